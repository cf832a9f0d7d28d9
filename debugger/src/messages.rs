//! What a client sends, as far as it is read. Types of the protocol that others publish are either old or cover far more
//! than an adapter of one language needs; these have the fields that are used.

use serde::Deserialize;
use serde::de::DeserializeOwned;
use serde_json::{Map, Value as Json};

/// A request.
#[derive(Debug, Clone, Deserialize)]
pub struct Request {
    pub(crate) seq: i64,
    pub(crate) command: String,
    #[serde(default)]
    pub(crate) arguments: Json,
}

/// Why a message is not a request.
#[derive(Debug)]
pub struct NoRequest {
    /// Its number; 0 if it has none.
    pub seq: i64,
    /// What is wrong with it.
    pub message: String,
}

impl Request {
    /// Reads a message.
    ///
    /// # Errors
    /// It is not a request.
    pub fn read(body: &[u8]) -> Result<Request, NoRequest> {
        let message: Json = serde_json::from_slice(body).map_err(|error| NoRequest {
            seq: 0,
            message: format!("the message is not JSON: {error}"),
        })?;
        Request::of(message)
    }

    /// A message that is read already.
    pub(crate) fn of(message: Json) -> Result<Request, NoRequest> {
        let seq = message.get("seq").and_then(Json::as_i64).unwrap_or(0);
        let refused = |message: String| NoRequest { seq, message };
        match message.get("type").and_then(Json::as_str) {
            Some("request") => serde_json::from_value(message)
                .map_err(|error| refused(format!("the request is broken: {error}"))),
            Some(other) => Err(refused(format!(
                "a client sends requests, no message of type `{other}`"
            ))),
            None => Err(refused("the message has no `type`".into())),
        }
    }

    /// Whether a long scan is given up for it.
    pub fn is_urgent(&self) -> bool {
        matches!(
            self.command.as_str(),
            "pause" | "disconnect" | "terminate" | "restart" | "stepBack" | "reverseContinue"
        )
    }

    /// Whether the program, or what is known of its breakpoints, may be another one after it.
    pub(crate) fn changes(&self) -> bool {
        match self.command.as_str() {
            "initialize"
            | "launch"
            | "threads"
            | "stackTrace"
            | "scopes"
            | "variables"
            | "completions"
            | "source"
            | "breakpointLocations"
            | "dataBreakpointInfo"
            | "exceptionInfo"
            | "setExceptionBreakpoints" => false,
            "evaluate" => self.arguments.get("context").and_then(Json::as_str) == Some("repl"),
            _ => true,
        }
    }

    /// Its arguments. A client may leave out arguments of which none is needed.
    pub(crate) fn arguments<T: DeserializeOwned>(&self) -> Result<T, String> {
        let arguments = match &self.arguments {
            Json::Null => Json::Object(Map::new()),
            given => given.clone(),
        };
        serde_json::from_value(arguments).map_err(|error| format!("{}: {error}", self.command))
    }

    /// The configuration that a restart brings with it. The protocol has it as the `arguments` of the arguments; nvim-dap
    /// sends it in their place.
    pub(crate) fn new_configuration(&self) -> Option<&Json> {
        let given = self.arguments.as_object()?;
        match given.get("arguments") {
            Some(wrapped) => Some(wrapped).filter(|wrapped| !wrapped.is_null()),
            None => ["program", "scenarioFile"]
                .iter()
                .any(|name| given.contains_key(*name))
                .then_some(&self.arguments),
        }
    }
}

#[derive(Debug, Clone, Deserialize)]
#[serde(rename_all = "camelCase", default)]
pub(crate) struct Initialize {
    #[serde(rename = "linesStartAt1")]
    pub lines_start_at_1: bool,
    #[serde(rename = "columnsStartAt1")]
    pub columns_start_at_1: bool,
    pub path_format: Option<String>,
    #[serde(rename = "supportsInvalidatedEvent")]
    pub takes_invalidated: bool,
}

impl Default for Initialize {
    fn default() -> Initialize {
        Initialize {
            lines_start_at_1: true,
            columns_start_at_1: true,
            path_format: None,
            takes_invalidated: false,
        }
    }
}

#[derive(Debug, Clone, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(crate) struct SetBreakpoints {
    pub source: Source,
    #[serde(default)]
    pub breakpoints: Option<Vec<SourceBreakpoint>>,
    /// The old way.
    #[serde(default)]
    pub lines: Vec<i64>,
}

#[derive(Debug, Clone, Deserialize)]
pub(crate) struct Source {
    #[serde(default)]
    pub path: Option<String>,
}

/// `source`.
#[derive(Debug, Clone, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(crate) struct TextOfSource {
    pub source_reference: i64,
}

#[derive(Debug, Clone, Default, Deserialize)]
#[serde(rename_all = "camelCase", default)]
pub(crate) struct SourceBreakpoint {
    pub line: i64,
    pub column: Option<i64>,
    pub condition: Option<String>,
    pub hit_condition: Option<String>,
    pub log_message: Option<String>,
}

#[derive(Debug, Clone, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(crate) struct BreakpointLocations {
    pub source: Source,
    pub line: i64,
    pub end_line: Option<i64>,
}

#[derive(Debug, Clone, Deserialize)]
pub(crate) struct SetDataBreakpoints {
    pub breakpoints: Vec<DataBreakpoint>,
}

#[derive(Debug, Clone, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(crate) struct DataBreakpoint {
    pub data_id: String,
    pub condition: Option<String>,
    pub hit_condition: Option<String>,
}

#[derive(Debug, Clone, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(crate) struct DataBreakpointInfo {
    pub name: String,
    pub variables_reference: Option<i64>,
    pub frame_id: Option<i64>,
}

#[derive(Debug, Clone, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(crate) struct SetExceptionBreakpoints {
    #[serde(default)]
    pub filters: Vec<String>,
    #[serde(default)]
    pub filter_options: Vec<FilterOption>,
}

#[derive(Debug, Clone, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(crate) struct FilterOption {
    pub filter_id: String,
}

#[derive(Debug, Clone, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(crate) struct StackTrace {
    pub start_frame: Option<usize>,
    pub levels: Option<usize>,
}

#[derive(Debug, Clone, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(crate) struct Scopes {
    pub frame_id: i64,
}

#[derive(Debug, Clone, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(crate) struct Variables {
    #[serde(rename = "variablesReference")]
    pub reference: i64,
    pub filter: Option<String>,
    pub start: Option<usize>,
    pub count: Option<usize>,
}

#[derive(Debug, Clone, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(crate) struct SetVariable {
    pub variables_reference: i64,
    pub name: String,
    pub value: String,
}

#[derive(Debug, Clone, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(crate) struct SetExpression {
    pub expression: String,
    pub value: String,
    pub frame_id: Option<i64>,
}

#[derive(Debug, Clone, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(crate) struct Evaluate {
    pub expression: String,
    pub frame_id: Option<i64>,
    pub context: Option<String>,
}

#[derive(Debug, Clone, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(crate) struct Completions {
    pub text: String,
    pub column: i64,
    pub frame_id: Option<i64>,
}

/// `next`, `stepIn`, `stepOut`, `stepBack`.
#[derive(Debug, Clone, Deserialize)]
pub(crate) struct StepArguments {
    pub granularity: Option<Granularity>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Granularity {
    Statement,
    Line,
    Instruction,
}

/// `ladder/force` and `ladder/unforce`: of a variable that is shown, or of an expression.
#[derive(Debug, Clone, Default, Deserialize)]
#[serde(rename_all = "camelCase", default)]
pub(crate) struct Force {
    /// The tag; without it, with `ladder/unforce`, all of them.
    pub name: Option<String>,
    pub variables_reference: Option<i64>,
    pub frame_id: Option<i64>,
    pub value: Option<String>,
}

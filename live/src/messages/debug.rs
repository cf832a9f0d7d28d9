//! How a debugger comes to a simulation, and what it says and is told.

use ladder_documents::position::Range;
use serde::{Deserialize, Serialize};
use serde_json::Value;

use super::{Options, is_false};

/// The argument of `ladder.simulate.debug`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Debug {
    /// The configuration of the launch, as the debug adapter takes it.
    pub launch: Value,
    /// How to run it, for what the configuration does not say.
    #[serde(default)]
    pub options: Options,
}

/// The answer of `ladder.simulate.debug`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Debugged {
    /// The session, for all later commands and for the messages of the debugger.
    pub session: String,
    /// It ran already.
    #[serde(default, skip_serializing_if = "is_false")]
    pub joined: bool,
    /// How things are: as `ladder.simulate.start` answers, or as any other command where it ran already.
    pub state: Value,
    /// Where the first rung is, where it was started.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub first: Option<Range>,
    /// What a person should know.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub notes: Vec<String>,
}

/// The parameters of `ladder/toDebugger` and `ladder/fromDebugger`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct DebuggerMessage {
    /// The session that is debugged.
    pub session: String,
    /// A message of the Debug Adapter Protocol, without its header.
    pub message: Value,
}

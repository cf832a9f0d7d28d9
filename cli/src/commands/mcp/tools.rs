//! The tools: what each takes and answers. What is listed to clients, and what a call is checked against, is made of this table.

use super::given::Given;
use rmcp::model::{JsonObject, Tool as Described, ToolAnnotations};
use serde_json::{Value, json};
use std::sync::Arc;

/// What a parameter takes.
#[derive(Debug, Clone, Copy)]
pub(super) enum Kind {
    Text,
    /// A file or folder, seen from one of the client's folders.
    Path,
    Number,
    Flag,
    Texts,
    /// Names of tags with their values.
    Values,
    /// Values by scan.
    Scans,
    Choice(&'static [&'static str]),
}

pub(super) struct Parameter {
    name: &'static str,
    kind: Kind,
    is_needed: bool,
    about: &'static str,
}

/// What an answer has besides `ok`, `total` and `next`.
#[derive(Debug, Clone, Copy)]
pub(super) enum Shape {
    /// `text`.
    Text,
    /// A list of objects.
    List(&'static str),
}

pub(super) struct Tool {
    pub(super) name: &'static str,
    title: &'static str,
    about: &'static str,
    parameters: &'static [Parameter],
    shape: Shape,
    /// It can change files.
    writes: bool,
}

const fn needed(name: &'static str, kind: Kind, about: &'static str) -> Parameter {
    Parameter {
        name,
        kind,
        is_needed: true,
        about,
    }
}

const fn optional(name: &'static str, kind: Kind, about: &'static str) -> Parameter {
    Parameter {
        is_needed: false,
        ..needed(name, kind, about)
    }
}

const FROM: Parameter = optional(
    "from",
    Kind::Number,
    "where the answer begins: `next` of the one before",
);
const PROGRAM: Parameter = needed("path", Kind::Path, "the program");
const SET: Parameter = optional("set", Kind::Values, "tags that are set before the first scan");
const FORCE: Parameter = optional("force", Kind::Values, "tags that are held at a value");
const PLANT: Parameter = optional(
    "plant",
    Kind::Path,
    "a model of the machine that runs beside it; else what ladder.toml says",
);

/// All of them.
pub(super) const TOOLS: [Tool; 12] = [
    Tool {
        name: "check",
        title: "Find errors",
        about: "Finds errors and warnings in a program, scenarios or a folder, each with its place, what to do, and a fix where there is one.",
        parameters: &[
            needed("path", Kind::Path, "a program, a file of scenarios, or a folder"),
            FROM,
        ],
        shape: Shape::List("findings"),
        writes: false,
    },
    Tool {
        name: "fix",
        title: "Fix errors",
        about: "Fixes what can be fixed safely in a program. Without `write` it shows the changes as a diff and changes nothing.",
        parameters: &[
            needed("path", Kind::Path, "a program or a folder"),
            optional(
                "guesses",
                Kind::Flag,
                "also fixes that may change what the program does",
            ),
            optional("write", Kind::Flag, "change the files"),
            FROM,
        ],
        shape: Shape::Text,
        writes: true,
    },
    Tool {
        name: "format",
        title: "Align the drawing",
        about: "Aligns the rungs of a program, or the columns of scenarios; nothing else changes. Draw roughly and let this align it. Without \
                `write` it shows the changes as a diff.",
        parameters: &[
            needed("path", Kind::Path, "a program, a file of scenarios, or a folder"),
            optional("write", Kind::Flag, "change the files"),
            FROM,
        ],
        shape: Shape::Text,
        writes: true,
    },
    Tool {
        name: "render",
        title: "Draw a program",
        about: "Draws a program as a ladder diagram, in characters or as a picture; after some scans with its power and values.",
        parameters: &[
            needed("path", Kind::Path, "a program, or a scene (picture only)"),
            optional("as", Kind::Choice(&["text", "png"]), "characters, or a picture"),
            optional(
                "scans",
                Kind::Number,
                "run so many scans first, and show the power",
            ),
            SET,
            FROM,
        ],
        shape: Shape::Text,
        writes: false,
    },
    Tool {
        name: "simulate",
        title: "Run scans",
        about: "Runs a program for some scans from a cold start, and answers with the values of tags after each.",
        parameters: &[
            PROGRAM,
            needed("scans", Kind::Number, "how many"),
            optional(
                "interval",
                Kind::Text,
                "the time from one scan to the next, such as 10ms",
            ),
            SET,
            FORCE,
            optional(
                "inputs",
                Kind::Scans,
                "what is set before later scans: [{\"scan\": 5, \"values\": {\"stop\": true}}]",
            ),
            optional(
                "watch",
                Kind::Texts,
                "the tags that are answered, such as t1.ET; without it all",
            ),
            PLANT,
            optional(
                "connect",
                Kind::Texts,
                "tags that are connected though names differ: plant.level=height",
            ),
            FROM,
        ],
        shape: Shape::List("scans"),
        writes: false,
    },
    Tool {
        name: "session",
        title: "A simulation that goes on",
        about: "One simulation from call to call: `start` (answers with its number), then `step`, `set`, `force`, `release`, `back`, `why`, \
                `look`, and `end`. Each answers with the values of the tags.",
        parameters: &[
            needed(
                "action",
                Kind::Choice(&[
                    "start", "step", "set", "force", "release", "back", "why", "look", "end",
                ]),
                "what is done",
            ),
            optional("path", Kind::Path, "for start: the program"),
            PLANT,
            optional("session", Kind::Number, "its number, for all but start"),
            optional("scans", Kind::Number, "for step and back: how many; 1 without it"),
            optional("values", Kind::Values, "for set, force, and step (set before it)"),
            optional(
                "tags",
                Kind::Texts,
                "for release; and which values are answered: inputs and outputs without it",
            ),
            optional("tag", Kind::Text, "for why: the tag that is explained"),
            FROM,
        ],
        shape: Shape::List("values"),
        writes: false,
    },
    Tool {
        name: "test",
        title: "Run scenarios",
        about: "Runs the scenarios of a file or folder (.ladder-test), and answers with each and what differs.",
        parameters: &[
            needed("path", Kind::Path, "a file of scenarios, or a folder"),
            optional("filter", Kind::Text, "only those with this in their names"),
            FROM,
        ],
        shape: Shape::List("scenarios"),
        writes: false,
    },
    Tool {
        name: "prove",
        title: "Prove properties",
        about: "Decides the properties of a file of scenarios for every run: proved, or violated with a run that shows it.",
        parameters: &[
            needed("path", Kind::Path, "a file of scenarios, or a folder"),
            optional(
                "seconds",
                Kind::Number,
                "how long it may take for each file; at most 100",
            ),
            FROM,
        ],
        shape: Shape::List("properties"),
        writes: false,
    },
    Tool {
        name: "why",
        title: "Explain a value",
        about: "Explains why a tag holds what it holds, from values that were taken from a controller, without a run.",
        parameters: &[
            PROGRAM,
            needed("tag", Kind::Text, "the tag"),
            needed("values", Kind::Values, "the values of the controller's tags"),
            FROM,
        ],
        shape: Shape::Text,
        writes: false,
    },
    Tool {
        name: "diff",
        title: "Compare programs",
        about: "Shows what differs between two programs or folders, network by network, and whether an edited network does the same.",
        parameters: &[
            needed(
                "old",
                Kind::Path,
                "the old program or folder; or of a revision, as in HEAD:motor.clad",
            ),
            needed("new", Kind::Path, "the new one"),
            optional("same", Kind::Flag, "only whether both do the same"),
            FROM,
        ],
        shape: Shape::Text,
        writes: false,
    },
    Tool {
        name: "convert",
        title: "Translate",
        about: "Translates a program of another system into ladder text, or ladder text into another notation (l5x, plcopen, simatic, simaticml, \
                twincat, st, c, click, ldmicro ..). Without `output` it answers with the text.",
        parameters: &[
            PROGRAM,
            optional("to", Kind::Text, "the notation; ladder text without it"),
            optional("output", Kind::Path, "write it to this file"),
            optional("replace", Kind::Flag, "replace the file if it is there"),
            FROM,
        ],
        shape: Shape::Text,
        writes: true,
    },
    Tool {
        name: "explain",
        title: "Look it up",
        about: "The page of an instruction (TON, '[/]'), a rule (double-coil) or a block of the library ($Alarm); without a name the list of all.",
        parameters: &[optional("name", Kind::Text, "the name"), FROM],
        shape: Shape::Text,
        writes: false,
    },
];

pub(super) fn by_name(name: &str) -> Option<&'static Tool> {
    TOOLS.iter().find(|tool| tool.name == name)
}

impl Kind {
    fn schema(self) -> Value {
        let values =
            || json!({"type": "object", "additionalProperties": {"type": ["string", "number", "boolean"]}});
        match self {
            Kind::Text | Kind::Path => json!({"type": "string"}),
            Kind::Number => json!({"type": "integer", "minimum": 0}),
            Kind::Flag => json!({"type": "boolean"}),
            Kind::Texts => json!({"type": "array", "items": {"type": "string"}}),
            Kind::Values => values(),
            Kind::Scans => json!({
                "type": "array",
                "items": {
                    "type": "object",
                    "properties": {"scan": {"type": "integer", "minimum": 0}, "values": values()},
                    "required": ["scan", "values"],
                },
            }),
            Kind::Choice(words) => json!({"type": "string", "enum": words}),
        }
    }

    fn takes(self, value: &Value) -> bool {
        let is_plain = |value: &Value| value.is_string() || value.is_number() || value.is_boolean();
        let are_plain = |value: &Value| value.as_object().is_some_and(|all| all.values().all(is_plain));
        match self {
            Kind::Text | Kind::Path => value.is_string(),
            Kind::Number => value.is_u64(),
            Kind::Flag => value.is_boolean(),
            Kind::Texts => value
                .as_array()
                .is_some_and(|all| all.iter().all(Value::is_string)),
            Kind::Values => are_plain(value),
            Kind::Scans => value.as_array().is_some_and(|all| {
                all.iter()
                    .all(|row| row["scan"].is_u64() && are_plain(&row["values"]))
            }),
            Kind::Choice(words) => value.as_str().is_some_and(|word| words.contains(&word)),
        }
    }
}

impl Tool {
    /// As clients list it.
    pub(super) fn described(&self) -> Described {
        let properties: JsonObject = (self.parameters.iter())
            .map(|it| {
                let mut schema = it.kind.schema();
                schema["description"] = json!(it.about);
                (it.name.to_owned(), schema)
            })
            .collect();
        let needed = self.parameters.iter().filter(|it| it.is_needed);
        let needed: Vec<&str> = needed.map(|it| it.name).collect();
        let input = json!({"type": "object", "properties": properties, "required": needed, "additionalProperties": false});
        let mut described = Described::new(self.name, self.about, object(input));
        described.title = Some(self.title.to_owned());
        described.output_schema = Some(Arc::new(object(self.output())));
        described.annotations = Some(ToolAnnotations::from_raw(
            Some(self.title.to_owned()),
            Some(!self.writes),
            Some(self.writes),
            Some(self.name != "session"),
            Some(false),
        ));
        described
    }

    /// The schema of what it answers.
    fn output(&self) -> Value {
        let (key, of_key) = match self.shape {
            Shape::Text => ("text", json!({"type": "string"})),
            Shape::List(key) => (key, json!({"type": "array", "items": {"type": "object"}})),
        };
        json!({
            "type": "object",
            "properties": {
                "ok": {"type": "boolean", "description": "nothing to complain about"},
                key: of_key,
                "total": {"type": "integer", "description": "how many items or characters there are in all"},
                "next": {"type": "integer", "description": "where the rest begins, if this is not all: ask with `from`"},
            },
            "required": ["ok", key, "total"],
        })
    }

    /// Whether a call is as it is listed.
    ///
    /// # Errors
    /// A sentence for who called.
    pub(super) fn check(&self, given: &Given) -> Result<(), String> {
        for (name, value) in &given.0 {
            let Some(parameter) = self.parameters.iter().find(|it| it.name == name) else {
                let known: Vec<&str> = self.parameters.iter().map(|it| it.name).collect();
                return Err(format!(
                    "`{}` has no parameter `{name}`: it takes {}",
                    self.name,
                    known.join(", ")
                ));
            };
            if !value.is_null() && !parameter.kind.takes(value) {
                return Err(format!("`{name}` is wanted as {}", parameter.kind.schema()));
            }
        }
        let missing = |it: &&Parameter| it.is_needed && given.0.get(it.name).is_none_or(Value::is_null);
        match self.parameters.iter().find(missing) {
            Some(missing) => Err(format!("`{}` is missing: {}", missing.name, missing.about)),
            None => Ok(()),
        }
    }
}

fn object(value: Value) -> JsonObject {
    match value {
        Value::Object(object) => object,
        _ => JsonObject::new(),
    }
}

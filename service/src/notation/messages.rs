//! What travels between editor and server about programs of other systems. `docs/protocol.md` shows each message.

use serde::{Deserialize, Serialize};

/// The argument of `ladder.convert`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Convert {
    /// The program's file.
    pub uri: String,
    /// Its content where the editor has another than the disk, or the file is none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub text: Option<String>,
    /// The notation that it is in; without it its content decides.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub from: Option<String>,
    /// The notation to write; without it ladder text.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub to: Option<String>,
}

/// The answer to `ladder.convert`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Converted {
    /// The notation that the program was in.
    pub from: String,
    /// The notation that it is in now.
    pub to: String,
    /// How the names of such files end, without the dot.
    pub extension: String,
    /// The program.
    pub text: String,
    /// What belongs next to it.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub companions: Vec<NextTo>,
    /// How many elements mean the same.
    pub translated: usize,
    /// How many mean nearly the same.
    pub approximated: usize,
    /// How many have no counterpart.
    pub refused: usize,
    /// What there is to say about single elements.
    pub remarks: Vec<Element>,
    /// What else a person should know.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub notes: Vec<String>,
}

/// A file that belongs next to a program.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct NextTo {
    /// Its whole name, after a `/` if it is in a folder of its own.
    pub name: String,
    /// What it holds; none where that is not a text in UTF-8.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub text: Option<String>,
}

/// A remark on an element.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Element {
    /// Line of the file, from 1; none where it is in a text that nobody sees.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub line: Option<u32>,
    /// Its column in characters, from 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub column: Option<u32>,
    /// `approximated`, `refused`, or the severity of what the other system itself would complain about.
    pub outcome: String,
    /// The element as it is written, or the name of the other system's check.
    pub element: String,
    /// Why.
    pub reason: String,
}

/// The argument of `ladder.preview`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Preview {
    /// A program of another system that is open.
    pub uri: String,
}

/// The answer to `ladder.preview`, and the parameters of `ladder/preview`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Previewed {
    /// The program.
    pub uri: String,
    /// The version of its text.
    pub version: i32,
    /// The ladder text that it becomes.
    pub text: String,
}

/// The argument of `ladder.notations`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Nothing {}

/// The answer to `ladder.notations`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Notations {
    /// Those that programs are written in, without ladder text.
    pub notations: Vec<Known>,
}

/// A notation that programs are written in.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Known {
    /// What a command takes: `ldmicro`.
    pub name: String,
    /// What a person calls it.
    pub title: String,
    /// How the names of its files end, without the dot, the usual one first.
    pub extensions: Vec<String>,
}

//! The messages of the commands that have to do with typing.

use ladder_documents::Lines;
use ladder_documents::position::{Position, Range};
use serde::{Deserialize, Serialize};

/// The argument of `ladder.cursor`: where a client's cursor is.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Cursor {
    /// The document.
    pub uri: String,
    /// The line, from 0; none if nobody types in the document.
    pub line: Option<u32>,
}

/// The argument of `ladder.edit`: a change of the drawing.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct EditDrawing {
    /// The document.
    pub uri: String,
    /// What is selected, or where the cursor is.
    pub range: Range,
    /// What is done.
    pub edit: EditKind,
}

/// What is done to a drawing.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase")]
pub enum EditKind {
    /// A contact is put in.
    Contact,
    /// A contact that lets power through while its tag is low.
    ClosedContact,
    /// A coil.
    Coil,
    /// A timer, to be made any other block.
    Block,
    /// A branch around what is selected.
    Branch,
    /// A contact or coil becomes its opposite.
    Invert,
    /// A block changes places with what is before it.
    Left,
    /// With what is after it.
    Right,
    /// A block goes to the rung above.
    Up,
    /// To the rung below.
    Down,
    /// What is selected goes, with its wire.
    Delete,
}

/// The argument of `ladder.comment`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct ToggleComment {
    /// The document.
    pub uri: String,
    /// Its lines, from 0; each stretch of them is toggled by itself.
    pub lines: Vec<Lines>,
}

/// The answer to `ladder.edit` and to `ladder.comment`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct EditedDrawing {
    /// The version of the document that the edits are for.
    pub version: i32,
    /// The edits, to be made together.
    pub edits: Vec<Replacement>,
    /// Where the cursor is afterwards; none where it stays.
    pub cursor: Option<Position>,
}

/// One edit.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Replacement {
    /// What is replaced.
    pub range: Range,
    /// By what.
    pub new_text: String,
}

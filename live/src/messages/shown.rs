//! What a client shows of a program, and what it is sent of that.

use ladder_documents::Lines;
use ladder_documents::position::{Position, Range};
use serde::{Deserialize, Serialize};

use super::{Tag, is_false};

/// What of a program a client shows.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Shown {
    /// Lines of the text, from 0.
    #[serde(default)]
    pub lines: Vec<Lines>,
    /// Tags next to those that these lines name.
    #[serde(default)]
    pub tags: Vec<String>,
}

/// The argument of `ladder.simulate.show`: all that is shown, in the place of what was shown before.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Show {
    /// The session.
    pub session: String,
    /// Lines of the text, from 0.
    #[serde(default)]
    pub lines: Vec<Lines>,
    /// Tags next to those that these lines name.
    #[serde(default)]
    pub tags: Vec<String>,
}

/// The argument of `ladder.simulate.tags`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Search {
    /// The session.
    pub session: String,
    /// Only tags whose names hold this, in any case.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub containing: Option<String>,
    /// Only what this tag opens into, such as the elements of an array. With an empty name the tags of the program, of which
    /// those that open are listed as one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub of: Option<String>,
    /// Only the tags of these names, in this order; a name that the program does not have is left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub names: Option<Vec<String>>,
    /// This many of them are left out at the beginning of the list.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub first: Option<usize>,
    /// No more than this many; all unless given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub count: Option<usize>,
}

/// The answer of `ladder.simulate.tags`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Found {
    /// How many tags there are that were searched for, listed or not.
    pub count: usize,
    /// Those that are listed, in the order of first appearance.
    pub tags: Vec<Tag>,
}

/// What a contact does with the power that comes to it, or would do.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase")]
pub enum Contact {
    /// It lets power through, whether any comes or not.
    Closed,
    /// It would not, and none comes.
    Open,
    /// It holds up the power that comes.
    Blocks,
}

/// An operand of a block, and what stands for its value.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Operand {
    /// Where the operand is.
    pub range: Range,
    /// Its block.
    pub block: Range,
    /// The tags whose values belong next to it, the most telling one first: of a timer `t1.ET` and `t1.Q`.
    pub tags: Vec<String>,
    /// The power of the block, or what the contact does, shows the value already.
    #[serde(default, skip_serializing_if = "is_false")]
    pub drawn: bool,
}

/// Where the value of an operand is shown over the text: never between the characters of a line, which would push the
/// drawing apart.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Label {
    /// The tag whose text it is.
    pub tag: String,
    /// What is before that text: of an element with a computed index which one it is, `[2]=`; of a timer that is declared `ET=`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub index: Option<String>,
    /// Where its operand begins.
    pub at: Position,
    /// On which side of the operand's line.
    pub side: Side,
    /// In which column of the screen it begins, from 0.
    pub column: u32,
    /// Where neither side leaves room: the column after the end of the line, for editors that cannot show a line between two. There
    /// the tag's name and `: ` are before it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub after: Option<u32>,
}

/// On which side of a line something is shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase")]
pub enum Side {
    /// Over the line above, which is blank there.
    Above,
    /// Over the line below, which is blank there.
    Below,
    /// In a line of its own between the line and the one above, where neither leaves room.
    Between,
    /// After the end of the line: the value of what it declares.
    After,
}

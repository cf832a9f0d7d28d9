//! The messages of the commands that draw in the diagram.

use crate::typing_messages::Replacement;
use ladder_documents::position::{Position, Range};
use serde::{Deserialize, Serialize};

/// The argument of `ladder.diagramEdit`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct DiagramEdit {
    /// The program, which must be open.
    pub uri: String,
    /// The version of the text that the places are of.
    pub version: i32,
    /// What is done.
    pub edit: DrawingEdit,
}

/// What is done in the diagram.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(tag = "op", rename_all = "camelCase")]
#[allow(missing_docs)]
pub enum DrawingEdit {
    /// Something is put into a wire.
    Insert {
        at: Position,
        #[serde(flatten)]
        put: Put,
    },
    /// A branch beside what is between two places of a line.
    Parallel {
        from: Position,
        to: Position,
        side: BranchSide,
        #[serde(flatten)]
        put: Put,
    },
    /// Things go, or a network.
    Delete(Deleted),
    /// What is between the parentheses of a block.
    Operand {
        what: Range,
        text: String,
        #[serde(default, skip_serializing_if = "Option::is_none")]
        declare: Option<Declare>,
    },
    /// The first part of a block.
    Head { what: Range, text: String },
    /// Things go to another place.
    Move { what: Vec<Range>, to: Target },
    /// The end of a branch moves along the line.
    BranchEnd { what: Position, to: Position },
    /// A branch that ends by itself is joined.
    Close { what: Position, to: Position },
    /// A new network.
    Network(NewNetwork),
    /// A comment above a network, or another text for one.
    Comment(Commented),
    /// A tag is declared, or its declaration changes or goes.
    Declaration(Declared),
    /// A network goes to before another one.
    MoveNetwork { network: u32, before: Option<u32> },
    /// A network is there twice.
    Duplicate { network: u32 },
    /// A network becomes two.
    Split { at: Position },
    /// Two networks become one.
    Merge { networks: Vec<u32> },
    /// A tag gets another name, everywhere.
    Rename { what: Range, text: String },
}

/// What is put in.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Put {
    /// Ladder text, mnemonics, or drawn characters.
    pub text: String,
    /// Timers, counters and instances get tags of their own.
    #[serde(default, skip_serializing_if = "is_false")]
    pub copied: bool,
    /// How its first new name is declared.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub declare: Option<Declare>,
}

#[allow(clippy::trivially_copy_pass_by_ref, reason = "serde asks for a reference")]
fn is_false(value: &bool) -> bool {
    !value
}

/// A declaration.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Declare {
    /// The section, by its keyword.
    pub section: String,
    /// The type.
    #[serde(rename = "type")]
    pub ty: String,
}

/// A row of the table of declarations.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(untagged, deny_unknown_fields)]
pub enum Declared {
    /// The declaration at a name; without a row it goes.
    #[allow(missing_docs)]
    At {
        what: Range,
        row: Option<DeclarationCells>,
    },
    /// A new one, in the file or in the body of a block.
    New {
        /// The block.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        block: Option<String>,
        /// What it says.
        row: DeclarationCells,
    },
}

/// What a row of the table of declarations says.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DeclarationCells {
    /// The first line of its section: `VAR RETAIN`.
    pub section: String,
    /// Its name.
    pub name: String,
    /// Its direct address.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub address: String,
    /// Its type.
    #[serde(rename = "type")]
    pub ty: String,
    /// Its initial value.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub initial: String,
    /// Its comment.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub comment: String,
}

/// The argument of `ladder.declarations`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Declarations {
    /// The program, which must be open.
    pub uri: String,
}

/// The answer to `ladder.declarations`: all that a program declares, in the order of its text.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DeclarationTable {
    /// The version of the text.
    pub version: i32,
    /// The tags.
    pub rows: Vec<DeclaredRow>,
    /// The blocks that are defined in the file, which have declarations of their own.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub blocks: Vec<String>,
}

/// A declared tag.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DeclaredRow {
    /// The user-defined block in whose body it is.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub block: Option<String>,
    /// What it says.
    pub cells: DeclarationCells,
    /// Where its name is.
    pub at: Range,
}

/// On which side of what is there a branch comes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase")]
pub enum BranchSide {
    /// It runs last.
    Below,
    /// It runs first.
    Above,
}

/// What goes.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(untagged, deny_unknown_fields)]
#[allow(missing_docs)]
pub enum Deleted {
    What { what: Vec<Range> },
    Network { network: u32 },
}

/// Where things go.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Target {
    /// A place in a wire.
    pub at: Position,
}

/// A new network.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct NewNetwork {
    /// A line of the network that it is next to; none for the end of the file.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub network: Option<u32>,
    /// On which side of that.
    pub place: NetworkPlace,
    /// Ladder text or drawn characters.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub text: Option<String>,
    /// What was typed into the field for it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub entry: Option<String>,
    /// As of [`Put`].
    #[serde(default, skip_serializing_if = "is_false")]
    pub copied: bool,
    /// As of [`Put`].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub declare: Option<Declare>,
}

/// On which side of a network another one comes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase")]
#[allow(missing_docs)]
pub enum NetworkPlace {
    Above,
    Below,
}

/// A comment.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(untagged, deny_unknown_fields)]
#[allow(missing_docs)]
pub enum Commented {
    Above { network: u32, text: String },
    What { what: Range, text: String },
}

/// The answer to `ladder.diagramEdit`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct DiagramEdited {
    /// The version of the document that the edits are for.
    pub version: i32,
    /// The edits, to be made together.
    pub edits: Vec<Replacement>,
    /// What is new or moved, in the new text.
    pub select: Vec<Range>,
    /// Where a person goes on there.
    pub focus: Option<Position>,
    /// What was done, in a sentence.
    pub said: String,
    /// What was declared.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub declared: Vec<DeclaredTag>,
    /// Edits of other files.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub also: Vec<FileEdits>,
}

/// A tag with its declaration.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DeclaredTag {
    /// Its name.
    pub name: String,
    /// The keyword of its section.
    pub section: String,
    /// Its type.
    #[serde(rename = "type")]
    pub ty: String,
}

/// Edits of another file.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct FileEdits {
    /// The file.
    pub uri: String,
    /// Its version, if it is open.
    pub version: Option<i32>,
    /// The edits.
    pub edits: Vec<Replacement>,
}

/// The argument of `ladder.diagramOffer`: one of `at`, `what` and `network`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct DiagramOffer {
    /// The program, which must be open.
    pub uri: String,
    /// The version of the text that the places are of.
    pub version: i32,
    /// A place in a wire.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub at: Option<Position>,
    /// What is selected.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub what: Option<Vec<Range>>,
    /// A line of a network.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub network: Option<u32>,
    /// What a person wants to put in.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub text: Option<String>,
}

/// The answer to `ladder.diagramOffer`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct DiagramOffered {
    /// The version of the document.
    pub version: i32,
    /// What can be done, and why the rest cannot.
    pub offers: Vec<Offer>,
    /// What is selected, as ladder text.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub text: Option<String>,
    /// The places in the wires on both sides of it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub points: Option<OfferedSide>,
    /// The next larger group.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub larger: Option<Range>,
    /// The things of that group, on all its lines.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub larger_things: Vec<Range>,
    /// All that acts at the end of the line.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub acting: Option<Span>,
    /// The networks next to the one that is asked about.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub neighbours: Option<Neighbours>,
    /// The new names of the text, as they would be declared.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub declares: Vec<DeclaredTag>,
    /// A name that is free.
    pub name: String,
}

/// Something that can be done.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Offer {
    /// What.
    pub op: String,
    /// Why it cannot.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub why: Option<String>,
}

/// The wires on both sides of something.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(missing_docs)]
pub struct OfferedSide {
    pub before: Position,
    pub behind: Position,
}

/// Two places of a line.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(missing_docs)]
pub struct Span {
    pub from: Position,
    pub to: Position,
}

/// The networks next to one, by a line of each; null where there is none in its program, function or block.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Neighbours {
    /// The one above.
    pub above: Option<u32>,
    /// The one below.
    pub below: Option<u32>,
    /// The one below that.
    pub after: Option<u32>,
}

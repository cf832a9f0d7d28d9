//! A whole program without columns: what is declared, what is drawn, and the comments on it. Importers of other
//! notations make one; [`ProgramSketch::write`] returns its text.

mod block;
mod expression;
mod of_text;
mod path;
mod read;
mod write;

use crate::Circuit;
pub use block::{Block, Head, Invalid, Operand};
pub use expression::{Expression, Literal, Operator, Sign};
pub use path::{Path, Step};
use std::fmt::{self, Display, Formatter};
pub use write::WrittenProgram;

/// A number of the importer's that says what a written place was made from. It comes back next to the place in the
/// text, see [`WrittenProgram`].
pub type Origin = u32;

/// A program, from top to bottom.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct ProgramSketch {
    /// Its parts in their order.
    pub items: Vec<Item>,
}

/// A part of a program.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Item {
    /// A comment on lines of its own. It may have several lines; see [`comment_text`] for what it cannot hold.
    Comment(String),
    /// A comment for the tools: `profile ldmicro`, `allow-file(never-read): reason`.
    Directive(String),
    /// A blank line.
    Blank,
    /// Ladder text as it is: types, or the definition of a block.
    Text(String),
    /// A line of ladder text as it is, and what it was made from.
    Kept(String, Origin),
    /// `VAR` .. `END_VAR`, or `TYPE` .. `END_TYPE`
    Section(Section),
    /// A network.
    Network(Network),
    /// `FUNCTION_BLOCK` .. `END_FUNCTION_BLOCK`
    Block {
        /// As in a header: `[$Debounce]`.
        header: String,
        /// What the header comes from.
        origin: Option<Origin>,
        /// What is between header and end.
        items: Vec<Item>,
    },
}

/// A section of declarations. One without declarations is not written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Section {
    /// What its tags are for.
    pub kind: SectionKind,
    /// `CONSTANT` or `RETAIN`, if it has one.
    pub qualifier: Option<Qualifier>,
    /// Its declarations in their order.
    pub declarations: Vec<Declaration>,
}

impl Section {
    /// An empty section without a qualifier.
    pub const fn new(kind: SectionKind) -> Section {
        Section {
            kind,
            qualifier: None,
            declarations: Vec::new(),
        }
    }
}

/// The keyword that a section begins with.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[allow(missing_docs, reason = "they are the keywords themselves")]
pub enum SectionKind {
    Var,
    VarInput,
    VarOutput,
    VarInOut,
    VarGlobal,
    VarExternal,
    /// Its declarations are types: `(IDLE, FILLING)`, `STRUCT` with its members on lines of their own.
    Type,
}

impl SectionKind {
    /// As it is written.
    pub const fn keyword(self) -> &'static str {
        match self {
            SectionKind::Var => "VAR",
            SectionKind::VarInput => "VAR_INPUT",
            SectionKind::VarOutput => "VAR_OUTPUT",
            SectionKind::VarInOut => "VAR_IN_OUT",
            SectionKind::VarGlobal => "VAR_GLOBAL",
            SectionKind::VarExternal => "VAR_EXTERNAL",
            SectionKind::Type => "TYPE",
        }
    }

    /// The keyword that it ends with.
    pub const fn end(self) -> &'static str {
        match self {
            SectionKind::Type => "END_TYPE",
            _ => "END_VAR",
        }
    }
}

/// What the header of a section adds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Qualifier {
    /// The tags keep their values over a warm restart.
    Retain,
    /// The tags are never written.
    Constant,
}

impl Qualifier {
    /// As it is written.
    pub const fn keyword(self) -> &'static str {
        match self {
            Qualifier::Retain => "RETAIN",
            Qualifier::Constant => "CONSTANT",
        }
    }
}

/// One tag, or several of one kind.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Declaration {
    /// The names; at least one.
    pub names: Vec<String>,
    /// A direct address, with its `%`.
    pub address: Option<String>,
    /// The type, as it is written.
    pub ty: String,
    /// The initial value, as it is written.
    pub initial: Option<String>,
    /// The comment on it.
    pub comment: Option<String>,
    /// What it was made from.
    pub origin: Option<Origin>,
}

impl Declaration {
    /// A tag and its type.
    pub fn new(name: impl Into<String>, ty: impl Into<String>) -> Declaration {
        Declaration {
            names: vec![name.into()],
            ty: ty.into(),
            ..Declaration::default()
        }
    }
}

/// A network, with the comments that are above it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Network {
    /// Each on a line of its own, or more.
    pub comments: Vec<String>,
    /// What is drawn.
    pub drawing: Drawing,
}

/// How a network is given.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Drawing {
    /// From the left rail to the right one, as what is in series and in parallel.
    Circuit(Circuit<Element>),
    /// Rung by rung, with its connectors: for what series and parallel cannot say. The k-th [`RungPiece::Down`] of a
    /// rung and the k-th [`RungPiece::Up`] of the next are one point.
    Rungs(Vec<Vec<RungPiece>>),
}

/// One thing on a rung of [`Drawing::Rungs`]. Wire joins each to the one before it, unless a
/// [`RungPiece::Gap`] is between them.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum RungPiece {
    /// `+` at either end
    Rail,
    /// `\`
    Down,
    /// `/`
    Up,
    /// Blanks.
    Gap,
    /// A block, or a comment in the wire.
    Element(Element),
}

/// A block, or a comment in a wire.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Element {
    /// Which of the two.
    pub part: Part,
    /// What it was made from.
    pub origin: Option<Origin>,
}

/// What is on a rung between connectors.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Part {
    /// `[TON]( t, T#5s )`
    Block(Block),
    /// A piece of wire that says something: `# relay in the door #`
    Comment(String),
    /// A block that a person has drawn as ladder text, which the table does not have, lacks an operand, or is spelled otherwise.
    Text(String),
}

impl Element {
    /// A block, and what it was made from.
    pub const fn of(block: Block, origin: Option<Origin>) -> Element {
        let part = Part::Block(block);
        Element { part, origin }
    }

    /// A comment in a wire.
    pub fn comment(text: &str, origin: Option<Origin>) -> Element {
        let part = Part::Comment(text.to_owned());
        Element { part, origin }
    }

    /// The block, if it is one.
    pub const fn as_block(&self) -> Option<&Block> {
        match &self.part {
            Part::Block(block) => Some(block),
            _ => None,
        }
    }
}

impl Display for Element {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match &self.part {
            Part::Block(block) => block.fmt(f),
            Part::Comment(text) => f.write_str(&comment_on_line(text)),
            Part::Text(text) => f.write_str(text),
        }
    }
}

/// A text as a comment on what is left of a line: `# relay in the door #`.
pub fn comment_on_line(text: &str) -> String {
    format!("# {} #", comment_text(text).replace('\n', " "))
}

/// A text as it can be in a comment: a comment cannot hold `#`, so it becomes `\x23`. Lone carriage returns and
/// other control characters become `\x..` too, and what would be a directive to the tools (`ladder: ..`) is none.
pub fn comment_text(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    if text.trim_start().starts_with("ladder:") {
        out.push_str("text: ");
    }
    for c in text.replace("\r\n", "\n").chars() {
        match c {
            '\n' | '\t' => out.push(c),
            '#' => out.push_str("\\x23"),
            c if c.is_control() => out.push_str(&format!("\\x{:02x}", u32::from(c))),
            c => out.push(c),
        }
    }
    out
}

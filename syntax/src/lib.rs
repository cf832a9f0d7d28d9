//! Lexer, parser, lossless tree and wiring of the ladder text language.
//!
//! Text flows one way:
//!
//! ```text
//! text --lexer--> tokens --grammar--> a small summary per logical line --structure--> networks, sections,
//!                                     + its text                                      block definitions
//!                                       \--asked for--> its green node, seen through `ast`
//!                                                         \--wiring--> parts, segments, connector pairs
//! ```
//!
//! The **logical line** is the unit: a rung, a rail, blank or comment line, one declaration, the first or last
//! line of a section or block definition. Parsing a line is a function of its text and of the [`Mode`] it
//! begins in, so an edit ([`Parse::edited`]) re-parses the lines it touches and nothing else. Networks and sections
//! are ranges over lines, regrouped from the summaries; trees are made when they are asked for.
//!
//! What holds for every text: `parse(text).to_string() == text`; parsing never fails, it gives a tree and
//! [`SyntaxError`]s; an error never leaves its line (an open comment excepted); nesting is bounded.
//!
//! The grammar reports what it reads to a [`Builder`]. The tree's is one; code that needs no tree brings another
//! ([`read_lines`]) and gets the same lines and the same structure with what that builder made of them.
//!
//! No instruction is known here: an unknown or half-typed mnemonic parses like any other, and every operand
//! is read with one expression grammar. What an instruction allows is for the analysis to say.

pub mod ast;
mod builder;
mod conflict;
mod dump;
mod edit;
mod error;
mod file_lines;
mod grammar;
mod kind;
mod lexer;
mod line;
mod line_index;
mod line_tree;
mod lines;
mod name;
pub mod numeral;
mod parse;
mod part;
mod structure;
mod summary;
mod tree_builder;
mod unclosed_comment;
pub mod wiring;
pub mod xml;

pub use builder::Builder;
pub use conflict::{Conflict, Sign, conflicts};
pub use dump::dump;
pub use error::{DeclarationProblem, Many, OperandPlace, Surroundings, SyntaxError, SyntaxErrorKind};
pub use file_lines::{AllLines, FileLines};
pub use grammar::{MAX_DEPTH, MAX_TERMS, is_declaration_keyword, is_type_keyword};
pub use kind::{LadderLanguage, SyntaxKind, SyntaxNode, SyntaxToken};
pub use lexer::{is_address, is_literal};
pub use line::{LineKind, Mode, ReadLine};
pub use line_index::{LineColumn, LineIndex, line_around};
pub use line_tree::{Line, LineTree, Trees};
pub use lines::{LineList, LineReader, Lines, read_lines};
pub use name::{Name, is_block_name, is_identifier, is_reserved};
pub use parse::{MAX_FILE_BYTES, MAX_OPEN_BYTES, MAX_OPEN_LINES, Parse, parse, tree};
pub use part::Part;
pub use structure::{BlockDefinition, Frame, Item, Network, Section, Structure};

pub use rowan::{self, NodeOrToken, TextRange, TextSize};

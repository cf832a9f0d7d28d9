//! What a notation of ladder programs is, and what all of them share.
//!
//! ```text
//! foreign bytes --Notation::read--> ProgramSketch + Report --convert--> ladder text, places, report
//! ladder text   --analysis--------> Analysis --Notation::write-------> foreign text + Report
//! ```
//!
//! A notation is one crate next to this one and one line in the list, `ladder-notations`. It knows no files and no
//! layout: what it reads is a sketch, which the one writer of `ladder-format` draws; what it writes comes from an analysed
//! program. Nothing is dropped silently: the [`Report`] says of each element what became of it. `convert` is the one way in: a file in
//! another encoding is UTF-8 before a notation sees it, and what a project is written into has names that every system takes.
#![forbid(unsafe_code)]

pub mod address;
mod arrays;
mod block_name;
mod bridges;
pub mod chart;
pub mod circuit;
pub mod comments;
mod convert;
mod elements;
mod encoding;
mod error;
mod file_name;
mod finding;
mod folded;
mod foreign;
mod formulas;
mod fresh;
mod functions;
pub mod guard;
mod iec_names;
mod items;
pub mod kept;
mod loops;
mod no_program;
mod notation;
mod one_file;
pub mod pieces;
mod place;
mod project;
mod reading;
mod remark;
mod report;
mod rewritten;
mod source;
pub mod stand_in;
mod system;
mod target;
mod tasks;
mod unread;
mod whole;
mod written;
pub mod xml;

pub use block_name::{BlockNames, block_name};
pub use convert::{Converted, convert};
pub use elements::blocks;
pub use encoding::in_utf8;
pub use error::{ReadError, WriteError};
pub use finding::Finding;
pub use folded::folded;
pub use foreign::{Foreign, Mark};
pub use functions::is_function;
pub use iec_names::is_reserved_in_iec;
pub use ladder_format::names::{self, Names};
pub use ladder_syntax::LineColumn;
pub use no_program::no_program;
pub use notation::{Notation, Reach, has_extension};
pub use one_file::{Kept, OneFile, WrittenProject, without_known, write_one_file};
pub use place::Lines;
pub use project::Project;
pub use reading::{Content, ProjectFile, Reading, Writing};
pub use remark::{Remark, remarks};
pub use report::{Entry, Outcome, Report, Tally};
pub use source::{Bytes, Companion, Source, text_of};
pub use target::{Stays, Target, Unwritable};
pub use tasks::ProjectTask;
pub use unread::{Power, Turn, Unread, UnreadParts, foreign_text_of, unread_body, unread_operands};
pub use written::{refuse_unread, write_checked};

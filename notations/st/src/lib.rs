//! Ladder programs as Structured Text of IEC 61131-3, to be read, compiled and kept by people.
//!
//! ```text
//! program model --network: powers as expressions, blocks as statements--> bodies --declarations, pieces--> text
//! ```
//!
//! What is written is the analysed program, network by network. The power of a rung is an expression of its contacts, written where
//! something acts on it; what a later statement would change gets a name first. Where the standard leaves open what happens, or
//! says something else than the language does, a function or block of `runtime/` is written along; only those that a program
//! needs. What cannot be expressed is refused, with its place.
//!
//! What is read is a file of Structured Text, or a body in one that is in another file: see [`read`].
#![forbid(unsafe_code)]

mod arguments;
mod arithmetic;
mod block;
mod checks;
mod coil;
mod comment;
mod convert;
mod curve;
mod expression;
mod flow;
mod literal;
mod names;
mod network;
mod pieces;
mod place;
mod power;
mod project;
mod range;
pub mod read;
mod sections;
mod states;
mod term;
mod texts;
mod unit;
mod user;
mod write;

use ladder_analysis::Analysis;
use ladder_notation::{Notation, Reach, ReadError, Reading, Source, WriteError, Writing, has_extension};

/// See the module.
#[derive(Debug)]
pub struct St;

impl Notation for St {
    fn name(&self) -> &'static str {
        "st"
    }

    fn title(&self) -> &'static str {
        "Structured Text"
    }

    fn extensions(&self) -> &'static [&'static str] {
        &["st"]
    }

    fn writes_other_files(&self) -> bool {
        true
    }

    fn owns_extension(&self) -> bool {
        true
    }

    fn is_in_workspaces(&self) -> bool {
        true
    }

    fn reach(&self) -> Reach {
        Reach::Workspace
    }

    fn has_companion(&self, _program: &str, file: &str) -> bool {
        let end = file.rsplit('.').next().unwrap_or_default();
        has_extension(self, end) || end.eq_ignore_ascii_case("clad")
    }

    fn recognises(&self, bytes: &[u8]) -> bool {
        std::str::from_utf8(bytes).is_ok_and(read::begins_program)
    }

    fn read(&self, source: &Source<'_>) -> Result<Reading, ReadError> {
        read::read(source.text()?, read::Dialect::Iec, &source.companions)
    }

    fn write(&self, analysis: &Analysis) -> Result<Writing, WriteError> {
        write::write(analysis)
    }
}

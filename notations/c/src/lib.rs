//! Ladder programs as C libraries: one source, one header, C99 without an allocation or a global variable.
//!
//! ```text
//! program --compile (simulator)--> flat code + first memory --code, data, header--> motor.c, motor.h
//! ```
//!
//! What is translated is the simulator's own code, instruction by instruction, so that each instruction has one meaning:
//! the library does what `ladder sim` shows. What an instruction needs of C is a piece of `runtime/`, and only the
//! pieces that a program uses are written. A header declares three things: a structure with the inputs, the outputs and all else
//! that the program remembers; `NAME_init`; and `NAME_scan`, which runs one scan at a time of the caller's.
//!
//! C is only written: it cannot be read as a ladder program again.
#![forbid(unsafe_code)]

mod code;
mod constants;
mod data;
mod header;
mod interface;
mod names;
mod pieces;
mod retained;
mod write;

use ladder_analysis::Analysis;
use ladder_notation::{Notation, ReadError, Reading, Source, WriteError, Writing};

/// See the module.
#[derive(Debug)]
pub struct C;

impl Notation for C {
    fn name(&self) -> &'static str {
        "c"
    }

    fn title(&self) -> &'static str {
        "C library"
    }

    fn extensions(&self) -> &'static [&'static str] {
        &["c"]
    }

    fn is_read(&self) -> bool {
        false
    }

    fn writes_other_files(&self) -> bool {
        true
    }

    fn recognises(&self, _bytes: &[u8]) -> bool {
        false
    }

    fn read(&self, _source: &Source<'_>) -> Result<Reading, ReadError> {
        Err(ReadError::whole(
            "C is only written: a ladder program cannot be read from it",
        ))
    }

    fn write(&self, analysis: &Analysis) -> Result<Writing, WriteError> {
        write::write(analysis)
    }
}

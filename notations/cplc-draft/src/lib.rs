//! The first draft of CPLC-LD by its author (2019): the same drawing, with `//` comments, `IN = { .. }` headers, and one
//! `<..>` for each operand.
//!
//! ```text
//! // a motor
//! IN  = { DI start, DI stop }
//! OUT = { DO run }
//! VAR = { INT count, BOOL[4] step }
//!
//! +---\---[ ]<start>---\---[/]<stop>---( )<run>---+
//!     |                |
//!     /---[ ]<run>-----/
//! ```
//!
//! `(..)` is read in place of `<..>` too, as the author wrote both. A timer or counter `[TON]<name><reset><time><preset>`
//! is one tag here: where the program reads `name` it reads `name.Q`, where it reads `time` it reads `name.ET`
//! (`count`: `name.CV`). The draft does not say what a preset counts: milliseconds here. A comparison's or calculation's `name` becomes a coil after it where the program reads it.

mod blocks;
mod header;
mod line;
mod read;
mod write;

use ladder_analysis::Analysis;
use ladder_notation::{Notation, ReadError, Reading, Source, WriteError, Writing};

/// See the module.
#[derive(Debug)]
pub struct CplcDraft;

impl Notation for CplcDraft {
    fn name(&self) -> &'static str {
        "cplc-draft"
    }

    fn title(&self) -> &'static str {
        "program in the first draft of CPLC-LD"
    }

    fn extensions(&self) -> &'static [&'static str] {
        &["cplc"]
    }

    fn recognises(&self, bytes: &[u8]) -> bool {
        std::str::from_utf8(bytes).is_ok_and(ladder_analysis::is_cplc_draft)
    }

    fn read(&self, source: &Source<'_>) -> Result<Reading, ReadError> {
        read::read(source.text()?)
    }

    fn write(&self, analysis: &Analysis) -> Result<Writing, WriteError> {
        write::write(analysis)
    }
}

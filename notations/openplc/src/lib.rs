//! Ladder programs of OpenPLC Editor 4 (`.ld`): declarations as IEC 61131-3 writes them, then one JSON object with the
//! rungs.
//!
//! ```text
//! text --header--> a unit with its variables
//!      --rungs---> its body as a graph --project--> with what it uses of its project, the model of
//!                  `ladder-notation-plcopen`, and its way to ladder text
//! ```
#![forbid(unsafe_code)]

mod header;
mod project;
mod rungs;

use ladder_analysis::Analysis;
use ladder_notation::{Notation, Reach, ReadError, Reading, Source, WriteError, Writing};

/// See the module.
#[derive(Debug)]
pub struct OpenPlc;

impl Notation for OpenPlc {
    fn name(&self) -> &'static str {
        "openplc"
    }

    fn title(&self) -> &'static str {
        "OpenPLC ladder program"
    }

    fn extensions(&self) -> &'static [&'static str] {
        &["ld"]
    }

    fn is_written(&self) -> bool {
        false
    }

    fn recognises(&self, bytes: &[u8]) -> bool {
        header::recognises(bytes)
    }

    fn has_companion(&self, _program: &str, file: &str) -> bool {
        project::is_file(file)
    }

    fn reach(&self) -> Reach {
        Reach::Project(Some(project::PROJECT))
    }

    fn read(&self, source: &Source<'_>) -> Result<Reading, ReadError> {
        project::project(source).map(ladder_notation_plcopen::reading)
    }

    fn write(&self, _: &Analysis) -> Result<Writing, WriteError> {
        Err(WriteError::new("programs of OpenPLC Editor 4 are read only"))
    }
}

//! Ladder programs of OpenPLC Editor 4 (`.ld`): declarations as IEC 61131-3 writes them, then one JSON object with the
//! rungs.
//!
//! ```text
//! text --header--> a unit with its variables
//!      --rungs---> its body as a graph --> the model of `ladder-notation-plcopen`, and its way to ladder text
//! ```
#![forbid(unsafe_code)]

mod header;
mod rungs;

use ladder_analysis::Analysis;
use ladder_notation::{Notation, ReadError, Reading, Source, WriteError, Writing};
use ladder_notation_plcopen::model::{Body, Project};

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

    fn read(&self, source: &Source<'_>) -> Result<Reading, ReadError> {
        let text = source.text()?;
        let mut project = Project::default();
        let (mut unit, json) = header::read(text, &mut project.report)?;
        unit.body = Body::Graph(rungs::read(text, json, &mut project.report)?);
        project.units.push(unit);
        Ok(ladder_notation_plcopen::reading(project))
    }

    fn write(&self, _: &Analysis) -> Result<Writing, WriteError> {
        Err(WriteError::new("programs of OpenPLC Editor 4 are read only"))
    }
}

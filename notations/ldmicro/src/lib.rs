//! LDmicro's programs (`.ld`): the text files of LDmicro 2.2 (`LDmicro0.1`) and of its fork (`LDmicro0.2`).
//!
//! ```text
//! bytes --parse--> File --sketch--> sketch of a ladder program, report, findings
//!                    |
//!                  save --> bytes as LDmicro saves them
//!                    |
//! analysed program --export--> File
//! ```
//!
//! What ladder text cannot say stays in comments of three forms, so that export gives the file back:
//! `# ldmicro: MICRO=.. #` above the declarations (header, renamed names), `# ldmicro: GOSUB init #` in a wire (an
//! element without a counterpart), and `# was: MOVE ch 'A' #` after a block (the same element, in other words).

mod drawn;
mod element;
mod export;
mod field;
mod fork;
mod head;
mod kept;
mod model;
mod parse;
mod rules;
mod save;
mod sketch;
mod tags;
mod text;

pub use drawn::LdmicroText;

use ladder_analysis::Analysis;
use ladder_notation::{Notation, ReadError, Reading, Source, Target, WriteError, Writing};

/// See the module.
#[derive(Debug)]
pub struct Ldmicro;

impl Notation for Ldmicro {
    fn name(&self) -> &'static str {
        "ldmicro"
    }

    fn title(&self) -> &'static str {
        "LDmicro program"
    }

    fn extensions(&self) -> &'static [&'static str] {
        &["ld"]
    }

    fn recognises(&self, bytes: &[u8]) -> bool {
        head::recognises(bytes)
    }

    fn writes_unread(&self) -> bool {
        true
    }

    fn read(&self, source: &Source<'_>) -> Result<Reading, ReadError> {
        source.bounded()?;
        let file = parse::parse(source.bytes)?;
        let mut reading = sketch::sketch(&file);
        reading.findings.extend(rules::findings(&file));
        reading.findings.sort_by_key(|finding| finding.place);
        Ok(reading)
    }

    fn write(&self, analysis: &Analysis) -> Result<Writing, WriteError> {
        Target::SERIES_AND_BRANCHES.write(analysis, |analysis, _| {
            let (file, report) = export::file(analysis)?;
            Ok(Writing {
                bytes: save::save(&file),
                companions: Vec::new(),
                report,
            })
        })
    }
}

/// An LDmicro file as LDmicro itself would save it.
///
/// # Errors
///
/// If it is not an LDmicro program, or a broken one.
pub fn resaved(bytes: &[u8]) -> Result<Vec<u8>, ReadError> {
    parse::parse(bytes).map(|file| save::save(&file))
}

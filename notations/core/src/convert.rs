//! From a file of another system to ladder text.

use super::{Finding, LineColumn, Notation, ReadError, Reading, Report, Source};
use ladder_format::program::WrittenProgram;
use ladder_syntax::TextSize;

/// A foreign program as ladder text.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Converted {
    /// The text, and the places in it that were made from something.
    pub written: WrittenProgram,
    /// Where in the foreign file that something is.
    pub places: Vec<LineColumn>,
    /// What became of each element.
    pub report: Report,
    /// What the other system itself would complain about.
    pub findings: Vec<Finding>,
}

impl Converted {
    /// The place of the foreign file that the text at an offset was made from; its beginning if it was made from
    /// nothing.
    pub fn place_of(&self, offset: TextSize) -> LineColumn {
        self.written
            .origin_at(offset)
            .and_then(|origin| self.places.get(origin as usize).copied())
            .unwrap_or(LineColumn::START)
    }
}

/// Reads a foreign program and writes it as ladder text.
///
/// # Errors
///
/// As [`Notation::read`].
pub fn convert(
    notation: &dyn Notation,
    source: &Source<'_>,
    options: &ladder_format::Options,
) -> Result<Converted, ReadError> {
    let Reading {
        program,
        places,
        report,
        findings,
    } = notation.read(source)?;
    Ok(Converted {
        written: program.write(options),
        places,
        report,
        findings,
    })
}

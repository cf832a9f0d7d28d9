//! Writing a program in another notation, and reading it again: what is broken then is refused.

use super::{Foreign, LineColumn, Notation, Source, WriteError, Writing};
use ladder_analysis::Analysis;
use std::sync::Arc;

/// Writes a program that has no errors. What is written is read again, where the notation [is](Notation::is_read), as a file whose name has this stem: what cannot
/// be read, and each error in what it becomes, is refused in the report.
///
/// # Errors
///
/// As [`Notation::write`].
pub fn write_checked(
    notation: &'static dyn Notation,
    analysis: &Analysis,
    stem: &str,
) -> Result<Writing, WriteError> {
    // What is written is called as its file is.
    let mut named = analysis.clone();
    Arc::make_mut(&mut named.context).name = stem.into();
    let mut writing = notation.write(&named)?;
    if !notation.is_read() {
        return Ok(writing);
    }
    let source = Source {
        name: stem.into(),
        bytes: &writing.bytes,
        companions: writing.companions.clone(),
    };
    let again = match Foreign::read(notation, &source) {
        Ok(again) => again,
        Err(error) => {
            let why = format!("what is written cannot be read again: {error}");
            writing.report.refused(LineColumn::START, notation.title(), why);
            return Ok(writing);
        }
    };
    let text = again.ladder();
    let analysis = ladder_analysis::analyze(&ladder_syntax::parse(text).into(), stem);
    for error in analysis.errors() {
        let place = again.place(error.range);
        let why = format!("at {place} of what is written: {}", error.message);
        writing.report.refused(LineColumn::START, &text[error.range], why);
    }
    Ok(writing)
}

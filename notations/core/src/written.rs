//! Writing a program in another notation, and reading it again: what is broken then is refused.

use super::{Foreign, LineColumn, Lines, Notation, Report, Source, WriteError, Writing};
use ladder_analysis::Analysis;
use ladder_analysis::networks::NetworkAt;
use ladder_analysis::networks::network::Meaning;
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
    if !notation.writes_unread() {
        refuse_unread(&named, &mut writing.report, |_| false);
    }
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

/// Refuses the unread parts of a program at their places, but for those that are written as what they were. Those are asked for by
/// the names of their blocks, as `$MSG`.
pub fn refuse_unread(analysis: &Analysis, report: &mut Report, is_written: impl Fn(&str) -> bool) {
    let context = &analysis.context;
    if context.user_blocks.iter().all(|block| block.unread.is_none()) {
        return;
    }
    let text = context.parse.to_string();
    let lines = Lines::of(&text);
    for block in context.networks.iter().flat_map(NetworkAt::blocks) {
        let Meaning::User(user) = block.meaning else {
            continue;
        };
        let of = &context.user_blocks[user];
        if of.unread.is_some() && !is_written(&of.name) {
            let place = lines.place(&text, block.range().start().into());
            let why = "it is an unread part: what it does is not known here, and so it is not written";
            report.refused(place, block.head_text(), why);
        }
    }
}

//! Open programs of other systems: their diagnostics, and the ladder text that they become for those who follow it.

use std::sync::Arc;

use ladder_analysis::{Diagnostic as Finding, Severity};
use ladder_documents::{Opened, Revision};
use ladder_notations::{Lines, Mark, ReadError};
use ladder_syntax::{TextRange, TextSize};
use tower_lsp::ls_types::Diagnostic;

use super::{diagnostics, shown};
use crate::lsp::finding::Findings;
use crate::lsp::session::agreed::Agreed;
use crate::lsp::{convert, session::shared::Shared};
use crate::notation::messages::Previewed;

/// What is where the name of a rule would, for a file that cannot be read.
const BAD_PROGRAM: &str = "bad-program";

/// What is wrong in a program of another system. For a blocking thread.
pub(crate) fn diagnostics_of(agreed: Agreed, revision: &Revision) -> Vec<Diagnostic> {
    match revision.opened() {
        Some(Ok(opened)) => of_program(agreed, revision, opened),
        Some(Err(error)) => of_broken(revision, error),
        None => Vec::new(),
    }
}

/// What the other system complains about, or this one.
enum Said<'o> {
    Mark(&'o Mark),
    Finding(&'o Finding),
}

impl Said<'_> {
    fn start(&self) -> TextSize {
        match self {
            Said::Mark(mark) => mark.range.start(),
            Said::Finding(finding) => finding.range.start(),
        }
    }

    fn is_error(&self) -> bool {
        let severity = match self {
            Said::Mark(mark) => mark.severity,
            Said::Finding(finding) => finding.severity,
        };
        severity == Severity::Error
    }
}

fn of_program(agreed: Agreed, revision: &Revision, opened: &Opened) -> Vec<Diagnostic> {
    let marks = opened.foreign().remarks();
    let mut all: Vec<Said<'_>> = marks.iter().map(Said::Mark).collect();
    all.extend(opened.findings().iter().map(Said::Finding));
    all.sort_by_key(Said::start);
    let (chosen, left_out) = shown::chosen(&all, revision.edited(), |told| (told.is_error(), told.start()));
    let mut findings = Findings::of(agreed, revision);
    let mut items: Vec<Diagnostic> = Vec::with_capacity(chosen.len() + 1);
    for told in chosen {
        match told {
            Said::Mark(mark) => {
                let range = convert::range_in(revision, mark.range);
                items.push(convert::diagnostic(
                    range,
                    mark.severity,
                    mark.check,
                    mark.message.clone(),
                ));
            }
            Said::Finding(finding) => items.push(findings.diagnostic(finding)),
        }
    }
    items.extend(shown::rest(left_out));
    items
}

fn of_broken(revision: &Revision, error: &ReadError) -> Vec<Diagnostic> {
    let text = revision.text();
    let lines = Lines::of(&text);
    let all: Vec<(TextRange, &str)> = error
        .all()
        .map(|(place, message)| (lines.word(&text, place), message))
        .collect();
    let (chosen, left_out) = shown::chosen(&all, revision.edited(), |(range, _)| (true, range.start()));
    let items = chosen.into_iter().map(|(range, message)| {
        let range = convert::range_in(revision, *range);
        convert::diagnostic(range, Severity::Error, BAD_PROGRAM, (*message).to_owned())
    });
    items.chain(shown::rest(left_out)).collect()
}

/// Has the open files of its workspace checked again if they see something else in a program than before. For a blocking thread.
pub(crate) fn tell_others(shared: &Arc<Shared>, revision: &Revision) {
    if let Some(place) = revision
        .place()
        .filter(|_| shared.companions.is_current(revision))
    {
        let affected = revision.tell_neighbours();
        diagnostics::passed_on(shared, affected, &place.path);
    }
}

/// Tells the one who follows it the ladder text of a program, if it is another one now. One that cannot be read has none:
/// what was sent last stays. For a blocking thread.
pub(crate) fn tell_preview(shared: &Shared, revision: &Arc<Revision>) {
    if !shared.previews.follow(&revision.uri) || !shared.companions.is_current(revision) {
        return;
    }
    if let Some(Ok(opened)) = revision.opened() {
        let previewed = previewed(revision, opened);
        shared
            .outbox
            .preview(&shared.companions, revision.clone(), &shared.previews, previewed);
    }
}

/// A program's ladder text as a message has it.
pub(crate) fn previewed(revision: &Revision, opened: &Opened) -> Previewed {
    Previewed {
        uri: revision.uri.to_string(),
        version: revision.version,
        text: opened.foreign().ladder().to_owned(),
    }
}

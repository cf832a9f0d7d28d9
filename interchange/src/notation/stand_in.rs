//! Elements without a counterpart, which stand in ladder text as comments, on their way back.

use super::{Lines, WriteError};
use ladder_analysis::Analysis;
use std::borrow::Cow;

/// What holds the place of a comment; a parenthesis closes it.
const STAND_IN: &str = "[ ](SYS.ON";

/// The analysis of a text in which each comment on a rung that is an element has a contact in its place, so that it has
/// a place in the circuit. Every byte stays where it is: what is at the contact's place in the text is the comment.
///
/// # Errors
///
/// If the program has errors.
pub(super) fn analysis<'a>(
    analysis: &'a Analysis,
    text: &str,
    is_element: impl Fn(&str) -> bool,
) -> Result<Cow<'a, Analysis>, WriteError> {
    let mut aside = String::with_capacity(text.len());
    for line in text.split_inclusive('\n') {
        let mut rest = line;
        let in_rung = line.starts_with(['+', '|', '/', '\\']);
        while let Some(start) = rest.find('#') {
            let Some(length) = rest[start + 1..].find('#').map(|at| at + 2) else {
                break;
            };
            let comment = &rest[start..start + length];
            aside.push_str(&rest[..start]);
            if in_rung && length > STAND_IN.len() && is_element(comment) {
                let blanks = length - STAND_IN.len() - 1;
                aside.push_str(&format!("{STAND_IN}{:blanks$})", ""));
            } else {
                aside.push_str(comment);
            }
            rest = &rest[start + length..];
        }
        aside.push_str(rest);
    }
    let analysis = if aside == text {
        Cow::Borrowed(analysis)
    } else {
        let parse = ladder_syntax::parse(&aside).into();
        Cow::Owned(ladder_analysis::analyze(&parse, &analysis.context.name))
    };
    if analysis.program().is_some() {
        return Ok(analysis);
    }
    let first = analysis.errors().next().map(|error| {
        let place = Lines::of(text).place(text, error.range.start().into());
        format!(": {place}: {}", error.message)
    });
    let why = first.unwrap_or_else(|| ", or needs another file of its workspace".to_owned());
    Err(WriteError::new(format!("the program has errors{why}")))
}

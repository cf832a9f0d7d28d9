//! What the words of a property mean.

use super::file::Scenarios;
use crate::completion::Snippet;
use ladder_simulator::scenario::{FORMS, Form, PROPERTY, TextLine};
use ladder_syntax::{Name, TextRange, TextSize};

/// What an operand of a property stands for.
pub(super) const IN_PROPERTY: &str = "What it is after a scan.";

const ALWAYS: &str = "Violated in a scan after which the condition is FALSE.";
const NEVER: &str = "Violated in a scan after which the condition is TRUE.";
const WHEN: &str = "`when a: b` is violated in a scan after which `a` is TRUE and `b` is not. `when a: b until c` also in each \
                    scan after that, up to the one in which `c` is TRUE.";
const AFTER: &str =
    "`after a: b` is violated in a scan after which `b` is FALSE, if `a` was TRUE after the scan before.";
const WITHIN: &str = "`within 500ms of a: b` is violated if `b` does not come so soon after `a`: a time, or a number of scans \
                      as in `within 3 scans of a: b`.";
const POSSIBLE: &str = "The other way round: asks for a run that has a scan after which the condition is TRUE. `possible e within \
                        10s` asks for one that has it so soon.";
const NO_FAULTS: &str =
    "Violated in a scan in which a block records a fault: a division by zero, an index that is outside.";

/// What a word at the beginning of a line of a property is for.
pub(super) fn form(word: &str) -> Option<&'static str> {
    Some(match word {
        PROPERTY => {
            "What must hold in every run of the program, whatever goes into it. Its name is in quotes, its form after that or on \
             the next line. `ladder prove` decides it."
        }
        "assume" => {
            "What is assumed of the inputs, in every scan: runs in which it does not hold are left out of all proofs of this file."
        }
        "always" => ALWAYS,
        "never" => NEVER,
        "when" => WHEN,
        "after" => AFTER,
        "within" => WITHIN,
        "possible" => POSSIBLE,
        "no" => NO_FAULTS,
        _ => return None,
    })
}

/// What a form demands.
pub(super) fn of_form<E>(form: &Form<E>) -> &'static str {
    match form {
        Form::Always(_) => ALWAYS,
        Form::Never(_) => NEVER,
        Form::When { .. } => WHEN,
        Form::After { .. } => AFTER,
        Form::Within { .. } => WITHIN,
        Form::Possible { .. } => POSSIBLE,
        Form::NoFaults => NO_FAULTS,
    }
}

/// What a word further on in such a line is for.
pub(super) fn in_property(word: &str) -> Option<&'static str> {
    Some(match word {
        "until" => "Up to the scan after which this is TRUE; in that one nothing is demanded any more.",
        "of" => "What is before it is how soon the answer comes, what is after it asks.",
        "rises" => {
            "`rises(e)`: `e` is TRUE now and was not after the scan before; what is TRUE after the first scan has risen."
        }
        "falls" => "`falls(e)`: `e` is FALSE now and was TRUE after the scan before.",
        "was" => "`was(e)`: what `e` was after the scan before; FALSE or 0 before the first.",
        "faults" => NO_FAULTS,
        word => return form(word),
    })
}

/// The functions that only properties have.
pub(super) const PAST: [&str; 3] = ["rises", "falls", "was"];

/// What can be written for each form: what the list shows, and the text.
pub(super) fn snippets() -> Vec<(&'static str, Snippet)> {
    let one = |word: &str| Snippet::default().text(word).stop("condition");
    let two = |word: &str, then: &str| one(word).text(": ").stop(then);
    vec![
        ("never", one("never ")),
        ("always", one("always ")),
        ("when", two("when ", "what holds")),
        (
            "when until",
            two("when ", "what holds").text(" until ").stop("end"),
        ),
        ("after", two("after ", "what holds then")),
        (
            "within",
            Snippet::default()
                .text("within ")
                .stop("500ms")
                .text(" of ")
                .stop("condition")
                .text(": ")
                .stop("answer"),
        ),
        ("possible", one("possible ")),
        ("no faults", Snippet::plain_text("no faults")),
    ]
}

/// Whether a line is one of a property or an assumption, if only the beginning of one, and not a row of a tag that is called so.
pub(super) fn is_of_property(scenarios: &Scenarios<'_>, start: TextSize, text: &str) -> bool {
    let line = TextLine::read(text, "", start.into());
    let Some(first) = line.words.first() else {
        return false;
    };
    if first.text != PROPERTY && !FORMS.contains(&first.text) {
        return false;
    }
    let place: TextRange = first.range();
    let mut rows = scenarios.suite.scenarios.iter().flat_map(|it| &it.rows);
    let is_row = rows.any(|row| row.range == place);
    let is_tag = || {
        let tags = scenarios.program.and_then(|program| program.scopes.first());
        tags.is_some_and(|tags| tags.find(&Name::new(first.text)).is_some())
    };
    !(is_row && (line.words.len() > 1 || is_tag()))
}

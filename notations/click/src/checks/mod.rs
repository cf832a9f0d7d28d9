//! What Click says about a program: the rules of the DSL's page and the checks of Click's own software.
//!
//! Checks that the vendor numbers have its number: `click-c0201`.

mod copies;
mod drawing;
mod flow;
mod kinds;
mod mathematics;
mod memory;
mod words;

pub(super) use words::Words;

use super::model::{Action, Program, Routine, Rung};
use ladder_analysis::Severity;
use ladder_notation::{Finding, LineColumn};

/// All that Click would complain about, from the top to the bottom, in the words of the notation that the program is in.
pub(super) fn findings(program: &Program, words: Words) -> Vec<Finding> {
    let mut out = Found {
        words,
        all: Vec::new(),
    };
    flow::check(program, &mut out);
    memory::check(program, &mut out);
    drawing::check(program, &mut out);
    for (_, _, action) in actions(program) {
        kinds::action(action, &mut out);
    }
    for rung in program.routines().flat_map(|routine| &routine.rungs) {
        kinds::condition(&rung.condition, &mut out);
    }
    out.all.sort_by_key(|finding| finding.place);
    out.all
}

/// Each action with its rung and its routine.
fn actions(program: &Program) -> impl Iterator<Item = (&Routine, &Rung, &Action)> {
    program.routines().flat_map(|routine| {
        let rungs = routine.rungs.iter();
        rungs.flat_map(move |rung| rung.actions.iter().map(move |action| (routine, rung, action)))
    })
}

/// What was found so far.
struct Found {
    words: Words,
    all: Vec<Finding>,
}

impl Found {
    fn error(&mut self, place: LineColumn, check: &'static str, message: impl Into<String>) {
        self.push(place, Severity::Error, check, message.into());
    }

    fn warning(&mut self, place: LineColumn, check: &'static str, message: impl Into<String>) {
        self.push(place, Severity::Warning, check, message.into());
    }

    fn info(&mut self, place: LineColumn, check: &'static str, message: impl Into<String>) {
        self.push(place, Severity::Info, check, message.into());
    }

    fn push(&mut self, place: LineColumn, severity: Severity, check: &'static str, message: String) {
        self.all.push(Finding {
            place,
            severity,
            check,
            message,
        });
    }
}

#[cfg(test)]
mod tests;

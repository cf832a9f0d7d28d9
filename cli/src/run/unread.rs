//! The unread parts of programs are named, once for each program.

use crate::terminal;
use ladder_analysis::program::Program;
use ladder_workspace::shown;
use std::collections::BTreeSet;
use std::sync::Mutex;

/// What was said already.
static SAID: Mutex<BTreeSet<String>> = Mutex::new(BTreeSet::new());

/// Says on stderr which unread parts a program has.
pub(crate) fn note(file: &str, program: &Program) {
    let Some(note) = program.unread_note() else { return };
    let message = format!("{}: {}", shown::line(file), shown::line(&note));
    let is_new = SAID.lock().is_ok_and(|mut said| said.insert(message.clone()));
    if is_new {
        terminal::note(&message);
    }
}

/// Their names, for reports.
pub(crate) fn names(program: &Program) -> Vec<String> {
    program
        .unread_parts()
        .map(|(_, name, _)| name.to_owned())
        .collect()
}

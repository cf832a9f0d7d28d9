//! The unread parts of programs are named, once for each program.

use crate::terminal;
use crate::xml::attribute;
use ladder_analysis::program::Program;
use ladder_workspace::shown;
use std::collections::BTreeSet;
use std::sync::Mutex;

/// What was reported already.
static SAID: Mutex<BTreeSet<String>> = Mutex::new(BTreeSet::new());

/// Says on stderr which unread parts a program has.
pub(crate) fn note(file: &str, program: &Program) {
    let Some(note) = program.unread_note() else { return };
    let message = format!("{}: {}", shown::line(file), shown::line(&note));
    let is_new = SAID.lock().is_ok_and(|mut told| told.insert(message.clone()));
    if is_new {
        terminal::note(&message);
    }
}

/// What a report in the form of JUnit says of a program: what each is, and its name.
pub(crate) fn properties<'n>(names: impl Iterator<Item = (&'n str, &'n str)>) -> String {
    let mut out = String::new();
    for (what, name) in names {
        let name = attribute(name);
        out.push_str(&format!("      <property name=\"{what}\" value=\"{name}\"/>\n"));
    }
    if out.is_empty() {
        return out;
    }
    format!("    <properties>\n{out}    </properties>\n")
}

/// Their names, for reports.
pub(crate) fn names(program: &Program) -> Vec<String> {
    program
        .unread_parts()
        .map(|(_, name, _)| name.to_owned())
        .collect()
}

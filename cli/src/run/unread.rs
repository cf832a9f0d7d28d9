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

/// Their names in a report in the form of JUnit.
pub(crate) fn properties(names: &[String]) -> String {
    if names.is_empty() {
        return String::new();
    }
    let mut out = String::from("    <properties>\n");
    for name in names {
        let name = attribute(name);
        out.push_str(&format!(
            "      <property name=\"unread part\" value=\"{name}\"/>\n"
        ));
    }
    out + "    </properties>\n"
}

/// Their names, for reports.
pub(crate) fn names(program: &Program) -> Vec<String> {
    program
        .unread_parts()
        .map(|(_, name, _)| name.to_owned())
        .collect()
}

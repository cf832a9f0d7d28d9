//! `--same`: whether programs do the same.

use super::settings::SettingsDiff;
use crate::outcome::Outcome;
use ladder_review::report::Compared;
use ladder_review::whole::{Whole, whole};
use ladder_workspace::shown;
use std::io::{self, Write};

/// Prints it of all programs together, with what shows that they differ or why it is not known.
pub(super) fn print(compared: &[Compared<'_>], settings: &[SettingsDiff]) -> io::Result<Outcome> {
    let (mut others, mut open) = (Vec::new(), Vec::new());
    for file in compared {
        let (to, said) = match (file.old, file.new) {
            (Some(_), Some(_)) => match whole(&file.comparison) {
                Whole::Same => continue,
                Whole::Other(said) => (&mut others, said),
                Whole::NotDecided(said) => (&mut open, said),
            },
            (None, _) => (&mut open, vec![String::from("a new file")]),
            (_, None) => (&mut open, vec![String::from("gone")]),
        };
        to.extend(said.iter().map(|said| format!("{}: {said}", file.name())));
    }
    open.extend(
        settings
            .iter()
            .map(|diff| format!("{}: other settings", diff.name())),
    );
    let (answer, reasons) = match (others.is_empty(), open.is_empty()) {
        (true, true) => ("the same", others),
        (true, false) => ("not decided", open),
        (false, _) => ("not the same", others),
    };
    let mut out = io::stdout().lock();
    writeln!(out, "{answer}")?;
    for reason in &reasons {
        writeln!(out, "  {}", shown::line(reason))?;
    }
    Ok(if answer == "the same" {
        Outcome::Fine
    } else {
        Outcome::Findings
    })
}

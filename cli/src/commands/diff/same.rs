//! `--same`: whether programs do the same.

use super::settings::SettingsDiff;
use crate::outcome::Outcome;
use ladder_review::report::Compared;
use ladder_review::whole::{Whole, said};
use ladder_workspace::shown;
use std::io::{self, Write};

/// Prints it of all programs together, with what shows that they differ or why it is not known.
pub(super) fn print(compared: &[Compared<'_>], settings: &[SettingsDiff]) -> io::Result<Outcome> {
    let (mut others, mut open) = (Vec::new(), Vec::new());
    for file in compared {
        let add = |to: &mut Vec<String>, reasons: &[String]| {
            to.extend(reasons.iter().map(|reason| format!("{}: {reason}", file.name())));
        };
        match &file.comparison.whole {
            Some(Whole::Same) => {}
            Some(Whole::Differs(run)) => {
                let (said, rows) = said(run);
                add(&mut others, &[said]);
                others.extend(rows.iter().map(|row| format!("  {row}")));
            }
            Some(Whole::Outputs(names)) => add(&mut others, names),
            Some(Whole::NotDecided(reasons)) => add(&mut open, reasons),
            None if file.old.is_none() => add(&mut open, &["a new file".into()]),
            None => add(&mut open, &["gone".into()]),
        }
    }
    open.extend(
        settings
            .iter()
            .map(|diff| format!("{}: other settings", diff.name())),
    );
    let (answer, outcome, reasons) = match (others.is_empty(), open.is_empty()) {
        (true, true) => ("the same", Outcome::Fine, others),
        (true, false) => ("not decided", Outcome::Findings, open),
        (false, _) => ("not the same", Outcome::Findings, others),
    };
    let mut out = io::stdout().lock();
    writeln!(out, "{answer}")?;
    for reason in &reasons {
        writeln!(out, "  {}", shown::line(reason))?;
    }
    Ok(outcome)
}

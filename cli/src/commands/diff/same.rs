//! `--same`: whether programs do the same.

use super::settings::SettingsDiff;
use crate::found_runs::{are_together, of_one};
use crate::outcome::{Failure, Outcome};
use crate::terminal;
use ladder_prover::{Which, scenario_file, scenario_of_difference};
use ladder_review::report::Compared;
use ladder_review::whole::{REFUTED, Whole, told};
use ladder_simulator::scenario::program_line;
use ladder_workspace::shown;
use std::io::{self, Write};
use std::path::Path;

/// Prints it of all programs together, with what shows that they differ or why it is not known.
pub(super) fn print(compared: &[Compared<'_>], settings: &[SettingsDiff]) -> io::Result<Outcome> {
    let (mut others, mut open, mut names) = (Vec::new(), Vec::new(), Vec::new());
    for file in compared {
        let add = |to: &mut Vec<String>, reasons: &[String]| {
            to.extend(reasons.iter().map(|reason| format!("{}: {reason}", file.name())));
        };
        let shown = file
            .comparison
            .renames
            .iter()
            .filter(|rename| rename.shown_as.is_some());
        names.extend(shown.map(|rename| format!("{}: renamed: {rename}", file.name())));
        match &file.comparison.whole {
            Some(Whole::Same) => {}
            Some(Whole::Differs(run)) => {
                let (told, rows) = told(run);
                add(&mut others, &[told]);
                others.extend(rows.iter().map(|row| format!("  {row}")));
            }
            Some(Whole::Outputs(names)) => add(&mut others, names),
            Some(Whole::NotDecided(reasons)) => add(&mut open, reasons),
            Some(Whole::Refuted) => add(&mut open, &[REFUTED.into()]),
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
        (true, true) if names.is_empty() => ("the same", Outcome::Fine, others),
        (true, true) => ("the same but for the names", Outcome::Findings, names),
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

/// Writes the run in which two programs differ as a scenario: what the old program does in it. It is of the new program, or of the old
/// one where only that is on the disk, and in its folder.
///
/// # Errors
/// There are runs of several programs, the file is elsewhere, or it cannot be written.
pub(super) fn write(file: &Path, compared: &[Compared<'_>]) -> Result<(), Failure> {
    let runs = compared.iter().filter_map(|of| match &of.comparison.whole {
        Some(Whole::Differs(run)) => Some((of, run)),
        _ => None,
    });
    let several = "--write takes the run of one program: name two files";
    let Some((of, run)) = of_one(&runs.collect::<Vec<_>>(), several)? else {
        return Ok(());
    };
    let names = [of.new, of.old].into_iter().flatten().map(Path::new);
    let mut here = names.filter(|name| name.is_file() && are_together(name, file));
    let Some(program) = here.next().and_then(Path::file_name) else {
        return Err(Failure::new(format!(
            "{}: the file for --write is in the folder of one of the programs, which it names",
            shown::path(file)
        )));
    };
    let Some(scenario) = scenario_of_difference("as the old program does it", run, Which::Old) else {
        terminal::note(&"no scenario shows that only one program ends: nothing is written");
        return Ok(());
    };
    let text = scenario_file(
        &program_line(&program.to_string_lossy()),
        run.interval,
        &[scenario],
    );
    ladder_workspace::write_made(file, text.as_bytes())?;
    Ok(())
}

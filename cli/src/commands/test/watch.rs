//! `ladder test --watch`: the same scenarios again whenever they, or their programs, change.

use super::{Arguments, Format, Round, run_files};
use crate::outcome::{Failure, Outcome};
use crate::seen::{Reads, Seen};
use crate::terminal;
use ladder_simulator::scenario;
use ladder_syntax::numeral::counted;
use ladder_workspace::Named;
use std::path::PathBuf;

/// Runs them, and runs them again, until nobody reads any more. Ctrl-C ends the process as it ends any other.
pub(super) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let paths = &arguments.paths;
    let mut programs = programs(paths);
    let mut seen = Seen::now(paths, Reads::Scenarios(&programs));
    loop {
        if arguments.format == Format::Full {
            terminal::clear();
        }
        match run_files(arguments) {
            Ok(Round {
                outcome,
                nobody_reads,
            }) => {
                if nobody_reads || seen.named == 0 {
                    return Ok(outcome);
                }
            }
            Err(failure) if seen.named == 0 => return Err(failure),
            // The next change may put it right.
            Err(failure) => terminal::error(&failure),
        }
        terminal::note(&format_args!(
            "watching {} of scenarios; Ctrl-C ends this",
            counted(seen.named, "file")
        ));
        seen = seen.next(paths, Reads::Scenarios(&programs));
        let named = self::programs(paths);
        if named != programs {
            programs = named;
            seen = Seen::now(paths, Reads::Scenarios(&programs));
        }
    }
}

/// The programs that the scenarios name.
fn programs(paths: &[PathBuf]) -> Vec<PathBuf> {
    let (files, _) = ladder_workspace::find_scenarios(paths);
    let named = files.iter().filter_map(|file| {
        let suite = scenario::parse(&ladder_workspace::read(file).ok()?);
        let (name, _) = suite.program?;
        Some(Named::in_file(file, &name).path())
    });
    named.collect()
}

//! `ladder check`: the mistakes in programs.

mod report;

use crate::findings::Source;
use crate::outcome::{Failure, Outcome};
use crate::terminal;
use clap::{Args, ValueEnum};
use report::Report;
use std::path::PathBuf;

const EXAMPLES: &str = "\
Examples:
  ladder check motor.clad                 one program
  ladder check .                          all programs in this folder
  ladder check --deny warnings .          a warning, too, makes the exit status 1
  ladder check --format json . > out.json

Exit status: 0 no errors, 1 errors (with --deny warnings: errors or warnings), 2 a file cannot be read.";

/// Look for mistakes in programs
///
/// Shows each mistake with the lines it is on, the places that have to do with it, and what to do.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// Programs, or folders to search for them
    #[arg(value_name = "PATH", required = true)]
    paths: Vec<PathBuf>,

    /// How the findings are written
    #[arg(long, value_enum, default_value_t = Format::Full)]
    format: Format,

    /// Treat findings of this severity as errors in the exit status
    #[arg(long, value_enum)]
    deny: Option<Deny>,
}

/// How the findings are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Format {
    /// For people: the lines, with the place marked
    Full,
    /// For machines: one array of objects
    Json,
}

/// What `--deny` takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Deny {
    /// Warnings count like errors
    Warnings,
}

pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let (files, errors) = ladder_workspace::find_programs(&arguments.paths);
    for error in &errors {
        terminal::error(error);
    }
    let mut outcome = if errors.is_empty() {
        Outcome::Fine
    } else {
        Outcome::Failed
    };
    let mut report = Report::new(arguments.format);
    for file in files {
        // One file that is bad does not keep the others from being checked.
        match ladder_workspace::read(&file) {
            Ok(text) => report.add(&Source::new(file.display().to_string(), text))?,
            Err(error) => {
                terminal::error(&error);
                outcome = Outcome::Failed;
            }
        }
    }
    let tally = report.finish()?;
    let denied = arguments.deny == Some(Deny::Warnings) && tally.warnings > 0;
    if tally.errors > 0 || denied {
        outcome = outcome.max(Outcome::Findings);
    }
    Ok(outcome)
}

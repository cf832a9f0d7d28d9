//! `ladder check`: the mistakes in programs.

mod mend;
mod report;
mod tally;

use super::test;
use crate::findings::{Problem, Source, Workspaces};
use crate::outcome::{Failure, Outcome};
use crate::terminal;
use annotate_snippets::Renderer;
use clap::{Args, ValueEnum};
use ladder_analysis::Diagnostic;
use ladder_workspace::FileError;
use rayon::prelude::*;
use report::Report;
use std::path::{Path, PathBuf};

const EXAMPLES: &str = "\
Examples:
  ladder check motor.clad                 one program
  ladder check .                          all programs in this folder
  ladder check --deny warnings .          a warning, too, makes the exit status 1
  ladder check --fix motor.clad           mend what can be mended in one way only
  ladder check --format sarif . > out.sarif

Exit status: 0 no errors, 1 errors (with --deny warnings: errors or warnings), 2 a file (or ladder.toml) cannot be read.";

/// Look for mistakes in programs
///
/// Shows each mistake with the lines it is on, the places that have to do with it, and what to do. Global tags,
/// functions and blocks of the other files in the workspace (the folder of the nearest ladder.toml, else the file's
/// own folder) are known, also when only one file is named.
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

    /// Mend what can be mended in one way only, keep the drawing aligned, and show what is left
    #[arg(long)]
    fix: bool,

    /// Show at the end how often each rule found something
    #[arg(long)]
    statistics: bool,
}

/// How the findings are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Format {
    /// For people: the lines, with the place marked
    Full,
    /// One line each, with file, line and column
    Concise,
    /// For machines: one array of objects
    Json,
    /// For code scanning services: SARIF 2.1.0
    Sarif,
    /// For GitHub Actions: commands that mark the lines of a change
    Github,
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
    let mut report = Report::new(arguments.format, arguments.statistics);
    let renderer = report.renderer().clone();
    let mut workspaces = Workspaces::default();
    for files in files.chunks(AT_ONCE) {
        let mut sources = Vec::with_capacity(files.len());
        for file in files {
            match source(file, &mut workspaces) {
                Ok(source) => sources.extend(source),
                // One file that is bad does not keep the others from being checked.
                Err(failure) => {
                    failure.show();
                    outcome = Outcome::Failed;
                }
            }
        }
        let sources = sources.into_par_iter();
        let checked: Vec<_> = sources
            .map(|source| check(source, arguments.fix, &renderer))
            .collect();
        for checked in checked {
            match checked {
                Ok(checked) => {
                    let problems = checked.problems.iter().map(|problem| problem.outcome);
                    outcome = problems.fold(outcome, Outcome::max);
                    report.add(&checked)?;
                }
                Err(error) => {
                    terminal::error(&error);
                    outcome = Outcome::Failed;
                }
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

/// So many files are checked at once: what is found in them is kept until their turn comes.
const AT_ONCE: usize = 64;

/// A program, or a file of scenarios, that was checked.
struct Checked {
    source: Source,
    findings: Vec<Diagnostic>,
    /// What is wrong in a file of scenarios.
    problems: Vec<Problem>,
    /// How many findings were mended.
    mended: usize,
}

fn check(source: Source, fix: bool, renderer: &Renderer) -> Result<Checked, FileError> {
    let path = Path::new(&source.file);
    if ladder_workspace::is_scenario(path) {
        return Ok(Checked {
            problems: test::mistakes(path, &source, renderer),
            source,
            findings: Vec::new(),
            mended: 0,
        });
    }
    if fix {
        return mend::mend(source);
    }
    let findings = source.analyze().diagnostics.clone();
    Ok(Checked {
        source,
        findings,
        problems: Vec::new(),
        mended: 0,
    })
}

/// A file among the others of its workspace. None: that cannot be used, and it has been said why.
fn source(file: &Path, workspaces: &mut Workspaces) -> Result<Option<Source>, Failure> {
    let text = ladder_workspace::read(file)?;
    if ladder_workspace::is_scenario(file) {
        return Ok(Some(Source::new(file.display().to_string(), text)));
    }
    let workspace = workspaces.of(file)?;
    Ok(workspace.map(|workspace| Source::within(workspace, file.display().to_string(), text)))
}

//! `ladder check`: the errors in programs.

mod fix;
mod report;
mod stdin;
mod tally;
mod watch;
#[cfg(feature = "run")]
mod wires;

use super::{render, test};
use crate::findings::{Problem, Source, Workspaces};
use crate::form::{self, Form};
use crate::outcome::{Failure, Outcome, unreadable};
use crate::terminal;
use annotate_snippets::Renderer;
use clap::{Args, ValueEnum};
use fix::Fixed;
use ladder_analysis::{Applicability, Diagnostic};
use ladder_workspace::{FileError, is_scene};
use rayon::prelude::*;
use report::{Report, Target};
use std::path::{Path, PathBuf};
use tally::Tally;

const EXAMPLES: &str = "\
Examples:
  ladder check motor.clad             one program
  ladder check .                      all programs in this folder
  ladder check --deny warnings .      a warning, too, makes the exit status 1
  ladder check --watch .              again and again, whenever a file changes
  ladder check --fix motor.clad       fix what can be fixed safely
  ladder check --fix --diff .         only show what would be fixed
  ladder check --format sarif . > out.sarif
  ladder check plant.ld               a program of another system
  ladder check --stdin-filename motor.clad - < draft
                                      a text that is not saved yet

Exit status: 0 no errors, 1 errors (with --deny warnings: errors or warnings), 2 a file (or ladder.toml) cannot be read.";

/// Look for errors in programs
///
/// Shows each error with the lines it is on, the places that have to do with it, and what to do. Global tags,
/// functions and blocks of the other files in the workspace (the folder of the nearest ladder.toml, else the file's
/// own folder) are known, also when only one file is named.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// Programs, or folders to search for them (without any: this folder); `-` reads a text from stdin
    #[arg(value_name = "PATH", default_value = ".", hide_default_value = true)]
    paths: Vec<PathBuf>,

    /// How the findings are written
    #[arg(long, value_enum, default_value_t = Format::Full)]
    format: Format,

    /// Treat findings of this severity as errors in the exit status
    #[arg(long, value_enum)]
    deny: Option<Deny>,

    /// Fix what can be fixed safely, keep the drawing aligned, and show what is left
    ///
    /// With `-` the fixed text goes to stdout, and what is left to stderr.
    #[arg(long)]
    fix: bool,

    /// With --fix: make the fixes that are guesses as well; look at what they did
    #[arg(long, requires = "fix")]
    unsafe_fixes: bool,

    /// With --fix: write nothing; show what would change, and exit with 1 if anything does
    #[arg(long, requires = "fix")]
    diff: bool,

    /// Show at the end how often each rule found something
    #[arg(long)]
    statistics: bool,

    /// Check again whenever a program or ladder.toml changes, until Ctrl-C
    #[arg(long, conflicts_with = "fix")]
    watch: bool,

    /// The file that the text from stdin stands for; it need not exist
    ///
    /// Messages have its name, its ladder.toml holds, and the other programs of its workspace are known. Without it the
    /// text is alone, under the settings of the current folder.
    #[arg(long, value_name = "PATH")]
    stdin_filename: Option<PathBuf>,

    /// The notation of the programs, as for `ladder convert`; without it their content decides. Findings have their places in
    /// the file that is named
    #[arg(long, value_name = "NOTATION", value_parser = form::names(), hide_possible_values = true)]
    from: Option<String>,

    /// Pass over what ladder.toml or an ignore file excludes, even if it is named (for hooks and editors)
    #[arg(long)]
    force_exclude: bool,
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

impl Arguments {
    /// What the programs are written in, if that is given.
    fn form(&self) -> Option<Form> {
        self.from.as_deref().map(form::named)
    }

    /// What is fixed, if anything is.
    fn task(&self) -> Option<fix::Task> {
        self.fix.then_some(fix::Task {
            most: if self.unsafe_fixes {
                Applicability::Unsafe
            } else {
                Applicability::Safe
            },
            writes: !self.diff,
        })
    }
}

pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    if arguments.diff && !matches!(arguments.format, Format::Full | Format::Concise) {
        return Err(Failure::new(
            "--diff shows a unified diff for people: leave --format out, or name full or concise",
        ));
    }
    let from_stdin = crate::stdin::is_meant(&arguments.paths, arguments.stdin_filename.as_deref())?;
    match (from_stdin, arguments.watch) {
        (true, true) => Err(Failure::new(
            "`-` (stdin) cannot be watched; name a file or folder",
        )),
        (true, false) => stdin::run(arguments),
        (false, true) => watch::run(arguments),
        (false, false) => {
            let round = check_files(arguments)?;
            // The process ends: the system takes the memory back in one piece, and much faster.
            std::mem::forget(round.workspaces);
            Ok(round.outcome)
        }
    }
}

/// What came of a check of the files.
struct Round {
    outcome: Outcome,
    nobody_reads: bool,
    /// All that is known of the programs.
    workspaces: Workspaces,
}

/// Checks the files once.
fn check_files(arguments: &Arguments) -> Result<Round, Failure> {
    let (mut files, errors) = ladder_workspace::find_programs(&arguments.paths);
    if arguments.force_exclude {
        files.retain(|file| !ladder_workspace::is_excluded(file));
    }
    let mut outcome = unreadable(&errors);
    let mut report = Report::new(arguments.format, arguments.statistics, Target::Stdout);
    let renderer = report.renderer().clone();
    let mut workspaces = Workspaces::default();
    for files in files.chunks(AT_ONCE) {
        let mut sources = Vec::with_capacity(files.len());
        for file in files {
            match source(file, arguments, &mut workspaces) {
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
            .map(|source| check_file(source, arguments.task(), &renderer))
            .collect();
        for checked in checked {
            match checked {
                Ok(checked) => {
                    outcome = outcome.max(checked.outcome());
                    report.add(&checked)?;
                }
                Err(error) => {
                    terminal::error(&error);
                    outcome = Outcome::Failed;
                }
            }
        }
    }
    #[cfg(feature = "run")]
    if !arguments.diff {
        for (folder, workspace) in workspaces.loaded() {
            let wrong = wires::problems(&folder, workspace.settings(), &mut workspaces, &renderer);
            report.problems(&wrong)?;
        }
    }
    let (tally, nobody_reads) = report.finish()?;
    Ok(Round {
        outcome: outcome.max(exit_of(&tally, arguments)),
        nobody_reads,
        workspaces,
    })
}

/// What all that was found means for the exit status.
fn exit_of(tally: &Tally, arguments: &Arguments) -> Outcome {
    let would_change = arguments.diff && tally.fixed > 0;
    let denied = arguments.deny == Some(Deny::Warnings) && tally.warnings > 0;
    if tally.errors > 0 || denied || would_change {
        Outcome::Findings
    } else {
        Outcome::Fine
    }
}

/// This many files are checked at once: what is found in them is kept until their turn comes.
const AT_ONCE: usize = 64;

/// A program, a file of scenarios, or a scene, that was checked.
struct Checked {
    source: Source,
    findings: Vec<Diagnostic>,
    /// What is wrong in a file of scenarios, or a scene.
    problems: Vec<Problem>,
    /// What was fixed.
    fixed: Fixed,
}

impl Checked {
    /// What its problems mean for the exit status.
    fn outcome(&self) -> Outcome {
        let problems = self.problems.iter().map(|problem| problem.outcome);
        problems.fold(Outcome::Fine, Outcome::max)
    }
}

/// Checks a file. It is written once, at the end, and only if something was fixed.
fn check_file(source: Source, task: Option<fix::Task>, renderer: &Renderer) -> Result<Checked, FileError> {
    let checked = check(source, task, renderer);
    if !checked.fixed.fixes.is_empty() && checked.fixed.before.is_none() {
        ladder_workspace::write(Path::new(&checked.source.file), checked.source.text.as_bytes())?;
    }
    Ok(checked)
}

fn check(source: Source, task: Option<fix::Task>, renderer: &Renderer) -> Checked {
    let path = Path::new(&source.file);
    if ladder_workspace::is_scenario(path) {
        return Checked {
            problems: test::errors(path, &source, renderer),
            source,
            findings: Vec::new(),
            fixed: Fixed::default(),
        };
    }
    if is_scene(path) {
        return Checked {
            problems: render::scene::problems(path, &source, renderer),
            source,
            findings: Vec::new(),
            fixed: Fixed::default(),
        };
    }
    if let Some(task) = task {
        return fix::fix(source, task);
    }
    let remarks = source.remarks().into_iter();
    Checked {
        problems: remarks
            .map(|remark| Problem::remark(&source, remark, renderer))
            .collect(),
        findings: source.findings(),
        source,
        fixed: Fixed::default(),
    }
}

/// A file among the others of its workspace. None: that cannot be used, and it has been reported why.
fn source(
    file: &Path,
    arguments: &Arguments,
    workspaces: &mut Workspaces,
) -> Result<Option<Source>, Failure> {
    let bytes = ladder_workspace::read_bytes(file)?;
    if ladder_workspace::is_scenario(file) || is_scene(file) {
        return Ok(Some(Source::of_bytes(file, bytes, Some(Form::Ladder))?));
    }
    let source = Source::of_bytes(file, bytes, arguments.form())?;
    may_be_fixed(&source, arguments)?;
    let workspace = workspaces.of(file)?;
    Ok(workspace.map(|workspace| source.within(workspace)))
}

/// Refuses to fix what is not ladder text: its fixes are about a text that is nowhere.
fn may_be_fixed(source: &Source, arguments: &Arguments) -> Result<(), Failure> {
    match source.foreign() {
        Some(foreign) if arguments.fix => Err(Failure::new(format!(
            "{}: --fix fixes only ladder text, and this file is in the notation `{}`; `ladder convert {0} -o FILE.clad` \
             writes it as ladder text",
            source.file,
            foreign.notation()
        ))),
        _ => Ok(()),
    }
}

//! `ladder fmt` and `ldfmt`: the canonical layout.

mod files;
mod layout;
mod selection;

use crate::diff;
use crate::outcome::{Failure, Outcome};
use crate::stdin;
use crate::terminal::{self, Stdout};
use clap::Args;
use ladder_workspace::{Settings, shown};
use selection::Selection;
use std::io::Write;
use std::path::{Path, PathBuf};

const EXAMPLES: &str = "\
Examples:
  ldfmt motor.clad                  rewrite one file
  ldfmt .                           rewrite all programs in this folder
  ldfmt --check .                   only say what would change
  ldfmt --diff motor.clad           show what would change
  ldfmt motor.ladder-test           align the columns of scenarios
  ldfmt - < motor.clad              from stdin to stdout
  ldfmt --range 12-20 motor.clad    only the networks on lines 12 to 20
  ldfmt --force-exclude FILE...     in a hook: what is excluded stays as it is

Exit status: 0 fine, 1 a file would change (--check, --diff), 2 a file cannot be read or written, or ladder.toml is wrong.";

/// Align ladder diagrams
///
/// Brings programs into the one canonical layout, in place. Only white space, the length of wires, decoration
/// and the case of keywords change: the program does what it did before. A network that cannot be read stays as
/// it is, the others are aligned. The width and the spacing can be set in ladder.toml. A file of scenarios
/// (.ladder-test) that is named gets its columns aligned; folders are searched for programs only.
///
/// `ladder fmt` and `ldfmt` are the same formatter.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// Programs and scenarios, or folders to search for programs (without any: this folder); `-` reads stdin and writes stdout
    #[arg(value_name = "PATH", default_value = ".", hide_default_value = true)]
    paths: Vec<PathBuf>,

    /// Write nothing; exit with 1 if a file would change, and name it
    #[arg(long)]
    check: bool,

    /// Write nothing; show what would change, and exit with 1 if anything does
    #[arg(long)]
    diff: bool,

    /// The name that stdin goes by in messages; the file need not exist
    #[arg(long, value_name = "PATH", visible_alias = "stdin-filepath")]
    stdin_filename: Option<PathBuf>,

    /// Take the settings from this file, not from the ladder.toml above each program
    #[arg(long, value_name = "FILE")]
    config: Option<PathBuf>,

    /// Pass over what ladder.toml or an ignore file excludes, even if it is named (for hooks and editors)
    #[arg(long)]
    force_exclude: bool,

    /// Align only the networks that lines (and columns) touch, counted from 1
    #[arg(long, value_name = "L[:C]-L[:C]")]
    range: Option<Selection>,
}

/// What to do with a text that is not in the canonical layout.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Task {
    Rewrite,
    Report,
    ShowDifference,
}

impl Arguments {
    fn task(&self) -> Task {
        if self.diff {
            Task::ShowDifference
        } else if self.check {
            Task::Report
        } else {
            Task::Rewrite
        }
    }

    /// The settings that hold for all files, if some were given.
    fn config(&self) -> Result<Option<Settings>, Failure> {
        Ok(self.config.as_deref().map(Settings::read).transpose()?)
    }
}

pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    if stdin::is_meant(&arguments.paths, arguments.stdin_filename.as_deref())? {
        return format_stdin(arguments);
    }
    files::format(arguments)
}

fn format_stdin(arguments: &Arguments) -> Result<Outcome, Failure> {
    let name = stdin::name_or_default(arguments.stdin_filename.as_deref());
    let text = stdin::read(name)?;
    let settings = match arguments.config()? {
        Some(config) => config,
        None => Settings::of(name)?,
    };
    let excluded = arguments.force_exclude
        && arguments.stdin_filename.is_some()
        && (ladder_workspace::is_excluded(name)
            || std::path::absolute(name).is_ok_and(|name| !settings.files.contain(&name)));
    let formatted = if excluded {
        None
    } else {
        layout::formatted(name, &text, &settings.format, arguments.range)?
    };
    let mut out = Stdout::new();
    let outcome = match (arguments.task(), &formatted) {
        (Task::Rewrite, _) => {
            out.write_all(formatted.as_ref().unwrap_or(&text).as_bytes())?;
            Outcome::Fine
        }
        (_, None) => Outcome::Fine,
        (Task::Report, Some(_)) => {
            would_change(name);
            Outcome::Findings
        }
        (Task::ShowDifference, Some(formatted)) => {
            diff::print(name, &text, formatted, &mut out)?;
            Outcome::Findings
        }
    };
    out.flush()?;
    Ok(outcome)
}

fn would_change(file: &Path) {
    terminal::note(&format_args!("would change: {}", shown::path(file)));
}

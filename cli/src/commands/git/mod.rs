//! `ladder git`: git shows and merges programs by network.

mod attributes;
mod plan;

use crate::findings::Source;
use crate::form::{self, Form};
use crate::outcome::{Failure, Outcome};
use crate::terminal::{self, Stdout, is_interactive};
use clap::{Args, Subcommand};
use ladder_workspace::shown;
use plan::{Plan, Scope, Task};
use std::io::{BufRead, Write};
use std::path::{Path, PathBuf};

const EXAMPLES: &str = "\
Examples:
  ladder git install             for this repository, after a question
  ladder git install --global    for all repositories of this user
  ladder git install --yes       without a question
  ladder git uninstall           take it back

  git difftool -t ladder         what changed, network by network
  git merge feature              merges programs by network

Exit status: 0 done, 1 nothing was written, for nobody said yes, 2 it could not be done.";

/// Let git show and merge programs by network
///
/// `install` sets up git: titles and words for `git diff`, programs of other systems as ladder text in it, `git difftool -t
/// ladder`, and `ladder merge` for merges. It shows what it would write, and asks.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Set up git for programs
    Install(Where),
    /// Take back what `install` has set up
    Uninstall(Where),
    /// Print a file as ladder text, for `git diff`; what is not a program as it is
    Show {
        /// The file
        file: PathBuf,
    },
}

#[derive(Debug, Args)]
struct Where {
    /// For all repositories of this user, not for this one alone
    #[arg(long)]
    global: bool,

    /// Write without a question
    #[arg(short, long)]
    yes: bool,
}

pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    match &arguments.command {
        Command::Install(wanted) => set_up(Task::Install, wanted),
        Command::Uninstall(wanted) => set_up(Task::Uninstall, wanted),
        Command::Show { file } => show(file),
    }
}

fn set_up(task: Task, wanted: &Where) -> Result<Outcome, Failure> {
    let scope = if wanted.global {
        Scope::Global
    } else {
        Scope::Repository
    };
    let plan = Plan::new(task, scope)?;
    let mut out = Stdout::new();
    if plan.is_done() {
        writeln!(
            out,
            "{}",
            match task {
                Task::Install => "git is set up already",
                Task::Uninstall => "nothing of it is set up",
            }
        )?;
        out.flush()?;
        return Ok(Outcome::Fine);
    }
    for line in plan.lines() {
        writeln!(out, "{}", shown::line(&line))?;
    }
    out.flush()?;
    if !wanted.yes && !is_interactive() {
        terminal::note(&"nothing is written; `--yes` writes it");
        return Ok(Outcome::Findings);
    }
    if !wanted.yes && !agrees(&mut out)? {
        return Ok(Outcome::Findings);
    }
    plan.write()?;
    Ok(Outcome::Fine)
}

/// Asks the person.
fn agrees(out: &mut Stdout) -> Result<bool, Failure> {
    write!(out, "\nWrite this? [y/N] ")?;
    out.flush()?;
    let mut answer = String::new();
    std::io::stdin().lock().read_line(&mut answer)?;
    Ok(matches!(answer.trim().to_lowercase().as_str(), "y" | "yes"))
}

/// A file as git is to compare it. It does not fail on what is not a program: git would show no difference at all then.
fn show(file: &Path) -> Result<Outcome, Failure> {
    let bytes = ladder_workspace::read_bytes(file)?;
    let mut out = Stdout::new();
    match form::of_program(file, &bytes) {
        Ok(Form::Foreign(notation)) => {
            match Source::of_bytes(file, bytes.clone(), Some(Form::Foreign(notation))) {
                Ok(source) => out.write_all(source.text.as_bytes())?,
                Err(_) => out.write_all(&bytes)?,
            }
        }
        Ok(Form::Ladder) | Err(_) => out.write_all(&bytes)?,
    }
    out.flush()?;
    Ok(Outcome::Fine)
}

//! `ladder prove`: whether the properties of programs hold for all inputs and all runs.

mod file;
mod interrupt;
mod json;
mod junit;
mod people;

use crate::findings::Workspaces;
use crate::found_runs::{are_together, of_one};
use crate::outcome::{Failure, Outcome, unreadable};
use crate::output::{Existing, may_write};
use crate::terminal::{self, Stdout, stdout_has_colours};
use annotate_snippets::Renderer;
use clap::{Args, ValueEnum};
use file::{FileAnswers, Wishes};
use ladder_syntax::numeral::counted;
use ladder_workspace::shown;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::time::{Duration, Instant};

const EXAMPLES: &str = "\
Examples:
  ladder prove door.ladder-test                 the properties in this file
  ladder prove .                                those of all files in this folder
  ladder prove . --time 60                      search longer for what is hard to decide
  ladder prove door.ladder-test --write found.ladder-test
                                                the runs that were found, as scenarios
  ladder prove . --format junit > report.xml    for a build server

Ctrl-C shows the answers that are there; a second one ends at once.

Properties are in a file of scenarios, before, between or after these:

  program door.clad
  interval 100ms

  assume not (is_open and is_closed)

  property \"the contactors exclude each other\"
  never up and down

  property \"the lamp follows the door\"
  within 500ms of rises(up): warning or not up

The forms are: always e, never e, when a: b, when a: b until c, after a: b, within 1s of a: b, possible e, no faults.
Expressions are those of [CALC], with rises(e), falls(e) and was(e).

Exit status: 0 all is proved or possible, 1 a property is violated, impossible or not decided, 2 a file cannot be
read, or the prover went wrong.";

/// Prove the properties of programs, or find runs that violate them
///
/// Each property is decided for all inputs and all runs from a cold start. A run that violates it is played in the
/// simulator before it is shown.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// Scenario files, or folders to search for them
    #[arg(value_name = "PATH", required = true)]
    paths: Vec<PathBuf>,

    /// How many seconds the properties of a file may take
    #[arg(long, value_name = "SECONDS", default_value_t = 20.0)]
    time: f64,

    /// How the answers are written
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,

    /// Write the runs that were found to this file, as scenarios
    #[arg(long, value_name = "FILE")]
    write: Option<PathBuf>,

    /// Replace the file for --write if it is there
    #[arg(long, requires = "write")]
    force: bool,

    /// End with exit status 0 also if a property could not be decided
    #[arg(long)]
    allow_unknown: bool,
}

/// How the answers are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Format {
    /// For people
    Text,
    /// For machines: one object
    Json,
    /// For build servers: XML as of JUnit
    Junit,
}

pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let began = Instant::now();
    if !arguments.time.is_finite() || !(0.0..=1e6).contains(&arguments.time) {
        return Err(Failure::new("--time takes a number of seconds, such as 60"));
    }
    if let Some(program) = (arguments.paths.iter()).find(|path| ladder_workspace::is_program(path)) {
        return Err(Failure::new(format!(
            "{}: this is a program; name the file with its properties, for example {}",
            shown::path(program),
            shown::path(&program.with_extension(ladder_workspace::SCENARIO_EXTENSION))
        )));
    }
    let (files, errors) = ladder_workspace::find_scenarios(&arguments.paths);
    let mut outcome = unreadable(&errors);
    if let Some(file) = &arguments.write {
        if file == Path::new("-") {
            return Err(Failure::new("--write needs a file: stdout has the answers"));
        }
        may_write(file, Existing::by(arguments.force))?;
    }
    let colours = arguments.format == Format::Text && stdout_has_colours();
    let shows_progress = arguments.format == Format::Text && terminal::is_interactive();
    let wishes = Wishes {
        time: Duration::from_secs_f64(arguments.time),
        renderer: if colours {
            Renderer::styled()
        } else {
            Renderer::plain()
        },
        workspaces: Mutex::<Workspaces>::default(),
        cancel: interrupt::watched(),
        shows_progress,
    };
    let mut out = Stdout::new();
    let mut all: Vec<FileAnswers> = Vec::new();
    for (number, path) in files.iter().enumerate() {
        if wishes.cancel.is_cancelled() {
            let left = counted(files.len() - number, "file");
            terminal::warning(&format!("stopped: {left} without answers"));
            outcome = outcome.max(Outcome::Findings);
            break;
        }
        let title = format!("{} ({} of {})", shown::path(path), number + 1, files.len());
        if shows_progress {
            terminal::passing(&title);
        }
        let answers = file::answers(path, &title, &wishes);
        if shows_progress {
            terminal::passing("");
        }
        if answers.properties.is_empty() && answers.problems.is_empty() {
            continue;
        }
        outcome = outcome.max(answers.outcome(arguments.allow_unknown));
        if arguments.format == Format::Text {
            people::file(&answers, colours, &mut out)?;
            if shows_progress {
                out.flush()?;
            }
        }
        all.push(answers);
    }
    if all.is_empty() && errors.is_empty() && !wishes.cancel.is_cancelled() {
        return Err(Failure::new(
            "there is no property in these files; write one, as in: never up and down",
        ));
    }
    let seconds = began.elapsed().as_secs_f64();
    match arguments.format {
        Format::Text if all.is_empty() => {}
        Format::Text => people::end(&all, seconds, colours, &mut out)?,
        Format::Json => json::write(&all, seconds, &mut out)?,
        Format::Junit => junit::write(&all, arguments.allow_unknown, seconds, &mut out)?,
    }
    out.flush()?;
    if let Some(file) = &arguments.write {
        write_runs(file, &all)?;
    }
    Ok(outcome)
}

/// Writes the runs that were found. They are of one program, which is in the folder of the file.
fn write_runs(file: &Path, all: &[FileAnswers]) -> Result<(), Failure> {
    let with_runs: Vec<&FileAnswers> = all
        .iter()
        .filter(|answers| !answers.scenarios().is_empty())
        .collect();
    let several = "--write takes the runs of one program: name one file of scenarios";
    let Some(answers) = of_one(&with_runs, several)? else {
        return Ok(());
    };
    if !are_together(file, Path::new(&answers.file)) {
        return Err(Failure::new(format!(
            "{}: the file for --write is in the folder of {}, which names its program",
            shown::path(file),
            shown::line(&answers.file)
        )));
    }
    let text = ladder_prover::scenario_file(&answers.head, answers.interval, &answers.scenarios());
    ladder_workspace::write_made(file, text.as_bytes())?;
    Ok(())
}

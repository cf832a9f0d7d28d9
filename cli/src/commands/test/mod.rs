//! `ladder test`: runs the scenarios of programs.

mod coverage;
mod github;
mod json;
mod junit;
mod lcov;
mod mutation;
mod people;
mod pictures;
mod report;
mod suite;
mod watch;

use crate::findings::{Problem, Source};
use crate::outcome::{Failure, Outcome, unreadable};
use crate::output::{Existing, may_write};
use crate::terminal::{self, Stdout, stdout_has_colours};
use annotate_snippets::Renderer;
use clap::{Args, ValueEnum};
use coverage::Covered;
use ladder_workspace::shown;
use mutation::{Asked, Mutated, Target};
use pictures::Pictures;
use report::{FileReport, Tally};
use std::collections::BTreeMap;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, mpsc};
use std::time::{Duration, Instant};
use suite::Wishes;

const EXAMPLES: &str = "\
Examples:
  ladder test .                                all scenarios in this folder
  ladder test motor.ladder-test --filter stop  those with \"stop\" in their name
  ladder test . --format junit > report.xml    for a build server
  ladder test . --coverage                     and what was never exercised
  ladder test . --pictures failed              and the machine where it failed
  ladder test . --watch                        again whenever a file changes
  ladder test motor.ladder-test --mutate       how much the scenarios notice
  ladder test motor.clad --generate            add scenarios for the rest

A file of scenarios, motor.ladder-test, says what goes into a program and what must come out of it:

  program motor.clad
  step 100ms

  scenario \"the seal-in holds after start is let go\"
  start   _-_______
  stop    ______-__
  run  => _-----___

One column is one step: _ is low, - is high, . is as before (after => it is not checked). Numbers are with
blanks between them.

With --mutate one thing after the other is changed in the program: a contact is inverted or bridged, an edge
turned, a coil inverted, a comparison shifted, a timer of another kind. A change that no scenario notices is shown
with a run that would notice it, unless it is proved that the program does the same.

Exit status: 0 all is as expected, 1 a scenario failed, or a scenario file or its program has errors, or a
change is not noticed (with --min-score: too many are not), 2 a file cannot be read, or no scenario has the name
asked for.";

/// Run the scenarios of programs
///
/// Searches folders for files that end in .ladder-test. Each scenario starts cold. A scenario that fails is shown
/// as two diagrams, what was expected and what came, with the columns marked that differ.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// Scenario files, or folders to search for them (without any: this folder)
    #[arg(value_name = "PATH", default_value = ".", hide_default_value = true)]
    paths: Vec<PathBuf>,

    /// Run only the scenarios whose name contains this, in any case
    #[arg(long, value_name = "TEXT")]
    filter: Option<String>,

    /// How the results are written
    #[arg(long, value_enum, default_value_t = Format::Full)]
    format: Format,

    /// Show which networks, contacts and coils were exercised
    #[arg(long)]
    coverage: bool,

    /// Write what was exercised to this file, in the form of LCOV
    #[arg(long, value_name = "FILE")]
    coverage_output: Option<PathBuf>,

    /// Draw the scenes of a program (NAME.scene.svg next to it) as they are in the step that fails, into this folder
    #[arg(long, value_name = "FOLDER")]
    pictures: Option<PathBuf>,

    /// Replace the file for --coverage-output or --output even if this command did not make it
    #[arg(long)]
    force: bool,

    /// Change one thing after the other in the programs, and show which changes no scenario notices
    ///
    /// A PATH may then be a program too.
    #[arg(long, conflicts_with = "watch")]
    mutate: bool,

    /// Write scenarios that notice what no scenario does, as the program is today; includes --mutate
    ///
    /// They are added to the program's first scenario file, or to a new one next to it. Check what they expect.
    #[arg(long, conflicts_with = "watch")]
    generate: bool,

    /// Write the scenarios of --generate to this file
    #[arg(long, short, value_name = "FILE", requires = "generate")]
    output: Option<PathBuf>,

    /// How many seconds --mutate may take
    #[arg(long, value_name = "SECONDS", default_value_t = 120.0)]
    time: f64,

    /// With --mutate, end with exit status 1 only if a program has a lower score, in percent
    #[arg(long, value_name = "PERCENT", value_parser = clap::value_parser!(u8).range(0..=100))]
    min_score: Option<u8>,

    /// Run again whenever scenarios, a program or ladder.toml change, until Ctrl-C
    #[arg(long)]
    watch: bool,
}

/// How the results are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Format {
    /// For people
    Full,
    /// For build servers: XML in the form of JUnit
    Junit,
    /// For machines: one object
    Json,
    /// For GitHub: annotations at the lines
    Github,
}

/// A way to write results. They come file by file, in the order of the search.
trait Writer {
    fn file(&mut self, report: &FileReport, out: &mut dyn Write) -> io::Result<()>;
    /// All files are done.
    fn end(&mut self, all: &All, out: &mut dyn Write) -> io::Result<()>;
}

/// What is at the end.
struct All<'c> {
    tally: Tally,
    seconds: f64,
    covered: Option<&'c Covered>,
    /// What came of changes to the programs, if they were asked for.
    mutated: Option<&'c [Mutated]>,
}

/// What came of running all files once.
struct Round {
    outcome: Outcome,
    /// The output is closed.
    nobody_reads: bool,
}

pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    if arguments.watch {
        watch::run(arguments)
    } else {
        run_files(arguments).map(|round| round.outcome)
    }
}

/// Runs all files once.
fn run_files(arguments: &Arguments) -> Result<Round, Failure> {
    let began = Instant::now();
    let Paths { paths, programs } = Paths::of(arguments)?;
    if arguments.coverage_output.as_deref() == Some(Path::new("-")) {
        return Err(Failure::new(
            "--coverage-output needs a file: stdout has the results",
        ));
    }
    let (files, errors) = ladder_workspace::find_scenarios(&paths);
    let mut outcome = unreadable(&errors);
    if let Some(file) = &arguments.output {
        may_write(file, Existing::by(arguments.force))?;
    }
    if let Some(file) = &arguments.coverage_output {
        may_write(file, Existing::by(arguments.force))?;
    }
    let for_people = arguments.format == Format::Full;
    let colours = for_people && stdout_has_colours();
    let wishes = Wishes {
        filter: arguments.filter.as_ref().map(|filter| filter.to_lowercase()),
        coverage: arguments.coverage || arguments.coverage_output.is_some(),
        pictures: arguments.pictures.clone().map(|folder| Pictures {
            folder,
            existing: Existing::by(arguments.force),
        }),
        width: terminal::width().saturating_sub(people::INDENT.len()),
        renderer: if colours {
            Renderer::styled()
        } else {
            Renderer::plain()
        },
        workspaces: Mutex::default(),
    };
    let mut writer: Box<dyn Writer> = match arguments.format {
        Format::Full => Box::new(people::People::new(colours, arguments.coverage)),
        Format::Junit => Box::new(junit::Junit::default()),
        Format::Json => Box::new(json::Json::default()),
        Format::Github => Box::new(github::Github),
    };
    let mut covered = Covered::default();
    let mut tally = Tally::default();
    let mut out = Stdout::new();
    in_order(&files, &wishes, |report| {
        outcome = outcome.max(report.outcome());
        tally.count(&report);
        covered.add(&report);
        writer.file(&report, &mut out)
    })?;
    if let Some(filter) = &arguments.filter
        && tally.scenarios() == 0
        && tally.files > tally.broken
    {
        return Err(Failure::new(format!("no scenario has `{filter}` in its name")));
    }
    let seconds = began.elapsed().as_secs_f64();
    let mutated = if arguments.mutate || arguments.generate {
        Some(mutate(arguments, (&files, &programs), &wishes, &mut outcome)?)
    } else {
        None
    };
    for mutated in mutated.iter().flatten() {
        mutated.note_in(&mut covered);
    }
    if tally.files > 0 || mutated.as_ref().is_some_and(|mutated| !mutated.is_empty()) {
        let all = All {
            tally,
            seconds,
            covered: wishes.coverage.then_some(&covered),
            mutated: mutated.as_deref(),
        };
        writer.end(&all, &mut out)?;
    }
    out.flush()?;
    if arguments.generate {
        let target = match &arguments.output {
            Some(file) => Target::File(file.clone(), Existing::by(arguments.force)),
            None => Target::InPlace,
        };
        for done in mutation::generate(mutated.as_deref().unwrap_or_default(), &target)? {
            terminal::note(&done);
        }
    }
    if let Some(file) = &arguments.coverage_output {
        ladder_workspace::write_made(file, lcov::text(&covered).as_bytes())?;
    }
    Ok(Round {
        outcome,
        nobody_reads: out.is_closed(),
    })
}

/// What is named.
struct Paths {
    /// Scenario files, and folders.
    paths: Vec<PathBuf>,
    /// Programs without scenarios.
    programs: Vec<PathBuf>,
}

impl Paths {
    fn of(arguments: &Arguments) -> Result<Paths, Failure> {
        let mut all = Paths {
            paths: Vec::new(),
            programs: Vec::new(),
        };
        for path in &arguments.paths {
            if !ladder_workspace::is_program(path) {
                all.paths.push(path.clone());
                continue;
            }
            let scenarios = path.with_extension(ladder_workspace::SCENARIO_EXTENSION);
            if !(arguments.mutate || arguments.generate) {
                return Err(Failure::new(format!(
                    "{}: this is a program; name the file with its scenarios, for example {}",
                    shown::path(path),
                    shown::path(&scenarios)
                )));
            }
            if scenarios.exists() {
                all.paths.push(scenarios);
            } else {
                all.programs.push(path.clone());
            }
        }
        Ok(all)
    }
}

/// Changes the programs, and adds to the outcome whether that was noticed.
fn mutate(
    arguments: &Arguments,
    (files, programs): (&[PathBuf], &[PathBuf]),
    wishes: &Wishes,
    outcome: &mut Outcome,
) -> Result<Vec<Mutated>, Failure> {
    if !arguments.time.is_finite() || !(0.0..=1e6).contains(&arguments.time) {
        return Err(Failure::new("--time takes a number of seconds, such as 60"));
    }
    let asked = Asked {
        files,
        programs,
        time: Duration::from_secs_f64(arguments.time),
    };
    let mutated = mutation::mutate(&asked, wishes).unwrap_or_else(|problems| {
        for problem in &problems {
            terminal::plain(&format_args!("{}\n", problem.shown));
            *outcome = (*outcome).max(problem.outcome);
        }
        Vec::new()
    });
    let is_enough = |mutated: &Mutated| match (mutated.score().percent(), arguments.min_score) {
        (None, _) => true,
        (Some(percent), Some(least)) => percent >= usize::from(least),
        (Some(percent), None) => percent == 100,
    };
    if !mutated.iter().all(is_enough) {
        *outcome = (*outcome).max(Outcome::Findings);
    }
    Ok(mutated)
}

/// Runs the files on all processors, and returns their reports in the order of the files, each as soon as it can be.
fn in_order(
    files: &[PathBuf],
    wishes: &Wishes,
    mut take: impl FnMut(FileReport) -> io::Result<()>,
) -> io::Result<()> {
    let threads = std::thread::available_parallelism()
        .map_or(1, usize::from)
        .min(files.len());
    let next = AtomicUsize::new(0);
    let (send, receive) = mpsc::channel();
    std::thread::scope(|scope| {
        for _ in 0..threads {
            let (send, next) = (send.clone(), &next);
            scope.spawn(move || {
                while let Some((index, file)) = Some(next.fetch_add(1, Ordering::Relaxed))
                    .and_then(|index| Some((index, files.get(index)?)))
                {
                    // Nobody takes the rest if the output is broken.
                    if send.send((index, suite::run(file, wishes))).is_err() {
                        return;
                    }
                }
            });
        }
        drop(send);
        let mut early = BTreeMap::new();
        let mut wanted = 0;
        for (index, report) in receive {
            early.insert(index, report);
            while let Some(report) = early.remove(&wanted) {
                take(report)?;
                wanted += 1;
            }
        }
        Ok(())
    })
}

/// The errors of a scenario file, and those of its program.
pub(crate) fn errors(path: &Path, source: &Source, renderer: &Renderer) -> Vec<Problem> {
    suite::check(path, source, renderer)
}

//! One file of scenarios: its properties are decided.

use crate::findings::{FileRange, Problem, Source, Workspaces};
use crate::outcome::Outcome;
use crate::ready::{Ready, place_of};
use crate::run::unread;
use crate::terminal;
use annotate_snippets::Renderer;
use ladder_analysis::Cancel;
use ladder_prover::{Answer, Basis, Listener, Options, Progress, Verdict, found_scenario, prove};
use ladder_simulator::scenario;
use std::cell::Cell;
use std::path::Path;
use std::sync::Mutex;
use std::time::{Duration, Instant};

/// From one text about how far it is to the next.
const BETWEEN: Duration = Duration::from_millis(200);

/// What is asked of each file.
pub(super) struct Wishes {
    pub(super) time: Duration,
    /// A person sees how far the search is.
    pub(super) shows_progress: bool,
    /// Cancelled where the answers that are there are wanted at once.
    pub(super) cancel: Cancel,
    pub(super) renderer: Renderer,
    /// Those of the programs.
    pub(super) workspaces: Mutex<Workspaces>,
}

/// What came of a file.
pub(super) struct FileAnswers {
    /// As it was named.
    pub(super) file: String,
    /// The program as the file names it.
    pub(super) program: String,
    /// The lines about it and what runs beside it.
    pub(super) head: String,
    /// What the answers rest on besides.
    pub(super) basis: Basis,
    /// Its unread parts.
    pub(super) unread_parts: Vec<String>,
    /// Why nothing was decided.
    pub(super) problems: Vec<Problem>,
    pub(super) properties: Vec<PropertyAnswer>,
    /// Between two scans, in nanoseconds.
    pub(super) interval: i64,
    pub(super) seconds: f64,
}

/// What came of a property.
pub(super) struct PropertyAnswer {
    pub(super) name: String,
    pub(super) place: FileRange,
    pub(super) answer: Answer,
    /// Why it is not decided, or what was left open, each with its place in the program.
    pub(super) open: Vec<(String, Option<FileRange>)>,
    /// The run that was found.
    pub(super) scenario: Option<String>,
}

impl PropertyAnswer {
    pub(super) fn outcome(&self, allow_unknown: bool) -> Outcome {
        match self.answer.verdict {
            Verdict::Proved(_) | Verdict::Possible(_) => Outcome::Fine,
            Verdict::Unknown(_) if allow_unknown => Outcome::Fine,
            _ => Outcome::Findings,
        }
    }
}

impl FileAnswers {
    /// The words next to the verdict of a property.
    pub(super) fn note(&self, property: &PropertyAnswer) -> String {
        let note = property.answer.note(self.interval);
        let told = self.basis.told(&property.answer);
        match (note.is_empty(), told.is_empty()) {
            (false, false) => format!("{note}, {told}"),
            _ => note + &told,
        }
    }

    pub(super) fn outcome(&self, allow_unknown: bool) -> Outcome {
        let problems = self.problems.iter().map(|problem| problem.outcome);
        let properties = self
            .properties
            .iter()
            .map(|property| property.outcome(allow_unknown));
        problems.chain(properties).max().unwrap_or(Outcome::Fine)
    }

    /// The runs that were found.
    pub(super) fn scenarios(&self) -> Vec<String> {
        self.properties
            .iter()
            .filter_map(|property| property.scenario.clone())
            .collect()
    }
}

/// Decides the properties of a file.
///
/// `title` is what it is called while a person waits.
pub(super) fn answers(path: &Path, title: &str, wishes: &Wishes) -> FileAnswers {
    let began = Instant::now();
    let mut answers = FileAnswers {
        file: path.display().to_string(),
        program: String::new(),
        head: String::new(),
        basis: Basis::default(),
        unread_parts: Vec::new(),
        problems: Vec::new(),
        properties: Vec::new(),
        interval: 0,
        seconds: 0.0,
    };
    match ladder_workspace::read(path) {
        Ok(text) => {
            let source = Source::new(answers.file.clone(), text);
            if let Err(problems) = decide(path, title, &source, wishes, &mut answers) {
                answers.problems = problems;
            }
        }
        Err(error) => {
            let place = FileRange::start(&answers.file);
            answers.problems.push(Problem::unusable(place, &error));
        }
    }
    answers.seconds = began.elapsed().as_secs_f64();
    answers
}

fn decide(
    path: &Path,
    title: &str,
    source: &Source,
    wishes: &Wishes,
    answers: &mut FileAnswers,
) -> Result<(), Vec<Problem>> {
    let suite = ladder_simulator::scenario::parse(&source.text);
    if suite.properties.is_empty() && suite.errors.is_empty() {
        return Ok(());
    }
    let ready = Ready::new(path, source, &wishes.renderer, &wishes.workspaces);
    let Ready {
        suite,
        mut watched,
        mut simulation,
        program,
        ..
    } = ready.map_err(|(problems, _)| problems)?;
    answers.head = scenario::head(&suite);
    answers.program = suite
        .program
        .as_ref()
        .map(|(name, _)| name.clone())
        .unwrap_or_default();
    answers.unread_parts = unread::names(simulation.program());
    answers.interval = simulation.options().interval;
    let shows_progress = wishes.shows_progress;
    let (title, shown_at) = (title.to_owned(), Cell::new(None::<Instant>));
    let tell = move |Progress { scan, decided, of }: Progress| {
        if shows_progress && shown_at.get().is_none_or(|at| at.elapsed() >= BETWEEN) {
            terminal::passing(&format!("{title}: scan {scan}, {decided} of {of} decided"));
            shown_at.set(Some(Instant::now()));
        }
    };
    let options = Options {
        time: wishes.time,
        cancel: wishes.cancel.clone(),
        listener: Listener::new(tell),
        ..Options::default()
    };
    let mut found = prove(&mut simulation, &mut watched, options.clone()).map_err(|refuted| {
        let message = format!(
            "the prover found a run for \"{}\" that does not happen in the simulator: this is an error in the prover, \
             please report it with the program",
            refuted.name
        );
        vec![Problem::unusable(FileRange::start(&answers.file), &message)]
    })?;
    answers.basis = Basis::of(&suite, &simulation, &watched, &mut found, &options);
    let files = simulation.program().files.clone();
    for (property, answer) in watched.properties.into_iter().zip(found) {
        let scenario = found_scenario(&property.name, &property.form, &answer.verdict, answers.interval);
        let open = answer.open.iter().map(|(what, location)| {
            let place = location.map(|location| place_of(&program, &files, location));
            (what.clone(), place)
        });
        answers.properties.push(PropertyAnswer {
            name: property.name,
            place: FileRange::of(source, property.range),
            open: open.collect(),
            scenario,
            answer,
        });
    }
    Ok(())
}

//! One scenario file: its program is read, and its scenarios are run.

use super::pictures::{self, Pictures};
use super::report::{CaseReport, DifferenceReport, FaultReport, FileReport, ViolationReport};
use crate::findings::{FileRange, Problem, Source, Workspaces};
use crate::ready::{Ready, place_of};
use crate::run::unread;
use annotate_snippets::Renderer;
use ladder_simulator::coverage::Coverage;
use ladder_simulator::scenario;
use std::path::Path;
use std::sync::Mutex;
use std::time::Instant;

/// What is asked of each file.
pub(super) struct Wishes {
    /// Only scenarios whose name holds this, in small letters.
    pub(super) filter: Option<String>,
    /// Whether what is exercised is recorded.
    pub(super) coverage: bool,
    /// How wide drawings may be.
    pub(super) width: usize,
    /// Where pictures of what failed go, if they are asked for.
    pub(super) pictures: Option<Pictures>,
    pub(super) renderer: Renderer,
    /// Those of the programs.
    pub(super) workspaces: Mutex<Workspaces>,
}

impl Wishes {
    /// Whether a scenario of this name is to be run.
    pub(super) fn wants(&self, name: &str) -> bool {
        let holds = |filter: &String| name.to_lowercase().contains(filter);
        self.filter.as_ref().is_none_or(holds)
    }
}

/// Runs the scenarios of a file.
pub(super) fn run(path: &Path, wishes: &Wishes) -> FileReport {
    let began = Instant::now();
    let mut report = FileReport {
        file: path.display().to_string(),
        program: None,
        unread_parts: Vec::new(),
        problems: Vec::new(),
        cases: Vec::new(),
        seconds: 0.0,
        coverage: None,
        properties: 0,
    };
    match ladder_workspace::read(path) {
        Ok(text) => {
            let source = Source::new(report.file.clone(), text);
            if let Err(problems) = play(path, &source, wishes, &mut report) {
                report.problems = problems;
            }
        }
        Err(error) => report
            .problems
            .push(Problem::unusable(FileRange::start(&report.file), &error)),
    }
    report.seconds = began.elapsed().as_secs_f64();
    report
}

/// The errors of a scenario file, as far as they can be found.
pub(super) fn check(path: &Path, source: &Source, renderer: &Renderer) -> Vec<Problem> {
    match Ready::new(path, source, renderer, &Mutex::default()) {
        Ok(_) => Vec::new(),
        Err((problems, _)) => problems,
    }
}

fn play(path: &Path, source: &Source, wishes: &Wishes, report: &mut FileReport) -> Result<(), Vec<Problem>> {
    let Ready {
        suite,
        cases,
        mut watched,
        mut simulation,
        program,
    } = Ready::new(path, source, &wishes.renderer, &wishes.workspaces).map_err(|(problems, program)| {
        report.program = program;
        problems
    })?;
    report.unread_parts = unread::names(simulation.program());
    let files = simulation.program().files.clone();
    let mut scenes = None;
    let mut coverage = wishes.coverage.then(|| Coverage::of(&mut simulation));
    for case in &cases {
        if !wishes.wants(&case.name) {
            continue;
        }
        let began = Instant::now();
        let ran = scenario::run(
            case,
            &mut watched,
            &mut simulation,
            |simulation| match &mut coverage {
                Some(coverage) => coverage.scan(simulation),
                None => simulation.scan(),
            },
        );
        let seconds = began.elapsed().as_secs_f64();
        let interval = simulation.options().interval;
        let drawing = if ran.passed() {
            Vec::new()
        } else {
            scenario::draw(case, &ran, interval, wishes.width)
        };
        report.cases.push(CaseReport {
            name: case.name.clone(),
            place: FileRange::of(source, case.range),
            passed: ran.passed(),
            steps: case.steps(),
            scans: ran.scans,
            seconds,
            drawing,
            differences: ran
                .differences
                .iter()
                .map(|difference| DifferenceReport {
                    tag: difference.tag.clone(),
                    place: FileRange::of(source, difference.range),
                    steps: difference.steps.clone(),
                    places: difference
                        .places
                        .iter()
                        .map(|place| FileRange::of(source, *place))
                        .collect(),
                    sentence: scenario::sentence(case, &ran, difference, interval),
                })
                .collect(),
            violations: ran
                .violations
                .iter()
                .map(|violation| ViolationReport {
                    name: violation.name.clone(),
                    place: FileRange::of(source, violation.range),
                    scan: violation.scan,
                    steps: violation.steps.clone(),
                    sentence: scenario::violation_sentence(case, violation, interval),
                })
                .collect(),
            outside: (ran.outside.as_ref())
                .map(|outside| scenario::outside_sentence(&suite, outside, interval)),
            faults: ran
                .faults
                .iter()
                .map(|fault| FaultReport {
                    place: place_of(&program, &files, fault.location),
                    scan: fault.scan,
                    message: fault.message.clone(),
                })
                .collect(),
            stopped: ran.stopped,
            pictures: match &wishes.pictures {
                Some(pictures) if !ran.passed() => {
                    let scenes = scenes.get_or_insert_with(|| pictures::scenes_of(path, &suite));
                    let number = report.cases.len() + 1;
                    pictures.draw(
                        (path, number),
                        scenes,
                        (case, &ran),
                        (&mut watched, &mut simulation),
                    )
                }
                _ => Vec::new(),
            },
        });
    }
    if let Some(coverage) = &mut coverage {
        coverage.finish(&simulation);
    }
    report.properties = suite.properties.len();
    report.coverage = coverage;
    report.program = Some(program);
    Ok(())
}

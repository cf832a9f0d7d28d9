//! One scenario file: its program is read, and its scenarios are run.

use super::report::{CaseReport, DifferenceReport, FaultReport, FileReport};
use crate::findings::{FileRange, NotRead, Problem, Source, Workspaces, full};
use crate::outcome::Outcome;
use annotate_snippets::Renderer;
use ladder_analysis::program::Location;
use ladder_analysis::{NotWhole, Severity};
use ladder_simulator::coverage::Coverage;
use ladder_simulator::scenario::{self, Case, ScenarioError, Suite};
use ladder_simulator::{Options, Simulation};
use ladder_syntax::TextRange;
use ladder_workspace::{FileError, Named, Settings};
use std::borrow::Cow;
use std::path::Path;
use std::sync::{Arc, Mutex};
use std::time::Instant;

/// What is asked of each file.
pub(super) struct Wishes {
    /// Only scenarios whose name holds this, in small letters.
    pub(super) filter: Option<String>,
    /// Whether what is exercised is recorded.
    pub(super) coverage: bool,
    /// How wide drawings may be.
    pub(super) width: usize,
    pub(super) renderer: Renderer,
    /// Those of the programs.
    pub(super) workspaces: Mutex<Workspaces>,
}

impl Wishes {
    /// A program among the others of its workspace, which many files of scenarios share.
    fn source(&self, program: &Path, bytes: Vec<u8>) -> Result<Source, NotRead> {
        let source = Source::of_bytes(program, bytes, None)?;
        // Settings that cannot be used are reported where they are read.
        let workspace = match self.workspaces.lock() {
            Ok(mut workspaces) => workspaces.of(program).ok().flatten(),
            Err(_) => None,
        };
        Ok(match workspace {
            Some(workspace) => source.within(workspace),
            None => source,
        })
    }
}

/// Runs the scenarios of a file.
pub(super) fn run(path: &Path, wishes: &Wishes) -> FileReport {
    let began = Instant::now();
    let mut report = FileReport {
        file: path.display().to_string(),
        program: None,
        problems: Vec::new(),
        cases: Vec::new(),
        seconds: 0.0,
        coverage: None,
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
    let wishes = Wishes {
        filter: None,
        coverage: false,
        width: 0,
        renderer: renderer.clone(),
        workspaces: Mutex::default(),
    };
    match Ready::new(path, source, &wishes) {
        Ok(_) => Vec::new(),
        Err((problems, _)) => problems,
    }
}

/// A file whose scenarios can be run.
struct Ready {
    cases: Vec<Case>,
    simulation: Simulation,
    program: Arc<Source>,
}

impl Ready {
    /// Reads the program and binds the scenarios to it. If that cannot be, the program is given as far as it was
    /// read.
    fn new(
        path: &Path,
        source: &Source,
        wishes: &Wishes,
    ) -> Result<Ready, (Vec<Problem>, Option<Arc<Source>>)> {
        let suite = scenario::parse(&source.text);
        let errors = |found: &[ScenarioError]| -> Vec<Problem> {
            let mut found: Vec<&ScenarioError> = suite.errors.iter().chain(found).collect();
            found.sort_by_key(|error| error.range.start());
            found
                .into_iter()
                .map(|found| Problem::of(source, found, &wishes.renderer))
                .collect()
        };
        let Some((name, range)) = &suite.program else {
            return Err((errors(&[]), None));
        };
        let named = Named::in_file(path, name);
        let program = named.path();
        let with_errors = |problem: Problem| {
            let mut problems = errors(&[]);
            problems.insert(0, problem);
            (problems, None)
        };
        let bytes = named
            .read_bytes()
            .map_err(|error| with_errors(missing_program(source, *range, &error, &wishes.renderer)))?;
        let program_source = wishes.source(&program, bytes);
        let program_source = program_source.map_err(|error| with_errors(broken_program(&program, &error)))?;
        let program_source = Arc::new(program_source);
        let mut simulation =
            compile(&program, &program_source, &suite, &wishes.renderer).map_err(|problems| {
                let mut all = errors(&[]);
                all.extend(problems);
                (all, Some(Arc::clone(&program_source)))
            })?;
        let (cases, found) = scenario::bind(&suite, &simulation);
        let problems = errors(&found);
        if !problems.is_empty() {
            return Err((problems, Some(program_source)));
        }
        simulation.take_faults();
        Ok(Ready {
            cases,
            simulation,
            program: program_source,
        })
    }
}

fn play(path: &Path, source: &Source, wishes: &Wishes, report: &mut FileReport) -> Result<(), Vec<Problem>> {
    let Ready {
        cases,
        mut simulation,
        program,
    } = Ready::new(path, source, wishes).map_err(|(problems, program)| {
        report.program = program;
        problems
    })?;
    let files = simulation.program().files.clone();
    let mut coverage = wishes.coverage.then(|| Coverage::of(&mut simulation));
    for case in &cases {
        let wanted = |filter: &String| case.name.to_lowercase().contains(filter);
        if !wishes.filter.as_ref().is_none_or(wanted) {
            continue;
        }
        let began = Instant::now();
        let ran = scenario::run(case, &mut simulation, |simulation| match &mut coverage {
            Some(coverage) => coverage.scan(simulation),
            None => simulation.scan(),
        });
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
        });
    }
    if let Some(coverage) = &mut coverage {
        coverage.finish(&simulation);
    }
    report.coverage = coverage;
    report.program = Some(program);
    Ok(())
}

/// The program, ready to run, at the interval that the scenarios or the workspace ask for.
fn compile(
    path: &Path,
    source: &Source,
    suite: &Suite,
    renderer: &Renderer,
) -> Result<Simulation, Vec<Problem>> {
    let settings = Settings::of(path)
        .map_err(|error| vec![Problem::unusable(FileRange::start(&source.file), &error)])?;
    let program = source.program().map_err(|why| match why {
        NotWhole::Missing(file) => {
            let message = format!("{file}, which this program uses, cannot be read any more");
            vec![Problem::unusable(FileRange::start(&source.file), &message)]
        }
        NotWhole::Errors(file) => match source.other(&file) {
            Some(other) if source.analyze().context.name != file => errors(&other, renderer),
            _ => errors(source, renderer),
        },
    })?;
    let mut options: Options = settings.simulate.options(&program);
    if let Some((interval, _)) = suite.interval {
        options.interval = interval;
    }
    Simulation::new(program, options).map_err(|error| {
        let found = ScenarioError {
            range: source.range_in_file(error.location.range),
            message: error.message,
            help: None,
        };
        vec![Problem::of(source, &found, renderer)]
    })
}

/// The errors in a program.
fn errors(source: &Source, renderer: &Renderer) -> Vec<Problem> {
    let remarks = source.remarks().into_iter();
    let remarks = remarks.filter(|remark| remark.severity == Severity::Error);
    let remarks = remarks.map(|remark| Problem::remark(source, remark, renderer));
    let found = source.errors().into_iter().map(|error| Problem {
        place: FileRange::of(source, error.range),
        rule: error.rule.name(),
        severity: error.severity,
        shown: full::render(source, &error, renderer),
        message: error.message,
        help: error.help.map(Cow::into_owned),
        outcome: Outcome::Findings,
    });
    remarks.chain(found).collect()
}

/// A place of a program, in whichever file it lies.
fn place_of(source: &Source, files: &[String], location: Location) -> FileRange {
    let other = match location.file {
        0 => None,
        file => source.other(&files[file as usize]),
    };
    let source = other.as_ref().unwrap_or(source);
    FileRange::of(source, source.range_in_file(location.range))
}

/// The program that a file names is in another system's notation, and broken.
fn broken_program(program: &Path, error: &NotRead) -> Problem {
    let file = program.display().to_string();
    let place = error.place.map(|place| FileRange {
        file: file.clone(),
        line: place.line,
        column: place.column,
        end_line: place.line,
        end_column: place.column,
    });
    Problem::unusable(place.unwrap_or_else(|| FileRange::start(&file)), &error.failure)
}

/// The program that a file names cannot be read: reported where it is named.
fn missing_program(source: &Source, range: TextRange, error: &FileError, renderer: &Renderer) -> Problem {
    let found = ScenarioError {
        range,
        message: error.to_string(),
        help: Some("a program is named as it is seen from the folder of the scenario file".to_owned()),
    };
    Problem {
        outcome: Outcome::Failed,
        ..Problem::of(source, &found, renderer)
    }
}

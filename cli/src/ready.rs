//! A scenario file with its program: read, compiled, and bound to each other.

use crate::findings::{FileRange, NotRead, Problem, Source, Workspaces, full, is_settings};
use crate::outcome::Outcome;
use crate::run::{Plants, unread};
use annotate_snippets::Renderer;
use ladder_analysis::program::Location;
use ladder_analysis::{NotWhole, Severity};
use ladder_picture::scene::Finding;
use ladder_simulator::scenario::{self, Case, ScenarioError, Suite, Watched};
use ladder_simulator::{Options, Simulation};
use ladder_syntax::TextRange;
use ladder_workspace::{FileError, Named, Settings, is_scene};
use std::borrow::Cow;
use std::path::Path;
use std::sync::{Arc, Mutex};

/// A file whose scenarios can be run, and whose properties can be asked.
pub(crate) struct Ready {
    pub(crate) suite: Suite,
    pub(crate) cases: Vec<Case>,
    pub(crate) watched: Watched,
    pub(crate) simulation: Simulation,
    pub(crate) program: Arc<Source>,
}

impl Ready {
    /// Reads the program and binds the scenarios to it. If that cannot be, the program is given as far as it was
    /// read.
    pub(crate) fn new(
        path: &Path,
        source: &Source,
        renderer: &Renderer,
        workspaces: &Mutex<Workspaces>,
    ) -> Result<Ready, NotReady> {
        let suite = scenario::parse(&source.text);
        let errors = |found: &[ScenarioError]| -> Vec<Problem> {
            let mut found: Vec<&ScenarioError> = suite.errors.iter().chain(found).collect();
            found.sort_by_key(|error| error.range.start());
            found
                .into_iter()
                .map(|found| Problem::of(source, found, renderer))
                .collect()
        };
        if suite.program.is_none() {
            return Err((errors(&[]), None));
        }
        let prepared = prepared(path, source, &suite, renderer, workspaces);
        let (mut simulation, program_source) = prepared.map_err(|(mut problems, program)| {
            problems.extend(errors(&[]));
            (problems, program)
        })?;
        let (cases, mut found) = scenario::bind(&suite, &simulation);
        if let Some((_, range)) = suite.interval.filter(|_| simulation.program().has_tasks()) {
            found.push(ScenarioError {
                range,
                message: "the tasks of a project say how often each program runs".to_owned(),
                help: Some("leave the line out".to_owned()),
            });
        }
        let (watched, of_properties) = scenario::bind_properties(&suite, &simulation);
        found.extend(of_properties);
        let problems = errors(&found);
        if !problems.is_empty() {
            return Err((problems, Some(program_source)));
        }
        simulation.take_faults();
        Ok(Ready {
            cases,
            watched,
            suite,
            simulation,
            program: program_source,
        })
    }
}

/// What goes wrong before a program runs, and the program as far as it was read.
type NotReady = (Vec<Problem>, Option<Arc<Source>>);

/// The program that a file of scenarios or a scene is about, beside its plants and ready to run.
pub(crate) fn prepared(
    path: &Path,
    source: &Source,
    suite: &Suite,
    renderer: &Renderer,
    workspaces: &Mutex<Workspaces>,
) -> Result<(Simulation, Arc<Source>), NotReady> {
    let unread = |problem: Problem| (vec![problem], None);
    let Some((name, range)) = &suite.program else {
        return Err((Vec::new(), None));
    };
    let named = Named::in_file(path, name);
    let program = named.path();
    let bytes = named
        .read_bytes()
        .map_err(|error| unread(missing_program(source, *range, &error, renderer)))?;
    let mut program_source =
        source_of(&program, bytes, workspaces).map_err(|error| unread(broken_program(&program, &error)))?;
    let mut plants = Vec::new();
    for plant in &suite.plants {
        let named = Named::in_file(path, &plant.file);
        let bytes = named
            .read_bytes()
            .map_err(|error| unread(missing_program(source, plant.range, &error, renderer)))?;
        let of_plant = source_of(&named.path(), bytes, workspaces)
            .map_err(|error| unread(broken_program(&named.path(), &error)))?;
        plants.push((of_plant, plant.name.clone()));
    }
    if plants.is_empty() && is_scene(path) {
        // A scene shows what is simulated, and that runs with the plants of the settings.
        program_source = Plants::default().beside(program_source).map_err(|failure| {
            let place = FileRange::start(&program.display().to_string());
            unread(Problem::unusable(place, &failure))
        })?;
    } else {
        program_source = program_source.beside(plants, suite.connections());
    }
    let program_source = Arc::new(program_source);
    let of_plants = program_source.plant_errors();
    if !of_plants.is_empty() {
        let of_plants = of_plants.iter().map(|error| {
            let error = scenario::plant_error(suite, error);
            Problem::of(source, &error, renderer)
        });
        return Err((of_plants.collect(), Some(program_source)));
    }
    let simulation = compile(&program, &program_source, suite, renderer)
        .map_err(|problems| (problems, Some(Arc::clone(&program_source))))?;
    Ok((simulation, program_source))
}

/// A program without scenarios, ready to run.
///
/// # Errors
/// It cannot be read, or has errors.
pub(crate) fn program_alone(
    path: &Path,
    renderer: &Renderer,
    workspaces: &Mutex<Workspaces>,
) -> Result<(Arc<Source>, Simulation), Vec<Problem>> {
    let bytes = ladder_workspace::read_bytes(path).map_err(|error| {
        let place = FileRange::start(&path.display().to_string());
        vec![Problem::unusable(place, &error)]
    })?;
    let source = source_of(path, bytes, workspaces).map_err(|error| vec![broken_program(path, &error)])?;
    let simulation = compile(path, &source, &scenario::parse(""), renderer)?;
    Ok((Arc::new(source), simulation))
}

/// A program among the others of its workspace, which many files of scenarios share.
fn source_of(program: &Path, bytes: Vec<u8>, workspaces: &Mutex<Workspaces>) -> Result<Source, NotRead> {
    if is_settings(program) {
        return Source::of_tasks(program);
    }
    let source = Source::of_bytes(program, bytes, None)?;
    // Settings that cannot be used are reported where they are read.
    let workspace = match workspaces.lock() {
        Ok(mut workspaces) => workspaces.of(program).ok().flatten(),
        Err(_) => None,
    };
    Ok(match workspace {
        Some(workspace) => source.within(workspace),
        None => source,
    })
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
    unread::note(&source.file, &program);
    let mut options: Options = settings.simulate.options(&program, path);
    if let Some((interval, _)) = suite.interval.filter(|_| !program.has_tasks()) {
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
        part: source.name_of(error.range).map(str::to_owned),
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
pub(crate) fn place_of(source: &Source, files: &[String], location: Location) -> FileRange {
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
        help: Some(
            if is_scene(Path::new(&source.file)) {
                Finding::NO_PROGRAM
            } else {
                "a program is named as it is seen from the folder of the scenario file"
            }
            .to_owned(),
        ),
    };
    Problem {
        outcome: Outcome::Failed,
        ..Problem::of(source, &found, renderer)
    }
}

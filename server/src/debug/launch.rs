//! From the configuration of a launch to a program that is ready for its first scan.

use std::path::{Component, Path, PathBuf};
use std::sync::Arc;

use ladder_analysis::program::Program;
use ladder_analysis::values::value::Value;
use ladder_analysis::{Analysis, NotWhole};
use ladder_simulator::scenario;
use ladder_simulator::{HistoryLimits, Inputs, Options, Session, Simulation};
use ladder_workspace::{Named, RetentiveFile, Root, Workspace, shown};
use serde_json::{Map, Value as Json};

use super::configuration::{Configuration, GivenInputs, is_scenario_file};
use super::play::Play;
use super::sources::Source;
use super::target::Target;
use super::watch::Scope;
use crate::simulation::value::from_json;

/// Loads the program and makes it ready for its first scan. The second part are sentences for the person.
pub(super) fn load(configuration: &Configuration) -> Result<(Target, Vec<String>), String> {
    let play = scenario_of(configuration)?;
    let program_path = match (&play, &configuration.program) {
        (Some(asked), _) => asked.program.clone(),
        (None, Some(program)) => absolute(program)?,
        (None, None) => return Err("`program` is missing: name the .clad file to run".into()),
    };
    let Loaded {
        program,
        sources,
        workspace,
    } = load_program(&program_path)?;
    let simulate = &workspace.settings().simulate;
    let mut options: Options = simulate.options(&program);
    if let Some((interval, _)) = play.as_ref().and_then(|asked| asked.suite.interval) {
        options.interval = interval;
    }
    if let Some(interval) = configuration.interval()? {
        options.interval = interval;
    }
    let limits = match configuration.history.or(simulate.history) {
        Some(scans) => HistoryLimits::of_scans(usize::try_from(scans).unwrap_or(usize::MAX)),
        None => HistoryLimits::default(),
    };
    let simulation = Simulation::new(program, options).map_err(|error| error.to_string())?;
    let play = play.map(|asked| asked.bind(&simulation)).transpose()?;
    let mut session = Session::of(simulation, limits);
    let mut notes = Vec::new();
    // A scenario starts cold, as its test does.
    let retain = match &configuration.retain {
        Some(name) => Some(inside(&program_path, name, "retain")?),
        None => simulate.retain.clone().filter(|_| play.is_none()),
    };
    let retention = match retain {
        Some(file) => {
            let name = program_path
                .file_name()
                .unwrap_or_default()
                .to_string_lossy()
                .into_owned();
            let (file, found) = RetentiveFile::open_named(&file, &name).map_err(|error| error.to_string())?;
            notes.extend(found.notes);
            notes.extend(found.kept.iter().flat_map(|kept| session.warm_start(kept)));
            Some(file)
        }
        None => None,
    };
    let inputs = match &configuration.inputs {
        GivenInputs::Held(values) => {
            assign(&mut session, "inputs", values, Session::set)?;
            Inputs::default()
        }
        GivenInputs::Table(name) => read_table(&program_path, name, session.simulation())?,
    };
    assign(&mut session, "forces", &configuration.forces, Session::force)?;
    let target = Target::new(session, sources, play, inputs, retention);
    Ok((target, notes))
}

fn assign(
    session: &mut Session,
    what: &str,
    values: &Map<String, Json>,
    give: impl Fn(&mut Session, &ladder_simulator::Point, Value) -> Result<(), ladder_simulator::ValueRefused>,
) -> Result<(), String> {
    for (tag, value) in values {
        let wrong = |problem: String| format!("{what}: {problem}");
        let scope = Scope {
            simulation: session.simulation(),
            instance: None,
        };
        let point = scope.resolve(tag).map_err(wrong)?;
        let value = from_json(value, point.ty).map_err(|problem| wrong(format!("{tag}: {problem}")))?;
        give(session, &point, value).map_err(|refused| wrong(refused.message))?;
    }
    Ok(())
}

/// The table of inputs that the configuration names.
fn read_table(program: &Path, name: &str, simulation: &Simulation) -> Result<Inputs, String> {
    let file = inside(program, name, "inputs")?;
    let located = file.locate().map_err(|error| format!("inputs: {error}"))?;
    let text = ladder_workspace::read(&located).map_err(|error| format!("inputs: {error}"))?;
    Inputs::parse(&shown::path(&located), &text, simulation).map_err(|error| format!("inputs: {error}"))
}

/// A path that the client gave: it must be whole, for nobody chose the folder that the adapter runs in.
fn absolute(path: &str) -> Result<PathBuf, String> {
    let path = Path::new(path);
    if path.is_absolute() {
        return Ok(path.to_owned());
    }
    Err(format!(
        "{}: name the whole path of the file, for example with ${{workspaceFolder}} before it",
        shown::path(path)
    ))
}

/// A file that the configuration names next to the program: it lies in the folder of the program's workspace.
fn inside(program: &Path, name: &str, what: &str) -> Result<Named, String> {
    let path = Path::new(name);
    if !path.is_absolute() {
        return Ok(Named::in_file(program, name));
    }
    let root = Root::of(program).map_err(|error| format!("{what}: {error}"))?;
    let relative = path.strip_prefix(root.folder()).ok().and_then(Path::to_str);
    let relative = relative.ok_or_else(|| {
        format!(
            "{what}: {} lies outside of {}, where the program is",
            shown::path(path),
            shown::path(root.folder())
        )
    })?;
    Ok(Named::in_settings(root.folder(), &relative.replace('\\', "/")))
}

struct Loaded {
    program: Arc<Program>,
    sources: Vec<Source>,
    workspace: Workspace,
}

/// Reads a program with what it uses of its workspace.
fn load_program(path: &Path) -> Result<Loaded, String> {
    if !ladder_workspace::is_program(path) {
        return Err(format!(
            "{}: a .clad file can be debugged; `ladder convert` makes one of a program of another system",
            shown::path(path)
        ));
    }
    let text = ladder_workspace::read(path).map_err(|error| error.to_string())?;
    let workspace = Workspace::of(path).map_err(|error| error.to_string())?;
    let own = workspace.program_at(path);
    let analysis = match own {
        Some(own) if own.text == text => workspace.analysis(own),
        Some(own) => workspace.analyze_guest(&text, &own.name),
        None => workspace.analyze_guest(&text, &path.to_string_lossy()),
    };
    let source = Source::new(path.to_owned(), text);
    let program = match workspace.link(&analysis) {
        Ok(program) => program,
        Err(NotWhole::Missing(file)) => {
            return Err(format!(
                "{}, which the program uses, cannot be read any more",
                shown::line(&file)
            ));
        }
        Err(NotWhole::Errors(file)) => {
            let other = workspace
                .program_named(&file)
                .filter(|_| file != analysis.context.name);
            return Err(match other {
                Some(other) => {
                    let source = Source::new(other.path().to_owned(), other.text.clone());
                    first_error(&source, &workspace.analysis(other))
                }
                None => first_error(&source, &analysis),
            });
        }
    };
    let mut sources = vec![source];
    for name in program.files.iter().skip(1) {
        let other = workspace.program_named(name);
        let other = other.ok_or_else(|| {
            format!(
                "{}, which the program uses, cannot be read any more",
                shown::line(name)
            )
        })?;
        sources.push(Source::new(other.path().to_owned(), other.text.clone()));
    }
    Ok(Loaded {
        program,
        sources,
        workspace,
    })
}

/// Why a program with errors is not run: the first of them, and how many there are.
fn first_error(source: &Source, analysis: &Analysis) -> String {
    let errors: Vec<_> = analysis.errors().collect();
    let file = shown::path(&source.path);
    let Some(first) = errors.first() else {
        return format!("{file}: the program cannot be run");
    };
    let line = source.line(first.range.start()) + 1;
    let more = match errors.len() {
        1 => String::new(),
        all => format!(" (and {} more)", all - 1),
    };
    format!(
        "{file}:{line}: {}{more}; a program with errors is not run",
        first.message
    )
}

/// A scenario that was asked for, before its program is known.
struct Asked {
    file: Source,
    suite: scenario::Suite,
    name: Option<String>,
    program: PathBuf,
}

/// The scenario that the configuration asks for, if it does.
fn scenario_of(configuration: &Configuration) -> Result<Option<Asked>, String> {
    if !configuration.scenario_asked_for() {
        return Ok(None);
    }
    let program = configuration.program.as_deref();
    let file = match (&configuration.scenario_file, program) {
        (Some(file), _) => absolute(file)?,
        (None, Some(program)) if is_scenario_file(program) => absolute(program)?,
        (None, Some(program)) => absolute(program)?.with_extension(ladder_workspace::SCENARIO_EXTENSION),
        (None, None) => {
            return Err("`scenarioFile` is missing: name the .ladder-test file of the scenario".into());
        }
    };
    let text = ladder_workspace::read(&file).map_err(|error| error.to_string())?;
    let suite = scenario::parse(&text);
    let file = Source::new(file, text);
    let Some((named, _)) = &suite.program else {
        return Err(error(&file, &suite.errors));
    };
    let named = Named::in_file(&file.path, named);
    // Links are followed only to see that they stay inside; the client knows the file by the name that it has.
    let located = named.locate().map_err(|error| error.to_string())?;
    let plain = named.path();
    let program = if plain.canonicalize().is_ok_and(|path| path == located) && !has_parents(&plain) {
        plain
    } else {
        located
    };
    Ok(Some(Asked {
        name: configuration.scenario.clone(),
        program,
        suite,
        file,
    }))
}

fn has_parents(path: &Path) -> bool {
    path.components().any(|part| part == Component::ParentDir)
}

impl Asked {
    fn bind(self, simulation: &Simulation) -> Result<Play, String> {
        let (cases, found) = scenario::bind(&self.suite, simulation);
        let errors: Vec<_> = self.suite.errors.iter().cloned().chain(found).collect();
        if !errors.is_empty() {
            return Err(error(&self.file, &errors));
        }
        let names: Vec<String> = cases.iter().map(|case| format!("\"{}\"", case.name)).collect();
        let mut cases = cases.into_iter();
        let case = match &self.name {
            None => cases.next(),
            Some(name) => cases.find(|case| case.name == *name),
        };
        let case = case.ok_or_else(|| {
            format!(
                "{}: there is no scenario \"{}\"; the file has {}",
                shown::path(&self.file.path),
                self.name.as_deref().unwrap_or_default(),
                names.join(", ")
            )
        })?;
        Ok(Play::new(self.file, case))
    }
}

fn error(file: &Source, errors: &[scenario::ScenarioError]) -> String {
    let first = errors.iter().min_by_key(|error| error.range.start());
    let path = shown::path(&file.path);
    first.map_or(format!("{path}: it names no program"), |first| {
        let line = file.line(first.range.start()) + 1;
        let help = first
            .help
            .as_ref()
            .map_or(String::new(), |help| format!("; {help}"));
        format!("{path}:{line}: {}{help}", first.message)
    })
}

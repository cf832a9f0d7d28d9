//! What a configuration asks for: the program, where it is named by a scenario, and what is given to it.

use std::path::{Component, Path, PathBuf};

use ladder_analysis::Connect;
use ladder_analysis::values::value::Value;
use ladder_host::World;
use ladder_live::Keeping;
use ladder_live::value::from_json;
use ladder_simulator::expression::Scope;
use ladder_simulator::scenario::{self, Suite};
use ladder_simulator::{Inputs, Session, Simulation};
use ladder_workspace::{Disk, Named, Simulate, shown};
use serde_json::{Map, Value as Json};

use crate::configuration::{Configuration, GivenInputs, is_scenario_file};
use crate::play::Play;
use crate::properties::Properties;
use crate::sources::{Source, is_on_another_computer};

/// What a configuration asks for.
pub(crate) struct Asked {
    world: World,
    configuration: Configuration,
    scenario: Option<Scenario>,
    program: PathBuf,
    /// The file whose properties the program is watched for.
    properties: Option<(Source, Suite)>,
}

/// What is given to a program while it runs, and what it is watched for.
#[derive(Debug, Default)]
pub(crate) struct GivenByFiles {
    pub play: Option<Play>,
    /// What a table gives, scan by scan.
    pub inputs: Inputs,
    pub properties: Option<Properties>,
    /// Why properties are not watched, in words.
    pub problem: Option<String>,
}

impl Asked {
    /// Reads the scenario, if one is asked for: it names the program.
    pub(crate) fn of(configuration: &Configuration, world: &World) -> Result<Asked, String> {
        let disk = &*world.disk;
        let scenario = scenario_of(configuration, disk)?;
        let program = match (&scenario, &configuration.program) {
            (Some(scenario), _) => scenario.program.clone(),
            (None, Some(program)) => in_own_workspace(disk, program, "program")?.0,
            (None, None) => return Err("`program` is missing: name the .clad or .st file to run".into()),
        };
        let properties = match &scenario {
            Some(scenario) => scenario.properties(disk),
            None => properties_next_to(&program, disk),
        };
        Ok(Asked {
            world: world.clone(),
            configuration: configuration.clone(),
            scenario,
            program,
            properties,
        })
    }

    pub(crate) fn configuration(&self) -> &Configuration {
        &self.configuration
    }

    /// Where the files are that it names.
    pub(crate) fn world(&self) -> &World {
        &self.world
    }

    /// The program's file.
    pub(crate) fn program(&self) -> &Path {
        &self.program
    }

    /// The models of the machine that run beside the program, each with what is before the names of its tags, and what is connected:
    /// as the scenario says, else as the settings do.
    pub(crate) fn plants(&self, settings: &Simulate) -> (Vec<(Named, String)>, Vec<Connect>) {
        let Some(scenario) = &self.scenario else {
            let plants = settings.plants_of(&self.program).iter();
            let plants = plants.map(|plant| (plant.file.clone(), plant.name.clone()));
            return (plants.collect(), settings.connects.clone());
        };
        let disk = &self.world.disk;
        let plants = scenario.suite.plants.iter();
        let plants = plants.map(|plant| {
            (
                disk.named_in(&scenario.file.path, &plant.file),
                plant.name.clone(),
            )
        });
        (plants.collect(), scenario.suite.connections())
    }

    /// Whether a scenario is to be run.
    pub(crate) fn is_scenario(&self) -> bool {
        self.scenario.is_some()
    }

    /// The time from one scan to the next, in nanoseconds, if it is given.
    pub(crate) fn interval(&self) -> Result<Option<i64>, String> {
        let of_scenario = self
            .scenario
            .as_ref()
            .and_then(|scenario| scenario.suite.interval);
        let of_scenario = of_scenario.map(|(interval, _)| interval);
        Ok(self.configuration.interval()?.or(of_scenario))
    }

    /// Where retentive tags are kept. A scenario starts cold, as its test does.
    pub(crate) fn keeping(&self) -> Result<Keeping, String> {
        match &self.configuration.retain {
            Some(name) => Ok(Keeping::In(inside(
                &*self.world.disk,
                &self.program,
                name,
                "retain",
            )?)),
            None if self.is_scenario() => Ok(Keeping::Nothing),
            None => Ok(Keeping::AsSettingsSay),
        }
    }

    /// Gives a session what it begins with; what is left is given while it runs.
    pub(crate) fn give(&self, session: &mut Session) -> Result<GivenByFiles, String> {
        let scenario = self.scenario.as_ref();
        let play = scenario
            .map(|scenario| scenario.bind(session.simulation()))
            .transpose()?;
        let inputs = match &self.configuration.inputs {
            GivenInputs::Held(values) => {
                assign(session, "inputs", values, Session::set)?;
                Inputs::default()
            }
            GivenInputs::Table(name) => {
                read_table(&*self.world.disk, &self.program, name, session.simulation())?
            }
        };
        assign(session, "forces", &self.configuration.forces, Session::force)?;
        let (properties, problem) = match self.watched(session) {
            Ok(properties) => (properties, None),
            Err(problem) => (None, Some(problem)),
        };
        Ok(GivenByFiles {
            play,
            inputs,
            properties,
            problem,
        })
    }

    fn watched(&self, session: &Session) -> Result<Option<Properties>, String> {
        let Some((file, suite)) = &self.properties else {
            return Ok(None);
        };
        Properties::bind(file.again(), suite.clone(), session).map_err(|errors| unwatched(file, &errors))
    }
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
fn read_table(
    disk: &dyn Disk,
    program: &Path,
    name: &str,
    simulation: &Simulation,
) -> Result<Inputs, String> {
    let file = inside(disk, program, name, "inputs")?;
    let text = disk
        .read_text(&file)
        .map_err(|error| format!("inputs: {error}"))?;
    Inputs::parse(&shown::path(&file.path()), &text, simulation).map_err(|error| format!("inputs: {error}"))
}

/// A path that the client gave: it must be whole, for nobody chose the folder that the adapter runs in, and on this
/// computer: on Windows even a check of a file on another one sends it the name of the person.
fn absolute(disk: &dyn Disk, path: &str) -> Result<PathBuf, String> {
    let shown = shown::line(path);
    if is_on_another_computer(path) {
        return Err(format!(
            "{shown}: this is on another computer; give its folder a drive letter, and name the file there"
        ));
    }
    if disk.is_whole(Path::new(path)) {
        return Ok(PathBuf::from(path));
    }
    Err(format!(
        "{shown}: name the whole path of the file, for example with ${{workspaceFolder}} before it"
    ))
}

/// A file that the client names by its whole path: links to it stay in the workspace that it lies in.
fn in_own_workspace(disk: &dyn Disk, path: &str, what: &str) -> Result<(PathBuf, Named), String> {
    let mut whole = absolute(disk, path)?;
    if has_parents(&whole)
        && let (Some(Ok(folder)), Some(name)) = (
            whole.parent().map(|folder| disk.canonicalize(folder)),
            whole.file_name(),
        )
    {
        whole = folder.join(name);
    }
    let file = inside(disk, &whole, &whole.to_string_lossy(), what)?;
    disk.locate(&file).map_err(|error| format!("{what}: {error}"))?;
    Ok((whole, file))
}

/// A file that the configuration names next to the program: it lies in the folder of the program's workspace.
fn inside(disk: &dyn Disk, program: &Path, name: &str, what: &str) -> Result<Named, String> {
    if !disk.is_whole(Path::new(name)) {
        return Ok(disk.named_in(program, name));
    }
    let path = absolute(disk, name)?;
    let root = disk
        .root_of(program)
        .map_err(|error| format!("{what}: {error}"))?;
    let relative = path.strip_prefix(root.folder()).ok().and_then(Path::to_str);
    let relative = relative.ok_or_else(|| {
        format!(
            "{what}: {} lies outside of {}, where the program is",
            shown::path(&path),
            shown::path(root.folder())
        )
    })?;
    Ok(Named::in_settings(root.folder(), &relative.replace('\\', "/")))
}

/// The file next to a program that has its properties, if it is about this program.
fn properties_next_to(program: &Path, disk: &dyn Disk) -> Option<(Source, Suite)> {
    let path = program.with_extension(ladder_workspace::SCENARIO_EXTENSION);
    let file = disk.named_in(program, &path.file_name()?.to_string_lossy());
    let text = disk.read_text(&file).ok()?;
    let suite = scenario::parse(&text);
    let (named, _) = suite.program.as_ref()?;
    let located = disk.locate(&disk.named_in(&path, named)).ok()?;
    (disk.canonicalize(program).ok()? == located).then(|| (Source::new(path, text), suite))
}

/// A scenario that was asked for, before its program is known.
struct Scenario {
    file: Source,
    /// Where the file is, whose text may be another one.
    named: Named,
    suite: Suite,
    name: Option<String>,
    line: Option<u32>,
    program: PathBuf,
}

/// The scenario that the configuration asks for, if it does.
fn scenario_of(configuration: &Configuration, disk: &dyn Disk) -> Result<Option<Scenario>, String> {
    if !configuration.scenario_asked_for() {
        return Ok(None);
    }
    let program = configuration.program.as_deref();
    let (path, file) = match (&configuration.scenario_file, program) {
        (Some(file), Some(program)) => {
            let (program, _) = in_own_workspace(disk, program, "program")?;
            let file = inside(disk, &program, file, "scenarioFile")?;
            (file.path(), file)
        }
        (Some(file), None) => in_own_workspace(disk, file, "scenarioFile")?,
        (None, Some(program)) if is_scenario_file(program) => in_own_workspace(disk, program, "program")?,
        (None, Some(program)) => {
            let (program, _) = in_own_workspace(disk, program, "program")?;
            let file = program.with_extension(ladder_workspace::SCENARIO_EXTENSION);
            in_own_workspace(disk, &file.to_string_lossy(), "scenarioFile")?
        }
        (None, None) => {
            return Err("`scenarioFile` is missing: name the .ladder-test file of the scenario".into());
        }
    };
    // What is wrong in a scenario is told with its text, which of other files is nobody's business.
    if !ladder_workspace::is_scenario(&path) {
        return Err(format!(
            "scenarioFile: {}: scenarios are in a file ending in .ladder-test",
            shown::path(&path)
        ));
    }
    let named = file;
    let file = match &configuration.scenario_text {
        Some(text) => Source::given(path, text.clone()),
        None => Source::new(path, disk.read_text(&named).map_err(|error| error.to_string())?),
    };
    let suite = scenario::parse(&file.text);
    let Some((program, _)) = &suite.program else {
        return Err(error(&file, &suite.errors));
    };
    let program = disk.named_in(&file.path, program);
    // Links are followed only to see that they stay inside; the client knows the file by the name that it has.
    let located = disk.locate(&program).map_err(|error| error.to_string())?;
    let plain = program.path();
    let program = if disk.canonicalize(&plain).is_ok_and(|path| path == located) && !has_parents(&plain) {
        plain
    } else {
        located
    };
    Ok(Some(Scenario {
        name: configuration.scenario.clone(),
        line: configuration.scenario_line,
        program,
        suite,
        named,
        file,
    }))
}

fn has_parents(path: &Path) -> bool {
    path.components().any(|part| part == Component::ParentDir)
}

impl Scenario {
    /// The properties of its file: a run that a proof has found is given without them.
    fn properties(&self, disk: &dyn Disk) -> Option<(Source, Suite)> {
        if self.file.given_text().is_none() {
            return Some((self.file.again(), self.suite.clone()));
        }
        let text = disk.read_text(&self.named).ok()?;
        let suite = scenario::parse(&text);
        Some((Source::new(self.file.path.clone(), text), suite))
    }

    fn bind(&self, simulation: &Simulation) -> Result<Play, String> {
        let (cases, found) = scenario::bind(&self.suite, simulation);
        let errors: Vec<_> = self.suite.errors.iter().cloned().chain(found).collect();
        if !errors.is_empty() {
            return Err(error(&self.file, &errors));
        }
        let names: Vec<String> = cases.iter().map(|case| format!("\"{}\"", case.name)).collect();
        let line = self.line.map(|line| line.saturating_sub(1) as usize);
        let mut cases = cases.into_iter();
        let case = match (&self.name, line) {
            (Some(name), _) => cases.find(|case| case.name == *name),
            // Above the first one it is the first one that is meant.
            (None, Some(line)) => cases
                .clone()
                .rfind(|case| self.file.line(case.range.start()) <= line)
                .or_else(|| cases.next()),
            (None, None) => cases.next(),
        };
        let case = case.ok_or_else(|| {
            format!(
                "{}: there is no scenario \"{}\"; the file has {}",
                shown::path(&self.file.path),
                self.name.as_deref().unwrap_or_default(),
                names.join(", ")
            )
        })?;
        let file = self.file.again();
        Ok(Play::new(file, self.suite.clone(), case))
    }
}

/// Why properties are not watched, in words.
pub(crate) fn unwatched(file: &Source, errors: &[scenario::ScenarioError]) -> String {
    format!("{}; the properties are not watched", error(file, errors))
}

/// The first error of a file, with its place.
pub(crate) fn error(file: &Source, errors: &[scenario::ScenarioError]) -> String {
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

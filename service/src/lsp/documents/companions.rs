//! Diagnostics of open texts that are not ladder text: settings files, scenarios, scenes, and programs of other systems.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use ladder_analysis::{Analysis, Severity};
use ladder_documents::{Kind, Revision, address};
use ladder_host::Work;
use ladder_notations::of_workspaces;
use ladder_picture::scene::{self, Finding, Scene};
use ladder_simulator::Simulation;
use ladder_simulator::scenario::{self, PlantLine, ScenarioError, Suite};
use ladder_syntax::TextRange;
use ladder_workspace::{FileError, Settings, errors_on_disk, is_scene, scene_stem};
use tower_lsp::ls_types::Diagnostic;

use super::{diagnostics, foreign, misfits, pull, settings_file};
use crate::lsp::session::proofs::ProgramText;
use crate::lsp::transport::blocking::blocking;
use crate::lsp::{convert, session::shared::Shared};
use crate::proof::PropertyProved;

/// What is where the name of a rule would.
pub(crate) const BAD_SETTING: &str = "bad-setting";
const BAD_SCENARIO: &str = "bad-scenario";
/// The same, of what `ladder prove` finds.
const PROPERTY_VIOLATED: &str = "property-violated";
/// The rows of a run with so many scans are not shown in a message.
const MOST_SHOWN: usize = 80;

/// Sees to it that the newest text gets its diagnostics.
pub(crate) fn refresh(shared: &Arc<Shared>, uri: &str) {
    if shared.agreed().pulls_diagnostics && !shared.previews.follow(uri) {
        return;
    }
    if let Some(revision) = shared.companions.begin_analysis(uri) {
        shared.spawn(look_at(shared.clone(), revision, shared.busy.begin()));
    }
}

/// Looks once more at the open texts that name tags, scenarios, scenes and settings: a program has changed.
pub(crate) fn refresh_scenarios(shared: &Arc<Shared>) {
    for companion in shared.companions.all() {
        if matches!(companion.kind(), Kind::Scenarios | Kind::Scene | Kind::Settings)
            && shared.companions.touch(&companion.uri)
        {
            refresh(shared, &companion.uri);
        }
    }
}

/// Looks once more at the open programs of other systems that changed files belong to.
pub(crate) fn refresh_programs(shared: &Arc<Shared>, changed: &[PathBuf]) {
    for program in shared.companions.all() {
        let belongs = |file: &PathBuf| {
            let (Some(notation), Some(place)) = (program.kind().notation(), program.place()) else {
                return false;
            };
            let foreign = shared.neighbours.foreign();
            foreign.is_companion(notation, &place.path, file)
        };
        if changed.iter().any(belongs) && shared.companions.touch(&program.uri) {
            refresh(shared, &program.uri);
            pull::refresh(shared);
        }
    }
}

async fn look_at(shared: Arc<Shared>, first: Arc<Revision>, _work: Work) {
    let mut next = Some(first);
    while let Some(revision) = next {
        if shared.companions.is_current(&revision) {
            let (next_to, job) = (shared.clone(), revision.clone());
            let looked = blocking(&*shared.host, move |_| {
                if !next_to.agreed().pulls_diagnostics {
                    let found = diagnostics_of(&next_to, &job);
                    next_to
                        .outbox
                        .diagnostics(&next_to.companions, job.clone(), found);
                }
                foreign::tell_preview(&next_to, &job);
                foreign::tell_others(&next_to, &job);
            });
            if let Err(error) = looked.await {
                let message = format!("no diagnostics for {}: {}", revision.uri, error.message);
                shared.outbox.log(message);
            }
        }
        next = shared.companions.analysed(&revision);
    }
}

/// The text is gone from the editor. A settings file counts as it is on disk.
pub(crate) fn closed(shared: &Arc<Shared>, uri: &str) {
    shared.previews.end(uri);
    shared.proofs.forget(uri);
    if !shared.agreed().pulls_diagnostics {
        shared.outbox.no_diagnostics(uri);
    }
    if let Some(path) = address::path_of(uri).filter(|path| of_workspaces(path).is_some()) {
        diagnostics::neighbour_closed(shared, uri.to_owned(), path);
    }
    if Kind::of(uri, "", "") == Kind::Settings {
        settings_file::tell_again(shared, uri);
    }
}

/// What is wrong in an open text that is not ladder text. For a blocking thread.
pub(crate) fn diagnostics_of(shared: &Shared, revision: &Revision) -> Vec<Diagnostic> {
    if !revision.fits() {
        return vec![diagnostics::too_large(revision)];
    }
    match revision.kind() {
        Kind::Foreign(_) => foreign::diagnostics_of(shared.agreed(), revision),
        Kind::Settings => settings(shared, revision),
        Kind::Scenarios => scenarios(shared, revision),
        Kind::Scene => scene(shared, revision),
        Kind::Program | Kind::Other => Vec::new(),
    }
}

fn settings(shared: &Shared, revision: &Revision) -> Vec<Diagnostic> {
    let path = address::path_of(&revision.uri);
    let text = revision.text();
    let (settings, errors) = Settings::examine(path.as_deref().unwrap_or(Path::new("")), &text);
    let disk = &shared.world().disk;
    let beside = path.map_or_else(Vec::new, |path| {
        let mut beside = errors_on_disk(&settings, &text, &**disk);
        beside.extend(misfits::of(shared, &path, &settings, &text));
        beside
    });
    let errors = errors.into_iter().chain(beside);
    errors
        .map(|error| error_at(revision, error.range, BAD_SETTING, error.message))
        .collect()
}

fn scenarios(shared: &Shared, revision: &Revision) -> Vec<Diagnostic> {
    let suite = scenario::parse(&revision.text());
    let mut errors = suite.errors.clone();
    let mut found = Vec::new();
    match simulated(shared, revision, &suite) {
        Some(Ok(simulation)) => {
            errors.extend(scenario::bind(&suite, &simulation).1);
            errors.extend(scenario::bind_properties(&suite, &simulation).1);
            found.extend(proofs(shared, revision, &simulation));
        }
        Some(Err(not_ready)) => found.extend(why_not(revision, &suite, not_ready, BAD_SCENARIO)),
        None => {}
    }
    found.extend(
        errors
            .into_iter()
            .map(|error| told(revision, error, BAD_SCENARIO)),
    );
    in_order(found)
}

/// The scene that a text is.
pub(crate) fn scene_of(revision: &Revision, text: &str) -> Scene {
    let path = address::path_of(&revision.uri).unwrap_or_default();
    scene::of_file(scene_stem(&path).unwrap_or_default(), text)
}

fn scene(shared: &Shared, revision: &Revision) -> Vec<Diagnostic> {
    let scene = scene_of(revision, &revision.text());
    let suite = scene.suite();
    let mut findings = scene.findings.clone();
    let mut found = Vec::new();
    // One that cannot be read has no expressions to bind.
    let is_drawn = !scene.nodes.is_empty();
    match is_drawn.then(|| simulated(shared, revision, &suite)).flatten() {
        Some(Ok(simulation)) => findings.extend(scene.bind(&simulation).1),
        Some(Err(not_ready)) => found.extend(why_not(revision, &suite, not_ready, Finding::NAME)),
        None => {}
    }
    found.extend(findings.into_iter().map(|finding| {
        let range = convert::range_in(revision, finding.range);
        let message = format!("{}\n{}", finding.message, finding.help);
        convert::diagnostic(range, finding.severity, Finding::NAME, message)
    }));
    in_order(found)
}

fn in_order(mut found: Vec<Diagnostic>) -> Vec<Diagnostic> {
    found.sort_by_key(|it| (it.range.start.line, it.range.start.character));
    found
}

/// The program that a file names, ready to run. None: it names none, or lies in no folder.
pub(crate) fn simulated(
    shared: &Shared,
    revision: &Revision,
    suite: &Suite,
) -> Option<Result<Simulation, NotReady>> {
    let (name, _) = suite.program.as_ref()?;
    let path = address::path_of(&revision.uri)?;
    let disk = &shared.world().disk;
    let program = disk.locate(&disk.named_in(&path, name));
    let program = program.map_err(|error| NotReady::Missing(error.to_string()));
    Some(program.and_then(|program| compiled(shared, &program, (&path, suite))))
}

/// Why the program that a file names does not run with it, where it names what is to blame.
fn why_not(revision: &Revision, suite: &Suite, why: NotReady, rule: &str) -> Vec<Diagnostic> {
    let range = suite
        .program
        .as_ref()
        .map(|(_, range)| *range)
        .unwrap_or_default();
    match why {
        NotReady::Missing(message) => {
            let help = if rule == BAD_SCENARIO {
                "a program is named as it is seen from the folder of the scenario file"
            } else {
                Finding::NO_PROGRAM
            };
            vec![error_at(revision, range, rule, format!("{message}\n{help}"))]
        }
        NotReady::Plants(of_plants) => {
            let told = of_plants.into_iter().map(|error| told(revision, error, rule));
            told.collect()
        }
        // The program itself shows what is wrong with it.
        NotReady::Errors(message) => {
            let range = convert::range_in(revision, range);
            vec![convert::diagnostic(range, Severity::Info, rule, message)]
        }
    }
}

fn told(
    revision: &Revision,
    ScenarioError { range, message, help }: ScenarioError,
    rule: &str,
) -> Diagnostic {
    let help = help.map(|help| format!("\n{help}"));
    error_at(revision, range, rule, message + &help.unwrap_or_default())
}

/// What is known of properties that do not hold.
fn proofs(shared: &Shared, revision: &Revision, simulation: &Simulation) -> Vec<Diagnostic> {
    let known = shared.proofs.of(revision, || Some(ProgramText::of(simulation)));
    let refuted = known.iter().filter(|property| property.is_refuted());
    refuted.map(violated).collect()
}

/// A property that does not hold, as a diagnostic at its name.
pub(crate) fn violated(property: &PropertyProved) -> Diagnostic {
    let mut message = format!("\"{}\" is {}", property.name, property.message);
    if property.scan.is_some_and(|scan| scan < MOST_SHOWN) {
        message = format!("{message}\n{}", property.diagram);
    }
    let range = convert::range(property.range);
    convert::diagnostic(range, Severity::Error, PROPERTY_VIOLATED, message)
}

/// Shows what is known of properties, for the text that is there already.
pub(crate) fn refresh_proofs(shared: &Arc<Shared>, uri: &str) {
    if shared.companions.touch(uri) {
        refresh(shared, uri);
        pull::refresh(shared);
    }
}

/// Why scenarios cannot be compared with their program, or run.
pub(crate) enum NotReady {
    Missing(String),
    Errors(String),
    /// What is wrong with the plants, where the scenarios name them.
    Plants(Vec<ScenarioError>),
}

impl From<NotReady> for String {
    fn from(not_ready: NotReady) -> String {
        match not_ready {
            NotReady::Missing(message) | NotReady::Errors(message) => message,
            NotReady::Plants(errors) => {
                let first = errors.into_iter().next();
                first.map_or_else(String::new, |error| error.message)
            }
        }
    }
}

/// The program of scenarios, ready to run: as the editor shows it if it is open, else as it is on disk. These are their file and
/// what it says.
pub(crate) fn compiled(
    shared: &Shared,
    path: &Path,
    scenarios: (&Path, &Suite),
) -> Result<Simulation, NotReady> {
    let analysis = shared
        .neighbours
        .analysis_of(path)
        .map_err(|error| NotReady::Missing(error.to_string()))?;
    compiled_from(shared, path, &analysis, scenarios)
}

/// The program of a file that is analysed, ready to run.
pub(crate) fn compiled_from(
    shared: &Shared,
    path: &Path,
    analysis: &Arc<Analysis>,
    (file, suite): (&Path, &Suite),
) -> Result<Simulation, NotReady> {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let errors = |of: &str| NotReady::Errors(format!("{of} has errors; its scenarios run when it has none"));
    if analysis.diagnostics().iter().any(is_error) {
        return Err(errors(&name));
    }
    let disk = &shared.world().disk;
    let plants = suite.plants.iter().map(|plant| {
        let located = disk.locate(&disk.named_in(file, &plant.file));
        let missing = |error: FileError| NotReady::Plants(vec![plant_missing(plant, &error.to_string())]);
        Ok((located.map_err(missing)?, plant.name.clone()))
    });
    let mut plants = plants.collect::<Result<Vec<_>, NotReady>>()?;
    let mut connections = suite.connections();
    if plants.is_empty() && is_scene(file) {
        // A scene shows what is simulated, and that runs with the plants of the settings.
        let settings = shared.neighbours.simulate(path);
        let of_settings = settings.plants_of(path).iter();
        plants.extend(of_settings.map(|plant| (plant.file.path(), plant.name.clone())));
        connections.clone_from(&settings.connects);
    }
    let linked = if plants.is_empty() {
        let linked = shared.neighbours.link(path, analysis);
        linked.map(|linked| (linked, Vec::new()))
    } else {
        shared
            .neighbours
            .link_beside(path, analysis, &plants, &connections)
    };
    let (linked, of_plants) = linked.map_err(|_| {
        NotReady::Errors(format!(
            "a file that {name} uses has errors; its scenarios run when that has none"
        ))
    })?;
    if !of_plants.is_empty() {
        let of_plants = of_plants.iter().map(|error| scenario::plant_error(suite, error));
        return Err(NotReady::Plants(of_plants.collect()));
    }
    let interval = suite.interval.map(|(interval, _)| interval);
    let mut options = shared.neighbours.simulate(path).options(&linked.program, path);
    if let Some(interval) = interval.filter(|_| !linked.program.has_tasks()) {
        options.interval = interval;
    }
    Simulation::new(linked.program, options).map_err(|_| errors(&name))
}

/// A plant that cannot be read.
fn plant_missing(plant: &PlantLine, message: &str) -> ScenarioError {
    ScenarioError {
        range: plant.range,
        message: message.to_owned(),
        help: Some("a plant is named as it is seen from the folder of the scenario file".to_owned()),
    }
}

fn is_error(finding: &ladder_analysis::Diagnostic) -> bool {
    finding.severity == Severity::Error
}

fn error_at(revision: &Revision, range: TextRange, code: &str, message: String) -> Diagnostic {
    convert::diagnostic(convert::range_in(revision, range), Severity::Error, code, message)
}

//! From the configuration of a launch to a program that is ready for its first scan.

use std::path::Path;
use std::sync::Arc;
use std::time::Duration;

use ladder_analysis::program::Program;
use ladder_analysis::{Analysis, Linked, NotWhole, PlantFile, Severity};
use ladder_host::World;
use ladder_live::Keeping;
use ladder_notations::Foreign;
use ladder_simulator::{HistoryLimits, Options, Session};
use ladder_workspace::{Plan, RetentiveFile, SETTINGS_FILE, Workspace, shown};

use crate::asked::Asked;
use crate::configuration::Configuration;
use crate::sources::Source;
use crate::target::Target;

/// Loads the program and makes it ready for its first scan. The second part are sentences for the person.
pub(crate) fn load(configuration: &Configuration, world: &World) -> Result<(Target, Vec<String>), String> {
    let asked = Asked::of(configuration, world)?;
    let Loaded {
        program,
        sources,
        workspace,
    } = load_program(world, &asked)?;
    let simulate = &workspace.settings().simulate;
    let mut options: Options = simulate.options(&program, asked.program());
    options.interval = asked.interval()?.unwrap_or(options.interval);
    let limits = match configuration.history.or(simulate.history) {
        Some(scans) => HistoryLimits::of_scans(usize::try_from(scans).unwrap_or(usize::MAX)),
        None => HistoryLimits::default(),
    };
    let mut session = Session::new(program, options, limits).map_err(|error| error.to_string())?;
    let mut notes: Vec<String> = session.simulation().program().unread_note().into_iter().collect();
    let retain = match asked.keeping()? {
        Keeping::Nothing => None,
        Keeping::In(file) => Some(file),
        Keeping::AsSettingsSay => simulate.retain.clone(),
    };
    let retention = match retain {
        Some(file) => {
            let name = asked.program().file_name().unwrap_or_default();
            let (file, found) =
                RetentiveFile::open_named(&*world.disk, &file, &name.to_string_lossy(), Duration::ZERO)
                    .map_err(|error| error.to_string())?;
            notes.extend(found.notes);
            notes.extend(found.kept.iter().flat_map(|kept| session.warm_start(kept)));
            Some(file)
        }
        None => None,
    };
    let given = asked.give(&mut session)?;
    notes.extend(given.problem.clone());
    let target = Target::new(world.clone(), session, sources, given, retention);
    Ok((target, notes))
}

struct Loaded {
    program: Arc<Program>,
    sources: Vec<Source>,
    workspace: Workspace,
}

/// Only a program can be run, or what the tasks of settings run.
pub(crate) fn must_be_program(path: &Path) -> Result<(), String> {
    if ladder_workspace::is_program(path) || is_settings(path) {
        return Ok(());
    }
    Err(format!(
        "{}: a .clad or .st file can be debugged, or a ladder.toml with tasks; `ladder convert` makes one of a program of another system",
        shown::path(path)
    ))
}

fn is_settings(path: &Path) -> bool {
    path.file_name().is_some_and(|name| name == SETTINGS_FILE)
}

/// Reads a program with what it uses of its workspace.
fn load_program(world: &World, asked: &Asked) -> Result<Loaded, String> {
    let path = asked.program();
    must_be_program(path)?;
    let text = world.disk.read_own(path).map_err(|error| error.to_string())?;
    let workspace = Workspace::on(&world.disk, path).map_err(|error| error.to_string())?;
    let plan = is_settings(path).then(|| Plan::of(workspace.settings(), path));
    let plan = plan.transpose().map_err(|error| error.to_string())?;
    let own = workspace.program_at(path);
    let (analysis, source) = match (&plan, own) {
        (Some(plan), _) => {
            let text = plan.text(&workspace.settings().format);
            let analysis = workspace.analyze_guest(&text, &path.to_string_lossy());
            (analysis, Source::given(path.to_owned(), text))
        }
        (None, Some(own)) if own.text() == text || own.member.foreign().is_some() => {
            let source = Source::of_member(path.to_owned(), &own.member);
            if let Some(error) = own
                .member
                .foreign()
                .and_then(|foreign| first_remark(&source, foreign))
            {
                return Err(error);
            }
            (workspace.analysis(own), source)
        }
        (None, None) if !ladder_workspace::is_ladder_text(path) => {
            return Err(format!("{}: this cannot be read as a program", shown::path(path)));
        }
        (None, own) => {
            let name = own.map_or_else(|| path.to_string_lossy(), |own| (&*own.name).into());
            let analysis = workspace.analyze_guest(&text, &name);
            (analysis, Source::new(path.to_owned(), text))
        }
    };
    let program = match link(world, asked, &workspace, plan.as_ref(), &analysis)? {
        Ok(linked) => linked.program,
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
                    let source = Source::of_member(other.path().to_owned(), &other.member);
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
        sources.push(Source::of_member(other.path().to_owned(), &other.member));
    }
    Ok(Loaded {
        program,
        sources,
        workspace,
    })
}

/// What runs: the program, beside the models of its machine if there are any that it has to do with.
fn link(
    world: &World,
    asked: &Asked,
    workspace: &Workspace,
    plan: Option<&Plan<'_>>,
    analysis: &Arc<Analysis>,
) -> Result<Result<Linked, NotWhole>, String> {
    let alone = || match plan {
        Some(plan) => workspace.link_plan(plan, analysis),
        None => workspace.link(analysis),
    };
    let (named, connects) = asked.plants(&workspace.settings().simulate);
    if named.is_empty() {
        return Ok(alone());
    }
    let mut plants = Vec::new();
    for (file, name) in named {
        let path = world.disk.locate(&file).map_err(|error| error.to_string())?;
        let plant = workspace.program_at(&path).ok_or_else(|| {
            let path = shown::path(&path);
            format!("{path}: the plant does not belong to the workspace of the program, or cannot be read")
        })?;
        let analysis = workspace.analysis(plant);
        plants.push(PlantFile { analysis, name });
    }
    let linked = match workspace.link_beside(analysis, plan, (&plants, &connects)) {
        Ok(linked) => linked,
        Err(why) => return Ok(Err(why)),
    };
    match linked {
        (linked, _) if !linked.program.is_connected() && !asked.is_scenario() => Ok(alone()),
        (linked, errors) => match errors.first() {
            None => Ok(Ok(linked)),
            Some(error) => Err(format!("plant: {}: {}", error.message, error.help)),
        },
    }
}

/// Why a program of another notation is not run: what of it is wrong before it is ladder text.
fn first_remark(source: &Source, foreign: &Foreign) -> Option<String> {
    let remarks = foreign.remarks();
    let first = remarks.iter().find(|mark| mark.severity == Severity::Error)?;
    let (file, line) = (shown::path(&source.path), source.line_of(first.range.start()) + 1);
    Some(format!(
        "{file}:{line}: {}; a program with errors is not run",
        first.message
    ))
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

//! Which programs run, in which order, and how often: once in a scan, or at times that a scan does not have.

use super::duration;
use super::units::{Inside, network};
use crate::expression::{Meaning, operand, reads};
use crate::graph::Kind;
use crate::model::{Body, Project, Role, Task, Unit, UnitKind};
use crate::scope::{Scope, Shared};
use crate::standard;
use ladder_format::program::{Item, Qualifier, SectionKind};
use ladder_notation::{Power, Reading, Report, Turn, Unread, UnreadParts};
use std::collections::HashSet;

/// A program that runs.
pub(super) struct Run<'p> {
    pub(super) unit: &'p Unit,
    pub(super) when: When<'p>,
    /// What runs it.
    pub(super) task: Option<&'p Task>,
}

/// When a program runs there.
#[derive(Clone, Copy)]
pub(super) enum When<'p> {
    /// Once in each scan.
    EachScan,
    /// When its task has its turn, which is between any two networks of the others.
    AtTimes(&'p Task),
    /// Nothing runs it.
    Never,
}

impl When<'_> {
    /// When an unread part of such a program runs.
    pub(super) const fn turn(self) -> Turn {
        match self {
            When::AtTimes(_) => Turn::AnyTime,
            When::EachScan | When::Never => Turn::Here,
        }
    }
}

/// A program has no more instances.
const MOST_INSTANCES: usize = 8;

/// Programs have no second instances where there are more than these.
const MOST_PROGRAMS: usize = 100;

/// The programs in the order in which their tasks run them. Programs without a task come last.
pub(super) fn order<'p>(project: &'p Project, report: &mut Report) -> Vec<Run<'p>> {
    let mut order: Vec<Run<'p>> = Vec::new();
    let programs = || project.units.iter().filter(|unit| unit.kind == UnitKind::Program);
    let mut tasks: Vec<&Task> = project.tasks.iter().collect();
    tasks.sort_by_key(|task| task.priority);
    let shortest = shortest(project);
    for task in tasks {
        let shown = format!("task {}", task.name);
        let interval = task.interval.as_deref().and_then(duration::nanoseconds);
        let when = if task.event.is_none() && interval == shortest {
            report.translated(task.place, shown);
            When::EachScan
        } else {
            let why = format!("it runs {} there, and in every scan here", times(task));
            report.approximated(task.place, shown, why);
            When::AtTimes(task)
        };
        for (place, name) in &task.programs {
            let shown = format!("instance of {name}");
            let Some(unit) = programs().find(|unit| unit.name.eq_ignore_ascii_case(name)) else {
                report.refused(*place, shown, "there is no such program");
                continue;
            };
            let again = order.iter().filter(|run| std::ptr::eq(run.unit, unit)).count();
            if again >= MOST_INSTANCES || (again > 0 && order.len() > MOST_PROGRAMS) {
                let why = format!(
                    "a program runs {MOST_INSTANCES} times at most here, each with its own variables"
                );
                report.refused(*place, shown, why);
                continue;
            }
            report.translated(*place, shown);
            order.push(Run {
                unit,
                when,
                task: Some(task),
            });
        }
    }
    let when = if order.is_empty() {
        When::EachScan
    } else {
        When::Never
    };
    for unit in programs() {
        if !order.iter().any(|run| std::ptr::eq(run.unit, unit)) {
            if matches!(when, When::Never) {
                let why = "no task runs it: it is a function that nothing calls";
                report.approximated(unit.place, format!("program {}", unit.name), why);
            }
            order.push(Run {
                unit,
                when,
                task: None,
            });
        }
    }
    order
}

/// When a task runs, in words.
fn times(task: &Task) -> String {
    match (&task.event, &task.interval) {
        (Some(event), _) => format!("when {event} rises"),
        (None, Some(interval)) => format!("every {}", interval.rsplit('#').next().unwrap_or_default()),
        (None, None) => "whenever there is time".to_owned(),
    }
}

/// The length of a scan: the shortest interval of a task, in nanoseconds.
pub(super) fn shortest(project: &Project) -> Option<u64> {
    let intervals = project.tasks.iter().filter_map(|task| task.interval.as_deref());
    intervals
        .filter_map(duration::nanoseconds)
        .filter(|interval| *interval > 0)
        .min()
}

/// What says that a program which runs in every scan here writes at other times there: none, if it does not, or if an unread part
/// says so already.
pub(super) fn at_times(
    shared: &Shared<'_>,
    project: &Project,
    run: &Run<'_>,
    inside: &Inside,
    unread: &mut UnreadParts,
    reading: &mut Reading,
) -> Option<Item> {
    let When::AtTimes(task) = run.when else {
        return None;
    };
    let writes = written(shared, project, run.unit, inside);
    if inside.about.is_some() || writes.as_ref().is_some_and(Vec::is_empty) {
        return None;
    }
    let name = format!("{} in task {}", run.unit.name, task.name);
    let text = times(task);
    let about = format!("{name}: it runs {text} there, between any two networks of the other tasks.");
    let part = Unread {
        name: &name,
        about: &about,
        text: &text,
        writes: writes.as_deref(),
        power: Power::Passes,
        turn: Turn::AnyTime,
    };
    let block = unread.body(part, |name| shared.has_block(name));
    let [_, network] = network(block, task.place, reading);
    Some(network)
}

/// The tags that a program writes, if that is known: its own, and globals that stand where something is written.
fn written(shared: &Shared<'_>, project: &Project, unit: &Unit, inside: &Inside) -> Option<Vec<String>> {
    let mut names = HashSet::new();
    globals(shared, unit, &inside.scope, &mut names, &mut HashSet::new())?;
    let mut all = Vec::new();
    for item in &inside.sections {
        if let Item::Section(section) = item
            && section.kind != SectionKind::VarInput
            && section.qualifier != Some(Qualifier::Constant)
        {
            all.extend(
                section
                    .declarations
                    .iter()
                    .flat_map(|it| it.names.iter().cloned()),
            );
        }
    }
    for global in &project.globals {
        if let Some(known) = shared.globals.get(&global.name)
            && names.contains(&known.path.root.to_lowercase())
            && global.qualifier != Some(Qualifier::Constant)
        {
            all.push(known.path.root.clone());
        }
    }
    Some(all)
}

/// The names that stand where something is written, in small letters. None: something in it is not known.
fn globals(
    shared: &Shared<'_>,
    unit: &Unit,
    scope: &Scope,
    names: &mut HashSet<String>,
    done: &mut HashSet<String>,
) -> Option<()> {
    let meaning = Meaning { shared, scope };
    let mut note = |text: &str| {
        let operand = operand(text, meaning).ok()?;
        names.extend(reads(&operand.value));
        Some(())
    };
    let bodies = unit.parts.iter().map(|part| &part.body).chain([&unit.body]);
    let mut called = Vec::new();
    for body in bodies {
        let graph = match body {
            Body::Graph(graph) => graph,
            Body::Empty | Body::Ladder(_) => continue,
            Body::Text(..) | Body::Chart(_) => return None,
        };
        for node in &graph.nodes {
            match &node.kind {
                Kind::Coil(text, ..) | Kind::Variable(text, _) => note(text)?,
                Kind::Block { code: Some(_), .. } => return None,
                Kind::Block { name, instance, .. } => {
                    if let Some(instance) = instance {
                        // One that nothing declares has a tag of its own.
                        let _ = note(instance);
                    }
                    for end in node
                        .inputs
                        .iter()
                        .filter(|pin| pin.in_out)
                        .flat_map(|pin| &pin.from)
                    {
                        if let Kind::Value(text, _) = &graph.nodes[end.node].kind {
                            note(text)?;
                        }
                    }
                    match shared.blocks.get(&name.to_lowercase()) {
                        Some(block) => called.push(block),
                        None if standard::block(name).is_some() || standard::function(name).is_some() => {}
                        None => return None,
                    }
                }
                _ => {}
            }
        }
    }
    for block in called {
        if !done.insert(block.name.clone()) {
            continue;
        }
        let is_external = |role: Role| role == Role::External;
        if block
            .unit
            .variables
            .iter()
            .any(|variable| is_external(variable.role))
        {
            return None;
        }
        globals(shared, block.unit, &block.scope, names, done)?;
    }
    Some(())
}

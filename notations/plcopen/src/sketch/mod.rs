//! From the model to ladder text: as one program that runs as the project does, and as the files of a workspace.

mod blocks;
mod body;
mod call;
mod declare;
mod draw;
mod duration;
mod enabled;
mod initial;
mod power;
mod prepare;
mod turns;
mod units;

use super::graph::{End, Kind};
use super::model::{Body, Project, Task, Unit, UnitKind};
use super::scope::{Scope, Shared};
use ladder_format::Circuit;
use ladder_format::program::{Drawing, Element, Item, Network, ProgramSketch};
use ladder_notation::{Content, Names, ProjectFile, Reading, Report, is_function};
use std::collections::HashSet;
use units::{Inside, Place, unit_items};

/// The whole project.
pub fn reading(project: Project) -> Reading {
    let mut project = project;
    crate::along::take_out(&mut project);
    let mut reading = Reading {
        report: std::mem::take(&mut project.report),
        ..Reading::default()
    };
    project.units.iter_mut().for_each(crate::own::without_sinks);
    crate::brought::along(&mut project);
    let project = &project;
    let shared = Shared::of(project);
    let types = declare::types(&shared, project, &mut reading);
    let globals = declare::globals(&shared, project, &mut reading);
    let blocks = blocks(&shared, project, &mut reading);
    let order = order(project, &mut reading.report);
    let mut items: Vec<Item> = project.comments.iter().cloned().map(Item::Comment).collect();
    if let Some(interval) = shortest(project).and_then(duration::interval) {
        items.push(Item::Directive(format!("cycle {interval}")));
    }
    for part in [&types, &globals, &blocks] {
        push_part(&mut items, part.clone());
    }
    let is_alone = order.len() == 1 && !order[0].1;
    let place = if is_alone { Place::Program } else { Place::Function };
    let mut programs = Vec::new();
    let mut scope = shared.globals.clone();
    let mut sections = Vec::new();
    for (unit, _) in &order {
        let own = shared.program(unit, Some(&scope));
        let is_again = programs
            .iter()
            .any(|(other, _): &(&Unit, _)| std::ptr::eq(*other, *unit));
        let told = (reading.report.entries.len(), reading.findings.len());
        let inside = unit_items(&shared, project, unit, own, place, &mut reading);
        if is_again {
            // What there is to say of another instance was said of the first.
            reading.report.entries.truncate(told.0);
            reading.findings.truncate(told.1);
        }
        scope = inside.scope;
        if !is_alone && !inside.sections.is_empty() {
            if !sections.is_empty() {
                sections.push(Item::Blank);
            }
            sections.push(Item::Comment(format!("of {}", unit.name)));
        }
        sections.extend(inside.sections);
        programs.push((*unit, inside.items));
    }
    push_part(&mut items, sections);
    if is_alone {
        items.extend(programs.into_iter().flat_map(|(_, items)| items));
    } else {
        together(&mut items, &order, programs, &mut reading);
    }
    reading.program = ProgramSketch { items };
    let is_project = order.len() > 1 || !types.is_empty() || !blocks.is_empty() || !globals.is_empty();
    if is_project {
        reading.files = files(
            &shared,
            project,
            &order,
            [("types", types), ("globals", globals), ("blocks", blocks)],
        );
    }
    reading.report.entries.sort_by_key(|entry| entry.place);
    reading.findings.sort_by_key(|finding| finding.place);
    reading
}

fn push_part(items: &mut Vec<Item>, part: Vec<Item>) {
    if part.is_empty() {
        return;
    }
    if !items.is_empty() {
        items.push(Item::Blank);
    }
    items.extend(part);
}

/// The function blocks and functions.
fn blocks(shared: &Shared<'_>, project: &Project, reading: &mut Reading) -> Vec<Item> {
    let mut items = Vec::new();
    let enabled = enabled(project);
    for unit in &project.units {
        if unit.kind == UnitKind::Program {
            continue;
        }
        let Some(block) = shared
            .blocks
            .get(&unit.name.to_lowercase())
            .filter(|block| std::ptr::eq(block.unit, unit))
        else {
            let why = "another unit has this name, and is read";
            reading
                .report
                .refused(unit.place, format!("unit {}", unit.name), why);
            continue;
        };
        if let Body::Ladder(text) = &unit.body {
            let own = crate::brought::name(text).unwrap_or_default();
            let text = text.replace(&format!("[${own}]"), &format!("[{}]", block.name));
            items.extend([Item::Blank, Item::Text(text)]);
            continue;
        }
        let scope = block.scope.clone();
        let Inside {
            sections,
            items: body,
            ..
        } = unit_items(shared, project, unit, scope, Place::Block, reading);
        if !items.is_empty() {
            items.push(Item::Blank);
        }
        if block.name[1..] != unit.name {
            items.push(Item::Comment(format!("{} in the project", unit.name)));
        }
        items.extend(unit.comment.iter().cloned().map(Item::Comment));
        let is_enabled = unit.kind == UnitKind::FunctionBlock && enabled.contains(&unit.name.to_lowercase());
        let guard = is_enabled.then(|| guard(reading.origin(unit.place)));
        items.push(Item::Block {
            header: format!("[{}]", block.name),
            items: sections
                .into_iter()
                .chain(guard.into_iter().flatten())
                .chain(body)
                .collect(),
        });
    }
    items
}

/// The units, by their names in small letters, of which something decides when they run: more than the left rail is wired to EN
/// of a call, or they are functions in ladder text.
fn enabled(project: &Project) -> HashSet<String> {
    let bodies = project.units.iter().flat_map(|unit| {
        let parts = unit.parts.iter().map(|part| &part.body);
        parts.chain([&unit.body])
    });
    let functions = project
        .units
        .iter()
        .filter(|unit| unit.comment.as_deref().is_some_and(is_function));
    let mut enabled: HashSet<String> = functions.map(|unit| unit.name.to_lowercase()).collect();
    for body in bodies {
        let Body::Graph(graph) = body else { continue };
        let is_rail =
            |end: &End| matches!(graph.nodes.get(end.node), Some(node) if node.kind == Kind::LeftRail);
        for node in &graph.nodes {
            let mut pins = node.inputs.iter().filter(|pin| blocks::is_enable(&pin.name));
            if let Kind::Block { name, .. } = &node.kind
                && pins.any(|pin| !pin.from.iter().all(is_rail))
            {
                enabled.insert(name.to_lowercase());
            }
        }
    }
    enabled
}

/// What keeps a block from running without power.
fn guard(origin: u32) -> [Item; 2] {
    let element = |text: &str| Circuit::Element(Element::block(text.to_owned(), Some(origin)));
    let drawing = Drawing::Circuit(Circuit::Series(vec![element("[/]( EN )"), element("<RET>")]));
    let network = Network {
        comments: Vec::new(),
        drawing,
    };
    [Item::Blank, Item::Network(network)]
}

/// The programs in the order in which their tasks run them, and whether something is special about how each runs: it
/// needs a room of its own. Programs without a task come last.
fn order<'p>(project: &'p Project, report: &mut Report) -> Vec<(&'p Unit, bool)> {
    let mut order: Vec<(&Unit, bool)> = Vec::new();
    let programs = || project.units.iter().filter(|unit| unit.kind == UnitKind::Program);
    let mut tasks: Vec<&Task> = project.tasks.iter().collect();
    tasks.sort_by_key(|task| task.priority);
    let shortest = shortest(project);
    for task in tasks {
        let shown = format!("task {}", task.name);
        match task.interval.as_deref() {
            Some(interval) if duration::nanoseconds(interval) != shortest => {
                let why = format!("it runs every {interval} there, and in every scan here");
                report.approximated(task.place, shown, why);
            }
            _ => report.translated(task.place, shown),
        }
        for (place, name) in &task.programs {
            let shown = format!("instance of {name}");
            let Some(unit) = programs().find(|unit| unit.name.eq_ignore_ascii_case(name)) else {
                report.refused(*place, shown, "there is no such program");
                continue;
            };
            let again = order
                .iter()
                .filter(|(other, _)| std::ptr::eq(*other, unit))
                .count();
            if again >= MOST_INSTANCES || (again > 0 && order.len() > MOST_PROGRAMS) {
                let why = format!(
                    "a program runs {MOST_INSTANCES} times at most here, each with its own variables"
                );
                report.refused(*place, shown, why);
                continue;
            }
            report.translated(*place, shown);
            order.push((unit, false));
        }
    }
    let has_tasks = !order.is_empty();
    for unit in programs() {
        if !order.iter().any(|(other, _)| std::ptr::eq(*other, unit)) {
            if has_tasks {
                let why = "no task runs it: it is a function that nothing calls";
                report.approximated(unit.place, format!("program {}", unit.name), why);
            }
            order.push((unit, has_tasks));
        }
    }
    order
}

/// A program has no more instances.
const MOST_INSTANCES: usize = 8;

/// Programs have no second instances where there are more than these.
const MOST_PROGRAMS: usize = 100;

/// The length of a scan: the shortest interval of a task, in nanoseconds.
fn shortest(project: &Project) -> Option<u64> {
    let intervals = project.tasks.iter().filter_map(|task| task.interval.as_deref());
    intervals
        .filter_map(duration::nanoseconds)
        .filter(|interval| *interval > 0)
        .min()
}

/// Several programs in one: functions that are called in their order.
fn together(
    items: &mut Vec<Item>,
    order: &[(&Unit, bool)],
    programs: Vec<(&Unit, Vec<Item>)>,
    reading: &mut Reading,
) {
    let mut names = Names::default();
    let names: Vec<String> = order.iter().map(|(unit, _)| names.fresh(&unit.name)).collect();
    let mut block = |keyword: &str, name: &str, unit: &Unit| {
        let origin = reading.origin(unit.place);
        Item::Network(Network {
            comments: Vec::new(),
            drawing: Drawing::Circuit(Circuit::Element(Element::block(
                format!("<{keyword}>( {name} )"),
                Some(origin),
            ))),
        })
    };
    for ((unit, is_idle), name) in order.iter().zip(&names) {
        if !is_idle {
            items.extend([Item::Blank, block("CALL", name, unit)]);
        }
    }
    for ((unit, body), name) in programs.into_iter().zip(&names) {
        items.extend([Item::Blank, block("FUN", name, unit)]);
        items.extend(body);
    }
}

/// The project as files: what is shared, each program, and the settings.
fn files(
    shared: &Shared<'_>,
    project: &Project,
    order: &[(&Unit, bool)],
    parts: [(&str, Vec<Item>); 3],
) -> Vec<ProjectFile> {
    let mut names = Names::default();
    let mut file = |name: &str, content| {
        let plain: String = name
            .chars()
            .map(|c| if c.is_ascii_alphanumeric() { c } else { '_' })
            .collect();
        let name = format!("{}.clad", names.fresh(&plain));
        ProjectFile { name, content }
    };
    let mut files = Vec::new();
    // What they report is the same as before.
    let mut again = Reading::default();
    for (name, items) in parts {
        if !items.is_empty() {
            files.push(file(name, Content::Program(ProgramSketch { items })));
        }
    }
    for (unit, _) in order {
        let scope: Scope = shared.program(unit, None);
        let inside = unit_items(shared, project, unit, scope, Place::Program, &mut again);
        let mut items: Vec<Item> = unit.comment.iter().cloned().map(Item::Comment).collect();
        push_part(&mut items, inside.sections);
        items.extend(inside.items);
        files.push(file(&unit.name, Content::Program(ProgramSketch { items })));
    }
    let interval = shortest(project).and_then(duration::interval);
    let mut settings = format!(
        "# {}\n",
        project
            .comments
            .first()
            .map_or("A project", |said| said.trim())
            .replace(char::is_control, " ")
    );
    if let Some(interval) = interval {
        settings.push_str(&format!("\n[simulate]\ninterval = \"{interval}\"\n"));
    }
    files.push(ProjectFile {
        name: "ladder.toml".to_owned(),
        content: Content::Text(settings),
    });
    files
}

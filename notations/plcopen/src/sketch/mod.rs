//! From the model to ladder text: as one program that runs as the project does, and as the files of a workspace.

mod actions;
mod blocks;
mod body;
mod call;
mod chart;
mod declare;
mod draw;
mod duration;
mod enabled;
mod feedback;
mod initial;
mod once;
mod power;
mod prepare;
mod state;
mod stays;
mod structured;
mod tasks;
mod texts;
mod turns;
mod units;
mod unknown;

use super::graph::{End, Kind};
use super::model::{Body, Evaluation, Project, Task, Unit, UnitKind};
use super::scope::{Scope, Shared};
use ladder_format::Circuit;
use ladder_format::program::{Block, Drawing, Element, Item, Network, Path, ProgramSketch};
use ladder_notation::{
    Content, LineColumn, Names, ProjectFile, ProjectTask, Reading, UnreadParts, is_function,
};
use std::collections::HashSet;
use structured::Seen;
use tasks::{Run, When, at_times, order, shortest};
use units::{Inside, Place, network, unit_items};

/// The whole project.
pub fn reading(project: Project) -> Reading {
    let mut project = project;
    crate::along::take_out(&mut project);
    let mut reading = Reading {
        report: std::mem::take(&mut project.report),
        ..Reading::default()
    };
    project.units.iter_mut().for_each(crate::own::without_sinks);
    if project.is_own {
        project.units.iter_mut().for_each(crate::own::with_comparisons);
        project.units.iter_mut().for_each(crate::own::without_conversions);
    }
    crate::brought::along(&mut project);
    let project = &project;
    reading.names = names(project);
    let shared = Shared::of(project);
    let types = declare::types(&shared, project, &mut reading);
    let globals = declare::globals(&shared, project, &mut reading);
    let mut unread = UnreadParts::default();
    let seen = Seen::of(&shared, project);
    let blocks = blocks(&seen, &mut unread, &mut reading);
    let order = order(project, &mut reading.report);
    let is_alone = matches!(&order[..], [run] if !matches!(run.when, When::Never));
    let place = if is_alone { Place::Program } else { Place::Function };
    let mut insides: Vec<Inside> = Vec::new();
    let mut told_of = HashSet::new();
    let mut scope = shared.globals.clone();
    for run in &order {
        let own = shared.program(run.unit, Some(&scope));
        let told = (reading.report.entries.len(), reading.findings.len());
        let place = (place, run.when);
        let inside = unit_items(&seen, run.unit, own, place, &mut unread, &mut reading);
        if !told_of.insert(std::ptr::from_ref(run.unit)) {
            // Findings on another instance were reported on the first.
            reading.report.entries.truncate(told.0);
            reading.findings.truncate(told.1);
        }
        scope = inside.scope.clone();
        insides.push(inside);
    }
    // Of a folder each program is a file, and runs by itself.
    let shared_unread = unread.items().collect();
    let mut at_any_time = Vec::new();
    for (run, inside) in order.iter().zip(&insides) {
        at_any_time.extend(at_times(&shared, project, run, inside, &mut unread, &mut reading));
    }
    let all_blocks: Vec<Item> = blocks
        .iter()
        .flat_map(|block| &block.items)
        .cloned()
        .chain(unread.items())
        .collect();
    let mut programs = Vec::new();
    let mut sections = Vec::new();
    for (run, inside) in order.iter().zip(insides) {
        if !is_alone && !inside.sections.is_empty() {
            if !sections.is_empty() {
                sections.push(Item::Blank);
            }
            sections.push(Item::Comment(format!("of {}", run.unit.name)));
        }
        sections.extend(inside.sections);
        programs.push((run.unit, inside.items));
    }
    let mut items: Vec<Item> = project.comments.iter().cloned().map(Item::Comment).collect();
    if let Some(interval) = shortest(project).and_then(duration::interval) {
        items.push(Item::Directive(format!("cycle {interval}")));
    }
    for part in [&types, &globals, &all_blocks] {
        push_part(&mut items, part.clone());
    }
    push_part(&mut items, sections);
    items.extend(at_any_time.into_iter().flat_map(|network| [Item::Blank, network]));
    if is_alone {
        items.extend(programs.into_iter().flat_map(|(_, items)| items));
    } else {
        together(&mut items, &order, programs, &mut reading);
    }
    reading.program = ProgramSketch { items };
    let is_project = order.len() > 1 || !types.is_empty() || !all_blocks.is_empty() || !globals.is_empty();
    if is_project {
        let parts = Parts {
            types,
            globals,
            blocks,
            unread: shared_unread,
        };
        reading.files = files(&seen, &order, &mut unread, parts);
        let periodic = project.tasks.iter().filter(|task| task.event.is_none());
        reading.exact_in_files = periodic
            .map(|task| (task.place, format!("task {}", task.name)))
            .collect();
    }
    reading.report.entries.sort_by_key(|entry| entry.place);
    reading.findings.sort_by_key(|finding| finding.place);
    reading
}

/// What a person who has the project open calls its parts.
fn names(project: &Project) -> Vec<(LineColumn, String)> {
    let drawn = match project.evaluation {
        Evaluation::Once => "network",
        Evaluation::EachOutput => "rung",
    };
    let mut names = Vec::new();
    for unit in &project.units {
        let kind = match unit.kind {
            UnitKind::Program => "program",
            UnitKind::Function => "function",
            UnitKind::FunctionBlock => "function block",
        };
        let own = std::iter::once((unit.place, unit.name.clone(), &unit.body));
        let parts = unit.parts.iter().map(|part| {
            let name = format!("{} {} of {}", part.what, part.name, unit.name);
            (part.place, name, &part.body)
        });
        for (place, name, body) in own.chain(parts) {
            let networks: &[LineColumn] = match body {
                Body::Graph(graph) => &graph.networks,
                _ => &[],
            };
            // What other files of the project have is at the start, and has no networks with a place.
            if place == LineColumn::START && networks.is_empty() {
                continue;
            }
            // A part of a unit says already what it is.
            let is_unit = place == unit.place;
            names.push((
                place,
                if is_unit {
                    format!("{kind} {name}")
                } else {
                    name.clone()
                },
            ));
            let networks = networks.iter().zip(1..);
            let networks = networks.filter(|(at, _)| **at != LineColumn::START);
            names.extend(networks.map(|(at, number)| (*at, format!("{drawn} {number} of {name}"))));
        }
    }
    names
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

/// A function block or function, with the comments above it.
struct BlockItems<'p> {
    unit: &'p Unit,
    items: Vec<Item>,
}

/// What the programs of a project share.
struct Parts<'p> {
    types: Vec<Item>,
    globals: Vec<Item>,
    blocks: Vec<BlockItems<'p>>,
    unread: Vec<Item>,
}

/// The function blocks and functions.
fn blocks<'p>(seen: &Seen<'p>, unread: &mut UnreadParts, reading: &mut Reading) -> Vec<BlockItems<'p>> {
    let Seen { shared, project, .. } = *seen;
    let mut blocks: Vec<BlockItems<'p>> = Vec::new();
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
            let items = vec![Item::Blank, Item::Text(text)];
            blocks.push(BlockItems { unit, items });
            continue;
        }
        let mut items = Vec::new();
        let scope = block.scope.clone();
        let Inside {
            sections,
            items: body,
            about,
            ..
        } = unit_items(seen, unit, scope, (Place::Block, When::EachScan), unread, reading);
        if !blocks.is_empty() {
            items.push(Item::Blank);
        }
        if block.name[1..] != unit.name {
            items.push(Item::Comment(format!("{} in the project", unit.name)));
        }
        items.extend(unit.comment.iter().cloned().map(Item::Comment));
        let is_enabled = unit.kind == UnitKind::FunctionBlock
            && about.is_none()
            && enabled.contains(&unit.name.to_lowercase());
        items.extend(about.map(Item::Comment));
        let guard = is_enabled.then(|| guard(reading.origin(unit.place)));
        items.push(Item::Block {
            header: format!("[{}]", block.name),
            origin: None,
            items: sections
                .into_iter()
                .chain(guard.into_iter().flatten())
                .chain(body)
                .collect(),
        });
        blocks.push(BlockItems { unit, items });
    }
    blocks
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
    let blocks = [Block::negated_contact(Path::tag("EN")), Block::ret()];
    let elements = blocks.map(|block| Circuit::Element(Element::of(block, Some(origin))));
    let drawing = Drawing::Circuit(Circuit::Series(elements.into()));
    let network = Network {
        comments: Vec::new(),
        drawing,
    };
    [Item::Blank, Item::Network(network)]
}

/// Several programs in one: functions that are called in their order.
fn together(
    items: &mut Vec<Item>,
    order: &[Run<'_>],
    programs: Vec<(&Unit, Vec<Item>)>,
    reading: &mut Reading,
) {
    let mut names = Names::default();
    let names: Vec<String> = order.iter().map(|run| names.fresh(&run.unit.name)).collect();
    for (run, name) in order.iter().zip(&names) {
        if !matches!(run.when, When::Never) {
            items.extend(network(Block::call(name), run.unit.place, reading));
        }
    }
    for ((unit, body), name) in programs.into_iter().zip(&names) {
        items.extend(network(Block::function(name), unit.place, reading));
        items.extend(body);
    }
}

/// A task, as the settings of a folder have it. None: an event starts it. One without an interval runs as often as the others.
fn project_task(project: &Project, task: &Task) -> Option<ProjectTask> {
    let own = task.interval.as_deref().and_then(duration::nanoseconds);
    let interval = own.filter(|own| *own > 0).or_else(|| shortest(project));
    let interval = i64::try_from(interval.unwrap_or(10_000_000)).ok()?;
    if interval % 1_000 != 0 {
        return None;
    }
    task.event.is_none().then(|| ProjectTask {
        name: task.name.clone(),
        interval,
        priority: task.priority,
        programs: Vec::new(),
    })
}

/// The project as files: what is shared, each program, and the settings.
fn files(seen: &Seen<'_>, order: &[Run<'_>], unread: &mut UnreadParts, parts: Parts<'_>) -> Vec<ProjectFile> {
    let Seen { shared, project, .. } = *seen;
    // What they report is the same as before.
    let mut again = Reading::default();
    let mut programs: Vec<Vec<Item>> = Vec::new();
    for run in order {
        let scope: Scope = shared.program(run.unit, None);
        let place = (Place::Program, run.when);
        let inside = unit_items(seen, run.unit, scope, place, unread, &mut again);
        let mut items: Vec<Item> = run.unit.comment.iter().cloned().map(Item::Comment).collect();
        push_part(&mut items, inside.sections);
        items.extend(inside.items);
        programs.push(items);
    }
    let stays = stays::texts(&parts, order, &programs);
    let is_drawn = |block: &&BlockItems<'_>| !stays.contains_key(&std::ptr::from_ref(block.unit));
    let blocks = parts.blocks.iter().filter(is_drawn);
    let blocks = blocks.flat_map(|block| &block.items).cloned().chain(parts.unread);
    let blocks = blocks.skip_while(|item| *item == Item::Blank).collect();
    let mut names = Names::default();
    let mut file = |name: &str, content: Content| {
        let plain: String = name
            .chars()
            .map(|c| if c.is_ascii_alphanumeric() { c } else { '_' })
            .collect();
        let ending = match content {
            Content::Text(_) => "st",
            _ => "clad",
        };
        let name = format!("{}.{ending}", names.fresh(&plain));
        ProjectFile { name, content }
    };
    let mut files = Vec::new();
    for (name, items) in [
        ("types", parts.types),
        ("globals", parts.globals),
        ("blocks", blocks),
    ] {
        if !items.is_empty() {
            files.push(file(name, Content::Program(ProgramSketch { items })));
        }
    }
    for block in &parts.blocks {
        if let Some(text) = stays.get(&std::ptr::from_ref(block.unit)) {
            files.push(file(&block.unit.name, Content::Text(text.clone())));
        }
    }
    let mut tasks: Vec<ProjectTask> = Vec::new();
    for (run, items) in order.iter().zip(programs) {
        let content = match stays.get(&std::ptr::from_ref(run.unit)) {
            Some(text) => Content::Text(text.clone()),
            None => Content::Program(ProgramSketch { items }),
        };
        let file = file(&run.unit.name, content);
        if let Some(task) = run.task.and_then(|task| project_task(project, task)) {
            let there = tasks.iter_mut().find(|other| other.name == task.name);
            match there {
                Some(other) => other.programs.push(file.name.clone()),
                None => tasks.push(ProjectTask {
                    programs: vec![file.name.clone()],
                    ..task
                }),
            }
        }
        files.push(file);
    }
    let settings = format!(
        "# {}\n",
        project
            .comments
            .first()
            .map_or("A project", |told| told.trim())
            .replace(char::is_control, " ")
    );
    files.push(ProjectFile {
        name: "ladder.toml".to_owned(),
        content: Content::Settings(settings, tasks),
    });
    files
}

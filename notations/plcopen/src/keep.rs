//! A project in which only what was changed in its ladder text is written again.
//!
//! A drawing has its own numbers and places, so a unit of which anything is changed is written again as a whole; and so are those that
//! call it, or that it calls, where its pins are others now. All else stays to the letter.

use crate::graph::Kind;
use crate::model::{Body, Project, Role, Task, Type, Unit, UnitKind, Variable};
use crate::write::texts::function_as_block;
use crate::{emit, read, write};
use ladder_analysis::Analysis;
use ladder_notation::kept::{Rules, merge};
use ladder_notation::{
    Entry, Kept, LineColumn, Outcome, Project as Files, ReadError, Report, WriteError, WrittenProject,
    without_known,
};
use roxmltree::Node;
use std::collections::{HashMap, HashSet};

/// How elements of a project are known again.
const RULES: Rules = Rules {
    key,
    says: |_| None,
    is_whole: |own, _| matches!(own.tag_name().name(), "pou" | "dataType" | "variable"),
    text: |_, _, _, now| Some(now.to_owned()),
    // Of instances it is the number.
    number: "name",
    together: &[],
    repeats: |_, _| false,
    used_by: |node| match node.tag_name().name() {
        "pou" | "dataType" => node.attribute("name").map(str::to_owned),
        _ => None,
    },
};

fn key(node: Node<'_, '_>) -> Option<String> {
    let attribute = match node.tag_name().name() {
        "pou" | "dataType" | "variable" | "task" => "name",
        "pouInstance" => "typeName",
        _ => return None,
    };
    node.attribute(attribute).map(str::to_owned)
}

/// Writes the files of a folder into the project that they come from.
pub(crate) fn write(files: &Files, kept: &Kept<'_>) -> Result<WrittenProject, WriteError> {
    let broken = |error: ReadError| WriteError::new(error.to_string());
    let original = kept.source.text_of_project().map_err(broken)?;
    let there = read::project(original).map_err(broken)?;
    let is_alone = kept.before.count() < 2;
    let name = |files: &Files, number: usize| program_of(&there, files.stem(number), is_alone && number == 0);
    let (mut before, known) = write::files::project(kept.before, |number| name(kept.before, number))?;
    let (mut after, mut reports) = write::files::project(files, |number| name(files, number))?;
    keep_globals(original, &mut before, &mut after, &mut reports)?;
    for project in [&mut before, &mut after] {
        name_as_there(&there, project);
    }
    let [was, now] = [&before, &after].map(|project| project.tasks.clone());
    before.tasks = tasks(&there, &before);
    after.tasks = tasks(&there, &after);
    if files.tasks() != kept.before.tasks() {
        change_tasks(&mut after.tasks, &was, &now);
    }
    let program = |number: usize| name(files, number);
    let broken_units = keep_broken(
        (original, &there),
        files,
        &before,
        &mut after,
        &mut reports,
        program,
    );
    let drawn = drawn_anew(&there, &before, &after);
    for (number, report) in reports.iter_mut().enumerate() {
        let was = (0..kept.before.count()).find(|was| kept.before.file(*was) == files.file(number));
        let Some(was) = was else { continue };
        // What is not drawn again is as it was, whatever there is to say of it.
        let analysis = files.analysis_of(number);
        let is_drawn = |entry: &&Entry| {
            let unit = unit_at(entry, analysis, &program(number));
            drawn.contains(&unit) || broken_units.contains(&unit)
        };
        let of_drawn: Vec<Entry> = report.entries.iter().filter(is_drawn).cloned().collect();
        without_known(report, analysis, &known[was], kept.before.analysis_of(was));
        for entry in of_drawn {
            if !report.entries.contains(&entry) {
                report.entries.push(entry);
            }
        }
        report.entries.sort_by_key(|entry| entry.place);
    }
    for name in &drawn {
        let (own, now) = (unit_of(&there, name), unit_of(&after, name));
        let Some((own, now)) = own.zip(now) else { continue };
        if unit_of(&before, name).is_some_and(|was| text_of(was) == text_of(now)) {
            let why = "it is drawn again, as the pins of what it calls, or its own, are others now";
            reports[0].approximated(LineColumn::START, format!("unit {}", own.name), why);
        }
        if let Some(unit) = before.units.iter_mut().find(|unit| is(unit, name)) {
            // So it is another one.
            unit.comment = Some("written again".to_owned());
        }
    }
    let [old, new] = [before, after].map(emit::project);
    // What the head says is not in ladder text.
    let new = match (head(&old), head(&new)) {
        (Some(old), Some(own)) => new.replacen(own, old, 1),
        _ => new,
    };
    let [old, new] = [old, new].map(|text| as_named_there(original, text));
    let merged = merge(original, &old, &new, &RULES).map_err(broken)?;
    Ok(WrittenProject {
        bytes: merged.into_bytes(),
        reports,
    })
}

/// The tag with the name of a project.
fn head(text: &str) -> Option<&str> {
    let start = text.find("<contentHeader")?;
    Some(&text[start..start + text[start..].find('>')?])
}

/// The elements of a text with the prefixes of a file.
fn as_named_there(original: &str, text: String) -> String {
    let text = if original.contains("xmlns:xhtml=") {
        text
    } else {
        text.replace("<xhtml:p>", XHTML)
    };
    let root = original
        .find("project")
        .and_then(|end| original[..end].rsplit_once('<'));
    let Some((_, prefix)) = root.filter(|(_, prefix)| prefix.ends_with(':')) else {
        return text;
    };
    let mut out = String::with_capacity(text.len());
    for (number, part) in text.split('<').enumerate() {
        if number > 0 {
            out.push('<');
        }
        let (end, tag) = match part.strip_prefix('/') {
            Some(tag) => ("/", tag),
            None => ("", part),
        };
        let name = tag
            .split(|c: char| !c.is_alphanumeric() && c != ':')
            .next()
            .unwrap_or_default();
        out.push_str(end);
        if number > 0 && !name.is_empty() && !name.contains(':') {
            out.push_str(prefix);
        }
        out.push_str(tag);
    }
    out.replacen("xmlns=", &format!("xmlns:{}=", prefix.trim_end_matches(':')), 1)
}

/// A paragraph in a file that has no name for its namespace.
const XHTML: &str = "<xhtml:p xmlns:xhtml=\"http://www.w3.org/1999/xhtml\">";

/// The unit that an entry of a report on a file is about, in small letters.
fn unit_at(entry: &Entry, analysis: &Analysis, program: &str) -> String {
    let context = &analysis.context;
    let line = (entry.place.line as usize).saturating_sub(1);
    let mut blocks = context.parse.structure().blocks.iter();
    match blocks.position(|block| block.lines.contains(&line)) {
        Some(block) => context.user_blocks[block]
            .name
            .trim_start_matches('$')
            .to_lowercase(),
        None => program.to_lowercase(),
    }
}

fn text_of(unit: &Unit) -> String {
    emit::unit_text(unit.clone())
}

/// Units of which not all can be written stay as the file has them. They come back, in small letters.
fn keep_broken(
    (original, there): (&str, &Project),
    files: &Files,
    before: &Project,
    after: &mut Project,
    reports: &mut [Report],
    program: impl Fn(usize) -> String,
) -> HashSet<String> {
    let refused = reports.iter().enumerate().flat_map(|(number, report)| {
        let refused = report
            .entries
            .iter()
            .filter(|entry| matches!(entry.outcome, Outcome::Refused(_)));
        refused.map(move |entry| (number, entry))
    });
    let mut lossy: HashSet<String> = refused
        .map(|(number, entry)| unit_at(entry, files.analysis_of(number), &program(number)))
        .collect();
    for number in 0..files.count() {
        let blocks = files.analysis_of(number).context.user_blocks.iter();
        let unread = blocks.filter(|block| block.unread.is_some());
        lossy.extend(unread.map(|block| block.name.trim_start_matches('$').to_lowercase()));
    }
    let mut broken = HashSet::new();
    loop {
        let drawn = drawn_anew(there, before, after);
        let is_broken = |name: &String| {
            let (Some(own), Some(now)) = (unit_of(there, name), unit_of(after, name)) else {
                return false;
            };
            let was_function = own.kind == UnitKind::Function && now.kind != own.kind;
            let is_text = matches!(now.body, Body::Text(..));
            let is_called_otherwise = function_as_block(now, after).is_some();
            (lossy.contains(name) && !is_text)
                || is_called_otherwise
                || (was_function && in_text(original, there, name))
        };
        let found: Vec<String> = drawn.iter().filter(|name| is_broken(name)).cloned().collect();
        let is_changed = |name: &String| {
            let was = unit_of(before, name).zip(unit_of(after, name));
            was.is_some_and(|(was, now)| text_of(was) != text_of(now))
        };
        if found.is_empty() {
            return broken;
        }
        // One that is only called by what is changed cannot be drawn again either: then nothing is.
        let back: Vec<String> = if found.iter().all(is_changed) {
            found
        } else {
            drawn.iter().filter(|name| is_changed(name)).cloned().collect()
        };
        if back.is_empty() {
            return broken;
        }
        for name in back {
            let was = unit_of(before, &name).cloned();
            if let (Some(now), Some(was)) = (after.units.iter_mut().find(|unit| is(unit, &name)), was) {
                let why = "not all of it, or of what is drawn again with it, can be written: it stays as the file has it; change it there";
                reports[0].refused(LineColumn::START, format!("unit {}", was.name), why);
                *now = was;
            }
            broken.insert(name);
        }
    }
}

fn unit_of<'p>(project: &'p Project, name: &str) -> Option<&'p Unit> {
    project.units.iter().find(|unit| is(unit, name))
}

/// Whether a text that is not drawn names a unit.
fn in_text(original: &str, there: &Project, name: &str) -> bool {
    let has_texts = there
        .units
        .iter()
        .any(|unit| matches!(unit.body, Body::Text(..) | Body::Chart(_)) || !unit.parts.is_empty());
    let mut words = original.split(|c: char| !c.is_alphanumeric() && c != '_');
    has_texts && words.any(|word| word.eq_ignore_ascii_case(name))
}

/// Names a type as the file does.
fn rename(ty: &mut Type, names: &HashMap<String, String>) {
    match ty {
        Type::Named(name) => {
            if let Some(own) = names.get(&name.to_lowercase()) {
                name.clone_from(own);
            }
        }
        Type::Array(_, element) => rename(element, names),
        _ => {}
    }
}

/// Calls units as the file does, where the writer has another name for them, and leaves out what the head of the file says.
fn name_as_there(there: &Project, project: &mut Project) {
    let mut names: HashMap<String, String> = HashMap::new();
    for unit in &there.units {
        let written = write::identifier(&unit.name);
        if written != unit.name && unit_of(there, &written).is_none() {
            names.insert(written.to_lowercase(), unit.name.clone());
        }
    }
    for unit in &mut project.units {
        if let Some(own) = names.get(&unit.name.to_lowercase()) {
            unit.name.clone_from(own);
        }
        for variable in &mut unit.variables {
            rename(&mut variable.ty, &names);
        }
        if let Body::Graph(graph) = &mut unit.body {
            for node in &mut graph.nodes {
                if let Kind::Block { name, .. } = &mut node.kind
                    && let Some(own) = names.get(&name.to_lowercase())
                {
                    name.clone_from(own);
                }
            }
        }
        for told in &there.comments {
            let rest = unit
                .comment
                .as_deref()
                .and_then(|comment| comment.trim().strip_prefix(told.trim()));
            if let Some(rest) = rest {
                unit.comment = Some(rest.trim().to_owned()).filter(|rest| !rest.is_empty());
            }
        }
    }
    for global in &mut project.globals {
        rename(&mut global.ty, &names);
    }
    for (_, program) in project.tasks.iter_mut().flat_map(|task| &mut task.programs) {
        if let Some(own) = names.get(&program.to_lowercase()) {
            program.clone_from(own);
        }
    }
}

fn is(unit: &Unit, name: &str) -> bool {
    unit.name.eq_ignore_ascii_case(name)
}

/// The program that a file is. One that is new is called as its file.
fn program_of(there: &Project, stem: &str, is_only: bool) -> String {
    let mut programs = there.units.iter().filter(|unit| unit.kind == UnitKind::Program);
    let plain = |name: &str| -> String {
        let plain = name
            .chars()
            .map(|c| if c.is_ascii_alphanumeric() { c } else { '_' });
        plain.collect::<String>().to_lowercase()
    };
    let stem_of_first = stem
        .trim_end_matches(|c: char| c.is_ascii_digit())
        .trim_end_matches('_');
    let by_name = |wanted: &str| {
        let mut programs = programs.clone();
        programs.find(|unit| plain(&unit.name) == wanted.to_lowercase())
    };
    let known = by_name(stem).or_else(|| by_name(stem_of_first));
    let only = || programs.next().filter(|_| is_only);
    known
        .or_else(only)
        .map_or_else(|| stem.to_owned(), |unit| unit.name.clone())
}

/// Variables for all units are where the file has them: what is not in its configuration is not changed.
fn keep_globals(
    original: &str,
    before: &mut Project,
    after: &mut Project,
    reports: &mut [Report],
) -> Result<(), WriteError> {
    let document =
        ladder_notation::xml::Xml::parse(original).map_err(|error| WriteError::new(error.to_string()))?;
    let all = document.document.descendants();
    let lists: Vec<_> = all
        .filter(|node| node.tag_name().name() == "globalVars")
        .collect();
    let in_configuration = |node: &Node<'_, '_>| {
        node.parent()
            .is_some_and(|parent| parent.tag_name().name() == "configuration")
    };
    let known: HashSet<String> = lists
        .iter()
        .filter(|list| in_configuration(list))
        .flat_map(Node::children)
        .filter_map(|node| Some(node.attribute("name")?.to_lowercase()))
        .collect();
    let index = |project: &Project| -> HashMap<String, Variable> {
        let globals = project.globals.iter();
        globals
            .map(|global| (global.name.to_lowercase(), global.clone()))
            .collect()
    };
    let (was, is) = (index(before), index(after));
    let same = |one: &Variable, other: &Variable| {
        one == other
            && (&one.initial, &one.address, &one.comment) == (&other.initial, &other.address, &other.comment)
    };
    let has_place = document
        .document
        .descendants()
        .any(|node| node.tag_name().name() == "configuration");
    let names: Vec<String> = was
        .keys()
        .chain(is.keys())
        .cloned()
        .collect::<HashSet<_>>()
        .into_iter()
        .collect();
    for name in names {
        let changed = match (was.get(&name), is.get(&name)) {
            (Some(was), Some(is)) => !same(was, is) && !known.contains(&name),
            (Some(_), None) => !known.contains(&name),
            (None, Some(_)) => !has_place,
            (None, None) => false,
        };
        if changed && let Some(report) = reports.first_mut() {
            let why =
                "the file has no variables for all units, or has this one at another place: change it there";
            report.refused(LineColumn::START, format!("tag {name}"), why);
            after
                .globals
                .retain(|global| !global.name.eq_ignore_ascii_case(&name));
            after.globals.extend(was.get(&name).cloned());
        }
    }
    // One list, in one order, with what is new at its end.
    let order: Vec<String> = before
        .globals
        .iter()
        .map(|global| global.name.to_lowercase())
        .collect();
    let place = |global: &Variable| {
        order
            .iter()
            .position(|name| *name == global.name.to_lowercase())
            .unwrap_or(order.len())
    };
    after.globals.sort_by_key(|global| place(global));
    Ok(())
}

/// The tasks of the file, with the programs that are there. What is new is run by the first.
fn tasks(there: &Project, project: &Project) -> Vec<Task> {
    let mut tasks = there.tasks.clone();
    let has = |name: &str| project.units.iter().any(|unit| is(unit, name));
    let known = |name: &str| there.units.iter().any(|unit| is(unit, name));
    for task in &mut tasks {
        task.programs.retain(|(_, name)| has(name) || !known(name));
    }
    let programs = project.units.iter().filter(|unit| unit.kind == UnitKind::Program);
    let new = programs.filter(|unit| !known(&unit.name));
    if let Some(first) = tasks.first_mut() {
        first
            .programs
            .extend(new.map(|unit| (LineColumn::START, unit.name.clone())));
    }
    tasks
}

/// Tasks with what of them is otherwise now.
fn change_tasks(tasks: &mut Vec<Task>, was: &[Task], now: &[Task]) {
    let find = |tasks: &[Task], name: &str| {
        let mut tasks = tasks.iter();
        tasks.position(|task| task.name.eq_ignore_ascii_case(name))
    };
    tasks.retain(|task| find(was, &task.name).is_none() || find(now, &task.name).is_some());
    let names = |task: &Task| -> Vec<String> {
        let names = task.programs.iter().map(|(_, name)| name.to_lowercase());
        names.collect()
    };
    let known: HashSet<String> = was.iter().chain(now).flat_map(names).collect();
    for own in now {
        let before = find(was, &own.name).map(|at| &was[at]);
        let Some(at) = find(tasks, &own.name) else {
            tasks.push(own.clone());
            continue;
        };
        let task = &mut tasks[at];
        if before.is_none_or(|before| before.interval != own.interval) {
            task.interval.clone_from(&own.interval);
            task.event = None;
        }
        if before.is_none_or(|before| before.priority != own.priority) {
            task.priority = own.priority;
        }
        // What no file of the folder is stays.
        if before.is_none_or(|before| names(before) != names(own)) {
            let rest = task.programs.drain(..);
            let rest: Vec<_> = rest
                .filter(|(_, name)| !known.contains(&name.to_lowercase()))
                .collect();
            task.programs.clone_from(&own.programs);
            task.programs.extend(rest);
        }
    }
    // A program that has moved to another task.
    for task in tasks {
        let own: Vec<String> = find(now, &task.name).map_or_else(Vec::new, |at| names(&now[at]));
        let others: HashSet<String> = now.iter().flat_map(names).collect();
        task.programs.retain(|(_, name)| {
            let name = name.to_lowercase();
            own.contains(&name) || !others.contains(&name)
        });
    }
}

/// The units that are written again, in small letters: those that are changed, and those that call one of them or are called by one, where the file
/// has other pins.
fn drawn_anew(there: &Project, before: &Project, after: &Project) -> HashSet<String> {
    let index = |project: &Project| -> HashMap<String, Unit> {
        let units = project.units.iter();
        units
            .map(|unit| (unit.name.to_lowercase(), unit.clone()))
            .collect()
    };
    let (own, was, now) = (index(there), index(before), index(after));
    let is_changed = |name: &String| match (was.get(name), now.get(name)) {
        (Some(was), Some(now)) => text_of(was) != text_of(now),
        (None, Some(_)) => true,
        _ => false,
    };
    // What is called otherwise than the file has it.
    let has_other_pins = |name: &String| match (own.get(name), now.get(name)) {
        (Some(own), Some(now)) => pins(own) != pins(now),
        _ => false,
    };
    let calls: HashMap<&String, HashSet<String>> =
        now.iter().map(|(name, unit)| (name, called(unit))).collect();
    let mut again: HashSet<String> = now.keys().filter(|name| is_changed(name)).cloned().collect();
    loop {
        let more: Vec<String> = calls
            .iter()
            .flat_map(|(caller, called)| called.iter().map(move |called| (*caller, called)))
            .filter(|(_, called)| has_other_pins(called))
            .flat_map(|(caller, called)| {
                let of_called = again.contains(caller).then(|| called.clone());
                let of_caller = again.contains(called).then(|| caller.clone());
                of_called.into_iter().chain(of_caller)
            })
            .filter(|name| !again.contains(name))
            .collect();
        if more.is_empty() {
            break;
        }
        again.extend(more);
    }
    again
}

/// How a unit looks from outside.
fn pins(unit: &Unit) -> Vec<(u8, String)> {
    let kind = |role: Role| match role {
        Role::Input => Some(0),
        Role::Output => Some(1),
        Role::InOut => Some(2),
        _ => None,
    };
    let pins = unit
        .variables
        .iter()
        .filter_map(|variable| Some((kind(variable.role)?, variable.name.to_lowercase())));
    let mut pins: Vec<(u8, String)> = pins.collect();
    pins.sort();
    pins
}

/// What a unit calls or has instances of, in small letters.
fn called(unit: &Unit) -> HashSet<String> {
    fn named(ty: &Type, out: &mut HashSet<String>) {
        match ty {
            Type::Named(name) => {
                out.insert(name.to_lowercase());
            }
            Type::Array(_, element) => named(element, out),
            _ => {}
        }
    }
    let mut out = HashSet::new();
    for variable in &unit.variables {
        named(&variable.ty, &mut out);
    }
    if let Body::Graph(graph) = &unit.body {
        for node in &graph.nodes {
            if let Kind::Block { name, .. } = &node.kind {
                out.insert(name.to_lowercase());
            }
        }
    }
    out
}

//! A unit: its variables, and what it does.

use super::body::{Body as Networks, Made};
use super::chart;
use super::declare;
use super::structured::{self, Seen};
use super::tasks::{When, shortest};
use super::texts;
use crate::model::{Body, Part, Project, Type, Unit, UnitKind, WORKSHEET};
use crate::scope::{Scope, Shared};
use ladder_format::program::{Block, Drawing, Element, Item, Network, ProgramSketch};
use ladder_format::{Circuit, Options};
use ladder_notation::chart::Clock;
use ladder_notation::{Outcome, Power, Reading, Unread, UnreadParts, unread_body};
use std::collections::{HashMap, HashSet};

/// Where a unit's networks stand.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Place {
    /// In the main program.
    Program,
    /// In a function of the file that others call.
    Function,
    /// In a block of one's own.
    Block,
}

/// What a unit became.
pub(super) struct Inside {
    pub(super) sections: Vec<Item>,
    pub(super) items: Vec<Item>,
    /// With the names that its networks took.
    pub(super) scope: Scope,
    /// What its body is, where nothing of it is read.
    pub(super) about: Option<String>,
}

/// What becomes of something that is not read.
pub(super) const UNREAD: &str = "a scan runs past it, and what it may write is not known";

/// A unit as it is written at a place.
pub(super) fn unit_items(
    seen: &Seen<'_>,
    unit: &Unit,
    scope: Scope,
    (place, when): (Place, When<'_>),
    unread: &mut UnreadParts,
    reading: &mut Reading,
) -> Inside {
    let Seen { shared, project, .. } = *seen;
    let what = match unit.kind {
        UnitKind::Program => "program",
        UnitKind::Function => "function",
        UnitKind::FunctionBlock => "function block",
    };
    reading
        .report
        .translated(unit.place, format!("{what} {}", unit.name));
    let mut made = Made {
        unread: std::mem::take(unread),
        ..Made::of(scope)
    };
    if unit.kind == UnitKind::Program {
        made.items.extend(unit.comment.iter().cloned().map(Item::Comment));
    }
    let structured = match &unit.body {
        Body::Chart(drawn) => {
            made.actions = actions(shared, project, unit, reading);
            let clock = match (place, when) {
                (Place::Block, _) | (_, When::AtTimes(_)) => Clock::AtCalls,
                _ => Clock::EachScan,
            };
            let interval = shortest(project);
            Some(chart::body(
                seen,
                (unit, drawn),
                clock,
                interval,
                &mut made,
                reading,
            ))
        }
        _ => structured::text(unit).map(|text| structured::body(seen, unit, text, &mut made, reading)),
    };
    let is_read = matches!(structured, Some(Ok(())));
    let boxes = match structured {
        None => texts::read(seen, unit, &mut made, reading),
        Some(_) => Ok(()),
    };
    let why = structured.and_then(Result::err).or(boxes.clone().err());
    let whole = if is_read {
        None
    } else {
        whole(shared, unit, (&made.scope, boxes.is_err()), reading)
    };
    let about = whole.as_ref().map(|(language, _)| {
        let what = format!("{} ({language})", unit.name);
        let because = why.as_ref().map_or_else(String::new, |why| format!(" ({why})"));
        (format!("{what} is not read{because}: {UNREAD}."), what)
    });
    if let (Some((_, text)), Some((about, name))) = (&whole, &about) {
        match (place, when) {
            (Place::Block, _) => made.items.extend(unread_body(text, None)),
            (_, When::Never) => made.items.extend([Item::Blank, Item::Comment(text.clone())]),
            _ => {
                let part = Unread {
                    name,
                    about,
                    text,
                    writes: None,
                    power: Power::Passes,
                    turn: when.turn(),
                };
                let block = made.unread.body(part, |name| shared.has_block(name));
                made.items.extend(network(block, unit.place, reading));
            }
        }
    } else {
        if !is_read {
            made.actions = actions(shared, project, unit, reading);
        }
        if let Body::Graph(graph) = &unit.body {
            Networks::draw(shared, graph, &mut made, reading);
        }
        for part in &unit.parts {
            if made.in_place.contains(&part.name.to_lowercase()) {
                let shown = format!("{} {}", part.what, part.name);
                reading.report.translated(part.place, shown);
            } else if !chart::has(unit, part) {
                part_items(shared, (unit, part), (place, when), &mut made, reading);
            }
        }
    }
    let Made {
        scope,
        items,
        helpers,
        declared,
        needed,
        unread: parts,
        actions: _,
        texts: _,
        in_place: _,
    } = made;
    *unread = parts;
    let is_needed = |name: &str| needed.contains(&name.to_lowercase());
    let mut sections = declare::variables(shared, project, unit, &scope, is_needed, reading);
    for (name, ty, comment) in helpers {
        sections.helper(&name, &ty, &comment, None);
    }
    for tag in declared {
        sections.declared(tag);
    }
    Inside {
        sections: sections.items(),
        items,
        scope,
        about: about.map(|(about, _)| about),
    }
}

/// A network with a block alone.
pub(super) fn network(block: Block, place: ladder_notation::LineColumn, reading: &mut Reading) -> [Item; 2] {
    let origin = reading.origin(place);
    let network = Network {
        comments: Vec::new(),
        drawing: Drawing::Circuit(Circuit::Element(Element::of(block, Some(origin)))),
    };
    [Item::Blank, Item::Network(network)]
}

/// The language and the text of a unit of which nothing is read: its body is a text or a chart, or a text in it may end its run, and
/// with that what comes after it.
fn whole(
    shared: &Shared<'_>,
    unit: &Unit,
    (scope, box_leaves): (&Scope, bool),
    reading: &mut Reading,
) -> Option<(&'static str, String)> {
    let sheets = unit.parts.iter().filter(|part| part.what == WORKSHEET);
    let mut bodies = sheets.map(|part| &part.body).chain([&unit.body]);
    let (language, text) = match &unit.body {
        Body::Text(language, text, _) => (*language, text.clone()),
        Body::Chart(drawn) => {
            let lines: Vec<&str> = drawn.shown.iter().map(|(_, told)| told.as_str()).collect();
            ("SFC", lines.join("\n"))
        }
        body if box_leaves || bodies.any(may_leave) => ("LD", text_of(shared, body, scope, reading)),
        _ => return None,
    };
    let shown = format!("body of {}", unit.name);
    reading
        .report
        .approximated(unit.place, shown, format!("{language} is not read: {UNREAD}"));
    let mut all = text;
    for part in &unit.parts {
        let mut scope = scope.clone();
        if part.what == "transition" {
            scope.declare(&part.name, &Type::Named("BOOL".to_owned()), "");
        }
        let shown = format!("{} {}", part.what, part.name);
        let text = text_of(shared, &part.body, &scope, reading);
        all.push_str(&format!("\n\n{shown}:\n{text}"));
        let why = format!("it is part of what is not read: {UNREAD}");
        reading.report.approximated(part.place, shown, why);
    }
    Some((language, all))
}

/// The texts of the actions and methods that boxes of a unit call, whatever unit has them.
fn actions(
    shared: &Shared<'_>,
    project: &Project,
    unit: &Unit,
    reading: &mut Reading,
) -> HashMap<String, String> {
    let bodies = unit.parts.iter().map(|part| &part.body).chain([&unit.body]);
    let names = bodies.filter_map(|body| match body {
        Body::Graph(graph) => Some(graph.blocks()),
        _ => None,
    });
    let names: HashSet<String> = names.flatten().map(action_name).collect();
    let mut actions: HashMap<String, String> = HashMap::new();
    for owner in &project.units {
        let is_called = |part: &&Part| part.what != WORKSHEET && names.contains(&action_name(&part.name));
        let mut parts = owner.parts.iter().filter(is_called).peekable();
        if parts.peek().is_none() {
            continue;
        }
        let block = shared.blocks.get(&owner.name.to_lowercase());
        let scope = block.map_or_else(|| shared.program(owner, None), |block| block.scope.clone());
        for part in parts {
            let text = text_of(shared, &part.body, &scope, reading);
            let all = actions.entry(action_name(&part.name)).or_default();
            all.push_str(&format!("{} of {}:\n{text}\n", part.name, owner.name));
        }
    }
    actions
}

/// What a box calls, by the name of the action alone, in small letters.
pub(super) fn action_name(name: &str) -> String {
    name.rsplit('.').next().unwrap_or_default().to_lowercase()
}

/// Whether a text in a body may end the run of the unit that it is in.
fn may_leave(body: &Body) -> bool {
    matches!(body, Body::Text(_, text, _) if texts::may_leave(text))
}

/// What is in a body, as a text: of what is drawn the ladder that it is here.
fn text_of(shared: &Shared<'_>, body: &Body, scope: &Scope, reading: &mut Reading) -> String {
    match body {
        Body::Empty => String::new(),
        Body::Text(_, text, _) | Body::Ladder(text) => text.clone(),
        Body::Chart(drawn) => {
            let lines: Vec<&str> = drawn.shown.iter().map(|(_, told)| told.as_str()).collect();
            lines.join("\n")
        }
        Body::Graph(graph) => {
            let mut aside = Reading::default();
            let mut made = Made::of(scope.clone());
            Networks::draw(shared, graph, &mut made, &mut aside);
            // What cannot be drawn is in no text either.
            let mut entries = aside.report.entries;
            entries.retain(|entry| matches!(entry.outcome, Outcome::Refused(_)));
            reading.report.entries.extend(entries);
            let items = made.unread.items().chain(made.items).collect();
            let written = ProgramSketch { items }.write(&Options::default());
            written.text.trim().to_owned()
        }
    }
}

/// A further body, or an action, which is a function that nothing calls, and in a block is after its end.
fn part_items(
    shared: &Shared<'_>,
    (unit, part): (&Unit, &Part),
    (place, when): (Place, When<'_>),
    made: &mut Made,
    reading: &mut Reading,
) {
    let shown = format!("{} {}", part.what, part.name);
    if part.what == WORKSHEET {
        match &part.body {
            Body::Graph(graph) => Networks::draw(shared, graph, made, reading),
            Body::Empty => {}
            body => {
                let text = text_of(shared, body, &made.scope, reading);
                let name = format!("{shown} of {}", unit.name);
                let part_of = Unread {
                    name: &name,
                    about: &format!("{name} is not read: {UNREAD}."),
                    text: &text,
                    writes: None,
                    power: Power::Passes,
                    turn: when.turn(),
                };
                let block = made.unread.body(part_of, |name| shared.has_block(name));
                made.items.extend(network(block, part.place, reading));
                let why = format!("a text is not read: {UNREAD}");
                reading.report.approximated(part.place, shown, why);
            }
        }
        return;
    }
    if matches!(part.body, Body::Empty) {
        reading.report.translated(part.place, shown);
        return;
    }
    let why = match place {
        Place::Block => "nothing that is read runs it: it stands after the end of the block",
        _ => "nothing that is read runs it: it is a function that nothing calls",
    };
    reading.report.approximated(part.place, shown.clone(), why);
    let Body::Graph(graph) = &part.body else {
        let text = text_of(shared, &part.body, &made.scope, reading);
        made.items
            .extend([Item::Blank, Item::Comment(format!("{shown}:\n{text}"))]);
        return;
    };
    // A block has no functions of its own.
    let block = match place {
        Place::Block => Block::ret(),
        _ => Block::function(&made.scope.fresh(&part.name)),
    };
    made.items.extend([Item::Blank, Item::Comment(shown)]);
    let [_, begin] = network(block, part.place, reading);
    made.items.push(begin);
    Networks::draw(shared, graph, made, reading);
}

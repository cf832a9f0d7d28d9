//! A unit: its variables, and what it does.

use super::body::{Body as Networks, Made};
use super::declare;
use crate::model::{Body, Part, Project, Type, Unit, UnitKind};
use crate::scope::{Scope, Shared};
use ladder_analysis::Severity;
use ladder_format::Circuit;
use ladder_format::program::{Drawing, Element, Item, Network};
use ladder_notation::{Finding, LineColumn, Reading};
use std::collections::HashSet;

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
}

/// A unit as it is written at a place.
pub(super) fn unit_items(
    shared: &Shared<'_>,
    project: &Project,
    unit: &Unit,
    scope: Scope,
    place: Place,
    reading: &mut Reading,
) -> Inside {
    let what = match unit.kind {
        UnitKind::Program => "program",
        UnitKind::Function => "function",
        UnitKind::FunctionBlock => "function block",
    };
    reading
        .report
        .translated(unit.place, format!("{what} {}", unit.name));
    let mut made = Made {
        scope,
        items: Vec::new(),
        helpers: Vec::new(),
        needed: HashSet::new(),
    };
    if unit.kind == UnitKind::Program {
        made.items.extend(unit.comment.iter().cloned().map(Item::Comment));
    }
    body(
        shared, project, &unit.body, unit.place, &unit.name, &mut made, reading,
    );
    for part in &unit.parts {
        part_items(shared, project, part, place, &mut made, reading);
    }
    let Made {
        scope,
        items,
        helpers,
        needed,
    } = made;
    let is_needed = |name: &str| needed.contains(&name.to_lowercase());
    let mut sections = declare::variables(shared, project, unit, &scope, is_needed, reading);
    for (name, ty, comment) in helpers {
        sections.helper(&name, &ty, &comment, None);
    }
    Inside {
        sections: sections.items(),
        items,
        scope,
    }
}

/// What a body becomes.
fn body(
    shared: &Shared<'_>,
    project: &Project,
    body: &Body,
    place: LineColumn,
    name: &str,
    made: &mut Made,
    reading: &mut Reading,
) {
    match body {
        Body::Graph(graph) => Networks::draw(shared, project.evaluation, graph, made, reading),
        Body::Empty | Body::Ladder(_) => {}
        Body::Text(language, text) => {
            let why = format!("a body in {language} is not run here: its text is a comment");
            not_run(reading, place, format!("body of {name}"), &why);
            made.items.push(Item::Blank);
            made.items.push(Item::Comment(format!(
                "In {language}, which is not run here:\n{text}"
            )));
        }
        Body::Chart(shown) => {
            made.items.push(Item::Blank);
            let said: Vec<&str> = shown.iter().map(|(_, said)| said.as_str()).collect();
            made.items.push(Item::Comment(format!(
                "A chart of steps, which is not run here:\n{}",
                said.join("\n")
            )));
            let why = "a chart of steps is not run here: it is a comment";
            not_run(reading, place, format!("body of {name}"), why);
            for (place, said) in shown {
                reading.report.approximated(*place, said, why);
            }
        }
    }
}

/// An action, a transition, or what is drawn in a chart: a function that nothing calls, or in a block a comment.
fn part_items(
    shared: &Shared<'_>,
    project: &Project,
    part: &Part,
    place: Place,
    made: &mut Made,
    reading: &mut Reading,
) {
    let shown = format!("{} {}", part.what, part.name);
    if part.what == "transition" && made.scope.get(&part.name).is_none() {
        made.scope
            .declare(&part.name, &Type::Named("BOOL".to_owned()), "");
        let tag = made
            .scope
            .get(&part.name)
            .map_or(String::new(), |known| known.spelled.clone());
        made.helpers
            .push((tag, "BOOL".to_owned(), format!("what {shown} says")));
    }
    if matches!(part.body, Body::Empty) {
        reading.report.translated(part.place, shown);
        return;
    }
    if let Body::Graph(_) = part.body {
        let why = match place {
            Place::Block => "the chart that runs it is not run here: it stands after the end of the block",
            _ => "the chart that runs it is not run here: it is a function that nothing calls",
        };
        reading.report.approximated(part.place, shown.clone(), why);
        let origin = reading.origin(part.place);
        // A block has no functions of its own.
        let block = match place {
            Place::Block => "<RET>".to_owned(),
            _ => format!("<FUN>( {} )", made.scope.fresh(&part.name)),
        };
        made.items.extend([
            Item::Blank,
            Item::Comment(format!("{shown}: the chart that runs it is not run here")),
            Item::Network(Network {
                comments: Vec::new(),
                drawing: Drawing::Circuit(Circuit::Element(Element::block(block, Some(origin)))),
            }),
        ]);
    } else {
        made.items.extend([Item::Blank, Item::Comment(shown.clone())]);
    }
    body(shared, project, &part.body, part.place, &shown, made, reading);
}

/// What stays as a text, and the program around it runs.
pub(super) fn not_run(reading: &mut Reading, place: LineColumn, shown: String, why: &str) {
    reading.findings.push(Finding {
        place,
        severity: Severity::Warning,
        check: "plcopen-not-run",
        message: why.to_owned(),
    });
    reading.report.approximated(place, shown, why);
}

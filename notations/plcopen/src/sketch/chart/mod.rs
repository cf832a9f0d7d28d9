//! Charts: their texts and drawings are read as those of other bodies, and what they are together is lowered as every chart is.

mod conditions;
mod drawn;
mod sources;

use super::body::{Body as Networks, Made};
use super::structured::Seen;
use crate::chart::{Action as DrawnAction, Condition as Drawing, Drawn, Element, Flow, Kind, What, flow};
use crate::graph::Graph;
use crate::model::{Body, Evaluation, Part, Role, Unit, UnitKind, WORKSHEET};
use ladder_format::program::{Item, Path};
use ladder_notation::chart::{self, Act, Action, Association, Chart, Clock, Qualifier, Step, Transition};
use ladder_notation::{LineColumn, Reading};
use ladder_notation_st::read::{self as st, PartKind};
use std::collections::HashMap;

/// In nanoseconds.
const SECOND: u64 = 1_000_000_000;

/// What feeds something is followed no further.
const LONGEST: usize = 400;

/// Why a chart is not read: a sentence without its point.
type Read<T> = Result<T, String>;

/// Whether a part of a unit belongs to its chart: its actions and transitions.
pub(super) fn has(unit: &Unit, part: &Part) -> bool {
    let Body::Chart(drawn) = &unit.body else {
        return false;
    };
    let is_it = |name: &String| name.eq_ignore_ascii_case(&part.name);
    drawn.elements.iter().any(|element| match &element.kind {
        Kind::Transition {
            condition: Drawing::Named(name),
            ..
        } => part.what == "transition" && is_it(name),
        Kind::Actions(actions) => {
            let named = |action: &DrawnAction| matches!(&action.what, What::Named(name) if is_it(name));
            part.what == "action" && actions.iter().any(named)
        }
        _ => false,
    })
}

/// Reads the chart that is a unit's body; scans take so many nanoseconds, where that is known.
///
/// # Errors
///
/// What keeps it from being read; nothing of it is in what was made so far.
pub(super) fn body(
    seen: &Seen<'_>,
    (unit, drawn): (&Unit, &Drawn),
    clock: Clock,
    interval: Option<u64>,
    made: &mut Made,
    reading: &mut Reading,
) -> Read<()> {
    let before = (made.scope.clone(), made.needed.clone(), made.unread.clone());
    let lengths = (made.items.len(), made.helpers.len());
    let told = (reading.places.len(), reading.report.entries.len());
    let mut reader = Reader {
        seen,
        unit,
        drawn,
        made,
        reading,
        tags: HashMap::new(),
    };
    let read = reader.chart(clock, interval);
    if read.is_err() {
        (made.scope, made.needed, made.unread) = before;
        made.items.truncate(lengths.0);
        made.helpers.truncate(lengths.1);
        reading.places.truncate(told.0);
        reading.report.entries.truncate(told.1);
    }
    read
}

/// A text of the chart: where it is, and what it says.
struct Text<'u> {
    told: &'u str,
    place: LineColumn,
    kind: PartKind,
}

/// Where the networks of a condition or an action come from.
enum Source<'u> {
    /// The text of this number.
    Text(usize),
    /// A drawing. Of a condition: the element that it ends at.
    Graph(&'u Graph, usize),
    Nothing,
}

struct Reader<'r, 's, 'u> {
    seen: &'r Seen<'s>,
    unit: &'u Unit,
    drawn: &'u Drawn,
    made: &'r mut Made,
    reading: &'r mut Reading,
    /// The tags of each step that are its `X` and `T`.
    tags: HashMap<usize, (String, String)>,
}

impl<'u> Reader<'_, '_, 'u> {
    fn chart(&mut self, clock: Clock, interval: Option<u64>) -> Read<()> {
        self.check()?;
        let at = |(place, why): (LineColumn, String)| format!("line {}: {why}", place.line);
        let flow = flow(self.drawn).map_err(at)?;
        self.steps(&flow)?;
        let mut texts = Vec::new();
        let conditions = flow.transitions.iter().map(|(number, ..)| *number);
        let conditions: Vec<Source<'u>> = conditions
            .map(|number| {
                let element = &self.drawn.elements[number];
                self.condition_source(element, &mut texts)
                    .map_err(|why| at((element.place, why)))
            })
            .collect::<Read<_>>()?;
        let (actions, associations) = self.actions(&flow, &mut texts)?;
        let mut bodies = self.texts(&texts)?;
        let mut drawings = self.drawings(&flow, &conditions).map_err(at)?;
        let mut chart = Chart {
            counts_late: interval.is_none_or(|interval| interval % SECOND != 0),
            ..Chart::default()
        };
        let mut places = HashMap::new();
        for ((number, _), associations) in flow.steps.iter().zip(associations) {
            let element = &self.drawn.elements[*number];
            let Kind::Step { name, is_initial } = &element.kind else {
                continue;
            };
            let Some((active, elapsed)) = self.tags.get(number).cloned() else {
                continue;
            };
            places.insert(*number, chart.steps.len());
            chart.steps.push(Step {
                name: name.clone(),
                active,
                elapsed,
                is_initial: *is_initial,
                associations,
                origin: Some(self.reading.origin(element.place)),
            });
            let shown = format!("step {name}");
            self.reading.report.translated(element.place, shown);
        }
        for ((number, from, to), source) in flow.transitions.iter().zip(conditions) {
            let element = &self.drawn.elements[*number];
            let condition = match drawings.conditions.remove(number) {
                Some((cone, tag)) => self.drawn_condition(&cone, &tag),
                None => self.condition(source, &mut bodies),
            };
            let condition = condition.map_err(|why| at((element.place, why)))?;
            let ends = |steps: &[usize]| -> Option<Vec<usize>> {
                steps.iter().map(|step| places.get(step).copied()).collect()
            };
            let (Some(from), Some(to)) = (ends(from), ends(to)) else {
                let why = "a step that nothing leads to is before it".to_owned();
                return Err(at((element.place, why)));
            };
            let priority = priority(element).map_err(|why| at((element.place, why)))?;
            chart.transitions.push(Transition {
                from,
                to,
                priority,
                condition,
                origin: Some(self.reading.origin(element.place)),
            });
            self.reading.report.translated(element.place, "transition");
        }
        for (name, place, source) in actions {
            let act = match source {
                Done::Variable(path) => Act::Variable(path),
                Done::Body(source) => Act::Body(self.items(source, &mut bodies)),
            };
            let origin = Some(self.reading.origin(place));
            chart.actions.push(Action { name, act, origin });
        }
        if !drawings.apart.graph.nodes.is_empty() {
            self.runs_apart(&drawings.apart.graph, &mut chart);
        }
        for number in &flow.unreached {
            let element = &self.drawn.elements[*number];
            let shown = match &element.kind {
                Kind::Step { name, .. } => format!("step {name}"),
                _ => "transition".to_owned(),
            };
            let why = "nothing leads to it from an initial step: it never runs";
            self.reading.report.approximated(element.place, shown, why);
        }
        let scope = &mut self.made.scope;
        let lowered = chart::lower(chart, clock, &mut |like| scope.fresh(like))?;
        self.made.items.push(Item::Blank);
        self.made.items.extend(lowered.items);
        self.made.declared.extend(lowered.tags);
        Ok(())
    }

    /// What runs apart from the conditions is an action after those of the first step.
    fn runs_apart(&mut self, graph: &Graph, chart: &mut Chart) {
        let Some(first) = chart.steps.first() else { return };
        let actions = first.associations.iter().map(|one| one.action + 1);
        let place = actions.max().unwrap_or(0);
        let associations = chart.steps.iter_mut().flat_map(|step| &mut step.associations);
        for association in associations.filter(|one| one.action >= place) {
            association.action += 1;
        }
        let action = Action {
            name: "blocks of conditions".to_owned(),
            act: Act::Body(self.draw(graph)),
            origin: None,
        };
        chart.actions.insert(place, action);
        let stored = Association {
            action: place,
            qualifier: Qualifier::Stored,
        };
        chart.steps[0].associations.push(stored);
    }

    /// What no chart has that is read.
    fn check(&self) -> Read<()> {
        let shared = self.seen.shared;
        if shared.evaluation == Evaluation::Once {
            return Err("CODESYS runs the actions of a chart before its transitions".to_owned());
        }
        if self.unit.kind == UnitKind::Function {
            return Err("a function keeps nothing, so it has no chart".to_owned());
        }
        if self.unit.parts.iter().any(|part| part.what == WORKSHEET) {
            return Err("it has further bodies".to_owned());
        }
        if self.unit.variables.iter().any(|one| one.role == Role::Temp) {
            return Err("its temporary variables begin again in each scan".to_owned());
        }
        Ok(())
    }

    /// Tags for the steps.
    fn steps(&mut self, flow: &Flow) -> Read<()> {
        for (number, _) in &flow.steps {
            let element = &self.drawn.elements[*number];
            let Kind::Step { name, .. } = &element.kind else {
                continue;
            };
            let scope = &mut self.made.scope;
            if scope.get(name).is_some() {
                return Err(format!("a step and a variable are called {name}"));
            }
            let active = scope.fresh(name);
            let elapsed = scope.fresh(&format!("{name}_T"));
            scope.step(name, Path::tag(&active), Path::tag(&elapsed));
            self.tags.insert(*number, (active, elapsed));
        }
        Ok(())
    }

    /// The networks of an action.
    fn items(&mut self, source: Source<'u>, bodies: &mut [Option<st::Body>]) -> Vec<Item> {
        match source {
            Source::Nothing => Vec::new(),
            Source::Text(number) => bodies[number].take().map(|body| body.items).unwrap_or_default(),
            Source::Graph(graph, _) => self.draw(graph),
        }
    }

    fn draw(&mut self, graph: &Graph) -> Vec<Item> {
        let before = self.made.items.len();
        Networks::draw(self.seen.shared, graph, self.made, self.reading);
        self.made.items.split_off(before)
    }
}

/// What an action does.
enum Done<'u> {
    Variable(Path),
    Body(Source<'u>),
}

fn priority(element: &Element) -> Read<Option<u32>> {
    match &element.kind {
        Kind::Transition {
            priority: Some(written),
            ..
        } => written
            .trim()
            .parse()
            .map(Some)
            .map_err(|_| format!("`{written}` is not a priority")),
        _ => Ok(None),
    }
}

//! What a client shows of a program, and what it has been sent of that: so that states cost what is seen.

use std::collections::{HashMap, HashSet};

use ladder_analysis::program::Place;
use ladder_analysis::values::value::Value;
use ladder_documents::position::Range;
use ladder_format::display_width;
use ladder_simulator::{Group, Point, Simulation, chart};
use ladder_syntax::TextRange;

use crate::drawing::{Drawing, Element};
use crate::labels::{Wanted, place, room};
use crate::line_map::LineMap;
use crate::messages::{self, Contact, Label, Lines, Shown};

/// More lines than this are no screen.
const MOST_LINES: u32 = 2000;

/// The part of a program that a client shows.
#[derive(Debug, Default)]
pub(crate) struct View {
    shown: Shown,
    elements: Vec<Element>,
    points: Vec<Point>,
    /// What opens, and is shown.
    groups: Vec<Group>,
    /// The power of elements as the client knows it, by the engine's numbers.
    sent_power: HashMap<usize, Flow>,
    /// The values as the client knows them.
    reported_values: HashMap<String, (Value, bool)>,
    /// The same of what opens, with what is shown of it while it is closed.
    reported_groups: HashMap<String, (String, bool)>,
    /// Lines whose operands the client knows.
    reported_lines: HashSet<u32>,
    /// Operands whose values it is to be sent.
    operands: Vec<messages::Operand>,
    /// The operands that may have labels, and which tag each shows.
    valued: Vec<Valued>,
    indexed: Vec<Indexed>,
    /// Where values are shown.
    labels: Vec<Label>,
    /// How many columns are kept for the value of each label.
    rooms: Vec<u32>,
    /// They may have to be placed elsewhere.
    unplaced: bool,
}

/// An operand that shows a value, or would if the tag were forced.
#[derive(Debug)]
struct Valued {
    range: TextRange,
    point: Point,
    drawn: bool,
    declared: bool,
    /// What is before its value.
    index: Option<String>,
}

/// An operand with a computed index.
#[derive(Debug)]
struct Indexed {
    block: TextRange,
    place: Place,
    /// What it led to when this was listed.
    element: Option<String>,
}

/// The power of an element.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Flow {
    Known { on: bool, contact: Option<Contact> },
    Unknown,
}

impl Flow {
    /// For the client.
    pub(crate) fn at(self, range: Range) -> messages::Power {
        let (on, contact) = match self {
            Flow::Known { on, contact } => (on, contact),
            Flow::Unknown => (false, None),
        };
        messages::Power {
            range,
            on,
            unknown: self == Flow::Unknown,
            contact,
        }
    }
}

/// What has changed of what is shown.
#[derive(Debug, Default)]
pub(crate) struct Update {
    pub(crate) points: Vec<Point>,
    pub(crate) groups: Vec<Group>,
    pub(crate) power: Vec<messages::Power>,
    pub(crate) operands: Vec<messages::Operand>,
    /// All of them, if one is at another place.
    pub(crate) labels: Option<Vec<Label>>,
}

impl View {
    /// Shows something else from now on. What was shown before and is not any more is forgotten.
    pub(crate) fn show(
        &mut self,
        shown: &Shown,
        drawing: &Drawing,
        line_map: &LineMap,
        simulation: &Simulation,
    ) {
        let revision = line_map.running();
        self.shown.clone_from(shown);
        let mut known = HashSet::new();
        let mut lines_reported = HashSet::new();
        self.elements.clear();
        self.points.clear();
        self.groups.clear();
        self.valued.clear();
        self.indexed.clear();
        self.unplaced = true;
        let mut seen_words = HashSet::new();
        let is_shown = |line: u32| shown.lines.iter().any(|it| (it.first..=it.last).contains(&line));
        self.operands.retain(|operand| is_shown(operand.block.start.line));
        let named = shown.tags.iter();
        for name in named {
            match simulation.resolve(name) {
                Ok(point) if known.insert(point.name.clone()) => self.points.push(point),
                Ok(_) => {}
                Err(_) => self.groups.extend(simulation.listed_group(name)),
            }
        }
        for &Lines { first, last } in &shown.lines {
            let last = last.min(first.saturating_add(MOST_LINES - 1));
            for stretch in line_map.stretches(first, last) {
                // A text has no wires.
                if line_map.shows_drawing() {
                    let elements = drawing.elements_in(stretch, revision, simulation);
                    self.elements.extend(elements);
                }
                let mut operands = drawing.declared_in(stretch, simulation);
                operands.extend(drawing.operands_in(stretch, revision, simulation));
                for mut operand in operands {
                    let places = (line_map.operand(operand.range), line_map.range(operand.block));
                    if !line_map.shows_drawing() {
                        operand.drawn = false;
                        // A tag of the reader's own is in no statement, and one that is read and written there is in one place.
                        let Some(word) = places.0 else { continue };
                        if !seen_words.insert((word.start.line, word.start.character)) {
                            continue;
                        }
                    }
                    if let Some(place) = &operand.indexed {
                        self.indexed.push(Indexed {
                            block: operand.block,
                            place: place.clone(),
                            element: operand.points.first().map(|point| point.name.clone()),
                        });
                    }
                    if let (Some(range), Some(block)) = places
                        && !operand.points.is_empty()
                        && !self.reported_lines.contains(&block.start.line)
                        && !lines_reported.contains(&block.start.line)
                    {
                        self.operands.push(messages::Operand {
                            range,
                            block,
                            tags: operand.points.iter().map(|point| point.name.clone()).collect(),
                            drawn: operand.drawn,
                        });
                    }
                    if let Some(point) = operand.points.first() {
                        self.valued.push(Valued {
                            range: operand.range,
                            point: point.clone(),
                            drawn: operand.drawn,
                            declared: operand.declared,
                            index: operand.index(),
                        });
                    }
                    for point in operand.points {
                        if known.insert(point.name.clone()) {
                            self.points.push(point);
                        }
                    }
                }
            }
            lines_reported.extend(first..=last.min(line_map.shown().last_line()));
        }
        let mut seen = HashSet::new();
        self.elements.retain(|element| seen.insert(element.number));
        self.valued.sort_by_key(|it| it.range.start());
        self.valued.dedup_by_key(|it| it.range.start());
        self.sent_power.retain(|number, _| seen.contains(number));
        self.reported_values.retain(|name, _| known.contains(name));
        let groups: HashSet<&str> = self.groups.iter().map(|group| group.name.as_str()).collect();
        self.reported_groups
            .retain(|name, _| groups.contains(name.as_str()));
        // They are sent with the next picture.
        self.reported_lines = lines_reported;
    }

    /// Follows computed indices to the elements that they lead to now.
    fn follow_indices(&mut self, drawing: &Drawing, line_map: &LineMap, simulation: &Simulation) {
        let moved = self.indexed.iter().filter(|indexed| {
            let now = simulation.indexed_point(&indexed.place).map(|now| now.name);
            now != indexed.element
        });
        let lines = moved.filter_map(|indexed| line_map.range(indexed.block));
        let lines: HashSet<u32> = lines.map(|range| range.start.line).collect();
        if !lines.is_empty() {
            // The operands of a line come together.
            self.reported_lines.retain(|line| !lines.contains(line));
            self.operands
                .retain(|operand| !lines.contains(&operand.block.start.line));
            let shown = std::mem::take(&mut self.shown);
            self.show(&shown, drawing, line_map, simulation);
        }
    }

    /// What has changed since this was asked last.
    pub(crate) fn update(
        &mut self,
        drawing: &Drawing,
        line_map: &LineMap,
        simulation: &Simulation,
        is_unknown: &dyn Fn(usize) -> bool,
    ) -> Update {
        self.follow_indices(drawing, line_map, simulation);
        let mut update = Update {
            operands: std::mem::take(&mut self.operands),
            ..Update::default()
        };
        for element in &self.elements {
            let flow = if is_unknown(element.number) {
                Flow::Unknown
            } else {
                let on = simulation.is_live(element.number);
                let contact = element.contact.as_ref().map(|it| it.state(on, simulation));
                Flow::Known { on, contact }
            };
            let sent = self.sent_power.insert(element.number, flow);
            if sent != Some(flow)
                && let Some(range) = line_map.range(element.range)
            {
                update.power.push(flow.at(range));
            }
        }
        for point in &self.points {
            let now = (simulation.value(point), simulation.is_forced(point));
            let before = self.reported_values.get(&point.name);
            if before != Some(&now) {
                let is_held_as_before = before.is_some_and(|before| before.1 == now.1);
                self.unplaced |= !is_held_as_before || self.outgrows(point, simulation);
                self.reported_values.insert(point.name.clone(), now);
                update.points.push(point.clone());
            }
        }
        for group in &self.groups {
            let now = (simulation.brief(group, &group.name), simulation.has_forced(group));
            if self.reported_groups.get(&group.name) != Some(&now) {
                self.reported_groups.insert(group.name.clone(), now);
                update.groups.push(group.clone());
            }
        }
        if std::mem::take(&mut self.unplaced) {
            let labels = self.place(line_map, simulation);
            if labels != self.labels {
                self.labels.clone_from(&labels);
                update.labels = Some(labels);
            }
        }
        update
    }

    /// Whether a value takes more columns than are kept for it.
    fn outgrows(&self, point: &Point, simulation: &Simulation) -> bool {
        let mut of_point = self.labels.iter().zip(&self.rooms);
        of_point.any(|(label, room)| label.tag == point.name && width(point, simulation) > *room)
    }

    /// Where the values of all operands that are shown go.
    fn place(&mut self, line_map: &LineMap, simulation: &Simulation) -> Vec<Label> {
        let shown = line_map.shown();
        let line_at = |line: u32| {
            let (start, end) = (shown.line_start(line), shown.line_start(line + 1));
            (line <= shown.last_line()).then(|| shown.stretch(start.into()..end.into()))
        };
        let mut labels = Vec::new();
        let mut wanted = Vec::new();
        let row_of = |valued: &Valued| line_map.operand(valued.range).map(|range| range.start.line);
        let mut declared_in: HashMap<u32, usize> = HashMap::new();
        for row in self.valued.iter().filter(|it| it.declared).filter_map(row_of) {
            *declared_in.entry(row).or_default() += 1;
        }
        for valued in &self.valued {
            let Valued { range, point, .. } = valued;
            let index = match row_of(valued).filter(|_| valued.declared) {
                Some(row) => told_before(point, declared_in[&row] > 1),
                None => valued.index.clone(),
            };
            // The drawing itself tells the value of a contact that is not forced, and the text that of a constant; neither
            // tells which element a computed index leads to.
            let is_constant = point.read_only && !point.name.starts_with("SYS.");
            let is_told = is_constant || (valued.drawn && !simulation.is_forced(point));
            if is_told && (index.is_none() || valued.declared) {
                continue;
            }
            let before = index.as_deref().map_or(0, display_width);
            let Some(at) = line_map.operand(*range).map(|range| range.start) else {
                continue;
            };
            let start = shown.line_start(at.line).into();
            let text = shown.stretch(start..shown.offset(at).into());
            wanted.push(Wanted {
                row: at.line,
                declared: valued.declared,
                column: display_width(&text),
                width: before + room(point.ty).max(width(point, simulation)),
                name: display_width(&point.name) + 2,
            });
            labels.push((valued, index, at));
        }
        let befores = labels
            .iter()
            .map(|(_, index, _)| index.as_deref().map_or(0, display_width));
        let rooms = wanted.iter().zip(befores).map(|(it, before)| it.width - before);
        self.rooms = rooms.collect();
        let places = place(&wanted, |line| {
            line_at(line).map(|line| line.trim_end_matches(['\r', '\n']).to_owned())
        });
        let placed = labels.into_iter().zip(places);
        placed
            .map(|((valued, index, at), place)| Label {
                tag: valued.point.name.clone(),
                index,
                at,
                side: place.side,
                column: place.column,
                after: place.after,
            })
            .collect()
    }
}

/// What is before the value of a tag after its declaration: its name if it is one of several there, else which of its members
/// it is.
fn told_before(point: &Point, is_one_of_several: bool) -> Option<String> {
    let member = point.name.rsplit_once('.').map(|(_, member)| member);
    let told = if is_one_of_several {
        Some(point.name.as_str())
    } else {
        member
    };
    told.map(|told| format!("{told}="))
}

/// How many columns a value takes. What is forced has a mark.
fn width(point: &Point, simulation: &Simulation) -> u32 {
    let text = chart::reading(&simulation.value(point), point.ty);
    display_width(&text) + u32::from(simulation.is_forced(point))
}

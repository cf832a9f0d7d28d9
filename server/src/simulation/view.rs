//! What a client shows of a program, and what it has been sent of that: so that states cost what is seen.

use std::collections::{HashMap, HashSet};

use ladder_analysis::values::value::Value;
use ladder_simulator::{Point, Simulation};

use super::drawing::{Drawing, Element};
use super::messages::{self, Contact, Lines, Shown};
use super::sight::Sight;

/// More lines than this are no screen.
const MOST_LINES: u32 = 2000;

/// The part of a program that a client shows.
#[derive(Debug, Default)]
pub(super) struct View {
    elements: Vec<Element>,
    points: Vec<Point>,
    /// The power of elements as the client knows it, by the engine's numbers.
    sent_power: HashMap<usize, (bool, Option<Contact>)>,
    /// The values as the client knows them.
    told_values: HashMap<String, (Value, bool)>,
    /// Lines whose operands the client knows.
    told_lines: HashSet<u32>,
    /// Operands whose values it is to be sent.
    operands: Vec<messages::Operand>,
}

/// What has changed of what is shown.
#[derive(Debug, Default)]
pub(super) struct News {
    pub(super) points: Vec<Point>,
    pub(super) power: Vec<messages::Power>,
    pub(super) operands: Vec<messages::Operand>,
}

impl View {
    /// Shows something else from now on. What was shown before and is not any more is forgotten.
    pub(super) fn show(&mut self, shown: &Shown, drawing: &Drawing, sight: &Sight, simulation: &Simulation) {
        let revision = sight.running();
        let mut known = HashSet::new();
        let mut lines_told = HashSet::new();
        self.elements.clear();
        self.points.clear();
        let is_shown = |line: u32| shown.lines.iter().any(|it| (it.first..=it.last).contains(&line));
        self.operands.retain(|operand| is_shown(operand.block.start.line));
        let named = shown.tags.iter();
        for point in named.filter_map(|name| simulation.resolve(name).ok()) {
            if known.insert(point.name.clone()) {
                self.points.push(point);
            }
        }
        for &Lines { first, last } in &shown.lines {
            let last = last.min(first.saturating_add(MOST_LINES - 1));
            for stretch in sight.stretches(first, last) {
                let elements = drawing.elements_in(stretch, revision, simulation);
                self.elements.extend(elements);
                for operand in drawing.operands_in(stretch, revision, simulation) {
                    let places = (sight.range(operand.range), sight.range(operand.block));
                    if let (Some(range), Some(block)) = places
                        && !self.told_lines.contains(&block.start.line)
                        && !lines_told.contains(&block.start.line)
                    {
                        self.operands.push(messages::Operand {
                            range,
                            block,
                            tags: operand.points.iter().map(|point| point.name.clone()).collect(),
                            drawn: operand.drawn,
                        });
                    }
                    for point in operand.points {
                        if known.insert(point.name.clone()) {
                            self.points.push(point);
                        }
                    }
                }
            }
            lines_told.extend(first..=last.min(sight.shown().last_line()));
        }
        let mut seen = HashSet::new();
        self.elements.retain(|element| seen.insert(element.number));
        self.sent_power.retain(|number, _| seen.contains(number));
        self.told_values.retain(|name, _| known.contains(name));
        // They are sent with the next picture.
        self.told_lines = lines_told;
    }

    /// What has changed since this was asked last.
    pub(super) fn news(&mut self, sight: &Sight, simulation: &Simulation) -> News {
        let mut news = News {
            operands: std::mem::take(&mut self.operands),
            ..News::default()
        };
        for element in &self.elements {
            let on = simulation.is_live(element.number);
            let contact = element.contact.as_ref().map(|it| it.state(on, simulation));
            let sent = self.sent_power.insert(element.number, (on, contact));
            if sent != Some((on, contact))
                && let Some(range) = sight.range(element.range)
            {
                news.power.push(messages::Power { range, on, contact });
            }
        }
        for point in &self.points {
            let now = (simulation.value(point), simulation.is_forced(point));
            if self.told_values.get(&point.name) != Some(&now) {
                self.told_values.insert(point.name.clone(), now);
                news.points.push(point.clone());
            }
        }
        news
    }
}

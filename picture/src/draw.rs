//! A network on paper.

use super::columns::Layout;
use super::figure::{Drawn, Figure};
use super::glyph::{self, WireEnds};
use super::grid::{Kind, Slot};
use super::nodes::point_of;
use super::paper::Paper;
use super::shapes::{Anchor, Element};
use super::style::{LINE, Look, MARGIN, UNIT};
use super::symbol::width;
use ladder_analysis::networks::NetworkAt;
use ladder_syntax::{Parse, TextRange};
use std::collections::HashMap;

/// Pixels between two rungs.
const BETWEEN: i32 = 6;
/// The middle of a rail or vertical line in its column.
const MIDDLE: i32 = UNIT / 2;

/// A network with its columns, and where it is drawn.
pub(super) struct Drawing<'d> {
    pub(super) parse: &'d Parse,
    /// The network's index, and what is known of it.
    pub(super) index: usize,
    pub(super) network: NetworkAt<'d>,
    pub(super) figure: &'d Figure,
    pub(super) layout: &'d Layout,
    /// The column of the right rail, where the network ends at one.
    pub(super) rail: Option<u32>,
    pub(super) power: Option<&'d HashMap<TextRange, bool>>,
    /// A user will show the power of a running program on it.
    pub(super) live: bool,
}

/// The power of a line.
#[derive(Debug, Clone)]
pub(super) struct Power {
    pub(super) flow: Flow,
    /// In a live drawing the parts that carry it.
    pub(super) of: Vec<Element>,
}

impl Power {
    /// What is not joined to anything has none, as far as power is shown.
    fn none(next_to: Flow) -> Power {
        let flow = match next_to {
            Flow::Unknown => Flow::Unknown,
            _ => Flow::Dead,
        };
        Power { flow, of: Vec::new() }
    }
}

/// What is known of the power in a part.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Flow {
    /// Nothing is known about power.
    Unknown,
    Dead,
    Live,
}

impl Flow {
    pub(super) const fn line(self) -> Look {
        match self {
            Flow::Unknown => Look::Line,
            Flow::Dead => Look::Dead,
            Flow::Live => Look::Live,
        }
    }

    const fn dot(self) -> Look {
        match self {
            Flow::Unknown => Look::Dot,
            Flow::Dead => Look::DotDead,
            Flow::Live => Look::DotLive,
        }
    }
}

impl Drawing<'_> {
    /// Draws it below `top`; returns its lower end.
    pub(super) fn draw(&self, paper: &mut Paper, top: i32) -> i32 {
        let mut wires = Vec::with_capacity(self.figure.rooms.len());
        let mut y = top;
        for room in &self.figure.rooms {
            wires.push(y + room.over);
            y += room.over + room.under + BETWEEN;
        }
        let bottom = y - BETWEEN;
        let powers = self.powers_of_lines();
        self.verticals(paper, &wires, &powers);
        for (rung, &y) in wires.iter().enumerate() {
            self.rung(paper, rung, y, &powers);
        }
        paper.of(None);
        paper.powered_by(&[]);
        self.rails(paper, top, bottom);
        bottom
    }

    fn flow(&self, rung: usize, part: usize) -> Flow {
        let Some(power) = self.power else {
            return Flow::Unknown;
        };
        match power.get(&self.network.part_range(self.parse, rung, part)) {
            Some(true) => Flow::Live,
            _ => Flow::Dead,
        }
    }

    const fn element(&self, rung: usize, part: usize) -> Element {
        let network = self.index;
        Element { network, rung, part }
    }

    fn power(&self, rung: usize, part: usize) -> Power {
        Power {
            flow: self.flow(rung, part),
            of: if self.live {
                vec![self.element(rung, part)]
            } else {
                Vec::new()
            },
        }
    }

    /// The power of each vertical line: that of its points, which is the same for all but where branches come together.
    fn powers_of_lines(&self) -> Vec<Power> {
        let power_of = |thing: &super::grid::Thing| {
            let mut power = Power {
                flow: Flow::Unknown,
                of: Vec::new(),
            };
            for &(rung, slot) in &thing.slots {
                for item in self.layout.grid.rungs[rung][slot].items.clone() {
                    let part = self.figure.rungs[rung][item].part;
                    if power.flow != Flow::Live {
                        power.flow = self.flow(rung, part);
                    }
                    if self.live {
                        power.of.push(self.element(rung, part));
                    }
                }
            }
            power
        };
        let things = self.layout.grid.things.iter();
        things
            .map(|thing| match thing.kind {
                Kind::Node => power_of(thing),
                _ => Power::none(Flow::Unknown),
            })
            .collect()
    }

    fn rails(&self, paper: &mut Paper, top: i32, bottom: i32) {
        let mut things = self.layout.grid.things.iter();
        if things.any(|thing| thing.kind == Kind::LeftRail) {
            let left = MARGIN + MIDDLE;
            paper.rail((left, top), (left, bottom));
        }
        if let Some(column) = self.rail {
            let right = MARGIN + column as i32 * UNIT + MIDDLE;
            paper.rail((right, top), (right, bottom));
        }
    }

    /// The lines from rung to rung, one for each two rungs that a node joins.
    fn verticals(&self, paper: &mut Paper, wires: &[i32], powers: &[Power]) {
        for (rung, slots) in self.layout.grid.rungs.iter().enumerate() {
            for slot in slots {
                let Some(part) = self.leads_down(rung, slot) else {
                    continue;
                };
                let (at, _) = self.ends(slot);
                paper.of(Some(self.element(rung, part)));
                let power = &powers[slot.thing];
                let look = power.flow.line();
                paper.powered_by(&power.of);
                paper.node(look, (at, wires[rung]), (at, wires[rung + 1]));
            }
        }
    }

    /// The part of the first `\` of a line on this rung.
    fn leads_down(&self, rung: usize, slot: &Slot) -> Option<usize> {
        let mut items = self.figure.rungs[rung][slot.items.clone()].iter();
        let leads_down = |item: &&super::figure::Item| {
            point_of(item).is_some_and(|point| self.network.wiring.points[point].upper == rung)
        };
        items.find(leads_down).map(|item| item.part)
    }

    /// Where the wire comes to something, and where it leaves it.
    fn ends(&self, slot: &Slot) -> (i32, i32) {
        let thing = &self.layout.grid.things[slot.thing];
        let left = MARGIN + self.layout.columns[slot.thing] as i32 * UNIT;
        match thing.kind {
            Kind::LeftRail | Kind::RightRail | Kind::Node => (left + MIDDLE, left + MIDDLE),
            _ => (left, left + thing.columns as i32 * UNIT),
        }
    }

    fn rung(&self, paper: &mut Paper, rung: usize, y: i32, powers: &[Power]) {
        let room = self.figure.rooms[rung];
        paper.of(None);
        paper.powered_by(&[]);
        for (line, comment) in self.figure.above[rung].iter().enumerate() {
            let base = y - room.over + (line as i32 + 1) * LINE - 4;
            let at = (MARGIN + 3 * UNIT, base);
            paper.text(Look::Comment, at, Anchor::Start, width(comment), comment);
        }
        let slots = &self.layout.grid.rungs[rung];
        let mut arriving = Power::none(Flow::Unknown);
        let mut from = 0;
        for (index, slot) in slots.iter().enumerate() {
            let item = &self.figure.rungs[rung][slot.items.start];
            let (left, right) = self.ends(slot);
            let own = match item.drawn {
                Drawn::Connector(_) => powers[slot.thing].clone(),
                _ => self.power(rung, item.part),
            };
            if slot.joined && index > 0 {
                if let Some(wire) = item.wire {
                    arriving = self.power(rung, wire);
                }
                paper.of(Some(self.element(rung, item.wire.unwrap_or(item.part))));
                paper.powered_by(&arriving.of);
                paper.wire(arriving.flow.line(), (from, y), (left, y));
            } else {
                arriving = Power::none(own.flow);
            }
            paper.of(Some(self.element(rung, item.part)));
            paper.powered_by(&[]);
            let goes_on = slots.get(index + 1).is_some_and(|next| next.joined);
            self.draw_slot(
                paper,
                rung,
                slot,
                WireEnds { left, right, y },
                (&arriving, &own),
                goes_on,
            );
            arriving = own;
            from = right;
        }
        paper.of(None);
        paper.powered_by(&[]);
        let comment = &self.figure.after[rung];
        let right = match self.rail {
            Some(column) => MARGIN + (column as i32 + 1) * UNIT,
            None => slots.last().map_or(MARGIN, |last| self.ends(last).1),
        };
        let at = (right + 2 * UNIT, y + 4);
        paper.text(Look::Comment, at, Anchor::Start, width(comment), comment);
    }

    /// Draws what is in a slot. `flow` is the power that arrives at it, and that leaves it.
    fn draw_slot(
        &self,
        paper: &mut Paper,
        rung: usize,
        slot: &Slot,
        place: WireEnds,
        flow: (&Power, &Power),
        goes_on: bool,
    ) {
        let WireEnds { left, right, y } = place;
        let (arriving, own) = flow;
        let rows = |over: i32, under: i32| (y - over, y + under);
        match &self.figure.rungs[rung][slot.items.start].drawn {
            Drawn::LeftRail | Drawn::RightRail => {}
            Drawn::Connector(_) => {
                let up = slot.items.clone().any(|item| {
                    let point = point_of(&self.figure.rungs[rung][item]);
                    point.is_some_and(|point| self.network.wiring.points[point].upper < rung)
                });
                let down = self.leads_down(rung, slot).is_some();
                let arms = [slot.joined, goes_on, up, down];
                if arms.iter().filter(|there| **there).count() > 2 {
                    paper.powered_by(&own.of);
                    paper.dot(own.flow.dot(), (left, y));
                }
            }
            Drawn::Stub => {
                paper.powered_by(&own.of);
                paper.wire(own.flow.line(), (left, y), (right, y));
            }
            Drawn::Comment(text) => {
                if slot.joined || goes_on {
                    paper.powered_by(&own.of);
                    paper.wire(own.flow.line(), (left, y), (right, y));
                    paper.powered_by(&[]);
                }
                let at = (i32::midpoint(left, right), y - 6);
                paper.text(Look::Comment, at, Anchor::Middle, width(text), text);
            }
            Drawn::Symbol { symbol, .. } => {
                glyph::draw(paper, symbol, place, arriving, own);
                let room = symbol.room();
                paper.place((left, right), y, rows(room.over, room.under));
            }
        }
    }
}

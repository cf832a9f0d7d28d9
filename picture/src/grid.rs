//! A network as things on rungs, where a vertical line is one thing that is on several.

use super::figure::{Drawn, Figure};
use super::nodes::{Joints, Sets, point_of, points};
use std::ops::Range;

/// The things of a network and the order in which they are on its rungs.
#[derive(Debug)]
pub(super) struct Grid {
    pub(super) things: Vec<Thing>,
    /// For each rung what is on it, from left to right.
    pub(super) rungs: Vec<Vec<Slot>>,
}

/// Something that has a column.
#[derive(Debug)]
pub(super) struct Thing {
    pub(super) kind: Kind,
    /// How many columns it takes.
    pub(super) columns: u32,
    /// Where it is: rung, and slot there. A line from rung to rung has several.
    pub(super) slots: Vec<(usize, usize)>,
}

/// What a thing is, as far as its column goes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    LeftRail,
    RightRail,
    /// A vertical line.
    Node,
    /// A block that decides about power, or a wire that ends at nothing.
    Condition,
    /// A block that does something.
    Acting,
    Comment,
}

/// A thing on a rung.
#[derive(Debug)]
pub(super) struct Slot {
    pub(super) thing: usize,
    /// The elements of the rung that it is: of a line the connectors.
    pub(super) items: Range<usize>,
    /// Whether a wire leads to it from the slot before.
    pub(super) joined: bool,
}

impl Grid {
    /// Puts together what the joints join.
    pub(super) fn new(figure: &Figure, joints: &Joints) -> Grid {
        let mut lines = Sets::new(points(figure));
        for (items, joints) in figure.rungs.iter().zip(joints) {
            for ((left, right), joined) in items.iter().zip(items.iter().skip(1)).zip(joints) {
                if let (true, Some(left), Some(right)) = (*joined, point_of(left), point_of(right)) {
                    lines.join(left, right);
                }
            }
        }
        let mut grid = Grid {
            things: Vec::new(),
            rungs: Vec::new(),
        };
        let mut thing_of_line = vec![None; points(figure)];
        for (rung, items) in figure.rungs.iter().enumerate() {
            let mut slots: Vec<Slot> = Vec::new();
            for (index, item) in items.iter().enumerate() {
                let goes_on = index > 0 && joints[rung][index - 1];
                if let Some(slot) = slots.last_mut().filter(|_| goes_on) {
                    slot.items.end = index + 1;
                    continue;
                }
                let next = grid.things.len();
                let thing = match point_of(item) {
                    Some(point) => *thing_of_line[lines.find(point)].get_or_insert(next),
                    None => next,
                };
                if thing == next {
                    grid.things.push(Thing {
                        kind: kind(&item.drawn),
                        columns: item.columns,
                        slots: Vec::new(),
                    });
                }
                grid.things[thing].slots.push((rung, slots.len()));
                slots.push(Slot {
                    thing,
                    items: index..index + 1,
                    joined: item.joined,
                });
            }
            grid.rungs.push(slots);
        }
        grid
    }
}

fn kind(drawn: &Drawn) -> Kind {
    match drawn {
        Drawn::LeftRail => Kind::LeftRail,
        Drawn::RightRail => Kind::RightRail,
        Drawn::Connector(_) => Kind::Node,
        Drawn::Stub | Drawn::Symbol { acts: false, .. } => Kind::Condition,
        Drawn::Symbol { acts: true, .. } => Kind::Acting,
        Drawn::Comment(_) => Kind::Comment,
    }
}

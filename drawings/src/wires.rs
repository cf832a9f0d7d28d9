//! The wires of a sheet: what they join from left to right, and what from line to line.

use crate::marks::{Mark, Marks};
use crate::sheet::{Arms, Sheet, arms, is_bar, is_wire};
use crate::text::is_hyphen;
use std::collections::{HashMap, HashSet};

/// Something on a wire.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Thing {
    /// Its first column, and the one after its last.
    pub(crate) from: usize,
    pub(crate) to: usize,
    pub(crate) kind: ThingKind,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum ThingKind {
    /// Where a line from above or below meets the wire: its number in [`Wires::joints`].
    Joint(usize),
    /// An element: its number.
    Symbol(usize),
}

/// A wire from left to right without a gap, with what is on it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Run {
    pub(crate) line: usize,
    pub(crate) from: usize,
    pub(crate) to: usize,
    pub(crate) things: Vec<Thing>,
}

impl Run {
    /// The one element on it; none if there are more, or lines from above or below meet it after its first column.
    pub(crate) fn only_symbol(&self) -> Option<usize> {
        let things = match &self.things[..] {
            [first, rest @ ..] if first.is_joint() && first.from == self.from => rest,
            all => all,
        };
        match things {
            [
                Thing {
                    kind: ThingKind::Symbol(symbol),
                    ..
                },
            ] => Some(*symbol),
            _ => None,
        }
    }

    /// Whether wire leads from nothing to its first thing, and from its last to nothing.
    pub(crate) fn begins_bare(&self) -> bool {
        self.things
            .first()
            .is_none_or(|first| first.from > self.from || !first.is_joint())
    }

    pub(crate) fn ends_bare(&self) -> bool {
        self.things
            .last()
            .is_none_or(|last| last.to < self.to || !last.is_joint())
    }

    /// Whether it is part of a rung: a line from top to bottom is none by itself, nor is a dash in a text.
    pub(crate) fn is_rung(&self) -> bool {
        let has_symbol = self.things.iter().any(|thing| !thing.is_joint());
        has_symbol || (!self.things.is_empty() && self.to - self.from > 1)
    }
}

impl Thing {
    pub(crate) fn is_joint(self) -> bool {
        matches!(self.kind, ThingKind::Joint(_))
    }
}

/// A place where lines meet, or where one passes from top to bottom.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Joint {
    pub(crate) line: usize,
    pub(crate) column: usize,
    /// Wire comes from the left, leaves to the right.
    pub(crate) enters: bool,
    pub(crate) leaves: bool,
    /// A line leads up, leads down.
    pub(crate) up: bool,
    pub(crate) down: bool,
    /// It is drawn as a plain line from top to bottom.
    pub(crate) is_bar: bool,
    /// All joints that lines from top to bottom make one have the same number.
    pub(crate) vertical: usize,
}

/// All of them.
#[derive(Debug, Default)]
pub(crate) struct Wires {
    pub(crate) runs: Vec<Run>,
    /// Line by line, from left to right.
    pub(crate) joints: Vec<Joint>,
}

impl Wires {
    /// The column of the leftmost wire.
    pub(crate) fn left(&self) -> Option<usize> {
        self.runs
            .iter()
            .filter(|run| run.is_rung())
            .map(|run| run.from)
            .min()
    }

    /// The wires of a line.
    pub(crate) fn on(&mut self, line: usize) -> &mut [Run] {
        let first = self.runs.partition_point(|run| run.line < line);
        let after = self.runs.partition_point(|run| run.line <= line);
        &mut self.runs[first..after]
    }

    /// The wires left and right of a place that has none.
    pub(crate) fn next_to(&self, line: usize, column: usize) -> impl Iterator<Item = &Run> {
        let right = self
            .runs
            .partition_point(|run| (run.line, run.from) < (line, column));
        let both = self.runs[right.saturating_sub(1)..].iter().take(2);
        both.filter(move |run| run.line == line)
    }
}

/// Follows the wires. `power` is for each box the line on which power comes to it, with the number of its symbol.
pub(crate) fn find(sheet: &Sheet, marks: &Marks, power: &[Option<(usize, usize)>]) -> Wires {
    let mut reader = Reader {
        sheet,
        marks,
        power,
        met: HashSet::new(),
        wires: Wires::default(),
    };
    reader.meet();
    for line in 0..sheet.len() {
        reader.line(line);
    }
    reader.verticals();
    reader.wires
}

struct Reader<'s> {
    sheet: &'s Sheet,
    marks: &'s Marks,
    power: &'s [Option<(usize, usize)>],
    /// Wire that a line from above or below ends at.
    met: HashSet<(usize, usize)>,
    wires: Wires,
}

impl Reader<'_> {
    fn is_wire(&self, line: usize, column: usize) -> bool {
        match self.marks.at(line, column) {
            Mark::Wire => true,
            Mark::None => is_wire(self.sheet.at(line, column)) && !is_hyphen(self.sheet, line, column),
            _ => false,
        }
    }

    fn arms(&self, line: usize, column: usize) -> Option<Arms> {
        let is_free = self.marks.at(line, column) == Mark::None;
        arms(self.sheet.at(line, column)).filter(|_| is_free)
    }

    /// Finds the wires that a line from top to bottom ends at without a joint drawn there.
    fn meet(&mut self) {
        for line in 0..self.sheet.len() {
            for column in 0..self.sheet.width(line) {
                let is_line = is_bar(self.sheet.at(line, column)) && self.arms(line, column).is_some();
                if !is_line {
                    continue;
                }
                let others = [line.checked_sub(1), Some(line + 1)];
                for other in others.into_iter().flatten() {
                    let near = [column.checked_sub(1), Some(column + 1)];
                    let mut near = near.into_iter().flatten();
                    if self.is_wire(other, column) && !near.any(|column| self.arms(other, column).is_some()) {
                        self.met.insert((other, column));
                    }
                }
            }
        }
    }

    /// The wires of a line.
    fn line(&mut self, line: usize) {
        let mut run: Option<Run> = None;
        let mut column = 0;
        let width = self.sheet.width(line);
        while column < width {
            let (to, kind, left, right) = match self.marks.at(line, column) {
                Mark::Symbol(symbol) => {
                    let end = (column..width).find(|&next| self.marks.at(line, next) != Mark::Symbol(symbol));
                    (end.unwrap_or(width), Some(ThingKind::Symbol(symbol)), true, true)
                }
                Mark::Frame(frame) => {
                    let end = (column..width).find(|&next| self.marks.at(line, next) != Mark::Frame(frame));
                    let end = end.unwrap_or(width);
                    match self.power[frame] {
                        Some((at, symbol)) if at == line => {
                            (end, Some(ThingKind::Symbol(symbol)), true, true)
                        }
                        _ => {
                            self.end(&mut run);
                            column = end;
                            continue;
                        }
                    }
                }
                _ if self.met.contains(&(line, column)) => {
                    (column + 1, Some(self.joint(line, column)), true, true)
                }
                _ if self.is_wire(line, column) => (column + 1, None, true, true),
                _ => match self.arms(line, column) {
                    Some(arms) => {
                        let joint = self.joint(line, column);
                        (column + 1, Some(joint), arms.left, arms.right)
                    }
                    None => {
                        self.end(&mut run);
                        column += 1;
                        continue;
                    }
                },
            };
            if !left {
                self.end(&mut run);
            }
            let own = run.get_or_insert_with(|| Run {
                line,
                from: column,
                to: column,
                things: Vec::new(),
            });
            own.to = to;
            own.things.extend(kind.map(|kind| Thing {
                from: column,
                to,
                kind,
            }));
            if !right {
                self.end(&mut run);
            }
            column = to;
        }
        self.end(&mut run);
    }

    fn joint(&mut self, line: usize, column: usize) -> ThingKind {
        let vertical = self.wires.joints.len();
        self.wires.joints.push(Joint {
            line,
            column,
            enters: false,
            leaves: false,
            up: false,
            down: false,
            is_bar: is_bar(self.sheet.at(line, column)),
            vertical,
        });
        ThingKind::Joint(vertical)
    }

    fn end(&mut self, run: &mut Option<Run>) {
        let Some(run) = run.take() else { return };
        for thing in &run.things {
            if let ThingKind::Joint(joint) = thing.kind {
                let joint = &mut self.wires.joints[joint];
                joint.enters = thing.from > run.from;
                joint.leaves = thing.to < run.to;
            }
        }
        self.wires.runs.push(run);
    }

    /// Joins the joints that are above each other.
    fn verticals(&mut self) {
        let mut columns: Vec<HashMap<usize, usize>> = vec![HashMap::new(); self.sheet.len()];
        for (number, joint) in self.wires.joints.iter().enumerate() {
            columns[joint.line].insert(joint.column, number);
        }
        let leads = |line: usize, column: usize, up: bool| {
            let met = self.met.contains(&(line, column));
            met || self
                .arms(line, column)
                .is_some_and(|arms| if up { arms.up } else { arms.down })
        };
        let mut pairs = Vec::new();
        for line in 1..columns.len() {
            let (above, below) = (&columns[line - 1], &columns[line]);
            let mut free = Vec::new();
            for (&column, &upper) in above {
                match below.get(&column) {
                    _ if !leads(line - 1, column, false) => {}
                    Some(&lower) if leads(line, column, true) => pairs.push((upper, lower)),
                    _ => free.push((column, upper)),
                }
            }
            // People are off by a column now and then.
            for (column, upper) in free {
                let near = [column.checked_sub(1), Some(column + 1)].into_iter().flatten();
                let near = near.filter_map(|near| Some((near, *below.get(&near)?)));
                let mut fits = near.filter(|(near, lower)| {
                    let has_bar = self.wires.joints[upper].is_bar || self.wires.joints[*lower].is_bar;
                    let is_free = above.get(near).is_none_or(|_| !leads(line - 1, *near, false));
                    has_bar && is_free && leads(line, *near, true)
                });
                if let (Some((_, lower)), None) = (fits.next(), fits.next()) {
                    pairs.push((upper, lower));
                }
            }
        }
        // From top to bottom, so that the number of a vertical is that of its first joint.
        pairs.sort_unstable();
        let mut same: Vec<usize> = (0..self.wires.joints.len()).collect();
        for &(upper, lower) in &pairs {
            let (one, other) = (root(&mut same, upper), root(&mut same, lower));
            same[one.max(other)] = one.min(other);
            self.wires.joints[upper].down = true;
            self.wires.joints[lower].up = true;
        }
        for joint in 0..same.len() {
            self.wires.joints[joint].vertical = root(&mut same, joint);
        }
    }
}

fn root(same: &mut [usize], mut joint: usize) -> usize {
    while same[joint] != joint {
        same[joint] = same[same[joint]];
        joint = same[joint];
    }
    joint
}

//! From wires to the rungs of networks: the same lines, with connectors where lines lead from one rung to another.
//!
//! A line from top to bottom that power only leaves is the left rail, one that power only comes to is the right one. Any other carries
//! the power of all wires that come to it to all that leave it. A pair of connectors does that for two rungs. For more, the power
//! is first led up to the highest rung, and from there down again, as far as either is needed.

use crate::wires::{Joint, Run, ThingKind, Wires};
use std::collections::BTreeMap;

/// How far from the outermost wire a rail may be: people are off by a column or two.
const NEAR: usize = 3;

/// One thing on a rung.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Piece {
    Rail,
    Down,
    Up,
    Gap,
    Symbol(usize),
}

/// A network of a sheet.
#[derive(Debug, Default)]
pub(crate) struct Network {
    /// The lines of its rungs.
    pub(crate) lines: Vec<usize>,
    pub(crate) rungs: Vec<Vec<Piece>>,
}

impl Network {
    /// Its elements.
    pub(crate) fn symbols(&self) -> impl Iterator<Item = usize> {
        self.rungs.iter().flatten().filter_map(|piece| match *piece {
            Piece::Symbol(symbol) => Some(symbol),
            _ => None,
        })
    }
}

/// Something that cannot be read: line and column, and why.
pub(crate) type Problem = ((usize, usize), String);

/// A line from top to bottom.
#[derive(Debug, Default)]
struct Vertical {
    joints: Vec<usize>,
    enters: bool,
    leaves: bool,
}

impl Vertical {
    fn is_inside(&self) -> bool {
        self.enters && self.leaves
    }
}

/// All networks from top to bottom, and what is wrong with their wires. `acts`: whether a symbol is one that power may end after.
pub(crate) fn networks(wires: &Wires, acts: &dyn Fn(usize) -> bool) -> (Vec<Network>, Vec<Problem>) {
    let plan = Plan::of(wires);
    let problems = plan.problems(acts);
    (plan.networks(acts), problems)
}

struct Plan<'w> {
    wires: &'w Wires,
    /// The lines with rungs.
    rows: Vec<usize>,
    verticals: BTreeMap<usize, Vertical>,
    /// The outermost columns of all rungs.
    left: usize,
    right: usize,
}

impl Plan<'_> {
    fn of(wires: &Wires) -> Plan<'_> {
        let rungs = || wires.runs.iter().filter(|run| run.is_rung());
        let mut rows: Vec<usize> = rungs().map(|run| run.line).collect();
        rows.dedup();
        let mut verticals: BTreeMap<usize, Vertical> = BTreeMap::new();
        for (number, joint) in wires.joints.iter().enumerate() {
            let vertical = verticals.entry(joint.vertical).or_default();
            vertical.joints.push(number);
            vertical.enters |= joint.enters;
            vertical.leaves |= joint.leaves;
        }
        Plan {
            wires,
            rows,
            verticals,
            left: rungs().map(|run| run.from).min().unwrap_or(0),
            right: rungs().map(|run| run.to).max().unwrap_or(0),
        }
    }

    fn is_left(&self, column: usize) -> bool {
        column < self.left + NEAR
    }

    fn is_right(&self, column: usize) -> bool {
        column + NEAR >= self.right
    }

    fn joint(&self, number: usize) -> Joint {
        self.wires.joints[number]
    }

    fn problems(&self, acts: &dyn Fn(usize) -> bool) -> Vec<Problem> {
        let mut problems = Vec::new();
        for run in self.wires.runs.iter().filter(|run| run.is_rung()) {
            self.ends(run, acts, &mut problems);
        }
        for vertical in self.verticals.values() {
            self.joins(vertical, &mut problems);
        }
        problems.sort_unstable();
        problems
    }

    /// What is wrong with the ends of a wire.
    fn ends(&self, run: &Run, acts: &dyn Fn(usize) -> bool, problems: &mut Vec<Problem>) {
        let is_source = |number: usize| !self.verticals[&self.joint(number).vertical].enters;
        let is_sink = |number: usize| !self.verticals[&self.joint(number).vertical].leaves;
        let begins_bare = match run.things.first().map(|thing| thing.kind) {
            Some(ThingKind::Joint(joint)) if !run.begins_bare() => is_source(joint),
            _ => true,
        };
        if begins_bare && !self.is_left(run.from) {
            let why = "no wire leads here from the left, and no line from above or below";
            problems.push(((run.line, run.from), why.to_owned()));
        }
        let ends_bare = match run.things.last().map(|thing| thing.kind) {
            Some(ThingKind::Joint(joint)) if !run.ends_bare() => is_sink(joint),
            _ => true,
        };
        let last = run.things.iter().rev().find_map(|thing| match thing.kind {
            ThingKind::Symbol(symbol) => Some(symbol),
            ThingKind::Joint(_) => None,
        });
        if ends_bare && !self.is_right(run.to) && !last.is_some_and(acts) {
            let why = "the wire ends here, and no line leads on from it";
            problems.push(((run.line, run.to - 1), why.to_owned()));
        }
    }

    /// What is wrong with a line from top to bottom.
    fn joins(&self, vertical: &Vertical, problems: &mut Vec<Problem>) {
        let joints: Vec<Joint> = vertical.joints.iter().map(|&number| self.joint(number)).collect();
        let (Some(first), Some(last)) = (joints.first(), joints.last()) else {
            return;
        };
        let place = |joint: &Joint| (joint.line, joint.column);
        let is_bare = |joint: &Joint| !joint.enters && !joint.leaves;
        if vertical.is_inside() {
            if joints.len() == 1 {
                let why = "nothing joins this to a line above or below";
                problems.push((place(first), why.to_owned()));
            }
            if is_bare(first) || is_bare(last) {
                for joint in joints.iter().filter(|joint| !is_bare(joint)) {
                    let why = "the line that leads up or down from here ends at nothing";
                    problems.push((place(joint), why.to_owned()));
                }
            }
            let crosses =
                |joint: &&Joint| joint.is_bar && joint.enters && joint.leaves && joint.up && joint.down;
            for joint in joints.iter().filter(crosses) {
                let why =
                    "whether the two lines meet here or only cross cannot be seen: draw + where they meet";
                problems.push((place(joint), why.to_owned()));
            }
        } else if joints.iter().all(is_bare)
            && !joints
                .iter()
                .any(|joint| self.is_left(joint.column) || self.is_right(joint.column))
        {
            problems.push((place(first), "this line joins nothing".to_owned()));
        }
    }

    /// The numbers of the rungs that a vertical line leads from and to.
    fn reach(&self, vertical: &Vertical) -> Option<(usize, usize)> {
        let lines = || vertical.joints.iter().map(|&joint| self.joint(joint).line);
        let first = self.rows.partition_point(|row| Some(*row) < lines().min());
        let after = self.rows.partition_point(|row| Some(*row) <= lines().max());
        (first < after).then(|| (first, after - 1))
    }

    fn networks(&self, acts: &dyn Fn(usize) -> bool) -> Vec<Network> {
        // For each rung whether a line joins it to the next.
        let mut goes_on = vec![false; self.rows.len()];
        for vertical in self.verticals.values().filter(|vertical| vertical.is_inside()) {
            if let Some((first, last)) = self.reach(vertical) {
                goes_on[first..last].fill(true);
            }
        }
        let buses: BTreeMap<usize, Bus> = self
            .verticals
            .iter()
            .filter(|(_, vertical)| vertical.is_inside())
            .filter_map(|(number, vertical)| Some((*number, self.bus(vertical)?)))
            .collect();
        let mut networks: Vec<Network> = Vec::new();
        let mut runs = self.wires.runs.iter().peekable();
        let mut joined = false;
        for (row, &line) in self.rows.iter().enumerate() {
            if !joined {
                networks.push(Network::default());
            }
            joined = goes_on[row];
            let mut rung = Vec::new();
            while runs.next_if(|run| run.line < line).is_some() {}
            while let Some(run) = runs.next_if(|run| run.line == line) {
                self.run(run, row, &buses, acts, &mut rung);
            }
            if let Some(network) = networks.last_mut() {
                network.lines.push(line);
                network.rungs.push(tidied(&rung));
            }
        }
        networks
    }

    fn bus(&self, vertical: &Vertical) -> Option<Bus> {
        let (top, bottom) = self.reach(vertical)?;
        let rows = |wanted: &dyn Fn(Joint) -> bool| -> Vec<usize> {
            let joints = vertical.joints.iter().map(|&joint| self.joint(joint));
            let lines = joints.filter(|joint| wanted(*joint)).map(|joint| joint.line);
            lines
                .filter_map(|line| self.rows.binary_search(&line).ok())
                .collect()
        };
        let (enters, leaves) = (rows(&|joint| joint.enters), rows(&|joint| joint.leaves));
        let first_enters = enters.iter().min().copied()?;
        let lowest = enters.iter().max().copied().filter(|lowest| *lowest > top);
        // Without a wire that comes from above, the power that is led up is all that there is.
        let needs_more = leaves.iter().any(|&row| row > top && first_enters < row);
        let down_to = leaves.iter().max().copied().filter(|_| needs_more);
        Some(Bus {
            top,
            bottom,
            up_from: lowest,
            down_to,
        })
    }

    fn run(
        &self,
        run: &Run,
        row: usize,
        buses: &BTreeMap<usize, Bus>,
        acts: &dyn Fn(usize) -> bool,
        rung: &mut Vec<Piece>,
    ) {
        rung.push(Piece::Gap);
        let is_rung = run.is_rung();
        if is_rung && run.begins_bare() && self.is_left(run.from) {
            rung.push(Piece::Rail);
        }
        let mut last = None;
        for (number, thing) in run.things.iter().enumerate() {
            let joint = match thing.kind {
                ThingKind::Symbol(symbol) => {
                    last = Some(symbol);
                    rung.push(Piece::Symbol(symbol));
                    continue;
                }
                ThingKind::Joint(joint) => self.joint(joint),
            };
            match buses.get(&joint.vertical) {
                Some(bus) => bus.pieces(row, rung),
                // A rail: of a line that passes by nothing is drawn.
                None if number == 0 && joint.leaves || joint.enters && !joint.leaves => {
                    rung.push(Piece::Rail);
                }
                None => {}
            }
        }
        if is_rung && run.ends_bare() && (self.is_right(run.to) || last.is_some_and(acts)) {
            rung.push(Piece::Rail);
        }
    }
}

/// A line from top to bottom that wires come to and leave.
#[derive(Debug)]
struct Bus {
    /// Its highest and lowest rung.
    top: usize,
    bottom: usize,
    /// The rung from which power is led up to the highest one.
    up_from: Option<usize>,
    /// The rung to which power is led down from the highest one.
    down_to: Option<usize>,
}

impl Bus {
    /// The connectors on a rung.
    fn pieces(&self, row: usize, rung: &mut Vec<Piece>) {
        if self.bottom == self.top + 1 {
            rung.push(if row == self.top { Piece::Down } else { Piece::Up });
            return;
        }
        let between = |end: Option<usize>, both: [Piece; 2]| -> Vec<Piece> {
            match end {
                Some(end) if row <= end && row == self.top => vec![Piece::Down],
                Some(end) if row < end => both.to_vec(),
                Some(end) if row == end => vec![Piece::Up],
                _ => Vec::new(),
            }
        };
        let up = between(self.up_from, [Piece::Down, Piece::Up]);
        let down = between(self.down_to, [Piece::Up, Piece::Down]);
        let parted = row != self.top && !up.is_empty() && !down.is_empty();
        rung.extend(up);
        rung.extend(parted.then_some(Piece::Gap));
        rung.extend(down);
    }
}

/// Without gaps at the ends or next to each other, and with rails only at the ends.
fn tidied(rung: &[Piece]) -> Vec<Piece> {
    let mut tidy: Vec<Piece> = Vec::new();
    for (number, &piece) in rung.iter().enumerate() {
        let is_last = rung[number + 1..].iter().all(|piece| *piece == Piece::Gap);
        match piece {
            Piece::Gap if tidy.last().is_none_or(|last| *last == Piece::Gap) => {}
            Piece::Rail if !tidy.is_empty() && !is_last => {}
            piece => tidy.push(piece),
        }
    }
    while tidy.last() == Some(&Piece::Gap) {
        tidy.pop();
    }
    tidy
}

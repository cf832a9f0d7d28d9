//! Which connectors are drawn as one vertical line.
//!
//! The text draws three branches as a staircase, because a connector joins two lines only. Electrically the steps are
//! one point as long as nothing but bare wire is between them, and a picture draws one point as one line:
//!
//! ```text
//! points   p --bare wire--> q   one node, if all power of q comes from p, or all power of p goes to q
//! node                          one line, as far as on every rung nothing is between its connectors
//! ```
//!
//! In a node every wire that comes in reaches every wire that goes out, exactly as through its points: if q gets its
//! power from p alone, then what arrives at p leaves at both; if p gives its power to q alone, then what arrives at
//! either leaves at q. Any other pair of points stays two lines with a wire between them.

use super::figure::{Drawn, Figure, Item};

/// For each rung, which neighbours are connectors on the same vertical line: true at `n` for elements `n` and `n + 1`.
pub(super) type Joints = Vec<Vec<bool>>;

/// Joins no connectors: every pair keeps its own line.
pub(super) fn apart(figure: &Figure) -> Joints {
    let count = |items: &Vec<Item>| vec![false; items.len().saturating_sub(1)];
    figure.rungs.iter().map(count).collect()
}

/// Finds what is drawn as one line.
pub(super) fn joints(figure: &Figure) -> Joints {
    let mut nodes = electrical(figure);
    let joints = figure.rungs.iter().map(|items| {
        let pairs = items.iter().zip(items.iter().skip(1));
        pairs
            .map(|(left, right)| match (&left.drawn, &right.drawn) {
                (Drawn::Connector(p), Drawn::Connector(q)) => nodes.find(*p) == nodes.find(*q),
                _ => false,
            })
            .collect()
    });
    Separation::new(figure, joints.collect()).run()
}

/// The number of pairs of connectors.
pub(super) fn points(figure: &Figure) -> usize {
    let points = figure.rungs.iter().flatten().filter_map(point_of);
    points.max().map_or(0, |last| last + 1)
}

pub(super) fn point_of(item: &Item) -> Option<usize> {
    match item.drawn {
        Drawn::Connector(point) => Some(point),
        _ => None,
    }
}

/// Sets of things that are one.
#[derive(Debug)]
pub(super) struct Sets {
    parent: Vec<usize>,
}

impl Sets {
    pub(super) fn new(count: usize) -> Sets {
        Sets {
            parent: (0..count).collect(),
        }
    }

    /// The one that represents its set.
    pub(super) fn find(&mut self, mut one: usize) -> usize {
        while self.parent[one] != one {
            self.parent[one] = self.parent[self.parent[one]];
            one = self.parent[one];
        }
        one
    }

    /// Makes two sets one; the first represents it.
    pub(super) fn join(&mut self, first: usize, second: usize) {
        let (first, second) = (self.find(first), self.find(second));
        self.parent[second] = first;
    }
}

/// The points of a network as electrical nodes.
fn electrical(figure: &Figure) -> Sets {
    let count = points(figure);
    let mut nodes = Sets::new(count);
    // How many wires come to each node, and leave it.
    let (mut coming, mut leaving) = (vec![0_usize; count], vec![0_usize; count]);
    let mut bare = Vec::new();
    for items in &figure.rungs {
        for (left, right) in items.iter().zip(items.iter().skip(1)) {
            if !right.joined {
                continue;
            }
            let (from, to) = (point_of(left), point_of(right));
            if let Some(from) = from {
                leaving[from] += 1;
            }
            if let Some(to) = to {
                coming[to] += 1;
            }
            bare.extend(from.zip(to));
        }
    }
    // A joined node may make room for another one; a second look finds all that are drawn in practice.
    for _ in 0..2 {
        for &(from, to) in &bare {
            let (from, to) = (nodes.find(from), nodes.find(to));
            if from == to || (coming[to] != 1 && leaving[from] != 1) {
                continue;
            }
            nodes.join(from, to);
            // The wire between them is none any more.
            coming[from] = coming[from] + coming[to] - 1;
            leaving[from] = leaving[from] + leaving[to] - 1;
        }
    }
    nodes
}

/// Takes joints apart until every line is one: two points between the same two rungs are on one line if nothing is
/// between their connectors on both.
struct Separation<'f> {
    figure: &'f Figure,
    joints: Joints,
    /// For each point the elements that are its `\` and its `/`, on the upper and the lower rung.
    ends: Vec<Option<[(usize, usize); 2]>>,
    /// For each rung and element the last `\` up to there, and the last `/`, by their points.
    before: Vec<Vec<[Option<usize>; 2]>>,
    /// For each point the next one between the same rungs.
    next: Vec<Option<usize>>,
    /// For each point whether it is known to be on another line than the next.
    parted: Vec<bool>,
}

impl<'f> Separation<'f> {
    fn new(figure: &'f Figure, joints: Joints) -> Separation<'f> {
        let count = points(figure);
        let mut ends = vec![None; count];
        let mut upper_end = vec![None; count];
        let mut next = vec![None; count];
        let mut before = Vec::with_capacity(figure.rungs.len());
        for (rung, items) in figure.rungs.iter().enumerate() {
            let mut last = [None, None];
            let mut here = Vec::with_capacity(items.len());
            for (index, item) in items.iter().enumerate() {
                if let Some(point) = point_of(item) {
                    // A point is met at its `\` first.
                    match upper_end[point] {
                        None => {
                            upper_end[point] = Some((rung, index));
                            if let Some(left) = last[0].replace(point) {
                                next[left] = Some(point);
                            }
                        }
                        Some(upper) => {
                            ends[point] = Some([upper, (rung, index)]);
                            last[1] = Some(point);
                        }
                    }
                }
                here.push(last);
            }
            before.push(here);
        }
        Separation {
            figure,
            joints,
            ends,
            before,
            next,
            parted: vec![false; count],
        }
    }

    fn run(mut self) -> Joints {
        let mut open: Vec<(usize, usize)> = Vec::new();
        for (rung, joints) in self.joints.iter().enumerate() {
            let gaps = joints.iter().enumerate().filter(|(_, joined)| !**joined);
            open.extend(gaps.map(|(index, _)| (rung, index)));
        }
        while let Some((rung, index)) = open.pop() {
            // On this rung a line ends between two `\`, and between two `/`: so it does on the rungs next to it.
            for side in [0, 1] {
                let Some(point) = self.before[rung][index][side].filter(|&point| !self.parted[point]) else {
                    continue;
                };
                let Some((from, to)) = self.next_to(point, 1 - side) else {
                    continue;
                };
                self.parted[point] = true;
                open.extend(self.part(from.0, from.1, to.1));
            }
        }
        self.joints
    }

    /// Where a point and the next one are on their upper (0) or lower (1) rung.
    fn next_to(&self, point: usize, side: usize) -> Option<((usize, usize), (usize, usize))> {
        let next = self.next[point]?;
        Some((self.ends[point]?[side], self.ends[next]?[side]))
    }

    /// Parts two connectors of a rung, if all between them is joined yet; where the drawing itself has a gap, there.
    fn part(&mut self, rung: usize, from: usize, to: usize) -> Option<(usize, usize)> {
        let between = from..to;
        if !self.joints[rung][between.clone()].iter().all(|joined| *joined) {
            return None;
        }
        let items = &self.figure.rungs[rung];
        let gap = between.clone().find(|&n| !items[n + 1].joined);
        let at = gap.or(between.last())?;
        self.joints[rung][at] = false;
        Some((rung, at))
    }
}

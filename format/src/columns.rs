//! Columns: where every element of a network is (LANGUAGE §8 rules 2, 3 and 5). A pure function of the
//! sketch; text plays no part.
//!
//! First everything is as far left as its neighbours and the pairs allow. That is a longest path in the
//! graph of the rungs' order and the pairs, and the order of evaluation (LANGUAGE §6) is an order of that
//! graph: a rung is followed up to a `\`, then the rung below up to the `/` of the pair, and so on. Each
//! element is met once, so the cost grows with the number of elements and with nothing else.
//!
//! Then, in a network that is railed right, what acts moves right: the same walk from the other end, over the
//! elements that move.

use crate::sketch::{Element, ElementKind, NONE, Sketch};
use std::ops::Range;

/// What the left layout of a network says about the whole of it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct Outline {
    /// One of its rungs begins at the left rail.
    pub(crate) railed_left: bool,
    /// One of its rungs ends at the right rail.
    pub(crate) railed_right: bool,
    /// The column, from 0, that its right rail would have at the least.
    pub(crate) rail: u32,
}

/// The least number of columns between neighbours on a rung.
pub(crate) type Spacing = u32;

/// Works out columns. Keeps its buffers, so that one serves all networks of a file.
#[derive(Debug, Default)]
pub(crate) struct Placer {
    /// For each rung the element that is next.
    cursor: Vec<u32>,
    /// For each rung the column where what was placed on it ends: from the left after its last element, from the
    /// right where the next one may end.
    edge: Vec<u32>,
    /// Rungs that wait for the one below to reach a connector; the last one is being followed.
    stack: Vec<usize>,
    /// For each rung its first element that moves right. What moves is always the rung's end.
    moving: Vec<u32>,
    /// For each rung: up to here the partners know that they do not move.
    passed_on: Vec<u32>,
    queue: Vec<usize>,
}

impl Placer {
    /// Sets the columns (from 0) of the elements of some rungs, which form a network, as far left as possible.
    pub(crate) fn place_left(
        &mut self,
        sketch: &Sketch,
        rungs: Range<usize>,
        spacing: Spacing,
        columns: &mut [u32],
    ) -> Outline {
        let elements = |rung: usize| sketch.rung(rung);
        let mut outline = Outline {
            railed_left: rungs.clone().any(|r| {
                elements(r)
                    .first()
                    .is_some_and(|e| e.kind == ElementKind::LeftRail)
            }),
            railed_right: rungs.clone().any(|r| {
                elements(r)
                    .last()
                    .is_some_and(|e| e.kind == ElementKind::RightRail)
            }),
            rail: 0,
        };
        let margin = if outline.railed_left { 1 + spacing } else { 0 };
        let first = rungs.start;
        self.cursor.clear();
        self.edge.clear();
        for range in &sketch.rungs[rungs.clone()] {
            self.cursor.push(range.start);
            let at_rail = sketch.elements[range.start as usize..range.end as usize]
                .first()
                .is_some_and(|e| matches!(e.kind, ElementKind::LeftRail | ElementKind::LeftBar));
            self.edge.push(if at_rail { 0 } else { margin });
        }
        for top in 0..rungs.len() {
            self.stack.clear();
            self.stack.push(top);
            while let Some(&rung) = self.stack.last() {
                let at = self.cursor[rung];
                if at == sketch.rungs[first + rung].end {
                    self.stack.pop();
                    continue;
                }
                let element = &sketch.elements[at as usize];
                let distance = |rung: usize, at: u32| {
                    let is_first = at == sketch.rungs[first + rung].start;
                    if is_first {
                        0
                    } else {
                        distance(sketch, at, spacing)
                    }
                };
                if element.partner == NONE {
                    let column = self.edge[rung] + distance(rung, at);
                    put(sketch, columns, at, column);
                    self.edge[rung] = column + element.width;
                    self.cursor[rung] += 1;
                } else if element.kind == ElementKind::Up {
                    // The rung above waits for this one.
                    self.stack.pop();
                } else if self.cursor[rung + 1] == element.partner {
                    let above = self.edge[rung] + distance(rung, at);
                    let below = self.edge[rung + 1] + distance(rung + 1, element.partner);
                    let column = above.max(below);
                    put(sketch, columns, at, column);
                    put(sketch, columns, element.partner, column);
                    for side in [rung, rung + 1] {
                        self.edge[side] = column + 1;
                        self.cursor[side] += 1;
                    }
                } else {
                    self.stack.push(rung + 1);
                }
            }
        }
        for (rung, range) in rungs.clone().enumerate() {
            let rail = match elements(range).last().map(|e| e.kind) {
                None => self.edge[rung],
                // A rung that ends at the rail has its last element in the rail's column.
                Some(ElementKind::RightRail | ElementKind::RightBar) => self.edge[rung] - 1,
                Some(_) => self.edge[rung] + spacing,
            };
            outline.rail = outline.rail.max(rail);
        }
        outline
    }

    /// Moves right what acts, in a network that is railed right in column `rail` (from 0) and was placed left.
    pub(crate) fn place_right(
        &mut self,
        sketch: &Sketch,
        rungs: Range<usize>,
        spacing: Spacing,
        rail: u32,
        columns: &mut [u32],
    ) {
        self.find_moving(sketch, rungs.clone());
        let first = rungs.start;
        self.cursor.clear();
        self.edge.clear();
        for range in &sketch.rungs[rungs.clone()] {
            self.cursor.push(range.end);
            self.edge.push(rail.saturating_sub(spacing));
        }
        for top in 0..rungs.len() {
            self.stack.clear();
            self.stack.push(top);
            while let Some(&rung) = self.stack.last() {
                if self.cursor[rung] == self.moving[rung] {
                    self.stack.pop();
                    continue;
                }
                let at = self.cursor[rung] - 1;
                let element = &sketch.elements[at as usize];
                match element.kind {
                    ElementKind::RightRail | ElementKind::RightBar => {
                        put(sketch, columns, at, rail);
                        self.cursor[rung] = at;
                    }
                    _ if element.partner == NONE => {
                        let column = self.edge[rung] - element.width;
                        put(sketch, columns, at, column);
                        self.edge[rung] = column.saturating_sub(spacing);
                        self.cursor[rung] = at;
                    }
                    ElementKind::Up => {
                        self.stack.pop();
                    }
                    _ if self.cursor[rung + 1] == element.partner + 1 => {
                        let column = self.edge[rung].min(self.edge[rung + 1]) - 1;
                        put(sketch, columns, at, column);
                        put(sketch, columns, element.partner, column);
                        for side in [rung, rung + 1] {
                            self.edge[side] = column.saturating_sub(spacing);
                            self.cursor[side] -= 1;
                        }
                    }
                    _ => self.stack.push(rung + 1),
                }
            }
        }
        debug_assert!(first + self.moving.len() == rungs.end);
    }

    /// Finds what moves right. An acting block does if everything right of it on its rung does; a pair or a
    /// comment needs something that moves directly left of it besides. The two lean on each other (a coil
    /// before a closing pair, the pair because of the coil), so the answer is the largest set that holds:
    /// begin with all that could, and take away what cannot.
    fn find_moving(&mut self, sketch: &Sketch, rungs: Range<usize>) {
        let first = rungs.start;
        self.moving.clear();
        self.passed_on.clear();
        self.queue.clear();
        for range in &sketch.rungs[rungs.clone()] {
            let elements = &sketch.elements[range.start as usize..range.end as usize];
            let still = elements
                .iter()
                .rposition(|e| !could_move(e.kind))
                .map_or(0, |n| n + 1);
            self.moving.push(range.start + still as u32);
            self.passed_on.push(range.start);
        }
        for rung in 0..rungs.len() {
            self.queue.push(rung);
            for at in self.moving[rung]..sketch.rungs[first + rung].end {
                if !sketch.elements[at as usize].joined {
                    self.check_support(sketch, rung, at);
                }
            }
        }
        while let Some(rung) = self.queue.pop() {
            let moving = self.moving[rung];
            for at in self.passed_on[rung]..moving {
                let element = &sketch.elements[at as usize];
                if element.partner != NONE {
                    let other = partners_rung(rung, element.kind);
                    self.stop(other, element.partner);
                }
            }
            self.passed_on[rung] = moving;
            if moving < sketch.rungs[first + rung].end {
                self.check_support(sketch, rung, moving);
            }
        }
    }

    /// Stops a pair or a comment that has nothing directly left of it that moves.
    fn check_support(&mut self, sketch: &Sketch, rung: usize, at: u32) {
        let element = &sketch.elements[at as usize];
        match element.kind {
            ElementKind::Comment if !self.is_supported(sketch, rung, at) => self.stop(rung, at),
            ElementKind::Down | ElementKind::Up if element.partner == NONE => self.stop(rung, at),
            ElementKind::Down | ElementKind::Up => {
                let other = partners_rung(rung, element.kind);
                if !self.is_supported(sketch, rung, at) && !self.is_supported(sketch, other, element.partner)
                {
                    self.stop(rung, at);
                    self.stop(other, element.partner);
                }
            }
            _ => {}
        }
    }

    fn is_supported(&self, sketch: &Sketch, rung: usize, at: u32) -> bool {
        sketch.elements[at as usize].joined && at > self.moving[rung]
    }

    /// The element, and with it all left of it on its rung, does not move.
    fn stop(&mut self, rung: usize, at: u32) {
        if self.moving[rung] <= at {
            self.moving[rung] = at + 1;
            self.queue.push(rung);
        }
    }
}

/// How far an element is from the one before it on its rung. A stub is the end of a wire: it touches what the
/// wire leads to.
fn distance(sketch: &Sketch, at: u32, spacing: Spacing) -> u32 {
    let [before, element] = [at - 1, at].map(|n| &sketch.elements[n as usize]);
    let is_stub = |e: &Element| e.kind == ElementKind::Stub;
    if element.joined && (is_stub(before) || is_stub(element)) {
        0
    } else {
        spacing
    }
}

/// Sets the column of an element, and with it that of a stub before it, where its wire begins.
fn put(sketch: &Sketch, columns: &mut [u32], at: u32, column: u32) {
    let mut at = at as usize;
    columns[at] = column;
    while sketch.elements[at].joined && sketch.elements[at - 1].kind == ElementKind::Stub {
        columns[at - 1] = columns[at] - sketch.elements[at - 1].width;
        at -= 1;
    }
}

fn could_move(kind: ElementKind) -> bool {
    matches!(
        kind,
        ElementKind::RightRail
            | ElementKind::RightBar
            | ElementKind::Acting
            | ElementKind::Down
            | ElementKind::Up
            | ElementKind::Comment
    )
}

fn partners_rung(rung: usize, kind: ElementKind) -> usize {
    if kind == ElementKind::Down {
        rung + 1
    } else {
        rung - 1
    }
}

#[cfg(test)]
#[path = "columns_tests.rs"]
mod tests;

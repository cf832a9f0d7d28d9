//! Wires that come back to where they began, as a generator sees them: it runs each block once, after what feeds it, and of a block that
//! is on its way it reads what that left in the scan before.

use crate::graph::{End, Graph, Kind, Node};
use ladder_notation::{LineColumn, Report};

/// The wires of a drawing are no deeper.
const DEEPEST: usize = 300;

/// A drawing has no more loops than these.
const MOST_LOOPS: usize = 200;

impl Graph {
    /// Makes sure that it can be drawn: without what connects nothing, and without circles of wires; one that is too deep keeps its
    /// comments only.
    pub fn open(&mut self, report: &mut Report) {
        self.without_loose();
        match self.without_loops() {
            Ok(taken) => {
                for place in taken {
                    let why = "its power comes back to it, without a block between: that wire is left out";
                    report.refused(place, "wire", why);
                }
            }
            Err(node) => {
                let why = format!(
                    "more than {DEEPEST} elements or {MOST_LOOPS} loops are in it: nothing of it is read"
                );
                let place = self.nodes.get(node).map_or(LineColumn::START, |node| node.place);
                report.refused(place, "drawing", &why);
                self.nodes.retain(|node| matches!(node.kind, Kind::Comment(_)));
                self.nodes.push(Node::new(
                    place,
                    Kind::Comment(format!("A drawing is not read: {why}")),
                    Vec::new(),
                ));
                self.feedback.clear();
            }
        }
    }

    /// Wires from blocks that did not run yet go into [`Graph::feedback`]; those of circles without a block are taken out, and the
    /// places of their ends come back. The error is the element that is too deep.
    fn without_loops(&mut self) -> Result<Vec<LineColumn>, usize> {
        let has_turn = self.turns();
        let by_place = self.by_place();
        let (turns, others): (Vec<usize>, Vec<usize>) =
            by_place.into_iter().partition(|node| has_turn[*node]);
        let count = self.nodes.len();
        let mut walk = Walk {
            graph: self,
            visits: vec![Visit::New; count],
            depths: vec![0; count],
            path: Vec::new(),
            taken: Vec::new(),
            loops: 0,
        };
        for node in turns.into_iter().chain(others) {
            if walk.visits[node] == Visit::New {
                walk.visit(node, false)?;
            }
        }
        Ok(walk.taken)
    }
}

#[derive(Clone, Copy, PartialEq)]
enum Visit {
    New,
    Open,
    Done,
}

struct Walk<'g> {
    graph: &'g mut Graph,
    visits: Vec<Visit>,
    /// How many elements are before each, the longest way.
    depths: Vec<usize>,
    /// The elements that are open.
    path: Vec<usize>,
    taken: Vec<LineColumn>,
    loops: usize,
}

impl Walk<'_> {
    /// An element, after all that feeds it. A block with a number of its own runs no other, and what comes to it `only_reads`, too.
    fn visit(&mut self, node: usize, only_reads: bool) -> Result<(), usize> {
        if self.path.len() > DEEPEST {
            return Err(node);
        }
        self.visits[node] = Visit::Open;
        self.path.push(node);
        let only_reads = if self.is_block(node) {
            self.graph.nodes[node].order.is_some()
        } else {
            only_reads
        };
        for pin in 0..self.graph.nodes[node].inputs.len() {
            let mut wire = 0;
            while let Some(end) = self.graph.nodes[node].inputs[pin].from.get(wire).copied() {
                match self.visits[end.node] {
                    Visit::Done => {}
                    Visit::New if only_reads && self.is_block(end.node) => self.feeds_back(node, end)?,
                    Visit::New => self.visit(end.node, only_reads)?,
                    Visit::Open if self.is_block(end.node) => self.feeds_back(node, end)?,
                    Visit::Open if self.is_block_after(end.node) => {
                        self.graph.nodes[node].inputs[pin].from[wire] = self.again(end)?;
                        continue;
                    }
                    Visit::Open => {
                        self.taken.push(self.graph.nodes[node].place);
                        self.graph.nodes[node].inputs[pin].from.remove(wire);
                        self.count(node)?;
                        continue;
                    }
                }
                if self.visits[end.node] == Visit::Done {
                    self.depths[node] = self.depths[node].max(self.depths[end.node]);
                }
                wire += 1;
            }
        }
        self.depths[node] += 1;
        if self.depths[node] > DEEPEST {
            return Err(node);
        }
        self.visits[node] = Visit::Done;
        self.path.pop();
        Ok(())
    }

    fn is_block(&self, node: usize) -> bool {
        matches!(self.graph.nodes[node].kind, Kind::Block { .. })
    }

    /// Whether a block is open that an open element feeds.
    fn is_block_after(&self, node: usize) -> bool {
        let after = self.path.iter().rev().take_while(|open| **open != node);
        after.into_iter().any(|open| self.is_block(*open))
    }

    fn feeds_back(&mut self, node: usize, end: End) -> Result<(), usize> {
        self.graph.feedback.insert((node, end));
        self.count(node)
    }

    /// An open element once more, for a block that is before it, too: it has other power there. What is done is done once.
    fn again(&mut self, end: End) -> Result<End, usize> {
        self.count(end.node)?;
        let drawn = &self.graph.nodes[end.node];
        let kind = match &drawn.kind {
            kind @ Kind::Contact(..) => kind.clone(),
            _ => Kind::Joint,
        };
        let inputs = drawn.inputs.clone();
        let copy = Node {
            position: drawn.position,
            ..Node::new(drawn.place, kind, inputs)
        };
        self.graph.nodes.push(copy);
        self.visits.push(Visit::New);
        self.depths.push(0);
        let node = self.graph.nodes.len() - 1;
        Ok(End { node, output: 0 })
    }

    fn count(&mut self, node: usize) -> Result<(), usize> {
        self.loops += 1;
        if self.loops > MOST_LOOPS {
            Err(node)
        } else {
            Ok(())
        }
    }
}

//! A body in LD or FBD: elements, and the wires between their pins.

use super::standard::{self, Function};
use ladder_notation::{LineColumn, Report};
use std::collections::HashSet;

/// The elements of a body, in the order of the file.
#[derive(Debug, Default)]
pub struct Graph {
    /// See above.
    pub nodes: Vec<Node>,
    /// What an element sees of the scan before: which element, of which output.
    pub(crate) feedback: HashSet<(usize, End)>,
}

/// An element.
#[derive(Debug)]
pub struct Node {
    /// Where it is in the file.
    pub place: LineColumn,
    /// Where it is in the drawing: from the left, from the top.
    pub position: (f64, f64),
    /// Its number in the order of execution, if it has one.
    pub order: Option<u32>,
    /// What it is.
    pub kind: Kind,
    /// Where power and values enter.
    pub inputs: Vec<Pin>,
    /// Where they leave.
    pub outputs: Vec<Output>,
}

/// Where power or a value enters.
#[derive(Debug, Default)]
pub struct Pin {
    /// `EN`, `IN1`; empty where there is only one.
    pub name: String,
    /// What is done to it.
    pub modifier: Modifier,
    /// The outputs that are wired to it; several are OR.
    pub from: Vec<End>,
    /// It is a reference to a variable: the pin of a VAR_IN_OUT.
    pub in_out: bool,
}

/// Where power or a value leaves.
#[derive(Debug, Default)]
pub struct Output {
    /// `Q`, `ENO`; empty where there is only one.
    pub name: String,
    /// It is inverted.
    pub negated: bool,
}

/// What is done to power.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Modifier {
    /// It is inverted.
    pub negated: bool,
    /// Only its changes count.
    pub edge: Edge,
}

/// Which changes count.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Edge {
    /// All of it counts.
    #[default]
    None,
    /// The scan in which it comes.
    Rising,
    /// The scan in which it goes.
    Falling,
}

/// One output of one element.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct End {
    /// The element.
    pub node: usize,
    /// Which of its outputs.
    pub output: usize,
}

/// What an element is.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Kind {
    /// Where power comes from.
    LeftRail,
    /// Where it ends.
    RightRail,
    /// With its variable.
    Contact(String, Modifier),
    /// With its variable.
    Coil(String, Modifier, Storage),
    /// A function, or an instance of a function block.
    Block {
        /// `TON`
        name: String,
        /// `T1`
        instance: Option<String>,
        /// The text of one that is written in ST.
        code: Option<String>,
    },
    /// A value: its expression, and whether it is inverted.
    Value(String, bool),
    /// A variable that is written, and whether inverted.
    Variable(String, bool),
    /// A mark that jumps go to.
    Label(String),
    /// A jump.
    Jump(String, bool),
    /// The end of the unit's run.
    Return(bool),
    /// A point of the wire: connectors, continuations, the ends of branches.
    Joint,
    /// Its text.
    Comment(String),
    /// What has no counterpart; what it is.
    Other(String),
}

/// What a coil does.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Storage {
    /// Writes.
    #[default]
    None,
    /// Latches.
    Set,
    /// Unlatches.
    Reset,
}

impl Node {
    /// An element with one pin and one output.
    pub fn new(place: LineColumn, kind: Kind, inputs: Vec<Pin>) -> Node {
        Node {
            place,
            position: (0.0, 0.0),
            order: None,
            kind,
            inputs,
            outputs: vec![Output::default()],
        }
    }
}

impl Graph {
    /// The names of the blocks that stand in it.
    pub(crate) fn blocks(&self) -> impl Iterator<Item = &str> {
        self.nodes.iter().filter_map(|node| match &node.kind {
            Kind::Block { name, .. } => Some(name.as_str()),
            _ => None,
        })
    }

    /// The texts in ST that stand in it.
    pub(crate) fn codes(&self) -> impl Iterator<Item = &str> {
        self.nodes.iter().filter_map(|node| match &node.kind {
            Kind::Block { code, .. } => code.as_deref(),
            _ => None,
        })
    }

    /// For each element the number of the part of the drawing that it is in. Rails join nothing.
    #[cfg(test)]
    pub(crate) fn parts(&self) -> Vec<usize> {
        let mut root: Vec<usize> = (0..self.nodes.len()).collect();
        let is_rail = |node: usize| matches!(self.nodes[node].kind, Kind::LeftRail | Kind::RightRail);
        for (index, node) in self.nodes.iter().enumerate() {
            for end in node.inputs.iter().flat_map(|pin| &pin.from) {
                if !is_rail(index) && !is_rail(end.node) {
                    let (one, other) = (find(&mut root, index), find(&mut root, end.node));
                    root[one.max(other)] = one.min(other);
                }
            }
        }
        (0..root.len()).map(|node| find(&mut root, node)).collect()
    }

    /// The elements in the order of the drawing: numbered ones first, then row by row, elements whose tops differ by less
    /// than ten units being in one row, as the generator of OpenPLC has it. Without positions the order of the file.
    pub(crate) fn in_order(&self) -> Vec<usize> {
        let mut order: Vec<usize> = (0..self.nodes.len()).collect();
        order.sort_by(|one, other| {
            self.nodes[*one]
                .position
                .1
                .total_cmp(&self.nodes[*other].position.1)
        });
        let mut row = 0;
        let mut top = f64::NEG_INFINITY;
        let mut keys = vec![(0, 0.0); self.nodes.len()];
        for node in &order {
            let (left, y) = self.nodes[*node].position;
            if y - top >= ROW {
                (row, top) = (row + 1, y);
            }
            keys[*node] = (row, left);
        }
        order.sort_by(|one, other| {
            let number = |node: &usize| self.nodes[*node].order.unwrap_or(u32::MAX);
            let by_number = number(one).cmp(&number(other));
            let by_row = keys[*one].0.cmp(&keys[*other].0);
            let by_left = keys[*one].1.total_cmp(&keys[*other].1);
            by_number.then(by_row).then(by_left).then(one.cmp(other))
        });
        order
    }
}

/// Elements whose tops differ by less are in one row.
const ROW: f64 = 10.0;

#[cfg(test)]
fn find(root: &mut [usize], mut node: usize) -> usize {
    while root[node] != node {
        root[node] = root[root[node]];
        node = root[node];
    }
    node
}

impl Graph {
    /// Puts the elements of another drawing below those of this one.
    pub(crate) fn append(&mut self, other: Graph) {
        let before = self.nodes.len();
        let below = |graph: &Graph| graph.nodes.iter().map(|node| node.position.1).fold(0.0, f64::max);
        let shift = below(self) + 1_000.0;
        let is_placed = below(&other) > 0.0 || below(self) > 0.0;
        let moved = |end: End| End {
            node: end.node + before,
            ..end
        };
        self.feedback.extend(
            other
                .feedback
                .iter()
                .map(|(node, end)| (node + before, moved(*end))),
        );
        for mut node in other.nodes {
            if is_placed {
                node.position.1 += shift;
            }
            for end in node.inputs.iter_mut().flat_map(|pin| &mut pin.from) {
                end.node += before;
            }
            self.nodes.push(node);
        }
    }
}

/// A wire: to this pin of this element, the n-th of those that end there.
type Wire = (usize, usize, usize);

/// The wires of a drawing are no deeper.
const DEEPEST: usize = 300;

/// A drawing has no more loops than these.
const MOST_LOOPS: usize = 200;

impl Graph {
    /// Makes sure that it can be drawn: wires that make a circle are taken out, and one that is too deep keeps its
    /// comments only.
    pub fn open(&mut self, report: &mut Report) {
        match self.without_loops() {
            Ok(taken) => {
                for (node, _) in taken {
                    let why = "its power comes back to it, without a block between: that wire is left out";
                    report.refused(self.nodes[node].place, "wire", why);
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

    /// Takes apart what is wired in a circle: a wire from a block that acts shows what the block had in the scan before, and
    /// goes into [`Graph::feedback`]; any other is taken out and comes back. The error is the element that is too deep.
    fn without_loops(&mut self) -> Result<Vec<(usize, usize)>, usize> {
        let acts = |kind: &Kind| match kind {
            Kind::Block { name, .. } => !matches!(
                standard::function(name),
                Some(Function::Gate(_) | Function::Compare(..))
            ),
            _ => false,
        };
        let mut taken = Vec::new();
        for _ in 0..=MOST_LOOPS {
            let Some(circle) = self.circle()? else {
                return Ok(taken);
            };
            let source = |wire: &Wire| self.nodes[wire.0].inputs[wire.1].from[wire.2];
            let from_block = circle
                .iter()
                .find(|wire| acts(&self.nodes[source(wire).node].kind));
            if let Some(wire) = from_block {
                let end = source(wire);
                self.feedback.insert((wire.0, end));
            } else if let Some(&(node, pin, wire)) = circle.last() {
                self.nodes[node].inputs[pin].from.remove(wire);
                taken.push((node, pin));
            }
        }
        Err(taken.first().map_or(0, |(node, _)| *node))
    }

    /// A circle of wires, if there is one.
    fn circle(&self) -> Result<Option<Vec<Wire>>, usize> {
        #[derive(Clone, Copy, PartialEq)]
        enum State {
            New,
            Open,
            Done,
        }
        let mut state = vec![State::New; self.nodes.len()];
        let mut depth = vec![0; self.nodes.len()];
        // Elements that are open, each with the next of its wires and the wire that it is the source of.
        let mut stack: Vec<(usize, usize, Option<Wire>)> = Vec::new();
        let wires: Vec<Vec<Wire>> = self
            .nodes
            .iter()
            .enumerate()
            .map(|(node, it)| {
                let pins = it.inputs.iter().enumerate();
                pins.flat_map(|(pin, it)| (0..it.from.len()).map(move |wire| (node, pin, wire)))
                    .collect()
            })
            .collect();
        for start in 0..self.nodes.len() {
            if state[start] != State::New {
                continue;
            }
            stack.push((start, 0, None));
            state[start] = State::Open;
            while let Some((node, next, _)) = stack.last_mut() {
                let Some(&wire) = wires[*node].get(*next) else {
                    let sources = wires[*node]
                        .iter()
                        .map(|(node, pin, wire)| self.nodes[*node].inputs[*pin].from[*wire]);
                    let sources = sources.filter(|end| !self.feedback.contains(&(*node, *end)));
                    depth[*node] = 1 + sources.map(|end| depth[end.node]).max().unwrap_or(0);
                    if depth[*node] > DEEPEST {
                        return Err(*node);
                    }
                    state[*node] = State::Done;
                    stack.pop();
                    continue;
                };
                *next += 1;
                let end = self.nodes[wire.0].inputs[wire.1].from[wire.2];
                if self.feedback.contains(&(wire.0, end)) {
                    continue;
                }
                match state[end.node] {
                    State::Done => {}
                    State::Open => {
                        let begin = stack.iter().position(|(node, ..)| *node == end.node).unwrap_or(0);
                        let path = stack[begin + 1..].iter().filter_map(|(_, _, wire)| *wire);
                        return Ok(Some(path.chain([wire]).collect()));
                    }
                    State::New => {
                        state[end.node] = State::Open;
                        stack.push((end.node, 0, Some(wire)));
                    }
                }
            }
        }
        Ok(None)
    }
}

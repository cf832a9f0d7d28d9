//! A body in LD or FBD: elements, and the wires between their pins.

use ladder_notation::LineColumn;
use std::collections::HashSet;

/// The elements of a body, in the order of the file.
#[derive(Debug, Clone, Default)]
pub struct Graph {
    /// See above.
    pub nodes: Vec<Node>,
    /// Where each network begins, if the file has one after the other.
    pub networks: Vec<LineColumn>,
    /// What an element sees of the scan before: which element, of which output.
    pub(crate) feedback: HashSet<(usize, End)>,
}

/// An element.
#[derive(Debug, Clone)]
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
#[derive(Debug, Clone, Default)]
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
#[derive(Debug, Clone, Default)]
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
        code: Option<Code>,
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

/// The text of a block.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Code {
    /// What it says.
    pub text: String,
    /// Where it begins, if its lines are lines of the file.
    pub place: Option<LineColumn>,
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

    /// The elements that are texts in ST.
    pub(crate) fn codes(&self) -> impl Iterator<Item = (usize, &Code)> {
        let nodes = self.nodes.iter().enumerate();
        nodes.filter_map(|(number, node)| match &node.kind {
            Kind::Block { code, .. } => Some((number, code.as_ref()?)),
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
    pub(crate) fn by_place(&self) -> Vec<usize> {
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

//! Where the elements of a drawing stand. What is done is from top to bottom in its order: that is the order in which
//! generators take it.

use crate::graph::{End, Graph, Kind, Node};

/// The size of a contact or coil.
const SWITCH: (f64, f64) = (30.0, 20.0);

/// From one pin of a block to the next, and from its top to the first.
const PIN: f64 = 30.0;

/// Between two rows, and between two elements of a row.
const GAP: f64 = 40.0;

/// Elements whose tops differ by less are in one row.
const ROW: f64 = 10.0;

/// How wide a character is.
const CHARACTER: f64 = 8.0;

/// The left rails stand here.
const LEFT: f64 = 10.0;

/// Width and height of an element.
pub(super) fn size(node: &Node) -> (f64, f64) {
    let wide = |text: &str| CHARACTER * text.chars().count() as f64;
    match &node.kind {
        Kind::LeftRail | Kind::RightRail => (10.0, 40.0),
        Kind::Contact(..) | Kind::Coil(..) => SWITCH,
        Kind::Block { name, instance, .. } => {
            let longest = |names: &mut dyn Iterator<Item = &str>| names.map(wide).fold(0.0, f64::max);
            let pins = longest(&mut node.inputs.iter().map(|pin| pin.name.as_str()))
                + longest(&mut node.outputs.iter().map(|output| output.name.as_str()))
                + 20.0;
            let title = wide(name).max(wide(instance.as_deref().unwrap_or_default())) + 20.0;
            let rows = node.inputs.len().max(node.outputs.len()).max(1) as f64;
            (tens(pins.max(title)), PIN * rows + 10.0)
        }
        Kind::Value(text, _) | Kind::Variable(text, _) => (tens(wide(text) + 20.0), 30.0),
        Kind::Label(name) | Kind::Jump(name, _) => (tens(wide(name) + 20.0), 20.0),
        Kind::Return(_) => (60.0, 20.0),
        Kind::Comment(text) => {
            let longest = text.lines().map(wide).fold(0.0, f64::max);
            (
                tens(longest + 20.0).max(120.0),
                20.0 * text.lines().count() as f64 + 20.0,
            )
        }
        Kind::Joint | Kind::Other(_) => (10.0, 10.0),
    }
}

fn tens(number: f64) -> f64 {
    (number / 10.0).ceil() * 10.0
}

/// Where a pin is, from the left and top of its element.
pub(super) fn pin(node: &Node, pin: usize) -> (f64, f64) {
    match node.kind {
        Kind::Block { .. } => (0.0, PIN * (pin as f64 + 1.0)),
        _ => (0.0, size(node).1 / 2.0),
    }
}

/// Where an output is, from the left and top of its element.
pub(super) fn output(node: &Node, output: usize) -> (f64, f64) {
    let (_, y) = pin(node, output);
    (size(node).0, y)
}

/// A point of the drawing.
pub(super) fn at(node: &Node, (x, y): (f64, f64)) -> (f64, f64) {
    (node.position.0 + x, node.position.1 + y)
}

struct Layout<'g> {
    graph: &'g mut Graph,
    /// The lowest point so far, from the top.
    bottom: f64,
    /// The top of the last element that is done, and its right end.
    last: (f64, f64),
    /// The height of the line of each element: that of its first pin or output.
    lines: Vec<f64>,
    /// The elements whose line goes on in another already.
    goes_on: Vec<bool>,
    /// The left rail of this network.
    rail: Option<usize>,
}

/// Finds the place of each element of a drawing. Its elements are in the order in which they run, a rail before those of its
/// network.
pub(super) fn lay_out(graph: &mut Graph) {
    let count = graph.nodes.len();
    let mut layout = Layout {
        graph,
        bottom: 0.0,
        last: (0.0, 0.0),
        lines: vec![0.0; count],
        goes_on: vec![false; count],
        rail: None,
    };
    for node in 0..count {
        layout.place(node);
    }
}

impl Layout<'_> {
    fn place(&mut self, node: usize) {
        match &self.graph.nodes[node].kind {
            Kind::LeftRail => {
                self.rail = Some(node);
                self.lines[node] = self.bottom + GAP;
                self.graph.nodes[node].position = (LEFT, self.bottom + GAP - 20.0);
            }
            Kind::Comment(_) | Kind::Label(_) => {
                let (_, height) = size(&self.graph.nodes[node]);
                self.graph.nodes[node].position = (LEFT + 10.0, self.bottom + 20.0);
                self.bottom += 20.0 + height;
            }
            // Next to the block that it is for.
            Kind::Value(..) => {}
            _ => self.element(node),
        }
    }

    fn is_value(&self, end: End) -> bool {
        matches!(self.graph.nodes[end.node].kind, Kind::Value(..))
    }

    fn element(&mut self, node: usize) {
        let inputs = &self.graph.nodes[node].inputs;
        let sources: Vec<End> = inputs.iter().flat_map(|pin| pin.from.iter().copied()).collect();
        let (values, powers): (Vec<End>, Vec<End>) = sources.into_iter().partition(|end| self.is_value(*end));
        let right = |end: &End| {
            let source = &self.graph.nodes[end.node];
            source.position.0 + size(source).0
        };
        let widest = values
            .iter()
            .map(|end| size(&self.graph.nodes[end.node]).0)
            .fold(0.0, f64::max);
        let from = powers.iter().map(right).fold(LEFT + 10.0, f64::max);
        let x = tens(from + GAP + if values.is_empty() { 0.0 } else { widest + 20.0 });
        let above = match self.graph.nodes[node].kind {
            Kind::Block { .. } => PIN,
            _ => size(&self.graph.nodes[node]).1 / 2.0,
        };
        let line = self.line(node, (x, above), powers.first().copied());
        self.graph.nodes[node].position = (x, line - above);
        self.lines[node] = line;
        if let Some(first) = powers.first() {
            self.goes_on[first.node] = true;
        }
        let (width, height) = size(&self.graph.nodes[node]);
        self.bottom = self.bottom.max(line - above + height);
        if is_done(&self.graph.nodes[node].kind) {
            self.last = (line - above, x + width);
        }
        for (number, pin_at) in self.pins(node) {
            for end in self.graph.nodes[node].inputs[number].from.clone() {
                if self.is_value(end) {
                    let (width, height) = size(&self.graph.nodes[end.node]);
                    self.graph.nodes[end.node].position = (x - 20.0 - width, pin_at - height / 2.0);
                    self.bottom = self.bottom.max(pin_at + height / 2.0);
                }
            }
        }
    }

    fn pins(&self, node: usize) -> Vec<(usize, f64)> {
        let drawn = &self.graph.nodes[node];
        let all = 0..drawn.inputs.len();
        all.map(|number| (number, at(drawn, pin(drawn, number)).1))
            .collect()
    }

    /// The line that an element is on: that of what feeds it, where nothing else is there yet; else a new one
    /// below.
    fn line(&self, node: usize, (x, above): (f64, f64), first: Option<End>) -> f64 {
        let below = self.bottom.max(self.lines[self.rail.unwrap_or(0)] - GAP) + GAP;
        let Some(first) = first else { return below };
        let source = &self.graph.nodes[first.node];
        let line = match source.kind {
            Kind::LeftRail if !self.goes_on[first.node] => self.lines[first.node],
            Kind::LeftRail => return below,
            Kind::Block { .. } => at(source, output(source, first.output)).1,
            _ => self.lines[first.node],
        };
        let is_free = !self.goes_on[first.node] || line > self.lines[first.node];
        let top = line - above;
        let is_in_order = !is_done(&self.graph.nodes[node].kind)
            || top >= self.last.0 + ROW
            || (top > self.last.0 - ROW && x >= self.last.1);
        if is_free && is_in_order { line } else { below }
    }
}

/// Whether a generator takes an element for itself.
fn is_done(kind: &Kind) -> bool {
    !matches!(kind, Kind::Contact(..) | Kind::Value(..) | Kind::Joint)
}

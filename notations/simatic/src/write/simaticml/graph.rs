//! A network as a graph of parts, in the order of the power.

use crate::model::{Net, Part, RAIL, Type, Unit};
use crate::operand::operand;
use crate::scope::Scope;
use crate::standard::{Row, of_document, power_pins};
use std::collections::HashMap;

/// What is in the list of parts.
pub(super) enum Node<'n> {
    Part(&'n Part, Shape<'n>),
    /// So many wires come together.
    Or(usize),
}

/// How a part is written.
pub(super) struct Shape<'n> {
    pub(super) row: Option<&'static Row>,
    pub(super) name: &'static str,
    pub(super) negated: bool,
    /// Of a call: the block, and what holds its state.
    pub(super) callee: Option<&'n Unit>,
}

/// Where power comes from: the rail, or a pin of a node.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum Source {
    Rail,
    Pin(usize, &'static str),
}

/// A network as nodes, and what takes the power of each source.
pub(super) struct Graph<'n> {
    pub(super) nodes: Vec<Node<'n>>,
    pub(super) sinks: HashMap<Source, Vec<(usize, String)>>,
    /// The sources that the power of each node comes from.
    pub(super) sources: Vec<Vec<Source>>,
}

impl<'n> Graph<'n> {
    /// The nodes of a network whose wires are in the order of the power.
    pub(super) fn of(net: &'n Net, scope: &mut Scope<'n>) -> Result<Graph<'n>, String> {
        let mut graph = Graph {
            nodes: Vec::new(),
            sinks: HashMap::new(),
            sources: Vec::new(),
        };
        let mut counts = vec![0usize; net.points];
        for to in net.wires.iter().filter_map(|wire| wire.to) {
            counts[to] += 1;
        }
        let mut into: Vec<Vec<Source>> = vec![Vec::new(); net.points];
        let mut at: Vec<Option<Source>> = vec![None; net.points];
        at[RAIL] = Some(Source::Rail);
        for wire in &net.wires {
            let mut source = at[wire.from].ok_or("no power reaches a part of it")?;
            for part in &wire.parts {
                source = graph.part(part, source, scope)?;
            }
            let Some(to) = wire.to else { continue };
            into[to].push(source);
            if into[to].len() == counts[to] {
                at[to] = Some(graph.joined(&into[to]));
            }
        }
        let ends = |(number, node): (usize, &Node<'_>)| {
            let is_bits = matches!(node, Node::Part(_, shape) if shape.name.ends_with("Bitfield"));
            is_bits && graph.sinks.contains_key(&Source::Pin(number, "eno"))
        };
        if graph.nodes.iter().enumerate().any(ends) {
            return Err("power does not go on after bits that are set together there".to_owned());
        }
        Ok(graph)
    }

    fn feed(&mut self, source: Source, node: usize, pin: String) {
        self.sources[node].push(source);
        self.sinks.entry(source).or_default().push((node, pin));
    }

    fn push(&mut self, node: Node<'n>) -> usize {
        self.nodes.push(node);
        self.sources.push(Vec::new());
        self.nodes.len() - 1
    }

    fn part(&mut self, part: &'n Part, source: Source, scope: &mut Scope<'n>) -> Result<Source, String> {
        let shape = shape(part, scope)?;
        let (enters, leaves) = power_pins(shape.name);
        let node = self.push(Node::Part(part, shape));
        self.feed(source, node, enters.to_owned());
        Ok(Source::Pin(node, leaves))
    }

    /// Where several wires end.
    fn joined(&mut self, sources: &[Source]) -> Source {
        if let [source] = sources {
            return *source;
        }
        let node = self.push(Node::Or(sources.len()));
        for (number, source) in sources.iter().enumerate() {
            self.feed(*source, node, format!("in{}", number + 1));
        }
        Source::Pin(node, "out")
    }
}

/// How a part is written there.
fn shape<'n>(part: &Part, scope: &mut Scope<'n>) -> Result<Shape<'n>, String> {
    let none = || format!("`{}` has no form there", part.name);
    let Some(row) = of_document(&part.name) else {
        let held = operand(scope, &part.name, "")?.ty;
        let callee = match &held {
            Some(Type::Named(name)) => scope.unit(name),
            _ => None,
        };
        return Ok(Shape {
            row: None,
            name: "Call",
            negated: false,
            callee: Some(callee.ok_or_else(none)?),
        });
    };
    // What is negated is the same with a sign at its operand.
    let plain = part.name.strip_prefix("I_").and_then(of_document).unwrap_or(row);
    Ok(Shape {
        row: Some(row),
        name: plain.xml.first().copied().ok_or_else(none)?,
        negated: row.xml.is_empty(),
        callee: None,
    })
}

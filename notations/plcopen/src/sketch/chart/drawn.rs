//! Conditions that are drawn. Generators write contacts where the condition is asked for; blocks and edges run in an action of their own,
//! which the first step stores, so that a condition sees what they were in the scan before.

use super::Read;
use crate::graph::{Edge, End, Graph, Kind, Modifier, Node, Output, Pin, Storage};
use ladder_notation::LineColumn;
use std::collections::{HashMap, HashSet};

/// What feeds one condition has no more elements.
const MOST: usize = 10_000;

/// What runs apart from the conditions that ask for it.
#[derive(Default)]
pub(super) struct Apart {
    /// In the order of its execution numbers.
    pub(super) graph: Graph,
    /// Elements that are in it already: of which drawing, and of which element.
    places: HashMap<(*const Graph, usize), usize>,
    /// What is asked for, and what it is called.
    asked: HashMap<(*const Graph, End), String>,
    order: u32,
    /// The elements that a condition asks for.
    seen: HashSet<(*const Graph, usize)>,
}

impl Apart {
    /// The condition that ends at an element, as a drawing that ends at a coil of this tag. `fresh` is a name for a BOOL.
    ///
    /// # Errors
    ///
    /// What in it is not known.
    pub(super) fn condition(
        &mut self,
        graph: &Graph,
        (end, tag): (usize, &str),
        fresh: &mut dyn FnMut() -> String,
    ) -> Read<Graph> {
        let mut cone = Graph::default();
        let mut places: HashMap<usize, usize> = HashMap::new();
        let mut waiting = vec![end];
        let mut found = Vec::new();
        while let Some(number) = waiting.pop() {
            if places.contains_key(&number) {
                continue;
            }
            places.insert(number, 0);
            found.push(number);
            self.seen.insert((std::ptr::from_ref(graph), number));
            let node = &graph.nodes[number];
            let is_apart = matches!(node.kind, Kind::Block { .. });
            if !is_apart {
                let ends = node.inputs.iter().flat_map(|pin| &pin.from);
                waiting.extend(ends.map(|end| end.node));
            }
            if found.len() > MOST {
                return Err("its condition is too large".to_owned());
            }
        }
        found.sort_unstable();
        found.retain(|number| *number != end);
        found.push(end);
        for number in &found {
            places.insert(*number, cone.nodes.len());
            let mut node = graph.nodes[*number].clone();
            match &node.kind {
                _ if *number == end => {
                    node.kind = Kind::Coil(tag.to_owned(), Modifier::default(), Storage::None);
                }
                Kind::Contact(variable, modifier) if modifier.edge != Edge::None => {
                    let edge = Kind::Contact(variable.clone(), *modifier);
                    let seen = self.edge(graph, *number, edge, fresh);
                    node.kind = Kind::Contact(seen, Modifier::default());
                }
                // What it says is read below, for each of its outputs.
                Kind::Block { .. } => {}
                Kind::Contact(..) | Kind::LeftRail | Kind::Joint | Kind::Value(..) => {}
                _ => return Err("its condition is not one of contacts and blocks".to_owned()),
            }
            cone.nodes.push(node);
        }
        for place in 0..found.len() {
            for pin in 0..cone.nodes[place].inputs.len() {
                if matches!(cone.nodes[place].kind, Kind::Block { .. }) {
                    break;
                }
                for wire in 0..cone.nodes[place].inputs[pin].from.len() {
                    let from = cone.nodes[place].inputs[pin].from[wire];
                    let to = if matches!(graph.nodes[from.node].kind, Kind::Block { .. }) {
                        let (seen, is_negated) = self.output(graph, from, fresh)?;
                        let at = graph.nodes[from.node].place;
                        asks(&mut cone, at, seen, is_negated)
                    } else {
                        places[&from.node]
                    };
                    cone.nodes[place].inputs[pin].from[wire] = End {
                        node: to,
                        output: if to < found.len() { from.output } else { 0 },
                    };
                }
            }
        }
        // Blocks are asked for their outputs only.
        for node in &mut cone.nodes {
            if matches!(node.kind, Kind::Block { .. }) {
                *node = Node::new(node.place, Kind::Comment(String::new()), Vec::new());
            }
        }
        Ok(cone)
    }

    /// The elements of a drawing that no condition asks for.
    pub(super) fn unasked<'g>(&self, graph: &'g Graph) -> impl Iterator<Item = &'g Node> {
        let key = std::ptr::from_ref(graph);
        let is_unasked = move |number: &usize| {
            !self.seen.contains(&(key, *number)) && !self.places.contains_key(&(key, *number))
        };
        let numbers: Vec<usize> = (0..graph.nodes.len()).filter(is_unasked).collect();
        numbers.into_iter().map(|number| &graph.nodes[number])
    }

    /// What reads an output of a block in the next scan, and whether it is inverted.
    fn output(&mut self, graph: &Graph, end: End, fresh: &mut dyn FnMut() -> String) -> Read<(String, bool)> {
        let node = &graph.nodes[end.node];
        let Kind::Block { instance, .. } = &node.kind else {
            return Err("it is no block".to_owned());
        };
        let Some(output) = node.outputs.get(end.output) else {
            return Err("a block has no such output".to_owned());
        };
        self.block(graph, end.node, 0)?;
        if let Some(instance) = instance {
            return Ok((format!("{instance}.{}", output.name), output.negated));
        }
        let key = (std::ptr::from_ref(graph), end);
        if let Some(tag) = self.asked.get(&key) {
            return Ok((tag.clone(), false));
        }
        let tag = fresh();
        self.asked.insert(key, tag.clone());
        let from = End {
            node: self.places[&(key.0, end.node)],
            output: end.output,
        };
        self.ends_at(node.place, &tag, from);
        Ok((tag, false))
    }

    /// What a contact sees of the edges of its tag.
    fn edge(
        &mut self,
        graph: &Graph,
        number: usize,
        edge: Kind,
        fresh: &mut dyn FnMut() -> String,
    ) -> String {
        let end = End {
            node: number,
            output: 0,
        };
        let key = (std::ptr::from_ref(graph), end);
        if let Some(tag) = self.asked.get(&key) {
            return tag.clone();
        }
        let tag = fresh();
        self.asked.insert(key, tag.clone());
        let place = graph.nodes[number].place;
        let rail = self.graph.nodes.len();
        self.graph
            .nodes
            .push(Node::new(place, Kind::LeftRail, Vec::new()));
        self.graph
            .nodes
            .push(Node::new(place, edge, vec![fed_by(rail, 0)]));
        let from = End {
            node: rail + 1,
            output: 0,
        };
        self.ends_at(place, &tag, from);
        tag
    }

    /// A coil as the next thing that runs.
    fn ends_at(&mut self, place: LineColumn, tag: &str, from: End) {
        let kind = Kind::Coil(tag.to_owned(), Modifier::default(), Storage::None);
        let mut coil = Node::new(place, kind, vec![fed_by(from.node, from.output)]);
        self.order += 1;
        coil.order = Some(self.order);
        self.graph.nodes.push(coil);
    }

    /// Takes an element with all that feeds it; a block runs after the blocks before it.
    fn block(&mut self, graph: &Graph, number: usize, depth: usize) -> Read<()> {
        let key = (std::ptr::from_ref(graph), number);
        if self.places.contains_key(&key) {
            return Ok(());
        }
        if depth > super::LONGEST {
            return Err("what feeds its condition is too long".to_owned());
        }
        let place = self.graph.nodes.len();
        self.places.insert(key, place);
        self.graph.nodes.push(graph.nodes[number].clone());
        let inputs = &graph.nodes[number].inputs;
        for end in inputs.iter().flat_map(|pin| &pin.from) {
            self.block(graph, end.node, depth + 1)?;
        }
        let wires = self.graph.nodes[place].inputs.iter_mut();
        for end in wires.flat_map(|pin| &mut pin.from) {
            end.node = self.places[&(key.0, end.node)];
        }
        if matches!(graph.nodes[number].kind, Kind::Block { .. }) {
            self.order += 1;
            self.graph.nodes[place].order = Some(self.order);
        }
        Ok(())
    }
}

fn fed_by(node: usize, output: usize) -> Pin {
    Pin {
        from: vec![End { node, output }],
        ..Pin::default()
    }
}

/// A contact from the rail on.
fn asks(cone: &mut Graph, place: LineColumn, variable: String, negated: bool) -> usize {
    let rail = cone.nodes.len();
    cone.nodes.push(Node::new(place, Kind::LeftRail, Vec::new()));
    let modifier = Modifier {
        negated,
        ..Modifier::default()
    };
    let mut contact = Node::new(place, Kind::Contact(variable, modifier), vec![fed_by(rail, 0)]);
    contact.outputs = vec![Output::default()];
    cone.nodes.push(contact);
    rail + 1
}

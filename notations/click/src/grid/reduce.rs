//! From the wiring of a rung to circuits: how power gets from the left rail to a net.
//!
//! What is in series or in parallel becomes one edge, until one edge leads from the rail to the net. Where that
//! does not happen there is a bridge, through which power goes both ways; it becomes the paths that it makes.

use super::netlist::{Netlist, RAIL};
use super::paths::{Span, paths};
use super::subcircuit::{Kind, Subcircuit};
use std::collections::HashMap;

/// Why there is no circuit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum NoCircuit {
    /// Nothing joins the net to the rail.
    Unfed,
    /// Branches nest too deep.
    Deep,
    /// A bridge makes too many paths.
    ManyPaths,
    /// All the rungs together are more than is read.
    TooLarge,
}

/// How much work may still be done, over all rungs of a file.
#[derive(Debug, Clone)]
pub(super) struct Budget(usize);

impl Budget {
    /// For one file.
    pub(super) const FILE: Budget = Budget(20_000_000);

    pub(super) fn spend(&mut self, work: usize) -> Result<(), NoCircuit> {
        self.0 = self.0.checked_sub(work).ok_or(NoCircuit::TooLarge)?;
        Ok(())
    }
}

/// How power gets from the left rail to a net. A bare wire is a series of nothing.
pub(super) fn circuit(
    netlist: &Netlist<'_>,
    net: usize,
    budget: &mut Budget,
) -> Result<Subcircuit, NoCircuit> {
    budget.spend(netlist.contacts.len() + netlist.nets + 1)?;
    if net == RAIL {
        return Ok(Subcircuit::wire());
    }
    let mut graph = Graph::of(netlist, net);
    graph.reduce();
    let mut edges: Vec<Edge> = graph.edges.into_iter().flatten().collect();
    match &edges[..] {
        [] => Err(NoCircuit::Unfed),
        [edge] if edge.joins(RAIL, net) => Ok(edges.remove(0).part_from(RAIL)),
        _ => {
            let edges: Vec<Span> = edges.into_iter().map(Edge::into_span).collect();
            paths(&edges, net, budget)
        }
    }
}

/// What lies between two nets.
struct Edge {
    from: usize,
    to: usize,
    part: Subcircuit,
}

impl Edge {
    fn joins(&self, one: usize, other: usize) -> bool {
        (self.from, self.to) == (one, other) || (self.from, self.to) == (other, one)
    }

    fn other(&self, net: usize) -> usize {
        if self.from == net { self.to } else { self.from }
    }

    /// As it is passed from one of its ends.
    fn part_from(self, net: usize) -> Subcircuit {
        if self.from == net {
            self.part
        } else {
            self.part.reversed()
        }
    }

    fn into_span(self) -> Span {
        Span {
            from: self.from,
            to: self.to,
            part: self.part,
        }
    }
}

/// The edges between nets. It shrinks; edges that are gone are none.
struct Graph {
    edges: Vec<Option<Edge>>,
    /// The edges at each net, among them such as are gone.
    at: Vec<Vec<usize>>,
    between: HashMap<(usize, usize), usize>,
    /// The net that power is to reach.
    target: usize,
}

impl Graph {
    fn of(netlist: &Netlist<'_>, target: usize) -> Graph {
        let mut graph = Graph {
            edges: Vec::with_capacity(netlist.contacts.len()),
            at: vec![Vec::new(); netlist.nets],
            between: HashMap::new(),
            target,
        };
        for (number, contact) in netlist.contacts.iter().enumerate() {
            graph.add(Edge {
                from: contact.left,
                to: contact.right,
                part: Subcircuit::contact(number),
            });
        }
        graph
    }

    /// Adds an edge; next to another between the same nets, it becomes a branch of that. What a wire leads round
    /// decides nothing.
    fn add(&mut self, edge: Edge) {
        let (from, to) = (edge.from, edge.to);
        if from == to {
            return;
        }
        let between = (from.min(to), from.max(to));
        let other = self.between.get(&between).copied();
        if let Some(there) = other.and_then(|other| self.edges[other].as_mut()) {
            let next_to = edge.part_from(there.from);
            let part = std::mem::replace(&mut there.part, Subcircuit::wire());
            there.part = part.next_to(next_to);
            return;
        }
        let index = self.edges.len();
        self.between.insert(between, index);
        self.at[from].push(index);
        self.at[to].push(index);
        self.edges.push(Some(edge));
    }

    fn take(&mut self, index: usize) -> Option<Edge> {
        let edge = self.edges[index].take()?;
        self.between
            .remove(&(edge.from.min(edge.to), edge.from.max(edge.to)));
        Some(edge)
    }

    /// Makes one edge of what is in series, and leaves out what leads nowhere, until nothing changes.
    fn reduce(&mut self) {
        let mut waiting: Vec<usize> = (1..self.at.len()).rev().collect();
        while let Some(net) = waiting.pop() {
            if net == RAIL || net == self.target {
                continue;
            }
            let edges = &self.edges;
            self.at[net].retain(|edge| edges[*edge].is_some());
            match self.at[net][..] {
                [only] => {
                    let gone = self.take(only);
                    waiting.extend(gone.map(|edge| edge.other(net)));
                }
                [one, other] => {
                    let (Some(one), Some(other)) = (self.take(one), self.take(other)) else {
                        continue;
                    };
                    let (from, to) = (one.other(net), other.other(net));
                    waiting.extend([from, to]);
                    let part = one.part_from(from).after(other.part_from(net));
                    self.add(Edge { from, to, part });
                }
                _ => {}
            }
        }
    }
}

/// The contacts through which power goes from their left edge to their right one, and those the other way: in all
/// circuits of a rung.
#[derive(Debug, Clone, Default)]
pub(super) struct Directions {
    ways: HashMap<usize, (bool, bool)>,
}

impl Directions {
    pub(super) fn note(&mut self, part: &Subcircuit) {
        match &part.kind {
            Kind::Contact { contact, reversed } => {
                let ways = self.ways.entry(*contact).or_default();
                match reversed {
                    false => ways.0 = true,
                    true => ways.1 = true,
                }
            }
            Kind::Series(parts) | Kind::Parallel(parts) => parts.iter().for_each(|part| self.note(part)),
        }
    }

    /// The contacts that power passes both ways, in the order of reading.
    pub(super) fn both(&self) -> Vec<usize> {
        let mut both: Vec<usize> = self
            .ways
            .iter()
            .filter(|(_, ways)| **ways == (true, true))
            .map(|(contact, _)| *contact)
            .collect();
        both.sort_unstable();
        both
    }

    /// Whether power passes a contact at all.
    pub(super) fn pass(&self, contact: usize) -> bool {
        self.ways.contains_key(&contact)
    }
}

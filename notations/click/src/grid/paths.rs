//! A bridge as the paths that it makes.

use super::netlist::RAIL;
use super::reduce::{Budget, NoCircuit};
use super::subcircuit::Subcircuit;
use std::collections::{HashMap, HashSet};

/// How many paths a bridge may make.
const MOST_PATHS: usize = 64;

/// How many nets a bridge may have.
const MOST_NETS: usize = 64;

/// How many steps the search for the paths of one bridge may take.
const MOST_STEPS: usize = 20_000;

/// What lies between two nets.
#[derive(Debug, Clone)]
pub(super) struct Span {
    pub(super) from: usize,
    pub(super) to: usize,
    pub(super) part: Subcircuit,
}

/// All ways from the left rail to a net. Nets that every way passes part them, so that each bridge stands for itself.
pub(super) fn paths(edges: &[Span], target: usize, budget: &mut Budget) -> Result<Subcircuit, NoCircuit> {
    let graph = Graph::of(edges);
    if graph.at.len() > MOST_NETS {
        return Err(NoCircuit::ManyPaths);
    }
    let stops = graph.stops(target).ok_or(NoCircuit::Unfed)?;
    let mut whole = Subcircuit::wire();
    for pair in stops.windows(2) {
        let mut walk = Walk {
            graph: &graph,
            to: pair[1],
            // No way goes past the next stop and comes back.
            passed: stops.iter().copied().filter(|stop| *stop != pair[1]).collect(),
            steps: 0,
            found: Vec::new(),
        };
        walk.on(pair[0], &mut Vec::new())?;
        let contacts = walk.found.iter().map(|path| {
            path.iter()
                .map(|step| edges[step.edge].part.contacts() + 1)
                .sum::<usize>()
        });
        budget.spend(contacts.sum::<usize>() + walk.steps)?;
        let branches = walk.found.iter().map(|path| {
            path.iter()
                .fold(Subcircuit::wire(), |before, step| before.after(step.part(edges)))
        });
        whole = whole.after(Subcircuit::any(branches.collect()));
    }
    Ok(whole)
}

/// An edge as it is passed.
#[derive(Clone, Copy)]
struct DirectedEdge {
    edge: usize,
    reversed: bool,
}

impl DirectedEdge {
    fn part(self, edges: &[Span]) -> Subcircuit {
        let part = edges[self.edge].part.clone();
        if self.reversed { part.reversed() } else { part }
    }
}

struct Graph {
    /// From each net, where its edges lead.
    at: HashMap<usize, Vec<(DirectedEdge, usize)>>,
}

impl Graph {
    fn of(edges: &[Span]) -> Graph {
        let mut at: HashMap<usize, Vec<(DirectedEdge, usize)>> = HashMap::new();
        for (edge, span) in edges.iter().enumerate() {
            let step = |reversed| DirectedEdge { edge, reversed };
            at.entry(span.from).or_default().push((step(false), span.to));
            at.entry(span.to).or_default().push((step(true), span.from));
        }
        Graph { at }
    }

    fn leads(&self, net: usize) -> &[(DirectedEdge, usize)] {
        self.at.get(&net).map_or(&[], Vec::as_slice)
    }

    /// The nets that are reached from the rail without passing one of them, in the order in which they are found.
    fn reached(&self, without: Option<usize>) -> Vec<usize> {
        let mut reached = vec![RAIL];
        let mut seen: HashSet<usize> = HashSet::from([RAIL]);
        let mut next = 0;
        while let Some(net) = reached.get(next).copied() {
            next += 1;
            for (_, to) in self.leads(net) {
                if Some(*to) != without && seen.insert(*to) {
                    reached.push(*to);
                }
            }
        }
        reached
    }

    /// The rail, the nets that every way to the target passes, in their order, and the target. None: there is no way.
    fn stops(&self, target: usize) -> Option<Vec<usize>> {
        let reached = self.reached(None);
        if !reached.contains(&target) {
            return None;
        }
        let is_stop =
            |net: &usize| *net == RAIL || *net == target || !self.reached(Some(*net)).contains(&target);
        // Breadth comes first, so that a stop is found before the next one; the target is the last.
        let mut stops: Vec<usize> = reached
            .into_iter()
            .filter(is_stop)
            .filter(|net| *net != target)
            .collect();
        stops.push(target);
        Some(stops)
    }
}

struct Walk<'g> {
    graph: &'g Graph,
    to: usize,
    passed: HashSet<usize>,
    steps: usize,
    found: Vec<Vec<DirectedEdge>>,
}

impl Walk<'_> {
    /// Goes on from a net that was reached on a path.
    fn on(&mut self, net: usize, path: &mut Vec<DirectedEdge>) -> Result<(), NoCircuit> {
        self.steps += 1;
        if self.steps > MOST_STEPS {
            return Err(NoCircuit::ManyPaths);
        }
        if net == self.to {
            self.found.push(path.clone());
            return if self.found.len() > MOST_PATHS {
                Err(NoCircuit::ManyPaths)
            } else {
                Ok(())
            };
        }
        let graph = self.graph;
        for (step, to) in graph.leads(net) {
            if self.passed.contains(to) {
                continue;
            }
            self.passed.insert(*to);
            path.push(*step);
            self.on(*to, path)?;
            path.pop();
            self.passed.remove(to);
        }
        Ok(())
    }
}

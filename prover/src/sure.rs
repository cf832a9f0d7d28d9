//! What happens in a program whatever its unread parts write: the machine of bits once more, in which each bit that depends on them
//! says by two whether it may be high and whether it may be low. A run of it needs no value of theirs.

use crate::decide::dependents;
use crate::encode::{Input, State, World};
use crate::graph::{Graph, Lit, Node};
use crate::model::Model;

/// See the module.
pub(crate) struct Sure {
    pub(crate) model: Model,
    /// Of each node of the original that it may be high, and that it may be low.
    of: Vec<[Lit; 2]>,
}

impl Sure {
    /// High where a literal of the original is high for sure.
    pub(crate) fn lit(&self, lit: Lit) -> Lit {
        !may_be(&self.of, !lit)
    }

    /// Of a model.
    pub(crate) fn of(model: &Model) -> Sure {
        let world = &model.world;
        let depends = depending(model);
        let mut graph = Graph::default();
        let mut of = vec![[Lit::FALSE, Lit::TRUE]; world.graph.len()];
        let mut leaves: Vec<Option<[Lit; 2]>> = vec![None; world.graph.len()];
        for state in &world.states {
            let node = state.leaf.node();
            if depends[node] && leaves[node].is_none() {
                leaves[node] = Some([graph.leaf(), graph.leaf()]);
            }
        }
        for node in 1..of.len() {
            of[node] = match world.graph.node(node) {
                Node::False => [Lit::FALSE, Lit::TRUE],
                Node::And(a, b) => {
                    let high = graph.and(may_be(&of, a), may_be(&of, b));
                    if depends[node] {
                        [high, graph.or(may_be(&of, !a), may_be(&of, !b))]
                    } else {
                        [high, !high]
                    }
                }
                Node::Leaf => match leaves[node] {
                    Some(both) => both,
                    None if depends[node] => [Lit::TRUE; 2],
                    None => {
                        let leaf = graph.leaf();
                        [leaf, !leaf]
                    }
                },
            };
        }
        let mut states = Vec::new();
        for state in &world.states {
            let both = [state.leaf, !state.leaf].map(|lit| may_be(&of, lit));
            let next = [state.next, !state.next].map(|lit| may_be(&of, lit));
            let count = if depends[state.leaf.node()] { 2 } else { 1 };
            let initial = [state.initial, !state.initial];
            for n in 0..count {
                states.push(State {
                    leaf: both[n],
                    initial: initial[n],
                    next: next[n],
                });
            }
        }
        let inputs = world.inputs.iter().map(|input| Input {
            tag: input.tag.clone(),
            bits: input.bits.iter().map(|bit| may_be(&of, *bit)).collect(),
        });
        // What excludes values of unread parts alone is no matter of runs.
        let is_of_runs = |assumed: &&Lit| !is_of_values(model, **assumed);
        let assumed = model.assumed.iter().filter(is_of_runs);
        let model = Model {
            assumed: assumed.map(|lit| !may_be(&of, !*lit)).collect(),
            properties: Vec::new(),
            lemmas: Vec::new(),
            world: World {
                inputs: inputs.collect(),
                states,
                constants: world.constants.clone(),
                graph,
                ..World::default()
            },
        };
        Sure { model, of }
    }
}

fn may_be(of: &[[Lit; 2]], lit: Lit) -> Lit {
    of[lit.node()][usize::from(lit.is_negated())]
}

/// Of each node whether it depends on what unread parts write, in whichever scan.
pub(crate) fn depending(model: &Model) -> Vec<bool> {
    let unread = &model.world.unread;
    if unread.is_empty() {
        return vec![false; model.world.graph.len()];
    }
    dependents(model, unread.iter().copied())
}

/// What is assumed and depends on what unread parts write.
pub(crate) fn doubtful_assumptions(model: &Model) -> Vec<Lit> {
    if model.world.unread.is_empty() {
        return Vec::new();
    }
    let depends = depending(model);
    let assumed = model.assumed.iter().copied();
    let assumed = assumed.filter(|lit| depends[lit.node()] && !is_of_values(model, *lit));
    assumed.collect()
}

/// Whether a literal depends on what unread parts write in the scan, and on nothing else.
fn is_of_values(model: &Model, lit: Lit) -> bool {
    let world = &model.world;
    let mut stack = vec![lit.node()];
    let mut seen = rustc_hash::FxHashSet::default();
    while let Some(node) = stack.pop() {
        if !seen.insert(node) {
            continue;
        }
        match world.graph.node(node) {
            Node::False => {}
            Node::And(a, b) => stack.extend([a.node(), b.node()]),
            Node::Leaf if world.unread.contains(&node) => {}
            Node::Leaf => return false,
        }
    }
    true
}

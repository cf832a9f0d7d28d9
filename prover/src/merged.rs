//! States of two programs that always hold the same, though not by their form, become one: by induction, after those are given up
//! that do not.

use crate::decide::reach;
use crate::encode::{Input, State, World};
use crate::graph::{Graph, Lit, Node};
use crate::lanes::Lanes;
use crate::limits::End;
use crate::model::Model;
use crate::unrolled::{Found, From, Unrolled};
use rustc_hash::{FxHashMap, FxHashSet};

/// Conflicts that the question about all merged states may have, and about one of them.
const CONFLICTS: u64 = 5_000;
const CONFLICTS_OF_ONE: u64 = 200;
/// How many nodes are merged in all until nothing more is given up.
const MOST_STEPS: usize = 20_000_000;

/// A model in which states have been merged.
pub(crate) struct Merged {
    pub(crate) model: Model,
    /// Of each node of the original what it is.
    of: Vec<Lit>,
}

impl Merged {
    /// What a literal of the original is.
    pub(crate) fn lit(&self, lit: Lit) -> Lit {
        self.of[lit.node()].negated_if(lit.is_negated())
    }

    /// Whether merged states are next what both were to be, by their form.
    fn agrees(&self, original: &Model, (old, new): (usize, usize)) -> bool {
        let states = &original.world.states;
        self.lit(states[old].next) == self.lit(states[new].next)
    }
}

/// The model with the first of each pair in the place of the second.
pub(crate) fn merge(model: &Model, pairs: &[(usize, usize)]) -> Merged {
    let world = &model.world;
    let first_of: FxHashMap<usize, usize> = pairs.iter().map(|(old, new)| (*new, *old)).collect();
    let replaced: FxHashMap<usize, Lit> = first_of
        .iter()
        .map(|(new, old)| (world.states[*new].leaf.node(), world.states[*old].leaf))
        .collect();
    let mut graph = Graph::default();
    let mut of = vec![Lit::FALSE; world.graph.len()];
    for node in 1..of.len() {
        let lit = |lit: Lit| of[lit.node()].negated_if(lit.is_negated());
        of[node] = match world.graph.node(node) {
            Node::False => Lit::FALSE,
            Node::And(a, b) => graph.and(lit(a), lit(b)),
            Node::Leaf => match replaced.get(&node) {
                Some(first) => lit(*first),
                None => graph.leaf(),
            },
        };
    }
    let lit = |lit: Lit| of[lit.node()].negated_if(lit.is_negated());
    let mut numbers: Vec<Option<usize>> = vec![None; world.states.len()];
    let mut states = Vec::new();
    for (number, state) in world.states.iter().enumerate() {
        if !first_of.contains_key(&number) {
            numbers[number] = Some(states.len());
            states.push(State {
                leaf: lit(state.leaf),
                initial: state.initial,
                next: lit(state.next),
            });
        }
    }
    let inputs = world.inputs.iter().map(|input| Input {
        tag: input.tag.clone(),
        bits: input.bits.iter().map(|bit| lit(*bit)).collect(),
    });
    let open = world.open.iter();
    let mut model = Model {
        assumed: model.assumed.iter().map(|assumed| lit(*assumed)).collect(),
        properties: Vec::new(),
        lemmas: Vec::new(),
        world: World {
            inputs: inputs.collect(),
            states,
            open: open.map(|(node, gap)| (of[*node].node(), *gap)).collect(),
            unread: (world.unread.iter()).map(|node| of[*node].node()).collect(),
            gaps: world.gaps.clone(),
            numbers: world.numbers.clone(),
            constants: world.constants.clone(),
            ages: world.ages.clone(),
            timers: world.timers.clone(),
            graph,
            ..World::default()
        },
    };
    model.world.renumber(&numbers);
    Merged { model, of }
}

/// Drops pairs that hold different values in a scan of these runs.
pub(crate) fn drop_seen(model: &Model, pairs: &mut Vec<(usize, usize)>, lanes: &Lanes<'_>) {
    let states = &model.world.states;
    pairs.retain(|(old, new)| {
        (lanes.value(states[*old].leaf) ^ lanes.value(states[*new].leaf)) & lanes.alive == 0
    });
}

/// Those of the pairs that always hold the same, as far as what is wanted depends on them: the rest is dropped until one scan
/// breaks none of them.
pub(crate) fn keep(
    model: &Model,
    wanted: &[Lit],
    mut pairs: Vec<(usize, usize)>,
    end: &End,
) -> Vec<(usize, usize)> {
    let most = MOST_STEPS / model.world.graph.len();
    for _ in 0..most.max(10) {
        if pairs.is_empty() || end.is_over() {
            break;
        }
        let merged = merge(model, &pairs);
        let asked = asked(model, &merged, wanted, &pairs);
        let broken = broken(&merged.model, &asked, end);
        if broken.is_empty() {
            return pairs;
        }
        pairs.retain(|pair| !broken.contains(pair));
    }
    Vec::new()
}

/// A pair, and what both of it are next.
type Asked = ((usize, usize), [Lit; 2]);

/// The pairs on which what is wanted depends and that do not stay the same by their form.
fn asked(model: &Model, merged: &Merged, wanted: &[Lit], pairs: &[(usize, usize)]) -> Vec<Asked> {
    let states = &model.world.states;
    let mut left: Vec<(usize, usize)> = pairs.to_vec();
    left.retain(|pair| !merged.agrees(model, *pair));
    let mut asked: Vec<Asked> = Vec::new();
    loop {
        let wanted = wanted.iter().map(|lit| merged.lit(*lit));
        let also = asked.iter().flat_map(|(_, next)| *next);
        let nodes: FxHashSet<usize> = reach(&merged.model, wanted.chain(also));
        let before = asked.len();
        left.retain(|pair| {
            let matters = nodes.contains(&merged.lit(states[pair.0].leaf).node());
            if matters {
                let next = [pair.0, pair.1].map(|number| merged.lit(states[number].next));
                asked.push((*pair, next));
            }
            !matters
        });
        if asked.len() == before {
            return asked;
        }
    }
}

/// The pairs that one scan may break, in which all of them held the same before.
fn broken(model: &Model, asked: &[Asked], end: &End) -> FxHashSet<(usize, usize)> {
    let mut broken = FxHashSet::default();
    if asked.is_empty() {
        return broken;
    }
    let mut step = Unrolled::new(model, From::Anywhere, end);
    if !step.add_scan() {
        return broken;
    }
    let mut open: Vec<((usize, usize), Lit)> = Vec::new();
    for (pair, [old, new]) in asked {
        let both = (step.lit(0, *old), step.lit(0, *new));
        open.push((*pair, step.differ(&[both])));
    }
    loop {
        let any = step.selector();
        let mut clause: Vec<Lit> = open.iter().map(|(_, differs)| *differs).collect();
        clause.push(!any);
        step.require_one(&clause);
        match step.ask(&[any], CONFLICTS) {
            Found::No => return broken,
            Found::Yes => {
                let is_broken = |differs: &Lit| step.value_of(*differs);
                let count = open.len();
                open.retain(|(pair, differs)| {
                    let breaks = is_broken(differs);
                    if breaks {
                        broken.insert(*pair);
                    }
                    !breaks
                });
                if open.len() == count {
                    break;
                }
            }
            Found::Unknown => break,
        }
    }
    // What cannot be decided together is asked one by one.
    for (pair, differs) in open {
        if step.ask(&[differs], CONFLICTS_OF_ONE) != Found::No {
            broken.insert(pair);
        }
    }
    broken
}

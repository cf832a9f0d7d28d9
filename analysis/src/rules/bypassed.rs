//! Contacts that decide nothing because a wire leads round them, whichever connectors it goes by.
//!
//! After a condition there is power only where there was some before it. So what a contact passes on changes nothing
//! at a connector at which the wire that comes along the other line carries at least as much by itself. All of this
//! follows from the drawing; the values of tags do not matter.

use super::power_rules::is_condition;
use super::wiring_walk::Walk;
use crate::program::Step;
use ladder_instructions::{Op, Power};

/// How many steps a network may have: nobody draws more by hand.
const MOST_STEPS: usize = 400;

/// A contact round which a wire leads.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Bypassed {
    /// The contact.
    pub(super) block: usize,
    /// The step at which the wire joins its line again.
    pub(super) join: usize,
}

/// All of them, in the order of evaluation. None if the network is too large.
pub(super) fn bypassed(walk: &Walk<'_>) -> Option<Vec<Bypassed>> {
    let steps = walk.steps();
    if steps.len() > MOST_STEPS {
        return None;
    }
    let same = same_power(walk);
    if !may_lead_round(steps, &same) {
        return Some(Vec::new());
    }
    let (limits, carried) = (limits(walk, &same), carried(steps, &same));
    let mut consumers = vec![Vec::new(); steps.len()];
    for (index, step) in steps.iter().enumerate() {
        match *step {
            Step::Start { .. } => {}
            Step::Block { en, .. } => consumers[en].push(index),
            Step::Join { upper, lower } => {
                consumers[upper].push(index);
                consumers[lower].push(index);
            }
        }
    }
    let mut found = Vec::new();
    for (index, step) in steps.iter().enumerate() {
        let Step::Block { block, .. } = *step else {
            continue;
        };
        if limits_power(walk, block) {
            // What the contact itself passes on may come along both lines; that is not a wire round it.
            let mut before = limits[index].clone();
            before.remove(same[index]);
            let join = absorbed(walk, index, &before, &carried, &consumers);
            found.extend(join.map(|join| Bypassed { block, join }));
        }
    }
    Some(found)
}

/// The connector at which what a step passes on changes nothing any more, if it goes nowhere else.
fn absorbed(
    walk: &Walk<'_>,
    from: usize,
    limits: &Steps,
    carried: &[Steps],
    consumers: &[Vec<usize>],
) -> Option<usize> {
    let mut joined = None;
    let mut seen = Steps::none(consumers.len());
    let mut open = vec![from];
    while let Some(at) = open.pop() {
        if !seen.insert(at) {
            continue;
        }
        for &next in &consumers[at] {
            match walk.steps()[next] {
                Step::Join { upper, lower } => {
                    let other = if upper == at { lower } else { upper };
                    if limits.meets(&carried[other]) {
                        joined.get_or_insert(next);
                    } else {
                        open.push(next);
                    }
                }
                Step::Block { block, .. } if limits_power(walk, block) => open.push(next),
                _ => return None,
            }
        }
    }
    joined
}

/// Whether no more power leaves a block than enters it, and the power has no other effect on it.
fn limits_power(walk: &Walk<'_>, block: usize) -> bool {
    let bound = walk.block(block);
    is_condition(bound)
        && bound
            .instruction()
            .is_none_or(|row| !matches!(row.power, Power::Inverts | Power::EnEdge(_)))
}

/// For each step the first one with the very same power: the left rail is one, and a coil passes on what it gets.
fn same_power(walk: &Walk<'_>) -> Vec<usize> {
    let mut same: Vec<usize> = Vec::with_capacity(walk.steps().len());
    let mut rail = None;
    for (index, step) in walk.steps().iter().enumerate() {
        same.push(match *step {
            Step::Start { rail: true } => *rail.get_or_insert(index),
            Step::Block { block, en } if passes(walk, block) => same[en],
            _ => index,
        });
    }
    same
}

fn passes(walk: &Walk<'_>, block: usize) -> bool {
    walk.block(block).instruction().is_some_and(|row| {
        row.power == Power::Passes && (row.coil.is_some() || matches!(row.op, Op::Res | Op::Lbl))
    })
}

/// Whether a power that is used twice comes to a connector by way of wire alone: no wire leads round anything
/// otherwise. Cheap, and seldom so.
fn may_lead_round(steps: &[Step], same: &[usize]) -> bool {
    let mut uses = vec![0; steps.len()];
    for step in steps {
        match *step {
            Step::Start { .. } => {}
            Step::Block { en, .. } => uses[same[en]] += 1,
            Step::Join { upper, lower } => {
                uses[same[upper]] += 1;
                uses[same[lower]] += 1;
            }
        }
    }
    let is_shared = |step: usize| uses[same[step]] > 1 && !matches!(steps[step], Step::Start { rail: false });
    steps
        .iter()
        .any(|step| matches!(*step, Step::Join { upper, lower } if is_shared(upper) || is_shared(lower)))
}

/// For each step those that have power whenever it has.
fn limits(walk: &Walk<'_>, same: &[usize]) -> Vec<Steps> {
    let steps = walk.steps();
    let mut limits: Vec<Steps> = Vec::with_capacity(steps.len());
    for (index, step) in steps.iter().enumerate() {
        let mut of_step = match *step {
            // It never has any.
            Step::Start { rail: false } => Steps::all(steps.len()),
            Step::Block { block, en } if passes(walk, block) || limits_power(walk, block) => {
                limits[en].clone()
            }
            Step::Join { upper, lower } => limits[upper].and(&limits[lower]),
            _ => Steps::none(steps.len()),
        };
        of_step.insert(same[index]);
        limits.push(of_step);
    }
    limits
}

/// For each step those whose power it carries by way of wire alone.
fn carried(steps: &[Step], same: &[usize]) -> Vec<Steps> {
    let mut carried: Vec<Steps> = Vec::with_capacity(steps.len());
    for (index, step) in steps.iter().enumerate() {
        let mut of_step = match *step {
            Step::Join { upper, lower } => carried[upper].or(&carried[lower]),
            Step::Block { en, .. } if same[index] != index => carried[en].clone(),
            _ => Steps::none(steps.len()),
        };
        if !matches!(step, Step::Start { rail: false }) {
            of_step.insert(same[index]);
        }
        carried.push(of_step);
    }
    carried
}

/// A set of steps, a bit for each.
#[derive(Debug, Clone)]
struct Steps(Vec<u64>);

impl Steps {
    fn none(count: usize) -> Steps {
        Steps(vec![0; count.div_ceil(64)])
    }

    fn all(count: usize) -> Steps {
        Steps(vec![u64::MAX; count.div_ceil(64)])
    }

    /// Adds a step; false if it was there.
    fn insert(&mut self, step: usize) -> bool {
        let (word, bit) = (&mut self.0[step / 64], 1 << (step % 64));
        let new = *word & bit == 0;
        *word |= bit;
        new
    }

    fn remove(&mut self, step: usize) {
        self.0[step / 64] &= !(1 << (step % 64));
    }

    fn and(&self, other: &Steps) -> Steps {
        Steps(self.0.iter().zip(&other.0).map(|(a, b)| a & b).collect())
    }

    fn or(&self, other: &Steps) -> Steps {
        Steps(self.0.iter().zip(&other.0).map(|(a, b)| a | b).collect())
    }

    fn meets(&self, other: &Steps) -> bool {
        self.0.iter().zip(&other.0).any(|(a, b)| a & b != 0)
    }
}

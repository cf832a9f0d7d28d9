//! Which properties hold in every run: by induction, and by looking for a run that violates them.
//!
//! *Base* has the scans from the cold start, *step* as many from any state. Where step cannot reach a violation after k
//! scans without one, and base has none in the first k, there is none at all.

use crate::encode::Input;
use crate::graph::{Lit, Node};
use crate::lanes::Lanes;
use crate::limits::End;
use crate::model::Model;
use crate::unrolled::{Found, From, Unrolled};
use crate::wanted::{Progress, tell};
use rustc_hash::FxHashSet;

/// How far is looked.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Depth {
    /// Scans from the cold start.
    pub(crate) base: usize,
    /// Scans of the induction.
    pub(crate) step: usize,
    /// When it must be done.
    pub(crate) end: End,
    pub(crate) seeks: Seeks,
    /// Conflicts that one question may have.
    pub(crate) conflicts: u64,
}

/// Which runs are wanted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Seeks {
    /// One of every property that has one, with as few changes of its inputs as can be had.
    Every,
    /// The first that is found of any of them, as it is.
    One,
}

/// What is known of a property.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Known {
    /// No run violates it: by an induction over so many scans.
    Never(usize),
    /// This run does.
    Found(Run),
    /// There is no violation in so many scans.
    NotIn(usize),
    /// Nothing that is assumed can hold at the start.
    Vacuous,
}

/// The inputs of a run: for each input of the model its bits in each scan; of one that does not matter none.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Run {
    pub(crate) scans: usize,
    /// In the order of the model's inputs.
    pub(crate) inputs: Vec<Vec<Vec<bool>>>,
}

/// After so many scans runs are tried before the solver goes on: they reach further.
const TRIED_AT: usize = 40;
const TRIED_SCANS: usize = 3_000;
/// The steps of all of these runs.
const TRIED_STEPS: usize = 150_000_000;

/// Conflicts that one question may have where an answer is worth it.
pub(crate) const CONFLICTS: u64 = 200_000;
/// The same before all other questions have been asked.
const CHEAP: u64 = 2_000;
/// The part of them for a question of the induction, after which the next scan may help.
const STEP_PART: u64 = 10;

/// The properties whose literals are given, each of which is to be low in every scan.
pub(crate) fn decide(model: &Model, targets: &[Lit], depth: Depth) -> (Vec<Known>, u64) {
    let mut base = Unrolled::new(model, From::Start, depth.end);
    let mut step = Unrolled::new(model, From::Anywhere, depth.end);
    let mut known: Vec<Option<Known>> = vec![None; targets.len()];
    let selectors: Vec<Lit> = targets.iter().map(|_| step.selector()).collect();
    let states: Vec<Lit> = cone(model, targets).into_iter().collect();
    let mut reached = vec![0; targets.len()];
    let mut given_up: FxHashSet<usize> = FxHashSet::default();
    for scan in 0..depth.base {
        if scan == TRIED_AT {
            try_runs(model, targets, &mut known, depth.end);
        }
        let is_late = depth.end.is_over() || base.is_full();
        let is_found = depth.seeks == Seeks::One
            && known
                .iter()
                .flatten()
                .any(|known| matches!(known, Known::Found(_)));
        if known.iter().all(Option::is_some) || is_late || is_found {
            break;
        }
        tell(Progress {
            scan,
            decided: known.iter().flatten().count(),
            of: known.len(),
        });
        let goes_on =
            base.add_scan() && (model.assumed.is_empty() || base.ask(&[], depth.conflicts) != Found::No);
        if !goes_on {
            if scan == 0 {
                return (vec![Known::Vacuous; targets.len()], base.clauses());
            }
            // No run that is assumed goes on: nothing more can be violated.
            for (n, known) in known.iter_mut().enumerate() {
                if known.is_none() && !given_up.contains(&n) {
                    *known = Some(Known::Never(scan));
                }
            }
            break;
        }
        let is_open = |n: &usize| known[*n].is_none() && !given_up.contains(n);
        let mut left: Vec<usize> = (0..targets.len()).filter(is_open).collect();
        let can_induce =
            scan < depth.step && !step.is_full() && prepare(&mut step, targets, &selectors, scan);
        // What is hard to answer comes after what is not, and after what that proves.
        for conflicts in [depth.conflicts.min(CHEAP), depth.conflicts] {
            if left.is_empty() {
                break;
            }
            for n in std::mem::take(&mut left) {
                let target = targets[n];
                let bad = base.lit(scan, target);
                match base.ask(&[bad], conflicts) {
                    Found::Yes if depth.seeks == Seeks::One => {
                        let run = read(&base, model, &inputs_of(model, &[target]), scan);
                        known[n] = Some(Known::Found(run));
                        left.clear();
                        break;
                    }
                    Found::Yes => {
                        let run = readable(&mut base, model, scan, (target, bad), depth.end);
                        known[n] = Some(Known::Found(run));
                    }
                    Found::No => {
                        base.require(!bad);
                        reached[n] = scan + 1;
                    }
                    Found::Unknown => left.push(n),
                }
            }
            if can_induce {
                // Only what this scan does not violate.
                let is_open = |n: &usize| known[*n].is_none() && reached[*n] == scan + 1;
                let open = (0..targets.len()).filter(is_open).collect();
                for n in induce(&mut step, targets, &selectors, (&states, depth), open, scan) {
                    known[n] = Some(Known::Never(scan));
                    step.require(selectors[n]);
                }
            }
        }
        given_up.extend(left);
    }
    let answers = known.into_iter().zip(reached);
    let answers = answers.map(|(known, reached)| known.unwrap_or(Known::NotIn(reached)));
    (answers.collect(), base.clauses() + step.clauses())
}

/// Runs with inputs that are held for a while: many scans, and some of what is far away happens in them.
fn try_runs(model: &Model, targets: &[Lit], known: &mut [Option<Known>], end: End) {
    let open: Vec<usize> = (0..targets.len()).filter(|n| known[*n].is_none()).collect();
    let wanted: Vec<Lit> = open.iter().map(|n| targets[*n]).collect();
    if wanted.is_empty() {
        return;
    }
    for (round, hold) in [(1u64, 64u64), (2, 512), (3, 8)] {
        let mut lanes = Lanes::new(model, &wanted, round * 0x1234_5677, hold);
        for _ in 0..TRIED_SCANS.min(TRIED_STEPS / 3 / lanes.steps()) {
            if end.is_over() || open.iter().all(|n| known[*n].is_some()) {
                return;
            }
            lanes.scan();
            for &n in &open {
                let found = lanes.value(targets[n]) & lanes.alive;
                if found != 0 && known[n].is_none() {
                    let inputs = inputs_of(model, &[targets[n]]);
                    known[n] = Some(Known::Found(lanes.run(found.trailing_zeros(), &inputs)));
                }
            }
        }
    }
}

/// Adds a scan to those of the induction, before which none of the chosen properties is violated. False: none can be.
fn prepare(step: &mut Unrolled<'_>, targets: &[Lit], selectors: &[Lit], scan: usize) -> bool {
    if !step.add_scan() {
        return false;
    }
    if let Some(before) = scan.checked_sub(1) {
        for (&target, &selector) in targets.iter().zip(selectors) {
            let bad = step.lit(before, target);
            step.require_one(&[!selector, !bad]);
        }
    }
    true
}

/// Those of the open properties that cannot be violated in this scan if none of them was in the scans before.
fn induce(
    step: &mut Unrolled<'_>,
    targets: &[Lit],
    selectors: &[Lit],
    (states, depth): (&[Lit], Depth),
    mut open: Vec<usize>,
    scan: usize,
) -> Vec<usize> {
    loop {
        let before = open.clone();
        for n in before.iter().copied() {
            let bad = step.lit(scan, targets[n]);
            let mut question: Vec<Lit> = open.iter().map(|n| selectors[*n]).collect();
            question.push(bad);
            let mut repeats = 0;
            loop {
                match step.ask(&question, depth.conflicts / STEP_PART) {
                    Found::No => break,
                    // A run that comes back to where it was need not be followed.
                    Found::Yes if repeats < MOST_REPEATS && forbid_repeat(step, states, scan) => repeats += 1,
                    _ => {
                        open.retain(|other| *other != n);
                        break;
                    }
                }
            }
        }
        if open.len() == before.len() {
            return open;
        }
    }
}

/// Excludes two scans of the run that was found to begin in the same state, if two do.
fn forbid_repeat(step: &mut Unrolled<'_>, states: &[Lit], last: usize) -> bool {
    if states.is_empty() || last == 0 || states.len() > MOST_COMPARED {
        return false;
    }
    // All must be known to the solver, or their values mean nothing: then the question is put once more.
    let mut is_new = false;
    for scan in 0..=last {
        for state in states {
            is_new |= step.make_known(scan, *state);
        }
    }
    if is_new {
        return true;
    }
    let of = |scan: usize| -> Vec<bool> { states.iter().map(|state| step.value(scan, *state)).collect() };
    let seen: Vec<Vec<bool>> = (0..=last).map(of).collect();
    for one in 0..last {
        for other in one + 1..=last {
            if seen[one] == seen[other] {
                let pairs: Vec<(Lit, Lit)> = states
                    .iter()
                    .map(|state| (step.lit(one, *state), step.lit(other, *state)))
                    .collect();
                let differ = step.differ(&pairs);
                step.require(differ);
                return true;
            }
        }
    }
    false
}

/// The leaves of what is remembered, on which these and what is assumed depend in any scan.
fn cone(model: &Model, targets: &[Lit]) -> FxHashSet<Lit> {
    let nodes = reach(model, targets.iter().chain(&model.assumed).copied());
    let states = model.world.states.iter();
    let states = states.filter(|state| nodes.contains(&state.leaf.node()));
    states.map(|state| state.leaf).collect()
}

/// The nodes on which literals depend in any scan.
pub(crate) fn reach(model: &Model, from: impl Iterator<Item = Lit>) -> FxHashSet<usize> {
    let states: rustc_hash::FxHashMap<usize, Lit> = (model.world.states.iter())
        .map(|state| (state.leaf.node(), state.next))
        .collect();
    let mut nodes = FxHashSet::default();
    let mut stack: Vec<usize> = from.map(Lit::node).collect();
    while let Some(node) = stack.pop() {
        if !nodes.insert(node) {
            continue;
        }
        match model.world.graph.node(node) {
            Node::And(a, b) => stack.extend([a.node(), b.node()]),
            Node::Leaf => stack.extend(states.get(&node).map(|next| next.node())),
            Node::False => {}
        }
    }
    nodes
}

/// How often a question of the induction is put again without a run that repeats itself.
const MOST_REPEATS: usize = 100;
/// Runs of more bits that are remembered are not asked for repetitions.
const MOST_COMPARED: usize = 4_000;

/// How long a run is made more readable.
const READABLE: u64 = 20_000_000;
const READABLE_CONFLICTS: u64 = 1_000;

/// The run that was found, with as few changes of its inputs as can be had by asking for each whether it may be as before.
fn readable(base: &mut Unrolled<'_>, model: &Model, last: usize, (target, bad): (Lit, Lit), end: End) -> Run {
    let inputs = inputs_of(model, &[target]);
    let mut run = read(base, model, &inputs, last);
    let most = base.work().saturating_add(READABLE);
    let mut fixed = vec![bad];
    for (number, input) in model.world.inputs.iter().enumerate() {
        if !inputs[number] {
            continue;
        }
        for scan in 0..=last {
            if end.is_over() || base.work() > most {
                return run;
            }
            let Some(as_before) = as_before(base, input, scan) else {
                continue;
            };
            let bits = |run: &Run, scan: usize| run.inputs[number].get(scan).cloned();
            let is_so = match scan {
                0 => bits(&run, 0).is_some_and(|bits| bits.iter().all(|bit| !bit)),
                scan => bits(&run, scan) == bits(&run, scan - 1),
            };
            fixed.push(as_before);
            if is_so {
                continue;
            }
            if base.ask(&fixed, READABLE_CONFLICTS) == Found::Yes {
                run = read(base, model, &inputs, last);
            } else {
                fixed.pop();
            }
        }
    }
    run
}

/// That an input is as in the scan before, and low before the first. None: it does not matter in this scan.
fn as_before(base: &mut Unrolled<'_>, input: &Input, scan: usize) -> Option<Lit> {
    let matters = input.bits.iter().any(|bit| base.knows(scan, *bit).is_some());
    if !matters {
        return None;
    }
    let pairs: Vec<(Lit, Lit)> = (input.bits.iter())
        .map(|&bit| {
            let before = match scan.checked_sub(1) {
                None => Lit::FALSE,
                Some(before) => base.lit(before, bit),
            };
            (base.lit(scan, bit), before)
        })
        .collect();
    Some(!base.differ(&pairs))
}

/// Of each input of the model whether one of these depends on it, or what is assumed does.
pub(crate) fn inputs_of(model: &Model, targets: &[Lit]) -> Vec<bool> {
    let nodes = reach(model, model.assumed.iter().chain(targets).copied());
    let matters = |input: &Input| input.bits.iter().any(|bit| nodes.contains(&bit.node()));
    model.world.inputs.iter().map(matters).collect()
}

fn read(base: &Unrolled<'_>, model: &Model, inputs: &[bool], last: usize) -> Run {
    let of = |(input, is_asked): (&Input, &bool)| {
        let is_there = |scan: usize| input.bits.iter().any(|bit| base.knows(scan, *bit).is_some());
        let matters = *is_asked && (0..=last).any(is_there);
        if !matters {
            return Vec::new();
        }
        let mut scans: Vec<Vec<bool>> = Vec::with_capacity(last + 1);
        for scan in 0..=last {
            let matters = input.bits.iter().any(|bit| base.knows(scan, *bit).is_some());
            let bits = match (matters, scans.last()) {
                (false, Some(before)) => before.clone(),
                _ => input.bits.iter().map(|bit| base.value(scan, *bit)).collect(),
            };
            scans.push(bits);
        }
        scans
    };
    Run {
        scans: last + 1,
        inputs: model.world.inputs.iter().zip(inputs).map(of).collect(),
    }
}

//! Which properties hold in every run: by induction, and by looking for a run that violates them.
//!
//! *Base* has the scans from the cold start, *step* as many from any state. Where step cannot reach a violation after k
//! scans without one, and base has none in the first k, there is none at all. Step waits where it is the harder of the two:
//! what happens after a few scans is found soon, whatever an induction would need.

use crate::encode::Input;
use crate::graph::{Lit, Node};
use crate::induction::Induction;
use crate::lanes::Lanes;
use crate::limits::End;
use crate::model::Model;
use crate::progress::{Listener, Progress};
use crate::unrolled::{Found, From, Unrolled};
use rustc_hash::FxHashSet;
use std::collections::BTreeSet;

/// How far is looked.
#[derive(Debug, Clone)]
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
    /// Hears how far it is.
    pub(crate) listener: Listener,
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
/// The same before all other questions of a scan have been asked.
const CHEAP: u64 = 2_000;
/// The same before those of all later scans have, where a question is put again with times as they are, and where no verdict
/// depends on it.
pub(crate) const DEAR: u64 = 5_000;
/// The steps that the solver of the induction may make before that of the runs has made any, and how many for each of its.
const INDUCTION_FIRST: u64 = 2_000_000;
const INDUCTION_SHARE: u64 = 2;

/// The properties whose literals are given, each of which is to be low in every scan. And how many clauses the solvers had.
pub(crate) fn decide(model: &Model, targets: &[Lit], depth: &Depth) -> (Vec<Known>, u64) {
    let conflicts = depth.conflicts.min(DEAR);
    let first = attempt(
        model,
        targets,
        &Depth {
            conflicts,
            ..depth.clone()
        },
    );
    let (mut known, given_up, clauses) = (first.known, first.given_up, first.clauses);
    let is_found = depth.seeks == Seeks::One && known.iter().any(|known| matches!(known, Known::Found(_)));
    if given_up.is_empty() || is_found || conflicts == depth.conflicts {
        return (known, clauses);
    }
    // One that is hard has waited for what happens late to the others.
    let hard: Vec<Lit> = given_up.iter().map(|n| targets[*n]).collect();
    let again = attempt(model, &hard, depth);
    for (n, later) in given_up.into_iter().zip(again.known) {
        match (&known[n], &later) {
            (Known::NotIn(before), Known::NotIn(after)) if before >= after => {}
            _ => known[n] = later,
        }
    }
    (known, clauses + again.clauses)
}

/// What came of one attempt.
struct Attempt {
    known: Vec<Known>,
    /// What had a question that took more conflicts than one may have.
    given_up: BTreeSet<usize>,
    clauses: u64,
}

fn attempt(model: &Model, targets: &[Lit], depth: &Depth) -> Attempt {
    let mut base = Unrolled::new(model, From::Start, &depth.end);
    let mut induction = Induction::new(model, targets, depth);
    let mut known: Vec<Option<Known>> = vec![None; targets.len()];
    let mut reached = vec![0; targets.len()];
    let mut given_up = BTreeSet::new();
    for scan in 0..depth.base {
        if scan == TRIED_AT {
            try_runs(model, targets, &mut known, &depth.end);
        }
        let is_open = |n: &usize| known[*n].is_none() && !given_up.contains(n);
        let mut left: Vec<usize> = (0..targets.len()).filter(is_open).collect();
        let is_late = depth.end.is_over() || base.is_full();
        if left.is_empty() || !wants_more(&known, depth.seeks) || is_late {
            break;
        }
        depth.listener.tell(Progress {
            scan,
            decided: known.iter().flatten().count(),
            of: known.len(),
        });
        let goes_on =
            base.add_scan() && (model.assumed.is_empty() || base.ask(&[], depth.conflicts) != Found::No);
        if !goes_on {
            // No run that is assumed goes on: nothing more can be violated.
            let rest = if scan == 0 {
                Known::Vacuous
            } else {
                Known::Never(scan)
            };
            for n in left {
                known[n] = Some(rest.clone());
            }
            break;
        }
        let most = base
            .work()
            .saturating_mul(INDUCTION_SHARE)
            .saturating_add(INDUCTION_FIRST);
        let can_induce = induction.add_scan(most);
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
                        let run = readable(&mut base, model, scan, (target, bad), &depth.end);
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
                induction.decide(&mut known, &reached, most);
            }
        }
        given_up.extend(left);
    }
    // Now the induction has all the time that is left, unless what was given up waits for it.
    while given_up.is_empty()
        && wants_more(&known, depth.seeks)
        && !depth.end.is_over()
        && induction.add_scan(u64::MAX)
    {
        induction.decide(&mut known, &reached, u64::MAX);
    }
    given_up.retain(|n| known[*n].is_none());
    let answers = known.into_iter().zip(reached);
    let answers = answers.map(|(known, reached)| known.unwrap_or(Known::NotIn(reached)));
    Attempt {
        known: answers.collect(),
        given_up,
        clauses: base.clauses() + induction.step.clauses(),
    }
}

/// Whether more is to be found than what is known.
fn wants_more(known: &[Option<Known>], seeks: Seeks) -> bool {
    let is_found = |known: &Option<Known>| matches!(known, Some(Known::Found(_)));
    known.iter().any(Option::is_none) && !(seeks == Seeks::One && known.iter().any(is_found))
}

/// Runs with inputs that are held for a while: many scans, and some of what is far away happens in them.
fn try_runs(model: &Model, targets: &[Lit], known: &mut [Option<Known>], end: &End) {
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

/// The leaves of what is remembered, on which these and what is assumed depend in any scan.
pub(crate) fn cone(model: &Model, targets: &[Lit]) -> FxHashSet<Lit> {
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

/// Of each node whether it depends on one of these in any scan.
pub(crate) fn dependents(model: &Model, from: impl Iterator<Item = usize>) -> Vec<bool> {
    let world = &model.world;
    let count = world.graph.len();
    // For each node those that are made of it, as a list.
    let mut first: Vec<Option<usize>> = vec![None; count];
    let mut links: Vec<(usize, Option<usize>)> = Vec::new();
    let mut link = |from: usize, to: usize| {
        links.push((to, first[from]));
        first[from] = Some(links.len() - 1);
    };
    for node in 0..count {
        if let Node::And(a, b) = world.graph.node(node) {
            link(a.node(), node);
            link(b.node(), node);
        }
    }
    for state in &world.states {
        link(state.next.node(), state.leaf.node());
    }
    let mut depends = vec![false; count];
    let mut stack: Vec<usize> = from.collect();
    while let Some(node) = stack.pop() {
        if std::mem::replace(&mut depends[node], true) {
            continue;
        }
        let mut next = first[node];
        while let Some((to, after)) = next.map(|link| links[link]) {
            stack.push(to);
            next = after;
        }
    }
    depends
}

/// How long a run is made more readable.
const READABLE: u64 = 20_000_000;
const READABLE_CONFLICTS: u64 = 1_000;

/// The run that was found, with as few changes of its inputs as can be had by asking for each whether it may be as before.
fn readable(
    base: &mut Unrolled<'_>,
    model: &Model,
    last: usize,
    (target, bad): (Lit, Lit),
    end: &End,
) -> Run {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::tests::model_of;
    use std::time::Duration;

    /// That two products are equal takes more than anyone waits for; it does not stand before what happens after some scans.
    #[test]
    fn what_is_hard_waits_for_what_is_late() {
        let program = "VAR_INPUT x, y : INT; go : BOOL; END_VAR
VAR u, v, n : INT; END_VAR
+--[CALC]( u, u * x + y )--[CALC]( v, v * x + y )--+
+--[ ]( go )--[ADD]( n, n, 1 )--+
";
        let model = model_of(program, "always u * u = v * v\nnever n > 12");
        let targets: Vec<Lit> = model.properties.iter().map(|property| property.bad).collect();
        let depth = Depth {
            base: 200,
            step: 20,
            end: End::in_time(Duration::from_secs(60)),
            seeks: Seeks::One,
            conflicts: CONFLICTS,
            listener: Listener::default(),
        };
        let (known, _) = decide(&model, &targets, &depth);
        let found = matches!(&known[..], [Known::NotIn(_), Known::Found(Run { scans: 13, .. })]);
        assert!(found, "{known:?}");
    }
}

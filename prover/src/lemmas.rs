//! What always holds of what is remembered, so that the induction need not think of states that never are.
//!
//! Runs leave guesses: a bit that never changed, two bits of which one was never high without the other, a property's wait
//! that was never longer than a timer has run. Of these those stay that one scan cannot break as long as all of them hold.

use crate::decide::reach;
use crate::graph::Lit;
use crate::lanes::Lanes;
use crate::limits::End;
use crate::model::Model;
use crate::number::Number;
use crate::unrolled::{Found, From, Unrolled};
use std::collections::BTreeSet;

/// Of more bits pairs are not compared.
const MOST_BITS: usize = 150;
/// Of more waits and ages the rest is not compared.
const MOST_PAIRS: usize = 200;
/// Of a number that had more values nothing is guessed.
const MOST_VALUES: usize = 8;
/// Of more numbers the rest is not looked into.
const MOST_NUMBERS: usize = 60;
const CONFLICTS: u64 = 5_000;
/// Steps of the solver for all of its questions, and of the runs from which is guessed.
const MOST_WORK: u64 = 50_000_000;
const MOST_STEPS: usize = 100_000_000;
const SCANS: usize = 60;

/// What was seen of numbers in runs: for each wait and age by how much the wait was longer at most.
struct Pair {
    wait: usize,
    age: usize,
    most: i64,
}

/// Finds what always holds and adds it to the model.
pub(crate) fn add(model: &mut Model, targets: &[Lit], end: &End) {
    let guesses = guess(model, targets, end);
    model.lemmas = keep(model, guesses, end);
}

/// The bits that are remembered and matter, and of each wait whether something waits.
fn bits(model: &mut Model, targets: &[Lit]) -> Vec<Lit> {
    let reached = reach(model, targets.iter().copied());
    let of_numbers: Vec<usize> = (model.world.waits.iter().chain(&model.world.ages))
        .flatten()
        .copied()
        .collect();
    let mut bits: Vec<Lit> = (model.world.states.iter().enumerate())
        .filter(|(n, state)| reached.contains(&state.leaf.node()) && !of_numbers.contains(n))
        .map(|(_, state)| state.leaf)
        .collect();
    for n in 0..model.world.waits.len() {
        let leaves: Vec<Lit> = model.world.waits[n]
            .iter()
            .map(|n| model.world.states[*n].leaf)
            .collect();
        bits.push(model.world.graph.any(leaves));
    }
    bits
}

fn guess(model: &mut Model, targets: &[Lit], end: &End) -> Vec<Lit> {
    let bits = bits(model, targets);
    let compared = bits.len().min(MOST_BITS);
    let mut pairs: Vec<Pair> = Vec::new();
    for wait in 0..model.world.waits.len() {
        for age in 0..model.world.ages.len() {
            pairs.push(Pair {
                wait,
                age,
                most: i64::MIN,
            });
        }
    }
    pairs.truncate(MOST_PAIRS);
    let mut sets = ValueSets::of(model, targets);
    // Of each bit whether it was ever low and high; of each pair which of the four were seen.
    let mut seen = vec![[false; 2]; bits.len()];
    let mut both = vec![0u8; compared * compared];
    let mut all: Vec<Lit> = targets.to_vec();
    all.extend(&bits);
    for round in 0..4u64 {
        let mut lanes = Lanes::new(model, &all, 0x9E37_79B9 + round * 77, 4 << round);
        for _ in 0..SCANS.min(MOST_STEPS / 4 / lanes.steps()) {
            if end.is_over() {
                break;
            }
            lanes.scan();
            let alive = lanes.alive;
            let values: Vec<u64> = bits.iter().map(|bit| lanes.value(*bit)).collect();
            for (seen, value) in seen.iter_mut().zip(&values) {
                seen[0] |= !value & alive != 0;
                seen[1] |= value & alive != 0;
            }
            for a in 0..compared {
                for b in a + 1..compared {
                    let (a_is, b_is) = (values[a], values[b]);
                    let found = &mut both[a * compared + b];
                    *found |= u8::from(!a_is & !b_is & alive != 0)
                        | u8::from(a_is & !b_is & alive != 0) << 1
                        | u8::from(!a_is & b_is & alive != 0) << 2
                        | u8::from(a_is & b_is & alive != 0) << 3;
                }
            }
            sets.note(model, &lanes);
            for pair in &mut pairs {
                let (waits, ages) = (&model.world.waits[pair.wait], &model.world.ages[pair.age]);
                for lane in (0..64).filter(|lane| alive >> lane & 1 == 1) {
                    let number = |bits: &[usize]| {
                        let bits = bits
                            .iter()
                            .map(|n| lanes.value(model.world.states[*n].leaf) >> lane & 1);
                        bits.enumerate()
                            .fold(0i64, |number, (n, bit)| number | (bit as i64) << n.min(62))
                    };
                    let wait = number(waits);
                    if wait > 0 {
                        pair.most = pair.most.max(wait - number(ages));
                    }
                }
            }
        }
    }
    let graph = &mut model.world.graph;
    let mut guesses: Vec<Lit> = Vec::new();
    for (bit, [low, high]) in bits.iter().zip(&seen) {
        match (low, high) {
            (true, false) => guesses.push(!*bit),
            (false, true) => guesses.push(*bit),
            _ => {}
        }
    }
    for a in 0..compared {
        for b in a + 1..compared {
            if seen[a] != [true; 2] || seen[b] != [true; 2] {
                continue;
            }
            for (n, (a_is, b_is)) in [(false, false), (true, false), (false, true), (true, true)]
                .into_iter()
                .enumerate()
            {
                if both[a * compared + b] >> n & 1 == 0 {
                    let together = graph.and(bits[a].negated_if(!a_is), bits[b].negated_if(!b_is));
                    guesses.push(!together);
                }
            }
        }
    }
    guesses.extend(sets.guesses(model));
    for pair in pairs
        .iter()
        .filter(|pair| (i64::MIN + 1..=2).contains(&pair.most))
    {
        let number = |bits: &[usize]| {
            let bits = bits.iter().map(|n| model.world.states[*n].leaf);
            Number::unsigned(bits.collect())
        };
        let (wait, age) = (
            number(&model.world.waits[pair.wait]),
            number(&model.world.ages[pair.age]),
        );
        let graph = &mut model.world.graph;
        let is_none = graph.equal(&wait, &Number::constant(0));
        let age = graph.add(&age, &Number::constant(pair.most.max(0)));
        let is_longer = graph.less(&age, &wait);
        guesses.push(graph.or(is_none, !is_longer));
    }
    guesses
}

/// Numbers that are remembered, with the values that were seen.
struct ValueSets {
    numbers: Vec<(Vec<usize>, BTreeSet<u64>)>,
}

impl ValueSets {
    /// Of those that matter.
    fn of(model: &Model, targets: &[Lit]) -> ValueSets {
        let reached = reach(model, targets.iter().copied());
        let matters = |bits: &&Vec<usize>| {
            let mut leaves = bits.iter().map(|n| model.world.states[*n].leaf.node());
            leaves.any(|node| reached.contains(&node))
        };
        let numbers = model.world.numbers.iter().filter(matters).take(MOST_NUMBERS);
        ValueSets {
            numbers: numbers.map(|bits| (bits.clone(), BTreeSet::new())).collect(),
        }
    }

    fn note(&mut self, model: &Model, lanes: &Lanes<'_>) {
        for (bits, seen) in &mut self.numbers {
            let bits: Vec<u64> = bits
                .iter()
                .map(|n| lanes.value(model.world.states[*n].leaf))
                .collect();
            for lane in (0..64).filter(|lane| lanes.alive >> lane & 1 == 1) {
                if seen.len() > MOST_VALUES {
                    break;
                }
                let value = bits.iter().enumerate();
                seen.insert(value.fold(0, |value, (n, bit)| value | (bit >> lane & 1) << n));
            }
        }
        self.numbers.retain(|(_, seen)| seen.len() <= MOST_VALUES);
    }

    /// That each has one of the values that were seen.
    fn guesses(&self, model: &mut Model) -> Vec<Lit> {
        let mut guesses = Vec::new();
        for (bits, seen) in self.numbers.iter().filter(|(_, seen)| seen.len() > 1) {
            let leaves: Vec<Lit> = bits.iter().map(|n| model.world.states[*n].leaf).collect();
            let graph = &mut model.world.graph;
            let is_one: Vec<Lit> = (seen.iter())
                .map(|value| {
                    let bits = leaves.iter().enumerate();
                    let bits = bits.map(|(n, leaf)| leaf.negated_if(value >> n & 1 == 0));
                    graph.all(bits)
                })
                .collect();
            guesses.push(graph.any(is_one));
        }
        guesses
    }
}

/// Those that one scan cannot break while all of them hold.
fn keep(model: &Model, mut guesses: Vec<Lit>, end: &End) -> Vec<Lit> {
    let mut step = Unrolled::new(model, From::Anywhere, end);
    if guesses.is_empty() || !step.add_scan() {
        return Vec::new();
    }
    step.add_next();
    let mut held = Vec::with_capacity(guesses.len());
    for guess in &guesses {
        let selector = step.selector();
        let before = step.lit(0, *guess);
        step.require_one(&[!selector, before]);
        let after = step.lit(1, *guess);
        held.push((selector, after));
    }
    while !guesses.is_empty() && step.work() < MOST_WORK {
        let breaks = step.selector();
        let mut clause: Vec<Lit> = held.iter().map(|(_, after)| !*after).collect();
        clause.push(!breaks);
        step.require_one(&clause);
        let mut question: Vec<Lit> = held.iter().map(|(selector, _)| *selector).collect();
        question.push(breaks);
        match step.ask(&question, CONFLICTS) {
            Found::No => return guesses,
            Found::Unknown => return Vec::new(),
            Found::Yes => {}
        }
        let stays: Vec<bool> = held.iter().map(|(_, after)| step.value_of(*after)).collect();
        if stays.iter().all(|stays| *stays) {
            return Vec::new();
        }
        let mut which = stays.iter();
        guesses.retain(|_| *which.next().unwrap_or(&false));
        let mut which = stays.iter();
        held.retain(|_| *which.next().unwrap_or(&false));
    }
    Vec::new()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::decide::{Depth, Known, Seeks, decide};
    use crate::model::tests::model_of;
    use crate::progress::Listener;
    use std::time::Duration;

    /// What is known of the first property of a program without what always holds, and with it.
    fn without_and_with(program: &str, property: &str) -> [Known; 2] {
        let mut model = model_of(program, property);
        let targets = vec![model.properties[0].bad];
        let depth = Depth {
            base: 5,
            step: 5,
            end: End::in_time(Duration::from_secs(20)),
            seeks: Seeks::Every,
            conflicts: CONFLICTS,
            listener: Listener::default(),
        };
        let without = decide(&model, &targets, &depth).0.remove(0);
        add(&mut model, &targets, &depth.end);
        [without, decide(&model, &targets, &depth).0.remove(0)]
    }

    #[test]
    fn a_wait_is_no_longer_than_a_timer_runs() {
        let program = "VAR t : TON; END_VAR\n+--[ ]( start )--( )( run )--+\n+--[ ]( run )--[TON]( t, T#5s )--( )( ready )--+\n";
        let known = without_and_with(program, "within 5s of run: ready or not run");
        assert_eq!(known, [Known::NotIn(5), Known::Never(0)]);
    }

    /// The phases are 0, 3, 5 and 6, of which any two bits have all four combinations; from 1 on there would be a way to 7.
    #[test]
    fn a_number_has_one_of_the_values_that_were_seen() {
        let program = "VAR phase : INT; t : TON; END_VAR
+--[/]( t.Q )--[TON]( t, T#1s )--+
+--[ ]( t.Q )--[LUT]( phase, phase, 3, 2, 4, 5, 7, 6, 0, 7 )--+
+--[EQ]( phase, 7 )--( )( lost )--+
";
        let known = without_and_with(program, "never lost");
        assert!(matches!(known, [Known::NotIn(5), Known::Never(_)]), "{known:?}");
    }
}

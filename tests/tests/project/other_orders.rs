//! What a comparison says of programs whose networks were swapped, moved, doubled and deleted, next to runs of both: where it says
//! that they do the same, no run differs.

use ladder_analysis::Cancel;
use ladder_analysis::program::Role;
use ladder_invariants::generator::{Dice, Mode, program};
use ladder_invariants::runs::differing;
use ladder_invariants::trace::compile;
use ladder_review::outline::{Entry, Kind};
use ladder_review::whole::Whole;
use ladder_review::{Limits, Outline, compare};
use ladder_simulator::{Options as Running, Point, Simulation};
use std::time::Duration;

fn simulation(text: &str) -> Option<Simulation> {
    let options = Running {
        watchdog: 20_000,
        ..Running::default()
    };
    Simulation::new(compile(text)?, options).ok()
}

/// Outputs that differ after some scan in which both programs have the same inputs.
fn differs(old: &str, new: &str, seed: u64) -> Option<String> {
    let (mut old, mut new) = (simulation(old)?, simulation(new)?);
    let inputs = old.points().iter().filter(|point| point.is_input);
    let inputs: Vec<String> = inputs.map(|point| point.name.clone()).collect();
    let outputs = old.points().iter().filter(|point| point.role == Role::Output);
    let outputs = outputs.filter_map(|point| Some((point.clone(), new.resolve(&point.name).ok()?)));
    let outputs: Vec<(Point, Point)> = outputs.collect();
    differing([&mut old, &mut new], &inputs, &outputs, seed)
}

/// What is reported of two texts. None: nothing is.
fn told(old: &str, new: &str) -> Option<Whole> {
    let [old, new] = [old, new].map(|text| Outline::of_text("main.clad", text));
    let mut comparison = compare(&old, &new);
    comparison.decide(Duration::from_secs(2), &Cancel::default());
    let limits = Limits {
        time: Duration::from_millis(500),
        scans: 10,
        readable: 100_000,
    };
    comparison.decide_whole(limits, usize::MAX);
    comparison.whole
}

/// The networks that are next to each other: of the program with its functions, and of each body.
fn neighbours<'e>(entries: &'e [Entry], found: &mut Vec<Vec<&'e Entry>>) {
    let is_network = |entry: &&Entry| entry.kind == Kind::Network;
    found.push(entries.iter().filter(is_network).collect());
    for entry in entries.iter().filter(|entry| entry.kind == Kind::Block) {
        neighbours(&entry.inside, found);
    }
}

/// A text with networks that are elsewhere, twice there or gone. None: it has too few.
fn reordered(text: &str, dice: &mut Dice) -> Option<String> {
    let outline = Outline::of_text("main.clad", text);
    let mut lists = Vec::new();
    neighbours(&outline.entries, &mut lists);
    lists.retain(|list| list.len() > 1);
    if lists.is_empty() {
        return None;
    }
    let list = lists.swap_remove(dice.below(lists.len()));
    let (one, other) = (dice.below(list.len()), dice.below(list.len()));
    let mut order: Vec<usize> = (0..list.len()).collect();
    match dice.below(4) {
        0 => order.swap(one, other),
        1 => {
            let moved = order.remove(one);
            order.insert(other.min(order.len()), moved);
        }
        2 => order.insert(other, one),
        _ => drop(order.remove(one)),
    }
    // The stretches between the networks stay where they are.
    let mut new = String::new();
    let mut at = 0;
    let mut places = list.iter();
    for entry in order {
        if let Some(place) = places.next() {
            new.push_str(&text[at..usize::from(place.range.start())]);
            at = place.range.end().into();
        }
        let range = list[entry].range;
        let form = &text[usize::from(range.start())..usize::from(range.end())];
        new.push_str(form);
        if !form.ends_with(['\r', '\n']) {
            new.push('\n');
        }
    }
    for place in places {
        new.push_str(&text[at..usize::from(place.range.start())]);
        at = place.range.end().into();
    }
    new.push_str(&text[at..]);
    Some(new)
}

#[test]
fn what_is_called_the_same_in_another_order_never_differs_in_a_run() {
    let (mut same, mut other) = (0, 0);
    for seed in 0..20 {
        for mode in [Mode::Boolean, Mode::Sensible, Mode::Wild, Mode::Typed] {
            let mut dice = Dice::new(seed);
            let old = program(seed, mode);
            let Some(new) = reordered(&old, &mut dice) else {
                continue;
            };
            match told(&old, &new) {
                Some(Whole::Same) => {
                    same += 1;
                    if let Some(what) = differs(&old, &new, seed) {
                        panic!(
                            "{mode:?}, seed {seed}: reported to be the same, and differs: {what}\n{old}\n{new}"
                        );
                    }
                }
                Some(Whole::Differs(_) | Whole::Outputs(_)) => other += 1,
                Some(Whole::NotDecided(_)) | None => {}
                Some(Whole::Refuted) => {
                    panic!("{mode:?}, seed {seed}: a run that does not happen\n{old}\n{new}")
                }
            }
        }
    }
    println!("{same} the same, {other} other");
    assert!(same >= 10 && other >= 8, "{same} the same, {other} other");
}

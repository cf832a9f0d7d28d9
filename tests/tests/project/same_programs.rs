//! What the prover says of pairs of whole programs next to runs of both: what is the same never differs in a run, a difference is
//! one of both simulators, and what was only laid out in another way or put in another order is never said to differ.

use crate::followed::{programs, value};
use ladder_analysis::program::Role;
use ladder_format::{Options as Layout, format_text};
use ladder_invariants::generator::{Dice, Mode, program};
use ladder_invariants::trace::compile;
use ladder_prover::{Limits, Whole, compare_programs};
use ladder_simulator::{Options as Running, Point, Simulation};
use std::collections::BTreeMap;
use std::time::Duration;

fn simulation(text: &str) -> Option<Simulation> {
    let options = Running {
        watchdog: 20_000,
        ..Running::default()
    };
    Simulation::new(compile(text)?, options).ok()
}

/// What is said of two programs. None: one has errors.
fn said(old: &str, new: &str) -> Option<Whole> {
    let (mut was, mut is) = (simulation(old)?, simulation(new)?);
    let limits = Limits {
        time: Duration::from_millis(1_500),
        scans: 10,
        readable: 1_000_000,
    };
    let said = compare_programs(&mut was, &mut is, limits);
    Some(said.unwrap_or_else(|_| panic!("a run was found that does not happen\n{old}\n{new}")))
}

/// Outputs that differ after some scan in which both programs have the same inputs.
fn differs(old: &str, new: &str, seed: u64) -> Option<String> {
    let (mut old, mut new) = (simulation(old)?, simulation(new)?);
    let both = |role: Role| -> Vec<(Point, Option<Point>)> {
        let points = old.points().iter();
        let points = points.filter(|point| point.role == role && !point.read_only && !point.ty.is_string());
        points
            .map(|point| (point.clone(), new.resolve(&point.name).ok()))
            .collect()
    };
    let (inputs, outputs) = (both(Role::Input), both(Role::Output));
    let mut dice = Dice::new(seed);
    for hold in [2, 3, 8, 20] {
        old.reset();
        new.reset();
        for scan in 0..60 {
            for (point, other) in &inputs {
                if dice.below(hold) == 0 {
                    let value = value(&mut dice, point.ty);
                    old.set(point, value.clone()).expect("it fits");
                    if let Some(other) = other.as_ref().filter(|other| other.role == Role::Input) {
                        new.set(other, value).expect("it fits there, too");
                    }
                }
            }
            // A scan that does not come to its end is not compared.
            if !old.scan() || !new.scan() {
                break;
            }
            let other = outputs.iter().find(|(point, other)| {
                other
                    .as_ref()
                    .is_some_and(|other| old.value(point) != new.value(other))
            });
            if let Some((point, _)) = other {
                return Some(format!("{} in scan {scan}", point.name));
            }
        }
    }
    None
}

/// Plays a difference that was found, with what is shown of it and no more.
fn confirms(old: &str, new: &str, whole: &Whole) -> bool {
    let Whole::Differs(run) = whole else { return true };
    let [mut old, mut new] = [old, new].map(|text| simulation(text).expect("it was compared"));
    let mut is_so = true;
    for scan in 0..run.scans {
        for simulation in [&mut old, &mut new] {
            for row in &run.given {
                let point = simulation.resolve(&row.name).ok();
                if let Some(point) = point.filter(|point| point.role == Role::Input) {
                    simulation.set(&point, row.values[scan].clone()).expect("it fits");
                }
            }
            is_so &= simulation.scan();
        }
        for differing in &run.differs {
            let value = |simulation: &Simulation| {
                simulation.value(&simulation.resolve(&differing.name).expect("both have it"))
            };
            is_so &= value(&old) == differing.old[scan] && value(&new) == differing.new[scan];
        }
        let faulted = [&mut old, &mut new].map(|simulation| !simulation.take_faults().is_empty());
        is_so &= faulted == [run.faults[0][scan], run.faults[1][scan]];
    }
    let last = run.scans - 1;
    let shows = run.differs.iter().any(|tag| tag.old[last] != tag.new[last]);
    is_so && (shows || run.faults[0][last] != run.faults[1][last] || run.ended.is_some())
}

/// How often each was said.
#[derive(Debug, Default)]
struct Tally {
    same: usize,
    differs: usize,
    unknown: usize,
    why: BTreeMap<String, usize>,
}

fn check(old: &str, new: &str, seed: u64, tally: &mut Tally) {
    let Some(whole) = said(old, new) else { return };
    assert!(confirms(old, new, &whole), "seed {seed}: {whole:?}\n{old}\n{new}");
    match whole {
        Whole::Same => {
            tally.same += 1;
            if let Some(what) = differs(old, new, seed) {
                panic!("seed {seed}: said to be the same, and differs: {what}\n{old}\n{new}");
            }
        }
        Whole::Differs(_) => tally.differs += 1,
        Whole::Unknown(why) => {
            tally.unknown += 1;
            *tally.why.entry(why).or_default() += 1;
        }
    }
}

const EDITS: [(&str, &str); 12] = [
    ("[ ](", "[/]("),
    ("[/](", "[ ]("),
    ("[P](", "[N]("),
    ("[N](", "[ ]("),
    ("( )(", "(/)("),
    ("(S)(", "( )("),
    ("(R)(", "(S)("),
    ("[ADD]", "[SUB]"),
    ("[GT]", "[GE]"),
    ("[EQ]", "[NE]"),
    ("[SR]", "[RS]"),
    ("[TON]", "[TP]"),
];

fn mutants(mode: Mode) -> Tally {
    let mut tally = Tally::default();
    for seed in 0..programs() {
        let text = program(seed, mode);
        let mut dice = Dice::new(seed);
        for (word, other) in EDITS {
            let places: Vec<usize> = text.match_indices(word).map(|(at, _)| at).collect();
            let Some(&at) = places.get(dice.below(places.len().max(1))) else {
                continue;
            };
            let new = format!("{}{other}{}", &text[..at], &text[at + word.len()..]);
            check(&text, &new, seed, &mut tally);
        }
    }
    println!("{mode:?}: {tally:?}");
    tally
}

#[test]
fn one_edit_in_contacts_and_coils() {
    let tally = mutants(Mode::Boolean);
    assert!(tally.same >= 5 && tally.differs >= 15, "{tally:?}");
    assert!(tally.unknown * 20 <= tally.differs, "{tally:?}");
}

#[test]
fn one_edit_in_sensible_programs() {
    let tally = mutants(Mode::Sensible);
    assert!(tally.same >= 5 && tally.differs >= 20, "{tally:?}");
}

#[test]
fn one_edit_in_wild_programs() {
    mutants(Mode::Wild);
}

#[test]
fn one_edit_in_programs_with_types() {
    mutants(Mode::Typed);
}

#[test]
fn another_layout_is_no_difference() {
    let mut tally = Tally::default();
    for seed in 0..programs() {
        for mode in [Mode::Boolean, Mode::Sensible, Mode::Wild, Mode::Typed] {
            let text = program(seed, mode);
            let layout = Layout {
                width: 60,
                ..Layout::default()
            };
            let narrow = format_text(&text, &layout);
            check(&text, &narrow, seed, &mut tally);
            assert_eq!(tally.differs, 0, "{mode:?}, seed {seed}\n{text}");
        }
    }
    println!("{tally:?}");
    assert!(tally.same > 45, "{tally:?}");
}

/// Networks of tags of their own, in any order.
#[test]
fn another_order_of_what_has_nothing_in_common_is_no_difference() {
    let mut tally = Tally::default();
    for seed in 0..programs() {
        let mut dice = Dice::new(seed);
        let mut networks: Vec<String> = (0..6)
            .map(|n| {
                let block = dice.of(&[
                    "[P]( aN )",
                    "[ ]( aN )--[TON]( tN, T#50ms )",
                    "[ ]( aN )--[CTU]( cN, 3 )",
                ]);
                let coil = dice.of(&["( )( xN )", "(S)( xN )", "(/)( xN )"]);
                let rung = format!("+--[/]( bN )--{block}--{coil}--+\n\n");
                rung.replace('N', &n.to_string())
            })
            .collect();
        let old = networks.concat();
        dice.shuffle(&mut networks);
        check(&old, &networks.concat(), seed, &mut tally);
        assert_eq!((tally.differs, tally.unknown), (0, 0), "seed {seed}\n{old}");
    }
}

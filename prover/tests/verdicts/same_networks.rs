//! What the prover says of pairs of networks next to runs of both programs: what does the same never differs in a run, and what
//! was only drawn or written in another way is never said to differ.

use super::compile;
use super::followed::programs;
use ladder_analysis::Cancel;
use ladder_format::{Options as Layout, format_text};
use ladder_generator::generator::{Dice, Mode, program};
use ladder_generator::runs::value;
use ladder_prover::{Compared, Meaning, other_tags};
use ladder_simulator::{Options as Running, Simulation};
use std::time::Duration;

/// The verdict on each pair of networks. None: they cannot be compared one by one.
fn meanings(old: &str, new: &str) -> Option<Vec<Meaning>> {
    let (old, new) = (compile(old)?, compile(new)?);
    if old.networks.len() != new.networks.len() {
        return None;
    }
    let compared = Compared::new(&old, &new).ok()?;
    let networks = 0..old.networks.len();
    let told = networks.map(|n| compared.networks(n, n, Duration::from_secs(2), &Cancel::default()));
    let same_tags = other_tags(&old, &new).is_empty();
    same_tags.then(|| told.collect())
}

/// Whether some values differ after some scan in which both programs have the same inputs.
fn differ(old: &str, new: &str, seed: u64) -> bool {
    let run = |text: &str| {
        let options = Running {
            watchdog: 20_000,
            ..Running::default()
        };
        Simulation::new(compile(text)?, options).ok()
    };
    let (Some(mut old), Some(mut new)) = (run(old), run(new)) else {
        return false;
    };
    let points = old.points().iter();
    let points: Vec<_> = points
        .filter_map(|point| Some((point.clone(), new.resolve(&point.name).ok()?)))
        .collect();
    let mut dice = Dice::new(seed);
    for _ in 0..4 {
        old.reset();
        new.reset();
        for _ in 0..30 {
            for (point, other) in &points {
                if point.is_input && dice.one_in(3) {
                    let value = value(&mut dice, point.ty);
                    if old.set(point, value.clone()).is_ok() {
                        new.set(other, value).expect("it fits there, too");
                    }
                }
            }
            // A scan that does not come to its end is not compared.
            if !old.scan() || !new.scan() {
                break;
            }
            if points
                .iter()
                .any(|(point, other)| old.value(point) != new.value(other))
            {
                return true;
            }
        }
    }
    false
}

/// A text with one word for another at one of its places. None: there is no such word.
fn edited(text: &str, word: &str, other: &str, dice: &mut Dice) -> Option<String> {
    let places: Vec<usize> = text.match_indices(word).map(|(at, _)| at).collect();
    let at = *places.get(dice.below(places.len().max(1)))?;
    Some(format!("{}{other}{}", &text[..at], &text[at + word.len()..]))
}

const EDITS: [(&str, &str); 11] = [
    ("[ ](", "[/]("),
    ("[/](", "[ ]("),
    ("[P](", "[N]("),
    ("[N](", "[ ]("),
    ("( )(", "(/)("),
    ("(S)(", "(R)("),
    ("(R)(", "(S)("),
    ("[ADD]", "[SUB]"),
    ("[GT]", "[GE]"),
    ("[EQ]", "[NE]"),
    ("[SR]", "[RS]"),
];

/// How many edits were said to do the same, and how many to differ.
fn edits(mode: Mode) -> (usize, usize) {
    let mut tally = (0, 0);
    for seed in 0..programs() {
        let text = program(seed, mode);
        let mut dice = Dice::new(seed);
        for (word, other) in EDITS {
            let Some(new) = edited(&text, word, other, &mut dice) else {
                continue;
            };
            let Some(told) = meanings(&text, &new) else {
                continue;
            };
            let is_same = told.iter().all(|meaning| *meaning == Meaning::Same);
            tally.0 += usize::from(is_same);
            tally.1 += usize::from(told.iter().any(|meaning| matches!(meaning, Meaning::Other(_))));
            assert!(
                !is_same || !differ(&text, &new, seed),
                "seed {seed}, {word} to {other}: reported to be the same\n{text}\n{new}"
            );
        }
    }
    println!("{mode:?}: {} the same, {} other", tally.0, tally.1);
    tally
}

#[test]
fn what_differs_in_a_run_is_never_the_same() {
    for (mode, least) in [(Mode::Boolean, 30), (Mode::Sensible, 30), (Mode::Wild, 5)] {
        let (same, other) = edits(mode);
        assert!(same + other >= least, "{mode:?}: {same} {other}");
    }
}

#[test]
fn what_is_laid_out_in_another_way_is_never_another_thing() {
    let mut same = 0;
    for seed in 0..programs() {
        for mode in [Mode::Boolean, Mode::Sensible, Mode::Wild] {
            let text = program(seed, mode);
            let narrow = format_text(
                &text,
                &Layout {
                    width: 60,
                    ..Layout::default()
                },
            );
            for meaning in meanings(&text, &narrow).into_iter().flatten() {
                assert!(
                    !matches!(meaning, Meaning::Other(_) | Meaning::Declared(_)),
                    "{mode:?}, seed {seed}: {meaning:?}\n{text}"
                );
                same += usize::from(meaning == Meaning::Same);
            }
        }
    }
    assert!(same > 100, "only {same} are the same");
}

/// A contact, a branch of two of them, and rungs of these.
#[derive(Clone)]
enum Part {
    One(String),
    Either(String, String),
}

fn rung(parts: &[Part]) -> String {
    let (mut upper, mut lower) = (String::from("+--"), String::from("|  "));
    for part in parts {
        match part {
            Part::One(contact) => {
                upper.push_str(contact);
                lower.push_str(&" ".repeat(contact.len()));
            }
            Part::Either(above, below) => {
                let width = above.len().max(below.len());
                upper.push_str(&format!("\\--{above:-<width$}--\\"));
                lower.push_str(&format!("/--{below:-<width$}--/"));
            }
        }
        upper.push_str("--");
        lower.push_str("  ");
    }
    format!("{upper}( )( x )--+\n{lower}         |\n")
}

fn contact(dice: &mut Dice) -> String {
    format!(
        "[{}]( {} )",
        dice.of(&[" ", "/", "P", "N"]),
        dice.of(&["a", "b", "c", "x"])
    )
}

/// A rung, and one that does the same: its branches swapped, its parts in another order, and power negated twice.
fn rewritten(dice: &mut Dice) -> (String, String) {
    let mut parts: Vec<Part> = Vec::new();
    for _ in 0..=dice.below(4) {
        parts.push(if dice.one_in(2) {
            Part::One(contact(dice))
        } else {
            Part::Either(contact(dice), contact(dice))
        });
    }
    let old = rung(&parts);
    for part in &mut parts {
        if let Part::Either(above, below) = part
            && dice.one_in(2)
        {
            std::mem::swap(above, below);
        }
    }
    dice.shuffle(&mut parts);
    parts.push(Part::One("[NOT]--[NOT]".into()));
    (old, rung(&parts))
}

/// Whether a rung has two edges of one tag: which memory is whose is not known of these once they have changed places.
fn has_edges_twice(rung: &str) -> bool {
    ["a", "b", "c", "x"].iter().any(|tag| {
        let count = |kind: &str| rung.matches(&format!("[{kind}]( {tag} )")).count();
        count("P") + count("N") > 1
    })
}

#[test]
fn rungs_that_are_written_in_another_way_are_the_same() {
    let mut checked = 0;
    for seed in 0..programs() * 20 {
        let (old, new) = rewritten(&mut Dice::new(seed));
        let told = meanings(&old, &new).unwrap_or_else(|| panic!("they compile:\n{old}{new}"));
        checked += 1;
        if has_edges_twice(&old) {
            assert!(
                !matches!(told[0], Meaning::Other(_)),
                "seed {seed}: {told:?}\n{old}{new}"
            );
            continue;
        }
        assert_eq!(told, [Meaning::Same], "seed {seed}\n{old}{new}");
    }
    assert!(checked > 100);
}

#[test]
fn a_contact_of_another_kind_is_never_the_same_where_runs_differ() {
    let (mut differs, mut said_so) = (0, 0);
    for seed in 0..programs() * 20 {
        let mut dice = Dice::new(seed);
        let (old, _) = rewritten(&mut dice);
        let (word, other) = dice.of(&[("[ ]", "[/]"), ("[/]", "[P]"), ("[P]", "[N]"), ("[N]", "[ ]")]);
        let Some(new) = edited(&old, word, other, &mut dice) else {
            continue;
        };
        let told = meanings(&old, &new).unwrap_or_else(|| panic!("they compile:\n{old}{new}"));
        if differ(&old, &new, seed) {
            differs += 1;
            assert_ne!(told, [Meaning::Same], "seed {seed}\n{old}{new}");
            said_so += usize::from(matches!(told[0], Meaning::Other(_)));
        }
    }
    assert!(differs > 50 && said_so == differs, "{said_so} of {differs}");
}

//! Programs with types of their own: the simulator next to the reference evaluation.
//!
//! `GENERATED_PROGRAMS=5000 cargo test -p ladder-invariants typed` tries more.

use ladder_invariants::generator::{Dice, typed_of};
use ladder_invariants::trace::{Stimulus, compare_typed};

fn count(default: u64) -> u64 {
    let asked = std::env::var("GENERATED_PROGRAMS").ok();
    asked.and_then(|count| count.parse().ok()).unwrap_or(default)
}

#[test]
fn parts_of_tags_do_what_the_definition_says() {
    for seed in 0..count(100) {
        compare_typed(&typed_of(&mut Dice::new(seed)), Stimulus { seed, scans: 12 }, 0);
    }
}

#[test]
fn an_edit_keeps_what_has_the_same_path_and_type() {
    for seed in 0..count(30) {
        compare_typed(&typed_of(&mut Dice::new(seed)), Stimulus { seed, scans: 40 }, 8);
    }
}

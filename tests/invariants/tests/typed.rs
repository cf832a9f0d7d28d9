//! Programs with types of their own: the simulator next to the reference evaluation.

use ladder_invariants::generator::{Dice, typed_of};
use ladder_invariants::trace::{Stimulus, compare_typed};

#[test]
fn parts_of_tags_do_what_the_definition_says() {
    for seed in 0..150 {
        compare_typed(&typed_of(&mut Dice::new(seed)), Stimulus { seed, scans: 12 });
    }
}

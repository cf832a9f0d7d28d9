//! Programs that do the same by how they were made: laid out in another way, or put in another order that does not matter.

use super::case::Case;
use super::followed::programs;
use super::judge::{Tally, all, wrong_sameness};
use ladder_format::{Options as Layout, format_text};
use ladder_generator::generator::{Dice, Mode, program};

fn check(old: &str, new: &str, seed: u64, tally: &mut Tally) {
    let [Some(old), Some(new)] = [old, new].map(Case::of_text) else {
        return;
    };
    let wrong = wrong_sameness(&old, &new, seed, all, tally);
    assert_eq!((wrong, tally.differs), (None, 0), "seed {seed}\n{old}");
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
            check(&text, &format_text(&text, &layout), seed, &mut tally);
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
        assert_eq!(tally.undecided, 0, "seed {seed}\n{old}");
    }
}

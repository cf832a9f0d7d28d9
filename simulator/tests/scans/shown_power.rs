//! The power that is shown is that of the last scan, whether something is forced (plain code runs) or not.

use crate::support::{force, set, simulation};
use expect_test::{Expect, expect};
use ladder_analysis::program::ElementKind;
use ladder_simulator::Simulation;

/// The power of every block, with the letters that it is written in.
fn power(simulation: &Simulation, text: &str) -> String {
    let mut shown = String::new();
    for (kind, location, power) in simulation.power() {
        if kind == ElementKind::Block {
            shown.push_str(&format!("{} {}\n", &text[location.range], u8::from(power)));
        }
    }
    shown
}

/// Sets the tags before each scan and shows the power after the last.
#[track_caller]
#[allow(clippy::needless_pass_by_value)]
fn check(text: &str, scans: &[&[(&str, &str)]], expected: Expect) {
    let text = format!("VAR unused : BOOL; END_VAR\n{text}");
    for forced in [false, true] {
        let mut simulation = simulation(&text);
        if forced {
            force(&mut simulation, "unused", "0");
        }
        for tags in scans {
            for (tag, value) in *tags {
                set(&mut simulation, tag, value);
            }
            simulation.scan();
        }
        expected.assert_eq(&power(&simulation, &text));
    }
}

/// A body is drawn once, as its first place runs it. That place was jumped over, the second was not.
#[test]
fn the_first_place_of_a_block_is_shown() {
    check(
        "FUNCTION_BLOCK [$B]\nVAR x : BOOL; END_VAR\n+--( )( x )--+\nEND_FUNCTION_BLOCK\n\
         VAR_INPUT skip : BOOL; END_VAR\n\
         +--[ ]( skip )--<JMP>( over )--+\n\
         +--[$B]--+\n\
         +--<LBL>( over )--[$B]--+\n",
        &[&[("skip", "1")]],
        expect![[r#"
            [ ]( skip ) 1
            <JMP>( over ) 0
            ( )( x ) 0
            [$B] 0
            <LBL>( over ) 1
            [$B] 1
        "#]],
    );
}

/// A fault followed by more contacts: what the block would have written is not there.
#[test]
fn a_fault_leaves_a_coil_without_power() {
    check(
        "VAR_INPUT a : BOOL; i : INT; END_VAR\nVAR list : ARRAY[0..1] OF BOOL; y : BOOL; END_VAR\n\
         +--[ ]( a )--(S)( list[i] )--( )( y )--+\n",
        &[&[("a", "1")], &[("i", "7")]],
        expect![[r#"
            [ ]( a ) 1
            (S)( list[i] ) 0
            ( )( y ) 0
        "#]],
    );
}

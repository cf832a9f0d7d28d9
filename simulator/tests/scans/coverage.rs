//! What scans have exercised of a program.

use crate::support::{set, simulation};
use expect_test::{Expect, expect};
use ladder_simulator::coverage::Coverage;

/// The parts that were not seen both ways after a scan with `a` low and one with it high.
fn check(text: &str, expected: Expect) {
    let mut simulation = simulation(text);
    let mut coverage = Coverage::of(&mut simulation);
    for value in ["0", "1"] {
        set(&mut simulation, "a", value);
        coverage.scan(&mut simulation);
    }
    coverage.finish(&simulation);
    let mut shown = String::new();
    for part in &coverage.parts {
        if !(part.on && part.off) {
            let place = &text[part.location.range];
            shown.push_str(&format!("{place} on: {}, off: {}\n", part.on, part.off));
        }
    }
    expected.assert_eq(&shown);
}

#[test]
fn a_coil_that_is_always_with_power() {
    check(
        "VAR_INPUT a : BOOL; END_VAR\n+--( )( y )--(S)( z )--+\n+--\\--( )( w )--+\n|  /--[ ]( a )--( )( v )--+\n",
        expect![[""]],
    );
    // A master control takes its power away.
    check(
        "VAR_INPUT a : BOOL; END_VAR\n+--[/]( SYS.OFF )--<MCR>--+\n+--( )( y )--[ ]( a )--( )( z )--+\n",
        expect![[r#"
            [/]( SYS.OFF ) on: true, off: false
            ( )( y ) on: true, off: false
        "#]],
    );
}

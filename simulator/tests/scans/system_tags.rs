//! The clocks of SYS (LANGUAGE §4).

use crate::support::{check, simulation_with, trace};
use expect_test::expect;
use ladder_simulator::Options;

const CLOCKS: &str = "VAR a, b, c, d, e, f : BOOL; END_VAR\n\
    +--[ ]( SYS.CLOCK_10MS )--( )( a )--+\n\
    +--[ ]( SYS.CLOCK_100MS )--( )( b )--+\n\
    +--[ ]( SYS.CLOCK_500MS )--( )( c )--+\n\
    +--[ ]( SYS.CLOCK_1S )--( )( d )--+\n\
    +--[ ]( SYS.CLOCK_1M )--( )( e )--+\n\
    +--[ ]( sys.clock_1h )--( )( f )--+\n";

fn every(milliseconds: i64, scans: usize) -> String {
    let options = Options {
        interval: milliseconds * 1_000_000,
        ..Options::default()
    };
    trace(
        &mut simulation_with(CLOCKS, options),
        &scans.to_string(),
        "a b c d e f",
    )
}

#[test]
fn square_waves_low_in_the_first_half() {
    expect![[r#"
        a  _-_-_-_-_-_-_-_-_-_-_-_-
        b  __________----------____
        c  ________________________
        d  ________________________
        e  ________________________
        f  ________________________
    "#]]
    .assert_eq(&every(5, 24));
    expect![[r#"
        a  ________________________
        b  _-_-_-_-_-_-_-_-_-_-_-_-
        c  _____-----_____-----____
        d  __________----------____
        e  ________________________
        f  ________________________
    "#]]
    .assert_eq(&every(50, 24));
    expect![[r#"
        a  ________________________
        b  _-_-_-_-_-_-_-_-_-_-_-_-
        c  _-_-_-_-_-_-_-_-_-_-_-_-
        d  __--__--__--__--__--__--
        e  ________________________
        f  ________________________
    "#]]
    .assert_eq(&every(250, 24));
    expect![[r#"
        a  ________________________
        b  ________________________
        c  ________________________
        d  ________________________
        e  ___---___---___---___---
        f  ________________________
    "#]]
    .assert_eq(&every(10_000, 24));
    expect![[r#"
        a  ________________________
        b  ________________________
        c  ________________________
        d  ________________________
        e  ________________________
        f  ___---___---___---___---
    "#]]
    .assert_eq(&every(600_000, 24));
}

/// A scan sees the level of the moment at which it began, however long the scans are.
#[test]
fn scans_that_are_longer_than_the_wave() {
    expect![[r#"
        a  __--_--__-__--_--__-__--
        b  _________________-------
        c  ________________________
        d  ________________________
        e  ________________________
        f  ________________________
    "#]]
    .assert_eq(&every(3, 24));
    expect![[r#"
        a  _-__--_--__-__--_--__-__
        b  ________-------_______--
        c  ________________________
        d  ________________________
        e  ________________________
        f  ________________________
    "#]]
    .assert_eq(&every(7, 24));
}

#[test]
fn they_stay_the_same_within_a_scan() {
    check(
        "VAR n : INT; END_VAR\n+--<FOR>( 3 )--+\n+--[P]( SYS.CLOCK_100MS )--[ADD]( n, n, 1 )--+\n+--<NEXT>--+\n",
        "20",
        "n SYS.CLOCK_100MS",
        expect![[r#"
            n                0 0 0 0 0 1 1 1 1 1 1 1 1 1 1 2 2 2 2 2
            SYS.CLOCK_100MS  _____-----_____-----
        "#]],
    );
}

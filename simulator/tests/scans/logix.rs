//! The profile `logix`: power after timers and counters, edges at the start, formulas, and numbers that do not fit.

use crate::support::check;
use expect_test::expect;

fn logix(text: &str) -> String {
    format!("# ladder: profile logix #\n{text}")
}

#[test]
fn power_passes_timers_and_counters() {
    check(
        &logix(
            "VAR_INPUT en : BOOL; END_VAR\nVAR t : TON; c : CTU; END_VAR\n\
             +--[ ]( en )--[TON]( t, T#20ms )--( )( y )--+\n\
             +--[ ]( en )--[CTU]( c, 1 )--(S)( z )--( )( w )--+\n",
        ),
        "en  _---_",
        "y t.Q z w c.CV",
        expect![[r#""#]],
    );
}

#[test]
fn what_is_high_at_the_start_does_not_rise() {
    check(
        &logix(
            "VAR_INPUT en : BOOL; END_VAR\nVAR c : CTU; END_VAR\n\
             +--[P]( en )--( )( p )--+\n\
             +--[ ]( en )--[OSR]--( )( o )--+\n\
             +--[ ]( en )--(P)( q )--+\n\
             +--[ ]( en )--[CTU]( c, 9 )--+\n",
        ),
        "en  --_-_",
        "p o q c.CV",
        expect![[r#""#]],
    );
}

#[test]
fn formulas_are_rounded_and_cut_at_their_end() {
    check(
        &logix(
            "VAR i, j : INT; d, n, m, z, q : DINT; s : SINT; r : REAL; END_VAR\n\
             +--[MOV]( i, 30000 )--[CALC]( d, i * 2 / 3 )--[CALC]( j, i * 2 )--+\n\
             +--[MOV]( r, 2.5 )--[CALC]( n, r )--[CALC]( m, r * 3 )--[TYP]( s, 300 )--+\n\
             +--[CALC]( z, 7 / q )--[CALC]( i, 7 MOD q )--[DIV]( q, d, q )--+\n",
        ),
        "",
        "d j n m s z i q",
        expect![[r#""#]],
    );
}

#[test]
fn a_real_divided_by_zero_is_a_fault() {
    check(
        &logix("VAR r, x, n : REAL; END_VAR\n+--[MOV]( x, 1.5 )--[CALC]( r, x / n )--( )( y )--+\n"),
        "",
        "r y",
        expect![[r#""#]],
    );
}

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
             +--[ ]( en )--[CTU]( c, 1 )--( )( w )--+\n",
        ),
        "en  _----_",
        "y t.Q w c.CV",
        expect![[r#"
            y     _----_
            t.Q   ___--_
            w     _----_
            c.CV  0 1 1 1 1 1
        "#]],
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
        expect![[r#"
            p     ___-_
            o     ___-_
            q     ___-_
            c.CV  0 0 0 1 1
        "#]],
    );
}

#[test]
fn formulas_are_rounded_and_cut_at_their_end() {
    check(
        &logix(
            "VAR_INPUT x : BOOL; END_VAR\nVAR i, j : INT; d, n, m, z, q : DINT; s : SINT; r : REAL; END_VAR\n\
             +--[MOV]( i, 30000 )--[CALC]( d, i * 2 / 3 )--[CALC]( j, i * 2 )--+\n\
             +--[MOV]( r, 2.5 )--[CALC]( n, r )--[CALC]( m, r * 3 )--[TYP]( s, 300 )--+\n\
             +--[CALC]( z, 7 / q )--[CALC]( i, 7 MOD q )--[DIV]( q, d, q )--+\n",
        ),
        "x  _",
        "d j n m s z i q",
        expect![[r#"
            d  20000
            j  -5536
            n  2
            m  8
            s  44
            z  7
            i  0
            q  20000
        "#]],
    );
}

#[test]
fn a_real_divided_by_zero_is_a_fault() {
    check(
        &logix(
            "VAR_INPUT go : BOOL; END_VAR\nVAR r, x, n : REAL; END_VAR\n+--[MOV]( x, 1.5 )--[CALC]( r, x / n )--( )( y )--+\n",
        ),
        "go  _",
        "r y",
        expect![[r#"
            r  0.0
            y  _
            scan 0 at 103: division by zero: nothing was written; check the divisor before this block
        "#]],
    );
}

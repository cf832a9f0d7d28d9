//! What generated programs do not have, to the prover and to the simulator: timers and counters of each profile, ranges whose
//! ends are computed, states that an index chooses.

use super::compile;
use super::followed::{Tally, compare, programs};

/// All of it is followed, but for so many values.
fn check(text: &str, most_open: usize) {
    assert!(compile(text).is_some(), "it has errors\n{text}");
    let mut tally = Tally::default();
    for seed in 0..programs().div_ceil(5) {
        if let Some(difference) = compare(text, seed, 80, &mut tally) {
            panic!("seed {seed}: {difference}");
        }
    }
    println!("{tally:?}");
    let is_right = tally.equal >= 1_000 && tally.open <= most_open && tally.blocked.is_empty();
    assert!(is_right, "{tally:?}");
}

#[test]
fn ldmicro() {
    check(
        "# ladder: profile ldmicro #
VAR_INPUT a, b, far, clear : BOOL; n : INT; END_VAR
VAR t1 : TON; t2 : TOF; t3 : RTO; c1 : CTU; c2 : CTD; c3 : CTC; y : INT; END_VAR
+--[ ]( a )--[TON]( t1, T#40ms )--( )( q1 )--+
+--[ ]( a )--[TOF]( t2, T#40ms )--( )( q2 )--+
+--[ ]( a )--[RTO]( t3, T#60ms )--( )( q3 )--+
+--[ ]( far )--[MOV]( c1.CV, 32767 )--[MOV]( t1.ET, n )--+
+--[ ]( a )--[CTU]( c1, 2 )--( )( q4 )--+
+--[ ]( b )--[CTD]( c2, -3 )--( )( q5 )--+
+--[ ]( a )--[CTC]( c3, 4 )--( )( q6 )--+
+--[ ]( b )--[CTU]( c2, 3 )--( )( q7 )--+
+--[ ]( clear )--(RES)( c1 )--+
+--[ ]( clear )--(RES)( t3 )--+
+--[LUT]( y, n, 5, 7, 9 )--[PWL]( y, n, 0, 0, 10, 25, 20, 5 )--+
",
        0,
    );
}

#[test]
fn a_division_by_zero_ends_a_program_of_ldmicro() {
    check(
        "# ladder: profile ldmicro #
VAR_INPUT a : BOOL; n : INT; END_VAR
VAR y, z : INT; END_VAR
+--[GT]( n, 30000 )--[SUB]( z, n, n )--+
+--[LE]( n, 30000 )--[MOV]( z, 7 )--+
+--[ ]( a )--[DIV]( y, n, z )--( )( q )--+
+--[ ]( q )--( )( r1 )--( )( r2 )--( )( r3 )--+
",
        0,
    );
}

#[test]
fn iot() {
    check(
        "# ladder: profile iot #
VAR_INPUT a, b, r : BOOL; n : INT; END_VAR
VAR t1 : TON; t2 : TOF; t3 : TON; c1 : CTU; c2 : CTD; list : ARRAY[1..3] OF TON; ups : ARRAY[1..3] OF CTU; k : INT := 2; END_VAR
+--[ ]( a )--[TON]( t1, T#60ms, B := T#20ms )--( )( q1 )--+
+--[ ]( a )--[TOF]( t2, 3, B := T#10ms )--( )( q2 )--+
+--[ ]( b )--[TON]( t3, n, B := T#25ms )--( )( q3 )--+
+--[ ]( a )--[CTU]( c1, 3 )--( )( q4 )--+
+--[ ]( b )--[CTD]( c2, 1, AC := 4 )--( )( q5 )--+
+--[ ]( r )--(RES)( t1 )--+
+--[ ]( r )--(RES)( c1 )--+
+--[ ]( r )--(RES)( c2 )--+
+--[GE]( n, 1 )--[LE]( n, 3 )--[MOV]( k, n )--+
+--[ ]( a )--[TON]( list[k], 3, B := T#10ms )--( )( q6 )--+
+--[ ]( a )--[CTU]( ups[k], 3 )--( )( q7 )--+
+--[ ]( r )--(RES)( list[k] )--+
",
        0,
    );
}

#[test]
fn click() {
    check(
        "# ladder: profile click #
VAR_INPUT a, b, r : BOOL; n : INT; END_VAR
VAR t1, t6 : TON; t2 : TOF; t3 : RTO; t4 : RTOF; t5 : TON; c1 : CTU; c2 : CTD; c3 : CTUD; y, z : INT; w : DINT; ups : ARRAY[1..3] OF CTU; k : INT := 2; END_VAR
+--[ ]( a )--[TON]( t1, 30 )--( )( q1 )--+
+--[ ]( a )--[TOF]( t2, T#20ms )--( )( q2 )--+
+--[ ]( a )--[RTO]( t3, 2, R := r, B := T#25ms )--( )( q3 )--+
+--[ ]( a )--[RTOF]( t4, 30, R := r )--( )( q4 )--+
+--[ ]( b )--[TON]( t6, n )--( )( q8 )--+
+--[ ]( a )--[CTU]( c1, 2, R := r )--( )( q5 )--+
+--[ ]( b )--[CTD]( c2, -2, R := r )--( )( q6 )--+
+--[ ]( a )--[CTUD]( c3, 2, CD := b, R := r )--( )( q7 )--+
+--[GE]( n, 1 )--[LE]( n, 3 )--[MOV]( k, n )--+
+--[ ]( a )--[CTU]( ups[k], 3, R := r )--( )( q9 )--+
+--[CALC]( y, n * 3 - 7 )--[CALC]( z, (n + 100) / 7 MOD 5 )--[MOV]( w, n )--+
",
        0,
    );
}

#[test]
fn relays_of_click() {
    check(
        "# ladder: profile click #
VAR_INPUT a, b, halt : BOOL; n : INT; END_VAR
VAR SC : ARRAY[1..50] OF BOOL; SD : ARRAY[1..20] OF INT; list : ARRAY[1..4] OF INT; y, z : INT; w : DINT; END_VAR
+--[ ]( a )--[CALC]( y, n / z )--( )( q1 )--+
+--[ ]( SC[40] )--( )( zero )--+
+--[ ]( SC[43] )--( )( range )--+
+--[ ]( b )--[MOV]( list[n], 3 )--( )( q2 )--+
+--[ ]( SC[44] )--( )( address )--+
+--[ ]( SC[3] )--( )( even )--+
+--[MUL]( w, n, n )--[SUB]( z, n, n )--+
+--[GT]( n, 20000 )--[ ]( halt )--(S)( SC[50] )--+
",
        0,
    );
}

#[test]
fn ranges_with_computed_ends() {
    check(
        "VAR_INPUT a, b, next : BOOL; i, j, n : INT; w : WORD; END_VAR
VAR flags, copies : ARRAY[1..9] OF BOOL; list, other : ARRAY[0..6] OF INT; bytes : ARRAY[0..3] OF BYTE; whole : WORD;
    sum, found, found2 : INT; end_at : INT := 3; END_VAR
+--[ ]( a )--(S)( flags[i..j] )--( )( q1 )--+
+--[ ]( b )--(R)( flags[i..9] )--( )( q2 )--+
+--[ ]( flags[2..i] )--( )( q3 )--+
+--[/]( flags[i..8] )--( )( q4 )--+
+--[ ]( a )--( )( copies[j..j] )--( )( q11 )--+
+--[ ]( a )--[FILL]( list[i..j], n )--( )( q5 )--+
+--[ ]( b )--[BMOV]( other[0..end_at], list[i..j] )--( )( q6 )--+
+--[ ]( b )--[BMOV]( list[j..6], list[0..i] )--( )( q7 )--+
+--[ ]( a )--[BMOV]( copies[1..i], flags[j..9] )--( )( q8 )--+
+--[CALC]( sum, SUM(list[i..j]) )--( )( q9 )--+
+--[ ]( a )--[PACK]( whole, flags[i..j] )--( )( q10 )--+
+--[ ]( b )--[UNPACK]( copies[i..j], w )--( )( q12 )--+
+--[UNPACK]( bytes[0..1], w )--[PACK]( whole, bytes[2..3] )--+
+--[SEARCH]( found, GT, n, list[i..j], NEXT := next, FOUND => q16 )--( )( q13 )--+
+--[ ]( a )--[SHIFT]( list[i..j], n )--[SHIFT]( copies[i..j], b )--( )( q15 )--+
+--[ ]( b )--[BMOV]( list[i], other[0..2] )--( )( q17 )--+
+--[SEARCH]( found2, EQ, n, other[0..6] )--( )( q14 )--+
",
        0,
    );
}

#[test]
fn states_that_an_index_chooses_and_loops_that_a_tag_counts() {
    check(
        "VAR_INPUT a, b, r : BOOL; i : INT; many : USINT; END_VAR
VAR ons : ARRAY[1..3] OF TON; offs : ARRAY[1..3] OF TOF; ups : ARRAY[1..3, 0..1] OF CTU; latches : ARRAY[1..3] OF SR;
    k : INT := 1; turn, sum : INT; turns : USINT; grid : ARRAY[1..3, 1..3] OF INT; END_VAR
+--[GE]( i, 1 )--[LE]( i, 4 )--[MOV]( k, i )--+
+--[ ]( a )--[TON]( ons[k], T#30ms, R := r )--( )( q1 )--+
+--[ ]( a )--[TOF]( offs[k], T#30ms )--( )( q2 )--+
+--[ ]( b )--[CTU]( ups[k, 1], 3 )--( )( q3 )--+
+--[ ]( r )--(RES)( ons[k] )--(RES)( ups[2, 1] )--+
+--[ ]( a )--[SR]( latches[k], R := b )--( )( q4 )--+
+--[ ]( ons[k].Q )--[ADD]( grid[k, k], grid[k, 1], 1 )--+
+--[MIN]( turns, many, 9 )--[MOV]( sum, 0 )--+
+--[ ]( a )--<FOR>( turns, I := turn )--+
+--[ADD]( sum, sum, turn )--[GT]( sum, 20 )--<JMP>( out )--+
+--<NEXT>--+
+--<LBL>( out )--[ ]( r )--( )( q5 )--+
",
        0,
    );
}

//! Structures, arrays of anything and enumerations.

use crate::support::check;
use expect_test::expect;

const TYPES: &str = "TYPE\n Phase : (IDLE, FILLING, MIXING := 10);\n Valve : STRUCT\n  open : BOOL; level : ARRAY[0..2] OF INT := [7, 8, 9];\n END_STRUCT;\n\
    Cell : STRUCT\n  valve : Valve; zone : ARRAY[1..2] OF Valve; t : ARRAY[1..2] OF TON; step : Phase := MIXING;\n END_STRUCT;\nEND_TYPE\n";

#[test]
fn members_and_computed_indices() {
    check(
        &format!(
            "{TYPES}VAR_INPUT k : INT; on : BOOL; END_VAR\nVAR cell : ARRAY[1..3] OF Cell := [1(), (valve := (open := TRUE))]; n, m : INT; seen : BOOL; END_VAR\n\
             +--[ ]( on )--( )( cell[k].zone[k - 1].open )--+\n\
             +--[MOV]( cell[k].zone[k - 1].level[k - 2], 40 )--+\n\
             +--[ ]( cell[2].valve.open )--( )( seen )--+\n\
             +--[CALC]( n, cell[2].zone[1].level[0] )--[CALC]( m, cell[3].zone[2].level[1] + SUM(cell[1].valve.level[0..2]) )--+\n"
        ),
        "k 2 3 4 1\non -_--",
        "n m seen cell[2].zone[1].open cell[3].zone[2].open",
        expect![[r#"
            n                     40 40 40 40
            m                     32 64 64 64
            seen                  ----
            cell[2].zone[1].open  ----
            cell[3].zone[2].open  ____
            scan 2 at 413: index 4 is outside the array [1..3]: nothing was written; limit the index before this block
            scan 2 at 451: index 4 is outside the array [1..3]: nothing was written; limit the index before this block
            scan 3 at 413: index 0 is outside the array [1..2]: nothing was written; limit the index before this block
            scan 3 at 451: index 0 is outside the array [1..2]: nothing was written; limit the index before this block
        "#]],
    );
}

#[test]
fn whole_structures() {
    check(
        &format!(
            "{TYPES}VAR_INPUT k : INT; END_VAR\nVAR a : Valve := (open := TRUE, level := [1]); v : ARRAY[1..3] OF Valve; b : Valve; END_VAR\n\
             +--[MOV]( v[k], a )--[MOV]( b, v[k - 1] )--+\n"
        ),
        "k 1 2 3 4",
        "v[1].level[0] v[2].open v[2].level[1] b.open b.level[0]",
        expect![[r#"
            v[1].level[0]  1 1 1 1
            v[2].open      _---
            v[2].level[1]  8 0 0 0
            b.open         _---
            b.level[0]     7 1 1 1
            scan 0 at 400: index 0 is outside the array [1..3]: nothing was written; limit the index before this block
            scan 3 at 382: index 4 is outside the array [1..3]: nothing was written; limit the index before this block
        "#]],
    );
}

#[test]
fn blocks_take_them() {
    check(
        &format!(
            "{TYPES}FUNCTION_BLOCK [$Copy]\nVAR_INPUT from : Valve; END_VAR\nVAR_OUTPUT to : Valve; END_VAR\nVAR_IN_OUT it : Cell; END_VAR\n\
             +--[MOV]( to, from )--[MOV]( to.level[1], it.zone[2].level[2] )--[MOV]( it.step, FILLING )--+\n\
             +--[TON]( it.t[2], T#20ms )--( )( it.valve.open )--+\nEND_FUNCTION_BLOCK\n\
             VAR cell : ARRAY[1..2] OF Cell; a, b : Valve; END_VAR\nVAR_INPUT n : INT; END_VAR\n\
             +--[MOV]( a.level[0], n )--[$Copy]( a, b, cell[2] )--+\n"
        ),
        "n 1 2 3 4",
        "b.level[0] b.level[1] cell[2].valve.open cell[2].t[2].Q cell[1].step cell[2].step",
        expect![[r#"
            b.level[0]          1 2 3 4
            b.level[1]          9 9 9 9
            cell[2].valve.open  __--
            cell[2].t[2].Q      __--
            cell[1].step        MIXING MIXING MIXING MIXING
            cell[2].step        FILLING FILLING FILLING FILLING
        "#]],
    );
}

#[test]
fn enumerations_by_name_and_number() {
    check(
        &format!(
            "{TYPES}VAR_INPUT n : INT; END_VAR\nVAR step : Phase := FILLING; s : STRING; m : INT; back : Phase; mixes : BOOL; END_VAR\n\
             +--[TYP]( step, n )--[TYP]( s, step )--[TYP]( m, step )--[TYP]( back, s )--+\n\
             +--[EQ]( step, MIXING )--( )( mixes )--+\n"
        ),
        "n 0 1 10 5",
        "step s m back mixes",
        expect![[r#"
            step   IDLE FILLING MIXING MIXING
            s      IDLE FILLING MIXING MIXING
            m      0 1 10 10
            back   IDLE FILLING MIXING MIXING
            mixes  __--
            scan 3 at 376: the value does not fit into the type of the result: nothing was written; limit it before this block or use a wider type
        "#]],
    );
}

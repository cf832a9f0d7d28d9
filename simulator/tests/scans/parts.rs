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

#[test]
fn named_instances() {
    check(
        "FUNCTION_BLOCK [$Motor]\nVAR_INPUT start, stop : BOOL; END_VAR\nVAR_OUTPUT running : BOOL; starts : INT := 10; END_VAR\nVAR t : TON; list : ARRAY[1..3] OF INT; END_VAR\n\
         +--\\--[ ]( start )----\\--[/]( stop )--( )( running )--[TON]( t, 20ms )--( )( ENO )--+\n   /--[ ]( running )--/\n\
         +--[P]( start )--[ADD]( starts, starts, 1 )--[ADD]( list[2], list[2], 2 )--+\nEND_FUNCTION_BLOCK\n\
         FUNCTION_BLOCK [$Pair]\nVAR_INPUT go : BOOL; END_VAR\nVAR a, b : $Motor; END_VAR\n\
         +--[$Motor]( a, go, SYS.OFF )--[$Motor]( b, a.running, SYS.OFF )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n\
         TYPE\n Cell : STRUCT\n  m : $Motor; x : INT;\n END_STRUCT;\nEND_TYPE\n\
         VAR m1 : $Motor; all : ARRAY[1..3] OF $Motor; cell : ARRAY[1..2] OF Cell; pair : $Pair; n : INT; p, q, r : BOOL; END_VAR\nVAR_INPUT a, b : BOOL; END_VAR\n\
         +--[$Motor]( m1, a, b )--( )( p )--+\n\
         +--[$Motor]( all[2], a, b, starts => n )--[$Motor]( cell[2].m, b, a )--( )( q )--+\n\
         +--[$Pair]( pair, a )--( )( r )--+\n",
        "a -_-_____\nb ____-___",
        "p q r m1.running m1.starts m1.list[2] m1.t.ET all[2].starts all[1].starts n cell[2].m.running pair.b.starts",
        expect![[r#"
            p                  __--____
            q                  ______--
            r                  __------
            m1.running         ----____
            m1.starts          11 11 12 12 12 12 12 12
            m1.list[2]         2 2 4 4 4 4 4 4
            m1.t.ET            0 10 20 20 0 0 0 0
            all[2].starts      11 11 12 12 12 12 12 12
            all[1].starts      10 10 10 10 10 10 10 10
            n                  11 11 12 12 12 12 12 12
            cell[2].m.running  ____----
            pair.b.starts      11 11 11 11 11 11 11 11
        "#]],
    );
}

/// What a call leaves out keeps what the tag holds: its default, what a call handed over, a member write, the body's own.
#[test]
fn inputs_that_are_left_out() {
    check(
        "FUNCTION_BLOCK [$Ramp]\nVAR_INPUT go : BOOL; step : INT := 2; most : INT; END_VAR\nVAR_OUTPUT n : INT; END_VAR\n\
         +--[ ]( go )--[ADD]( n, n, step )--[GT]( n, most )--[MOV]( n, 0 )--[ADD]( most, most, 10 )--+\nEND_FUNCTION_BLOCK\n\
         FUNCTION_BLOCK [$Pair]\nVAR_INPUT go : BOOL; END_VAR\nVAR r : $Ramp; END_VAR\n\
         +--[MOV]( r.most, 20 )--[$Ramp]( r, go )--+\nEND_FUNCTION_BLOCK\n\
         VAR a : $Ramp; all : ARRAY[0..1] OF $Ramp; p : $Pair; x, y, z : INT; END_VAR\nVAR_INPUT go, faster : BOOL; k : INT; END_VAR\n\
         +--[ ]( faster )--[MOV]( a.step, 5 )--+\n\
         +--[$Ramp]( a, go, n => x )--+\n\
         +--( )( all[k].go )--[$Ramp]( all[0], most := 5, n => y )--[$Ramp]( all[1] )--+\n\
         +--[$Pair]( p, go )--[MOV]( z, p.go )--[$Ramp]( go, 1, 50 )--+\n"
            .replace("[MOV]( z, p.go )", "[TYP]( z, p.go )")
            .as_str(),
        "go ------\nfaster __-___\nk 1 1 0 0 0 0",
        "x a.most a.step y all[1].n all[1].most z p.r.n",
        expect![[r#"
            x            0 2 7 0 5 10
            a.most       10 10 10 20 20 20
            a.step       2 2 5 5 5 5
            y            0 0 2 4 0 2
            all[1].n     0 2 4 6 8 10
            all[1].most  10 10 10 10 10 10
            z            1 1 1 1 1 1
            p.r.n        2 4 6 8 10 12
        "#]],
    );
}

#[test]
fn a_warm_restart_keeps_parts_by_their_path() {
    use crate::support::simulation;
    let mut running = simulation(
        "TYPE\n P : (IDLE, RUN);\n M : STRUCT\n  n : INT; p : P; on : BOOL;\n END_STRUCT;\nEND_TYPE\n\
         VAR RETAIN m : ARRAY[1..2] OF M; END_VAR\nVAR o : M; END_VAR\n\
         +--[ADD]( m[2].n, m[2].n, 1 )--[ADD]( o.n, o.n, 1 )--[MOV]( m[1].p, RUN )--+\n",
    );
    for _ in 0..3 {
        running.scan();
    }
    let kept = running.retained();
    let kept = kept
        .iter()
        .map(|kept| format!("{} : {} = {}\n", kept.name, kept.ty, kept.values.join(" ")));
    expect![[r#"
        m[].n : ARRAY[1..2] OF INT = 0 3
        m[].p : ARRAY[1..2] OF P = RUN IDLE
        m[].on : ARRAY[1..2] OF BOOL = FALSE FALSE
    "#]]
    .assert_eq(&kept.collect::<String>());
}

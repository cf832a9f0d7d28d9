//! The profile `click`: timers, counters, numbers, and what the controller reports of itself.

use crate::support::{check, get, simulation};
use expect_test::expect;
use ladder_simulator::{Options, Simulation, Status};
use std::sync::Arc;

fn click(text: &str) -> String {
    format!("# ladder: profile click #\n{text}")
}

#[test]
fn the_first_scan_of_a_timer_counts_and_it_runs_on() {
    check(
        &click(
            "VAR_INPUT en : BOOL; END_VAR\nVAR on : TON; off : TOF; END_VAR\n\
             +--[ ]( en )--[TON]( on, 30 )--( )( y )--+\n\
             +--[ ]( en )--[TOF]( off, T#20ms )--( )( z )--+\n",
        ),
        "en   _-----__-____-_",
        "on.Q on.ET y off.Q off.ET z",
        expect![[r#"
            on.Q    ___---_________
            on.ET   0 10 20 30 40 50 0 0 10 0 0 0 0 10 0
            y       ___---_________
            off.Q   _------_--___--
            off.ET  0 0 0 0 0 0 10 20 0 10 20 30 40 0 10
            z       _------_--___--
        "#]],
    );
}

#[test]
fn a_longer_preset_takes_back_what_was_reached() {
    check(
        &click(
            "VAR_INPUT en, longer : BOOL; END_VAR\nVAR on : TON; off : TOF; wait : INT := 20; END_VAR\n\
             +--[ ]( longer )--[ADD]( wait, wait, 30 )--+\n\
             +--[ ]( en )--[TON]( on, wait )--( )( y )--+\n\
             +--[ ]( en )--[TOF]( off, wait )--( )( z )--+\n",
        ),
        "en     ------_________\nlonger ____-______-___",
        "y z on.ET off.ET",
        expect![[r#"
            y       _-----_________
            z       ----------_--__
            on.ET   10 20 30 40 50 60 0 0 0 0 0 0 0 0 0
            off.ET  0 0 0 0 0 0 10 20 30 40 50 60 70 80 90
        "#]],
    );
}

#[test]
fn retentive_timers_keep_what_is_less_than_a_unit() {
    check(
        &click(
            "VAR_INPUT en, r : BOOL; END_VAR\nVAR t : RTO; o : RTOF; END_VAR\n\
             +--[ ]( en )--[RTO]( t, 2, R := r, B := T#25ms )--( )( y )--+\n\
             +--[ ]( en )--[RTOF]( o, 30, R := r )--( )( z )--+\n",
        ),
        "en _--__---__-____--\nr  ___________-_____",
        "t.ET y o.ET z",
        expect![[r#"
            t.ET  0 0 0 0 0 1 1 2 2 2 2 0 0 0 0 0 0
            y     _______----______
            o.ET  0 0 0 10 20 20 20 20 30 40 40 0 0 0 0 0 0
            z     _-------__-____--
        "#]],
    );
}

#[test]
fn a_timer_can_be_written_and_stops_at_its_limit() {
    check(
        &click(
            "VAR_INPUT en, far : BOOL; END_VAR\nVAR t : TON; END_VAR\n\
             +--[ ]( far )--[MOV]( t.ACC, 32755 )--+\n\
             +--[ ]( en )--[TON]( t, 20, B := T#1ms )--( )( y )--+\n",
        ),
        "en  -------\nfar ___-___",
        "t.ACC y",
        expect![[r#"
            t.ACC  10 20 30 32765 32767 32767 32767
            y      _------
        "#]],
    );
}

#[test]
fn counters_compare() {
    check(
        &click(
            "VAR_INPUT go, back, r, put : BOOL; END_VAR\nVAR up : CTU; down : CTD; both : CTUD; END_VAR\n\
             +--[ ]( put )--[MOV]( down.ACC, 5 )--+\n\
             +--[ ]( go )--[CTU]( up, 2, R := r )--+\n\
             +--[ ]( go )--[CTD]( down, 3, R := r )--+\n\
             +--[ ]( go )--[CTUD]( both, 2, CD := back, R := r )--+\n",
        ),
        "go   _-_-_-_-___\nback _______-__-\nr    ________-__\nput  -__________",
        "up.ACC up.DN down.ACC down.DN both.ACC both.DN",
        expect![[r#"
            up.ACC    0 1 1 2 2 3 3 4 0 0 0
            up.DN     ___-----___
            down.ACC  5 4 4 3 3 2 2 1 0 0 0
            down.DN   ___-----_--
            both.ACC  0 1 1 2 2 3 3 3 0 0 -1
            both.DN   ___-----___
        "#]],
    );
}

#[test]
fn a_timer_that_cannot_count_so_far_is_refused() {
    let text = click("VAR t : TON; END_VAR\n+--[TON]( t, T#1m )--( )( y )--+\n");
    let analysis = ladder_analysis::analyze(&Arc::new(ladder_syntax::parse(&text)), "test.clad");
    let program = analysis.program().expect("it is a warning");
    let error = Simulation::new(Arc::clone(program), Options::default()).expect_err("it is too long");
    expect!["the preset is 60000 units of the timer, which counts to 32767; count in a longer unit, as in: B := T#1s"].assert_eq(&error.message);
}

/// What the numbers are after one scan.
fn after(declarations: &str, network: &str, shown: &[&str]) -> String {
    let text = click(&format!(
        "VAR_INPUT SC : ARRAY[1..50] OF BOOL; END_VAR\nVAR {declarations} END_VAR\n{network}\n"
    ));
    let mut simulation = simulation(&text);
    simulation.scan();
    let mut out: Vec<String> = shown
        .iter()
        .map(|name| format!("{name}={}", get(&simulation, name)))
        .collect();
    for relay in [40, 43, 44, 46] {
        if get(&simulation, &format!("SC[{relay}]")) == "1" {
            out.push(format!("SC{relay}"));
        }
    }
    out.extend(simulation.take_faults().into_iter().map(|fault| fault.message));
    out.join(" ")
}

#[test]
fn formulas() {
    let all: Vec<String> = [
        ("y, a : INT := 32767;", "a + 1"),
        ("y : INT; a : INT := 1000;", "a * a"),
        ("y : INT; a : INT := 200;", "a * a + 30000"),
        ("y : INT; a : INT := 200;", "a * a / 2"),
        ("y : DINT; a : INT := 32767;", "a * 2"),
        ("y : INT; a : INT := -7;", "a / 2"),
        ("y : INT; a : INT := -7;", "a MOD 2"),
        ("y : INT; a : INT := 7;", "a MOD -2"),
        ("y : INT := 9; a : INT;", "5 + 100 / a"),
        ("y : REAL := 9.0; a : REAL;", "100 / a"),
        ("y : REAL; a : INT := -7;", "a / 2"),
        ("y : INT; a : REAL := 2.75;", "a * 2"),
        ("y : INT; a : REAL := 40000.0;", "a"),
        ("y : INT; a : DINT := 100000;", "a / 10"),
        ("y : INT; a : DINT := 100000;", "a"),
        ("y : REAL; a : DINT := 16777217;", "a * 0.5"),
        ("y : WORD; a : WORD := 16#FFFF;", "a + 16#2"),
        ("y : WORD; a : WORD := 16#00F0;", "a AND 16#FFC0 OR 16#8000"),
        ("y : INT; a : WORD := 16#FFFF;", "a"),
        ("y : DINT; a : DINT := 2147483647;", "a + 1"),
        ("y : INT; a : INT := 2;", "a ^ 10"),
        ("y : INT; a : INT := 2;", "a ^ 15"),
        ("y : INT; a : INT := 2;", "a ^ -1"),
        ("y : REAL := 9.0; a : REAL := -1.0;", "SQRT(a)"),
        ("y : INT; a : INT := -32768;", "-a"),
        (
            "y : INT; a : INT; b : ARRAY[1..2] OF INT := [30000, 30000];",
            "SUM(b[1..2])",
        ),
        ("y : REAL := 9.0; a : REAL := 1.0e30;", "a * a"),
    ]
    .into_iter()
    .map(|(declarations, formula)| {
        let network = format!("+--[CALC]( y, {formula} )--+");
        format!(
            "{declarations} {formula}: {}",
            after(declarations, &network, &["y"])
        )
    })
    .collect();
    expect![[r#"
        y, a : INT := 32767; a + 1: y=-32768 SC43
        y : INT; a : INT := 1000; a * a: y=16960 SC43
        y : INT; a : INT := 200; a * a + 30000: y=4464 SC43
        y : INT; a : INT := 200; a * a / 2: y=-12768 SC43
        y : DINT; a : INT := 32767; a * 2: y=65534
        y : INT; a : INT := -7; a / 2: y=-3
        y : INT; a : INT := -7; a MOD 2: y=1
        y : INT; a : INT := 7; a MOD -2: y=-1
        y : INT := 9; a : INT; 5 + 100 / a: y=0 SC40
        y : REAL := 9.0; a : REAL; 100 / a: y=0.0 SC40
        y : REAL; a : INT := -7; a / 2: y=-3.5
        y : INT; a : REAL := 2.75; a * 2: y=5
        y : INT; a : REAL := 40000.0; a: y=-25536 SC43
        y : INT; a : DINT := 100000; a / 10: y=10000
        y : INT; a : DINT := 100000; a: y=-31072 SC43
        y : REAL; a : DINT := 16777217; a * 0.5: y=8388608.0
        y : WORD; a : WORD := 16#FFFF; a + 16#2: y=1 SC43
        y : WORD; a : WORD := 16#00F0; a AND 16#FFC0 OR 16#8000: y=32960
        y : INT; a : WORD := 16#FFFF; a: y=-1 SC43
        y : DINT; a : DINT := 2147483647; a + 1: y=-2147483648 SC43
        y : INT; a : INT := 2; a ^ 10: y=1024
        y : INT; a : INT := 2; a ^ 15: y=-32768 SC43
        y : INT; a : INT := 2; a ^ -1: y=0
        y : REAL := 9.0; a : REAL := -1.0; SQRT(a): y=9.0 SC46 the function has no result for -1.0: nothing was written; limit the value before this block
        y : INT; a : INT := -32768; -a: y=-32768 SC43
        y : INT; a : INT; b : ARRAY[1..2] OF INT := [30000, 30000]; SUM(b[1..2]): y=-5536 SC43
        y : REAL := 9.0; a : REAL := 1.0e30; a * a: y=0.0 SC43"#]].assert_eq(&all.join("\n"));
}

#[test]
fn copies() {
    let all: Vec<String> = [
        ("y : INT; a : DINT := 1000000;", "[TYP]( y, a )"),
        ("y : INT; a : DINT := -1000000;", "[TYP]( y, a )"),
        ("y : DINT; a : INT := -1;", "[MOV]( y, a )"),
        ("y : WORD; a : INT := -1;", "[MOV]( y, a )"),
        ("y : REAL; a : INT := -1;", "[MOV]( y, a )"),
        ("y : DINT; a : WORD := 16#FFFF;", "[TYP]( y, a )"),
        ("y : WORD; a : DINT := 70000;", "[TYP]( y, a )"),
        ("y : INT; a : REAL := -2.75;", "[TYP]( y, a )"),
        ("y : INT; a : REAL := 1.0e9;", "[TYP]( y, a )"),
        ("y : DINT; a : REAL := 1.0e30;", "[TYP]( y, a )"),
        (
            "y : INT := 9; a : INT := 3; b : ARRAY[1..2] OF INT;",
            "[MOV]( y, b[a] )",
        ),
        (
            "y : INT := 9; a : INT := 3; b : ARRAY[1..2] OF INT;",
            "[MOV]( b[a], y )",
        ),
        ("y : INT := 9; a : STRING[5] := 'x1';", "[PACK]( y, a )"),
    ]
    .into_iter()
    .map(|(declarations, block)| {
        let network = format!("+--{block}--+");
        format!(
            "{declarations} {block}: {}",
            after(declarations, &network, &["y"])
        )
    })
    .collect();
    expect![[r#"
        y : INT; a : DINT := 1000000; [TYP]( y, a ): y=32767 SC43
        y : INT; a : DINT := -1000000; [TYP]( y, a ): y=-32768 SC43
        y : DINT; a : INT := -1; [MOV]( y, a ): y=-1
        y : WORD; a : INT := -1; [MOV]( y, a ): y=65535
        y : REAL; a : INT := -1; [MOV]( y, a ): y=-1.0
        y : DINT; a : WORD := 16#FFFF; [TYP]( y, a ): y=65535
        y : WORD; a : DINT := 70000; [TYP]( y, a ): y=4464 SC43
        y : INT; a : REAL := -2.75; [TYP]( y, a ): y=-2
        y : INT; a : REAL := 1.0e9; [TYP]( y, a ): y=32767 SC43
        y : DINT; a : REAL := 1.0e30; [TYP]( y, a ): y=2147483647 SC43
        y : INT := 9; a : INT := 3; b : ARRAY[1..2] OF INT; [MOV]( y, b[a] ): y=9 SC44
        y : INT := 9; a : INT := 3; b : ARRAY[1..2] OF INT; [MOV]( b[a], y ): y=9 SC44
        y : INT := 9; a : STRING[5] := 'x1'; [PACK]( y, a ): y=9 SC43"#]]
    .assert_eq(&all.join("\n"));
}

#[test]
fn the_controller_tells_of_itself() {
    let text = click(
        "VAR_INPUT SC : ARRAY[1..50] OF BOOL; SD : ARRAY[9..12] OF INT; go : BOOL; END_VAR\n\
         VAR y, z : INT; END_VAR\n\
         +--[ ]( go )--[CALC]( y, 1 / z )--+\n\
         +--[ ]( SC[40] )--( )( wrong )--+\n",
    );
    check(
        &text,
        "go __-__",
        "SC[1] SC[2] SC[3] SC[4] SC[11] SC[40] wrong SD[9] SD[10]",
        expect![[r#"
            SC[1]   -----
            SC[2]   -____
            SC[3]   _-_-_
            SC[4]   _____
            SC[11]  -----
            SC[40]  __-__
            wrong   __-__
            SD[9]   1 2 3 4 5
            SD[10]  10 10 10 10 10
        "#]],
    );
}

#[test]
fn outside_its_domain_a_function_stops_the_controller() {
    let mut simulation = simulation(&click(
        "VAR_INPUT SC : ARRAY[40..46] OF BOOL; END_VAR\nVAR y : REAL := 9.0; x : REAL := -1.0; after : INT; END_VAR\n\
         +--[CALC]( y, SQRT(x) )--+\n+--[MOV]( after, 1 )--+\n",
    ));
    assert!(simulation.scan());
    assert_eq!(get(&simulation, "SC[46]"), "1");
    assert_eq!(get(&simulation, "after"), "1");
    assert_eq!(simulation.status(), Status::Ended);
    assert!(!simulation.scan());
}

#[test]
fn a_program_can_stop_the_controller() {
    let mut simulation = simulation(&click(
        "VAR_INPUT halt : BOOL; END_VAR\nVAR SC : ARRAY[50..50] OF BOOL; END_VAR\n+--[ ]( halt )--(S)( SC[50] )--+\n",
    ));
    assert!(simulation.scan());
    let halt = simulation.resolve("halt").expect("it is there");
    simulation
        .set(&halt, ladder_analysis::values::value::Value::Bool(true))
        .expect("it is a BOOL");
    assert!(simulation.scan());
    assert_eq!(simulation.status(), Status::Ended);
}

#[test]
fn a_forced_relay_stays_as_it_is_forced() {
    let mut simulation = simulation(&click(
        "VAR_INPUT SC : ARRAY[40..46] OF BOOL; END_VAR\nVAR y, z : INT; END_VAR\n+--[CALC]( y, 1 / z )--+\n",
    ));
    let relay = simulation.resolve("SC[40]").expect("it is there");
    simulation
        .force(&relay, ladder_analysis::values::value::Value::Bool(false))
        .expect("it can be forced");
    simulation.scan();
    assert_eq!(get(&simulation, "SC[40]"), "0");
}

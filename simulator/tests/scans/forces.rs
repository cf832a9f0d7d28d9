//! Forces, inputs and restarts.

use crate::support::{force, get, set, simulation, unforce};
use expect_test::expect;
use ladder_simulator::value_text::parse;

const MOTOR: &str = "VAR_INPUT start, stop : BOOL; END_VAR\nVAR_OUTPUT run : BOOL; END_VAR\n\
                     VAR n : INT; RETAINED : BOOL; END_VAR\nVAR RETAIN total : DINT; t : RTO; c : CTU; END_VAR\n\
                     +--\\--[ ]( start )--\\--[/]( stop )--( )( run )--+\n\
                     |  /--[ ]( run )----/\n\
                     +--[ ]( run )--[ADD]( n, n, 1 )--[ADD]( total, total, 1 )--[RTO]( t, T#1h )--+\n\
                     +--[ ]( run )--[CTU]( c, 5 )--+\n";

#[test]
fn a_forced_output_reads_as_forced_everywhere() {
    let mut simulation = simulation(MOTOR);
    force(&mut simulation, "run", "1");
    assert_eq!(get(&simulation, "run"), "1");
    simulation.scan();
    assert_eq!(
        (get(&simulation, "run"), get(&simulation, "n")),
        ("1".into(), "1".into())
    );
    // What is not an input keeps the forced value until it is written: here it seals itself in.
    unforce(&mut simulation, "run");
    assert_eq!(get(&simulation, "run"), "1");
    simulation.scan();
    assert_eq!(get(&simulation, "run"), "1");
    set(&mut simulation, "stop", "1");
    simulation.scan();
    assert_eq!(get(&simulation, "run"), "0");
    force(&mut simulation, "run", "0");
    set(&mut simulation, "stop", "0");
    set(&mut simulation, "start", "1");
    simulation.scan();
    assert_eq!(get(&simulation, "run"), "0");
}

#[test]
fn inputs_go_on_arriving_under_a_force() {
    let mut simulation = simulation(MOTOR);
    force(&mut simulation, "stop", "1");
    set(&mut simulation, "start", "1");
    set(&mut simulation, "stop", "0");
    simulation.scan();
    assert_eq!(
        (get(&simulation, "stop"), get(&simulation, "run")),
        ("1".into(), "0".into())
    );
    unforce(&mut simulation, "stop");
    assert_eq!(get(&simulation, "stop"), "0");
    simulation.scan();
    assert_eq!(get(&simulation, "run"), "1");
}

#[test]
fn a_force_replaces_another() {
    let mut simulation = simulation(MOTOR);
    set(&mut simulation, "start", "1");
    force(&mut simulation, "start", "0");
    force(&mut simulation, "START", "1");
    force(&mut simulation, "start", "0");
    let start = simulation.resolve("start").unwrap();
    assert!(simulation.is_forced(&start));
    assert_eq!(simulation.forced().count(), 1);
    simulation.unforce_all();
    assert_eq!(get(&simulation, "start"), "1");
    assert!(!simulation.is_forced(&start));
}

#[test]
fn elements_and_texts() {
    let mut simulation = simulation(
        "VAR_INPUT a : BOOL; i : INT := 1; END_VAR\n\
         VAR w : INT; b : ARRAY[1..3] OF INT; s : STRING; f : ARRAY[0..1] OF BOOL; END_VAR\n\
         +--[MOV]( w, 0 )--[MOV]( b[i], 7 )--[MOV]( b[2], 8 )--[MOV]( s, 'text' )--( )( f[0..1] )--( )( w.1 )--+\n",
    );
    for (tag, value) in [("w", "5"), ("b[1]", "5"), ("s", "held"), ("f[1]", "0")] {
        force(&mut simulation, tag, value);
    }
    simulation.scan();
    let values: Vec<String> = ["w", "b[1]", "b[2]", "s", "f[0]", "f[1]"]
        .iter()
        .map(|tag| get(&simulation, tag))
        .collect();
    assert_eq!(values, ["5", "5", "8", "held", "1", "0"]);
    unforce(&mut simulation, "w");
    simulation.scan();
    assert_eq!(get(&simulation, "w"), "2");
}

#[test]
fn bits_and_members_of_timers_and_blocks_are_not_forced() {
    let mut simulation = simulation(
        "TYPE S : STRUCT\nw : WORD;\nt : TON;\nEND_STRUCT; END_TYPE\n\
         FUNCTION_BLOCK [$M]\nVAR_INPUT x : BOOL; END_VAR\nVAR n : INT; END_VAR\n+--[ ]( x )--[ADD]( n, n, 1 )--+\nEND_FUNCTION_BLOCK\n\
         VAR s : ARRAY[1..2] OF S; m : $M; c : CTU; a : BOOL; END_VAR\n\
         +--[ ]( s[1].w.3 )--[TON]( s[2].t, 1s )--[CTU]( c, 3 )--[$M]( m, a )--[$M]( a )--( )( a )--+\n",
    );
    let mut refused = String::new();
    for tag in ["s[1].w.3", "s[2].t.ET", "c.CV", "m.x", "m.n", "$M#1.n"] {
        let point = simulation.resolve(tag).unwrap();
        let value = parse("1", point.ty).unwrap();
        let error = simulation.force(&point, value.clone()).unwrap_err();
        refused.push_str(&format!("{}\n", error.message));
        // But they can be set.
        simulation.set(&point, value).unwrap();
    }
    assert_eq!(simulation.forced().count(), 0);
    expect![[r#"
        s[1].w.3 is a bit, which cannot be forced: force s[1].w as a whole
        s[2].t.ET is a member of a TON, which cannot be forced: force what the block of s[2].t reads
        c.CV is a member of a CTU, which cannot be forced: force what the block of c reads
        m.x is inside of the state of a block, which cannot be forced: force what the block is given
        m.n is inside of the state of a block, which cannot be forced: force what the block is given
        $M#1.n is inside of the state of a block, which cannot be forced: force what the block is given
    "#]]
    .assert_eq(&refused);
}

#[test]
fn what_cannot_be_given_a_value() {
    let mut simulation = simulation(
        "VAR CONSTANT k : INT := 3; END_VAR\nVAR x : SINT; t : TON; END_VAR\n+--[MOV]( x, 3 )--[TON]( t, 1s )--+\n",
    );
    let mut refused = |tag: &str, value: &str| {
        let point = simulation.resolve(tag).unwrap();
        let value = parse(value, point.ty).unwrap();
        simulation.set(&point, value).unwrap_err().message
    };
    expect![[r#"
        k is read-only: it cannot be given a value
        SYS.SCAN is read-only: it cannot be given a value
        t.TT is read-only: it cannot be given a value
    "#]]
    .assert_eq(&format!(
        "{}\n{}\n{}\n",
        refused("k", "4"),
        refused("sys.scan", "4"),
        refused("t.TT", "1"),
    ));
    let point = simulation.resolve("x").unwrap();
    let wide = ladder_analysis::values::value::Value::Int(300);
    expect!["x is a SINT and cannot hold this value"]
        .assert_eq(&simulation.set(&point, wide).unwrap_err().message);
}

#[test]
fn unknown_names() {
    let simulation = simulation(
        "VAR run : BOOL; a : ARRAY[1..3] OF INT; t : TON; w : WORD; r : REAL; END_VAR\n\
         +--[ ]( run )--[TON]( t, 1s )--[MOV]( a[1], 1 )--[MOV]( w, 1 )--[MOV]( r, 1 )--+\n",
    );
    let names = [
        "runn", "zebra", "a", "a[4]", "a[x]", "t", "t.XX", "w.16", "w.x", "r.1", "run.1", "run[1]",
        "SYS.NOW", "", "b[1]", "b.Q",
    ];
    let all: Vec<String> = names
        .iter()
        .map(|name| format!("{name}: {}\n", simulation.resolve(name).unwrap_err().message))
        .collect();
    expect![[r#"
        runn: there is no tag `runn`; did you mean run?
        zebra: there is no tag `zebra` in this program
        a: a is an array: name one of its elements, as in a[1]
        a[4]: a[4] does not exist: the array goes from 1 to 3
        a[x]: `x` is not an index: write a number, as in a[1]
        t: t is a TON: name one of its members, as in t.Q
        t.XX: t has no member `XX`: a TON has Q ET IN PT
        w.16: w has no bit `16`: the bits of a WORD are 0 to 15
        w.x: w has no bit `x`: the bits of a WORD are 0 to 15
        r.1: r is a REAL and has no members
        run.1: run is a BOOL and has no members
        run[1]: run is not an array: it is a BOOL and has no elements
        SYS.NOW: there is no SYS.NOW: the system tags are SYS.FIRST_SCAN SYS.SCAN SYS.TIME SYS.SCAN_TIME SYS.FAULT SYS.ON SYS.OFF SYS.CLOCK_10MS SYS.CLOCK_100MS SYS.CLOCK_500MS SYS.CLOCK_1S SYS.CLOCK_1M SYS.CLOCK_1H
        : there is no tag `` in this program
        b[1]: there is no tag `b` in this program
        b.Q: there is no tag `b` in this program
    "#]].assert_eq(&all.concat());
}

#[test]
fn restarts() {
    let mut simulation = simulation(MOTOR);
    set(&mut simulation, "start", "1");
    for _ in 0..5 {
        simulation.scan();
    }
    let look = |simulation: &ladder_simulator::Simulation| {
        let tags = ["start", "run", "n", "total", "t.ET", "c.CV", "SYS.SCAN"];
        let values: Vec<String> = tags
            .iter()
            .map(|tag| format!("{tag} {}", get(simulation, tag)))
            .collect();
        format!("{}\n", values.join(" "))
    };
    let mut log = look(&simulation);
    simulation.warm_restart();
    log.push_str(&look(&simulation));
    set(&mut simulation, "start", "1");
    simulation.scan();
    simulation.scan();
    log.push_str(&look(&simulation));
    simulation.reset();
    log.push_str(&look(&simulation));
    force(&mut simulation, "start", "1");
    simulation.reset();
    simulation.scan();
    log.push_str(&look(&simulation));
    expect![[r#"
        start 1 run 1 n 5 total 5 t.ET 40 c.CV 1 SYS.SCAN 4
        start 0 run 0 n 0 total 5 t.ET 40 c.CV 1 SYS.SCAN 0
        start 1 run 1 n 2 total 7 t.ET 60 c.CV 1 SYS.SCAN 1
        start 0 run 0 n 0 total 0 t.ET 0 c.CV 0 SYS.SCAN 0
        start 1 run 1 n 1 total 1 t.ET 0 c.CV 1 SYS.SCAN 0
    "#]]
    .assert_eq(&log);
}

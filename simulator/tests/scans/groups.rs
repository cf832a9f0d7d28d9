//! Tags that open: arrays and timers in lists.

use crate::support::simulation;
use expect_test::{Expect, expect};
use ladder_analysis::program::TagId;
use ladder_simulator::{Entry, Point};

const PUMPS: &str = "\
VAR_INPUT trip : ARRAY[1..2] OF BOOL; END_VAR
VAR_OUTPUT pump : ARRAY[0..2] OF BOOL; END_VAR
VAR t : TON; n : INT; recipe : ARRAY[-1..400] OF INT; words : ARRAY[1..2] OF STRING[5]; END_VAR
+--[ ]( trip[1] )--[TON]( t, T#1s )--( )( pump[1] )--+
";

fn names(points: &[Point]) -> String {
    points
        .iter()
        .map(|point| point.name.as_str())
        .collect::<Vec<_>>()
        .join(" ")
}

fn shown(entries: &[Entry]) -> String {
    let lines = entries.iter().map(|entry| match entry {
        Entry::Value(point) => format!("{} : {}\n", point.name, point.ty),
        Entry::Group(group) => format!("{} : {}, {} parts\n", group.name, group.ty, group.parts),
    });
    lines.collect()
}

#[test]
fn a_list_of_all_tags_has_the_elements_unless_they_are_very_many() {
    let simulation = simulation(PUMPS);
    expect!["trip[1] trip[2] pump[0] pump[1] pump[2] t.Q t.ET n words[1] words[2]"]
        .assert_eq(&names(simulation.points()));
    expect![[r#"
        trip : ARRAY[1..2] OF BOOL, 2 parts
        pump : ARRAY[0..2] OF BOOL, 3 parts
        t : TON, 2 parts
        n : INT
        recipe : ARRAY[-1..400] OF INT, 402 parts
        words : ARRAY[1..2] OF STRING[5], 2 parts
    "#]]
    .assert_eq(&shown(&simulation.entries("")));
}

#[test]
fn a_name_may_stand_for_many() {
    let simulation = simulation(PUMPS);
    let all = |text: &str, expected: Expect| {
        let shown = match simulation.resolve_all(text) {
            Ok(points) => names(&points),
            Err(unknown) => unknown.message,
        };
        expected.assert_eq(&shown);
    };
    all("Pump", expect!["pump[0] pump[1] pump[2]"]);
    all("pump[1]", expect!["pump[1]"]);
    all("pump[ 1 .. 2 ]", expect!["pump[1] pump[2]"]);
    all("recipe[-1..1]", expect!["recipe[-1] recipe[0] recipe[1]"]);
    all("t", expect!["t.Q t.ET"]);
    all("n", expect!["n"]);
    all(
        "pump[2..1]",
        expect!["pump[2..1] has no elements: write the smaller index first"],
    );
    all(
        "pump[1..3]",
        expect!["pump[3] does not exist: the array goes from 0 to 2"],
    );
    all(
        "n[1..3]",
        expect!["n is not an array: it is an INT and has no elements"],
    );
    all("pmp", expect!["there is no tag `pmp`; did you mean pump?"]);
    all(
        "pump[1..x]",
        expect!["`1..x` is not an index: write a number, as in pump[0]"],
    );
    assert_eq!(simulation.resolve_all("recipe").unwrap().len(), 402);
}

#[test]
fn elements_are_found_by_a_part_of_their_name() {
    let simulation = simulation(PUMPS);
    let found = |text: &str, expected: Expect| expected.assert_eq(&names(&simulation.search(text)));
    found("UMP", expect!["pump[0] pump[1] pump[2]"]);
    found("p[2", expect!["trip[2] pump[2]"]);
    found("recipe", expect![[""]]);
    found("cipe[40", expect!["recipe[40] recipe[400]"]);
    assert_eq!(
        simulation.resolve("pump[1].x").unwrap_err().message,
        "pump[1] is a BOOL and has no members"
    );
    assert!(simulation.resolve("pump[1]").unwrap().is_in("Pump"));
    assert!(!simulation.resolve("n.3").unwrap().is_in("n.30"));
}

const LINES: &str = r"
TYPE
    Phase  : (IDLE, FILLING, MIXING := 10, EMPTYING);
    Recipe : ARRAY[1..3] OF REAL;
    Motor  : STRUCT
        speed, limit : REAL := 50.0;
        running      : BOOL;
        delay        : TON;
    END_STRUCT;
END_TYPE

VAR
    pump  : Motor := (speed := 20.0);
    lines : ARRAY[1..4] OF Motor;
    step  : Phase := FILLING;
    mix   : Recipe := [1.5, 2.0, 6.0];
    go, stop : BOOL;
    k     : INT := 2;
    m1    : $Motor;
    c     : CTU;
    grid  : ARRAY[1..2, 0..1] OF INT;
    timers : ARRAY[1..2] OF TON;
    ms    : ARRAY[1..2] OF $Motor;
    big   : ARRAY[1..10000] OF INT; many : ARRAY[1..100] OF TON;
END_VAR

FUNCTION_BLOCK [$Inner]
VAR_INPUT a : BOOL; END_VAR
VAR n : INT; t : TON; hist : ARRAY[1..2] OF INT; END_VAR
+--[ ]( a )--[TON]( t, T#50ms )--[ADD]( n, n, 1 )--( )( ENO )--+
END_FUNCTION_BLOCK

FUNCTION_BLOCK [$Motor]
VAR_INPUT  start, halt : BOOL; END_VAR
VAR_OUTPUT running : BOOL; END_VAR
VAR inner : $Inner; seal : BOOL; END_VAR
+--[ ]( start )--\--[/]( halt )--[$Inner]( inner, start )--( )( running )--+
+--[ ]( running )--/
END_FUNCTION_BLOCK

+--[EQ]( step, FILLING )--[ ]( go )--[TON]( lines[2].delay, T#5s )--[MOV]( step, MIXING )--+
+--[ ]( go )--[$Motor]( m1, go, stop )--[CTU]( c, 5 )--( )( pump.running )--+
+--[ ]( go )--[$Motor]( ms[1], go, stop )--+
+--[ ]( go )--[TON]( timers[2], T#1s )--[MOV]( grid[2, 1], k )--[MOV]( big[3], k )--+
";

#[test]
fn what_is_compound_is_a_tree() {
    let simulation = simulation(LINES);
    let opened = |path: &str, expected: Expect| expected.assert_eq(&shown(&simulation.entries(path)));
    opened(
        "",
        expect![[r#"
        pump : Motor, 4 parts
        lines : ARRAY[1..4] OF Motor, 4 parts
        step : Phase
        mix : ARRAY[1..3] OF REAL, 3 parts
        go : BOOL
        stop : BOOL
        k : INT
        m1 : $Motor, 7 parts
        c : CTU, 2 parts
        grid : ARRAY[1..2, 0..1] OF INT, 4 parts
        timers : ARRAY[1..2] OF TON, 2 parts
        ms : ARRAY[1..2] OF $Motor, 2 parts
        big : ARRAY[1..10000] OF INT, 10000 parts
        many : ARRAY[1..100] OF TON, 100 parts
    "#]],
    );
    opened(
        "pump",
        expect![[r#"
        pump.speed : REAL
        pump.limit : REAL
        pump.running : BOOL
        pump.delay : TON, 2 parts
    "#]],
    );
    opened(
        "Lines",
        expect![[r#"
        lines[1] : Motor, 4 parts
        lines[2] : Motor, 4 parts
        lines[3] : Motor, 4 parts
        lines[4] : Motor, 4 parts
    "#]],
    );
    opened(
        "lines[ 2 ]",
        expect![[r#"
        lines[2].speed : REAL
        lines[2].limit : REAL
        lines[2].running : BOOL
        lines[2].delay : TON, 2 parts
    "#]],
    );
    opened(
        "mix",
        expect![[r#"
        mix[1] : REAL
        mix[2] : REAL
        mix[3] : REAL
    "#]],
    );
    opened(
        "grid",
        expect![[r#"
        grid[1, 0] : INT
        grid[1, 1] : INT
        grid[2, 0] : INT
        grid[2, 1] : INT
    "#]],
    );
    opened(
        "grid[2]",
        expect![[r#"
        grid[2, 0] : INT
        grid[2, 1] : INT
    "#]],
    );
    opened(
        "timers",
        expect![[r#"
        timers[1] : TON, 2 parts
        timers[2] : TON, 2 parts
    "#]],
    );
    opened(
        "timers[2]",
        expect![[r#"
        timers[2].Q : BOOL
        timers[2].ET : TIME
    "#]],
    );
    opened(
        "m1",
        expect![[r#"
        m1.EN : BOOL
        m1.ENO : BOOL
        m1.start : BOOL
        m1.halt : BOOL
        m1.running : BOOL
        m1.inner : $Inner, 6 parts
        m1.seal : BOOL
    "#]],
    );
    opened(
        "m1.inner",
        expect![[r#"
        m1.inner.EN : BOOL
        m1.inner.ENO : BOOL
        m1.inner.a : BOOL
        m1.inner.n : INT
        m1.inner.t : TON, 2 parts
        m1.inner.hist : ARRAY[1..2] OF INT, 2 parts
    "#]],
    );
    opened(
        "ms",
        expect![[r#"
        ms[1] : $Motor, 7 parts
        ms[2] : $Motor, 7 parts
    "#]],
    );
    opened(
        "MS[2].Inner",
        expect![[r#"
        ms[2].inner.EN : BOOL
        ms[2].inner.ENO : BOOL
        ms[2].inner.a : BOOL
        ms[2].inner.n : INT
        ms[2].inner.t : TON, 2 parts
        ms[2].inner.hist : ARRAY[1..2] OF INT, 2 parts
    "#]],
    );
    opened("big[3]", expect![[""]]);
    opened("nothing", expect![[""]]);
    assert_eq!(simulation.entries("big").len(), 10_000);
    let states = simulation.opened("lines[2]").unwrap();
    assert!(matches!(states.last(), Some(Entry::Group(group)) if group.state.is_some()));
}

#[test]
fn a_path_stands_for_the_values_in_it() {
    let simulation = simulation(LINES);
    let all = |text: &str, expected: Expect| {
        let shown = match simulation.resolve_all(text) {
            Ok(points) => names(&points),
            Err(unknown) => unknown.message,
        };
        expected.assert_eq(&shown);
    };
    all(
        "lines[1..2]",
        expect![
            "lines[1].speed lines[1].limit lines[1].running lines[1].delay.Q lines[1].delay.ET lines[2].speed lines[2].limit lines[2].running lines[2].delay.Q lines[2].delay.ET"
        ],
    );
    all(
        "pump",
        expect!["pump.speed pump.limit pump.running pump.delay.Q pump.delay.ET"],
    );
    all("grid", expect!["grid[1, 0] grid[1, 1] grid[2, 0] grid[2, 1]"]);
    all("grid[2, 0..1]", expect!["grid[2, 0] grid[2, 1]"]);
    all("grid[2]", expect!["grid[2, 0] grid[2, 1]"]);
    all(
        "m1.inner",
        expect![
            "m1.inner.EN m1.inner.ENO m1.inner.a m1.inner.n m1.inner.t.Q m1.inner.t.ET m1.inner.hist[1] m1.inner.hist[2]"
        ],
    );
    all(
        "ms[2].inner.hist[1..2]",
        expect!["ms[2].inner.hist[1] ms[2].inner.hist[2]"],
    );
    all(
        "ms[2].inner.hist[3]",
        expect!["ms[2].inner.hist[3] does not exist: this index goes from 1 to 2"],
    );
    all(
        "grid[3, 0..1]",
        expect!["grid[3, 0] does not exist: this index goes from 1 to 2"],
    );
    all(
        "lines[3..2]",
        expect!["lines[3..2] has no elements: write the smaller index first"],
    );
    all(
        "lines[3].sped",
        expect!["lines has parts: name one of them, as in lines[1].speed"],
    );
}

#[test]
fn a_table_of_all_tags_has_elementary_parts_but_no_insides_and_no_long_arrays() {
    let simulation = simulation(LINES);
    let tags = (0..simulation.program().tags.len() as u32).map(TagId);
    let points: Vec<Point> = tags.flat_map(|tag| simulation.in_table(tag)).collect();
    expect!["pump.speed pump.limit pump.running pump.delay.ET pump.delay.Q lines[1].speed lines[2].speed lines[3].speed lines[4].speed lines[1].limit lines[2].limit lines[3].limit lines[4].limit lines[1].running lines[2].running lines[3].running lines[4].running lines[1].delay.ET lines[1].delay.Q lines[2].delay.ET lines[2].delay.Q lines[3].delay.ET lines[3].delay.Q lines[4].delay.ET lines[4].delay.Q step mix[1] mix[2] mix[3] go stop k c.CV c.Q grid[1, 0] grid[1, 1] grid[2, 0] grid[2, 1] timers[1].ET timers[1].Q timers[2].ET timers[2].Q"].assert_eq(&names(&points));
}

//! Structures, arrays, enumerations and states of blocks over changes of the program and restarts.

use crate::change::{change, held, run, session, set};
use crate::support::{self, get, simulation};
use expect_test::{Expect, expect};
use ladder_simulator::Simulation;

/// Runs a program for one scan, changes it, and shows what was lost and what tags hold.
#[track_caller]
fn over_a_change(old: &str, given: &[(&str, &str)], new: &str, tags: &str, expected: Expect) {
    let mut session = session(old);
    for (tag, value) in given {
        set(&mut session, tag, value);
    }
    session.scan();
    let lost = change(&mut session, new);
    expected.assert_eq(&format!("{lost}{}\n", held(&session, tags)));
}

/// The same with what a retentive file keeps. Returns the complaints too.
#[track_caller]
fn over_a_file(old: &str, given: &[(&str, &str)], new: &str, tags: &str, expected: Expect) {
    let mut before = simulation(old);
    for (tag, value) in given {
        support::set(&mut before, tag, value);
    }
    before.scan();
    let mut after = simulation(new);
    let complaints = after.warm_start(&before.retained());
    let tags = tags.split(' ').map(|tag| format!("{tag} {}", get(&after, tag)));
    let lines = complaints
        .into_iter()
        .chain([tags.collect::<Vec<_>>().join(", ")]);
    expected.assert_eq(&lines.map(|line| line + "\n").collect::<String>());
}

const LINE: &str = "TYPE\nLine : STRUCT\nn : INT := 3;\nlog : ARRAY[1..COLUMNS] OF INT;\nEND_STRUCT;\nEND_TYPE\n\
                    VAR RETAIN\nl : ARRAY[ROWS] OF Line;\nEND_VAR\nVAR\nk : INT := 2;\nEND_VAR\n\
                    +--[MOV]( y, l[k].n )--[MOV]( y, l[k].log[2] )--+\n";

fn line(rows: &str, columns: &str) -> String {
    LINE.replace("ROWS", rows).replace("COLUMNS", columns)
}

const GIVEN: &[(&str, &str)] = &[
    ("l[1].n", "10"),
    ("l[2].n", "20"),
    ("l[2].log[1]", "21"),
    ("l[2].log[2]", "22"),
];

#[test]
fn elements_that_remain_go_on() {
    over_a_change(
        &line("1..2", "2"),
        GIVEN,
        &line("2..4", "3"),
        "l[2].n l[3].n l[2].log[1] l[2].log[2] l[2].log[3] l[4].log[2]",
        expect![[r#"
            l[2].n 20, l[3].n 3, l[2].log[1] 21, l[2].log[2] 22, l[2].log[3] 0, l[4].log[2] 0
        "#]],
    );
}

#[test]
fn elements_that_remain_are_kept() {
    over_a_file(
        &line("1..2", "2"),
        GIVEN,
        &line("2..4", "3"),
        "l[2].n l[3].n l[2].log[1] l[2].log[2] l[2].log[3] l[4].log[2]",
        expect![[r#"
            l[2].n 20, l[3].n 3, l[2].log[1] 21, l[2].log[2] 22, l[2].log[3] 0, l[4].log[2] 0
        "#]],
    );
}

const PHASES: &str = "TYPE\nPhase : (VALUES);\nEND_TYPE\nVAR RETAIN\np : ARRAY[1..3] OF Phase;\nEND_VAR\n\
                      +--[MOV]( p[3], p[3] )--+\n";

#[test]
fn only_a_value_that_is_no_more_starts_cold() {
    let old = PHASES.replace("VALUES", "IDLE, FILLING, MIXING");
    let new = PHASES.replace("VALUES", "STOPPED, MIXING, IDLE");
    let given = [("p[1]", "MIXING"), ("p[2]", "FILLING")];
    over_a_change(
        &old,
        &given,
        &new,
        "p[1] p[2] p[3]",
        expect![[r#"
        p: p[2] was FILLING, which is no value any more: it begins with its initial value
        p[1] MIXING, p[2] STOPPED, p[3] IDLE
    "#]],
    );
    over_a_file(
        &old,
        &given,
        &new,
        "p[1] p[2] p[3]",
        expect![[r#"
        p: `FILLING` is not a value of Phase: write one of STOPPED MIXING IDLE: it begins with its initial value
        p[1] MIXING, p[2] STOPPED, p[3] IDLE
    "#]],
    );
}

const COUNT: &str = "FUNCTION_BLOCK [$Count]\nVAR_INPUT\nx : BOOL;\nEND_VAR\nVAR_OUTPUT\nn : INT;\nEND_VAR\nVAR\nt : TON;\nEND_VAR\n\
                     +--[ ]( x )--[OSR]--[ADD]( n, n, 1 )--+\n+--[ ]( x )--[TON]( t, 1s )--+\nEND_FUNCTION_BLOCK\n\
                     VAR_INPUT\nx : BOOL;\nEND_VAR\nVAR RETAIN\nm : ARRAY[1..2] OF $Count;\nEND_VAR\nVAR\nk : INT := 2;\nEND_VAR\n\
                     +--[$Count]( m[k], x )--+\n";

#[test]
fn the_state_of_a_block_goes_on_with_its_edges() {
    let mut session = session(COUNT);
    run(&mut session, "x _-");
    let lost = change(&mut session, &format!("{COUNT}+--[ ]( x )--( )( y )--+\n"));
    run(&mut session, "x -");
    expect![[r#"
        m[2].n 1, m[2].t.ET 10, m[1].n 0, y 1
    "#]]
    .assert_eq(&format!(
        "{lost}{}\n",
        held(&session, "m[2].n m[2].t.ET m[1].n y")
    ));
}

#[test]
fn the_state_of_a_block_is_kept() {
    over_a_file(
        COUNT,
        &[("x", "1")],
        COUNT,
        "m[1].n m[2].n m[2].t.Q",
        expect![[r#"
            m[1].n 0, m[2].n 1, m[2].t.Q 0
        "#]],
    );
}

#[test]
fn an_array_that_is_a_member_goes_by_reference() {
    let text = "TYPE\nGroup : STRUCT\nn : INT;\nlamps : ARRAY[1..4] OF BOOL;\nEND_STRUCT;\nEND_TYPE\n\
        FUNCTION_BLOCK [$Light]\nVAR_IN_OUT\nlist : ARRAY[1..4] OF BOOL;\nEND_VAR\n+--( )( list[2] )--+\nEND_FUNCTION_BLOCK\n\
        VAR\ng : ARRAY[1..2] OF Group;\none : Group;\nk : INT := 1;\nEND_VAR\n\
        +--[$Light]( one.lamps )--+\n+--[$Light]( g[2].lamps )--+\n+--[$Light]( g[k].lamps )--+\n";
    let mut simulation = simulation(text);
    simulation.scan();
    let lamps = [
        "one.lamps[1]",
        "one.lamps[2]",
        "g[1].lamps[2]",
        "g[2].lamps[1]",
        "g[2].lamps[2]",
    ];
    assert_eq!(
        lamps.map(|lamp| get(&simulation, lamp)),
        ["0", "1", "1", "0", "1"]
    );
}

/// Edges of its own, in a block in it, and in a state that is one of its tags.
const EDGES: &str = "FUNCTION_BLOCK [$Rise]\nVAR_INPUT\nx : BOOL;\nEND_VAR\nVAR_OUTPUT\nn : INT;\nEND_VAR\n\
                     +--[P]( x )--[ADD]( n, n, 1 )--+\nEND_FUNCTION_BLOCK\n\
                     FUNCTION_BLOCK [$All]\nVAR_INPUT\nx : BOOL;\nEND_VAR\nVAR_OUTPUT\na, b, c : INT;\nEND_VAR\nVAR\nrise : ARRAY[1..2] OF $Rise;\nEND_VAR\n\
                     +--[ ]( x )--[OSR]--[ADD]( a, a, 1 )--+\n+--[$Rise]( x, b )--+\n+--[$Rise]( rise[2], x, c )--+\nEND_FUNCTION_BLOCK\n\
                     VAR_INPUT\nx : BOOL;\nEND_VAR\nVAR RETAIN\nm : ARRAY[1..2] OF $All;\none : $All;\nEND_VAR\nVAR\nlost : $All;\nk : INT := 2;\nEND_VAR\n\
                     +--[$All]( m[k], x )--+\n+--[$All]( one, x )--+\n+--[$All]( lost, x )--+\n";

#[test]
fn the_state_of_a_retentive_block_keeps_its_edges() {
    let tags = "m[1].a m[2].a m[2].b m[2].c one.a one.b one.c lost.a lost.b lost.c";
    let shown = |simulation: &Simulation| {
        let tags = tags
            .split(' ')
            .map(|tag| format!("{tag} {}", get(simulation, tag)));
        tags.collect::<Vec<_>>().join(", ") + "\n"
    };
    let mut simulation = simulation(EDGES);
    support::set(&mut simulation, "x", "1");
    simulation.scan();
    let kept = simulation.retained();
    let edges = kept.iter().filter(|kept| kept.name.contains('#'));
    let names: Vec<String> = edges
        .map(|kept| format!("{} {}", kept.name, kept.values[0]))
        .collect();
    expect![[r#"
        m[1].OSR#1 FALSE, m[2].OSR#1 TRUE, one.OSR#1 TRUE, m[1].P#2 FALSE, m[2].P#2 TRUE, one.P#2 TRUE, m[1].P#3 FALSE, m[1].P#3.1 FALSE, m[2].P#3 FALSE, m[2].P#3.1 TRUE, one.P#3 FALSE, one.P#3.1 TRUE
    "#]].assert_eq(&(names.join(", ") + "\n"));
    // The power is high all the time: whoever remembers that sees no other edge.
    let expected = expect![[r#"
        m[1].a 0, m[2].a 1, m[2].b 1, m[2].c 1, one.a 1, one.b 1, one.c 1, lost.a 1, lost.b 1, lost.c 1
    "#]];
    simulation.warm_restart();
    support::set(&mut simulation, "x", "1");
    simulation.scan();
    expected.assert_eq(&shown(&simulation));
    let mut from_file = support::simulation(EDGES);
    assert_eq!(from_file.warm_start(&kept), [""; 0]);
    support::set(&mut from_file, "x", "1");
    from_file.scan();
    assert_eq!(shown(&from_file), shown(&simulation));
}

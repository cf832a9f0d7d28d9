//! Pairs of whole programs: whether they do the same.

use super::simulation;
use expect_test::{Expect, expect};
use ladder_prover::{Divergence, Limits, Row, Whole, compare_programs, compare_programs_assuming};
use ladder_simulator::value_text;
use std::fmt::Write;
use std::time::{Duration, Instant};

const INTERVAL: i64 = 100_000_000;

fn compared(old: &str, new: &str, time: u64) -> Whole {
    let [mut old, mut new] = [old, new].map(|text| simulation(text, INTERVAL).expect("it has no errors"));
    let limits = Limits {
        time: Duration::from_millis(time),
        ..Limits::default()
    };
    compare_programs(&mut old, &mut new, limits).expect("what is found happens")
}

fn cells(row: &Row) -> String {
    let values = row.values.iter().map(|value| value_text::cell(value, row.ty));
    values.collect::<Vec<_>>().join(" ")
}

fn drawn(run: &Divergence) -> String {
    let mut text = format!("differs after scan {}\n", run.scans);
    for row in &run.given {
        let _ = writeln!(text, "{} {}", row.name, cells(row));
    }
    for (which, faults) in ["old", "new"].into_iter().zip(&run.faults) {
        if faults.contains(&true) {
            let _ = writeln!(text, "fault in {which}: {faults:?}");
        }
    }
    if let Some(which) = run.ended {
        let _ = writeln!(text, "only one ended: {which:?}");
    }
    for differing in &run.differs {
        for (which, values) in [("old", &differing.old), ("new", &differing.new)] {
            let row = Row {
                name: differing.name.clone(),
                ty: differing.ty,
                values: values.clone(),
            };
            let _ = writeln!(text, "{} {which} {}", row.name, cells(&row));
        }
    }
    text
}

fn told(old: &str, new: &str) -> String {
    match compared(old, new, 5_000) {
        Whole::Same => String::from("the same\n"),
        Whole::Differs(run) => drawn(&run),
        Whole::Unknown(why) => format!("unknown: {why}\n"),
    }
}

#[track_caller]
fn check(old: &str, new: &str, expected: Expect) {
    expected.assert_eq(&told(old, new));
}

/// A rung of contacts, with the same drawn otherwise.
const REWRITTEN: [&str; 2] = [
    "+--\\--[/]( a )--\\--( )( x )--+\n|  /--[/]( b )--/            |\n",
    "+--[ ]( a )--[ ]( b )--(/)( x )--+\n",
];

#[test]
fn the_same_in_every_run() {
    let timer = "+--[ ]( x )--[TON]( t, 5s )--( )( y )--+\n";
    for (old, new) in [
        (REWRITTEN[0].to_owned(), REWRITTEN[1].to_owned()),
        // What follows, with timers, edges and counts.
        (REWRITTEN[0].to_owned() + timer, REWRITTEN[1].to_owned() + timer),
        (
            REWRITTEN[0].to_owned() + "+--[P]( x )--[CTU]( c, 3 )--(S)( y )--+\n",
            REWRITTEN[1].to_owned() + "+--[P]( x )--[CTU]( c, 3 )--(S)( y )--+\n",
        ),
        // Networks in another order.
        (
            "+--[ ]( a )--( )( x )--+\n\n+--[P]( b )--[TON]( t, 5s )--( )( y )--+\n".to_owned(),
            "+--[P]( b )--[TON]( t, 5s )--( )( y )--+\n\n+--[ ]( a )--( )( x )--+\n".to_owned(),
        ),
        // A relay in between, which the other has not.
        (
            "VAR_OUTPUT\n    x : BOOL;\nEND_VAR\nVAR\n    r : BOOL;\nEND_VAR\n+--[ ]( a )--( )( r )--+\n+--[ ]( r )--( )( x )--+\n"
                .to_owned(),
            "VAR_OUTPUT\n    x : BOOL;\nEND_VAR\n+--[ ]( a )--( )( x )--+\n".to_owned(),
        ),
    ] {
        assert_eq!(told(&old, &new), "the same\n", "{old}{new}");
    }
}

/// What a network does from a state that no run comes to is no difference.
#[test]
fn states_that_never_are() {
    let program = |contact: &str| {
        format!(
            "+--\\--[ ]( a )----\\--[/]( down )--( )( up )--+\n|  /--[ ]( up )---/                          |\n\
             +--\\--[ ]( b )----\\--[/]( up )--( )( down )--+\n|  /--[ ]( down )-/                          |\n\
             +--[ ]( up ){contact}--( )( lamp )--+\n"
        )
    };
    check(&program(""), &program("--[/]( down )"), expect!["the same\n"]);
}

#[test]
fn one_edit() {
    check(
        "+--\\--[ ]( start )--\\--[/]( stop )--( )( run )--+\n|  /--[ ]( run )----/                           |\n",
        "+--\\--[ ]( start )--\\--( )( run )--+\n|  /--[ ]( run )----/              |\n",
        expect![[r#"
            differs after scan 1
            start 1
            stop 1
            run old 0
            run new 1
        "#]],
    );
    // A run that must wait.
    check(
        "+--[ ]( a )--[TON]( t, 1s )--( )( x )--+\n",
        "+--[ ]( a )--[TON]( t, 1200ms )--( )( x )--+\n",
        expect![[r#"
            differs after scan 11
            a 1 1 1 1 1 1 1 1 1 1 1
            x old 0 0 0 0 0 0 0 0 0 0 1
            x new 0 0 0 0 0 0 0 0 0 0 0
        "#]],
    );
    check(
        "+--[ ]( a )--[CTU]( c, 4 )--( )( x )--+\n",
        "+--[ ]( a )--[CTU]( c, 5 )--( )( x )--+\n",
        expect![[r#"
            differs after scan 7
            a 1 0 1 0 1 0 1
            x old 0 0 0 0 0 0 1
            x new 0 0 0 0 0 0 0
        "#]],
    );
    // A number that is met in one scan of many.
    check(
        "VAR_INPUT\n    n : INT;\nEND_VAR\n+--[GT]( n, 20345 )--( )( x )--+\n",
        "VAR_INPUT\n    n : INT;\nEND_VAR\n+--[GE]( n, 20345 )--( )( x )--+\n",
        expect![[r#"
            differs after scan 1
            n 20345
            x old 0
            x new 1
        "#]],
    );
}

#[test]
fn what_is_compared() {
    // What is kept over a restart, and what other files see.
    for section in ["VAR RETAIN", "VAR_GLOBAL"] {
        let program = |by: i64| {
            format!(
                "{section}\n    n : DINT;\nEND_VAR\n+--[P]( a )--[ADD]( n, n, {by} )--+\n+--[ ]( a )--( )( x )--+\n"
            )
        };
        let told = told(&program(1), &program(2));
        assert_eq!(told, "differs after scan 1\na 1\nn old 1\nn new 2\n");
    }
    // A tag of the program alone is its own affair.
    let program = |by: i64| {
        format!(
            "VAR\n    n : DINT;\nEND_VAR\n+--[P]( a )--[ADD]( n, n, {by} )--+\n+--[ ]( a )--( )( x )--+\n"
        )
    };
    check(&program(1), &program(2), expect!["the same\n"]);
    // Faults, and the end.
    let program = |by: &str| {
        format!(
            "VAR_INPUT\n    n : DINT;\nEND_VAR\nVAR\n    m : DINT;\nEND_VAR\n+--[ ]( a )--[DIV]( m, 8, {by} )--+\n+--[ ]( a )--( )( x )--+\n"
        )
    };
    check(
        &program("n"),
        &program("2"),
        expect![[r#"
        differs after scan 1
        a 1
        fault in old: [true]
    "#]],
    );
    check(
        "+--[ ]( a )--( )( x )--+\n+--[ ]( b )--<END>--+\n",
        "+--[ ]( a )--( )( x )--+\n",
        expect![[r#"
            differs after scan 1
            b 1
            only one ended: Old
        "#]],
    );
}

/// What is at an address is the same by whichever name.
#[test]
fn other_names() {
    let program = |input: &str, output: &str, address: &str| {
        format!(
            "VAR_INPUT\n    {input} AT {address} : BOOL;\nEND_VAR\nVAR_OUTPUT\n    {output} AT %QX0.0 : BOOL;\nEND_VAR\n\
             VAR\n    relay : BOOL;\nEND_VAR\n+--[P]( {input} )--(S)( relay )--+\n+--[ ]( relay )--( )( {output} )--+\n"
        )
    };
    let old = program("start", "lamp", "%IX0.0");
    check(&old, &program("go", "light", "%IX0.0"), expect!["the same\n"]);
    check(
        &old,
        &program("go", "light", "%IX0.0")
            .replace("[P]", "[ ]")
            .replace("(S)", "( )"),
        expect![[r#"
            differs after scan 2
            start 1 0
            lamp old 1 1
            lamp new 1 0
        "#]],
    );
    check(
        &old,
        &program("start", "lamp", "%IX0.1"),
        expect![[r#"
        unknown: start is at another address
    "#]],
    );
    // A relay has another name.
    check(&old, &old.replace("relay", "seal"), expect!["the same\n"]);
}

#[test]
fn what_is_not_known() {
    let start = Instant::now();
    let program = |hours: i64| {
        format!(
            "VAR\n    one : RTO;\n    n : DINT;\nEND_VAR\n+--[ ]( a )--[RTO]( one, {hours}h )--( )( done )--+\n"
        )
    };
    let whole = compared(&program(500), &program(501), 500);
    let Whole::Unknown(why) = whole else {
        panic!("{whole:?}")
    };
    assert!(why.ends_with("and no proof"), "{why}");
    assert!(start.elapsed() < Duration::from_secs(5), "{:?}", start.elapsed());
    check(
        "VAR_INPUT\n    n : INT;\nEND_VAR\n+--[GT]( n, 1 )--( )( x )--+\n",
        "VAR_INPUT\n    n : DINT;\nEND_VAR\n+--[GT]( n, 1 )--( )( x )--+\n",
        expect![[r#"
            unknown: n is declared differently
        "#]],
    );
    check(
        "+--[ ]( a )--( )( x )--+\n",
        "+--[ ]( a )--( )( y )--+\n",
        expect![[r#"
            unknown: the programs have no output in common
        "#]],
    );
    check(
        "VAR_OUTPUT\n    s : STRING;\nEND_VAR\n+--[ ]( a )--[MOVE]( s, 'a' )--( )( x )--+\n",
        "VAR_OUTPUT\n    s : STRING;\nEND_VAR\n+--[ ]( a )--[MOVE]( s, 'b' )--( )( x )--+\n",
        expect![[r#"
            unknown: texts are not tracked, as in s
        "#]],
    );
}

/// What differs only where an assumption does not hold is the same; a run that is found keeps it.
#[test]
fn what_is_assumed_holds_in_the_runs() {
    let old = "+--[ ]( a )--[ ]( b )--( )( y )--+\n+--[ ]( c )--( )( z )--+\n";
    let new = "+--[ ]( a )--( )( y )--+\n+--[ ]( c )--( )( z )--+\n";
    let both = |assumption: &str| {
        let [mut old, mut new] = [old, new].map(|text| simulation(text, INTERVAL).expect("it has no errors"));
        let suite = ladder_simulator::scenario::parse(&format!("program p.clad\nassume {assumption}\n"));
        let (mut assumed, errors) = ladder_simulator::scenario::bind_properties(&suite, &old);
        assert_eq!((suite.errors, errors), (Vec::new(), Vec::new()));
        let limits = Limits::default();
        compare_programs_assuming(&mut old, &mut new, &mut assumed, limits).expect("what is found happens")
    };
    assert_eq!(both("b or not a"), Whole::Same);
    let Whole::Differs(found) = both("c or not a") else {
        panic!("they differ");
    };
    let names: Vec<&str> = found.given.iter().map(|row| row.name.as_str()).collect();
    assert_eq!(names, ["a", "c"]);
}

//! Counters and bistables, sentence by sentence of the language's definition.

use crate::support::{check, get, set, simulation, trace};
use expect_test::expect;

fn counter(kind: &str, named: &str) -> String {
    format!(
        "VAR_INPUT en, cd, r, ld : BOOL; pv : DINT := 2; END_VAR\nVAR c : {kind}; END_VAR\n\
         +--[ ]( en )--[{kind}]( c, pv{named} )--( )( y )--+\n"
    )
}

#[test]
fn up() {
    check(
        &counter("CTU", ", R := r"),
        "en --_-_-_-_-\nr  _______-_-",
        "c.Q c.CV c.CC y",
        expect![[r#"
            c.Q   ___----___
            c.CV  1 1 1 2 2 3 3 0 0 0
            c.CC  -__-_-_-__
            y     ___----___
        "#]],
    );
}

#[test]
fn down() {
    check(
        &counter("CTD", ", LD := ld, R := r"),
        "en _-_-_-_-__\nld -_______--\nr  ____-____-",
        "c.Q c.CV c.CC",
        expect![[r#"
            c.Q   ___-----_-
            c.CV  2 1 1 0 0 -1 -1 -2 2 0
            c.CC  --_-_-_---
        "#]],
    );
}

#[test]
fn up_and_down() {
    check(
        &counter("CTUD", ", CD := cd, R := r, LD := ld"),
        "en -_-_-_-___\ncd __-_-__-__\nr  ________-_\nld _________-",
        "c.QU c.QD c.Q c.CV y",
        expect![[r#"
            c.QU  ______-__-
            c.QD  ________-_
            c.Q   ______-__-
            c.CV  1 1 1 1 1 1 2 1 0 2
            y     ______-__-
        "#]],
    );
}

#[test]
fn in_a_circle() {
    check(
        &counter("CTC", ", R := r"),
        "en _-_-_-_-_-\nr  _________-",
        "c.Q c.CV",
        expect![[r#"
            c.Q   ___--_____
            c.CV  0 1 1 2 2 0 0 1 1 0
        "#]],
    );
}

#[test]
fn counters_stop_at_the_limits_of_dint() {
    let mut up = simulation(&counter("CTUD", ", CD := cd"));
    set(&mut up, "c.CV", "2147483646");
    up.scan();
    expect![[r#"
        c.CV  2147483646 2147483647 2147483647 2147483647 2147483647 2147483647
    "#]]
    .assert_eq(&trace(&mut up, "en _-_-_-", "c.CV"));
    let mut down = simulation(&counter("CTUD", ", CD := cd"));
    set(&mut down, "c.CV", "-2147483647");
    down.scan();
    expect![[r#"
        c.CV  -2147483647 -2147483648 -2147483648 -2147483648 -2147483648 -2147483648
    "#]]
    .assert_eq(&trace(&mut down, "cd _-_-_-", "c.CV"));
}

#[test]
fn the_preset_is_read_at_every_evaluation() {
    check(
        &counter("CTU", ""),
        "en -____\npv 2 1 0 1 2",
        "c.Q c.PV",
        expect![[r#"
        c.Q   _---_
        c.PV  2 1 0 1 2
    "#]],
    );
}

#[test]
fn res_clears_at_once() {
    let run = |kind: &str| {
        let text = format!(
            "VAR_INPUT en, c : BOOL; END_VAR\nVAR k : {kind}; q : BOOL; END_VAR\n\
             +--[ ]( en )--[{kind}]( k, 1 )--( )( y )--+\n\
             +--[ ]( c )--(R)( k )--( )( z )--+\n\
             +--[ ]( k.Q )--( )( q )--+\n"
        );
        format!(
            "{kind}\n{}",
            trace(&mut simulation(&text), "en -_-_-\nc  __-__", "y q k.CV z")
        )
    };
    let all: Vec<String> = ["CTU", "CTD", "CTUD", "CTC"].map(run).into();
    expect![[r#"
        CTU
        y     ---_-
        q     --__-
        k.CV  1 1 0 0 1
        z     __-__
        CTD
        y     -----
        q     -----
        k.CV  -1 -1 0 0 -1
        z     __-__
        CTUD
        y     ---_-
        q     --__-
        k.CV  1 1 0 0 1
        z     __-__
        CTC
        y     --__-
        q     --__-
        k.CV  1 1 0 0 1
        z     __-__
    "#]]
    .assert_eq(&all.concat());
}

#[test]
fn controller_names() {
    let mut simulation = simulation(&counter("CTU", ""));
    crate::support::set(&mut simulation, "en", "1");
    simulation.scan();
    let names = ["c.EN", "c.PRE", "c.ACC", "c.AC", "c.DN", "c.CC", "c.CU", "C.cv"];
    let values: Vec<String> = names.iter().map(|name| get(&simulation, name)).collect();
    assert_eq!(values, ["1", "2", "1", "1", "0", "1", "1", "1"]);
}

#[test]
fn bistables() {
    let text = "VAR_INPUT s, r : BOOL; END_VAR\nVAR a : SR; b : RS; END_VAR\n\
                +--[ ]( s )--[SR]( a, R := r )--( )( y )--+\n\
                +--[ ]( s )--[RS]( b, R := r )--( )( z )--+\n";
    check(
        text,
        "s _-__-_-_\nr ___-__-_",
        "a.Q1 b.Q1 y z",
        expect![[r#"
        a.Q1  _--_----
        b.Q1  _--_--__
        y     _--_----
        z     _--_--__
    "#]],
    );
}

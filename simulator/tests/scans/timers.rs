//! Timers, sentence by sentence of the language's definition. One column is a scan of 10 ms.

use crate::support::{check, simulation, trace};
use expect_test::expect;

fn timer(kind: &str) -> String {
    format!(
        "VAR_INPUT en, r : BOOL; pt : TIME := T#30ms; END_VAR\nVAR t : {kind}; END_VAR\n\
         +--[ ]( en )--[{kind}]( t, pt, R := r )--( )( y )--+\n"
    )
}

const WATCH: &str = "en t.Q t.ET t.TT";

#[test]
fn on_delay() {
    check(
        &timer("TON"),
        "en _-------___--___",
        WATCH,
        expect![[r#"
            en    _-------___--___
            t.Q   ____----________
            t.ET  0 0 10 20 30 30 30 30 0 0 0 0 10 0 0 0
            t.TT  _---_______--___
        "#]],
    );
}

#[test]
fn off_delay() {
    check(
        &timer("TOF"),
        "en _---______--__---",
        WATCH,
        expect![[r#"
            en    _---______--__---
            t.Q   _------___-------
            t.ET  0 0 0 0 0 10 20 30 30 30 0 0 0 10 0 0 0
            t.TT  _________________
        "#]],
    );
}

#[test]
fn pulse() {
    check(
        &timer("TP"),
        "en _------__-_-____",
        WATCH,
        expect![[r#"
        en    _------__-_-____
        t.Q   _---_____---____
        t.ET  0 0 10 20 30 30 30 0 0 0 10 20 0 0 0 0
        t.TT  ____---_________
    "#]],
    );
}

#[test]
fn retentive_on_delay() {
    check(
        &timer("RTO"),
        "en _---__---___\nr __________-_",
        WATCH,
        expect![[r#"
            en    _---__---___
            t.Q   _______---__
            t.ET  0 0 10 20 20 20 20 30 30 30 0 0
            t.TT  _---__-_____
        "#]],
    );
}

#[test]
fn retentive_off_delay() {
    check(
        &timer("RTOF"),
        "en _--__--_____--__",
        WATCH,
        expect![[r#"
        en    _--__--_____--__
        t.Q   _--------___--__
        t.ET  0 0 0 0 10 10 10 10 20 30 30 30 30 30 30 30
        t.TT  ________________
    "#]],
    );
}

#[test]
fn a_reset_that_ends_under_a_high_en() {
    let trace = |kind: &str| {
        let inputs = "en _--------------\nr  ___---______-__";
        format!("{kind}\n{}", trace(&mut simulation(&timer(kind)), inputs, WATCH))
    };
    let all: Vec<String> = ["TON", "TOF", "TP", "RTO", "RTOF"].map(trace).into();
    expect![[r#"
        TON
        en    _--------------
        t.Q   _________---___
        t.ET  0 0 10 0 0 0 0 10 20 30 30 30 0 0 10
        t.TT  _--___---____--
        TOF
        en    _--------------
        t.Q   _--___------_--
        t.ET  0 0 0 0 0 0 0 0 0 0 0 0 0 0 0
        t.TT  _______________
        TP
        en    _--------------
        t.Q   _--____________
        t.ET  0 0 10 0 0 0 0 0 0 0 0 0 0 0 0
        t.TT  ______------_--
        RTO
        en    _--------------
        t.Q   _________---___
        t.ET  0 0 10 0 0 0 0 10 20 30 30 30 0 0 10
        t.TT  _--___---____--
        RTOF
        en    _--------------
        t.Q   _--___------_--
        t.ET  0 0 0 0 0 0 0 0 0 0 0 0 0 0 0
        t.TT  _______________
    "#]]
    .assert_eq(&all.concat());
}

#[test]
fn a_reset_with_res_is_seen_at_once_and_ends_with_it() {
    let trace = |kind: &str| {
        let text = format!(
            "VAR_INPUT en, c : BOOL; END_VAR\nVAR t : {kind}; q : BOOL; END_VAR\n\
             +--[ ]( en )--[{kind}]( t, T#20ms )--( )( y )--+\n\
             +--[ ]( c )--(RES)( t )--+\n\
             +--[ ]( t.Q )--( )( q )--+\n"
        );
        let inputs = "en _-------__\nc  ____-_____";
        format!(
            "{kind}\n{}",
            crate::support::trace(&mut simulation(&text), inputs, "y q t.ET")
        )
    };
    let all: Vec<String> = ["TON", "TOF", "TP", "RTO", "RTOF"].map(trace).into();
    expect![[r#"
        TON
        y     ___--__-__
        q     ___-___-__
        t.ET  0 0 10 20 0 0 10 20 0 0
        TOF
        y     _---------
        q     _---_-----
        t.ET  0 0 0 0 0 0 0 0 0 10
        TP
        y     _--_______
        q     _--_______
        t.ET  0 0 10 20 0 0 0 0 0 0
        RTO
        y     ___--__---
        q     ___-___---
        t.ET  0 0 10 20 0 0 10 20 20 20
        RTOF
        y     _---------
        q     _---_-----
        t.ET  0 0 0 0 0 0 0 0 0 10
    "#]]
    .assert_eq(&all.concat());
}

#[test]
fn without_preset_all_but_the_pulse_follow_en() {
    let trace = |kind: &str| {
        let inputs = "en _-__--\npt 0 . . -1s . .";
        format!("{kind}\n{}", trace(&mut simulation(&timer(kind)), inputs, WATCH))
    };
    let all: Vec<String> = ["TON", "TOF", "TP", "RTO", "RTOF"].map(trace).into();
    expect![[r#"
        TON
        en    _-__--
        t.Q   _-__--
        t.ET  0 0 0 0 0 0
        t.TT  ______
        TOF
        en    _-__--
        t.Q   _-__--
        t.ET  0 0 0 0 0 0
        t.TT  ______
        TP
        en    _-__--
        t.Q   ______
        t.ET  0 0 0 0 0 0
        t.TT  _-__--
        RTO
        en    _-__--
        t.Q   _-__--
        t.ET  0 0 0 0 0 0
        t.TT  ______
        RTOF
        en    _-__--
        t.Q   _-__--
        t.ET  0 0 0 0 0 0
        t.TT  ______
    "#]]
    .assert_eq(&all.concat());
}

#[test]
fn the_preset_is_read_at_every_evaluation() {
    // Lengthened under a high Q, then shortened while it runs.
    check(
        &timer("TON"),
        "en ------_------\npt 30 . . . 60 . . . . 10 . . .",
        "t.Q t.ET t.PT",
        expect![[r#"
            t.Q   ___---___----
            t.ET  0 10 20 30 40 50 0 0 10 10 10 10 10
            t.PT  30 30 30 30 60 60 60 60 60 10 10 10 10
        "#]],
    );
}

#[test]
fn plain_integers_are_milliseconds() {
    check(
        "VAR n : UINT := 20; END_VAR\n+--[TON]( t, 20 )--[TON]( u, n )--+\n",
        "5",
        "t.Q t.PT u.Q u.ET u.PT",
        expect![[r#"
            t.Q   __---
            t.PT  20 20 20 20 20
            u.Q   ____-
            u.ET  0 0 0 10 20
            u.PT  20 20 20 20 20
        "#]],
    );
}

#[test]
fn a_timer_that_was_jumped_over_is_right_when_it_is_reached() {
    check(
        "VAR_INPUT skip : BOOL; END_VAR\nVAR t : TON; r : RTO; END_VAR\n\
         +--[ ]( skip )--<JMP>( over )--+\n\
         +--[TON]( t, T#50ms )--+\n\
         +--[RTO]( r, T#50ms )--+\n\
         +--<LBL>( over )--( )( y )--+\n",
        "skip __--__",
        "t.ET t.Q r.ET",
        expect![[r#"
            t.ET  0 10 10 10 40 50
            t.Q   _____-
            r.ET  0 10 10 10 40 50
        "#]],
    );
}

#[test]
fn two_evaluations_in_one_scan_see_the_same_clock() {
    check(
        "VAR_INPUT a : BOOL; END_VAR\nVAR t : RTO; p : TP; c : CTU; END_VAR\n\
         +--<FOR>( 3 )--+\n\
         +--[RTO]( t, T#50ms )--<NEXT>--+\n\
         +--[ ]( a )--[TP]( p, T#20ms )--+\n\
         +--[ ]( a )--[CTU]( c, 9 )--+\n",
        "a _-_---",
        "t.ET p.Q p.ET c.CV",
        expect![[r#"
            t.ET  0 10 20 30 40 50
            p.Q   _--___
            p.ET  0 0 10 20 20 20
            c.CV  0 1 1 2 2 2
        "#]],
    );
}

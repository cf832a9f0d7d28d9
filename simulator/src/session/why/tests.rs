//! How far back is gone for an answer.

use crate::session::{HistoryLimits, Session};
use crate::simulation::{Options, Simulation};
use expect_test::{Expect, expect};
use ladder_analysis::values::value::Value;
use std::fmt::Write;

/// A motor that is started in scan 3 and one that never is, after this many rungs in which something changes all the time.
fn run(rungs: usize, scans: u64, limits: HistoryLimits) -> Session {
    let mut text = String::new();
    for rung in 0..rungs {
        let _ = writeln!(text, "+--[/]( b{rung} )--( )( b{rung} )--+");
    }
    text.push_str("+--[ ]( start )--(S)( run )--+\n+--[ ]( never )--( )( idle )--+\n");
    let analysis = ladder_analysis::analyze(&ladder_syntax::parse(&text).into(), "test.clad");
    let program = analysis.program().cloned().unwrap();
    let mut session = Session::of(Simulation::new(program, Options::default()).unwrap(), limits);
    let start = session.simulation().resolve("start").unwrap();
    for scan in 0..scans {
        if scan == 3 {
            session.set(&start, Value::Bool(true)).unwrap();
        }
        session.scan();
    }
    session
}

/// How many scans are gone back over, for each tag.
fn check(limits: HistoryLimits, expected: Expect) {
    let mut shown = String::new();
    for (rungs, scans) in [(1, 400), (1, 4000), (1, 8000), (200, 4000)] {
        let mut session = run(rungs, scans, limits);
        let _ = write!(
            shown,
            "{rungs} rungs, {scans} scans, {} kept:",
            session.scans_behind()
        );
        for tag in ["idle", "never", "run", "b0"] {
            let point = session.simulation().resolve(tag).unwrap();
            let _ = write!(shown, " {tag} {}", session.inquire(&point).1);
        }
        shown.push('\n');
    }
    expected.assert_eq(&shown);
}

#[test]
fn nothing_is_gone_over_for_what_has_not_changed() {
    check(
        HistoryLimits::default(),
        expect![[r#"
            1 rungs, 400 scans, 400 kept: idle 1 never 0 run 397 b0 2
            1 rungs, 4000 scans, 4000 kept: idle 1 never 0 run 427 b0 2
            1 rungs, 8000 scans, 8000 kept: idle 1 never 0 run 347 b0 2
            200 rungs, 4000 scans, 4000 kept: idle 1 never 0 run 427 b0 2
        "#]],
    );
}

#[test]
fn scans_that_are_kept_are_not_gone_over_for_what_changed_before_them() {
    check(
        HistoryLimits::of_scans(300),
        expect![[r#"
            1 rungs, 400 scans, 300 kept: idle 1 never 0 run 600 b0 2
            1 rungs, 4000 scans, 300 kept: idle 1 never 0 run 1 b0 2
            1 rungs, 8000 scans, 300 kept: idle 1 never 0 run 1 b0 2
            200 rungs, 4000 scans, 300 kept: idle 1 never 0 run 1 b0 2
        "#]],
    );
}

/// A machine whose parts change seldom, often and with each scan; texts and numbers among them.
const MACHINE: &str = "\
VAR_INPUT start, stop, level : BOOL; amount : INT; END_VAR
VAR t : TON; c : CTU; sum : DINT; name : STRING[20]; END_VAR
+--\\--[ ]( start )--\\--[/]( stop )--( )( run )--+
|  /--[ ]( run )----/
+--[ ]( run )--[TON]( t, T#700ms )--(S)( warm )--+
+--[ ]( stop )--(R)( warm )--+
+--[/]( beat )--( )( beat )--+
+--[ ]( level )--[CTU]( c, 5 )--[MOV]( name, 'full' )--+
+--[ ]( warm )--[ADD]( sum, sum, amount )--+
";

#[test]
fn the_answer_is_that_of_going_back_over_each_scan() {
    let analysis = ladder_analysis::analyze(&ladder_syntax::parse(MACHINE).into(), "test.clad");
    let program = analysis.program().cloned().unwrap();
    let mut session = Session::new(program, Options::default(), HistoryLimits::of_scans(2000)).unwrap();
    let point = |name: &str| session.simulation().resolve(name).unwrap();
    let inputs = ["start", "stop", "level"].map(point);
    let amount = point("amount");
    let points = session.simulation().points().to_vec();
    let (mut number, mut shorter) = (12345u64, 0);
    for round in 0..40 {
        for _ in 0..3 {
            number = number
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            let input = &inputs[(number >> 33) as usize % inputs.len()];
            let value = Value::Bool(number >> 40 & 1 != 0);
            match (number >> 45) % 5 {
                0 => session.force(input, value).unwrap(),
                1 => session.unforce(input),
                2 => session
                    .set(&amount, Value::Int((number >> 50) as i64 % 4))
                    .unwrap(),
                _ => session.set(input, value).unwrap(),
            }
            for _ in 0..(number >> 36) % 150 {
                session.scan();
            }
        }
        if round % 5 == 4 {
            session.step_back(round as usize * 13);
        }
        for point in &points {
            let (why, scans) = session.inquire(point);
            session.history.are_spans_passed = false;
            let (over_each, each) = session.inquire(point);
            session.history.are_spans_passed = true;
            assert_eq!(why, over_each, "{}", point.name);
            shorter += each - scans;
        }
    }
    assert!(shorter > 100_000, "{shorter}");
}

//! What counts for the watchdog, and how a scan is cancelled.

use crate::support::simulation_with;
use expect_test::{Expect, expect};
use ladder_analysis::Cancel;
use ladder_analysis::values::value::Value;
use ladder_simulator::{Breakpoint, Fault, HistoryLimits, Options, Session, Simulation, Status, Stop};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

fn watched(text: &str, watchdog: u64) -> Simulation {
    simulation_with(
        text,
        Options {
            watchdog,
            ..Options::default()
        },
    )
}

/// The fault that stops the first scan, in fused code and in plain code alike.
fn stopped(text: &str, watchdog: u64) -> Fault {
    let mut fused = watched(text, watchdog);
    let mut plain = watched(text, watchdog);
    let forced = plain.resolve("forced").unwrap();
    plain.force(&forced, Value::Bool(false)).unwrap();
    assert!(!fused.scan() && !plain.scan());
    assert_eq!(
        (fused.status(), plain.status()),
        (Status::Faulted, Status::Faulted)
    );
    let (fused, plain) = (fused.take_faults(), plain.take_faults());
    assert_eq!(fused, plain);
    fused.into_iter().next_back().unwrap()
}

fn check_stopped(text: &str, watchdog: u64, block: &str, message: Expect) {
    let text = format!("VAR forced, y : BOOL; END_VAR\n{text}");
    let fault = stopped(&text, watchdog);
    assert!(text[fault.location.range].starts_with(block), "{fault:?}");
    assert!(fault.stops);
    message.assert_eq(&fault.message);
}

/// A loop of 900,000 turns.
fn endless(declarations: &str, block: &str) -> String {
    format!("VAR {declarations} END_VAR\n+--<FOR>( 900_000 )--+\n+--{block}--+\n+--<NEXT>--+\n")
}

#[test]
fn elements_of_arrays_count() {
    let arrays = "x, z : ARRAY[1..100_000] OF DINT; b : ARRAY[1..100_000] OF BOOL; n, i : DINT; r : ARRAY[1..2] OF REAL;";
    check_stopped(
        &endless(arrays, "[FILL]( x[1..100_000], 7 )"),
        1_000_000,
        "[FILL]",
        expect![
            "this scan has done more than 1000000 blocks do, so the watchdog stopped the simulation here: 100 elements or characters count as a block; go through fewer of them in one scan"
        ],
    );
    for block in [
        "[BMOV]( x[1..100_000], z[1..100_000] )",
        "[SEARCH]( i, EQ, 5, x[1..100_000] )",
        "[CALC]( n, SUM(x[1..100_000]) )",
        "[ ]( b[1..100_000] )",
        "(S)( b[1..100_000] )",
        "[UNPACK]( b[1..100_000], n )",
        "[P]( y )--[SHIFT]( x[1..100_000], 1 )",
    ] {
        let mut simulation = watched(
            &format!("VAR y : BOOL; END_VAR\n{}", endless(arrays, block)),
            20_000,
        );
        let fits = block.contains("SHIFT") && simulation.scan();
        assert!(fits || !simulation.scan(), "{block}");
        assert!(simulation.work() <= 20_000 || fits, "{block}");
    }
}

#[test]
fn characters_of_texts_count() {
    let texts = "s, u, v : STRING[1000]; a : ARRAY[1..10] OF STRING[1000]; n : DINT; b : BOOL;";
    let long = format!("[MOV]( s, '{}' )", "a".repeat(999));
    for block in [
        "[MOV]( u, s )",
        "[CONCAT]( u, s, v )",
        "[FIND]( n, s, v )",
        "[FILL]( a[1..10], s )",
        "[EQ]( s, v )--( )( b )",
        "[MID]( u, s, 900, 2 )",
        "[SEL]( u, b, s, v )",
    ] {
        let text = format!(
            "VAR {texts} END_VAR\n+--{long}--[MOV]( v, s )--+\n+--<FOR>( 1000 )--+\n+--{block}--+\n+--<NEXT>--+\n"
        );
        // A few blocks a turn fit easily, with their texts they do not.
        assert!(!watched(&text, 5_000).scan(), "{block}");
        assert!(watched(&text, 50_000_000).scan(), "{block}");
    }
}

#[test]
fn operands_count() {
    let many = ", n".repeat(900);
    let text =
        |block: &str| format!("VAR n : DINT; END_VAR\n+--<FOR>( 200 )--+\n+--{block}--+\n+--<NEXT>--+\n");
    for block in [
        format!("[ADD]( n{many} )"),
        format!("[LE]( n{many} )--( )( b )"),
        format!("[MAX]( n{many} )"),
    ] {
        let text = text(&block);
        assert!(!watched(&text, 1_000).scan(), "{}", &text[..80]);
        assert!(watched(&text, 1_000_000).scan(), "{}", &text[..80]);
    }
}

#[test]
fn what_one_scan_may_do_is_not_less_than_it_was() {
    let text = "VAR x : ARRAY[1..1_000_000] OF DINT; END_VAR\n+--<FOR>( 4 )--+\n\
                +--[FILL]( x[1..1_000_000], 7 )--+\n+--<NEXT>--+\n";
    assert!(watched(text, Options::default().watchdog).scan());
    // Few elements are no work compared with their block.
    let text = "VAR x : ARRAY[1..9] OF DINT; END_VAR\n+--[FILL]( x[1..9], 7 )--[FILL]( x[1..9], 8 )--+\n";
    assert!(watched(text, 2).scan());
}

const ENDLESS: &str =
    "VAR n : DINT; END_VAR\n+--[ADD]( n, n, 1 )--+\n+--<LBL>( again )--[ ]( go )--<JMP>( again )--+\n";

/// Cancelled once it has been asked so often, and how often it was asked.
fn cancelled_at(times: usize) -> (Cancel, Arc<AtomicUsize>) {
    let asked = Arc::<AtomicUsize>::default();
    let counts = asked.clone();
    let cancel = Cancel::when(move || counts.fetch_add(1, Ordering::Relaxed) + 1 >= times);
    (cancel, asked)
}

#[test]
fn a_scan_without_end_can_be_stopped_and_is_taken_back() {
    let go = "go";
    for (breakpoint, forced) in [(false, false), (true, false), (false, true)] {
        let mut session = Session::of(watched(ENDLESS, u64::MAX), HistoryLimits::default());
        for _ in 0..3 {
            assert!(session.scan());
        }
        let point = session.simulation().resolve(go).unwrap();
        let n = session.simulation().resolve("n").unwrap();
        if breakpoint {
            session.add_breakpoint(Breakpoint::Change(point.clone()));
        }
        if forced {
            session.force(&point, Value::Bool(true)).unwrap();
        } else {
            session.set(&point, Value::Bool(true)).unwrap();
        }
        let (cancel, asked) = cancelled_at(10);
        session.set_cancel(Some(cancel));
        let ran = session.run(5, &Cancel::default());
        assert_eq!(ran, (0, Stop::Cancelled));
        assert_eq!(asked.load(Ordering::Relaxed), 10);
        assert_eq!(session.simulation().status(), Status::Ready);
        assert_eq!((session.simulation().scans(), session.is_open()), (3, false));
        assert_eq!(session.faults(), []);
        // What was given is still given, what the scan had done is not.
        assert_eq!(session.simulation().value(&point), Value::Bool(true));
        assert_eq!(session.simulation().value(&n), Value::Int(3));
        // Once it can come to an end it does, as if nothing had been.
        session.unforce_all();
        session.set(&point, Value::Bool(false)).unwrap();
        session.clear_breakpoints();
        assert!(session.scan());
        assert_eq!(session.simulation().value(&n), Value::Int(4));
        assert_eq!(session.step_back(4), 4);
    }
}

#[test]
fn without_a_history_a_scan_that_was_stopped_is_a_fault() {
    let mut simulation = watched(ENDLESS, u64::MAX);
    let go = simulation.resolve("go").unwrap();
    simulation.set(&go, Value::Bool(true)).unwrap();
    let mut session = Session::of(simulation, HistoryLimits::of_scans(0));
    session.set_cancel(Some(cancelled_at(1).0));
    assert_eq!(session.run(5, &Cancel::default()), (0, Stop::Faulted));
    let faults = session.faults();
    expect!["the scan took long and was stopped by hand here, before its end"].assert_eq(&faults[0].message);
    session.reset();
    assert!(session.scan());
}

#[test]
fn a_short_scan_comes_to_its_end_though_it_is_cancelled() {
    let text = "VAR x : ARRAY[1..1000] OF DINT; END_VAR\n+--<FOR>( 1000 )--+\n\
                +--[FILL]( x[1..1000], 7 )--+\n+--<NEXT>--+\n";
    let mut simulation = watched(text, u64::MAX);
    let (cancel, asked) = cancelled_at(1);
    simulation.set_cancel(Some(cancel));
    assert!(simulation.scan());
    assert_eq!(asked.load(Ordering::Relaxed), 0);
}

#[test]
fn a_loop_over_large_arrays_is_cancelled_too() {
    let text = endless("x : ARRAY[1..1_000_000] OF DINT;", "[FILL]( x[1..1_000_000], 7 )");
    let mut simulation = watched(&text, u64::MAX);
    simulation.set_cancel(Some(cancelled_at(1).0));
    assert!(!simulation.scan());
    assert_eq!(simulation.status(), Status::Faulted);
}

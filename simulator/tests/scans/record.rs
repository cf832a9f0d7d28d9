//! What a person did, as a scenario.

use crate::change_and_back::{Numbers, give, programs};
use crate::support::{simulation, simulation_with};
use expect_test::{Expect, expect};
use ladder_analysis::values::value::Value;
use ladder_simulator::scenario::{Recorded, bind, parse, record, run};
use ladder_simulator::value_text;
use ladder_simulator::{HistoryLimits, Options, Session, Simulation};

const MOTOR: &str = "\
+--\\--[ ]( start )--\\--[/]( stop )-------------( )( run )--+
|  /--[ ]( run )----/                                      |
+--[ ]( run )--[TON]( t, T#50ms )--( )( warm )--+
";

fn session(text: &str) -> Session {
    Session::of(simulation(text), HistoryLimits::default())
}

fn set(session: &mut Session, tag: &str, value: &str) {
    let point = session.simulation().resolve(tag).unwrap();
    let value = value_text::parse(value, point.ty).unwrap();
    session.set(&point, value).unwrap();
}

fn scan(session: &mut Session, scans: usize) {
    for _ in 0..scans {
        session.scan();
    }
}

#[track_caller]
fn check(session: &Session, program: &str, expected: Expect) {
    let recorded = record(session, "motor.clad", "what was done").unwrap();
    let mut shown = recorded.text.clone();
    for note in &recorded.notes {
        shown.push_str(&format!("note: {note}\n"));
    }
    expected.assert_eq(&shown);
    passes(&recorded, program);
}

/// The scenario is read without an error, and passes.
#[track_caller]
fn passes(recorded: &Recorded, program: &str) {
    let suite = parse(&recorded.text);
    assert_eq!(suite.errors, [], "{}", recorded.text);
    let interval = suite.interval.unwrap().0;
    let mut simulation = simulation_with(
        program,
        Options {
            interval,
            ..Options::default()
        },
    );
    let (cases, errors) = bind(&suite, &simulation);
    assert_eq!(errors, [], "{}", recorded.text);
    for case in &cases {
        let ran = run(case, &mut simulation, Simulation::scan);
        assert!(
            ran.passed(),
            "{:?}\n{}\n{program}",
            ran.differences,
            recorded.text
        );
    }
}

#[test]
fn what_was_pressed_and_what_came_of_it() {
    let mut session = session(MOTOR);
    scan(&mut session, 2);
    set(&mut session, "start", "1");
    scan(&mut session, 2);
    set(&mut session, "start", "0");
    scan(&mut session, 8);
    set(&mut session, "stop", "1");
    scan(&mut session, 2);
    check(
        &session,
        MOTOR,
        expect![[r#"
            program motor.clad
            step 10ms
            interval 10ms

            scenario "what was done"
            start    __--__________
            stop     ____________--
            warm  => _______-----__
            run   => __----------__
        "#]],
    );
    // Nothing but what was there at the beginning.
    session.reset();
    set(&mut session, "start", "1");
    scan(&mut session, 60);
    check(
        &session,
        MOTOR,
        expect![[r#"
            program motor.clad
            step 50ms
            interval 10ms

            scenario "what was done"
            start    ------------
            warm  => _-----------
            run   => ------------
        "#]],
    );
}

#[test]
fn values_of_all_types() {
    let text = "VAR_INPUT level : REAL; wait : TIME; n : INT; END_VAR\nVAR_OUTPUT name : STRING[20]; half : REAL; long : TIME; END_VAR\nVAR k : INT; END_VAR\n\
                +--[GT]( n, 3 )--[MOV]( name, 'it$'s # n' )--+\n+--[DIV]( half, level, 2.0 )--[MOV]( long, wait )--[ADD]( k, k, n )--+\n";
    let mut session = session(text);
    set(&mut session, "level", "3.5");
    set(&mut session, "wait", "T#1500ms");
    scan(&mut session, 2);
    set(&mut session, "n", "-7");
    scan(&mut session, 2);
    set(&mut session, "n", "4");
    set(&mut session, "k", "100");
    scan(&mut session, 2);
    check(
        &session,
        text,
        expect![[r#"
        program motor.clad
        step 20ms
        interval 10ms

        scenario "what was done"
        level    3.5 . .
        wait     T#1s500ms . .
        n        . -7 4
        k        . . 100
        name  => '' '' 'it$'s # n'
        half  => 1.75 1.75 1.75
        long  => T#1s500ms T#1s500ms T#1s500ms
    "#]],
    );
}

#[test]
fn stepping_back_records_up_to_there() {
    let mut session = session(MOTOR);
    set(&mut session, "start", "1");
    scan(&mut session, 3);
    set(&mut session, "stop", "1");
    scan(&mut session, 3);
    session.step_back(3);
    check(
        &session,
        MOTOR,
        expect![[r#"
            program motor.clad
            step 30ms
            interval 10ms

            scenario "what was done"
            start    -
            warm  => _
            run   => -
        "#]],
    );
}

#[test]
fn what_cannot_be_recorded_is_said() {
    let mut nothing = session(MOTOR);
    assert!(
        record(&nothing, "m", "n")
            .unwrap_err()
            .contains("nothing has run yet")
    );
    scan(&mut nothing, 1);
    assert!(record(&nothing, "m", "n").is_ok());
    let mut unkept = Session::of(simulation(MOTOR), HistoryLimits::of_scans(0));
    scan(&mut unkept, 4);
    assert!(
        record(&unkept, "m", "n")
            .unwrap_err()
            .contains("let `history` in ladder.toml be more than 0")
    );
    let mut begun = simulation(MOTOR);
    begun.scan();
    let mut late = Session::of(begun, HistoryLimits::default());
    scan(&mut late, 4);
    assert!(
        record(&late, "m", "n")
            .unwrap_err()
            .contains("began after the first scan")
    );
}

#[test]
fn more_values_than_are_kept_cannot_be_recorded_until_the_program_begins_again() {
    let mut session = Session::of(simulation(MOTOR), HistoryLimits::of_scans(3));
    for press in 0..=100_000 {
        set(&mut session, "start", if press % 2 == 0 { "1" } else { "0" });
        session.scan();
    }
    assert!(
        record(&session, "m", "n")
            .unwrap_err()
            .contains("more than 100000 values were given")
    );
    session.reset();
    scan(&mut session, 1);
    assert!(record(&session, "m", "n").is_ok());
}

#[test]
fn what_was_pressed_is_known_for_as_long_as_the_session_lasts() {
    let mut session = Session::of(simulation(MOTOR), HistoryLimits::of_scans(3));
    scan(&mut session, 1000);
    set(&mut session, "start", "1");
    scan(&mut session, 1000);
    set(&mut session, "start", "0");
    scan(&mut session, 3000);
    check(
        &session,
        MOTOR,
        expect![[r#"
            program motor.clad
            step 10s
            interval 10ms

            scenario "what was done"
            start    _-___
            warm  => _----
            run   => _----
        "#]],
    );
    // On another way what was given on the first one was not given.
    set(&mut session, "stop", "1");
    scan(&mut session, 2);
    session.step_back(2);
    set(&mut session, "start", "1");
    scan(&mut session, 5000);
    check(
        &session,
        MOTOR,
        expect![[r#"
            program motor.clad
            step 10s
            interval 10ms

            scenario "what was done"
            start    _-___-----
            warm  => _---------
            run   => _---------
        "#]],
    );
    let mut hour = Session::of(simulation(MOTOR), HistoryLimits::of_scans(3));
    scan(&mut hour, 7);
    set(&mut hour, "start", "1");
    scan(&mut hour, 60_000);
    let recorded = record(&hour, "motor.clad", "what was done").unwrap();
    assert_eq!(
        recorded.text.lines().last().unwrap().len(),
        "run   => ".len() + 60_007
    );
    passes(&recorded, MOTOR);
}

#[test]
fn forces_and_changes_are_played_as_inputs() {
    let mut session = session(MOTOR);
    let start = session.simulation().resolve("start").unwrap();
    session.force(&start, Value::Bool(true)).unwrap();
    scan(&mut session, 2);
    session.unforce_all();
    scan(&mut session, 2);
    check(
        &session,
        MOTOR,
        expect![[r#"
            program motor.clad
            step 20ms
            interval 10ms

            scenario "what was done"
            start    -_
            warm  => __
            run   => --
        "#]],
    );
    let run = session.simulation().resolve("run").unwrap();
    session.force(&run, Value::Bool(false)).unwrap();
    scan(&mut session, 4);
    check(
        &session,
        MOTOR,
        expect![[r#"
            program motor.clad
            step 20ms
            interval 10ms

            scenario "what was done"
            start    -___
            run      .._.
            warm  => ____
            run   => --__
        "#]],
    );
    let other = MOTOR.replace("T#50ms", "T#20ms");
    session.change(simulation(&other).program().clone()).unwrap();
    scan(&mut session, 2);
    check(
        &session,
        &other,
        expect![[r#"
            program motor.clad
            step 20ms
            interval 10ms

            scenario "what was done"
            start    -____
            run      .._..
            warm  => _-___
            run   => --___
            note: the program was changed, or tags were forced, while this was recorded: what is expected is what the program does now with the same inputs
        "#]],
    );
}

#[test]
fn whatever_is_pressed_the_scenario_passes() {
    for (number, text) in (1u64..).zip(programs()) {
        let mut numbers = Numbers(number * 31 + 5);
        let mut session = session(&text);
        for scan in 0..40 {
            if numbers.next().is_multiple_of(4) {
                give(&mut session, scan * 7 + number);
            }
            session.scan();
        }
        match record(&session, "program.clad", "random") {
            Ok(recorded) => passes(&recorded, &text),
            Err(why) => assert!(
                why.contains("no tag") || why.contains("first scan"),
                "{why}\n{text}"
            ),
        }
    }
}

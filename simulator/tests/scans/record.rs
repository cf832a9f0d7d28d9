//! What a person did, as a scenario.

use crate::change_and_back::{Numbers, give, programs};
use crate::support::{simulation, simulation_with};
use expect_test::{Expect, expect};
use ladder_analysis::values::value::Value;
use ladder_simulator::scenario::{self, Recorded, Wanted, Watched, bind, parse, run};
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

fn record(session: &Session, program: &str, name: &str) -> Result<Recorded, String> {
    let wanted = Wanted {
        program,
        name,
        outputs: None,
    };
    scenario::record(session, wanted)
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
        let ran = run(case, &mut Watched::default(), &mut simulation, Simulation::scan);
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
            time     . 550ms
            start    - -
            warm  => _ -
            run   => - -
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
            level    3.5     .       .
            wait     1s500ms .       .
            n        .       -7      4
            k        .       .       100
            name  => ''      ''      'it$'s # n'
            half  => 1.75    1.75    1.75
            long  => 1s500ms 1s500ms 1s500ms
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
            step 50ms
            interval 10ms

            scenario "what was done"
            time     10s . 9.95s 30s
            start    _   - -     _
            warm  => _   _ -     -
            run   => _   - -     -
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
            step 50ms
            interval 10ms

            scenario "what was done"
            time     10s . 9.95s 30s 50s
            start    _   - -     _   -
            warm  => _   _ -     -   -
            run   => _   - -     -   -
        "#]],
    );
    let mut hour = Session::of(simulation(MOTOR), HistoryLimits::of_scans(3));
    scan(&mut hour, 7);
    set(&mut hour, "start", "1");
    scan(&mut hour, 60_000);
    check(
        &hour,
        MOTOR,
        expect![[r#"
        program motor.clad
        step 10ms
        interval 10ms

        scenario "what was done"
        time     70ms 50ms 9m59s950ms
        start    _    -    -
        warm  => _    _    -
        run   => _    -    -
    "#]],
    );
}

/// A belt for a minute, with a box every six seconds: as people press, at any moment.
#[test]
fn a_minute_fits_on_a_screen() {
    let text = include_str!("../../../examples/conveyor.clad");
    let mut session = session(text);
    let mut give = |scans: usize, tag: &str, value: &str| {
        scan(&mut session, scans);
        set(&mut session, tag, value);
    };
    give(0, "stop", "1");
    give(123, "start", "1");
    give(31, "start", "0");
    for _ in 0..9 {
        give(437, "beam", "1");
        give(63, "beam", "0");
    }
    give(611, "stop", "0");
    scan(&mut session, 200);
    let wanted = Wanted {
        program: "conveyor.clad",
        name: "recorded",
        outputs: None,
    };
    let recorded = scenario::record(&session, wanted).unwrap();
    passes(&recorded, text);
    assert!(recorded.text.lines().count() <= 40, "{}", recorded.text);
    assert!(
        recorded.text.lines().all(|line| line.len() <= 80),
        "{}",
        recorded.text
    );
    expect![[r#"
        program conveyor.clad
        step 10ms
        interval 10ms

        scenario "recorded"
        time       1.23s 310ms 4.37s 630ms 4.37s 630ms 4.37s 630ms 4.37s 630ms 4.37s
        stop       -     -     -     -     -     -     -     -     -     -     -
        start      _     -     _     _     _     _     _     _     _     _     _
        beam       _     _     _     -     _     -     _     -     _     -     _
        belt    => _     -     -     -     -     -     -     -     -     -     -
        pusher  => _     _     _     _     _     _     _     _     _     _     _
        jam     => _     _     _     _     _     _     _     _     _     _     _
        running => _     -     -     -     -     -     -     -     -     -     -

        time       630ms 4.37s 630ms 2s 2.37s 630ms 4.37s 630ms 4.37s 630ms 6.11s 2s
        stop       -     -     -     -  -     -     -     -     -     -     -     _
        beam       -     _     -     _  _     -     _     -     _     -     _     _
        belt    => -     -     -     _  -     -     -     -     -     -     -     _
        pusher  => _     _     _     -  _     _     _     _     _     _     _     _
        jam     => _     _     _     _  _     _     _     _     _     _     _     _
        running => -     -     -     -  -     -     -     -     -     -     -     _
    "#]]
    .assert_eq(&recorded.text);
    let chosen = ["boxes.CV".to_owned(), "belt".to_owned()];
    let wanted = Wanted {
        outputs: Some(&chosen),
        ..wanted
    };
    let recorded = scenario::record(&session, wanted).unwrap();
    passes(&recorded, text);
    expect![[r#"
        program conveyor.clad
        step 10ms
        interval 10ms

        scenario "recorded"
        time        1.23s 310ms 4.37s 630ms 4.37s 630ms 4.37s 630ms 4.37s 630ms 4.37s
        stop        -     -     -     -     -     -     -     -     -     -     -
        start       _     -     _     _     _     _     _     _     _     _     _
        beam        _     _     _     -     _     -     _     -     _     -     _
        boxes.CV => 0     0     0     0     1     1     2     2     3     3     4
        belt     => _     -     -     -     -     -     -     -     -     -     -

        time        630ms 4.37s 630ms . 1.99s 2.37s 630ms 4.37s 630ms 4.37s 630ms 6.11s
        beam        -     _     -     _ _     _     -     _     -     _     -     _
        boxes.CV => 4     5     5     6 0     0     0     1     1     2     2     3
        belt     => -     -     -     _ _     -     -     -     -     -     -     -

        time        2s
        stop        _
        boxes.CV => 3
        belt     => _
    "#]]
    .assert_eq(&recorded.text);
    let none = scenario::record(
        &session,
        Wanted {
            outputs: Some(&[]),
            ..wanted
        },
    );
    assert!(none.unwrap_err().contains("choose one"));
    let unknown = ["bolt".to_owned()];
    let unknown = scenario::record(
        &session,
        Wanted {
            outputs: Some(&unknown),
            ..wanted
        },
    );
    assert!(unknown.unwrap_err().contains("did you mean belt"));
    let offered = scenario::recordable(&session);
    let names: Vec<&str> = offered.iter().map(|it| it.name.as_str()).collect();
    expect!["belt pusher jam running passed total boxes.Q boxes.CV push.Q push.ET blocked.Q blocked.ET"]
        .assert_eq(&names.join(" "));
}

/// A tag that changes in every scan does not make a column of each.
#[test]
fn a_tag_that_always_changes_makes_no_columns() {
    let text = "VAR_INPUT go : BOOL; END_VAR\nVAR_OUTPUT n : DINT; on : BOOL; END_VAR\n+--[ADD]( n, n, 1 )--+\n+--[ ]( go )--( )( on )--+\n";
    let mut session = session(text);
    scan(&mut session, 500);
    set(&mut session, "go", "1");
    scan(&mut session, 700);
    check(
        &session,
        text,
        expect![[r#"
        program motor.clad
        step 1s
        interval 10ms

        scenario "what was done"
        time    5s  7s
        go      _   -
        n    => 500 1200
        on   => _   -
    "#]],
    );
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

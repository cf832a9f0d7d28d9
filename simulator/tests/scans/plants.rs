//! Programs beside models of their machine: order, faults, ends, power, and what a session knows of both.

use crate::support::{get, set, simulation, trace};
use expect_test::expect;
use ladder_analysis::values::value::Value;
use ladder_analysis::{PlantFile, analyze, link_with_plants};
use ladder_simulator::scenario::{Wanted, passes, record};
use ladder_simulator::{HistoryLimits, Options, Session, Simulation};
use ladder_syntax::parse;
use std::sync::Arc;

/// A program beside a plant, which is called `plant`.
fn beside(program: &str, plant: &str) -> Simulation {
    connected(("own.clad", program), ("machine.clad", plant, "plant"), &[])
}

/// A program beside a plant, with what is connected by hand.
fn connected(
    (own, program): (&str, &str),
    (file, plant, name): (&str, &str, &str),
    connects: &[(String, String)],
) -> Simulation {
    let analysis = |text: &str, name: &str| Arc::new(analyze(&Arc::new(parse(text)), name));
    let plants = [PlantFile {
        analysis: analysis(plant, file),
        name: name.to_owned(),
    }];
    let own = analysis(program, own);
    let linked = link_with_plants(&own, &[], (&plants, connects), &|_| None);
    let (linked, errors) = linked.expect("both have no errors");
    assert_eq!(errors, []);
    Simulation::new(linked.program, Options::default()).expect("it compiles")
}

const FOLLOWS: &str = "VAR_INPUT seen : BOOL; END_VAR
VAR_OUTPUT moves : BOOL; END_VAR
VAR RETAIN n : INT; END_VAR
+--[/]( seen )--( )( moves )--+
+--[P]( moves )--[ADD]( n, n, 1 )--+
";

const MACHINE: &str = "VAR_INPUT moves : BOOL; END_VAR
VAR_OUTPUT seen : BOOL; END_VAR
VAR way, again : INT; END_VAR
+--[ ]( moves )--[ADD]( way, way, 1 )--+
+--[GE]( way, 3 )--( )( seen )--+
";

#[test]
fn a_plant_runs_first_on_what_the_program_left() {
    expect![[r#"
        moves       ---___
        plant.way   0 1 2 3 3 3
        seen        ___---
        plant.seen  ___---
        way         0 1 2 3 3 3
    "#]]
    .assert_eq(&trace(
        &mut beside(FOLLOWS, MACHINE),
        "6",
        "moves plant.way seen plant.seen way",
    ));
}

#[test]
fn an_end_in_a_plant_ends_the_plant_alone() {
    let machine = format!("{MACHINE}+--[EQ]( way, 2 )--<END>--+\n+--[ADD]( again, again, 1 )--+\n");
    expect![[r#"
        way    0 1 2 2 2 2
        again  1 2 2 2 2 2
        seen   ______
        moves  ------
    "#]]
    .assert_eq(&trace(
        &mut beside(FOLLOWS, &machine),
        "6",
        "way again seen moves",
    ));
}

#[test]
fn each_has_its_own_faults() {
    let machine = format!("{MACHINE}+--[EQ]( way, 2 )--[DIV]( again, again, 0 )--+\n");
    expect![[r#"
        way              0 1 2 3 3 3
        SYS.FAULT        ______
        plant.SYS.FAULT  ___-__
        scan 2 at 188: division by zero: nothing was written; check the divisor before this block
    "#]]
    .assert_eq(&trace(
        &mut beside(FOLLOWS, &machine),
        "6",
        "way SYS.FAULT plant.SYS.FAULT",
    ));
}

#[test]
fn what_is_retentive_is_there_when_the_power_comes_back() {
    expect![[r#"
        SYS.POWER       -__---
        moves           -__---
        n               1 1 1 2 2 2
        way             0 0 0 0 1 2
        SYS.SCAN        0 1 2 0 1 2
        SYS.FIRST_SCAN  -__-__
        plant.SYS.SCAN  0 1 2 3 4 5
    "#]]
    .assert_eq(&trace(
        &mut beside(FOLLOWS, MACHINE),
        "SYS.POWER -__---",
        "SYS.POWER moves n way SYS.SCAN SYS.FIRST_SCAN plant.SYS.SCAN",
    ));
    let alone = "VAR RETAIN n : INT; END_VAR\nVAR m : INT; t : TON; END_VAR
+--[ADD]( n, n, 1 )--[ADD]( m, m, 1 )--+
+--[TON]( t, 30ms )--+
+--[PERSIST]( t )--+
";
    expect![[r#"
        n         1 2 3 3 3 3 4 5 6
        m         1 2 3 0 0 0 1 2 3
        t.ET      0 10 20 20 20 20 30 30 30
        t.Q       ______---
        SYS.SCAN  0 1 2 3 4 5 0 1 2
        SYS.TIME  0 10 20 30 40 50 0 10 20
    "#]]
    .assert_eq(&trace(
        &mut simulation(alone),
        "SYS.POWER ---___---",
        "n m t.ET t.Q SYS.SCAN SYS.TIME",
    ));
}

#[test]
fn what_the_plant_drives_is_held_when_it_is_given() {
    let mut simulation = beside(FOLLOWS, MACHINE);
    set(&mut simulation, "seen", "1");
    simulation.scan();
    assert_eq!(
        (get(&simulation, "seen"), get(&simulation, "plant.seen")),
        ("1".into(), "0".into())
    );
    let seen = simulation.resolve("seen").unwrap();
    simulation.unforce(&seen);
    simulation.scan();
    assert_eq!(get(&simulation, "seen"), "0");
}

#[test]
fn a_session_steps_back_in_both_and_says_why_through_the_connection() {
    let mut session = Session::of(beside(FOLLOWS, MACHINE), HistoryLimits::default());
    for _ in 0..6 {
        session.scan();
    }
    let moves = session.simulation().resolve("moves").unwrap();
    let seen = session.simulation().resolve("seen").unwrap();
    expect![[r#"
        moves is 0 since scan 3 (30 ms): line 4, ( )( moves ) wrote it; blocked by [/]( seen ) (line 4, column 4): seen is 1
          seen is 1 since scan 3 (30 ms): line 2, seen wrote it (plant.seen is 1); power came straight from the rail
            plant.seen is 1 since scan 3 (30 ms): line 5, ( )( seen ) wrote it; power came through [GE]( way, 3 ) (line 5, column 4): plant.way is 3
              plant.way is 3 since scan 3 (30 ms): line 4, [ADD]( way, way, 1 ) wrote it; power came through [ ]( moves ) (line 4, column 4): plant.moves is 1
                plant.moves is 1 since scan 1 (10 ms): line 1, moves wrote it (moves is 1); power came straight from the rail"#]].assert_eq(&session.why(&moves).text(&[FOLLOWS, MACHINE], &[]));
    expect![[r#"
        seen is 1 since scan 3 (30 ms): line 2, seen wrote it (plant.seen is 1); power came straight from the rail
          plant.seen is 1 since scan 3 (30 ms): line 5, ( )( seen ) wrote it; power came through [GE]( way, 3 ) (line 5, column 4): plant.way is 3
            plant.way is 3 since scan 3 (30 ms): line 4, [ADD]( way, way, 1 ) wrote it; power came through [ ]( moves ) (line 4, column 4): plant.moves is 1
              plant.moves is 1 since scan 1 (10 ms): line 1, moves wrote it (moves is 1); power came straight from the rail
                moves is 1 since scan 0 (0 ms): line 4, ( )( moves ) wrote it; power came through [/]( seen ) (line 4, column 4): seen is 0"#]].assert_eq(&session.why(&seen).text(&[FOLLOWS, MACHINE], &[]));
    session.step_back(4);
    assert_eq!(get(session.simulation(), "way"), "1");
    session.warm_restart();
    let both = |session: &Session| [get(session.simulation(), "way"), get(session.simulation(), "n")];
    assert_eq!(both(&session), ["1", "1"]);
    session.scan();
    session.scan();
    assert_eq!(both(&session), ["2", "2"]);
    session.step_back(3);
    assert_eq!(
        (session.simulation().scans(), both(&session)),
        (2, ["1".to_owned(), "1".to_owned()])
    );
}

#[test]
fn a_recording_has_the_plant() {
    let program = FOLLOWS
        .replace("seen : BOOL", "at_end, stop : BOOL")
        .replace("[/]( seen )", "[/]( at_end )--[/]( stop )");
    let connects = [("machine.seen".to_owned(), "at_end".to_owned())];
    for (own, file) in [
        ("own.clad", "machine.clad"),
        ("press/own.clad", "press/machine.clad"),
        ("press/left/own.clad", "press/models/machine.clad"),
    ] {
        let simulation = connected((own, &program), (file, MACHINE, "machine"), &connects);
        let mut session = Session::of(simulation, HistoryLimits::default());
        session.scan();
        for (tag, value) in [
            ("stop", Some(true)),
            ("at_end", Some(true)),
            ("stop", Some(false)),
            ("at_end", None),
            // As it is anyway.
            ("at_end", Some(false)),
            ("at_end", None),
        ] {
            let point = session.simulation().resolve(tag).unwrap();
            match value {
                Some(value) => session.set(&point, Value::Bool(value)).unwrap(),
                None => session.unforce(&point),
            }
            session.scan();
        }
        session.warm_restart();
        for _ in 0..4 {
            session.scan();
        }
        let wanted = Wanted {
            program: "own.clad",
            name: "to the end",
            outputs: None,
        };
        let recorded = record(&session, wanted).unwrap();
        assert!(passes(&session, &recorded), "{}", recorded.text);
        let shown = format!("{}{}\n", recorded.text, recorded.notes.join("\n"));
        if own == "own.clad" {
            expect![[r#"
                program own.clad
                plant machine.clad as machine
                connect machine.seen = at_end
                step 10ms
                interval 10ms

                scenario "to the end"
                stop         _--_________
                at_end       ..-.~_~.....
                SYS.POWER    -------_----
                moves     => -___--______

            "#]]
            .assert_eq(&shown);
        } else {
            let plant = shown.lines().nth(1).unwrap();
            let wanted = if own.contains("left") {
                "plant ../models/machine.clad as machine"
            } else {
                "plant machine.clad as machine"
            };
            assert_eq!(plant, wanted);
        }
    }
}

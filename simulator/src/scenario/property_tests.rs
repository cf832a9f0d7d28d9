//! Properties as texts: what is read, what is reported, and what runs violate.

use super::{bind_properties, parse};
use crate::expression::Expression;
use crate::simulation::{Options, Simulation};
use expect_test::{Expect, expect};
use ladder_analysis::values::value::Value;
use std::sync::Arc;

const DOOR: &str = "\
VAR_INPUT start, stop : BOOL; level : INT; END_VAR
VAR_OUTPUT up, down : BOOL; END_VAR
VAR wait : TON; END_VAR
+--[ ]( start )--[/]( stop )--( )( up )--+
+--[ ]( stop )--[TON]( wait, T#50ms )--( )( down )--+
+--[ ]( down )--[DIV]( level_2, 100, level )--+
";

fn simulation() -> Simulation {
    let analysis = ladder_analysis::analyze(&Arc::new(ladder_syntax::parse(DOOR)), "door.clad");
    let program = analysis.program().cloned().expect("it has no errors");
    Simulation::new(program, Options::default()).expect("it compiles")
}

fn check(properties: &str, expected: Expect) {
    let text = format!("program door.clad\n{properties}");
    let suite = parse(&text);
    let (watched, errors) = bind_properties(&suite, &simulation());
    let mut out = String::new();
    for error in suite.errors.iter().chain(&errors) {
        let help = error.help.as_deref().unwrap_or("-");
        out.push_str(&format!("`{}`: {}; {help}\n", &text[error.range], error.message));
    }
    for written in &suite.assumptions {
        out.push_str(&format!("assume {}\n", written.text));
    }
    for property in &suite.properties {
        let form = property
            .form
            .try_map(|written| Ok::<_, ()>(written.text.as_str()));
        out.push_str(&format!(
            "{} | {:?}\n",
            property.name,
            form.expect("it is the same")
        ));
    }
    assert_eq!(watched.properties.len() + errors.len(), suite.properties.len());
    expected.assert_eq(&out);
}

#[test]
fn forms_are_read() {
    check(
        "assume not (start and stop) # a comment\nproperty \"apart\"\nnever up and down\nalways level >= 16#0A\n\
         property \"on\" when rises(start): up until stop\nafter stop: not up\n\
         within 500ms of was(level) > 5: up or down\nwithin 1 scan of start: up\npossible up within 3 scans\nno faults\n\
         when start: wait.Q = (level = 3)\nscenario \"x\"\nstart _-\nup => _-\nnever down and start # last\n",
        expect![[r#"
            assume not (start and stop)
            apart | Never("up and down")
            always level >= 16#0A | Always("level >= 16#0A")
            on | When { condition: "rises(start)", then: "up", until: Some("stop") }
            after stop: not up | After { condition: "stop", then: "not up" }
            within 500ms of was(level) > 5: up or down | Within { span: Time(500000000), condition: "was(level) > 5", then: "up or down" }
            within 1 scan of start: up | Within { span: Scans(1), condition: "start", then: "up" }
            possible up within 3 scans | Possible { what: "up", within: Some(Scans(3)) }
            no faults | NoFaults
            when start: wait.Q = (level = 3) | When { condition: "start", then: "wait.Q = (level = 3)", until: None }
            never down and start | Never("down and start")
        "#]],
    );
}

#[test]
fn errors_have_their_places() {
    check(
        "property \"empty\"\nproperty \"open\nnever up and\nnever nothing\nwhen start up\nwithin soon of start: up\nalways level\n\
         never up down\npossible rises(level)\nnever was(up, down)\nproperty \"last\"\n",
        expect![[r#"
            `"empty"`: the property "empty" says nothing; say below it what must hold, as in: never up and down
            `"open`: the quote after the name is missing; write it as in: property "the contactors exclude each other"
            `up`: a colon is missing here; write it as in: when jam: not running
            `soon of start: up`: how long it may take is missing here; write a time or a number of scans, as in: within 500ms of start: run
            `down`: `down` does not belong here; the property ends before it
            `"last"`: the property "last" says nothing; say below it what must hold, as in: never up and down
            `up and`: a value is missing next to this operator; -
            `nothing`: there is no tag `nothing` in this program; -
            `level`: a condition is TRUE or FALSE, and this is of type INT; -
            `rises(level)`: a condition is TRUE or FALSE, and this is of type INT; -
            `was(up, down)`: `was(up, down)` takes one expression, as in: was(level > 5); -
            never up and | Never("up and")
            never nothing | Never("nothing")
            always level | Always("level")
            possible rises(level) | Possible { what: "rises(level)", within: None }
            never was(up, down) | Never("was(up, down)")
        "#]],
    );
}

/// In which scans a run violates a property. `level` is 0 in the fourth scan.
fn violated(property: &str, start: &str, stop: &str) -> Vec<usize> {
    let suite = parse(&format!("program door.clad\n{property}\n"));
    let mut simulation = simulation();
    let (mut watched, errors) = bind_properties(&suite, &simulation);
    assert_eq!((&*suite.errors, &*errors), (&[][..], &[][..]));
    let monitor = &mut watched.properties[0];
    monitor.restart();
    let points = ["start", "stop", "level"].map(|name| simulation.resolve(name).expect(name));
    let levels = start.bytes().zip(stop.bytes()).enumerate();
    let violated = levels.filter(|&(scan, (start, stop))| {
        let values = [
            Value::Bool(start == b'-'),
            Value::Bool(stop == b'-'),
            Value::Int(i64::from(scan != 3)),
        ];
        for (point, value) in points.iter().zip(values) {
            simulation.set(point, value).expect("it fits");
        }
        simulation.scan();
        let faulted = !simulation.take_faults().is_empty();
        monitor.violates(&simulation, faulted)
    });
    violated.map(|(scan, _)| scan).collect()
}

#[test]
fn runs_are_watched() {
    let nothing: [usize; 0] = [];
    assert_eq!(violated("never up", "_-_-", "____"), [1, 3]);
    assert_eq!(violated("always start = up", "_---", "__--"), [2, 3]);
    assert_eq!(violated("when start: up", "-_-_", "_-__"), nothing);
    assert_eq!(violated("when start: up until stop", "-____", "___-_"), [1, 2]);
    assert_eq!(violated("after start: up", "-_--_", "_____"), [1, 4]);
    assert_eq!(
        violated("within 2 scans of start: stop", "-____", "__-__"),
        nothing
    );
    assert_eq!(violated("within 2 scans of start: stop", "-____", "___-_"), [2]);
    assert_eq!(violated("within 25ms of start: stop", "-____", "___-_"), [2]);
    assert_eq!(
        violated("within 0 scans of start: stop", "-____", "_____"),
        [0, 1, 2, 3, 4]
    );
    assert_eq!(violated("never rises(start)", "--_-", "____"), [0, 3]);
    assert_eq!(violated("never falls(start)", "--_-", "____"), [2]);
    assert_eq!(violated("always was(level) = level", "____", "____"), [0, 3]);
    // A fault makes an expression FALSE.
    assert_eq!(violated("always 10 / level > 1", "____", "____"), [3]);
    assert_eq!(violated("no faults", "__________", "----------"), nothing);
}

const CELLS: &str = "\
TYPE
    Mode : (OFF, HEAT := 5, COOL);
    Cell : STRUCT
        mode : Mode;
        temp : INT := 20;
        wait : TON;
    END_STRUCT;
END_TYPE
VAR_INPUT k : INT; mode : Mode; END_VAR
VAR cells : ARRAY[1..2] OF Cell; grid : ARRAY[0..1, 0..2] OF INT := [1, 2, 3, 4, 5, 6]; END_VAR
+--[MOV]( cells[2].mode, mode )--[MOV]( cells[2].temp, k )--+
+--[EQ]( mode, HEAT )--[TON]( cells[1].wait, 10ms )--+
+--[TON]( cells[2].wait, 0s )--+
";

/// For each condition in which scans of a run it holds: `k` is 1, 2, 1, and `mode` is off, heat, heat.
fn holds(conditions: &[&str]) -> String {
    let analysis = ladder_analysis::analyze(&Arc::new(ladder_syntax::parse(CELLS)), "cells.clad");
    let program = analysis.program().cloned().expect("it has no errors");
    let mut simulation = Simulation::new(program, Options::default()).expect("it compiles");
    let [k, mode] = ["k", "mode"].map(|name| simulation.resolve(name).expect(name));
    let mut out = String::new();
    for condition in conditions {
        let mut compiled = match Expression::condition(condition, &simulation) {
            Ok(compiled) => compiled,
            Err(problem) => {
                out.push_str(&format!("{condition}: {problem}\n"));
                continue;
            }
        };
        simulation.reset();
        let scans = [(1, 0), (2, 5), (1, 5)].map(|values| {
            simulation.set(&k, Value::Int(values.0)).expect("it fits");
            simulation.set(&mode, Value::Int(values.1)).expect("it fits");
            simulation.scan();
            match compiled.holds(&simulation) {
                Ok(true) => '-',
                Ok(false) => '_',
                Err(_) => '?',
            }
        });
        out.push_str(&format!("{condition}: {}\n", scans.iter().collect::<String>()));
    }
    out
}

#[test]
fn enumerations_and_computed_indices() {
    expect![[r#"
        mode = HEAT: _--
        mode = Mode.heat: _--
        mode <> OFF and was(mode) = OFF: _-_
        rises(mode = HEAT): _-_
        cells[k].mode = HEAT: _-_
        cells[k].mode = mode: --_
        cells[k + 1].temp = 1: -?-
        cells[k].wait.Q: _--
        cells[k].wait.ET = T#10ms: __-
        grid[k, 2] = 6: -?-
        grid[k - 1, k] = 2: -_-
        SUM(grid[0, k..2]) = 5: -_-
        MAX(grid[k - 1, 0], grid[0, k]) = 4: _-_
    "#]]
    .assert_eq(&holds(&[
        "mode = HEAT",
        "mode = Mode.heat",
        "mode <> OFF and was(mode) = OFF",
        "rises(mode = HEAT)",
        "cells[k].mode = HEAT",
        "cells[k].mode = mode",
        "cells[k + 1].temp = 1",
        "cells[k].wait.Q",
        "cells[k].wait.ET = T#10ms",
        "grid[k, 2] = 6",
        "grid[k - 1, k] = 2",
        "SUM(grid[0, k..2]) = 5",
        "MAX(grid[k - 1, 0], grid[0, k]) = 4",
    ]));
}

#[test]
fn what_is_wrong_with_values_and_conditions_is_said() {
    expect![[r#"
        HEAT: `HEAT` is a value of Mode, and nothing here asks for one; compare a tag with it, as in: tag = Mode.HEAT
        mode: a condition is TRUE or FALSE, and this is of type Mode
        mode > HEAT: values of Mode are equal or not: none is greater than another
        mode = WARM: there is no tag `WARM` in this program
        mode = Mode.WARM: Mode has no value `WARM`: its values are OFF HEAT COOL
        k = HEAT: `HEAT` is a value of Mode, and nothing here asks for one; compare a tag with it, as in: tag = Mode.HEAT
        k = TRUE: INT and BOOL cannot be compared
        cells[k].speed = 1: cells has parts: name one of them, as in cells[1].mode
        cells[k] = cells[1]: cells has parts: name one of them, as in cells[1].mode
        grid[k] = 1: grid has parts: name one of them, as in grid[0, 0]
        not k: a condition is TRUE or FALSE, and this is of type INT
    "#]]
    .assert_eq(&holds(&[
        "HEAT",
        "mode",
        "mode > HEAT",
        "mode = WARM",
        "mode = Mode.WARM",
        "k = HEAT",
        "k = TRUE",
        "cells[k].speed = 1",
        "cells[k] = cells[1]",
        "grid[k] = 1",
        "not k",
    ]));
}

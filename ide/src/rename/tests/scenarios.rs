//! The rows of scenarios.

use super::{check, renamed};
use crate::fixture::played;
use expect_test::expect;

#[test]
fn scenarios_follow() {
    let plant = "%% lib.clad\nVAR_GLOBAL total : DINT; END_VAR\n+--<FUN>( f )--( )( lamp )--+\n\
        %% main.clad\n+--[ ]( start )-------<CALL>( f )--[TON]( t, 5s )--( )( run )--+\n\
        %% motor.ladder-test\nprogram main.clad\nstep 100ms\n\nscenario \"starts\"\nstart     _-_\nrun    => _--\nt.ET   => 0s 1s 2s\n\
        lib.lamp => _-_\n\nscenario \"other\"\ntotal => 1 2 3\n\
        %% other.ladder-test\nprogram other.clad\nscenario \"x\"\nrun => _-\n";
    let at = |place: &str| plant.replacen(place, &format!("{place}$0"), 1);
    check(
        &at("( )( run"),
        "motor_runs",
        expect![[r#"
        %% main.clad
        +--[ ]( start )----------------<CALL>( f )--[TON]( t, 5s )--( )( motor_runs )--+
        %% motor.ladder-test
        program main.clad
        step 100ms

        scenario "starts"
        start         _-_
        motor_runs => _--
        t.ET       => 0s 1s 2s
        lib.lamp     => _-_

        scenario "other"
        total => 1 2 3
    "#]],
    );
    check(
        &at("[TON]( t"),
        "q",
        expect![[r#"
        %% main.clad
        +--[ ]( start )-------<CALL>( f )--[TON]( q, 5s )--( )( run )--+
        %% motor.ladder-test
        program main.clad
        step 100ms

        scenario "starts"
        start     _-_
        run    => _--
        q.ET   => 0s 1s 2s
        lib.lamp => _-_

        scenario "other"
        total => 1 2 3
    "#]],
    );
    check(
        &at("( )( lamp"),
        "l",
        expect![[r#"
            %% lib.clad
            VAR_GLOBAL total : DINT; END_VAR
            +--<FUN>( f )--------------------------------------------------------( )( l )--+
            %% motor.ladder-test
            program main.clad
            step 100ms

            scenario "starts"
            start     _-_
            run    => _--
            t.ET   => 0s 1s 2s
            lib.l    => _-_

            scenario "other"
            total => 1 2 3
        "#]],
    );
    check(
        &at("VAR_GLOBAL total"),
        "a_longer_name",
        expect![[r#"
        %% lib.clad
        VAR_GLOBAL a_longer_name : DINT; END_VAR
        +--<FUN>( f )--( )( lamp )--+
        %% motor.ladder-test
        program main.clad
        step 100ms

        scenario "starts"
        start     _-_
        run    => _--
        t.ET   => 0s 1s 2s
        lib.lamp => _-_

        scenario "other"
        a_longer_name => 1 2 3
    "#]],
    );
}

const CELLS: &str = r#"%% main.clad
TYPE
    Phase : (IDLE, FILLING := 3, FULL);
    Valve : STRUCT
        open : BOOL;
        wait : TON;
    END_STRUCT;
    Zone : STRUCT
        valve : Valve;
        phase : Phase;
    END_STRUCT;
    Cell : STRUCT
        zone  : ARRAY[1..2] OF Zone;
        drive : $Motor;
    END_STRUCT;
END_TYPE

FUNCTION_BLOCK [$Motor]
VAR_INPUT
    start : BOOL;
END_VAR
VAR_OUTPUT
    running : BOOL;
END_VAR
VAR
    turns : DINT;
END_VAR
+--[ ]( start )--\-----------------------( )( running )--+
|                /--[ADD]( turns, turns, 1 )--( )( ENO )--+
END_FUNCTION_BLOCK

VAR
    cell  : ARRAY[1..3] OF Cell;
    drive : $Motor;
    go    : BOOL;
    step  : Phase;
END_VAR

+--[ ]( go )--\--( )( cell[2].zone[1].valve.open )----------+
|             /--[MOV]( cell[2].zone[1].phase, FILLING )----+
+--[ ]( go )--[MOV]( step, Phase.FILLING )--+
+--[$Motor]( drive, go )--[$Motor]( cell[1].drive, go )--[$Motor]( go )--( )( on )--+
%% cells.ladder-test
program main.clad

scenario "all that has a name"
go                                _      -
cell[ 2 ].zone[1].valve.open => _      -
cell[2].zone[1].phase        => IDLE   FILLING
step                            => idle   Phase.filling
drive.running                   => _      -
drive.turns                     => 0      1
cell[1].drive.turns          => 0      1
$Motor#1.turns                  => 0      1

scenario "in columns"
go      _    -
step => IDLE FILLING
"#;

/// Whatever is renamed, the scenarios hold: they name all that can be named.
#[test]
fn types_members_values_and_instances() {
    const SECOND: &str = "%% cells.ladder-test\n";
    let split = |text: &str| {
        // What is named in no scenario changes none.
        let (program, scenarios) = text.split_once(SECOND).unwrap_or((text, ""));
        (program.replacen("%% main.clad\n", "", 1), scenarios.to_owned())
    };
    let (program, scenarios) = split(CELLS);
    assert_eq!(
        played(&program, &scenarios),
        "ok all that has a name\nok in columns\n"
    );
    let mut shown = String::new();
    for (place, new) in [
        ("    Phase", "State"),
        ("(IDLE, FILLING", "FILLS"),
        ("    Valve", "Tap"),
        ("        open", "is_open"),
        ("        zone", "part"),
        ("        drive", "motor"),
        ("    running", "on"),
        ("    turns", "rounds"),
        ("BLOCK [$Motor", "$Engine"),
        ("    cell", "c"),
        ("    drive : $Motor;\n    go", "m1"),
    ] {
        let at = CELLS.find(place).expect("a place") + place.len();
        let at = if place.ends_with("go") {
            at - ": $Motor;\n    go ".len()
        } else {
            at
        };
        let mut marked = CELLS.to_owned();
        marked.insert_str(at, "$0");
        let (program, mut scenarios) = split(&renamed(&marked, new));
        let (_, before) = split(CELLS);
        if scenarios.is_empty() {
            scenarios.clone_from(&before);
        }
        assert_eq!(
            played(&program, &scenarios),
            "ok all that has a name\nok in columns\n",
            "{place} -> {new}\n{program}\n{scenarios}"
        );
        shown.push_str(&format!("{} -> {new}\n", place.trim()));
        for (old, line) in before.lines().zip(scenarios.lines()) {
            let squeezed = |line: &str| line.split_whitespace().collect::<Vec<_>>().join(" ");
            if squeezed(old) != squeezed(line) {
                shown.push_str(&format!("    {line}\n"));
            }
        }
    }
    let expected = expect![[r#"
        Phase -> State
            step                            => idle   State.filling
        (IDLE, FILLING -> FILLS
            cell[2].zone[1].phase        => IDLE   FILLS
            step                            => idle   Phase.FILLS
            step => IDLE FILLS
        Valve -> Tap
        open -> is_open
            cell[ 2 ].zone[1].valve.is_open => _      -
        zone -> part
            cell[ 2 ].part[1].valve.open => _      -
            cell[2].part[1].phase        => IDLE   FILLING
        drive -> motor
            cell[1].motor.turns          => 0      1
        running -> on
            drive.on                        => _      -
        turns -> rounds
            drive.rounds                    => 0      1
            cell[1].drive.rounds         => 0      1
            $Motor#1.rounds                 => 0      1
        BLOCK [$Motor -> $Engine
            $Engine#1.turns                 => 0      1
        cell -> c
            c[ 2 ].zone[1].valve.open    => _      -
            c[2].zone[1].phase           => IDLE   FILLING
            c[1].drive.turns             => 0      1
        drive : $Motor;
            go -> m1
            m1.running                      => _      -
            m1.turns                        => 0      1
    "#]];
    expected.assert_eq(&shown);
}

/// The type is in one file, the scenarios are about another.
#[test]
fn members_of_types_in_other_files() {
    check(
        "%% types.clad\nTYPE\n    Valve : STRUCT\n        op$0en : BOOL;\n    END_STRUCT;\nEND_TYPE\n\
         %% main.clad\nVAR v : Valve; END_VAR\n+--[ ]( a )--( )( v.open )--+\n\
         %% a.ladder-test\nprogram main.clad\nscenario \"x\"\na         _-\nv.open => _-\n\
         %% other.clad\nVAR v : BOOL; END_VAR\n+--[ ]( a )--( )( v )--+\n\
         %% b.ladder-test\nprogram other.clad\nscenario \"open\"\nv => _-\n",
        "on",
        expect![[r#"
            %% types.clad
            TYPE
                Valve : STRUCT
                    on : BOOL;
                END_STRUCT;
            END_TYPE
            %% main.clad
            VAR v : Valve; END_VAR
            +--[ ]( a )-------------------------------------------------------( )( v.on )--+
            %% a.ladder-test
            program main.clad
            scenario "x"
            a         _-
            v.on   => _-
        "#]],
    );
}

/// What was connected by its name stays connected, and nothing else becomes so.
#[test]
fn plants_stay_connected() {
    let machine = "%% main.clad\nVAR_INPUT level, near : BOOL; END_VAR\nVAR_OUTPUT pump, lamp : BOOL; END_VAR\n+--[ ]( level )--[ ]( near )--( )( pump )--+\n\
        %% tank.clad\nVAR_INPUT pump, stop : BOOL; END_VAR\nVAR_OUTPUT level, sensor : BOOL; END_VAR\n+--[ ]( pump )--[/]( stop )--( )( level )--+\n\
        %% main.ladder-test\nprogram main.clad\nplant tank.clad as tank # the tank\nconnect tank.sensor = near\n\nscenario \"fills\"\ntank.level => _-\n\
        %% alone.ladder-test\nprogram main.clad\n\nscenario \"alone\"\npump => _-\n";
    let at = |place: &str| machine.replacen(place, &format!("{place}$0"), 1);
    check(
        &at("( )( pump"),
        "motor",
        expect![[r#"
        %% main.clad
        VAR_INPUT level, near : BOOL; END_VAR
        VAR_OUTPUT motor, lamp : BOOL; END_VAR
        +--[ ]( level )--[ ]( near )-------------------------------------( )( motor )--+
        %% main.ladder-test
        program main.clad
        plant tank.clad as tank # the tank
        connect tank.sensor = near
        connect tank.pump = motor

        scenario "fills"
        tank.level => _-
        %% alone.ladder-test
        program main.clad

        scenario "alone"
        motor => _-
    "#]],
    );
    check(
        &at("[ ]( near"),
        "close",
        expect![[r#"
        %% main.clad
        VAR_INPUT level, close : BOOL; END_VAR
        VAR_OUTPUT pump, lamp : BOOL; END_VAR
        +--[ ]( level )--[ ]( close )-------------------------------------( )( pump )--+
        %% main.ladder-test
        program main.clad
        plant tank.clad as tank # the tank
        connect tank.sensor = close

        scenario "fills"
        tank.level => _-
    "#]],
    );
    check(
        &at("( )( level"),
        "height",
        expect![[r#"
        %% tank.clad
        VAR_INPUT pump, stop : BOOL; END_VAR
        VAR_OUTPUT height, sensor : BOOL; END_VAR
        +--[ ]( pump )--[/]( stop )-------------------------------------( )( height )--+
        %% main.ladder-test
        program main.clad
        plant tank.clad as tank # the tank
        connect tank.sensor = near
        connect tank.height = level

        scenario "fills"
        tank.height => _-
    "#]],
    );
    check(
        &at("VAR_OUTPUT pump, lamp"),
        "stop",
        expect![[r#"
        refused: tank.clad has a tag `stop`, too, with which it would be connected as a plant
    "#]],
    );
    check(
        &at("VAR_OUTPUT pump, lamp"),
        "sensor",
        expect![[r#"
        %% main.clad
        VAR_INPUT level, near : BOOL; END_VAR
        VAR_OUTPUT pump, sensor : BOOL; END_VAR
        +--[ ]( level )--[ ]( near )--( )( pump )--+
    "#]],
    );
}

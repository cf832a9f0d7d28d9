//! Types, their members and values.

use super::check;
use expect_test::{Expect, expect};

const TYPES: &str = "TYPE\n    Phase : (IDLE, FILLING, MIXING := 10);\n    Motor : STRUCT\n        speed   : REAL;\n        running : BOOL;\n        delay   : TON;\n    END_STRUCT;\nEND_TYPE\n\nVAR\n    pump  : Motor := (speed := 20.0);\n    lines : ARRAY[1..4] OF Motor;\n    step  : Phase := FILLING;\n    k     : INT;\nEND_VAR\n\n";

#[test]
fn types_members_and_values() {
    let check = |rest: &str, new: &str, expected: Expect| check(&format!("{TYPES}{rest}"), new, expected);
    let rungs = |cursor: &str| {
        let text = "+--[ ]( pump.running )--[EQ]( step, FILLING )--[MOV]( step, Phase.MIXING )--( )( lines[k].running )--+\n";
        text.replacen(cursor, &format!("{cursor}$0"), 1)
    };
    check(
        &rungs("pump.running"),
        "is_on",
        expect![[r#"
        TYPE
            Phase : (IDLE, FILLING, MIXING := 10);
            Motor : STRUCT
                speed : REAL;
                is_on : BOOL;
                delay : TON;
            END_STRUCT;
        END_TYPE

        VAR
            pump  : Motor := (speed := 20.0);
            lines : ARRAY[1..4] OF Motor;
            step  : Phase := FILLING;
            k     : INT;
        END_VAR

        +--[ ]( pump.is_on )--[EQ]( step, FILLING )----[MOV]( step, Phase.MIXING )--( )( lines[k].is_on )--+
    "#]],
    );
    check(
        &rungs("step, FILLING"),
        "FULL",
        expect![[r#"
        TYPE
            Phase : (IDLE, FULL, MIXING := 10);
            Motor : STRUCT
                speed   : REAL;
                running : BOOL;
                delay   : TON;
            END_STRUCT;
        END_TYPE

        VAR
            pump  : Motor := (speed := 20.0);
            lines : ARRAY[1..4] OF Motor;
            step  : Phase := FULL;
            k     : INT;
        END_VAR

        +--[ ]( pump.running )--[EQ]( step, FULL )---[MOV]( step, Phase.MIXING )--( )( lines[k].running )--+
    "#]],
    );
    check(
        &rungs("step, Phase"),
        "State",
        expect![[r#"
        TYPE
            State : (IDLE, FILLING, MIXING := 10);
            Motor : STRUCT
                speed   : REAL;
                running : BOOL;
                delay   : TON;
            END_STRUCT;
        END_TYPE

        VAR
            pump  : Motor := (speed := 20.0);
            lines : ARRAY[1..4] OF Motor;
            step  : State := FILLING;
            k     : INT;
        END_VAR

        +--[ ]( pump.running )--[EQ]( step, FILLING )--[MOV]( step, State.MIXING )--( )( lines[k].running )--+
    "#]],
    );
    check(
        &rungs("step, FILLING"),
        "idle",
        expect![[r#"
        refused: there is a member `idle` on line 2 of main.clad already: both would become one
    "#]],
    );
    check(
        &rungs("step, FILLING"),
        "k",
        expect![[r#"
        refused: there is a tag `k` on line 14 of main.clad already: both would become one
    "#]],
    );
    check(
        &rungs("pump.running"),
        "speed",
        expect![[r#"
        refused: there is a member `speed` on line 4 of main.clad already: both would become one
    "#]],
    );
}

#[test]
fn types_of_other_files() {
    check(
        "%% types.clad\nTYPE\n    Motor : STRUCT\n        on$0 : BOOL;\n    END_STRUCT;\nEND_TYPE\n%% main.clad\nVAR\n    m : Motor := (on := TRUE);\nEND_VAR\n+--[ ]( m.on )--( )( Q1 )--+\n",
        "running",
        expect![[r#"
            %% types.clad
            TYPE
                Motor : STRUCT
                    running : BOOL;
                END_STRUCT;
            END_TYPE
            %% main.clad
            VAR
                m : Motor := (running := TRUE);
            END_VAR
            +--[ ]( m.running )-------------------------------------------------( )( Q1 )--+
        "#]],
    );
}

#[test]
fn a_type_may_have_the_name_of_a_tag() {
    let text = |rung: &str| {
        format!("TYPE\n    Ph$0ase : (A, B);\nEND_TYPE\nVAR\n    step : Phase;\nEND_VAR\n{rung}\n")
    };
    check(
        &text("+--[EQ]( step, B )--( )( Q1 )--+"),
        "Step",
        expect![[r#"
        TYPE
            Step : (A, B);
        END_TYPE
        VAR
            step : Step;
        END_VAR
        +--[EQ]( step, B )--( )( Q1 )--+
    "#]],
    );
    // But where a value is written with its type, the tag comes first.
    check(
        &text("+--[EQ]( step, Phase.B )--( )( Q1 )--+"),
        "Step",
        expect![[r#"
        refused: there is a tag `Step` on line 5 of main.clad already: both would become one
    "#]],
    );
}

//! Whole files: declarations, units and charts.

use super::check_file;
use crate::read::dialect::Dialect;
use crate::read::program::read;
use expect_test::expect;

#[test]
fn files() {
    check_file(
        "TYPE\n  Phase : (IDLE, RUN := 5);\n  Pump : STRUCT speed : INT := 3; on : BOOL; END_STRUCT;\nEND_TYPE\n\
         (* cuts *)\nFUNCTION Clamp : INT VAR_INPUT v, hi : INT; END_VAR VAR n : INT; END_VAR\n\
         n := n + 1; IF v > hi THEN Clamp := hi; ELSE Clamp := v; END_IF; END_FUNCTION\n\
         FUNCTION_BLOCK FB_Ramp VAR_INPUT go : BOOL; END_VAR VAR_OUTPUT y : INT := 2; END_VAR IF go THEN y := Clamp(y + 1, hi := 9); END_IF; END_FUNCTION_BLOCK\n\
         VAR_GLOBAL CONSTANT K : INT := 16#7; END_VAR\n\
         PROGRAM Main VAR step : Phase := RUN; p : Pump := (speed := 4); a AT %IX0.0 : BOOL; r : FB_Ramp; g : ARRAY[1..K] OF INT := [3(1), 2]; END_VAR\n\
         (* first *) CASE step OF IDLE: step := Phase.RUN; Phase#RUN: p.on := a; END_CASE; // told\n\
         r(go := a); g[2] := r.y; (* last *)\nEND_PROGRAM\n",
        &expect![[r#"
            TYPE
                Phase : (IDLE, RUN := 5);
                Pump  : STRUCT
                    speed : INT := 3;
                    on    : BOOL;
                END_STRUCT;
            END_TYPE

            # cuts #
            FUNCTION_BLOCK [$Clamp]
            VAR_INPUT
                v  : INT;
                hi : INT;
            END_VAR
            VAR
                n : INT;
            END_VAR
            VAR_OUTPUT
                Clamp : INT;  # what the function returns #
            END_VAR

            +-----------------------------------------------------------[MOV]( Clamp, 0 )--+
            +---------------------------------------------------------------[MOV]( n, 0 )--+
            +----------------------------------------------------------[CALC]( n, n + 1 )--+

            # IF v > hi THEN #
            +--[GT]( v, hi )--------------------------[MOV]( Clamp, hi )--<JMP>( endif1 )--+

            # ELSE #
            +-----------------------------------------------------------[MOV]( Clamp, v )--+
            +--<LBL>( endif1 )-------------------------------------------------------------+
            END_FUNCTION_BLOCK

            FUNCTION_BLOCK [$FB_Ramp]
            VAR_INPUT
                go : BOOL;
            END_VAR
            VAR_OUTPUT
                y : INT := 2;
            END_VAR
            VAR
                st1 : INT;
            END_VAR

            # IF go THEN #
            +--[/]( go )--------------------------------------------------<JMP>( endif1 )--+

            # y := Clamp(y + 1, hi := 9) #
            +-------------[CALC]( st1, y + 1 )--[$Clamp]( v := st1, hi := 9, Clamp => y )--+
            +--<LBL>( endif1 )-------------------------------------------------------------+
            END_FUNCTION_BLOCK

            VAR_GLOBAL CONSTANT
                K : INT := 16#7;
            END_VAR
            VAR
                step           : Phase              := RUN;
                p              : Pump               := (speed := 4);
                a    AT %IX0.0 : BOOL;
                r              : $FB_Ramp;
                g              : ARRAY[1..K] OF INT := [3(1), 2];
            END_VAR

            # first #
            # CASE step OF #
            # IDLE: #
            +--[EQ]( step, Phase.IDLE )-------[MOV]( step, Phase.RUN )--<JMP>( endcase1 )--+

            # Phase.RUN: #
            +--[EQ]( step, Phase.RUN )-----------------------------------[MOV]( p.on, a )--+

            # told #
            +--<LBL>( endcase1 )---------------------------------[$FB_Ramp]( r, go := a )--+

            # last #
            +----------------------------------------------------------[MOV]( g[2], r.y )--+
        "#]],
    );
}

#[test]
fn a_unit_that_does_not_parse_is_unread_as_a_whole() {
    check_file(
        "FUNCTION_BLOCK Odd VAR_INPUT a : BOOL; END_VAR a := ; END_FUNCTION_BLOCK\n\
         PROGRAM Main VAR o : Odd; p : POINTER TO INT; END_VAR o(a := TRUE); p^ := 3; END_PROGRAM\n",
        &expect![[r#"
            # line 2 of Main: a pointer works on memory by address, which ladder text does not have; it is not run here. #
            FUNCTION_BLOCK [$line_2_of_Main]
            # ladder: unread #
            # p^ := 3 #
            END_FUNCTION_BLOCK

            # Odd: line 1 does not parse: a value is expected here, not `;`; it is not run here. #
            FUNCTION_BLOCK [$Odd]
            VAR_INPUT
                a : BOOL;
            END_VAR
            # ladder: unread #
            # a := ; #
            END_FUNCTION_BLOCK

            VAR
                o : $Odd;
            END_VAR

            +------------------------------------------------------[$Odd]( o, a := TRUE )--+
            +-----------------------------------------------------------[$line_2_of_Main]--+
            1:1: Odd: line 1 does not parse: a value is expected here, not `;`
            2:27: variable p: a pointer works on memory by address, which ladder text does not have; it is not declared
            2:69: p^ := 3: a pointer works on memory by address, which ladder text does not have: it is not run
            1:53: a value is expected here, not `;`
        "#]],
    );
}

#[test]
fn charts() {
    check_file(
        "PROGRAM Main VAR go, lamp : BOOL; n : INT; END_VAR\n\
         INITIAL_STEP Idle: END_STEP\n\
         TRANSITION FROM Idle TO Run := go; END_TRANSITION\n\
         STEP Run: lamp(D, T#500ms); Count(P); END_STEP\n\
         TRANSITION FROM Run TO Idle := Run.T >= T#2s AND n / 2 > 3; END_TRANSITION\n\
         ACTION Count: n := n + 1; (* one more *) END_ACTION\n\
         END_PROGRAM\n",
        &expect![[r#"
            VAR
                go   : BOOL;
                lamp : BOOL;
                n    : INT;
            END_VAR
            VAR
                st1         : INT;
                Idle        : BOOL := TRUE;  # step Idle #
                Run         : BOOL;  # step Run #
                Run_T       : TIME;  # how long step Run is active #
                Idle_to_Run : BOOL;  # from Idle to Run #
                Run_to_Idle : BOOL;  # from Run to Idle #
                Count       : BOOL;  # action Count runs #
                Run_before  : BOOL;  # step Run in the scan before #
            END_VAR

            # steps in the scan before #
            +--[ ]( Run )---------( )( Run_before )--[ADD]( Run_T, Run_T, SYS.SCAN_TIME )--+

            # transitions #
            +--[ ]( Idle )--[ ]( go )---------------------( )( Idle_to_Run )--(R)( Idle )--+
            +--[ ]( Run )--[CALC]( st1, n / 2 )--[GT]( Run_T, T#2s )--[GT]( st1, 3 )---------------( )( Run_to_Idle )--(R)( Run )--+

            # the steps that they lead to #
            +--[ ]( Idle_to_Run )------------------------[MOV]( Run_T, T#0s )--(S)( Run )--+
            +--[ ]( Run_to_Idle )---------------------------------------------(S)( Idle )--+

            # action Count #
            +--[ ]( Run )--[/]( Run_before )---------------------------------( )( Count )--+

            # action lamp #
            +--[ ]( Run )--[GE]( Run_T, T#500ms )-----------------------------(S)( lamp )--+
            +--[/]( Run )--[ ]( Run_before )----------------------------------(R)( lamp )--+

            # action Count #
            # one more #
            +--[ ]( Count )--------------------------------------------[CALC]( n, n + 1 )--+
        "#]],
    );
}

#[test]
fn what_is_wrong_in_a_chart() {
    for part in [
        "STEP Run: lamp(N) END_STEP",
        "STEP Run: lamp(D); END_STEP",
        "STEP Run: lamp(); END_STEP",
        "STEP Run: n(N); END_STEP",
        "STEP Run: lamp(X); END_STEP",
        "TRANSITION FROM Idle TO Gone := lamp; END_TRANSITION",
        "TRANSITION FROM Idle TO Idle := Gone.X; END_TRANSITION",
        "TRANSITION FROM Idle TO Idle : LD lamp END_TRANSITION",
        "ACTION Set: Idle.X := TRUE; END_ACTION STEP Run: Set(N); END_STEP",
        "ACTION lamp: n := 1; END_ACTION",
        "STEP lamp: END_STEP",
        "lamp := TRUE;",
        "STEP Run:",
    ] {
        let text = format!(
            "PROGRAM Main VAR lamp : BOOL; n : INT; END_VAR\nINITIAL_STEP Idle: END_STEP\n{part}\nEND_PROGRAM\n"
        );
        let read = read(&text, Dialect::Iec, &[]).expect("it is Structured Text");
        let told = read
            .report
            .entries
            .iter()
            .filter(|entry| entry.outcome != ladder_notation::Outcome::Translated);
        assert!(told.count() > 0, "{part}");
    }
}

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

#[test]
fn what_is_handed_over_to_an_in_out_is_read_through_the_instance() {
    check_file(
        "FUNCTION_BLOCK Ramp VAR_INPUT up : BOOL; END_VAR VAR_IN_OUT val : INT; END_VAR\n  IF up THEN val := val + 1; END_IF;\nEND_FUNCTION_BLOCK\n\
         PROGRAM Main VAR r, q : Ramp; v, w, x : INT; END_VAR\n  r(up := TRUE, val := v);\n  w := r.val;\n  r.val := 5;\n  q(val := v);\n  q(val := x);\n  w := q.val;\nEND_PROGRAM\n",
        &expect![[r#"
            # line 10 of Main: `q` has no member `val` that is read; it is not run here. #
            FUNCTION_BLOCK [$line_10_of_Main]
            # ladder: unread, writes w #
            # w := q.val #
            END_FUNCTION_BLOCK

            FUNCTION_BLOCK [$Ramp]
            VAR_INPUT
                up : BOOL;
            END_VAR
            VAR_IN_OUT
                val : INT;
            END_VAR

            # IF up THEN val := val + 1; END_IF #
            +--[ ]( up )-------------------------------------------[CALC]( val, val + 1 )--+
            END_FUNCTION_BLOCK

            VAR
                r : $Ramp;
                q : $Ramp;
                v : INT;
                w : INT;
                x : INT;
            END_VAR

            +------------------------------------------[$Ramp]( r, up := TRUE, val := v )--+
            +---------------------------------------------------------------[MOV]( w, v )--+
            +---------------------------------------------------------------[MOV]( v, 5 )--+
            +------------------------------------------------------[$Ramp]( q, val := v )--+

            # ladder: allow(duplicate-instance): several calls of q #
            +------------------------------------------------------[$Ramp]( q, val := x )--+
            +----------------------------------------------------------[$line_10_of_Main]--+
            10:3: w := q.val: `q` has no member `val` that is read: it is not run
        "#]],
    );
}

#[test]
fn structures_of_instances_are_copied_value_by_value() {
    check_file(
        "TYPE V : STRUCT x : REAL; y : ARRAY[0..1] OF INT; END_STRUCT; END_TYPE\n\
         FUNCTION_BLOCK F VAR_INPUT a : V; END_VAR VAR_OUTPUT r : V; END_VAR\n  r := a;\nEND_FUNCTION_BLOCK\n\
         FUNCTION Twice : V VAR_INPUT a : V; END_VAR\n  Twice := a;\n  Twice.x := 2.0 * a.x;\nEND_FUNCTION\n\
         PROGRAM Main VAR c, d : F; y : V; END_VAR\n  c(a := y);\n  y := c.r;\n  d(a := c.r);\n  y := Twice(y);\nEND_PROGRAM\n",
        &expect![[r#"
            TYPE
                V : STRUCT
                    x : REAL;
                    y : ARRAY[0..1] OF INT;
                END_STRUCT;
            END_TYPE

            FUNCTION_BLOCK [$F]
            VAR_INPUT
                a : V;
            END_VAR
            VAR_OUTPUT
                r : V;
            END_VAR

            +---------------------------------------------------------------[MOV]( r, a )--+
            END_FUNCTION_BLOCK

            FUNCTION_BLOCK [$Twice]
            VAR_INPUT
                a : V;
            END_VAR
            VAR_OUTPUT
                Twice : V;  # what the function returns #
            END_VAR

            +-----------------------------------------------------------[MOV]( Twice, a )--+
            +------------------------------------------------[CALC]( Twice.x, 2.0 * a.x )--+
            END_FUNCTION_BLOCK

            VAR
                c : $F;
                d : $F;
                y : V;
            END_VAR
            VAR
                st1 : V;
                st2 : V;
            END_VAR

            +-----------------------------------------------------------[$F]( c, a := y )--+

            # y := c.r #
            +---[MOV]( y.x, c.r.x )--[MOV]( y.y[0], c.r.y[0] )--[MOV]( y.y[1], c.r.y[1] )--+
            +----------------[MOV]( st1.x, c.r.x )--[MOV]( st1.y[0], c.r.y[0] )--[MOV]( st1.y[1], c.r.y[1] )--[$F]( d, a := st1 )--+

            # y := Twice(y) #
            +---------------------------[$Twice]( a := y, Twice => st2 )--[MOV]( y, st2 )--+
        "#]],
    );
}

#[test]
fn what_has_no_address_or_no_type_here() {
    check_file(
        "PROGRAM Main\nVAR\n  i AT %IX27 : BOOL;\n  q AT %QW0.1 : INT;\n  m AT %MX0.2 : UINT;\n  one AT %MW0.0 : INT;\n  other AT %MW0.0 : INT;\n  p : Pid;\n  out : REAL;\nEND_VAR\n\
         q := m;\n  p(IN := 1.0);\n  out := p.out;\n  IF i THEN q := 1; ELSIF p.out > 1.0 THEN q := 2; END_IF;\n  one := 1;\nEND_PROGRAM\n",
        &expect![[r#"
            # line 12 of Main: `p` is not a block that can be called; it is not run here. #
            FUNCTION_BLOCK [$line_12_of_Main]
            # ladder: unread #
            # p(IN := 1.0) #
            END_FUNCTION_BLOCK

            # line 13 of Main: `p` has no member `out` that is read; it is not run here. #
            FUNCTION_BLOCK [$line_13_of_Main]
            # ladder: unread, writes out #
            # out := p.out #
            END_FUNCTION_BLOCK

            # line 14 of Main: `p` has no member `out` that is read; it is not run here. #
            FUNCTION_BLOCK [$line_14_of_Main]
            # ladder: unread, writes q #
            # IF i THEN q := 1; ELSIF p.out > 1.0 THEN q := 2; END_IF #
            END_FUNCTION_BLOCK

            # line 15 of Main: `one` holds the state of a block, or is of an unknown type; it is not run here. #
            FUNCTION_BLOCK [$line_15_of_Main]
            # ladder: unread #
            # one := 1 #
            END_FUNCTION_BLOCK

            VAR_INPUT
                i : BOOL;
            END_VAR
            VAR_OUTPUT
                q : INT;
            END_VAR
            VAR
                m   : UINT;
                out : REAL;
            END_VAR

            +--------------------------------------------------------------[WRAP]( q, m )--+
            +----------------------------------------------------------[$line_12_of_Main]--+
            +----------------------------------------------------------[$line_13_of_Main]--+
            +----------------------------------------------------------[$line_14_of_Main]--+
            +----------------------------------------------------------[$line_15_of_Main]--+
            3:3: variable i: there is no `%IX27` here: the tag has no address
            4:3: variable q: there is no `%QW0.1` here: the tag has no address
            5:3: variable m: there is no `%MX0.2` here: the tag has no address
            6:3: variable one: another variable is at `%MW0.0`, too; it is not declared
            7:3: variable other: another variable is at `%MW0.0`, too; it is not declared
            8:3: variable p: the type `Pid` is not known here; it is not declared
            12:3: p(IN := 1.0): `p` is not a block that can be called: it is not run
            13:3: out := p.out: `p` has no member `out` that is read: it is not run
            14:3: IF i THEN q := 1; ELSIF p.out > 1.0 THEN q := 2; END_IF: `p` has no member `out` that is read: it is not run
            15:3: one := 1: `one` holds the state of a block, or is of an unknown type: it is not run
        "#]],
    );
}

#[test]
fn a_block_has_its_name_before_a_function_next_to_it() {
    let other = ladder_notation::Companion {
        name: "F.st".to_owned(),
        bytes: b"FUNCTION F : INT VAR_INPUT a : INT; END_VAR F := a; END_FUNCTION"
            .to_vec()
            .into(),
    };
    let own = "FUNCTION_BLOCK F VAR_OUTPUT a : BOOL; END_VAR a := TRUE; END_FUNCTION_BLOCK";
    let reading = read(own, Dialect::Iec, &[other]).expect("it is read");
    let shown = reading.program.write(&ladder_format::Options::default()).text;
    assert!(!shown.contains("what the function returns"), "{shown}");
}

#[test]
fn a_global_that_no_file_has_is_not_declared() {
    check_file(
        "PROGRAM Main VAR_EXTERNAL far : INT; END_VAR VAR n : INT; END_VAR\n  n := far;\n  n := 1;\nEND_PROGRAM\n",
        &expect![[r#"
            # line 2 of Main: the type of `far` is not known here; it is not run here. #
            FUNCTION_BLOCK [$line_2_of_Main]
            # ladder: unread, writes n #
            # n := far #
            END_FUNCTION_BLOCK

            VAR
                n : INT;
            END_VAR

            +-----------------------------------------------------------[$line_2_of_Main]--+
            +---------------------------------------------------------------[MOV]( n, 1 )--+
            1:27: variable far: no file that is read has a global of this name; it is not declared
            2:3: n := far: the type of `far` is not known here: it is not run
        "#]],
    );
}

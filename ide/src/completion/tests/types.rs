//! Members of structures, values of enumerations, names of types.

use super::check;
use expect_test::expect;

const TYPES: &str = "TYPE\n    Phase : (IDLE, FILLING, MIXING := 10);\n    Motor : STRUCT\n        speed   : REAL;\n        running : BOOL;\n        delay   : TON;\n    END_STRUCT;\nEND_TYPE\n\nVAR\n    pump  : Motor := (speed := 20.0);\n    lines : ARRAY[1..4] OF Motor;\n    step  : Phase := FILLING;\n    k     : INT;\nEND_VAR\n\n";

#[track_caller]
fn check_after_types(rest: &str, expected: expect_test::Expect) {
    check(&format!("{TYPES}{rest}"), expected);
}

#[test]
fn members() {
    check_after_types(
        "+--[ ]( pump.$0 )--( )( Q1 )--+\n",
        expect![[r#"
        running        BOOL
        delay          TON
        speed          REAL
    "#]],
    );
    check_after_types(
        "+--[ ]( lines[k + 1].r$0 )--( )( Q1 )--+\n",
        expect![[r#"
            running        BOOL
        "#]],
    );
    check_after_types(
        "+--[ ]( lines[2].delay.$0 )--( )( Q1 )--+\n",
        expect![[r#"
            Q              BOOL
            IN             BOOL
            R              BOOL
            TT             BOOL
            DN             BOOL
            EN             BOOL
            ET             TIME
            PT             TIME
            ACC            TIME
            PRE            TIME
            AC             TIME
        "#]],
    );
    check_after_types(
        "+--[ ]( lines.$0 )--( )( Q1 )--+\n",
        expect![[r#"
        nothing
    "#]],
    );
}

#[test]
fn values() {
    check_after_types(
        "+--[EQ]( step, $0 )--( )( Q1 )--+\n",
        expect![[r#"
        IDLE           Phase, 0
        FILLING        Phase, 1
        MIXING         Phase, 10
        step           Phase, VAR
    "#]],
    );
    check_after_types(
        "+--[ ]( I1 )--[MOV]( step, M$0 )--+\n",
        expect![[r#"
        MIXING         Phase, 10
    "#]],
    );
    check_after_types(
        "+--[ ]( I1 )--[MOV]( x, Phase.$0 )--+\n",
        expect![[r#"
        IDLE           Phase, 0
        FILLING        Phase, 1
        MIXING         Phase, 10
    "#]],
    );
}

#[test]
fn types() {
    check(
        "TYPE\n    Motor : STRUCT\n        on : BOOL;\n    END_STRUCT;\nEND_TYPE\nVAR\n    a : Mo$0\nEND_VAR\n",
        expect![[r#"
        Motor          type of this file
    "#]],
    );
    check(
        "TYPE\n    Motor : STRUCT\n        on : BOOL;\n    $0",
        expect![[r#"
        END_STRUCT     end of the structure
    "#]],
    );
}

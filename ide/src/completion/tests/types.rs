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
            $Motor         state of a block
            $Amount        state of a block
        "#]],
    );
    check(
        "TYPE\n    Motor : STRUCT\n        on : BOOL;\n    $0",
        expect![[r#"
        END_STRUCT     end of the structure
    "#]],
    );
}

const MOTORS: &str = "FUNCTION_BLOCK [$Motor]\nVAR_INPUT\n    start : BOOL;\nEND_VAR\nVAR_OUTPUT\n    running : BOOL;\nEND_VAR\n+--[ ]( start )--( )( running )--+\nEND_FUNCTION_BLOCK\n\nTYPE\n    Phase : (IDLE, FILLING, FULL);\n    Cell : STRUCT\n        drive : $Motor;\n        phase : Phase;\n        level : ARRAY[1..3] OF INT;\n    END_STRUCT;\nEND_TYPE\n\nVAR CONSTANT\n    last : INT := 4;\nEND_VAR\n\nVAR\n    m1   : $Motor;\n    cell : ARRAY[1..4] OF Cell;\n    step : Phase;\n    k    : INT;\nEND_VAR\n\n";

/// What is proposed first at each of some rungs, whatever else is wrong in the file.
#[track_caller]
fn check_rungs(rungs: &[&str], expected: expect_test::Expect) {
    let mut shown = String::new();
    for rung in rungs {
        for after in ["\n", "\n+--[ ]( --(\n+--[FOO]( m1., x )--+\n"] {
            let (_, found) = super::found(&format!("{MOTORS}{rung}{after}"));
            let labels: Vec<&str> = found
                .items
                .iter()
                .take(5)
                .map(|item| item.label.as_str())
                .collect();
            let line = format!("{rung}  {}\n", labels.join(", "));
            if after.len() == 1 || !shown.ends_with(&line) {
                shown.push_str(&line);
            }
        }
    }
    expected.assert_eq(&shown);
}

#[test]
fn in_half_typed_rungs() {
    check_rungs(
        &[
            "+--[ ]( m1.$0",
            "+--[ ]( m1.$0 )--( )( y )--+",
            "+--[ ]( cell[2].$0",
            "+--[ ]( cell[2].drive.$0",
            "+--[ ]( cell[k + 1].drive.r$0",
            "+--[EQ]( cell[k].phase, $0",
            "+--[EQ]( step, Phase.$0",
            "+--[NE]( step, F$0 )--( )( y )--+",
            "+--[MOV]( cell[2].phase, $0",
            "+--[MOV]( step, F$0",
            "+--[CALC]( y, step = $0",
            "+--[CALC]( y, step <> F$0 )--+",
            "+--[SEL]( step, k, $0",
            "+--[MUX]( step, k, IDLE, F$0",
            "+--[MOV]( cell[1].level[$0",
            "+--[MOV]( k, cell[l$0",
            "+--[MOV]( k, cell[k].level[1] + cell[2].l$0",
            "+--[$Motor]( $0",
            "+--[$Motor]( m$0, a )--( )( y )--+",
            "+--[$Motor]( cell[1].$0, a )--( )( y )--+",
            "+--[$Motor]( m1, $0",
        ],
        expect![[r#"
            +--[ ]( m1.$0  start, running
            +--[ ]( m1.$0 )--( )( y )--+  start, running
            +--[ ]( cell[2].$0  level, drive, phase
            +--[ ]( cell[2].drive.$0  start, running
            +--[ ]( cell[k + 1].drive.r$0  running, start
            +--[EQ]( cell[k].phase, $0  step, IDLE, FILLING, FULL, cell
            +--[EQ]( step, Phase.$0  IDLE, FILLING, FULL
            +--[NE]( step, F$0 )--( )( y )--+  FILLING, FULL
            +--[MOV]( cell[2].phase, $0  step, IDLE, FILLING, FULL, cell
            +--[MOV]( step, F$0  FILLING, FULL
            +--[CALC]( y, step = $0  step, IDLE, FILLING, FULL, cell
            +--[CALC]( y, step <> F$0 )--+  FILLING, FULL, FIND(, LEFT(
            +--[SEL]( step, k, $0  IDLE, FILLING, FULL, step, cell
            +--[MUX]( step, k, IDLE, F$0  FILLING, FULL
            +--[MOV]( cell[1].level[$0  k, last, cell, SYS.SCAN
            +--[MOV]( cell[1].level[$0  k, last, x, cell, SYS.SCAN
            +--[MOV]( k, cell[l$0  last, cell
            +--[MOV]( k, cell[k].level[1] + cell[2].l$0  level
            +--[$Motor]( $0  m1, cell, k, last, start :=
            +--[$Motor]( $0  m1, cell, k, last, x
            +--[$Motor]( m$0, a )--( )( y )--+  m1, SYS.CLOCK_10MS, SYS.CLOCK_100MS, SYS.CLOCK_500MS, SYS.CLOCK_1M
            +--[$Motor]( cell[1].$0, a )--( )( y )--+  level, drive, phase
            +--[$Motor]( m1, $0  cell, k, last, start :=, running =>
            +--[$Motor]( m1, $0  cell, k, last, x, start :=
        "#]],
    );
}

#[test]
fn in_declarations() {
    let at = |declaration: &str| {
        let (_, found) = super::found(&format!("{MOTORS}VAR\n    {declaration}\nEND_VAR\n"));
        let labels: Vec<&str> = found
            .items
            .iter()
            .take(6)
            .map(|item| item.label.as_str())
            .collect();
        format!("{declaration}  {}\n", labels.join(", "))
    };
    let declarations = [
        "a : Phase := $0;",
        "a : Phase := F$0;",
        "a : Cell := ($0",
        "a : Cell := (phase := $0);",
        "a : Cell := (phase := F$0",
        "a : ARRAY[1..2] OF Phase := [$0",
        "a : ARRAY[1..l$0] OF INT;",
        "a : $$0",
        "a : ARRAY[1..2] OF $0",
    ];
    let shown: Vec<String> = declarations.into_iter().map(at).collect();
    let expected = expect![[r#"
        a : Phase := $0;  IDLE, FILLING, FULL
        a : Phase := F$0;  FILLING, FULL
        a : Cell := ($0  phase :=, level :=
        a : Cell := (phase := $0);  IDLE, FILLING, FULL
        a : Cell := (phase := F$0  FILLING, FULL
        a : ARRAY[1..2] OF Phase := [$0  IDLE, FILLING, FULL
        a : ARRAY[1..l$0] OF INT;  last
        a : $$0  $Motor, $Alarm, $Alternate, $Average, $Blink, $Debounce
        a : ARRAY[1..2] OF $0  BOOL, INT, DINT, REAL, TIME, BYTE
    "#]];
    expected.assert_eq(&shown.concat());
}

//! What is proposed.

use super::super::{Scenarios, scenario_completions};
use super::{Asked, HEAD};
use crate::fixture::Fixture;
use expect_test::{Expect, expect};
use ladder_simulator::scenario::parse;
use ladder_syntax::TextSize;

#[test]
fn completion_of_headings() {
    let check = |text: &str, expected: Expect| expected.assert_eq(&Asked::at(text).completions(None));
    check(
        "program main.clad\n$0\n",
        expect![[r#"
            plant||plant 
            connect||connect 
            step||step 
            interval||interval 
            tolerance||tolerance 
            scenario||scenario "${1:what is shown}"
            $0
            property||property "${1:what must hold}"
            $0
            assume||assume ${1:condition}
            never|property|never ${1:condition}
            always|property|always ${1:condition}
            when|property|when ${1:condition}: ${2:what holds}
            when until|property|when ${1:condition}: ${2:what holds} until ${3:end}
            after|property|after ${1:condition}: ${2:what holds then}
            within|property|within ${1:500ms} of ${2:condition}: ${3:answer}
            possible|property|possible ${1:condition}
            no faults|property|no faults
        "#]],
    );
    check(
        "program m$0\n",
        expect![[r#"
        a.clad|program|a.clad
        main.clad|program|main.clad
    "#]],
    );
    check(
        "step $0\n",
        expect![[r#"
        10ms|a whole number of scans|10ms
        100ms|a whole number of scans|100ms
        1s|a whole number of scans|1s
    "#]],
    );
    check("# a comment $0\n", expect![]);
}

#[test]
fn completion_of_tags_and_values() {
    let check = |rows: &str, expected: Expect| {
        expected.assert_eq(&Asked::at(&format!("{HEAD}{rows}")).completions(None));
    };
    check(
        "$0",
        expect![[r#"
            start|BOOL, input|start 
            run|BOOL, output|run => 
            total|DINT, internal|total => 
            warm.Q|BOOL, internal|warm.Q => 
            warm.ET|TIME, internal|warm.ET => 
            warm.IN|BOOL, internal|warm.IN => 
            warm.PT|TIME, internal|warm.PT => 
            list[1]|INT, internal|list[1] => 
            list[2]|INT, internal|list[2] => 
            lib.total|BOOL, internal of lib.clad|lib.total => 
            lib.go|BOOL, internal of lib.clad|lib.go => 
            time||time 
            scenario||scenario "${1:what is shown}"
            $0
            property||property "${1:what must hold}"
            $0
            assume||assume ${1:condition}
            never|property|never ${1:condition}
            always|property|always ${1:condition}
            when|property|when ${1:condition}: ${2:what holds}
            when until|property|when ${1:condition}: ${2:what holds} until ${3:end}
            after|property|after ${1:condition}: ${2:what holds then}
            within|property|within ${1:500ms} of ${2:condition}: ${3:answer}
            possible|property|possible ${1:condition}
            no faults|property|no faults
        "#]],
    );
    // What has a row is not proposed, and what is after the cursor stays.
    check(
        "start _-\nr$0 _-\n",
        expect![[r#"
            run|BOOL, output|run
            total|DINT, internal|total
            warm.Q|BOOL, internal|warm.Q
            warm.ET|TIME, internal|warm.ET
            warm.IN|BOOL, internal|warm.IN
            warm.PT|TIME, internal|warm.PT
            list[1]|INT, internal|list[1]
            list[2]|INT, internal|list[2]
            lib.total|BOOL, internal of lib.clad|lib.total
            lib.go|BOOL, internal of lib.clad|lib.go
            time||time 
            scenario||scenario "${1:what is shown}"
            $0
            property||property "${1:what must hold}"
            $0
            assume||assume ${1:condition}
            never|property|never ${1:condition}
            always|property|always ${1:condition}
            when|property|when ${1:condition}: ${2:what holds}
            when until|property|when ${1:condition}: ${2:what holds} until ${3:end}
            after|property|after ${1:condition}: ${2:what holds then}
            within|property|within ${1:500ms} of ${2:condition}: ${3:answer}
            possible|property|possible ${1:condition}
            no faults|property|no faults
        "#]],
    );
    check(
        "start _--_\nrun $0\n",
        expect![[r#"
        =>|expected|=> 
        ____|low to the end|____
        _|low|_
        ----|high to the end|----
        -|high|-
        ....|as before to the end|....
        .|as before; not checked|.
    "#]],
    );
    check(
        "start _--_\nrun => _$0\n",
        expect![[r#"
        ___|low to the end|___
        _|low|_
        ---|high to the end|---
        -|high|-
        ...|as before to the end|...
        .|as before; not checked|.
    "#]],
    );
    // Below a row `time` it is as many as that has; a row above it is another piece's.
    check(
        "start _--_\nrun => _-__\ntime 1s . 3s\nrun => $0\n",
        expect![[r#"
        ___|low to the end|___
        _|low|_
        ---|high to the end|---
        -|high|-
        ...|as before to the end|...
        .|as before; not checked|.
    "#]],
    );
    check(
        "start _-\nrun => _-\ntime 1s\nr$0",
        expect![[r#"
            run|BOOL, output|run => 
            start|BOOL, input|start 
            total|DINT, internal|total => 
            warm.Q|BOOL, internal|warm.Q => 
            warm.ET|TIME, internal|warm.ET => 
            warm.IN|BOOL, internal|warm.IN => 
            warm.PT|TIME, internal|warm.PT => 
            list[1]|INT, internal|list[1] => 
            list[2]|INT, internal|list[2] => 
            lib.total|BOOL, internal of lib.clad|lib.total => 
            lib.go|BOOL, internal of lib.clad|lib.go => 
            time||time 
            scenario||scenario "${1:what is shown}"
            $0
            property||property "${1:what must hold}"
            $0
            assume||assume ${1:condition}
            never|property|never ${1:condition}
            always|property|always ${1:condition}
            when|property|when ${1:condition}: ${2:what holds}
            when until|property|when ${1:condition}: ${2:what holds} until ${3:end}
            after|property|after ${1:condition}: ${2:what holds then}
            within|property|within ${1:500ms} of ${2:condition}: ${3:answer}
            possible|property|possible ${1:condition}
            no faults|property|no faults
        "#]],
    );
    check(
        "start _-\ntime $0\n",
        expect![[r#"
        .|as long as `step` says|.
        100ms|so long is the step|100ms
        1s|so long is the step|1s
        3s|so long is the step|3s
        1m|so long is the step|1m
    "#]],
    );
    check(
        "warm.ET => $0\n",
        expect![[r#"
        .|as before; not checked|.
        0ms|a duration|0ms
        100ms|a duration|100ms
        1s|a duration|1s
    "#]],
    );
    check(
        "total => 1 $0\n",
        expect![[r#"
        .|as before; not checked|.
        0|a number|0
        1|a number|1
    "#]],
    );
}

/// A file of functions that uses another one with a block of its own, and one that is not used.
#[test]
fn completion_of_tags_of_used_files() {
    let asked = |rows: &str, trigger| {
        let text = format!("{HEAD}{rows}");
        let offset = TextSize::new(text.find("$0").expect("a cursor") as u32);
        let text = text.replacen("$0", "", 1);
        let fixture = Fixture::new(&format!(
            "{}%% main.ladder-test\n{text}",
            "\
%% main.clad
VAR total : INT; END_VAR
+--<CALL>( count )--( )( run )--+
%% sub/lib.clad
VAR_GLOBAL level : INT; END_VAR
VAR_INPUT go, unused : BOOL; END_VAR
VAR CONSTANT most : INT := 5; END_VAR
VAR total : DINT; warm : TON; END_VAR
+--<FUN>( count )--[ ]( go )--[$Far]( go )--[TON]( warm, 5s )--[INC]( total )--+
%% far.clad
VAR distance : INT; END_VAR
FUNCTION_BLOCK [$Far]
VAR_INPUT x : BOOL; END_VAR
+--[ ]( x )--( )( ENO )--+
END_FUNCTION_BLOCK
%% unused.clad
VAR nothing : INT; END_VAR
"
        ));
        let suite = parse(&text);
        let found = scenario_completions(
            &Scenarios {
                text: &text,
                suite: &suite,
                program: Some(&fixture.files[0].0.context),
                workspace: &fixture.others(0),
            },
            offset,
            &[],
            trigger,
        );
        let item = |it: &crate::completion::Completion| {
            format!("{}|{}|{}\n", it.label, it.detail, it.text.snippet())
        };
        found.items.iter().map(item).collect::<Vec<_>>().concat()
    };
    expect![[r#"
        run|BOOL, output|run => 
        total|INT, internal|total => 
        lib.go|BOOL, input of sub/lib.clad|lib.go 
        lib.total|DINT, internal of sub/lib.clad|lib.total => 
        lib.warm.Q|BOOL, internal of sub/lib.clad|lib.warm.Q => 
        lib.warm.ET|TIME, internal of sub/lib.clad|lib.warm.ET => 
        lib.warm.IN|BOOL, internal of sub/lib.clad|lib.warm.IN => 
        lib.warm.PT|TIME, internal of sub/lib.clad|lib.warm.PT => 
        time||time 
        scenario||scenario "${1:what is shown}"
        $0
        property||property "${1:what must hold}"
        $0
        assume||assume ${1:condition}
        never|property|never ${1:condition}
        always|property|always ${1:condition}
        when|property|when ${1:condition}: ${2:what holds}
        when until|property|when ${1:condition}: ${2:what holds} until ${3:end}
        after|property|after ${1:condition}: ${2:what holds then}
        within|property|within ${1:500ms} of ${2:condition}: ${3:answer}
        possible|property|possible ${1:condition}
        no faults|property|no faults
    "#]]
    .assert_eq(&asked("$0\n", None));
    // One that has a row is not proposed; those that begin like what is written are first.
    expect![[r#"
        lib.go|BOOL, input of sub/lib.clad|lib.go 
        lib.warm.Q|BOOL, internal of sub/lib.clad|lib.warm.Q => 
        lib.warm.ET|TIME, internal of sub/lib.clad|lib.warm.ET => 
        lib.warm.IN|BOOL, internal of sub/lib.clad|lib.warm.IN => 
        lib.warm.PT|TIME, internal of sub/lib.clad|lib.warm.PT => 
        run|BOOL, output|run => 
        total|INT, internal|total => 
    "#]]
    .assert_eq(&asked("lib.total => 1\nlib.$0\n", Some('.')));
    expect![[r#"
        .|as before; not checked|.
        0ms|a duration|0ms
        100ms|a duration|100ms
        1s|a duration|1s
    "#]]
    .assert_eq(&asked("lib.warm.ET => $0\n", None));
}

#[test]
fn a_dot_among_levels_opens_no_list() {
    let at = |rows: &str| Asked::at(&format!("{HEAD}{rows}")).completions(Some('.'));
    assert_eq!(at("start _.$0\n"), "");
    assert!(at("warm.$0\n").contains("warm.ET|TIME"), "{}", at("warm.$0\n"));
}

#[test]
fn members_and_values() {
    let plant = "%% main.clad\nTYPE\n    Phase : (IDLE, FULL);\n    Cell : STRUCT\n        open  : BOOL;\n        drive : $Motor;\n        phase : Phase;\n    END_STRUCT;\nEND_TYPE\nFUNCTION_BLOCK [$Motor]\nVAR_INPUT start : BOOL; END_VAR\nVAR turns : DINT; END_VAR\n+--[ ]( start )--[ADD]( turns, turns, 1 )--+\nEND_FUNCTION_BLOCK\nVAR m1 : $Motor; cell : ARRAY[1..40] OF Cell; END_VAR\n+--[$Motor]( m1, a )--+\n";
    let check = |rows: &str, expected: Expect| {
        let text = format!("{HEAD}{rows}");
        let at = text.find("$0").expect("a cursor");
        let text = text.replacen("$0", "", 1);
        let fixture = Fixture::new(&format!("{plant}%% main.ladder-test\n{text}"));
        let asked = Scenarios {
            text: &text,
            suite: &parse(&text),
            program: Some(&fixture.files[0].0.context),
            workspace: &fixture.others(0),
        };
        let found = scenario_completions(&asked, TextSize::new(at as u32), &[], None);
        let shown = found
            .items
            .iter()
            .take(6)
            .map(|it| format!("{}|{}|{}\n", it.label, it.detail, it.text.snippet()));
        expected.assert_eq(&shown.collect::<Vec<_>>().concat());
    };
    check(
        "cell[30].$0",
        expect![[r#"
            cell[30].open|BOOL|cell[30].open => 
            cell[30].drive|$Motor|cell[30].drive
            cell[30].phase|Phase|cell[30].phase => 
            time||time 
            scenario||scenario "${1:what is shown}"
            $0
            property||property "${1:what must hold}"
            $0
        "#]],
    );
    check(
        "cell[30].drive.t$0",
        expect![[r#"
            cell[30].drive.start|BOOL|cell[30].drive.start => 
            cell[30].drive.turns|DINT|cell[30].drive.turns => 
            time||time 
            scenario||scenario "${1:what is shown}"
            $0
            property||property "${1:what must hold}"
            $0
            assume||assume ${1:condition}
        "#]],
    );
    check(
        "m1.$0",
        expect![[r#"
            m1.start|BOOL|m1.start => 
            m1.turns|DINT|m1.turns => 
            time||time 
            scenario||scenario "${1:what is shown}"
            $0
            property||property "${1:what must hold}"
            $0
            assume||assume ${1:condition}
        "#]],
    );
    check(
        "cell[2].phase => $0",
        expect![[r#"
        .|as before; not checked|.
        IDLE|a value|IDLE
        FULL|a value|FULL
    "#]],
    );
    check(
        "cell[2].phase => IDLE F$0",
        expect![[r#"
        .|as before; not checked|.
        IDLE|a value|IDLE
        FULL|a value|FULL
    "#]],
    );
}

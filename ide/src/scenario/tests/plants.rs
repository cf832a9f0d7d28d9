//! What runs beside the program: its lines, its tags and its connections.

use super::super::{Scenarios, scenario_completions, scenario_definition, scenario_hover};
use crate::fixture::Fixture;
use crate::references::scenario_references;
use expect_test::{Expect, expect};
use ladder_simulator::scenario::parse;
use ladder_syntax::TextSize;

const WORKSPACE: &str = "\
%% press/main.clad
VAR_INPUT near : BOOL; level : REAL; END_VAR
VAR_OUTPUT pump : BOOL; speed : REAL; END_VAR
VAR seen : BOOL; END_VAR
+--[ ]( near )--\\--( )( seen )---------------+
|               /--[GE]( level, 1.0 )--( )( pump )--+
%% press/tank.clad
VAR_INPUT pump, leak : BOOL; wanted : REAL; END_VAR
VAR_OUTPUT level : REAL; sensor : BOOL; END_VAR
+--[ ]( pump )--[/]( leak )--[ADD]( level, level, wanted )--[GE]( level, 1.0 )--( )( sensor )--+
%% other/tank.clad
VAR_OUTPUT level : DINT; END_VAR
+--[INC]( level )--+
";

fn ask<T>(text: &str, question: impl FnOnce(&Fixture, &Scenarios<'_>, TextSize) -> T) -> T {
    let at = text.find("$0").expect("a cursor");
    let text = text.replacen("$0", "", 1);
    let fixture = Fixture::new(&format!("{WORKSPACE}%% press/main.ladder-test\n{text}"));
    let workspace = fixture.others(0);
    let scenarios = Scenarios {
        text: &text,
        suite: &parse(&text),
        program: Some(&fixture.files[0].0.context),
        workspace: &workspace,
    };
    question(&fixture, &scenarios, TextSize::new(at as u32))
}

#[test]
fn completion_of_plants_and_connections() {
    const HEAD: &str = "program main.clad\nplant tank.clad as tank\n";
    let check = |text: &str, expected: Expect| {
        let programs = ["main.clad".to_owned(), "tank.clad".to_owned()];
        let found = ask(text, |_, scenarios, offset| {
            scenario_completions(scenarios, offset, &programs, None)
        });
        let item = |it: &crate::completion::Completion| {
            format!("{}|{}|{}\n", it.label, it.detail, it.text.snippet())
        };
        let shown: Vec<String> = found.items.iter().map(item).collect();
        expected.assert_eq(&shown.concat());
    };
    check(
        "program main.clad\nplant $0\n",
        expect![[r#"
        main.clad|a model of the machine|main.clad
        tank.clad|a model of the machine|tank.clad
    "#]],
    );
    check(
        "program main.clad\nplant tank.clad $0\n",
        expect![[r#"
        as|another name before its tags|as
    "#]],
    );
    check(
        &format!("{HEAD}connect $0\n"),
        expect![[r#"
        tank.pump|BOOL, input of press/tank.clad|tank.pump = 
        tank.leak|BOOL, input of press/tank.clad|tank.leak = 
        tank.wanted|REAL, input of press/tank.clad|tank.wanted = 
        tank.level|REAL, output of press/tank.clad|tank.level = 
        tank.sensor|BOOL, output of press/tank.clad|tank.sensor = 
    "#]],
    );
    check(
        &format!("{HEAD}connect tank.sensor $0\n"),
        expect![[r#"
        =|connected with|=
    "#]],
    );
    check(
        &format!("{HEAD}connect tank.sensor = $0\n"),
        expect![[r#"
        near|BOOL, input of press/main.clad|near
    "#]],
    );
    check(
        &format!("{HEAD}connect speed = t$0\n"),
        expect![[r#"
        tank.wanted|REAL, input of press/tank.clad|tank.wanted
    "#]],
    );
    check(
        &format!("{HEAD}scenario \"fills\"\nta$0\n"),
        expect![[r#"
        tank.pump|BOOL, input of press/tank.clad|tank.pump 
        tank.leak|BOOL, input of press/tank.clad|tank.leak 
        tank.wanted|REAL, input of press/tank.clad|tank.wanted 
        tank.level|REAL, output of press/tank.clad|tank.level => 
        tank.sensor|BOOL, output of press/tank.clad|tank.sensor => 
        near|BOOL, input|near 
        level|REAL, input|level 
        pump|BOOL, output|pump => 
        speed|REAL, output|speed => 
        seen|BOOL, internal|seen => 
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
        &format!("{HEAD}scenario \"fills\"\nnear _-$0\n"),
        expect![[r#"
        =>|expected|=> 
        _|low|_
        -|high|-
        .|as before; not checked|.
        ~|as the plant has it|~
    "#]],
    );
    check(
        &format!("{HEAD}scenario \"fills\"\nlevel 1.0 $0\n"),
        expect![[r#"
        .|as before; not checked|.
        ~|as the plant has it|~
        0.0|a number|0.0
        1.0|a number|1.0
    "#]],
    );
    check(
        &format!("{HEAD}never tank.l$0\n"),
        expect![[r#"
        rises(||rises(${1:condition})
        falls(||falls(${1:condition})
        was(||was(${1:condition})
        not|the opposite|not 
        tank.leak|BOOL, input of press/tank.clad|tank.leak
        tank.level|REAL, output of press/tank.clad|tank.level
        near|BOOL, input|near
        level|REAL, input|level
        pump|BOOL, output|pump
        speed|REAL, output|speed
        seen|BOOL, internal|seen
        tank.pump|BOOL, input of press/tank.clad|tank.pump
        tank.wanted|REAL, input of press/tank.clad|tank.wanted
        tank.sensor|BOOL, output of press/tank.clad|tank.sensor
    "#]],
    );
}

#[test]
fn what_a_plant_names_is_found() {
    let check = |text: &str, expected: Expect| {
        let shown = ask(text, |fixture, scenarios, offset| {
            let mut shown = String::new();
            if let Some((hover, file)) = scenario_hover(scenarios, offset) {
                let file = file.unwrap_or_default();
                let place = &scenarios.text[hover.range];
                shown.push_str(&format!("[{place}] {file}\n{}\n", hover.markdown));
            }
            for target in scenario_definition(scenarios, offset) {
                shown.push_str(&format!(
                    "definition {}\n",
                    fixture.show(&target.file, target.focus)
                ));
            }
            for it in scenario_references(scenarios, offset) {
                shown.push_str(&format!("{} {:?}\n", fixture.show(&it.file, it.range), it.usage));
            }
            shown
        });
        expected.assert_eq(&shown);
    };
    check(
        "program main.clad\nplant ta$0nk.clad\n",
        expect![[r#"
        [tank.clad] 
        press/tank.clad: 1 network, 5 tags

        A model of the machine, which runs beside the program: its outputs are inputs of the program and the reverse, where names and types are the same. Its tags are `plant.level` in rows and properties; with `as tank` after the file, `tank.level`.
        definition press/tank.clad:1:1 
    "#]],
    );
    check(
        "program main.clad\nplant tank.clad as it\nconnect it.sen$0sor = near\nnever it.sensor\n",
        expect![[r#"
            [it.sensor] press/tank.clad
            `it.sensor` : BOOL, of

            ```clad
            sensor : BOOL
            ```
            Output (declared in VAR_OUTPUT on line [2](#L2))  
            Written: line [3](#L3)  
            Read: nowhere

            ```clad
            +--[ ]( pump )--[/]( leak )--[ADD]( level, level, wanted )--[GE]( level, 1.0 )--( )( sensor )--+
            ```

            ---

            Connected: the input takes the value of the output before each scan.
            definition press/tank.clad:2:26 sensor
            press/tank.clad:2:26 sensor Definition
            press/tank.clad:3:86 sensor Write
        "#]],
    );
    check(
        "program main.clad\nplant tank.clad\nconnect plant.sensor = ne$0ar\n",
        expect![[r#"
            [near] press/main.clad
            ```clad
            near : BOOL
            ```
            Input (declared in VAR_INPUT on line [1](#L1))  
            Written: nowhere  
            Read: line [4](#L4)

            ```clad
            +--[ ]( near )--\--( )( seen )---------------+
            ```

            ---

            Connected: the input takes the value of the output before each scan.
            definition press/main.clad:1:11 near
            press/main.clad:1:11 near Definition
            press/main.clad:4:9 near Read
        "#]],
    );
    check(
        "program main.clad\nplant tank.clad\nnever plant.lev$0el > 5.0\n",
        expect![[r#"
            [plant.level] press/tank.clad
            `plant.level` : REAL, of

            ```clad
            level : REAL
            ```
            Output (declared in VAR_OUTPUT on line [2](#L2))  
            Written: line [3](#L3)  
            Read: line [3](#L3)

            ```clad
            +--[ ]( pump )--[/]( leak )--[ADD]( level, level, wanted )--[GE]( level, 1.0 )--( )( sensor )--+
            ```

            ---

            What it is after a scan.
            definition press/tank.clad:2:12 level
            press/tank.clad:2:12 level Definition
            press/tank.clad:3:37 level Write
            press/tank.clad:3:44 level Read
            press/tank.clad:3:67 level Read
        "#]],
    );
}

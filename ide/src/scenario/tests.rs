//! Features of scenario files, each at a cursor.

use super::{
    Scenarios, prepare_scenario_rename, rename_in_scenario, scenario_completions, scenario_definition,
    scenario_highlights, scenario_hover, scenario_outline, scenario_references,
};
use crate::fixture::Fixture;
use expect_test::{Expect, expect};
use ladder_format::{Options, apply};
use ladder_simulator::scenario::parse;
use ladder_syntax::TextSize;

const PLANT: &str = "\
%% main.clad
VAR_INPUT start : BOOL; # the green *button* # END_VAR
VAR_OUTPUT run : BOOL; END_VAR
VAR warm : TON; total : DINT; list : ARRAY[1..2] OF INT; END_VAR
+--[ ]( start )--[TON]( warm, 5s )--( )( run )--+
+--[ ]( run )--[ADD]( total, total, 1 )--[MOV]( list[1], 2 )--+
+--<CALL>( count )--+
%% lib.clad
VAR total, go : BOOL; list : ARRAY[1..2] OF INT; END_VAR
+--<FUN>( count )--[ ]( go )--( )( total )--+
%% other.ladder-test
program main.clad
scenario \"other\"
start _-
run => _-
";

/// The workspace of [`PLANT`] with one more file of scenarios, in which the cursor is.
struct Asked {
    fixture: Fixture,
    text: String,
    offset: TextSize,
}

impl Asked {
    fn at(text: &str) -> Asked {
        let at = text.find("$0").expect("a cursor");
        let text = text.replacen("$0", "", 1);
        let fixture = Fixture::new(&format!("{PLANT}%% main.ladder-test\n{text}"));
        Asked {
            fixture,
            text,
            offset: TextSize::new(at as u32),
        }
    }

    /// Asks, as an editor does: of a text that was read once, and of all files of the workspace.
    fn ask<T>(&self, question: impl FnOnce(&Scenarios<'_>) -> T) -> T {
        question(&Scenarios {
            text: &self.text,
            suite: &parse(&self.text),
            program: Some(&self.fixture.files[0].0.context),
            workspace: &self.fixture.others(0),
        })
    }

    fn completions(&self, trigger: Option<char>) -> String {
        let programs = ["a.clad".to_owned(), "main.clad".to_owned()];
        let found = self.ask(|it| scenario_completions(it, self.offset, &programs, trigger));
        let item = |it: &crate::Completion| format!("{}|{}|{}\n", it.label, it.detail, it.text.snippet());
        found.items.iter().map(item).collect::<Vec<_>>().concat()
    }
}

const HEAD: &str = "program main.clad\nstep 100ms\n\nscenario \"one\"\n";

#[test]
fn completion_of_headings() {
    let check = |text: &str, expected: Expect| expected.assert_eq(&Asked::at(text).completions(None));
    check(
        "program main.clad\n$0\n",
        expect![[r#"
            step||step 
            interval||interval 
            tolerance||tolerance 
            scenario||scenario "${1:what is shown}"
            $0
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
            scenario||scenario "${1:what is shown}"
            $0
        "#]],
    );
    // What has a row is not proposed, and what is behind the cursor stays.
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
            scenario||scenario "${1:what is shown}"
            $0
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

/// A file of functions that uses another one with a block of its own, and one that nobody uses.
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
        let item = |it: &crate::Completion| format!("{}|{}|{}\n", it.label, it.detail, it.text.snippet());
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
        scenario||scenario "${1:what is shown}"
        $0
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
fn hover_says_what_a_row_and_a_value_mean() {
    let check = |rows: &str, expected: Expect| {
        let asked = Asked::at(&format!("{HEAD}{rows}"));
        let found = asked.ask(|it| scenario_hover(it, asked.offset));
        let shown = found.map(|(it, file)| {
            let file = file.filter(|file| **file != *"main.clad");
            let links = file.map_or(String::new(), |file| format!("(lines of {file})\n"));
            format!("[{}]\n{}\n{links}", &asked.text[it.range], it.markdown)
        });
        expected.assert_eq(&shown.unwrap_or_default());
    };
    check(
        "st$0art _-_\n",
        expect![[r#"
        [start]
        the green \*button

        ```clad
        start : BOOL
        ```
        Input (declared in VAR_INPUT on line [1](#L1))  
        Written: nowhere  
        Read: line [4](#L4)

        ```clad
        +--[ ]( start )--[TON]( warm, 5s )--( )( run )--+
        ```

        ---

        Given before the first scan of each step.
    "#]],
    );
    check(
        "warm.E$0T => 1s\n",
        expect![[r#"
        [warm.ET]
        `warm.ET` : TIME, of

        ```clad
        warm : TON
        ```
        Internal tag (declared in VAR on line [3](#L3))  
        Written: line [4](#L4)  
        Read: line [4](#L4)

        ```clad
        +--[ ]( start )--[TON]( warm, 5s )--( )( run )--+
        ```

        ---

        Expected after the last scan of each step.
    "#]],
    );
    check(
        "start _-$0_\n",
        expect![[r#"
        [_]
        `start` is given: low (`FALSE`)  
        step 3 of 3: 200ms to 300ms
    "#]],
    );
    check(
        "start _-.$0\n",
        expect![[r#"
        [.]
        `start` is not given anew; last it was high (`TRUE`)  
        step 3 of 3: 200ms to 300ms
    "#]],
    );
    check(
        "run =$0> _-\n",
        expect![[r#"
        [=>]
        What is behind `=>` is expected of the program after each step.
    "#]],
    );
    check(
        "run => _.$0-\n",
        expect![[r#"
        [-]
        `run` is expected to be high (`TRUE`)  
        step 3 of 3: 200ms to 300ms
    "#]],
    );
    check(
        "total => 1 16#0$0F\n",
        expect![[r#"
        [16#0F]
        `total` is expected to be `15`  
        step 2 of 2: 100ms to 200ms
    "#]],
    );
    check(
        "lib.li$0st[2] => 0 1\n",
        expect![[r#"
        [lib.list[2]]
        `lib.list[2]` : INT, of

        ```clad
        list : ARRAY[1..2] OF INT
        ```
        Internal tag (declared in VAR on line [1](#L1))  
        Written: nowhere  
        Read: nowhere

        ---

        Expected after the last scan of each step.
        (lines of lib.clad)
    "#]],
    );
    check(
        "lib.go _$0-\n",
        expect![[r#"
        [-]
        `lib.go` is given: high (`TRUE`)  
        step 2 of 2: 100ms to 200ms
    "#]],
    );
    check(
        "total => 1 2 ± 1$0%\n",
        expect![[r#"
        [± 1%]
        How far a value may be from what is expected: `± 0.01`, or a part of it, `± 1%`.
    "#]],
    );
    let asked = Asked::at("program ma$0in.clad\n");
    let found = asked.ask(|it| scenario_hover(it, asked.offset)).unwrap().0;
    expect!["main.clad: 3 networks, 5 tags"].assert_eq(&found.markdown);
    let asked = Asked::at("program main.clad\nst$0ep 1s\n");
    let found = asked.ask(|it| scenario_hover(it, asked.offset)).unwrap().0;
    assert!(found.markdown.starts_with("How long a step is"));
}

#[test]
fn a_row_leads_to_its_declaration_and_to_all_uses() {
    let check = |rows: &str, expected: Expect| {
        let asked = Asked::at(&format!("{HEAD}{rows}"));
        let mut shown = String::new();
        for target in asked.ask(|it| scenario_definition(it, asked.offset)) {
            shown.push_str(&format!(
                "definition {}\n",
                asked.fixture.show(&target.file, target.focus)
            ));
        }
        for it in asked.ask(|it| scenario_references(it, asked.offset)) {
            shown.push_str(&format!(
                "{} {:?}\n",
                asked.fixture.show(&it.file, it.range),
                it.usage
            ));
        }
        for it in asked.ask(|it| scenario_highlights(it, asked.offset)) {
            shown.push_str(&format!(
                "highlight {} {:?}\n",
                asked.fixture.show("main.ladder-test", it.range),
                it.usage
            ));
        }
        expected.assert_eq(&shown);
    };
    check(
        "start _-\nru$0n => _-\nwarm.ET => 0s 1s\n",
        expect![[r#"
        definition main.clad:2:12 run
        main.clad:2:12 run Definition
        main.clad:4:42 run Write
        main.clad:5:9 run Read
        other.ladder-test:4:1 run Read
        main.ladder-test:6:1 run Read
        highlight main.ladder-test:6:1 run Read
    "#]],
    );
    // A tag of a file that the program uses; the program has another one of that name.
    check(
        "lib.to$0tal => _-\nlib.go _-\ntotal => 1 1\nLIB.TOTAL => _-\n",
        expect![[r#"
            definition lib.clad:1:5 total
            lib.clad:1:5 total Definition
            lib.clad:2:36 total Write
            main.ladder-test:5:5 total Read
            main.ladder-test:8:5 TOTAL Read
            highlight main.ladder-test:5:5 total Read
            highlight main.ladder-test:8:5 TOTAL Read
        "#]],
    );
    check(
        "li$0b.list[1] => 0 1\nlib.list[2] => 0 1\n",
        expect![[r#"
        definition lib.clad:1:23 list
        lib.clad:1:23 list Definition
        main.ladder-test:5:5 list Read
        main.ladder-test:6:5 list Read
        highlight main.ladder-test:5:5 list Read
        highlight main.ladder-test:6:5 list Read
    "#]],
    );
    check("lib.nothing$0 => _-\nother.total => _-\n", expect![]);
}

#[test]
fn a_tag_of_the_program_has_places_in_scenarios() {
    let fixture = Fixture::new(&PLANT.replace("VAR_OUTPUT run", "VAR_OUTPUT ru$0n"));
    let (context, offset, others) = fixture.ask();
    let shown: Vec<String> = crate::references(context, offset, &others)
        .iter()
        .map(|it| format!("{} {:?}\n", fixture.show(&it.file, it.range), it.usage))
        .collect();
    let shown = shown.concat();
    expect![[r#"
        main.clad:2:12 run Definition
        main.clad:4:42 run Write
        main.clad:5:9 run Read
        other.ladder-test:4:1 run Read
    "#]]
    .assert_eq(&shown);
}

#[test]
fn rename_reaches_the_program_and_all_scenarios() {
    let check = |rows: &str, new: &str, expected: Expect| {
        let asked = Asked::at(&format!("{HEAD}{rows}"));
        let renamed = asked.ask(|it| rename_in_scenario(it, asked.offset, new, &Options::default()));
        let shown = match renamed {
            Err(refused) => format!("refused: {refused}\n"),
            Ok(files) => files
                .iter()
                .map(|it| {
                    format!(
                        "%% {}\n{}",
                        it.file,
                        apply(asked.fixture.text(&it.file), &it.edits)
                    )
                })
                .collect::<Vec<_>>()
                .concat(),
        };
        expected.assert_eq(&shown);
    };
    check(
        "start _-\nru$0n => _-\n",
        "motor",
        expect![[r#"
            %% main.clad
            VAR_INPUT start : BOOL; # the green *button* # END_VAR
            VAR_OUTPUT motor : BOOL; END_VAR
            VAR warm : TON; total : DINT; list : ARRAY[1..2] OF INT; END_VAR
            +--[ ]( start )-------------------------------[TON]( warm, 5s )--( )( motor )--+
            +--[ ]( motor )-----------------[ADD]( total, total, 1 )--[MOV]( list[1], 2 )--+
            +--<CALL>( count )--+
            %% other.ladder-test
            program main.clad
            scenario "other"
            start   _-
            motor => _-
            %% main.ladder-test
            program main.clad
            step 100ms

            scenario "one"
            start   _-
            motor => _-
        "#]],
    );
    check(
        "war$0m.ET => 0s\n",
        "heat",
        expect![[r#"
            %% main.clad
            VAR_INPUT start : BOOL; # the green *button* # END_VAR
            VAR_OUTPUT run : BOOL; END_VAR
            VAR heat : TON; total : DINT; list : ARRAY[1..2] OF INT; END_VAR
            +--[ ]( start )--[TON]( heat, 5s )--( )( run )--+
            +--[ ]( run )--[ADD]( total, total, 1 )--[MOV]( list[1], 2 )--+
            +--<CALL>( count )--+
            %% main.ladder-test
            program main.clad
            step 100ms

            scenario "one"
            heat.ET => 0s
        "#]],
    );
    check(
        "lib.to$0tal => _-\ntotal => 1 1\n",
        "count_of_parts",
        expect![[r#"
            %% lib.clad
            VAR count_of_parts, go : BOOL; list : ARRAY[1..2] OF INT; END_VAR
            +--<FUN>( count )--[ ]( go )--------( )( count_of_parts )--+
            %% main.ladder-test
            program main.clad
            step 100ms

            scenario "one"
            lib.count_of_parts => _-
            total          => 1 1
        "#]],
    );
    check(
        "lib.to$0tal => _-\n",
        "go",
        expect![[r#"
            refused: there is a tag `go` on line 1 of lib.clad already: both would become one
        "#]],
    );
    check(
        "start$0 _-\n",
        "run",
        expect![[r#"
        refused: there is a tag `run` on line 2 of main.clad already: both would become one
    "#]],
    );
    check(
        "nothing$0 _-\n",
        "run",
        expect![[r#"
        refused: there is nothing to rename here
    "#]],
    );
    check(
        "start _$0-\n",
        "run",
        expect![[r#"
        refused: there is nothing to rename here
    "#]],
    );
    let asked = Asked::at(&format!("{HEAD}war$0m.ET => 0s\n"));
    let found = asked
        .ask(|it| prepare_scenario_rename(it, asked.offset))
        .unwrap()
        .unwrap();
    assert_eq!(found.name, "warm");
}

#[test]
fn the_outline_holds_scenarios_with_their_rows() {
    let asked = Asked::at(&format!("{HEAD}start _-$0\nrun => _-\nscenario \"two\"\n"));
    let mut shown = String::new();
    for part in asked.ask(scenario_outline) {
        shown.push_str(&format!(
            "{} ({}) {:?}\n",
            part.name, part.detail, &asked.text[part.range]
        ));
        for row in part.children {
            shown.push_str(&format!(
                "    {} ({}) {:?}\n",
                row.name, row.detail, &asked.text[row.range]
            ));
        }
    }
    expect![[r#"
        one (2 steps) "scenario \"one\"\nstart _-\nrun => _-"
            start (given) "start _-"
            run (expected) "run => _-"
        two (0 steps) "scenario \"two\""
    "#]]
    .assert_eq(&shown);
}

//! Where a tag is declared and used, and its rename everywhere.

use super::super::{scenario_definition, scenario_highlights};
use super::{Asked, HEAD, PLANT};
use crate::fixture::Fixture;
use crate::references::scenario_references;
use crate::rename::{prepare_scenario_rename, rename_in_scenario};
use expect_test::{Expect, expect};
use ladder_format::{Options, apply};

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
    let shown: Vec<String> = crate::references::references(context, offset, &others)
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
            +--<FUN>( count )--[ ]( go )----------------------------( )( count_of_parts )--+
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

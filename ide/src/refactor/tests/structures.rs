//! Tags become members of a structure and come back; what the program does stays, and scenarios follow.

use super::{check, fixture};
use crate::fixture::{Fixture, played};
use crate::refactor::refactorings;
use expect_test::{Expect, expect};
use ladder_format::{Options, apply};

/// What an action makes of a program and its scenarios, which hold before and after.
#[track_caller]
fn kept(begin: &str, marked: &str, scenarios: &str, expected: Expect) -> String {
    let (program, range) = fixture(marked);
    let before = played(&program, scenarios);
    assert!(
        before.starts_with("ok ") && !before.contains("FAILED"),
        "{before}"
    );
    let files = Fixture::new(&format!(
        "%% main.clad\n{program}%% main.ladder-test\n{scenarios}"
    ));
    let analysis = &files.files[0].0;
    let actions = refactorings(analysis, range);
    let found = actions.iter().find(|action| action.title.starts_with(begin));
    let action = found.unwrap_or_else(|| panic!("{begin} is not offered"));
    assert_eq!(action.disabled, None);
    let changed = action.everywhere(analysis, &program, &Options::default(), &files.others(0));
    let new = |file: &str| {
        let old = files.text(file);
        let edits = changed.iter().find(|changed| *changed.file == *file);
        edits.map_or_else(|| old.to_owned(), |changed| apply(old, &changed.edits))
    };
    let (program, scenarios) = (new("main.clad"), new("main.ladder-test"));
    expected.assert_eq(&format!("{}\n\n{program}\n%%\n{scenarios}", action.title));
    assert_eq!(played(&program, &scenarios), before, "{program}\n{scenarios}");
    program
}

const PUMPS: &str = r#"# Two pumps #
VAR_INPUT
    go : BOOL;
END_VAR

# All that is known of the pumps #
VAR RETAIN
    pump1_run, pump1_fault : BOOL;  # it runs; it does not #
    pump1_wait             : TON;
    pump2_run              : BOOL;
    pump1_speeds           : ARRAY[1..3] OF INT := [1, 2, 3];
    pump1_code             : WORD := 16#0F;
    pump2_fault            : BOOL;
    k                      : INT := 2;
END_VAR

+--[ ]( go )--[TON]( pump1_wait, 30ms )--\--( )( pump1_run )-----------------+
|                                        /--[ADD]( pump1_speeds[k], k, 7 )---+
+--[ ]( pump1_wait.DN )--[/]( pump1_code.2 )--( )( pump1_fault )--+
+--[CALC]( total, SUM(pump1_speeds[1..3]) + pump1_speeds[k] )--[P]( pump1_run )--[BMOV]( copy[1..3], pump1_speeds[1..3] )--+
+--[ ]( pump1_run )--(S)( pump2_run )--( )( pump2_fault )--+
VAR
    copy : ARRAY[1..3] OF INT;
END_VAR
"#;

const PUMPED: &str = r#"program main.clad

scenario "the first pump"
go                 _-----
pump1_run       => ____--
pump1_wait.ET   => 0ms 0ms 10ms 20ms 30ms 30ms
pump1_speeds[2] => 2 2 2 2 9 9
pump1_code.1    => ------
pump1_fault     => ______
pump2_run       => ____--
total           => 8 8 8 8 8 22
"#;

#[test]
fn tags_that_begin_alike() {
    let marked = PUMPS.replacen("pump1_wait    ", "pump1$0_wait    ", 1);
    kept("Extract", &marked, PUMPED, expect![[r#""#]]);
}

#[test]
fn tags_that_are_selected() {
    let marked = PUMPS
        .replacen("    pump1_wait ", "    pump1$0_wait ", 1)
        .replacen("pump1_speeds  ", "pu$1mp1_speeds  ", 1);
    kept("Extract", &marked, PUMPED, expect![[r#""#]]);
}

/// A second group becomes a tag of the type that is there.
#[test]
fn another_of_a_known_type() {
    check(
        "Extract",
        "\
TYPE
    Pump : STRUCT
        run   : BOOL;
        level : INT := 5;
    END_STRUCT;
END_TYPE
VAR pump1 : Pump; pump2_run : BOOL; pump2$0_level : INT := 5; END_VAR
+--[ ]( pump1.run )--[MOV]( pump2_level, pump1.level )--( )( pump2_run )--+
",
        expect![[r#"
            Extract 2 tags into the structure `Pump`

            TYPE
                Pump : STRUCT
                    run   : BOOL;
                    level : INT := 5;
                END_STRUCT;
            END_TYPE
            VAR
                pump1 : Pump;
                pump2 : Pump;
            END_VAR
            +--[ ]( pump1.run )-------[MOV]( pump2.level, pump1.level )--( )( pump2.run )--+
        "#]],
    );
}

/// Why the first of the actions that begin so cannot be done, for each of some programs.
#[track_caller]
fn refused(begin: &str, programs: &[&str], expected: Expect) {
    let mut shown = String::new();
    for marked in programs {
        let (text, range) = fixture(&format!("{marked}\n+--[ ]( go )--( )( on )--+\n"));
        let actions = super::offered(&text, range);
        let found = actions.into_iter().find(|action| action.title.starts_with(begin));
        let why = match found {
            None => "not offered".to_owned(),
            Some(action) => action.disabled.unwrap_or(action.title),
        };
        shown.push_str(&format!("{marked}\n    {why}\n"));
    }
    expected.assert_eq(&shown);
}

#[test]
fn tags_that_stay() {
    refused(
        "Extract",
        &[
            "VAR_INPUT a_x$0 AT %IX0.0 : BOOL; a_y : BOOL; END_VAR",
            "VAR_GLOBAL a_x$0, a_y : BOOL; END_VAR",
            "VAR CONSTANT a_x$0 : INT := 1; a_y : INT := 2; END_VAR",
            "VAR $0a_x : INT; END_VAR VAR_INPUT a_y : INT;$1 END_VAR",
            "VAR $0a_x : INT; a_y : NOTHING;$1 END_VAR",
            "VAR a_x$0, # the first # a_y : INT; END_VAR",
            "VAR a_x$0, b_y : INT; END_VAR",
            "FUNCTION_BLOCK [$B]\nVAR_INPUT a_x$0, a_y : BOOL; END_VAR\nEND_FUNCTION_BLOCK",
            "# ladder: profile click #\nVAR a_x$0, a_y : BOOL; END_VAR",
        ],
        expect![[r#"
            VAR_INPUT a_x$0 AT %IX0.0 : BOOL; a_y : BOOL; END_VAR
                `a_x`: it is at a direct address
            VAR_GLOBAL a_x$0, a_y : BOOL; END_VAR
                `a_x`: other files know it by its name
            VAR CONSTANT a_x$0 : INT := 1; a_y : INT := 2; END_VAR
                `a_x`: bounds of arrays may name it
            VAR $0a_x : INT; END_VAR VAR_INPUT a_y : INT;$1 END_VAR
                fix the errors of the file first
            VAR $0a_x : INT; a_y : NOTHING;$1 END_VAR
                fix the errors of the file first
            VAR a_x$0, # the first # a_y : INT; END_VAR
                a comment stands between the names of a declaration
            VAR a_x$0, b_y : INT; END_VAR
                not offered
            FUNCTION_BLOCK [$B]
            VAR_INPUT a_x$0, a_y : BOOL; END_VAR
            END_FUNCTION_BLOCK
                `a_x`: it is an operand of its block
            # ladder: profile click #
            VAR a_x$0, a_y : BOOL; END_VAR
                programs of this profile have no structures
        "#]],
    );
}

/// A body's own tags, which scenarios name by the place or the tag of its state.
#[test]
fn tags_of_a_body() {
    let program = "\
FUNCTION_BLOCK [$Count]
VAR_INPUT
    raw : BOOL;
END_VAR
VAR
    n_up, n_all : DINT;
END_VAR
+--[ ]( raw )--[ADD]( n_up, n_up, 1 )--[ADD]( n$0_all, n_all, n_up )--( )( ENO )--+
END_FUNCTION_BLOCK

VAR
    c : $Count;
END_VAR

+--[$Count]( c, go )--[$Count]( go )--( )( on )--+
"
    .replacen("n$0_all", "n_all", 1)
    .replacen("n_up, n_all :", "n_up, n$0_all :", 1);
    let scenarios = "program main.clad\n\nscenario \"counts\"\ngo               _--\nc.n_all       => 0 1 3\n$Count#1.n_up => 0 1 2\n";
    kept("Extract", &program, scenarios, expect![[r#"
        Extract 2 tags into the structure `N`

        TYPE
            N : STRUCT
                up, all : DINT;
            END_STRUCT;
        END_TYPE

        FUNCTION_BLOCK [$Count]
        VAR_INPUT
            raw : BOOL;
        END_VAR
        VAR
            n : N;
        END_VAR
        +--[ ]( raw )---------------------[ADD]( n.up, n.up, 1 )--[ADD]( n.all, n.all, n.up )--( )( ENO )--+
        END_FUNCTION_BLOCK

        VAR
            c : $Count;
        END_VAR

        +--[$Count]( c, go )--[$Count]( go )--( )( on )--+

        %%
        program main.clad

        scenario "counts"
        go               _--
        c.n.all       => 0 1 3
        $Count#1.n.up => 0 1 2
    "#]]);
}

//! Tags become members of a structure and come back; what the program does stays, and scenarios follow.

use super::{check, fixture};
use crate::fixture::{Fixture, played};
use crate::refactor::refactorings;
use expect_test::{Expect, expect};
use ladder_format::{Options, apply};

/// What an action makes of a program and its scenarios, which hold before and after.
#[track_caller]
fn kept(begin: &str, marked: &str, scenarios: &str) -> String {
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
    assert_eq!(played(&program, &scenarios), before, "{program}\n{scenarios}");
    format!("{}\n\n{program}\n%%\n{scenarios}", action.title)
}

fn shows(shown: &str, expected: Expect) {
    expected.assert_eq(shown);
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
total           => 8 8 8 8 22 22
"#;

#[test]
fn tags_that_begin_alike() {
    let marked = PUMPS.replacen("pump1_wait    ", "pump1$0_wait    ", 1);
    shows(
        &kept("Extract", &marked, PUMPED),
        expect![[r#"
        Extract 5 tags into the structure `Pump`

        # Two pumps #
        VAR_INPUT
            go : BOOL;
        END_VAR

        TYPE
            Pump : STRUCT
                run, fault : BOOL;  # it runs; it does not #
                wait       : TON;
                speeds     : ARRAY[1..3] OF INT := [1, 2, 3];
                code       : WORD               := 16#0F;
            END_STRUCT;
        END_TYPE

        # All that is known of the pumps #
        VAR RETAIN
            pump1       : Pump;
            pump2_run   : BOOL;
            pump2_fault : BOOL;
            k           : INT := 2;
        END_VAR

        +--[ ]( go )-----[TON]( pump1.wait, 30ms )--\----------------( )( pump1.run )--+
        |                                           /--[ADD]( pump1.speeds[k], k, 7 )--+
        +--[ ]( pump1.wait.DN )--[/]( pump1.code.2 )---------------( )( pump1.fault )--+
        +--[CALC]( total, SUM(pump1.speeds[1..3]) + pump1.speeds[k] )--[P]( pump1.run )------------------[BMOV]( copy[1..3], pump1.speeds[1..3] )--+
        +--[ ]( pump1.run )----------------------(S)( pump2_run )--( )( pump2_fault )--+
        VAR
            copy : ARRAY[1..3] OF INT;
        END_VAR

        %%
        program main.clad

        scenario "the first pump"
        go                 _-----
        pump1.run       => ____--
        pump1.wait.ET   => 0ms 0ms 10ms 20ms 30ms 30ms
        pump1.speeds[2] => 2 2 2 2 9 9
        pump1.code.1    => ------
        pump1.fault     => ______
        pump2_run       => ____--
        total           => 8 8 8 8 22 22
    "#]],
    );
}

#[test]
fn tags_that_are_selected() {
    let marked = PUMPS
        .replacen("    pump1_wait ", "    pump1$0_wait ", 1)
        .replacen("pump1_speeds  ", "pu$1mp1_speeds  ", 1);
    shows(
        &kept("Extract", &marked, PUMPED),
        expect![[r#"
        Extract 3 tags into the structure `Group`

        # Two pumps #
        VAR_INPUT
            go : BOOL;
        END_VAR

        TYPE
            Group : STRUCT
                pump1_wait   : TON;
                pump2_run    : BOOL;
                pump1_speeds : ARRAY[1..3] OF INT := [1, 2, 3];
            END_STRUCT;
        END_TYPE

        # All that is known of the pumps #
        VAR RETAIN
            pump1_run, pump1_fault : BOOL;  # it runs; it does not #
            group                  : Group;
            pump1_code             : WORD := 16#0F;
            pump2_fault            : BOOL;
            k                      : INT  := 2;
        END_VAR

        +--[ ]( go )-------------[TON]( group.pump1_wait, 30ms )--\----------------------( )( pump1_run )--+
        |                                                         /--[ADD]( group.pump1_speeds[k], k, 7 )--+
        +--[ ]( group.pump1_wait.DN )--[/]( pump1_code.2 )---------( )( pump1_fault )--+
        +--[CALC]( total, SUM(group.pump1_speeds[1..3]) + group.pump1_speeds[k] )--[P]( pump1_run )--------------------[BMOV]( copy[1..3], group.pump1_speeds[1..3] )--+
        +--[ ]( pump1_run )----------------(S)( group.pump2_run )--( )( pump2_fault )--+
        VAR
            copy : ARRAY[1..3] OF INT;
        END_VAR

        %%
        program main.clad

        scenario "the first pump"
        go                       _-----
        pump1_run             => ____--
        group.pump1_wait.ET   => 0ms 0ms 10ms 20ms 30ms 30ms
        group.pump1_speeds[2] => 2 2 2 2 9 9
        pump1_code.1          => ------
        pump1_fault           => ______
        group.pump2_run       => ____--
        total                 => 8 8 8 8 22 22
    "#]],
    );
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
            "VAR a_x$0 : ARRAY[1..16] OF WORD; a_y : ARRAY[1..16] OF TIME; END_VAR\n+--[$Drum]( a_x, a_y, 3 )--( )( on )--+",
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
            VAR a_x$0 : ARRAY[1..16] OF WORD; a_y : ARRAY[1..16] OF TIME; END_VAR
            +--[$Drum]( a_x, a_y, 3 )--( )( on )--+
                `a_x` goes into `[$Drum]` by reference, as a whole array
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
    shows(
        &kept("Extract", &program, scenarios),
        expect![[r#"
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
    "#]],
    );
}

/// Members become tags, each with what it has at the start.
#[test]
fn members_become_tags() {
    let structured = "\
TYPE
    Valve : STRUCT
        open, shut : BOOL;
        wait       : TON;
        spot       : ARRAY[1..2] OF INT := [5, 6];
        phase      : Phase := FULL;
    END_STRUCT;
    Phase : (IDLE, FULL);
END_TYPE

VAR RETAIN
    inlet$0 : Valve := (shut := TRUE);  # lets it in #
    k     : INT := 1;
END_VAR

+--[ ]( go )--[TON]( inlet.wait, 20ms )--( )( inlet.open )--+
+--[EQ]( inlet.phase, FULL )--[ADD]( total, inlet.spot[k], inlet.spot[2] )--[/]( inlet.shut )--( )( on )--+
+--[ ]( inlet.wait.Q )--\\--(R)( inlet.shut )----------+
|                        /--[MOV]( inlet.phase, IDLE )--+
";
    let scenarios = "program main.clad\n\nscenario \"opens\"\ngo               _-----\ninlet.wait.ET => 0ms 0ms 10ms 20ms 20ms 20ms\n\
        inlet.open    => ___---\ninlet.spot[2]   => 6 6 6 6 6 6\ninlet.phase   => FULL FULL FULL IDLE IDLE IDLE\non            => ______\n";
    shows(
        &kept("Replace", structured, scenarios),
        expect![[r#"
            Replace `inlet` by a tag for each member of `Valve`

            TYPE
                Valve : STRUCT
                    open, shut : BOOL;
                    wait       : TON;
                    spot       : ARRAY[1..2] OF INT := [5, 6];
                    phase      : Phase := FULL;
                END_STRUCT;
                Phase : (IDLE, FULL);
            END_TYPE

            VAR RETAIN
                inlet_open  : BOOL;  # lets it in #
                inlet_shut  : BOOL               := TRUE;
                inlet_wait  : TON;
                inlet_spot  : ARRAY[1..2] OF INT := [5, 6];
                inlet_phase : Phase              := FULL;
                k           : INT                := 1;
            END_VAR

            +--[ ]( go )---------------------[TON]( inlet_wait, 20ms )--( )( inlet_open )--+
            +--[EQ]( inlet_phase, FULL )--[ADD]( total, inlet_spot[k], inlet_spot[2] )--[/]( inlet_shut )---------------( )( on )--+
            +--[ ]( inlet_wait.Q )--\-----------------------------------(R)( inlet_shut )--+
            |                       /--------------------------[MOV]( inlet_phase, IDLE )--+

            %%
            program main.clad

            scenario "opens"
            go               _-----
            inlet_wait.ET => 0ms 0ms 10ms 20ms 20ms 20ms
            inlet_open    => ___---
            inlet_spot[2]   => 6 6 6 6 6 6
            inlet_phase   => FULL FULL FULL IDLE IDLE IDLE
            on            => ______
        "#]],
    );
    let a = "TYPE A : STRUCT\n x : BOOL;\nEND_STRUCT;\nEND_TYPE\n";
    refused(
        "Replace",
        &[
            &format!("{a}VAR a$0, b : A; END_VAR\n+--[MOV]( a, b )--+"),
            &format!("{a}VAR a$0 : A; a_x : BOOL; END_VAR"),
            &format!("{a}VAR a$0 : ARRAY[1..2] OF A; END_VAR"),
            &format!("{a}VAR_GLOBAL a$0 : A; END_VAR"),
            &a.replace("STRUCT;", "STRUCT := (x := TRUE);")
                .replace("TYPE\n", "TYPE\nVAR a$0 : A; END_VAR\n"),
        ],
        expect![[r#"
            TYPE A : STRUCT
             x : BOOL;
            END_STRUCT;
            END_TYPE
            VAR a$0, b : A; END_VAR
            +--[MOV]( a, b )--+
                `a` is used as a whole on line 6
            TYPE A : STRUCT
             x : BOOL;
            END_STRUCT;
            END_TYPE
            VAR a$0 : A; a_x : BOOL; END_VAR
                there is a tag `a_x` already
            TYPE A : STRUCT
             x : BOOL;
            END_STRUCT;
            END_TYPE
            VAR a$0 : ARRAY[1..2] OF A; END_VAR
                not offered
            TYPE A : STRUCT
             x : BOOL;
            END_STRUCT;
            END_TYPE
            VAR_GLOBAL a$0 : A; END_VAR
                `a`: other files know it by its name
            TYPE A : STRUCT
             x : BOOL;
            END_STRUCT := (x := TRUE);
            END_TYPE
            VAR a$0 : A; END_VAR

                `A` has values at the start of its own: write those of the tag first
        "#]],
    );
}

const COUNTS: &str = "\
FUNCTION_BLOCK [$Count]
VAR_INPUT
    raw : BOOL;
END_VAR
VAR
    n : DINT;
END_VAR
+--[ ]( raw )--[ADD]( n, n, 1 )--( )( ENO )--+
END_FUNCTION_BLOCK

FUNCTION_BLOCK [$Both]
VAR_INPUT
    raw : BOOL;
END_VAR
+--[$Count]( raw )--[$Count]( EN )--( )( ENO )--+
END_FUNCTION_BLOCK

VAR
    c : $Count;
END_VAR

+--[$Count]( c, a )--[$Count]( b )--[$Count]( raw := d )--( )( on )--+
+--[$Both]( a )--[$Count]( a )--+
";

const COUNTED: &str = "program main.clad\n\nscenario \"counts\"\na                     _---\nb                     __--\nd                     ___-\n\
    c.n                => 0 1 2 3\n$Count#1.n         => 0 0 1 2\n$Count#2.n         => 0 0 0 1\n$Count#3.n         => 0 1 2 3\n\
    $Both#1.$Count#1.n => 0 1 2 3\n$Both#1.$Count#2.n => 1 2 3 4\n";

#[test]
fn the_state_of_a_place_gets_a_tag() {
    let mut shown = String::new();
    for place in [
        "[$Count]( b",
        "[$Count]( raw :",
        "[$Count]( EN",
        "[$Count]( raw )--[",
        "[$Count]( a )--+",
    ] {
        let marked = COUNTS.replacen(place, &place.replacen("$Count", "$Co$0unt", 1), 1);
        let changed = kept("Give", &marked, COUNTED);
        let lines = changed
            .lines()
            .filter(|line| !COUNTS.contains(line) && !COUNTED.contains(line));
        lines.for_each(|line| shown.push_str(&format!("{line}\n")));
    }
    shows(
        &shown,
        expect![[r#"
        Give the state of `[$Count]` the tag `count1`
            c      : $Count;
            count1 : $Count;
        +----[$Count]( c, a )--[$Count]( count1, b )--[$Count]( raw := d )--( )( on )--+
        %%
        count1.n           => 0 0 1 2
        $Count#1.n         => 0 0 0 1
        $Count#2.n         => 0 1 2 3
        Give the state of `[$Count]` the tag `count1`
            c      : $Count;
            count1 : $Count;
        +----[$Count]( c, a )--[$Count]( b )--[$Count]( count1, raw := d )--( )( on )--+
        %%
        count1.n           => 0 0 0 1
        $Count#2.n         => 0 1 2 3
        Give the state of `[$Count]` the tag `count1`
            count1 : $Count;
        +-------------------------[$Count]( raw )--[$Count]( count1, EN )--( )( ENO )--+
        %%
        $Both#1.count1.n   => 1 2 3 4
        Give the state of `[$Count]` the tag `count1`
            count1 : $Count;
        +-------------------------[$Count]( count1, raw )--[$Count]( EN )--( )( ENO )--+
        %%
        $Both#1.count1.n   => 0 1 2 3
        $Both#1.$Count#1.n => 1 2 3 4
        Give the state of `[$Count]` the tag `count1`
            c      : $Count;
            count1 : $Count;
        +-----------------------------------------[$Both]( a )--[$Count]( count1, a )--+
        %%
        count1.n           => 0 1 2 3
    "#]],
    );
}

/// What others may read is not taken apart.
#[test]
fn around_a_state_that_has_a_tag() {
    check(
        "Inline the block",
        &COUNTS.replacen("[$Count]( c", "[$Co$0unt]( c", 1),
        expect![[r#"
            disabled: its state belongs to a tag that others may read
        "#]],
    );
    let selected = "+--$0[$Count]( c, a )--[$Count]( b )$1";
    check(
        "Extract the selected",
        &COUNTS.replacen("+--[$Count]( c, a )--[$Count]( b )", selected, 1),
        expect![[r#"
            disabled: `c` keeps the state of a block, which stays where it is
        "#]],
    );
}

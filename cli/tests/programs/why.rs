//! `ladder why`

use crate::harness::Folder;
use expect_test::{Expect, expect};

const PLANT: &str = "\
VAR_INPUT
    start, stop : BOOL;
    level : INT;
END_VAR
VAR_OUTPUT
    run, horn, pump : BOOL;
END_VAR
VAR
    pause : TON;
END_VAR
VAR CONSTANT
    MAX : INT := 5;
END_VAR

+--\\--[ ]( start )--\\--[/]( stop )--[LT]( level, MAX )--( )( run )--+
|  /--[ ]( run )----/                                               |

+--[ ]( run )--[TON]( pause, 5s )--( )( horn )--+

+--[P]( start )--(S)( pump )--+
+--[ ]( stop )--(R)( pump )--+
";

fn check(tag: &str, values: &str, expected: Expect) {
    let folder = Folder::with(&[("plant.clad", PLANT), ("values.csv", values)]);
    let run = folder.ladder(&["why", "plant.clad", tag, "--tags", "values.csv"]);
    expected.assert_eq(&run.to_string());
}

#[test]
fn what_blocks_the_power_with_the_values_of_the_table() {
    check(
        "run",
        "start,1\nstop,0\nlevel,7\nrun,0\n",
        expect![[r#"
        exit status 0
        -- stdout
        run is 0: line 15, ( )( run ) writes 0; blocked by [LT]( level, MAX ) (line 15, column 37): level is 7, MAX is 5
          level is 7: it is an input

        │                          7                                                  │
        │     start     stop     level                                          run   │
        ┝━━┳━━┥━━━┝━━┳━━┥━/━┝━━━━┥ < ├─────────────────────────────────────────(   )──┤
        │  ┃         ┃            MAX                                                 │
        │  ┃         ┃             5                                                  │
        │  ┃   run   ┃                                                                │
        │  ┗━━┥   ├──┚                                                                │
    "#]],
    );
}

#[test]
fn values_that_contradict_the_program_are_said() {
    check(
        "run",
        "start;TRUE\nstop;FALSE\nlevel;3\nrun;0\n",
        expect![[r#"
            exit status 1
            -- stdout
            run is 0, against the program: line 15, ( )( run ) writes 1; power came through [ ]( start ) (line 15, column 7): start is 1, [/]( stop ) (line 15, column 24): stop is 0, [LT]( level, MAX ) (line 15, column 37): level is 3, MAX is 5
              start is 1: it is an input
              stop is 0: it is an input
              level is 3: it is an input

            │                          3                                                  │
            │     start     stop     level                                          run   │
            ┝━━┳━━┥━━━┝━━┳━━┥━/━┝━━━━┥━<━┝━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━(━━━)━━┥
            │  ┃         ┃            MAX                                                 │
            │  ┃         ┃             5                                                  │
            │  ┃   run   ┃                                                                │
            │  ┗━━┥   ├──┚                                                                │

            the values contradict the program: they were taken in mid-scan, something else writes the tag, or the controller runs another program
        "#]],
    );
}

#[test]
fn a_timer_is_as_far_as_the_table_says() {
    check(
        "horn",
        "Name,Monitor value\nrun,1\npause.ACC,1500\nhorn,0\n",
        expect![[r#"
            exit status 0
            -- stdout
            horn is 0: line 18, ( )( horn ) writes 0; blocked by [TON]( pause, 5s ) (line 18, column 16): pause.ET is T#1s500ms
              pause.ET is T#1s500ms: line 18, [TON]( pause, 5s ) writes T#1s500ms; power came through [ ]( run ) (line 18, column 4): run is 1
                run is 1, as far as the table goes: line 15, ( )( run ) writes 1; power came through [ ]( run ) (line 16, column 7): run is 1, [/]( stop ) (line 15, column 24): stop is 0, [LT]( level, MAX ) (line 15, column 37): level is 0, MAX is 5
                  stop is 0, though not in the table: it is an input
                  level is 0, though not in the table: it is an input

            │                                                            1s500ms          │
            │                                                             pause           │
            │   run                                                     ┌─ TON ─┐  horn   │
            ┝━━┥━━━┝━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━┥IN    Q├──(   )──┤
            │                                                           │PT 5s  │         │
            │                                                           └───────┘         │
        "#]],
    );
    check(
        "horn",
        "run,1\npause.ET,T#5s\nhorn,1\nstart,0\nstop,0\nlevel,1\n",
        expect![[r#"
            exit status 0
            -- stdout
            horn is 1: line 18, ( )( horn ) writes 1; power came through [ ]( run ) (line 18, column 4): run is 1, [TON]( pause, 5s ) (line 18, column 16): pause.ET is T#5s
              run is 1: line 15, ( )( run ) writes 1; power came through [ ]( run ) (line 16, column 7): run is 1, [/]( stop ) (line 15, column 24): stop is 0, [LT]( level, MAX ) (line 15, column 37): level is 1, MAX is 5
                stop is 0: it is an input
                level is 1: it is an input
              pause.ET is T#5s: line 18, [TON]( pause, 5s ) writes T#5s; power came through [ ]( run ) (line 18, column 4): run is 1

            │                                                              5s             │
            │                                                             pause           │
            │   run                                                     ┌─ TON ─┐  horn   │
            ┝━━┥━━━┝━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━┥IN    Q┝━━(━━━)━━┥
            │                                                           │PT 5s  │         │
            │                                                           └───────┘         │
        "#]],
    );
}

#[test]
fn of_one_moment_no_edge_is_known() {
    check(
        "pump",
        "start,1\nstop,0\npump,0\n",
        expect![[r#"
            exit status 0
            -- stdout
            pump is 0: line 20, (S)( pump ) does not write it; blocked by [P]( start ) (line 20, column 4): start is 1; then line 21, (R)( pump ) does not write it; blocked by [ ]( stop ) (line 21, column 4): stop is 0
              start is 1: it is an input
              stop is 0: it is an input

            │      1                                                               0      │
            │    start                                                           pump     │
            ┝━━━━┥ P ├───────────────────────────────────────────────────────────( S )────┤

            │                                                                      0      │
            │  stop                                                              pump     │
            ┝━━┥   ├─────────────────────────────────────────────────────────────( R )────┤
        "#]],
    );
}

#[test]
fn what_is_needed_or_unknown_is_said() {
    check(
        "run",
        "start,1\nrun,0\nMAX,6\nvalve,1\n",
        expect![[r#"
            exit status 1
            -- stdout
            run is 0, as far as the table goes: line 15, ( )( run ) writes 1; power came through [ ]( start ) (line 15, column 7): start is 1, [/]( stop ) (line 15, column 24): stop is 0, [LT]( level, MAX ) (line 15, column 37): level is 0, MAX is 5
              start is 1: it is an input
              stop is 0, though not in the table: it is an input
              level is 0, though not in the table: it is an input

            │                          0                                                  │
            │     start     stop     level                                          run   │
            ┝━━┳━━┥━━━┝━━┳━━┥━/━┝━━━━┥━<━┝━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━(━━━)━━┥
            │  ┃         ┃            MAX                                                 │
            │  ┃         ┃             5                                                  │
            │  ┃   run   ┃                                                                │
            │  ┗━━┥   ├──┚                                                                │

            needed, and not in the table (taken as they begin): level, stop

            another value in the program, where these are constants: MAX is 5, not 6 (line 3)

            in the table, and not in the program: valve (line 4)
        "#]],
    );
}

#[test]
fn what_does_not_matter_is_not_needed() {
    check(
        "run",
        "stop,1\nrun,0\n",
        expect![[r#"
            exit status 0
            -- stdout
            run is 0: line 15, ( )( run ) writes 0; blocked by [ ]( start ) (line 15, column 7): start is 0 and by [/]( stop ) (line 15, column 24): stop is 1; or else by [/]( stop ) (line 15, column 24): stop is 1 and by [ ]( run ) (line 16, column 7): run is 0
              start is 0, though not in the table: it is an input
              stop is 1: it is an input

            │                          0                                                  │
            │     start     stop     level                                          run   │
            ┝━━┳━━┥   ├──┬──┤ / ├────┤ < ├─────────────────────────────────────────(   )──┤
            │  ┃         │            MAX                                                 │
            │  ┃         │             5                                                  │
            │  ┃   run   │                                                                │
            │  ┗━━┥   ├──┘                                                                │
        "#]],
    );
}

#[test]
fn each_network_sees_the_values_of_the_table_and_not_what_one_before_it_wrote() {
    let plant = "VAR_INPUT a : BOOL; END_VAR\n+--[ ]( a )--( )( m )--+\n\n+--[ ]( m )--( )( y )--+\n";
    let folder = Folder::with(&[("plant.clad", plant), ("values.csv", "a,0\nm,1\ny,1\n")]);
    let run = folder.ladder(&["why", "plant.clad", "y", "--tags", "values.csv"]);
    expect![[r#"
        exit status 1
        -- stdout
        y is 1: line 4, ( )( y ) writes 1; power came through [ ]( m ) (line 4, column 4): m is 1
          m is 1, against the program: line 2, ( )( m ) writes 0; blocked by [ ]( a ) (line 2, column 4): a is 0
            a is 0: it is an input

        │    m                                                                   y    │
        ┝━━┥━━━┝━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━(━━━)━━┥

        the values contradict the program: they were taken in mid-scan, something else writes the tag, or the controller runs another program
    "#]]
    .assert_eq(&run.to_string());
}

#[test]
fn what_is_written_after_it_was_read_contradicts_nothing() {
    // (the program, the tag, the table)
    for (plant, tag, table) in [
        (
            "+--[ ]( y )--( )( z )--+\n\n+--[ ]( a )--( )( y )--+\n",
            "z",
            "a,1\ny,1\nz,0\n",
        ),
        (
            "+--[ ]( y )--( )( z )--[ ]( a )--( )( y )--+\n",
            "z",
            "a,1\ny,0\nz,1\n",
        ),
        ("+--[/]( t )--( )( t )--+\n", "t", "t,1\n"),
        ("+--[ADD]( n, n, 1 )--+\n", "n", "n,5\n"),
    ] {
        let folder = Folder::with(&[("plant.clad", plant), ("values.csv", table)]);
        let run = folder
            .ladder(&["why", "plant.clad", tag, "--tags", "values.csv"])
            .to_string();
        assert!(run.contains("which the table does not decide"), "{plant}\n{run}");
        assert!(
            !run.contains("contradict") && run.starts_with("exit status 1"),
            "{run}"
        );
    }
    // What decides without it still does.
    let seal = "+--\\--[ ]( start )--\\--[/]( stop )--( )( run )--+\n|  /--[ ]( run )----/\n";
    let folder = Folder::with(&[("plant.clad", seal), ("values.csv", "start,1\nstop,0\nrun,0\n")]);
    let run = folder
        .ladder(&["why", "plant.clad", "run", "--tags", "values.csv"])
        .to_string();
    assert!(run.contains("run is 0, against the program"), "{run}");
}

#[test]
fn what_cannot_be_read_is_said_with_its_line() {
    check(
        "run",
        "start,1\nlevel,high\n",
        expect![[r#"
            exit status 2
            -- stderr
            error: values.csv: line 2: `high` is not a value for an INT: write a whole number as in 42 or 16#FF
        "#]],
    );
    check(
        "run",
        "run,0\nrun,1\n",
        expect![[r#"
            exit status 2
            -- stderr
            error: values.csv: line 2: `run` has another value in line 1
        "#]],
    );
    check(
        "run",
        "run\n",
        expect![[r#"
            exit status 2
            -- stderr
            error: values.csv: line 1: `run` has no value; a row is a name and a value, as in `start,1`
        "#]],
    );
    check(
        "run",
        "TYPE,NAME,SCOPE\n",
        expect![[r#"
            exit status 2
            -- stderr
            error: values.csv: line 1: the header has no column of values; call it `value`
        "#]],
    );
    check(
        "rum",
        "run,0\n",
        expect![[r#"
            exit status 2
            -- stderr
            error: there is no tag `rum`; did you mean run?
        "#]],
    );
}

#[test]
fn for_other_programs() {
    let folder = Folder::with(&[
        ("plant.clad", PLANT),
        ("values.csv", "start,1\nstop,1\nlevel,1\nrun,0\n"),
    ]);
    let run = folder.ladder(&[
        "why",
        "plant.clad",
        "run",
        "--tags",
        "values.csv",
        "--format",
        "json",
    ]);
    expect![[r#"
        exit status 0
        -- stdout
        {
          "contradiction": false,
          "missing": [],
          "unknown": [],
          "constants": [],
          "reason": {
            "tag": "run",
            "type": "BOOL",
            "value": "0",
            "given": true,
            "contradiction": false,
            "text": "run is 0: line 15, ( )( run ) writes 0; blocked by [/]( stop ) (line 15, column 24): stop is 1",
            "writes": [
              {
                "block": "( )( run )",
                "line": 15,
                "column": 57,
                "power": false,
                "writes": true,
                "leaves": "0",
                "ways": [
                  [
                    {
                      "block": "[/]( stop )",
                      "line": 15,
                      "column": 24,
                      "stops": true,
                      "values": [
                        {
                          "tag": "stop",
                          "value": "1"
                        }
                      ]
                    }
                  ]
                ],
                "read": []
              }
            ],
            "because": [
              {
                "tag": "stop",
                "type": "BOOL",
                "value": "1",
                "given": true,
                "contradiction": false,
                "text": "stop is 1: it is an input",
                "writes": [],
                "because": []
              }
            ]
          }
        }
    "#]]
    .assert_eq(&run.to_string());
}

#[test]
fn what_is_in_the_state_of_a_block_comes_from_the_block() {
    let program = "\
FUNCTION_BLOCK [$Motor]
VAR_INPUT start, stop : BOOL; END_VAR
VAR_OUTPUT run : BOOL; END_VAR
VAR t : TON; tripped : BOOL; END_VAR
+--[ ]( start )--[/]( stop )--[/]( tripped )--[TON]( t, 2s )--( )( run )--+
END_FUNCTION_BLOCK

VAR_INPUT b1, b2 : BOOL; END_VAR
VAR_OUTPUT lamp : BOOL; END_VAR
VAR m1 : $Motor; END_VAR
+--[$Motor]( m1, b1, b2 )--+
+--[ ]( m1.run )--( )( lamp )--+
";
    let folder = Folder::with(&[
        ("plant.clad", program),
        (
            "values.csv",
            "b1;ON\nb2;off\nm1.t.ET;300\nm1.tripped;0\nm1.run;0\nlamp;0\n",
        ),
    ]);
    let run = folder.ladder(&["why", "plant.clad", "lamp", "--tags", "values.csv"]);
    expect![[r#"
        exit status 0
        -- stdout
        lamp is 0: line 12, ( )( lamp ) writes 0; blocked by [ ]( m1.run ) (line 12, column 4): m1.run is 0
          m1.run is 0: line 5, ( )( run ) writes 0; blocked by [TON]( t, 2s ) (line 5, column 47): m1.t.ET is T#300ms
            m1.t.ET is T#300ms: line 5, [TON]( t, 2s ) writes T#300ms; power came through [ ]( start ) (line 5, column 4): m1.start is 1, [/]( stop ) (line 5, column 18): m1.stop is 0, [/]( tripped ) (line 5, column 31): m1.tripped is 0
              m1.start is 1, though not in the table: line 11, [$Motor]( m1, b1, b2 ) writes 1; power came straight from the rail
                b1 is 1: it is an input
              m1.stop is 0, though not in the table: line 11, [$Motor]( m1, b1, b2 ) writes 0; power came straight from the rail
                b2 is 0: it is an input
              m1.tripped is 0: no network writes it

        │  m1.run                                                              lamp   │
        ┝━━┥   ├───────────────────────────────────────────────────────────────(   )──┤
    "#]]
    .assert_eq(&run.to_string());
}

#[test]
fn values_are_read_as_controllers_write_them() {
    check(
        "run",
        "\"Name\";\"Data type\";\"Monitor value\"\n\"start\";\"Bool\";\"ON\"\n\"stop\";\"Bool\";\"off\"\n\"level\";\"Int\";\"7 mm\"\n\
         \"run\";\"Bool\";\"FALSE\"\n\"horn\";\"Bool\";\"???\"\n\"valve\";\"Bool\";\"TRUE\"\n",
        expect![[r#"
            exit status 0
            -- stdout
            run is 0: line 15, ( )( run ) writes 0; blocked by [LT]( level, MAX ) (line 15, column 37): level is 7, MAX is 5
              level is 7: it is an input

            │                          7                                                  │
            │     start     stop     level                                          run   │
            ┝━━┳━━┥━━━┝━━┳━━┥━/━┝━━━━┥ < ├─────────────────────────────────────────(   )──┤
            │  ┃         ┃            MAX                                                 │
            │  ┃         ┃             5                                                  │
            │  ┃   run   ┃                                                                │
            │  ┗━━┥   ├──┚                                                                │

            in the table, and not in the program: valve (line 7)
        "#]],
    );
    check(
        "run",
        "start,maybe\n",
        expect![[r#"
            exit status 2
            -- stderr
            error: values.csv: line 1: `maybe` is not a value for a BOOL: write 0, 1, TRUE or FALSE
        "#]],
    );
}

#[test]
fn a_bit_and_its_number_cannot_have_different_values() {
    let program = "VAR_INPUT n : INT; END_VAR\n+--[ ]( n.1 )--( )( y )--+\n";
    let why = |values: &str| {
        let folder = Folder::with(&[("a.clad", program), ("values.csv", values)]);
        folder.ladder(&["why", "a.clad", "y", "--tags", "values.csv"])
    };
    assert_eq!(why("n,2\ny,1\nn.1,1\n").status, Some(0));
    expect![[r#"
        exit status 2
        -- stderr
        error: values.csv: line 1: `n.1` has another value in `n` of line 3
    "#]]
    .assert_eq(&why("n.1,0\ny,1\nn,2\n").to_string());
}

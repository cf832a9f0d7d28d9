//! `ladder sim`

use crate::harness::{Folder, MOTOR, Run};
use expect_test::{Expect, expect};

/// A program with a tag of many types.
pub(super) const TYPES: &str = "\
VAR_INPUT go : BOOL; speed : INT; END_VAR
VAR total : LREAL; level : REAL := 0.1; wait : TIME; word1 : WORD; big : ULINT; name : STRING; END_VAR
VAR list : ARRAY[1..3] OF INT; t1 : TON; END_VAR
VAR CONSTANT limit : INT := 80; END_VAR
+--[ADD]( total, total, 0.5 )--[MOV]( wait, t1.ET )--[MOV]( list[2], speed )--+
+--[ ]( go )--[TON]( t1, T#25ms )--[MOV]( word1, 255 )--[MOV]( name, 'a, b' )--+
";

fn types(arguments: &[&str], expected: Expect) {
    let folder = Folder::with(&[("types.clad", TYPES)]);
    let run = folder.ladder(&[&["sim", "types.clad"], arguments].concat());
    expected.assert_eq(&run.to_string());
}

fn motor(arguments: &[&str]) -> Run {
    let folder = Folder::with(&[("motor.clad", MOTOR)]);
    folder.ladder(&[&["sim", "motor.clad"], arguments].concat())
}

#[test]
fn without_watch_every_elementary_tag_is_written_sorted_by_name() {
    types(
        &["--scans", "4", "--set", "go=1"],
        expect![[r#"
            exit status 0
            -- stdout
            scan,time_ms,big,go,level,list[1],list[2],list[3],name,speed,t1.ET,t1.Q,total,wait,word1
            0,0,0,1,0.1,0,0,0,,0,0,0,0.5,0,0
            1,10,0,1,0.1,0,0,0,,0,10,0,1.0,0,0
            2,20,0,1,0.1,0,0,0,,0,20,0,1.5,10,0
            3,30,0,1,0.1,0,0,0,"a, b",0,25,1,2.0,20,255
        "#]],
    );
}

#[test]
fn watched_tags_in_the_order_and_spelling_given() {
    types(
        &[
            "--scans",
            "2",
            "--set",
            "go=TRUE",
            "--watch",
            "T1.et,list[2],word1.3,SYS.SCAN,t1.DN,limit",
            "--set",
            "speed=-7",
        ],
        expect![[r#"
            exit status 0
            -- stdout
            scan,time_ms,T1.et,list[2],word1.3,SYS.SCAN,t1.DN,limit
            0,0,0,-7,0,0,0,80
            1,10,10,-7,0,1,0,80
        "#]],
    );
}

#[test]
fn the_interval_may_be_any_duration() {
    types(
        &[
            "--scans", "3", "--dt", "12.5ms", "--set", "go=1", "--watch", "t1.ET",
        ],
        expect![[r#"
            exit status 0
            -- stdout
            scan,time_ms,t1.ET
            0,0,0
            1,12.5,12.5
            2,25,25
        "#]],
    );
    types(
        &["--scans", "2", "--dt", "T#1h", "--watch", "SYS.TIME"],
        expect![[r#"
            exit status 0
            -- stdout
            scan,time_ms,SYS.TIME
            0,0,0
            1,3600000,3600000
        "#]],
    );
}

#[test]
fn no_scans_give_a_header() {
    types(
        &["--scans", "0", "--watch", "go"],
        expect![[r#"
        exit status 0
        -- stdout
        scan,time_ms,go
    "#]],
    );
}

#[test]
fn inputs_are_given_before_each_scan_and_hold() {
    let folder = Folder::with(&[
        ("motor.clad", MOTOR),
        ("in.csv", "START,stop\r\n1,\r\n0,\r\n\r\n,TRUE\r\n"),
    ]);
    let run = folder.ladder(&["sim", "motor.clad", "--scans", "6", "--inputs", "in.csv"]);
    expect![[r#"
        exit status 0
        -- stdout
        scan,time_ms,run,start,stop
        0,0,1,1,0
        1,10,1,0,0
        2,20,1,0,0
        3,30,0,0,1
        4,40,0,0,1
        5,50,0,0,1
    "#]]
    .assert_eq(&run.to_string());
}

#[test]
fn a_force_holds_against_program_and_inputs() {
    let folder = Folder::with(&[("motor.clad", MOTOR), ("in.csv", "start\n1\n0\n1\n")]);
    let run = folder.ladder(&[
        "sim",
        "motor.clad",
        "--scans",
        "3",
        "--inputs",
        "in.csv",
        "--force",
        "start=0",
        "--force",
        "run=1",
    ]);
    expect![[r#"
        exit status 0
        -- stdout
        scan,time_ms,run,start,stop
        0,0,1,0,0
        1,10,1,0,0
        2,20,1,0,0
    "#]]
    .assert_eq(&run.to_string());
}

#[test]
fn a_diagram_shows_the_power_after_the_last_scan() {
    expect![[r#"
        exit status 0
        -- stdout
        +==\==[ ]( start )==\==[/]( stop )=================================( )( run )==+
        |  /==[ ]( run )====/                                                          |
    "#]]
    .assert_eq(&motor(&["--scans", "2", "--set", "start=1", "--format", "diagram"]).to_string());
    expect![[r#"
        exit status 0
        -- stdout
        +--\--[ ]( start )--\--[/]( stop )---------------------------------( )( run )--+
        |  /--[ ]( run )----/                                                          |
    "#]]
    .assert_eq(&motor(&["--scans", "0", "--format", "diagram"]).to_string());
}

#[test]
fn the_output_goes_to_a_file() {
    let folder = Folder::with(&[("motor.clad", MOTOR), ("out.csv", "scan,time_ms\n9,90\n")]);
    let run = folder.ladder(&["sim", "motor.clad", "--scans", "1", "-o", "out.csv"]);
    assert_eq!(run.to_string(), "exit status 0\n");
    assert_eq!(folder.read("out.csv"), "scan,time_ms,run,start,stop\n0,0,0,0,0\n");
    let run = folder.ladder(&["sim", "motor.clad", "--scans", "0", "-o", "-"]);
    assert_eq!(run.stdout, "scan,time_ms,run,start,stop\n");
    let run = folder.ladder(&["sim", "motor.clad", "--scans", "1", "-o", "no/out.csv"]);
    assert_eq!(run.status, Some(2));
    assert!(
        run.stderr.starts_with("error: no/out.csv: cannot be written: "),
        "{run}"
    );
}

#[test]
fn faults_are_named_with_their_place_and_the_run_goes_on() {
    let folder = Folder::with(&[("a.clad", "+--[DIV]( x, 7, y )--+\n+--[ADD]( y, y, 1 )--+\n")]);
    let run = folder.ladder(&["sim", "a.clad", "--scans", "2", "--watch", "x"]);
    expect![[r#"
        exit status 0
        -- stdout
        scan,time_ms,x
        0,0,0
        1,10,7
        -- stderr
        a.clad:1:4: fault in scan 0: division by zero: nothing was written; check the divisor before this block
    "#]].assert_eq(&run.to_string());
}

#[test]
fn a_scan_that_never_ends_is_stopped_and_has_no_row() {
    let folder = Folder::with(&[(
        "a.clad",
        "+--[ADD]( x, x, 1 )--+\n+--<LBL>( again )--[GT]( x, 1 )--<JMP>( again )--+\n",
    )]);
    let run = folder.ladder(&["sim", "a.clad", "--scans", "9"]);
    expect![[r#"
        exit status 1
        -- stdout
        scan,time_ms,x
        0,0,1
        -- stderr
        a.clad:2:4: fault in scan 1: this scan has evaluated more than 1000000 blocks, so the watchdog stopped the simulation here; look for a jump or loop that does not end
    "#]].assert_eq(&run.to_string());
}

#[test]
fn end_ends_the_run() {
    let folder = Folder::with(&[("a.clad", "+--[ADD]( x, x, 1 )--[GE]( x, 2 )--<END>--+\n")]);
    let run = folder.ladder(&["sim", "a.clad", "--scans", "9"]);
    expect![[r#"
        exit status 0
        -- stdout
        scan,time_ms,x
        0,0,1
        1,10,2
    "#]]
    .assert_eq(&run.to_string());
}

/// A quoted number with a comma, as a spreadsheet saves it between commas.
#[test]
fn a_comma_is_the_point_of_a_number_in_any_table() {
    let program = "VAR_INPUT pause : TIME; level : REAL; END_VAR\n+--[GT]( level, 1.0 )--[GT]( pause, 1s )--( )( y )--+\n";
    let run = |table: &str| {
        let folder = Folder::with(&[("a.clad", program), ("in.csv", table)]);
        let watched = ["--scans", "1", "--watch", "pause,level"];
        let run = folder.ladder(&[&["sim", "a.clad", "--inputs", "in.csv"], &watched[..]].concat());
        run.to_string()
    };
    for table in [
        "pause,level\n\"1,5s\",\"2,25\"\n",
        "pause;level\nT#1,5s;2,25\n",
        "pause\tlevel\n1,5 s\t2,25\n",
    ] {
        let run = run(table);
        assert!(run.ends_with("0,0,1500,2.25\n"), "{table}\n{run}");
    }
    let run = run("level\n\"1,500\"\n");
    assert!(run.contains("`1,500` is not a value for a REAL"), "{run}");
}

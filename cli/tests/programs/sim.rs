//! `ladder sim`

use crate::harness::{Folder, MOTOR, Run};
use expect_test::{Expect, expect};

/// A program with a tag of many types.
const TYPES: &str = "\
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

#[test]
fn a_program_with_errors_is_not_run() {
    let folder = Folder::with(&[("a.clad", "+--[TNO]( t, T#5s )--( )( run )--+\n")]);
    let run = folder.ladder(&["sim", "a.clad", "--scans", "1", "-o", "out.csv"]);
    expect![[r#"
        exit status 1
        -- stderr
        error[unknown-instruction]: there is no instruction [TNO]
         --> a.clad:1:4
          |
        1 | +--[TNO]( t, T#5s )--( )( run )--+
          |    ^^^^^
          |
          = help: did you mean [TON] (on-delay timer)?
        help: Replace with [TON]
          |
        1 - +--[TNO]( t, T#5s )--( )( run )--+
        1 + +------------------------------------------------[TON]( t, T#5s )--( )( run )--+
          |

        error: a.clad: a program with errors is not run
    "#]]
    .assert_eq(&run.to_string());
    assert_eq!(folder.names(), ["a.clad"]);
}

/// One message, exit status 2, and no file.
fn refused(arguments: &[&str], message: &str) {
    let folder = Folder::with(&[("types.clad", TYPES)]);
    let run = folder.ladder(&[&["sim", "types.clad", "-o", "out.csv"], arguments].concat());
    run.refused_with(message);
    assert_eq!(folder.names(), ["types.clad"]);
}

#[test]
fn without_scans_it_says_what_is_missing() {
    refused(
        &[],
        "say how many scans to run, for example --scans 100; `ladder sim --help` shows more",
    );
}

#[test]
fn unknown_tags_are_refused_with_what_was_meant() {
    let scans = ["--scans", "1"];
    let with = |option: &'static str, text: &'static str| [scans[0], scans[1], option, text];
    refused(
        &with("--watch", "go,sped"),
        "--watch sped: there is no tag `sped`; did you mean speed?",
    );
    refused(
        &with("--set", "og=1"),
        "--set og=1: there is no tag `og`; did you mean go?",
    );
    refused(
        &with("--force", "pump=1"),
        "--force pump=1: there is no tag `pump` in this program",
    );
    refused(
        &with("--set", "t1=1"),
        "--set t1=1: t1 is a TON: name one of its members, as in t1.Q",
    );
    refused(
        &with("--set", "list=1"),
        "--set list=1: list is an array: name one of its elements, as in list[1]",
    );
}

#[test]
fn values_that_do_not_fit_are_refused() {
    let scans = ["--scans", "1"];
    let with = |option: &'static str, text: &'static str| [scans[0], scans[1], option, text];
    refused(
        &with("--set", "go"),
        "--set go: write it TAG=VALUE, for example start=1",
    );
    refused(
        &with("--set", "go=2"),
        "--set go=2: `2` is not a value for a BOOL: write 0, 1, TRUE or FALSE",
    );
    refused(
        &with("--force", "speed=40000"),
        "--force speed=40000: 40000 does not fit: INT holds -32768 to 32767",
    );
    refused(
        &with("--set", "limit=1"),
        "--set limit=1: limit is read-only: it cannot be given a value",
    );
    refused(
        &with("--set", "SYS.SCAN=1"),
        "--set SYS.SCAN=1: SYS.SCAN is read-only: it cannot be given a value",
    );
}

#[test]
fn a_broken_csv_is_refused_with_row_and_column() {
    for (csv, message) in [
        ("", "in.csv: the file is empty; its first line names the tags"),
        (
            "go,sped\n1,2\n",
            "in.csv: header, column 2 (`sped`): there is no tag `sped`; did you mean speed?",
        ),
        ("go,GO\n1,2\n", "in.csv: the header has `GO` in columns 1 and 2"),
        (
            "go;speed\n1;2\n",
            "in.csv: header, column 1 (`go;speed`): columns are separated by commas",
        ),
        (
            "go,limit\n1,2\n",
            "in.csv: header, column 2 (`limit`): this tag can only be read",
        ),
        (
            "go,speed\n1,5\n0,fast\n",
            "in.csv: row 1 (line 3), column `speed`: `fast` is not a value for an INT: write a whole number as in 42 or 16#FF",
        ),
        (
            "go,speed\n1,5\n\n0\n",
            "in.csv: row 2 (line 4): the cell for column `speed` is missing; the row has 1 of 2 cells",
        ),
        (
            "go,speed\n1,5,6\n",
            "in.csv: row 0 (line 2): column 3 has no name in the header; the row has 3 of 2 cells",
        ),
    ] {
        let folder = Folder::with(&[("types.clad", TYPES), ("in.csv", csv)]);
        let run = folder.ladder(&[
            "sim",
            "types.clad",
            "--scans",
            "9",
            "--inputs",
            "in.csv",
            "-o",
            "out.csv",
        ]);
        run.refused_with(message);
        assert_eq!(folder.names(), ["in.csv", "types.clad"]);
    }
    let folder = Folder::with(&[("types.clad", TYPES)]);
    folder.write("latin.csv", b"go\n\xE4\n");
    let sim = |inputs: &str| folder.ladder(&["sim", "types.clad", "--scans", "1", "--inputs", inputs]);
    sim("latin.csv").refused_with(
        "latin.csv: the file is not UTF-8: byte 16#E4 at line 2, column 1; save it as UTF-8 in your editor",
    );
    sim("missing.csv").refused_with("missing.csv: no such file or folder");
}

#[test]
fn an_interval_must_be_a_time_that_passes() {
    let folder = Folder::with(&[("motor.clad", MOTOR)]);
    for dt in ["0ms", "-5ms", "soon", ""] {
        let run = folder.ladder(&["sim", "motor.clad", "--scans", "1", &format!("--dt={dt}")]);
        assert_eq!(run.status, Some(2), "{run}");
        assert_eq!(run.stdout, "", "{run}");
        assert!(run.stderr.starts_with("error: "), "{run}");
    }
}

/// Two pumps, each with an element of every array.
const PUMPS: &str = "\
VAR_INPUT trip : ARRAY[1..2] OF BOOL; run : BOOL; END_VAR
VAR_OUTPUT pump : ARRAY[1..2] OF BOOL; END_VAR
VAR i : INT; starts : ARRAY[1..2] OF INT; t : TON; END_VAR
+--[MOV]( i, 0 )--<FOR>( 2 )--+

+--[ADD]( i, i, 1 )--[ ]( run )--[/]( trip[i] )--( )( pump[i] )--[ADD]( starts[i], starts[i], 1 )--+
+--<NEXT>--+
";

const LINES: &str = "\
TYPE
    Phase : (IDLE, FILLING);
    Motor : STRUCT
        speed : REAL := 50.0;
        delay : TON;
    END_STRUCT;
END_TYPE
VAR_INPUT step : Phase; END_VAR
VAR
    lines : ARRAY[1..2] OF Motor;
    grid  : ARRAY[1..2, 0..1] OF INT;
    long  : ARRAY[1..65] OF INT;
    once  : $Once;
END_VAR

FUNCTION_BLOCK [$Once]
VAR n : INT; END_VAR
+--[ADD]( n, n, 1 )--( )( ENO )--+
END_FUNCTION_BLOCK

+--[EQ]( step, FILLING )--[$Once]( once )--[TON]( lines[2].delay, T#5s )--[MOV]( grid[2, 1], 7 )--[MOV]( long[3], 7 )--+
";

#[test]
fn compound_values_are_written_part_by_part() {
    let inputs = "step,\"lines[2].speed\"\nfilling,12.5\n";
    let folder = Folder::with(&[("lines.clad", LINES), ("in.csv", inputs)]);
    let run = |arguments: &[&str], expected: Expect| {
        let given = ["sim", "lines.clad", "--scans", "2", "--inputs", "in.csv"];
        expected.assert_eq(&folder.ladder(&[&given, arguments].concat()).to_string());
    };
    run(
        &[],
        expect![[r#"
            exit status 0
            -- stdout
            scan,time_ms,"grid[1, 0]","grid[1, 1]","grid[2, 0]","grid[2, 1]",lines[1].delay.ET,lines[1].delay.Q,lines[1].speed,lines[2].delay.ET,lines[2].delay.Q,lines[2].speed,step
            0,0,0,0,0,0,0,0,50.0,0,0,12.5,FILLING
            1,10,0,0,0,0,0,0,50.0,10,0,12.5,FILLING
        "#]],
    );
    run(
        &["--watch", "lines[2],grid[2, 0..1],once"],
        expect![[r#"
            exit status 0
            -- stdout
            scan,time_ms,lines[2].speed,lines[2].delay.Q,lines[2].delay.ET,"grid[2, 0]","grid[2, 1]",once.EN,once.ENO,once.n
            0,0,12.5,0,0,0,0,1,1,1
            1,10,12.5,0,10,0,0,1,1,2
        "#]],
    );
    run(
        &[
            "--watch",
            "step,lines[1].speed",
            "--force",
            "lines[1].speed=3",
            "--force",
            "step=idle",
        ],
        expect![[r#"
            exit status 0
            -- stdout
            scan,time_ms,step,lines[1].speed
            0,0,IDLE,3.0
            1,10,IDLE,3.0
        "#]],
    );
    run(
        &["--watch", "lines[3]"],
        expect![[r#"
            exit status 2
            -- stderr
            error: --watch lines[3]: lines has parts: name one of them, as in lines[1].speed
        "#]],
    );
}

#[test]
fn arrays_are_written_element_by_element() {
    let folder = Folder::with(&[("pumps.clad", PUMPS)]);
    let run = |arguments: &[&str], expected: Expect| {
        let given = [
            "sim",
            "pumps.clad",
            "--scans",
            "2",
            "--set",
            "run=1",
            "--set",
            "trip[2]=1",
        ];
        expected.assert_eq(&folder.ladder(&[&given, arguments].concat()).to_string());
    };
    run(
        &[],
        expect![[r#"
            exit status 0
            -- stdout
            scan,time_ms,i,pump[1],pump[2],run,starts[1],starts[2],t.ET,t.Q,trip[1],trip[2]
            0,0,2,1,0,1,1,0,0,0,0,1
            1,10,2,1,0,1,2,0,0,0,0,1
        "#]],
    );
    run(
        &["--watch", "pump"],
        expect![[r#"
        exit status 0
        -- stdout
        scan,time_ms,pump[1],pump[2]
        0,0,1,0
        1,10,1,0
    "#]],
    );
    run(
        &["--watch", "starts[1..2],t,pump[2..2],run"],
        expect![[r#"
        exit status 0
        -- stdout
        scan,time_ms,starts[1],starts[2],t.Q,t.ET,pump[2],run
        0,0,1,0,0,0,0,1
        1,10,2,0,0,0,0,1
    "#]],
    );
    run(
        &["--format", "vcd", "--watch", "trip,pump[1]"],
        expect![[r#"
        exit status 0
        -- stdout
        $comment TIME is in milliseconds $end
        $version ladder 0.1.0 $end
        $timescale 10 ms $end
        $scope module pumps $end
        $var wire 1 ! trip[1] $end
        $var wire 1 " trip[2] $end
        $var wire 1 # pump[1] $end
        $upscope $end
        $enddefinitions $end
        #0
        $dumpvars
        0!
        1"
        1#
        $end
        #2
    "#]],
    );
    run(
        &["--watch", "pump[0..2]"],
        expect![[r#"
        exit status 2
        -- stderr
        error: --watch pump[0..2]: pump[0] does not exist: the array goes from 1 to 2
    "#]],
    );
    run(
        &["--force", "pump[2]=1", "--watch", "pump"],
        expect![[r#"
        exit status 0
        -- stdout
        scan,time_ms,pump[1],pump[2]
        0,0,1,1
        1,10,1,1
    "#]],
    );
}

/// Arrays of two dimensions, alone and in a structure, and of what keeps a state.
const PARTS: &str = "\
FUNCTION_BLOCK [$Twice]
VAR_INPUT x : INT; END_VAR
VAR_OUTPUT y : INT; END_VAR
+--[MUL]( y, x, 2 )--+
END_FUNCTION_BLOCK
TYPE Row : STRUCT a : ARRAY[0..1, 1..2] OF INT; END_STRUCT; END_TYPE
VAR grid : ARRAY[1..2, 0..1] OF INT := [1, 2, 3, 4]; row : Row; twice : ARRAY[1..2] OF $Twice; END_VAR
+--[$Twice]( twice[2], grid[2, 1], row.a[1, 2] )--+
";

#[test]
fn parts_are_written_by_their_paths() {
    let folder = Folder::with(&[("parts.clad", PARTS)]);
    let run = |arguments: &[&str], expected: Expect| {
        let given = ["sim", "parts.clad", "--scans", "1"];
        expected.assert_eq(&folder.ladder(&[&given, arguments].concat()).to_string());
    };
    run(
        &[],
        expect![[r#"
            exit status 0
            -- stdout
            scan,time_ms,"grid[1, 0]","grid[1, 1]","grid[2, 0]","grid[2, 1]","row.a[0, 1]","row.a[0, 2]","row.a[1, 1]","row.a[1, 2]"
            0,0,1,2,3,4,0,0,0,8
        "#]],
    );
    run(
        &["--watch", "grid[2,1],grid[1][0],row.a[1, 2],twice[2].y"],
        expect![[r#"
            exit status 0
            -- stdout
            scan,time_ms,"grid[2,1]",grid[1][0],"row.a[1, 2]",twice[2].y
            0,0,4,1,8,8
        "#]],
    );
}

//! `ladder sim` of structures and arrays.

use crate::harness::Folder;
use expect_test::{Expect, expect};

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

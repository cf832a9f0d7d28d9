//! What the inputs of a program are (LANGUAGE §4).

use super::support::simulation_of;
use expect_test::{Expect, expect};

/// The inputs of the first of several files.
fn check(files: &[(&str, &str)], expected: Expect) {
    let simulation = simulation_of(files);
    let inputs = simulation.points().iter().filter(|point| point.is_input);
    let inputs: Vec<String> = inputs
        .map(|point| format!("{} : {}", point.name, point.ty))
        .collect();
    expected.assert_eq(&inputs.join("\n"));
}

const SHARED: &str = "VAR_GLOBAL g : INT; b : BOOL; END_VAR\nVAR_OUTPUT y, z : BOOL; END_VAR
+--[GT]( g, 3 )--( )( y )--+\n+--[ ]( b )--( )( z )--+\n";

#[test]
fn what_is_not_declared_and_never_written() {
    check(
        &[(
            "a.clad",
            "+--[GT]( level, 3 )--[GT]( weight, 2.5 )--[GT]( MI3, 3 )--[GT]( MF3, 2.5 )--[ ]( M3 )--( )( y )--+
+--[GT]( pause, T#5s )--[EQ]( word, 'ab' )--[EQ]( day, D#2026-11-21 )--[EQ]( %MW3, 16#7 )--( )( z )--+
+--[TON]( t, delay )--[ADD]( written, written, 1 )--+
",
        )],
        expect![[r"
            level : DINT
            weight : LREAL
            MI3 : DINT
            MF3 : LREAL
            M3 : BOOL
            pause : TIME
            word : STRING
            day : DATE
            %MW3 : WORD
            delay : TIME"]],
    );
}

#[test]
fn what_is_declared() {
    check(
        &[(
            "a.clad",
            "TYPE\n    Recipe : STRUCT\n        speed : INT;\n        list : ARRAY[1..2] OF INT;\n    END_STRUCT;\nEND_TYPE
VAR_INPUT mix : Recipe; row : ARRAY[0..1] OF BOOL; END_VAR
VAR level AT %IW3 : INT; never : INT; kept : Recipe; END_VAR
VAR CONSTANT limit : INT := 3; END_VAR
+--[ ]( row[1] )--[GT]( mix.speed, level )--[GT]( never, limit )--[GT]( kept.speed, 3 )--( )( y )--+
",
        )],
        expect![[r"
            mix.speed : INT
            mix.list[1] : INT
            mix.list[2] : INT
            row[0] : BOOL
            row[1] : BOOL
            level : INT"]],
    );
}

#[test]
fn globals_that_another_file_writes() {
    check(
        &[("a.clad", SHARED), ("b.clad", "+--[ ]( I1 )--[MOV]( g, 7 )--+\n")],
        expect!["g : INT"],
    );
    check(
        &[
            (
                "a.clad",
                "VAR_EXTERNAL h : INT; END_VAR\n+--[GT]( h, 3 )--[GT]( i, 3 )--( )( y )--+\n",
            ),
            (
                "b.clad",
                "VAR_GLOBAL h, i : INT; END_VAR\n+--[ ]( I1 )--[MOV]( h, 7 )--[MOV]( i, 7 )--+\n",
            ),
        ],
        expect![[r"
            h : INT
            i : INT"]],
    );
}

#[test]
fn globals_that_only_the_program_itself_writes() {
    let program = format!("{SHARED}+--<CALL>( count )--+\n");
    let library = "+--<FUN>( count )--[ADD]( g, g, 1 )--+\n";
    check(&[("a.clad", &program), ("b.clad", library)], expect![""]);
    // Another program counts, too.
    check(
        &[
            ("a.clad", &program),
            ("b.clad", library),
            ("c.clad", "+--[ ]( I1 )--<CALL>( count )--+\n"),
        ],
        expect!["g : INT"],
    );
    check(
        &[
            ("a.clad", &program),
            ("b.clad", &format!("+--[ ]( I1 )--<CALL>( count )--+\n{library}")),
        ],
        expect!["g : INT"],
    );
}

#[test]
fn globals_that_a_block_writes() {
    let block = "FUNCTION_BLOCK [$Count]\n+--[ADD]( g, g, 1 )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n";
    let program = format!("{SHARED}+--[$Count]( )--+\n");
    check(&[("a.clad", &program), ("b.clad", block)], expect![""]);
    check(
        &[
            ("a.clad", &program),
            ("b.clad", block),
            ("c.clad", "+--[ ]( I1 )--[$Count]( )--+\n"),
        ],
        expect!["g : INT"],
    );
}

#[test]
fn states_that_another_file_runs() {
    check(
        &[
            (
                "a.clad",
                "VAR_GLOBAL t : TON; END_VAR\n+--[ ]( t.Q )--( )( y )--+\n",
            ),
            ("b.clad", "+--[ ]( I1 )--[TON]( t, T#5s )--( )( Q1 )--+\n"),
        ],
        expect![[r"
            t.Q : BOOL
            t.ET : TIME"]],
    );
}

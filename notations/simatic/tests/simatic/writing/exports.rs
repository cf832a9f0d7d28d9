//! SimaticML.

use crate::analysis;
use expect_test::{ExpectFile, expect_file};
use ladder_notation::Notation;
use ladder_notation_simatic::SimaticMl;

/// The files of a program, and what there is to say.
#[track_caller]
fn check(text: &str, expected: ExpectFile) {
    let writing = SimaticMl
        .write(&analysis(text))
        .unwrap_or_else(|error| panic!("{error}"));
    let mut out = String::from_utf8_lossy(&writing.bytes).into_owned();
    for companion in &writing.companions {
        out.push_str(&format!(
            "== {}\n{}",
            companion.name,
            String::from_utf8_lossy(&companion.bytes)
        ));
    }
    for entry in writing.report.remarks() {
        out.push_str(&format!(
            "{} {}: {:?}\n",
            entry.place, entry.element, entry.outcome
        ));
    }
    expected.assert_eq(&out);
}

#[test]
fn a_program_is_a_function_block() {
    check(
        "# Warm up #\n# and wait #\n\nVAR_INPUT\n    start, stop : BOOL;  # keys #\nEND_VAR\nVAR RETAIN\n    total : DINT := 7;\nEND_VAR\n\
         VAR\n    warm : TON;\n    row : ARRAY[1..3] OF INT := [1, 2(5)];\n    k : INT;\nEND_VAR\nVAR CONSTANT\n    most : INT := 3;\nEND_VAR\n\n\
         # Seal-in #\n+--\\--[ ]( start )--\\--[/]( stop )--[TON]( warm, 5s )--( )( run )--+\n|  /--[ ]( run )----/\n\n\
         +--[P]( run )--[ADD]( total, total, 1 )--[LE]( 0, row[k], most )--[CALC]( k, k * 2 + row[2] )--+\n",
        expect_file!["exports/program.xml"],
    );
}

#[test]
fn calls_jumps_and_counters() {
    check(
        "FUNCTION_BLOCK [$Watch]\nVAR_INPUT\n    value : INT;\nEND_VAR\nVAR_OUTPUT\n    bad : BOOL;\nEND_VAR\n\
         +--[/]( EN )--<RET>--+\n+--[GT]( value, 5 )--( )( bad )--+\nEND_FUNCTION_BLOCK\n\n\
         VAR\n    n : INT;\n    m : $Watch;\n    w : WORD;\n    t : TON;\n    c : CTUD;\n    on, alarm : BOOL;\n    bits : ARRAY[0..7] OF BOOL;\nEND_VAR\n\
         +--[ ]( on )--[$Watch]( m, 3, alarm )--<JMP>( end )--+\n\n\
         +--[ ]( w.3 )--[CTUD]( c, 4, R := on )--(S)( bits[2..4] )--+\n\n\
         +--[ ]( SYS.FIRST_SCAN )--\\--(RES)( t )--+\n|                         /--[LIMIT]( n, 1, n, 9 )--[SEL]( n, on, n, 0 )--+\n\n\
         +--<LBL>( end )--[ ]( %IX0.3 )--[OSR]--(/)( alarm )--+\n\n+--[NOT]--( )( alarm )--+\n\n+--[ ]( on )--<RET>--+\n",
        expect_file!["exports/calls.xml"],
    );
}

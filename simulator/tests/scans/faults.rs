//! Faults: the result is not written, ENO is low, the fault is recorded with its place, the scan goes on.

use crate::support::{check, force, get, set, simulation};
use expect_test::expect;

/// Runs one block once; what became of its result, its power, and the message.
fn fault(declarations: &str, block: &str, result: &str) -> String {
    let text = format!("VAR {declarations} ok : BOOL; END_VAR\n+--{block}--( )( ok )--+\n");
    let mut simulation = simulation(&text);
    let before = get(&simulation, result);
    assert!(simulation.scan());
    let after = get(&simulation, result);
    assert_eq!(before, after, "the result was written");
    assert_eq!(get(&simulation, "ok"), "0");
    let faults = simulation.take_faults();
    let [fault] = faults.as_slice() else {
        panic!("{block}: {faults:?}")
    };
    assert_eq!(&text[fault.location.range], block);
    assert!(!fault.stops);
    format!("{block}: {}\n", fault.message)
}

#[test]
fn every_kind() {
    let all: Vec<String> = vec![
        fault("n : INT := 7; z : INT;", "[DIV]( n, 5, z )", "n"),
        fault("n : INT := 7; z : INT;", "[MOD]( n, 5, z )", "n"),
        fault("x : REAL := 7; z : REAL;", "[DIV]( x, 5, z )", "x"),
        fault("x : LREAL := 7; z : LREAL;", "[MOD]( x, 5, z )", "x"),
        fault("n : INT := 7; e : INT := -1;", "[EXP]( n, 5, e )", "n"),
        fault("n : INT := 7; e : INT := -1;", "[SHL]( n, n, e )", "n"),
        fault("x : REAL := 7; z : REAL := -1;", "[SQRT]( x, z )", "x"),
        fault("x : REAL := 7; z : REAL;", "[LN]( x, z )", "x"),
        fault("x : REAL := 7; z : REAL := 1.5;", "[ASIN]( x, z )", "x"),
        fault("x : REAL := 3.0e38;", "[MUL]( x, x, x )", "x"),
        fault("x : LREAL := 1.0e300;", "[EXPE]( x, x )", "x"),
        fault("x : LREAL := -8;", "[EXP]( x, x, 0.5 )", "x"),
        fault("n : SINT; z : INT := 200;", "[TYP]( n, z )", "n"),
        fault("n : INT; z : REAL := 40000;", "[TYP]( n, z )", "n"),
        fault("n : INT; z : REAL := -40000;", "[TRUNC]( n, z )", "n"),
        fault("b : BOOL; z : INT := 2;", "[TYP]( b, z )", "b"),
        fault(
            "a : ARRAY[1..3] OF INT; i : INT := 4;",
            "[MOV]( a[i], 1 )",
            "a[3]",
        ),
        fault(
            "a : ARRAY[1..3] OF INT; n : INT := 1; i : INT;",
            "[MOV]( n, a[i] )",
            "n",
        ),
        fault("x : INT := 1; z : INT;", "[CALC]( x, 10 / (z * 2) )", "x"),
    ];
    expect![[r#"
        [DIV]( n, 5, z ): division by zero: nothing was written; check the divisor before this block
        [MOD]( n, 5, z ): division by zero: nothing was written; check the divisor before this block
        [DIV]( x, 5, z ): division by zero: nothing was written; check the divisor before this block
        [MOD]( x, 5, z ): division by zero: nothing was written; check the divisor before this block
        [EXP]( n, 5, e ): an integer cannot be raised to the negative power -1: nothing was written; use a REAL or LREAL result
        [SHL]( n, n, e ): cannot shift by -1 places: nothing was written; shift the other way with 0 or more places
        [SQRT]( x, z ): the function has no result for -1.0: nothing was written; limit the value before this block
        [LN]( x, z ): the function has no result for 0.0: nothing was written; limit the value before this block
        [ASIN]( x, z ): the function has no result for 1.5: nothing was written; limit the value before this block
        [MUL]( x, x, x ): the result is too large for a real number: nothing was written; check the operands
        [EXPE]( x, x ): the result is too large for a real number: nothing was written; check the operands
        [EXP]( x, x, 0.5 ): the function has no result for -8.0: nothing was written; limit the value before this block
        [TYP]( n, z ): the value does not fit into the type of the result: nothing was written; limit it before this block or use a wider type
        [TYP]( n, z ): the value does not fit into the type of the result: nothing was written; limit it before this block or use a wider type
        [TRUNC]( n, z ): the value does not fit into the type of the result: nothing was written; limit it before this block or use a wider type
        [TYP]( b, z ): the value does not fit into the type of the result: nothing was written; limit it before this block or use a wider type
        [MOV]( a[i], 1 ): index 4 is outside the array [1..3]: nothing was written; limit the index before this block
        [MOV]( n, a[i] ): index 0 is outside the array [1..3]: nothing was written; limit the index before this block
        [CALC]( x, 10 / (z * 2) ): division by zero: nothing was written; check the divisor before this block
    "#]].assert_eq(&all.concat());
}

#[test]
fn the_scan_goes_on_and_the_next_one_knows() {
    check(
        "VAR_INPUT z : INT := 0; END_VAR\nVAR n, m : INT; before, now : BOOL; END_VAR\n\
         +--[ ]( SYS.FAULT )--( )( before )--+\n\
         +--[DIV]( n, 100, z )--[MOV]( m, n )--+\n\
         +--[ ]( SYS.FAULT )--( )( now )--+\n",
        "z 0 5 0 0",
        "n m before now SYS.FAULT",
        expect![[r#"
            n          0 20 20 20
            m          0 20 20 20
            before     _-_-
            now        _-_-
            SYS.FAULT  _-_-
            scan 0 at 117: division by zero: nothing was written; check the divisor before this block
            scan 2 at 117: division by zero: nothing was written; check the divisor before this block
            scan 3 at 117: division by zero: nothing was written; check the divisor before this block
        "#]],
    );
}

#[test]
fn a_block_without_power_reads_nothing() {
    let mut simulation = simulation(
        "VAR_INPUT a : BOOL; z : INT; END_VAR\nVAR n : INT; END_VAR\n+--[ ]( a )--[DIV]( n, 5, z )--+\n",
    );
    simulation.scan();
    assert!(simulation.take_faults().is_empty());
    set(&mut simulation, "a", "1");
    simulation.scan();
    assert_eq!(simulation.take_faults().len(), 1);
}

#[test]
fn faults_of_a_long_run_do_not_fill_the_memory() {
    let mut simulation = simulation("VAR n, z : INT; END_VAR\n+--[DIV]( n, 5, z )--+\n");
    for _ in 0..10_000 {
        assert!(simulation.scan());
    }
    let faults = simulation.take_faults();
    assert_eq!((faults.first().unwrap().scan, faults.len()), (0, 4096));
}

#[test]
fn every_kind_in_ranges_texts_and_ports() {
    let words = "a : ARRAY[1..4] OF INT := [1, 2, 3, 4]; b : ARRAY[0..2] OF INT; i, j : INT;";
    let all: Vec<String> = vec![
        fault("n : INT := 7; k : INT := 2;", "[MUX]( n, k, 5, 6 )", "n"),
        fault("n : INT := 7; k : INT := -1;", "[LUT]( n, k, 5, 6 )", "n"),
        fault(words, "[BMOV]( b[i..2], a[1..4] )", "b[0]"),
        fault(
            &words.replace("i, j : INT", "i : INT := 3; j : INT := 2"),
            "[FILL]( a[i..j], 9 )",
            "a[2]",
        ),
        fault(
            &words.replace("i, j : INT", "i : INT := 5; j : INT"),
            "[FILL]( a[1..i], 9 )",
            "a[1]",
        ),
        fault("n : INT := 7; s : STRING := '12x';", "[TYP]( n, s )", "n"),
        fault("n : SINT := 7; s : STRING := '300';", "[TYP]( n, s )", "n"),
        fault("t : TIME; x : LREAL := 1.0e300;", "[TYP]( t, x )", "t"),
        fault("n : INT; t : TIME := T#1h;", "[TYP]( n, t )", "n"),
        fault("s : STRING := 'abc';", "[LEFT]( s, s, 4 )", "s"),
        fault("w : WORD := 3; n : INT := -2;", "[ROL]( w, w, n )", "w"),
        fault("x : LREAL := 7; z : LREAL := -1;", "[LOG]( x, z )", "x"),
        fault("x : LREAL := 7; z : LREAL := -2;", "[ACOS]( x, z )", "x"),
        fault("t : TIME := T#1s; z : INT;", "[DIV]( t, t, z )", "t"),
        fault("n : INT := 7; c : INT := 64;", "[ADC]( n, c )", "n"),
        fault("p : BOOL; a : ARRAY[1..3] OF BOOL; i : INT;", "[ ]( a[i] )", "p"),
        fault(
            "p : BOOL; a : ARRAY[1..3] OF BOOL; i : INT := 9;",
            "( )( a[i] )",
            "p",
        ),
        fault(
            "p : BOOL; a : ARRAY[1..3] OF WORD; i : INT := 9;",
            "(S)( a[i].3 )",
            "p",
        ),
    ];
    expect![[r#"
        [MUX]( n, k, 5, 6 ): 2 selects none of the 2 values, which count from 0 to 1: nothing was written
        [LUT]( n, k, 5, 6 ): -1 selects none of the 2 values, which count from 0 to 1: nothing was written
        [BMOV]( b[i..2], a[1..4] ): the ranges have different lengths, 3 and 4: nothing was written; make them equal
        [FILL]( a[i..j], 9 ): the range from 3 to 2 ends before it begins: nothing was written; check its ends before this block
        [FILL]( a[1..i], 9 ): index 5 is outside the array [1..4]: nothing was written; limit the index before this block
        [TYP]( n, s ): the text cannot be read as a value of the result's type: nothing was written
        [TYP]( n, s ): the value does not fit into the type of the result: nothing was written; limit it before this block or use a wider type
        [TYP]( t, x ): the value does not fit into the type of the result: nothing was written; limit it before this block or use a wider type
        [TYP]( n, t ): the value does not fit into the type of the result: nothing was written; limit it before this block or use a wider type
        [LEFT]( s, s, 4 ): 4 does not fit a text of 3 characters: nothing was written; check the length and positions before this block
        [ROL]( w, w, n ): cannot shift by -2 places: nothing was written; shift the other way with 0 or more places
        [LOG]( x, z ): the function has no result for -1.0: nothing was written; limit the value before this block
        [ACOS]( x, z ): the function has no result for -2.0: nothing was written; limit the value before this block
        [DIV]( t, t, z ): division by zero: nothing was written; check the divisor before this block
        [ADC]( n, c ): index 64 is outside the array [0..63]: nothing was written; limit the index before this block
        [ ]( a[i] ): index 0 is outside the array [1..3]: nothing was written; limit the index before this block
        ( )( a[i] ): index 9 is outside the array [1..3]: nothing was written; limit the index before this block
        (S)( a[i].3 ): index 9 is outside the array [1..3]: nothing was written; limit the index before this block
    "#]].assert_eq(&all.concat());
}

#[test]
fn a_coil_acts_with_low_power_and_so_needs_its_index() {
    let rungs = [
        "( )( a[i] )",
        "(/)( a[i] )",
        "(S)( a[i] )",
        "(R)( a[i] )",
        "(P)( a[i] )",
        "(N)( a[i] )",
        "(M)( a[i] )",
        "(SM)( a[i] )",
        "(RM)( a[i] )",
        "(RES)( t[i] )",
        "(R)( t[i] )",
        "( )( n[i].3 )",
        "[TON]( t[i], 1s )",
        "[P]( a[i] )",
    ];
    let of_high_power = ["[ ]( a[i] )", "[MOV]( n[i], 5 )", "[EQ]( n[i], 5 )"];
    for rung in rungs.iter().chain(&of_high_power) {
        let text = format!(
            "VAR a : ARRAY[1..2] OF BOOL; n : ARRAY[1..2] OF INT; t : ARRAY[1..2] OF TON; i : INT := 5; e, u : BOOL; END_VAR\n\
             +--[ ]( e )--{rung}--( )( Q1 )--+\n"
        );
        for plain in [false, true] {
            let mut simulation = simulation(&text);
            if plain {
                force(&mut simulation, "u", "0");
            }
            simulation.scan();
            let faults = simulation.take_faults().len();
            assert_eq!(
                faults,
                usize::from(rungs.contains(rung)),
                "{rung}, plain code: {plain}"
            );
        }
    }
}

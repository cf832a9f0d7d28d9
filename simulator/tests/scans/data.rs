//! Data instructions: moves, conversions, selection, curves, strings, ranges, expressions.

use crate::support::{check, get, set, simulation};
use expect_test::expect;

/// Runs a program of one scan; what its tags hold then, and its faults.
#[track_caller]
#[allow(clippy::needless_pass_by_value)]
fn once(declarations: &str, rung: &str, watch: &str, expected: expect_test::Expect) {
    check(
        &format!("VAR {declarations} END_VAR\n{rung}\n"),
        "1",
        watch,
        expected,
    );
}

#[test]
fn conversions() {
    once(
        "i : INT; j : INT; k : DINT; u : USINT; b, c : BOOL; r : REAL; l : LREAL; t, v : TIME; s : SINT;",
        "+--[TYP]( i, 2.5 )--[TYP]( j, 3.5 )--[TYP]( k, T#1500us )--[TYP]( u, TRUE )--[TYP]( b, 1 )--+\n\
         +--[TYP]( c, 0.4 )--[TYP]( r, 16777217 )--[TYP]( l, T#2500us )--[TYP]( t, 1500 )--[TYP]( v, 0.5 )--+\n\
         +--[TYP]( s, -2.5 )--+",
        "i j k u b c r l t v s",
        expect![[r#"
            i  2
            j  4
            k  2
            u  1
            b  -
            c  _
            r  16777216.0
            l  2.5
            t  1500
            v  0.5
            s  -2
        "#]],
    );
}

#[test]
fn conversions_of_bit_strings_and_dates() {
    once(
        "w : WORD := 16#FFFF; i : INT; d : DINT; x : DT := DT#2026-11-21-13:45:00.5; y : DATE; z : TOD; b : BYTE; \
         a, c : TIME; dt2 : DT;",
        "+--[MOV]( i, w )--[TYP]( d, w )--[TYP]( y, x )--[TYP]( z, x )--[TYP]( b, 255 )--+\n\
         +--[SUB]( a, x, DT#2026-11-20-00:00:00 )--[ADD]( dt2, x, T#1d )--[MUL]( c, T#1s, 2.5 )--+",
        "i d y z b a dt2 c",
        expect![[r#"
            i    -1
            d    65535
            y    2026-11-21
            z    13:45:00.5
            b    255
            a    135900500
            dt2  2026-11-22-13:45:00.5
            c    2500
        "#]],
    );
}

#[test]
fn numbers_and_texts() {
    once(
        "s, u, v, w, x, y : STRING; i : INT; r : REAL; t, t2, t3 : TIME; b : BOOL; h : DINT;",
        "+--[TYP]( s, -42 )--[TYP]( u, 1.5 )--[TYP]( v, T#1m30s )--[TYP]( w, TRUE )--+\n\
         +--[TYP]( i, ' 1_234 ' )--[TYP]( r, '2.5e1' )--[TYP]( t, 'T#1h30m' )--[TYP]( t2, '250ms' )--+\n\
         +--[TYP]( t3, '1.5' )--[TYP]( b, 'true' )--[TYP]( h, '16#FF' )--[UNPACK]( x, 7 )--+",
        "s u v w i r t t2 t3 b h x",
        expect![[r#"
            s   -42
            u   1.5
            v   T#1m30s
            w   TRUE
            i   1234
            r   25.0
            t   5400000
            t2  250
            t3  1.5
            b   -
            h   255
            x   7
        "#]],
    );
}

#[test]
fn texts_that_are_no_values() {
    for text in ["", "x", "1x", "--1", "1.5", "40000", "16#G", "2#2", "_1"] {
        let program =
            format!("VAR i : INT := 7; ok : BOOL; END_VAR\n+--[TYP]( i, '{text}' )--( )( ok )--+\n");
        let mut simulation = simulation(&program);
        simulation.scan();
        assert_eq!(
            (get(&simulation, "i"), get(&simulation, "ok")),
            ("7".into(), "0".into()),
            "{text}"
        );
        assert_eq!(simulation.take_faults().len(), 1, "{text}");
    }
    for text in ["inf", "nan", "1e999", "1,5"] {
        let program = format!("VAR r : REAL; ok : BOOL; END_VAR\n+--[TYP]( r, '{text}' )--( )( ok )--+\n");
        let mut simulation = simulation(&program);
        simulation.scan();
        assert_eq!(get(&simulation, "ok"), "0", "{text}");
    }
    for text in ["T#", "5x", "1s1h", "1.5h3m", "T#5"] {
        let program = format!("VAR t : TIME; ok : BOOL; END_VAR\n+--[TYP]( t, '{text}' )--( )( ok )--+\n");
        let mut simulation = simulation(&program);
        simulation.scan();
        assert_eq!(get(&simulation, "ok"), "0", "{text}");
    }
}

#[test]
fn selections() {
    check(
        "VAR_INPUT k : INT; g : BOOL; END_VAR\nVAR n, m : INT; b, ok : BOOL; s, t : STRING[5]; x : BYTE; END_VAR\n\
         +--[SEL]( n, g, 10, 20 )--[SEL]( b, g, FALSE, TRUE )--[SEL]( s, g, 'low', 'high!' )--+\n\
         +--[MUX]( m, k, 5, 6, 7 )--( )( ok )--+\n\
         +--[LUT]( x, k, 16#3F, 16#06 )--[MUX]( t, k, 'a', s )--+\n",
        "k 0 1 2 3 -1\ng _-___",
        "n b s m ok x t",
        expect![[r#"
            n   10 20 10 10 10
            b   _-___
            s   low high! low low low
            m   5 6 7 7 7
            ok  ---__
            x   63 6 6 6 6
            t   a high! high! high! high!
            scan 2 at 233: 2 selects none of the 2 values, which count from 0 to 1: nothing was written
            scan 3 at 193: 3 selects none of the 3 values, which count from 0 to 2: nothing was written
            scan 3 at 233: 3 selects none of the 2 values, which count from 0 to 1: nothing was written
            scan 4 at 193: -1 selects none of the 3 values, which count from 0 to 2: nothing was written
            scan 4 at 233: -1 selects none of the 2 values, which count from 0 to 1: nothing was written
        "#]],
    );
}

#[test]
fn curves() {
    check(
        "VAR_INPUT x : INT; r : REAL; END_VAR\nVAR y, z : INT; l : REAL; END_VAR\n\
         +--[PWL]( y, x, 0, 10, 3, 0, 6, 0, 10, -9 )--[PWL]( z, x, 5, 1, 5, 2 )--+\n\
         +--[PWL]( l, r, 0, 0, 1, 2.5 )--+\n",
        "x -5 0 1 2 3 4 7 8 99\nr -1 0 0.5 1 2 . . . .",
        "y z l",
        expect![[r#"
            y  10 10 6 3 0 0 -2 -4 -9
            z  1 1 1 1 1 1 2 2 2
            l  0.0 0.0 1.25 2.5 2.5 2.5 2.5 2.5 2.5
        "#]],
    );
}

#[test]
fn string_functions() {
    once(
        "s : STRING := 'ladder'; a, b, c, d, e, f, g, h : STRING; n, m, o : INT; short : STRING[3];",
        "+--[LEN]( n, s )--[FIND]( m, s, 'dd' )--[FIND]( o, s, 'x' )--+\n\
         +--[LEFT]( a, s, 2 )--[RIGHT]( b, s, 2 )--[MID]( c, s, 3, 2 )--[CONCAT]( d, s, '-', a, b )--+\n\
         +--[INSERT]( e, s, 'XX', 0 )--[DELETE]( f, s, 2, 3 )--[REPLACE]( g, s, 'T', 2, 3 )--+\n\
         +--[CONCAT]( s, s, s )--[MOV]( short, s )--[CALC]( h, CONCAT(LEFT(s, 1), RIGHT(s, 1)) )--+",
        "n m o a b c d e f g s short h",
        expect![[r#"
            n      6
            m      3
            o      0
            a      la
            b      er
            c      add
            d      ladder-laer
            e      XXladder
            f      laer
            g      laTer
            s      ladderladder
            short  lad
            h      lr
        "#]],
    );
}

#[test]
fn positions_outside_the_text() {
    let blocks = [
        "[LEFT]( y, s, 4 )",
        "[LEFT]( y, s, -1 )",
        "[RIGHT]( y, s, 4 )",
        "[MID]( y, s, 2, 3 )",
        "[MID]( y, s, 1, 0 )",
        "[INSERT]( y, s, 'x', 4 )",
        "[DELETE]( y, s, 1, 4 )",
        "[REPLACE]( y, s, 'x', 3, 2 )",
    ];
    let mut all = String::new();
    for block in blocks {
        let text =
            format!("VAR s : STRING := 'abc'; y : STRING; ok : BOOL; END_VAR\n+--{block}--( )( ok )--+\n");
        let mut simulation = simulation(&text);
        simulation.scan();
        assert_eq!(
            (get(&simulation, "y"), get(&simulation, "ok")),
            (String::new(), "0".into()),
            "{block}"
        );
        all.push_str(&format!("{block}: {}\n", simulation.take_faults()[0].message));
    }
    expect![[r#"
        [LEFT]( y, s, 4 ): 4 does not fit a text of 3 characters: nothing was written; check the length and positions before this block
        [LEFT]( y, s, -1 ): -1 does not fit a text of 3 characters: nothing was written; check the length and positions before this block
        [RIGHT]( y, s, 4 ): 4 does not fit a text of 3 characters: nothing was written; check the length and positions before this block
        [MID]( y, s, 2, 3 ): 3 does not fit a text of 3 characters: nothing was written; check the length and positions before this block
        [MID]( y, s, 1, 0 ): 0 does not fit a text of 3 characters: nothing was written; check the length and positions before this block
        [INSERT]( y, s, 'x', 4 ): 4 does not fit a text of 3 characters: nothing was written; check the length and positions before this block
        [DELETE]( y, s, 1, 4 ): 4 does not fit a text of 3 characters: nothing was written; check the length and positions before this block
        [REPLACE]( y, s, 'x', 3, 2 ): 2 does not fit a text of 3 characters: nothing was written; check the length and positions before this block
    "#]].assert_eq(&all);
}

#[test]
fn ranges_of_arrays() {
    check(
        "VAR_INPUT i, j : INT; END_VAR\n\
         VAR a : ARRAY[1..5] OF INT := [1, 2, 3, 4, 5]; b : ARRAY[0..4] OF INT; s : ARRAY[1..3] OF STRING[4]; END_VAR\n\
         VAR f : ARRAY[1..4] OF BOOL; ok, ok2 : BOOL; END_VAR\n\
         +--[BMOV]( b[i], a[2..4] )--( )( ok )--+\n\
         +--[BMOV]( a[2..5], a[1..4] )--[FILL]( s[1..3], 'text' )--[FILL]( f[2..3], TRUE )--+\n\
         +--[FILL]( b[i..j], 9 )--( )( ok2 )--+\n",
        "i 0 2 3 0\nj 0 4 4 -1",
        "b[0] b[1] b[2] b[3] b[4] a[1] a[2] a[5] s[3] f[1] f[2] ok ok2",
        expect![[r#"
            b[0]  9 9 9 1
            b[1]  3 3 3 1
            b[2]  4 9 9 1
            b[3]  0 9 9 9
            b[4]  0 9 9 9
            a[1]  1 1 1 1
            a[2]  1 1 1 1
            a[5]  4 3 2 1
            s[3]  text text text text
            f[1]  ____
            f[2]  ----
            ok    --_-
            ok2   ---_
            scan 2 at 195: index 5 is outside the array [0..4]: nothing was written; limit the index before this block
            scan 3 at 321: index -1 is outside the array [0..4]: nothing was written; limit the index before this block
        "#]],
    );
}

#[test]
fn shift_registers() {
    check(
        "VAR_INPUT step, d : BOOL; END_VAR\n\
         VAR belt : ARRAY[1..3] OF BOOL; n : ARRAY[0..2] OF INT; s : ARRAY[1..2] OF STRING := ['a', 'b']; y : BOOL; END_VAR\n\
         +--[ ]( step )--[SHIFT]( belt[1..3], d )--[SHIFT]( n[0..2], 7 )--[SHIFT]( s[1..2], s[2] )--( )( y )--+\n",
        "step --_-_-\nd    -_____",
        "belt[1] belt[2] belt[3] n[0] n[1] s[1] s[2] y",
        expect![[r#"
            belt[1]  ---___
            belt[2]  ___--_
            belt[3]  _____-
            n[0]     7 7 7 7 7 7
            n[1]     0 0 0 7 7 7
            s[1]     b b b a a b
            s[2]     a a a b b a
            y        --_-_-
        "#]],
    );
}

#[test]
fn packing() {
    once(
        "f : ARRAY[0..7] OF BOOL := [TRUE, FALSE, TRUE, FALSE, FALSE, FALSE, FALSE, TRUE]; b : BYTE; s : SINT; \
         p : ARRAY[1..4] OF BYTE := [1, 2, 3, 4]; d : DWORD; q : ARRAY[1..2] OF INT; g : ARRAY[1..10] OF BOOL; t : STRING; n : INT;",
        "+--[PACK]( b, f[0..7] )--[PACK]( s, f[0..7] )--[PACK]( d, p[1..4] )--[UNPACK]( q[1..2], d )--+\n\
         +--[UNPACK]( g[1..10], b )--[UNPACK]( t, d )--[PACK]( n, '-12' )--+",
        "b s d q[1] q[2] g[1] g[2] g[8] g[9] t n",
        expect![[r#"
            b     133
            s     -123
            d     67305985
            q[1]  513
            q[2]  1027
            g[1]  -
            g[2]  _
            g[8]  -
            g[9]  _
            t     67305985
            n     -12
        "#]],
    );
}

#[test]
fn searching() {
    check(
        "VAR_INPUT next : BOOL; END_VAR\n\
         VAR w : ARRAY[1..5] OF INT := [3, 9, 4, 9, 1]; r : ARRAY[-2..0] OF REAL := [0.5, 0.1, 2.5]; END_VAR\n\
         VAR y : INT := 7; z, none, k : INT; found, seen : BOOL; s : ARRAY[1..2] OF STRING := ['x', 'y']; END_VAR\n\
         +--[SEARCH]( y, GT, 3, w[1..5], NEXT := next, FOUND => found )--+\n\
         +--[SEARCH]( z, EQ, 0.1, r[-2..0] )--[SEARCH]( none, LT, 0, w[2..4], FOUND => seen )--[SEARCH]( k, EQ, 'y', s[1..2] )--+\n",
        "next _-----_",
        "y found z none seen k",
        expect![[r#"
            y      2 3 4 -1 -1 -1 2
            found  ---___-
            z      -1 -1 -1 -1 -1 -1 -1
            none   -1 -1 -1 -1 -1 -1 -1
            seen   _______
            k      2 2 2 2 2 2 2
        "#]],
    );
}

#[test]
fn expressions() {
    once(
        "a : DINT := 7; b : DINT := -2; n, m, o, p, q : DINT; x, y, z : LREAL; f, g, h : BOOL; w : WORD; r : ARRAY[1..3] OF INT := [1, 2, 3]; \
         t : TIME; u : UINT := 65535; s : REAL;",
        "+--[CALC]( n, a + b * 3 ^ 2 )--[CALC]( m, -2 ^ 2 )--[CALC]( o, a / 2 * 2 + a MOD 2 )--[CALC]( p, 1 SHL 3 + 1 )--+\n\
         +--[CALC]( x, SQRT(2.0) * PI )--[CALC]( f, a > 3 AND NOT (b > 0) OR a = 0 )--[CALC]( w, 16#F0 AND NOT 16#30 )--+\n\
         +--[CALC]( q, SUM(r[1..3]) + MAX(a, b, 9) - LIMIT(0, b, 5) + SEL(TRUE, 1, 100) )--[CALC]( t, (T#1s + T#500ms) * 2 )--+\n\
         +--[CALC]( y, 2 ^ 3 ^ 2 )--[CALC]( z, SUM(r[2..3]) )--[CALC]( g, u + 1 > u )--[CALC]( s, 1 / 3 )--[CALC]( h, 'a' < 'b' XOR TRUE )--+",
        "n m o p x f w q t y z g s h",
        expect![[r#"
            n  -11
            m  4
            o  7
            p  16
            x  4.442882938158366
            f  -
            w  192
            q  115
            t  3000
            y  512.0
            z  5.0
            g  _
            s  0.33333334
            h  _
        "#]],
    );
}

#[test]
fn ports() {
    let mut simulation = simulation(
        "VAR_INPUT go : BOOL; END_VAR\nVAR raw, b : INT; u : USINT; came, fits : BOOL; END_VAR\n\
         +--[ADC]( raw, 3 )--[PWM]( 40, 1000, CH := 2 )--[URCV]( b )--( )( came )--+\n\
         +--[P]( go )--[FMT]( 'n=%d of %d%d$N', raw, -1 )--[USND]( 321 )--+\n\
         +--[ADC]( u, 4 )--( )( fits )--+\n",
    );
    set(&mut simulation, "PORT.ADC[3]", "512");
    set(&mut simulation, "port.adc[4]", "300");
    simulation.feed_serial(b"A");
    set(&mut simulation, "go", "1");
    simulation.scan();
    let values: Vec<String> = [
        "raw",
        "PORT.DUTY[2]",
        "PORT.FREQUENCY[2]",
        "b",
        "came",
        "fits",
        "u",
    ]
    .iter()
    .map(|tag| get(&simulation, tag))
    .collect();
    assert_eq!(values, ["512", "40", "1000", "65", "1", "0", "0"]);
    assert_eq!(
        String::from_utf8(simulation.take_serial()).unwrap(),
        "n=512 of -1%d\nA"
    );
    simulation.scan();
    assert_eq!(
        (get(&simulation, "b"), get(&simulation, "came")),
        ("65".into(), "0".into())
    );
    assert!(simulation.take_serial().is_empty());
    let messages: Vec<String> = ["PORT.ADC", "PORT.ADC[64]", "PORT.DAC[1]"]
        .iter()
        .map(|name| simulation.resolve(name).unwrap_err().message)
        .collect();
    expect![[r#"
        the channels of PORT.ADC are 0 to 63
        the channels of PORT.ADC are 0 to 63
        there is no port `DAC`: the ports are PORT.ADC[0], PORT.DUTY[0], PORT.FREQUENCY[0]"#]]
    .assert_eq(&messages.join("\n"));
}

#[test]
fn scan_time() {
    let mut simulation =
        simulation("VAR n : INT; r : REAL; END_VAR\n+--[SCANTIME]( n )--[SCANTIME]( r )--[SCANTIME]--+\n");
    simulation.scan();
    assert_eq!(get(&simulation, "n"), "0");
    for _ in 0..250 {
        simulation.scan();
    }
    assert_eq!(
        (get(&simulation, "n"), get(&simulation, "r")),
        ("10".into(), "10.0".into())
    );
    assert_eq!(simulation.take_serial(), b"10\r\n10\r\n");
}

/// The index is the array's own, wherever the array lies in its tag.
#[test]
fn searching_an_array_in_another() {
    check(
        "TYPE\n R : STRUCT\n t : ARRAY[1..4] OF INT := [0, 3, 2, 3];\n s : ARRAY[-3..0] OF STRING := ['a', 'b', 'c', 'd'];\n f : ARRAY[5..8] OF BOOL := [FALSE, FALSE, TRUE, FALSE];\n END_STRUCT;\nEND_TYPE\n\
         FUNCTION_BLOCK [$Find]\nVAR_IN_OUT unit : R; list : ARRAY[1..4] OF INT; END_VAR\nVAR_OUTPUT i, j : INT; END_VAR\n\
         +--[SEARCH]( i, EQ, 3, unit.t[2..4] )--[SEARCH]( j, EQ, 3, list )--+\nEND_FUNCTION_BLOCK\n\
         VAR_INPUT n : INT; from : INT := 1; next : BOOL; END_VAR\n\
         VAR b : ARRAY[0..1] OF R; g : ARRAY[0..1, 1..4] OF INT := [4(0), 0, 0, 0, 3]; p, q, r, v, w, i, j : INT; found : BOOL; END_VAR\n\
         +--[SEARCH]( p, EQ, 3, b[n].t[from..4], NEXT := next, FOUND => found )--[SEARCH]( q, EQ, 3, b[1].t )--[SEARCH]( r, EQ, 3, g[n, from..4] )--+\n\
         +--[SEARCH]( v, EQ, 'c', b[n].s[-3..0] )--[SEARCH]( w, EQ, TRUE, b[1].f[5..8] )--[$Find]( b[n], b[1].t, i, j )--+\n",
        "n 1 1 1 0 1\nnext _--__\nfrom 1 1 1 1 4",
        "p found q r v w i j",
        expect![[r#"
            p      2 4 -1 2 4
            found  --_--
            q      2 2 2 2 2
            r      4 4 4 -1 4
            v      -1 -1 -1 -1 -1
            w      7 7 7 7 7
            i      2 2 2 2 2
            j      2 2 2 2 2
        "#]],
    );
}

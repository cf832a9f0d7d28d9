//! The types of undeclared tags, one table a case.

use crate::analyze;
use expect_test::{Expect, expect};
use std::sync::Arc;

/// The tags of the file's scope with their types and roles, then the errors.
fn check(text: &str, expected: Expect) {
    let parse = Arc::new(ladder_syntax::parse(text));
    let analysis = analyze(&parse, "test.clad");
    let mut shown = String::new();
    for tag in &analysis.context.scopes[0].tags {
        let ty = tag.ty.map(|ty| ty.to_string()).unwrap_or_default();
        shown.push_str(&format!("{} : {ty}, {:?}\n", tag.name, tag.role));
    }
    for found in analysis
        .diagnostics()
        .iter()
        .filter(|d| d.severity == crate::Severity::Error)
    {
        shown.push_str(&format!(
            "{}: {} `{}`\n",
            found.rule, found.message, &text[found.range]
        ));
    }
    expected.assert_eq(&shown);
}

#[test]
fn places_give_their_type() {
    check(
        "+--[ ]( a )--[TON]( t, pt, R := r )--(S)( y )--+\n+--[CTU]( c, pv, R := r )--(RES)( c )--+\n",
        expect![[r#"
            a : BOOL, Input
            t : TON, Internal
            pt : TIME, Input
            r : BOOL, Input
            y : BOOL, Output
            c : CTU, Internal
            pv : DINT, Input
        "#]],
    );
    check(
        "+--[SEL]( n, g, 1, 2 )--[LEN]( k, s )--[CONCAT]( u, s, 'x' )--+\n",
        expect![[r#"
        n : DINT, Internal
        g : BOOL, Input
        k : DINT, Internal
        s : STRING, Input
        u : STRING, Internal
    "#]],
    );
}

#[test]
fn names_that_say_their_type() {
    check(
        "+--[ ]( I1 )--[MOV]( MI3, 5 )--[MOV]( MF1, 2.5 )--( )( Q2 )--( )( %QX0.1 )--+\n",
        expect![[r#"
        I1 : BOOL, Input
        MI3 : DINT, Internal
        MF1 : LREAL, Internal
        Q2 : BOOL, Output
        %QX0.1 : BOOL, Output
    "#]],
    );
}

#[test]
fn company_gives_its_type() {
    check(
        "+--[MOV]( x, 2.5 )--[ADD]( y, x, 1 )--[MOV]( z, 5s )--[MOV]( d, D#2026-11-21 )--+\n",
        expect![[r#"
        x : LREAL, Internal
        y : LREAL, Internal
        z : TIME, Internal
        d : DATE, Internal
    "#]],
    );
    check(
        "+--[GT]( level, 80.5 )--[GT]( elapsed, t.ET )--[TON]( t, 5s )--( )( y )--+\n",
        expect![[r#"
        level : LREAL, Input
        elapsed : TIME, Input
        t : TON, Internal
        y : BOOL, Output
    "#]],
    );
    check(
        "+--[SQRT]( root, 2.0 )--[CALC]( area, PI * root ^ 2.0 )--+\n",
        expect![[r#"
        root : LREAL, Internal
        area : LREAL, Internal
    "#]],
    );
    check(
        "+--[MOV]( n, 3 )--[EQ]( n, m )--( )( y )--+\n",
        expect![[r#"
        n : DINT, Internal
        m : DINT, Input
        y : BOOL, Output
    "#]],
    );
}

#[test]
fn reset_takes_a_bit_or_a_counter() {
    check(
        "+--[ ]( a )--(R)( c )--+\n+--[ ]( b )--[CTU]( c, 3 )--+\n+--[ ]( b )--(R)( y )--+\n",
        expect![[r#"
        a : BOOL, Input
        c : CTU, Internal
        b : BOOL, Input
        y : BOOL, Output
    "#]],
    );
}

#[test]
fn two_answers() {
    check(
        "+--[ ]( t )--[TON]( t, 5s )--( )( y )--+\n",
        expect![[r#"
        t : BOOL, Internal
        y : BOOL, Output
        type-mismatch: `t` is used as TON here, and as BOOL before `t`
    "#]],
    );
}

#[test]
fn inputs_and_outputs() {
    check(
        "+--[ ]( start )--\\--[/]( stop )--( )( run )--+\n|  /--[ ]( run )--/\n+--[ ]( run )--( )( lamp )--+\n",
        expect![[r#"
            start : BOOL, Input
            stop : BOOL, Input
            run : BOOL, Internal
            lamp : BOOL, Output
            unpaired-connector: the 2nd `/` on line 2 has no partner: line 2 has 2 `/`, line 1 above it has 1 `\` `/`
        "#]],
    );
}

#[test]
fn arrays_must_be_declared() {
    check(
        "+--[MOV]( a[1], 5 )--+\n",
        expect![[r#"
        a : DINT, Internal
        undeclared-tag: the array `a` is not declared `a`
    "#]],
    );
    check(
        "VAR a : ARRAY[1..3] OF INT; END_VAR\n+--[MOV]( a[4], 5 )--[MOV]( a, 5 )--[MOV]( a[2].16, TRUE )--+\n\
         +--[CALC]( a[1], a[a[1]] + a[a[1] + 1] )--[BMOV]( a[1..2], a[-a[1]..3] )--+\n",
        expect![[r#"
            a : ARRAY[1..3] OF INT, Internal
            bad-operand: `a` has the elements 1 to 3, there is no 4 `4`
            type-mismatch: `a` is an array: name an element such as a[1] `a`
            unknown-member: INT has the bits 0 to 15, there is no `16` `16`
        "#]],
    );
}

#[test]
fn values_that_do_not_pass() {
    check(
        "VAR i : INT; w : WORD; u : UINT; r : REAL; t : TIME; b : BOOL; s : STRING; n : TON; END_VAR\n\
         +--[MOV]( i, w )--[MOV]( w, i )--[MOV]( r, i )--+\n\
         +--[MOV]( i, u )--+\n+--[MOV]( i, r )--+\n+--[MOV]( b, i )--+\n+--[ADD]( w, w, 1 )--+\n+--[ADD]( t, t, 5 )--+\n\
         +--[MUL]( t, t, 5 )--[ADD]( t, t, 5s )--[DIV]( t, t, 2.0 )--+\n+--[GT]( t, i )--+\n+--[GT]( b, TRUE )--+\n\
         +--[ ]( n )--+\n+--[ ]( i )--+\n+--[MOV]( s, 5 )--+\n+--[MOV]( i, 40000 )--+\n+--[MOV]( SYS.SCAN, 1 )--+\n\
         +--[MOV]( n.ET, 5s )--+\n+--[ADD]( 5, i, i )--+\n+--[ADD]( i, i + 1, i )--+\n",
        expect![[r#"
            i : INT, Internal
            w : WORD, Internal
            u : UINT, Internal
            r : REAL, Internal
            t : TIME, Internal
            b : BOOL, Internal
            s : STRING, Internal
            n : TON, Internal
            type-mismatch: `u` is UINT, and `a` of [MOV] takes INT `u`
            type-mismatch: `r` is REAL, and `a` of [MOV] takes INT `r`
            type-mismatch: `i` is INT, and `a` of [MOV] takes BOOL `i`
            type-mismatch: the result is WORD, this block gives a number or a TIME `w`
            type-mismatch: the number 5 is given, TIME is expected `5`
            type-mismatch: TIME and INT cannot be compared `[GT]( t, i )`
            type-mismatch: BOOL values are equal or not: none is greater than another `[GT]( b, TRUE )`
            type-mismatch: `n` is the state of a TON, a value is expected here `n`
            type-mismatch: this is INT, BOOL is expected here `i`
            type-mismatch: the number 5 is given, STRING is expected `5`
            literal-out-of-range: 40000 is outside of INT, which holds -32768 to 32767 `40000`
            constant-write: the tags of SYS are read only: the controller sets them `SYS.SCAN`
            bad-operand: a member of a timer or counter is written by its own block only: use (RES) or R := to clear it `n.ET`
            bad-operand: the result `i` is last here `5, i, i`
            bad-operand: an expression belongs in [CALC] only: a tag or a literal is expected here `i + 1`
        "#]],
    );
}

#[test]
fn expressions() {
    check(
        "VAR i : INT; d : DINT; r : REAL; b : BOOL; t : TIME; a : ARRAY[1..3] OF INT; END_VAR\n\
         +--[CALC]( d, (i + 2) * MAX(i, 3) - SUM(a[1..3]) )--[CALC]( b, i > 2 AND NOT (r < 1.5) )--+\n\
         +--[CALC]( t, t * 2 + 5s )--[CALC]( r, SQRT(r) + i )--[CALC]( b, d > i )--+\n\
         +--[CALC]( i, d )--+\n+--[CALC]( i, PI )--+\n+--[CALC]( i, i > 2 )--+\n+--[CALC]( i, FOO(2) )--+\n+--[CALC]( i, MAX(2) )--+\n",
        expect![[r#"
            i : INT, Internal
            d : DINT, Internal
            r : REAL, Internal
            b : BOOL, Internal
            t : TIME, Internal
            a : ARRAY[1..3] OF INT, Internal
            type-mismatch: this is DINT, INT is expected here `d`
            type-mismatch: PI is a real number, the result is INT `PI`
            type-mismatch: a comparison gives BOOL, the result is INT `i > 2`
            bad-operand: there is no function `FOO` for expressions `FOO`
            bad-operand: MAX is written MAX(a, b, ...) `MAX(2)`
        "#]],
    );
}

#[test]
fn parentheses_after_no_function() {
    check(
        "VAR a : ARRAY[1..3] OF DINT; END_VAR\n+--[CALC]( y, (a[1]( 2 ) * 10) + 1 )--+\n+--[ ]( a.b( 2 ) )--( )( z )--+\n",
        expect![[r#"
            a : ARRAY[1..3] OF DINT, Internal
            y : DINT, Internal
            z : BOOL, Output
            bad-operand: parentheses belong after the name of a function only: this is none `a[1]( 2 )`
            bad-operand: parentheses belong after the name of a function only: this is none `a.b( 2 )`
        "#]],
    );
}

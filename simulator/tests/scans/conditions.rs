//! Contacts, edges, comparisons and coils.

use crate::support::check;
use expect_test::expect;

#[test]
fn contacts_on_ranges() {
    check(
        "VAR_INPUT p, q : BOOL; END_VAR\nVAR a : ARRAY[1..3] OF BOOL; all, none, s : BOOL; END_VAR\n\
         +--[ ]( p )--( )( a[1..2] )--+\n\
         +--[ ]( q )--( )( a[3] )--+\n\
         +--[ ]( a[1..3] )--( )( all )--+\n\
         +--[/]( a[1..3] )--( )( none )--+\n\
         +--[ ]( p )--(S)( a[2..3] )--( )( s )--+\n\
         +--[/]( q )--(R)( a[1..3] )--+\n",
        "p _-_-\nq __--",
        "all none s a[1] a[2] a[3]",
        expect![[r#"
            all   ___-
            none  -___
            s     _-_-
            a[1]  ___-
            a[2]  ___-
            a[3]  __--
        "#]],
    );
}

#[test]
fn edges_remember_whatever_en_is() {
    check(
        "VAR_INPUT en, a : BOOL; END_VAR\nVAR p, n, r, f, cp, cn : BOOL; END_VAR\n\
         +--[ ]( en )--[P]( a )--( )( p )--+\n\
         +--[ ]( en )--[N]( a )--( )( n )--+\n\
         +--[ ]( a )--[OSR]--( )( r )--+\n\
         +--[ ]( a )--[OSF]--( )( f )--+\n\
         +--[ ]( a )--(P)( cp )--(N)( cn )--+\n",
        "en --__--_--\na  -_-_-_---",
        "p n r f cp cn",
        expect![[r#"
            p   -___-____
            n   _-___-___
            r   -_-_-_-__
            f   _-_-_-___
            cp  -_-_-_-__
            cn  _-_-_-___
        "#]],
    );
}

#[test]
fn an_edge_is_a_difference_from_the_last_evaluation() {
    check(
        "VAR_INPUT a : BOOL; END_VAR\nVAR b : BOOL; n, m, k : INT; c : CTU; END_VAR\n\
         +--<FOR>( 3 )--+\n\
         +--[P]( a )--[ADD]( n, n, 1 )--+\n\
         +--[/]( b )--( )( b )--+\n\
         +--[P]( b )--[ADD]( m, m, 1 )--+\n\
         +--[ ]( b )--[OSF]--[ADD]( k, k, 1 )--+\n\
         +--[ ]( b )--[CTU]( c, 5 )--<NEXT>--+\n",
        "a _-_-",
        "n m k c.CV",
        expect![[r#"
            n     0 1 1 2
            m     2 3 5 6
            k     1 3 4 6
            c.CV  2 3 5 6
        "#]],
    );
}

#[test]
fn comparisons() {
    check(
        "VAR_INPUT a, b, c : INT; END_VAR\nVAR eq, ne, gt, ge, lt, le, chain : BOOL; END_VAR\n\
         +--[EQ]( a, b )--( )( eq )--+\n\
         +--[NE]( a, b )--( )( ne )--+\n\
         +--[GT]( a, b )--( )( gt )--+\n\
         +--[GE]( a, b )--( )( ge )--+\n\
         +--[LT]( a, b )--( )( lt )--+\n\
         +--[LE]( a, b )--( )( le )--+\n\
         +--[LT]( a, b, c )--( )( chain )--+\n",
        "a 1 2 2 -5\nb 1 1 3 4\nc 0 0 4 4",
        "eq ne gt ge lt le chain",
        expect![[r#"
            eq     -___
            ne     _---
            gt     _-__
            ge     --__
            lt     __--
            le     -_--
            chain  __-_
        "#]],
    );
}

#[test]
fn whole_numbers_compare_by_value() {
    check(
        "VAR u : ULINT := 16#FFFF_FFFF_FFFF_FFFF; l : LINT := -1; s : SINT := -1; w : UINT := 65535; END_VAR\n\
         VAR r : REAL := 1.5; d : DINT := 1; t : TIME := T#1s; x : STRING := 'ab'; p, q : BOOL := TRUE; END_VAR\n\
         VAR y1, y2, y3, y4, y5, y6, y7, y8 : BOOL; END_VAR\n\
         +--[GT]( u, l )--( )( y1 )--+\n\
         +--[EQ]( u, l )--( )( y2 )--+\n\
         +--[LT]( s, w )--( )( y3 )--+\n\
         +--[GT]( r, d )--( )( y4 )--+\n\
         +--[EQ]( t, T#1000ms )--( )( y5 )--+\n\
         +--[LT]( x, 'b' )--( )( y6 )--+\n\
         +--[EQ]( p, q )--( )( y7 )--+\n\
         +--[GT]( u, 5 )--( )( y8 )--+\n",
        "1",
        "y1 y2 y3 y4 y5 y6 y7 y8",
        expect![[r#"
            y1  -
            y2  _
            y3  -
            y4  -
            y5  -
            y6  -
            y7  -
            y8  -
        "#]],
    );
}

#[test]
fn coils_on_bits_and_elements() {
    check(
        "VAR_INPUT a : BOOL; i : INT := 1; END_VAR\n\
         VAR w : WORD; b : ARRAY[1..3] OF BOOL; d : ARRAY[0..1] OF SINT; y, z : BOOL; END_VAR\n\
         +--[ ]( a )--( )( w.3 )--(/)( w.4 )--(S)( w.15 )--( )( y )--+\n\
         +--[ ]( a )--( )( b[i] )--( )( z )--+\n\
         +--[ ]( b[i] )--(S)( d[1].7 )--(R)( d[1].0 )--+\n",
        "a _-_-\ni 1 2 3 4",
        "w y z b[1] b[2] b[3] d[1]",
        expect![[r#"
            w     16 32776 32784 32776
            y     _---
            z     _-__
            b[1]  ____
            b[2]  _---
            b[3]  ____
            d[1]  0 -128 -128 -128
            scan 3 at 202: index 4 is outside the array [1..3]: nothing was written; limit the index before this block
            scan 3 at 230: index 4 is outside the array [1..3]: nothing was written; limit the index before this block
        "#]],
    );
}

#[test]
fn a_contact_without_power_does_not_look_at_its_index() {
    check(
        "VAR_INPUT a : BOOL; i : INT; END_VAR\nVAR b : ARRAY[1..3] OF BOOL; END_VAR\n\
         +--[ ]( a )--[ ]( b[i] )--( )( y )--+\n",
        "a _-_\ni 0 0 2",
        "y",
        expect![[r#"
            y  ___
            scan 1 at 87: index 0 is outside the array [1..3]: nothing was written; limit the index before this block
        "#]],
    );
}

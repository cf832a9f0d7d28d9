//! User-defined blocks.

use crate::support::{check, get, set, simulation};
use expect_test::expect;

#[test]
fn each_place_has_a_state_of_its_own() {
    check(
        "FUNCTION_BLOCK [$Count]\n\
         VAR_INPUT limit : INT := 2; END_VAR\nVAR_OUTPUT n : INT; END_VAR\nVAR c : CTU; END_VAR\n\
         +--[ ]( EN )--[CTU]( c, 99 )--+\n\
         +--[TYP]( n, c.CV )--[GE]( n, limit )--( )( ENO )--+\n\
         +--[LT]( n, limit )--(R)( ENO )--+\n\
         END_FUNCTION_BLOCK\n\
         VAR_INPUT a, b : BOOL; END_VAR\nVAR x, y : INT; p, q : BOOL; END_VAR\n\
         +--[ ]( a )--[$Count]( n => x )--( )( p )--+\n\
         +--[ ]( b )--[$Count]( 1, y )--( )( q )--+\n",
        "a _-_-_-\nb __---_",
        "x y p q",
        expect![[r#"
            x  0 1 1 2 2 3
            y  0 0 1 1 1 1
            p  ___---
            q  __----
        "#]],
    );
}

#[test]
fn inputs_in_before_and_outputs_out_after_whatever_en_is() {
    check(
        "FUNCTION_BLOCK [$Copy]\n\
         VAR_INPUT i : INT := 7; END_VAR\nVAR_OUTPUT o : DINT; e : BOOL; END_VAR\n\
         +--[MOV]( o, i )--[ADD]( i, i, 1 )--+\n\
         +--[ ]( EN )--( )( e )--+\n\
         +--(S)( ENO )--+\n\
         END_FUNCTION_BLOCK\n\
         VAR_INPUT en : BOOL; v : INT; END_VAR\nVAR o1, o2 : LINT; e1, y : BOOL; END_VAR\n\
         +--[ ]( en )--[$Copy]( v, o1, e1 )--( )( y )--+\n\
         +--[$Copy]( o => o2 )--+\n",
        "en _-_\nv 1 2 3",
        "o1 o2 e1 y",
        expect![[r#"
            o1  1 2 3
            o2  7 7 7
            e1  _-_
            y   ---
        "#]],
    );
}

#[test]
fn in_outs_are_references() {
    check(
        "FUNCTION_BLOCK [$Bump]\n\
         VAR_IN_OUT n : INT; b : BOOL; t : TON; a : ARRAY[1..3] OF INT; END_VAR\n\
         +--[ADD]( n, n, 1 )--[ADD]( a[2], a[2], n )--+\n\
         +--[ ]( EN )--[TON]( t, T#20ms )--( )( b )--+\n\
         END_FUNCTION_BLOCK\n\
         VAR_INPUT i : INT := 1; END_VAR\n\
         VAR v : INT; w : WORD; t1, t2 : TON; arr : ARRAY[1..3] OF INT; f : ARRAY[0..1] OF BOOL; END_VAR\n\
         +--[$Bump]( v, w.3, t1, arr )--+\n\
         +--[$Bump]( arr[i], f[1], t2, arr )--+\n",
        "i 1 3 1 4",
        "v w t1.ET t2.Q arr[1] arr[2] arr[3] f[1]",
        expect![[r#"
            v       1 2 3 4
            w       0 0 8 8
            t1.ET   0 10 20 20
            t2.Q    __--
            arr[1]  1 1 2 2
            arr[2]  2 5 10 14
            arr[3]  0 1 1 1
            f[1]    __--
            scan 3 at 370: index 4 is outside the array [1..3]: nothing was written; limit the index before this block
        "#]],
    );
}

#[test]
fn blocks_inside_blocks() {
    check(
        "FUNCTION_BLOCK [$Edge]\nVAR n : INT; END_VAR\nVAR_OUTPUT count : INT; END_VAR\n\
         +--[ ]( EN )--[OSR]--[ADD]( n, n, 1 )--( )( ENO )--+\n\
         +--[MOV]( count, n )--+\n\
         END_FUNCTION_BLOCK\n\
         FUNCTION_BLOCK [$Two]\nVAR_INPUT a, b : BOOL; END_VAR\nVAR_OUTPUT sum : INT; END_VAR\nVAR x, y : INT; END_VAR\n\
         +--[ ]( a )--[$Edge]( x )--+\n\
         +--[ ]( b )--[$Edge]( y )--+\n\
         +--[ADD]( sum, x, y )--+\n\
         END_FUNCTION_BLOCK\n\
         VAR_INPUT p, q : BOOL; END_VAR\nVAR s1, s2 : INT; END_VAR\n\
         +--[$Two]( p, q, s1 )--[$Two]( q, q, s2 )--+\n",
        "p _-_-_\nq __--_",
        "s1 s2",
        expect![[r#"
            s1  0 1 2 3 3
            s2  0 0 2 2 2
        "#]],
    );
}

#[test]
fn return_ends_the_body_and_labels_are_its_own() {
    check(
        "FUNCTION_BLOCK ($Work)\nVAR_INPUT early, over : BOOL; END_VAR\nVAR_OUTPUT n : INT; END_VAR\n\
         +--[ADD]( n, n, 1 )--+\n\
         +--[ ]( early )--<RET>--[ADD]( n, n, 1000 )--+\n\
         +--[ ]( over )--<JMP>( there )--+\n\
         +--[ADD]( n, n, 10 )--+\n\
         +--<LBL>( there )--[ADD]( n, n, 100 )--+\n\
         END_FUNCTION_BLOCK\n\
         VAR_INPUT early, over : BOOL; END_VAR\nVAR n, m, k : INT; END_VAR\n\
         +--<FOR>( 2 )--+\n\
         +--($Work)( early, over, n )--[ADD]( m, m, 1 )--<NEXT>--+\n\
         +--<LBL>( there )--[ADD]( k, k, 1 )--+\n",
        "early _-_-\nover __--",
        "n m k",
        expect![[r#"
            n  222 224 426 428
            m  2 4 6 8
            k  1 2 3 4
        "#]],
    );
}

#[test]
fn a_loop_around_the_block_is_not_disturbed() {
    check(
        "FUNCTION_BLOCK [$Loop]\nVAR_OUTPUT n : INT; END_VAR\n\
         +--<FOR>( 3 )--+\n+--[ADD]( n, n, 1 )--<NEXT>--+\n\
         +--[GT]( n, 100 )--<JMP>( x )--+\n+--<LBL>( x )--+\n\
         END_FUNCTION_BLOCK\n\
         VAR n, m : INT; END_VAR\n\
         +--<FOR>( 4 )--[$Loop]( n )--+\n\
         +--[ADD]( m, m, 1 )--+\n\
         +--[$Loop]( n )--<NEXT>--+\n",
        "2",
        "n m",
        expect![[r#"
            n  12 24
            m  4 8
        "#]],
    );
}

#[test]
fn rails_are_live_in_a_body_and_the_outer_ones_come_back() {
    check(
        "FUNCTION_BLOCK [$B]\nVAR_OUTPUT first, second : BOOL; END_VAR\n\
         +--( )( first )--+\n+--[ ]( SYS.OFF )--<MCR>--+\n+--( )( second )--+\n\
         END_FUNCTION_BLOCK\n\
         VAR f, s, y, z : BOOL; END_VAR\n\
         +--[ ]( SYS.OFF )--<MCR>--+\n\
         +--[$B]( f, s )--+\n\
         +--( )( y )--+\n\
         +--<MCR>--+\n\
         +--[$B]( f, s )--+\n\
         +--( )( z )--+\n",
        "1",
        "f s y z",
        expect![[r#"
            f  -
            s  _
            y  _
            z  -
        "#]],
    );
}

const FLOW: &str = "FUNCTION_BLOCK <$Guard>\nVAR_INPUT what : INT; END_VAR\nVAR_OUTPUT seen : INT; END_VAR\n\
     +--[ADD]( seen, seen, 1 )--+\n\
     +--[EQ]( what, 1 )--<JMP>( out )--+\n\
     +--[EQ]( what, 2 )--<RET>--+\n\
     +--[EQ]( what, 3 )--<END>--+\n\
     +--[EQ]( what, 4 )--<JMP>( inside )--+\n\
     +--[ADD]( seen, seen, 10 )--+\n\
     +--<LBL>( inside )--+\n\
     END_FUNCTION_BLOCK\n";

#[test]
fn a_block_of_function_shape_acts_where_it_is() {
    let text = format!(
        "{FLOW}VAR_INPUT w : INT; END_VAR\nVAR s, a, b, c, f : INT; END_VAR\n\
         +--<$Guard>( w, s )--[ADD]( a, a, 1 )--+\n\
         +--[ADD]( b, b, 1 )--<CALL>( f )--[ADD]( f, f, 1 )--+\n\
         +--<LBL>( out )--[ADD]( c, c, 1 )--+\n\
         +--<FUN>( f )--[SUB]( f, f, 2 )--+\n"
    );
    check(
        &text,
        "w 0 1 2 4 3 0",
        "s a b c f",
        expect![[r#"
        s  11 12 13 14 15
        a  1 1 1 2 2
        b  1 1 1 2 2
        c  1 2 2 3 3
        f  -1 -1 -1 -2 -2
    "#]],
    );
}

#[test]
fn a_block_of_function_shape_returns_from_the_function_it_is_in() {
    let text = format!(
        "{FLOW}FUNCTION_BLOCK <$Outer>\nVAR_INPUT w : INT; END_VAR\nVAR_OUTPUT s, n : INT; END_VAR\n\
         +--[ADD]( n, n, 1 )--<$Guard>( w, s )--[ADD]( n, n, 10 )--+\n\
         END_FUNCTION_BLOCK\n\
         VAR_INPUT w : INT; END_VAR\nVAR s, n, a, b : INT; END_VAR\n\
         +--<CALL>( f )--[ADD]( a, a, 1 )--+\n\
         +--<FUN>( f )--<$Outer>( w, s, n )--[ADD]( b, b, 1 )--+\n\
         +--[ADD]( b, b, 10 )--+\n\
         +--<LBL>( out )--[ADD]( b, b, 100 )--+\n"
    );
    check(
        &text,
        "w 0 1 2 3 0",
        "s n a b",
        expect![[r#"
        s  11 12 13 14
        n  11 12 13 14
        a  1 2 3 3
        b  111 211 211 211
    "#]],
    );
}

#[test]
fn retentive_tags_of_a_body() {
    let mut simulation = simulation(
        "FUNCTION_BLOCK [$B]\nVAR RETAIN n : INT; END_VAR\nVAR m : INT; END_VAR\nVAR_OUTPUT x, y : INT; END_VAR\n\
         +--[ADD]( n, n, 1 )--[ADD]( m, m, 1 )--[MOV]( x, n )--[MOV]( y, m )--+\n\
         END_FUNCTION_BLOCK\n\
         VAR x1, y1, x2, y2 : INT; END_VAR\n\
         +--[$B]( x1, y1 )--[$B]( x2, y2 )--+\n",
    );
    simulation.scan();
    simulation.scan();
    simulation.warm_restart();
    simulation.scan();
    let values: Vec<String> = ["x1", "y1", "x2", "y2"]
        .iter()
        .map(|tag| get(&simulation, tag))
        .collect();
    assert_eq!(values, ["3", "1", "3", "1"]);
}

#[test]
fn a_fault_in_an_operand_keeps_the_body_from_running() {
    let mut simulation = simulation(
        "FUNCTION_BLOCK [$B]\nVAR_INPUT i : INT; END_VAR\nVAR_OUTPUT n : INT; END_VAR\n\
         +--[ADD]( n, n, 1 )--(S)( ENO )--+\nEND_FUNCTION_BLOCK\n\
         VAR_INPUT k : INT := 9; END_VAR\nVAR a : ARRAY[1..3] OF INT; n : INT; y : BOOL; END_VAR\n\
         +--[$B]( a[k], n )--( )( y )--+\n",
    );
    simulation.scan();
    assert_eq!(
        (get(&simulation, "n"), get(&simulation, "y")),
        ("0".into(), "0".into())
    );
    set(&mut simulation, "k", "3");
    simulation.scan();
    assert_eq!(
        (get(&simulation, "n"), get(&simulation, "y")),
        ("1".into(), "1".into())
    );
}

#[test]
fn parts_of_outputs_are_read_by_the_name_of_the_state() {
    check(
        "TYPE\nValve : STRUCT\nx : INT;\nEND_STRUCT;\n\
         Drive : STRUCT\nrun : BOOL;\nlist : ARRAY[1..3] OF INT;\nvalve : Valve;\nEND_STRUCT;\nEND_TYPE\n\
         FUNCTION_BLOCK [$Group]\n\
         VAR_INPUT start : BOOL; END_VAR\n\
         VAR_OUTPUT drive : Drive; many : ARRAY[0..1] OF Drive; flat : ARRAY[0..4] OF INT; ok : BOOL; END_VAR\n\
         +--[ ]( start )--( )( drive.run )--( )( ok )--+\n\
         +--[ADD]( drive.list[2], drive.list[2], 1 )--[MOV]( many[1].list[3], 7 )--+\n\
         +--[MOV]( flat[3], 9 )--[MOV]( drive.valve.x, 4 )--+\n\
         END_FUNCTION_BLOCK\n\
         VAR_INPUT go : BOOL; END_VAR\n\
         VAR g : ARRAY[1..3] OF $Group; one : $Group; k : INT := 3; a, b, c, d, e : INT; y, z : BOOL; END_VAR\n\
         +--[$Group]( g[2], start := go )--[$Group]( one, start := go )--+\n\
         +--[MOV]( a, one.drive.list[2] )--[MOV]( b, g[2].many[1].list[k] )--[MOV]( c, one.flat[k] )--+\n\
         +--[MOV]( d, g[k - 1].drive.valve.x )--[ADD]( e, one.drive.valve.x, g[2].flat[3] )--+\n\
         +--\\--[ ]( g[k - 1].drive.run )--( )( y )--\\--+\n\
         |  /--[ ]( g[2].ok )-------------( )( z )--/  |\n",
        "go _-_",
        "a b c d e y z",
        expect![[r#"
            a  1 2 3
            b  7 7 7
            c  9 9 9
            d  4 4 4
            e  13 13 13
            y  _-_
            z  _-_
        "#]],
    );
}

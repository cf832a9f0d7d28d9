//! Blocks that are not known, or not given what they take.

use crate::check::{check, clean};
use expect_test::expect;

#[test]
fn misspelt() {
    check("+--[TOM]( t, T#5s )--( )( y )--+\n", expect![[r#""#]]);
    check("+--[ ]( a )--(Q)( y )--+\n", expect![[r#""#]]);
    check("+--[XIC]( a )--(OTE)( y )--+\n", expect![[r#""#]]);
    check("+--[FROBNICATE]( a )--( )( y )--+\n", expect![[r#""#]]);
    check("+--[ ]( a )--<JPM>( x )--+\n\n+--<LBL>( x )--( )( y )--+\n", expect![[r#""#]]);
}

#[test]
fn the_tag_in_the_place_of_the_kind() {
    check("+--[start]--(run)--+\n", expect![[r#""#]]);
}

#[test]
fn wrong_brackets() {
    check("+--[ ]( a )--[SET]( run )--+\n", expect![[r#""#]]);
    check("+--[ ]( a )--[RESET]( run )--+\n", expect![[r#""#]]);
    check("+--[ ]( a )--<TON>( t, T#5s )--( )( y )--+\n", expect![[r#""#]]);
    check("+--[ ]( a )--(MOV)( y, 5 )--+\n", expect![[r#""#]]);
    check("+--[ ]( a )--[S]( y )--+\n", expect![[r#""#]]);
    check("+--< >( a )--( )( y )--+\n", expect![[r#""#]]);
}

#[test]
fn too_few_operands() {
    check("+--[TON]( t )--( )( y )--+\n", expect![[r#""#]]);
    check("+--[ ]--( )--+\n", expect![[r#""#]]);
    check("+--[ADD]( y )--+\n", expect![[r#""#]]);
    check("+--[TON]( t, R := r )--( )( y )--+\n", expect![[r#""#]]);
    check("+--[PWL]( y, x, 0, 0, 10 )--+\n", expect![[r#""#]]);
}

#[test]
fn too_many_operands() {
    check("+--[ ]( a, b )--( )( y )--+\n", expect![[r#""#]]);
    check("+--[TON]( t, T#5s, T#6s, x, R := r )--( )( y )--+\n", expect![[r#""#]]);
    check("+--[ ]( a )--<RET>( b )--+\n", expect![[r#""#]]);
}

#[test]
fn one_mistake_in_an_operand_list_is_told_once() {
    check("+--[TON]( t, )--( )( y )--+\n", expect![[r#""#]]);
    check("+--[ ]( a b )--( )( y )--+\n", expect![[r#""#]]);
    check("+--[MOV]( y, )--+\n", expect![[r#""#]]);
    check("+--[CALC]( y, a + )--+\n", expect![[r#""#]]);
}

#[test]
fn spellings_that_are_right() {
    clean("+--[ton]( t, T#5s )--[]( a )--()( y )--+\n");
    clean("+--[EQU]( a, 5 )--[NOT]--[R_TRIG]--(RES)( c )--[CTU]( c, 5 )--+\n");
}

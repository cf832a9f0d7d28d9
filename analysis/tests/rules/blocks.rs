//! Blocks that are not known, or not given what they take.

use crate::check::{check, clean};
use expect_test::expect;

#[test]
fn misspelt() {
    check(
        "+--[TOM]( t, T#5s )--( )( y )--+\n",
        expect![[r#"
            > +--[TOM]( t, T#5s )--( )( y )--+
                 ^^^^^ error[unknown-instruction]: there is no instruction [TOM]
                help: did you mean [TON] (on-delay timer)?
        "#]],
    );
    check(
        "+--[ ]( a )--(Q)( y )--+\n",
        expect![[r#"
            > +--[ ]( a )--(Q)( y )--+
                           ^^^ error[unknown-instruction]: there is no instruction (Q)
                help: a coil is ( ), (/), (S), (R), (P), (N), (M), (SM), (RM) or (RES)
        "#]],
    );
    check(
        "+--[XIC]( a )--(OTE)( y )--+\n",
        expect![[r#"
            > +--[XIC]( a )--(OTE)( y )--+
                 ^^^^^ error[unknown-instruction]: there is no [XIC]: the open contact is written [ ]
                help: it is written [ ]( tag )
                fix: Replace with [ ]
                  +--[ ]( a )--------------------------------------------------------(OTE)( y )--+
            > +--[XIC]( a )--(OTE)( y )--+
                             ^^^^^ error[unknown-instruction]: there is no (OTE): the coil is written ( )
                help: it is written ( )( tag )
                fix: Replace with ( )
                  +--------------------------------------------------------[XIC]( a )--( )( y )--+
        "#]],
    );
    check(
        "+--[FROBNICATE]( a )--( )( y )--+\n",
        expect![[r#"
            > +--[FROBNICATE]( a )--( )( y )--+
                 ^^^^^^^^^^^^ error[unknown-instruction]: there is no instruction [FROBNICATE]
                help: contacts are [ ] and [/]; the language reference lists all instructions
        "#]],
    );
    check(
        "+--[ ]( a )--<JPM>( x )--+\n\n+--<LBL>( x )--( )( y )--+\n",
        expect![[r#"
            > +--[ ]( a )--<JPM>( x )--+
                           ^^^^^ error[unknown-instruction]: there is no instruction <JPM>
                help: did you mean <JMP> (jump)?
                fix: Replace with <JMP>
                  +--[ ]( a )--------------------------------------------------------<JMP>( x )--+
        "#]],
    );
}

#[test]
fn the_tag_in_the_place_of_the_kind() {
    check(
        "+--[start]--(run)--+\n",
        expect![[r#"
            > +--[start]--(run)--+
                 ^^^^^^^ error[unknown-instruction]: there is no instruction [start]
                help: a contact of the tag `start` is written [ ]( start )
                fix: Write [ ]( start )
                  +--[ ]( start )---------------------------------------------------------(run)--+
            > +--[start]--(run)--+
                          ^^^^^ error[unknown-instruction]: there is no instruction (run)
                help: a coil of the tag `run` is written ( )( run )
                fix: Write ( )( run )
                  +---------------------------------------------------------[start]--( )( run )--+
        "#]],
    );
}

/// Whichever tags there are.
#[test]
fn a_word_that_may_be_an_instruction_or_a_tag() {
    check(
        "+--[ ]( TOM )--[TOM]--(RSE)--+\n",
        expect![[r#"
            > +--[ ]( TOM )--[TOM]--(RSE)--+
                             ^^^^^ error[unknown-instruction]: there is no instruction [TOM]
                help: a contact of the tag `TOM` is written [ ]( TOM )
                fix: Write [ ]( TOM )
                  +--[ ]( TOM )--[ ]( TOM )-----------------------------------------------(RSE)--+
            > +--[ ]( TOM )--[TOM]--(RSE)--+
                                    ^^^^^ error[unknown-instruction]: there is no instruction (RSE)
                help: a coil of the tag `RSE` is written ( )( RSE )
                fix: Write ( )( RSE )
                  +--[ ]( TOM )-----------------------------------------------[TOM]--( )( RSE )--+
        "#]],
    );
}

#[test]
fn wrong_brackets() {
    check(
        "+--[ ]( a )--[SET]( run )--+\n",
        expect![[r#"
            > +--[ ]( a )--[SET]( run )--+
                           ^^^^^ error[wrong-shape]: [SET]( run ) is not [MOV]( y, a )
                help: to latch a bit write (S)( run )
                fix: Replace with (S)
                  +--[ ]( a )--------------------------------------------------------(S)( run )--+
        "#]],
    );
    check(
        "+--[ ]( a )--[RESET]( run )--+\n",
        expect![[r#"
            > +--[ ]( a )--[RESET]( run )--+
                           ^^^^^^^ error[wrong-shape]: there is no [RESET]: the reset coil is written (R)
                help: to reset a bit write (R)( run )
                safe fix: Replace with (R)
                  +--[ ]( a )--------------------------------------------------------(R)( run )--+
        "#]],
    );
    check(
        "+--[ ]( a )--<TON>( t, T#5s )--( )( y )--+\n",
        expect![[r#"
            > +--[ ]( a )--<TON>( t, T#5s )--( )( y )--+
                           ^^^^^ error[wrong-shape]: there is no <TON>: the on-delay timer is written [TON]
                help: write [TON]( t, T#5s )
                safe fix: Replace with [TON]
                  +--[ ]( a )----------------------------------------[TON]( t, T#5s )--( )( y )--+
        "#]],
    );
    check(
        "+--[ ]( a )--(MOV)( y, 5 )--+\n",
        expect![[r#"
            > +--[ ]( a )--(MOV)( y, 5 )--+
                           ^^^^^ error[wrong-shape]: there is no (MOV): the move is written [MOV]
                help: write [MOV]( y, 5 )
                safe fix: Replace with [MOV]
                  +--[ ]( a )-----------------------------------------------------[MOV]( y, 5 )--+
        "#]],
    );
    check(
        "+--[ ]( a )--[S]( y )--+\n",
        expect![[r#"
            > +--[ ]( a )--[S]( y )--+
                           ^^^ error[wrong-shape]: there is no [S]: the set coil is written (S)
                help: to latch a bit write (S)( y )
                fix: Replace with (S)
                  +--[ ]( a )----------------------------------------------------------(S)( y )--+
        "#]],
    );
    check(
        "+--< >( a )--( )( y )--+\n",
        expect![[r#"
            > +--< >( a )--( )( y )--+
                 ^^^ error[wrong-shape]: there is no < >: the open contact is written [ ]
                help: to test a bit write [ ]( a )
                fix: Replace with [ ]
                  +--[ ]( a )----------------------------------------------------------( )( y )--+
        "#]],
    );
}

#[test]
fn too_few_operands() {
    check(
        "+--[TON]( t )--( )( y )--+\n",
        expect![[r#"
            > +--[TON]( t )--( )( y )--+
                 ^^^^^^^^^^ error[bad-arity]: [TON] takes 2 operands, 1 is given
                help: it is written [TON]( t, PT, R := )
                fix: Add PT
                  +--------------------------------------------------[TON]( t, T#1s )--( )( y )--+
        "#]],
    );
    check(
        "+--[ ]--( )--+\n",
        expect![[r#"
            > +--[ ]--( )--+
                 ^^^ error[bad-arity]: [ ] takes 1 operand, none is given
                help: it is written [ ]( tag )
                fix: Add tag
                  +--[ ]( ? )--( )--+
            > +--[ ]--( )--+
                      ^^^ error[bad-arity]: ( ) takes 1 operand, none is given
                help: it is written ( )( tag )
                fix: Add tag
                  +--[ ]--( )( ? )--+
        "#]],
    );
    check(
        "+--[ADD]( y )--+\n",
        expect![[r#"
            > +--[ADD]( y )--+
                 ^^^^^^^^^^ error[bad-arity]: [ADD] takes at least 3 operands, 1 is given
                help: it is written [ADD]( y, a, b, ... )
                fix: Add a and b
                  +--[ADD]( y, ?, ? )--+
        "#]],
    );
    check(
        "+--[TON]( t, R := r )--( )( y )--+\n",
        expect![[r#"
            > +--[TON]( t, R := r )--( )( y )--+
                 ^^^^^^^^^^^^^^^^^^ error[bad-arity]: [TON] takes 2 operands, 1 is given
                help: it is written [TON]( t, PT, R := )
                fix: Add PT
                  +------------------------------------------[TON]( t, T#1s, R := r )--( )( y )--+
        "#]],
    );
    check(
        "+--[PWL]( y, x, 0, 0, 10 )--+\n",
        expect![[r#"
            > +--[PWL]( y, x, 0, 0, 10 )--+
                 ^^^^^^^^^^^^^^^^^^^^^^^ error[bad-arity]: [PWL] takes at least 6 operands, 5 are given
                help: it is written [PWL]( y, x, x0, y0, x1, y1, ... )
                fix: Add y1
                  +--[PWL]( y, x, 0, 0, 10, ? )--+
        "#]],
    );
}

#[test]
fn too_many_operands() {
    check(
        "+--[ ]( a, b )--( )( y )--+\n",
        expect![[r#"
            > +--[ ]( a, b )--( )( y )--+
                         ^ error[bad-arity]: [ ] takes 1 operand, 2 are given
                help: it is written [ ]( tag )
        "#]],
    );
    check(
        "+--[TON]( t, T#5s, T#6s, x, R := r )--( )( y )--+\n",
        expect![[r#"
            > +--[TON]( t, T#5s, T#6s, x, R := r )--( )( y )--+
                                 ^^^^^^^ error[bad-arity]: [TON] takes 2 operands, 4 are given
                help: it is written [TON]( t, PT, R := )
        "#]],
    );
    check(
        "+--[ ]( a )--<RET>( b )--+\n",
        expect![[r#"
            > +--[ ]( a )--<RET>( b )--+
                                  ^ error[bad-arity]: <RET> takes no operands, 1 is given
                help: it is written <RET>
        "#]],
    );
}

#[test]
fn one_error_in_an_operand_list_is_reported_once() {
    check(
        "+--[TON]( t, )--( )( y )--+\n",
        expect![[r#"
            > +--[TON]( t, )--( )( y )--+
                           ^ error[bad-operand]: an operand is missing here
                help: write the operand, or take the comma away
        "#]],
    );
    check(
        "+--[ ]( a b )--( )( y )--+\n",
        expect![[r#"
            > +--[ ]( a b )--( )( y )--+
                        ^ error[bad-operand]: a comma is missing before this operand
                help: operands are separated by commas
        "#]],
    );
    check(
        "+--[MOV]( y, )--+\n",
        expect![[r#"
            > +--[MOV]( y, )--+
                           ^ error[bad-operand]: an operand is missing here
                help: write the operand, or take the comma away
        "#]],
    );
    check(
        "+--[CALC]( y, a + )--+\n",
        expect![[r#"
            > +--[CALC]( y, a + )--+
                                ^ error[bad-operand]: a value is missing next to this operator
        "#]],
    );
}

#[test]
fn spellings_that_are_right() {
    clean("+--[ton]( t, T#5s )--[]( a )--()( y )--+\n");
    clean("+--[EQU]( a, 5 )--[NOT]--[R_TRIG]--(RES)( c )--[CTU]( c, 5 )--+\n");
}

#[test]
fn durations_and_points_in_time() {
    check(
        "VAR d : TOD; t : TIME; END_VAR\n+--[TYP]( t, d )--+\n",
        expect![[r#"
            > +--[TYP]( t, d )--+
                           ^ error[type-mismatch]: TOD cannot be converted into TIME
                help: a DT converts to its DATE and its TOD, a DATE to a DT; a TIME is the difference of two TODs or two DTs, [SUB]( time, later, earlier )
        "#]],
    );
    clean(
        "VAR d : DATE; c : TOD; x : DT; s : STRING; END_VAR\n+--[TYP]( d, x )--[TYP]( c, x )--[TYP]( x, d )--[TYP]( s, c )--+\n",
    );
    // The left side is a TIME, however many numbers it is divided by.
    clean("VAR t, u : TIME; n : DINT; END_VAR\n+--[CALC]( t, u / n / n * 2 )--[CALC]( u, 3 * (t * n) )--+\n");
}

#[test]
fn texts_of_any_length_compare() {
    clean(
        "VAR s : STRING; y : BOOL; END_VAR\n+--[EQ]( s, 'a', 'text' )--( )( y )--+\n+--[NE]( 'a', s )--(R)( y )--+\n",
    );
}

#[test]
fn operands_in_each_others_place() {
    check(
        r"FUNCTION_BLOCK [$A]
VAR_INPUT   first : INT;  END_VAR
VAR_OUTPUT  lamp : BOOL;  END_VAR
+--[GT]( first, 3 )--( )( lamp )--+
END_FUNCTION_BLOCK

FUNCTION_BLOCK [$C]
VAR_INPUT   first : INT;  on : BOOL;  wait : TIME;  END_VAR
VAR_OUTPUT  lamp : BOOL;  END_VAR
VAR         t : TON;  END_VAR
+--[GT]( first, 3 )--[ ]( on )--[TON]( t, wait )--( )( lamp )--+
END_FUNCTION_BLOCK

VAR  n : INT;  b, c : BOOL;  t : TIME;  t1 : TON;  END_VAR

+--[$A]( b, n )--+

+--[$C]( TRUE, 3, t, c )--+

+--[$C]( n, t, b, c )--+

+--[$C]( b, c, t, n )--+

+--[TON]( 5s, t1 )--( )( c )--+

+--[MOV]( 3, n )--( )( b )--+

+--[SEL]( n, n, 3, 4 )--(S)( c )--+
",
        expect![[r#"
            > +--[$A]( b, n )--+
                       ^^^^ error[type-mismatch]: `b` and `n` are swapped
                help: `first` of [$A] comes before `lamp`
                fix: Swap `b` and `n`
                  +----------------------------------------------------------------[$A]( n, b )--+
            > +--[$C]( TRUE, 3, t, c )--+
                       ^^^^^^^ error[type-mismatch]: `TRUE` and `3` are swapped
                help: `first` of [$C] comes before `on`
                fix: Swap `TRUE` and `3`
                  +-------------------------------------------------------[$C]( 3, TRUE, t, c )--+
            > +--[$C]( n, t, b, c )--+
                          ^^^^ error[type-mismatch]: `t` and `b` are swapped
                help: `on` of [$C] comes before `wait`
                fix: Swap `t` and `b`
                  +----------------------------------------------------------[$C]( n, b, t, c )--+
            > +--[$C]( b, c, t, n )--+
                       ^^^^^^^^^^ error[type-mismatch]: `b` and `n` are swapped
                help: `first` of [$C] comes before `lamp`
                fix: Swap `b` and `n`
                  +----------------------------------------------------------[$C]( n, c, t, b )--+
            > +--[TON]( 5s, t1 )--( )( c )--+
                        ^^^^^^ error[bad-operand]: `5s` and `t1` are swapped
                help: the tag that keeps the state of the TON comes first
                fix: Swap `5s` and `t1`
                  +---------------------------------------------------[TON]( t1, 5s )--( )( c )--+
            > +--[MOV]( 3, n )--( )( b )--+
                        ^^^^ error[bad-operand]: `3` and `n` are swapped
                help: the result comes first
                fix: Swap `3` and `n`
                  +-----------------------------------------------------[MOV]( n, 3 )--( )( b )--+
            > +--[SEL]( n, n, 3, 4 )--(S)( c )--+
                           ^ error[type-mismatch]: `n` is INT, and `g` of [SEL] takes BOOL
                help: compare it ([NE]( tag, 0 )), or name one of its bits (tag.0)
        "#]],
    );
}

#[test]
fn a_loop_with_a_counter() {
    check(
        "+--[FOR]( i, 1, 3 )--+\n+--<NEXT>--+\n\n+--<FOR>( i, 0, n )--+\n+--<NEXT>--+\n\n+--<FOR>( i, 1, n )--+\n+--<NEXT>--+\n",
        expect![[r#"
            > +--[FOR]( i, 1, 3 )--+
                 ^^^^^^^^^^^^^^^^ error[wrong-shape]: a loop takes how many times it runs: write <FOR>( 3, I => i )
                help: `i` is then the number of the turn, from 1
                fix: Write <FOR>( 3, I => i )
                  +----------------------------------------------------------<FOR>( 3, I => i )--+
            > +--<FOR>( i, 0, n )--+
                 ^^^^^^^^^^^^^^^^ error[wrong-shape]: a loop takes how many times it runs: write <FOR>( turns, I => i )
                help: `i` is then the number of the turn, from 1
                fix: Write <FOR>( turns, I => i )
                  +------------------------------------------------------<FOR>( turns, I => i )--+
            > +--<FOR>( i, 1, n )--+
                 ^^^^^^^^^^^^^^^^ error[wrong-shape]: a loop takes how many times it runs: write <FOR>( n, I => i )
                help: `i` is then the number of the turn, from 1
                fix: Write <FOR>( n, I => i )
                  +----------------------------------------------------------<FOR>( n, I => i )--+
        "#]],
    );
}

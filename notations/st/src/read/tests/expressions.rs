//! Assignments, numbers, conversions and functions.

use super::check;
use crate::read::dialect::Dialect;
use expect_test::expect;

#[test]
fn assignments() {
    check(
        "a := b AND NOT c OR d; i := j; i := j + 1; r := s / 3.0; a := TRUE;",
        Dialect::Iec,
        &expect![[r#"
        +-----------------------------------------------[CALC]( a, b AND NOT c OR d )--+
        +---------------------------------------------------------------[MOV]( i, j )--+
        +----------------------------------------------------------[CALC]( i, j + 1 )--+
        +--------------------------------------------------------[CALC]( r, s / 3.0 )--+
        +------------------------------------------------------------[MOV]( a, TRUE )--+
    "#]],
    );
}

#[test]
fn a_bool_that_is_assigned_once_is_a_coil() {
    check(
        "a := b AND NOT (c OR i > 3);",
        Dialect::Iec,
        &expect![[r#"
        # a := b AND NOT (c OR i > 3) #
        +--[ ]( b )--[/]( c )--[LE]( i, 3 )----------------------------------( )( a )--+
    "#]],
    );
    check(
        "a := (b XOR c) = d; b := i / j > 3;",
        Dialect::Iec,
        &expect![[r#"
        VAR
            st1 : DINT;
        END_VAR

        +--------------------------------------------------[CALC]( a, (b XOR c) = d )--+

        # b := i / j > 3 #
        +----------------------------------[CALC]( st1, i / j )--[CALC]( b, st1 > 3 )--+
    "#]],
    );
}

#[test]
fn integers_are_exact_and_cut_where_they_are_assigned() {
    check(
        "i := (j + k) / 2; a := i + j = k; a := i MOD 2 = 1; u := i * j; i := u;",
        Dialect::Iec,
        &expect![[r#"
            VAR
                st1 : DINT;
                st2 : DINT;
            END_VAR

            # i := (j + k) / 2 #
            +--------------[CALC]( st1, j + k )--[CALC]( st2, st1 / 2 )--[WRAP]( i, st2 )--+

            # a := i + j = k #
            +----------------------------------[CALC]( st2, i + j )--[CALC]( a, st2 = k )--+
            +----------------------------------------------------[CALC]( a, i MOD 2 = 1 )--+
            +----------------------------------------------------------[CALC]( u, i * j )--+
            +--------------------------------------------------------------[WRAP]( i, u )--+
        "#]],
    );
    check(
        "i := (j + k) / 2; u := i * j;",
        Dialect::Scl,
        &expect![[r#"
        +----------------------------------------------------[CALC]( i, (j + k) / 2 )--+
        +----------------------------------------------------------[CALC]( u, i * j )--+
    "#]],
    );
    check(
        "r := i / j + 0.5; r := i * 1.5; a := i > 1.5; i := -32768; w := w AND 16#FF; u := i + 100000;",
        Dialect::Iec,
        &expect![[r#"
        VAR
            st1 : DINT;
            st2 : LREAL;
        END_VAR

        # r := i / j + 0.5 #
        +-------------[CALC]( st1, i / j )--[CALC]( st2, st1 + 0.5 )--[TYP]( r, st2 )--+
        +--------------------------------------------------------[CALC]( r, i * 1.5 )--+

        # a := i > 1.5 #
        +-------------------------------------[MOV]( st2, i )--[CALC]( a, st2 > 1.5 )--+
        +----------------------------------------------------------[MOV]( i, -32768 )--+
        +----------------------------------------------------[CALC]( w, w AND 16#FF )--+

        # u := i + 100000 #
        +----------------------------------[MOV]( st1, i )--[CALC]( u, st1 + 100000 )--+
    "#]],
    );
}

#[test]
fn conversions() {
    check(
        "i := DINT_TO_INT(u); u := INT_TO_DINT(i) * j; r := INT_TO_REAL(i) / 2.0; i := REAL_TO_INT(r); \
         i := TRUNC(r); a := INT_TO_BOOL(i); i := WORD_TO_INT(w); u := TIME_TO_DINT(p);",
        Dialect::Iec,
        &expect![[r#"
            VAR
                st2 : REAL;
                st3 : LINT;
                st4 : DINT;
            END_VAR

            +--------------------------------------------------------------[WRAP]( i, u )--+
            +----------------------------------------------------------[CALC]( u, i * j )--+

            # r := INT_TO_REAL(i) / 2.0 #
            +-------------------------------------[TYP]( st2, i )--[CALC]( r, st2 / 2.0 )--+

            # i := REAL_TO_INT(r) #
            +-------------------------------------------[TYP]( st3, r )--[WRAP]( i, st3 )--+

            # i := TRUNC(r) #
            +---------------------[TRUNC]( st3, r )--[WRAP]( st4, st3 )--[WRAP]( i, st4 )--+
            +---------------------------------------------------------[CALC]( a, i <> 0 )--+
            +--------------------------------------------------------------[WRAP]( i, w )--+
            +---------------------------------------------------------------[TYP]( u, p )--+
        "#]],
    );
}

#[test]
fn functions_are_instructions() {
    check(
        "i := MIN(j, k, 3); w := SHL(w, 3) OR 16#1; r := SEL(a, 1.5, LIMIT(0.0, s, 10.0)); i := SEL(G := a, IN0 := j, IN1 := k); \
         a := GT(i, j); r := SQRT(s); i := ADD(i, j, k); r := r ** 2.0;",
        Dialect::Iec,
        &expect![[r#"
            VAR
                st2 : WORD;
                st3 : REAL;
            END_VAR

            +---------------------------------------------------------[MIN]( i, j, k, 3 )--+

            # w := SHL(w, 3) OR 16|1 #
            +--------------------------------[SHL]( st2, w, 3 )--[CALC]( w, st2 OR 16#1 )--+

            # r := SEL(a, 1.5, LIMIT(0.0, s, 10.0)) #
            +-----------------------[LIMIT]( st3, 0.0, s, 10.0 )--[SEL]( r, a, 1.5, st3 )--+
            +---------------------------------------------------------[SEL]( i, a, j, k )--+
            +----------------------------------------------------------[CALC]( a, i > j )--+
            +--------------------------------------------------------------[SQRT]( r, s )--+
            +------------------------------------------------------[CALC]( i, i + j + k )--+
            +--------------------------------------------------------[CALC]( r, r ^ 2.0 )--+
        "#]],
    );
}

#[test]
fn right_sides_that_may_fault_are_not_always_reached() {
    check(
        "a := i <> 0 AND j / i > 3;",
        Dialect::Iec,
        &expect![[r#"
        VAR
            st1 : BOOL;
            st2 : DINT;
        END_VAR

        +--[CALC]( st1, i <> 0 )--[/]( st1 )-------------------------<JMP>( enough1 )--+
        +--------------------------------[CALC]( st2, j / i )--[CALC]( st1, st2 > 3 )--+
        +--<LBL>( enough1 )-------------------------------------------[MOV]( a, st1 )--+
    "#]],
    );
    check(
        "IF a OR_ELSE x[i] > 3 THEN j := 1; END_IF;",
        Dialect::Codesys,
        &expect![[r#"
        VAR
            st1 : BOOL;
        END_VAR

        +--[CALC]( st1, a )--[ ]( st1 )------------------------------<JMP>( enough1 )--+
        +-----------------------------------------------------[CALC]( st1, x[i] > 3 )--+

        # IF a OR_ELSE x[i] > 3 THEN j := 1; END_IF #
        +--<LBL>( enough1 )--[ ]( st1 )---------------------------------[MOV]( j, 1 )--+
    "#]],
    );
}

#[test]
fn timers_counters_and_edges() {
    check(
        "t(IN := a AND b, PT := T#5s, Q => c); p := t.ET; z(CU := a, R := b, PV := 10); i := z.CV;",
        Dialect::Iec,
        &expect![[r#"
            +--[ ]( a )--[ ]( b )------------------------------[TON]( t, T#5s )--( )( c )--+
            +------------------------------------------------------------[MOV]( p, t.ET )--+
            +--[ ]( a )--------------------------------------------[CTU]( z, 10, R := b )--+
            +-----------------------------------------------------------[WRAP]( i, z.CV )--+
        "#]],
    );
    check(
        "t(IN := a, PT := T#5s); t(IN := b);",
        Dialect::Iec,
        &expect![[r#"
        +--[ ]( a )--------------------------------------------------[TON]( t, T#5s )--+

        # ladder: allow(duplicate-timer): several calls of t #
        +--[ ]( b )--------------------------------------------------[TON]( t, t.PT )--+
    "#]],
    );
    check(
        "t.PT := T#3s; t(IN := a); p := t.PT;",
        Dialect::Iec,
        &expect![[r#"
        VAR
            t_PT : TIME;
        END_VAR

        +---------------------------------------------------------[MOV]( t_PT, T#3s )--+
        +--[ ]( a )--------------------------------------------------[TON]( t, t_PT )--+
        +------------------------------------------------------------[MOV]( p, t_PT )--+
    "#]],
    );
    check(
        "e(CLK := a OR b); IF e.Q THEN i := i + 1; END_IF; f(CLK := a); c := f.Q;",
        Dialect::Iec,
        &expect![[r#"
        +--\--[ ]( a )--\--[OSR]---------------------------------------------( )( e )--+
        |  /--[ ]( b )--/                                                              |

        # IF e.Q THEN i := i + 1; END_IF #
        +--[ ]( e )------------------------------------------------[CALC]( i, i + 1 )--+
        +--[/]( a )--[OSR]---------------------------------------------------( )( f )--+
        +--[ ]( f )----------------------------------------------------------( )( c )--+
    "#]],
    );
    check(
        "IF a THEN e(CLK := b); ELSE e(CLK := c, Q => d); END_IF;",
        Dialect::Iec,
        &expect![[r#"
        VAR
            e_M : BOOL;
        END_VAR

        # IF a THEN #
        +--[/]( a )----------------------------------------------------<JMP>( else1 )--+
        +---------------------------------[CALC]( e, b AND NOT e_M )--[MOV]( e_M, b )--+
        +-------------------------------------------------------------<JMP>( endif1 )--+

        # ELSE #
        +--<LBL>( else1 )-----------------[CALC]( e, c AND NOT e_M )--[MOV]( e_M, c )--+
        +---------------------------------------------------------------[MOV]( d, e )--+
        +--<LBL>( endif1 )-------------------------------------------------------------+
    "#]],
    );
}

#[test]
fn inputs_of_functions_by_their_names_and_numbers_of_bits() {
    check(
        "w := MIN(w, WORD#16#10);\ni := LIMIT(MX := j, IN := k, MN := 1);\ni := MAX(IN1 := i, IN2 := j, IN3 := k);\n\
         i := FIND(STR1 := 'ab', STR2 := 'b');\ni := LEN(STR := 'ab');\ni := FIND(STR1 := 'ab', 'b');\ni := MAX(IN1 := i, IN3 := k);\ni := LEN(TEXT := 'ab');",
        Dialect::Codesys,
        &expect![[r#"
            # line 7 of Main: `MAX` has other inputs; it is not run here. #
            FUNCTION_BLOCK [$line_7_of_Main]
            # ladder: unread #
            # i := MAX(IN1 := i, IN3 := k) #
            END_FUNCTION_BLOCK

            # line 8 of Main: `LEN` has other inputs; it is not run here. #
            FUNCTION_BLOCK [$line_8_of_Main]
            # ladder: unread #
            # i := LEN(TEXT := 'ab') #
            END_FUNCTION_BLOCK
            VAR
                st1 : UINT;
                st2 : UINT;
                st3 : UINT;
            END_VAR

            # w := MIN(w, 16|10) #
            +-------------------[MOV]( st1, w )--[MOV]( st2, 16#10 )--[MIN]( st3, st1, st2 )--[MOV]( w, st3 )--+
            +-------------------------------------------------------[LIMIT]( i, 1, k, j )--+
            +---------------------------------------------------------[MAX]( i, i, j, k )--+
            +------------------------------------------------------[FIND]( i, 'ab', 'b' )--+
            +------------------------------------------------------------[LEN]( i, 'ab' )--+
            +------------------------------------------------------[FIND]( i, 'ab', 'b' )--+
            +-----------------------------------------------------------[$line_7_of_Main]--+
            +-----------------------------------------------------------[$line_8_of_Main]--+
        "#]],
    );
}

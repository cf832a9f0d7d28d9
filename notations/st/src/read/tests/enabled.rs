//! Calls with `EN` and `ENO`.

use super::{check, check_file};
use crate::read::dialect::Dialect;
use expect_test::expect;

#[test]
fn functions_run_with_power() {
    check(
        "i := ADD(EN := a, IN1 := j, IN2 := k, ENO => b); u := MUL(EN := a OR c, IN1 := u, IN2 := v) + 1;",
        Dialect::Iec,
        &expect![[r#"
            VAR
                st1 : DINT;
            END_VAR

            # i := ADD(EN := a, IN1 := j, IN2 := k, ENO => b) #
            +--[MOV]( i, 0 )--[ ]( a )-----------------------[CALC]( i, j + k )--( )( b )--+
            +--[MOV]( st1, 0 )--\--[ ]( a )--\-----------------------[CALC]( st1, u * v )--+
            |                   /--[ ]( c )--/                                             |
            +--------------------------------------------------------[CALC]( u, st1 + 1 )--+
        "#]],
    );
    check(
        "i := MAX(j, k, ENO => b); IF a THEN i := MAX(EN := c, IN1 := j, IN2 := k, ENO => d); END_IF; d := a;",
        Dialect::Iec,
        &expect![[r#"
            # i := MAX(j, k, ENO => b) #
            +--------------------------------------------------[MAX]( i, j, k )--( )( b )--+

            # IF a THEN #
            +--[/]( a )---------------------------------------------------<JMP>( endif1 )--+

            # i := MAX(EN := c, IN1 := j, IN2 := k, ENO => d) #
            +--[MOV]( i, 0 )--[MOV]( d, FALSE )--[ ]( c )------------------[MAX]( i, j, k )--[MOV]( d, TRUE )--+
            +--<LBL>( endif1 )----------------------------------------------[MOV]( d, a )--+
        "#]],
    );
}

#[test]
fn what_is_of_the_user_is_jumped_over() {
    check_file(
        "FUNCTION Twice : INT VAR_INPUT v : INT; END_VAR Twice := v * 2; END_FUNCTION
FUNCTION_BLOCK Count VAR_INPUT by1 : INT; END_VAR VAR_OUTPUT sum : INT; END_VAR VAR_IN_OUT all : INT; END_VAR
    sum := sum + by1; all := all + 1;
END_FUNCTION_BLOCK
PROGRAM Main VAR go, done : BOOL; n, m : INT; c : Count; END_VAR
    n := Twice(EN := go, v := m);
    c(EN := go, by1 := n, all := m, sum => n, ENO => done);
    Twice(EN := done, v := n);
END_PROGRAM
",
        &expect![[r#"
            FUNCTION_BLOCK [$Twice]
            VAR_INPUT
                v : INT;
            END_VAR
            VAR_OUTPUT
                Twice : INT;  # what the function returns #
            END_VAR

            +------------------------------------------------------[CALC]( Twice, v * 2 )--+
            END_FUNCTION_BLOCK

            FUNCTION_BLOCK [$Count]
            VAR_INPUT
                by1 : INT;
            END_VAR
            VAR_OUTPUT
                sum : INT;
            END_VAR
            VAR_IN_OUT
                all : INT;
            END_VAR

            +----------------------------------------------------[CALC]( sum, sum + by1 )--+
            +------------------------------------------------------[CALC]( all, all + 1 )--+
            END_FUNCTION_BLOCK

            VAR
                go   : BOOL;
                done : BOOL;
                n    : INT;
                m    : INT;
                c    : $Count;
            END_VAR

            # n := Twice(EN := go, v := m) #
            +---------------------------------------------------------------[MOV]( n, 0 )--+
            +--[/]( go )------------------------------------------------<JMP>( endcall1 )--+
            +----------------------------------------------[$Twice]( v := m, Twice => n )--+
            +--<LBL>( endcall1 )----------------------------------------[MOV]( c.by1, n )--+
            +--------------------------------------------------------[MOV]( done, FALSE )--+
            +--[/]( go )------------------------------------------------<JMP>( endcall2 )--+
            +--------------------------------[$Count]( c, all := m )--[MOV]( done, TRUE )--+
            +--<LBL>( endcall2 )----------------------------------------[MOV]( n, c.sum )--+
            +--[/]( done )----------------------------------------------<JMP>( endcall3 )--+
            +----------------------------------------------------------[$Twice]( v := n )--+
            +--<LBL>( endcall3 )-----------------------------------------------------------+
        "#]],
    );
}

#[test]
fn what_is_not_read() {
    check(
        "i := ADD(EN := a, IN1 := j, IN2 := k, ENO => i); i := ADD(IN1 := j, IN2 := k, NOT ENO => a); t(EN := a, IN := b, PT := p); e(EN := a, CLK := b);",
        Dialect::Iec,
        &expect![[r#"
            # line 1 of Main: `i` is not a BOOL; it is not run here. #
            FUNCTION_BLOCK [$line_1_of_Main]
            # ladder: unread #
            # i := ADD(EN := a, IN1 := j, IN2 := k, ENO => i) #
            END_FUNCTION_BLOCK

            # line 1 of Main: ENO goes into a tag, and not negated; it is not run here. #
            FUNCTION_BLOCK [$line_1_of_Main2]
            # ladder: unread #
            # i := ADD(IN1 := j, IN2 := k, NOT ENO => a) #
            END_FUNCTION_BLOCK

            # line 1 of Main: a call of `t` with EN or ENO is not read: use IF; it is not run here. #
            FUNCTION_BLOCK [$line_1_of_Main3]
            # ladder: unread #
            # t(EN := a, IN := b, PT := p) #
            END_FUNCTION_BLOCK

            # line 1 of Main: a call of `e` with EN or ENO is not read: use IF; it is not run here. #
            FUNCTION_BLOCK [$line_1_of_Main4]
            # ladder: unread #
            # e(EN := a, CLK := b) #
            END_FUNCTION_BLOCK

            +-----------------------------------------------------------[$line_1_of_Main]--+
            +----------------------------------------------------------[$line_1_of_Main2]--+
            +----------------------------------------------------------[$line_1_of_Main3]--+
            +----------------------------------------------------------[$line_1_of_Main4]--+
        "#]],
    );
    check(
        "#i := ADD(EN := #a, IN1 := #j, IN2 := #k);",
        Dialect::Scl,
        &expect![[r#"
        # line 1 of Main: a call with EN or ENO is not read: use IF; it is not run here. #
        FUNCTION_BLOCK [$line_1_of_Main]
        # ladder: unread #
        # \hi := ADD(EN := \ha, IN1 := \hj, IN2 := \hk) #
        END_FUNCTION_BLOCK

        +-----------------------------------------------------------[$line_1_of_Main]--+
    "#]],
    );
}

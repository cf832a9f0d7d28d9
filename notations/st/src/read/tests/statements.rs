//! Branches, cases and loops, and what has no counterpart.

use super::check;
use crate::read::dialect::Dialect;
use expect_test::expect;

#[test]
fn branches() {
    check(
        "IF a THEN i := 1; END_IF; IF b THEN a := TRUE; END_IF; IF a AND i > 3 THEN i := 1; j := 2; END_IF;",
        Dialect::Iec,
        &expect![[r#"
        # IF a THEN i := 1; END_IF #
        +--[ ]( a )-----------------------------------------------------[MOV]( i, 1 )--+

        # IF b THEN a := TRUE; END_IF #
        +--[ ]( b )----------------------------------------------------------(S)( a )--+

        # IF a AND i > 3 THEN i := 1; j := 2; END_IF #
        +--[ ]( a )--[GT]( i, 3 )------------------------[MOV]( i, 1 )--[MOV]( j, 2 )--+
    "#]],
    );
    check(
        "IF a OR b THEN i := i + 1; j := i / 2; ELSIF c THEN i := 0; ELSE i := 7; END_IF;",
        Dialect::Iec,
        &expect![[r#"
        # IF a OR b THEN #
        +--[/]( a )--[/]( b )------------------------------------------<JMP>( else1 )--+
        +----------------------------------------------------------[CALC]( i, i + 1 )--+
        +----------------------------------------------------------[CALC]( j, i / 2 )--+
        +-------------------------------------------------------------<JMP>( endif1 )--+

        # ELSIF c THEN #
        +--<LBL>( else1 )--[ ]( c )--------------------[MOV]( i, 0 )--<JMP>( endif1 )--+

        # ELSE #
        +---------------------------------------------------------------[MOV]( i, 7 )--+
        +--<LBL>( endif1 )-------------------------------------------------------------+
    "#]],
    );
    check(
        "IF a THEN\n  IF b THEN i := 1; j := i + 1; END_IF;\nELSE\n  i := 7;\nEND_IF;\nIF a THEN RETURN; END_IF",
        Dialect::Codesys,
        &expect![[r#"
        # IF a THEN #
        +--[/]( a )----------------------------------------------------<JMP>( else1 )--+

        # IF b THEN #
        +--[/]( b )---------------------------------------------------<JMP>( endif2 )--+
        +---------------------------------------------------------------[MOV]( i, 1 )--+
        +----------------------------------------------------------[CALC]( j, i + 1 )--+
        +--<LBL>( endif2 )--------------------------------------------<JMP>( endif1 )--+

        # ELSE #
        +--<LBL>( else1 )-----------------------------------------------[MOV]( i, 7 )--+

        # IF a THEN RETURN; END_IF #
        +--<LBL>( endif1 )--[ ]( a )--------------------------------------------<RET>--+
    "#]],
    );
}

#[test]
fn cases() {
    check(
        "CASE i OF 1: j := 1; 2, 5..9: j := j + 1; k := 2; ELSE j := 0; END_CASE;",
        Dialect::Iec,
        &expect![[r#"
        # CASE i OF #
        # 1: #
        +--[EQ]( i, 1 )------------------------------[MOV]( j, 1 )--<JMP>( endcase1 )--+

        # 2, 5..9: #
        +--\--[EQ]( i, 2 )-----\--[NOT]---------------------------------<JMP>( arm1 )--+
        |  /--[LE]( 5, i, 9 )--/                                                       |
        +----------------------------------------------------------[CALC]( j, j + 1 )--+
        +---------------------------------------------------------------[MOV]( k, 2 )--+
        +-----------------------------------------------------------<JMP>( endcase1 )--+

        # ELSE #
        +--<LBL>( arm1 )------------------------------------------------[MOV]( j, 0 )--+
        +--<LBL>( endcase1 )-----------------------------------------------------------+
    "#]],
    );
    check(
        "CASE i + 1 OF 1, 2, 3, 4, 5: j := 1; END_CASE;",
        Dialect::Iec,
        &expect![[r#"
        VAR
            st1 : DINT;
            st2 : BOOL;
        END_VAR

        # CASE i + 1 OF #
        +--------[CALC]( st1, i + 1 )--[CALC]( st2, st1 = 1 OR st1 = 2 OR st1 = 3 OR st1 = 4 OR st1 = 5 )--+

        # 1, 2, 3, 4, 5: #
        +--[ ]( st2 )---------------------------------------------------[MOV]( j, 1 )--+
    "#]],
    );
}

#[test]
fn loops() {
    check(
        "FOR i := 1 TO 10 DO x[i - 1] := i; IF x[i] = 3 THEN EXIT; END_IF; END_FOR; j := i;",
        Dialect::Codesys,
        &expect![[r#"
        VAR
            st1 : BOOL;
        END_VAR

        # FOR i := 1 TO 10 DO #
        +---------------------------------------------------------<FOR>( 10, I => i )--+
        +--------------------------------------------------------[MOV]( x[i - 1], i )--+

        # IF x[i] = 3 THEN EXIT; END_IF #
        +--[CALC]( st1, x[i] = 3 )--[ ]( st1 )-----------------------<JMP>( endfor1 )--+
        +----------------------------------------------------------------------<NEXT>--+
        +----------------------------------------------------------[CALC]( i, i + 1 )--+
        +--<LBL>( endfor1 )---------------------------------------------[MOV]( j, i )--+
    "#]],
    );
    check(
        "FOR i := 7 TO 0 BY -1 DO j := j + i; END_FOR;",
        Dialect::Iec,
        &expect![[r#"
        VAR
            st1 : INT;
        END_VAR

        # FOR i := 7 TO 0 BY -1 DO #
        +--------------------------------------------------------<FOR>( 8, I => st1 )--+
        +--------------------------------------------------------[CALC]( i, 8 - st1 )--+
        +----------------------------------------------------------[CALC]( j, j + i )--+
        +----------------------------------------------------------------------<NEXT>--+
    "#]],
    );
    check(
        "FOR i := j TO k BY l DO IF a THEN CONTINUE; END_IF; m := m + i; END_FOR;",
        Dialect::Iec,
        &expect![[r#"
        VAR
            st1 : INT;
            st2 : INT;
        END_VAR

        # FOR i := j TO k BY l DO #
        +-----------------------------[MOV]( i, j )--[MOV]( st1, k )--[MOV]( st2, l )--+
        +--<LBL>( loop1 )--[GE]( st2, 0 )--[GT]( i, st1 )------------<JMP>( endfor1 )--+
        +--[LT]( st2, 0 )--[LT]( i, st1 )----------------------------<JMP>( endfor1 )--+

        # IF a THEN CONTINUE; END_IF #
        +--[ ]( a )----------------------------------------------------<JMP>( next1 )--+
        +----------------------------------------------------------[CALC]( m, m + i )--+
        +--<LBL>( next1 )----------------------------------------[CALC]( i, i + st2 )--+
        +--------------------------------------------------------------<JMP>( loop1 )--+
        +--<LBL>( endfor1 )------------------------------------------------------------+
    "#]],
    );
    check(
        "WHILE i < 10 DO i := i + 1; END_WHILE; REPEAT i := i - 1; UNTIL i = 0 END_REPEAT; WHILE TRUE DO EXIT; END_WHILE;",
        Dialect::Iec,
        &expect![[r#"
        # WHILE i < 10 DO #
        +--<LBL>( loop1 )--[GE]( i, 10 )---------------------------<JMP>( endwhile1 )--+
        +----------------------------------------------------------[CALC]( i, i + 1 )--+
        +--------------------------------------------------------------<JMP>( loop1 )--+

        # REPEAT #
        +--<LBL>( endwhile1 )--<LBL>( loop2 )----------------------[CALC]( i, i - 1 )--+

        # UNTIL i = 0 #
        +--[NE]( i, 0 )------------------------------------------------<JMP>( loop2 )--+

        # WHILE TRUE DO #
        +--<LBL>( loop3 )------------------------------------------<JMP>( endwhile2 )--+
        +--------------------------------------------------------------<JMP>( loop3 )--+
        +--<LBL>( endwhile2 )----------------------------------------------------------+
    "#]],
    );
}

#[test]
fn dialects() {
    check(
        "a S= b; a R= c AND d; i := j := 3; IF a THEN i := 0; END_IF",
        Dialect::Codesys,
        &expect![[r#"
        +--[ ]( b )----------------------------------------------------------(S)( a )--+
        +--[ ]( c )--[ ]( d )------------------------------------------------(R)( a )--+

        # i := j := 3 #
        +------------------------------------------------[MOV]( j, 3 )--[MOV]( i, j )--+

        # IF a THEN i := 0; END_IF #
        +--[ ]( a )-----------------------------------------------------[MOV]( i, 0 )--+
    "#]],
    );
    check(
        "REGION one\n#i += 1;\nEND_REGION\n#t.TON(IN := #a, PT := T#1S); #b := #w.%X3; GOTO out; out: #j := 1;",
        Dialect::Scl,
        &expect![[r#"
        # one #
        +----------------------------------------------------------[CALC]( i, i + 1 )--+
        +--[ ]( a )--------------------------------------------------[TON]( t, T#1S )--+
        +--[ ]( w.3 )--------------------------------------------------------( )( b )--+
        +----------------------------------------------------------------<JMP>( out )--+
        +--<LBL>( out )-------------------------------------------------[MOV]( j, 1 )--+
    "#]],
    );
    check(
        "a [:=] 0; b := 1; // told\n w := 16#FF;",
        Dialect::Logix,
        &expect![[r#"
        +-----------------------------------------------------------[MOV]( a, FALSE )--+

        # told #
        +------------------------------------------------------------[MOV]( b, TRUE )--+
        +-----------------------------------------------------------[MOV]( w, 16#FF )--+
    "#]],
    );
}

#[test]
fn what_has_no_counterpart_is_an_unread_part_at_its_place() {
    check(
        "i := 1;\nj := ADR(i);\nMSG(a);\nIF ADR(i) > 3 THEN RETURN; END_IF;",
        Dialect::Iec,
        &expect![[r#"
        unread: `ADR`: it works on memory by address, which ladder text does not have
    "#]],
    );
    check(
        "i := 1;\nj := GETTIME(16#FF);\np^ := 3; k := 2;",
        Dialect::Iec,
        &expect![[r#"
            # line 2 of Main: `GETTIME` is not declared, and is not a function that is read; it is not run here. #
            FUNCTION_BLOCK [$line_2_of_Main]
            # ladder: unread #
            # j := GETTIME(16\hFF) #
            END_FUNCTION_BLOCK

            # line 3 of Main: a pointer works on memory by address, which ladder text does not have; it is not run here. #
            FUNCTION_BLOCK [$line_3_of_Main]
            # ladder: unread #
            # p^ := 3 #
            END_FUNCTION_BLOCK

            +---------------------------------------------------------------[MOV]( i, 1 )--+
            +-----------------------------------------------------------[$line_2_of_Main]--+
            +-----------------------------------------------------------[$line_3_of_Main]--+
            +---------------------------------------------------------------[MOV]( k, 2 )--+
        "#]],
    );
}

#[test]
fn mistakes_are_reported_at_their_places() {
    check(
        "i := ;\nIF a THEN j := 1 END_IF;\nFOR i = 1 TO 3 DO END_FOR;\n) x",
        Dialect::Iec,
        &expect![[r#"
        5..6: a value is expected here, not `;`
        38..39: `:=` is expected here, not `=`
        57..58: `:=` is expected here, not `;`
        59..60: a statement is expected here, not `)`
    "#]],
    );
    // In quotes a name of SCL, a text elsewhere.
    check(
        "FOR \"a\" := 1 TO 2 DO i := j; END_FOR;",
        Dialect::Codesys,
        &expect![[r#"
            4..7: a name is expected here, not `"a"`
            36..37: `:=` is expected here, not `;`
        "#]],
    );
}

#[test]
fn a_timer_and_the_line_that_takes_its_output_are_one_rung() {
    check(
        "t(IN := a, PT := T#3s);\nb := t.Q;\n(* why *)\nz(CU := c, PV := 5);  (* counted *)\nd := z.Q;\n",
        Dialect::Iec,
        &expect![[r#"
            +--[ ]( a )----------------------------------------[TON]( t, T#3s )--( )( b )--+

            # why #
            # counted #
            +--[ ]( c )-----------------------------------------------------[CTU]( z, 5 )--+
            +--[ ]( z.Q )--------------------------------------------------------( )( d )--+
        "#]],
    );
    // A line that does something else with it stays one of its own.
    check(
        "t(IN := a, PT := T#3s);\n\nb := t.Q;\nc := NOT t.Q;\n",
        Dialect::Iec,
        &expect![[r#"
            +--[ ]( a )--------------------------------------------------[TON]( t, T#3s )--+
            +--[ ]( t.Q )--------------------------------------------------------( )( b )--+
            +--[/]( t.Q )--------------------------------------------------------( )( c )--+
        "#]],
    );
}

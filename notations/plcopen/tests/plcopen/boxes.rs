//! Boxes with texts in ST.

use crate::harness::{check, program, project};
use expect_test::expect;

/// A drawing in which `BOX 3 text` is a box with a text that element 2 feeds.
fn with_boxes(variables: &str, body: &str, boxes: &[(u32, u32, &str)]) -> String {
    let mut text = program(variables, body);
    for (id, from, code) in boxes {
        let start = text
            .find(&format!("<BOX localId=\"{id}\""))
            .expect("the box is there");
        let end = start + text[start..].find("</BOX>").expect("the box ends") + "</BOX>".len();
        let made = format!(
            "<block localId=\"{id}\" typeName=\"EXECUTE\"><inputVariables><variable formalParameter=\"EN\"><connectionPointIn><connection refLocalId=\"{from}\"/></connectionPointIn></variable></inputVariables><inOutVariables/><outputVariables><variable formalParameter=\"ENO\"><connectionPointOut/></variable></outputVariables><addData><data><STCode>{code}</STCode></data></addData></block>"
        );
        text.replace_range(start..end, &made);
    }
    project("", &text, "")
}

#[test]
fn texts_of_a_body_share_their_instances_and_labels() {
    let text = with_boxes(
        "a : BOOL\nn : INT\nt : TON\nq : BOOL",
        "leftPowerRail 1
         contact 2 from=1 a
         BOX 3
         coil 4 from=3 q
         BOX 5
         contact 6 from=1 t.Q
         BOX 7
         contact 8 from=1 a
         label 9 label=past1
         coil 10 from=8 q",
        &[
            (
                3,
                2,
                "t(IN := q, PT := T#2s); IF n = 3 THEN n := 4; q := FALSE; END_IF;",
            ),
            (5, 1, "(* always *) n := n + 1;"),
            (7, 6, "t(IN := FALSE);"),
        ],
    );
    check(
        &text,
        expect![[r#"
        VAR
            a     : BOOL;
            n     : INT;
            t     : TON;
            q     : BOOL;
            power : BOOL;  # the power after a block #
        END_VAR

        +--[ ]( a )--( )( power )--[NOT]-------------------------------<JMP>( past2 )--+

        +--[ ]( q )--------------------------------------------------[TON]( t, T#2s )--+

        # IF n = 3 THEN n := 4; q := FALSE; END_IF #
        +--[EQ]( n, 3 )------------------------------[MOV]( n, 4 )--[MOV]( q, FALSE )--+

        +--<LBL>( past2 )--[ ]( power )--------------------------------------( )( q )--+

        # always #
        +----------------------------------------------------------[CALC]( n, n + 1 )--+

        +--[ ]( t.Q )--[NOT]-------------------------------------------<JMP>( past4 )--+

        # ladder: allow(duplicate-timer): several calls of t #
        +--[ ]( SYS.OFF )--------------------------------------------[TON]( t, t.PT )--+

        +--<LBL>( past4 )--<LBL>( past1 )----------------------------------------------+

        +--[ ]( a )----------------------------------------------------------( )( q )--+
    "#]],
    );
}

#[test]
fn texts_that_are_not_read_spoil_no_others() {
    let text = with_boxes(
        "a : BOOL\nn : INT\nt : TON",
        "leftPowerRail 1
         contact 2 from=1 a
         BOX 3
         BOX 4
         BOX 5
         contact 6 from=1 a
         block 7 TON t IN=6 / Q ET
         BOX 8",
        &[
            (3, 2, "n := (1;"),
            (4, 2, "n := 2;"),
            (5, 2, "EXIT;"),
            (8, 2, "t(IN := TRUE);"),
        ],
    );
    check(
        &text,
        expect![[r#"
        # EXECUTE is not read (line 1 does not parse: `)` is expected here, not `;`): a scan runs past it, and what it may write is not known. #
        FUNCTION_BLOCK [$EXECUTE]
        # ladder: unread #
        # n := (1; #
        END_FUNCTION_BLOCK

        # EXECUTE is not read (a RETURN, EXIT or GOTO may leave the text of a box): a scan runs past it, and what it may write is not known. #
        FUNCTION_BLOCK [$EXECUTE2]
        # ladder: unread #
        # EXIT; #
        END_FUNCTION_BLOCK

        # EXECUTE is not read (a box calls `t`, too): a scan runs past it, and what it may write is not known. #
        FUNCTION_BLOCK [$EXECUTE3]
        # ladder: unread #
        # t(IN := TRUE); #
        END_FUNCTION_BLOCK

        VAR
            a : BOOL;
            n : INT;
            t : TON;
        END_VAR

        +--[ ]( a )--------------------------------------------------------[$EXECUTE]--+

        +--[ ]( a )--[NOT]---------------------------------------------<JMP>( past1 )--+

        +---------------------------------------------------------------[MOV]( n, 2 )--+

        +--<LBL>( past1 )--[ ]( a )---------------------------------------[$EXECUTE2]--+

        +--[ ]( a )--------------------------------------------------[TON]( t, T#0s )--+

        +--[ ]( a )-------------------------------------------------------[$EXECUTE3]--+
        approximated block EXECUTE: line 1 does not parse: `)` is expected here, not `;`: a scan runs past it, and what it may write is not known
        approximated block EXECUTE: a RETURN, EXIT or GOTO may leave the text of a box: a scan runs past it, and what it may write is not known
        approximated TON t: nothing is wired to its limit: it is nothing here
        approximated block EXECUTE: a box calls `t`, too: a scan runs past it, and what it may write is not known
    "#]],
    );
}

#[test]
fn what_codesys_reads_once_is_not_read_again() {
    let of = |code: &str| {
        let text = with_boxes(
            "a : BOOL\nb : BOOL\nc : BOOL",
            "leftPowerRail 1
             contact 2 from=1 a
             BOX 3
             coil 4 from=3 b
             coil 5 from=2 c",
            &[(3, 2, code)],
        );
        text.replace("<types>", "<fileHeader productName=\"CODESYS V3.5\"/><types>")
    };
    check(
        &of("b := NOT b;"),
        expect![[r#"
        # from CODESYS V3.5 #

        VAR
            a     : BOOL;
            b     : BOOL;
            c     : BOOL;
            power : BOOL;  # the power after a block #
        END_VAR

        +--[ ]( a )--( )( power )--[NOT]-------------------------------<JMP>( past1 )--+

        +----------------------------------------------------------[CALC]( b, NOT b )--+

        +--<LBL>( past1 )--[ ]( power )--------------------------------------( )( b )--+

        +--[ ]( a )----------------------------------------------------------( )( c )--+
    "#]],
    );
    check(
        &of("a := FALSE;"),
        expect![[r#"
        # from CODESYS V3.5 #

        # EXECUTE is not read (what it writes is read in its network by what is not after it): a scan runs past it, and what it may write is not known. #
        FUNCTION_BLOCK [$EXECUTE]
        # ladder: unread #
        # a := FALSE; #
        END_FUNCTION_BLOCK

        VAR
            a : BOOL;
            b : BOOL;
            c : BOOL;
        END_VAR

        +--[ ]( a )--\----------------------------------------[$EXECUTE]--( )( b )--\--+
        |            /----------------------------------------------------( )( c )--/  |
        approximated block EXECUTE: what it writes is read in its network by what is not after it: a scan runs past it, and what it may write is not known
    "#]],
    );
}

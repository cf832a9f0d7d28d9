//! What is put into a wire: names that are new, copies, other notations, and what is refused.

use super::{check, copied, given, insert};
use crate::redraw::{Change, Given};
use expect_test::expect;
use ladder_analysis::names::scope::SectionKind;

#[test]
fn new_names_are_declared_where_declarations_are() {
    check(
        "FUNCTION_BLOCK [$B]\nVAR_INPUT a : BOOL; END_VAR\n+--[ ]( EN )--$0[ ]( a )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n",
        insert("[ ]( b )--[TON]( t, T#1s )"),
        expect![[r#"
            FUNCTION_BLOCK [$B]
            VAR_INPUT a : BOOL; END_VAR
            VAR
                b : BOOL;
                t : TON;
            END_VAR
            +--[ ]( EN )--«[ ]( b )»--«[TON]( t, T#1s )»--[ ]( a )-----------------( )( ENO )--+
            END_FUNCTION_BLOCK
            Open contact b and 1 more added; b declared as BOOL in VAR; t declared as TON in VAR
        "#]],
    );
    check(
        "VAR_INPUT\n    a : BOOL;\nEND_VAR\n\n+--[ ]( a )--$0( )( y )--+\n",
        insert("[MOV]( speed, 5 )"),
        expect![[r#"
            VAR_INPUT
                a : BOOL;
            END_VAR
            VAR
                speed : DINT;
            END_VAR

            +--[ ]( a )---------------------------------------«[MOV]( speed, 5 )»--( )( y )--+
            Move speed added; speed declared as DINT in VAR
        "#]],
    );
    check(
        "+--[ ]( a )--$0( )( y )--+\n",
        insert("[ ]( b )"),
        expect![[r#"
        +--[ ]( a )--«[ ]( b )»------------------------------------------------( )( y )--+
        Open contact b added
    "#]],
    );
    check(
        "+--[ ]( a )--$0( )( y )--+\n",
        |at| Change::Insert {
            at: at[0],
            given: Given {
                declare: Some((SectionKind::Input, "BOOL".to_owned())),
                ..given("[ ]( b )")
            },
        },
        expect![[r#"
            VAR_INPUT
                b : BOOL;
            END_VAR

            +--[ ]( a )--«[ ]( b )»------------------------------------------------( )( y )--+
            Open contact b added; b declared as BOOL in VAR_INPUT
        "#]],
    );
    // A block of the file itself says what its parameters are.
    check(
        "VAR x : BOOL; END_VAR\n+--[ ]( x )--$0( )( y )--+\n\nFUNCTION_BLOCK [$M]\nVAR_INPUT go : INT; END_VAR\n+--[ ]( EN )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n",
        insert("[$M]( m1, n )"),
        expect![[r#"
            VAR
                x  : BOOL;
                m1 : $M;
                n  : INT;
            END_VAR
            +--[ ]( x )-------------------------------------------«[$M]( m1, n )»--( )( y )--+

            FUNCTION_BLOCK [$M]
            VAR_INPUT go : INT; END_VAR
            +--[ ]( EN )--( )( ENO )--+
            END_FUNCTION_BLOCK
            [$M] m1 added; m1 declared as $M in VAR; n declared as INT in VAR
        "#]],
    );
}

#[test]
fn a_copy_has_states_of_its_own() {
    check(
        "VAR\n    a, y : BOOL;\n    t : TON;\n    t_1 : TON;\nEND_VAR\n\n+--[ ]( a )--[TON]( t, T#5s )--$0( )( y )--+\n",
        |at| Change::Insert {
            at: at[0],
            given: copied("[TON]( t, T#5s )--[ ]( t.Q )"),
        },
        expect![[r#"
            VAR
                a, y   : BOOL;
                t, t_2 : TON;
                t_1    : TON;
            END_VAR

            +--[ ]( a )--[TON]( t, T#5s )--«[TON]( t_2, T#5s )»--«[ ]( t_2.Q )»------( )( y )--+
            On-delay timer t_2 and 1 more added; t_2 declared as TON in VAR
        "#]],
    );
    check(
        "+--[ ]( a )--[TON]( t, T#5s )--( )( $0y )--+\n",
        |at| Change::Duplicate { network: at[0] },
        expect![[r#"
            +--[ ]( a )--[TON]( t, T#5s )--( )( y )--+

            «+--[ ]( a )--------------------------------------[TON]( t_1, T#5s )--( )( y )--+»
            Network duplicated
        "#]],
    );
    check(
        "FUNCTION_BLOCK [$B]\nVAR a : BOOL; END_VAR\n+--[ ]( EN )--$0[ ]( a )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n",
        |at| Change::Insert {
            at: at[0],
            given: copied("[ ]( elsewhere )"),
        },
        expect![[r#"
            `elsewhere` is not known in the block `$B`: declare it there first
        "#]],
    );
}

#[test]
fn what_is_drawn_by_hand_or_broken_stays() {
    check(
        "# ladder: fmt off #\n+-[ ]( a )-$0-( )( y )-+\n# ladder: fmt on #\n",
        insert("[ ]( x )"),
        expect![[r#"
            this network is between `fmt off` and `fmt on`: it is drawn by hand, in the text
        "#]],
    );
    check(
        "+-[ ]( a )-$0-\\--( )( y )-+\n",
        insert("[ ]( x )"),
        expect![[r#"
            the drawing of this network has an error: put that right in the text first
        "#]],
    );
    check(
        "+-[ ]( a )-$0-|--( )( y )-+\n",
        insert("[ ]( x )"),
        expect![[r#"
        a `|` is in the middle of a wire here: put that right in the text first
    "#]],
    );
    check(
        "+-[ ]( a )-$0-( )( y )-+\n",
        insert("[ ]( x"),
        expect![[r#"
        `( x` is not closed: `)` is missing
    "#]],
    );
    check(
        "+-[ ]( a )-$0-( )( y )-+\n",
        insert("[ ]( x )  [ ]( z )"),
        expect![[r#"
            what is put into a wire is joined on both sides, and its branches meet again
        "#]],
    );
    check(
        "+-[ ]( a )-$0-( )( y )-+\n",
        insert("VAR z : BOOL; END_VAR"),
        expect![[r#"
            `: BOOL` is not expected here
        "#]],
    );
    check(
        "+-[ ]( $0a )--( )( y )-+\n",
        insert("[ ]( x )"),
        expect![[r#"
        there is no wire there that something could be put into
    "#]],
    );
    check(
        "VAR $0a : BOOL; END_VAR\n",
        insert("[ ]( x )"),
        expect![[r#"
        there is no network there
    "#]],
    );
}

#[test]
fn other_notations_are_read() {
    check(
        "+--[ ]( a )--$0( )( y )--+\n",
        insert("XIC b BST XIO c NXB XIC d BND"),
        expect![[r#"
            +--[ ]( a )--«[ ]( b )»--\--«[/]( c )»--\--------------------------------( )( y )--+
            |                      /--«[ ]( d )»--/                                          |
            Open contact b and 2 more added
        "#]],
    );
    check(
        "+--[ ]( a )--$0( )( y )--+\n",
        insert("XIC(b)XYZ(c)"),
        expect![[r#"
            `XYZ(c)` is not read
        "#]],
    );
    check(
        "+--[ ]( a )--$0( )( y )--+\n",
        |at| Change::Network {
            near: Some(at[0]),
            is_above: false,
            given: given("  start   stop          run\n|--| |----|/|-----------( )--|\n"),
        },
        expect![[r#"
            +--[ ]( a )--( )( y )--+

            «+--[ ]( start )--[/]( stop )---------------------------------------( )( run )--+»
            Network added
        "#]],
    );
    check(
        "+--[ ]( a )--$0( )( y )--+\n",
        insert("\\--[ ]( b )--\\\n/--[ ]( c )--/"),
        expect![[r#"
            +--[ ]( a )--\--«[ ]( b )»--\------------------------------------------( )( y )--+
            |            /--«[ ]( c )»--/                                                    |
            Open contact b and 1 more added
        "#]],
    );
}

//! Blocks and comments get another text, or another place.

use super::{check, given, insert, moved};
use crate::redraw::Change;
use expect_test::expect;
use ladder_syntax::{TextRange, TextSize};

const NOTED: &str = "# $0above$1 #\n+--[ ]( a )--( )( y )--+  # beside #\n";

const COUNTER: &str = "+--[ ]( a )--[CTU]( c, $0100$1, R := r )--( )( y )--+\n";

#[test]
fn a_block_that_cannot_be_read_keeps_its_text() {
    check(
        "+--\\--[ ]( ? )--\\--$0( )( y )--+\n|  /--[ ]( b )--/\n",
        insert("[ ]( x )"),
        expect![[r#"
            +--\--[ ]( ? )--\--«[ ]( x )»------------------------------------------( )( y )--+
            |  /--[ ]( b )--/                                                              |
            Open contact x added
        "#]],
    );
    check(
        "+--\\--[ ]( $0?$1 )--\\--( )( y )--+\n|  /--[ ]( b )--/\n",
        |at| Change::Operand {
            what: TextRange::new(at[0], at[1]),
            given: given("start"),
        },
        expect![[r#"
            +--\--«[ ]( start )»--\------------------------------------------------( )( y )--+
            |  /--[ ]( b )------/                                                          |
            ? is start now
        "#]],
    );
}

#[test]
fn comments_come_and_go() {
    let comment = |text: &'static str| {
        move |at: &[TextSize]| Change::Comment {
            network: at[0],
            text: text.to_owned(),
        }
    };
    let edit = |text: &'static str| {
        move |at: &[TextSize]| Change::EditComment {
            what: TextRange::new(at[0], at[1]),
            text: text.to_owned(),
        }
    };
    check(
        "+--[ ]($0 a )--( )( y )--+\r\n",
        comment("two\nlines"),
        expect![[r#"
            «# two #␍
            # lines #»␍
            +--[ ]( a )--( )( y )--+␍
            Comment added
        "#]],
    );
    check(
        "+--[ ]($0 a )--( )( y )--+\n",
        comment("T#5s"),
        expect![[r#"
        a comment cannot hold a `#`: write it without
    "#]],
    );
    check(
        NOTED,
        edit("new"),
        expect![[r#"
        «# new #»
        +--[ ]( a )--( )( y )--+  # beside #
        Comment changed
    "#]],
    );
    check(
        NOTED,
        edit(""),
        expect![[r#"
        +--[ ]( a )--( )( y )--+  # beside #
        Comment deleted
    "#]],
    );
    check(
        "# $0one #\n\n# two$1 #\n+--[ ]( a )--( )( y )--+\n",
        edit("new"),
        expect![[r#"
            «# new #»
            +--[ ]( a )--( )( y )--+
            Comment changed
        "#]],
    );
    check(
        "# $0one #\n+--[ ]( a )--( )( y )--+\n# two$1 #\n",
        edit("new"),
        expect![[r#"
            there is something between these comments
        "#]],
    );
    check(
        "+--[ ]( a )--# $0in$1 #--( )( y )--+\n",
        edit("new"),
        expect![[r#"
            +--[ ]( a )--«# new #»-------------------------------------------------( )( y )--+
            Comment changed
        "#]],
    );
    check(
        "+--[ ]( a )--( )( y )--+  # $0beside$1 #\n",
        edit(""),
        expect![[r#"
            +--[ ]( a )----------------------------------------------------------( )( y )--+
            Comment deleted
        "#]],
    );
}

#[test]
fn operands_and_heads() {
    let operand = |text: &'static str| {
        move |at: &[TextSize]| Change::Operand {
            what: TextRange::new(at[0], at[1]),
            given: given(text),
        }
    };
    check(
        COUNTER,
        operand("5 + 3"),
        expect![[r#"
        +--[ ]( a )-------------------------------«[CTU]( c, 5 + 3, R := r )»--( )( y )--+
        100 is 5 + 3 now
    "#]],
    );
    check(
        COUNTER,
        operand(""),
        expect![[r#"
        +--[ ]( a )--------------------------------------«[CTU]( c, R := r )»--( )( y )--+
        Operand of [CTU] deleted
    "#]],
    );
    check(
        COUNTER,
        operand("1 )--[ ]( b"),
        expect![[r#"
        `[CTU]( c, 1 )--[ ]( b, R := r )` is not one block
    "#]],
    );
    check(
        "+--[CTU]( c, 5, R := $0r$1 )--( )( y )--+\n",
        operand(""),
        expect![[r#"
            +-----------------------------------------------------«[CTU]( c, 5 )»--( )( y )--+
            Operand of [CTU] deleted
        "#]],
    );
    check(
        "+--[ ]($0 $1)--( )( y )--+\n",
        operand("a"),
        expect![[r#"
        +--«[ ]( a )»----------------------------------------------------------( )( y )--+
        The operand is a now
    "#]],
    );
    check(
        "+--[ ]($0 $1)--( )( y )--+\n",
        operand("a b"),
        expect![[r#"
            a comma is missing before this operand
        "#]],
    );
    let head = |text: &'static str| {
        move |at: &[TextSize]| Change::Head {
            what: TextRange::new(at[0], at[1]),
            text: text.to_owned(),
        }
    };
    check(
        "+--$0[ ]$1( a )--( )( y )--+\n",
        head("[P]"),
        expect![[r#"
        +--«[P]( a )»----------------------------------------------------------( )( y )--+
        Rising-edge contact a now
    "#]],
    );
    check(
        "+--$0[ ]$1( a )--( )( y )--+\n",
        head("[ "),
        expect![[r#"
        `[` is not closed: `]` is missing
    "#]],
    );
}

#[test]
fn things_move_within_and_between_networks() {
    check(
        "+--\\--[ ]( a )--[ ]( b )--\\--$2( )( y )--+\n|  /--$0[ ]( c )$1------------/\n",
        moved,
        expect![[r#"
            +--[ ]( a )--[ ]( b )--«[ ]( c )»--------------------------------------( )( y )--+
            c moved
        "#]],
    );
    check(
        "+--$2[ ]( a )--$0\\--[ ]( b )--\\$1--( )( y )--+\n|            /--[ ]( c )--/\n",
        moved,
        expect![[r#"
            +--\--«[ ]( b )»--\--[ ]( a )------------------------------------------( )( y )--+
            |  /--«[ ]( c )»--/                                                              |
            b and 1 more moved
        "#]],
    );
    check(
        "+--$0[ ]( a )$1--( )( y )--+\n\nFUNCTION_BLOCK [$B]\n+--[ ]( EN )--$2( )( ENO )--+\nEND_FUNCTION_BLOCK\n",
        moved,
        expect![[r#"
            `a` is not known there: declare it there first
        "#]],
    );
    check(
        "+--$0[ ]( a )--[ ]( b )$1--$2( )( y )--+\n",
        moved,
        expect![[r#"
        +--«[ ]( a )»--«[ ]( b )»------------------------------------------------( )( y )--+
        a and 1 more moved
    "#]],
    );
}

//! What a key draws, with `$0` where the cursor is; `^` shows where it goes.

use super::{Redraw, redraw};
use expect_test::{Expect, expect};
use ladder_analysis::context;
use ladder_format::{Options, apply};
use ladder_syntax::{TextRange, TextSize, parse};
use std::sync::Arc;

fn check(fixture: &str, what: Redraw, expected: Expect) {
    let at = fixture.find("$0").expect("a fixture has its $0");
    let text = fixture.replacen("$0", "", 1);
    let context = context(&Arc::new(parse(&text)), "test.clad");
    let range = TextRange::empty(TextSize::new(at as u32));
    let shown = match redraw(&context, range, what, &Options::default()) {
        Ok(redrawn) => {
            let mut new = apply(&text, &redrawn.edits);
            if let Some(cursor) = redrawn.focus {
                new.insert(cursor.into(), '^');
            }
            new
        }
        Err(why) => format!("{why}\n"),
    };
    expected.assert_eq(&shown);
}

const RUNG: &str = "+--[ ]( a )--\\--[ ]( b )--\\--( )( y )--+\n             /--[ ]( c )--/\n";

#[test]
fn blocks_are_put_in_at_the_cursor() {
    check(
        "+--[ ]( a )--$0( )( y )--+\n",
        Redraw::Contact,
        expect![[r#"
            +--[ ]( a )--[ ]( ^contact_1 )----------------------------------------( )( y )--+
        "#]],
    );
    check(
        "+--$0[ ]( a )--( )( y )--+\n",
        Redraw::ClosedContact,
        expect![[r#"
            +--[/]( ^contact_1 )--[ ]( a )----------------------------------------( )( y )--+
        "#]],
    );
    check(
        "+--[ ]( a )--( )( y )--$0+\n",
        Redraw::Coil,
        expect![[r#"
            +--[ ]( a )-------------------------------------------( )( y )--( )( ^coil_1 )--+
        "#]],
    );
    check(
        "+--[ ]( contact_1 )$0--( )( y )--+\n",
        Redraw::Block,
        expect![[r#"
            +--[ ]( contact_1 )--------------------------[TON]( ^timer_1, T#1s )--( )( y )--+
        "#]],
    );
    check(
        "+--[ ]( a )--( )( y )--+\n\n$0\n",
        Redraw::Contact,
        expect![[r#"
            +--[ ]( a )--( )( y )--+

            +--[ ]( ^contact_1 )------------------------------------------------------------+
        "#]],
    );
    check(
        "VAR a$0 : BOOL; END_VAR\n",
        Redraw::Contact,
        expect![[r#"
        put the cursor on a rung without errors in its drawing, or on an empty line
    "#]],
    );
}

#[test]
fn blocks_move_along_the_rung_and_to_another() {
    check(
        "+--[ ]( a )--[$0/]( b )--( )( y )--+\n",
        Redraw::Left,
        expect![[r#"
            +--^[/]( b )--[ ]( a )------------------------------------------------( )( y )--+
        "#]],
    );
    check(
        "+--[ $0]( a )--[/]( b )--( )( y )--+\n",
        Redraw::Left,
        expect![[r#"
            the rung or the branch ends there
        "#]],
    );
    check(
        &RUNG.replace("( a )", "($0 a )"),
        Redraw::Right,
        expect![[r#"
            +--\--^[ ]( a )--[ ]( b )--\------------------------------------------( )( y )--+
            |  /--[ ]( c )------------/                                                    |
        "#]],
    );
    check(
        &RUNG.replace("( b )", "($0 b )"),
        Redraw::Down,
        expect![[r#"
            +--[ ]( a )--^[ ]( b )--[ ]( c )--------------------------------------( )( y )--+
        "#]],
    );
    check(
        &RUNG.replace("( c )", "($0 c )"),
        Redraw::Up,
        expect![[r#"
            +--[ ]( a )--^[ ]( c )--[ ]( b )--------------------------------------( )( y )--+
        "#]],
    );
    check(
        &RUNG.replace("( a )", "($0 a )"),
        Redraw::Up,
        expect![[r#"
        there is no rung there
    "#]],
    );
}

#[test]
fn a_block_goes_to_the_network_above_or_below() {
    let two = "# first #\n+--[ ]( a )--[ ]( b )--( )( y )--+\n\n# second #\n+--[ ]( c )--\\--( )( z )--+\n|  /--[ ]( d )--/\n";
    let two = two.replace("+--[ ]( c )", "+--\\--[ ]( c )");
    check(
        &two.replace("( b )", "($0 b )"),
        Redraw::Down,
        expect![[r#"
            # first #
            +--[ ]( a )----------------------------------------------------------( )( y )--+

            # second #
            +--\--[ ]( c )--^[ ]( b )--\------------------------------------------( )( z )--+
            |  /--[ ]( d )------------/                                                    |
        "#]],
    );
    check(
        &two.replace("( c )", "($0 c )"),
        Redraw::Up,
        expect![[r#"
            # first #
            +--[ ]( a )--^[ ]( c )--[ ]( b )--------------------------------------( )( y )--+

            # second #
            +--[ ]( d )----------------------------------------------------------( )( z )--+
        "#]],
    );
    check(
        &two.replace("( d )", "($0 d )"),
        Redraw::Down,
        expect![[r#"
        there is no rung there
    "#]],
    );
    check(
        "+--[ $0]( a )--+\n\n+--[ ]( b )--( )( y )--+\n",
        Redraw::Down,
        expect![[r#"
            +--^[ ]( a )--[ ]( b )------------------------------------------------( )( y )--+
        "#]],
    );
    check(
        "+--[ ]( a )--+\n\n+--<FUN>( f )--+\n\n+--[ ]($0 b )--( )( y )--+\n",
        Redraw::Up,
        expect![[r#"
            there is no rung there
        "#]],
    );
    // A network with an error in its drawing stays as it is.
    check(
        "+--[ ]($0 a )--( )( x )--+\n\n+--[ ]( b )--|--( )( y )--+\n",
        Redraw::Down,
        expect![[r#"
            a `|` is in the middle of a wire here: put that right in the text first
        "#]],
    );
}

#[test]
fn a_block_is_deleted_with_its_wire() {
    check(
        &RUNG.replace("( a )", "($0 a )"),
        Redraw::Delete,
        expect![[r#"
            +^--\--[ ]( b )--\----------------------------------------------------( )( y )--+
            |  /--[ ]( c )--/                                                              |
        "#]],
    );
    check(
        &RUNG.replace("( c )", "($0 c )"),
        Redraw::Delete,
        expect![[r#"
            +--[ ]( a )--[ ]( b )------------------------------------------------( )( y )^--+
        "#]],
    );
    check(
        "+--[ $0]( a )--+\n\n+--[ ]( b )--( )( y )--+\n",
        Redraw::Delete,
        expect![[r#"
            ^+--[ ]( b )--( )( y )--+
        "#]],
    );
}

#[test]
fn a_branch_is_wrapped_round_what_is_selected() {
    check(
        &RUNG.replace("( a )", "($0 a )"),
        Redraw::Branch,
        expect![[r#"
            +--\--[ ]( a )--------------\--\--[ ]( b )--\------------------------( )( y )--+
            |  /--[ ]( ^new_contact_1 )--/  /--[ ]( c )--/                                  |
        "#]],
    );
    check(
        &RUNG.replace("( a )", "($0 a )"),
        Redraw::Invert,
        expect![[r#"
            +--[/]( a )--\--[ ]( b )--\------------------------------------------( )( y )--+
            |            /--[ ]( c )--/                                                    |
        "#]],
    );
}

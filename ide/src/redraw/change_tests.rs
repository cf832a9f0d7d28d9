//! Changes of the diagram: what a text becomes, with `«»` around what is selected then, and what is said; or why not. `$0`, `$1`
//! .. in a text are the places that a change is about.

use super::{Change, Given, change};
use crate::drawing::beside::Side;
use expect_test::{Expect, expect};
use ladder_analysis::context;
use ladder_analysis::names::scope::SectionKind;
use ladder_format::{Options, apply};
use ladder_syntax::{TextRange, TextSize, parse};
use std::sync::Arc;

fn given(text: &str) -> Given {
    Given {
        text: text.to_owned(),
        ..Given::default()
    }
}

fn copied(text: &str) -> Given {
    Given {
        copied: true,
        ..given(text)
    }
}

/// The text of a fixture, and its places.
fn fixture(marked: &str) -> (String, Vec<TextSize>) {
    let mut text = marked.to_owned();
    let mut places = Vec::new();
    let next = |text: &str| {
        let mut marks = text.match_indices('$').map(|(at, _)| at);
        marks.find(|at| text[at + 1..].starts_with(|c: char| c.is_ascii_digit()))
    };
    while let Some(at) = next(&text) {
        let number = text[at + 1..at + 2].to_owned();
        text.replace_range(at..at + 2, "");
        places.push((number, TextSize::new(at as u32)));
    }
    places.sort();
    (text, places.into_iter().map(|(_, place)| place).collect())
}

#[track_caller]
fn check(marked: &str, what: impl Fn(&[TextSize]) -> Change, expected: Expect) {
    let (text, places) = fixture(marked);
    let context = context(&Arc::new(parse(&text)), "test.clad");
    let shown = match change(&context, &what(&places), &Options::default()) {
        Err(why) => format!("{why}\n"),
        Ok(done) => {
            let mut new = apply(&text, &done.edits);
            for range in done.select.iter().rev() {
                new.insert(range.end().into(), '»');
                new.insert(range.start().into(), '«');
            }
            format!("{}{}\n", new.replace('\r', "␍"), done.said)
        }
    };
    expected.assert_eq(&shown);
}

const TWO: &str = "# one #\n+--[ ]($0 a )--( )( y )--+\n+--[ ]($1 b )--( )( z )--+";
const NOTED: &str = "# $0above$1 #\n+--[ ]( a )--( )( y )--+  # beside #\n";
const COUNTER: &str = "+--[ ]( a )--[CTU]( c, $0100$1, R := r )--( )( y )--+\n";

fn insert(text: &'static str) -> impl Fn(&[TextSize]) -> Change {
    move |at| Change::Insert {
        at: at[0],
        given: given(text),
    }
}

fn below(text: &'static str) -> impl Fn(&[TextSize]) -> Change {
    move |at| Change::Parallel {
        from: at[0],
        to: at[1],
        side: Side::Below,
        given: given(text),
    }
}

fn delete(at: &[TextSize]) -> Change {
    let what = at.chunks(2).map(|pair| TextRange::new(pair[0], pair[1]));
    Change::Delete { what: what.collect() }
}

fn moved(at: &[TextSize]) -> Change {
    Change::Move {
        what: vec![TextRange::new(at[0], at[1])],
        to: at[2],
    }
}

#[test]
fn never_a_bare_wire_beside_something() {
    check(
        "+--\\--$0[ ]( a )$1--\\--( )( y )--+  # one #\n|  /--\\--[ ]( b )--\\--/\n|     /--[ ]( c )--/  # two #\n",
        delete,
        expect![[r#"
            +--\--[ ]( b )--\----------------------------------------------------( )( y )--+  # one #
            |  /--[ ]( c )--/                                                              |  # two #
            a deleted
        "#]],
    );
    check(
        "+--\\--[ ]( a )--$0# why #--\\--( )( y )--+\n|  /--[ ]( b )$1--/\n",
        |at| Change::Delete {
            what: vec![TextRange::empty(at[1] - TextSize::new(1))],
        },
        expect![[r#"
            +--[ ]( a )--# why #-------------------------------------------------( )( y )--+
            b deleted
        "#]],
    );
    check(
        "+--\\--$0[ ]( a )$1--# why #--\\--( )( y )--+\n|  /--[ ]( b )--/\n",
        delete,
        expect![[r#"
            +--[ ]( b )----------------------------------------------------------( )( y )--+  # why #
            a deleted
        "#]],
    );
    // A group, by its line from `\\` to `\\`.
    check(
        "+--[ ]( c )--$0\\--[ ]( a )--\\$1--( )( y )--+\n|            /--[ ]( b )--/\n",
        delete,
        expect![[r#"
            +--[ ]( c )----------------------------------------------------------( )( y )--+
            a and 1 more deleted
        "#]],
    );
    // In a bridge nothing can take its place.
    check(
        "+--[ ]( a )--\\--$0[ ]( b )$1--\\--( )( y )--+\n|            /--[/]( x )--\\--/\n+--[ ]( c )---------------/--[ ]( d )--( )( z )--+\n",
        delete,
        expect![[r#"
            a bare wire would be left between two places that are joined in another way as well
        "#]],
    );
}

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
fn networks_that_are_no_term_are_changed_by_rows() {
    const BRIDGE: &str = "+--[ ]( a )--\\--$0[ ]( b )$1-----\\--( )( y )--+\n|            /--[/]( x )--\\--/\n+--[ ]( c )---------------/--[ ]( d )--( )( z )--+\n";
    check(
        BRIDGE,
        below("[ ]( e )"),
        expect![[r#"
        +--[ ]( a )--\-----\--[ ]( b )--\-----\------------------------------( )( y )--+
        |            /--\  /--«[ ]( e )»--/  \--/                                        |
        |               /--[/]( x )--\-----/                                           |
        +--[ ]( c )------------------/--[ ]( d )-----------------------------( )( z )--+
        Open contact e added in parallel to b
    "#]],
    );
    check(
        &BRIDGE.replace("[ ]( d )", "$2[ ]( d )"),
        moved,
        expect![[r#"
        +--[ ]( a )--\---------------\---------------------------------------( )( y )--+
        |            /--[/]( x )--\--/                                                 |
        +--[ ]( c )---------------/--«[ ]( b )»--[ ]( d )----------------------( )( z )--+
        b moved
    "#]],
    );
}

#[test]
fn branches_that_end_by_themselves() {
    const TAIL: &str = "+--[ ]( run )--\\--[/]( fault )--( )( motor )--+\n|              /--[ ]( test )$0--( )( lamp )$1--+\n";
    check(
        TAIL,
        insert("[ ]( x )"),
        expect![[r#"
        +--[ ]( run )--\--[/]( fault )-----------------------------------( )( motor )--+
        |              /--[ ]( test )--«[ ]( x )»---------------------------( )( lamp )--+
        Open contact x added
    "#]],
    );
    check(
        TAIL,
        below("[ ]( x )"),
        expect![[r#"
        +--[ ]( run )--\--[/]( fault )-----------------------------------( )( motor )--+
        |              /--[ ]( test )--\-------------------------------( )( lamp )--\--+
        |                              /--«[ ]( x )»----------------------------------/  |
        Open contact x added in parallel to lamp
    "#]],
    );
    check(
        "+--[ ]( run )--\\--[/]( fault )--( )( motor )--+\n|              /--[ ]( test )--( )( lamp )$0\n",
        insert("( )( x )"),
        expect![[r#"
            +--[ ]( run )--\--[/]( fault )-----------------------------------( )( motor )--+
            |              /--[ ]( test )---------------------------( )( lamp )--«( )( x )»  |
            Coil x added
        "#]],
    );
    check(
        "+--[ ]( run )--\\--$0[/]( fault )--( )( motor )$1--+\n|              /--[ ]( test )--( )( lamp )--+\n",
        delete,
        expect![[r#"
            +--[ ]( run )--[ ]( test )----------------------------------------( )( lamp )--+
            fault and 1 more deleted
        "#]],
    );
    check(
        "+--[ ]( run )--\\--[/]( fault )--( )( motor )--|\n|              /--[ ]( test )$0--|\n",
        insert("[ ]( x )"),
        expect![[r#"
            +--[ ]( run )--\--[/]( fault )--( )( motor )--|
            |              /--[ ]( test )--«[ ]( x )»--|
            Open contact x added
        "#]],
    );
    check(
        "+--[ ]( a )--\\--[ ]( b )--$1( )( y )--+\n|            /--[ ]( c )$0\n",
        |at| Change::Close {
            what: at[0],
            to: at[1],
        },
        expect![[r#"
            +--[ ]( a )--\--[ ]( b )--\------------------------------------------( )( y )--+
            |            /--[ ]( c )--/                                                    |
            Branch closed
        "#]],
    );
}

fn end(at: &[TextSize]) -> Change {
    Change::BranchEnd {
        what: at[0],
        to: at[1],
    }
}

#[test]
fn the_end_of_a_branch_moves_along_the_line() {
    const LINE: &str = "+--[ ]( a )--\\--[ ]( b )--[ ]( c )--\\--[ ]( d )--( )( y )--+\n|            /--[ ]( x )-------------/\n";
    let at = |from: &str, to: &str| {
        LINE.replacen(to, &format!("$1{to}"), 1)
            .replacen(from, &format!("$0{from}"), 1)
    };
    check(
        &at("\\--[ ]( d )", "( )( y )"),
        end,
        expect![[r#"
        +--[ ]( a )--\--[ ]( b )--[ ]( c )--[ ]( d )--\----------------------( )( y )--+
        |            /--[ ]( x )----------------------/                                |
        End of the branch moved
    "#]],
    );
    check(
        &at("\\--[ ]( d )", "[ ]( c )"),
        end,
        expect![[r#"
            +--[ ]( a )--\--[ ]( b )--\--[ ]( c )--[ ]( d )----------------------( )( y )--+
            |            /--[ ]( x )--/                                                    |
            End of the branch moved
        "#]],
    );
    check(
        &at("\\--[ ]( b )", "[ ]( a )"),
        end,
        expect![[r#"
            +--\--[ ]( a )--[ ]( b )--[ ]( c )--\--[ ]( d )----------------------( )( y )--+
            |  /--[ ]( x )----------------------/                                          |
            End of the branch moved
        "#]],
    );
    check(
        &at("\\--[ ]( b )", "[ ]( c )"),
        end,
        expect![[r#"
        +--[ ]( a )--[ ]( b )--\--[ ]( c )--\--[ ]( d )----------------------( )( y )--+
        |                      /--[ ]( x )--/                                          |
        End of the branch moved
    "#]],
    );
    check(
        &at("/--[ ]( x )", "[ ]( a )"),
        end,
        expect![[r#"
            +--\--[ ]( a )--[ ]( b )--[ ]( c )--\--[ ]( d )----------------------( )( y )--+
            |  /--[ ]( x )----------------------/                                          |
            End of the branch moved
        "#]],
    );
    check(
        &at("\\--[ ]( b )", "( )( y )"),
        end,
        expect![[r#"
        the end of a branch can only be moved along the line that it is joined to
    "#]],
    );
    check(
        &at("\\--[ ]( d )", "[ ]( b )"),
        end,
        expect![[r#"
            nothing would be beside the branch then
        "#]],
    );
    // The lowest of three.
    check(
        "+--\\--[ ]( a )--------------\\--( )( y )--+\n|  /--\\--[ ]( b )--$1[ ]( c )--$0\\--/\n|     /--[ ]( x )------------/\n",
        end,
        expect![[r#"
            +--\--[ ]( a )------------------\------------------------------------( )( y )--+
            |  /--\--[ ]( b )--\--[ ]( c )--/                                              |
            |     /--[ ]( x )--/                                                           |
            End of the branch moved
        "#]],
    );
}

#[test]
fn networks_come_and_go() {
    let network = |near: Option<usize>, is_above: bool| {
        move |at: &[TextSize]| Change::Network {
            near: near.map(|near| at[near]),
            is_above,
            given: given("[ ]( n )--( )( m )"),
        }
    };
    check(
        TWO,
        network(Some(0), true),
        expect![[r#"
        «+--[ ]( n )----------------------------------------------------------( )( m )--+»

        # one #
        +--[ ]( a )--( )( y )--+
        +--[ ]( b )--( )( z )--+Network added
    "#]],
    );
    check(
        TWO,
        network(Some(0), false),
        expect![[r#"
        # one #
        +--[ ]( a )--( )( y )--+

        «+--[ ]( n )----------------------------------------------------------( )( m )--+»

        +--[ ]( b )--( )( z )--+Network added
    "#]],
    );
    check(
        TWO,
        network(Some(1), true),
        expect![[r#"
        # one #
        +--[ ]( a )--( )( y )--+

        «+--[ ]( n )----------------------------------------------------------( )( m )--+»

        +--[ ]( b )--( )( z )--+Network added
    "#]],
    );
    check(
        TWO,
        network(Some(1), false),
        expect![[r#"
        # one #
        +--[ ]( a )--( )( y )--+
        +--[ ]( b )--( )( z )--+

        «+--[ ]( n )----------------------------------------------------------( )( m )--+»Network added
    "#]],
    );
    check(
        TWO,
        network(None, false),
        expect![[r#"
        # one #
        +--[ ]( a )--( )( y )--+
        +--[ ]( b )--( )( z )--+

        «+--[ ]( n )----------------------------------------------------------( )( m )--+»Network added
    "#]],
    );
    check(
        "",
        network(None, false),
        expect![[r#"
        «+--[ ]( n )----------------------------------------------------------( )( m )--+»
        Network added
    "#]],
    );
    check(
        "VAR\n    a$0 : BOOL;\nEND_VAR\n",
        network(Some(0), false),
        expect![[r#"
            VAR
                a : BOOL;
            END_VAR
            VAR_INPUT
                n : BOOL;
            END_VAR
            VAR_OUTPUT
                m : BOOL;
            END_VAR

            «+--[ ]( n )----------------------------------------------------------( )( m )--+»
            Network added; n declared as BOOL in VAR_INPUT; m declared as BOOL in VAR_OUTPUT
        "#]],
    );
    check(
        "FUNCTION_BLOCK [$B]$0\nEND_FUNCTION_BLOCK\n",
        network(Some(0), false),
        expect![[r#"
            FUNCTION_BLOCK [$B]
            VAR
                n : BOOL;
                m : BOOL;
            END_VAR

            «+--[ ]( n )----------------------------------------------------------( )( m )--+»
            END_FUNCTION_BLOCK
            Network added; n declared as BOOL in VAR; m declared as BOOL in VAR
        "#]],
    );
    check(
        TWO,
        |at| Change::DeleteNetwork { network: at[0] },
        expect![[r#"
        +--[ ]( b )--( )( z )--+Network deleted
    "#]],
    );
    check(
        TWO,
        |at| Change::DeleteNetwork { network: at[1] },
        expect![[r#"
        # one #
        +--[ ]( a )--( )( y )--+
        Network deleted
    "#]],
    );
    check(
        "\u{feff}+--[ ]($0 a )--( )( y )--+\r\n\r\n# c #\r\n+--[ ]( $1b )--( )( z )--+\r\n",
        |at| Change::MoveNetwork {
            network: at[1],
            before: Some(at[0]),
        },
        expect![[r#"
            ﻿«# c #␍
            +--[ ]( b )--( )( z )--+»␍
            ␍
            +--[ ]( a )--( )( y )--+␍
            Network moved
        "#]],
    );
    check(
        "+--[ ]($0 a )--( )( y )--+\n\n+--<FUN>( f )--+\n\n+--[ ]( $1b )--( )( z )--+\n",
        |at| Change::MoveNetwork {
            network: at[0],
            before: Some(at[1]),
        },
        expect![[r#"
            +--<FUN>( f )--+

            «+--[ ]( a )--( )( y )--+»

            +--[ ]( b )--( )( z )--+
            Network moved; it is in the function `f` now
        "#]],
    );
    check(
        "+--[ ]($0 a )--( )( y )--+\n\n+--[ ]( b )--( )( z )--+\n",
        |at| Change::MoveNetwork {
            network: at[0],
            before: None,
        },
        expect![[r#"
            +--[ ]( b )--( )( z )--+

            «+--[ ]( a )--( )( y )--+»
            Network moved
        "#]],
    );
    check(
        "+--[ ]($0 a )--( )( y )--+\n\n# below #\n+--[ ]($1 b )--( )( z )--+\n",
        |at| Change::Merge {
            networks: at.to_vec(),
        },
        expect![[r#"
            +--\--[ ]( a )----------------------------------------------------( )( y )--\--+
            |  # below #                                                                |  |
            |  /--[ ]( b )----------------------------------------------------( )( z )--/  |
            Networks joined
        "#]],
    );
    check(
        "+--[ ]($0 a )--<JMP>( y )--+\n\n+--[ ]($1 b )--( )( z )--+\n",
        |at| Change::Merge {
            networks: at.to_vec(),
        },
        expect![[r#"
            a block of program flow would do something else then
        "#]],
    );
    check(
        "VAR a, b, y : BOOL; END_VAR\n+--[ ]( a )--$0[ ]( b )--( )( y )--+\n",
        |at| Change::Split { at: at[0] },
        expect![[r#"
            VAR
                a, b, y : BOOL;
                split_1 : BOOL;
            END_VAR
            +--[ ]( a )----------------------------------------------------«( )( split_1 )»--+

            +--«[ ]( split_1 )»--[ ]( b )------------------------------------------( )( y )--+
            Network split; split_1 carries the power; split_1 declared as BOOL in VAR
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

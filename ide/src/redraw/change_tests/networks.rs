//! Networks come, go, move, part and join.

use super::{check, given};
use crate::redraw::{Change, Given};
use expect_test::expect;
use ladder_analysis::names::scope::SectionKind;
use ladder_syntax::TextSize;

const TWO: &str = "# one #\n+--[ ]($0 a )--( )( y )--+\n+--[ ]($1 b )--( )( z )--+";

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
        "\r\n",
        |_| Change::Network {
            near: None,
            is_above: false,
            given: Given {
                declare: Some((SectionKind::Input, "BOOL".to_owned())),
                ..given("[ ]( n )--( )( m )")
            },
        },
        expect![[r#"
            VAR_INPUT␍
                n : BOOL;␍
            END_VAR␍
            VAR_OUTPUT␍
                m : BOOL;␍
            END_VAR␍
            ␍
            «+--[ ]( n )----------------------------------------------------------( )( m )--+»␍
            Network added; n declared as BOOL in VAR_INPUT; m declared as BOOL in VAR_OUTPUT
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

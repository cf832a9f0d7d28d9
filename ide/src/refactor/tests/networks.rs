//! Networks are split, become functions and come back.

use super::{check, titles};
use expect_test::expect;

#[test]
fn split_where_lines_are_independent() {
    check(
        "Split",
        r"# both #
+--\--[ ]( a )-------------------( )( y )--+
|  /--[ ]( $0b )-------------------( )( z )--+
",
        expect![[r#"
            Split the network above this rung

            # both #
            +--[ ]( a )----------------------------------------------------------( )( y )--+

            +--[ ]( b )----------------------------------------------------------( )( z )--+
        "#]],
    );
}

#[test]
fn split_where_power_hangs_below() {
    check(
        "Split",
        r"
+--[ ]( a )--\-------------------( )( y )--+
# the second #
|            /--[ ]( $0b )---------( )( z )--+
",
        expect![[r#"
            Split the network above this rung (`split_1` carries the power)


            +--[ ]( a )--\-------------------------------------------------------( )( y )--+
            |            /-------------------------------------------------( )( split_1 )--+

            # the second #
            +--[ ]( split_1 )--[ ]( b )------------------------------------------( )( z )--+
        "#]],
    );
}

#[test]
fn split_across() {
    check(
        "Split",
        r"
VAR a, b : BOOL; END_VAR
+--\--[ ]( a )--\--\--[ ]( $0b )--\--( )( y )--+
|  /--[ ]( c )--/  /--[ ]( d )--/            |
",
        expect![[r#"
            Split the network before `b` (`split_1` carries the power)


            VAR
                a, b    : BOOL;
                split_1 : BOOL;
            END_VAR
            +--\--[ ]( a )--\----------------------------------------------( )( split_1 )--+
            |  /--[ ]( c )--/                                                              |

            +--[ ]( split_1 )--\--[ ]( b )--\------------------------------------( )( y )--+
            |                  /--[ ]( d )--/                                              |
        "#]],
    );
    titles(
        "+--[ ]( a )--[ ]( $0b )--<MCR>--+\n",
        expect![[r#"
            Make `b` normally closed (changes what the rung does)
            Make `b` a rising-edge contact (changes what the rung does)
            Draw a parallel contact `new_contact_1` around `b` (no change while it is low)
            Wrap `b` in a branch, with a copy in parallel (changes nothing yet)
            Split the network here -- an <MCR> switches the rungs below it in its network
            Declare the undeclared tags of the file
            Extract the network into the function `function_1` -- <MCR> works only where it is: a function has labels, returns and loops of its own
        "#]],
    );
}

#[test]
fn extract() {
    check(
        "Extract",
        r"# head #

# a pump #
+--[ ]( a )--[TON]( t, 5s )------( )( y )--+
+--[ ]( $0b )-------------------( )( z )--+
+--[ ]( c )-------------------( )( x )--+
",
        expect![[r#"
            Extract the network into the function `function_1`

            # head #

            # a pump #
            +--[ ]( a )--[TON]( t, 5s )------( )( y )--+
            +--------------------------------------------------------<CALL>( function_1 )--+
            +--[ ]( c )-------------------( )( x )--+

            +--<FUN>( function_1 )--[ ]( b )-------------------------------------( )( z )--+
        "#]],
    );
    check(
        "Extract",
        r"# head #

# a pump #
+--$0[ ]( a )--[TON]( t, 5s )------( )( y )--+
+--[ ]( b )$1-------------------( )( z )--+
+--[ ]( c )-------------------( )( x )--+",
        expect![[r#"
    Extract 2 networks into the function `function_1`

    # head #

    +--------------------------------------------------------<CALL>( function_1 )--+
    +--[ ]( c )----------------------------------------------------------( )( x )--+

    # a pump #
    +--<FUN>( function_1 )--[ ]( a )---------------------[TON]( t, 5s )--( )( y )--+
    +--[ ]( b )----------------------------------------------------------( )( z )--+
"#]],
    );
    check(
        "Extract",
        "+--[ ]( a )-----------<JMP>( $0y )--+\n",
        expect![[r#"
        disabled: <JMP> works only where it is: a function has labels, returns and loops of its own
    "#]],
    );
}

#[test]
fn inline() {
    check(
        "Inline",
        r"
+--[ ]( a )--------------------( )( y )--+
+--<C$0ALL>( f )--+  # called #
+--[ ]( c )--------------------( )( z )--+

# what it does #
+--<FUN>( f )--\--[ ]( a )-----( )( x )--+
|              /--[ ]( d )-----( )( w )--+
+--[ ]( e )--------------------( )( v )--+
",
        expect![[r#"
            Inline the function `f` here


            +--[ ]( a )--------------------( )( y )--+
            # what it does #
            +--\--[ ]( a )-------------------------------------------------------( )( x )--+
            |  /--[ ]( d )-------------------------------------------------------( )( w )--+
            +--[ ]( e )----------------------------------------------------------( )( v )--+  # called #
            +--[ ]( c )----------------------------------------------------------( )( z )--+
        "#]],
    );
    check(
        "Inline",
        r"
+--[ ]( a )--<CALL>( $0f )--+
+--<FUN>( f )--+
",
        expect![[r#"
    disabled: whether the function runs depends on this rung's power
"#]],
    );
}

/// The marks show the line ends.
#[test]
fn line_ends_wide_letters_and_a_byte_order_mark() {
    let text = "\u{feff}+--[ ]( 温度 )--\\--( )( läuft )--+  # 🏭 #\r\n|\t/--[ ]( $0b )--( )( z )--+\r\n";
    for begin in [
        "Split",
        "Draw a parallel contact",
        "Extract the network",
        "Declare",
    ] {
        let (text, range) = super::fixture(text);
        let new = super::done(begin, &text, range);
        assert!(new.starts_with('\u{feff}'), "{new:?}");
        assert!(!new.replace("\r\n", "").contains(['\r', '\n']), "{new:?}");
        assert_eq!(new.matches("# 🏭 #").count(), 1, "{new:?}");
    }
    check(
        "Split",
        &text.replace("\r\n", "\n"),
        expect![[r#"
            Split the network above this rung (`split_1` carries the power)

            ﻿+--[ ]( 温度 )--\------------------------------------------------( )( läuft )--+  # 🏭 #
            |               /----------------------------------------------( )( split_1 )--+

            +--[ ]( split_1 )--[ ]( b )------------------------------------------( )( z )--+
        "#]],
    );
}

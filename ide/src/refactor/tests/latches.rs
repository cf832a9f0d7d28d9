//! Set and reset coils, seal-ins, declarations.

use super::{check, titles};
use expect_test::expect;

#[test]
fn reset_wins() {
    check(
        "Make a seal-in",
        r"# pump #
+--[ ]( start )--# hand #--[P]( x )---------(S)( p$0ump )--+  # on #
# off again #
+--\--[ ]( stop )---\------------(R)( pump )--+  # off #
|  /--[/]( safe )---/                         |
",
        expect![[r#"
            Make a seal-in of the set and reset coils of `pump`

            # pump #
            # off again #
            +--\--[ ]( start )--# hand #--[P]( x )--\--[/]( stop )--[ ]( safe )-------------------( )( pump )--+  # on #  # off #
            |  /--[ ]( pump )-----------------------/                                                          |
        "#]],
    );
}

#[test]
fn set_wins() {
    check(
        "Make a seal-in",
        r"
+--[ ]( stop )--[ ]( really )----(RM)( pump )--+
+--\--[ ]( start )--\----(SM)( p$0ump )--+
|  /--[TON]( t, 5s )--/                    |
",
        expect![[r#"
            Make a seal-in of the set and reset coils of `pump`


            +--\--[ ]( pump )--\--[/]( stop )----\-------------------------\--(M)( pump )--+
            |  /--\            /--[/]( really )--/                      \--/               |
            |     /--\--[ ]( start )---------------------------------\--/                  |
            |        /-------------------------------[TON]( t, 5s )--/                     |
        "#]],
    );
}

#[test]
fn not_where_more_is_written() {
    check(
        "Make a seal-in",
        r"
+--[ ]( start )---------(S)( p$0ump )--+
+--[ ]( stop )---------(R)( pump )--+
+--[ ]( stop )---------(R)( pump )--+
",
        expect![[r#"
            disabled: `pump` is written elsewhere too
        "#]],
    );
    check(
        "Make a seal-in",
        r"
+--[ ]( start )---------(S)( p$0ump )--+
+--[P]( stop )---------(R)( pump )--+
",
        expect![[r#"
            not offered
        "#]],
    );
    check(
        "Make a seal-in",
        r"
+--[ ]( start )---------(S)( p$0ump )--+
+--[ ]( pump.3 )--[ ]( stop )---------(R)( other )--+
",
        expect![[r#"
            not offered
        "#]],
    );
}

#[test]
fn back() {
    check(
        "Write the seal-in",
        r"
+--\--[ ]( start )--[P]( x )--\--[/]( stop )--[ ]( safe )--( )( p$0ump )--+  # on #
# hold #
|  /--[ ]( pump )-------------/                                       |
",
        expect![[r#"
            Write the seal-in of `pump` as a set and a reset coil


            # hold #
            +--[ ]( start )--[P]( x )-----------------------------------------(S)( pump )--+  # on #
            +--\--[ ]( stop )--\----------------------------------------------(R)( pump )--+
            |  /--[/]( safe )--/                                                           |
        "#]],
    );
    check(
        "Write the seal-in",
        r"
+--\--[ ]( pump )--[/]( stop )---\----( )( p$0ump )--+
|  /--[TON]( t, 5s )-------------/                 |
",
        expect![[r#"
            Write the seal-in of `pump` as a set and a reset coil


            +--[ ]( stop )----------------------------------------------------(R)( pump )--+
            +-------------------------------------------------[TON]( t, 5s )--(S)( pump )--+
        "#]],
    );
    check(
        "Write the seal-in",
        r"
+--\--[TON]( t, 5s )--------------\----( )( p$0ump )--+
|  /--[ ]( pump )--[/]( stop )----/                 |
",
        expect![[r#"
            not offered
        "#]],
    );
}

#[test]
fn declarations() {
    check(
        "Declare",
        r"# head #

+--[ ]( start )--[TON]( t, wait )--[GT]( level, 5.0 )--( )( $0pump )--+
+--[P]( I1 )--[ADD]( n, n, 1 )--+
",
        expect![[r#"
            Declare the undeclared tags of the file

            # head #

            VAR_INPUT
                start : BOOL;
                wait  : TIME;
                level : LREAL;
            END_VAR
            VAR_OUTPUT
                pump : BOOL;
            END_VAR
            VAR
                t : TON;
                n : DINT;
            END_VAR

            +--[ ]( start )--[TON]( t, wait )--[GT]( level, 5.0 )--( )( pump )--+
            +--[P]( I1 )--[ADD]( n, n, 1 )--+
        "#]],
    );
    check(
        "Declare",
        r"
FUNCTION_BLOCK [$B]
VAR_INPUT a : BOOL; END_VAR
+--[ ]( EN )--[ ]( $0a )--( )( b )--[ ]( c[3] )--( )( ENO )--+
END_FUNCTION_BLOCK
",
        expect![[r#"
            not offered
        "#]],
    );
    check(
        "Declare",
        r"
FUNCTION_BLOCK [$B]
VAR_INPUT a : BOOL; END_VAR
+--[ ]( EN )--[ ]( a )--( )( $0b )--[ ]( c[3] )--( )( ENO )--+
END_FUNCTION_BLOCK
",
        expect![[r#"
            Declare the undeclared tags of the block


            FUNCTION_BLOCK [$B]
            VAR_INPUT a : BOOL; END_VAR
            VAR
                b : BOOL;
                c : ARRAY[1..3] OF BOOL;
            END_VAR
            +--[ ]( EN )--[ ]( a )--( )( b )--[ ]( c[3] )--( )( ENO )--+
            END_FUNCTION_BLOCK
        "#]],
    );
    titles(
        "VAR_INPUT a : BOOL; END_VAR\n+--[ ]( $0a )--( )( b )--+\n",
        expect![[r#"
            Make `a` normally closed (changes what the rung does)
            Make `a` a rising-edge contact (changes what the rung does)
            Draw a parallel contact `new_contact_1` around `a` (no change while it is low)
            Wrap `a` in a branch, with a copy in parallel (changes nothing yet)
            Extract the network into the function `function_1`
        "#]],
    );
}

//! Parallel branches come and go.

use super::{check, titles};
use expect_test::expect;

#[test]
fn around_a_contact() {
    check(
        "Draw",
        "+--[ ]( st$0art )---------------------( )( run )--+\n",
        expect![[r#"
            Draw a parallel contact `new_contact_1` around `start` (no change while it is low)

            +--\--[ ]( start )----------\--------------------------------------( )( run )--+
            |  /--[ ]( new_contact_1 )--/                                                  |
        "#]],
    );
}

#[test]
fn around_a_part_of_a_rung_with_a_branch_below() {
    check(
        "Draw",
        "\
+--\\--[ ]( start )--\\--[/]( st$0op )-------------( )( run )--+  # main #
|  /--[ ]( run )----/                                      |  # seal-in #
",
        expect![[r#"
    Draw a parallel contact `new_contact_1` around `stop` (no change while it is low)

    +--\--[ ]( start )--\--\--[/]( stop )-----------\------------------( )( run )--+  # main #
    |  /--[ ]( run )----/  /--[ ]( new_contact_1 )--/                              |  # seal-in #
"#]],
    );
    check(
        "Draw",
        "\
+--\\--[ ]( st$0art )--\\--[/]( stop )-------------( )( run )--+  # main #
# between #
|  /--[ ]( run )----/                                      |  # seal-in #
",
        expect![[r#"
    Draw a parallel contact `new_contact_1` around `start` (no change while it is low)

    +--\--[ ]( start )----------------\--[/]( stop )-------------------( )( run )--+  # main #
    |  # between #                    |                                            |
    |  /--\--[ ]( run )------------\--/                                            |  # seal-in #
    |     /--[ ]( new_contact_1 )--/                                               |
"#]],
    );
    check(
        "Draw",
        "\
+$0--\\--[ ]( start )--\\--$1[/]( stop )-------------( )( run )--+  # main #
|  /--[ ]( run )----/                                      |  # seal-in #
",
        expect![[r#"
    Draw a parallel contact `new_contact_1` around `start` (no change while it is low)

    +--\--[ ]( start )----------------\--[/]( stop )-------------------( )( run )--+  # main #
    |  /--\--[ ]( run )------------\--/                                            |  # seal-in #
    |     /--[ ]( new_contact_1 )--/                                               |
"#]],
    );
}

#[test]
fn next_to_a_coil() {
    check(
        "Draw",
        "+--[ ]( a )---------------------( )( r$0un )--+\n",
        expect![[r#"
            Draw a parallel coil `new_coil_1` next to `run`

            +--[ ]( a )--\--------------------------------------------------( )( run )--\--+
            |            /-------------------------------------------( )( new_coil_1 )--/  |
        "#]],
    );
}

#[test]
fn in_a_body() {
    check(
        "Draw",
        "\
FUNCTION_BLOCK [$B]
VAR_INPUT a : BOOL; END_VAR
+--[ ]( EN )--[ ]( $0a )--( )( ENO )--+
END_FUNCTION_BLOCK
",
        expect![[r#"
            Draw a parallel contact `new_contact_1` around `a` (no change while it is low)

            FUNCTION_BLOCK [$B]
            VAR_INPUT a : BOOL; END_VAR
            VAR
                new_contact_1 : BOOL;
            END_VAR
            +--[ ]( EN )--\--[ ]( a )--------------\---------------------------( )( ENO )--+
            |             /--[ ]( new_contact_1 )--/                                       |
            END_FUNCTION_BLOCK
        "#]],
    );
}

#[test]
fn where_power_crosses_both_ways() {
    check(
        "Draw",
        "\
+--[ ]( $0a )--\\--[ ]( b )---( )( y )--+
+--[ ]( c )--/--[ ]( d )---( )( z )--+
",
        expect![[r#"
    Draw a parallel contact `new_contact_1` around `a` (no change while it is low)

    +--\--[ ]( a )--------------\-----\--\--[ ]( b )---------------------( )( y )--+
    |  /--[ ]( new_contact_1 )--/  \--/  /--\                                      |
    +--[ ]( c )--------------------/--------/--[ ]( d )------------------( )( z )--+
"#]],
    );
    check(
        "Draw",
        "\
+--[ ]( a )--\\--[ ]( $0b )---( )( y )--+
+--[ ]( c )--/--[ ]( d )---( )( z )--+
",
        expect![[r#"
    Draw a parallel contact `new_contact_1` around `b` (no change while it is low)

    +--[ ]( a )-----\--\-----\--[ ]( b )--------------\------------------( )( y )--+
    |            \--/  /--\  /--[ ]( new_contact_1 )--/                            |
    +--[ ]( c )--/--------/--[ ]( d )------------------------------------( )( z )--+
"#]],
    );
}

#[test]
fn a_copy() {
    check(
        "Wrap",
        "+--$0[ ]( a )--[/]( b )$1---------------------( )( run )--+\n",
        expect![[r#"
            Wrap `a` in a branch, with a copy in parallel (changes nothing yet)

            +--\--[ ]( a )--[/]( b )--\----------------------------------------( )( run )--+
            |  /--[ ]( a )--[/]( b )--/                                                    |
        "#]],
    );
    check(
        "Wrap",
        "+--$0[ ]( a )--[P]( b )$1---------------------( )( run )--+\n",
        expect![[r#"
            disabled: [P] has an effect or a memory, and a copy would have them once more
        "#]],
    );
}

#[test]
fn gone() {
    check(
        "Remove",
        "\
+--\\--[ ]( start )--\\--[/]( stop )-------------( )( run )--+  # main #
|  /--[ ]( ru$0n )----/                                      |  # seal-in #
",
        expect![[r#"
            Remove the parallel branch with `run` (changes what the rung does)

            +--[ ]( start )--[/]( stop )---------------------------------------( )( run )--+  # main #  # seal-in #
        "#]],
    );
    check(
        "Remove",
        "\
+--\\--[ ]( st$0art )--\\--[/]( stop )-------------( )( run )--+  # main #
|  /--[ ]( run )----/                                      |  # seal-in #
",
        expect![[r#"
            Remove the parallel branch with `start` (changes what the rung does)

            +--[ ]( run )--[/]( stop )-----------------------------------------( )( run )--+  # main #  # seal-in #
        "#]],
    );
    check(
        "Remove",
        "\
+--\\-----\\--[ ]( a )--\\-----\\--------( )( y )--+
|  /--\\  /--[ ]( b )--/  \\--/                  |
|     /--[ ]( $0c )--------/                     |
",
        expect![[r#"
            Remove the parallel branch with `c` (changes what the rung does)

            +--\--[ ]( a )--\----------------------------------------------------( )( y )--+
            |  /--[ ]( b )--/                                                              |
        "#]],
    );
    check(
        "Remove",
        "\
+--\\-----\\--[ ]( a )--\\-----\\--------( )( y )--+
|  /--\\  /--[ ]( $0b )--/  \\--/                  |
|     /--[ ]( c )--------/                     |
",
        expect![[r#"
            Remove the parallel branch with `b` (changes what the rung does)

            +--\--[ ]( a )--\----------------------------------------------------( )( y )--+
            |  /--[ ]( c )--/                                                              |
        "#]],
    );
    check(
        "Remove",
        "\
+--\\--[ ]( a )--------\\--------------( )( y )--+
|  /--\\--[ ]( $0b )--\\--/                        |
|     /--[ ]( c )--/                           |
",
        expect![[r#"
            Remove the parallel branch with `b` (changes what the rung does)

            +--\--[ ]( a )--\----------------------------------------------------( )( y )--+
            |  /--[ ]( c )--/                                                              |
        "#]],
    );
    titles(
        "+--[ ]( a )--[TON]( $0t, 5s )---------( )( run )--+\n",
        expect![[r#"
            Draw a parallel contact `new_contact_1` around `t` (no change while it is low)
            Wrap `t` in a branch, with a copy in parallel (changes nothing yet) -- [TON] has an effect or a memory, and a copy would have them once more
            Split the network before `t` (`split_1` carries the power)
            Declare the undeclared tags of the file
            Extract the network into the function `function_1`
        "#]],
    );
}

#[test]
fn no_line_of_comments_is_lost() {
    check(
        "Remove",
        r"
+--\--[ ]( start )--\--[/]( stop )----------( )( run )--+
# what holds it #
|  /--[ ]( $0run )----/                                |
",
        expect![[r#"
            Remove the parallel branch with `run` (changes what the rung does)


            # what holds it #
            +--[ ]( start )--[/]( stop )---------------------------------------( )( run )--+
        "#]],
    );
    check(
        "Split the network before",
        r"
+--\--[ ]( start )--[/]( $0stop )----------( )( run )--+
# nothing #
|  /----                                              |
",
        expect![[r#"
            Split the network before `stop` (`split_1` carries the power)


            +--\--[ ]( start )---------------------------------------------( )( split_1 )--+
            |  /--                                                                         |

            # nothing #
            +--[ ]( split_1 )--[/]( stop )-------------------------------------( )( run )--+
        "#]],
    );
}

//! Enter, in time and overtaken.

use super::{check, check_typed};
use expect_test::expect;

#[test]
fn enter_goes_on_with_the_rail() {
    check(
        "+--\\--[ ]( a )--\\--( )( y )--+\n$0",
        expect![[r#"
            +--\--[ ]( a )--\--( )( y )--+
            |  /--
        "#]],
    );
    check(
        "+--[ ]( ä )--\\--[ ]( b )--\\--( )( y )--+\n  $0\n",
        expect![[r#"
            +--[ ]( ä )--\--[ ]( b )--\--( )( y )--+
            |            /--

        "#]],
    );
    check(
        "+--\\--[ ]( a )--\\--( )( y )--+\n$0\n|  /--[ ]( b )--/            |\n",
        expect![[r#"
            +--\--[ ]( a )--\--( )( y )--+
            | ·
            |  /--[ ]( b )--/            |

        "#]],
    );
    check(
        "+--\\--[ ]( a )--\\--( )( y )--+\r\n|  |  |\r\n$0\r\n",
        expect![[r#"
            +--\--[ ]( a )--\--( )( y )--+
            |  |  |
            |  /--

        "#]],
    );
    check(
        "[ ]( b )--\\--[ ]( a )--\n$0\n",
        expect![[r#"
            [ ]( b )--\--[ ]( a )--
                      /--

        "#]],
    );
}

#[test]
fn enter_within_a_block_does_nothing() {
    check(
        "+--[ ]( run )--[TON\n$0]\n",
        expect![[r#"
        +--[ ]( run )--[TON]

    "#]],
    );
    check(
        "+--[ ]( run )--[TON]( t,\n    $0T#5s )--( )( y )--+\n",
        expect![[r#"
        +--[ ]( run )--[TON]( t,T#5s )--( )( y )--+

    "#]],
    );
    check(
        "+--[ ]( a\n$0",
        expect![[r#"
        +--[ ]( a
    "#]],
    );
    check(
        "+--<JMP\n$0>( l )\n",
        expect![[r#"
        +--<JMP>( l )

    "#]],
    );
}

#[test]
fn enter_outside_of_networks() {
    check(
        "+--[ ]( a )-( )( y )--+\n$0",
        expect![[r#"
            +--[ ]( a )----------------------------------------------------------( )( y )--+
            +--
        "#]],
    );
    check(
        "+--[ ]( a )-( )( y )--+\n\n$0\n",
        expect![[r#"
        nothing
    "#]],
    );
    check(
        "+--[ ]( a )\n$0--( )( y )--+\n",
        expect![[r#"
        nothing
    "#]],
    );
    check(
        "+--[ ]( a\n$0\n",
        expect![[r#"
            +--[ ]( a

        "#]],
    );
    check(
        "VAR\n$0\nEND_VAR\n",
        expect![[r#"
        VAR
           ·
        END_VAR

    "#]],
    );
    check(
        "VAR\n    a : INT;\n  $0\nEND_VAR\n",
        expect![[r#"
            VAR
                a : INT;
               ·
            END_VAR

        "#]],
    );
    check(
        "VAR\n    a : INT;\nEND_VAR\n$0\n",
        expect![[r#"
        nothing
    "#]],
    );
    check(
        "# comment\n$0\n #\n+-[ ]( a )-+\n",
        expect![[r#"
        nothing
    "#]],
    );
    check(
        "+--[ ]( a )--+  # open\n$0",
        expect![[r#"
        nothing
    "#]],
    );
    check(
        "\n$0",
        expect![[r#"
        nothing
    "#]],
    );
}

#[test]
fn enter_after_a_rung_begins_the_next() {
    check(
        "+--[ ]( a )--( )( y )--+\n$0\n\n+--[ ]( x )--( )( z )--+\n",
        expect![[r#"
            +--[ ]( a )----------------------------------------------------------( )( y )--+
            +--

            +--[ ]( x )--( )( z )--+

        "#]],
    );
    check(
        "+--\\--[ ]( a )--\\--( )( y )--+\n|  /--[ ]( b )--/            |\n$0",
        expect![[r#"
            +--\--[ ]( a )--\----------------------------------------------------( )( y )--+
            |  /--[ ]( b )--/                                                              |
            +--
        "#]],
    );
    // One between two that touch, and once more a line further down.
    check(
        "+--[ ]( a )------------------( )( y )--+\n$0\n+--[ ]( x )------------------( )( z )--+\n",
        expect![[r#"
            +--[ ]( a )----------------------------------------------------------( )( y )--+
            +--
            +--[ ]( x )------------------( )( z )--+

        "#]],
    );
    check(
        "+--[ ]( a )------------------( )( y )--+\n+--\n$0\n+--[ ]( x )------------------( )( z )--+\n",
        expect![[r#"
            +--[ ]( a )------------------( )( y )--+

            +--
            +--[ ]( x )------------------( )( z )--+

        "#]],
    );
    check(
        "+--\\--[ ]( a )--\\------------( )( y )--+\n|  /--[ ]( b )--/                      |\n$0\n+--[ ]( x )------------------( )( z )--+\n",
        expect![[r#"
            +--\--[ ]( a )--\----------------------------------------------------( )( y )--+
            |  /--[ ]( b )--/                                                              |
            +--
            +--[ ]( x )------------------( )( z )--+

        "#]],
    );
    // Nothing is known of rails.
    check(
        "--[ ]( a )--( )( y )--\n$0",
        expect![[r#"
        nothing
    "#]],
    );
    // Not finished.
    check(
        "+--[ ]( a )--\n$0",
        expect![[r#"
        nothing
    "#]],
    );
    // Again and again: a line further down, then not at all.
    check(
        "+--[ ]( a )------------------( )( y )--+\n+--\n$0",
        expect![[r#"
        +--[ ]( a )------------------( )( y )--+

        +--
    "#]],
    );
    check(
        "+--[ ]( a )------------------( )( y )--+\n\n+--\n$0",
        expect![[r#"
            +--[ ]( a )------------------( )( y )--+



        "#]],
    );
}

#[test]
fn enter_after_a_branch_leaves_the_rail_where_it_is() {
    const ROW: &str = "+--\\--[ ]( a )--\\--( )( y )--+\n|  /--[ ]( b )--/\n";
    check(
        &format!("{ROW}$0            |"),
        expect![[r#"
            +--\--[ ]( a )--\----------------------------------------------------( )( y )--+
            |  /--[ ]( b )--/                                                              |
            +--
        "#]],
    );
    check(
        &format!("{ROW}  $0          |\n\n+--[ ]( c )--( )( z )--+\n"),
        expect![[r#"
            +--\--[ ]( a )--\----------------------------------------------------( )( y )--+
            |  /--[ ]( b )--/                                                              |
            +--

            +--[ ]( c )--( )( z )--+

        "#]],
    );
    // Another branch is open.
    check(
        "+--\\--\\--[ ]( a )--\\--\\--( )( y )--+\n|  |  /--[ ]( b )--/\n$0      |\n",
        expect![[r#"
            nothing
        "#]],
    );
    // A rail that the user draws.
    check(
        &format!("{ROW}|\n$0|\n"),
        expect![[r#"
            nothing
        "#]],
    );
}

#[test]
fn an_enter_that_was_overtaken_is_asked_about_again() {
    const RUNG: &str = "+--[ ]( a )------------------( )( y )--+\n";
    // What was begun on the line above is not wanted.
    check_typed(
        &format!("{RUNG}+--\n# why$0\n{RUNG}"),
        '\n',
        expect![[r#"
            +--[ ]( a )------------------( )( y )--+

            # why
            +--[ ]( a )------------------( )( y )--+

        "#]],
    );
    check_typed(
        &format!("{RUNG}+--# why #\n+--[ ]( b )$0"),
        '\n',
        expect![[r#"
            +--[ ]( a )------------------( )( y )--+
            # why #
            +--[ ]( b )
        "#]],
    );
    check_typed(
        "+--\\--[ ]( a )--\\--( )( y )--+\n|  /--|  /--[ ]( b )--/\n+--[ ]( c )$0",
        '\n',
        expect![[r#"
            +--\--[ ]( a )--\--( )( y )--+
            |  /--[ ]( b )--/
            +--[ ]( c )
        "#]],
    );
    // The network above is drawn again, and nothing is begun.
    check_typed(
        "+-[ ]( a )-( )( y )-+\n# why #$0",
        '\n',
        expect![[r#"
            +--[ ]( a )----------------------------------------------------------( )( y )--+
            # why #
        "#]],
    );
    check_typed(
        "# open\n+--\n+--[ ]( b )$0",
        '\n',
        expect![[r#"
            nothing
        "#]],
    );
    // A rail that the user draws is not one that was begun.
    check_typed(
        "+--\\--[ ]( a )--\\--( )( y )--+\n|  $0",
        '\n',
        expect![[r#"
            nothing
        "#]],
    );
    // A rung that was begun by hand, and a line that an editor has indented.
    check_typed(
        &format!("{RUNG}+--\n  $0[ ]( b )--( )( y )--+\n"),
        '\n',
        expect![[r#"
            nothing
        "#]],
    );
}

#[test]
fn the_end_of_a_structure_finds_its_column() {
    check(
        "TYPE\n    Motor : STRUCT\n        speed : INT;\n        END_STRUCT;$0\nEND_TYPE\n",
        expect![[r#"
            TYPE
                Motor : STRUCT
                    speed : INT;
                END_STRUCT;
            END_TYPE

        "#]],
    );
    check(
        "TYPE\n    Motor : STRUCT\n        speed : INT;\n        END_STRUCT;\n$0        \nEND_TYPE\n",
        expect![[r#"
            TYPE
                Motor : STRUCT
                    speed : INT;
                END_STRUCT;
               ·
            END_TYPE

        "#]],
    );
    check(
        "TYPE\n    Motor : STRUCT\n        speed : INT;$0\n    END_STRUCT;\nEND_TYPE\n",
        expect![[r#"
            nothing
        "#]],
    );
}

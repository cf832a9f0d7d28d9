//! What was begun, typed once more.

use super::check;
use expect_test::expect;

#[test]
fn what_enter_has_begun_is_typed_once_more() {
    const RUNG: &str = "+--[ ]( a )------------------( )( y )--+\n";
    const BRANCH: &str = "+--\\--[ ]( a )--\\--( )( y )--+\n";
    check(
        &format!("{RUNG}+--+$0"),
        expect![[r#"
            +--[ ]( a )------------------( )( y )--+
            +
        "#]],
    );
    check(
        &format!("{RUNG}+--+$0\n\n{RUNG}"),
        expect![[r#"
            +--[ ]( a )------------------( )( y )--+
            +

            +--[ ]( a )------------------( )( y )--+

        "#]],
    );
    check(
        &format!("{RUNG}\n+--#$0\n{RUNG}"),
        expect![[r#"
        +--[ ]( a )------------------( )( y )--+

        #
        +--[ ]( a )------------------( )( y )--+

    "#]],
    );
    check(
        &format!("{BRANCH}|  /--|$0"),
        expect![[r#"
            +--\--[ ]( a )--\--( )( y )--+
            |
        "#]],
    );
    // Another rung, to whose end the branch comes down.
    check(
        &format!("{BRANCH}|  /--+$0"),
        expect![[r#"
            +--\--[ ]( a )--\--( )( y )--+
            +
        "#]],
    );
    check(
        &format!("{BRANCH}|  /--  /$0"),
        expect![[r#"
            +--\--[ ]( a )--\--( )( y )--+
            |  /
        "#]],
    );
    check(
        &format!("{RUNG}+--E$0"),
        expect![[r#"
        +--[ ]( a )------------------( )( y )--+
        E
    "#]],
    );
    check(
        &format!("VAR\n    a : BOOL;\n    END_VAR\n$0\n{RUNG}"),
        expect![[r#"
        VAR
            a : BOOL;
        END_VAR

        +--[ ]( a )------------------( )( y )--+

    "#]],
    );
    // The editor has taken the indent of the line above along.
    check(
        &format!("VAR\n    a : BOOL;\n    END_VAR\n    $0\n{RUNG}"),
        expect![[r#"
            VAR
                a : BOOL;
            END_VAR

            +--[ ]( a )------------------( )( y )--+

        "#]],
    );
    check(
        &format!("  VAR\n$0\n{RUNG}"),
        expect![[r#"
        VAR
           ·
        +--[ ]( a )------------------( )( y )--+

    "#]],
    );
    // A row that only leads past.
    check(
        &format!("{BRANCH}|  /--  |$0"),
        expect![[r#"
        +--\--[ ]( a )--\--( )( y )--+
        |  |
    "#]],
    );
    // A user types faster than the answers come.
    check(
        &format!("{RUNG}+--+--[ ]( b )$0"),
        expect![[r#"
        +--[ ]( a )------------------( )( y )--+
        +--[ ]( b )
    "#]],
    );
    check(
        &format!("{BRANCH}|  /--|  /--[ ]( b )$0"),
        expect![[r#"
        +--\--[ ]( a )--\--( )( y )--+
        |  /--[ ]( b )
    "#]],
    );
    check(
        &format!("{RUNG}\n+--# why #$0\n{RUNG}"),
        expect![[r#"
        +--[ ]( a )------------------( )( y )--+

        # why #
        +--[ ]( a )------------------( )( y )--+

    "#]],
    );
    // None of that after something else, or in front of it.
    check(
        &format!("{RUNG}+---+$0"),
        expect![[r#"
            +--[ ]( a )------------------( )( y )--+
            +------------------------------------------------------------------------------+
        "#]],
    );
    check(
        &format!("{RUNG}+--+$0--( )( y )--+"),
        expect![[r#"
            +--[ ]( a )------------------( )( y )--+
            +--+-----------------------------------------------------------------( )( y )--+
        "#]],
    );
    check(
        &format!("{BRANCH}|  /--[ ]( b )|$0"),
        expect![[r#"
        nothing
    "#]],
    );
    check(
        &format!("# in a comment\n+--+$0\n#\n{RUNG}"),
        expect![[r#"
        nothing
    "#]],
    );
}

#[test]
fn the_right_rail_is_there_already() {
    check(
        "+--[ ]( a )--( )( y )--+-+$0\n",
        expect![[r#"
        +--[ ]( a )--( )( y )--+

    "#]],
    );
    check(
        "+--[ ]( a )--( )( y )--+--+$0\n",
        expect![[r#"
        +--[ ]( a )--( )( y )--+

    "#]],
    );
    check(
        "+--[ ]( a )--( )( y )--++$0\n",
        expect![[r#"
        +--[ ]( a )--( )( y )--+

    "#]],
    );
    check(
        "+--[ ]( a )--( )( y )--+--$0\n",
        expect![[r#"
        nothing
    "#]],
    );
}

//! Branches: beside something, taken out again, that end by themselves, and whose ends move.

use super::{below, check, delete, insert, moved};
use crate::redraw::Change;
use expect_test::expect;
use ladder_syntax::{TextRange, TextSize};

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

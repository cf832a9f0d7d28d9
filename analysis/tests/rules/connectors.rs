//! Connectors without a partner.

use crate::check::{check, clean};
use expect_test::expect;

#[test]
fn nothing_below_or_above() {
    check(
        "+--[ ]( a )--\\--( )( y )--+\n",
        expect![[r#"
            > +--[ ]( a )--\--( )( y )--+
                           ^ error[unpaired-connector]: the `\` on line 1 has no partner: there is no rung below it
                help: every `\` needs a `/` on the rung below: together they join the two lines
                fix: Replace `\` with wire
                  +--[ ]( a )----------------------------------------------------------( )( y )--+
        "#]],
    );
    check(
        "+--[ ]( a )--( )( y )--+\n|  /--[ ]( b )--\n",
        expect![[r#"
            > |  /--[ ]( b )--
                 ^ error[unpaired-connector]: the `/` on line 2 has no partner: line 1 above it has no `\`
                help: every `/` needs a `\` on the rung above: together they join the two lines
                at 1:1 `+--[ ]( a )--( )( y )--+`: its partner `\` belongs onto this rung
                fix: Draw `\` above it
                  +--\--[ ]( a )-------------------------------------------------------( )( y )--+
                  |  /--[ ]( b )--                                                               |
        "#]],
    );
    check(
        "+--\\--[ ]( a )--\\--( )( y )--+\n|  ---[ ]( b )---            |\n",
        expect![[r#"
            > +--\--[ ]( a )--\--( )( y )--+
                 ^ error[unpaired-connector]: the 1st `\` on line 1 has no partner: line 2 below it has no `/`
                help: every `\` needs a `/` on the rung below: together they join the two lines
                at 2:1 `|  ---[ ]( b )---            |`: its partner `/` belongs onto this rung
                fix: Close the branch with `/`
                  |  /--[ ]( b )---            |
            > +--\--[ ]( a )--\--( )( y )--+
                              ^ error[unpaired-connector]: the 2nd `\` on line 1 has no partner: line 2 below it has no `/`
                help: every `\` needs a `/` on the rung below: together they join the two lines
                at 2:1 `|  ---[ ]( b )---            |`: its partner `/` belongs onto this rung
                fix: Close the branch with `/`
                  |  ---[ ]( b )--/            |
        "#]],
    );
}

#[test]
fn one_too_many() {
    check(
        "+--\\--[ ]( a )--\\--( )( y )--+\n|  /--[ ]( b )---            |\n",
        expect![[r#"
            > +--\--[ ]( a )--\--( )( y )--+
                              ^ error[unpaired-connector]: the 2nd `\` on line 1 has no partner: line 1 has 2 `\`, line 2 below it has 1 `/`
                help: every `\` needs a `/` on the rung below: together they join the two lines
                at 2:1 `|  /--[ ]( b )---            |`: its partner `/` belongs onto this rung
                fix: Close the branch with `/`
                  +--\--[ ]( a )--\----------------------------------------------------( )( y )--+
                  |  /--[ ]( b )--/                                                              |
        "#]],
    );
    // The columns say that the first one lacks its partner, the order says it is the second.
    check(
        "+--\\--[ ]( a )--\\--( )( y )--+\n|  ---[ ]( b )--/            |\n",
        expect![[r#"
            > +--\--[ ]( a )--\--( )( y )--+
                              ^ error[unpaired-connector]: the 2nd `\` on line 1 has no partner: line 1 has 2 `\`, line 2 below it has 1 `/`
                help: connectors pair in their order from left to right, whatever their columns: the partner is probably missing at the 1st `\`
                at 1:4 `\`: no `/` is below this `\`
                at 2:1 `|  ---[ ]( b )--/            |`: its partner `/` belongs onto this rung
                fix: Close the branch with `/`
                  +--\--[ ]( a )--\----------------------------------------------------( )( y )--+
                  |  /--[ ]( b )--/                                                              |
        "#]],
    );
    check(
        "+-----[ ]( a )--\\--( )( y )--+\n|  /--[ ]( b )--/            |\n",
        expect![[r#"
            > |  /--[ ]( b )--/            |
                              ^ error[unpaired-connector]: the 2nd `/` on line 2 has no partner: line 2 has 2 `/`, line 1 above it has 1 `\`
                help: connectors pair in their order from left to right, whatever their columns: the partner is probably missing at the 1st `/`
                at 2:4 `/`: no `\` is above this `/`
                at 1:1 `+-----[ ]( a )--\--( )( y )--+`: its partner `\` belongs onto this rung
                fix: Join with `\` above it
                  +--\--[ ]( a )--\----------------------------------------------------( )( y )--+
                  |  /--[ ]( b )--/                                                              |
        "#]],
    );
}

#[test]
fn in_the_middle_of_three() {
    check(
        "+--\\--[ ]( a )-----\\--( )( y )--+\n|  /--\\--[ ]( b )--/            |\n|     /--[ ]( c )--/            |\n",
        expect![[r#"
            > |     /--[ ]( c )--/            |
                                 ^ error[unpaired-connector]: the 2nd `/` on line 3 has no partner: line 3 has 2 `/`, line 2 above it has 1 `\`
                help: every `/` needs a `\` on the rung above: together they join the two lines
                at 2:1 `|  /--\--[ ]( b )--/            |`: its partner `\` belongs onto this rung
                fix: Draw `\` above it
                  +--\--[ ]( a )--------\----------------------------------------------( )( y )--+
                  |  /--\--[ ]( b )--\--/                                                        |
                  |     /--[ ]( c )--/                                                           |
        "#]],
    );
}

#[test]
fn no_other_rule_follows() {
    // Without its partner the branch has no power: that is the same error.
    check(
        "+--[ ]( a )--\\--( )( y )--+\n|                         |\n|            ---( )( z )--+\n",
        expect![[r#"
            > +--[ ]( a )--\--( )( y )--+
                           ^ error[unpaired-connector]: the `\` on line 1 has no partner: line 3 below it has no `/`
                help: every `\` needs a `/` on the rung below: together they join the two lines
                at 3:1 `|            ---( )( z )--+`: its partner `/` belongs onto this rung
                fix: Close the branch with `/`
                  +--[ ]( a )--\-------------------------------------------------------( )( y )--+
                  |            |                                                                 |
                  |            /-------------------------------------------------------( )( z )--+
        "#]],
    );
    check(
        "+--[ ]( a --\\--( )( y )--+\n",
        expect![[r#"
            > +--[ ]( a --\--( )( y )--+
                    ^^^^ error[unclosed-block]: `( a` is not closed: `)` is missing
                help: a block is closed on its own line
                safe fix: Insert `)`
                  +--[ ]( a )--\--( )( y )--+
        "#]],
    );
}

#[test]
fn what_is_drawn_is_completed() {
    // Drawn in a hurry: the columns do not fit.
    check(
        "+-\\-[ ]( start )-\\-[/]( stop )-( )( run )-+\n|  -[ ]( run )-/\n",
        expect![[r#"
            > +-\-[ ]( start )-\-[/]( stop )-( )( run )-+
                               ^ error[unpaired-connector]: the 2nd `\` on line 1 has no partner: line 1 has 2 `\`, line 2 below it has 1 `/`
                help: connectors pair in their order from left to right, whatever their columns: the partner is probably missing at the 1st `\`
                at 1:3 `\`: no `/` is below this `\`
                at 2:1 `|  -[ ]( run )-/`: its partner `/` belongs onto this rung
                fix: Close the branch with `/`
                  +--\--[ ]( start )--\--[/]( stop )---------------------------------( )( run )--+
                  |  /--[ ]( run )----/                                                          |
        "#]],
    );
    // The closing one is forgotten: after wire, after a block, too far away.
    check(
        "+--\\--[ ]( start )--\\--[/]( stop )--( )( run )--+\n|  /--[ ]( run )----   |\n",
        expect![[r#"
            > +--\--[ ]( start )--\--[/]( stop )--( )( run )--+
                                  ^ error[unpaired-connector]: the 2nd `\` on line 1 has no partner: line 1 has 2 `\`, line 2 below it has 1 `/`
                help: every `\` needs a `/` on the rung below: together they join the two lines
                at 2:1 `|  /--[ ]( run )----   |`: its partner `/` belongs onto this rung
                fix: Close the branch with `/`
                  +--\--[ ]( start )--\--[/]( stop )---------------------------------( )( run )--+
                  |  /--[ ]( run )----/                                                          |
        "#]],
    );
    check(
        "+--\\--[ ]( start )--\\--[/]( stop )--( )( run )--+\n|  /--[ ]( run )--     |\n",
        expect![[r#"
            > +--\--[ ]( start )--\--[/]( stop )--( )( run )--+
                                  ^ error[unpaired-connector]: the 2nd `\` on line 1 has no partner: line 1 has 2 `\`, line 2 below it has 1 `/`
                help: every `\` needs a `/` on the rung below: together they join the two lines
                at 2:1 `|  /--[ ]( run )--     |`: its partner `/` belongs onto this rung
                fix: Close the branch with `/`
                  +--\--[ ]( start )--\--[/]( stop )---------------------------------( )( run )--+
                  |  /--[ ]( run )----/                                                          |
        "#]],
    );
    check(
        "+--\\--[ ]( start )--\\--[/]( stop )--( )( run )--+\n|  /--[ ]( run )       |\n",
        expect![[r#"
            > +--\--[ ]( start )--\--[/]( stop )--( )( run )--+
                                  ^ error[unpaired-connector]: the 2nd `\` on line 1 has no partner: line 1 has 2 `\`, line 2 below it has 1 `/`
                help: every `\` needs a `/` on the rung below: together they join the two lines
                at 2:1 `|  /--[ ]( run )       |`: its partner `/` belongs onto this rung
                fix: Close the branch with `/`
                  +--\--[ ]( start )--\--[/]( stop )---------------------------------( )( run )--+
                  |  /--[ ]( run )----/                                                          |
        "#]],
    );
    // One is forgotten above.
    check(
        "+-----[ ]( start )--\\--[/]( stop )--( )( run )--+\n|  /--[ ]( run )----/\n",
        expect![[r#"
            > |  /--[ ]( run )----/
                                  ^ error[unpaired-connector]: the 2nd `/` on line 2 has no partner: line 2 has 2 `/`, line 1 above it has 1 `\`
                help: connectors pair in their order from left to right, whatever their columns: the partner is probably missing at the 1st `/`
                at 2:4 `/`: no `\` is above this `/`
                at 1:1 `+-----[ ]( start )--\--[/]( stop )--( )( run )--+`: its partner `\` belongs onto this rung
                fix: Join with `\` above it
                  +--\--[ ]( start )--\--[/]( stop )---------------------------------( )( run )--+
                  |  /--[ ]( run )----/                                                          |
        "#]],
    );
    check(
        "+--[ ]( x )--( )( z )--+\n\n  --[ ]( a )--\n  /--[ ]( b )--/\n",
        expect![[r#"
            >   /--[ ]( b )--/
                ^ error[unpaired-connector]: the 1st `/` on line 4 has no partner: line 3 above it has no `\`
                help: every `/` needs a `\` on the rung above: together they join the two lines
                at 3:3 `--[ ]( a )--`: its partner `\` belongs onto this rung
                fix: Close the branch with `\`
                    \-[ ]( a )--
            >   /--[ ]( b )--/
                             ^ error[unpaired-connector]: the 2nd `/` on line 4 has no partner: line 3 above it has no `\`
                help: every `/` needs a `\` on the rung above: together they join the two lines
                at 3:3 `--[ ]( a )--`: its partner `\` belongs onto this rung
                fix: Close the branch with `\`
                    --[ ]( a )--\
        "#]],
    );
}

#[test]
fn swapped_connectors() {
    check(
        "+--/--[ ]( start )--\\--[/]( stop )--( )( run )--+\n|  \\--[ ]( run )----/\n",
        expect![[r#"
            > +--/--[ ]( start )--\--[/]( stop )--( )( run )--+
                 ^ error[unpaired-connector]: the `/` on line 1 has no partner: there is no rung above it
                help: every `/` needs a `\` on the rung above: together they join the two lines
                fix: Swap `/` and `\`
                  +--\--[ ]( start )--\--[/]( stop )---------------------------------( )( run )--+
                  |  /--[ ]( run )----/                                                          |
            > |  \--[ ]( run )----/
                 ^ error[unpaired-connector]: the `\` on line 2 has no partner: there is no rung below it
                help: every `\` needs a `/` on the rung below: together they join the two lines
                fix: Swap `/` and `\`
                  +--\--[ ]( start )--\--[/]( stop )---------------------------------( )( run )--+
                  |  /--[ ]( run )----/                                                          |
        "#]],
    );
    check(
        "+--\\--[ ]( start )--/--[/]( stop )--( )( run )--+\n|  /--[ ]( run )----\\\n",
        expect![[r#"
            > +--\--[ ]( start )--/--[/]( stop )--( )( run )--+
                                  ^ error[unpaired-connector]: the `/` on line 1 has no partner: there is no rung above it
                help: every `/` needs a `\` on the rung above: together they join the two lines
                fix: Swap `/` and `\`
                  +--\--[ ]( start )--\--[/]( stop )---------------------------------( )( run )--+
                  |  /--[ ]( run )----/                                                          |
            > |  /--[ ]( run )----\
                                  ^ error[unpaired-connector]: the `\` on line 2 has no partner: there is no rung below it
                help: every `\` needs a `/` on the rung below: together they join the two lines
                fix: Swap `/` and `\`
                  +--\--[ ]( start )--\--[/]( stop )---------------------------------( )( run )--+
                  |  /--[ ]( run )----/                                                          |
        "#]],
    );
    // One of a pair leans the wrong way.
    check(
        "+--\\--[ ]( start )--\\--[/]( stop )--( )( run )--+\n|  \\--[ ]( run )----/\n",
        expect![[r#"
            > +--\--[ ]( start )--\--[/]( stop )--( )( run )--+
                                  ^ error[unpaired-connector]: the 2nd `\` on line 1 has no partner: line 1 has 2 `\`, line 2 below it has 1 `/`
                help: connectors pair in their order from left to right, whatever their columns: the partner is probably missing at the 1st `\`
                at 1:4 `\`: no `/` is below this `\`
                at 2:1 `|  \--[ ]( run )----/`: its partner `/` belongs onto this rung
                fix: Replace `\` with `/`
                  +--\--[ ]( start )--\--[/]( stop )---------------------------------( )( run )--+
                  |  /--[ ]( run )----/                                                          |
            > |  \--[ ]( run )----/
                 ^ error[unpaired-connector]: the `\` on line 2 has no partner: there is no rung below it
                help: every `\` needs a `/` on the rung below: together they join the two lines
                fix: Replace `\` with `/`
                  +--\--[ ]( start )--\--[/]( stop )---------------------------------( )( run )--+
                  |  /--[ ]( run )----/                                                          |
        "#]],
    );
    check(
        "+--/--[ ]( start )--\\--[/]( stop )--( )( run )--+\n|  /--[ ]( run )----/\n",
        expect![[r#"
            > +--/--[ ]( start )--\--[/]( stop )--( )( run )--+
                 ^ error[unpaired-connector]: the `/` on line 1 has no partner: there is no rung above it
                help: every `/` needs a `\` on the rung above: together they join the two lines
                fix: Replace `/` with `\`
                  +--\--[ ]( start )--\--[/]( stop )---------------------------------( )( run )--+
                  |  /--[ ]( run )----/                                                          |
            > |  /--[ ]( run )----/
                                  ^ error[unpaired-connector]: the 2nd `/` on line 2 has no partner: line 2 has 2 `/`, line 1 above it has 1 `\`
                help: connectors pair in their order from left to right, whatever their columns: the partner is probably missing at the 1st `/`
                at 2:4 `/`: no `\` is above this `/`
                at 1:1 `+--/--[ ]( start )--\--[/]( stop )--( )( run )--+`: its partner `\` belongs onto this rung
                fix: Replace `/` with `\`
                  +--\--[ ]( start )--\--[/]( stop )---------------------------------( )( run )--+
                  |  /--[ ]( run )----/                                                          |
        "#]],
    );
}

#[test]
fn a_rail_in_the_place_of_a_connector() {
    check(
        "+--\\--[ ]( start )--\\--[/]( stop )--( )( run )--+\n|  |--[ ]( run )----/                          |\n",
        expect![[r#"
            > +--\--[ ]( start )--\--[/]( stop )--( )( run )--+
                                  ^ error[unpaired-connector]: the 2nd `\` on line 1 has no partner: line 1 has 2 `\`, line 2 below it has 1 `/`
                help: connectors pair in their order from left to right, whatever their columns: the partner is probably missing at the 1st `\`
                at 1:4 `\`: no `/` is below this `\`
                at 2:1 `|  |--[ ]( run )----/                          |`: its partner `/` belongs onto this rung
                fix: Replace `|` with `/`
                  +--\--[ ]( start )--\--[/]( stop )---------------------------------( )( run )--+
                  |  /--[ ]( run )----/                                                          |
                fix: Close the branch with `/`
                  +--\--[ ]( start )--\--[/]( stop )---------------------------------( )( run )--+
                  |  /--[ ]( run )----/                                                          |
        "#]],
    );
    check(
        "+--\\--[ ]( start )--\\--[/]( stop )--( )( run )--+\n|  /--[ ]( run )----|                          |\n",
        expect![[r#"
            > +--\--[ ]( start )--\--[/]( stop )--( )( run )--+
                                  ^ error[unpaired-connector]: the 2nd `\` on line 1 has no partner: line 1 has 2 `\`, line 2 below it has 1 `/`
                help: every `\` needs a `/` on the rung below: together they join the two lines
                at 2:1 `|  /--[ ]( run )----|                          |`: its partner `/` belongs onto this rung
                fix: Replace `|` with `/`
                  +--\--[ ]( start )--\--[/]( stop )---------------------------------( )( run )--+
                  |  /--[ ]( run )----/                                                          |
                fix: Close the branch with `/`
                  +--\--[ ]( start )--\--[/]( stop )---------------------------------( )( run )--+
                  |  /--[ ]( run )----/                                                          |
        "#]],
    );
    check(
        "+--\\--[ ]( start )--\\--[/]( stop )--( )( run )--+\n|  /--[ ]( run )----+                          |\n",
        expect![[r#"
            > +--\--[ ]( start )--\--[/]( stop )--( )( run )--+
                                  ^ error[unpaired-connector]: the 2nd `\` on line 1 has no partner: line 1 has 2 `\`, line 2 below it has 1 `/`
                help: every `\` needs a `/` on the rung below: together they join the two lines
                at 2:1 `|  /--[ ]( run )----+                          |`: its partner `/` belongs onto this rung
                fix: Replace `+` with `/`
                  +--\--[ ]( start )--\--[/]( stop )---------------------------------( )( run )--+
                  |  /--[ ]( run )----/                                                          |
        "#]],
    );
    check(
        "+--\\--[ ]( start )--|--[/]( stop )--( )( run )--+\n|  /--[ ]( run )----/                          |\n",
        expect![[r#"
            > +--\--[ ]( start )--|--[/]( stop )--( )( run )--+
                                  ^ error[misplaced-rail]: `|` cuts the wire
                help: `|` only draws the rails and verticals; lines are joined with \ and /
                fix: Replace with `\`
                  +--\--[ ]( start )--\--[/]( stop )---------------------------------( )( run )--+
                  |  /--[ ]( run )----/                                                          |
            > |  /--[ ]( run )----/                          |
                                  ^ error[unpaired-connector]: the 2nd `/` on line 2 has no partner: line 2 has 2 `/`, line 1 above it has 1 `\`
                help: every `/` needs a `\` on the rung above: together they join the two lines
                at 1:1 `+--\--[ ]( start )--|--[/]( stop )--( )( run )--+`: its partner `\` belongs onto this rung
                fix: Replace `|` with `\`
                  +--\--[ ]( start )--\--[/]( stop )---------------------------------( )( run )--+
                  |  /--[ ]( run )----/                                                          |
                fix: Close the branch with `\`
                  +--\--[ ]( start )--\--|--[/]( stop )------------------------------( )( run )--+
                  |  /--[ ]( run )----/                                                          |
        "#]],
    );
    check(
        "+--+--[ ]( start )--+--[/]( stop )--( )( run )--+\n|  /--[ ]( run )----/                          |\n",
        expect![[r#"
            > +--+--[ ]( start )--+--[/]( stop )--( )( run )--+
                 ^ error[misplaced-rail]: `+` is in the middle of a line
                help: `+` is where a line leaves the left rail or ends at the right rail; lines are joined with \ and /
                fix: Replace with `\`
                  +--\--[ ]( start )--+--[/]( stop )--( )( run )--+
            > +--+--[ ]( start )--+--[/]( stop )--( )( run )--+
                                  ^ error[misplaced-rail]: `+` is in the middle of a line
                help: `+` is where a line leaves the left rail or ends at the right rail; lines are joined with \ and /
                fix: Replace with `\`
                  +--+--[ ]( start )--\--[/]( stop )--( )( run )--+
            > |  /--[ ]( run )----/                          |
                 ^ error[unpaired-connector]: the 1st `/` on line 2 has no partner: line 1 above it has no `\`
                help: every `/` needs a `\` on the rung above: together they join the two lines
                at 1:1 `+--+--[ ]( start )--+--[/]( stop )--( )( run )--+`: its partner `\` belongs onto this rung
                fix: Replace `+` with `\`
                  +--\--[ ]( start )--+--[/]( stop )--( )( run )--+
            > |  /--[ ]( run )----/                          |
                                  ^ error[unpaired-connector]: the 2nd `/` on line 2 has no partner: line 1 above it has no `\`
                help: every `/` needs a `\` on the rung above: together they join the two lines
                at 1:1 `+--+--[ ]( start )--+--[/]( stop )--( )( run )--+`: its partner `\` belongs onto this rung
                fix: Replace `+` with `\`
                  +--+--[ ]( start )--\--[/]( stop )--( )( run )--+
        "#]],
    );
    // The right rail is not a connector.
    check(
        "+--[ ]( a )--\\-+\n\n+--[ ]( b )--( )( z )--+\n",
        expect![[r#"
            > +--[ ]( a )--\-+
                           ^ error[unpaired-connector]: the `\` on line 1 has no partner: line 3 below it has no `/`
                help: every `\` needs a `/` on the rung below: together they join the two lines
                at 3:1 `+--[ ]( b )--( )( z )--+`: its partner `/` belongs onto this rung
                fix: Replace `\` with wire
                  +--[ ]( a )--------------------------------------------------------------------+
        "#]],
    );
}

#[test]
fn pairs() {
    clean("+--\\--[ ]( a )--\\--( )( y )--+\n|  /--[ ]( b )--/            |\n");
    // Columns do not matter.
    clean("+--\\--[ ]( a )--\\--( )( y )--+\n|     /--[ ]( b )--/            |\n");
}

#[test]
fn a_connector_is_drawn_where_a_block_is_in_its_column() {
    check(
        r"
+--[ ]( b )--\--[ ]( a )--( )( y )--+
|            /--[ ]( long_name )--/  |

+--[ ]( a )--( )( y )--+
|  /--[ ]( c )--/      |

+--[ ]( b )--\--[ ]( long_name )--\--( )( y )--+
|            /--[ ]( a )--( )( z )-----------+
",
        expect![[r#"
            > |            /--[ ]( long_name )--/  |
                                                ^ error[unpaired-connector]: the 2nd `/` on line 3 has no partner: line 3 has 2 `/`, line 2 above it has 1 `\`
                help: every `/` needs a `\` on the rung above: together they join the two lines
                at 2:1 `+--[ ]( b )--\--[ ]( a )--( )( y )--+`: its partner `\` belongs onto this rung
                fix: Replace `+` with `\`
                  +--[ ]( b )--\--[ ]( a )--( )( y )--\
                  |            /--[ ]( long_name )----/
                fix: Join with `\` above it
                  +--[ ]( b )--\--[ ]( a )------------------------------------------( )( y )--\--+
                  |            /--[ ]( long_name )--------------------------------------------/  |
            > |  /--[ ]( c )--/      |
                 ^ error[unpaired-connector]: the 1st `/` on line 6 has no partner: line 5 above it has no `\`
                help: every `/` needs a `\` on the rung above: together they join the two lines
                at 5:1 `+--[ ]( a )--( )( y )--+`: its partner `\` belongs onto this rung
                fix: Draw `\` above it
                  +--\--[ ]( a )--( )( y )--+
            > |  /--[ ]( c )--/      |
                              ^ error[unpaired-connector]: the 2nd `/` on line 6 has no partner: line 5 above it has no `\`
                help: every `/` needs a `\` on the rung above: together they join the two lines
                at 5:1 `+--[ ]( a )--( )( y )--+`: its partner `\` belongs onto this rung
                fix: Draw `\` above it
                  +--[ ]( a )--\--( )( y )--+
            > +--[ ]( b )--\--[ ]( long_name )--\--( )( y )--+
                                                ^ error[unpaired-connector]: the 2nd `\` on line 8 has no partner: line 8 has 2 `\`, line 9 below it has 1 `/`
                help: every `\` needs a `/` on the rung below: together they join the two lines
                at 9:1 `|            /--[ ]( a )--( )( z )-----------+`: its partner `/` belongs onto this rung
                fix: Join with `/` below it
                  +--[ ]( b )--\--[ ]( long_name )----------------------------------\--( )( y )--+
                  |            /--[ ]( a )--------------------------------( )( z )--/------------+
        "#]],
    );
}

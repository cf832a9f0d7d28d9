//! Power that cannot come, and networks that do nothing.

use crate::check::{check, clean};
use expect_test::expect;

#[test]
fn blank_cuts_the_wire() {
    check(
        "+--[ ]( a )--  --( )( y )--+\n",
        expect![[r#"
            > +--[ ]( a )--  --( )( y )--+
                           ^^ error[open-wire]: the wire is cut here: no power can reach what is after
                help: a blank or a `|` breaks a wire: draw it through with `-`
                fix: Join the wire
                  +--[ ]( a )----------------------------------------------------------( )( y )--+
        "#]],
    );
    check(
        "+--[ ]( a )-- | --( )( y )--+\n",
        expect![[r#"
            > +--[ ]( a )-- | --( )( y )--+
                           ^^^ error[open-wire]: the wire is cut here: no power can reach what is after
                help: a blank or a `|` breaks a wire: draw it through with `-`
        "#]],
    );
    check(
        "+--[ ]( a )-- # oil # --( )( y )--+\n",
        expect![[r#"
            > +--[ ]( a )-- # oil # --( )( y )--+
                           ^^^^^^^^^ error[open-wire]: the wire is cut here: no power can reach what is after
                help: a blank or a `|` breaks a wire: draw it through with `-`
                fix: Join the wire
                  +--[ ]( a )--# oil #-------------------------------------------------( )( y )--+
        "#]],
    );
    check(
        "+--[ ]( a )--( )( y ) +\n",
        expect![[r#"
            > +--[ ]( a )--( )( y ) +
                                   ^ error[open-wire]: the wire is cut here: no power can reach what is after
                help: a blank or a `|` breaks a wire: draw it through with `-`
                safe fix: Join the wire
                  +--[ ]( a )----------------------------------------------------------( )( y )--+
        "#]],
    );
    check(
        "+--\\--[ ]( a )--\\-----( )( y )--+\n|  /-- [ ]( b )--/            |\n",
        expect![[r#"
            > |  /-- [ ]( b )--/            |
                    ^ error[open-wire]: the wire is cut here: no power can reach what is after
                help: a blank or a `|` breaks a wire: draw it through with `-`
                safe fix: Join the wire
                  +--\--[ ]( a )--\----------------------------------------------------( )( y )--+
                  |  /--[ ]( b )--/                                                              |
        "#]],
    );
}

#[test]
fn line_without_a_beginning() {
    check(
        "--[ ]( a )--( )( y )--+\n",
        expect![[r#"
            > --[ ]( a )--( )( y )--+
              ^^^^^^^^^^^^^^^^^^^^^^^ warning[rung-not-powered]: this rung gets no power: it does not begin with `+`, which takes power from the left rail
                help: begin the line with `+`; a `|` there is decoration
                fix: Begin at the left rail
                  +--[ ]( a )----------------------------------------------------------( )( y )--+
        "#]],
    );
    check(
        "|--[ ]( a )--( )( y )--+\n",
        expect![[r#"
            > |--[ ]( a )--( )( y )--+
               ^^^^^^^^^^^^^^^^^^^^^^^ warning[rung-not-powered]: this rung gets no power: it does not begin with `+`, which takes power from the left rail
                help: begin the line with `+`; a `|` there is decoration
                fix: Begin at the left rail
                  +--[ ]( a )----------------------------------------------------------( )( y )--+
        "#]],
    );
    check(
        "[ ]( a )--( )( y )--+\n",
        expect![[r#"
            > [ ]( a )--( )( y )--+
              ^^^^^^^^^^^^^^^^^^^^^ warning[rung-not-powered]: this rung gets no power: it does not begin with `+`, which takes power from the left rail
                help: begin the line with `+`; a `|` there is decoration
                fix: Begin at the left rail
                  +--[ ]( a )----------------------------------------------------------( )( y )--+
        "#]],
    );
    check(
        "+--[ ]( a )-------\\--( )( y )--+\n|  --[ ]( b )-----/             |\n",
        expect![[r#"
            > |  --[ ]( b )-----/             |
                 ^^^^^^^^^^^^^^^ error[open-wire]: no power can reach this wire: it begins neither at the left rail nor at a connector
                help: begin the line with `+`, or join it to the line above with \ and /
                fix: Begin at the left rail
                  +--[ ]( a )--\-------------------------------------------------------( )( y )--+
                  +--[ ]( b )--/                                                                 |
        "#]],
    );
}

#[test]
fn branch_drawn_the_wrong_way_round() {
    check(
        "+--[ ]( a )--------\\--( )( y )--+\n|     \\--[ ]( b )--/            |\n|     /--( )( z )               |\n",
        expect![[r#"
            > |     \--[ ]( b )--/            |
                    ^^^^^^^^^^^^^^ error[open-wire]: this branch is drawn the wrong way round: power comes from the line above at its right end
                help: power runs to the right: begin the branch with `/` and end it with `\`
                fix: Swap `\` and `/`
                  +--[ ]( a )--\-------------------------------------------------------( )( y )--+
                  |            /--[ ]( b )--\                                                    |
                  |                         /------------------------------------------( )( z )  |
        "#]],
    );
    check(
        "      \\--( )( z )--+\n      /--[ ]( c )--\\\n+--[ ]( b )--------/\n",
        expect![[r#"
            >       /--[ ]( c )--\
                    ^^^^^^^^^^^^^^ error[open-wire]: this branch is drawn the wrong way round: power comes from the line below at its right end
                help: power runs to the right: begin the branch with `\` and end it with `/`
                fix: Swap `\` and `/`
                  |                         \------------------------------------------( )( z )--+
                  |            \--[ ]( c )--/                                                    |
                  +--[ ]( b )--/                                                                 |
        "#]],
    );
}

#[test]
fn pair_that_nothing_feeds() {
    check(
        "|  \\--( )( y )--+\n|  /--( )( z )--+\n",
        expect![[r#"
            > |  \--( )( y )--+
                 ^ error[open-wire]: no power can reach this connector: nothing comes along its line, or along that of its partner
                help: one of the two lines must come from the left rail or from a live wire
                at 2:4 `/`: its partner
                fix: Begin at the left rail
                  +--\-----------------------------------------------------------------( )( y )--+
                  |  /-----------------------------------------------------------------( )( z )--+
        "#]],
    );
    check(
        "+--[ ]( a )-- \\--( )( y )--+\n|             /--( )( z )--+\n",
        expect![[r#"
            > +--[ ]( a )-- \--( )( y )--+
                           ^ error[open-wire]: the wire is cut here: no power can reach what is after
                help: a blank or a `|` breaks a wire: draw it through with `-`
                fix: Join the wire
                  +--[ ]( a )--\-------------------------------------------------------( )( y )--+
                  |            /-------------------------------------------------------( )( z )--+
        "#]],
    );
}

#[test]
fn one_loss_is_reported_once() {
    // All three lines are dead after the cut.
    check(
        "+--[ ]( a )--  --\\--( )( x )--+\n|                /--\\--( )( y )--+\n|                   /--( )( z )--+\n",
        expect![[r#"
            > +--[ ]( a )--  --\--( )( x )--+
                           ^^ error[open-wire]: the wire is cut here: no power can reach what is after
                help: a blank or a `|` breaks a wire: draw it through with `-`
                fix: Join the wire
                  +--[ ]( a )--\-------------------------------------------------------( )( x )--+
                  |            /--\----------------------------------------------------( )( y )--+
                  |               /----------------------------------------------------( )( z )--+
        "#]],
    );
    // The bar cuts the wire as well: one error.
    check(
        "+--[ ]( a )--|--( )( y )--+\n",
        expect![[r#"
            > +--[ ]( a )--|--( )( y )--+
                           ^ error[misplaced-rail]: `|` cuts the wire
                help: `|` only draws the rails and verticals; lines are joined with \ and /
        "#]],
    );
    check(
        "+--[ ]( a )--+--( )( y )--+\n",
        expect![[r#"
            > +--[ ]( a )--+--( )( y )--+
                           ^ error[misplaced-rail]: `+` is in the middle of a line
                help: `+` is where a line leaves the left rail or ends at the right rail; lines are joined with \ and /
        "#]],
    );
    check(
        "+--[ ]( a )--( )( y )--+  +--[ ]( b )--( )( z )--+\n",
        expect![[r#"
            > +--[ ]( a )--( )( y )--+  +--[ ]( b )--( )( z )--+
                                     ^^^^ error[misplaced-rail]: a second rung begins on this line
                help: each rung belongs on a line of its own
                fix: Break the line
                  +--[ ]( a )----------------------------------------------------------( )( y )--+
                  +--[ ]( b )--( )( z )--+
        "#]],
    );
}

#[test]
fn drawings_that_are_right() {
    clean(
        "+--\\--[ ]( a )--\\-----\\--[ ]( c )--\\--( )( y )--+\n|  /--[ ]( b )--/     /--[ ]( d )--/            |\n",
    );
    clean(
        "+--\\--[ ]( a )--------\\--( )( y )--+\n|  /--\\--[ ]( b )--\\--/            |\n|     /--[ ]( c )--/               |\n",
    );
    clean(
        "+--\\-----\\--[ ]( a )--\\-----\\--( )( y )--+\n|  /--\\  /--[ ]( b )--/  \\--/            |\n|     /--[ ]( c )--------/               |\n",
    );
    clean("+--[ ]( a )--\\--( )( y )--\\--+\n|            /--( )( z )--/  |\n");
    // Powered from below.
    clean("|               \\--( )( y )--+\n+--[ ]( a )-----/--( )( z )--+\n");
}

#[test]
fn nothing_happens() {
    check(
        "+--[ ]( a )--[EQ]( n, 5 )--+\n",
        expect![[r#"
        > +--[ ]( a )--[EQ]( n, 5 )--+
          ^^^^^^^^^^^^^^^^^^^^^^^^^^^^ warning[no-output]: this network does nothing: no block in it acts
            help: its contacts only pass power on: end it with a coil or another block that acts, or remove it
    "#]],
    );
    check(
        "+----------+\n",
        expect![[r#"
        > +----------+
          ^^^^^^^^^^^^ warning[no-output]: this network does nothing: no block in it acts
            help: put blocks onto the wire, or remove the line
    "#]],
    );
    check(
        "+--\\--[ ]( a )--\\--+  # later #\n|  /--[ ]( b )--/  |\n",
        expect![[r#"
            > +--\--[ ]( a )--\--+  # later #
              ^^^^^^^^^^^^^^^^^^^^ warning[no-output]: this network does nothing: no block in it acts
                help: its contacts only pass power on: end it with a coil or another block that acts, or remove it
        "#]],
    );
    clean("+--[ ]( a )--<JMP>( there )--+\n\n+--<LBL>( there )--+\n");
    // Of a block that is not known nobody can say what it does.
    check(
        "+--[ ]( a )--[FROBNICATE]( b )--+\n",
        expect![[r#"
        > +--[ ]( a )--[FROBNICATE]( b )--+
                       ^^^^^^^^^^^^ error[unknown-instruction]: there is no instruction [FROBNICATE]
            help: contacts are [ ] and [/]; the language reference lists all instructions
    "#]],
    );
}

#[test]
fn columns_that_mislead() {
    check(
        "+--\\--[ ]( a )--\\--------------\\--( )( y )--+\n|               /--[ ]( b )--\\-/--------------+\n|                            /-( )( z )-------+\n",
        expect![[r#"
            > +--\--[ ]( a )--\--------------\--( )( y )--+
                                             ^ error[unpaired-connector]: the 3rd `\` on line 1 has no partner: line 1 has 3 `\`, line 2 below it has 2 `/`
                help: connectors pair in their order from left to right, whatever their columns: the partner is probably missing at the 1st `\`
                at 1:4 `\`: no `/` is below this `\`
                at 2:1 `|               /--[ ]( b )--\-/--------------+`: its partner `/` belongs onto this rung
        "#]],
    );
    check(
        "+--\\--[ ]( a )--\\--[ ]( c )--\\--( )( y )--+\n|               /--[ ]( b )--/--[ ]( d )--/\n",
        expect![[r#"
            > +--\--[ ]( a )--\--[ ]( c )--\--( )( y )--+
                              ^ info[misleading-alignment]: the 2nd `\` is above the 1st `/`, but pairs with the 2nd
                help: connectors pair in their order from left to right, whatever their columns
                at 2:30 `/`: this is its partner
                safe fix: Put pairs into one column
                  +--\--[ ]( a )--\--[ ]( c )--\---------------------------------------( )( y )--+
                  |  /--[ ]( b )--/--[ ]( d )--/                                                 |
        "#]],
    );
}

/// What comes after a set coil and acts is a warning, with a fix that draws a branch; what does not act is an info.
#[test]
fn latched_power_and_its_branch() {
    check(
        "+--[ ]( go )--[ ]( this )--(S)( next )--(R)( this )--+\n",
        expect![[r#"
            > +--[ ]( go )--[ ]( this )--(S)( next )--(R)( this )--+
                                                      ^^^^^^^^^^^ warning[latched-power]: (R)( this ) is after (S): its power is `next`, and stays on when the rung before goes off
                help: draw a branch before the set coil; if the latched power is meant, put a contact of the tag on a rung of its own
                at 1:28 `(S)( next )`: the set coil
                fix: Draw a branch before (S)( next )
                  +--[ ]( go )--[ ]( this )--\--------------------------------------(S)( next )--+
                  |                          /--------------------------------------(R)( this )--+
        "#]],
    );
    check(
        "+--\\--[ ]( go )--\\--(S)( next )--(R)( this )--[TON]( t, T#5s )--( )( late )--+\n|  /--[ ]( go2 )--/  |\n\n+--[ ]( next )--(S)( this )--+\n",
        expect![[r#"
            > +--\--[ ]( go )--\--(S)( next )--(R)( this )--[TON]( t, T#5s )--( )( late )--+
                                               ^^^^^^^^^^^ warning[latched-power]: (R)( this ) is after (S): its power is `next`, and stays on when the rung before goes off
                help: draw a branch before the set coil; if the latched power is meant, put a contact of the tag on a rung of its own
                at 1:21 `(S)( next )`: the set coil
                fix: Draw a branch before (S)( next )
                  +--\--[ ]( go )---------\--\--------------------------------------(S)( next )--+
                  |  /--\              \--/  /-------(R)( this )--[TON]( t, T#5s )--( )( late )--+
                  |     /--[ ]( go2 )--/                                                         |
        "#]],
    );
    // One of the branches goes down, the other comes up; the last line may have what is latched, too.
    check(
        "+--[ ]( a )--\\--[ ]( b )--\\--(S)( x )--( )( y )--+\n             /--[ ]( c )--/\n\n+--\\--( )( z )--+\n|  /--[ ]( a )--(S)( x )--( )( v )--+\n",
        expect![[r#"
            > +--[ ]( a )--\--[ ]( b )--\--(S)( x )--( )( y )--+
                                                     ^^^^^^^^ warning[latched-power]: ( )( y ) is after (S): its power is `x`, and stays on when the rung before goes off
                help: draw a branch before the set coil; if the latched power is meant, put a contact of the tag on a rung of its own
                at 1:30 `(S)( x )`: the set coil
                fix: Draw a branch before (S)( x )
                  +--[ ]( a )--\--[ ]( b )--------\--\---------------------------------(S)( x )--+
                  |            /--\            \--/  /---------------------------------( )( y )--+
                  |               /--[ ]( c )--/                                                 |
            > |  /--[ ]( a )--(S)( x )--( )( v )--+
                                        ^^^^^^^^ warning[latched-power]: ( )( v ) is after (S): its power is `x`, and stays on when the rung before goes off
                help: draw a branch before the set coil; if the latched power is meant, put a contact of the tag on a rung of its own
                at 5:17 `(S)( x )`: the set coil
                fix: Draw a branch before (S)( x )
                  +--\-----------------------------------------------------------------( )( z )--+
                  |  /--[ ]( a )--\----------------------------------------------------(S)( x )--+
                  |               /----------------------------------------------------( )( v )--+
        "#]],
    );
    // Nothing acts, or what is after it is connected further.
    check(
        "+--[ ]( a )--(S)( x )--[ ]( b )--+\n\n+--[ ]( a )--(S)( x )--\\--( )( y )--+\n|  /--( )( z )--+\n",
        expect![[r#"
            > +--[ ]( a )--(S)( x )--[ ]( b )--+
                                     ^^^^^^^^ warning[dead-end]: the power of [ ]( b ) goes nowhere: nothing that acts is after it
                help: put a coil or another block after it, join the line to another with \ and /, or remove it
            > +--[ ]( a )--(S)( x )--[ ]( b )--+
                                     ^^^^^^^^ info[latched-power]: [ ]( b ) is after (S): its power is `x`, and stays on when the rung before goes off
                help: draw a branch before the set coil; if the latched power is meant, put a contact of the tag on a rung of its own
                at 1:14 `(S)( x )`: the set coil
                fix: Draw a branch before (S)( x )
                  +--[ ]( a )--\-------------------------------------------------------(S)( x )--+
                  |            /--[ ]( b )-------------------------------------------------------+
            > +--[ ]( a )--(S)( x )--\--( )( y )--+
                                        ^^^^^^^^ warning[latched-power]: ( )( y ) is after (S): its power is `x`, and stays on when the rung before goes off
                help: draw a branch before the set coil; if the latched power is meant, put a contact of the tag on a rung of its own
                at 3:14 `(S)( x )`: the set coil
        "#]],
    );
    clean("+--[ ]( a )--(S)( x )--+\n");
}

//! Branches drawn as other tools draw them, from bar to bar, and whole drawings as people paste them.

use crate::check::check;
use expect_test::expect;

#[test]
fn branches_between_others_that_are_drawn_with_bars() {
    check(
        "+--\\--[ ]( a )--\\--( )( y )--+\n|  |--[ ]( b )--|            |\n|  /--[ ]( c )--/            |\n",
        expect![[r#"
            > +--\--[ ]( a )--\--( )( y )--+
                 ^ error[unpaired-connector]: the branch on line 2 begins and ends with `|`, which is decoration: nothing joins it to the branch above it
                help: a branch between two others begins with `/--\` and ends with `\--/`
                at 2:4 `|`: no power comes to this `|`
                at 2:17 `|`: no power leaves this `|`
                fix: Draw it with `/--\` and `\--/`
                  +--\--[ ]( a )--------\----------------------------------------------( )( y )--+
                  |  /--\--[ ]( b )--\--/                                                        |
                  |     /--[ ]( c )--/                                                           |
            > |  /--[ ]( c )--/            |
                 ^ error[unpaired-connector]: the branch on line 2 begins and ends with `|`, which is decoration: nothing joins it to the branch below it
                help: a branch between two others begins with `/--\` and ends with `\--/`
                at 2:4 `|`: no power comes to this `|`
                at 2:17 `|`: no power leaves this `|`
                fix: Draw it with `/--\` and `\--/`
                  +--\--[ ]( a )--------\----------------------------------------------( )( y )--+
                  |  /--\--[ ]( b )--\--/                                                        |
                  |     /--[ ]( c )--/                                                           |
        "#]],
    );
    check(
        "+--\\--[ ]( a )--\\--( )( y )--+\n|  |--[ ]( b )--|            |\n|  |--[ ]( c )--|            |\n|  /--[ ]( d )--/            |\n",
        expect![[r#"
            > +--\--[ ]( a )--\--( )( y )--+
                 ^ error[unpaired-connector]: the branch on line 2 begins and ends with `|`, which is decoration: nothing joins it to the branch above it
                help: a branch between two others begins with `/--\` and ends with `\--/`
                at 2:4 `|`: no power comes to this `|`
                at 2:17 `|`: no power leaves this `|`
                fix: Draw it with `/--\` and `\--/`
                  +--\--[ ]( a )--------------\----------------------------------------( )( y )--+
                  |  /--\--[ ]( b )--------\--/                                                  |
                  |     /--\--[ ]( c )--\--/                                                     |
                  |        /--[ ]( d )--/                                                        |
            > |  /--[ ]( d )--/            |
                 ^ error[unpaired-connector]: the branch on line 3 begins and ends with `|`, which is decoration: nothing joins it to the branch below it
                help: a branch between two others begins with `/--\` and ends with `\--/`
                at 3:4 `|`: no power comes to this `|`
                at 3:17 `|`: no power leaves this `|`
                fix: Draw it with `/--\` and `\--/`
                  +--\--[ ]( a )--------------\----------------------------------------( )( y )--+
                  |  /--\--[ ]( b )--------\--/                                                  |
                  |     /--\--[ ]( c )--\--/                                                     |
                  |        /--[ ]( d )--/                                                        |
        "#]],
    );
    // The last branch, and one that only looks like it.
    check(
        "+--\\--[ ]( a )--\\--( )( y )--+\n|  |--[ ]( b )--|            |\n",
        expect![[r#"
            > +--\--[ ]( a )--\--( )( y )--+
                 ^ error[unpaired-connector]: the 1st `\` on line 1 has no partner: line 2 below it has no `/`
                help: every `\` needs a `/` on the rung below: together they join the two lines
                at 2:1 `|  |--[ ]( b )--|            |`: its partner `/` belongs onto this rung
                fix: Replace `|` with `/`
                  |  /--[ ]( b )--|            |
                fix: Close the branch with `/`
                  |  |/--[ ]( b )--|            |
            > +--\--[ ]( a )--\--( )( y )--+
                              ^ error[unpaired-connector]: the 2nd `\` on line 1 has no partner: line 2 below it has no `/`
                help: every `\` needs a `/` on the rung below: together they join the two lines
                at 2:1 `|  |--[ ]( b )--|            |`: its partner `/` belongs onto this rung
                fix: Replace `|` with `/`
                  |  |--[ ]( b )--/            |
                fix: Close the branch with `/`
                  |  |--[ ]( b )--/|            |
        "#]],
    );
}

#[test]
fn a_drawing_of_boxes() {
    check(
        "├──┬──[ ]( a )──┬──( )( y )──┤\n│  ├──[ ]( b )──┤            │\n│  └──[ ]( c )──┘            │\n",
        expect![[r#"
            > ├──┬──[ ]( a )──┬──( )( y )──┤
              ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ error[unexpected-character]: this looks like a ladder diagram that is drawn with characters
                help: convert it with `ladder convert --from ascii`, or draw these lines as ladder text with the fix
                fix: Draw it with - + | \ / and blocks
                  +--\--[ ]( a )--------\----------------------------------------------( )( y )--+
                  |  /--\--[ ]( b )--\--/                                                        |
                  |     /--[ ]( c )--/                                                           |
        "#]],
    );
}

#[test]
fn names_above_a_drawing_of_boxes() {
    check(
        "     start         stop            run\n├─┬──┤ ├───┬────────┤/├────────────( )──┤\n│ │  run   │                            │\n│ └──┤ ├───┘                            │\n",
        expect![[r#"
            >      start         stop            run
              ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ error[unexpected-character]: this looks like a ladder diagram that is drawn with characters
                help: convert it with `ladder convert --from ascii`, or draw these lines as ladder text with the fix
                fix: Draw it with - + | \ / and blocks
                  +--\--[ ]( start )--\--[/]( stop )---------------------------------( )( run )--+
                  |  /--[ ]( run )----/                                                          |
        "#]],
    );
}

#[test]
fn a_joint_between_two_others_is_no_rail() {
    check(
        "│  Go       Halt            Fan\n├──┤ ├───┬──┤/├─────────────( )──┤\n│  Jog   │\n├──┤ ├───┤\n│  Fan   │\n├──┤ ├───┘\n",
        expect![[r#"
            > │  Go       Halt            Fan
              ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ error[unexpected-character]: this looks like a ladder diagram that is drawn with characters
                help: convert it with `ladder convert --from ascii`, or draw these lines as ladder text with the fix
                fix: Draw it with - + | \ / and blocks
                  +--[ ]( Go )------\--[/]( Halt )-----------------------------------( )( Fan )--+
                  +--[ ]( Jog )--\--/                                                            |
                  +--[ ]( Fan )--/                                                               |
        "#]],
    );
}

#[test]
fn a_box_that_does_not_say_what_it_is_stays() {
    check(
        "│  Go      ┌─────────┐     Fan\n├──┤ ├─────┤IN      Q├─────( )──┤\n│    5s────┤PT     ET│\n│          └─────────┘\n",
        expect![[r#"
            > │  Go      ┌─────────┐     Fan
              ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ error[unexpected-character]: this looks like a ladder diagram that is drawn with characters
                help: convert it with `ladder convert --from ascii`: what cannot be read stays as a comment
                at 2:12 `┤IN      Q├`: this cannot be read: the box does not say which block it is: TON, TOF and TP have these pins
        "#]],
    );
}

#[test]
fn contacts_without_names_stay() {
    check(
        "# from a forum #\n---| |---|/|---+---( )---\n",
        expect![[r#"
            > ---| |---|/|---+---( )---
              ^^^^^^^^^^^^^^^^^^^^^^^^^ error[unexpected-character]: this looks like a ladder diagram that is drawn with characters
                help: convert it with `ladder convert --from ascii`: what cannot be read stays as a comment
                at 2:4 `| |`: this cannot be read: no name is above this contact or inside it
                at 2:10 `|/|`: this cannot be read: no name is above this contact, and `/` inside tells only its kind
                at 2:16 `+---( )---`: this cannot be read: nothing joins this to a line above or below
                at 2:20 `( )`: this cannot be read: no name is above this coil or inside it
        "#]],
    );
}

#[test]
fn a_drawing_among_ladder_text() {
    check(
        r"
VAR
    warmup : TON;
END_VAR
# from the forum #
  start      stop            run
|--| |---+---|/|------------( )--|
|  run   |                       |
|--| |---+                       |

Rung 2: the timer
              warmup
  run       +--------+      ready
|--| |------|IN TON Q|-------( )--|
|     T#5s--|PT    ET|            |
            +--------+

+--[ ]( ready )--( )( lamp )--+
+--[ ]( lamp )--[XYZ]--( )( bell )--+
",
        expect![[r#"
            >   start      stop            run
              ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ error[unexpected-character]: this looks like a ladder diagram that is drawn with characters
                help: convert it with `ladder convert --from ascii`, or draw these lines as ladder text with the fix
                fix: Draw it with - + | \ / and blocks
                  +--[ ]( start )--\--[/]( stop )------------------------------------( )( run )--+
                  +--[ ]( run )----/                                                             |

                  # Rung 2: the timer #
                  +--[ ]( run )-----------------------------[TON]( warmup, T#5s )--( )( ready )--+
        "#]],
    );
}

#[test]
fn ladder_text_with_an_error_is_no_drawing() {
    check(
        "+--[ ]( go )--[stop]--( )( fan )--+\n",
        expect![[r#"
        > +--[ ]( go )--[stop]--( )( fan )--+
                        ^^^^^^ error[unknown-instruction]: there is no instruction [stop]
            help: a contact of the tag `stop` is written [ ]( stop )
            fix: Write [ ]( stop )
              +--[ ]( go )--[ ]( stop )------------------------------------------( )( fan )--+
    "#]],
    );
    check(
        "+--[start]--(run)--+\n",
        expect![[r#"
        > +--[start]--(run)--+
             ^^^^^^^ error[unknown-instruction]: there is no instruction [start]
            help: a contact of the tag `start` is written [ ]( start )
            fix: Write [ ]( start )
              +--[ ]( start )---------------------------------------------------------(run)--+
        > +--[start]--(run)--+
                      ^^^^^ error[unknown-instruction]: there is no instruction (run)
            help: a coil of the tag `run` is written ( )( run )
            fix: Write ( )( run )
              +---------------------------------------------------------[start]--( )( run )--+
    "#]],
    );
    check(
        "+--[ ]( b )--[XYZ]( c )--+  # ├──┤ ├──( )──┤ #\n",
        expect![[r##"
            > +--[ ]( b )--[XYZ]( c )--+  # ├──┤ ├──( )──┤ #
                           ^^^^^ error[unknown-instruction]: there is no instruction [XYZ]
                help: contacts are [ ] and [/]; the language reference lists all instructions
        "##]],
    );
    check(
        "# --| |--( )-- #\n+--[ ]( a )--( )( b )--+\n+--[ ]( b )--[XYZ]( c )--+\n",
        expect![[r#"
            > +--[ ]( b )--[XYZ]( c )--+
                           ^^^^^ error[unknown-instruction]: there is no instruction [XYZ]
                help: contacts are [ ] and [/]; the language reference lists all instructions
        "#]],
    );
}

//! What can be expressed of a network's power for all values of its contacts.

use crate::check::{check, check_program, clean};
use expect_test::expect;

#[test]
fn never_and_always() {
    check(
        "+--[ ]( a )--[ ]( b )--[/]( A )--( )( y )--+\n",
        expect![[r#"
        > +--[ ]( a )--[ ]( b )--[/]( A )--( )( y )--+
                                 ^^^^^^^^ warning[constant-power]: no power ever comes through here: when this conducts, what is before it does not
            help: change one of the conditions; to switch a rung off on purpose use [ ]( SYS.OFF )
            at 1:4 `[ ]( a )`: this is off whenever the other is on
    "#]],
    );
    check(
        "+--\\--[ ]( a )--\\--[ ]( b )--( )( y )--+\n|  /--[/]( a )--/                      |\n",
        expect![[r#"
            > +--\--[ ]( a )--\--[ ]( b )--( )( y )--+
                    ^^^^^^^^ warning[constant-power]: one of these branches always conducts: together they are a bare wire
                help: change one of the conditions, or draw a wire instead of the branches
                at 2:7 `[/]( a )`: this conducts whenever the other does not
        "#]],
    );
    // Only together with the branch before it.
    check(
        "+--\\--[ ]( a )--\\--[/]( a )--[/]( b )--( )( y )--+\n|  /--[ ]( b )--/                                |\n",
        expect![[r#"
            > +--\--[ ]( a )--\--[/]( a )--[/]( b )--( )( y )--+
                                           ^^^^^^^^ warning[constant-power]: no power ever comes through here: when this conducts, what is before it does not
                help: change one of the conditions; to switch a rung off on purpose use [ ]( SYS.OFF )
                at 1:20 `[/]( a )`: this is off whenever the other is on
        "#]],
    );
    check(
        "+--[P]( a )--[/]( a )--( )( y )--+\n",
        expect![[r#"
        > +--[P]( a )--[/]( a )--( )( y )--+
                       ^^^^^^^^ warning[constant-power]: no power ever comes through here: when this conducts, what is before it does not
            help: change one of the conditions; to switch a rung off on purpose use [ ]( SYS.OFF )
            at 1:4 `[P]( a )`: this is off whenever the other is on
    "#]],
    );
    check(
        "+--[ ]( a )--[NOT]--[ ]( a )--( )( y )--+\n",
        expect![[r#"
        > +--[ ]( a )--[NOT]--[ ]( a )--( )( y )--+
                              ^^^^^^^^ warning[constant-power]: no power ever comes through here: when this conducts, what is before it does not
            help: change one of the conditions; to switch a rung off on purpose use [ ]( SYS.OFF )
            at 1:14 `[NOT]`: this is off whenever the other is on
    "#]],
    );
    // Written in between: another value.
    clean("+--[ ]( a )--(R)( a )--+\n\n+--[/]( a )--( )( y )--+\n");
    clean("+--[/]( a )--[MOV]( a, TRUE )--+\n\n+--[ ]( SYS.OFF )--[ ]( a )--[/]( SYS.ON )--( )( y )--+\n");
    // Memory may differ.
    clean("+--[P]( a )--[ ]( b )--[P]( a )--( )( y )--+\n");
    clean(
        "VAR\n    f : ARRAY[1..4] OF BOOL;\nEND_VAR\nVAR_INPUT\n    i, j : INT;\nEND_VAR\n+--[ ]( f[i] )--[/]( f[j] )--( )( Q1 )--+\n+--( )( f[2] )--+\n",
    );
}

/// Of several coils that write a contact's tag it is enough that one is evaluated before it.
#[test]
fn a_coil_before_a_contact_decides_its_value() {
    check(
        "+--[ ]( a )-------------\\--(S)( m )--+\n+--(/)( m )--[ ]( m )--/             |\n",
        expect![[r#"
            > +--[ ]( a )-------------\--(S)( m )--+
                                         ^^^^^^^^ info[order-sensitive]: the order of this network matters: with a = 0, m = 1: `m` becomes 0, but 1 if all contacts were read first
                help: a contact reads what a coil of the same network has just written: give the later part a rung of its own
                at 2:14 `[ ]( m )`: this contact sees what the network has just written
            > +--(/)( m )--[ ]( m )--/             |
                           ^^^^^^^^ warning[constant-power]: no power ever comes through here: when this conducts, what is before it does not
                help: change one of the conditions; to switch a rung off on purpose use [ ]( SYS.OFF )
            > +--(/)( m )--[ ]( m )--/             |
                           ^^^^^^^^ warning[contact-after-coil]: [ ]( m ) is after a coil: readers look for it left of the coils
                help: draw a branch before the coil: the coil on one line, this contact and what it leads to on the other
                at 2:4 `(/)( m )`: this is the coil
        "#]],
    );
}

#[test]
fn comparisons() {
    check(
        "+--[GT]( level, 80 )--[LT]( level, 20 )--( )( y )--+\n",
        expect![[r#"
            > +--[GT]( level, 80 )--[LT]( level, 20 )--( )( y )--+
                                    ^^^^^^^^^^^^^^^^^ warning[constant-power]: no power ever comes through here: when this conducts, what is before it does not
                help: change one of the conditions; to switch a rung off on purpose use [ ]( SYS.OFF )
                at 1:4 `[GT]( level, 80 )`: this is off whenever the other is on
        "#]],
    );
    check(
        "+--[GT]( level, 80 )--[LT]( 20, level )--( )( y )--+\n",
        expect![[r#"
            > +--[GT]( level, 80 )--[LT]( 20, level )--( )( y )--+
                                    ^^^^^^^^^^^^^^^^^ warning[redundant-element]: [LT]( 20, level ) changes nothing here
                help: a wire in its place does the same: remove it, or correct the tag that was meant
                fix: Draw a wire in its place
                  +--[GT]( level, 80 )-------------------------------------------------( )( y )--+
        "#]],
    );
    check(
        "+--\\--[GT]( level, 20 )--\\--( )( y )--+\n|  /--[LT]( level, 80 )--/            |\n",
        expect![[r#"
            > +--\--[GT]( level, 20 )--\--( )( y )--+
                    ^^^^^^^^^^^^^^^^^ warning[constant-power]: one of these branches always conducts: together they are a bare wire
                help: change one of the conditions, or draw a wire instead of the branches
                at 2:7 `[LT]( level, 80 )`: this conducts whenever the other does not
        "#]],
    );
    // No whole number lies between.
    check(
        "+--[GT]( n, 5 )--[LT]( n, 6 )--( )( y )--+\n",
        expect![[r#"
        > +--[GT]( n, 5 )--[LT]( n, 6 )--( )( y )--+
                           ^^^^^^^^^^^^ warning[constant-power]: no power ever comes through here: when this conducts, what is before it does not
            help: change one of the conditions; to switch a rung off on purpose use [ ]( SYS.OFF )
            at 1:4 `[GT]( n, 5 )`: this is off whenever the other is on
    "#]],
    );
    clean("VAR_INPUT\n    r : REAL;\nEND_VAR\n+--[GT]( r, 5.0 )--[LT]( r, 6.0 )--( )( Q1 )--+\n");
    check(
        "VAR CONSTANT\n    HIGH : INT := 80;\nEND_VAR\nVAR_INPUT\n    n : USINT;\n    m : INT;\nEND_VAR\n+--[LT]( n, 0 )--( )( Q1 )--+\n\n+--[GE]( n, 0 )--( )( Q2 )--+\n\n+--[GT]( m, HIGH )--[LE]( m, 80 )--( )( Q3 )--+\n\n+--[GT]( HIGH, 5 )--( )( Q4 )--+\n",
        expect![[r#"
            > +--[LT]( n, 0 )--( )( Q1 )--+
                 ^^^^^^^^^^^^ warning[constant-power]: [LT]( n, 0 ) never conducts
                help: whatever its tags hold, it is false: compare with another value, or remove the rung
            > +--[GE]( n, 0 )--( )( Q2 )--+
                 ^^^^^^^^^^^^ warning[constant-power]: [GE]( n, 0 ) always conducts
                help: whatever its tags hold, it is true: compare with another value, or remove it
                fix: Draw a wire in its place
                  +-------------------------------------------------------------------( )( Q2 )--+
            > +--[GT]( m, HIGH )--[LE]( m, 80 )--( )( Q3 )--+
                                  ^^^^^^^^^^^^^ warning[constant-power]: no power ever comes through here: when this conducts, what is before it does not
                help: change one of the conditions; to switch a rung off on purpose use [ ]( SYS.OFF )
                at 12:4 `[GT]( m, HIGH )`: this is off whenever the other is on
            > +--[GT]( HIGH, 5 )--( )( Q4 )--+
                 ^^^^^^^^^^^^^^^ warning[constant-power]: [GT]( HIGH, 5 ) always conducts
                help: whatever its tags hold, it is true: compare with another value, or remove it
                fix: Draw a wire in its place
                  +-------------------------------------------------------------------( )( Q4 )--+
        "#]],
    );
    check(
        "+--[GT]( a, b )--[GT]( b, a )--( )( y )--+\n",
        expect![[r#"
        > +--[GT]( a, b )--[GT]( b, a )--( )( y )--+
                           ^^^^^^^^^^^^ warning[constant-power]: no power ever comes through here: when this conducts, what is before it does not
            help: change one of the conditions; to switch a rung off on purpose use [ ]( SYS.OFF )
            at 1:4 `[GT]( a, b )`: this is off whenever the other is on
    "#]],
    );
    check(
        "+--[EQ]( a, b )--[NE]( a, b )--( )( y )--+\n\n+--[GE]( a, a )--( )( z )--+\n",
        expect![[r#"
            > +--[EQ]( a, b )--[NE]( a, b )--( )( y )--+
                               ^^^^^^^^^^^^ warning[constant-power]: no power ever comes through here: when this conducts, what is before it does not
                help: change one of the conditions; to switch a rung off on purpose use [ ]( SYS.OFF )
                at 1:4 `[EQ]( a, b )`: this is off whenever the other is on
            > +--[GE]( a, a )--( )( z )--+
                 ^^^^^^^^^^^^ warning[constant-power]: [GE]( a, a ) always conducts
                help: whatever its tags hold, it is true: compare with another value, or remove it
                fix: Draw a wire in its place
                  +--------------------------------------------------------------------( )( z )--+
        "#]],
    );
    clean("+--[GT]( a, b )--[GT]( b, c )--( )( y )--+\n\n+--[GE]( x, 30, 20 )--( )( z )--+\n");
}

#[test]
fn what_changes_nothing() {
    check(
        "+--[ ]( a )--[ ]( b )--[ ]( a )--( )( y )--+\n",
        expect![[r#"
            > +--[ ]( a )--[ ]( b )--[ ]( a )--( )( y )--+
                 ^^^^^^^^ warning[redundant-element]: [ ]( a ) changes nothing here
                help: a wire in its place does the same: remove it, or correct the tag that was meant
                fix: Draw a wire in its place
                  +--[ ]( b )--[ ]( a )------------------------------------------------( )( y )--+
        "#]],
    );
    check(
        "+--\\--[ ]( a )----------------\\--( )( y )--+\n|  /--[ ]( a )--[ ]( b )--/                |\n",
        expect![[r#"
            > |  /--[ ]( a )--[ ]( b )--/                |
                    ^^^^^^^^ warning[redundant-element]: [ ]( a ) changes nothing here
                help: without its branch everything stays the same: remove it, or correct the tag that was meant
        "#]],
    );
    check(
        "+--[GT]( n, 80 )--[GT]( n, 20 )--( )( y )--+\n",
        expect![[r#"
            > +--[GT]( n, 80 )--[GT]( n, 20 )--( )( y )--+
                                ^^^^^^^^^^^^^ warning[redundant-element]: [GT]( n, 20 ) changes nothing here
                help: a wire in its place does the same: remove it, or correct the tag that was meant
                fix: Draw a wire in its place
                  +--[GT]( n, 80 )-----------------------------------------------------( )( y )--+
        "#]],
    );
    // Each is needed: two out of three.
    clean(
        "+--\\--[ ]( a )--[ ]( b )--\\--( )( y )--+\n|  /--\\--[ ]( a )--[ ]( c )--\\--/         |\n|     /--[ ]( b )--[ ]( c )--/            |\n",
    );
    // An edge acts on its tag whatever power it gets; the timer runs with the contact.
    clean("+--[ ]( a )--[TON]( t, T#5s )--[ ]( a )--( )( y )--+\n");
    // Toggling: each of the four contacts counts.
    clean(
        "+--\\--[ ]( turn )--[/]( second )--\\--( )( second )--+\n|  /--[/]( turn )--[ ]( second )--/                 |\n",
    );
}

#[test]
fn branches() {
    check(
        "+--\\--[ ]( a )--\\--( )( y )--+\n|  /-----------/             |\n",
        expect![[r#"
            > +--\--[ ]( a )--\--( )( y )--+
                    ^^^^^^^^ warning[shorted-branch]: a bare wire next to [ ]( a ) shorts it: it decides nothing
                help: put a contact into the wire next to it, or remove the branch
        "#]],
    );
    check(
        "+--\\----------------------\\--( )( y )--+\n|  /--[ ]( a )--[ ]( b )--/            |\n",
        expect![[r#"
            > |  /--[ ]( a )--[ ]( b )--/            |
                    ^^^^^^^^ warning[shorted-branch]: a bare wire next to these contacts shorts them: they decide nothing
                help: put a contact into the wire next to it, or remove the branch
                at 2:17 `[ ]( b )`: this is shorted as well
        "#]],
    );
    check(
        "+--\\--[ ]( a )--[ ]( b )--\\--( )( y )--+\n|  /--[ ]( b )--[ ]( a )--/            |\n",
        expect![[r#"
            > |  /--[ ]( b )--[ ]( a )--/            |
                              ^^^^^^^^ warning[duplicate-branch]: this branch conducts in the same cases as the one above it: one of them is enough
                help: remove it, or correct the tag that was meant
                at 1:17 `[ ]( b )`: the other branch
        "#]],
    );
    // A coil on the branch does something.
    clean("+--[ ]( x )--\\--( )( a )--\\--( )( y )--+\n|            /-----------/            |\n");
    clean("+--\\--[ ]( a )--\\--( )( y )--+\n|  /--[ ]( y )--/            |\n");
}

#[test]
fn order() {
    check(
        "+--\\--[ ]( a )--[/]( y )--( )( y )--+\n|  /--[ ]( y )--( )( z )------------+\n",
        expect![[r#"
            > |  /--[ ]( y )--( )( z )------------+
                              ^^^^^^^^ info[order-sensitive]: the order of this network matters: with a = 1, y = 0: `z` becomes 1, but 0 if all contacts were read first
                help: a contact reads what a coil of the same network has just written: give the later part a rung of its own
                at 2:7 `[ ]( y )`: this contact sees what the network has just written
        "#]],
    );
    check(
        "+--[ ]( a )--( )( y )--[/]( y )--( )( z )--+\n",
        expect![[r#"
            > +--[ ]( a )--( )( y )--[/]( y )--( )( z )--+
                                     ^^^^^^^^ warning[constant-power]: no power ever comes through here: when this conducts, what is before it does not
                help: change one of the conditions; to switch a rung off on purpose use [ ]( SYS.OFF )
            > +--[ ]( a )--( )( y )--[/]( y )--( )( z )--+
                                     ^^^^^^^^ warning[contact-after-coil]: [/]( y ) is after a coil: readers look for it left of the coils
                help: draw a branch before the coil: the coil on one line, this contact and what it leads to on the other
                at 1:14 `( )( y )`: this is the coil
            > +--[ ]( a )--( )( y )--[/]( y )--( )( z )--+
                                               ^^^^^^^^ info[order-sensitive]: the order of this network matters: with a = 1, y = 0: `z` becomes 0, but 1 if all contacts were read first
                help: a contact reads what a coil of the same network has just written: give the later part a rung of its own
                at 1:24 `[/]( y )`: this contact sees what the network has just written
        "#]],
    );
    check(
        "+--[GT]( n, 5 )--\\--(S)( y )--+\n|                /--[ ]( y )--[ ]( b )--( )( z )--+\n",
        expect![[r#"
            > |                /--[ ]( y )--[ ]( b )--( )( z )--+
                                  ^^^^^^^^ warning[redundant-element]: [ ]( y ) changes nothing here
                help: a wire in its place does the same: remove it, or correct the tag that was meant
                fix: Draw a wire in its place
                  +--[GT]( n, 5 )--\---------------------------------------------------(S)( y )--+
                  |                /--[ ]( b )-----------------------------------------( )( z )--+
            > |                /--[ ]( y )--[ ]( b )--( )( z )--+
                                                      ^^^^^^^^ info[order-sensitive]: the order of this network matters: with n > 5, y = 0, b = 1: `z` becomes 1, but 0 if all contacts were read first
                help: a contact reads what a coil of the same network has just written: give the later part a rung of its own
                at 2:21 `[ ]( y )`: this contact sees what the network has just written
        "#]],
    );
    // The same either way.
    clean("+--\\--[ ]( a )--\\--( )( y )--+\n|  /--[ ]( y )--/            |\n");
    clean("+--[ ]( a )--\\--( )( y )--+\n|            /--[ ]( b )--( )( z )--+\n");
    // Not known: the new count.
    clean("+--[ ]( a )--\\--[ADD]( n, n, 1 )--+\n|            /--[GT]( n, 5 )--( )( z )--+\n");
}

#[test]
fn beyond_the_bound_nothing_is_said() {
    let contacts: Vec<String> = (0..20).map(|n| format!("[ ]( c{n}x )--")).collect();
    let contacts = contacts.concat();
    check_program(
        &format!("+--{contacts}[ ]( a )--[/]( a )--( )( y )--+\n"),
        expect![[r#"
            > +--[ ]( c0x )--[ ]( c1x )--[ ]( c2x )--[ ]( c3x )--[ ]( c4x )--[ ]( c5x )--[ ]( c6x )--[ ]( c7x )--[ ]( c8x )--[ ]( c9x )--[ ]( c10x )--[ ]( c11x )--[ ]( c12x )--[ ]( c13x )--[ ]( c14x )--[ ]( c15x )--[ ]( c16x )--[ ]( c17x )--[ ]( c18x )--[ ]( c19x )--[ ]( a )--[/]( a )--( )( y )--+
              ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ info[complex-network]: this network has 22 conditions, more than 16
                help: give parts of it tags of their own, each on a rung above, with names that say what they mean
        "#]],
    );
}

#[test]
fn master_control() {
    // The rail itself may be off.
    clean(
        "+--[ ]( a )--<MCR>--+\n\n+--[ ]( b )--<JMP>( x )--( )( y )--+\n\n+--<JMP>( x )--+\n\n+--( )( z )--+\n\n+--<LBL>( x )--( )( q )--+\n\n+--<MCR>--+\n",
    );
}

#[test]
fn a_wire_leads_round() {
    // From the rail, by one connector.
    check(
        "+--------------\\--[ ]( start )--( )( run )--+\n+--[ ]( aux )--/                            |\n",
        expect![[r#"
            > +--[ ]( aux )--/                            |
                 ^^^^^^^^^^ warning[redundant-element]: [ ]( aux ) decides nothing: a wire leads round it
                help: put a contact into the wire, or remove what it leads round
                at 1:16 `\`: the wire joins the line again here
        "#]],
    );
    check(
        "+--[ ]( aux )--\\--[ ]( start )--( )( run )--+\n+--------------/                            |\n",
        expect![[r#"
            > +--[ ]( aux )--\--[ ]( start )--( )( run )--+
                 ^^^^^^^^^^ warning[redundant-element]: [ ]( aux ) decides nothing: a wire leads round it
                help: put a contact into the wire, or remove what it leads round
                at 1:16 `\`: the wire joins the line again here
        "#]],
    );
    // The power of one contact may come along both lines: no wire leads round it.
    check(
        "+--[ ]( b )--\\-------\\--( )( y )--+\n+--[ ]( a )--/-------/            |\n",
        expect![[r#""#]],
    );
    // Round two lines, with a contact on each.
    check(
        "+--------------------------\\--( )( run )--+\n+--[ ]( a )--\\--[ ]( b )--/              |\n+--[ ]( c )--/                           |\n",
        expect![[r#"
            > +--[ ]( a )--\--[ ]( b )--/              |
                 ^^^^^^^^ warning[redundant-element]: these contacts decide nothing: a wire leads round them
                help: put a contact into the wire, or remove what it leads round
                at 2:17 `[ ]( b )`: this decides nothing either
                at 3:4 `[ ]( c )`: this decides nothing either
                at 1:28 `\`: the wire joins the line again here
        "#]],
    );
    // Through the line between.
    check(
        "+--\\--[ ]( a )----------------\\--( )( y )--+\n|  /--\\--[ ]( b )--\\--------/            |\n|     /-----------/                      |\n",
        expect![[r#"
            > +--\--[ ]( a )----------------\--( )( y )--+
                    ^^^^^^^^ warning[redundant-element]: [ ]( a ) decides nothing: a wire leads round it
                help: put a contact into the wire, or remove what it leads round
                at 1:31 `\`: the wire joins the line again here
            > |  /--\--[ ]( b )--\--------/            |
                       ^^^^^^^^ warning[shorted-branch]: a bare wire next to [ ]( b ) shorts it: it decides nothing
                help: put a contact into the wire next to it, or remove the branch
        "#]],
    );
    // After a coil there is the same power.
    check(
        "+--[ ]( a )--\\--( )( x )--\\--( )( y )--+\n|            /--[ ]( b )--/            |\n",
        expect![[r#"
            > |            /--[ ]( b )--/            |
                              ^^^^^^^^ warning[redundant-element]: [ ]( b ) decides nothing: a wire leads round it
                help: put a contact into the wire, or remove what it leads round
                at 1:27 `\`: the wire joins the line again here
        "#]],
    );
    // One of the two still decides: its power goes elsewhere as well.
    check(
        "+--\\----------------------------\\--( )( y )--+\n|  /--[ ]( a )--\\--[ ]( b )----/            |\n|               /------------------( )( z )--+\n",
        expect![[r#"
            > |  /--[ ]( a )--\--[ ]( b )----/            |
                                 ^^^^^^^^ warning[shorted-branch]: a bare wire next to [ ]( b ) shorts it: it decides nothing
                help: put a contact into the wire next to it, or remove the branch
        "#]],
    );
    // Power also comes in between: only what the wire leads round is reported.
    check(
        "+--[ ]( p )--\\-----------------------------\\--( )( y )--+\n|            /--[ ]( a )--\\--[ ]( b )------/            |\n+--[ ]( q )---------------/                             |\n",
        expect![[r#"
            > |            /--[ ]( a )--\--[ ]( b )------/            |
                              ^^^^^^^^ warning[redundant-element]: [ ]( a ) decides nothing: a wire leads round it
                help: put a contact into the wire, or remove what it leads round
                at 1:44 `\`: the wire joins the line again here
        "#]],
    );
    // Larger than any table.
    check(
        "+--------------------------------------------------------------------------------------------------------\\--( )( y )--+\n\
         +--[ ]( a1 )--[ ]( a2 )--[ ]( a3 )--[ ]( a4 )--[ ]( a5 )--[ ]( a6 )--[ ]( a7 )--[ ]( a8 )--[ ]( a9 )--\\--/            |\n\
         +--[ ]( b1 )--[ ]( b2 )--[ ]( b3 )--[ ]( b4 )--[ ]( b5 )--[ ]( b6 )--[ ]( b7 )--[ ]( b8 )--[ ]( b9 )--/               |\n",
        expect![[r#"
            > +--[ ]( a1 )--[ ]( a2 )--[ ]( a3 )--[ ]( a4 )--[ ]( a5 )--[ ]( a6 )--[ ]( a7 )--[ ]( a8 )--[ ]( a9 )--\--/            |
                 ^^^^^^^^^ warning[redundant-element]: these contacts decide nothing: a wire leads round them
                help: put a contact into the wire, or remove what it leads round
                at 2:15 `[ ]( a2 )`: this decides nothing either
                at 2:26 `[ ]( a3 )`: this decides nothing either
                at 2:37 `[ ]( a4 )`: this decides nothing either
                at 2:48 `[ ]( a5 )`: this decides nothing either
                at 2:59 `[ ]( a6 )`: this decides nothing either
                at 2:70 `[ ]( a7 )`: this decides nothing either
                at 2:81 `[ ]( a8 )`: this decides nothing either
                at 2:92 `[ ]( a9 )`: this decides nothing either
                at 3:4 `[ ]( b1 )`: this decides nothing either
                at 3:15 `[ ]( b2 )`: this decides nothing either
                at 3:26 `[ ]( b3 )`: this decides nothing either
                at 3:37 `[ ]( b4 )`: this decides nothing either
                at 3:48 `[ ]( b5 )`: this decides nothing either
                at 3:59 `[ ]( b6 )`: this decides nothing either
                at 3:70 `[ ]( b7 )`: this decides nothing either
                at 3:81 `[ ]( b8 )`: this decides nothing either
                at 3:92 `[ ]( b9 )`: this decides nothing either
                at 1:106 `\`: the wire joins the line again here
        "#]],
    );
    // Nothing leads round these.
    clean("+--\\--[ ]( a )--\\--( )( y )--+\n|  /--[ ]( b )--/            |\n");
    clean("+--[ ]( a )--\\--( )( y )--+\n+--[ ]( b )--/            |\n");
    clean(
        "+--[ ]( a )--\\--[ ]( b )-----\\--( )( y )--+\n|            /--[/]( x )--\\--/            |\n+--[ ]( c )---------------/--[ ]( d )--( )( z )--+\n",
    );
    // What remembers or inverts power is another thing.
    clean("+--\\----------------\\--( )( y )--+\n|  /--[ ]( a )--[NOT]--/        |\n");
    clean("+--\\------------------------\\--( )( y )--+\n|  /--[TON]( t, T#5s )--/                 |\n");
}

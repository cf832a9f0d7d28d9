//! What can be said of a network's power for all values of its contacts.

use crate::check::{check, check_program, clean};
use expect_test::expect;

#[test]
fn never_and_always() {
    check(
        "+--[ ]( a )--[ ]( b )--[/]( A )--( )( y )--+\n",
        expect![[r#"
        > +--[ ]( a )--[ ]( b )--[/]( A )--( )( y )--+
                                 ^^^^^^^^ warning[constant-power]: no power ever comes through here: when this conducts, what stands before it does not
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
                                           ^^^^^^^^ warning[constant-power]: no power ever comes through here: when this conducts, what stands before it does not
                help: change one of the conditions; to switch a rung off on purpose use [ ]( SYS.OFF )
                at 1:20 `[/]( a )`: this is off whenever the other is on
        "#]],
    );
    check(
        "+--[P]( a )--[/]( a )--( )( y )--+\n",
        expect![[r#"
        > +--[P]( a )--[/]( a )--( )( y )--+
                       ^^^^^^^^ warning[constant-power]: no power ever comes through here: when this conducts, what stands before it does not
            help: change one of the conditions; to switch a rung off on purpose use [ ]( SYS.OFF )
            at 1:4 `[P]( a )`: this is off whenever the other is on
    "#]],
    );
    check(
        "+--[ ]( a )--[NOT]--[ ]( a )--( )( y )--+\n",
        expect![[r#"
        > +--[ ]( a )--[NOT]--[ ]( a )--( )( y )--+
                              ^^^^^^^^ warning[constant-power]: no power ever comes through here: when this conducts, what stands before it does not
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

#[test]
fn comparisons() {
    check(
        "+--[GT]( level, 80 )--[LT]( level, 20 )--( )( y )--+\n",
        expect![[r#"
            > +--[GT]( level, 80 )--[LT]( level, 20 )--( )( y )--+
                                    ^^^^^^^^^^^^^^^^^ warning[constant-power]: no power ever comes through here: when this conducts, what stands before it does not
                help: change one of the conditions; to switch a rung off on purpose use [ ]( SYS.OFF )
                at 1:4 `[GT]( level, 80 )`: this is off whenever the other is on
        "#]],
    );
    check(
        "+--[GT]( level, 80 )--[LT]( 20, level )--( )( y )--+\n",
        expect![[r#"
            > +--[GT]( level, 80 )--[LT]( 20, level )--( )( y )--+
                                    ^^^^^^^^^^^^^^^^^ info[redundant-element]: [LT]( 20, level ) changes nothing here
                help: a wire in its place does the same: remove it, or correct the tag that was meant
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
                           ^^^^^^^^^^^^ warning[constant-power]: no power ever comes through here: when this conducts, what stands before it does not
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
            > +--[GT]( m, HIGH )--[LE]( m, 80 )--( )( Q3 )--+
                                  ^^^^^^^^^^^^^ warning[constant-power]: no power ever comes through here: when this conducts, what stands before it does not
                help: change one of the conditions; to switch a rung off on purpose use [ ]( SYS.OFF )
                at 12:4 `[GT]( m, HIGH )`: this is off whenever the other is on
            > +--[GT]( HIGH, 5 )--( )( Q4 )--+
                 ^^^^^^^^^^^^^^^ warning[constant-power]: [GT]( HIGH, 5 ) always conducts
                help: whatever its tags hold, it is true: compare with another value, or remove it
        "#]],
    );
    check(
        "+--[GT]( a, b )--[GT]( b, a )--( )( y )--+\n",
        expect![[r#"
        > +--[GT]( a, b )--[GT]( b, a )--( )( y )--+
                           ^^^^^^^^^^^^ warning[constant-power]: no power ever comes through here: when this conducts, what stands before it does not
            help: change one of the conditions; to switch a rung off on purpose use [ ]( SYS.OFF )
            at 1:4 `[GT]( a, b )`: this is off whenever the other is on
    "#]],
    );
    check(
        "+--[EQ]( a, b )--[NE]( a, b )--( )( y )--+\n\n+--[GE]( a, a )--( )( z )--+\n",
        expect![[r#"
            > +--[EQ]( a, b )--[NE]( a, b )--( )( y )--+
                               ^^^^^^^^^^^^ warning[constant-power]: no power ever comes through here: when this conducts, what stands before it does not
                help: change one of the conditions; to switch a rung off on purpose use [ ]( SYS.OFF )
                at 1:4 `[EQ]( a, b )`: this is off whenever the other is on
            > +--[GE]( a, a )--( )( z )--+
                 ^^^^^^^^^^^^ warning[constant-power]: [GE]( a, a ) always conducts
                help: whatever its tags hold, it is true: compare with another value, or remove it
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
             ^^^^^^^^ info[redundant-element]: [ ]( a ) changes nothing here
            help: a wire in its place does the same: remove it, or correct the tag that was meant
    "#]],
    );
    check(
        "+--\\--[ ]( a )----------------\\--( )( y )--+\n|  /--[ ]( a )--[ ]( b )--/                |\n",
        expect![[r#"
            > |  /--[ ]( a )--[ ]( b )--/                |
                    ^^^^^^^^ info[redundant-element]: [ ]( a ) changes nothing here
                help: without its branch everything stays the same: remove it, or correct the tag that was meant
        "#]],
    );
    check(
        "+--[GT]( n, 80 )--[GT]( n, 20 )--( )( y )--+\n",
        expect![[r#"
            > +--[GT]( n, 80 )--[GT]( n, 20 )--( )( y )--+
                                ^^^^^^^^^^^^^ info[redundant-element]: [GT]( n, 20 ) changes nothing here
                help: a wire in its place does the same: remove it, or correct the tag that was meant
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
                    ^^^^^^^^ warning[shorted-branch]: a bare wire beside [ ]( a ) shorts it: it decides nothing
                help: put a contact into the wire beside it, or remove the branch
        "#]],
    );
    check(
        "+--\\----------------------\\--( )( y )--+\n|  /--[ ]( a )--[ ]( b )--/            |\n",
        expect![[r#"
            > |  /--[ ]( a )--[ ]( b )--/            |
                    ^^^^^^^^ warning[shorted-branch]: a bare wire beside these contacts shorts them: they decide nothing
                help: put a contact into the wire beside it, or remove the branch
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
                                     ^^^^^^^^ warning[constant-power]: no power ever comes through here: when this conducts, what stands before it does not
                help: change one of the conditions; to switch a rung off on purpose use [ ]( SYS.OFF )
            > +--[ ]( a )--( )( y )--[/]( y )--( )( z )--+
                                     ^^^^^^^^ warning[contact-after-coil]: [/]( y ) stands behind a coil: whoever looks for it looks left of the coils
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
                                  ^^^^^^^^ info[redundant-element]: [ ]( y ) changes nothing here
                help: a wire in its place does the same: remove it, or correct the tag that was meant
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

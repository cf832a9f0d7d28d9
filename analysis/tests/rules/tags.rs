//! How tags are used in a whole program.

use crate::check::{check_program, clean_program};
use expect_test::expect;
use ladder_analysis::analyze;
use std::sync::Arc;

#[test]
fn read_and_written() {
    check_program(
        "VAR_INPUT\n    a, b : BOOL;\nEND_VAR\nVAR_OUTPUT\n    y, z : BOOL;\nEND_VAR\nVAR\n    m, n, o : BOOL;\n    t : TON;\n    k : INT;\nEND_VAR\n\n+--[ ]( a )--[ ]( m )--[ ]( t.Q )--( )( y )--( )( n )--[MOV]( k, 5 )--+\n",
        expect![[r#"
            >     a, b : BOOL;
                     ^ info[never-read]: the input `b` is declared, and nothing reads it
                help: read it where it is meant to act, or remove its declaration
            >     y, z : BOOL;
                     ^ info[never-written]: the output `z` is never written: it stays off
                help: write it with a coil or another block, or remove its declaration
            >     m, n, o : BOOL;
                     ^ info[never-read]: `n` is written, and nothing reads it
                help: read it where it is meant to act; declare it in VAR_OUTPUT if it is for the outside; or remove it
            >     m, n, o : BOOL;
                        ^ info[never-read]: `o` is declared and never used
                help: use it, or remove its declaration
            >     k : INT;
                  ^ info[never-read]: `k` is written, and nothing reads it
                help: read it where it is meant to act; declare it in VAR_OUTPUT if it is for the outside; or remove it
            > +--[ ]( a )--[ ]( m )--[ ]( t.Q )--( )( y )--( )( n )--[MOV]( k, 5 )--+
                                ^ info[never-written]: `m` is read, and nothing writes it: it stays off
                help: write it; declare it in VAR_INPUT if it comes from outside; or give it a value and declare it CONSTANT
                at 8:5 `m`: `m` is declared here
            > +--[ ]( a )--[ ]( m )--[ ]( t.Q )--( )( y )--( )( n )--[MOV]( k, 5 )--+
                                          ^ info[never-written]: no [TON] block works on `t`: it stays as it is at the start
                help: put the block with this tag onto a rung
                at 9:5 `t`: `t` is declared here
        "#]],
    );
    check_program(
        "+--[ ]( M1 )--( )( Q1 )--( )( M2 )--+\n",
        expect![[r#"
        > +--[ ]( M1 )--( )( Q1 )--( )( M2 )--+
                  ^^ info[never-written]: `M1` is read, and nothing writes it: it is off unless it is given from outside
            help: write it, or use an input (I and a number) if it comes from outside
        > +--[ ]( M1 )--( )( Q1 )--( )( M2 )--+
                                        ^^ info[never-read]: `M2` is an internal tag: it is written, and nothing reads it
            help: read it where it is meant to act, or use an output (Q and a number) if it is for the outside
    "#]],
    );
    clean_program(
        "VAR RETAIN\n    total : DINT;\nEND_VAR\nVAR\n    speed AT %MW2 : INT;\nEND_VAR\nVAR_GLOBAL RETAIN\n    shared : BOOL;\nEND_VAR\nVAR CONSTANT\n    LIMIT : INT := 5;\nEND_VAR\nVAR\n    limit_2 : INT := 7;\nEND_VAR\n\n+--[ ]( I1 )--[MOV]( total, 5 )--[MOV]( speed, LIMIT )--[GT]( speed, limit_2 )--( )( Q1 )--+\n",
    );
    // No outputs: what the tags hold is what the program is for.
    clean_program("VAR\n    n : INT;\nEND_VAR\n+--[MOV]( n, 5 )--+\n");
    // A misspelt name is reported once.
    check_program(
        "VAR_INPUT\n    start : BOOL;\nEND_VAR\nVAR_OUTPUT\n    run : BOOL;\nEND_VAR\n+--[ ]( strat )--( )( run )--+\n",
        expect![[r#"
            > +--[ ]( strat )--( )( run )--+
                      ^^^^^ warning[undeclared-tag]: `strat` is not declared
                help: did you mean `start`?
                fix: Replace with `start`
                  +--[ ]( start )----------------------------------------------------( )( run )--+
                fix: Declare `strat : BOOL` in VAR_INPUT
                      strat : BOOL;
        "#]],
    );
    // In a block.
    check_program(
        "FUNCTION_BLOCK [$B]\nVAR_INPUT\n    a, b : BOOL;\nEND_VAR\nVAR_OUTPUT\n    y : BOOL;\nEND_VAR\n+--[ ]( a )--( )( ENO )--(R)( a )--+\nEND_FUNCTION_BLOCK\n\n+--[$B]( p, q, r )--( )( s )--+\n",
        expect![[r#"
            >     a, b : BOOL;
                     ^ info[never-read]: the input `b` is declared, and nothing reads it
                help: read it where it is meant to act, or remove its declaration
            >     y : BOOL;
                  ^ info[never-written]: the output `y` is never written: it stays off
                help: write it with a coil or another block, or remove its declaration
            > +--[ ]( a )--( )( ENO )--(R)( a )--+
                                            ^ warning[input-written]: `a` is an input of the block, and is written here: its caller gives it again each time the block runs
                help: write a tag of its own, and read that instead of the input where it is needed
                at 3:5 `a`: `a` is declared as an input here
        "#]],
    );
}

#[test]
fn inputs() {
    check_program(
        "VAR_INPUT\n    a : BOOL;\n    b AT %IX0.0 : BOOL;\nEND_VAR\n+--[ ]( a )--( )( b )--(S)( a )--( )( I1 )--( )( %IX0.1 )--+\n+--[ ]( b )--[ ]( I1 )--(R)( a )--( )( Q1 )--+\n",
        expect![[r#"
            > +--[ ]( a )--( )( b )--(S)( a )--( )( I1 )--( )( %IX0.1 )--+
                                ^ warning[input-written]: `b` is an input, and is written here: the next reading of the inputs overwrites it
                help: write a tag of its own, and read that instead of the input where it is needed
                at 3:5 `b`: `b` is declared as an input here
            > +--[ ]( a )--( )( b )--(S)( a )--( )( I1 )--( )( %IX0.1 )--+
                                          ^ warning[input-written]: `a` is an input, and is written here: the next reading of the inputs overwrites it
                help: write a tag of its own, and read that instead of the input where it is needed
                at 6:30 `a`: `a` is written here as well
                at 2:5 `a`: `a` is declared as an input here
            > +--[ ]( a )--( )( b )--(S)( a )--( )( I1 )--( )( %IX0.1 )--+
                                               ^^^^^^^^^ warning[latched-power]: ( )( I1 ) is after (S): its power is `a`, and stays on when the rung before goes off
                help: draw a branch before the set coil; if the latched power is meant, put a contact of the tag on a rung of its own
                at 5:24 `(S)( a )`: the set coil
                fix: Draw a branch before (S)( a )
                  +--[ ]( a )-----------------------------( )( b )--\------------------(S)( a )--+
                  |                                                 /--( )( I1 )--( )( %IX0.1 )--+
            > +--[ ]( a )--( )( b )--(S)( a )--( )( I1 )--( )( %IX0.1 )--+
                                                    ^^ warning[input-written]: `I1` is an input, and is written here: the next reading of the inputs overwrites it
                help: write a tag of its own, and read that instead of the input where it is needed
            > +--[ ]( a )--( )( b )--(S)( a )--( )( I1 )--( )( %IX0.1 )--+
                                                               ^^^^^^ warning[input-written]: `%IX0.1` is an input, and is written here: the next reading of the inputs overwrites it
                help: write a tag of its own, and read that instead of the input where it is needed
        "#]],
    );
}

#[test]
fn latches() {
    check_program(
        "+--[ ]( a )--(S)( y )--+\n\n+--[ ]( b )--(R)( z )--+\n\n+--[ ]( y )--[ ]( z )--( )( q )--+\n",
        expect![[r#"
            > +--[ ]( a )--(S)( y )--+
                                ^ info[set-without-reset]: `y` is set, and nothing resets it: once on, it stays on
                help: reset it with (R)( y ); or write ( )( y ) if it should follow the power
            > +--[ ]( b )--(R)( z )--+
                                ^ info[reset-without-set]: `z` is reset, and nothing sets it: it is never on
                help: set it with (S)( z ), or remove the reset
        "#]],
    );
    clean_program("+--[ ]( a )--(S)( y )--+\n\n+--[ ]( b )--( )( y )--+\n");
    clean_program(
        "VAR\n    armed : BOOL := TRUE;\nEND_VAR\n+--[ ]( I1 )--(R)( armed )--+\n\n+--[ ]( armed )--( )( Q1 )--+\n",
    );
    check_program(
        "+--[ ]( a )--[ ]( b )--(S)( y )--+\n\n+--[ ]( a )--(R)( y )--+\n",
        expect![[r#"
            > +--[ ]( a )--[ ]( b )--(S)( y )--+
                                          ^ warning[set-and-reset]: whenever this sets `y`, another coil resets it in the same scan: this has no effect
                help: change one of the conditions, or remove one of the coils
                at 3:19 `y`: this resets `y`
        "#]],
    );
    check_program(
        "+--[ ]( a )--(R)( y )--(S)( y )--+\n",
        expect![[r#"
        > +--[ ]( a )--(R)( y )--(S)( y )--+
                            ^ warning[set-and-reset]: whenever this resets `y`, another coil sets it in the same scan: this has no effect
            help: change one of the conditions, or remove one of the coils
            at 1:29 `y`: this sets `y`
    "#]],
    );
    // The other way round the reset is the exception.
    clean_program("+--[ ]( a )--(S)( y )--+\n\n+--[ ]( a )--[ ]( b )--(R)( y )--+\n");
    clean_program("+--[GE]( level, 800 )--(S)( call )--+\n\n+--[LE]( level, 200 )--(R)( call )--+\n");
    // What they ask for changes in between.
    check_program(
        "+--[ ]( a )--(S)( y )--+\n\n+--[ ]( b )--( )( a )--+\n\n+--[ ]( a )--(R)( y )--+\n",
        expect![[r#"
            > +--[ ]( a )--(S)( y )--+
                      ^ info[read-before-write]: `a` is written further down: this rung sees its value of the scan before
                help: move the rung that writes `a` above this one, so that it acts in the same scan
                at 3:19 `a`: `a` is written here
        "#]],
    );
}

#[test]
fn one_scan_late() {
    check_program(
        "+--[ ]( a )--[/]( fault )--( )( run )--+\n\n+--[ ]( overload )--( )( fault )--+\n",
        expect![[r#"
            > +--[ ]( a )--[/]( fault )--( )( run )--+
                                ^^^^^ info[read-before-write]: `fault` is written further down: this rung sees its value of the scan before
                help: move the rung that writes `fault` above this one, so that it acts in the same scan
                at 3:26 `fault`: `fault` is written here
        "#]],
    );
    check_program(
        "+--[ ]( t.Q )--( )( y )--+\n\n+--[ ]( a )--[TON]( t, T#5s )--+\n",
        expect![[r#"
            > +--[ ]( t.Q )--( )( y )--+
                      ^ info[read-before-write]: `t` is written further down: this rung sees its value of the scan before
                help: move the rung that writes `t` above this one, so that it acts in the same scan
                at 3:21 `t`: `t` is written here
        "#]],
    );
    // A circle: one of them has to be late.
    clean_program("+--[ ]( a )--[/]( y )--( )( x )--+\n\n+--[ ]( x )--[TON]( t, T#5s )--( )( y )--+\n");
    // An edge by hand.
    clean_program("+--[ ]( a )--[/]( before )--( )( rose )--+\n\n+--[ ]( a )--( )( before )--+\n");
    // Jumps decide about the order.
    clean_program(
        "+--[ ]( c )--<JMP>( x )--+\n\n+--[ ]( y )--( )( z )--+\n\n+--<LBL>( x )--[ ]( a )--( )( y )--+\n",
    );
}

/// The findings at addresses that are read one below the other, each with the places that are related.
fn overlaps(addresses: &str) -> String {
    let rung = |address: &str| match &address[2..3] {
        "X" => format!("+--[ ]( {address} )--( )( M1 )--+\n\n"),
        _ => format!("+--[NE]( {address}, 16#0 )--( )( M1 )--+\n\n"),
    };
    let text: String = addresses.split(' ').map(rung).collect();
    let analysis = analyze(&Arc::new(ladder_syntax::parse(&text)), "a.clad");
    let mut lines = String::new();
    for found in analysis.diagnostics() {
        if found.rule.name() == "overlapping-address" {
            let related: Vec<&str> = found.related.iter().map(|related| &text[related.range]).collect();
            lines += &format!("{}: {}\n", &text[found.range], related.join(" "));
        }
    }
    lines
}

#[test]
fn addresses() {
    check_program(
        "+--[ ]( %IX0.3 )--( )( %QX0.0 )--+\n\n+--[GT]( %IW0, 100 )--( )( %QX2.1 )--+\n\n+--[MOV]( %QB2, 16#1 )--+\n",
        expect![[r#"
            > +--[GT]( %IW0, 100 )--( )( %QX2.1 )--+
                       ^^^^ warning[overlapping-address]: `%IW0` and `%IX0.3` would share memory in a controller; here each is a tag of its own
                help: use one address for one thing: name a bit of the word (tag.3), or put the bits into it with [PACK]
                at 1:9 `%IX0.3`: `%IX0.3` is here
            > +--[MOV]( %QB2, 16#1 )--+
                        ^^^^ warning[overlapping-address]: `%QB2` and `%QX2.1` would share memory in a controller; here each is a tag of its own
                help: use one address for one thing: name a bit of the word (tag.3), or put the bits into it with [PACK]
                at 3:28 `%QX2.1`: `%QX2.1` is here
        "#]],
    );
    check_program(
        "VAR_INPUT\n    level AT %IW1 : INT;\n    low AT %IX2.0 : BOOL;\nEND_VAR\n+--[GT]( level, 5 )--[ ]( low )--( )( %QX0.0 )--+\n",
        expect![[r#"
            >     low AT %IX2.0 : BOOL;
                  ^^^ warning[overlapping-address]: `low` at %IX2.0 and `level` at %IW1 would share memory in a controller; here each is a tag of its own
                help: use one address for one thing: name a bit of the word (tag.3), or put the bits into it with [PACK]
                at 2:5 `level`: `level` at %IW1 is here
        "#]],
    );
    // Each that overlaps an earlier one is reported once, whichever is within the other.
    for (addresses, expected) in [
        ("%IW0 %IB1 %ID0", "%IB1: %IW0\n%ID0: %IW0 %IB1\n"),
        ("%IB0 %IB3 %ID0", "%ID0: %IB0 %IB3\n"),
        ("%ID0 %IB0 %IB3", "%IB0: %ID0\n%IB3: %ID0\n"),
        ("%IW1 %ID0 %IW0", "%ID0: %IW1\n%IW0: %ID0\n"),
        ("%IX0.0 %IX0.1 %IX0.2 %IW0", "%IW0: %IX0.0 %IX0.1 %IX0.2\n"),
        ("%IW0 %IX0.0 %IX0.1", "%IX0.0: %IW0\n%IX0.1: %IW0\n"),
        (
            "%IX0.0 %IX0.1 %IX0.2 %IX0.3 %IX0.4 %IB0",
            "%IB0: %IX0.0 %IX0.1 %IX0.2 %IX0.3 %IX0.4\n",
        ),
        ("%IW0 %QB0 %IB2 %QX1.0 %MX0.0", ""),
    ] {
        assert_eq!(overlaps(addresses), expected, "{addresses}");
    }
    clean_program(
        "+--[ ]( %IX0.3 )--[ ]( %IX0.4 )--( )( %QX0.3 )--+\n\n+--[GT]( %IW1, %IW2 )--[GT]( %IB1, 5 )--( )( %QX2.1 )--+\n",
    );
}

#[test]
fn names_of_one_address_are_one_tag() {
    // Nothing is reported that another name makes untrue.
    clean_program(
        "VAR_INPUT\n    go, seen AT %IX0.0 : BOOL;\nEND_VAR\nVAR_OUTPUT\n    run AT %QX0.0 : BOOL;\n    shown AT %QX00.0 : BOOL;\n    level AT %QW2 : INT;\n    bits AT %QW2 : WORD;\nEND_VAR\n\
         +--[ ]( go )--[MOV]( level, 5 )--(S)( run )--+\n\n+--[/]( seen )--[MOV]( bits, 16#FFFF )--(R)( shown )--+\n",
    );
    clean_program(
        "VAR\n    flag, mark AT %MX0.0 : BOOL;\nEND_VAR\n+--[ ]( I1 )--( )( mark )--+\n\n+--[ ]( flag )--( )( Q1 )--+\n\n+--[ ]( I2 )--[OSR]--(S)( flag )--+\n",
    );
    check_program(
        "VAR\n    flag, mark AT %MX0.0 : BOOL;\n    kept, held AT %MX0.1 : BOOL;\nEND_VAR\n+--[ ]( I1 )--( )( mark )--(S)( kept )--+\n\n+--[ ]( I2 )--( )( flag )--[ ]( %mx0.00 )--(S)( held )--+\n",
        expect![[r#"
            > +--[ ]( I1 )--( )( mark )--(S)( kept )--+
                                              ^^^^ info[set-without-reset]: `kept` is set, and nothing resets it: once on, it stays on
                help: reset it with (R)( kept ); or write ( )( kept ) if it should follow the power
            > +--[ ]( I2 )--( )( flag )--[ ]( %mx0.00 )--(S)( held )--+
                                 ^^^^ warning[double-coil]: `%MX0.0` is written by 2 coils: the last one alone decides
                help: combine all conditions into one coil, joined with \ and /; or use (S) and (R)
                at 5:20 `mark`: `%MX0.0` is written here as well
            > +--[ ]( I2 )--( )( flag )--[ ]( %mx0.00 )--(S)( held )--+
                                         ^^^^^^^^^^^^^^ warning[redundant-element]: [ ]( %mx0.00 ) changes nothing here
                help: a wire in its place does the same: remove it, or correct the tag that was meant
                fix: Draw a wire in its place
                  +--[ ]( I2 )-----------------------------------------( )( flag )--(S)( held )--+
            > +--[ ]( I2 )--( )( flag )--[ ]( %mx0.00 )--(S)( held )--+
                                         ^^^^^^^^^^^^^^ warning[contact-after-coil]: [ ]( %mx0.00 ) is after a coil: readers look for it left of the coils
                help: draw a branch before the coil: the coil on one line, this contact and what it leads to on the other
                at 7:15 `( )( flag )`: this is the coil
            > +--[ ]( I2 )--( )( flag )--[ ]( %mx0.00 )--(S)( held )--+
                                                         ^^^^^^^^^^^ info[order-sensitive]: the order of this network matters: with I2 = 1, flag = 0, held = 0: `held` becomes 1, but 0 if all contacts were read first
                help: a contact reads what a coil of the same network has just written: give the later part a rung of its own
                at 7:28 `[ ]( %mx0.00 )`: this contact sees what the network has just written
            > +--[ ]( I2 )--( )( flag )--[ ]( %mx0.00 )--(S)( held )--+
                                                              ^^^^ info[set-without-reset]: `held` is set, and nothing resets it: once on, it stays on
                help: reset it with (R)( held ); or write ( )( held ) if it should follow the power
        "#]],
    );
    // Power knows it too.
    check_program(
        "VAR\n    flag, mark AT %MX0.0 : BOOL;\nEND_VAR\n+--[ ]( flag )--[/]( mark )--( )( Q1 )--+\n\n+--[/]( flag )--(S)( mark )--\\--[/]( flag )--( )( Q2 )--+\n|                            /--(R)( %MX0.0 )-----------+\n",
        expect![[r#"
            > +--[ ]( flag )--[/]( mark )--( )( Q1 )--+
                              ^^^^^^^^^^^ warning[constant-power]: no power ever comes through here: when this conducts, what is before it does not
                help: change one of the conditions; to switch a rung off on purpose use [ ]( SYS.OFF )
                at 4:4 `[ ]( flag )`: this is off whenever the other is on
            > +--[/]( flag )--(S)( mark )--\--[/]( flag )--( )( Q2 )--+
                                              ^^^^^^^^^^^ warning[constant-power]: no power ever comes through here: when this conducts, what is before it does not
                help: change one of the conditions; to switch a rung off on purpose use [ ]( SYS.OFF )
            > +--[/]( flag )--(S)( mark )--\--[/]( flag )--( )( Q2 )--+
                                              ^^^^^^^^^^^ warning[contact-after-coil]: [/]( flag ) is after a coil: readers look for it left of the coils
                help: draw a branch before the coil: the coil on one line, this contact and what it leads to on the other
                at 6:17 `(S)( mark )`: this is the coil
            > +--[/]( flag )--(S)( mark )--\--[/]( flag )--( )( Q2 )--+
                                              ^^^^^^^^^^^ warning[latched-power]: [/]( flag ) is after (S): its power is `mark`, and stays on when the rung before goes off
                help: draw a branch before the set coil; if the latched power is meant, put a contact of the tag on a rung of its own
                at 6:17 `(S)( mark )`: the set coil
            > +--[/]( flag )--(S)( mark )--\--[/]( flag )--( )( Q2 )--+
                                                           ^^^^^^^^^ info[order-sensitive]: the order of this network matters: with flag = 0: `Q2` becomes 0, but 1 if all contacts were read first
                help: a contact reads what a coil of the same network has just written: give the later part a rung of its own
                at 6:33 `[/]( flag )`: this contact sees what the network has just written
        "#]],
    );
    for address in ["%MW3", "%MX0.3", "%MD3"] {
        assert_eq!(overlaps(&format!("{address} {}", address.replace('3', "03"))), "");
    }
}

#[test]
fn names_of_one_address_agree() {
    check_program(
        "VAR\n    level AT %MD3 : REAL := 1.5;\n    bits AT %MD03 : DWORD;\n    more AT %MD3 : REAL;\n    other AT %md3 : REAL := 2.5;\nEND_VAR\nVAR CONSTANT\n    fixed AT %MD3 : REAL;\nEND_VAR\n+--[GT]( level, 1.0 )--( )( y )--+\n",
        expect![[r#"
            >     bits AT %MD03 : DWORD;
                  ^^^^ error[duplicate-declaration]: `bits` is DWORD, and `level` at the same address %MD03 is REAL
                help: an address is one tag, whatever its names: they agree in type, initial value and CONSTANT
                at 2:5 `level`: `level` is declared here
            >     other AT %md3 : REAL := 2.5;
                  ^^^^^ error[duplicate-declaration]: `other` starts with another value than `level` at the same address %md3
                help: an address is one tag, whatever its names: they agree in type, initial value and CONSTANT
                at 2:5 `level`: `level` is declared here
            >     fixed AT %MD3 : REAL;
                  ^^^^^ error[duplicate-declaration]: `fixed` is CONSTANT, and `level` at the same address %MD3 is not
                help: an address is one tag, whatever its names: they agree in type, initial value and CONSTANT
                at 2:5 `level`: `level` is declared here
            > +--[GT]( level, 1.0 )--( )( y )--+
                                          ^ warning[undeclared-tag]: `y` is not declared
                help: declare it, so that a typing error cannot make a new tag
                fix: Declare `y : BOOL` in VAR_OUTPUT
                  VAR_OUTPUT
                      y : BOOL;
                  END_VAR
        "#]],
    );
    check_program(
        "VAR\n    y : BOOL;\nEND_VAR\n+--[EQ]( %MD3, 16#5 )--[$High]( )--( )( y )--+\n\nFUNCTION_BLOCK [$High]\nVAR n AT %MD3 : REAL; END_VAR\n+--[ ]( EN )--[MOV]( n, 1.0 )--+\nEND_FUNCTION_BLOCK\n",
        expect![[r#"
            > +--[EQ]( %MD3, 16#5 )--[$High]( )--( )( y )--+
                       ^^^^ error[duplicate-declaration]: `%MD3` is DWORD here, and `n` at this address is REAL
                help: an address is one tag, whatever its names: they agree in type, initial value and CONSTANT
                at 7:5 `n`: `n` is declared here
        "#]],
    );
    // Integers and bit strings of one width keep their bits; what says nothing agrees.
    clean_program(
        "VAR\n    level AT %MW3 : INT := -1;\n    bits AT %MW3 : WORD := 16#FFFF;\n    more AT %MW3 : UINT;\nEND_VAR\n+--[GT]( level, 1 )--[EQ]( bits, more )--( )( Q1 )--+\n",
    );
}

#[test]
fn what_is_given_has_no_address() {
    check_program(
        "VAR_EXTERNAL\n    total AT %MW3 : INT;\nEND_VAR\n\nFUNCTION_BLOCK [$B]\nVAR_INPUT p AT %IX0.0 : BOOL; END_VAR\nVAR_OUTPUT r AT %QX0.1 : BOOL; END_VAR\nVAR_IN_OUT q AT %QX0.0 : BOOL; END_VAR\n+--[ ]( p )--( )( q )--( )( r )--+\nEND_FUNCTION_BLOCK\n",
        expect![[r#"
            >     total AT %MW3 : INT;
                  ^^^^^ error[bad-declaration]: no file of the workspace declares `total` as VAR_GLOBAL
                help: VAR_EXTERNAL names a global that is declared elsewhere: declare it, or correct the name
            >     total AT %MW3 : INT;
                           ^^^^ error[bad-declaration]: VAR_EXTERNAL names a global that is declared elsewhere, with its address: take AT away
            > VAR_INPUT p AT %IX0.0 : BOOL; END_VAR
                             ^^^^^^ error[bad-declaration]: an operand of a block is given where the block is: take AT away, or declare the tag in VAR
            > VAR_OUTPUT r AT %QX0.1 : BOOL; END_VAR
                              ^^^^^^ error[bad-declaration]: an operand of a block is given where the block is: take AT away, or declare the tag in VAR
            > VAR_IN_OUT q AT %QX0.0 : BOOL; END_VAR
                              ^^^^^^ error[bad-declaration]: an operand of a block is given where the block is: take AT away, or declare the tag in VAR
        "#]],
    );
}

#[test]
fn what_runs_to_its_end_once() {
    check_program(
        "+--[ ]( a )--[CTU]( c, 5 )--( )( y )--+\n",
        expect![[r#"
        > +--[ ]( a )--[CTU]( c, 5 )--( )( y )--+
                              ^ warning[never-reset]: nothing resets or loads the CTU `c`: it counts to its end once
            help: reset or load it with (R)( c ), or with an operand of its block
    "#]],
    );
    for reset in [
        "+--[ ]( a )--[CTU]( c, 5, R := b )--( )( y )--+\n",
        "+--[ ]( a )--[CTU]( c, 5 )--( )( y )--+\n\n+--[ ]( b )--(R)( c )--+\n",
        "+--[ ]( a )--[CTD]( c, 5, LD := b )--( )( y )--+\n",
        "+--[ ]( a )--[CTC]( c, 5 )--( )( y )--+\n",
        "+--[ ]( a )--[TON]( c, T#5s )--( )( y )--+\n",
    ] {
        clean_program(reset);
    }
    check_program(
        "+--[ ]( a )--[RTO]( meter, T#1h )--( )( y )--+\n",
        expect![[r#"
            > +--[ ]( a )--[RTO]( meter, T#1h )--( )( y )--+
                                  ^^^^^ warning[never-reset]: nothing resets the RTO `meter`: once it has run out it stays so
                help: reset it with (R)( meter ), or with an operand of its block
        "#]],
    );
}

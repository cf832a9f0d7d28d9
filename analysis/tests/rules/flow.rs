//! Jumps, loops, functions, and what a scan comes to.

use crate::check::{check, check_program, clean, clean_program};
use expect_test::expect;

#[test]
fn never_reached() {
    check(
        "+--<JMP>( x )--( )( a )--+\n\n+--( )( b )--+\n\n+--( )( c )--+\n\n+--<LBL>( x )--( )( d )--+\n",
        expect![[r#"
            > +--<JMP>( x )--( )( a )--+
                             ^^^^^^^^ warning[unreachable]: ( )( a ) never runs: the network is left before it
                help: put it before the block that leaves, or onto a rung of its own above
                at 1:4 `<JMP>( x )`: this always jumps away
            > +--( )( b )--+
              ^^^^^^^^^^^^^^ warning[unreachable]: no scan ever comes to this rung, nor to the network after it
                help: put a condition before what leaves above it, mark it with a <LBL> that is jumped to, or remove it
                at 1:4 `<JMP>( x )`: this always jumps away
        "#]],
    );
    check(
        "+--( )( a )--<RET>--+\n\n+--( )( b )--+\n",
        expect![[r#"
        > +--( )( a )--<RET>--+
                       ^^^^^ info[return-outside-function]: <RET> in the main program ends the scan: nothing below it runs in this scan
            help: if that is meant, keep it; to skip some rungs only, jump over them with <JMP>
        > +--( )( b )--+
          ^^^^^^^^^^^^^^ warning[unreachable]: no scan ever comes to this rung
            help: put a condition before what leaves above it, mark it with a <LBL> that is jumped to, or remove it
            at 1:14 `<RET>`: this always returns
    "#]],
    );
    check(
        "+--\\--[ ]( a )--\\--<JMP>( x )--+\n|  /--[/]( a )--/              |\n\n+--( )( b )--+\n\n+--<LBL>( x )--( )( d )--+\n",
        expect![[r#"
            > +--\--[ ]( a )--\--<JMP>( x )--+
                    ^^^^^^^^ warning[constant-power]: one of these branches always conducts: together they are a bare wire
                help: change one of the conditions, or draw a wire instead of the branches
                at 2:7 `[/]( a )`: this conducts whenever the other does not
            > +--( )( b )--+
              ^^^^^^^^^^^^^^ warning[unreachable]: no scan ever comes to this rung
                help: put a condition before what leaves above it, mark it with a <LBL> that is jumped to, or remove it
                at 1:20 `<JMP>( x )`: this always jumps away
        "#]],
    );
    check(
        "+--[ ]( SYS.ON )--<JMP>( x )--+\n\n+--( )( b )--+\n\n+--<LBL>( x )--( )( d )--+\n",
        expect![[r#"
            > +--( )( b )--+
              ^^^^^^^^^^^^^^ warning[unreachable]: no scan ever comes to this rung
                help: put a condition before what leaves above it, mark it with a <LBL> that is jumped to, or remove it
                at 1:19 `<JMP>( x )`: this always jumps away
        "#]],
    );
    clean("+--[ ]( SYS.FIRST_SCAN )--<JMP>( x )--+\n\n+--( )( b )--+\n\n+--<LBL>( x )--( )( d )--+\n");
    // A function is after the main program's end.
    clean(
        "+--<CALL>( f )--+\n\n+--<JMP>( done )--+\n\n+--<LBL>( done )--+\n\n+--<FUN>( f )--( )( y )--<RET>--+\n",
    );
    // Skipped loop.
    clean(
        "+--[ ]( a )--<FOR>( 3 )--+\n\n+--[ADD]( n, n, 1 )--+\n\n+--<NEXT>--+\n\n+--[GT]( n, 5 )--( )( y )--+\n",
    );
}

#[test]
fn never_left() {
    check(
        "+--<LBL>( x )--( )( a )--+\n\n+--<JMP>( x )--+\n",
        expect![[r#"
        > +--<JMP>( x )--+
             ^^^^^^^^^^ warning[endless-jump]: a scan that comes here never ends: this always jumps back
            help: do not wait within a scan: the program runs again and again by itself, and inputs are read between two scans
            at 1:4 `<LBL>( x )`: it jumps to here
    "#]],
    );
    check(
        "+--<LBL>( x )--[/]( a )--<JMP>( x )--+\n\n+--( )( b )--+\n",
        expect![[r#"
            > +--<LBL>( x )--[/]( a )--<JMP>( x )--+
                                       ^^^^^^^^^^ warning[endless-jump]: a scan waits here for ever while the condition holds: nothing in the loop changes `a`
                help: do not wait within a scan: the program runs again and again by itself, and inputs are read between two scans
                at 1:4 `<LBL>( x )`: it jumps to here
        "#]],
    );
    // The loop counts.
    clean(
        "+--[MOV]( n, 0 )--+\n\n+--<LBL>( x )--[ADD]( n, n, 1 )--+\n\n+--[LT]( n, 10 )--<JMP>( x )--+\n\n+--[GT]( n, 5 )--( )( b )--+\n",
    );
    // Two names of one address are one tag.
    clean(
        "VAR\n    a AT %QX0.0 : BOOL;\n    b AT %QX0.0 : BOOL;\nEND_VAR\nVAR_INPUT\n    c : BOOL;\nEND_VAR\n\
         VAR_OUTPUT\n    y : BOOL;\nEND_VAR\n\n\
         +--<LBL>( x )--[ ]( c )--( )( b )--+\n\n+--[/]( a )--<JMP>( x )--+\n\n+--( )( y )--+\n",
    );
    // A timer gives the same in every round, an edge does not.
    clean("+--<LBL>( x )--[P]( a )--<JMP>( x )--+\n\n+--( )( b )--+\n");
    clean("+--<LBL>( x )--[ ]( a )--<CALL>( f )--<JMP>( x )--+\n\n+--<FUN>( f )--(R)( a )--+\n");
}

#[test]
fn ends() {
    check(
        "+--[ ]( a )--( )( y )--+\n\n+--<END>--+\n",
        expect![[r#"
            > +--<END>--+
                 ^^^^^ warning[unconditional-end]: <END> stops the program for good, and no condition is before it: only one scan runs
                help: a program needs no end; <RET> ends the scan, as END does in other controllers
                fix: End the scan only: <RET>
                  +-----------------------------------------------------------------------<RET>--+
        "#]],
    );
    clean("+--[ ]( a )--( )( y )--+\n\n+--[ ]( b )--<END>--+\n");
    check(
        "+--[ ]( a )--<RET>--+\n\n+--[ ]( b )--( )( y )--+\n",
        expect![[r#"
            > +--[ ]( a )--<RET>--+
                           ^^^^^ info[return-outside-function]: <RET> in the main program ends the scan: nothing below it runs in this scan
                help: if that is meant, keep it; to skip some rungs only, jump over them with <JMP>
        "#]],
    );
}

#[test]
fn loops() {
    check(
        "+--<FOR>( 3 )--+\n\n+--[ADD]( n, n, 1 )--+\n",
        expect![[r#"
        > +--<FOR>( 3 )--+
             ^^^^^^^^^^ error[unbalanced-loop]: this <FOR> has no <NEXT>: nobody can say where the loop ends
            help: end the loop with <NEXT> on a network of its own after the rungs that are repeated
    "#]],
    );
    check(
        "+--[ADD]( n, n, 1 )--+\n\n+--<NEXT>--+\n",
        expect![[r#"
        > +--<NEXT>--+
             ^^^^^^ error[unbalanced-loop]: this <NEXT> ends no loop
            help: begin the loop with <FOR>( n ) on a network before it, or remove it
    "#]],
    );
    let nested = |count: usize| {
        let begin = "+--<FOR>( 3 )--+\n\n".repeat(count);
        let end = "\n+--<NEXT>--+\n".repeat(count);
        format!("{begin}+--[ADD]( n, n, 1 )--+\n{end}")
    };
    clean(&nested(8));
    check(
        &nested(9),
        expect![[r#"
        > +--<FOR>( 3 )--+
             ^^^^^^^^^^ error[unbalanced-loop]: this loop is in 8 others: no more can be in each other
            help: end an outer loop with <NEXT> first; or put the inner loop into a function and <CALL> it
            at 1:4 `<FOR>( 3 )`: this is the outermost of them
    "#]],
    );
    check(
        &format!("# ladder: profile click #\n{}", nested(2)),
        expect![[r#"
            > +--<FOR>( 3 )--+
                 ^^^^^^^^^^ error[unbalanced-loop]: in the profile `click` a loop cannot be in another loop
                help: end the first loop with <NEXT>; or put the inner loop into a function and <CALL> it
                at 2:4 `<FOR>( 3 )`: this loop has not ended
        "#]],
    );
    check(
        "+--<FOR>( 3 )--<FOR>( 2 )--[ADD]( n, n, 1 )--+\n\n+--<NEXT>--<NEXT>--+\n",
        expect![[r#"
            > +--<FOR>( 3 )--<FOR>( 2 )--[ADD]( n, n, 1 )--+
                             ^^^^^^^^^^ error[unbalanced-loop]: this is the second <FOR> of its network
                help: a network begins one loop and ends one: put it onto a network of its own
            > +--<NEXT>--<NEXT>--+
                         ^^^^^^ error[unbalanced-loop]: this is the second <NEXT> of its network
                help: a network begins one loop and ends one: put it onto a network of its own
        "#]],
    );
    check(
        "+--<FOR>( 3 )--+\n\n+--<CALL>( f )--+\n\n+--<FUN>( f )--[ADD]( n, n, 1 )--+\n\n+--<NEXT>--+\n",
        expect![[r#"
            > +--<FOR>( 3 )--+
                 ^^^^^^^^^^ error[unbalanced-loop]: this <FOR> has no <NEXT>: nobody can say where the loop ends
                help: end the loop with <NEXT> on a network of its own after the rungs that are repeated
            > +--<NEXT>--+
                 ^^^^^^ error[unbalanced-loop]: this <NEXT> ends no loop
                help: begin the loop with <FOR>( n ) on a network before it, or remove it
        "#]],
    );
    clean(
        "+--<FOR>( 3 )--+\n\n+--[ADD]( n, n, 1 )--+\n\n+--<NEXT>--<FOR>( 2 )--+\n\n+--[ADD]( n, n, 1 )--+\n\n+--<NEXT>--+\n\n+--[GT]( n, 5 )--( )( y )--+\n",
    );
}

#[test]
fn calls() {
    check(
        "+--<CALL>( f )--+\n\n+--<FUN>( f )--[ ]( a )--<CALL>( f )--+\n",
        expect![[r#"
            > +--<FUN>( f )--[ ]( a )--<CALL>( f )--+
                                               ^ warning[recursive-call]: the function `f` calls itself
                help: calls nest to a depth of 64, then the simulation stops with a fault: use <FOR> to repeat, or break the circle
        "#]],
    );
    check(
        "+--<CALL>( f )--+\n\n+--<FUN>( f )--[ ]( a )--<CALL>( g )--+\n\n+--<FUN>( g )--<CALL>( f )--( )( y )--+\n",
        expect![[r#"
            > +--<FUN>( f )--[ ]( a )--<CALL>( g )--+
                                               ^ warning[recursive-call]: `f` calls itself: by way of `g`, then `f`
                help: calls nest to a depth of 64, then the simulation stops with a fault: use <FOR> to repeat, or break the circle
                at 5:24 `f`: `f` is used here
        "#]],
    );
    clean(
        "+--<CALL>( f )--<CALL>( g )--+\n\n+--<FUN>( f )--[ ]( a )--<CALL>( g )--+\n\n+--<FUN>( g )--( )( y )--+\n",
    );
}

#[test]
fn unused() {
    check_program(
        "+--<LBL>( x )--[ ]( a )--( )( y )--+\n\n+--<FUN>( f )--( )( z )--+\n",
        expect![[r#"
            > +--<LBL>( x )--[ ]( a )--( )( y )--+
                        ^ info[unused-label]: nothing jumps to the label `x`
                help: remove it, or jump to it with <JMP>
            > +--<FUN>( f )--( )( z )--+
                        ^ info[unused-function]: nothing in this file calls the function `f`
                help: call it with <CALL>( f ), or remove it
        "#]],
    );
    // A file of functions is for others.
    clean_program("+--<FUN>( f )--[ ]( a )--( )( z )--+\n");
    clean_program(
        "FUNCTION_BLOCK <$Skip>\n+--[ ]( EN )--<JMP>( there )--+\nEND_FUNCTION_BLOCK\n\n+--[ ]( a )--<$Skip>--+\n\n+--<LBL>( there )--( )( y )--+\n",
    );
}

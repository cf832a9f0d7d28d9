//! Coils, labels, functions and blocks of a whole program.

use crate::check::{check, clean};
use expect_test::expect;

#[test]
fn two_coils() {
    check(
        "+--[ ]( a )--( )( y )--+\n\n+--[ ]( b )--( )( y )--+\n",
        expect![[r#"
            > +--[ ]( b )--( )( y )--+
                                ^ warning[double-coil]: `y` is written by 2 coils: the last one alone decides
                help: combine all conditions into one coil, joined with \ and /; or use (S) and (R)
                at 1:19 `y`: `y` is written here as well
        "#]],
    );
    check(
        "+--[ ]( a )--( )( y )--+\n\n+--[ ]( b )--(/)( Y )--+\n\n+--[ ]( c )--(M)( y )--+\n",
        expect![[r#"
            > +--[ ]( b )--(/)( Y )--+
                                ^ warning[double-coil]: `y` is written by 3 coils: the last one alone decides
                help: combine all conditions into one coil, joined with \ and /; or use (S) and (R)
                at 1:19 `y`: `y` is written here as well
                at 5:19 `y`: `y` is written here as well
        "#]],
    );
    check(
        "+--[ ]( a )--( )( y )--( )( y )--+\n",
        expect![[r#"
        > +--[ ]( a )--( )( y )--( )( y )--+
                                      ^ warning[double-coil]: `y` is written by 2 coils: the last one alone decides
            help: combine all conditions into one coil, joined with \ and /; or use (S) and (R)
            at 1:19 `y`: `y` is written here as well
    "#]],
    );
}

#[test]
fn two_coils_on_parts_of_a_tag() {
    check(
        "VAR\n    w : WORD;\n    f : ARRAY[1..4] OF BOOL;\nEND_VAR\n\n+--( )( w.3 )--( )( w.4 )--( )( f[2] )--( )( w.3 )--( )( f[3] )--( )( f[2] )--+\n",
        expect![[r#"
            > +--( )( w.3 )--( )( w.4 )--( )( f[2] )--( )( w.3 )--( )( f[3] )--( )( f[2] )--+
                                                           ^^^ warning[double-coil]: `w.3` is written by 2 coils: the last one alone decides
                help: combine all conditions into one coil, joined with \ and /; or use (S) and (R)
                at 6:9 `w.3`: `w.3` is written here as well
            > +--( )( w.3 )--( )( w.4 )--( )( f[2] )--( )( w.3 )--( )( f[3] )--( )( f[2] )--+
                                                                                    ^^^^ warning[double-coil]: `f[2]` is written by 2 coils: the last one alone decides
                help: combine all conditions into one coil, joined with \ and /; or use (S) and (R)
                at 6:33 `f[2]`: `f[2]` is written here as well
        "#]],
    );
    clean(
        "VAR\n    f : ARRAY[1..4] OF BOOL;\n    i : INT;\nEND_VAR\n\n+--( )( f[i] )--[ADD]( i, i, 1 )--( )( f[i] )--+\n",
    );
}

#[test]
fn coils_that_do_not_meet() {
    clean("+--[ ]( a )--(S)( y )--+\n\n+--[ ]( b )--(R)( y )--+\n");
    // Either the one or the other runs.
    clean(
        "+--[ ]( auto )--<JMP>( automatic )--+\n\n+--[ ]( a )--( )( y )--<JMP>( done )--+\n\n+--<LBL>( automatic )--[ ]( b )--( )( y )--+\n\n+--<LBL>( done )--+\n",
    );
    clean("+--[ ]( m )--<CALL>( f )--+\n\n+--[ ]( a )--( )( y )--+\n\n+--<FUN>( f )--( )( y )--+\n");
    // The drawing of the second is broken: what it means is not known.
    check(
        "+--[ ]( a )--( )( y )--+\n\n+--[ ]( b --( )( y )--+\n",
        expect![[r#"
            > +--[ ]( b --( )( y )--+
                    ^^^^ error[unclosed-block]: `( b` is not closed: `)` is missing
                help: a block is closed on its own line
                safe fix: Insert `)`
                  +--[ ]( b )----------------------------------------------------------( )( y )--+
        "#]],
    );
}

#[test]
fn second_block_on_a_timer() {
    check(
        "+--[ ]( a )--[TON]( t, T#5s )--( )( x )--+\n\n+--[ ]( b )--[TON]( t, T#2s )--( )( y )--+\n",
        expect![[r#"
            > +--[ ]( b )--[TON]( t, T#2s )--( )( y )--+
                                  ^ error[duplicate-timer]: the timer `t` has a second block: both would work on one TON
                help: give this block a timer of its own; to use the timer on another rung read `t.Q`; if both are meant to work on it, write `# ladder: allow(duplicate-timer): reason #` above this network
                at 1:21 `t`: the timer `t` belongs to this block
        "#]],
    );
    check(
        "+--[ ]( a )--[CTU]( c, 5 )--( )( x )--+\n\n+--[ ]( b )--[CTU]( c, 5 )--[CTU]( C, 5 )--( )( y )--+\n",
        expect![[r#"
            > +--[ ]( b )--[CTU]( c, 5 )--[CTU]( C, 5 )--( )( y )--+
                                  ^ error[duplicate-counter]: the counter `c` has a second block: both would work on one CTU
                help: give this block a counter of its own; to use the counter on another rung read `c.Q`; if both are meant to work on it, write `# ladder: allow(duplicate-counter): reason #` above this network
                at 1:21 `c`: the counter `c` belongs to this block
            > +--[ ]( b )--[CTU]( c, 5 )--[CTU]( C, 5 )--( )( y )--+
                                                 ^ error[duplicate-counter]: the counter `c` has a second block: both would work on one CTU
                help: give this block a counter of its own; to use the counter on another rung read `c.Q`; if both are meant to work on it, write `# ladder: allow(duplicate-counter): reason #` above this network
                at 1:21 `c`: the counter `c` belongs to this block
        "#]],
    );
    // Another type is another error.
    check(
        "+--[ ]( a )--[TON]( t, T#5s )--( )( x )--+\n\n+--[ ]( b )--[TOF]( t, T#5s )--( )( y )--+\n",
        expect![[r#"
            > +--[ ]( b )--[TOF]( t, T#5s )--( )( y )--+
                                  ^ error[type-mismatch]: `t` is used as TOF here, and as TON before
                help: give each of the two blocks a tag of its own
                at 1:21 `t`: here it is TON
        "#]],
    );
    clean(
        "+--[ ]( a )--[TON]( t, T#5s )--( )( x )--+\n\n+--[ ]( t.Q )--(RES)( t )--[ ]( t.TT )--( )( y )--+\n",
    );
}

#[test]
fn labels() {
    check(
        "+--[ ]( a )--<JMP>( x )--+\n\n+--<LBL>( x )--( )( p )--+\n\n+--[ ]( b )--<JMP>( X )--+\n\n+--<LBL>( x )--( )( q )--+\n\n+--[ ]( c )--<JMP>( x )--+\n",
        expect![[r#"
            > +--<LBL>( x )--( )( q )--+
                        ^ info[duplicate-label]: the label `x` appears more than once
                help: a jump takes the nearest label after it, else the nearest before it
                at 3:11 `x`: it is here first
                at 1:21 `x`: this jump goes to line 3
                at 5:21 `X`: this jump goes to line 7
                at 9:21 `x`: this jump goes to line 7
            > +--[ ]( c )--<JMP>( x )--+
                           ^^^^^^^^^^ warning[endless-jump]: a scan waits here for ever while the condition holds: nothing in the loop changes `c`
                help: do not wait within a scan: the program runs again and again by itself, and inputs are read between two scans
                at 7:4 `<LBL>( x )`: it jumps to here
        "#]],
    );
    check(
        "+--[ ]( a )--<JMP>( ready )--+\n\n+--<LBL>( redy )--( )( p )--+\n",
        expect![[r#"
            > +--[ ]( a )--<JMP>( ready )--+
                                  ^^^^^ error[unknown-label]: there is no label `ready` to jump to
                help: did you mean `redy`?
                fix: Jump to `redy`
                  +--[ ]( a )-----------------------------------------------------<JMP>( redy )--+
        "#]],
    );
    check(
        "+--[ ]( a )--<JMP>( x )--<CALL>( f )--+\n\n+--<FUN>( f )--+\n\n+--<LBL>( x )--( )( p )--+\n",
        expect![[r#"
            > +--[ ]( a )--<JMP>( x )--<CALL>( f )--+
                                  ^ error[unknown-label]: there is no label `x` to jump to
                help: a jump stays in its own program or function: put a label there, or use <CALL>
                at 5:11 `x`: the label of this name belongs to another function or block
        "#]],
    );
    // Each function has labels of its own.
    clean("+--<LBL>( x )--( )( p )--<CALL>( f )--+\n\n+--<FUN>( f )--+\n\n+--<LBL>( x )--( )( q )--+\n");
}

#[test]
fn functions() {
    check(
        "+--[ ]( a )--<CALL>( fil )--+\n\n+--<FUN>( fill )--( )( y )--+\n",
        expect![[r#"
            > +--[ ]( a )--<CALL>( fil )--+
                                   ^^^ error[unknown-function]: there is no function `fil`
                help: did you mean `fill`?
        "#]],
    );
    check(
        "+--<CALL>( f )--+\n\n+--<FUN>( f )--( )( y )--+\n\n+--<FUN>( F )--( )( z )--+\n",
        expect![[r#"
            > +--<FUN>( F )--( )( z )--+
                        ^ error[duplicate-function]: the function `F` is defined twice
                help: remove one of the functions, or give one of them another name
                at 3:11 `f`: `f` is first defined here
        "#]],
    );
    check(
        "+--<CALL>( f )--<CALL>( g )--+\n\n+--<FUN>( f )--<FUN>( g )--( )( y )--+\n",
        expect![[r#"
            > +--<CALL>( f )--<CALL>( g )--+
                                      ^ error[unknown-function]: there is no function `g`
                help: a function begins with a network that holds <FUN>( g )
            > +--<FUN>( f )--<FUN>( g )--( )( y )--+
                             ^^^^^ error[wrong-place]: this network begins two functions
                help: give each function a network of its own to begin with
        "#]],
    );
}

const DEBOUNCE: &str = "\
FUNCTION_BLOCK [$Debounce]
VAR_INPUT
    raw  : BOOL;
    wait : TIME;
END_VAR
VAR_OUTPUT
    clean : BOOL;
END_VAR
VAR
    t : TON;
END_VAR
+--[ ]( EN )--[ ]( raw )--[TON]( t, wait )--( )( clean )--( )( ENO )--+
END_FUNCTION_BLOCK

";

#[test]
fn uses_of_blocks() {
    clean(&format!("{DEBOUNCE}+--[$Debounce]( a, T#20ms, y )--+\n"));
    check(
        &format!("{DEBOUNCE}+--[$Debounc]( a, T#20ms, y )--+\n"),
        expect![[r#"
            > +--[$Debounc]( a, T#20ms, y )--+
                 ^^^^^^^^^^ error[unknown-block]: there is no block [$Debounc]
                help: did you mean [$Debounce]?
                fix: Replace with [$Debounce]
                  +-------------------------------------------------[$Debounce]( a, T#20ms, y )--+
        "#]],
    );
    check(
        &format!("{DEBOUNCE}+--($Debounce)( a, T#20ms, y )--+\n"),
        expect![[r#"
            > +--($Debounce)( a, T#20ms, y )--+
                 ^^^^^^^^^^^ error[wrong-shape]: the block is drawn [$Debounce], not ($Debounce)
                help: a block keeps the brackets of its definition
                at 1:16 `[$Debounce]`: it is defined here
                safe fix: Replace with [$Debounce]
                  +-------------------------------------------------[$Debounce]( a, T#20ms, y )--+
        "#]],
    );
    check(
        &format!("{DEBOUNCE}+--[$Debounce]( a )--+\n"),
        expect![[r#"
        > +--[$Debounce]( a )--+
             ^^^^^^^^^^^^^^^^ error[bad-arity]: the operand `wait` of [$Debounce] is missing
            help: it is written [$Debounce]( raw, wait, clean )
            at 1:16 `[$Debounce]`: the block is defined here
    "#]],
    );
    check(
        &format!("{DEBOUNCE}+--[$Debounce]( a, T#20ms, y, z )--+\n"),
        expect![[r#"
            > +--[$Debounce]( a, T#20ms, y, z )--+
                                            ^ error[bad-arity]: [$Debounce] takes 3 operands, 4 are given
                help: it is written [$Debounce]( raw, wait, clean )
                at 1:16 `[$Debounce]`: the block is defined here
        "#]],
    );
    check(
        &format!("{DEBOUNCE}+--[$Debounce]( a, T#20ms, raw := b, wat := y )--+\n"),
        expect![[r#"
            > +--[$Debounce]( a, T#20ms, raw := b, wat := y )--+
                                         ^^^^^^^^ error[bad-arity]: the operand `raw` of [$Debounce] is given twice
                help: leave one of them out
                at 15:17 `a`: it is given here before
            > +--[$Debounce]( a, T#20ms, raw := b, wat := y )--+
                                                   ^^^ error[bad-operand]: [$Debounce] has no operand of the name `wat`
                help: did you mean `wait`?
        "#]],
    );
    check(
        "+--[$Valve]( a )--+\n",
        expect![[r#"
        > +--[$Valve]( a )--+
             ^^^^^^^^ error[unknown-block]: there is no block [$Valve]
            help: define it: FUNCTION_BLOCK [$Valve], its declarations and rungs, END_FUNCTION_BLOCK
    "#]],
    );
}

#[test]
fn definitions_of_blocks() {
    check(
        "FUNCTION_BLOCK [$A]\n+--( )( ENO )--+\nEND_FUNCTION_BLOCK\nFUNCTION_BLOCK ($a)\n+--( )( ENO )--+\nEND_FUNCTION_BLOCK\n",
        expect![[r#"
            > FUNCTION_BLOCK ($a)
                             ^^^^ error[duplicate-block]: the block `$a` is defined twice
                help: remove one of the definitions, or give one block another name; one name has one shape
                at 1:16 `[$A]`: `$A` is first defined here
        "#]],
    );
    check(
        "FUNCTION_BLOCK [$A]\n+--[$A]--( )( ENO )--+\nEND_FUNCTION_BLOCK\n",
        expect![[r#"
            > FUNCTION_BLOCK [$A]
                             ^^^^ error[recursive-block]: the block `$A` uses itself
                help: every place of a block has a state of its own, so a block cannot contain itself: break the circle
                at 2:4 `[$A]`: `$A` is used here
        "#]],
    );
    check(
        "FUNCTION_BLOCK [$A]\n+--[$B]--( )( ENO )--+\nEND_FUNCTION_BLOCK\nFUNCTION_BLOCK [$B]\n+--[$C]--( )( ENO )--+\nEND_FUNCTION_BLOCK\nFUNCTION_BLOCK [$C]\n+--[$B]--( )( ENO )--+\nEND_FUNCTION_BLOCK\n",
        expect![[r#"
            > FUNCTION_BLOCK [$B]
                             ^^^^ error[recursive-block]: the block `$B` uses itself: it uses `$C`, which uses `$B`
                help: every place of a block has a state of its own, so a block cannot contain itself: break the circle
                at 5:4 `[$C]`: `$C` is used here
                at 8:4 `[$B]`: `$B` is used here
        "#]],
    );
    check(
        "FUNCTION_BLOCK [$A]\n+--<END>--+\n+--<FUN>( f )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n",
        expect![[r#"
            > +--<END>--+
                 ^^^^^ error[wrong-place]: <END> cannot be in this block
                help: <RET> ends the body of the block
                at 1:16 `[$A]`: this is the block
            > +--<FUN>( f )--( )( ENO )--+
                 ^^^^^ error[wrong-place]: <FUN> cannot be in this block
                help: write the function in the program, or in the body of a <$B> block
                at 1:16 `[$A]`: this is the block
        "#]],
    );
}

#[test]
fn labels_around_a_block() {
    let block = |body: &str| {
        format!("FUNCTION_BLOCK <$Skip>\n+--[ ]( EN )--<JMP>( there )--+\n{body}END_FUNCTION_BLOCK\n\n")
    };
    clean(&format!(
        "{}+--<$Skip>--+\n\n+--<LBL>( there )--( )( y )--+\n",
        block("")
    ));
    clean(&format!(
        "{}+--<$Skip>--+\n",
        block("+--<LBL>( there )--( )( ENO )--+\n")
    ));
    check(
        &format!(
            "{}+--<$Skip>--<CALL>( f )--+\n\n+--<LBL>( there )--( )( y )--+\n\n+--<FUN>( f )--<$Skip>--+\n",
            block("")
        ),
        expect![[r#"
            > +--[ ]( EN )--<JMP>( there )--+
                                   ^^^^^ error[unknown-label]: there is no label `there` in the block, nor where the block is
                help: put the label into the block, or at each place that uses the block
                at 9:16 `<$Skip>`: here the block is, and no label of this name
        "#]],
    );
    check(
        &format!(
            "{}FUNCTION_BLOCK <$Outer>\n+--<$Skip>--+\nEND_FUNCTION_BLOCK\n\n+--<$Outer>--+\n",
            block("")
        ),
        expect![[r#"
            > +--[ ]( EN )--<JMP>( there )--+
                                   ^^^^^ error[unknown-label]: there is no label `there` in the block, nor where the block is
                help: put the label into the block, or at each place that uses the block
                at 9:4 `<$Outer>`: here the block is, and no label of this name
        "#]],
    );
    // In other shapes a jump stays in the body.
    check(
        "FUNCTION_BLOCK [$Skip]\n+--[ ]( EN )--<JMP>( there )--+\nEND_FUNCTION_BLOCK\n\n+--[$Skip]--<LBL>( there )--( )( y )--+\n",
        expect![[r#"
            > +--[ ]( EN )--<JMP>( there )--+
                                   ^^^^^ error[unknown-label]: there is no label `there` to jump to
                help: a jump stays in its own program or function: put a label there, or use <CALL>
                at 5:20 `there`: the label of this name belongs to another function or block
        "#]],
    );
}

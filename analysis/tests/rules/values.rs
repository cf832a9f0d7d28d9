//! What single blocks are given: numbers, durations, spellings; and what is after what.

use crate::check::{check, check_program, clean};
use expect_test::expect;

#[test]
fn reals() {
    let tags = "VAR_INPUT\n    r, s : REAL;\n    n : INT;\nEND_VAR\nVAR_OUTPUT\n    b : BOOL;\nEND_VAR\n";
    check(
        &format!("{tags}+--[EQ]( r, s )--[NE]( r, 2.5 )--( )( b )--+\n"),
        expect![[r#"
            > +--[EQ]( r, s )--[NE]( r, 2.5 )--( )( b )--+
                 ^^^^^^^^^^^^ warning[real-equality]: two real numbers are nearly never exactly equal: this may not conduct when it should
                help: compare with a tolerance: one [GE] for the lower and one [LE] for the upper limit
            > +--[EQ]( r, s )--[NE]( r, 2.5 )--( )( b )--+
                               ^^^^^^^^^^^^^^ warning[real-equality]: two real numbers are nearly always unequal: this conducts although they are as good as the same
                help: compare with a tolerance: one [GE] for the lower and one [LE] for the upper limit
        "#]],
    );
    check(
        &format!("{tags}+--[CALC]( b, r * 2.0 = s OR n = 3 )--+\n"),
        expect![[r#"
            > +--[CALC]( b, r * 2.0 = s OR n = 3 )--+
                            ^^^^^^^^^^^ warning[real-equality]: two real numbers are nearly never exactly equal: this may not conduct when it should
                help: compare with a tolerance: one [GE] for the lower and one [LE] for the upper limit
        "#]],
    );
    clean(&format!(
        "{tags}+--[NE]( r, 0.0 )--[EQ]( n, 5 )--[GE]( r, s )--( )( b )--+\n"
    ));
}

#[test]
fn zero() {
    check(
        "VAR CONSTANT\n    NOTHING : INT := 0;\nEND_VAR\nVAR_OUTPUT\n    y : INT;\nEND_VAR\nVAR_INPUT\n    a : INT;\nEND_VAR\n+--[DIV]( y, a, 0 )--[MOD]( y, a, NOTHING )--[CALC]( y, a / 0 + a MOD 0 )--[DIV]( y, 0, a )--+\n",
        expect![[r#"
            > +--[DIV]( y, a, 0 )--[MOD]( y, a, NOTHING )--[CALC]( y, a / 0 + a MOD 0 )--[DIV]( y, 0, a )--+
                              ^ warning[division-by-zero]: this divides by zero: every time it runs it is a fault, and no result is written
                help: divide by another number, or run the block only while the divisor is not zero
            > +--[DIV]( y, a, 0 )--[MOD]( y, a, NOTHING )--[CALC]( y, a / 0 + a MOD 0 )--[DIV]( y, 0, a )--+
                                                ^^^^^^^ warning[division-by-zero]: this divides by zero: every time it runs it is a fault, and no result is written
                help: divide by another number, or run the block only while the divisor is not zero
            > +--[DIV]( y, a, 0 )--[MOD]( y, a, NOTHING )--[CALC]( y, a / 0 + a MOD 0 )--[DIV]( y, 0, a )--+
                                                                          ^ warning[division-by-zero]: this divides by zero: every time it runs it is a fault, and no result is written
                help: divide by another number, or run the block only while the divisor is not zero
            > +--[DIV]( y, a, 0 )--[MOD]( y, a, NOTHING )--[CALC]( y, a / 0 + a MOD 0 )--[DIV]( y, 0, a )--+
                                                                                    ^ warning[division-by-zero]: this divides by zero: every time it runs it is a fault, and no result is written
                help: divide by another number, or run the block only while the divisor is not zero
        "#]],
    );
}

#[test]
fn presets() {
    check(
        "+--[ ]( a )--[TON]( t, 5 )--[TOF]( u, T#0s )--[TP]( v, 500us )--( )( y )--+\n",
        expect![[r#"
            > +--[ ]( a )--[TON]( t, 5 )--[TOF]( u, T#0s )--[TP]( v, 500us )--( )( y )--+
                                     ^ warning[short-preset]: the preset is shorter than a scan of 10 ms: the timer cannot tell it from one scan
                help: a plain number is milliseconds: 5 s is written T#5s
            > +--[ ]( a )--[TON]( t, 5 )--[TOF]( u, T#0s )--[TP]( v, 500us )--( )( y )--+
                                                    ^^^^ warning[short-preset]: the preset is 0: the timer does not wait
                help: give a time of at least a scan, or leave the timer out
            > +--[ ]( a )--[TON]( t, 5 )--[TOF]( u, T#0s )--[TP]( v, 500us )--( )( y )--+
                                                                     ^^^^^ warning[short-preset]: the preset is shorter than a scan of 10 ms: the timer cannot tell it from one scan
                help: give a time of at least a scan, or leave the timer out
        "#]],
    );
    clean("+--[ ]( a )--[TON]( t, 10 )--[TOF]( u, T#10ms )--( )( y )--+\n");
}

#[test]
fn signs() {
    check(
        "VAR_OUTPUT\n    y : LREAL;\nEND_VAR\nVAR_INPUT\n    x : LREAL;\nEND_VAR\n+--[CALC]( y, -x ^ 2.0 + -3.0 ^ 2.0 - ( -x ) ^ 2.0 - x ^ 2.0 )--+\n",
        expect![[r#"
            > +--[CALC]( y, -x ^ 2.0 + -3.0 ^ 2.0 - ( -x ) ^ 2.0 - x ^ 2.0 )--+
                            ^^^^^^^^ info[ambiguous-sign]: the sign is taken before the power: -2 ^ 2 is 4 here, and -4 in mathematics
                help: show with parentheses what is meant: (-a) ^ b, or -(a ^ b)
                safe fix: Put parentheses around what it means now
                  +-----------------[CALC]( y, (-x) ^ 2.0 + -3.0 ^ 2.0 - (-x) ^ 2.0 - x ^ 2.0 )--+
            > +--[CALC]( y, -x ^ 2.0 + -3.0 ^ 2.0 - ( -x ) ^ 2.0 - x ^ 2.0 )--+
                                       ^^^^^^^^^^ info[ambiguous-sign]: the sign is taken before the power: -2 ^ 2 is 4 here, and -4 in mathematics
                help: show with parentheses what is meant: (-a) ^ b, or -(a ^ b)
                safe fix: Put parentheses around what it means now
                  +-----------------[CALC]( y, -x ^ 2.0 + (-3.0) ^ 2.0 - (-x) ^ 2.0 - x ^ 2.0 )--+
        "#]],
    );
}

#[test]
fn spellings() {
    check_program(
        "+--[GRT]( n, 5 )--[equ]( n, 7 )--[R_TRIG]--( )( y )--+\n",
        expect![[r#"
            > +--[GRT]( n, 5 )--[equ]( n, 7 )--[R_TRIG]--( )( y )--+
                 ^^^^^ info[alternative-mnemonic]: [GRT] is another spelling of [GT]
                help: one spelling for one instruction makes a program easy to search
                safe fix: Write [GT]
                  +--[GT]( n, 5 )--[EQU]( n, 7 )--[R_TRIG]-----------------------------( )( y )--+
            > +--[GRT]( n, 5 )--[equ]( n, 7 )--[R_TRIG]--( )( y )--+
                 ^^^^^^^^^^^^^ warning[redundant-element]: [GT]( n, 5 ) changes nothing here
                help: a wire in its place does the same: remove it, or correct the tag that was meant
                fix: Draw a wire in its place
                  +--[EQU]( n, 7 )--[R_TRIG]-------------------------------------------( )( y )--+
            > +--[GRT]( n, 5 )--[equ]( n, 7 )--[R_TRIG]--( )( y )--+
                                ^^^^^ info[alternative-mnemonic]: [equ] is another spelling of [EQ]
                help: one spelling for one instruction makes a program easy to search
                safe fix: Write [EQ]
                  +--[GRT]( n, 5 )--[EQ]( n, 7 )--[R_TRIG]-----------------------------( )( y )--+
            > +--[GRT]( n, 5 )--[equ]( n, 7 )--[R_TRIG]--( )( y )--+
                                               ^^^^^^^^ info[alternative-mnemonic]: [R_TRIG] is another spelling of [OSR]
                help: one spelling for one instruction makes a program easy to search
                safe fix: Write [OSR]
                  +--[GRT]( n, 5 )--[EQU]( n, 7 )--[OSR]-------------------------------( )( y )--+
        "#]],
    );
    clean("+--[GRT]( n, 5 )--[R_TRIG]--( )( y )--+\n");
    check(
        "FUNCTION_BLOCK [$B]\nVAR_INPUT\n    a : BOOL;\nEND_VAR\nVAR_OUTPUT\n    y : BOOL;\nEND_VAR\n+--[ ]( a )--( )( y )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n\n+--[$B]( a := p, y := q )--( )( r )--+\n",
        expect![[r#"
            > +--[$B]( a := p, y := q )--( )( r )--+
                                 ^^ info[result-arrow]: `y` is a result of [$B]: it is taken with `=>`
                help: `:=` gives an operand, `=>` takes a result
                safe fix: Replace `:=` with `=>`
                  +--------------------------------------------[$B]( a := p, y => q )--( )( r )--+
        "#]],
    );
}

#[test]
fn after_coils() {
    check(
        "+--[ ]( a )--( )( y )--[ ]( b )--( )( z )--[ ]( c )--( )( q )--+\n",
        expect![[r#"
            > +--[ ]( a )--( )( y )--[ ]( b )--( )( z )--[ ]( c )--( )( q )--+
                                     ^^^^^^^^ warning[contact-after-coil]: [ ]( b ) is after a coil: readers look for it left of the coils
                help: draw a branch before the coil: the coil on one line, this contact and what it leads to on the other
                at 1:14 `( )( y )`: this is the coil
        "#]],
    );
    check(
        "+--[ ]( a )--(S)( y )--[TON]( t, T#5s )--( )( z )--+\n",
        expect![[r#"
            > +--[ ]( a )--(S)( y )--[TON]( t, T#5s )--( )( z )--+
                                     ^^^^^^^^^^^^^^^^ warning[latched-power]: [TON]( t, T#5s ) is after (S): its power is `y`, and stays on when the rung before goes off
                help: draw a branch before the set coil; if the latched power is meant, put a contact of the tag on a rung of its own
                at 1:14 `(S)( y )`: the set coil
                fix: Draw a branch before (S)( y )
                  +--[ ]( a )--\-------------------------------------------------------(S)( y )--+
                  |            /-------------------------------------[TON]( t, T#5s )--( )( z )--+
        "#]],
    );
    // However the operator is written, the sentence is the same.
    check(
        "VAR i : INT; t : ARRAY[1..3] OF INT; END_VAR\n+--(S)( Q1 )--[search]( i, eq, 5, t[1..3], FOUND => Q2 )--+\n",
        expect![[r#"
            > +--(S)( Q1 )--[search]( i, eq, 5, t[1..3], FOUND => Q2 )--+
                            ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ warning[latched-power]: [SEARCH]( i, EQ, 5, t[1..3], Q2 ) is after (S): its power is `Q1`, and stays on when the rung before goes off
                help: draw a branch before the set coil; if the latched power is meant, put a contact of the tag on a rung of its own
                at 2:4 `(S)( Q1 )`: the set coil
                fix: Draw a branch before (S)( Q1 )
                  +--\----------------------------------------------------------------(S)( Q1 )--+
                  |  /-------------------------------[SEARCH]( i, EQ, 5, t[1..3], FOUND => Q2 )--+
        "#]],
    );
    clean("+--[ ]( a )--( )( y )--[TON]( t, T#5s )--( )( z )--+\n");
    clean("+--[ ]( a )--\\--( )( y )--\\--+\n|            /--( )( z )--/  |\n");
    clean("+--[ ]( a )--\\--(S)( y )--\\--+\n|            /--(S)( z )--/  |\n");
}

#[test]
fn dead_ends() {
    check(
        "+--\\--[ ]( a )--( )( y )--+\n|  /--[ ]( b )--[ ]( c )--+\n",
        expect![[r#"
            > |  /--[ ]( b )--[ ]( c )--+
                    ^^^^^^^^ warning[dead-end]: the power of [ ]( b ) goes nowhere: nothing that acts is after it
                help: put a coil or another block after it, join the line to another with \ and /, or remove it
        "#]],
    );
    check(
        "+--[ ]( a )--( )( y )--[ ]( b )--+\n",
        expect![[r#"
            > +--[ ]( a )--( )( y )--[ ]( b )--+
                                     ^^^^^^^^ warning[dead-end]: the power of [ ]( b ) goes nowhere: nothing that acts is after it
                help: put a coil or another block after it, join the line to another with \ and /, or remove it
        "#]],
    );
    check(
        "+--[ ]( a )--\\--( )( y )--+\n|            /--          |\n",
        expect![[r#"
            > |            /--          |
                            ^^ warning[dead-end]: this wire ends at nothing
                help: draw it on to a connector or a block, or remove it
        "#]],
    );
    clean("+--[ ]( a )--\\--( )( y )--\n|            /--( )( z )  |\n");
    clean(
        "+--[ ]( a )--\\--( )( y )--\\--+\n|            /--( )( z )--/  |\n\n+--<LBL>( x )--+\n\n+--<FUN>( f )--+\n",
    );
}

#[test]
fn comments() {
    check(
        "# +--[ ]( a )--( )( y )--+ #\n+--[ ]( b )--( )( y )--+\n",
        expect![[r#"
            > # +--[ ]( a )--( )( y )--+ #
              ^^^^^^^^^^^^^^^^^^^^^^^^^^^^ info[commented-out-rung]: this comment is a rung: nobody can tell whether it still belongs to the program
                help: remove it (an old version is kept by version control), or switch it off with [ ]( SYS.OFF )
        "#]],
    );
    check(
        "# old:\n|\n#\n# +--\\--[ ]( a )--\\--( )( y )--+\n  |  /--[ ]( b )--/            | #\n+--[ ]( b )--( )( y )--+\n",
        expect![[r#"
            > # +--\--[ ]( a )--\--( )( y )--+
              ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ info[commented-out-rung]: this comment is a rung: nobody can tell whether it still belongs to the program
                help: remove it (an old version is kept by version control), or switch it off with [ ]( SYS.OFF )
        "#]],
    );
    clean("# +---- pumps ( left ) ----+ #\n# a --( b )--> c #\n+--[ ]( b )--( )( y )--+\n");
}

#[test]
fn complex() {
    let contacts: Vec<String> = (0..17).map(|n| format!("[ ]( c{n}x )--")).collect();
    let contacts = contacts.concat();
    check_program(
        &format!("+--{contacts}( )( y )--+\n"),
        expect![[r#"
        > +--[ ]( c0x )--[ ]( c1x )--[ ]( c2x )--[ ]( c3x )--[ ]( c4x )--[ ]( c5x )--[ ]( c6x )--[ ]( c7x )--[ ]( c8x )--[ ]( c9x )--[ ]( c10x )--[ ]( c11x )--[ ]( c12x )--[ ]( c13x )--[ ]( c14x )--[ ]( c15x )--[ ]( c16x )--( )( y )--+
          ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ info[complex-network]: this network has 17 conditions, more than 16
            help: give parts of it tags of their own, each on a rung above, with names that say what they mean
    "#]],
    );
}

#[test]
fn the_next_of_a_search_needs_an_index_that_is_free() {
    let search = |first: i64| {
        format!(
            "VAR r : ARRAY[{first}..3] OF REAL; y : INT; n : BOOL; END_VAR\n\
             +--[SEARCH]( y, EQ, 1.0, r[1..3], NEXT := n )--+\n+--[SEARCH]( y, EQ, 1.0, r[1..3] )--+\n"
        )
    };
    check(
        &search(-1),
        expect![[r#"
        > +--[SEARCH]( y, EQ, 1.0, r[1..3], NEXT := n )--+
                                            ^^^^^^^^^ error[bad-operand]: `r` begins at -1: NEXT goes on after the index in the result, where -1 says that nothing was found
            help: let the array begin at 0 or 1
    "#]],
    );
    clean(&search(0));
}

#[test]
fn pi_is_for_expressions() {
    check(
        "VAR r : LREAL; END_VAR\n+--[MOV]( r, PI )--[GT]( PI, r )--[CALC]( r, PI * 2.0 )--+\n+--[ ]( Pi )--(S)( pi )--+\n",
        expect![[r#"
            > +--[MOV]( r, PI )--[GT]( PI, r )--[CALC]( r, PI * 2.0 )--+
                           ^^ error[bad-operand]: PI is a number for the expressions of [CALC], no tag
                help: compute with it there: [CALC]( result, PI * radius ), then use the result
            > +--[MOV]( r, PI )--[GT]( PI, r )--[CALC]( r, PI * 2.0 )--+
                                       ^^ error[bad-operand]: PI is a number for the expressions of [CALC], no tag
                help: compute with it there: [CALC]( result, PI * radius ), then use the result
            > +--[ ]( Pi )--(S)( pi )--+
                      ^^ error[bad-operand]: PI is a number for the expressions of [CALC], no tag
                help: compute with it there: [CALC]( result, PI * radius ), then use the result
            > +--[ ]( Pi )--(S)( pi )--+
                                 ^^ error[bad-operand]: PI is a number for the expressions of [CALC], no tag
                help: compute with it there: [CALC]( result, PI * radius ), then use the result
        "#]],
    );
}

#[test]
fn the_time_base_belongs_to_another_profile() {
    check(
        "+--[TON]( t, 5s, R := r, B := T#1s )--( )( y )--+\n",
        expect![[r#"
            > +--[TON]( t, 5s, R := r, B := T#1s )--( )( y )--+
                                       ^^^^^^^^^ error[bad-operand]: [TON] has no operand `B` in the profile `iec`
                help: leave it out, or say above the first network whose arithmetic the program has: # ladder: profile click # or # ladder: profile iot #
        "#]],
    );
}

#[test]
fn times_that_a_profile_cannot_count() {
    check(
        "# ladder: profile ldmicro #\n# ladder: cycle 5ms #\n+--[TON]( t, 9ms )--[TOF]( u, 10ms )--[RTO]( v, 1h )--( )( y )--+\n",
        expect![[r#"
            > +--[TON]( t, 9ms )--[TOF]( u, 10ms )--[RTO]( v, 1h )--( )( y )--+
                           ^^^ warning[short-preset]: the time is 1 scan of 5 ms: timers of this profile take 2 or more
                help: give a longer time, or a shorter scan above the first network, as in: # ladder: cycle 1ms #
            > +--[TON]( t, 9ms )--[TOF]( u, 10ms )--[RTO]( v, 1h )--( )( y )--+
                                                              ^^ warning[short-preset]: the time is 720000 scans of 5 ms: timers of this profile count to 32768
                help: give a shorter time, or a longer scan above the first network, as in: # ladder: cycle 100ms #
        "#]],
    );
    check(
        "# ladder: profile iot #\n+--[TON]( t, 0 )--[TON]( u, 3, B := 5ms )--[TOF]( v, 3 )--( )( y )--+\n",
        expect![[r#"
            > +--[TON]( t, 0 )--[TON]( u, 3, B := 5ms )--[TOF]( v, 3 )--( )( y )--+
                           ^ warning[short-preset]: the preset is 0 or less: the first step reaches it
                help: count one step or more
            > +--[TON]( t, 0 )--[TON]( u, 3, B := 5ms )--[TOF]( v, 3 )--( )( y )--+
                                          ^ warning[short-preset]: the time base is 5 ms and a scan 10 ms: a timer counts one step in a scan at most, and runs slow
                help: take a longer time base, or a shorter scan
        "#]],
    );
}

#[test]
fn a_division_by_zero_in_a_profile() {
    for (profile, expected) in [
        (
            "ldmicro",
            expect![[r#"
        > +--[DIV]( n, m, 0 )--+
                          ^ warning[division-by-zero]: this divides by zero: every time it runs the result is 0, and the scan is the last one
            help: divide by another number, or run the block only while the divisor is not zero
    "#]],
        ),
        (
            "click",
            expect![[r#"
        > +--[DIV]( n, m, 0 )--+
                          ^ warning[division-by-zero]: this divides by zero: every time it runs the result is 0, and the controller tells of an error
            help: divide by another number, or run the block only while the divisor is not zero
    "#]],
        ),
    ] {
        check(
            &format!("# ladder: profile {profile} #\n+--[DIV]( n, m, 0 )--+\n"),
            expected,
        );
    }
}

#[test]
fn units_of_a_timer() {
    check(
        "# ladder: profile click #\n+--[TON]( t, 1m )--[TON]( u, 40000, B := 1s )--[TOF]( v, 3s, B := 1m )--[RTO]( w, 2m, B := 1s )--( )( y )--+\n",
        expect![[r#"
            > +--[TON]( t, 1m )--[TON]( u, 40000, B := 1s )--[TOF]( v, 3s, B := 1m )--[RTO]( w, 2m, B := 1s )--( )( y )--+
                           ^^ warning[short-preset]: the preset is 60000 units: timers of this profile count to 32767
                help: count in a longer unit, as in: B := T#1s
            > +--[TON]( t, 1m )--[TON]( u, 40000, B := 1s )--[TOF]( v, 3s, B := 1m )--[RTO]( w, 2m, B := 1s )--( )( y )--+
                                           ^^^^^ warning[short-preset]: the preset is 40000 units: timers of this profile count to 32767
                help: count in a longer unit, as in: B := T#1s
            > +--[TON]( t, 1m )--[TON]( u, 40000, B := 1s )--[TOF]( v, 3s, B := 1m )--[RTO]( w, 2m, B := 1s )--( )( y )--+
                                                                       ^^ warning[short-preset]: the preset is less than one unit of the timer: it does not wait
                help: give at least one unit; B := T#1s sets the unit, 1 ms unless given
        "#]],
    );
}

#[test]
fn what_a_profile_takes() {
    check(
        "# ladder: profile ldmicro #\nVAR c : CTU; t : TON; END_VAR\n+--[CTU]( c, 2 )--[CTD]( c, 1 )--[MOV]( c.CV, 3 )--[MOV]( t.ET, 2 )--[TON]( t, 1s )--[TP]( p, 1s )--( )( y )--+\n",
        expect![[r#"
            > +--[CTU]( c, 2 )--[CTD]( c, 1 )--[MOV]( c.CV, 3 )--[MOV]( t.ET, 2 )--[TON]( t, 1s )--[TP]( p, 1s )--( )( y )--+
                                                                                                   ^^^^ error[unknown-instruction]: there is no [TP] in the profile `ldmicro`
                help: its timers and counters are [TON] [TOF] [RTO] [CTU] [CTD] [CTC]
            > +--[CTU]( c, 2 )--[CTD]( c, 1 )--[MOV]( c.CV, 3 )--[MOV]( t.ET, 2 )--[TON]( t, 1s )--[TP]( p, 1s )--( )( y )--+
                                                                                                         ^ warning[undeclared-tag]: `p` is not declared
                help: declare it, so that a typing error cannot make a new tag
                fix: Declare `p : TP` in VAR
                  VAR
                      c : CTU;
                      t : TON;
                      p : TP;
                  END_VAR
            > +--[CTU]( c, 2 )--[CTD]( c, 1 )--[MOV]( c.CV, 3 )--[MOV]( t.ET, 2 )--[TON]( t, 1s )--[TP]( p, 1s )--( )( y )--+
                                                                                                                       ^ warning[undeclared-tag]: `y` is not declared
                help: declare it, so that a typing error cannot make a new tag
                fix: Declare `y : BOOL` in VAR_OUTPUT
                  VAR_OUTPUT
                      y : BOOL;
                  END_VAR
        "#]],
    );
    check(
        "# ladder: profile iot #\nVAR c : CTU; END_VAR\n+--[ ]( MI01 )--[AND]( Q1, c.AC, 4 )--[ADD]( MF01, I1, 0.5 )--( )( MI02 )--[EQ]( I1, 1 )--( )( y )--+\n",
        expect![[r#"
            > +--[ ]( MI01 )--[AND]( Q1, c.AC, 4 )--[ADD]( MF01, I1, 0.5 )--( )( MI02 )--[EQ]( I1, 1 )--( )( y )--+
                                                                                         ^^^^^^^^^^^^^ warning[contact-after-coil]: [EQ]( I1, 1 ) is after a coil: readers look for it left of the coils
                help: draw a branch before the coil: the coil on one line, this contact and what it leads to on the other
                at 3:63 `( )( MI02 )`: this is the coil
            > +--[ ]( MI01 )--[AND]( Q1, c.AC, 4 )--[ADD]( MF01, I1, 0.5 )--( )( MI02 )--[EQ]( I1, 1 )--( )( y )--+
                                                                                                             ^ warning[undeclared-tag]: `y` is not declared
                help: declare it, so that a typing error cannot make a new tag
                fix: Declare `y : BOOL` in VAR_OUTPUT
                  VAR_OUTPUT
                      y : BOOL;
                  END_VAR
        "#]],
    );
}

#[test]
fn what_is_no_address() {
    check(
        "VAR a : BOOL; END_VAR\n+--[ ]( %ZX0.1 )--[ ]( %Q0.1 )--[GT]( %IW, 3 )--[ ]( %IX0.9 )--[ ]( a )--( )( %mx )--+\n",
        expect![[r#"
            > +--[ ]( %ZX0.1 )--[ ]( %Q0.1 )--[GT]( %IW, 3 )--[ ]( %IX0.9 )--[ ]( a )--( )( %mx )--+
                      ^^^^^^ error[bad-operand]: `%ZX0.1` is not an address: write one like %IX0.0, %QW1 or %MD2
            > +--[ ]( %ZX0.1 )--[ ]( %Q0.1 )--[GT]( %IW, 3 )--[ ]( %IX0.9 )--[ ]( a )--( )( %mx )--+
                                     ^^^^^ error[bad-operand]: `%Q0.1` is not an address: write one like %IX0.0, %QW1 or %MD2
            > +--[ ]( %ZX0.1 )--[ ]( %Q0.1 )--[GT]( %IW, 3 )--[ ]( %IX0.9 )--[ ]( a )--( )( %mx )--+
                                                    ^^^ error[bad-operand]: `%IW` is not an address: write one like %IX0.0, %QW1 or %MD2
            > +--[ ]( %ZX0.1 )--[ ]( %Q0.1 )--[GT]( %IW, 3 )--[ ]( %IX0.9 )--[ ]( a )--( )( %mx )--+
                                                                                            ^^^ error[bad-operand]: `%mx` is not an address: write one like %IX0.0, %QW1 or %MD2
        "#]],
    );
}

#[test]
fn ranges_that_cannot_fit() {
    let declared = "VAR CONSTANT\n    TOP : INT := 9;\nEND_VAR\nVAR\n    a, b : ARRAY[1..10] OF INT;\n    bits : ARRAY[0..40] OF BOOL;\n    texts : ARRAY[1..300] OF STRING;\n    wide : ARRAY[0..3] OF DWORD;\n    i : INT;\n    w : WORD;\n    s : SINT;\n    u : USINT;\n    d : DWORD;\n    r : REAL;\n    t : STRING;\nEND_VAR\n";
    check(
        &format!(
            "{declared}+--[BMOV]( a[1..3], b[1..4] )--[BMOV]( a[1..3], b[TOP] )--[BMOV]( a[8], b[1..4] )--+\n\n\
             +--[BMOV]( a[TOP..10], b[1..3] )--[FILL]( a[TOP..3], 5 )--+\n\n\
             +--[PACK]( w, bits[0..16] )--[PACK]( d, a[1..3] )--[PACK]( w, wide[1..i] )--[PACK]( r, bits[0..3] )--[PACK]( w, i )--+\n\n\
             +--[UNPACK]( bits[0..40], r )--[UNPACK]( i, w )--+\n\n\
             +--[SEARCH]( s, EQ, 't', texts[1..200] )--[SEARCH]( u, EQ, 't', texts[i..255] )--[SEARCH]( u, EQ, 't', texts[2] )--+\n"
        ),
        expect![[r#"
            > +--[BMOV]( a[1..3], b[1..4] )--[BMOV]( a[1..3], b[TOP] )--[BMOV]( a[8], b[1..4] )--+
                                  ^^^^^^^ error[bad-operand]: this range has 4 elements, and the one it is copied to has 3
                help: give both one length; or write one of them as an index alone, where it starts: it is as long as the other
            > +--[BMOV]( a[1..3], b[1..4] )--[BMOV]( a[1..3], b[TOP] )--[BMOV]( a[8], b[1..4] )--+
                                                              ^^^^^^ error[bad-operand]: the array ends at 10: there are no 3 elements from 9 on
                help: the range is as long as the other one: begin further up, or copy fewer
            > +--[BMOV]( a[1..3], b[1..4] )--[BMOV]( a[1..3], b[TOP] )--[BMOV]( a[8], b[1..4] )--+
                                                                                ^^^^ error[bad-operand]: the array ends at 10: there are no 4 elements from 8 on
                help: the range is as long as the other one: begin further up, or copy fewer
            > +--[BMOV]( a[TOP..10], b[1..3] )--[FILL]( a[TOP..3], 5 )--+
                                     ^^^^^^^ error[bad-operand]: this range has 3 elements, and the one it is copied to has 2
                help: give both one length; or write one of them as an index alone, where it starts: it is as long as the other
            > +--[BMOV]( a[TOP..10], b[1..3] )--[FILL]( a[TOP..3], 5 )--+
                                                        ^^^^^^^^^ error[bad-operand]: the range ends at 3, before it begins at 9: swap them
            > +--[PACK]( w, bits[0..16] )--[PACK]( d, a[1..3] )--[PACK]( w, wide[1..i] )--[PACK]( r, bits[0..3] )--[PACK]( w, i )--+
                            ^^^^^^^^^^^ error[bad-operand]: 17 elements of BOOL do not fit into a WORD: it takes 16
            > +--[PACK]( w, bits[0..16] )--[PACK]( d, a[1..3] )--[PACK]( w, wide[1..i] )--[PACK]( r, bits[0..3] )--[PACK]( w, i )--+
                                                      ^^^^^^^ error[bad-operand]: 3 elements of INT do not fit into a DWORD: it takes 2
            > +--[PACK]( w, bits[0..16] )--[PACK]( d, a[1..3] )--[PACK]( w, wide[1..i] )--[PACK]( r, bits[0..3] )--[PACK]( w, i )--+
                                                                            ^^^^^^^^^^ error[type-mismatch]: a DWORD does not fit into a WORD
            > +--[PACK]( w, bits[0..16] )--[PACK]( d, a[1..3] )--[PACK]( w, wide[1..i] )--[PACK]( r, bits[0..3] )--[PACK]( w, i )--+
                                                                                                                              ^ error[type-mismatch]: a range or a STRING is packed, this is an INT
            > +--[UNPACK]( bits[0..40], r )--[UNPACK]( i, w )--+
                                                       ^ error[type-mismatch]: a value is unpacked into a range or a STRING, this is an INT
            > +--[SEARCH]( s, EQ, 't', texts[1..200] )--[SEARCH]( u, EQ, 't', texts[i..255] )--[SEARCH]( u, EQ, 't', texts[2] )--+
                           ^ error[bad-operand]: the result is SINT, which cannot hold the index 200 that may be found
                help: declare the result as DINT
            > +--[SEARCH]( s, EQ, 't', texts[1..200] )--[SEARCH]( u, EQ, 't', texts[i..255] )--[SEARCH]( u, EQ, 't', texts[2] )--+
                                                                  ^ error[bad-operand]: the result is USINT, which cannot hold the index 255 that may be found
                help: declare the result as DINT
            > +--[SEARCH]( s, EQ, 't', texts[1..200] )--[SEARCH]( u, EQ, 't', texts[i..255] )--[SEARCH]( u, EQ, 't', texts[2] )--+
                                                                                                         ^ error[bad-operand]: the result is USINT, which cannot hold the index 300 that may be found
                help: declare the result as DINT
        "#]],
    );
    // What is right, and what nobody knows before it runs.
    clean(&format!(
        "{declared}+--[BMOV]( a[1..3], b[2..4] )--[BMOV]( a[1..3], b[8] )--[BMOV]( a[TOP], b[TOP..10] )--[BMOV]( a[i], b[1..10] )--[BMOV]( a[1..i], b[1..4] )--+\n\n\
         +--[PACK]( w, bits[0..15] )--[PACK]( d, a[1..2] )--[PACK]( d, bits[i..40] )--[PACK]( i, t )--[PACK]( w, a[3..3] )--+\n\n\
         +--[UNPACK]( bits[0..40], w )--[UNPACK]( a[1..10], d )--[UNPACK]( t, r )--+\n\n\
         +--[SEARCH]( s, EQ, 't', texts[1..127] )--[SEARCH]( u, EQ, 't', texts[1..254] )--[SEARCH]( i, EQ, 't', texts[1..300] )--[SHIFT]( a[1..1], 5 )--+\n"
    ));
}

#[test]
fn whole_arrays_as_ranges() {
    let declared = "VAR\n    bits : ARRAY[0..7] OF BOOL;\n    grid : ARRAY[1..2, 1..4] OF BOOL;\n    long : ARRAY[0..8] OF BOOL;\n    b : BYTE;\nEND_VAR\nVAR CONSTANT\n    fixed : ARRAY[0..7] OF BOOL;\nEND_VAR\n";
    clean(&format!(
        "{declared}+--[PACK]( b, bits )--[PACK]( b, grid )--[PACK]( b, grid[2] )--[PACK]( b, fixed )--[UNPACK]( bits, b )--[UNPACK]( grid, b )--+\n"
    ));
    check(
        &format!("{declared}+--[PACK]( b, long )--[UNPACK]( fixed, b )--[UNPACK]( fixed[0..3], b )--+\n"),
        expect![[r#"
            > +--[PACK]( b, long )--[UNPACK]( fixed, b )--[UNPACK]( fixed[0..3], b )--+
                                              ^^^^^ error[constant-write]: `fixed` is a constant: no block may write it
                help: declare it in a VAR section without CONSTANT, or write another tag
                at 8:5 `fixed`: `fixed` is declared CONSTANT here
            > +--[PACK]( b, long )--[UNPACK]( fixed, b )--[UNPACK]( fixed[0..3], b )--+
                                                                    ^^^^^^^^^^^ error[constant-write]: `fixed` is a constant: no block may write it
                help: declare it in a VAR section without CONSTANT, or write another tag
                at 8:5 `fixed`: `fixed` is declared CONSTANT here
        "#]],
    );
}

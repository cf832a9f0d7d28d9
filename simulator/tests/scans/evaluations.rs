//! What one evaluation of a block is (LANGUAGE §5, §6): edges from one to the next, all operands before it acts.

use crate::support::check;
use expect_test::expect;

#[test]
fn a_loop_in_which_power_goes_up_and_down_sees_each_rise() {
    check(
        "VAR b, x : BOOL; rises, falls, risen, fallen, coils : INT; c : CTU; cd : CTD; ud : CTUD; cc : CTC; \
         a : ARRAY[1..9] OF DINT; END_VAR\n\
         +--<FOR>( 4 )--+\n\
         +--[/]( b )--( )( b )--+\n\
         +--[P]( b )--[ADD]( rises, rises, 1 )--+\n\
         +--[N]( b )--[ADD]( falls, falls, 1 )--+\n\
         +--[ ]( b )--[OSR]--[ADD]( risen, risen, 1 )--+\n\
         +--[ ]( b )--[OSF]--[ADD]( fallen, fallen, 1 )--+\n\
         +--[ ]( b )--(P)( x )--+\n\
         +--[ ]( x )--[ADD]( coils, coils, 1 )--+\n\
         +--[ ]( b )--[CTU]( c, 9 )--+\n\
         +--[ ]( b )--[CTD]( cd, 9 )--+\n\
         +--[NOT]--[CTUD]( ud, 9, CD := b )--+\n\
         +--[ ]( b )--[CTC]( cc, 9 )--+\n\
         +--[ ]( b )--[SHIFT]( a[1..9], c.CV )--+\n\
         +--<NEXT>--+\n",
        "2",
        "rises falls risen fallen coils c.CV cd.CV ud.CV cc.CV a[1] a[2] a[3] a[4] a[5]",
        expect![[r#"
            rises   2 4
            falls   2 4
            risen   2 4
            fallen  2 4
            coils   2 4
            c.CV    2 4
            cd.CV   -2 -4
            ud.CV   -2 -4
            cc.CV   2 4
            a[1]    2 4
            a[2]    1 3
            a[3]    0 2
            a[4]    0 1
            a[5]    0 0
        "#]],
    );
}

#[test]
fn a_second_call_with_the_same_power_sees_no_edge() {
    check(
        "VAR_INPUT a : BOOL; END_VAR\nVAR n : INT; c : CTU; END_VAR\n\
         +--<CALL>( f )--<CALL>( f )--+\n\
         +--<FUN>( f )--[P]( a )--[ADD]( n, n, 1 )--+\n\
         +--[ ]( a )--[CTU]( c, 9 )--+\n",
        "a _--_-",
        "n c.CV",
        expect![[r#"
            n     0 1 1 1 2
            c.CV  0 1 1 1 2
        "#]],
    );
}

#[test]
fn a_pulse_timer_is_started_by_a_rise_within_a_scan() {
    // In the first turn EN is low, in the second it is high.
    check(
        "VAR_INPUT go : BOOL; END_VAR\nVAR i : INT; t : TP; END_VAR\n\
         +--[MOV]( i, 0 )--<FOR>( 2 )--+\n\
         +--[ ]( go )--[EQ]( i, 1 )--[TP]( t, T#20ms )--+\n\
         +--[ADD]( i, i, 1 )--<NEXT>--+\n",
        "go _------",
        "t.Q t.ET",
        expect![[r#"
            t.Q   _------
            t.ET  0 0 10 0 10 0 10
        "#]],
    );
}

/// What an operand reads is what was there before the block did anything.
#[test]
fn operands_are_read_before_a_member_is_written() {
    check(
        "VAR_INPUT d : BOOL; END_VAR\nVAR c : CTUD; END_VAR\n\
         +--[ ]( SYS.OFF )--[CTUD]( c, 9, CD := d, R := c.CD )--+\n",
        "d _--__",
        "c.CD c.R c.CV",
        expect![[r#"
            c.CD  _--__
            c.R   __--_
            c.CV  0 -1 0 0 0
        "#]],
    );
}

#[test]
fn a_fault_in_any_operand_is_the_blocks() {
    check(
        "VAR_INPUT i : INT; d : BOOL; END_VAR\n\
         VAR a : ARRAY[1..3] OF BOOL; n : ARRAY[1..3] OF INT := [7, 8, 9]; c : CTUD; y, z, w : INT; q : BOOL; END_VAR\n\
         +--[CTUD]( c, 9, CD := d, R := a[i] )--+\n\
         +--[SEL]( y, SYS.ON, n[i], 5 )--[ADD]( z, z, 1 )--+\n\
         +--[MUX]( w, 0, 1, n[i] )--( )( q )--+\n\
         +--[CALC]( z, z + SEL(TRUE, n[i], 0) )--+\n",
        "i 1 4 2",
        "c.CD c.CV y z w q",
        expect![[r#"
            c.CD  ___
            c.CV  1 1 1
            y     5 5 5
            z     1 1 2
            w     1 1 1
            q     -_-
            scan 1 at 149: index 4 is outside the array [1..3]: nothing was written; limit the index before this block
            scan 1 at 190: index 4 is outside the array [1..3]: nothing was written; limit the index before this block
            scan 1 at 242: index 4 is outside the array [1..3]: nothing was written; limit the index before this block
            scan 1 at 281: index 4 is outside the array [1..3]: nothing was written; limit the index before this block
        "#]],
    );
}

#[test]
fn a_pulse_output_is_set_whole_or_not_at_all() {
    check(
        "VAR_INPUT i : INT; END_VAR\nVAR d : ARRAY[1..3] OF INT := [10, 20, 30]; f : ARRAY[1..2] OF INT := [100, 200]; END_VAR\n\
         +--[PWM]( d[i], f[i] )--[PWM]( i, 5, CH := d[i] )--+\n",
        "i 1 2 3 1",
        "PORT.DUTY[0] PORT.FREQUENCY[0] PORT.DUTY[10] PORT.DUTY[20]",
        expect![[r#"
            PORT.DUTY[0]       10 20 20 10
            PORT.FREQUENCY[0]  100 200 200 100
            PORT.DUTY[10]      1 1 1 1
            PORT.DUTY[20]      0 2 2 2
            scan 2 at 120: index 3 is outside the array [1..2]: nothing was written; limit the index before this block
        "#]],
    );
}

const PUT: &str = "FUNCTION_BLOCK [$Put]\nVAR_INPUT a : INT; END_VAR\nVAR_OUTPUT q, r : INT; END_VAR\nVAR_IN_OUT i : INT; END_VAR\n\
                   +--[MOV]( q, a )--[ADD]( r, a, 1 )--[ADD]( i, i, 1 )--+\nEND_FUNCTION_BLOCK\n";

#[test]
fn an_output_goes_where_its_index_pointed_before_the_body_ran() {
    check(
        &format!(
            "{PUT}VAR i : INT := 1; n, m : ARRAY[1..4] OF INT; END_VAR\n+--[$Put]( a := 5, q => n[i], r => m[i], i := i )--+\n"
        ),
        "3",
        "i n[1] n[2] n[3] m[1] m[2] m[3]",
        expect![[r#"
            i     2 3 4
            n[1]  5 5 5
            n[2]  0 5 5
            n[3]  0 0 5
            m[1]  6 6 6
            m[2]  0 6 6
            m[3]  0 0 6
        "#]],
    );
}

#[test]
fn the_body_does_not_run_where_an_output_has_no_place() {
    check(
        &format!(
            "{PUT}VAR i : INT := 3; n : ARRAY[1..4] OF INT; m : ARRAY[1..3] OF INT; ok : BOOL; END_VAR\n\
             +--[$Put]( a := 5, q => n[i], r => m[i], i := i )--( )( ok )--+\n"
        ),
        "3",
        "ok i n[3] n[4] m[3]",
        expect![[r#"
            ok    -__
            i     4 4 4
            n[3]  5 5 5
            n[4]  0 0 0
            m[3]  6 6 6
            scan 1 at 271: index 4 is outside the array [1..3]: nothing was written; limit the index before this block
            scan 2 at 271: index 4 is outside the array [1..3]: nothing was written; limit the index before this block
        "#]],
    );
}

/// The result of a body's last block is the block's output, however it was computed.
#[test]
fn an_output_is_copied_out_in_every_run() {
    check(
        "FUNCTION_BLOCK [$Twice]\nVAR_INPUT a : INT; END_VAR\nVAR_OUTPUT q : INT; END_VAR\n\
         +--[ ]( EN )--[CALC]( q, a * 2 + 1 )--+\nEND_FUNCTION_BLOCK\n\
         VAR_INPUT go : BOOL; x : INT; END_VAR\nVAR y, seen : INT; END_VAR\n\
         +--[ ]( go )--[$Twice]( x, y )--+\n+--[MOV]( seen, y )--+\n+--[MOV]( y, 99 )--+\n",
        "go -_-_\nx 3 4 5 6",
        "seen",
        expect![[r#"
            seen  7 7 11 11
        "#]],
    );
}

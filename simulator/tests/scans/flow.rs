//! Jumps, functions, loops, the master control relay, and what stops a simulation.

use crate::support::{check, get, set, simulation, simulation_with};
use expect_test::expect;
use ladder_simulator::{Options, Status};

#[test]
fn a_jump_leaves_at_once_and_goes_to_the_nearest_label_after() {
    check(
        "VAR_INPUT a : BOOL; END_VAR\nVAR x : LINT; y : BOOL; END_VAR\n\
         +--[MOV]( x, 0 )--+\n\
         +--\\--[ ]( a )--<JMP>( there )--[CALC]( x, x * 10 + 1 )--+\n\
         \x20  /--[CALC]( x, x * 10 + 2 )--( )( y )--+\n\
         +--[CALC]( x, x * 10 + 3 )--+\n\
         +--<LBL>( there )--[CALC]( x, x * 10 + 4 )--+\n\
         +--<LBL>( there )--[CALC]( x, x * 10 + 5 )--+\n",
        "a _-_",
        "x y",
        expect![[r#"
            x  2345 45 2345
            y  ---
        "#]],
    );
}

#[test]
fn a_jump_back_is_a_loop() {
    check(
        "VAR n : INT; END_VAR\n\
         +--<LBL>( again )--[ADD]( n, n, 1 )--+\n\
         +--[NE]( n, 5 )--<JMP>( again )--+\n",
        "1",
        "n",
        expect![[r#"
            n  5
        "#]],
    );
}

#[test]
fn functions_run_when_called_and_keep_their_state_otherwise() {
    check(
        "VAR_INPUT a, early : BOOL; END_VAR\nVAR n, m : INT; y : BOOL; END_VAR\n\
         +--[ ]( a )--<CALL>( work )--[ADD]( m, m, 1 )--+\n\
         +--<FUN>( work )--[ADD]( n, n, 1 )--( )( y )--+\n\
         +--[ ]( early )--<RET>--+\n\
         +--[ADD]( n, n, 10 )--+\n",
        "a     _-_--\nearly ____-",
        "n m y",
        expect![[r#"
            n  0 11 11 22 23
            m  0 1 1 2 3
            y  _----
        "#]],
    );
}

#[test]
fn a_function_that_calls_itself_keeps_the_powers_of_each_call() {
    // The power after the call is that of its own activation.
    check(
        "VAR depth, x : LINT; END_VAR\n\
         +--[MOV]( depth, 0 )--[MOV]( x, 0 )--<CALL>( f )--+\n\
         +--<FUN>( f )--[ADD]( depth, depth, 1 )--+\n\
         +--\\--[LT]( depth, 4 )--<CALL>( f )--[ADD]( x, x, 1 )--+\n\
         \x20  /--[GE]( depth, 4 )--[ADD]( x, x, 100 )--+\n",
        "2",
        "depth x",
        expect![[r#"
            depth  4 4
            x      403 403
        "#]],
    );
}

#[test]
fn return_in_the_main_program_ends_the_scan_and_end_the_program() {
    let mut simulation = simulation(
        "VAR_INPUT r, e : BOOL; END_VAR\nVAR n, m : INT; END_VAR\n\
         +--[ADD]( n, n, 1 )--+\n+--[ ]( r )--<RET>--+\n+--[ ]( e )--<END>--+\n+--[ADD]( m, m, 1 )--+\n",
    );
    let mut log = String::new();
    for (r, e) in [("0", "0"), ("1", "0"), ("0", "1"), ("0", "0")] {
        set(&mut simulation, "r", r);
        set(&mut simulation, "e", e);
        let ran = simulation.scan();
        log.push_str(&format!(
            "ran {ran} n {} m {} {:?} scans {}\n",
            get(&simulation, "n"),
            get(&simulation, "m"),
            simulation.status(),
            simulation.scans()
        ));
    }
    expect![[r#"
        ran true n 1 m 1 Ready scans 1
        ran true n 2 m 1 Ready scans 2
        ran true n 3 m 1 Ended scans 3
        ran false n 3 m 1 Ended scans 3
    "#]]
    .assert_eq(&log);
    simulation.reset();
    assert_eq!(
        (simulation.status(), simulation.scans(), simulation.time()),
        (Status::Ready, 0, 0)
    );
    assert!(simulation.scan());
}

#[test]
fn loops() {
    check(
        "VAR_INPUT n : INT; out, back : BOOL; END_VAR\nVAR i, x, y, z : INT; END_VAR\n\
         +--[MOV]( i, 0 )--<FOR>( n )--[MOV]( n, 1 )--+\n\
         +--[ADD]( i, i, 1 )--[ADD]( x, x, 1 )--+\n\
         +--[ ]( out )--[EQ]( i, 2 )--<JMP>( after )--+\n\
         +--[ADD]( y, y, 1 )--<NEXT>--[ADD]( y, y, 10 )--+\n\
         +--<LBL>( after )--[ADD]( z, z, 1 )--+\n",
        "n 3 0 -1 3\nout ___-",
        "x y z",
        expect![[r#"
            x  3 3 3 5
            y  33 33 33 44
            z  1 2 3 4
        "#]],
    );
}

/// The number is there before the first network of the body; a loop without power or turns leaves it, and a loop in a
/// function that is called from a turn has a number of its own.
#[test]
fn each_turn_has_its_number() {
    check(
        "VAR_INPUT a : BOOL; END_VAR\n\
         VAR i, j : INT; small : SINT; x, y, n : DINT; END_VAR\n\
         +--[MOV]( x, 0 )--[MOV]( y, 0 )--[CALC]( n, 3 - n )--+\n\
         +--[ ]( a )--<FOR>( n, I => i )--+\n\
         +--[CALC]( x, x * 10 + i )--<CALL>( Inner )--+\n\
         +--<NEXT>--+\n\
         +--<FOR>( 130, I => small )--+\n\
         +--<NEXT>--+\n\
         +--<FUN>( Inner )--<FOR>( 2, I => j )--+\n\
         +--[CALC]( y, y * 10 + j )--<NEXT>--+\n",
        "a -_-",
        "x y i j small",
        expect![[r#"
            x      123 0 123
            y      121212 0 121212
            i      3 3 3
            j      2 2 2
            small  -126 -126 -126
        "#]],
    );
}

#[test]
fn a_jump_into_a_loop_runs_on() {
    check(
        "VAR_INPUT a : BOOL; END_VAR\nVAR x, y : INT; END_VAR\n\
         +--[ ]( a )--<JMP>( inside )--+\n\
         +--<FOR>( 3 )--+\n\
         +--[ADD]( x, x, 1 )--+\n\
         +--<LBL>( inside )--[ADD]( y, y, 1 )--+\n\
         +--<NEXT>--+\n",
        "a _-",
        "x y",
        expect![[r#"
            x  3 3
            y  3 4
        "#]],
    );
}

/// Each has a number of its own, a loop that makes no turn is passed by, and a jump ends every loop that it leaves.
#[test]
fn loops_nest() {
    check(
        "VAR_INPUT n, m : INT; inner, outer : BOOL; END_VAR\nVAR i, j, k : INT; x, y, z, w : DINT; END_VAR\n\
         +--[MOV]( x, 0 )--[MOV]( y, 0 )--[MOV]( z, 0 )--[MOV]( w, 0 )--+\n\
         +--<FOR>( n, I => i )--+\n\
         +--[ADD]( y, y, 1 )--<FOR>( m, I => j )--+\n\
         +--[CALC]( x, x + i * 10 + j )--+\n\
         +--[ ]( inner )--[EQ]( j, 2 )--<JMP>( next )--+\n\
         +--[ ]( outer )--[EQ]( i, 2 )--<JMP>( after )--+\n\
         +--<FOR>( 2, I => k )--+\n\
         +--[CALC]( w, w + k )--<NEXT>--+\n\
         +--<NEXT>--+\n\
         +--<LBL>( next )--[ADD]( z, z, 1 )--<NEXT>--[ADD]( z, z, 100 )--+\n\
         +--<LBL>( after )--[ADD]( z, z, 1000 )--+\n",
        "n 2 0 3 3 3\nm 3 3 0 3 3\ninner ___-_\nouter ____-",
        "x y z w i j k",
        expect![[r#"
            x  102 0 0 129 57
            y  2 0 3 3 2
            z  1202 1000 1303 1303 1101
            w  18 0 0 9 9
            i  2 2 3 3 2
            j  3 3 3 2 1
            k  2 2 2 2 2
        "#]],
    );
}

/// A NEXT whose FOR does not run does nothing, also in another loop; one that is jumped back to begins again.
#[test]
fn jumps_among_loops_in_loops() {
    check(
        "VAR_INPUT a : BOOL; END_VAR\nVAR i, j : INT; x, y, z, turns : DINT; END_VAR\n\
         +--[MOV]( x, 0 )--[MOV]( y, 0 )--[MOV]( z, 0 )--[MOV]( turns, 0 )--+\n\
         +--<FOR>( 3, I => i )--+\n\
         +--[ ]( a )--<JMP>( inside )--+\n\
         +--<LBL>( again )--<FOR>( 2, I => j )--+\n\
         +--[ADD]( x, x, 1 )--+\n\
         +--<LBL>( inside )--[ADD]( y, y, 1 )--+\n\
         +--[/]( a )--[EQ]( j, 2 )--[LT]( turns, 2 )--[ADD]( turns, turns, 1 )--<JMP>( again )--+\n\
         +--<NEXT>--+\n\
         +--[ADD]( z, z, 1 )--<NEXT>--+\n",
        "a _-_",
        "x y z turns i",
        expect![[r#"
            x      10 0 10
            y      10 3 10
            z      3 3 3
            turns  2 0 2
            i      3 3 3
        "#]],
    );
}

/// A block's body, a function that calls itself, and a scan that is stopped in the midst have loops of their own.
#[test]
fn loops_in_loops_of_bodies_and_functions() {
    check(
        "FUNCTION_BLOCK [$Count]\nVAR_INPUT n : INT; END_VAR\nVAR_OUTPUT sum : DINT; END_VAR\n\
         +--[MOV]( sum, 0 )--<FOR>( n )--+\n+--<FOR>( n )--+\n+--[ADD]( sum, sum, 1 )--[GE]( sum, 7 )--<RET>--+\n+--<NEXT>--+\n+--<NEXT>--+\nEND_FUNCTION_BLOCK\n\
         VAR i, j, depth : INT; s : DINT; total : DINT; END_VAR\n\
         +--[MOV]( total, 0 )--[MOV]( depth, 0 )--<FOR>( 3, I => i )--+\n+--<FOR>( 2, I => j )--+\n\
         +--[$Count]( i, s )--[ADD]( total, total, s )--+\n+--<NEXT>--+\n+--<CALL>( Again )--<NEXT>--+\n\
         +--<FUN>( Again )--[ADD]( depth, depth, 1 )--<FOR>( 2 )--+\n+--<FOR>( 2 )--+\n+--[LT]( depth, 40 )--<CALL>( Again )--+\n+--<NEXT>--+\n+--<NEXT>--+\n",
        "2",
        "total s i j depth",
        expect![[r#"
            total  24 24
            s      7 7
            i      3 3
            j      2 2
            depth  42 42
        "#]],
    );
}

#[test]
fn a_jump_right_of_for_takes_the_loop_back() {
    check(
        "VAR x, y : INT; END_VAR\n\
         +--<FOR>( 3 )--<JMP>( inside )--+\n\
         +--[ADD]( x, x, 1 )--+\n\
         +--<LBL>( inside )--[ADD]( y, y, 1 )--<NEXT>--+\n",
        "2",
        "x y",
        expect![[r#"
            x  0 0
            y  1 2
        "#]],
    );
}

#[test]
fn a_function_called_from_a_loop_has_loops_of_its_own() {
    check(
        "VAR x, y : INT; END_VAR\n\
         +--<FOR>( 3 )--+\n\
         +--<CALL>( f )--[ADD]( x, x, 1 )--<NEXT>--+\n\
         +--<FUN>( f )--<FOR>( 4 )--+\n\
         +--[ADD]( y, y, 1 )--<NEXT>--+\n",
        "1",
        "x y",
        expect![[r#"
            x  3
            y  12
        "#]],
    );
}

#[test]
fn master_control_relay() {
    check(
        "VAR_INPUT on, jog : BOOL; END_VAR\nVAR before, motor, kept, after, inner : BOOL; END_VAR\n\
         +--[ ]( jog )--( )( before )--+\n\
         +--[ ]( on )--<MCR>--+\n\
         +--\\--[ ]( jog )--( )( motor )--+\n\
         \x20  /--(S)( kept )--+\n\
         +--<CALL>( f )--+\n\
         +--\\--( )( inner )--<MCR>--+\n\
         \x20  /--[ ]( jog )--( )( after )--+\n\
         +--<CALL>( f )--+\n\
         +--<FUN>( f )--[ ]( on )--<MCR>--+\n",
        "on  _-_-\njog -___",
        "before motor kept inner after",
        expect![[r#"
            before  -___
            motor   ____
            kept    _---
            inner   ----
            after   -___
        "#]],
    );
}

#[test]
fn the_watchdog_names_the_block() {
    let text = "VAR n : DINT; END_VAR\n\
                +--<LBL>( again )--[ADD]( n, n, 1 )--+\n\
                +--<JMP>( again )--+\n";
    let mut simulation = simulation_with(
        text,
        Options {
            watchdog: 10,
            ..Options::default()
        },
    );
    assert!(!simulation.scan());
    assert_eq!((simulation.status(), simulation.scans()), (Status::Faulted, 0));
    let faults = simulation.take_faults();
    let [fault] = faults.as_slice() else {
        panic!("{faults:?}")
    };
    // Three blocks a turn: the eleventh is the second of its turn.
    assert_eq!(&text[fault.location.range], "[ADD]( n, n, 1 )");
    expect!["this scan has evaluated more than 10 blocks, so the watchdog stopped the simulation here; look for a jump or loop that does not end"].assert_eq(&fault.message);
    assert!(fault.stops);
    assert!(!simulation.scan());
}

#[test]
fn a_long_program_trips_the_watchdog_at_the_first_block_too_many() {
    let rungs: Vec<String> = (0..8)
        .map(|n| format!("+--[ ]( a{n} )--( )( y{n} )--+\n"))
        .collect();
    let rungs = rungs.concat();
    for (watchdog, block) in [
        (16, None),
        (15, Some("( )( y7 )")),
        (7, Some("( )( y3 )")),
        (0, Some("[ ]( a0 )")),
    ] {
        let mut simulation = simulation_with(
            &rungs,
            Options {
                watchdog,
                ..Options::default()
            },
        );
        assert_eq!(simulation.scan(), block.is_none());
        let fault = simulation.take_faults().pop();
        assert_eq!(fault.map(|fault| &rungs[fault.location.range]), block);
    }
}

#[test]
fn calls_nest_to_depth_64() {
    let text = |deepest: u32| {
        format!(
            "VAR n : DINT; END_VAR\n\
             +--[MOV]( n, 0 )--<CALL>( f )--+\n\
             +--<FUN>( f )--[ADD]( n, n, 1 )--[LT]( n, {deepest} )--<CALL>( f )--+\n"
        )
    };
    let mut deep = simulation(&text(64));
    assert!(deep.scan());
    assert_eq!(get(&deep, "n"), "64");
    let text = text(65);
    let mut deeper = simulation(&text);
    assert!(!deeper.scan());
    let fault = deeper.take_faults().pop().unwrap();
    assert_eq!(&text[fault.location.range], "<CALL>( f )");
    expect!["calls are nested deeper than 64, so the simulation was stopped; look for a function that calls itself without end"].assert_eq(&fault.message);
    assert_eq!(deeper.status(), Status::Faulted);
}

#[test]
fn a_loop_without_power_is_passed_by_and_next_needs_none() {
    check(
        "VAR_INPUT go : BOOL; n : INT; END_VAR\nVAR x, y : INT; END_VAR\n\
         +--[ ]( go )--<FOR>( n )--+\n\
         +--[ADD]( x, x, 1 )--+\n\
         +--[/]( SYS.ON )--<NEXT>--+\n\
         +--[ADD]( y, y, 1 )--+\n",
        "go __--\nn 2 2 2 3",
        "x y",
        expect![[r#"
            x  0 0 2 5
            y  1 2 3 4
        "#]],
    );
}

#[test]
fn the_turns_are_read_once() {
    check(
        "VAR n, x : INT; END_VAR\n\
         +--[MOV]( n, 3 )--<FOR>( n )--+\n\
         +--[ADD]( n, n, 1 )--[ADD]( x, x, 1 )--<NEXT>--+\n",
        "2",
        "n x",
        expect![[r#"
            n  6 6
            x  3 6
        "#]],
    );
}

#[test]
fn a_return_ends_the_loop() {
    // A second call finds no turns left over.
    check(
        "VAR_INPUT out : BOOL; END_VAR\nVAR x, y, z : INT; END_VAR\n\
         +--<CALL>( f )--[ADD]( z, z, 1 )--+\n\
         +--<FUN>( f )--<FOR>( 5 )--+\n\
         +--[ADD]( x, x, 1 )--[ ]( out )--<RET>--+\n\
         +--[ADD]( y, y, 1 )--<NEXT>--+\n",
        "out _-_",
        "x y z",
        expect![[r#"
            x  5 6 11
            y  5 5 10
            z  1 2 3
        "#]],
    );
}

#[test]
fn a_next_that_is_reached_by_a_jump_out_and_back_does_nothing() {
    check(
        "VAR x, y : INT; END_VAR\n\
         +--[MOV]( y, 0 )--<FOR>( 4 )--+\n\
         +--[ADD]( x, x, 1 )--<JMP>( away )--+\n\
         +--<LBL>( back )--[ADD]( y, y, 1 )--<NEXT>--+\n\
         +--<LBL>( away )--[EQ]( y, 0 )--<JMP>( back )--+\n",
        "2",
        "x y",
        expect![[r#"
            x  1 2
            y  1 1
        "#]],
    );
}

#[test]
fn the_rails_of_the_caller_come_back_and_begin_live() {
    check(
        "VAR_INPUT on : BOOL; END_VAR\nVAR inside, after, top, own : BOOL; END_VAR\n\
         +--( )( top )--+\n\
         +--[ ]( on )--<MCR>--+\n\
         +--( )( after )--<CALL>( g )--+\n\
         +--\\--( )( own )--+\n\
         \x20  /--[ ]( SYS.ON )--<CALL>( f )--<MCR>--+\n\
         +--<FUN>( f )--( )( inside )--+\n\
         +--[/]( SYS.ON )--<MCR>--+\n\
         +--<FUN>( g )--(R)( inside )--+\n",
        "on -_",
        "top after own inside",
        expect![[r#"
            top     --
            after   -_
            own     --
            inside  --
        "#]],
    );
}

#[test]
fn two_calls_in_a_scan_see_the_same_clock_and_no_second_edge() {
    check(
        "VAR_INPUT a : BOOL; END_VAR\nVAR n, m, z : INT; t : TON; c : CTU; END_VAR\n\
         +--<CALL>( f )--<CALL>( f )--+\n\
         +--<FUN>( f )--[ADD]( z, z, 1 )--+\n\
         +--[P]( a )--[ADD]( n, n, 1 )--+\n\
         +--[ ]( a )--[CTU]( c, 9 )--+\n\
         +--[ ]( a )--[TON]( t, T#20ms )--[OSR]--[ADD]( m, m, 1 )--+\n",
        "a _---_-",
        "z n m c.CV t.ET",
        expect![[r#"
            z     2 4 6 8 10 12
            n     0 1 1 1 1 2
            m     0 0 0 1 1 1
            c.CV  0 1 1 1 1 2
            t.ET  0 0 10 20 0 0
        "#]],
    );
}

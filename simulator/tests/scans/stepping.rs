//! Scans in steps: by block, by network; what shows in their midst; states that are brought back.

use crate::support::{force, get, set, simulation, simulation_with, unforce};
use expect_test::expect;
use ladder_simulator::{Options, Simulation, Status, Stepped, diagram};

const MIXED: &str = "
VAR_INPUT a, b : BOOL; z, i : INT; END_VAR
VAR n, k : INT; x : LREAL := 1.5; s : STRING; arr : ARRAY[1..4] OF INT; t : TON; u : TP; c : CTU; l, y : BOOL; END_VAR
VAR w : WORD; z2 : INT; p, q : BOOL; END_VAR
+--\\--[ ]( a )--\\--[/]( b )--( )( y )--+
|  /--[ ]( y )--/
+--[ ]( y )--[TON]( t, T#30ms )--[P]( a )--[CTU]( c, 3 )--+
+--[NOT]--[TP]( u, T#20ms )--(P)( l )--+
+--[ADD]( n, n, 3 )--[DIV]( k, n, z )--+
+--[CALC]( x, SQRT(x * 2.5) + SIN(x) )--[MOV]( s, 'text' )--[$Twice]( p, q )--+
+--[MOV]( arr[i], n )--( )( w.3 )--+
+--[GT]( n, 20 )--<CALL>( f )--+
+--<FOR>( 3 )--+
+--[ADD]( k, k, arr[2] )--<NEXT>--+
+--<FUN>( f )--[XOR]( w, w, 16#55 )--[TYP]( z2, x )--<RET>--+
FUNCTION_BLOCK [$Twice]
VAR_INPUT in : BOOL; END_VAR
VAR_OUTPUT out : BOOL; END_VAR
VAR t : TON; END_VAR
+--\\--[ ]( in )--<RET>--( )( out )--+
   /--[TON]( t, T#20ms )--( )( out )--+
+--[/]( EN )--<JMP>( over )--[MOV]( n2, 1 )--+
+--<LBL>( over )--[ ]( out )--( )( ENO )--+
END_FUNCTION_BLOCK
";

fn mixed() -> String {
    MIXED.replace(
        "VAR t : TON; END_VAR\n+--\\",
        "VAR t : TON; n2 : INT; END_VAR\n+--\\",
    )
}

fn inputs(simulation: &mut Simulation, scan: usize) {
    for (tag, bit) in [("a", 1), ("b", 4), ("i", 2), ("z", 8), ("p", 16)] {
        set(simulation, tag, &u8::from(scan & bit != 0).to_string());
    }
}

/// What can be seen of a simulation.
fn seen(text: &str, simulation: &Simulation) -> String {
    let mut seen = diagram(text, simulation);
    for point in simulation.points() {
        seen.push_str(&format!("{} {:?}\n", point.name, simulation.value(point)));
    }
    seen
}

fn block_of(text: &str, stepped: Stepped) -> &str {
    match stepped {
        Stepped::At(location) => text[location.range].trim_end(),
        Stepped::Done => "done",
        Stepped::Stopped => "stopped",
    }
}

/// All steps of one scan.
fn steps(text: &str, simulation: &mut Simulation, step: fn(&mut Simulation) -> Stepped) -> String {
    let mut log = String::new();
    loop {
        let stepped = step(simulation);
        log.push_str(block_of(text, stepped));
        log.push('\n');
        if !matches!(stepped, Stepped::At(_)) {
            return log;
        }
    }
}

#[test]
fn steps_do_what_a_scan_does() {
    let text = mixed();
    let mut whole = simulation(&text);
    let mut blocks = simulation(&text);
    let mut networks = simulation(&text);
    for scan in 0..80 {
        for simulation in [&mut whole, &mut blocks, &mut networks] {
            inputs(simulation, scan);
        }
        whole.scan();
        while let Stepped::At(_) = blocks.step_block() {}
        // Now and then the rest of it at once.
        for _ in 0..scan % 7 {
            networks.step_network();
        }
        networks.scan();
        let expected = seen(&text, &whole);
        assert_eq!(seen(&text, &blocks), expected, "scan {scan}");
        assert_eq!(seen(&text, &networks), expected, "scan {scan}");
        let faults = whole.take_faults();
        assert_eq!(blocks.take_faults(), faults, "scan {scan}");
        assert_eq!(networks.take_faults(), faults, "scan {scan}");
    }
}

#[test]
fn blocks_in_the_order_in_which_they_run() {
    let text = "VAR_INPUT a : BOOL := TRUE; END_VAR\nVAR n : INT; x, y : BOOL; END_VAR\n\
                +--\\--[ ]( a )--\\--( )( x )--<CALL>( f )--( )( y )--+\n\
                \x20  /--[/]( y )--/\n\
                +--<FOR>( 2 )--+\n\
                +--[ADD]( n, n, 1 )--<NEXT>--+\n\
                +--[ ]( x )--<JMP>( end )--+\n\
                +--[/]( a )--( )( y )--+\n\
                +--<LBL>( end )--[$B]( x )--+\n\
                +--<FUN>( f )--[NOT]--( )( y )--+\n\
                FUNCTION_BLOCK [$B]\nVAR_INPUT in : BOOL; END_VAR\n+--[ ]( in )--<RET>--( )( ENO )--+\nEND_FUNCTION_BLOCK\n";
    let mut simulation = simulation(text);
    assert!(!simulation.is_open());
    expect![[r#"
        [ ]( a )
        [/]( y )
        ( )( x )
        <CALL>( f )
        [NOT]
        ( )( y )
        ( )( y )
        <FOR>( 2 )
        [ADD]( n, n, 1 )
        [ADD]( n, n, 1 )
        [ ]( x )
        <JMP>( end )
        [$B]( x )
        [ ]( in )
        <RET>
        done
    "#]]
    .assert_eq(&steps(text, &mut simulation, Simulation::step_block));
    assert!(!simulation.is_open());
    expect![[r#"
        +--\--[ ]( a )--\--( )( x )--<CALL>( f )--( )( y )--+
           /--[/]( y )--/
        +--<FUN>( f )--[NOT]--( )( y )--+
        +--<FOR>( 2 )--+
        +--[ADD]( n, n, 1 )--<NEXT>--+
        +--[ADD]( n, n, 1 )--<NEXT>--+
        +--[ ]( x )--<JMP>( end )--+
        +--<LBL>( end )--[$B]( x )--+
        +--[ ]( in )--<RET>--( )( ENO )--+
        done
    "#]]
    .assert_eq(&steps(text, &mut simulation, Simulation::step_network));
}

#[test]
fn what_has_run_so_far_has_power() {
    let text = "VAR_INPUT a : BOOL := TRUE; END_VAR\nVAR x, y, z : BOOL; END_VAR\n\
                +--\\--[ ]( a )--\\--( )( x )--+\n\
                \x20  /--[ ]( z )--/\n\
                +--[ ]( x )--<CALL>( f )--( )( y )--+\n\
                +--[ ]( a )--( )( z )--+\n\
                +--<FUN>( f )--[ ]( x )--( )( z )--+\n";
    let mut simulation = simulation(text);
    simulation.scan();
    let body = |simulation: &Simulation| {
        let drawn = diagram(text, simulation);
        drawn.lines().skip(2).collect::<Vec<_>>().join("\n") + "\n"
    };
    let mut log = String::new();
    for step in 0..7 {
        let at = block_of(text, simulation.step_block());
        log.push_str(&format!("{step} before {at}, z {}\n", get(&simulation, "z")));
        log.push_str(&body(&simulation));
    }
    assert!(simulation.finish_scan());
    assert!(!simulation.finish_scan());
    log.push_str(&format!("the end\n{}", body(&simulation)));
    expect![[r#"
        0 before [ ]( a ), z 1
        +==\==[ ]( a )--\--( )( x )--+
           /==[ ]( z )--/
        +--[ ]( x )--<CALL>( f )--( )( y )--+
        +--[ ]( a )--( )( z )--+
        +--<FUN>( f )--[ ]( x )--( )( z )--+
        1 before [ ]( z ), z 1
        +==\==[ ]( a )==\--( )( x )--+
           /==[ ]( z )--/
        +--[ ]( x )--<CALL>( f )--( )( y )--+
        +--[ ]( a )--( )( z )--+
        +--<FUN>( f )--[ ]( x )--( )( z )--+
        2 before ( )( x ), z 1
        +==\==[ ]( a )==\==( )( x )--+
           /==[ ]( z )==/
        +--[ ]( x )--<CALL>( f )--( )( y )--+
        +--[ ]( a )--( )( z )--+
        +--<FUN>( f )--[ ]( x )--( )( z )--+
        3 before [ ]( x ), z 1
        +==\==[ ]( a )==\==( )( x )==+
           /==[ ]( z )==/
        +==[ ]( x )--<CALL>( f )--( )( y )--+
        +--[ ]( a )--( )( z )--+
        +--<FUN>( f )--[ ]( x )--( )( z )--+
        4 before <CALL>( f ), z 1
        +==\==[ ]( a )==\==( )( x )==+
           /==[ ]( z )==/
        +==[ ]( x )==<CALL>( f )--( )( y )--+
        +--[ ]( a )--( )( z )--+
        +--<FUN>( f )--[ ]( x )--( )( z )--+
        5 before [ ]( x ), z 1
        +==\==[ ]( a )==\==( )( x )==+
           /==[ ]( z )==/
        +==[ ]( x )==<CALL>( f )--( )( y )--+
        +--[ ]( a )--( )( z )--+
        +==<FUN>( f )==[ ]( x )--( )( z )--+
        6 before ( )( z ), z 1
        +==\==[ ]( a )==\==( )( x )==+
           /==[ ]( z )==/
        +==[ ]( x )==<CALL>( f )--( )( y )--+
        +--[ ]( a )--( )( z )--+
        +==<FUN>( f )==[ ]( x )==( )( z )--+
        the end
        +==\==[ ]( a )==\==( )( x )==+
           /==[ ]( z )==/
        +==[ ]( x )==<CALL>( f )==( )( y )==+
        +==[ ]( a )==( )( z )==+
        +==<FUN>( f )==[ ]( x )==( )( z )==+
    "#]]
    .assert_eq(&log);
}

#[test]
fn a_fault_that_stops_leaves_the_power_up_to_its_place() {
    let text = "VAR n : INT; END_VAR\n\
                +--[NOT]--[NOT]--( )( x )--+\n\
                +--<LBL>( again )--[LT]( n, 3 )--<CALL>( f )--( )( y )--+\n\
                +--[ADD]( n, n, 1 )--<JMP>( again )--+\n\
                +--( )( z )--+\n\
                +--<FUN>( f )--( )( w )--[NOT]--( )( v )--+\n";
    let mut drawings = Vec::new();
    for (watchdog, forced) in [(8, false), (8, true), (17, false), (17, true)] {
        let options = Options {
            watchdog,
            ..Options::default()
        };
        let mut simulation = simulation_with(text, options);
        if forced {
            force(&mut simulation, "z", "1");
        }
        assert!(!simulation.scan());
        drawings.push(diagram(text, &simulation));
    }
    // Fused code stops where plain code does.
    assert_eq!((&drawings[0], &drawings[2]), (&drawings[1], &drawings[3]));
    expect![[r#"
        VAR n : INT; END_VAR
        +==[NOT]--[NOT]==( )( x )==+
        +==<LBL>( again )==[LT]( n, 3 )==<CALL>( f )--( )( y )--+
        +--[ADD]( n, n, 1 )--<JMP>( again )--+
        +--( )( z )--+
        +==<FUN>( f )==( )( w )==[NOT]--( )( v )--+
        VAR n : INT; END_VAR
        +==[NOT]--[NOT]==( )( x )==+
        +==<LBL>( again )==[LT]( n, 3 )==<CALL>( f )--( )( y )--+
        +==[ADD]( n, n, 1 )==<JMP>( again )--+
        +--( )( z )--+
        +==<FUN>( f )==( )( w )--[NOT]--( )( v )--+
    "#]]
    .assert_eq(&format!("{}{}", drawings[0], drawings[2]));
}

#[test]
fn inputs_and_forces_wait_for_the_next_scan() {
    let text = "VAR_INPUT a : BOOL; END_VAR\nVAR x, y, z : BOOL; END_VAR\n\
                +--[ ]( a )--( )( x )--+\n+--[ ]( a )--( )( y )--+\n+--( )( z )--+\n";
    let mut simulation = simulation(text);
    let values = |simulation: &Simulation| {
        let of = |tag| get(simulation, tag);
        format!("a {} x {} y {} z {}", of("a"), of("x"), of("y"), of("z"))
    };
    simulation.step_network();
    simulation.step_network();
    set(&mut simulation, "a", "1");
    force(&mut simulation, "z", "0");
    assert_eq!(values(&simulation), "a 0 x 0 y 0 z 0");
    simulation.finish_scan();
    assert_eq!(values(&simulation), "a 1 x 0 y 0 z 0");
    simulation.scan();
    assert_eq!(values(&simulation), "a 1 x 1 y 1 z 0");
    simulation.begin_scan();
    unforce(&mut simulation, "z");
    simulation.finish_scan();
    assert_eq!(values(&simulation), "a 1 x 1 y 1 z 0");
    simulation.scan();
    assert_eq!(values(&simulation), "a 1 x 1 y 1 z 1");
    // A restart gives the open scan up, and what waited for its end is done.
    simulation.begin_scan();
    force(&mut simulation, "x", "1");
    simulation.reset();
    assert!(!simulation.is_open());
    simulation.scan();
    assert_eq!(values(&simulation), "a 0 x 1 y 0 z 1");
}

#[test]
fn a_state_brings_everything_back() {
    let text = mixed();
    let mut simulation = simulation(&text);
    let mut states = Vec::new();
    let mut kept = simulation.state();
    let play = |simulation: &mut Simulation, scan: usize| {
        inputs(simulation, scan);
        match scan {
            20 => force(simulation, "y", "1"),
            40 => unforce(simulation, "y"),
            _ => {}
        }
        if scan.is_multiple_of(5) {
            simulation.step_network();
            simulation.step_block();
        } else {
            simulation.scan();
        }
    };
    for scan in 0..60 {
        simulation.state_into(&mut kept);
        assert_eq!(kept, simulation.state());
        states.push((kept.clone(), seen(&text, &simulation)));
        play(&mut simulation, scan);
    }
    for back in (0..60).rev().step_by(7) {
        assert!(simulation.restore(&states[back].0));
        for (scan, (_, expected)) in states.iter().enumerate().skip(back) {
            assert_eq!(&seen(&text, &simulation), expected, "scan {scan} from {back}");
            play(&mut simulation, scan);
        }
    }
    // The room that scans need is not given up.
    simulation.restore(&states[30].0);
    let again = allocation_counter::measure(|| while simulation.scan() && simulation.scans() < 50 {});
    assert_eq!(again.count_total, 0);
    let other = crate::support::simulation("+--[ ]( a )--( )( y )--+\n");
    assert!(!simulation.restore(&other.state()));
}

#[test]
fn a_step_that_ends_the_program_or_faults() {
    let text = "VAR_INPUT e : BOOL; END_VAR\nVAR n : INT; END_VAR\n\
                +--[ ]( e )--<END>--+\n+--<LBL>( again )--[ADD]( n, n, 1 )--<JMP>( again )--+\n";
    let options = Options {
        watchdog: 9,
        ..Options::default()
    };
    let mut first = simulation_with(text, options);
    let mut steps = 0;
    while let Stepped::At(_) = first.step_block() {
        steps += 1;
    }
    let mut second = simulation_with(text, options);
    assert!(!second.scan());
    assert_eq!(first.take_faults(), second.take_faults());
    assert_eq!(get(&first, "n"), get(&second, "n"));
    // [ ], <END>, then pairs of [ADD] and <JMP>: <LBL> counts as a block but is not a stop.
    assert_eq!((steps, first.status()), (6, Status::Faulted));
    assert_eq!(first.step_block(), Stepped::Stopped);
    assert!(!first.begin_scan());

    let mut ends = simulation_with(text, options);
    set(&mut ends, "e", "1");
    ends.step_block();
    ends.step_block();
    assert_eq!(ends.step_block(), Stepped::Done);
    assert_eq!((ends.status(), ends.scans()), (Status::Ended, 1));
}

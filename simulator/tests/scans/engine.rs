//! The engine itself: power, diagram, determinism, no allocation, system tags.

use crate::support::{check, force, get, set, simulation, simulation_with, trace};
use expect_test::expect;
use ladder_analysis::Cancel;
use ladder_simulator::{Options, diagram};

const MIXED: &str = "
VAR_INPUT a, b : BOOL; z, i : INT; END_VAR
VAR n, k : INT; x : LREAL := 1.5; s : STRING; arr : ARRAY[1..4] OF INT; t : TON; u : TP; c : CTU; l : BOOL; END_VAR
+--\\--[ ]( a )--\\--[/]( b )--( )( y )--+
|  /--[ ]( y )--/
+--[ ]( y )--[TON]( t, T#30ms )--[P]( a )--[CTU]( c, 3 )--+
+--[NOT]--[TP]( u, T#20ms )--(P)( l )--+
+--[ADD]( n, n, 3 )--[DIV]( k, n, z )--+
+--[CALC]( x, SQRT(x * 2.5) + SIN(x) )--[MOV]( s, 'text' )--+
+--[MOV]( arr[i], n )--( )( w.3 )--+
+--[GT]( n, 20 )--<CALL>( f )--+
+--<FOR>( 3 )--+
+--[ADD]( k, k, arr[2] )--<NEXT>--+
+--<FUN>( f )--[XOR]( w, w, 16#55 )--[TYP]( z2, x )--<RET>--+
";

fn mixed() -> String {
    MIXED.replace("l : BOOL;", "l, y : BOOL; w : WORD; z2 : INT;")
}

const INPUTS: &str = "a _-__-_---_-\nb ____-_____-\nz 1 2 0 3 0 1 2 3 4 5 6\ni 1 2 3 4 5 0 1 2 3 4 1";
const WATCH: &str = "y t.Q t.ET c.CV u.Q n k x s arr[1] arr[2] w z2";

#[test]
fn the_same_inputs_give_the_same_trace() {
    let text = mixed();
    let first = trace(&mut simulation(&text), INPUTS, WATCH);
    let second = trace(&mut simulation(&text), INPUTS, WATCH);
    assert_eq!(first, second);
    expect![[r#"
        y       _---__----_
        t.Q     _________-_
        t.ET    0 0 10 20 0 0 0 10 20 30 0
        c.CV    0 0 0 0 0 0 0 0 0 0 0
        u.Q     ___________
        n       3 6 9 12 15 18 21 24 27 30 33
        k       3 21 39 22 40 36 28 80 78 78 77
        x       2.933986659707763 2.9144322484160865 2.924485881567617 2.9193310146667844 2.9219778869989685 2.9206197819398687 2.921316884109716 2.920959136902197 2.921142747972325 2.921048515729748 2.921096878532194
        s       text text text text text text text text text text text
        arr[1]  3 3 3 3 3 3 21 21 21 21 33
        arr[2]  0 6 6 6 6 6 6 24 24 24 24
        w       8 8 8 8 0 0 93 8 93 8 93
        z2      0 0 0 0 0 0 3 3 3 3 3
        scan 2 at 364: division by zero: nothing was written; check the divisor before this block
        scan 4 at 364: division by zero: nothing was written; check the divisor before this block
        scan 4 at 449: index 5 is outside the array [1..4]: nothing was written; limit the index before this block
        scan 5 at 449: index 0 is outside the array [1..4]: nothing was written; limit the index before this block
    "#]].assert_eq(&first);
}

#[test]
fn forces_elsewhere_change_nothing() {
    let text = mixed().replace("VAR_INPUT a", "VAR_INPUT unused, a");
    let plain = trace(&mut simulation(&text), INPUTS, WATCH);
    let mut forced = simulation(&text);
    force(&mut forced, "unused", "1");
    assert_eq!(trace(&mut forced, INPUTS, WATCH), plain);
    // Nor the power of any element, scan by scan.
    let (mut plain, mut forced) = (simulation(&text), simulation(&text));
    force(&mut forced, "unused", "1");
    for scan in 0..40 {
        for (tag, bit) in [("a", 1), ("b", 4), ("i", 2)] {
            let value = u8::from(scan & bit != 0).to_string();
            set(&mut plain, tag, &value);
            set(&mut forced, tag, &value);
        }
        plain.scan();
        forced.scan();
        assert_eq!(diagram(&text, &plain), diagram(&text, &forced), "scan {scan}");
        assert!(plain.power().eq(forced.power()), "scan {scan}");
    }
}

#[test]
fn a_scan_allocates_nothing() {
    let mut simulation = simulation(&mixed());
    let run = |simulation: &mut ladder_simulator::Simulation| {
        let info = allocation_counter::measure(|| {
            for _ in 0..100 {
                simulation.scan();
            }
        });
        info.count_total
    };
    set(&mut simulation, "a", "1");
    set(&mut simulation, "i", "9");
    assert_eq!(run(&mut simulation), 0);
    force(&mut simulation, "y", "1");
    assert_eq!(run(&mut simulation), 0);
    // The check can fail.
    let one = allocation_counter::measure(|| drop(std::hint::black_box(Box::new(1))));
    assert_eq!(one.count_total, 1);
}

#[test]
fn live_wires_are_drawn_double() {
    let text = "VAR_INPUT a, b, c : BOOL; END_VAR\nVAR t : TON; y, z : BOOL; END_VAR\n\
                +--\\--[ ]( a )--\\--[/]( b )--[TON]( t, T#20ms )--( )( y )--+  # motor #\n\
                |  /--[ ]( c )--/                                         |\n\
                \n\
                +--[ ]( c )--# was: b #--( )( z )--------------------------+\n";
    let mut simulation = simulation(text);
    let mut log = diagram(text, &simulation);
    set(&mut simulation, "a", "1");
    simulation.scan();
    log.push_str(&diagram(text, &simulation));
    set(&mut simulation, "a", "0");
    set(&mut simulation, "c", "1");
    simulation.scan();
    simulation.scan();
    log.push_str(&diagram(text, &simulation));
    force(&mut simulation, "b", "1");
    simulation.scan();
    log.push_str(&diagram(text, &simulation));
    expect![[r#"
        VAR_INPUT a, b, c : BOOL; END_VAR
        VAR t : TON; y, z : BOOL; END_VAR
        +--\--[ ]( a )--\--[/]( b )--[TON]( t, T#20ms )--( )( y )--+  # motor #
        |  /--[ ]( c )--/                                         |

        +--[ ]( c )--# was: b #--( )( z )--------------------------+
        VAR_INPUT a, b, c : BOOL; END_VAR
        VAR t : TON; y, z : BOOL; END_VAR
        +==\==[ ]( a )==\==[/]( b )==[TON]( t, T#20ms )--( )( y )--+  # motor #
        |  /==[ ]( c )--/                                         |

        +==[ ]( c )--# was: b #--( )( z )--------------------------+
        VAR_INPUT a, b, c : BOOL; END_VAR
        VAR t : TON; y, z : BOOL; END_VAR
        +==\==[ ]( a )--\==[/]( b )==[TON]( t, T#20ms )==( )( y )==+  # motor #
        |  /==[ ]( c )==/                                         |

        +==[ ]( c )==# was: b #==( )( z )==========================+
        VAR_INPUT a, b, c : BOOL; END_VAR
        VAR t : TON; y, z : BOOL; END_VAR
        +==\==[ ]( a )--\==[/]( b )--[TON]( t, T#20ms )--( )( y )--+  # motor #
        |  /==[ ]( c )==/                                         |

        +==[ ]( c )==# was: b #==( )( z )==========================+
    "#]]
    .assert_eq(&log);
}

#[test]
fn what_was_not_reached_has_no_power() {
    let text = "VAR_INPUT a : BOOL; END_VAR\nVAR y, z : BOOL; END_VAR\n\
                +--\\--[ ]( a )--<JMP>( over )--( )( y )--+\n\
                \x20  /--( )( z )-------------------------+\n\
                +--[/]( y )--( )( x )--+\n\
                +--<LBL>( over )--( )( w )--+\n";
    let text = text.replace("y, z", "y, z, x, w");
    let mut simulation = simulation(&text);
    simulation.scan();
    let mut log = diagram(&text, &simulation);
    set(&mut simulation, "a", "1");
    simulation.scan();
    log.push_str(&diagram(&text, &simulation));
    expect![[r#"
        VAR_INPUT a : BOOL; END_VAR
        VAR y, z, x, w : BOOL; END_VAR
        +==\==[ ]( a )--<JMP>( over )--( )( y )--+
           /==( )( z )=========================+
        +==[/]( y )==( )( x )==+
        +==<LBL>( over )==( )( w )==+
        VAR_INPUT a : BOOL; END_VAR
        VAR y, z, x, w : BOOL; END_VAR
        +==\==[ ]( a )==<JMP>( over )--( )( y )--+
           /==( )( z )-------------------------+
        +--[/]( y )--( )( x )--+
        +==<LBL>( over )==( )( w )==+
    "#]]
    .assert_eq(&log);
}

#[test]
fn system_tags() {
    let text = "VAR f : BOOL; s : DINT; t, d : TIME; on, off : BOOL; END_VAR\n\
                +--[ ]( SYS.FIRST_SCAN )--( )( f )--+\n\
                +--[MOV]( s, SYS.SCAN )--[MOV]( t, SYS.TIME )--[MOV]( d, SYS.SCAN_TIME )--+\n\
                +--\\--[ ]( SYS.ON )---( )( on )---+\n\
                \x20  /--[ ]( SYS.OFF )--( )( off )--+\n";
    let options = Options {
        interval: 2_500_000,
        ..Options::default()
    };
    expect![[r#"
        f         -__
        s         0 1 2
        t         0 2.5 5
        d         0 2.5 2.5
        on        ---
        off       ___
        SYS.SCAN  0 1 2
        SYS.TIME  0 2.5 5
    "#]]
    .assert_eq(&trace(
        &mut simulation_with(text, options),
        "3",
        "f s t d on off SYS.SCAN SYS.TIME",
    ));
}

#[test]
fn a_run_can_be_cancelled() {
    let mut simulation = simulation("+--[ ]( a )--( )( y )--+\n");
    assert_eq!(simulation.run(7, &Cancel::default()), 7);
    assert_eq!(simulation.run(7, &Cancel::when(|| true)), 0);
    assert_eq!(simulation.scans(), 7);
    assert_eq!(get(&simulation, "SYS.SCAN"), "6");
}

#[test]
fn points_in_the_order_of_the_tags() {
    let simulation = simulation(&mixed());
    let names: Vec<String> = simulation
        .points()
        .iter()
        .map(|point| format!("{} {} {:?}", point.name, point.ty, point.role))
        .collect();
    expect![[r#"
        a BOOL Input
        b BOOL Input
        z INT Input
        i INT Input
        n INT Internal
        k INT Internal
        x LREAL Internal
        s STRING Internal
        arr[1] INT Internal
        arr[2] INT Internal
        arr[3] INT Internal
        arr[4] INT Internal
        t.Q BOOL Internal
        t.ET TIME Internal
        u.Q BOOL Internal
        u.ET TIME Internal
        c.Q BOOL Internal
        c.CV DINT Internal
        l BOOL Internal
        y BOOL Internal
        w WORD Internal
        z2 INT Internal"#]]
    .assert_eq(&names.join("\n"));
}

#[test]
fn arithmetic_in_each_type() {
    check(
        "VAR a : INT; b : SINT := 100; c : UINT; d : USINT := 200; e : ULINT := 16#FFFF_FFFF_FFFF_FFFF; f : LINT; END_VAR\n\
         VAR r : REAL; l : LREAL; t : TIME; w : WORD := 16#8001; y : BYTE := 16#81; p : BOOL; END_VAR\n\
         +--[SUB]( a, -7, 2 )--[DIV]( a, a, 2 )--[MOD]( f, -7, 3 )--[EXP]( f, f, 3 )--+\n\
         +--[ADD]( b, b, b )--[MUL]( d, d, 2 )--[DIV]( e, e, 2 )--[NEG]( c, 5 )--+\n\
         +--[DIV]( r, 1, 3 )--[DIV]( l, 1, 3 )--[MUL]( t, T#1s, 3 )--[DIV]( t, t, 2 )--+\n\
         +--[ROL]( w, w, 1 )--[SHR]( y, y, 7 )--[AND]( p, TRUE, SYS.ON )--[LIMIT]( c, 10, c, 20 )--+\n",
        "1",
        "a f b d e c r l t w y p",
        expect![[r#"
            a  -4
            f  -1
            b  -56
            d  144
            e  9223372036854775807
            c  20
            r  0.33333334
            l  0.3333333333333333
            t  1500
            w  3
            y  1
            p  -
        "#]],
    );
}

#[test]
fn one_part_at_a_time_shows_the_same_power() {
    let mut simulation = simulation(&mixed());
    for scan in 0..6 {
        set(&mut simulation, "a", if scan % 3 == 1 { "1" } else { "0" });
        simulation.scan();
        for (element, (kind, location, live)) in simulation.power().enumerate() {
            assert_eq!(
                simulation.is_live(element),
                live,
                "{kind:?} at {location:?} in scan {scan}"
            );
        }
    }
    assert!(!simulation.is_live(usize::MAX));
}

//! Time and retention: the scan interval, system tags, cold and warm restart, sentence by sentence.

use crate::support::{check, force, get, set, simulation, simulation_with};
use expect_test::{Expect, expect};
use ladder_simulator::{Kept, Options, Simulation};

fn run(simulation: &mut Simulation, scans: usize) {
    for _ in 0..scans {
        simulation.scan();
    }
}

fn values(simulation: &Simulation, tags: &str) -> String {
    tags.split_whitespace()
        .map(|tag| format!("{tag}={}", get(simulation, tag)))
        .collect::<Vec<_>>()
        .join(" ")
}

/// Runs a program, restarts it warm, and shows tags before and after.
#[track_caller]
fn over_a_warm_restart(text: &str, prepare: impl FnOnce(&mut Simulation), tags: &str, expected: Expect) {
    let mut simulation = simulation(text);
    prepare(&mut simulation);
    let before = values(&simulation, tags);
    let kept = simulation.retained();
    simulation.warm_restart();
    let after = values(&simulation, tags);
    expected.assert_eq(&format!("before: {before}\nafter:  {after}\n"));
    // What went through texts is the same.
    let mut other = self::simulation(text);
    assert_eq!(other.warm_start(&kept), Vec::<String>::new());
    assert_eq!(values(&other, tags), after);
}

#[test]
fn system_tags_tell_the_time() {
    check(
        "VAR n : DINT; t, d : TIME; END_VAR\n\
         +--[ ]( SYS.FIRST_SCAN )--( )( first )--+\n\
         +--[MOV]( n, SYS.SCAN )--[MOV]( t, SYS.TIME )--[MOV]( d, SYS.SCAN_TIME )--+\n\
         +--[ ]( SYS.ON )--( )( on )--+\n+--[ ]( SYS.OFF )--( )( off )--+\n",
        "4",
        "first n t d on off",
        expect![[r#"
            first  -___
            n      0 1 2 3
            t      0 10 20 30
            d      0 10 10 10
            on     ----
            off    ____
        "#]],
    );
}

#[test]
fn the_clock_moves_by_the_interval() {
    let options = Options {
        interval: 2_500_000,
        ..Options::default()
    };
    let mut simulation = simulation_with("VAR t : TIME; END_VAR\n+--[MOV]( t, SYS.TIME )--+\n", options);
    run(&mut simulation, 4);
    assert_eq!(
        (get(&simulation, "t"), simulation.time()),
        ("7.5".into(), 10_000_000)
    );
}

#[test]
fn a_fault_is_seen_in_the_next_scan() {
    check(
        "VAR_INPUT d : DINT; END_VAR\nVAR n : DINT; END_VAR\n\
         +--[DIV]( n, 1, d )--+\n+--[ ]( SYS.FAULT )--( )( alarm )--+\n",
        "d 1 0 1 1",
        "alarm",
        expect![[r#"
            alarm  __-_
            scan 1 at 53: division by zero: nothing was written; check the divisor before this block
        "#]],
    );
}

#[test]
fn retain_keeps_the_value_and_nothing_else_does() {
    over_a_warm_restart(
        "VAR RETAIN a : DINT := 5; END_VAR\nVAR b : DINT := 7; END_VAR\n\
         VAR_INPUT RETAIN i : INT; END_VAR\nVAR_INPUT j : INT := 3; END_VAR\n\
         +--[ADD]( a, a, 1 )--[ADD]( b, b, 1 )--+\n",
        |simulation| {
            set(simulation, "i", "4");
            set(simulation, "j", "4");
            run(simulation, 3);
        },
        "a b i j SYS.SCAN SYS.TIME",
        expect![[r#"
            before: a=8 b=10 i=4 j=4 SYS.SCAN=2 SYS.TIME=20
            after:  a=8 b=7 i=4 j=3 SYS.SCAN=0 SYS.TIME=0
        "#]],
    );
}

#[test]
fn a_cold_restart_keeps_nothing() {
    let mut simulation =
        simulation("VAR RETAIN a : DINT := 5; END_VAR\n+--[ADD]( a, a, 1 )--( M )( m )--+\n");
    run(&mut simulation, 3);
    simulation.reset();
    assert_eq!(values(&simulation, "a m SYS.SCAN"), "a=5 m=0 SYS.SCAN=0");
}

#[test]
fn the_first_scan_after_a_warm_restart_is_a_first_scan() {
    let mut simulation =
        simulation("VAR RETAIN n : DINT; END_VAR\n+--[ ]( SYS.FIRST_SCAN )--[ADD]( n, n, 1 )--+\n");
    run(&mut simulation, 3);
    simulation.warm_restart();
    assert_eq!((simulation.scans(), simulation.time()), (0, 0));
    run(&mut simulation, 3);
    assert_eq!(get(&simulation, "n"), "2");
}

#[test]
fn retentive_coils_and_persist_make_a_tag_retentive() {
    over_a_warm_restart(
        "VAR_INPUT x : BOOL; END_VAR\nVAR n, k : INT; w : WORD; f : ARRAY[1..3] OF INT; END_VAR\n\
         +--[ ]( x )--(M)( m )--(SM)( s )--( )( plain )--+\n+--[/]( x )--(RM)( r )--+\n\
         +--[ ]( x )--(M)( w.3 )--[MOV]( w, 16#FF )--(M)( w.1 )--+\n\
         +--[MOV]( n, 6 )--[MOV]( k, 6 )--[MOV]( f[2], 5 )--[PERSIST]( n )--[PERSIST]( f[1] )--+\n",
        |simulation| {
            set(simulation, "r", "1");
            set(simulation, "x", "1");
            run(simulation, 2);
        },
        "m s plain r w n k f[2]",
        expect![[r#"
            before: m=1 s=1 plain=1 r=1 w=255 n=6 k=6 f[2]=5
            after:  m=1 s=1 plain=0 r=1 w=255 n=6 k=0 f[2]=5
        "#]],
    );
}

#[test]
fn every_type_is_kept() {
    over_a_warm_restart(
        "VAR RETAIN\n b : BOOL := TRUE; y : BYTE := 200; l : LWORD := 16#FFFFFFFFFFFFFFFF; i : SINT := -5;\n\
         u : ULINT := 18446744073709551615; r : REAL := 0.1; d : LREAL := -1.5e300; t : TIME := T#-1h2ms;\n\
         a : DATE := D#2026-11-21; o : TOD := TOD#13:45:00.5; z : DT := DT#2026-11-21-13:45:00;\n\
         s : STRING := 'it$'s $T$N$00'; v : ARRAY[-1..1] OF STRING[4] := ['a', 'b', '']; END_VAR\n\
         VAR n : INT; END_VAR\n+--[MOV]( v[1], 'xyzz' )--[NOT]( y, y )--[MOV]( s, 'a$Nb' )--+\n",
        |simulation| run(simulation, 1),
        "b y l i u r d t a o z s v[-1] v[1]",
        expect![[r#"
            before: b=1 y=55 l=18446744073709551615 i=-5 u=18446744073709551615 r=0.1 d=-1.5e300 t=-3600002 a=2026-11-21 o=13:45:00.5 z=2026-11-21-13:45:00 s=a
            b v[-1]=a v[1]=xyzz
            after:  b=1 y=55 l=18446744073709551615 i=-5 u=18446744073709551615 r=0.1 d=-1.5e300 t=-3600002 a=2026-11-21 o=13:45:00.5 z=2026-11-21-13:45:00 s=a
            b v[-1]=a v[1]=xyzz
        "#]],
    );
}

const TIMERS: &str = "VAR_INPUT x : BOOL; END_VAR\n\
    VAR RETAIN on : TON; off : TOF; p : TP; keep : RTO; c : CTU; b : SR; END_VAR\nVAR lost : TON; END_VAR\n\
    +--[ ]( x )--[TON]( on, T#80ms )--( )( q )--+\n+--[ ]( x )--[TP]( p, T#80ms )--+\n\
    +--[ ]( x )--[RTO]( keep, T#1h )--+\n+--[ ]( x )--[CTU]( c, 9 )--+\n+--[ ]( x )--[SR]( b )--+\n\
    +--[/]( x )--[TOF]( off, T#80ms )--+\n+--[ ]( x )--[TON]( lost, T#80ms )--+\n";

#[test]
fn timers_counters_and_bistables_go_on_where_they_were() {
    let tags = "on.ET p.ET p.Q keep.ET c.CV b.Q1 off.ET off.Q lost.ET";
    over_a_warm_restart(
        TIMERS,
        |simulation| {
            run(simulation, 1);
            set(simulation, "x", "1");
            run(simulation, 5);
        },
        tags,
        expect![[r#"
            before: on.ET=40 p.ET=40 p.Q=1 keep.ET=40 c.CV=1 b.Q1=1 off.ET=40 off.Q=1 lost.ET=40
            after:  on.ET=40 p.ET=40 p.Q=1 keep.ET=40 c.CV=1 b.Q1=1 off.ET=40 off.Q=1 lost.ET=0
        "#]],
    );
    // The time that passed before counts on; that of the failure itself is not known.
    let mut simulation = simulation(TIMERS);
    run(&mut simulation, 1);
    set(&mut simulation, "x", "1");
    run(&mut simulation, 5);
    let kept = simulation.retained();
    let mut other = self::simulation(TIMERS);
    other.warm_start(&kept);
    for simulation in [&mut simulation, &mut other] {
        set(simulation, "x", "1");
    }
    simulation.warm_restart();
    set(&mut simulation, "x", "1");
    let mut seen = Vec::new();
    for _ in 0..6 {
        simulation.scan();
        other.scan();
        assert_eq!(values(&simulation, tags), values(&other, tags));
        seen.push(values(&simulation, "on.ET on.Q p.Q keep.ET c.CV lost.ET"));
    }
    expect![[r#"
        on.ET=50 on.Q=0 p.Q=1 keep.ET=50 c.CV=1 lost.ET=0
        on.ET=60 on.Q=0 p.Q=1 keep.ET=60 c.CV=1 lost.ET=10
        on.ET=70 on.Q=0 p.Q=1 keep.ET=70 c.CV=1 lost.ET=20
        on.ET=80 on.Q=1 p.Q=0 keep.ET=80 c.CV=1 lost.ET=30
        on.ET=80 on.Q=1 p.Q=0 keep.ET=90 c.CV=1 lost.ET=40
        on.ET=80 on.Q=1 p.Q=0 keep.ET=100 c.CV=1 lost.ET=50"#]]
    .assert_eq(&seen.join("\n"));
}

#[test]
fn the_memory_of_edges_begins_again() {
    check_edges("+--[P]( kept )--[ADD]( n, n, 1 )--+\n");
    check_edges("+--[ ]( kept )--[OSR]--[ADD]( n, n, 1 )--+\n");
}

/// A retentive tag that is high rises again for an edge after a warm restart: a first evaluation counts a high tag as
/// having risen.
fn check_edges(rung: &str) {
    let text = format!("VAR RETAIN kept : BOOL := TRUE; n : INT; END_VAR\n{rung}");
    let mut simulation = simulation(&text);
    run(&mut simulation, 3);
    assert_eq!(get(&simulation, "n"), "1");
    simulation.warm_restart();
    run(&mut simulation, 3);
    assert_eq!(get(&simulation, "n"), "2");
}

#[test]
fn bodies_keep_their_own_for_each_place() {
    let mut simulation = simulation(
        "FUNCTION_BLOCK [$Count]\nVAR_INPUT up : BOOL; END_VAR\nVAR_OUTPUT seen : INT; END_VAR\nVAR RETAIN n : INT; END_VAR\n\
         VAR hits : INT; m : BOOL; END_VAR\nVAR_IN_OUT last : BOOL; END_VAR\n\
         +--[ ]( up )--[ADD]( n, n, 1 )--[ADD]( hits, hits, 1 )--(M)( m )--(SM)( last )--+\n+--[MOV]( seen, n )--+\nEND_FUNCTION_BLOCK\n\
         VAR_INPUT a, b : BOOL; END_VAR\nVAR x, y : INT; la, lb : BOOL; END_VAR\n\
         +--[$Count]( a, x, la )--+\n+--[$Count]( b, y, lb )--+\n",
    );
    set(&mut simulation, "a", "1");
    run(&mut simulation, 4);
    let kept = |simulation: &Simulation| {
        let line = |kept: &Kept| format!("{} : {} = {}\n", kept.name, kept.ty, kept.values.join(", "));
        simulation.retained().iter().map(line).collect::<String>()
    };
    expect![[r#"
        la : BOOL = TRUE
        lb : BOOL = FALSE
        $Count[1].n : INT = 4
        $Count[1].m : BOOL = TRUE
        $Count[2].n : INT = 0
        $Count[2].m : BOOL = FALSE
    "#]]
    .assert_eq(&kept(&simulation));
    simulation.warm_restart();
    run(&mut simulation, 1);
    assert_eq!(values(&simulation, "x y la lb"), "x=4 y=0 la=1 lb=0");
}

#[test]
fn a_forced_tag_stays_forced_over_a_restart() {
    let mut simulation =
        simulation("VAR RETAIN n, k : INT; END_VAR\n+--[ADD]( n, n, 1 )--[ADD]( k, k, 1 )--+\n");
    run(&mut simulation, 3);
    force(&mut simulation, "n", "40");
    let kept = simulation.retained();
    simulation.warm_restart();
    assert_eq!(values(&simulation, "n k"), "n=40 k=3");
    run(&mut simulation, 2);
    assert_eq!(values(&simulation, "n k"), "n=40 k=5");
    simulation.warm_start(&kept);
    assert_eq!(values(&simulation, "n k"), "n=40 k=3");
}

#[test]
fn values_of_another_program_are_taken_tag_by_tag() {
    let mut simulation = simulation(
        "VAR RETAIN a : INT := 1; b : DINT := 2; c : ARRAY[1..3] OF INT; t : TON; k : CTU; s : SR; END_VAR\n\
         VAR d : INT := 4; END_VAR\n\
         +--[ ]( SYS.OFF )--[TON]( t, T#1s )--[CTU]( k, 5 )--[SR]( s )--[MOV]( d, c[1] )--[ADD]( a, b, 1 )--+\n"
            .replace("[ADD]( a, b, 1 )", "[ADD]( b, a, 1 )")
            .as_str(),
    );
    let kept = |name: &str, ty: &str, values: &str| Kept {
        name: name.into(),
        ty: ty.into(),
        values: values.split(' ').map(str::to_owned).collect(),
    };
    let complaints = simulation.warm_start(&[
        kept("A", "INT", "77"),
        kept("b", "INT", "77"),
        kept("gone", "INT", "77"),
        kept("d", "INT", "77"),
        kept("c", "ARRAY[1..3] OF INT", "1 2"),
        kept("c", "ARRAY[0..2] OF INT", "1 2 3"),
        kept("a", "INT", "40000"),
        kept("t", "TON", "1 0 0 9 0 0 0"),
        kept("k", "CTU", "0 0 0 0 0 0 0 0 0 1 99999999999"),
        kept("s", "SR", "x"),
    ]);
    expect![[r#"
        b was kept as INT, but it is DINT now: it begins with its initial value
        gone was kept, but the program has no retentive tag of that name any more
        d was kept, but the program has no retentive tag of that name any more
        c: 2 values were kept where 3 belong: it begins with its initial value
        a: 40000 does not fit: INT holds -32768 to 32767: it begins with its initial value
        t: this is not a state of a TON: it begins with its initial value
        k: this is not a state of a CTU: it begins with its initial value
        s: `x` is not a number: it begins with its initial value"#]]
    .assert_eq(&complaints.join("\n"));
    assert_eq!(values(&simulation, "a b d c[1]"), "a=77 b=2 d=4 c[1]=2");
}

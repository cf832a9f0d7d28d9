//! Why a tag holds what it holds.

use crate::support::{simulation, stimulus};
use expect_test::{Expect, expect};
use ladder_simulator::value_text::parse;
use ladder_simulator::{HistoryLimits, Moment, Session, Wording};

/// Runs a program and asks about tags.
#[track_caller]
fn check(text: &str, inputs: &str, tags: &str, expected: Expect) {
    let mut session = Session::of(simulation(text), HistoryLimits::default());
    run(&mut session, inputs);
    expected.assert_eq(&ask(&mut session, text, tags));
}

fn run(session: &mut Session, inputs: &str) {
    let (scans, rows) = stimulus(inputs);
    for scan in 0..scans {
        for (tag, cells) in &rows {
            if let Some(value) = cells.get(scan).filter(|cell| *cell != ".") {
                set(session, tag, value);
            }
        }
        session.scan();
    }
}

fn set(session: &mut Session, tag: &str, value: &str) {
    let point = session.simulation().resolve(tag).unwrap();
    let value = parse(value, point.ty).unwrap();
    session.set(&point, value).unwrap();
}

fn ask(session: &mut Session, text: &str, tags: &str) -> String {
    let mut shown = String::new();
    for tag in tags.split_whitespace() {
        let point = session
            .simulation()
            .resolve(tag)
            .unwrap_or_else(|error| panic!("{error}"));
        shown.push_str(&session.why(&point).text(&[text], &[]));
        shown.push('\n');
    }
    shown
}

const MOTOR: &str = "\
+--\\--[ ]( start )--\\--[/]( stop )-------------( )( run )--+
|  /--[ ]( run )----/                                      |
";

#[test]
fn what_is_off_is_blocked() {
    check(
        MOTOR,
        "start _--____\nstop  ____-__",
        "run",
        expect![[r#"
            run is 0 since scan 4 (40 ms): line 1, ( )( run ) wrote it; blocked by [/]( stop ) (line 1, column 24): stop is 1; now, in scan 6, it is blocked by [ ]( start ) (line 1, column 7): start is 0; or else by [ ]( run ) (line 2, column 7): run is 0
              stop is 1 since scan 4 (40 ms): it was given from outside
              start is 0 since scan 3 (30 ms): it was given from outside
        "#]],
    );
    check(
        MOTOR,
        "start _--____\nstop  ____--_",
        "run",
        expect![[r#"
            run is 0 since scan 4 (40 ms): line 1, ( )( run ) wrote it; blocked by [/]( stop ) (line 1, column 24): stop is 1; now, in scan 6, it is blocked by [ ]( start ) (line 1, column 7): start is 0; or else by [ ]( run ) (line 2, column 7): run is 0
              stop is 1 since scan 4 (40 ms): it was given from outside
              start is 0 since scan 3 (30 ms): it was given from outside
        "#]],
    );
    check(
        MOTOR,
        "start __\nstop  --",
        "run",
        expect![[r#"
        run is 0 since the start: line 1, ( )( run ) wrote it; blocked by [ ]( start ) (line 1, column 7): start is 0 and by [/]( stop ) (line 1, column 24): stop is 1; or else by [/]( stop ) (line 1, column 24): stop is 1 and by [ ]( run ) (line 2, column 7): run is 0
          start is 0 since the start: nothing else was given
          stop is 1 since scan 0 (0 ms): it was given from outside
    "#]],
    );
    check(
        MOTOR,
        "3",
        "run start",
        expect![[r#"
        run is 0 since the start: line 1, ( )( run ) wrote it; blocked by [ ]( start ) (line 1, column 7): start is 0; or else by [ ]( run ) (line 2, column 7): run is 0
          start is 0 since the start: nothing else was given
        start is 0 since the start: nothing else was given
    "#]],
    );
}

#[test]
fn what_is_on_was_made_so() {
    check(
        MOTOR,
        "start _-___\nstop  _____",
        "run start",
        expect![[r#"
        run is 1 since scan 1 (10 ms): line 1, ( )( run ) wrote it; power came through [ ]( start ) (line 1, column 7): start is 1, [/]( stop ) (line 1, column 24): stop is 0
          start is 1 since scan 1 (10 ms): it was given from outside
          stop is 0 since the start: nothing else was given
        start is 0 since scan 2 (20 ms): it was given from outside
    "#]],
    );
}

#[test]
fn what_is_not_kept_is_not_known() {
    let limits = HistoryLimits::of_scans(3);
    let mut session = Session::of(simulation(MOTOR), limits);
    run(&mut session, "start _-_______");
    expect![[r#"
        run is 1 since before the scans that are kept: line 1, ( )( run ) wrote it; power came through [ ]( run ) (line 2, column 7): run is 1, [/]( stop ) (line 1, column 24): stop is 0
          stop is 0 since the start: nothing else was given
        stop is 0 since the start: nothing else was given
    "#]].assert_eq(&ask(&mut session, MOTOR, "run stop"));
    let mut session = Session::of(simulation(MOTOR), HistoryLimits::of_scans(0));
    run(&mut session, "start _-_______");
    expect![[r#"
        run is 1 since before the scans that are kept: what wrote it is not known
    "#]]
    .assert_eq(&ask(&mut session, MOTOR, "run"));
}

#[test]
fn of_a_long_run_what_changed_before_the_kept_scans_and_what_among_them() {
    let text =
        "+--[ ]( early )--( )( a )--+\n\n+--[ ]( late )--( )( b )--+\n\n+--[ ]( never )--( )( c )--+\n";
    let mut session = Session::of(simulation(text), HistoryLimits::of_scans(400));
    for scan in 0..1000 {
        match scan {
            10 => set(&mut session, "early", "1"),
            // The first scan that is kept at the end, and the last one that is not.
            600 => set(&mut session, "late", "1"),
            599 => set(&mut session, "early", "0"),
            _ => {}
        }
        session.scan();
    }
    expect![[r#"
        a is 0 since before the scans that are kept: line 1, ( )( a ) wrote it; blocked by [ ]( early ) (line 1, column 4): early is 0
          early is 0 since before the scans that are kept: it was given from outside
        b is 1 since scan 600 (6000 ms): line 3, ( )( b ) wrote it; power came through [ ]( late ) (line 3, column 4): late is 1
          late is 1 since scan 600 (6000 ms): it was given from outside
        c is 0 since the start: line 5, ( )( c ) wrote it; blocked by [ ]( never ) (line 5, column 4): never is 0
          never is 0 since the start: nothing else was given
        early is 0 since before the scans that are kept: it was given from outside
        late is 1 since scan 600 (6000 ms): it was given from outside
        never is 0 since the start: nothing else was given
    "#]].assert_eq(&ask(&mut session, text, "a b c early late never"));
    assert_eq!(session.step_back(300), 300);
    expect![[r#"
        a is 0 since before the scans that are kept: line 1, ( )( a ) wrote it; blocked by [ ]( early ) (line 1, column 4): early is 0
          early is 0 since before the scans that are kept: it was given from outside
        b is 1 since scan 600 (6000 ms): line 3, ( )( b ) wrote it; power came through [ ]( late ) (line 3, column 4): late is 1
          late is 1 since scan 600 (6000 ms): it was given from outside
    "#]].assert_eq(&ask(&mut session, text, "a b"));
    // Another way on: what is done now counts, whatever lay ahead.
    set(&mut session, "early", "1");
    session.scan();
    expect![[r#"
        a is 1 since scan 700 (7000 ms): line 1, ( )( a ) wrote it; power came through [ ]( early ) (line 1, column 4): early is 1
          early is 1 since scan 700 (7000 ms): it was given from outside
        b is 1 since scan 600 (6000 ms): line 3, ( )( b ) wrote it; power came through [ ]( late ) (line 3, column 4): late is 1
          late is 1 since scan 600 (6000 ms): it was given from outside
    "#]].assert_eq(&ask(&mut session, text, "a b"));
}

#[test]
fn every_way_in_which_power_could_come() {
    // Two in a row, next to one; a bridge; an input that is on already.
    check(
        "+--\\--[ ]( a )--[ ]( b )--\\--[ ]( on )--( )( y )--+\n|  /--[ ]( c )-----------/                        |\n",
        "on ---",
        "y",
        expect![[r#"
            y is 0 since the start: line 1, ( )( y ) wrote it; blocked by [ ]( c ) (line 2, column 7): c is 0; or else by [ ]( a ) (line 1, column 7): a is 0 and by [ ]( b ) (line 1, column 17): b is 0
              c is 0 since the start: nothing else was given
              a is 0 since the start: nothing else was given
              b is 0 since the start: nothing else was given
        "#]],
    );
    check(
        "+--[ ]( a )--\\--[ ]( b )--\\--( )( y )--+\n+--[ ]( c )--/--[ ]( d )--/            |\n",
        "a _--\nd ___",
        "y",
        expect![[r#"
            y is 0 since the start: line 1, ( )( y ) wrote it; blocked by [ ]( b ) (line 1, column 17): b is 0; or else by [ ]( d ) (line 2, column 17): d is 0
              b is 0 since the start: nothing else was given
              d is 0 since the start: nothing else was given
        "#]],
    );
    // A contact twice in the same way counts once as a tag, but both must close.
    check(
        "+--[ ]( a )--[ ]( b )--[ ]( a )--( )( y )--+\n",
        "b --",
        "y",
        expect![[r#"
            y is 0 since the start: line 1, ( )( y ) wrote it; blocked by [ ]( a ) (line 1, column 4): a is 0 and by [ ]( a ) (line 1, column 24): a is 0
              a is 0 since the start: nothing else was given
        "#]],
    );
}

#[test]
fn inverters_comparisons_and_timers_in_the_way() {
    let text = "VAR_INPUT x : BOOL; n : INT; END_VAR\nVAR t : TON; END_VAR\n\
                +--[ ]( x )--[NOT]--( )( y )--+\n\
                +--[GT]( n, 5 )--( )( z )--+\n\
                +--[ ]( x )--[TON]( t, T#50ms )--( )( late )--+\n";
    check(
        text,
        "x _---\nn 1 2 3 4",
        "y z late t.Q t.ET",
        expect![[r#"
            y is 0 since scan 1 (10 ms): line 3, ( )( y ) wrote it; blocked by [NOT] (line 3, column 14): x is 1
              x is 1 since scan 1 (10 ms): it was given from outside
            z is 0 since the start: line 4, ( )( z ) wrote it; blocked by [GT]( n, 5 ) (line 4, column 4): n is 4
              n is 4 since scan 3 (30 ms): it was given from outside
            late is 0 since the start: line 5, ( )( late ) wrote it; blocked by [TON]( t, T#50ms ) (line 5, column 14): t.ET is T#20ms
              t.ET is T#20ms since scan 3 (30 ms): line 5, [TON]( t, T#50ms ) wrote it; power came through [ ]( x ) (line 5, column 4): x is 1
                x is 1 since scan 1 (10 ms): it was given from outside
            t.Q is 0 since the start: line 5, [TON]( t, T#50ms ) wrote it; power came through [ ]( x ) (line 5, column 4): x is 1
              x is 1 since scan 1 (10 ms): it was given from outside
            t.ET is T#20ms since scan 3 (30 ms): line 5, [TON]( t, T#50ms ) wrote it; power came through [ ]( x ) (line 5, column 4): x is 1
              x is 1 since scan 1 (10 ms): it was given from outside
        "#]],
    );
    check(
        text,
        "x _------\nn 1 2 9 9 9 9 9",
        "z late t.Q",
        expect![[r#"
            z is 1 since scan 2 (20 ms): line 4, ( )( z ) wrote it; power came through [GT]( n, 5 ) (line 4, column 4): n is 9
              n is 9 since scan 2 (20 ms): it was given from outside
            late is 1 since scan 6 (60 ms): line 5, ( )( late ) wrote it; power came through [ ]( x ) (line 5, column 4): x is 1, [TON]( t, T#50ms ) (line 5, column 14): t.ET is T#50ms
              x is 1 since scan 1 (10 ms): it was given from outside
              t.ET is T#50ms since scan 6 (60 ms): line 5, [TON]( t, T#50ms ) wrote it; power came through [ ]( x ) (line 5, column 4): x is 1
            t.Q is 1 since scan 6 (60 ms): line 5, [TON]( t, T#50ms ) wrote it; power came through [ ]( x ) (line 5, column 4): x is 1
              x is 1 since scan 1 (10 ms): it was given from outside
        "#]],
    );
    check(
        text,
        "x -_",
        "late",
        expect![[r#"
            late is 0 since the start: line 5, ( )( late ) wrote it; blocked by [ ]( x ) (line 5, column 4): x is 0 and by [TON]( t, T#50ms ) (line 5, column 14): t.ET is T#0s
              x is 0 since scan 1 (10 ms): it was given from outside
              t.ET is T#0s since the start: line 5, [TON]( t, T#50ms ) wrote it; blocked by [ ]( x ) (line 5, column 4): x is 0
        "#]],
    );
}

#[test]
fn latches_moves_and_counters() {
    let text = "VAR_INPUT on, off : BOOL; END_VAR\nVAR n, m : INT; c : CTU; END_VAR\n\
                +--[ ]( on )--(S)( lamp )--[MOV]( n, 7 )--[CTU]( c, 3 )--+\n\
                +--[ ]( off )--(R)( lamp )--+\n\
                +--[ADD]( m, n, 1 )--+\n";
    check(
        text,
        "on  _-____\noff ______",
        "lamp n m c.CV",
        expect![[r#"
            lamp is 1 since scan 1 (10 ms): line 3, (S)( lamp ) wrote it; power came through [ ]( on ) (line 3, column 4): on is 1
              on is 1 since scan 1 (10 ms): it was given from outside
            n is 7 since scan 1 (10 ms): line 3, [MOV]( n, 7 ) wrote it; power came through [ ]( on ) (line 3, column 4): on is 1, (S)( lamp ) (line 3, column 15)
              on is 1 since scan 1 (10 ms): it was given from outside
            m is 8 since scan 1 (10 ms): line 5, [ADD]( m, n, 1 ) wrote it (n is 7); power came straight from the rail
              n is 7 since scan 1 (10 ms): line 3, [MOV]( n, 7 ) wrote it; power came through [ ]( on ) (line 3, column 4): on is 1, (S)( lamp ) (line 3, column 15)
                on is 1 since scan 1 (10 ms): it was given from outside
            c.CV is 1 since scan 1 (10 ms): line 3, [CTU]( c, 3 ) wrote it; power came through [ ]( on ) (line 3, column 4): on is 1, (S)( lamp ) (line 3, column 15), [MOV]( n, 7 ) (line 3, column 28)
              on is 1 since scan 1 (10 ms): it was given from outside
        "#]],
    );
    check(
        text,
        "on  _-____\noff ___-__",
        "lamp",
        expect![[r#"
        lamp is 0 since scan 3 (30 ms): line 4, (R)( lamp ) wrote it; power came through [ ]( off ) (line 4, column 4): off is 1
          off is 1 since scan 3 (30 ms): it was given from outside
    "#]],
    );
    check(
        text,
        "2",
        "lamp n",
        expect![[r#"
        lamp is 0 since the start: nothing has written it
        n is 0 since the start: nothing has written it
    "#]],
    );
}

#[test]
fn the_rail_may_be_off_and_the_rung_may_be_passed_by() {
    let text = "VAR_INPUT live, skip : BOOL; END_VAR\n\
                +--[ ]( live )--<MCR>--+\n+--[ ]( SYS.ON )--( )( y )--+\n+--<MCR>--+\n\
                +--[ ]( skip )--<JMP>( end )--+\n+--[ ]( live )--( )( z )--+\n+--<LBL>( end )--( )( w )--+\n";
    check(
        text,
        "live _-_\nskip __-",
        "y z w",
        expect![[r#"
            y is 0 since scan 2 (20 ms): line 3, ( )( y ) wrote it; blocked by the left rail (line 3): an <MCR> has switched it off
            z is 1 since scan 1 (10 ms): line 6, ( )( z ) wrote it; power came through [ ]( live ) (line 6, column 4): live is 1
              live is 1 since scan 1 (10 ms): it was given from outside
            w is 1 since scan 0 (0 ms): line 7, ( )( w ) wrote it; power came through <LBL>( end ) (line 7, column 4)
        "#]],
    );
}

#[test]
fn forces_system_tags_blocks_and_arrays() {
    let text = "FUNCTION_BLOCK [$Copy]\nVAR_INPUT a : BOOL; END_VAR\nVAR_OUTPUT b : BOOL; END_VAR\n\
                +--[ ]( a )--( )( b )--+\nEND_FUNCTION_BLOCK\n\
                VAR_INPUT x : BOOL; i : INT; END_VAR\nVAR y : BOOL; f : ARRAY[1..3] OF INT; w : WORD; END_VAR\n\
                +--[$Copy]( x, y )--+\n+--[ ]( x )--[MOV]( f[i], 5 )--[MOV]( f[3], 6 )--( )( w.2 )--+\n";
    let mut session = Session::of(simulation(text), HistoryLimits::default());
    set(&mut session, "i", "2");
    run(&mut session, "x _--");
    let before = session.step_back(0);
    assert_eq!(before, 0);
    expect![[r#"
        y is 1 since scan 1 (10 ms): line 8, [$Copy]( x, y ) wrote it ($Copy#1.b is 1); power came straight from the rail
          $Copy#1.b is 1 since scan 1 (10 ms): line 4, ( )( b ) wrote it; power came through [ ]( a ) (line 4, column 4): $Copy#1.a is 1
            $Copy#1.a is 1 since scan 1 (10 ms): line 8, [$Copy]( x, y ) wrote it (x is 1); power came straight from the rail
              x is 1 since scan 1 (10 ms): it was given from outside
        f[1] is 0 since the start: nothing has written it
        f[2] is 5 since scan 1 (10 ms): line 9, [MOV]( f[i], 5 ) wrote it (i is 2); power came through [ ]( x ) (line 9, column 4): x is 1
          x is 1 since scan 1 (10 ms): it was given from outside
        f[3] is 6 since scan 1 (10 ms): line 9, [MOV]( f[3], 6 ) wrote it; power came through [ ]( x ) (line 9, column 4): x is 1, [MOV]( f[i], 5 ) (line 9, column 14)
          x is 1 since scan 1 (10 ms): it was given from outside
        w.2 is 1 since scan 1 (10 ms): line 9, ( )( w.2 ) wrote it; power came through [ ]( x ) (line 9, column 4): x is 1, [MOV]( f[i], 5 ) (line 9, column 14), [MOV]( f[3], 6 ) (line 9, column 32)
          x is 1 since scan 1 (10 ms): it was given from outside
        w.3 is 0 since the start: nothing has written it
        SYS.SCAN is 2 since scan 2 (20 ms): the simulation keeps it
    "#]].assert_eq(&ask(&mut session, text, "y f[1] f[2] f[3] w.2 w.3 SYS.SCAN"));
    let y = session.simulation().resolve("y").unwrap();
    session.force(&y, parse("0", y.ty).unwrap()).unwrap();
    expect![[r#"
        y is 0 since scan 3 (30 ms): it is forced
    "#]]
    .assert_eq(&ask(&mut session, text, "y"));
}

#[test]
fn in_the_midst_of_a_scan_and_in_the_past() {
    let text = "+--[ ]( a )--( )( x )--+\n+--[ ]( x )--( )( y )--+\n+--[/]( a )--( )( x )--+\n";
    let mut session = Session::of(simulation(text), HistoryLimits::default());
    run(&mut session, "a _-");
    set(&mut session, "a", "0");
    expect![[r#"
        x is 0 since scan 1 (10 ms): line 3, ( )( x ) wrote it; blocked by [/]( a ) (line 3, column 4): a is 1
          a is 1 since scan 1 (10 ms): it was given from outside
        y is 1 since scan 1 (10 ms): line 2, ( )( y ) wrote it; power came through [ ]( x ) (line 2, column 4): x is 1
          x is 1 since scan 0 (0 ms): line 3, ( )( x ) wrote it; power came through [/]( a ) (line 3, column 4): a is 0
            a is 0 since the start: nothing else was given
        a is 0 since scan 2 (20 ms): it was given from outside
    "#]].assert_eq(&ask(&mut session, text, "x y a"));
    session.step_network();
    session.step_network();
    expect![[r#"
        x is 0 since scan 1 (10 ms): line 3, ( )( x ) wrote it; blocked by [/]( a ) (line 3, column 4): a is 1; now, in scan 2, it is blocked by [ ]( a ) (line 1, column 4): a is 0
          a is 1 since scan 1 (10 ms): it was given from outside
          a is 0 since scan 2 (20 ms): it was given from outside
        y is 1 since scan 1 (10 ms): line 2, ( )( y ) wrote it; power came through [ ]( x ) (line 2, column 4): x is 1
          x is 1 since scan 0 (0 ms): line 3, ( )( x ) wrote it; power came through [/]( a ) (line 3, column 4): a is 0
            a is 0 since the start: nothing else was given
    "#]].assert_eq(&ask(&mut session, text, "x y"));
    // Asking changes nothing.
    session.scan();
    run(&mut session, "2");
    expect![[r#"
        x is 1 since scan 2 (20 ms): line 3, ( )( x ) wrote it; power came through [/]( a ) (line 3, column 4): a is 0
          a is 0 since scan 2 (20 ms): it was given from outside
        y is 0 since scan 2 (20 ms): line 2, ( )( y ) wrote it; blocked by [ ]( x ) (line 2, column 4): x is 0
          x is 0 since scan 1 (10 ms): line 3, ( )( x ) wrote it; blocked by [/]( a ) (line 3, column 4): a is 1
            a is 1 since scan 1 (10 ms): it was given from outside
    "#]].assert_eq(&ask(&mut session, text, "x y"));
    session.step_back(3);
    expect![[r#"
        x is 0 since scan 1 (10 ms): line 3, ( )( x ) wrote it; blocked by [/]( a ) (line 3, column 4): a is 1
          a is 1 since scan 1 (10 ms): it was given from outside
        y is 1 since scan 1 (10 ms): line 2, ( )( y ) wrote it; power came through [ ]( x ) (line 2, column 4): x is 1
          x is 1 since scan 0 (0 ms): line 3, ( )( x ) wrote it; power came through [/]( a ) (line 3, column 4): a is 0
            a is 0 since the start: nothing else was given
    "#]].assert_eq(&ask(&mut session, text, "x y"));
    assert_eq!(session.scans_ahead(), 3);
}

/// Every block is told as it is after it has run: what it then holds is what it passes power on for.
#[test]
fn blocks_tell_what_they_have_come_to() {
    let text = "VAR_INPUT a : BOOL; END_VAR\n\
                VAR c : CTU; d : CTD; t : TOF; n, i : INT; f : ARRAY[1..3] OF INT; END_VAR\n\
                VAR up, down, late, count, high : BOOL; END_VAR\n\
                +--[ ]( a )--[CTU]( c, 1 )--( )( up )--+\n\
                +--[ ]( a )--[CTD]( d, 1 )--( )( down )--+\n\
                +--[ ]( a )--[TOF]( t, T#20ms )--( )( late )--+\n\
                +--[ ]( a )--[ADD]( n, n, 1 )--[MOV]( i, 0 )--[GE]( n, 1 )--( )( count )--+\n\
                +--[ ]( a )--<FOR>( 3 )--+\n\
                +--[ADD]( i, i, 1 )--[ADD]( f[i], f[i], i )--[GT]( f[i], 2 )--( )( high )--+\n\
                +--<NEXT>--+\n";
    check(
        text,
        "a _-",
        "up down late count high",
        expect![[r#"
        up is 1 since scan 1 (10 ms): line 4, ( )( up ) wrote it; power came through [ ]( a ) (line 4, column 4): a is 1, [CTU]( c, 1 ) (line 4, column 14): c.CV is 1
          a is 1 since scan 1 (10 ms): it was given from outside
          c.CV is 1 since scan 1 (10 ms): line 4, [CTU]( c, 1 ) wrote it; power came through [ ]( a ) (line 4, column 4): a is 1
        down is 1 since scan 0 (0 ms): line 5, ( )( down ) wrote it; power came through [CTD]( d, 1 ) (line 5, column 14): d.CV is 0
          d.CV is 0 since the start: line 5, [CTD]( d, 1 ) wrote it; blocked by [ ]( a ) (line 5, column 4): a is 0
            a is 0 since the start: nothing else was given
        late is 1 since scan 1 (10 ms): line 6, ( )( late ) wrote it; power came through [ ]( a ) (line 6, column 4): a is 1, [TOF]( t, T#20ms ) (line 6, column 14): t.ET is T#0s
          a is 1 since scan 1 (10 ms): it was given from outside
          t.ET is T#0s since the start: line 6, [TOF]( t, T#20ms ) wrote it; power came through [ ]( a ) (line 6, column 4): a is 1
        count is 1 since scan 1 (10 ms): line 7, ( )( count ) wrote it; power came through [ ]( a ) (line 7, column 4): a is 1, [ADD]( n, n, 1 ) (line 7, column 14): n is 1, [MOV]( i, 0 ) (line 7, column 32), [GE]( n, 1 ) (line 7, column 47): n is 1
          a is 1 since scan 1 (10 ms): it was given from outside
          n is 1 since scan 1 (10 ms): line 7, [ADD]( n, n, 1 ) wrote it; power came through [ ]( a ) (line 7, column 4): a is 1
        high is 1 since scan 1 (10 ms): line 9, ( )( high ) wrote it; power came through [ADD]( i, i, 1 ) (line 9, column 4): i is 3, [ADD]( f[i], f[i], i ) (line 9, column 22): f[3] is 3, i is 3, [GT]( f[i], 2 ) (line 9, column 46): f[3] is 3
          i is 3 since scan 1 (10 ms): line 9, [ADD]( i, i, 1 ) wrote it; power came straight from the rail
          f[3] is 3 since scan 1 (10 ms): line 9, [ADD]( f[i], f[i], i ) wrote it (i is 3); power came through [ADD]( i, i, 1 ) (line 9, column 4): i is 3
    "#]],
    );
    check(
        text,
        "a _-__",
        "late",
        expect![[r#"
        late is 1 since scan 1 (10 ms): line 6, ( )( late ) wrote it; power came through [ ]( a ) (line 6, column 4): a is 1, [TOF]( t, T#20ms ) (line 6, column 14): t.ET is T#0s
          a is 1 since scan 1 (10 ms): it was given from outside
          t.ET is T#0s since the start: line 6, [TOF]( t, T#20ms ) wrote it; power came through [ ]( a ) (line 6, column 4): a is 1
    "#]],
    );
}

#[test]
fn constants_are_no_news() {
    let text = "VAR CONSTANT FILL_B : INT := 20; END_VAR\nVAR_INPUT level : INT; END_VAR\nVAR m : INT; END_VAR\n\
                +--[ ]( SYS.ON )--[GE]( level, FILL_B )--[MOV]( m, FILL_B )--( )( full )--+\n";
    check(
        text,
        "level 0 25",
        "full m FILL_B",
        expect![[r#"
        full is 1 since scan 1 (10 ms): line 4, ( )( full ) wrote it; power came through [ ]( SYS.ON ) (line 4, column 4): SYS.ON is 1, [GE]( level, FILL_B ) (line 4, column 19): level is 25, FILL_B is 20, [MOV]( m, FILL_B ) (line 4, column 42): FILL_B is 20
          level is 25 since scan 1 (10 ms): it was given from outside
        m is 20 since scan 1 (10 ms): line 4, [MOV]( m, FILL_B ) wrote it (FILL_B is 20); power came through [ ]( SYS.ON ) (line 4, column 4): SYS.ON is 1, [GE]( level, FILL_B ) (line 4, column 19): level is 25, FILL_B is 20
          level is 25 since scan 1 (10 ms): it was given from outside
        FILL_B is 20 since the start: nothing has written it
    "#]],
    );
}

const LOOP: &str = "\
VAR_INPUT a : ARRAY[1..3] OF BOOL; go : BOOL; END_VAR\n\
VAR q, r : ARRAY[1..3] OF BOOL; k : INT; END_VAR\n\
+--<FOR>( 3, I => k )--+\n\
+--[ ]( a[k] )--( )( q[k] )--+\n\
+--[ ]( go )--( )( r[k] )--+\n\
+--<NEXT>--+\n";

const CALLED_TWICE: &str = "\
VAR_INPUT a, b : BOOL; END_VAR\n\
VAR x : BOOL; p : INT; q : ARRAY[1..2] OF BOOL; END_VAR\n\
+--[MOV]( p, 1 )--[ ]( a )--( )( x )--+\n\
+--<CALL>( part )--+\n\
+--[MOV]( p, 2 )--[ ]( b )--( )( x )--+\n\
+--<CALL>( part )--+\n\
+--<FUN>( part )--+\n\
+--[ ]( x )--( )( q[p] )--+\n\
+--<RET>--+\n";

const MOTORS: &str = "\
FUNCTION_BLOCK [$Motor]\nVAR_INPUT start, stop : BOOL; END_VAR\nVAR_OUTPUT run : BOOL; END_VAR\n\
VAR t : TON; END_VAR\nVAR_IN_OUT count : INT; END_VAR\n\
+--[ ]( start )--[/]( stop )--[TON]( t, T#10ms )--( )( run )--+\n\
+--[ ]( run )--[ADD]( count, count, 1 )--+\n\
END_FUNCTION_BLOCK\n\
VAR_INPUT go : ARRAY[1..2] OF BOOL; halt : BOOL; END_VAR\n\
VAR m1 : $Motor; m : ARRAY[1..2] OF $Motor; n : ARRAY[1..2] OF INT; c, k : INT; y : BOOL; END_VAR\n\
+--[$Motor]( m1, go[2], halt, y, c )--+\n\
+--<FOR>( 2, I => k )--+\n\
+--[$Motor]( m[k], go[k], halt, count := n[k] )--+\n\
+--<NEXT>--+\n";

/// Each element tells of the turn that wrote it, whether it changed then or not, and a coil that has only written low tells so.
#[test]
fn the_turn_of_a_loop() {
    check(
        LOOP,
        "a[1] _-\na[3] __-\ngo _____-",
        "q[1] q[2] q[3] r[2] k",
        expect![[r#"
            q[1] is 1 since scan 1 (10 ms): line 4, ( )( q[k] ) wrote it (k is 1); power came through [ ]( a[k] ) (line 4, column 4): a[1] is 1
              a[1] is 1 since scan 1 (10 ms): it was given from outside
            q[2] is 0 since the start: line 4, ( )( q[k] ) wrote it (k is 2); blocked by [ ]( a[k] ) (line 4, column 4): a[2] is 0
              a[2] is 0 since the start: nothing else was given
            q[3] is 1 since scan 2 (20 ms): line 4, ( )( q[k] ) wrote it (k is 3); power came through [ ]( a[k] ) (line 4, column 4): a[3] is 1
              a[3] is 1 since scan 2 (20 ms): it was given from outside
            r[2] is 1 since scan 5 (50 ms): line 5, ( )( r[k] ) wrote it (k is 2); power came through [ ]( go ) (line 5, column 4): go is 1
              go is 1 since scan 5 (50 ms): it was given from outside
            k is 3 since scan 0 (0 ms): line 3, <FOR>( 3, I => k ) wrote it; power came straight from the rail
        "#]],
    );
}

/// A function that several blocks call, and the bodies of blocks.
#[test]
fn the_run_of_what_is_called_twice() {
    check(
        CALLED_TWICE,
        "a _-\nb ___",
        "q[1] q[2]",
        expect![[r#"
        q[1] is 1 since scan 1 (10 ms): line 8, ( )( q[p] ) wrote it, called by <CALL>( part ) (line 4) (p is 1); power came through [ ]( x ) (line 8, column 4): x is 1
          x is 1 since scan 1 (10 ms): line 3, ( )( x ) wrote it; power came through [MOV]( p, 1 ) (line 3, column 4), [ ]( a ) (line 3, column 19): a is 1
            a is 1 since scan 1 (10 ms): it was given from outside
        q[2] is 0 since the start: line 8, ( )( q[p] ) wrote it, called by <CALL>( part ) (line 6) (p is 2); blocked by [ ]( x ) (line 8, column 4): x is 0
          x is 0 since the start: line 5, ( )( x ) wrote it; blocked by [ ]( b ) (line 5, column 19): b is 0
            b is 0 since the start: nothing else was given
    "#]],
    );
    check(
        MOTORS,
        "go[2] _----\nhalt _____-",
        "m1.run y m[1].run m[2].run m[2].start c n[2] n[1] m1.t.ET",
        expect![[r#"
            m1.run is 0 since scan 5 (50 ms): line 6, ( )( run ) wrote it; blocked by [/]( stop ) (line 6, column 18): m1.stop is 1 and by [TON]( t, T#10ms ) (line 6, column 31): m1.t.ET is T#0s
              m1.stop is 1 since scan 5 (50 ms): line 11, [$Motor]( m1, go[2], halt, y, c ) wrote it (halt is 1); power came straight from the rail
                halt is 1 since scan 5 (50 ms): it was given from outside
              m1.t.ET is T#0s since scan 5 (50 ms): line 6, [TON]( t, T#10ms ) wrote it; blocked by [/]( stop ) (line 6, column 18): m1.stop is 1
            y is 0 since scan 5 (50 ms): line 11, [$Motor]( m1, go[2], halt, y, c ) wrote it (m1.run is 0); power came straight from the rail
              m1.run is 0 since scan 5 (50 ms): line 6, ( )( run ) wrote it; blocked by [/]( stop ) (line 6, column 18): m1.stop is 1 and by [TON]( t, T#10ms ) (line 6, column 31): m1.t.ET is T#0s
                m1.stop is 1 since scan 5 (50 ms): line 11, [$Motor]( m1, go[2], halt, y, c ) wrote it (halt is 1); power came straight from the rail
                  halt is 1 since scan 5 (50 ms): it was given from outside
                m1.t.ET is T#0s since scan 5 (50 ms): line 6, [TON]( t, T#10ms ) wrote it; blocked by [/]( stop ) (line 6, column 18): m1.stop is 1
            m[1].run is 0 since the start: line 6, ( )( run ) wrote it; blocked by [ ]( start ) (line 6, column 4): m[1].start is 0 and by [/]( stop ) (line 6, column 18): m[1].stop is 1 and by [TON]( t, T#10ms ) (line 6, column 31): m[1].t.ET is T#0s
              m[1].start is 0 since the start: line 13, [$Motor]( m[k], go[k], halt, count := n[k] ) wrote it (go[1] is 0); power came straight from the rail
                go[1] is 0 since the start: nothing else was given
              m[1].stop is 1 since scan 5 (50 ms): line 13, [$Motor]( m[k], go[k], halt, count := n[k] ) wrote it (halt is 1); power came straight from the rail
                halt is 1 since scan 5 (50 ms): it was given from outside
              m[1].t.ET is T#0s since the start: line 6, [TON]( t, T#10ms ) wrote it; blocked by [ ]( start ) (line 6, column 4): m[1].start is 0 and by [/]( stop ) (line 6, column 18): m[1].stop is 1
            m[2].run is 0 since scan 5 (50 ms): line 6, ( )( run ) wrote it; blocked by [/]( stop ) (line 6, column 18): m[2].stop is 1 and by [TON]( t, T#10ms ) (line 6, column 31): m[2].t.ET is T#0s
              m[2].stop is 1 since scan 5 (50 ms): line 13, [$Motor]( m[k], go[k], halt, count := n[k] ) wrote it (halt is 1); power came straight from the rail
                halt is 1 since scan 5 (50 ms): it was given from outside
              m[2].t.ET is T#0s since scan 5 (50 ms): line 6, [TON]( t, T#10ms ) wrote it; blocked by [/]( stop ) (line 6, column 18): m[2].stop is 1
            m[2].start is 1 since scan 1 (10 ms): line 13, [$Motor]( m[k], go[k], halt, count := n[k] ) wrote it (go[2] is 1); power came straight from the rail
              go[2] is 1 since scan 1 (10 ms): it was given from outside
            c is 3 since scan 4 (40 ms): line 7, [ADD]( count, count, 1 ) wrote it; power came through [ ]( run ) (line 7, column 4): m1.run is 1
              m1.run is 1 since scan 2 (20 ms): line 6, ( )( run ) wrote it; power came through [ ]( start ) (line 6, column 4): m1.start is 1, [/]( stop ) (line 6, column 18): m1.stop is 0, [TON]( t, T#10ms ) (line 6, column 31): m1.t.ET is T#10ms
                m1.start is 1 since scan 1 (10 ms): line 11, [$Motor]( m1, go[2], halt, y, c ) wrote it (go[2] is 1); power came straight from the rail
                  go[2] is 1 since scan 1 (10 ms): it was given from outside
                m1.stop is 0 since the start: line 11, [$Motor]( m1, go[2], halt, y, c ) wrote it (halt is 0); power came straight from the rail
                  halt is 0 since the start: nothing else was given
                m1.t.ET is T#10ms since scan 2 (20 ms): line 6, [TON]( t, T#10ms ) wrote it; power came through [ ]( start ) (line 6, column 4): m1.start is 1, [/]( stop ) (line 6, column 18): m1.stop is 0
            n[2] is 3 since scan 4 (40 ms): line 7, [ADD]( count, count, 1 ) wrote it; power came through [ ]( run ) (line 7, column 4): m[2].run is 1
              m[2].run is 1 since scan 2 (20 ms): line 6, ( )( run ) wrote it; power came through [ ]( start ) (line 6, column 4): m[2].start is 1, [/]( stop ) (line 6, column 18): m[2].stop is 0, [TON]( t, T#10ms ) (line 6, column 31): m[2].t.ET is T#10ms
                m[2].start is 1 since scan 1 (10 ms): line 13, [$Motor]( m[k], go[k], halt, count := n[k] ) wrote it (go[2] is 1); power came straight from the rail
                  go[2] is 1 since scan 1 (10 ms): it was given from outside
                m[2].stop is 0 since the start: line 13, [$Motor]( m[k], go[k], halt, count := n[k] ) wrote it (halt is 0); power came straight from the rail
                  halt is 0 since the start: nothing else was given
                m[2].t.ET is T#10ms since scan 2 (20 ms): line 6, [TON]( t, T#10ms ) wrote it; power came through [ ]( start ) (line 6, column 4): m[2].start is 1, [/]( stop ) (line 6, column 18): m[2].stop is 0
            n[1] is 0 since the start: nothing has written it
            m1.t.ET is T#0s since scan 5 (50 ms): line 6, [TON]( t, T#10ms ) wrote it; blocked by [/]( stop ) (line 6, column 18): m1.stop is 1
              m1.stop is 1 since scan 5 (50 ms): line 11, [$Motor]( m1, go[2], halt, y, c ) wrote it (halt is 1); power came straight from the rail
                halt is 1 since scan 5 (50 ms): it was given from outside
        "#]],
    );
}

/// What a table of values says of them.
#[track_caller]
fn check_moment(text: &str, values: &str, tags: &str, expected: Expect) {
    let simulation = simulation(text);
    let given = values.split_whitespace().map(|given| {
        let (tag, value) = given.split_once('=').unwrap();
        let point = simulation.resolve(tag).unwrap();
        let value = parse(value, point.ty).unwrap();
        (point, value)
    });
    let given = given.collect();
    let mut moment = Moment::new(simulation, given).unwrap();
    let mut shown = String::new();
    for tag in tags.split_whitespace() {
        let point = moment.simulation().resolve(tag).unwrap();
        let judged = moment.why(&point);
        shown.push_str(&Wording::new(&[text], &[]).judged(&judged));
        shown.push('\n');
    }
    expected.assert_eq(&shown);
}

#[test]
fn of_one_moment_it_is_the_turn_that_writes_the_tag() {
    check_moment(
        LOOP,
        "a[1]=1 a[2]=0 a[3]=0 go=0 q[1]=1 q[2]=0 q[3]=0 r[1]=0 k=3",
        "q[1] q[3] r[1] k",
        expect![[r#"
            q[1] is 1: line 4, ( )( q[k] ) writes 1 (k is 1); power came through [ ]( a[k] ) (line 4, column 4): a[1] is 1
            q[3] is 0: line 4, ( )( q[k] ) writes 0 (k is 3); blocked by [ ]( a[k] ) (line 4, column 4): a[3] is 0
            r[1] is 0: line 5, ( )( r[k] ) writes 0 (k is 1); blocked by [ ]( go ) (line 5, column 4): go is 0
            k is 3: line 3, <FOR>( 3, I => k ) writes 3; power came straight from the rail
        "#]],
    );
    check_moment(
        CALLED_TWICE,
        "a=1 b=0 x=0 p=2 q[1]=1 q[2]=0",
        "q[1] q[2]",
        expect![[r#"
            q[1] is 1: line 8, ( )( q[p] ) writes 1, called by <CALL>( part ) (line 4) (p is 1); power came through [ ]( x ) (line 8, column 4): x is 1
            q[2] is 0: line 8, ( )( q[p] ) writes 0, called by <CALL>( part ) (line 6) (p is 2); blocked by [ ]( x ) (line 8, column 4): x is 0
        "#]],
    );
    check_moment(
        MOTORS,
        "go[1]=1 go[2]=0 halt=0 m1.run=0 m[1].run=1 m[1].t.ET=T#10ms m[1].t.Q=1 m[2].run=0 k=2 y=0",
        "m1.run m[1].run m[2].run m[2].start y",
        expect![[r#"
            m1.run is 0, as far as the table goes: line 6, ( )( run ) writes 0; blocked by [ ]( start ) (line 6, column 4): m1.start is 0 and by [TON]( t, T#10ms ) (line 6, column 31): m1.t.ET is T#0s
            m[1].run is 1: line 6, ( )( run ) writes 1; power came through [ ]( start ) (line 6, column 4): m[1].start is 1, [/]( stop ) (line 6, column 18): m[1].stop is 0, [TON]( t, T#10ms ) (line 6, column 31): m[1].t.ET is T#10ms
            m[2].run is 0, as far as the table goes: line 6, ( )( run ) writes 0; blocked by [ ]( start ) (line 6, column 4): m[2].start is 0 and by [TON]( t, T#10ms ) (line 6, column 31): m[2].t.ET is T#0s
            m[2].start is 0, though not in the table: line 13, [$Motor]( m[k], go[k], halt, count := n[k] ) writes 0; power came straight from the rail
            y is 0: line 11, [$Motor]( m1, go[2], halt, y, c ) writes 0; power came straight from the rail
        "#]],
    );
}

#[test]
fn a_bit_has_the_value_that_the_table_has_for_its_number() {
    let text = "VAR_INPUT n : INT; END_VAR\nVAR_OUTPUT y : BOOL; END_VAR\n+--[ ]( n.1 )--( )( y )--+\n";
    check_moment(
        text,
        "n=2 y=1",
        "y",
        expect![[r#"
        y is 1: line 3, ( )( y ) writes 1; power came through [ ]( n.1 ) (line 3, column 4): n.1 is 1
    "#]],
    );
    check_moment(
        text,
        "n=1 y=1",
        "y",
        expect![[r#"
        y is 1, against the program: line 3, ( )( y ) writes 0; blocked by [ ]( n.1 ) (line 3, column 4): n.1 is 0
    "#]],
    );
    check_moment(
        text,
        "n.0=1 y=1",
        "y",
        expect![[r#"
        y is 1, as far as the table goes: line 3, ( )( y ) writes 0; blocked by [ ]( n.1 ) (line 3, column 4): n.1 is 0
    "#]],
    );
}

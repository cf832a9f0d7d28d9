//! Running, pausing, stepping, restarting, faults, and another version of the file.

use super::{Bench, MOTOR, press};
use crate::screen::app::Next;
use expect_test::expect;
use ratatui::crossterm::event::{KeyCode, KeyModifiers};

#[test]
fn the_clock_follows_the_speed() {
    let bench = Bench::new(MOTOR);
    bench.check_lines(
        "p +1000ms",
        0..1,
        expect![[r#"
            | motor.clad  ▶ RUNNING 1x                                      scan 100  1.00 s
        "#]],
    );
    bench.check_lines(
        "p +1000ms p +1000ms",
        0..1,
        expect![[r#"
            | motor.clad  ■ PAUSED  speed 1x                                scan 100  1.00 s
        "#]],
    );
    bench.check_lines(
        "+ + p +1000ms",
        0..1,
        expect![[r#"
            | motor.clad  ▶ RUNNING 5x                                      scan 500  5.00 s
        "#]],
    );
    bench.check_lines(
        "- - - p +1000ms",
        0..1,
        expect![[r#"
            | motor.clad  ▶ RUNNING 0.1x                                     scan 10  0.10 s
        "#]],
    );
}

#[test]
fn steps_and_back() {
    let bench = Bench::new(MOTOR);
    bench.check_lines(
        "space s space s s",
        0..6,
        expect![[r#"
            | motor.clad  ■ PAUSED  speed 1x                                  scan 3  0.03 s
            |   VAR_INPUT  start, stop : BOOL;  END_VAR
            |   VAR  warmup : TON;  END_VAR
            |
            |   # Seal-in #
            | > +══\══[ ]( start )──\══[/]( stop )═════════════( )(●run )══+
        "#]],
    );
    bench.check_lines(
        "space s space s s b b b",
        0..6,
        expect![[r#"
            | motor.clad  ■ PAUSED  speed 1x                          3 back  scan 0  0.00 s
            |   VAR_INPUT  start, stop : BOOL;  END_VAR
            |   VAR  warmup : TON;  END_VAR
            |
            |   # Seal-in #
            | > +──\──[ ]( start )──\──[/]( stop )─────────────( )( run )──+
        "#]],
    );
    bench.check_info(
        "b",
        expect![[r#"
            | this is the beginning
        "#]],
    );
    // Forward again, and then on.
    bench.check_lines(
        "space s space s s b b s s s",
        0..1,
        expect![[r#"
            | motor.clad  ■ PAUSED  speed 1x                                  scan 4  0.04 s
        "#]],
    );
}

#[test]
fn a_restart_leaves_the_switches_as_they_are() {
    let bench = Bench::new(MOTOR);
    bench.check_lines(
        "space s space s s c",
        0..6,
        expect![[r#"
            | motor.clad  ■ PAUSED  speed 1x                                  scan 0  0.00 s
            |   VAR_INPUT  start, stop : BOOL;  END_VAR
            |   VAR  warmup : TON;  END_VAR
            |
            |   # Seal-in #
            | > +──\──[ ]( start )──\──[/]( stop )─────────────( )( run )──+
        "#]],
    );
    bench.check_lines(
        "space s s s c s",
        0..6,
        expect![[r#"
            | motor.clad  ■ PAUSED  speed 1x                                  scan 1  0.01 s
            |   VAR_INPUT  start, stop : BOOL;  END_VAR
            |   VAR  warmup : TON;  END_VAR
            |
            |   # Seal-in #
            | > +══\══[ ](●start )══\══[/]( stop )═════════════( )(●run )══+
        "#]],
    );
    let retentive = "+--[ ]( go )--( M )( kept )--( )( lost )--+\n";
    let retentive = retentive.replace("( M )", "(M)");
    Bench::new(&retentive).check_lines(
        "space s space C",
        0..2,
        expect![[r#"
            | motor.clad  ■ PAUSED  speed 1x                                  scan 0  0.00 s
            | > +──[ ]( go )──(M)(●kept )──( )( lost )──+
        "#]],
    );
}

#[test]
fn the_end() {
    let bench = Bench::new("+--[ ]( stop )--<END>--+\n").size(80, 10);
    bench.check(
        "p space +500ms",
        expect![[r#"
            | motor.clad  ■ ENDED                                             scan 1  0.01 s
            | > +══[ ](●stop )══<END>──+
            |
            |
            |
            |
            |─ Inputs: press the number ─────────────────────────────────────────────────────
            | 1 ● stop
            | Open contact: input stop is TRUE; space switches it
            | space switch p run s step b back +- speed f force w watch ? help q quit
        "#]],
    );
    bench.check_info(
        "p space +500ms p",
        expect![[r#"
            | the program has ended: c starts it again
        "#]],
    );
    bench.check_info(
        "p space +500ms s",
        expect![[r#"
            | the program has ended: b goes back, c starts it again
        "#]],
    );
    bench.check_lines(
        "p space +500ms b",
        0..1,
        expect![[r#"
            | motor.clad  ■ PAUSED  speed 1x                          1 back  scan 0  0.00 s
        "#]],
    );
}

#[test]
fn faults_are_seen() {
    let text = "\
VAR_INPUT  parts : INT;  END_VAR
+--( )( a )--+
+--[DIV]( share, 12, parts )--( )( ok )--+
";
    let bench = Bench::new(text).size(90, 14);
    bench.check(
        "s s s",
        expect![[r#"
            | motor.clad  ■ PAUSED  speed 1x                                            scan 3  0.03 s
            |   VAR_INPUT  parts : INT;  END_VAR
            | > +══( )(●a )══+
            |!  +══[DIV]( share, 12, parts )──( )( ok )──+  share=0  parts=0
            |
            |
            |─ Inputs: press the number ───────────────────────────────────────────────────────────────
            | 1 parts=0
            |─ Watch ────────────────────────────────────────────────────────── [ ] 1 column = 100 ms ─
            | a   TRUE                                                                                ⠁
            | ok  FALSE                                                                               ⡀
            | ! motor.clad:3:4: scan 2 (3 times): division by zero: nothing was written; check the
            | Coil: output a is TRUE
            | space switch   p run   s step   b back   +- speed   f force   w watch   ? help   q quit
        "#]],
    );
    bench.check_info(
        "s tab !",
        expect![[r#"
            | Divide: share=0, parts=0
        "#]],
    );
    bench.check_lines(
        "s b",
        11..13,
        expect![[r#"
            | ok  FALSE
            | Coil: output a is FALSE
        "#]],
    );
    let endless = Bench::new("+--<LBL>( again )--+\n+--[ ]( go )--<JMP>( again )--+\n").size(90, 12);
    endless.check_lines(
        "p +100ms space +100ms",
        0..1,
        expect![[r#"
            | motor.clad  ! STOPPED BY A FAULT                                         scan 10  0.10 s
        "#]],
    );
}

#[test]
fn another_version_of_the_file() {
    let other = MOTOR.replace("( ready )", "( warm )").replace("T#5s", "T#9s");
    let same = MOTOR.replace("Seal-in", "Hold");
    let lost = MOTOR.replace("TON", "TOF");
    let texts = [
        ("other", other.as_str()),
        ("same", same.as_str()),
        ("lost", lost.as_str()),
        ("broken", "+--[ ]( a --+\n"),
    ];
    let bench = Bench::new(MOTOR).size(150, 24);
    let lines = |steps: &str, lines: std::ops::Range<usize>| {
        bench.play_with(steps, &texts, |_, buffer| {
            let all = super::characters(buffer);
            let some: Vec<&str> = all.lines().skip(lines.start).take(lines.len()).collect();
            some.join("\n") + "\n"
        })
    };
    let info = |steps: &str| lines(steps, 22..23).replace(bench.folder.path().to_str().unwrap(), "");
    expect![[r#"
        | Open contact: input start is FALSE; space switches it
    "#]]
    .assert_eq(&info("look"));
    expect![[r#"
        | motor.clad has changed on disk: r loads it again
    "#]]
    .assert_eq(&info("space s write:other look"));
    expect![[r#"
        | /motor.clad was loaded again: the program goes on with all that it held
    "#]]
    .assert_eq(&info("space s write:other look r"));
    expect![[r#"
        | motor.clad  ■ PAUSED  speed 1x                                                                                               1 FORCE  scan 2  0.02 s
        |1   VAR_INPUT  start, stop : BOOL;  END_VAR
        |2   VAR  warmup : TON;  END_VAR
        |3
        |4   # Seal-in #
        |5 > +══\══[ ](●start )══\══[/]( stopF)═════════════( )(●run )══+
        |6   |  /══[ ](●run )════/                                      |
        |7
        |8   # Warm-up #
        |9   +══[ ](●run )═════════[TON]( warmup, T#9s )──( )( warm )──+  warmup 10ms/9s
    "#]]
    .assert_eq(&lines("space tab f 0 s write:other look r s", 0..10));
    // The rest of what it was doing goes on, and stepping back leads to the program that ran before.
    expect![[r#"
        | motor.clad  ■ PAUSED  speed 1x                                                                                                        scan 4  0.04 s
        |1   VAR_INPUT  start, stop : BOOL;  END_VAR
        |2   VAR  warmup : TON;  END_VAR
        |3
        |4   # Seal-in #
        |5 > +══\══[ ](●start )══\══[/]( stop )═════════════( )(●run )══+
        |6   |  /══[ ](●run )════/                                      |
        |7
        |8   # Warm-up #
        |9   +══[ ](●run )═════════[TON]( warmup, T#9s )──( )( warm )──+  warmup 30ms/9s
    "#]].assert_eq(&lines("space s s s write:other look r s", 0..10));
    expect![[r#"
        | motor.clad  ■ PAUSED  speed 1x                                                                                                2 back  scan 2  0.02 s
        |1   VAR_INPUT  start, stop : BOOL;  END_VAR
        |2   VAR  warmup : TON;  END_VAR
        |3
        |4   # Seal-in #
        |5 > +══\══[ ](●start )══\══[/]( stop )═════════════( )(●run )══+
        |6   |  /══[ ](●run )════/                                      |
        |7
        |8   # Warm-up #
        |9   +══[ ](●run )═════════[TON]( warmup, T#5s )──( )( ready )──+  warmup 10ms/5s
    "#]].assert_eq(&lines("space s s s write:other look r s b b", 0..10));
    expect![[r#"
        | /motor.clad was loaded again: the program does what it did
    "#]]
    .assert_eq(&info("space s write:same look r"));
    expect![[r#"
        | /motor.clad was loaded again: warmup was a TON and is a TOF now: it begins with its initial value
    "#]]
    .assert_eq(&info("space s write:lost look r"));
    expect![[r#"
        | /motor.clad:1:7: `( a` is not closed: `)` is missing; the old program goes on
    "#]]
    .assert_eq(&info("space s write:broken look r"));
    expect![[r#"
        |5 > +══\══[ ](●start )══\══[/]( stop )═════════════( )(●run )══+
        |6   |  /══[ ](●run )════/                                      |
    "#]]
    .assert_eq(&lines("space s write:broken look r s", 5..7));
}

#[test]
fn what_ends_it() {
    let bench = Bench::new(MOTOR);
    bench.play("", |app, _| {
        assert_eq!(press(app, KeyCode::Char('q'), KeyModifiers::NONE), Next::Quit);
        assert_eq!(press(app, KeyCode::Char('c'), KeyModifiers::CONTROL), Next::Quit);
        String::new()
    });
    bench.play("w 'q'", |app, _| {
        assert_eq!(press(app, KeyCode::Char('q'), KeyModifiers::NONE), Next::Go);
        assert_eq!(press(app, KeyCode::Char('c'), KeyModifiers::CONTROL), Next::Quit);
        String::new()
    });
    bench.play("?", |app, _| {
        assert_eq!(press(app, KeyCode::Char('q'), KeyModifiers::NONE), Next::Quit);
        String::new()
    });
}

#[test]
fn parts_of_a_scan() {
    let bench = Bench::new(MOTOR);
    bench.check_lines(
        "space . . . .",
        0..10,
        expect![[r#"
        | motor.clad  ■ IN SCAN 0  speed 1x                               scan 0  0.00 s
        |   VAR_INPUT  start, stop : BOOL;  END_VAR
        |   VAR  warmup : TON;  END_VAR
        |
        |   # Seal-in #
        | ▶ +══\══[ ](●start )══\══[/]( stop )═════════════( )( run )──+
        |   |  /══[ ]( run )────/                                      |
        |
        |   # Warm-up #
        |   +──[ ]( run )─────────[TON]( warmup, T#5s )──( )( ready )──+  warmup 0s/0s
    "#]],
    );
    bench.check_lines(
        "space , ,",
        0..10,
        expect![[r#"
        | motor.clad  ■ IN SCAN 0  speed 1x                               scan 0  0.00 s
        |   VAR_INPUT  start, stop : BOOL;  END_VAR
        |   VAR  warmup : TON;  END_VAR
        |
        |   # Seal-in #
        |   +══\══[ ](●start )══\══[/]( stop )═════════════( )(●run )══+
        |   |  /══[ ](●run )────/                                      |
        |
        |   # Warm-up #
        | ▶ +══[ ](●run )─────────[TON]( warmup, T#5s )──( )( ready )──+  warmup 0s/0s
    "#]],
    );
    bench.check_info(
        "space , , ,",
        expect![[r#"
        | the scan is over
    "#]],
    );
    bench.check_lines(
        "space . . s",
        0..1,
        expect![[r#"
        | motor.clad  ■ PAUSED  speed 1x                                  scan 1  0.01 s
    "#]],
    );
    bench.check_lines(
        "space s . . b",
        0..1,
        expect![[r#"
        | motor.clad  ■ PAUSED  speed 1x                                  scan 1  0.01 s
    "#]],
    );
    bench.check_lines(
        "space s . . b b",
        0..1,
        expect![[r#"
        | motor.clad  ■ PAUSED  speed 1x                          1 back  scan 0  0.00 s
    "#]],
    );
}

#[test]
fn breakpoints() {
    let bench = Bench::new(MOTOR);
    let to_warmup = "G B";
    bench.check_info(
        to_warmup,
        expect![[r#"
        | the program stops at the rung in line 9
    "#]],
    );
    bench.check(
        &format!("{to_warmup} 1 p +100ms"),
        expect![[r#"
        | motor.clad  ■ IN SCAN 0  speed 1x                               scan 0  0.00 s
        |   VAR_INPUT  start, stop : BOOL;  END_VAR
        |   VAR  warmup : TON;  END_VAR
        |
        |   # Seal-in #
        |   +══\══[ ](●start )══\══[/]( stop )═════════════( )(●run )══+
        |   |  /══[ ](●run )────/                                      |
        |
        |   # Warm-up #
        |◆▶ +══[ ](●run )─────────[TON]( warmup, T#5s )──( )( ready )──+  warmup 0s/0s
        |
        |
        |
        |
        |
        |
        |─ Inputs: press the number ─────────────────────────────────────────────────────
        | 1 ● start   2 ○ stop
        |─ Watch ──────────────────────────────────────────────── [ ] 1 column = 100 ms ─
        | ready      FALSE
        | warmup.ET  0s
        | run        TRUE
        | stopped before this rung: . , s step on, p runs on, B takes the stop away
        | space switch p run s step b back +- speed f force w watch ? help q quit
    "#]],
    );
    bench.check_info(
        &format!("{to_warmup} 1 p +100ms p +100ms"),
        expect![[r#"
        | stopped before this rung: . , s step on, p runs on, B takes the stop away
    "#]],
    );
    bench.check_lines(
        &format!("{to_warmup} 1 p +100ms B p +100ms"),
        0..1,
        expect![[r#"
        | motor.clad  ▶ RUNNING 1x                                       scan 10  0.10 s
    "#]],
    );
    let at_change = "down t g";
    bench.check_info(
        "down t",
        expect![[r#"
        | the program stops when run changes
    "#]],
    );
    bench.check_lines(
        &format!("{at_change} p +100ms 1 +100ms"),
        0..1,
        expect![[r#"
        | motor.clad  ■ IN SCAN 10  speed 1x                             scan 10  0.10 s
    "#]],
    );
    bench.check_info(
        &format!("{at_change} p +100ms 1 +100ms"),
        expect![[r#"
        | stopped: here run has changed from FALSE to TRUE
    "#]],
    );
}

#[test]
fn why() {
    let bench = Bench::new(MOTOR);
    bench.check(
        "space s space s down y",
        expect![[r#"
        | motor.clad  ■ PAUSED  speed 1x                                  scan 2  0.02 s
        |   VAR_INPUT  start, stop : BOOL;  END_VAR
        |   VAR  warmup : TON;  END_VAR
        |
        |   # Seal-in #
        |   +══\══[ ]( start )──\══[/]( stop )═════════════( )(●run )══+
        | > |  /══[ ](●run )════/                                      |
        |
        |┌ Why? Any key closes it ──────────────────────────────────────────────────────┐
        |│ run is 1 since scan 0 (0 ms): line 5, ( )( run ) wrote it; power came        │
        |│     through [ ]( start ) (line 5, column 7): start is 1, [/]( stop ) (line   │
        |│     5, column 24): stop is 0                                                 │
        |│   start is 1 since scan 0 (0 ms): it was given from outside                  │
        |│   stop is 0 since the start: nothing else was given                          │
        |└──────────────────────────────────────────────────────────────────────────────┘
        |
        |─ Inputs: press the number ─────────────────────────────────────────────────────
        | 1 ○ start   2 ○ stop
        |─ Watch ──────────────────────────────────────────────── [ ] 1 column = 100 ms ─
        | ready      FALSE                                                              ⡀
        | warmup.ET  10ms                                                               █
        | run        TRUE                                                               ⠁
        | Open contact: run is TRUE
        | space switch p run s step b back +- speed f force w watch ? help q quit
    "#]],
    );
    bench.check_lines(
        "space s space s down y x",
        8..12,
        expect![[r#"
        |   # Warm-up #
        |   +══[ ](●run )═════════[TON]( warmup, T#5s )──( )( ready )──+  warmup 10ms/5s
        |
        |
    "#]],
    );
    bench.check(
        "2 s s size:40x10 down y down down",
        expect![[r#"
        |┌ Why? up, down; any other key closes i┐
        |│     ]( start ) (line 5, column 7):   │
        |│     start is 0 and by [/]( stop )    │
        |│     (line 5, column 24): stop is 1;  │
        |│     or else by [/]( stop ) (line 5,  │
        |│     column 24): stop is 1 and by [   │
        |│     ]( run ) (line 6, column 7): run │
        |│     is 0                             │
        |│   start is 0 since the start:        │
        |└──────────────────────────────────────┘
    "#]],
    );
}

/// What was done is written as a test, which passes; a file that is there is left alone.
#[test]
fn a_session_becomes_a_test() {
    let line = |buffer: &ratatui::buffer::Buffer, line: usize| {
        let all = super::characters(buffer);
        all.lines().nth(line).unwrap_or_default().to_owned()
    };
    let bench = Bench::new(MOTOR);
    let keys = "s space s s space s s tab space s";
    let message = bench.play(&format!("{keys} R enter R enter"), |_, buffer| line(buffer, 22));
    expect!["| motor-recorded-2.ladder-test was written and passes"].assert_eq(&message);
    let read = |name: &str| std::fs::read_to_string(bench.folder.path().join(name)).unwrap();
    expect![[r#"
        program motor.clad
        step 10ms
        interval 10ms

        scenario "recorded"
        start    _--___
        stop     _____-
        ready => ______
        run   => _----_
    "#]]
    .assert_eq(&read("motor-recorded.ladder-test"));
    assert_eq!(
        read("motor-recorded.ladder-test"),
        read("motor-recorded-2.ladder-test")
    );
    // One output less, and a timer's value more.
    bench.play(&format!("{keys} R space down down down space enter"), |_, _| {
        String::new()
    });
    expect![[r#"
        program motor.clad
        step 10ms
        interval 10ms

        scenario "recorded"
        start        _  -  -    _    _    _
        stop         _  _  _    _    _    -
        run       => _  -  -    -    -    _
        warmup.ET => 0s 0s 10ms 20ms 30ms 0s
    "#]]
    .assert_eq(&read("motor-recorded-3.ladder-test"));
    let message = Bench::new(MOTOR).play("R", |_, buffer| line(buffer, 22));
    expect!["| nothing has run yet: run some scans, and record then"].assert_eq(&message);
    let message = bench.play(&format!("{keys} R a a enter"), |_, buffer| line(buffer, 22));
    expect!["| no tag is chosen, and a scenario expects something: choose one at least"].assert_eq(&message);
}

/// The outputs of a recorded test are chosen from a list.
#[test]
fn what_a_test_expects_is_chosen_from_a_list() {
    let bench = Bench::new(MOTOR);
    bench.check(
        "s space s s size:60x14 R down space",
        expect![[r#"
        | motor.clad  ■ PAUSED  speed 1x              scan 3  0.03 s
        |   VAR  warmup : TON;  END_VAR
        |
        |   # Seal-in #
        | > +══\══[ ](●start )══\══[/]( stop )══════════( )(●run )══+
        |   |  /══[ ](●run )════/                                   |
        |┌ The test expects values of ────────────────┐
        |│ [x] ready             BOOL    output       │──────────────
        |│ [ ] run               BOOL                 │
        |│ [ ] warmup.Q          BOOL                 │umn = 100 ms ─
        |│ [ ] warmup.ET         TIME                 │             ⡀
        |└────────────────────────────────────────────┘             █
        | record: space on or off   a all   Enter write   Esc leave i
        | space switch p run s step b back +- speed f force w watch ?
    "#]],
    );
}

//! Scenarios as texts, with what is reported about them.

mod errors;

use super::{Ran, Watched, bind, draw, parse, run};
use crate::simulation::{Options, Simulation};
use expect_test::{Expect, expect};
use ladder_syntax::LineIndex;
use std::sync::Arc;

const MOTOR: &str = "\
VAR_INPUT start, stop : BOOL; END_VAR
VAR_OUTPUT run, ready : BOOL; END_VAR
VAR warmup : TON; starts : DINT; hours : LREAL; text : STRING; list : ARRAY[1..3] OF INT; END_VAR
VAR CONSTANT limit : INT := 80; END_VAR
+--\\--[ ]( start )--\\--[/]( stop )--( )( run )--+
|  /--[ ]( run )----/
+--[ ]( run )--[TON]( warmup, T#50ms )--( )( ready )--+
+--[ ]( run )--[OSR]--[ADD]( starts, starts, 1 )--[ADD]( list[2], list[2], 2 )--+
+--[ ]( run )--[ADD]( hours, hours, 0.1 )--[MOV]( text, 'it runs' )--+
";

fn simulation(program: &str, interval: Option<i64>) -> Simulation {
    let parse = Arc::new(ladder_syntax::parse(program));
    let analysis = ladder_analysis::analyze(&parse, "motor.clad");
    let program = analysis
        .program()
        .cloned()
        .unwrap_or_else(|| panic!("{:?}", analysis.diagnostics()));
    let options = Options {
        interval: interval.unwrap_or(Options::default().interval),
        ..Options::default()
    };
    Simulation::new(program, options).expect("it compiles")
}

/// The errors of a text, or what comes of its scenarios.
fn report(program: &str, text: &str, width: usize) -> String {
    let suite = parse(text);
    let mut simulation = simulation(program, suite.interval.map(|interval| interval.0));
    let (cases, errors) = bind(&suite, &simulation);
    let mut out = String::new();
    let lines = LineIndex::new(text);
    for error in suite.errors.iter().chain(&errors) {
        let (from, to) = (
            lines.line_column(text, error.range.start()),
            lines.line_column(text, error.range.end()),
        );
        out.push_str(&format!(
            "{}:{}-{}: {}\n",
            from.line, from.column, to.column, error.message
        ));
        if let Some(help) = &error.help {
            out.push_str(&format!("    {help}\n"));
        }
    }
    if !out.is_empty() {
        return out;
    }
    for case in &cases {
        let ran: Ran = run(case, &mut Watched::default(), &mut simulation, Simulation::scan);
        let word = if ran.passed() { "ok" } else { "FAILED" };
        out.push_str(&format!("{word} {}, {} scans\n", case.name, ran.scans));
        for line in draw(case, &ran, simulation.options().interval, width) {
            if !ran.passed() {
                out.push_str(&format!("{}\n", line.text));
            }
        }
        if let Some(step) = ran.stopped {
            out.push_str(&format!("stopped in step {step}\n"));
        }
        for fault in &ran.faults {
            out.push_str(&format!("fault in scan {}: {}\n", fault.scan, fault.message));
        }
    }
    out
}

fn check(text: &str, expected: Expect) {
    expected.assert_eq(&report(MOTOR, text, 80));
}

#[test]
fn the_example_of_the_language() {
    check(
        "\
program motor.clad
step 100ms

scenario \"the seal-in holds after start is let go\"
start   _-_______
stop    ______-__
run  => _-----___
starts => 0 1 1 1 1 1 1 1 1
",
        expect![[r#"
            ok the seal-in holds after start is let go, 90 scans
        "#]],
    );
}

#[test]
fn steps_are_as_long_as_their_times() {
    check(
        "\
program motor.clad
step 20ms
scenario \"a wait is one column\"
time     . 1s .
start    - _  _
stop     _ _  -
run   => - -  _
warmup.ET => 10ms 50ms .

time     3s . 70ms
start    _  - .
stop     _  _ .
run   => _  - -
ready => _  _ -
starts => 1 2 2
",
        expect![[r#"
            ok a wait is one column, 413 scans
        "#]],
    );
    check(
        "\
program motor.clad
step 10ms
scenario \"what differs\"
time     .  1s .
start    -  _  _
stop     _  _  -
run   => -  _  -
time     3s . 70ms
stop     _  _ .
run   => _  - _
starts => 1 2 2
",
        expect![[r#"
            FAILED what differs, 410 scans
            time             . 1s . 3s . 70ms
            start            --_____.  . .
            stop             _____--_____.
            run    expected  --___--___--____
                   got       -----___________
                               ^^ ^    ^
            run is TRUE in step 1 (at 1s), FALSE was expected; 3 of 6 steps differ
            time              . 1s . 3s . 70ms
            start             --_____.  . .
            stop              _____--_____.
            starts  expected  . .  . 1  2 2
                    got       1 1  1 1  1 1
                                        ^ ^^^^
            starts is 1 in step 4 (at 4s20ms), 2 was expected; 2 of 6 steps differ
        "#]],
    );
}

#[test]
fn what_differs_is_drawn_twice_and_marked() {
    check(
        "\
program motor.clad
scenario \"levels\"
start   _-_______
stop    ______-__
run  => _---_._--
starts => 0 1 1 1 1 1 1 1 1
scenario \"numbers\"
start       _    -    _    .    _    -
starts =>   0    1    2    .    100  1
warmup.ET => 0ms 0ms  10ms .    T#25ms 40
text =>    ''    'it runs' . . . 'it ran'
",
        expect![[r#"
            FAILED levels, 9 scans
            start            _-_______
            stop             ______-__
            run    expected  _---_._--
                   got       _-----___
                                 ^  ^^
            run is TRUE in step 4 (at 40ms), FALSE was expected; 3 of 9 steps differ
            FAILED numbers, 6 scans
            start                ___----------__________.         __________---------
            starts     expected  0  1         2         .         100       1
                       got       0  1         1         1         1         1
                                              ^^^^^^^^^           ^^^^^^^^^
            starts is 1 in step 2 (at 20ms), 2 was expected; 2 of 6 steps differ
            warmup.ET  expected  0s 0s        10ms      .         25ms      40ms
                       got       0s 0s        10ms      20ms      30ms      40ms
                                                                  ^^^^^^^^^
            warmup.ET is T#30ms in step 4 (at 40ms), T#25ms was expected
            text       expected  '' 'it runs' .         .         .         'it ran'
                       got       '' 'it runs' 'it runs' 'it runs' 'it runs' 'it runs'
                                                                            ^^^^^^^^^
            text is 'it runs' in step 5 (at 50ms), 'it ran' was expected
        "#]],
    );
}

#[test]
fn each_scenario_starts_cold() {
    check(
        "\
program motor.clad
scenario \"one\"
start -_
starts => 1 1
scenario \"two\"
start _-
starts => 0 1
",
        expect![[r#"
            ok one, 2 scans
            ok two, 2 scans
        "#]],
    );
}

#[test]
fn reals_have_a_tolerance() {
    check(
        "\
program motor.clad
scenario \"exact\"
start -__
hours => 0.1 0.2 0.3
scenario \"of the row\"
start -__
hours => 0.1 0.2 0.3 ± 0.01
scenario \"in ASCII, and in parts\"
start -__
hours => 0.1 0.2 0.303 +-1%
scenario \"of times and integers\"
start -__
warmup.ET => 5ms 15ms 15ms ± 5ms
starts => 0 2 1 ±1
scenario \"too far\"
start -__
hours => 0.1 0.2 0.32 ± 0.01
",
        expect![[r#"
            FAILED exact, 3 scans
            start            ----_______________________
            hours  expected  0.1 0.2 0.3
                   got       0.1 0.2 0.30000000000000004
                                     ^^^^^^^^^^^^^^^^^^^
            hours is 0.30000000000000004 in step 2 (at 20ms), 0.3 was expected; give the row a tolerance, as in ± 0.001
            ok of the row, 3 scans
            ok in ASCII, and in parts, 3 scans
            ok of times and integers, 3 scans
            FAILED too far, 3 scans
            start            ----_______________________
            hours  expected  0.1 0.2 0.32
                   got       0.1 0.2 0.30000000000000004
                                     ^^^^^^^^^^^^^^^^^^^
            hours is 0.30000000000000004 in step 2 (at 20ms), 0.32 was expected
        "#]],
    );
    check(
        "program motor.clad\ntolerance 1e-9\nscenario \"of the file\"\nstart -__\nhours => 0.1 0.2 0.3\n",
        expect![[r#"
            ok of the file, 3 scans
        "#]],
    );
}

#[test]
fn a_step_is_a_number_of_scans() {
    let text = |step: &str| {
        format!("program motor.clad\n{step}\nscenario \"a\"\nstart -_\nwarmup.ET => 30ms 50ms\n")
    };
    check(
        &text("step 40ms"),
        expect![[r#"
        ok a, 8 scans
    "#]],
    );
    check(
        &text("interval 20ms\nstep 40ms"),
        expect![[r#"
            FAILED a, 4 scans
            start                -----____
            warmup.ET  expected  30ms 50ms
                       got       20ms 50ms
                                 ^^^^
            warmup.ET is T#20ms in step 0 (at 20ms), T#30ms was expected
        "#]],
    );
    check(
        &text("interval 40ms\nstep 60ms"),
        expect![[r#"
        3:6-10: a step is a whole number of scans, and 60ms is not a multiple of the scan interval 40ms
            write `step 40ms`, or give another scan interval, as in: interval 1ms
    "#]],
    );
}

#[test]
fn long_scenarios_are_shown_around_the_first_difference() {
    let rows = format!(
        "start -{}\nrun => {}_{}",
        "_".repeat(199),
        "-".repeat(120),
        "-".repeat(79)
    );
    check(
        &format!("program motor.clad\nscenario \"long\"\n{rows}\n"),
        expect![[r#"
            FAILED long, 200 scans
            start            …_____________________________________________________________…
            run    expected  …--------------------_----------------------------------------…
                   got       …-------------------------------------------------------------…
                                                  ^
            run is TRUE in step 120 (at 1s200ms), FALSE was expected
        "#]],
    );
    let rows = format!("start -{}\nhours =>{}", "_".repeat(59), " 0.1 . .".repeat(20));
    check(
        &format!("program motor.clad\ntolerance 1e-6\nscenario \"long numbers\"\n{rows}\n"),
        expect![[r#"
            FAILED long numbers, 60 scans
            start            …___________________________________________________________…
            hours  expected  ….   .                   0.1 .   .   0.1 .                  …
                   got       …0.2 0.30000000000000004 0.4 0.5 0.6 0.7 0.7999999999999999 …
                                                      ^^^         ^^^
            hours is 0.4 in step 3 (at 30ms), 0.1 was expected; 19 of 60 steps differ
        "#]],
    );
}

const PORTS: &str = "\
VAR_INPUT go : BOOL; END_VAR
VAR level : LINT; share : INT; got : USINT; END_VAR
+--[ADC]( level, 2 )--[PWM]( 40, 1000, CH := 1 )--+
+--[ ]( go )--[DIV]( share, 12, share )--+
+--[URCV]( got )--[FMT]( 'got %d', got )--+
";

#[test]
fn ports_and_faults() {
    let text = "\
program ports.clad
scenario \"ports\"
PORT.ADC[2] 100 . -5
level => 100 100 -5
PORT.DUTY[1] => 40 40 40
PORT.SERIAL '' 'A' .
PORT.SERIAL => '' 'got 65' ''
scenario \"a fault is seen in the next scan\"
go _-__
SYS.FAULT => __-_
scenario \"faults are reported\"
go -_
share => 0 0
";
    expect![[r#"
        ok ports, 3 scans
        ok a fault is seen in the next scan, 4 scans
        fault in scan 1: division by zero: nothing was written; check the divisor before this block
        ok faults are reported, 2 scans
        fault in scan 0: division by zero: nothing was written; check the divisor before this block
    "#]]
    .assert_eq(&report(PORTS, text, 80));
}

const ENDLESS: &str = "\
VAR_INPUT go : BOOL; END_VAR
+--[/]( go )--( )( idle )--+
+--<LBL>( again )--[ ]( go )--<JMP>( again )--+
";

#[test]
fn a_program_that_does_not_end_fails_unless_that_is_expected() {
    let text = "\
program endless.clad
scenario \"not expected\"
go __-_
idle => --._
scenario \"expected\"
go __-_
SYS.FAULT => __--
";
    expect![[r#"
        FAILED not expected, 2 scans
        go              __-_
        idle  expected  --._
              got       --??
                           ^
        idle has no value in step 3 (at 30ms), FALSE was expected
        stopped in step 2
        fault in scan 2: this scan has evaluated more than 1000000 blocks, so the watchdog stopped the simulation here; look for a jump or loop that does not end
        ok expected, 2 scans
        fault in scan 2: this scan has evaluated more than 1000000 blocks, so the watchdog stopped the simulation here; look for a jump or loop that does not end
    "#]].assert_eq(&report(ENDLESS, text, 80));
}

#[test]
fn a_scenario_has_a_bounded_number_of_scans() {
    let text = "program motor.clad\nstep 100000h\nscenario \"long\"\nstart _-_\n";
    let (_, errors) = bind(&parse(text), &simulation(MOTOR, None));
    expect![[r#"
        "long" would take 108000000000 scans, and a scenario has at most 10000000
        shorten the step, or take a longer scan interval, as in: interval 1s"#]]
    .assert_eq(&format!(
        "{}\n{}",
        errors[0].message,
        errors[0].help.as_deref().unwrap_or_default()
    ));
    assert_eq!(&text[errors[0].range], "100000h");
    // The most that is allowed.
    let text = "program motor.clad\nstep 100000s\nscenario \"long\"\nstart -\n";
    assert_eq!(bind(&parse(text), &simulation(MOTOR, None)).1, []);
}

#[test]
fn a_scenario_does_a_bounded_amount_of_work() {
    let mut simulation = simulation(MOTOR, None);
    let text = "program motor.clad\nstep 1000s\nscenario \"long\"\nstart _-_\nrun => _--\n";
    let (cases, errors) = bind(&parse(text), &simulation);
    assert_eq!(errors, []);
    let ran = super::run::run_within(
        5000,
        &cases[0],
        &mut Watched::default(),
        &mut simulation,
        Simulation::scan,
    );
    assert_eq!(ran.stopped, Some(0));
    assert!(ran.scans < 5000, "{}", ran.scans);
    expect!["all scans together have done the work of more than 5000 blocks; run fewer scans, or make the program do less in each"].assert_eq(&ran.faults[0].message);
}

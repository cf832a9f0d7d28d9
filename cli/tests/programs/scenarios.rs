//! `ladder test`, and `ladder check` on scenario files

use crate::harness::{Folder, MOTOR, Run};
use expect_test::{Expect, expect};

pub(crate) const PASSES: &str = "\
program motor.clad
step 100ms

scenario \"the seal-in holds after start is let go\"
start   _-_______
stop    ______-__
run  => _-----___
";

pub(crate) const FAILS: &str = "\
program motor.clad

scenario \"start runs it\"
start   _--
run  => _--

scenario \"stop does nothing\"
start   _-____
stop    ___-__
run  => _-----
";

/// Times differ from run to run.
pub(crate) fn without_times(text: &str) -> String {
    let mut out = String::new();
    let mut rest = text;
    // `time="0.001"`, `"seconds":0.001`, `in 0.01 s.`
    while let Some((at, lead)) = ["time=\"", "\"seconds\":", ", in "]
        .iter()
        .filter_map(|lead| Some((rest.find(lead)?, *lead)))
        .min()
    {
        let (before, after) = rest.split_at(at + lead.len());
        out.push_str(before);
        out.push('T');
        rest = after.trim_start_matches(|c: char| c.is_ascii_digit() || matches!(c, '.' | 'e' | '-'));
    }
    out + rest
}

fn shown(run: &Run) -> String {
    without_times(&run.to_string())
}

pub(crate) fn check(files: &[(&str, &str)], arguments: &[&str], expected: Expect) {
    let folder = Folder::with(&[&[("motor.clad", MOTOR)], files].concat());
    expected.assert_eq(&shown(&folder.ladder(arguments)));
}

#[test]
fn a_line_for_each_scenario_and_a_sum() {
    check(
        &[("motor.ladder-test", PASSES)],
        &["test", "motor.ladder-test"],
        expect![[r#"
            exit status 0
            -- stdout
            motor.ladder-test
              ok    the seal-in holds after start is let go

            1 scenario in 1 file: 1 passed, in T s.
        "#]],
    );
}

#[test]
fn a_failed_scenario_is_drawn() {
    check(
        &[("fails.ladder-test", FAILS), ("passes.ladder-test", PASSES)],
        &["test", "."],
        expect![[r#"
            exit status 1
            -- stdout
            fails.ladder-test
              ok    start runs it
              FAIL  stop does nothing
                    start            _-____
                    stop             ___-__
                    run    expected  _-----
                           got       _--___
                                        ^^^
                    run is FALSE in step 3 (at 30ms), TRUE was expected; 3 of 6 steps differ
                    at fails.ladder-test:10:12
            passes.ladder-test
              ok    the seal-in holds after start is let go

            3 scenarios in 2 files: 2 passed, 1 failed, in T s.
        "#]],
    );
}

#[test]
fn folders_are_searched_and_gitignore_is_obeyed() {
    let folder = Folder::with(&[
        ("plant/ladder.toml", ""),
        ("plant/motor.clad", MOTOR),
        ("plant/motor.ladder-test", PASSES),
        (
            "plant/deep/other.ladder-test",
            &PASSES.replace("motor.clad", "../motor.clad"),
        ),
        ("old/motor.ladder-test", "nonsense"),
        (".gitignore", "old/\n"),
    ]);
    expect![[r#"
        exit status 0
        -- stdout
        plant/deep/other.ladder-test
          ok    the seal-in holds after start is let go
        plant/motor.ladder-test
          ok    the seal-in holds after start is let go

        2 scenarios in 2 files: 2 passed, in T s.
    "#]]
    .assert_eq(&shown(&folder.ladder(&["test", "."])));
}

#[test]
fn a_filter_takes_scenarios_by_their_name() {
    let folder = Folder::with(&[("motor.clad", MOTOR), ("a.ladder-test", FAILS)]);
    expect![[r#"
        exit status 0
        -- stdout
        a.ladder-test
          ok    start runs it

        1 scenario in 1 file: 1 passed, in T s.
    "#]]
    .assert_eq(&shown(&folder.ladder(&["test", ".", "--filter", "RUNS"])));
    folder
        .ladder(&["test", ".", "--filter", "walks"])
        .refused_with("no scenario has `walks` in its name");
}

#[test]
fn errors_are_shown_with_their_place() {
    let wrong = "program motor.clad\nscenario \"a\"\nstrat _-_\nrun => _--_\n";
    check(
        &[("a.ladder-test", wrong), ("b.ladder-test", PASSES)],
        &["test", "."],
        expect![[r#"
            exit status 1
            -- stdout
            error[bad-scenario]: there is no tag `strat`; did you mean start?
             --> a.ladder-test:3:1
              |
            3 | strat _-_
              | ^^^^^

            error[bad-scenario]: `run` has 4 steps, but `strat` has 3
             --> a.ladder-test:4:11
              |
            4 | run => _--_
              |           ^
              |
              = help: all rows of a scenario have one length: a value for each step

            b.ladder-test
              ok    the seal-in holds after start is let go

            1 scenario in 2 files: 1 passed, 1 file not run for errors, in T s.
        "#]],
    );
    check(
        &[("a.ladder-test", wrong)],
        &["check", "a.ladder-test"],
        expect![[r#"
            exit status 1
            -- stdout
            error[bad-scenario]: there is no tag `strat`; did you mean start?
             --> a.ladder-test:3:1
              |
            3 | strat _-_
              | ^^^^^

            error[bad-scenario]: `run` has 4 steps, but `strat` has 3
             --> a.ladder-test:4:11
              |
            4 | run => _--_
              |           ^
              |
              = help: all rows of a scenario have one length: a value for each step

            Checked 1 file: 2 errors.
        "#]],
    );
    check(
        &[("a.ladder-test", wrong)],
        &["check", "--format", "json", "a.ladder-test"],
        expect![[r#"
            exit status 1
            -- stdout
            [
              {"file":"a.ladder-test","line":3,"column":1,"end_line":3,"end_column":6,"rule":"bad-scenario","severity":"error","message":"there is no tag `strat`; did you mean start?"},
              {"file":"a.ladder-test","line":4,"column":11,"end_line":4,"end_column":12,"rule":"bad-scenario","severity":"error","message":"`run` has 4 steps, but `strat` has 3","help":"all rows of a scenario have one length: a value for each step"}
            ]
        "#]],
    );
    check(
        &[("a.ladder-test", PASSES)],
        &["check", "a.ladder-test"],
        expect![[r#"
            exit status 0
            -- stdout
            Checked 1 file: no errors found.
        "#]],
    );
}

#[test]
fn a_program_that_is_missing_or_has_errors() {
    check(
        &[("a.ladder-test", &PASSES.replace("motor.clad", "pump.clad"))],
        &["test", "a.ladder-test"],
        expect![[r#"
            exit status 2
            -- stdout
            error[bad-scenario]: pump.clad: no such file or folder
             --> a.ladder-test:1:9
              |
            1 | program pump.clad
              |         ^^^^^^^^^
              |
              = help: a program is named as it is seen from the folder of the scenario file

            0 scenarios in 1 file: 0 passed, 1 file not run for errors, in T s.
        "#]],
    );
    check(
        &[
            ("a.ladder-test", &PASSES.replace("motor.clad", "pump.clad")),
            ("pump.clad", "+--[ ]( start )--[TNO]( t, 5s )--( )( run )--+\n"),
        ],
        &["test", "a.ladder-test"],
        expect![[r#"
            exit status 1
            -- stdout
            error[unknown-instruction]: there is no instruction [TNO]
             --> pump.clad:1:18
              |
            1 | +--[ ]( start )--[TNO]( t, 5s )--( )( run )--+
              |                  ^^^^^
              |
              = help: did you mean [TON] (on-delay timer)?
            help: Replace with [TON]
              |
            1 - +--[ ]( start )--[TNO]( t, 5s )--( )( run )--+
            1 + +--[ ]( start )------------------------------------[TON]( t, 5s )--( )( run )--+
              |

            0 scenarios in 1 file: 0 passed, 1 file not run for errors, in T s.
        "#]],
    );
    check(
        &[],
        &["test", "motor.clad"],
        expect![[r#"
        exit status 2
        -- stderr
        error: motor.clad: this is a program; name the file with its scenarios, for example motor.ladder-test
    "#]],
    );
    check(
        &[],
        &["test", "nothing.ladder-test", "."],
        expect![[r#"
        exit status 2
        -- stderr
        error: nothing.ladder-test: no such file or folder
        error: .: no scenarios (a file ending in .ladder-test) are in this folder
    "#]],
    );
}

pub(crate) const SHARE: &str = "\
VAR_INPUT parts : INT; END_VAR
VAR_OUTPUT share : INT; END_VAR
+--[DIV]( share, 12, parts )--+
";

#[test]
fn faults_are_shown() {
    check(
        &[
            ("share.clad", SHARE),
            (
                "share.ladder-test",
                "program share.clad\nscenario \"no parts\"\nparts 3 0 2\nshare => 4 4 6\nSYS.FAULT => __-\n",
            ),
        ],
        &["test", "."],
        expect![[r#"
            exit status 0
            -- stdout
            share.ladder-test
              ok    no parts
                    share.clad:3:4: fault in scan 1: division by zero: nothing was written; check the divisor before this block

            1 scenario in 1 file: 1 passed, in T s.
        "#]],
    );
}

#[test]
fn the_interval_comes_from_the_workspace_unless_the_file_has_its_own() {
    let program = "VAR_INPUT go : BOOL; END_VAR\nVAR t : TON; END_VAR\n+--[ ]( go )--[TON]( t, T#1s )--( )( done )--+\n";
    let test = "scenario \"a\"\ngo -\nt.ET =>";
    check(
        &[
            ("t.clad", program),
            ("ladder.toml", "[simulate]\ninterval = \"20ms\"\n"),
            (
                "a.ladder-test",
                &format!("program t.clad\nstep 100ms\n{test} 80ms\n"),
            ),
            (
                "b.ladder-test",
                &format!("program t.clad\nstep 100ms\ninterval 50ms\n{test} 50ms\n"),
            ),
        ],
        &["test", "."],
        expect![[r#"
            exit status 0
            -- stdout
            a.ladder-test
              ok    a
            b.ladder-test
              ok    a

            2 scenarios in 2 files: 2 passed, in T s.
        "#]],
    );
}

/// A program with a part of each kind that can be missed.
const PARTS: &str = "\
VAR_INPUT a, b, c : BOOL; n : INT; END_VAR
VAR_OUTPUT x, y, z : BOOL; END_VAR
+--\\--[ ]( a )--\\--[/]( b )--( )( x )--+
|  /--[ ]( c )--/
+--[GT]( n, 5 )--( )( y )--+
+--[ ]( a )--[ ]( b )--<RET>--+
+--( )( z )--+
+--<RET>--+
+--[ ]( a )--( )( last )--+
";

#[test]
fn coverage_shows_what_was_never_exercised() {
    let test = "program parts.clad\nscenario \"a\"\na _--\nb __-\nx => _-_\n";
    let files = [("parts.clad", PARTS), ("parts.ladder-test", test)];
    check(
        &files,
        &["test", "parts.ladder-test", "--coverage"],
        expect![[r#"
            exit status 0
            -- stdout
            parts.ladder-test
              ok    a

            Coverage
              networks  contacts  coils
                   5/6       4/7    2/4  parts.clad

            Never exercised
              parts.clad:4:7: this contact was never closed while power came to it
                |  /--[ ]( c )--/
                      ^^^^^^^^
              parts.clad:5:4: this comparison was never closed while power came to it
                +--[GT]( n, 5 )--( )( y )--+
                   ^^^^^^^^^^^^
              parts.clad:5:18: this coil never had power
                +--[GT]( n, 5 )--( )( y )--+
                                 ^^^^^^^^
              parts.clad:9:1: this network was never reached
                +--[ ]( a )--( )( last )--+
                ^^^^^^^^^^^^^^^^^^^^^^^^^^^

            1 scenario in 1 file: 1 passed, in T s.
        "#]],
    );
    let folder = Folder::with(&files);
    let run = folder.ladder(&["test", ".", "--coverage-output", "lcov.info"]);
    assert_eq!(run.status, Some(0), "{run}");
    expect![[r#"
        TN:
        SF:parts.clad
        BRDA:3,0,0,1
        BRDA:3,0,1,1
        BRDA:3,1,0,1
        BRDA:3,1,1,1
        BRDA:4,0,0,0
        BRDA:4,0,1,1
        BRDA:5,0,0,0
        BRDA:5,0,1,1
        BRDA:6,0,0,1
        BRDA:6,0,1,1
        BRDA:6,1,0,1
        BRDA:6,1,1,1
        BRDA:9,0,0,-
        BRDA:9,0,1,-
        BRF:14
        BRH:10
        DA:3,3
        DA:4,3
        DA:5,3
        DA:6,3
        DA:7,2
        DA:8,2
        DA:9,0
        LF:7
        LH:6
        end_of_record
    "#]]
    .assert_eq(&folder.read("lcov.info"));
}

#[test]
fn coverage_is_taken_over_all_scenarios_of_a_run() {
    let test = |name: &str, rows: &str| format!("program motor.clad\nscenario \"{name}\"\n{rows}");
    check(
        &[
            ("a.ladder-test", &test("a", "start _-\nrun => _-\n")),
            ("b.ladder-test", &test("b", "start -__\nstop __-\nrun => --_\n")),
        ],
        &["test", ".", "--coverage"],
        expect![[r#"
            exit status 0
            -- stdout
            a.ladder-test
              ok    a
            b.ladder-test
              ok    b

            Coverage
              networks  contacts  coils
                   1/1       3/3    1/1  motor.clad

            2 scenarios in 2 files: 2 passed, in T s.
        "#]],
    );
}

const TURNS: &str = "\
VAR_INPUT run : BOOL; trip : ARRAY[1..3] OF BOOL; END_VAR
VAR_OUTPUT alarm : BOOL; pump : ARRAY[1..3] OF BOOL; found : BOOL; END_VAR
VAR i, n : INT; END_VAR
+--[MOV]( i, 0 )--<FOR>( 3 )--+

+--[ADD]( i, i, 1 )--[/]( trip[i] )--[ ]( run )--( )( pump[i] )--+
+--[ ]( trip[i] )--(S)( alarm )--+
+--<NEXT>--+

+--[MOV]( n, 1 )--<CALL>( look )--[MOV]( n, 2 )--<CALL>( look )--+

+--<FUN>( look )--[EQ]( n, 1 )--( )( found )--+
";

#[test]
fn coverage_counts_every_turn_of_a_loop_and_every_call() {
    let test = "program turns.clad\nscenario \"a\"\nrun __--\ntrip[1] ___-\npump[2] => __--\n";
    let files = [("turns.clad", TURNS), ("turns.ladder-test", test)];
    check(
        &files,
        &["test", "turns.ladder-test", "--coverage"],
        expect![[r#"
        exit status 0
        -- stdout
        turns.ladder-test
          ok    a

        Coverage
          networks  contacts  coils
               6/6       4/4    3/3  turns.clad

        1 scenario in 1 file: 1 passed, in T s.
    "#]],
    );
}

#[test]
fn a_waveform_that_differs_is_shown_with_the_numbers_that_were_given() {
    let program = "VAR_INPUT auto : BOOL; level : INT; t : TIME; END_VAR\nVAR_OUTPUT pump, n : BOOL; END_VAR\n\
                   +--[ ]( auto )--[GT]( level, 50 )--( )( pump )--+\n";
    let test = "program tank.clad\nscenario \"fills\"\nauto _----\nlevel 10 30 50 70 .\nt . T#2s . . .\npump => ___--\n\
                scenario \"differs\"\nauto _----\nlevel 10 30 50 70 .\nt . T#2s . . .\npump => __---\n";
    check(
        &[("tank.clad", program), ("tank.ladder-test", test)],
        &["test", "tank.ladder-test"],
        expect![[r#"
            exit status 1
            -- stdout
            tank.ladder-test
              ok    fills
              FAIL  differs
                    auto             ___----------
                    level            10 30 50 70 .
                    t                .  2s .  .  .
                    pump   expected  ______-------
                           got       _________----
                                           ^^
                    pump is FALSE in step 2 (at 20ms), TRUE was expected
                    at tank.ladder-test:11:11

            2 scenarios in 1 file: 1 passed, 1 failed, in T s.
        "#]],
    );
}

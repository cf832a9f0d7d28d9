//! `ladder test --mutate` and `--generate`

use crate::harness::{Folder, MOTOR};
use crate::scenarios::{PASSES, without_times};
use expect_test::{Expect, expect};

/// Its second contact decides nothing, and nobody has tried the third.
const GATE: &str = "\
VAR_INPUT a, b : BOOL; END_VAR
VAR_OUTPUT y : BOOL; END_VAR
VAR t : TON; END_VAR
+--[ ]( a )--[ ]( a )--[/]( b )--[TON]( t, T#30ms )--( )( y )--+
";

const GATE_TEST: &str = "\
program gate.clad
step 10ms

scenario \"it is open after three scans\"
a    _----_
y => ____-_
";

fn check(files: &[(&str, &str)], arguments: &[&str], expected: Expect) {
    let folder = Folder::with(files);
    expected.assert_eq(&without_times(&folder.ladder(arguments).to_string()));
}

#[test]
fn what_no_scenario_notices_is_shown_with_a_run_that_would() {
    check(
        &[("gate.clad", GATE), ("gate.ladder-test", GATE_TEST)],
        &["test", "--mutate", "gate.ladder-test"],
        expect![[r#"
            exit status 1
            -- stdout
            gate.ladder-test
              ok    it is open after three scans

            1 scenario in 1 file: 1 passed, in T s.

            Changes that no scenario notices
              gate.clad:4:24: contact bridged
                +--[ ]( a )--[ ]( a )--[/]( b )--[TON]( t, T#30ms )--( )( y )--+
                                       ^^^^^^^^
                                       --------
                  a            ----
                  b            __--
                  y  expected  ____
                     got       ___-
                                  ^

            Mutation
              caught  missed  the same  not known  score
                   6       1         2          0   85 %  gate.clad
        "#]],
    );
}

#[test]
fn coverage_says_what_is_not_shown_to_matter() {
    let files = [("gate.clad", GATE), ("gate.ladder-test", GATE_TEST)];
    let folder = Folder::with(&files);
    let run = folder
        .ladder(&["test", "--mutate", "--coverage", "gate.clad"])
        .to_string();
    let (_, coverage) = run.split_once("Coverage").expect("it is there");
    let (coverage, _) = coverage.split_once("1 scenario in").expect("a sum follows");
    expect![[r#"

          networks  contacts  coils
               1/1       1/3    1/1  gate.clad

        Never exercised, or not shown to matter
          gate.clad:4:14: this contact was never open while power came to it
            +--[ ]( a )--[ ]( a )--[/]( b )--[TON]( t, T#30ms )--( )( y )--+
                         ^^^^^^^^
          gate.clad:4:24: this contact was never open while power came to it
            +--[ ]( a )--[ ]( a )--[/]( b )--[TON]( t, T#30ms )--( )( y )--+
                                   ^^^^^^^^

    "#]]
    .assert_eq(coverage);
    folder.ladder(&["test", "--mutate", "--coverage-output", "gate.info", "gate.clad"]);
    expect![[r#"
        TN:
        SF:gate.clad
        BRDA:4,0,0,1
        BRDA:4,0,1,1
        BRDA:4,0,2,1
        BRDA:4,1,0,1
        BRDA:4,1,1,0
        BRDA:4,1,2,1
        BRDA:4,2,0,1
        BRDA:4,2,1,0
        BRDA:4,2,2,0
        BRF:9
        BRH:6
        DA:4,6
        LF:1
        LH:1
        end_of_record
    "#]]
    .assert_eq(&folder.read("gate.info"));
}

#[test]
fn machines_are_told() {
    let files = [("motor.clad", MOTOR), ("motor.ladder-test", PASSES)];
    check(
        &files,
        &["test", "--mutate", "motor.clad", "--coverage", "--format", "json"],
        expect![[r#"
            exit status 1
            -- stdout
            {"files": [
            {"file":"motor.ladder-test","program":"motor.clad","seconds":T,"errors":[],"scenarios":[{"name":"the seal-in holds after start is let go","line":4,"column":10,"passed":true,"steps":9,"scans":90,"seconds":T,"differences":[],"faults":[]}]}
            ],
            "summary": {"files":1,"passed":1,"failed":0,"not_run":0,"seconds":T},
            "mutation": [{"program":"motor.clad","caught":6,"missed":1,"same":0,"unknown":0,"score":85,"changes":[{"line":2,"column":7,"end_line":2,"end_column":17,"change":"contact inverted","before":"[ ]( run )","after":"[/]( run )","fate":"missed","scenario":"scenario \"line 2\"\ntime    10ms\nrun  => _\n","diagram":"time            10ms\nrun   expected  ____\n      got       ----\n                ^^^^"}]}],
            "coverage": [{"file":"motor.clad","networks":{"exercised":1,"all":1},"contacts":{"exercised":3,"all":3},"coils":{"exercised":1,"all":1},"rungs":[{"line":1,"scans":90},{"line":2,"scans":90}],"parts":[{"kind":"contact","line":1,"column":7,"on":true,"off":true,"matters":true},{"kind":"contact","line":1,"column":24,"on":true,"off":true,"matters":true},{"kind":"coil","line":1,"column":68,"on":true,"off":true},{"kind":"contact","line":2,"column":7,"on":true,"off":true,"matters":false}]}]}
        "#]],
    );
    check(
        &files,
        &["test", "--mutate", "motor.clad", "--format", "github"],
        expect![[r#"
            exit status 1
            -- stdout
            ::warning file=motor.clad,line=2,col=7,endColumn=17,title=no scenario notices this change::contact inverted: [ ]( run ) becomes [/]( run )
            1 scenario in 1 file: 1 passed, 0 failed
        "#]],
    );
    check(
        &files,
        &["test", "--mutate", "motor.clad", "--format", "junit"],
        expect![[r#"
            exit status 1
            -- stdout
            <?xml version="1.0" encoding="UTF-8"?>
            <testsuites name="ladder test" tests="2" failures="1" errors="0" time="T">
              <testsuite name="motor.ladder-test" tests="1" failures="0" errors="0" skipped="0" time="T" file="motor.ladder-test">
                <testcase name="the seal-in holds after start is let go" classname="motor.ladder-test" time="T" file="motor.ladder-test" line="4"/>
              </testsuite>
              <testsuite name="changes to motor.clad" tests="1" failures="1" errors="0" skipped="0" time="T" file="motor.clad">
                <testcase name="motor.clad:2:7" classname="motor.clad" time="T" file="motor.clad" line="2">
                  <failure message="no scenario notices this change: contact inverted: [ ]( run ) becomes [/]( run )" type="change"/>
                </testcase>
              </testsuite>
            </testsuites>
        "#]],
    );
}

#[test]
fn generated_scenarios_are_added_and_notice_what_they_claim() {
    let folder = Folder::with(&[("gate.clad", GATE), ("gate.ladder-test", GATE_TEST)]);
    let generated = folder
        .ladder(&["test", "--generate", "gate.ladder-test"])
        .to_string();
    let (_, told) = generated.split_once("-- stderr").expect("it says so");
    expect![[r#"

        note: gate.ladder-test: 1 scenario added for 1 change that no scenario noticed; what is expected there is what the program does today, so check it
    "#]].assert_eq(told);
    let file = folder.read("gate.ladder-test");
    expect![[r#"

        # Generated, to be checked: this is what the program does today. It notices when
        #   [/]( b ) becomes -------- in line 4
        scenario "generated 1: [/]( b )"
        a    ----
        b    __--
        y => ____
    "#]]
    .assert_eq(file.strip_prefix(GATE_TEST).expect("nothing is lost"));
    let again = folder
        .ladder(&["test", "--mutate", "gate.ladder-test"])
        .to_string();
    expect![[r#"
        exit status 0
        -- stdout
        gate.ladder-test
          ok    it is open after three scans
          ok    generated 1: [/]( b )

        2 scenarios in 1 file: 2 passed, in T s.

        Mutation
          caught  missed  the same  not known  score
               7       0         2          0  100 %  gate.clad
    "#]]
    .assert_eq(&without_times(&again));
}

#[test]
fn a_program_without_scenarios_gets_a_file() {
    let folder = Folder::with(&[("motor.clad", MOTOR)]);
    folder.ladder(&["test", "--generate", "motor.clad"]);
    expect![[r#"
        program motor.clad
        interval 10ms

        # Generated, to be checked: this is what the program does today. It notices when
        #   [ ]( start ) becomes [/]( start ) in line 1
        #   [ ]( start ) becomes -------- in line 1
        #   ( )( run ) becomes (/)( run ) in line 1
        #   [ ]( run ) becomes [/]( run ) in line 2
        #   and of 1 more
        scenario "generated 1: [ ]( start )"
        run => _

        # Generated, to be checked: this is what the program does today. It notices when
        #   [/]( stop ) becomes [ ]( stop ) in line 1
        #   [/]( stop ) becomes -------- in line 1
        scenario "generated 2: [/]( stop )"
        start    -
        stop     -
        run   => _
    "#]]
    .assert_eq(&folder.read("motor.ladder-test"));
    let tested = folder
        .ladder(&["test", "--mutate", "motor.ladder-test"])
        .to_string();
    assert!(tested.starts_with("exit status 0"), "{tested}");
}

#[test]
fn line_ends_stay_and_another_file_is_not_replaced() {
    let test = GATE_TEST.replace('\n', "\r\n");
    let folder = Folder::with(&[("gate.clad", GATE), ("gate.ladder-test", &test)]);
    folder.ladder(&["test", "--generate", "gate.clad", "-o", "more.ladder-test"]);
    assert_eq!(folder.read("gate.ladder-test"), test);
    let more = folder.read("more.ladder-test");
    assert!(
        more.starts_with("program gate.clad\nstep 10ms\ninterval 10ms\n"),
        "{more}"
    );
    let again = folder.ladder(&["test", "--generate", "gate.clad", "-o", "more.ladder-test"]);
    expect![[r#"
        exit status 2
        -- stderr
        error: more.ladder-test: this belongs to a program, and it stays as it is; name another file, or end with --force
    "#]].assert_eq(&again.to_string());
    folder.ladder(&["test", "--generate", "gate.clad"]);
    let file = folder.read("gate.ladder-test");
    assert!(file.starts_with(&test), "{file}");
    assert_eq!(file.matches('\n').count(), file.matches("\r\n").count(), "{file}");
    // All files of a program count.
    let all = folder.ladder(&["test", "--mutate", "."]).to_string();
    assert!(
        all.contains("100 %") && all.matches("gate.clad").count() == 1,
        "{all}"
    );
}

#[test]
fn a_least_score_decides_about_the_exit_status() {
    let folder = Folder::with(&[("gate.clad", GATE), ("gate.ladder-test", GATE_TEST)]);
    for (least, status) in [("80", "exit status 0"), ("90", "exit status 1")] {
        let run = folder
            .ladder(&["test", "--mutate", "gate.clad", "--min-score", least])
            .to_string();
        assert!(run.starts_with(status), "{run}");
    }
}

#[test]
fn nothing_is_changed_while_a_scenario_fails() {
    let fails = GATE_TEST.replace("____-_", "___--_");
    check(
        &[("gate.clad", GATE), ("gate.ladder-test", &fails)],
        &["test", "--mutate", "gate.clad"],
        expect![[r#"
            exit status 1
            -- stdout
            gate.ladder-test
              FAIL  it is open after three scans
                    a            _----_
                    y  expected  ___--_
                       got       ____-_
                                    ^
                    y is FALSE in step 3 (at 30ms), TRUE was expected
                    at gate.ladder-test:6:9

            1 scenario in 1 file: 0 passed, 1 failed, in T s.

            Mutation
              caught  missed  the same  not known  score
                   0       0         0          0      -  gate.clad: nothing was changed, for "it is open after three scans" fails as it is
        "#]],
    );
}

#[test]
fn runs_keep_to_what_is_assumed() {
    let test = GATE_TEST.replace("step 10ms", "step 10ms\nassume not b");
    check(
        &[("gate.clad", GATE), ("gate.ladder-test", &test)],
        &["test", "--mutate", "gate.clad"],
        expect![[r#"
            exit status 0
            -- stdout
            gate.ladder-test
              ok    it is open after three scans

            1 scenario in 1 file: 1 passed, in T s.

            Mutation
              caught  missed  the same  not known  score
                   6       0         3          0  100 %  gate.clad
        "#]],
    );
}

#[test]
fn what_takes_too_long_is_said() {
    let folder = Folder::with(&[("gate.clad", GATE), ("gate.ladder-test", GATE_TEST)]);
    let run = folder
        .ladder(&["test", "--mutate", "gate.clad", "--time", "0"])
        .to_string();
    assert!(run.contains("there was no time left"), "{run}");
    let wrong = folder
        .ladder(&["test", "--mutate", "gate.clad", "--time", "nan"])
        .to_string();
    assert!(wrong.starts_with("exit status 2"), "{wrong}");
}

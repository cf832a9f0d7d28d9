//! Programs of other systems, named where a command takes a program.

use crate::harness::{Folder, MOTOR};
use expect_test::expect;

const RUNG: &str = "\
start (open contact I0.1 V open contact Q0) & closed contact I1.0 & active coil Q0 end
start open contact I0.1 & open contact I3.0 V (open contact I2.0 & inactive coil Q1) end
";

pub(crate) const DRAFT: &str = "\
// a lamp
IN = {DI go}
OUT = {DO lamp}

+---[ ]<go>---[PID]<x>---()<lamp>---+
";

/// Divides by what nobody gives.
pub(crate) const FAULTY: &str = "\
IN = {AI a, AI b}
OUT = {AO c}

+---[DIV]<share><a><b><c>---+
";

#[test]
fn findings_stand_in_the_file_that_was_named() {
    let folder = Folder::with(&[("motor.rung", RUNG), ("lamp.cplc", DRAFT)]);
    expect![[r#"
        exit status 1
        -- stdout
        warning[textbook-precedence]: the paper does not say what belongs together here: before a coil `&` takes all that is before it, between contacts it binds more tightly than `V`; put parentheses round what belongs together
         --> motor.rung:2:7
          |
        2 | start open contact I0.1 & open contact I3.0 V (open contact I2.0 & inactive coil Q1) end
          |       ^^^^^^^^^^^^^^^^^

        warning[dead-end]: the power of [ ]( I0 ) goes nowhere: nothing that acts is after it
         --> motor.rung:2:7
          |
        2 | start open contact I0.1 & open contact I3.0 V (open contact I2.0 & inactive coil Q1) end
          |       ^^^^^^^^^^^^^^^^^
          |
          = help: put a coil or another block after it, join the line to another with \ and /, or remove it

        error[cplc-draft-block]: `[PID]<x>` stays as a comment: the draft has no such block
         --> lamp.cplc:5:15
          |
        5 | +---[ ]<go>---[PID]<x>---()<lamp>---+
          |               ^^^^^^^^

        Checked 2 files: 1 error, 2 warnings.
    "#]].assert_eq(&folder.ladder(&["check", "motor.rung", "lamp.cplc"]).to_string());
    for (format, expected) in [
        (
            "concise",
            expect![[r#"
                exit status 1
                -- stdout
                motor.rung:2:7: warning[textbook-precedence] the paper does not say what belongs together here: before a coil `&` takes all that is before it, between contacts it binds more tightly than `V`; put parentheses round what belongs together
                motor.rung:2:7: warning[dead-end] the power of [ ]( I0 ) goes nowhere: nothing that acts is after it
                lamp.cplc:5:15: error[cplc-draft-block] `[PID]<x>` stays as a comment: the draft has no such block
                Checked 2 files: 1 error, 2 warnings.
            "#]],
        ),
        (
            "json",
            expect![[r#"
                exit status 1
                -- stdout
                [
                  {"file":"motor.rung","line":2,"column":7,"end_line":2,"end_column":24,"rule":"textbook-precedence","severity":"warning","message":"the paper does not say what belongs together here: before a coil `&` takes all that is before it, between contacts it binds more tightly than `V`; put parentheses round what belongs together"},
                  {"file":"motor.rung","rule":"dead-end","severity":"warning","message":"the power of [ ]( I0 ) goes nowhere: nothing that acts is after it","line":2,"column":7,"end_line":2,"end_column":24,"help":"put a coil or another block after it, join the line to another with \\ and /, or remove it"},
                  {"file":"lamp.cplc","line":5,"column":15,"end_line":5,"end_column":23,"rule":"cplc-draft-block","severity":"error","message":"`[PID]<x>` stays as a comment: the draft has no such block"}
                ]
            "#]],
        ),
        (
            "github",
            expect![[r#"
                exit status 1
                -- stdout
                ::warning file=motor.rung,line=2,col=7,endColumn=24,title=textbook-precedence::the paper does not say what belongs together here: before a coil `&` takes all that is before it, between contacts it binds more tightly than `V`; put parentheses round what belongs together
                ::warning file=motor.rung,line=2,col=7,endColumn=24,title=dead-end::the power of [ ]( I0 ) goes nowhere: nothing that acts is after it%0Aput a coil or another block after it, join the line to another with \ and /, or remove it
                ::error file=lamp.cplc,line=5,col=15,endColumn=23,title=cplc-draft-block::`[PID]<x>` stays as a comment: the draft has no such block
            "#]],
        ),
    ] {
        let run = folder.ladder(&["check", "--format", format, "motor.rung", "lamp.cplc"]);
        expected.assert_eq(&run.to_string());
    }
}

#[test]
fn findings_for_code_scanning() {
    let folder = Folder::with(&[("lamp.cplc", DRAFT), ("motor.rung", RUNG)]);
    let run = folder.ladder(&["check", "--format", "sarif", "motor.rung", "lamp.cplc"]);
    let document: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
    let results = document["runs"][0]["results"].as_array().unwrap();
    let places: Vec<String> = results
        .iter()
        .map(|result| {
            let place = &result["locations"][0]["physicalLocation"];
            let region = &place["region"];
            format!(
                "{} {} {}:{}-{}",
                result["ruleId"],
                place["artifactLocation"]["uri"],
                region["startLine"],
                region["startColumn"],
                region["endColumn"]
            )
        })
        .collect();
    expect![[r#"
        "textbook-precedence" "motor.rung" 2:7-24
        "dead-end" "motor.rung" 2:7-24
        "cplc-draft-block" "lamp.cplc" 5:15-23"#]]
    .assert_eq(&places.join("\n"));
}

#[test]
fn a_run_shows_the_coils() {
    let folder = Folder::with(&[("motor.rung", RUNG)]);
    expect![[r#"
        exit status 0
        -- stdout
        scan,time_ms,Q0,Q1
        0,0,1,1
    "#]]
    .assert_eq(&folder.ladder(&["sim", "motor.rung", "--scans", "1"]).to_string());
    let run = folder.ladder(&[
        "sim",
        "motor.rung",
        "--scans",
        "1",
        "--set",
        "I1=1",
        "--watch",
        "I1,Q0",
    ]);
    expect![[r#"
        exit status 0
        -- stdout
        scan,time_ms,I1,Q0
        0,0,1,0
    "#]]
    .assert_eq(&run.to_string());
    let run = folder.ladder(&["sim", "motor.rung", "--scans", "1", "--format", "diagram"]);
    expect![[r#"
        exit status 0
        -- stdout
        VAR_INPUT
            I0 : BOOL := TRUE;
            I1 : BOOL;
            I2 : BOOL;
            I3 : BOOL;
        END_VAR
        VAR_OUTPUT
            Q0 : BOOL;
            Q1 : BOOL;
        END_VAR

        +==\==[ ]( I0 )==\==[/]( I1 )=======================================( )( Q0 )==+
        |  /==[ ]( Q0 )--/                                                             |

        +==\==[ ]( I0 )==[ ]( I3 )--------------------------------------------------\--+
        |  /==[ ]( I2 )--------------------------------------------------(/)( Q1 )--/  |
    "#]]
    .assert_eq(&run.to_string());
}

#[test]
fn faults_stand_in_the_file_that_was_named() {
    let folder = Folder::with(&[("share.cplc", FAULTY)]);
    let run = folder.ladder(&["sim", "share.cplc", "--scans", "1"]);
    expect![[r#"
        exit status 0
        -- stdout
        scan,time_ms,a,b,c
        0,0,0.0,0.0,0.0
        -- stderr
        share.cplc:4:5: fault in scan 0: division by zero: nothing was written; check the divisor before this block
    "#]].assert_eq(&run.to_string());
}

#[test]
fn what_has_no_counterpart_is_not_run() {
    let folder = Folder::with(&[("lamp.cplc", DRAFT)]);
    expect![[r#"
        exit status 1
        -- stderr
        error[cplc-draft-block]: `[PID]<x>` stays as a comment: the draft has no such block
         --> lamp.cplc:5:15
          |
        5 | +---[ ]<go>---[PID]<x>---()<lamp>---+
          |               ^^^^^^^^

        error: lamp.cplc: a program with errors is not run
    "#]]
    .assert_eq(&folder.ladder(&["sim", "lamp.cplc", "--scans", "1"]).to_string());
    let run = folder.ladder(&["render", "lamp.cplc", "-o", "lamp.svg"]);
    expect![[r#"
        exit status 1
        -- stderr
        error[cplc-draft-block]: `[PID]<x>` stays as a comment: the draft has no such block
         --> lamp.cplc:5:15
          |
        5 | +---[ ]<go>---[PID]<x>---()<lamp>---+
          |               ^^^^^^^^

        error: lamp.cplc: drawn as far as it goes; the program has errors
    "#]]
    .assert_eq(&run.to_string());
    assert!(folder.read("lamp.svg").contains("lamp"));
}

#[test]
fn scenarios_of_a_foreign_program() {
    let scenarios = "\
program motor.rung
step 10ms

scenario \"start and stop\"
I0 _-___
I1 ___-_
Q0 => _--__
Q1 => -____
";
    let folder = Folder::with(&[("motor.rung", RUNG), ("motor.ladder-test", scenarios)]);
    let run = folder.ladder(&["test", "motor.ladder-test", "--coverage"]);
    let shown = run.to_string();
    let shown = shown.split(", in ").next().unwrap();
    expect![[r#"
        exit status 1
        -- stdout
        motor.ladder-test
          FAIL  start and stop
                I0            _-___
                I1            ___-_
                Q1  expected  -____
                    got       -----
                               ^^^^
                Q1 is TRUE in step 1 (at 10ms), FALSE was expected; 4 of 5 steps differ
                at motor.ladder-test:8:8

        Coverage
          networks  contacts  coils
               2/2       4/6    1/2  motor.rung

        Never exercised
          motor.rung:2:27: this contact was never closed while power came to it
            start open contact I0.1 & open contact I3.0 V (open contact I2.0 & inactive coil Q1) end
                                      ^^^^^^^^^^^^^^^^^
          motor.rung:2:48: this contact was never closed while power came to it
            start open contact I0.1 & open contact I3.0 V (open contact I2.0 & inactive coil Q1) end
                                                           ^^^^^^^^^^^^^^^^^
          motor.rung:2:68: this coil never had power
            start open contact I0.1 & open contact I3.0 V (open contact I2.0 & inactive coil Q1) end
                                                                               ^^^^^^^^^^^^^^^^

        1 scenario in 1 file: 0 passed, 1 failed"#]]
    .assert_eq(shown);
    folder.write("motor.rung", b"start open I0.1 end\n");
    let run = folder.ladder(&["test", "motor.ladder-test", "--format", "github"]);
    expect![[r#"
        exit status 2
        -- stdout
        ::error file=motor.rung,line=1,col=7,endColumn=7,title=bad-scenario::motor.rung:1:7: `open` is followed by `contact`
        0 scenarios in 1 file: 0 passed, 0 failed, 1 file not run for errors
    "#]].assert_eq(&run.to_string());
    expect![[r#"
        exit status 2
        -- stdout
        error: motor.rung:1:7: `open` is followed by `contact`

        Checked 1 file: 1 error.
    "#]]
    .assert_eq(&folder.ladder(&["check", "motor.ladder-test"]).to_string());
}

#[test]
fn what_is_broken_is_reported_with_its_place() {
    let folder = Folder::with(&[
        ("broken.rung", "start open contact I0.1 & active coil end\n"),
        ("unknown.ld", "what is this\n"),
        ("any.txt", MOTOR),
    ]);
    let broken = "broken.rung:1:27: a name such as `I0.1`, `M2` or `Q3` is missing here";
    for arguments in [
        &["check", "broken.rung"][..],
        &["sim", "broken.rung", "--scans", "1", "-o", "out.csv"],
        &["render", "broken.rung", "-o", "out.svg"],
    ] {
        folder.ladder(arguments).refused_with(broken);
    }
    folder.ladder(&["check", "unknown.ld"]).refused_with(
        "unknown.ld: this is in no notation that is known; if it is, `ladder convert --from` takes it",
    );
    // Ladder text may have any name that is not another system's.
    assert_eq!(folder.ladder(&["check", "any.txt"]).status, Some(0));
    assert_eq!(folder.names(), ["any.txt", "broken.rung", "unknown.ld"]);
}

#[test]
fn the_notation_can_be_named() {
    let folder = Folder::with(&[(
        "lamp.clad",
        "IN = {DI go}\nOUT = {DO lamp}\n+--[ ]<go>--()<lamp>--+\n",
    )]);
    for command in [
        &["check", "--from", "cplc-draft", "lamp.clad"][..],
        &["sim", "--from", "cplc-draft", "lamp.clad", "--scans", "1"],
        &["render", "--from", "cplc-draft", "lamp.clad", "-o", "lamp.svg"],
    ] {
        let run = folder.ladder(command);
        assert_eq!((run.status, run.stderr.as_str()), (Some(0), ""));
    }
    let run = folder.ladder(&["check", "--from", "ldmicro", "lamp.clad"]);
    run.refused_with("lamp.clad:1:1: the first line of an LDmicro program is `LDmicro0.1` or `LDmicro0.2`");
}

#[test]
fn a_foreign_program_is_not_fixed() {
    let folder = Folder::with(&[("motor.rung", RUNG), ("motor.clad", MOTOR)]);
    let run = folder.ladder(&["check", "--fix", "motor.rung", "motor.clad"]);
    expect![[r#"
        exit status 2
        -- stdout
        Checked 1 file: no errors found.
        -- stderr
        error: motor.rung: --fix fixes only ladder text, and this file is in the notation `textbook`; `ladder convert motor.rung -o FILE.clad` writes it as ladder text
    "#]].assert_eq(&run.to_string());
    assert_eq!(folder.read("motor.rung"), RUNG);
}

#[test]
fn a_foreign_program_is_not_aligned() {
    let folder = Folder::with(&[("motor.rung", RUNG), ("motor.clad", MOTOR)]);
    let run = folder.ladder(&["fmt", "motor.rung", "motor.clad"]);
    expect![[r#"
        exit status 2
        -- stderr
        error: motor.rung: only ladder text is aligned, and this file is in the notation `textbook`
    "#]]
    .assert_eq(&run.to_string());
    assert_eq!(folder.read("motor.rung"), RUNG);
}

const MOTOR_DRAFT: &str = "\
// a motor
IN = {DI start, DI stop}
OUT = {DO run}

+---\\--[ ]<start>---\\---[/]<stop>---()<run>---+
    /--[ ]<run>-----/
";

#[test]
fn a_draft_that_is_called_ladder_text_is_reported_once() {
    let folder = Folder::with(&[("motor.clad", MOTOR_DRAFT), ("lamp.clad", DRAFT)]);
    let run = folder.ladder(&["check", "--format", "concise", "motor.clad"]);
    expect![[r#"
        exit status 1
        -- stdout
        motor.clad:2:1: error[unexpected-character] this is a program in the first draft of CPLC-LD, which ladder text has moved on from
        Checked 1 file: 1 error.
    "#]].assert_eq(&run.to_string());
    expect![[r#"
        exit status 0
        -- stdout
        fixed motor.clad:2:1 unexpected-character: Convert to ladder text
        Checked 1 file: no errors found. Fixed 1 finding.
    "#]]
    .assert_eq(&folder.ladder(&["check", "--fix", "motor.clad"]).to_string());
    expect![[r#"
        # a motor #

        VAR_INPUT
            start : BOOL;
            stop  : BOOL;
        END_VAR
        VAR_OUTPUT
            run : BOOL;
        END_VAR

        +--\--[ ]( start )--\--[/]( stop )---------------------------------( )( run )--+
        |  /--[ ]( run )----/                                                          |
    "#]]
    .assert_eq(&folder.read("motor.clad"));
    // What cannot be said exactly is not said unasked.
    expect![[r#"
        exit status 1
        -- stdout
        error[unexpected-character]: this is a program in the first draft of CPLC-LD, which ladder text has moved on from
          --> lamp.clad:2:1
           |
         2 | IN = {DI go}
           | ^^^^^^^^^^^^
           |
           = help: `ladder convert --from cplc-draft` writes it as ladder text, and says what becomes of each element
        help: Convert to ladder text
           |
         1 + # a lamp #
         2 + 
         3 + VAR_INPUT
         4 +     go : BOOL;
         5 + END_VAR
         6 + VAR_OUTPUT
         7 +     lamp : BOOL;
         8 + END_VAR
         9 + 
        10 + +--[ ]( go )--# [PID]<x> #----------------------------------------( )( lamp )--+
           |

        Checked 1 file: 1 error.
    "#]].assert_eq(&folder.ladder(&["check", "--fix", "lamp.clad"]).to_string());
    assert_eq!(folder.read("lamp.clad"), DRAFT);
    let run = folder.ladder(&["check", "--fix", "--unsafe-fixes", "lamp.clad"]);
    assert_eq!(run.status, Some(0));
    expect![[r#"
        # a lamp #

        VAR_INPUT
            go : BOOL;
        END_VAR
        VAR_OUTPUT
            lamp : BOOL;
        END_VAR

        +--[ ]( go )--# [PID]<x> #----------------------------------------( )( lamp )--+
    "#]]
    .assert_eq(&folder.read("lamp.clad"));
    folder.write("broken.clad", b"IN = {DI start}\n+--[ ]<start>--?--()<run>--+\n");
    expect![[r#"
        exit status 1
        -- stdout
        error[unexpected-character]: this is a program in the first draft of CPLC-LD, which ladder text has moved on from
         --> broken.clad:1:1
          |
        1 | IN = {DI start}
          | ^^^^^^^^^^^^^^^
          |
          = help: it cannot be converted yet: 2:16: `?` is nothing that a rung is drawn with

        Checked 1 file: 1 error.
    "#]].assert_eq(&folder.ladder(&["check", "broken.clad"]).to_string());
}

#[test]
fn only_named_files_are_foreign() {
    let folder = Folder::with(&[
        ("a/motor.clad", MOTOR),
        ("a/motor.rung", RUNG),
        ("b/motor.rung", RUNG),
    ]);
    expect![[r#"
        exit status 0
        -- stdout
        Checked 1 file: no errors found.
    "#]]
    .assert_eq(&folder.ladder(&["check", "a"]).to_string());
    expect![[r#"
        exit status 2
        -- stderr
        error: b: no program (a file ending in .clad or .st) is in this folder
    "#]]
    .assert_eq(&folder.ladder(&["check", "b"]).to_string());
}

#[test]
fn a_text_from_stdin_may_be_foreign() {
    let folder = Folder::with(&[]);
    let ladder = env!("CARGO_BIN_EXE_ladder");
    let run = folder.run(
        ladder,
        &["check", "--format", "concise", "-"],
        DRAFT.as_bytes(),
        &[],
    );
    expect![[r#"
        exit status 1
        -- stdout
        <stdin>:5:15: error[cplc-draft-block] `[PID]<x>` stays as a comment: the draft has no such block
        Checked 1 file: 1 error.
    "#]]
    .assert_eq(&run.to_string());
    let named = ["check", "--fix", "--stdin-filename", "motor.rung", "-"];
    let run = folder.run(ladder, &named, RUNG.as_bytes(), &[]);
    expect![[r#"
        exit status 2
        -- stderr
        error: motor.rung: --fix fixes only ladder text, and this file is in the notation `textbook`; `ladder convert motor.rung -o FILE.clad` writes it as ladder text
    "#]].assert_eq(&run.to_string());
}

#[test]
fn the_settings_of_the_workspace_hold() {
    let folder = Folder::with(&[
        ("ladder.toml", "[lint]\nnever-read = \"off\"\n"),
        ("motor.rung", "start open contact I0.1 & active coil M0 end\n"),
    ]);
    expect![[r#"
        exit status 0
        -- stdout
        Checked 1 file: no errors found.
    "#]]
    .assert_eq(&folder.ladder(&["check", "motor.rung"]).to_string());
}

#[test]
fn a_timer_or_counter_of_two_blocks_is_a_warning_in_its_file() {
    let ldmicro = "\
LDmicro0.1
CYCLE=10000
CRYSTAL=4000000
BAUD=2400

IO LIST
END

PROGRAM
RUNG
CONTACTS Xa 0
TON Tx 100000
COIL Ya 0 0 0
END
RUNG
CONTACTS Xb 0
TON Tx 200000
COIL Yb 0 0 0
END
RUNG
CONTACTS Xc 0
CTU Cx 3
RES Cx
END
RUNG
CONTACTS Xd 0
CTU Cx 4
COIL Yd 0 0 0
END
";
    let iot = "\
NO I01 ; TON T1 3 100 ; OUT Q01
NO I02 ; TON T1 5 100 ; OUT Q02
NO I03 ; CTU C1 3 ; RESET C1
NO I04 ; CTU C1 4 ; OUT Q04
";
    let folder = Folder::with(&[("two.ld", ldmicro), ("two.iot", iot)]);
    let check = |file: &str| folder.ladder(&["check", file, "--format", "concise"]).to_string();
    expect![[r#"
        exit status 0
        -- stdout
        two.ld:12:1: warning[ldmicro-timer-name] Variable for 'Tx' incorrectly assigned: TON: variable cannot be used elsewhere.
        two.ld:17:1: warning[ldmicro-timer-name] Variable for 'Tx' incorrectly assigned: TON: variable cannot be used elsewhere.
        two.ld:17:1: warning[duplicate-timer] the timer `Tx` has a second block: both would work on one TON
        two.ld:27:1: warning[duplicate-counter] the counter `Cx` has a second block: both would work on one CTU
        Checked 1 file: 4 warnings.
    "#]].assert_eq(&check("two.ld"));
    expect![[r#"
        exit status 0
        -- stdout
        two.iot:2:10: warning[duplicate-timer] the timer `T1` has a second block: both would work on one TON
        two.iot:4:10: warning[duplicate-counter] the counter `C1` has a second block: both would work on one CTU
        Checked 1 file: 2 warnings.
    "#]].assert_eq(&check("two.iot"));
    // In ladder text that is read from them, too.
    for file in ["two.ld", "two.iot"] {
        folder.ladder(&["convert", file, "-o", "two.clad", "--force"]);
        let told = folder
            .ladder(&["check", "two.clad", "--format", "concise"])
            .stdout;
        let found = |rule: &str| told.lines().filter(|line| line.contains(rule)).count();
        assert_eq!(
            [
                found("warning[duplicate-timer]"),
                found("warning[duplicate-counter]")
            ],
            [1, 1],
            "{told}"
        );
    }
}

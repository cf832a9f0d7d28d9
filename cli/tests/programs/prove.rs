//! `ladder prove`

use crate::harness::Folder;
use crate::scenarios::without_times;
use expect_test::{Expect, expect};
use std::path::Path;

const MOTOR: &str = "\
VAR warmup : TON; END_VAR
+--\\--[ ]( start )--\\--[/]( stop )--( )( run )--+
|  /--[ ]( run )----/
+--[ ]( run )--[TON]( warmup, T#2s )--( )( ready )--+
";

const PROPERTIES: &str = "\
program motor.clad
interval 100ms

property \"stop wins\"
never stop and run

property \"ready comes at once\"
within 1s of run: ready or not run

possible ready
";

fn check(files: &[(&str, &str)], arguments: &[&str], expected: Expect) {
    let folder = Folder::with(&[&[("motor.clad", MOTOR)], files].concat());
    expected.assert_eq(&without_depth(&without_times(
        &folder.ladder(arguments).to_string(),
    )));
}

/// How far a search came depends on the machine, and so may what the solver had.
fn without_depth(text: &str) -> String {
    let text = &text
        .split("\"clauses\":")
        .map(|part| part.trim_start_matches(|c: char| c.is_ascii_digit()))
        .collect::<Vec<_>>()
        .join("\"clauses\":N");
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    lines.retain(|line| !line.ends_with("not decided: the time was over"));
    for line in &mut lines {
        if let Some(at) = line.find("no such run in ") {
            line.truncate(at);
            line.push_str("no such run in N scans");
        }
    }
    lines.join("\n") + "\n"
}

#[test]
fn a_line_for_each_property_and_the_runs() {
    check(
        &[("motor.ladder-test", PROPERTIES)],
        &["prove", "motor.ladder-test"],
        expect![[r#"
            exit status 1
            -- stdout
            motor.ladder-test
              proved      stop wins            for any times
              violated    ready comes at once  in scan 10, at 1s
                          start    -----------
                          stop     ___________
                          run   => -----------
                          ready => ___________
              possible    possible ready       in scan 20, at 2s
                          start    ---------------------
                          stop     _____________________
                          ready => ____________________-

            3 properties in 1 file: 1 proved, 1 possible, 1 violated, in T s.
        "#]],
    );
}

#[test]
fn json_has_the_same() {
    check(
        &[("motor.ladder-test", PROPERTIES)],
        &["prove", "motor.ladder-test", "--format", "json"],
        expect![[r#"
            exit status 1
            -- stdout
            {"files":[{"file":"motor.ladder-test","program":"motor.clad","seconds":T,"interval_ns":100000000,"errors":[],"properties":[{"name":"stop wins","line":4,"column":10,"verdict":"proved","times":"any","k":0,"never_triggered":false,"open":[],"clauses":N,"seconds":T},{"name":"ready comes at once","line":7,"column":10,"verdict":"violated","scan":10,"never_triggered":false,"open":[],"clauses":N,"seconds":T,"trace":[{"tag":"start","given":true,"values":["TRUE","TRUE","TRUE","TRUE","TRUE","TRUE","TRUE","TRUE","TRUE","TRUE","TRUE"]},{"tag":"stop","given":true,"values":["FALSE","FALSE","FALSE","FALSE","FALSE","FALSE","FALSE","FALSE","FALSE","FALSE","FALSE"]},{"tag":"run","given":false,"values":["TRUE","TRUE","TRUE","TRUE","TRUE","TRUE","TRUE","TRUE","TRUE","TRUE","TRUE"]},{"tag":"ready","given":false,"values":["FALSE","FALSE","FALSE","FALSE","FALSE","FALSE","FALSE","FALSE","FALSE","FALSE","FALSE"]}],"scenario":"scenario \"ready comes at once is violated\"\nstart    -----------\nstop     ___________\nrun   => -----------\nready => ___________\n"},{"name":"possible ready","line":10,"column":1,"verdict":"possible","scan":20,"never_triggered":false,"open":[],"clauses":N,"seconds":T,"trace":[{"tag":"start","given":true,"values":["TRUE","TRUE","TRUE","TRUE","TRUE","TRUE","TRUE","TRUE","TRUE","TRUE","TRUE","TRUE","TRUE","TRUE","TRUE","TRUE","TRUE","TRUE","TRUE","TRUE","TRUE"]},{"tag":"stop","given":true,"values":["FALSE","FALSE","FALSE","FALSE","FALSE","FALSE","FALSE","FALSE","FALSE","FALSE","FALSE","FALSE","FALSE","FALSE","FALSE","FALSE","FALSE","FALSE","FALSE","FALSE","FALSE"]},{"tag":"ready","given":false,"values":["FALSE","FALSE","FALSE","FALSE","FALSE","FALSE","FALSE","FALSE","FALSE","FALSE","FALSE","FALSE","FALSE","FALSE","FALSE","FALSE","FALSE","FALSE","FALSE","FALSE","TRUE"]}],"scenario":"scenario \"possible ready is possible\"\nstart    ---------------------\nstop     _____________________\nready => ____________________-\n"}]}],"seconds":T}
        "#]],
    );
}

#[test]
fn build_servers_read_xml() {
    check(
        &[("motor.ladder-test", PROPERTIES)],
        &["prove", "motor.ladder-test", "--format", "junit"],
        expect![[r#"
            exit status 1
            -- stdout
            <?xml version="1.0" encoding="UTF-8"?>
            <testsuites name="ladder prove" tests="3" failures="1" errors="0" time="T">
              <testsuite name="motor.ladder-test" tests="3" failures="1" errors="0" skipped="0" time="T" file="motor.ladder-test">
                <testcase name="stop wins" classname="motor.ladder-test" time="T" file="motor.ladder-test" line="4"/>
                <testcase name="ready comes at once" classname="motor.ladder-test" time="T" file="motor.ladder-test" line="7">
                  <failure message="violated in scan 10, at 1s" type="violated">start    -----------
            stop     ___________
            run   =&gt; -----------
            ready =&gt; ___________</failure>
                </testcase>
                <testcase name="possible ready" classname="motor.ladder-test" time="T" file="motor.ladder-test" line="10"/>
              </testsuite>
            </testsuites>
        "#]],
    );
}

#[test]
fn a_fault_in_a_property_is_said() {
    let text = "program p.clad\nproperty \"the share\"\nnever 100 / n > 100\nnever 100 / (n * 2 + 1) > 100\n";
    check(
        &[
            (
                "p.clad",
                "VAR_INPUT n : USINT; END_VAR\n+--[GT]( n, 3 )--( )( some )--+\n",
            ),
            ("p.ladder-test", text),
        ],
        &["prove", "p.ladder-test"],
        expect![[r#"
            exit status 0
            -- stdout
            p.ladder-test
              proved      the share                      for any times
                          a fault can happen in it (in scan 0): its expression is FALSE then
              proved      never 100 / (n * 2 + 1) > 100  for any times

            2 properties in 1 file: 2 proved, in T s.
        "#]],
    );
}

#[test]
fn what_is_proved_or_possible_is_fine() {
    let text = "program motor.clad\nnever stop and run\npossible run\nwhen run and stop: ready\nwithin 2s of run: ready or not run\n";
    check(
        &[("a.ladder-test", text)],
        &["prove", "."],
        expect![[r#"
        exit status 0
        -- stdout
        a.ladder-test
          proved      never stop and run                  for any times
          possible    possible run                        in scan 0, at 0s
                      start    -
                      stop     _
                      run   => -
          proved      when run and stop: ready            for any times
                      never triggered: what is on its left side never happens
          proved      within 2s of run: ready or not run  for an interval of 10ms

        4 properties in 1 file: 3 proved, 1 possible, in T s.
    "#]],
    );
}

#[test]
fn what_cannot_be_decided_says_why() {
    let program = "VAR hours : TON; END_VAR\n+--[ ]( start )--[TON]( hours, T#8h )--( )( tired )--+\n\
                   +--[ADD]( level, level, 0.5 )--[GT]( level, 3.0 )--( )( full )--+\n";
    let back = "+--<LBL>( again )--[ ]( go )--<JMP>( again )--+\n+--[ ]( go )--( )( gone )--+\n";
    let files = [
        ("p.clad", program),
        (
            "p.ladder-test",
            "program p.clad\ninterval 1s\npossible tired and start\nnever full\n",
        ),
        ("back.clad", back),
        ("back.ladder-test", "program back.clad\nnever gone\n"),
    ];
    check(
        &files,
        &["prove", ".", "--time", "2"],
        expect![[r#"
            exit status 1
            -- stdout
            back.ladder-test
              unknown     never gone
                          not decided: a jump may go back more often than is followed (back.clad:1)

            p.ladder-test
              unknown     possible tired and start  no such run in N scans
                          not decided: hours takes 28800 scans (p.clad:1)
              unknown     never full
                          not decided: arithmetic of reals is not tracked (p.clad:3)

            3 properties in 2 files: 3 unknown, in T s.
        "#]],
    );
    check(
        &files,
        &["prove", "back.ladder-test", "--allow-unknown"],
        expect![[r#"
            exit status 0
            -- stdout
            back.ladder-test
              unknown     never gone
                          not decided: a jump may go back more often than is followed (back.clad:1)

            1 property in 1 file: 1 unknown, in T s.
        "#]],
    );
}

/// A product of two numbers of 16 bits that is a prime: a question that no solver answers soon.
#[cfg(unix)]
#[test]
fn the_state_of_a_block_that_another_program_runs_may_be_any() {
    let library = "FUNCTION_BLOCK [$B]
VAR_INPUT x : BOOL; END_VAR
VAR_OUTPUT o : BOOL; most : INT := 5; END_VAR
+--[ ]( x )--( )( o )--+
END_FUNCTION_BLOCK
VAR_GLOBAL h : $B; END_VAR
+--[ ]( q )--[$B]( h, q )--+
";
    let files = [
        ("library.clad", library),
        ("motor.clad", "+--[ ]( h.o )--( )( y )--+\n"),
        ("motor.ladder-test", "program motor.clad\nnever y\n"),
        (
            "local.clad",
            "VAR g : $B; END_VAR\n+--[EQ]( g.most, 5 )--[/]( g.o )--( )( y )--+\n",
        ),
        ("local.ladder-test", "program local.clad\nalways y\n"),
    ];
    check(
        &files,
        &["prove", "."],
        expect![[r#"
            exit status 1
            -- stdout
            local.ladder-test
              proved      always y  for any times

            motor.ladder-test
              violated    never y  in scan 0, at 0s
                          h.o    -
                          y   => -

            2 properties in 2 files: 1 proved, 1 violated, in T s.
        "#]],
    );
}

#[test]
fn ctrl_c_asks_for_the_answers_that_are_there() {
    use std::process::{Command, Stdio};
    use std::time::{Duration, Instant};

    let folder = Folder::with(&[
        (
            "hard.clad",
            "VAR_INPUT x, y : DINT; END_VAR\n+--[MUL]( z, x, y )--[EQ]( z, 2147483647 )--( )( hit )--+\n",
        ),
        (
            "hard.ladder-test",
            "program hard.clad\nassume x > 1 and y > 1 and x < 65536 and y < 65536\nnever hit\nalways x > 0\n",
        ),
    ]);
    let began = Instant::now();
    let child = Command::new(env!("CARGO_BIN_EXE_ladder"))
        .args(["prove", "hard.ladder-test", "--time", "600"])
        .current_dir(folder.path("."))
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    std::thread::sleep(Duration::from_secs(3));
    let sent = Command::new("kill")
        .args(["-INT", &child.id().to_string()])
        .status();
    assert!(sent.unwrap().success());
    let output = child.wait_with_output().unwrap();
    assert!(began.elapsed() < Duration::from_secs(60), "{:?}", began.elapsed());
    let shown = String::from_utf8(output.stdout).unwrap();
    // How far it came by then depends on the machine.
    assert_eq!(output.status.code(), Some(1), "{shown}");
    assert!(shown.contains("unknown     never hit"), "{shown}");
    assert!(shown.contains("not decided: it was stopped"), "{shown}");
}

#[test]
fn the_time_counts_from_the_first_block_of_the_program_on() {
    let folder = Folder::with(&[("motor.clad", MOTOR), ("motor.ladder-test", PROPERTIES)]);
    let run = folder
        .ladder(&["prove", "motor.ladder-test", "--time", "0"])
        .to_string();
    assert!(run.starts_with("exit status 1\n"), "{run}");
    let late = "not decided: the time was over before all of the program was followed (motor.clad:2)";
    assert!(run.contains(late), "{run}");
    assert!(run.contains("3 properties in 1 file: 3 unknown"), "{run}");
}

#[test]
fn assumptions_that_cannot_hold_are_no_success() {
    let text = "program motor.clad\nassume start and not start\nnever run\n";
    check(
        &[("a.ladder-test", text)],
        &["prove", "."],
        expect![[r#"
        exit status 1
        -- stdout
        a.ladder-test
          vacuous     never run  what is assumed cannot hold in the first scan

        1 property in 1 file: 1 vacuous, in T s.
    "#]],
    );
}

#[test]
fn errors_are_shown_at_their_places() {
    let text = "program motor.clad\nnever nothing\nwhen run ready\nalways 5\n";
    check(
        &[("a.ladder-test", text)],
        &["prove", "a.ladder-test"],
        expect![[r#"
            exit status 1
            -- stdout
            error[bad-scenario]: there is no tag `nothing` in this program
             --> a.ladder-test:2:7
              |
            2 | never nothing
              |       ^^^^^^^

            error[bad-scenario]: a colon is missing here
             --> a.ladder-test:3:10
              |
            3 | when run ready
              |          ^^^^^
              |
              = help: write it as in: when jam: not running

            error[bad-scenario]: a condition is TRUE or FALSE, and this is of type LINT
             --> a.ladder-test:4:8
              |
            4 | always 5
              |        ^

            0 properties in 1 file: 1 file not read for errors, in T s.
        "#]],
    );
    check(
        &[("a.ladder-test", text)],
        &["test", "a.ladder-test"],
        expect![[r#"
            exit status 1
            -- stdout
            error[bad-scenario]: there is no tag `nothing` in this program
             --> a.ladder-test:2:7
              |
            2 | never nothing
              |       ^^^^^^^

            error[bad-scenario]: a colon is missing here
             --> a.ladder-test:3:10
              |
            3 | when run ready
              |          ^^^^^
              |
              = help: write it as in: when jam: not running

            error[bad-scenario]: a condition is TRUE or FALSE, and this is of type LINT
             --> a.ladder-test:4:8
              |
            4 | always 5
              |        ^

            0 scenarios in 1 file: 0 passed, 1 file not run for errors, in T s.
        "#]],
    );
    check(
        &[],
        &["prove", "motor.clad"],
        expect![[r#"
        exit status 2
        -- stderr
        error: motor.clad: this is a program; name the file with its properties, for example motor.ladder-test
    "#]],
    );
    check(
        &[],
        &["prove", "."],
        expect![[r#"
        exit status 2
        -- stderr
        error: .: no scenarios (a file ending in .ladder-test) are in this folder
    "#]],
    );
    check(
        &[],
        &["prove", ".", "--time", "soon"],
        expect![[r#"
        exit status 2
        -- stderr
        error: invalid value 'soon' for '--time <SECONDS>': invalid float literal

        For more information, try '--help'.
    "#]],
    );
}

#[test]
fn the_runs_are_scenarios_that_pass() {
    let text = "program p.clad\ninterval 100ms\nproperty \"it \"\nnever a and b\nno faults\n\
                property \"in time\"\nwithin 1 scan of was(n) > 5: n < 3\n";
    let program = "VAR_INPUT a, b : BOOL; n : INT; END_VAR\n+--[ ]( a )--[DIV]( x, 10, n )--+\n";
    let folder = Folder::with(&[("p.clad", program), ("p.ladder-test", text)]);
    let arguments = ["prove", "p.ladder-test", "--write", "found.ladder-test"];
    let proved = folder.ladder(&arguments).to_string();
    let found = folder.read("found.ladder-test");
    expect![[r#"
        program p.clad
        interval 100ms

        scenario "it is violated"
        a    -
        b    -
        a => -

        scenario "no faults is violated"
        a            - -
        n            0 0
        SYS.FAULT => . -

        scenario "in time is violated"
        n    6 6 6
        n => 6 6 6
    "#]]
    .assert_eq(&found);
    let tested = folder.ladder(&["test", "found.ladder-test"]).to_string();
    expect![[r#"
        exit status 0
        -- stdout
        found.ladder-test
          ok    it is violated
                p.clad:2:14: fault in scan 0: division by zero: nothing was written; check the divisor before this block
          ok    no faults is violated
                p.clad:2:14: fault in scan 0: division by zero: nothing was written; check the divisor before this block
                p.clad:2:14: fault in scan 1: division by zero: nothing was written; check the divisor before this block
          ok    in time is violated

        3 scenarios in 1 file: 3 passed, in T s.
    "#]].assert_eq(&without_times(&tested));
    assert!(proved.contains("3 violated"), "{proved}");
    // It stays where it is once it is there.
    let again = folder.ladder(&arguments).to_string();
    assert!(
        again.contains("ends with --force") || again.contains("end with --force"),
        "{again}"
    );
}

#[test]
fn the_name_of_the_program_may_need_quotes() {
    let text = "program \"line [2] #1.clad\"\nnever run\n";
    let folder = Folder::with(&[("line [2] #1.clad", MOTOR), ("line.ladder-test", text)]);
    folder.ladder(&["prove", "line.ladder-test", "--write", "found.ladder-test"]);
    let tested = folder.ladder(&["test", "found.ladder-test"]).to_string();
    assert!(tested.contains("1 passed"), "{tested}");
}

#[test]
fn a_long_run_has_a_column_for_each_stretch_in_which_nothing_changes() {
    let text = "program motor.clad\ninterval 10ms\nproperty \"never warm\"\nnever ready and not was(stop)\n";
    let folder = Folder::with(&[("motor.clad", MOTOR), ("motor.ladder-test", text)]);
    let arguments = ["prove", "motor.ladder-test", "--write", "found.ladder-test"];
    folder.ladder(&arguments);
    expect![[r#"
        program motor.clad
        interval 10ms

        scenario "never warm is violated"
        time     1.37s 180ms 450ms .
        stop     _     _     _     _
        start    -     _     -     -
        ready => _     _     _     -
    "#]]
    .assert_eq(&folder.read("found.ladder-test"));
    let tested = folder.ladder(&["test", "found.ladder-test"]).to_string();
    assert!(tested.contains("1 passed"), "{tested}");
}

#[test]
fn every_example_has_properties_and_all_are_proved() {
    let examples = concat!(env!("CARGO_MANIFEST_DIR"), "/../examples");
    let proved = Folder::with(&[])
        .ladder(&["prove", "--time", "120", examples])
        .to_string();
    assert!(proved.starts_with("exit status 0"), "{proved}");
    let total = proved.lines().rfind(|line| line.contains(" properties in "));
    let total = total.unwrap_or_default();
    assert!(
        total.contains("in 14 files") && !total.contains("possible"),
        "{total}"
    );
}

/// What the examples with plants are for: each has something that holds because the machine is as it is.
#[test]
fn without_its_plant_a_property_of_each_of_these_examples_is_violated() {
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples");
    for (program, property) in [
        ("conveyor", "when not was(belt): not rises(beam)"),
        ("garage_door", "never is_open and is_closed"),
        ("mixer", "when step = IDLE: not lower"),
        ("tank", "never high_alarm"),
    ] {
        let beside = std::fs::read_to_string(examples.join(format!("{program}_plant.ladder-test"))).unwrap();
        assert!(beside.contains(property), "{program}");
        let file = format!("{program}.clad");
        let text = std::fs::read_to_string(examples.join(&file)).unwrap();
        let alone = format!("program {file}\ninterval 1s\n{property}\n");
        let folder = Folder::with(&[(&file, &text), ("alone.ladder-test", &alone)]);
        let answer = folder.ladder(&["prove", "alone.ladder-test"]).to_string();
        assert!(answer.starts_with("exit status 1"), "{program}: {answer}");
        assert!(answer.contains("  violated  "), "{program}: {answer}");
    }
}

#[test]
fn test_says_how_many_properties_there_are() {
    check(
        &[("motor.ladder-test", PROPERTIES)],
        &["test", "motor.ladder-test"],
        expect![[r#"
            exit status 0
            -- stdout
            motor.ladder-test
                    3 properties; ladder prove motor.ladder-test decides them for all runs

            0 scenarios in 1 file: 0 passed, in T s.
        "#]],
    );
}

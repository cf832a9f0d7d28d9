//! Scenarios whose expectations are not met: where the program is shown then.

use expect_test::{Expect, expect};
use serde_json::json;

use super::Client;

/// Runs a scenario on to its end; for each stop why it is, where, and what tags are there.
fn check(program: &str, rows: &str, watched: &[&str], expected: Expect) {
    let mut client = Client::new(program);
    let file = client.folder.path().join("own.ladder-test");
    std::fs::write(&file, format!("program own.clad\nscenario \"s\"\n{rows}")).unwrap();
    client.body("initialize", json!({}));
    client.body(
        "launch",
        json!({"scenarioFile": file, "scenario": "s", "stopOnEntry": true, "speed": "max"}),
    );
    client.body("configurationDone", json!({}));
    let mut shown = String::new();
    for _ in 0..9 {
        let told = client.ask("continue", json!({"threadId": 1}));
        let event = |name: &str| told.iter().find(|message| message["event"] == name);
        let Some(stopped) = event("stopped") else {
            let status = &event("exited").unwrap()["body"]["exitCode"];
            shown.push_str(&format!("exit status {status}\n"));
            break;
        };
        let why = stopped["body"]["description"]
            .as_str()
            .unwrap()
            .split(" (")
            .next();
        let frames = client.body("stackTrace", json!({"threadId": 1}));
        let frame = &frames["stackFrames"][0];
        let place = format!("{}:{}", frame["line"], frame["column"]);
        let values: Vec<String> = watched
            .iter()
            .map(|tag| format!("{tag} is {}", client.evaluate(tag, "watch")))
            .collect();
        shown.push_str(&format!(
            "{}\n  {place} {}; {}\n",
            why.unwrap(),
            frame["name"].as_str().unwrap(),
            values.join(", ")
        ));
    }
    expected.assert_eq(&shown);
}

const MOTOR: &str = "VAR_INPUT start : BOOL; END_VAR
VAR_OUTPUT run, lamp : BOOL; END_VAR
+--[ ]( start )--( )( run )--+

+--[/]( run )----( )( lamp )--+
";

/// The coil of the tag, in the scan of the step, after it has written; the next stop is the next step's.
#[test]
fn a_program_stops_at_the_coil_that_is_wrong_in_its_scan() {
    check(
        MOTOR,
        "start _-__\nrun => _-_-\n",
        &["SYS.SCAN", "run", "lamp"],
        expect![[r#"
            run is FALSE, expected TRUE in step 3
              3:18 main, rung in line 3; SYS.SCAN is 3, run is FALSE, lamp is TRUE
            exit status 1
        "#]],
    );
}

/// The scan has come to its end there.
#[test]
fn after_the_last_block_it_is_the_end_of_the_scan() {
    check(
        MOTOR,
        "start _-\nlamp => --\n",
        &["lamp"],
        expect![[r#"
        lamp is FALSE, expected TRUE in step 1
          5:18 main, rung in line 5, end of scan 1; lamp is FALSE
        exit status 1
    "#]],
    );
}

/// It holds its value since an earlier scan: what could have written it is what is wrong.
#[test]
fn a_latch_that_is_not_reset_and_a_coil_that_is_never_set() {
    let program = "VAR_INPUT a, b : BOOL; END_VAR
VAR_OUTPUT l, m, n : BOOL; END_VAR
+--[ ]( a )--(S)( l )--+

+--[ ]( a )--[ ]( b )--(R)( l )--+

+--[ ]( b )--(S)( m )--+

+--[/]( a )--( )( n )--+
";
    check(
        program,
        "a -__\nl => -__\n",
        &["l"],
        expect![[r#"
        l is TRUE, expected FALSE in step 1
          3:14 main, rung in line 3; l is TRUE
        l is TRUE, expected FALSE in step 2
          3:14 main, rung in line 3; l is TRUE
        exit status 1
    "#]],
    );
    check(
        program,
        "a -__\nm => -__\n",
        &["m"],
        expect![[r#"
        m is FALSE, expected TRUE in step 0
          7:14 main, rung in line 7; m is FALSE
        exit status 1
    "#]],
    );
}

/// Nothing is guessed where the value is not the program's.
#[test]
fn an_input_has_no_coil() {
    check(
        MOTOR,
        "start -\nstart => _\n",
        &["start"],
        expect![[r#"
        start is TRUE, expected FALSE in step 0
          3:1 main, before scan 1; start is TRUE
        exit status 1
    "#]],
    );
}

/// Of two places of one block it is the one whose output is wrong.
#[test]
fn a_coil_in_a_body_is_that_of_its_instance() {
    let program = "VAR_INPUT a, b : BOOL; END_VAR
VAR one, two : $Pass; END_VAR
VAR_OUTPUT y, z : BOOL; END_VAR
FUNCTION_BLOCK [$Pass]
VAR_INPUT i : BOOL; END_VAR
VAR_OUTPUT q : BOOL; END_VAR
+--[ ]( i )--( )( q )--+
END_FUNCTION_BLOCK
+--[$Pass]( one, a )--+
+--[$Pass]( two, b )--+
+--[ ]( one.q )--( )( y )--+
+--[ ]( two.q )--( )( z )--+
";
    check(
        program,
        "a -\nb _\none.q => _\n",
        &["one.q"],
        expect![[r#"
        one.q is TRUE, expected FALSE in step 0
          7:14 $Pass, rung in line 7; one.q is TRUE
        exit status 1
    "#]],
    );
}

//! Properties that are watched while a program is debugged.

use expect_test::{Expect, expect};
use serde_json::{Value as Json, json};

use super::Client;

const SHUTTER: &str = "VAR_INPUT a, b : BOOL; END_VAR
VAR_OUTPUT up, down : BOOL; END_VAR
+--[ ]( a )--( )( up )--+

+--[ ]( b )--( )( down )--+
";

const PROPERTIES: &str = "program own.clad

assume not (a and was(b))

property \"not both\"
never up and down

after rises(up): not down

scenario \"both\"
a _-_--
b __-_-
up => _-_--
";

/// The client of a program with a file of scenarios next to it, stopped before its first scan.
fn client(scenarios: &str, launch: Json) -> Client {
    let mut client = Client::new(SHUTTER);
    std::fs::write(client.folder.path().join("own.ladder-test"), scenarios).unwrap();
    client.body("initialize", json!({}));
    let mut configuration = json!({"program": client.program(), "speed": "max", "stopOnEntry": true});
    for (key, value) in launch.as_object().unwrap() {
        configuration[key] = value.clone();
    }
    let told = client.ask("launch", configuration);
    assert_eq!(told[0]["success"], true, "{told:?}");
    client.body("configurationDone", Json::Null);
    client
}

/// What a client is shown: what is written with its place, why it is, and how it ends.
fn shown(client: &Client, told: &[Json]) -> String {
    let mut lines = String::new();
    for message in told {
        let body = &message["body"];
        let text = |key: &str| body[key].as_str().unwrap_or_default().trim_end().to_owned();
        lines.push_str(&match message["event"].as_str() {
            Some("output") => format!("{} {}: {}\n", text("category"), body["line"], text("output")),
            Some("stopped") => format!("{} {}\n", text("reason"), text("description")),
            Some("exited") => format!("exit status {}\n", body["exitCode"]),
            _ => continue,
        });
    }
    let lines = lines.replace(" \n", "\n");
    lines.replace(&*client.folder.path().to_string_lossy(), "")
}

/// Does one thing after the other; what was shown.
fn check(mut client: Client, requests: &[&str], expected: Expect) {
    let mut all = String::new();
    for request in requests {
        let told = client.ask(request, json!({"threadId": 1}));
        all.push_str(&format!("{request}\n{}", shown(&client, &told)));
    }
    expected.assert_eq(&all);
}

#[test]
fn a_scenario_that_violates_a_property_stops_and_has_failed() {
    check(
        client(PROPERTIES, json!({"scenario": "both"})),
        &["continue", "continue"],
        expect![[r#"
            continue
            stderr 8: the property "after rises(up): not down" is violated in scan 2 (at 20ms): up is FALSE, down is TRUE
            exception the property "after rises(up): not down" is violated in scan 2 (at 20ms): up is FALSE, down is TRUE
            continue
            console null: outside of what is assumed from scan 3 (at 30ms) on, where `not (a and was(b))` does not hold: the properties are not watched from there
            stderr null: scenario "both" failed
            exit status 1
        "#]],
    );
}

/// What the properties remember is of the scan that was gone back to.
#[test]
fn a_step_back_takes_back_what_was_remembered() {
    check(
        client(PROPERTIES, json!({"scenario": "both"})),
        &[
            "continue",
            "ladder/stepBackScan",
            "ladder/stepBackScan",
            "continue",
            "continue",
        ],
        expect![[r#"
            continue
            stderr 8: the property "after rises(up): not down" is violated in scan 2 (at 20ms): up is FALSE, down is TRUE
            exception the property "after rises(up): not down" is violated in scan 2 (at 20ms): up is FALSE, down is TRUE
            ladder/stepBackScan
            step
            ladder/stepBackScan
            step
            continue
            stderr 8: the property "after rises(up): not down" is violated in scan 2 (at 20ms): up is FALSE, down is TRUE
            exception the property "after rises(up): not down" is violated in scan 2 (at 20ms): up is FALSE, down is TRUE
            continue
            console null: outside of what is assumed from scan 3 (at 30ms) on, where `not (a and was(b))` does not hold: the properties are not watched from there
            stderr null: scenario "both" failed
            exit status 1
        "#]],
    );
}

/// A run that a proof has found has no properties in its text: those of the file count.
#[test]
fn a_text_in_the_place_of_the_file_is_watched_for_the_properties_of_the_file() {
    let text = "program own.clad\ninterval 10ms\n\nscenario \"found\"\na _-\nb _-\nup => _-\n";
    let properties = "program own.clad\n\nnever up and down\n";
    let given = json!({"scenario": "found", "scenarioText": text});
    let mut client = client(properties, given);
    let told = client.ask("continue", json!({"threadId": 1}));
    expect![[r#"
        stderr 3: the property "never up and down" is violated in scan 1 (at 10ms): up is TRUE, down is TRUE
        exception the property "never up and down" is violated in scan 1 (at 10ms): up is TRUE, down is TRUE
    "#]]
    .assert_eq(&shown(&client, &told));
    let exception = client.body("exceptionInfo", json!({"threadId": 1}));
    assert_eq!(exception["exceptionId"], "Property violated");
}

#[test]
fn a_program_is_watched_for_the_properties_next_to_it() {
    let given = json!({"inputs": {"a": true, "b": true}});
    check(
        client("program own.clad\nnever up and down\n", given),
        &["continue", "continue"],
        expect![[r#"
            continue
            stderr 2: the property "never up and down" is violated in scan 0 (at 0s): up is TRUE, down is TRUE
            exception the property "never up and down" is violated in scan 0 (at 0s): up is TRUE, down is TRUE
            continue
        "#]],
    );
}

#[test]
fn an_error_in_the_properties_is_told_and_the_program_runs() {
    let mut client = Client::new(SHUTTER);
    let file = client.folder.path().join("own.ladder-test");
    std::fs::write(file, "program own.clad\nnever up and dwn\n").unwrap();
    client.body("initialize", json!({}));
    let program = client.program();
    let told = client.ask("launch", json!({"program": program}));
    expect![[r#"
        console null: /own.ladder-test:2: there is no tag `dwn`; did you mean down?; the properties are not watched
    "#]]
    .assert_eq(&shown(&client, &told));
}

#[test]
fn where_they_are_switched_off_they_are_written_alone() {
    let mut client = client(PROPERTIES, json!({"scenario": "both"}));
    client.body("setExceptionBreakpoints", json!({"filters": ["faults"]}));
    check(
        client,
        &["continue"],
        expect![[r#"
            continue
            stderr 8: the property "after rises(up): not down" is violated in scan 2 (at 20ms): up is FALSE, down is TRUE
            console null: outside of what is assumed from scan 3 (at 30ms) on, where `not (a and was(b))` does not hold: the properties are not watched from there
            stderr null: scenario "both" failed
            exit status 1
        "#]],
    );
}

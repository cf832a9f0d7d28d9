//! Programs in Structured Text, and projects with tasks.

use serde_json::{Value as Json, json};

use super::Client;

const COUNTER: &str = "\
PROGRAM Counter
VAR go : BOOL; n, m : INT; t : TON; END_VAR
    IF go THEN
        n := n + 1;
        t(IN := TRUE, PT := T#1s);
    END_IF;
    m := n * 2;
END_PROGRAM
";

/// A client that has launched a file of its folder.
fn launched(files: &[(&str, &str)], program: &str) -> Client {
    let mut client = Client::new("");
    for (name, text) in files {
        std::fs::write(client.folder.path().join(name), text).unwrap();
    }
    let path = client.folder.path().join(program);
    client.body("initialize", json!({}));
    client.body(
        "launch",
        json!({"program": path.to_str().unwrap(), "stopOnEntry": true, "speed": "max"}),
    );
    client
}

/// The name and the line of where it is.
fn top(client: &mut Client) -> (String, i64) {
    let body = client.body("stackTrace", json!({"threadId": 1}));
    let frame = &body["stackFrames"][0];
    let name = frame["source"]["name"].as_str().unwrap_or_default();
    (name.to_owned(), frame["line"].as_i64().unwrap())
}

#[test]
fn a_run_stops_at_a_statement() {
    let mut client = launched(&[("counter.st", COUNTER)], "counter.st");
    let path = client.folder.path().join("counter.st");
    let set = json!({"source": {"path": path.to_str().unwrap()}, "breakpoints": [{"line": 7}, {"line": 4}]});
    let body = client.body("setBreakpoints", set);
    assert_eq!(
        (&body["breakpoints"][0]["line"], &body["breakpoints"][1]["line"]),
        (&json!(7), &json!(4)),
        "{body}"
    );
    client.body("configurationDone", Json::Null);
    client.ask("continue", json!({"threadId": 1}));
    assert_eq!(top(&mut client), ("counter.st".to_owned(), 7));
    client.evaluate("go := TRUE", "repl");
    client.ask("continue", json!({"threadId": 1}));
    assert_eq!(top(&mut client), ("counter.st".to_owned(), 4));
    client.ask("next", json!({"threadId": 1}));
    assert_eq!(top(&mut client), ("counter.st".to_owned(), 5));
    assert_eq!(client.evaluate("n", "hover"), "1");
}

#[test]
fn what_does_not_parse_is_not_run() {
    let mut client = Client::new("");
    let path = client.folder.path().join("counter.st");
    std::fs::write(&path, COUNTER.replace("THEN", "")).unwrap();
    client.body("initialize", json!({}));
    let answer = client
        .ask("launch", json!({"program": path.to_str().unwrap()}))
        .swap_remove(0);
    assert!(
        answer["message"]
            .as_str()
            .unwrap()
            .contains("counter.st:4: `THEN` is expected"),
        "{answer}"
    );
}

#[test]
fn the_tasks_of_a_project_are_debugged() {
    let settings = "[[task]]\nname = \"slow\"\ninterval = \"100ms\"\nprograms = [\"counter.st\"]\n\
                    [[task]]\nname = \"fast\"\ninterval = \"20ms\"\nprograms = [\"own.clad\"]\n";
    let files = [
        ("counter.st", COUNTER),
        ("ladder.toml", settings),
        ("own.clad", "+--[ADD]( k, k, 1 )--+\n"),
    ];
    let mut client = launched(&files, "ladder.toml");
    let path = client.folder.path().join("counter.st");
    let set = json!({"source": {"path": path.to_str().unwrap()}, "breakpoints": [{"line": 7}]});
    client.body("setBreakpoints", set);
    client.body("configurationDone", Json::Null);
    client.ask("continue", json!({"threadId": 1}));
    assert_eq!(top(&mut client), ("counter.st".to_owned(), 7));
    // The slow task runs before the fast one in its sixth scan.
    client.ask("continue", json!({"threadId": 1}));
    assert_eq!(client.evaluate("own.k", "hover"), "5");
}

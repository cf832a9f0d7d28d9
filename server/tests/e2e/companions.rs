//! Settings files and scenarios: what is wrong in them is shown at its place.

use std::fs;

use serde_json::{Value, json};

use crate::client::{Client, span};
use crate::plant::Plant;

const SOUND: &str = "+--[ ]( a )--( )( y )--+\n";

/// The next diagnostics of a file: `code [line, character, line, character] message`.
async fn published(client: &mut Client, uri: &str) -> Vec<(Value, String)> {
    let found = client
        .notification("textDocument/publishDiagnostics", |it| it["uri"] == uri)
        .await;
    let found = found["diagnostics"].as_array().unwrap().clone();
    let shown = |it: &Value| {
        let text = format!(
            "{} {}",
            it["code"].as_str().unwrap(),
            it["message"].as_str().unwrap()
        );
        (it["range"].clone(), text)
    };
    found.iter().map(shown).collect()
}

async fn open(client: &mut Client, uri: &str, language: &str, text: &str) {
    let document = json!({"uri": uri, "languageId": language, "version": 1, "text": text});
    client
        .notify("textDocument/didOpen", json!({"textDocument": document}))
        .await;
}

async fn replace(client: &mut Client, uri: &str, version: i32, text: &str) {
    let params =
        json!({"textDocument": {"uri": uri, "version": version}, "contentChanges": [{"text": text}]});
    client.notify("textDocument/didChange", params).await;
}

async fn close(client: &mut Client, uri: &str) {
    client
        .notify("textDocument/didClose", json!({"textDocument": {"uri": uri}}))
        .await;
}

#[tokio::test]
async fn a_error_in_the_settings_above_an_open_program() {
    let plant = Plant::with(&[("ladder.toml", "# plant\n[format]\nwith = 120\n")]);
    let mut client = Client::new().await;
    let settings = plant.uri("ladder.toml");
    client.open_as(&plant.uri("a.clad"), 1, SOUND).await;
    let found = published(&mut client, &settings).await;
    assert_eq!(
        found,
        [(
            span([2, 0, 2, 4]),
            "bad-setting `with` is not a setting in [format]: did you mean `width`?".to_owned()
        )]
    );
    // Fixed on disk.
    plant.write("ladder.toml", "[format]\nwidth = 120\n");
    let params = json!({"changes": [{"uri": settings, "type": 2}]});
    client.notify("workspace/didChangeWatchedFiles", params).await;
    assert_eq!(published(&mut client, &settings).await, []);
    client.finish().await;
}

#[tokio::test]
async fn an_open_settings_file_is_checked_as_the_editor_shows_it() {
    let plant = Plant::with(&[("ladder.toml", "[lint]\nopen-wires = \"off\"\n")]);
    let mut client = Client::new().await;
    let settings = plant.uri("ladder.toml");
    client.open_as(&plant.uri("a.clad"), 1, SOUND).await;
    assert_eq!(published(&mut client, &settings).await.len(), 1);
    open(&mut client, &settings, "toml", "[lint]\nopen-wires = \"off\"\n").await;
    assert_eq!(published(&mut client, &settings).await.len(), 1);
    replace(&mut client, &settings, 2, "[lint]\nopen-wire = \"off\"\n").await;
    assert_eq!(published(&mut client, &settings).await, []);
    // Half-written.
    replace(&mut client, &settings, 3, "[lint]\nopen-wire = \n").await;
    let found = published(&mut client, &settings).await;
    assert!(
        found[0].1.starts_with("bad-setting this is not TOML"),
        "{found:?}"
    );
    assert_eq!(found[0].0["start"]["line"], 1);
    // Closed without being saved: what is on disk counts, and is shown again.
    close(&mut client, &settings).await;
    assert_eq!(published(&mut client, &settings).await, []);
    assert_eq!(published(&mut client, &settings).await.len(), 1);
    client.finish().await;
}

#[tokio::test]
async fn what_is_no_program_is_not_read_as_one() {
    let mut client = Client::new().await;
    let (other, settings) = ("file:///plant/Cargo.toml", "file:///plant/ladder.toml");
    open(&mut client, other, "toml", "[package]\n").await;
    open(&mut client, settings, "toml", "[format]\n").await;
    for uri in [other, settings] {
        assert_eq!(published(&mut client, uri).await, []);
        let place = json!({"textDocument": {"uri": uri}, "position": {"line": 0, "character": 2}});
        assert_eq!(client.request("textDocument/hover", place).await, Ok(Value::Null));
        let format = json!({"textDocument": {"uri": uri}, "options": {"tabSize": 4, "insertSpaces": true}});
        assert_eq!(
            client.request("textDocument/formatting", format).await,
            Ok(Value::Null)
        );
    }
    client.finish().await;
}

#[tokio::test]
async fn errors_in_scenarios_stand_at_their_places_and_follow_the_program() {
    let plant = Plant::with(&[("a.clad", SOUND)]);
    let mut client = Client::new().await;
    let (test, program) = (plant.uri("a.ladder-test"), plant.uri("a.clad"));
    let text = "program a.clad\nstep 100ms\n\nscenario \"on\"\na    _-\ny => _-\n";
    open(&mut client, &test, "ladder-test", text).await;
    assert_eq!(published(&mut client, &test).await, []);
    replace(&mut client, &test, 2, &text.replace("a    _-", "b    _-")).await;
    let found = published(&mut client, &test).await;
    assert_eq!(found[0].0, span([4, 0, 4, 1]));
    assert!(found[0].1.starts_with("bad-scenario "), "{found:?}");
    // The program, as the editor shows it, has the tag.
    client
        .open_as(&program, 1, &SOUND.replace("( a )", "( b )"))
        .await;
    assert_eq!(published(&mut client, &test).await, []);
    replace(&mut client, &program, 2, "+--[ ]( b )--( )( y\n").await;
    let found = published(&mut client, &test).await;
    assert_eq!(
        found,
        [(
            span([0, 8, 0, 14]),
            "bad-scenario a.clad has errors; its scenarios run when it has none".to_owned()
        )]
    );
    close(&mut client, &program).await;
    // The program counts as it is on disk, where it has no errors and no `b`.
    loop {
        let found = published(&mut client, &test).await;
        if found.iter().all(|(_, text)| !text.contains("has errors")) {
            break;
        }
    }
    fs::remove_file(plant.folder.path().join("a.clad")).unwrap();
    let params = json!({"changes": [{"uri": program, "type": 3}]});
    client.notify("workspace/didChangeWatchedFiles", params).await;
    loop {
        let found = published(&mut client, &test).await;
        if found.iter().any(|(_, text)| text.contains("no such file")) {
            break;
        }
    }
    close(&mut client, &test).await;
    client.finish().await;
}

#[tokio::test]
async fn scenarios_run_in_the_server_against_the_text_of_the_editor() {
    let plant = Plant::with(&[("a.clad", "+--[ ]( x )--( )( y )--+\n")]);
    let (test, program) = (plant.uri("a.ladder-test"), plant.uri("a.clad"));
    let mut client = Client::new().await;
    let ask = json!({"command": "ladder.runScenarios", "arguments": [{"uri": test}]});
    let closed = client.request("workspace/executeCommand", ask.clone()).await;
    let message = closed.unwrap_err().1;
    assert!(
        message.ends_with("is no file of scenarios that is open in the editor"),
        "{message}"
    );
    let text = "program a.clad\nstep 100ms\nscenario \"s\"\nx    -_\ny => -_\n";
    open(&mut client, &test, "ladder-test", text).await;
    let run = client
        .request("workspace/executeCommand", ask.clone())
        .await
        .unwrap();
    assert_eq!(run["scenarios"][0]["passed"], true);
    assert!(run.get("coverage").is_none());
    // What the editor shows counts, not what is on disk.
    client.open_as(&program, 1, "+--[/]( x )--( )( y )--+\n").await;
    let run = client
        .request("workspace/executeCommand", ask.clone())
        .await
        .unwrap();
    assert_eq!(run["scenarios"][0]["passed"], false);
    assert_eq!(run["program"], program);
    let wrong = "program a.clad\nstep 100ms\nscenario \"s\"\nnone => -_\n";
    let params = json!({"textDocument": {"uri": test, "version": 2}, "contentChanges": [{"text": wrong}]});
    client.notify("textDocument/didChange", params).await;
    let message = client
        .request("workspace/executeCommand", ask)
        .await
        .unwrap_err()
        .1;
    assert!(message.starts_with("line 4: "), "{message}");
    client.finish().await;
}

/// `program ladder.toml` is what the tasks run, with the texts that the editor shows.
#[tokio::test]
async fn scenarios_of_a_project() {
    let task = "[[task]]\nname = \"t\"\ninterval = \"10ms\"\nprograms = [\"a.clad\", \"b.clad\"]\n";
    let plant = Plant::with(&[
        ("ladder.toml", task),
        ("a.clad", SOUND),
        ("b.clad", "+--[ ]( c )--( )( d )--+\n"),
    ]);
    let mut client = Client::new().await;
    let test = plant.uri("plant.ladder-test");
    let text =
        "program ladder.toml\nstep 100ms\n\nscenario \"both\"\na.a    _-\nb.c    -_\na.y => _-\nb.d => -_\n";
    open(&mut client, &test, "ladder-test", text).await;
    assert_eq!(published(&mut client, &test).await, []);
    let ask = json!({"command": "ladder.runScenarios", "arguments": [{"uri": test}]});
    let run = client.request("workspace/executeCommand", ask).await.unwrap();
    assert_eq!(run["scenarios"][0]["passed"], true, "{run}");
    client
        .open_as(&plant.uri("b.clad"), 1, "+--[ ]( c )--( )( other )--+\n")
        .await;
    // Before the program is changed the files of the folder may have been read once more.
    let found = loop {
        let found = published(&mut client, &test).await;
        if !found.is_empty() {
            break found;
        }
    };
    assert_eq!(found[0].0, span([7, 0, 7, 3]), "{found:?}");
    client.finish().await;
}

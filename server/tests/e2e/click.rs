//! Click programs in Python: read only when the client says that they are, checked and drawn while a person types.

use std::fmt::Write;

use serde_json::{Value, json};

use crate::client::{Answer, Client};
use crate::plant::Plant;

const TANK: &str = "\
def main():
    # Filled up to its limit.
    if all(c.Start, ds.Level < ds.Limit):
        out(y.Valve)

    if ds.Level >= ds.Limit:
        ton(
            t.Stir,
            2, Tm)

    if True:
        end()
";

const URI: &str = "file:///plant/tank.py";

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

/// The diagnostics of a version: `line:character code message`, from 0.
async fn published(client: &mut Client, uri: &str, version: i32) -> Vec<String> {
    let found = client
        .notification("textDocument/publishDiagnostics", |it| {
            it["uri"] == uri && it["version"] == version
        })
        .await;
    let found = found["diagnostics"].as_array().unwrap().iter().map(shown);
    found.collect()
}

fn shown(found: &Value) -> String {
    let start = &found["range"]["start"];
    let (code, message) = (
        found["code"].as_str().unwrap(),
        found["message"].as_str().unwrap(),
    );
    format!("{}:{} {code} {message}", start["line"], start["character"])
}

async fn hover(client: &mut Client, uri: &str, line: u32) -> Value {
    let params = json!({"textDocument": {"uri": uri}, "position": {"line": line, "character": 9}});
    client.request("textDocument/hover", params).await.unwrap()
}

async fn command(client: &mut Client, command: &str, argument: Value) -> Answer {
    let params = json!({"command": command, "arguments": [argument]});
    client.request("workspace/executeCommand", params).await
}

#[tokio::test]
async fn python_files_are_nobodys_unless_a_person_says_so() {
    let mut client = Client::new().await;
    open(&mut client, URI, "python", TANK).await;
    assert_eq!(published(&mut client, URI, 1).await, [""; 0]);
    assert_eq!(hover(&mut client, URI, 3).await, Value::Null);
    let (code, message) = command(&mut client, "ladder.preview", json!({"uri": URI}))
        .await
        .unwrap_err();
    assert_eq!(code, -32803);
    assert!(
        message.contains("not open as a program of another system"),
        "{message}"
    );
    replace(&mut client, URI, 2, "import os\n").await;
    assert_eq!(published(&mut client, URI, 2).await, [""; 0]);
    client.finish().await;
}

#[tokio::test]
async fn what_is_wrong_is_shown_at_its_place_while_a_person_types() {
    let mut client = Client::new().await;
    open(&mut client, URI, "ladder-click", TANK).await;
    assert_eq!(published(&mut client, URI, 1).await, [""; 0]);
    // The checks of Click.
    let text = TANK.replace(
        "    if True:\n        end()\n",
        "    if c.Start:\n        out(y.Valve)\n",
    );
    replace(&mut client, URI, 2, &text).await;
    let found = published(&mut client, URI, 2).await;
    let has = |place: &str| {
        assert!(
            found.iter().any(|it| it.starts_with(place)),
            "{place}: {found:#?}"
        );
    };
    has("0:4 click-c0201 ");
    has("11:8 click-c1001 ");
    // What is not of the language, each at its place.
    let text = "import os\ndef main():\n    if c.A and c.B:\n        out(y.C)\n    else:\n        out(y.D)\n";
    replace(&mut client, URI, 3, text).await;
    let found = published(&mut client, URI, 3).await;
    let expected = [
        "0:0 bad-program an import outside a function is not in the DSL",
        "2:7 bad-program `and` is not in the DSL: write all(a, b)",
        "4:4 bad-program `else` is not in the DSL: write a rung of its own with nc(..)",
    ];
    assert_eq!(found, expected);
    // No Python.
    replace(&mut client, URI, 4, "def main():\n    if c.A\n").await;
    let found = published(&mut client, URI, 4).await;
    assert_eq!(found.len(), 1, "{found:?}");
    assert!(
        found[0].starts_with("1:10 bad-program this is not Python: "),
        "{found:?}"
    );
    let close = json!({"textDocument": {"uri": URI}});
    client.notify("textDocument/didClose", close).await;
    let gone = client
        .notification("textDocument/publishDiagnostics", |_| true)
        .await;
    assert_eq!(gone["diagnostics"], json!([]));
    client.finish().await;
}

#[tokio::test]
async fn a_hover_shows_what_a_line_becomes() {
    let mut client = Client::new().await;
    open(&mut client, URI, "ladder-click", TANK).await;
    let mut told = String::new();
    for line in 0..TANK.lines().count() as u32 {
        let found = hover(&mut client, URI, line).await;
        let text = found["contents"]["value"].as_str().unwrap_or("nothing");
        writeln!(
            told,
            "{line}: {}",
            text.trim_matches('`').trim_start_matches("clad\n").trim_end()
        )
        .unwrap();
    }
    let valve = "+--[ ]( Start )--[LT]( Level, Limit )----------------------------( )( Valve )--+";
    let stir = "+--[GE]( Level, Limit )------------------------[TON]( Stir, T#2m, B := T#1m )--+";
    let end = "+-----------------------------------------------------------------------<RET>--+";
    assert_eq!(
        told,
        format!(
            "0: nothing\n1: nothing\n2: {valve}\n3: {valve}\n4: nothing\n5: {stir}\n6: {stir}\n7: {stir}\n8: {stir}\n\
             9: nothing\n10: {end}\n11: {end}\n"
        )
    );
    // What has no counterpart, with the reason.
    let text = "def main():\n    if c.A:\n        search('eq', 'OK', txt[1], txt[9], ds.At, c.Hit)\n    if True:\n        end()\n";
    replace(&mut client, URI, 2, text).await;
    let found = hover(&mut client, URI, 2).await;
    let text = found["contents"]["value"].as_str().unwrap_or_default();
    assert!(text.contains("**no counterpart** `search("), "{found}");
    client.finish().await;
}

#[tokio::test]
async fn the_ladder_text_is_followed() {
    let mut client = Client::new().await;
    open(&mut client, URI, "ladder-click", TANK).await;
    let begun = command(&mut client, "ladder.preview", json!({"uri": URI}))
        .await
        .unwrap();
    assert_eq!((&begun["uri"], &begun["version"]), (&json!(URI), &json!(1)));
    assert!(
        begun["text"].as_str().unwrap().contains("( )( Valve )"),
        "{begun}"
    );
    // Broken while a person types: what was sent last stays.
    replace(&mut client, URI, 2, &TANK.replace("y.Valve", "y.")).await;
    assert_eq!(published(&mut client, URI, 2).await.len(), 1);
    replace(&mut client, URI, 3, &TANK.replace("y.Valve", "y.Inlet")).await;
    let preview = client.notification("ladder/preview", |_| true).await;
    assert_eq!((&preview["uri"], &preview["version"]), (&json!(URI), &json!(3)));
    assert!(
        preview["text"].as_str().unwrap().contains("( )( Inlet )"),
        "{preview}"
    );
    // The same text is not sent twice, and nobody follows what is closed.
    replace(&mut client, URI, 4, &TANK.replace("(y.Valve", "( y.Inlet")).await;
    published(&mut client, URI, 4).await;
    client
        .notify("textDocument/didClose", json!({"textDocument": {"uri": URI}}))
        .await;
    open(&mut client, URI, "ladder-click", TANK).await;
    published(&mut client, URI, 1).await;
    assert_eq!(client.arrived("ladder/preview"), [Value::Null; 0]);
    client.finish().await;
}

#[tokio::test]
async fn a_client_that_asks_for_diagnostics_is_reported_the_ladder_text_too() {
    let capabilities = json!({"textDocument": {"diagnostic": {}}});
    let mut client = Client::with(capabilities).await;
    open(
        &mut client,
        URI,
        "ladder-click",
        &TANK.replace("y.Valve", "y[999]"),
    )
    .await;
    let params = json!({"textDocument": {"uri": URI}});
    let answer = client.request("textDocument/diagnostic", params).await.unwrap();
    let found: Vec<_> = answer["items"].as_array().unwrap().iter().map(shown).collect();
    assert!(found.iter().any(|it| it.starts_with("3:")), "{found:?}");
    replace(&mut client, URI, 2, TANK).await;
    command(&mut client, "ladder.preview", json!({"uri": URI}))
        .await
        .unwrap();
    replace(&mut client, URI, 3, &TANK.replace("y.Valve", "y.Inlet")).await;
    let preview = client.notification("ladder/preview", |_| true).await;
    assert_eq!(preview["version"], 3);
    assert_eq!(
        client.arrived("textDocument/publishDiagnostics"),
        [Value::Null; 0]
    );
    client.finish().await;
}

#[tokio::test]
async fn what_runs_is_the_ladder_text() {
    let mut client = Client::new().await;
    open(&mut client, URI, "ladder-click", TANK).await;
    let (code, message) = client.simulate("start", json!({"uri": URI})).await.unwrap_err();
    assert_eq!(code, -32803);
    assert!(message.contains("open that"), "{message}");
    let preview = command(&mut client, "ladder.preview", json!({"uri": URI}))
        .await
        .unwrap();
    let drawing = "ladder-click:/plant/tank.py.clad";
    let text = preview["text"].as_str().unwrap();
    open(&mut client, drawing, "clad", text).await;
    let started = client.simulate("start", json!({"uri": drawing})).await.unwrap();
    assert_eq!(started["state"]["uri"], drawing);
    let session = &started["session"];
    client
        .simulate("set", json!({"session": session, "tag": "Start", "value": true}))
        .await
        .unwrap();
    client
        .simulate("set", json!({"session": session, "tag": "Limit", "value": 5}))
        .await
        .unwrap();
    let state = client
        .simulate("step", json!({"session": session}))
        .await
        .unwrap();
    let tags = state["tags"].as_array().unwrap();
    assert_eq!(
        tags.iter().find(|tag| tag["name"] == "Valve").unwrap()["value"],
        true
    );
    assert!(
        state["power"]
            .as_array()
            .unwrap()
            .iter()
            .any(|it| it["on"] == true)
    );
    client.finish().await;
}

#[tokio::test]
async fn an_open_program_has_the_nicknames_that_lie_next_to_it() {
    let nicknames =
        "Address,Data Type,Nickname,Initial Value,Retentive,Address Comment\nY001,BIT,Valve,0,No,\n";
    let plant = Plant::with(&[("my tank_nicknames.csv", nicknames)]);
    let mut client = Client::new().await;
    let uri = plant.uri("my%20tank.py");
    // Nothing in it says that it is a program: the language does.
    let text = "def main():\n    if x[1]:\n        out(y[1])\n    if True:\n        end()\n";
    open(&mut client, &uri, "ladder-click", text).await;
    let answer = command(&mut client, "ladder.convert", json!({"uri": uri}))
        .await
        .unwrap();
    assert_eq!(
        (&answer["from"], &answer["refused"]),
        (&json!("click"), &json!(0))
    );
    let preview = command(&mut client, "ladder.preview", json!({"uri": uri}))
        .await
        .unwrap();
    assert_eq!(preview["text"], answer["text"]);
    assert!(
        preview["text"].as_str().unwrap().contains("( )( Valve )"),
        "{preview}"
    );
    // The file is another one now.
    plant.write("my tank_nicknames.csv", &nicknames.replace("Valve", "Inlet"));
    let changed = json!({"changes": [{"uri": plant.uri("my%20tank_nicknames.csv"), "type": 2}]});
    client.notify("workspace/didChangeWatchedFiles", changed).await;
    let preview = client.notification("ladder/preview", |_| true).await;
    assert_eq!(preview["version"], 1);
    assert!(
        preview["text"].as_str().unwrap().contains("( )( Inlet )"),
        "{preview}"
    );
    client.finish().await;
}

#[tokio::test]
async fn hostile_files_are_refused_and_none_is_run() {
    let plant = Plant::with(&[("a.clad", "")]);
    let planted = plant.folder.path().join("planted");
    let code = format!(
        "open({:?}, 'w')\ndef main():\n    if __import__('os').system('touch {}'):\n        out(y[1])\n",
        planted,
        planted.display()
    );
    let deep = format!(
        "def main():\n    if {}c.A{}:\n        out(y.B)\n",
        "(\n".repeat(100_000),
        ")\n".repeat(100_000)
    );
    let large = format!(
        "def main():\n{}",
        "    if c.A:\n        out(y.B)\n".repeat(50_000)
    );
    let mut client = Client::new().await;
    let uri = plant.uri("tank.py");
    open(&mut client, &uri, "ladder-click", &code).await;
    let found = published(&mut client, &uri, 1).await;
    assert!(
        found.iter().all(|it| it.contains(" bad-program ")) && found.len() >= 2,
        "{found:?}"
    );
    assert_eq!(hover(&mut client, &uri, 2).await, Value::Null);
    command(&mut client, "ladder.preview", json!({"uri": uri}))
        .await
        .unwrap_err();
    assert!(!planted.exists());
    for (version, (text, says)) in [(deep, "nests too deeply"), (large, "more than 1 MB")]
        .iter()
        .enumerate()
    {
        let version = version as i32 + 2;
        replace(&mut client, &uri, version, text).await;
        let found = published(&mut client, &uri, version).await;
        assert_eq!(found.len(), 1, "{says}");
        assert!(found[0].contains(says), "{found:?}");
    }
    // Many errors: so many as an editor shows.
    let wrong = format!(
        "def main():\n{}",
        "    if a and b:\n        out(y.B)\n".repeat(2_000)
    );
    replace(&mut client, &uri, 4, &wrong).await;
    assert_eq!(published(&mut client, &uri, 4).await.len(), 1_001);
    client.finish().await;
}

//! `ladder lsp --mirror` and `--replay`: a session is recorded, and says the same when it is played again.

use crate::harness::Folder;
use serde_json::{Value, json};

const URI: &str = "file:///plant/motor.clad";

/// A session as a client's bytes: its messages in their frames, and one that is none.
fn session() -> Vec<u8> {
    // A process that is long gone when the session is played again.
    let gone = 4_000_000;
    let mut messages = vec![
        json!({"id": 1, "method": "initialize", "params": {"processId": gone, "capabilities": {}}}),
        json!({"method": "initialized", "params": {}}),
        json!({"method": "textDocument/didOpen", "params": {"textDocument": {
            "uri": URI, "languageId": "clad", "version": 1, "text": "+--[ ]( start )--( )( run )--+\n"
        }}}),
    ];
    for version in 2..40 {
        let range = json!({"start": {"line": 0, "character": 8}, "end": {"line": 0, "character": 8}});
        messages.push(json!({"method": "textDocument/didChange", "params": {
            "textDocument": {"uri": URI, "version": version},
            "contentChanges": [{"range": range, "text": if version % 3 == 0 { "/" } else { "x" }}]
        }}));
        let place = json!({"textDocument": {"uri": URI}, "position": {"line": 0, "character": 9}});
        messages.push(json!({"id": version, "method": "textDocument/hover", "params": place}));
    }
    let document = json!({"textDocument": {"uri": URI}, "options": {"tabSize": 4, "insertSpaces": true}});
    messages.push(json!({"id": 90, "method": "textDocument/formatting", "params": document}));
    messages.push(json!({"id": 91, "method": "shutdown"}));
    messages.push(json!({"method": "exit"}));
    let mut bytes = Vec::new();
    for mut message in messages {
        message["jsonrpc"] = "2.0".into();
        if message["method"] == "shutdown" {
            bytes.extend(b"Content-Length: 3\r\n\r\n\xff{}");
        }
        let body = message.to_string();
        bytes.extend(format!("Content-Length: {}\r\n\r\n{body}", body.len()).bytes());
    }
    bytes
}

#[test]
fn a_recorded_session_says_the_same_each_time() {
    let folder = Folder::with(&[]);
    let ladder = env!("CARGO_BIN_EXE_ladder");
    let session = session();
    let recorded = folder.run(ladder, &["lsp", "--mirror", "session.rec"], &session, &[]);
    assert!(recorded.stdout.contains("\"capabilities\""), "{recorded}");
    let played = folder.ladder(&["lsp", "--replay", "session.rec"]);
    assert_eq!(played.status, Some(0), "{played}");
    assert_eq!(
        played.stdout,
        folder.ladder(&["lsp", "--replay", "session.rec"]).stdout
    );

    let told: Vec<Value> = played
        .stdout
        .lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect();
    // Every request has its answer, and in steps every version has its diagnostics.
    for id in (1..40).chain([90, 91]) {
        assert_eq!(
            told.iter().filter(|it| it["id"] == id).count(),
            1,
            "answers to {id}"
        );
    }
    let published = told
        .iter()
        .filter(|it| it["method"] == "textDocument/publishDiagnostics");
    let versions: Vec<&Value> = published.map(|it| &it["params"]["version"]).collect();
    assert_eq!(
        versions,
        (1..40)
            .map(Value::from)
            .collect::<Vec<_>>()
            .iter()
            .collect::<Vec<_>>()
    );
    assert!(played.stdout.contains("not UTF-8"), "{played}");
}

#[test]
fn a_recording_can_be_played_by_its_own_clock() {
    let folder = Folder::with(&[]);
    folder.run(
        env!("CARGO_BIN_EXE_ladder"),
        &["lsp", "--mirror", "session.rec"],
        &session(),
        &[],
    );
    let played = folder.ladder(&["lsp", "--replay", "session.rec", "--speed", "2"]);
    assert_eq!(played.status, Some(0), "{played}");
    assert!(
        played.stdout.starts_with("{\"id\":1,") || played.stdout.contains("\"capabilities\""),
        "{played}"
    );
}

#[test]
fn what_is_no_recording_is_refused() {
    let folder = Folder::with(&[("motor.clad", "+--[ ]( a )--( )( y )--+\n")]);
    let run = folder.ladder(&["lsp", "--replay", "motor.clad"]);
    assert_eq!(run.status, Some(2));
    assert_eq!(
        run.stderr,
        "motor.clad: this is not a recording; make one with ladder lsp --mirror FILE\n"
    );
    let run = folder.ladder(&["lsp", "--mirror", "nowhere/session.rec"]);
    assert_eq!(run.status, Some(2));
    assert!(
        run.stderr
            .starts_with("the session cannot be recorded in nowhere/session.rec: "),
        "{run}"
    );
    for arguments in [
        &["lsp", "--speed", "2"][..],
        &["lsp", "--replay", "a", "--mirror", "b"],
        &["lsp", "--replay", "a", "--speed", "0"],
    ] {
        assert_eq!(folder.ladder(arguments).status, Some(2), "{arguments:?}");
    }
}

//! Files of one workspace: what is not open counts as it is on disk, what is open as the editor shows it.

use std::fs;

use serde_json::{Value, json};

use crate::client::Client;
use crate::plant::Plant;

const LIBRARY: &str = "VAR_GLOBAL total : DINT; END_VAR\n+--<FUN>( count )--[ADD]( total, total, 1 )--+\n";
const MAIN: &str = "+--<CALL>( count )--[GT]( total, 3 )--( )( y )--+\n";

async fn published(client: &mut Client, uri: &str) -> Vec<String> {
    let found = client
        .notification("textDocument/publishDiagnostics", |it| it["uri"] == uri)
        .await;
    let found = found["diagnostics"].as_array().unwrap().clone();
    let code = |it: &Value| it["code"].as_str().unwrap().to_owned();
    found.iter().map(code).collect()
}

async fn replace(client: &mut Client, uri: &str, version: i32, text: &str) {
    let params = json!({
        "textDocument": {"uri": uri, "version": version},
        "contentChanges": [{"text": text}]
    });
    client.notify("textDocument/didChange", params).await;
}

async fn watched(client: &mut Client, uri: &str) {
    let params = json!({"changes": [{"uri": uri, "type": 2}]});
    client.notify("workspace/didChangeWatchedFiles", params).await;
}

const NONE: [&str; 0] = [];

#[tokio::test]
async fn files_that_are_not_open_count() {
    let plant = Plant::with(&[("library.clad", LIBRARY)]);
    let mut client = Client::new().await;
    let main = plant.uri("main.clad");
    client.open_as(&main, 1, MAIN).await;
    assert_eq!(published(&mut client, &main).await, NONE);
    client.finish().await;
}

#[tokio::test]
async fn an_open_text_wins_and_dependents_follow_it() {
    let plant = Plant::with(&[("library.clad", LIBRARY), ("main.clad", MAIN)]);
    let mut client = Client::new().await;
    let (main, library) = (plant.uri("main.clad"), plant.uri("library.clad"));
    client.open_as(&main, 1, MAIN).await;
    assert_eq!(published(&mut client, &main).await, NONE);
    client.open_as(&library, 1, LIBRARY).await;
    assert_eq!(published(&mut client, &library).await, NONE);
    replace(&mut client, &library, 2, &LIBRARY.replace("count", "counted")).await;
    assert_eq!(published(&mut client, &main).await, ["unknown-function"]);
    // A change that nobody else sees: nothing is published again for the other file.
    replace(
        &mut client,
        &library,
        3,
        &LIBRARY.replace("count", "counted").replace(", 1 )", ", 2 )"),
    )
    .await;
    assert_eq!(published(&mut client, &library).await, NONE);
    replace(
        &mut client,
        &library,
        4,
        &LIBRARY.replace("total : DINT", "total : STRING"),
    )
    .await;
    assert_eq!(published(&mut client, &main).await, ["type-mismatch"]);
    // Closed without being saved: the text on disk counts again.
    client
        .notify("textDocument/didClose", json!({"textDocument": {"uri": library}}))
        .await;
    assert_eq!(published(&mut client, &main).await, NONE);
    client.finish().await;
}

#[tokio::test]
async fn changed_made_and_removed_files_are_followed() {
    let plant = Plant::with(&[("main.clad", MAIN)]);
    let mut client = Client::new().await;
    let (main, library) = (plant.uri("main.clad"), plant.uri("library.clad"));
    client.open_as(&main, 1, MAIN).await;
    assert_eq!(published(&mut client, &main).await, ["unknown-function"]);
    plant.write("library.clad", LIBRARY);
    watched(&mut client, &library).await;
    assert_eq!(published(&mut client, &main).await, NONE);
    plant.write("library.clad", &LIBRARY.replace("DINT", "STRING"));
    watched(&mut client, &library).await;
    assert_eq!(published(&mut client, &main).await, ["type-mismatch"]);
    fs::remove_file(plant.folder.path().join("library.clad")).unwrap();
    watched(&mut client, &library).await;
    assert_eq!(published(&mut client, &main).await, ["unknown-function"]);
    client.finish().await;
}

#[tokio::test]
async fn settings_say_which_files_belong_to_it() {
    let plant = Plant::with(&[("main.clad", MAIN), ("lib/library.clad", LIBRARY)]);
    let mut client = Client::new().await;
    let main = plant.uri("main.clad");
    client.open_as(&main, 1, MAIN).await;
    assert_eq!(published(&mut client, &main).await, ["unknown-function"]);
    plant.write("ladder.toml", "[format]\nspacing = 3\n");
    watched(&mut client, &plant.uri("ladder.toml")).await;
    assert_eq!(published(&mut client, &main).await, NONE);
    let edits = client
        .request(
            "textDocument/formatting",
            json!({"textDocument": {"uri": main}, "options": {"tabSize": 4, "insertSpaces": true}}),
        )
        .await
        .unwrap();
    let inserted: Vec<&str> = edits
        .as_array()
        .unwrap()
        .iter()
        .filter_map(|edit| edit["newText"].as_str())
        .collect();
    assert_eq!(inserted[0], "---", "{edits}");
    plant.write("ladder.toml", "[workspace]\nexcluded = [\"lib\"]\n");
    watched(&mut client, &plant.uri("ladder.toml")).await;
    let shown = client
        .notification("textDocument/publishDiagnostics", |it| {
            it["uri"] == plant.uri("ladder.toml")
        })
        .await;
    assert_eq!(
        shown["diagnostics"][0]["message"],
        "`excluded` is not a setting in [workspace]: did you mean `exclude`?"
    );
    client.finish().await;
}

#[tokio::test]
async fn related_places_lie_in_the_other_file() {
    let plant = Plant::with(&[
        ("a b.clad", "\n+--<FUN>( f )--( )( z )--+\n"),
        ("c.clad", "+--<FUN>( f )--( )( z )--+\n"),
    ]);
    let mut client = Client::new().await;
    let main = plant.uri("main.clad");
    client.open_as(&main, 1, "+--<CALL>( f )--+\n").await;
    let found = client
        .notification("textDocument/publishDiagnostics", |it| it["uri"] == main)
        .await;
    let related = &found["diagnostics"][0]["relatedInformation"];
    let expected = plant.uri("a%20b.clad");
    assert_eq!(related[0]["location"]["uri"], expected);
    assert_eq!(
        related[0]["location"]["range"]["start"],
        json!({"line": 1, "character": 10})
    );
    assert_eq!(related[1]["location"]["uri"], plant.uri("c.clad"));
    client.finish().await;
}

#[tokio::test]
async fn a_simulation_runs_functions_of_other_files_and_faults_name_them() {
    let library = "VAR zero, n : INT; END_VAR\n+--<FUN>( count )--[ADD]( total, total, 1 )--[DIV]( n, 1, zero )--+\n\
                   VAR_GLOBAL total : DINT; END_VAR\n";
    let plant = Plant::with(&[("library.clad", library)]);
    let mut client = Client::new().await;
    let main = plant.uri("main.clad");
    client.open_as(&main, 1, MAIN).await;
    published(&mut client, &main).await;
    let started = client.simulate("start", json!({"uri": main})).await.unwrap();
    let session = started["session"].clone();
    let state = client
        .simulate("step", json!({"session": session, "scans": 4}))
        .await
        .unwrap();
    let tags = state["tags"].as_array().unwrap();
    let total = tags.iter().find(|tag| tag["name"] == "total").unwrap();
    assert_eq!(total["value"], 4);
    assert!(tags.iter().any(|tag| tag["name"] == "library.zero"), "{tags:?}");
    assert_eq!(state["faults"][0]["uri"], plant.uri("library.clad"));
    assert_eq!(
        state["faults"][0]["range"]["start"],
        json!({"line": 1, "character": 45})
    );
    client.finish().await;
}

#[tokio::test]
async fn a_hover_tells_of_the_other_files() {
    let plant = Plant::with(&[("library.clad", LIBRARY)]);
    let mut client = Client::new().await;
    let main = plant.uri("main.clad");
    client.open_as(&main, 1, MAIN).await;
    let params = json!({"textDocument": {"uri": main}, "position": {"line": 0, "character": 26}});
    let hover = client.request("textDocument/hover", params).await.unwrap();
    let text = hover["contents"]["value"].as_str().unwrap();
    assert!(text.contains("Read in this file: line [1]("), "{text}");
    assert!(
        text.ends_with("In `library.clad`: written once, read once"),
        "{text}"
    );
    client.finish().await;
}

/// What one file does with the tags and functions of another is reported where these are declared, as it is now.
#[tokio::test]
async fn what_nobody_uses_follows_the_files_that_could() {
    const SHARED: &str = "VAR_GLOBAL total : DINT; END_VAR\nVAR_OUTPUT y : BOOL; END_VAR\n\
        +--[ADD]( total, total, 1 )--( )( y )--+\n+--<FUN>( count )--( )( y )--+\n";
    let plant = Plant::with(&[("main.clad", "+--( )( z )--+\n")]);
    let mut client = Client::new().await;
    let (main, shared) = (plant.uri("main.clad"), plant.uri("shared.clad"));
    client.open_as(&shared, 1, SHARED).await;
    assert_eq!(published(&mut client, &shared).await, ["unused-function"]);
    client.open_as(&main, 1, "+--( )( z )--+\n").await;
    assert_eq!(published(&mut client, &main).await, NONE);
    replace(&mut client, &main, 2, "+--( )( z )--<CALL>( count )--+\n").await;
    let mut found = published(&mut client, &shared).await;
    if found == ["unused-function"] {
        // The other file was opened while the first one said what it offers: then that is checked once more.
        found = published(&mut client, &shared).await;
    }
    assert_eq!(found, NONE);
    // Half typed: the word may still mean it.
    replace(&mut client, &main, 3, "+--( )( z )--<CALL>( count\n").await;
    replace(&mut client, &main, 4, "+--( )( z )--+\n").await;
    assert_eq!(published(&mut client, &shared).await, ["unused-function"]);
    // Closed without being saved, then changed on disk.
    client
        .notify("textDocument/didClose", json!({"textDocument": {"uri": main}}))
        .await;
    plant.write("main.clad", "+--( )( z )--<CALL>( count )--+\n");
    watched(&mut client, &main).await;
    assert_eq!(published(&mut client, &shared).await, NONE);
    client.finish().await;
}

/// What `total` holds after one more scan.
async fn total_after_a_scan(client: &mut Client, session: &str) -> Value {
    let state = client
        .simulate("step", json!({"session": session}))
        .await
        .unwrap();
    let tags = state["tags"].as_array().unwrap();
    tags.iter().find(|tag| tag["name"] == "total").unwrap()["value"].clone()
}

/// Waits until a simulation has taken so many changes.
async fn changed(client: &mut Client, number: u64) {
    let is_there = |it: &Value| it["change"]["number"] == number;
    client.notification("ladder/simulationState", is_there).await;
}

#[tokio::test]
async fn what_is_inside_of_another_file_goes_into_what_runs() {
    let plant = Plant::with(&[("library.clad", LIBRARY), ("main.clad", MAIN)]);
    let mut client = Client::new().await;
    let (main, library) = (plant.uri("main.clad"), plant.uri("library.clad"));
    client.open_as(&main, 1, MAIN).await;
    client.open_as(&library, 1, LIBRARY).await;
    assert_eq!(published(&mut client, &library).await, NONE);
    let started = client.simulate("start", json!({"uri": main})).await.unwrap();
    let session = started["session"].as_str().unwrap().to_owned();
    assert_eq!(total_after_a_scan(&mut client, &session).await, 1);
    // Nothing that another file sees of it.
    replace(&mut client, &library, 2, &LIBRARY.replace(", 1 )", ", 10 )")).await;
    changed(&mut client, 1).await;
    assert_eq!(total_after_a_scan(&mut client, &session).await, 11);
    // Closed without being saved: the text on disk counts again.
    client
        .notify("textDocument/didClose", json!({"textDocument": {"uri": library}}))
        .await;
    changed(&mut client, 2).await;
    assert_eq!(total_after_a_scan(&mut client, &session).await, 12);
    plant.write("library.clad", &LIBRARY.replace(", 1 )", ", 100 )"));
    watched(&mut client, &library).await;
    changed(&mut client, 3).await;
    assert_eq!(total_after_a_scan(&mut client, &session).await, 112);
    client.finish().await;
}

/// A program with a function that nothing in it calls.
const UNCALLED: &str = "+--[ ]( a )--( )( y )--+\n+--<FUN>( count )--( )( z )--+\n";

#[tokio::test]
async fn a_call_in_a_file_that_is_read_later_counts() {
    let plant = Plant::with(&[
        ("ladder.toml", ""),
        ("a.clad", UNCALLED),
        ("b.clad", "+--[ ]( a )--<CALL>( count )--+\n"),
    ]);
    // At once after the start, while the folder is read in the background.
    let root = plant.uri("").trim_end_matches('/').to_owned();
    let mut client = Client::begun(json!({"processId": null, "rootUri": root, "capabilities": {}})).await;
    let a = plant.uri("a.clad");
    client.open_as(&a, 1, UNCALLED).await;
    while published(&mut client, &a)
        .await
        .contains(&"unused-function".to_owned())
    {}
    // Typed, where another file calls it already.
    replace(&mut client, &a, 2, &UNCALLED.replace("count", "other")).await;
    while !published(&mut client, &a)
        .await
        .contains(&"unused-function".to_owned())
    {}
    replace(&mut client, &a, 3, UNCALLED).await;
    while published(&mut client, &a)
        .await
        .contains(&"unused-function".to_owned())
    {}
    client.finish().await;
}

#[tokio::test]
async fn a_place_in_another_file_moves_with_its_text() {
    let global = |ty: &str| format!("VAR_GLOBAL total : {ty}; END_VAR\n+--[ ]( a )--( )( y )--+\n");
    let plant = Plant::with(&[("a.clad", &global("DINT")), ("b.clad", &global("INT"))]);
    let mut client = Client::new().await;
    let (a, b) = (plant.uri("a.clad"), plant.uri("b.clad"));
    client.open_as(&a, 1, &global("DINT")).await;
    client.open_as(&b, 1, &global("INT")).await;
    let named = |it: &Value, line: u64| {
        let all = it["diagnostics"].as_array().unwrap();
        let related = all
            .iter()
            .filter_map(|found| found["relatedInformation"].as_array());
        let mut related = related.flatten();
        related.any(|place| place["location"]["range"]["start"]["line"] == line)
    };
    client
        .notification("textDocument/publishDiagnostics", |it| {
            (it["uri"] == a || it["uri"] == b) && named(it, 0)
        })
        .await;
    for (uri, ty) in [(&a, "DINT"), (&b, "INT")] {
        replace(&mut client, uri, 2, &format!("\n\n\n{}", global(ty))).await;
    }
    client
        .notification("textDocument/publishDiagnostics", |it| {
            (it["uri"] == a || it["uri"] == b) && named(it, 3)
        })
        .await;
    client.finish().await;
}

#[tokio::test]
async fn a_hidden_file_is_seen_by_no_other() {
    let block = "FUNCTION_BLOCK [$Hidden]\n+--[ ]( EN )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n";
    let user = "+--[$Hidden]--( )( y )--+\n";
    for settings in [&[("ladder.toml", "")][..], &[]] {
        let plant = Plant::with(&[&[(".h.clad", block), ("a.clad", user)], settings].concat());
        let mut client = Client::new().await;
        let (hidden, a) = (plant.uri(".h.clad"), plant.uri("a.clad"));
        client.open_as(&a, 1, user).await;
        assert_eq!(published(&mut client, &a).await, ["unknown-block"]);
        client.open_as(&hidden, 1, block).await;
        published(&mut client, &hidden).await;
        replace(&mut client, &a, 2, &format!("{user}\n")).await;
        assert_eq!(published(&mut client, &a).await, ["unknown-block"]);
        client
            .notify("textDocument/didClose", json!({"textDocument": {"uri": hidden}}))
            .await;
        watched(&mut client, &hidden).await;
        published(&mut client, &hidden).await;
        replace(&mut client, &a, 3, user).await;
        assert_eq!(published(&mut client, &a).await, ["unknown-block"]);
        client.finish().await;
    }
}

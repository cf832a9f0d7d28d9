//! Folders that are open, and files that come and go.

use std::fs;

use serde_json::{Value, json};

use crate::client::Client;
use crate::plant::Plant;

const LIBRARY: &str = "+--<FUN>( count )--[ ]( go )--( )( counted )--+\n";
const MAIN: &str = "+--<CALL>( count )--+\n";
const NONE: [&str; 0] = [];

async fn published(client: &mut Client, uri: &str) -> Vec<String> {
    let found = client
        .notification("textDocument/publishDiagnostics", |it| it["uri"] == uri)
        .await;
    let code = |it: &Value| it["code"].as_str().unwrap().to_owned();
    found["diagnostics"]
        .as_array()
        .unwrap()
        .iter()
        .map(code)
        .collect()
}

async fn begun(folders: &[&Plant]) -> Client {
    let folders: Vec<Value> = folders
        .iter()
        .map(|plant| json!({"uri": plant.uri("").trim_end_matches('/'), "name": "plant"}))
        .collect();
    Client::begun(json!({"processId": null, "capabilities": {}, "workspaceFolders": folders})).await
}

#[tokio::test]
async fn settings_files_of_open_folders_are_checked_before_anything_is_opened() {
    let (one, two) = (
        Plant::with(&[("line/ladder.toml", "[formt]\n"), ("line/a.clad", MAIN)]),
        Plant::with(&[("ladder.toml", "lint = 1\n")]),
    );
    let mut client = begun(&[&one]).await;
    assert_eq!(
        published(&mut client, &one.uri("line/ladder.toml")).await,
        ["bad-setting"]
    );
    let folder = |plant: &Plant| json!({"uri": plant.uri("").trim_end_matches('/'), "name": "plant"});
    let params = json!({"event": {"added": [folder(&two)], "removed": [folder(&one)]}});
    client.notify("workspace/didChangeWorkspaceFolders", params).await;
    assert_eq!(published(&mut client, &one.uri("line/ladder.toml")).await, NONE);
    assert_eq!(
        published(&mut client, &two.uri("ladder.toml")).await,
        ["bad-setting"]
    );
    client.finish().await;
}

#[tokio::test]
async fn a_root_is_a_folder_too() {
    let plant = Plant::with(&[("ladder.toml", "[formt]\n")]);
    let root = plant.uri("").trim_end_matches('/').to_owned();
    let mut client = Client::begun(json!({"processId": null, "capabilities": {}, "rootUri": root})).await;
    assert_eq!(
        published(&mut client, &plant.uri("ladder.toml")).await,
        ["bad-setting"]
    );
    client.finish().await;
}

#[tokio::test]
async fn a_client_that_watches_nothing_is_served_all_the_same() {
    let plant = Plant::with(&[("main.clad", MAIN)]);
    let mut client = Client::with(json!({})).await;
    let main = plant.uri("main.clad");
    client.open_as(&main, 1, MAIN).await;
    assert_eq!(published(&mut client, &main).await, ["unknown-function"]);
    // Each of these is seen at the next change of the text, but the disk is checked now and then only.
    let mut version = 1;
    let mut until = async |client: &mut Client, wanted: &[&str]| {
        let begin = std::time::Instant::now();
        loop {
            version += 1;
            let params = json!({"textDocument": {"uri": main, "version": version}, "contentChanges": [{"text": MAIN}]});
            client.notify("textDocument/didChange", params).await;
            if published(client, &main).await == wanted {
                return;
            }
            assert!(begin.elapsed().as_secs() < 20, "never {wanted:?}");
            tokio::time::sleep(std::time::Duration::from_millis(100)).await;
        }
    };
    plant.write("library.clad", LIBRARY);
    until(&mut client, &NONE).await;
    fs::remove_file(plant.folder.path().join("library.clad")).unwrap();
    until(&mut client, &["unknown-function"]).await;
    plant.write("ladder.toml", "[lint]\nunknown-function = \"off\"\n");
    until(&mut client, &NONE).await;
    plant.write("ladder.toml", "");
    until(&mut client, &["unknown-function"]).await;
    plant.write("lib/library.clad", LIBRARY);
    until(&mut client, &NONE).await;
    fs::remove_file(plant.folder.path().join("ladder.toml")).unwrap();
    until(&mut client, &["unknown-function"]).await;
    client.finish().await;
}

#[tokio::test]
async fn a_saved_settings_file_counts_at_once() {
    let plant = Plant::with(&[("ladder.toml", ""), ("main.clad", MAIN)]);
    let mut client = Client::with(json!({})).await;
    let main = plant.uri("main.clad");
    client.open_as(&main, 1, MAIN).await;
    assert_eq!(published(&mut client, &main).await, ["unknown-function"]);
    plant.write("ladder.toml", "[lint]\nunknown-function = \"warn\"\n");
    let params = json!({"textDocument": {"uri": plant.uri("ladder.toml")}});
    client.notify("textDocument/didSave", params).await;
    let found = client
        .notification("textDocument/publishDiagnostics", |it| it["uri"] == main)
        .await;
    assert_eq!(found["diagnostics"][0]["severity"], 2);
    client.finish().await;
}

#[tokio::test]
async fn scenarios_follow_a_program_that_is_renamed() {
    let plant = Plant::with(&[
        ("motor.clad", MAIN),
        ("library.clad", LIBRARY),
        ("closed.ladder-test", "# of the motor #\nprogram motor.clad\n"),
        ("other.ladder-test", "program library.clad\n"),
    ]);
    let mut client = Client::silent();
    let operations = json!({"didCreate": true, "willRename": true, "didRename": true, "didDelete": true});
    let params = json!({"processId": null, "capabilities": {"workspace": {"fileOperations": operations}}});
    let offered = client.request("initialize", params).await.unwrap();
    let offered = &offered["capabilities"]["workspace"]["fileOperations"];
    assert_eq!(
        offered["willRename"]["filters"][0]["pattern"]["glob"],
        "**/*.{clad,ladder-test}"
    );
    client.notify("initialized", json!({})).await;
    let (motor, pump) = (plant.uri("motor.clad"), plant.uri("pump.clad"));
    let rename = json!({"files": [{"oldUri": motor, "newUri": pump}]});
    let edit = client
        .request("workspace/willRenameFiles", rename.clone())
        .await
        .unwrap();
    let range = crate::client::span([1, 8, 1, 18]);
    assert_eq!(
        edit,
        json!({"changes": {plant.uri("closed.ladder-test"): [{"range": range, "newText": "pump.clad"}]}})
    );
    // Files that come and go are followed without being watched.
    client.open_as(&motor, 1, MAIN).await;
    assert_eq!(published(&mut client, &motor).await, NONE);
    let folder = plant.folder.path();
    fs::rename(folder.join("library.clad"), folder.join("library.old")).unwrap();
    let gone = json!({"files": [{"oldUri": plant.uri("library.clad"), "newUri": plant.uri("library.old")}]});
    client.notify("workspace/didRenameFiles", gone).await;
    assert_eq!(published(&mut client, &motor).await, ["unknown-function"]);
    plant.write("new.clad", LIBRARY);
    let made = json!({"files": [{"uri": plant.uri("new.clad")}]});
    client.notify("workspace/didCreateFiles", made).await;
    assert_eq!(published(&mut client, &motor).await, NONE);
    fs::remove_file(folder.join("new.clad")).unwrap();
    let deleted = json!({"files": [{"uri": plant.uri("new.clad")}]});
    client.notify("workspace/didDeleteFiles", deleted).await;
    assert_eq!(published(&mut client, &motor).await, ["unknown-function"]);
    client.finish().await;
}

//! A folder that a user sent: what it names lies inside of it, and to open it writes nothing.
#![cfg(unix)]

use std::collections::BTreeMap;
use std::fs;
use std::os::unix::fs::symlink;
use std::path::{Path, PathBuf};
use std::process::Command;

use serde_json::{Value, json};

use crate::client::Client;
use crate::plant::Plant;

const KEEPS: &str = "VAR RETAIN n : INT; END_VAR\n+--[ADD]( n, n, 1 )--+\n";

/// What lies below a folder: names, and what files hold.
fn everything(folder: &Path) -> BTreeMap<PathBuf, Option<Vec<u8>>> {
    let mut found = BTreeMap::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).unwrap() {
            let entry = entry.unwrap();
            let kind = entry.file_type().unwrap();
            if kind.is_dir() {
                folders.push(entry.path());
            }
            let content = kind.is_file().then(|| fs::read(entry.path()).unwrap());
            found.insert(entry.path(), content);
        }
    }
    found
}

fn pipe(plant: &Plant, name: &str) {
    let made = Command::new("mkfifo")
        .arg(plant.folder.path().join(name))
        .status();
    assert!(made.unwrap().success());
}

async fn open(client: &mut Client, plant: &Plant, name: &str, language: &str) {
    let text = fs::read_to_string(plant.folder.path().join(name)).unwrap();
    let document = json!({"uri": plant.uri(name), "languageId": language, "version": 1, "text": text});
    client
        .notify("textDocument/didOpen", json!({"textDocument": document}))
        .await;
}

/// The sentences about a file.
async fn said_of(client: &mut Client, plant: &Plant, name: &str) -> String {
    let uri = plant.uri(name);
    let found = client
        .notification("textDocument/publishDiagnostics", |it| it["uri"] == uri)
        .await;
    let found = found["diagnostics"].as_array().unwrap().iter();
    let found: Vec<&str> = found.map(|it| it["message"].as_str().unwrap()).collect();
    found.join("\n")
}

#[tokio::test]
async fn scenarios_that_are_opened_read_nothing_outside_and_wait_for_nothing() {
    let scenarios = |program: &str| format!("program \"{program}\"\nstep 10ms\n");
    let plant = Plant::with(&[
        ("secret.clad", "+--[ ]( a )--( )( y )--+\n"),
        ("plant/ladder.toml", "[simulate]\nretain = \"../profile\"\n"),
        ("plant/up.ladder-test", &scenarios("../secret.clad")),
        ("plant/whole.ladder-test", &scenarios("/dev/zero")),
        ("plant/host.ladder-test", &scenarios("\\\\host\\share\\a.clad")),
        ("plant/link.ladder-test", &scenarios("link.clad")),
        ("plant/pipe.ladder-test", &scenarios("pipe.clad")),
        (
            "plant/a.clad",
            "# see ../secret.clad and link.clad and a.clad #\n+--[ ]( a )--( )( y )--+\n",
        ),
    ]);
    symlink("../secret.clad", plant.folder.path().join("plant/link.clad")).unwrap();
    pipe(&plant, "plant/pipe.clad");
    pipe(&plant, "plant/.ignore");
    let before = everything(plant.folder.path());
    let root = plant.uri("plant");
    let mut client = Client::begun(json!({
        "processId": null, "rootUri": root, "capabilities": {},
        "workspaceFolders": [{"uri": root, "name": "plant"}]
    }))
    .await;
    for (name, sentence) in [
        ("up", "this leads out of the workspace"),
        ("whole", "a path in a workspace is relative"),
        ("host", "a path in a workspace is relative"),
        ("link", "this leads out of the workspace"),
        ("pipe", "this is a pipe, and only a regular file is used here"),
    ] {
        let file = format!("plant/{name}.ladder-test");
        open(&mut client, &plant, &file, "ladder-test").await;
        let told = said_of(&mut client, &plant, &file).await;
        assert!(told.contains(sentence), "{name}: {told}");
    }
    open(&mut client, &plant, "plant/ladder.toml", "toml").await;
    // Findings in the file on disk may come first, and be taken back.
    let mut told = String::new();
    while told.is_empty() {
        told = said_of(&mut client, &plant, "plant/ladder.toml").await;
    }
    assert!(
        told.contains("`retain` cannot be used: this leads out of the workspace"),
        "{told}"
    );
    open(&mut client, &plant, "plant/a.clad", "clad").await;
    let params = json!({"textDocument": {"uri": plant.uri("plant/a.clad")}});
    let links = client.request("textDocument/documentLink", params).await.unwrap();
    let links: Vec<&Value> = links.as_array().unwrap().iter().map(|it| &it["target"]).collect();
    assert_eq!(links, [&json!(plant.uri("plant/a.clad"))]);
    client.finish().await;
    assert_eq!(everything(plant.folder.path()), before);
}

#[tokio::test]
async fn a_simulation_keeps_nothing_in_a_file_of_others() {
    let plant = Plant::with(&[
        ("profile", "export PATH=/bin\n"),
        ("plant/ladder.toml", "[simulate]\nretain = \"kept\"\n"),
        ("plant/a.clad", KEEPS),
    ]);
    let kept = plant.folder.path().join("plant/kept");
    for (content, sentence) in [
        (None, "this leads out of the workspace"),
        (
            Some("# a script\n"),
            "this is not a file of retentive values, and it stays as it is",
        ),
        (
            Some(""),
            "this is not a file of retentive values, and it stays as it is",
        ),
    ] {
        match content {
            None => symlink("../profile", &kept).unwrap(),
            Some(content) => {
                fs::remove_file(&kept).unwrap();
                fs::write(&kept, content).unwrap();
            }
        }
        let before = everything(plant.folder.path());
        let mut client = Client::new().await;
        let uri = plant.uri("plant/a.clad");
        client.open_as(&uri, 1, KEEPS).await;
        let answer = client.simulate("start", json!({"uri": uri})).await.unwrap();
        let note = answer["notes"][0].as_str().unwrap();
        assert!(note.contains(sentence), "{note}");
        let step = json!({"session": answer["session"], "scans": 5});
        client.simulate("step", step).await.unwrap();
        client
            .simulate("stop", json!({"session": answer["session"]}))
            .await
            .unwrap();
        client.finish().await;
        assert_eq!(everything(plant.folder.path()), before);
    }
}

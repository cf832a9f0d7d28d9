//! The operations of the diagram: each a drawing, what is done, and the drawing behind it.

use std::path::{Path, PathBuf};

use serde_json::{Map, Value, json};

use crate::client::{Answer, Client, URI};

/// The folders of cases: of this project, and where more are.
fn cases() -> Vec<PathBuf> {
    let own = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/corpus/drawing");
    let more = std::env::var_os("LADDER_CORPUS").map(|corpus| Path::new(&corpus).join("drawing"));
    let folders = std::iter::once(own).chain(more).filter(|folder| folder.is_dir());
    let cases = folders.flat_map(|folder| std::fs::read_dir(folder).unwrap());
    let mut cases: Vec<PathBuf> = cases.map(|case| case.unwrap().path()).collect();
    cases.sort();
    cases
}

fn read(case: &Path, name: &str) -> String {
    std::fs::read_to_string(case.join(name)).unwrap()
}

fn position(place: &Value) -> Value {
    json!({"line": place[0], "character": place[1]})
}

fn range(places: &Value) -> Value {
    json!({"start": position(&places[0]), "end": position(&places[1])})
}

/// An operation as the protocol has it: places are pairs of numbers in the cases.
fn edit(operation: &Value) -> Value {
    let op = operation["op"].as_str().unwrap();
    let mut edit = Map::new();
    for (name, value) in operation.as_object().unwrap() {
        let value = match (name.as_str(), op) {
            ("note" | "means", _) => continue,
            ("to", "move") => json!({"at": position(&value["at"])}),
            ("at" | "from" | "to", _) | ("what", "branchEnd" | "close") => position(value),
            ("what", "delete" | "move") => value.as_array().unwrap().iter().map(range).collect(),
            ("what", _) => range(value),
            _ => value.clone(),
        };
        edit.insert(name.clone(), value);
    }
    Value::Object(edit)
}

pub(crate) async fn asked(client: &mut Client, command: &str, argument: Value) -> Answer {
    let params = json!({"command": command, "arguments": [argument]});
    client.request("workspace/executeCommand", params).await
}

async fn edited(client: &mut Client, version: i64, edit: Value) -> Answer {
    asked(
        client,
        "ladder.diagramEdit",
        json!({"uri": URI, "version": version, "edit": edit}),
    )
    .await
}

/// The offset of a position in UTF-16.
fn offset(text: &str, place: &Value) -> usize {
    let (line, character) = (
        place["line"].as_u64().unwrap(),
        place["character"].as_u64().unwrap(),
    );
    let lines = text.split_inclusive('\n').take(line as usize);
    let start: usize = lines.map(str::len).sum();
    let mut units = 0;
    let within = text[start..].char_indices().find(|(_, c)| {
        let is_there = units >= character as usize;
        units += c.len_utf16();
        is_there
    });
    start + within.map_or(text[start..].len(), |(at, _)| at)
}

/// A text with the edits of an answer, which are sorted and do not touch.
fn applied(text: &str, edited: &Value) -> String {
    let mut new = text.to_owned();
    let mut next = usize::MAX;
    for edit in edited["edits"].as_array().unwrap().iter().rev() {
        let [start, end] = ["start", "end"].map(|end| offset(text, &edit["range"][end]));
        assert!(start <= end && end < next, "{edited}");
        new.replace_range(start..end, edit["newText"].as_str().unwrap());
        next = start;
    }
    new
}

#[tokio::test]
async fn each_operation_gives_its_drawing() {
    let mut failed = Vec::new();
    let cases = cases();
    assert!(cases.len() >= 24);
    for case in cases {
        let mut client = Client::with_encoding("utf-16").await;
        let before = read(&case, "before.clad");
        client.open(&before).await;
        let operation: Value = serde_json::from_str(&read(&case, "operation.json")).unwrap();
        let got = match edited(&mut client, 1, edit(&operation)).await {
            Ok(answer) => applied(&before, &answer),
            Err((code, message)) => format!("{code}: {message}\n"),
        };
        let after = read(&case, "after.clad");
        if got != after {
            failed.push(format!("{}\nwant\n{after}\ngot\n{got}", case.display()));
        }
        client.finish().await;
    }
    assert!(failed.is_empty(), "{}", failed.join("\n"));
}

//! What an editor asks of an open scenario file, over the protocol.

use serde_json::{Value, json};

use crate::client::{Client, span};
use crate::features::edited;
use crate::plant::Plant;

const PROGRAM: &str = "VAR_INPUT start : BOOL; END_VAR\nVAR_OUTPUT run : BOOL; END_VAR\n+--[ ]( start )----------( )( run )--+\n";
const SCENARIOS: &str = "program main.clad\nstep 100ms\n\nscenario \"one\"\nstart _-\nrun => _-\n";

/// A client that has the scenarios open, and the address of a file by its name.
async fn opened(files: &[(&str, &str)]) -> (Client, Plant, String) {
    let plant = Plant::with(files);
    let mut client = Client::new().await;
    let uri = plant.uri("main.ladder-test");
    let text = files
        .iter()
        .find(|(name, _)| *name == "main.ladder-test")
        .unwrap()
        .1;
    let document = json!({"uri": uri, "languageId": "ladder-test", "version": 3, "text": text});
    client
        .notify("textDocument/didOpen", json!({"textDocument": document}))
        .await;
    (client, plant, uri)
}

async fn ask(client: &mut Client, what: &str, uri: &str, at: (u32, u32), more: Value) -> Value {
    let mut params = json!({
        "textDocument": {"uri": uri},
        "position": {"line": at.0, "character": at.1},
    });
    params
        .as_object_mut()
        .unwrap()
        .extend(more.as_object().unwrap().clone());
    client
        .request(&format!("textDocument/{what}"), params)
        .await
        .unwrap()
}

#[tokio::test]
async fn a_row_is_about_a_tag_of_a_program_that_nobody_has_open() {
    let (mut client, plant, uri) = opened(&[("main.clad", PROGRAM), ("main.ladder-test", SCENARIOS)]).await;
    let hover = ask(&mut client, "hover", &uri, (5, 1), json!({})).await;
    let told = hover["contents"]["value"].as_str().unwrap();
    assert!(
        told.contains("run : BOOL") && told.contains("VAR_OUTPUT"),
        "{told}"
    );
    assert_eq!(hover["range"], span([5, 0, 5, 3]));

    let found = ask(&mut client, "definition", &uri, (5, 1), json!({})).await;
    assert_eq!(found[0]["uri"], plant.uri("main.clad"));
    assert_eq!(found[0]["range"], span([1, 11, 1, 14]));

    let context = json!({"context": {"includeDeclaration": true}});
    let found = ask(&mut client, "references", &uri, (5, 1), context.clone()).await;
    let files: Vec<&str> = found
        .as_array()
        .unwrap()
        .iter()
        .map(|it| it["uri"].as_str().unwrap())
        .collect();
    let program = plant.uri("main.clad");
    assert_eq!(files, [program.as_str(), &program, &uri]);
    // The program's references reach the scenarios too.
    client.open_as(&program, 1, PROGRAM).await;
    let found = ask(&mut client, "references", &program, (1, 12), context).await;
    assert_eq!(found[2], json!({"uri": uri, "range": span([5, 0, 5, 3])}));

    let found = ask(&mut client, "documentHighlight", &uri, (5, 1), json!({})).await;
    assert_eq!(found, json!([{"range": span([5, 0, 5, 3]), "kind": 2}]));

    let symbols = ask(&mut client, "documentSymbol", &uri, (0, 0), json!({})).await;
    assert_eq!(symbols[0]["name"], "one");
    client.finish().await;
}

#[tokio::test]
async fn a_name_follows_from_the_scenario_to_the_program_and_to_other_scenarios() {
    let other = SCENARIOS.replace("one", "two");
    let files = [
        ("main.clad", PROGRAM),
        ("main.ladder-test", SCENARIOS),
        ("other.ladder-test", other.as_str()),
    ];
    let (mut client, plant, uri) = opened(&files).await;
    let prepared = ask(&mut client, "prepareRename", &uri, (5, 2), json!({})).await;
    assert_eq!(prepared["placeholder"], "run");
    let edit = ask(
        &mut client,
        "rename",
        &uri,
        (5, 2),
        json!({"newName": "motor_runs"}),
    )
    .await;
    let changes = edit["documentChanges"].as_array().unwrap();
    let of = |name: &str| {
        let uri = plant.uri(name);
        changes
            .iter()
            .find(|it| it["textDocument"]["uri"] == uri)
            .unwrap()
    };
    assert_eq!(of("main.clad")["textDocument"]["version"], Value::Null);
    assert_eq!(of("main.ladder-test")["textDocument"]["version"], 3);
    let text = edited(PROGRAM, &of("main.clad")["edits"]);
    assert!(
        text.contains("VAR_OUTPUT motor_runs") && text.contains("( motor_runs )"),
        "{text}"
    );
    let text = edited(&other, &of("other.ladder-test")["edits"]);
    assert!(text.contains("\nmotor_runs => _-\n"), "{text}");
    let text = edited(SCENARIOS, &of("main.ladder-test")["edits"]);
    assert!(text.contains("\nmotor_runs => _-\n"), "{text}");
    client.finish().await;
}

#[tokio::test]
async fn tags_are_proposed_and_columns_are_aligned() {
    let text = SCENARIOS.replace("run => _-\n", "run =>   _-\n\n");
    let (mut client, _plant, uri) = opened(&[("main.clad", PROGRAM), ("main.ladder-test", &text)]).await;
    let found = ask(&mut client, "completion", &uri, (6, 0), json!({})).await;
    let labels: Vec<&str> = found["items"]
        .as_array()
        .unwrap()
        .iter()
        .map(|it| it["label"].as_str().unwrap())
        .collect();
    assert_eq!(
        labels[..4],
        ["time", "scenario", "property", "assume"],
        "all tags have rows: {found}"
    );
    let found = ask(&mut client, "completion", &uri, (0, 8), json!({})).await;
    assert_eq!(found["items"][0]["label"], "main.clad");

    let options = json!({"options": {"tabSize": 4, "insertSpaces": true}});
    let edits = ask(&mut client, "formatting", &uri, (0, 0), options.clone()).await;
    let aligned = "program main.clad\nstep 100ms\n\nscenario \"one\"\nstart    _-\nrun   => _-\n";
    assert_eq!(edited(&text, &edits), aligned);
    let mut typed = options.clone();
    typed["ch"] = json!("\n");
    let edits = ask(&mut client, "onTypeFormatting", &uri, (6, 0), typed).await;
    assert_eq!(edited(&text, &edits), format!("{aligned}\n"));
    let mut part = options;
    part["range"] = span([4, 0, 4, 3]);
    let edits = ask(&mut client, "rangeFormatting", &uri, (0, 0), part).await;
    assert_eq!(edited(&text, &edits), text.replace("start _", "start    _"));
    client.finish().await;
}

#[tokio::test]
async fn a_scenario_file_without_a_program_is_answered_all_the_same() {
    let text = "program gone.clad\nscenario \"one\"\nrun => _-\n";
    let (mut client, _plant, uri) = opened(&[("main.ladder-test", text)]).await;
    for what in [
        "hover",
        "definition",
        "documentHighlight",
        "prepareRename",
        "completion",
    ] {
        ask(&mut client, what, &uri, (2, 1), json!({})).await;
    }
    let params =
        json!({"textDocument": {"uri": uri}, "position": {"line": 2, "character": 1}, "newName": "x"});
    assert_eq!(
        client.request("textDocument/rename", params).await,
        Ok(Value::Null)
    );
    client.finish().await;
}

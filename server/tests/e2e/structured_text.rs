//! Files of Structured Text next to ladder text: what they declare is known in it, and shown where it is.

use serde_json::{Value, json};

use crate::client::Client;
use crate::plant::Plant;

const BLOCKS: &str = "\
FUNCTION_BLOCK FB_Motor
VAR_INPUT go : BOOL; END_VAR
VAR_OUTPUT run : BOOL; END_VAR
    run := go;
END_FUNCTION_BLOCK
";

const MAIN: &str = "\
VAR m : $FB_Motor; END_VAR
VAR_INPUT start : BOOL; END_VAR
VAR_OUTPUT lamp : BOOL; END_VAR
+--[$FB_Motor]( m, go := start, run => lamp )--+
";

const CALLER: &str = "\
PROGRAM Main
VAR m : FB_Motor; on : BOOL; END_VAR
    m(go := TRUE);
    on := m.run;
END_PROGRAM
";

async fn published(client: &mut Client, uri: &str) -> Vec<String> {
    let found = client
        .notification("textDocument/publishDiagnostics", |it| it["uri"] == uri)
        .await;
    let found = found["diagnostics"].as_array().unwrap().clone();
    let shown = |it: &Value| {
        let start = &it["range"]["start"];
        format!(
            "{}:{} {}",
            start["line"],
            start["character"],
            it["code"].as_str().unwrap()
        )
    };
    found.iter().map(shown).collect()
}

async fn open(client: &mut Client, uri: &str, text: &str) {
    let document = json!({"uri": uri, "languageId": "st", "version": 1, "text": text});
    client
        .notify("textDocument/didOpen", json!({"textDocument": document}))
        .await;
}

async fn replace(client: &mut Client, uri: &str, version: i32, text: &str) {
    let params = json!({
        "textDocument": {"uri": uri, "version": version},
        "contentChanges": [{"text": text}]
    });
    client.notify("textDocument/didChange", params).await;
}

/// Where a definition is: the file's name, line and character.
async fn definition(client: &mut Client, uri: &str, line: u32, character: u32) -> String {
    let params = json!({"textDocument": {"uri": uri}, "position": {"line": line, "character": character}});
    let found = client.request("textDocument/definition", params).await.unwrap();
    let first = &found[0];
    let uri = first["uri"]
        .as_str()
        .or(first["targetUri"].as_str())
        .unwrap_or_default();
    let range = if first["range"].is_null() {
        &first["targetSelectionRange"]
    } else {
        &first["range"]
    };
    let name = uri.rsplit('/').next().unwrap_or_default();
    format!(
        "{name} {}:{}",
        range["start"]["line"], range["start"]["character"]
    )
}

const NONE: [&str; 0] = [];

#[tokio::test]
async fn a_call_in_ladder_text_leads_into_the_file() {
    let plant = Plant::with(&[("blocks.st", BLOCKS)]);
    let mut client = Client::new().await;
    let main = plant.uri("main.clad");
    client.open_as(&main, 1, MAIN).await;
    assert_eq!(published(&mut client, &main).await, NONE);
    assert_eq!(definition(&mut client, &main, 3, 6).await, "blocks.st 0:15");
    // A parameter.
    assert_eq!(definition(&mut client, &main, 3, 20).await, "blocks.st 1:10");
    let params = json!({"textDocument": {"uri": main}, "position": {"line": 3, "character": 6}});
    let hover = client.request("textDocument/hover", params).await.unwrap();
    assert!(
        hover["contents"]["value"]
            .as_str()
            .unwrap()
            .contains("`go`: BOOL, input")
    );
    client.finish().await;
}

#[tokio::test]
async fn what_is_typed_into_it_counts_at_once() {
    let plant = Plant::with(&[("blocks.st", BLOCKS)]);
    let mut client = Client::new().await;
    let (main, blocks) = (plant.uri("main.clad"), plant.uri("blocks.st"));
    client.open_as(&main, 1, MAIN).await;
    assert_eq!(published(&mut client, &main).await, NONE);
    open(&mut client, &blocks, BLOCKS).await;
    assert_eq!(published(&mut client, &blocks).await, NONE);
    let typed = format!("\n\n{}", BLOCKS.replace("go", "forward"));
    replace(&mut client, &blocks, 2, &typed).await;
    assert_eq!(published(&mut client, &blocks).await, NONE);
    assert_eq!(published(&mut client, &main).await, ["3:19 bad-operand"]);
    assert_eq!(definition(&mut client, &main, 3, 6).await, "blocks.st 2:15");
    replace(
        &mut client,
        &blocks,
        3,
        &typed.replace("run := forward;", "run := ;"),
    )
    .await;
    assert_eq!(
        published(&mut client, &blocks).await,
        ["2:15 unread-part", "5:11 st-syntax"]
    );
    client
        .notify("textDocument/didClose", json!({"textDocument": {"uri": blocks}}))
        .await;
    // Once more for the block that could not be read.
    while published(&mut client, &main).await != NONE {}
    assert_eq!(definition(&mut client, &main, 3, 6).await, "blocks.st 0:15");
    client.finish().await;
}

#[tokio::test]
async fn calls_in_it_lead_to_blocks_too() {
    let plant = Plant::with(&[("blocks.st", BLOCKS)]);
    let mut client = Client::new().await;
    let caller = plant.uri("caller.st");
    open(&mut client, &caller, CALLER).await;
    assert_eq!(published(&mut client, &caller).await, NONE);
    assert_eq!(definition(&mut client, &caller, 2, 7).await, "blocks.st 1:10");
    assert_eq!(definition(&mut client, &caller, 1, 8).await, "blocks.st 0:15");
    assert_eq!(definition(&mut client, &caller, 3, 10).await, "caller.st 1:4");
    client.finish().await;
}

#[tokio::test]
async fn nothing_is_renamed_in_it() {
    let plant = Plant::with(&[("blocks.st", BLOCKS)]);
    let mut client = Client::new().await;
    let main = plant.uri("main.clad");
    client.open_as(&main, 1, MAIN).await;
    let params =
        json!({"textDocument": {"uri": main}, "position": {"line": 3, "character": 6}, "newName": "$Drive"});
    let (_, message) = client.request("textDocument/rename", params).await.unwrap_err();
    assert_eq!(
        message,
        "blocks.st would change too, which is not ladder text: change it there first"
    );
    client.finish().await;
}

//! Going from place to place: definitions, references, highlights, over open and closed files.

use serde_json::{Value, json};

use crate::client::Client;
use crate::plant::Plant;

const LIBRARY: &str =
    "VAR_GLOBAL total : DINT; END_VAR\n# ö # +--<FUN>( count )--[ADD]( total, total, 1 )--+\n";
const MAIN: &str = "+--<CALL>( count )--[GT]( total, 3 )--( )( y )--+\n";

/// Places as `main.clad 0:11-0:16`.
fn places(answer: &Value) -> Vec<String> {
    let show = |place: &Value| {
        let uri = place["uri"]
            .as_str()
            .or(place["targetUri"].as_str())
            .unwrap_or("");
        let range = if place["range"].is_null() {
            &place["targetSelectionRange"]
        } else {
            &place["range"]
        };
        let at = |end: &str| format!("{}:{}", range[end]["line"], range[end]["character"]);
        let name = uri.rsplit('/').next().unwrap();
        format!("{name} {}-{}", at("start"), at("end")).trim().to_owned()
    };
    answer
        .as_array()
        .unwrap_or(&Vec::new())
        .iter()
        .map(show)
        .collect()
}

async fn ask(client: &mut Client, method: &str, uri: &str, line: u32, character: u32) -> Value {
    let params = json!({
        "textDocument": {"uri": uri},
        "position": {"line": line, "character": character},
        "context": {"includeDeclaration": true}
    });
    let method = format!("textDocument/{method}");
    client.request(&method, params).await.unwrap()
}

#[tokio::test]
async fn definitions_lead_into_files_that_are_not_open() {
    let plant = Plant::with(&[("library.clad", LIBRARY), ("main.clad", MAIN)]);
    let main = plant.uri("main.clad");
    for encoding in ["utf-8", "utf-16"] {
        let mut client = Client::with_encoding(encoding).await;
        client.open_as(&main, 1, MAIN).await;
        let character = if encoding == "utf-8" { 17 } else { 16 };
        let found = ask(&mut client, "definition", &main, 0, 12).await;
        let expected = format!("library.clad 1:{character}-1:{}", character + 5);
        assert_eq!(places(&found), [expected]);
        for method in ["declaration", "implementation"] {
            assert_eq!(places(&ask(&mut client, method, &main, 0, 12).await).len(), 1);
        }
        assert_eq!(
            ask(&mut client, "typeDefinition", &main, 0, 12).await,
            Value::Null
        );
        client.finish().await;
    }
    let mut client = Client::with(json!({"textDocument": {"definition": {"linkSupport": true}}})).await;
    client.open_as(&main, 1, MAIN).await;
    let found = ask(&mut client, "definition", &main, 0, 12).await;
    assert_eq!(places(&found), ["library.clad 1:16-1:21"]);
    assert_eq!(
        found[0]["targetRange"]["start"],
        json!({"line": 1, "character": 0})
    );
    client.finish().await;
}

#[tokio::test]
async fn references_count_the_text_that_the_editor_shows() {
    let plant = Plant::with(&[("library.clad", LIBRARY), ("main.clad", MAIN)]);
    let (main, library) = (plant.uri("main.clad"), plant.uri("library.clad"));
    let mut client = Client::new().await;
    client.open_as(&main, 1, MAIN).await;
    let found = ask(&mut client, "references", &main, 0, 27).await;
    assert_eq!(
        places(&found),
        [
            "main.clad 0:26-0:31",
            "library.clad 0:11-0:16",
            "library.clad 1:33-1:38",
            "library.clad 1:40-1:45"
        ]
    );
    client
        .open_as(&library, 1, "\n\nVAR_GLOBAL total : DINT; END_VAR\n")
        .await;
    let found = ask(&mut client, "references", &main, 0, 27).await;
    assert_eq!(places(&found), ["main.clad 0:26-0:31", "library.clad 2:11-2:16"]);
    client.finish().await;
}

#[tokio::test]
async fn references_without_declarations_and_highlights() {
    let text = "VAR a : BOOL; END_VAR\n+--[ ]( a )--( )( a )--+\n";
    let mut client = Client::new().await;
    client.open(text).await;
    let uri = crate::client::URI;
    let params = json!({
        "textDocument": {"uri": uri},
        "position": {"line": 0, "character": 4},
        "context": {"includeDeclaration": false}
    });
    let found = client.request("textDocument/references", params).await.unwrap();
    assert_eq!(places(&found), ["motor.clad 1:8-1:9", "motor.clad 1:18-1:19"]);
    let found = ask(&mut client, "documentHighlight", uri, 1, 18).await;
    let kinds: Vec<_> = found
        .as_array()
        .unwrap()
        .iter()
        .map(|it| it["kind"].clone())
        .collect();
    assert_eq!(kinds, [1, 2, 3]);
    assert_eq!(
        ask(&mut client, "references", "file:///nowhere.clad", 1, 18).await,
        Value::Null
    );
    client.finish().await;
}

#[tokio::test]
async fn the_parts_of_a_document() {
    let text = "# Motor #\n+--\\--[ ]( a )--\\--( )( run )--+\n|  /--[ ]( run )--/             |\n";
    let document = json!({"textDocument": {"uri": crate::client::URI}});
    let mut client = Client::new().await;
    client.open(text).await;
    let flat = client
        .request("textDocument/documentSymbol", document.clone())
        .await
        .unwrap();
    assert_eq!(flat[0]["name"], "Motor");
    assert_eq!(flat[0]["location"]["range"]["end"]["line"], 2);
    let folds = client
        .request("textDocument/foldingRange", document.clone())
        .await
        .unwrap();
    assert_eq!(folds, json!([{"startLine": 1, "endLine": 2}]));
    let positions = json!([{"line": 1, "character": 11}, {"line": 9, "character": 0}]);
    let params = json!({"textDocument": {"uri": crate::client::URI}, "positions": positions});
    let selections = client
        .request("textDocument/selectionRange", params)
        .await
        .unwrap();
    assert_eq!(selections[0]["range"], crate::client::span([1, 11, 1, 12]));
    assert_eq!(
        selections[0]["parent"]["range"],
        crate::client::span([1, 9, 1, 14])
    );
    assert_eq!(selections[1]["range"], crate::client::span([0, 0, 3, 0]));
    client.finish().await;

    let nested = json!({"textDocument": {"documentSymbol": {"hierarchicalDocumentSymbolSupport": true}}});
    let mut client = Client::with(nested).await;
    client.open("+--<FUN>( f )--( )( x )--+\n").await;
    let tree = client
        .request("textDocument/documentSymbol", document)
        .await
        .unwrap();
    assert_eq!(tree[0]["name"], "f");
    assert_eq!(tree[0]["children"][0]["name"], "Network 1");
    client.finish().await;
}

#[tokio::test]
async fn symbols_of_all_files_links_and_calls() {
    let plant = Plant::with(&[
        ("library.clad", LIBRARY),
        (
            "main.clad",
            "# see library.clad, none.clad, https://example.com #\n",
        ),
        ("notes/plan.md", ""),
    ]);
    let main = plant.uri("main.clad");
    let text = format!("# see library.clad, none.clad, notes/plan.md, https://example.com #\n{MAIN}");
    let mut client = Client::new().await;
    client.open_as(&main, 1, &text).await;
    let found = client
        .request("workspace/symbol", json!({"query": "ct"}))
        .await
        .unwrap();
    assert_eq!(found[0]["name"], "count");
    assert!(
        found[0]["location"]["uri"]
            .as_str()
            .unwrap()
            .ends_with("/library.clad")
    );

    let params = json!({"textDocument": {"uri": main}});
    let links = client.request("textDocument/documentLink", params).await.unwrap();
    let targets: Vec<_> = links
        .as_array()
        .unwrap()
        .iter()
        .map(|it| it["target"].as_str().unwrap())
        .collect();
    assert_eq!(targets.len(), 3, "{targets:?}");
    assert!(targets[0].ends_with("/library.clad") && targets[1].ends_with("/notes/plan.md"));
    assert_eq!(targets[2], "https://example.com");

    let items = ask(&mut client, "prepareCallHierarchy", &main, 1, 12).await;
    assert_eq!(items[0]["name"], "count");
    let incoming = json!({"item": items[0]});
    let calls = client
        .request("callHierarchy/incomingCalls", incoming.clone())
        .await
        .unwrap();
    assert_eq!(calls[0]["from"]["name"], "main.clad");
    assert_eq!(calls[0]["fromRanges"][0], crate::client::span([1, 11, 1, 16]));
    let program = json!({"item": calls[0]["from"]});
    let calls = client
        .request("callHierarchy/outgoingCalls", program)
        .await
        .unwrap();
    assert_eq!(calls[0]["to"]["name"], "count");
    let calls = client
        .request("callHierarchy/outgoingCalls", incoming)
        .await
        .unwrap();
    assert_eq!(calls, json!([]));
    let alien = json!({"item": {
        "name": "x", "kind": 12, "uri": main,
        "range": crate::client::span([0, 0, 0, 0]), "selectionRange": crate::client::span([0, 0, 0, 0])
    }});
    let calls = client
        .request("callHierarchy/outgoingCalls", alien)
        .await
        .unwrap();
    assert_eq!(calls, Value::Null, "an item that did not come from here");
    client.finish().await;
}

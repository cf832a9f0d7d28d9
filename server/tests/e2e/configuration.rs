//! What the editor's own settings say, and what `ladder.toml` says over them.

use serde_json::{Value, json};

use crate::client::Client;
use crate::plant::Plant;

/// A network that is crooked by one column, with two coils for one tag.
const TWICE: &str = "+--[ ]( a )--( )( y )--+\n\n+--[ ]( b )--( )( y )--+\n";

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

/// The dashes that formatting puts in first.
async fn spacing(client: &mut Client, uri: &str) -> String {
    let params = json!({"textDocument": {"uri": uri}, "options": {"tabSize": 4, "insertSpaces": true}});
    let edits = client.request("textDocument/formatting", params).await.unwrap();
    edits[0]["newText"].as_str().unwrap().to_owned()
}

#[tokio::test]
async fn settings_that_come_with_initialize() {
    for options in [
        json!({"lint": {"double-coil": "off"}, "format": {"spacing": 4.0}}),
        json!({"ladder": {"lint": {"double-coil": "off"}, "format": {"spacing": 4}}}),
    ] {
        let plant = Plant::with(&[]);
        let mut client =
            Client::begun(json!({"processId": null, "capabilities": {}, "initializationOptions": options}))
                .await;
        let uri = plant.uri("a.clad");
        client.open_as(&uri, 1, TWICE).await;
        assert_eq!(published(&mut client, &uri).await, [""; 0]);
        assert_eq!(spacing(&mut client, &uri).await, "----");
        client.finish().await;
    }
}

#[tokio::test]
async fn a_settings_file_wins() {
    let plant = Plant::with(&[("ladder.toml", "[format]\nspacing = 3\n")]);
    let options = json!({"lint": {"double-coil": "off"}, "format": {"spacing": 4}});
    let mut client =
        Client::begun(json!({"processId": null, "capabilities": {}, "initializationOptions": options})).await;
    let uri = plant.uri("a.clad");
    client.open_as(&uri, 1, TWICE).await;
    // Also where it says nothing: everybody who works on the project sees the same.
    assert_eq!(published(&mut client, &uri).await, ["double-coil"]);
    assert_eq!(spacing(&mut client, &uri).await, "---");
    client.finish().await;
}

#[tokio::test]
async fn what_is_wrong_in_them_is_reported_once() {
    let plant = Plant::with(&[]);
    let options = json!({"lint": {"double-coils": "off"}, "workspace": {"exclude": ["old/"]}});
    let mut client = Client::begun(
        json!({"processId": null, "capabilities": {}, "initializationOptions": options.clone()}),
    )
    .await;
    let shown = client.notification("window/showMessage", |_| true).await;
    assert_eq!(
        shown["message"].as_str().unwrap(),
        "The settings of this editor: `ladder.lint.double-coils`: `double-coils` is not a rule: did you mean `double-coil`?\n\
         `ladder.workspace`: `workspace` is not a setting: it must be the same for everybody, and is in ladder.toml"
    );
    let params = json!({"settings": {"ladder": options}});
    client.notify("workspace/didChangeConfiguration", params).await;
    let uri = plant.uri("a.clad");
    client.open_as(&uri, 1, TWICE).await;
    published(&mut client, &uri).await;
    assert_eq!(client.arrived("window/showMessage"), Vec::<Value>::new());
    client.finish().await;
}

#[tokio::test]
async fn a_client_that_cannot_be_asked_sends_them_along() {
    let plant = Plant::with(&[]);
    let mut client = Client::with(json!({})).await;
    let uri = plant.uri("a.clad");
    client.open_as(&uri, 1, TWICE).await;
    assert_eq!(published(&mut client, &uri).await, ["double-coil"]);
    let params = json!({"settings": {"other": 7, "ladder": {"lint": {"double-coil": "off"}}}});
    client.notify("workspace/didChangeConfiguration", params).await;
    assert_eq!(published(&mut client, &uri).await, [""; 0]);
    client.finish().await;
}

#[tokio::test]
async fn a_client_that_can_be_asked_is_asked() {
    let plant = Plant::with(&[]);
    let mut client = Client::silent();
    client.take_requests();
    let params = json!({"processId": null, "capabilities": {"workspace": {
        "configuration": true, "didChangeConfiguration": {"dynamicRegistration": true}
    }}});
    client.request("initialize", params).await.unwrap();
    client.notify("initialized", json!({})).await;
    let (id, params) = client.asked("client/registerCapability").await;
    assert_eq!(
        params["registrations"][0]["method"],
        "workspace/didChangeConfiguration"
    );
    client.reply(id, Value::Null).await;
    let (id, params) = client.asked("workspace/configuration").await;
    assert_eq!(params["items"], json!([{"section": "ladder"}]));
    client.reply(id, json!([null])).await;
    let uri = plant.uri("a.clad");
    client.open_as(&uri, 1, TWICE).await;
    assert_eq!(published(&mut client, &uri).await, ["double-coil"]);
    // Two changes: the answer to the second question counts, though it comes first.
    let params = json!({"settings": null});
    client
        .notify("workspace/didChangeConfiguration", params.clone())
        .await;
    let (first, _) = client.asked("workspace/configuration").await;
    client.notify("workspace/didChangeConfiguration", params).await;
    let (second, _) = client.asked("workspace/configuration").await;
    client
        .reply(second, json!([{"lint": {"double-coil": "off"}}]))
        .await;
    client
        .reply(first, json!([{"lint": {"double-coil": "error"}}]))
        .await;
    assert_eq!(published(&mut client, &uri).await, [""; 0]);
    client.finish().await;
}

#[tokio::test]
async fn hints_and_lenses_are_asked_for_again_when_they_are_switched() {
    let mut client = Client::silent();
    client.take_requests();
    let params = json!({"processId": null, "capabilities": {"workspace": {
        "inlayHint": {"refreshSupport": true}, "codeLens": {"refreshSupport": true}
    }}});
    client.request("initialize", params).await.unwrap();
    client.notify("initialized", json!({})).await;
    let switched = |hints, lenses| json!({"settings": {"ladder": {"inlayHints": {"enable": hints}, "codeLens": {"enable": lenses}}}});
    for (settings, refreshed) in [
        (switched(true, true), "workspace/inlayHint/refresh"),
        (switched(true, false), "workspace/codeLens/refresh"),
    ] {
        client.notify("workspace/didChangeConfiguration", settings).await;
        let (id, _) = client.asked(refreshed).await;
        client.reply(id, Value::Null).await;
    }
    client.finish().await;
}

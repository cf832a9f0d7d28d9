//! Beginning, ending, and messages that are none.

use ladder_server::Ending;
use serde_json::{Value, json};

use crate::client::{Client, URI};

fn initialize(encodings: Option<&[&str]>) -> Value {
    let general = encodings.map_or(json!({}), |it| json!({"positionEncodings": it}));
    json!({"processId": null, "rootUri": null, "capabilities": {"general": general}})
}

#[tokio::test]
async fn the_encoding_is_negotiated() {
    for (offered, chosen) in [
        (Some(&["utf-16", "utf-8"][..]), "utf-8"),
        (Some(&["utf-16", "utf-32"]), "utf-32"),
        (Some(&["utf-16"]), "utf-16"),
        (None, "utf-16"),
    ] {
        let mut client = Client::silent();
        let result = client.request("initialize", initialize(offered)).await.unwrap();
        assert_eq!(result["capabilities"]["positionEncoding"], chosen);
        assert_eq!(
            result["capabilities"]["textDocumentSync"],
            json!({"openClose": true, "change": 2, "willSave": true, "save": {"includeText": false}})
        );
        assert_eq!(result["serverInfo"]["name"], "ladder");
        client.finish().await;
    }
}

#[tokio::test]
async fn exit_ends_the_server_while_the_input_stays_open() {
    let mut client = Client::new().await;
    client.request("shutdown", Value::Null).await.unwrap();
    client.notify("exit", Value::Null).await;
    assert_eq!(client.ended().await, Ending::Clean);
}

#[tokio::test]
async fn exit_without_shutdown_is_an_abrupt_end() {
    let mut client = Client::new().await;
    client.notify("exit", Value::Null).await;
    assert_eq!(client.ended().await, Ending::Abrupt);
    let mut client = Client::silent();
    client.notify("exit", Value::Null).await;
    assert_eq!(client.ended().await, Ending::Abrupt);
}

#[tokio::test]
async fn a_client_that_does_not_wait_loses_nothing() {
    let mut client = Client::silent();
    let first = client.ask("initialize", initialize(Some(&["utf-8"]))).await;
    client.notify("initialized", json!({})).await;
    client.open("+--[ ]( a )--( )( b )--+\n").await;
    let place = json!({"textDocument": {"uri": URI}, "position": {"line": 0, "character": 4}});
    let hover = client.ask("textDocument/hover", place).await;
    let last = client.ask("shutdown", Value::Null).await;
    client.notify("exit", Value::Null).await;
    assert!(client.answer(first).await.is_ok());
    // Cancelled by the end of the session or answered: but not "not initialized".
    assert_ne!(client.answer(hover).await.map_err(|(code, _)| code), Err(-32002));
    assert_eq!(client.answer(last).await, Ok(Value::Null));
    assert_eq!(client.ended().await, Ending::Clean);
}

#[tokio::test]
async fn nothing_is_done_before_initialize_and_nothing_after_shutdown() {
    let mut client = Client::silent();
    assert_eq!(client.hover(0, 0).await.unwrap_err().0, -32002);
    client.request("initialize", initialize(None)).await.unwrap();
    assert_eq!(
        client
            .request("initialize", initialize(None))
            .await
            .unwrap_err()
            .0,
        -32600
    );
    assert_eq!(client.hover(0, 0).await, Ok(Value::Null));
    client.request("shutdown", Value::Null).await.unwrap();
    assert_eq!(client.hover(0, 0).await.unwrap_err().0, -32600);
    client.notify("exit", Value::Null).await;
    assert_eq!(client.ended().await, Ending::Clean);
}

#[tokio::test]
async fn unknown_methods_and_bad_parameters_are_answered() {
    let mut client = Client::new().await;
    assert_eq!(
        client
            .request("textDocument/bake", json!({}))
            .await
            .unwrap_err()
            .0,
        -32601
    );
    let place = json!({"textDocument": {"uri": URI}, "position": {"line": 0, "character": 0}});
    assert_eq!(
        client.request("textDocument/moniker", place).await.unwrap_err().0,
        -32601,
        "not offered"
    );
    for params in [
        json!({}),
        json!([1]),
        json!({"textDocument": {"uri": URI}, "position": {"line": -1, "character": 0}}),
    ] {
        assert_eq!(
            client.request("textDocument/hover", params).await.unwrap_err().0,
            -32602
        );
    }
    // A notification that nobody knows is nothing, and the server goes on.
    client.notify("$/unknown", json!({})).await;
    client.notify("unknown", json!(7)).await;
    assert_eq!(client.hover(0, 0).await, Ok(Value::Null));
    client.finish().await;
}

#[tokio::test]
async fn a_notification_that_makes_no_sense_is_reported() {
    let mut client = Client::new().await;
    client
        .notify(
            "textDocument/didChange",
            json!({"textDocument": {"uri": URI}, "contentChanges": []}),
        )
        .await;
    let log = client.notification("window/logMessage", |_| true).await;
    let message = log["message"].as_str().unwrap();
    assert!(
        message.contains("textDocument/didChange") && message.contains("version"),
        "{message}"
    );
    client.finish().await;
}

#[tokio::test]
async fn messages_that_cannot_be_decoded_do_not_end_the_session() {
    let mut client = Client::new().await;
    client.send_raw(b"Content-Length: 9\r\n\r\nnot json!").await;
    client.send_raw(b"Content-Length: 2\r\n\r\n\xff\xff").await;
    client.send_raw(b"What-Is: this\r\n\r\n").await;
    client.send(&json!([])).await;
    client
        .send(&json!({"jsonrpc": "1.0", "method": "initialized"}))
        .await;
    assert_eq!(client.hover(0, 0).await, Ok(Value::Null));
    while client.unaddressed.len() < 5 {
        client.read().await;
    }
    let codes: Vec<_> = client
        .unaddressed
        .iter()
        .map(|it| it["error"]["code"].as_i64().unwrap())
        .collect();
    assert_eq!(codes, [-32700, -32700, -32700, -32600, -32600]);
    client.finish().await;
}

#[cfg(unix)]
#[tokio::test]
async fn the_server_ends_with_the_process_that_started_it() {
    let mut parent = std::process::Command::new("sleep").arg("600").spawn().unwrap();
    let mut client = Client::silent();
    let params = json!({"processId": parent.id(), "rootUri": null, "capabilities": {}});
    client.request("initialize", params).await.unwrap();
    parent.kill().unwrap();
    parent.wait().unwrap();
    assert_eq!(client.ended().await, Ending::Abrupt);
}

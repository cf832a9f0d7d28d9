//! Code lenses and inlay hints: only for clients and people that want them.

use serde_json::{Value, json};

use crate::client::{Client, URI, span};

const TEXT: &str =
    "+--[ ]( a )--<JMP>( done )--+\n+--[ ]( b )--<JMP>( done )--+\n+--<LBL>( done )--( )( y )--+\n";

async fn lenses(client: &mut Client, uri: &str) -> Value {
    let params = json!({"textDocument": {"uri": uri}});
    client.request("textDocument/codeLens", params).await.unwrap()
}

fn able() -> Value {
    json!({"experimental": {"commands": ["ladder.simulation.start", "ladder.test", "ladder.showReferences"]}})
}

#[tokio::test]
async fn lenses_for_a_client_that_can_run_them() {
    let folder = std::env::temp_dir().join(format!("ladder-lenses-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    std::fs::write(folder.join("motor.ladder-test"), "program motor.clad\n").unwrap();
    let uri = format!("file://{}/motor.clad", folder.display());
    let mut client = Client::with(able()).await;
    client.open_as(&uri, 1, TEXT).await;
    let found = lenses(&mut client, &uri).await;
    let found = found.as_array().unwrap();
    assert_eq!(
        found[0]["command"],
        json!({"title": "Start simulation", "command": "ladder.simulation.start", "arguments": [uri]})
    );
    assert_eq!(
        found[1]["command"],
        json!({
            "title": "Run scenarios",
            "command": "ladder.test",
            "arguments": [uri.replace(".clad", ".ladder-test")]
        })
    );
    assert_eq!(found[2]["range"], span([2, 0, 2, 0]));
    assert_eq!(found[2].get("command"), None, "counted when it comes into sight");
    let resolved = client
        .request("codeLens/resolve", found[2].clone())
        .await
        .unwrap();
    let command = &resolved["command"];
    assert_eq!(
        (&command["title"], &command["command"]),
        (&json!("2 jumps"), &json!("ladder.showReferences"))
    );
    assert_eq!(command["arguments"][2][1]["range"], span([1, 20, 1, 24]));
    client.finish().await;
    std::fs::remove_dir_all(&folder).unwrap();
}

#[tokio::test]
async fn no_lenses_for_others() {
    let mut client = Client::with(json!({})).await;
    client.open(TEXT).await;
    assert_eq!(lenses(&mut client, URI).await, Value::Null);
    client.finish().await;

    let mut client = Client::silent();
    let params = json!({
        "processId": null, "capabilities": able(),
        "initializationOptions": {"codeLens": {"enable": false}}
    });
    client.request("initialize", params).await.unwrap();
    client.open(TEXT).await;
    assert_eq!(
        lenses(&mut client, URI).await,
        Value::Null,
        "a person has switched them off"
    );
    client.finish().await;
}

#[tokio::test]
async fn hints_stand_at_line_ends_for_those_who_want_them() {
    let ask = json!({"textDocument": {"uri": URI}, "range": span([0, 0, 9, 0])});
    let text = "+--[ ]( ö )--( )( y )--+\r\n+--[ ]( b )--( )( z )--+\r\n";
    let mut client = Client::with(json!({})).await;
    client.open(text).await;
    let hints = client.request("textDocument/inlayHint", ask.clone()).await;
    assert_eq!(hints, Ok(Value::Null), "off unless set");
    client.finish().await;

    let mut client = Client::silent();
    let params = json!({
        "processId": null, "capabilities": {},
        "initializationOptions": {"inlayHints": {"enable": true}}
    });
    client.request("initialize", params).await.unwrap();
    client.open(text).await;
    let hints = client.request("textDocument/inlayHint", ask).await.unwrap();
    assert_eq!(
        hints[0],
        json!({"label": "y := ö", "paddingLeft": true, "position": {"line": 0, "character": 24}})
    );
    assert_eq!(hints.as_array().unwrap().len(), 2);
    client.finish().await;
}

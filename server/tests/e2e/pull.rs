//! Diagnostics for clients that ask for them.

use serde_json::{Value, json};

use crate::client::Client;
use crate::plant::Plant;

const LIBRARY: &str = "+--<FUN>( count )--[ ]( go )--( )( counted )--+\n";
const MAIN: &str = "+--<CALL>( count )--+\n";

/// A client that asks for diagnostics, with these folders open.
async fn client(folders: &[&str], rest: Value) -> Client {
    let mut client = Client::silent();
    client.take_requests();
    let mut capabilities = json!({
        "textDocument": {"diagnostic": {"relatedDocumentSupport": true}},
        "workspace": {"diagnostics": {"refreshSupport": true}}
    });
    for (key, value) in rest.as_object().unwrap() {
        capabilities[key] = value.clone();
    }
    let folders: Vec<Value> = folders
        .iter()
        .map(|uri| json!({"uri": uri, "name": "plant"}))
        .collect();
    let params = json!({"processId": null, "capabilities": capabilities, "workspaceFolders": folders});
    let offered = client.request("initialize", params).await.unwrap();
    assert_eq!(
        offered["capabilities"]["diagnosticProvider"],
        json!({
            "identifier": "ladder", "interFileDependencies": true, "workspaceDiagnostics": true,
            "workDoneProgress": true
        })
    );
    client.notify("initialized", json!({})).await;
    client
}

async fn ask(client: &mut Client, uri: &str, previous: Value) -> Value {
    let params = json!({"textDocument": {"uri": uri}, "previousResultId": previous});
    client.request("textDocument/diagnostic", params).await.unwrap()
}

fn codes(report: &Value) -> Vec<&str> {
    let items = report["items"].as_array().unwrap();
    items.iter().map(|it| it["code"].as_str().unwrap()).collect()
}

async fn replace(client: &mut Client, uri: &str, version: i32, text: &str) {
    let params =
        json!({"textDocument": {"uri": uri, "version": version}, "contentChanges": [{"text": text}]});
    client.notify("textDocument/didChange", params).await;
}

#[tokio::test]
async fn what_is_asked_for_is_not_published_too() {
    let plant = Plant::with(&[("library.clad", LIBRARY)]);
    let mut client = client(&[], json!({})).await;
    let main = plant.uri("main.clad");
    client.open_as(&main, 1, &MAIN.replace("count", "cuont")).await;
    let first = ask(&mut client, &main, Value::Null).await;
    assert_eq!(first["kind"], "full");
    assert_eq!(codes(&first), ["unknown-function"]);
    let again = ask(&mut client, &main, first["resultId"].clone()).await;
    assert_eq!(again, json!({"kind": "unchanged", "resultId": first["resultId"]}));
    replace(&mut client, &main, 2, MAIN).await;
    let fixed = ask(&mut client, &main, first["resultId"].clone()).await;
    assert_eq!((fixed["kind"].as_str(), codes(&fixed)), (Some("full"), vec![]));
    client
        .notify("textDocument/didClose", json!({"textDocument": {"uri": main}}))
        .await;
    client
        .request(
            "textDocument/hover",
            json!({"textDocument": {"uri": main}, "position": {"line": 0, "character": 0}}),
        )
        .await
        .unwrap();
    assert_eq!(
        client.arrived("textDocument/publishDiagnostics"),
        Vec::<Value>::new()
    );
    client.finish().await;
}

#[tokio::test]
async fn a_client_that_does_not_ask_is_not_offered_it() {
    let mut client = Client::silent();
    let params = json!({"processId": null, "capabilities": {}});
    let offered = client.request("initialize", params).await.unwrap();
    assert_eq!(offered["capabilities"].get("diagnosticProvider"), None);
    client.finish().await;
}

#[tokio::test]
async fn the_client_is_reported_when_another_file_changes_them() {
    let plant = Plant::with(&[]);
    let mut client = client(&[], json!({})).await;
    let (main, library) = (plant.uri("main.clad"), plant.uri("library.clad"));
    client.open_as(&main, 1, MAIN).await;
    assert_eq!(
        codes(&ask(&mut client, &main, Value::Null).await),
        ["unknown-function"]
    );
    client.open_as(&library, 1, LIBRARY).await;
    let (id, _) = client.asked("workspace/diagnostic/refresh").await;
    client.reply(id, Value::Null).await;
    assert_eq!(codes(&ask(&mut client, &main, Value::Null).await), [""; 0]);
    client.finish().await;
}

#[tokio::test]
async fn a_error_in_the_settings_comes_next_to_those_of_a_program() {
    let plant = Plant::with(&[("ladder.toml", "[formt]\n")]);
    let mut client = client(&[], json!({})).await;
    let (main, settings) = (plant.uri("main.clad"), plant.uri("ladder.toml"));
    client.open_as(&main, 1, "").await;
    let report = ask(&mut client, &main, Value::Null).await;
    assert_eq!(codes(&report["relatedDocuments"][&settings]), ["bad-setting"]);
    // Opened, it is asked for by itself.
    let document = json!({"uri": settings, "languageId": "toml", "version": 1, "text": "[format]\n"});
    client
        .notify("textDocument/didOpen", json!({"textDocument": document}))
        .await;
    assert_eq!(codes(&ask(&mut client, &settings, Value::Null).await), [""; 0]);
    client.finish().await;
}

#[tokio::test]
async fn a_client_that_takes_no_related_documents_gets_a_message() {
    let plant = Plant::with(&[("ladder.toml", "[formt]\n"), ("other/ladder.toml", "[lin]\n")]);
    let folder = plant.uri("");
    let mut client = client(
        &[folder.trim_end_matches('/')],
        json!({"textDocument": {"diagnostic": {}}}),
    )
    .await;
    let main = plant.uri("main.clad");
    client.open_as(&main, 1, "").await;
    let report = ask(&mut client, &main, Value::Null).await;
    assert_eq!(report.get("relatedDocuments"), None);
    let shown = client.notification("window/showMessage", |_| true).await;
    let message = shown["message"].as_str().unwrap();
    assert!(
        message.ends_with("ladder.toml:1:2: `formt` is not a setting: did you mean `format`?"),
        "{message}"
    );
    ask(&mut client, &main, Value::Null).await;
    assert_eq!(client.arrived("window/showMessage"), Vec::<Value>::new());
    client.finish().await;
}

#[tokio::test]
async fn the_whole_workspace_is_asked_for_at_once() {
    let plant = Plant::with(&[
        ("ladder.toml", "[format]\nwith = 1\n"),
        ("lines/a.clad", MAIN),
        ("b.clad", "+--[ ]( a )--\n"),
        // A workspace of its own.
        ("other/ladder.toml", ""),
        ("other/c.clad", MAIN),
    ]);
    let folder = plant.uri("");
    let mut client = client(&[folder.trim_end_matches('/')], json!({})).await;
    let open = plant.uri("open.clad");
    client.open_as(&open, 7, LIBRARY).await;
    let report = async |client: &mut Client, previous: Value| {
        let params = json!({"previousResultIds": previous, "workDoneToken": "w"});
        let report = client.request("workspace/diagnostic", params).await.unwrap();
        let items = report["items"].as_array().unwrap().clone();
        let short = |it: &Value| {
            let name = it["uri"].as_str().unwrap().replace(&folder, "");
            let codes = if it["kind"] == "full" {
                codes(it).join(" ")
            } else {
                "unchanged".to_owned()
            };
            format!("{name} {} {codes}", it["version"])
        };
        let shown: Vec<String> = items.iter().map(short).collect();
        (items, shown)
    };
    let (items, shown) = report(&mut client, json!([])).await;
    assert_eq!(
        shown,
        [
            "b.clad null no-output",
            "ladder.toml null bad-setting",
            "lines/a.clad null ",
            "open.clad 7 ",
            "other/c.clad null unknown-function",
            "other/ladder.toml null ",
        ]
    );
    let begin = client.notification("$/progress", |it| it["token"] == "w").await;
    assert_eq!(begin["value"]["kind"], "begin");
    client
        .notification("$/progress", |it| it["value"]["kind"] == "end")
        .await;
    let previous: Vec<Value> = items
        .iter()
        .map(|it| json!({"uri": it["uri"], "value": it["resultId"]}))
        .collect();
    replace(&mut client, &open, 8, &LIBRARY.replace("count )", "counter )")).await;
    let (_, shown) = report(&mut client, json!(previous)).await;
    assert_eq!(
        shown,
        [
            "b.clad null unchanged",
            "ladder.toml null unchanged",
            "lines/a.clad null unknown-function",
            "open.clad 8 unchanged",
            "other/c.clad null unchanged",
            "other/ladder.toml null unchanged",
        ]
    );
    client.finish().await;
}

#[tokio::test]
async fn a_long_beginning_is_shown() {
    let network = "+--[ ]( a )--[ ]( b )--[ ]( c )--( )( y )--+\n\n".repeat(3000);
    let plant = Plant::with(&[]);
    for nth in 0..12 {
        plant.write(&format!("{nth}.clad"), &network);
    }
    let folder = plant.uri("");
    let mut client = client(
        &[folder.trim_end_matches('/')],
        json!({"window": {"workDoneProgress": true}}),
    )
    .await;
    let (id, params) = client.asked("window/workDoneProgress/create").await;
    client.reply(id, Value::Null).await;
    let of_it = |it: &Value| it["token"] == params["token"];
    let begin = client.notification("$/progress", of_it).await;
    assert_eq!(begin["value"]["title"], "Reading ladder programs");
    client
        .notification("$/progress", |it| of_it(it) && it["value"]["kind"] == "end")
        .await;
    client.finish().await;
}

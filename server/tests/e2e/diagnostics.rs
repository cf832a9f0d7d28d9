//! Diagnostics belong to the version that they name.

use serde_json::{Value, json};

use crate::client::{Client, URI, span};

const UNPAIRED: &str = "+--\\--[ ]( a )--( )( y )--+\n|  /--[ ]( b )--/         |\n";
const SOUND: &str = "+--[ ]( a )--( )( y )--+\n";

fn codes(diagnostics: &[Value]) -> Vec<&str> {
    diagnostics
        .iter()
        .map(|it| it["code"].as_str().unwrap())
        .collect()
}

#[tokio::test]
async fn each_version_has_its_own() {
    let mut client = Client::new().await;
    client.open(UNPAIRED).await;
    let first = client.diagnostics(1).await;
    assert_eq!(codes(&first), ["unpaired-connector"]);
    assert_eq!(first[0]["source"], "ladder");
    assert_eq!(first[0]["severity"], 1);
    assert_eq!(first[0]["range"], span([1, 16, 1, 17]));
    client.replace(2, SOUND).await;
    assert_eq!(client.diagnostics(2).await, Vec::<Value>::new());
    client.finish().await;
}

#[tokio::test]
async fn related_places_are_linked_or_else_written_out() {
    let double = "VAR  a, y : BOOL;  a : INT;  END_VAR\n+--[ ]( a )--( )( y )--+\n";
    let mut rich = Client::new().await;
    rich.open(double).await;
    let found = rich.diagnostics(1).await;
    assert_eq!(codes(&found), ["duplicate-declaration"]);
    let related = found[0]["relatedInformation"].as_array().unwrap();
    assert_eq!(related[0]["location"]["uri"], URI);
    let line = related[0]["location"]["range"]["start"]["line"].as_u64().unwrap() + 1;
    rich.finish().await;

    let mut poor = Client::with(json!({})).await;
    poor.open(double).await;
    let found = poor.diagnostics(1).await;
    assert_eq!(found[0].get("relatedInformation"), None);
    assert_eq!(found[0].get("data"), None);
    let message = found[0]["message"].as_str().unwrap();
    assert!(message.contains(&format!("\nline {line}: ")), "{message}");
    poor.finish().await;
}

#[tokio::test]
async fn no_version_is_published_after_a_newer_one() {
    let mut client = Client::new().await;
    client.open(UNPAIRED).await;
    for version in 2..=400 {
        client
            .replace(version, if version % 2 == 0 { SOUND } else { UNPAIRED })
            .await;
    }
    let mut newest = 0;
    while newest < 400 {
        let published = client
            .notification("textDocument/publishDiagnostics", |_| true)
            .await;
        let version = published["version"].as_i64().unwrap();
        assert!(version > newest, "{version} after {newest}");
        newest = version;
        let count = published["diagnostics"].as_array().unwrap().len();
        assert_eq!(count, usize::from(version % 2 == 1), "those of version {version}");
    }
    client.finish().await;
}

#[tokio::test]
async fn closing_clears_them_for_good() {
    let mut client = Client::new().await;
    for round in 0..50 {
        client.open(UNPAIRED).await;
        if round % 2 == 0 {
            client.diagnostics(1).await;
        }
        client.close().await;
        let cleared = client
            .notification("textDocument/publishDiagnostics", |it| {
                it["diagnostics"] == json!([])
            })
            .await;
        assert_eq!(cleared["uri"], URI);
    }
    // What is left came before the closing that cleared it: nothing arrives later.
    client.arrived("textDocument/publishDiagnostics");
    client.hover(0, 0).await.unwrap();
    assert_eq!(
        client.arrived("textDocument/publishDiagnostics"),
        Vec::<Value>::new()
    );
    client.finish().await;
}

#[tokio::test]
async fn a_file_over_24_mib_gets_one_clear_message() {
    let mut client = Client::new().await;
    client
        .open(&"+--[ ]( a )--( )( y )--+\n".repeat((24 << 20) / 24 + 1))
        .await;
    let found = client.diagnostics(1).await;
    assert_eq!(codes(&found), ["file-too-large"]);
    assert!(found[0]["message"].as_str().unwrap().contains("24 MiB"));
    assert_eq!(client.hover(0, 4).await, Ok(Value::Null));
    let error = client.simulate("start", json!({"uri": URI})).await.unwrap_err();
    assert_eq!(error.0, -32803);
    client.finish().await;
}

#[tokio::test]
async fn of_very_many_findings_those_near_the_last_change_are_sent() {
    let mut client = Client::new().await;
    let mut text = "+--[ ]( a )--[/]( a )--( )( y )--+\n\n".repeat(3_000);
    text.push_str("+--[ ]( \n");
    client.open(&text).await;
    let found = client.diagnostics(1).await;
    assert_eq!(found.len(), 1_001);
    let rest = found.last().expect("one more");
    assert_eq!(rest["code"], "more-findings");
    assert!(codes(&found).contains(&"unclosed-block"), "errors come first");
    // A blank far down.
    client.change(2, &[([4_001, 0, 4_001, 0], " ")]).await;
    let found = client.diagnostics(2).await;
    let lines: Vec<u64> = found[..1_000]
        .iter()
        .map(|it| it["range"]["start"]["line"].as_u64().unwrap())
        .collect();
    assert!(
        lines[..999].iter().all(|line| line.abs_diff(4_000) <= 1_001),
        "{lines:?}"
    );
    client.finish().await;
}

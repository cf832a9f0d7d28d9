//! Documents stay what the client says they are.

use serde_json::{Value, json};

use crate::client::{Client, URI, span};

/// The width of the tag under the hover.
fn width(hover: &Value) -> u64 {
    let range = &hover["range"];
    range["end"]["character"].as_u64().unwrap() - range["start"]["character"].as_u64().unwrap()
}

#[tokio::test]
async fn a_burst_of_changes_is_applied_in_order() {
    const CHANGES: usize = 3_000;
    let mut client = Client::new().await;
    client.open("+--[ ]( t )--( )( y )--+\n").await;
    // Each digit is put in front of the one before, so any two that change places show.
    let mut digits = String::new();
    for version in 0..CHANGES {
        let digit = ((version * 7) % 10).to_string();
        client.change(2 + version as i32, &[([0, 9, 0, 9], &digit)]).await;
        digits.insert_str(0, &digit);
    }
    let hover = client.hover(0, 8).await.unwrap();
    assert_eq!(width(&hover), 1 + CHANGES as u64);
    assert!(
        hover["contents"]["value"]
            .as_str()
            .unwrap()
            .contains(&format!("t{digits}"))
    );
    client.diagnostics(1 + CHANGES as i32).await;
    client.finish().await;
}

#[tokio::test]
async fn a_hover_sees_the_text_that_was_sent_before_it() {
    let mut client = Client::new().await;
    client.open("+--[ ]( t )--( )( y )--+\n").await;
    let mut asked = Vec::new();
    for version in 2..=300 {
        client.change(version, &[([0, 9, 0, 9], "x")]).await;
        let place = json!({"textDocument": {"uri": URI}, "position": {"line": 0, "character": 8}});
        asked.push((version, client.ask("textDocument/hover", place).await));
    }
    for (version, id) in asked {
        assert_eq!(
            width(&client.answer(id).await.unwrap()),
            version as u64,
            "version {version}"
        );
    }
    client.finish().await;
}

#[tokio::test]
async fn positions_are_read_and_written_in_the_negotiated_unit() {
    // The comment holds an emoji: 4 bytes, 2 UTF-16 units, 1 scalar value.
    for (encoding, wide) in [("utf-8", 4), ("utf-16", 2), ("utf-32", 1)] {
        let mut client = Client::with_encoding(encoding).await;
        client.open("\r\n+--# 😀 #--[ ]( tag )--( )( y )--+\r\n").await;
        let tag = 14 + wide;
        let hover = client.hover(1, tag).await.unwrap();
        assert_eq!(hover["range"], span([1, tag, 1, tag + 3]), "{encoding}");
        client.change(2, &[([1, tag, 1, tag + 3], "other")]).await;
        let hover = client.hover(1, tag + 4).await.unwrap();
        assert_eq!(hover["range"], span([1, tag, 1, tag + 5]), "{encoding}");
        assert!(hover["contents"]["value"].as_str().unwrap().contains("other"));
        client.finish().await;
    }
}

#[tokio::test]
async fn positions_out_of_range_are_clamped() {
    let mut client = Client::new().await;
    client.open("+--[ ]( a )--( )( y )--+").await;
    for (line, character) in [(0, 4_000_000_000), (99, 0), (u32::MAX, u32::MAX)] {
        assert!(client.hover(line, character).await.is_ok());
    }
    // A swapped range means what it covers; one past the end means the end.
    client
        .change(2, &[([0, 9, 0, 8], "bc"), ([7, 0, 9, 9], "\n")])
        .await;
    let hover = client.hover(0, 8).await.unwrap();
    assert_eq!(hover["range"], span([0, 8, 0, 10]));
    client.finish().await;
}

#[tokio::test]
async fn a_version_that_does_not_grow_is_refused_and_reported() {
    let mut client = Client::new().await;
    client.open_as(URI, 5, "+--[ ]( a )--( )( y )--+").await;
    for version in [5, 3, -1] {
        client.change(version, &[([0, 8, 0, 9], "wrong")]).await;
        let log = client.notification("window/logMessage", |_| true).await;
        assert!(
            log["message"]
                .as_str()
                .unwrap()
                .contains(&format!("version {version}")),
            "{log}"
        );
    }
    let shown = client.arrived("window/showMessage");
    assert_eq!(shown.len(), 1, "the person sees it once");
    assert_eq!(
        client.hover(0, 8).await.unwrap()["range"],
        span([0, 8, 0, 9]),
        "the text is as it was"
    );
    client.change(6, &[([0, 8, 0, 9], "right")]).await;
    assert_eq!(client.hover(0, 8).await.unwrap()["range"], span([0, 8, 0, 13]));
    client.finish().await;
}

#[tokio::test]
async fn documents_that_are_not_open_have_no_answers_but_no_errors_either() {
    let mut client = Client::new().await;
    assert_eq!(client.hover(0, 0).await, Ok(Value::Null));
    let options = json!({"tabSize": 4, "insertSpaces": true});
    let formatting = json!({"textDocument": {"uri": URI}, "options": options});
    assert_eq!(
        client.request("textDocument/formatting", formatting).await,
        Ok(Value::Null)
    );
    let action =
        json!({"textDocument": {"uri": URI}, "range": span([0, 0, 1, 0]), "context": {"diagnostics": []}});
    assert_eq!(
        client.request("textDocument/codeAction", action).await,
        Ok(Value::Null)
    );
    client.change(2, &[([0, 0, 0, 0], "x")]).await;
    let log = client.notification("window/logMessage", |_| true).await;
    assert!(log["message"].as_str().unwrap().contains("not open"), "{log}");
    client.close().await;
    client.notification("window/logMessage", |_| true).await;
    client.finish().await;
}

#[tokio::test]
async fn a_whole_text_may_be_sent_too() {
    let mut client = Client::new().await;
    client.open("").await;
    client.replace(2, "+--[ ]( pump )--( )( y )--+").await;
    assert_eq!(client.hover(0, 8).await.unwrap()["range"], span([0, 8, 0, 12]));
    client.finish().await;
}

//! The findings of what is being typed wait, for clients that say where their cursor is.

use std::time::Duration;

use serde_json::{Value, json};
use tokio::time::sleep;

use crate::client::{Client, URI};

const SOUND: &str = "+--[ ]( a )--( )( y )--+\n\n+--[ ]( b )--( )( z )--+\n";

async fn cursor(client: &mut Client, line: Value) {
    let params = json!({"command": "ladder.cursor", "arguments": [{"uri": URI, "line": line}]});
    assert_eq!(
        client.request("workspace/executeCommand", params).await.unwrap(),
        Value::Null
    );
}

fn lines(diagnostics: &[Value]) -> Vec<u64> {
    let line = |it: &Value| it["range"]["start"]["line"].as_u64().unwrap();
    diagnostics.iter().map(line).collect()
}

#[tokio::test]
async fn a_half_typed_rung_waits_until_the_cursor_leaves_it() {
    let mut client = Client::new().await;
    client.open(SOUND).await;
    assert_eq!(client.diagnostics(1).await, Vec::<Value>::new());
    cursor(&mut client, json!(1)).await;
    // A connector, and on the next line a branch that is not closed.
    client
        .change(2, &[([1, 0, 1, 0], "+--\\--[ ]( c )--( )( x )--+")])
        .await;
    assert_eq!(client.diagnostics(2).await, Vec::<Value>::new());
    client.change(3, &[([1, 27, 1, 27], "\n|  /--[ ")]).await;
    assert_eq!(client.diagnostics(3).await, Vec::<Value>::new());
    // Up in the same network, then out of it.
    cursor(&mut client, json!(1)).await;
    assert!(client.arrived("textDocument/publishDiagnostics").is_empty());
    cursor(&mut client, json!(4)).await;
    let shown = client.diagnostics(3).await;
    assert!(
        !shown.is_empty() && lines(&shown).iter().all(|line| (1..=2).contains(line)),
        "{shown:?}"
    );
    client.finish().await;
}

#[tokio::test]
async fn a_half_typed_rung_waits_until_it_is_saved_or_nobody_types() {
    for save in [true, false] {
        let mut client = Client::new().await;
        client.open(SOUND).await;
        client.diagnostics(1).await;
        cursor(&mut client, json!(0)).await;
        client.change(2, &[([0, 3, 0, 3], "\\")]).await;
        assert_eq!(client.diagnostics(2).await, Vec::<Value>::new());
        if save {
            let params = json!({"textDocument": {"uri": URI}});
            client.notify("textDocument/didSave", params).await;
        } else {
            cursor(&mut client, Value::Null).await;
        }
        assert_eq!(lines(&client.diagnostics(2).await), [0]);
        client.finish().await;
    }
}

#[tokio::test]
async fn what_is_elsewhere_is_shown_at_once_and_so_is_all_where_no_cursor_is_known() {
    let mut client = Client::new().await;
    client.open(SOUND).await;
    client.diagnostics(1).await;
    client.change(2, &[([0, 3, 0, 3], "\\")]).await;
    assert_eq!(lines(&client.diagnostics(2).await), [0]);
    cursor(&mut client, json!(2)).await;
    client.change(3, &[([2, 3, 2, 3], "\\")]).await;
    assert_eq!(lines(&client.diagnostics(3).await), [0]);
    client.finish().await;
}

#[tokio::test]
async fn an_editor_that_saves_by_itself_ends_no_wait() {
    const AFTER_DELAY: u8 = 2;
    let mut client = Client::new().await;
    client.open(SOUND).await;
    client.diagnostics(1).await;
    cursor(&mut client, json!(0)).await;
    client.change(2, &[([0, 3, 0, 3], "\\")]).await;
    assert_eq!(client.diagnostics(2).await, Vec::<Value>::new());
    let document = json!({"uri": URI});
    for (reason, shown) in [(AFTER_DELAY, false), (1, true)] {
        let params = json!({"textDocument": document, "reason": reason});
        client.notify("textDocument/willSave", params).await;
        client
            .notify("textDocument/didSave", json!({"textDocument": document}))
            .await;
        if shown {
            assert_eq!(lines(&client.diagnostics(2).await), [0]);
        } else {
            // Longer than the findings take.
            sleep(Duration::from_millis(500)).await;
            cursor(&mut client, json!(0)).await;
            assert!(client.arrived("textDocument/publishDiagnostics").is_empty());
        }
    }
    client.finish().await;
}

#[tokio::test]
async fn a_section_and_a_comment_that_are_not_closed_yet_wait() {
    for (begun, next) in [
        ("VAR\n    a, b : BOOL;\n", "    c : BO"),
        ("# It is\n", "  a comm"),
    ] {
        let mut client = Client::new().await;
        client.open("\n").await;
        client.diagnostics(1).await;
        cursor(&mut client, json!(0)).await;
        client.change(2, &[([0, 0, 0, 0], begun)]).await;
        assert_eq!(client.diagnostics(2).await, Vec::<Value>::new(), "{begun}");
        let line = u32::try_from(begun.lines().count()).unwrap();
        client.change(3, &[([line, 0, line, 0], next)]).await;
        cursor(&mut client, json!(line)).await;
        assert_eq!(client.diagnostics(3).await, Vec::<Value>::new(), "{next}");
        cursor(&mut client, Value::Null).await;
        assert!(lines(&client.diagnostics(3).await).contains(&0), "{begun}{next}");
        client.finish().await;
    }
}

#[tokio::test]
async fn a_section_that_is_not_closed_is_no_mistake_of_the_rung_below() {
    let mut client = Client::new().await;
    client.open("\n+--[ ]( I1 )--( )( Q1 )--+\n").await;
    assert_eq!(client.diagnostics(1).await, Vec::<Value>::new());
    cursor(&mut client, json!(0)).await;
    let mut version = 1;
    for (line, character, text) in [
        (0, 0, "VAR_INPUT"),
        (0, 9, "\n"),
        (1, 0, "    a : BOOL;"),
        (1, 13, "\n"),
        (2, 0, "VAR_OUTPUT"),
        (2, 10, "\n"),
    ] {
        version += 1;
        client
            .change(version, &[([line, character, line, character], text)])
            .await;
        let found = client.diagnostics(version).await;
        assert_eq!(found, Vec::<Value>::new(), "{text:?} in line {line}");
        cursor(&mut client, json!(line + u32::from(text == "\n"))).await;
    }
    client.finish().await;
}

#[tokio::test]
async fn tags_of_a_program_that_is_being_begun_wait_until_their_line_is_looked_at_again() {
    let mut client = Client::new().await;
    client.open("").await;
    client.diagnostics(1).await;
    cursor(&mut client, json!(0)).await;
    let mut version = 1;
    let written = [
        "VAR_INPUT",
        "    start : BOOL;",
        "END_VAR",
        "+--[ ]( start )--( )( run )--+",
        "",
    ];
    for (line, text) in written.iter().enumerate() {
        let line = u32::try_from(line).unwrap();
        let end = u32::try_from(text.len()).unwrap();
        for (character, text) in [(0, *text), (end, "\n")] {
            version += 1;
            client
                .change(version, &[([line, character, line, character], text)])
                .await;
            assert_eq!(
                client.diagnostics(version).await,
                Vec::<Value>::new(),
                "{text:?} in line {line}"
            );
        }
        cursor(&mut client, json!(line + 1)).await;
    }
    cursor(&mut client, json!(3)).await;
    // `run` is not declared, in a file that declares tags.
    let has_any = |it: &Value| it["diagnostics"] != json!([]);
    let shown = client
        .notification("textDocument/publishDiagnostics", has_any)
        .await;
    assert_eq!(lines(shown["diagnostics"].as_array().unwrap()), [3]);
    client.finish().await;
}

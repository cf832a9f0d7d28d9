//! Messages that no editor sends, and headers that tell the wrong length: the session goes on.

use serde_json::{Value, json};

use crate::client::{Client, URI};

const RUNG: &str = "+--[ ]( a )--( )( b )--+\n";

/// A request for a hover, as bytes.
fn hover(id: i64) -> String {
    json!({
        "jsonrpc": "2.0", "id": id, "method": "textDocument/hover",
        "params": {"textDocument": {"uri": URI}, "position": {"line": 0, "character": 0}}
    })
    .to_string()
}

fn framed(length: impl std::fmt::Display, body: &str) -> Vec<u8> {
    format!("Content-Length: {length}\r\n\r\n{body}").into_bytes()
}

/// The code of the next error that answers no request.
async fn unaddressed(client: &mut Client) -> i64 {
    loop {
        if let Some(error) = client.unaddressed.pop_front() {
            return error["error"]["code"].as_i64().unwrap();
        }
        client.read().await;
    }
}

#[tokio::test]
async fn half_of_a_surrogate_pair_becomes_a_replacement_character() {
    let mut client = Client::new().await;
    let open = json!({
        "jsonrpc": "2.0", "method": "textDocument/didOpen",
        "params": {"textDocument": {"uri": URI, "languageId": "clad", "version": 1, "text": "TEXT"}}
    });
    // Alone, in the wrong order, twice the first half; then a whole pair, and a backslash that is only text.
    let text = r"# \ud800 \udc00\ud800 \uDBFF\ud83d\ude00 \\ud800 #\n+--[ ]( a )--( )( b )--+\n";
    let open = open.to_string().replace("TEXT", text);
    client.send_raw(&framed(open.len(), &open)).await;
    let place = json!({"textDocument": {"uri": URI}, "position": {"line": 1, "character": 8}});
    let shown = client.request("textDocument/hover", place).await.unwrap();
    assert!(
        shown["contents"]["value"].as_str().unwrap().contains('a'),
        "{shown}"
    );
    let text = json!({"textDocument": {"uri": URI}, "options": {"tabSize": 4, "insertSpaces": true}});
    assert!(client.request("textDocument/formatting", text).await.is_ok());
    client.finish().await;
}

#[tokio::test]
async fn a_number_out_of_range_is_answered() {
    let mut client = Client::new().await;
    for params in [
        r#"{"position":{"line":1e400}}"#,
        "[-1e999]",
        r#"{"a":{"b":[0,1e309]}}"#,
    ] {
        let id = client.next_id();
        let body =
            format!(r#"{{"jsonrpc":"2.0","id":{id},"method":"textDocument/hover","params":{params}}}"#);
        client.send_raw(&framed(body.len(), &body)).await;
        assert_eq!(client.answer(id).await.unwrap_err().0, -32600, "{params}");
    }
    // Also where nothing asks for it.
    let body = r#"{"jsonrpc":"2.0","method":"initialized","params":{},"beside":1e400}"#;
    client.send_raw(&framed(body.len(), body)).await;
    assert_eq!(unaddressed(&mut client).await, -32600);
    client.finish().await;
}

#[tokio::test]
async fn deep_nesting_is_answered() {
    let mut client = Client::new().await;
    for depth in (120..132).chain([10_000, 1_000_000]) {
        for (open, close) in [("[", "]"), (r#"{"a":"#, "}")] {
            let id = client.next_id();
            let params = open.repeat(depth) + "0" + &close.repeat(depth);
            let body =
                format!(r#"{{"jsonrpc":"2.0","id":{id},"method":"textDocument/hover","params":{params}}}"#);
            client.send_raw(&framed(body.len(), &body)).await;
            let (code, _) = client.answer(id).await.unwrap_err();
            assert!([-32600, -32602].contains(&code), "{depth}: {code}");
        }
    }
    client.finish().await;
}

#[tokio::test]
async fn a_wrong_length_is_recovered_from_at_the_next_header() {
    let good = hover(0);
    let length = good.len();
    let long_line = format!("{}{}", " ".repeat(10_000), good);
    for (what, wrong) in [
        ("too small", framed(length - 7, &good)),
        ("nothing", framed(0, &good)),
        ("one", framed(1, &good)),
        ("negative", framed("-5", &good)),
        ("a word", framed("twelve", &good)),
        ("a fraction", framed("12.5", &good)),
        ("empty", framed("", &good)),
        ("past every number", framed("9".repeat(40), &good)),
        ("missing", format!("Content-Type: x\r\n\r\n{good}").into_bytes()),
        ("no header at all", good.clone().into_bytes()),
        ("a long line without a header", long_line.into_bytes()),
        ("bytes", vec![0xff; 5000]),
    ] {
        let mut client = Client::new().await;
        client.send_raw(&wrong).await;
        assert_eq!(client.hover(0, 0).await, Ok(Value::Null), "{what}");
        assert!(
            [-32700, -32600].contains(&unaddressed(&mut client).await),
            "{what}"
        );
        assert!(client.unaddressed.is_empty(), "{what}: reported once");
        client.finish().await;
    }
}

#[tokio::test]
async fn a_length_that_is_too_large_does_not_swallow_what_follows() {
    for more in [1, 2, 5, 14, 18, 25, 100, 5000, 1 << 28, 1 << 40, 1_u64 << 62] {
        let mut client = Client::new().await;
        // The message is whole, so it is answered as soon as the next header shows where it ends.
        let id = client.next_id();
        let body = hover(id);
        client.send_raw(&framed(body.len() as u64 + more, &body)).await;
        assert_eq!(client.hover(0, 0).await, Ok(Value::Null), "{more}");
        assert_eq!(client.answer(id).await, Ok(Value::Null), "{more}");
        client.finish().await;
    }
    // A message that is broken as well.
    let mut client = Client::new().await;
    client
        .send_raw(&framed(1_u64 << 40, r#"{"jsonrpc":"2.0","#))
        .await;
    assert_eq!(client.hover(0, 0).await, Ok(Value::Null));
    assert_eq!(unaddressed(&mut client).await, -32700);
    client.finish().await;
}

#[tokio::test]
async fn a_text_that_shows_a_header_is_only_text() {
    let mut client = Client::new().await;
    client
        .open(&format!("# Content-Length: 5\r\n\r\n #\n{RUNG}"))
        .await;
    assert_eq!(client.diagnostics(1).await, Vec::<Value>::new());
    client.finish().await;
}

#[tokio::test]
async fn requests_of_the_protocol_itself_are_not_known() {
    let mut client = Client::new().await;
    for method in ["$/anything", "$/cancelRequest", "$/setTrace", "$/"] {
        let (code, message) = client.request(method, json!({"id": 7})).await.unwrap_err();
        assert_eq!(code, -32601, "{method}: {message}");
        client.notify(method, json!({"id": 7, "value": "off"})).await;
    }
    // A request by the name of a notification is answered as well.
    for method in ["textDocument/didOpen", "initialized", "window/logMessage"] {
        assert!(client.request(method, json!({})).await.is_err(), "{method}");
    }
    assert_eq!(client.hover(0, 0).await, Ok(Value::Null));
    client.finish().await;
}

//! Semantic tokens: all of them, those of a range, and what has changed.

use serde_json::{Value, json};

use crate::client::{Client, URI, span};

/// The tokens with their text, read as a client reads them.
fn read(text: &str, data: &[Value]) -> Vec<(String, u64)> {
    let lines: Vec<Vec<u16>> = text
        .split('\n')
        .map(|line| line.encode_utf16().collect())
        .collect();
    let numbers: Vec<usize> = data.iter().map(|n| n.as_u64().unwrap() as usize).collect();
    let (mut line, mut at) = (0, 0);
    numbers
        .chunks(5)
        .map(|token| {
            line += token[0];
            at = if token[0] == 0 { at + token[1] } else { token[1] };
            let text = String::from_utf16(&lines[line][at..at + token[2]]).unwrap();
            (text, token[3] as u64)
        })
        .collect()
}

async fn ask(client: &mut Client, method: &str, mut params: Value) -> Value {
    params["textDocument"] = json!({"uri": URI});
    client
        .request(&format!("textDocument/semanticTokens/{method}"), params)
        .await
        .unwrap()
}

fn data(answer: &Value) -> Vec<Value> {
    answer["data"].as_array().unwrap().clone()
}

const TEXT: &str =
    "# 😀 over\nlines #\n+--[ ]( ö )--# 😀 #--[TON]( t, T#5s )--( )( y )--+\n+--[ ]( a )--( )( b )--+\n";

#[tokio::test]
async fn tokens_are_reported_in_the_units_of_the_client() {
    let mut client = Client::with(json!({})).await;
    client.open(TEXT).await;
    let whole = ask(&mut client, "full", json!({})).await;
    let tokens = read(TEXT, &data(&whole));
    let texts: Vec<&str> = tokens.iter().map(|(text, _)| text.as_str()).collect();
    assert_eq!(
        texts,
        [
            "# 😀 over",
            "lines #",
            "ö",
            "# 😀 #",
            "TON",
            "t",
            "T#5s",
            "y",
            "a",
            "b"
        ],
        "a comment over lines is split for a client that cannot take it whole"
    );
    let part = ask(&mut client, "range", json!({"range": span([3, 0, 3, 5])})).await;
    let part: Vec<String> = read(TEXT, &data(&part))
        .into_iter()
        .map(|(text, _)| text)
        .collect();
    assert_eq!(part, ["a", "b"]);
    client.finish().await;

    let capabilities = json!({"textDocument": {"semanticTokens": {
        "requests": {}, "tokenTypes": [], "tokenModifiers": [], "formats": ["relative"], "multilineTokenSupport": true
    }}});
    let mut client = Client::with(capabilities).await;
    client.open(TEXT).await;
    let whole = data(&ask(&mut client, "full", json!({})).await);
    assert_eq!(whole[..5], [json!(0), json!(0), json!(17), json!(0), json!(0)]);
    client.finish().await;
}

#[tokio::test]
async fn a_change_is_reported_as_a_delta() {
    let mut client = Client::with(json!({})).await;
    client.open(TEXT).await;
    let whole = ask(&mut client, "full", json!({})).await;
    let mut known = data(&whole);
    let mut id = whole["resultId"].clone();
    let mut text = TEXT.to_owned();
    for (version, (line, from, to, new)) in [(3, 8, 9, "longer"), (3, 0, 0, "# x #\n"), (2, 8, 9, "")]
        .into_iter()
        .enumerate()
    {
        client
            .change(version as i32 + 2, &[([line, from, line, to], new)])
            .await;
        let start: usize = text.split_inclusive('\n').take(line as usize).map(str::len).sum();
        // The line that is changed in the middle holds two bytes for one unit at most before that place.
        text.replace_range(
            start + from as usize..start + to as usize + usize::from(line == 2),
            new,
        );
        let delta = ask(&mut client, "full/delta", json!({"previousResultId": id})).await;
        assert_ne!(delta["resultId"], id);
        let edits = delta["edits"].as_array().unwrap();
        assert_eq!(edits.len(), 1);
        let start = edits[0]["start"].as_u64().unwrap() as usize;
        let end = start + edits[0]["deleteCount"].as_u64().unwrap() as usize;
        let new = edits[0]["data"].as_array().cloned().unwrap_or_default();
        assert!(new.len() < known.len() / 2, "it is short: {delta}");
        known.splice(start..end, new);
        let whole = ask(&mut client, "full", json!({})).await;
        assert_eq!(known, data(&whole));
        id = whole["resultId"].clone();
        read(&text, &known);
    }
    let unknown = ask(&mut client, "full/delta", json!({"previousResultId": "?"})).await;
    assert_eq!(
        data(&unknown),
        known,
        "to a client that asks for something else all is sent"
    );
    client.finish().await;
}

/// The page has the legend, in its order.
#[test]
fn the_page_has_the_legend() {
    let page = include_str!("../../../docs/protocol.md");
    let kinds = ladder_ide::TokenKind::LEGEND.map(|(_, name, words)| (name, words));
    let modifiers = ladder_ide::Modifiers::LEGEND.map(|(_, name, words)| (name, words));
    let mut rows: Vec<String> = Vec::new();
    rows.push("| type | stands for |\n| --- | --- |".to_owned());
    rows.extend(kinds.map(|(name, words)| format!("| `{name}` | {words} |")));
    assert!(page.contains(&(rows.join("\n") + "\n\n")), "{}", rows.join("\n"));
    let mut rows = vec!["| modifier | stands for |\n| --- | --- |".to_owned()];
    rows.extend(modifiers.map(|(name, words)| format!("| `{name}` | {words} |")));
    assert!(page.contains(&(rows.join("\n") + "\n\n")), "{}", rows.join("\n"));
}

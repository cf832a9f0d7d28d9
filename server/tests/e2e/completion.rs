//! Completion and its documentation.

use std::time::Duration;

use serde_json::{Value, json};
use tokio::time::sleep;

use crate::client::{Client, URI};

async fn complete(client: &mut Client, line: u32, character: u32) -> Vec<Value> {
    let params = json!({
        "textDocument": {"uri": URI},
        "position": {"line": line, "character": character},
        "context": {"triggerKind": 1}
    });
    let answer = client.request("textDocument/completion", params).await.unwrap();
    answer["items"].as_array().unwrap().clone()
}

fn labelled<'v>(items: &'v [Value], label: &str) -> &'v Value {
    items
        .iter()
        .find(|item| item["label"] == label)
        .expect("it is proposed")
}

#[tokio::test]
async fn a_half_written_block_is_completed_and_documented() {
    let capabilities = json!({
        "textDocument": {"completion": {"completionItem": {
            "snippetSupport": true, "documentationFormat": ["markdown"]
        }}},
        "general": {"positionEncodings": ["utf-16"]}
    });
    let mut client = Client::with(capabilities).await;
    client.open("# 😀 #\n+--# ö #--[TO\n").await;
    let items = complete(&mut client, 1, 13).await;
    let timer = labelled(&items, "[TON]");
    assert_eq!(timer["insertTextFormat"], 2);
    assert_eq!(
        timer["textEdit"],
        json!({
            "range": {"start": {"line": 1, "character": 10}, "end": {"line": 1, "character": 13}},
            "newText": "[TON]( ${1:t}, ${2:T#1s} )--$0"
        })
    );
    assert_eq!(timer["filterText"], "[TON");
    assert_eq!(timer.get("command"), None);
    assert_eq!(timer.get("documentation"), None, "nobody has checked it yet");
    let resolved = client
        .request("completionItem/resolve", timer.clone())
        .await
        .unwrap();
    assert_eq!(resolved["documentation"]["kind"], "markdown");
    let text = resolved["documentation"]["value"].as_str().unwrap();
    assert!(
        text.contains("On-delay timer") && text.contains("EN   _---"),
        "{text}"
    );
    client.finish().await;
}

#[tokio::test]
async fn a_client_that_replaces_up_to_the_cursor_cuts_the_rest() {
    let capabilities = json!({
        "textDocument": {"completion": {"completionItem": {
            "snippetSupport": true, "resolveSupport": {"properties": ["additionalTextEdits", "command"]}
        }}},
        "experimental": {"commands": ["ladder.completion.cut"]}
    });
    let mut client = Client::with(capabilities).await;
    client.open("+--[TO]--( )( y )--+\n").await;
    let items = complete(&mut client, 0, 6).await;
    let timer = labelled(&items, "[TON]");
    assert_eq!(
        timer["textEdit"],
        json!({
            "range": {"start": {"line": 0, "character": 3}, "end": {"line": 0, "character": 6}},
            "newText": "[TON]( ${1:t}, ${2:T#1s} )$0"
        })
    );
    assert_eq!(timer["command"]["command"], "ladder.completion.cut");
    assert_eq!(
        timer["command"]["arguments"],
        json!([{"cut": "]", "before": "--( )( y )--+"}])
    );
    // It cannot ask for that later.
    let text = timer["documentation"].as_str().unwrap();
    assert!(text.contains("On-delay timer"), "{text}");
    client.finish().await;
}

#[tokio::test]
async fn a_client_without_snippets_gets_plain_text() {
    let mut client = Client::with(json!({})).await;
    client.open("+--[ ]( start )--( )( \n").await;
    let items = complete(&mut client, 0, 4).await;
    let contact = labelled(&items, "[/]");
    assert_eq!(contact.get("insertTextFormat"), None);
    assert_eq!(contact["textEdit"]["newText"], "[/]");
    let items = complete(&mut client, 0, 22).await;
    let tag = labelled(&items, "start");
    assert_eq!(tag["textEdit"]["newText"], "start )--+");
    let resolved = client
        .request("completionItem/resolve", tag.clone())
        .await
        .unwrap();
    let text = resolved["documentation"].as_str().unwrap();
    assert!(text.starts_with("start : BOOL\nInput"), "{text}");
    client.finish().await;
}

#[tokio::test]
async fn signatures_point_at_the_operand_that_is_written() {
    let ask = json!({"textDocument": {"uri": URI}, "position": {"line": 0, "character": 14}});
    let capabilities = json!({"textDocument": {"signatureHelp": {"signatureInformation": {
        "parameterInformation": {"labelOffsetSupport": true}, "documentationFormat": ["markdown"]
    }}}});
    let mut client = Client::with(capabilities).await;
    client.open("+--[TON]( tö, \n").await;
    let help = client
        .request("textDocument/signatureHelp", ask.clone())
        .await
        .unwrap();
    assert_eq!(
        (&help["activeParameter"], &help["signatures"][0]["label"]),
        (&json!(1), &json!("[TON]( t, PT, R := )"))
    );
    assert_eq!(help["signatures"][0]["parameters"][1]["label"], json!([10, 12]));
    client.finish().await;

    let mut plain = Client::with(json!({})).await;
    plain.open("+--[TON]( tö, \n").await;
    let help = plain.request("textDocument/signatureHelp", ask).await.unwrap();
    assert_eq!(help["signatures"][0]["parameters"][1]["label"], "PT");
    plain.finish().await;
}

#[tokio::test]
async fn a_contact_has_no_signature_unless_it_is_asked_for() {
    let mut client = Client::with(json!({})).await;
    client.open("+--[ ]( a )--[TON]( t, \n").await;
    for (character, kind, labels) in [(8, 2, 0), (8, 3, 0), (8, 1, 1), (20, 2, 1)] {
        let ask = json!({"textDocument": {"uri": URI}, "position": {"line": 0, "character": character},
            "context": {"triggerKind": kind, "isRetrigger": false}});
        let help = client.request("textDocument/signatureHelp", ask).await.unwrap();
        let found = help["signatures"].as_array().map_or(0, Vec::len);
        assert_eq!(found, labels, "{character} {kind}: {help}");
    }
    client.finish().await;
}

#[tokio::test]
async fn each_row_says_what_it_is_where_the_client_shows_that() {
    let capabilities =
        json!({"textDocument": {"completion": {"completionItem": {"labelDetailsSupport": true}}}});
    let mut plain = Client::with(capabilities).await;
    plain.open("+--[TO\n").await;
    let items = complete(&mut plain, 0, 6).await;
    assert_eq!(
        labelled(&items, "[TON]")["labelDetails"],
        json!({"description": "On-delay timer"})
    );
    plain.finish().await;
}

/// VS Code asks at the first key. An answer that may be longer is asked for again once more was typed, and is not shown before: who
/// types faster than the answers come would see none.
#[tokio::test]
async fn a_list_comes_to_who_types_ahead_in_a_large_program() {
    const RUNGS: u32 = 10_000;
    const LINE: u32 = RUNGS / 2;
    let rung = |n: u32| format!("+--[ ]( in_{n} )--[TON]( t_{n}, T#5s )--( )( out_{n} )--+\n");
    let mut client = Client::new().await;
    client.open(&(0..RUNGS).map(rung).collect::<String>()).await;
    complete(&mut client, 0, 4).await;
    let mut version = 1;
    for pace in [0, 30, 70, 130] {
        let mut asked = None;
        let typed = ["\n", "+--[", "C", "T", "U"];
        let mut column = 0;
        for text in typed {
            version += 1;
            client
                .change(version, &[([LINE, column, LINE, column], text)])
                .await;
            column += if text == "\n" {
                0
            } else {
                u32::try_from(text.len()).unwrap()
            };
            if text == "+--[" {
                let params = json!({
                    "textDocument": {"uri": URI},
                    "position": {"line": LINE, "character": column},
                    "context": {"triggerKind": 2, "triggerCharacter": "["}
                });
                asked = Some(client.ask("textDocument/completion", params).await);
            }
            sleep(Duration::from_millis(pace)).await;
        }
        let answer = client.answer(asked.unwrap()).await.unwrap();
        let items = answer["items"].as_array().unwrap();
        assert!(
            labelled(items, "[CTU]")["filterText"]
                .as_str()
                .unwrap()
                .starts_with("[CTU")
        );
        if answer["isIncomplete"] == true {
            // It came before the next key: it was shown, and is asked for again.
            assert_ne!(pace, 0);
            let items = complete(&mut client, LINE, column).await;
            assert_eq!(items[0]["label"], "[CTU]");
        }
        version += 1;
        client.change(version, &[([LINE, 0, LINE + 1, 0], "")]).await;
    }
    client.finish().await;
}

//! Hover, formatting, code actions, cancelling.

use serde_json::{Value, json};

use crate::client::{Client, URI, span};
use crate::plant::Plant;

async fn format(client: &mut Client) -> Value {
    let options = json!({"tabSize": 4, "insertSpaces": true});
    client
        .request(
            "textDocument/formatting",
            json!({"textDocument": {"uri": URI}, "options": options}),
        )
        .await
        .unwrap()
}

async fn actions(client: &mut Client, range: [u32; 4], only: Option<&str>) -> Vec<Value> {
    let mut context = json!({"diagnostics": []});
    if let Some(only) = only {
        context["only"] = json!([only]);
    }
    let params = json!({"textDocument": {"uri": URI}, "range": span(range), "context": context});
    let answer = client.request("textDocument/codeAction", params).await.unwrap();
    answer.as_array().unwrap().clone()
}

/// The text after the edits, which are in bytes (the client negotiated utf-8).
pub(crate) fn edited(text: &str, edits: &Value) -> String {
    let offset = |position: &Value| {
        let line = position["line"].as_u64().unwrap() as usize;
        let start: usize = text.split_inclusive('\n').take(line).map(str::len).sum();
        start + position["character"].as_u64().unwrap() as usize
    };
    let mut edits: Vec<_> = edits
        .as_array()
        .unwrap()
        .iter()
        .map(|edit| {
            (
                offset(&edit["range"]["start"])..offset(&edit["range"]["end"]),
                edit["newText"].as_str().unwrap(),
            )
        })
        .collect();
    edits.sort_by_key(|(range, _)| range.start);
    let mut text = text.to_owned();
    for (range, new) in edits.into_iter().rev() {
        text.replace_range(range, new);
    }
    text
}

/// A client that can ask for another name is told which one was made up; the others rename by hand.
#[tokio::test]
async fn a_name_that_is_made_up_can_be_typed_at_once() {
    for (can, told) in [
        (
            json!({"experimental": {"commands": ["ladder.rename"]}}),
            json!([URI, "function_1"]),
        ),
        (json!({}), Value::Null),
    ] {
        let mut client = Client::with(can).await;
        client.open("+--[ ]( a )--( )( y )--+\n").await;
        let offered = actions(&mut client, [0, 4, 0, 4], Some("refactor.extract")).await;
        assert_eq!(offered.len(), 1, "{offered:?}");
        assert_eq!(offered[0]["command"]["arguments"], told);
        client.finish().await;
    }
}

#[tokio::test]
async fn hover_explains_what_is_there() {
    let mut client = Client::new().await;
    client.open("+--[TON]( t1, T#5s )--( )( y )--+\n").await;
    let hover = client.hover(0, 4).await.unwrap();
    assert_eq!(hover["contents"]["kind"], "markdown");
    assert!(
        hover["contents"]["value"].as_str().unwrap().contains("TON"),
        "{hover}"
    );
    assert_eq!(
        client.hover(1, 0).await,
        Ok(Value::Null),
        "nothing is after the last line"
    );
    client.finish().await;

    let mut plain = Client::with(json!({})).await;
    plain.open("+--[TON]( t1, T#5s )--( )( y )--+\n").await;
    let hover = plain.hover(0, 4).await.unwrap();
    assert_eq!(hover["contents"]["kind"], "plaintext");
    assert!(
        !hover["contents"]["value"].as_str().unwrap().contains("```"),
        "{hover}"
    );
    plain.finish().await;
}

#[tokio::test]
async fn formatting_sends_small_edits() {
    let text = "+-\\-[ ]( a )-\\-( )( y )-+\n|  /-[ ](b)--/ |\n";
    let mut client = Client::new().await;
    client.open(text).await;
    let edits = format(&mut client).await;
    let formatted = edited(text, &edits);
    assert_eq!(
        formatted,
        "+--\\--[ ]( a )--\\----------------------------------------------------( )( y )--+\n|  /--[ ]( b )--/                                                              |\n"
    );
    for edit in edits.as_array().unwrap() {
        assert!(
            edit["newText"]
                .as_str()
                .unwrap()
                .trim_matches([' ', '-', '\n', '|'])
                .is_empty(),
            "{edit}"
        );
    }
    client.replace(2, &formatted).await;
    assert_eq!(format(&mut client).await, json!([]), "what is formatted stays");
    client.finish().await;
}

#[tokio::test]
async fn edits_for_a_text_that_has_moved_on_are_not_sent() {
    let mut client = Client::new().await;
    client.open(&"+-[ ]( a )-( )( y )-+\n\n".repeat(3000)).await;
    let options = json!({"tabSize": 4, "insertSpaces": true});
    let params = json!({"textDocument": {"uri": URI}, "options": options});
    let id = client.ask("textDocument/formatting", params).await;
    client.change(2, &[([0, 0, 1, 0], "")]).await;
    assert_eq!(client.answer(id).await.unwrap_err().0, -32801);
    client.finish().await;
}

/// Two jumps to labels that are nearly there.
const MISTYPED: &str = "\
+--<LBL>( again )--------------------------------------------------------------+

+--[ ]( a )----------------------------------------------------<JMP>( agian )--+

+--[ ]( b )-----------------------------------------------------<JMP>( agan )--+
";

#[tokio::test]
async fn a_fix_is_offered_where_its_problem_is() {
    let mut client = Client::new().await;
    client.open(MISTYPED).await;
    assert_eq!(
        actions(&mut client, [0, 4, 0, 4], Some("quickfix")).await,
        Vec::<Value>::new()
    );
    let offered = actions(&mut client, [2, 72, 2, 72], None).await;
    let fix = &offered[0];
    assert_eq!(
        (&fix["kind"], &fix["isPreferred"]),
        (&json!("quickfix"), &json!(false)),
        "it is a guess"
    );
    let diagnostic = &fix["diagnostics"][0];
    assert_eq!(diagnostic["code"], "unknown-label");
    assert_eq!(diagnostic["data"], json!({"fixes": [fix["title"]]}));
    let edit = &fix["edit"]["documentChanges"][0];
    assert_eq!(edit["textDocument"], json!({"uri": URI, "version": 1}));
    assert_eq!(
        edited(MISTYPED, &edit["edits"]),
        MISTYPED.replace("agian", "again")
    );
    client.finish().await;
}

/// A program in the first draft of the language.
const DRAFT: &str = "// a lamp\nIN = {DI go}\nOUT = {DO lamp}\n\n+---[ ]<go>---()<lamp>---+\n";

#[tokio::test]
async fn a_draft_becomes_ladder_text() {
    let mut client = Client::with(json!({"general": {"positionEncodings": ["utf-8"]}})).await;
    client.open(DRAFT).await;
    let offered = actions(&mut client, [1, 0, 1, 0], Some("quickfix")).await;
    assert_eq!(offered.len(), 1, "{offered:?}");
    assert_eq!(offered[0]["title"], "Convert to ladder text");
    let ladder = edited(DRAFT, &offered[0]["edit"]["changes"][URI]);
    assert!(ladder.starts_with("# a lamp #\n\nVAR_INPUT\n"), "{ladder}");
    assert!(ladder.contains("[ ]( go )--"), "{ladder}");
    client.finish().await;
}

#[tokio::test]
async fn a_draft_that_cannot_be_converted_yet_says_why() {
    for can in [false, true] {
        let mut client = Client::with(json!({
            "textDocument": {"codeAction": {"disabledSupport": can}}
        }))
        .await;
        client
            .open("IN = {DI start}\n+--[ ]<start>--?--()<run>--+\n")
            .await;
        let offered = actions(&mut client, [0, 0, 0, 0], Some("quickfix")).await;
        let reasons: Vec<&Value> = offered.iter().map(|it| &it["disabled"]["reason"]).collect();
        let reason = json!("it cannot be converted yet: 2:16: `?` is nothing that a rung is drawn with");
        assert_eq!(reasons, vec![&reason; usize::from(can)]);
        client.finish().await;
    }
}

/// Two places where a wire is missing, and a label that is only nearly there.
const TOUCHING: &str = "\
+--[ ]( a )( )( y )--+

+--[ ]( b )( )( z )--+

+--<LBL>( again )--<JMP>( agian )--+
";

#[tokio::test]
async fn all_fixes_at_once() {
    let mut client = Client::with(json!({"general": {"positionEncodings": ["utf-8"]}})).await;
    client.open(TOUCHING).await;
    let offered = actions(&mut client, [0, 0, 0, 0], Some("source.fixAll")).await;
    assert_eq!(offered.len(), 1);
    assert_eq!(offered[0]["kind"], "source.fixAll.ladder");
    let fixed = edited(TOUCHING, &offered[0]["edit"]["changes"][URI]);
    assert!(
        fixed.contains("[ ]( a )-") && fixed.contains("[ ]( b )-"),
        "{fixed}"
    );
    assert!(fixed.contains("agian"), "a guess is not made unasked: {fixed}");
    client.finish().await;
}

/// A seal-in, and a client that asks for edits when it wants them.
const MOTOR: &str = "\
+--\\--[ ]( start )--\\--[/]( stop )---------------------------------( )( run )--+
|  /--[ ]( run )----/                                                          |
";

fn asks_later() -> Value {
    json!({
        "general": {"positionEncodings": ["utf-8"]},
        "workspace": {"workspaceEdit": {"documentChanges": true}},
        "textDocument": {"codeAction": {
            "dataSupport": true, "disabledSupport": true, "resolveSupport": {"properties": ["edit"]}
        }}
    })
}

#[tokio::test]
async fn the_problems_of_a_line_are_fixed_wherever_on_it_the_cursor_is() {
    const THREE: &str = "\
+--\\--[ ]( a )--\\--( )( y )--+
|  |--[ ]( b )--|            |
|  /--[ ]( c )--/            |
";
    for asks in [asks_later(), json!({"general": {"positionEncodings": ["utf-8"]}})] {
        let mut client = Client::with(asks).await;
        client.open(THREE).await;
        let problem = json!({"range": span([0, 3, 0, 4]), "message": "no matter"});
        let params = json!({
            "textDocument": {"uri": URI},
            "range": span([0, 0, 0, 0]),
            "context": {"diagnostics": [problem], "only": ["quickfix"]},
        });
        let offered = client.request("textDocument/codeAction", params).await.unwrap();
        let mut fix = offered[0].clone();
        if fix.get("edit").is_none() {
            fix = client.request("codeAction/resolve", fix).await.unwrap();
        }
        let edits = fix["edit"]["documentChanges"]
            .get(0)
            .map_or(&fix["edit"]["changes"][URI], |change| &change["edits"]);
        assert!(edited(THREE, edits).contains("/--\\--[ ]( b )--\\--/"), "{fix}");
        client.finish().await;
    }
}

#[tokio::test]
async fn a_refactoring_tells_its_edits_when_it_is_chosen() {
    let mut client = Client::with(asks_later()).await;
    client.open(MOTOR).await;
    let offered = actions(&mut client, [0, 26, 0, 26], Some("refactor.rewrite")).await;
    let toggle = offered
        .iter()
        .find(|action| {
            action["title"]
                .as_str()
                .unwrap()
                .starts_with("Make `stop` normally open")
        })
        .expect("a contact can be toggled");
    assert_eq!(toggle["kind"], "refactor.rewrite");
    assert!(toggle.get("edit").is_none(), "{toggle}");
    let resolved = client
        .request("codeAction/resolve", toggle.clone())
        .await
        .unwrap();
    let edit = &resolved["edit"]["documentChanges"][0];
    assert_eq!(edit["textDocument"], json!({"uri": URI, "version": 1}));
    assert_eq!(
        edited(MOTOR, &edit["edits"]),
        MOTOR.replace("[/]( stop )", "[ ]( stop )")
    );
    assert_eq!(
        actions(&mut client, [0, 26, 0, 26], Some("refactor.inline")).await,
        Vec::<Value>::new(),
        "only what is asked for"
    );
    // What was offered for a text that has moved on is not made.
    client.change(2, &[([0, 0, 0, 0], "# x #\n")]).await;
    let outdated = client.request("codeAction/resolve", toggle.clone()).await;
    assert_eq!(outdated.unwrap_err().0, -32801);
    client.finish().await;
}

/// A call that depends on a contact cannot be inlined: the editor shows why, if it can.
#[tokio::test]
async fn what_cannot_be_done_comes_with_its_reason() {
    let text = "+--[ ]( a )--<CALL>( f )--+\n\n+--<FUN>( f )--( )( y )--+\n";
    let mut client = Client::with(asks_later()).await;
    client.open(text).await;
    let offered = actions(&mut client, [0, 20, 0, 20], Some("refactor.inline")).await;
    assert_eq!(offered.len(), 1);
    let reason = "whether the function runs depends on this rung's power";
    assert_eq!(offered[0]["disabled"], json!({"reason": reason}));
    assert!(offered[0].get("edit").is_none() && offered[0].get("data").is_none());
    client.finish().await;

    let mut plain = Client::new().await;
    plain.open(text).await;
    let offered = actions(&mut plain, [0, 20, 0, 20], Some("refactor.inline")).await;
    assert_eq!(offered, Vec::<Value>::new());
    plain.finish().await;
}

#[tokio::test]
async fn a_refactoring_tells_its_edits_at_once_where_nobody_asks_later() {
    let mut client = Client::new().await;
    client.open(MOTOR).await;
    let offered = actions(&mut client, [0, 26, 0, 26], Some("refactor")).await;
    assert!(offered.len() > 1, "{offered:?}");
    for action in &offered {
        let edits = &action["edit"]["documentChanges"][0]["edits"];
        assert_ne!(edited(MOTOR, edits), MOTOR, "{action}");
        assert!(action.get("data").is_none(), "{action}");
    }
    client.finish().await;
}

#[tokio::test]
async fn a_cancelled_request_is_answered_as_such() {
    let mut client = Client::new().await;
    client.open("+--[ ]( a )--( )( y )--+\n").await;
    let started = client.simulate("start", json!({"uri": URI})).await.unwrap();
    let session = started["session"].as_str().unwrap().to_owned();
    let params = json!({
        "command": "ladder.simulate.step",
        "arguments": [{"session": session, "scans": 1_000_000_000_000_u64}]
    });
    let id = client.ask("workspace/executeCommand", params).await;
    // The server goes on answering while the scans run.
    assert!(client.hover(0, 5).await.is_ok());
    client.notify("$/cancelRequest", json!({"id": id})).await;
    assert_eq!(client.answer(id).await.unwrap_err().0, -32800);
    // And the work has stopped: the session's thread is free for the next command.
    let state = client
        .simulate("state", json!({"session": session}))
        .await
        .unwrap();
    assert_eq!(state["status"], "paused");
    client.finish().await;
}

#[tokio::test]
async fn each_selection_is_toggled_by_itself() {
    let text = "+--( )( a )--+\n# b #\n\n+--[GT]( x, 16#FF )--( )( c )--+\n";
    let mut client = Client::new().await;
    client.open(text).await;
    let mut toggle = async |lines: Value| {
        let argument = json!({"uri": URI, "lines": lines});
        let params = json!({"command": "ladder.comment", "arguments": [argument]});
        client.request("workspace/executeCommand", params).await
    };
    // The second cursor is in the lines of the first selection.
    let lines = json!([{"first": 0, "last": 0}, {"first": 1, "last": 1}, {"first": 1, "last": 2}]);
    let answer = toggle(lines).await.unwrap();
    let first = "# +--( )( a )--+ #\nb\n\n+--[GT]( x, 16#FF )--( )( c )--+\n";
    assert_eq!(edited(text, &answer["edits"]), first);
    let (_, why) = toggle(json!([{"first": 0, "last": 99}])).await.unwrap_err();
    assert_eq!(
        why,
        "line 4 holds a \"#\", which would end the comment; write it without"
    );
}

#[tokio::test]
async fn a_finding_links_the_page_of_its_rule() {
    let can = json!({"experimental": {"rulePages": true}});
    for (client, links) in [(can, true), (json!({}), false)] {
        let mut client = Client::with(client).await;
        client
            .open("+--[ ]( a )--( )( y )--+\n+--[ ]( b )--( )( y )--+\n")
            .await;
        let published = client
            .notification("textDocument/publishDiagnostics", |it| it["uri"] == URI)
            .await;
        let found = &published["diagnostics"][0];
        assert_eq!(found["code"], "double-coil");
        let link = found["codeDescription"]["href"].as_str();
        assert_eq!(link, links.then_some("ladder-rule:/double-coil.md"));
        client.finish().await;
    }
}

#[tokio::test]
async fn a_definition_leads_into_the_library() {
    let can = json!({"experimental": {"libraryBlocks": true}});
    for (client, leads) in [(can, true), (json!({}), false)] {
        let mut client = Client::with(client).await;
        client
            .open("+--[$Debounce]( button )--( )( y )--+\n+--[$Debounce]( 5 )--( )( z )--+\n")
            .await;
        let place = json!({"textDocument": {"uri": URI}, "position": {"line": 0, "character": 6}});
        let found = client.request("textDocument/definition", place).await.unwrap();
        assert_eq!(
            found[0]["uri"].as_str(),
            leads.then_some("ladder-library:/Debounce.clad"),
            "{found}"
        );
        let ask = |block: &str| json!({"command": "ladder.libraryBlock", "arguments": [{"block": block}]});
        let source = client
            .request("workspace/executeCommand", ask("$debounce"))
            .await
            .unwrap();
        let text = include_str!("../../../library/Debounce.clad");
        assert_eq!(source, json!({"text": text}));
        let unknown = client.request("workspace/executeCommand", ask("$No")).await;
        assert_eq!(unknown.unwrap_err().1, "the library has no block `$No`");
        client.finish().await;
    }
}

#[tokio::test]
async fn the_page_of_a_rule_is_the_books() {
    let mut client = Client::new().await;
    let ask = |rule: &str| json!({"command": "ladder.rulePage", "arguments": [{"rule": rule}]});
    let page = client
        .request("workspace/executeCommand", ask("double-coil"))
        .await
        .unwrap();
    let book = include_str!("../../../docs/src/rules/double-coil.md");
    assert_eq!(page, json!({"markdown": book}));
    let unknown = client.request("workspace/executeCommand", ask("no-such")).await;
    assert_eq!(unknown.unwrap_err().1, "no rule is called `no-such`");
    client.finish().await;
}

#[tokio::test]
async fn a_finding_that_is_meant_so_is_switched_off() {
    const TWICE: &str = "+--[ ]( a )--( )( y )--+\n+--[ ]( b )--( )( y )--+\n";
    let plant = Plant::with(&[
        ("ladder.toml", "[lint]\nnever-read = \"off\"\n"),
        ("a.clad", TWICE),
    ]);
    let mut client = Client::with(json!({"general": {"positionEncodings": ["utf-8"]}})).await;
    let uri = plant.uri("a.clad");
    let settings = plant.uri("ladder.toml");
    client.open_as(&uri, 1, TWICE).await;
    let params = json!({
        "textDocument": {"uri": uri}, "range": span([1, 18, 1, 18]),
        "context": {"diagnostics": [], "only": ["quickfix"]},
    });
    let ask = "textDocument/codeAction";
    let offered = client.request(ask, params.clone()).await.unwrap();
    let titles: Vec<&str> = offered
        .as_array()
        .unwrap()
        .iter()
        .map(|action| action["title"].as_str().unwrap())
        .collect();
    assert_eq!(
        titles,
        [
            "Combine the 2 coils of `y` into one (changes what the program does)",
            "Allow `double-coil` here, with a reason",
            "Allow `double-coil` in this file, with a reason",
            "Switch `double-coil` off in ladder.toml",
        ]
    );
    let off = &offered[3]["edit"]["changes"][&settings];
    assert_eq!(
        edited("[lint]\nnever-read = \"off\"\n", off),
        "[lint]\ndouble-coil = \"off\"\nnever-read = \"off\"\n"
    );
    // What the editor shows of the settings counts, saved or not.
    let typed = "# ours #\n[lint]\n";
    let document = json!({"uri": settings, "languageId": "toml", "version": 1, "text": typed});
    client
        .notify("textDocument/didOpen", json!({"textDocument": document}))
        .await;
    let offered = client.request(ask, params).await.unwrap();
    let off = &offered[3]["edit"]["changes"][&settings];
    assert_eq!(edited(typed, off), "# ours #\n[lint]\ndouble-coil = \"off\"\n");
    client.finish().await;
}

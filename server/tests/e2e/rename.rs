//! Renaming, and formatting of parts, over the protocol.

use serde_json::{Value, json};

use crate::client::{Client, URI, span};
use crate::features::edited;
use crate::plant::Plant;

const LIBRARY: &str =
    "VAR_GLOBAL\n    total : DINT;\nEND_VAR\n# ö # +--<FUN>( count )--[ADD]( total, total, 1 )--+\n";
const MAIN: &str = "+--<CALL>( count )--[GT]( total, 3 )--( )( y )--+\n";

async fn rename(client: &mut Client, uri: &str, at: (u32, u32), new: &str) -> Result<Value, (i64, String)> {
    let params = json!({
        "textDocument": {"uri": uri},
        "position": {"line": at.0, "character": at.1},
        "newName": new
    });
    client.request("textDocument/rename", params).await
}

#[tokio::test]
async fn all_files_in_one_edit_with_versions() {
    let plant = Plant::with(&[("library.clad", LIBRARY), ("main.clad", MAIN)]);
    let (main, library) = (plant.uri("main.clad"), plant.uri("library.clad"));
    let mut client = Client::new().await;
    client.open_as(&main, 7, MAIN).await;
    let edit = rename(&mut client, &main, (0, 27), "sum").await.unwrap();
    let changes = edit["documentChanges"].as_array().unwrap();
    assert_eq!(changes.len(), 2);
    assert_eq!(changes[0]["textDocument"], json!({"uri": main, "version": 7}));
    assert_eq!(
        changes[1]["textDocument"],
        json!({"uri": library, "version": null})
    );
    let text = edited(MAIN, &changes[0]["edits"]);
    assert_eq!(
        text,
        "+--<CALL>( count )--[GT]( sum, 3 )-----------------------------------( )( y )--+\n"
    );
    let text = edited(LIBRARY, &changes[1]["edits"]);
    assert!(
        text.contains("    sum : DINT;\n") && text.contains("[ADD]( sum, sum, 1 )"),
        "{text}"
    );
    client.finish().await;

    // A client without versions.
    let mut client = Client::with(json!({"general": {"positionEncodings": ["utf-8"]}})).await;
    client.open_as(&main, 7, MAIN).await;
    let edit = rename(&mut client, &main, (0, 12), "up").await.unwrap();
    assert!(edit["documentChanges"].is_null());
    let text = edited(LIBRARY, &edit["changes"][&library]);
    assert!(text.contains("<FUN>( up )"), "{text}");
    client.finish().await;
}

#[tokio::test]
async fn what_cannot_be_is_refused_with_the_reason() {
    let mut client = Client::new().await;
    client.open("+--[ ]( a )--[ ]( b )--( )( %QX0.0 )--+\n").await;
    let refused = rename(&mut client, URI, (0, 8), "b").await.unwrap_err();
    assert_eq!(refused.0, -32803);
    assert!(refused.1.contains("there is a tag `b`"), "{refused:?}");
    let nothing = rename(&mut client, URI, (0, 1), "b").await.unwrap_err();
    assert_eq!(nothing.0, -32803);

    let place = |character: u32| json!({"textDocument": {"uri": URI}, "position": {"line": 0, "character": character}});
    let prepared = client.request("textDocument/prepareRename", place(8)).await;
    assert_eq!(
        prepared,
        Ok(json!({"range": span([0, 8, 0, 9]), "placeholder": "a"}))
    );
    let prepared = client.request("textDocument/prepareRename", place(1)).await;
    assert_eq!(prepared, Ok(Value::Null));
    let prepared = client.request("textDocument/prepareRename", place(30)).await;
    assert!(prepared.unwrap_err().1.contains("direct address"));
    client.finish().await;
}

const CROOKED: &str = "+-[ ]( a )-( )( b )-+\n\n+-[ ]( c )-( )( d )-+\n\n+-[ ]( e )-( )( f )-+\n";

#[tokio::test]
async fn one_range_or_several() {
    let mut client = Client::new().await;
    client.open(CROOKED).await;
    let options = json!({"tabSize": 4, "insertSpaces": true});
    let params = json!({"textDocument": {"uri": URI}, "options": options, "range": span([2, 0, 2, 5])});
    let edits = client
        .request("textDocument/rangeFormatting", params)
        .await
        .unwrap();
    assert!(!edits.as_array().unwrap().is_empty());
    assert!(
        edits
            .as_array()
            .unwrap()
            .iter()
            .all(|edit| edit["range"]["start"]["line"] == 2),
        "{edits}"
    );
    let ranges = json!([span([0, 0, 0, 5]), span([4, 3, 4, 3])]);
    let params = json!({"textDocument": {"uri": URI}, "options": options, "ranges": ranges});
    let edits = client
        .request("textDocument/rangesFormatting", params)
        .await
        .unwrap();
    let text = edited(CROOKED, &edits);
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines[2], "+-[ ]( c )-( )( d )-+");
    assert!(
        lines[0].starts_with("+--[ ]( a )--") && lines[4].starts_with("+--[ ]( e )--"),
        "{text}"
    );
    client.finish().await;
}

#[tokio::test]
async fn while_a_person_types() {
    let mut client = Client::new().await;
    let text = "+--\\--[ ]( start )--\\--( )( run )--+\n|  /--[ ]( run )--/\n\n";
    client.open(text).await;
    let ask = |line: u32, character: u32, typed: &str| {
        json!({
            "textDocument": {"uri": URI}, "position": {"line": line, "character": character},
            "ch": typed, "options": {"tabSize": 4, "insertSpaces": true}
        })
    };
    let edits = client
        .request("textDocument/onTypeFormatting", ask(1, 19, "/"))
        .await
        .unwrap();
    assert_eq!(
        edited(text, &edits),
        "+--\\--[ ]( start )--\\----------------------------------------------( )( run )--+\n|  /--[ ]( run )----/                                                          |\n\n"
    );
    let edits = client
        .request("textDocument/onTypeFormatting", ask(1, 5, "x"))
        .await;
    assert_eq!(edits, Ok(json!([])));
    client.finish().await;
}

#[tokio::test]
async fn scenarios_follow_open_or_not() {
    let tests = "program main.clad\nstep 100ms\n\nscenario \"one\"\ny => _-\n";
    let plant = Plant::with(&[
        ("main.clad", MAIN),
        ("a.ladder-test", tests),
        ("b.ladder-test", tests),
    ]);
    let (main, a) = (plant.uri("main.clad"), plant.uri("a.ladder-test"));
    let mut client = Client::new().await;
    client.open_as(&main, 1, MAIN).await;
    let shown = tests.replace("_-", "_--");
    let document = json!({"uri": a, "languageId": "ladder-test", "version": 4, "text": shown});
    client
        .notify("textDocument/didOpen", json!({"textDocument": document}))
        .await;
    let edit = rename(&mut client, &main, (0, 44), "lamp").await.unwrap();
    let changes = edit["documentChanges"].as_array().unwrap();
    assert_eq!(changes.len(), 3, "{edit}");
    assert_eq!(changes[1]["textDocument"], json!({"uri": a, "version": 4}));
    assert_eq!(
        edited(&shown, &changes[1]["edits"]),
        shown.replace("y =>", "lamp =>")
    );
    assert_eq!(
        edited(tests, &changes[2]["edits"]),
        tests.replace("y =>", "lamp =>")
    );
    client.finish().await;
}

const VALVES: &str = "TYPE\n    Valve : STRUCT\n        open : BOOL;\n    END_STRUCT;\nEND_TYPE\n\nVAR\n    v : Valve;\n    \
    pump_run : BOOL;\n    pump_on : BOOL;\nEND_VAR\n\n+--[ ]( pump_run )--( )( v.open )--( )( pump_on )--+\n";
const VALVE_TESTS: &str =
    "program main.clad\n\nscenario \"one\"\npump_run    _-\nv.open   => _-\npump_on  => _-\n";

/// A member's name, and what an extraction makes of tags, are in scenarios too.
#[tokio::test]
async fn members_and_extracted_tags_change_scenarios() {
    let plant = Plant::with(&[("main.clad", VALVES), ("a.ladder-test", VALVE_TESTS)]);
    let (main, tests) = (plant.uri("main.clad"), plant.uri("a.ladder-test"));
    let mut client = Client::new().await;
    client.open_as(&main, 1, VALVES).await;
    let edit = rename(&mut client, &main, (2, 9), "is_open").await.unwrap();
    let changes = edit["documentChanges"].as_array().unwrap();
    assert_eq!(changes[1]["textDocument"]["uri"], tests);
    assert_eq!(
        edited(VALVE_TESTS, &changes[1]["edits"]),
        VALVE_TESTS
            .replace("pump_run    ", "pump_run     ")
            .replace("v.open   =>", "v.is_open =>")
            .replace("pump_on  =>", "pump_on   =>")
    );
    let params = json!({
        "textDocument": {"uri": main},
        "range": span([8, 6, 8, 6]),
        "context": {"diagnostics": [], "only": ["refactor.extract"]},
    });
    let offered = client.request("textDocument/codeAction", params).await.unwrap();
    let mut action = offered[0].clone();
    assert_eq!(action["title"], "Extract 2 tags into the structure `Pump`");
    if action.get("edit").is_none() {
        action = client.request("codeAction/resolve", action).await.unwrap();
    }
    let changes = action["edit"]["documentChanges"].as_array().unwrap();
    let program = edited(VALVES, &changes[0]["edits"]);
    assert!(
        program.contains("    pump : Pump;") && program.contains("[ ]( pump.run )"),
        "{program}"
    );
    assert_eq!(changes[1]["textDocument"]["uri"], tests);
    assert_eq!(
        edited(VALVE_TESTS, &changes[1]["edits"]),
        VALVE_TESTS.replace("pump_", "pump.")
    );
    client.finish().await;
}

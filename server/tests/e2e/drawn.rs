//! The operations of the diagram: each a drawing, what is done, and the drawing behind it.

use std::path::{Path, PathBuf};

use serde_json::{Map, Value, json};

use crate::client::{Answer, Client, URI};

/// The folders of cases: of this project, and where more are.
fn cases() -> Vec<PathBuf> {
    let own = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/corpus/drawing");
    let more = std::env::var_os("LADDER_CORPUS").map(|corpus| Path::new(&corpus).join("drawing"));
    let folders = std::iter::once(own).chain(more).filter(|folder| folder.is_dir());
    let cases = folders.flat_map(|folder| std::fs::read_dir(folder).unwrap());
    let mut cases: Vec<PathBuf> = cases.map(|case| case.unwrap().path()).collect();
    cases.sort();
    cases
}

fn read(case: &Path, name: &str) -> String {
    std::fs::read_to_string(case.join(name)).unwrap()
}

fn position(place: &Value) -> Value {
    json!({"line": place[0], "character": place[1]})
}

fn range(places: &Value) -> Value {
    json!({"start": position(&places[0]), "end": position(&places[1])})
}

/// An operation as the protocol has it: places are pairs of numbers in the cases.
fn edit(operation: &Value) -> Value {
    let op = operation["op"].as_str().unwrap();
    let mut edit = Map::new();
    for (name, value) in operation.as_object().unwrap() {
        let value = match (name.as_str(), op) {
            ("note" | "means", _) => continue,
            ("to", "move") => json!({"at": position(&value["at"])}),
            ("at" | "from" | "to", _) | ("what", "branchEnd" | "close") => position(value),
            ("what", "delete" | "move") => value.as_array().unwrap().iter().map(range).collect(),
            ("what", _) => range(value),
            _ => value.clone(),
        };
        edit.insert(name.clone(), value);
    }
    Value::Object(edit)
}

pub(crate) async fn asked(client: &mut Client, command: &str, argument: Value) -> Answer {
    let params = json!({"command": command, "arguments": [argument]});
    client.request("workspace/executeCommand", params).await
}

async fn edited(client: &mut Client, version: i32, edit: Value) -> Answer {
    asked(
        client,
        "ladder.diagramEdit",
        json!({"uri": URI, "version": version, "edit": edit}),
    )
    .await
}

/// The offset of a position in UTF-16.
fn offset(text: &str, place: &Value) -> usize {
    let (line, character) = (
        place["line"].as_u64().unwrap(),
        place["character"].as_u64().unwrap(),
    );
    let lines = text.split_inclusive('\n').take(line as usize);
    let start: usize = lines.map(str::len).sum();
    let mut units = 0;
    let within = text[start..].char_indices().find(|(_, c)| {
        let is_there = units >= character as usize;
        units += c.len_utf16();
        is_there
    });
    start + within.map_or(text[start..].len(), |(at, _)| at)
}

/// A text with the edits of an answer, which are sorted and do not touch.
fn applied(text: &str, edited: &Value) -> String {
    let mut new = text.to_owned();
    let mut next = usize::MAX;
    for edit in edited["edits"].as_array().unwrap().iter().rev() {
        let [start, end] = ["start", "end"].map(|end| offset(text, &edit["range"][end]));
        assert!(start <= end && end < next, "{edited}");
        new.replace_range(start..end, edit["newText"].as_str().unwrap());
        next = start;
    }
    new
}

#[tokio::test]
async fn each_operation_gives_its_drawing() {
    let mut failed = Vec::new();
    let cases = cases();
    assert!(cases.len() >= 24);
    let mut client = Client::with_encoding("utf-16").await;
    for case in cases {
        let before = read(&case, "before.clad");
        client.open(&before).await;
        let operation: Value = serde_json::from_str(&read(&case, "operation.json")).unwrap();
        let got = match edited(&mut client, 1, edit(&operation)).await {
            Ok(answer) => applied(&before, &answer),
            Err((code, message)) => format!("{code}: {message}\n"),
        };
        let after = read(&case, "after.clad");
        if got != after {
            failed.push(format!("{}\nwant\n{after}\ngot\n{got}", case.display()));
        }
        client.close().await;
    }
    client.finish().await;
    assert!(failed.is_empty(), "{}", failed.join("\n"));
}

const MOTOR: &str = "\
# Motor #
+--\\--[ ]( start )--\\--[/]( stop )---------------------------------( )( run )--+
|  /--[ ]( run )----/                                                          |

# ladder: fmt off #
+--[ ]( run )--( )( lamp )--+
# ladder: fmt on #
";

#[tokio::test]
async fn a_change_is_for_the_text_that_the_server_has() {
    let mut client = Client::new().await;
    client.open(MOTOR).await;
    let insert = json!({"op": "insert", "at": {"line": 1, "character": 22}, "text": "[/]( overload )"});
    let outdated = edited(&mut client, 7, insert.clone()).await;
    assert_eq!(outdated.unwrap_err().0, -32801);
    let done = edited(&mut client, 1, insert).await.unwrap();
    assert_eq!(done["said"], "Closed contact overload added");
    assert_eq!(done["focus"], done["select"][0]["start"]);
    let asked_of_none = json!({"uri": "file:///plant/none.clad", "version": 1, "network": 0});
    let refused = asked(&mut client, "ladder.diagramOffer", asked_of_none)
        .await
        .unwrap_err();
    assert_eq!(
        refused,
        (
            -32803,
            "file:///plant/none.clad is not open in the editor".to_owned()
        )
    );
    let by_hand = json!({"op": "insert", "at": {"line": 5, "character": 14}, "text": "[ ]( x )"});
    let refused = edited(&mut client, 1, by_hand).await.unwrap_err();
    assert_eq!(refused.0, -32803);
    assert!(refused.1.contains("`fmt off`"), "{}", refused.1);
    client.finish().await;
}

#[tokio::test]
async fn names_change_everywhere() {
    let mut client = Client::new().await;
    client.open(MOTOR).await;
    let what = json!({"start": {"line": 2, "character": 11}, "end": {"line": 2, "character": 14}});
    let rename = json!({"op": "rename", "what": what, "text": "motor"});
    let done = edited(&mut client, 1, rename).await.unwrap();
    assert_eq!(
        applied(MOTOR, &done),
        "\
# Motor #
+--\\--[ ]( start )--\\--[/]( stop )-------------------------------( )( motor )--+
|  /--[ ]( motor )--/                                                          |

# ladder: fmt off #
+--[ ]( motor )--( )( lamp )--+
# ladder: fmt on #
"
    );
    client.finish().await;
}

/// What of a drawing is about drawing in it.
fn drawing_in(svg: &str) -> Vec<String> {
    let mut found = Vec::new();
    for name in ["point", "joins", "tight"] {
        let attribute = format!(" data-{name}=\"");
        let values = svg.split(&attribute).skip(1);
        found.extend(values.map(|rest| format!("{name} {}", rest.split('"').next().unwrap())));
    }
    found
}

#[tokio::test]
async fn a_drawing_has_its_points() {
    let mut client = Client::new().await;
    client
        .open(
            "\
+--\\--[ ]( a )--\\--[ ]( b )--\\-----\\--# c #--( )( y )--+
|  /--\\         /--[ ]( c )--/  \\--/
|     /--[ ]( d )---------------/

+--[ ]( a )[ ]( b )--|--( )( y )--+
",
        )
        .await;
    let argument = json!({"uri": URI, "lines": {"first": 0, "last": 9}});
    let drawn = asked(&mut client, "ladder.diagram", argument).await.unwrap();
    let svg = drawn["pieces"][0]["svg"].as_str().unwrap();
    assert_eq!(
        drawing_in(svg),
        [
            "point 0:1",
            "point 0:4",
            "point 0:14",
            "point 0:17",
            "point 0:27",
            "point 0:36",
            "point 0:43",
            "point 0:53",
            "point 1:17",
            "point 1:27",
            "point 2:7",
            "point 2:17",
            "joins 0:3,1:3",
            "joins 0:16,1:16",
            "joins 0:29,1:29 0:35,1:35",
            "joins 1:6,2:6",
            "joins 1:32,2:32",
            "tight 0:30",
        ]
    );
    assert!(svg.contains("data-at=\"0:38\" data-end=\"0:43\""), "{svg}");
    let broken = &drawn["pieces"][1];
    assert_eq!(broken["editable"], false);
    assert!(broken["why"].as_str().unwrap().contains("`|`"), "{broken}");
    assert_eq!(
        drawing_in(broken["svg"].as_str().unwrap_or_default()),
        Vec::<String>::new()
    );
    client.finish().await;
}

#[tokio::test]
async fn what_can_be_done_is_said_with_why_not() {
    let mut client = Client::new().await;
    client.open(MOTOR).await;
    let mut offers = Vec::new();
    for asked_about in [
        json!({"at": {"line": 1, "character": 22}}),
        json!({"what": [{"start": {"line": 1, "character": 3}, "end": {"line": 1, "character": 21}}]}),
        json!({"network": 1}),
        json!({"network": 5}),
        json!({"at": {"line": 1, "character": 22}, "text": "[TON]( t, T#1s )"}),
    ] {
        let mut argument = json!({"uri": URI, "version": 1});
        argument
            .as_object_mut()
            .unwrap()
            .extend(asked_about.as_object().unwrap().clone());
        let offered = asked(&mut client, "ladder.diagramOffer", argument).await.unwrap();
        let not = offered["offers"]
            .as_array()
            .unwrap()
            .iter()
            .filter(|offer| offer.get("why").is_some());
        let not: Vec<&str> = not.map(|offer| offer["op"].as_str().unwrap()).collect();
        offers.push(format!("{not:?} {}", offered.get("text").unwrap_or(&Value::Null)));
    }
    assert_eq!(
        offers,
        [
            "[] null",
            "[\"operand\", \"head\", \"split\"] \"\\\\--[ ]( start )--\\\\\\n   /--[ ]( run )--/\"",
            "[\"moveUp\", \"merge\"] \"# Motor #\\n+--\\\\--[ ]( start )--\\\\--[/]( stop )---------------------------------( )( run )--+\\n|  /--[ ]( run )----/                                                          |\\n\"",
            "[\"moveDown\", \"merge\"] \"# ladder: fmt off #\\n+--[ ]( run )--( )( lamp )--+\\n\"",
            "[] null",
        ]
    );
    client.finish().await;
}

/// Makes a change, as an editor does, and returns the new text.
async fn drawn(client: &mut Client, text: &str, version: i32, edit: Value) -> String {
    let done = edited(client, version, edit).await.unwrap();
    let new = applied(text, &done);
    client.replace(version + 1, &new).await;
    new
}

/// Where something is in a text: its first place, and the one behind it.
fn around(text: &str, what: &str) -> [Value; 2] {
    let start = text
        .find(what)
        .unwrap_or_else(|| panic!("{what} is not in\n{text}"));
    [start, start + what.len()].map(|at| {
        let line = text[..at].matches('\n').count();
        let character = at - text[..at].rfind('\n').map_or(0, |end| end + 1);
        json!({"line": line, "character": character})
    })
}

#[tokio::test]
async fn a_motor_starter_is_drawn_from_nothing() {
    let mut client = Client::new().await;
    client.open("").await;
    let first = json!({"op": "network", "place": "below", "entry": "XIC start OTE run",
        "declare": {"section": "VAR_INPUT", "type": "BOOL"}});
    let mut text = drawn(&mut client, "", 1, first).await;
    let [from, to] = around(&text, "[ ]( start )");
    let seal_in = json!({"op": "parallel", "from": from, "to": to, "side": "below", "text": "[ ]( run )"});
    text = drawn(&mut client, &text, 2, seal_in).await;
    let [at, _] = around(&text, "( )( run )");
    text = drawn(
        &mut client,
        &text,
        3,
        json!({"op": "insert", "at": at, "text": "[/]( stop )"}),
    )
    .await;
    let second = json!({"op": "network", "place": "below", "entry": "XIC run TON warm T#5s OTE ready"});
    text = drawn(&mut client, &text, 4, second).await;
    let [at, _] = around(&text, "+--\\--[ ]( start )");
    text = drawn(
        &mut client,
        &text,
        5,
        json!({"op": "comment", "network": at["line"], "text": "Motor"}),
    )
    .await;
    let [from, to] = around(&text, "( )( ready )");
    let lamp =
        json!({"op": "parallel", "from": from, "to": to, "side": "below", "text": "[/]( off )--( )( lamp )"});
    text = drawn(&mut client, &text, 6, lamp).await;
    assert_eq!(
        text,
        "\
VAR_INPUT
    start : BOOL;
    stop  : BOOL;
    off   : BOOL;
END_VAR
VAR_OUTPUT
    run   : BOOL;
    ready : BOOL;
    lamp  : BOOL;
END_VAR
VAR
    warm : TON;
END_VAR

# Motor #
+--\\--[ ]( start )--\\--[/]( stop )---------------------------------( )( run )--+
|  /--[ ]( run )----/                                                          |

+--[ ]( run )--[TON]( warm, T#5s )--\\-------------------------( )( ready )--\\--+
|                                   /--[/]( off )--------------( )( lamp )--/  |
"
    );
    client.finish().await;
}

//! The diagram next to the text: only what is shown is drawn, and only what is not known is sent.

use serde_json::{Value, json};

use crate::client::{Answer, Client, URI};

const MOTOR: &str = "\
# Runs the motor #
+--\\--[ ]( start )--\\--[/]( stop )--( )( run )--+
|  /--[ ]( run )----/                            |

+--[ ]( run )--[TON]( warm, 20ms )--( )( lamp )--+
";

async fn asked(client: &mut Client, argument: Value) -> Answer {
    let params = json!({"command": "ladder.diagram", "arguments": [argument]});
    client.request("workspace/executeCommand", params).await
}

async fn drawn(client: &mut Client, lines: [u32; 2], known: &[Value]) -> Value {
    let lines = json!({"first": lines[0], "last": lines[1]});
    let argument = json!({"uri": URI, "lines": lines, "known": known});
    asked(client, argument).await.unwrap()
}

fn pieces(drawn: &Value) -> &[Value] {
    drawn["pieces"].as_array().unwrap()
}

fn keys(drawn: &Value) -> Vec<Value> {
    pieces(drawn).iter().map(|piece| piece["key"].clone()).collect()
}

/// The first lines of the pieces that come with their drawing.
fn sent(drawn: &Value) -> Vec<u64> {
    let with_drawing = pieces(drawn).iter().filter(|piece| piece.get("svg").is_some());
    let first = |piece: &Value| piece["lines"]["first"].as_u64().unwrap();
    with_drawing.map(first).collect()
}

#[tokio::test]
async fn a_page_gets_what_it_shows() {
    let mut client = Client::new().await;
    client.open(MOTOR).await;
    let whole = drawn(&mut client, [0, 99], &[]).await;
    assert_eq!((&whole["version"], &whole["lineCount"]), (&json!(1), &json!(6)));
    let kinds: Vec<_> = pieces(&whole).iter().map(|piece| &piece["kind"]).collect();
    assert_eq!(kinds, ["comment", "network", "network"]);
    assert_eq!(sent(&whole), [0, 1, 4]);
    // All of what the lines cut through.
    let part = drawn(&mut client, [2, 3], &[]).await;
    assert_eq!(
        (sent(&part), &part["lines"]),
        (vec![1], &json!({"first": 1, "last": 3}))
    );
    let nothing = drawn(&mut client, [3, 3], &[]).await;
    assert_eq!(
        (sent(&nothing), &nothing["lines"]),
        (vec![], &json!({"first": 3, "last": 3}))
    );
    client.finish().await;
}

#[tokio::test]
async fn places_in_a_drawing_are_those_of_the_simulation() {
    let mut client = Client::with_encoding("utf-16").await;
    client.open(&MOTOR.replace("start", "stärt")).await;
    let show = json!({"lines": [{"first": 0, "last": 9}]});
    let start = json!({"uri": URI, "options": {"show": show}});
    let state = client.simulate("start", start).await.unwrap()["state"].clone();
    let whole = drawn(&mut client, [0, 99], &[]).await;
    let mut found = Vec::new();
    for piece in pieces(&whole) {
        let first = piece["lines"]["first"].as_u64().unwrap();
        let svg = piece["svg"].as_str().unwrap();
        for name in ["data-at", "data-power", "data-operand"] {
            for attribute in svg.split(&format!("{name}=\"")).skip(1) {
                for place in attribute.split('"').next().unwrap().split(' ') {
                    let (line, character) = place.split_once(':').unwrap();
                    let line = first + line.parse::<u64>().unwrap();
                    found.push((name, line, character.parse::<u64>().unwrap()));
                }
            }
        }
    }
    let places = |list: &str| -> Vec<(u64, u64)> {
        let list = state[list].as_array().unwrap().iter();
        let start = |it: &Value| it["range"]["start"].clone();
        let place = |it: Value| (it["line"].as_u64().unwrap(), it["character"].as_u64().unwrap());
        list.map(start).map(place).collect()
    };
    let (power, operands) = (places("power"), places("operands"));
    assert_eq!(found.iter().filter(|(name, ..)| *name == "data-at").count(), 7);
    for (name, line, character) in found {
        // A literal has no value.
        let among = if name == "data-operand" { &operands } else { &power };
        let is_literal = name == "data-operand" && (line, character) == (4, 28);
        assert_ne!(
            among.contains(&(line, character)),
            is_literal,
            "{name} {line}:{character}"
        );
    }
    client.finish().await;
}

#[tokio::test]
async fn an_edit_sends_one_network() {
    let mut client = Client::new().await;
    let rung = |index: usize| format!("+--[ ]( a{index} )--[/]( b )--( )( c{index} )--+\n");
    let program: String = (0..10_000).map(rung).collect();
    client.open(&program).await;
    let lines = [5000, 5040];
    let first = drawn(&mut client, lines, &[]).await;
    let all = first.to_string().len();
    assert_eq!(sent(&first).len(), 41, "what is shown, of 10,000");
    let known = keys(&first);
    // A letter in one of them, and a line above all of them.
    client.change(2, &[([5020, 8, 5020, 8], "x")]).await;
    let second = drawn(&mut client, lines, &known).await;
    assert_eq!((&second["version"], sent(&second)), (&json!(2), vec![5020]));
    let one = second.to_string().len();
    assert!(one * 5 < all, "{one} bytes for one, {all} for all");
    client.change(3, &[([0, 0, 0, 0], "\n")]).await;
    let known = keys(&second);
    let third = drawn(&mut client, [5001, 5041], &known).await;
    assert_eq!((&third["version"], sent(&third)), (&json!(3), vec![]));
    client.finish().await;
}

#[tokio::test]
async fn half_typed_is_shown_as_text() {
    let mut client = Client::new().await;
    client.open(MOTOR).await;
    client.change(2, &[([4, 10, 4, 14], "")]).await;
    let whole = drawn(&mut client, [0, 99], &[]).await;
    assert_eq!(pieces(&whole)[2]["kind"], "broken");
    let svg = pieces(&whole)[2]["svg"].as_str().unwrap();
    assert!(svg.contains("+--[ ]( ru-[TON]( warm"), "{svg}");
    client.finish().await;
}

#[tokio::test]
async fn errors_are_reported() {
    let mut client = Client::new().await;
    let lines = json!({"first": 0, "last": 9});
    let argument = json!({"uri": URI, "lines": lines});
    let refused = asked(&mut client, argument.clone()).await.unwrap_err();
    assert_eq!(refused, (-32803, format!("{URI} is not open in the editor")));
    client.open(MOTOR).await;
    let (code, message) = asked(&mut client, json!({"uri": URI})).await.unwrap_err();
    assert_eq!((code, message.contains("lines")), (-32602, true), "{message}");
    // What is out of range is brought back into it.
    for (first, last, rail) in [(9, 0, 0), (u32::MAX, u32::MAX, u32::MAX), (0, u32::MAX, 1)] {
        let argument = json!({"uri": URI, "lines": {"first": first, "last": last}, "rail": rail});
        assert!(asked(&mut client, argument).await.is_ok(), "{first} to {last}");
    }
    client.finish().await;
}

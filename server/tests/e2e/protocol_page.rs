//! `docs/protocol.md` tells the truth: its examples are one session, and it is played here.
//!
//! Each fenced `json` block is one message. What a client sends is sent; an answer or a notification of the server
//! must be what the server says, to the letter. With `UPDATE_EXPECT=1` the page is rewritten to what it says.

use std::collections::BTreeSet;
use std::fmt::Write;

use ladder_live::diagram_text::{DiagramText, DrawnText};
use ladder_live::messages;
use ladder_service::drawing_messages::{
    DeclarationTable, Declarations, DiagramEdit, DiagramEdited, DiagramOffer, DiagramOffered,
};
use ladder_service::typing_messages::{Cursor, EditDrawing, EditedDrawing, ToggleComment};
use ladder_service::{
    AskedBlock, AskedPage, CrossReference, CrossReferenced, Diagram, Drawn, DrawnFence, Fence,
    notation_messages,
};
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::{Value, json};

use crate::client::Client;

const PAGE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/protocol.md");

/// Notifications that a client sends; all others are the server's.
const OF_CLIENT: [&str; 6] = [
    "ladder/toDebugger",
    "ladder/simulationShown",
    "initialized",
    "textDocument/didOpen",
    "textDocument/didChange",
    "exit",
];

/// The stretches of the page that are JSON.
fn examples(page: &str) -> Vec<std::ops::Range<usize>> {
    let fence = "```json\n";
    let starts = page.match_indices(fence).map(|(at, _)| at + fence.len());
    starts
        .map(|start| start..start + page[start..].find("```").expect("a fence is closed"))
        .collect()
}

#[tokio::test]
async fn the_page_shows_what_the_server_says() {
    let page = std::fs::read_to_string(PAGE).unwrap();
    let mut updated = String::new();
    let mut copied = 0;
    let mut client = Client::silent();
    let mut asked = BTreeSet::new();
    let mut last_state = Value::Null;
    for range in examples(&page) {
        let shown: Value = serde_json::from_str(&page[range.clone()])
            .unwrap_or_else(|error| panic!("{error} in\n{}", &page[range.clone()]));
        let method = shown["method"].as_str();
        let told = match (shown["id"].as_i64(), method) {
            (Some(id), Some(_)) => {
                if shown["params"]["command"] == "ladder.simulate.pause" {
                    // What the run before it does would depend on the moment.
                    let is_over = |state: &Value| state["status"] == "paused";
                    client.notification("ladder/simulationState", is_over).await;
                }
                client.ask_as(id, &shown).await;
                asked.insert(id);
                continue;
            }
            (None, Some(method)) if OF_CLIENT.contains(&method) => {
                client.send(&shown).await;
                continue;
            }
            (None, Some(method)) => {
                // States in between may be left out, the newest comes in any case; one of what is shown holds less than the answer.
                let newest = |it: &Value| {
                    method != "ladder/simulationState" || *it == last_state || it.get("commands").is_some()
                };
                let params = client.notification(method, newest).await;
                json!({"jsonrpc": "2.0", "method": method, "params": params})
            }
            (Some(id), None) => {
                asked.remove(&id);
                match client.answer(id).await {
                    Ok(result) => {
                        last_state = result.get("state").unwrap_or(&result).clone();
                        json!({"jsonrpc": "2.0", "id": id, "result": result})
                    }
                    Err((code, message)) => {
                        json!({"jsonrpc": "2.0", "id": id, "error": {"code": code, "message": message}})
                    }
                }
            }
            (None, None) => panic!("not a message: {shown}"),
        };
        if std::env::var_os("UPDATE_EXPECT").is_some() {
            updated += &page[copied..range.start];
            updated += &pretty(&told);
            updated += "\n";
            copied = range.end;
        } else {
            assert_eq!(
                shown,
                told,
                "the page shows\n{}\nthe server says\n{}",
                pretty(&shown),
                pretty(&told)
            );
        }
    }
    // Those whose answer depends on the moment are not shown, but they must succeed.
    for id in asked {
        client.answer(id).await.unwrap();
    }
    assert_eq!(client.ended().await, ladder_server::Ending::Clean);
    if std::env::var_os("UPDATE_EXPECT").is_some() {
        updated += &page[copied..];
        std::fs::write(PAGE, updated).unwrap();
    }
}

/// Reading a message as its type and writing it again gives the same message: the page leaves out nothing that the
/// types have, and has nothing that they lack (they deny unknown members).
fn is_whole<T: Serialize + DeserializeOwned>(message: &Value) {
    let read: T =
        serde_json::from_value(message.clone()).unwrap_or_else(|error| panic!("{error}: {message}"));
    assert_eq!(serde_json::to_value(read).unwrap(), *message);
}

#[tokio::test]
async fn the_page_shows_every_command_whole() {
    let page = std::fs::read_to_string(PAGE).unwrap();
    let messages: Vec<Value> = examples(&page)
        .into_iter()
        .map(|range| serde_json::from_str(&page[range]).unwrap())
        .collect();
    let mut client = Client::silent();
    let offered = client
        .request("initialize", messages[0]["params"].clone())
        .await
        .unwrap();
    for command in offered["capabilities"]["executeCommandProvider"]["commands"]
        .as_array()
        .unwrap()
    {
        let example = messages
            .iter()
            .find(|it| it["params"]["command"] == *command)
            .unwrap_or_else(|| panic!("no example of {command}"));
        let argument = &example["params"]["arguments"][0];
        let answer = messages
            .iter()
            .find(|it| it["id"] == example["id"] && it.get("result").is_some());
        let answer = answer.map_or(&Value::Null, |it| &it["result"]);
        match command.as_str().unwrap().rsplit('.').next().unwrap() {
            "start" => {
                is_whole::<messages::Start>(argument);
                is_whole::<messages::Started>(answer);
                continue;
            }
            "debug" => {
                is_whole::<messages::Debug>(argument);
                is_whole::<messages::Debugged>(answer);
                continue;
            }
            "stop" => {
                is_whole::<messages::OfSession>(argument);
                is_whole::<messages::Stopped>(answer);
                continue;
            }
            // The program of the page has nothing to serve.
            "serve" => {
                is_whole::<messages::Serve>(argument);
                continue;
            }
            // Its answer depends on the moment.
            "pause" => {
                is_whole::<messages::OfSession>(argument);
                continue;
            }
            "diagram" => {
                is_whole::<Diagram>(argument);
                is_whole::<Drawn>(answer);
                continue;
            }
            "runScenarios" => {
                is_whole::<ladder_service::RunScenarios>(argument);
                is_whole::<ladder_service::ScenariosRun>(answer);
                continue;
            }
            "compare" => {
                is_whole::<ladder_service::Compare>(argument);
                is_whole::<ladder_service::ComparedTexts>(answer);
                continue;
            }
            "proveProperties" => {
                is_whole::<ladder_service::ProveProperties>(argument);
                is_whole::<ladder_service::PropertiesProved>(answer);
                continue;
            }
            "crossReference" => {
                is_whole::<CrossReference>(argument);
                is_whole::<CrossReferenced>(answer);
                continue;
            }
            "diagramText" => {
                is_whole::<DiagramText>(argument);
                is_whole::<DrawnText>(answer);
                continue;
            }
            "diagramPalette" => {
                is_whole::<ladder_service::Palette>(argument);
                is_whole::<ladder_service::Drawable>(answer);
                continue;
            }
            "declarations" => {
                is_whole::<Declarations>(argument);
                is_whole::<DeclarationTable>(answer);
                continue;
            }
            "diagramEdit" => {
                is_whole::<DiagramEdit>(argument);
                is_whole::<DiagramEdited>(answer);
                continue;
            }
            "diagramOffer" => {
                is_whole::<DiagramOffer>(argument);
                is_whole::<DiagramOffered>(answer);
                continue;
            }
            "scene" => {
                is_whole::<messages::SceneAsked>(argument);
                is_whole::<messages::SceneShown>(answer);
                continue;
            }
            "fence" => {
                is_whole::<Fence>(argument);
                is_whole::<DrawnFence>(answer);
                continue;
            }
            "rulePage" => {
                // A page has fences of its own: the answer is not shown.
                is_whole::<AskedPage>(argument);
                continue;
            }
            "libraryBlock" => {
                is_whole::<AskedBlock>(argument);
                continue;
            }
            "cursor" => {
                is_whole::<Cursor>(argument);
                assert_eq!(*answer, Value::Null);
                continue;
            }
            "edit" => {
                is_whole::<EditDrawing>(argument);
                is_whole::<EditedDrawing>(answer);
                continue;
            }
            "comment" => {
                is_whole::<ToggleComment>(argument);
                is_whole::<EditedDrawing>(answer);
                continue;
            }
            "convert" => {
                is_whole::<notation_messages::Convert>(argument);
                is_whole::<notation_messages::Converted>(answer);
                continue;
            }
            "notations" => {
                is_whole::<notation_messages::Nothing>(argument);
                is_whole::<notation_messages::Notations>(answer);
                continue;
            }
            "preview" => {
                is_whole::<notation_messages::Preview>(argument);
                is_whole::<notation_messages::Previewed>(answer);
                continue;
            }
            "why" => {
                is_whole::<messages::OfTag>(argument);
                is_whole::<messages::Why>(answer);
                continue;
            }
            "tags" => {
                is_whole::<messages::Search>(argument);
                is_whole::<messages::Found>(answer);
                continue;
            }
            "record" => {
                is_whole::<messages::Record>(argument);
                is_whole::<messages::Recorded>(answer);
                continue;
            }
            "history" => {
                is_whole::<messages::Past>(argument);
                is_whole::<messages::History>(answer);
                continue;
            }
            "trace" => {
                is_whole::<messages::Trace>(argument);
                is_whole::<messages::Traced>(answer);
                continue;
            }
            "goTo" => is_whole::<messages::GoTo>(argument),
            "breakpoints" => is_whole::<messages::Breakpoints>(argument),
            "step" | "back" => is_whole::<messages::StepBy>(argument),
            "run" => is_whole::<messages::Run>(argument),
            "speed" => is_whole::<messages::Speed>(argument),
            "show" => is_whole::<messages::Show>(argument),
            "set" | "force" => is_whole::<messages::Assign>(argument),
            "pulse" => is_whole::<messages::OfTag>(argument),
            "unforce" => is_whole::<messages::Unforce>(argument),
            _ => is_whole::<messages::OfSession>(argument),
        }
        is_whole::<messages::State>(answer);
    }
    client.request("shutdown", Value::Null).await.unwrap();
}

/// JSON as a person writes it: what fits on a line is on one, members in an order that reads well.
fn pretty(value: &Value) -> String {
    let mut out = String::new();
    write_pretty(&mut out, value, 0);
    out
}

const WIDTH: usize = 112;

fn write_pretty(out: &mut String, value: &Value, indent: usize) {
    let line = one_line(value);
    if indent + line.len() <= WIDTH {
        out.push_str(&line);
        return;
    }
    let inner = indent + 2;
    match value {
        Value::Array(items) => {
            out.push('[');
            for (nth, item) in items.iter().enumerate() {
                let _ = write!(out, "{}\n{:inner$}", if nth > 0 { "," } else { "" }, "");
                write_pretty(out, item, inner);
            }
            let _ = write!(out, "\n{:indent$}]", "");
        }
        Value::Object(_) => {
            out.push('{');
            for (nth, (name, member)) in members(value).into_iter().enumerate() {
                let _ = write!(
                    out,
                    "{}\n{:inner$}\"{name}\": ",
                    if nth > 0 { "," } else { "" },
                    ""
                );
                write_pretty(out, member, inner);
            }
            let _ = write!(out, "\n{:indent$}}}", "");
        }
        _ => out.push_str(&line),
    }
}

fn one_line(value: &Value) -> String {
    match value {
        Value::Array(items) => {
            format!("[{}]", items.iter().map(one_line).collect::<Vec<_>>().join(", "))
        }
        Value::Object(_) => {
            let members = members(value);
            let members = members
                .into_iter()
                .map(|(name, member)| format!("\"{name}\": {}", one_line(member)));
            format!("{{{}}}", members.collect::<Vec<_>>().join(", "))
        }
        _ => value.to_string(),
    }
}

/// Members that come first, in this order; the others follow in the order of the alphabet.
const ORDER: [&str; 23] = [
    "jsonrpc",
    "id",
    "method",
    "session",
    "uri",
    "version",
    "stale",
    "status",
    "scan",
    "timeMs",
    "name",
    "title",
    "kind",
    "type",
    "range",
    "start",
    "line",
    "code",
    "severity",
    "source",
    "message",
    "value",
    "textDocument",
];

fn members(value: &Value) -> Vec<(&String, &Value)> {
    let mut members: Vec<_> = value.as_object().into_iter().flatten().collect();
    members.sort_by_key(|(name, _)| ORDER.iter().position(|it| it == name).unwrap_or(ORDER.len()));
    members
}

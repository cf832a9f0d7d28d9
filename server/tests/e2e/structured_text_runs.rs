//! Simulations of Structured Text, and of projects with tasks.

use serde_json::{Value, json};

use crate::client::Client;
use crate::plant::Plant;

const COUNTER: &str = "\
PROGRAM Counter
VAR go : BOOL; n, m : INT; t : TON; END_VAR
    IF go THEN
        n := n + 1;
    END_IF;
    t(IN := go, PT := T#20ms);
    m := n * 2;
END_PROGRAM
";

async fn open(client: &mut Client, uri: &str, language: &str, text: &str) {
    let document = json!({"uri": uri, "languageId": language, "version": 1, "text": text});
    client
        .notify("textDocument/didOpen", json!({"textDocument": document}))
        .await;
}

fn tag<'a>(state: &'a Value, name: &str) -> &'a Value {
    let tags = state["tags"].as_array().unwrap();
    let found = tags.iter().find(|tag| tag["name"] == name);
    &found.unwrap_or_else(|| panic!("no {name} in {state}"))["value"]
}

async fn act(client: &mut Client, session: &str, command: &str, mut argument: Value) -> Value {
    argument["session"] = session.into();
    client.simulate(command, argument).await.unwrap()
}

async fn hover(client: &mut Client, uri: &str, line: u32, character: u32) -> String {
    let params = json!({"textDocument": {"uri": uri}, "position": {"line": line, "character": character}});
    let hover = client.request("textDocument/hover", params).await.unwrap();
    hover["contents"]["value"].as_str().unwrap_or_default().to_owned()
}

/// A client with a simulation of the counter that shows all of its lines; the first state.
async fn started(plant: &Plant) -> (Client, String, Value) {
    let mut client = Client::new().await;
    let uri = plant.uri("counter.st");
    open(&mut client, &uri, "st", COUNTER).await;
    let show = json!({"lines": [{"first": 0, "last": 7}], "tags": []});
    let start = json!({"uri": uri, "options": {"show": show}});
    let answer = client.simulate("start", start).await.unwrap();
    let session = answer["session"].as_str().unwrap().to_owned();
    (client, session, answer["state"].clone())
}

#[tokio::test]
async fn values_are_at_the_words_of_the_text() {
    let plant = Plant::with(&[("counter.st", COUNTER)]);
    let (mut client, s, first) = started(&plant).await;
    let mut operands = first["operands"].as_array().unwrap().clone();
    let at = |it: &Value| {
        let start = &it["range"]["start"];
        (start["line"].as_u64(), start["character"].as_u64())
    };
    operands.sort_by_key(at);
    let words = operands.iter().map(|it| {
        let start = &it["range"]["start"];
        format!(
            "{}:{} {}",
            start["line"],
            start["character"],
            it["tags"][0].as_str().unwrap()
        )
    });
    let words: Vec<String> = words.collect();
    assert_eq!(
        words,
        [
            "1:4 go",
            "1:15 n",
            "1:18 m",
            "1:27 t.ET",
            "2:7 go",
            "3:8 n",
            "5:4 t.ET",
            "5:12 go",
            "6:4 m",
            "6:9 n"
        ]
    );
    assert_eq!(first["power"], json!([]));
    act(&mut client, &s, "set", json!({"tag": "go", "value": true})).await;
    let state = act(&mut client, &s, "step", json!({"scans": 3})).await;
    assert_eq!(state["scan"], 3);
    let all = act(&mut client, &s, "tags", json!({"names": ["n", "m", "t.Q"]})).await;
    assert_eq!(
        (tag(&all, "n"), tag(&all, "m"), tag(&all, "t.Q")),
        (&json!(3), &json!(6), &json!(true))
    );
    let uri = plant.uri("counter.st");
    assert!(
        hover(&mut client, &uri, 6, 4)
            .await
            .starts_with("`m` is **6**\n\n---\n\n")
    );
    assert!(hover(&mut client, &uri, 3, 8).await.starts_with("`n` is **3**"));
    let why = act(&mut client, &s, "why", json!({"tag": "m"})).await;
    assert!(why["text"].as_str().unwrap().contains("line 7"), "{why}");
    assert_eq!(why["blocks"][0]["start"]["line"], 6);
    client.finish().await;
}

#[tokio::test]
async fn it_stops_at_a_statement() {
    let plant = Plant::with(&[("counter.st", COUNTER)]);
    let (mut client, s, _) = started(&plant).await;
    let state = act(&mut client, &s, "breakpoints", json!({"lines": [4]})).await;
    assert_eq!(state["breakpoints"][0]["range"]["start"]["line"], 5);
    let state = act(&mut client, &s, "step", json!({"scans": 1})).await;
    assert_eq!(
        state["hit"]["message"],
        "stopped in front of the statement in line 6"
    );
    let state = act(&mut client, &s, "stepRung", json!({})).await;
    assert_eq!(state["next"]["start"]["line"], 6);
    let refused = client
        .simulate("breakpoints", json!({"session": s, "lines": [7]}))
        .await
        .unwrap_err();
    assert_eq!(refused.1, "there is no statement in line 8 or below it");
    client.finish().await;
}

#[tokio::test]
async fn it_follows_what_is_typed() {
    let plant = Plant::with(&[("counter.st", COUNTER)]);
    let (mut client, s, _) = started(&plant).await;
    act(&mut client, &s, "set", json!({"tag": "go", "value": true})).await;
    act(&mut client, &s, "step", json!({"scans": 2})).await;
    let uri = plant.uri("counter.st");
    let replace = |version: i32, text: String| json!({"textDocument": {"uri": uri, "version": version}, "contentChanges": [{"text": text}]});
    let tripled = format!("\n{}", COUNTER.replace("* 2", "* 3"));
    let change = replace(2, tripled.clone());
    client.notify("textDocument/didChange", change).await;
    let state = act(&mut client, &s, "step", json!({"scans": 1})).await;
    assert_eq!((&state["stale"], &state["version"]), (&json!(false), &json!(2)));
    let all = act(&mut client, &s, "tags", json!({"names": ["n", "m"]})).await;
    assert_eq!((tag(&all, "n"), tag(&all, "m")), (&json!(3), &json!(9)));
    // One with an error is not run, and the one before it is shown in the lines that are the same.
    let change = replace(3, tripled.replace("THEN", "").replace("\nPROGRAM", "\n\nPROGRAM"));
    client.notify("textDocument/didChange", change).await;
    let state = act(&mut client, &s, "step", json!({"scans": 1})).await;
    assert_eq!(state["stale"], true);
    assert!(hover(&mut client, &uri, 8, 4).await.contains("`m` is **12**"));
    client.finish().await;
}

#[tokio::test]
async fn a_text_with_errors_is_not_started() {
    let plant = Plant::with(&[("counter.st", COUNTER)]);
    let mut client = Client::new().await;
    let uri = plant.uri("counter.st");
    open(&mut client, &uri, "st", &COUNTER.replace("THEN", "")).await;
    let refused = client.simulate("start", json!({"uri": uri})).await.unwrap_err();
    assert_eq!(
        refused.1,
        "the program has an error in line 4: `THEN` is expected here, not `n`"
    );
    client.finish().await;
}

#[tokio::test]
async fn the_tasks_of_a_project_run_at_their_rates() {
    let settings = "[[task]]\nname = \"slow\"\ninterval = \"100ms\"\nprograms = [\"counter.st\"]\n\
                    [[task]]\nname = \"fast\"\ninterval = \"20ms\"\nprograms = [\"own.clad\"]\n";
    let own = "+--[ADD]( k, k, 1 )--+\n";
    let plant = Plant::with(&[
        ("counter.st", COUNTER),
        ("ladder.toml", settings),
        ("own.clad", own),
    ]);
    let mut client = Client::new().await;
    let uri = plant.uri("ladder.toml");
    open(&mut client, &uri, "toml", settings).await;
    let answer = client.simulate("start", json!({"uri": uri})).await.unwrap();
    let s = answer["session"].as_str().unwrap().to_owned();
    act(
        &mut client,
        &s,
        "set",
        json!({"tag": "counter.go", "value": true}),
    )
    .await;
    let state = act(&mut client, &s, "step", json!({"scans": 10})).await;
    assert_eq!(
        (tag(&state, "own.k"), tag(&state, "counter.n")),
        (&json!(10), &json!(2))
    );
    // What is typed into a program of it counts.
    let counter = plant.uri("counter.st");
    open(&mut client, &counter, "st", &COUNTER.replace("n + 1", "n + 10")).await;
    let mut n = 2;
    for _ in 0..50 {
        let state = act(&mut client, &s, "step", json!({"scans": 5})).await;
        let now = tag(&state, "counter.n").as_i64().unwrap();
        if now - n == 10 {
            client.finish().await;
            return;
        }
        n = now;
    }
    panic!("it goes on as it was");
}

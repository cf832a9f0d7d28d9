//! A simulation follows the text in the editor while it runs.

use serde_json::{Value, json};

use crate::client::{Client, URI, span};

const MOTOR: &str = "\
+--\\--[ ]( start )--\\--[/]( stop )--( )( run )--+
|  /--[ ]( run )----/                            |
+--[ ]( run )--[TON]( t, T#50ms )--( )( warm )--+
";

/// A motor that runs since the second of five scans.
async fn running(options: Value) -> (Client, String) {
    let mut client = Client::new().await;
    client.open(MOTOR).await;
    let argument = json!({"uri": URI, "options": options});
    let answer = client.simulate("start", argument).await.unwrap();
    let s = answer["session"].as_str().unwrap().to_owned();
    act(&mut client, "step", json!({"session": s})).await;
    act(
        &mut client,
        "set",
        json!({"session": s, "tag": "start", "value": true}),
    )
    .await;
    act(&mut client, "step", json!({"session": s, "scans": 4})).await;
    (client, s)
}

async fn act(client: &mut Client, command: &str, argument: Value) -> Value {
    client.simulate(command, argument).await.unwrap()
}

/// The state for a version of the text.
async fn state_of(client: &mut Client, version: i32) -> Value {
    client
        .notification("ladder/simulationState", |it| it["version"] == version)
        .await
}

fn value(state: &Value, name: &str) -> Value {
    let tags = state["tags"].as_array().unwrap();
    tags.iter().find(|tag| tag["name"] == name).unwrap()["value"].clone()
}

/// The live elements, each as line and first column.
fn live(state: &Value) -> Vec<(u64, u64)> {
    let power = state["power"].as_array().unwrap().iter();
    power
        .filter(|element| element["on"] == true)
        .map(|element| {
            let start = &element["range"]["start"];
            (
                start["line"].as_u64().unwrap(),
                start["character"].as_u64().unwrap(),
            )
        })
        .collect()
}

#[tokio::test]
async fn a_comment_changes_nothing() {
    let (mut client, s) = running(json!({})).await;
    let before = act(&mut client, "state", json!({"session": s})).await;
    client.change(2, &[([0, 0, 0, 0], "# a motor #\n")]).await;
    let state = state_of(&mut client, 2).await;
    assert_eq!(
        (&state["stale"], &state["scan"], state.get("change")),
        (&json!(false), &json!(5), None)
    );
    assert_eq!(state["tags"], before["tags"]);
    assert_eq!(state["behind"], 5);
    let below: Vec<(u64, u64)> = live(&before).iter().map(|(line, at)| (line + 1, *at)).collect();
    assert_eq!(live(&state), below);
    client.finish().await;
}

#[tokio::test]
async fn a_changed_program_goes_on() {
    let (mut client, s) = running(json!({})).await;
    let force = json!({"session": s, "tag": "stop", "value": false});
    act(&mut client, "force", force).await;
    client
        .change(2, &[([2, 0, 2, 0], "+--[ ]( run )--( )( lamp )--+\n")])
        .await;
    let state = state_of(&mut client, 2).await;
    assert_eq!(state["change"], json!({"number": 1, "scan": 5}));
    assert_eq!(
        (&state["scan"], value(&state, "run"), value(&state, "t.ET")),
        (&json!(5), json!(true), json!(30))
    );
    assert_eq!((&state["forced"], &state["behind"]), (&json!(1), &json!(5)));
    let state = act(&mut client, "step", json!({"session": s})).await;
    assert_eq!(
        (value(&state, "lamp"), value(&state, "t.ET")),
        (json!(true), json!(40))
    );
    // A longer time, and a rung with an error; then without it.
    client
        .change(3, &[([3, 28, 3, 28], "0"), ([3, 0, 3, 0], "+--[ ]( t )--+\n")])
        .await;
    let stale = state_of(&mut client, 3).await;
    assert_eq!(stale["stale"], true);
    client.change(4, &[([3, 0, 4, 0], "")]).await;
    let state = state_of(&mut client, 4).await;
    assert_eq!(
        (&state["stale"], &state["change"]["number"]),
        (&json!(false), &json!(2))
    );
    // Back over both changes, and there the lines are those that are still the same.
    let state = act(&mut client, "back", json!({"session": s, "scans": 3})).await;
    assert_eq!((&state["scan"], &state["version"]), (&json!(3), &json!(4)));
    assert!(
        live(&state).iter().all(|(line, _)| *line < 2),
        "{:?}",
        live(&state)
    );
    assert!(!live(&state).is_empty());
    client.finish().await;
}

#[tokio::test]
async fn with_errors_the_last_good_program_runs_on() {
    let (mut client, s) = running(json!({})).await;
    let before = act(&mut client, "state", json!({"session": s})).await;
    client.change(2, &[([1, 0, 1, 0], "\n+--[TON]( \n")]).await;
    let state = state_of(&mut client, 2).await;
    assert_eq!((&state["stale"], state.get("change")), (&json!(true), None));
    let moved: Vec<(u64, u64)> = live(&before)
        .iter()
        .map(|&(line, at)| (if line == 0 { 0 } else { line + 2 }, at))
        .collect();
    assert_eq!(live(&state), moved);
    let state = act(&mut client, "step", json!({"session": s})).await;
    assert_eq!(
        (&state["stale"], &state["scan"], value(&state, "t.ET")),
        (&json!(true), &json!(6), json!(40))
    );
    // A line that was changed shows nothing.
    client.change(3, &[([4, 4, 4, 5], "x")]).await;
    let state = state_of(&mut client, 3).await;
    assert!(
        live(&state).iter().all(|(line, _)| *line != 4),
        "{:?}",
        live(&state)
    );
    let why = act(&mut client, "why", json!({"session": s, "tag": "run"})).await;
    assert_eq!(why["blocks"][0], span([0, 36, 0, 46]));
    // Undone, it is as if nothing had been.
    client.replace(4, MOTOR).await;
    let state = state_of(&mut client, 4).await;
    assert_eq!((&state["stale"], state.get("change")), (&json!(false), None));
    assert_eq!(value(&state, "t.ET"), 40);
    client.finish().await;
}

#[tokio::test]
async fn what_could_not_be_kept_is_listed() {
    let (mut client, _) = running(json!({})).await;
    client.change(2, &[([2, 16, 2, 19], "TOF")]).await;
    let state = state_of(&mut client, 2).await;
    assert_eq!(
        state["change"]["lost"],
        json!([{
            "message": "t was a TON and is a TOF now: it begins with its initial value",
            "range": span([2, 22, 2, 23]),
        }])
    );
    client.finish().await;
}

/// The next state of which something holds, to a client that shows each at once.
async fn next_shown(client: &mut Client, session: &str, wanted: impl Fn(&Value) -> bool) -> Value {
    loop {
        let state = client.notification("ladder/simulationState", |_| true).await;
        client
            .notify("ladder/simulationShown", json!({"session": session}))
            .await;
        if wanted(&state) {
            return state;
        }
    }
}

#[tokio::test]
async fn what_is_shown_is_reported_whole_where_stepping_goes_across_a_change() {
    let show = json!({"lines": [{"first": 0, "last": 3}]});
    let (mut client, s) = running(json!({"show": show})).await;
    client
        .notify("ladder/simulationShown", json!({"session": s}))
        .await;
    client.change(2, &[([2, 16, 2, 19], "TOF")]).await;
    next_shown(&mut client, &s, |state| state["version"] == 2).await;
    let mut reported = Vec::new();
    for (command, scan) in [("step", 6), ("back", 5), ("back", 4), ("step", 5)] {
        act(&mut client, command, json!({"session": s})).await;
        let state = next_shown(&mut client, &s, |state| state["scan"] == scan).await;
        let timer = live(&state).iter().any(|(line, _)| *line == 2);
        reported.push((
            command,
            state.get("delta").is_none(),
            timer,
            state["program"].clone(),
        ));
    }
    // Before the change the line of the timer was another one: nothing is known of it.
    let (in_part, whole) = (false, true);
    let (first, second) = (Value::Null, json!(1));
    assert_eq!(
        reported,
        [
            ("step", in_part, true, second.clone()),
            ("back", in_part, false, second.clone()),
            ("back", whole, false, first),
            ("step", whole, true, second)
        ]
    );
    client.finish().await;
}

#[tokio::test]
async fn what_is_shown_is_reported_whole_after_a_change() {
    let show = json!({"lines": [{"first": 0, "last": 3}]});
    let (mut client, s) = running(json!({"show": show})).await;
    client
        .notify("ladder/simulationShown", json!({"session": s}))
        .await;
    client.change(2, &[([0, 0, 0, 0], "# a motor #\n")]).await;
    let state = next_shown(&mut client, &s, |state| state["version"] == 2).await;
    assert!(state.get("delta").is_none(), "{state}");
    assert!(live(&state).contains(&(1, 36)), "{state}");
    assert!(live(&state).iter().all(|(line, _)| *line > 0));
    client.finish().await;
}

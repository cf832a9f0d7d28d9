//! Simulations that go back, stop of themselves and say why.

use std::fs;

use serde_json::{Value, json};

use crate::client::{Client, URI, span};

const MOTOR: &str = "\
+--\\--[ ]( start )--\\--[/]( stop )--( )( run )--+
|  /--[ ]( run )----/                            |
+--[ ]( run )--( )( lamp )--+
";

async fn started(program: &str, options: Value) -> (Client, String) {
    let mut client = Client::new().await;
    client.open(program).await;
    let argument = json!({"uri": URI, "options": options});
    let answer = client.simulate("start", argument).await.unwrap();
    let session = answer["session"].as_str().unwrap().to_owned();
    (client, session)
}

async fn set(client: &mut Client, session: &str, tag: &str, value: bool) {
    let argument = json!({"session": session, "tag": tag, "value": value});
    client.simulate("set", argument).await.unwrap();
}

async fn act(client: &mut Client, session: &str, command: &str) -> Value {
    client
        .simulate(command, json!({"session": session}))
        .await
        .unwrap()
}

fn value(state: &Value, name: &str) -> Value {
    let tags = state["tags"].as_array().unwrap();
    tags.iter().find(|tag| tag["name"] == name).unwrap()["value"].clone()
}

#[tokio::test]
async fn back_and_forward_again() {
    let (mut client, s) = started(MOTOR, json!({})).await;
    act(&mut client, &s, "step").await;
    set(&mut client, &s, "start", true).await;
    act(&mut client, &s, "step").await;
    let state = act(&mut client, &s, "back").await;
    assert_eq!(
        (
            &state["scan"],
            &state["behind"],
            &state["ahead"],
            value(&state, "start")
        ),
        (&json!(1), &json!(1), &json!(1), json!(false))
    );
    let state = act(&mut client, &s, "step").await;
    assert_eq!((value(&state, "run"), &state["ahead"]), (json!(true), &json!(0)));
    // Another future.
    act(&mut client, &s, "back").await;
    set(&mut client, &s, "stop", true).await;
    let state = act(&mut client, &s, "step").await;
    assert_eq!((value(&state, "run"), &state["ahead"]), (json!(false), &json!(0)));
    client.finish().await;
}

#[tokio::test]
async fn a_program_that_has_ended_lives_again_after_a_step_back() {
    let (mut client, s) = started("+--[ ]( x )--<END>--+\n", json!({"inputs": {"x": true}})).await;
    assert_eq!(act(&mut client, &s, "step").await["status"], "ended");
    let state = act(&mut client, &s, "back").await;
    assert_eq!((&state["status"], &state["scan"]), (&json!("paused"), &json!(0)));
    client.finish().await;
}

#[tokio::test]
async fn the_history_is_as_long_as_asked_for() {
    let (mut client, s) = started(MOTOR, json!({"history": 3})).await;
    let state = client
        .simulate("step", json!({"session": s, "scans": 9}))
        .await
        .unwrap();
    assert_eq!(state["behind"], 3);
    let past = client
        .simulate(
            "history",
            json!({"session": s, "tags": ["run", "SYS.SCAN"], "scans": 9}),
        )
        .await
        .unwrap();
    assert_eq!(past["firstScan"], 5);
    assert_eq!(
        past["tags"][1],
        json!({"name": "SYS.SCAN", "type": "DINT", "values": [5, 6, 7, 8]})
    );
    client.finish().await;
}

#[tokio::test]
async fn a_run_stops_at_a_breakpoint_and_goes_on_from_there() {
    let (mut client, s) = started(MOTOR, json!({})).await;
    let breakpoints = json!({"session": s, "lines": [2], "tags": ["run"]});
    let state = client.simulate("breakpoints", breakpoints).await.unwrap();
    assert_eq!(
        state["breakpoints"],
        json!([{"range": span([2, 0, 3, 0])}, {"tag": "run"}])
    );
    let run = json!({"session": s, "realTime": false});
    client.simulate("run", run.clone()).await.unwrap();
    let state = client
        .notification("ladder/simulationState", |it| it["hit"].is_object())
        .await;
    assert_eq!(
        (&state["status"], &state["hit"]["message"], &state["next"]),
        (
            &json!("paused"),
            &json!("stopped in front of the rung in line 3"),
            &span([2, 3, 2, 13])
        )
    );
    set(&mut client, &s, "start", true).await;
    let state = act(&mut client, &s, "step").await;
    // `start` was given within a scan and waited for its end.
    assert_eq!((&state["scan"], value(&state, "start")), (&json!(1), json!(true)));
    client.simulate("run", run).await.unwrap();
    let state = client
        .notification("ladder/simulationState", |it| {
            it["hit"]["message"] != "stopped in front of the rung in line 3" && it["hit"].is_object()
        })
        .await;
    assert_eq!(
        state["hit"]["message"],
        "run changed from FALSE to TRUE in line 1"
    );
    assert_eq!(
        (&state["hit"]["range"], &state["hit"]["number"]),
        (&span([0, 36, 0, 46]), &json!(2))
    );
    let wrong = client
        .simulate("breakpoints", json!({"session": s, "lines": [7], "tags": []}))
        .await;
    assert_eq!(wrong.unwrap_err().1, "there is no rung in line 8 or below it");
    client.finish().await;
}

#[tokio::test]
async fn why() {
    let (mut client, s) = started(MOTOR, json!({})).await;
    act(&mut client, &s, "step").await;
    let why = client
        .simulate("why", json!({"session": s, "tag": "LAMP"}))
        .await
        .unwrap();
    assert_eq!(why["tag"], "lamp");
    assert_eq!(why["blocks"], json!([span([2, 15, 2, 26]), span([2, 3, 2, 13])]));
    assert_eq!(
        why["text"].as_str().unwrap().lines().next().unwrap(),
        "lamp is 0 since the start: line 3, ( )( lamp ) wrote it; blocked by [ ]( run ) (line 3, column 4): run is 0"
    );
    let reason = &why["reason"];
    assert_eq!(
        reason["text"],
        why["text"].as_str().unwrap().lines().next().unwrap()
    );
    assert_eq!(reason["since"], json!({"kind": "start"}));
    let write = &reason["write"];
    assert_eq!(write["range"], span([2, 15, 2, 26]));
    let stop = &write["ways"][0][0];
    assert_eq!(
        (&stop["range"], &stop["stops"]),
        (&span([2, 3, 2, 13]), &json!(true))
    );
    // What it depends on hangs below it, with places of its own.
    let run = &stop["because"][0];
    assert_eq!((&run["tag"], &run["cause"]), (&json!("run"), &json!("block")));
    assert_eq!(run["write"]["block"], "( )( run )");
    assert_eq!(run["write"]["ways"][0][0]["because"][0]["cause"], "initial");
    client.finish().await;
}

#[tokio::test]
async fn a_client_that_takes_deltas_is_reported_what_has_changed() {
    let (mut client, s) = started(MOTOR, json!({"deltas": true})).await;
    set(&mut client, &s, "start", true).await;
    let whole = client.notification("ladder/simulationState", |_| true).await;
    assert_eq!(
        (whole.get("delta"), whole["tags"].as_array().unwrap().len()),
        (None, 4)
    );
    let run = json!({"session": s, "scans": 20, "realTime": true});
    client.simulate("run", run).await.unwrap();
    let mut power: Vec<Value> = whole["power"].as_array().unwrap().clone();
    let mut deltas = 0;
    let last = loop {
        let state = client.notification("ladder/simulationState", |_| true).await;
        for element in state["power"].as_array().unwrap() {
            let known = power.iter_mut().find(|it| it["range"] == element["range"]);
            *known.unwrap() = element.clone();
        }
        if state.get("delta").is_some() {
            deltas += 1;
        }
        if state["scan"] == 20 && state["status"] == "paused" {
            break state;
        }
    };
    assert!(deltas > 0, "{last}");
    let state = act(&mut client, &s, "state").await;
    assert_eq!(state["power"], json!(power));
    // Nothing but the time changes any more: no power is sent, however many states are.
    let run = json!({"session": s, "scans": 40, "realTime": true});
    client.simulate("run", run).await.unwrap();
    loop {
        let state = client.notification("ladder/simulationState", |_| true).await;
        if state.get("delta").is_some() {
            assert_eq!(state["power"], json!([]));
        }
        if state["scan"] == 60 && state["status"] == "paused" {
            break;
        }
    }
    client.finish().await;
}

#[tokio::test]
async fn a_workspace_says_how_long_and_what_is_kept() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("pump.clad");
    let program = "VAR RETAIN n : INT; END_VAR\n+--[ADD]( n, n, 1 )--+\n";
    fs::write(&path, program).unwrap();
    fs::write(
        folder.path().join("ladder.toml"),
        "[simulate]\nhistory = 2\ninterval = \"20ms\"\nretain = \"pump.retain\"\n",
    )
    .unwrap();
    let uri = format!("file://{}", path.display());
    for starts in 0..3 {
        let mut client = Client::new().await;
        client.open_as(&uri, 1, program).await;
        let answer = client.simulate("start", json!({"uri": uri})).await.unwrap();
        let session = answer["session"].as_str().unwrap().to_owned();
        if starts == 2 {
            let note = answer["notes"][0].as_str().unwrap();
            assert!(note.contains("pump.retain: the file is damaged"), "{note}");
            assert_eq!(value(&answer["state"], "n"), 0);
            client.finish().await;
            break;
        }
        assert_eq!(
            (value(&answer["state"], "n"), answer.get("notes")),
            (json!(starts * 5), None)
        );
        let step = json!({"session": session, "scans": 5});
        let state = client.simulate("step", step).await.unwrap();
        assert_eq!((&state["behind"], &state["timeMs"]), (&json!(2), &json!(100)));
        client
            .simulate("stop", json!({"session": session}))
            .await
            .unwrap();
        client.finish().await;
        let kept = folder.path().join("pump.retain");
        assert!(fs::read_to_string(&kept).unwrap().contains("n\tINT\t"));
        if starts == 1 {
            fs::write(&kept, "ladder-retain 1\n").unwrap();
        }
    }
}

#[tokio::test]
async fn a_warm_restart_keeps_what_is_retentive() {
    let program =
        "VAR RETAIN n : INT; END_VAR\nVAR m : INT; END_VAR\n+--[ADD]( n, n, 1 )--[ADD]( m, m, 1 )--+\n";
    let (mut client, s) = started(program, json!({})).await;
    act(&mut client, &s, "step").await;
    let state = act(&mut client, &s, "warmRestart").await;
    assert_eq!(
        (
            value(&state, "n"),
            value(&state, "m"),
            &state["scan"],
            &state["behind"]
        ),
        (json!(1), json!(0), &json!(0), &json!(0))
    );
    client.finish().await;
}

#[tokio::test]
async fn no_answer_holds_more_of_the_past_than_a_client_can_take() {
    let mut client = Client::new().await;
    client.open("+--[ ]( a )--( )( b )--+\n").await;
    let answer = client.simulate("start", json!({"uri": URI})).await.unwrap();
    let session = &answer["session"];
    client
        .simulate("step", json!({"session": session, "scans": 300}))
        .await
        .unwrap();
    let many = vec!["a"; 1000];
    let asked = json!({"session": session, "tags": many, "scans": u64::MAX});
    let (_, refused) = client.simulate("history", asked).await.unwrap_err();
    assert!(
        refused.contains("1000 tags in 301 scans") && refused.contains("the last 200 scans"),
        "{refused}"
    );
    let asked = json!({"session": session, "tags": many, "scans": 200});
    let past = client.simulate("history", asked).await.unwrap();
    assert_eq!(past["tags"][999]["values"].as_array().unwrap().len(), 200);
    client.finish().await;
}

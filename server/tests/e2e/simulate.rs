//! The simulator, as an editor drives it.

use std::time::{Duration, Instant};

use serde_json::{Value, json};

use crate::client::{Answer, Client, URI, span};

const MOTOR: &str = "\
+--\\--[ ]( start )--\\--[/]( stop )--( )( run )--+
|  /--[ ]( run )----/                            |
";

const COUNT: &str = "\
VAR_INPUT  go : BOOL;  END_VAR
VAR  n : DINT;  t : TON;  big : LINT;  ratio : LREAL;  note : STRING;  END_VAR
+--[ ]( go )--[ADD]( n, n, 1 )--[TON]( t, 50ms )--( )( late )--+
";

/// A client with a session of this program, and the first state.
async fn started(program: &str) -> (Client, String, Value) {
    let mut client = Client::new().await;
    client.open(program).await;
    let answer = client.simulate("start", json!({"uri": URI})).await.unwrap();
    let session = answer["session"].as_str().unwrap().to_owned();
    (client, session, answer["state"].clone())
}

fn tag<'a>(state: &'a Value, name: &str) -> &'a Value {
    let tags = state["tags"].as_array().unwrap();
    tags.iter()
        .find(|tag| tag["name"] == name)
        .unwrap_or_else(|| panic!("no {name} in {state}"))
}

/// Whether power flows at this place.
fn power(state: &Value, range: [u32; 4]) -> bool {
    let power = state["power"].as_array().unwrap();
    let there = power.iter().find(|it| it["range"] == span(range));
    there.unwrap_or_else(|| panic!("nothing at {range:?} in {power:?}"))["on"]
        .as_bool()
        .unwrap()
}

async fn set(client: &mut Client, session: &str, tag: &str, value: Value) -> Answer {
    client
        .simulate("set", json!({"session": session, "tag": tag, "value": value}))
        .await
}

async fn step(client: &mut Client, session: &str, scans: u64) -> Value {
    client
        .simulate("step", json!({"session": session, "scans": scans}))
        .await
        .unwrap()
}

#[tokio::test]
async fn a_motor_starts_holds_and_stops() {
    let (mut client, s, first) = started(MOTOR).await;
    assert_eq!(
        (&first["status"], &first["scan"], &first["version"]),
        (&json!("paused"), &json!(0), &json!(1))
    );
    assert_eq!((&first["stale"], &first["timeMs"]), (&json!(false), &json!(0)));
    let names: Vec<_> = first["tags"]
        .as_array()
        .unwrap()
        .iter()
        .map(|tag| tag["name"].as_str().unwrap())
        .collect();
    assert_eq!(names, ["start", "stop", "run"]);
    assert_eq!(
        tag(&first, "start"),
        &json!({"name": "start", "type": "BOOL", "value": false, "text": "0", "role": "input", "forced": false})
    );

    set(&mut client, &s, "start", json!(true)).await.unwrap();
    let state = client.simulate("step", json!({"session": s})).await.unwrap();
    assert_eq!((&state["scan"], &state["timeMs"]), (&json!(1), &json!(10)));
    assert_eq!(tag(&state, "run")["value"], true);
    assert!(power(&state, [0, 36, 0, 46]), "the coil");
    assert!(
        !power(&state, [1, 6, 1, 16]),
        "the seal-in: run was low when it was read"
    );

    set(&mut client, &s, "start", json!("FALSE")).await.unwrap();
    let state = step(&mut client, &s, 3).await;
    assert_eq!(
        (tag(&state, "run")["value"].clone(), &state["scan"]),
        (json!(true), &json!(4))
    );
    assert!(power(&state, [1, 6, 1, 16]) && !power(&state, [0, 6, 0, 18]));

    set(&mut client, &s, "stop", json!(1)).await.unwrap();
    assert_eq!(tag(&step(&mut client, &s, 1).await, "run")["value"], false);
    client.finish().await;
}

#[tokio::test]
async fn forcing_holds_a_value_until_it_is_let_go() {
    let (mut client, s, _) = started(MOTOR).await;
    let force = json!({"session": s, "tag": "run", "value": true});
    let state = client.simulate("force", force).await.unwrap();
    assert_eq!(
        (&tag(&state, "run")["value"], &tag(&state, "run")["forced"]),
        (&json!(true), &json!(true))
    );
    set(&mut client, &s, "stop", json!(true)).await.unwrap();
    assert_eq!(tag(&step(&mut client, &s, 2).await, "run")["value"], true);
    let state = client
        .simulate("unforce", json!({"session": s, "tag": "run"}))
        .await
        .unwrap();
    assert_eq!(tag(&state, "run")["forced"], false);
    assert_eq!(tag(&step(&mut client, &s, 1).await, "run")["value"], false);

    client
        .simulate("force", json!({"session": s, "tag": "start", "value": true}))
        .await
        .unwrap();
    let state = client.simulate("unforce", json!({"session": s})).await.unwrap();
    assert_eq!(tag(&state, "start")["forced"], false);
    client.finish().await;
}

#[tokio::test]
async fn values_are_written_as_their_types() {
    let (mut client, s, first) = started(COUNT).await;
    assert_eq!(
        tag(&first, "t.ET"),
        &json!({"name": "t.ET", "type": "TIME", "value": 0, "text": "0ms", "role": "internal", "forced": false})
    );
    set(&mut client, &s, "go", json!(true)).await.unwrap();
    let state = step(&mut client, &s, 3).await;
    assert_eq!(tag(&state, "n")["value"], 3);
    assert_eq!(tag(&state, "t.ET")["value"], 20);
    // Beyond what a double holds, an integer is text.
    let state = set(&mut client, &s, "big", json!("9223372036854775807"))
        .await
        .unwrap();
    assert_eq!(tag(&state, "big")["value"], "9223372036854775807");
    let state = set(&mut client, &s, "big", json!(-5)).await.unwrap();
    assert_eq!(tag(&state, "big")["value"], -5);
    let state = set(&mut client, &s, "ratio", json!(0.25)).await.unwrap();
    assert_eq!(tag(&state, "ratio")["value"], 0.25);
    let state = set(&mut client, &s, "note", json!("Grüße")).await.unwrap();
    assert_eq!(tag(&state, "note")["value"], "Grüße");
    // What a person types is read by its type.
    for (name, text, value) in [
        ("go", "off", json!(false)),
        ("n", "16#FF", json!(255)),
        ("note", "'a'", json!("a")),
    ] {
        let typed = json!({"session": s, "tag": name, "text": text});
        let state = client.simulate("set", typed).await.unwrap();
        assert_eq!(tag(&state, name)["value"], value);
    }
    client.finish().await;
}

#[tokio::test]
async fn how_it_is_comes_in_words() {
    let (mut client, s, first) = started(MOTOR).await;
    assert_eq!(first["text"], "paused, scan 0, 0ms");
    let force = json!({"session": s, "tag": "run", "value": true});
    client.simulate("force", force).await.unwrap();
    let slow = json!({"session": s, "speed": 0.1});
    let state = client.simulate("speed", slow).await.unwrap();
    assert_eq!(state["text"], "paused, scan 0, 0ms, 0.1x speed, 1 forced");
    // A run is as fast as was said last, until something else is said.
    let state = client.simulate("run", json!({"session": s})).await.unwrap();
    assert_eq!(state["text"], "running, scan 0, 0ms, 0.1x speed, 1 forced");
    let full = json!({"session": s, "realTime": false});
    client.simulate("speed", full).await.unwrap();
    let far = |it: &Value| it["scan"].as_u64() > Some(1000);
    let state = client.notification("ladder/simulationState", far).await;
    let text = state["text"].as_str().unwrap();
    assert!(
        text.starts_with("running, scan ") && text.ends_with(", full speed, 1 forced"),
        "{text}"
    );
    // Errors in the text.
    client
        .change(2, &[([0, 0, 0, 0], "+--[ ]( start )--\\--+\n")])
        .await;
    let broken = |it: &Value| it["stale"] == true;
    let state = client.notification("ladder/simulationState", broken).await;
    let text = state["text"].as_str().unwrap();
    assert!(
        text.ends_with(", 1 forced, before the errors in the text"),
        "{text}"
    );
    client.finish().await;
}

#[tokio::test]
async fn errors_are_explained() {
    let (mut client, s, _) = started(COUNT).await;
    let (code, message) = set(&mut client, &s, "gi", json!(true)).await.unwrap_err();
    assert_eq!(code, -32803);
    assert!(message.contains("go"), "did you mean: {message}");
    for (tag, value) in [
        ("go", json!(2)),
        ("n", json!("many")),
        ("n", json!(1.5)),
        ("big", json!(null)),
        ("n", json!(3_000_000_000_u64)),
    ] {
        let (code, message) = set(&mut client, &s, tag, value.clone()).await.unwrap_err();
        assert_eq!(code, -32602, "{tag} := {value}: {message}");
        assert!(message.contains(tag), "{message}");
    }
    for (command, argument, code) in [
        ("step", json!({"session": "s99"}), -32803),
        ("step", json!({"session": 1}), -32602),
        ("step", json!({"session": s, "scans": "one"}), -32602),
        ("state", json!({"session": s, "extra": 1}), -32602),
        ("start", json!({"uri": URI, "options": {"intervalms": 5}}), -32602),
        ("start", json!({"uri": "file:///other.clad"}), -32803),
        ("start", json!({"uri": URI, "options": {"intervalMs": 0}}), -32602),
        (
            "start",
            json!({"uri": URI, "options": {"intervalMs": -1}}),
            -32602,
        ),
        (
            "start",
            json!({"uri": URI, "options": {"inputs": {"nobody": true}}}),
            -32803,
        ),
        ("fly", json!({}), -32602),
    ] {
        let (got, message) = client.simulate(command, argument.clone()).await.unwrap_err();
        assert_eq!(got, code, "{command} {argument}: {message}");
    }
    let (code, _) = client
        .request(
            "workspace/executeCommand",
            json!({"command": "ladder.simulate.state", "arguments": []}),
        )
        .await
        .unwrap_err();
    assert_eq!(code, -32602);
    client.finish().await;
}

#[tokio::test]
async fn a_program_with_errors_is_not_simulated() {
    let mut client = Client::new().await;
    client.open("+--[ ]( a )--[BAKE]( b )--( )( y )--+\n").await;
    let (code, message) = client.simulate("start", json!({"uri": URI})).await.unwrap_err();
    assert_eq!(code, -32803);
    assert!(message.contains("line 1"), "{message}");
    client.finish().await;
}

#[tokio::test]
async fn options_take_effect() {
    let mut client = Client::new().await;
    client.open(COUNT).await;
    let options = json!({"intervalMs": 2.5, "inputs": {"go": true}});
    let answer = client
        .simulate("start", json!({"uri": URI, "options": options}))
        .await
        .unwrap();
    let s = answer["session"].as_str().unwrap().to_owned();
    let state = step(&mut client, &s, 3).await;
    assert_eq!(
        (&state["timeMs"], &tag(&state, "n")["value"]),
        (&json!(7.5), &json!(3))
    );
    let other = client.simulate("start", json!({"uri": URI})).await.unwrap();
    assert_ne!(
        other["session"], answer["session"],
        "sessions do not know each other"
    );
    assert_eq!(tag(&other["state"], "n")["value"], 0);
    client.finish().await;
}

#[tokio::test]
async fn a_run_goes_on_by_itself_and_can_be_paused() {
    let (mut client, s, _) = started(COUNT).await;
    set(&mut client, &s, "go", json!(true)).await.unwrap();
    let state = client
        .simulate("run", json!({"session": s, "realTime": false}))
        .await
        .unwrap();
    assert_eq!(state["status"], "running");
    // The program runs, the server answers, values can be set meanwhile.
    client
        .notification("ladder/simulationState", |it| it["scan"].as_u64().unwrap() > 1000)
        .await;
    set(&mut client, &s, "go", json!(false)).await.unwrap();
    let state = client.simulate("pause", json!({"session": s})).await.unwrap();
    assert_eq!(state["status"], "paused");
    let scan = state["scan"].clone();
    assert!(tag(&state, "n")["value"].as_i64().unwrap() > 1000);
    tokio::time::sleep(Duration::from_millis(30)).await;
    assert_eq!(
        client.simulate("state", json!({"session": s})).await.unwrap()["scan"],
        scan
    );
    client.finish().await;
}

#[tokio::test]
async fn a_run_of_some_scans_ends_by_itself() {
    let (mut client, s, _) = started(MOTOR).await;
    client
        .simulate("run", json!({"session": s, "scans": 25, "realTime": false}))
        .await
        .unwrap();
    let state = client
        .notification("ladder/simulationState", |it| it["scan"] == 25)
        .await;
    assert_eq!(state["status"], "paused");
    assert_eq!(
        client.simulate("state", json!({"session": s})).await.unwrap()["scan"],
        25
    );
    client.finish().await;
}

#[tokio::test]
async fn real_time_takes_its_time() {
    let (mut client, s, _) = started(MOTOR).await;
    let begin = Instant::now();
    client
        .simulate("run", json!({"session": s, "scans": 21}))
        .await
        .unwrap();
    client
        .notification("ladder/simulationState", |it| it["scan"] == 21)
        .await;
    assert!(
        begin.elapsed() >= Duration::from_millis(200),
        "the first scan is at once, twenty intervals follow"
    );
    client.finish().await;
}

#[tokio::test]
async fn no_more_than_twenty_states_a_second_and_the_last_one_always() {
    let (mut client, s, _) = started(COUNT).await;
    let begin = Instant::now();
    for n in 1..=200 {
        set(&mut client, &s, "n", json!(n)).await.unwrap();
    }
    client
        .notification("ladder/simulationState", |it| tag(it, "n")["value"] == 200)
        .await;
    let ticks = begin.elapsed().as_millis() / 50 + 2;
    let arrived = client.arrived("ladder/simulationState").len() as u128 + 1;
    assert!(arrived <= ticks, "{arrived} states in {ticks} ticks");
    client.finish().await;
}

#[tokio::test]
async fn reset_begins_again() {
    let (mut client, s, first) = started(COUNT).await;
    set(&mut client, &s, "go", json!(true)).await.unwrap();
    step(&mut client, &s, 9).await;
    let state = client.simulate("reset", json!({"session": s})).await.unwrap();
    assert_eq!(
        (&state["scan"], &state["timeMs"], &state["status"]),
        (&json!(0), &json!(0), &json!("paused"))
    );
    assert_eq!(tag(&state, "n"), tag(&first, "n"));
    client.finish().await;
}

#[tokio::test]
async fn stop_ends_a_session_and_says_so() {
    let (mut client, s, _) = started(MOTOR).await;
    client
        .simulate("run", json!({"session": s, "realTime": false}))
        .await
        .unwrap();
    let answer = client.simulate("stop", json!({"session": s})).await.unwrap();
    assert_eq!(answer, json!({"session": s, "stopped": true}));
    client
        .notification("ladder/simulationState", |it| it["status"] == "ended")
        .await;
    assert_eq!(
        client
            .simulate("state", json!({"session": s}))
            .await
            .unwrap_err()
            .0,
        -32803
    );
    client.finish().await;
}

#[tokio::test]
async fn closing_the_document_ends_its_sessions() {
    let (mut client, s, _) = started(MOTOR).await;
    client
        .simulate("run", json!({"session": s, "realTime": false}))
        .await
        .unwrap();
    client.close().await;
    client
        .notification("ladder/simulationState", |it| it["status"] == "ended")
        .await;
    assert_eq!(
        client
            .simulate("state", json!({"session": s}))
            .await
            .unwrap_err()
            .0,
        -32803
    );
    client.finish().await;
}

#[tokio::test]
async fn a_long_step_gives_way_to_stop() {
    let (mut client, s, _) = started(MOTOR).await;
    let params = json!({
        "command": "ladder.simulate.step",
        "arguments": [{"session": s, "scans": 1_000_000_000_000_u64}]
    });
    let long = client.ask("workspace/executeCommand", params).await;
    let state = client
        .notification("ladder/simulationState", |it| it["status"] == "running")
        .await;
    assert!(state["scan"].as_u64().unwrap() > 0);
    client.simulate("stop", json!({"session": s})).await.unwrap();
    assert!(client.answer(long).await.is_ok());
    client.finish().await;
}

#[tokio::test]
async fn a_scan_without_end_gives_way_to_pause_and_stop() {
    let endless = "+--<LBL>( again )--[ ]( go )--<JMP>( again )--+\n";
    let mut client = Client::new().await;
    client.open(endless).await;
    let options = json!({"watchdog": u64::MAX >> 1, "inputs": {"go": true}});
    let params = json!({"uri": URI, "options": options});
    let session = client.simulate("start", params).await.unwrap();
    let s = session["session"].as_str().unwrap().to_owned();
    for _ in 0..3 {
        let params = json!({"command": "ladder.simulate.step", "arguments": [{"session": s, "scans": 5}]});
        let step = client.ask("workspace/executeCommand", params).await;
        let state = client.simulate("pause", json!({"session": s})).await.unwrap();
        assert_eq!((&state["status"], &state["scan"]), (&json!("paused"), &json!(0)));
        let state = client.answer(step).await.unwrap();
        assert_eq!(state["status"], "paused");
        client.simulate("run", json!({"session": s})).await.unwrap();
        let state = client.simulate("pause", json!({"session": s})).await.unwrap();
        assert_eq!((&state["status"], &state["scan"]), (&json!("paused"), &json!(0)));
        assert_eq!(state["faults"], json!([]));
    }
    client.simulate("run", json!({"session": s})).await.unwrap();
    client.simulate("stop", json!({"session": s})).await.unwrap();
    client.finish().await;
}

#[tokio::test]
async fn an_end_and_a_fault_stop_the_program_for_good() {
    let (mut client, s, _) = started("+--[ ]( a )--<END>--+\n").await;
    set(&mut client, &s, "a", json!(true)).await.unwrap();
    let state = step(&mut client, &s, 5).await;
    assert_eq!((&state["status"], &state["scan"]), (&json!("ended"), &json!(1)));
    let state = client.simulate("run", json!({"session": s})).await.unwrap();
    assert_eq!((&state["status"], &state["scan"]), (&json!("ended"), &json!(1)));
    client.finish().await;

    let (mut client, s, _) = started("+--<LBL>( again )--+\n\n+--<JMP>( again )--+\n").await;
    let state = step(&mut client, &s, 5).await;
    assert_eq!(state["status"], "faulted");
    let fault = &state["faults"][0];
    assert_eq!(fault["scan"], 0);
    assert!(!fault["message"].as_str().unwrap().is_empty());
    assert_eq!(fault["range"], span([0, 3, 0, 17]), "where the watchdog struck");
    client.finish().await;
}

#[tokio::test]
async fn a_pulse_is_one_scan_long() {
    let program = "\
VAR_INPUT  button : BOOL;  END_VAR
VAR  on : DINT;  edges : DINT;  END_VAR
+--[ ]( button )-----------[ADD]( on, on, 1 )-----+
+--[ ]( button )--[OSR]----[ADD]( edges, edges, 1 )--+
";
    let (mut client, s, _) = started(program).await;
    let pulse = json!({"session": s, "tag": "button"});
    let state = client.simulate("pulse", pulse.clone()).await.unwrap();
    assert_eq!(tag(&state, "button")["value"], true);
    // One pulse at a time.
    client.simulate("pulse", pulse.clone()).await.unwrap();
    let state = step(&mut client, &s, 1).await;
    assert_eq!(
        (&tag(&state, "on")["value"], &tag(&state, "button")["value"]),
        (&json!(1), &json!(false))
    );
    let state = step(&mut client, &s, 3).await;
    assert_eq!(tag(&state, "on")["value"], 1);

    // Within a scan it waits for the next one.
    client.simulate("stepBlock", json!({"session": s})).await.unwrap();
    client.simulate("pulse", pulse.clone()).await.unwrap();
    let state = step(&mut client, &s, 3).await;
    assert_eq!(
        (&tag(&state, "on")["value"], &tag(&state, "edges")["value"]),
        (&json!(2), &json!(2))
    );

    // A tag that is on is off for one scan.
    set(&mut client, &s, "button", json!(true)).await.unwrap();
    client.simulate("pulse", pulse.clone()).await.unwrap();
    let state = step(&mut client, &s, 3).await;
    assert_eq!(
        (&tag(&state, "on")["value"], &tag(&state, "button")["value"]),
        (&json!(4), &json!(true))
    );

    let force = json!({"session": s, "tag": "button", "value": true});
    client.simulate("force", force).await.unwrap();
    let refused = client.simulate("pulse", pulse).await.unwrap_err();
    assert_eq!(refused, (-32803, "button is forced; release it first".to_owned()));
    let wrong = json!({"session": s, "tag": "on"});
    let refused = client.simulate("pulse", wrong).await.unwrap_err();
    assert_eq!(
        refused,
        (-32602, "on is a DINT; only a tag of BOOL has pulses".to_owned())
    );
    client.finish().await;
}

#[tokio::test]
async fn a_value_in_a_hover_is_no_markdown() {
    let program = "VAR  note : STRING := '![x](http://y/z.png) `b`';  END_VAR\n+--[LEN]( n, note )--+\n";
    let (mut client, _, _) = started(program).await;
    let shown = client.hover(1, 14).await.unwrap();
    let text = shown["contents"]["value"].as_str().unwrap();
    assert!(
        text.starts_with("`note` is **`` '![x](http://y/z.png) `b`' ``**"),
        "{text}"
    );
    client.finish().await;
}

//! A debugger and the live view work on one session, whichever of them began.

use serde_json::{Value, json};

use crate::client::Client;
use crate::plant::Plant;

const MOTOR: &str = "\
VAR
  start, stop : BOOL;
END_VAR
+--\\--[ ]( start )--\\--[/]( stop )--( )( run )--+
|  /--[ ]( run )----/                            |
+--[ ]( run )--[TON]( t, T#50ms )--( )( warm )--+
";

/// A client whose program is debugged.
struct Debugged {
    client: Client,
    plant: Plant,
    session: String,
    seq: i64,
}

impl Debugged {
    /// Begins, as an editor does that shows all of the program.
    async fn launched(launch: Value) -> Debugged {
        let plant = Plant::with(&[("motor.clad", MOTOR), ("motor.ladder-test", SCENARIOS)]);
        let mut client = Client::new().await;
        client.open_as(&plant.uri("motor.clad"), 1, MOTOR).await;
        let (session, _) = begin(&mut client, &plant, launch.clone()).await;
        let mut debugged = Debugged {
            client,
            plant,
            session,
            seq: 0,
        };
        debugged.introduce(launch).await;
        debugged
    }

    async fn introduce(&mut self, launch: Value) {
        self.body("initialize", json!({"supportsInvalidatedEvent": true}))
            .await;
        self.body("launch", launch).await;
        self.event("initialized").await;
    }

    /// A request of the debugger, and the body of its answer.
    async fn body(&mut self, command: &str, arguments: Value) -> Value {
        let answer = self.answer(command, arguments).await;
        assert_eq!(answer["success"], true, "{answer}");
        answer["body"].clone()
    }

    async fn answer(&mut self, command: &str, arguments: Value) -> Value {
        self.seq += 1;
        let seq = self.seq;
        let message = json!({"seq": seq, "type": "request", "command": command, "arguments": arguments});
        let params = json!({"session": self.session, "message": message});
        self.client.notify("ladder/toDebugger", params).await;
        let told = self
            .client
            .notification("ladder/fromDebugger", |it| it["message"]["request_seq"] == seq)
            .await;
        told["message"].clone()
    }

    async fn event(&mut self, event: &str) -> Value {
        let session = self.session.clone();
        let told = self
            .client
            .notification("ladder/fromDebugger", |it| {
                it["session"] == *session && it["message"]["event"] == event
            })
            .await;
        told["message"]["body"].clone()
    }

    async fn break_at(&mut self, line: i64) {
        let source = json!({"path": path(&self.plant, "motor.clad")});
        let set = json!({"source": source, "breakpoints": [{"line": line}]});
        let body = self.body("setBreakpoints", set).await;
        assert_eq!(body["breakpoints"][0]["verified"], true, "{body}");
    }

    /// A command of the editor.
    async fn act(&mut self, command: &str, mut argument: Value) -> Value {
        argument["session"] = self.session.clone().into();
        self.client.simulate(command, argument).await.unwrap()
    }

    /// What the live view is told.
    async fn state(&mut self, wanted: impl Fn(&Value) -> bool) -> Value {
        self.client.notification("ladder/simulationState", wanted).await
    }
}

const SCENARIOS: &str = "\
program motor.clad
scenario \"rests\"
run  => __
scenario \"starts\"
start   _-_
run  => _--
";

fn path(plant: &Plant, name: &str) -> String {
    plant.folder.path().join(name).to_str().unwrap().to_owned()
}

async fn begin(client: &mut Client, plant: &Plant, mut launch: Value) -> (String, Value) {
    for name in ["program", "scenarioFile"] {
        if let Some(file) = launch[name].as_str() {
            launch[name] = path(plant, file).into();
        }
    }
    let answer = client.simulate("debug", json!({"launch": launch})).await.unwrap();
    (answer["session"].as_str().unwrap().to_owned(), answer)
}

fn value<'s>(state: &'s Value, name: &str) -> &'s Value {
    let tags = state["tags"].as_array().unwrap();
    &tags.iter().find(|tag| tag["name"] == name).unwrap()["value"]
}

/// Whether the element at a place carries power.
fn is_live(state: &Value, line: u64, text: &str) -> bool {
    let column = MOTOR.lines().nth(line as usize).unwrap().find(text).unwrap();
    let mut power = state["power"].as_array().unwrap().iter();
    power
        .find(|it| it["range"]["start"] == json!({"line": line, "character": column}))
        .unwrap()["on"]
        == true
}

#[tokio::test]
async fn stopped_at_a_breakpoint_the_live_view_shows_power_and_values() {
    let launch = json!({"program": "motor.clad", "speed": "max", "inputs": {"start": true}});
    let mut it = Debugged::launched(launch).await;
    it.break_at(6).await;
    it.body("configurationDone", Value::Null).await;
    let stopped = it.event("stopped").await;
    assert_eq!(stopped["reason"], "breakpoint");
    let state = it
        .state(|it| it["status"] == "paused" && it["next"]["start"]["line"] == 5)
        .await;
    assert_eq!(value(&state, "run"), true);
    assert!(is_live(&state, 3, "( )( run )"), "{state}");
    assert!(!is_live(&state, 5, "( )( warm )"));

    let why = it.act("why", json!({"tag": "run"})).await;
    assert!(why.to_string().contains("start"), "{why}");

    // A force of the editor holds in the debugger, and the other way round.
    it.act("force", json!({"tag": "stop", "value": true})).await;
    it.event("invalidated").await;
    let told = it
        .body("evaluate", json!({"expression": "stop", "context": "watch"}))
        .await;
    assert_eq!(told["result"], "FALSE → TRUE after this scan");
    it.body("continue", json!({"threadId": 1})).await;
    it.event("stopped").await;
    it.state(|it| it["scan"] == 1 && value(it, "run") == false && it["forced"] == 1)
        .await;
    it.body("ladder/unforce", json!({})).await;

    // Steps of both lead to the same place.
    it.act("stepBlock", json!({})).await;
    it.event("stopped").await;
    let frames = it.body("stackTrace", json!({"threadId": 1})).await;
    assert_eq!(frames["stackFrames"][0]["line"], 6);
    it.body("next", json!({"threadId": 1})).await;
    it.state(|it| it["scan"] == 2 && it["forced"] == 0).await;
    it.act("back", json!({})).await;
    assert_eq!(it.event("stopped").await["reason"], "step");
    assert_eq!(it.event("stopped").await["reason"], "goto");

    // Running goes either way, too.
    it.body(
        "setBreakpoints",
        json!({"source": {"path": path(&it.plant, "motor.clad")}, "breakpoints": []}),
    )
    .await;
    it.act("run", json!({})).await;
    it.event("continued").await;
    it.act("pause", json!({})).await;
    assert_eq!(it.event("stopped").await["reason"], "pause");
    it.act("step", json!({"scans": 3})).await;
    assert_eq!(it.event("stopped").await["reason"], "step");

    it.act("stop", json!({})).await;
    it.event("terminated").await;
    it.body("disconnect", json!({})).await;
}

#[tokio::test]
async fn a_running_simulation_is_given_a_breakpoint() {
    let plant = Plant::with(&[("motor.clad", MOTOR)]);
    let mut client = Client::new().await;
    let uri = plant.uri("motor.clad");
    client.open_as(&uri, 1, MOTOR).await;
    let started = client.simulate("start", json!({"uri": uri})).await.unwrap();
    let session = started["session"].as_str().unwrap().to_owned();
    client
        .simulate("run", json!({"session": session, "realTime": false}))
        .await
        .unwrap();
    let (joined, answer) = begin(&mut client, &plant, json!({"program": "motor.clad"})).await;
    assert_eq!(
        (joined.as_str(), &answer["joined"]),
        (session.as_str(), &json!(true))
    );
    let mut it = Debugged {
        client,
        plant,
        session,
        seq: 0,
    };
    it.introduce(json!({"program": "motor.clad", "stopOnEntry": true}))
        .await;
    it.body("configurationDone", Value::Null).await;
    assert_eq!(it.act("state", json!({})).await["status"], "running");
    it.break_at(4).await;
    it.event("stopped").await;
    let state = it.state(|it| it["status"] == "paused").await;
    assert!(state["scan"].as_u64().unwrap() > 0);

    // A line above moves it; who sets breakpoints in another way is told whose they are.
    let text = format!("# more #\n{MOTOR}");
    let uri = it.plant.uri("motor.clad");
    let change = json!({"textDocument": {"uri": uri, "version": 2}, "contentChanges": [{"text": text}]});
    it.client.notify("textDocument/didChange", change).await;
    it.body("continue", json!({"threadId": 1})).await;
    it.event("stopped").await;
    let frames = it.body("stackTrace", json!({"threadId": 1})).await;
    assert_eq!(frames["stackFrames"][0]["line"], 5);
    let lines = json!({"session": it.session, "lines": [4]});
    let refused = it.client.simulate("breakpoints", lines).await.unwrap_err();
    assert!(refused.1.contains("debugger"), "{refused:?}");

    // Without its debugger it goes on.
    it.body("disconnect", json!({})).await;
    it.act("run", json!({"scans": 2})).await;
    let state = it.state(|it| it["status"] == "paused").await;
    assert_eq!(state["breakpoints"], Value::Null);
}

#[tokio::test]
async fn a_scenario_is_debugged_in_the_live_view() {
    // Which scenario is at a line the server knows.
    let launch = json!({"scenarioFile": "motor.ladder-test", "scenarioLine": 6});
    let mut it = Debugged::launched(launch).await;
    it.break_at(6).await;
    it.body("configurationDone", Value::Null).await;
    it.event("stopped").await;
    let frames = it.body("stackTrace", json!({"threadId": 1})).await;
    assert_eq!(frames["stackFrames"][1]["name"], "scenario \"starts\", step 0");
    it.body("continue", json!({"threadId": 1})).await;
    it.event("stopped").await;
    let state = it
        .state(|it| it["scan"] == 1 && it["next"]["start"]["line"] == 5)
        .await;
    assert!(is_live(&state, 3, "( )( run )"));
    it.body("continue", json!({"threadId": 1})).await;
    it.event("stopped").await;
    it.body("continue", json!({"threadId": 1})).await;
    assert_eq!(it.event("exited").await["exitCode"], 0);
    it.event("terminated").await;
    // A restart runs another one of the same program.
    let launch = json!({"scenarioFile": path(&it.plant, "motor.ladder-test"), "scenario": "rests"});
    it.body("restart", json!({"arguments": launch})).await;
    it.event("stopped").await;
    let frames = it.body("stackTrace", json!({"threadId": 1})).await;
    assert_eq!(frames["stackFrames"][1]["name"], "scenario \"rests\", step 0");
}

#[tokio::test]
async fn a_run_that_is_in_no_file_is_debugged_with_its_text() {
    let text =
        "program motor.clad\ninterval 10ms\n\nscenario \"it starts is violated\"\nstart  _-\nrun => _-\n";
    let launch = json!({"scenarioFile": "motor.ladder-test", "scenarioText": text, "stopOnEntry": true});
    let mut debugged = Debugged::launched(launch).await;
    debugged.body("configurationDone", json!({})).await;
    debugged.event("stopped").await;
    let stack = debugged.body("stackTrace", json!({"threadId": 1})).await;
    let frames = stack["stackFrames"].as_array().unwrap();
    let frame = frames.last().unwrap();
    assert_eq!(frame["name"], "scenario \"it starts is violated\", step 0");
    assert_eq!(
        frame["source"],
        json!({"name": "run for motor.ladder-test", "sourceReference": 1})
    );
    let source = debugged.body("source", json!({"sourceReference": 1})).await;
    assert_eq!(source["content"], text);
    let answer = debugged.answer("source", json!({"sourceReference": 0})).await;
    assert_eq!(answer["success"], false);
    debugged.body("continue", json!({"threadId": 1})).await;
    assert_eq!(debugged.event("exited").await["exitCode"], 0);
    debugged.client.finish().await;
}

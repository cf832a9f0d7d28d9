//! Sessions with the adapter, message by message.

mod compound;
mod expectations;
mod hostile;
mod properties;
mod refused;
mod structured_text;
mod watches;

use std::sync::atomic::AtomicUsize;
use std::sync::{Arc, Mutex};
use std::time::Duration;

use ladder_host::testing::on_disk;
use ladder_host::{Clock, World};
use serde_json::{Value as Json, json};
use tempfile::TempDir;

use super::adapter::Adapter;
use super::messages::Request;

/// What the adapter writes.
#[derive(Debug, Clone, Default)]
struct Written(Arc<Mutex<Vec<Json>>>);

impl Written {
    /// The messages since this was asked last.
    fn take(&self) -> Vec<Json> {
        std::mem::take(&mut *self.0.lock().unwrap())
    }
}

/// A client with a program of its own.
struct Client {
    adapter: Adapter,
    written: Written,
    folder: TempDir,
    seq: i64,
}

impl Client {
    fn new(text: &str) -> Client {
        Client::in_world(text, on_disk())
    }

    fn in_world(text: &str, world: World) -> Client {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("ladder.toml"), "").unwrap();
        std::fs::write(folder.path().join("own.clad"), text).unwrap();
        let written = Written::default();
        let out = written.clone();
        Client {
            adapter: Adapter::new(
                world,
                Box::new(move |message| {
                    out.0.lock().unwrap().push(message.clone());
                    Ok(())
                }),
                Arc::<AtomicUsize>::default(),
            ),
            written,
            folder,
            seq: 0,
        }
    }

    fn program(&self) -> String {
        self.folder.path().join("own.clad").to_str().unwrap().to_owned()
    }

    /// Sends a request and runs the program until it is. What was reported: the answer first.
    fn ask(&mut self, command: &str, arguments: Json) -> Vec<Json> {
        self.seq += 1;
        let request = Request {
            seq: self.seq,
            command: command.to_owned(),
            arguments,
        };
        self.adapter.handle(&request);
        for _ in 0..100 {
            if !self.adapter.is_running() {
                break;
            }
            self.adapter.run_on();
        }
        let told = self.written.take();
        let answers = told.iter().filter(|message| message["type"] == "response");
        let answers: Vec<&Json> = answers.collect();
        assert_eq!(answers.len(), 1, "{command} {told:?}");
        assert_eq!(answers[0]["request_seq"], self.seq);
        assert_eq!(answers[0]["command"], command);
        assert_eq!(told[0]["type"], "response");
        told
    }

    /// The body of a good answer.
    #[track_caller]
    fn body(&mut self, command: &str, arguments: Json) -> Json {
        let answer = self.ask(command, arguments).swap_remove(0);
        assert_eq!(answer["success"], true, "{answer}");
        answer["body"].clone()
    }

    /// What an expression is.
    fn evaluate(&mut self, expression: &str, context: &str) -> String {
        let arguments = json!({"expression": expression, "context": context, "frameId": 1});
        let answer = self.ask("evaluate", arguments).swap_remove(0);
        match answer["success"].as_bool() {
            Some(true) => answer["body"]["result"].as_str().unwrap().to_owned(),
            _ => format!("error: {}", answer["message"].as_str().unwrap()),
        }
    }

    /// Launches the program: it is before its first scan.
    fn launched(text: &str) -> Client {
        Client::new(text).launch()
    }

    fn launch(mut self) -> Client {
        self.body("initialize", json!({}));
        let program = self.program();
        self.body(
            "launch",
            json!({"program": program, "stopOnEntry": true, "speed": "max"}),
        );
        self.body("configurationDone", Json::Null);
        self
    }
}

const LOOP: &str = "VAR n : LINT; END_VAR\n+--<LBL>( again )--[ADD]( n, n, 1 )--<JMP>( again )--+\n";

/// The watchdog is a fault that the program does not survive.
#[test]
fn the_watchdog_stops_the_program_for_good() {
    let mut client = Client::launched(LOOP);
    let told = client.ask("continue", json!({"threadId": 1}));
    let stopped = told.iter().find(|message| message["event"] == "stopped").unwrap();
    assert_eq!(stopped["body"]["reason"], "exception");
    let text = stopped["body"]["text"].as_str().unwrap();
    assert!(text.contains("watchdog"), "{text}");
    let frames = client.body("stackTrace", json!({"threadId": 1}));
    assert_eq!(frames["stackFrames"][0]["line"], 2);
    let told = client.ask("continue", json!({"threadId": 1}));
    let exited = told.iter().find(|message| message["event"] == "exited").unwrap();
    assert_eq!(exited["body"]["exitCode"], 1);
}

#[test]
fn a_program_that_ends_itself_is_shown_once_more() {
    let mut client = Client::launched("VAR n : INT; END_VAR\n+--[ADD]( n, n, 1 )--[GE]( n, 3 )--<END>--+\n");
    let told = client.ask("continue", json!({"threadId": 1}));
    let stopped = told.iter().find(|message| message["event"] == "stopped").unwrap();
    assert_eq!(stopped["body"]["reason"], "end");
    assert_eq!(client.evaluate("n", "watch"), "3");
    let told = client.ask("continue", json!({"threadId": 1}));
    assert!(told.iter().any(|message| message["event"] == "terminated"));
    assert_eq!(told[1]["body"]["exitCode"], 0);
}

/// An editor that asks a moment too late shows no error.
#[test]
fn variables_of_a_moment_that_is_over_are_none() {
    let mut client = Client::launched("VAR n : INT; END_VAR\n+--[ADD]( n, n, 1 )--+\n");
    client.body("stackTrace", json!({"threadId": 1}));
    let scopes = client.body("scopes", json!({"frameId": 1}));
    let reference = scopes["scopes"][0]["variablesReference"].clone();
    let asked = json!({"variablesReference": reference});
    assert_ne!(client.body("variables", asked.clone())["variables"], json!([]));
    client.ask("next", json!({"threadId": 1}));
    assert_eq!(client.body("variables", asked)["variables"], json!([]));
}

/// Nobody takes a scenario for passed that was only checked.
#[test]
fn a_scenario_that_is_ended_by_hand_has_not_passed() {
    let scenarios = "program own.clad\nscenario \"two steps\"\na => 0 0\nscenario \"wrong\"\na => 1 0\n";
    for (name, status) in [("two steps", None), ("wrong", Some(1))] {
        let mut client = Client::new("VAR a : INT; END_VAR\n+--[MOV]( a, 0 )--+\n");
        let file = client.folder.path().join("own.ladder-test");
        std::fs::write(&file, scenarios).unwrap();
        client.body("initialize", json!({}));
        let launch = json!({"scenarioFile": file, "scenario": name, "stopOnEntry": status.is_none()});
        client.body("launch", launch);
        let body = json!({"filters": ["expectations"]});
        client.body("setExceptionBreakpoints", body);
        client.body("configurationDone", Json::Null);
        let told = client.ask("terminate", json!({}));
        let exited = told.iter().find(|message| message["event"] == "exited");
        let exit_code = exited.map(|message| message["body"]["exitCode"].as_i64().unwrap());
        assert_eq!(exit_code, status, "{name}");
        assert!(told.iter().any(|message| message["event"] == "terminated"));
    }
}

/// Back and forth gives the same places.
#[test]
fn every_place_of_a_scan_is_found_again_on_the_way_back() {
    let text =
        "VAR n, m : INT; END_VAR\n+--[ADD]( n, n, 1 )--[ADD]( m, m, n )--+\n+--[GE]( n, 2 )--( )( y )--+\n";
    let mut client = Client::launched(text);
    let place = |client: &mut Client| {
        let frames = client.body("stackTrace", json!({"threadId": 1}));
        let frame = &frames["stackFrames"][0];
        let values = (client.evaluate("n", "watch"), client.evaluate("m", "watch"));
        (
            frame["name"].clone(),
            frame["line"].clone(),
            frame["column"].clone(),
            values,
        )
    };
    let mut there = vec![place(&mut client)];
    for _ in 0..9 {
        client.body("stepIn", json!({"threadId": 1}));
        there.push(place(&mut client));
    }
    let mut back = vec![place(&mut client)];
    for _ in 0..9 {
        client.body("stepBack", json!({"threadId": 1, "granularity": "instruction"}));
        back.push(place(&mut client));
    }
    back.reverse();
    assert_eq!(there, back);
}

#[test]
fn files_of_the_workspace_belong_to_the_program() {
    let mut client = Client::new("VAR n : INT; END_VAR\n+--[$Twice]( n )--+\n");
    let library = client.folder.path().join("library.clad");
    let body =
        "FUNCTION_BLOCK [$Twice]\nVAR_IN_OUT v : INT; END_VAR\n+--[ADD]( v, v, 2 )--+\nEND_FUNCTION_BLOCK\n";
    std::fs::write(&library, body).unwrap();
    client.body("initialize", json!({}));
    let program = client.program();
    client.body("launch", json!({"program": program, "speed": "max"}));
    let source = json!({"path": library.to_str()});
    let set = client.body(
        "setBreakpoints",
        json!({"source": source, "breakpoints": [{"line": 3}]}),
    );
    assert_eq!(set["breakpoints"][0]["verified"], true);
    client.body("configurationDone", Json::Null);
    let frames = client.body("stackTrace", json!({"threadId": 1}));
    assert_eq!(
        frames["stackFrames"][0]["source"]["path"],
        library.to_str().unwrap()
    );
    assert_eq!(frames["stackFrames"][1]["source"]["name"], "own.clad");
    assert_eq!(client.evaluate("v + 1", "watch"), "1");
    let elsewhere = json!({"path": "/nowhere.clad"});
    let set = client.body(
        "setBreakpoints",
        json!({"source": elsewhere, "breakpoints": [{"line": 3}]}),
    );
    assert_eq!(set["breakpoints"][0]["verified"], false);
}

/// Each name of a tag at a direct address is shown and can be given.
#[test]
fn names_of_one_address_are_variables() {
    let mut client = Client::launched(
        "VAR a, b AT %MW3 : INT; END_VAR\n+--[ADD]( a, b, 1 )--[$More]( )--+\n\
         FUNCTION_BLOCK [$More]\nVAR own AT %MW3 : INT; END_VAR\n+--[ADD]( own, own, 1 )--+\nEND_FUNCTION_BLOCK\n",
    );
    let names = |client: &mut Client, scope: &str| {
        let scopes = client.body("scopes", json!({"frameId": 1}));
        let scopes = scopes["scopes"].as_array().unwrap();
        let scope = scopes.iter().find(|it| it["name"] == scope).unwrap();
        let reference = json!({"variablesReference": scope["variablesReference"]});
        let variables = client.body("variables", reference);
        let shown = variables["variables"].as_array().unwrap().iter();
        let shown = shown.map(|it| format!("{}={}", it["name"], it["value"]).replace('"', ""));
        shown.collect::<Vec<_>>().join(" ")
    };
    assert_eq!(names(&mut client, "Internal"), "a=0 b=0");
    client.evaluate("b := 5", "repl");
    client.evaluate("force b := 7", "repl");
    assert_eq!(names(&mut client, "Internal"), "a=7 (forced) b=7 (forced)");
    assert_eq!(client.evaluate("a + 1", "watch"), "8");
    client.evaluate("unforce a", "repl");
    client.body("stepIn", json!({"threadId": 1}));
    client.body("stepIn", json!({"threadId": 1}));
    assert_eq!(names(&mut client, "$More#1"), "EN=TRUE ENO=TRUE own=8");
    assert_eq!(client.evaluate("own", "watch"), "8");
}

/// An editor asks about a tag before it opens a menu: by then the program may have gone on.
#[test]
fn a_question_about_a_tag_of_a_stop_that_is_over_is_no_error() {
    let mut client = Client::launched("VAR n : INT; END_VAR\n+--[ADD]( n, n, 1 )--+\n");
    let scopes = client.body("scopes", json!({"frameId": 1}));
    let scopes = scopes["scopes"].as_array().unwrap();
    let internal = scopes.iter().find(|scope| scope["name"] == "Internal").unwrap();
    let tag = json!({"variablesReference": internal["variablesReference"], "name": "n"});
    assert_eq!(client.body("dataBreakpointInfo", tag.clone())["dataId"], "n");
    client.body("next", json!({"threadId": 1}));
    assert_eq!(client.body("dataBreakpointInfo", tag)["dataId"], Json::Null);
}

/// The protocol wraps the new configuration; nvim-dap does not.
#[test]
fn a_restart_takes_a_new_configuration_wrapped_or_not() {
    let mut client = Client::launched("VAR n : INT; END_VAR\n+--[ADD]( n, n, 1 )--+\n");
    let program = client.program();
    let holding = |n: i64| json!({"program": program, "stopOnEntry": true, "inputs": {"n": n}});
    for (arguments, wanted) in [
        (json!({"arguments": holding(3)}), "3"),
        (json!({}), "3"),
        (holding(4), "4"),
        (json!({"arguments": null}), "4"),
    ] {
        client.body("restart", arguments);
        assert_eq!(client.evaluate("n", "watch"), wanted);
    }
}

/// An editor that is sent a line with each scan of a program without a clock can neither show nor stop it any more.
#[test]
fn log_points_write_no_more_than_can_be_shown() {
    let now = Duration::from_secs(5);
    let world = World {
        clock: Clock::new(move || now),
        ..on_disk()
    };
    let mut client = Client::in_world("VAR n : LINT; END_VAR\n+--[ADD]( n, n, 1 )--+\n", world).launch();
    let source = json!({"path": client.program()});
    let arguments = json!({"source": source, "breakpoints": [{"line": 2, "logMessage": "n is {n}"}]});
    client.body("setBreakpoints", arguments);
    let mut written = client.ask("continue", json!({"threadId": 1}));
    while client.adapter.due().is_none() {
        client.adapter.run_on();
        written.extend(client.written.take());
    }
    let lines = written.iter().filter(|message| message["event"] == "output");
    assert_eq!(lines.count(), 100);
    assert_eq!(client.adapter.due(), Some(now + Duration::from_millis(100)));
}

//! `ladder mcp`: an assistant at the other end, who has nothing but the tools.

use crate::harness::Folder;
use serde_json::{Value, json};
use std::io::{BufRead, BufReader, Write};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

/// A client that has greeted.
struct Client {
    child: Child,
    stdin: Option<ChildStdin>,
    stdout: BufReader<ChildStdout>,
    last: u64,
}

impl Client {
    fn of(folder: &Folder) -> Client {
        let mut child = Command::new(env!("CARGO_BIN_EXE_ladder"))
            .arg("mcp")
            .current_dir(folder.path(""))
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        let stdin = child.stdin.take();
        let stdout = BufReader::new(child.stdout.take().unwrap());
        let mut client = Client {
            child,
            stdin,
            stdout,
            last: 0,
        };
        let greeting = json!({
            "protocolVersion": "2025-06-18",
            "capabilities": {},
            "clientInfo": {"name": "test", "version": "1"},
        });
        let info = client.ask("initialize", greeting);
        assert_eq!(info["serverInfo"]["name"], "ladder");
        client.send(&json!({"jsonrpc": "2.0", "method": "notifications/initialized"}));
        client
    }

    fn send(&mut self, message: &Value) {
        let stdin = self.stdin.as_mut().unwrap();
        writeln!(stdin, "{message}").unwrap();
        stdin.flush().unwrap();
    }

    fn ask(&mut self, method: &str, params: Value) -> Value {
        self.last += 1;
        let asked = json!({"jsonrpc": "2.0", "id": self.last, "method": method, "params": params});
        self.send(&asked);
        loop {
            let mut line = String::new();
            assert!(
                self.stdout.read_line(&mut line).unwrap() > 0,
                "the server has gone"
            );
            let message: Value = serde_json::from_str(&line).unwrap();
            if message["id"] == self.last {
                return match message.get("error") {
                    Some(error) => error.clone(),
                    None => message["result"].clone(),
                };
            }
        }
    }

    /// What a tool answers, as it is typed.
    #[track_caller]
    fn call(&mut self, tool: &str, arguments: Value) -> Value {
        let result = self.ask("tools/call", json!({"name": tool, "arguments": arguments}));
        assert!(result["isError"] != true, "{tool} {arguments}: {result}");
        result["structuredContent"].clone()
    }

    /// Why a tool refuses.
    #[track_caller]
    fn refused(&mut self, tool: &str, arguments: Value) -> String {
        let result = self.ask("tools/call", json!({"name": tool, "arguments": arguments}));
        assert_eq!(result["isError"], true, "{tool} {arguments}: {result}");
        result["content"][0]["text"].as_str().unwrap().to_owned()
    }
}

impl Drop for Client {
    fn drop(&mut self) {
        self.stdin = None;
        let _ = self.child.wait();
    }
}

const MOTOR: &str = "\
VAR_INPUT start, stop : BOOL; END_VAR
VAR_OUTPUT run, lamp : BOOL; END_VAR
VAR warm : TON; END_VAR
+--\\--[ ]( start )--\\--[/]( stop )---------------------------------( )( run )--+
|  /--[ ]( run )----/                                                          |
+--[ ]( run )-------------------------------[TON]( warm, 100ms )--( )( lamp )--+
";
const TESTS: &str = "program motor.clad\nstep 50ms\n\nnever run and stop\n\nscenario \"warm\"\nstart   -____\nlamp => __---\n";

#[test]
fn every_tool_answers() {
    let folder = Folder::with(&[
        ("motor.clad", MOTOR),
        ("motor.ladder-test", TESTS),
        ("old.clad", &MOTOR.replace("100ms", "200ms")),
        ("broken.clad", "+--[ ]( a )--( )( b\n"),
    ]);
    let mut client = Client::of(&folder);
    let listed = client.ask("tools/list", json!({}));
    let tools = listed["tools"].as_array().unwrap();
    assert_eq!(tools.len(), 12);
    for tool in tools {
        assert_eq!(tool["outputSchema"]["required"][0], "ok", "{tool}");
    }

    let found = client.call("check", json!({"path": "broken.clad"}));
    assert_eq!(
        (&found["ok"], &found["findings"][0]["rule"]),
        (&json!(false), &json!("unclosed-block"))
    );
    let shown = client.call("fix", json!({"path": "broken.clad"}));
    assert!(
        shown["text"].as_str().unwrap().contains("+++ broken.clad"),
        "{shown}"
    );
    assert_eq!(folder.read("broken.clad"), "+--[ ]( a )--( )( b\n");
    client.call("fix", json!({"path": "broken.clad", "write": true}));
    assert!(folder.read("broken.clad").contains("( )( b )"));
    client.call("format", json!({"path": "motor.clad", "write": true}));

    let drawn = client.call(
        "render",
        json!({"path": "motor.clad", "scans": 1, "set": {"start": true}}),
    );
    assert!(drawn["text"].as_str().unwrap().contains("━━┥━━━┝━━"), "{drawn}");
    let picture = client.ask(
        "tools/call",
        json!({"name": "render", "arguments": {"path": "motor.clad", "as": "png"}}),
    );
    assert!(
        picture["content"][1]["data"]
            .as_str()
            .unwrap()
            .starts_with("iVBORw0KGgo")
    );

    let ran = client.call(
        "simulate",
        json!({"path": "motor.clad", "scans": 120, "watch": ["run", "warm.ET"], "inputs": [
            {"scan": 1, "values": {"start": true}},
            {"scan": 2, "values": {"start": false}},
            {"scan": 4, "values": {"stop": true}},
        ]}),
    );
    let runs: Vec<&Value> = ran["scans"]
        .as_array()
        .unwrap()
        .iter()
        .map(|it| &it["values"][0])
        .take(6)
        .collect();
    assert_eq!(runs, [false, true, true, true, false, false]);
    assert_eq!((&ran["total"], &ran["next"]), (&json!(120), &json!(50)));
    let rest = client.call(
        "simulate",
        json!({"path": "motor.clad", "scans": 120, "from": 100}),
    );
    assert_eq!((&rest["scans"][0]["scan"], rest.get("next")), (&json!(100), None));

    let tested = client.call("test", json!({"path": "motor.ladder-test"}));
    assert_eq!(
        (&tested["ok"], &tested["scenarios"][0]["passed"]),
        (&json!(true), &json!(true))
    );
    let proved = client.call("prove", json!({"path": "."}));
    assert_eq!(proved["properties"][0]["verdict"], "proved");
    let why = client.call(
        "why",
        json!({"path": "motor.clad", "tag": "run", "values": {"start": 1, "stop": 0, "run": true}}),
    );
    assert!(
        why["text"].as_str().unwrap().starts_with("run is 1: line "),
        "{why}"
    );
    let differs = client.call("diff", json!({"old": "old.clad", "new": "motor.clad"}));
    assert!(differs["text"].as_str().unwrap().contains("200ms"), "{differs}");
    let same = client.call(
        "diff",
        json!({"old": "motor.clad", "new": "motor.clad", "same": true}),
    );
    assert_eq!(same["ok"], true);
    let text = client.call("convert", json!({"path": "motor.clad", "to": "st"}));
    assert!(
        text["text"].as_str().unwrap().contains("(start OR run)"),
        "{text}"
    );
    client.call(
        "convert",
        json!({"path": "motor.clad", "to": "st", "output": "motor.st"}),
    );
    assert!(folder.read("motor.st").contains("PROGRAM"));
    let page = client.call("explain", json!({"name": "TON"}));
    assert!(page["text"].as_str().unwrap().contains("On-delay"), "{page}");
    let list = client.call("explain", json!({}));
    assert!(
        list["next"].is_u64() || list["text"].as_str().unwrap().contains("double-coil"),
        "{list}"
    );
}

#[test]
fn a_simulation_goes_on_from_call_to_call() {
    let folder = Folder::with(&[("motor.clad", MOTOR), ("broken.clad", "+--[ ]( a\n")]);
    let mut client = Client::of(&folder);
    let begun = client.call("session", json!({"action": "start", "path": "motor.clad"}));
    assert_eq!((&begun["session"], &begun["scan"]), (&json!(1), &json!(0)));
    client.call(
        "session",
        json!({"action": "step", "session": 1, "values": {"start": true}}),
    );
    let later = client.call("session", json!({"action": "step", "session": 1, "values": {"start": false}, "scans": 10, "tags": ["lamp", "warm.ET"]}));
    assert_eq!(
        later["values"],
        json!([
            {"tag": "lamp", "type": "BOOL", "value": "TRUE", "forced": false},
            {"tag": "warm.ET", "type": "TIME", "value": "T#100ms", "forced": false},
        ])
    );
    let why = client.call("session", json!({"action": "why", "tag": "lamp"}));
    assert!(
        why["why"].as_str().unwrap().contains("[TON]( warm, 100ms )"),
        "{why}"
    );
    let back = client.call("session", json!({"action": "back", "scans": 2, "tags": ["lamp"]}));
    assert_eq!(
        (&back["scan"], &back["values"][0]["value"]),
        (&json!(9), &json!("FALSE"))
    );
    client.call("session", json!({"action": "force", "values": {"run": false}}));
    let forced = client.call("session", json!({"action": "step", "tags": ["run"]}));
    assert_eq!(
        (&forced["values"][0]["value"], &forced["values"][0]["forced"]),
        (&json!("FALSE"), &json!(true))
    );
    client.call("session", json!({"action": "release"}));
    let ended = client.call("session", json!({"action": "end", "session": 1}));
    assert_eq!(ended["ended"], true);
    for (arguments, why) in [
        (
            json!({"action": "step", "session": 1}),
            "there is no simulation 1: start one with its `path`",
        ),
        (
            json!({"action": "start", "path": "broken.clad"}),
            "the program has errors, or uses a file that has some: `check` shows them",
        ),
        (json!({"action": "start"}), "`path` is missing"),
        (json!({"action": "jump"}), "`action` is wanted as"),
    ] {
        let refused = client.refused("session", arguments);
        assert!(refused.starts_with(why), "{refused}");
    }
}

#[test]
fn nothing_leads_out_of_the_folder() {
    let outside = Folder::with(&[("secret.clad", "+--[ ]( secret )--( )( y )--+\n")]);
    let folder = Folder::with(&[("motor.clad", MOTOR)]);
    let secret = outside.path("secret.clad").display().to_string();
    let mut client = Client::of(&folder);
    for path in [&secret, "../secret.clad", "/etc/passwd", "none.clad"] {
        for tool in ["check", "fix", "format", "render", "test", "prove", "convert"] {
            let refused = client.refused(tool, json!({"path": path}));
            assert!(
                refused.contains("there is no such file or folder in"),
                "{tool} {path}: {refused}"
            );
        }
        client.refused("simulate", json!({"path": path, "scans": 1}));
        client.refused(
            "simulate",
            json!({"path": "motor.clad", "scans": 1, "plant": path}),
        );
        client.refused("session", json!({"action": "start", "path": path}));
        client.refused("diff", json!({"old": path, "new": "motor.clad"}));
    }
    client.refused("diff", json!({"old": "HEAD:../secret.clad", "new": "motor.clad"}));
    client.refused(
        "diff",
        json!({"old": "--output=x:motor.clad", "new": "motor.clad"}),
    );
    client.refused("convert", json!({"path": "motor.clad", "output": "../motor.st"}));
    client.refused(
        "convert",
        json!({"path": "motor.clad", "to": "st", "output": "motor.clad"}),
    );
    assert_eq!(folder.read("motor.clad"), MOTOR);
    assert_eq!(folder.names(), ["motor.clad"]);
    let unknown = client.refused("check", json!({"path": "motor.clad", "rm": true}));
    assert_eq!(unknown, "`check` has no parameter `rm`: it takes path, from");
    assert!(
        client
            .refused("sudo", json!({}))
            .contains("there is no tool `sudo`")
    );
}

#[test]
fn there_are_pages_and_prompts() {
    let folder = Folder::with(&[]);
    let mut client = Client::of(&folder);
    let resources = client.ask("resources/list", json!({}));
    assert_eq!(resources["resources"][0]["uri"], "ladder://guide");
    for (address, words) in [
        ("ladder://guide", "A column is a step"),
        ("ladder://reference", "double-coil"),
        ("ladder://reference/TON", "On-delay"),
        ("ladder://reference/double-coil", "the last one"),
        ("ladder://reference/$Alarm", "$Alarm"),
    ] {
        let read = client.ask("resources/read", json!({"uri": address}));
        let text = read["contents"][0]["text"]
            .as_str()
            .unwrap_or_else(|| panic!("{read}"));
        assert!(text.contains(words), "{address}: {text}");
    }
    let none = client.ask("resources/read", json!({"uri": "ladder://reference/nothing"}));
    assert!(none["message"].is_string(), "{none}");
    let prompts = client.ask("prompts/list", json!({}));
    assert_eq!(prompts["prompts"].as_array().unwrap().len(), 3);
    let prompt = json!({"name": "explain_rung", "arguments": {"path": "motor.clad", "line": "4"}});
    let prompt = client.ask("prompts/get", prompt);
    let text = prompt["messages"][0]["content"]["text"].as_str().unwrap();
    assert!(text.contains("line 4 of motor.clad"), "{text}");
}

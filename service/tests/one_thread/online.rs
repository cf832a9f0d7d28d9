//! A controller in the place of a simulation: one that tells what a test says.

use std::collections::HashMap;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex};
use std::time::Duration;

use expect_test::expect;
use ladder_analysis::values::value::Value as Held;
use ladder_host::{Connection, Served, Wires};
use ladder_simulator::Point;
use ladder_simulator::online::{Connection as State, Found, Newest, Online, Wanted, Watched};
use ladder_workspace::{Misfit, Settings};
use serde_json::{Value, json};

use crate::session::Session;
use crate::{URI, command, opened_beside};

const MOTOR: &str = "VAR n : INT; END_VAR\n+--\\--[ ]( start )--\\--[/]( stop )--( )( run )--+\n|  /--[ ]( run )----/                           |\n+--[GT]( n, 5 )--( )( high )--------------------+\n";

/// What the wires of all sessions hold.
#[derive(Debug, Clone, Default)]
pub(crate) struct Desk(Arc<Mutex<HashMap<String, Held>>>);

impl Desk {
    fn set(&self, values: &[(&str, Held)]) {
        let values = values
            .iter()
            .map(|(name, value)| ((*name).to_owned(), value.clone()));
        self.0.lock().unwrap().extend(values);
    }
}

impl Wires for Desk {
    fn watch(
        &self,
        asked: &ladder_workspace::Online,
        stem: &str,
        program: &Online,
    ) -> Result<Connection, String> {
        let address = asked.modbus.clone().ok_or("no address")?;
        let wanted = program.points().into_iter().map(|point| Wanted {
            name: point.name.clone(),
            point,
        });
        let watch = Watch {
            desk: self.clone(),
            wanted: wanted.collect(),
            snapshots: AtomicU64::new(0),
        };
        Ok((format!("{stem}@{address}"), Box::new(watch)))
    }

    fn serve(
        &self,
        asked: &ladder_workspace::ServeModbus,
        _: &ladder_simulator::Simulation,
    ) -> Result<Box<dyn Served>, String> {
        match asked.hold {
            Some("initial") => Err("the port is taken".to_owned()),
            _ => Ok(Box::new(self.clone())),
        }
    }

    fn misfits(&self, settings: &Settings, simulation: &ladder_simulator::Simulation) -> Vec<Misfit> {
        let read = settings.devices.iter().flat_map(|device| &device.read);
        let unknown =
            read.filter_map(|it| Some((it.range.clone(), simulation.resolve(&it.tag).err()?.to_string())));
        unknown.collect()
    }
}

/// Clients write what is on the desk, and find there what the program makes of it.
impl Served for Desk {
    fn about(&self) -> String {
        "a desk: 2 tags, 1 can be written".to_owned()
    }

    fn written(&self, simulation: &ladder_simulator::Simulation) -> Vec<(Point, Held)> {
        let start = self.0.lock().unwrap().remove("start");
        let point = simulation.resolve("start").unwrap();
        start.into_iter().map(|value| (point.clone(), value)).collect()
    }

    fn show(&self, simulation: &ladder_simulator::Simulation) {
        let run = simulation.value(&simulation.resolve("run").unwrap());
        self.set(&[("run", run)]);
    }

    fn replace(&self, simulation: &ladder_simulator::Simulation) -> Result<(), String> {
        let found = simulation.resolve("run").map(|_| ());
        found.map_err(|unknown| unknown.to_string())
    }
}

/// Each look is a reading.
#[derive(Debug)]
struct Watch {
    desk: Desk,
    wanted: Vec<Wanted>,
    snapshots: AtomicU64,
}

impl Watched for Watch {
    fn wanted(&self) -> &[Wanted] {
        &self.wanted
    }

    fn newest(&self) -> Newest {
        let held = self.desk.0.lock().unwrap();
        let values: Vec<Option<Held>> = self.wanted.iter().map(|it| held.get(&it.name).cloned()).collect();
        let found = values.iter().map(|value| match value {
            Some(_) => Found::Here,
            None => Found::Missing,
        });
        Newest {
            connection: State::Open,
            found: found.collect(),
            snapshots: self.snapshots.fetch_add(1, Ordering::Relaxed),
            values: values.into(),
            age: Some(Duration::from_millis(100)),
        }
    }
}

fn online() -> (Session, Desk) {
    let desk = Desk::default();
    let files = [("ladder.toml", "[online]\nmodbus = \"10.0.0.5:502\"\n")];
    let mut session = opened_beside(MOTOR, &files, Some(desk.clone()));
    desk.set(&[
        ("start", Held::Bool(true)),
        ("stop", Held::Bool(false)),
        ("run", Held::Bool(true)),
        ("high", Held::Bool(false)),
    ]);
    let started = command(
        &mut session,
        "start",
        json!({"uri": URI, "options": {"online": true}}),
    );
    assert_eq!(started["session"], "s1", "{started}");
    session.wait(250);
    (session, desk)
}

fn state(session: &mut Session) -> Value {
    command(session, "state", json!({"session": "s1"}))
}

fn power(state: &Value, line: u64) -> Vec<bool> {
    let power = state["power"].as_array().unwrap().iter();
    let own = power.filter(|it| it["range"]["start"]["line"] == line);
    own.map(|it| it["on"] == true).collect()
}

#[test]
fn values_and_power_are_those_of_the_controller() {
    let (mut session, desk) = online();
    let seen = state(&mut session);
    expect![[r#"
        [
          "online motor@10.0.0.5:502, READ ONLY; values 0.1 s old; 1 tag is not there as here",
          "running",
          {
            "ageMs": 100.0,
            "answers": true,
            "differences": [
              "n is not in the controller"
            ],
            "name": "motor@10.0.0.5:502",
            "text": "READ ONLY; values 0.1 s old; 1 tag is not there as here"
          }
        ]"#]]
    .assert_eq(&format!(
        "{:#}",
        json!([seen["text"], seen["status"], seen["controller"]])
    ));
    assert!(power(&seen, 1).iter().all(|on| *on), "{seen}");
    desk.set(&[
        ("stop", Held::Bool(true)),
        ("run", Held::Bool(false)),
        ("n", Held::Int(7)),
        ("high", Held::Bool(true)),
    ]);
    session.wait(250);
    let seen = state(&mut session);
    assert_eq!(power(&seen, 1).last(), Some(&false), "{seen}");
    assert!(power(&seen, 3).iter().all(|on| *on), "{seen}");
    let why = command(&mut session, "why", json!({"session": "s1", "tag": "run"}));
    expect![[r#"
        run is 0: line 2, ( )( run ) writes 0; blocked by [/]( stop ) (line 2, column 24): stop is 1
          stop is 1: it is an input"#]]
    .assert_eq(why["text"].as_str().unwrap());
}

#[test]
fn what_is_not_known_is_marked_and_nothing_is_a_switch() {
    let (mut session, desk) = online();
    let seen = state(&mut session);
    let unknown = |state: &Value, line: u64| {
        let power = state["power"].as_array().unwrap().iter();
        let own = power.filter(|it| it["range"]["start"]["line"] == line);
        let marks = own.map(|it| if it["unknown"] == true { '?' } else { '.' });
        marks.collect::<String>()
    };
    expect!["1: ............., 3: ..?????"].assert_eq(&format!(
        "1: {}, 3: {}",
        unknown(&seen, 1),
        unknown(&seen, 3)
    ));
    let tags = seen["tags"].as_array().unwrap();
    assert!(tags.iter().all(|tag| tag["readOnly"] == true), "{seen}");
    desk.set(&[("n", Held::Int(7))]);
    session.wait(250);
    assert!(!unknown(&state(&mut session), 3).contains('?'));
}

#[test]
fn what_stays_against_the_program_is_a_fault_of_its_rung() {
    let (mut session, desk) = online();
    desk.set(&[("high", Held::Bool(true)), ("n", Held::Int(0))]);
    session.wait(400);
    let seen = state(&mut session);
    expect![[r#"
        [
          {
            "message": "high is not what this rung makes it: something else writes it, or the controller runs another program",
            "range": {
              "end": {
                "character": 0,
                "line": 4
              },
              "start": {
                "character": 0,
                "line": 3
              }
            },
            "scan": 9
          }
        ]"#]].assert_eq(&format!("{:#}", seen["faults"]));
}

#[test]
fn nothing_that_writes_or_stops_is_done() {
    let (mut session, _) = online();
    for (name, given) in [
        ("set", json!({"tag": "start", "value": false})),
        ("force", json!({"tag": "start", "value": false})),
        ("unforce", json!({})),
        ("pulse", json!({"tag": "start"})),
        ("step", json!({})),
        ("stepRung", json!({})),
        ("back", json!({})),
        ("reset", json!({})),
        ("warmRestart", json!({})),
        ("breakpoints", json!({"lines": [1]})),
        ("record", json!({})),
    ] {
        let mut argument = json!({"session": "s1"});
        argument
            .as_object_mut()
            .unwrap()
            .extend(given.as_object().unwrap().clone());
        let answer = session.ask(
            "workspace/executeCommand",
            json!({"command": format!("ladder.simulate.{name}"), "arguments": [argument]}),
        );
        let message = answer["error"]["message"].as_str().unwrap_or_default();
        assert!(message.contains("only watched"), "{name}: {answer}");
    }
    session.wait(250);
    assert_eq!(state(&mut session)["status"], "running");
}

#[test]
fn an_edit_is_watched_on() {
    let (mut session, _) = online();
    let text = MOTOR.replace("[/]( stop )", "[ ]( stop )");
    session.notify(
        "textDocument/didChange",
        json!({"textDocument": {"uri": URI, "version": 2}, "contentChanges": [{"text": text}]}),
    );
    session.wait(600);
    let seen = state(&mut session);
    assert_eq!(seen["version"], 2, "{seen}");
    assert!(
        seen["faults"]
            .to_string()
            .contains("run is not what this rung makes it"),
        "{seen}"
    );
}

#[test]
fn without_a_way_or_a_name_there_is_a_sentence() {
    let refused = |files: &[(&str, &str)], desk| {
        let mut session = opened_beside(MOTOR, files, desk);
        let start = json!({"uri": URI, "options": {"online": true}});
        let answer = session.ask(
            "workspace/executeCommand",
            json!({"command": "ladder.simulate.start", "arguments": [start]}),
        );
        answer["error"]["message"].as_str().unwrap_or_default().to_owned()
    };
    let all = [
        refused(&[], None),
        refused(&[], Some(Desk::default())),
        refused(
            &[("ladder.toml", "[online]\nevery = \"1s\"\n")],
            Some(Desk::default()),
        ),
    ];
    expect![[r#"
        there is no way to a controller from here
        which controller? Put [online] into ladder.toml, for example with logix = "192.168.1.10/0"
        no address"#]]
    .assert_eq(&all.join("\n"));
}

#[test]
fn clients_write_before_a_scan_and_read_after_it() {
    let desk = Desk::default();
    let mut session = opened_beside(MOTOR, &[], Some(desk.clone()));
    command(&mut session, "start", json!({"uri": URI}));
    let served = command(&mut session, "serve", json!({"session": "s1", "on": true}));
    expect!["paused, scan 0, 0ms, a desk: 2 tags, 1 can be written"]
        .assert_eq(served["text"].as_str().unwrap());
    desk.set(&[("start", Held::Bool(true))]);
    let held = |name: &str| desk.0.lock().unwrap().get(name).cloned();
    assert_eq!(held("run"), None);
    command(&mut session, "step", json!({"session": "s1"}));
    assert_eq!((held("start"), held("run")), (None, Some(Held::Bool(true))));
    // An edit that the settings do not fit ends it.
    let text = MOTOR.replace("run", "runs");
    session.notify(
        "textDocument/didChange",
        json!({"textDocument": {"uri": URI, "version": 2}, "contentChanges": [{"text": text}]}),
    );
    session.wait(300);
    assert_eq!(state(&mut session)["served"], Value::Null);
}

/// What was told last of a file: places and messages.
fn told_of(session: &Session, uri: &str) -> Option<String> {
    let told = session.heard("textDocument/publishDiagnostics");
    let of_file = told.iter().rfind(|it| it["uri"] == *uri)?;
    let lines = of_file["diagnostics"].as_array()?.iter().map(|it| {
        let start = &it["range"]["start"];
        format!(
            "{}:{} {}\n",
            start["line"],
            start["character"],
            it["message"].as_str().unwrap_or_default()
        )
    });
    Some(lines.collect())
}

#[test]
fn settings_show_what_no_program_has() {
    let settings =
        "[[device]]\nname = \"rio\"\nmodbus = \"10.0.0.6:502\"\nread = { \"coil 0\" = \"ready\" }\n";
    let mut session = opened_beside(
        MOTOR,
        &[("motor.clad", MOTOR), ("ladder.toml", settings)],
        Some(Desk::default()),
    );
    let uri = "file:///plant/ladder.toml";
    expect![[r#"
        3:9 there is no tag `ready` in this program
    "#]]
    .assert_eq(&told_of(&session, uri).unwrap());
    // In the text that an editor shows it follows the program.
    let document =
        json!({"uri": uri, "languageId": "toml", "version": 1, "text": settings.replace("coil", "discrete")});
    session.notify("textDocument/didOpen", json!({"textDocument": document}));
    expect![[r#"
        3:9 there is no tag `ready` in this program
    "#]]
    .assert_eq(&told_of(&session, uri).unwrap());
    let text = MOTOR.replace("n : INT;", "n : INT; ready : BOOL;");
    let params = json!({"textDocument": {"uri": URI, "version": 2}, "contentChanges": [{"text": text}]});
    session.notify("textDocument/didChange", params);
    session.wait(1000);
    assert_eq!(told_of(&session, uri).unwrap(), "");
}

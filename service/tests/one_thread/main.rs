//! The server on one thread, with files in memory and a clock that goes on only when there is nothing else to do: what is seen
//! here is the same each time.

mod online;
mod session;

use online::Desk;
use serde_json::{Value, json};
use session::Session;

const URI: &str = "file:///plant/motor.clad";
const CONTACT: &str = "+--[ ]( a )--( )( y )--+\n";

/// A client that has opened a program, in a workspace with these files besides.
fn opened(text: &str, files: &[(&str, &str)]) -> Session {
    opened_beside(text, files, None)
}

/// The same, where there is a way to wires.
fn opened_beside(text: &str, files: &[(&str, &str)], wires: Option<Desk>) -> Session {
    let mut session = Session::beside(wires, files);
    session.ask(
        "initialize",
        json!({"rootUri": "file:///plant", "capabilities": {}}),
    );
    session.notify("initialized", json!({}));
    session.open(URI, text);
    session
}

fn command(session: &mut Session, name: &str, given: Value) -> Value {
    let answer = session.ask(
        "workspace/executeCommand",
        json!({"command": format!("ladder.simulate.{name}"), "arguments": [given]}),
    );
    answer["result"].clone()
}

/// Each level is asked for when it is opened; a member is set and forced by its path.
#[test]
fn compound_tags_are_listed_level_by_level() {
    let text = "TYPE\n P : (IDLE, RUN);\n M : STRUCT\n  n : INT; p : P; t : TON;\n END_STRUCT;\nEND_TYPE\n\
                VAR m : ARRAY[1..2] OF M; g : ARRAY[1..100, 1..100] OF INT; END_VAR\n\
                +--[TON]( m[2].t, T#1s )--[MOV]( g[1, 2], 3 )--+\n";
    let mut session = opened(text, &[]);
    command(&mut session, "start", json!({"uri": URI}));
    let mut listed = |given: Value| -> Vec<String> {
        let mut search = json!({"session": "s1"});
        let (search_map, given) = (search.as_object_mut().unwrap(), given.as_object().unwrap());
        search_map.extend(given.clone());
        let found = command(&mut session, "tags", search);
        let tags = found["tags"].as_array().unwrap().iter();
        tags.map(|tag| format!("{} {} {} {}", tag["name"], tag["type"], tag["text"], tag["parts"]))
            .map(|line| line.replace('"', ""))
            .collect()
    };
    let top = ["m ARRAY[1..2] OF M  2", "g ARRAY[1..100, 1..100] OF INT  10000"];
    assert_eq!(listed(json!({"of": ""})), top);
    assert_eq!(
        listed(json!({"of": "m"})),
        ["m[1] M n=0 p=IDLE 3", "m[2] M n=0 p=IDLE 3"]
    );
    let members = [
        "m[2].n INT 0 null",
        "m[2].p P IDLE null",
        "m[2].t TON Q=FALSE ET=T#0s 2",
    ];
    assert_eq!(listed(json!({"of": "m[2]"})), members);
    let shown = ["m[2].t.Q BOOL 0 null", "m[2].t.ET TIME 0ms null"];
    assert_eq!(listed(json!({"of": "m[2].t"})), shown);
    // A long array opens into stretches, and these into elements.
    let stretches = listed(json!({"of": "g"}));
    assert_eq!(stretches.len(), 100);
    assert_eq!(stretches[1], "g[2, 1] .. g[2, 100] INT  100");
    let elements = listed(json!({"of": "g[2, 1] .. g[2, 100]"}));
    assert_eq!(
        (elements.len(), elements[99].as_str()),
        (100, "g[2, 100] INT 0 null")
    );
    assert_eq!(
        listed(json!({"names": ["g[2, 1] .. g[2, 100]"]})),
        [stretches[1].as_str()]
    );
    let some = ["g[1, 3] INT 0 null", "g[1, 4] INT 0 null"];
    assert_eq!(listed(json!({"of": "g", "first": 2, "count": 2})), some);
    assert_eq!(listed(json!({"of": "", "containing": "[2].P"})), [top[0]]);
    let named = ["m[2] M n=0 p=IDLE 3", "m[1].n INT 0 null"];
    assert_eq!(listed(json!({"names": ["m[2]", "m[1].n"]})), named);
    command(
        &mut session,
        "force",
        json!({"session": "s1", "tag": "m[2].p", "value": "run"}),
    );
    let found = command(&mut session, "tags", json!({"session": "s1", "of": "m"}));
    let forced: Vec<&Value> = found["tags"]
        .as_array()
        .unwrap()
        .iter()
        .map(|tag| &tag["forced"])
        .collect();
    assert_eq!(forced, [false, true]);
}

#[test]
fn a_run_scans_at_its_times() {
    let mut session = opened(CONTACT, &[]);
    command(
        &mut session,
        "start",
        json!({"uri": URI, "options": {"intervalMs": 10}}),
    );
    command(&mut session, "run", json!({"session": "s1"}));
    session.wait(995);
    let state = command(&mut session, "state", json!({"session": "s1"}));
    assert_eq!(
        (&state["status"], &state["scan"]),
        (&json!("running"), &json!(100))
    );
    command(&mut session, "speed", json!({"session": "s1", "speed": 10.0}));
    session.wait(99);
    let state = command(&mut session, "pause", json!({"session": "s1"}));
    assert_eq!(state["scan"], 200);
    let states = session.heard("ladder/simulationState");
    // Twenty in a second.
    assert!((20..26).contains(&states.len()), "{}", states.len());
    session.wait(10_000);
    let state = command(&mut session, "state", json!({"session": "s1"}));
    assert_eq!(state["scan"], 200, "it is paused");
}

#[test]
fn a_scan_without_end_keeps_no_message_waiting() {
    let text = "+--<LBL>( again )--( )( y )--+\n+--<JMP>( again )--+\n";
    let mut session = opened(text, &[("ladder.toml", "[simulate]\nwatchdog = 1000000000\n")]);
    let started = command(&mut session, "start", json!({"uri": URI}));
    assert_eq!(
        started["session"],
        "s1",
        "{:?}",
        session.heard("textDocument/publishDiagnostics")
    );
    // Each look at the clock takes a moment, as work does.
    session.time_passes_with_work();
    command(&mut session, "run", json!({"session": "s1"}));
    let state = command(&mut session, "pause", json!({"session": "s1"}));
    assert_eq!((&state["status"], &state["scan"]), (&json!("paused"), &json!(0)));
}

#[test]
fn retentive_tags_are_kept_in_the_files_that_there_are() {
    let text = "VAR RETAIN n: DINT; END_VAR\n+--[ ]( a )--[CALC]( n, n + 1 )--+\n";
    let mut session = opened(
        text,
        &[("ladder.toml", "[simulate]\nretain = \"plant.retain\"\n")],
    );
    let started = command(
        &mut session,
        "start",
        json!({"uri": URI, "options": {"inputs": {"a": true}}}),
    );
    assert_eq!(
        started["session"],
        "s1",
        "{:?}",
        session.heard("textDocument/publishDiagnostics")
    );
    command(&mut session, "step", json!({"session": "s1", "scans": 7}));
    command(&mut session, "stop", json!({"session": "s1"}));
    let kept = session.file("plant.retain");
    assert!(
        kept.starts_with("ladder-retain 1\nprogram motor.clad\nn\tDINT\t7\n"),
        "{kept}"
    );
    command(&mut session, "start", json!({"uri": URI}));
    let state = command(&mut session, "state", json!({"session": "s2"}));
    assert!(state["tags"].to_string().contains(r#""n""#), "{state}");
    assert!(state["tags"].to_string().contains('7'), "{state}");
}

#[test]
fn the_other_files_of_the_workspace_count() {
    let called = "+--( )( y )--+\n+--<FUN>( count )--( )( y )--+\n";
    let session = opened(
        "+--( )( z )--<CALL>( count )--+\n",
        &[("ladder.toml", ""), ("line/called.clad", called)],
    );
    let found = session.heard("textDocument/publishDiagnostics");
    assert_eq!(found.last().unwrap()["diagnostics"], json!([]));
    let alone = opened("+--( )( z )--<CALL>( count )--+\n", &[]);
    let found = alone.heard("textDocument/publishDiagnostics");
    assert_eq!(
        found.last().unwrap()["diagnostics"][0]["code"],
        "unknown-function"
    );
}

/// The folder of a library is a workspace of its own.
#[test]
fn the_blocks_of_a_library_of_the_workspace_count() {
    let hold = "FUNCTION_BLOCK [$Hold]\n+--[ ]( EN )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n";
    let mut session = opened(
        "+--[$Hold]--( )( y )--+\n",
        &[
            ("ladder.toml", "[workspace]\nlibrary = [\"shared/blocks\"]\n"),
            ("shared/blocks/ladder.toml", ""),
            ("shared/blocks/hold.clad", hold),
        ],
    );
    let found = |session: &Session| {
        session.heard("textDocument/publishDiagnostics").last().unwrap()["diagnostics"].clone()
    };
    assert_eq!(found(&session), json!([]));
    let at = json!({"textDocument": {"uri": URI}, "position": {"line": 0, "character": 5}});
    let definition = session.ask("textDocument/definition", at.clone())["result"].to_string();
    assert!(definition.contains("shared/blocks/hold.clad"), "{definition}");
    let hover = session.ask("textDocument/hover", at.clone())["result"].to_string();
    assert!(hover.contains("$Hold"), "{hover}");
    let completion = session.ask("textDocument/completion", at)["result"].to_string();
    assert!(completion.contains("$Hold"), "{completion}");
    session.write("shared/blocks/hold.clad", &hold.replace("$Hold", "$Held"));
    session.wait(3_000);
    assert_eq!(found(&session)[0]["code"], "unknown-block");
}

#[test]
fn folders_of_a_library_lie_inside_of_the_workspace() {
    let outside = "[workspace]\nlibrary = [\"../blocks\", \"none\"]\n";
    let mut session = opened(CONTACT, &[("ladder.toml", "")]);
    let document =
        json!({"uri": "file:///plant/ladder.toml", "languageId": "toml", "version": 1, "text": outside});
    session.notify("textDocument/didOpen", json!({"textDocument": document}));
    session.wait(1_000);
    let found = session.heard("textDocument/publishDiagnostics");
    let of_settings = found
        .iter()
        .rfind(|found| found["uri"] == "file:///plant/ladder.toml")
        .unwrap();
    let messages = of_settings["diagnostics"]
        .as_array()
        .unwrap()
        .iter()
        .map(|found| found["message"].as_str().unwrap().to_owned());
    let messages: Vec<String> = messages.collect();
    assert!(
        messages[0].starts_with("`../blocks` cannot be used: this leads out of the workspace"),
        "{messages:?}"
    );
    assert_eq!(messages[1], "`none` cannot be used: no such file or folder");
}

#[test]
fn the_page_about_the_protocol_shows_what_is_answered_here_too() {
    const PAGE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/protocol.md");
    let page = std::fs::read_to_string(PAGE).unwrap();
    let mut session = Session::with(&[]);
    let mut compared = 0;
    for example in page.split("```json\n").skip(1) {
        let example: Value = serde_json::from_str(example.split("```").next().unwrap()).unwrap();
        let is_of_client = |method| {
            let notifications = [
                "initialized",
                "exit",
                "ladder/simulationShown",
                "ladder/toDebugger",
            ];
            notifications.contains(&method)
                || matches!(method, "textDocument/didOpen" | "textDocument/didChange")
        };
        match (example.get("id"), example["method"].as_str()) {
            (Some(_), Some(_)) => session.send(&example),
            (None, Some(method)) if is_of_client(method) => session.send(&example),
            (Some(id), None) => {
                let answer = session.answer(id).expect("an answer");
                // Nothing can be served from a page.
                if !answer.to_string().contains("nothing can be served from here") {
                    assert_eq!(answer, &example);
                    compared += 1;
                }
            }
            // How many states come depends on the clock.
            (None, Some("ladder/simulationState")) => {}
            (None, Some(_)) => assert!(session.has_said(&example), "{example}"),
            (None, None) => panic!("{example}"),
        }
    }
    assert!(compared > 40, "{compared}");
    assert!(session.is_over());
}

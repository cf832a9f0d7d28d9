//! Whatever a client sends, each request gets exactly one answer, in words.

use serde_json::{Value as Json, json};

use super::Client;

/// What a launch with these files says; `$` stands for the folder of the program's workspace.
fn launched_with(client: &mut Client, configuration: &Json) -> String {
    let folder = client.folder.path().to_str().unwrap().to_owned();
    let configuration = configuration.to_string().replace('$', &folder);
    let answer = client
        .ask("launch", serde_json::from_str(&configuration).unwrap())
        .swap_remove(0);
    answer["message"]
        .as_str()
        .unwrap_or("launched")
        .replace(&folder, "$")
}

#[test]
#[cfg(unix)]
fn no_file_outside_of_the_workspace_is_read() {
    use std::os::unix::fs::symlink;
    let outside = tempfile::tempdir().unwrap();
    let secret = outside.path().join("secret.ladder-test");
    std::fs::write(&secret, "root:x:0:0\n").unwrap();
    std::fs::write(outside.path().join("secret.clad"), "+--[ ]( secret )\n").unwrap();
    std::fs::write(outside.path().join("own.ladder-test"), "root:x:0:0\n").unwrap();
    let mut client = Client::new("+--[ ]( a )--( )( b )--+\n");
    client.body("initialize", json!({}));
    let own = client.folder.path().to_owned();
    std::fs::write(
        own.join("good.ladder-test"),
        "program own.clad\nscenario \"s\"\na -\nb => -\n",
    )
    .unwrap();
    std::fs::write(own.join("notes.txt"), "root:x:0:0\n").unwrap();
    symlink(&secret, own.join("link.ladder-test")).unwrap();
    symlink(&secret, own.join("own.ladder-test")).unwrap();
    symlink(outside.path(), own.join("folder")).unwrap();
    symlink(outside.path().join("secret.clad"), own.join("link.clad")).unwrap();
    let away = secret.to_str().unwrap();
    let says = [
        json!({"program": "$/own.clad", "scenarioFile": "/etc/passwd"}),
        json!({"scenarioFile": "/etc/passwd"}),
        json!({"scenarioFile": "$/notes.txt"}),
        json!({"program": "$/own.clad", "scenarioFile": away}),
        json!({"program": "$/own.clad", "scenarioFile": "$/link.ladder-test"}),
        json!({"scenarioFile": "$/link.ladder-test"}),
        json!({"program": "$/link.ladder-test"}),
        json!({"program": "$/own.clad", "scenarioLine": 1}),
        json!({"scenarioFile": "$/folder/own.ladder-test"}),
        json!({"program": "$/link.clad"}),
        json!({"program": "$/folder/secret.clad"}),
        json!({"program": "$/own.clad", "scenarioFile": "../secret.ladder-test"}),
        json!({"program": "$/own.clad", "inputs": "/etc/passwd"}),
        json!({"program": "$/own.clad", "inputs": "link.clad"}),
        json!({"program": "$/own.clad", "retain": "$/folder/kept"}),
        json!({"program": "//other/share/own.clad"}),
        json!({"program": "\\\\other\\share\\own.clad"}),
        json!({"scenarioFile": "\\\\other\\share\\own.ladder-test"}),
        json!({"program": "$/own.clad", "scenarioFile": "//other/share/own.ladder-test"}),
        json!({"program": "$/own.clad", "inputs": "//other/share/own.csv"}),
        json!({"program": "$/own.clad", "retain": "//other/share/kept"}),
    ];
    for configuration in says {
        let told = launched_with(&mut client, &configuration);
        let refused = [
            "leads out of the workspace",
            "lies outside of",
            "on another computer",
            "ending in .ladder-test",
        ];
        assert!(
            refused.iter().any(|it| told.contains(it)),
            "{configuration}: {told}"
        );
        assert!(
            !told.contains("root") && !told.contains("secret )"),
            "{configuration}: {told}"
        );
    }
    let good = json!({"program": "$/own.clad", "scenarioFile": "good.ladder-test"});
    assert_eq!(launched_with(&mut client, &good), "launched");
}

#[test]
#[cfg(unix)]
fn a_breakpoint_in_a_file_that_only_looks_like_the_program_is_none() {
    use std::os::unix::fs::symlink;
    let outside = tempfile::tempdir().unwrap();
    let mut client = Client::launched("+--[ ]( a )--( )( b )--+\n");
    let own = client.folder.path().to_owned();
    symlink("own.clad", own.join("same.clad")).unwrap();
    symlink(own.join("own.clad"), outside.path().join("own.clad")).unwrap();
    symlink(outside.path().join("own.clad"), own.join("round.clad")).unwrap();
    let mut verified = |path: &str| {
        let asked = json!({"source": {"path": path}, "breakpoints": [{"line": 1}]});
        client.body("setBreakpoints", asked)["breakpoints"][0]["verified"] == true
    };
    let own = own.to_str().unwrap();
    assert!(verified(&format!("{own}/own.clad")));
    assert!(verified(&format!("{own}/same.clad")));
    // It leads out of the workspace, and nothing there is asked where it leads.
    assert!(!verified(&format!("{own}/round.clad")));
    assert!(!verified("//other/share/own.clad"));
}

const COMMANDS: [&str; 37] = [
    "initialize",
    "launch",
    "attach",
    "configurationDone",
    "threads",
    "setBreakpoints",
    "setFunctionBreakpoints",
    "setInstructionBreakpoints",
    "breakpointLocations",
    "dataBreakpointInfo",
    "setDataBreakpoints",
    "setExceptionBreakpoints",
    "exceptionInfo",
    "stackTrace",
    "scopes",
    "variables",
    "setVariable",
    "setExpression",
    "evaluate",
    "completions",
    "pause",
    "continue",
    "next",
    "stepIn",
    "stepOut",
    "stepBack",
    "reverseContinue",
    "ladder/force",
    "ladder/unforce",
    "ladder/stepBackScan",
    "gotoTargets",
    "goto",
    "source",
    "",
    "restart",
    "terminate",
    "disconnect",
];

/// Arguments that no client should send.
fn arguments(program: &str) -> Vec<Json> {
    let numbers = [i64::MIN, -1, 0, 1, i64::MAX];
    let mut all = vec![Json::Null, json!([]), json!("text"), json!(7), json!({})];
    for number in numbers {
        all.push(json!({
            "frameId": number, "variablesReference": number, "threadId": number, "line": number, "endLine": number,
            "column": number, "name": "n", "value": "16#FFFF_FFFF_FFFF", "expression": "n[", "text": "n", "context": "repl",
            "source": {"path": program}, "breakpoints": [
                {"line": number, "column": number, "condition": "n", "dataId": ""},
                {"line": number, "hitCondition": "% 0", "logMessage": "{", "dataId": "SYS.SCAN"},
            ],
            "lines": [number], "filters": ["faults"], "program": program, "start": number, "granularity": "line",
        }));
    }
    for text in [
        "",
        "\0",
        "\u{feff}$",
        "$R#1.",
        "(",
        "a := b := c",
        "force",
        "unforce \u{202e}",
        "'",
        "n /* */",
        "#",
    ] {
        all.push(json!({
            "expression": text, "name": text, "value": text, "text": text, "column": 2, "context": "repl", "frameId": 1,
            "variablesReference": 1, "program": text, "source": {"path": text}, "line": 1,
            "breakpoints": [{"line": 1, "condition": text, "logMessage": text, "hitCondition": text, "dataId": text}],
            "scenario": text, "retain": text, "cycle": text, "inputs": {text: text}, "arguments": {"program": text},
        }));
    }
    all
}

#[test]
fn every_request_is_answered_once_in_every_phase() {
    let text = "VAR n : INT; a : ARRAY[1..3] OF INT; t : TON; END_VAR\n+--[ADD]( n, n, 1 )--[GE]( n, 3 )--( )( y )--+\n";
    for launched in [false, true] {
        let mut client = if launched {
            Client::launched(text)
        } else {
            Client::new(text)
        };
        let program = client.program();
        for command in COMMANDS {
            for arguments in arguments(&program) {
                let told = client.ask(command, arguments.clone());
                let message = told[0]["message"].as_str().unwrap_or_default();
                assert!(!message.contains("error of its own"), "{command} {arguments}");
                assert!(
                    told[0]["success"] == true || !message.is_empty(),
                    "{command} {arguments}"
                );
            }
        }
    }
}

//! Whatever a client sends, each request gets exactly one answer, in words.

use serde_json::{Value as Json, json};

use super::Client;

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
                let said = client.ask(command, arguments.clone());
                let message = said[0]["message"].as_str().unwrap_or_default();
                assert!(!message.contains("error of its own"), "{command} {arguments}");
                assert!(
                    said[0]["success"] == true || !message.is_empty(),
                    "{command} {arguments}"
                );
            }
        }
    }
}

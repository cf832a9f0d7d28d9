//! Breakpoints that are refused, each with its reason.

use expect_test::{Expect, expect};
use serde_json::{Value as Json, json};

use super::Client;

const TEXT: &str = "VAR level : INT; END_VAR
+--[ADD]( level, level, 1 )--+
";

/// What is answered to one breakpoint.
#[track_caller]
fn check(command: &str, breakpoint: &Json, reason: Expect) {
    let mut client = Client::launched(TEXT);
    let source = json!({"path": client.program()});
    let asked = json!({"source": source, "breakpoints": [breakpoint]});
    let answer = client.body(command, asked);
    let answers = answer["breakpoints"].as_array().unwrap();
    assert_eq!(answers.len(), 1, "{answers:?}");
    let message = answers[0]["message"].as_str();
    assert_eq!(answers[0]["verified"], message.is_none(), "{answers:?}");
    reason.assert_eq(message.unwrap_or_default());
}

#[test]
fn what_is_next_to_a_breakpoint_is_checked_when_it_is_set() {
    let line = |more: Json| {
        let mut breakpoint = json!({"line": 2});
        breakpoint
            .as_object_mut()
            .unwrap()
            .extend(more.as_object().unwrap().clone());
        breakpoint
    };
    let check = |more: Json, reason: Expect| check("setBreakpoints", &line(more), reason);
    check(json!({"condition": "level > 3"}), expect![[""]]);
    check(
        json!({"condition": "nix > 3"}),
        expect!["there is no tag `nix` in this program"],
    );
    check(
        json!({"condition": "level >"}),
        expect!["a value is missing next to this operator"],
    );
    check(
        json!({"condition": "level"}),
        expect!["`level` is of type INT; a condition is TRUE or FALSE, as in level > 0"],
    );
    check(
        json!({"condition": "level = 'a'"}),
        expect!["a comparison gives BOOL, the result is INT"],
    );
    check(
        json!({"hitCondition": "often"}),
        expect!["`often` is not a count of hits: write a number such as 5, or >= 5, or % 5"],
    );
    check(
        json!({"logMessage": "it is {nix}"}),
        expect!["there is no tag `nix` in this program"],
    );
    check(
        json!({"logMessage": "it is {level"}),
        expect!["`it is {level`: a brace is not closed; `{{` is a brace itself"],
    );
}

#[test]
fn a_breakpoint_below_the_last_rung_is_refused() {
    check(
        "setBreakpoints",
        &json!({"line": 9}),
        expect!["there is no rung in this line or below it"],
    );
}

#[test]
fn a_breakpoint_on_a_tag_is_checked_likewise() {
    check(
        "setDataBreakpoints",
        &json!({"dataId": "level", "condition": "level > 3"}),
        expect![[""]],
    );
    check(
        "setDataBreakpoints",
        &json!({"dataId": "nix"}),
        expect!["there is no tag `nix` in this program"],
    );
    check(
        "setDataBreakpoints",
        &json!({"dataId": "level", "condition": "nix > 3"}),
        expect!["there is no tag `nix` in this program"],
    );
}

/// As many answers as questions: a client that gets fewer shows no reason.
#[test]
fn a_function_is_no_place() {
    check(
        "setFunctionBreakpoints",
        &json!({"name": "main"}),
        expect!["a breakpoint is in a line: set one at the first rung of the function or block"],
    );
}

//! Structures, arrays and the states of blocks: the names of frames, and variables that open.

use expect_test::expect;
use serde_json::{Value as Json, json};

use super::Client;

const TEXT: &str = r"TYPE
    Phase : (IDLE, FILLING);
    Motor : STRUCT
        speed   : REAL := 50.0;
        running : BOOL;
        delay   : TON;
    END_STRUCT;
END_TYPE
VAR
    lines : ARRAY[1..2] OF Motor;
    step  : Phase := FILLING;
    grid  : ARRAY[1..2, 0..1] OF INT;
    m1    : $Motor;
END_VAR
FUNCTION_BLOCK [$Inner]
VAR_INPUT a : BOOL; END_VAR
VAR n : INT; END_VAR
+--[ ]( a )--[ADD]( n, n, 1 )--( )( ENO )--+
END_FUNCTION_BLOCK
FUNCTION_BLOCK [$Motor]
VAR_INPUT start : BOOL; END_VAR
VAR inner : $Inner; own : Motor; END_VAR
+--[$Inner]( inner, start )--( )( own.running )--[$Inner]( start )--+
END_FUNCTION_BLOCK
+--[$Motor]( m1, TRUE )--[$Motor]( TRUE )--[TON]( lines[2].delay, T#5s )--[MOV]( grid[2, 1], 7 )--+
";

/// What opens, with all that is in it, a line for each.
fn tree(client: &mut Client, reference: &Json, depth: usize, out: &mut String) {
    let body = client.body("variables", json!({"variablesReference": reference}));
    for variable in body["variables"].as_array().unwrap() {
        let text = |key: &str| variable[key].as_str().unwrap().to_owned();
        let line = format!("{}{} = {}", "  ".repeat(depth), text("name"), text("value"));
        out.push_str(line.trim_end());
        out.push('\n');
        if variable["variablesReference"] != 0 {
            tree(client, &variable["variablesReference"], depth + 1, out);
        }
    }
}

fn scope(client: &mut Client, name: &str) -> String {
    let scopes = client.body("scopes", json!({"frameId": 1}));
    let scopes = scopes["scopes"].as_array().unwrap();
    let scope = scopes.iter().find(|scope| scope["name"] == name).unwrap();
    let mut out = String::new();
    tree(client, &scope["variablesReference"].clone(), 0, &mut out);
    out
}

fn frames(client: &mut Client) -> Vec<String> {
    let body = client.body("stackTrace", json!({"threadId": 1}));
    let frames = body["stackFrames"].as_array().unwrap();
    let names = frames
        .iter()
        .map(|frame| frame["name"].as_str().unwrap().to_owned());
    names.collect()
}

#[test]
fn what_is_compound_opens() {
    let mut client = Client::launched(TEXT);
    client.body("next", json!({"threadId": 1}));
    let internal = scope(&mut client, "Internal");
    expect![[r#"
        lines = ARRAY[1..2] OF Motor
          [1] = speed=50.0 running=FALSE
            speed = 50.0
            running = FALSE
            delay = Q=FALSE ET=T#0s
              Q = FALSE
              ET = T#0s
              IN = FALSE
              PT = T#0s
          [2] = speed=50.0 running=FALSE
            speed = 50.0
            running = FALSE
            delay = Q=FALSE ET=T#0s
              Q = FALSE
              ET = T#0s
              IN = TRUE
              PT = T#5s
        step = FILLING
        grid = ARRAY[1..2, 0..1] OF INT
          [1, 0] = 0
          [1, 1] = 0
          [2, 0] = 0
          [2, 1] = 0
        m1 = EN=TRUE ENO=TRUE start=TRUE
          EN = TRUE
          ENO = TRUE
          start = TRUE
          inner = EN=TRUE ENO=TRUE a=TRUE
            EN = TRUE
            ENO = TRUE
            a = TRUE
            n = 1
          own = speed=50.0 running=TRUE
            speed = 50.0
            running = TRUE
            delay = Q=FALSE ET=T#0s
              Q = FALSE
              ET = T#0s
              IN = FALSE
              PT = T#0s
          $Inner#1 = $Inner
            EN = TRUE
            ENO = TRUE
            a = TRUE
            n = 1
    "#]]
    .assert_eq(&internal);
    let blocks = scope(&mut client, "Blocks");
    expect![[r#"
        $Motor#1 = $Motor
          EN = TRUE
          ENO = TRUE
          start = TRUE
          inner = $Inner
            EN = TRUE
            ENO = TRUE
            a = TRUE
            n = 1
          own = Motor
            speed = 50.0
            running = TRUE
            delay = Q=FALSE ET=T#0s
              Q = FALSE
              ET = T#0s
              IN = FALSE
              PT = T#0s
          $Inner#1 = $Inner
            EN = TRUE
            ENO = TRUE
            a = TRUE
            n = 1
    "#]]
    .assert_eq(&blocks);
}

#[test]
fn frames_and_expressions_go_by_the_names_of_states() {
    let mut client = Client::launched(TEXT);
    let line = 1 + TEXT.lines().position(|line| line.contains("[ADD]( n")).unwrap();
    let source = json!({"path": client.program()});
    client.body(
        "setBreakpoints",
        json!({"source": source, "breakpoints": [{"line": line}]}),
    );
    let mut seen = String::new();
    for _ in 0..4 {
        client.ask("continue", json!({"threadId": 1}));
        let frames = frames(&mut client);
        let value = client.evaluate("n", "watch");
        seen.push_str(&format!("{}; n is {value}\n", frames.join(" < ")));
    }
    expect![[r#"
        $Inner  m1.inner, rung in line 18 < $Motor  m1, rung in line 23 < main, rung in line 25; n is 0
        m1.$Inner#1, rung in line 18 < $Motor  m1, rung in line 23 < main, rung in line 25; n is 0
        $Inner  $Motor#1.inner, rung in line 18 < $Motor#1, rung in line 23 < main, rung in line 25; n is 0
        $Motor#1.$Inner#1, rung in line 18 < $Motor#1, rung in line 23 < main, rung in line 25; n is 0
    "#]]
    .assert_eq(&seen);
    let values = [
        "m1",
        "m1.inner",
        "m1.own",
        "m1.inner.n",
        "lines",
        "lines[2]",
        "lines[2].delay",
        "grid[2, 1]",
        "step",
        "$Motor#1.own",
        "$Motor#1.own.speed",
        "m1.$Inner#1",
    ];
    let mut shown = String::new();
    for name in values {
        shown.push_str(&format!("{name}: {}\n", client.evaluate(name, "watch")));
    }
    expect![[r#"
        m1: EN=TRUE ENO=TRUE start=TRUE
        m1.inner: EN=TRUE ENO=TRUE a=TRUE
        m1.own: speed=50.0 running=TRUE
        m1.inner.n: 1
        lines: ARRAY[1..2] OF Motor
        lines[2]: speed=50.0 running=FALSE
        lines[2].delay: Q=FALSE ET=T#0s
        grid[2, 1]: 0
        step: FILLING
        $Motor#1.own: Motor
        $Motor#1.own.speed: 50.0
        m1.$Inner#1: $Inner
    "#]]
    .assert_eq(&shown);
    let set = json!({"expression": "lines[1].speed", "value": "12.5", "frameId": 1});
    assert_eq!(
        client.body("setExpression", set)["value"],
        "50.0 → 12.5 after this scan"
    );
    let forced = client.evaluate("force step := idle", "repl");
    assert_eq!(forced, "FILLING → IDLE after this scan");
}

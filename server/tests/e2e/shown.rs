//! A client that says what it shows: states cost what is seen, and come as fast as it keeps up.

use std::fmt::Write;

use serde_json::{Value, json};

use crate::client::{Client, URI, span};

const SEEN: &str = "ladder/simulationShown";
const STATE: &str = "ladder/simulationState";

const MOTOR: &str = "\
+--\\--[ ]( start )--\\--[/]( stop )--( )( run )--+
|  /--[ ]( run )----/                            |

+--[ ]( run )--[TON]( warm, 20ms )--( )( lamp )--+
";

/// A client with a session of this program, of which it shows these lines and tags; the session, and the first state.
async fn shown(program: &str, lines: [u32; 2], tags: Value) -> (Client, String, Value) {
    let mut client = Client::new().await;
    client.open(program).await;
    let show = json!({"lines": [{"first": lines[0], "last": lines[1]}], "tags": tags});
    let start = json!({"uri": URI, "options": {"show": show}});
    let answer = client.simulate("start", start).await.unwrap();
    let session = answer["session"].as_str().unwrap().to_owned();
    (client, session, answer["state"].clone())
}

fn names(state: &Value) -> Vec<&str> {
    let tags = state["tags"].as_array().unwrap().iter();
    tags.map(|tag| tag["name"].as_str().unwrap()).collect()
}

fn lines(list: &Value) -> Vec<u64> {
    let mut lines: Vec<u64> = list
        .as_array()
        .unwrap()
        .iter()
        .map(|it| it["range"]["start"]["line"].as_u64().unwrap())
        .collect();
    lines.dedup();
    lines
}

#[tokio::test]
async fn only_what_is_shown_is_reported() {
    let (mut client, s, first) = shown(MOTOR, [0, 1], json!(["lamp", "nobody"])).await;
    assert_eq!(names(&first), ["lamp", "start", "stop", "run"]);
    assert_eq!(
        (lines(&first["power"]), lines(&first["operands"])),
        (vec![0, 1], vec![0, 1])
    );
    assert_eq!(first["operands"].as_array().unwrap().len(), 4);
    assert_eq!(
        first["operands"][0],
        json!({"range": span([0, 11, 0, 16]), "block": span([0, 6, 0, 18]), "tags": ["start"], "drawn": true})
    );

    // Where no rung joins it, a rail is sent as an element without power.
    let rail = json!({"range": span([1, 0, 1, 1]), "on": false});
    assert!(first["power"].as_array().unwrap().contains(&rail), "{first}");

    // The answer says what has been done; what it has changed comes once, with the notification.
    let set = json!({"session": s, "tag": "start", "value": true});
    let answer = client.simulate("set", set).await.unwrap();
    assert_eq!(
        (&answer["commands"], &answer["tags"], &answer["power"]),
        (&json!(1), &json!([]), &json!([]))
    );
    let state = client.notification(STATE, |_| true).await;
    assert_eq!(
        (&state["commands"], names(&state), &state["delta"]),
        (&json!(1), vec!["start"], &json!(true))
    );
    assert_eq!(state.get("operands"), None);

    // Other lines: what is known is not sent again.
    client.notify(SEEN, json!({"session": s})).await;
    let show = json!({"session": s, "lines": [{"first": 1, "last": 3}], "tags": []});
    client.simulate("show", show).await.unwrap();
    let state = client.notification(STATE, |_| true).await;
    assert_eq!(names(&state), ["warm.ET", "warm.Q"], "the lamp is known");
    assert_eq!(
        (lines(&state["power"]), lines(&state["operands"])),
        (vec![3], vec![3])
    );
    let timer = &state["operands"][1];
    assert_eq!(
        (&timer["tags"], timer.get("drawn")),
        (&json!(["warm.ET", "warm.Q"]), None)
    );
    client.finish().await;
}

#[tokio::test]
async fn lines_that_are_shown_twice_are_reported_once() {
    // The text shows the first two, a diagram next to it the last two.
    let mut client = Client::new().await;
    client.open(MOTOR).await;
    let show = json!({"lines": [{"first": 0, "last": 1}, {"first": 1, "last": 3}]});
    let start = json!({"uri": URI, "options": {"show": show}});
    let state = client.simulate("start", start).await.unwrap()["state"].clone();
    let operands = state["operands"].as_array().unwrap().iter();
    let operands: Vec<&Value> = operands.map(|operand| &operand["tags"][0]).collect();
    assert_eq!(
        operands,
        ["start", "stop", "run", "run", "run", "warm.ET", "lamp"]
    );
    client.finish().await;
}

#[tokio::test]
async fn the_next_state_comes_when_the_client_has_shown_the_one_before() {
    let (mut client, s, _) = shown(MOTOR, [0, 3], json!([])).await;
    let run = json!({"session": s, "realTime": false});
    client.simulate("run", run).await.unwrap();
    client.notification(STATE, |_| true).await;
    // The program goes on, and many answers come, but no state.
    let mut scans = 0;
    for _ in 0..20 {
        let state = client.simulate("state", json!({"session": s})).await.unwrap();
        scans = state["scan"].as_u64().unwrap();
    }
    assert_eq!(client.arrived(STATE), Vec::<Value>::new());
    client.simulate("pause", json!({"session": s})).await.unwrap();
    client.notify(SEEN, json!({"session": s})).await;
    let state = client.notification(STATE, |_| true).await;
    assert_eq!(state["status"], "paused", "the newest, not the next");
    assert!(state["scan"].as_u64().unwrap() >= scans);
    client.finish().await;
}

#[tokio::test]
async fn contacts_say_what_they_do() {
    let program = "\
VAR  n : DINT := 3;  END_VAR
+--[ ]( a )--[/]( b )--[LT]( n, 5 )--[P]( c )--( )( y )--+
";
    let (mut client, s, first) = shown(program, [1, 1], json!([])).await;
    let contacts = |state: &Value| -> Vec<String> {
        let power = state["power"].as_array().unwrap().iter();
        power
            .filter_map(|it| it["contact"].as_str().map(str::to_owned))
            .collect()
    };
    assert_eq!(contacts(&first), ["open", "closed", "closed", "open"]);
    client.simulate("step", json!({"session": s})).await.unwrap();
    let state = client.notification(STATE, |_| true).await;
    assert_eq!(
        contacts(&state),
        ["blocks"],
        "the first; the others stay as they were"
    );
    client.notify(SEEN, json!({"session": s})).await;
    for (tag, value) in [("a", true), ("b", true)] {
        let set = json!({"session": s, "tag": tag, "value": value});
        client.simulate("set", set).await.unwrap();
    }
    client.simulate("step", json!({"session": s})).await.unwrap();
    let mut state = client.notification(STATE, |_| true).await;
    while state["commands"] != 4 {
        client.notify(SEEN, json!({"session": s})).await;
        state = client.notification(STATE, |_| true).await;
    }
    assert_eq!(contacts(&state).last().unwrap(), "blocks");
    client.finish().await;
}

/// A person who toggles a tag of a paused program sees its contacts move, and not only with the next scan.
#[tokio::test]
async fn a_toggle_while_paused_moves_the_contact_at_once() {
    let (mut client, s, _) = shown(MOTOR, [0, 0], json!([])).await;
    client.simulate("step", json!({"session": s})).await.unwrap();
    let contact_of_start = |state: &Value| {
        let mut power = state["power"].as_array().unwrap().iter();
        let start = power.find(|it| it["range"] == span([0, 6, 0, 18]))?;
        Some((start["contact"].as_str()?.to_owned(), start["on"].as_bool()?))
    };
    let set = |value: bool| json!({"session": s, "tag": "start", "value": value});
    for (given, contact) in [(None, "blocks"), (Some(true), "closed"), (Some(false), "blocks")] {
        if let Some(given) = given {
            client.notify(SEEN, json!({"session": s})).await;
            client.simulate("set", set(given)).await.unwrap();
        }
        let state = client.notification(STATE, |_| true).await;
        assert_eq!(contact_of_start(&state), Some((contact.into(), false)), "{state}");
    }
}

#[tokio::test]
async fn ten_thousand_rungs_cost_what_is_shown() {
    let mut program = String::new();
    for rung in 0..10_000 {
        let _ = writeln!(program, "+--[ ]( a{rung} )--[/]( b{rung} )--( )( c{rung} )--+");
    }
    let (mut client, s, first) = shown(&program, [5000, 5049], json!([])).await;
    assert_eq!(
        (names(&first).len(), first["power"].as_array().unwrap().len()),
        (150, 450)
    );
    let set = json!({"session": s, "tag": "a5007", "value": true});
    client.simulate("set", set).await.unwrap();
    client.notify(SEEN, json!({"session": s})).await;
    client.simulate("step", json!({"session": s})).await.unwrap();
    let mut named = Vec::new();
    for commands in [1, 2] {
        let state = client.notification(STATE, |it| it["commands"] == commands).await;
        named.extend(names(&state).into_iter().map(str::to_owned));
    }
    assert_eq!(named, ["a5007", "c5007"]);

    let search = json!({"session": s, "containing": "C500", "first": 1, "count": 2});
    let found = client.simulate("tags", search).await.unwrap();
    assert_eq!(
        (&found["count"], names(&found)),
        (&json!(11), vec!["c5000", "c5001"])
    );
    client.finish().await;
}

#[tokio::test]
async fn a_hover_tells_the_value() {
    let program = format!("{MOTOR}VAR warm : TON; END_VAR\n");
    let (mut client, s, _) = shown(&program, [0, 3], json!([])).await;
    for command in ["set", "force"] {
        let tag = if command == "set" { "start" } else { "run" };
        let argument = json!({"session": s, "tag": tag, "value": true});
        client.simulate(command, argument).await.unwrap();
    }
    client
        .simulate("step", json!({"session": s, "scans": 2}))
        .await
        .unwrap();
    let mut hover = async |line: u32, character: u32| {
        let place = json!({"textDocument": {"uri": URI}, "position": {"line": line, "character": character}});
        let hover = client.request("textDocument/hover", place).await.unwrap();
        let text = hover["contents"]["value"].as_str().unwrap().to_owned();
        text.lines().next().unwrap().to_owned()
    };
    assert_eq!(hover(1, 12).await, "`run` is **1**, forced");
    assert_eq!(hover(3, 23).await, "`warm.ET` is **T#10ms**; `warm.Q` is **0**");
    // The declaration has the same ones.
    assert_eq!(hover(4, 5).await, "`warm.ET` is **T#10ms**; `warm.Q` is **0**");
    client.finish().await;
}

#[tokio::test]
async fn constants_are_read_only_and_runs_have_a_speed() {
    let program = "VAR CONSTANT  FIVE : DINT := 5;  END_VAR\n+--[EQ]( n, FIVE )--( )( y )--+\n";
    let (mut client, s, first) = shown(program, [0, 1], json!([])).await;
    let read_only = |name: &str| {
        let mut tags = first["tags"].as_array().unwrap().iter();
        tags.find(|tag| tag["name"] == name).unwrap()["readOnly"] == true
    };
    assert_eq!((read_only("FIVE"), read_only("n")), (true, false));
    for (run, refusal) in [
        (json!({"session": s, "speed": 0}), "from 0.001 to 1000"),
        (json!({"session": s, "speed": 2, "realTime": false}), "no speed"),
    ] {
        let (code, message) = client.simulate("run", run).await.unwrap_err();
        assert_eq!(code, -32602);
        assert!(message.contains(refusal), "{message}");
    }
    let run = json!({"session": s, "scans": 30, "speed": 100});
    client.simulate("run", run).await.unwrap();
    loop {
        client.notify(SEEN, json!({"session": s})).await;
        let state = client.notification(STATE, |_| true).await;
        if state["scan"] == 30 && state["status"] == "paused" {
            break;
        }
    }
    client.finish().await;
}

#[tokio::test]
async fn values_come_with_their_places() {
    let program = "\
+--[TON]( t, 5s )--[ADD]( n, n, 1 )--( )( y )--+

+--[ ]( y )--[MOV]( m, 3 )--+
# after #
";
    let (mut client, s, first) = shown(program, [0, 3], json!([])).await;
    let label = |tag: &str, at: [u32; 2], side: &str, column: u32| {
        let at = json!({"line": at[0], "character": at[1]});
        json!({"tag": tag, "at": at, "side": side, "column": column})
    };
    let apart = |tag: &str, at: [u32; 2], column: u32, after: u32| {
        let mut label = label(tag, at, "between", column);
        label["after"] = after.into();
        label
    };
    // The first line has none above; the drawing tells what contacts and coils hold.
    let at_first = [
        label("t.ET", [0, 10], "below", 10),
        label("n", [0, 26], "below", 26),
        apart("n", [0, 29], 29, 50),
        label("m", [2, 20], "above", 20),
    ];
    assert_eq!(first["labels"], json!(at_first), "{:#}", first["labels"]);

    // A value that has room changes alone.
    let set = json!({"session": s, "tag": "m", "value": 12345});
    client.simulate("set", set).await.unwrap();
    let state = client.notification(STATE, |_| true).await;
    assert_eq!(
        (&state["tags"][0]["text"], state.get("labels")),
        (&json!("12345"), None)
    );

    // One that outgrows it moves, and so does what it is in the way of.
    client.notify(SEEN, json!({"session": s})).await;
    let set = json!({"session": s, "tag": "t.ET", "value": 123_456_789});
    client.simulate("set", set).await.unwrap();
    let state = client.notification(STATE, |_| true).await;
    assert_eq!(state["tags"][0]["text"], "1d10h17m36.789s");
    let outgrown = [
        label("t.ET", [0, 10], "below", 10),
        label("n", [0, 26], "below", 26),
        apart("n", [0, 29], 29, 50),
        label("m", [2, 20], "below", 20),
    ];
    assert_eq!(state["labels"], json!(outgrown), "{:#}", state["labels"]);

    // What is forced shows its value everywhere.
    client.notify(SEEN, json!({"session": s})).await;
    let force = json!({"session": s, "tag": "y", "value": true});
    client.simulate("force", force).await.unwrap();
    let state = client.notification(STATE, |_| true).await;
    let labels = state["labels"].as_array().unwrap();
    let of_y: Vec<_> = labels.iter().filter(|label| label["tag"] == "y").collect();
    let forced = [label("y", [0, 42], "below", 42), apart("y", [2, 8], 8, 31)];
    assert_eq!(json!(of_y), json!(forced), "{:#}", state["labels"]);

    // What is not shown any more has no labels.
    client.notify(SEEN, json!({"session": s})).await;
    let show = json!({"session": s, "lines": [{"first": 2, "last": 3}]});
    client.simulate("show", show).await.unwrap();
    let state = client.notification(STATE, |_| true).await;
    let labels = state["labels"].as_array().unwrap().iter();
    let tags: Vec<_> = labels.map(|label| label["tag"].clone()).collect();
    assert_eq!(tags, ["y", "m"]);
    client.finish().await;
}

/// Two pumps in a loop.
const PUMPS: &str = "\
VAR_INPUT trip : ARRAY[1..2] OF BOOL; run : BOOL; END_VAR
VAR_OUTPUT pump : ARRAY[1..2] OF BOOL; END_VAR
VAR i : INT; starts : ARRAY[1..2] OF INT; END_VAR
+--[MOV]( i, 0 )--<FOR>( 2 )--+

+--[ADD]( i, i, 1 )--+
+--[ ]( run )--[/]( trip[i] )--( )( pump[i] )--[ADD]( starts[i], starts[i], 1 )--+
+--<NEXT>--+
";

/// Values are after what is declared, with a name where the line has several; a constant and an array have none.
#[tokio::test]
async fn values_are_next_to_declarations() {
    let program = "\
VAR
    a, b : BOOL;
    n : INT; # a count #
    t : TON;
    many : ARRAY[1..2] OF INT;
END_VAR
VAR CONSTANT
    MOST : INT := 3;
END_VAR
+--[ ]( a )--[TON]( t, T#5s )--[MOV]( n, MOST )--( )( b )--+
";
    let (mut client, s, first) = shown(program, [0, 9], json!([])).await;
    let declared = |tag: &str, at: [u32; 2], column: u32| {
        let at = json!({"line": at[0], "character": at[1]});
        json!({"tag": tag, "at": at, "side": "after", "column": column})
    };
    let told = |mut label: Value, before: &str| {
        label["index"] = before.into();
        label
    };
    let labels = first["labels"].as_array().unwrap().iter();
    let after: Vec<&Value> = labels.filter(|label| label["side"] == "after").collect();
    assert_eq!(
        json!(after),
        json!([
            told(declared("a", [1, 4], 18), "a="),
            told(declared("b", [1, 7], 23), "b="),
            declared("n", [2, 4], 26),
            told(declared("t.ET", [3, 4], 14), "ET="),
        ]),
    );
    // What is commanded at the cursor there is about that tag.
    let operands = first["operands"].as_array().unwrap().iter();
    let of_line = operands.filter(|operand| operand["block"]["start"]["line"] == 1);
    let tags: Vec<&Value> = of_line.map(|operand| &operand["tags"]).collect();
    assert_eq!(json!(tags), json!([["a"], ["b"]]));
    client.simulate("stop", json!({"session": s})).await.unwrap();
}

/// The labels on a line of the text, as a person reads them.
fn labels(state: &Value, line: u64) -> String {
    let labels = state["labels"].as_array().unwrap().iter();
    let of_line = labels.filter(|label| label["at"]["line"] == line);
    let shown = of_line.map(|label| {
        let index = label.get("index").and_then(Value::as_str).unwrap_or_default();
        format!("{} {index}", label["tag"].as_str().unwrap())
    });
    shown.collect::<Vec<_>>().join(", ")
}

#[tokio::test]
async fn an_operand_says_which_element_it_is() {
    let (mut client, s, first) = shown(PUMPS, [0, 8], json!([])).await;
    // Before the loop there is none.
    assert_eq!(labels(&first, 6), "");
    let mut seen = Vec::new();
    for _ in 0..9 {
        client.simulate("stepRung", json!({"session": s})).await.unwrap();
        let state = client.notification(STATE, |_| true).await;
        client.notify(SEEN, json!({"session": s})).await;
        if state.get("labels").is_some() {
            seen.push(labels(&state, 6));
        }
        if let Some(operands) = state.get("operands") {
            let of_line: Vec<&Value> = operands
                .as_array()
                .unwrap()
                .iter()
                .map(|it| &it["tags"][0])
                .collect();
            seen.push(format!("{of_line:?}"));
        }
    }
    expect_test::expect![[r#"
        [
            "trip[1] [1]=, pump[1] [1]=, starts[1] [1]=, starts[1] [1]=",
            "[String(\"run\"), String(\"trip[1]\"), String(\"pump[1]\"), String(\"starts[1]\"), String(\"starts[1]\")]",
            "trip[2] [2]=, pump[2] [2]=, starts[2] [2]=, starts[2] [2]=",
            "[String(\"run\"), String(\"trip[2]\"), String(\"pump[2]\"), String(\"starts[2]\"), String(\"starts[2]\")]",
        ]
    "#]].assert_debug_eq(&seen);
    // What is on the line can be found, and forced, by what it is now.
    let hover = client.hover(6, 23).await.unwrap().to_string();
    assert!(hover.contains("trip[2]"), "{hover}");
    client.finish().await;
}

#[tokio::test]
async fn an_array_is_listed_as_one_that_opens_or_by_its_elements() {
    let (mut client, s, _) = shown(PUMPS, [0, 0], json!([])).await;
    let listed = async |client: &mut Client, mut search: Value| {
        search["session"] = json!(s);
        client.simulate("tags", search).await.unwrap()
    };
    let top = listed(&mut client, json!({"of": ""})).await;
    assert_eq!(names(&top), ["trip", "run", "pump", "i", "starts"]);
    assert_eq!(
        top["tags"][0],
        json!({
            "name": "trip", "type": "ARRAY[1..2] OF BOOL", "value": "", "text": "", "role": "input", "forced": false,
            "parts": 2
        })
    );
    let parts = listed(&mut client, json!({"of": "Trip"})).await;
    assert_eq!(names(&parts), ["trip[1]", "trip[2]"]);
    assert_eq!(parts["tags"][0]["value"], json!(false));
    let found = listed(&mut client, json!({"containing": "P[2"})).await;
    assert_eq!(names(&found), ["trip[2]", "pump[2]"]);
    let found = listed(&mut client, json!({"of": "", "containing": "pump[2]"})).await;
    assert_eq!(names(&found), ["pump"]);
    let wanted = json!({"names": ["pump[2]", "gone", "TRIP", "run"]});
    let found = listed(&mut client, wanted).await;
    assert_eq!(names(&found), ["pump[2]", "trip", "run"]);
    let force = json!({"session": s, "tag": "pump[2]", "value": true});
    client.simulate("force", force).await.unwrap();
    let top = listed(&mut client, json!({"of": "", "containing": "pump"})).await;
    assert_eq!(top["tags"][0]["forced"], json!(true));
    client.finish().await;
}

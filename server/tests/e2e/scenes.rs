//! Scenes over the protocol: what is wrong in one, where its names lead, and the values of a simulation in it.

use serde_json::{Value, json};

use crate::client::{Client, span};
use crate::features::edited;
use crate::plant::Plant;

const PROGRAM: &str = "VAR_INPUT start : BOOL; END_VAR\nVAR_OUTPUT run : BOOL; END_VAR\n+--[ ]( start )--[ ]( full )--( )( run )--+\n";
const MACHINE: &str = "VAR_INPUT run : BOOL; END_VAR\nVAR_OUTPUT full : BOOL; END_VAR\nVAR level : INT; END_VAR\n\
                       +--[LT]( level, 100 )--( )( full )--+\n+--[ ]( run )--[ADD]( level, level, 1 )--+\n";

/// A scene: a line for each element from the fourth on.
fn scene(root: &str, elements: &str) -> String {
    format!(
        "<svg xmlns='http://www.w3.org/2000/svg' xmlns:l='https://ladder.example/scene' {root}>\n<title>t</title>\n<desc>d</desc>\n{elements}\n</svg>\n"
    )
}

async fn open(client: &mut Client, uri: &str, language: &str, text: &str) {
    let document = json!({"uri": uri, "languageId": language, "version": 1, "text": text});
    client
        .notify("textDocument/didOpen", json!({"textDocument": document}))
        .await;
}

async fn ask(client: &mut Client, what: &str, uri: &str, at: (u32, u32), more: Value) -> Value {
    let mut params = json!({"textDocument": {"uri": uri}, "position": {"line": at.0, "character": at.1}});
    params
        .as_object_mut()
        .unwrap()
        .extend(more.as_object().unwrap().clone());
    client
        .request(&format!("textDocument/{what}"), params)
        .await
        .unwrap()
}

async fn execute(client: &mut Client, command: &str, argument: Value) -> Value {
    let params = json!({"command": command, "arguments": [argument]});
    client.request("workspace/executeCommand", params).await.unwrap()
}

/// The edits of one file.
fn edits_of(edit: &Value, uri: &str) -> Value {
    let changes = edit["documentChanges"].as_array().unwrap();
    let of = changes.iter().find(|it| it["textDocument"]["uri"] == uri);
    of.unwrap_or_else(|| panic!("{uri} in {edit}"))["edits"].clone()
}

#[tokio::test]
async fn what_is_wrong_is_shown_at_its_place() {
    let plant = Plant::with(&[("main.clad", PROGRAM), ("tank.clad", MACHINE)]);
    let mut client = Client::new().await;
    let uri = plant.uri("main.scene.svg");
    let text = scene(
        "l:plant='tank.clad'",
        "<g l:show='nobody'/>\n<g l:move-x='plant.level &gt; 5'/>\n<script>x</script>\n<rect l:fill='plant.level &gt; 5: red; blue'/>",
    );
    open(&mut client, &uri, "svg", &text).await;
    let found = client
        .notification("textDocument/publishDiagnostics", |it| it["uri"] == *uri)
        .await;
    let shown: Vec<String> = found["diagnostics"]
        .as_array()
        .unwrap()
        .iter()
        .map(|it| {
            let start = &it["range"]["start"];
            let message = it["message"].as_str().unwrap().lines().next().unwrap().to_owned();
            format!(
                "{}:{} {} {}: {message}",
                start["line"], start["character"], it["severity"], it["code"]
            )
        })
        .collect();
    assert_eq!(
        shown,
        [
            "3:11 1 \"bad-scene\": there is no tag `nobody` in this program",
            "4:13 1 \"bad-scene\": a number is wanted here, and this is of type BOOL",
            "5:0 2 \"bad-scene\": `script` is left out, with what is in it",
            "6:14 3 \"bad-scene\": l:fill tells its state by a colour alone",
        ]
    );
}

#[tokio::test]
async fn names_lead_to_the_program_and_its_plant_and_back() {
    let elements = "<g l:show='run and plant.level &gt; 5' l:press='start'/>";
    let text = scene("l:program='main.clad' l:plant='tank.clad as plant'", elements);
    let plant = Plant::with(&[
        ("main.clad", PROGRAM),
        ("tank.clad", MACHINE),
        ("pump.scene.svg", &text),
    ]);
    let mut client = Client::new().await;
    let uri = plant.uri("pump.scene.svg");
    open(&mut client, &uri, "svg", &text).await;

    let found = ask(&mut client, "definition", &uri, (3, 12), json!({})).await;
    assert_eq!(found[0]["uri"], plant.uri("main.clad"));
    assert_eq!(found[0]["range"], span([1, 11, 1, 14]));
    let found = ask(&mut client, "definition", &uri, (3, 27), json!({})).await;
    assert_eq!(found[0]["uri"], plant.uri("tank.clad"));
    assert_eq!(found[0]["range"], span([2, 4, 2, 9]));
    let hover = ask(&mut client, "hover", &uri, (3, 12), json!({})).await;
    assert!(
        hover["contents"]["value"]
            .as_str()
            .unwrap()
            .contains("run : BOOL"),
        "{hover}"
    );
    let hover = ask(&mut client, "hover", &uri, (3, 5), json!({})).await;
    assert!(
        hover["contents"]["value"]
            .as_str()
            .unwrap()
            .contains("shown while"),
        "{hover}"
    );

    // From the scene, and from the program of which the scene is not asked about.
    for (asked, at) in [(uri.clone(), (3, 12)), (plant.uri("main.clad"), (1, 12))] {
        if asked != uri {
            open(&mut client, &asked, "clad", PROGRAM).await;
        }
        let renamed = ask(&mut client, "rename", &asked, at, json!({"newName": "runs"})).await;
        let changed = edited(&text, &edits_of(&renamed, &uri));
        assert!(
            changed.contains("l:show='runs and plant.level &gt; 5'"),
            "{changed}"
        );
        let changed = edited(PROGRAM, &edits_of(&renamed, &plant.uri("main.clad")));
        assert!(changed.contains("( )( runs )"), "{changed}");
    }
    let renamed = ask(&mut client, "rename", &uri, (3, 27), json!({"newName": "height"})).await;
    let changed = edited(&text, &edits_of(&renamed, &uri));
    assert!(
        changed.contains("l:show='run and plant.height &gt; 5'"),
        "{changed}"
    );
    let changed = edited(MACHINE, &edits_of(&renamed, &plant.uri("tank.clad")));
    assert!(changed.contains("height : INT"), "{changed}");
}

#[tokio::test]
async fn tags_and_attributes_are_proposed() {
    let plant = Plant::with(&[("main.clad", PROGRAM)]);
    let mut client = Client::new().await;
    let uri = plant.uri("main.scene.svg");
    let text = scene(
        "",
        "<g l:show='r'/>\n<g l:fill='run: v'/>\n<g l: />\n<g l:alt='r'/>",
    );
    open(&mut client, &uri, "svg", &text).await;
    let mut labels = Vec::new();
    for at in [(3, 12), (4, 17), (5, 5), (6, 11)] {
        let found = ask(&mut client, "completion", &uri, at, json!({})).await;
        let items = found["items"].as_array().unwrap();
        let first = items
            .iter()
            .take(2)
            .map(|item| item["label"].as_str().unwrap().to_owned());
        labels.push(first.collect::<Vec<_>>());
    }
    assert!(labels[0].iter().any(|it| it == "run"), "{labels:?}");
    assert_eq!(labels[1][..2], ["var(--ladder-on)", "var(--ladder-off)"]);
    assert_eq!(labels[2][..2], ["l:show", "l:fill"]);
    assert!(labels[3].is_empty(), "{labels:?}");
}

#[tokio::test]
async fn a_scene_shows_what_is_simulated() {
    let text = scene(
        "",
        "<rect l:move-x='plant.level' l:toggle='start'/>\n<g l:set='plant.level := 0'/>",
    );
    let plant = Plant::with(&[
        ("main.clad", PROGRAM),
        ("tank.clad", MACHINE),
        ("main.scene.svg", &text),
        ("ladder.toml", "[simulate]\nplant = \"tank.clad\"\n"),
    ]);
    let mut client = Client::new().await;
    let (uri, program) = (plant.uri("main.scene.svg"), plant.uri("main.clad"));
    let rest = execute(&mut client, "ladder.scene", json!({"uri": uri})).await;
    assert_eq!(rest["program"], program);
    assert_eq!(rest["nodes"][0]["name"], "svg");
    let uses: Vec<&str> = rest["slots"]
        .as_array()
        .unwrap()
        .iter()
        .map(|it| it["use"].as_str().unwrap())
        .collect();
    assert_eq!(uses, ["row", "transform", "aria-checked", "row", "given", "row"]);
    assert_eq!(
        rest["acts"][1],
        json!({"node": rest["acts"][1]["node"], "kind": "set", "tag": "plant.level"})
    );

    open(&mut client, &program, "clad", PROGRAM).await;
    let options = json!({"show": {"lines": [], "tags": []}});
    let started = execute(
        &mut client,
        "ladder.simulate.start",
        json!({"uri": program, "options": options}),
    )
    .await;
    let session = started["session"].clone();
    let shown = execute(
        &mut client,
        "ladder.scene",
        json!({"uri": uri, "session": session}),
    )
    .await;
    let transform = uses.iter().position(|it| *it == "transform").unwrap();
    assert_eq!(shown["values"][transform], "");
    execute(
        &mut client,
        "ladder.simulate.set",
        json!({"session": session, "tag": "start", "value": true}),
    )
    .await;
    client
        .notify("ladder/simulationShown", json!({"session": session}))
        .await;
    execute(
        &mut client,
        "ladder.simulate.step",
        json!({"session": session, "scans": 4}),
    )
    .await;
    let mut values = Vec::new();
    // A state may come between the two.
    let state = loop {
        let state = client.notification("ladder/simulationState", |_| true).await;
        let scenes = state["scenes"].as_array().cloned().unwrap_or_default();
        values.extend(
            scenes
                .iter()
                .flat_map(|scene| scene["values"].as_array().unwrap().clone()),
        );
        client
            .notify("ladder/simulationShown", json!({"session": session}))
            .await;
        if state["scan"] == 4 {
            break state;
        }
    };
    assert_eq!(state["scenes"][0]["uri"], uri);
    let last = values.iter().rfind(|it| it[0] == transform);
    assert_eq!(last.unwrap()[1], "translate(3 0)", "{values:?}");

    // Another program has other tags: the scene is to be asked for again.
    let change = json!({
        "textDocument": {"uri": program, "version": 2},
        "contentChanges": [{"text": PROGRAM.replace("[ ]( full )", "[/]( full )")}],
    });
    client.notify("textDocument/didChange", change).await;
    let is_told = |state: &Value| state["scenes"][0]["again"] == true;
    client.notification("ladder/simulationState", is_told).await;
    let shown = execute(
        &mut client,
        "ladder.scene",
        json!({"uri": uri, "session": session}),
    )
    .await;
    assert_eq!(shown["values"][transform], "translate(3 0)");

    let outside = json!({"command": "ladder.scene", "arguments": [{"uri": program}]});
    let (_, message) = client
        .request("workspace/executeCommand", outside)
        .await
        .unwrap_err();
    assert!(message.contains("is not a scene"), "{message}");
}

/// What a scene names outside of its workspace is not read.
#[tokio::test]
async fn nothing_outside_is_read() {
    let text = scene("l:program='../outside.clad'", "<g l:show='secret'/>");
    let plant = Plant::with(&[
        ("outside.clad", "+--( )( secret )--+\n"),
        ("work/ladder.toml", ""),
        ("work/main.scene.svg", &text),
    ]);
    let mut client = Client::new().await;
    let uri = plant.uri("work/main.scene.svg");
    open(&mut client, &uri, "svg", &text).await;
    let found = client
        .notification("textDocument/publishDiagnostics", |it| it["uri"] == *uri)
        .await;
    let message = found["diagnostics"][0]["message"].as_str().unwrap();
    assert!(message.contains("outside"), "{message}");
    let rest = execute(&mut client, "ladder.scene", json!({"uri": uri})).await;
    assert_eq!(rest["program"], Value::Null);
    assert_eq!(rest["slots"], json!([]));
}

#[tokio::test]
async fn the_plants_of_the_settings_are_known_in_a_scene() {
    let text = scene("l:program='main.clad'", "<g l:move-x='tank.level'/>");
    let plant = Plant::with(&[
        ("main.clad", PROGRAM),
        ("tank.clad", MACHINE),
        ("ladder.toml", "[simulate]\nplant = \"tank.clad as tank\"\n"),
        ("main.scene.svg", &text),
    ]);
    let mut client = Client::new().await;
    let uri = plant.uri("main.scene.svg");
    open(&mut client, &uri, "svg", &text).await;
    let found = ask(&mut client, "definition", &uri, (3, 18), json!({})).await;
    assert_eq!(found[0]["uri"], plant.uri("tank.clad"), "{found}");
    let found = ask(&mut client, "completion", &uri, (3, 14), json!({})).await;
    assert!(found.to_string().contains("\"tank.level\""), "{found}");
}

//! Properties that are proved in an editor: answers, findings, lenses and actions.

use serde_json::{Value, json};

use crate::client::{Answer, Client, span};
use crate::features::edited;
use crate::plant::Plant;

const PROGRAM: &str = "VAR_INPUT go_up, go_down : BOOL; END_VAR\nVAR_OUTPUT up, down : BOOL; END_VAR\n\
    +--[ ]( go_up )----[/]( down )--( )( up )--+\n+--[ ]( go_down )--[/]( up )----( )( down )--+\n";
const PROPERTIES: &str = "program door.clad\ninterval 10ms\nstep 100ms\n\nproperty \"not both\"\nnever up and down\n\n\
    property \"it goes\"\nalways up or not go_up\n\nscenario \"up\"\ngo_up _-\nup => _-\n";

fn able() -> Value {
    json!({
        "workspace": {"workspaceEdit": {"documentChanges": true, "resourceOperations": ["create"]}},
        "experimental": {"commands": ["ladder.prove"]}
    })
}

async fn opened(files: &[(&str, &str)]) -> (Client, Plant, String) {
    let plant = Plant::with(files);
    let mut client = Client::with(able()).await;
    let uri = plant.uri("door.ladder-test");
    if let Some((_, text)) = files.iter().find(|(name, _)| name.ends_with(".ladder-test")) {
        let document = json!({"uri": uri, "languageId": "ladder-test", "version": 1, "text": text});
        client
            .notify("textDocument/didOpen", json!({"textDocument": document}))
            .await;
    }
    (client, plant, uri)
}

async fn prove(client: &mut Client, argument: Value) -> Answer {
    let ask = json!({"command": "ladder.proveProperties", "arguments": [argument]});
    client.request("workspace/executeCommand", ask).await
}

/// The next diagnostics of the file that are as wanted.
async fn published(client: &mut Client, uri: &str, wanted: impl Fn(&[Value]) -> bool) -> Vec<Value> {
    let fits = |it: &Value| it["uri"] == *uri && wanted(it["diagnostics"].as_array().unwrap());
    let told = client.notification("textDocument/publishDiagnostics", fits).await;
    told["diagnostics"].as_array().unwrap().clone()
}

async fn change(client: &mut Client, uri: &str, version: i32, text: &str) {
    let params =
        json!({"textDocument": {"uri": uri, "version": version}, "contentChanges": [{"text": text}]});
    client.notify("textDocument/didChange", params).await;
}

async fn actions(client: &mut Client, uri: &str, at: [u32; 4]) -> Vec<Value> {
    let params = json!({"textDocument": {"uri": uri}, "range": span(at), "context": {"diagnostics": [], "only": ["quickfix"]}});
    let found = client.request("textDocument/codeAction", params).await.unwrap();
    found.as_array().cloned().unwrap_or_default()
}

#[tokio::test]
async fn a_violated_property_is_a_finding_until_a_text_changes() {
    let (mut client, plant, uri) = opened(&[("door.clad", PROGRAM), ("door.ladder-test", PROPERTIES)]).await;
    let answer = prove(&mut client, json!({"uri": uri})).await.unwrap();
    let [proved, violated] = answer["properties"].as_array().unwrap().as_slice() else {
        panic!("{answer}");
    };
    assert_eq!(
        (&proved["name"], &proved["verdict"], &proved["message"]),
        (
            &json!("not both"),
            &json!("proved"),
            &json!("proved for any times")
        )
    );
    assert_eq!(violated["verdict"], "violated");
    assert_eq!(violated["range"], span([7, 9, 7, 18]));
    assert!(violated["scan"].as_u64().is_some(), "{violated}");
    let run = violated["scenario"].as_str().unwrap();
    assert!(
        run.starts_with("program door.clad\ninterval 10ms\n\nscenario \"it goes is violated\"\n"),
        "{run}"
    );
    let is_there = |found: &[Value]| found.iter().any(|it| it["code"] == "property-violated");
    let found = published(&mut client, &uri, is_there).await;
    let [found] = found.as_slice() else {
        panic!("{found:?}")
    };
    assert_eq!(found["range"], span([7, 9, 7, 18]));
    let message = found["message"].as_str().unwrap();
    assert!(
        message.starts_with("\"it goes\" is violated in scan ") && message.contains("go_up "),
        "{message}"
    );

    // The program says something else now, and then what it reported before.
    let program = plant.uri("door.clad");
    client.open_as(&program, 1, PROGRAM).await;
    let params = json!({"textDocument": {"uri": program, "version": 2}, "contentChanges": [{"text": PROGRAM.replace("[/]( down )", "[ ]( go_up )")}]});
    client.notify("textDocument/didChange", params).await;
    published(&mut client, &uri, <[Value]>::is_empty).await;
    let answer = prove(&mut client, json!({"uri": uri, "name": "it goes"}))
        .await
        .unwrap();
    let properties = answer["properties"].as_array().unwrap();
    assert_eq!(
        (properties.len(), &properties[0]["verdict"]),
        (1, &json!("proved"))
    );
    client.finish().await;
}

#[tokio::test]
async fn a_changed_file_of_properties_forgets_what_was_found() {
    let (mut client, _plant, uri) = opened(&[("door.clad", PROGRAM), ("door.ladder-test", PROPERTIES)]).await;
    prove(&mut client, json!({"uri": uri})).await.unwrap();
    published(&mut client, &uri, |found| !found.is_empty()).await;
    change(
        &mut client,
        &uri,
        2,
        &PROPERTIES.replace("always up", "always  up"),
    )
    .await;
    published(&mut client, &uri, <[Value]>::is_empty).await;
    change(&mut client, &uri, 3, &PROPERTIES.replace("up or", "nothing or")).await;
    let refused = prove(&mut client, json!({"uri": uri})).await.unwrap_err().1;
    assert!(refused.starts_with("line 9: "), "{refused}");
    let refused = prove(&mut client, json!({"uri": uri.replace("door", "gone")}))
        .await
        .unwrap_err()
        .1;
    assert!(refused.ends_with("is no file of scenarios"), "{refused}");
    client.finish().await;
}

#[tokio::test]
async fn a_file_that_is_not_open_is_proved_as_it_is_on_disk() {
    let (mut client, plant, _) = opened(&[("door.clad", PROGRAM)]).await;
    plant.write("door.ladder-test", PROPERTIES);
    let ask = json!({"uri": plant.uri("door.ladder-test"), "name": "not both"});
    let answer = prove(&mut client, ask).await.unwrap();
    assert_eq!(answer["properties"][0]["verdict"], "proved");
    assert_eq!(answer.get("version"), None);
    client.finish().await;
}

#[tokio::test]
async fn each_property_has_a_lens() {
    let (mut client, _plant, uri) = opened(&[("door.clad", PROGRAM), ("door.ladder-test", PROPERTIES)]).await;
    let params = json!({"textDocument": {"uri": uri}});
    let lenses = client.request("textDocument/codeLens", params).await.unwrap();
    let shown: Vec<_> = lenses
        .as_array()
        .unwrap()
        .iter()
        .map(|lens| {
            json!([
                lens["range"]["start"]["line"],
                lens["command"]["title"],
                lens["command"]["arguments"]
            ])
        })
        .collect();
    assert_eq!(
        json!(shown),
        json!([
            [0, "Prove all", [uri]],
            [4, "Prove", [uri, "not both"]],
            [7, "Prove", [uri, "it goes"]]
        ])
    );
    client.finish().await;
}

#[tokio::test]
async fn a_counterexample_becomes_a_scenario() {
    let (mut client, _plant, uri) = opened(&[("door.clad", PROGRAM), ("door.ladder-test", PROPERTIES)]).await;
    assert_eq!(
        actions(&mut client, &uri, [7, 0, 7, 0]).await,
        [] as [Value; 0],
        "nothing is known yet"
    );
    prove(&mut client, json!({"uri": uri})).await.unwrap();
    assert_eq!(
        actions(&mut client, &uri, [4, 0, 4, 0]).await,
        [] as [Value; 0],
        "it is proved"
    );
    let found = actions(&mut client, &uri, [8, 0, 8, 0]).await;
    let [action] = found.as_slice() else {
        panic!("{found:?}")
    };
    assert_eq!(action["title"], "Write the counterexample as a scenario");
    assert_eq!(action["diagnostics"][0]["code"], "property-violated");
    let text = edited(PROPERTIES, &action["edit"]["documentChanges"][0]["edits"]);
    assert!(
        text.contains("\n\nscenario \"it goes is violated\"\ntime "),
        "{text}"
    );
    assert!(text.contains("up => ") && text.contains(" 10ms"), "{text}");
    change(&mut client, &uri, 2, &text).await;
    let ask = json!({"command": "ladder.runScenarios", "arguments": [{"uri": uri}]});
    let run = client.request("workspace/executeCommand", ask).await.unwrap();
    let passed: Vec<_> = run["scenarios"]
        .as_array()
        .unwrap()
        .iter()
        .map(|it| &it["passed"])
        .collect();
    // Its rows are as they came, and the property of the file is violated in it: until the program is corrected.
    assert_eq!(passed, [true, false], "{text}");
    let scenario = &run["scenarios"][1];
    assert_eq!(scenario["differences"], json!([]), "{scenario}");
    assert_eq!(scenario["violations"][0]["name"], "it goes", "{scenario}");
    client.finish().await;
}

#[tokio::test]
async fn outputs_that_lock_each_other_propose_a_property() {
    let (mut client, plant, _) = opened(&[("door.clad", PROGRAM)]).await;
    let program = plant.uri("door.clad");
    client.open_as(&program, 1, PROGRAM).await;
    let proposed = |found: Vec<Value>| {
        found
            .into_iter()
            .find(|it| it["title"] == "Add the property: never up and down")
    };
    let action = proposed(actions(&mut client, &program, [2, 38, 2, 38]).await).expect("on a coil");
    let uri = plant.uri("door.ladder-test");
    let changes = &action["edit"]["documentChanges"];
    assert_eq!(changes[0], json!({"kind": "create", "uri": uri}));
    let made = edited("", &changes[1]["edits"]);
    assert_eq!(
        made,
        "program door.clad\n\nproperty \"not both up and down\"\nnever up and down\n"
    );
    assert!(
        proposed(actions(&mut client, &program, [2, 8, 2, 8]).await).is_none(),
        "on another tag"
    );

    // In a file that is there it goes above the scenarios, and not twice.
    plant.write(
        "door.ladder-test",
        "program door.clad\n\n# how it goes up\nscenario \"up\"\ngo_up -\nup => -\n",
    );
    let text = std::fs::read_to_string(plant.folder.path().join("door.ladder-test")).unwrap();
    let action = proposed(actions(&mut client, &program, [2, 38, 2, 38]).await).unwrap();
    let text = edited(&text, &action["edit"]["documentChanges"][0]["edits"]);
    assert_eq!(
        text,
        "program door.clad\n\nproperty \"not both up and down\"\nnever up and down\n\n# how it goes up\nscenario \"up\"\ngo_up -\nup => -\n"
    );
    plant.write("door.ladder-test", &text);
    assert!(
        proposed(actions(&mut client, &program, [2, 38, 2, 38]).await).is_none(),
        "it is there"
    );
    let short = "program door.clad\n";
    let document = json!({"uri": uri, "languageId": "ladder-test", "version": 4, "text": short});
    client
        .notify("textDocument/didOpen", json!({"textDocument": document}))
        .await;
    let action =
        proposed(actions(&mut client, &uri, [0, 0, 0, 0]).await).expect("next to the program's name");
    assert_eq!(
        edited(short, &action["edit"]["documentChanges"][0]["edits"]),
        "program door.clad\n\nproperty \"not both up and down\"\nnever up and down\n"
    );
    client.finish().await;
}

/// Whether a number has divisors takes the prover as long as it may.
const HARD: &str = "VAR_INPUT x, y : LINT; END_VAR\nVAR p : LINT; END_VAR\nVAR_OUTPUT found : BOOL; END_VAR\n\
    +--[MUL]( p, x, y )--+\n\
    +--[EQ]( p, 1000036000099 )--[GT]( x, 1 )--[GT]( y, 1 )--[LT]( x, 2000000 )--[LT]( y, 2000000 )--( )( found )--+\n";
const HARD_PROPERTIES: &str =
    "program door.clad\n\nproperty \"prime\"\nnever found\n\nproperty \"easy\"\nalways x = x\n";

/// Asks for a proof that takes long; it is under way when this returns.
async fn hard_proof(client: &mut Client, uri: &str) -> i64 {
    let ask = json!({"command": "ladder.proveProperties", "arguments": [{"uri": uri, "name": "prime"}]});
    client.ask("workspace/executeCommand", ask).await
}

#[tokio::test]
async fn a_proof_that_is_cancelled_leaves_its_turn_to_the_next() {
    let (mut client, _plant, uri) =
        opened(&[("door.clad", HARD), ("door.ladder-test", HARD_PROPERTIES)]).await;
    let proof = hard_proof(&mut client, &uri).await;
    // Another one waits its turn, and is given up there.
    let waiting = hard_proof(&mut client, &uri).await;
    client.notify("$/cancelRequest", json!({"id": waiting})).await;
    assert_eq!(client.answer(waiting).await.unwrap_err().0, -32800);
    client.notify("$/cancelRequest", json!({"id": proof})).await;
    assert_eq!(client.answer(proof).await.unwrap_err().0, -32800);
    let easy = prove(&mut client, json!({"uri": uri, "name": "easy"}))
        .await
        .unwrap();
    assert_eq!(easy["properties"][0]["verdict"], "proved");
    client.finish().await;
}

#[tokio::test]
async fn typing_goes_on_while_a_proof_runs_and_overtakes_it() {
    let (mut client, plant, uri) =
        opened(&[("door.clad", HARD), ("door.ladder-test", HARD_PROPERTIES)]).await;
    let program = plant.uri("door.clad");
    client.open_as(&program, 1, HARD).await;
    let at = |uri: &str, line: u32| json!({"textDocument": {"uri": uri}, "position": {"line": line, "character": 6}});
    // What is typed into another file ends no proof, and is answered while it runs.
    let other = plant.uri("other.clad");
    client.open_as(&other, 1, PROGRAM).await;
    let proof = hard_proof(&mut client, &uri).await;
    for version in 2..20 {
        change(&mut client, &other, version, &format!("{PROGRAM}# {version} #\n")).await;
        client.request("textDocument/hover", at(&other, 2)).await.unwrap();
        client
            .request("textDocument/completion", at(&other, 2))
            .await
            .unwrap();
    }
    // Into the program, or into the properties.
    change(&mut client, &program, 2, &format!("{HARD}# more #\n")).await;
    assert_eq!(client.answer(proof).await.unwrap_err().0, -32801);
    let proof = hard_proof(&mut client, &uri).await;
    client
        .request("textDocument/hover", at(&program, 3))
        .await
        .unwrap();
    change(&mut client, &uri, 2, &format!("{HARD_PROPERTIES}# more\n")).await;
    assert_eq!(client.answer(proof).await.unwrap_err().0, -32801);
    client.finish().await;
}

//! The file that keeps retentive tags is written, and free for the next run, when a simulation is over.

use std::fs;

use ladder_server::Ending;
use serde_json::{Value, json};

use crate::client::Client;
use crate::plant::Plant;

const KEEPS: &str = "VAR RETAIN n : INT; END_VAR\n+--[ADD]( n, n, 1 )--+\n";
const SETTINGS: (&str, &str) = ("ladder.toml", "[simulate]\nretain = \"plant.retain\"\n");

fn kept(plant: &Plant) -> String {
    fs::read_to_string(plant.folder.path().join("plant.retain")).unwrap()
}

#[tokio::test]
async fn two_simulations_do_not_share_a_file() {
    let plant = Plant::with(&[SETTINGS, ("a.clad", KEEPS), ("b.clad", KEEPS)]);
    let mut client = Client::new().await;
    let mut sessions = Vec::new();
    for name in ["a.clad", "b.clad"] {
        let uri = plant.uri(name);
        client.open_as(&uri, 1, KEEPS).await;
        let answer = client.simulate("start", json!({"uri": uri})).await.unwrap();
        let note = answer["notes"][0].as_str().unwrap_or_default();
        assert_eq!(
            note.contains("another run uses this file"),
            name == "b.clad",
            "{note}"
        );
        sessions.push(answer["session"].clone());
    }
    for (session, scans) in sessions.iter().zip([3, 5]) {
        let step = json!({"session": session, "scans": scans});
        client.simulate("step", step).await.unwrap();
    }
    for session in &sessions {
        client
            .simulate("stop", json!({"session": session}))
            .await
            .unwrap();
    }
    // Who has the answer to `stop` may start again, here or in another process.
    assert_eq!(plant.names(), ["a.clad", "b.clad", "ladder.toml", "plant.retain"]);
    let kept = kept(&plant);
    assert!(
        kept.contains("program a.clad\n") && kept.contains("n\tINT\t3\n"),
        "{kept}"
    );
    client.finish().await;
}

/// A client with a simulation of a program that keeps a tag, three scans on.
async fn three_scans(plant: &Plant) -> Client {
    let mut client = Client::new().await;
    let uri = plant.uri("a.clad");
    client.open_as(&uri, 1, KEEPS).await;
    let answer = client.simulate("start", json!({"uri": uri})).await.unwrap();
    let step = json!({"session": answer["session"], "scans": 3});
    client.simulate("step", step).await.unwrap();
    client
}

#[tokio::test]
async fn what_runs_at_shutdown_is_saved_first() {
    let plant = Plant::with(&[SETTINGS, ("a.clad", KEEPS)]);
    let mut client = three_scans(&plant).await;
    client.request("shutdown", Value::Null).await.unwrap();
    assert_eq!(plant.names(), ["a.clad", "ladder.toml", "plant.retain"]);
    assert!(kept(&plant).contains("n\tINT\t3\n"), "{}", kept(&plant));
    client.notify("exit", Value::Null).await;
    assert_eq!(client.ended().await, Ending::Clean);
}

#[tokio::test]
async fn what_runs_at_an_abrupt_end_is_saved_first() {
    let plant = Plant::with(&[SETTINGS, ("a.clad", KEEPS)]);
    let mut client = three_scans(&plant).await;
    client.notify("exit", Value::Null).await;
    assert_eq!(client.ended().await, Ending::Abrupt);
    assert_eq!(plant.names(), ["a.clad", "ladder.toml", "plant.retain"]);
    assert!(kept(&plant).contains("n\tINT\t3\n"), "{}", kept(&plant));
}

//! The trace of chosen tags, and going to a scan of it.

use serde_json::{Value, json};

use crate::client::{Client, URI};

const PROGRAM: &str = "\
+--[ ]( start )--[TON]( warm, 40ms )--( )( hot )--+
+--[ADD]( n, 1, n )--+
";

async fn started() -> (Client, String) {
    let mut client = Client::new().await;
    client.open(PROGRAM).await;
    let argument = json!({"uri": URI, "options": {"inputs": {"start": true}}});
    let answer = client.simulate("start", argument).await.unwrap();
    let session = answer["session"].as_str().unwrap().to_owned();
    (client, session)
}

async fn step(client: &mut Client, session: &str, scans: u64) {
    let argument = json!({"session": session, "scans": scans});
    client.simulate("step", argument).await.unwrap();
}

async fn trace(client: &mut Client, session: &str, mut argument: Value) -> Value {
    argument["session"] = json!(session);
    client.simulate("trace", argument).await.unwrap()
}

#[tokio::test]
async fn what_is_drawn_of_tags() {
    let (mut client, s) = started().await;
    step(&mut client, &s, 8).await;
    let tags = json!({"tags": ["hot", "WARM.ET", "nobody"], "cursors": [2, 7]});
    let traced = trace(&mut client, &s, tags).await;
    assert_eq!(
        (&traced["first"], &traced["last"], &traced["per"], &traced["here"]),
        (&json!(1), &json!(8), &json!(1), &json!(8))
    );
    assert_eq!(
        traced["cursors"],
        json!({"times": ["20ms", "70ms"], "difference": "+50ms"})
    );
    let [hot, warm, nobody] = [0, 1, 2].map(|tag| &traced["tags"][tag]);
    assert_eq!(
        (&hot["kind"], &hot["columns"], &hot["readings"]),
        (&json!("bit"), &json!([[1, 0], [5, 1]]), &json!(["0", "1"]))
    );
    assert_eq!(
        (&warm["name"], &warm["range"], &warm["difference"], &warm["now"]),
        (
            &json!("warm.ET"),
            &json!([0, 40]),
            &json!("+30ms"),
            &json!("40ms")
        )
    );
    assert_eq!(
        warm["columns"],
        json!([
            [1, 0, 0, 0],
            [2, 10, 10, 10],
            [3, 20, 20, 20],
            [4, 30, 30, 30],
            [5, 40, 40, 40]
        ])
    );
    assert_eq!(nobody, &json!({"name": "nobody", "kind": "unknown"}));
    client.finish().await;
}

#[tokio::test]
async fn only_what_is_new_is_sent() {
    let (mut client, s) = started().await;
    step(&mut client, &s, 100).await;
    let tags = json!({"tags": ["n"], "span": 50, "columns": 10});
    let whole = trace(&mut client, &s, tags).await;
    assert_eq!(
        (&whole["first"], &whole["per"], &whole["tags"][0]["columns"][0]),
        (&json!(51), &json!(5), &json!([10, 50, 54, 54]))
    );
    step(&mut client, &s, 3).await;
    let tags = json!({"tags": ["n"], "span": 50, "columns": 10, "since": whole["newest"]});
    let fresh = trace(&mut client, &s, tags).await;
    assert_eq!(fresh["revision"], whole["revision"]);
    assert_eq!(fresh["tags"][0]["columns"], json!([[20, 100, 103, 103]]));
    client.finish().await;
}

#[tokio::test]
async fn a_click_in_the_past_and_another_future() {
    let (mut client, s) = started().await;
    step(&mut client, &s, 9).await;
    let before = trace(&mut client, &s, json!({"tags": ["n", "hot"]})).await;
    let state = client.simulate("goTo", json!({"session": s, "scan": 3})).await;
    let state = state.unwrap();
    assert_eq!(
        (&state["scan"], &state["behind"], &state["ahead"]),
        (&json!(3), &json!(3), &json!(6))
    );
    let there = trace(&mut client, &s, json!({"tags": ["n", "hot"]})).await;
    assert_eq!(
        (
            &there["here"],
            &there["newest"],
            &there["reach"],
            &there["revision"]
        ),
        (
            &json!(3),
            &json!(9),
            &json!({"first": 0, "last": 9}),
            &before["revision"]
        )
    );
    assert_eq!(there["tags"][0]["columns"], before["tags"][0]["columns"]);
    assert_eq!(there["tags"][0]["now"], "3");
    // Forward again.
    let state = client.simulate("goTo", json!({"session": s, "scan": 8})).await;
    assert_eq!(state.unwrap()["ahead"], 1);
    let refused = client.simulate("goTo", json!({"session": s, "scan": 10})).await;
    assert_eq!(
        refused.unwrap_err().1,
        "scan 10 is not kept; one can go to the scans from 0 to 9"
    );
    let set = json!({"session": s, "tag": "start", "value": false});
    client.simulate("set", set).await.unwrap();
    let other = trace(&mut client, &s, json!({"tags": ["n", "hot"]})).await;
    assert_eq!(other["newest"], 8);
    assert_ne!(other["revision"], before["revision"]);
    client.finish().await;
}

#[tokio::test]
async fn what_makes_no_sense_is_refused() {
    let (mut client, s) = started().await;
    for (argument, message) in [
        (
            json!({"tags": ["n"], "columns": 0}),
            "columns is 0; it must be from 1 to 10000",
        ),
        (
            json!({"tags": ["n"], "cursors": [1, 2, 3]}),
            "a trace has two cursors at most",
        ),
        (
            json!({"tags": vec!["n"; 65]}),
            "65 tags are too many for a trace; choose up to 64",
        ),
    ] {
        let mut argument = argument;
        argument["session"] = json!(s);
        let refused = client.simulate("trace", argument).await;
        assert_eq!(refused.unwrap_err().1, message);
    }
    // Before the first scan nothing is known, and far away nothing is drawn.
    let nothing = trace(&mut client, &s, json!({"tags": ["n"]})).await;
    assert_eq!(nothing["tags"][0].get("columns"), None);
    step(&mut client, &s, 2).await;
    let far = trace(
        &mut client,
        &s,
        json!({"tags": ["n"], "last": u64::MAX, "span": 10}),
    )
    .await;
    assert_eq!(far["tags"][0].get("columns"), None);
    client.finish().await;
}

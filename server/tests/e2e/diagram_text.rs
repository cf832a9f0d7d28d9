//! The diagram drawn with characters, at rest and live.

use expect_test::{Expect, expect};
use serde_json::{Value, json};

use crate::client::{Client, URI, span};

const MOTOR: &str = "\
# Runs the motor #
+--\\--[ ]( start )--\\--[/]( stop )--( )( run )--+
|  /--[ ]( run )----/                            |

+--[ ]( run )--[TON]( warm, 20ms )--( )( lamp )--+
";

async fn drawn(client: &mut Client, session: Option<&str>, lines: [u32; 2]) -> Value {
    let lines = json!({"first": lines[0], "last": lines[1]});
    let mut argument = json!({"uri": URI, "lines": lines, "rail": 46});
    if let Some(session) = session {
        argument["session"] = json!(session);
    }
    let params = json!({"command": "ladder.diagramText", "arguments": [argument]});
    client.request("workspace/executeCommand", params).await.unwrap()
}

fn check(drawn: &Value, shown: Expect) {
    let lines = drawn["drawn"].as_array().unwrap().iter();
    let lines = lines.map(|it| format!("{} {}", it["line"], it["text"].as_str().unwrap()));
    let lines: Vec<String> = lines.map(|it| it.trim_end().to_owned()).collect();
    shown.assert_eq(&lines.join("\n"));
}

#[tokio::test]
async fn a_program_at_rest_and_running() {
    let mut client = Client::new().await;
    client.open(MOTOR).await;
    let rest = drawn(&mut client, None, [0, 9]).await;
    check(
        &rest,
        expect![[r#"
        0 Runs the motor
        1
        1 │     start     stop                    run   │
        1 ├──┬──┤   ├──┬──┤ / ├──────────────────(   )──┤
        2 │  │   run   │                                │
        2 │  └──┤   ├──┘                                │
        4
        4 │                             warm            │
        4 │   run                     ┌─ TON ─┐  lamp   │
        4 ├──┤   ├────────────────────┤IN    Q├──(   )──┤
        4 │                           │PT 20ms│         │
        4 │                           └───────┘         │"#]],
    );
    let answer = client
        .simulate(
            "start",
            json!({"uri": URI, "options": {"inputs": {"start": true}}}),
        )
        .await;
    let session = answer.unwrap()["session"].as_str().unwrap().to_owned();
    client
        .simulate("step", json!({"session": session, "scans": 2}))
        .await
        .unwrap();
    client
        .simulate(
            "force",
            json!({"session": session, "tag": "stop", "value": false}),
        )
        .await
        .unwrap();
    let live = drawn(&mut client, Some(&session), [0, 9]).await;
    check(
        &live,
        expect![[r#"
        0 Runs the motor
        1
        1 │     start     stop!                   run   │
        1 ┝━━┳━━┥━━━┝━━┳━━┥━/━┝━━━━━━━━━━━━━━━━━━(━━━)━━┥
        2 │  ┃   run   ┃                                │
        2 │  ┗━━┥━━━┝━━┛                                │
        4
        4 │                             10ms            │
        4 │                             warm            │
        4 │   run                     ┌─ TON ─┐  lamp   │
        4 ┝━━┥━━━┝━━━━━━━━━━━━━━━━━━━━┥IN    Q├──(   )──┤
        4 │                           │PT 20ms│         │
        4 │                           └───────┘         │"#]],
    );
    let blocks = live["blocks"].as_array().unwrap();
    let timer = blocks.iter().find(|block| block["tags"][0] == "warm.ET").unwrap();
    assert_eq!(
        timer,
        &json!({
            "range": span([4, 15, 4, 34]),
            "lines": [7, 13],
            "columns": [28, 37],
            "tags": ["warm.ET", "warm.Q"]
        })
    );
    let marks = live["drawn"][2]["marks"].as_array().unwrap();
    assert!(marks.contains(&json!([16, 21, "forced"])), "{marks:?}");
    // Only what is asked for, but whole networks.
    check(
        &drawn(&mut client, Some(&session), [2, 2]).await,
        expect![[r#"
            1 │     start     stop!                   run   │
            1 ┝━━┳━━┥━━━┝━━┳━━┥━/━┝━━━━━━━━━━━━━━━━━━(━━━)━━┥
            2 │  ┃   run   ┃                                │
            2 │  ┗━━┥━━━┝━━┛                                │"#]],
    );
    client.finish().await;
}

#[tokio::test]
async fn while_the_text_has_errors_what_is_the_same_is_shown() {
    let mut client = Client::new().await;
    client.open(MOTOR).await;
    let answer = client.simulate("start", json!({"uri": URI, "options": {}})).await;
    let session = answer.unwrap()["session"].as_str().unwrap().to_owned();
    let broken = MOTOR.replace("# Runs", "\n# Runs");
    client
        .replace(2, &broken.replace("[TON]( warm, 20ms )", "[TON]( warm, "))
        .await;
    check(
        &drawn(&mut client, Some(&session), [0, 9]).await,
        expect![[r#"
            1 Runs the motor
            2
            2 │     start     stop                    run   │
            2 ├──┬──┤   ├──┬──┤─/─├──────────────────(   )──┤
            3 │  │   run   │                                │
            3 │  └──┤   ├──┘                                │"#]],
    );
    client.finish().await;
}

#[tokio::test]
async fn what_is_not_there_is_refused() {
    let mut client = Client::new().await;
    client.open(MOTOR).await;
    let far = drawn(&mut client, None, [900, 4_000_000_000]).await;
    assert_eq!(far["drawn"], json!([]));
    let argument = json!({"uri": URI, "lines": {"first": 0, "last": 1}, "session": "s9"});
    let params = json!({"command": "ladder.diagramText", "arguments": [argument]});
    let refused = client.request("workspace/executeCommand", params).await;
    assert_eq!(
        refused.unwrap_err().1,
        "there is no simulation s9; it was stopped, or never started"
    );
    client.finish().await;
}

//! A storm of simulation commands, as no editor sends them: each is answered, and in time.
//!
//! `LADDER_STORM=100000 LADDER_STORM_SEED=7 cargo test -p ladder-server --test e2e storm` sends more of them, or others.

use std::time::{Duration, Instant};

use serde_json::{Value, json};
use tokio::time::timeout;

use crate::client::{Client, URI};

/// The longest time that an answer may take, on a machine that is busy with other tests too.
const LONGEST: Duration = Duration::from_secs(15);

const INTERNAL_ERROR: i64 = -32603;

/// So many requests wait for their answers at most.
const WINDOW: usize = 12;

const PROGRAMS: [&str; 3] = [
    "+--[ ]( go )--( )( run )--+\n",
    "\
VAR_INPUT  go : BOOL;  END_VAR
VAR RETAIN  n : DINT;  END_VAR
VAR  t : TON;  note : STRING;  a : ARRAY[1..9] OF DINT;  END_VAR
+--[ ]( go )--[ADD]( n, n, 1 )--[TON]( t, 50ms )--( )( run )--+
+--[CALC]( n, n MOD 9 + 1 )--[MOV]( a[n], n )--+
",
    "\
VAR  n : DINT;  a : ARRAY[1..9] OF DINT;  END_VAR
+--<FOR>( 20000 )--+
+--[ADD]( n, n, 1 )--+
+--<NEXT>( )--+
+--[ ]( go )--( )( run )--+
",
];

/// Numbers that look random, and are the same for the same seed.
struct Dice(u64);

impl Dice {
    fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    fn below(&mut self, end: u64) -> u64 {
        (self.next() >> 11) % end
    }

    /// Mostly a few, now and then any number.
    fn scans(&mut self) -> u64 {
        match self.below(10) {
            0 => self.next(),
            1 => self.next() >> 32,
            2 => self.below(5_000_000),
            _ => self.below(20),
        }
    }

    fn of<T: Copy>(&mut self, all: &[T]) -> T {
        all[self.below(all.len() as u64) as usize]
    }
}

/// A command and its argument.
fn command(dice: &mut Dice, session: &str) -> (&'static str, Value) {
    let command = dice.of(&[
        "step",
        "step",
        "stepBlock",
        "stepRung",
        "back",
        "goTo",
        "run",
        "speed",
        "pause",
        "set",
        "pulse",
        "force",
        "unforce",
        "breakpoints",
        "why",
        "history",
        "trace",
        "record",
        "state",
        "show",
        "tags",
        "reset",
        "warmRestart",
        "stop",
    ]);
    let mut argument = json!({"session": session});
    let tag = dice.of(&[
        "go", "run", "n", "t.ET", "note", "a[3]", "a[n]", "none", "", "SYS.SCAN",
    ]);
    let set = match command {
        "step" | "back" => vec![("scans", json!(dice.scans()))],
        "history" => vec![
            ("tags", json!([tag, "run", "go"])),
            ("scans", json!(dice.scans())),
        ],
        "goTo" => vec![("scan", json!(dice.scans()))],
        "run" if dice.below(2) == 0 => vec![("scans", json!(dice.scans())), ("realTime", json!(false))],
        "run" => vec![("speed", json!(dice.of(&[0.1, 1.0, 1000.0, 1e9])))],
        "speed" => vec![("realTime", json!(dice.below(2) == 0))],
        "set" | "force" => vec![
            ("tag", json!(tag)),
            (
                "value",
                serde_json::from_str(dice.of(&["true", "7", "\"x\"", "1e300"])).unwrap(),
            ),
        ],
        "pulse" | "why" => vec![("tag", json!(tag))],
        "breakpoints" if dice.below(4) == 0 => {
            vec![("lines", json!([dice.below(9)])), ("tags", json!([tag]))]
        }
        "trace" => vec![("tags", json!([tag, "run"])), ("last", json!(dice.scans()))],
        "record" => vec![("name", json!("a\u{2028}\"b"))],
        "show" => vec![
            ("lines", json!([{"first": 0, "last": dice.next() as u32}])),
            ("tags", json!([tag])),
        ],
        "tags" => vec![("containing", json!(tag)), ("first", json!(dice.scans()))],
        _ => Vec::new(),
    };
    for (name, value) in set {
        argument[name] = value;
    }
    (command, argument)
}

fn from_environment(name: &str) -> Option<u64> {
    std::env::var(name).ok()?.parse().ok()
}

/// A request that waits for its answer, and when it was sent.
struct Sent {
    id: i64,
    at: Instant,
    what: String,
}

async fn take_answer(client: &mut Client, sent: Sent) {
    let left = LONGEST.saturating_sub(sent.at.elapsed());
    let answer = timeout(left, client.answer(sent.id)).await;
    let Ok(answer) = answer else {
        panic!("no answer to {} after {LONGEST:?}", sent.what);
    };
    if let Err((code, message)) = answer {
        assert_ne!(code, INTERNAL_ERROR, "{}: {message}", sent.what);
        assert!(!message.contains("has stopped"), "{}: {message}", sent.what);
    }
}

async fn start(client: &mut Client) -> String {
    let started = client.simulate("start", json!({"uri": URI})).await.unwrap();
    started["session"].as_str().unwrap().to_owned()
}

#[tokio::test]
async fn every_command_of_a_storm_is_answered_in_time() {
    let count = from_environment("LADDER_STORM").unwrap_or(400);
    let mut dice = Dice(from_environment("LADDER_STORM_SEED").unwrap_or(77) | 1);
    let mut client = Client::new().await;
    client.open(PROGRAMS[0]).await;
    let mut session = start(&mut client).await;
    let mut waiting: Vec<Sent> = Vec::new();
    for number in 0..count {
        if number % 50 == 49 {
            client.replace(number as i32 + 2, dice.of(&PROGRAMS)).await;
        }
        let (command, argument) = command(&mut dice, &session);
        let what = format!("{command} {argument}");
        let params = json!({"command": format!("ladder.simulate.{command}"), "arguments": [argument]});
        let id = client.ask("workspace/executeCommand", params).await;
        let at = Instant::now();
        waiting.push(Sent { id, at, what });
        if dice.below(20) == 0 {
            let id = waiting[dice.below(waiting.len() as u64) as usize].id;
            client.notify("$/cancelRequest", json!({"id": id})).await;
        }
        if command == "stop" {
            session = start(&mut client).await;
        }
        while waiting.len() > WINDOW {
            take_answer(&mut client, waiting.remove(0)).await;
        }
    }
    for sent in waiting {
        take_answer(&mut client, sent).await;
    }
    client.finish().await;
}

#[tokio::test]
async fn a_step_that_would_never_end_gives_way_to_what_waits() {
    let mut client = Client::new().await;
    client.open(PROGRAMS[0]).await;
    let session = start(&mut client).await;
    let mut sent = Vec::new();
    for (command, scans) in [
        ("step", u64::MAX),
        ("record", 0),
        ("step", 1 << 40),
        ("state", 0),
        ("step", 3),
    ] {
        let mut argument = json!({"session": session});
        if scans > 0 {
            argument["scans"] = json!(scans);
        }
        let params = json!({"command": format!("ladder.simulate.{command}"), "arguments": [argument]});
        sent.push(client.ask("workspace/executeCommand", params).await);
    }
    let mut scans = Vec::new();
    for id in sent {
        let answer = timeout(LONGEST, client.answer(id))
            .await
            .expect("an answer in time");
        scans.push(answer.map(|it| it["scan"].as_u64()));
    }
    // Where each of them came to: the recording may have been given up, the last step is whole.
    let [
        Ok(Some(first)),
        _,
        Ok(Some(second)),
        Ok(Some(state)),
        Ok(Some(last)),
    ] = scans[..]
    else {
        panic!("{scans:?}");
    };
    assert!(0 < first && first < second && second == state, "{scans:?}");
    assert_eq!(last, state + 3);
    client.finish().await;
}

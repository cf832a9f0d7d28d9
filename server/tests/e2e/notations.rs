//! `ladder.convert` and `ladder.notations`.

use std::collections::BTreeSet;

use serde_json::{Value, json};

use crate::client::Client;
use crate::plant::Plant;

const RUNG: &str = "start open contact I0.1 & active coil Q0 end\n";

async fn command(client: &mut Client, command: &str, argument: Value) -> Result<Value, (i64, String)> {
    let params = json!({"command": command, "arguments": [argument]});
    client.request("workspace/executeCommand", params).await
}

#[tokio::test]
async fn a_file_on_disk_is_read_and_nothing_is_written() {
    let plant = Plant::with(&[("motor.rung", RUNG)]);
    let mut client = Client::new().await;
    let uri = plant.uri("motor.rung");
    let answer = command(&mut client, "ladder.convert", json!({"uri": uri}))
        .await
        .unwrap();
    assert_eq!(
        (&answer["from"], &answer["to"]),
        (&json!("textbook"), &json!("clad"))
    );
    assert_eq!(answer["translated"], 2);
    assert!(
        answer["text"].as_str().unwrap().contains("( )( Q0 )--+"),
        "{answer}"
    );
    // What the editor shows counts more than the disk.
    let argument = json!({"uri": uri, "text": RUNG.replace("Q0", "Q7")});
    let answer = command(&mut client, "ladder.convert", argument).await.unwrap();
    assert!(
        answer["text"].as_str().unwrap().contains("( )( Q7 )--+"),
        "{answer}"
    );
    let names = std::fs::read_dir(plant.folder.path()).unwrap();
    let names: BTreeSet<_> = names.map(|entry| entry.unwrap().file_name()).collect();
    assert!(
        names
            .iter()
            .all(|name| name == "motor.rung" || name == "ladder.toml"),
        "{names:?}"
    );
    client.finish().await;
}

#[tokio::test]
async fn an_open_program_is_exported() {
    let mut client = Client::new().await;
    client.open("+--[ ]( I0 )--( )( Q0 )--+\n").await;
    let argument = json!({"uri": crate::client::URI, "to": "textbook"});
    let answer = command(&mut client, "ladder.convert", argument).await.unwrap();
    assert_eq!(answer["extension"], "rung");
    assert!(answer["text"].as_str().unwrap().starts_with("start"), "{answer}");
    client.finish().await;
}

/// As on the command line: what the text that is made has errors in is refused.
#[tokio::test]
async fn a_result_with_errors_is_refused() {
    let text = "def main():\n    if dh[1] == \"ab\":\n        out(y.A)\n    if True:\n        end()\n";
    let plant = Plant::with(&[("compare.py", text)]);
    let mut client = Client::new().await;
    let argument = json!({"uri": plant.uri("compare.py")});
    let answer = command(&mut client, "ladder.convert", argument).await.unwrap();
    assert_eq!(
        (&answer["translated"], &answer["refused"]),
        (&json!(2), &json!(1)),
        "{answer}"
    );
    let remark = &answer["remarks"][0];
    assert_eq!(
        (&remark["outcome"], &remark["line"]),
        (&json!("refused"), &json!(2))
    );
    client.finish().await;
}

#[tokio::test]
async fn what_cannot_be_converted_is_reported() {
    let plant = Plant::with(&[
        ("motor.rung", "start open I0.1 end\n"),
        ("motor.clad", "+--( )( a )--+\n"),
    ]);
    let mut client = Client::new().await;
    for (argument, code, message) in [
        (
            json!({"uri": plant.uri("motor.rung")}),
            -32803,
            "motor.rung:1:7: `open` is followed by `contact`",
        ),
        (
            json!({"uri": plant.uri("motor.clad")}),
            -32803,
            "motor.clad: this is ladder text already; name the notation to write it in",
        ),
        (
            json!({"uri": "untitled:Untitled-1"}),
            -32803,
            "untitled:Untitled-1 is not a file; send its text",
        ),
        (
            json!({"uri": plant.uri("gone.ld")}),
            -32803,
            "gone.ld: no such file or folder",
        ),
        (
            json!({"uri": plant.uri("motor.clad"), "to": "fbd"}),
            -32602,
            "there is no notation fbd; there are clad, textbook,",
        ),
        (
            json!({"uri": "file:///a", "form": "ldmicro"}),
            -32602,
            "unknown field `form`",
        ),
    ] {
        let (found, told) = command(&mut client, "ladder.convert", argument)
            .await
            .unwrap_err();
        assert_eq!(found, code, "{told}");
        assert!(told.contains(message), "{told}");
    }
    client.finish().await;
}

#[tokio::test]
#[cfg(unix)]
async fn only_regular_files_of_the_folder_are_read() {
    let plant = Plant::with(&[("a.clad", "")]);
    let outside = tempfile::NamedTempFile::new().unwrap();
    std::fs::write(outside.path(), RUNG).unwrap();
    std::os::unix::fs::symlink(outside.path(), plant.folder.path().join("link.rung")).unwrap();
    let mut client = Client::new().await;
    for uri in [
        plant.uri("link.rung"),
        "file:///dev/stdin".to_owned(),
        "file:///dev/zero".to_owned(),
    ] {
        let refused = command(&mut client, "ladder.convert", json!({"uri": uri})).await;
        assert_eq!(refused.unwrap_err().0, -32803, "{uri}");
    }
    client.finish().await;
}

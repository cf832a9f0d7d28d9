//! What changed in an open program since an earlier text of it.

use serde_json::{Value, json};

use crate::client::{Answer, Client, URI};
use crate::plant::Plant;

const BASE: &str = "\
+--[ ]( a )--[ ]( b )--( )( x )--+

+--[ ]( a )--( )( y )--+

+--[ ]( c )--( )( z )--+

+--[ ]( c )--( )( w )--+
";

const NOW: &str = "\
# swapped #
+--[ ]( b )--[ ]( a )--( )( x )--+

+--[/]( a )--( )( y )--+

+--[ ]( c )--( )( w )--+

+--[ ]( d )--( )( v )--+
";

async fn asked(client: &mut Client, argument: Value) -> Answer {
    let params = json!({"command": "ladder.compare", "arguments": [argument]});
    client.request("workspace/executeCommand", params).await
}

fn told(change: &Value) -> String {
    let lines = |side: &str| match &change[side] {
        Value::Null => String::from("none"),
        lines => format!("{}-{}", lines["first"], lines["last"]),
    };
    let word = |name: &str| change[name].as_str().unwrap_or("-").to_owned();
    let (old, new) = (lines("old"), lines("new"));
    let moved = if change["moved"] == true { "moved " } else { "" };
    let line = &change["line"];
    format!(
        "{line}: {moved}{} {} {old} {new}",
        word("change"),
        word("meaning")
    )
}

#[tokio::test]
async fn each_network_is_said_with_its_lines_in_both() {
    let mut client = Client::new().await;
    client.open(NOW).await;
    let answer = asked(&mut client, json!({"uri": URI, "base": BASE}))
        .await
        .unwrap();
    assert_eq!((&answer["version"], answer.get("style")), (&json!(1), None));
    let changes = answer["changes"].as_array().unwrap();
    assert_eq!(
        changes.iter().map(told).collect::<Vec<_>>(),
        [
            "1: edited same 0-0 1-1",
            "3: edited other 2-2 3-3",
            "5: gone - 4-4 none",
            "7: new - none 7-7",
        ]
    );
    assert_eq!(
        changes[1]["reason"],
        "with a off, y goes off in the old and on in the new program"
    );
    assert_eq!(changes[1]["names"], json!(["y"]));
    client.finish().await;
}

#[tokio::test]
async fn blocks_of_other_files_are_followed() {
    let plant = Plant::with(&[(
        "blocks.clad",
        "FUNCTION_BLOCK [$Both]\nVAR_INPUT\n    one, other : BOOL;\nEND_VAR\n+--[ ]( one )--[ ]( other )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n",
    )]);
    let now = "+--[$Both]( b, a )--( )( x )--+\n\n+--[$Both]( a, c )--( )( y )--+\n";
    let base = "+--[$Both]( a, b )--( )( x )--+\n\n+--[$Both]( a, b )--( )( y )--+\n";
    plant.write("motor.clad", now);
    let uri = plant.uri("motor.clad");
    let mut client = Client::new().await;
    client.open_as(&uri, 1, now).await;
    let answer = asked(&mut client, json!({"uri": uri, "base": base}))
        .await
        .unwrap();
    let changes = answer["changes"].as_array().unwrap();
    assert_eq!(
        changes.iter().map(told).collect::<Vec<_>>(),
        ["0: edited same 0-0 0-0", "2: edited other 2-2 2-2"],
        "{changes:?}"
    );
    client.finish().await;
}

#[tokio::test]
async fn drawings_come_if_they_are_wanted() {
    let mut client = Client::new().await;
    client.open(NOW).await;
    let argument = json!({"uri": URI, "base": BASE, "drawings": "dark"});
    let answer = asked(&mut client, argument).await.unwrap();
    let style = answer["style"].as_str().unwrap();
    assert!(style.contains(".change") && style.contains(".line {"), "{style}");
    let drawing = answer["changes"][1]["drawing"].as_str().unwrap();
    assert_eq!(drawing.matches("<svg ").count(), 2, "{drawing}");
    assert!(!drawing.contains("<script"), "{drawing}");
    client.finish().await;
}

#[tokio::test]
async fn nothing_has_changed() {
    let mut client = Client::new().await;
    client.open(NOW).await;
    let base = NOW.replace('\n', "\r\n");
    let answer = asked(&mut client, json!({"uri": URI, "base": base}))
        .await
        .unwrap();
    assert_eq!(answer["changes"], json!([]));
    assert!(
        asked(&mut client, json!({"uri": "file:///none.clad", "base": ""}))
            .await
            .is_err()
    );
    client.finish().await;
}

/// Products in another order, in each of many networks: that they are the same takes long to decide.
fn products(each: impl Fn(usize) -> String) -> String {
    let rungs = (0..300).map(|n| format!("+--[CALC]( p{n}, {} )--+\n\n", each(n)));
    let names: Vec<String> = (0..300).map(|n| format!("p{n}")).collect();
    format!(
        "VAR_INPUT x, y : LINT; END_VAR\nVAR {} : LINT; END_VAR\n{}",
        names.join(", "),
        rungs.collect::<String>()
    )
}

#[tokio::test]
async fn a_comparison_is_cancelled_or_overtaken_while_typing_goes_on() {
    let mut client = Client::new().await;
    let base = products(|n| format!("x * (x * ({n} + y))"));
    client.open(&products(|n| format!("(y + {n}) * x * x"))).await;
    let ask = json!({"command": "ladder.compare", "arguments": [{"uri": URI, "base": base}]});
    let id = client.ask("workspace/executeCommand", ask.clone()).await;
    // Answered before it, or there would be nothing to cancel.
    client.hover(2, 10).await.unwrap();
    client.notify("$/cancelRequest", json!({"id": id})).await;
    assert_eq!(client.answer(id).await.unwrap_err().0, -32800);
    let id = client.ask("workspace/executeCommand", ask).await;
    client.change(2, &[([2, 0, 2, 0], "# more #\n")]).await;
    client.hover(3, 10).await.unwrap();
    assert_eq!(client.answer(id).await.unwrap_err().0, -32801);
    client.finish().await;
}

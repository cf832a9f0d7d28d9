//! What an editor waits for in a folder of many files: the first diagnostics, the places of a tag that all files use, and
//! its new name.
//!
//! Run with `cargo build --release -p ladder-cli --bins && cargo bench -p ladder-tests --bench workspace`. The number of files
//! may follow as an argument.

use ladder_tests::client::Server;
use serde_json::{Value, json};
use std::fmt::Write as _;
use std::path::Path;
use std::time::{Duration, Instant};

/// So long after the last answer the server has given back what it needed for it.
const SETTLED: Duration = Duration::from_secs(5);

/// How often each file names the global.
const USES: usize = 60;

/// A file of the folder: it reads the global in each of its rungs.
fn file(number: usize) -> String {
    let mut text = String::from("VAR_EXTERNAL\n    enable : BOOL;\nEND_VAR\nVAR_INPUT\n");
    let mut rungs = String::new();
    for n in 0..USES {
        let _ = writeln!(text, "    start_{number}_{n} : BOOL;");
        let _ = writeln!(
            rungs,
            "+--[ ]( enable )--[ ]( start_{number}_{n} )--( )( run_{number}_{n} )--+\n"
        );
    }
    text.push_str("END_VAR\nVAR_OUTPUT\n");
    for n in 0..USES {
        let _ = writeln!(text, "    run_{number}_{n} : BOOL;");
    }
    text.push_str("END_VAR\n\n");
    text + &rungs
}

/// Writes the folder; how many bytes its programs have.
fn write(folder: &Path, files: usize) -> usize {
    let write = |name: &str, text: &str| {
        std::fs::write(folder.join(name), text).expect("the folder can be written");
        text.len()
    };
    write("ladder.toml", "");
    let globals = "VAR_GLOBAL\n    enable : BOOL;\nEND_VAR\n\n+--[ ]( I1 )--( )( enable )--+\n";
    let mut bytes = write("globals.clad", globals);
    for number in 0..files {
        bytes += write(&format!("part_{number}.clad"), &file(number));
    }
    bytes
}

/// How long an answer takes, and how many places are in it.
fn asked(server: &mut Server, method: &str, params: &Value, place: &str) -> (Duration, usize) {
    let started = Instant::now();
    let answer = server.request(method, params);
    let took = started.elapsed();
    let text = String::from_utf8_lossy(&answer);
    (took, text.matches(place).count())
}

fn main() {
    let given = std::env::args().skip(1).find_map(|it| it.parse().ok());
    let files: usize = given.unwrap_or(2_000);
    let folder = tempfile::tempdir().expect("a folder can be made");
    let bytes = write(folder.path(), files);
    println!("{files} files, {:.1} MB", bytes as f64 / 1e6);
    let mut server = Server::start();
    let idle = server.memory();
    let uri = format!("file://{}", folder.path().join("part_7.clad").display());
    let started = Instant::now();
    server.send(
        &json!({ "jsonrpc": "2.0", "method": "textDocument/didOpen", "params": {
        "textDocument": { "uri": uri, "languageId": "clad", "version": 1, "text": file(7) } } }),
    );
    server.diagnostics_of(1);
    println!("  {:<28} {:.2?}", "first diagnostics", started.elapsed());
    let text = file(7);
    let line = text
        .lines()
        .position(|line| line.starts_with('+'))
        .unwrap_or_default();
    let at = json!({ "line": line, "character": 9 });
    let document = json!({ "uri": uri });
    let references =
        json!({ "textDocument": document, "position": at, "context": { "includeDeclaration": true } });
    for what in ["references", "references, again"] {
        let (took, places) = asked(&mut server, "textDocument/references", &references, "\"range\"");
        println!("  {what:<28} {took:.2?}, {places} places");
    }
    let rename = json!({ "textDocument": document, "position": at, "newName": "released" });
    let (took, edits) = asked(&mut server, "textDocument/rename", &rename, "\"newText\"");
    println!("  {:<28} {took:.2?}, {edits} edits", "rename");
    let at_once = server.memory();
    std::thread::sleep(SETTLED);
    if let (Some([idle, _]), Some([at_once, most]), Some([now, _])) = (idle, at_once, server.memory()) {
        let share = |held: u64| held.saturating_sub(idle) as f64 / bytes as f64;
        println!(
            "  memory: {:.0} MB idle, {:.1} times the texts above it, {:.1} times at rest, at most {:.1} times",
            idle as f64 / 1e6,
            share(at_once),
            share(now),
            share(most)
        );
    }
}

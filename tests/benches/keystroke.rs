//! From a keystroke to its diagnostics, over the real program and real pipes.
//!
//! Opens a file of rungs in `ladder lsp`, types a letter into one rung, and takes the time until the diagnostics
//! of that very version arrive. Beside it stands the bare limit: the round trip of a request that the server
//! does not know, which has the same framing, pipes and scheduling, and no work.
//!
//! Run with `cargo build --release -p ladder-cli && cargo bench -p ladder-tests --bench keystroke`; the number of
//! rungs may follow as arguments.

use serde_json::{Value, json};
use std::io::{BufRead, BufReader, Read, Write};
use std::path::PathBuf;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use std::time::{Duration, Instant};

const EDITS: usize = 400;

struct Server {
    child: Child,
    stdin: ChildStdin,
    stdout: BufReader<ChildStdout>,
    next_id: u64,
}

impl Server {
    fn start() -> Server {
        let program = program();
        let mut child = Command::new(&program)
            .arg("lsp")
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .unwrap_or_else(|error| panic!("cannot start {}: {error}", program.display()));
        let stdin = child.stdin.take().expect("stdin is piped");
        let stdout = BufReader::new(child.stdout.take().expect("stdout is piped"));
        let mut server = Server {
            child,
            stdin,
            stdout,
            next_id: 0,
        };
        server.request(
            "initialize",
            &json!({ "processId": null, "rootUri": null, "capabilities": {} }),
        );
        server.send(&json!({ "jsonrpc": "2.0", "method": "initialized", "params": {} }));
        server
    }

    fn send(&mut self, message: &Value) {
        let body = message.to_string();
        write!(self.stdin, "Content-Length: {}\r\n\r\n{body}", body.len()).expect("the server reads");
        self.stdin.flush().expect("the server reads");
    }

    fn receive(&mut self) -> Value {
        let mut length = 0;
        loop {
            let mut line = String::new();
            let read = self.stdout.read_line(&mut line).expect("the server answers");
            assert!(read > 0, "the server has ended");
            if line == "\r\n" {
                break;
            }
            if let Some(value) = line.strip_prefix("Content-Length: ") {
                length = value.trim().parse().expect("a length is a number");
            }
        }
        let mut body = vec![0; length];
        self.stdout
            .read_exact(&mut body)
            .expect("the server answers whole");
        serde_json::from_slice(&body).expect("the server answers JSON")
    }

    fn request(&mut self, method: &str, params: &Value) -> Value {
        self.next_id += 1;
        let id = self.next_id;
        self.send(&json!({ "jsonrpc": "2.0", "id": id, "method": method, "params": params }));
        loop {
            let message = self.receive();
            if message["id"] == json!(id) {
                return message;
            }
        }
    }

    fn diagnostics_of(&mut self, version: i64) {
        loop {
            let message = self.receive();
            if message["method"] == "textDocument/publishDiagnostics"
                && message["params"]["version"] == version
            {
                return;
            }
        }
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// The release build beside this bench, unless `LADDER_BIN` names another.
fn program() -> PathBuf {
    if let Some(path) = std::env::var_os("LADDER_BIN") {
        return path.into();
    }
    let bench = std::env::current_exe().expect("a program knows where it is");
    bench
        .ancestors()
        .nth(2)
        .expect("target/release/deps")
        .join("ladder")
}

/// Rungs of four kinds in turn, with names of their own.
fn program_text(rungs: usize) -> String {
    let mut text = String::new();
    for n in 0..rungs {
        let before = n.saturating_sub(1);
        text.push_str(&match n % 4 {
            0 => format!(
                "+--\\--[ ]( start_{n} )--\\--[/]( stop_{n} )--( )( run_{n} )--+\n|  /--[ ]( run_{n} )----/\n\n"
            ),
            1 => format!("+--[ ]( run_{before} )--[TON]( timer_{n}, T#5s )--( )( ready_{n} )--+\n\n"),
            2 => format!("+--[ ]( ready_{before} )--[GT]( level_{n}, 80 )--[ADD]( sum_{n}, sum_{n}, 1 )--+\n\n"),
            _ => format!("+--[P]( in_{n} )--[CTU]( count_{n}, 10, R := reset_{n} )--( )( full_{n} )--+\n\n"),
        });
    }
    text
}

fn show(what: &str, mut times: Vec<Duration>) -> Duration {
    times.sort_unstable();
    let at = |share: f64| times[((times.len() - 1) as f64 * share) as usize];
    println!(
        "  {what:<28} median {:>9.1?}   99th percentile {:>9.1?}",
        at(0.5),
        at(0.99)
    );
    at(0.5)
}

fn measure(rungs: usize) {
    let text = program_text(rungs);
    let line = text
        .lines()
        .position(|line| line.contains("run_"))
        .expect("the text has a rung")
        + 8 * (rungs / 16);
    let column = text
        .lines()
        .nth(line)
        .and_then(|l| l.find("( "))
        .map_or(0, |at| at + 2);
    println!("{rungs} rungs, {} bytes", text.len());
    let mut server = Server::start();
    let uri = "file:///bench.clad";
    server.send(
        &json!({ "jsonrpc": "2.0", "method": "textDocument/didOpen", "params": {
        "textDocument": { "uri": uri, "languageId": "clad", "version": 1, "text": text } } }),
    );
    server.diagnostics_of(1);
    let mut edits = Vec::with_capacity(EDITS);
    for n in 0..EDITS {
        let version = n as i64 + 2;
        // A letter in, a letter out.
        let (end, new) = if n % 2 == 0 {
            (column, "x")
        } else {
            (column + 1, "")
        };
        let started = Instant::now();
        server.send(
            &json!({ "jsonrpc": "2.0", "method": "textDocument/didChange", "params": {
            "textDocument": { "uri": uri, "version": version },
            "contentChanges": [{ "range": { "start": { "line": line, "character": column },
                                            "end": { "line": line, "character": end } }, "text": new }] } }),
        );
        server.diagnostics_of(version);
        edits.push(started.elapsed());
    }
    let mut bare = Vec::with_capacity(EDITS);
    for _ in 0..EDITS {
        let started = Instant::now();
        server.request("ladder/nothing", &Value::Null);
        bare.push(started.elapsed());
    }
    let edit = show("edit to its diagnostics", edits);
    let limit = show("bare round trip", bare);
    println!(
        "  ratio of the medians: {:.1}",
        edit.as_secs_f64() / limit.as_secs_f64()
    );
}

fn main() {
    let given: Vec<usize> = std::env::args()
        .skip(1)
        .filter_map(|argument| argument.parse().ok())
        .collect();
    for rungs in if given.is_empty() { vec![1_000] } else { given } {
        measure(rungs);
    }
}

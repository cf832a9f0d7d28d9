//! What an editor waits for: from a keystroke to its diagnostics, and from a request to its answer, over the real
//! program and real pipes.
//!
//! Opens a file of rungs in `ladder lsp`, types a letter into one rung again and again, and takes the time until the
//! diagnostics of that very version arrive; then asks for everything else, each time behind an edit. Beside it stands
//! the bare limit: the round trip of a request that the server does not know, which has the same framing, pipes and
//! scheduling, and no work.
//!
//! Run with `cargo build --release -p ladder-cli && cargo bench -p ladder-tests --bench language_server`; the numbers
//! of rungs may follow as arguments.

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

/// Declared, clean and aligned: rungs of four kinds in turn, with names of their own.
fn program_text(rungs: usize) -> String {
    let mut rows = String::new();
    let mut sections = [String::new(), String::new(), String::new()];
    for n in 0..rungs {
        let before = n.saturating_sub(1);
        let (drawn, [input, output, inner]) = match n % 4 {
            0 => (
                format!(
                    "+--\\--[ ]( start_{n} )--\\--[/]( stop_{n} )--( )( run_{n} )--+\n|  /--[ ]( run_{n} )----/\n\n"
                ),
                [
                    format!("start_{n}, stop_{n} : BOOL;"),
                    format!("run_{n} : BOOL;"),
                    String::new(),
                ],
            ),
            1 => (
                format!("+--[ ]( run_{before} )--[TON]( timer_{n}, T#5s )--( )( ready_{n} )--+\n\n"),
                [
                    String::new(),
                    format!("ready_{n} : BOOL;"),
                    format!("timer_{n} : TON;"),
                ],
            ),
            2 => (
                format!(
                    "+--[ ]( ready_{before} )--[GT]( level_{n}, 80 )--[ADD]( sum_{n}, sum_{n}, 1 )--+\n\n"
                ),
                [
                    format!("level_{n} : INT;"),
                    format!("sum_{n} : DINT;"),
                    String::new(),
                ],
            ),
            _ => (
                format!("+--[P]( in_{n} )--[CTU]( count_{n}, 10, R := reset_{n} )--( )( full_{n} )--+\n\n"),
                [
                    format!("in_{n}, reset_{n} : BOOL;"),
                    format!("full_{n} : BOOL;"),
                    format!("count_{n} : CTU;"),
                ],
            ),
        };
        rows.push_str(&drawn);
        for (section, line) in sections.iter_mut().zip([input, output, inner]) {
            if !line.is_empty() {
                section.push_str(&format!("    {line}\n"));
            }
        }
    }
    let [inputs, outputs, inner] = sections;
    let text =
        format!("VAR_INPUT\n{inputs}END_VAR\nVAR_OUTPUT\n{outputs}END_VAR\nVAR\n{inner}END_VAR\n\n{rows}");
    ladder_format::format_text(&text, &ladder_format::Options::default())
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

/// An open document in which somebody types.
struct Typing {
    server: Server,
    line: usize,
    column: usize,
    version: i64,
    uri: String,
}

impl Typing {
    /// A letter in, a letter out.
    fn type_on(&mut self) {
        let (end, new) = if self.version % 2 == 1 {
            (self.column, "x")
        } else {
            (self.column + 1, "")
        };
        self.version += 1;
        let place = |character| json!({ "line": self.line, "character": character });
        self.server.send(
            &json!({ "jsonrpc": "2.0", "method": "textDocument/didChange", "params": {
            "textDocument": { "uri": self.uri, "version": self.version },
            "contentChanges": [{ "range": { "start": place(self.column), "end": place(end) }, "text": new }] } }),
        );
    }

    fn edits(&mut self, count: usize) -> Vec<Duration> {
        let edit = |_| {
            let started = Instant::now();
            self.type_on();
            self.server.diagnostics_of(self.version);
            started.elapsed()
        };
        (0..count).map(edit).collect()
    }

    /// A request on a text that was just edited and checked. What the answer is must not be an error.
    fn requests(&mut self, count: usize, method: &str, params: &Value) -> Vec<Duration> {
        let mut params = params.clone();
        params["textDocument"] = json!({ "uri": self.uri });
        let request = |_| {
            self.type_on();
            self.server.diagnostics_of(self.version);
            let started = Instant::now();
            let answer = self.server.request(method, &params);
            let took = started.elapsed();
            assert!(answer.get("error").is_none(), "{method}: {answer}");
            // A delta refers to what was told before.
            if let Some(id) = answer["result"].get("resultId") {
                params["previousResultId"] = id.clone();
            }
            took
        };
        (0..count).map(request).collect()
    }

    /// Time of the processor that the server has taken, in all its threads: what else the machine does is not in it.
    /// Linux only.
    fn processor_time(&self) -> Option<Duration> {
        let tasks = std::fs::read_dir(format!("/proc/{}/task", self.server.child.id())).ok()?;
        let of = |task: std::fs::DirEntry| {
            let stat = std::fs::read_to_string(task.path().join("schedstat")).ok()?;
            stat.split_whitespace().next()?.parse::<u64>().ok()
        };
        let nanoseconds: u64 = tasks.flatten().filter_map(of).sum();
        Some(Duration::from_nanos(nanoseconds))
    }

    /// Memory that the server holds, and has held at most, in bytes. Linux only.
    fn memory(&self) -> Option<[u64; 2]> {
        let status = std::fs::read_to_string(format!("/proc/{}/status", self.server.child.id())).ok()?;
        let of = |name: &str| {
            let line = status.lines().find(|line| line.starts_with(name))?;
            line.split_whitespace().nth(1)?.parse::<u64>().ok()
        };
        Some([of("VmRSS:")? * 1024, of("VmHWM:")? * 1024])
    }
}

fn measure(rungs: usize) {
    let text = program_text(rungs);
    // A rung in the middle of the file.
    let middle = format!("start_{} )", rungs / 8 * 4);
    let drawn = |line: &str| line.contains(&middle) && line.starts_with('+');
    let (line, row) = text
        .lines()
        .enumerate()
        .find(|(_, line)| drawn(line))
        .expect("the rung is there");
    let column = row.find(&middle).expect("the tag is there") + middle.len() - 2;
    println!("{rungs} rungs, {} bytes", text.len());
    // A workspace of its own, so that nothing else on the disk is looked at.
    let folder = tempfile::tempdir().expect("a folder can be made");
    let file = folder.path().join("bench.clad");
    std::fs::write(folder.path().join("ladder.toml"), "").expect("the folder can be written");
    std::fs::write(&file, &text).expect("the folder can be written");
    let uri = format!("file://{}", file.display());
    let mut server = Server::start();
    server.send(
        &json!({ "jsonrpc": "2.0", "method": "textDocument/didOpen", "params": {
        "textDocument": { "uri": uri, "languageId": "clad", "version": 1, "text": text } } }),
    );
    let started = Instant::now();
    server.diagnostics_of(1);
    println!("  {:<28} {:.1?}", "opening it", started.elapsed());
    let mut typing = Typing {
        server,
        line,
        column,
        version: 1,
        uri,
    };
    let count = if rungs > 20_000 { EDITS / 8 } else { EDITS };
    let before = typing.processor_time();
    let edit = show("edit to its diagnostics", typing.edits(count));
    if let (Some(before), Some(after)) = (before, typing.processor_time()) {
        println!(
            "  {:<28} {:.1?}",
            "processor time of an edit",
            after.saturating_sub(before) / count as u32
        );
    }
    let mut bare = Vec::with_capacity(EDITS);
    for _ in 0..EDITS {
        let started = Instant::now();
        typing.server.request("ladder/nothing", &Value::Null);
        bare.push(started.elapsed());
    }
    let limit = show("bare round trip", bare);
    let at = json!({ "position": { "line": line, "character": column } });
    let options = json!({ "options": { "tabSize": 4, "insertSpaces": true } });
    let rename = json!({ "position": { "line": line, "character": column }, "newName": "renamed_here" });
    for (what, method, params) in [
        ("completion", "textDocument/completion", &at),
        ("hover", "textDocument/hover", &at),
        (
            "semantic tokens, full",
            "textDocument/semanticTokens/full",
            &json!({}),
        ),
        (
            "semantic tokens, delta",
            "textDocument/semanticTokens/full/delta",
            &json!({ "previousResultId": "" }),
        ),
        ("document symbols", "textDocument/documentSymbol", &json!({})),
        ("format", "textDocument/formatting", &options),
        ("rename", "textDocument/rename", &rename),
    ] {
        let count = if rungs > 2_000 { 20 } else { 100 };
        show(what, typing.requests(count, method, params));
    }
    println!(
        "  ratio of the medians, edit to bare round trip: {:.1}",
        edit.as_secs_f64() / limit.as_secs_f64()
    );
    if let Some([now, most]) = typing.memory() {
        let share = |bytes: u64| bytes as f64 / text.len() as f64;
        println!(
            "  memory: {:.1} times the text, at most {:.1} times",
            share(now),
            share(most)
        );
    }
}

fn main() {
    let given: Vec<usize> = std::env::args()
        .skip(1)
        .filter_map(|argument| argument.parse().ok())
        .collect();
    for rungs in if given.is_empty() {
        vec![1_000, 10_000, 100_000]
    } else {
        given
    } {
        measure(rungs);
    }
}

//! The language server as a process, spoken to as an editor does, and what the system counts of it.

use serde_json::{Value, json};
use std::io::{BufRead, BufReader, Read, Write};
use std::path::PathBuf;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use std::time::Duration;

/// A running language server. Whatever goes wrong with it ends the bench.
pub struct Server {
    child: Child,
    stdin: ChildStdin,
    stdout: BufReader<ChildStdout>,
    next_id: u64,
    /// Of which version the last diagnostics are.
    checked: i64,
}

impl Server {
    /// Starts one, and greets it.
    pub fn start() -> Server {
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
            checked: 0,
        };
        server.request(
            "initialize",
            &json!({ "processId": null, "rootUri": null, "capabilities": {} }),
        );
        server.send(&json!({ "jsonrpc": "2.0", "method": "initialized", "params": {} }));
        server
    }

    /// Sends a message.
    pub fn send(&mut self, message: &Value) {
        let body = message.to_string();
        write!(self.stdin, "Content-Length: {}\r\n\r\n{body}", body.len()).expect("the server reads");
        self.stdin.flush().expect("the server reads");
    }

    /// The next message as it was sent: what a client does with it is not the server's time. Of diagnostics the version
    /// is noted.
    fn receive(&mut self) -> Vec<u8> {
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
        let is_diagnostics = body.starts_with(DIAGNOSTICS);
        if let Some(version) = is_diagnostics.then(|| version_at_the_end(&body)).flatten() {
            self.checked = version;
        }
        body
    }

    /// Asks, and waits for the answer, which is given as it was sent.
    pub fn request(&mut self, method: &str, params: &Value) -> Vec<u8> {
        self.next_id += 1;
        let id = self.next_id;
        self.send(&json!({ "jsonrpc": "2.0", "id": id, "method": method, "params": params }));
        let end = format!(",\"id\":{id}}}");
        loop {
            let message = self.receive();
            if message.ends_with(end.as_bytes()) && !message.starts_with(b"{\"jsonrpc\":\"2.0\",\"method\"") {
                return message;
            }
        }
    }

    /// Waits for the diagnostics of a version, if they have not come yet.
    pub fn diagnostics_of(&mut self, version: i64) {
        while self.checked < version {
            self.receive();
        }
    }

    /// Time of the processor that the server has taken, in all its threads: what else the machine does is not in it.
    /// Linux only.
    pub fn processor_time(&self) -> Option<Duration> {
        let tasks = std::fs::read_dir(format!("/proc/{}/task", self.child.id())).ok()?;
        let of = |task: std::fs::DirEntry| {
            let stat = std::fs::read_to_string(task.path().join("schedstat")).ok()?;
            stat.split_whitespace().next()?.parse::<u64>().ok()
        };
        let nanoseconds: u64 = tasks.flatten().filter_map(of).sum();
        Some(Duration::from_nanos(nanoseconds))
    }

    /// Memory that the server holds, and has held at most, in bytes. Linux only.
    pub fn memory(&self) -> Option<[u64; 2]> {
        let status = std::fs::read_to_string(format!("/proc/{}/status", self.child.id())).ok()?;
        let of = |name: &str| {
            let line = status.lines().find(|line| line.starts_with(name))?;
            line.split_whitespace().nth(1)?.parse::<u64>().ok()
        };
        Some([of("VmRSS:")? * 1024, of("VmHWM:")? * 1024])
    }
}

/// What a message with diagnostics begins with.
const DIAGNOSTICS: &[u8] = br#"{"jsonrpc":"2.0","method":"textDocument/publishDiagnostics""#;

/// The version that the parameters of a notification end with.
fn version_at_the_end(body: &[u8]) -> Option<i64> {
    let rest = body.strip_suffix(b"}}")?;
    let digits = rest.iter().rev().take_while(|byte| byte.is_ascii_digit()).count();
    let (before, digits) = rest.split_at(rest.len() - digits);
    before.ends_with(b"\"version\":").then_some(())?;
    std::str::from_utf8(digits).ok()?.parse().ok()
}

impl Drop for Server {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// The release build next to this bench, unless `LADDER_BIN` names another.
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

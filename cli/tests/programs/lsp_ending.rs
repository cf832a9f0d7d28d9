//! How `ladder lsp` ends, as a process: editors keep its input open and wait, or die without a word.

use std::io::{BufRead, BufReader, Read, Write};
use std::process::{Child, ChildStdin, ChildStdout, Command, ExitStatus, Stdio};
use std::time::{Duration, Instant};

use serde_json::{Value, json};

/// Far longer than it takes, on a machine that is busy.
const PATIENCE: Duration = Duration::from_secs(20);

struct Server {
    child: Child,
    stdin: Option<ChildStdin>,
    stdout: BufReader<ChildStdout>,
}

impl Server {
    /// A server that has answered `initialize`.
    fn start(process: Option<u32>) -> Server {
        let mut child = Command::new(env!("CARGO_BIN_EXE_ladder"))
            .arg("lsp")
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .expect("ladder starts");
        let stdin = child.stdin.take();
        let stdout = BufReader::new(child.stdout.take().expect("stdout is piped"));
        let mut server = Server { child, stdin, stdout };
        let params = json!({"processId": process, "rootUri": null, "capabilities": {}});
        server.request("initialize", &params);
        server
    }

    fn send(&mut self, message: &Value) {
        let body = message.to_string();
        let stdin = self.stdin.as_mut().expect("stdin is open");
        write!(stdin, "Content-Length: {}\r\n\r\n{body}", body.len()).expect("the server reads");
    }

    fn notify(&mut self, method: &str) {
        self.send(&json!({"jsonrpc": "2.0", "method": method}));
    }

    /// Sends a request and reads until its answer.
    fn request(&mut self, method: &str, params: &Value) -> Value {
        self.send(&json!({"jsonrpc": "2.0", "id": 1, "method": method, "params": params}));
        loop {
            let message = self.receive();
            if message["id"] == 1 {
                return message;
            }
        }
    }

    fn receive(&mut self) -> Value {
        let mut length = 0;
        loop {
            let mut line = String::new();
            self.stdout.read_line(&mut line).expect("stdout is text");
            match line.strip_prefix("Content-Length: ") {
                Some(number) => length = number.trim().parse().expect("a length"),
                None => assert_eq!(line, "\r\n", "stdout belongs to the protocol"),
            }
            if line == "\r\n" {
                break;
            }
        }
        let mut body = vec![0; length];
        self.stdout.read_exact(&mut body).expect("a message");
        serde_json::from_slice(&body).expect("JSON")
    }

    /// Waits for the end, without closing stdin.
    fn ended(&mut self) -> ExitStatus {
        let begin = Instant::now();
        loop {
            if let Some(status) = self.child.try_wait().expect("the child is ours") {
                return status;
            }
            assert!(begin.elapsed() < PATIENCE, "the server does not end");
            std::thread::sleep(Duration::from_millis(5));
        }
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        // A test that failed leaves no server running.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

#[test]
fn exit_ends_it_while_stdin_stays_open() {
    let mut server = Server::start(None);
    assert_eq!(server.request("shutdown", &Value::Null)["result"], Value::Null);
    server.notify("exit");
    assert_eq!(server.ended().code(), Some(0));
}

#[test]
fn exit_without_shutdown_has_status_1() {
    let mut server = Server::start(None);
    server.notify("exit");
    assert_eq!(server.ended().code(), Some(1));
}

#[test]
fn the_end_of_the_input_ends_it() {
    let mut server = Server::start(None);
    server.stdin = None;
    assert_eq!(server.ended().code(), Some(1));
    let mut server = Server::start(None);
    server.request("shutdown", &Value::Null);
    server.stdin = None;
    assert_eq!(server.ended().code(), Some(0), "it was asked to");
}

#[cfg(unix)]
#[test]
fn the_death_of_the_editor_ends_it() {
    let mut editor = Command::new("sleep").arg("600").spawn().expect("sleep starts");
    let mut server = Server::start(Some(editor.id()));
    editor.kill().expect("the child is ours");
    editor.wait().expect("the child is ours");
    assert_eq!(server.ended().code(), Some(1));
}

#[test]
fn a_run_that_goes_on_does_not_keep_it() {
    let mut server = Server::start(None);
    let uri = "file:///motor.clad";
    let document =
        json!({"uri": uri, "languageId": "clad", "version": 1, "text": "+--[ ]( a )--( )( y )--+\n"});
    let opened =
        json!({"jsonrpc": "2.0", "method": "textDocument/didOpen", "params": {"textDocument": document}});
    server.send(&opened);
    let mut simulate = |command: &str, argument: Value| {
        let params = json!({"command": format!("ladder.simulate.{command}"), "arguments": [argument]});
        server.request("workspace/executeCommand", &params)["result"].clone()
    };
    let session = simulate("start", json!({"uri": uri}))["session"].clone();
    let state = simulate("run", json!({"session": session, "realTime": false}));
    assert_eq!(state["status"], "running");
    server.notify("exit");
    assert_eq!(server.ended().code(), Some(1));
}

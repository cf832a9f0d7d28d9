//! A small client: it speaks the base protocol over an in-process pipe, framework and all.
//!
//! It checks what every test wants to hold: each request is answered exactly once, nothing else is answered, and
//! nothing takes longer than [`PATIENCE`].

use std::collections::{HashMap, HashSet, VecDeque};
use std::time::{Duration, Instant};

use ladder_server::{Ending, serve};
use serde_json::{Value, json};
use tokio::io::{AsyncBufReadExt, AsyncReadExt, AsyncWriteExt, BufReader, DuplexStream};
use tokio::task::JoinHandle;
use tokio::time::timeout;

/// Far longer than anything takes, on a machine that is busy with other tests too.
pub(crate) const PATIENCE: Duration = Duration::from_secs(30);

/// The document that most tests open.
pub(crate) const URI: &str = "file:///plant/motor.clad";

/// An answer: the result, or the error's code and message.
pub(crate) type Answer = Result<Value, (i64, String)>;

/// One client with its server.
pub(crate) struct Client {
    to_server: DuplexStream,
    from_server: BufReader<DuplexStream>,
    server: JoinHandle<Ending>,
    asked: i64,
    outstanding: HashSet<i64>,
    answers: HashMap<i64, Answer>,
    /// What came that nobody has checked yet.
    notifications: VecDeque<Value>,
    /// Requests of the server that nobody has answered yet; none if the client does not take any.
    requests: Option<VecDeque<Value>>,
    /// Errors that answer no request: their `id` is `null`.
    pub(crate) unaddressed: VecDeque<Value>,
}

impl Client {
    /// A client that has said nothing yet.
    pub(crate) fn silent() -> Self {
        let (to_server, input) = tokio::io::duplex(1 << 16);
        let (output, from_server) = tokio::io::duplex(1 << 16);
        Client {
            to_server,
            from_server: BufReader::new(from_server),
            server: tokio::spawn(serve(input, output)),
            asked: 0,
            outstanding: HashSet::new(),
            answers: HashMap::new(),
            notifications: VecDeque::new(),
            requests: None,
            unaddressed: VecDeque::new(),
        }
    }

    /// A client that can do everything, initialized, with this encoding.
    pub(crate) async fn with_encoding(encoding: &str) -> Self {
        Self::with(json!({
            "textDocument": {
                "publishDiagnostics": {
                    "relatedInformation": true, "tagSupport": {"valueSet": [1, 2]}, "dataSupport": true
                },
                "hover": {"contentFormat": ["markdown"]}
            },
            "workspace": {"workspaceEdit": {"documentChanges": true}},
            "general": {"positionEncodings": [encoding]}
        }))
        .await
    }

    /// A client with these capabilities, initialized.
    pub(crate) async fn with(capabilities: Value) -> Self {
        Self::begun(json!({"processId": null, "rootUri": null, "capabilities": capabilities})).await
    }

    /// A client that begins like this.
    pub(crate) async fn begun(params: Value) -> Self {
        let mut client = Self::silent();
        client.request("initialize", params).await.expect("initialize");
        client.notify("initialized", json!({})).await;
        client
    }

    /// A client that can do everything, initialized.
    pub(crate) async fn new() -> Self {
        Self::with_encoding("utf-8").await
    }

    /// Sends bytes as they are.
    pub(crate) async fn send_raw(&mut self, bytes: &[u8]) {
        timeout(PATIENCE, self.to_server.write_all(bytes))
            .await
            .expect("the server reads")
            .expect("it lives");
    }

    /// Sends a message in its frame.
    pub(crate) async fn send(&mut self, message: &Value) {
        let body = message.to_string();
        self.send_raw(format!("Content-Length: {}\r\n\r\n{body}", body.len()).as_bytes())
            .await;
    }

    /// Sends a notification.
    pub(crate) async fn notify(&mut self, method: &str, params: Value) {
        self.send(&json!({"jsonrpc": "2.0", "method": method, "params": params}))
            .await;
    }

    /// Sends a request without waiting for its answer.
    pub(crate) async fn ask(&mut self, method: &str, params: Value) -> i64 {
        self.asked += 1;
        let id = self.asked;
        self.outstanding.insert(id);
        self.send(&json!({"jsonrpc": "2.0", "id": id, "method": method, "params": params}))
            .await;
        id
    }

    /// The number of a request that is then sent as bytes.
    pub(crate) fn next_id(&mut self) -> i64 {
        self.asked += 1;
        self.outstanding.insert(self.asked);
        self.asked
    }

    /// Sends a request that has its number already.
    pub(crate) async fn ask_as(&mut self, id: i64, message: &Value) {
        self.outstanding.insert(id);
        self.send(message).await;
    }

    /// The answer to a request.
    pub(crate) async fn answer(&mut self, id: i64) -> Answer {
        let begin = Instant::now();
        loop {
            if let Some(answer) = self.answers.remove(&id) {
                return answer;
            }
            assert!(begin.elapsed() < PATIENCE, "no answer to request {id}");
            self.read().await;
        }
    }

    /// Sends a request and waits for its answer.
    pub(crate) async fn request(&mut self, method: &str, params: Value) -> Answer {
        let id = self.ask(method, params).await;
        self.answer(id).await
    }

    /// The parameters of the next notification of this method that fits; others stay for later.
    pub(crate) async fn notification(&mut self, method: &str, fits: impl Fn(&Value) -> bool) -> Value {
        let begin = Instant::now();
        loop {
            let wanted = |it: &Value| it["method"] == method && fits(&it["params"]);
            if let Some(at) = self.notifications.iter().position(wanted) {
                return self.notifications.remove(at).unwrap()["params"].take();
            }
            assert!(begin.elapsed() < PATIENCE, "no such {method}");
            self.read().await;
        }
    }

    /// From now on the server may ask the client.
    pub(crate) fn take_requests(&mut self) {
        self.requests = Some(VecDeque::new());
    }

    /// The next request of the server with this method: its number and parameters. Others stay for later.
    pub(crate) async fn asked(&mut self, method: &str) -> (Value, Value) {
        let begin = Instant::now();
        loop {
            let requests = self.requests.as_mut().expect("a client that takes requests");
            if let Some(at) = requests.iter().position(|it| it["method"] == method) {
                let mut request = requests.remove(at).unwrap();
                return (request["id"].take(), request["params"].take());
            }
            assert!(begin.elapsed() < PATIENCE, "no request {method}");
            self.read().await;
        }
    }

    /// Answers a request of the server.
    pub(crate) async fn reply(&mut self, id: Value, result: Value) {
        self.send(&json!({"jsonrpc": "2.0", "id": id, "result": result}))
            .await;
    }

    /// All notifications of this method that are here already.
    pub(crate) fn arrived(&mut self, method: &str) -> Vec<Value> {
        let (these, others): (VecDeque<_>, _) = self
            .notifications
            .drain(..)
            .partition(|it: &Value| it["method"] == method);
        self.notifications = others;
        these.into_iter().map(|mut it| it["params"].take()).collect()
    }

    /// Reads one message and puts it where it belongs.
    pub(crate) async fn read(&mut self) {
        let message = timeout(PATIENCE, self.read_message())
            .await
            .expect("the server says something");
        if message.get("method").is_some() {
            if message.get("id").is_some() {
                let taken = self.requests.as_mut();
                taken
                    .unwrap_or_else(|| panic!("the server asks this client nothing: {message}"))
                    .push_back(message);
                return;
            }
            self.notifications.push_back(message);
            return;
        }
        let Some(id) = message["id"].as_i64() else {
            self.unaddressed.push_back(message);
            return;
        };
        assert!(
            self.outstanding.remove(&id),
            "answered twice, or never asked: {message}"
        );
        let answer = match message.get("error") {
            Some(error) => Err((
                error["code"].as_i64().unwrap(),
                error["message"].as_str().unwrap().to_owned(),
            )),
            None => Ok(message
                .get("result")
                .cloned()
                .expect("an answer has a result or an error")),
        };
        self.answers.insert(id, answer);
    }

    async fn read_message(&mut self) -> Value {
        let mut length = None;
        loop {
            let mut line = String::new();
            assert_ne!(
                self.from_server.read_line(&mut line).await.unwrap(),
                0,
                "the server has gone"
            );
            match line.trim_end().strip_prefix("Content-Length: ") {
                Some(number) => length = Some(number.parse::<usize>().unwrap()),
                None if line == "\r\n" => break,
                None => panic!("not a header: {line:?}"),
            }
        }
        let mut body = vec![0; length.expect("a length")];
        self.from_server.read_exact(&mut body).await.unwrap();
        serde_json::from_slice(&body).unwrap()
    }

    /// Waits until the server has ended by itself, while both pipes stay open.
    pub(crate) async fn ended(&mut self) -> Ending {
        timeout(PATIENCE, &mut self.server)
            .await
            .expect("the server ends")
            .expect("without a panic")
    }

    /// Ends the session as the protocol asks; everything asked must have been answered.
    pub(crate) async fn finish(mut self) {
        assert_eq!(self.request("shutdown", Value::Null).await, Ok(Value::Null));
        self.notify("exit", Value::Null).await;
        assert_eq!(self.ended().await, Ending::Clean);
        assert_eq!(self.outstanding, HashSet::new(), "requests without an answer");
    }

    // Documents.

    /// Opens [`URI`] at version 1.
    pub(crate) async fn open(&mut self, text: &str) {
        self.open_as(URI, 1, text).await;
    }

    /// Opens a document.
    pub(crate) async fn open_as(&mut self, uri: &str, version: i32, text: &str) {
        let document = json!({"uri": uri, "languageId": "clad", "version": version, "text": text});
        self.notify("textDocument/didOpen", json!({"textDocument": document}))
            .await;
    }

    /// Changes [`URI`]: each change is a range `[line, character, line, character]` and its new text.
    pub(crate) async fn change(&mut self, version: i32, changes: &[([u32; 4], &str)]) {
        let changes: Vec<_> = changes
            .iter()
            .map(|(range, text)| json!({"range": span(*range), "text": text}))
            .collect();
        self.notify(
            "textDocument/didChange",
            json!({"textDocument": {"uri": URI, "version": version}, "contentChanges": changes}),
        )
        .await;
    }

    /// Replaces the whole text of [`URI`].
    pub(crate) async fn replace(&mut self, version: i32, text: &str) {
        let params = json!({
            "textDocument": {"uri": URI, "version": version},
            "contentChanges": [{"text": text}]
        });
        self.notify("textDocument/didChange", params).await;
    }

    /// Closes [`URI`].
    pub(crate) async fn close(&mut self) {
        self.notify("textDocument/didClose", json!({"textDocument": {"uri": URI}}))
            .await;
    }

    /// The diagnostics of [`URI`] for this version.
    pub(crate) async fn diagnostics(&mut self, version: i32) -> Vec<Value> {
        let published = self
            .notification("textDocument/publishDiagnostics", |it| {
                it["uri"] == URI && it["version"] == version
            })
            .await;
        published["diagnostics"].as_array().unwrap().clone()
    }

    /// What a hover on [`URI`] shows.
    pub(crate) async fn hover(&mut self, line: u32, character: u32) -> Answer {
        let params =
            json!({"textDocument": {"uri": URI}, "position": {"line": line, "character": character}});
        self.request("textDocument/hover", params).await
    }

    /// A command of the simulator.
    pub(crate) async fn simulate(&mut self, command: &str, argument: Value) -> Answer {
        let params = json!({"command": format!("ladder.simulate.{command}"), "arguments": [argument]});
        self.request("workspace/executeCommand", params).await
    }
}

/// A range of the protocol.
pub(crate) fn span([line, character, end_line, end_character]: [u32; 4]) -> Value {
    json!({
        "start": {"line": line, "character": character},
        "end": {"line": end_line, "character": end_character}
    })
}

//! Whatever a client sends, the server lives on, and each request is answered once.
//!
//! The input as a whole is sent as it is; each part of it is sent as the body of a message, unless it holds headers of its
//! own.

use crate::input::parts;
use ladder_server::serve;
use serde::de::IgnoredAny;
use serde_json::{Value, json};
use std::collections::HashMap;
use std::time::Duration;
use tokio::io::{AsyncBufReadExt, AsyncRead, AsyncReadExt, AsyncWriteExt, BufReader, duplex};
use tokio::runtime::Builder;
use tokio::time::timeout;

/// More messages tell nothing new.
const MOST_MESSAGES: usize = 12;

/// Far longer than anything takes.
const PATIENCE: Duration = Duration::from_secs(15);

/// Bytes that fit between client and server without anybody waiting.
const PIPE: usize = 1 << 20;

/// What begins a message, in small letters.
const HEADER: &[u8] = b"content-length";

/// The requests of the session itself.
const OWN: [&str; 2] = ["\"first of all\"", "\"last of all\""];

pub(crate) fn check(data: &[u8]) {
    let runtime = Builder::new_current_thread().enable_all().build();
    let runtime = runtime.expect("a runtime");
    runtime.block_on(async {
        // A header in a body may take the place of the one that follows, and swallow what is after it.
        let has_headers = data
            .to_ascii_lowercase()
            .windows(HEADER.len())
            .any(|it| it == HEADER);
        if has_headers {
            raw(data).await;
        } else {
            let bodies: Vec<&[u8]> = parts(data).into_iter().take(MOST_MESSAGES).collect();
            session(&bodies).await;
        }
    });
    runtime.shutdown_timeout(PATIENCE);
}

fn frame(body: &[u8]) -> Vec<u8> {
    let mut framed = format!("Content-Length: {}\r\n\r\n", body.len()).into_bytes();
    framed.extend_from_slice(body);
    framed
}

/// What a client says before anything else.
fn beginning() -> Vec<u8> {
    let text = "VAR t : TON; END_VAR\n+--[ ]( start )--[TON]( t, 5s )--( )( run )--+\n+--[ ]( run )--( )( lamp )--+\n";
    let document = json!({"uri": "untitled:main.clad", "languageId": "ladder", "version": 1, "text": text});
    let messages = [
        json!({"jsonrpc": "2.0", "id": "first of all", "method": "initialize", "params": {"capabilities": {}}}),
        json!({"jsonrpc": "2.0", "method": "initialized", "params": {}}),
        json!({"jsonrpc": "2.0", "method": "textDocument/didOpen", "params": {"textDocument": document}}),
    ];
    messages
        .iter()
        .flat_map(|message| frame(message.to_string().as_bytes()))
        .collect()
}

/// What is to come back for a body.
enum Due {
    /// One answer, with this id or none.
    Answer(String),
    /// It may be answered, with this id or none.
    Perhaps(Option<String>),
    /// JSON that this test does not read: it may be answered, with whatever id.
    Unread,
    /// The server goes.
    End,
}

fn due(body: &[u8]) -> Due {
    // What is not a text, or no JSON, is answered without an id.
    let is_json =
        std::str::from_utf8(body).is_ok_and(|text| serde_json::from_str::<IgnoredAny>(text).is_ok());
    if !is_json {
        return Due::Answer("null".to_owned());
    }
    let Ok(message) = serde_json::from_slice::<Value>(body) else {
        return Due::Unread;
    };
    let id = message.get("id").filter(|id| id.is_string() || id.is_i64());
    let id = id.map(Value::to_string);
    let method = message["method"].as_str();
    if method == Some("exit") {
        return Due::End;
    }
    match id {
        Some(id) if message["jsonrpc"] == "2.0" && method.is_some() => Due::Answer(id),
        id => Due::Perhaps(id),
    }
}

/// A session with these bodies between its beginning and its last request.
async fn session(bodies: &[&[u8]]) {
    let (mut to_server, input) = duplex(PIPE);
    let (output, from_server) = duplex(PIPE);
    let server = tokio::spawn(serve(input, output));
    let mut bytes = beginning();
    let mut asked: HashMap<String, usize> = HashMap::new();
    let mut answers = 0;
    let (mut ends, mut knows_ids) = (false, true);
    for body in bodies {
        bytes.extend(frame(body));
        match due(body) {
            Due::Answer(id) => {
                answers += 1;
                *asked.entry(id).or_default() += 1;
            }
            Due::Unread => knows_ids = false,
            Due::Perhaps(id) => *asked.entry(id.unwrap_or_default()).or_default() += 1,
            Due::End => ends = true,
        }
    }
    bytes.extend(frame(
        json!({"jsonrpc": "2.0", "id": "last of all", "method": "ladder/last"})
            .to_string()
            .as_bytes(),
    ));
    to_server
        .write_all(&bytes)
        .await
        .expect("the pipe is wide enough");
    let mut heard = Heard::new(from_server);
    while !(ends || heard.own == OWN.len() && heard.others >= answers) {
        let more = timeout(PATIENCE, heard.next()).await;
        let more = more.unwrap_or_else(|_| panic!("{} of {answers} are answered", heard.others));
        assert!(
            more,
            "the server has ended, {} of {answers} are answered",
            heard.others
        );
    }
    drop(to_server);
    let ended = timeout(PATIENCE, async {
        while heard.next().await {}
        server.await
    });
    ended
        .await
        .expect("the server ends with its input")
        .expect("it does not panic");
    if ends {
        return;
    }
    assert!(
        heard.others <= bodies.len(),
        "{} answers to {} messages",
        heard.others,
        bodies.len()
    );
    for (id, count) in &heard.ids {
        let most = asked.get(id).copied().unwrap_or_default();
        assert!(
            !knows_ids || id == "null" || *count <= most,
            "{count} answers to {id}"
        );
    }
}

/// A session in which the client sends anything.
async fn raw(data: &[u8]) {
    let (mut to_server, input) = duplex(PIPE + data.len());
    let (output, from_server) = duplex(PIPE);
    let server = tokio::spawn(serve(input, output));
    let mut bytes = beginning();
    bytes.extend_from_slice(data);
    to_server
        .write_all(&bytes)
        .await
        .expect("the pipe is wide enough");
    drop(to_server);
    let mut heard = Heard::new(from_server);
    let ended = timeout(PATIENCE, async {
        while heard.next().await {}
        server.await
    });
    ended
        .await
        .expect("the server ends with its input")
        .expect("it does not panic");
}

/// What the server says.
struct Heard<R> {
    from_server: BufReader<R>,
    /// Answers to the session's own requests.
    own: usize,
    /// All other answers, and how many of each id.
    others: usize,
    ids: HashMap<String, usize>,
}

impl<R: AsyncRead + Unpin> Heard<R> {
    fn new(from_server: R) -> Self {
        Heard {
            from_server: BufReader::new(from_server),
            own: 0,
            others: 0,
            ids: HashMap::new(),
        }
    }

    /// Reads one message; false at the end.
    async fn next(&mut self) -> bool {
        let mut length = 0;
        loop {
            let mut line = String::new();
            match self.from_server.read_line(&mut line).await {
                Ok(0) => return false,
                Ok(_) => {}
                Err(error) => panic!("{error}"),
            }
            match line.trim_end().split_once(": ") {
                Some(("Content-Length", value)) => length = value.parse().expect("a length"),
                Some(_) => {}
                None => break,
            }
        }
        let mut body = vec![0; length];
        self.from_server
            .read_exact(&mut body)
            .await
            .expect("the whole message");
        let message: Value = serde_json::from_slice(&body).expect("the server speaks JSON");
        if message.get("method").is_some() {
            return true;
        }
        let id = message.get("id").map(Value::to_string).unwrap_or_default();
        let panicked = message["error"]["code"] == -32603;
        assert!(!panicked, "{message}");
        if OWN.contains(&id.as_str()) {
            self.own += 1;
        } else {
            self.others += 1;
            *self.ids.entry(id).or_default() += 1;
        }
        true
    }
}

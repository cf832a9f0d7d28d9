//! Plays a recorded session again, and prints what the server says: a message a line.
//!
//! As fast as possible, each message waits until all before it are done, so that what is printed is the same each time
//! and can be compared; the recording's own clock is not kept. With a speed it is kept, and nothing waits.

use std::collections::HashSet;
use std::io::Write;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use serde_json::{Value, json};
use tokio::io::{AsyncBufReadExt, AsyncRead, AsyncReadExt, AsyncWrite, AsyncWriteExt, BufReader};
use tokio::sync::Notify;
use tokio::time::{Instant, sleep_until, timeout};

use crate::native::Native;
use crate::recording::Piece;
use crate::serve::serve_counting;
use ladder_host::Busy;

/// Bytes between the player and the server.
const PIPE: usize = 64 << 10;

/// What takes longer is not waited for.
const PATIENCE: Duration = Duration::from_secs(30);

/// A recorded answer may belong to a question that the server does not ask this time.
const QUESTION: Duration = Duration::from_millis(500);

/// What an answer of the client brings about begins within this time.
const MOMENT: Duration = Duration::from_millis(5);

/// The method of the player's own requests. Nobody knows it, so it is answered at once, after all before it. (One that begins
/// with `$/` the framework would leave unanswered.)
const BARRIER: &str = "ladder/barrier";

/// Plays the pieces. `speed` is how much faster than it was the clock runs.
pub(crate) async fn play(pieces: Vec<Piece>, speed: Option<f64>, out: impl Write + Send + 'static) {
    let (mut to_server, input) = tokio::io::duplex(PIPE);
    let (output, from_server) = tokio::io::duplex(PIPE);
    let busy = Busy::default();
    let host = Native::here();
    let server = tokio::spawn(serve_counting(input, output, busy.clone()));
    let heard = Arc::<Heard>::default();
    let printer = tokio::spawn(print(from_server, heard.clone(), out));
    match speed {
        None => in_steps(pieces, &mut to_server, &heard, (&*host, &busy)).await,
        Some(speed) => in_time(pieces, speed, &mut to_server).await,
    }
    drop(to_server);
    let _ = server.await;
    let _ = printer.await;
}

/// What the server has said so far.
#[derive(Debug, Default)]
struct Heard {
    /// Numbers of requests that were answered, and of requests that the server made, as JSON.
    answered: Mutex<HashSet<String>>,
    asked: Mutex<HashSet<String>>,
    news: Notify,
}

impl Heard {
    /// Waits until the number is among them.
    async fn wait(&self, numbers: &Mutex<HashSet<String>>, number: &str, patience: Duration) {
        let here = || {
            numbers
                .lock()
                .unwrap_or_else(PoisonError::into_inner)
                .contains(number)
        };
        let heard = async {
            loop {
                let news = self.news.notified();
                if here() {
                    return;
                }
                news.await;
            }
        };
        // What does not come is missing in what is printed, which is what the recording is for.
        let _ = timeout(patience, heard).await;
    }
}

/// One message after the other, each when all before it are done.
async fn in_steps(
    pieces: Vec<Piece>,
    to_server: &mut (impl AsyncWrite + Unpin),
    heard: &Heard,
    (host, busy): (&Native, &Busy),
) {
    let bytes: Vec<u8> = pieces.into_iter().flat_map(|piece| piece.bytes).collect();
    for (nth, message) in messages(&bytes).into_iter().enumerate() {
        let json = body(message).and_then(|body| serde_json::from_slice::<Value>(body).ok());
        let number = json
            .as_ref()
            .and_then(|json| json.get("id"))
            .map(Value::to_string);
        let method = json.as_ref().and_then(|json| json["method"].as_str());
        if let (Some(number), None) = (&number, method) {
            heard.wait(&heard.asked, number, QUESTION).await;
        }
        let sent = match &json {
            Some(json) if method == Some("initialize") => frame(&without_parent(json.clone())),
            _ => message.to_vec(),
        };
        if to_server.write_all(&sent).await.is_err() {
            return;
        }
        if let (Some(number), Some(_)) = (&number, method) {
            heard.wait(&heard.answered, number, PATIENCE).await;
        }
        if method == Some("exit") {
            return;
        }
        let barrier = json!(format!("{BARRIER}/{nth}"));
        let request = json!({ "jsonrpc": "2.0", "id": barrier, "method": BARRIER });
        if to_server.write_all(&frame(&request)).await.is_err() {
            return;
        }
        heard.wait(&heard.answered, &barrier.to_string(), PATIENCE).await;
        if method.is_none() {
            // A handler that waits for a client's answer goes on a moment later.
            tokio::time::sleep(MOMENT).await;
        }
        busy.rest(host, PATIENCE).await;
    }
}

/// Each piece at its time.
async fn in_time(pieces: Vec<Piece>, speed: f64, to_server: &mut (impl AsyncWrite + Unpin)) {
    let begun = Instant::now();
    // The first message is the one that names the parent.
    let mut first = true;
    for Piece { at, bytes } in pieces {
        sleep_until(begun + at.div_f64(speed)).await;
        let named = first.then(|| body(&bytes)).flatten();
        let named = named.and_then(|body| serde_json::from_slice::<Value>(body).ok());
        first = false;
        let sent = named.map_or(bytes.clone(), |json| frame(&without_parent(json)));
        if to_server.write_all(&sent).await.is_err() {
            return;
        }
    }
}

/// The process that the session belonged to is gone, and the server would go with it.
fn without_parent(mut initialize: Value) -> Value {
    if let Some(params) = initialize.get_mut("params").and_then(Value::as_object_mut) {
        params.insert("processId".into(), Value::Null);
    }
    initialize
}

fn frame(message: &Value) -> Vec<u8> {
    let body = message.to_string();
    format!("Content-Length: {}\r\n\r\n{body}", body.len()).into_bytes()
}

/// The messages with their headers. What cannot be separated is the last one.
fn messages(mut bytes: &[u8]) -> Vec<&[u8]> {
    let mut messages = Vec::new();
    while !bytes.is_empty() {
        let length = length(bytes).unwrap_or(bytes.len());
        let (message, rest) = bytes.split_at(length.min(bytes.len()));
        messages.push(message);
        bytes = rest;
    }
    messages
}

/// How long the first message is, with its header.
fn length(bytes: &[u8]) -> Option<usize> {
    let header = header(bytes)?;
    let text = std::str::from_utf8(&bytes[..header]).ok()?;
    let lines = text.lines().filter_map(|line| line.split_once(':'));
    let length = lines
        .filter(|(name, _)| name.trim().eq_ignore_ascii_case("content-length"))
        .find_map(|(_, value)| value.trim().parse::<usize>().ok())?;
    header.checked_add(length)
}

/// How long the header is.
fn header(bytes: &[u8]) -> Option<usize> {
    let end = b"\r\n\r\n";
    let at = bytes.windows(end.len()).position(|it| it == end)?;
    Some(at + end.len())
}

/// What is after the header, if that is one message.
fn body(message: &[u8]) -> Option<&[u8]> {
    (length(message)? == message.len()).then_some(())?;
    Some(&message[header(message)?..])
}

/// Prints what the server says, and notes what it answers and asks.
async fn print(from_server: impl AsyncRead + Unpin, heard: Arc<Heard>, mut out: impl Write) {
    let mut from_server = BufReader::new(from_server);
    while let Some(message) = next(&mut from_server).await {
        let number = message.get("id").map(Value::to_string);
        let own = message["id"].as_str().is_some_and(|id| id.starts_with(BARRIER));
        if !own && writeln!(out, "{message}").and_then(|()| out.flush()).is_err() {
            return;
        }
        if let Some(number) = number {
            let numbers = if message.get("method").is_some() {
                &heard.asked
            } else {
                &heard.answered
            };
            numbers
                .lock()
                .unwrap_or_else(PoisonError::into_inner)
                .insert(number);
        }
        heard.news.notify_waiters();
    }
}

async fn next(input: &mut (impl AsyncBufReadExt + Unpin)) -> Option<Value> {
    let mut length = 0;
    loop {
        let mut line = String::new();
        if input.read_line(&mut line).await.ok()? == 0 {
            return None;
        }
        match line.trim_end().split_once(": ") {
            Some(("Content-Length", value)) => length = value.parse().ok()?,
            Some(_) => {}
            None => break,
        }
    }
    let mut body = vec![0; length];
    input.read_exact(&mut body).await.ok()?;
    serde_json::from_slice(&body).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn messages_are_told_apart() {
        let bytes = b"Content-Length: 2\r\n\r\n{}content-length:3\r\nX: 1\r\n\r\n[1]garbage";
        let found: Vec<_> = messages(bytes)
            .into_iter()
            .map(|it| (String::from_utf8_lossy(it).into_owned(), body(it).is_some()))
            .collect();
        assert_eq!(
            found,
            [
                ("Content-Length: 2\r\n\r\n{}".to_owned(), true),
                ("content-length:3\r\nX: 1\r\n\r\n[1]".to_owned(), true),
                ("garbage".to_owned(), false),
            ]
        );
    }
}

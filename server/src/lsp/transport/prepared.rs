//! Answers and diagnostics that are JSON text already.
//!
//! The framework takes an answer as a tree of JSON values, and for a large one that tree costs more than all the work for
//! the answer. So a handler may give the text itself: the [`Guard`](super::guard::Guard) keeps it and answers with a ticket,
//! and the [`Outlet`] puts the text in the ticket's place when the answer is written. The parameters of
//! `textDocument/publishDiagnostics` go the same way.

use std::cell::Cell;
use std::collections::{HashMap, VecDeque};
use std::future::Future;
use std::io;
use std::pin::Pin;
use std::sync::{Arc, Mutex, PoisonError};
use std::task::{Context, Poll, ready};

use serde::de::DeserializeOwned;
use serde_json::Value;
use tokio::io::AsyncWrite;
use tokio::sync::oneshot;
use tower_lsp::jsonrpc::{Error, Result};

tokio::task_local! {
    /// The text that the handler of a request has given.
    static GIVEN: Cell<Option<Text>>;
}

/// A JSON text that is to be written.
#[derive(Debug)]
pub(super) struct Text {
    json: String,
    /// Dropped, and so noticed at the other end, when the text is written or will never be.
    _on_its_way: Option<oneshot::Sender<()>>,
}

/// Answers the request that is being handled with a JSON text. What it returns is for the handler to return.
pub(crate) fn answer<T: DeserializeOwned>(text: String) -> Result<Option<T>> {
    give(Text {
        json: text,
        _on_its_way: None,
    })
}

/// As [`answer`]. The other end of the channel learns when the answer has its place in what is written: what is sent
/// from then on comes behind it.
pub(crate) fn answer_ahead<T: DeserializeOwned>(
    text: String,
    on_its_way: oneshot::Sender<()>,
) -> Result<Option<T>> {
    give(Text {
        json: text,
        _on_its_way: Some(on_its_way),
    })
}

/// As [`answer`], for a handler that has to return something: this, which is not sent.
pub(crate) fn answer_instead<T: DeserializeOwned>(unsent: T, text: String) -> Result<T> {
    Ok(answer(text)?.unwrap_or(unsent))
}

fn give<T: DeserializeOwned>(text: Text) -> Result<Option<T>> {
    let mut text = Some(text);
    if GIVEN.try_with(|given| given.set(text.take())).is_ok() {
        return Ok(None);
    }
    // Outside of a session, as in tests.
    let json = text.map(|text| text.json).unwrap_or_default();
    serde_json::from_str(&json).map_err(|_| Error::internal_error())
}

/// Runs a handler; with its outcome comes the text that it has given.
pub(super) async fn handle<F: Future>(handler: F) -> (F::Output, Option<Text>) {
    let run = async {
        let outcome = handler.await;
        (outcome, GIVEN.with(Cell::take))
    };
    GIVEN.scope(Cell::new(None), run).await
}

/// The texts whose tickets are on their way.
#[derive(Debug, Default)]
pub(crate) struct Prepared {
    waiting: Mutex<Waiting>,
}

#[derive(Debug, Default)]
struct Waiting {
    last: u64,
    texts: HashMap<u64, Text>,
}

/// Before the number of a ticket. No answer of the server is a string by itself.
const TICKET: &str = "ladder-prepared-";

/// What is before a ticket and its quote: in an answer, and in a notification.
const BEFORE: [&[u8]; 2] = [
    br#"{"jsonrpc":"2.0","result":"#,
    br#"{"jsonrpc":"2.0","method":"textDocument/publishDiagnostics","params":"#,
];

/// This many bytes are written at once at most.
const AT_ONCE: usize = 256 << 10;

/// The longest of them with what a ticket begins with.
const BEGINNING: usize = BEFORE[1].len() + 1 + TICKET.len();

/// A ticket's number and the quote behind it are no longer than this.
const LONGEST_NUMBER: usize = 21;

impl Prepared {
    /// Keeps a text, and gives its ticket.
    pub(super) fn keep(&self, text: Text) -> Value {
        Value::String(self.put(text))
    }

    /// The same, for the parameters of a notification.
    pub(super) fn ticket(&self, json: String) -> String {
        self.put(Text {
            json,
            _on_its_way: None,
        })
    }

    fn put(&self, text: Text) -> String {
        let mut waiting = self.waiting();
        waiting.last += 1;
        let number = waiting.last;
        waiting.texts.insert(number, text);
        format!("{TICKET}{number}")
    }

    fn take(&self, number: u64) -> Option<Text> {
        self.waiting().texts.remove(&number)
    }

    fn waiting(&self) -> std::sync::MutexGuard<'_, Waiting> {
        self.waiting.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// The output, with texts in the place of their tickets. What the framework writes is framed; the beginning of each body is
/// looked at, all else passes.
pub(crate) struct Outlet<O> {
    output: Pin<Box<O>>,
    prepared: Arc<Prepared>,
    state: State,
    /// Of a message the header, and so much of its body that it shows whether it is a ticket.
    held: Vec<u8>,
    /// What is to be written before all else, of the first piece what is behind `written`. A text is a piece as it was
    /// given: it may be large.
    ahead: VecDeque<Vec<u8>>,
    written: usize,
}

#[derive(Debug, Clone, Copy)]
enum State {
    Header,
    /// Behind a header of `header` bytes, at the beginning of a body of `length`.
    Beginning {
        header: usize,
        length: usize,
    },
    /// This many bytes of a body are to come.
    Rest(usize),
}

impl<O: AsyncWrite> Outlet<O> {
    pub(crate) fn new(output: O, prepared: Arc<Prepared>) -> Self {
        Outlet {
            output: Box::pin(output),
            prepared,
            state: State::Header,
            held: Vec::new(),
            ahead: VecDeque::new(),
            written: 0,
        }
    }

    /// Takes bytes of a header, or of the beginning of a body; how many.
    fn hold(&mut self, bytes: &[u8]) -> usize {
        let mut taken = 0;
        while let State::Header = self.state {
            let Some(&byte) = bytes.get(taken) else {
                return taken;
            };
            taken += 1;
            self.held.push(byte);
            if self.held.ends_with(b"\r\n\r\n") {
                self.state = match length_in(&self.held) {
                    Some(length) => State::Beginning {
                        header: self.held.len(),
                        length,
                    },
                    None => State::Rest(usize::MAX),
                };
            }
        }
        if let State::Beginning { header, length } = self.state {
            let looked_at = length.min(BEGINNING + LONGEST_NUMBER);
            let missing = (header + looked_at - self.held.len()).min(bytes.len() - taken);
            self.held.extend_from_slice(&bytes[taken..taken + missing]);
            taken += missing;
            if self.held.len() < header + looked_at {
                return taken;
            }
            self.exchange(header, length);
            self.state = match length - looked_at {
                0 => State::Header,
                rest => State::Rest(rest),
            };
        } else {
            self.ahead.push_back(std::mem::take(&mut self.held));
        }
        self.held.clear();
        taken
    }

    /// Puts what is held ahead of all else, with the text if it is a ticket.
    fn exchange(&mut self, header: usize, length: usize) {
        let body = &self.held[header..];
        let ticket = ticket_in(body);
        match ticket.and_then(|ticket| Some((self.prepared.take(ticket.number)?, ticket))) {
            Some((Text { json: text, .. }, Ticket { start, end, .. })) => {
                let length = length - (end - start) + text.len();
                let mut before = format!("Content-Length: {length}\r\n\r\n").into_bytes();
                before.extend_from_slice(&body[..start]);
                let behind = body[end..].to_vec();
                self.ahead.extend([before, text.into_bytes(), behind]);
            }
            None => self.ahead.push_back(std::mem::take(&mut self.held)),
        }
    }

    fn poll_ahead(&mut self, cx: &mut Context<'_>) -> Poll<io::Result<()>> {
        while let Some(piece) = self.ahead.front() {
            let rest = &piece[self.written..];
            if rest.is_empty() {
                self.ahead.pop_front();
                self.written = 0;
                continue;
            }
            // Standard output copies what it is given, and keeps room for as much.
            let rest = &rest[..rest.len().min(AT_ONCE)];
            match ready!(self.output.as_mut().poll_write(cx, rest))? {
                0 => return Poll::Ready(Err(io::ErrorKind::WriteZero.into())),
                written => self.written += written,
            }
        }
        Poll::Ready(Ok(()))
    }
}

impl<O: AsyncWrite> AsyncWrite for Outlet<O> {
    fn poll_write(mut self: Pin<&mut Self>, cx: &mut Context<'_>, bytes: &[u8]) -> Poll<io::Result<usize>> {
        ready!(self.poll_ahead(cx))?;
        let State::Rest(rest) = self.state else {
            return Poll::Ready(Ok(self.hold(bytes)));
        };
        let now = &bytes[..rest.min(bytes.len()).min(AT_ONCE)];
        let written = ready!(self.output.as_mut().poll_write(cx, now))?;
        self.state = match rest - written {
            0 => State::Header,
            rest => State::Rest(rest),
        };
        Poll::Ready(Ok(written))
    }

    fn poll_flush(mut self: Pin<&mut Self>, cx: &mut Context<'_>) -> Poll<io::Result<()>> {
        ready!(self.poll_ahead(cx))?;
        self.output.as_mut().poll_flush(cx)
    }

    fn poll_shutdown(mut self: Pin<&mut Self>, cx: &mut Context<'_>) -> Poll<io::Result<()>> {
        ready!(self.poll_ahead(cx))?;
        self.output.as_mut().poll_shutdown(cx)
    }
}

/// The length that a header announces.
fn length_in(header: &[u8]) -> Option<usize> {
    let header = std::str::from_utf8(header).ok()?;
    let mut lines = header.split("\r\n");
    lines.find_map(|line| line.strip_prefix("Content-Length:")?.trim().parse().ok())
}

/// A ticket, and where in a body it starts and ends with its quotes.
struct Ticket {
    number: u64,
    start: usize,
    end: usize,
}

/// The ticket that a body begins with.
fn ticket_in(body: &[u8]) -> Option<Ticket> {
    let start = BEFORE.iter().find(|before| body.starts_with(before))?.len();
    let rest = body[start..]
        .strip_prefix(b"\"")?
        .strip_prefix(TICKET.as_bytes())?;
    let digits = rest.iter().take_while(|byte| byte.is_ascii_digit()).count();
    (rest.get(digits) == Some(&b'"')).then_some(())?;
    Some(Ticket {
        number: std::str::from_utf8(&rest[..digits]).ok()?.parse().ok()?,
        start,
        end: start + 1 + TICKET.len() + digits + 1,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use tokio::io::AsyncWriteExt;

    fn frame(body: &str) -> String {
        format!("Content-Length: {}\r\n\r\n{body}", body.len())
    }

    fn answer_with(result: &str, id: &str) -> String {
        frame(&format!(r#"{{"jsonrpc":"2.0","result":{result},"id":{id}}}"#))
    }

    fn diagnostics_with(params: &str) -> String {
        frame(&format!(
            r#"{{"jsonrpc":"2.0","method":"textDocument/publishDiagnostics","params":{params}}}"#
        ))
    }

    proptest! {
        /// However the framework cuts what it writes, and however little the output takes at once.
        #[test]
        fn each_text_stands_in_the_place_of_its_ticket(
            messages in prop::collection::vec((0..5_usize, 0..200_usize), 1..8),
            cut in 1..90_usize,
            room in 1..300_usize,
        ) {
            let prepared = Arc::new(Prepared::default());
            let (mut given, mut expected) = (String::new(), String::new());
            for (kind, length) in messages {
                let text = format!("[{:?}]", "ä".repeat(length));
                let id = format!("{:?}", "7".repeat(length));
                match kind {
                    0 => {
                        let ticket = Value::String(prepared.ticket(text.clone())).to_string();
                        given += &answer_with(&ticket, &id);
                        expected += &answer_with(&text, &id);
                    }
                    // A ticket that nobody has given is a text like any other.
                    1 => {
                        let unknown = format!("\"{TICKET}{}\"", 99_999);
                        given += &answer_with(&unknown, &id);
                        expected += &answer_with(&unknown, &id);
                    }
                    2 => {
                        given += &answer_with(&text, "1");
                        expected += &answer_with(&text, "1");
                    }
                    3 => {
                        let ticket = Value::String(prepared.ticket(text.clone())).to_string();
                        given += &diagnostics_with(&ticket);
                        expected += &diagnostics_with(&text);
                    }
                    _ => {
                        given += &frame("{}");
                        expected += &frame("{}");
                    }
                }
            }
            let runtime = tokio::runtime::Builder::new_current_thread().build().unwrap();
            let written = runtime.block_on(async {
                let (output, mut input) = tokio::io::duplex(room);
                let mut outlet = Outlet::new(output, prepared);
                let write = async {
                    for piece in given.as_bytes().chunks(cut) {
                        outlet.write_all(piece).await.unwrap();
                    }
                    outlet.shutdown().await.unwrap();
                };
                let mut written = Vec::new();
                let read = tokio::io::AsyncReadExt::read_to_end(&mut input, &mut written);
                let ((), read) = tokio::join!(write, read);
                read.unwrap();
                written
            });
            prop_assert_eq!(String::from_utf8(written).unwrap(), expected);
        }
    }
}

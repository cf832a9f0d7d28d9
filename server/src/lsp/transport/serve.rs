//! One session, from the first byte to the end.

use std::fmt::Write as _;
use std::time::Duration;

use futures::{SinkExt, StreamExt};
use serde::Serialize;
use serde_json::value::RawValue;
use tokio::io::{AsyncRead, AsyncWrite, AsyncWriteExt};
use tokio::sync::mpsc;
use tower_lsp::LspService;
use tower_lsp::jsonrpc::{Id, Response};

use super::answered::Left;
use super::guard::Guard;
use super::received::{Received, receive};
use crate::busy::Busy;
use crate::lsp::backend::Backend;

/// Handlers that run at once. Four of them, the framework's own limit, are soon all waiting for something.
const CONCURRENCY: usize = 64;

/// Requests that may wait for a handler.
const WAITING: usize = 100;

/// How long answers that are under way may take after `exit`.
const GRACE: Duration = Duration::from_millis(500);

/// How a session ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ending {
    /// The client asked for `shutdown` first.
    Clean,
    /// It did not: `exit` alone, the end of the input, or the death of the client's process.
    Abrupt,
}

/// Serves one client until it says `exit`, its input ends, or its process dies. The input need not end for the
/// session to: some editors keep it open and wait for the server to go.
pub async fn serve<I, O>(input: I, output: O) -> Ending
where
    I: AsyncRead + Send + Unpin + 'static,
    O: AsyncWrite,
{
    serve_counting(input, output, Busy::default()).await
}

/// As [`serve`], and shows whether work is under way.
pub(crate) async fn serve_counting<I, O>(input: I, output: O, busy: Busy) -> Ending
where
    I: AsyncRead + Send + Unpin + 'static,
    O: AsyncWrite,
{
    let (service, socket) = LspService::build(|client| Backend::counting(client, busy))
        .custom_method("textDocument/rangesFormatting", Backend::ranges_formatting)
        .custom_method("ladder/simulationShown", Backend::simulation_shown)
        .custom_method("ladder/toDebugger", Backend::to_debugger)
        .finish();
    let shared = service.inner().shared();
    let mut guard = Guard::new(service, shared.outbox.clone());
    let life = guard.life();
    let (mut questions, mut answers_of_client) = socket.split();

    let (messages, mut received) = mpsc::channel(1);
    let reader = tokio::spawn(receive(input, messages));
    // All that is written goes through one channel: what was put into it first comes first.
    let (out, mut written) = mpsc::channel::<String>(1);
    let (mut handlers, waiting) = futures::channel::mpsc::channel(WAITING);
    let dispatch = async move {
        while let Some(message) = received.recv().await {
            let handler = match message {
                Received::Request(request) => {
                    if guard.ready().await.is_err() {
                        return;
                    }
                    guard.call(request)
                }
                Received::Broken(answer) => Box::pin(std::future::ready((Some(answer), Left::default()))),
                Received::Answer(answer) => {
                    let _ = answers_of_client.send(answer).await;
                    continue;
                }
            };
            let _ = handlers.send(handler).await;
        }
    };
    let answers = out.clone();
    let answer = waiting
        .buffer_unordered(CONCURRENCY)
        .for_each(move |(answer, Left { place, text })| {
            let out = answers.clone();
            async move {
                if let Some(answer) = answer {
                    let frame = match &text {
                        Some(result) if answer.is_ok() => framed(&AsText::of(&answer, result)),
                        _ => framed(&answer),
                    };
                    // The writer is gone only when the client is.
                    let _ = out.send(frame).await;
                }
                drop(place);
            }
        });
    let ask = async move {
        while let Some(question) = questions.next().await {
            let _ = out.send(framed(&question)).await;
        }
        std::future::pending::<()>().await;
    };
    // When there is nothing more to answer, nothing is asked either.
    let talk = async {
        tokio::select! {
            _ = futures::future::join(dispatch, answer) => {}
            () = ask => {}
        }
    };
    let write = async {
        tokio::pin!(output);
        while let Some(frame) = written.recv().await {
            if output.write_all(frame.as_bytes()).await.is_err() || output.flush().await.is_err() {
                return;
            }
        }
    };
    let server = futures::future::join(talk, write);
    let exit = async {
        life.exited().await;
        tokio::time::sleep(GRACE).await;
    };
    tokio::select! {
        _ = server => {}
        () = exit => {}
        () = shared.orphaned.notified() => {}
    }
    reader.abort();
    shared.sessions.stop_everything().await;
    if life.is_shut_down() {
        Ending::Clean
    } else {
        Ending::Abrupt
    }
}

/// An answer whose result is a text already.
#[derive(Serialize)]
struct AsText<'a> {
    jsonrpc: &'static str,
    result: &'a RawValue,
    id: &'a Id,
}

impl<'a> AsText<'a> {
    fn of(answer: &'a Response, result: &'a RawValue) -> Self {
        AsText {
            jsonrpc: "2.0",
            result,
            id: answer.id(),
        }
    }
}

/// A message as it is written.
fn framed(message: &impl Serialize) -> String {
    // What the framework gives has texts as its keys, and no numbers that JSON does not have.
    let json = serde_json::to_string(message).unwrap_or_default();
    let mut frame = String::with_capacity(json.len() + 40);
    let _ = write!(frame, "Content-Length: {}\r\n\r\n{json}", json.len());
    frame
}

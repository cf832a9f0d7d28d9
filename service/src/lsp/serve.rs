//! One session, from the first message to the end.

use std::pin::pin;
use std::sync::Arc;
use std::time::Duration;

use futures::channel::mpsc::{Sender, channel};
use futures::future::{Either, select};
use futures::{SinkExt, Stream, StreamExt};
use ladder_host::{Busy, Host};
use serde::Serialize;
use serde_json::value::RawValue;
use tower_lsp::LspService;
use tower_lsp::jsonrpc::{Id, Response};

use super::transport::answered::Left;
use super::transport::guard::Guard;
use super::transport::received::{Kind, Received};
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

/// The end of a session.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Ended {
    /// How it ended.
    pub ending: Ending,
    /// Whether there are no more messages to answer: what was reported last is still for the client to read.
    pub all_is_said: bool,
}

/// Serves one client until it says `exit`, there are no more messages, or its process dies. There may be more messages, and
/// the session ends nevertheless: some editors go on and wait for the server to go.
///
/// What it says goes out as JSON, a message at a time. `busy` shows whether work is under way that nobody asked for.
pub async fn serve(
    host: Arc<dyn Host>,
    messages: impl Stream<Item = Received> + Send,
    out: Sender<String>,
    busy: Busy,
) -> Ended {
    let (service, socket) = LspService::build(|client| Backend::new(client, host.clone(), busy))
        .custom_method("textDocument/rangesFormatting", Backend::ranges_formatting)
        .custom_method("ladder/simulationShown", Backend::simulation_shown)
        .custom_method("ladder/toDebugger", Backend::to_debugger)
        .finish();
    let shared = service.inner().shared();
    let mut guard = Guard::new(service, shared.outbox.clone());
    let life = guard.life();
    let (mut questions, mut answers_of_client) = socket.split();

    let (mut handlers, waiting) = channel(WAITING);
    let dispatch = async move {
        let mut messages = pin!(messages);
        while let Some(Received(message)) = messages.next().await {
            let handler = match message {
                Kind::Request(request) => {
                    if guard.ready().await.is_err() {
                        return;
                    }
                    guard.call(request)
                }
                Kind::Broken(answer) => Box::pin(std::future::ready((Some(answer), Left::default()))),
                Kind::Answer(answer) => {
                    let _ = answers_of_client.send(answer).await;
                    continue;
                }
            };
            let _ = handlers.send(handler).await;
        }
    };
    // All that is reported goes through one channel: what was put into it first comes first.
    let mut answers = out.clone();
    let answer = async move {
        let mut done = pin!(waiting.buffer_unordered(CONCURRENCY));
        while let Some((answer, Left { place, text })) = done.next().await {
            if let Some(answer) = answer {
                let json = match &text {
                    Some(result) if answer.is_ok() => json(&AsText::of(&answer, result)),
                    _ => json(&answer),
                };
                // Nobody reads it only when the client is gone.
                let _ = answers.send(json).await;
            }
            drop(place);
        }
    };
    let mut asked = out;
    let ask = async move {
        while let Some(question) = questions.next().await {
            let _ = asked.send(json(&question)).await;
        }
        std::future::pending::<()>().await;
    };
    // When there is nothing more to answer, nothing is asked either.
    let answering = pin!(futures::future::join(dispatch, answer));
    let asking = pin!(ask);
    let exit = pin!(async {
        life.exited().await;
        host.sleep(GRACE).await;
    });
    let orphaned = pin!(shared.orphaned.given());
    let stopped = select(exit, orphaned);
    let all_is_said = matches!(select(select(answering, asking), stopped).await, Either::Left(_));
    shared.sessions.stop_everything(&*host).await;
    Ended {
        ending: if life.is_shut_down() {
            Ending::Clean
        } else {
            Ending::Abrupt
        },
        all_is_said,
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

/// A message as it is sent.
fn json(message: &impl Serialize) -> String {
    // What comes from the framework has texts as its keys, and no numbers that JSON does not have.
    serde_json::to_string(message).unwrap_or_default()
}

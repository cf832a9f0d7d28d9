//! The framework's service, with what it leaves open.
//!
//! - A panic in a handler answers its request with -32603, and the server lives on.
//! - `initialize` and `shutdown` are answered before the next message is taken up, so that a client that does not wait (a
//!   script, a replayed session) loses nothing.
//! - `shutdown` and `exit` are recorded: [`Life`] knows how the process is to end, also while the client keeps the input
//!   open.
//! - A request for a method of the protocol itself (`$/..`) is answered with -32601.
//! - A notification with parameters that make no sense is logged (see [`misread`](super::misread)).

use std::future::{Future, poll_fn};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::{Arc, Mutex, PoisonError};
use std::task::{Poll, Waker};

use futures::FutureExt;
use futures::future::BoxFuture;
use serde_json::json;
use tower::Service;
use tower_lsp::ExitedError;
use tower_lsp::jsonrpc::{Error, Request, Response};

use super::answered::{Left, handle};
use super::blocking::internal_error;
use super::misread::misread;
use crate::lsp::session::outbox::Outbox;
use crate::signal::Signal;

/// The state of the session.
#[derive(Debug, Default)]
pub(crate) struct Life {
    state: Mutex<State>,
    exit: Signal,
}

#[derive(Debug, Default)]
struct State {
    /// A message is being answered that everything after it has to wait for.
    barrier: bool,
    waiting: Option<Waker>,
    shutdown: bool,
}

impl Life {
    /// Resolves when the client has sent `exit`.
    pub(crate) async fn exited(&self) {
        self.exit.given().await;
    }

    /// Whether the client has asked for the shutdown, which is what makes an exit a clean one.
    pub(crate) fn is_shut_down(&self) -> bool {
        self.state().shutdown
    }

    fn state(&self) -> std::sync::MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// The service. See the module.
pub(crate) struct Guard<S> {
    inner: S,
    life: Arc<Life>,
    outbox: Outbox,
}

/// An answer, if there is one, and what its handler has left.
pub(crate) type Answer = (Option<Response>, Left);

impl<S> Guard<S>
where
    S: Service<Request, Response = Option<Response>, Error = ExitedError>,
    S::Future: Send + 'static,
{
    pub(crate) fn new(inner: S, outbox: Outbox) -> Self {
        Guard {
            inner,
            life: Arc::default(),
            outbox,
        }
    }

    pub(crate) fn life(&self) -> Arc<Life> {
        self.life.clone()
    }

    /// Waits until the next message can be taken up; an error after `exit`.
    pub(crate) fn ready(&mut self) -> impl Future<Output = Result<(), ExitedError>> {
        poll_fn(|cx| {
            let mut state = self.life.state();
            if state.barrier {
                state.waiting = Some(cx.waker().clone());
                return Poll::Pending;
            }
            drop(state);
            self.inner.poll_ready(cx)
        })
    }

    /// Takes up a message. Handlers run in the order of their messages up to their first `await`.
    pub(crate) fn call(&mut self, request: Request) -> BoxFuture<'static, Answer> {
        let id = request.id().cloned();
        if id.is_none()
            && let Some(problem) = misread(&request)
        {
            self.outbox.log(problem);
            return futures::future::ready((None, Left::default())).boxed();
        }
        // The framework leaves such a request without an answer; LSP wants this one.
        if let Some(id) = &id
            && request.method().starts_with("$/")
        {
            let answer = Response::from_error(id.clone(), Error::method_not_found());
            return futures::future::ready((Some(answer), Left::default())).boxed();
        }
        let step = match request.method() {
            "exit" => {
                self.life.exit.give();
                LifeStage::Other
            }
            "initialize" => LifeStage::Initialize,
            "shutdown" => LifeStage::Shutdown,
            _ => LifeStage::Other,
        };
        let request = if step == LifeStage::Shutdown {
            without_params(request)
        } else {
            request
        };
        let lift = (step != LifeStage::Other).then(|| Barrier::raise(&self.life));
        let life = self.life.clone();
        let call = catch_unwind(AssertUnwindSafe(|| self.inner.call(request)));
        async move {
            let _lift = lift;
            let (outcome, left) = match call {
                Ok(future) => handle(AssertUnwindSafe(future).catch_unwind()).await,
                Err(panic) => (Err(panic), Left::default()),
            };
            let answer = match outcome {
                // After `exit` nothing is answered.
                Ok(answer) => answer.unwrap_or_default(),
                Err(panic) => id.map(|id| Response::from_error(id, internal_error(panic.as_ref()))),
            };
            if step == LifeStage::Shutdown && answer.as_ref().is_some_and(Response::is_ok) {
                life.state().shutdown = true;
            }
            let answer = match step {
                LifeStage::Initialize => answer.map(with_newer_capabilities),
                _ => answer,
            };
            (answer, left)
        }
        .boxed()
    }
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum LifeStage {
    Initialize,
    Shutdown,
    Other,
}

/// The answer of `initialize` with what the framework's types do not know yet: several ranges can be formatted at once (3.18).
fn with_newer_capabilities(answer: Response) -> Response {
    let (id, mut body) = answer.into_parts();
    let ranges = body.as_mut().ok();
    let ranges =
        ranges.and_then(|result| result.pointer_mut("/capabilities/documentRangeFormattingProvider"));
    if let Some(provider) = ranges {
        *provider = json!({ "rangesSupport": true });
    }
    Response::from_parts(id, body)
}

/// Keeps later messages waiting until it is dropped, also by a panic or a cancellation.
struct Barrier(Arc<Life>);

impl Barrier {
    fn raise(life: &Arc<Life>) -> Self {
        life.state().barrier = true;
        Barrier(life.clone())
    }
}

impl Drop for Barrier {
    fn drop(&mut self) {
        let mut state = self.0.state();
        state.barrier = false;
        if let Some(waker) = state.waiting.take() {
            waker.wake();
        }
    }
}

/// Some clients send `"params": {}` with `shutdown`, which takes none.
fn without_params(request: Request) -> Request {
    let (method, id, _) = request.into_parts();
    let builder = Request::build(method);
    match id {
        Some(id) => builder.id(id).finish(),
        None => builder.finish(),
    }
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use serde_json::Value;
    use tower_lsp::ls_types::{Hover, HoverParams, InitializeParams, InitializeResult};
    use tower_lsp::{LanguageServer, LspService, jsonrpc};

    use super::*;
    use ladder_host::testing::TestHost;
    use ladder_host::{EventLoop, Host};

    /// A server that panics in its handlers.
    struct Faulty(Arc<EventLoop>);

    impl LanguageServer for Faulty {
        async fn initialize(&self, _: InitializeParams) -> jsonrpc::Result<InitializeResult> {
            self.0.sleep(Duration::from_millis(20)).await;
            Ok(InitializeResult::default())
        }

        async fn shutdown(&self) -> jsonrpc::Result<()> {
            Ok(())
        }

        async fn hover(&self, params: HoverParams) -> jsonrpc::Result<Option<Hover>> {
            assert_ne!(params.text_document_position_params.position.line, 7, "planted");
            self.0.sleep(Duration::ZERO).await;
            assert_ne!(
                params.text_document_position_params.position.line, 8,
                "planted too"
            );
            Ok(None)
        }
    }

    fn guarded(host: &Arc<EventLoop>) -> Guard<LspService<Faulty>> {
        let mut outbox = None;
        let (service, socket) = LspService::new(|client| {
            outbox = Some(Outbox::open(client, &**host, ladder_host::Busy::default()));
            Faulty(host.clone())
        });
        // The loopback has to live, or sending fails.
        std::mem::forget(socket);
        Guard::new(service, outbox.unwrap())
    }

    async fn call(guard: &mut Guard<LspService<Faulty>>, message: Value) -> Option<Value> {
        let request = serde_json::from_value(message).unwrap();
        guard.ready().await.unwrap();
        let (answer, _) = guard.call(request).await;
        answer.map(|answer| serde_json::to_value(answer).unwrap())
    }

    fn hover(id: u32, line: u32) -> Value {
        let params = json!({
            "textDocument": {"uri": "file:///a.clad"},
            "position": {"line": line, "character": 0}
        });
        json!({"jsonrpc": "2.0", "id": id, "method": "textDocument/hover", "params": params})
    }

    fn initialize() -> Value {
        json!({"jsonrpc": "2.0", "id": 0, "method": "initialize", "params": {"capabilities": {}}})
    }

    #[test]
    fn a_panicking_handler_answers_and_the_server_lives_on() {
        let test = TestHost::default();
        let host = &test.host;
        test.run(async {
            let mut guard = guarded(host);
            call(&mut guard, initialize()).await;
            for (id, line, words) in [(1, 7, "planted"), (2, 8, "planted too")] {
                let answer = call(&mut guard, hover(id, line)).await.unwrap();
                assert_eq!(answer["id"], id);
                assert_eq!(answer["error"]["code"], -32603);
                assert!(
                    answer["error"]["message"].as_str().unwrap().contains(words),
                    "{answer}"
                );
            }
            let answer = call(&mut guard, hover(3, 1)).await.unwrap();
            assert_eq!(answer, json!({"jsonrpc": "2.0", "id": 3, "result": null}));
        });
    }

    #[test]
    fn what_comes_after_initialize_waits_for_it() {
        let test = TestHost::default();
        let host = &test.host;
        test.run(async {
            let mut guard = guarded(host);
            let request = serde_json::from_value(initialize()).unwrap();
            guard.ready().await.unwrap();
            let first = guard.call(request);
            let (done, first_done) = futures::channel::oneshot::channel();
            host.spawn(Box::pin(async move {
                let _ = done.send(first.await.0.is_some());
            }));
            // Without the barrier this is answered with "not initialized".
            let answer = call(&mut guard, hover(1, 1)).await.unwrap();
            assert_eq!(answer["result"], Value::Null, "{answer}");
            assert_eq!(answer.get("error"), None);
            assert_eq!(first_done.await, Ok(true));
        });
    }

    #[test]
    fn shutdown_is_recorded_when_it_was_granted() {
        let test = TestHost::default();
        let host = &test.host;
        test.run(async {
            let shutdown = || json!({"jsonrpc": "2.0", "id": 1, "method": "shutdown", "params": {}});
            let mut guard = guarded(host);
            let answer = call(&mut guard, shutdown()).await.unwrap();
            assert_eq!(answer["error"]["code"], -32002);
            assert!(!guard.life().is_shut_down());
            call(&mut guard, initialize()).await;
            assert_eq!(call(&mut guard, shutdown()).await.unwrap()["result"], Value::Null);
            assert!(guard.life().is_shut_down());
            call(&mut guard, json!({"jsonrpc": "2.0", "method": "exit"})).await;
            guard.life().exited().await;
        });
    }
}

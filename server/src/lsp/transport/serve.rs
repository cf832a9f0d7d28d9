//! One session, from the first byte to the end.

use std::time::Duration;

use tokio::io::{AsyncRead, AsyncWrite};
use tower_lsp::{LspService, Server};

use super::{guard::Guard, inlet, prepared::Outlet};
use crate::busy::Busy;
use crate::lsp::backend::Backend;

/// Handlers that run at once. Four of them, the framework's own limit, are soon all waiting for something.
const CONCURRENCY: usize = 64;

/// Bytes between the [`inlet`] and the framework.
const PIPE: usize = 64 << 10;

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
        .finish();
    let shared = service.inner().shared();
    let guard = Guard::new(service, shared.outbox.clone());
    let life = guard.life();
    let outlet = Outlet::new(output, guard.prepared());

    let (to_framework, from_client) = tokio::io::duplex(PIPE);
    let reader = tokio::spawn(inlet::feed(input, to_framework, guard.long_texts()));
    let server = Server::new(from_client, outlet, socket)
        .concurrency_level(CONCURRENCY)
        .serve(guard);
    let exit = async {
        life.exited().await;
        tokio::time::sleep(GRACE).await;
    };
    tokio::select! {
        () = server => {}
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

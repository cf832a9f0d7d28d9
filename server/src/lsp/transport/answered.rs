//! When the answer to a request has its place in what is written.

use std::cell::Cell;
use std::future::Future;

use tokio::sync::oneshot;

/// Dropped when an answer has its place, or will never have one.
pub(crate) type Place = oneshot::Sender<()>;

tokio::task_local! {
    /// What the handler of a request waits for.
    static AWAITED: Cell<Option<Place>>;
}

/// Resolves when the answer to the request that is being handled has its place: what is sent from then on comes after it.
/// To be called by the handler itself, not by a task that it has spawned.
pub(crate) fn answered() -> impl Future<Output = ()> + use<> {
    let (place, taken) = oneshot::channel();
    // Outside of a session, as in tests, there is nothing to wait for.
    let _ = AWAITED.try_with(|awaited| awaited.set(Some(place)));
    async {
        // Nothing is sent from the other end; it is dropped.
        let _ = taken.await;
    }
}

/// Runs a handler; with its outcome comes what it waits for.
pub(super) async fn handle<F: Future>(handler: F) -> (F::Output, Option<Place>) {
    let run = async {
        let outcome = handler.await;
        (outcome, AWAITED.with(Cell::take))
    };
    AWAITED.scope(Cell::new(None), run).await
}

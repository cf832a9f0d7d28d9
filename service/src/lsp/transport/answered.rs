//! What becomes of the answer of a handler: when it has its place in what is written, and large ones as text.

use std::cell::RefCell;
use std::future::{Future, poll_fn};
use std::pin::pin;

use futures::channel::oneshot;
use serde::Serialize;
use serde_json::value::{RawValue, to_raw_value};

/// Dropped when an answer has its place, or will never have one.
pub(crate) type Place = oneshot::Sender<()>;

/// What a handler leaves next to its answer.
#[derive(Default)]
pub(crate) struct Left {
    /// What waits for the answer to have its place.
    pub(crate) place: Option<Place>,
    /// The result, already as text.
    pub(crate) text: Option<Box<RawValue>>,
}

thread_local! {
    /// What the handler that is polled now has left. Nothing outside of a session, as in tests.
    static LEFT: RefCell<Option<Left>> = const { RefCell::new(None) };
}

/// Changes what is left; false outside of a session, where nothing would take it.
fn leave(change: impl FnOnce(&mut Left)) -> bool {
    LEFT.with_borrow_mut(|left| left.as_mut().map(change).is_some())
}

/// Resolves when the answer to the request that is being handled has its place: what is sent from then on comes after it.
/// To be called by the handler itself, not by a task that it has spawned.
pub(crate) fn answered() -> impl Future<Output = ()> + use<> {
    let (place, taken) = oneshot::channel();
    leave(|left| left.place = Some(place));
    async {
        // Nothing is sent from the other end; it is dropped.
        let _ = taken.await;
    }
}

/// For an answer of megabytes: its text is made here, because the framework would make a tree of values of it first, which
/// takes four times as long. To be called by the handler itself.
pub(crate) fn as_text<T: Serialize>(answer: Option<T>) -> Option<T> {
    let text = to_raw_value(&answer).ok();
    let is_text = text.is_some() && leave(|left| left.text = text);
    answer.filter(|_| !is_text)
}

/// Runs a handler; with its outcome comes what it leaves. It must not panic while it is polled.
pub(super) async fn handle<F: Future>(handler: F) -> (F::Output, Left) {
    let mut handler = pin!(handler);
    let mut left = Left::default();
    // Handlers take turns on their threads: what one leaves is there only while it is polled.
    let outcome = poll_fn(|cx| {
        let before = LEFT.replace(Some(std::mem::take(&mut left)));
        let polled = handler.as_mut().poll(cx);
        left = LEFT.replace(before).unwrap_or_default();
        polled
    })
    .await;
    (outcome, left)
}

//! A value that is replaced now and then, and one who wants to see the newest.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::task::{Poll, Waker};

/// The end that replaces the value.
#[derive(Debug)]
pub struct Sender<T>(Arc<Mutex<Slot<T>>>);

/// The end that sees it.
#[derive(Debug)]
pub struct Receiver<T>(Arc<Mutex<Slot<T>>>);

#[derive(Debug)]
struct Slot<T> {
    value: T,
    is_new: bool,
    is_last: bool,
    waiting: Option<Waker>,
}

/// Both ends, with a value that is new to nobody.
pub fn newest<T>(value: T) -> (Sender<T>, Receiver<T>) {
    let slot = Arc::new(Mutex::new(Slot {
        value,
        is_new: false,
        is_last: false,
        waiting: None,
    }));
    (Sender(slot.clone()), Receiver(slot))
}

impl<T> Sender<T> {
    /// Replaces the value.
    pub fn send(&self, value: T) {
        let mut slot = lock(&self.0);
        (slot.value, slot.is_new) = (value, true);
        wake(slot);
    }
}

impl<T> Drop for Sender<T> {
    fn drop(&mut self) {
        let mut slot = lock(&self.0);
        slot.is_last = true;
        wake(slot);
    }
}

impl<T: Clone> Receiver<T> {
    /// The value as it is now, which is not new any more.
    pub fn get(&self) -> T {
        let mut slot = lock(&self.0);
        slot.is_new = false;
        slot.value.clone()
    }

    /// The newest value, once there is one that was not seen; none when nobody will replace it any more.
    pub async fn next(&mut self) -> Option<T> {
        std::future::poll_fn(|cx| {
            let mut slot = lock(&self.0);
            if std::mem::take(&mut slot.is_new) {
                return Poll::Ready(Some(slot.value.clone()));
            }
            if slot.is_last {
                return Poll::Ready(None);
            }
            slot.waiting = Some(cx.waker().clone());
            Poll::Pending
        })
        .await
    }
}

fn lock<T>(slot: &Mutex<Slot<T>>) -> MutexGuard<'_, Slot<T>> {
    slot.lock().unwrap_or_else(PoisonError::into_inner)
}

fn wake<T>(mut slot: MutexGuard<'_, Slot<T>>) {
    let waiting = slot.waiting.take();
    drop(slot);
    if let Some(waker) = waiting {
        waker.wake();
    }
}

#[cfg(test)]
mod tests {
    use futures::FutureExt;

    use super::*;

    #[test]
    fn the_last_one_is_seen_and_those_before_it_are_not() {
        let (sender, mut receiver) = newest(0);
        assert_eq!(receiver.next().now_or_never(), None);
        sender.send(1);
        sender.send(2);
        assert_eq!(receiver.next().now_or_never(), Some(Some(2)));
        assert_eq!(receiver.next().now_or_never(), None);
        sender.send(3);
        drop(sender);
        assert_eq!(receiver.next().now_or_never(), Some(Some(3)));
        assert_eq!(receiver.next().now_or_never(), Some(None));
        assert_eq!(receiver.get(), 3);
    }
}

//! Something that happens once, and those who wait for it.

use std::sync::{Mutex, PoisonError};

use futures::FutureExt;
use futures::channel::oneshot;
use futures::future::Shared;

/// Something that happens once.
#[derive(Debug)]
pub(crate) struct Signal {
    /// None once it has happened.
    sender: Mutex<Option<oneshot::Sender<()>>>,
    happened: Shared<oneshot::Receiver<()>>,
}

impl Default for Signal {
    fn default() -> Self {
        let (sender, receiver) = oneshot::channel();
        Signal {
            sender: Mutex::new(Some(sender)),
            happened: receiver.shared(),
        }
    }
}

impl Signal {
    /// It happens.
    pub(crate) fn give(&self) {
        self.sender.lock().unwrap_or_else(PoisonError::into_inner).take();
    }

    /// Resolves when it has happened.
    pub(crate) fn given(&self) -> impl Future<Output = ()> + use<> {
        self.happened.clone().map(|_| ())
    }
}

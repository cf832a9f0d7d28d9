//! What all handlers share.

use std::sync::{Arc, OnceLock};

use tokio::sync::Notify;
use tower_lsp::Client;

use super::capabilities::Agreed;
use super::outbox::Outbox;
use crate::document::Documents;
use crate::document::neighbours::Neighbours;
use crate::simulation::Sessions;

/// The state of one session with one client.
#[derive(Debug)]
pub(super) struct Shared {
    agreed: OnceLock<Agreed>,
    pub(super) client: Client,
    pub(super) documents: Arc<Documents>,
    /// The files beside them.
    pub(super) neighbours: Arc<Neighbours>,
    pub(super) sessions: Sessions,
    pub(super) outbox: Outbox,
    /// Told when the process that started the server is gone.
    pub(super) orphaned: Notify,
}

impl Shared {
    pub(super) fn new(client: Client) -> Arc<Self> {
        let documents = Arc::<Documents>::default();
        Arc::new(Shared {
            agreed: OnceLock::new(),
            outbox: Outbox::open(client.clone(), documents.clone()),
            client,
            documents,
            neighbours: Arc::default(),
            sessions: Sessions::default(),
            orphaned: Notify::new(),
        })
    }

    /// Records what was agreed. The framework lets only one `initialize` through.
    pub(super) fn agree(&self, agreed: Agreed) {
        let _ = self.agreed.set(agreed);
    }

    /// What was agreed with the client; before that, the protocol's defaults.
    pub(super) fn agreed(&self) -> Agreed {
        self.agreed.get().copied().unwrap_or_default()
    }

    /// The text of a document is another one now: simulations of it say so.
    pub(super) fn text_moved(&self, uri: &str) {
        self.sessions.mark_stale(uri);
    }

    /// The document is gone from the editor, and with it the drawing that its simulations would show.
    pub(super) fn document_closed(&self, uri: &str) {
        self.sessions.stop_all_of(uri);
    }
}

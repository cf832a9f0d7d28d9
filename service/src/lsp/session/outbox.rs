//! What goes out without being asked for, in order.
//!
//! Sending to a client that is slow suspends, so no handler does it: a handler puts a note here and goes on, and
//! one task sends the notes in their order. Diagnostics are checked against the open documents at the last
//! moment: those of a text that the editor no longer shows are dropped.

use std::sync::Arc;

use futures::StreamExt;
use futures::channel::mpsc;
use ladder_documents::{Documents, Revision};
use ladder_host::{Busy, Host, Work};
use ladder_workspace::shown;
use tower_lsp::Client;
use tower_lsp::ls_types::notification::Notification;
use tower_lsp::ls_types::{Diagnostic, MessageType};

use super::previews::Previews;
use crate::lsp::convert;
use crate::notation::messages::Previewed;

/// The sending end. When the last one is dropped the task ends.
#[derive(Debug, Clone)]
pub(crate) struct Outbox {
    notes: mpsc::UnboundedSender<(Note, Work)>,
    busy: Busy,
}

#[derive(Debug)]
enum Note {
    Diagnostics(Arc<Documents>, Arc<Revision>, Vec<Diagnostic>),
    Preview(Arc<Documents>, Arc<Revision>, Arc<Previews>, Previewed),
    DiagnosticsOnDisk(String, Vec<Diagnostic>),
    Log(MessageType, String),
    Show(MessageType, String),
}

impl Outbox {
    /// Starts the task that sends.
    pub(crate) fn open(client: Client, host: &dyn Host, busy: Busy) -> Self {
        let (notes, inbox) = mpsc::unbounded();
        host.spawn(Box::pin(send(client, inbox)));
        Outbox { notes, busy }
    }

    /// Diagnostics of an open text, all of them.
    pub(crate) fn diagnostics(
        &self,
        documents: &Arc<Documents>,
        revision: Arc<Revision>,
        diagnostics: Vec<Diagnostic>,
    ) {
        self.note(Note::Diagnostics(documents.clone(), revision, diagnostics));
    }

    /// The ladder text that an open program of another system becomes; sent if it is another one than before.
    pub(crate) fn preview(
        &self,
        documents: &Arc<Documents>,
        revision: Arc<Revision>,
        previews: &Arc<Previews>,
        previewed: Previewed,
    ) {
        self.note(Note::Preview(
            documents.clone(),
            revision,
            previews.clone(),
            previewed,
        ));
    }

    /// Diagnostics of a file that is not open, all of them.
    pub(crate) fn diagnostics_on_disk(&self, uri: &str, diagnostics: Vec<Diagnostic>) {
        self.note(Note::DiagnosticsOnDisk(uri.to_owned(), diagnostics));
    }

    /// Takes the diagnostics of a closed document off the screen.
    pub(crate) fn no_diagnostics(&self, uri: &str) {
        self.diagnostics_on_disk(uri, Vec::new());
    }

    /// A line for the client's log.
    pub(crate) fn log(&self, message: impl Into<String>) {
        self.note(Note::Log(MessageType::WARNING, written_out(message)));
    }

    /// A message for the person at the screen.
    pub(crate) fn show(&self, message: impl Into<String>) {
        self.note(Note::Show(MessageType::WARNING, written_out(message)));
    }

    fn note(&self, note: Note) {
        // The task is gone only when the session is.
        let _ = self.notes.unbounded_send((note, self.busy.begin()));
    }
}

/// The notification with a program's ladder text.
#[derive(Debug)]
enum LadderPreview {}

impl Notification for LadderPreview {
    type Params = Previewed;
    const METHOD: &'static str = "ladder/preview";
}

/// A log may end on a terminal, and so may what others wrote in the message.
fn written_out(message: impl Into<String>) -> String {
    shown::text(&message.into()).into_owned()
}

async fn send(client: Client, mut inbox: mpsc::UnboundedReceiver<(Note, Work)>) {
    while let Some((note, work)) = inbox.next().await {
        match note {
            Note::Diagnostics(documents, revision, _) if !documents.is_current(&revision) => {}
            Note::Preview(documents, revision, previews, previewed) => {
                // What was not sent is news later: in this order.
                if documents.is_current(&revision) && previews.is_news(&previewed) {
                    client.send_notification::<LadderPreview>(previewed).await;
                }
            }
            Note::Diagnostics(_, revision, diagnostics) => {
                if let Some(uri) = convert::uri(&revision.uri) {
                    client
                        .publish_diagnostics(uri, diagnostics, Some(revision.version))
                        .await;
                }
            }
            Note::DiagnosticsOnDisk(uri, diagnostics) => {
                if let Some(uri) = convert::uri(&uri) {
                    client.publish_diagnostics(uri, diagnostics, None).await;
                }
            }
            Note::Log(level, message) => client.log_message(level, message).await,
            Note::Show(level, message) => client.show_message(level, message).await,
        }
        drop(work);
    }
}

#[cfg(test)]
mod tests {
    use futures::StreamExt;
    use serde_json::{Value, json};
    use tower::Service;
    use tower_lsp::ls_types::{InitializeParams, InitializeResult};
    use tower_lsp::{LanguageServer, LspService, jsonrpc};

    use super::*;
    use ladder_documents::position::Encoding;
    use ladder_host::testing::TestHost;

    struct Quiet;

    impl LanguageServer for Quiet {
        async fn initialize(&self, _: InitializeParams) -> jsonrpc::Result<InitializeResult> {
            Ok(InitializeResult::default())
        }

        async fn shutdown(&self) -> jsonrpc::Result<()> {
            Ok(())
        }
    }

    /// The session's own tests cannot make the client slow at the right moment; here nothing is sent until the
    /// notes are all there.
    #[test]
    fn diagnostics_of_a_text_that_is_no_longer_shown_are_not_sent() {
        let host = TestHost::default();
        host.run(open_close_and_open_again(&*host.host));
    }

    async fn open_close_and_open_again(host: &dyn Host) {
        let documents = Arc::<Documents>::default();
        let mut outbox = None;
        let (mut service, socket) = LspService::new(|client| {
            outbox = Some(Outbox::open(client, host, Busy::default()));
            Quiet
        });
        let initialize =
            json!({"jsonrpc": "2.0", "id": 1, "method": "initialize", "params": {"capabilities": {}}});
        service
            .call(serde_json::from_value(initialize).unwrap())
            .await
            .unwrap();
        let outbox = outbox.unwrap();

        let open = |version, text| documents.open("file:///a.clad", version, Encoding::Utf16, text);
        let first = open(1, "x");
        outbox.diagnostics(&documents, first.clone(), Vec::new());
        documents.close(&first.uri);
        outbox.no_diagnostics(&first.uri);
        let second = open(1, "y");
        outbox.diagnostics(&documents, first, Vec::new());
        let third = documents.change(&second.uri, 2, &[]).unwrap();
        outbox.diagnostics(&documents, second, Vec::new());
        outbox.diagnostics(&documents, third, Vec::new());
        drop(outbox);

        let sent: Vec<Value> = socket
            .take(2)
            .map(|request| request.params().unwrap()["version"].clone())
            .collect()
            .await;
        assert_eq!(sent, [Value::Null, json!(2)], "the clearing, and the newest");
    }
}

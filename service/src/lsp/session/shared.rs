//! What all handlers share.

use std::collections::{BTreeMap, HashMap};
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Arc, Mutex, OnceLock, PoisonError, RwLock};
use std::time::Duration;

use ladder_analysis::Exported;
use ladder_documents::neighbours::Neighbours;
use ladder_documents::on_disk::OnDisk;
use ladder_documents::{Documents, Kind, Revision};
use ladder_host::{Busy, Host, Moment, World, within};
use ladder_live::Sessions;
use ladder_workspace::EditorSettings;
use tower_lsp::Client;
use tower_lsp::ls_types::Diagnostic;

use super::agreed::Agreed;
use super::outbox::Outbox;
use super::previews::Previews;
use super::proofs::Proofs;
use super::tokens_sent::TokensSent;
use super::typing::Typed;
use crate::signal::Signal;

/// What was found in files that are not open, as long as they and what they see stay as they are.
type Found = Mutex<HashMap<PathBuf, (Arc<OnDisk>, Arc<Exported>, Arc<Vec<Diagnostic>>)>>;

/// What was sent of settings files to the client, by file: what was wrong in them last.
type Sent = Mutex<BTreeMap<PathBuf, Vec<Diagnostic>>>;

/// The state of one session with one client.
#[derive(Debug)]
pub(crate) struct Shared {
    agreed: OnceLock<Agreed>,
    /// What the editor's own settings say.
    editor: RwLock<Arc<EditorSettings>>,
    /// How often the client was asked for its settings, or sent them.
    editor_asked: AtomicU64,
    /// What was reported last about errors in them.
    settings_complaint: Mutex<String>,
    /// What was reported of settings files that are not open.
    pub(crate) settings_files: Sent,
    /// What was found in files that are not open.
    pub(crate) found: Found,
    /// Whether the client is about to be notified that diagnostics have changed.
    pub(crate) refresh_due: AtomicBool,
    /// When the files on disk were last checked for a client that does not report changes.
    pub(crate) looked_around: Mutex<Option<Moment>>,
    /// The folders that the client has open.
    pub(crate) folders: Mutex<Vec<PathBuf>>,
    pub(crate) client: Client,
    /// Whether work is under way that nobody asked for.
    pub(crate) busy: Busy,
    /// The open programs.
    pub(crate) documents: Arc<Documents>,
    /// The open texts that are not ladder text: settings files, scenarios, programs of other systems, and what the
    /// client sends besides. They are apart, so that nobody takes one for ladder text.
    pub(crate) companions: Arc<Documents>,
    /// Which of them are programs whose ladder text a client follows.
    pub(crate) previews: Arc<Previews>,
    /// What is known of properties.
    pub(crate) proofs: Proofs,
    /// The files next to them.
    pub(crate) neighbours: Arc<Neighbours>,
    pub(crate) sessions: Sessions,
    /// What a person is typing.
    pub(crate) typed: Typed,
    pub(crate) outbox: Outbox,
    /// The semantic tokens that the client has.
    pub(crate) tokens_sent: TokensSent,
    /// Given when the process that started the server is gone.
    pub(crate) orphaned: Signal,
    /// Where the server runs.
    pub(crate) host: Arc<dyn Host>,
}

impl Shared {
    pub(crate) fn new(client: Client, host: Arc<dyn Host>, busy: Busy) -> Arc<Self> {
        Arc::new(Shared {
            agreed: OnceLock::new(),
            editor: RwLock::default(),
            editor_asked: AtomicU64::new(0),
            settings_complaint: Mutex::default(),
            settings_files: Sent::default(),
            found: Found::default(),
            refresh_due: AtomicBool::new(false),
            looked_around: Mutex::new(None),
            folders: Mutex::default(),
            outbox: Outbox::open(client.clone(), &*host, busy.clone()),
            busy,
            client,
            documents: Arc::default(),
            companions: Arc::default(),
            previews: Arc::default(),
            proofs: Proofs::default(),
            neighbours: Arc::new(Neighbours::on(host.world().disk.clone())),
            tokens_sent: TokensSent::default(),
            sessions: Sessions::default(),
            typed: Typed::default(),
            orphaned: Signal::default(),
            host,
        })
    }

    /// Records what was agreed. The framework lets only one `initialize` through.
    pub(crate) fn agree(&self, agreed: Agreed) {
        let _ = self.agreed.set(agreed);
    }

    /// What was agreed with the client; before that, the protocol's defaults.
    pub(crate) fn agreed(&self) -> Agreed {
        self.agreed.get().copied().unwrap_or_default()
    }

    /// What the editor's own settings say now.
    pub(crate) fn editor(&self) -> Arc<EditorSettings> {
        self.editor.read().unwrap_or_else(PoisonError::into_inner).clone()
    }

    /// Takes the editor's settings.
    pub(crate) fn set_editor(&self, settings: EditorSettings) {
        self.neighbours.set_defaults(settings.project.clone());
        *self.editor.write().unwrap_or_else(PoisonError::into_inner) = Arc::new(settings);
    }

    /// The client is about to be asked for its settings, or has sent them: the number of the occasion.
    pub(crate) fn editor_settings_asked(&self) -> u64 {
        self.editor_asked.fetch_add(1, Ordering::Relaxed) + 1
    }

    /// Whether there was no later occasion.
    pub(crate) fn editor_settings_asked_last(&self, occasion: u64) -> bool {
        self.editor_asked.load(Ordering::Relaxed) == occasion
    }

    /// Reports what is wrong with the editor's settings, unless that was reported last.
    pub(crate) fn report_settings_once(&self, complaint: String) {
        let mut last = self
            .settings_complaint
            .lock()
            .unwrap_or_else(PoisonError::into_inner);
        if !complaint.is_empty() && *last != complaint {
            self.outbox
                .show(format!("The settings of this editor: {complaint}"));
        }
        *last = complaint;
    }

    /// The files and the clock.
    pub(crate) fn world(&self) -> &World {
        self.host.world()
    }

    /// Does a task, which nobody waits for.
    pub(crate) fn spawn(&self, task: impl Future<Output = ()> + Send + 'static) {
        self.host.spawn(Box::pin(task));
    }

    /// What a future resolves to, if it does so in this time.
    pub(crate) async fn within<T>(&self, time: Duration, future: impl Future<Output = T>) -> Option<T> {
        within(&*self.host, time, future).await
    }

    /// Does something on a thread that may read the disk. Nobody waits for it.
    pub(crate) fn in_background(self: &Arc<Self>, job: impl FnOnce(&Arc<Shared>) + Send + 'static) {
        let (shared, work) = (self.clone(), self.busy.begin());
        self.host.work(Box::new(move || {
            job(&shared);
            drop(work);
        }));
    }

    /// The text of a document is another one now: simulations of it go on with that.
    pub(crate) fn text_moved(&self, uri: &str) {
        if let Some(revision) = self.simulated(uri) {
            self.sessions.follow(&revision);
        }
    }

    /// The open text that a simulation runs: ladder text, a program in another language of workspaces, or settings with tasks.
    pub(crate) fn simulated(&self, uri: &str) -> Option<Arc<Revision>> {
        let runs = |revision: &Arc<Revision>| match revision.kind() {
            Kind::Foreign(notation) => notation.is_in_workspaces(),
            Kind::Settings => revision.place().is_some(),
            _ => false,
        };
        let companion = || self.companions.get(uri).filter(runs);
        self.documents.get(uri).or_else(companion)
    }

    /// The document is gone from the editor, and with it the drawing that its simulations would show.
    pub(crate) fn document_closed(&self, uri: &str) {
        self.sessions.stop_all_of(uri);
        self.tokens_sent.forget(uri);
        self.typed.forget(uri);
    }
}

//! Which simulations there are.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use ladder_analysis::Cancel;
use ladder_documents::Revision;
use ladder_host::{Busy, Host};

use crate::action::Action;
use crate::request::Failure;
use crate::session::Session;

/// No editor shows more simulations than this at once; a client that starts them in a loop is stopped here.
const MOST: usize = 32;

/// A disk that takes longer does not keep the editor from closing: some wait two seconds for the answer to `shutdown`.
const SAVING: Duration = Duration::from_millis(1500);

/// The sessions of one client, by name.
#[derive(Debug, Default)]
pub struct Sessions {
    table: Mutex<Table>,
    running: Busy,
}

#[derive(Debug, Default)]
struct Table {
    named: u64,
    open: BTreeMap<String, Arc<Session>>,
}

impl Sessions {
    /// A name that no session has had.
    pub fn new_name(&self) -> String {
        let mut table = self.lock();
        table.named += 1;
        format!("s{}", table.named)
    }

    /// Enters a session that has just started.
    ///
    /// # Errors
    /// Too many are open.
    pub fn add(&self, session: Session) -> Result<Arc<Session>, Failure> {
        let mut table = self.lock();
        if table.open.len() >= MOST {
            return Err(Failure::Failed(format!(
                "{MOST} simulations are open; stop one of them first"
            )));
        }
        let session = Arc::new(session);
        table.open.insert(session.id.clone(), session.clone());
        Ok(session)
    }

    /// The session of this name.
    ///
    /// # Errors
    /// There is none.
    pub fn get(&self, id: &str) -> Result<Arc<Session>, Failure> {
        self.lock().open.get(id).cloned().ok_or_else(|| unknown(id))
    }

    /// The simulations of a document, the newest last.
    pub fn of(&self, uri: &str) -> Vec<Arc<Session>> {
        let table = self.lock();
        let these = table.open.values().filter(|session| &*session.uri == uri);
        these.cloned().collect()
    }

    /// Takes a session off the table, to be stopped.
    ///
    /// # Errors
    /// There is none of this name.
    pub fn remove(&self, id: &str) -> Result<Arc<Session>, Failure> {
        self.lock().open.remove(id).ok_or_else(|| unknown(id))
    }

    /// Tells the simulations of a document that its text is another one.
    pub fn follow(&self, revision: &Arc<Revision>) {
        for session in self
            .lock()
            .open
            .values()
            .filter(|session| session.uri == revision.uri)
        {
            drop(session.ask(Action::Follow(revision.clone()), Cancel::default()));
        }
    }

    /// Tells the simulations of a document, whose text is as it was, that other files are not.
    pub fn follow_others(&self, revision: &Arc<Revision>) {
        for session in self.of(&revision.uri) {
            drop(session.ask(Action::FollowOthers(revision.clone()), Cancel::default()));
        }
    }

    /// Whether nothing is simulated.
    pub fn is_empty(&self) -> bool {
        self.lock().open.is_empty()
    }

    /// Stops the simulations of a document.
    pub fn stop_all_of(&self, uri: &str) {
        self.lock().open.retain(|_, session| {
            let goes = &*session.uri == uri;
            if goes {
                drop(session.ask(Action::Stop, Cancel::default()));
            }
            !goes
        });
    }

    /// Counts the sessions that are under way; those that were asked to stop too, until they have.
    pub fn running(&self) -> Busy {
        self.running.clone()
    }

    /// Stops all simulations, and waits until they have saved what they keep: after this the process may end.
    pub async fn stop_everything(&self, host: &dyn Host) {
        for session in std::mem::take(&mut self.lock().open).into_values() {
            drop(session.ask(Action::Stop, Cancel::default()));
        }
        self.running.rest(host, SAVING).await;
    }

    fn lock(&self) -> MutexGuard<'_, Table> {
        self.table.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

fn unknown(id: &str) -> Failure {
    Failure::Failed(format!(
        "there is no simulation {id}; it was stopped, or never started"
    ))
}

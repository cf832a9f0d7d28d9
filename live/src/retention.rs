//! Retentive tags of a simulation, where the workspace names a file for them.

use std::time::Duration;

use ladder_simulator::Session;
use ladder_workspace::{Named, RetentiveFile};

use ladder_host::{Clock, World};

/// Where retentive tags are kept.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub enum Keeping {
    /// As the workspace says, if it does.
    #[default]
    AsSettingsSay,
    /// In this file.
    In(Named),
    /// Nowhere: the program starts cold.
    Nothing,
}

/// A simulation that was asked to stop lets go of its file in this time. An editor that starts it again may not wait until then.
const PATIENCE: Duration = Duration::from_secs(1);

/// The file, while a simulation runs.
#[derive(Debug)]
pub(crate) struct Retention {
    file: RetentiveFile,
    clock: Clock,
}

impl Retention {
    /// Reads the file and begins with what it kept. Without a file, or with one that cannot be used, the simulation
    /// keeps nothing; the sentences are for the person.
    pub(crate) fn begin(
        world: &World,
        file: Option<&Named>,
        program: &str,
        session: &mut Session,
    ) -> (Option<Retention>, Vec<String>) {
        let Some(file) = file else {
            return (None, Vec::new());
        };
        match RetentiveFile::open_named(&*world.disk, file, program, PATIENCE) {
            Ok((file, found)) => {
                let mut notes = found.notes;
                let complaints = found.kept.map(|kept| session.warm_start(&kept));
                notes.extend(complaints.into_iter().flatten());
                let clock = world.clock.clone();
                (Some(Retention { file, clock }), notes)
            }
            Err(error) => (None, vec![error.to_string()]),
        }
    }

    /// Between two scans: saves if that is due. What cannot be written is tried again a second later.
    pub(crate) fn keep(&mut self, session: &Session) {
        if self.file.is_due(self.clock.now()) {
            self.save(session);
        }
    }

    /// Saves.
    pub(crate) fn save(&mut self, session: &Session) {
        let _ = self.file.save(&session.simulation().retained());
    }
}

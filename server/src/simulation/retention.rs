//! Retentive tags of a simulation, where the workspace names a file for them.

use std::time::{Duration, Instant};

use ladder_simulator::Session;
use ladder_workspace::{FileError, Found, Named, Problem, RetentiveFile};

/// Where retentive tags are kept.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(crate) enum Keeping {
    /// As the workspace says, if it does.
    #[default]
    AsSettingsSay,
    /// In this file.
    In(Named),
    /// Nowhere: the program starts cold.
    Nothing,
}

/// A simulation that was asked to stop lets go of its file in this time.
const PATIENCE: Duration = Duration::from_secs(1);

/// Opens the file. An editor that starts a simulation again may not wait until the one before has ended.
fn patiently(file: &Named, program: &str) -> Result<(RetentiveFile, Found), FileError> {
    let begun = Instant::now();
    loop {
        match RetentiveFile::open_named(file, program) {
            Err(error) if matches!(error.problem, Problem::InUse) && begun.elapsed() < PATIENCE => {
                std::thread::sleep(Duration::from_millis(20));
            }
            opened => return opened,
        }
    }
}

/// The file, while a simulation runs.
#[derive(Debug)]
pub(super) struct Retention {
    file: RetentiveFile,
}

impl Retention {
    /// Reads the file and begins with what it kept. Without a file, or with one that cannot be used, the simulation
    /// keeps nothing; the sentences are for the person.
    pub(super) fn begin(
        file: Option<&Named>,
        program: &str,
        session: &mut Session,
    ) -> (Option<Retention>, Vec<String>) {
        let Some(file) = file else {
            return (None, Vec::new());
        };
        match patiently(file, program) {
            Ok((file, found)) => {
                let mut notes = found.notes;
                let complaints = found.kept.map(|kept| session.warm_start(&kept));
                notes.extend(complaints.into_iter().flatten());
                (Some(Retention { file }), notes)
            }
            Err(error) => (None, vec![error.to_string()]),
        }
    }

    /// Between two scans: saves if that is due. What cannot be written is tried again a second later.
    pub(super) fn keep(&mut self, session: &Session) {
        if self.file.is_due(Instant::now()) {
            self.save(session);
        }
    }

    /// Saves.
    pub(super) fn save(&mut self, session: &Session) {
        let _ = self.file.save(&session.simulation().retained());
    }
}

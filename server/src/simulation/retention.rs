//! Retentive tags of a simulation, where the workspace names a file for them.

use std::path::Path;

use ladder_simulator::Session;
use ladder_workspace::RetentiveFile;

/// The file, while a simulation runs.
#[derive(Debug)]
pub(super) struct Retention {
    file: RetentiveFile,
}

impl Retention {
    /// Reads the file and begins with what it kept. Without a file, or with one that cannot be read, the simulation
    /// keeps nothing; the sentences are for the person.
    pub(super) fn begin(
        file: Option<&Path>,
        program: &str,
        session: &mut Session,
    ) -> (Option<Retention>, Vec<String>) {
        let Some(path) = file else {
            return (None, Vec::new());
        };
        match RetentiveFile::open(path, program) {
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
        if self.file.is_due() {
            self.finish(session);
        }
    }

    /// Saves.
    pub(super) fn finish(&mut self, session: &Session) {
        let _ = self.file.save(&session.simulation().retained());
    }
}

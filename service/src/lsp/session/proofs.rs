//! What is known of the properties of open files: it counts until the text of one of their files is another.

use std::collections::HashMap;
use std::fmt::{self, Write};
use std::hash::{DefaultHasher, Hasher};
use std::sync::{Arc, Mutex, PoisonError};

use futures::lock::{Mutex as Turns, MutexGuard};
use ladder_documents::Revision;
use ladder_simulator::Simulation;

use crate::proof::PropertyProved;

/// The answers, by the addresses of the files of properties.
#[derive(Debug, Default)]
pub(crate) struct Proofs {
    found: Mutex<HashMap<String, Proved>>,
    turn: Turns<()>,
}

#[derive(Debug)]
struct Proved {
    file: Arc<Revision>,
    program: ProgramText,
    properties: Vec<PropertyProved>,
}

/// Tells programs apart, with the places that they have in their files and the time from one scan to the next.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct ProgramText(u64);

impl ProgramText {
    /// That of a program that is ready to run.
    pub(crate) fn of(simulation: &Simulation) -> ProgramText {
        let mut written = Hashed(DefaultHasher::new());
        let _ = write!(
            written,
            "{:?}{}",
            simulation.program(),
            simulation.options().interval
        );
        ProgramText(written.0.finish())
    }
}

/// What is written to it is not kept.
struct Hashed(DefaultHasher);

impl fmt::Write for Hashed {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        self.0.write(text.as_bytes());
        Ok(())
    }
}

impl Proofs {
    /// Waits until no other proof is under way: several at once would only take longer, and leave an editor no processor.
    pub(crate) async fn turn(&self) -> MutexGuard<'_, ()> {
        self.turn.lock().await
    }

    /// Takes what was found, next to what is known of the other properties of the same texts.
    pub(crate) fn found(&self, file: &Arc<Revision>, program: ProgramText, properties: Vec<PropertyProved>) {
        let mut all = self.lock();
        let known = all.entry(file.uri.to_string()).or_insert_with(|| Proved {
            file: Arc::clone(file),
            program,
            properties: Vec::new(),
        });
        if !same_text(&known.file, file) || known.program != program {
            known.properties.clear();
        }
        (known.file, known.program) = (Arc::clone(file), program);
        let is_new = |known: &PropertyProved| !properties.iter().any(|it| it.name == known.name);
        known.properties.retain(is_new);
        known.properties.extend(properties);
    }

    /// What is known of the properties of a file with a program, which is only asked for where it matters.
    pub(crate) fn of(
        &self,
        file: &Revision,
        program: impl FnOnce() -> Option<ProgramText>,
    ) -> Vec<PropertyProved> {
        let all = self.lock();
        let known = all.get(&*file.uri);
        let known = known.filter(|known| same_text(&known.file, file) && program() == Some(known.program));
        known.map_or(Vec::new(), |known| known.properties.clone())
    }

    /// The file is gone from the editor.
    pub(crate) fn forget(&self, uri: &str) {
        self.lock().remove(uri);
    }

    /// A panic elsewhere leaves at worst an answer that is missing.
    fn lock(&self) -> std::sync::MutexGuard<'_, HashMap<String, Proved>> {
        self.found.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Of one opening: what is known of a file that was closed is forgotten.
fn same_text(one: &Revision, other: &Revision) -> bool {
    (one.version, one.len()) == (other.version, other.len())
}

//! The program that runs follows the text in the editor.

use std::sync::Arc;

use ladder_documents::Revision;
use ladder_simulator::Changeover;

use crate::engine::{Engine, unreadable};
use crate::line_map::LineMap;
use crate::messages;

/// The texts of the programs that ran, by their numbers in the session.
#[derive(Debug)]
pub(crate) struct Texts {
    known: Vec<(u64, Arc<Revision>)>,
    /// The number of the one that is checked.
    looked_at: u64,
    /// The text of the editor has errors: the last good one runs.
    pub(crate) stale: bool,
    /// What became of the last change.
    pub(crate) change: Option<messages::ProgramChange>,
}

impl Texts {
    pub(crate) fn new(revision: Arc<Revision>) -> Texts {
        Texts {
            known: vec![(0, revision)],
            looked_at: 0,
            stale: false,
            change: None,
        }
    }

    fn of(&self, generation: u64) -> Option<&Arc<Revision>> {
        let known = self.known.iter().rev();
        known
            .into_iter()
            .find(|(number, _)| *number == generation)
            .map(|(_, revision)| revision)
    }
}

impl Engine {
    /// Goes on with the program of another text of the editor, if that has one; else the last good one runs on. Returns
    /// whether the program is another one. Analyses and compiles.
    pub(crate) fn follow(&mut self, shown: Arc<Revision>) -> bool {
        let ladder = shown.in_ladder();
        let running = if unreadable(&shown).is_some() {
            None
        } else if self.controller.is_some() {
            ladder.program().map(|program| program.map(Ok))
        } else {
            ladder.running()
        };
        let program = match running {
            Some(Ok(Ok(program))) => Some(program),
            _ => None,
        };
        self.texts.stale = program.is_none();
        let mut is_another = false;
        if let Some(program) = program {
            match self.session.change(program) {
                Ok(Changeover::None) => {
                    let newest = self.session.newest_generation();
                    self.texts.known.retain(|(number, _)| *number != newest);
                    self.texts.known.push((newest, shown.clone()));
                }
                Ok(Changeover::Carried { lost }) => {
                    is_another = true;
                    let generation = self.session.generation();
                    self.texts.known.push((generation, shown.clone()));
                    let lost_in = LineMap::of(ladder, shown.clone(), shown.clone());
                    let lost = lost.into_iter().map(|lost| messages::Lost {
                        message: lost.message,
                        range: lost
                            .location
                            .filter(|location| location.file == 0)
                            .and_then(|location| lost_in.range(location.range)),
                    });
                    self.texts.change = Some(messages::ProgramChange {
                        number: generation,
                        scan: self.session.simulation().scans(),
                        lost: lost.collect(),
                    });
                }
                // It needs too much memory: what runs goes on.
                Err(_) => self.texts.stale = true,
            }
        }
        if is_another {
            self.watch_again();
            self.serve_again();
        }
        self.recorder.look(&self.session);
        // Texts of programs that cannot be stepped back to any more are of no use.
        let oldest = self.session.oldest_generation();
        self.texts.known.retain(|(number, _)| *number >= oldest);
        let generation = self.session.generation();
        self.texts.looked_at = generation;
        if let Some(running) = self.texts.of(generation).cloned() {
            self.check_again(running, shown);
        }
        is_another
    }

    /// Whether the program uses, or lacks, something of another file.
    pub(crate) fn uses_others(&self) -> bool {
        self.texts.stale || self.session.simulation().program().files.len() > 1
    }

    /// Something has happened: it is recorded. Stepping over a change leads to another program.
    pub(crate) fn look_at_what_runs(&mut self) {
        self.recorder.look(&self.session);
        let generation = self.session.generation();
        if self.texts.looked_at == generation {
            return;
        }
        self.texts.looked_at = generation;
        if let Some(running) = self.texts.of(generation).cloned() {
            let shown = self.line_map.shown().clone();
            self.check_again(running, shown);
        }
    }
}

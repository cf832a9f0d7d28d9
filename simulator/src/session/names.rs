//! Tags by any name that they have, or had before the program was changed.

use super::Session;
use crate::carry::{Moved, Names};
use crate::simulation::Simulation;
use crate::tags::{Point, UnknownTag};
use ladder_syntax::Name;

/// This many changes of a name are remembered.
const MOST: usize = 256;

impl Session {
    /// The point of this name in the program that runs here; also by a name that its tag had earlier or has later.
    ///
    /// # Errors
    /// There is none.
    pub fn find(&self, name: &str) -> Result<Point, UnknownTag> {
        self.find_in(&self.simulation, name)
    }

    /// The same in one of the programs that ran.
    pub(crate) fn find_in(&self, simulation: &Simulation, name: &str) -> Result<Point, UnknownTag> {
        simulation.resolve(name).or_else(|unknown| {
            let mut others = self.other_names(name).into_iter();
            others
                .find_map(|name| simulation.resolve(&name).ok())
                .ok_or(unknown)
        })
    }

    /// Takes note of a tag that has another name now.
    pub(super) fn note_renamed(&mut self, moved: &Moved) {
        if let Some(names) = moved.renamed() {
            self.renamed.push(names.clone());
            let oldest = self.renamed.len().saturating_sub(MOST);
            self.renamed.drain(..oldest);
        }
    }

    fn other_names(&self, name: &str) -> Vec<String> {
        let mut names = vec![name.to_owned()];
        let mut looked_at = 0;
        while let Some(name) = names.get(looked_at).cloned() {
            for other in self.renamed.iter().filter_map(|names: &Names| names.other(&name)) {
                if names.iter().all(|known| Name::new(known) != Name::new(&other)) {
                    names.push(other);
                }
            }
            looked_at += 1;
        }
        names.split_off(1)
    }
}

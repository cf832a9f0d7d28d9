//! The list in which is chosen of which tags a recorded test expects something.

use super::plant::Plant;
use ladder_simulator::scenario::Recordable;

/// Tags, each chosen or not.
#[derive(Debug)]
pub(super) struct Outputs {
    pub(super) tags: Vec<(Recordable, bool)>,
    /// The one that keys are about.
    pub(super) at: usize,
}

impl Outputs {
    /// All tags that can be chosen; at first those are that a recording has of its own.
    ///
    /// # Errors
    /// There is nothing that could be recorded: why.
    pub(super) fn new(plant: &Plant) -> Result<Outputs, String> {
        let usual = plant.record_as_test("program", None)?.expected;
        let offered = plant.recordable().into_iter();
        let mut tags: Vec<(Recordable, bool)> = offered
            .map(|tag| {
                let chosen = usual.contains(&tag.name);
                (tag, chosen)
            })
            .collect();
        tags.sort_by_key(|(_, chosen)| !chosen);
        Ok(Outputs { tags, at: 0 })
    }

    pub(super) fn move_by(&mut self, lines: isize) {
        let last = self.tags.len().saturating_sub(1);
        self.at = self.at.saturating_add_signed(lines).min(last);
    }

    /// Chooses the tag that keys are about, or no longer.
    pub(super) fn toggle(&mut self) {
        if let Some((_, chosen)) = self.tags.get_mut(self.at) {
            *chosen = !*chosen;
        }
    }

    /// All of them, or none if all are chosen.
    pub(super) fn toggle_all(&mut self) {
        let all = self.tags.iter().all(|(_, chosen)| *chosen);
        for (_, chosen) in &mut self.tags {
            *chosen = !all;
        }
    }

    /// The tags that are chosen.
    pub(super) fn chosen(&self) -> Vec<String> {
        let chosen = self.tags.iter().filter(|(_, chosen)| *chosen);
        chosen.map(|(tag, _)| tag.name.clone()).collect()
    }
}

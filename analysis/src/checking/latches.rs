//! The tags that are set and reset, and on which others it depends what is found about them.

use super::at_tags::TagKey;
use rustc_hash::{FxHashMap, FxHashSet};

/// The tags that are set and reset.
#[derive(Debug, Default)]
pub(super) struct Latches {
    all: FxHashSet<TagKey>,
    /// Of those whose coils may undo each other the tags that their conditions ask for: who writes these decides.
    asked: FxHashMap<TagKey, Vec<TagKey>>,
    /// The same the other way round.
    asking: FxHashMap<TagKey, FxHashSet<TagKey>>,
}

impl Latches {
    /// A tag is one of them. `asked`: the tags whose writers decide what is found.
    pub(super) fn note(&mut self, key: &TagKey, asked: Vec<TagKey>) {
        self.all.insert(key.clone());
        for tag in &asked {
            self.asking.entry(tag.clone()).or_default().insert(key.clone());
        }
        if !asked.is_empty() {
            self.asked.insert(key.clone(), asked);
        }
    }

    /// A tag is none of them, as far as is known.
    pub(super) fn forget(&mut self, key: &TagKey) {
        self.all.remove(key);
        for tag in self.asked.remove(key).unwrap_or_default() {
            if let Some(asking) = self.asking.get_mut(&tag) {
                asking.remove(key);
                if asking.is_empty() {
                    self.asking.remove(&tag);
                }
            }
        }
    }

    /// Those about which these tags decide.
    pub(super) fn asking<'a>(
        &'a self,
        tags: impl Iterator<Item = &'a TagKey>,
    ) -> impl Iterator<Item = &'a TagKey> {
        tags.filter_map(|tag| self.asking.get(tag)).flatten()
    }

    /// All of them.
    pub(super) fn all(&self) -> impl Iterator<Item = &TagKey> {
        self.all.iter()
    }
}

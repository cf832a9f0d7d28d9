//! Values that a controller had in its tags when its program was saved: they are no part of what was written.

use crate::comparison::{Change, Comparison};
use crate::outline::{Entry, Kind, Outline};
use crate::verdict::Verdict;
use ladder_analysis::program::{Program, Tag};
use ladder_instructions::Profile;
use ladder_syntax::Name;
use rustc_hash::{FxHashMap, FxHashSet};
use std::sync::Arc;

impl Comparison<'_> {
    /// Tells edits that are of such values alone from others: both programs were saved by a controller's system, and write the tags.
    pub fn fold_values(&mut self) {
        let sides = [self.old, self.new];
        if sides
            .iter()
            .any(|outline| outline.context.profile != Profile::Logix)
        {
            return;
        }
        for change in &mut self.changes {
            let (Some(old), Some(new)) = (change.old, change.new) else {
                continue;
            };
            let is_value = change.verdict == Verdict::Edited
                && old.comments == new.comments
                && differs_in_value(old, new)
                && sides.iter().all(|outline| is_written(outline, new));
            if is_value {
                change.verdict = Verdict::Value;
            }
        }
    }

    /// How many declarations have another value.
    pub fn values(&self) -> usize {
        self.changes
            .iter()
            .filter(|change| change.verdict == Verdict::Value)
            .count()
    }

    /// The old program, beginning with the values that the new one has in these tags.
    pub(crate) fn with_new_values(&self, old: Arc<Program>, new: &Program) -> Arc<Program> {
        let changed = self
            .changes
            .iter()
            .filter(|change| change.verdict == Verdict::Value);
        let names: FxHashSet<&Name> = changed
            .flat_map(|change: &Change<'_>| &change.entry().names)
            .collect();
        if names.is_empty() {
            return old;
        }
        let values: FxHashMap<Name, &Tag> = new.tags.iter().map(|tag| (Name::new(&tag.name), tag)).collect();
        let mut program = (*old).clone();
        for tag in program.tags.iter_mut().filter(|tag| tag.block.is_none()) {
            let declared = tag.name.split(['.', '[']).next().unwrap_or_default();
            if names.contains(&Name::new(declared))
                && let Some(new) = values.get(&Name::new(&tag.name)).filter(|new| new.ty == tag.ty)
            {
                tag.initial.clone_from(&new.initial);
            }
        }
        Arc::new(program)
    }
}

/// Whether two declarations of the program itself say the same up to their values.
fn differs_in_value(old: &Entry, new: &Entry) -> bool {
    let declaration = |entry: &Entry| -> Vec<String> {
        let words = entry
            .told
            .words
            .iter()
            .take_while(|word| *word != ":=" && *word != ";");
        words.cloned().collect()
    };
    new.kind == Kind::Declaration && new.place.is_empty() && declaration(old) == declaration(new)
}

/// Whether the program writes all tags of a declaration, and so never needs what they begin with for long.
fn is_written(outline: &Outline, entry: &Entry) -> bool {
    let Some(scope) = outline.context.scopes.first() else {
        return false;
    };
    entry.names.iter().all(|name| {
        let tag = scope.find(name).map(|tag| &scope.tags[tag]);
        tag.is_some_and(|tag| !tag.constant && outline.context.writers(tag).next().is_some())
    })
}

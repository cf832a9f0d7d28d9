//! The tags that no declaration names, and what decides about several of them.
//!
//! In a file that declares tags, the first few are compared with the declared names. In one that declares none, a name
//! that is used once is compared with all others: whoever is near to a name that comes or goes is looked at again.

use super::at_tags::TagKey;
use crate::context::{Change, Context};
use crate::did_you_mean::{Compared, is_near};
use crate::rules::near_names::NearNames;
use crate::rules::undeclared_tag::{MOST_SUGGESTIONS, Undeclaring, is_usual};
use crate::scope::TagFacts;
use ladder_syntax::Name;
use rustc_hash::FxHashSet;
use std::cell::OnceCell;

/// The undeclared tags of a file.
#[derive(Debug, Default)]
pub(super) struct UndeclaredTags {
    /// Those of which that is found.
    found: FxHashSet<TagKey>,
    /// The first of them in the file.
    suggested: FxHashSet<Name>,
    /// The names that these are compared with, once one is.
    compared: OnceCell<Compared>,
    /// All names, of a file that declares none.
    usual: Option<NearNames>,
}

impl UndeclaredTags {
    /// Before any tag is looked at.
    pub(super) fn of(context: &Context, declares: bool) -> UndeclaredTags {
        let usual = (!declares).then(|| {
            let usual = context.scopes[0].tags.iter().filter(|tag| is_usual(tag));
            NearNames::new(usual.map(|tag| Name::new(&tag.name)))
        });
        UndeclaredTags {
            usual,
            ..UndeclaredTags::default()
        }
    }

    /// Whether there are any.
    pub(super) fn any(&self) -> bool {
        !self.found.is_empty()
    }

    /// A tag is one of them.
    pub(super) fn note(&mut self, key: &TagKey) {
        self.found.insert(key.clone());
        if key.0 == 0 && self.usual.is_none() && self.suggested.len() < MOST_SUGGESTIONS {
            self.suggested.insert(key.1.clone());
        }
    }

    /// A tag is none of them, as far as is known.
    pub(super) fn forget(&mut self, key: &TagKey) {
        self.found.remove(key);
    }

    /// What decides about a tag.
    pub(super) fn undeclaring(&self, (scope, tag): (usize, &TagFacts)) -> Undeclaring<'_> {
        match &self.usual {
            Some(usual) => Undeclaring::Usual(usual),
            None => {
                let suggested = &self.suggested;
                let is_one = suggested.len() < MOST_SUGGESTIONS || suggested.contains(&Name::new(&tag.name));
                Undeclaring::Forgotten((scope == 0 && is_one).then_some(&self.compared))
            }
        }
    }

    /// Enters the names that a change has brought or taken away, and adds the tags that are near to one.
    pub(super) fn follow(&mut self, context: &Context, change: &Change, again: &mut FxHashSet<TagKey>) {
        let Some(usual) = &mut self.usual else { return };
        let file = &context.scopes[0];
        let changed = change.tags.iter().filter(|(scope, _)| *scope == 0);
        for (_, name) in changed.clone() {
            let is_one = file.find(name).is_some_and(|tag| is_usual(&file.tags[tag]));
            match (usual.has(name), is_one) {
                (false, true) => usual.insert(name),
                (true, false) => usual.remove(name),
                _ => {}
            }
        }
        for (_, name) in changed {
            again.extend(
                usual
                    .one_letter_from(name)
                    .into_iter()
                    .map(|name| (0, name.clone())),
            );
        }
    }

    /// Finds out which are the first of the file now. Gives the tags to look at again.
    pub(super) fn choose_suggested(&mut self, context: &Context) -> Vec<TagKey> {
        if self.usual.is_some() {
            return Vec::new();
        }
        let file = &context.scopes[0];
        let names = self
            .found
            .iter()
            .filter(|(scope, _)| *scope == 0)
            .map(|(_, name)| name);
        let first: FxHashSet<Name> = if self.found.len() <= MOST_SUGGESTIONS {
            names.cloned().collect()
        } else {
            let in_order = file.tags.from(file.declared).map(|tag| Name::new(&tag.name));
            let found = in_order.filter(|name| self.found.contains(&(0, name.clone())));
            found.take(MOST_SUGGESTIONS).collect()
        };
        let before = std::mem::replace(&mut self.suggested, first);
        let changed = self.compared.get_mut().map(|compared| compared.follow(context));
        let changed = changed.unwrap_or_default();
        let is_near = |name: &&Name| !changed.is_empty() && is_near(name.as_str(), &changed);
        let mut again: FxHashSet<&Name> = before.symmetric_difference(&self.suggested).collect();
        again.extend(self.suggested.iter().filter(is_near));
        again.into_iter().map(|name| (0, name.clone())).collect()
    }
}

//! Something for each of many names, of which an edit changes little.

use ladder_syntax::Name;
use rustc_hash::{FxHashMap, FxHashSet};
use std::sync::Arc;

/// This many names are looked through one by one before all of them are put together anew.
const MOST: usize = 32;

/// What names lead to. Copies share what they have in common.
#[derive(Debug, Clone)]
pub(crate) struct ByName<T> {
    names: Arc<FxHashMap<Name, T>>,
    /// What has changed of these names since.
    changed: Vec<(Name, Option<T>)>,
}

impl<T> Default for ByName<T> {
    fn default() -> Self {
        ByName {
            names: Arc::default(),
            changed: Vec::new(),
        }
    }
}

impl<T> From<FxHashMap<Name, T>> for ByName<T> {
    fn from(names: FxHashMap<Name, T>) -> Self {
        ByName {
            names: Arc::new(names),
            changed: Vec::new(),
        }
    }
}

impl<T: Copy + PartialEq> ByName<T> {
    /// What a name leads to.
    pub(crate) fn get(&self, name: &Name) -> Option<T> {
        let changed = self.changed.iter().find(|(changed, _)| changed == name);
        match changed {
            Some((_, value)) => *value,
            None => self.names.get(name).copied(),
        }
    }

    /// Makes room for this many names more, so that the table need not be made anew as it grows.
    pub(crate) fn reserve(&mut self, names: usize) {
        Arc::make_mut(&mut self.names).reserve(names);
    }

    /// Adds a name before any has changed, if it is not there.
    pub(crate) fn add(&mut self, name: Name, value: T) {
        Arc::make_mut(&mut self.names).entry(name).or_insert(value);
    }

    /// A name leads to something else, or to nothing any longer.
    pub(crate) fn set(&mut self, name: Name, value: Option<T>) {
        if self.get(&name) == value {
            return;
        }
        self.changed.retain(|(changed, _)| *changed != name);
        self.changed.push((name, value));
        if self.changed.len() <= MOST {
            return;
        }
        let names = Arc::make_mut(&mut self.names);
        for (name, value) in self.changed.drain(..) {
            match value {
                Some(value) => names.insert(name, value),
                None => names.remove(&name),
            };
        }
    }

    /// All names that lead to something.
    pub(crate) fn iter(&self) -> impl Iterator<Item = (&Name, T)> {
        let stays = |name: &Name| !self.changed.iter().any(|(changed, _)| changed == name);
        let kept = self.names.iter().filter(move |(name, _)| stays(name));
        let kept = kept.map(|(name, value)| (name, *value));
        let changed = self.changed.iter();
        kept.chain(changed.filter_map(|(name, value)| Some((name, (*value)?))))
    }

    /// The names that do not lead to the same in another copy. Of copies that share most names few are looked at.
    pub(crate) fn differing<'n>(&'n self, other: &'n ByName<T>) -> FxHashSet<&'n Name> {
        let own = self.changed.iter().chain(&other.changed).map(|(name, _)| name);
        let mut names: FxHashSet<&Name> = own.collect();
        if !Arc::ptr_eq(&self.names, &other.names) {
            names.extend(self.names.keys().chain(other.names.keys()));
        }
        names.retain(|name| self.get(name) != other.get(name));
        names
    }
}

#[cfg(test)]
mod tests {
    use super::{ByName, MOST};
    use ladder_syntax::Name;

    #[test]
    fn copies_differ_in_what_was_changed() {
        let name = |n: usize| Name::new(&format!("n{n}"));
        let mut first: ByName<usize> = ByName::default();
        for n in 0..100 {
            first.add(name(n), n);
        }
        let mut second = first.clone();
        for changed in 0..2 * MOST {
            let (at, value) = (name(changed), (changed % 3 > 0).then_some(changed + 1));
            second.set(at, value);
            assert_eq!(first.differing(&second).len(), changed + 1);
            assert_eq!(second.iter().count(), 100 - changed / 3 - 1);
        }
        second.set(name(7), Some(7));
        assert!(!second.differing(&first).contains(&name(7)));
        assert_eq!(second.iter().find(|(at, _)| **at == name(7)), Some((&name(7), 7)));
    }
}

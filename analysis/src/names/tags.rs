//! The tags of a scope, in chunks that contexts before and behind an edit share.

use crate::chunked::{self, Chunked};
use crate::scope::TagFacts;
use std::ops::{Index, IndexMut, Range};
use std::sync::Arc;

/// The tags of a scope: in the order of declaration, then of first use.
#[derive(Debug, Clone, Default)]
pub struct Tags(Chunked<Arc<TagFacts>>);

impl Tags {
    /// How many there are.
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.0.len() == 0
    }

    /// A tag, if there are that many.
    pub fn get(&self, tag: usize) -> Option<&TagFacts> {
        (tag < self.len()).then(|| &self[tag])
    }

    /// All of them, in their order.
    pub fn iter(&self) -> Iter<'_> {
        self.from(0)
    }

    /// Those from one on.
    pub fn from(&self, first: usize) -> Iter<'_> {
        Iter(self.0.from(first))
    }

    pub(crate) fn push(&mut self, tag: TagFacts) {
        self.0.push(Arc::new(tag));
    }

    /// Puts others in the place of some.
    pub(crate) fn splice(&mut self, old: Range<usize>, new: impl IntoIterator<Item = Arc<TagFacts>>) {
        if old.is_empty() {
            self.0.splice(old, new);
            return;
        }
        // Where there are as many, all others stay where they are.
        let (mut old, mut new) = (old, new.into_iter());
        while let Some(tag) = old.clone().next().and_then(|_| new.next()) {
            *self.0.get_mut(old.start) = tag;
            old.start += 1;
        }
        let rest: Vec<Arc<TagFacts>> = new.collect();
        if !old.is_empty() || !rest.is_empty() {
            self.0.splice(old, rest);
        }
    }

    /// Takes one out.
    pub(crate) fn take(&mut self, tag: usize) -> Arc<TagFacts> {
        let gone = Arc::clone(&self.0[tag]);
        self.0.splice(tag..tag + 1, []);
        gone
    }

    /// Leaves this many at the beginning, and gives the others.
    pub(crate) fn split_off(&mut self, first: usize) -> Vec<Arc<TagFacts>> {
        self.0.split_off(first)
    }

    pub(crate) fn extend(&mut self, tags: impl IntoIterator<Item = Arc<TagFacts>>) {
        for tag in tags {
            self.0.push(tag);
        }
    }
}

/// Tags of a scope, in their order.
#[derive(Debug, Clone)]
pub struct Iter<'t>(chunked::Iter<'t, Arc<TagFacts>>);

impl<'t> Iterator for Iter<'t> {
    type Item = &'t TagFacts;

    fn next(&mut self) -> Option<&'t TagFacts> {
        self.0.next().map(|tag| &**tag)
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        self.0.size_hint()
    }

    fn fold<B, F: FnMut(B, &'t TagFacts) -> B>(self, first: B, mut with: F) -> B {
        self.0.fold(first, |all, tag| with(all, tag))
    }
}

impl DoubleEndedIterator for Iter<'_> {
    fn next_back(&mut self) -> Option<Self::Item> {
        self.0.next_back().map(|tag| &**tag)
    }
}

impl ExactSizeIterator for Iter<'_> {}

impl<'t> IntoIterator for &'t Tags {
    type Item = &'t TagFacts;
    type IntoIter = Iter<'t>;

    fn into_iter(self) -> Iter<'t> {
        self.iter()
    }
}

impl Index<usize> for Tags {
    type Output = TagFacts;

    fn index(&self, tag: usize) -> &TagFacts {
        &self.0[tag]
    }
}

impl IndexMut<usize> for Tags {
    fn index_mut(&mut self, tag: usize) -> &mut TagFacts {
        Arc::make_mut(self.0.get_mut(tag))
    }
}

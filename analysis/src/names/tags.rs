//! The tags of a scope, in chunks that contexts before and behind an edit share.

use crate::chunked::{self, Chunked};
use crate::letters::Letters;
use crate::scope::TagFacts;
use std::ops::{Index, IndexMut, Range};
use std::sync::Arc;

/// The tags of a scope: in the order of declaration, then of first use.
#[derive(Debug, Clone, Default)]
pub struct Tags(Chunked<Entry>);

/// A tag, and beside it what tells many apart without a look at each.
#[derive(Debug, Clone)]
struct Entry {
    /// Of its name, which keeps its letters when it is spelled in another case.
    letters: Letters,
    tag: Arc<TagFacts>,
}

impl From<Arc<TagFacts>> for Entry {
    fn from(tag: Arc<TagFacts>) -> Entry {
        Entry {
            letters: Letters::of(&tag.name),
            tag,
        }
    }
}

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

    /// Some of them, without those whose names lack one of these letters.
    pub fn that_have(&self, letters: Letters, range: Range<usize>) -> impl Iterator<Item = &TagFacts> {
        let some = self.0.from(range.start).take(range.len());
        some.filter(move |entry| entry.letters.have(letters))
            .map(|entry| &*entry.tag)
    }

    pub(crate) fn push(&mut self, tag: TagFacts) {
        self.0.push(Arc::new(tag).into());
    }

    /// Puts others in the place of some.
    pub(crate) fn splice(&mut self, old: Range<usize>, new: impl IntoIterator<Item = Arc<TagFacts>>) {
        if old.is_empty() {
            self.0.splice(old, new.into_iter().map(Entry::from));
            return;
        }
        // Where there are as many, all others stay where they are.
        let (mut old, mut new) = (old, new.into_iter().map(Entry::from));
        while let Some(tag) = old.clone().next().and_then(|_| new.next()) {
            *self.0.get_mut(old.start) = tag;
            old.start += 1;
        }
        let rest: Vec<Entry> = new.collect();
        if !old.is_empty() || !rest.is_empty() {
            self.0.splice(old, rest);
        }
    }

    /// Takes one out.
    pub(crate) fn take(&mut self, tag: usize) -> Arc<TagFacts> {
        let gone = Arc::clone(&self.0[tag].tag);
        self.0.splice(tag..tag + 1, []);
        gone
    }

    /// Leaves this many at the beginning, and gives the others.
    pub(crate) fn split_off(&mut self, first: usize) -> Vec<Arc<TagFacts>> {
        let rest = self.0.split_off(first).into_iter();
        rest.map(|entry| entry.tag).collect()
    }

    pub(crate) fn extend(&mut self, tags: impl IntoIterator<Item = Arc<TagFacts>>) {
        for tag in tags {
            self.0.push(tag.into());
        }
    }
}

/// Tags of a scope, in their order.
#[derive(Debug, Clone)]
pub struct Iter<'t>(chunked::Iter<'t, Entry>);

impl<'t> Iterator for Iter<'t> {
    type Item = &'t TagFacts;

    fn next(&mut self) -> Option<&'t TagFacts> {
        self.0.next().map(|entry| &*entry.tag)
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        self.0.size_hint()
    }

    fn fold<B, F: FnMut(B, &'t TagFacts) -> B>(self, first: B, mut with: F) -> B {
        self.0.fold(first, |all, entry| with(all, &entry.tag))
    }
}

impl DoubleEndedIterator for Iter<'_> {
    fn next_back(&mut self) -> Option<Self::Item> {
        self.0.next_back().map(|entry| &*entry.tag)
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
        &self.0[tag].tag
    }
}

impl IndexMut<usize> for Tags {
    fn index_mut(&mut self, tag: usize) -> &mut TagFacts {
        Arc::make_mut(&mut self.0.get_mut(tag).tag)
    }
}

//! A list whose copies share what they have in common: a change copies one chunk of it.

use std::ops::{Index, Range};
use std::sync::Arc;

/// How many values a chunk holds.
const CHUNK: usize = 128;

/// A list that is cheap to copy and to change in few places.
#[derive(Debug, Clone)]
pub(crate) struct Chunked<T> {
    /// All are full but the last.
    chunks: Vec<Arc<Vec<T>>>,
    len: usize,
}

impl<T> Default for Chunked<T> {
    fn default() -> Self {
        Chunked {
            chunks: Vec::new(),
            len: 0,
        }
    }
}

impl<T> Chunked<T> {
    /// How many values there are.
    pub(crate) fn len(&self) -> usize {
        self.len
    }

    /// A value, if there are so many.
    pub(crate) fn get(&self, index: usize) -> Option<&T> {
        self.chunks.get(index / CHUNK)?.get(index % CHUNK)
    }
}

impl<T: Clone> Chunked<T> {
    /// Adds a value at the end.
    pub(crate) fn push(&mut self, value: T) {
        if self.len.is_multiple_of(CHUNK) {
            self.chunks.push(Arc::new(Vec::with_capacity(CHUNK)));
        }
        if let Some(last) = self.chunks.last_mut() {
            Arc::make_mut(last).push(value);
        }
        self.len += 1;
    }

    /// A value to change. Panics where there are not so many.
    pub(crate) fn get_mut(&mut self, index: usize) -> &mut T {
        &mut Arc::make_mut(&mut self.chunks[index / CHUNK])[index % CHUNK]
    }

    /// Puts others in the place of some.
    pub(crate) fn splice(&mut self, old: Range<usize>, new: impl IntoIterator<Item = T>) {
        let below = self.split_off(old.start);
        let below = below.into_iter().skip(old.len());
        self.extend(new.into_iter().chain(below));
    }

    /// Adds values at the end, a chunk at a time.
    fn extend(&mut self, values: impl IntoIterator<Item = T>) {
        let mut values = values.into_iter();
        if !self.len.is_multiple_of(CHUNK)
            && let Some(last) = self.chunks.last_mut()
        {
            let last = Arc::make_mut(last);
            let missing = CHUNK - last.len();
            let before = last.len();
            last.extend(values.by_ref().take(missing));
            self.len += last.len() - before;
        }
        if !self.len.is_multiple_of(CHUNK) {
            return;
        }
        loop {
            let mut chunk = Vec::with_capacity(CHUNK);
            chunk.extend(values.by_ref().take(CHUNK));
            if chunk.is_empty() {
                return;
            }
            self.len += chunk.len();
            self.chunks.push(Arc::new(chunk));
        }
    }

    /// Leaves the first so many values, and gives the others.
    pub(crate) fn split_off(&mut self, first: usize) -> Vec<T> {
        let mut rest = Vec::with_capacity(self.len.saturating_sub(first));
        let last = first.div_ceil(CHUNK);
        let whole = self.chunks.split_off(last.min(self.chunks.len()));
        if !first.is_multiple_of(CHUNK)
            && first < self.len
            && let Some(chunk) = self.chunks.last_mut()
        {
            rest = Arc::make_mut(chunk).split_off(first % CHUNK);
        }
        rest.extend(whole.iter().flat_map(|chunk| chunk.iter().cloned()));
        self.len = self.len.min(first);
        rest
    }
}

impl<T> Index<usize> for Chunked<T> {
    type Output = T;

    fn index(&self, index: usize) -> &T {
        &self.chunks[index / CHUNK][index % CHUNK]
    }
}

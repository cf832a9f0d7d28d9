//! A list whose copies share what they have in common: a change copies one chunk of it.

use std::iter::{Chain, FlatMap};
use std::ops::{Index, Range};
use std::slice;
use std::sync::Arc;

/// How many values a chunk holds. Values that come and go between others let it grow to twice as many.
const CHUNK: usize = 128;

/// With fewer values a chunk that has changed is joined to the next one.
const FEWEST: usize = CHUNK / 4;

/// A list that is cheap to copy and to change in few places.
#[derive(Debug, Clone)]
pub(crate) struct Chunked<T> {
    /// None of them is empty.
    chunks: Vec<Arc<Vec<T>>>,
    /// Where each of them starts. Nothing as long as all are full but the last: then it follows from their numbers.
    starts: Vec<u32>,
    len: usize,
}

impl<T> Default for Chunked<T> {
    fn default() -> Self {
        Chunked {
            chunks: Vec::new(),
            starts: Vec::new(),
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
        let (chunk, offset) = self.find(index);
        self.chunks.get(chunk)?.get(offset)
    }

    /// The values from one on, in their order.
    pub(crate) fn from(&self, first: usize) -> Iter<'_, T> {
        let (chunk, offset) = self.find(first);
        let rest = self.chunks.get(chunk..).unwrap_or_default();
        let (begun, whole) = rest
            .split_first()
            .map_or((None, rest), |(begun, whole)| (Some(begun), whole));
        let begun = begun.and_then(|begun| begun.get(offset..)).unwrap_or_default();
        let values: fn(&Arc<Vec<T>>) -> slice::Iter<'_, T> = |chunk| chunk.iter();
        Iter {
            values: begun.iter().chain(whole.iter().flat_map(values)),
            left: self.len.saturating_sub(first),
        }
    }

    /// In which chunk a value is, and where in it.
    fn find(&self, index: usize) -> (usize, usize) {
        if self.starts.is_empty() {
            return (index / CHUNK, index % CHUNK);
        }
        let behind = self.starts.partition_point(|start| *start as usize <= index);
        let chunk = behind.saturating_sub(1);
        (chunk, index - self.starts[chunk] as usize)
    }

    /// To be said when chunks have come, gone, or changed their lengths.
    fn number(&mut self) {
        self.starts.clear();
        let all_but_last = self.chunks.len().saturating_sub(1);
        let is_full = |chunk: &Arc<Vec<T>>| chunk.len() == CHUNK;
        if self.chunks[..all_but_last].iter().all(is_full)
            && self.chunks.last().is_none_or(|last| last.len() <= CHUNK)
        {
            return;
        }
        let mut start = 0;
        for chunk in &self.chunks {
            self.starts.push(start);
            start += chunk.len() as u32;
        }
    }
}

impl<T: Clone> Chunked<T> {
    /// Adds a value at the end.
    pub(crate) fn push(&mut self, value: T) {
        match self.chunks.last_mut().filter(|last| last.len() < CHUNK) {
            Some(last) => Arc::make_mut(last).push(value),
            None => {
                let mut chunk = Vec::with_capacity(CHUNK);
                chunk.push(value);
                self.chunks.push(Arc::new(chunk));
                if !self.starts.is_empty() {
                    self.number();
                }
            }
        }
        self.len += 1;
    }

    /// A value to change. Panics where there are not so many.
    pub(crate) fn get_mut(&mut self, index: usize) -> &mut T {
        let (chunk, offset) = self.find(index);
        &mut Arc::make_mut(&mut self.chunks[chunk])[offset]
    }

    /// Puts others in the place of some. All other chunks than theirs stay as they are.
    pub(crate) fn splice(&mut self, old: Range<usize>, new: impl IntoIterator<Item = T>) {
        if old.start == self.len {
            for value in new {
                self.push(value);
            }
            return;
        }
        let (first, from) = self.find(old.start);
        let (mut last, behind) = if old.is_empty() {
            (first, from)
        } else {
            let (chunk, offset) = self.find(old.end - 1);
            (chunk, offset + 1)
        };
        let mut values: Vec<T> = self.chunks[first][..from].to_vec();
        values.extend(new);
        values.extend_from_slice(&self.chunks[last][behind..]);
        while values.len() < FEWEST
            && let Some(next) = self.chunks.get(last + 1)
        {
            values.extend_from_slice(next);
            last += 1;
        }
        let taken: usize = self.chunks[first..=last].iter().map(|chunk| chunk.len()).sum();
        self.len = self.len - taken + values.len();
        let chunks: Vec<Arc<Vec<T>>> = if values.is_empty() {
            Vec::new()
        } else if values.len() <= 2 * CHUNK {
            vec![Arc::new(values)]
        } else {
            values
                .chunks(CHUNK)
                .map(|chunk| Arc::new(chunk.to_vec()))
                .collect()
        };
        self.chunks.splice(first..=last, chunks);
        self.number();
    }

    /// Leaves the first so many values, and gives the others.
    pub(crate) fn split_off(&mut self, first: usize) -> Vec<T> {
        let rest = self.from(first).cloned().collect();
        let (chunk, offset) = self.find(first);
        if let Some(begun) = self.chunks.get_mut(chunk).filter(|_| offset > 0) {
            Arc::make_mut(begun).truncate(offset);
        }
        self.chunks.truncate(chunk + usize::from(offset > 0));
        self.len = self.len.min(first);
        self.number();
        rest
    }
}

impl<T> Index<usize> for Chunked<T> {
    type Output = T;

    fn index(&self, index: usize) -> &T {
        let (chunk, offset) = self.find(index);
        &self.chunks[chunk][offset]
    }
}

type Values<'l, T> =
    FlatMap<slice::Iter<'l, Arc<Vec<T>>>, slice::Iter<'l, T>, fn(&Arc<Vec<T>>) -> slice::Iter<'_, T>>;

/// Values of a list, in their order.
#[derive(Debug, Clone)]
pub(crate) struct Iter<'l, T> {
    values: Chain<slice::Iter<'l, T>, Values<'l, T>>,
    left: usize,
}

impl<'l, T> Iterator for Iter<'l, T> {
    type Item = &'l T;

    fn next(&mut self) -> Option<&'l T> {
        let value = self.values.next();
        self.left -= usize::from(value.is_some());
        value
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        (self.left, Some(self.left))
    }

    // Chunk by chunk: a list is gone through as a whole more often than not.
    fn fold<B, F: FnMut(B, &'l T) -> B>(self, first: B, with: F) -> B {
        self.values.fold(first, with)
    }
}

impl<T> DoubleEndedIterator for Iter<'_, T> {
    fn next_back(&mut self) -> Option<Self::Item> {
        let value = self.values.next_back();
        self.left -= usize::from(value.is_some());
        value
    }
}

impl<T> ExactSizeIterator for Iter<'_, T> {}

#[cfg(test)]
mod tests {
    use super::{CHUNK, Chunked};
    use proptest::prelude::*;
    use std::sync::Arc;

    /// Changes at random places, with the shares of the list's length in thousandths.
    fn changes() -> impl Strategy<Value = Vec<(usize, usize, usize)>> {
        let few = prop_oneof![3 => 0..4usize, 1 => 0..400usize];
        let change = (0..1001usize, few.clone(), few);
        proptest::collection::vec(change, 1..40)
    }

    proptest! {
        #[test]
        fn it_is_what_a_plain_list_is(first in 0..1000usize, changes in changes()) {
            let mut list = Chunked::default();
            let mut plain: Vec<usize> = (0..first).collect();
            for value in &plain {
                list.push(*value);
            }
            for (number, (share, out, into)) in changes.into_iter().enumerate() {
                let start = plain.len() * share / 1000;
                let old = start..(start + out).min(plain.len());
                let new = || (0..into).map(|value| 10_000 * (number + 1) + value);
                let before = list.clone();
                let was = plain.clone();
                list.splice(old.clone(), new());
                plain.splice(old, new());
                if number % 5 == 4 {
                    list.push(number);
                    plain.push(number);
                    let at = plain.len() * (1000 - share) / 1000;
                    prop_assert_eq!(list.split_off(at), plain.split_off(at));
                }
                prop_assert_eq!(list.len(), plain.len());
                prop_assert!(list.from(0).eq(&plain));
                prop_assert!(list.from(start).rev().eq(plain.iter().skip(start).rev()));
                prop_assert!((0..plain.len()).all(|index| list[index] == plain[index]));
                prop_assert_eq!(list.get(plain.len()), None);
                prop_assert!(list.chunks.iter().all(|chunk| !chunk.is_empty() && chunk.len() <= 2 * CHUNK));
                prop_assert!(before.from(0).eq(&was));
            }
        }
    }

    #[test]
    fn a_value_that_comes_or_goes_copies_one_chunk() {
        let mut list = Chunked::default();
        for value in 0..20 * CHUNK {
            list.push(value);
        }
        for (old, new) in [(700..700, vec![1]), (700..701, vec![]), (900..902, vec![5])] {
            let before = list.clone();
            list.splice(old, new);
            let kept = |chunk: &&Arc<Vec<usize>>| before.chunks.iter().any(|old| Arc::ptr_eq(old, chunk));
            assert_eq!(list.chunks.iter().filter(kept).count(), 19);
        }
    }
}

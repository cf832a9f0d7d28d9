//! Which entry of one text is which of another.
//!
//! The longest common run of equal entries stays; equal ones elsewhere have moved; of the rest those are one edited entry that
//! write or declare the same names, or are alike. Whatever two texts hold, the time grows no faster than their length but for
//! a logarithm: of each entry only a few others are compared with it.

use crate::outline::{Entry, Kind};
use ladder_syntax::Name;
use similar::{Algorithm, DiffTag, capture_diff_slices};
use std::collections::{BTreeSet, HashMap, VecDeque};

/// Two entries that are one, by their numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Pair {
    pub(crate) old: usize,
    pub(crate) new: usize,
    /// It is elsewhere among the others now.
    pub(crate) moved: bool,
}

/// From so much likeness on, out of 2, an entry is another one edited.
const ALIKE: f64 = 0.8;

/// With so many others of the same names an entry is compared, and with so many at the same place.
const CANDIDATES: usize = 8;

/// With so many in all.
const MOST_CANDIDATES: usize = 64;

/// What makes two entries equal.
type Key<'e> = (Kind, &'e str, usize);

/// Of two lists of entries those that are one, in the order of the new list.
pub(crate) fn pairs(old: &[&Entry], new: &[&Entry]) -> Vec<Pair> {
    let (old_keys, new_keys) = (keys(old), keys(new));
    let mut found: Vec<Option<(usize, bool)>> = vec![None; new.len()];
    let mut taken = vec![false; old.len()];
    for op in capture_diff_slices(Algorithm::Myers, &old_keys, &new_keys) {
        if op.tag() == DiffTag::Equal {
            for (old, new) in op.old_range().zip(op.new_range()) {
                found[new] = Some((old, false));
                taken[old] = true;
            }
        }
    }
    equal_elsewhere(&old_keys, &new_keys, &mut found, &mut taken);
    edited(old, new, &mut found, &mut taken);
    let pairs = found.iter().enumerate();
    pairs
        .filter_map(|(new, found)| found.map(|(old, moved)| Pair { old, new, moved }))
        .collect()
}

/// What distinguishes each entry. Sections of one kind are told apart by their number, whatever they hold.
fn keys<'e>(entries: &[&'e Entry]) -> Vec<Key<'e>> {
    let mut sections: HashMap<&str, usize> = HashMap::new();
    let keys = entries.iter().map(|entry| {
        let key = entry.told.key.as_str();
        let number = match entry.kind {
            Kind::Section => {
                let count = sections.entry(key).or_default();
                *count += 1;
                *count
            }
            _ => 0,
        };
        (entry.kind, key, number)
    });
    keys.collect()
}

fn equal_elsewhere(
    old: &[Key<'_>],
    new: &[Key<'_>],
    found: &mut [Option<(usize, bool)>],
    taken: &mut [bool],
) {
    let mut left: HashMap<&Key<'_>, VecDeque<usize>> = HashMap::new();
    for (at, key) in old.iter().enumerate().filter(|(at, _)| !taken[*at]) {
        left.entry(key).or_default().push_back(at);
    }
    for (found, key) in found.iter_mut().zip(new).filter(|(found, _)| found.is_none()) {
        if let Some(old) = left.get_mut(key).and_then(VecDeque::pop_front) {
            *found = Some((old, true));
            taken[old] = true;
        }
    }
}

/// Pairs what is left by common names and likeness, the most alike first.
fn edited(old: &[&Entry], new: &[&Entry], found: &mut [Option<(usize, bool)>], taken: &mut [bool]) {
    let old_left: Vec<usize> = (0..old.len()).filter(|at| !taken[*at]).collect();
    let mut by_name: HashMap<(Kind, &Name), Vec<usize>> = HashMap::new();
    for &at in &old_left {
        for name in &old[at].names {
            by_name.entry((old[at].kind, name)).or_default().push(at);
        }
    }
    let mut likely: Vec<(f64, usize, usize)> = Vec::new();
    for (at, entry) in new.iter().enumerate().filter(|(at, _)| found[*at].is_none()) {
        let mut candidates = BTreeSet::new();
        for name in &entry.names {
            if candidates.len() >= MOST_CANDIDATES {
                break;
            }
            if let Some(others) = by_name.get(&(entry.kind, name)) {
                candidates.extend(nearest(others, at));
            }
        }
        candidates.extend(nearest(&old_left, place_before(found, at)));
        for other in candidates {
            let likeness = likeness(old[other], entry);
            if likeness > ALIKE {
                likely.push((likeness, other, at));
            }
        }
    }
    likely.sort_by(|a, b| b.0.total_cmp(&a.0).then_with(|| (a.2, a.1).cmp(&(b.2, b.1))));
    let mut edited = Vec::new();
    for (_, old, new) in likely {
        if !taken[old] && found[new].is_none() {
            taken[old] = true;
            found[new] = Some((old, false));
            edited.push(new);
        }
    }
    edited.sort_unstable();
    mark_moved(found, &edited);
}

/// The place in the old list that is right after the nearest entry above which is in both.
fn place_before(found: &[Option<(usize, bool)>], at: usize) -> usize {
    // How far it is to that entry is bounded, as is what comes of it: a place in the neighbourhood.
    let above = found[..at].iter().rev().take(64);
    let place = above.flatten().find(|(_, moved)| !moved);
    place.map_or(at, |(old, _)| old + 1)
}

/// Some numbers around a place in a sorted list.
fn nearest(sorted: &[usize], place: usize) -> &[usize] {
    let at = sorted.partition_point(|other| *other < place);
    let first = at.saturating_sub(CANDIDATES / 2);
    &sorted[first..sorted.len().min(first + CANDIDATES)]
}

/// How alike two entries of a kind are: up to 1 for the names, up to 1 for what they say.
fn likeness(old: &Entry, new: &Entry) -> f64 {
    if old.kind != new.kind {
        return 0.0;
    }
    // A short one is never like a long one, and need not be compared with it word by word.
    let most = most_common(old.names.len(), new.names.len())
        + most_common(old.told.words.len(), new.told.words.len());
    if most <= ALIKE {
        return 0.0;
    }
    common(&old.names, &new.names) + common(&old.told.words, &new.told.words)
}

/// How much two lists of these lengths can have in common.
fn most_common(old: usize, new: usize) -> f64 {
    2.0 * old.min(new) as f64 / (old + new).max(1) as f64
}

/// How much of two lists is common, whatever the order: 1 for all.
fn common<T: std::hash::Hash + Eq>(old: &[T], new: &[T]) -> f64 {
    if old.is_empty() || new.is_empty() {
        return 0.0;
    }
    let mut left: HashMap<&T, usize> = HashMap::new();
    for word in old {
        *left.entry(word).or_default() += 1;
    }
    let mut both = 0;
    for word in new {
        if let Some(count) = left.get_mut(word).filter(|count| **count > 0) {
            *count -= 1;
            both += 1;
        }
    }
    f64::from(2 * both) / (old.len() + new.len()) as f64
}

/// An edited entry has moved if it is not between the entries that it was between.
fn mark_moved(found: &mut [Option<(usize, bool)>], edited: &[usize]) {
    let mut after = vec![usize::MAX; found.len() + 1];
    for at in (0..found.len()).rev() {
        after[at] = match found[at] {
            Some((old, false)) if edited.binary_search(&at).is_err() => old,
            _ => after[at + 1],
        };
    }
    let mut before: Option<usize> = None;
    for at in 0..found.len() {
        let Some((old, moved)) = found[at] else { continue };
        if edited.binary_search(&at).is_ok() {
            let moved = before.is_some_and(|before| old < before) || old > after[at + 1];
            found[at] = Some((old, moved));
            if !moved {
                before = Some(old);
            }
        } else if !moved {
            before = Some(old);
        }
    }
}

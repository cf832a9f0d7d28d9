//! Differences between two moments, as bytes.
//!
//! A bank is written as the runs of cells that differ: the gap before the run, its length, and what the cells differ
//! in (the exclusive or of both values). So the same bytes go from the older moment to the newer one and back.
//! Texts and queues are written with both contents. Nothing here is kept outside the process, so what is read was
//! written by this very code.

use crate::memory::Text;
use std::collections::VecDeque;
use std::ops::Range;

/// Which way a difference is gone.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Way {
    /// To the older moment.
    Back,
    /// To the newer one.
    Forward,
}

/// A cell of a bank.
pub(super) trait Cell: Copy + Eq {
    /// What two cells differ in.
    fn difference(self, other: Self) -> u64;
    /// The cell that differs from this one so.
    fn differing(self, by: u64) -> Self;
}

impl Cell for u8 {
    fn difference(self, other: u8) -> u64 {
        u64::from(self ^ other)
    }
    fn differing(self, by: u64) -> u8 {
        self ^ by as u8
    }
}

impl Cell for u32 {
    fn difference(self, other: u32) -> u64 {
        u64::from(self ^ other)
    }
    fn differing(self, by: u64) -> u32 {
        self ^ by as u32
    }
}

impl Cell for i64 {
    fn difference(self, other: i64) -> u64 {
        (self ^ other) as u64
    }
    fn differing(self, by: u64) -> i64 {
        self ^ by as i64
    }
}

/// Cells that are compared at once.
const BLOCK: usize = 64;

/// Writes how `new` differs from `old`, makes `old` equal to it, and gives each run that differs.
pub(super) fn write_cells<T: Cell>(
    out: &mut Vec<u8>,
    old: &mut [T],
    new: &[T],
    mut differs: impl FnMut(Range<usize>),
) {
    let (mut at, mut after) = (0, 0);
    while at < new.len() {
        let end = (at + BLOCK).min(new.len());
        if old[at..end] == new[at..end] {
            at = end;
            continue;
        }
        while at < end {
            if old[at] == new[at] {
                at += 1;
                continue;
            }
            let start = at;
            while at < new.len() && old[at] != new[at] {
                at += 1;
            }
            write_run(out, start - after, &old[start..at], &new[start..at]);
            old[start..at].copy_from_slice(&new[start..at]);
            differs(start..at);
            after = at;
        }
    }
    write_number(out, 0);
}

fn write_run<T: Cell>(out: &mut Vec<u8>, gap: usize, old: &[T], new: &[T]) {
    let differences = || old.iter().zip(new).map(|(&old, &new)| old.difference(new));
    let first = old[0].difference(new[0]);
    let is_even = differences().all(|difference| difference == first);
    write_number(out, gap as u64 + 1);
    write_number(out, (old.len() as u64) << 1 | u64::from(is_even));
    if is_even {
        write_number(out, first);
    } else {
        differences().for_each(|difference| write_number(out, difference));
    }
}

/// Reads what [`write_cells`] wrote: gives each cell that differs, and what it differs in.
pub(super) fn read_cells(bytes: &mut Bytes<'_>, mut each: impl FnMut(usize, u64)) {
    let mut at = 0;
    loop {
        let gap = bytes.number();
        if gap == 0 {
            return;
        }
        at += gap as usize - 1;
        let head = bytes.number();
        let end = at + (head >> 1) as usize;
        if head & 1 != 0 {
            let difference = bytes.number();
            (at..end).for_each(|cell| each(cell, difference));
        } else {
            (at..end).for_each(|cell| each(cell, bytes.number()));
        }
        at = end;
    }
}

/// Makes the cells what they were, or became.
pub(super) fn move_cells<T: Cell>(bytes: &mut Bytes<'_>, cells: &mut [T]) {
    read_cells(bytes, |at, difference| {
        cells[at] = cells[at].differing(difference);
    });
}

/// Writes how texts differ, makes `old` equal to `new`, and gives each one that differs.
pub(super) fn write_texts(out: &mut Vec<u8>, old: &mut [Text], new: &[Text], mut differs: impl FnMut(usize)) {
    let mut after = 0;
    for (at, (old, new)) in old.iter_mut().zip(new).enumerate() {
        if old == new {
            continue;
        }
        write_number(out, (at - after) as u64 + 1);
        write_bytes(out, old.bytes());
        write_bytes(out, new.bytes());
        old.set(new.bytes());
        differs(at);
        after = at + 1;
    }
    write_number(out, 0);
}

/// Reads what [`write_texts`] wrote.
pub(super) fn move_texts(bytes: &mut Bytes<'_>, texts: &mut [Text], way: Way) {
    let mut at = 0;
    loop {
        let gap = bytes.number();
        if gap == 0 {
            return;
        }
        at += gap as usize - 1;
        let (old, new) = (bytes.bytes(), bytes.bytes());
        texts[at].set(if way == Way::Back { old } else { new });
        at += 1;
    }
}

/// How many places at the front of a queue are tried as what was taken from it.
const TAKEN: usize = 64;

/// Writes how a queue differs: bytes that are gone from its front, bytes that came at its end.
pub(super) fn write_queue(out: &mut Vec<u8>, old: &mut VecDeque<u8>, new: &VecDeque<u8>) {
    let kept = |gone: &usize| {
        let rest = old.len() - gone;
        rest <= new.len() && old.iter().skip(*gone).eq(new.iter().take(rest))
    };
    let gone = (0..=old.len().min(TAKEN)).find(kept).unwrap_or(old.len());
    let came = new.len() - (old.len() - gone);
    write_number(out, gone as u64);
    out.extend(old.drain(..gone));
    write_number(out, came as u64);
    out.extend(new.range(new.len() - came..));
    old.extend(new.range(new.len() - came..));
}

/// Reads what [`write_queue`] wrote.
pub(super) fn move_queue(bytes: &mut Bytes<'_>, queue: &mut VecDeque<u8>, way: Way) {
    let (gone, came) = (bytes.bytes(), bytes.bytes());
    match way {
        Way::Back => {
            queue.truncate(queue.len() - came.len());
            gone.iter().rev().for_each(|&byte| queue.push_front(byte));
        }
        Way::Forward => {
            queue.drain(..gone.len());
            queue.extend(came);
        }
    }
}

fn write_bytes(out: &mut Vec<u8>, bytes: &[u8]) {
    write_number(out, bytes.len() as u64);
    out.extend_from_slice(bytes);
}

/// Seven bits in a byte, the lowest first.
fn write_number(out: &mut Vec<u8>, mut number: u64) {
    while number > 0x7F {
        out.push(number as u8 | 0x80);
        number >>= 7;
    }
    out.push(number as u8);
}

/// Bytes that are read from their front.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bytes<'b>(pub(super) &'b [u8]);

impl<'b> Bytes<'b> {
    fn number(&mut self) -> u64 {
        let mut number = 0;
        let mut shift = 0;
        while let Some((&byte, rest)) = self.0.split_first() {
            self.0 = rest;
            number |= u64::from(byte & 0x7F) << shift;
            if byte & 0x80 == 0 {
                break;
            }
            shift += 7;
        }
        number
    }

    fn bytes(&mut self) -> &'b [u8] {
        let length = (self.number() as usize).min(self.0.len());
        let (bytes, rest) = self.0.split_at(length);
        self.0 = rest;
        bytes
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn there_and_back<T: Cell + std::fmt::Debug>(old: &[T], new: &[T]) -> usize {
        let mut follows = old.to_vec();
        let mut out = Vec::new();
        write_cells(&mut out, &mut follows, new, |_| ());
        assert_eq!(follows, new);
        move_cells(&mut Bytes(&out), &mut follows);
        assert_eq!(follows, old);
        move_cells(&mut Bytes(&out), &mut follows);
        assert_eq!(follows, new);
        out.len()
    }

    #[test]
    fn cells_go_there_and_back() {
        assert_eq!(there_and_back::<u8>(&[], &[]), 1);
        assert_eq!(there_and_back(&[0u8; 1000], &[0; 1000]), 1);
        let mut new = [0u8; 1000];
        (new[0], new[63], new[64], new[65], new[999]) = (1, 1, 2, 3, 255);
        there_and_back(&[0; 1000], &new);
        there_and_back(&[i64::MIN, 5, -1, 7], &[i64::MAX, 5, 1, 8]);
        there_and_back(&[u32::MAX, 0], &[0, u32::MAX]);
    }

    #[test]
    fn what_counts_alike_costs_little() {
        assert!(there_and_back(&vec![41i64; 10_000], &vec![42; 10_000]) < 8);
    }

    #[test]
    fn queues_go_there_and_back() {
        for (old, new) in [
            ("", ""),
            ("", "abc"),
            ("abc", ""),
            ("abc", "abcd"),
            ("abc", "cd"),
            ("abc", "xyz"),
            ("aaa", "aaaa"),
            ("aab", "ab"),
        ] {
            let old: VecDeque<u8> = old.bytes().collect();
            let new: VecDeque<u8> = new.bytes().collect();
            let (mut queue, mut out) = (old.clone(), Vec::new());
            write_queue(&mut out, &mut queue, &new);
            assert_eq!(queue, new);
            move_queue(&mut Bytes(&out), &mut queue, Way::Back);
            assert_eq!(queue, old);
            move_queue(&mut Bytes(&out), &mut queue, Way::Forward);
            assert_eq!(queue, new);
        }
    }

    #[test]
    fn texts_go_there_and_back() {
        let texts = |words: [&str; 3]| {
            words.map(|word| {
                let mut text = Text::new(10);
                text.set(word.as_bytes());
                text
            })
        };
        let (old, new) = (texts(["a", "same", ""]), texts(["", "same", "bcd"]));
        let (mut follows, mut out) = (old.clone(), Vec::new());
        write_texts(&mut out, &mut follows, &new, |_| ());
        assert_eq!(follows, new);
        move_texts(&mut Bytes(&out), &mut follows, Way::Back);
        assert_eq!(follows, old);
        move_texts(&mut Bytes(&out), &mut follows, Way::Forward);
        assert_eq!(follows, new);
    }
}

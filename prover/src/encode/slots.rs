//! Which cells a computed slot may mean, known before a scan is followed: an index reaches the elements of its array, and
//! what is multiplied by and added to it reaches elements at equal distances.

use super::unread::each_written;
use super::uses::{Access, Cell};
use crate::number::common;
use ladder_simulator::compiled::{Code, Instr, IntegerOp, Memory as Banks, Routine, Width, Word};
use rustc_hash::{FxHashMap, FxHashSet};
use std::ops::Range;

/// Slots at equal distances. None that is meant is missing; some that are there may never be meant.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Slots {
    first: i64,
    last: i64,
    /// From one to the next; 0 for one alone.
    step: i64,
    /// Of a range's start where its elements end at the latest.
    end: Option<i64>,
}

impl Slots {
    const fn one(slot: i64) -> Slots {
        Slots {
            first: slot,
            last: slot,
            step: 0,
            end: None,
        }
    }

    /// Each of them.
    pub(crate) fn each(self) -> impl Iterator<Item = u32> {
        let step = usize::try_from(self.step.max(1)).unwrap_or(1);
        (self.first..=self.last)
            .step_by(step)
            .filter_map(|slot| u32::try_from(slot).ok())
    }

    /// How many there are at most.
    pub(crate) fn count(self) -> usize {
        usize::try_from((self.last - self.first) / self.step.max(1) + 1).unwrap_or(0)
    }

    fn plus(self, other: Slots) -> Option<Slots> {
        let last = self.last.checked_add(other.last)?;
        Some(Slots {
            first: self.first.checked_add(other.first)?,
            last,
            step: common(self.step, other.step),
            end: match (self.end, other.end) {
                (Some(end), None) => Some(end.checked_add(other.last)?),
                (None, Some(end)) => Some(end.checked_add(self.last)?),
                _ => None,
            },
        })
    }

    fn times(self, factor: i64) -> Option<Slots> {
        let ends = [self.first.checked_mul(factor)?, self.last.checked_mul(factor)?];
        Some(Slots {
            first: ends[0].min(ends[1]),
            last: ends[0].max(ends[1]),
            step: self.step.checked_mul(factor)?.checked_abs()?,
            end: None,
        })
    }

    fn or(self, other: Slots) -> Slots {
        Slots {
            first: self.first.min(other.first),
            last: self.last.max(other.last),
            step: common(common(self.step, other.step), (self.first - other.first).abs()),
            end: self.end.zip(other.end).map(|(a, b)| a.max(b)),
        }
    }
}

/// What the words of some code may mean.
#[derive(Debug, Default, Clone)]
pub(crate) struct Reach {
    /// None: something else is computed too.
    words: FxHashMap<u32, Option<Slots>>,
    /// What is never written, and no tag.
    constants: FxHashMap<u32, i64>,
}

impl Reach {
    /// Of code, where these words are no constants.
    pub(crate) fn of(code: &Code, initial: &Banks, is_tag: impl Fn(u32) -> bool) -> Reach {
        let mut reach = Reach::default();
        let mut written: FxHashSet<u32> = FxHashSet::default();
        let mut note = |cell: Cell, access: Access| {
            if let (Cell::Word(Word(at)), true) = (cell, access != Access::Read) {
                written.insert(at);
            }
        };
        for instr in &code.instrs {
            if let Instr::Unread { at } = *instr {
                each_written(&code.unread[at as usize], &reach, &mut |_, cell| {
                    note(cell, Access::Change);
                });
            }
            instr.for_each_use(&mut note);
            if let Instr::Routine { routine, operands } = *instr {
                // The words of ranges are tags.
                let pool = &code.operands[operands as usize..];
                routine.for_each_use(pool, &|words| reach.range(words), &mut note);
            }
        }
        let words = (0u32..).zip(&initial.words);
        let constants = words.filter(|(at, _)| !written.contains(at) && !is_tag(*at));
        reach.constants = constants.map(|(at, value)| (at, *value)).collect();
        for instr in &code.instrs {
            reach.follow(code, instr);
        }
        reach
    }

    fn follow(&mut self, code: &Code, instr: &Instr) {
        match *instr {
            Instr::Index { to, array, .. } => {
                let place = code.arrays[array as usize];
                let last = i64::from(place.base) + (place.last - place.first);
                self.add(to, Some(elements(place.base, last)));
            }
            Instr::Integer {
                op,
                width: Width::I64,
                to,
                a,
                b,
            } => {
                let value = self.slots(a).zip(self.slots(b));
                let value = value.and_then(|(a, b)| match op {
                    IntegerOp::Add => a.plus(b),
                    IntegerOp::Sub => a.plus(b.times(-1)?),
                    IntegerOp::Mul if a.step == 0 => b.times(a.first),
                    IntegerOp::Mul if b.step == 0 => a.times(b.first),
                    _ => None,
                });
                self.add(to, value);
            }
            Instr::Move { to, from } => self.add(to, self.slots(from)),
            Instr::Unread { at } => {
                each_written(&code.unread[at as usize], &Reach::default(), &mut |_, cell| {
                    self.forget(cell, Access::Change);
                });
            }
            Instr::Routine { routine, operands } => {
                let pool = &code.operands[operands as usize..];
                match (routine, pool) {
                    (Routine::Range, [_, _, base, first, last, start, count, ..]) => {
                        let slots = self.array(*base, [*first, *last]);
                        self.add(Word(*start), slots);
                        self.add(Word(*count), None);
                    }
                    (Routine::RangeFrom, [_, _, base, first, last, start, ..]) => {
                        let slots = self.array(*base, [*first, *last]);
                        self.add(Word(*start), slots);
                    }
                    _ => routine.for_each_use(pool, &|_| None, &mut |cell, access| {
                        self.forget(cell, access);
                    }),
                }
            }
            ref other => other.for_each_use(&mut |cell, access| self.forget(cell, access)),
        }
    }

    fn forget(&mut self, cell: Cell, access: Access) {
        if let (Cell::Word(word), true) = (cell, access != Access::Read) {
            self.add(word, None);
        }
    }

    /// The starts of ranges of an array, whose bounds are in these words.
    fn array(&self, base: u32, [first, last]: [u32; 2]) -> Option<Slots> {
        let last = i64::from(base) + self.constants.get(&last)? - self.constants.get(&first)?;
        let mut slots = elements(base, last);
        slots.end = last.checked_add(1);
        Some(slots)
    }

    fn add(&mut self, Word(to): Word, slots: Option<Slots>) {
        let merged = match self.words.get(&to) {
            None => slots,
            Some(known) => known.zip(slots).map(|(known, slots)| known.or(slots)),
        };
        self.words.insert(to, merged);
    }

    /// The slots that a word may mean.
    pub(crate) fn slots(&self, Word(at): Word) -> Option<Slots> {
        match self.constants.get(&at) {
            Some(&value) => Some(Slots::one(value)),
            None => *self.words.get(&at)?,
        }
    }

    /// The slots among which the elements of a range are: it is told by the words that hold its start and how many they are.
    pub(crate) fn range(&self, [start, count]: [u32; 2]) -> Option<Range<u32>> {
        let slots = self.slots(Word(start))?;
        let end = match (slots.end, self.constants.get(&count)) {
            (Some(end), _) => end,
            (None, Some(count)) => slots.last.checked_add(*count)?,
            (None, None) => return None,
        };
        Some(u32::try_from(slots.first).ok()?..u32::try_from(end).ok()?)
    }
}

fn elements(base: u32, last: i64) -> Slots {
    let first = i64::from(base);
    Slots {
        first,
        last,
        step: i64::from(last > first),
        end: None,
    }
}

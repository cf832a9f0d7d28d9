//! Ranges of arrays whose ends are known: filled, copied, shifted, packed, added up.

use super::Scan;
use super::cells::Cells;
use crate::graph::Lit;
use crate::number::Number;
use ladder_analysis::values::compound::EnumId;
use ladder_analysis::values::types::Scalar;
use ladder_simulator::compiled::{Bit, Memory as Banks, Routine, TYPES, Width, Word};
use std::ops::Range;

/// A range as a routine has it: the words that hold its first slot and how many there are. None: it is known only while the
/// program runs.
pub(super) fn range_of(
    initial: &Banks,
    cells: Option<&Cells>,
    [start, count]: [u32; 2],
) -> Option<Range<u32>> {
    let changes = |word: u32| {
        cells.is_some_and(|cells| cells.word_changes(Word(word)) || cells.inputs_at_words.contains_key(&word))
    };
    if changes(start) || changes(count) {
        return None;
    }
    let value = |word: u32| initial.words.get(word as usize).copied();
    let (start, count) = (value(start)?, value(count)?);
    Some(u32::try_from(start).ok()?..u32::try_from(start.checked_add(count)?).ok()?)
}

impl Scan<'_, '_> {
    fn range(&mut self, at: u32, words: [u32; 2]) -> Option<Range<u32>> {
        let range = self.memory.range(words);
        if range.is_none() {
            self.block(
                "the ends of a range of an array are known only while the program runs",
                at,
            );
        }
        range
    }

    /// A routine on ranges. False: it is another.
    pub(super) fn on_ranges(&mut self, at: u32, routine: Routine, pool: &[u32]) -> bool {
        match (routine, pool) {
            (Routine::AllHigh | Routine::AllLow, [to, start, count, ..]) => {
                let Some(range) = self.range(at, [*start, *count]) else {
                    return true;
                };
                let mut all = Lit::TRUE;
                for slot in range {
                    let bit = self.bit(Bit(slot)).negated_if(routine == Routine::AllLow);
                    all = self.world.graph.and(all, bit);
                }
                self.write_bit(Bit(*to), all);
            }
            (Routine::FillBits, [start, count, from, ..]) => {
                let Some(range) = self.range(at, [*start, *count]) else {
                    return true;
                };
                let value = self.bit(Bit(*from));
                for slot in range {
                    self.write_bit(Bit(slot), value);
                }
            }
            (Routine::FillWords, [start, count, from, ..]) => {
                let Some(range) = self.range(at, [*start, *count]) else {
                    return true;
                };
                let value = self.word(Word(*from));
                for slot in range {
                    self.write_word(Word(slot), value.clone());
                }
            }
            (Routine::SetBits | Routine::ResetBits, [en, start, count, ..]) => {
                let Some(range) = self.range(at, [*start, *count]) else {
                    return true;
                };
                let en = self.bit(Bit(*en));
                for slot in range {
                    self.write_bit_if(en, Bit(slot), Lit::constant(routine == Routine::SetBits));
                }
            }
            (Routine::CopyBits | Routine::CopyWords, [to, to_count, from, from_count, ..]) => {
                let (to, from) = (
                    self.range(at, [*to, *to_count]),
                    self.range(at, [*from, *from_count]),
                );
                let (Some(to), Some(from)) = (to, from) else {
                    return true;
                };
                if to.len() != from.len() {
                    self.fault(at, Lit::TRUE);
                    return true;
                }
                // As if through a buffer.
                if routine == Routine::CopyBits {
                    let values: Vec<Lit> = from.map(|slot| self.bit(Bit(slot))).collect();
                    to.zip(values)
                        .for_each(|(slot, value)| self.write_bit(Bit(slot), value));
                } else {
                    let values: Vec<Number> = from.map(|slot| self.word(Word(slot))).collect();
                    to.zip(values)
                        .for_each(|(slot, value)| self.write_word(Word(slot), value));
                }
            }
            (Routine::ShiftBits, [start, count, entering, ..]) => {
                let Some(range) = self.range(at, [*start, *count]) else {
                    return true;
                };
                let mut values = vec![self.bit(Bit(*entering))];
                values.extend(range.clone().map(|slot| self.bit(Bit(slot))));
                range
                    .zip(values)
                    .for_each(|(slot, value)| self.write_bit(Bit(slot), value));
            }
            (Routine::ShiftWords, [start, count, entering, ..]) => {
                let Some(range) = self.range(at, [*start, *count]) else {
                    return true;
                };
                let mut values = vec![self.word(Word(*entering))];
                values.extend(range.clone().map(|slot| self.word(Word(slot))));
                range
                    .zip(values)
                    .for_each(|(slot, value)| self.write_word(Word(slot), value));
            }
            (Routine::PackBits, [to, ty, start, count, ..]) if is_whole(*ty) => {
                let width = width(*ty);
                let Some(range) = self.range(at, [*start, *count]) else {
                    return true;
                };
                if range.len() > width.bits() as usize {
                    self.fault(at, Lit::TRUE);
                    return true;
                }
                let bits: Vec<Lit> = range.map(|slot| self.bit(Bit(slot))).collect();
                self.write_word(Word(*to), Number::unsigned(bits).wrapped(width));
            }
            (Routine::UnpackBits, [start, count, from, ty, ..]) if is_whole(*ty) => {
                let width = width(*ty).bits() as usize;
                let Some(range) = self.range(at, [*start, *count]) else {
                    return true;
                };
                let value = self.word(Word(*from));
                for (n, slot) in range.enumerate() {
                    let bit = if n < width { value.bit(n) } else { Lit::FALSE };
                    self.write_bit(Bit(slot), bit);
                }
            }
            (Routine::Sum, [to, ty, start, count, ..]) if is_whole(*ty) => {
                let Some(range) = self.range(at, [*start, *count]) else {
                    return true;
                };
                let mut total = Number::constant(0);
                for slot in range {
                    let value = self.word(Word(slot));
                    total = self.world.graph.add(&total, &value).wrapped(width(*ty));
                }
                self.write_word(Word(*to), total);
            }
            (Routine::Enumerate, [to, ty, from, ..]) => {
                let value = self.word(Word(*from));
                if let Some(id) = ty.checked_sub(TYPES.len() as u32).and_then(EnumId::from_number) {
                    let values = &id.get().values;
                    let is_one: Vec<Lit> = (values.iter())
                        .map(|(_, named)| {
                            self.world
                                .graph
                                .equal(&value, &Number::constant(i64::from(*named)))
                        })
                        .collect();
                    let is_valid = self.world.graph.any(is_one);
                    self.fault(at, !is_valid);
                }
                self.write_word(Word(*to), value);
            }
            _ => return false,
        }
        true
    }
}

fn width(ty: u32) -> Width {
    Width::of(TYPES.get(ty as usize).copied().unwrap_or(Scalar::Lint))
}

fn is_whole(ty: u32) -> bool {
    TYPES.get(ty as usize).is_some_and(|ty| !ty.is_real())
}

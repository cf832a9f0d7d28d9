//! `[SEARCH]`.

use super::Operands;
use crate::memory::{Memory, TextSlot, Word};
use crate::operation::Width;
use ladder_analysis::values::types::Scalar;
use std::cmp::Ordering;

/// Looks for the first element that compares with a as asked, after index y if NEXT is high.
pub(super) fn search<const FORCED: bool>(memory: &mut Memory, with: &mut Operands) {
    let (y, width) = (with.word(), Width::of(with.ty()));
    let first = with.value(memory);
    let test = with.test();
    let (a, a_type) = (with.number(), with.ty());
    let range = with.range(memory);
    let element = with.ty();
    if element.is_string() {
        with.count(range.len().saturating_mul(memory.text(TextSlot(a)).len()));
    }
    let base = with.number() as usize;
    let (next, found) = (with.bit(), with.bit());

    let nothing = width.wrap(-1);
    let before = memory.word(y);
    // Indices of the array are compared as numbers: y may be unsigned.
    let index_of = |slot: usize| first + (slot - base) as i64;
    let hit = if memory.bit(next) && before == nothing {
        None
    } else {
        let after = |slot: &usize| !memory.bit(next) || i128::from(index_of(*slot)) > width.number(before);
        range
            .filter(after)
            .find(|&slot| test.holds(compare(memory, slot, element, a, a_type)))
    };
    memory.put_word::<FORCED>(y, hit.map_or(nothing, |slot| width.wrap(index_of(slot))));
    memory.put_bit::<FORCED>(found, hit.is_some());
}

fn compare(memory: &Memory, slot: usize, element: Scalar, a: u32, a_type: Scalar) -> Ordering {
    if element == Scalar::Bool {
        return memory.bits[slot].cmp(&memory.bits[a as usize]);
    }
    if element.is_string() {
        return memory.text(TextSlot(slot as u32)).cmp(memory.text(TextSlot(a)));
    }
    let (left, right) = (memory.word(Word(slot as u32)), memory.word(Word(a)));
    if element.is_real() || a_type.is_real() {
        let real = |word: i64, ty: Scalar| {
            if ty.is_real() {
                f64::from_bits(word as u64)
            } else {
                word as f64
            }
        };
        return real(left, element)
            .partial_cmp(&real(right, a_type))
            .unwrap_or(Ordering::Less);
    }
    Width::of(element)
        .number(left)
        .cmp(&Width::of(a_type).number(right))
}

//! Ranges of arrays: finding, filling, copying, shifting, packing.

use super::Operands;
use crate::fault::Trouble;
use crate::memory::{Bit, Memory, TextSlot, Word};
use crate::operation::{IntegerOp, RealOp, Width, integer, real};
use ladder_analysis::values::types::Scalar;
use std::ops::Range;

/// A range whose ends are known only now.
pub(super) fn find(memory: &mut Memory, with: &mut Operands) -> Result<(), Trouble> {
    let (from, to) = (with.value(memory), with.value(memory));
    let base = with.number();
    let (first, last) = (with.value(memory), with.value(memory));
    for index in [from, to] {
        if index < first || index > last {
            return Err(Trouble::Index { index, first, last });
        }
    }
    if from > to {
        return Err(Trouble::EmptyRange { from, to });
    }
    let (start, count) = (with.word(), with.word());
    memory.words[start.0 as usize] = i64::from(base) + (from - first);
    memory.words[count.0 as usize] = to - from + 1;
    Ok(())
}

/// A range that begins at an index and is as long as another.
pub(super) fn find_from(memory: &mut Memory, with: &mut Operands) -> Result<(), Trouble> {
    let (from, count) = (with.value(memory), with.value(memory));
    let base = with.number();
    let (first, last) = (with.value(memory), with.value(memory));
    for index in [from, from.saturating_add(count - 1)] {
        if index < first || index > last {
            return Err(Trouble::Index { index, first, last });
        }
    }
    let start = with.word();
    memory.words[start.0 as usize] = i64::from(base) + (from - first);
    Ok(())
}

/// Whether all bits of a range are the same as `value`.
pub(super) fn all(memory: &mut Memory, with: &mut Operands, value: u8) {
    let to = with.bit();
    let range = with.range(memory);
    let all = memory.bits[range].iter().all(|&bit| bit == value);
    memory.set_bit(to, all);
}

pub(super) fn fill_bits<const FORCED: bool>(memory: &mut Memory, with: &mut Operands) {
    let range = with.range(memory);
    let value = memory.bit(with.bit());
    write_bits::<FORCED>(memory, range, value);
}

pub(super) fn fill_words<const FORCED: bool>(memory: &mut Memory, with: &mut Operands) {
    let range = with.range(memory);
    let value = with.value(memory);
    for slot in range {
        memory.put_word::<FORCED>(Word(slot as u32), value);
    }
}

pub(super) fn fill_texts<const FORCED: bool>(memory: &mut Memory, with: &mut Operands) {
    let range = with.range(memory);
    let from = with.text();
    with.count(range.len().saturating_mul(memory.text(from).len()));
    for slot in range {
        memory.copy_text::<FORCED>(TextSlot(slot as u32), from);
    }
}

/// Each slot of a range with the one of a shorter range that goes into it: that is repeated. Where it lies in the first, it begins
/// at a multiple of its length there, and so stays as it is.
fn repeated(memory: &Memory, with: &mut Operands) -> impl Iterator<Item = (usize, usize)> + use<> {
    let (to, from) = (with.range(memory), with.range(memory));
    let count = from.len().max(1);
    to.enumerate().map(move |(n, to)| (to, from.start + n % count))
}

pub(super) fn repeat_bits<const FORCED: bool>(memory: &mut Memory, with: &mut Operands) {
    for (to, from) in repeated(memory, with) {
        let value = memory.bits[from] != 0;
        memory.put_bit::<FORCED>(Bit(to as u32), value);
    }
}

pub(super) fn repeat_words<const FORCED: bool>(memory: &mut Memory, with: &mut Operands) {
    for (to, from) in repeated(memory, with) {
        let value = memory.words[from];
        memory.put_word::<FORCED>(Word(to as u32), value);
    }
}

pub(super) fn repeat_texts<const FORCED: bool>(memory: &mut Memory, with: &mut Operands) {
    for (to, from) in repeated(memory, with) {
        with.count(memory.texts[from].bytes().len());
        memory.copy_text::<FORCED>(TextSlot(to as u32), TextSlot(from as u32));
    }
}

pub(super) fn write_bits_when<const FORCED: bool>(memory: &mut Memory, with: &mut Operands, value: bool) {
    if memory.bit(with.bit()) {
        let range = with.range(memory);
        write_bits::<FORCED>(memory, range, value);
    }
}

fn write_bits<const FORCED: bool>(memory: &mut Memory, range: Range<usize>, value: bool) {
    for slot in range {
        memory.put_bit::<FORCED>(Bit(slot as u32), value);
    }
}

/// Two ranges of one length.
fn two(memory: &Memory, with: &mut Operands) -> Result<(Range<usize>, Range<usize>), Trouble> {
    let (to, from) = (with.range(memory), with.range(memory));
    if to.len() == from.len() {
        Ok((to, from))
    } else {
        Err(Trouble::Lengths {
            to: to.len() as i64,
            from: from.len() as i64,
        })
    }
}

/// The order in which elements are copied so that none is overwritten before it was read: as if through a buffer.
fn pairs(to: Range<usize>, from: Range<usize>) -> impl Iterator<Item = (usize, usize)> {
    let (len, upwards) = (to.len(), to.start <= from.start);
    (0..len).map(move |n| {
        let n = if upwards { n } else { len - 1 - n };
        (to.start + n, from.start + n)
    })
}

pub(super) fn copy_bits<const FORCED: bool>(memory: &mut Memory, with: &mut Operands) -> Result<(), Trouble> {
    let (to, from) = two(memory, with)?;
    for (to, from) in pairs(to, from) {
        let value = memory.bits[from] != 0;
        memory.put_bit::<FORCED>(Bit(to as u32), value);
    }
    Ok(())
}

pub(super) fn copy_words<const FORCED: bool>(
    memory: &mut Memory,
    with: &mut Operands,
) -> Result<(), Trouble> {
    let (to, from) = two(memory, with)?;
    for (to, from) in pairs(to, from) {
        let value = memory.words[from];
        memory.put_word::<FORCED>(Word(to as u32), value);
    }
    Ok(())
}

pub(super) fn copy_texts<const FORCED: bool>(
    memory: &mut Memory,
    with: &mut Operands,
) -> Result<(), Trouble> {
    let (to, from) = two(memory, with)?;
    for (to, from) in pairs(to, from) {
        with.count(memory.texts[from].bytes().len());
        memory.copy_text::<FORCED>(TextSlot(to as u32), TextSlot(from as u32));
    }
    Ok(())
}

pub(super) fn shift_bits<const FORCED: bool>(memory: &mut Memory, with: &mut Operands) {
    let range = with.range(memory);
    let entering = memory.bit(with.bit());
    for (to, from) in pairs(range.start + 1..range.end, range.start..range.end - 1) {
        let value = memory.bits[from] != 0;
        memory.put_bit::<FORCED>(Bit(to as u32), value);
    }
    memory.put_bit::<FORCED>(Bit(range.start as u32), entering);
}

pub(super) fn shift_words<const FORCED: bool>(memory: &mut Memory, with: &mut Operands) {
    let range = with.range(memory);
    let entering = with.value(memory);
    for (to, from) in pairs(range.start + 1..range.end, range.start..range.end - 1) {
        let value = memory.words[from];
        memory.put_word::<FORCED>(Word(to as u32), value);
    }
    memory.put_word::<FORCED>(Word(range.start as u32), entering);
}

/// What enters is in a slot outside the range.
pub(super) fn shift_texts<const FORCED: bool>(memory: &mut Memory, with: &mut Operands) {
    let range = with.range(memory);
    let entering = with.text();
    for (to, from) in pairs(range.start + 1..range.end, range.start..range.end - 1) {
        with.count(memory.texts[from].bytes().len());
        memory.copy_text::<FORCED>(TextSlot(to as u32), TextSlot(from as u32));
    }
    memory.copy_text::<FORCED>(TextSlot(range.start as u32), entering);
}

/// How wide a value is that is packed; a real has the bits that IEEE 754 says.
fn width_of(ty: Scalar) -> Width {
    Width::of(match ty {
        Scalar::Real => Scalar::Dword,
        Scalar::Lreal => Scalar::Lword,
        ty => ty,
    })
}

/// The word of memory that holds these bits as a value of a type.
fn of_bits(ty: Scalar, bits: i64) -> Result<i64, Trouble> {
    let real = match ty {
        Scalar::Real => f64::from(f32::from_bits(bits as u32)),
        Scalar::Lreal => f64::from_bits(bits as u64),
        _ => return Ok(bits),
    };
    // No tag holds an infinity, or what is not a number.
    if real.is_finite() {
        Ok(real.to_bits() as i64)
    } else {
        Err(Trouble::NotFinite)
    }
}

/// The bits of a value of a type, from the word of memory that holds it.
fn bits_of(ty: Scalar, word: i64) -> i64 {
    match ty {
        Scalar::Real => i64::from((f64::from_bits(word as u64) as f32).to_bits()),
        _ => word,
    }
}

/// Bits into a word, the first as bit 0.
pub(super) fn pack_bits<const FORCED: bool>(memory: &mut Memory, with: &mut Operands) -> Result<(), Trouble> {
    let (to, ty) = (with.word(), with.ty());
    let width = width_of(ty);
    let range = with.range(memory);
    if range.len() > width.bits() as usize {
        return Err(Trouble::Lengths {
            to: i64::from(width.bits()),
            from: range.len() as i64,
        });
    }
    let bits = memory.bits[range].iter().enumerate();
    let value = bits.fold(0u64, |value, (n, &bit)| value | u64::from(bit) << n);
    memory.put_word::<FORCED>(to, of_bits(ty, width.wrap(value as i64))?);
    Ok(())
}

/// Words into a wider one, the first as the lowest part.
pub(super) fn pack_words<const FORCED: bool>(
    memory: &mut Memory,
    with: &mut Operands,
) -> Result<(), Trouble> {
    let (to, ty) = (with.word(), with.ty());
    let width = width_of(ty);
    let range = with.range(memory);
    let part = Width::of(with.ty()).bits();
    let room = (width.bits() / part) as usize;
    if range.len() > room {
        return Err(Trouble::Lengths {
            to: room as i64,
            from: range.len() as i64,
        });
    }
    let mask = u64::MAX >> (64 - part);
    let words = memory.words[range].iter().enumerate();
    let value = words.fold(0u64, |value, (n, &word)| {
        value | (word as u64 & mask) << (n as u32 * part)
    });
    memory.put_word::<FORCED>(to, of_bits(ty, width.wrap(value as i64))?);
    Ok(())
}

/// Elements past the width of the value are cleared.
pub(super) fn unpack_bits<const FORCED: bool>(memory: &mut Memory, with: &mut Operands) {
    let range = with.range(memory);
    let (value, ty) = (with.value(memory), with.ty());
    let (value, width) = (bits_of(ty, value), width_of(ty).bits());
    for (n, slot) in range.enumerate() {
        let bit = n < width as usize && value >> n & 1 != 0;
        memory.put_bit::<FORCED>(Bit(slot as u32), bit);
    }
}

pub(super) fn unpack_words<const FORCED: bool>(memory: &mut Memory, with: &mut Operands) {
    let range = with.range(memory);
    let part = Width::of(with.ty());
    let (value, ty) = (with.value(memory), with.ty());
    let (value, width) = (bits_of(ty, value), width_of(ty).bits());
    for (n, slot) in range.enumerate() {
        let shift = n as u32 * part.bits();
        let word = if shift < width {
            (value as u64 & (u64::MAX >> (64 - width))) >> shift
        } else {
            0
        };
        memory.put_word::<FORCED>(Word(slot as u32), part.wrap(word as i64));
    }
}

/// Adds up a range, each step in the type of the result.
pub(super) fn sum(memory: &mut Memory, with: &mut Operands) -> Result<(), Trouble> {
    let (to, ty) = (with.word(), with.ty());
    let range = with.range(memory);
    let element = with.ty();
    if ty.is_real() {
        let single = ty == Scalar::Real;
        let mut total = 0.0;
        for &word in &memory.words[range] {
            let value = if element.is_real() {
                f64::from_bits(word as u64)
            } else {
                word as f64
            };
            total = real(RealOp::Add, single, total, value)?;
        }
        memory.words[to.0 as usize] = total.to_bits() as i64;
        return Ok(());
    }
    let mut total = 0;
    for &word in &memory.words[range] {
        total = integer(IntegerOp::Add, Width::of(ty), total, word)?;
    }
    memory.words[to.0 as usize] = total;
    Ok(())
}

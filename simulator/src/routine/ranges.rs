//! Ranges of arrays.

use super::Operands;
use crate::fault::Trouble;
use crate::memory::{Bit, Memory};

/// A range whose ends are known only now.
pub(super) fn find(memory: &mut Memory, mut operands: Operands) -> Result<(), Trouble> {
    let (from, to) = (memory.word(operands.word()), memory.word(operands.word()));
    let base = operands.number();
    let (first, last) = (memory.word(operands.word()), memory.word(operands.word()));
    for index in [from, to] {
        if index < first || index > last {
            return Err(Trouble::Index { index, first, last });
        }
    }
    if from > to {
        return Err(Trouble::Lengths {
            to: to - from + 1,
            from: 1,
        });
    }
    let (start, count) = (operands.word(), operands.word());
    memory.words[start.0 as usize] = i64::from(base) + (from - first);
    memory.words[count.0 as usize] = to - from + 1;
    Ok(())
}

/// Whether all bits of a range are the same as `value`.
pub(super) fn all(memory: &mut Memory, mut operands: Operands, value: u8) {
    let to = operands.bit();
    let range = operands.range(memory);
    let all = memory.bits[range].iter().all(|&bit| bit == value);
    memory.set_bit(to, all);
}

pub(super) fn fill_bits<const FORCED: bool>(memory: &mut Memory, mut operands: Operands) {
    let range = operands.range(memory);
    let value = memory.bit(operands.bit());
    write_bits::<FORCED>(memory, range, value);
}

pub(super) fn write_bits_when<const FORCED: bool>(memory: &mut Memory, mut operands: Operands, value: bool) {
    if memory.bit(operands.bit()) {
        let range = operands.range(memory);
        write_bits::<FORCED>(memory, range, value);
    }
}

fn write_bits<const FORCED: bool>(memory: &mut Memory, range: std::ops::Range<usize>, value: bool) {
    if FORCED {
        for slot in range {
            memory.put_bit::<FORCED>(Bit(slot as u32), value);
        }
    } else {
        memory.bits[range].fill(u8::from(value));
    }
}

//! Routines: the work that is too rare or too long to be an instruction of its own. Each takes its operands, slots
//! and numbers, from the code's operand pool.

mod ranges;

use crate::fault::Trouble;
use crate::memory::{Bit, Memory, Word};
use crate::timers::Clock;

/// Which routine; behind each what its operands are. A range is two words: the slot of its first element, and how
/// many there are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Routine {
    /// Finds a range whose ends are known only now: first and last index, base slot, first and last index of the
    /// array, to: start, count.
    Range,
    /// Whether all bits of a range are high: to, range.
    AllHigh,
    /// Whether none is: to, range.
    AllLow,
    /// Writes one bit into a range: range, from.
    FillBits,
    /// Sets the bits of a range if EN is high: EN, range.
    SetBits,
    /// Clears them likewise.
    ResetBits,
}

/// Operands in their order.
pub(crate) struct Operands<'c> {
    rest: std::slice::Iter<'c, u32>,
}

impl Operands<'_> {
    fn number(&mut self) -> u32 {
        self.rest.next().copied().unwrap_or(0)
    }

    fn bit(&mut self) -> Bit {
        Bit(self.number())
    }

    fn word(&mut self) -> Word {
        Word(self.number())
    }

    /// The slots of a range.
    fn range(&mut self, memory: &Memory) -> std::ops::Range<usize> {
        let (start, count) = (self.word(), self.word());
        let start = memory.word(start) as usize;
        start..start + memory.word(count) as usize
    }
}

/// Runs a routine.
pub(crate) fn run<const FORCED: bool>(
    routine: Routine,
    memory: &mut Memory,
    operands: &[u32],
    _clock: Clock,
) -> Result<(), Trouble> {
    let operands = Operands {
        rest: operands.iter(),
    };
    match routine {
        Routine::Range => ranges::find(memory, operands),
        Routine::AllHigh => {
            ranges::all(memory, operands, 1);
            Ok(())
        }
        Routine::AllLow => {
            ranges::all(memory, operands, 0);
            Ok(())
        }
        Routine::FillBits => {
            ranges::fill_bits::<FORCED>(memory, operands);
            Ok(())
        }
        Routine::SetBits => {
            ranges::write_bits_when::<FORCED>(memory, operands, true);
            Ok(())
        }
        Routine::ResetBits => {
            ranges::write_bits_when::<FORCED>(memory, operands, false);
            Ok(())
        }
    }
}

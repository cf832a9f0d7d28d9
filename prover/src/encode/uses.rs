//! Which cells instructions read and write, where it is known which a computed slot may mean.

use super::slots::Reach;
use super::unread::each_written;
use ladder_instructions::Op;
pub(super) use ladder_simulator::compiled::uses::{Access, Cell};
use ladder_simulator::compiled::{Bit, Code, Instr, Word};
use std::ops::Range;

/// Each use of a cell in a stretch of code, with its instruction.
pub(super) fn for_each_access(
    code: &Code,
    reach: &Reach,
    stretch: Range<u32>,
    each: &mut dyn FnMut(u32, Cell, Access),
) {
    for at in stretch {
        let Some(instr) = code.instrs.get(at as usize) else {
            return;
        };
        let each = &mut |cell, access| each(at, cell, access);
        instr.for_each_use(each);
        match *instr {
            Instr::StoreBit { at: slot, .. } => stored(reach, slot, &|n| Cell::Bit(Bit(n)), each),
            Instr::StoreWord { at: slot, .. } => stored(reach, slot, &|n| Cell::Word(Word(n)), each),
            Instr::StateAt { .. } | Instr::ClearAt { .. } => match chosen(reach, instr) {
                None => each(Cell::Unknown, Access::Change),
                Some(all) => all.for_each(|(_, _, instr)| instr.for_each_use(each)),
            },
            Instr::Unread { at: number } => {
                each_written(&code.unread[number as usize], reach, &mut |_, cell| {
                    each(cell, Access::Change);
                });
            }
            Instr::Routine { routine, operands } => {
                let pool = &code.operands[operands as usize..];
                routine.for_each_use(pool, &|words| reach.range(words), each);
            }
            _ => {}
        }
    }
}

fn stored(reach: &Reach, slot: Word, cell: &dyn Fn(u32) -> Cell, each: &mut dyn FnMut(Cell, Access)) {
    match reach.slots(slot) {
        Some(slots) => slots.each().for_each(|n| each(cell(n), Access::Change)),
        None => each(Cell::Unknown, Access::Change),
    }
}

/// The instructions that one whose timer, counter or bistable is chosen by an index may be: with the slots of their bits and
/// words. None: it is not known which.
pub(super) fn chosen(
    reach: &Reach,
    instr: &Instr,
) -> Option<impl Iterator<Item = (u32, u32, Instr)> + use<>> {
    let (Instr::StateAt { bits, words, .. } | Instr::ClearAt { bits, words, .. }) = *instr else {
        return None;
    };
    let (bits, words) = (reach.slots(bits)?, reach.slots(words)?);
    // A bistable has no words.
    if words.count() != 1 && words.count() != bits.count() {
        return None;
    }
    let instr = *instr;
    let last = words.each().last()?;
    let words = words.each().chain(std::iter::repeat(last));
    Some(
        bits.each()
            .zip(words)
            .map(move |(bits, words)| (bits, words, fixed(instr, Bit(bits), Word(words)))),
    )
}

/// The same for a timer, counter or bistable that is known.
fn fixed(instr: Instr, bits: Bit, words: Word) -> Instr {
    use Instr as I;
    let (op, out, en, operand) = match instr {
        I::StateAt {
            op, out, en, operand, ..
        } => (op, out, en, operand),
        I::ClearAt { en, state, .. } => {
            return I::Clear {
                en,
                state,
                bits,
                words,
            };
        }
        other => return other,
    };
    let (pt, pv, reset) = (Word(operand), Word(operand), Bit(operand));
    #[rustfmt::skip]
    let instr = match op {
        Op::Tof => I::Tof { out, en, pt, bits, words },
        Op::Tp => I::Tp { out, en, pt, bits, words },
        Op::Rto => I::Rto { out, en, pt, bits, words },
        Op::Rtof => I::Rtof { out, en, pt, bits, words },
        Op::Ctu => I::Ctu { out, en, pv, bits, words },
        Op::Ctd => I::Ctd { out, en, pv, bits, words },
        Op::Ctud => I::Ctud { out, en, pv, bits, words },
        Op::Ctc => I::Ctc { out, en, pv, bits, words },
        Op::Sr => I::Sr { out, en, reset, bits },
        Op::Rs => I::Rs { out, en, reset, bits },
        _ => I::Ton { out, en, pt, bits, words },
    };
    instr
}

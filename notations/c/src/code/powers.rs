//! What is known of powers before the program runs.

use ladder_simulator::compiled::uses::{Access, Cell};
use ladder_simulator::compiled::{Bit, Code, Compiled, Home, Instr};
use std::collections::{HashMap, HashSet};

/// The powers that one instruction writes and the table of uses says who reads, with how often that is. Tags are not among them.
pub(super) struct Powers(HashMap<Bit, u32>);

impl Powers {
    pub(super) fn of(compiled: &Compiled) -> Powers {
        let code = &compiled.code;
        let (mut reads, mut writes) = (HashMap::<Bit, u32>::new(), HashMap::<Bit, u32>::new());
        for instr in &code.instrs {
            instr.for_each_use(&mut |cell, access| {
                if let Cell::Bit(bit) = cell {
                    *reads.entry(bit).or_default() += u32::from(access != Access::Write);
                    *writes.entry(bit).or_default() += u32::from(access != Access::Read);
                }
            });
        }
        let mut powers: HashMap<Bit, u32> = (writes.into_iter())
            .filter(|(_, writes)| *writes == 1)
            .map(|(bit, _)| (bit, reads.get(&bit).copied().unwrap_or(0)))
            .collect();
        for home in &compiled.homes {
            if let Home::Bits { at, len, .. } = home {
                (at.0..at.0 + len).for_each(|at| {
                    powers.remove(&Bit(at));
                });
            }
        }
        // A routine's operands are bits and words; and a block with a fault clears its power.
        let faulting = (0..).zip(&code.instrs).filter(|(_, instr)| instr.can_fault());
        let others = (code.operands.iter().map(|operand| Bit(*operand)))
            .chain(code.saved.iter().flatten().copied())
            .chain(faulting.map(|(at, _)| code.blocks[code.block_at(at) as usize].out));
        others.for_each(|bit| {
            powers.remove(&bit);
        });
        Powers(powers)
    }

    /// Those that are read in so many places.
    pub(super) fn read(&self, times: u32) -> HashSet<Bit> {
        let read = self.0.iter().filter(|(_, reads)| **reads == times);
        read.map(|(bit, _)| *bit).collect()
    }

    /// Those that are on whenever they are read: they follow from the rail, where no zone takes its power.
    pub(super) fn always(&self, code: &Code, has_zones: bool) -> HashSet<Bit> {
        let mut always = HashSet::new();
        for instr in &code.instrs {
            let (out, follows) = match *instr {
                Instr::Rail { out } => (out, !has_zones),
                Instr::Follow { out, en }
                | Instr::Powered { out, en, .. }
                | Instr::MoveWhen { out, en, .. } => (out, en == Bit::HIGH || always.contains(&en)),
                _ => continue,
            };
            if follows && self.0.contains_key(&out) {
                always.insert(out);
            }
        }
        always
    }
}

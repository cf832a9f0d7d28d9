//! Fusing: contacts, joins and coils become truth tables.
//!
//! Most of a ladder program is small boolean networks. One instruction each costs more in deciding what comes next
//! than in doing it, so stretches of them are gathered into groups that read at most three bits; a group's results
//! are truth tables of eight entries. A [`Record`] looks up one result. All records that follow each other run in
//! one loop, and each remembers in one byte which row of its table it took: from that the power of every element of
//! the group can be computed afterwards ([`Power::Row`]), at no cost while scanning.
//!
//! Fused code does the same as the plain code it is made of, as long as no bit is forced; with forces the plain code
//! runs.

use crate::code::{BlockPlace, Code, Instr, Record};
use crate::memory::{Bit, Memory};
use crate::uses::{Access, Cell};

/// Where the power of an element is found after a scan of fused code.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Power {
    /// In a bit of its own.
    Slot(Bit),
    /// In the row that a record took: the row's bit in the truth table.
    Row { record: u32, truth: u8 },
}

/// The truth tables of a group's three inputs themselves.
const INPUT: [u8; 3] = [0b1010_1010, 0b1100_1100, 0b1111_0000];

/// Fused code, and where the power of each bit slot of the plain code is found.
#[derive(Debug)]
pub(crate) struct Fused {
    pub(crate) code: Code,
    powers: Vec<Power>,
}

impl Fused {
    /// Where a power is found.
    pub(crate) fn power(&self, slot: Bit) -> Power {
        self.powers
            .get(slot.0 as usize)
            .copied()
            .unwrap_or(Power::Slot(slot))
    }
}

/// Fuses a program's code. `temporary` has for each bit whether nothing but code reads it; memory may grow by bits
/// that fused code needs.
pub(crate) fn fuse(plain: &Code, mut temporary: Vec<bool>, memory: &mut Memory) -> Fused {
    let mut is_target = vec![false; plain.instrs.len() + 1];
    for block in &plain.blocks {
        let instrs = &plain.instrs[block.start as usize..block.end as usize];
        if instrs.iter().any(Instr::can_fault) {
            // A fault goes on after the block: what the block would have written must not be found there.
            is_target[block.end as usize] = true;
            // It takes the block's power back, in its slot.
            if let Some(temporary) = temporary.get_mut(block.out.0 as usize) {
                *temporary = false;
            }
        }
    }
    let mut last_read = vec![0; memory.bits.len()];
    for (at, instr) in plain.instrs.iter().enumerate() {
        // Nothing of a routine or of a state is temporary.
        instr.for_each_use(&mut |cell, access| {
            if let (Cell::Bit(bit), Access::Read) = (cell, access) {
                last_read[bit.0 as usize] = at as u32;
            }
        });
        instr.for_each_target(|to| is_target[to as usize] = true);
    }
    for powers in &plain.saved {
        for power in powers {
            last_read[power.0 as usize] = u32::MAX;
        }
    }
    let mut fuser = Fuser {
        plain,
        temporary: &temporary,
        last_read,
        memory,
        instrs: Vec::with_capacity(plain.instrs.len() / 2),
        records: Vec::new(),
        // The plain instruction that each fused one reaches up to, for the count of work.
        reaches: Vec::new(),
        powers: Vec::new(),
        group: Group::default(),
        may_extend: false,
    };
    fuser.powers = (0..fuser.memory.bits.len() as u32)
        .map(|bit| Power::Slot(Bit(bit)))
        .collect();
    let moved = fuser.walk(&is_target);
    fuser.memory.fill_up_bits();
    let mut code = Code {
        work_through: fuser
            .reaches
            .iter()
            .map(|&at| plain.work_through[at as usize])
            .collect(),
        instrs: fuser.instrs,
        records: fuser.records,
        blocks: Vec::with_capacity(plain.blocks.len()),
        arrays: plain.arrays.clone(),
        networks: Vec::new(),
        stops: Vec::new(),
        operands: plain.operands.clone(),
        saved: plain.saved.clone(),
        unread: Vec::new(),
        relays: plain.relays,
        main: plain.main,
    };
    code.blocks.extend(plain.blocks.iter().map(|block| BlockPlace {
        start: moved[block.start as usize],
        end: moved[block.end as usize],
        ..*block
    }));
    for instr in &mut code.instrs {
        instr.for_each_target_mut(|to| *to = moved[*to as usize]);
    }
    Fused {
        code,
        powers: fuser.powers,
    }
}

struct Fuser<'c> {
    plain: &'c Code,
    temporary: &'c [bool],
    last_read: Vec<u32>,
    memory: &'c mut Memory,
    instrs: Vec<Instr>,
    records: Vec<Record>,
    reaches: Vec<u32>,
    powers: Vec<Power>,
    group: Group,
    /// Whether the last instruction is a run of records that more may join: nothing jumps to after it.
    may_extend: bool,
}

/// A group writes at most this many bits: each of them is looked for among the others.
const MOST_WRITTEN: usize = 64;

/// Boolean instructions that read at most three bits in all.
#[derive(Default)]
struct Group {
    inputs: Vec<Bit>,
    /// What was written, in order, with its truth table.
    written: Vec<(Bit, u8)>,
}

impl Group {
    /// The table of a bit as it is at this point of the group; none if it would be a fourth input.
    fn read(&mut self, bit: Bit) -> Option<u8> {
        match bit {
            Bit::LOW => return Some(0),
            Bit::HIGH => return Some(u8::MAX),
            _ => {}
        }
        if let Some(&(_, truth)) = self.written.iter().rev().find(|(written, _)| *written == bit) {
            return Some(truth);
        }
        let at = match self.inputs.iter().position(|&input| input == bit) {
            Some(at) => at,
            None if self.inputs.len() < INPUT.len() => {
                self.inputs.push(bit);
                self.inputs.len() - 1
            }
            None => return None,
        };
        Some(INPUT[at])
    }

    /// Takes an instruction in. False if it does not fit any more; the group may then have gained an input that
    /// nothing reads, which does no harm.
    fn take(&mut self, instr: &Instr) -> bool {
        if self.written.len() == MOST_WRITTEN {
            return false;
        }
        let written = match *instr {
            Instr::Contact { out, en, tag } => self.combine(en, tag, |en, tag| en & tag).map(|t| (out, t)),
            Instr::NegatedContact { out, en, tag } => {
                self.combine(en, tag, |en, tag| en & !tag).map(|t| (out, t))
            }
            Instr::Join { out, upper, lower } => self.combine(upper, lower, |a, b| a | b).map(|t| (out, t)),
            Instr::AndBit { to, a, b } => self.combine(a, b, |a, b| a & b).map(|t| (to, t)),
            Instr::OrBit { to, a, b } => self.combine(a, b, |a, b| a | b).map(|t| (to, t)),
            Instr::XorBit { to, a, b } => self.combine(a, b, |a, b| a ^ b).map(|t| (to, t)),
            Instr::Set { en, tag } => self.combine(en, tag, |en, tag| en | tag).map(|t| (tag, t)),
            Instr::Reset { en, tag } => self.combine(en, tag, |en, tag| !en & tag).map(|t| (tag, t)),
            Instr::Invert { out: to, en: a }
            | Instr::NotBit { to, a }
            | Instr::NegatedCoil { en: a, tag: to } => self.read(a).map(|a| (to, !a)),
            Instr::MoveBit { to, from: a } | Instr::Coil { en: a, tag: to } => self.read(a).map(|a| (to, a)),
            _ => None,
        };
        match written {
            Some(written) => {
                self.written.push(written);
                true
            }
            None => false,
        }
    }

    fn combine(&mut self, a: Bit, b: Bit, with: impl Fn(u8, u8) -> u8) -> Option<u8> {
        let a = self.read(a)?;
        Some(with(a, self.read(b)?))
    }
}

/// Whether an instruction reads and writes bits only, and nothing else happens.
fn is_boolean(instr: &Instr) -> bool {
    matches!(
        instr,
        Instr::Contact { .. }
            | Instr::NegatedContact { .. }
            | Instr::Join { .. }
            | Instr::Invert { .. }
            | Instr::Coil { .. }
            | Instr::NegatedCoil { .. }
            | Instr::Set { .. }
            | Instr::Reset { .. }
            | Instr::MoveBit { .. }
            | Instr::AndBit { .. }
            | Instr::OrBit { .. }
            | Instr::XorBit { .. }
            | Instr::NotBit { .. }
    )
}

impl Fuser<'_> {
    /// Walks the plain code; gives for each plain instruction, and the end, where it went.
    fn walk(&mut self, is_target: &[bool]) -> Vec<u32> {
        let plain = self.plain;
        let mut moved = Vec::with_capacity(plain.instrs.len() + 1);
        // Up to here code may be skipped, or left by a fault: it stays as it is.
        let mut guarded = 0;
        let mut networks = plain.networks.iter().peekable();
        for (at, instr) in plain.instrs.iter().enumerate() {
            // A group of two networks would hold inputs that have nothing in common.
            while networks.next_if(|place| place.start as usize <= at).is_some() {
                self.close(at);
            }
            if is_target[at] {
                self.close(at);
                self.may_extend = false;
            }
            let fusible = at >= guarded && is_boolean(instr);
            if !fusible {
                self.close(at);
                moved.push(self.instrs.len() as u32);
                self.push(*instr, at);
                if let Instr::Powered { end, .. } = *instr {
                    guarded = guarded.max(end as usize);
                }
                continue;
            }
            if !self.group.take(instr) {
                self.close(at);
                self.group.take(instr);
            }
            moved.push(self.instrs.len() as u32);
        }
        self.close(plain.instrs.len());
        moved.push(self.instrs.len() as u32);
        moved
    }

    fn push(&mut self, instr: Instr, at: usize) {
        self.instrs.push(instr);
        self.reaches.push(at as u32);
        self.may_extend = false;
    }

    /// Ends the group before the plain instruction `at`.
    fn close(&mut self, at: usize) {
        if self.group.written.is_empty() {
            self.group.inputs.clear();
            return;
        }
        let group = std::mem::take(&mut self.group);
        let first = self.records.len() as u32;
        let mut results: Vec<(Bit, u8)> = Vec::new();
        for &(bit, truth) in &group.written {
            match results.iter_mut().find(|(known, _)| *known == bit) {
                Some((_, known)) => *known = truth,
                None => results.push((bit, truth)),
            }
        }
        for &(bit, truth) in &results {
            if self.is_temporary(bit) {
                self.powers[bit.0 as usize] = Power::Row { record: first, truth };
            }
        }
        results.retain(|&(bit, _)| !self.is_temporary(bit) || self.last_read[bit.0 as usize] >= at as u32);
        // What the group reads is written last, so that every record of it reads the same.
        let is_input = |bit: Bit| group.inputs.contains(&bit);
        let (last, mut outputs): (Vec<_>, Vec<_>) = results.into_iter().partition(|&(bit, _)| is_input(bit));
        match last.as_slice() {
            [] if outputs.is_empty() => {
                // Only the display wants it.
                let unread = self.spare();
                outputs.push((unread, 0));
            }
            [] => {}
            [one] => outputs.push(*one),
            several => {
                let spares: Vec<Bit> = several.iter().map(|_| self.spare()).collect();
                outputs.extend(
                    several
                        .iter()
                        .zip(&spares)
                        .map(|(&(_, truth), &spare)| (spare, truth)),
                );
                self.emit(&group.inputs, &outputs, at);
                for (&(bit, _), &spare) in several.iter().zip(&spares) {
                    self.emit(&[spare], &[(bit, INPUT[0])], at);
                }
                return;
            }
        }
        self.emit(&group.inputs, &outputs, at);
    }

    fn emit(&mut self, inputs: &[Bit], outputs: &[(Bit, u8)], at: usize) {
        let input = |n: usize| inputs.get(n).map_or(Bit::LOW, |&bit| bit);
        for &(out, truth) in outputs {
            let start = self.records.len() as u32;
            self.records.push(Record {
                inputs: [input(0), input(1), input(2)],
                out,
                truth,
            });
            match self.instrs.last_mut() {
                Some(Instr::Records { count, .. }) if self.may_extend => *count += 1,
                Some(last @ Instr::Record { .. }) if self.may_extend => {
                    *last = Instr::Records {
                        start: start - 1,
                        count: 2,
                    };
                }
                _ => {
                    self.instrs.push(Instr::Record { at: start });
                    self.reaches.push(0);
                    self.may_extend = true;
                }
            }
        }
        if let Some(reaches) = self.reaches.last_mut() {
            *reaches = at as u32 - 1;
        }
    }

    fn is_temporary(&self, bit: Bit) -> bool {
        self.temporary.get(bit.0 as usize).copied().unwrap_or(false)
    }

    /// A bit of fused code's own.
    fn spare(&mut self) -> Bit {
        self.memory.bits.push(0);
        self.powers
            .push(Power::Slot(Bit(self.memory.bits.len() as u32 - 1)));
        Bit(self.memory.bits.len() as u32 - 1)
    }
}

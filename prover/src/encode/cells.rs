//! The cells of memory: which of them the code writes, and how many bits their values take.

use super::ranges::range_of;
use ladder_analysis::program::{Program, Role};
use ladder_analysis::values::types::{Scalar, Type};
use ladder_simulator::compiled::{
    Bit, Compiled, Home, Instr, Memory as Banks, PointSlot, Routine, Word, counter, timer,
};
use rustc_hash::{FxHashMap, FxHashSet};

/// A value that goes into the program from outside.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct InputTag {
    /// As the simulator resolves it.
    pub(crate) name: String,
    pub(crate) ty: Scalar,
}

/// What is known of the cells before the code is encoded.
#[derive(Debug, Default)]
pub(crate) struct Cells {
    pub(crate) inputs_at_bits: FxHashMap<u32, InputTag>,
    pub(crate) inputs_at_words: FxHashMap<u32, InputTag>,
    /// The types of the words that are tags.
    types: FxHashMap<u32, Scalar>,
    written_bits: FxHashSet<u32>,
    written_words: FxHashSet<u32>,
    /// Cells that only one block uses, and writes once, before it reads them.
    pub(crate) temporary_bits: FxHashSet<u32>,
    pub(crate) temporary_words: FxHashSet<u32>,
    /// The words of ET that only their timer writes.
    pub(crate) elapsed: FxHashSet<u32>,
}

impl Cells {
    /// What is known of a program's cells; those of `seen` are looked at from outside.
    pub(crate) fn of(program: &Program, compiled: &Compiled, seen: &[PointSlot]) -> Cells {
        let mut cells = Cells::default();
        let mut tag_bits = FxHashSet::default();
        for (tag, home) in program.tags.iter().zip(&compiled.homes) {
            let is_input = tag.role == Role::Input && !tag.constant && tag.block.is_none();
            let name = |index: i64| match tag.ty {
                Type::Array { .. } => tag.element_name(index),
                _ => tag.name.clone(),
            };
            match *home {
                Home::Bits { at, first, len } => {
                    tag_bits.extend(at.0..at.0 + len);
                    for n in 0..if is_input { len } else { 0 } {
                        let (name, ty) = (name(first + i64::from(n)), Scalar::Bool);
                        cells.inputs_at_bits.insert(at.0 + n, InputTag { name, ty });
                    }
                }
                Home::Words { at, first, len, ty } => {
                    for n in 0..len {
                        cells.types.insert(at.0 + n, ty);
                        if is_input {
                            let name = name(first + i64::from(n));
                            cells.inputs_at_words.insert(at.0 + n, InputTag { name, ty });
                        }
                    }
                }
                Home::State { state, words, .. } if state.is_counter() => {
                    cells.types.insert(words.0 + counter::CV, Scalar::Dint);
                }
                _ => {}
            }
        }
        if let Some(Word(at)) = compiled.ports.analog {
            for n in 0..ladder_simulator::compiled::CHANNELS {
                let (name, ty) = (format!("PORT.ADC[{n}]"), Scalar::Lint);
                cells.inputs_at_words.insert(at + n, InputTag { name, ty });
            }
        }
        cells.uses(compiled);
        cells.temporary_bits.retain(|at| !tag_bits.contains(at));
        for slot in seen {
            match slot {
                PointSlot::Bit(Bit(at)) => cells.temporary_bits.remove(at),
                PointSlot::Word(Word(at)) | PointSlot::BitOf { word: Word(at), .. } => {
                    cells.temporary_words.remove(at)
                }
                PointSlot::Timing { .. } | PointSlot::Text(_) => false,
            };
        }
        cells
    }

    /// Whether a cell may hold something else than at the start.
    pub(crate) fn bit_changes(&self, Bit(at): Bit) -> bool {
        self.written_bits.contains(&at)
    }

    /// The same of a word.
    pub(crate) fn word_changes(&self, Word(at): Word) -> bool {
        self.written_words.contains(&at)
    }

    /// The type of a word that is a tag.
    pub(crate) fn type_of(&self, Word(at): Word) -> Option<Scalar> {
        self.types.get(&at).copied()
    }

    fn uses(&mut self, compiled: &Compiled) {
        let code = &compiled.code;
        let mut bits: FxHashMap<u32, Uses> = FxHashMap::default();
        let mut words: FxHashMap<u32, Uses> = FxHashMap::default();
        let mut routines: Vec<u32> = (code.instrs.iter())
            .filter_map(|instr| match instr {
                Instr::Routine { operands, .. } => Some(*operands),
                _ => None,
            })
            .collect();
        routines.sort_unstable();
        let mut arrays: FxHashMap<u32, (u32, u32)> = FxHashMap::default();
        for (at, instr) in code.instrs.iter().enumerate() {
            let block = code.block_at(at as u32);
            if let Instr::Index { to, array, .. } = *instr {
                let place = code.arrays[array as usize];
                arrays.insert(to.0, (place.base, (place.last - place.first + 1) as u32));
            }
            for_each_use(instr, &mut |cell, access| {
                let uses = match cell {
                    Cell::Bit(Bit(at)) => bits.entry(at),
                    Cell::Word(Word(at)) => words.entry(at),
                };
                uses.or_default().add(access, block);
            });
            match *instr {
                Instr::StoreBit { at, .. } => {
                    let (base, len) = arrays.get(&at.0).copied().unwrap_or_default();
                    for n in 0..len {
                        bits.entry(base + n).or_default().add(Access::Change, block);
                    }
                }
                Instr::StoreWord { at, .. } => {
                    let (base, len) = arrays.get(&at.0).copied().unwrap_or_default();
                    for n in 0..len {
                        words.entry(base + n).or_default().add(Access::Change, block);
                    }
                }
                Instr::Routine { routine, operands } => {
                    let next = routines.partition_point(|&other| other <= operands);
                    let end = routines
                        .get(next)
                        .map_or(code.operands.len(), |&end| end as usize);
                    let pool = &code.operands[operands as usize..end];
                    routine_uses(routine, pool, &compiled.initial, &mut |cell, access| {
                        let uses = match cell {
                            Cell::Bit(Bit(at)) => bits.entry(at),
                            Cell::Word(Word(at)) => words.entry(at),
                        };
                        uses.or_default().add(access, block);
                    });
                }
                _ => {}
            }
        }
        let mut elapsed = FxHashSet::default();
        for instr in &code.instrs {
            if let Instr::Ton { words: at, .. }
            | Instr::Tof { words: at, .. }
            | Instr::Tp { words: at, .. }
            | Instr::Rto { words: at, .. }
            | Instr::Rtof { words: at, .. } = instr
            {
                elapsed.insert(at.0 + timer::ET);
            }
        }
        // What `for_each_use` says of a timer does not hold its ET: another use that writes it is someone else's.
        elapsed.retain(|at| words.get(at).is_none_or(|uses| uses.writes == 0));
        self.elapsed = elapsed;
        self.temporary_bits = temporary(&bits);
        self.temporary_words = temporary(&words)
            .into_iter()
            .filter(|at| !self.types.contains_key(at))
            .collect();
        self.written_bits = written(&bits);
        self.written_words = written(&words);
        for instr in &code.instrs {
            if let Instr::Ton { words, .. }
            | Instr::Tof { words, .. }
            | Instr::Tp { words, .. }
            | Instr::Rto { words, .. }
            | Instr::Rtof { words, .. } = instr
            {
                self.written_words.insert(words.0 + timer::ET);
            }
        }
    }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Access {
    Read,
    /// Written in any case where the instruction runs.
    Write,
    /// Written where something holds, or read before.
    Change,
}

/// What is known of the uses of a cell.
#[derive(Debug, Default)]
struct Uses {
    block: Option<u32>,
    spread: bool,
    read_first: bool,
    writes: usize,
}

impl Uses {
    fn add(&mut self, access: Access, block: u32) {
        match self.block {
            None => {
                self.block = Some(block);
                self.read_first = access != Access::Write;
            }
            Some(other) => self.spread |= other != block,
        }
        self.writes += usize::from(access != Access::Read);
    }
}

fn temporary(uses: &FxHashMap<u32, Uses>) -> FxHashSet<u32> {
    let own = uses
        .iter()
        .filter(|(_, uses)| !uses.spread && !uses.read_first && uses.writes == 1);
    own.map(|(at, _)| *at).collect()
}

fn written(uses: &FxHashMap<u32, Uses>) -> FxHashSet<u32> {
    let written = uses.iter().filter(|(_, uses)| uses.writes > 0);
    written.map(|(at, _)| *at).collect()
}

#[derive(Debug, Clone, Copy)]
enum Cell {
    Bit(Bit),
    Word(Word),
}

/// The cells that an instruction names. Those of elements are found by its array.
fn for_each_use(instr: &Instr, each: &mut dyn FnMut(Cell, Access)) {
    use Access::{Change, Read, Write};
    use Instr as I;
    let mut reads = Vec::new();
    instr.for_each_bit_read(|bit| reads.push(bit));
    for bit in reads {
        each(Cell::Bit(bit), Read);
    }
    let mut word = |word: Word, access| each(Cell::Word(word), access);
    match *instr {
        I::Compare { a, b, .. } | I::CompareUnsigned { a, b, .. } | I::CompareReal { a, b, .. } => {
            word(a, Read);
            word(b, Read);
        }
        I::LoadBitOf { word: from, .. } => word(from, Read),
        I::StoreBitOf { word: to, .. } => word(to, Change),
        I::Move { to, from } | I::Convert { to, from, .. } | I::RealFunction { to, a: from, .. } => {
            word(from, Read);
            word(to, Write);
        }
        I::MoveWhen { to, from, .. } => {
            word(from, Read);
            word(to, Change);
        }
        I::Integer { to, a, b, .. } | I::Real { to, a, b, .. } => {
            word(a, Read);
            word(b, Read);
            word(to, Write);
        }
        I::IntegerWhen { to, a, b, .. } | I::RealWhen { to, a, b, .. } => {
            word(a, Read);
            word(b, Read);
            word(to, Change);
        }
        I::BitToWord { to, .. } | I::Turn { to, .. } => word(to, Write),
        I::Index { to, index, .. } => {
            word(index, Read);
            word(to, Write);
        }
        I::LoadWord { to, at } => {
            word(at, Read);
            word(to, Write);
        }
        I::StoreWord { at, from } => {
            word(at, Read);
            word(from, Read);
        }
        I::LoadBit { at, .. } | I::StoreBit { at, .. } => word(at, Read),
        I::Ton { pt, words, .. }
        | I::Tof { pt, words, .. }
        | I::Tp { pt, words, .. }
        | I::Rto { pt, words, .. }
        | I::Rtof { pt, words, .. } => {
            word(pt, Read);
            word(words.offset(timer::PT), Change);
        }
        I::Ctu { pv, words, .. }
        | I::Ctd { pv, words, .. }
        | I::Ctud { pv, words, .. }
        | I::Ctc { pv, words, .. } => {
            word(pv, Read);
            word(words.offset(counter::PV), Change);
            word(words.offset(counter::CV), Change);
        }
        I::Clear { state, words, .. } if state.is_counter() => word(words.offset(counter::CV), Change),
        I::For { turns, .. } => word(turns, Read),
        _ => {}
    }
    let mut bit = |bit: Bit, access| each(Cell::Bit(bit), access);
    match *instr {
        I::Contact { out, .. }
        | I::NegatedContact { out, .. }
        | I::Join { out, .. }
        | I::Invert { out, .. }
        | I::Follow { out, .. }
        | I::Rail { out }
        | I::Compare { out, .. }
        | I::CompareUnsigned { out, .. }
        | I::CompareReal { out, .. }
        | I::CompareBit { out, .. }
        | I::CompareText { out, .. }
        | I::Powered { out, .. }
        | I::MoveWhen { out, .. }
        | I::IntegerWhen { out, .. }
        | I::RealWhen { out, .. }
        | I::LoadBitOf { to: out, .. }
        | I::LoadBit { to: out, .. }
        | I::StateAt { out, .. }
        | I::Coil { tag: out, .. }
        | I::NegatedCoil { tag: out, .. }
        | I::MoveBit { to: out, .. }
        | I::AndBit { to: out, .. }
        | I::OrBit { to: out, .. }
        | I::XorBit { to: out, .. }
        | I::NotBit { to: out, .. } => bit(out, Write),
        I::Set { tag, .. } | I::Reset { tag, .. } => bit(tag, Change),
        I::Rising { out, before, .. } | I::Falling { out, before, .. } => {
            bit(before, Change);
            bit(out, Write);
        }
        I::Ton { out, bits, .. }
        | I::Tof { out, bits, .. }
        | I::Tp { out, bits, .. }
        | I::Rto { out, bits, .. }
        | I::Rtof { out, bits, .. } => {
            bit(bits.offset(timer::R), Read);
            bit(bits.offset(timer::IN), Change);
            bit(bits.offset(timer::Q), Change);
            bit(out, Write);
        }
        I::Ctu { out, bits, .. }
        | I::Ctd { out, bits, .. }
        | I::Ctud { out, bits, .. }
        | I::Ctc { out, bits, .. } => {
            for member in [counter::CD, counter::R, counter::LD] {
                bit(bits.offset(member), Read);
            }
            for member in [
                counter::CU,
                counter::Q,
                counter::QD,
                counter::CHANGED,
                counter::UP_BEFORE,
                counter::DOWN_BEFORE,
            ] {
                bit(bits.offset(member), Change);
            }
            bit(out, Write);
        }
        I::Sr { out, bits, .. } | I::Rs { out, bits, .. } => {
            bit(bits, Change);
            bit(out, Write);
        }
        I::Clear { state, bits, .. } => {
            let (count, _) = ladder_simulator::compiled::state_size(state);
            for n in 0..count {
                bit(bits.offset(n), Change);
            }
        }
        _ => {}
    }
}

/// The cells of a routine. Of one that is not encoded each number may be a bit or a word that it writes.
fn routine_uses(routine: Routine, pool: &[u32], initial: &Banks, each: &mut dyn FnMut(Cell, Access)) {
    let bit = |at: u32| Cell::Bit(Bit(at));
    let word = |at: u32| Cell::Word(Word(at));
    // A range that is known only while the program runs blocks it, so what is noted here of one does not matter.
    let mut range = |words: [u32; 2], cell: &dyn Fn(u32) -> Cell, access: Access| {
        words.into_iter().for_each(|at| each(word(at), Access::Read));
        for slot in range_of(initial, None, words).unwrap_or_default() {
            each(cell(slot), access);
        }
    };
    match (routine, pool) {
        (Routine::AllHigh | Routine::AllLow, [to, start, count, ..]) => {
            range([*start, *count], &bit, Access::Read);
            each(bit(*to), Access::Change);
        }
        (Routine::FillBits | Routine::ShiftBits, [start, count, from, ..]) => {
            range([*start, *count], &bit, Access::Change);
            each(bit(*from), Access::Read);
        }
        (Routine::FillWords | Routine::ShiftWords, [start, count, from, ..]) => {
            range([*start, *count], &word, Access::Change);
            each(word(*from), Access::Read);
        }
        (Routine::SetBits | Routine::ResetBits, [en, start, count, ..]) => {
            range([*start, *count], &bit, Access::Change);
            each(bit(*en), Access::Read);
        }
        (Routine::CopyBits, [to, to_count, from, from_count, ..]) => {
            range([*to, *to_count], &bit, Access::Change);
            range([*from, *from_count], &bit, Access::Read);
        }
        (Routine::CopyWords, [to, to_count, from, from_count, ..]) => {
            range([*to, *to_count], &word, Access::Change);
            range([*from, *from_count], &word, Access::Read);
        }
        (Routine::PackBits, [to, _, start, count, ..]) => {
            range([*start, *count], &bit, Access::Read);
            each(word(*to), Access::Change);
        }
        (Routine::UnpackBits, [start, count, from, ..]) => {
            range([*start, *count], &bit, Access::Change);
            each(word(*from), Access::Read);
        }
        (Routine::Sum, [to, _, start, count, ..]) => {
            range([*start, *count], &word, Access::Read);
            each(word(*to), Access::Change);
        }
        (Routine::Enumerate, [to, _, from, ..]) => {
            each(word(*from), Access::Read);
            each(word(*to), Access::Change);
        }
        (Routine::SelectBit, [to, selector, count, list @ ..]) => {
            each(word(*selector), Access::Read);
            for from in &list[..(*count as usize).min(list.len())] {
                each(bit(*from), Access::Read);
            }
            each(bit(*to), Access::Change);
        }
        (Routine::SelectWord, [to, selector, count, list @ ..]) => {
            each(word(*selector), Access::Read);
            for from in &list[..(*count as usize).min(list.len())] {
                each(word(*from), Access::Read);
            }
            each(word(*to), Access::Change);
        }
        _ => {
            for &number in pool {
                each(bit(number), Access::Change);
                each(word(number), Access::Change);
            }
        }
    }
}

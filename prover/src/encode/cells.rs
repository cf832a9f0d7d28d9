//! The cells of memory: which of them the code writes, and how many bits their values take.

use super::slots::Reach;
use super::uses::{Access, Cell, chosen, for_each_access};
use ladder_analysis::program::Program;
use ladder_analysis::values::types::Scalar;
use ladder_simulator::compiled::{Bit, Compiled, Home, Instr, PointSlot, Word, counter, timer};
use rustc_hash::{FxHashMap, FxHashSet};

/// A value that goes into the program from outside.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct InputTag {
    /// As the simulator resolves it.
    pub(crate) name: String,
    pub(crate) ty: Scalar,
}

/// What is known of the cells before the code is encoded.
#[derive(Debug, Default, Clone)]
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
    /// Of a network that is followed alone the timers by their first bits. All that it finds is an input then.
    pub(crate) alone: Option<FxHashMap<u32, String>>,
    /// Which cells computed slots may mean.
    pub(crate) reach: Reach,
    /// Something writes to a cell that is not known.
    pub(crate) has_unknown_writes: bool,
    /// Of such a network the members of timers and counters that its program never writes, such as `t1.R`, by their names.
    pub(crate) idle: FxHashMap<String, u32>,
}

impl Cells {
    /// What is known of a program's cells; those of `seen` are read from outside.
    pub(crate) fn of(program: &Program, compiled: &Compiled, seen: &[PointSlot]) -> Cells {
        let mut cells = Cells::default();
        let mut tag_bits = FxHashSet::default();
        for home in &compiled.homes {
            match *home {
                Home::Bits { at, len, .. } => tag_bits.extend(at.0..at.0 + len),
                Home::Words { at, len, ty, .. } => {
                    cells.types.extend((at.0..at.0 + len).map(|at| (at, ty)));
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
        let inputs = program.tags.iter().zip(&compiled.homes);
        for (tag, home) in inputs.filter(|(tag, _)| tag.is_input) {
            cells.name_tag(tag, home, &mut FxHashMap::default());
        }
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
        self.reach = Reach::of(code, &compiled.initial, |at| self.types.contains_key(&at));
        let mut bits: FxHashMap<u32, Uses> = FxHashMap::default();
        let mut words: FxHashMap<u32, Uses> = FxHashMap::default();
        let mut has_unknown = false;
        let all = 0..code.instrs.len() as u32;
        for_each_access(code, &self.reach, all, &mut |at, cell, access| {
            let uses = match cell {
                Cell::Bit(Bit(at)) => bits.entry(at),
                Cell::Word(Word(at)) => words.entry(at),
                Cell::Timer(_) | Cell::Elapsed(_) => return,
                Cell::Unknown => {
                    has_unknown = true;
                    return;
                }
            };
            uses.or_default().add(access, code.block_at(at));
        });
        let relays = &code.relays;
        let relays = [
            relays.zero,
            relays.range,
            relays.address,
            relays.math,
            relays.stop,
        ];
        for Bit(at) in relays.into_iter().flatten() {
            // Any block may report an error there.
            bits.entry(at).or_default().add(Access::Change, u32::MAX);
        }
        self.has_unknown_writes = has_unknown;
        let mut elapsed = FxHashSet::default();
        for instr in &code.instrs {
            let each = chosen(&self.reach, instr).into_iter().flatten();
            for instr in each.map(|(_, _, instr)| instr).chain([*instr]) {
                if let Instr::Ton { words: at, .. }
                | Instr::Tof { words: at, .. }
                | Instr::Tp { words: at, .. }
                | Instr::Rto { words: at, .. }
                | Instr::Rtof { words: at, .. } = instr
                {
                    elapsed.insert(at.0 + timer::ET);
                }
            }
        }
        self.temporary_bits = temporary(&bits);
        self.temporary_words = temporary(&words)
            .into_iter()
            .filter(|at| !self.types.contains_key(at))
            .collect();
        self.written_bits = written(&bits);
        self.written_words = written(&words);
        self.written_words.extend(&elapsed);
        // What `for_each_use` says of a timer does not hold its ET: another use that writes it is someone else's.
        elapsed.retain(|at| words.get(at).is_none_or(|uses| uses.writes == 0));
        self.elapsed = elapsed;
    }
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

//! Unread parts (LANGUAGE §5.9): what one may write is open from there on, and so is its power. In a program that is compared with
//! another one it gives the same as the same part there, as long as it gets the same.

use super::Scan;
use super::routine::writes_unseen;
use super::slots::Reach;
use super::uses::Cell;
use super::world::{Gap, Ran, Read};
use crate::graph::Lit;
use crate::number::Number;
use ladder_analysis::values::types::Scalar;
use ladder_instructions::StateType;
use ladder_simulator::compiled::{
    Bit, Borrowed, Code, Home, Instr, UnreadPlace, Word, counter, state_size, timer,
};
use rustc_hash::FxHashMap;

/// Bits of an age that is open: as many as any age has.
const AGE_BITS: usize = 63;

/// Each cell that an unread part may write, with what it is called: the same in another program.
pub(super) fn each_written<'p>(
    place: &'p UnreadPlace,
    reach: &Reach,
    each: &mut dyn FnMut((&'p str, u32), Cell),
) {
    for tracked in place.own.iter().chain(place.writes.iter()) {
        let mut number = 0;
        cells_of(tracked.home, reach, &mut |cell| {
            each((&tracked.name, number), cell);
            number += 1;
        });
    }
    if let Some([_, out]) = place.power {
        each(("ENO", 0), Cell::Bit(out));
    }
}

/// The cells of a tag; what is not a cell that is tracked is left out.
fn cells_of(home: Home, reach: &Reach, each: &mut dyn FnMut(Cell)) {
    let word = |n: u32| Cell::Word(Word(n));
    match home {
        Home::Bits { at, len, .. } => (at.0..at.0 + len).for_each(|n| each(Cell::Bit(Bit(n)))),
        Home::Words { at, len, .. } => (at.0..at.0 + len).for_each(|n| each(word(n))),
        Home::State { state, bits, words } => state_cells(state, bits, words, each),
        Home::Texts { .. } | Home::Borrowed(Borrowed::Unbound) => {}
        Home::Borrowed(Borrowed::BitOf { word, .. } | Borrowed::As { word, .. }) => each(Cell::Word(word)),
        Home::Borrowed(Borrowed::BitOfAt { at, .. }) => match reach.slots(at) {
            Some(slots) => slots.each().for_each(|n| each(word(n))),
            None => each(Cell::Unknown),
        },
        Home::Borrowed(Borrowed::Elements { at, len, ty, .. }) => match reach.slots(at) {
            _ if matches!(ty, Scalar::String(_)) => {}
            Some(slots) => {
                for n in slots.each().flat_map(|n| n..n.saturating_add(len)) {
                    each(match ty {
                        Scalar::Bool => Cell::Bit(Bit(n)),
                        _ => word(n),
                    });
                }
            }
            None => each(Cell::Unknown),
        },
        Home::Borrowed(Borrowed::State { state, bits, words }) => {
            let Some((bits, words)) = reach.slots(bits).zip(reach.slots(words)) else {
                return each(Cell::Unknown);
            };
            if state_size(state).1 > 0 && words.count() != bits.count() {
                return each(Cell::Unknown);
            }
            // A bistable has no words.
            let words = words.each().chain(std::iter::repeat(0));
            for (bits, words) in bits.each().zip(words) {
                state_cells(state, Bit(bits), Word(words), each);
            }
        }
    }
}

fn state_cells(state: StateType, bits: Bit, words: Word, each: &mut dyn FnMut(Cell)) {
    let (count, _) = state_size(state);
    for n in (0..count).filter(|n| !state.is_timer() || *n != timer::PHASE) {
        each(Cell::Bit(bits.offset(n)));
    }
    if state.is_timer() {
        each(Cell::Word(words.offset(timer::PT)));
        each(Cell::Word(words.offset(timer::ET)));
        each(Cell::Timer(bits));
    } else if state.is_counter() {
        each(Cell::Word(words.offset(counter::PV)));
        each(Cell::Word(words.offset(counter::CV)));
    }
}

impl Scan<'_, '_> {
    /// A scan that comes to an unread part.
    pub(super) fn unread(&mut self, at: u32, number: u32) {
        let code = self.code;
        let place = &code.unread[number as usize];
        let gap = Gap {
            what: format!("what the unread part `{}` writes is not known", place.name),
            location: place.location,
        };
        let mut cells = Vec::new();
        each_written(place, &self.reach, &mut |name, cell| cells.push((name, cell)));
        if cells.iter().any(|(_, cell)| *cell == Cell::Unknown) {
            return self.block(gap.what, at);
        }
        if !self.world.compares {
            for (_, cell) in cells {
                let value = self.open_unread(cell, &gap);
                self.write_unread(cell, value);
            }
            return;
        }
        let turn = self.turns.entry(number_of(code, number)).or_default();
        *turn += 1;
        let key = (place.text.clone(), *turn);
        let reads = self.reads(place);
        let like = self.world.ran.remove(&key);
        let same = like
            .as_ref()
            .map_or(Lit::FALSE, |like| self.gets_the_same(like, reads.as_deref()));
        let mut written = FxHashMap::default();
        for ((name, number), cell) in cells {
            let known = like
                .as_ref()
                .and_then(|like| like.written.get(&(name.to_owned(), number)));
            let value = match known {
                Some(known) if same == Lit::TRUE => known.clone(),
                Some(known) if same != Lit::FALSE => {
                    let own = self.open_unread(cell, &gap);
                    let both = known.iter().zip(own);
                    both.map(|(known, own)| self.world.graph.choose(same, *known, own))
                        .collect()
                }
                _ => self.open_unread(cell, &gap),
            };
            self.write_unread(cell, value.clone());
            written.insert((name.to_owned(), number), value);
        }
        let ran = Ran {
            act: self.act,
            reads,
            written,
        };
        self.world.ran.insert(key, ran);
    }

    /// What a part gets: none if something of it is not tracked.
    fn reads(&mut self, place: &UnreadPlace) -> Option<Vec<(String, Read)>> {
        let names = std::mem::take(&mut self.world.twins.names);
        let mut reads = Vec::new();
        let mut is_tracked = true;
        let power = place.power.map(|[en, _]| Home::Bits {
            at: en,
            first: 0,
            len: 1,
        });
        let given = place.given.iter().copied().chain(power).enumerate();
        let given = given.map(|(number, home)| (format!("operand {number}"), home));
        let tags = place.reads.iter().chain(&place.own);
        let tags = tags.map(|tracked| {
            let name = names.get(&tracked.name).unwrap_or(&tracked.name);
            (name.to_lowercase(), tracked.home)
        });
        let all: Vec<(String, Home)> = given.chain(tags).collect();
        for (name, home) in all {
            if let Home::Texts { at, len, .. } = home {
                is_tracked &= !writes_texts(self.code);
                for n in at.0..at.0 + len {
                    let text = self.memory.first_text(n).to_vec();
                    reads.push((name.clone(), Read::Text(text)));
                }
                continue;
            }
            let mut cells = Vec::new();
            cells_of(home, &self.reach, &mut |cell| cells.push(cell));
            for cell in cells {
                let value = match cell {
                    Cell::Bit(bit) => Number::of_bit(self.bit(bit)),
                    Cell::Word(word) | Cell::Elapsed(word) => self.word(word),
                    Cell::Timer(bits) => Number::unsigned(self.memory.phase(self.world, bits)),
                    Cell::Unknown => {
                        is_tracked = false;
                        continue;
                    }
                };
                reads.push((name.clone(), Read::Number(value)));
            }
        }
        self.world.twins.names = names;
        // Where tags are in memory means nothing.
        reads.sort_by(|a, b| a.0.cmp(&b.0));
        is_tracked.then_some(reads)
    }

    /// High where a part gets the same as the one in the other program, now and in all scans before.
    fn gets_the_same(&mut self, like: &Ran, reads: Option<&[(String, Read)]>) -> Lit {
        let (Some(old), Some(new)) = (like.reads.as_deref(), reads) else {
            return Lit::FALSE;
        };
        if old.len() != new.len() {
            return Lit::FALSE;
        }
        let mut all = Vec::new();
        for ((was, old), (is, new)) in old.iter().zip(new) {
            all.push(match (old, new) {
                _ if was != is => return Lit::FALSE,
                (Read::Number(old), Read::Number(new)) => self.world.graph.equal(old, new),
                (Read::Text(old), Read::Text(new)) if old == new => Lit::TRUE,
                _ => return Lit::FALSE,
            });
        }
        let graph = &mut self.world.graph;
        let all = graph.all(all);
        let now = graph.or(all, !self.act);
        let both = graph.same(like.act, self.act);
        let now = graph.and(now, both);
        match now.known() {
            Some(known) => Lit::constant(known),
            // From any state it is not known what it got before.
            None if self.alone.is_some() => Lit::FALSE,
            None => self.world.and_always_before(now),
        }
    }

    /// Any value of a cell.
    fn open_unread(&mut self, cell: Cell, gap: &Gap) -> Vec<Lit> {
        let bits = match cell {
            Cell::Bit(_) => self.world.open_bits(gap.clone(), 1),
            Cell::Timer(_) => self.world.open_bits(gap.clone(), 3 + AGE_BITS),
            Cell::Word(word) | Cell::Elapsed(word) => {
                let ty = self.memory.type_of(word).unwrap_or(Scalar::Lint);
                self.world.open_any(gap.clone(), ty).low(64)
            }
            Cell::Unknown => Vec::new(),
        };
        self.world.unread.extend(
            bits.iter()
                .filter(|bit| bit.known().is_none())
                .map(|bit| bit.node()),
        );
        bits
    }

    /// Sets a cell, from the bits of a value.
    fn write_unread(&mut self, cell: Cell, bits: Vec<Lit>) {
        match cell {
            Cell::Bit(bit) => self.write_bit(bit, bits[0]),
            Cell::Word(word) | Cell::Elapsed(word) => self.write_word(word, Number::of_bits(bits)),
            Cell::Timer(timer) => {
                let (phase, age) = bits.split_at(3);
                let old = self.memory.phase(self.world, timer);
                let phase = phase.iter().zip(old);
                let phase = phase.map(|(new, old)| self.world.graph.choose(self.act, *new, old));
                let phase = phase.collect();
                self.memory.set_phase(timer, phase);
                self.memory.open_age(self.world, timer, (self.act, age.to_vec()));
            }
            Cell::Unknown => {}
        }
    }
}

/// Of several parts with one text the first: they are counted together.
fn number_of(code: &Code, number: u32) -> u32 {
    let text = &code.unread[number as usize].text;
    let first = code.unread.iter().position(|place| place.text == *text);
    first.map_or(number, |first| first as u32)
}

/// Whether a text may change in a scan: texts are not tracked.
fn writes_texts(code: &Code) -> bool {
    code.instrs.iter().any(|instr| match *instr {
        Instr::MoveText { .. } | Instr::StoreText { .. } => true,
        Instr::Routine { routine, .. } => writes_unseen(routine),
        _ => false,
    })
}

//! A network by itself: from any state, what it leaves of each tag, edge and timer, and where execution goes on.

use super::cells::{Cells, InputTag};
use super::memory::Memory;
use super::world::World;
use super::{Scan, Times};
use crate::graph::Lit;
use crate::number::Number;
use ladder_analysis::program::{Clock, Program, SystemTag, Tag};
use ladder_analysis::values::types::{Scalar, Type};
use ladder_simulator::compiled::{
    Bit, CHANNELS, Cell, Compiled, Home, Instr, Ports, Word, counter, state_size, timer,
};
use rustc_hash::FxHashMap;
use std::ops::Range;

/// Times are nanoseconds: no interval of scans is as short.
const INTERVAL: i64 = 1;

/// What a network leaves.
pub(crate) struct Left {
    /// Each value that has a name.
    pub(crate) values: Vec<(InputTag, Number)>,
    /// A fault was recorded.
    pub(crate) faulted: Lit,
    /// The program ended.
    pub(crate) ended: Lit,
    /// Execution goes on at the network below.
    pub(crate) goes_on: Lit,
    /// Who goes on at which network instead.
    pub(crate) jumps: Vec<(u32, Lit)>,
    /// The left rail is live.
    pub(crate) rail: Lit,
}

/// Follows a network alone, in a memory that others share by the names of the cells.
pub(crate) fn follow_alone(
    world: &mut World,
    compiled: &Compiled,
    cells: &Cells,
    stretch: Range<u32>,
) -> Left {
    let memory = Memory::new(&compiled.initial, Some(cells));
    let rail = rail(world);
    let mut scan = Scan::new(world, &compiled.code, memory, (Times::Exact, INTERVAL), Lit::TRUE);
    scan.frame.rail = rail;
    scan.alone = Some(stretch.clone());
    scan.stretch(stretch.start);
    Left {
        values: scan.memory.left(),
        faulted: scan.faulted,
        ended: scan.ended,
        goes_on: scan.act,
        jumps: std::mem::take(&mut scan.pending).into_iter().collect(),
        rail: scan.frame.rail,
    }
}

/// Whether the left rail is live before the network.
fn rail(world: &mut World) -> Lit {
    let name = String::from("SYS.RAIL");
    let ty = Scalar::Bool;
    world.shared(&InputTag { name, ty }).bit(0)
}

impl Cells {
    /// What is known of a program's cells to a network of it that is followed alone: whatever a tag or a place in the network
    /// remembers may be anything, and goes by a name.
    pub(crate) fn alone(program: &Program, compiled: &Compiled) -> Cells {
        let mut cells = Cells::of(program, compiled, &[]);
        cells.elapsed.clear();
        let mut timers = FxHashMap::default();
        let tags = program.tags.iter().zip(&compiled.homes);
        for (tag, home) in tags.filter(|(tag, _)| tag.block.is_none() && !tag.constant) {
            cells.name_tag(tag, home, &mut timers);
        }
        cells.name_system(compiled.ports);
        for (cell, Bit(memory)) in compiled.edges_of_tags() {
            let tag = match cell {
                Cell::Bit(Bit(at)) => cells.inputs_at_bits.get(&at),
                Cell::Word(Word(at)) => cells.inputs_at_words.get(&at),
            };
            let name = format!("{} before 0", tag.map_or("", |tag| &tag.name));
            cells.name_bit(memory, name);
        }
        cells.alone = Some(timers);
        cells.are_no_temporaries();
        cells
    }

    /// The same, with names for what the blocks of one network remember. Edges of one tag are told apart by their order.
    pub(crate) fn with_network(&self, compiled: &Compiled, network: usize, stretch: Range<u32>) -> Cells {
        let mut cells = self.clone();
        let code = &compiled.code.instrs[stretch.start as usize..stretch.end as usize];
        let mut edges: FxHashMap<u32, String> = FxHashMap::default();
        for instr in code {
            if let Instr::Rising { tag, before, .. } | Instr::Falling { tag, before, .. } = *instr {
                let tag = self.inputs_at_bits.get(&tag.0).map(|tag| tag.name.clone());
                edges.entry(before.0).or_insert(tag.unwrap_or_default());
            }
        }
        let mut count: FxHashMap<String, usize> = FxHashMap::default();
        for cell in compiled.remembered_in(network) {
            let what = match cell {
                Cell::Bit(Bit(at)) => edges.get(&at).map_or("", String::as_str),
                Cell::Word(_) => "number",
            };
            let number = count.entry(what.to_owned()).or_default();
            *number += 1;
            let name = format!("{what} before {number}");
            match cell {
                Cell::Bit(Bit(at)) if !cells.inputs_at_bits.contains_key(&at) => {
                    let ty = Scalar::Bool;
                    cells.inputs_at_bits.insert(at, InputTag { name, ty });
                }
                Cell::Word(Word(at)) if !cells.inputs_at_words.contains_key(&at) => {
                    let ty = Scalar::Lint;
                    cells.inputs_at_words.insert(at, InputTag { name, ty });
                }
                _ => {}
            }
        }
        cells.are_no_temporaries();
        cells
    }

    /// A member that neither program writes stays low.
    pub(crate) fn keep_idle(&mut self, other: &Cells) {
        for (name, at) in &self.idle {
            if other.idle.contains_key(name) {
                self.inputs_at_bits.remove(at);
            }
        }
    }

    /// What has a name is seen from outside.
    fn are_no_temporaries(&mut self) {
        let (bits, words) = (&self.inputs_at_bits, &self.inputs_at_words);
        self.temporary_bits.retain(|at| !bits.contains_key(at));
        self.temporary_words.retain(|at| !words.contains_key(at));
    }

    /// What a tag holds goes in by its name, each element and member.
    pub(super) fn name_tag(&mut self, tag: &Tag, home: &Home, timers: &mut FxHashMap<u32, String>) {
        let name = |index: i64| match tag.ty {
            Type::Array { .. } => tag.element_name(index),
            _ => tag.name.clone(),
        };
        match *home {
            Home::Bits { at, first, len } => {
                for n in 0..len {
                    self.name_bit(at.0 + n, name(first + i64::from(n)));
                }
            }
            Home::Words { at, first, len, ty } => {
                for n in 0..len {
                    self.name_word(at.0 + n, name(first + i64::from(n)), ty);
                }
            }
            Home::State { state, bits, words } => {
                let bit_names: &[&str] = if state.is_timer() {
                    timers.entry(bits.0).or_insert_with(|| tag.name.clone());
                    &["IN", "Q", "R"]
                } else if state.is_counter() {
                    &[
                        "CU",
                        "CD",
                        "R",
                        "LD",
                        "Q",
                        "QD",
                        "CHANGED",
                        "CU before",
                        "CD before",
                    ]
                } else {
                    &["Q1"]
                };
                for (n, member) in bit_names.iter().enumerate() {
                    let at = Bit(bits.0 + n as u32);
                    if ["R", "CD", "LD"].contains(member) && !self.bit_changes(at) {
                        let name = format!("{}.{member}", tag.name).to_ascii_lowercase();
                        self.idle.insert(name, at.0);
                    }
                    self.name_bit(bits.0 + n as u32, format!("{}.{member}", tag.name));
                }
                let word_names = if state.is_timer() {
                    vec![(timer::PT, "PT", Scalar::Time), (timer::ET, "ET", Scalar::Time)]
                } else if state_size(state).1 > 0 {
                    vec![
                        (counter::PV, "PV", Scalar::Dint),
                        (counter::CV, "CV", Scalar::Dint),
                    ]
                } else {
                    Vec::new()
                };
                for (n, member, ty) in word_names {
                    self.name_word(words.0 + n, format!("{}.{member}", tag.name), ty);
                }
            }
            Home::Texts { .. } | Home::Borrowed(_) => {}
        }
    }

    fn name_system(&mut self, ports: Ports) {
        let tag = |tag: SystemTag| format!("SYS.{}", tag.name());
        self.name_bit(Bit::FIRST_SCAN.0, tag(SystemTag::FirstScan));
        self.name_bit(Bit::FAULT.0, tag(SystemTag::Fault));
        for clock in Clock::ALL {
            let Bit(at) = Bit::CLOCKS.offset(clock as u32);
            self.name_bit(at, tag(SystemTag::Clock(clock)));
        }
        let words = [
            (Word::SCAN, SystemTag::Scan),
            (Word::TIME, SystemTag::Time),
            (Word::SCAN_TIME, SystemTag::ScanTime),
        ];
        for (Word(at), system) in words {
            self.name_word(at, tag(system), system.ty());
        }
        let channels = [
            (ports.analog, CHANNELS, "ADC"),
            (ports.pulse, 2 * CHANNELS, "PULSE"),
        ];
        for (first, count, port) in channels {
            for n in 0..first.map_or(0, |_| count) {
                let at = first.map_or(0, |Word(at)| at + n);
                self.name_word(at, format!("PORT.{port}[{n}]"), Scalar::Lint);
            }
        }
    }

    fn name_bit(&mut self, at: u32, name: String) {
        let ty = Scalar::Bool;
        self.inputs_at_bits.entry(at).or_insert(InputTag { name, ty });
    }

    fn name_word(&mut self, at: u32, name: String, ty: Scalar) {
        self.inputs_at_words.entry(at).or_insert(InputTag { name, ty });
    }
}

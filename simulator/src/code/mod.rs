//! The flat code that a program becomes: instructions in their order of evaluation, and the tables that lead
//! from a place in the code back to the drawing.

mod effects;
mod instr;
mod unread;
mod uses;

pub use instr::{Instr, NOTHING_SAVED};
pub use unread::{Tracked, UnreadPlace};

use crate::controller::Relays;
use crate::memory::Bit;
use ladder_analysis::program::{ElementKind, Location};
use ladder_instructions::Controller;

/// One result of a few boolean instructions: the bit of a truth table that three bits select.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Record {
    pub inputs: [Bit; 3],
    pub out: Bit,
    /// Bit n is the result where the inputs are the binary digits of n, the first one the lowest.
    pub truth: u8,
}

/// The instructions of a program.
#[derive(Debug, Default)]
pub struct Code {
    pub instrs: Vec<Instr>,
    pub records: Vec<Record>,
    /// For each instruction what the blocks count that begin at it or before it: one each, and more for one of very
    /// many instructions. Not kept up after jumps: it counts text.
    pub work_through: Vec<u32>,
    /// The blocks in the order of the code.
    pub blocks: Vec<BlockPlace>,
    /// Where each network begins, in the order of the code: its first instruction and its number.
    pub networks: Vec<NetworkPlace>,
    /// For each instruction the kinds of [`stop`] in front of it. Plain code only.
    pub(crate) stops: Vec<u8>,
    /// Arrays that are indexed while scanning.
    pub arrays: Vec<ArrayPlace>,
    /// Operands of routines.
    pub operands: Vec<u32>,
    /// Powers that a call which can come back to the same network must keep.
    pub saved: Vec<Vec<Bit>>,
    /// The unread parts: where each is, and what it may read and write.
    pub unread: Vec<UnreadPlace>,
    /// Where errors are reported that are not faults.
    pub relays: Relays,
    /// Where the main program begins: what is before it are plants.
    pub main: u32,
}

/// Where a scan can halt: in front of what has code. A set of kinds for each instruction.
pub(crate) mod stop {
    /// A block.
    pub(crate) const BLOCK: u8 = 1;
    /// The first instruction of a network.
    pub(crate) const NETWORK: u8 = 2;
    /// What is observed: while a scan is run again, or of each turn where code runs several times in a scan.
    pub(crate) const MARK: u8 = 4;
}

impl Code {
    /// The network that begins at an instruction; one without code is passed by.
    pub fn network_at(&self, pc: u32) -> Option<usize> {
        let through = self.networks.partition_point(|place| place.start <= pc);
        let place = self.networks[..through].last()?;
        (place.start == pc).then_some(place.network as usize)
    }

    /// All networks that begin at an instruction: those without code are there too.
    pub fn networks_at(&self, pc: u32) -> impl Iterator<Item = usize> + '_ {
        let first = self.networks.partition_point(|place| place.start < pc);
        let here = self.networks[first..]
            .iter()
            .take_while(move |place| place.start == pc);
        here.map(|place| place.network as usize)
    }

    /// The block that begins at an instruction; one without code is passed by.
    pub fn block_from(&self, pc: u32) -> Option<&BlockPlace> {
        let through = self.blocks.partition_point(|place| place.start <= pc);
        let here = self.blocks[..through]
            .iter()
            .rev()
            .take_while(|place| place.start == pc);
        here.into_iter().find(|place| place.end > pc)
    }

    /// The innermost block that an instruction belongs to, as an index into the blocks.
    pub fn block_at(&self, pc: u32) -> u32 {
        let through = self.blocks.partition_point(|block| block.start <= pc);
        let mut block = through.saturating_sub(1) as u32;
        while block > 0 && self.blocks[block as usize].end <= pc {
            block = self.blocks[block as usize].outer;
        }
        block
    }

    /// Notes where scans can halt.
    pub fn note_stops(&mut self) {
        self.stops = vec![0; self.instrs.len()];
        for place in self.blocks.iter().filter(|place| place.start < place.end) {
            self.stops[place.start as usize] |= stop::BLOCK;
        }
        for place in &self.networks {
            // Networks without code at the end have no instruction to halt at.
            if let Some(stops) = self.stops.get_mut(place.start as usize) {
                *stops |= stop::NETWORK;
            }
        }
    }
}

/// Where a network's code begins.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct NetworkPlace {
    pub start: u32,
    /// By its number in the program.
    pub network: u32,
}

/// Where a block's code is.
#[derive(Debug, Clone, Copy)]
pub struct BlockPlace {
    /// Its first instruction.
    pub start: u32,
    /// The one after it.
    pub end: u32,
    /// The block in whose body it is; the first one for a block that is in none.
    pub outer: u32,
    /// What the watchdog counts for it and the blocks before it.
    pub work_through: u32,
    /// The power that leaves it: low if it faults.
    pub out: Bit,
    /// Where it is drawn.
    pub location: Location,
    /// Where its errors are reported.
    pub controller: Controller,
    /// It is in a plant, or in the body of a block there.
    pub is_of_plant: bool,
}

/// An array that is indexed while scanning.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct ArrayPlace {
    /// Slot of its first element.
    pub base: u32,
    /// Index of the first element.
    pub first: i64,
    /// Index of the last element.
    pub last: i64,
}

/// A part of the drawing and the slot that holds its power.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ElementPlace {
    pub kind: ElementKind,
    pub location: Location,
    pub power: Bit,
    /// Its network, by its number in the program.
    pub network: u32,
    /// The step whose power it shows, to see whether it was reached.
    pub step: u32,
    /// The instruction before which that power is there.
    pub at: u32,
}

//! From the program model to flat code.
//!
//! Every tag gets its slots, every power its own bit (written once in a scan, so that all of them can be shown
//! afterwards), and every network becomes a stretch of instructions in its order of evaluation. A power that is
//! the same as another by its nature (after a coil, a join with an open end) shares that one's slot.
//!
//! Nothing here can fail on a program that the analysis found correct, but for want of memory.

mod arguments;
mod c_arithmetic;
mod call_graph;
mod chosen;
mod coils;
mod conditions;
mod controller;
mod cycles;
mod data;
mod expansion;
mod expression;
mod flow;
mod formula;
mod instruction;
mod network;
mod number_coils;
mod owner;
mod parts;
mod place;
mod plants;
mod ports;
#[cfg(test)]
mod profile_tests;
mod range;
mod range_blocks;
mod selection;
mod state;
mod strings;
mod tables;
mod ticks;
mod units;
mod unread;
mod user_block;

use crate::code::{ArrayPlace, Code, ElementPlace, Instr};
use crate::compile_error::CompileError;
use crate::fuse::{Fused, fuse};
use crate::layout::{Borrowed, Home, Layout};
use crate::memory::{Bit, Memory, Word};
use crate::places::{BlockAt, Cell, EdgeOf, Places, Remembered};
use crate::retain::{Retained, kept_tags, retained};
use crate::system::System;
use crate::work;
use call_graph::Cycles;
use flow::Region;
use ladder_analysis::program::{Location, Program, TagId};
use ladder_instructions::Semantics;
use owner::{Owner, Thing};
use plants::PlantCells;
pub use ports::{CHANNELS, Ports};
use std::collections::HashMap;
use std::ops::Range;

/// A program ready to run.
#[derive(Debug)]
pub struct Compiled {
    /// What a scan walks through, as it also runs in steps and with forces.
    pub code: Code,
    /// The same, as it runs without forces.
    pub(crate) fused: Fused,
    /// Where each tag lives, in the order of the program's tags.
    pub homes: Vec<Home>,
    /// The words that hold a literal of the program and are never written.
    pub literals: HashMap<Word, i64>,
    /// Memory at a cold start.
    pub initial: Memory,
    /// What can be shown as live or dead, in the order of the drawing.
    pub(crate) elements: Vec<ElementPlace>,
    /// For each network of the drawing, whether some scans may not reach it.
    pub(crate) skippable: Vec<bool>,
    /// For each network of the drawing where its code is; that of the first place where it is in a block's body.
    pub(crate) stretches: Vec<Range<u32>>,
    /// Where the ports are.
    pub ports: Ports,
    /// What a warm restart keeps.
    pub retained: Vec<Retained>,
    /// What no tag of the program holds, for a change of the running program.
    pub(crate) places: Places,
    /// What plants have of their own, where there are any.
    pub(crate) plants: Option<PlantCells>,
}

/// More code than this is refused: user-defined blocks inside blocks can multiply without end.
const MOST_INSTRUCTIONS: usize = 1 << 24;

fn too_large(location: Location) -> CompileError {
    CompileError {
        message:
            "the program takes more memory than the simulator has; user-defined blocks inside blocks multiply"
                .into(),
        location,
    }
}

type Result<T> = std::result::Result<T, CompileError>;

/// Compiles a program that is to run a scan in each interval, in nanoseconds. Each file's blocks are compiled for its
/// profile: what differs there is other code, so that nothing is asked about profiles while scanning.
///
/// # Errors
/// The program takes more memory than there is, or its files do not agree on an address.
pub fn compile(program: &Program, interval: i64) -> Result<Compiled> {
    if let Some(disagreement) = &program.disagreement {
        return Err(CompileError {
            message: disagreement.message.clone(),
            location: disagreement.location,
        });
    }
    expansion::check(program)?;
    let mut layout = Layout::new();
    let homes = program
        .tags
        .iter()
        .map(|tag| match tag.block {
            // Tags of a block's body get room for each place where the block is.
            Some(_) => Ok(Home::Borrowed(Borrowed::Unbound)),
            None => layout.tag(tag),
        })
        .collect::<Result<Vec<Home>>>()?;
    let mut block_tags = vec![Vec::new(); program.blocks.len()];
    for (index, tag) in program.tags.iter().enumerate() {
        if let Some(block) = tag.block {
            block_tags[block].push(TagId(index as u32));
        }
    }
    let mut compiler = Compiler {
        program,
        layout,
        homes,
        code: Code::default(),
        elements: Vec::new(),
        skippable: vec![false; program.networks.len()],
        stretches: vec![0..0; program.networks.len()],
        constants: HashMap::new(),
        arrays: HashMap::new(),
        regions: Vec::new(),
        outer: 0,
        functions: vec![0; program.functions.len()],
        calls: Vec::new(),
        powers: Vec::new(),
        step: 0,
        cycles: Cycles::default(),
        ports: Ports::default(),
        block_tags,
        shown: vec![false; program.blocks.len()],
        outer_powers: Vec::new(),
        keeps: kept_tags(program),
        retained: Vec::new(),
        retained_edges: Vec::new(),
        kept_things: HashMap::new(),
        semantics: &Semantics::IEC,
        interval,
        edges: HashMap::new(),
        starts: HashMap::new(),
        complaints: Vec::new(),
        slips: None,
        line_free: None,
        places: Places::default(),
        standing: Vec::new(),
        owners: Vec::new(),
        passed_owners: HashMap::new(),
        owned_bits: HashMap::new(),
        owned_tags: HashMap::new(),
        owned: Vec::new(),
        unread: unread::Seen::default(),
        system: System::CONTROLLER,
        plant: None,
        plant_cells: None,
        ended: Vec::new(),
    };
    compiler.parts_at_any_time();
    compiler.starting_counts();
    compiler.regions()?;
    Ok(compiler.finish())
}

struct Compiler<'p> {
    program: &'p Program,
    layout: Layout,
    homes: Vec<Home>,
    code: Code,
    elements: Vec<ElementPlace>,
    skippable: Vec<bool>,
    stretches: Vec<Range<u32>>,
    constants: HashMap<i64, Word>,
    arrays: HashMap<ArrayPlace, u32>,
    /// The stretch of networks that is being compiled, with those it is in.
    regions: Vec<Region>,
    /// The block that is being compiled, of `code.blocks`; the first one outside of all blocks.
    outer: u32,
    /// The first instruction of each function.
    functions: Vec<u32>,
    /// Calls whose function was not compiled yet: instruction and function.
    calls: Vec<(u32, usize)>,
    /// The power of each step of the network that is being compiled.
    powers: Vec<Bit>,
    /// The step that is being compiled.
    step: usize,
    /// Which functions call each other.
    cycles: Cycles,
    ports: Ports,
    /// Of each user-defined block the tags of its body.
    block_tags: Vec<Vec<TagId>>,
    /// Whether a place where it is was compiled.
    shown: Vec<bool>,
    /// The powers of the networks around the body that is being compiled.
    outer_powers: Vec<Vec<Bit>>,
    /// Of each tag whether it is retentive.
    keeps: Vec<bool>,
    /// Retentive tags of bodies, one for each place.
    retained: Vec<(TagId, Home)>,
    /// Edges of blocks whose states are retentive tags, by the names that they have in a file.
    retained_edges: Vec<(String, Home)>,
    /// How many things are kept of each tag that holds such states, by the name of the first like it.
    kept_things: HashMap<&'p str, u32>,
    /// What the profile of the file does otherwise whose network is being compiled.
    semantics: &'static Semantics,
    /// The time between two scans in nanoseconds.
    interval: i64,
    /// The memories of edges that belong to a tag, by its slot.
    edges: HashMap<EdgeOf, Bit>,
    /// What counters begin with, where it is not 0.
    starts: HashMap<TagId, Word>,
    /// The bits that show, when the block that is being compiled is done, whether it divided by zero.
    complaints: Vec<Bit>,
    /// What notes that the block that is being compiled went wrong, where it goes on all the same.
    slips: Option<formula::Slips>,
    /// The scan from which on the serial port is free, where sending takes time.
    line_free: Option<Word>,
    places: Places,
    /// The block that is being compiled, after those in whose bodies it is.
    standing: Vec<BlockAt>,
    /// The states that are tags of the blocks in whose bodies it is.
    owners: Vec<Owner>,
    /// What in-outs stand for that are states of blocks.
    passed_owners: HashMap<TagId, Owner>,
    /// What such states have besides the tags of the program: the first bit, one for each state.
    owned_bits: HashMap<Thing, Bit>,
    /// The same for the tags of bodies inside: the first two, which say where all are.
    owned_tags: HashMap<Thing, (Home, Home)>,
    /// What else belongs to states that are tags: the first tag like it, and the cells.
    owned: Vec<(TagId, Home)>,
    /// What is known of unread parts.
    unread: unread::Seen,
    /// The system tags of what is being compiled.
    system: System,
    /// The plant that is being compiled.
    plant: Option<usize>,
    /// What plants have of their own, once they are compiled.
    plant_cells: Option<PlantCells>,
    /// Of each plant the bit that says that it has ended, if it may.
    ended: Vec<Option<Bit>>,
}

impl Compiled {
    /// Where the system tags of plants are, if there are plants: how many bits and words after those of the controller.
    pub fn system_of_plants(&self) -> Option<(u32, u32)> {
        self.plants.as_ref().map(|plants| plants.system.offsets())
    }

    /// Where the code of a network is. None: it has none, or the network is in the body of a block, each place of which
    /// has code of its own.
    pub fn stretch_of(&self, network: usize) -> Option<Range<u32>> {
        let stretch = self.stretches.get(network)?;
        (!stretch.is_empty()).then(|| stretch.clone())
    }

    /// What the blocks of a network remember that no tag holds, in the order of the code: edges and the like.
    pub fn remembered_in(&self, network: usize) -> impl Iterator<Item = Cell> + '_ {
        let remembered = self.places.remembered.iter();
        let here = remembered.filter(move |it| it.path.first().is_some_and(|block| block.network == network));
        here.map(|it| it.cell)
    }

    /// The memories that all edges of a tag share, where edges belong to tags: the cell of the tag, and the memory.
    pub fn edges_of_tags(&self) -> impl Iterator<Item = (Cell, Bit)> + '_ {
        let edges = self.places.of_tags.iter();
        edges.map(|(of, memory)| match *of {
            EdgeOf::Bit(bit) => (Cell::Bit(bit), *memory),
            EdgeOf::Word(word) => (Cell::Word(word), *memory),
        })
    }
}

impl Compiler<'_> {
    fn finish(mut self) -> Compiled {
        for (at, function) in std::mem::take(&mut self.calls) {
            if let Instr::Call { to, .. } = &mut self.code.instrs[at as usize] {
                *to = self.functions[function];
            }
        }
        self.open_owned();
        self.count_work();
        self.code.note_stops();
        let Layout {
            mut memory,
            temporary,
            ..
        } = self.layout;
        let fused = fuse(&self.code, temporary, &mut memory);
        self.places.of_tags.extend(self.edges);
        self.places.line_free = self.line_free;
        Compiled {
            fused,
            places: self.places,
            plants: self.plant_cells,
            ports: self.ports,
            retained: retained(
                self.program,
                &self.homes,
                &self.keeps,
                &self.retained,
                self.retained_edges,
            ),
            code: self.code,
            homes: self.homes,
            literals: self
                .constants
                .into_iter()
                .map(|(value, word)| (word, value))
                .collect(),
            initial: memory,
            elements: self.elements,
            skippable: self.skippable,
            stretches: self.stretches,
        }
    }

    /// Notes what blocks count for the watchdog: one each, and more for one of very many instructions.
    fn count_work(&mut self) {
        let Code {
            instrs,
            blocks,
            work_through,
            ..
        } = &mut self.code;
        let mut work = 0;
        for block in 0..blocks.len() {
            let end = blocks
                .get(block + 1)
                .map_or(instrs.len(), |next| next.start as usize);
            // Instructions before the first block count for none.
            work_through.resize(blocks[block].start as usize, work);
            work += 1 + work::blocks(end - blocks[block].start as usize);
            blocks[block].work_through = work;
        }
        work_through.resize(instrs.len(), work);
    }

    /// The block that is being compiled remembers something from scan to scan.
    fn remember(&mut self, cell: Cell) {
        self.places.remembered.push(Remembered {
            path: self.standing.clone(),
            cell,
        });
    }

    fn emit(&mut self, instr: Instr) {
        self.code.instrs.push(instr);
    }

    /// Where the next instruction will be.
    fn here(&self) -> u32 {
        self.code.instrs.len() as u32
    }

    /// A word that holds a value and is never written.
    fn constant(&mut self, value: i64) -> Word {
        let layout = &mut self.layout;
        *self
            .constants
            .entry(value)
            .or_insert_with(|| layout.constant(value))
    }
}

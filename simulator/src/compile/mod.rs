//! From the program model to flat code.
//!
//! Every tag gets its slots, every power its own bit (written once in a scan, so that all of them can be shown
//! afterwards), and every network becomes a stretch of instructions in its order of evaluation. A power that is
//! the same as another by its nature (behind a coil, a join with an open end) shares that one's slot.
//!
//! Nothing here can fail on a program that the analysis found correct, but for want of memory.

mod arguments;
mod c_arithmetic;
mod call_graph;
mod coils;
mod conditions;
mod controller;
mod cycles;
mod data;
mod expression;
mod flow;
mod formula;
mod number_coils;
mod place;
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
mod user_block;

use crate::code::{ArrayPlace, BlockPlace, Code, ElementPlace, Instr, NetworkPlace};
use crate::fuse::{Fused, fuse};
use crate::layout::{Home, Layout};
use crate::memory::{Bit, Memory, Word};
use crate::places::{BlockAt, Cell, Places, Remembered};
use crate::retain::{Retained, kept_tags, retained};
use crate::work;
use arguments::Arguments;
use call_graph::Cycles;
pub(crate) use cycles::COUNT as COUNT_OF_SCANS;
use flow::Region;
use ladder_analysis::program::{Block, BlockKind, Location, Program, Step, TagId};
use ladder_instructions::{Counting, Instruction, Law, Op, Relay, Serial, Tables, Timing};
pub(crate) use ports::{CHANNELS, Ports};
use std::collections::HashMap;
use std::ops::Range;
pub(crate) use ticks::COUNT as COUNT_OF_TICKS;
pub(crate) use units::MOST_UNITS;

/// Why a program cannot run in the simulator.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CompileError {
    /// What is wrong and what to do.
    pub message: String,
    /// Where.
    pub location: Location,
}

impl std::fmt::Display for CompileError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for CompileError {}

/// A program ready to run.
#[derive(Debug)]
pub(crate) struct Compiled {
    pub(crate) code: Code,
    /// The same, as it runs without forces.
    pub(crate) fused: Fused,
    /// Where each tag lives, in the order of the program's tags.
    pub(crate) homes: Vec<Home>,
    /// Memory at a cold start.
    pub(crate) initial: Memory,
    /// What can be shown as live or dead, in the order of the drawing.
    pub(crate) elements: Vec<ElementPlace>,
    /// For each network of the drawing, whether some scans may not reach it.
    pub(crate) skippable: Vec<bool>,
    /// For each network of the drawing where its code is; that of the first place where it is in a block's body.
    pub(crate) stretches: Vec<Range<u32>>,
    /// Where the ports are.
    pub(crate) ports: Ports,
    /// What a warm restart keeps.
    pub(crate) retained: Vec<Retained>,
    /// What no tag of the program holds, for a change of the running program.
    pub(crate) places: Places,
}

/// More code than this is refused: user-defined blocks inside blocks can multiply without end.
const MOST_INSTRUCTIONS: usize = 1 << 24;

type Result<T> = std::result::Result<T, CompileError>;

/// Compiles a program that is to run a scan in each interval, in nanoseconds. Each file's blocks are compiled for its
/// profile: what differs there is other code, so that nothing is asked about profiles while scanning.
pub(crate) fn compile(program: &Program, interval: i64) -> Result<Compiled> {
    let mut layout = Layout::new();
    let homes = program
        .tags
        .iter()
        .map(|tag| match tag.block {
            // Tags of a block's body get room for each place where the block is.
            Some(_) => Ok(Home::Unbound),
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
        law: &Law::IEC,
        interval,
        edges: HashMap::new(),
        starts: HashMap::new(),
        complaints: Vec::new(),
        slips: None,
        line_free: None,
        places: Places::default(),
        standing: Vec::new(),
    };
    compiler.starting_counts();
    compiler.controller();
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
    /// What the profile of the file does otherwise whose network is being compiled.
    law: &'static Law,
    /// The time between two scans in nanoseconds.
    interval: i64,
    /// The memories of edges that belong to a tag, by its slot.
    edges: HashMap<EdgeOf, Bit>,
    /// What counters begin with, where it is not 0.
    starts: HashMap<TagId, Word>,
    /// The bits that tell, when the block that is being compiled is done, whether it divided by zero.
    complaints: Vec<Bit>,
    /// What notes that the block that is being compiled went wrong, where it goes on all the same.
    slips: Option<formula::Slips>,
    /// The scan from which on the serial port is free, where sending takes time.
    line_free: Option<Word>,
    places: Places,
    /// The block that is being compiled, behind those in whose bodies it is.
    standing: Vec<BlockAt>,
}

/// What an edge belongs to that is shared by all edges of a tag.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum EdgeOf {
    Bit(Bit),
    Word(Word),
}

impl Compiler<'_> {
    fn finish(mut self) -> Compiled {
        for (at, function) in std::mem::take(&mut self.calls) {
            if let Instr::Call { to, .. } = &mut self.code.instrs[at as usize] {
                *to = self.functions[function];
            }
        }
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
            ports: self.ports,
            retained: retained(self.program, &self.homes, &self.keeps, &self.retained),
            code: self.code,
            homes: self.homes,
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

    /// One network: its steps in their order.
    fn network(&mut self, index: usize) -> Result<()> {
        let program = self.program;
        let network = &program.networks[index];
        let outer_law = std::mem::replace(&mut self.law, program.law(network.location));
        let start = self.here();
        self.code.networks.push(NetworkPlace {
            start,
            network: index as u32,
        });
        if self.skippable[index] {
            let network = self.noted(self.regions.len() - 1);
            self.emit(Instr::Network { network });
        }
        let lights_itself = self.law.relay == Relay::Power && flow::holds(network, Op::Mcr);
        let outer = std::mem::take(&mut self.powers);
        let mut ends = Vec::with_capacity(network.steps.len());
        for (number, &step) in network.steps.iter().enumerate() {
            self.step = number;
            let power = match step {
                Step::Start { rail: false } => Bit::LOW,
                Step::Start { rail: true } => self.rail(lights_itself),
                Step::Join { upper, lower } => self.join(self.powers[upper], self.powers[lower]),
                Step::Block { block, en } => {
                    self.standing.push(BlockAt {
                        network: index,
                        block,
                    });
                    let power = self.block(&network.blocks[block], self.powers[en])?;
                    self.standing.pop();
                    power
                }
            };
            self.powers.push(power);
            ends.push(self.here());
        }
        self.elements
            .extend(network.elements.iter().map(|element| ElementPlace {
                kind: element.kind,
                location: Location {
                    file: network.location.file,
                    range: element.range,
                },
                power: self.powers[element.step],
                network: index as u32,
                step: element.step as u32,
                at: ends[element.step],
            }));
        if self.stretches[index].is_empty() {
            self.stretches[index] = start..self.here();
        }
        self.powers = outer;
        self.law = outer_law;
        if self.layout.is_too_large() || self.code.instrs.len() > MOST_INSTRUCTIONS {
            return Err(CompileError {
                message: "the program takes more memory than the simulator has; user-defined blocks inside \
                          blocks multiply"
                    .into(),
                location: network.location,
            });
        }
        Ok(())
    }

    /// The left rail of a network. One that holds an `<MCR>` always has a live rail.
    fn rail(&mut self, lights_itself: bool) -> Bit {
        if !self.region().has_mcr || lights_itself {
            return Bit::HIGH;
        }
        let out = self.layout.bit();
        self.emit(Instr::Rail { out });
        out
    }

    fn join(&mut self, upper: Bit, lower: Bit) -> Bit {
        match (upper, lower) {
            (Bit::LOW, one) | (one, Bit::LOW) => one,
            (Bit::HIGH, _) | (_, Bit::HIGH) => Bit::HIGH,
            _ if upper == lower => upper,
            _ => {
                let out = self.layout.bit();
                self.emit(Instr::Join { out, upper, lower });
                out
            }
        }
    }

    /// One block; gives its ENO.
    fn block(&mut self, block: &Block, en: Bit) -> Result<Bit> {
        let number = self.code.blocks.len();
        self.code.blocks.push(BlockPlace {
            start: self.here(),
            end: self.here(),
            work_through: 0,
            out: en,
            location: block.location,
            controller: self.law.controller,
        });
        let out = match block.kind {
            BlockKind::Instruction(row) => self.instruction(row, block, en)?,
            BlockKind::User(index) => self.user_block(index, block, en)?,
        };
        let end = self.here();
        let place = &mut self.code.blocks[number];
        (place.end, place.out) = (end, out);
        Ok(out)
    }

    /// One instruction of the table. A new row does not compile until it has its line here.
    fn instruction(&mut self, row: &Instruction, block: &Block, en: Bit) -> Result<Bit> {
        let arguments = Arguments::of(block);
        match row.op {
            Op::Contact
            | Op::NegatedContact
            | Op::RisingContact
            | Op::FallingContact
            | Op::Inverter
            | Op::OneShotRising
            | Op::OneShotFalling
            | Op::Eq
            | Op::Ne
            | Op::Gt
            | Op::Ge
            | Op::Lt
            | Op::Le => self.condition(row, arguments, en),

            op if self.is_as_in_c(op) => self.c_arithmetic(op, arguments, en),
            Op::Lut | Op::Pwl if self.law.tables == Tables::Open => self.open_table(row.op, arguments, en),
            Op::Mov
            | Op::Typ
            | Op::Add
            | Op::Mul
            | Op::Sub
            | Op::Div
            | Op::Mod
            | Op::Exp
            | Op::Not
            | Op::And
            | Op::Or
            | Op::Xor
            | Op::Shl
            | Op::Shr
            | Op::Rol
            | Op::Ror
            | Op::Abs
            | Op::Neg
            | Op::Trunc
            | Op::Sqrt
            | Op::Ln
            | Op::Log
            | Op::Expe
            | Op::Sin
            | Op::Cos
            | Op::Tan
            | Op::Asin
            | Op::Acos
            | Op::Atan
            | Op::Rad
            | Op::Deg
            | Op::Min
            | Op::Max
            | Op::Limit
            | Op::Sel
            | Op::Calc
            | Op::Mux
            | Op::Lut
            | Op::Pwl
            | Op::Len
            | Op::Left
            | Op::Right
            | Op::Mid
            | Op::Concat
            | Op::Insert
            | Op::Delete
            | Op::Replace
            | Op::Find => self.data(row.op, arguments, en),
            Op::Bmov => self.move_range(arguments, en),
            Op::Fill => self.fill_range(arguments, en),
            Op::Pack => self.pack(arguments, en),
            Op::Unpack => self.unpack(arguments, en),
            Op::Shift => self.shift_range(arguments, en),
            Op::Search => self.search(arguments, en),

            Op::Ton | Op::Tof | Op::Tp | Op::Rto | Op::Rtof => match self.law.timing {
                Timing::Clock => self.timer(row.op, arguments, en),
                Timing::Scans => self.scan_timer(row.op, arguments, en),
                Timing::Ticks => self.tick_timer(row.op, arguments, en),
                Timing::Units => self.unit_timer(row.op, arguments, en),
            },
            Op::Ctu | Op::Ctd | Op::Ctud | Op::Ctc => match self.law.counting {
                Counting::Saturating => self.counter(row.op, arguments, en),
                Counting::Wrapping => self.wrapping_counter(row.op, arguments, en),
                Counting::Latching => self.latching_counter(row.op, arguments, en),
                Counting::Comparing => self.comparing_counter(row.op, arguments, en),
            },
            Op::Sr | Op::Rs => self.bistable(row.op, arguments, en),

            // That the tag is retentive is known from its declaration or from the coil, when the program starts.
            Op::Coil
            | Op::NegatedCoil
            | Op::SetCoil
            | Op::ResetCoil
            | Op::RisingCoil
            | Op::FallingCoil
            | Op::RetentiveCoil
            | Op::RetentiveSet
            | Op::RetentiveReset => self.coil(row, arguments, en),
            Op::Res => self.clear(arguments, en),

            // What PERSIST does is known when the program starts.
            Op::Lbl | Op::Fun | Op::Next | Op::Persist => Ok(en),
            Op::Jmp => self.jump(arguments, en),
            Op::Call => self.call(arguments, en),
            Op::Ret => self.ret(en),
            Op::End => self.end(en),
            Op::For => self.for_loop(arguments, en),
            Op::Mcr => Ok(self.mcr(en)),

            Op::Adc => self.analog_input(arguments, en),
            Op::Pwm => self.pulse_output(arguments, en),
            Op::Usnd if self.law.serial == Serial::EverySecondScan => self.send_slowly(arguments, en),
            Op::Usnd => self.send(arguments, en),
            Op::Urcv => self.receive(arguments, en),
            Op::Fmt if self.law.serial == Serial::EverySecondScan => self.send_text_slowly(arguments, en),
            Op::Fmt => self.send_text(arguments, en),
            Op::Scantime => self.scan_time(arguments, en),
        }
    }
}

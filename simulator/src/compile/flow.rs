//! Program flow (LANGUAGE §5.5): the main program, functions, jumps, calls, loops.

use super::arguments::Arguments;
use super::call_graph::Cycles;
use super::place::Slot;
use super::user_block::Output;
use super::{Compiler, Result};
use crate::code::{Instr, NOTHING_SAVED};
use crate::memory::{Bit, Word};
use crate::operation::{IntegerOp, Width};
use ladder_analysis::program::{Argument, Block, BlockKind, Bound, Network, Place, Program, SystemTag};
use ladder_instructions::{Op, Relay, Shape};
use ladder_syntax::Name;
use std::ops::Range;

/// A stretch of networks that jumps and loops do not leave: the main program, a function, a block's body.
#[derive(Debug)]
pub(super) struct Region {
    networks: Range<usize>,
    kind: Kind,
    /// Whether the rails can be switched off here.
    pub(super) has_mcr: bool,
    /// The first instruction of each network, and the one after the last.
    starts: Vec<u32>,
    /// Jumps, to be aimed when all networks are: instruction and network.
    jumps: Vec<(u32, usize)>,
    /// Returns from a block's body, to be aimed at its end.
    returns: Vec<u32>,
    loops: Vec<Loop>,
}

/// A loop, to be aimed likewise.
#[derive(Debug)]
struct Loop {
    /// The network of the FOR, and that of its NEXT.
    first: usize,
    last: usize,
    /// The instruction that enters, after which the body is, and the one that goes back.
    enter: u32,
    again: u32,
}

/// What a stretch of networks is.
#[derive(Debug)]
pub(super) enum Kind {
    Main,
    Function(usize),
    Body(BodyExit),
}

/// What is left to do where a body is left from within.
#[derive(Debug, Clone)]
pub(super) struct BodyExit {
    /// What its outputs are copied to.
    pub(super) outputs: Vec<Output>,
    /// Whether it has a frame of its own.
    pub(super) framed: bool,
    /// `<$B>`: what it does not do itself acts where the block is.
    pub(super) passes_on: bool,
    /// It is drawn with the power of another place, so what it reaches is not noted.
    pub(super) hidden: bool,
    /// The step of the outer network at which it is.
    pub(super) step: usize,
}

/// Whether a network holds a block of one of these instructions.
pub(super) fn holds_any(network: &Network, ops: &[Op]) -> bool {
    ops.iter().any(|&op| holds(network, op))
}

/// Whether a network holds a block of this instruction.
pub(super) fn holds(network: &Network, op: Op) -> bool {
    network.blocks.iter().any(|block| is(&block.kind, op))
}

/// Whether a block is this instruction.
pub(super) fn is(kind: &BlockKind, op: Op) -> bool {
    matches!(kind, BlockKind::Instruction(row) if row.op == op)
}

/// Notes which networks of the main program some scans may not reach, or not in one go: what jumps pass over or go back
/// to, what loops run, what is after an end.
fn note_skippable(program: &Program, skippable: &mut [bool]) {
    let main = program.main.clone();
    let loops = program.loops(main.clone());
    let mut outside_of_main = program
        .networks
        .iter()
        .enumerate()
        .filter(|(index, _)| !main.contains(index));
    let may_end_outside_of_main = outside_of_main.any(|(_, network)| holds(network, Op::End));
    // Where ranges begin and end, summed up at last: many may reach to the end.
    let mut edges = vec![0i32; program.networks.len() + 1];
    for index in main.clone() {
        let network = &program.networks[index];
        for block in &network.blocks {
            let target = match block.arguments.first().map(|bound| &bound.argument) {
                Some(Argument::Label(target)) => *target,
                _ => None,
            };
            let passed = match &block.kind {
                BlockKind::Instruction(row) => match row.op {
                    Op::Jmp => match target {
                        Some(target) if target > index => index..target,
                        Some(target) => target..index + 1,
                        None => index..main.end,
                    },
                    Op::Ret | Op::End => index..main.end,
                    Op::Call if may_end_outside_of_main => index..main.end,
                    Op::For => {
                        let own = loops.iter().find(|(first, _)| *first == index);
                        index + 1..own.map_or(main.end, |(_, last)| last + 1)
                    }
                    _ => continue,
                },
                // Its body may jump, return or end in the main program's stead.
                BlockKind::User(user) if program.blocks[*user].shape == Shape::Function => index..main.end,
                BlockKind::User(_) if may_end_outside_of_main => index..main.end,
                BlockKind::User(_) => continue,
            };
            edges[passed.start] += 1;
            edges[passed.end] -= 1;
        }
    }
    let mut open = 0;
    for (skippable, edge) in skippable.iter_mut().zip(edges) {
        open += edge;
        *skippable |= open > 0;
    }
}

impl Region {
    /// The network that is being compiled.
    fn current(&self) -> usize {
        (self.networks.start + self.starts.len()).saturating_sub(1)
    }
}

impl Compiler<'_> {
    pub(super) fn region(&mut self) -> &mut Region {
        self.regions
            .last_mut()
            .expect("networks are compiled inside a region")
    }

    /// The main program, then every function.
    pub(super) fn regions(&mut self) -> Result<()> {
        let program = self.program;
        self.cycles = Cycles::of(program);
        let main = program.main.clone();
        note_skippable(program, &mut self.skippable);
        self.plants()?;
        self.controller();
        self.stretch(main, Kind::Main)?;
        self.emit(Instr::Finish);
        for (index, function) in program.functions.iter().enumerate() {
            self.functions[index] = self.here();
            let interval = self.interval;
            self.interval *= i64::from(function.every.unwrap_or(1));
            self.skippable[function.networks.clone()].fill(true);
            self.compile_function(index)?;
            self.emit(Instr::Finish);
            self.interval = interval;
        }
        Ok(())
    }

    /// A region: all its networks, with its jumps and loops aimed.
    pub(super) fn stretch(&mut self, networks: Range<usize>, kind: Kind) -> Result<()> {
        let program = self.program;
        self.regions.push(Region {
            has_mcr: program.networks[networks.clone()]
                .iter()
                .any(|network| holds(network, Op::Mcr)),
            networks: networks.clone(),
            kind,
            starts: Vec::with_capacity(networks.len() + 1),
            jumps: Vec::new(),
            returns: Vec::new(),
            loops: (program.loops(networks.clone()).into_iter())
                .map(|(first, last)| Loop {
                    first,
                    last,
                    enter: 0,
                    again: 0,
                })
                .collect(),
        });
        for index in networks {
            let start = self.here();
            self.region().starts.push(start);
            self.network(index)?;
            self.loop_ends(index)?;
        }
        let end = self.here();
        self.region().starts.push(end);
        self.aim();
        Ok(())
    }

    /// What is after a network with `<NEXT>` or `<FOR>`. A network with both ends the one loop before it
    /// enters the other.
    fn loop_ends(&mut self, index: usize) -> Result<()> {
        let program = self.program;
        let network = &program.networks[index];
        let at = self.here();
        if holds(network, Op::Next)
            && let Some(ended) = self.region().loops.iter_mut().find(|it| it.last == index)
        {
            ended.again = at;
            self.emit(Instr::Again { body: 0 });
        }
        let at = self.here();
        if let Some(block) = network.blocks.iter().find(|block| is(&block.kind, Op::For))
            && let Some(begun) = self.region().loops.iter_mut().find(|it| it.first == index)
        {
            begun.enter = at;
            self.emit(Instr::Enter { body: 0, after: 0 });
            self.turn(block)?;
        }
        Ok(())
    }

    /// What begins each turn of a loop: its tag takes the number. The block is there once more, as the one that writes it.
    fn turn(&mut self, block: &Block) -> Result<()> {
        let arguments = Arguments::of(block);
        let Some(argument) = arguments.named("I") else {
            return Ok(());
        };
        let (place, ty) = arguments.as_place(argument)?;
        self.placed(block, Bit::HIGH, |compiler| {
            let (out, start) = compiler.begin_powered(Bit::HIGH);
            let spot = compiler.spot(place)?;
            let to = compiler.layout.word();
            compiler.emit(Instr::Turn {
                to,
                width: Width::of(ty),
            });
            compiler.store(spot, Slot::Word(to));
            compiler.end_powered(start);
            Ok(out)
        })?;
        Ok(())
    }

    /// Aims the jumps and loops of the region that was compiled.
    fn aim(&mut self) {
        let Some(region) = self.regions.pop() else { return };
        let start = |network: usize| region.starts[network - region.networks.start];
        for &(at, network) in &region.jumps {
            if let Instr::Jump { to, .. } = &mut self.code.instrs[at as usize] {
                *to = start(network);
            }
        }
        for &at in &region.returns {
            if let Instr::Jump { to, .. } = &mut self.code.instrs[at as usize] {
                *to = region.starts[region.networks.len()];
            }
        }
        for it in &region.loops {
            let body = it.enter + 1;
            self.code.instrs[it.enter as usize] = Instr::Enter {
                body,
                after: start(it.last + 1),
            };
            self.code.instrs[it.again as usize] = Instr::Again { body };
        }
    }

    /// `<JMP>`: no power passes it. With EN low there is none, with EN high it leaves.
    pub(super) fn jump(&mut self, arguments: Arguments, en: Bit) -> Result<Bit> {
        match arguments.get(0)? {
            Argument::Label(Some(target)) if self.region().networks.contains(target) => {
                let (at, target) = (self.here(), *target);
                self.region().jumps.push((at, target));
                let (step, network) = self.whereabouts();
                self.emit(Instr::Jump {
                    en,
                    to: 0,
                    step,
                    network,
                });
                Ok(Bit::LOW)
            }
            Argument::OuterLabel(label) => self.jump_out(arguments, label, en),
            _ => Err(arguments.mismatch()),
        }
    }

    /// A jump from the body of a `<$B>` to a label around the place where the block is: the nearest after that
    /// place, else the nearest before it.
    fn jump_out(&mut self, arguments: Arguments, label: &Name, en: Bit) -> Result<Bit> {
        let program = self.program;
        let outer = self.regions.len().saturating_sub(1);
        for level in (0..outer).rev() {
            if !matches!(&self.regions[level + 1].kind, Kind::Body(exit) if exit.passes_on) {
                break;
            }
            let (here, networks) = (
                self.regions[level].current(),
                self.regions[level].networks.clone(),
            );
            let labels = program
                .labels
                .iter()
                .filter(|(name, network)| name == label && networks.contains(network));
            let mut networks = labels.map(|&(_, network)| network);
            let target = networks
                .clone()
                .find(|&network| network > here)
                .or_else(|| networks.next_back());
            if let Some(target) = target {
                let (step, network) = self.whereabouts();
                let (en, start) = self.leave_bodies(level, en);
                let at = self.here();
                self.regions[level].jumps.push((at, target));
                self.emit(Instr::Jump {
                    en,
                    to: 0,
                    step,
                    network,
                });
                self.end_leaving(start);
                return Ok(Bit::LOW);
            }
        }
        Err(arguments.refused(format!(
            "there is no label `{}` in this block, nor where the block is",
            label.as_str()
        )))
    }

    /// The step and the network that are being compiled.
    fn whereabouts(&self) -> (u32, u32) {
        (self.step as u32, self.noted(self.regions.len().saturating_sub(1)))
    }

    /// The network that is being compiled in a region, as the machine notes how far it was run. A body is drawn
    /// once, as its first place runs it: networks of all other places share a number after all of them.
    pub(super) fn noted(&self, region: usize) -> u32 {
        let hides = |region: &Region| matches!(&region.kind, Kind::Body(exit) if exit.hidden);
        match self.regions.get(..=region) {
            Some(regions) if regions.iter().any(hides) => self.program.networks.len() as u32,
            _ => self.regions.get(region).map_or(0, Region::current) as u32,
        }
    }

    /// The number of the region in which a `<RET>` or `<END>` takes effect, counted from the outermost: the bodies
    /// of `<$B>` blocks pass it on.
    fn acting_region(&self) -> usize {
        let acts = |region: &Region| !matches!(&region.kind, Kind::Body(exit) if exit.passes_on);
        self.regions.iter().rposition(acts).unwrap_or(0)
    }

    /// Begins what leaves the bodies inside the region `outer`: their outputs are copied out and their frames
    /// closed, with EN high only. Returns the power with which the rest is to be done, and where it began.
    fn leave_bodies(&mut self, outer: usize, en: Bit) -> (Bit, Option<usize>) {
        if outer + 1 == self.regions.len() {
            return (en, None);
        }
        let (_, start) = self.begin_powered(en);
        let (mut step, mut network) = self.whereabouts();
        for level in (outer + 1..self.regions.len()).rev() {
            self.emit(Instr::Left { step, network });
            let Kind::Body(exit) = &self.regions[level].kind else {
                continue;
            };
            let exit = exit.clone();
            self.copy_out(&exit.outputs);
            if exit.framed {
                self.emit(Instr::LeaveBody);
            }
            (step, network) = (exit.step as u32, self.noted(level - 1));
        }
        self.emit(Instr::Left { step, network });
        (Bit::HIGH, Some(start))
    }

    fn end_leaving(&mut self, start: Option<usize>) {
        if let Some(start) = start {
            self.end_powered(start);
        }
    }

    /// `<CALL>`: its power is EN, whatever the function does.
    pub(super) fn call(&mut self, arguments: Arguments, en: Bit) -> Result<Bit> {
        let Argument::Function(function) = *arguments.get(0)? else {
            return Err(arguments.mismatch());
        };
        let en = self.unless_ended(function, en);
        let every = self.program.functions[function].every.filter(|every| *every > 1);
        let before = every.map_or_else(Vec::new, |every| self.at_the_rate_of(every));
        let at = self.here();
        self.calls.push((at, function));
        let caller = self.regions.iter().find_map(|region| match region.kind {
            Kind::Function(function) => Some(function),
            _ => None,
        });
        let saved = match caller {
            // The call may come back to this network before it returns, and would overwrite its powers.
            Some(caller) if self.cycles.share_a_cycle(caller, function) => {
                let mut powers = self.outer_powers.concat();
                powers.extend(&self.powers);
                powers.retain(|&power| power != Bit::LOW && power != Bit::HIGH);
                self.code.saved.push(powers);
                self.code.saved.len() as u32 - 1
            }
            _ => NOTHING_SAVED,
        };
        self.emit(Instr::Call { en, to: 0, saved });
        for (to, from) in before {
            self.emit(Instr::Move { to, from });
        }
        if let Some(ended) = self.plant_ended() {
            let (step, network) = self.whereabouts();
            self.emit(Instr::Return {
                en: ended,
                step,
                network,
            });
        }
        Ok(en)
    }

    /// Lets `SYS` count the runs of a task that runs once in so many scans. Returns what of it held something else, and what that was.
    fn at_the_rate_of(&mut self, every: u32) -> Vec<(Word, Word)> {
        let every = self.constant(i64::from(every));
        let mut counted = vec![(Word::SCAN_TIME, IntegerOp::Mul, Width::I64)];
        // Without a need a proof does not depend on the number of the scan.
        let blocks = self.program.networks.iter().flat_map(|network| &network.blocks);
        let mut places = blocks.flat_map(|block| block.arguments.iter().flat_map(Bound::places));
        if places.any(|(place, _)| *place == Place::System(SystemTag::Scan)) {
            counted.push((Word::SCAN, IntegerOp::Div, Width::I32));
        }
        let before = counted.into_iter().map(|(to, op, width)| {
            let before = self.layout.word();
            self.emit(Instr::Move { to: before, from: to });
            self.emit(Instr::Integer {
                op,
                width,
                to,
                a: to,
                b: every,
            });
            (to, before)
        });
        before.collect()
    }

    /// `<RET>`: ends the function, the scan, or the body of a `[$B]`.
    pub(super) fn ret(&mut self, en: Bit) -> Bit {
        let outer = self.acting_region();
        let (step, network) = self.whereabouts();
        let (en, start) = self.leave_bodies(outer, en);
        if matches!(self.regions[outer].kind, Kind::Body(_)) {
            let at = self.here();
            self.regions[outer].returns.push(at);
            self.emit(Instr::Jump {
                en,
                to: 0,
                step,
                network,
            });
        } else {
            self.emit(Instr::Return { en, step, network });
        }
        self.end_leaving(start);
        Bit::LOW
    }

    /// `<END>`: in a plant it ends that one.
    pub(super) fn end(&mut self, en: Bit) -> Bit {
        let (step, network) = self.whereabouts();
        let (en, start) = self.leave_bodies(0, en);
        if let Some(ended) = self.plant_ended() {
            self.emit(Instr::OrBit {
                to: ended,
                a: ended,
                b: en,
            });
            self.emit(Instr::Return { en, step, network });
        } else {
            self.emit(Instr::End { en, step, network });
        }
        self.end_leaving(start);
        Bit::LOW
    }

    /// `<FOR>`: notes the turns; the loop is entered at the end of the network. With EN low the count is not read.
    pub(super) fn for_loop(&mut self, arguments: Arguments, en: Bit) -> Result<Bit> {
        // A slot of its own: reading the count may fault.
        let (out, start) = self.begin_powered(en);
        let turns = self.count(arguments.value(0)?)?;
        if self.code.instrs.len() == start + 1 {
            self.code.instrs.truncate(start);
            self.emit(Instr::For { en, turns });
            return Ok(en);
        }
        self.end_powered(start);
        // After the skip, so that a loop without power notes that it makes no turn. A fault passes this by, and
        // the loop before it left no turns.
        self.emit(Instr::For { en: out, turns });
        Ok(out)
    }

    /// `<MCR>`
    pub(super) fn mcr(&mut self, en: Bit) -> Bit {
        match self.semantics.relay {
            Relay::Power => self.emit(Instr::Mcr { en }),
            Relay::Toggle => {
                let live = self.layout.bit();
                self.emit(Instr::Rail { out: live });
                let dead = self.layout.bit();
                self.emit(Instr::NotBit { to: dead, a: live });
                self.emit(Instr::OrBit {
                    to: dead,
                    a: dead,
                    b: en,
                });
                self.emit(Instr::Mcr { en: dead });
            }
        }
        en
    }
}

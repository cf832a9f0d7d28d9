//! Why tags hold what they hold at one moment of which only the values are known: taken from a controller, without a run.
//!
//! Each network is run from the values of the moment: what a network has written is put back to what was given before the next
//! begins. A loop is run as a whole, and so is what several blocks call: there the values of one turn are not those of the moment. No time passes. Edges hold what their operands hold, so that none of them comes through.

use super::known::{Open, known};
use super::reasons::{self, Blocker};
use super::trace::{self, Traced};
use super::writers::{Writers, called_by};
use super::{Reason, Write, place};
use crate::fault::Fault;
use crate::layout::Home;
use crate::memory::Bit;
use crate::places::{BlockAt, networks_of_bodies};
use crate::simulation::{Scope, Simulation, State, Status};
use crate::tags::{Point, Within};
use crate::timers::Timer;
use ladder_analysis::program::{Block, BlockKind, Network, Program};
use ladder_analysis::values::value::Value;
use ladder_instructions::{Op, StateType};
use std::collections::{HashMap, HashSet};

/// So many tags are asked about for one question.
const MOST_ASKED: usize = 40;
/// So far the chain is followed.
const DEEPEST: usize = 4;

/// A program, and the values of a moment.
#[derive(Debug)]
pub struct Moment {
    pub(super) simulation: Simulation,
    pub(super) writers: Writers,
    /// Before the program has done anything.
    initial: State,
    /// The first instruction of each network outside of the bodies of blocks.
    starts: HashMap<u32, usize>,
    /// Of each network whether it goes on with the values of those that ran before it.
    goes_on: Vec<bool>,
    /// The names of what functions read which several blocks call.
    shared: HashSet<String>,
    given: Vec<(Point, Value)>,
    /// The timers of which something was given.
    timers: Vec<(Timer, StateType)>,
    pub(super) names: HashSet<String>,
    /// What that leaves open.
    pub(super) open: Open,
    /// Of each network the given values that it may write over.
    written: HashMap<usize, Vec<usize>>,
    /// The given values in the states of blocks.
    inside: Vec<usize>,
    /// The given values that several networks write and a function reads which several blocks call: what it is called with.
    /// They are not put back.
    parameters: HashSet<usize>,
    /// Inputs of bodies that were not given, and that blocks make of what was given.
    handed_over: HashSet<String>,
    /// The given values that a network leaves as others, with that network.
    others: Vec<(usize, usize)>,
    /// How many moments there were.
    moments: i64,
    /// Before the scan in which the networks are seen.
    settled: State,
}

/// What the program says of a tag's value.
#[derive(Debug, Clone, PartialEq)]
pub struct Judged {
    /// The tag.
    pub point: Point,
    /// What it holds: what was given, or what it begins with.
    pub value: Value,
    /// Whether that was given.
    pub is_given: bool,
    /// What the blocks that may write it do, in their order; those that are not reached are not there.
    pub judgements: Vec<Judgement>,
    /// How many blocks may write it.
    pub writers: usize,
    /// What was not given and may decide what these networks do with the tag.
    pub missing: Vec<Point>,
    /// What decides, and is written after these networks have read it: what was given is not what they have read.
    pub overwritten: Vec<Point>,
    /// The same of the tags that were read.
    pub because: Vec<Judged>,
}

/// What a block that may write a tag does.
#[derive(Debug, Clone, PartialEq)]
pub struct Judgement {
    /// How power comes to it, or what stops it. Its scan means nothing.
    pub write: Write,
    /// Whether it writes the tag.
    pub writes: bool,
    /// What the tag holds after it.
    pub leaves: Value,
    /// The network that it is in.
    pub network: usize,
}

impl Judged {
    /// What contradicts the value: the last block that writes the tag leaves another one, whatever was not given.
    pub fn contradiction(&self) -> Option<&Judgement> {
        self.other_value().filter(|_| self.overwritten.is_empty())
    }

    /// What would contradict the value, if all had been read as it was given.
    pub(super) fn other_value(&self) -> Option<&Judgement> {
        let last = self.judgements.iter().rfind(|judgement| judgement.writes)?;
        (self.is_given && self.missing.is_empty() && last.leaves != self.value).then_some(last)
    }

    /// What was written after it was read, where that leaves open whether the program explains the value.
    pub fn undecided(&self) -> &[Point] {
        match self.other_value() {
            Some(_) => &self.overwritten,
            None => &[],
        }
    }
}

impl Moment {
    /// A program before its first scan, whose interval should be 0, with the values of a moment.
    ///
    /// # Errors
    /// With these values it does not come through a scan: its faults.
    pub fn new(mut simulation: Simulation, given: Vec<(Point, Value)>) -> Result<Moment, Vec<Fault>> {
        let writers = Writers::of(&simulation);
        let program = simulation.program();
        let is_of_body = networks_of_bodies(program);
        let stretches = simulation.compiled.stretches.iter().enumerate();
        let starts =
            stretches.filter(|(network, stretch)| stretch.start < stretch.end && !is_of_body[*network]);
        let starts = starts
            .map(|(network, stretch)| (stretch.start, network))
            .collect();
        let goes_on = networks_that_go_on(program);
        let shared = read_in_shared_functions(&simulation, &goes_on);
        simulation.set_cancel(None);
        let initial = simulation.state();
        let mut moment = Moment {
            simulation,
            writers,
            settled: initial.clone(),
            initial,
            starts,
            goes_on,
            shared,
            given: Vec::new(),
            timers: Vec::new(),
            names: HashSet::new(),
            open: Open::default(),
            written: HashMap::new(),
            inside: Vec::new(),
            parameters: HashSet::new(),
            handed_over: HashSet::new(),
            others: Vec::new(),
            moments: 0,
        };
        moment.become_another(given)?;
        Ok(moment)
    }

    /// The values of another moment. Nothing of the one before is left; moments count as scans.
    ///
    /// # Errors
    /// As for the first.
    pub fn become_another(&mut self, given: Vec<(Point, Value)>) -> Result<(), Vec<Fault>> {
        self.note(given);
        self.moments += 1;
        self.settled.clone_from(&self.initial);
        // Edges and timers get to know the values.
        self.see_all();
        if self.simulation.status == Status::Faulted {
            return Err(self.simulation.take_faults());
        }
        self.simulation.machine.scan = self.moments;
        self.settled = self.simulation.state();
        self.see_all();
        Ok(())
    }

    /// What is known of values before they are seen.
    fn note(&mut self, given: Vec<(Point, Value)>) {
        self.written.clear();
        self.inside.clear();
        self.timers.clear();
        self.parameters.clear();
        self.handed_over.clear();
        let simulation = &self.simulation;
        let mut last = None;
        for (index, (point, _)) in given.iter().enumerate() {
            if point.within == Within::Block {
                self.inside.push(index);
            }
            let tag = self.writers.tag_of(point);
            if let Some(Home::State { state, bits, words }) =
                tag.map(|tag| simulation.compiled.homes[tag.0 as usize])
                && state.is_timer()
                && last != tag
            {
                self.timers.push((Timer { bits, words }, state));
                last = tag;
            }
            let writers = self.writers.of_point(simulation, point);
            let mut networks: Vec<usize> = writers.iter().map(|at| at.network).collect();
            networks.dedup();
            for network in &networks {
                self.written.entry(*network).or_default().push(index);
            }
            let mut of_tag = self.writers.of_tag(tag).iter().map(|at| at.network);
            let first = of_tag.next();
            if self.shared.contains(&point.name) && of_tag.any(|other| Some(other) != first) {
                self.parameters.insert(index);
            }
        }
        self.names = given.iter().map(|(point, _)| point.name.clone()).collect();
        self.given = given;
    }

    /// The program after a scan in which each network was run from the values, which are all there again.
    pub fn simulation(&self) -> &Simulation {
        &self.simulation
    }

    /// Why a point holds its value, or what contradicts that.
    pub fn why(&mut self, point: &Point) -> Judged {
        let mut asked = HashSet::new();
        let mut powers = Vec::new();
        let judged = self.judge(point, DEEPEST, &mut asked, &mut powers);
        // What is shown is the turn that is told.
        for (network, powers) in powers {
            let slots = self.writers.slots(&self.simulation, network);
            for (slot, power) in slots.into_iter().zip(&powers) {
                if slot != Bit::LOW && slot != Bit::HIGH {
                    self.simulation.machine.memory.set_bit(slot, *power);
                }
            }
        }
        judged
    }

    /// The powers are those of the networks that may write the point, as far as it is the first that is asked about.
    fn judge(
        &mut self,
        point: &Point,
        depth: usize,
        asked: &mut HashSet<String>,
        powers: &mut Vec<(usize, Vec<bool>)>,
    ) -> Judged {
        asked.insert(point.name.clone());
        let blocks = self.writers.of_point(&self.simulation, point);
        let found = self.see(point, &blocks);
        let program = self.simulation.program().clone();
        let mut judgements = Vec::with_capacity(found.len());
        let (mut read, mut missing): (Vec<Point>, Vec<Point>) = (Vec::new(), Vec::new());
        let mut overwritten: Vec<Point> = Vec::new();
        let mut is_handed_over = false;
        for (traced, writes, leaves) in found {
            is_handed_over = traced.is_handed_over;
            let network = &program.networks[traced.at.network];
            let later = |point: &Point| self.is_given(point) && self.is_written_after(point, traced.at);
            for (all, found) in [
                (
                    &mut missing,
                    open_values(network, &traced, |point| !self.is_given(point)),
                ),
                (&mut overwritten, open_values(network, &traced, later)),
            ] {
                for point in found {
                    if !all.contains(&point) {
                        all.push(point);
                    }
                }
            }
            let write = write_of(network, &traced, point);
            if depth == DEEPEST {
                powers.push((traced.at.network, traced.powers.clone()));
            }
            let reasons = write.reasons.iter().flatten().flat_map(|reason| &reason.values);
            for (point, _) in reasons.chain(&write.read) {
                if !point.is_constant() && !point.is_system() && !read.contains(point) {
                    read.push(point.clone());
                }
            }
            judgements.push(Judgement {
                write,
                writes,
                leaves,
                network: traced.at.network,
            });
        }
        let value = self.simulation.value(point);
        let mut because = Vec::new();
        read.retain(|point| depth > 0 && asked.len() < MOST_ASKED && asked.insert(point.name.clone()));
        for point in read {
            because.push(self.judge(&point, depth - 1, asked, powers));
        }
        missing.retain(|needed| !self.handed_over.contains(&needed.name));
        if is_handed_over && missing.is_empty() {
            self.handed_over.insert(point.name.clone());
        }
        // Of what no block of its body writes, the call of a block is not a writer.
        let is_call = |at: &&BlockAt| {
            let block = &program.networks[at.network].blocks[at.block];
            matches!(block.kind, BlockKind::User(_))
        };
        let is_writer = |at: &&BlockAt| !judgements.is_empty() || !is_call(at);
        let writers = blocks.iter().filter(is_writer).count();
        Judged {
            is_given: self.is_given(point),
            point: point.clone(),
            value,
            judgements,
            writers,
            missing,
            overwritten,
            because,
        }
    }

    /// Those that a scan runs, by itself or in functions.
    pub(super) fn networks_outside_of_bodies(&self) -> impl Iterator<Item = usize> + '_ {
        self.starts.values().copied()
    }

    /// Whether its value was given, or that of the number that it is a bit of.
    pub(crate) fn is_given(&self, point: &Point) -> bool {
        let number = point.bit_of().map(|(number, _)| number);
        self.names.contains(&point.name) || number.is_some_and(|number| self.names.contains(number))
    }

    /// Whether a block that runs after another one in the scan, or is that, may write a point. Between the main networks and
    /// functions there is no order.
    fn is_written_after(&self, point: &Point, at: BlockAt) -> bool {
        let main = &self.simulation.program().main;
        let writers = self.writers.of_point(&self.simulation, point);
        writers.iter().any(|writer| {
            main.contains(&writer.network) != main.contains(&at.network)
                || (writer.network, writer.block) >= (at.network, at.block)
        })
    }

    /// Runs the scan.
    fn see_all(&mut self) {
        if let Some(any) = self.simulation.points().first().cloned() {
            self.see(&any, &[]);
        }
    }

    /// The values that contradict the program, in the order in which they were given, up to so many: each with the network that
    /// is the last to write it.
    pub fn contradictions(&mut self, most: usize) -> Vec<(Point, usize)> {
        let mut others = std::mem::take(&mut self.others);
        others.sort_unstable();
        others.retain(|(value, network)| {
            let writers = self.writers.of_point(&self.simulation, &self.given[*value].0);
            writers.last().is_some_and(|last| last.network == *network)
        });
        let mut found = Vec::new();
        for (value, network) in others {
            if found.len() == most {
                break;
            }
            let point = self.given[value].0.clone();
            let judged = self.judge(&point, 0, &mut HashSet::new(), &mut Vec::new());
            if judged.contradiction().is_some() {
                found.push((point, network));
            }
        }
        found
    }

    /// Runs the scan; what each of these blocks does to a point, in their order.
    fn see(&mut self, point: &Point, blocks: &[BlockAt]) -> Vec<(Traced, bool, Value)> {
        let Moment {
            simulation,
            writers,
            given,
            timers,
            written,
            inside,
            starts,
            goes_on,
            parameters,
            others,
            settled,
            ..
        } = self;
        simulation.restore(settled);
        simulation.machine.faults.clear();
        others.clear();
        let put_all = |simulation: &mut Simulation, but: &HashSet<usize>| {
            let all = given.iter().enumerate();
            for (_, (point, value)) in all.filter(|(index, _)| !but.contains(index)) {
                simulation.write(point, value);
            }
            let now = simulation.time();
            for &(timer, state) in timers.iter() {
                timer.follow_members(&mut simulation.machine.memory, state, now);
            }
        };
        put_all(simulation, &HashSet::new());
        let asked: HashSet<usize> = blocks.iter().map(|at| at.network).collect();
        let also: Vec<u32> = starts.keys().copied().collect();
        let mut last: Option<usize> = None;
        let mut compare = |simulation: &Simulation, network: usize| {
            let own = written.get(&network).filter(|_| !goes_on[network]);
            let differs = |index: &&usize| simulation.value(&given[**index].0) != given[**index].1;
            let differs = own.into_iter().flatten().filter(differs);
            others.extend(differs.map(|&index| (index, network)));
        };
        let mut halted = |simulation: &mut Simulation, pc: u32| {
            let Some(&network) = starts.get(&pc) else { return };
            let before = last.replace(network);
            if let Some(before) = before {
                compare(simulation, before);
            }
            if goes_on[network] {
                return;
            }
            if asked.contains(&network) || before.is_some_and(|before| goes_on[before]) {
                put_all(simulation, parameters);
            } else if let Some(last) = before {
                let calls = simulation.program().networks[last].blocks.iter();
                let has_body = calls
                    .into_iter()
                    .any(|block| matches!(block.kind, BlockKind::User(_)));
                let own = written.get(&last).into_iter().flatten();
                let own = own.chain(inside.iter().filter(|_| has_body));
                for &index in own.filter(|index| !parameters.contains(index)) {
                    let (point, value) = &given[index];
                    simulation.write(point, value);
                }
            }
        };
        let mut found: Vec<(Traced, bool, Value)> = Vec::new();
        let mut note = |simulation: &Simulation, traced: Traced, writes: bool| {
            // Of several turns the last that writes the tag is told.
            let earlier = found.iter().position(|(other, ..)| other.at == traced.at);
            if let Some(earlier) = earlier {
                if found[earlier].1 && !writes {
                    return;
                }
                found.remove(earlier);
            }
            let leaves = simulation.value(point);
            found.push((traced, writes, leaves));
        };
        trace::all_writes(
            simulation,
            writers,
            (blocks, point),
            &also,
            &mut halted,
            &mut note,
        );
        if let Some(last) = last {
            compare(simulation, last);
        }
        put_all(simulation, &HashSet::new());
        found
    }
}

/// What may decide what a block does, of that which is open: all but constants and what the system keeps may be.
fn open_values(network: &Network, traced: &Traced, is_open: impl Fn(&Point) -> bool) -> Vec<Point> {
    let is_open = |(point, _): &&(Point, Value)| !point.is_constant() && !point.is_system() && is_open(point);
    let of_block = |block: &usize| traced.values.get(block).into_iter().flatten().filter(is_open);
    let mut blocks: Vec<usize> = traced.values.keys().copied().collect();
    blocks.sort_unstable();
    blocks.retain(|block| of_block(block).next().is_some());
    if is_certain(network, traced, &blocks) {
        blocks.retain(|block| *block == traced.at.block && traced.power);
    }
    let points = blocks.iter().flat_map(of_block).map(|(point, _)| point.clone());
    points.collect()
}

/// Of each network whether it runs with what those before it have left: in a loop, and in functions that several blocks
/// call, or that are called there.
fn networks_that_go_on(program: &Program) -> Vec<bool> {
    let mut goes_on = vec![false; program.networks.len()];
    let functions = program.functions.iter().map(|function| function.networks.clone());
    for routine in std::iter::once(program.main.clone()).chain(functions.clone()) {
        let mut loops = 0usize;
        for network in routine {
            goes_on[network] = loops > 0;
            for block in &program.networks[network].blocks {
                match block.kind {
                    BlockKind::Instruction(row) if row.op == Op::For => loops += 1,
                    BlockKind::Instruction(row) if row.op == Op::Next => loops = loops.saturating_sub(1),
                    _ => {}
                }
            }
        }
    }
    loop {
        let mut calls = vec![0; program.functions.len()];
        for (network, goes_on) in program.networks.iter().zip(&goes_on) {
            for function in network.blocks.iter().flat_map(called_by) {
                calls[function] += if *goes_on { 2 } else { 1 };
            }
        }
        let mut is_new = false;
        for (networks, _) in functions.clone().zip(calls).filter(|(_, calls)| *calls > 1) {
            is_new |= goes_on[networks.clone()].contains(&false);
            goes_on[networks].fill(true);
        }
        if !is_new {
            return goes_on;
        }
    }
}

/// The names of what is read in functions which several blocks call.
fn read_in_shared_functions(simulation: &Simulation, goes_on: &[bool]) -> HashSet<String> {
    let program = simulation.program();
    let functions = program.functions.iter();
    let networks = functions.flat_map(|function| function.networks.clone());
    let networks = networks.filter(|network| goes_on[*network]);
    let blocks = networks.flat_map(|network| &program.networks[network].blocks);
    let scope = Scope::default();
    let read = |block: &Block| {
        let mut read = place::values_read(simulation, &scope, block);
        for bound in &block.arguments {
            read.extend(place::index_values(simulation, &scope, &bound.argument));
        }
        read
    };
    blocks.flat_map(read).map(|(point, _)| point.name).collect()
}

/// Whether power comes to a block, or does not, whatever the blocks do of which not all values are known.
fn is_certain(network: &Network, traced: &Traced, open: &[usize]) -> bool {
    let is_open = |block: usize, _| open.contains(&block);
    let conducts = |block: usize| traced.conducts.get(&block).copied();
    known(network, &traced.powers, &is_open, &conducts)[traced.en].is_some()
}

fn write_of(network: &Network, traced: &Traced, point: &Point) -> Write {
    let of_block = |block: usize| traced.values.get(&block).cloned().unwrap_or_default();
    let reason = |blocker: &Blocker| match *blocker {
        Blocker::Rail => Reason {
            block: network.location,
            is_rail: true,
            values: Vec::new(),
            because: Vec::new(),
        },
        Blocker::Block(block) => Reason {
            block: network.blocks[block].location,
            is_rail: false,
            values: reasons::deciding(network, block, &traced.powers)
                .into_iter()
                .flat_map(of_block)
                .collect(),
            because: Vec::new(),
        },
    };
    let ways = traced.ways(network);
    let mut read = traced.read.clone();
    read.retain(|(read, _)| traced.power && read.name != point.name);
    Write {
        scan: 0,
        block: network.blocks[traced.at.block].location,
        called: traced.called,
        power: traced.power,
        reasons: ways.iter().map(|way| way.iter().map(reason).collect()).collect(),
        indices: traced.indices.clone(),
        read,
        because: Vec::new(),
    }
}

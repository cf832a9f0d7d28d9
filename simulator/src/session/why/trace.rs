//! One scan again: the last write of a tag, and the powers around it. The scan runs through but for the networks that
//! may write the tag, with the bodies that run there: it halts in front of each of their blocks and after it.

use super::place;
use super::reasons::{self, Blocker};
use super::target::{Aim, Target, Written};
use super::writers::Writers;
use crate::code::{Code, stop};
use crate::machine::Until;
use crate::memory::Bit;
use crate::places::BlockAt;
use crate::simulation::{Routine, Scope, Simulation, Stepped};
use crate::tags::Point;
use ladder_analysis::program::{BlockKind, Location, Network, Step};
use ladder_analysis::values::value::Value;
use ladder_instructions::{Acts, Coil, Group, Op, Power};
use std::collections::HashMap;

/// How far a scan is run again.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Limit {
    /// To its end.
    End,
    /// Up to where a scan was: the instruction that came next, and how many blocks it might still evaluate, which tells
    /// the rounds of a loop apart.
    Position { pc: u32, budget: u64 },
}

impl Limit {
    /// Where a simulation is in its scan.
    pub(super) fn of(simulation: &Simulation) -> Limit {
        let open = simulation.machine.open_scan();
        Limit::Position {
            pc: open.pc(),
            budget: open.budget(),
        }
    }
}

/// A write that was found.
#[derive(Debug)]
pub(super) struct Traced {
    pub(super) at: BlockAt,
    /// The step that is its EN, and whether that was high.
    pub(super) en: usize,
    pub(super) power: bool,
    /// The power of each step of the network.
    pub(super) powers: Vec<bool>,
    /// Of each contact whether it would pass power on.
    pub(super) conducts: HashMap<usize, bool>,
    /// What blocks of the network read, with the values that they left behind.
    pub(super) values: HashMap<usize, Vec<(Point, Value)>>,
    /// Where the scan was after them.
    pub(super) positions: HashMap<usize, Limit>,
    /// What the block made its result of.
    pub(super) read: Vec<(Point, Value)>,
    /// What the indices were of what it wrote: they tell the turns of a loop apart.
    pub(super) indices: Vec<(Point, Value)>,
    /// The block through which the function was called, where several call it.
    pub(super) called: Option<Location>,
    /// Whether the block has handed the point over to its body, as an input.
    pub(super) is_handed_over: bool,
}

impl Traced {
    /// With power the blocks that it came through; without it what is missing, in each way.
    pub(super) fn ways(&self, network: &Network) -> Vec<Vec<Blocker>> {
        if self.power {
            vec![reasons::passed(network, self.en, &self.powers)]
        } else {
            reasons::missing(network, self.en, &self.powers, &self.conducts)
        }
    }
}

/// Runs the scan at whose start a simulation is, up to a limit; the last write of the point in it.
pub(super) fn last_write(
    simulation: &mut Simulation,
    writers: &Writers,
    blocks: &[BlockAt],
    point: &Point,
    limit: Limit,
) -> Option<Traced> {
    let mut last = None;
    let found = &mut |_: &Simulation, traced, has_written| {
        if has_written {
            last = Some(traced);
        }
    };
    let halts = Halts::of(simulation, writers, blocks, limit);
    let asked = Asked {
        writers,
        blocks,
        point,
        limit,
    };
    run(simulation, halts, &asked, &mut |_, _| {}, found);
    last
}

/// Runs a whole scan, with a halt at these instructions as well; every block that may write the point, and whether it did.
pub(super) fn all_writes(
    simulation: &mut Simulation,
    writers: &Writers,
    (blocks, point): (&[BlockAt], &Point),
    also: &[u32],
    halted: &mut dyn FnMut(&mut Simulation, u32),
    found: &mut dyn FnMut(&Simulation, Traced, bool),
) {
    let mut halts = Halts::of(simulation, writers, blocks, Limit::End);
    halts.all.extend(also);
    let asked = Asked {
        writers,
        blocks,
        point,
        limit: Limit::End,
    };
    run(simulation, halts, &asked, halted, found);
}

/// Whose writes are looked for in a scan, and how far.
struct Asked<'a> {
    writers: &'a Writers,
    blocks: &'a [BlockAt],
    point: &'a Point,
    limit: Limit,
}

/// A block that runs.
struct Open {
    at: BlockAt,
    /// Its code.
    start: u32,
    end: u32,
    /// Which of the places it is where its network is, and how many functions were called.
    run: (usize, usize),
    depth: usize,
    scope: Scope,
    /// The names in its body.
    inside: Option<Scope>,
    target: Target,
    /// What the point in question held, if the block may write it.
    before: Option<Value>,
    called: Option<Location>,
    body: Body,
}

/// How far the body of a block has come.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Body {
    /// It has not begun, or there is none.
    Ahead,
    /// Its inputs are handed over.
    Runs,
    /// One of its blocks has written the point in question.
    Wrote,
}

fn run(
    simulation: &mut Simulation,
    mut halts: Halts,
    asked: &Asked<'_>,
    halted: &mut dyn FnMut(&mut Simulation, u32),
    found: &mut dyn FnMut(&Simulation, Traced, bool),
) {
    halts.mark(&mut simulation.compiled.code, true);
    let mut open: Vec<Open> = Vec::new();
    let mut seen = Seen {
        outs: std::mem::take(&mut halts.outs),
        ..Seen::default()
    };
    simulation.begin_scan();
    while Limit::of(simulation) != asked.limit {
        let stepped = simulation.step(Until::Marked);
        let is_halted = matches!(stepped, Stepped::At(_));
        let position = if is_halted {
            Limit::of(simulation)
        } else {
            Limit::End
        };
        let pc = simulation.machine.open_scan().pc();
        let depth = simulation.machine.open_scan().activations().count();
        while let Some(ran) = open.pop_if(|open| {
            let is_in = depth > open.depth || (depth == open.depth && open.start < pc && pc < open.end);
            !is_halted || !is_in
        }) {
            seen.look_after(simulation, &ran, position);
            let Some((traced, has_written)) = seen.written(simulation, asked, &ran) else {
                continue;
            };
            if has_written {
                for around in &mut open {
                    around.body = Body::Wrote;
                }
            }
            found(simulation, traced, has_written);
        }
        if !is_halted {
            break;
        }
        for began in open.iter_mut().filter(|open| open.body == Body::Ahead) {
            if let Some(traced) = seen.handed_over(simulation, asked, (began, position)) {
                found(simulation, traced, true);
            }
            began.body = Body::Runs;
        }
        halted(simulation, pc);
        for &(at, end) in halts.blocks.get(&pc).into_iter().flatten() {
            let mut around = open
                .iter()
                .rev()
                .filter(|open| open.start <= pc && end <= open.end);
            let scope = around.find_map(|open| open.inside.as_ref());
            let scope = scope.cloned().unwrap_or_default();
            let next = seen.look_before(simulation, asked, (at, pc..end), (scope, depth));
            open.push(next);
        }
    }
    halts.mark(&mut simulation.compiled.code, false);
}

/// Where the scan halts.
struct Halts {
    /// The first instruction of each block of the networks in question, and of the bodies that run there: those of one
    /// instruction from the outside in, each with its end.
    blocks: HashMap<u32, Vec<(BlockAt, u32)>>,
    /// The powers that leave the blocks of a network, in each place where it is.
    outs: HashMap<(usize, usize), HashMap<usize, Bit>>,
    /// All instructions to halt at.
    all: Vec<u32>,
}

impl Halts {
    fn of(simulation: &Simulation, writers: &Writers, asked: &[BlockAt], limit: Limit) -> Halts {
        let compiled = &simulation.compiled;
        let mut halts = Halts {
            blocks: HashMap::new(),
            outs: HashMap::new(),
            all: Vec::new(),
        };
        if let Limit::Position { pc, .. } = limit {
            halts.all.push(pc);
        }
        let mut networks: Vec<usize> = asked.iter().map(|at| at.network).collect();
        networks.dedup();
        for network in networks {
            let stretch = &compiled.stretches[network];
            let first = compiled
                .code
                .blocks
                .partition_point(|place| place.start < stretch.start);
            let mut body_end = 0;
            for place in &compiled.code.blocks[first..] {
                if place.start >= stretch.end {
                    break;
                }
                let Some(at) = simulation.block_at(place.location) else {
                    continue;
                };
                // Of bodies only those matter that may write the tag.
                if at.network == network {
                    body_end = if asked.contains(&at) { place.end } else { 0 };
                } else if place.start >= body_end {
                    continue;
                }
                let run = (at.network, writers.place_at(at.network, place.start));
                halts.outs.entry(run).or_default().insert(at.block, place.out);
                if place.start == place.end {
                    continue;
                }
                halts.blocks.entry(place.start).or_default().push((at, place.end));
                halts.all.extend([place.start, place.end]);
            }
        }
        halts
    }

    fn mark(&self, code: &mut Code, on: bool) {
        for &pc in &self.all {
            // The last block of a program has nothing after it.
            if let Some(stops) = code.stops.get_mut(pc as usize) {
                *stops = if on {
                    *stops | stop::MARK
                } else {
                    *stops & !stop::MARK
                };
            }
        }
    }
}

/// What was seen of the networks with writers, in each place where they are.
#[derive(Default)]
struct Seen {
    networks: HashMap<(usize, usize), SeenNetwork>,
    outs: HashMap<(usize, usize), HashMap<usize, Bit>>,
}

#[derive(Default)]
struct SeenNetwork {
    conducts: HashMap<usize, bool>,
    values: HashMap<usize, Vec<(Point, Value)>>,
    positions: HashMap<usize, Limit>,
}

impl Seen {
    /// A block that is about to run reads its operands.
    fn look_before(
        &mut self,
        simulation: &Simulation,
        asked: &Asked<'_>,
        (at, code): (BlockAt, std::ops::Range<u32>),
        (scope, depth): (Scope, usize),
    ) -> Open {
        let run = (at.network, asked.writers.place_at(at.network, code.start));
        let seen = self.networks.entry(run).or_default();
        let this = &simulation.program().networks[at.network].blocks[at.block];
        let values = place::values_read(simulation, &scope, this);
        if let BlockKind::Instruction(row) = this.kind {
            let value = match values.as_slice() {
                [(_, Value::Bool(high))] => Some(*high),
                _ => None,
            };
            match (row.power, value) {
                (Power::Level { high: wanted }, Some(high)) => seen.conducts.insert(at.block, high == wanted),
                _ if row.group == Group::State => seen.conducts.insert(at.block, false),
                _ => seen.conducts.remove(&at.block),
            };
        }
        seen.values.insert(at.block, values);
        let is_inside = scope.is_of_body();
        let may_write = is_inside || asked.blocks.contains(&at);
        let inside = matches!(this.kind, BlockKind::User(_)).then(|| scope.inside(simulation, at));
        let (target, before, called) = if may_write {
            (
                Target::of(simulation, (&scope, inside.as_ref()), this),
                Some(simulation.value(asked.point)),
                called_through(simulation, asked.writers),
            )
        } else {
            (Target::default(), None, None)
        };
        Open {
            at,
            start: code.start,
            end: code.end,
            run,
            depth,
            scope,
            inside,
            target,
            before,
            called,
            body: Body::Ahead,
        }
    }

    /// A block has run: what it read is told as it is now, since a timer passes power on for what it has come to, not
    /// for what it was. Which element of an array it was has been settled before: the block may write the index too.
    fn look_after(&mut self, simulation: &Simulation, ran: &Open, position: Limit) {
        let seen = self.networks.entry(ran.run).or_default();
        for (point, value) in seen.values.entry(ran.at.block).or_default() {
            *value = simulation.value(point);
        }
        seen.positions.insert(ran.at.block, position);
    }

    /// A block whose body begins, if the point is one of the inputs that it has handed over.
    fn handed_over(
        &mut self,
        simulation: &Simulation,
        asked: &Asked<'_>,
        (began, position): (&Open, Limit),
    ) -> Option<Traced> {
        began.before.as_ref()?;
        let aim = began.target.at(simulation, asked.point)?;
        let seen = self.networks.entry(began.run).or_default();
        seen.positions.insert(began.at.block, position);
        (aim.moment == Written::BeforeBody).then(|| self.traced(simulation, asked.writers, began, Some(aim)))
    }

    /// A block that may write the point has run, and whether it has written it. None: it is for its body to have done so,
    /// or it has nothing to do with the point.
    fn written(&mut self, simulation: &Simulation, asked: &Asked<'_>, ran: &Open) -> Option<(Traced, bool)> {
        let before = ran.before.as_ref()?;
        let block = &simulation.program().networks[ran.at.network].blocks[ran.at.block];
        let aim = ran.target.at(simulation, asked.point);
        let is_of_body = match &aim {
            Some(aim) => aim.moment == Written::BeforeBody && ran.body != Body::Ahead,
            None => ran.body == Body::Wrote,
        };
        let has_changed = simulation.value(asked.point) != *before;
        let is_for_body = match block.kind {
            BlockKind::User(user) => simulation.program().blocks[user].unread.is_none(),
            BlockKind::Instruction(_) => ran.scope.is_of_body(),
        };
        if is_of_body || (is_for_body && aim.is_none() && !has_changed) {
            return None;
        }
        let is_aim = aim.is_some();
        let traced = self.traced(simulation, asked.writers, ran, aim);
        let acts = match block.kind {
            BlockKind::User(_) => true,
            BlockKind::Instruction(row) => match row.coil {
                Some(Coil::Sets | Coil::Resets) => traced.power,
                _ if row.op == Op::Res => traced.power,
                _ => row.acts == Acts::Always || traced.power,
            },
        };
        Some((traced, has_changed || (acts && is_aim)))
    }

    /// The power of each step of a network. What is drawn of a body is drawn for its first place; in the others the blocks know
    /// what leaves them.
    fn powers(&self, simulation: &Simulation, writers: &Writers, run: (usize, usize)) -> Vec<bool> {
        let bit = |slot: Bit| simulation.machine.memory.bit(slot);
        let (network, place) = run;
        if place == 0 {
            let slots = writers.slots(simulation, network).into_iter();
            return slots.map(bit).collect();
        }
        let outs = self.outs.get(&run);
        let mut powers: Vec<bool> = Vec::new();
        for step in &simulation.program().networks[network].steps {
            powers.push(match *step {
                Step::Start { rail } => rail,
                Step::Join { upper, lower } => powers[upper] || powers[lower],
                Step::Block { block, en } => outs
                    .and_then(|outs| outs.get(&block))
                    .map_or(powers[en], |&out| bit(out)),
            });
        }
        powers
    }

    /// A block, with the powers of its network.
    fn traced(
        &mut self,
        simulation: &Simulation,
        writers: &Writers,
        open: &Open,
        aim: Option<Aim>,
    ) -> Traced {
        let network = &simulation.program().networks[open.at.network];
        let powers = self.powers(simulation, writers, open.run);
        let seen = self.networks.entry(open.run).or_default();
        let en = en_of(network, open.at.block).unwrap_or_default();
        let operands = || seen.values.get(&open.at.block).cloned().unwrap_or_default();
        let is_handed_over = aim.as_ref().is_some_and(|aim| aim.moment == Written::BeforeBody);
        let (read, mut indices) = aim.map_or((None, Vec::new()), |aim| (aim.read, aim.indices));
        indices.retain(|(index, _)| !index.is_constant());
        Traced {
            at: open.at,
            en,
            power: powers.get(en).copied().unwrap_or_default(),
            powers,
            conducts: seen.conducts.clone(),
            read: read.unwrap_or_else(operands),
            values: seen.values.clone(),
            positions: seen.positions.clone(),
            indices,
            called: open.called,
            is_handed_over,
        }
    }
}

/// The block through which the function was called that runs, if several call it.
fn called_through(simulation: &Simulation, writers: &Writers) -> Option<Location> {
    let activations = simulation.activations();
    let at = activations.iter().position(|activation| {
        matches!(activation.routine, Routine::Function(function) if writers.is_called_from_several(function))
    })?;
    activations.get(at + 1).map(|caller| caller.location)
}

/// The step whose power is a block's EN.
pub(super) fn en_of(network: &Network, block: usize) -> Option<usize> {
    network.steps.iter().find_map(|step| match *step {
        Step::Block { block: this, en } if this == block => Some(en),
        _ => None,
    })
}

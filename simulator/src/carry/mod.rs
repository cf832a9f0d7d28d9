//! A change of the running program: the new program goes on from where the old one was.
//!
//! Tags keep their values by name and type, timers and counters with all that they remember; a tag that has another name at
//! all of its places is the same one. Edges and whatever else
//! belongs to a block's place in the text go where that block went. The clock goes on. A change that leaves the code as it
//! was (of comments, of the layout) is none: only places in the text are other ones.

mod counterparts;
mod matching;
mod renamed;
mod signature;
mod tags;

use crate::memory::{Bit, Word};
use crate::places::{BlockAt, Cell};
use crate::simulation::{Simulation, Status};
use crate::tags::Point;
pub use counterparts::counterparts;
use ladder_analysis::program::{BlockKind, Location};
use ladder_analysis::values::value::Value;
use ladder_instructions::{Instruction, Op};
use matching::Matching;
pub(crate) use renamed::Names;
use renamed::Renamed;
use std::borrow::Cow;
use std::collections::{HashMap, HashSet};

/// What a change of the running program came to.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Changeover {
    /// The program does what it did; nothing has happened.
    None,
    /// It does something else from the next scan on.
    Carried {
        /// What could not be kept.
        lost: Vec<Lost>,
    },
}

/// Something of the old program that the new one could not go on with.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Lost {
    /// What it is, and what happens instead.
    pub message: String,
    /// The place in the new program, if it has one.
    pub location: Option<Location>,
}

/// Whether two programs are the same but for their places in the text.
pub(crate) fn is_same(old: &Simulation, new: &Simulation) -> bool {
    let mut names = old.program.tags.iter().zip(&new.program.tags);
    does_the_same(old, new)
        && old.compiled.retained == new.compiled.retained
        && names.all(|(was, is)| was.name == is.name)
        && old.program.other_names == new.program.other_names
}

/// Whether two programs are the same but for their places in the text and the names of their tags.
fn does_the_same(old: &Simulation, new: &Simulation) -> bool {
    let (was, is) = (&old.compiled, &new.compiled);
    let same_tags = || {
        let tags = old.program.tags.iter().zip(&new.program.tags);
        old.program.tags.len() == new.program.tags.len()
            && tags.clone().all(|(was, is)| {
                (
                    was.ty,
                    (was.role, was.is_input),
                    was.retain,
                    was.constant,
                    &was.address,
                    was.block,
                    &was.column,
                ) == (
                    is.ty,
                    (is.role, is.is_input),
                    is.retain,
                    is.constant,
                    &is.address,
                    is.block,
                    &is.column,
                )
            })
    };
    old.program.networks.len() == new.program.networks.len()
        && was.code.instrs == is.code.instrs
        && was.code.operands == is.code.operands
        && was.code.arrays == is.code.arrays
        && was.code.networks == is.code.networks
        && was.code.saved == is.code.saved
        && was.code.relays == is.code.relays
        && was.fused.code.instrs == is.fused.code.instrs
        && was.fused.code.records == is.fused.code.records
        && was.fused.code.operands == is.fused.code.operands
        && was.initial == is.initial
        && was.homes == is.homes
        && was.retained.len() == is.retained.len()
        && was
            .retained
            .iter()
            .zip(&is.retained)
            .all(|(was, is)| was.lives_as(is))
        && was.places.remembered == is.places.remembered
        && was.elements.len() == is.elements.len()
        && same_tags()
}

/// Lets a program that has not run yet go on where another is, between two scans.
pub(crate) fn carry(old: &Simulation, new: &mut Simulation) -> (Vec<Lost>, Moved) {
    let renamed = Renamed::of(old, new);
    let matching = Matching::of(&old.program, &new.program, &renamed);
    let mut lost = Vec::new();
    engine(old, new);
    tags::carry(old, new, &matching, &renamed, &mut lost);
    places(old, new, &matching, &mut lost);
    ports(old, new);
    powers(old, new, &matching);
    forces(old, new, &renamed, &mut lost);
    (lost, Moved::of(old, new, &matching, renamed))
}

/// Where parts of a program are in a later form of it.
pub(crate) fn moved(old: &Simulation, new: &Simulation) -> Moved {
    let renamed = Renamed::of(old, new);
    let matching = Matching::of(&old.program, &new.program, &renamed);
    Moved::of(old, new, &matching, renamed)
}

/// Where parts of the old program are in the new one.
#[derive(Debug, Default)]
pub(crate) struct Moved {
    blocks: HashMap<Location, Location>,
    networks: HashMap<usize, usize>,
    renamed: Renamed,
}

impl Moved {
    fn of(old: &Simulation, new: &Simulation, matching: &Matching, renamed: Renamed) -> Moved {
        let mut moved = Moved {
            renamed,
            ..Moved::default()
        };
        for (number, network) in new.program.networks.iter().enumerate() {
            if let Some(was) = matching.networks[number] {
                moved.networks.insert(was, number);
            }
            for (block, is) in network.blocks.iter().enumerate() {
                let at = BlockAt {
                    network: number,
                    block,
                };
                if let Some(was) = matching.block(at) {
                    let was = &old.program.networks[was.network].blocks[was.block];
                    moved.blocks.insert(was.location, is.location);
                }
            }
        }
        moved
    }

    /// Where a block went.
    pub(crate) fn block(&self, was: Location) -> Option<Location> {
        self.blocks.get(&was).copied()
    }

    /// What a tag, or a part of one, is called now.
    pub(crate) fn name<'n>(&self, was: &'n str) -> Cow<'n, str> {
        self.renamed.name_now(was)
    }

    /// The tag that has another name now.
    pub(crate) fn renamed(&self) -> Option<&Names> {
        self.renamed.names.as_ref()
    }

    /// What number a network has now.
    pub(crate) fn network(&self, was: usize) -> Option<usize> {
        self.networks.get(&was).copied()
    }
}

/// The clock, and what the engine keeps for itself.
fn engine(old: &Simulation, new: &mut Simulation) {
    let (was, is) = (&old.machine, &mut new.machine);
    (is.now, is.scan, is.faulted, is.worked) = (was.now, was.scan, was.faulted, was.worked);
    is.cancel.clone_from(&was.cancel);
    is.memory.bits[..Bit::RESERVED].copy_from_slice(&was.memory.bits[..Bit::RESERVED]);
    is.memory.words[..Word::RESERVED].copy_from_slice(&was.memory.words[..Word::RESERVED]);
    // What hung or went wrong may be fixed; a program that came to its end has come to its end.
    new.status = match old.status {
        Status::Ended => Status::Ended,
        Status::Ready | Status::Faulted => Status::Ready,
    };
}

/// What blocks remember at their places: the cells that are the same ones, and the blocks of the new program without such cells.
fn paired_places(
    old: &Simulation,
    new: &Simulation,
    matching: &Matching,
) -> (Vec<(Cell, Cell)>, Vec<Option<BlockAt>>) {
    let mut was: HashMap<_, Vec<Cell>> = HashMap::new();
    for remembered in &old.compiled.places.remembered {
        was.entry(&remembered.path).or_default().push(remembered.cell);
    }
    let mut counts: HashMap<_, usize> = HashMap::new();
    let mut found: Vec<(Cell, Cell)> = Vec::new();
    let mut again = Vec::new();
    for remembered in &new.compiled.places.remembered {
        let nth = counts.entry(&remembered.path).or_default();
        let path = matching.path(&remembered.path);
        let cell = path.as_ref().and_then(|path| was.get(path)?.get(*nth).copied());
        *nth += 1;
        match cell {
            Some(cell) => found.push((cell, remembered.cell)),
            None => again.push(remembered.path.last().copied()),
        }
    }
    (found, again)
}

/// Copies what blocks remember at their places.
fn places(old: &Simulation, new: &mut Simulation, matching: &Matching, lost: &mut Vec<Lost>) {
    let (found, mut again) = paired_places(old, new, matching);
    // Only where a block of this kind was taken away something is lost; any other is a new one.
    let mut removed = removed_ops(old, new, matching);
    again.dedup();
    for at in again.into_iter().flatten() {
        let block = &new.program.networks[at.network].blocks[at.block];
        let BlockKind::Instruction(row) = block.kind else {
            continue;
        };
        if let Some(place) = removed.iter().position(|op| *op == row.op) {
            removed.swap_remove(place);
            lost.push(Lost {
                message: format!(
                    "{} is not the one that was there before: it forgets what it saw last",
                    drawn(row)
                ),
                location: Some(block.location),
            });
        }
    }
    let memory = &mut new.machine.memory;
    for pair in found {
        match pair {
            (Cell::Bit(was), Cell::Bit(is)) => {
                memory.bits[is.0 as usize] = old.machine.memory.bits[was.0 as usize];
            }
            (Cell::Word(was), Cell::Word(is)) => {
                memory.words[is.0 as usize] = old.machine.memory.words[was.0 as usize];
            }
            _ => {}
        }
    }
    if let (Some(was), Some(is)) = (old.compiled.places.line_free, new.compiled.places.line_free) {
        memory.words[is.0 as usize] = old.machine.memory.word(was);
    }
}

/// An instruction as it is drawn, without operands.
fn drawn(row: &Instruction) -> String {
    let (open, close) = row.shape.brackets();
    format!("{open}{}{close}", row.mnemonic)
}

/// The blocks that remembered something, and are no more.
fn removed_ops(old: &Simulation, new: &Simulation, matching: &Matching) -> Vec<Op> {
    let mut kept = HashSet::new();
    for (network, it) in new.program.networks.iter().enumerate() {
        let blocks = 0..it.blocks.len();
        kept.extend(blocks.filter_map(|block| matching.block(BlockAt { network, block })));
    }
    let remembered = old.compiled.places.remembered.iter();
    let mut places: Vec<_> = remembered.filter_map(|it| it.path.last().copied()).collect();
    places.dedup();
    places
        .into_iter()
        .filter(|at| !kept.contains(at))
        .filter_map(
            |at| match old.program.networks[at.network].blocks[at.block].kind {
                BlockKind::Instruction(row) => Some(row.op),
                BlockKind::User(_) => None,
            },
        )
        .collect()
}

/// Channels and the serial port.
fn ports(old: &Simulation, new: &mut Simulation) {
    let (was, is) = (old.compiled.ports, new.compiled.ports);
    let channels = crate::compile::CHANNELS as usize;
    let arrays = [
        (was.analog, is.analog, channels),
        (was.pulse, is.pulse, 2 * channels),
    ];
    for (was, is, count) in arrays {
        if let (Some(was), Some(is)) = (was, is) {
            let (was, is) = (was.0 as usize, is.0 as usize);
            new.machine.memory.words[is..is + count]
                .copy_from_slice(&old.machine.memory.words[was..was + count]);
        }
    }
    new.machine
        .memory
        .received
        .clone_from(&old.machine.memory.received);
}

/// The power that is shown until the next scan, where networks stayed what they were.
fn powers(old: &Simulation, new: &mut Simulation, matching: &Matching) {
    let mut was: HashMap<(usize, u32), Bit> = HashMap::new();
    for element in &old.compiled.elements {
        was.insert((element.network as usize, element.step), element.power);
    }
    for element in &new.compiled.elements {
        let network = element.network as usize;
        let Some(before) = matching.networks[network] else {
            continue;
        };
        let is_own = element.power.0 as usize >= Bit::RESERVED;
        if let Some(&power) = was.get(&(before, element.step))
            && is_own
        {
            new.machine.memory.set_bit(element.power, old.has_power(power));
        }
    }
    for (network, was) in matching.networks.iter().enumerate() {
        if let Some(was) = *was {
            new.machine.reached[network] = if old.compiled.skippable[was] {
                old.machine.reached[was]
            } else {
                old.machine.scan
            };
            new.machine.left_at[network] = old.machine.left_at[was];
        }
    }
    // The rows that records took are not those of this code.
    new.ran_plain = true;
}

/// Forces stay, and what waits underneath.
fn forces(old: &Simulation, new: &mut Simulation, renamed: &Renamed, lost: &mut Vec<Lost>) {
    for (name, force) in &old.forces {
        let point = new.resolve(&renamed.name_now(name));
        let point = point.ok().filter(|point| !point.read_only);
        let kept = |value: Value, point: &Point| tags::kept(value, force.point.ty, point.ty);
        let held = point.and_then(|point| Some((kept(old.value(&force.point), &point)?, point)));
        match held {
            Some((value, point)) => {
                let underneath = force.underneath.clone();
                let underneath = underneath.and_then(|value| kept(value, &point));
                new.hold(point.clone(), value);
                if let Some(held) = new.forces.get_mut(&point.name) {
                    held.underneath = underneath;
                }
            }
            None => lost.push(Lost {
                message: format!(
                    "{name} is not forced any more: the program has it no longer, or as another type"
                ),
                location: None,
            }),
        }
    }
}

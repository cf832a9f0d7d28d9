//! Which cells of two programs hold the same thing, whatever they hold now.

use super::matching::Matching;
use super::renamed::Renamed;
use super::{paired_places, tags};
use crate::layout::{Home, state_size};
use crate::memory::{Bit, Word};
use crate::places::{Cell, EdgeOf};
use crate::simulation::Simulation;
use std::collections::{HashMap, HashSet};

/// The cells of tags, timers, counters and of what blocks remember at their places, as a change of the running program would
/// carry them: of the old program, and of the new one.
pub fn counterparts(old: &Simulation, new: &Simulation) -> Vec<(Cell, Cell)> {
    let renamed = Renamed::of(old, new);
    let matching = Matching::of(&old.program, &new.program, &renamed);
    let mut found = Vec::new();
    for ((was, from), (is, to)) in tags::pairs(old, new, &matching, &renamed).0 {
        if was.ty == is.ty {
            homes(from, to, &mut found);
        }
    }
    let edges: Vec<(Cell, Cell)> = found
        .iter()
        .filter_map(|(was, is)| Some((edge(old, *was)?, edge(new, *is)?)))
        .collect();
    found.extend(edges);
    found.extend(paired_places(old, new, &matching).0);
    powers(old, new, &matching, &mut found);
    found
}

/// The powers in networks: some are remembered where a network may be passed over.
fn powers(old: &Simulation, new: &Simulation, matching: &Matching, found: &mut Vec<(Cell, Cell)>) {
    let mut networks = matching.networks.clone();
    let taken: HashSet<usize> = networks.iter().copied().flatten().collect();
    let mut edited = (0..old.program.networks.len()).filter(|network| !taken.contains(network));
    for network in networks.iter_mut().filter(|network| network.is_none()) {
        *network = edited.next();
    }
    let mut was: HashMap<(usize, u32), Bit> = HashMap::new();
    for element in &old.compiled.elements {
        was.insert((element.network as usize, element.step), element.power);
    }
    for element in &new.compiled.elements {
        let network = networks[element.network as usize];
        let power = network.and_then(|network| was.get(&(network, element.step)));
        found.extend(power.map(|was| (Cell::Bit(*was), Cell::Bit(element.power))));
    }
}

fn homes(from: Home, to: Home, found: &mut Vec<(Cell, Cell)>) {
    let bit = |(from, to): (Bit, Bit), n: u32| (Cell::Bit(from.offset(n)), Cell::Bit(to.offset(n)));
    let word = |(from, to): (Word, Word), n: u32| (Cell::Word(from.offset(n)), Cell::Word(to.offset(n)));
    match (from, to) {
        (Home::Bits { at: from, len, .. }, Home::Bits { at: to, .. }) => {
            found.extend((0..len).map(|n| bit((from, to), n)));
        }
        (Home::Words { at: from, len, .. }, Home::Words { at: to, .. }) => {
            found.extend((0..len).map(|n| word((from, to), n)));
        }
        (
            Home::State { state, bits, words },
            Home::State {
                bits: to_bits,
                words: to_words,
                ..
            },
        ) => {
            let (bit_count, word_count) = state_size(state);
            found.extend((0..bit_count).map(|n| bit((bits, to_bits), n)));
            found.extend((0..word_count).map(|n| word((words, to_words), n)));
        }
        _ => {}
    }
}

/// The memory that all edges of a cell share.
fn edge(simulation: &Simulation, of: Cell) -> Option<Cell> {
    let of = match of {
        Cell::Bit(bit) => EdgeOf::Bit(bit),
        Cell::Word(word) => EdgeOf::Word(word),
    };
    let edges = &simulation.compiled.places.of_tags;
    edges.get(&of).copied().map(Cell::Bit)
}

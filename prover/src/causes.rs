//! Why a property is not decided: what was left open on which it depends, and what takes longer than was searched.

use crate::decide::reach;
use crate::graph::Lit;
use crate::model::Model;
use crate::sure::doubtful_assumptions;
use ladder_analysis::program::Location;
use ladder_simulator::Simulation;
use ladder_simulator::compiled::{Bit, Home, Word};
use rustc_hash::FxHashSet;

/// In words, with the block or the tag that it is about.
type Cause = (String, Option<Location>);

/// What was left open that a literal depends on.
pub(crate) fn left_open(model: &Model, target: Lit) -> Vec<Cause> {
    let assumed = doubtful_assumptions(model);
    let nodes = reach(model, assumed.into_iter().chain([target]));
    let gaps = &model.world.gaps;
    let mut found: Vec<usize> = (model.world.open.iter())
        .filter(|(node, _)| nodes.contains(node))
        .map(|(_, gap)| *gap)
        .collect();
    found.sort_unstable();
    found.dedup();
    let found = found.into_iter().map(|gap| &gaps[gap]);
    found.map(|gap| (gap.what.clone(), gap.location)).collect()
}

/// The timers and counters on which a literal depends and that count further than was searched.
pub(crate) fn what_takes_long(
    simulation: &Simulation,
    model: &Model,
    target: Lit,
    scans: usize,
) -> Vec<Cause> {
    let nodes = reach(model, std::iter::once(target));
    let program = simulation.program();
    let tags = program.tags.iter().zip(&simulation.compiled().homes);
    let mut found = Vec::new();
    for (tag, home) in tags {
        let Home::State { bits, words, .. } = *home else {
            continue;
        };
        let says = timer(model, &nodes, bits, scans).or_else(|| counter(model, &nodes, words, scans));
        found.extend(says.map(|says| (format!("{} {says}", tag.name), Some(tag.location))));
    }
    found
}

fn timer(model: &Model, nodes: &FxHashSet<usize>, bits: Bit, scans: usize) -> Option<String> {
    let timers = model.world.timers.iter().zip(&model.world.ages);
    let mut ages = timers
        .filter(|(timer, _)| **timer == bits.0)
        .map(|(_, ages)| ages);
    let matters = |ages: &Vec<usize>| {
        let mut leaves = ages.iter().map(|n| model.world.states[*n].leaf.node());
        leaves.any(|node| nodes.contains(&node))
    };
    if !ages.any(matters) {
        return None;
    }
    match model.world.presets.get(&bits.0)? {
        Some(preset) if *preset >= scans as u64 => Some(format!("takes {preset} scans")),
        Some(_) => None,
        None => Some("has a preset that changes".into()),
    }
}

fn counter(model: &Model, nodes: &FxHashSet<usize>, words: Word, scans: usize) -> Option<String> {
    let counts = model.world.counts.iter();
    let mut presets = counts
        .filter(|(at, bit, _)| *at == words.0 && nodes.contains(&bit.node()))
        .map(|(_, _, preset)| *preset);
    match presets.next()? {
        Some(preset) if preset.unsigned_abs() >= scans as u64 => Some(format!("counts to {preset}")),
        Some(_) => None,
        None => Some("counts to a number that changes".into()),
    }
}

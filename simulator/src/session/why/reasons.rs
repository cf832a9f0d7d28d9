//! The boolean network before a block: how power came to it, or what it would take.

use super::trace::en_of;
use ladder_analysis::program::{BlockKind, Network, Step};
use ladder_instructions::Power;
use std::collections::HashMap;

/// What passes power on, or blocks it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Blocker {
    /// A block of the network.
    Block(usize),
    /// The left rail: an `<MCR>` has switched it off.
    Rail,
}

/// More ways than this are not distinguished.
const MOST_WAYS: usize = 64;

/// The blocks that power came through to a step with power, from left to right. Of two wires with power that meet, the
/// upper one is followed.
pub(super) fn passed(network: &Network, step: usize, powers: &[bool]) -> Vec<Blocker> {
    let mut path = Vec::new();
    let mut at = step;
    loop {
        match network.steps[at] {
            Step::Start { .. } => break,
            Step::Join { upper, lower } => at = if powers[upper] { upper } else { lower },
            Step::Block { block, en } => {
                path.push(Blocker::Block(block));
                if !powers[en] {
                    // It gives power of its own: an inverter, a timer that runs out.
                    break;
                }
                at = en;
            }
        }
    }
    path.reverse();
    path
}

/// The sets of blockers of which all must give way so that power reaches a step without power; none holds another.
/// `conducts` gives for contacts what they would do; any other block is taken to pass power on if none reaches it.
pub(super) fn missing(
    network: &Network,
    step: usize,
    powers: &[bool],
    conducts: &HashMap<usize, bool>,
) -> Vec<Vec<Blocker>> {
    let mut ways: Vec<Vec<Vec<Blocker>>> = Vec::with_capacity(step + 1);
    for (at, this) in network.steps[..=step].iter().enumerate() {
        let here = match *this {
            // Power is there, nothing is missing.
            _ if powers[at] => vec![Vec::new()],
            Step::Start { rail: true } => vec![vec![Blocker::Rail]],
            Step::Start { rail: false } => Vec::new(),
            Step::Join { upper, lower } => ways[upper].iter().chain(&ways[lower]).cloned().collect(),
            Step::Block { block, en } => {
                if inverts(network, block) {
                    vec![vec![Blocker::Block(block)]]
                } else if powers[en] || conducts.get(&block) == Some(&false) {
                    let with = |way: &Vec<Blocker>| {
                        let mut way = way.clone();
                        way.push(Blocker::Block(block));
                        way.sort_unstable();
                        way.dedup();
                        way
                    };
                    ways[en].iter().map(with).collect()
                } else {
                    ways[en].clone()
                }
            }
        };
        ways.push(smallest(here));
    }
    ways.pop().unwrap_or_default()
}

/// The blocks whose operands decide that one passes power on or stops it: itself, or what brings power to one that inverts.
pub(super) fn deciding(network: &Network, block: usize, powers: &[bool]) -> Vec<usize> {
    let en = en_of(network, block).filter(|en| inverts(network, block) && powers[*en]);
    let Some(en) = en else { return vec![block] };
    // It passes nothing on because power reaches it.
    let passed = passed(network, en, powers).into_iter();
    let blocks = passed.filter_map(|blocker| match blocker {
        Blocker::Block(index) => Some(index),
        Blocker::Rail => None,
    });
    blocks.collect()
}

/// Whether a block gives power when none reaches it.
pub(super) fn inverts(network: &Network, block: usize) -> bool {
    matches!(network.blocks[block].kind, BlockKind::Instruction(row) if row.power == Power::Inverts)
}

/// Only the sets that hold no other, the small ones first.
fn smallest(mut ways: Vec<Vec<Blocker>>) -> Vec<Vec<Blocker>> {
    ways.sort_by(|a, b| (a.len(), a).cmp(&(b.len(), b)));
    let mut kept: Vec<Vec<Blocker>> = Vec::new();
    for way in ways {
        let holds = |other: &Vec<Blocker>| other.iter().all(|blocker| way.contains(blocker));
        if kept.len() < MOST_WAYS && !kept.iter().any(holds) {
            kept.push(way);
        }
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;
    use std::sync::Arc;

    const SHAPES: [&str; 5] = [
        "+--[ ]( a )--[ ]( b )--[ ]( c )--( )( y )--+\n",
        "+--\\--[ ]( a )--\\--[ ]( b )--( )( y )--+\n|  /--[ ]( c )--/\n",
        "+--[ ]( a )--\\--[ ]( b )--\\--( )( y )--+\n+--[ ]( c )--/--[ ]( d )--/\n",
        "+--\\--[ ]( a )--------\\--( )( y )--+\n|  /--\\--[ ]( b )--\\--/\n|     /--[ ]( c )--/\n",
        "+--\\--[ ]( a )--\\--[ ]( d )--\\--[ ]( e )--\\--( )( y )--+\n|  /--[ ]( b )--/--[ ]( c )--/--[ ]( f )--/\n",
    ];

    /// The power of each step when these contacts conduct.
    fn powers(network: &Network, conducts: &dyn Fn(usize) -> bool) -> Vec<bool> {
        let mut powers: Vec<bool> = Vec::new();
        for step in &network.steps {
            powers.push(match *step {
                Step::Start { rail } => rail,
                Step::Join { upper, lower } => powers[upper] || powers[lower],
                Step::Block { block, en } => powers[en] && conducts(block),
            });
        }
        powers
    }

    #[test]
    fn the_ways_are_all_the_smallest_ones_and_no_other() {
        for text in SHAPES {
            let analysis = ladder_analysis::analyze(&Arc::new(ladder_syntax::parse(text)), "test.clad");
            let program = analysis.program().cloned().unwrap();
            let network = &program.networks[0];
            let contacts = network.blocks.len() - 1;
            let coil = network
                .blocks
                .iter()
                .position(|block| matches!(block.kind, BlockKind::Instruction(row) if row.coil.is_some()));
            let coil = coil.unwrap();
            let en = network.steps.iter().find_map(|step| match *step {
                Step::Block { block, en } if block == coil => Some(en),
                _ => None,
            });
            let en = en.unwrap();
            let numbers: Vec<usize> = (0..=contacts).filter(|&block| block != coil).collect();
            for closed in 0..1u32 << contacts {
                let is_closed = |set: u32, block: usize| {
                    let bit = numbers.iter().position(|&number| number == block);
                    bit.is_none_or(|bit| set >> bit & 1 != 0)
                };
                let now = powers(network, &|block| is_closed(closed, block));
                if now[en] {
                    continue;
                }
                let conducts = numbers
                    .iter()
                    .map(|&block| (block, is_closed(closed, block)))
                    .collect();
                let found: BTreeSet<Vec<Blocker>> =
                    missing(network, en, &now, &conducts).into_iter().collect();
                // Every set of open contacts, tried.
                let opens = (1..1u32 << contacts).filter(|set| set & closed == 0);
                let enough: Vec<u32> = opens
                    .filter(|set| powers(network, &|block| is_closed(closed | set, block))[en])
                    .collect();
                let least = enough
                    .iter()
                    .filter(|&&set| enough.iter().all(|&other| other == set || other & set != other));
                let expected: BTreeSet<Vec<Blocker>> = least
                    .map(|set| {
                        let bits = numbers.iter().enumerate();
                        let chosen = bits.filter(|(bit, _)| set >> bit & 1 != 0);
                        chosen.map(|(_, &block)| Blocker::Block(block)).collect()
                    })
                    .collect();
                assert_eq!(found, expected, "{text} with {closed:b}");
            }
        }
    }
}

//! Which networks and blocks of a changed program are those of the program before.
//!
//! Networks that do the same are the same, wherever they went. What is left of networks in the same gap between two
//! of these was edited: there blocks are matched, first those that do the same, then those whose operands were changed.

use super::renamed::Renamed;
use super::signature::Signatures;
use crate::places::BlockAt;
use ladder_analysis::program::Program;
use std::collections::{HashMap, HashSet, VecDeque};

/// Where the parts of the new program were in the old one.
#[derive(Debug)]
pub(super) struct Matching {
    /// Of each network of the new program that of the old one which does the same.
    pub(super) networks: Vec<Option<usize>>,
    /// Blocks of networks that were edited.
    edited: HashMap<BlockAt, BlockAt>,
}

impl Matching {
    pub(super) fn of(old: &Program, new: &Program, renamed: &Renamed) -> Matching {
        let unchanged = Renamed::default();
        let old_side = Side::of(old, &unchanged);
        let new_side = Side::of(new, renamed);
        let networks = same(&old_side.networks(), &new_side.networks());
        let mut matching = Matching {
            networks,
            edited: HashMap::new(),
        };
        let mut is_matched = vec![false; old.networks.len()];
        for &network in matching.networks.iter().flatten() {
            is_matched[network] = true;
        }
        let mut at = 0;
        while at < new.networks.len() {
            if matching.networks[at].is_some() {
                at += 1;
                continue;
            }
            let gap = matching.networks[at..]
                .iter()
                .take_while(|it| it.is_none())
                .count();
            let from = match at.checked_sub(1) {
                Some(before) => matching.networks[before].map_or(0, |network| network + 1),
                None => 0,
            };
            let old_gap = is_matched[from..].iter().take_while(|it| !**it).count();
            let blocks_of = |program: &Program, first: usize, count: usize| -> Vec<BlockAt> {
                let networks = first..first + count;
                networks
                    .flat_map(|network| {
                        let blocks = 0..program.networks[network].blocks.len();
                        blocks.map(move |block| BlockAt { network, block })
                    })
                    .collect()
            };
            let old_ones = blocks_of(old, from, old_gap);
            let new_ones = blocks_of(new, at, gap);
            matching.match_blocks(&old_side, old_ones, &new_side, new_ones);
            at += gap;
        }
        // What was edited and moved.
        let taken: HashSet<BlockAt> = matching.edited.values().copied().collect();
        let old_ones = unmatched(old, |at| is_matched[at.network] || taken.contains(&at));
        let new_ones = unmatched(new, |at| matching.block(at).is_some());
        matching.match_blocks(&old_side, old_ones, &new_side, new_ones);
        matching
    }

    fn match_blocks(
        &mut self,
        old: &Side<'_>,
        mut old_ones: Vec<BlockAt>,
        new: &Side<'_>,
        mut new_ones: Vec<BlockAt>,
    ) {
        for by_kind in [false, true] {
            let mut known: HashMap<u64, VecDeque<BlockAt>> = HashMap::new();
            for &at in &old_ones {
                if let Some(key) = old.block(at, by_kind) {
                    known.entry(key).or_default().push_back(at);
                }
            }
            let mut taken = HashSet::new();
            new_ones.retain(|&at| {
                let found = new
                    .block(at, by_kind)
                    .and_then(|key| known.get_mut(&key))
                    .and_then(VecDeque::pop_front);
                if let Some(was) = found {
                    self.edited.insert(at, was);
                    taken.insert(was);
                }
                found.is_none()
            });
            old_ones.retain(|at| !taken.contains(at));
        }
    }

    /// The block of the old program that a block of the new one is.
    pub(super) fn block(&self, at: BlockAt) -> Option<BlockAt> {
        match self.networks.get(at.network).copied().flatten() {
            Some(network) => Some(BlockAt { network, ..at }),
            None => self.edited.get(&at).copied(),
        }
    }

    /// The same for a block in bodies.
    pub(super) fn path(&self, path: &[BlockAt]) -> Option<Vec<BlockAt>> {
        path.iter().map(|&at| self.block(at)).collect()
    }
}

/// A program, and what distinguishes its parts.
struct Side<'p> {
    program: &'p Program,
    signatures: Signatures<'p>,
}

impl<'p> Side<'p> {
    fn of(program: &'p Program, renamed: &'p Renamed) -> Side<'p> {
        Side {
            program,
            signatures: Signatures::of(program, renamed),
        }
    }

    fn networks(&self) -> Vec<u64> {
        let networks = self.program.networks.iter();
        networks.map(|network| self.signatures.network(network)).collect()
    }

    /// What a block does, or of which kind it is.
    fn block(&self, at: BlockAt, by_kind: bool) -> Option<u64> {
        let block = &self.program.networks[at.network].blocks[at.block];
        if by_kind {
            self.signatures.kind(block)
        } else {
            Some(self.signatures.block(block))
        }
    }
}

/// The blocks of a program that are not taken yet.
fn unmatched(program: &Program, is_taken: impl Fn(BlockAt) -> bool) -> Vec<BlockAt> {
    let networks = program.networks.iter().enumerate();
    networks
        .flat_map(|(network, it)| (0..it.blocks.len()).map(move |block| BlockAt { network, block }))
        .filter(|&at| !is_taken(at))
        .collect()
}

/// Of each new key the old one that it is: those at both ends that agree, then the first equal one that is left.
fn same(old: &[u64], new: &[u64]) -> Vec<Option<usize>> {
    let start = old.iter().zip(new).take_while(|(old, new)| old == new).count();
    let rest = old.len().min(new.len()) - start;
    let ends = old.iter().rev().zip(new.iter().rev()).take(rest);
    let end = ends.take_while(|(old, new)| old == new).count();
    let mut left: HashMap<u64, VecDeque<usize>> = HashMap::new();
    for (at, &key) in old.iter().enumerate().take(old.len() - end).skip(start) {
        left.entry(key).or_default().push_back(at);
    }
    let middle = new.len() - end;
    let matched = new.iter().enumerate().map(|(at, key)| {
        if at < start {
            Some(at)
        } else if at >= middle {
            Some(old.len() - (new.len() - at))
        } else {
            left.get_mut(key).and_then(VecDeque::pop_front)
        }
    });
    matched.collect()
}

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
        let old_signatures = Signatures::of(old, &Renamed::default());
        let new_signatures = Signatures::of(new, renamed);
        let keys = |program: &Program, signatures: &Signatures<'_>| -> Vec<u64> {
            let networks = program.networks.iter();
            networks.map(|network| signatures.network(network)).collect()
        };
        let networks = same(&keys(old, &old_signatures), &keys(new, &new_signatures));
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
            let olds = blocks_of(old, from, old_gap);
            let news = blocks_of(new, at, gap);
            matching.match_blocks((old, &old_signatures, olds), (new, &new_signatures, news));
            at += gap;
        }
        // What was edited and went elsewhere.
        let taken: HashSet<BlockAt> = matching.edited.values().copied().collect();
        let olds = unmatched(old, |at| is_matched[at.network] || taken.contains(&at));
        let news = unmatched(new, |at| matching.block(at).is_some());
        matching.match_blocks((old, &old_signatures, olds), (new, &new_signatures, news));
        matching
    }

    fn match_blocks(
        &mut self,
        (old, old_signatures, mut olds): (&Program, &Signatures<'_>, Vec<BlockAt>),
        (new, new_signatures, mut news): (&Program, &Signatures<'_>, Vec<BlockAt>),
    ) {
        for by_kind in [false, true] {
            let key = |program: &Program, signatures: &Signatures<'_>, at: BlockAt| {
                let block = &program.networks[at.network].blocks[at.block];
                if by_kind {
                    signatures.kind(block)
                } else {
                    Some(signatures.block(block))
                }
            };
            let mut known: HashMap<u64, VecDeque<BlockAt>> = HashMap::new();
            for &at in &olds {
                if let Some(key) = key(old, old_signatures, at) {
                    known.entry(key).or_default().push_back(at);
                }
            }
            let mut taken = HashSet::new();
            news.retain(|&at| {
                let found = key(new, new_signatures, at)
                    .and_then(|key| known.get_mut(&key))
                    .and_then(VecDeque::pop_front);
                if let Some(was) = found {
                    self.edited.insert(at, was);
                    taken.insert(was);
                }
                found.is_none()
            });
            olds.retain(|at| !taken.contains(at));
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

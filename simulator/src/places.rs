//! What a program remembers that no tag of it holds: edges and the like belong to a block's place in the text, and tags
//! of a user-defined block exist once for each place where it is.

use crate::layout::Home;
use crate::memory::{Bit, Word};
use ladder_analysis::program::{Program, TagId};
use std::collections::HashMap;

/// Of each network whether it is in the body of a user-defined block.
pub(crate) fn networks_of_bodies(program: &Program) -> Vec<bool> {
    let mut is_of_body = vec![false; program.networks.len()];
    for user in &program.blocks {
        is_of_body[user.networks.clone()].fill(true);
    }
    is_of_body
}

/// Where tags live.
pub(crate) type Homes = Vec<(TagId, Home)>;

/// A block of a program.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) struct BlockAt {
    pub(crate) network: usize,
    /// Its number there.
    pub(crate) block: usize,
}

/// A cell that a block keeps from scan to scan.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Cell {
    Bit(Bit),
    Word(Word),
}

/// What an edge belongs to that is shared by all edges of a tag.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum EdgeOf {
    Bit(Bit),
    Word(Word),
}

/// What a block remembers.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Remembered {
    /// The block, after those in whose bodies it is.
    pub(crate) path: Vec<BlockAt>,
    pub(crate) cell: Cell,
}

/// All that no tag of the program holds.
#[derive(Debug, Default)]
pub(crate) struct Places {
    /// In the order of the code.
    pub(crate) remembered: Vec<Remembered>,
    /// The tags of bodies, with the path of the place.
    pub(crate) body_tags: Vec<(Vec<BlockAt>, TagId, Home)>,
    /// The same of bodies inside blocks whose state is a tag, with the number of that tag among those like it.
    pub(crate) owned_tags: Vec<(Vec<BlockAt>, u32, TagId, Home)>,
    /// The tags that are the states of blocks, with the path of the place where the block is, and where the tags of its body live.
    pub(crate) named: Vec<(Vec<BlockAt>, TagId, Homes)>,
    /// What the in-outs of bodies stand for, likewise.
    pub(crate) body_in_outs: Vec<(Vec<BlockAt>, TagId, Home)>,
    /// Edges that belong to a tag.
    pub(crate) of_tags: HashMap<EdgeOf, Bit>,
    /// The scan from which on the serial port is free.
    pub(crate) line_free: Option<Word>,
}

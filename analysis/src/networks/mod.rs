//! The networks of a file, and where each of them is.
//!
//! What is known of a network by itself counts from its start, and the texts before and after an edit share it. Where it
//! is, and what surrounds it, is next to it here.

pub mod access_kind;
pub(crate) mod control_flow;
pub(crate) mod known_blocks;
pub(crate) mod named;
pub(crate) mod neighbours;
pub mod network;
pub mod order;
pub(crate) mod order_table;
#[cfg(test)]
mod order_tests;
pub(crate) mod reading;
pub(crate) mod unread_line;
pub(crate) mod use_kind;
pub mod use_place;

use crate::networks::network::{BoundBlock, Formal, NetworkFacts};

use crate::networks::use_place::{Use, UseRef};
use ladder_syntax::{Parse, TextRange, TextSize};
use std::ops::{Deref, Range};
use std::sync::Arc;

/// The networks of a file, from top to bottom.
#[derive(Debug, Clone, Default)]
pub struct Networks(Vec<Placed>);

/// What is known of a network wherever it is, and where it is in this text.
#[derive(Debug, Clone)]
struct Placed {
    facts: Arc<NetworkFacts>,
    first_line: u32,
    start: TextSize,
    /// The scope of its tags: 0 the file's, else that of block definition `scope - 1`.
    scope: u32,
    /// See [`NetworkAt::broken`].
    broken: bool,
}

impl Networks {
    /// None yet, with room for so many.
    pub(crate) fn with_capacity(networks: usize) -> Networks {
        Networks(Vec::with_capacity(networks))
    }

    /// Adds one below the others.
    pub(crate) fn push(
        &mut self,
        facts: Arc<NetworkFacts>,
        first_line: usize,
        start: TextSize,
        scope: usize,
    ) {
        self.0.push(Placed {
            broken: facts.broken_by_itself,
            facts,
            first_line: first_line as u32,
            start,
            scope: scope as u32,
        });
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// A network. Panics where there are not so many.
    pub fn at(&self, index: usize) -> NetworkAt<'_> {
        let Placed {
            facts,
            first_line,
            start,
            scope,
            broken,
        } = &self.0[index];
        NetworkAt {
            facts,
            index,
            first_line: *first_line as usize,
            range: TextRange::at(*start, facts.len),
            scope: *scope as usize,
            broken: *broken,
        }
    }

    /// A network, if there are so many.
    pub fn get(&self, index: usize) -> Option<NetworkAt<'_>> {
        (index < self.len()).then(|| self.at(index))
    }

    /// The first network.
    pub fn first(&self) -> Option<NetworkAt<'_>> {
        self.get(0)
    }

    /// The last network.
    pub fn last(&self) -> Option<NetworkAt<'_>> {
        self.get(self.len().checked_sub(1)?)
    }

    /// All of them, from top to bottom.
    pub fn iter(&self) -> impl DoubleEndedIterator<Item = NetworkAt<'_>> + ExactSizeIterator + Clone {
        (0..self.len()).map(|index| self.at(index))
    }

    /// Some of them, from top to bottom.
    pub fn range(
        &self,
        range: Range<usize>,
    ) -> impl DoubleEndedIterator<Item = NetworkAt<'_>> + ExactSizeIterator + Clone {
        range.map(|index| self.at(index))
    }

    /// How many are at the top of the file for which this holds, of a condition that does not hold any more after
    /// the first for which it does not.
    pub fn partition_point(&self, mut holds: impl FnMut(NetworkAt<'_>) -> bool) -> usize {
        let (mut low, mut high) = (0, self.len());
        while low < high {
            let middle = low.midpoint(high);
            if holds(self.at(middle)) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        low
    }

    /// The network in whose lines one lies.
    pub fn on_line(&self, line: usize) -> Option<NetworkAt<'_>> {
        let number = self.partition_point(|network| network.lines().end <= line);
        self.get(number).filter(|network| network.lines().contains(&line))
    }

    /// A use as it counts in the file.
    pub(crate) fn use_of(&self, place: UseRef) -> Use {
        let network = &self.0[place.network as usize];
        let named = &network.facts.named[place.named() as usize];
        let line = network.facts.blocks[named.block as usize].base + network.start;
        named.at(place.network as usize, line)
    }

    /// What the operand is given for in which a tag is used.
    pub(crate) fn formal_of(&self, place: UseRef) -> Formal {
        let facts = self.facts(place.network as usize);
        let named = &facts.named[place.named() as usize];
        facts.blocks[named.block as usize].formals[named.operand as usize]
    }

    /// The shared facts of a network.
    pub(crate) fn facts(&self, index: usize) -> &Arc<NetworkFacts> {
        &self.0[index].facts
    }

    pub(crate) fn set_scope(&mut self, index: usize, scope: usize) {
        self.0[index].scope = scope as u32;
    }

    pub(crate) fn set_broken(&mut self, index: usize) {
        self.0[index].broken = true;
    }
}

impl<'c> IntoIterator for &'c Networks {
    type Item = NetworkAt<'c>;
    type IntoIter = std::iter::Map<
        std::iter::Zip<Range<usize>, std::iter::Repeat<&'c Networks>>,
        fn((usize, &'c Networks)) -> NetworkAt<'c>,
    >;

    fn into_iter(self) -> Self::IntoIter {
        (0..self.len())
            .zip(std::iter::repeat(self))
            .map(|(index, networks)| networks.at(index))
    }
}

/// A network at its place in the file.
#[derive(Debug, Clone, Copy)]
pub struct NetworkAt<'c> {
    facts: &'c NetworkFacts,
    /// Which network of the file it is.
    pub index: usize,
    /// Its first line, as in the parse: that of its first rung.
    pub first_line: usize,
    /// From the first rung to the last, line ends included.
    pub range: TextRange,
    /// The scope of its tags: 0 the file's, else that of block definition `scope - 1`.
    pub scope: usize,
    /// Its text, or that of the rung which should be joined to it, has an error in the drawing (an unclosed
    /// block, a stray character, a connector without its partner), so that wiring says little about what is meant.
    pub broken: bool,
}

impl Deref for NetworkAt<'_> {
    type Target = NetworkFacts;

    fn deref(&self) -> &NetworkFacts {
        self.facts
    }
}

impl<'c> NetworkAt<'c> {
    /// What is known of it by itself.
    pub fn facts(self) -> &'c NetworkFacts {
        self.facts
    }

    /// Its blocks from left to right, top to bottom.
    pub fn blocks(self) -> impl DoubleEndedIterator<Item = BlockAt<'c>> + ExactSizeIterator + Clone {
        self.facts.blocks.iter().map(move |bound| BlockAt {
            bound,
            base: self.range.start() + bound.base,
        })
    }

    /// One of its blocks.
    pub fn block(self, block: usize) -> BlockAt<'c> {
        let bound = &self.facts.blocks[block];
        BlockAt {
            bound,
            base: self.range.start() + bound.base,
        }
    }

    /// Its lines, as in the parse: from the first rung to the last.
    pub fn lines(self) -> Range<usize> {
        self.first_line..self.first_line + self.facts.line_count()
    }

    /// The line of a rung, as in the parse.
    pub fn line(self, rung: usize) -> usize {
        self.first_line + self.facts.wiring.line_offsets[rung]
    }

    /// A part of a rung, counted from the start of the file.
    pub fn part_range(self, parse: &Parse, rung: usize, part: usize) -> TextRange {
        self.facts.wiring.rungs[rung].parts[part].range + parse.line_start(self.line(rung))
    }
}

/// A block at its place in the file.
#[derive(Debug, Clone, Copy)]
pub struct BlockAt<'c> {
    bound: &'c BoundBlock,
    /// Where its line starts, from the start of the file.
    pub base: TextSize,
}

impl Deref for BlockAt<'_> {
    type Target = BoundBlock;

    fn deref(&self) -> &BoundBlock {
        self.bound
    }
}

impl<'c> BlockAt<'c> {
    /// What is known of it wherever it is.
    pub fn bound(self) -> &'c BoundBlock {
        self.bound
    }

    /// A range of the block's line, counted from the start of the file.
    pub fn absolute(self, range: TextRange) -> TextRange {
        range + self.base
    }

    /// The whole block, counted from the start of the file.
    pub fn range(self) -> TextRange {
        self.absolute(self.bound.facts.range)
    }

    /// Its first part, counted from the start of the file.
    pub fn head_range(self) -> TextRange {
        self.absolute(self.bound.facts.head_range)
    }
}

//! The networks of a file, and where each of them is.
//!
//! What is known of a network by itself counts from its start, and texts before and behind an edit share it. Where it
//! is, and what surrounds it, is in lists of plain numbers beside it: the only thing that an edit copies for each network.
//! A network keeps its number (`id`) while it stays, so that whoever refers to it need not know how many are above it.

pub(crate) mod chunked;
pub(crate) mod control_flow;
pub mod facts;
pub(crate) mod kept;
pub(crate) mod known_blocks;
pub(crate) mod neighbours;
pub mod network;
pub mod order;
pub(crate) mod order_table;
#[cfg(test)]
mod order_tests;
pub(crate) mod outward_jumps;
pub(crate) mod reading;
pub(crate) mod unread_line;
pub mod user_block;

use crate::chunked::Chunked;
use crate::network::{BoundBlock, Formal, NetworkFacts};
use crate::scope::{Use, UseRef};
use ladder_syntax::{Parse, TextRange, TextSize};
use std::ops::{Deref, Range};
use std::sync::Arc;

/// The networks of a file, from top to bottom.
#[derive(Debug, Clone, Default)]
pub struct Networks {
    /// By their numbers.
    facts: Chunked<Arc<NetworkFacts>>,
    places: Vec<NetworkPlace>,
    /// For each number which network it is. An edit that leaves as many networks shares the list.
    index_of: Arc<Vec<u32>>,
    /// Numbers that no network has.
    free: Vec<u32>,
}

/// A network that takes the place of another.
pub(crate) struct Spliced {
    /// Its number, if it had one before.
    pub(crate) id: Option<u32>,
    pub(crate) facts: Arc<NetworkFacts>,
    pub(crate) first_line: usize,
    pub(crate) start: TextSize,
    pub(crate) scope: usize,
}

/// Where a network is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct NetworkPlace {
    /// The number by which others refer to it.
    pub(crate) id: u32,
    pub(crate) first_line: u32,
    /// In bytes.
    pub(crate) start: u32,
    /// The scope of its tags: 0 the file's, else that of block definition `scope - 1`.
    pub(crate) scope: u32,
    /// See [`NetworkAt::broken`].
    pub(crate) broken: bool,
}

impl Networks {
    /// None yet, with room for so many.
    pub(crate) fn with_capacity(networks: usize) -> Networks {
        Networks {
            places: Vec::with_capacity(networks),
            index_of: Arc::new(Vec::with_capacity(networks)),
            ..Networks::default()
        }
    }

    /// Adds one below the others.
    pub(crate) fn push(
        &mut self,
        facts: Arc<NetworkFacts>,
        first_line: usize,
        start: TextSize,
        scope: usize,
    ) {
        let id = self.places.len() as u32;
        Arc::make_mut(&mut self.index_of).push(id);
        self.places.push(NetworkPlace {
            id,
            first_line: first_line as u32,
            start: start.into(),
            scope: scope as u32,
            broken: facts.broken_by_itself,
        });
        self.facts.push(facts);
    }

    /// Puts others in the place of some. Those that are new get the numbers `free` of those that are gone, as far as these
    /// reach; what is below is so many more lines and bytes further down.
    pub(crate) fn splice(
        &mut self,
        old: Range<usize>,
        new: Vec<Spliced>,
        free: Vec<u32>,
        lines: isize,
        bytes: i64,
    ) {
        for place in &mut self.places[old.end..] {
            place.first_line = place.first_line.wrapping_add_signed(lines as i32);
            place.start = place.start.wrapping_add_signed(bytes as i32);
        }
        // The first of them gets the first number: a network that is only read again keeps its own.
        self.free.extend(free.into_iter().rev());
        let same_count = old.len() == new.len();
        let first = old.start;
        let mut places = Vec::with_capacity(new.len());
        for network in new {
            let id = network.id.unwrap_or_else(|| self.number(&network.facts));
            places.push(NetworkPlace {
                id,
                first_line: network.first_line as u32,
                start: network.start.into(),
                scope: network.scope as u32,
                broken: network.facts.broken_by_itself,
            });
        }
        let end = first + places.len();
        self.places.splice(old, places);
        let moved = if same_count { end } else { self.places.len() };
        let of = |place: &NetworkPlace| place.id as usize;
        let mut indexed = (first..).zip(&self.places[first..moved]);
        if indexed.any(|(index, place)| self.index_of[of(place)] != index as u32) {
            let index_of = Arc::make_mut(&mut self.index_of);
            for (index, place) in (first..).zip(&self.places[first..moved]) {
                index_of[of(place)] = index as u32;
            }
        }
    }

    /// A number for a network that has none.
    fn number(&mut self, facts: &Arc<NetworkFacts>) -> u32 {
        if let Some(id) = self.free.pop() {
            *self.facts.get_mut(id as usize) = Arc::clone(facts);
            return id;
        }
        let id = self.facts.len() as u32;
        self.facts.push(Arc::clone(facts));
        Arc::make_mut(&mut self.index_of).push(0);
        id
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        self.places.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.places.is_empty()
    }

    /// A network. Panics where there are not so many.
    pub fn at(&self, index: usize) -> NetworkAt<'_> {
        let place = self.places[index];
        let facts = &self.facts[place.id as usize];
        NetworkAt {
            facts,
            index,
            first_line: place.first_line as usize,
            range: TextRange::at(TextSize::new(place.start), facts.len),
            scope: place.scope as usize,
            broken: place.broken,
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

    /// How many are at the top of the file for which this holds, of a condition that does not hold any more behind
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

    /// The network of a number.
    pub(crate) fn index_of(&self, id: u32) -> usize {
        self.index_of[id as usize] as usize
    }

    /// Where the network of a number starts.
    pub(crate) fn start_of(&self, id: u32) -> TextSize {
        TextSize::new(self.places[self.index_of(id)].start)
    }

    /// The first line of the network of a number, as in the parse.
    pub(crate) fn first_line_of(&self, id: u32) -> usize {
        self.places[self.index_of(id)].first_line as usize
    }

    /// How many numbers there are, with those that no network has.
    pub(crate) fn numbers(&self) -> usize {
        self.index_of.len()
    }

    /// The number of a network.
    pub(crate) fn id(&self, index: usize) -> u32 {
        self.places[index].id
    }

    /// A use as it counts in the file.
    pub(crate) fn use_of(&self, place: UseRef) -> Use {
        let index = self.index_of(place.network);
        let facts = &self.facts[place.network as usize];
        let named = &facts.named[place.named() as usize];
        let line = facts.blocks[named.block as usize].base + TextSize::new(self.places[index].start);
        named.at(index, line)
    }

    /// In what order a tag has the places at which it is used: those in the file's own scope, then those in bodies of
    /// user-defined blocks that lead to it, each from top to bottom.
    pub(crate) fn order_of(&self, place: UseRef) -> (bool, usize, u32) {
        let index = self.index_of(place.network);
        (self.places[index].scope > 0, index, place.named())
    }

    /// The block at a place where a tag is used.
    pub(crate) fn block_of(&self, place: UseRef) -> &BoundBlock {
        let facts = &self.facts[place.network as usize];
        &facts.blocks[facts.named[place.named() as usize].block as usize]
    }

    /// What the operand is given for in which a tag is used.
    pub(crate) fn formal_of(&self, place: UseRef) -> Formal {
        let facts = &self.facts[place.network as usize];
        let named = &facts.named[place.named() as usize];
        facts.blocks[named.block as usize].formals[named.operand as usize]
    }

    /// The shared facts of a network.
    pub(crate) fn facts(&self, index: usize) -> &Arc<NetworkFacts> {
        &self.facts[self.places[index].id as usize]
    }

    /// What is known of the network that has a number, or had it last.
    pub(crate) fn numbered(&self, id: u32) -> Option<&NetworkFacts> {
        self.facts.get(id as usize).map(|facts| &**facts)
    }

    pub(crate) fn set_scope(&mut self, index: usize, scope: usize) {
        self.places[index].scope = scope as u32;
    }

    /// As its own text says.
    pub(crate) fn reset_broken(&mut self, index: usize) {
        self.places[index].broken = self.facts(index).broken_by_itself;
    }

    pub(crate) fn set_broken(&mut self, index: usize) {
        self.places[index].broken = true;
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
    /// Its text, or that of the rung which should be joined to it, has a mistake in the drawing (an unclosed
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

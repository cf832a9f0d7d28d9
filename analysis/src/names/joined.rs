//! Which tag each name of a network means, kept from when the names of a whole file are joined.
//!
//! A name is looked up in a table that is larger than the processor's cache, and when a file is opened half a dozen passes
//! ask about every name in it. After an edit few names are asked about: then each is looked up by itself.

use crate::context::Context;
use crate::networks::NetworkAt;
use crate::scope::Scope;
use crate::uses::Named;
use ladder_syntax::TextRange;

/// The tags that the networks of a file name, as indices in their scopes.
#[derive(Debug, Default)]
pub(crate) struct Joined {
    /// In the order of the networks and of the names in them.
    tags: Vec<u32>,
    /// For each network where its tags begin, and at the end how many there are.
    first: Vec<u32>,
}

impl Joined {
    /// No names yet, with room for those of this many networks.
    pub(crate) fn with_networks(networks: usize) -> Joined {
        let mut first = Vec::with_capacity(networks + 1);
        first.push(0);
        Joined {
            tags: Vec::with_capacity(4 * networks),
            first,
        }
    }

    /// The next name of the network that is being joined means this tag.
    pub(crate) fn push(&mut self, tag: usize) {
        self.tags.push(tag as u32);
    }

    /// All names of a network are joined.
    pub(crate) fn end_network(&mut self) {
        self.first.push(self.tags.len() as u32);
    }

    fn of(&self, network: usize) -> &[u32] {
        &self.tags[self.first[network] as usize..self.first[network + 1] as usize]
    }
}

/// Some names of a network, and the tags that they mean.
#[derive(Debug, Clone, Copy)]
pub(crate) struct NamedTags<'c> {
    scope: &'c Scope,
    named: &'c [Named],
    joined: Option<&'c [u32]>,
}

impl<'c> NamedTags<'c> {
    /// All names of a network.
    pub(crate) fn of(context: &'c Context, network: NetworkAt<'c>) -> NamedTags<'c> {
        NamedTags {
            scope: &context.scopes[network.scope],
            named: &network.facts().named,
            joined: context.joined.as_deref().map(|joined| joined.of(network.index)),
        }
    }

    /// The names of the next block, which is the one with this number: the rest is left.
    pub(crate) fn next_block(&mut self, block: usize) -> NamedTags<'c> {
        let in_it = |named: &&Named| named.block as usize == block;
        let count = self.named.iter().take_while(in_it).count();
        let of_block = NamedTags {
            scope: self.scope,
            named: &self.named[..count],
            joined: self.joined.map(|joined| &joined[..count]),
        };
        self.named = &self.named[count..];
        self.joined = self.joined.map(|joined| &joined[count..]);
        of_block
    }

    /// Each name with its tag, if it has one.
    pub(crate) fn iter(self) -> impl Iterator<Item = (&'c Named, Option<usize>)> {
        let names = self.named.iter().enumerate();
        names.map(move |(number, named)| (named, self.tag(number)))
    }

    /// The tag of the name at a place, counted from the start of its block's line. None: nothing is known of a name there.
    pub(crate) fn at(self, range: TextRange) -> Option<usize> {
        let number = self.named.iter().position(|named| named.is_at(range))?;
        self.tag(number)
    }

    fn tag(self, number: usize) -> Option<usize> {
        match self.joined {
            Some(joined) => Some(joined[number] as usize),
            None => self.scope.find(&self.named[number].key),
        }
    }
}

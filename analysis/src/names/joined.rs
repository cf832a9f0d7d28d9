//! Which tag each name of a network means: looked up once, when the names of a file are joined, since half a dozen passes ask
//! about every name.

use crate::networks::named::Named;
use ladder_syntax::TextRange;

/// Of a name that means no tag.
const NO_TAG: u32 = u32::MAX;

/// The tags that the networks of a file name, as indices in their scopes.
#[derive(Debug, Clone, Default)]
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

    /// The next name of the network that is being joined means this tag; none if it is the value of an enumeration.
    pub(crate) fn push(&mut self, tag: Option<usize>) {
        self.tags.push(tag.map_or(NO_TAG, |tag| tag as u32));
    }

    /// All names of a network are joined.
    pub(crate) fn end_network(&mut self) {
        self.first.push(self.tags.len() as u32);
    }

    /// The names of a network, which are these.
    pub(crate) fn names<'c>(&'c self, network: usize, named: &'c [Named]) -> NamedTags<'c> {
        let tags = self.first[network] as usize..self.first[network + 1] as usize;
        NamedTags {
            named,
            tags: &self.tags[tags],
        }
    }
}

/// Some names of a network, and the tags that they mean.
#[derive(Debug, Clone, Copy)]
pub(crate) struct NamedTags<'c> {
    named: &'c [Named],
    tags: &'c [u32],
}

impl<'c> NamedTags<'c> {
    /// The names of the next block, which is the one with this number: the rest is left.
    pub(crate) fn next_block(&mut self, block: usize) -> NamedTags<'c> {
        let in_it = |named: &&Named| named.block as usize == block;
        let count = self.named.iter().take_while(in_it).count();
        let of_block = NamedTags {
            named: &self.named[..count],
            tags: &self.tags[..count],
        };
        self.named = &self.named[count..];
        self.tags = &self.tags[count..];
        of_block
    }

    /// Each name of a tag with that.
    pub(crate) fn iter(self) -> impl Iterator<Item = (&'c Named, usize)> {
        let tags = self.tags.iter().map(|tag| *tag as usize);
        self.named
            .iter()
            .zip(tags)
            .filter(|(_, tag)| *tag != NO_TAG as usize)
    }

    /// The tag of the name at a place, counted from the start of its block's line. None: nothing is known of a name there.
    pub(crate) fn at(self, range: TextRange) -> Option<usize> {
        let number = self.named.iter().position(|named| named.is_at(range))?;
        let tag = self.tags[number];
        (tag != NO_TAG).then_some(tag as usize)
    }
}

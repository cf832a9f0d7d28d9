//! What an edit leaves as it was: the networks on whose lines nothing has changed.
//!
//! A line that an edit does not touch stays the same line ([`Parse::edited`]), and what is known of a network by
//! itself follows from its lines, and from the signatures of the user-defined blocks that it holds. So two texts are compared line by line: those that both
//! begin with, and those that both end with.

use crate::names::context::Context;
use crate::networks::network::{NetworkFacts, UserBlocks};
use ladder_syntax::{Network, Parse, Structure};
use std::borrow::Cow;
use std::sync::Arc;

/// What an earlier context has that a new text has as well.
pub(crate) struct Kept<'c> {
    before: &'c Context,
    /// The networks, sections and block definitions of its text.
    structure: Cow<'c, Structure>,
    /// How many lines both texts begin with.
    above: usize,
    /// From which line on the new text ends as the old one does.
    below: usize,
    /// How many more lines the new text has.
    lines: isize,
    /// The file's own blocks have the signatures that they had.
    signatures: bool,
    /// The old network to look at next.
    next: usize,
}

impl<'c> Kept<'c> {
    pub(crate) fn of(before: &'c Context, parse: &Parse, signatures: u64) -> Kept<'c> {
        let (old, new) = (before.parse.lines(), parse.lines());
        let (above, below) = new.shared_with(old);
        let below = new.len() - below;
        Kept {
            before,
            structure: before.parse.structure_once(),
            above,
            below,
            lines: new.len() as isize - old.len() as isize,
            signatures: before.signatures == signatures,
            next: 0,
        }
    }

    /// What is known of a network of the new text, if the old one has it too. To be asked from top to bottom.
    pub(crate) fn network(&mut self, drawn: &Network) -> Option<Arc<NetworkFacts>> {
        let moved = drawn.lines.start >= self.below;
        if drawn.lines.end > self.above && !moved {
            return None;
        }
        let by = if moved { self.lines } else { 0 };
        let first = drawn.lines.start.wrapping_add_signed(-by);
        let networks = &self.structure.networks;
        // Nearly always it is the very next one.
        if networks
            .get(self.next)
            .is_none_or(|next| next.lines.start != first)
        {
            self.next = networks.partition_point(|old| old.lines.start < first);
        }
        let old = networks.get(self.next)?;
        if old.lines.start != first || old.lines.len() != drawn.lines.len() {
            return None;
        }
        let facts = self.before.networks.facts(self.next);
        let means_the_same = match facts.user_blocks {
            UserBlocks::None => true,
            UserBlocks::Own => self.signatures,
            UserBlocks::Others => false,
        };
        if !means_the_same {
            return None;
        }
        self.next += 1;
        Some(Arc::clone(facts))
    }
}

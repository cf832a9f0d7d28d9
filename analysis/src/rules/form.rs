//! What the rules about the form of a network are given, and nothing else of the file: what they find is kept with the network
//! while this is the same.

use crate::names::context::Context;
use crate::networks::NetworkAt;
use crate::written::user_block::UserBlockFacts;
use ladder_instructions::Profile;
use ladder_syntax::Parse;

/// A network with what else decides about its drawing and the form of its blocks.
pub(super) struct Form<'c> {
    pub(super) network: NetworkAt<'c>,
    /// For the places and the text of its own lines. Next to them a rule may look at connectors that lack their partners:
    /// where they are the network is [broken](NetworkAt::broken).
    pub(super) parse: &'c Parse,
    pub(super) profile: Profile,
    /// For the signatures of the blocks that it holds, and of the one whose body it is in.
    pub(super) user_blocks: &'c [UserBlockFacts],
    /// The whole file, for a network of which nothing is kept.
    pub(super) file: Option<&'c Context>,
}

impl<'c> Form<'c> {
    pub(super) fn of(context: &'c Context, network: NetworkAt<'c>) -> Form<'c> {
        // Elsewhere what surrounds the network, or another file, has a say.
        let is_kept = network.names_tags_only && !network.broken;
        Form {
            network,
            parse: &context.parse,
            profile: context.profile,
            user_blocks: &context.user_blocks,
            file: (!is_kept).then_some(context),
        }
    }
}

//! The types of a network's operands, looked at again only where what they name has another type.

use super::check;
use crate::context::Context;
use crate::networks::NetworkAt;
use crate::verdict::{self, InNetwork, Pass};
use ladder_syntax::TextRange;

/// Resolves a network for the sake of its mistakes. Gives them, and the first block that could not be resolved whole.
/// `stamp` is that of its tags.
pub(crate) fn check_network(
    context: &Context,
    network: NetworkAt<'_>,
    stamp: u64,
) -> (InNetwork, Option<TextRange>) {
    let mut unresolved = None;
    let key = network.names_tags_only.then_some(stamp);
    let found = verdict::once(Pass::Types, key, network, |out| {
        unresolved = check(context, network.index, out);
        unresolved.is_none()
    });
    (found, unresolved)
}

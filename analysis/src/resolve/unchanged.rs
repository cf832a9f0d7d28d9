//! Which networks need no second look: what they name still has the same types.

use super::check;
use crate::context::Context;
use crate::diagnostic::Diagnostic;
use crate::verdict::Pass;
use ladder_syntax::TextRange;

/// Resolves all networks for the sake of their mistakes, which go to `out`. Gives the first block that could not be
/// resolved whole. `stamps` are those of the networks' tags.
pub(crate) fn check_all(context: &Context, stamps: &[u64], out: &mut Vec<Diagnostic>) -> Option<TextRange> {
    let mut unresolved = None;
    for (index, network) in context.networks.iter().enumerate() {
        // Never 0.
        let key = stamps[index] | 1;
        if network.names_tags_only && network.verdict.recall(Pass::Types, key, network.range, out) {
            continue;
        }
        let before = out.len();
        let here = check(context, index, out);
        if here.is_none() {
            network
                .verdict
                .keep(Pass::Types, key, network.range, &out[before..]);
        }
        unresolved = unresolved.or(here);
    }
    unresolved
}

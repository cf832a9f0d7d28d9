//! Which networks need no second look: nothing was wrong with them, and what they name still has the same types.

use super::check;
use crate::context::Context;
use crate::diagnostic::Diagnostic;
use crate::scope::{Origin, TagFacts};
use ladder_syntax::TextRange;
use rustc_hash::FxHasher;
use std::hash::{Hash, Hasher};

/// Resolves all networks for the sake of their mistakes, which go to `out`. Gives the first block that could not be
/// resolved whole.
pub(crate) fn check_all(context: &Context, out: &mut Vec<Diagnostic>) -> Option<TextRange> {
    let types = types(context);
    let mut unresolved = None;
    for (index, network) in context.networks.iter().enumerate() {
        // Never 0.
        let types = types[index] | 1;
        if network.names_tags_only && network.verdict.is_well_typed(types) {
            continue;
        }
        let found = out.len();
        let here = check(context, index, out);
        if out.len() == found && here.is_none() {
            network.verdict.well_typed(types);
        }
        unresolved = unresolved.or(here);
    }
    unresolved
}

/// For each network a number that says which types its tags have, at their places in it.
fn types(context: &Context) -> Vec<u64> {
    let mut types = vec![0_u64; context.networks.len()];
    for tag in context.scopes.iter().flat_map(|scope| &scope.tags) {
        let stamp = stamp(tag);
        for place in &tag.uses {
            let within = place.range.start() - context.networks[place.network].range.start();
            let mut hasher = FxHasher::default();
            (stamp, u32::from(within)).hash(&mut hasher);
            // A tag of another scope is met twice, here and there: the order does not matter.
            let sum = &mut types[place.network];
            *sum = sum.wrapping_add(hasher.finish());
        }
    }
    types
}

/// All of a tag that decides whether an operand may name it.
fn stamp(tag: &TagFacts) -> u64 {
    let mut hasher = FxHasher::default();
    let undeclared = tag.origin == Origin::Undeclared;
    (tag.ty, tag.constant, tag.mistyped, undeclared).hash(&mut hasher);
    hasher.finish()
}

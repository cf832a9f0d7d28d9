//! A number for each network that stands for all that its tags add to what is found in it. While the number is the
//! same, and the lines are, so are the findings.

use crate::context::Context;
use crate::networks::NetworkAt;
use crate::scope::{Origin, TagFacts};
use crate::value::Value;
use rustc_hash::FxHasher;
use std::hash::{Hash, Hasher};

/// The stamps of the networks, as in the context.
pub(crate) fn stamps(context: &Context) -> Vec<u64> {
    let all = (context.profile, context.signatures);
    let of_scope = |network: NetworkAt<'_>| hash((all, network.scope));
    let mut stamps: Vec<u64> = context.networks.iter().map(of_scope).collect();
    for tag in context.scopes.iter().flat_map(|scope| &scope.tags) {
        if tag.uses.is_empty() {
            continue;
        }
        let stamp = stamp(tag);
        for place in &tag.uses.0 {
            // A tag of another scope is met twice, here and there: the order does not matter.
            let sum = &mut stamps[context.networks.index_of(place.network)];
            *sum = sum.wrapping_add(hash((stamp, place.named)));
        }
    }
    stamps
}

fn hash(value: impl Hash) -> u64 {
    let mut hasher = FxHasher::default();
    value.hash(&mut hasher);
    hasher.finish()
}

/// All of a tag that findings in a network depend on. Its name stands for the tag itself, which other names may lead
/// to, and messages spell it so.
fn stamp(tag: &TagFacts) -> u64 {
    let mut hasher = FxHasher::default();
    let undeclared = tag.origin == Origin::Undeclared;
    (&tag.name, tag.ty, tag.constant, tag.mistyped, undeclared).hash(&mut hasher);
    if tag.constant {
        for value in &tag.initial {
            match value {
                Value::Bool(on) => on.hash(&mut hasher),
                Value::Int(n) => n.hash(&mut hasher),
                Value::Real(r) => r.to_bits().hash(&mut hasher),
                Value::Text(text) => text.hash(&mut hasher),
            }
        }
    }
    hasher.finish()
}

//! A number for each network that stands for all that its tags add to what is found in it. While the number is the
//! same, and the lines are, so are the findings.

use crate::context::Context;
use crate::joined::NamedTags;
use crate::networks::NetworkAt;
use crate::scope::{Origin, TagFacts};
use crate::value::Value;
use rustc_hash::FxHasher;
use std::hash::{Hash, Hasher};

/// The stamp of a network.
pub(crate) fn of_network(context: &Context, network: NetworkAt<'_>) -> u64 {
    let mut sum = hash((context.profile, context.signatures, network.scope));
    let scope = &context.scopes[network.scope];
    for (number, (_, tag)) in (0u32..).zip(NamedTags::of(context, network).iter()) {
        let Some(tag) = tag else {
            continue;
        };
        let mut facts = &scope.tags[tag];
        // A tag of another scope adds both what it is here and what it is there.
        while let Some((scope, tag)) = context.leads_to(facts) {
            sum = sum.wrapping_add(hash((stamp(facts), number)));
            facts = &context.scopes[scope].tags[tag];
        }
        sum = sum.wrapping_add(hash((stamp(facts), number)));
        if let Some(first) = context.at_address.first(facts) {
            sum = sum.wrapping_add(hash((first, number)));
        }
    }
    sum
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
        for value in &tag.rare.initial {
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

//! A number for each network that stands for all that its tags add to what is found in it. While the number is the
//! same, and the lines are, so are the findings.

use crate::names::context::Context;
use crate::names::scope::{Origin, TagFacts};
use crate::networks::NetworkAt;
use crate::values::value::Value;
use rustc_hash::FxHasher;
use std::hash::{Hash, Hasher};

/// The stamp of a network.
pub(crate) fn of_network(context: &Context, network: NetworkAt<'_>) -> u64 {
    // One hasher takes all of it: a sum of hashes stays the same where two tags exchange their types.
    let mut hasher = FxHasher::default();
    (context.profile, context.signatures, network.scope).hash(&mut hasher);
    context.types.stamp(&mut hasher);
    let scope = &context.scopes[network.scope];
    for (number, (_, tag)) in (0u32..).zip(context.names_of(network).iter()) {
        number.hash(&mut hasher);
        let mut facts = &scope.tags[tag];
        // A tag of another scope adds both what it is here and what it is there.
        while let Some((scope, tag)) = context.alias_of(facts) {
            stamp(facts, &mut hasher);
            facts = &context.scopes[scope].tags[tag];
        }
        stamp(facts, &mut hasher);
        if let Some((scope, first)) = context.at_address.all(facts).first() {
            context.scopes[*scope].tags[*first].name.hash(&mut hasher);
        }
    }
    hasher.finish()
}

/// All of a tag that findings in a network depend on. Its name stands for the tag itself, which other names may lead
/// to, and messages spell it so.
fn stamp(tag: &TagFacts, hasher: &mut FxHasher) {
    let undeclared = tag.origin == Origin::Undeclared;
    (&tag.name, tag.ty, tag.constant, tag.mistyped, undeclared).hash(hasher);
    if tag.constant {
        for value in &tag.cold.initial {
            match value {
                Value::Bool(on) => on.hash(hasher),
                Value::Int(n) => n.hash(hasher),
                Value::Real(r) => r.to_bits().hash(hasher),
                Value::Text(text) => text.hash(hasher),
            }
        }
    }
}

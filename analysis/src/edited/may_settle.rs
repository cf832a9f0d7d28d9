//! Whether the edits of a text can be followed one by one.

use crate::context::Context;
use crate::networks::Networks;
use crate::rare::Lead;
use crate::scope::{Origin, Scope, SectionKind, TagFacts};

/// Whether a context of a whole text can be the beginning. Tags of other files that the file names are followed, and those of the file
/// and of other files that a body names; not two entries of one scope for one tag, nor VAR_GLOBAL sections in bodies.
pub(crate) fn may_settle(context: &Context) -> bool {
    let [file, bodies @ ..] = context.scopes.as_slice() else {
        return false;
    };
    let of_body = |tag: &TagFacts| {
        let is_global = tag.origin == Origin::Declared(SectionKind::Global);
        !is_global && !matches!(tag.rare.lead, Some(Lead::Entry(..)))
    };
    let mut of_bodies = bodies.iter().flat_map(Scope::unusual);
    file.unusual().all(|(_, tag)| !tag.leads_elsewhere())
        && of_bodies.all(|(_, tag)| of_body(tag))
        && (bodies.is_empty() || are_by_first_use(file, &context.networks))
}

/// Whether the tags without a declaration are where an edit puts one: what bodies declare in VAR_EXTERNAL is in the order of these
/// declarations instead.
fn are_by_first_use(file: &Scope, networks: &Networks) -> bool {
    let found = file.tags.from(file.declared);
    let first_uses = found.map(|tag| tag.uses.0.first().map(|place| networks.order_of(*place)));
    first_uses.clone().all(|first| first.is_some()) && first_uses.is_sorted()
}

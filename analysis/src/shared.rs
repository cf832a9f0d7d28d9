//! Tags that several scopes share: VAR_GLOBAL tags, and direct addresses.
//!
//! A body knows a shared tag under an entry of its own, which leads to the tag itself; types, constants and uses
//! are those of the tag.

use crate::context::Context;
use crate::scope::{Origin, SectionKind, TagFacts};
use ladder_syntax::Name;
use std::collections::HashMap;

/// Leads what is shared to where it is declared. To be done when all uses are known, before types are inferred.
pub(crate) fn share(context: &mut Context) {
    if context.scopes.len() == 1 {
        return;
    }
    let mut globals: HashMap<Name, (usize, usize)> = HashMap::new();
    for (scope, facts) in context.scopes.iter().enumerate() {
        for (tag, facts) in facts.tags.iter().enumerate() {
            if facts.origin == Origin::Declared(SectionKind::Global) {
                globals.entry(Name::new(&facts.name)).or_insert((scope, tag));
            }
        }
    }
    for scope in 0..context.scopes.len() {
        for tag in 0..context.scopes[scope].tags.len() {
            let facts = &context.scopes[scope].tags[tag];
            let target = match facts.origin {
                Origin::Undeclared | Origin::Declared(SectionKind::External) => {
                    globals.get(&Name::new(&facts.name)).copied()
                }
                // An address is one tag for the whole file.
                Origin::Form if scope > 0 && facts.address.is_some() => Some(of_file(context, scope, tag)),
                _ => None,
            };
            if let Some(target) = target.filter(|target| target.0 != scope) {
                lead(context, (scope, tag), target);
            }
        }
    }
}

/// The file's entry for an address that a body uses.
fn of_file(context: &mut Context, scope: usize, tag: usize) -> (usize, usize) {
    let facts = &context.scopes[scope].tags[tag];
    if let Some(found) = context.scopes[0].find(&Name::new(&facts.name)) {
        return (0, found);
    }
    let facts = TagFacts {
        uses: Vec::new(),
        ..facts.clone()
    };
    (0, context.scopes[0].add(facts))
}

fn lead(context: &mut Context, from: (usize, usize), to: (usize, usize)) {
    let target = &context.scopes[to.0].tags[to.1];
    let (ty, role, constant, retain, at) =
        (target.ty, target.role, target.constant, target.retain, target.at);
    let entry = &mut context.scopes[from.0].tags[from.1];
    entry.shared = Some(to);
    if !entry.is_declared() {
        entry.origin = Origin::Shared;
        entry.at = at;
    }
    (entry.ty, entry.role, entry.constant, entry.retain) = (ty, role, constant, retain);
    let uses = entry.uses.clone();
    context.scopes[to.0].tags[to.1].uses.extend(uses);
}

//! `duplicate-declaration`: two names of one direct address do not agree on what it holds.

use crate::context::Context;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::Rule;
use crate::mistakes::one_address::{HELP, Said, disagreement};
use crate::names::scope::TagFacts;
use ladder_syntax::Name;
use rustc_hash::FxHashMap;

/// Looks at the tags that have an address.
pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let mut together: FxHashMap<Name, Names<'_>> = FxHashMap::default();
    // What is declared says more of an address than the address itself.
    let (declared, others): (Vec<&TagFacts>, Vec<&TagFacts>) =
        context.addressed().partition(|tag| tag.is_declared());
    for tag in declared.into_iter().chain(others).filter(|tag| !tag.mistyped) {
        let Some(address) = tag.rare.address.as_deref() else {
            continue;
        };
        let Some(names) = together.get_mut(&Name::new(address)) else {
            let names = Names {
                first: tag,
                with_value: tag,
            };
            together.insert(Name::new(address), names);
            continue;
        };
        let all = [names.first, names.with_value].into_iter();
        let mut found = all.filter_map(|first| otherwise(context, first, tag, address));
        if let Some(found) = found.next() {
            out.push(found);
        } else if names.with_value.rare.initial.is_empty() {
            names.with_value = tag;
        }
    }
}

/// The names of an address above one.
struct Names<'c> {
    first: &'c TagFacts,
    /// The first that says what it starts with, if one does.
    with_value: &'c TagFacts,
}

fn otherwise(context: &Context, first: &TagFacts, second: &TagFacts, address: &str) -> Option<Diagnostic> {
    let mut said = Said::from(second);
    if !second.is_declared() && second.uses.writers().next().is_none() {
        // It is only read: what is CONSTANT may be.
        said.constant = first.constant;
    }
    let message = disagreement(first.into(), said, address)?;
    let found = Diagnostic::new(Rule::DuplicateDeclaration, context.place_of(second), message).help(HELP);
    Some(found.related(
        context.place_of(first),
        format!("`{}` is declared here", first.name),
    ))
}

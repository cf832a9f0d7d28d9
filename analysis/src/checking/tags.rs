//! What is found at the places of tags.

use crate::context::Context;
use crate::findings::diagnostic::Diagnostic;
use crate::networks::control_flow::ControlFlow;
use crate::rules::{self, AroundTags};
use crate::still_wanted::StillWanted;

/// Asks the rules about tags. None if that is not wanted any longer.
pub(super) fn check(
    context: &Context,
    any: ControlFlow,
    wanted: &StillWanted<'_>,
) -> Option<Vec<Diagnostic>> {
    let around = AroundTags::of(context, any);
    let mut found = Vec::new();
    for (scope, facts) in context.scopes.iter().enumerate() {
        for tag in facts.tags.iter().filter(|tag| !tag.leads_elsewhere()) {
            wanted.one_more()?;
            rules::of_tag((scope, tag), &around, &mut found);
        }
    }
    Some(found)
}

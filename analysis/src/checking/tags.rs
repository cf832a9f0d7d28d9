//! What is found at the places of tags.

use crate::cancel::Cancel;
use crate::findings::diagnostic::Diagnostic;
use crate::names::context::Context;
use crate::networks::control_flow::ControlFlow;
use crate::rules::Checks;
use crate::rules::tag_view::{AroundTags, TagView};

/// Asks the rules about tags. `any` is what the networks have together of program flow. None if that is cancelled.
pub(super) fn check(
    rules: &Checks,
    context: &Context,
    any: ControlFlow,
    cancel: &Cancel,
) -> Option<Vec<Diagnostic>> {
    let around = AroundTags::of(context, any);
    let mut found = Vec::new();
    for (scope, facts) in context.scopes.iter().enumerate() {
        for tag in facts.tags.iter().filter(|tag| !tag.is_alias()) {
            cancel.one_more()?;
            let view = TagView::new(scope, tag, &around);
            rules.tag(&view, &mut found);
        }
    }
    Some(found)
}

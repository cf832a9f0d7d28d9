//! `type-mismatch`, where two places ask for two types of one undeclared tag.

use crate::context::Context;
use crate::findings::diagnostic::Diagnostic;
use crate::mistakes::type_mismatch;
use crate::names::infer;
use crate::names::scope::TagFacts;

/// Looks at the places of one tag.
pub(super) fn check(context: &Context, tag: &TagFacts, out: &mut Vec<Diagnostic>) {
    if !tag.is_inferred() || tag.mistyped {
        return;
    }
    let disagreeing = infer::disagreeing(context, tag).into_iter();
    out.extend(disagreeing.map(|(first, second)| type_mismatch::two_answers(&tag.name, first, second)));
}

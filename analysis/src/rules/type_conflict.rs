//! `type-mismatch`, where two places ask for two types of one undeclared tag.

use super::tag_view::TagView;
use crate::findings::diagnostic::Diagnostic;
use crate::names::infer;
use crate::rules::type_mismatch;

/// Looks at the places of one tag.
pub(super) fn check(view: &TagView<'_>, out: &mut Vec<Diagnostic>) {
    let (context, tag) = (view.context, view.tag);
    if !tag.is_inferred() || tag.mistyped {
        return;
    }
    let disagreeing = infer::disagreeing(context, tag).into_iter();
    out.extend(disagreeing.map(|(first, second)| type_mismatch::two_answers(&tag.name, first, second)));
}

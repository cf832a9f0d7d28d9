//! `input-written`: a block writes a tag that is fed from outside.

use super::tag_view::TagView;
use crate::findings::article::with_article;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::program::Role;

pub(crate) const RULE: Rule =
    Rule(&RuleFacts::new(RuleGroup::Names, "input-written", Severity::Warning).about_types());

pub(super) fn check(view: &TagView<'_>, out: &mut Vec<Diagnostic>) {
    let tag = view.tag;
    // In a body a name says nothing: `I1` there is undeclared.
    let in_body = view.scope > 0 && !tag.is_declared();
    if tag.mistyped || tag.role != Role::Input || view.places.writes == 0 || tag.constant || in_body {
        return;
    }
    let mut writers = view.context.writers(tag).filter(|place| {
        let bound = view.context.networks.at(place.network).block(place.block);
        // Of an unknown block nobody knows what it writes.
        !bound.faulty && bound.instruction().is_some()
    });
    let Some(first) = writers.next() else { return };
    let (what, why) = if view.scope == 0 {
        ("input", "the next reading of the inputs overwrites it")
    } else {
        (
            "input of the block",
            "its caller gives it again each time the block runs",
        )
    };
    let mut found = Diagnostic::new(
        RULE,
        first.range,
        format!(
            "`{}` is {}, and is written here: {why}",
            tag.name,
            with_article(what)
        ),
    )
    .help("write a tag of its own, and read that instead of the input where it is needed");
    for other in writers {
        found = found.related(other.range, format!("`{}` is written here as well", tag.name));
    }
    if tag.is_declared() {
        found = found.related(
            tag.declared_at,
            format!("`{}` is declared as an input here", tag.name),
        );
    }
    out.push(found);
}

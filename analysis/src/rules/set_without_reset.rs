//! `set-without-reset` and `reset-without-set`: a tag that is only ever set, or only ever reset.

use super::tag_view::TagView;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity, When};
use crate::program::Role;

pub(crate) const RULE: Rule =
    Rule(&RuleFacts::new(RuleGroup::Program, "set-without-reset", Severity::Info).when(When::Whole));

pub(super) fn check(view: &TagView<'_>, out: &mut Vec<Diagnostic>) {
    let tag = view.tag;
    if !view.is_all_known() {
        return;
    }
    let (all_set, all_reset) = (
        view.places.sets == view.places.writes,
        view.places.resets == view.places.writes,
    );
    // An input that is written is reported by input-written.
    if tag.role == Role::Input || view.places.writes == 0 || !(all_set || all_reset) {
        return;
    }
    let name = &tag.name;
    let (rule, message, help) = if all_set {
        (
            RULE,
            format!("`{name}` is set, and nothing resets it: once on, it stays on"),
            format!("reset it with (R)( {name} ); or write ( )( {name} ) if it should follow the power"),
        )
    } else if tag.cold.initial.is_empty() {
        (
            super::reset_without_set::RULE,
            format!("`{name}` is reset, and nothing sets it: it is never on"),
            format!("set it with (S)( {name} ), or remove the reset"),
        )
    } else {
        // It begins switched on.
        return;
    };
    let mut writers = view.context.writers(tag);
    let Some(first) = writers.next() else { return };
    let mut found = Diagnostic::new(rule, first.range, message).help(help);
    for other in writers {
        found = found.related(other.range, format!("`{name}` is written here as well"));
    }
    out.push(found);
}

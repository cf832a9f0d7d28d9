//! `set-without-reset` and `reset-without-set`: a tag that is only ever set, or only ever reset.

use super::tag_summary::Summary;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::Rule;
use crate::program::Role;

pub(super) fn check(summary: &Summary<'_>, out: &mut Vec<Diagnostic>) {
    let tag = summary.tag;
    let (all_set, all_reset) = (
        summary.places.sets == summary.places.writes,
        summary.places.resets == summary.places.writes,
    );
    // An input that is written is reported by input-written.
    if tag.role == Role::Input || summary.places.writes == 0 || !(all_set || all_reset) {
        return;
    }
    let name = &tag.name;
    let (rule, message, help) = if all_set {
        (
            Rule::SetWithoutReset,
            format!("`{name}` is set, and nothing resets it: once on, it stays on"),
            format!("reset it with (R)( {name} ); or write ( )( {name} ) if it should follow the power"),
        )
    } else if tag.rare.initial.is_empty() {
        (
            Rule::ResetWithoutSet,
            format!("`{name}` is reset, and nothing sets it: it is never on"),
            format!("set it with (S)( {name} ), or remove the reset"),
        )
    } else {
        // It begins switched on.
        return;
    };
    let mut writers = summary.context.writers(tag);
    let Some(first) = writers.next() else { return };
    let mut found = Diagnostic::new(rule, first.range, message).help(help);
    for other in writers {
        found = found.related(other.range, format!("`{name}` is written here as well"));
    }
    out.push(found);
}

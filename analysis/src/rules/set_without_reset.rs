//! `set-without-reset` and `reset-without-set`: a tag that is only ever set, or only ever reset.

use super::parts::Part;
use super::tag_view::TagView;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity, When};
use crate::networks::use_place::UseRef;
use crate::program::Role;

pub(crate) const RULE: Rule =
    Rule(&RuleFacts::new(RuleGroup::Program, "set-without-reset", Severity::Info).when(When::Whole));

pub(super) fn check(view: &TagView<'_>, out: &mut Vec<Diagnostic>) {
    // An input that is written is reported by input-written.
    let is_latched = view.places.sets > 0 || view.places.resets > 0;
    if !is_latched || view.unread.written || !view.is_all_known() || view.tag.role == Role::Input {
        return;
    }
    out.extend(view.parts().filter_map(|part| in_part(view, &part)));
}

fn in_part(view: &TagView<'_>, part: &Part<'_>) -> Option<Diagnostic> {
    let (name, touched) = (part.name, &part.touched);
    let (rule, message, help) = if touched.writes == 0 {
        return None;
    } else if touched.sets == touched.writes {
        (
            RULE,
            format!("`{name}` is set, and nothing resets it: once on, it stays on"),
            format!("reset it with (R)( {name} ); or write ( )( {name} ) if it should follow the power"),
        )
    } else if touched.resets == touched.writes && view.tag.cold.initial.is_empty() {
        (
            super::reset_without_set::RULE,
            format!("`{name}` is reset, and nothing sets it: it is never on"),
            format!("set it with (S)( {name} ), or remove the reset"),
        )
    } else {
        // A tag with an initial value begins switched on.
        return None;
    };
    let mut writers = part.own.iter().filter(|place| place.access().writes());
    let range = |place: &UseRef| view.context.networks.use_of(*place).range;
    let mut found = Diagnostic::new(rule, range(writers.next()?), message).help(help);
    for other in writers {
        found = found.related(range(other), format!("`{name}` is written here as well"));
    }
    Some(found)
}

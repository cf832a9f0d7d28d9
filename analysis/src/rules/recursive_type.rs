//! `recursive-type`: a type that contains itself, directly or through others. It would have parts without end.

use super::circles::way;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use ladder_syntax::TextRange;
use smol_str::SmolStr;

pub(crate) const RULE: Rule = Rule(&RuleFacts::new(
    RuleGroup::Names,
    "recursive-type",
    Severity::Error,
));

/// The types of the circle, the first of which is named again at this place.
pub(crate) fn recursive(names: &[SmolStr], at: TextRange) -> Diagnostic {
    let first = names.first().map_or("", SmolStr::as_str);
    let message = match names {
        [] | [_] => format!("the type `{first}` contains itself"),
        [_, others @ ..] => {
            let names: Vec<String> = others
                .iter()
                .chain(names.first())
                .map(|name| format!("`{name}`"))
                .collect();
            let through = way(names.into_iter(), ", which contains ");
            format!("the type `{first}` contains itself: it contains {through}")
        }
    };
    Diagnostic::new(RULE, at, message).help(
        "a tag of such a type would have parts without end: break the circle, for instance with an index",
    )
}

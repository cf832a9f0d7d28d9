//! `unknown-function`: a `<CALL>` names no function.

use super::near_names::{self, Meant};
use crate::findings::diagnostic::{Applicability, Diagnostic};
use crate::findings::did_you_mean;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::names::context::Context;
use ladder_syntax::TextRange;

pub(crate) const RULE: Rule =
    Rule(&RuleFacts::new(RuleGroup::Names, "unknown-function", Severity::Error).fixed(Applicability::Unsafe));

pub(crate) fn unknown(context: &Context, name: &str, range: TextRange) -> Diagnostic {
    let found = Diagnostic::new(RULE, range, format!("there is no function `{name}`"));
    let own = context.functions.iter().map(|f| f.name.as_str());
    let names = own.chain(context.others.function_names());
    match did_you_mean::closest(name, names) {
        Some(near) => near_names::ask(found, name, near, Meant::name(near, "Call", range)),
        None => found.help(format!(
            "a function begins with a network that holds <FUN>( {name} )"
        )),
    }
}

//! `unused-type`: a declared type that nothing uses.

use super::survey::Survey;
use super::type_members;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity, When};

pub(crate) const RULE: Rule = Rule(
    &RuleFacts::new(RuleGroup::Program, "unused-type", Severity::Info)
        .when(When::Whole)
        .without_effect(),
);

pub(super) fn check(survey: &Survey<'_>, out: &mut Vec<Diagnostic>) {
    let context = survey.context;
    if !survey.whole {
        return;
    }
    type_members::check(survey, out);
    for ty in context.types.own() {
        let key = &ty.declaration.key;
        let is_used = context.types.mentioned.contains(key)
            || context.others.mentions_type(key)
            || context.names_value_of(key);
        if !is_used {
            let place = if context.others.have_files() {
                "no file of the workspace"
            } else {
                "nothing in this file"
            };
            let name = &ty.declaration.name;
            let message = format!("{place} uses the type `{name}`");
            out.push(
                Diagnostic::new(RULE, ty.declaration.at, message).help("declare a tag with it, or remove it"),
            );
        }
    }
}

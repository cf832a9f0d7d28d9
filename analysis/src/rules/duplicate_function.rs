//! `duplicate-function`: a function is defined twice in a file. Calls of one that several other files define are found
//! while operands are resolved.

use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::names::context::Context;
use ladder_syntax::{Name, TextRange};
use rustc_hash::FxHashMap;

pub(crate) const RULE: Rule = Rule(&RuleFacts::new(
    RuleGroup::Names,
    "duplicate-function",
    Severity::Error,
));

pub(crate) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let mut first = FxHashMap::default();
    for function in &context.functions {
        match first.get(&function.key) {
            None => {
                first.insert(&function.key, function);
            }
            Some(before) => out.push(
                Diagnostic::new(
                    RULE,
                    function.at,
                    format!("the function `{}` is defined twice", function.name),
                )
                .help("remove one of the functions, or give one of them another name")
                .related(before.at, format!("`{}` is first defined here", before.name)),
            ),
        }
    }
}

/// A `<CALL>` of a function that the file does not have, and several others do.
pub(crate) fn of_several_files(context: &Context, name: &str, range: TextRange) -> Option<Diagnostic> {
    let key = Name::new(name);
    context.others.functions(&key).nth(1)?;
    let mut found = Diagnostic::new(
        RULE,
        range,
        format!("several files define the function `{name}`: which one is called here is open"),
    )
    .help("rename all but one of them, or define the function in this file");
    for (file, function) in context.others.functions(&key) {
        found = found.related_in(&file.file, function.at, "it is defined here");
    }
    Some(found)
}

//! `library-name`: a block that takes the place of one of the library.

use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::library;
use crate::names::context::Context;
use ladder_syntax::Name;

pub(crate) const RULE: Rule = Rule(
    &RuleFacts::new(RuleGroup::Names, "library-name", Severity::Info)
        .without_effect()
        .off(),
);

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    if library::source(&context.name).is_some() {
        return;
    }
    for block in &context.user_blocks[..context.own_blocks] {
        let is_it = |source: &&library::Source| Name::new(source.name) == block.key;
        if let Some(shipped) = library::SOURCES.iter().find(is_it) {
            let name = shipped.name;
            let message =
                format!("the library has a block {name} too: programs of this workspace are given this one");
            let help =
                format!("give it another name, unless it is meant to take the place of the library's {name}");
            out.push(Diagnostic::new(RULE, block.at, message).help(help));
        }
    }
}

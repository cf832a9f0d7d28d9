//! `unknown-block`: a user-defined block that no file defines, or that is drawn in another shape.

use super::form::Form;
use super::near_names::{self, Meant};
use crate::findings::diagnostic::{Applicability, Diagnostic};
use crate::findings::did_you_mean;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::names::context::Context;
use crate::networks::BlockAt;
use crate::networks::network::Meaning;
use ladder_syntax::Name;

pub(crate) const RULE: Rule =
    Rule(&RuleFacts::new(RuleGroup::Names, "unknown-block", Severity::Error).fixed(Applicability::Safe));

pub(super) fn check(form: &Form<'_>, out: &mut Vec<Diagnostic>) {
    // A network with a block that is not known may name one of another file.
    let Some(context) = form.file else { return };
    for bound in form.network.blocks() {
        if matches!(bound.meaning, Meaning::UnknownUser) && !bound.faulty {
            out.push(unknown(context, bound));
        }
    }
}

fn unknown(context: &Context, bound: BlockAt<'_>) -> Diagnostic {
    let (range, written) = (bound.head_range(), bound.head_text());
    let name = bound.facts.head.text();
    let key = Name::new(name);
    let in_brackets = |name: &str| {
        let (open, close) = bound.facts.shape.brackets();
        format!("{open}{name}{close}")
    };
    let own = context.user_blocks.iter().find(|block| block.key == key);
    if let Some(definition) = own {
        let (open, close) = definition.shape.brackets();
        let right = format!("{open}{}{close}", definition.name);
        return Diagnostic::new(
            super::wrong_shape::RULE,
            range,
            format!("the block is drawn {right}, not {written}"),
        )
        .help("a block keeps the brackets of its definition")
        .related_at(definition.file(), definition.at, "it is defined here")
        // One name has one shape.
        .fix(Applicability::Safe, format!("Replace with {right}"), range, right);
    }
    let found = Diagnostic::new(RULE, range, format!("there is no block {written}"));
    let others = context.others.all_blocks().map(|(_, block)| &block.facts);
    let same_shape = context
        .user_blocks
        .iter()
        .chain(others)
        .filter(|block| block.shape == bound.facts.shape);
    match did_you_mean::closest(name, same_shape.map(|block| block.name.as_str())) {
        Some(near) => {
            let written = in_brackets(near);
            let meant = Meant {
                shown: written.clone(),
                title: format!("Replace with {written}"),
                range,
                written,
            };
            near_names::ask(found, name, near, meant)
        }
        None => found.help(format!(
            "define it: FUNCTION_BLOCK {written}, its declarations and rungs, END_FUNCTION_BLOCK"
        )),
    }
}

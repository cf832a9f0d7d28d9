//! `duplicate-instance`: two blocks that work on one state.

use super::parts;
use super::tag_view::TagView;
use crate::boolean::written::written;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::networks::network::Formal;
use crate::networks::use_kind::Effect;
use crate::networks::use_place::Use;
use crate::values::types::Type;
use ladder_syntax::Name;
use rustc_hash::FxHashMap;
use std::collections::hash_map::Entry;

pub(crate) const RULE: Rule = Rule(&RuleFacts::new(
    RuleGroup::Names,
    "duplicate-instance",
    Severity::Warning,
));

pub(super) fn check(view: &TagView<'_>, out: &mut Vec<Diagnostic>) {
    let (context, tag) = (view.context, view.tag);
    if !matches!(tag.ty, Some(Type::Compound(_))) {
        return;
    }
    let mut first: FxHashMap<Name, Use> = FxHashMap::default();
    for place in tag
        .uses
        .0
        .iter()
        .filter(|place| place.effect() == Effect::KeepsState)
    {
        if !matches!(context.networks.formal_of(*place), Formal::Instance) {
            continue;
        }
        let second = context.networks.use_of(*place);
        let network = context.networks.at(second.network);
        let block = network.block(second.block);
        let operand = &block.facts.operands[second.operand].value;
        let path = written(context, network.scope, operand);
        let key = parts::fixed(context, network.scope, operand).unwrap_or_else(|| path.clone());
        match first.entry(Name::new(&key)) {
            Entry::Vacant(free) => {
                free.insert(second);
            }
            Entry::Occupied(first) => {
                let head = block.head_text();
                let message = format!("a second {head} works on `{path}`: what one does the other sees");
                out.push(
                    Diagnostic::new(RULE, second.range, message)
                        .help("give each block a state of its own, unless both are meant to share it")
                        .related(first.get().range, format!("`{path}` is the state of this block")),
                );
            }
        }
    }
}

//! `duplicate-block`: a user-defined block is defined twice in a file, or in two other files of which this one uses
//! it: which of them is meant?

use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::names::context::Context;
use crate::networks::NetworkAt;
use ladder_syntax::Name;
use std::collections::{HashMap, HashSet};

pub(crate) const RULE: Rule = Rule(&RuleFacts::new(
    RuleGroup::Names,
    "duplicate-block",
    Severity::Error,
));

pub(crate) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let own = &context.user_blocks[..context.own_blocks];
    let mut first = HashMap::new();
    for block in own.iter().filter(|block| !block.name.is_empty()) {
        match first.get(&block.key) {
            None => {
                first.insert(&block.key, block);
            }
            Some(before) => out.push(
                Diagnostic::new(
                    RULE,
                    block.at,
                    format!("the block `{}` is defined twice", block.name),
                )
                .help("remove one of the definitions, or give one block another name; one name has one shape")
                .related(before.at, format!("`{}` is first defined here", before.name)),
            ),
        }
    }
    let imported = context.user_blocks[context.own_blocks..].iter();
    let doubtful: HashSet<&Name> = imported
        .map(|block| &block.key)
        .filter(|key| context.others.blocks(key).nth(1).is_some())
        .collect();
    if doubtful.is_empty() {
        return;
    }
    for bound in context.networks.iter().flat_map(NetworkAt::blocks) {
        let Some(name) = bound.user_name() else { continue };
        let key = Name::new(name);
        if !doubtful.contains(&key) {
            continue;
        }
        let mut found = Diagnostic::new(
            RULE,
            bound.head_range(),
            format!(
                "several files define the block `{name}`: which one {} means is open",
                bound.head_text()
            ),
        )
        .help("rename all but one of them, or define the block in this file");
        for (file, block) in context.others.blocks(&key) {
            found = found.related_in(&file.file, block.facts.at, "it is defined here");
        }
        out.push(found);
    }
}

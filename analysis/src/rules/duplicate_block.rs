//! `duplicate-block`: a user-defined block is defined twice.

use crate::context::Context;
use crate::diagnostic::Diagnostic;
use crate::rule::Rule;
use std::collections::HashMap;

pub(crate) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let mut first = HashMap::new();
    for block in context.user_blocks.iter().filter(|block| !block.name.is_empty()) {
        match first.get(&block.key) {
            None => {
                first.insert(&block.key, block);
            }
            Some(before) => out.push(
                Diagnostic::new(
                    Rule::DuplicateBlock,
                    block.at,
                    format!("the block `{}` is defined twice", block.name),
                )
                .help("remove one of the definitions, or give one block another name; one name has one shape")
                .related(before.at, format!("`{}` is first defined here", before.name)),
            ),
        }
    }
}

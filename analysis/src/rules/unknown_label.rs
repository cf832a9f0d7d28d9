//! `unknown-label` where a `<$B>` block jumps out of its body. Other jumps are found while operands are resolved.

use super::near_names::{self, Meant};
use crate::exporting::outward_jumps::{Jump, outward_jumps};
use crate::findings::diagnostic::{Applicability, Diagnostic};
use crate::findings::did_you_mean;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::names::context::{Body, Context};
use crate::networks::network::Meaning;
use ladder_instructions::Shape;
use ladder_syntax::{Name, TextRange};
use std::collections::HashSet;
use std::sync::Arc;

pub(crate) const RULE: Rule =
    Rule(&RuleFacts::new(RuleGroup::Names, "unknown-label", Severity::Error).fixed(Applicability::Unsafe));

/// Jumps out of the bodies of `<$B>` blocks: such a label is looked up where the block is, and must be there
/// at every place.
pub(crate) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let is_open = |block: usize| context.user_blocks[block].shape == Shape::Function;
    if !(0..context.user_blocks.len()).any(is_open) {
        return;
    }
    let uses = places(context);
    let mut jumps = outward_jumps(context);
    for block in (context.own_blocks..context.user_blocks.len()).filter(|&block| is_open(block)) {
        foreign_jumps(context, block, &mut jumps);
    }
    let mut seen: HashSet<(usize, Name)> = jumps.iter().map(|jump| (jump.block, jump.key.clone())).collect();
    while let Some(jump) = jumps.pop() {
        for &(network, at) in &uses[jump.block] {
            if context.jump_target(network, &jump.key).is_some() {
                continue;
            }
            match context.bodies[network] {
                // Looked up one place further out.
                Body::Block(outer) if is_open(outer) => {
                    if seen.insert((outer, jump.key.clone())) {
                        jumps.push(Jump {
                            block: outer,
                            ..jump.clone()
                        });
                    }
                }
                _ => out.push(nowhere(context, &jump, at)),
            }
        }
    }
}

fn nowhere(context: &Context, jump: &Jump, place: TextRange) -> Diagnostic {
    match &jump.file {
        None => Diagnostic::new(
            RULE,
            jump.at,
            format!(
                "there is no label `{}` in the block, nor where the block is",
                jump.name
            ),
        )
        .help("put the label into the block, or at each place that uses the block")
        .related(place, "here the block is, and no label of this name"),
        // The other file is not wrong by itself.
        Some(file) => Diagnostic::new(
            RULE,
            place,
            format!(
                "the block `{}` jumps to the label `{}`, which is not here",
                context.user_blocks[jump.block].name, jump.name
            ),
        )
        .help(format!("mark a network with <LBL>( {} )", jump.name))
        .related_in(file, jump.at, "this is the jump"),
    }
}

/// The jumps out of a block of another file, and out of the blocks in it.
fn foreign_jumps(context: &Context, block: usize, jumps: &mut Vec<Jump>) {
    let key = &context.user_blocks[block].key;
    let Some((file, exported)) = context.others.blocks(key).next() else {
        return;
    };
    // Each block with the labels that those around it have.
    let mut open = vec![(Arc::clone(&file.file), exported, HashSet::<&Name>::new())];
    let mut seen = HashSet::new();
    while let Some((file, exported, mut around)) = open.pop() {
        if exported.facts.shape != Shape::Function || !seen.insert((Arc::clone(&file), exported.item)) {
            continue;
        }
        around.extend(&exported.own_labels);
        for (label, at) in &exported.labels {
            if !around.contains(label) {
                jumps.push(Jump {
                    block,
                    key: label.clone(),
                    name: label.as_str().into(),
                    at: *at,
                    file: Some(Arc::clone(&file)),
                });
            }
        }
        for (used, _) in &exported.uses {
            let mut all = context.others.blocks(used);
            let own = all.find(|(other, _)| other.file == file);
            if let Some((file, inner)) = own.or_else(|| context.others.blocks(used).next()) {
                open.push((Arc::clone(&file.file), inner, around.clone()));
            }
        }
    }
}

/// For each user-defined block the networks that it is in, and where.
fn places(context: &Context) -> Vec<Vec<(usize, TextRange)>> {
    let mut places = vec![Vec::new(); context.user_blocks.len()];
    for (index, network) in context.networks.iter().enumerate() {
        for bound in network.blocks() {
            if let Meaning::User(block) = bound.meaning {
                places[block].push((index, bound.head_range()));
            }
        }
    }
    places
}

pub(crate) fn unknown(context: &Context, network: usize, name: &str, range: TextRange) -> Diagnostic {
    let body = context.bodies[network];
    let found = Diagnostic::new(RULE, range, format!("there is no label `{name}` to jump to"));
    let seen = context
        .labels
        .iter()
        .filter(|label| context.bodies[label.network] == body);
    if let Some(near) = did_you_mean::closest(name, seen.map(|label| label.name.as_str())) {
        return near_names::ask(found, name, near, Meant::name(near, "Jump to", range));
    }
    let key = Name::new(name);
    match context.labels.iter().find(|label| label.key == key) {
        Some(elsewhere) => found
            .help("a jump stays in its own program or function: put a label there, or use <CALL>")
            .related(
                elsewhere.at,
                "the label of this name belongs to another function or block",
            ),
        None => found.help(format!("mark the network with <LBL>( {name} )")),
    }
}

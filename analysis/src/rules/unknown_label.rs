//! `unknown-label`: a `<JMP>` goes to a label that its program or function does not have.

use super::did_you_mean;
use crate::context::{Body, Context};
use crate::diagnostic::Diagnostic;
use crate::facts::NodeKind;
use crate::network::Meaning;
use crate::rule::Rule;
use ladder_instructions::{Op, Shape};
use ladder_syntax::{Name, TextRange};
use std::collections::HashSet;

pub(crate) fn unknown(context: &Context, network: usize, name: &str, range: TextRange) -> Diagnostic {
    let body = context.bodies[network];
    let found = Diagnostic::new(
        Rule::UnknownLabel,
        range,
        format!("there is no label `{name}` to jump to"),
    );
    let seen = context
        .labels
        .iter()
        .filter(|label| context.bodies[label.network] == body);
    if let Some(near) = did_you_mean::closest(name, seen.map(|label| label.name.as_str())) {
        return found
            .help(format!("did you mean `{near}`?"))
            .fix(format!("Jump to `{near}`"), range, near);
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

/// Jumps out of the bodies of `<$B>` blocks: such a label is looked up where the block stands, and must be there
/// at every place.
pub(crate) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let is_open = |block: usize| context.user_blocks[block].shape == Shape::Function;
    if !(0..context.user_blocks.len()).any(is_open) {
        return;
    }
    let uses = places(context);
    let mut jumps = outward_jumps(context);
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
                _ => out.push(
                    Diagnostic::new(
                        Rule::UnknownLabel,
                        jump.at,
                        format!(
                            "there is no label `{}` in the block, nor where the block stands",
                            jump.name
                        ),
                    )
                    .help("put the label into the block, or at each place that uses the block")
                    .related(at, "here the block stands, and no label of this name"),
                ),
            }
        }
    }
}

/// A jump in the body of a `<$B>` to a label that the body does not have.
#[derive(Clone)]
struct Jump {
    /// The block whose places must have the label.
    block: usize,
    key: Name,
    name: Box<str>,
    at: TextRange,
}

fn outward_jumps(context: &Context) -> Vec<Jump> {
    let mut jumps = Vec::new();
    for (index, network) in context.networks.iter().enumerate() {
        let Body::Block(block) = context.bodies[index] else {
            continue;
        };
        if context.user_blocks[block].shape != Shape::Function {
            continue;
        }
        for bound in network
            .blocks
            .iter()
            .filter(|bound| bound.op() == Some(Op::Jmp) && !bound.faulty)
        {
            let Some(operand) = bound.facts.operands.first() else {
                continue;
            };
            let NodeKind::Name(name) = &operand.value.kind else {
                continue;
            };
            let key = Name::new(name);
            if context.jump_target(index, &key).is_none() {
                jumps.push(Jump {
                    block,
                    key,
                    name: name.as_str().into(),
                    at: bound.absolute(operand.value.range),
                });
            }
        }
    }
    jumps
}

/// For each user-defined block the networks that it stands in, and where.
fn places(context: &Context) -> Vec<Vec<(usize, TextRange)>> {
    let mut places = vec![Vec::new(); context.user_blocks.len()];
    for (index, network) in context.networks.iter().enumerate() {
        for bound in &network.blocks {
            if let Meaning::User(block) = bound.meaning {
                places[block].push((index, bound.head_range()));
            }
        }
    }
    places
}

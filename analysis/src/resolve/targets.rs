//! What the bodies of a file use: functions and blocks, its own and those of other files.

use crate::names::context::{Body, Callee, Context};
use crate::networks::network::Meaning;
use crate::written::facts::NodeKind;
use crate::written::import::Import;
use ladder_instructions::Op;
use ladder_syntax::Name;
use rustc_hash::FxHashMap;

/// What a body calls, or holds.
#[derive(Debug, Clone)]
pub(crate) enum Target {
    /// A body of its own file.
    Own(Body),
    /// A function of another file.
    Function(Import),
    /// A block of another file.
    Block(Import),
}

/// What each body of a file uses.
pub(crate) fn targets(context: &Context) -> FxHashMap<Body, Vec<Target>> {
    let mut targets: FxHashMap<Body, Vec<Target>> = FxHashMap::default();
    for (network, &body) in context.networks.iter().zip(context.bodies.iter()) {
        for bound in network.blocks() {
            let target = match bound.meaning {
                Meaning::User(index) => match &context.user_blocks[index].import {
                    Some(import) => Some(Target::Block(import.clone())),
                    None => Some(Target::Own(Body::Block(index))),
                },
                Meaning::Instruction(row) if row.op == Op::Call => {
                    let operand = bound.facts.operands.first();
                    let callee = operand.and_then(|operand| match &operand.value.kind {
                        NodeKind::Name(name) => context.callee(&Name::new(name)),
                        _ => None,
                    });
                    callee.map(|callee| match callee {
                        Callee::Own(function) => Target::Own(Body::Function(function)),
                        Callee::Other(import) => Target::Function(import),
                    })
                }
                _ => None,
            };
            if let Some(target) = target {
                targets.entry(body).or_default().push(target);
            }
        }
    }
    targets
}

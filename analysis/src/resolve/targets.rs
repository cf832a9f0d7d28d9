//! What the bodies of a file use: functions and blocks, its own and those of other files.

use crate::names::context::{Body, Callee, Context};
use crate::networks::network::Meaning;
use crate::values::types::Type;
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

/// The blocks whose states each body of a file names, also where it does not run them: what they hold is in their definitions.
pub(crate) fn held(context: &Context) -> FxHashMap<Body, Vec<Target>> {
    let mut held: FxHashMap<Body, Vec<Target>> = FxHashMap::default();
    for (network, &body) in context.networks.iter().zip(context.bodies.iter()) {
        let tags = &context.scopes[network.scope].tags;
        for (_, tag) in context.names_of(network).iter() {
            let Some(Type::Compound(ty)) = tags[tag].ty.filter(|ty| ty.keeps_state()) else {
                continue;
            };
            ty.each_block(&mut |name| {
                let key = Name::new(name);
                let block = context.user_blocks.iter().position(|block| block.key == key);
                let targets = held.entry(body).or_default();
                targets.extend(block.map(|index| of_block(context, index)));
            });
        }
    }
    held
}

fn of_block(context: &Context, index: usize) -> Target {
    match &context.user_blocks[index].import {
        Some(import) => Target::Block(import.clone()),
        None => Target::Own(Body::Block(index)),
    }
}

/// What each body of a file runs.
pub(crate) fn targets(context: &Context) -> FxHashMap<Body, Vec<Target>> {
    let mut targets: FxHashMap<Body, Vec<Target>> = FxHashMap::default();
    for (network, &body) in context.networks.iter().zip(context.bodies.iter()) {
        for bound in network.blocks() {
            let target = match bound.meaning {
                Meaning::User(index) => Some(of_block(context, index)),
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

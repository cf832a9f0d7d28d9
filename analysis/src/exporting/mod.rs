//! From a file to what it shows to the others.

pub(crate) mod outward_jumps;
mod outward_uses;

use crate::cancel::Cancel;
use crate::names::context::{Body, Context};
use crate::names::scope::{Origin, Scope, SectionKind};
use crate::names::skeleton::skeleton;
use crate::names::uses;
use crate::networks::network::Formal;
use crate::networks::use_kind::Extent;
use crate::other_files::exports::{ExportedBlock, ExportedFunction, Exports, Global};
use crate::other_files::others::Others;
use crate::written::facts::{Node, NodeKind};
use crate::written::user_block::UserBlockFacts;
use ladder_instructions::Accepts;
use ladder_syntax::{Name, Parse, TextRange};
use outward_jumps::outward_jumps;
use rustc_hash::FxHashSet;
use std::sync::Arc;

/// What a file shows to the others. `file` is its name in messages.
pub fn exports(parse: &Arc<Parse>, file: &str) -> Exports {
    match skeleton(parse, file, &Others::default(), None, &Cancel::default()) {
        Some(context) => Exports::of(&context, file),
        None => unreachable!("nothing cancels it"),
    }
}

impl Exports {
    /// The same, of a file that is analysed already.
    pub fn of(context: &Context, file: &str) -> Exports {
        Exports {
            file: Arc::from(file),
            functions: functions(context),
            blocks: blocks(context),
            globals: globals(context),
            types: context
                .types
                .own()
                .iter()
                .map(|ty| ty.declaration.clone())
                .collect(),
            mentioned_types: mentioned_types(context),
            states: states(context),
            outward: outward_uses::of(context),
        }
    }
}

/// A block as its file says by itself: what a name of a type means depends on other files.
fn as_written(facts: &UserBlockFacts) -> UserBlockFacts {
    let mut facts = facts.clone();
    for parameter in facts
        .parameters
        .iter_mut()
        .filter(|parameter| parameter.declared.is_some())
    {
        parameter.ty = None;
    }
    facts
}

fn functions(context: &Context) -> Vec<ExportedFunction> {
    let first = |(item, key): (usize, &Name)| context.function(key) == Some(item);
    let all = context.functions.iter().enumerate();
    all.filter(|(item, function)| first((*item, &function.key)))
        .map(|(item, function)| ExportedFunction {
            name: function.name.clone(),
            key: function.key.clone(),
            item,
            at: function.at,
        })
        .collect()
}

fn blocks(context: &Context) -> Vec<ExportedBlock> {
    let mut blocks: Vec<ExportedBlock> = context.user_blocks[..context.own_blocks]
        .iter()
        .enumerate()
        .map(|(item, facts)| ExportedBlock {
            facts: as_written(facts),
            item,
            uses: context.scopes[item + 1].block_states(),
            labels: Vec::new(),
            own_labels: Vec::new(),
        })
        .collect();
    if blocks.is_empty() {
        return blocks;
    }
    for (network, block) in context.networks_of_blocks() {
        for bound in network.blocks() {
            if let Some(name) = bound.user_name() {
                blocks[block].uses.push((Name::new(name), bound.head_range()));
            }
        }
    }
    for jump in outward_jumps(context) {
        blocks[jump.block].labels.push((jump.key, jump.at));
    }
    for label in &context.labels {
        if let Body::Block(block) = context.bodies[label.network] {
            blocks[block].own_labels.push(label.key.clone());
        }
    }
    blocks.retain(|block| !block.facts.name.is_empty());
    blocks
}

/// The names of types that a file's declarations and operands mention, sorted. Of operands each name before a point counts.
fn mentioned_types(context: &Context) -> Vec<Name> {
    let mut names: Vec<Name> = context.types.mentioned.iter().cloned().collect();
    let in_operands = context.networks.iter().flat_map(|network| &network.facts().named);
    names.extend(
        in_operands
            .filter(|named| named.kind.extent() == Extent::Member)
            .map(|named| named.key.clone()),
    );
    names.sort_unstable();
    names.dedup();
    names
}

/// The VAR_GLOBAL tags of a file.
fn globals(context: &Context) -> Vec<Global> {
    let mut globals: Vec<Global> = Vec::new();
    for tag in context.scopes.iter().flat_map(|scope| &scope.tags) {
        if tag.origin != Origin::Declared(SectionKind::Global) {
            continue;
        }
        let key = Name::new(&tag.name);
        globals.push(Global {
            name: tag.name.to_string(),
            key,
            // What a name of a type means depends on other files.
            ty: tag.ty.filter(|_| !tag.mistyped && tag.cold.declared.is_none()),
            declared: tag.cold.declared.clone(),
            role: tag.role,
            constant: tag.constant,
            retain: tag.retain,
            initial: match tag.cold.declared {
                None => tag.cold.initial.clone(),
                Some(_) => Vec::new(),
            },
            address: tag.cold.address.clone(),
            at: tag.declared_at,
        });
    }
    // Two scopes of the file may introduce one tag.
    if context.scopes.len() > 1 {
        let mut seen = FxHashSet::default();
        globals.retain(|global| seen.insert(global.key.clone()));
    }
    globals
}

fn states(context: &Context) -> Vec<(Name, TextRange)> {
    let mut states = Vec::new();
    for network in context.networks.iter().filter(|network| network.keeps_state) {
        let scope = &context.scopes[network.scope];
        for bound in network.blocks() {
            for (operand, formal) in bound.facts.operands.iter().zip(bound.formals.iter()) {
                let Some(name) = state_in(&operand.value, *formal) else {
                    continue;
                };
                let key = Name::new(name);
                if may_be_shared(context, scope, &key) {
                    states.push((key, bound.absolute(operand.value.range)));
                }
            }
        }
    }
    states
}

/// The name of the tag on which a block keeps its state, if the operand is that.
fn state_in(operand: &Node, formal: Formal) -> Option<&str> {
    match (formal, &operand.kind) {
        (Formal::Operand(row), NodeKind::Name(name)) if matches!(row.accepts, Accepts::State(_)) => {
            Some(name)
        }
        _ => None,
    }
}

/// Whether a name may be that of a tag of another file: without a declaration one that says its type is not.
fn may_be_shared(context: &Context, scope: &Scope, name: &Name) -> bool {
    match scope.find(name).map(|tag| &scope.tags[tag]) {
        Some(tag) if tag.is_declared() || tag.origin == Origin::Implicit => tag.is_outward(),
        _ => uses::undeclared(name.as_str(), context.profile.semantics()).origin == Origin::Undeclared,
    }
}

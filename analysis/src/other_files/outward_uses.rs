//! What the networks of a file do with names that it does not hold itself.

use super::outward::{Outward, TagUse};
use crate::context::Context;
use crate::networks::NetworkAt;
use crate::networks::access::Access;
use crate::networks::control_flow::ControlFlow;
use crate::networks::network::Meaning;
use crate::networks::unread_line::identifiers;
use ladder_instructions::Op;
use ladder_syntax::{LineKind, Name, Part};
use rustc_hash::{FxHashMap, FxHashSet};

/// What a file does with what other files may hold.
pub(super) fn of(context: &Context) -> Outward {
    let mut outward = Outward::default();
    for network in &context.networks {
        names(context, network, &mut outward.tags);
        if network.control_flow.has(ControlFlow::CALL) {
            calls(context, network, &mut outward.calls);
        }
    }
    for word in unread_words(context) {
        outward.tags.insert(word.clone(), TagUse::BOTH);
        outward.calls.insert(word);
    }
    outward
}

/// What the names of a network add.
fn names(context: &Context, network: NetworkAt<'_>, tags: &mut FxHashMap<Name, TagUse>) {
    let scope = &context.scopes[network.scope];
    for named in &network.named {
        let own = scope
            .find(&named.key)
            .is_some_and(|tag| !scope.tags[tag].is_outward());
        if own || named.key.as_str().starts_with('%') {
            continue;
        }
        let meaning = network.blocks[named.block as usize].meaning;
        let used = at(context, meaning, named.kind.access());
        let entry = tags.entry(named.key.clone()).or_default();
        *entry = entry.with(used);
    }
}

/// How a place uses its tag. What a block of another file does with its operands that file says.
fn at(context: &Context, meaning: Meaning, access: Access) -> TagUse {
    let known = match meaning {
        Meaning::Instruction(_) => true,
        Meaning::User(block) => context.user_blocks[block].import.is_none(),
        Meaning::Unknown | Meaning::UnknownUser => false,
    };
    if known { TagUse::of(access) } else { TagUse::BOTH }
}

/// The functions that a network calls and the file does not hold.
fn calls(context: &Context, network: NetworkAt<'_>, calls: &mut FxHashSet<Name>) {
    for bound in network.blocks().filter(|bound| bound.op() == Some(Op::Call)) {
        if let Some((name, _)) = bound.facts.first_name() {
            let key = Name::new(name);
            if context.function(&key).is_none() {
                calls.insert(key);
            }
        }
    }
}

/// The words on lines that cannot be read.
fn unread_words(context: &Context) -> FxHashSet<Name> {
    let unread = |line: &&ladder_syntax::Line| !line.errors.is_empty() || line.kind == LineKind::Stray;
    let faulty = context.parse.lines().of_parts_that(Part::is_faulty);
    let lines = faulty.map(|(_, line)| line).filter(unread);
    lines
        .flat_map(|line| identifiers(line.text()).map(Name::new))
        .collect()
}

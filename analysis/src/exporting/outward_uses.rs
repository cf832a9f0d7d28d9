//! What the networks of a file do with names that it does not hold itself.

use crate::names::context::Context;
use crate::names::scope::{Origin, SectionKind, TagFacts, type_by_form};
use crate::networks::NetworkAt;
use crate::networks::control_flow::ControlFlow;
use crate::networks::named::Named;
use crate::networks::network::Meaning;
use crate::networks::unread_line::identifiers;
use crate::networks::use_kind::Extent;
use crate::other_files::outward::{Handed, Outward, TagUse};
use crate::program::Access;
use crate::program::{Unread, root_of};
use crate::written::facts::NodeKind;
use ladder_instructions::Op;
use ladder_syntax::{LineKind, Name, Part};
use rustc_hash::{FxHashMap, FxHashSet};

/// What a file does with what other files may hold.
pub(super) fn of(context: &Context) -> Outward {
    let mut outward = Outward::default();
    for network in &context.networks {
        names(context, network, &mut outward);
        if network.control_flow.has(ControlFlow::CALL) {
            calls(context, network, &mut outward.calls);
        }
        blocks(context, network, &mut outward.blocks);
    }
    for block in &context.user_blocks[..context.own_blocks] {
        if let Some(unread) = &block.unread {
            parts(unread, &mut outward);
        }
    }
    for word in unread_words(context) {
        outward.members.insert(word.clone(), TagUse::BOTH);
        outward.tags.insert(word.clone(), TagUse::BOTH);
        outward.blocks.entry(word.clone()).or_default();
        outward.calls.insert(word);
    }
    outward
}

/// What an unread part adds: it reads what it sees.
fn parts(unread: &Unread, outward: &mut Outward) {
    let written = unread.directive.writes.is_none();
    outward.all_tags = outward.all_tags.with(TagUse { read: true, written });
    for path in unread.directive.writes.iter().flatten() {
        outward.tags.insert(Name::new(root_of(path)), TagUse::BOTH);
    }
}

/// What the names of a network add.
fn names(context: &Context, network: NetworkAt<'_>, outward: &mut Outward) {
    let scope = &context.scopes[network.scope];
    for named in &network.named {
        let found = scope.find(&named.key).map(|tag| &scope.tags[tag]);
        let meaning = network.blocks[named.block as usize].meaning;
        let used = at(context, meaning, named.kind.access());
        match named.kind.extent() {
            Extent::Member => members(network, named, used, &mut outward.members),
            Extent::Whole | Extent::Elements if may_be_structure(&named.key, found) => {
                outward.wholes.insert(named.key.clone());
            }
            Extent::Whole | Extent::Elements => {}
        }
        let is_own = found.is_some_and(|tag| !tag.is_outward());
        if is_own || named.key.as_str().starts_with('%') {
            continue;
        }
        let entry = outward.tags.entry(named.key.clone()).or_default();
        *entry = entry.with(used);
    }
}

/// Whether the text of its file leaves it open whether a tag has members. What other files declare has no part in it.
fn may_be_structure(key: &Name, tag: Option<&TagFacts>) -> bool {
    match tag.map(|tag| tag.origin) {
        Some(Origin::Implicit) => false,
        Some(Origin::Declared(kind)) if kind != SectionKind::External => {
            tag.is_some_and(|tag| tag.cold.declared.is_some())
        }
        _ => !key.as_str().starts_with('%') && type_by_form(key.as_str()).is_none(),
    }
}

/// The members in the path that begins with a name.
fn members(network: NetworkAt<'_>, named: &Named, used: TagUse, found: &mut FxHashMap<Name, TagUse>) {
    let operand = &network.blocks[named.block as usize].facts.operands[named.operand as usize];
    let mut at = named.path_in(&operand.value);
    while let Some(node) = at {
        at = match &node.kind {
            NodeKind::Member(base, word) => {
                let entry = found.entry(Name::new(&word.text)).or_default();
                *entry = entry.with(used);
                Some(base)
            }
            NodeKind::Index(base, _) | NodeKind::Range(base, ..) | NodeKind::Paren(base) => Some(base),
            _ => None,
        };
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

/// The user-defined blocks on a network that the file does not hold.
fn blocks(context: &Context, network: NetworkAt<'_>, blocks: &mut FxHashMap<Name, FxHashSet<Handed>>) {
    let is_own = |meaning: Meaning| matches!(meaning, Meaning::User(block) if context.user_blocks[block].import.is_none());
    for bound in network.blocks().filter(|bound| !is_own(bound.meaning)) {
        let Some(name) = bound.user_name() else { continue };
        let names = bound.facts.operands.iter().filter_map(|operand| operand.name());
        let by_name: Vec<Name> = names.map(|word| Name::new(&word.text)).collect();
        let by_place = bound.facts.operands.len() - by_name.len();
        let entry = blocks.entry(Name::new(name)).or_default();
        entry.insert(Handed { by_place, by_name });
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

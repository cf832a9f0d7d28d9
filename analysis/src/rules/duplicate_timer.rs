//! `duplicate-timer` and `duplicate-counter`: a second block on the tag of a timer or counter.

use super::parts;
use super::tag_view::TagView;
use crate::boolean::written::written;
use crate::findings::article::with_article;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::names::context::Context;
use crate::names::scope::{Origin, SectionKind, TagFacts};
use crate::networks::network::Formal;
use crate::networks::use_kind::Effect;

use crate::networks::use_place::{Use, UseRef};
use crate::values::types::Type;
use ladder_instructions::{Accepts, StateType, States};
use ladder_syntax::Name;
use rustc_hash::FxHashMap;
use std::collections::hash_map::Entry;

pub(crate) const RULE: Rule = Rule(
    &RuleFacts::new(RuleGroup::Names, "duplicate-timer", Severity::Error)
        .about_types()
        .runs_if_allowed(),
);

/// Looks at the blocks of one tag.
pub(super) fn check(view: &TagView<'_>, out: &mut Vec<Diagnostic>) {
    let (context, tag) = (view.context, view.tag);
    if let Some(Type::Compound(_)) = tag.ty {
        return in_parts(context, tag, out);
    }
    let Some(Type::State(state)) = tag.ty else {
        return;
    };
    let rule = if state.is_timer() {
        RULE
    } else if state.is_counter() {
        super::duplicate_counter::RULE
    } else {
        return;
    };
    let is_shared = tag.cold.foreign.is_some() || tag.origin == Origin::Declared(SectionKind::Global);
    let keeps = |place: &&UseRef| place.effect() == Effect::KeepsState;
    if !is_shared && tag.uses.0.iter().filter(keeps).nth(1).is_none() {
        return;
    }
    let owners = tag.uses.0.iter().filter(|place| owns(context, **place, state));
    let mut owners = owners.map(|place| context.networks.use_of(*place));
    let Some(first) = owners.next() else { return };
    if is_shared {
        let found = in_another_file(context, rule, tag, state, &first);
        out.extend(found.map(|found| graded(context, found)));
    }
    out.extend(owners.map(|second| {
        let found = second_block(rule, &tag.name, state, &first, &second);
        graded(context, found)
    }));
}

/// Where a system runs both blocks on one state, that is what the program does there.
fn graded(context: &Context, mut found: Diagnostic) -> Diagnostic {
    if context.profile.semantics().states == States::Shared {
        found.severity = Severity::Warning;
    }
    found
}

/// Looks at the blocks of the timers and counters in a structure or array: the same path is the same one.
fn in_parts(context: &Context, tag: &TagFacts, out: &mut Vec<Diagnostic>) {
    let mut first: FxHashMap<Name, Use> = FxHashMap::default();
    for place in tag
        .uses
        .0
        .iter()
        .filter(|place| place.effect() == Effect::KeepsState)
    {
        let Formal::Operand(row) = context.networks.formal_of(*place) else {
            continue;
        };
        let Accepts::State(state) = row.accepts else {
            continue;
        };
        let rule = match state {
            state if state.is_timer() => RULE,
            state if state.is_counter() => super::duplicate_counter::RULE,
            _ => continue,
        };
        let second = context.networks.use_of(*place);
        let network = context.networks.at(second.network);
        let operand = &network.block(second.block).facts.operands[second.operand].value;
        let path = written(context, network.scope, operand);
        // However its index is written.
        let key = parts::fixed(context, network.scope, operand).unwrap_or_else(|| path.clone());
        match first.entry(Name::new(&key)) {
            Entry::Vacant(free) => {
                free.insert(second);
            }
            Entry::Occupied(first) => {
                let found = second_block(rule, &path, state, first.get(), &second);
                out.push(graded(context, found));
            }
        }
    }
}

/// Whether a block keeps its state in the tag. One of another type is an error of its own.
fn owns(context: &Context, place: UseRef, state: StateType) -> bool {
    matches!(context.networks.formal_of(place), Formal::Operand(o) if o.accepts == Accepts::State(state))
}

/// A global belongs to one block of the whole workspace.
fn in_another_file(
    context: &Context,
    rule: Rule,
    tag: &TagFacts,
    state: StateType,
    own: &Use,
) -> Option<Diagnostic> {
    let (file, at) = context.others.states(&Name::new(&tag.name)).next()?;
    let (name, kind) = (&tag.name, kind(rule));
    let message = format!(
        "the {kind} `{name}` has another block in {}: both would work on one {}",
        file.file,
        state.name()
    );
    Some(
        Diagnostic::new(rule, own.range, message)
            .help(format!(
                "give one of the blocks {} of its own; to use the {kind} elsewhere read `{name}.Q`",
                with_article(kind)
            ))
            .related_in(&file.file, at, "this is the other block"),
    )
}

fn kind(rule: Rule) -> &'static str {
    match rule {
        RULE => "timer",
        _ => "counter",
    }
}

fn second_block(rule: Rule, name: &str, state: StateType, first: &Use, second: &Use) -> Diagnostic {
    let (kind, output) = (kind(rule), "Q");
    Diagnostic::new(
        rule,
        second.range,
        format!(
            "the {kind} `{name}` has a second block: both would work on one {}",
            state.name()
        ),
    )
    .help(format!(
        "give this block {} of its own; to use the {kind} on another rung read `{name}.{output}`; if both are meant to work on it, write \
         `# ladder: allow({}): reason #` above this network",
        with_article(kind),
        rule.name()
    ))
    .related(first.range, format!("the {kind} `{name}` belongs to this block"))
}

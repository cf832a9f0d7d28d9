//! `read-before-write`: a rung reads what a rung below it writes, and so sees the value of the scan before,
//! although the two could be in the other order.

use super::dependencies::Circles;
use super::double_coil::Leaving;
use super::parts::{self, Part, Parts, Touched};
use super::survey::Survey;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity, When};
use crate::names::context::{Body, Context};
use crate::names::operand_value::{each_tag_path, tag};
use crate::names::scope::{Origin, SectionKind, TagFacts};
use crate::networks::named::access;
use crate::networks::use_place::Use;
use crate::program::Access;
use crate::program::Role;
use rustc_hash::FxHashSet;
use std::cell::LazyCell;

pub(crate) const RULE: Rule =
    Rule(&RuleFacts::new(RuleGroup::Program, "read-before-write", Severity::Info).when(When::Whole));

pub(super) fn check(survey: &Survey<'_>, out: &mut Vec<Diagnostic>) {
    if !survey.whole {
        return;
    }
    let context = survey.context;
    // The bodies in which the straight way down is not the only one.
    let jumping: FxHashSet<Body> = survey
        .networks_with(Leaving::WAYS)
        .map(|network| context.bodies[network.index])
        .collect();
    let circles = LazyCell::new(|| Circles::of(context));
    let scopes = context.scopes.iter().enumerate();
    for (scope, tag) in scopes.flat_map(|(n, scope)| scope.tags.iter().map(move |tag| (n, tag))) {
        if context.unread.done_with(scope, tag).written
            || tag.is_alias()
            || !is_own(context, tag)
            || !is_read_above(tag)
        {
            continue;
        }
        let parts = Parts::of(context, tag, &Touched::of(context, tag));
        for part in parts.each() {
            let Some((read, write)) = places(context, &part) else {
                continue;
            };
            // One rung reads the old value in any order where each depends on the other.
            if !jumping.contains(&context.bodies[write.network])
                && !circles.hold_both(read.network, write.network)
                && !compares_old_and_new(context, tag, read, write)
            {
                out.push(found(part.name, read, write));
            }
        }
    }
}

/// Whether nothing but the networks of this file writes a tag, and nothing is known of its value before.
fn is_own(context: &Context, tag: &TagFacts) -> bool {
    // A function or block of another file may write what is shared.
    let shared = matches!(
        tag.origin,
        Origin::Shared | Origin::Declared(SectionKind::Global | SectionKind::External | SectionKind::InOut)
    );
    let begins = tag.role == Role::Input || tag.retain || tag.constant || !tag.cold.initial.is_empty();
    // What is done by another name of its address may come first.
    !shared && !begins && context.others_at_address(tag).next().is_none()
}

/// Whether a network reads the tag above one that writes it: of most tags that is not so.
fn is_read_above(tag: &TagFacts) -> bool {
    let places = || tag.uses.0.iter();
    let read = places().find(|place| place.access().reads());
    let write = places().rev().find(|place| place.access().writes());
    read.zip(write)
        .is_some_and(|(read, write)| read.network < write.network)
}

/// The first rung that writes a part of a tag, and one above it that reads it.
fn places(context: &Context, part: &Part<'_>) -> Option<(Use, Use)> {
    let (read, write) = (part.touched.first_read?, part.touched.first_write?);
    let is_written_there = part.own.iter().any(|place| place.access().writes());
    let is_clear = is_written_there && !part.touched.scattered;
    let places = (context.networks.use_of(read), context.networks.use_of(write));
    (is_clear && read.network < write.network).then_some(places)
}

/// Whether the reading rung also reads what the value is made of: it compares old and new on purpose.
fn compares_old_and_new(context: &Context, late: &TagFacts, reading: Use, writing: Use) -> bool {
    let scope = context.networks.at(reading.network).scope;
    let own = tag(context, scope, &late.name).map(|(id, _)| id);
    let written = parts::fixed_at(context, &writing);
    let read_by_writer = parts_read(context, writing.network);
    let read = parts_read(context, reading.network);
    let is_own =
        |(id, part): &PartRead| Some(*id) == own && !parts::apart(part.as_deref(), written.as_deref());
    read.iter()
        .any(|part| !is_own(part) && read_by_writer.contains(part))
}

/// A tag, and which part of it.
type PartRead = ((usize, usize), Option<String>);

fn parts_read(context: &Context, network: usize) -> FxHashSet<PartRead> {
    let network = context.networks.at(network);
    let mut found = FxHashSet::default();
    for bound in network.blocks() {
        for (operand, formal) in bound.facts.operands.iter().zip(bound.formals.iter()) {
            if access(&bound, *formal, &context.user_blocks).is_some_and(Access::reads) {
                each_tag_path(&operand.value, &mut |path| {
                    if let Some((id, _)) = path
                        .root_name()
                        .and_then(|name| tag(context, network.scope, name))
                    {
                        found.insert((id, parts::fixed(context, network.scope, path)));
                    }
                });
            }
        }
    }
    found
}

fn found(name: &str, read: Use, write: Use) -> Diagnostic {
    let found = Diagnostic::new(
        RULE,
        read.range,
        format!("`{name}` is written further down: this rung sees its value of the scan before"),
    );
    let help = format!("move the rung that writes `{name}` above this one, so that it acts in the same scan");
    let related = format!("`{name}` is written here");
    found.help(help).related(write.range, related)
}

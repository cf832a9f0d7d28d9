//! `read-before-write`: a rung reads what a rung below it writes, and so sees the value of the scan before,
//! although the two could be in the other order.

use super::dependencies::Circles;
use super::double_coil::Leaving;
use super::survey::Survey;
use crate::context::{Body, Context};
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity, When};
use crate::names::operand_value::{each_tag, tag};
use crate::names::scope::{Origin, SectionKind, TagFacts};
use crate::networks::access::Access;
use crate::networks::named::access;
use crate::networks::use_place::{Use, UseRef};
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
    for tag in context.scopes.iter().flat_map(|scope| &scope.tags) {
        let Some((read, write)) = places(context, tag).filter(|_| !tag.is_alias()) else {
            continue;
        };
        // One rung reads the old value in any order where each depends on the other.
        if !jumping.contains(&context.bodies[write.network])
            && !circles.hold_both(read.network, write.network)
            && !compares_old_and_new(context, tag, (read, write))
        {
            out.push(found(tag, read, write));
        }
    }
}

/// The first rung that writes a tag, and one above it that reads it.
fn places(context: &Context, tag: &TagFacts) -> Option<(Use, Use)> {
    // A function or block of another file may write what is shared.
    let shared = matches!(
        tag.origin,
        Origin::Shared | Origin::Declared(SectionKind::Global | SectionKind::External | SectionKind::InOut)
    );
    if shared || tag.role == Role::Input || tag.retain || tag.constant || !tag.cold.initial.is_empty() {
        return None;
    }
    // What is done by another name of its address may come first.
    if context.others_at_address(tag).next().is_some() {
        return None;
    }
    let network = |place: &UseRef| place.network;
    let write = tag.uses.writers().min_by_key(network)?;
    let above = network(&write);
    let mut reads = tag.uses.0.iter().filter(|place| place.access().reads());
    let read = *reads.find(|place| network(place) < above)?;
    let (read, write) = (context.networks.use_of(read), context.networks.use_of(write));
    let body = context.bodies[write.network];
    let clear = |place: Use| context.bodies[place.network] == body && !place.indexed;
    context.uses(tag).all(clear).then_some((read, write))
}

/// Whether the reading rung also reads what the value is made of: it compares old and new on purpose.
fn compares_old_and_new(context: &Context, late: &TagFacts, (reading, writing): (Use, Use)) -> bool {
    let scope = context.networks.at(reading.network).scope;
    let own = tag(context, scope, &late.name).map(|(id, _)| id);
    let read_by_writer = tags_read(context, writing.network);
    let read = tags_read(context, reading.network);
    read.iter()
        .any(|tag| Some(*tag) != own && read_by_writer.contains(tag))
}

fn tags_read(context: &Context, network: usize) -> FxHashSet<(usize, usize)> {
    let network = context.networks.at(network);
    let mut found = FxHashSet::default();
    for bound in network.blocks() {
        for (operand, formal) in bound.facts.operands.iter().zip(bound.formals.iter()) {
            if access(&bound, *formal, &context.user_blocks).is_some_and(Access::reads) {
                each_tag(&operand.value, &mut |name| {
                    found.extend(tag(context, network.scope, name).map(|(id, _)| id));
                });
            }
        }
    }
    found
}

fn found(tag: &TagFacts, read: Use, write: Use) -> Diagnostic {
    let name = &tag.name;
    let found = Diagnostic::new(
        RULE,
        read.range,
        format!("`{name}` is written further down: this rung sees its value of the scan before"),
    );
    let help = format!("move the rung that writes `{name}` above this one, so that it acts in the same scan");
    let related = format!("`{name}` is written here");
    found.help(help).related(write.range, related)
}

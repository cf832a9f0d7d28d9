//! `overlapping-address`: two direct addresses that would share memory in a controller, and do not here.

use super::survey::Survey;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::names::context::Context;
use crate::names::scope::TagFacts;
use crate::values::address_bits::AddressBits;

pub(crate) const RULE: Rule = Rule(&RuleFacts::new(
    RuleGroup::Names,
    "overlapping-address",
    Severity::Warning,
));

/// Looks at tags that have an address.
pub(super) fn check(survey: &Survey<'_>, out: &mut Vec<Diagnostic>) {
    let context = survey.context;
    let mut areas: Vec<Area<'_>> = context.addressed().filter_map(Area::of).collect();
    let start = |area: &Area<'_>| context.place_of(area.tag).start();
    areas.sort_by_key(|area| (area.bits, start(area)));
    // Areas are of few sizes and begin at a multiple of their own: one is within another, or next to it.
    let mut around: Vec<usize> = Vec::new();
    // For each area those that it overlaps and that come before it.
    let mut earlier: Vec<Vec<usize>> = vec![Vec::new(); areas.len()];
    for (inner, area) in areas.iter().enumerate() {
        around.retain(|&outer: &usize| !areas[outer].bits.is_above(area.bits));
        // What is at one address is one tag.
        let is_other = |outer: &&usize| areas[**outer].bits != area.bits;
        for &outer in around.iter().filter(is_other) {
            if start(&areas[outer]) < start(area) {
                earlier[inner].push(outer);
            } else {
                earlier[outer].push(inner);
            }
        }
        // Of tags at one address the first stands for all.
        if around.last().is_none_or(|&outer| areas[outer].bits != area.bits) {
            around.push(inner);
        }
    }
    for (area, mut earlier) in areas.iter().zip(earlier) {
        earlier.sort_by_cached_key(|&other| start(&areas[other]));
        let earlier = earlier.into_iter().map(|other| &areas[other]);
        out.extend(overlapping(context, area, earlier));
    }
}

/// A tag with the bits that its address takes.
#[derive(Clone, Copy)]
struct Area<'c> {
    bits: AddressBits,
    address: &'c str,
    tag: &'c TagFacts,
}

impl<'c> Area<'c> {
    fn of(tag: &'c TagFacts) -> Option<Area<'c>> {
        let address = tag.cold.address.as_deref()?;
        let bits = AddressBits::of(address)?;
        Some(Area { bits, address, tag })
    }
}

/// The finding at an address that overlaps others, which are in the order of their places.
fn overlapping<'c>(
    context: &Context,
    area: &Area<'_>,
    mut earlier: impl Iterator<Item = &'c Area<'c>>,
) -> Option<Diagnostic> {
    let first = earlier.next()?;
    let name = |area: &Area<'_>| {
        if area.tag.name == area.address {
            format!("`{}`", area.address)
        } else {
            format!("`{}` at {}", area.tag.name, area.address)
        }
    };
    let found = Diagnostic::new(
        RULE,
        context.place_of(area.tag),
        format!(
            "{} and {} would share memory in a controller; here each is a tag of its own",
            name(area),
            name(first)
        ),
    )
    .help(
        "use one address for one thing: name a bit of the word (tag.3), or put the bits into it with [PACK]",
    );
    let all = std::iter::once(first).chain(earlier);
    Some(all.fold(found, |found, other| {
        found.related(context.place_of(other.tag), format!("{} is here", name(other)))
    }))
}

//! `unread-part`: a block stands for something that no reader of another system understands. It is not run, and nothing else is
//! reported of it.

use crate::findings::Finding;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::names::context::Context;
use crate::names::unread_uses::part;
use crate::networks::network::Meaning;
use crate::program::{Unread, unread_name};
use ladder_syntax::TextRange;

pub(crate) const RULE: Rule = Rule(&RuleFacts::new(
    RuleGroup::Wiring,
    "unread-part",
    Severity::Warning,
));

/// Places of a part that a finding links to.
const MOST_PLACES: usize = 10;

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    for (item, block) in context.user_blocks[..context.own_blocks].iter().enumerate() {
        let Some(unread) = &block.unread else { continue };
        let is_it = |meaning| matches!(meaning, Meaning::User(index) if index == item);
        let blocks = context
            .networks
            .iter()
            .flat_map(crate::networks::NetworkAt::blocks);
        let mut places = blocks
            .filter(|bound| is_it(bound.meaning))
            .map(crate::networks::BlockAt::range);
        let at = places.next().unwrap_or(block.at);
        let name = unread_name(&block.name);
        let mut found = Diagnostic::new(
            RULE,
            at,
            format!("`{name}` is an unread part: {}", writes(unread)),
        )
        .help("look in the program that it comes from, or write in its place what it does");
        if at != block.at {
            found = found.related(block.at, "what it says there");
        }
        for place in places.take(MOST_PLACES) {
            found = found.related(place, format!("`{name}` is here as well"));
        }
        out.push(found);
    }
}

fn writes(unread: &Unread) -> String {
    let what = match unread.directive.writes.as_deref() {
        None => "may write any tag that it sees".to_owned(),
        Some([]) => "writes nothing".to_owned(),
        Some(names) => {
            let names: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
            format!("may write {}", names.join(", "))
        }
    };
    if unread.directive.at_any_time {
        format!("it is not run, and {what}, between any two networks")
    } else {
        format!("it is not run, and {what}")
    }
}

/// Takes out what else is found of unread parts, but for errors: with one no program is there at all.
pub(crate) fn hide_all_else(context: &Context, all: &mut Vec<Finding>) {
    if !context.unread.any() {
        return;
    }
    let mut places: Vec<TextRange> = Vec::new();
    let blocks = &context.parse.frame().blocks;
    let unread = context.user_blocks[..context.own_blocks].iter().zip(blocks);
    for (_, definition) in unread.filter(|(block, _)| block.unread.is_some()) {
        let first = context.parse.line_start(definition.lines.start);
        let last = context.parse.line_range(definition.lines.end - 1);
        places.push(TextRange::new(first, last.end()));
    }
    for bound in context
        .networks
        .iter()
        .flat_map(crate::networks::NetworkAt::blocks)
    {
        if part(&bound, &context.user_blocks).is_some() {
            places.push(bound.range());
        }
    }
    places.sort_unstable_by_key(|place| place.start());
    let is_in = |found: &Finding| {
        let after = places.partition_point(|place| place.start() <= found.range.start());
        after > 0 && places[after - 1].contains_range(found.range)
    };
    all.retain(|found| {
        let is_own = found.rule == RULE || found.rule == super::bad_directive::RULE;
        is_own || found.severity == Severity::Error || !is_in(found)
    });
}

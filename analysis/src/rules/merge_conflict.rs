//! `merge-conflict`: both forms of something are in the text, between the lines of signs of a merge.

use crate::findings::Finding;
use crate::findings::diagnostic::{Applicability, Diagnostic, Fix};
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::names::context::Context;
use ladder_format::Edit;
use ladder_syntax::{Conflict, Parse, Sign, TextRange, TextSize};

pub(crate) const RULE: Rule =
    Rule(&RuleFacts::new(RuleGroup::Text, "merge-conflict", Severity::Error).fixed(Applicability::Unsafe));

pub(crate) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let parse = &context.parse;
    let before = out.len();
    for conflict in parse.conflicts() {
        if super::is_enough(before, out) {
            break;
        }
        out.push(found(parse, &conflict));
    }
}

/// Of the lines of a conflict nothing else is reported.
pub(crate) fn hide_all_else(parse: &Parse, all: &mut Vec<Finding>) {
    let conflicts: Vec<TextRange> = parse
        .conflicts()
        .iter()
        .map(|conflict| conflict.range(parse.text_len()))
        .collect();
    if conflicts.is_empty() {
        return;
    }
    all.retain(|found| {
        let at = found.range.start();
        let last = conflicts.partition_point(|conflict| conflict.start() <= at);
        found.rule == RULE
            || !conflicts[..last]
                .last()
                .is_some_and(|conflict| conflict.contains(at))
    });
}

fn found(parse: &Parse, conflict: &Conflict) -> Diagnostic {
    let (first, line) = conflict.signs[0];
    let text = parse.text_in(line);
    let blanks = TextSize::of(&text[..text.len() - text.trim_start().len()]);
    let range = TextRange::at(line.start() + blanks, TextSize::of(text.trim()));
    let parts = |sign| conflict.line(sign);
    if let (Sign::Ours, Some(theirs), Some(end)) = (first, parts(Sign::Theirs), parts(Sign::End)) {
        let message = "a merge left both forms of something here: it is not decided which one holds";
        let found = Diagnostic::new(RULE, range, message)
            .help("keep one of the two, or make one of them, and remove the lines of signs around them");
        return with_fixes(found, [line, parts(Sign::Base).unwrap_or(theirs), theirs, end]);
    }
    let is_open = first == Sign::Ours && conflict.signs.len() > 1 && parts(Sign::End).is_none();
    let found = Diagnostic::new(
        RULE,
        range,
        "a merge left a conflict here, of which lines of signs are missing",
    );
    found.help(if is_open {
        "put `>>>>>>>` below theirs: until then nothing after `=======` is read"
    } else {
        "make of it what should be here, and remove this line"
    })
}

/// Keeping one form is taking out the other, with the lines of signs.
fn with_fixes(found: Diagnostic, [ours, base, theirs, end]: [TextRange; 4]) -> Diagnostic {
    let keep = |title: &str, without: &[TextRange]| {
        let edits = without.iter().map(|range| Edit {
            range: *range,
            text: String::new(),
        });
        Fix::new(Applicability::Unsafe, title, edits.collect())
    };
    found
        .with(keep("Keep ours", &[ours, base.cover(end)]))
        .with(keep("Keep theirs", &[ours.cover(theirs), end]))
        .with(keep("Keep both", &[ours, base.cover(theirs), end]))
}

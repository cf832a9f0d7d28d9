//! Which of all findings are shown, and as what: without those that follow from others, with the severities that the
//! settings ask for, without what comments switch off, in the order of their places.

use super::Finding;
use super::anchored::Anchored;
use super::ledger::{Ledger, OfFile};
use crate::context::Context;
use crate::diagnostic::Diagnostic;
use crate::lint::{self, Allows};
use crate::rule::Severity;
use crate::rule_settings::RuleSettings;
use crate::rules::follow_ups::FollowUps;
use crate::rules::{self, tag_summary};
use ladder_syntax::TextSize;
use std::sync::Arc;

/// The findings of a file as they are shown, and the errors that are hidden or count as less now: a program with them
/// does not run all the same.
pub(super) fn shown(
    context: &Context,
    ledger: &Ledger,
    mut of_file: OfFile,
    settings: &RuleSettings,
) -> (Vec<Finding>, Vec<Diagnostic>) {
    let all = gathered(context, ledger, &mut of_file);
    let mut all = without_follow_ups(context, ledger, all);
    let mut of_text = Vec::new();
    rules::foreign_comment::check(context, &mut of_text);
    rules::syntax_errors::check(context, &mut of_text);
    all.extend(of_text.into_iter().map(Finding::from));
    let mut all = where_much_is_doubtful(context, all);
    let mut allows = Allows::none();
    if ledger.notes.ask() {
        let mut wrong = Vec::new();
        allows = Allows::of(context, &mut wrong);
        all.extend(wrong.into_iter().map(Finding::from));
    }
    let mut hidden = Vec::new();
    all.retain_mut(|finding| {
        let level = lint::level(settings, finding.rule, finding.severity);
        let level = level.filter(|_| !allows.hide(finding.rule, finding.range.start()));
        if finding.severity == Severity::Error && level != Some(Severity::Error) {
            hidden.push(finding.diagnostic(context));
        }
        finding.severity = level.unwrap_or(finding.severity);
        level.is_some()
    });
    all.extend(allows.unused(settings).into_iter().map(Finding::from));
    all.sort_by_key(|found| (found.range.start(), found.range.end(), found.rule));
    // The first says it best: what is found while types are inferred comes before what follows from it.
    all.dedup_by(|later, first| later.rule == first.rule && later.range == first.range);
    (all, hidden)
}

/// All that is found but for mistakes of the text itself. What rules say of the whole program counts only where all of
/// it is known.
fn gathered(context: &Context, ledger: &Ledger, of_file: &mut OfFile) -> Vec<Finding> {
    let in_file = |found: Vec<Diagnostic>| found.into_iter().map(Finding::from);
    let mut all: Vec<Finding> = in_file(context.found.clone()).collect();
    let networks = &context.networks;
    let before = all.len();
    all.extend(
        ledger
            .in_networks(context)
            .map(|(start, found)| Finding::new(found, start, networks)),
    );
    if ledger.is_full()
        && let Some(last) = all[before..].iter_mut().max_by_key(|found| found.range.start())
    {
        let mut found = last.diagnostic(context);
        rules::say_enough(&mut found);
        *last = Finding::from(found);
    }
    all.extend(in_file(std::mem::take(&mut of_file.names)));
    let counts =
        |found: &&Arc<Anchored>| tag_summary::says_it(found.rule(), of_file.whole, of_file.names_known);
    let at_tags = ledger.at_tags().filter(counts);
    all.extend(at_tags.map(|found| Finding::new(found, TextSize::default(), networks)));
    all.extend(in_file(std::mem::take(&mut of_file.program)));
    all
}

fn without_follow_ups(context: &Context, ledger: &Ledger, mut all: Vec<Finding>) -> Vec<Finding> {
    if all.is_empty() {
        return all;
    }
    let Some(mut follow_ups) = FollowUps::new(context, ledger.marked(context)) else {
        return all;
    };
    // Texts of places are read faster in their order.
    all.sort_by_key(|found| found.range.start());
    all.retain(|found| !follow_ups.explain(&found.diagnostic(context)));
    all
}

/// Behind an open comment, and in a text that is in another notation, only that is said.
fn where_much_is_doubtful(context: &Context, all: Vec<Finding>) -> Vec<Finding> {
    let parse = &context.parse;
    let has_errors = all.iter().any(|found| found.severity == Severity::Error);
    if parse.unclosed_comment().is_none() && !(has_errors && rules::cplc_draft::is_it(parse)) {
        return all;
    }
    let mut all: Vec<Diagnostic> = all.iter().map(|found| found.diagnostic(context)).collect();
    rules::unclosed_comment::hide_what_follows(parse, &mut all);
    rules::cplc_draft::hide_all_else(parse, &mut all);
    all.into_iter().map(Finding::from).collect()
}

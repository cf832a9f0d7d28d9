//! Which of all findings are shown, and as what: without those that follow from others, with the severities that the
//! settings ask for, without what comments switch off, in the order of their places.

use super::comments::Allows;
use crate::findings::Finding;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::Known;
use crate::findings::rule::{Rule, Severity};
use crate::findings::rule_settings::RuleSettings;
use crate::names::context::Context;
use crate::rules;
use crate::rules::follow_ups::FollowUps;

/// The findings as they are shown, and the errors that are hidden or count as less.
pub(super) fn shown(
    context: &Context,
    mut all: Vec<Finding>,
    known: Known,
    settings: &RuleSettings,
    (allows, of_comments): (Allows<'_>, Vec<Diagnostic>),
) -> (Vec<Finding>, Vec<Diagnostic>) {
    put_in_order(&mut all);
    if !all.is_empty()
        && let Some(mut follow_ups) = FollowUps::new(context)
    {
        all.retain(|found| !follow_ups.explain(&found.diagnostic()));
    }
    let mut of_text = Vec::new();
    rules::foreign_comment::check(context, &mut of_text);
    rules::syntax_errors::check(context, &mut of_text);
    all.extend(of_text.into_iter().map(Finding::from));
    hide_what_is_doubtful(context, &mut all);
    rules::unread_part::hide_all_else(context, &mut all);
    let mut conflicts = Vec::new();
    rules::merge_conflict::check(context, &mut conflicts);
    all.extend(conflicts.into_iter().map(Finding::from));
    all.extend(of_comments.into_iter().map(Finding::from));
    let (mut all, hidden) = as_asked(all, known, settings, allows);
    rules::merge_conflict::hide_all_else(&context.parse, &mut all);
    (all, hidden)
}

/// Puts findings into the order of their places, each once.
fn put_in_order(all: &mut Vec<Finding>) {
    let place = |found: &Finding| (found.range.start(), found.range.end());
    let rule = |found: &Finding| rules::position(found.rule);
    all.sort_by(|a, b| place(a).cmp(&place(b)).then_with(|| rule(a).cmp(&rule(b))));
    all.dedup_by(|later, first| later.rule == first.rule && later.range == first.range);
}

/// After an open comment, and in a text that is in another notation, only that is reported.
fn hide_what_is_doubtful(context: &Context, all: &mut Vec<Finding>) {
    let parse = &context.parse;
    if !rules::cplc_draft::is_it(parse) {
        rules::drawn::hide_all_else(parse, all);
        rules::neutral_text::hide_all_else(parse, all);
    }
    let has_errors = || all.iter().any(|found| found.severity == Severity::Error);
    if parse.unclosed_comment().is_none() && !(has_errors() && rules::cplc_draft::is_it(parse)) {
        return;
    }
    let mut left: Vec<Diagnostic> = all.iter().map(Finding::diagnostic).collect();
    rules::unclosed_comment::hide_what_follows(parse, &mut left);
    rules::cplc_draft::hide_all_else(parse, &mut left);
    *all = left.into_iter().map(Finding::from).collect();
}

/// What is left with the severities that the settings ask for and without what comments switch off; and the errors that are
/// hidden so.
fn as_asked(
    mut all: Vec<Finding>,
    known: Known,
    settings: &RuleSettings,
    mut allows: Allows<'_>,
) -> (Vec<Finding>, Vec<Diagnostic>) {
    let mut hidden = Vec::new();
    all.retain_mut(|finding| {
        let level = settings.severity_of(finding.rule, finding.severity);
        let level = level.filter(|_| !allows.hide(finding.rule, finding.range.start()));
        if finding.severity == Severity::Error && level != Some(Severity::Error) {
            hidden.push(finding.diagnostic());
        }
        finding.severity = level.unwrap_or(finding.severity);
        level.is_some()
    });
    let is_silent = |rule: Rule| settings.is_on(rule) && !rule.when().holds(known);
    all.extend(allows.unused(is_silent, settings).into_iter().map(Finding::from));
    put_in_order(&mut all);
    hidden.sort_by_key(|found| {
        (
            found.range.start(),
            found.range.end(),
            rules::position(found.rule),
        )
    });
    (all, hidden)
}

/// Keeps so many of a list for which a number is smallest, the first where numbers are alike, in their order.
pub fn keep_nearest<T, K: Ord + Copy>(all: &mut Vec<T>, most: usize, number: impl Fn(&T) -> K) {
    if all.len() <= most || most == 0 {
        all.truncate(most);
        return;
    }
    let mut numbers: Vec<(K, usize)> = all.iter().map(&number).zip(0..).collect();
    let (_, last, _) = numbers.select_nth_unstable(most - 1);
    let last = *last;
    let mut at = 0..;
    all.retain(|one| (number(one), at.next().unwrap_or_default()) <= last);
}

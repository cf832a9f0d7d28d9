//! Which of all findings are shown, and as what: without those that follow from others, with the severities that the
//! settings ask for, without what comments switch off, in the order of their places.

use super::ledger::{Ledger, OfFile};
use super::shelf::{Shelf, Source};
use crate::context::Context;
use crate::diagnostic::Diagnostic;
use crate::findings::Finding;
use crate::lint::{self, Allows};
use crate::rule::{Rule, Severity};
use crate::rule_settings::RuleSettings;
use crate::rules;
use crate::rules::follow_ups::FollowUps;
use crate::rules::tag_summary::{Known, When};
use ladder_syntax::TextSize;

/// The findings of a file as they are shown.
#[derive(Debug, Clone)]
pub(crate) enum Shown {
    /// All that is found is shown, with the severities that the settings ask for: nobody need go through it.
    Kept {
        shelf: Box<Shelf>,
        known: Known,
        /// What is found anew with each edit, in the order of the places. Nothing of it is on the shelf.
        anew: Vec<Finding>,
    },
    /// What is left when all was gone through, in the order of the places.
    Listed(Vec<Finding>),
}

/// The findings of a file as they are shown; the errors that are hidden or count as less now: a program with them
/// does not run all the same; and how many kept findings were looked at for it.
pub(super) fn shown(
    context: &Context,
    ledger: &Ledger,
    of_file: OfFile,
    settings: &RuleSettings,
) -> (Shown, Vec<Diagnostic>, usize) {
    let mut known = of_file.known;
    let anew = found_anew(context, ledger, of_file);
    let count = ledger.shelf.count(known);
    let is_error = |found: &Finding| found.severity == Severity::Error;
    let any_error = count.found_errors > 0 || anew.iter().any(|(_, found)| is_error(found));
    let parse = &context.parse;
    let is_doubtful = parse.unclosed_comment().is_some() || (any_error && rules::cplc_draft::is_it(parse));
    let is_any = count.shown + count.hidden_errors > 0 || !anew.is_empty();
    let mut follow_ups = is_any
        .then(|| FollowUps::new(context, ledger.marked(context)))
        .flatten();
    let lowers = |(_, found): &(Source, Finding)| {
        is_error(found) && lint::level(settings, found.rule, found.severity) != Some(Severity::Error)
    };
    let can_be_kept = !is_doubtful
        && !ledger.is_full()
        && !ledger.notes.ask()
        && count.hidden_errors == 0
        && !anew.iter().any(lowers)
        && follow_ups.as_ref().is_none_or(FollowUps::are_local);
    if can_be_kept {
        known.hides_declarations = follow_ups.as_ref().is_some_and(FollowUps::hide_declarations);
        if let Some((shown, looked_at)) = kept(context, (ledger, known), &anew, follow_ups.as_mut(), settings)
        {
            return (shown, Vec::new(), looked_at);
        }
    }
    let mut all = in_order(ledger.shelf.all(context, known).chain(anew).collect());
    let looked_at = all.len();
    if ledger.is_full() {
        say_enough(context, &mut all);
    }
    let mut all: Vec<Finding> = all.into_iter().map(|(_, found)| found).collect();
    if let Some(follow_ups) = &mut follow_ups {
        all.retain(|found| !follow_ups.explain(&found.diagnostic(context)));
    }
    all.extend(of_text(context));
    if is_doubtful {
        all = where_much_is_doubtful(context, all);
    }
    let (all, hidden) = as_asked(context, ledger, all, settings);
    (Shown::Listed(all), hidden, looked_at)
}

/// What is not on the shelf: what is wrong with names, types and the program as a whole, and what is found in networks
/// and at tags with places that are true for this text only. What rules say of the whole program counts only where all of
/// it is known.
fn found_anew(context: &Context, ledger: &Ledger, of_file: OfFile) -> Vec<(Source, Finding)> {
    let own = TextSize::default();
    let mut anew: Vec<(Source, Finding)> = Vec::new();
    let mut add = |source, found: Vec<Diagnostic>| {
        anew.extend(found.into_iter().map(|found| (source, Finding::from(found))));
    };
    add(Source::Context, context.found.clone());
    add(Source::Names, of_file.names);
    add(Source::Program, of_file.program);
    let declared = context.misdeclared.found();
    anew.extend(declared.map(|found| (Source::Context, Finding::new(found, own, context))));
    let in_networks = ledger.volatile_in_networks();
    anew.extend(in_networks.map(|found| (Source::Network, Finding::new(found, own, context))));
    let at_tags = ledger.volatile_at_tags();
    let at_tags = at_tags.filter(|found| When::of(found.rule()).holds(of_file.known));
    anew.extend(at_tags.map(|found| (Source::of_tag(found), Finding::new(found, own, context))));
    anew
}

/// What is found in the text itself.
fn of_text(context: &Context) -> impl Iterator<Item = Finding> {
    let mut found = Vec::new();
    rules::foreign_comment::check(context, &mut found);
    rules::syntax_errors::check(context, &mut found);
    found.into_iter().map(Finding::from)
}

/// Findings in the order of their places, each once.
fn in_order(mut all: Vec<(Source, Finding)>) -> Vec<(Source, Finding)> {
    all.sort_by_key(|(source, found)| (found.range.start(), found.range.end(), found.rule, *source));
    all.dedup_by(|(_, later), (_, first)| later.rule == first.rule && later.range == first.range);
    all
}

/// All that is found but what follows from mistakes of the text, if what is found anew hides nothing that is kept; and how
/// many kept findings were looked at for it.
fn kept(
    context: &Context,
    (ledger, known): (&Ledger, Known),
    anew: &[(Source, Finding)],
    mut follow_ups: Option<&mut FollowUps<'_>>,
    settings: &RuleSettings,
) -> Option<(Shown, usize)> {
    let mut all = Vec::with_capacity(anew.len());
    for (source, found) in in_order(anew.to_vec()) {
        match ledger.shelf.has(context, &found, known) {
            Some(other) if other < source => continue,
            Some(_) => return None,
            None => {}
        }
        let follows = match &mut follow_ups {
            Some(follow_ups) => follow_ups.explain(&found.diagnostic(context)),
            None => false,
        };
        if !follows {
            all.push((source, found));
        }
    }
    let mut shelf = Box::new(ledger.shelf.clone());
    let looked_at = follow_ups.map_or(0, |follow_ups| shelf.take_out(context, follow_ups));
    let of_text = of_text(context).filter(|found| shelf.has(context, found, known).is_none());
    all.extend(of_text.map(|found| (Source::Text, found)));
    let mut shown = Vec::with_capacity(all.len());
    for (_, mut found) in in_order(all) {
        let level = lint::level(settings, found.rule, found.severity);
        if found.severity == Severity::Error && level != Some(Severity::Error) {
            return None;
        }
        if let Some(level) = level {
            found.severity = level;
            shown.push(found);
        }
    }
    let shown = Shown::Kept {
        shelf,
        known,
        anew: shown,
    };
    Some((shown, looked_at))
}

/// No more was looked for: the last of what is found in networks says so.
fn say_enough(context: &Context, all: &mut [(Source, Finding)]) {
    let of_networks = all.iter_mut().filter(|(source, _)| *source == Source::Network);
    if let Some((_, last)) = of_networks.max_by_key(|(_, found)| found.range.start()) {
        let mut found = last.diagnostic(context);
        rules::say_enough(&mut found);
        *last = Finding::from(found);
    }
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

/// What is left with the severities that the settings ask for and without what comments switch off, in the order of the
/// places; and the errors that are hidden so.
fn as_asked(
    context: &Context,
    ledger: &Ledger,
    mut all: Vec<Finding>,
    settings: &RuleSettings,
) -> (Vec<Finding>, Vec<Diagnostic>) {
    let mut allows = Allows::none();
    if ledger.notes.ask() {
        let mut wrong = Vec::new();
        allows = Allows::of(context, ledger.notes.asking(context.parse.lines()), &mut wrong);
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

impl Shown {
    /// All of them, in the order of their places.
    pub(crate) fn all(&self, context: &Context) -> Vec<Finding> {
        match self {
            Shown::Listed(all) => all.clone(),
            Shown::Kept { shelf, known, anew } => {
                let mut all: Vec<Finding> = shelf.shown(context, *known).collect();
                all.extend(anew.iter().cloned());
                all.sort_by_key(|found| (found.range.start(), found.range.end(), found.rule));
                all
            }
        }
    }

    /// How many there are.
    pub(crate) fn len(&self) -> usize {
        match self {
            Shown::Listed(all) => all.len(),
            Shown::Kept { shelf, known, anew } => shelf.count(*known).shown + anew.len(),
        }
    }

    /// Whether one of them is an error.
    pub(crate) fn has_errors(&self) -> bool {
        let is_error = |found: &Finding| found.severity == Severity::Error;
        match self {
            Shown::Listed(all) => all.iter().any(is_error),
            Shown::Kept { shelf, known, anew } => shelf.count(*known).errors > 0 || anew.iter().any(is_error),
        }
    }

    /// At most so many of them, in the order of their places: errors come before all others, and then what is near to a
    /// place.
    pub(crate) fn nearest(&self, context: &Context, most: usize, to: TextSize) -> Vec<Finding> {
        let mut some = match self {
            Shown::Listed(all) => all.clone(),
            Shown::Kept { shelf, known, anew } => {
                let mut some = shelf.around(context, *known, (to, most, true));
                some.extend(shelf.around(context, *known, (to, most, false)));
                some.extend(anew.iter().cloned());
                some.sort_by_key(|found| (found.range.start(), found.range.end(), found.rule));
                some
            }
        };
        keep_nearest(&mut some, most, |found| {
            let away = u32::from(found.range.start()).abs_diff(u32::from(to));
            (found.severity != Severity::Error, away)
        });
        some
    }

    /// Whether a rule finds something that is not kept from one text to the next.
    pub(crate) fn finds_anew(&self, rule: Rule) -> bool {
        let (Shown::Listed(anew) | Shown::Kept { anew, .. }) = self;
        anew.iter().any(|found| found.rule == rule)
    }

    /// Adds one that is found anew.
    pub(super) fn add(&mut self, found: Finding) {
        match self {
            Shown::Listed(all) => all.push(found),
            Shown::Kept { anew, .. } => anew.push(found),
        }
    }
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

//! Which of all findings are shown, and as what: without those that follow from others, with the severities that the
//! settings ask for, without what comments switch off, in the order of their places.

use super::Work;
use super::ledger::{Ledger, OfFile};
use super::shelf::{Shelf, Source};
use super::unused_allows::UnusedAllows;
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
use rustc_hash::{FxHashMap, FxHashSet};

/// The findings of a file as they are shown.
#[derive(Debug, Clone)]
pub(crate) enum Shown {
    /// What is kept is known as it is shown: nobody need go through it.
    Kept {
        shelf: Box<Shelf>,
        known: Known,
        /// The comments about networks that hide nothing.
        unused: UnusedAllows,
        /// What is found anew with each edit, in the order of the places. Nothing of it is on the shelf.
        anew: Vec<Finding>,
    },
    /// What is left when all was gone through, in the order of the places.
    Listed(Vec<Finding>),
}

/// The findings of a file as they are shown; the errors that are hidden or count as less now, beside those that are
/// [kept](Shown::hidden_errors): a program with them does not run all the same; and what was looked at for it.
pub(super) fn shown(
    context: &Context,
    ledger: &mut Ledger,
    of_file: OfFile,
    settings: &RuleSettings,
) -> (Shown, Vec<Diagnostic>, Work) {
    let mut known = of_file.known;
    let anew = found_anew(context, ledger, of_file);
    let count = ledger.shelf.count(known);
    let is_error = |found: &Finding| found.severity == Severity::Error;
    let any_error = count.found_errors > 0 || anew.iter().any(|(_, found)| is_error(found));
    let parse = &context.parse;
    let is_doubtful = parse.unclosed_comment().is_some() || (any_error && rules::cplc_draft::is_it(parse));
    let is_any = count.found > 0 || !anew.is_empty();
    let mut follow_ups = is_any
        .then(|| FollowUps::new(context, ledger.marked(context)))
        .flatten();
    let can_be_kept = !is_doubtful
        && !ledger.is_full()
        && !ledger.allowed.has_others()
        && follow_ups.as_ref().is_none_or(FollowUps::are_local);
    if can_be_kept {
        known.hides_declarations = follow_ups.as_ref().is_some_and(FollowUps::hide_declarations);
        let kept = kept(context, (ledger, known), &anew, follow_ups.as_mut(), settings);
        if let Some(kept) = kept {
            return kept;
        }
    }
    let mut all = in_order(ledger.shelf.all(context, known).chain(anew).collect());
    let looked_at = Work {
        findings: all.len(),
        ..Work::default()
    };
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
    let (all, hidden) = as_asked(context, (ledger, known), all, settings);
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
    add(Source::Names, of_file.names);
    add(Source::Program, of_file.program);
    let declared = context.wrong_globals.found().chain(context.misdeclared.found());
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

/// All that is found but what follows from mistakes of the text, if what is found anew hides nothing that is kept; the
/// errors found anew that are hidden or count as less; and what was looked at for it.
fn kept(
    context: &Context,
    (ledger, known): (&mut Ledger, Known),
    anew: &[(Source, Finding)],
    mut follow_ups: Option<&mut FollowUps<'_>>,
    settings: &RuleSettings,
) -> Option<(Shown, Vec<Diagnostic>, Work)> {
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
    let (unused, comments) = ledger.allowed.unused((&mut ledger.shelf, known), settings);
    let mut unused = unused.clone();
    let mut shelf = Box::new(ledger.shelf.clone());
    let findings = follow_ups.map_or(0, |follow_ups| shelf.take_out(context, follow_ups));
    let of_text = of_text(context).filter(|found| shelf.has(context, found, known).is_none());
    let of_text = of_text.chain(ledger.allowed.wrong(context));
    all.extend(of_text.map(|found| (Source::Text, found)));
    let mut shown = Vec::with_capacity(all.len());
    let mut hidden_errors = Vec::new();
    let mut hidden_in: FxHashMap<u32, FxHashSet<Rule>> = FxHashMap::default();
    let mut found_rules: FxHashSet<Rule> = FxHashSet::default();
    for (_, mut found) in in_order(all) {
        let set = lint::level(settings, found.rule, found.severity);
        let network = shelf.with_comments_at(context, found.range.start());
        if set.is_some() {
            found_rules.insert(found.rule);
            if let Some(network) = network {
                hidden_in.entry(network).or_default().insert(found.rule);
            }
        }
        let level = set.filter(|_| !shelf.is_off(found.rule, network));
        if found.severity == Severity::Error && level != Some(Severity::Error) {
            hidden_errors.push(found.diagnostic(context));
        }
        if let Some(level) = level {
            found.severity = level;
            shown.push(found);
        }
    }
    // Beside what is kept, comments hide what is found anew, and nothing of what follows from mistakes.
    let mut again = shelf.take_changed();
    again.extend(hidden_in.keys());
    for &id in &again {
        let is_anew = |rule| hidden_in.get(&id).is_some_and(|rules| rules.contains(&rule));
        unused.ask(
            id,
            |rule| shelf.may_find_in(id, rule, known) || is_anew(rule),
            settings,
        );
    }
    let is_used = |rule| shelf.may_find_in_file(rule, known) || found_rules.contains(&rule);
    shown.extend(ledger.allowed.unused_in_file(context, is_used, settings));
    sort(&mut shown);
    let work = Work {
        findings,
        comments: comments + again.len(),
        ..Work::default()
    };
    let shown = Shown::Kept {
        shelf,
        known,
        unused,
        anew: shown,
    };
    Some((shown, hidden_errors, work))
}

/// Puts findings into the order of their places.
fn sort(found: &mut [Finding]) {
    found.sort_by_key(|found| (found.range.start(), found.range.end(), found.rule));
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
    (ledger, known): (&Ledger, Known),
    mut all: Vec<Finding>,
    settings: &RuleSettings,
) -> (Vec<Finding>, Vec<Diagnostic>) {
    let mut wrong = Vec::new();
    let mut allows = Allows::of(context, ledger.notes.asking(context.parse.lines()), &mut wrong);
    all.extend(wrong.into_iter().map(Finding::from));
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
    let is_silent = |rule| settings.is_on(rule) && When::is_silent(rule, known);
    all.extend(allows.unused(is_silent, settings).into_iter().map(Finding::from));
    sort(&mut all);
    // The first says it best: what is found while types are inferred comes before what follows from it.
    all.dedup_by(|later, first| later.rule == first.rule && later.range == first.range);
    (all, hidden)
}

impl Shown {
    /// All of them, in the order of their places.
    pub(crate) fn all(&self, context: &Context) -> Vec<Finding> {
        match self {
            Shown::Listed(all) => all.clone(),
            Shown::Kept {
                shelf,
                known,
                unused,
                anew,
            } => {
                let mut all: Vec<Finding> = shelf.shown(context, *known).collect();
                all.extend(unused.all(context));
                all.extend(anew.iter().cloned());
                sort(&mut all);
                all
            }
        }
    }

    /// How many there are.
    pub(crate) fn len(&self) -> usize {
        match self {
            Shown::Listed(all) => all.len(),
            Shown::Kept {
                shelf,
                known,
                unused,
                anew,
            } => shelf.count(*known).shown + unused.len() + anew.len(),
        }
    }

    /// Whether one of them is an error.
    pub(crate) fn has_errors(&self) -> bool {
        let is_error = |found: &Finding| found.severity == Severity::Error;
        match self {
            Shown::Listed(all) => all.iter().any(is_error),
            Shown::Kept {
                shelf,
                known,
                unused,
                anew,
            } => shelf.count(*known).errors > 0 || unused.has_errors() || anew.iter().any(is_error),
        }
    }

    /// Whether errors that are kept are hidden, or count as less.
    pub(crate) fn hides_errors(&self) -> bool {
        match self {
            Shown::Listed(_) => false,
            Shown::Kept { shelf, known, .. } => shelf.count(*known).hidden_errors > 0,
        }
    }

    /// The errors that are kept, and are hidden or count as less.
    pub(crate) fn hidden_errors(&self, context: &Context) -> Vec<Finding> {
        match self {
            Shown::Kept { shelf, known, .. } if self.hides_errors() => {
                shelf.hidden_errors(context, *known).collect()
            }
            _ => Vec::new(),
        }
    }

    /// At most so many of them, in the order of their places: errors come before all others, and then what is near to a
    /// place.
    pub(crate) fn nearest(&self, context: &Context, most: usize, to: TextSize) -> Vec<Finding> {
        let mut some = match self {
            Shown::Listed(all) => all.clone(),
            Shown::Kept {
                shelf,
                known,
                unused,
                anew,
            } => {
                let mut some = shelf.around(context, *known, (to, most, true));
                some.extend(shelf.around(context, *known, (to, most, false)));
                some.extend(unused.around(context, to, most));
                some.extend(anew.iter().cloned());
                sort(&mut some);
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

//! The findings that stay while nothing concerns them, by the network in which they are shown.
//!
//! Copies share what they have in common, so the findings of a text can be read while those of the next are put into their
//! places. What is found anew with each edit is not here: see [`Shown`](super::shown::Shown).

use crate::chunked::Chunked;
use crate::context::Context;
use crate::findings::{Anchored, Finding, Home};
use crate::lint;
use crate::rule::{Rule, Severity};
use crate::rule_settings::RuleSettings;
use crate::rules::tag_summary::{Known, When};
use ladder_syntax::{TextRange, TextSize};
use rustc_hash::FxHashSet;
use std::ops::AddAssign;
use std::sync::Arc;

/// Who finds something. Of two findings of one rule at one place the first of these is shown: what is found while
/// types are inferred comes before what follows from it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Source {
    Context,
    Network,
    Names,
    Tag,
    Program,
    Text,
}

/// The findings that are kept: all but those whose places are true for one text only.
#[derive(Debug, Clone)]
pub(crate) struct Shelf {
    settings: Arc<RuleSettings>,
    /// By the numbers of the networks.
    networks: Chunked<Option<Arc<Vec<Item>>>>,
    /// On lines of declarations, in the order of their places.
    declared: Arc<Vec<Item>>,
    counts: [Count; When::ALL.len()],
    /// What is not yet put into its place among the declarations, and what is not yet taken away there, by its address.
    coming: Vec<Item>,
    going: FxHashSet<usize>,
}

/// One finding.
#[derive(Debug, Clone)]
struct Item {
    /// The line of declarations on which it is.
    line: Option<u32>,
    /// From the start of this line, or of its network.
    range: TextRange,
    rule: Rule,
    source: Source,
    /// As the rule says.
    severity: Severity,
    /// As the settings ask for; none if they hide it.
    level: Option<Severity>,
    /// The one before it says the same.
    repeats: bool,
    anchored: Arc<Anchored>,
}

/// How many findings there are.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Count {
    /// Those that are shown.
    pub(super) shown: usize,
    /// Those that are shown as errors.
    pub(super) errors: usize,
    /// Errors, as the rules say.
    pub(super) found_errors: usize,
    /// Those of them that are hidden, or count as less.
    pub(super) hidden_errors: usize,
}

impl AddAssign for Count {
    fn add_assign(&mut self, other: Count) {
        self.shown += other.shown;
        self.errors += other.errors;
        self.found_errors += other.found_errors;
        self.hidden_errors += other.hidden_errors;
    }
}

impl Item {
    fn new(anchored: &Arc<Anchored>, source: Source, settings: &RuleSettings) -> Item {
        let (rule, severity) = (anchored.rule(), anchored.severity());
        let line = match anchored.home() {
            Some(Home::Declaration(line)) => Some(line),
            _ => None,
        };
        Item {
            line,
            range: anchored.anchored_range(),
            rule,
            source,
            severity,
            level: lint::level(settings, rule, severity),
            repeats: false,
            anchored: Arc::clone(anchored),
        }
    }

    fn count(&self) -> Count {
        if self.repeats {
            return Count::default();
        }
        let found = self.severity == Severity::Error;
        let shown = self.level == Some(Severity::Error);
        Count {
            shown: usize::from(self.level.is_some()),
            errors: usize::from(shown),
            found_errors: usize::from(found),
            hidden_errors: usize::from(found && !shown),
        }
    }

    /// Where it starts, of a network that starts at `own`.
    fn start(&self, context: &Context, own: TextSize) -> TextSize {
        let line = self.line.map(|line| context.declarations.start_of(line));
        self.range.start() + line.unwrap_or(own)
    }

    /// As the rule says it, of a network that starts at `own`.
    fn finding(&self, context: &Context, own: TextSize) -> Finding {
        let range = TextRange::at(self.start(context, own), self.range.len());
        Finding::at(range, self.severity, (&self.anchored, own))
    }
}

/// Puts findings into their order.
fn arrange(items: &mut [Item]) {
    let place = |item: &Item| (item.line, item.range.start(), item.range.end(), item.rule);
    items.sort_by_key(|item| (place(item), item.source));
    let mut before = None;
    for item in items {
        let place = Some(place(item));
        item.repeats = std::mem::replace(&mut before, place) == place;
    }
}

impl Shelf {
    pub(super) fn new(settings: &RuleSettings) -> Shelf {
        Shelf {
            settings: Arc::new(settings.clone()),
            networks: Chunked::default(),
            declared: Arc::default(),
            counts: Default::default(),
            coming: Vec::new(),
            going: FxHashSet::default(),
        }
    }

    /// There are so many numbers of networks.
    pub(super) fn resize(&mut self, numbers: usize) {
        while self.networks.len() < numbers {
            self.networks.push(None);
        }
    }

    /// Exchanges what a network owns.
    pub(super) fn set_network<'a>(&mut self, id: u32, found: impl Iterator<Item = &'a Arc<Anchored>>) {
        let kept = self.networks[id as usize].iter().flat_map(|items| items.iter());
        let kept = kept.filter(|item| item.source != Source::Network).cloned();
        let mut items: Vec<Item> = found
            .filter(|found| !found.is_volatile())
            .map(|found| Item::new(found, Source::Network, &self.settings))
            .collect();
        items.extend(kept);
        self.put(id, items);
    }

    /// Adds a finding that a tag owns. To be followed by [`Shelf::settle`].
    pub(super) fn add_of_tag(&mut self, found: &Arc<Anchored>) {
        if found.is_volatile() {
            return;
        }
        let item = Item::new(found, Source::Tag, &self.settings);
        let Some(Home::Network(id)) = found.home() else {
            self.coming.push(item);
            return;
        };
        let mut items = self.items_of(id);
        items.push(item);
        self.put(id, items);
    }

    /// Takes away a finding that a tag owns. To be followed by [`Shelf::settle`].
    pub(super) fn remove_of_tag(&mut self, found: &Arc<Anchored>) {
        if found.is_volatile() {
            return;
        }
        let Some(Home::Network(id)) = found.home() else {
            self.going.insert(Arc::as_ptr(found).addr());
            return;
        };
        let mut items = self.items_of(id);
        items.retain(|item| !Arc::ptr_eq(&item.anchored, found));
        self.put(id, items);
    }

    /// Takes away all that tags own.
    pub(super) fn remove_all_of_tags(&mut self) {
        for id in 0..self.networks.len() as u32 {
            let mut items = self.items_of(id);
            items.retain(|item| item.source != Source::Tag);
            self.put(id, items);
        }
        self.coming.clear();
        self.going = self
            .declared
            .iter()
            .map(|item| Arc::as_ptr(&item.anchored).addr())
            .collect();
    }

    /// Puts what has come and gone on lines of declarations into its place.
    pub(super) fn settle(&mut self) {
        if self.coming.is_empty() && self.going.is_empty() {
            return;
        }
        for item in self.declared.iter() {
            count(&mut self.counts, item, false);
        }
        let declared = Arc::make_mut(&mut self.declared);
        let going = std::mem::take(&mut self.going);
        declared.retain(|item| !going.contains(&Arc::as_ptr(&item.anchored).addr()));
        declared.append(&mut self.coming);
        arrange(declared);
        for item in self.declared.iter() {
            count(&mut self.counts, item, true);
        }
    }

    fn items_of(&self, id: u32) -> Vec<Item> {
        self.networks[id as usize].as_deref().cloned().unwrap_or_default()
    }

    fn put(&mut self, id: u32, mut items: Vec<Item>) {
        let before = self.networks[id as usize].clone();
        if items.is_empty() && before.is_none() {
            return;
        }
        arrange(&mut items);
        for item in before.iter().flat_map(|items| items.iter()) {
            count(&mut self.counts, item, false);
        }
        for item in &items {
            count(&mut self.counts, item, true);
        }
        *self.networks.get_mut(id as usize) = (!items.is_empty()).then(|| Arc::new(items));
    }

    /// How many findings there are of those that hold.
    pub(super) fn count(&self, known: Known) -> Count {
        let mut all = Count::default();
        for when in When::ALL.into_iter().filter(|when| when.holds(known)) {
            all += self.counts[when as usize];
        }
        all
    }

    /// Whether a rule finds the same at a place, and who does.
    pub(super) fn has(&self, context: &Context, finding: &Finding, known: Known) -> Option<Source> {
        let at = finding.range.start();
        let networks = &context.networks;
        let behind = networks.partition_point(|network| network.range.start() <= at);
        let (items, own) = match behind.checked_sub(1) {
            Some(index) => self.of_network(context, index),
            None => (self.declared.as_slice(), TextSize::default()),
        };
        let start = |item: &Item| item.start(context, own);
        let first = items.partition_point(|item| start(item) < at);
        let mut there = items[first..].iter().take_while(|item| start(item) == at);
        let same = |item: &&Item| {
            item.range.len() == finding.range.len()
                && item.rule == finding.rule
                && When::of(item.rule).holds(known)
        };
        there.find(same).map(|item| item.source)
    }

    fn of_network(&self, context: &Context, index: usize) -> (&[Item], TextSize) {
        let networks = &context.networks;
        let id = networks.id(index);
        match self.networks.get(id as usize) {
            Some(Some(items)) => (items, networks.start_of(id)),
            _ => (&[], TextSize::default()),
        }
    }

    /// All findings that hold, as the rules say them, in the order of their places.
    pub(super) fn all(&self, context: &Context, known: Known) -> impl Iterator<Item = (Source, Finding)> {
        let declared = self.declared.iter().map(|item| (item, TextSize::default()));
        let of_networks = (0..context.networks.len()).flat_map(move |index| {
            let (items, own) = self.of_network(context, index);
            items.iter().map(move |item| (item, own))
        });
        let all = declared.chain(of_networks);
        let all = all.filter(move |(item, _)| !item.repeats && When::of(item.rule).holds(known));
        all.map(|(item, own)| (item.source, item.finding(context, own)))
    }

    /// All findings that hold and are shown, as they are shown, in the order of their places.
    pub(super) fn shown(&self, context: &Context, known: Known) -> impl Iterator<Item = Finding> {
        self.all(context, known).filter_map(|(_, found)| {
            let severity = lint::level(&self.settings, found.rule, found.severity)?;
            Some(found.counted_as(severity))
        })
    }

    /// Of the findings that hold and are shown, errors or all others, so many before a place and so many behind it, as
    /// they are shown.
    pub(super) fn around(
        &self,
        context: &Context,
        known: Known,
        (at, most, errors): (TextSize, usize, bool),
    ) -> Vec<Finding> {
        let count = self.count(known);
        let there = if errors {
            count.errors
        } else {
            count.shown - count.errors
        };
        let wanted = |item: &Item, own: TextSize| {
            let level = item.level?;
            let is_it =
                !item.repeats && (level == Severity::Error) == errors && When::of(item.rule).holds(known);
            is_it.then(|| item.finding(context, own).counted_as(level))
        };
        let networks = &context.networks;
        let middle = networks.partition_point(|network| network.range.start() <= at);
        let file = TextSize::default();
        let above = self
            .declared
            .partition_point(|item| item.start(context, file) < at);
        let mut before = Vec::new();
        // What is behind the place in the network around it does not count.
        let mut left = most;
        for index in (0..middle).rev() {
            if left == 0 || before.len() >= there {
                break;
            }
            let (items, own) = self.of_network(context, index);
            for found in items.iter().rev().filter_map(|item| wanted(item, own)) {
                left = left.saturating_sub(usize::from(found.range.start() < at));
                before.push(found);
            }
        }
        let higher = self.declared[..above].iter().rev();
        before.extend(higher.filter_map(|item| wanted(item, file)).take(left));
        before.reverse();
        let mut all = before;
        let most = (all.len() + most).min(there);
        let lower = self.declared[above..]
            .iter()
            .filter_map(|item| wanted(item, file));
        all.extend(lower.take(most - all.len().min(most)));
        for index in middle..networks.len() {
            if all.len() >= most {
                break;
            }
            let (items, own) = self.of_network(context, index);
            all.extend(items.iter().filter_map(|item| wanted(item, own)));
        }
        all
    }
}

fn count(counts: &mut [Count; When::ALL.len()], item: &Item, comes: bool) {
    let counted = item.count();
    let all = &mut counts[When::of(item.rule) as usize];
    let change = |all: &mut usize, by: usize| *all = if comes { *all + by } else { *all - by };
    change(&mut all.shown, counted.shown);
    change(&mut all.errors, counted.errors);
    change(&mut all.found_errors, counted.found_errors);
    change(&mut all.hidden_errors, counted.hidden_errors);
}

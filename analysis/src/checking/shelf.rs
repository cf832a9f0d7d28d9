//! The findings that stay while nothing concerns them, by the network in which they are shown.
//!
//! Copies share what they have in common, so the findings of a text can be read while those of the next are put into their
//! places. What is found anew with each edit is not here: see [`Shown`](super::shown::Shown).

mod by_place;
mod item;

pub(super) use item::Source;

use super::at_tags::Exchanged;
use crate::chunked::Chunked;
use crate::context::Context;
use crate::findings::{Anchored, Home};
use crate::lint;
use crate::rule::{Rule, Severity};
use crate::rule_settings::RuleSettings;
use crate::rules::follow_ups::{FollowUps, is_about_words};
use crate::rules::tag_summary::{Known, When};
use item::{Count, Item, arrange};
use ladder_syntax::TextSize;
use rustc_hash::{FxHashMap, FxHashSet};
use std::sync::Arc;

/// The findings that are kept: all but those whose places are true for one text only.
#[derive(Debug, Clone)]
pub(crate) struct Shelf {
    settings: Arc<RuleSettings>,
    /// By the numbers of the networks.
    networks: Chunked<Items>,
    /// By the numbers of the lines of declarations.
    declared: Chunked<Items>,
    /// Those that hold a finding of a rule that is [about words](is_about_words).
    with_words: Arc<FxHashSet<Home>>,
    counts: [Count; When::ALL.len()],
    /// How many each rule has found.
    of_rules: Vec<u32>,
    /// Rules that comments switch off: in the file,
    off: Arc<FxHashSet<Rule>>,
    /// and in networks, by their numbers.
    off_in: Chunked<Option<Arc<[Rule]>>>,
    /// Of these networks the numbers of those in which something else is found than when it was
    /// [last asked](Shelf::take_changed).
    changed: FxHashSet<u32>,
}

/// The findings of one network or line of declarations, in the order of their places.
type Items = Option<Arc<[Item]>>;

impl Shelf {
    pub(super) fn new(settings: &RuleSettings) -> Shelf {
        Shelf {
            settings: Arc::new(settings.clone()),
            networks: Chunked::default(),
            declared: Chunked::default(),
            with_words: Arc::default(),
            counts: Default::default(),
            of_rules: vec![0; Rule::ALL.len()],
            off: Arc::default(),
            off_in: Chunked::default(),
            changed: FxHashSet::default(),
        }
    }

    /// There are so many numbers of networks, and of lines of declarations.
    pub(super) fn resize(&mut self, networks: usize, lines: usize) {
        while self.networks.len() < networks {
            self.networks.push(None);
            self.off_in.push(None);
        }
        while self.declared.len() < lines {
            self.declared.push(None);
        }
    }

    /// Exchanges what a network owns.
    pub(super) fn set_network<'a>(&mut self, id: u32, found: impl Iterator<Item = &'a Arc<Anchored>>) {
        let kept = self.networks[id as usize].iter().flat_map(|items| items.iter());
        let kept = kept.filter(|item| item.source != Source::Network).cloned();
        let mut items: Vec<Item> = found
            .filter(|found| !found.is_volatile())
            .map(|found| Item::new(found, Source::Network))
            .collect();
        items.extend(kept);
        self.put(Home::Network(id), items);
    }

    /// Exchanges what tags, bodies or the program own. `source`: who has found it.
    pub(super) fn exchange(&mut self, exchanged: Exchanged, source: impl Fn(&Anchored) -> Source) {
        let Exchanged { gone, new } = exchanged;
        let mut homes: FxHashMap<Home, Vec<Item>> = FxHashMap::default();
        let homes_of = |found: &Arc<Anchored>| found.home().filter(|_| !found.is_volatile());
        for found in &gone {
            if let Some(home) = homes_of(found) {
                homes.entry(home).or_default();
            }
        }
        for found in &new {
            if let Some(home) = homes_of(found) {
                let item = Item::new(found, source(found));
                homes.entry(home).or_default().push(item);
            }
        }
        let gone: FxHashSet<*const Anchored> = gone.iter().map(Arc::as_ptr).collect();
        for (home, new) in homes {
            let mut items = self.items_of(home);
            items.extend(new);
            items.retain(|item| !gone.contains(&Arc::as_ptr(&item.anchored)));
            self.put(home, items);
        }
    }

    /// Takes away all that tags own.
    pub(super) fn remove_all_of_tags(&mut self) {
        for home in self.homes() {
            let mut items = self.items_of(home);
            items.retain(|item| !item.source.is_tag());
            self.put(home, items);
        }
    }

    /// Comments switch these rules off in the file.
    pub(super) fn switch_off(&mut self, rules: FxHashSet<Rule>) {
        if *self.off == rules {
            return;
        }
        self.off = Arc::new(rules);
        for home in self.homes() {
            self.put(home, self.items_of(home));
        }
    }

    /// Comments switch these rules off in a network.
    pub(super) fn switch_off_in(&mut self, id: u32, rules: Option<Arc<[Rule]>>) {
        *self.off_in.get_mut(id as usize) = rules;
        self.put(Home::Network(id), self.items_of(Home::Network(id)));
    }

    /// Whether a comment switches a rule off in a network, or in the file.
    pub(super) fn is_off(&self, rule: Rule, network: Option<u32>) -> bool {
        let in_network = || self.off_in.get(network? as usize)?.as_ref();
        self.off.contains(&rule) || in_network().is_some_and(|rules| rules.contains(&rule))
    }

    /// The numbers of networks in which rules are off, and something else is found than when this was last asked.
    pub(super) fn take_changed(&mut self) -> FxHashSet<u32> {
        std::mem::take(&mut self.changed)
    }

    /// The number of the network around a place, if comments switch rules off there.
    pub(super) fn with_comments_at(&self, context: &Context, at: TextSize) -> Option<u32> {
        let line = context.parse.line_at(at)?;
        let network = context.networks.on_line(line)?;
        let id = context.networks.id(network.index);
        self.off_in.get(id as usize)?.as_ref().map(|_| id)
    }

    /// Whether a rule that the settings do not switch off finds something in a network, or would were it not
    /// [silent](When::is_silent).
    pub(super) fn may_find_in(&self, id: u32, rule: Rule, known: Known) -> bool {
        let items = || self.networks[id as usize].iter().flat_map(|items| items.iter());
        self.may_find(rule, known, || items().any(|item| item.rule == rule))
    }

    /// The same of the file.
    pub(super) fn may_find_in_file(&self, rule: Rule, known: Known) -> bool {
        self.may_find(rule, known, || self.of_rules[rule as usize] > 0)
    }

    fn may_find(&self, rule: Rule, known: Known, finds: impl FnOnce() -> bool) -> bool {
        self.settings.is_on(rule) && (When::is_silent(rule, known) || When::of(rule).holds(known) && finds())
    }

    fn homes(&self) -> impl Iterator<Item = Home> + use<> {
        let networks = (0..self.networks.len() as u32).map(Home::Network);
        let lines = (0..self.declared.len() as u32).map(Home::Declaration);
        networks.chain(lines)
    }

    fn items_of(&self, home: Home) -> Vec<Item> {
        let items = match home {
            Home::Network(id) => &self.networks[id as usize],
            Home::Declaration(line) => &self.declared[line as usize],
        };
        items.as_deref().map(<[Item]>::to_vec).unwrap_or_default()
    }

    /// As the settings ask for; none if they hide it, or a comment.
    fn level(&self, home: Home, item: &Item) -> Option<Severity> {
        let network = match home {
            Home::Network(id) => Some(id),
            Home::Declaration(_) => None,
        };
        let level = lint::level(&self.settings, item.rule, item.severity)?;
        (!self.is_off(item.rule, network)).then_some(level)
    }

    fn put(&mut self, home: Home, mut items: Vec<Item>) {
        for item in &mut items {
            item.level = self.level(home, item);
        }
        if let Home::Network(id) = home
            && self.off_in[id as usize].is_some()
        {
            self.changed.insert(id);
        }
        let before = match home {
            Home::Network(id) => self.networks[id as usize].clone(),
            Home::Declaration(line) => self.declared[line as usize].clone(),
        };
        if items.is_empty() && before.is_none() {
            return;
        }
        arrange(&mut items);
        let has_words = items.iter().any(|item| is_about_words(item.rule));
        if has_words != self.with_words.contains(&home) {
            let with_words = Arc::make_mut(&mut self.with_words);
            if has_words {
                with_words.insert(home);
            } else {
                with_words.remove(&home);
            }
        }
        for item in before.iter().flat_map(|items| items.iter()) {
            self.count_one(item, false);
        }
        for item in &items {
            self.count_one(item, true);
        }
        let items = (!items.is_empty()).then(|| items.into());
        match home {
            Home::Network(id) => *self.networks.get_mut(id as usize) = items,
            Home::Declaration(line) => *self.declared.get_mut(line as usize) = items,
        }
    }

    fn count_one(&mut self, item: &Item, comes: bool) {
        let counted = item.count();
        let all = &mut self.counts[When::of(item.rule) as usize];
        let change = |all: &mut usize, by: usize| *all = if comes { *all + by } else { *all - by };
        change(&mut all.found, counted.found);
        change(&mut all.shown, counted.shown);
        change(&mut all.errors, counted.errors);
        change(&mut all.found_errors, counted.found_errors);
        change(&mut all.hidden_errors, counted.hidden_errors);
        let of_rule = &mut self.of_rules[item.rule as usize];
        *of_rule = if comes { *of_rule + 1 } else { *of_rule - 1 };
    }

    /// Takes away what follows from mistakes of the text, all of which [are local](FollowUps::are_local). Tags that are not declared
    /// stay where a slip [may hide their declarations](FollowUps::hide_declarations). Gives how many findings were looked at.
    pub(super) fn take_out(&mut self, context: &Context, follow_ups: &mut FollowUps<'_>) -> usize {
        let networks = follow_ups.networks().into_iter();
        let mut homes: FxHashSet<Home> = networks
            .map(|index| Home::Network(context.networks.id(index)))
            .collect();
        if follow_ups.has_words() {
            homes.extend(self.with_words.iter());
        }
        let mut looked_at = 0;
        for home in homes {
            let mut items = self.items_of(home);
            let before = items.len();
            looked_at += before;
            let own = home.start(context);
            items.retain(|item| !follow_ups.explain(&item.finding(own).diagnostic(context)));
            if items.len() < before {
                self.put(home, items);
            }
        }
        looked_at
    }

    /// How many findings there are of those that hold.
    pub(super) fn count(&self, known: Known) -> Count {
        let mut all = Count::default();
        for when in When::ALL.into_iter().filter(|when| when.holds(known)) {
            all += self.counts[when as usize];
        }
        all
    }
}

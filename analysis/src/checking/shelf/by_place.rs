//! What is on the shelf, read by its place in the file.

use super::Shelf;
use super::item::{Item, Source};
use crate::context::Context;
use crate::findings::Finding;
use crate::rule::Severity;
use crate::rules::tag_summary::{Known, When};
use ladder_syntax::TextSize;

impl Shelf {
    /// Whether a rule finds the same at a place, and who does.
    pub(crate) fn has(&self, context: &Context, finding: &Finding, known: Known) -> Option<Source> {
        let at = finding.range.start();
        let networks = &context.networks;
        let behind = networks.partition_point(|network| network.range.start() <= at);
        let (items, own) = match behind.checked_sub(1) {
            Some(index) => self.of_network(context, index),
            None => match context.declarations.last_before(at) {
                Some(line) => self.of_line(context, line),
                None => return None,
            },
        };
        let start = |item: &Item| item.range.start() + own;
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

    fn of_line(&self, context: &Context, index: usize) -> (&[Item], TextSize) {
        let lines = &context.declarations;
        match self.declared.get(lines.number(index) as usize) {
            Some(Some(items)) => (items, lines.start(index)),
            _ => (&[], TextSize::default()),
        }
    }

    /// All items that hold, in the order of their places, each with where its network or line starts.
    fn items<'s>(&'s self, context: &Context, known: Known) -> impl Iterator<Item = (&'s Item, TextSize)> {
        let lines = (0..context.declarations.len()).map(|index| self.of_line(context, index));
        let networks = (0..context.networks.len()).map(|index| self.of_network(context, index));
        let all = lines.chain(networks);
        let all = all.flat_map(|(items, own)| items.iter().map(move |item| (item, own)));
        all.filter(move |(item, _)| !item.repeats && When::of(item.rule).holds(known))
    }

    /// All findings that hold, as the rules say them, in the order of their places.
    pub(crate) fn all(&self, context: &Context, known: Known) -> impl Iterator<Item = (Source, Finding)> {
        let all = self.items(context, known);
        all.map(|(item, own)| (item.source, item.finding(own)))
    }

    /// All findings that hold and are shown, as they are shown, in the order of their places.
    pub(crate) fn shown(&self, context: &Context, known: Known) -> impl Iterator<Item = Finding> {
        self.items(context, known)
            .filter_map(|(item, own)| Some(item.finding(own).counted_as(item.level?)))
    }

    /// The errors that hold, and are hidden or count as less, in the order of their places.
    pub(crate) fn hidden_errors(&self, context: &Context, known: Known) -> impl Iterator<Item = Finding> {
        let hidden = self
            .items(context, known)
            .filter(|(item, _)| item.is_hidden_error());
        hidden.map(|(item, own)| item.finding(own))
    }

    /// Of the findings that hold and are shown, errors or all others, so many before a place and so many behind it, as
    /// they are shown.
    pub(crate) fn around(
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
            is_it.then(|| item.finding(own).counted_as(level))
        };
        let networks = &context.networks;
        let of_network = |index| self.of_network(context, index);
        let of_line = |index| self.of_line(context, index);
        let network = networks.partition_point(|network| network.range.start() <= at);
        let line = context.declarations.last_before(at).map_or(0, |line| line + 1);
        // Findings on lines of declarations are above all networks.
        let higher = (0..network).rev().map(of_network);
        let higher = higher.chain((0..line).rev().map(of_line));
        let mut before = Vec::new();
        // What is behind the place in the network or on the line around it does not count.
        let mut left = most;
        for (items, own) in higher {
            if left == 0 || before.len() >= there {
                break;
            }
            for found in items.iter().rev().filter_map(|item| wanted(item, own)) {
                left = left.saturating_sub(usize::from(found.range.start() < at));
                before.push(found);
            }
        }
        before.reverse();
        let mut all = before;
        let most = (all.len() + most).min(there);
        let lower = (line..context.declarations.len()).map(of_line);
        for (items, own) in lower.chain((network..networks.len()).map(of_network)) {
            if all.len() >= most {
                break;
            }
            all.extend(items.iter().filter_map(|item| wanted(item, own)));
        }
        all
    }
}

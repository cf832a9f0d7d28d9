//! The comments that switch rules off in networks, and those of them that hide nothing, which are findings too.
//!
//! Copies share what they have in common, as those of the [`Shelf`](super::shelf::Shelf).

use crate::chunked::Chunked;
use crate::context::Context;
use crate::findings::{Anchored, Finding};
use crate::lint::{self, Allow};
use crate::rule::{Rule, Severity};
use crate::rule_settings::RuleSettings;
use crate::rules::tag_summary::When;
use ladder_syntax::{TextRange, TextSize};
use rustc_hash::FxHashSet;
use std::sync::Arc;

/// A comment that switches rules off. Its line counts from the start of something, its other places from that of the line.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct KeptAllow {
    pub(super) rules: Vec<Rule>,
    line: i64,
    comment: TextRange,
    removal: Option<TextRange>,
}

/// By the numbers of networks.
#[derive(Debug, Clone, Default)]
pub(crate) struct UnusedAllows {
    networks: Chunked<Option<Arc<OfNetwork>>>,
    /// How many comments hide nothing,
    unused: usize,
    /// and in which networks.
    with_unused: Arc<FxHashSet<u32>>,
    /// The networks with comments about rules of which what they find is not [always](When::Always) true.
    waiting: Arc<FxHashSet<u32>>,
}

/// The comments about one network.
#[derive(Debug)]
struct OfNetwork {
    /// From top to bottom.
    comments: Arc<[KeptAllow]>,
    /// What is said of each of them that hides nothing. Its places count from the line of the comment.
    unused: Box<[Option<Arc<Anchored>>]>,
}

impl KeptAllow {
    pub(super) fn new(context: &Context, allow: Allow, own: TextSize) -> KeptAllow {
        let line = context.parse.line_start(allow.line);
        KeptAllow {
            rules: allow.rules,
            line: i64::from(u32::from(line)) - i64::from(u32::from(own)),
            comment: allow.comment - line,
            removal: allow.removal.map(|removal| removal - line),
        }
    }

    /// Where its line starts, if what that counts from starts at `own`.
    fn line(&self, own: TextSize) -> TextSize {
        TextSize::new((i64::from(u32::from(own)) + self.line) as u32)
    }

    /// What is said of it if it hides nothing, with places that count from the start of its line.
    pub(super) fn unused(&self, is_used: impl Fn(Rule) -> bool, settings: &RuleSettings) -> Option<Anchored> {
        let found = lint::unused(&self.rules, is_used, (self.comment, self.removal), settings)?;
        Some(Anchored::from(found, TextSize::default()))
    }

    /// The same as a finding.
    pub(super) fn finding(&self, own: TextSize, unused: &Arc<Anchored>) -> Finding {
        Finding::counted_from(unused, self.line(own))
    }
}

impl UnusedAllows {
    /// There are so many numbers of networks.
    pub(super) fn resize(&mut self, networks: usize) {
        while self.networks.len() < networks {
            self.networks.push(None);
        }
    }

    /// The comments about a network.
    pub(super) fn comments(&self, id: u32) -> &[KeptAllow] {
        let of_network = self.networks[id as usize].as_ref();
        of_network.map_or(&[], |of_network| &of_network.comments)
    }

    /// Exchanges them. Which of them hide nothing is still to be [asked](UnusedAllows::ask).
    pub(super) fn set(&mut self, id: u32, comments: Vec<KeptAllow>) {
        let unused = vec![None; comments.len()].into();
        let of_network = OfNetwork {
            comments: comments.into(),
            unused,
        };
        self.put(id, (!of_network.comments.is_empty()).then_some(of_network));
    }

    /// Asks which comments about a network hide nothing.
    pub(super) fn ask(&mut self, id: u32, is_used: impl Fn(Rule) -> bool, settings: &RuleSettings) {
        let Some(of_network) = self.networks[id as usize].clone() else {
            return;
        };
        let known = of_network.comments.iter().zip(&of_network.unused);
        let unused: Box<[_]> = known
            .map(|(comment, known)| {
                let found = comment.unused(&is_used, settings)?;
                // One that says the same keeps its identity.
                let same = known.as_ref().filter(|known| ***known == found);
                Some(same.map_or_else(|| Arc::new(found), Arc::clone))
            })
            .collect();
        if unused.iter().all(Option::is_none) && of_network.unused.iter().all(Option::is_none) {
            return;
        }
        let comments = Arc::clone(&of_network.comments);
        self.put(id, Some(OfNetwork { comments, unused }));
    }

    fn put(&mut self, id: u32, of_network: Option<OfNetwork>) {
        let count = |of_network: Option<&OfNetwork>| {
            let unused = of_network.map_or(&[][..], |of_network| &of_network.unused);
            unused.iter().flatten().count()
        };
        let before = count(self.networks[id as usize].as_deref());
        let now = count(of_network.as_ref());
        self.unused = self.unused + now - before;
        if now > 0 && before == 0 {
            Arc::make_mut(&mut self.with_unused).insert(id);
        } else if now == 0 && before > 0 {
            Arc::make_mut(&mut self.with_unused).remove(&id);
        }
        let comments = of_network
            .iter()
            .flat_map(|of_network| of_network.comments.iter());
        let mut rules = comments.flat_map(|comment| &comment.rules);
        let waits = rules.any(|rule| When::of(*rule) != When::Always);
        if waits != self.waiting.contains(&id) {
            let waiting = Arc::make_mut(&mut self.waiting);
            if waits {
                waiting.insert(id);
            } else {
                waiting.remove(&id);
            }
        }
        *self.networks.get_mut(id as usize) = of_network.map(Arc::new);
    }

    /// The numbers of the networks with comments about which more is to be said where more, or less, of the file is known.
    pub(super) fn waiting(&self) -> impl Iterator<Item = u32> {
        self.waiting.iter().copied()
    }

    /// How many comments hide nothing.
    pub(super) fn len(&self) -> usize {
        self.unused
    }

    /// Whether it is an error that a comment hides nothing.
    pub(super) fn has_errors(&self) -> bool {
        let any = self.with_unused.iter().next();
        let any = any.and_then(|&id| self.networks[id as usize].as_ref());
        let found = any.and_then(|of_network| of_network.unused.iter().flatten().next());
        found.is_some_and(|found| found.severity() == Severity::Error)
    }

    /// The comments about a network that hide nothing.
    fn of_network(&self, context: &Context, index: usize) -> impl DoubleEndedIterator<Item = Finding> {
        let id = context.networks.id(index);
        let start = context.networks.start_of(id);
        let of_network = self.networks.get(id as usize).and_then(|found| found.as_deref());
        let all = of_network
            .into_iter()
            .flat_map(|of_network| of_network.comments.iter().zip(&of_network.unused));
        all.filter_map(move |(comment, unused)| Some(comment.finding(start, unused.as_ref()?)))
    }

    /// All comments that hide nothing, from top to bottom.
    pub(super) fn all(&self, context: &Context) -> impl Iterator<Item = Finding> {
        (0..context.networks.len()).flat_map(|index| self.of_network(context, index))
    }

    /// Of the comments that hide nothing so many before a place and so many behind it.
    pub(super) fn around(&self, context: &Context, at: TextSize, most: usize) -> Vec<Finding> {
        let networks = &context.networks;
        if self.unused <= most {
            let with_unused = self.with_unused.iter();
            let mut with_unused: Vec<usize> = with_unused.map(|&id| networks.index_of(id)).collect();
            with_unused.sort_unstable();
            let all = with_unused.into_iter();
            return all.flat_map(|index| self.of_network(context, index)).collect();
        }
        let middle = networks.partition_point(|network| network.range.start() <= at);
        let mut before = Vec::new();
        let mut left = most;
        // A comment before the place may be about a network behind it.
        let higher = (0..networks.len().min(middle + 1)).rev();
        for found in higher.flat_map(|index| self.of_network(context, index).rev()) {
            left = left.saturating_sub(usize::from(found.range.start() < at));
            before.push(found);
            if left == 0 || before.len() >= self.unused {
                break;
            }
        }
        before.reverse();
        let mut all = before;
        let most = (all.len() + most).min(self.unused);
        let lower = (middle + 1).min(networks.len())..networks.len();
        let lower = lower.flat_map(|index| self.of_network(context, index));
        all.extend(lower.take(most - all.len()));
        all
    }
}

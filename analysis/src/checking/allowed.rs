//! The comments that switch rules off in networks and in the file, kept from one text to the next.
//!
//! Comments are read once in each part of the text, and again where what is next to it changes: what a comment covers
//! may stand in another part. What they switch off is hidden on the [`Shelf`]; which of them hide nothing is asked again in
//! networks in which something else is found.

use super::part_notes::PartNotes;
use super::shelf::Shelf;
use super::unused_allows::{KeptAllow, UnusedAllows};
use crate::context::{Change, Context};
use crate::findings::{Anchored, Finding};
use crate::lint::{self, Covers, Directives, Says};
use crate::rule::Rule;
use crate::rule_settings::RuleSettings;
use crate::rules::tag_summary::Known;
use ladder_syntax::{FileLines, LineKind, Part, TextSize};
use rustc_hash::{FxHashMap, FxHashSet};
use std::collections::BTreeSet;
use std::ops::Range;
use std::sync::Arc;

/// The comments of all parts.
#[derive(Debug, Default)]
pub(super) struct Allowed {
    /// In the order of the parts. Empty as long as no comment is a directive.
    parts: Vec<OfPart>,
    /// Those that switch rules off in networks, with what is said of those that hide nothing.
    unused: UnusedAllows,
    /// What was known of the file when that was asked.
    known: Known,
}

/// What the comments of one part say.
#[derive(Debug, Default)]
struct OfPart {
    /// Those that switch rules off in networks, with the numbers of these: some may be in parts below.
    in_networks: Vec<(u32, KeptAllow)>,
    /// A comment is about what is below the part.
    leads_on: bool,
    /// What has to be looked at with each edit.
    rare: Option<Box<Rare>>,
}

/// What few comments say. Places count from the start of the part.
#[derive(Debug, Default)]
struct Rare {
    /// A comment switches rules off in something else than a network or the file.
    elsewhere: bool,
    /// Those that switch rules off in the file.
    of_file: Vec<KeptAllow>,
    says: Vec<Says>,
    /// What is wrong with comments.
    wrong: Vec<Arc<Anchored>>,
}

impl Allowed {
    /// Reads the comments of parts that are new, in the place of some earlier ones, and of those around them, and hides on the shelf
    /// what they switch off. Gives how many were read.
    pub(super) fn follow(
        &mut self,
        context: &Context,
        change: Option<&Change>,
        (notes, (new, old)): (&PartNotes, (Range<usize>, Range<usize>)),
        shelf: &mut Shelf,
    ) -> usize {
        let lines = context.parse.lines();
        let parts = lines.parts();
        if self.parts.is_empty() && !notes.ask() {
            return 0;
        }
        let is_followed = self.parts.len() + new.len() == parts.len() + old.len();
        let (new, old) = if is_followed {
            (new, old)
        } else {
            (0..parts.len(), 0..self.parts.len())
        };
        let fresh = new.clone().map(|_| OfPart::default());
        let gone = self.parts.splice(old, fresh);
        let ids = |part: &OfPart| part.in_networks.iter().map(|(id, _)| *id).collect::<Vec<_>>();
        let mut touched: FxHashSet<u32> = gone.flat_map(|part| ids(&part)).collect();
        let mut read: FxHashMap<u32, Vec<KeptAllow>> = FxHashMap::default();
        let mut count = 0;
        let networks = change.map_or(&[][..], |change| &change.networks);
        let mut to_read = self.to_read(context, new, networks);
        while let Some(part) = to_read.pop_first() {
            let directives = lint::directives(context, notes.asking_in(part, lines));
            count += directives.allows.len();
            let now = OfPart::of(context, part, directives);
            for (id, comment) in &now.in_networks {
                read.entry(*id).or_default().push(comment.clone());
            }
            let before = std::mem::replace(&mut self.parts[part], now);
            let now = &self.parts[part];
            let is_other = before.in_networks != now.in_networks;
            if is_other {
                touched.extend(ids(&before).into_iter().chain(ids(now)));
            }
            // What is below may be what they are about, with more comments.
            let leads_on = is_other && (before.leads_on || now.leads_on);
            if part + 1 < parts.len() && (leads_on || is_passed_by(&parts[part])) {
                to_read.insert(part + 1);
            }
        }
        self.unused.resize(context.networks.numbers());
        for id in touched {
            let comments = read.remove(&id).unwrap_or_default();
            if self.unused.comments(id) == comments {
                continue;
            }
            let rules: BTreeSet<Rule> = comments
                .iter()
                .flat_map(|comment| &comment.rules)
                .copied()
                .collect();
            let rules = (!rules.is_empty()).then(|| rules.into_iter().collect());
            self.unused.set(id, comments);
            shelf.switch_off_in(id, rules);
        }
        let of_file = self.rare(lines).flat_map(|(rare, _)| &rare.of_file);
        shelf.switch_off(of_file.flat_map(|allow| &allow.rules).copied().collect());
        if !notes.ask() {
            self.parts.clear();
        }
        count
    }

    /// The parts whose comments are to be read: those that are new, those with networks that are, and the ones around them as far
    /// as a comment in one of them may be about something in the other.
    fn to_read(&self, context: &Context, new: Range<usize>, networks: &[usize]) -> BTreeSet<usize> {
        let lines = context.parse.lines();
        let parts = lines.parts();
        let mut all: BTreeSet<usize> = new.clone().collect();
        // Where lines only went, the parts beside the place are neighbours now.
        all.extend(new.start.checked_sub(1));
        all.extend(
            networks
                .iter()
                .map(|&index| lines.part_of(context.networks.at(index).first_line)),
        );
        let below: Vec<usize> = all.iter().map(|part| part + 1).collect();
        all.extend(below.into_iter().filter(|part| *part < parts.len()));
        for part in all.clone() {
            for above in (0..part).rev() {
                let leads_on = self.parts[above].leads_on || is_passed_by(&parts[above]);
                if !leads_on || !all.insert(above) {
                    break;
                }
            }
        }
        all
    }

    /// What has to be looked at with each edit, with where its part starts.
    fn rare<'s>(&'s self, lines: &'s FileLines) -> impl Iterator<Item = (&'s Rare, TextSize)> {
        let parts = self.parts.iter().enumerate();
        parts.filter_map(|(part, of_part)| Some((&**of_part.rare.as_ref()?, lines.first_byte(part))))
    }

    /// Whether a comment switches rules off in something else than a network or the file.
    pub(super) fn has_others(&self) -> bool {
        let mut rare = self.parts.iter().filter_map(|part| part.rare.as_ref());
        rare.any(|rare| rare.elsewhere)
    }

    /// What is wrong with comments.
    pub(super) fn wrong(&self, context: &Context) -> Vec<Finding> {
        let lines = context.parse.lines();
        let says = self.rare(lines).flat_map(|(rare, own)| {
            let says = rare.says.iter();
            says.map(move |says| says.placed(own))
        });
        let idle = lint::idle_words(context, says);
        let wrong = self.rare(lines).flat_map(|(rare, own)| {
            let wrong = rare.wrong.iter();
            wrong.map(move |found| Finding::counted_from(found, own))
        });
        wrong.chain(idle.into_iter().map(Finding::from)).collect()
    }

    /// The comments for the whole file that hide nothing.
    pub(super) fn unused_in_file(
        &self,
        context: &Context,
        is_used: impl Fn(Rule) -> bool,
        settings: &RuleSettings,
    ) -> Vec<Finding> {
        let all = self.rare(context.parse.lines());
        let all = all.flat_map(|(rare, own)| rare.of_file.iter().map(move |allow| (allow, own)));
        let unused = all.filter_map(|(allow, own)| {
            let found = allow.unused(&is_used, settings)?;
            Some(allow.finding(own, &Arc::new(found)))
        });
        unused.collect()
    }

    /// The comments about networks that hide nothing of what is kept. Gives how many networks were asked for it.
    pub(super) fn unused(
        &mut self,
        (shelf, known): (&mut Shelf, Known),
        settings: &RuleSettings,
    ) -> (&UnusedAllows, usize) {
        let mut changed = shelf.take_changed();
        if std::mem::replace(&mut self.known, known) != known {
            changed.extend(self.unused.waiting());
        }
        for &id in &changed {
            let is_used = |rule| shelf.may_find_in(id, rule, known);
            self.unused.ask(id, is_used, settings);
        }
        (&self.unused, changed.len())
    }
}

impl OfPart {
    /// What the comments of a part say, read as they are now.
    fn of(context: &Context, part: usize, directives: Directives) -> OfPart {
        let Directives { allows, says, wrong } = directives;
        let lines = context.parse.lines();
        let own = lines.first_byte(part);
        let end = lines.first_line(part) + lines.parts()[part].lines().len();
        let mut of_part = OfPart::default();
        let mut rare = Rare {
            elsewhere: false,
            of_file: Vec::new(),
            says: says.into_iter().map(|says| says.counted_from(own)).collect(),
            wrong: wrong
                .into_iter()
                .map(|found| Arc::new(Anchored::from(found, own)))
                .collect(),
        };
        for allow in allows {
            match allow.covers {
                Covers::File => rare.of_file.push(KeptAllow::new(context, allow, own)),
                Covers::Network(index) => {
                    let network = context.networks.at(index);
                    of_part.leads_on |= network.first_line >= end;
                    let id = context.networks.id(index);
                    let kept = KeptAllow::new(context, allow, network.range.start());
                    of_part.in_networks.push((id, kept));
                }
                Covers::Lines(ref lines) => {
                    of_part.leads_on |= lines.is_empty() || lines.start >= end;
                    rare.elsewhere = true;
                }
            }
        }
        let is_any =
            rare.elsewhere || !rare.of_file.is_empty() || !rare.says.is_empty() || !rare.wrong.is_empty();
        of_part.rare = is_any.then(|| Box::new(rare));
        of_part
    }
}

/// Whether a comment above a part may be about something below it.
fn is_passed_by(part: &Part) -> bool {
    let nothing = |kind| matches!(kind, LineKind::Blank | LineKind::Comment | LineKind::Rail);
    part.lines().iter().all(|line| nothing(line.kind))
}

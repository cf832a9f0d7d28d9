//! What changed from one program to another, entry by entry.

use crate::matching::{Pair, pairs};
use crate::outline::{Entry, Kind, Outline};
use crate::rename::Rename;
use crate::used::{Used, declared_elsewhere, used};
use crate::verdict::Verdict;
use crate::whole::Whole;
use ladder_prover::{Compared, Meaning};
use ladder_syntax::Name;
use std::cell::OnceCell;
use std::collections::BTreeMap;

/// Two programs, and what became of each entry.
#[derive(Debug)]
pub struct Comparison<'o> {
    /// The old program.
    pub old: &'o Outline,
    /// The new program.
    pub new: &'o Outline,
    /// What became of the entries, in the order of the new program; what is gone is where it was.
    pub changes: Vec<Change<'o>>,
    /// Whether the programs do the same, once that was asked: see [`Comparison::decide_whole`].
    pub whole: Option<Whole>,
    /// What has another name in the new program. The old one is compared as if it had these names.
    pub renames: Vec<Rename>,
    /// Other files that one of the programs uses, and that are not the same on both sides; of programs with the same text also tags.
    pub uses: Vec<Used>,
    /// Both programs, once they are asked for.
    pub(crate) compiled: OnceCell<Result<Compared, String>>,
}

/// What became of an entry. Of one that holds others it says what became of its first line.
#[derive(Debug, Clone)]
pub struct Change<'o> {
    /// What became of it.
    pub verdict: Verdict,
    /// Of an edited network what it does now, once that was asked: see [`Comparison::decide`].
    pub meaning: Option<Meaning>,
    /// It is elsewhere among the others now.
    pub moved: bool,
    /// As it was. None: it is new.
    pub old: Option<&'o Entry>,
    /// As it is. None: it is gone.
    pub new: Option<&'o Entry>,
}

impl<'o> Change<'o> {
    /// The entry as it is, or was.
    pub fn entry(&self) -> &'o Entry {
        match (self.new, self.old) {
            (Some(entry), _) | (None, Some(entry)) => entry,
            (None, None) => unreachable!("a change is of an entry"),
        }
    }

    /// Whether anything is different.
    pub fn is_change(&self) -> bool {
        self.moved || self.verdict != Verdict::Same
    }
}

impl Comparison<'_> {
    /// Whether the programs, or files that they use, differ in more than blank lines.
    pub fn differs(&self) -> bool {
        self.changes.iter().any(Change::is_change) || !self.uses.is_empty() || !self.renames.is_empty()
    }

    /// How many entries each thing happened to, of those that hold no others: `(what, how many)`, the same ones last.
    pub fn counts(&self) -> Vec<(&'static str, usize)> {
        let mut counts: BTreeMap<Verdict, usize> = BTreeMap::new();
        let mut moved = 0;
        for change in &self.changes {
            if change.entry().kind.holds_others() && !change.is_change() {
                continue;
            }
            if change.moved && change.verdict == Verdict::Same {
                moved += 1;
            } else {
                *counts.entry(change.verdict).or_default() += 1;
            }
        }
        let count = |verdict| (Verdict::text(verdict), counts.get(&verdict).copied().unwrap_or(0));
        let mut all = vec![count(Verdict::Edited), count(Verdict::New), count(Verdict::Gone)];
        all.push(("moved", moved));
        all.extend(
            [
                Verdict::Redrawn,
                Verdict::Commented,
                Verdict::Value,
                Verdict::Same,
            ]
            .map(count),
        );
        all.retain(|(_, count)| *count > 0);
        all
    }
}

/// Compares two programs.
pub fn compare<'o>(old: &'o Outline, new: &'o Outline) -> Comparison<'o> {
    let mut comparison = Comparison {
        old,
        new,
        changes: Vec::new(),
        whole: None,
        renames: Vec::new(),
        uses: used(old, new),
        compiled: OnceCell::new(),
    };
    comparison.level(&old.entries, &new.entries);
    if !comparison.changes.iter().any(Change::is_change) {
        comparison.uses.extend(declared_elsewhere(old, new));
    }
    comparison
}

/// Compares two programs of which the old one was [given](crate::rename::renamed) the names of the new one.
pub fn compare_renamed<'o>(old: &'o Outline, new: &'o Outline, renames: Vec<Rename>) -> Comparison<'o> {
    let mut comparison = compare(old, new);
    // What is only drawn in another way around such a name is so for the name.
    let names: Vec<Name> = renames.iter().map(|rename| Name::new(&rename.is)).collect();
    let redrawn = |change: &&mut Change<'_>| change.verdict == Verdict::Redrawn;
    for change in comparison.changes.iter_mut().filter(redrawn) {
        let entry = change.entry();
        // Declarations next to it have its columns.
        let is_near = entry.kind == Kind::Declaration && !names.is_empty();
        if is_near || names.iter().any(|name| entry.told.key.contains(name.as_str())) {
            change.verdict = Verdict::Same;
        }
    }
    Comparison {
        renames,
        ..comparison
    }
}

impl<'o> Comparison<'o> {
    fn level(&mut self, old: &'o [Entry], new: &'o [Entry]) {
        let refs = |entries: &'o [Entry]| -> Vec<&'o Entry> { entries.iter().collect() };
        let pairs = pairs(&refs(old), &refs(new));
        let mut of_new: Vec<Option<Pair>> = vec![None; new.len()];
        let mut stays = vec![None; old.len()];
        for pair in pairs {
            of_new[pair.new] = Some(pair);
            stays[pair.old] = Some(pair.moved);
        }
        let mut next_old = 0;
        for (entry, pair) in new.iter().zip(of_new) {
            let Some(pair) = pair else {
                self.add(Verdict::New, false, None, Some(entry));
                continue;
            };
            if !pair.moved {
                self.gone(old, &stays, next_old..pair.old);
                next_old = pair.old + 1;
            }
            let was = &old[pair.old];
            self.add(self.verdict(was, entry), pair.moved, Some(was), Some(entry));
        }
        self.gone(old, &stays, next_old..old.len());
    }

    fn gone(&mut self, old: &'o [Entry], stays: &[Option<bool>], range: std::ops::Range<usize>) {
        for at in range.filter(|at| stays[*at].is_none()) {
            self.add(Verdict::Gone, false, Some(&old[at]), None);
        }
    }

    fn add(&mut self, verdict: Verdict, moved: bool, old: Option<&'o Entry>, new: Option<&'o Entry>) {
        self.changes.push(Change {
            verdict,
            meaning: None,
            moved,
            old,
            new,
        });
        let inside = |entry: Option<&'o Entry>| entry.map_or(&[][..], |entry| &entry.inside);
        self.level(inside(old), inside(new));
    }

    fn verdict(&self, old: &Entry, new: &Entry) -> Verdict {
        verdict(self.old, old, self.new, new)
    }
}

/// What became of an entry that is another one.
pub(crate) fn verdict(before: &Outline, old: &Entry, after: &Outline, new: &Entry) -> Verdict {
    if old.told.key != new.told.key {
        return Verdict::Edited;
    }
    if old.comments != new.comments {
        return Verdict::Commented;
    }
    if is_same_text(&before.text(old.shown), &after.text(new.shown)) {
        Verdict::Same
    } else {
        Verdict::Redrawn
    }
}

/// Whether two texts are equal but for blanks at the ends of their lines, and how these end.
pub(crate) fn is_same_text(old: &str, new: &str) -> bool {
    old == new || lines(old).eq(lines(new))
}

/// The lines of a text, without what ends them.
pub(crate) fn lines(text: &str) -> impl Iterator<Item = &str> {
    let text = text.trim_start_matches('\u{feff}').trim_end();
    text.split('\n')
        .flat_map(|line| line.strip_suffix('\r').unwrap_or(line).split('\r'))
        .map(str::trim_end)
}

//! `ladder test --mutate`: how much the scenarios notice. One thing after the other is changed in a program, and the scenarios run;
//! what none of them notices is compared with the program, so that it is known whether there was anything to notice.

mod change;
mod fate;
mod generate;
mod held;
mod json;
mod people;
mod subject;

use super::coverage::Covered;
use super::suite::Wishes;
use crate::findings::FileRange;
use crate::terminal::Progress;
use change::{Change, changes};
use fate::Fate;
pub(super) use generate::{Target, generate};
pub(super) use json::json;
pub(super) use people::People;
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};
use subject::{Notice, Subject, subjects};

/// What came of the changes of a program.
pub(super) struct Mutated {
    subject: Subject,
    /// In the order of the program.
    changes: Vec<(Change, Fate)>,
}

/// How many changes came to what.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Score {
    caught: usize,
    missed: usize,
    same: usize,
    unknown: usize,
}

impl Score {
    /// In hundredths, rounded down. None: no change is known to change anything.
    pub(super) fn percent(self) -> Option<usize> {
        (self.caught * 100).checked_div(self.caught + self.missed)
    }

    fn add(&mut self, fate: &Fate) {
        let count = match fate {
            Fate::Caught => &mut self.caught,
            Fate::Missed(_) => &mut self.missed,
            Fate::Same => &mut self.same,
            Fate::Unknown(_) => &mut self.unknown,
        };
        *count += 1;
    }
}

impl Mutated {
    pub(super) fn score(&self) -> Score {
        let mut score = Score::default();
        self.changes.iter().for_each(|(_, fate)| score.add(fate));
        score
    }

    /// The program's file.
    pub(super) fn program(&self) -> &str {
        &self.subject.source.file
    }

    /// The changes that no scenario notices, each with its place and what is changed.
    pub(super) fn missed(&self) -> impl Iterator<Item = (FileRange, String)> {
        let missed = self
            .changes
            .iter()
            .filter(|(_, fate)| matches!(fate, Fate::Missed(_)));
        missed.map(|(change, _)| {
            let source = &self.subject.source;
            let (before, after) = (change.before(source), change.after(source));
            let message = format!("{}: {before} becomes {after}", change.title);
            (self.place(change), message)
        })
    }

    /// The place of a change in the file.
    fn place(&self, change: &Change) -> FileRange {
        let source = &self.subject.source;
        FileRange::of(source, source.range_in_file(change.location.range))
    }

    /// Notes of each contact and comparison whether a scenario shows it to matter: whether it fails when that is bridged, and when it
    /// is inverted.
    pub(super) fn note_in(&self, covered: &mut Covered) {
        let mut matters: BTreeMap<u32, bool> = BTreeMap::new();
        for (change, fate) in &self.changes {
            if change.is_of_condition(&self.subject.program) {
                let all = matters
                    .entry(change.location.range.start().into())
                    .or_insert(true);
                *all &= matches!(fate, Fate::Caught | Fate::Same);
            }
        }
        covered.note_what_matters(&self.subject.source.file, &matters);
    }
}

/// The files, and programs that have none.
pub(super) struct Asked<'a> {
    pub(super) files: &'a [PathBuf],
    pub(super) programs: &'a [PathBuf],
    pub(super) time: Duration,
}

/// What came of all changes of all programs.
///
/// # Errors
/// The errors of a program that was named.
pub(super) fn mutate(
    asked: &Asked<'_>,
    wishes: &Wishes,
) -> Result<Vec<Mutated>, Vec<crate::findings::Problem>> {
    let end = Instant::now() + asked.time;
    let mut subjects = subjects(asked.files, wishes);
    for program in asked.programs {
        subjects.push(Subject::of_program(program, wishes)?);
    }
    let all: Vec<(usize, Change)> = subjects
        .iter()
        .enumerate()
        .filter(|(_, subject)| subject.fails.is_none())
        .flat_map(|(n, subject)| {
            changes(&subject.program)
                .into_iter()
                .map(move |change| (n, change))
        })
        .collect();
    let (done, missed) = (AtomicUsize::new(0), AtomicUsize::new(0));
    let progress = Progress::new();
    let caught: Vec<Notice> = all
        .par_iter()
        .map(|(n, change)| {
            let subject = &subjects[*n];
            let notice = if Instant::now() < end {
                subject.notice(&change.made_in(&subject.program))
            } else {
                Notice::No
            };
            let is_caught = !matches!(notice, Notice::No);
            let done = done.fetch_add(1, Ordering::Relaxed) + 1;
            let missed =
                missed.fetch_add(usize::from(!is_caught), Ordering::Relaxed) + usize::from(!is_caught);
            progress.say(|| format!("{done} of {} changes tried, {missed} not noticed", all.len()));
            notice
        })
        .collect();
    let left = missed.into_inner();
    done.store(0, Ordering::Relaxed);
    let fates: Vec<Fate> = all
        .par_iter()
        .zip(&caught)
        .map(|((n, change), notice)| {
            match notice {
                Notice::Yes => return Fate::Caught,
                Notice::Rests(why) => return Fate::Unknown(format!("a scenario notices it, but {why}")),
                Notice::No => {}
            }
            let subject = &subjects[*n];
            let fate = fate::of_uncaught(subject, &change.made_in(&subject.program), end, wishes.width);
            let done = done.fetch_add(1, Ordering::Relaxed) + 1;
            progress.say(|| format!("{done} of {left} changes compared that no scenario notices"));
            fate
        })
        .collect();
    drop(progress);
    let mut mutated: Vec<Mutated> = subjects
        .into_iter()
        .map(|subject| Mutated {
            subject,
            changes: Vec::new(),
        })
        .collect();
    for ((n, change), fate) in all.into_iter().zip(fates) {
        mutated[n].changes.push((change, fate));
    }
    Ok(mutated)
}

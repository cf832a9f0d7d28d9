//! `ladder test --generate`: scenarios that notice what no scenario has noticed. They expect what the program does today, so a person
//! is to check them.

use super::fate::{Fate, Run, catches};
use super::subject::Subject;
use super::{Change, Mutated};
use crate::outcome::Failure;
use crate::output::{Existing, may_write};
use ladder_simulator::scenario::Suite;
use ladder_syntax::numeral::counted;
use ladder_workspace::shown;
use rayon::prelude::*;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// Where generated scenarios go.
#[derive(Debug, Clone)]
pub(in super::super) enum Target {
    /// To the end of the first file that tests the program; to a new one where there is none.
    InPlace,
    /// Into this file.
    File(PathBuf, Existing),
}

/// How many changes a comment names.
const MOST_NAMED: usize = 4;

/// Writes scenarios that notice what is missed, few and short. Returns what was done, in sentences.
///
/// # Errors
/// A file cannot be written, or was changed in the meantime.
pub(in super::super) fn generate(mutated: &[Mutated], target: &Target) -> Result<Vec<String>, Failure> {
    let with_missed: Vec<&Mutated> = mutated.iter().filter(|it| it.score().missed > 0).collect();
    if let (Target::File(file, _), [_, _, ..]) = (target, &with_missed[..]) {
        return Err(Failure::new(format!(
            "{}: one file has the scenarios of one program; name one, or leave out --output",
            shown::path(file)
        )));
    }
    let mut done = Vec::new();
    for mutated in with_missed {
        let chosen = chosen(mutated);
        let file = mutated.write(&chosen, target)?;
        let caught: usize = chosen.iter().map(|chosen| chosen.catches.len()).sum();
        done.push(format!(
            "{}: {} added for {} that no scenario noticed; what is expected there is what the program does today, so check it",
            shown::path(&file),
            counted(chosen.len(), "scenario"),
            counted(caught, "change")
        ));
    }
    Ok(done)
}

/// A run that becomes a scenario.
struct Chosen<'m> {
    run: &'m Run,
    /// What it is the first to notice.
    catches: Vec<&'m Change>,
}

/// The run that notices the most of what is left, and of those the shortest, until nothing is left.
fn chosen(mutated: &Mutated) -> Vec<Chosen<'_>> {
    let missed: Vec<(&Change, &Run)> = (mutated.changes.iter())
        .filter_map(|(change, fate)| match fate {
            Fate::Missed(run) => Some((change, &**run)),
            _ => None,
        })
        .collect();
    let subject = &mutated.subject;
    let suites: Vec<Option<Suite>> = missed.iter().map(|(_, run)| run.suite(subject)).collect();
    let caught_by: Vec<BTreeSet<usize>> = suites
        .par_iter()
        .map(|suite| {
            let Some(suite) = suite else {
                return BTreeSet::new();
            };
            let noticed = |n: &usize| catches(suite, &missed[*n].0.made_in(&subject.program), subject);
            (0..missed.len()).filter(noticed).collect()
        })
        .collect();
    let mut left: BTreeSet<usize> = (0..missed.len()).collect();
    let mut chosen = Vec::new();
    while let Some((most, best)) = (0..missed.len())
        .map(|n| (caught_by[n].intersection(&left).count(), n))
        .max_by_key(|&(count, n)| (count, usize::MAX - missed[n].1.scans, usize::MAX - n))
        .filter(|(most, _)| *most > 0)
    {
        let caught: Vec<usize> = caught_by[best].intersection(&left).copied().collect();
        debug_assert_eq!(most, caught.len());
        chosen.push(Chosen {
            run: missed[best].1,
            catches: caught.iter().map(|n| missed[*n].0).collect(),
        });
        left.retain(|n| !caught_by[best].contains(n));
    }
    chosen.sort_by_key(|chosen| chosen.run.scans);
    chosen
}

impl Mutated {
    fn write(&self, chosen: &[Chosen<'_>], target: &Target) -> Result<PathBuf, Failure> {
        let tested = &self.subject.tested[0];
        let (file, before) = match target {
            Target::File(file, existing) => {
                may_write(file, *existing)?;
                if folder(file) != folder(&tested.file) {
                    return Err(Failure::new(format!(
                        "{}: the file is in the folder of {}, from which the program is named",
                        shown::path(file),
                        shown::path(&tested.file)
                    )));
                }
                (file.clone(), tested.heading())
            }
            Target::InPlace => {
                let now = match ladder_workspace::read(&tested.file) {
                    Ok(text) => text,
                    Err(_) if !tested.file.exists() => tested.heading(),
                    Err(error) => return Err(error.into()),
                };
                if tested.file.exists() && now != tested.text {
                    return Err(Failure::new(format!(
                        "{}: this file was changed in the meantime, and stays as it is; do it again",
                        shown::path(&tested.file)
                    )));
                }
                (tested.file.clone(), now)
            }
        };
        let line_end = if before.contains("\r\n") { "\r\n" } else { "\n" };
        let mut text = before.trim_end().to_owned();
        text.push_str(line_end);
        let first = 1 + before.matches("scenario \"generated ").count();
        for (number, chosen) in (first..).zip(chosen) {
            let Some(scenario) = chosen.scenario(&self.subject, number) else {
                continue;
            };
            text.push_str(line_end);
            text.push_str(&scenario.replace('\n', line_end));
        }
        match target {
            Target::InPlace if file.exists() => ladder_workspace::write(&file, text.as_bytes())?,
            _ => ladder_workspace::write_made(&file, text.as_bytes())?,
        }
        Ok(file)
    }
}

impl Chosen<'_> {
    fn scenario(&self, subject: &Subject, number: usize) -> Option<String> {
        let written = |text: &str| -> String {
            let blank = |c: char| if c.is_control() { ' ' } else { c };
            text.chars().map(blank).collect()
        };
        let first = self.catches.first()?;
        let name = written(first.before(&subject.source));
        let scenario = self
            .run
            .scenario(subject, &format!("generated {number}: {name}"))?;
        let mut text =
            "# Generated, to be checked: this is what the program does today. It notices when\n".to_owned();
        for change in self.catches.iter().take(MOST_NAMED) {
            let (before, after) = (change.before(&subject.source), change.after(&subject.source));
            let at = subject.source.range_in_file(change.location.range).start();
            let line = subject.source.place(at).line;
            let (before, after) = (written(before), written(&after));
            text.push_str(&format!("#   {before} becomes {after} in line {line}\n"));
        }
        if let Some(more) = self
            .catches
            .len()
            .checked_sub(MOST_NAMED)
            .filter(|more| *more > 0)
        {
            text.push_str(&format!("#   and of {more} more\n"));
        }
        Some(text + &scenario)
    }
}

fn folder(file: &Path) -> Option<PathBuf> {
    let folder = file.parent()?;
    let is_here = folder.as_os_str().is_empty();
    if is_here { Path::new(".") } else { folder }.canonicalize().ok()
}

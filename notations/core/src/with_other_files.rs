//! Programs that use blocks of other files and of the library, for systems that have blocks of one's own: they are written along,
//! as if the program defined them.

use crate::whole::{Added, whole};
use crate::{Entry, Outcome, Report, WriteError, Writing};
use ladder_analysis::Analysis;
use ladder_syntax::Name;
use std::collections::{HashMap, HashSet};

/// The blocks of other files that a system cannot say whole, with why. They are not to be written, and neither is a call.
pub type Unwritable = HashMap<Name, String>;

/// Writes a program with the blocks that it uses of other files and of the library. `write` is handed an analysis in which they
/// are blocks of the program's own. If part of one has no form it is handed the same again, with that block among the
/// [`Unwritable`].
///
/// # Errors
///
/// Those of `write`, and that what is used of other files cannot be one text with the program: it has another arithmetic, or the
/// same name for something else.
pub fn with_other_files(
    analysis: &Analysis,
    write: impl Fn(&Analysis, &Unwritable) -> Result<Writing, WriteError>,
) -> Result<Writing, WriteError> {
    let Some((whole, added)) = whole(analysis)? else {
        return write(analysis, &Unwritable::new());
    };
    let mut unwritable = Unwritable::new();
    loop {
        let mut writing = write(&whole, &unwritable)?;
        let known = unwritable.len();
        for block in &added {
            let first = writing.report.entries.iter().find_map(|entry| {
                let is_in = block.lines.contains(&entry.place.line);
                match &entry.outcome {
                    Outcome::Refused(why) if is_in => Some(why),
                    _ => None,
                }
            });
            if let Some(why) = first {
                let why = format!("`{}` of {} has no form there: {why}", block.name, block.file());
                unwritable.entry(Name::new(&block.name)).or_insert(why);
            }
        }
        // What uses one of them has no form either, which the next writing shows.
        if unwritable.len() == known {
            tell(&mut writing.report, &added, &unwritable);
            return Ok(writing);
        }
    }
}

/// Says of each block at its first call what became of it, instead of each line of it at a place that the file does not have.
fn tell(report: &mut Report, added: &[Added], unwritable: &Unwritable) {
    let mut said = HashSet::new();
    let mut written = HashSet::new();
    let mut entries = Vec::new();
    for entry in std::mem::take(&mut report.entries) {
        let block = added.iter().find(|block| block.lines.contains(&entry.place.line));
        let Some(block) = block else {
            entries.push(entry);
            continue;
        };
        written.insert(&block.name);
        if let Outcome::Approximated(why) = entry.outcome
            && !unwritable.contains_key(&Name::new(&block.name))
            && said.insert((&block.name, why.clone()))
        {
            entries.push(block.entry(Outcome::Approximated(why)));
        }
    }
    for block in added {
        match unwritable.get(&Name::new(&block.name)) {
            Some(why) => entries.push(block.entry(Outcome::Refused(why.clone()))),
            None if written.contains(&block.name) && said.iter().all(|(name, _)| **name != block.name) => {
                entries.push(block.entry(Outcome::Translated));
            }
            _ => {}
        }
    }
    entries.sort_by_key(|entry| entry.place);
    report.entries = entries;
}

impl Added {
    fn entry(&self, outcome: Outcome) -> Entry {
        Entry {
            place: self.used,
            element: format!("[{}]", self.name),
            outcome,
        }
    }
}

//! Programs that use functions and blocks of other files and of the library: they are written along, as if the program defined
//! them.

use crate::whole::{Added, whole};
use crate::{Entry, Outcome, Report, WriteError, Writing};
use ladder_analysis::Analysis;
use ladder_syntax::Name;
use std::collections::{HashMap, HashSet};

/// Blocks of which one has no form are used by others no deeper.
const DEEPEST: usize = 50;

/// The blocks of other files that a system cannot say whole, with why. They are not to be written, and neither is a call.
pub type Unwritable = HashMap<Name, String>;

/// Writes a program with the functions and blocks that it uses of other files and of the library. `write` is handed an analysis in
/// which they are the program's own. If part of one has no form it is handed the same again, with that block among the
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
    for _ in 0..DEEPEST {
        let mut writing = write(&whole, &unwritable)?;
        let known = unwritable.len();
        for entry in &writing.report.entries {
            if let (Outcome::Refused(why), Some(block)) = (&entry.outcome, at(&added, entry))
                && block.is_block
            {
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
    Err(WriteError::new(
        "the blocks of other files use each other too deep",
    ))
}

/// The block of another file that an entry is about.
fn at<'b>(added: &'b [Added], entry: &Entry) -> Option<&'b Added> {
    let line = entry.place.line;
    let after = added.partition_point(|block| block.lines.start <= line);
    let block = &added[after.checked_sub(1)?];
    block.lines.contains(&line).then_some(block)
}

/// Says of each block at its first call what became of it, instead of each line of it at a place that the file does not have.
fn tell(report: &mut Report, added: &[Added], unwritable: &Unwritable) {
    let mut said = HashSet::new();
    let (mut written, mut remarked) = (HashSet::new(), HashSet::new());
    let mut entries = Vec::new();
    for entry in std::mem::take(&mut report.entries) {
        let Some(block) = at(added, &entry) else {
            entries.push(entry);
            continue;
        };
        written.insert(&block.name);
        if let Outcome::Refused(why) = &entry.outcome
            && !block.is_block
        {
            remarked.insert(&block.name);
            let why = format!("in `{}` of {}: {why}", block.name, block.file());
            entries.push(block.entry(Outcome::Refused(why)));
        } else if let Outcome::Approximated(why) = entry.outcome
            && !unwritable.contains_key(&Name::new(&block.name))
            && said.insert((&block.name, why.clone()))
        {
            remarked.insert(&block.name);
            entries.push(block.entry(Outcome::Approximated(why)));
        }
    }
    for block in added {
        match unwritable.get(&Name::new(&block.name)) {
            Some(why) => entries.push(block.entry(Outcome::Refused(why.clone()))),
            None if written.contains(&block.name) && !remarked.contains(&block.name) => {
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
            element: if self.is_block {
                format!("[{}]", self.name)
            } else {
                format!("<CALL>( {} )", self.name)
            },
            outcome,
        }
    }
}

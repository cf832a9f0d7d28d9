//! Programs that use the library, for systems that have blocks of one's own: those of the library are written along, as if
//! the program defined them.

use crate::{Entry, LineColumn, Lines, Outcome, Report, WriteError, Writing};
use ladder_analysis::networks::NetworkAt;
use ladder_analysis::networks::network::Meaning;
use ladder_analysis::{Analysis, analyze_in, library};
use ladder_syntax::{Item, Name, parse};
use std::collections::{HashMap, HashSet};
use std::ops::Range;

/// The blocks of the library that a system cannot say whole, with why. They are not to be written, and neither is a call.
pub type Unwritable = HashMap<Name, String>;

/// A block of the library in the text of a program.
struct Added {
    name: &'static str,
    /// Its lines, from 1.
    lines: Range<u32>,
    /// The first of its calls.
    used: LineColumn,
}

/// Writes a program with the blocks of the library that it uses. `write` is handed an analysis in which they are blocks of the
/// program's own. If part of one has no form it is handed the same again, with that block among the [`Unwritable`].
///
/// # Errors
///
/// Those of `write`, and that the program has another arithmetic than the library.
pub fn with_library(
    analysis: &Analysis,
    write: impl Fn(&Analysis, &Unwritable) -> Result<Writing, WriteError>,
) -> Result<Writing, WriteError> {
    let (whole, added) = whole(analysis)?;
    let whole = whole.as_ref().unwrap_or(analysis);
    let mut unwritable = Unwritable::new();
    let mut writing = write(whole, &unwritable)?;
    for block in &added {
        let first = writing.report.entries.iter().find_map(|entry| {
            let is_in = block.lines.contains(&entry.place.line);
            match &entry.outcome {
                Outcome::Refused(why) if is_in => Some(why),
                _ => None,
            }
        });
        if let Some(why) = first {
            let why = format!("`{}` of the library has no form there: {why}", block.name);
            unwritable.insert(Name::new(block.name), why);
        }
    }
    if !unwritable.is_empty() {
        writing = write(whole, &unwritable)?;
    }
    tell(&mut writing.report, &added, &unwritable);
    Ok(writing)
}

/// The program with the blocks of the library that it uses: they stand below its last network, and above comments at its end,
/// so that all else keeps its place.
fn whole(analysis: &Analysis) -> Result<(Option<Analysis>, Vec<Added>), WriteError> {
    let context = &analysis.context;
    let files = || {
        let others = context.user_blocks[context.own_blocks..].iter();
        others.filter_map(|block| block.file())
    };
    let used: Vec<&library::Source> = files().filter_map(|file| library::source(file)).collect();
    if used.is_empty() || analysis.has_errors() {
        return Ok((None, Vec::new()));
    }
    let mut text = context.parse.to_string();
    let lines = Lines::of(&text);
    let place = |name: &str| {
        let mut blocks = context.networks.iter().flat_map(NetworkAt::blocks);
        let call = blocks.find(|block| {
            matches!(block.meaning, Meaning::User(user) if context.user_blocks[user].name.eq_ignore_ascii_case(name))
        });
        call.map_or(LineColumn::START, |call| {
            lines.place(&text, call.range().start().into())
        })
    };
    let places: Vec<LineColumn> = used.iter().map(|source| place(source.name)).collect();
    let mut of_library = files().filter_map(|file| library::analysis(file));
    if of_library.any(|file| file.context.profile != context.profile) {
        return Err(WriteError::new(format!(
            "{}: `{}` of the library counts and times as IEC 61131-3 says, and this program as {} does: draw what it does on rungs of the program",
            places[0],
            used[0].name,
            context.profile.name()
        )));
    }
    let items = context.parse.structure().items.iter().rev();
    let last = items.map_while(|item| match item {
        Item::Decoration(line) => Some(*line),
        _ => None,
    });
    let at = last
        .last()
        .map_or(text.len(), |line| context.parse.line_start(line).into());
    let end = text.split_off(at);
    if !text.ends_with('\n') {
        text.push('\n');
    }
    let line_count = |text: &str| text.matches('\n').count() as u32 + 1;
    let mut added = Vec::new();
    for (source, used) in used.iter().zip(places) {
        text.push('\n');
        let first = line_count(&text);
        text.push_str(source.text);
        added.push(Added {
            name: source.name,
            lines: first..line_count(&text),
            used,
        });
    }
    text.push_str(&end);
    let whole = analyze_in(&parse(&text).into(), &context.name, &context.others);
    Ok((Some(whole), added))
}

/// Says of each block at its first call what became of it, instead of each line of it at a place that no file has.
fn tell(report: &mut Report, added: &[Added], unwritable: &Unwritable) {
    if added.is_empty() {
        return;
    }
    let mut said = HashSet::new();
    let mut written = HashSet::new();
    let mut entries = Vec::new();
    for entry in std::mem::take(&mut report.entries) {
        let block = added.iter().find(|block| block.lines.contains(&entry.place.line));
        let Some(block) = block else {
            entries.push(entry);
            continue;
        };
        written.insert(block.name);
        if let Outcome::Approximated(why) = entry.outcome
            && !unwritable.contains_key(&Name::new(block.name))
            && said.insert((block.name, why.clone()))
        {
            entries.push(block.entry(Outcome::Approximated(why)));
        }
    }
    for block in added {
        match unwritable.get(&Name::new(block.name)) {
            Some(why) => entries.push(block.entry(Outcome::Refused(why.clone()))),
            None if written.contains(block.name) && said.iter().all(|(name, _)| *name != block.name) => {
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

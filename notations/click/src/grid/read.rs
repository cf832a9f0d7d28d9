//! From the files of a program to the model, and from there to ladder text.

use super::super::model::{Instruction, Program, Routine};
use super::super::nicknames;
use super::cell::{Body, Grid};
use super::file;
use super::rungs::Reader;
use ladder_analysis::Severity;
use ladder_notation::{Finding, LineColumn, Outcome, ReadError, Reading, Report, Source};
use std::collections::HashMap;

/// The folder next to a main program that holds its subroutines, each in a file of its name.
pub(in super::super) const SUBROUTINES: &str = "subroutines";

/// Files next to a main program that begin so are its subroutines too: earlier exports have no folder.
const SUBROUTINE: &str = "sub_";

/// The stem that the main program's file has in a folder of Click's ladders.
const MAIN: &str = "main";

/// Whether a file that comes with a program holds one of its subroutines.
pub(in super::super) fn is_subroutine_of(program: &str, file: &str) -> bool {
    program == MAIN && subroutine(file).is_some()
}

/// The name of the subroutine that a file holds, as its own name has it.
fn subroutine(file: &str) -> Option<&str> {
    let stem = file.strip_suffix(".csv")?;
    match stem.split_once('/') {
        Some((folder, name)) => (folder == SUBROUTINES).then_some(name),
        None => stem.strip_prefix(SUBROUTINE),
    }
}

/// The letters and digits of a name, small: files of subroutines are found by these.
fn plain(name: &str) -> String {
    let mut out = String::new();
    for c in name.to_lowercase().chars() {
        match c.is_alphanumeric() {
            true => out.push(c),
            false if out.ends_with('_') => {}
            false => out.push('_'),
        }
    }
    out.trim_matches('_').to_owned()
}

/// A program, with its subroutines and nicknames where they are next to it; `to_ladder` makes ladder text of what is in
/// its files.
pub(in super::super) fn read(
    source: &Source<'_>,
    to_ladder: impl FnOnce(&Program) -> Reading,
) -> Result<Reading, ReadError> {
    let mut texts = Texts::default();
    let mut reader = Reader::default();
    let grid = file::read(source.bytes, 0)?;
    texts.note(&grid);
    let own = routine(MAIN, &grid, &mut reader);
    let mut program = Program::default();
    let name = match source.name.strip_prefix(SUBROUTINE) {
        Some(name) => Some(name),
        None => (source.name != MAIN && goes_back(&own)).then_some(&*source.name),
    };
    match name {
        Some(name) => program.subroutines.push(Routine {
            name: name.to_owned(),
            ..own
        }),
        None => program.main = own,
    }
    // What was copied out of a program is not a program, and has no end.
    let is_lone = grid.rungs.len() == 1;
    let mut before = source.bytes.split(|byte| *byte == b'\n').count() as u32;
    let mut files = Vec::new();
    for companion in source
        .companions
        .iter()
        .filter(|one| is_subroutine_of(&source.name, &one.name))
    {
        let own = subroutine(&companion.name).unwrap_or_default();
        let call = call_of(&program.main, own);
        let name = call
            .as_ref()
            .map_or_else(|| own.to_owned(), |(name, _)| name.clone());
        let place = call.map_or(LineColumn::START, |(_, place)| place);
        let failure =
            |error: ReadError| ReadError::whole(format!("{}:{}", companion.name, Later { before, error }));
        let grid = file::read(&companion.bytes, before).map_err(failure)?;
        texts.note(&grid);
        files.push(File {
            before,
            name: &companion.name,
            place,
        });
        program.subroutines.push(routine(&name, &grid, &mut reader));
        before += companion.bytes.split(|byte| *byte == b'\n').count() as u32;
    }
    let mut nicknames = nicknames::next_to(source)?;
    program.nicknames = std::mem::take(&mut nicknames.all);
    nicknames.unused(&program);
    let mut reading = to_ladder(&program);
    reading.report = texts.joined(reading.report, reader.report);
    reading.findings.extend(reader.findings);
    for found in &mut reading.findings {
        if is_lone && matches!(found.check, "click-c0201" | "click-c0105") {
            found.severity = Severity::Info;
        }
    }
    reading.findings.sort_by_key(|found| found.place);
    for file in files.iter().rev() {
        file.bring_home(&mut reading);
    }
    reading.report.entries.splice(0..0, nicknames.report.entries);
    reading.findings.splice(0..0, nicknames.findings);
    Ok(reading)
}

fn routine(name: &str, grid: &Grid, reader: &mut Reader) -> Routine {
    for rung in &grid.rungs {
        reader.rung(rung);
    }
    let after = reader.finish(&grid.end);
    Routine {
        name: name.to_owned(),
        place: grid
            .rungs
            .first()
            .and_then(|rung| rung.rows.first())
            .map_or(LineColumn::START, |row| row.place),
        rungs: std::mem::take(&mut reader.rungs),
        after,
        ..Routine::default()
    }
}

/// Whether a routine is a subroutine by what it does: it goes back, and has no end.
fn goes_back(routine: &Routine) -> bool {
    let actions = routine.rungs.iter().flat_map(|rung| &rung.actions);
    let has = |what: &Instruction| actions.clone().any(|action| action.what == *what);
    has(&Instruction::Return) && !has(&Instruction::End)
}

/// The name and place of the first call of the subroutine that a file holds.
fn call_of(main: &Routine, file: &str) -> Option<(String, LineColumn)> {
    let mut actions = main.rungs.iter().flat_map(|rung| &rung.actions);
    let file = plain(file);
    actions.find_map(|action| match &action.what {
        Instruction::Call(name) if plain(name) == file => Some((name.clone(), action.place)),
        _ => None,
    })
}

/// What is at each place of the grids.
#[derive(Default)]
struct Texts {
    texts: HashMap<LineColumn, String>,
}

impl Texts {
    fn note(&mut self, grid: &Grid) {
        for row in grid.rungs.iter().flat_map(|rung| &rung.rows) {
            let contacts = row.cells.iter().filter_map(|cell| match &cell.body {
                Body::Contact(contact) => Some(contact),
                _ => None,
            });
            for text in contacts.chain(&row.output) {
                self.texts.insert(text.place, text.text.clone());
            }
        }
    }

    /// One entry for each cell, also where a contact appears several times in the model: what is worst of it.
    fn joined(&self, sketch: Report, grid: Report) -> Report {
        let mut out = Report::default();
        let mut by_place: HashMap<LineColumn, usize> = HashMap::new();
        for mut entry in sketch.entries.into_iter().chain(grid.entries) {
            let Some(text) = self.texts.get(&entry.place) else {
                out.entries.push(entry);
                continue;
            };
            entry.element.clone_from(text);
            match by_place.get(&entry.place) {
                Some(there) => {
                    let there = &mut out.entries[*there];
                    if weight(&entry.outcome) > weight(&there.outcome) {
                        *there = entry;
                    }
                }
                None => {
                    by_place.insert(entry.place, out.entries.len());
                    out.entries.push(entry);
                }
            }
        }
        out.entries.sort_by_key(|entry| entry.place);
        out
    }
}

const fn weight(outcome: &Outcome) -> u8 {
    match outcome {
        Outcome::Translated => 0,
        Outcome::Approximated(_) => 1,
        Outcome::Refused(_) => 2,
    }
}

/// A subroutine's file. Its lines are counted on from those of the files before it, so that each place is one of one
/// file; who reads the program knows only places of the main one.
struct File<'s> {
    /// How many lines all files before it have.
    before: u32,
    name: &'s str,
    /// Where the main program calls it.
    place: LineColumn,
}

impl File<'_> {
    /// Findings in it are reported at the call, with the place in words.
    fn bring_home(&self, reading: &mut Reading) {
        let own = |place: LineColumn| {
            (place.line > self.before).then(|| LineColumn {
                line: place.line - self.before,
                ..place
            })
        };
        for place in &mut reading.places {
            if own(*place).is_some() {
                *place = self.place;
            }
        }
        for entry in &mut reading.report.entries {
            let Some(place) = own(entry.place) else { continue };
            entry.place = self.place;
            if let Outcome::Approximated(why) | Outcome::Refused(why) = &mut entry.outcome {
                *why = format!("{}:{place}: {why}", self.name);
            }
        }
        for Finding { place, message, .. } in &mut reading.findings {
            let Some(own) = own(*place) else { continue };
            *place = self.place;
            *message = format!("{}:{own}: {message}", self.name);
        }
    }
}

/// An error in a file whose lines are counted on from others.
struct Later {
    before: u32,
    error: ReadError,
}

impl std::fmt::Display for Later {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self.error.place {
            Some(place) => write!(
                f,
                "{}:{}: {}",
                place.line.saturating_sub(self.before),
                place.column,
                self.error.message
            ),
            None => write!(f, " {}", self.error.message),
        }
    }
}

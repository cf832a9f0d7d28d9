//! What a person did becomes a scenario: the inputs as they were given, and what the program made of them.
//!
//! The inputs are played once more to the program as it is now, from a cold start, and what it does is what the scenario
//! expects: so it passes, also where the program was changed meanwhile or tags were forced. Where what was seen was
//! something else, that is reported.

use super::played::{Played, Track, divisor};
use super::run::MOST_BLOCKS;
use crate::session::{MOST_GIVEN, NotKnown, Session};
use crate::simulation::{Simulation, Status};
use crate::tags::Point;
use crate::value_text;
use ladder_analysis::program::Role;
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

/// A session as a scenario file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Recorded {
    /// The file.
    pub text: String,
    /// What a person should know of it.
    pub notes: Vec<String>,
}

/// This many values are written at most: a file of about as many bytes.
const MOST_CELLS: u64 = 10_000_000;

/// A session up to where it is as a scenario of this name; `program` is the program's file, as the scenario file
/// names it.
///
/// # Errors
/// Nothing has run, what was given is not known, nothing comes out of the program, or it would be too long: why there is no
/// scenario, and what to do.
pub fn record(session: &Session, program: &str, name: &str) -> Result<Recorded, String> {
    let scans = session.simulation().scans();
    if scans == 0 {
        return Err("nothing has run yet: run some scans, and record then".into());
    }
    let given = session.given().map_err(not_known)?;
    let mut notes = Vec::new();
    let options = session.simulation().options();
    let mut simulation =
        Simulation::new(session.newest_program().clone(), options).map_err(|error| error.message)?;
    let mut rows: BTreeMap<String, Row> = BTreeMap::new();
    let mut order: Vec<String> = Vec::new();
    let mut moments = BTreeSet::new();
    for (scan, point, value) in given.values().filter(|(scan, ..)| *scan < scans) {
        let found = session.find_in(&simulation, &point.name).ok();
        let Some(found) = found.filter(|found| found.ty == point.ty && !found.read_only) else {
            push_once(
                &mut notes,
                format!(
                    "{} is not in it: the program has no such tag any more",
                    point.name
                ),
            );
            continue;
        };
        let Some(text) = written(value, found.ty) else {
            continue;
        };
        let row = rows.entry(found.name.clone()).or_insert_with(|| {
            order.push(found.name.clone());
            Row {
                before: simulation.value(&found),
                point: found,
                cells: BTreeMap::new(),
                is_overwritten: false,
            }
        });
        row.cells.insert(scan, (value.clone(), text));
        moments.insert(scan);
    }
    let outputs = outputs(&simulation);
    if outputs.is_empty() {
        return Err("the program writes no tag that a scenario could look at".into());
    }
    let columns = scans / moments.iter().fold(scans, |step, &moment| divisor(step, moment));
    let of_outputs = outputs.iter().filter(|point| point.role == Role::Output).count();
    fits(columns, rows.len() + of_outputs.max(1), options.interval)?;
    let mut played = Played::new(&simulation, outputs, &moments, scans);
    play(&mut simulation, &mut rows, &mut played, scans)?;
    if played.scans < scans {
        push_once(&mut notes, "the program stops in the midst of it".into());
    }
    if session.simulation().has_serial() {
        push_once(&mut notes, "what came in at the serial port is not in it".into());
    }
    played.leave_out_what_rests();
    if differs(session, &played) {
        push_once(
            &mut notes,
            "the program was changed, or tags were forced, while this was recorded: what is expected is what the program \
             does now with the same inputs"
                .into(),
        );
    }
    let step = played.step();
    let steps = played.scans / step;
    if steps == 0 {
        return Err("the program stops in its first scan".into());
    }
    fits(steps, rows.len() + played.tracks.len(), options.interval)?;
    let mut text = format!(
        "program {}\nstep {}\ninterval {}\n\nscenario \"{}\"\n",
        quoted(program),
        duration(step as i64 * options.interval),
        duration(options.interval),
        name.replace('"', "'")
    );
    let width = order
        .iter()
        .chain(played.tracks.iter().map(|track| &track.point.name));
    let width = width.map(|name| name.chars().count()).max().unwrap_or(0);
    for name in &order {
        let row = &rows[name];
        // A level that nothing but the outside changes is drawn as it is.
        let is_level = row.point.ty == Scalar::Bool && !row.is_overwritten;
        let mut level = is_level.then(|| written(&row.before, row.point.ty)).flatten();
        let cells = (0..steps).map(|column| {
            let given = row.cells.get(&(column * step)).map(|(_, text)| text.clone());
            if is_level && given.is_some() {
                level.clone_from(&given);
            }
            given.or_else(|| level.clone())
        });
        let _ = writeln!(text, "{name:width$}    {}", line(row.point.ty, cells));
    }
    for track in &played.tracks {
        let Track { point, .. } = track;
        let values = track.at((1..=steps).map(|column| column * step - 1));
        let cells = values.map(|value| written(value, point.ty));
        let _ = writeln!(text, "{:width$} => {}", point.name, line(point.ty, cells));
    }
    Ok(Recorded { text, notes })
}

/// Why there is no scenario where it is not known what was given.
fn not_known(why: NotKnown) -> String {
    match why {
        NotKnown::NoHistory => {
            "what was given is only known where scans are kept: let `history` in ladder.toml be more than 0, and start again"
                .into()
        }
        NotKnown::LateStart => {
            "a scenario starts cold, and this session began after the first scan: restart, do it again, and record then"
                .into()
        }
        NotKnown::TooMany => format!(
            "more than {MOST_GIVEN} values were given since the start, and no more are kept: restart, do it again in a shorter \
             time, and record then"
        ),
    }
}

/// Whether a file of this many columns and rows is one that can be read.
fn fits(columns: u64, rows: usize, interval: i64) -> Result<(), String> {
    let cells = columns.saturating_mul(rows as u64);
    if cells <= MOST_CELLS {
        return Ok(());
    }
    let most = (MOST_CELLS / rows as u64).saturating_mul(interval as u64);
    Err(format!(
        "a column for each moment in which something was given makes {columns} columns in {rows} rows, and a scenario has at \
         most {MOST_CELLS} values: restart, do it again within {}, and record then",
        duration(i64::try_from(most).unwrap_or(i64::MAX) / 60_000_000_000 * 60_000_000_000)
    ))
}

/// How the file of a recorded scenario may be called that is next to a program: `motor-recorded.ladder-test`.
pub fn recorded_file(program: &str) -> String {
    let stem = program.rsplit_once('.').map_or(program, |(stem, _)| stem);
    format!("{stem}-recorded.ladder-test")
}

struct Row {
    point: Point,
    /// By scan: what was given before it, and as it is written.
    cells: BTreeMap<u64, (Value, String)>,
    /// What it holds in a cold start.
    before: Value,
    /// The program writes it too.
    is_overwritten: bool,
}

fn push_once(notes: &mut Vec<String>, note: String) {
    if !notes.contains(&note) {
        notes.push(note);
    }
}

/// What a scenario checks: the outputs, then what else the program has, but for members.
fn outputs(simulation: &Simulation) -> Vec<Point> {
    let points = simulation.points().iter();
    let points = points.filter(|point| !point.read_only && point.role != Role::Input);
    let (outputs, others): (Vec<&Point>, Vec<&Point>) = points.partition(|point| point.role == Role::Output);
    let others = others.into_iter().filter(|point| !point.name.contains('.'));
    outputs.into_iter().chain(others).cloned().collect()
}

/// Plays what was given, and notes what the outputs hold after each scan, as far as the program runs.
fn play(
    simulation: &mut Simulation,
    rows: &mut BTreeMap<String, Row>,
    played: &mut Played,
    scans: u64,
) -> Result<(), String> {
    let begun = simulation.work();
    for scan in 0..scans {
        for row in rows.values() {
            if let Some((value, _)) = row.cells.get(&scan) {
                // It is of the tag's type.
                let _ = simulation.set(&row.point, value.clone());
            }
        }
        if simulation.status() != Status::Ready || !simulation.scan() {
            break;
        }
        if simulation.work() - begun > MOST_BLOCKS {
            return Err(format!(
                "{scans} scans of this program take too long to be played again, as every run of the scenario would: restart, do \
                 it again in a shorter time, and record then"
            ));
        }
        for row in rows.values_mut() {
            let given = row.cells.range(..=scan).next_back();
            let given = given.map_or(&row.before, |(_, (value, _))| value);
            row.is_overwritten |= simulation.value(&row.point) != *given;
        }
        played.note(simulation);
    }
    Ok(())
}

/// Whether the session saw anything else, as far as it is kept.
fn differs(session: &Session, played: &Played) -> bool {
    let seen: Vec<Point> = played
        .tracks
        .iter()
        .filter_map(|track| session.find(&track.point.name).ok())
        .collect();
    if seen.len() < played.tracks.len() {
        return true;
    }
    let past = session.past(&seen, usize::try_from(played.scans).unwrap_or(usize::MAX));
    let kept = past.first().map_or(0, Vec::len) as u64;
    // What an earlier program did that is no longer kept is not known to have been the same.
    if kept < played.scans && session.newest_generation() > 0 {
        return true;
    }
    let first = played.scans - kept;
    let noted = || (first..played.scans).filter(|scan| played.is_noted(*scan));
    played.tracks.iter().zip(&past).any(|(track, past)| {
        let seen = noted().map(|scan| &past[(scan - first) as usize]);
        track.at(noted()).ne(seen)
    })
}

/// A value as a scenario has it; none if it could not be read back.
fn written(value: &Value, ty: Scalar) -> Option<String> {
    let text = value_text::display(value, ty);
    (value_text::parse(&text, ty).as_ref() == Ok(value)).then_some(text)
}

/// The cells of a row.
fn line(ty: Scalar, cells: impl Iterator<Item = Option<String>>) -> String {
    if ty == Scalar::Bool {
        let letters = cells.map(|cell| match cell.as_deref() {
            Some("TRUE") => '-',
            Some(_) => '_',
            None => '.',
        });
        return letters.collect();
    }
    let cells: Vec<String> = cells.map(|cell| cell.unwrap_or_else(|| ".".into())).collect();
    cells.join(" ")
}

fn duration(nanoseconds: i64) -> String {
    let text = value_text::display(&Value::Int(nanoseconds), Scalar::Time);
    text.trim_start_matches("T#").to_owned()
}

/// A file's name, in quotes where it holds what would end it.
fn quoted(name: &str) -> String {
    if name.contains(['#', '\'', '[', '=']) {
        format!("\"{name}\"")
    } else {
        name.to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::fits;

    #[test]
    fn a_file_that_nobody_could_open_is_refused_with_what_to_do() {
        assert_eq!(fits(360_000, 20, 10_000_000), Ok(()));
        let refused = fits(3_600_000, 20, 10_000_000).unwrap_err();
        assert!(refused.contains("3600000 columns in 20 rows"), "{refused}");
        assert!(refused.contains("do it again within 1h23m"), "{refused}");
    }
}

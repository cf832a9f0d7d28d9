//! What a person did becomes a scenario: the inputs as they were given, and what the program made of them.
//!
//! The inputs are played once more to the program as it is now, from a cold start, and what it does is what the scenario
//! expects: so it passes, also where the program was changed meanwhile or tags were forced. Where what was seen was
//! something else, that is reported.

use super::bind::{MOST_SCANS, bind};
use super::monitor::Watched;
use super::parse::parse;
use super::plants::lines_of;
use super::played::{Choice, Played};
use super::run::{MOST_BLOCKS, run};
use super::run_text::{self, Lengths, RunCell, RunRow};
use crate::session::{MOST_GIVEN, NotKnown, Session};
use crate::simulation::{Simulation, Status};
use crate::tags::Point;
use crate::value_text;
use ladder_analysis::Cancel;
use ladder_analysis::program::Role;
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use std::collections::{BTreeMap, BTreeSet};

/// A session as a scenario file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Recorded {
    /// The file.
    pub text: String,
    /// The tags of which something is expected.
    pub expected: Vec<String>,
    /// What a person should know of it.
    pub notes: Vec<String>,
}

/// This many values are written at most: a file of about as many bytes.
const MOST_CELLS: u64 = 10_000_000;

/// What is wanted of a recording.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Wanted<'a> {
    /// The program's file, as the scenario file names it.
    pub program: &'a str,
    /// What the scenario is called.
    pub name: &'a str,
    /// The tags of which is expected what they hold; the outputs, and a few other BOOLs that change, unless they are chosen.
    pub outputs: Option<&'a [String]>,
}

/// A tag that a recording may expect something of.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Recordable {
    /// The tag.
    pub name: String,
    /// Its type.
    pub ty: Scalar,
    /// Whether it is an output.
    pub is_output: bool,
}

/// The tags among which the rows of what is expected can be chosen: outputs, then the other tags, then members.
pub fn recordable(session: &Session) -> Vec<Recordable> {
    let points = session.simulation().points().iter();
    let points = points.filter(|point| !point.read_only && !point.is_input);
    let mut found: Vec<Recordable> = points
        .map(|point| Recordable {
            name: point.name.clone(),
            ty: point.ty,
            is_output: point.role == Role::Output,
        })
        .collect();
    found.sort_by_key(|it| (!it.is_output, it.name.contains('.')));
    found
}

/// A session up to where it is as a scenario.
///
/// # Errors
/// Nothing has run, what was given is not known, nothing comes out of the program, it would be too long, or it is
/// cancelled: why there is no scenario, and what to do.
pub fn record(session: &Session, wanted: Wanted<'_>) -> Result<Recorded, String> {
    let scans = session.simulation().scans();
    if scans == 0 {
        return Err("nothing has run yet: run some scans, and record then".into());
    }
    let given = session.given().map_err(not_known)?;
    let mut notes = Vec::new();
    let options = session.simulation().options();
    let fresh = || Simulation::new(session.newest_program().clone(), options).map_err(|error| error.message);
    let cancel = session.simulation().machine.cancel.as_ref();
    let mut simulation = fresh()?;
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
        let text = value.map_or(Some("~".to_owned()), |value| written(value, found.ty));
        let Some(text) = text else { continue };
        let row = rows.entry(found.name.clone()).or_insert_with(|| {
            order.push(found.name.clone());
            Row {
                before: simulation.value(&found),
                is_overwritten: simulation.is_driven(&found),
                point: found,
                cells: BTreeMap::new(),
            }
        });
        row.cells.insert(scan, (value.cloned(), text));
        moments.insert(scan);
    }
    let (outputs, choice) = match wanted.outputs {
        Some(chosen) => (chosen_points(chosen, &simulation)?, Choice::Chosen),
        None => (outputs(&simulation), Choice::Usual),
    };
    if outputs.is_empty() {
        return Err("the program writes no tag that a scenario could look at".into());
    }
    fits(moments.len() as u64, rows.len() + 1, scans)?;
    let mut played = Played::new(&simulation, outputs, choice);
    let ran = play(&mut simulation, &mut rows, scans, cancel, |simulation, scan| {
        played.note(simulation, scan);
    })?;
    if ran == 0 {
        return Err("the program stops in its first scan".into());
    }
    if ran < scans {
        push_once(&mut notes, "the program stops in the midst of it".into());
    }
    if session.simulation().has_serial() {
        push_once(&mut notes, "what came in at the serial port is not in it".into());
    }
    let mut begins = played.begins(&moments);
    begins.split_off(&ran);
    let ends: BTreeSet<u64> = begins.iter().copied().skip(1).chain([ran]).collect();
    play(&mut fresh()?, &mut rows, ran, cancel, |simulation, scan| {
        if ends.contains(&(scan + 1)) {
            played.hold(simulation);
        }
    })?;
    played.leave_out_what_rests();
    if differs(session, &played, &ends, ran) {
        push_once(
            &mut notes,
            "the program was changed, or tags were forced, while this was recorded: what is expected is what the program \
             does now with the same inputs"
                .into(),
        );
    }
    fits(ends.len() as u64, rows.len() + played.tracks.len(), scans)?;
    let columns: Vec<u64> = begins.iter().zip(&ends).map(|(begin, end)| end - begin).collect();
    let given_rows = order.iter().map(|name| rows[name].written(name, &begins));
    let expected_rows = played.tracks.iter().map(|track| RunRow {
        name: track.point.name.clone(),
        is_expected: true,
        is_level: track.point.ty == Scalar::Bool,
        goes_on: true,
        cells: track
            .held
            .iter()
            .map(|value| written(value, track.point.ty).map_or(RunCell::Nothing, RunCell::New))
            .collect(),
    });
    let all: Vec<RunRow> = given_rows.chain(expected_rows).collect();
    let lengths = Lengths {
        columns: &columns,
        interval: options.interval,
    };
    Ok(Recorded {
        text: format!(
            "{}{}{}",
            program_line(wanted.program),
            lines_of(simulation.program()),
            run_text::text(&all, lengths, wanted.name)
        ),
        expected: played
            .tracks
            .iter()
            .map(|track| track.point.name.clone())
            .collect(),
        notes,
    })
}

/// Whether a recorded scenario passes, when it is run as a test.
pub fn passes(session: &Session, recorded: &Recorded) -> bool {
    let suite = parse(&recorded.text);
    let options = session.simulation().options();
    let Ok(mut simulation) = Simulation::new(session.newest_program().clone(), options) else {
        return false;
    };
    let (cases, errors) = bind(&suite, &simulation);
    suite.errors.is_empty()
        && errors.is_empty()
        && cases
            .iter()
            .all(|case| run(case, &mut Watched::default(), &mut simulation, Simulation::scan).passed())
}

/// The tags that a person chose.
fn chosen_points(names: &[String], simulation: &Simulation) -> Result<Vec<Point>, String> {
    if names.is_empty() {
        return Err("no tag is chosen, and a scenario expects something: choose one at least".into());
    }
    let mut points: Vec<Point> = Vec::new();
    for name in names {
        let point = simulation.resolve(name).map_err(|unknown| unknown.message)?;
        if !points.iter().any(|known| known.name == point.name) {
            points.push(point);
        }
    }
    Ok(points)
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

/// Whether a file of this many columns and rows is one that can be read, and one that can be run.
fn fits(columns: u64, rows: usize, scans: u64) -> Result<(), String> {
    const AGAIN: &str = "restart, do it again in a shorter time, and record then";
    if scans > MOST_SCANS {
        return Err(format!(
            "a scenario has at most {MOST_SCANS} scans, and these are {scans}: {AGAIN}"
        ));
    }
    if columns.saturating_mul(rows as u64) > MOST_CELLS {
        return Err(format!(
            "a column for each moment in which something was given makes {columns} columns in {rows} rows, and a scenario has \
             at most {MOST_CELLS} values: {AGAIN}"
        ));
    }
    Ok(())
}

/// How the file of a recorded scenario may be called that is next to a program: `motor-recorded.ladder-test`.
pub fn recorded_file(program: &str) -> String {
    let stem = program.rsplit_once('.').map_or(program, |(stem, _)| stem);
    format!("{stem}-recorded.ladder-test")
}

struct Row {
    point: Point,
    /// By scan: what was given before it, none where it was given back to the plant, and as it is written.
    cells: BTreeMap<u64, (Option<Value>, String)>,
    /// What it holds in a cold start.
    before: Value,
    /// The program writes it too, or a plant.
    is_overwritten: bool,
}

impl Row {
    /// What is written of it, for columns that begin before these scans.
    fn written(&self, name: &str, begins: &BTreeSet<u64>) -> RunRow {
        // A level that nothing but the outside changes is drawn as it is.
        let is_level = self.point.ty == Scalar::Bool;
        let is_drawn = is_level && !self.is_overwritten;
        let mut level = is_drawn.then(|| written(&self.before, self.point.ty)).flatten();
        let cells = begins.iter().map(|begin| match self.cells.get(begin) {
            Some((_, text)) => {
                if is_drawn {
                    level = Some(text.clone());
                }
                RunCell::New(text.clone())
            }
            None => level.clone().map_or(RunCell::Nothing, RunCell::Still),
        });
        RunRow {
            cells: cells.collect(),
            name: name.to_owned(),
            is_expected: false,
            is_level,
            goes_on: is_drawn,
        }
    }
}

fn push_once(notes: &mut Vec<String>, note: String) {
    if !notes.contains(&note) {
        notes.push(note);
    }
}

/// What a scenario checks: the outputs, then what else the program has, but for members.
fn outputs(simulation: &Simulation) -> Vec<Point> {
    let points = simulation.points().iter();
    // What a plant does is the machine's matter.
    let is_own =
        |point: &&Point| simulation.program().plant_of(&point.name).is_none() && !simulation.is_driven(point);
    let points = points
        .filter(|point| !point.read_only && !point.is_input)
        .filter(is_own);
    let (outputs, others): (Vec<&Point>, Vec<&Point>) = points.partition(|point| point.role == Role::Output);
    let others = others.into_iter().filter(|point| !point.name.contains('.'));
    outputs.into_iter().chain(others).cloned().collect()
}

/// Plays what was given, as far as the program runs: how many scans that are. `after` sees each of them.
fn play(
    simulation: &mut Simulation,
    rows: &mut BTreeMap<String, Row>,
    scans: u64,
    cancel: Option<&Cancel>,
    mut after: impl FnMut(&Simulation, u64),
) -> Result<u64, String> {
    let begun = simulation.work();
    for scan in 0..scans {
        for row in rows.values() {
            match row.cells.get(&scan) {
                // It is of the tag's type.
                Some((Some(value), _)) => drop(simulation.set(&row.point, value.clone())),
                Some((None, _)) => simulation.unforce(&row.point),
                None => {}
            }
        }
        if simulation.status() != Status::Ready || !simulation.scan() {
            return Ok(scan);
        }
        if simulation.work() - begun > MOST_BLOCKS || cancel.is_some_and(Cancel::is_cancelled) {
            return Err(format!(
                "{scans} scans of this program take too long to be played again, as every run of the scenario would: restart, do \
                 it again in a shorter time, and record then"
            ));
        }
        for row in rows.values_mut() {
            let given = row.cells.range(..=scan).next_back();
            let given = given.map_or(&row.before, |(_, (value, _))| {
                value.as_ref().unwrap_or(&row.before)
            });
            row.is_overwritten |= simulation.value(&row.point) != *given;
        }
        after(simulation, scan);
    }
    Ok(scans)
}

/// Whether the session saw anything else at the ends of columns, as far as it is kept.
fn differs(session: &Session, played: &Played, ends: &BTreeSet<u64>, scans: u64) -> bool {
    let seen: Vec<Point> = played
        .tracks
        .iter()
        .filter_map(|track| session.find(&track.point.name).ok())
        .collect();
    if seen.len() < played.tracks.len() {
        return true;
    }
    let past = session.past(&seen, usize::try_from(scans).unwrap_or(usize::MAX));
    let kept = past.first().map_or(0, Vec::len) as u64;
    // What an earlier program did that is no longer kept is not known to have been the same.
    if kept < scans && session.newest_generation() > 0 {
        return true;
    }
    let first = scans - kept;
    played.tracks.iter().zip(&past).any(|(track, past)| {
        let held = ends.iter().zip(&track.held).filter(|(end, _)| **end > first);
        held.into_iter()
            .any(|(end, held)| past[(end - 1 - first) as usize] != *held)
    })
}

/// A value as a scenario has it; none if it could not be read back.
pub(super) fn written(value: &Value, ty: Scalar) -> Option<String> {
    let text = value_text::display(value, ty);
    (value_text::parse(&text, ty).as_ref() == Ok(value)).then_some(text)
}

/// The line of a file of scenarios that names its program: in quotes where the name holds what would end it.
pub fn program_line(name: &str) -> String {
    file_line("program", name, "")
}

/// A line that names a file, likewise.
pub(super) fn file_line(word: &str, name: &str, after: &str) -> String {
    let quote = if name.contains(['#', '\'', '[', '=']) {
        "\""
    } else {
        ""
    };
    format!("{word} {quote}{name}{quote}{after}\n")
}

#[cfg(test)]
mod tests {
    use super::fits;

    #[test]
    fn a_file_that_nobody_could_open_is_refused_with_what_to_do() {
        assert_eq!(fits(360_000, 20, 360_000), Ok(()));
        let refused = fits(3_600_000, 20, 3_600_000).unwrap_err();
        assert!(refused.contains("3600000 columns in 20 rows"), "{refused}");
        assert!(refused.contains("do it again in a shorter time"), "{refused}");
        assert!(fits(2, 2, 36_000_000).is_err());
    }
}

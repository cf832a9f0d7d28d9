//! What a person did becomes a scenario: the inputs as they were given, and what the program made of them.
//!
//! The inputs are played once more to the program as it is now, from a cold start, and what it does is what the scenario
//! expects: so it passes, also where the program was changed meanwhile or tags were forced. Where what was seen was
//! something else, that is said.

use crate::session::Session;
use crate::simulation::{Simulation, Status};
use crate::tags::Point;
use crate::value_text;
use ladder_analysis::program::Role;
use ladder_analysis::types::Scalar;
use ladder_analysis::value::Value;
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

/// With more rows than this only outputs are looked at.
const MOST_ROWS: usize = 8;

/// So many columns can be read; with more a step takes no account of what the outputs do in between.
const READABLE: u64 = 200;

/// A session up to where it is as a scenario of this name; `program` is the program's file, as the scenario file
/// names it.
///
/// # Errors
/// Nothing has run, the beginning is not kept any more, or nothing comes out of the program: why there is no scenario.
pub fn record(session: &Session, program: &str, name: &str) -> Result<Recorded, String> {
    let scans = session.simulation().scans();
    if scans == 0 {
        return Err("nothing has run yet: run some scans, and record then".into());
    }
    let Some(given) = session.given() else {
        return Err(
            "a scenario starts cold, and the first scans are not kept any more: restart, do it again, and record then"
                .into(),
        );
    };
    let mut notes = Vec::new();
    let options = session.simulation().options();
    let mut simulation =
        Simulation::new(session.newest_program().clone(), options).map_err(|error| error.message)?;
    let mut rows: BTreeMap<String, Row> = BTreeMap::new();
    let mut order: Vec<String> = Vec::new();
    let mut moments = BTreeSet::new();
    for before in given.iter().filter(|before| before.scan < scans) {
        for (point, value) in &before.values {
            let found = simulation.resolve(&point.name).ok();
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
            row.cells.insert(before.scan, (value.clone(), text));
            moments.insert(before.scan);
        }
    }
    let mut outputs = outputs(&simulation);
    if outputs.is_empty() {
        return Err("the program writes no tag that a scenario could look at".into());
    }
    let cold: Vec<Value> = outputs.iter().map(|point| simulation.value(point)).collect();
    let mut played = play(&mut simulation, &mut rows, &outputs, scans);
    if played.len() < scans as usize {
        push_once(&mut notes, "the program stops in the midst of it".into());
    }
    if session.simulation().has_serial() {
        push_once(&mut notes, "what came in at the serial port is not in it".into());
    }
    if differs(session, &outputs, &played) {
        push_once(
            &mut notes,
            "the program was changed, or tags were forced, while this was recorded: what is expected is what the program \
             does now with the same inputs"
                .into(),
        );
    }
    leave_out_what_rests(&mut outputs, &mut played, &cold);
    let scans = played.len() as u64;
    let step = step(&moments, &outputs_change(&played), scans);
    let steps = scans / step;
    if steps == 0 {
        return Err("the program stops in its first scan".into());
    }
    let mut text = format!(
        "program {}\nstep {}\ninterval {}\n\nscenario \"{}\"\n",
        quoted(program),
        duration(step as i64 * options.interval),
        duration(options.interval),
        name.replace('"', "'")
    );
    let width = order.iter().chain(outputs.iter().map(|point| &point.name));
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
    for (index, point) in outputs.iter().enumerate() {
        let cells = (1..=steps).map(|column| written(&played[(column * step - 1) as usize][index], point.ty));
        let _ = writeln!(text, "{:width$} => {}", point.name, line(point.ty, cells));
    }
    Ok(Recorded { text, notes })
}

/// How the file of a recorded scenario may be called that is beside a program: `motor-recorded.ladder-test`.
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

/// What a scenario looks at: the outputs, then what else the program has, but for members.
fn outputs(simulation: &Simulation) -> Vec<Point> {
    let points = simulation.points().iter();
    let points = points.filter(|point| !point.read_only && point.role != Role::Input);
    let (outputs, others): (Vec<&Point>, Vec<&Point>) = points.partition(|point| point.role == Role::Output);
    let others = others.into_iter().filter(|point| !point.name.contains('.'));
    outputs.into_iter().chain(others).cloned().collect()
}

/// Beside the outputs only a few other tags are looked at, and only those that change: BOOLs, or whatever there is where
/// nothing else comes out of the program.
/// `cold` is what they hold in a cold start.
fn leave_out_what_rests(points: &mut Vec<Point>, played: &mut [Vec<Value>], cold: &[Value]) {
    let changes = |index: usize| played.iter().any(|values| values[index] != cold[index]);
    let changes: Vec<bool> = (0..points.len()).map(changes).collect();
    let is_output = |point: &Point| point.role == Role::Output;
    let is_level = |point: &Point, changes: bool| changes && !is_output(point) && point.ty == Scalar::Bool;
    let kinds = || points.iter().zip(changes.iter().copied());
    let outputs = kinds().filter(|(point, _)| is_output(point)).count();
    let levels = kinds()
        .filter(|(point, changes)| is_level(point, *changes))
        .count();
    let rests = changes.iter().all(|changes| !changes);
    let keep: Vec<bool> = kinds()
        .map(|(point, changes)| {
            is_output(point)
                || (outputs + levels <= MOST_ROWS && is_level(point, changes))
                || (outputs == 0 && (changes || rests))
        })
        .collect();
    let mut kept = keep.iter();
    points.retain(|_| kept.next().copied().unwrap_or_default());
    for values in played {
        let mut kept = keep.iter();
        values.retain(|_| kept.next().copied().unwrap_or_default());
    }
}

/// What the outputs hold after each scan, as far as the program runs.
fn play(
    simulation: &mut Simulation,
    rows: &mut BTreeMap<String, Row>,
    outputs: &[Point],
    scans: u64,
) -> Vec<Vec<Value>> {
    let mut played = Vec::new();
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
        for row in rows.values_mut() {
            let given = row.cells.range(..=scan).next_back();
            let given = given.map_or(&row.before, |(_, (value, _))| value);
            row.is_overwritten |= simulation.value(&row.point) != *given;
        }
        played.push(outputs.iter().map(|point| simulation.value(point)).collect());
    }
    played
}

/// Whether the session saw anything else, as far as it is kept.
fn differs(session: &Session, outputs: &[Point], played: &[Vec<Value>]) -> bool {
    let seen: Vec<Point> = outputs
        .iter()
        .filter_map(|point| session.simulation().resolve(&point.name).ok())
        .collect();
    if seen.len() < outputs.len() {
        return true;
    }
    let past = session.past(&seen, played.len());
    past.iter().enumerate().any(|(index, values)| {
        values.len() != played.len() || values.iter().zip(played).any(|(a, b)| *a != b[index])
    })
}

/// The scans that change an output.
fn outputs_change(played: &[Vec<Value>]) -> BTreeSet<u64> {
    let pairs = played.windows(2).zip(1u64..);
    pairs
        .filter(|(pair, _)| pair[0] != pair[1])
        .map(|(_, scan)| scan)
        .collect()
}

/// How many scans a column stands for: as many as all that happens is a multiple of.
fn step(given: &BTreeSet<u64>, changes: &BTreeSet<u64>, scans: u64) -> u64 {
    let common =
        |moments: &mut dyn Iterator<Item = &u64>| moments.fold(scans, |step, &moment| divisor(step, moment));
    let exact = common(&mut given.iter().chain(changes));
    if scans / exact <= READABLE {
        return exact;
    }
    common(&mut given.iter())
}

fn divisor(a: u64, b: u64) -> u64 {
    if b == 0 { a } else { divisor(b, a % b) }
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

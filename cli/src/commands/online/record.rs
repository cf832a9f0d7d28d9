//! What inputs did, reading by reading, in a file that a simulation plays.
//!
//! The first row has all tags that were read, so that latches begin as they were, but not timers and counters, which begin with
//! their rung; those after it have what the program takes from outside, as far as it has changed. A row stands for one interval:
//! where nothing was read it is empty.

use super::report::cell;
use super::{Arguments, heading};
use crate::outcome::{Failure, Outcome};
use crate::output::{Existing, Output};
use crate::terminal;
use ladder_analysis::values::value::Value;
use ladder_devices::online::Controller;
use ladder_devices::real::Asked;
use ladder_simulator::Point;
use ladder_simulator::online::Watching;
use ladder_workspace::shown;
use std::collections::HashSet;
use std::path::Path;
use std::sync::mpsc::RecvTimeoutError;
use std::time::Instant;

pub(super) fn record(
    arguments: &Arguments,
    file: &Path,
    controller: &Controller,
    mut watching: Watching,
) -> Result<Outcome, Failure> {
    let simulation = watching.online().simulation();
    let mut named = HashSet::new();
    for tag in &arguments.watch {
        let points = simulation.resolve_all(tag);
        let points = points.map_err(|unknown| Failure::new(format!("--watch {tag}: {unknown}")))?;
        named.extend(points.into_iter().map(|point| point.name));
    }
    let points = watching.online().points().into_iter();
    let is_recorded = |point: &Point| {
        watching.online().is_known(point) && (point.takes_force() || named.contains(&point.name))
    };
    let points: Vec<Point> = points.filter(is_recorded).collect();
    let asked = crate::signals::asked(arguments.length)
        .map_err(|error| Failure::new(format!("signals cannot be watched: {error}")))?;
    let mut out = Output::open(Some(file), Existing::by(arguments.force))?;
    let names: Vec<String> = points.iter().map(|point| cell(&point.name)).collect();
    out.write_text(&(names.join(",") + "\n"))?;
    let mut before: Vec<Option<Value>> = vec![None; points.len()];
    terminal::note(&format_args!(
        "{}; Ctrl+C ends the recording",
        heading(controller, &watching)
    ));
    let (every, began) = (controller.every(), Instant::now());
    let mut rows = 0u32;
    let mut lost = 0u32;
    loop {
        let is_new = rows == 0 || watching.look();
        let row: Vec<String> = points
            .iter()
            .zip(&mut before)
            .map(|(point, before)| {
                let online = watching.online();
                let is_asked = rows == 0 || point.is_input || named.contains(&point.name);
                if !is_new || !is_asked || !online.is_known(point) {
                    return String::new();
                }
                let value = online.simulation().value(point);
                if before.as_ref() == Some(&value) {
                    return String::new();
                }
                let text = ladder_simulator::value_text::display(&value, point.ty);
                *before = Some(value);
                cell(&text)
            })
            .collect();
        out.write_text(&(row.join(",") + "\n"))?;
        lost += u32::from(!is_new);
        rows += 1;
        let due = began + every * rows;
        match asked.recv_timeout(due.saturating_duration_since(Instant::now())) {
            Ok(Asked::End) | Err(RecvTimeoutError::Disconnected) => break,
            Ok(_) | Err(RecvTimeoutError::Timeout) => {}
        }
    }
    out.finish()?;
    let missed = match lost {
        0 => String::new(),
        lost => format!(", {lost} of them without a reading"),
    };
    terminal::note(&format_args!(
        "{rows} rows{missed}: `ladder sim {} --inputs {} --dt {}ms --scans {rows}` plays them",
        shown::path(&arguments.file),
        shown::path(file),
        every.as_millis()
    ));
    Ok(Outcome::Fine)
}

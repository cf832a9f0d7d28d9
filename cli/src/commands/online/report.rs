//! What one reading came to.

use super::{MOST_TOLD, heading};
use crate::commands::render::text;
use crate::commands::why;
use crate::findings::Source;
use crate::outcome::{Failure, Outcome};
use crate::output::Output;
use crate::terminal::{self, Stdout};
use ladder_devices::online::Controller;
use ladder_picture::letters::Style;
use ladder_simulator::online::{Doubt, Watching};
use ladder_simulator::value_text;
use ladder_workspace::shown;
use std::io::Write;

/// Writes the diagram with its power, and below it what is in doubt.
pub(super) fn once(
    source: &Source,
    controller: &Controller,
    watching: &mut Watching,
    asked: Option<&str>,
) -> Result<Outcome, Failure> {
    let mut out = Stdout::new();
    writeln!(out, "{}\n", heading(controller, watching))?;
    if let Some(tag) = asked {
        let point = watching.online().simulation().resolve(tag);
        let point = point.map_err(|unknown| Failure::new(unknown.to_string()))?;
        let judged = watching.why(&point);
        why::reasons(source, watching.online().simulation(), &judged, &mut out)?;
    } else {
        let drawn = text::drawn(source, Some(watching.online().simulation()), Style::default());
        write!(out, "{}", shown::text(&drawn))?;
    }
    let networks = watching.unknown();
    let online = watching.online();
    let program = online.simulation().program();
    let line = |network: usize| {
        let location = program.networks[network].location;
        (location.file == 0).then(|| source.place(location.range.start()).line)
    };
    let unknown: Vec<String> = networks
        .into_iter()
        .filter_map(line)
        .map(|line| line.to_string())
        .collect();
    if !unknown.is_empty() {
        writeln!(
            out,
            "\nnot known, because a value that they need was not read: the rungs in line {}",
            unknown.join(", ")
        )?;
    }
    for doubt in online.doubts() {
        let place = line(doubt.network).map_or_else(String::new, |line| format!("line {line}: "));
        writeln!(out, "\n{place}{}", shown::line(&doubt.to_string()))?;
    }
    out.flush()?;
    differences(watching);
    let contradicts = online.doubts().iter().any(Doubt::is_reported);
    Ok(if contradicts {
        Outcome::Findings
    } else {
        Outcome::Fine
    })
}

/// How controller and program differ, on stderr.
pub(super) fn differences(watching: &Watching) {
    for difference in watching.differences(MOST_TOLD) {
        terminal::note(&shown::line(&difference));
    }
}

/// The values of the last snapshot, for `ladder why --tags`.
pub(super) fn values(watching: &Watching, out: &mut Output) -> Result<(), Failure> {
    let online = watching.online();
    out.write_text("name,value\n")?;
    for point in online.points().iter().filter(|point| online.is_known(point)) {
        let value = value_text::display(&online.simulation().value(point), point.ty);
        out.write_text(&format!("{},{}\n", cell(&point.name), cell(&value)))?;
    }
    Ok(())
}

/// A cell of a table in CSV.
pub(super) fn cell(text: &str) -> String {
    if text.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.to_owned()
    }
}

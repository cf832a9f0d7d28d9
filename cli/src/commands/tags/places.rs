//! `ladder tags --map modbus`: where tags are on the wire, frozen so that an edit moves none.

use super::Format;
use crate::commands::run::served;
use crate::findings::Source;
use crate::outcome::{Failure, Outcome};
use crate::run::{place, program};
use crate::terminal::Stdout;
use clap::ValueEnum;
use ladder_devices::modbus::{Place, freeze};
use ladder_simulator::{Point, Simulation};
use ladder_workspace::Settings;
use std::io::Write;
use std::path::Path;

/// What serves tags.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum Protocol {
    /// Modbus TCP, as `[serve.modbus]` of ladder.toml has it
    Modbus,
}

/// A tag at its place.
struct Row {
    place: Place,
    point: Point,
    may_be_written: bool,
}

pub(super) fn write(file: &Path, source: &Source, format: Format) -> Result<Outcome, Failure> {
    let settings = Settings::of(file)?;
    let Some(program) = program(source) else {
        return Ok(Outcome::Findings);
    };
    let options = settings.simulate.options(&program, file);
    let simulation = Simulation::new(program, options)
        .map_err(|error| Failure::new(format!("{}: {}", place(source, error.location), error.message)))?;
    let map = served::map(&settings.modbus.unwrap_or_default(), file, &simulation)?;
    let there = map.tags().map(|(place, point, may_be_written)| Row {
        place,
        point: point.clone(),
        may_be_written,
    });
    let mut rows: Vec<Row> = there.collect();
    rows.extend(freeze(&map, &simulation).into_iter().map(|(place, point)| Row {
        place,
        point,
        may_be_written: false,
    }));
    rows.sort_by_key(|row| row.place);
    let mut out = Stdout::new();
    match format {
        Format::Text => {
            writeln!(out, "[serve.modbus.map]")?;
            for row in &rows {
                writeln!(out, "\"{}\" = \"{}\"", row.place, row.point.name)?;
            }
        }
        Format::Csv => csv(&rows, &mut out)?,
        Format::Json => {
            return Err(Failure::new(
                "--map modbus is written as text, which is TOML, or with --format csv",
            ));
        }
    }
    out.flush()?;
    Ok(Outcome::Fine)
}

/// Both ways of counting: screens differ, and a value that is off by one place is the commonest question.
fn csv(rows: &[Row], out: &mut Stdout) -> std::io::Result<()> {
    let mut table = csv::Writer::from_writer(out);
    table.write_record(["tag", "type", "table", "from 0", "from 1", "access"])?;
    for row in rows {
        table.write_record([
            row.point.name.clone(),
            row.point.ty.to_string(),
            row.place.table.name().to_owned(),
            row.place.number.to_string(),
            row.place.counted_from_one().to_string(),
            if row.may_be_written {
                "read and write"
            } else {
                "read"
            }
            .to_owned(),
        ])?;
    }
    table.flush()
}

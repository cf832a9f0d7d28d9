//! `ladder tags --map modbus`: where tags are on the wire, frozen so that an edit moves none; for `ladder.toml`, for people, and for
//! screens.

use super::{Format, fuxa, node_red};
use crate::commands::run::served;
use crate::findings::Source;
use crate::json::to_writer_pretty;
use crate::outcome::{Failure, Outcome};
use crate::run::{program, simulation};
use crate::terminal::{self, Stdout};
use clap::ValueEnum;
use ladder_analysis::cross_reference;
use ladder_devices::modbus::{ADDRESS, Map, Place, freeze};
use ladder_simulator::Point;
use ladder_workspace::{ServeModbus, Settings, shown};
use std::collections::HashMap;
use std::io::Write;
use std::net::{IpAddr, Ipv4Addr, SocketAddr};
use std::path::Path;

/// What serves tags.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum Protocol {
    /// Modbus TCP, as `[serve.modbus]` of ladder.toml has it
    Modbus,
}

/// What a screen is told of a program.
pub(super) struct Served {
    /// What the program is called.
    pub(super) name: String,
    pub(super) address: SocketAddr,
    pub(super) unit: u8,
    pub(super) map: Map,
    /// What the declarations say, by the names of the tags.
    comments: HashMap<String, String>,
}

impl Served {
    /// What the declaration of a tag says; nothing if it says nothing.
    pub(super) fn comment(&self, point: &Point) -> &str {
        let tag = point.name.split(['[', '.']).next().unwrap_or_default();
        self.comments.get(tag).map_or("", String::as_str)
    }
}

pub(super) fn write(file: &Path, source: &Source, format: Format) -> Result<Outcome, Failure> {
    if format == Format::Json {
        return Err(Failure::new(
            "--map modbus is written as text, which is TOML, or with --format csv, fuxa or node-red",
        ));
    }
    let settings = Settings::of(file)?;
    let Some(program) = program(source) else {
        return Ok(Outcome::Findings);
    };
    let options = settings.simulate.options(&program, file);
    let simulation = simulation(source, program, options)?;
    let asked = settings.modbus.unwrap_or_default();
    let mut map = served::map(&asked, file, &simulation)?;
    let frozen = freeze(&map, &simulation);
    let without = frozen.tags().count() - map.tags().count();
    if format == Format::Text {
        map = frozen;
    } else if without > 0 {
        terminal::warning(&format_args!(
            "inputs and outputs without a place, which are left out: {without}; `ladder tags {} --map modbus` writes the lines for ladder.toml",
            shown::path(file)
        ));
    }
    let served = Served {
        name: file
            .file_stem()
            .unwrap_or_default()
            .to_string_lossy()
            .into_owned(),
        address: reached_at(&asked),
        unit: asked
            .units
            .as_deref()
            .and_then(|units| units.first())
            .copied()
            .unwrap_or(1),
        map,
        comments: cross_reference(&source.analyze().context)
            .into_iter()
            .filter(|entry| entry.block.is_none())
            .map(|entry| (entry.name, entry.comment))
            .collect(),
    };
    let mut out = Stdout::new();
    match format {
        Format::Text => {
            writeln!(out, "[serve.modbus.map]")?;
            for (place, point, _) in served.map.tags() {
                writeln!(out, "\"{place}\" = \"{}\"", point.name)?;
            }
        }
        Format::Csv => csv(&served, &mut out)?,
        Format::Fuxa => to_writer_pretty(&mut out, &fuxa::devices(&served))?,
        Format::NodeRed => to_writer_pretty(&mut out, &node_red::flow(&served))?,
        Format::Json => {}
    }
    if matches!(format, Format::Fuxa | Format::NodeRed) {
        writeln!(out)?;
    }
    out.flush()?;
    Ok(Outcome::Fine)
}

/// Where a screen on this computer finds the server.
fn reached_at(asked: &ServeModbus) -> SocketAddr {
    let mut address = asked.listen.unwrap_or(ADDRESS);
    if address.ip().is_unspecified() {
        address.set_ip(IpAddr::V4(Ipv4Addr::LOCALHOST));
    }
    address
}

/// A place in both ways of counting: `holding 100 (40101)`. Screens differ, and a value that is off by one place is the commonest
/// question.
pub(super) fn both(place: Place) -> String {
    format!("{place} ({})", place.counted_from_one())
}

fn csv(served: &Served, out: &mut Stdout) -> std::io::Result<()> {
    let mut table = csv::Writer::from_writer(out);
    table.write_record(["tag", "type", "table", "from 0", "from 1", "access", "comment"])?;
    for (place, point, may_be_written) in served.map.tags() {
        table.write_record([
            point.name.clone(),
            point.ty.to_string(),
            place.table.name().to_owned(),
            place.number.to_string(),
            place.counted_from_one().to_string(),
            if may_be_written { "read and write" } else { "read" }.to_owned(),
            super::for_spreadsheet(served.comment(point)),
        ])?;
    }
    table.flush()
}

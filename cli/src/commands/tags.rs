//! `ladder tags`: the cross-reference of a program.

#[cfg(feature = "run")]
mod factory_io;
#[cfg(feature = "run")]
mod fuxa;
#[cfg(feature = "run")]
mod node_red;
#[cfg(feature = "run")]
mod places;

use crate::findings::Source;
use crate::form::Notation;
use crate::json::to_writer_pretty;
use crate::outcome::{Failure, Outcome};
use crate::terminal::Stdout;
use clap::{Args, ValueEnum};
use ladder_analysis::{AccessKind, TagEntry, cross_reference};
use ladder_workspace::shown;
use serde::Serialize;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

const EXAMPLES: &str = "\
Examples:
  ladder tags motor.clad                where each tag is read and written
  ladder tags motor.clad --format csv   the same for a spreadsheet
  ladder tags motor.clad --format json  and for other programs
  ladder tags motor.clad --map modbus   the places of its tags, for ladder.toml
  ladder tags motor.clad --map modbus --format csv
                                        the same for who sets up a screen
  ladder tags motor.clad --map modbus --format fuxa > motor.fuxa.json
                                        for FUXA: Connections, Import
  ladder tags --import tags.csv > scene.clad
                                        declarations for a scene of Factory I/O
  ladder tags --import tags.csv --map modbus > ladder.toml
                                        and the settings that connect it

Exit status: 0 fine, 2 the file cannot be read.";

/// List the tags of a program, and where each is read and written
///
/// Of each tag its type, whether it is an input or output, its address, the comment at its declaration, and the lines and
/// networks that read, write, set and reset it. A program with errors is listed as far as it can be understood.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// The program
    #[cfg_attr(feature = "run", arg(required_unless_present = "import"))]
    #[cfg_attr(not(feature = "run"), arg(required = true))]
    file: Option<PathBuf>,

    #[command(flatten)]
    from: Notation,

    /// How the list is written
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,

    /// The places of tags in `[serve.modbus]` of ladder.toml instead, with places for inputs and outputs that have none yet
    #[cfg(feature = "run")]
    #[arg(long, value_enum, value_name = "MAP")]
    map: Option<places::Protocol>,

    /// The tags that Factory I/O exports instead of a program's: its sensors and actuators as declarations, or with `--map` as settings
    #[cfg(feature = "run")]
    #[arg(long, value_name = "CSV", conflicts_with_all = ["file", "from", "format"])]
    import: Option<PathBuf>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Format {
    /// For people
    Text,
    /// A row for each tag; places as LINE:NETWORK
    Csv,
    /// An array of objects
    Json,
    /// With --map: a device of the screens of FUXA
    Fuxa,
    /// With --map: a flow of Node-RED for node-red-contrib-modbus
    NodeRed,
}

pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    #[cfg(feature = "run")]
    if let Some(table) = &arguments.import {
        return factory_io::write(table, arguments.map);
    }
    let file = arguments.file.as_deref().unwrap_or(Path::new(""));
    let source = Source::read(file, arguments.from.form())?;
    #[cfg(feature = "run")]
    if let Some(places::Protocol::Modbus) = arguments.map {
        return places::write(file, &source, arguments.format);
    }
    let entries = cross_reference(&source.analyze().context);
    let mut out = Stdout::new();
    match arguments.format {
        Format::Text => text(&entries, &mut out)?,
        Format::Csv => csv(&entries, &mut out)?,
        Format::Json => json(&entries, &mut out)?,
        Format::Fuxa | Format::NodeRed => {
            return Err(Failure::new("this format is for places: add --map modbus"));
        }
    }
    out.flush()?;
    Ok(Outcome::Fine)
}

const KINDS: [AccessKind; 5] = [
    AccessKind::Write,
    AccessKind::Set,
    AccessKind::Reset,
    AccessKind::ReadWrite,
    AccessKind::Read,
];

fn name_of(entry: &TagEntry) -> String {
    match &entry.block {
        Some(block) => format!("{block}.{}", entry.name),
        None => entry.name.clone(),
    }
}

fn text(entries: &[TagEntry], out: &mut Stdout) -> io::Result<()> {
    for entry in entries {
        let mut head = format!("{} : {}, {}", name_of(entry), entry.ty, entry.kind.word());
        if let Some(address) = entry.address.as_ref().filter(|address| **address != entry.name) {
            head.push_str(&format!(", at {address}"));
        }
        if let Some(line) = entry.declared {
            head.push_str(&format!(", declared in line {line}"));
        }
        if !entry.comment.is_empty() {
            head.push_str(&format!("  # {} #", entry.comment));
        }
        writeln!(out, "{}", shown::line(&head))?;
        for kind in KINDS {
            let places = entry.places.iter().filter(|place| place.access == kind);
            let places: Vec<String> = places
                .map(|place| format!("line {} (network {})", place.line, place.network))
                .collect();
            if !places.is_empty() {
                writeln!(out, "    {:<14}  {}", kind.words(), places.join(", "))?;
            }
        }
        if entry.places.is_empty() {
            writeln!(out, "    used nowhere")?;
        }
    }
    Ok(())
}

fn csv(entries: &[TagEntry], out: &mut Stdout) -> io::Result<()> {
    let mut table = csv::Writer::from_writer(out);
    table.write_record([
        "tag",
        "block",
        "type",
        "kind",
        "address",
        "declared",
        "write",
        "set",
        "reset",
        "read and write",
        "read",
        "comment",
    ])?;
    for entry in entries {
        let declared = entry.declared.map(|line| line.to_string());
        let mut cells = vec![
            entry.name.clone(),
            entry.block.clone().unwrap_or_default(),
            entry.ty.clone(),
            entry.kind.word().to_owned(),
            entry.address.clone().unwrap_or_default(),
            declared.unwrap_or_default(),
        ];
        cells.extend(KINDS.map(|kind| {
            let places = entry.places.iter().filter(|place| place.access == kind);
            let places: Vec<String> = places
                .map(|place| format!("{}:{}", place.line, place.network))
                .collect();
            places.join(" ")
        }));
        cells.push(entry.comment.clone());
        table.write_record(cells.iter().map(|cell| for_spreadsheet(cell)))?;
    }
    table.flush()
}

/// A cell that is shown as it is: a spreadsheet takes what begins like a formula for one, and runs it.
fn for_spreadsheet(cell: &str) -> String {
    let line = shown::line(cell);
    let is_formula = line.trim_start().starts_with(['=', '+', '-', '@']);
    if is_formula {
        format!("'{line}")
    } else {
        line.into_owned()
    }
}

#[derive(Serialize)]
struct Tag<'a> {
    #[serde(rename = "tag")]
    name: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    block: Option<&'a str>,
    #[serde(rename = "type")]
    ty: &'a str,
    kind: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    address: Option<&'a str>,
    /// The line of the declaration, from 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    declared: Option<usize>,
    comment: &'a str,
    places: Vec<Place>,
}

#[derive(Serialize)]
struct Place {
    /// `read`, `write`, `set`, `reset` or `read and write`.
    does: &'static str,
    line: usize,
    network: usize,
}

fn json(entries: &[TagEntry], out: &mut Stdout) -> io::Result<()> {
    let tags = entries.iter().map(|entry| Tag {
        name: &entry.name,
        block: entry.block.as_deref(),
        ty: &entry.ty,
        kind: entry.kind.word(),
        address: entry.address.as_deref(),
        declared: entry.declared,
        comment: &entry.comment,
        places: entry
            .places
            .iter()
            .map(|place| Place {
                does: place.access.words(),
                line: place.line,
                network: place.network,
            })
            .collect(),
    });
    to_writer_pretty(out, &tags.collect::<Vec<_>>())?;
    writeln!(out)
}

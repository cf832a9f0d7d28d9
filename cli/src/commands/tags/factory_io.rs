//! `ladder tags --import`: the tags of a scene of Factory I/O, from the table that it exports, as declarations and as settings.
//!
//! As a *client* Factory I/O writes its sensors into coils and holding registers, and reads its actuators from discrete inputs and
//! input registers: the program is the server. As a *server* it has the tables the other way round, and is a device of the program.

use super::places::Protocol;
use crate::outcome::{Failure, Outcome};
use crate::terminal::{self, Stdout};
use ladder_devices::modbus::{ADDRESS, Place, Table};
use ladder_format::names::Names;
use ladder_format::program::{Declaration, Item, ProgramSketch, Section, SectionKind};
use ladder_workspace::shown;
use std::collections::HashMap;
use std::io::Write;
use std::path::Path;

const HEADER: [&str; 4] = ["Name", "Type", "Data Type", "Address"];

/// A sensor or an actuator.
struct Tag {
    /// Its name in the program.
    name: String,
    /// As the scene calls it.
    original: String,
    is_sensor: bool,
    /// `Bool`, `Int` or `Real`.
    ty: String,
    place: Place,
}

/// What Factory I/O is on the wire.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Role {
    Client,
    Server,
}

pub(super) fn write(file: &Path, map: Option<Protocol>) -> Result<Outcome, Failure> {
    let text = ladder_workspace::read(file)?;
    let (tags, role) = read(&text)
        .map_err(|(line, message)| Failure::new(format!("{}:{line}: {message}", shown::path(file))))?;
    let mut out = Stdout::new();
    match map {
        None => out.write_all(declarations(&tags, file).as_bytes())?,
        Some(Protocol::Modbus) => out.write_all(settings(&tags, role).as_bytes())?,
    }
    out.flush()?;
    Ok(Outcome::Fine)
}

/// Reads the table. What is wrong has its line.
fn read(text: &str) -> Result<(Vec<Tag>, Role), (u64, String)> {
    let text = text.trim_start_matches('\u{feff}');
    let mut table = csv::ReaderBuilder::new()
        .trim(csv::Trim::All)
        .from_reader(text.as_bytes());
    let header = table.headers().map_err(|error| (1, error.to_string()))?;
    if !header.iter().eq(HEADER) {
        let message = format!(
            "an export of the tags of Factory I/O begins with {}",
            HEADER.join(",")
        );
        return Err((1, message));
    }
    let mut names = Names::default();
    let mut tags: Vec<Tag> = Vec::new();
    let mut role: Option<(Role, u64)> = None;
    let mut taken: HashMap<Place, u64> = HashMap::new();
    let mut without = 0_usize;
    for record in table.records() {
        let record = record.map_err(|error| {
            let line = error.position().map_or(1, csv::Position::line);
            (line, "this row has not the four cells of the header".to_owned())
        })?;
        let line = record.position().map_or(1, csv::Position::line);
        let cell = |nth: usize| record.get(nth).unwrap_or_default();
        let [original, kind, ty, address] = [0, 1, 2, 3].map(cell);
        if address.is_empty() {
            without += 1;
            continue;
        }
        let is_sensor = match kind {
            "Input" => true,
            "Output" => false,
            _ => {
                let message =
                    format!("`{kind}` is neither Input, which is a sensor, nor Output, an actuator");
                return Err((line, message));
            }
        };
        let place = place(address).map_err(|message| (line, message))?;
        let fits = match ty {
            "Bool" => place.table.is_of_bits(),
            "Int" | "Real" => !place.table.is_of_bits(),
            _ => return Err((line, format!("`{ty}` is not one of Bool, Int and Real"))),
        };
        if !fits {
            return Err((line, format!("{ty} cannot be at {address}")));
        }
        let own = if is_sensor == place.table.is_written() {
            Role::Client
        } else {
            Role::Server
        };
        let (first, since) = *role.get_or_insert((own, line));
        if own != first {
            let message = format!(
                "{kind} at {address} has Factory I/O as the {}, and line {since} as the {}",
                word(own),
                word(first)
            );
            return Err((line, message));
        }
        if let Some(other) = taken.insert(place, line) {
            return Err((line, format!("line {other} has {address} already")));
        }
        tags.push(Tag {
            name: names.fresh(&spelled(original)),
            original: original.to_owned(),
            is_sensor,
            ty: ty.to_owned(),
            place,
        });
    }
    let Some((role, _)) = role else {
        let message = "no tag has an address: choose a Modbus driver in Factory I/O and place the tags in it";
        return Err((1, message.to_owned()));
    };
    if without > 0 {
        terminal::note(&format_args!(
            "without an address in the driver, and left out: {without}"
        ));
    }
    Ok((tags, role))
}

fn word(role: Role) -> &'static str {
    match role {
        Role::Client => "client",
        Role::Server => "server",
    }
}

/// `Holding Reg 3`
fn place(address: &str) -> Result<Place, String> {
    let tables = [
        ("Coil ", Table::Coil),
        ("Input Reg ", Table::Input),
        ("Input ", Table::Discrete),
        ("Holding Reg ", Table::Holding),
    ];
    let found = tables.into_iter().find_map(|(name, table)| {
        let number = address.strip_prefix(name)?.trim().parse().ok()?;
        Some(Place { table, number })
    });
    found.ok_or_else(|| {
        format!(
            "`{address}` is not an address of a Modbus driver: Coil 0, Input 0, Holding Reg 0, Input Reg 0"
        )
    })
}

/// A name in small letters whose words are parted by `_`.
fn spelled(original: &str) -> String {
    let words = original.split(|letter: char| !letter.is_alphanumeric());
    let words = words.filter(|word| !word.is_empty());
    words.map(str::to_lowercase).collect::<Vec<_>>().join("_")
}

fn declarations(tags: &[Tag], file: &Path) -> String {
    let section = |kind, of_sensors| {
        let own = tags.iter().filter(|tag| tag.is_sensor == of_sensors);
        let declarations = own.map(|tag| {
            let (ty, scaled) = match tag.ty.as_str() {
                "Bool" => ("BOOL", ""),
                "Real" => ("INT", ", times the scale of the driver"),
                _ => ("INT", ""),
            };
            Declaration {
                comment: Some(format!("{}{scaled}", tag.original)),
                ..Declaration::new(&tag.name, ty)
            }
        });
        Item::Section(Section {
            declarations: declarations.collect(),
            ..Section::new(kind)
        })
    };
    let name = file.file_name().unwrap_or_default().to_string_lossy();
    let sketch = ProgramSketch {
        items: vec![
            Item::Comment(format!(
                "The sensors and actuators of a scene of Factory I/O, from {name}"
            )),
            Item::Blank,
            section(SectionKind::VarInput, true),
            section(SectionKind::VarOutput, false),
        ],
    };
    sketch.write(&ladder_format::Options::default()).text
}

fn settings(tags: &[Tag], role: Role) -> String {
    let lines = |of_sensors: Option<bool>| {
        let own = tags
            .iter()
            .filter(|tag| of_sensors.is_none_or(|own| own == tag.is_sensor));
        let lines: Vec<String> = own
            .map(|tag| format!("\"{}\" = \"{}\"\n", tag.place, tag.name))
            .collect();
        lines.concat()
    };
    match role {
        Role::Client => {
            let sensors = tags.iter().filter(|tag| tag.is_sensor);
            let sensors: Vec<String> = sensors.map(|tag| format!("    \"{}\",\n", tag.name)).collect();
            let port = ADDRESS.port();
            format!(
                "# Factory I/O is the Modbus TCP client: its driver connects to this computer, port {port}, unit 1.\n[serve.modbus]\nwrite = [\n{}]\n\n[serve.modbus.map]\n{}",
                sensors.concat(),
                lines(None)
            )
        }
        Role::Server => format!(
            "# Factory I/O is the Modbus TCP server: here is the address of its computer.\n[[device]]\nname = \"factory_io\"\nmodbus = \"127.0.0.1:502\"\npoll = \"20ms\"\n\n[device.read]\n{}\n[device.write]\n{}",
            lines(Some(true)),
            lines(Some(false))
        ),
    }
}

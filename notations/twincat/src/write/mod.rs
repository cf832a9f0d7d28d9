//! A program as files of TwinCAT: its unit, and next to it the units, types and globals that it uses.
//!
//! ```text
//! analysis --ladder-notation-plcopen--> Project --> declarations as texts
//!                                               --networks--> trees --archive--> XML
//! ```

mod archive;
mod networks;
mod tree;

use ladder_analysis::Analysis;
use ladder_notation::xml::{escape, section};
use ladder_notation::{Companion, LineColumn, Target, WriteError, Writing};
use ladder_notation_plcopen::declarations::text;
use ladder_notation_plcopen::model::{Body, Unit};
use ladder_notation_plcopen::{Compiler, project};

/// How often a program runs where its task says nothing else, in nanoseconds.
const CYCLE: i64 = 10_000_000;

/// Writes a program.
///
/// # Errors
///
/// If the program has errors, or needs files that are not there.
pub(super) fn write(analysis: &Analysis) -> Result<Writing, WriteError> {
    Target::BLOCKS_ALONE.write(analysis, |analysis, unwritable| {
        let (project, mut report) = project(analysis, unwritable, Compiler::TwinCat)?;
        if analysis.context.cycle.is_some_and(|cycle| cycle != CYCLE) {
            let why = "how often a program runs is set at its task there: set its cycle time";
            report.approximated(LineColumn::START, "time of a scan", why);
        }
        let mut refused = Vec::new();
        let mut units: Vec<Companion> = Vec::new();
        for unit in &project.units {
            units.push(file(
                &unit.name,
                "POU",
                &text::unit(unit),
                &body(unit, &mut refused),
            ));
        }
        for (place, why) in refused {
            report.refused(place, "network", why);
        }
        // The program is the last one.
        let bytes = units.pop().map(|file| file.bytes.to_vec()).unwrap_or_default();
        let program = project.units.last().map_or("", |unit| &unit.name);
        let types = project.types.iter();
        units.extend(types.map(|ty| file(&ty.name, "DUT", &text::data_type(ty), "")));
        if !project.globals.is_empty() {
            let name = free(format!("GVL_{program}"), &units);
            units.push(file(&name, "GVL", &text::globals(&project.globals), ""));
        }
        report.entries.sort_by_key(|entry| entry.place);
        Ok(Writing {
            bytes,
            report,
            companions: units,
        })
    })
}

/// A name like this one that no file has.
fn free(mut name: String, files: &[Companion]) -> String {
    let stem = |file: &Companion| file.name.split('.').next().unwrap_or_default().to_owned();
    while files.iter().any(|file| stem(file).eq_ignore_ascii_case(&name)) {
        name.push_str("_1");
    }
    name
}

/// What a unit does.
fn body(unit: &Unit, refused: &mut Vec<networks::Refused>) -> String {
    let inside = match &unit.body {
        Body::Graph(graph) => {
            let (networks, wire) = networks::networks(graph, refused);
            format!("      <NWL>\n{}      </NWL>\n", archive::body(&networks, wire))
        }
        Body::Text("ST", text, _) => {
            let mut held = String::new();
            section(&mut held, text);
            format!("      <ST>{held}</ST>\n")
        }
        _ => "      <ST><![CDATA[]]></ST>\n".to_owned(),
    };
    format!("    <Implementation>\n{inside}    </Implementation>\n")
}

/// The file of an object: `POU`, `DUT`, `GVL`.
fn file(name: &str, what: &str, declaration: &str, body: &str) -> Companion {
    let mut escaped = String::new();
    escape(&mut escaped, name);
    let mut held = String::new();
    section(&mut held, declaration);
    let special = if what == "POU" {
        " SpecialFunc=\"None\""
    } else {
        ""
    };
    let id = id(name, what);
    let text = format!(
        "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<TcPlcObject Version=\"1.1.0.1\" ProductVersion=\"3.1.4024.16\">\n  \
         <{what} Name=\"{escaped}\" Id=\"{{{id}}}\"{special}>\n    <Declaration>{held}</Declaration>\n{body}  </{what}>\n</TcPlcObject>\n"
    );
    Companion {
        name: format!("{name}.Tc{what}"),
        bytes: text.into(),
    }
}

/// The number of an object. It is the same whenever the object is written, so that a project that has it finds it again.
fn id(name: &str, what: &str) -> String {
    // FNV-1a, twice.
    let hash = |seed: u64| {
        let bytes = what.bytes().chain(name.to_ascii_lowercase().into_bytes());
        bytes.fold(seed, |hash, byte| {
            (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3)
        })
    };
    let (high, low) = (hash(0xcbf2_9ce4_8422_2325), hash(0x8422_2325_cbf2_9ce4));
    format!(
        "{:08x}-{:04x}-4{:03x}-{:04x}-{:012x}",
        high >> 32,
        (high >> 16) & 0xffff,
        high & 0xfff,
        0x8000 | ((low >> 48) & 0x3fff),
        low & 0xffff_ffff_ffff
    )
}

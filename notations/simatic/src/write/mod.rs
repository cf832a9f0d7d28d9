//! From a program to source documents: the program as a function block, and each block and structure that it uses.

mod declare;
mod element;
mod network;
mod operand;
mod power;
mod strands;
mod unit;
mod unread;

use declare::{TypeForm, Types};
use ladder_analysis::Analysis;
use ladder_analysis::program::{Network, Program};
use ladder_instructions::Profile;
use ladder_notation::{
    Companion, LineColumn, Lines, Report, Unwritable, WriteError, Writing, no_program, with_blocks_alone,
    with_calls_as_instructions, with_system_tags,
};
use ladder_syntax::{Name, TextSize};
use power::Power;
use std::collections::{HashMap, HashSet};
use std::path::Path;
use unit::Unit;

/// What writes.
struct Writer<'a> {
    analysis: &'a Analysis,
    program: &'a Program,
    text: String,
    lines: Lines,
    types: Types,
    report: Report,
    companions: Vec<Companion>,
    /// Of the block that is being written: what it needs besides.
    statics: Vec<(String, String)>,
    taken: HashSet<String>,
    /// Texts in languages, each with its id.
    texts: Vec<(String, String)>,
    /// The names of the parameters of each block, by its name in small letters.
    parameters: HashMap<String, Vec<String>>,
    /// The networks of the program by where they begin.
    networks: HashMap<TextSize, &'a Network>,
    /// How each block of the program comes by its power.
    powers: Vec<Power>,
    /// Unread parts by their names in small letters: the text of each in SCL, or why it is not written.
    unread: HashMap<String, Result<String, String>>,
}

/// Writes a program.
pub(super) fn write(analysis: &Analysis) -> Result<Writing, WriteError> {
    with_blocks_alone(analysis, |analysis, unwritable| {
        with_system_tags(
            analysis,
            |_, tag| crate::standard::has(tag),
            |analysis| with_calls_as_instructions(analysis, |analysis| documents(analysis, unwritable)),
        )
    })
}

fn documents(analysis: &Analysis, unwritable: &Unwritable) -> Result<Writing, WriteError> {
    let text = analysis.context.parse.to_string();
    let Some(program) = analysis.program() else {
        return Err(no_program(analysis, &text));
    };
    if analysis.context.profile != Profile::Iec {
        let message = "the program counts and times as another controller does (`# ladder: profile .. #`), and a SIMATIC block does not: take the profile out, and see whether it still does what it should";
        return Err(WriteError::new(message));
    }
    let lines = Lines::of(&text);
    let units = unit::units(&analysis.context.parse);
    let mut writer = Writer {
        analysis,
        program,
        text,
        lines,
        types: declare::missing(unwritable),
        report: Report::default(),
        companions: Vec::new(),
        statics: Vec::new(),
        taken: HashSet::new(),
        texts: Vec::new(),
        parameters: unit::parameters(&units),
        networks: HashMap::new(),
        powers: power::powers(program),
        unread: unread::parts(&units),
    };
    for network in &program.networks {
        writer.networks.insert(network.location.range.start(), network);
    }
    writer.types(&units);
    let names: HashSet<String> = units
        .iter()
        .skip(1)
        .map(|unit| unit.name.to_lowercase())
        .collect();
    let name = Path::new(&*analysis.context.name).file_stem().unwrap_or_default();
    let mut name = name.to_string_lossy().into_owned();
    while names.contains(&name.to_lowercase()) {
        name.push_str("_program");
    }
    for unit in units.iter().skip(1).filter(|unit| unit.unread.is_none()) {
        let used = program
            .blocks
            .iter()
            .position(|block| block.name[1..].eq_ignore_ascii_case(&unit.name));
        if let Some(used) = used
            && !unwritable.contains_key(&Name::new(&program.blocks[used].name))
        {
            let (document, resource) = writer.unit(&unit.name, unit, Some(writer.powers[used]));
            writer.companion(&unit.name, document, resource);
        }
    }
    let (bytes, resource) = writer.unit(&name, &units[0], None);
    if let Some(bytes) = resource {
        writer.companions.push(Companion {
            name: format!("{name}.s7res"),
            bytes,
        });
    }
    writer.report.entries.sort_by_key(|entry| entry.place);
    Ok(Writing {
        bytes,
        companions: writer.companions,
        report: writer.report,
    })
}

impl Writer<'_> {
    fn companion(&mut self, name: &str, document: Vec<u8>, resource: Option<Vec<u8>>) {
        let parts = [(Some(document), "s7dcl"), (resource, "s7res")];
        let files = parts.into_iter().filter_map(|(bytes, end)| {
            Some(Companion {
                name: format!("{name}.{end}"),
                bytes: bytes?,
            })
        });
        self.companions.extend(files);
    }

    /// The types of the program; a structure is a document of its own.
    fn types(&mut self, units: &[Unit]) {
        for section in units.iter().flat_map(|unit| &unit.sections) {
            if section.keyword != "TYPE" {
                continue;
            }
            for (name, members) in &section.structures {
                let form = TypeForm::Structure(members.clone());
                self.types.insert(name.to_lowercase(), (name.clone(), form));
            }
            for declared in &section.declared {
                for name in &declared.names {
                    let form = TypeForm::Alias(declared.clone());
                    self.types.insert(name.to_lowercase(), (name.clone(), form));
                }
            }
        }
        let constants = units.iter().flat_map(|unit| &unit.sections);
        let constants = constants.filter(|section| section.qualifier.as_deref() == Some("CONSTANT"));
        for declared in constants.flat_map(|section| &section.declared) {
            let Some(Ok(number)) = declared.initial.as_deref().map(str::parse) else {
                continue;
            };
            for name in &declared.names {
                let own = (name.clone(), TypeForm::Constant(number));
                self.types.entry(name.to_lowercase()).or_insert(own);
            }
        }
        let types = std::mem::take(&mut self.types);
        let mut all: Vec<&(String, TypeForm)> = types.values().collect();
        all.sort_by(|(one, _), (other, _)| one.cmp(other));
        for (name, form) in all {
            if let TypeForm::Structure(members) = form {
                let at = members.first().map_or(0, |member| member.at);
                let place = self.place(at);
                self.texts.clear();
                let document =
                    declare::structure(name, members, &types, &mut |declared| self.pragma(declared));
                match document {
                    Ok(document) => {
                        self.report.translated(place, format!("type {name}"));
                        self.companion(name, document.into_bytes(), self.resource());
                    }
                    Err(why) => self.report.refused(place, format!("type {name}"), why),
                }
            }
        }
        self.types = types;
    }

    fn place(&self, at: usize) -> LineColumn {
        self.lines.place(&self.text, at)
    }

    /// A tag that the program does not have.
    fn static_tag(&mut self, like: &str, ty: &str) -> String {
        let mut number = 1;
        let name = loop {
            let name = format!("{like}_{number}");
            if self.taken.insert(name.to_lowercase()) {
                break name;
            }
            number += 1;
        };
        self.statics.push((name.clone(), ty.to_owned()));
        format!("#\"{name}\"")
    }

    /// A bit that remembers an edge.
    fn memory(&mut self) -> String {
        self.static_tag("edge", "Bool")
    }
}

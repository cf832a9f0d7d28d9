//! From a program to source documents: the program as a function block, and each block and structure that it uses.

mod declare;
mod element;
mod network;
mod operand;
mod strands;
mod unit;

use declare::{TypeForm, Types};
use ladder_analysis::Analysis;
use ladder_analysis::program::{BlockKind, Network, Program};
use ladder_instructions::{Op, Profile};
use ladder_notation::{
    Companion, LineColumn, Lines, Report, Unwritable, WriteError, Writing, no_program, with_library,
};
use ladder_syntax::{Name, TextSize};
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
    /// The blocks that are not written.
    unwritable: &'a Unwritable,
    /// The blocks whose first network keeps them from running without power, as all do there; in small letters.
    guarded: HashSet<String>,
}

/// Writes a program.
pub(super) fn write(analysis: &Analysis) -> Result<Writing, WriteError> {
    with_library(analysis, documents)
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
        types: HashMap::new(),
        report: Report::default(),
        companions: Vec::new(),
        statics: Vec::new(),
        taken: HashSet::new(),
        texts: Vec::new(),
        parameters: unit::parameters(&units),
        networks: HashMap::new(),
        unwritable,
        guarded: HashSet::new(),
    };
    for network in &program.networks {
        writer.networks.insert(network.location.range.start(), network);
    }
    writer.types(&units);
    writer.guards();
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
    for unit in units.iter().skip(1) {
        let used = program
            .blocks
            .iter()
            .find(|block| block.name[1..].eq_ignore_ascii_case(&unit.name));
        if used.is_some_and(|block| !unwritable.contains_key(&Name::new(&block.name))) {
            let (document, resource) = writer.unit(&unit.name, unit);
            writer.companion(&unit.name, document, resource);
        }
    }
    let (bytes, resource) = writer.unit(&name, &units[0]);
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
        let types = std::mem::take(&mut self.types);
        let mut all: Vec<&(String, TypeForm)> = types.values().collect();
        all.sort_by(|(one, _), (other, _)| one.cmp(other));
        for (name, form) in all {
            if let TypeForm::Structure(members) = form {
                let at = members.first().map_or(0, |member| member.at);
                let place = self.place(at);
                match declare::structure(name, members, &types) {
                    Ok(document) => {
                        self.report.translated(place, format!("type {name}"));
                        self.companion(name, document.into_bytes(), None);
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

    /// Finds the blocks that begin with `+--[/]( EN )--<RET>--+`.
    fn guards(&mut self) {
        for block in &self.program.blocks {
            let Some(network) = self.program.networks.get(block.networks.start) else {
                continue;
            };
            let ops = network.blocks.iter().map(|block| match block.kind {
                BlockKind::Instruction(row) => Some(row.op),
                BlockKind::User(_) => None,
            });
            let is_guard = ops.eq([Some(Op::NegatedContact), Some(Op::Ret)]);
            let reads = network.blocks.first().and_then(|block| block.arguments.first());
            let reads = reads.map(|bound| self.text[bound.range].trim());
            if is_guard && reads.is_some_and(|tag| tag.eq_ignore_ascii_case("EN")) {
                self.guarded.insert(block.name.to_lowercase());
            }
        }
    }

    /// Whether a block does nothing without power.
    fn is_guarded(&self, user: usize) -> bool {
        self.guarded
            .contains(&self.program.blocks[user].name.to_lowercase())
    }
}

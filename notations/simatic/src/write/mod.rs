//! From a program to the model: the program as a function block, each block and structure that it uses, and what calls it.

mod caller;
mod declare;
pub(crate) mod document;
mod element;
mod network;
mod operand;
mod power;
pub(crate) mod simaticml;
mod strands;
mod tags;
mod units;
mod unread;

use crate::model::Unit;
use ladder_analysis::Analysis;
use ladder_analysis::program::{Bound, Network, Program};
use ladder_instructions::Profile;
use ladder_notation::{LineColumn, Lines, Report, Unwritable, WriteError, no_program};
use ladder_syntax::{Name, TextSize};
use power::Power;
use std::collections::HashMap;
use std::path::Path;
use units::Source;

/// What the units of a project share.
struct Project<'a> {
    analysis: &'a Analysis,
    program: &'a Program,
    /// The blocks that are not written, with why.
    unwritable: &'a Unwritable,
    text: String,
    lines: Lines,
    sources: Vec<Source>,
    /// The blocks that the program reaches, in its order.
    used: Vec<Used>,
    /// The networks of the program by where they begin.
    networks: HashMap<TextSize, &'a Network>,
}

/// A block that a program reaches.
struct Used {
    power: Power,
    /// What the text has of it.
    source: Option<usize>,
}

/// What a program becomes.
pub(crate) struct Made {
    pub(crate) program: Unit,
    /// The structures and blocks that it uses.
    pub(crate) others: Vec<Unit>,
    /// What calls it; nothing for a program without networks.
    pub(crate) callers: Vec<Unit>,
    pub(crate) report: Report,
}

/// The units of a program.
///
/// # Errors
///
/// If it has errors, or is in the profile of another controller.
pub(crate) fn made(analysis: &Analysis, unwritable: &Unwritable) -> Result<Made, WriteError> {
    let context = &analysis.context;
    let text = context.parse.to_string();
    let Some(program) = analysis.program() else {
        return Err(no_program(analysis, &text));
    };
    if context.profile != Profile::Iec {
        let message = "the program counts and times as another controller does (`# ladder: profile .. #`), and a SIMATIC block does not: take the profile out, and see whether it still does what it should";
        return Err(WriteError::new(message));
    }
    let sources = units::sources(context);
    let names = sources.iter().enumerate().skip(1);
    let names: HashMap<Name, usize> = names
        .map(|(number, source)| (Name::new(&source.name), number))
        .collect();
    let used = program.blocks.iter().map(|block| Used {
        power: power::power(program, block),
        source: names.get(&Name::new(&block.name[1..])).copied(),
    });
    let networks = program.networks.iter();
    let project = Project {
        analysis,
        program,
        unwritable,
        lines: Lines::of(&text),
        text,
        used: used.collect(),
        sources,
        networks: networks
            .map(|network| (network.location.range.start(), network))
            .collect(),
    };
    let mut report = Report::default();
    let mut others = declare::structures(&project, &mut report);
    for (number, source) in project.sources.iter().enumerate().skip(1) {
        let used = project.used.iter().position(|used| used.source == Some(number));
        if let Some(user) = used.filter(|user| project.why_unwritable(*user).is_none())
            && source.unread.is_none()
        {
            let power = Some(project.used[user].power);
            others.push(units::unit(&project, source, &source.name, power, &mut report));
        }
    }
    let name = Path::new(&*context.name).file_stem().unwrap_or_default();
    let mut name = name.to_string_lossy().into_owned();
    while names.contains_key(&Name::new(&name)) {
        name.push_str("_program");
    }
    let own = units::unit(&project, &project.sources[0], &name, None, &mut report);
    let callers = if own.networks.is_empty() {
        Vec::new()
    } else {
        caller::caller(&project, &own).into()
    };
    report.entries.sort_by_key(|entry| entry.place);
    Ok(Made {
        program: own,
        others,
        callers,
        report,
    })
}

impl Project<'_> {
    /// What the text has of a block of the program.
    fn source(&self, user: usize) -> Option<&Source> {
        self.used[user].source.map(|number| &self.sources[number])
    }

    /// Why a block of the program is not written.
    fn why_unwritable(&self, user: usize) -> Option<&String> {
        self.unwritable.get(&Name::new(&self.program.blocks[user].name))
    }

    fn place(&self, at: TextSize) -> LineColumn {
        self.lines.place(&self.text, at.into())
    }

    /// Where the line of a declaration begins.
    fn line(&self, at: TextSize) -> LineColumn {
        let parse = &self.analysis.context.parse;
        self.place(parse.line_at(at).map_or(at, |line| parse.line_start(line)))
    }

    /// Where a network of the text begins.
    fn start(&self, number: usize) -> TextSize {
        let parse = &self.analysis.context.parse;
        parse.line_start(parse.structure().networks[number].lines.start)
    }

    /// The name that an operand is given by, and its value, as they are written.
    fn parts_of(&self, bound: &Bound) -> (&str, &str) {
        let text = self.text[bound.range].trim();
        match text.split_once(":=").or_else(|| text.split_once("=>")) {
            Some((name, value)) if !text.starts_with('\'') => (name.trim(), value.trim()),
            _ => ("", text),
        }
    }

    fn name_of(&self, bound: &Bound) -> &str {
        self.parts_of(bound).0
    }

    fn source_of(&self, bound: &Bound) -> &str {
        self.parts_of(bound).1
    }
}

//! From a program to an export of a controller.
//!
//! ```text
//! program --network, block, state, native--> rungs --.
//! declarations --data--> types, tags ----------------'--> Project --xml--> L5X
//! ```
//!
//! What a program of the profile `logix` says is written as it is. In other programs timers, counters and edges do
//! what they do here: where Logix does otherwise more than one instruction is written, or the report says so.

mod block;
mod body;
mod compute;
mod data;
mod layout;
mod loops;
mod names;
mod native;
mod network;
mod operand;
mod pattern;
mod routines;
mod rung;
mod state;
mod unread;
mod words;
mod xml;

use crate::model::{Raw, Tag};
use crate::names::Originals;
use crate::types::Elem;
use ladder_analysis::Analysis;
use ladder_analysis::context::Context;
use ladder_analysis::names::scope::TagFacts;
use ladder_analysis::networks::NetworkAt;
use ladder_analysis::program::{Program, TagId};
use ladder_instructions::{Op, Profile};
use ladder_notation::{
    LineColumn, Lines, Project, Report, Stays, Target, Unwritable, WriteError, Writing, stand_in,
};
use ladder_syntax::{Name, TextSize};
use layout::Layout;
use names::{Kind, Names};
use native::Known;
use rung::Series;
use std::collections::{HashMap, HashSet};

type Result<T> = std::result::Result<T, String>;

/// What a block becomes.
struct Lowered {
    /// What follows on the rung.
    pieces: Series,
    /// The rung ends, and goes on with this from the rail.
    cut: Option<Series>,
}

impl Lowered {
    /// Power goes on after it.
    fn passing(pieces: Series) -> Lowered {
        Lowered { pieces, cut: None }
    }
}

/// What is written.
struct Input<'a> {
    analysis: &'a Analysis,
    program: &'a Program,
    text: &'a str,
    lines: Lines,
    /// The program has the arithmetic and timing of Logix.
    is_own: bool,
    layout: &'a Layout,
}

/// What is known of the program before its first rung is written.
#[derive(Default)]
struct Facts {
    /// Tags that the reader declared for one instruction, and that nothing else uses.
    helpers: HashSet<TagId>,
    /// Those that are not needed, and what is in the place of them.
    absorbed: HashMap<TagId, Option<String>>,
    absorbed_names: HashSet<Name>,
    /// The constants whose parts are all 0.
    cleared: HashSet<Name>,
    /// The bits with which routines end the loop that calls them.
    leaves: HashSet<TagId>,
    loops: Loops,
    known: HashMap<usize, Known>,
    /// For each user-defined block its definition in the text.
    body_of: HashMap<usize, usize>,
}

/// The loops that are written as one instruction.
#[derive(Default)]
struct Loops {
    /// For each instruction with a loop the first network of that, by where it is.
    begins: HashMap<TextSize, usize>,
    /// All their networks.
    networks: HashSet<usize>,
}

/// The program, or the definition that is being written.
#[derive(Default)]
struct Scope {
    /// The definition.
    body: Option<usize>,
    in_function: bool,
    /// The program that its routine belongs to, if there are several.
    program: Option<usize>,
    /// Tags that its rungs need besides the program's.
    made: Vec<Tag>,
    /// Bits that are off when the first scan begins.
    first_scan: Vec<String>,
}

/// The network that is being written.
#[derive(Default)]
struct Sheet {
    rungs: Vec<Series>,
    before: Vec<Series>,
    labels: Vec<String>,
    note: Option<String>,
}

/// What the rungs need besides tags of their own.
#[derive(Default)]
struct Data {
    types: Vec<crate::model::DataType>,
    /// Where each type is declared, by its line.
    type_order: HashMap<String, usize>,
    /// What is written above each definition.
    body_comments: HashMap<usize, String>,
    /// The parameters that a call has a value for.
    given: HashSet<(usize, usize)>,
    /// The presets of timers and counters, by the block and the path.
    presets: HashMap<(String, Name), String>,
    /// The bits of pulses.
    pulses: HashMap<String, String>,
}

/// What writes a program.
struct Writer<'a> {
    input: Input<'a>,
    facts: Facts,
    scope: Scope,
    sheet: Sheet,
    data: Data,
    names: Names,
    report: Report,
}

/// What the controllers have.
const TARGET: Target = Target {
    lacks_on_arrays: Some(&[Op::Unpack]),
    has_functions: true,
    has_system_tag: |_| false,
    has_calls_in_formulas: false,
    has_bridges: false,
    // Blocks and loops that were read from there are instructions again.
    stays: |context| Stays {
        blocks: native::natives(context),
        turns: turns_of_instructions(context),
    },
    ..Target::BLOCKS_ALONE
};

/// Writes a program.
pub(crate) fn write(analysis: &Analysis) -> std::result::Result<Writing, WriteError> {
    laid_out(analysis, &Layout::default())
}

/// Writes the files of a folder.
pub(crate) fn write_project(project: &Project) -> std::result::Result<Writing, WriteError> {
    laid_out(&project.analysis, &Layout::of_files(project))
}

/// Writes the files of a folder with the names of the file that they come from.
pub(crate) fn write_again(
    project: &Project,
    originals: &Originals,
    before: &Project,
) -> std::result::Result<Writing, WriteError> {
    laid_out(
        &project.analysis,
        &Layout::of_original(project, originals, before),
    )
}

fn laid_out(analysis: &Analysis, layout: &Layout) -> std::result::Result<Writing, WriteError> {
    let target = match analysis.context.profile {
        Profile::Logix => Target {
            lacks_on_arrays: None,
            ..TARGET
        },
        _ => TARGET,
    };
    target.write(analysis, |analysis, unwritable| {
        file(analysis, unwritable, layout)
    })
}

/// The tags with the numbers of turns of `FAL`, `FSC` and `FOR`.
fn turns_of_instructions(context: &Context) -> HashSet<Name> {
    if context.profile != Profile::Logix {
        return HashSet::new();
    }
    let blocks = context.networks.iter().flat_map(NetworkAt::blocks);
    let instructions =
        blocks.filter(|block| matches!(block.head_text().as_str(), "[$FAL]" | "[$FSC]" | "[$FOR]"));
    let turns = instructions.filter_map(|block| {
        let last = block.facts.operands.last()?;
        Some(Name::new(
            &context.parse.text_in(block.absolute(last.value.range)),
        ))
    });
    turns.collect()
}

fn file(
    analysis: &Analysis,
    unwritable: &Unwritable,
    layout: &Layout,
) -> std::result::Result<Writing, WriteError> {
    let text = analysis.context.parse.to_string();
    let whole = stand_in::analysis(analysis, &text, is_nothing)?;
    let Some(program) = whole.program() else {
        return Err(WriteError::new("the program has errors"));
    };
    let mut writer = Writer {
        input: Input {
            analysis: &whole,
            program,
            text: &text,
            lines: Lines::of(&text),
            is_own: analysis.context.profile == Profile::Logix,
            layout,
        },
        facts: Facts::default(),
        scope: Scope::default(),
        sheet: Sheet::default(),
        data: Data::default(),
        names: Names::default(),
        report: Report::default(),
    };
    if !matches!(analysis.context.profile, Profile::Logix | Profile::Iec) {
        let why = "arithmetic, timers and counters are those of Logix there, not of the profile of this file";
        writer.report.approximated(LineColumn::START, "program", why);
    }
    writer.know_originals();
    for (task, why) in &layout.runs.told {
        let task = format!("task {task}");
        writer.report.approximated(LineColumn::START, task, why.as_str());
    }
    let project = writer.project(unwritable);
    let mut report = writer.report;
    for (name, spelled) in &writer.names.changed {
        let why = format!("its name is {spelled} there");
        report.approximated(LineColumn::START, name, why);
    }
    report.entries.sort_by_key(|entry| entry.place);
    Ok(Writing {
        bytes: xml::file(&project).into_bytes(),
        report,
        ..Writing::default()
    })
}

/// The comment that stands for an instruction without effect.
fn is_nothing(comment: &str) -> bool {
    comment.starts_with('#') && ladder_notation::comments::inside(comment).trim() == "NOP"
}

impl Writer<'_> {
    /// What was called otherwise in the file that the program comes from is called so again.
    fn know_originals(&mut self) {
        let layout = self.input.layout;
        for (name, routine) in layout.routines() {
            self.names.stands_for(Kind::Routine, name.as_str(), routine);
        }
        let Some(originals) = &layout.originals else {
            return;
        };
        for (name, original) in &originals.types {
            self.names.stands_for(Kind::Type, name.as_str(), original);
        }
        // What is new has none of these names.
        let mut taken: Vec<&String> = originals.tags.values().map(|(_, original)| original).collect();
        taken.sort_unstable();
        for original in taken {
            self.names.fresh(Kind::Tag, original);
        }
    }

    /// A tag or a parameter in the body that is written.
    fn root(&mut self, name: &str) -> String {
        let layout = self.input.layout;
        if let Some(body) = self.scope.body {
            let block = &self.input.analysis.context.user_blocks[body].key;
            let locals = layout.originals.as_ref().map(|originals| &originals.locals);
            let original = locals.and_then(|locals| locals.get(&(block.clone(), Name::new(name))));
            return match original {
                Some(original) => original.clone(),
                None => self.names.spell(Kind::Tag, name),
            };
        }
        let Some(at) = layout.tag(name) else {
            return self.names.spell(Kind::Tag, name);
        };
        let spelled = if at.is_original {
            at.name.clone()
        } else {
            self.names.spell(Kind::Tag, &at.name)
        };
        match at.program {
            Some(program) if self.scope.program.is_some_and(|own| own != program) => {
                format!("\\{}.{spelled}", layout.programs[program].name)
            }
            _ => spelled,
        }
    }

    /// A member of a structure, or a parameter of an instance.
    fn member_name(&mut self, name: &str) -> String {
        let originals = self.input.layout.originals.as_ref();
        match originals.and_then(|originals| originals.members.get(&Name::new(name))) {
            Some(original) => original.clone(),
            None => self.names.spell(Kind::Tag, name),
        }
    }

    fn at(&self, offset: usize) -> LineColumn {
        self.input.lines.place(self.input.text, offset)
    }

    fn place_of(&self, tag: &TagFacts) -> LineColumn {
        self.at(self.input.analysis.context.place_of(tag).start().into())
    }

    /// Notes why a network is not quite the same.
    fn note(&mut self, why: &str) {
        self.sheet.note.get_or_insert_with(|| why.to_owned());
    }

    /// A tag that the rungs need.
    fn made(&mut self, like: &str, ty: &str, what: &str) -> String {
        let name = self.names.fresh(Kind::Tag, like);
        self.scope.made.push(Tag {
            name: name.clone(),
            ty: ty.to_owned(),
            value: Elem::named(ty).map(|_| Raw::Scalar(ty.to_owned(), "0".to_owned())),
            comment: Some(what.to_owned()),
            ..Tag::default()
        });
        name
    }

    /// The bit in which an instruction remembers its rung. `risen`: what is high in the first scan has risen.
    fn storage(&mut self, like: &str, risen: bool) -> String {
        let name = self.made(like, "BOOL", "the memory of an edge");
        if risen {
            self.scope.first_scan.push(name.clone());
        }
        name
    }
}

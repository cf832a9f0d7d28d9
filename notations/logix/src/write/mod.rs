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
use crate::types::Elem;
use ladder_analysis::Analysis;
use ladder_analysis::context::{Body, Context};
use ladder_analysis::names::scope::TagFacts;
use ladder_analysis::networks::NetworkAt;
use ladder_analysis::program::{Program, TagId};
use ladder_instructions::Profile;
use ladder_notation::{
    LineColumn, Lines, Report, Unwritable, WriteError, Writing, stand_in, with_arrays_as_elements,
    with_calls_as_instructions, with_loops_as_jumps, with_other_files, with_system_tags,
};
use ladder_syntax::{Name, TextSize};
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

/// What writes a program.
struct Writer<'a> {
    analysis: &'a Analysis,
    program: &'a Program,
    text: &'a str,
    lines: Lines,
    /// The program has the arithmetic and timing of Logix.
    is_own: bool,
    names: Names,
    report: Report,
    types: Vec<crate::model::DataType>,
    /// Where each type is declared, by its line.
    type_order: HashMap<String, usize>,
    /// Tags that the reader declared for one instruction, and that nothing else uses.
    helpers: HashSet<TagId>,
    /// Those that are not needed, and what stands for them.
    absorbed: HashMap<TagId, Option<String>>,
    absorbed_names: HashSet<Name>,
    /// The bits with which routines end the loop that calls them.
    leaves: HashSet<TagId>,
    /// For each instruction with a loop the first network of that, by where it is.
    loops: HashMap<TextSize, usize>,
    /// The networks of loops.
    skipped: HashSet<usize>,
    known: HashMap<usize, Known>,
    /// For each user-defined block its definition in the text.
    body_of: HashMap<usize, usize>,
    /// What is said above each definition.
    body_comments: HashMap<usize, String>,
    /// The parameters that a call has a value for.
    given: HashSet<(usize, usize)>,
    /// The definition that is being written.
    body: Option<usize>,
    in_function: bool,
    /// Tags that the rungs of this scope need besides the program's.
    made: Vec<Tag>,
    /// Bits of this scope that are off when the first scan begins.
    first_scan: Vec<String>,
    /// The bits of pulses.
    pulses: HashMap<String, String>,
    /// The presets of timers and counters, by the block and the path.
    presets: HashMap<(String, Name), String>,
    rungs: Vec<Series>,
    before: Vec<Series>,
    label: Option<String>,
    note: Option<String>,
}

/// Writes a program.
pub(crate) fn write(analysis: &Analysis) -> std::result::Result<Writing, WriteError> {
    with_other_files(analysis, |analysis, unwritable| {
        // Blocks that were read from there are instructions again.
        let natives = native::natives(&analysis.context);
        let is_native = |body: Body| matches!(body, Body::Block(block) if natives.contains(&block));
        with_system_tags(
            analysis,
            |body, _| is_native(body),
            |analysis| by_own_means(analysis, &is_native, unwritable),
        )
    })
}

/// Writes a program with nothing that only ladder text has, but in the bodies of blocks that are instructions there.
fn by_own_means(
    analysis: &Analysis,
    is_native: &dyn Fn(Body) -> bool,
    unwritable: &Unwritable,
) -> std::result::Result<Writing, WriteError> {
    let plain =
        |analysis: &Analysis| with_calls_as_instructions(analysis, |analysis| file(analysis, unwritable));
    if analysis.context.profile != Profile::Logix {
        return with_arrays_as_elements(analysis, &["[UNPACK]"], |analysis| {
            with_loops_as_jumps(analysis, |_, _| true, plain)
        });
    }
    // Loops that were read from there are in an instruction again.
    let turns = turns_of_instructions(&analysis.context);
    let are_jumps = |body: Body, count: &str| !is_native(body) && !turns.contains(&Name::new(count.trim()));
    with_loops_as_jumps(analysis, are_jumps, plain)
}

/// The tags with the numbers of turns of `FAL`, `FSC` and `FOR`.
fn turns_of_instructions(context: &Context) -> HashSet<Name> {
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

fn file(analysis: &Analysis, unwritable: &Unwritable) -> std::result::Result<Writing, WriteError> {
    let text = analysis.context.parse.to_string();
    let whole = stand_in::analysis(analysis, &text, is_nothing)?;
    let Some(program) = whole.program() else {
        return Err(WriteError::new("the program has errors"));
    };
    let mut writer = Writer {
        analysis: &whole,
        program,
        text: &text,
        lines: Lines::of(&text),
        is_own: analysis.context.profile == Profile::Logix,
        names: Names::default(),
        report: Report::default(),
        types: Vec::new(),
        type_order: HashMap::new(),
        helpers: HashSet::new(),
        absorbed: HashMap::new(),
        absorbed_names: HashSet::new(),
        leaves: HashSet::new(),
        loops: HashMap::new(),
        skipped: HashSet::new(),
        known: HashMap::new(),
        body_of: HashMap::new(),
        body_comments: HashMap::new(),
        given: HashSet::new(),
        body: None,
        in_function: false,
        made: Vec::new(),
        first_scan: Vec::new(),
        pulses: HashMap::new(),
        presets: HashMap::new(),
        rungs: Vec::new(),
        before: Vec::new(),
        label: None,
        note: None,
    };
    if !matches!(analysis.context.profile, Profile::Logix | Profile::Iec) {
        let why = "arithmetic, timers and counters are those of Logix there, not of the profile of this file";
        writer.report.approximated(LineColumn::START, "program", why);
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
    fn at(&self, offset: usize) -> LineColumn {
        self.lines.place(self.text, offset)
    }

    fn place_of(&self, tag: &TagFacts) -> LineColumn {
        self.at(self.analysis.context.place_of(tag).start().into())
    }

    /// Notes why a network is not quite the same.
    fn note(&mut self, why: &str) {
        self.note.get_or_insert_with(|| why.to_owned());
    }

    /// A tag that the rungs need.
    fn made(&mut self, like: &str, ty: &str, what: &str) -> String {
        let name = self.names.fresh(Kind::Tag, like);
        self.made.push(Tag {
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
            self.first_scan.push(name.clone());
        }
        name
    }
}

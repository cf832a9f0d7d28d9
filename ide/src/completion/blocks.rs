//! Blocks by the brackets that are written, or on a bare wire: mnemonics and user-defined blocks with their operands
//! as tab stops.

use super::item::{Completion, CompletionKind, Snippet, Topic};
use super::likeness::{Likeness, likeness};
use super::proposals::Proposals;
use crate::typing::{Head, Operand, Typing};
use crate::wanted::Called;
use ladder_analysis::library;
use ladder_analysis::written::user_block::UserBlockFacts;
use ladder_instructions::{
    Accepts, Group, Instruction, Op, Presence, Profile, Purpose, Shape, TABLE, purpose,
};
use rustc_hash::FxHashSet;
use std::ops::Range;

/// In a block's first part.
pub(super) fn in_head(typing: &Typing<'_>, head: &Head, out: &mut Proposals<'_>) {
    let user_only = typing.text[typing.word.clone()].starts_with('$');
    if !user_only {
        for row in TABLE
            .iter()
            .filter(|row| row.shape == head.shape && is_offered(row, typing.context.profile))
        {
            propose_row(typing, row, Around::Head(head), out);
        }
    }
    each_user_block(typing, |block, file| {
        if block.shape == head.shape {
            propose_user(typing, block, file, Around::Head(head), out);
        }
    });
}

/// On a rung outside of blocks: each block with its brackets.
pub(super) fn on_wire(typing: &Typing<'_>, out: &mut Proposals<'_>) {
    for row in TABLE.iter().filter(|row| is_offered(row, typing.context.profile)) {
        propose_row(typing, row, Around::Wire, out);
    }
    each_user_block(typing, |block, file| {
        propose_user(typing, block, file, Around::Wire, out);
    });
}

/// What is there already of the block that is written.
#[derive(Clone, Copy)]
enum Around<'h> {
    Wire,
    Head(&'h Head),
}

/// Whether the profile has it.
fn is_offered(row: &Instruction, profile: Profile) -> bool {
    row.profiles.contain(profile)
}

/// Each block that can be used here, with the file that defines it if that is another one.
fn each_user_block(typing: &Typing<'_>, mut give: impl FnMut(&UserBlockFacts, Option<&str>)) {
    let context = typing.context;
    // A block is not in its own body.
    let own_body = typing.scope.checked_sub(1);
    let mut seen = FxHashSet::default();
    for (index, block) in context.user_blocks.iter().enumerate() {
        if Some(index) != own_body && block.name.len() > 1 && seen.insert(block.key.clone()) {
            give(block, block.file().map(|file| &**file));
        }
    }
    if let Some(own) = own_body.and_then(|own| context.user_blocks.get(own)) {
        seen.insert(own.key.clone());
    }
    for (file, block) in context.others.all_blocks() {
        if seen.insert(block.facts.key.clone()) {
            give(&block.facts, Some(&file.file));
        }
    }
}

fn propose_row(typing: &Typing<'_>, row: &'static Instruction, around: Around<'_>, out: &mut Proposals<'_>) {
    let name = if row.mnemonic == " " { "" } else { row.mnemonic };
    let filter = match (name, around) {
        ("", Around::Wire) => row.title,
        _ => name,
    };
    // Another spelling leads to the one that is written, and so does a word that says what it is for.
    let prefix = typing.prefix();
    let begins = |spelling: &str| {
        !prefix.is_empty()
            && likeness(spelling, prefix).is_some_and(|likeness| likeness <= Likeness::Beginning)
    };
    let (filter, fit, is_meant) = if begins(filter) {
        (filter, 0, false)
    } else if let Some(spelling) = row.spellings().find(|spelling| begins(spelling)) {
        (spelling, 1, false)
    } else {
        match purpose(row, prefix) {
            Some(Purpose::Title) => (row.title, 1, true),
            Some(Purpose::Sentence) => (row.title, 2, true),
            None => (filter, 0, false),
        }
    };
    let (range, text) = written(
        typing,
        row.shape,
        name,
        operands_of(row).as_deref(),
        acts(row),
        around,
    );
    let item = Completion {
        label: row.block(),
        detail: row.title.to_owned(),
        kind: CompletionKind::Instruction,
        range: typing.absolute(range),
        filter: filter.to_owned(),
        text,
        topic: Topic::Instruction(row.op, typing.context.profile),
    };
    if is_meant {
        out.add_like(Likeness::Word, (fit, rank(row)), item);
    } else {
        out.add_at((fit, rank(row)), item);
    }
}

fn propose_user(
    typing: &Typing<'_>,
    block: &UserBlockFacts,
    file: Option<&str>,
    around: Around<'_>,
    out: &mut Proposals<'_>,
) {
    let operands = operands_of_user(block);
    let (range, text) = written(typing, block.shape, &block.name, Some(&operands), false, around);
    let (open, close) = block.shape.brackets();
    let of_library = file.and_then(library::source);
    // A program's own blocks are meant more often than instructions, those of the library less often.
    let fit = if of_library.is_some() { 3 } else { 0 };
    out.add_at(
        (fit, 0),
        Completion {
            label: format!("{open}{}{close}", block.name),
            detail: match (file, of_library) {
                (_, Some(source)) => source.summary().replace('`', ""),
                (Some(file), None) => format!("User-defined block in {file}"),
                (None, None) => "User-defined block".to_owned(),
            },
            kind: CompletionKind::UserBlock,
            range: typing.absolute(range),
            filter: block.name.clone(),
            text,
            topic: Topic::UserBlock(block.name.clone()),
        },
    );
}

/// What is used more comes first.
fn rank(row: &Instruction) -> u8 {
    match (row.group, row.op) {
        (Group::Condition, Op::Eq | Op::Ne | Op::Gt | Op::Ge | Op::Lt | Op::Le) => 4,
        (Group::Condition, _) => 0,
        (Group::Coil, _) => 1,
        (Group::State, Op::Ton | Op::Tof | Op::Tp | Op::Rto | Op::Rtof) => 2,
        (Group::State, Op::Ctu | Op::Ctd | Op::Ctud | Op::Ctc) => 3,
        (Group::Data, Op::Mov) => 5,
        _ => 6,
    }
}

/// Whether nothing is drawn after such a block but the rail: coils, and what leaves the network.
fn acts(row: &Instruction) -> bool {
    row.shape == Shape::Coil || matches!(row.op, Op::Jmp | Op::Call | Op::Ret | Op::End)
}

/// The required operands, as they are until the user writes others. None: the block has no list.
pub(crate) fn operands_of(row: &Instruction) -> Option<Vec<String>> {
    if row.required() == 0
        && !row
            .operands
            .iter()
            .any(|o| matches!(o.presence, Presence::Repeated { .. }))
    {
        return None;
    }
    let places =
        (0..row.required()).filter_map(|index| row.positional(index).map(|operand| (index, operand)));
    Some(
        places
            .map(|(_, operand)| stand_in(operand.name, operand.accepts))
            .collect(),
    )
}

/// What is in an operand's place until the user writes something else.
fn stand_in(name: &str, accepts: Accepts) -> String {
    match accepts {
        Accepts::Duration | Accepts::Time => "T#1s".to_owned(),
        Accepts::Count => "10".to_owned(),
        Accepts::SearchOperator => "EQ".to_owned(),
        Accepts::Range => format!("{name}[1..8]"),
        Accepts::RangeOrValue if name == "y" || name == "a" => name.to_owned(),
        Accepts::Expression => "a + b".to_owned(),
        _ => name
            .chars()
            .filter(|c| c.is_alphanumeric() || *c == '_')
            .collect(),
    }
}

/// The operands of a user-defined block up to the last that must be given.
pub(crate) fn operands_of_user(block: &UserBlockFacts) -> Vec<String> {
    let given = block
        .parameters
        .iter()
        .rposition(|p| !p.has_default)
        .map_or(0, |last| last + 1);
    block.parameters[..given].iter().map(|p| p.name.clone()).collect()
}

/// What is replaced, and by what.
fn written(
    typing: &Typing<'_>,
    shape: Shape,
    name: &str,
    operands: Option<&[String]>,
    acts: bool,
    around: Around<'_>,
) -> (Range<usize>, Snippet) {
    let (open, close) = shape.brackets();
    let word = typing.word.clone();
    let inside = if name.is_empty() { " " } else { name };
    let head = match around {
        Around::Wire => {
            let wire = if wants_wire_before(typing) { "--" } else { "" };
            let text = Snippet::default().text(&format!("{wire}{open}{inside}{close}"));
            return with_list(typing, word.clone(), word.end, text, operands, acts, shape);
        }
        Around::Head(head) => head,
    };
    // From its opening bracket on, so that an editor that shows the label in its place shows the block as it will be.
    let text = Snippet::default().text(&format!("{open}{inside}{close}"));
    match (head.closed, head.has_list) {
        (Some(end), true) => (head.open..end, text),
        (Some(end), false) => with_list(typing, head.open..end, end, text, operands, acts, shape),
        (None, true) => (head.open..word.end, text),
        (None, false) => with_list(typing, head.open..word.end, word.end, text, operands, acts, shape),
    }
}

fn with_list(
    typing: &Typing<'_>,
    range: Range<usize>,
    end: usize,
    mut text: Snippet,
    operands: Option<&[String]>,
    acts: bool,
    shape: Shape,
) -> (Range<usize>, Snippet) {
    if let Some(operands) = operands {
        text = text.append(list(operands));
    }
    let wire = wire_after(typing, end, acts || shape == Shape::Coil);
    // A block without a list takes the parenthesis after it for its own: a wire keeps them apart.
    text = text.text(wire);
    if text.has_stops() || !wire.is_empty() {
        text = text.end();
    }
    (range, text)
}

fn list(operands: &[String]) -> Snippet {
    let mut text = Snippet::default().text("(");
    for (index, operand) in operands.iter().enumerate() {
        text = text.text(if index == 0 { " " } else { ", " }).stop(operand);
    }
    text.text(" )")
}

/// Whether a block that is written here touches something that is not a wire.
fn wants_wire_before(typing: &Typing<'_>) -> bool {
    let before = &typing.text[typing.physical_line().start..typing.word.start];
    before.ends_with(['+', '\\', '/', ']', ')', '>'])
}

/// The wire that a block needs after it, where none is drawn yet. One that acts reaches to the rail.
pub(super) fn wire_after(typing: &Typing<'_>, end: usize, acts: bool) -> &'static str {
    let rest = typing.rest(end);
    if rest.starts_with(['\\', '/', '+', '[', '(', '<']) {
        return "--";
    }
    if !rest.trim().is_empty() {
        return "";
    }
    let line = &typing.text[typing.physical_line()];
    let railed = line.trim_start_matches(['\u{feff}', ' ', '\t']).starts_with('+');
    match (acts, railed) {
        (true, true) => "--+",
        (true, false) => "",
        (false, _) => "--",
    }
}

/// What a list that is not closed yet needs after the operand that is written: the operands that are still missing,
/// the parenthesis, and the wire.
pub(super) fn rest_of_list(typing: &Typing<'_>, operand: &Operand, called: &[Called<'_>]) -> Snippet {
    let nothing = Snippet::default();
    if operand.closed && typing.rest(typing.word.end).starts_with(')') && operand.open.is_empty() {
        return nothing.text(" ").end();
    }
    let drawn = typing.rest(typing.word.end).trim_start();
    if operand.closed || operand.goes_on || !operand.open.is_empty() || drawn.starts_with([',', '.', '[']) {
        return nothing;
    }
    let index = operand.before.len();
    let (missing, acts) = match called.first() {
        Some(Called::Row(row)) => (operands_of(row).unwrap_or_default(), acts(row)),
        Some(Called::User(block)) => (operands_of_user(block), block.shape == Shape::Coil),
        None => return nothing,
    };
    let mut text = nothing;
    if operand.name.is_none() {
        for operand in missing.iter().skip(index + 1) {
            text = text.text(", ").stop(operand);
        }
    }
    text = text.text(" )").text(wire_after(typing, typing.word.end, acts));
    text.end()
}

//! Programs with functions, for systems whose functions do not see the tags of the program: each function is a block that is
//! handed the tags which it uses, and that does nothing without power. The one tag that holds its state is handed on to all that
//! call it, so that its edges and its own blocks go on wherever it is called from. A comment on the block says which function it
//! is, for people and for [`again`], which makes a function of it where such a program is read.

pub(crate) mod again;

use crate::edited::edited_line;
use crate::{WriteError, Writing};
use ladder_analysis::context::{Body, Context};
use ladder_analysis::names::scope::{Origin, TagFacts};
use ladder_analysis::networks::network::Meaning;
use ladder_analysis::networks::{BlockAt, NetworkAt};
use ladder_analysis::program::Role;
use ladder_analysis::values::types::Type;
use ladder_analysis::written::facts::NodeKind;
use ladder_analysis::{Analysis, AnalyzeOptions, analyze};
use ladder_syntax::{Item, LineKind, Name, TextRange, parse};
use std::collections::{BTreeMap, BTreeSet, HashSet};
use std::ops::Range;

/// Writes a program whose functions are blocks. Where they cannot be, `write` is handed the program as it is.
///
/// # Errors
///
/// Those of `write`.
pub(crate) fn with_functions_as_blocks(
    analysis: &Analysis,
    write: impl Fn(&Analysis) -> Result<Writing, WriteError>,
) -> Result<Writing, WriteError> {
    let Some((blocks, moved)) = as_blocks(analysis) else {
        return write(analysis);
    };
    let mut writing = write(&blocks)?;
    for entry in &mut writing.report.entries {
        let line = entry.place.line;
        let after = moved.partition_point(|part| part.lines.start <= line);
        let part = after.checked_sub(1).map(|part| &moved[part]);
        if let Some(part) = part.filter(|part| part.lines.contains(&line)) {
            entry.place.line = part.from + (line - part.lines.start).min(part.most);
        }
    }
    writing.report.entries.sort_by_key(|entry| entry.place);
    Ok(writing)
}

/// Functions call each other no deeper: see the language.
const DEEPEST: usize = 64;
/// All calls together are handed no more.
const MOST_OPERANDS: usize = 200_000;

/// Lines of a block, from 1.
struct Moved {
    lines: Range<u32>,
    /// The line of the program that the first of them stands for.
    from: u32,
    /// The others stand for lines after it, at most so many.
    most: u32,
}

/// The comment on a block that is a function. The name follows.
const MARK: &str = "In ladder text this is the function ";
/// What follows the name if the function begins on a network that does more.
const BEGINS: &str = ", from its first network on";

/// Whether the comment on a block says that it is a function in ladder text. It does nothing without power, and a reader says so.
pub fn is_function(comment: &str) -> bool {
    comment.lines().any(|line| line.starts_with(MARK))
}

/// A function on its way to a block.
#[derive(Default)]
struct Function {
    /// Its name.
    name: String,
    /// The name of the block.
    block: String,
    /// The tag that holds its state.
    state: String,
    /// Its lines, with the comments above it and in it.
    lines: Vec<usize>,
    /// The network with which it begins.
    first: usize,
    /// What it is handed, by name.
    operands: BTreeMap<String, Operand>,
    calls: BTreeSet<usize>,
}

/// A tag that a function is handed.
#[derive(Clone)]
struct Operand {
    ty: String,
    /// A copy will do.
    is_input: bool,
}

type Functions = BTreeMap<usize, Function>;

/// A call: the block, in the body of which, and the function.
struct Call<'c> {
    block: BlockAt<'c>,
    within: Body,
    function: usize,
}

/// A program whose functions are blocks, and what stands elsewhere in it. None: it has none, or one cannot be a block.
fn as_blocks(analysis: &Analysis) -> Option<(Analysis, Vec<Moved>)> {
    let context = &analysis.context;
    if context.functions.is_empty() || analysis.has_errors() {
        return None;
    }
    let calls = calls(context)?;
    let mut functions = named(context);
    enter_operands(context, &mut functions)?;
    for call in &calls {
        if let Body::Function(caller) = call.within {
            functions.get_mut(&caller)?.calls.insert(call.function);
        }
    }
    hand_on(&mut functions)?;
    let handed = calls.iter().filter_map(|call| functions.get(&call.function));
    if handed.map(|function| function.operands.len()).sum::<usize>() > MOST_OPERANDS {
        return None;
    }
    for (function, lines) in lines_of_functions(context) {
        functions.get_mut(&function)?.lines = lines;
    }
    let (text, moved) = text(context, &functions, &calls);
    let blocks = analyze(
        &parse(&text).into(),
        AnalyzeOptions::new(&context.name).among(&context.others),
    );
    blocks.program().is_some().then_some((blocks, moved))
}

/// What an instruction is called; of a block of one's own nothing.
pub(crate) fn head(block: BlockAt<'_>) -> String {
    match block.meaning {
        Meaning::Instruction(row) => row.block(),
        _ => String::new(),
    }
}

/// The calls of the file. None: one is in a block, which does not see the tags of the program.
fn calls(context: &Context) -> Option<Vec<Call<'_>>> {
    let mut calls = Vec::new();
    for network in &context.networks {
        for block in network.blocks().filter(|block| head(*block) == "<CALL>") {
            let NodeKind::Name(name) = &block.bound().facts.operands.first()?.value.kind else {
                return None;
            };
            let within = context.bodies[network.index];
            if let Body::Block(_) = within {
                return None;
            }
            calls.push(Call {
                block,
                within,
                function: context.function(&Name::new(name))?,
            });
        }
    }
    Some(calls)
}

/// The functions, with names for their blocks and states.
fn named(context: &Context) -> Functions {
    let mut taken: HashSet<Name> = context.scopes[0]
        .tags
        .iter()
        .map(|tag| Name::new(&tag.name))
        .collect();
    // Blocks lose their sign there.
    taken.extend(
        context
            .user_blocks
            .iter()
            .map(|block| Name::new(&block.name[1..])),
    );
    let mut fresh = |like: String| {
        let mut name = like.clone();
        let mut number = 1;
        while !taken.insert(Name::new(&name)) {
            number += 1;
            name = format!("{like}{number}");
        }
        name
    };
    let mut functions = Functions::new();
    for (number, facts) in context.functions.iter().enumerate() {
        let plain: String = facts.name.chars().filter(char::is_ascii_alphanumeric).collect();
        let plain = plain.trim_start_matches(|c: char| c.is_ascii_digit());
        let plain = if plain.is_empty() { "Function" } else { plain };
        let plain = fresh(plain.to_owned());
        let function = Function {
            name: facts.name.to_string(),
            state: fresh(format!("{plain}_state")),
            block: format!("${plain}"),
            first: facts.network,
            ..Function::default()
        };
        functions.insert(number, function);
    }
    functions
}

/// Enters the tags that the functions use. None: one of them cannot be handed on.
fn enter_operands(context: &Context, functions: &mut Functions) -> Option<()> {
    for tag in &context.scopes[0].tags {
        if tag.name.starts_with('%') || tag.name.eq_ignore_ascii_case("SYS") {
            continue;
        }
        for place in context.uses(tag) {
            let Body::Function(function) = context.bodies[place.network] else {
                continue;
            };
            let Some(function) = functions.get_mut(&function) else {
                continue;
            };
            let ty = tag.ty?;
            let is_input = !place.access.writes() && matches!(ty, Type::Scalar(_));
            // The tag itself must be retentive, and a constant is no in-out.
            let head = head(context.networks.at(place.network).block(place.block));
            if ["(M)", "(SM)", "(RM)", "[PERSIST]"].contains(&head.as_str()) || tag.constant && !is_input {
                return None;
            }
            let ty = ty.to_string();
            let operand = function
                .operands
                .entry(tag.name.to_string())
                .or_insert(Operand { ty, is_input });
            operand.is_input &= is_input;
        }
    }
    Some(())
}

/// Hands on what is used by the functions that a function calls, and their states. None: one calls itself, or that is too much.
fn hand_on(functions: &mut Functions) -> Option<()> {
    for _ in 0..DEEPEST {
        let (mut changes, mut handed) = (false, 0);
        for function in functions.keys().copied().collect::<Vec<_>>() {
            let own = functions.get(&function)?;
            let mut operands = own.operands.clone();
            let mut calls = own.calls.clone();
            for called in &own.calls {
                let called = functions.get(called)?;
                handed += called.operands.len() + called.calls.len();
                if handed > MOST_OPERANDS {
                    return None;
                }
                calls.extend(&called.calls);
                let state = Operand {
                    ty: called.block.clone(),
                    is_input: false,
                };
                operands.insert(called.state.clone(), state);
                for (name, operand) in &called.operands {
                    let own = operands.entry(name.clone()).or_insert_with(|| operand.clone());
                    own.is_input &= operand.is_input;
                }
            }
            if calls.contains(&function) {
                return None;
            }
            let inputs = |all: &BTreeMap<String, Operand>| all.values().filter(|one| one.is_input).count();
            let own = functions.get_mut(&function)?;
            changes |= own.calls.len() < calls.len()
                || own.operands.len() < operands.len()
                || inputs(&own.operands) != inputs(&operands);
            (own.operands, own.calls) = (operands, calls);
        }
        if !changes {
            return Some(());
        }
    }
    None
}

/// The lines of each function of a file: its networks, and the comments above and between these.
pub(crate) fn lines_of_functions(context: &Context) -> BTreeMap<usize, Vec<usize>> {
    let parse = &context.parse;
    let structure = parse.structure();
    let mut lines: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    let mut above: Vec<usize> = Vec::new();
    let mut current = None;
    for item in &structure.items {
        match *item {
            Item::Decoration(line) => above.push(line),
            Item::Network(number) => {
                let above = std::mem::take(&mut above);
                let Body::Function(function) = context.bodies[number] else {
                    continue;
                };
                let own = lines.entry(function).or_default();
                let is_first = current.replace(function) != Some(function);
                let is_comment = |line: &&usize| parse.lines()[**line].kind == LineKind::Comment;
                let from = if is_first {
                    above.len() - above.iter().rev().take_while(is_comment).count()
                } else {
                    0
                };
                own.extend(&above[from..]);
                own.extend(structure.networks[number].lines.clone());
            }
            _ => above.clear(),
        }
    }
    lines
}

/// The text with blocks in the place of functions: they stand at its end, and all else keeps its line.
fn text(context: &Context, functions: &Functions, calls: &[Call<'_>]) -> (String, Vec<Moved>) {
    let parse = &context.parse;
    let edits = edits(context, functions, calls);
    let line_text = |line: usize| edited_line(context, line, &edits);
    let moved: HashSet<usize> = functions
        .values()
        .flat_map(|function| function.lines.iter().copied())
        .collect();
    let mut text = String::new();
    for line in 0..parse.lines().len() {
        if moved.contains(&line) {
            text.extend(parse.lines()[line].text().chars().filter(|c| *c == '\n'));
        } else {
            text.push_str(&line_text(line));
        }
    }
    if !text.ends_with('\n') {
        text.push('\n');
    }
    text.push_str(&declarations(context, functions));
    let mut places = Vec::new();
    let count = |text: &str| text.matches('\n').count() as u32 + 1;
    for function in functions.values() {
        let number = |line: usize| context.line_number(parse.line_start(line)) as u32;
        let first = context.networks.at(function.first);
        let is_above = |line: &&usize| **line < first.first_line;
        let mut push = |text: &mut String, more: &str, from: u32, most: u32| {
            let start = count(text);
            text.push_str(more);
            if !text.ends_with('\n') {
                text.push('\n');
            }
            let lines = start..count(text);
            places.push(Moved { lines, from, most });
        };
        text.push('\n');
        for line in function.lines.iter().take_while(is_above) {
            push(&mut text, &line_text(*line), number(*line), u32::MAX);
        }
        // What only begins the function has nothing to do there.
        let is_bare = first.blocks().count() == 1;
        push(&mut text, &function.head(is_bare), number(first.first_line), 0);
        for line in function.lines.iter().skip_while(is_above) {
            let begins = structure_lines(context, function.first).contains(line);
            if !(begins && is_bare) {
                push(&mut text, &line_text(*line), number(*line), u32::MAX);
            }
        }
        text.push_str("END_FUNCTION_BLOCK\n");
    }
    (text, places)
}

fn structure_lines(context: &Context, network: usize) -> Range<usize> {
    context.parse.structure().networks[network].lines.clone()
}

/// What stands in the place of calls, and of `<FUN>`, in the order of the text.
fn edits(context: &Context, functions: &Functions, calls: &[Call<'_>]) -> Vec<(TextRange, String)> {
    let mut edits = Vec::new();
    for call in calls {
        if let Some(called) = functions.get(&call.function) {
            edits.push((call.block.range(), called.call()));
        }
    }
    for function in functions.values() {
        let first: NetworkAt<'_> = context.networks.at(function.first);
        for block in first.blocks().filter(|block| head(*block) == "<FUN>") {
            let range = block.range();
            edits.push((range, "-".repeat(range.len().into())));
        }
    }
    edits.sort_by_key(|(at, _)| at.start());
    edits
}

/// The tags that hold the states, and those that are handed on and that nothing declares: else what they are would follow from
/// the blocks.
fn declarations(context: &Context, functions: &Functions) -> String {
    let is_handed = |tag: &&TagFacts| {
        let mut functions = functions.values();
        matches!(tag.origin, Origin::Undeclared | Origin::Form)
            && functions.any(|function| function.operands.contains_key(tag.name.as_str()))
    };
    let mut text = String::new();
    for tag in context.scopes[0].tags.iter().filter(is_handed) {
        let section = match (tag.role, tag.retain) {
            (Role::Input, _) => "VAR_INPUT",
            (Role::Output, false) => "VAR_OUTPUT",
            (Role::Output, true) => "VAR_OUTPUT RETAIN",
            (Role::Internal, false) => "VAR",
            (Role::Internal, true) => "VAR RETAIN",
        };
        if let Some(ty) = tag.ty {
            text.push_str(&format!("{section}\n    {} : {ty};\nEND_VAR\n", tag.name));
        }
    }
    text.push_str("VAR\n");
    for function in functions.values() {
        text.push_str(&format!("    {} : {};\n", function.state, function.block));
    }
    text.push_str("END_VAR\n");
    text
}

impl Function {
    /// The block up to the network with which the function begins.
    fn head(&self, is_bare: bool) -> String {
        let begins = if is_bare { "" } else { BEGINS };
        let mut text = format!(
            "# {MARK}{}{begins} #\nFUNCTION_BLOCK [{}]\n",
            self.name, self.block
        );
        for (section, is_input) in [("VAR_INPUT", true), ("VAR_IN_OUT", false)] {
            let own = self
                .operands
                .iter()
                .filter(|(_, operand)| operand.is_input == is_input);
            let own: Vec<String> = own
                .map(|(name, operand)| format!("    {name} : {};\n", operand.ty))
                .collect();
            if !own.is_empty() {
                text.push_str(&format!("{section}\n{}END_VAR\n", own.concat()));
            }
        }
        text.push_str("+--[/]( EN )--<RET>--+\n");
        text
    }

    /// A call of the block.
    fn call(&self) -> String {
        let operands = self.operands.keys().map(|name| format!(", {name} := {name}"));
        format!(
            "[{}]( {}{} )",
            self.block,
            self.state,
            operands.collect::<String>()
        )
    }
}

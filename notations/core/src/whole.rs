//! A program with the functions, blocks and types that it uses of other files and of the library, as one text.

mod functions;
mod search;

use crate::{LineColumn, WriteError};
use functions::Functions;
use ladder_analysis::context::{Callee, Context};
use ladder_analysis::names::named_types::NamedType;
use ladder_analysis::{Analysis, AnalyzeOptions, analyze, library, link_files};
use ladder_syntax::{Item, LineKind, Name, Parse, parse};
use search::{Search, Used};
use std::collections::{HashMap, HashSet};
use std::ops::Range;
use std::sync::Arc;

/// A definition of another file in the text of a program.
pub(crate) struct Added {
    /// `$Motor`, or the name of a function.
    pub(crate) name: String,
    pub(crate) is_block: bool,
    /// What its file is called.
    from: Arc<str>,
    /// Its lines, from 1.
    pub(crate) lines: Range<u32>,
    /// The first of the program's own calls that needs it.
    pub(crate) used: LineColumn,
}

impl Added {
    /// The file, in words.
    pub(crate) fn file(&self) -> &str {
        file(&self.from)
    }
}

fn file(name: &str) -> &str {
    match library::source(name) {
        Some(_) => "the library",
        None => name,
    }
}

/// What a program needs of another file: that file among the others, and the block or function.
type Needed = (usize, Used);

/// The program with what it uses of other files: that stands below its last network, and above comments at its end, so that all
/// else keeps its place. None: it uses nothing of them.
///
/// # Errors
///
/// If they cannot be one text.
pub(crate) fn whole(analysis: &Analysis) -> Result<Option<(Analysis, Vec<Added>)>, WriteError> {
    if analysis.has_errors() {
        return Ok(None);
    }
    let linked;
    let files = match analysis.others() {
        Some(files) => files,
        None => {
            linked = link_files(&Arc::new(analysis.clone()), &|_| None);
            linked.as_ref().map_or(&[][..], |linked| &linked.others)
        }
    };
    if files.is_empty() {
        return Ok(None);
    }
    let context = &analysis.context;
    // What is used by others comes first, and functions at the end.
    let mut found = Search::found(context, files);
    found.reverse();
    found.sort_by_key(|((_, used), _)| matches!(used, Used::Function(_)));
    agree(context, files, &found)?;
    let mut text = context.parse.to_string();
    let end = text.split_off(end_of_networks(&context.parse, text.len()));
    if !text.ends_with('\n') {
        text.push('\n');
    }
    let needed: Vec<Needed> = found.iter().map(|(needed, _)| needed.clone()).collect();
    let functions = Functions::of(context, files, &needed);
    if !functions.declarations.is_empty() {
        text.push_str(&format!("\n{}", functions.declarations));
    }
    text.push_str(&functions::globals(context, files));
    let mut added = Vec::new();
    for ((from, item), used) in found {
        let other = &files[from].context;
        let (name, definition) = match item {
            Used::Block(block) => (
                other.user_blocks[block].name.clone(),
                definition(&other.parse, block),
            ),
            Used::Function(Callee::Own(function)) => {
                let name = other.functions[function].name.to_string();
                (name, functions.text(from, function))
            }
            Used::Function(Callee::Other(_)) => continue,
        };
        text.push('\n');
        let first = line_count(&text);
        text.push_str(&definition);
        added.push(Added {
            is_block: name.starts_with('$'),
            name,
            from: Arc::clone(&other.name),
            lines: first..line_count(&text),
            used,
        });
    }
    let (mut types, mut known) = (String::new(), HashSet::new());
    loop {
        let mut whole = text.clone();
        if !types.is_empty() {
            whole.push_str(&format!("\nTYPE\n{types}END_TYPE\n"));
        }
        whole.push_str(&end);
        let whole = analyze(
            &parse(&whole).into(),
            AnalyzeOptions::new(&context.name).among(&context.others),
        );
        if let Some(error) = whole.errors().next() {
            let message = format!(
                "with what it uses of other files the program has an error: {}",
                error.message
            );
            return Err(WriteError::new(message));
        }
        let before = types.len();
        for ty in whole.context.types.of_others() {
            if known.insert(ty.declaration.key.clone()) {
                types.extend(declaration(files, ty));
            }
        }
        if types.len() == before {
            return Ok(Some((whole, added)));
        }
    }
}

/// Says so if what is needed cannot stand in one text with the program.
fn agree(own: &Context, files: &[Arc<Analysis>], found: &[(Needed, LineColumn)]) -> Result<(), WriteError> {
    let mut blocks: HashMap<&Name, &str> = HashMap::new();
    blocks.extend(
        own.user_blocks[..own.own_blocks]
            .iter()
            .map(|block| (&block.key, &*own.name)),
    );
    let mut types: HashMap<&Name, &NamedType> = HashMap::new();
    types.extend(own.types.own().iter().map(|ty| (&ty.declaration.key, ty)));
    let mut known = HashSet::new();
    for ((from, used), at) in found {
        let other = &files[*from].context;
        let name = match used {
            Used::Block(block) => other.user_blocks[*block].name.as_str(),
            Used::Function(Callee::Own(function)) => &other.functions[*function].name,
            Used::Function(Callee::Other(_)) => continue,
        };
        if other.profile != own.profile {
            let says = |file: &Context| match file.profile.name() {
                "iec" => "IEC 61131-3",
                other => other,
            };
            return Err(WriteError::new(format!(
                "{at}: `{}` of {} counts and times as {} says, and this program as {} does: draw what it does on rungs of the program",
                name,
                file(&other.name),
                says(other),
                says(own)
            )));
        }
        if let Used::Block(block) = used
            && let Some(first) = blocks.insert(&other.user_blocks[*block].key, &other.name)
        {
            return Err(WriteError::new(format!(
                "{at}: there is a `{}` in {} and another one in {}, and what is written has one of a name: rename one of them",
                name,
                file(first),
                file(&other.name)
            )));
        }
        if !known.insert(from) {
            continue;
        }
        for ty in other.types.own().iter().chain(other.types.of_others()) {
            let first = types.entry(&ty.declaration.key).or_insert(ty);
            if first.declaration.declared != ty.declaration.declared {
                return Err(WriteError::new(format!(
                    "{at}: `{}` of {} knows another type `{}`, and what is written has one of a name: rename one of them",
                    name,
                    file(&other.name),
                    ty.declaration.name
                )));
            }
        }
    }
    Ok(())
}

/// Where the comments at the end of a text begin.
fn end_of_networks(parse: &Parse, length: usize) -> usize {
    let items = parse.structure().items.iter().rev();
    let last = items.map_while(|item| match item {
        Item::Decoration(line) => Some(*line),
        _ => None,
    });
    last.last().map_or(length, |line| parse.line_start(line).into())
}

/// The definition of a block, with the comments that stand directly above it.
fn definition(parse: &Parse, block: usize) -> String {
    let lines = parse.structure().blocks[block].lines.clone();
    let above = (0..lines.start).rev();
    let above = above.take_while(|line| parse.lines()[*line].kind == LineKind::Comment);
    text_of(parse, lines.start - above.count()..lines.end)
}

/// The declaration of a type in its file.
fn declaration(files: &[Arc<Analysis>], ty: &NamedType) -> Option<String> {
    let name = ty.file.as_ref()?;
    let file = files.iter().find(|file| file.context.name == *name)?;
    let parse = &file.context.parse;
    let first = parse.line_at(ty.declaration.at.start())?;
    let is_end = |line: &usize| matches!(parse.lines()[*line].kind, LineKind::StructEnd);
    let last = match parse.lines()[first].kind {
        LineKind::StructHeader => (first..parse.lines().len()).find(is_end)?,
        _ => first,
    };
    Some(text_of(parse, first..last + 1))
}

/// Some lines, the last one with its end.
fn text_of(parse: &Parse, lines: Range<usize>) -> String {
    let mut text = String::new();
    for line in lines {
        text.push_str(parse.lines()[line].text());
    }
    if !text.ends_with('\n') {
        text.push('\n');
    }
    text
}

/// The number of the line that a text ends on.
fn line_count(text: &str) -> u32 {
    text.matches('\n').count() as u32 + 1
}

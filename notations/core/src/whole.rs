//! A program with the functions, blocks and types that it uses of other files and of the library, as one text.

mod functions;
mod search;

use crate::elements::is_comment;
use crate::rewritten::{ADDED, Rewritten};
use crate::{LineColumn, Unwritable, WriteError};
use functions::Functions;
pub(crate) use functions::{declaration, is_shared};
use ladder_analysis::context::{Callee, Context};
use ladder_analysis::names::named_types::NamedType;
use ladder_analysis::{Analysis, library, link_files};
use ladder_format::program::{Drawing, Item, Origin, ProgramSketch, RungPiece};
use ladder_syntax::{LineKind, Name, Parse};
use search::Search;
pub(crate) use search::{Used, called_name, used_by};
use std::collections::{HashMap, HashSet};
use std::ops::Range;
use std::sync::Arc;

/// A definition of another file in a program.
pub(crate) struct Added {
    /// `$Motor`, or the name of a function.
    pub(crate) name: String,
    pub(crate) is_block: bool,
    /// What its file is called.
    from: Arc<str>,
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

/// The program with what it uses of other files: that is below its last network, and above comments at its end. Origins of it are
/// [`ADDED`] and its number. The program as it is: it uses nothing of them. Blocks that count and time in another way are unwritable.
///
/// # Errors
///
/// If they cannot be one text.
pub(crate) fn whole(analysis: &Analysis) -> Result<(Rewritten, Vec<Added>, Unwritable), WriteError> {
    let program = Rewritten::of(analysis);
    if analysis.has_errors() {
        return Ok((program, Vec::new(), Unwritable::new()));
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
        return Ok((program, Vec::new(), Unwritable::new()));
    }
    let context = &analysis.context;
    // What is used by others comes first, and functions at the end.
    let mut found = Search::found(context, files);
    found.reverse();
    found.sort_by_key(|((_, used), _)| matches!(used, Used::Function(_)));
    let unwritable = agree(context, files, &found)?;
    let mut items = ProgramSketch::of_text(&context.parse).items;
    let is_end = |item: &Item| is_comment(item) || *item == Item::Blank;
    let end = items.iter().rev().take_while(|item| is_end(item)).count();
    let end = items.split_off(items.len() - end);
    let needed: Vec<Needed> = found.iter().map(|(needed, _)| needed.clone()).collect();
    let mut functions = Functions::of(context, files, &needed);
    items.append(&mut functions.declarations);
    items.extend(functions::globals(context, files));
    let (mut added, mut sketches) = (Vec::new(), HashMap::new());
    for ((from, item), used) in found {
        let other = &files[from].context;
        let origin = ADDED + added.len() as Origin;
        let (name, mut definition) = match item {
            Used::Block(block) => {
                let sketch = sketches
                    .entry(from)
                    .or_insert_with(|| ProgramSketch::of_text(&other.parse).items);
                (other.user_blocks[block].name.clone(), definition(sketch, block))
            }
            Used::Function(Callee::Own(function)) => {
                let name = other.functions[function].name.to_string();
                (name, functions.take(from, function))
            }
            Used::Function(Callee::Other(_)) => continue,
        };
        mark(&mut definition, origin);
        items.push(Item::Blank);
        items.append(&mut definition);
        added.push(Added {
            is_block: name.starts_with('$'),
            name,
            from: Arc::clone(&other.name),
            used,
        });
    }
    let (mut types, mut known) = (String::new(), HashSet::new());
    loop {
        let mut sketch = ProgramSketch { items: items.clone() };
        if !types.is_empty() {
            let lines = ["TYPE", &types, "END_TYPE"].map(|text| Item::Text(text.to_owned()));
            sketch.items.push(Item::Blank);
            sketch.items.extend(lines);
        }
        sketch.items.extend(end.iter().cloned());
        let whole = program.with(&sketch);
        if let Some(error) = whole.analysis.errors().next() {
            let message = format!(
                "with what it uses of other files the program has an error: {}",
                error.message
            );
            return Err(WriteError::new(message));
        }
        let before = types.len();
        for ty in whole.analysis.context.types.of_others() {
            if known.insert(ty.declaration.key.clone()) {
                types.extend(type_declaration(files, ty));
            }
        }
        if types.len() == before {
            return Ok((whole, added, unwritable));
        }
    }
}

/// Says so if what is needed cannot stand in one text with the program. The blocks come back that count and time in another way.
fn agree(
    own: &Context,
    files: &[Arc<Analysis>],
    found: &[(Needed, LineColumn)],
) -> Result<Unwritable, WriteError> {
    let mut blocks: HashMap<&Name, &str> = HashMap::new();
    blocks.extend(
        own.user_blocks[..own.own_blocks]
            .iter()
            .map(|block| (&block.key, &*own.name)),
    );
    let mut types: HashMap<&Name, &NamedType> = HashMap::new();
    types.extend(own.types.own().iter().map(|ty| (&ty.declaration.key, ty)));
    let (mut known, mut unwritable) = (HashSet::new(), Unwritable::new());
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
            let why = format!(
                "`{}` of {} counts and times as {} says, and this program as {} does: draw what it does on rungs of the program",
                name,
                file(&other.name),
                says(other),
                says(own)
            );
            if !matches!(used, Used::Block(_)) {
                return Err(WriteError::new(format!("{at}: {why}")));
            }
            unwritable.insert(Name::new(name), why);
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
    Ok(unwritable)
}

/// The definition of a block, with the comments directly above it.
fn definition(items: &[Item], block: usize) -> Vec<Item> {
    let mut blocks = (0..items.len()).filter(|at| matches!(items[*at], Item::Block { .. }));
    let Some(at) = blocks.nth(block) else {
        return Vec::new();
    };
    let above = items[..at]
        .iter()
        .rev()
        .take_while(|item| is_comment(item))
        .count();
    items[at - above..=at].to_vec()
}

/// Sets one origin for all of some items, which come from a text.
fn mark(items: &mut [Item], origin: Origin) {
    for item in items {
        match item {
            Item::Kept(_, own) => *own = origin,
            Item::Block {
                origin: own, items, ..
            } => {
                *own = Some(origin);
                mark(items, origin);
            }
            Item::Network(network) => {
                if let Drawing::Rungs(rungs) = &mut network.drawing {
                    for piece in rungs.iter_mut().flatten() {
                        if let RungPiece::Element(element) = piece {
                            element.origin = Some(origin);
                        }
                    }
                }
            }
            _ => {}
        }
    }
}

/// The declaration of a type in its file.
fn type_declaration(files: &[Arc<Analysis>], ty: &NamedType) -> Option<String> {
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

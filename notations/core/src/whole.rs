//! A program with the blocks and types that it uses of other files and of the library, as one text.

use crate::{LineColumn, Lines, WriteError};
use ladder_analysis::context::{Body, Context};
use ladder_analysis::names::named_types::NamedType;
use ladder_analysis::networks::NetworkAt;
use ladder_analysis::networks::network::Meaning;
use ladder_analysis::values::types::Type;
use ladder_analysis::{Analysis, analyze_in, library, link_files};
use ladder_syntax::{Item, LineKind, Name, Parse, parse};
use std::collections::{HashMap, HashSet};
use std::ops::Range;
use std::sync::Arc;

/// A definition of another file in the text of a program.
pub(crate) struct Added {
    pub(crate) name: String,
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

/// A block that a program needs: its file among the others, and its number in that file.
type Needed = (usize, usize);

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
    let by_name = files.iter().enumerate();
    let mut search = Search {
        own: context,
        files,
        by_name: by_name
            .map(|(number, file)| (&*file.context.name, number))
            .collect(),
        uses: HashMap::new(),
        found: Vec::new(),
        seen: HashSet::new(),
    };
    search.of_program();
    // What is used by others comes first.
    let found: Vec<_> = search.found.into_iter().rev().collect();
    agree(context, files, &found)?;
    let mut text = context.parse.to_string();
    let end = text.split_off(end_of_networks(&context.parse, text.len()));
    if !text.ends_with('\n') {
        text.push('\n');
    }
    let mut added = Vec::new();
    for ((from, block), used) in found {
        let other = &files[from].context;
        text.push('\n');
        let first = line_count(&text);
        text.push_str(&definition(&other.parse, block));
        added.push(Added {
            name: other.user_blocks[block].name.clone(),
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
        let whole = analyze_in(&parse(&whole).into(), &context.name, &context.others);
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

/// Looks for the blocks of other files that a program needs.
struct Search<'a> {
    own: &'a Context,
    files: &'a [Arc<Analysis>],
    by_name: HashMap<&'a str, usize>,
    /// For each file that was asked the blocks that each of its own uses, by their numbers in its list.
    uses: HashMap<usize, HashMap<usize, Vec<usize>>>,
    found: Vec<(Needed, LineColumn)>,
    seen: HashSet<Needed>,
}

impl Search<'_> {
    fn of_program(&mut self) {
        let text = self.own.parse.to_string();
        let lines = Lines::of(&text);
        let calls = self.own.networks.iter().flat_map(NetworkAt::blocks);
        for call in calls {
            if let Meaning::User(user) = call.meaning {
                self.used(
                    self.own,
                    None,
                    user,
                    lines.place(&text, call.range().start().into()),
                );
            }
        }
        // Those that only declarations name.
        for user in self.own.own_blocks..self.own.user_blocks.len() {
            self.used(self.own, None, user, LineColumn::START);
        }
    }

    /// A block of the list of a file, and all that it uses; `from`: one of the others.
    fn used(&mut self, context: &Context, from: Option<usize>, user: usize, at: LineColumn) {
        let mut waiting: Vec<Needed> = self.needed(context, from, user).into_iter().collect();
        while let Some((file, block)) = waiting.pop() {
            if !self.seen.insert((file, block)) {
                continue;
            }
            self.found.push(((file, block), at));
            let other = Arc::clone(&self.files[file].context);
            let uses = self.uses.entry(file).or_insert_with(|| uses(&other));
            let used = uses.remove(&block).unwrap_or_default();
            waiting.extend(
                used.into_iter()
                    .filter_map(|user| self.needed(&other, Some(file), user)),
            );
        }
    }

    fn needed(&self, context: &Context, from: Option<usize>, user: usize) -> Option<Needed> {
        match &context.user_blocks[user].import {
            Some(import) => Some((*self.by_name.get(&*import.file)?, import.item)),
            None => from.map(|from| (from, user)),
        }
    }
}

/// The blocks that each block of a file calls, or has a tag of.
fn uses(context: &Context) -> HashMap<usize, Vec<usize>> {
    let mut uses: HashMap<usize, Vec<usize>> = HashMap::new();
    for network in &context.networks {
        if let Body::Block(block) = context.bodies[network.index] {
            let called = network.blocks().filter_map(|call| match call.meaning {
                Meaning::User(user) => Some(user),
                _ => None,
            });
            uses.entry(block).or_default().extend(called);
        }
    }
    let blocks = context.user_blocks.iter().enumerate();
    let by_name: HashMap<&Name, usize> = blocks.map(|(number, block)| (&block.key, number)).collect();
    for scope in &context.scopes {
        let Some(block) = scope.block else { continue };
        let names = scope.tags.iter().filter_map(|tag| tag.ty).flat_map(Type::blocks);
        let used = names.filter_map(|name| by_name.get(&Name::new(&name)).copied());
        uses.entry(block).or_default().extend(used);
    }
    uses
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
    for ((from, block), at) in found {
        let other = &files[*from].context;
        let block = &other.user_blocks[*block];
        if other.profile != own.profile {
            let says = |file: &Context| match file.profile.name() {
                "iec" => "IEC 61131-3",
                other => other,
            };
            return Err(WriteError::new(format!(
                "{at}: `{}` of {} counts and times as {} says, and this program as {} does: draw what it does on rungs of the program",
                block.name,
                file(&other.name),
                says(other),
                says(own)
            )));
        }
        if let Some(first) = blocks.insert(&block.key, &other.name) {
            return Err(WriteError::new(format!(
                "{at}: there is a `{}` in {} and another one in {}, and what is written has one of a name: rename one of them",
                block.name,
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
                    block.name,
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

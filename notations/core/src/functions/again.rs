//! What was written as blocks is functions again: of a block that says which function it is, where it is still called with the tags
//! of the program by their own names, nothing is lost. One that was changed otherwise stays a block.

use super::{BEGINS, DEEPEST, MARK};
use crate::elements::{Call, blocks, change, rename, series};
use crate::items::{above, block_name, trim, without};
use ladder_format::Circuit;
use ladder_format::program::{
    Block, Declaration, Drawing, Element, Item, Network, Path, ProgramSketch, RungPiece, Section, SectionKind,
};
use ladder_syntax::Name;
use std::collections::HashMap;

/// Makes functions of the blocks in the files of a program that say so.
pub(crate) fn functions_again(files: &mut [&mut ProgramSketch]) {
    let mut found = marked(files);
    if found.is_empty() {
        return;
    }
    found.retain(Marked::is_whole);
    find_states(files, &mut found);
    found.retain(|block| block.state != Name::new(""));
    resolve(files, &mut found);
    found.retain(|block| block.tags.is_some());
    // Functions stand where their program is.
    let Some(home) = found.first().map(|block| block.home) else {
        return;
    };
    found.retain(|block| block.home == home);
    found.sort_by_key(|block| block.rank);
    let functions: HashMap<Name, String> = found
        .iter()
        .map(|block| (block.key.clone(), block.function.clone()))
        .collect();
    let call = |block: &mut Block| {
        if let Some(call) = Call::of(block)
            && let Some(function) = functions.get(&call.block)
        {
            *block = Block::call(function);
        }
    };
    for file in files.iter_mut() {
        file.items = without(std::mem::take(&mut file.items), &|block| {
            functions.contains_key(block)
        });
        change(&mut file.items, &mut |_, block| call(block));
        for section in sections(&mut file.items) {
            section
                .declarations
                .retain(|declared| !functions.contains_key(&Name::new(&declared.ty)));
        }
        trim(&mut file.items);
    }
    let mut names = declared(&files[home].items);
    let mut locals = Vec::new();
    for block in found {
        let mut own = block.items;
        change(&mut own, &mut |_, block| call(block));
        let mut renamed = block.tags.unwrap_or_default();
        renamed.retain(|name, tag| *name != Name::new(tag));
        for section in sections(&mut own) {
            if section.kind != SectionKind::Var {
                continue;
            }
            for declared in &mut section.declarations {
                for name in &mut declared.names {
                    let free = names.fresh(name);
                    if free != *name {
                        renamed.insert(Name::new(name), free.clone());
                        *name = free;
                    }
                }
            }
            locals.push(section.clone());
        }
        if !renamed.is_empty() {
            change(&mut own, &mut |_, block| rename(block, &renamed));
        }
        let items = &mut files[home].items;
        items.extend(function(block.function, block.begins, block.told, own));
    }
    declare(&mut files[home].items, locals);
}

/// What the comment above a block ends with that has another name there.
const SPELLED: &str = " in the project";

/// A block that says which function it is.
struct Marked {
    /// `$Rinse`
    key: Name,
    function: String,
    /// The function begins on its first network.
    begins: bool,
    told: Vec<String>,
    items: Vec<Item>,
    /// The file that has the tag of its state, which has this name and is declared after so many others.
    home: usize,
    state: Name,
    rank: usize,
    /// The tags of the program that it is handed, by their names in it, once they are known.
    tags: Option<HashMap<Name, String>>,
}

/// The blocks of all files that say so.
fn marked(files: &[&mut ProgramSketch]) -> Vec<Marked> {
    let mut found = Vec::new();
    for (home, file) in files.iter().enumerate() {
        for (at, item) in file.items.iter().enumerate() {
            let Item::Block { header, items, .. } = item else {
                continue;
            };
            let mut told: Vec<String> = above(&file.items, at)
                .flat_map(|told| told.lines())
                .map(str::to_owned)
                .collect();
            let Some(mark) = told.iter().position(|line| line.starts_with(MARK)) else {
                continue;
            };
            let line = told.remove(mark);
            // It says how the block is spelled there.
            if told.first().is_some_and(|line| line.ends_with(SPELLED)) {
                told.remove(0);
            }
            let name = &line[MARK.len()..];
            let (name, begins) = match name.strip_suffix(BEGINS) {
                Some(name) => (name, true),
                None => (name, false),
            };
            found.push(Marked {
                key: block_name(header),
                function: name.to_owned(),
                begins,
                told,
                items: items.clone(),
                home,
                state: Name::new(""),
                rank: 0,
                tags: None,
            });
        }
    }
    found
}

impl Marked {
    /// Whether it begins with what keeps it from running without power, knows nothing else of that, and has what a function has.
    fn is_whole(&self) -> bool {
        let is_name =
            self.function.chars().all(|c| c.is_alphanumeric() || c == '_') && !self.function.is_empty();
        let mut networks = self.items.iter().filter_map(|item| match item {
            Item::Network(network) => Some(network),
            _ => None,
        });
        let guard = networks.next().and_then(series);
        let mut knows_power = false;
        for network in networks {
            let items = [Item::Network(network.clone())];
            blocks(&items, &mut |block| {
                block.paths(|path| knows_power |= is_power(&path.root));
            });
        }
        let kinds = [SectionKind::Var, SectionKind::VarInput, SectionKind::VarInOut];
        let is_plain = self.items.iter().all(|item| match item {
            Item::Section(section) => kinds.contains(&section.kind) && section.qualifier.is_none(),
            Item::Block { .. } | Item::Text(_) | Item::Directive(_) => false,
            _ => true,
        });
        is_name
            && is_plain
            && !knows_power
            && guard.is_some_and(|guard| guard == [&Block::negated_contact(Path::tag("EN")), &Block::ret()])
    }

    /// What it is handed, with the types.
    fn handed(&self) -> impl Iterator<Item = (&String, &Declaration)> {
        let own = self
            .items
            .iter()
            .filter_map(section)
            .filter(|section| section.kind != SectionKind::Var);
        own.flat_map(|section| &section.declarations)
            .flat_map(|declared| declared.names.iter().map(move |name| (name, declared)))
    }

    /// The tags of the program that a call hands it, if it hands it its state and all that it asks for. `tags`: those that
    /// the caller is handed; none in the program itself.
    fn handed_by(&self, call: &Call, tags: Option<&HashMap<Name, String>>) -> Option<HashMap<Name, String>> {
        let in_program = |tag: &str| match tags {
            Some(tags) => tags.get(&Name::new(tag)).cloned(),
            None => Some(tag.to_owned()),
        };
        let given: HashMap<Name, String> = call
            .given
            .iter()
            .map(|(name, tag)| Some((Name::new(name), in_program(tag.path()?.whole()?)?)))
            .collect::<Option<_>>()?;
        let is_all = self
            .handed()
            .all(|(name, _)| given.contains_key(&Name::new(name)));
        let is_state =
            in_program(call.state.as_deref()?).is_some_and(|state| Name::new(&state) == self.state);
        (is_state && is_all && given.len() == self.handed().count()).then_some(given)
    }

    /// Whether the tags that it is handed have the types of those of the program.
    fn fits(&self, tags: &HashMap<Name, String>, types: &HashMap<Name, String>) -> bool {
        self.handed().all(|(name, declared)| {
            let tag = tags.get(&Name::new(name)).map(|tag| Name::new(tag));
            tag.and_then(|tag| types.get(&tag))
                .is_some_and(|ty| is_of(ty, &declared.ty))
        })
    }
}

/// Looks for the tag of each block's state: one, with no comment of its own.
fn find_states(files: &[&mut ProgramSketch], found: &mut [Marked]) {
    let by_key = found.iter().enumerate();
    let by_key: HashMap<Name, usize> = by_key
        .map(|(number, block)| (block.key.clone(), number))
        .collect();
    let mut count = vec![0; found.len()];
    for (home, file) in files.iter().enumerate() {
        let declared = file.items.iter().filter_map(section);
        let declared =
            declared.flat_map(|section| section.declarations.iter().map(move |one| (section, one)));
        for (rank, (section, declared)) in declared.enumerate() {
            let Some(&number) = by_key.get(&Name::new(&declared.ty)) else {
                continue;
            };
            count[number] += 1;
            let is_plain = section.kind == SectionKind::Var && section.qualifier.is_none();
            if let [name] = &declared.names[..]
                && is_plain
                && declared.initial.is_none()
            {
                let block = &mut found[number];
                (block.home, block.state, block.rank) = (home, Name::new(name), rank);
            }
        }
    }
    for (block, count) in found.iter_mut().zip(count) {
        if count != 1 {
            block.state = Name::new("");
        }
    }
}

/// Finds for each block the tags that it is handed: the same wherever it is called, in the program or in another one that is a
/// function again.
fn resolve(files: &[&mut ProgramSketch], found: &mut [Marked]) {
    let by_key: HashMap<Name, usize> = found
        .iter()
        .enumerate()
        .map(|(number, block)| (block.key.clone(), number))
        .collect();
    let mut types: HashMap<Name, String> = HashMap::new();
    // Of each block its calls, with the block that calls.
    let mut calls: Vec<Vec<(Caller, Call)>> = found.iter().map(|_| Vec::new()).collect();
    for item in files.iter().flat_map(|file| &file.items) {
        if let Some(section) = section(item) {
            for declared in &section.declarations {
                types.extend(
                    declared
                        .names
                        .iter()
                        .map(|name| (Name::new(name), declared.ty.clone())),
                );
            }
        }
        let caller = match item {
            Item::Block { header, .. } => match by_key.get(&block_name(header)) {
                Some(number) => Caller::Function(*number),
                None => Caller::Block,
            },
            _ => Caller::Program,
        };
        blocks(std::slice::from_ref(item), &mut |block| {
            if let Some(call) = Call::of(block)
                && let Some(called) = by_key.get(&call.block)
            {
                calls[*called].push((caller, call));
            }
        });
    }
    // One that nothing calls is handed what has the same name.
    for (block, calls) in found.iter_mut().zip(&calls) {
        let own: HashMap<Name, String> = block
            .handed()
            .map(|(name, _)| (Name::new(name), name.clone()))
            .collect();
        if calls.is_empty() && block.fits(&own, &types) {
            block.tags = Some(own);
        }
    }
    // Callers are known before what they call.
    for _ in 0..DEEPEST {
        let mut changes = false;
        for (number, calls) in calls.iter().enumerate() {
            if found[number].tags.is_some() {
                continue;
            }
            let mut handed = calls.iter().map(|(caller, call)| {
                let tags = match caller {
                    Caller::Program => None,
                    Caller::Function(caller) => Some(found[*caller].tags.as_ref()?),
                    Caller::Block => return None,
                };
                found[number].handed_by(call, tags)
            });
            let first = handed.next().flatten();
            let first = first.filter(|first| found[number].fits(first, &types));
            if let Some(first) = first
                && handed.all(|other| other.as_ref() == Some(&first))
            {
                found[number].tags = Some(first);
                changes = true;
            }
        }
        if !changes {
            return;
        }
    }
}

/// Where a call stands.
#[derive(Clone, Copy)]
enum Caller {
    Program,
    /// In a block that says that it is a function.
    Function(usize),
    Block,
}

/// Whether a tag of a type is one of another: the same, a part of its range, or a name for it.
fn is_of(ty: &str, wanted: &str) -> bool {
    let (ty, wanted) = (ty.to_uppercase(), wanted.to_uppercase());
    let base = ty.split('(').next().unwrap_or_default();
    let is_known = ladder_analysis::values::types::Scalar::from_name(base).is_some();
    ty == wanted || base == wanted || (!is_known && !ty.starts_with("ARRAY"))
}

fn is_power(word: &str) -> bool {
    word.eq_ignore_ascii_case("EN") || word.eq_ignore_ascii_case("ENO")
}

/// The networks of a function.
fn function(name: String, begins: bool, told: Vec<String>, items: Vec<Item>) -> Vec<Item> {
    let head = Element::of(Block::function(&name), None);
    let mut out = Vec::new();
    let mut items = items.into_iter().filter(|item| !matches!(item, Item::Section(_)));
    // The guard is in the place of the head.
    let mut comments = told;
    for item in items.by_ref() {
        match item {
            Item::Comment(told) if !told.ends_with(SPELLED) => comments.push(told),
            Item::Network(guard) => {
                comments.extend(guard.comments);
                break;
            }
            _ => {}
        }
    }
    let mut rest: Vec<Item> = items.collect();
    let first = rest.iter_mut().find_map(|item| match item {
        Item::Network(network) => Some(network),
        _ => None,
    });
    let first = first.filter(|_| begins);
    match first.and_then(|first| begin(&mut first.drawing, &head).then_some(first)) {
        Some(first) => {
            first.comments.splice(0..0, comments);
        }
        _ => out.extend([
            Item::Blank,
            Item::Network(Network {
                comments,
                drawing: Drawing::Circuit(Circuit::Element(head)),
            }),
        ]),
    }
    out.append(&mut rest);
    out
}

/// Puts an element in front of a network. Not if that does not begin at the rail.
fn begin(drawing: &mut Drawing, head: &Element) -> bool {
    match drawing {
        Drawing::Circuit(circuit) => {
            let rest = std::mem::replace(circuit, Circuit::Series(Vec::new()));
            let rest = match rest {
                Circuit::Series(parts) => parts,
                other => vec![other],
            };
            *circuit = Circuit::Series(
                std::iter::once(Circuit::Element(head.clone()))
                    .chain(rest)
                    .collect(),
            );
            true
        }
        Drawing::Rungs(rungs) => match rungs.first_mut() {
            Some(rung) if rung.first() == Some(&RungPiece::Rail) => {
                rung.insert(1, RungPiece::Element(head.clone()));
                true
            }
            _ => false,
        },
    }
}

fn section(item: &Item) -> Option<&Section> {
    match item {
        Item::Section(section) if section.kind != SectionKind::Type => Some(section),
        _ => None,
    }
}

fn sections(items: &mut [Item]) -> impl Iterator<Item = &mut Section> {
    items.iter_mut().filter_map(|item| match item {
        Item::Section(section) => Some(section),
        _ => None,
    })
}

/// The names that are taken in a file.
fn declared(items: &[Item]) -> ladder_format::names::Names {
    let mut names = ladder_format::names::Names::default();
    for section in items.iter().filter_map(section) {
        for name in section.declarations.iter().flat_map(|declared| &declared.names) {
            names.fresh(name);
        }
    }
    names
}

/// Declares tags with the others of a file.
fn declare(items: &mut Vec<Item>, more: Vec<Section>) {
    for section in more {
        let same = |own: &&mut Section| (own.kind, own.qualifier) == (section.kind, section.qualifier);
        if let Some(own) = sections(items).find(same) {
            own.declarations.extend(section.declarations);
            continue;
        }
        let after = items.iter().rposition(|item| matches!(item, Item::Section(_)));
        let networks = items.iter().position(|item| matches!(item, Item::Network(_)));
        let at = after.map(|at| at + 1).or(networks).unwrap_or(items.len());
        items.insert(at, Item::Section(section));
    }
}

//! What a row or an operand of a property names: `run`, `warmup.ET`, `cell[2].valve.open`; of a file that the program only uses with the file's name before
//! it, `library.count`; of a place where a block is, `$Ramp#1.level`; and the values of an enumeration in its cells.

use super::file::Scenarios;
use super::naming::{Naming, namings};
use crate::neighbour::{ScenarioFile, Which, Workspace, first_that, mentions, named as file_named};
use crate::path::{Reached, Step, member_type, steps};
use crate::symbol::types::{declared_name, member_of, type_named};
use crate::symbol::{Symbol, Usage, block_file, tag_of};
use ladder_analysis::context::Context;
use ladder_analysis::names::scope::TagFacts;
use ladder_analysis::program::SystemTag;
use ladder_analysis::values::types::{Scalar, Type};
use ladder_simulator::scenario::{Cell, PlantLine, Row, Suite};
use ladder_syntax::{Name, TextRange, TextSize};
use std::ops::{Deref, Range};
use std::sync::Arc;

/// A file of the workspace.
#[derive(Clone)]
pub(crate) enum File<'c> {
    /// One that is known already.
    Known(&'c Context),
    /// One that the workspace has.
    Other(Arc<Context>),
}

impl Deref for File<'_> {
    type Target = Context;

    fn deref(&self) -> &Context {
        match self {
            File::Known(file) => file,
            File::Other(file) => file,
        }
    }
}

/// The files of which a row can name something.
#[derive(Clone, Copy)]
pub(crate) struct Files<'c> {
    /// The program that the scenarios are about.
    program: &'c Context,
    /// A file that the workspace does not show, for it was asked about.
    own: &'c Context,
    /// What the scenarios say: of the plants, which names go before those of their tags.
    pub(super) suite: &'c Suite,
    workspace: &'c dyn Workspace,
}

impl<'c> Files<'c> {
    pub(super) fn of(scenarios: &Scenarios<'c>) -> Option<Files<'c>> {
        let program = scenarios.program?;
        Some(Files {
            program,
            own: program,
            suite: scenarios.suite,
            workspace: scenarios.workspace,
        })
    }

    fn named(&self, name: &str) -> Option<File<'c>> {
        let mut known = [self.program, self.own].into_iter();
        match known.find(|file| file.is_called(name)) {
            Some(file) => Some(File::Known(file)),
            None => file_named(self.workspace, name).map(File::Other),
        }
    }

    /// The body of a block that a file knows: its file and scope.
    pub(super) fn body(&self, file: &Context, block: &Name) -> Option<(File<'c>, usize)> {
        let home = self.named(&block_file(file, block)?)?;
        let own = home.user_blocks[..home.own_blocks].iter();
        let (_, scope) = own.zip(1..).find(|(facts, _)| facts.key == *block)?;
        Some((home, scope))
    }

    /// The file whose tags have this before their names.
    fn with_stem(&self, stem: &Name, tag: &Name) -> Option<File<'c>> {
        let mut plants = self.suite.plants.iter();
        if let Some(plant) = plants.find(|plant| Name::new(&plant.name) == *stem) {
            return self.plant(plant);
        }
        self.of_stem(stem, Which::Mentioning(std::slice::from_ref(tag)))
    }

    fn of_stem(&self, stem: &Name, which: Which<'_>) -> Option<File<'c>> {
        let is_it = |file: &Context| Name::new(stem_of(&file.name)) == *stem;
        if is_it(self.own) && !self.program.is_called(&self.own.name) {
            return Some(File::Known(self.own));
        }
        first_that(self.workspace, which, is_it).map(File::Other)
    }

    /// What runs beside the program.
    pub(crate) fn plants(&self) -> impl Iterator<Item = (&'c PlantLine, File<'c>)> + '_ {
        let plants = self.suite.plants.iter();
        plants.filter_map(|plant| Some((plant, self.plant(plant)?)))
    }

    /// The file of a plant: named as the program is, or else one that is called so.
    pub(super) fn plant(&self, plant: &PlantLine) -> Option<File<'c>> {
        let (program, _) = self.suite.program.as_ref()?;
        let beside = self.program.name.strip_suffix(program.as_str());
        let beside = beside.and_then(|folder| self.named(&format!("{folder}{}", plant.file)));
        beside.or_else(|| self.of_stem(&Name::new(stem_of(&plant.file)), Which::All))
    }

    /// The program that the scenarios are about.
    pub(crate) fn program(&self) -> &'c Context {
        self.program
    }
}

/// What a row names.
pub(crate) struct Named<'c> {
    /// The tag, and where its name is in the row's: without the file's name, member or index.
    pub(super) symbol: Symbol,
    pub(super) name: Range<usize>,
    /// The file that has the tag.
    pub(super) file: File<'c>,
    /// The scope in that file, and the tag's number there.
    scope: usize,
    tag: usize,
    /// All that has a name in the row's: where it is, and what.
    pub(crate) words: Vec<(Range<usize>, Symbol)>,
    /// The type; none if something is missing.
    pub(super) whole: Option<Type>,
    /// The file in which the names of that type were looked up.
    pub(super) type_file: File<'c>,
}

impl Named<'_> {
    pub(super) fn tag(&self) -> &TagFacts {
        &self.file.scopes[self.scope].tags[self.tag]
    }

    /// The type of the value; none of a whole that has parts.
    pub(super) fn ty(&self) -> Option<Scalar> {
        self.whole?.scalar()
    }

    /// What is named at a place of the row's name.
    pub(super) fn at(&self, place: usize) -> Option<(&Range<usize>, &Symbol)> {
        let mut words = self.words.iter().map(|(word, symbol)| (word, symbol));
        words.find(|(word, _)| (word.start..=word.end).contains(&place))
    }

    /// What the cells of a row name: values, and types before them.
    pub(super) fn in_cells(&self, row: &Row) -> Vec<(TextRange, Symbol)> {
        let Some(ty @ Scalar::Enum(_)) = self.ty() else {
            return Vec::new();
        };
        let Some(name) = declared_name(Type::Scalar(ty)) else {
            return Vec::new();
        };
        let Some(Symbol::Type { file, name }) = type_named(&self.type_file, &name) else {
            return Vec::new();
        };
        let mut found = Vec::new();
        for (cell, range) in &row.cells {
            let Cell::Value(text) = cell else { continue };
            let before = text.rfind('.').map_or(0, |point| point + 1);
            let value = &text[before..];
            if before > 0 {
                let ty = Symbol::Type {
                    file: Arc::clone(&file),
                    name: name.clone(),
                };
                found.push((within(*range, &(0..before - 1)), ty));
            }
            let part = Symbol::Part {
                file: Arc::clone(&file),
                ty: name.clone(),
                name: Name::new(value),
            };
            found.push((within(*range, &(before..text.len())), part));
        }
        found
    }
}

/// A part of a place.
pub(super) fn within(whole: TextRange, part: &Range<usize>) -> TextRange {
    let at = |place: usize| whole.start() + TextSize::new(place as u32);
    TextRange::new(at(part.start), at(part.end))
}

/// What a row's name is about. None for what is of SYS or PORT, or not there.
pub(super) fn named<'c>(files: Files<'c>, name: &str) -> Option<Named<'c>> {
    if name.starts_with('$') {
        return in_places(files, name);
    }
    let program = File::Known(files.program);
    if name.starts_with('%') {
        // An address has points in it.
        let known = |end: &usize| program.scopes.first()?.find(&Name::new(&name[..*end]));
        let ends = std::iter::once(name.len()).chain(name.rmatch_indices(['.', '[']).map(|(at, _)| at));
        let end = ends.into_iter().find(|end| known(end).is_some())?;
        return from_tag(files, program, 0, name, 0..end, Vec::new());
    }
    let first = word(name, 0);
    let key = Name::new(&name[first.clone()]);
    if program.scopes.first()?.find(&key).is_some() {
        return from_tag(files, program, 0, name, first, Vec::new());
    }
    // A global tag that only other files name.
    if let Some((exports, _)) = files.program.others.globals(&key).next() {
        let file = files.named(&exports.file)?;
        let scopes = 0..file.scopes.len();
        let scope = scopes
            .into_iter()
            .find(|scope| file.scopes[*scope].find(&key).is_some())?;
        return from_tag(files, file, scope, name, first, Vec::new());
    }
    if !name[first.end..].starts_with('.') {
        return None;
    }
    let second = word(name, first.end + 1);
    let file = files.with_stem(&key, &Name::new(&name[second.clone()]))?;
    let found = from_tag(files, file, 0, name, second, Vec::new())?;
    // What is the same in all files goes by its name alone.
    matches!(found.symbol, Symbol::Tag { .. }).then_some(found)
}

/// A tag in the body of a block at one of its places: `$Outer#1.$Ramp#2.level`.
fn in_places<'c>(files: Files<'c>, name: &str) -> Option<Named<'c>> {
    let (mut file, mut at) = (File::Known(files.program), 0);
    let mut words = Vec::new();
    let mut scope = 0;
    while name[at..].starts_with('$') {
        let end = at + name[at..].find('.')?;
        let block = at..at + name[at..end].find('#')?;
        let key = Name::new(&name[block.clone()]);
        (file, scope) = files.body(&file, &key)?;
        let of = Arc::clone(&file.name);
        words.push((block, Symbol::Block { file: of, name: key }));
        at = end + 1;
    }
    from_tag(files, file, scope, name, word(name, at), words)
}

/// What a path names that begins with a tag of a scope.
fn from_tag<'c>(
    files: Files<'c>,
    file: File<'c>,
    scope: usize,
    text: &str,
    first: Range<usize>,
    mut words: Vec<(Range<usize>, Symbol)>,
) -> Option<Named<'c>> {
    let key = Name::new(&text[first.clone()]);
    let tag = file.scopes.get(scope)?.find(&key)?;
    let symbol = tag_of(&file, scope, &key)?;
    words.push((first.clone(), symbol.clone()));
    let mut seen_from = file.clone();
    let mut reached = file.shared(&file.scopes[scope].tags[tag]).ty.map(Reached::new);
    for step in steps(text, first.end) {
        reached = match (step, reached) {
            (Some(Step::Index(indices)), Some(before)) => before.indexed(indices),
            (Some(Step::Member(word)), Some(before)) => before.whole().and_then(|ty| {
                let (file, ty) = after_member(files, &seen_from, ty, text, word, &mut words)?;
                seen_from = file;
                Some(Reached::new(ty))
            }),
            _ => None,
        };
    }
    Some(Named {
        symbol,
        name: first,
        file,
        scope,
        tag,
        words,
        whole: reached.and_then(Reached::whole),
        type_file: seen_from,
    })
}

/// Where a member leads: its type, and the file that knows the names in that.
fn after_member<'c>(
    files: Files<'c>,
    file: &File<'c>,
    ty: Type,
    text: &str,
    word: Range<usize>,
    words: &mut Vec<(Range<usize>, Symbol)>,
) -> Option<(File<'c>, Type)> {
    let member = &text[word.clone()];
    let Type::Compound(id) = ty else {
        return Some((file.clone(), member_type(file, ty, member)?));
    };
    let Some(block) = id.block() else {
        words.extend(member_of(file, ty, member).map(|symbol| (word, symbol)));
        return Some((file.clone(), member_type(file, ty, member)?));
    };
    // A scenario sees all tags of a block, those that are its own too.
    let (home, scope) = files.body(file, &Name::new(&block))?;
    let symbol = member_of(&home, ty, member)?;
    let scope = &home.scopes[scope];
    let ty = home.shared(&scope.tags[scope.find(&Name::new(member))?]).ty?;
    words.push((word, symbol));
    Some((home, ty))
}

/// What a program calls a file that it uses: its name without folders and ending.
pub(super) fn stem_of(file: &str) -> &str {
    let name = file.rsplit('/').next().unwrap_or(file);
    name.rsplit_once('.').map_or(name, |(stem, _)| stem)
}

/// The type of the values of a row.
pub(super) fn value_type(scenarios: &Scenarios<'_>, name: &str) -> Option<Scalar> {
    let files = Files::of(scenarios)?;
    let (first, member) = name.split_once('.').unwrap_or((name, ""));
    let (first, member) = (first.trim(), member.trim());
    if first.eq_ignore_ascii_case("SYS") {
        return Some(SystemTag::from_name(member)?.ty());
    }
    if first.eq_ignore_ascii_case("PORT") {
        let serial = member.eq_ignore_ascii_case("SERIAL");
        return Some(if serial {
            Scalar::String(u16::MAX)
        } else {
            Scalar::Lint
        });
    }
    named(files, name)?.ty()
}

/// The word of a row's name that begins `from` bytes after its start, without member and index.
fn word(name: &str, from: usize) -> Range<usize> {
    let rest = &name[from..];
    let end = rest
        .find(|c: char| c.is_whitespace() || matches!(c, '.' | '['))
        .unwrap_or(rest.len());
    from..from + end
}

/// Places of a symbol in one row, or in one name of a property.
pub(crate) struct Found<'s> {
    pub(crate) naming: Naming<'s>,
    /// Those in the name.
    pub(crate) in_name: Vec<TextRange>,
    /// Those in the row's cells.
    pub(crate) in_cells: Vec<TextRange>,
}

/// Where a name is that of a symbol.
fn found_in<'s>(naming: Naming<'s>, named: &Named<'_>, symbol: &Symbol) -> Found<'s> {
    let words = named.words.iter().filter(|(_, it)| it == symbol);
    let cells = naming.row.map_or(Vec::new(), |row| named.in_cells(row));
    let cells = cells.into_iter().filter(|(_, it)| it == symbol);
    Found {
        naming,
        in_name: words.map(|(word, _)| within(naming.range, word)).collect(),
        in_cells: cells.map(|(range, _)| range).collect(),
    }
}

/// The rows and properties that name a symbol.
fn names_in<'s>(suite: &'s Suite, files: Files<'_>, symbol: &Symbol) -> Vec<Found<'s>> {
    let found = namings(suite).into_iter().filter_map(|naming| {
        let named = named(files, naming.text)?;
        Some(found_in(naming, &named, symbol))
    });
    found.collect()
}

/// The files of which a file of scenarios can name something, for one who asks about `own`, a file that the workspace does not
/// show. None: its program is not there.
pub(crate) fn with_files<T>(
    file: &ScenarioFile,
    own: &Context,
    workspace: &dyn Workspace,
    ask: impl FnOnce(Files<'_>) -> T,
) -> Option<T> {
    let program = file.program.as_ref()?;
    let other;
    let program = if own.is_called(program) {
        own
    } else {
        other = workspace.file(program)?;
        &other
    };
    Some(ask(Files {
        program,
        own,
        suite: &file.suite,
        workspace,
    }))
}

/// Shows each name in a file of scenarios, with what it names, to one who asks about `own`, a file that the workspace does not
/// show. Nothing of a file that has none of these names.
pub(crate) fn each_name<'s>(
    file: &'s ScenarioFile,
    names: &[&Name],
    own: &Context,
    workspace: &dyn Workspace,
    look: &mut dyn FnMut(Naming<'s>, &Named<'_>),
) {
    // To know a program takes time.
    if !names.iter().any(|name| mentions(&file.text, name)) {
        return;
    }
    with_files(file, own, workspace, |files| {
        for naming in namings(&file.suite) {
            if let Some(named) = named(files, naming.text) {
                look(naming, &named);
            }
        }
    });
}

/// The rows and properties of a file of scenarios that name a symbol, for one who asks about `own`.
pub(crate) fn naming<'s>(
    file: &'s ScenarioFile,
    symbol: &Symbol,
    own: &Context,
    workspace: &dyn Workspace,
) -> Vec<Found<'s>> {
    let is_named_outside = matches!(
        symbol,
        Symbol::Tag { .. }
            | Symbol::Global(_)
            | Symbol::Address(_)
            | Symbol::Block { .. }
            | Symbol::Type { .. }
            | Symbol::Part { .. }
    );
    let mut found = Vec::new();
    if let Some(name) = symbol.name().filter(|_| is_named_outside) {
        let mut look = |naming: Naming<'s>, named: &Named<'_>| found.push(found_in(naming, named, symbol));
        each_name(file, &[name], own, workspace, &mut look);
    }
    found
}

/// Where a file of scenarios names a symbol, in the order of its text.
pub(crate) fn places(
    symbol: &Symbol,
    file: &ScenarioFile,
    own: &Context,
    workspace: &dyn Workspace,
) -> Vec<(TextRange, Usage)> {
    of_names(naming(file, symbol, own, workspace))
}

/// The same of a file with what is known of it.
pub(super) fn places_in(suite: &Suite, files: Files<'_>, symbol: &Symbol) -> Vec<(TextRange, Usage)> {
    of_names(names_in(suite, files, symbol))
}

fn of_names(names: Vec<Found<'_>>) -> Vec<(TextRange, Usage)> {
    let of_name = |found: Found<'_>| {
        let usage = found.naming.usage();
        let names = found.in_name.into_iter().map(move |range| (range, usage));
        names.chain(found.in_cells.into_iter().map(|range| (range, Usage::Mention)))
    };
    names.into_iter().flat_map(of_name).collect()
}

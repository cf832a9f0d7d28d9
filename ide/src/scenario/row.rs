//! The tag of a row: `run`, `warmup.ET`, `list[3]`; a tag of a file that the program only uses with the file's name before
//! it, `library.count`.

use super::file::Scenarios;
use crate::neighbour::{ScenarioFile, Which, first_that};
use crate::symbol::{Symbol, Usage, tag_of};
use ladder_analysis::context::Context;
use ladder_analysis::names::scope::TagFacts;
use ladder_analysis::program::SystemTag;
use ladder_analysis::state_member;
use ladder_analysis::values::types::{Scalar, Type};
use ladder_simulator::scenario::{Direction, Row};
use ladder_syntax::{Name, TextRange, TextSize};
use std::ops::{Deref, Range};
use std::sync::Arc;

/// What a row names.
pub(super) struct Named<'c> {
    pub(super) symbol: Symbol,
    /// The file that has the tag.
    pub(super) file: File<'c>,
    /// Its number in the scope of that file.
    tag: usize,
    /// The tag's name in the row's, without the file's name, member or index.
    pub(super) name: Range<usize>,
}

impl Named<'_> {
    pub(super) fn tag(&self) -> &TagFacts {
        &self.file.scopes[0].tags[self.tag]
    }

    /// Where the tag's name is in a row.
    pub(super) fn range(&self, row: &Row) -> TextRange {
        let at = |place: usize| row.range.start() + TextSize::new(place as u32);
        TextRange::new(at(self.name.start), at(self.name.end))
    }
}

/// A file whose tags a row can name.
pub(super) enum File<'c> {
    /// The program that the scenarios are about.
    Program(&'c Context),
    /// One that the program may use.
    Other(Arc<Context>),
}

impl Deref for File<'_> {
    type Target = Context;

    fn deref(&self) -> &Context {
        match self {
            File::Program(program) => program,
            File::Other(file) => file,
        }
    }
}

/// The tag that a row's name is about. None for one of SYS or PORT, or one that is not there.
pub(super) fn named<'c>(scenarios: &Scenarios<'c>, name: &str) -> Option<Named<'c>> {
    let program = scenarios.program?;
    let first = word(name, 0);
    let key = Name::new(&name[first.clone()]);
    if let Some(tag) = program.scopes.first()?.find(&key) {
        return Some(Named {
            symbol: tag_of(program, 0, &key)?,
            file: File::Program(program),
            tag,
            name: first,
        });
    }
    if !name[first.end..].starts_with('.') {
        return None;
    }
    let word = word(name, first.end + 1);
    let (stem, key) = (key, Name::new(&name[word.clone()]));
    let which = Which::Mentioning(std::slice::from_ref(&key));
    let is_it = |file: &Context| Name::new(stem_of(&file.name)) == stem;
    let file = first_that(scenarios.workspace, which, is_it)?;
    let tag = file.scopes.first()?.find(&key)?;
    let symbol = tag_of(&file, 0, &key)?;
    // What is the same in all files goes by its name alone.
    matches!(symbol, Symbol::Tag { .. }).then_some(Named {
        symbol,
        file: File::Other(file),
        tag,
        name: word,
    })
}

/// What a program calls a file that it uses: its name without folders and ending.
pub(super) fn stem_of(file: &str) -> &str {
    let name = file.rsplit('/').next().unwrap_or(file);
    name.rsplit_once('.').map_or(name, |(stem, _)| stem)
}

/// The type of the values of a row.
pub(super) fn value_type(scenarios: &Scenarios<'_>, name: &str) -> Option<Scalar> {
    scenarios.program?;
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
    let named = named(scenarios, name)?;
    let file = &named.file;
    let rest = name[named.name.end..].trim();
    let member = rest.strip_prefix('.').map(str::trim);
    match (file.shared(named.tag()).ty?, member) {
        (Type::Scalar(ty), None) if rest.is_empty() => Some(ty),
        (Type::Scalar(_), Some(_)) => Some(Scalar::Bool),
        (Type::State(state), Some(member)) => Some(state_member(state, member)?.ty(file.profile.semantics())),
        (Type::Array { element, .. }, None) => Some(element),
        _ => None,
    }
}

/// Where a row names a symbol of the program of this name.
pub(crate) fn name_in(row: &Row, symbol: &Symbol, program: &str) -> Option<TextRange> {
    let old = symbol.name()?;
    let here = |from: usize| {
        let word = word(&row.name, from);
        let range = TextRange::at(
            row.range.start() + TextSize::new(from as u32),
            TextSize::of(&row.name[word.clone()]),
        );
        (Name::new(&row.name[word]) == *old).then_some(range)
    };
    match symbol {
        Symbol::Tag { file, .. } if **file != *program => {
            let stem = stem_of(file);
            let prefix = row.name.get(..stem.len())?;
            let is_prefix = Name::new(prefix) == Name::new(stem) && row.name[stem.len()..].starts_with('.');
            is_prefix.then(|| here(stem.len() + 1)).flatten()
        }
        _ => here(0),
    }
}

/// The word of a row's name that begins `from` bytes after its start, without member and index.
fn word(name: &str, from: usize) -> Range<usize> {
    let rest = &name[from..];
    let end = rest
        .find(|c: char| c.is_whitespace() || matches!(c, '.' | '['))
        .unwrap_or(rest.len());
    from..from + end
}

/// Where a file of scenarios names a symbol, in the order of its text. `hides` says whether a program has a tag of its own
/// by the name of a global one.
pub(crate) fn places(
    symbol: &Symbol,
    file: &ScenarioFile,
    hides: &dyn Fn(&str) -> bool,
) -> Vec<(TextRange, Usage)> {
    let Some(program) = &file.program else {
        return Vec::new();
    };
    // Only a file's own tags and global ones have names outside.
    let is_shown = match symbol {
        Symbol::Tag { scope, .. } => *scope == 0,
        Symbol::Global(_) => !hides(program),
        Symbol::Address(_) => true,
        _ => false,
    };
    if !is_shown {
        return Vec::new();
    }
    let rows = file.suite.scenarios.iter().flat_map(|scenario| &scenario.rows);
    rows.filter_map(|row| Some((name_in(row, symbol, program)?, usage(row))))
        .collect()
}

/// What a row does with its tag.
pub(crate) const fn usage(row: &Row) -> Usage {
    match row.direction {
        Direction::Given => Usage::Write,
        Direction::Expected => Usage::Read,
    }
}

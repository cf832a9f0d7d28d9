//! The tag of a row: `run`, `warmup.ET`, `list[3]`; a tag of a file that the program only uses with the file's name before
//! it.

use super::Scenarios;
use super::navigate::usage;
use crate::neighbour::ScenarioFile;
use crate::symbol::{Symbol, Usage, tag_of};
use ladder_analysis::program::SystemTag;
use ladder_analysis::scope::TagFacts;
use ladder_analysis::state_member;
use ladder_analysis::types::{Scalar, Type};
use ladder_simulator::scenario::{Row, parse};
use ladder_syntax::{Name, TextRange, TextSize};

/// What a row names in the program.
pub(super) struct Named<'c> {
    pub(super) symbol: Symbol,
    pub(super) tag: &'c TagFacts,
    /// The tag's name in the row, without member or index.
    pub(super) range: TextRange,
}

/// The tag of the program that a row names. None for one of SYS, PORT or another file, or one that is not there.
pub(super) fn named<'c>(scenarios: &Scenarios<'c>, row: &Row) -> Option<Named<'c>> {
    let program = scenarios.program?;
    let range = word_of(row);
    let key = Name::new(&scenarios.text[range]);
    let tag = program.scopes.first()?.find(&key)?;
    Some(Named {
        symbol: tag_of(program, 0, &key)?,
        tag: &program.scopes[0].tags[tag],
        range,
    })
}

/// The type of the values of a row.
pub(super) fn value_type(scenarios: &Scenarios<'_>, name: &str) -> Option<Scalar> {
    let program = scenarios.program?;
    let (first, rest) = name.split_at(name.find(['.', '[']).unwrap_or(name.len()));
    let rest = rest.trim();
    let member = rest.strip_prefix('.').map(str::trim);
    if first.eq_ignore_ascii_case("SYS") {
        return Some(SystemTag::from_name(member?)?.ty());
    }
    if first.eq_ignore_ascii_case("PORT") {
        let serial = member?.eq_ignore_ascii_case("SERIAL");
        return Some(if serial {
            Scalar::String(u16::MAX)
        } else {
            Scalar::Lint
        });
    }
    let scope = program.scopes.first()?;
    let tag = &scope.tags[scope.find(&Name::new(first.trim()))?];
    match (program.shared(tag).ty?, member) {
        (Type::Scalar(ty), None) if rest.is_empty() => Some(ty),
        (Type::Scalar(_), Some(_)) => Some(Scalar::Bool),
        (Type::State(state), Some(member)) => Some(state_member(state, member)?.ty(program.profile.law())),
        (Type::Array { element, .. }, None) => Some(element),
        _ => None,
    }
}

/// Where a row names a symbol of the program of this name.
pub(crate) fn name_in(row: &Row, symbol: &Symbol, program: &str) -> Option<TextRange> {
    let old = symbol.name()?;
    let start = row.range.start();
    let here = |from: usize| {
        let range = word(&row.name, start, from);
        let name = &row.name[from..from + usize::from(range.len())];
        (Name::new(name) == *old).then_some(range)
    };
    match symbol {
        Symbol::Tag { file, .. } if **file != *program => {
            let stem = file.rsplit('/').next()?.trim_end_matches(".clad");
            let prefix = row.name.get(..stem.len())?;
            let is_prefix = Name::new(prefix) == Name::new(stem) && row.name[stem.len()..].starts_with('.');
            is_prefix.then(|| here(stem.len() + 1)).flatten()
        }
        _ => here(0),
    }
}

/// Where the tag of a row is, without member and index.
pub(super) fn word_of(row: &Row) -> TextRange {
    word(&row.name, row.range.start(), 0)
}

/// The word of a row's name that begins `from` bytes behind its start, without member and index.
fn word(name: &str, start: TextSize, from: usize) -> TextRange {
    let rest = &name[from..];
    let end = rest
        .find(|c: char| c.is_whitespace() || matches!(c, '.' | '['))
        .unwrap_or(rest.len());
    TextRange::at(start + TextSize::new(from as u32), TextSize::new(end as u32))
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
    let suite = parse(&file.text);
    let rows = suite.scenarios.iter().flat_map(|scenario| &scenario.rows);
    rows.filter_map(|row| Some((name_in(row, symbol, program)?, usage(row))))
        .collect()
}

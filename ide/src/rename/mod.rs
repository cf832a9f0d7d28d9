//! Renaming: a thing gets another name at all its places, in all files of the workspace, and the drawings around them
//! are laid out in the same edit.
//!
//! A name that would make the program another one is refused with the reason: one that is not a name, one that something
//! else has (here, or in a file that would then mean that), and one that changes the type of an undeclared tag.

mod clash;
mod from_scenarios;
mod labels;
mod layout;
mod scenarios;
mod spelling;

pub use from_scenarios::{prepare_scenario_rename, rename_in_scenario};
pub(crate) use scenarios::in_columns;

use crate::body::file_text;
use crate::neighbour::Workspace;
use crate::outline::text_of;
use crate::symbol::{Found, Occurrence, Symbol, find, in_files_of, occurrences};
use ladder_analysis::context::Context;
use ladder_analysis::library;
use ladder_analysis::names::scope::Origin;
use ladder_analysis::with_article;
use ladder_analysis::{AnalyzeOptions, context};
use ladder_format::{Edit, Options, apply};
use ladder_syntax::{Name, TextRange, TextSize, parse};
use std::sync::Arc;

/// What would be renamed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Renamable {
    /// The name at the cursor.
    pub range: TextRange,
    /// As it is written there.
    pub name: String,
}

/// Why something cannot be renamed, or not in this way.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RenameRefused(pub String);

impl std::fmt::Display for RenameRefused {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.0)
    }
}

/// The edits of one file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Renamed {
    /// The file.
    pub file: Arc<str>,
    /// Sorted, none touching another, none where nothing changes.
    pub edits: Vec<Edit>,
}

/// What is at an offset and can be renamed. None: nothing has a name there.
///
/// # Errors
/// It has a name that is not the program's to choose.
pub fn prepare_rename(context: &Context, offset: TextSize) -> Result<Option<Renamable>, RenameRefused> {
    let own = context;
    let Some(Found { symbol, range }) = find(own, offset) else {
        return Ok(None);
    };
    fixed(own, &symbol)?;
    no_address(context, range)?;
    Ok(Some(Renamable {
        range,
        name: text_of(&context.parse, range),
    }))
}

/// The edits that give what is at an offset another name. `options` are those that the workspace's drawings are
/// laid out with.
///
/// # Errors
/// The name is refused.
pub fn rename(
    context: &Context,
    offset: TextSize,
    new: &str,
    workspace: &dyn Workspace,
    options: &Options,
) -> Result<Vec<Renamed>, RenameRefused> {
    let own = context;
    let Some(Found { symbol, range }) = find(own, offset) else {
        return Err(no_name());
    };
    no_address(context, range)?;
    rename_symbol(context, &symbol, new, workspace, options)
}

/// Nothing has a name there.
fn no_name() -> RenameRefused {
    RenameRefused("there is nothing to rename here".to_owned())
}

/// The edits that give a symbol of a file another name.
fn rename_symbol(
    context: &Context,
    symbol: &Symbol,
    new: &str,
    workspace: &dyn Workspace,
    options: &Options,
) -> Result<Vec<Renamed>, RenameRefused> {
    let own = context;
    fixed(own, symbol)?;
    let new = spelling::checked(own, symbol, new)?;
    // All places of all that must go by one name.
    let symbols = labels::of_one_name(own, symbol, workspace);
    let key = Name::new(&new);
    let is_other = symbol.name() != Some(&key);
    if is_other {
        for symbol in &symbols {
            clash::check(context, symbol, &key, &new, workspace)?;
        }
    }
    let in_file = |file: &Context| {
        if is_other {
            clash::where_used(file, symbol, &key, &new)?;
        }
        renamed_in(file, symbol, &symbols, &new, options)
    };
    let mut renamed: Vec<Renamed> = in_file(own)?.into_iter().collect();
    for file in in_files_of(own, &symbols, workspace, in_file) {
        renamed.extend(file?);
    }
    renamed.extend(scenarios::renamed(own, symbol, &new, workspace)?);
    Ok(renamed)
}

/// The edits of one file, if there are any: all of `symbols` get the name that is given to `symbol`, one of them.
fn renamed_in(
    file: &Context,
    symbol: &Symbol,
    symbols: &[Symbol],
    new: &str,
    options: &Options,
) -> Result<Option<Renamed>, RenameRefused> {
    let mut places: Vec<Occurrence> = symbols
        .iter()
        .flat_map(|symbol| occurrences(file, symbol))
        .collect();
    places.sort_by_key(|place| place.range.start());
    places.dedup_by_key(|place| place.range);
    if places.is_empty() {
        return Ok(None);
    }
    let text = file_text(&file.parse);
    let edits = places.into_iter().map(|place| Edit {
        range: place.range,
        text: new.to_owned(),
    });
    // What is written so already stays, and so does the tag's address where that is written in its stead.
    let edits: Vec<Edit> = edits
        .filter(|edit| {
            let written = &text[edit.range];
            written != edit.text && !written.starts_with('%')
        })
        .collect();
    if edits.is_empty() {
        return Ok(None);
    }
    same_type(file, symbol, &text, &edits, new)?;
    Ok(Some(Renamed {
        file: Arc::clone(&file.name),
        edits: layout::laid_out(&file.parse, &text, &edits, options),
    }))
}

/// Names that are not the program's to choose.
fn fixed(file: &Context, symbol: &Symbol) -> Result<(), RenameRefused> {
    if symbol.file().is_some_and(|file| library::source(file).is_some()) {
        return Err(RenameRefused(
            "the blocks of the library and their operands keep their names".to_owned(),
        ));
    }
    let why = match symbol {
        Symbol::Tag { scope, name, .. } => {
            let tags = &file.scopes.get(*scope).filter(|_| *scope > 0);
            let implicit = tags.is_some_and(|scope| {
                scope
                    .find(name)
                    .is_some_and(|tag| scope.tags[tag].origin == Origin::Implicit)
            });
            if !implicit {
                return Ok(());
            }
            "EN and ENO belong to every block: they keep their names".to_owned()
        }
        Symbol::Global(_)
        | Symbol::Label { .. }
        | Symbol::Function { .. }
        | Symbol::Block { .. }
        | Symbol::Type { .. }
        | Symbol::Part { .. } => {
            return Ok(());
        }
        Symbol::Address(name) => return Err(is_address(name.as_str())),
        Symbol::Member { .. } => {
            "the members of a timer, counter or bistable, and the bits of a tag, keep their names".to_owned()
        }
        Symbol::System(_) => "the tags of SYS keep their names".to_owned(),
        Symbol::Instruction(_) => "instructions keep their names".to_owned(),
    };
    Err(RenameRefused(why))
}

/// A tag that is declared at an address has the name of its declaration, not the address.
fn no_address(context: &Context, range: TextRange) -> Result<(), RenameRefused> {
    let written = text_of(&context.parse, range);
    if written.starts_with('%') {
        return Err(is_address(&written));
    }
    Ok(())
}

/// A direct address is not a name that anyone chose.
fn is_address(written: &str) -> RenameRefused {
    RenameRefused(format!(
        "`{}` is a direct address: it says where the signal is. Declare a tag with AT to give it a name",
        written.to_uppercase()
    ))
}

/// The type of an undeclared tag may follow from its name, and must not become another one.
fn same_type(
    file: &Context,
    symbol: &Symbol,
    text: &str,
    edits: &[Edit],
    new: &str,
) -> Result<(), RenameRefused> {
    let Symbol::Tag { scope, name, .. } = symbol else {
        return Ok(());
    };
    let tag_in = |context: &Context, name: &Name| {
        let scope = context.scopes.get(*scope)?;
        Some(scope.tags[scope.find(name)?].clone())
    };
    let Some(before) = tag_in(file, name).filter(|tag| !tag.is_declared()) else {
        return Ok(());
    };
    let parsed = Arc::new(parse(&apply(text, edits)));
    let after = context(&parsed, AnalyzeOptions::new(&file.name).among(&file.others));
    let Some(after) = tag_in(&after, &Name::new(new)) else {
        return Ok(());
    };
    if (before.ty, before.role) == (after.ty, after.role) {
        return Ok(());
    }
    let what = |tag: &ladder_analysis::names::scope::TagFacts| {
        let ty = tag.ty.map(|ty| ty.to_string()).unwrap_or_default();
        let role = match tag.role {
            ladder_analysis::program::Role::Input => "input",
            ladder_analysis::program::Role::Output => "output",
            ladder_analysis::program::Role::Internal => "internal tag",
        };
        format!("{role} of type {ty}")
    };
    Err(RenameRefused(format!(
        "`{}` is not declared, and is {}; the name `{new}` would make it {}: declare it first",
        before.name,
        with_article(what(&before)),
        with_article(what(&after))
    )))
}

#[cfg(test)]
mod tests;

//! Names that something else has: after the renaming one of the two would mean the other.

use super::RenameRefused;
use crate::neighbour::{Which, Workspace, in_each};
use crate::symbol::types::in_declarations;
use crate::symbol::{Symbol, Usage, declared_names, occurrences, tag_of};
use ladder_analysis::context::Context;
use ladder_analysis::names::scope::{Origin, SectionKind};
use ladder_analysis::with_article;
use ladder_syntax::{Name, TextRange};
use std::sync::Arc;

/// Whether a symbol may get a new name, as far as the files say that have it already. Those that name the symbol are asked
/// one by one with [`where_used`].
pub(super) fn check(
    context: &Context,
    symbol: &Symbol,
    key: &Name,
    new: &str,
    workspace: &dyn Workspace,
) -> Result<(), RenameRefused> {
    match symbol {
        Symbol::Tag { file, scope, .. } => {
            in_file(context, file, workspace, |file| tag(file, *scope, key, new))
        }
        Symbol::Global(_) => in_all(context, key, workspace, |file| global(file, symbol, key, new)),
        Symbol::Label { file, body, .. } => in_file(context, file, workspace, |file| {
            let other = Symbol::Label {
                file: Arc::clone(&file.name),
                body: *body,
                name: key.clone(),
            };
            named(file, &other, new, "label", "jump")
        }),
        Symbol::Function { .. } => {
            let other = |file: &Context| Symbol::Function {
                file: Arc::clone(&file.name),
                name: key.clone(),
            };
            in_all(context, key, workspace, |file| {
                named(file, &other(file), new, "function", "call")
            })
        }
        Symbol::Block { .. } => {
            let other = |file: &Context| Symbol::Block {
                file: Arc::clone(&file.name),
                name: key.clone(),
            };
            in_all(context, key, workspace, |file| {
                named(file, &other(file), new, "user-defined block", "block")
            })
        }
        Symbol::Type { .. } => {
            let other = |file: &Context| Symbol::Type {
                file: Arc::clone(&file.name),
                name: key.clone(),
            };
            in_all(context, key, workspace, |file| {
                named(file, &other(file), new, "type", "declaration")
            })
        }
        Symbol::Part { file, ty, .. } => {
            let other = Symbol::Part {
                file: Arc::clone(file),
                ty: ty.clone(),
                name: key.clone(),
            };
            in_file(context, file, workspace, |file| {
                named(file, &other, new, "member", "place")
            })
        }
        Symbol::Address(_) | Symbol::Member { .. } | Symbol::System(_) | Symbol::Instruction(_) => Ok(()),
    }
}

fn in_file(
    context: &Context,
    name: &str,
    workspace: &dyn Workspace,
    check: impl FnOnce(&Context) -> Result<(), RenameRefused>,
) -> Result<(), RenameRefused> {
    let own = context;
    if own.is_called(name) {
        return check(own);
    }
    match workspace.file(name) {
        Some(neighbour) => check(&neighbour),
        None => Err(RenameRefused(format!(
            "{name}, which declares it, cannot be read: rename it there"
        ))),
    }
}

fn in_all(
    context: &Context,
    key: &Name,
    workspace: &dyn Workspace,
    check: impl Fn(&Context) -> Result<(), RenameRefused> + Sync,
) -> Result<(), RenameRefused> {
    check(context)?;
    let which = Which::Mentioning(std::slice::from_ref(key));
    in_each(workspace, which, check).into_iter().collect()
}

/// Whether a symbol may get a new name in a file that names it.
pub(super) fn where_used(
    file: &Context,
    symbol: &Symbol,
    key: &Name,
    new: &str,
) -> Result<(), RenameRefused> {
    match symbol {
        Symbol::Global(_) => global(file, symbol, key, new),
        // A tag of the name comes before a type, and before a value alone.
        Symbol::Type { .. } | Symbol::Part { .. } if may_be_a_tag(file, symbol) => {
            let tags = file
                .scopes
                .iter()
                .filter_map(|scope| Some(&scope.tags[scope.find(key)?]));
            match tags.into_iter().next() {
                Some(other) => {
                    let foreign = other.cold.foreign.as_deref();
                    Err(taken(file, foreign, new, file.place_of(other), "tag"))
                }
                None => Ok(()),
            }
        }
        _ => Ok(()),
    }
}

/// Whether a type or a part of one is named where a tag may be named too: a type in the networks, a value of an enumeration
/// everywhere but in its declaration, a member never, for it comes after a point.
fn may_be_a_tag(file: &Context, symbol: &Symbol) -> bool {
    let mut places = occurrences(file, symbol).into_iter();
    match symbol {
        Symbol::Part { ty, .. } => {
            file.types.enumeration(ty.as_str()).is_some()
                && places.any(|place| place.usage != Usage::Definition)
        }
        _ => {
            let declared = in_declarations(file);
            places.any(|place| !declared.iter().any(|(range, ..)| *range == place.range))
        }
    }
}

/// A tag of one file, or of one block's body.
fn tag(file: &Context, scope: usize, key: &Name, new: &str) -> Result<(), RenameRefused> {
    let context = file;
    if let Some(other) = context.scopes[scope].find(key) {
        let other = &context.scopes[scope].tags[other];
        return Err(taken(
            file,
            other.cold.foreign.as_deref(),
            new,
            file.place_of(other),
            "tag",
        ));
    }
    if scope > 0 {
        // A body's own tag may hide one of the workspace that the body does not name.
        return Ok(());
    }
    if let Some((exports, _)) = context.others.globals(key).next() {
        return Err(taken(file, Some(&exports.file), new, TextRange::default(), "tag"));
    }
    let mut globals = declared_names(context)
        .filter(|declared| declared.section == SectionKind::Global && declared.name == *key);
    match globals.next() {
        Some(global) => Err(taken(file, None, new, global.at, "tag")),
        None => Ok(()),
    }
}

/// A VAR_GLOBAL tag, as far as one file is concerned.
fn global(file: &Context, symbol: &Symbol, key: &Name, new: &str) -> Result<(), RenameRefused> {
    let Some(old) = symbol.name() else { return Ok(()) };
    for (number, scope) in file.scopes.iter().enumerate() {
        let Some(tag) = scope.find(key).map(|tag| &scope.tags[tag]) else {
            continue;
        };
        // A declared tag hides the global one; that is well where the global one is not named.
        let hides = tag.is_declared()
            && !matches!(
                tag.origin,
                Origin::Declared(SectionKind::Global | SectionKind::External)
            );
        if !hides || tag_of(file, number, old).as_ref() == Some(symbol) {
            return Err(taken(
                file,
                tag.cold.foreign.as_deref(),
                new,
                file.place_of(tag),
                "tag",
            ));
        }
    }
    Ok(())
}

/// Labels, functions, blocks: defined somewhere, or only named.
fn named(file: &Context, other: &Symbol, new: &str, what: &str, mention: &str) -> Result<(), RenameRefused> {
    let places = occurrences(file, other);
    let defined = places.iter().find(|place| place.usage == Usage::Definition);
    if let Some(place) = defined {
        return Err(taken(file, None, new, place.range, what));
    }
    match places.first() {
        Some(place) => Err(RenameRefused(format!(
            "the {mention} on {} names `{new}`, which is not there: it would mean this one",
            place_of(file, place.range)
        ))),
        None => Ok(()),
    }
}

fn taken(file: &Context, foreign: Option<&str>, new: &str, at: TextRange, what: &str) -> RenameRefused {
    let place = match foreign {
        Some(foreign) => format!("in {foreign}"),
        None => format!("on {}", place_of(file, at)),
    };
    RenameRefused(format!(
        "there is {} `{new}` {place} already: both would become one",
        with_article(what)
    ))
}

fn place_of(file: &Context, at: TextRange) -> String {
    format!("line {} of {}", file.line_number(at.start()), file.name)
}

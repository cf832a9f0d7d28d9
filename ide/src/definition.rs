//! Where a thing is defined, declared, what type it has and where it is done.
//!
//! | asked of | definition | declaration | type | implementation |
//! | --- | --- | --- | --- | --- |
//! | a tag | its declaration; of a VAR_EXTERNAL tag the VAR_GLOBAL line | the VAR_EXTERNAL line of this file, else as definition | its declared type, or the block whose state it is; of a timer or counter the block that it belongs to | the places that write it |
//! | an undeclared tag | the places that write it, else where it is first | as definition | | as definition |
//! | a direct address | the declaration with this address after AT, else as an undeclared tag | as definition | | the places that write it |
//! | a member of a structure | its declaration | as definition | as a tag | the places that write it |
//! | a value | its declaration | as definition | its enumeration | |
//! | a member of a timer or counter, or a bit | as its tag | as its tag | as its tag | as its tag |
//! | a parameter | its declaration in the block | as definition | | the places in the body that write it |
//! | a label | its `<LBL>` | as definition | | its `<LBL>` |
//! | a function | its `<FUN>` | as definition | | its networks |
//! | a user-defined block | its first line | as definition | its first line | its body |

use crate::body;
use crate::neighbour::{Workspace, named};
use crate::symbol::types::{symbol_of, type_of_part};
use crate::symbol::{Found, Occurrence, Symbol, Usage, declared_names, find, in_files_of, occurrences};
use crate::target::Target;
use ladder_analysis::context::{Body, Context};
use ladder_analysis::names::scope::{Origin, SectionKind};
use ladder_analysis::networks::network::Formal;
use ladder_instructions::Accepts;
use ladder_syntax::{Name, TextRange, TextSize};
use std::sync::Arc;

/// Where the thing at an offset is defined.
pub fn definition(context: &Context, offset: TextSize, workspace: &dyn Workspace) -> Vec<Target> {
    let Some(Found { symbol, .. }) = find(context, offset) else {
        return Vec::new();
    };
    defined(context, &symbol, workspace)
}

/// Where the thing at an offset is declared.
pub fn declaration(context: &Context, offset: TextSize, workspace: &dyn Workspace) -> Vec<Target> {
    let own = context;
    let Some(Found { symbol, .. }) = find(own, offset) else {
        return Vec::new();
    };
    let symbol = tag_after(symbol);
    let external = of_file(own, &symbol, |usage| usage == Usage::Declaration);
    if external.is_empty() {
        return defined(context, &symbol, workspace);
    }
    external
}

/// The type of the thing at an offset: a user-defined block's definition, or the block that a timer or counter
/// belongs to.
pub fn type_definition(context: &Context, offset: TextSize, workspace: &dyn Workspace) -> Vec<Target> {
    let own = context;
    let Some(Found { symbol, .. }) = find(own, offset) else {
        return Vec::new();
    };
    match tag_after(symbol) {
        symbol @ (Symbol::Block { .. } | Symbol::Type { .. }) => defined(context, &symbol, workspace),
        symbol @ (Symbol::Tag { .. } | Symbol::Global(_) | Symbol::Part { .. }) => {
            match type_of(context, &symbol, workspace) {
                Some(ty) => defined(context, &ty, workspace),
                None => each_file(context, &symbol, workspace, |file| states(file, &symbol)),
            }
        }
        _ => Vec::new(),
    }
}

/// The declared type of a tag or part, or of its elements.
fn type_of(context: &Context, symbol: &Symbol, workspace: &dyn Workspace) -> Option<Symbol> {
    let in_file = |file: &Context| match symbol {
        Symbol::Part { ty, name, .. } => symbol_of(file, type_of_part(file, ty, name)?),
        _ => {
            let scope = match symbol {
                Symbol::Tag { scope, .. } => *scope,
                _ => 0,
            };
            let scope = file.scopes.get(scope)?;
            symbol_of(file, scope.tags[scope.find(symbol.name()?)?].ty?)
        }
    };
    match symbol.file().filter(|of| !context.is_called(of)) {
        Some(of) => in_file(&*named(workspace, of)?),
        None => in_file(context),
    }
}

/// Where the thing at an offset is done: a function's networks, a block's body, the places that write a tag.
pub fn implementation(context: &Context, offset: TextSize, workspace: &dyn Workspace) -> Vec<Target> {
    let Some(Found { symbol, .. }) = find(context, offset) else {
        return Vec::new();
    };
    let symbol = tag_after(symbol);
    match &symbol {
        Symbol::Function { .. } | Symbol::Block { .. } | Symbol::Label { .. } => {
            defined(context, &symbol, workspace)
                .into_iter()
                .map(|target| Target {
                    focus: body_of(context, &symbol, &target, workspace).unwrap_or(target.focus),
                    ..target
                })
                .collect()
        }
        _ => each_file(context, &symbol, workspace, |file| {
            of_file(file, &symbol, Usage::writes)
        }),
    }
}

/// A member leads to its tag.
fn tag_after(symbol: Symbol) -> Symbol {
    match symbol {
        Symbol::Member { of, .. } => *of,
        other => other,
    }
}

pub(crate) fn defined(context: &Context, symbol: &Symbol, workspace: &dyn Workspace) -> Vec<Target> {
    let symbol = &tag_after(symbol.clone());
    if matches!(symbol, Symbol::Instruction(_) | Symbol::System(_)) {
        return Vec::new();
    }
    let found = each_file(context, symbol, workspace, |file| {
        of_file(file, symbol, |usage| usage == Usage::Definition)
    });
    if !found.is_empty() {
        return found;
    }
    if let Symbol::Address(address) = symbol {
        let declared = at_address(context, address);
        if !declared.is_empty() {
            return declared;
        }
    }
    if !matches!(
        symbol,
        Symbol::Tag { .. } | Symbol::Address(_) | Symbol::Global(_)
    ) {
        return Vec::new();
    }
    let written = each_file(context, symbol, workspace, |file| {
        of_file(file, symbol, Usage::writes)
    });
    if !written.is_empty() {
        return written;
    }
    let mut all = of_file(context, symbol, |_| true);
    all.truncate(1);
    all
}

fn each_file(
    context: &Context,
    symbol: &Symbol,
    workspace: &dyn Workspace,
    give: impl Fn(&Context) -> Vec<Target> + Sync,
) -> Vec<Target> {
    let mut targets = give(context);
    let others = in_files_of(context, std::slice::from_ref(symbol), workspace, give);
    targets.extend(others.into_iter().flatten());
    targets
}

fn of_file(file: &Context, symbol: &Symbol, fits: impl Fn(Usage) -> bool) -> Vec<Target> {
    let places = occurrences(file, symbol);
    places
        .into_iter()
        .filter(|place| fits(place.usage))
        .map(|place| target(file, symbol, place))
        .collect()
}

fn target(file: &Context, symbol: &Symbol, place: Occurrence) -> Target {
    let range = place
        .usage
        .declares()
        .then(|| surroundings(file, symbol, place.range));
    Target {
        file: Arc::clone(&file.name),
        range: range.flatten().unwrap_or(place.range),
        focus: place.range,
    }
}

/// All that belongs to a definition whose name is in a range.
fn surroundings(context: &Context, symbol: &Symbol, at: TextRange) -> Option<TextRange> {
    match symbol {
        Symbol::Function { .. } => {
            let function = context.functions.iter().position(|it| it.at == at)?;
            body::extent(context, Body::Function(function))
        }
        Symbol::Block { .. } => {
            let definitions = &context.user_blocks[..context.own_blocks];
            let block = definitions.iter().position(|it| it.at.contains_range(at))?;
            body::extent(context, Body::Block(block))
        }
        Symbol::Label { .. } => {
            let label = context.labels.iter().find(|it| it.at == at)?;
            Some(body::without_line_end(
                context,
                context.networks.at(label.network).range,
            ))
        }
        _ => declared_names(context)
            .find(|declared| declared.at == at)
            .map(|it| it.declaration),
    }
}

/// The declarations of tags that lie at an address.
fn at_address(file: &Context, address: &Name) -> Vec<Target> {
    let tags = file.scopes.iter().flat_map(|scope| &scope.tags);
    tags.filter(|tag| tag.is_declared() && tag.origin != Origin::Declared(SectionKind::External))
        .filter(|tag| {
            tag.cold
                .address
                .as_ref()
                .is_some_and(|it| Name::new(it) == *address)
        })
        .map(|tag| Target {
            file: Arc::clone(&file.name),
            range: file.place_of(tag),
            focus: file.place_of(tag),
        })
        .collect()
}

/// The blocks that keep their state on a tag.
fn states(file: &Context, symbol: &Symbol) -> Vec<Target> {
    let mut targets = Vec::new();
    let places = occurrences(file, symbol);
    for network in &file.networks {
        for block in network.blocks() {
            for (operand, formal) in block.facts.operands.iter().zip(block.formals.iter()) {
                let at = block.absolute(operand.value.range);
                let keeps =
                    matches!(formal, Formal::Operand(row) if matches!(row.accepts, Accepts::State(_)));
                if keeps && places.iter().any(|place| place.range == at) {
                    targets.push(Target {
                        file: Arc::clone(&file.name),
                        range: block.range(),
                        focus: block.head_range(),
                    });
                }
            }
        }
    }
    targets
}

/// Where the body of a definition is.
fn body_of(
    context: &Context,
    symbol: &Symbol,
    target: &Target,
    workspace: &dyn Workspace,
) -> Option<TextRange> {
    let own = context;
    let neighbour;
    let file = if own.is_called(&target.file) {
        own
    } else {
        neighbour = named(workspace, &target.file)?;
        &neighbour
    };
    let context = file;
    match symbol {
        Symbol::Function { .. } => {
            let function = context.functions.iter().position(|it| it.at == target.focus)?;
            body::networks(context, Body::Function(function))
        }
        Symbol::Block { .. } => {
            let definitions = &context.user_blocks[..context.own_blocks];
            let block = definitions
                .iter()
                .position(|it| it.at.contains_range(target.focus))?;
            body::networks(context, Body::Block(block))
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests;

//! From an offset to the symbol that is named there.

use super::occurrences::{block_file, block_name, function_file, label_name, member_name, operand_name};
use super::{DeclaredName, Symbol, declared, types};
use crate::locate::{node_at, on_rung};
use ladder_analysis::context::Context;
use ladder_analysis::names::scope::{Origin, SectionKind};
use ladder_analysis::networks::BlockAt;
use ladder_analysis::networks::network::{Formal, Meaning};
use ladder_analysis::written::facts::{Node, NodeKind};
use ladder_instructions::{Accepts, Shape, lookup};
use ladder_syntax::wiring::PartKind;
use ladder_syntax::{LineKind, Name, SyntaxKind, TextRange, TextSize};
use std::sync::Arc;

/// A symbol where it was found.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Found {
    pub(crate) symbol: Symbol,
    /// The word that names it.
    pub(crate) range: TextRange,
}

/// What is named at an offset; a cursor right after a word counts.
pub(crate) fn find(file: &Context, offset: TextSize) -> Option<Found> {
    let parse = &file.parse;
    let line = parse.line_at(offset)?;
    match parse.lines()[line].kind {
        LineKind::Rung => part_on_a_rung(file, offset).or_else(|| on_a_rung(file, offset)),
        LineKind::SectionHeader
        | LineKind::SectionEnd
        | LineKind::Declaration
        | LineKind::StructHeader
        | LineKind::StructEnd => declared_at(file, line, offset)
            .or_else(|| type_at(file, line, offset))
            .or_else(|| among(types::in_declarations(file), offset)),
        LineKind::BlockHeader => {
            let blocks = file.user_blocks[..file.own_blocks].iter();
            let definitions = file.parse.frame().blocks.iter();
            let (block, _) = blocks.zip(definitions).find(|(_, it)| it.lines.start == line)?;
            let range = block_name(file, block.at)?;
            let symbol = Symbol::Block {
                file: Arc::clone(&file.name),
                name: block.key.clone(),
            };
            range
                .contains_inclusive(offset)
                .then_some(Found { symbol, range })
        }
        _ => None,
    }
}

/// The part of a declared type that is named at an offset.
fn among(places: Vec<types::Place>, offset: TextSize) -> Option<Found> {
    let found = places
        .into_iter()
        .find(|(range, ..)| range.contains_inclusive(offset));
    found.map(|(range, symbol, _)| Found { symbol, range })
}

fn part_on_a_rung(file: &Context, offset: TextSize) -> Option<Found> {
    let place = on_rung(file, offset)?;
    let block = place.block?;
    among(
        types::in_block(file, file.networks.at(place.network), block),
        offset,
    )
}

/// The symbol of a tag of a scope, by its name there.
pub(crate) fn tag_of(file: &Context, scope: usize, name: &Name) -> Option<Symbol> {
    let scopes = &file.scopes;
    let mut entry = (scope, scopes[scope].find(name)?);
    while let Some(alias_of) = file.alias_of(&scopes[entry.0].tags[entry.1]) {
        entry = alias_of;
    }
    let tag = &scopes[entry.0].tags[entry.1];
    let name = Name::new(&tag.name);
    Some(match tag.origin {
        Origin::Declared(SectionKind::Global | SectionKind::External) => Symbol::Global(name),
        _ if tag.cold.foreign.is_some() => Symbol::Global(name),
        Origin::Form if tag.cold.address.is_some() => Symbol::Address(name),
        _ => Symbol::Tag {
            file: Arc::clone(&file.name),
            scope: entry.0,
            name,
        },
    })
}

fn on_a_rung(file: &Context, offset: TextSize) -> Option<Found> {
    let context = file;
    let place = on_rung(context, offset)?;
    if place.drawn.kind != PartKind::Block {
        return None;
    }
    let block = place.block?;
    let within = offset.checked_sub(block.base)?;
    if let Some(index) = (block.facts.operands.iter()).position(|it| it.range.contains_inclusive(within)) {
        return in_operand(file, place.network, block, index, within);
    }
    if !block.facts.head_range.contains_inclusive(within) {
        return None;
    }
    if let Some(name) = block.user_name() {
        let range = block_name(context, block.head_range())?;
        let name = Name::new(name);
        let file = block_file(file, &name).unwrap_or_else(|| Arc::clone(&file.name));
        return Some(Found {
            symbol: Symbol::Block { file, name },
            range,
        });
    }
    Some(Found {
        symbol: Symbol::Instruction(block.op()?),
        range: block.head_range(),
    })
}

fn in_operand(
    file: &Context,
    network: usize,
    block: BlockAt<'_>,
    index: usize,
    within: TextSize,
) -> Option<Found> {
    let context = file;
    let operand = &block.facts.operands[index];
    let formal = block.formals.get(index).copied();
    if let Some(word) = operand.name()
        && word.range.contains_inclusive(within)
    {
        let (Some(Formal::Parameter(parameter)), Meaning::User(user)) = (formal, block.meaning) else {
            return None;
        };
        return Some(Found {
            symbol: operand_name(file, user, parameter)?,
            range: block.absolute(word.range),
        });
    }
    let node = node_at(&operand.value, within)?;
    let found = |symbol, range| {
        Some(Found {
            symbol,
            range: block.absolute(range),
        })
    };
    if let (NodeKind::Name(name), Some(Formal::Operand(row))) = (&node.kind, formal) {
        let whole = node.range == operand.value.range;
        let name = Name::new(name);
        match row.accepts {
            Accepts::Label if whole => {
                return found(label_name(file, network, name), node.range);
            }
            Accepts::Function if whole => {
                let file = function_file(file, &name).unwrap_or_else(|| Arc::clone(&file.name));
                return found(Symbol::Function { file, name }, node.range);
            }
            Accepts::SearchOperator if whole => return None,
            _ => {}
        }
    }
    let scope = context.networks.at(network).scope;
    match &node.kind {
        NodeKind::Name(name) | NodeKind::Address(name) => {
            found(tag_of(file, scope, &Name::new(name))?, node.range)
        }
        NodeKind::Member(base, word) => {
            if is_system(base) {
                return found(Symbol::System(Name::new(&word.text)), node.range);
            }
            let of = Box::new(tag_of(file, scope, &Name::new(tag_of_node(base)?.0))?);
            let name = member_name(&word.text);
            found(Symbol::Member { of, name }, word.range)
        }
        _ => None,
    }
}

/// The tag that an expression with members and indices is about, and where its name is.
pub(super) fn tag_of_node(node: &Node) -> Option<(&str, TextRange)> {
    match &node.kind {
        NodeKind::Name(name) | NodeKind::Address(name) => Some((name, node.range)),
        NodeKind::Member(base, _) | NodeKind::Index(base, _) | NodeKind::Range(base, ..) => tag_of_node(base),
        _ => None,
    }
}

pub(super) fn is_system(node: &Node) -> bool {
    matches!(&node.kind, NodeKind::Name(name) if name.eq_ignore_ascii_case("SYS"))
}

fn declared_at(file: &Context, line: usize, offset: TextSize) -> Option<Found> {
    let DeclaredName { name, scope, at, .. } = section_names(file, line)
        .into_iter()
        .find(|declared| declared.at.contains_inclusive(offset))?;
    Some(Found {
        symbol: tag_of(file, scope, &name)?,
        range: at,
    })
}

fn section_names(context: &Context, line: usize) -> Vec<DeclaredName> {
    let sections = &context.parse.frame().sections;
    let section = sections.partition_point(|section| section.lines.end <= line);
    match sections.get(section) {
        Some(it) if it.lines.contains(&line) => declared::names_of(context, section),
        _ => Vec::new(),
    }
}

/// The instruction that a declared type keeps the state of.
fn type_at(file: &Context, line: usize, offset: TextSize) -> Option<Found> {
    let parse = &file.parse;
    let start = parse.line_start(line);
    let token = parse.lines()[line]
        .syntax()
        .token_at_offset(offset - start)
        .find(|token| token.kind() == SyntaxKind::KEYWORD)?;
    let row = lookup(Shape::Logical, token.text()).next()?;
    let keeps_state = row
        .operands
        .iter()
        .any(|operand| matches!(operand.accepts, Accepts::State(_)));
    keeps_state.then(|| Found {
        symbol: Symbol::Instruction(row.op),
        range: token.text_range() + start,
    })
}

//! Hover on a declared type, a member or a value: the type with its layout.

use super::user_block::block_named;
use super::{Hover, user_block_card};
use crate::markdown;
use crate::symbol::{Found, Symbol, find};
use ladder_analysis::context::Context;
use ladder_analysis::values::compound::Compound;
use ladder_analysis::values::types::{Scalar, Type};
use ladder_syntax::{LineKind, Name, TextRange, TextSize};
use std::fmt::Write;

/// So many members or values are shown.
const MOST: usize = 40;

pub(super) fn hover(context: &Context, offset: TextSize) -> Option<Hover> {
    let Found { symbol, range } = find(context, offset)?;
    let markdown = match &symbol {
        Symbol::Type { name, .. } => card(context, name)?,
        Symbol::Part { ty, name, .. } => {
            let what = part(context, ty, name)?;
            format!("{what}\n\n---\n\n{}", card(context, ty)?)
        }
        Symbol::Block { name, .. } if is_type(context, range) => {
            user_block_card(context, &block_named(context, name)?)
        }
        _ => return None,
    };
    Some(Hover { range, markdown })
}

/// Whether a place is not on a rung: there the block itself says more.
fn is_type(context: &Context, range: TextRange) -> bool {
    let line = context.parse.line_at(range.start());
    line.is_some_and(|line| context.parse.lines()[line].kind == LineKind::Declaration)
}

/// An input or output of a block by the tag of its state.
pub(super) fn of_instance(context: &Context, block: &str, member: &str) -> Option<String> {
    let facts = block_named(context, &Name::new(block))?;
    let key = Name::new(member);
    let parameter = facts.parameters.iter().find(|parameter| parameter.key == key)?;
    let ty = parameter.ty.map(|ty| ty.to_string()).unwrap_or_default();
    Some(format!(
        "```clad\n{}.{} : {ty}\n```\n\n---\n\n{}",
        facts.name,
        parameter.name,
        user_block_card(context, &facts)
    ))
}

/// A member with its type, or a value with its number.
fn part(context: &Context, ty: &Name, name: &Name) -> Option<String> {
    let declared = context.types.find(ty.as_str())?;
    let line = match declared.ty? {
        Type::Scalar(Scalar::Enum(id)) => {
            let enumeration = id.get();
            let (value, number) = enumeration
                .values
                .iter()
                .find(|(value, _)| Name::new(value) == *name)?;
            format!("{}.{value} = {number}", enumeration.name)
        }
        Type::Compound(id) => id.with(|ty| match ty {
            Compound::Structure(structure) => {
                let (_, member) = structure.member(name.as_str())?;
                Some(format!("{}.{} : {}", structure.name, member.name, member.ty))
            }
            _ => None,
        })?,
        _ => return None,
    };
    Some(format!("```clad\n{line}\n```"))
}

/// A type as it is declared, and how many values it holds.
fn card(context: &Context, name: &Name) -> Option<String> {
    let found = context.types.find(name.as_str())?;
    let ty = found.ty?;
    let name = &found.declaration.name;
    let mut text = String::new();
    match ty {
        Type::Scalar(Scalar::Enum(id)) => {
            let enumeration = id.get();
            let values = enumeration.values.iter().take(MOST);
            let values: Vec<String> = values
                .map(|(name, number)| format!("{name} := {number}"))
                .collect();
            let more = if enumeration.values.len() > MOST {
                ", .."
            } else {
                ""
            };
            let _ = write!(text, "{name} : ({}{more})", values.join(", "));
        }
        Type::Compound(id) => match id.get() {
            Compound::Structure(structure) => {
                let _ = writeln!(text, "{name} : STRUCT");
                for member in structure.members.iter().take(MOST) {
                    let _ = writeln!(text, "    {} : {};", member.name, member.ty);
                }
                if structure.members.len() > MOST {
                    text.push_str("    ..\n");
                }
                text.push_str("END_STRUCT");
            }
            _ => {
                let _ = write!(text, "{name} : {ty}");
            }
        },
        _ => {
            let _ = write!(text, "{name} : {ty}");
        }
    }
    let place = match &found.file {
        Some(file) => format!("Type, declared in {}", markdown::code(file)),
        None => "Type, declared in this file".to_owned(),
    };
    let size = match ty {
        Type::Compound(id) if id.values() > 1 => format!("; {} values", id.values()),
        _ => String::new(),
    };
    Some(format!("```clad\n{text}\n```\n{place}{size}"))
}

//! Paths as they are typed: `cell[2].zone[k].valve`, perhaps not finished.

use crate::wanted::tag_of;
use ladder_analysis::context::Context;
use ladder_analysis::state_member;
use ladder_analysis::values::compound::Compound;
use ladder_analysis::values::types::{Scalar, Type};

/// The type of what a path means. None: it means nothing, or an array of which some indices are missing.
pub(crate) fn type_of(context: &Context, scope: usize, text: &str) -> Option<Type> {
    let end = text.find(['[', '.']).unwrap_or(text.len());
    let (root, mut rest) = text.split_at(end);
    let mut ty = tag_of(context, scope, root.trim())?.ty?;
    let mut given = 0;
    while !rest.trim_start().is_empty() {
        rest = rest.trim_start();
        if let Some(inside) = rest.strip_prefix('[') {
            let (commas, end) = index_end(inside)?;
            for _ in 0..=commas {
                let (dimensions, element) = ty.array()?;
                given += 1;
                if given == dimensions.len() {
                    (ty, given) = (element, 0);
                }
            }
            rest = &inside[end + 1..];
        } else {
            let after = rest.strip_prefix('.').filter(|_| given == 0)?.trim_start();
            let end = after.find(['[', '.']).unwrap_or(after.len());
            let (member, more) = after.split_at(end);
            ty = member_type(context, ty, member.trim())?;
            rest = more;
        }
    }
    (given == 0).then_some(ty)
}

/// The type of a member.
fn member_type(context: &Context, ty: Type, member: &str) -> Option<Type> {
    match ty {
        Type::Scalar(scalar) => {
            (scalar.is_integer() || scalar.is_bits()).then_some(Type::Scalar(Scalar::Bool))
        }
        Type::State(state) => {
            let member = state_member(state, member)?;
            Some(Type::Scalar(member.ty(context.profile.semantics())))
        }
        Type::Compound(id) => id.with(|ty| match ty {
            Compound::Structure(structure) => structure.member(member).map(|(_, member)| member.ty),
            _ => None,
        }),
        Type::Array { .. } => None,
    }
}

/// How many commas are between the brackets of an index, and where the closing one is.
fn index_end(text: &str) -> Option<(usize, usize)> {
    let (mut open, mut commas) = (0u32, 0);
    for (at, byte) in text.bytes().enumerate() {
        match byte {
            b'[' | b'(' => open += 1,
            b']' if open == 0 => return Some((commas, at)),
            b']' | b')' => open = open.saturating_sub(1),
            b',' if open == 0 => commas += 1,
            _ => {}
        }
    }
    None
}

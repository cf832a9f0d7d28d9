//! The type of a path such as `cell[2].zone[k].valve.open`, from the type of the tag that it begins with.

use super::infer::member;
use crate::networks::facts::{Node, NodeKind};
use crate::values::compound::Compound;
use crate::values::types::Type;
use ladder_instructions::Semantics;

/// The type of a path, and how many indices are given of it if it is an array. `root` knows the types of tags.
pub(crate) fn path_type(
    node: &Node,
    semantics: &Semantics,
    root: &mut impl FnMut(&Node) -> Option<Type>,
) -> Option<(Type, usize)> {
    match &node.kind {
        NodeKind::Name(_) | NodeKind::Address(_) => Some((root(node)?, 0)),
        NodeKind::Paren(inner) => path_type(inner, semantics, root),
        NodeKind::Index(base, _) => {
            let (ty, given) = path_type(base, semantics, root)?;
            let (dimensions, element) = ty.array()?;
            Some(if given + 1 == dimensions.len() {
                (element, 0)
            } else {
                (ty, given + 1)
            })
        }
        NodeKind::Range(base, ..) => Some((path_type(base, semantics, root)?.0.array()?.1, 0)),
        NodeKind::Member(base, word) => {
            let (ty, given) = path_type(base, semantics, root)?;
            match ty {
                _ if given > 0 => None,
                Type::State(state) => {
                    let member = member(state, &word.text)?;
                    Some((Type::Scalar(member.ty(semantics)), 0))
                }
                Type::Scalar(_) => Some((Type::BOOL, 0)),
                Type::Compound(id) => id.with(|ty| match ty {
                    Compound::Structure(structure) => {
                        structure.member(&word.text).map(|(_, member)| (member.ty, 0))
                    }
                    _ => None,
                }),
                Type::Array { .. } => None,
            }
        }
        _ => None,
    }
}

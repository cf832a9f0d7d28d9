//! The type of a path such as `cell[2].zone[k].valve.open`, from the type of the tag that it begins with.

use super::infer::member;
use super::operand_value::each_tag_path;
use crate::names::context::Context;
use crate::networks::BlockAt;
use crate::networks::network::{Formal, Meaning};
use crate::program::ParameterKind;
use crate::values::compound::{Compound, EnumId};
use crate::values::types::{Scalar, Type};
use crate::written::facts::{Node, NodeKind, Word};
use crate::written::user_block::Parameter;
use ladder_instructions::Semantics;
use ladder_syntax::Name;

/// What a path begins with, or goes through, that only its file knows.
pub(crate) trait Roots {
    /// The type of the tag that a node names.
    fn tag(&mut self, node: &Node) -> Option<Type>;

    /// The type of a parameter of a user-defined block.
    fn parameter(&mut self, block: &str, name: &str) -> Option<Type>;
}

/// Where no path goes through the state of a user-defined block.
impl<F: FnMut(&Node) -> Option<Type>> Roots for F {
    fn tag(&mut self, node: &Node) -> Option<Type> {
        self(node)
    }

    fn parameter(&mut self, _: &str, _: &str) -> Option<Type> {
        None
    }
}

/// The tags of a scope of a file, and the blocks that it knows.
pub(crate) struct InScope<'c, F> {
    pub(crate) context: &'c Context,
    pub(crate) tag: F,
}

impl<F: FnMut(&Node) -> Option<Type>> Roots for InScope<'_, F> {
    fn tag(&mut self, node: &Node) -> Option<Type> {
        (self.tag)(node)
    }

    fn parameter(&mut self, block: &str, name: &str) -> Option<Type> {
        self.context.block_parameter(block, name)?.ty
    }
}

/// The type of a path, and how many indices are given of it if it is an array.
pub(crate) fn path_type(node: &Node, semantics: &Semantics, root: &mut impl Roots) -> Option<(Type, usize)> {
    match &node.kind {
        NodeKind::Name(_) | NodeKind::Address(_) => Some((root.tag(node)?, 0)),
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
                    Compound::Block(block) => root.parameter(block, &word.text).map(|ty| (ty, 0)),
                    Compound::Array(_) => None,
                }),
                Type::Array { .. } => None,
            }
        }
        _ => None,
    }
}

impl Context {
    /// The type of a path in a scope. None: it means nothing, or an array of which some indices are missing.
    pub fn path_type(&self, scope: usize, node: &Node) -> Option<Type> {
        let tag = |root: &Node| {
            let tags = &self.scopes[scope];
            self.shared(&tags.tags[tags.find(&Name::new(root.name()?))?]).ty
        };
        let mut roots = InScope { context: self, tag };
        let found = path_type(node, self.profile.semantics(), &mut roots);
        found.filter(|(_, given)| *given == 0).map(|(ty, _)| ty)
    }

    /// The parameter of a user-defined block that others reach by the name of its state: `m1.running`.
    pub(crate) fn block_parameter(&self, block: &str, name: &str) -> Option<&Parameter> {
        let (block, name) = (Name::new(block), Name::new(name));
        let own = self.user_blocks.iter().find(|facts| facts.key == block);
        let facts = own.or_else(|| self.others.blocks(&block).next().map(|(_, block)| &block.facts))?;
        let parameter = facts.parameters.iter().find(|parameter| parameter.key == name);
        parameter.filter(|it| it.kind != ParameterKind::InOut)
    }

    /// The innermost step of a path that reaches into the state of a user-defined block: the path of that state, the block, and the
    /// word after it. `m1.speed.3` reaches into `m1`.
    pub(crate) fn into_instance(
        node: &Node,
        ty: impl Fn(&Node) -> Option<Type>,
    ) -> Option<(&Node, String, &Word)> {
        let mut at = node;
        loop {
            at = match &at.kind {
                NodeKind::Member(base, word) => {
                    if let Some(Type::Compound(id)) = ty(base)
                        && let Some(block) = id.block()
                    {
                        return Some((base, block.to_string(), word));
                    }
                    base
                }
                NodeKind::Index(base, _) | NodeKind::Range(base, ..) | NodeKind::Paren(base) => base,
                _ => return None,
            };
        }
    }

    /// The enumeration of whose values a name is one, where it is an operand of a block and no tag.
    pub fn value_in(&self, scope: usize, block: BlockAt<'_>, name: &str) -> Option<EnumId> {
        let key = Name::new(name);
        if self.scopes[scope].find(&key).is_some() || !self.types.has_value(&key) {
            return None;
        }
        let mut found = None;
        let mut offer = |ty: Option<Type>| {
            if let Some(Scalar::Enum(id)) = ty.and_then(Type::element_scalar)
                && id.get().number(name).is_some()
            {
                found.get_or_insert(id);
            }
        };
        for (operand, formal) in block.facts.operands.iter().zip(block.formals.iter()) {
            if let (Formal::Parameter(index), Meaning::User(user)) = (formal, block.meaning) {
                offer(self.user_blocks[user].parameters[*index].ty);
            }
            each_tag_path(&operand.value, &mut |path| offer(self.path_type(scope, path)));
        }
        found
    }

    /// The value of an enumeration that an operand of a block is, alone or with its type.
    pub(crate) fn value_of(
        &self,
        scope: usize,
        block: BlockAt<'_>,
        node: &Node,
    ) -> Option<(EnumId, smol_str::SmolStr)> {
        match &node.kind {
            NodeKind::Name(name) => Some((self.value_in(scope, block, name)?, name.clone())),
            NodeKind::Member(base, word) => {
                let name = base.name()?;
                let scope = &self.scopes[scope];
                let tag = scope.find(&Name::new(name)).map(|tag| &scope.tags[tag]);
                // A tag of the type's name comes first if it has members.
                let has_members = tag.is_some_and(|tag| !matches!(tag.ty, Some(Type::Scalar(_))));
                let id = self.types.enumeration(name).filter(|_| !has_members)?;
                Some((id, word.text.clone()))
            }
            _ => None,
        }
    }
}

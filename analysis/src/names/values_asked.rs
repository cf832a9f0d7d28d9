//! Which names in operands are values of enumerations, and no tags (LANGUAGE §4): `Phase.IDLE` where no tag has the name, and
//! `IDLE` alone where another operand of its block, or the parameter that it is given for, has the type.

use super::named_types::NamedTypes;
use super::operand_value::each_tag_path;
use super::path_type::path_type;
use super::scope::{Origin, Scope, SectionKind};
use crate::networks::BlockAt;
use crate::networks::NetworkAt;
use crate::networks::named::{Named, spelling};
use crate::networks::network::{Formal, Meaning};
use crate::networks::use_kind::Extent;
use crate::other_files::others::Others;
use crate::values::types::{Scalar, Type};
use crate::written::facts::Node;
use crate::written::user_block::UserBlockFacts;
use ladder_instructions::Semantics;
use ladder_syntax::Name;

/// What is known when the names of operands are looked up.
pub(crate) struct Asking<'c> {
    pub(crate) scopes: &'c [Scope],
    pub(crate) types: &'c mut NamedTypes,
    pub(crate) others: &'c Others,
    pub(crate) user_blocks: &'c [UserBlockFacts],
    pub(crate) semantics: &'c Semantics,
}

impl Asking<'_> {
    /// Whether a name that no tag of its scope has means a value, or the type before one.
    pub(crate) fn is_value(&mut self, network: NetworkAt<'_>, named: &Named) -> bool {
        let name = spelling(network.facts(), named);
        if named.kind.extent() == Extent::Member {
            self.types.read(name);
            return self.types.enumeration(name).is_some() && self.root(network.scope, name).is_none();
        }
        if !self.types.has_value(&named.key) || self.root(network.scope, name).is_some() {
            return false;
        }
        let block = network.block(named.block as usize);
        self.asked(network.scope, block).into_iter().any(|ty| match ty {
            Scalar::Enum(id) => id.get().number(name).is_some(),
            _ => false,
        })
    }

    /// The types that the operands and parameters of a block have.
    fn asked(&mut self, scope: usize, block: BlockAt<'_>) -> Vec<Scalar> {
        let mut asked = Vec::new();
        let semantics = self.semantics;
        for (operand, formal) in block.facts.operands.iter().zip(block.formals.iter()) {
            if let (Formal::Parameter(index), Meaning::User(user)) = (formal, block.meaning)
                && let Some(Type::Scalar(ty)) = self.user_blocks[user].parameters[*index].ty
            {
                asked.push(ty);
            }
            each_tag_path(&operand.value, &mut |path| {
                let ty = path_type(path, semantics, &mut |root: &Node| self.root(scope, root.name()?));
                asked.extend(ty.and_then(|(ty, _)| ty.element_scalar()));
            });
        }
        asked
    }

    /// The declared type of a name: in its scope, as VAR_GLOBAL of the file, or in another file.
    fn root(&mut self, scope: usize, name: &str) -> Option<Type> {
        let key = Name::new(name);
        let own = self.scopes[scope]
            .find(&key)
            .map(|tag| &self.scopes[scope].tags[tag]);
        if let Some(own) = own
            && own.is_declared()
            && own.ty.is_some()
        {
            return own.ty;
        }
        let globals = self
            .scopes
            .iter()
            .filter_map(|scope| Some(&scope.tags[scope.find(&key)?]));
        let mut globals = globals.filter(|tag| tag.origin == Origin::Declared(SectionKind::Global));
        if let Some(global) = globals.next() {
            return global.ty;
        }
        let (file, global) = self.others.globals(&key).next()?;
        match &global.declared {
            Some(declared) => self.types.meaning_in(declared, &file.file).map(|(ty, _)| ty),
            None => global.ty,
        }
    }
}

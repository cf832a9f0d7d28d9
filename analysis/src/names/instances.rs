//! Which operands are the states of user-defined blocks, as far as declarations say.

use super::named_types::NamedTypes;
use super::path_type::path_type;
use super::scope::{Origin, Scope, SectionKind};
use crate::networks::known_blocks::Declarations;
use crate::other_files::others::Others;
use crate::values::types::Type;
use crate::written::facts::Node;
use crate::written::type_spec::Declared;
use ladder_instructions::Semantics;
use ladder_syntax::Name;
use std::sync::Arc;

/// The declared tags and types of a file.
pub(super) struct Instances<'s> {
    pub(super) scopes: &'s [Scope],
    pub(super) types: &'s mut NamedTypes,
    pub(super) others: &'s Others,
    pub(super) semantics: &'static Semantics,
    /// Whether a tag is, or holds, the state of a block.
    pub(super) any: bool,
}

impl Declarations for Instances<'_> {
    fn type_in(&mut self, declared: &Declared, file: &Arc<str>) -> Option<Type> {
        self.types.meaning_in(declared, file).map(|(ty, _)| ty)
    }

    fn is_instance(&mut self, scope: usize, node: &Node, block: &Name) -> bool {
        if !self.any {
            return false;
        }
        let (scopes, others) = (self.scopes, self.others);
        let types = &mut *self.types;
        let mut root = |node: &Node| {
            let key = Name::new(node.name()?);
            let own = scopes[scope].find(&key).map(|tag| &scopes[scope].tags[tag]);
            let global = || {
                let mut all = scopes
                    .iter()
                    .filter_map(|scope| Some(&scope.tags[scope.find(&key)?]));
                all.find(|tag| tag.origin == Origin::Declared(SectionKind::Global))
            };
            if let Some(tag) = own.or_else(global) {
                return tag.ty;
            }
            let (file, global) = others.globals(&key).next()?;
            let declared = global.declared.as_ref()?;
            types.meaning_in(declared, &file.file).map(|(ty, _)| ty)
        };
        match path_type(node, self.semantics, &mut root) {
            Some((Type::Compound(id), 0)) => id.block().is_some_and(|own| Name::new(&own) == *block),
            _ => false,
        }
    }
}

//! The limits of a path such as `valve.open`, from the declaration of the tag that it begins with.

use super::limits::{Limited, Said, element, limits, member, resolved};
use super::operand_value::tag;
use crate::names::context::Context;
use crate::written::facts::{Node, NodeKind};
use crate::written::type_spec::{SpecKind, TypeSpec};
use std::sync::Arc;

impl Context {
    /// The limits of what a path of a scope means.
    pub(crate) fn limits(&self, scope: usize, path: &Node) -> Option<Limited> {
        limits(&self.types, self.told(scope, path)?.0)
    }

    /// The limits that the declaration of a parameter says.
    pub(crate) fn limits_of<'c>(&'c self, spec: &'c TypeSpec, file: Option<&'c Arc<str>>) -> Option<Limited> {
        limits(&self.types, (spec, file))
    }

    /// What is reported of a path, and how many dimensions of an array are open in it.
    fn told<'c>(&'c self, scope: usize, path: &Node) -> Option<(Said<'c>, usize)> {
        let types = &self.types;
        match &path.kind {
            NodeKind::Name(name) => {
                let (_, facts) = tag(self, scope, name)?;
                let declared = facts.cold.declared.as_deref()?;
                Some(((&declared.spec, facts.cold.foreign.as_ref()), 0))
            }
            NodeKind::Paren(inner) => self.told(scope, inner),
            NodeKind::Member(base, word) => {
                let (told, open) = self.told(scope, base)?;
                (open == 0).then_some((member(types, told, &word.text)?, 0))
            }
            NodeKind::Index(base, _) => {
                let (told, open) = self.told(scope, base)?;
                let SpecKind::Array(dimensions, _) = &resolved(types, told)?.0.kind else {
                    return None;
                };
                if open + 1 < dimensions.len() {
                    return Some((told, open + 1));
                }
                Some((element(types, told)?, 0))
            }
            NodeKind::Range(base, ..) => Some((element(types, self.told(scope, base)?.0)?, 0)),
            _ => None,
        }
    }
}

//! Values of enumerations by name: `Phase.IDLE`, and `IDLE` alone where the place asks for the type.

use super::Resolver;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::excerpt;
use crate::program::Expr;
use crate::rules::{bad_operand, type_mismatch};
use crate::values::compound::EnumId;
use crate::values::types::{Scalar, Type};
use crate::values::value::Value;
use crate::written::facts::{Node, NodeKind};
use ladder_syntax::{Name, TextRange};

/// What a name says where a value may be meant.
pub(super) enum NamedValue {
    /// It is not a value of an enumeration.
    No,
    /// It should be one, and is none; that is reported.
    Wrong,
    Is(Expr),
}

impl Resolver<'_, '_> {
    /// The enumeration and the number of the value that a node names with its type, as in `Phase.IDLE`. A declared tag of that
    /// name comes first.
    pub(super) fn value_of_enumeration(&self, node: &Node) -> Option<(EnumId, Option<i32>)> {
        let NodeKind::Member(base, word) = &node.kind else {
            return None;
        };
        let NodeKind::Name(name) = &base.kind else {
            return None;
        };
        let is_member = self
            .scope
            .find(&Name::new(name))
            .is_some_and(|tag| match self.tag_type(tag) {
                Type::Scalar(_) => word.text.starts_with(|c: char| c.is_ascii_digit()),
                _ => self.part_type(node).is_some(),
            });
        if is_member {
            return None;
        }
        let id = self.context.types.enumeration(name)?;
        Some((id, id.get().number(&word.text)))
    }

    /// What is wrong with a tag in the place of a value of an enumeration that has the same name. A place in the file.
    pub(super) fn hidden_value(&self, at: TextRange, found: Scalar, asked: Scalar) -> Option<Diagnostic> {
        let Scalar::Enum(id) = asked else { return None };
        let name = excerpt::text(&self.context.parse, at);
        let (enumeration, key) = (id.get(), Name::new(&name));
        let mut values = enumeration.values.iter().map(|(value, _)| value);
        let value = values.find(|value| Name::new(value) == key)?;
        let value = (enumeration.name.as_str(), value.as_str());
        Some(type_mismatch::hidden_value(&name, found, value, at))
    }

    /// The value of an enumeration that a node names where one of this type is asked for, or with its type.
    pub(super) fn named_value(&mut self, node: &Node, asked: Option<Scalar>) -> NamedValue {
        if let NodeKind::Paren(inner) = &node.kind {
            return self.named_value(inner, asked);
        }
        let (id, number, name) = match (&node.kind, asked) {
            (NodeKind::Member(_, word), _) => match self.value_of_enumeration(node) {
                Some((id, number)) => (id, number, &word.text),
                None => return NamedValue::No,
            },
            (NodeKind::Name(name), Some(Scalar::Enum(id))) if self.scope.find(&Name::new(name)).is_none() => {
                (id, id.get().number(name), name)
            }
            _ => return NamedValue::No,
        };
        let Some(number) = number else {
            let found = bad_operand::no_value(&id.get(), name, self.at(node.range));
            self.report(found);
            return NamedValue::Wrong;
        };
        let value = Value::Int(i64::from(number));
        NamedValue::Is(self.constant_expr(value, Scalar::Enum(id), node.range))
    }
}

//! The values that variables begin with: where they are declared, or as statements of the first scan. Compilers that are built on matiec
//! take no values for the members of one structure, only those of its type, and no number that a REAL has no room for.

use super::Project;
use super::declare::Variable;
use crate::literal::is_in_reach;
use crate::names;
use crate::place::indices_of;
use ladder_analysis::program::{ParameterKind, Tag, TagId};
use ladder_analysis::values::compound::{Compound, MemberType};
use ladder_analysis::values::types::Type;
use ladder_analysis::values::value::Value;
use std::collections::HashMap;

/// The parts of a variable by their names, with `[]` for the indices.
type Parts<'p> = HashMap<&'p str, &'p Tag>;

/// A part of a variable.
struct Part {
    ty: Type,
    /// As the program calls it.
    path: String,
    /// Where it is in the arrays around it, with the length of each.
    place: Vec<(i64, i64)>,
    /// As it is written.
    text: String,
    /// What its type begins with.
    own: Option<Value>,
}

impl Project<'_> {
    /// What the declaration of a variable says that it begins with; none where that is its type's own, or what a caller passes.
    pub(crate) fn initial(&self, variable: &Variable<'_>) -> Option<String> {
        let parts = self.parts_of(variable)?;
        if !Self::is_declared_whole(variable.ty, &parts) {
            return None;
        }
        match variable.ty {
            Type::Scalar(scalar) => {
                let value = parts.get(variable.root)?.initial.first()?;
                (*value != Value::zero(scalar)).then(|| self.literal(value, scalar))
            }
            ty => self.values_at(ty, variable.root.to_owned(), &parts),
        }
    }

    /// The statements that give a variable of this name what its declaration does not.
    pub(crate) fn first_values(&self, variable: &Variable<'_>, name: &str) -> Vec<String> {
        let Some(parts) = self.parts_of(variable) else {
            return Vec::new();
        };
        let mut lines = Vec::new();
        if !Self::is_declared_whole(variable.ty, &parts) {
            let part = Part {
                ty: variable.ty,
                path: variable.root.to_owned(),
                place: Vec::new(),
                text: name.to_owned(),
                own: None,
            };
            self.assign(part, &parts, &mut lines);
        }
        lines
    }

    /// What the members of a type begin with, where that is a value.
    pub(super) fn of_type(&self, member: &MemberType) -> Option<String> {
        let Type::Scalar(scalar) = member.ty else {
            return None;
        };
        let value = member.initial.as_ref()?.first()?;
        (*value != Value::zero(scalar) && is_in_reach(value)).then(|| self.literal(value, scalar))
    }

    /// None for an in-out.
    fn parts_of<'s>(&'s self, variable: &Variable<'_>) -> Option<Parts<'s>> {
        let program = self.source.program;
        let parameters = (variable.tag.block).map_or(&[][..], |block| &program.blocks[block].parameters);
        let is_passed = |(tag, kind): &(TagId, ParameterKind)| {
            *kind == ParameterKind::InOut && self.root(*tag) == variable.root
        };
        if parameters.iter().any(is_passed) {
            return None;
        }
        let parts = self.tags.parts.get(&(variable.tag.block, variable.root));
        Some(
            parts
                .into_iter()
                .flatten()
                .map(|tag| (tag.name.as_str(), *tag))
                .collect(),
        )
    }

    /// Whether a declaration says all that a variable begins with: a value, or an array of values. What is built on matiec crashes
    /// on an array of names.
    fn is_declared_whole(ty: Type, parts: &Parts<'_>) -> bool {
        let is_of_values = match ty {
            Type::Scalar(_) => true,
            ty => ty.array().is_some_and(
                |(_, element)| matches!(element, Type::Scalar(scalar) if !scalar.is_enumeration()),
            ),
        };
        is_of_values && parts.values().all(|tag| tag.initial.iter().all(is_in_reach))
    }

    fn first_value<'v>(path: &str, parts: &Parts<'v>, place: &[(i64, i64)]) -> Option<&'v Value> {
        let tag = parts
            .get(path)
            .or_else(|| parts.get(path.trim_end_matches("[]")))?;
        let at = place.iter().fold(0, |at, (number, length)| at * length + number);
        tag.initial.get(usize::try_from(at).ok()?)
    }

    fn assign(&self, part: Part, parts: &Parts<'_>, lines: &mut Vec<String>) {
        let elements = |dimensions: &[(i64, i64)], element: Type, lines: &mut Vec<String>| {
            let count: i64 = dimensions.iter().map(|(first, last)| last - first + 1).product();
            let offset = if dimensions.len() == 1 { dimensions[0].0 } else { 0 };
            for number in 0..count {
                let mut place = part.place.clone();
                place.push((number, count));
                let element = Part {
                    ty: element,
                    path: part.path.clone() + &"[]".repeat(dimensions.len()),
                    place,
                    text: format!(
                        "{}[{}]",
                        part.text,
                        indices_of(number + offset, dimensions).join(", ")
                    ),
                    own: None,
                };
                self.assign(element, parts, lines);
            }
        };
        match part.ty {
            Type::Scalar(scalar) => {
                let Some(value) = Self::first_value(&part.path, parts, &part.place) else {
                    return;
                };
                let own = part.own.unwrap_or_else(|| Value::zero(scalar));
                if *value != own {
                    lines.push(format!("{} := {};", part.text, self.literal(value, scalar)));
                }
            }
            Type::State(_) => {}
            Type::Array { first, last, element } => elements(&[(first, last)], Type::Scalar(element), lines),
            Type::Compound(id) => match id.get() {
                Compound::Block(_) => {}
                Compound::Array(array) => elements(&array.dimensions, array.element, lines),
                Compound::Structure(structure) => {
                    for member in &structure.members {
                        let first = member.initial.as_ref().and_then(|values| values.first());
                        let inner = Part {
                            ty: member.ty,
                            path: format!("{}.{}", part.path, member.name),
                            place: part.place.clone(),
                            text: format!("{}.{}", part.text, names::member(&member.name)),
                            own: first.filter(|value| is_in_reach(value)).cloned(),
                        };
                        self.assign(inner, parts, lines);
                    }
                }
            },
        }
    }

    /// The values of an array as its declaration lists them.
    fn values_at(&self, ty: Type, path: String, parts: &Parts<'_>) -> Option<String> {
        let (dimensions, element) = ty.array()?;
        let Type::Scalar(scalar) = element else {
            return None;
        };
        let path = path + &"[]".repeat(dimensions.len());
        let count: i64 = dimensions.iter().map(|(first, last)| last - first + 1).product();
        let zero = Value::zero(scalar);
        let mut values: Vec<(&Value, i64)> = Vec::new();
        for number in 0..count {
            let value = Self::first_value(&path, parts, &[(number, count)]).unwrap_or(&zero);
            match values.last_mut() {
                Some((last, times)) if *last == value => *times += 1,
                _ => values.push((value, 1)),
            }
        }
        if values.iter().all(|(value, _)| **value == zero) {
            return None;
        }
        let texts = values.into_iter().map(|(value, times)| {
            let value = self.literal(value, scalar);
            if times == 1 {
                value
            } else {
                format!("{times}({value})")
            }
        });
        Some(format!("[{}]", texts.collect::<Vec<_>>().join(", ")))
    }
}

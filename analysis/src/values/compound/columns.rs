//! What a tag of a type with parts is made of: its columns, and the values that it starts with.

use super::{Compound, Dimensions};
use crate::values::types::Type;
use crate::values::value::Value;
use smol_str::SmolStr;

/// An elementary part of a tag with parts, for all indices of the arrays around it.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    /// Its path from the tag on, with `[]` for each index: `[].valve.open`.
    pub path: String,
    /// First and last index of each array around it, the outermost first.
    pub dimensions: Dimensions,
    /// A scalar, a state, or a user-defined block.
    pub ty: Type,
}

impl Column {
    /// How many there are of it.
    pub fn count(&self) -> u64 {
        count(&self.dimensions)
    }

    /// How many elements the longest array around it has; an array of arrays is one.
    pub fn longest_array(&self) -> u64 {
        let (mut longest, mut dimensions) = (0, &*self.dimensions);
        for part in self.path.split(|c| !matches!(c, '[' | ']')) {
            let (run, rest) = dimensions.split_at(part.len() / 2);
            longest = longest.max(if run.is_empty() { 0 } else { count(run) });
            dimensions = rest;
        }
        longest
    }
}

pub(super) fn count(dimensions: &[(i64, i64)]) -> u64 {
    dimensions.iter().fold(1u64, |all, (first, last)| {
        all.saturating_mul(last.abs_diff(*first) + 1)
    })
}

impl Type {
    /// How many columns a tag of the type has.
    pub fn columns(self) -> u32 {
        match self {
            Type::Compound(id) => id.known().columns,
            _ => 1,
        }
    }

    /// How many elementary values.
    pub(crate) fn value_count(self) -> u64 {
        match self {
            Type::Scalar(_) => 1,
            Type::State(_) => 0,
            Type::Array { first, last, .. } => last.abs_diff(first) + 1,
            Type::Compound(id) => id.known().values,
        }
    }

    pub(super) fn part_count(self) -> u64 {
        match self {
            Type::State(_) => 1,
            Type::Compound(id) => id.known().parts,
            other => other.value_count(),
        }
    }

    /// Whether a timer, counter, bistable or block keeps its state in it.
    pub fn keeps_state(self) -> bool {
        match self {
            Type::State(_) => true,
            Type::Compound(id) => id.keeps_state(),
            Type::Scalar(_) | Type::Array { .. } => false,
        }
    }

    /// The dimensions, and the type of an element, if it is an array.
    pub fn array(self) -> Option<(Dimensions, Type)> {
        match self {
            Type::Array { first, last, element } => Some((Box::new([(first, last)]), Type::Scalar(element))),
            Type::Compound(id) => id.with(|ty| match ty {
                Compound::Array(array) => Some((array.dimensions.clone(), array.element)),
                _ => None,
            }),
            _ => None,
        }
    }

    /// Its elementary parts, one for all indices of the arrays around it, in the order of their declaration.
    pub fn column_list(self) -> Vec<Column> {
        let mut columns = Vec::new();
        self.add_columns(&mut String::new(), &mut Vec::new(), &mut columns);
        columns
    }

    // A type nests no deeper than its declarations were read.
    fn add_columns(self, path: &mut String, dimensions: &mut Vec<(i64, i64)>, out: &mut Vec<Column>) {
        let (length, depth) = (path.len(), dimensions.len());
        match self.array() {
            Some((own, element)) => {
                path.push_str(&"[]".repeat(own.len()));
                dimensions.extend(&own);
                element.add_columns(path, dimensions, out);
            }
            None => match self {
                Type::Compound(id) if id.block().is_none() => {
                    if let Compound::Structure(structure) = id.get() {
                        for member in &structure.members {
                            path.push('.');
                            path.push_str(&member.name);
                            member.ty.add_columns(path, dimensions, out);
                            path.truncate(length);
                        }
                    }
                }
                ty => out.push(Column {
                    path: path.clone(),
                    dimensions: dimensions.as_slice().into(),
                    ty,
                }),
            },
        }
        path.truncate(length);
        dimensions.truncate(depth);
    }

    /// The user-defined blocks whose states are in it.
    pub fn blocks(self) -> Vec<SmolStr> {
        if !self.keeps_state() {
            return Vec::new();
        }
        let columns = self.column_list().into_iter();
        let blocks = columns.filter_map(|column| match column.ty {
            Type::Compound(id) => id.block(),
            _ => None,
        });
        blocks.collect()
    }

    /// The values that its elementary parts start with, unless a declaration says otherwise: element by element, member by
    /// member.
    pub fn initial_values(self) -> Vec<Value> {
        let mut values = Vec::new();
        self.add_initial(&mut values);
        values
    }

    fn add_initial(self, values: &mut Vec<Value>) {
        if let Some((dimensions, element)) = self.array() {
            let one = element.initial_values();
            for _ in 0..count(&dimensions) {
                values.extend_from_slice(&one);
            }
            return;
        }
        match self {
            Type::Scalar(scalar) => values.push(Value::zero(scalar)),
            Type::Compound(id) => {
                if let Compound::Structure(structure) = id.get() {
                    for member in &structure.members {
                        match &member.initial {
                            Some(initial) => values.extend_from_slice(initial),
                            None => member.ty.add_initial(values),
                        }
                    }
                }
            }
            Type::State(_) | Type::Array { .. } => {}
        }
    }

    /// The values of a column out of those of the whole, which are in the order of [`Type::initial_values`].
    pub(crate) fn column_values(self, column: usize, values: &[Value]) -> Vec<Value> {
        let mut picked = Vec::new();
        self.pick(column as u32, values, &mut picked);
        picked
    }

    fn pick(self, column: u32, values: &[Value], picked: &mut Vec<Value>) {
        if let Some((_, element)) = self.array() {
            let size = element.value_count() as usize;
            if size > 0 {
                for one in values.chunks_exact(size) {
                    element.pick(column, one, picked);
                }
            }
            return;
        }
        match self {
            Type::Scalar(_) => picked.extend(values.first().cloned()),
            Type::Compound(id) => {
                let Compound::Structure(structure) = id.get() else {
                    return;
                };
                let (mut before, mut at) = (0, 0);
                for member in &structure.members {
                    let (columns, size) = (member.ty.columns(), member.ty.value_count() as usize);
                    if column < before + columns {
                        member.ty.pick(column - before, &values[at..at + size], picked);
                        return;
                    }
                    before += columns;
                    at += size;
                }
            }
            Type::State(_) | Type::Array { .. } => {}
        }
    }

    /// Whether a whole value of one type can be another's: the same named type, or arrays of the same bounds and elements.
    pub fn is_copied_to(self, other: Type) -> bool {
        self == other && !self.keeps_state()
    }
}

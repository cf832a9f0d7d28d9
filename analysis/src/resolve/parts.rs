//! Tags that have parts, as the program has them: a tag for each column.

use super::tags::Named;
use crate::program::{ColumnOf, Disagreement, Program, Tag, TagId};
use crate::values::compound::Column;
use crate::values::types::{Scalar, Type};
use crate::values::value::Value;
use std::sync::Arc;

/// A program with more tags than this is refused: a few lines can declare millions of them.
const MOST_TAGS: usize = 1_000_000;

/// Adds the columns of a tag. Returns of each the tag that holds it; of what keeps a state that of its first element, which those
/// of the others follow.
pub(super) fn add(program: &mut Program, named: &Named<'_>, ty: Type) -> Vec<TagId> {
    let mut first = Vec::new();
    let name = named.name();
    let values = match named.tag.cold.initial.as_slice() {
        [] => ty.initial_values(),
        values => values.to_vec(),
    };
    for (number, column) in ty.column_list().into_iter().enumerate() {
        first.push(TagId(program.tags.len() as u32));
        let count = column.count();
        if program.tags.len() as u64 + count > MOST_TAGS as u64 && column.ty.scalar().is_none() {
            program.disagreement.get_or_insert(Disagreement {
                message: format!("the program has more than {MOST_TAGS} tags: make {name} smaller"),
                location: named.location,
            });
            program.tags.push(tag(named, String::new(), Type::BOOL));
            continue;
        }
        let mut part = tag(named, format!("{name}{}", column.path), column.ty);
        let of = |dimensions| {
            Some(Arc::new(ColumnOf {
                dimensions,
                longest_array: column.longest_array(),
                declared: (name.len(), ty),
                root: name.len(),
            }))
        };
        part.column = of(column.dimensions.clone());
        match column.ty {
            Type::Scalar(element) => {
                part.ty = stored_as(&column, element);
                part.initial = ty.column_values(number, &values);
                if part.initial.iter().all(is_zero) {
                    part.initial = Vec::new();
                }
                program.tags.push(part);
            }
            _ if column.dimensions.is_empty() => program.tags.push(part),
            _ => {
                let is_one = column.dimensions.len() == 1;
                let from = if is_one { column.dimensions[0].0 } else { 0 };
                for index in from..from + count as i64 {
                    let mut one = tag(named, part.element_name(index), column.ty);
                    one.column = of(Box::default());
                    program.tags.push(one);
                }
            }
        }
    }
    first
}

/// The type of the tag that holds a column of values.
fn stored_as(column: &Column, element: Scalar) -> Type {
    match *column.dimensions {
        [] => Type::Scalar(element),
        [(first, last)] => Type::Array { first, last, element },
        _ => Type::Array {
            first: 0,
            last: column.count() as i64 - 1,
            element,
        },
    }
}

fn tag(named: &Named<'_>, name: String, ty: Type) -> Tag {
    Tag {
        name,
        ty,
        role: named.tag.role,
        is_input: false,
        retain: named.tag.retain,
        constant: named.tag.constant,
        shared: named.is_shared(),
        initial: Vec::new(),
        column: None,
        address: None,
        block: named.block,
        location: named.location,
    }
}

/// The values at the start of a tag without an initial value; nothing for zero.
pub(super) fn own_values(ty: Type) -> Vec<Value> {
    let (element, count) = match ty {
        Type::Scalar(scalar) => (scalar, 1),
        Type::Array { first, last, element } => (element, last.abs_diff(first) + 1),
        Type::State(_) | Type::Compound(_) => return Vec::new(),
    };
    match Value::zero(element) {
        value if is_zero(&value) => Vec::new(),
        value => vec![value; count as usize],
    }
}

fn is_zero(value: &Value) -> bool {
    match value {
        Value::Bool(high) => !high,
        Value::Int(number) => *number == 0,
        Value::Real(number) => *number == 0.0 && number.is_sign_positive(),
        Value::Text(text) => text.is_empty(),
    }
}

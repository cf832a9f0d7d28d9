//! Ranges of a path: rows, whole arrays, and all that a part holds, as they are copied and passed.

use super::Resolver;
use super::path::{Part, element_state, linear, no_array, own_row};
use crate::program::{Argument, Expr, Place, RangeRef, TagId};
use crate::rules::{bad_operand, type_mismatch};
use crate::values::types::{Scalar, Type};
use crate::values::value::Value;
use crate::written::facts::{Node, NodeKind};

impl Resolver<'_, '_> {
    /// A range of an array that is a part, `g[1, 2..3]`, or with `open` also an element from which on it is meant; or the whole
    /// array, row by row.
    pub(super) fn part_range(&mut self, node: &Node, open: bool) -> Option<RangeRef> {
        let range = self.at(node.range);
        match &node.kind {
            NodeKind::Paren(inner) => self.part_range(inner, open),
            NodeKind::Range(base, first, last) => {
                let part = self.part(base)?;
                let (bounds, element) = self.row(base, &part)?;
                let first_expr = self.subscript(base, first, bounds)?;
                let last_expr = self.subscript(base, last, bounds)?;
                if let (Some(a), Some(b)) = (self.known_index(first), self.known_index(last))
                    && a > b
                {
                    let message = format!("the range ends at {b}, before it begins at {a}: swap them");
                    self.report(bad_operand::wrong(range, message));
                    return None;
                }
                let row = own_row(&part, &[(first_expr.clone(), bounds)], range);
                let at = |index: Expr| Box::new(linear(&part, &[(index, bounds)], range));
                let (first, last) = (at(first_expr), at(last_expr));
                Some(RangeRef {
                    tag: self.column_id(part.tag, part.column),
                    element,
                    first,
                    last: Some(last),
                    row,
                    per_index: 1,
                })
            }
            NodeKind::Index(base, index) if open => {
                let part = self.part(base)?;
                if part.array().is_some_and(|(left, _)| left.len() > 1) {
                    return self.whole_range(node);
                }
                let (bounds, element) = self.row(base, &part)?;
                let index = self.subscript(base, index, bounds)?;
                let more = [(index, bounds)];
                Some(RangeRef {
                    tag: self.column_id(part.tag, part.column),
                    element,
                    first: Box::new(linear(&part, &more, range)),
                    last: None,
                    row: own_row(&part, &more, range),
                    per_index: 1,
                })
            }
            NodeKind::Missing => None,
            _ => self.whole_range(node),
        }
    }

    /// The only dimension of an array that has no index, and the elementary type of its elements. Says so if it is another.
    fn row(&mut self, base: &Node, part: &Part) -> Option<((i64, i64), Scalar)> {
        let range = self.at(base.range);
        match part.array() {
            Some((left, Type::Scalar(element))) if left.len() == 1 => Some((left[0], element)),
            Some((left, _)) if left.len() > 1 => {
                let message = "a range is in the last dimension: write an index for each of the others";
                self.report(bad_operand::wrong(range, message));
                None
            }
            Some((_, element)) => {
                let message = format!("a range of {element} does not fit here: its elements are no values");
                self.report(type_mismatch::wrong(range, message));
                None
            }
            None => {
                self.report(no_array(part.ty, self.text_of(base), range));
                None
            }
        }
    }

    /// An array of values as a whole, row by row.
    fn whole_range(&mut self, node: &Node) -> Option<RangeRef> {
        let range = self.at(node.range);
        let part = self.part(node)?;
        let mut open = Vec::new();
        let mut ty = part.ty;
        let mut given = part.given;
        while let Some((dimensions, element)) = ty.array() {
            open.extend_from_slice(&dimensions[given..]);
            (ty, given) = (element, 0);
        }
        let Some(element) = ty.scalar().filter(|_| !open.is_empty()) else {
            let message = "a range of an array is expected here: a[1..9]";
            self.report(bad_operand::wrong(range, message));
            return None;
        };
        let end = |pick: fn(&(i64, i64)) -> i64| -> Vec<(Expr, (i64, i64))> {
            let index = |bounds: &(i64, i64)| {
                let index = self.constant_expr(Value::Int(pick(bounds)), Scalar::Lint, node.range);
                (index, *bounds)
            };
            open.iter().map(index).collect()
        };
        let (first, last) = (end(|bounds| bounds.0), end(|bounds| bounds.1));
        let row = own_row(&part, &first, range);
        let at = |indices: &[(Expr, (i64, i64))]| Box::new(linear(&part, indices, range));
        let (first, last) = (at(&first), at(&last));
        Some(RangeRef {
            tag: self.column_id(part.tag, part.column),
            element,
            first,
            last: Some(last),
            row,
            per_index: 1,
        })
    }

    /// A range of structures, `lines[2..3]`, or with `open` also an element from which on it is meant, or a whole array of them:
    /// the range of each of their elementary parts.
    pub(super) fn part_ranges(&mut self, node: &Node, open: bool) -> Option<Vec<Argument>> {
        let range = self.at(node.range);
        let (base, first, last) = match &node.kind {
            NodeKind::Paren(inner) => return self.part_ranges(inner, open),
            NodeKind::Range(base, first, last) => (base, first, Some(&**last)),
            NodeKind::Index(base, first)
                if open && self.part_type(node).is_some_and(|(ty, _)| ty.array().is_none()) =>
            {
                (base, first, None)
            }
            _ => {
                if self.part(node)?.ty.array().is_some() {
                    return self.copied_parts(node);
                }
                let message = "a range of an array is expected here: a[1..9]";
                self.report(bad_operand::wrong(range, message));
                return None;
            }
        };
        let part = self.part(base)?;
        let Some((left, element)) = part.array() else {
            self.report(no_array(part.ty, self.text_of(base), self.at(base.range)));
            return None;
        };
        let [bounds] = *left.as_slice() else {
            let message = "a range is in the last dimension: write an index for each of the others";
            self.report(bad_operand::wrong(self.at(base.range), message));
            return None;
        };
        let first = self.subscript(base, first, bounds)?;
        let last = match last {
            Some(last) => Some(self.subscript(base, last, bounds)?),
            None => None,
        };
        let mut ranges = Vec::new();
        for (number, column) in (0..).zip(element.column_list()) {
            let Type::Scalar(scalar) = column.ty else { continue };
            let end = |index: &Expr, pick: fn(&(i64, i64)) -> i64| -> Vec<(Expr, (i64, i64))> {
                let mut indices = vec![(index.clone(), bounds)];
                indices.extend(column.dimensions.iter().map(|bounds| {
                    let index = self.constant_expr(Value::Int(pick(bounds)), Scalar::Lint, node.range);
                    (index, *bounds)
                }));
                indices
            };
            let first = end(&first, |bounds| bounds.0);
            let last = last.as_ref().map(|last| end(last, |bounds| bounds.1));
            let at = |indices: &[(Expr, (i64, i64))]| Box::new(linear(&part, indices, range));
            ranges.push(Argument::Range(RangeRef {
                tag: TagId(0),
                element: scalar,
                first: at(&first),
                last: last.as_deref().map(at),
                row: own_row(&part, &first, range),
                per_index: column
                    .dimensions
                    .iter()
                    .map(|(first, last)| last - first + 1)
                    .product(),
            }));
            if let Some(Argument::Range(range)) = ranges.last_mut() {
                range.tag = self.column_id(part.tag, part.column + number);
            }
        }
        Some(ranges)
    }

    /// The elementary parts of what a node names, each as it is copied: values by their place, arrays by their range.
    pub(super) fn copied_parts(&mut self, node: &Node) -> Option<Vec<Argument>> {
        let range = self.at(node.range);
        let part = self.part(node)?;
        let mut arguments = Vec::new();
        let columns = match part.given {
            0 => part.ty.column_list(),
            given => {
                // What is left of an array of several dimensions.
                let mut columns = part.ty.column_list();
                for column in &mut columns {
                    column.dimensions = column.dimensions[given..].into();
                }
                columns
            }
        };
        for (number, column) in (0..).zip(columns) {
            let id = self.column_id(part.tag, part.column + number);
            let Type::Scalar(scalar) = column.ty else { continue };
            let end = |pick: fn(&(i64, i64)) -> i64| {
                let indices: Vec<(Expr, (i64, i64))> = column
                    .dimensions
                    .iter()
                    .map(|bounds| {
                        let index = self.constant_expr(Value::Int(pick(bounds)), Scalar::Lint, node.range);
                        (index, *bounds)
                    })
                    .collect();
                Box::new(linear(&part, &indices, range))
            };
            arguments.push(if !column.dimensions.is_empty() {
                Argument::Range(RangeRef {
                    tag: id,
                    element: scalar,
                    first: end(|bounds| bounds.0),
                    last: Some(end(|bounds| bounds.1)),
                    row: None,
                    per_index: 1,
                })
            } else if part.indices.is_empty() {
                Argument::Place(Place::Tag(id), scalar)
            } else {
                Argument::Place(Place::Element(id, end(|bounds| bounds.0)), scalar)
            });
        }
        Some(arguments)
    }

    /// The elementary values of what a node names, each by its place.
    pub(super) fn copied_values(&mut self, node: &Node) -> Option<Vec<Argument>> {
        let range = self.at(node.range);
        let part = self.part(node)?;
        let mut arguments = Vec::new();
        for (number, column) in (0..).zip(part.ty.column_list()) {
            let id = self.column_id(part.tag, part.column + number);
            let Type::Scalar(scalar) = column.ty else { continue };
            let mut index: Vec<i64> = column.dimensions.iter().map(|(first, _)| *first).collect();
            loop {
                let more: Vec<(Expr, (i64, i64))> = (index.iter().zip(&column.dimensions))
                    .map(|(n, bounds)| {
                        let n = self.constant_expr(Value::Int(*n), Scalar::Lint, node.range);
                        (n, *bounds)
                    })
                    .collect();
                let place = if part.indices.is_empty() && more.is_empty() {
                    Place::Tag(id)
                } else {
                    Place::Element(id, Box::new(linear(&part, &more, range)))
                };
                arguments.push(Argument::Place(place, scalar));
                if !next_index(&mut index, &column.dimensions) {
                    break;
                }
            }
        }
        Some(arguments)
    }

    /// What a node names as an in-out: values by their place, arrays by their range, and what keeps a state one by one.
    pub(super) fn referred_parts(&mut self, node: &Node) -> Option<Vec<Argument>> {
        let range = self.at(node.range);
        let part = self.part(node)?;
        let mut copied = self.copied_parts(node)?.into_iter();
        let mut arguments = Vec::new();
        for (number, column) in (0..).zip(part.ty.column_list()) {
            if column.ty.scalar().is_some() {
                arguments.extend(copied.next());
                continue;
            }
            let count = column.count() as i64;
            let id = self.column_id(part.tag, part.column + number);
            arguments.extend((0..count).map(|n| element_state(&part, id, (n, count), range)));
        }
        Some(arguments)
    }
}

/// Goes on to the next element, row by row. False after the last.
fn next_index(index: &mut [i64], dimensions: &[(i64, i64)]) -> bool {
    for (n, (first, last)) in index.iter_mut().zip(dimensions).rev() {
        if *n < *last {
            *n += 1;
            return true;
        }
        *n = *first;
    }
    false
}

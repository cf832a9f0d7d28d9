//! Paths: what `cell[2].zone[k].valve.open` means, from the type of the tag that it begins with.

use super::Resolver;
use crate::findings::article::with_article;
use crate::names::path_type::{InScope, path_type};
use crate::networks::facts::{Node, NodeKind, Word};
use crate::program::{Argument, Chosen, Expr, ExprKind, Place, RangeRef, Subscript, TagId};
use crate::rules::{bad_operand, type_mismatch, unknown_member};
use crate::values::compound::Compound;
use crate::values::types::{Scalar, Type};
use crate::values::value::Value;
use ladder_instructions::StateType;
use ladder_syntax::TextRange;

/// A part of a tag that has parts, or the whole tag.
#[derive(Debug, Clone)]
pub(super) struct Part {
    /// The scope's tag.
    tag: usize,
    pub(super) ty: Type,
    /// So many of the indices of `ty`, which is an array, are given.
    given: usize,
    /// The first of its columns among those of the tag.
    column: u32,
    /// The indices that are given, with the bounds of their dimensions.
    indices: Vec<(Expr, (i64, i64))>,
}

impl Part {
    /// The bounds of its dimensions that have no index, and the type of an element, if it is an array.
    fn array(&self) -> Option<(Vec<(i64, i64)>, Type)> {
        let (dimensions, element) = self.ty.array()?;
        Some((dimensions.get(self.given..)?.to_vec(), element))
    }

    /// Its elementary type, if it is a value.
    pub(super) fn scalar(&self) -> Option<Scalar> {
        self.ty.scalar()
    }
}

impl Resolver<'_, '_> {
    /// Whether a node is a tag that has parts, or begins with one.
    pub(super) fn is_in_parts(&self, node: &Node) -> bool {
        let mut root = node;
        loop {
            match &root.kind {
                NodeKind::Member(base, _)
                | NodeKind::Index(base, _)
                | NodeKind::Range(base, ..)
                | NodeKind::Paren(base) => root = base,
                NodeKind::Name(_) | NodeKind::Address(_) => {
                    let tag = self.named_tag(root);
                    return tag.is_some_and(|tag| matches!(self.tag_type(tag), Type::Compound(_)));
                }
                _ => return false,
            }
        }
    }

    /// The type of a part, without reporting anything: with how many of its indices are given.
    pub(super) fn part_type(&self, node: &Node) -> Option<(Type, usize)> {
        let mut roots = InScope {
            context: self.context,
            tag: |root: &Node| self.named_tag(root).map(|tag| self.tag_type(tag)),
        };
        path_type(node, self.semantics(), &mut roots)
    }

    /// The part that a node names. Says what is wrong if it names none.
    pub(super) fn part(&mut self, node: &Node) -> Option<Part> {
        match &node.kind {
            NodeKind::Name(_) | NodeKind::Address(_) => {
                let tag = self.named_tag(node)?;
                Some(Part {
                    tag,
                    ty: self.tag_type(tag),
                    given: 0,
                    column: 0,
                    indices: Vec::new(),
                })
            }
            NodeKind::Paren(inner) => self.part(inner),
            NodeKind::Index(base, index) => {
                let mut part = self.part(base)?;
                let Some((dimensions, element)) = part.ty.array() else {
                    self.report(no_array(part.ty, self.text_of(base), self.at(base.range)));
                    return None;
                };
                let bounds = dimensions[part.given];
                let index = self.subscript(base, index, bounds)?;
                part.indices.push((index, bounds));
                part.given += 1;
                if part.given == dimensions.len() {
                    part.ty = element;
                    part.given = 0;
                }
                Some(part)
            }
            NodeKind::Member(base, word) => {
                let mut part = self.part(base)?;
                let structure = match part.ty {
                    Type::Compound(id) => match id.get() {
                        Compound::Structure(structure) => Some(structure),
                        _ => None,
                    },
                    _ => None,
                };
                let Some(structure) = structure else {
                    self.report(unknown_member::of_part(&part.ty, word, self.at(word.range)));
                    return None;
                };
                let Some((number, member)) = structure.member(&word.text) else {
                    if structure.is_whole {
                        let found = unknown_member::of_structure(&structure, word, self.at(word.range));
                        self.report(found);
                    }
                    return None;
                };
                part.column += structure.members[..number]
                    .iter()
                    .map(|member| member.ty.columns())
                    .sum::<u32>();
                part.ty = member.ty;
                Some(part)
            }
            NodeKind::Missing => None,
            NodeKind::Range(..) => {
                self.report(bad_operand::range_inside(self.at(node.range)));
                None
            }
            _ => {
                self.report(bad_operand::wrong(self.at(node.range), "a tag is expected here"));
                None
            }
        }
    }

    /// The place of a value in a tag that has parts, and its type.
    pub(super) fn part_place(&mut self, node: &Node) -> Option<(Place, Scalar)> {
        if let NodeKind::Paren(inner) = &node.kind {
            return self.part_place(inner);
        }
        if let NodeKind::Member(base, word) = &node.kind
            && let Some((ty, 0)) = self.part_type(base)
        {
            match ty {
                Type::State(state) => return self.state_member(base, state, word),
                Type::Scalar(_) => {
                    let (place, ty) = self.part_place(base)?;
                    return self.bit(place, ty, word);
                }
                Type::Compound(id) => {
                    if let Some(block) = id.block() {
                        return self.instance_member(base, &block, node, word);
                    }
                }
                Type::Array { .. } => {}
            }
        }
        if let NodeKind::Range(..) = node.kind {
            let message = "a range does not fit here: name one element";
            self.report(bad_operand::wrong(self.at(node.range), message));
            return None;
        }
        let part = self.part(node)?;
        let range = self.at(node.range);
        match part.scalar() {
            Some(scalar) => Some((self.column_place(&part, range), scalar)),
            None => {
                self.report(type_mismatch::part_as_value(
                    &self.text_of(node),
                    part.ty,
                    part.array().map(|(open, _)| open),
                    range,
                ));
                None
            }
        }
    }

    /// An index: an integer expression, computed in LINT. One that is a number must lie within the bounds.
    fn subscript(&mut self, base: &Node, index: &Node, (first, last): (i64, i64)) -> Option<Expr> {
        let expr = self.index_value(index)?;
        let Some(n) = self.known_index(index) else {
            return Some(expr);
        };
        if !(first..=last).contains(&n) {
            let name = self.text_of(base);
            let message = format!("`{name}` has the elements {first} to {last}, there is no {n}");
            self.report(bad_operand::wrong(self.at(index.range), message));
            return None;
        }
        Some(self.constant_expr(Value::Int(n), Scalar::Lint, index.range))
    }

    /// The value of an index.
    pub(super) fn index_value(&mut self, index: &Node) -> Option<Expr> {
        let is_expression = matches!(
            index.kind,
            NodeKind::Unary(..) | NodeKind::Binary(..) | NodeKind::Call(..)
        );
        if is_expression && crate::values::constant::signed_literal(index).is_none() {
            return self.expression(index, Scalar::Lint);
        }
        self.integer(index)
    }

    /// The tag of the program that holds a column of a scope's tag.
    fn column_id(&self, tag: usize, column: u32) -> TagId {
        let columns = self
            .lowering
            .and_then(|lowering| lowering.ids.columns.get(&tag))
            .and_then(|columns| columns.get(column as usize));
        columns.copied().unwrap_or_else(|| self.tag_id(tag))
    }

    /// The place of a part that is a value.
    fn column_place(&self, part: &Part, range: TextRange) -> Place {
        let id = self.column_id(part.tag, part.column);
        if part.indices.is_empty() {
            return Place::Tag(id);
        }
        Place::Element(id, Box::new(linear(part, &[], range)))
    }

    /// A member of the timer, counter or bistable that a node names.
    fn state_member(&mut self, base: &Node, state: StateType, word: &Word) -> Option<(Place, Scalar)> {
        let at = self.at(word.range);
        let Some(member) = crate::names::infer::member(state, &word.text) else {
            let name = self.text_of(base);
            self.report(unknown_member::of_state(&name, state, &word.text, at));
            return None;
        };
        let place = match self.state(base)? {
            Argument::ChosenState(chosen) => Place::ChosenMember(chosen, member),
            state => Place::Member(state.root()?, member),
        };
        Some((place, member.ty(self.semantics())))
    }

    /// What a node names that keeps a state: its type. None: it is no such tag or part.
    pub(super) fn state_type(&self, node: &Node) -> Option<StateType> {
        match self.part_type(node)? {
            (Type::State(state), _) => Some(state),
            _ => None,
        }
    }

    /// The tag of the program on which the timer, counter, bistable or block keeps its state that a node names.
    pub(super) fn state(&mut self, node: &Node) -> Option<Argument> {
        if !self.is_in_parts(node) {
            return self.named_tag(node).map(|tag| Argument::State(self.tag_id(tag)));
        }
        let part = self.part(node)?;
        let first = self.column_id(part.tag, part.column);
        Some(element_state(&part, first, (0, 1), self.at(node.range)))
    }

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
                let at = |index: Expr| Box::new(linear(&part, &[(index, bounds)], range));
                let (first, last) = (at(first_expr), at(last_expr));
                Some(RangeRef {
                    tag: self.column_id(part.tag, part.column),
                    element,
                    first,
                    last: Some(last),
                })
            }
            NodeKind::Index(base, index) if open => {
                let part = self.part(base)?;
                if part.array().is_some_and(|(left, _)| left.len() > 1) {
                    return self.whole_range(node);
                }
                let (bounds, element) = self.row(base, &part)?;
                let index = self.subscript(base, index, bounds)?;
                let rest = self.constant_expr(Value::Int(bounds.1), Scalar::Lint, node.range);
                let is_whole_column = part.indices.is_empty();
                let at = |index: Expr| Box::new(linear(&part, &[(index, bounds)], range));
                Some(RangeRef {
                    tag: self.column_id(part.tag, part.column),
                    element,
                    first: at(index),
                    // The elements from there on are those of its own row.
                    last: (!is_whole_column).then(|| at(rest)),
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
        let end = |pick: fn(&(i64, i64)) -> i64| {
            let indices: Vec<(Expr, (i64, i64))> = open
                .iter()
                .map(|bounds| {
                    let index = self.constant_expr(Value::Int(pick(bounds)), Scalar::Lint, node.range);
                    (index, *bounds)
                })
                .collect();
            Box::new(linear(&part, &indices, range))
        };
        let (first, last) = (end(|bounds| bounds.0), end(|bounds| bounds.1));
        Some(RangeRef {
            tag: self.column_id(part.tag, part.column),
            element,
            first,
            last: Some(last),
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
            // The elements from there on are those of its own row.
            None if !part.indices.is_empty() => {
                Some(self.constant_expr(Value::Int(bounds.1), Scalar::Lint, node.range))
            }
            None => None,
        };
        let mut ranges = Vec::new();
        for (number, column) in (0..).zip(element.column_list()) {
            let Type::Scalar(scalar) = column.ty else { continue };
            let end = |index: &Expr, pick: fn(&(i64, i64)) -> i64| {
                let mut indices = vec![(index.clone(), bounds)];
                indices.extend(column.dimensions.iter().map(|bounds| {
                    let index = self.constant_expr(Value::Int(pick(bounds)), Scalar::Lint, node.range);
                    (index, *bounds)
                }));
                Box::new(linear(&part, &indices, range))
            };
            ranges.push(Argument::Range(RangeRef {
                tag: TagId(0),
                element: scalar,
                first: end(&first, |bounds| bounds.0),
                last: last.as_ref().map(|last| end(last, |bounds| bounds.1)),
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

    /// A node as it is written.
    pub(super) fn text_of(&self, node: &Node) -> String {
        crate::findings::excerpt::text(&self.context.parse, self.at(node.range))
    }

    /// A bit of an integer or bit string.
    pub(super) fn bit(&mut self, place: Place, ty: Scalar, word: &Word) -> Option<(Place, Scalar)> {
        let bits = ty.is_integer() || ty.is_bits();
        let bit = word.text.parse::<u8>().ok();
        match bit.filter(|&bit| bits && u32::from(bit) < ty.width()) {
            Some(bit) => Some((Place::Bit(Box::new(place), ty, bit), Scalar::Bool)),
            None => {
                self.report(unknown_member::of_scalar(ty, &word.text, self.at(word.range)));
                None
            }
        }
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

fn no_array(ty: Type, name: String, range: TextRange) -> crate::findings::diagnostic::Diagnostic {
    type_mismatch::wrong(
        range,
        format!("`{name}` is {}, no array: it has no elements", with_article(ty)),
    )
}

/// The index of an element in its column: as it is where there is one dimension, else counted from 0 over all of them.
fn linear(part: &Part, more: &[(Expr, (i64, i64))], range: TextRange) -> Expr {
    let all: Vec<&(Expr, (i64, i64))> = part.indices.iter().chain(more).collect();
    if let [(index, _)] = all.as_slice() {
        return index.clone();
    }
    offset(&all, range)
}

/// The n-th of so many states that a part has, as its tag: those of its elements follow each other.
fn element_state(part: &Part, first: TagId, (n, count): (i64, i64), range: TextRange) -> Argument {
    let own = Expr {
        ty: Scalar::Lint,
        kind: ExprKind::Constant(Value::Int(n)),
        range,
    };
    let own = (own, (0, count - 1));
    let all: Vec<&(Expr, (i64, i64))> = part.indices.iter().chain([&own]).collect();
    let elements = all.iter().map(|(_, (first, last))| last - first + 1);
    let elements = elements.product::<i64>() as u32;
    let number = offset(&all, range);
    match number.kind {
        // While a file is only checked the numbers mean nothing.
        ExprKind::Constant(Value::Int(n)) => Argument::State(TagId(first.0.wrapping_add(n as u32))),
        _ => Argument::ChosenState(Box::new(Chosen {
            first,
            step: 1,
            count: elements,
            number,
        })),
    }
}

/// Where an element is, counted from 0 over all indices.
fn offset(all: &[&(Expr, (i64, i64))], range: TextRange) -> Expr {
    let mut stride = 1;
    let mut subscripts: Vec<Subscript> = Vec::with_capacity(all.len());
    for (index, (first, last)) in all.iter().copied().rev() {
        subscripts.push(Subscript {
            index: index.clone(),
            first: *first,
            last: *last,
            stride,
        });
        stride *= last - first + 1;
    }
    subscripts.reverse();
    let known = |subscript: &Subscript| match subscript.index.kind {
        ExprKind::Constant(Value::Int(n)) => Some((n - subscript.first) * subscript.stride),
        _ => None,
    };
    let kind = match subscripts.iter().map(known).sum::<Option<i64>>() {
        Some(offset) => ExprKind::Constant(Value::Int(offset)),
        None => ExprKind::Offset(subscripts),
    };
    Expr {
        ty: Scalar::Lint,
        kind,
        range,
    }
}

//! Paths: what `cell[2].zone[k].valve.open` means, from the type of the tag that it begins with.

use super::Resolver;
use crate::findings::article::with_article;
use crate::names::path_type::{InScope, path_type};
use crate::program::{Argument, Chosen, Expr, ExprKind, Place, Row, Subscript, TagId};
use crate::rules::{bad_operand, type_mismatch, unknown_member};
use crate::values::compound::Compound;
use crate::values::types::{Scalar, Type};
use crate::values::value::Value;
use crate::written::facts::{Node, NodeKind, Word};
use ladder_instructions::StateType;
use ladder_syntax::TextRange;

/// A part of a tag that has parts, or the whole tag.
#[derive(Debug, Clone)]
pub(super) struct Part {
    /// The scope's tag.
    pub(super) tag: usize,
    pub(super) ty: Type,
    /// So many of the indices of `ty`, which is an array, are given.
    pub(super) given: usize,
    /// The first of its columns among those of the tag.
    pub(super) column: u32,
    /// The indices that are given, with the bounds of their dimensions.
    pub(super) indices: Vec<(Expr, (i64, i64))>,
}

impl Part {
    /// The bounds of its dimensions that have no index, and the type of an element, if it is an array.
    pub(super) fn array(&self) -> Option<(Vec<(i64, i64)>, Type)> {
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
                Type::Compound(_) | Type::Array { .. } => {}
            }
        }
        if let Some(instance) = self.instance_of(node) {
            return self.instance_part(&instance, node);
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
    pub(super) fn subscript(&mut self, base: &Node, index: &Node, (first, last): (i64, i64)) -> Option<Expr> {
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
        if is_expression && crate::written::constant::signed_literal(index).is_none() {
            return self.expression(index, Scalar::Lint);
        }
        self.integer(index)
    }

    /// The tag of the program that holds a column of a scope's tag.
    pub(super) fn column_id(&self, tag: usize, column: u32) -> TagId {
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

pub(super) fn no_array(ty: Type, name: String, range: TextRange) -> crate::findings::diagnostic::Diagnostic {
    type_mismatch::wrong(
        range,
        format!("`{name}` is {}, no array: it has no elements", with_article(ty)),
    )
}

/// The index of an element in its column: as it is where there is one dimension, else counted from 0 over all of them.
pub(super) fn linear(part: &Part, more: &[(Expr, (i64, i64))], range: TextRange) -> Expr {
    let all: Vec<&(Expr, (i64, i64))> = part.indices.iter().chain(more).collect();
    if let [(index, _)] = all.as_slice() {
        return index.clone();
    }
    offset(&all, range)
}

/// The array that the last indices are in, where others choose it. Several dimensions are counted from 0, row by row.
pub(super) fn own_row(part: &Part, more: &[(Expr, (i64, i64))], range: TextRange) -> Option<Row> {
    if part.indices.is_empty() {
        return None;
    }
    let (index, bounds) = match more {
        [(index, bounds)] => (index.clone(), *bounds),
        _ => {
            let count: i64 = more.iter().map(|(_, (first, last))| last - first + 1).product();
            (offset(&more.iter().collect::<Vec<_>>(), range), (0, count - 1))
        }
    };
    let index = Box::new(index);
    Some(Row { index, bounds })
}

/// The n-th of so many states that a part has, as its tag: those of its elements follow each other.
pub(super) fn element_state(part: &Part, first: TagId, (n, count): (i64, i64), range: TextRange) -> Argument {
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

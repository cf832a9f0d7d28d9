//! Places: tags, elements, members, bits, system tags, ranges.

use super::Resolver;
use crate::names::infer;
use crate::names::scope::{Origin, type_by_form};
use crate::program::Access;
use crate::program::{Expr, ExprKind, Member, Place, RangeRef, SystemTag};
use crate::rules::{bad_operand, constant_write, type_mismatch, unknown_member};
use crate::values::literal::Literal;
use crate::values::types::{Scalar, Type};
use crate::values::value::Value;
use crate::written::facts::{Node, NodeKind, Word};
use ladder_instructions::StateType;
use ladder_syntax::{Name, TextRange};

impl Resolver<'_, '_> {
    /// The scope's tag that a node names as a whole.
    pub(super) fn named_tag(&self, node: &Node) -> Option<usize> {
        match &node.kind {
            NodeKind::Name(name) | NodeKind::Address(name) => {
                let by_name = || self.scope.find(&Name::new(name));
                self.names.at(node.range).or_else(by_name)
            }
            NodeKind::Paren(inner) => self.named_tag(inner),
            _ => None,
        }
    }

    pub(super) fn tag_type(&self, tag: usize) -> Type {
        self.scope.tags[tag].ty.unwrap_or(Type::Scalar(Scalar::Dint))
    }

    /// The type of a place, without reporting anything.
    pub(super) fn place_type(&self, node: &Node) -> Option<Scalar> {
        if let Some((id, _)) = self.value_of_enumeration(node) {
            return Some(Scalar::Enum(id));
        }
        if self.is_in_parts(node) {
            return match self.part_type(node)? {
                (ty, 0) => ty.scalar(),
                _ => None,
            };
        }
        match &node.kind {
            NodeKind::Name(_) | NodeKind::Address(_) => self.tag_type(self.named_tag(node)?).scalar(),
            NodeKind::Index(base, _) => match self.tag_type(self.named_tag(base)?) {
                Type::Array { element, .. } => Some(element),
                _ => None,
            },
            NodeKind::Member(base, word) => {
                if is_system(base) {
                    return SystemTag::from_name(&word.text).map(SystemTag::ty);
                }
                if let Some(Type::State(state)) = self.named_tag(base).map(|tag| self.tag_type(tag)) {
                    return infer::member(state, &word.text).map(|member| member.ty(self.semantics()));
                }
                Some(Scalar::Bool)
            }
            NodeKind::Paren(inner) => self.place_type(inner),
            _ => None,
        }
    }

    /// The place that a node names, and its type. Says what is wrong if it names none.
    pub(super) fn place(&mut self, node: &Node) -> Option<(Place, Scalar)> {
        let range = self.at(node.range);
        if self.is_in_parts(node) {
            return self.part_place(node);
        }
        match &node.kind {
            NodeKind::Name(name) if name.eq_ignore_ascii_case("SYS") => {
                self.report(bad_operand::wrong(
                    range,
                    "SYS is not a tag by itself: write SYS.ON, SYS.FIRST_SCAN, ...",
                ));
                None
            }
            NodeKind::Name(name) if name.eq_ignore_ascii_case("PI") => {
                self.report(bad_operand::pi(range));
                None
            }
            NodeKind::Address(name) if type_by_form(name).is_none() => {
                self.report(bad_operand::no_address(name, range));
                None
            }
            NodeKind::Name(name)
                if self.named_tag(node).is_none() && self.context.types.has_value(&Name::new(name)) =>
            {
                self.report(bad_operand::value_not_asked(name, range));
                None
            }
            NodeKind::Name(name) | NodeKind::Address(name) => {
                let tag = self.named_tag(node)?;
                match self.tag_type(tag) {
                    Type::Scalar(scalar) => Some((self.tag_as_place(tag, scalar), scalar)),
                    Type::State(state) => {
                        self.report(type_mismatch::state_as_value(name, state, range));
                        None
                    }
                    Type::Array { first, .. } => {
                        let message =
                            format!("`{name}` is an array: name an element such as {name}[{first}]");
                        self.report(type_mismatch::wrong(range, message));
                        None
                    }
                    Type::Compound(_) => None,
                }
            }
            NodeKind::Index(base, index) => {
                let (tag, element) = self.array(base)?;
                let index = self.index(base, tag, index)?;
                Some((Place::Element(self.tag_id(tag), Box::new(index)), element))
            }
            NodeKind::Member(base, word) => self.member(base, word),
            NodeKind::Paren(inner) => self.place(inner),
            NodeKind::Missing => None,
            NodeKind::NoFunction => {
                self.report(bad_operand::no_function(range));
                None
            }
            NodeKind::Range(..) => {
                self.report(bad_operand::wrong(
                    range,
                    "a range does not fit here: name one element",
                ));
                None
            }
            _ => {
                self.report(bad_operand::wrong(range, "a tag is expected here"));
                None
            }
        }
    }

    fn member(&mut self, base: &Node, word: &Word) -> Option<(Place, Scalar)> {
        let at = self.at(word.range);
        if is_system(base) {
            let Some(tag) = SystemTag::from_name(&word.text) else {
                self.report(unknown_member::system(&word.text, at));
                return None;
            };
            return Some((Place::System(tag), tag.ty()));
        }
        if let Some(tag) = self.named_tag(base)
            && let Type::State(state) = self.tag_type(tag)
        {
            let Some(member) = infer::member(state, &word.text) else {
                self.report(unknown_member::of_state(
                    &self.scope.tags[tag].name,
                    state,
                    &word.text,
                    at,
                ));
                return None;
            };
            return Some((
                Place::Member(self.tag_id(tag), member),
                member.ty(self.semantics()),
            ));
        }
        if let Some(tag) = self.named_tag(base)
            && self.scope.tags[tag].origin == Origin::Undeclared
            && StateType::ALL
                .iter()
                .any(|&state| infer::member(state, &word.text).is_some())
        {
            self.report(unknown_member::of_no_state(
                self.scope,
                &self.scope.tags[tag].name,
                &word.text,
                self.at(base.range),
                at,
            ));
            return None;
        }
        let (place, ty) = self.place(base)?;
        self.bit(place, ty, word)
    }

    /// The array that a node names: its tag and the type of its elements.
    fn array(&mut self, base: &Node) -> Option<(usize, Scalar)> {
        let range = self.at(base.range);
        let Some(tag) = self.named_tag(base) else {
            if !matches!(base.kind, NodeKind::Missing) {
                self.report(bad_operand::wrong(
                    range,
                    "an index belongs after the name of an array",
                ));
            }
            return None;
        };
        match self.tag_type(tag) {
            Type::Array { element, .. } => Some((tag, element)),
            ty => {
                let facts = &self.scope.tags[tag];
                // undeclared-tag reports an array without a declaration, once.
                if facts.origin != Origin::Undeclared && !facts.mistyped {
                    let diagnostic = type_mismatch::wrong(
                        range,
                        format!("`{}` is {ty}, no array: it has no elements", facts.name),
                    );
                    self.report(diagnostic);
                }
                None
            }
        }
    }

    /// An index: any integer. One that is written as a number, or is CONSTANT, must lie in the array.
    fn index(&mut self, base: &Node, tag: usize, index: &Node) -> Option<Expr> {
        let Type::Array { first, last, .. } = self.tag_type(tag) else {
            return None;
        };
        let expr = self.index_value(index)?;
        if let Some(n) = self.known_index(index)
            && !(first..=last).contains(&n)
        {
            let NodeKind::Name(name) = &base.kind else {
                return None;
            };
            let message = format!("`{name}` has the elements {first} to {last}, there is no {n}");
            self.report(bad_operand::wrong(self.at(index.range), message));
            return None;
        }
        Some(expr)
    }

    /// A range of an array: `a[3..9]`, or with `open` also an element from which on it is meant.
    pub(super) fn range(&mut self, node: &Node, open: bool) -> Option<RangeRef> {
        if self.is_in_parts(node) {
            return self.part_range(node, open);
        }
        match &node.kind {
            NodeKind::Range(base, first, last) => {
                let (tag, element) = self.array(base)?;
                let first_expr = self.index(base, tag, first)?;
                let last_expr = self.index(base, tag, last)?;
                if let (Some(a), Some(b)) = (self.known_index(first), self.known_index(last))
                    && a > b
                {
                    let message = format!("the range ends at {b}, before it begins at {a}: swap them");
                    self.report(bad_operand::wrong(self.at(node.range), message));
                    return None;
                }
                let last = Some(Box::new(last_expr));
                Some(RangeRef {
                    tag: self.tag_id(tag),
                    element,
                    first: Box::new(first_expr),
                    last,
                    row: None,
                    per_index: 1,
                })
            }
            NodeKind::Index(base, index) if open => {
                let (tag, element) = self.array(base)?;
                let first = Box::new(self.index(base, tag, index)?);
                Some(RangeRef {
                    tag: self.tag_id(tag),
                    element,
                    first,
                    last: None,
                    row: None,
                    per_index: 1,
                })
            }
            NodeKind::Missing => None,
            NodeKind::Name(_) if self.array_bounds(node).is_some() => {
                let (tag, first, last, element) = self.array_bounds(node)?;
                let index = |n| Box::new(self.constant_expr(Value::Int(n), Scalar::Lint, node.range));
                Some(RangeRef {
                    tag: self.tag_id(tag),
                    element,
                    first: index(first),
                    last: Some(index(last)),
                    row: None,
                    per_index: 1,
                })
            }
            _ => {
                let message = "a range of an array is expected here: a[1..9]";
                self.report(bad_operand::wrong(self.at(node.range), message));
                None
            }
        }
    }

    /// The tag that a node names, if it is an array of values in one dimension: its bounds and the type of its elements.
    fn array_bounds(&self, node: &Node) -> Option<(usize, i64, i64, Scalar)> {
        let tag = self.named_tag(node)?;
        match self.tag_type(tag) {
            Type::Array { first, last, element } => Some((tag, first, last, element)),
            _ => None,
        }
    }

    /// Says so if a place must not be written.
    pub(super) fn check_writable(&mut self, place: &Place, node: &Node, access: Access) -> bool {
        if !access.writes() {
            return true;
        }
        if self.is_written_by_block(node) {
            return false;
        }
        let range = self.at(node.range);
        let tag = match place {
            Place::System(_) => {
                self.report(constant_write::system(range));
                return false;
            }
            // There what they count is a variable like any other.
            Place::Member(_, Member::Et | Member::Cv) | Place::ChosenMember(_, Member::Et | Member::Cv)
                if self.semantics().states.are_written() =>
            {
                return true;
            }
            Place::Member(..) | Place::ChosenMember(..) => {
                let message = "a member of a timer or counter is written by its own block only: use (RES) or R := to \
                               clear it";
                self.report(bad_operand::wrong(range, message));
                return false;
            }
            Place::Bit(base, ..) | Place::As(base, ..) => {
                return self.check_writable(base, node, access);
            }
            Place::Tag(_) | Place::Element(..) | Place::Chosen(_) => self.written_tag(node),
        };
        let Some(tag) = tag.filter(|&tag| self.scope.tags[tag].constant) else {
            return true;
        };
        let tag = self.context.shared(&self.scope.tags[tag]);
        let name = Name::new(&tag.name);
        let elsewhere = match &tag.cold.foreign {
            Some(_) => self.context.others.globals(&name).next(),
            None => None,
        };
        let (file, declared) = match elsewhere {
            Some((file, global)) => (Some(&file.file), global.at),
            None => (None, self.context.place_of(tag)),
        };
        let diagnostic = constant_write::constant(&tag.name, range, file, declared);
        self.report(diagnostic);
        false
    }

    /// The scope's tag that a node is, or is a part of.
    fn written_tag(&self, node: &Node) -> Option<usize> {
        match &node.kind {
            NodeKind::Index(base, _)
            | NodeKind::Range(base, ..)
            | NodeKind::Member(base, _)
            | NodeKind::Paren(base) => self.written_tag(base),
            _ => self.named_tag(node),
        }
    }

    /// An integer value in its own type: a count, selector or index.
    pub(super) fn integer(&mut self, node: &Node) -> Option<Expr> {
        if let Some((Ok(Literal::Int(_)), _)) = crate::written::constant::signed_literal(node) {
            return self.literal_in(node, Scalar::Lint);
        }
        let expr = self.natural(node)?;
        if expr.ty.is_integer() {
            return Some(expr);
        }
        self.report(type_mismatch::wrong(
            self.at(node.range),
            format!("an integer is expected here, this is {}", expr.ty),
        ));
        None
    }

    pub(super) fn constant_expr(&self, value: Value, ty: Scalar, range: TextRange) -> Expr {
        Expr {
            ty,
            kind: ExprKind::Constant(value),
            range: self.at(range),
        }
    }
}

fn is_system(node: &Node) -> bool {
    matches!(&node.kind, NodeKind::Name(name) if name.eq_ignore_ascii_case("SYS"))
}

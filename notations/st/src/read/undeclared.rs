//! Tags that another file declares: the types that their places ask for.

use super::dialect::Dialect;
use super::lower::{bits_of, plain_types};
use super::scope::{ParameterRole, Scope, Type, elementary};
use super::token::{TokenKind, tokens};
use super::tree::{
    Call, Direction, Expression, ExpressionKind, LiteralKind, Place, Statement, StatementKind, Step,
};
use super::units;
use ladder_analysis::values::types::Scalar;
use ladder_format::program::{Operator, Sign};
use std::collections::{BTreeMap, BTreeSet};

/// A chain of assignments tells a type from end to end in so many turns.
const TURNS: usize = 4;

/// The tags of a text that are not declared, with the types that their places ask for: `run`, and in SCL `"Data".level`,
/// as they are written. A tag of which no place tells is left out.
pub fn undeclared(text: &str, dialect: Dialect, scope: &Scope) -> Vec<(String, Type)> {
    let (statements, ..) = units::body(text, dialect);
    let mut asked = Asked {
        scope,
        found: BTreeMap::new(),
    };
    for _ in 0..TURNS {
        let before = asked.found.len();
        asked.statements(&statements);
        if asked.found.len() == before {
            break;
        }
    }
    let found = &asked.found;
    let is_in_state = |key: &str| {
        let owner = key.rsplit_once('.').and_then(|(owner, _)| found.get(owner));
        matches!(owner, Some((_, Type::Standard(_))))
    };
    let all = found.iter().filter(|(key, _)| !is_in_state(key));
    all.map(|(_, tag)| tag.clone()).collect()
}

/// The names in a text in SCL, without their signs: those that a block may have, `run` and `#run`, and those of the project,
/// `"run"`.
pub fn names_in_scl(text: &str) -> [BTreeSet<&str>; 2] {
    let mut names = [BTreeSet::new(), BTreeSet::new()];
    for token in tokens(text, Dialect::Scl).tokens {
        if let TokenKind::Word | TokenKind::Name = token.kind {
            let name = &text[token.span];
            let is_of_project = name.starts_with('"');
            names[usize::from(is_of_project)].insert(name.trim_start_matches('#').trim_matches('"'));
        }
    }
    names
}

struct Asked<'s> {
    scope: &'s Scope,
    /// By the name in small letters: as it is written, and its type.
    found: BTreeMap<String, (String, Type)>,
}

impl Asked<'_> {
    fn statements(&mut self, statements: &[Statement]) {
        for statement in statements {
            match &statement.kind {
                StatementKind::Assign(targets, _, value) => {
                    let of_targets = targets.iter().find_map(|target| self.of_place(target));
                    let ty = of_targets.or_else(|| self.of(value));
                    for target in targets {
                        self.place(target, ty);
                    }
                    self.expression(value, ty);
                }
                StatementKind::Call(call) => self.call(call),
                StatementKind::If(branches, otherwise) => {
                    for (condition, body) in branches {
                        self.expression(condition, Some(Scalar::Bool));
                        self.statements(body);
                    }
                    self.statements(otherwise);
                }
                StatementKind::Case(selector, arms, otherwise) => {
                    self.expression(selector, Some(Scalar::Int));
                    for arm in arms {
                        self.statements(&arm.body);
                    }
                    self.statements(otherwise);
                }
                StatementKind::For(counting) => {
                    let ty = self.of_place(&counting.variable).or(Some(Scalar::Int));
                    self.place(&counting.variable, ty);
                    for bound in [&counting.from, &counting.to].into_iter().chain(&counting.by) {
                        self.expression(bound, ty);
                    }
                    self.statements(&counting.body);
                }
                StatementKind::While(condition, body) | StatementKind::Repeat(body, condition) => {
                    self.expression(condition, Some(Scalar::Bool));
                    self.statements(body);
                }
                _ => {}
            }
        }
    }

    /// A place that asks for a type.
    fn place(&mut self, place: &Place, ty: Option<Scalar>) {
        for step in &place.steps {
            if let Step::Index(indices) = step {
                for index in indices {
                    self.expression(index, Some(Scalar::Int));
                }
            }
        }
        let (name, rest) = place.written();
        let ty = match rest {
            [] => ty,
            [Step::Bit(_)] => Some(Scalar::Word),
            _ => None,
        };
        if let (None, false, Some(ty)) = (self.scope.known(&place.root), name.starts_with('%'), ty) {
            self.add(name, Type::Scalar(ty));
        }
    }

    fn add(&mut self, name: String, ty: Type) {
        let key = name.to_lowercase();
        self.found.entry(key).or_insert_with(|| (name, ty));
    }

    fn expression(&mut self, expression: &Expression, ty: Option<Scalar>) {
        match &expression.kind {
            ExpressionKind::Literal(..) => {}
            ExpressionKind::Place(place) => self.place(place, ty),
            ExpressionKind::Group(inner) | ExpressionKind::Unary(_, inner) => self.expression(inner, ty),
            ExpressionKind::Binary(operator, left, right) | ExpressionKind::Lazy(operator, left, right) => {
                let both = self.of(left).or_else(|| self.of(right));
                let both = if operator.compares() { both } else { both.or(ty) };
                self.expression(left, both);
                self.expression(right, both);
            }
            ExpressionKind::Call(call) => self.call(call),
        }
    }

    fn call(&mut self, call: &Call) {
        let shape = match self.scope.function_named(&call.callee.root) {
            Some(shape) => Some(shape.clone()),
            None => match self.scope.known(&call.callee.root).map(|known| &known.ty) {
                Some(Type::Block(shape)) => Some(shape.clone()),
                _ => None,
            },
        };
        let standard = match self.scope.known(&call.callee.root) {
            Some(known) => Some(known.ty.clone()),
            // `"IEC_Timer_0_DB".TON(..)`
            None => match &call.callee.steps[..] {
                [Step::Member(name)] => self.scope.type_named(name),
                _ => None,
            },
        };
        if let (Some(ty @ Type::Standard(_)), None) = (&standard, self.scope.known(&call.callee.root)) {
            self.add(call.callee.root.clone(), ty.clone());
        }
        let inputs = shape.iter().flat_map(|shape| &shape.parameters);
        let mut inputs = inputs.filter(|one| one.role == ParameterRole::Input);
        let mut first = plain_types(&call.callee.root).0;
        for argument in &call.arguments {
            let Some(value) = &argument.value else { continue };
            let ty = match &argument.name {
                Some(name) => match &shape {
                    Some(shape) => {
                        let parameter = shape
                            .parameters
                            .iter()
                            .find(|one| one.name.eq_ignore_ascii_case(name));
                        parameter.and_then(|parameter| parameter.ty.scalar())
                    }
                    None => standard.as_ref().and_then(|ty| ty.member(name)?.1.scalar()),
                },
                None => (inputs.next().and_then(|parameter| parameter.ty.scalar())).or(first.take()),
            };
            match (&value.kind, argument.direction) {
                (ExpressionKind::Place(place), Direction::Out | Direction::OutNegated) => {
                    self.place(place, ty);
                }
                _ => self.expression(value, ty),
            }
        }
    }

    /// The type of an expression, as far as it is plain.
    fn of(&self, expression: &Expression) -> Option<Scalar> {
        match &expression.kind {
            ExpressionKind::Literal(LiteralKind::Real, _) => Some(Scalar::Real),
            ExpressionKind::Literal(LiteralKind::Typed, text) => {
                let (word, _) = text.split_once('#')?;
                if word.eq_ignore_ascii_case("T") {
                    return Some(Scalar::Time);
                }
                elementary(word)
            }
            ExpressionKind::Literal(LiteralKind::Integer, _) => Some(Scalar::Int),
            ExpressionKind::Literal(LiteralKind::Text, _) => None,
            ExpressionKind::Place(place) => self.of_place(place),
            ExpressionKind::Group(inner) => self.of(inner),
            ExpressionKind::Unary(Sign::Not, inner) => self.of(inner).or(Some(Scalar::Bool)),
            ExpressionKind::Unary(_, inner) => self.of(inner),
            ExpressionKind::Binary(operator, ..) if operator.compares() => Some(Scalar::Bool),
            ExpressionKind::Binary(operator, left, right) | ExpressionKind::Lazy(operator, left, right) => {
                let both = [self.of(left), self.of(right)];
                // A literal adapts itself to what is next to it.
                let tag = both.into_iter().flatten().find(|ty| *ty != Scalar::Int);
                let is_logic = matches!(operator, Operator::And | Operator::Or | Operator::Xor);
                tag.or(both[0])
                    .or(both[1])
                    .or_else(|| is_logic.then_some(Scalar::Bool))
            }
            ExpressionKind::Call(call) => match self.scope.function_named(&call.callee.root) {
                Some(shape) => shape.returns.as_ref()?.1.scalar(),
                None => plain_types(&call.callee.root).1,
            },
        }
    }

    fn of_place(&self, place: &Place) -> Option<Scalar> {
        if place.root.eq_ignore_ascii_case("TRUE") || place.root.eq_ignore_ascii_case("FALSE") {
            return Some(Scalar::Bool);
        }
        let (name, rest) = place.written();
        if let (Some((_, ty)), true) = (self.found.get(&name.to_lowercase()), rest.is_empty()) {
            return ty.scalar();
        }
        let declared = self.scope.known(&place.root).map(|known| &known.ty);
        let found = || self.found.get(&place.root.to_lowercase()).map(|(_, ty)| ty);
        let mut ty = declared.or_else(found)?.clone();
        for step in &place.steps {
            ty = match (step, ty) {
                (Step::Member(_), Type::Trigger(_)) | (Step::Bit(_) | Step::ComputedBit(_), _) => Type::BOOL,
                (Step::Part(bits, _), _) => Type::Scalar(bits_of(*bits)?),
                (Step::Member(name), ty) => ty.member(name)?.1,
                (Step::Index(_), Type::Array(_, of)) => *of,
                _ => return None,
            };
        }
        ty.scalar()
    }
}

//! Arguments: what is given for each operand of a block.

use super::compared::{Compared, compared_without_order};
use super::{OperandAt, Resolver};
use crate::names::context::Callee;
use crate::networks::BlockAt;
use crate::networks::network::Formal;
use crate::program::Access;
use crate::program::{Argument, BinaryOperator, Bound, Expr, ExprKind, Place, RangeRef};
use crate::rules::{bad_operand, type_mismatch};
use crate::values::literal::Literal;
use crate::values::types::{Scalar, Type, converts};
use crate::values::value::Value;
use crate::written::constant::{natural_type, signed_literal};
use crate::written::facts::{Node, NodeKind};
use ladder_instructions::{
    Accepts, Direction, Instruction, Op, Operand, StateType, States, Timing, Truth, TypeClass,
};
use ladder_syntax::Name;

/// Whether a type is in a class of result types.
pub fn in_class(ty: Scalar, class: TypeClass) -> bool {
    match class {
        TypeClass::Number => ty.is_number(),
        TypeClass::NumberOrTime => ty.is_number() || matches!(ty, Scalar::Time | Scalar::Dt),
        TypeClass::Real => ty.is_real(),
        TypeClass::BitsOrInteger => ty.is_bits() || ty.is_integer(),
        TypeClass::BoolBitsOrInteger => ty == Scalar::Bool || ty.is_bits() || ty.is_integer(),
        TypeClass::Integer => ty.is_integer(),
        TypeClass::String => ty.is_string(),
        TypeClass::Any => true,
    }
}

const MILLISECOND: i64 = 1_000_000;

impl<'c> Resolver<'c, '_> {
    /// The arguments of an instruction, and the type that it works in.
    pub(super) fn arguments(
        &mut self,
        row: &'static Instruction,
        bound: BlockAt<'c>,
    ) -> (Vec<Bound>, Option<Scalar>) {
        if let Some(ty) = self.whole_type(row, bound) {
            return (self.whole_arguments(row, bound, ty), None);
        }
        let mut works_in = None;
        let mut arguments = Vec::with_capacity(bound.formals.len());
        let compared = self.compared_type(bound);
        for (written, formal) in bound.facts.operands.iter().zip(bound.formals.iter()) {
            let Formal::Operand(operand) = *formal else {
                continue;
            };
            let is_named = row.operands.len() > 1
                && matches!(
                    operand.accepts,
                    Accepts::Bool | Accepts::BoolOrRange | Accepts::Value
                );
            self.operand = is_named.then(|| OperandAt {
                range: bound.absolute(written.value.range),
                name: operand.name,
                block: bound,
            });
            let argument = match operand.accepts {
                Accepts::Result(class) => {
                    let place = self.result(&written.value, operand, class);
                    works_in = works_in.or(place.as_ref().map(|(_, ty)| *ty));
                    // Operands that do not fit together are reported once.
                    if works_in.is_some_and(|ty| {
                        !self.is_of_operands(row.op) && !self.check_times(row.op, bound, ty)
                    }) {
                        works_in = None;
                    }
                    place.map(|(place, ty)| Argument::Place(place, ty))
                }
                Accepts::Value if works_in.is_some() && self.is_of_operands(row.op) => {
                    self.operand_number(&written.value).map(Argument::Value)
                }
                Accepts::Value => match works_in {
                    Some(ty) => self.value_of(row.op, &written.value, ty).map(Argument::Value),
                    // The result's own error is enough.
                    None => None,
                },
                Accepts::Expression => match works_in {
                    Some(ty) => {
                        let ty = self.formula_type(&written.value, ty);
                        self.expression(&written.value, ty).map(Argument::Value)
                    }
                    None => None,
                },
                Accepts::Compared => {
                    let expr = match compared {
                        Compared::In(ty) => self.value(&written.value, ty),
                        Compared::ByValue => match self.own_type(&written.value) {
                            Some(Scalar::Bool) => self.value(&written.value, Scalar::Lint),
                            Some(_) => self.natural(&written.value),
                            None => self.literal_in(&written.value, Scalar::Lint),
                        },
                        Compared::Not => None,
                    };
                    works_in = Some(match compared {
                        Compared::In(ty) => ty,
                        _ => Scalar::Lint,
                    });
                    expr.map(Argument::Value)
                }
                Accepts::Wrapped => self.wrapped(&written.value).map(Argument::Value),
                Accepts::Convertible => match self.natural(&written.value) {
                    Some(value) => self.convertible(row.op, value, works_in).map(Argument::Value),
                    None => None,
                },
                // What a label or function block names is itself.
                Accepts::Label if row.op == Op::Lbl => Some(Argument::Label(None)),
                // One that begins no function is in a wrong place.
                Accepts::Function if row.op == Op::Fun => match &written.value.kind {
                    NodeKind::Name(name) => {
                        let own = self.context.function(&Name::new(name));
                        own.map(|item| self.function_number(&Callee::Own(item)))
                            .map(Argument::Function)
                    }
                    _ => self.argument(&written.value, operand),
                },
                _ => self.argument(&written.value, operand),
            };
            self.operand = None;
            if let Some(argument) = argument {
                // What is written into a range takes the type of its elements ([FILL], [SHIFT]).
                if let Argument::Range(range) = &argument {
                    works_in = works_in.or(Some(range.element));
                }
                let range = bound.absolute(written.range);
                arguments.push(Bound {
                    operand: Some(operand),
                    parameter: None,
                    argument,
                    range,
                });
            }
        }
        if let Some(ty) = compared_without_order(compared)
            && !matches!(row.op, Op::Eq | Op::Ne)
            && !(row.op == Op::Search && asks_for_equality(bound))
        {
            self.report(type_mismatch::no_order(ty, bound.range()));
        }
        if row.op == Op::Search {
            self.check_search(bound);
        }
        if arguments.len() == bound.formals.len() {
            self.check_ranges(row.op, bound, &arguments);
        }
        (arguments, works_in)
    }

    /// The place that a result goes to.
    fn result(
        &mut self,
        node: &Node,
        operand: &'static Operand,
        class: TypeClass,
    ) -> Option<(Place, Scalar)> {
        let (place, ty) = self.place_or_say(node)?;
        if !self.check_writable(&place, node, access(operand.direction)) {
            return None;
        }
        let takes_truth = self.semantics().truth == Truth::NotZero && ty == Scalar::Bool;
        if !in_class(ty, class) && !takes_truth {
            self.report(type_mismatch::result(ty, class, self.at(node.range)));
            return None;
        }
        Some((place, ty))
    }

    /// As `place`, but a literal gets its own sentence.
    pub(super) fn place_or_say(&mut self, node: &Node) -> Option<(Place, Scalar)> {
        if signed_literal(node).is_some() {
            self.report(bad_operand::literal_as_target(self.at(node.range)));
            return None;
        }
        self.place(node)
    }

    /// A value of an instruction that works in a type: TIME and dates mix in the ways that LANGUAGE §5.2 lists.
    fn value_of(&mut self, op: Op, node: &Node, ty: Scalar) -> Option<Expr> {
        let own = self.own_type(node);
        let literal = match signed_literal(node) {
            Some((Ok(literal), negative)) => Some(natural_type(literal, negative)),
            _ => None,
        };
        let found = own.or(literal);
        match (op, ty, found) {
            (Op::Mul | Op::Div, Scalar::Time, Some(found)) if found.is_number() => self.number(node),
            (Op::Sub, Scalar::Time, Some(Scalar::Dt | Scalar::Tod)) => self.natural(node),
            (Op::Add, Scalar::Dt, Some(Scalar::Time)) => self.natural(node),
            _ => self.value(node, ty),
        }
    }

    /// A value that `[TYP]` converts to the result's type, or that `[UNPACK]` takes apart.
    fn convertible(&mut self, op: Op, value: Expr, result: Option<Scalar>) -> Option<Expr> {
        if let (Op::Typ, Some(to)) = (op, result)
            && !converts(value.ty, to)
        {
            self.report(type_mismatch::does_not_convert(value.ty, to, value.range));
            return None;
        }
        Some(value)
    }

    /// A value that `[WRAP]` cuts to the result's type.
    fn wrapped(&mut self, node: &Node) -> Option<Expr> {
        if let Some((Ok(Literal::Int(_)), _)) = signed_literal(node) {
            return self.literal_in(node, Scalar::Lint);
        }
        let value = self.natural(node)?;
        if !value.ty.is_integer() && !value.ty.is_bits() {
            self.report(type_mismatch::does_not_wrap(value.ty, value.range));
            return None;
        }
        Some(value)
    }

    /// The argument of an operand that asks for something of its own.
    pub(super) fn argument(&mut self, node: &Node, operand: &'static Operand) -> Option<Argument> {
        let reads = operand.direction == Direction::In;
        match operand.accepts {
            Accepts::Bool if reads => self.value(node, Scalar::Bool).map(Argument::Value),
            Accepts::Bool => self.target(node, operand, Scalar::Bool),
            Accepts::BoolOrRange | Accepts::BoolRangeOrState => {
                if matches!(node.kind, NodeKind::Range(..)) {
                    let range = self.range(node, false)?;
                    if range.element != Scalar::Bool {
                        self.report(type_mismatch::does_not_pass(
                            range.element,
                            Scalar::Bool,
                            self.at(node.range),
                        ));
                        return None;
                    }
                    return self.ranged(range, node, operand);
                }
                if operand.accepts == Accepts::BoolRangeOrState
                    && let Some(state) = self.state_type(node)
                    && (state.is_timer() || state.is_counter())
                {
                    return self.state(node);
                }
                if reads {
                    return self.value(node, Scalar::Bool).map(Argument::Value);
                }
                self.target(node, operand, Scalar::Bool)
            }
            Accepts::State(state) if self.is_in_parts(node) => match self.state_type(node) {
                Some(found) if self.is_state_for(found, state) => self.state(node),
                _ => {
                    let part = self.part(node)?;
                    let found =
                        type_mismatch::wrong_state(&self.text_of(node), part.ty, state, self.at(node.range));
                    self.report(found);
                    None
                }
            },
            Accepts::State(state) => match self.named_tag(node).map(|tag| (tag, self.tag_type(tag))) {
                Some((tag, Type::State(found))) if self.is_state_for(found, state) => {
                    Some(Argument::State(self.tag_id(tag)))
                }
                Some((tag, ty)) => {
                    let name = self.scope.tags[tag].name.clone();
                    self.report(type_mismatch::wrong_state(&name, ty, state, self.at(node.range)));
                    None
                }
                None => {
                    self.report(bad_operand::state_expected(state, self.at(node.range)));
                    None
                }
            },
            Accepts::TimerOrCounter => match self.state_type(node) {
                Some(state) if state.is_timer() || state.is_counter() => self.state(node),
                _ => {
                    let message = "the tag of a timer or counter is expected here";
                    self.report(bad_operand::wrong(self.at(node.range), message));
                    None
                }
            },
            Accepts::Integer => self.integer(node).map(Argument::Value),
            Accepts::Number => self.number(node).map(Argument::Value),
            Accepts::String => {
                if let Some((Ok(crate::values::literal::Literal::Text(_)), _)) = signed_literal(node) {
                    return self.natural(node).map(Argument::Value);
                }
                self.value(node, Scalar::String(crate::values::types::DEFAULT_STRING))
                    .map(Argument::Value)
            }
            Accepts::Duration => self.duration(node).map(Argument::Value),
            Accepts::Time => self.value(node, Scalar::Time).map(Argument::Value),
            Accepts::Count => self
                .value(node, Scalar::integer_of(self.semantics()))
                .map(Argument::Value),
            Accepts::Range => {
                let range = self.range(node, true)?;
                self.ranged(range, node, operand)
            }
            Accepts::RangeOrValue => {
                if self.is_range(node) {
                    let range = self.range(node, false)?;
                    return self.ranged(range, node, operand);
                }
                if reads {
                    return self.natural(node).map(Argument::Value);
                }
                self.result(node, operand, TypeClass::Any)
                    .map(|(place, ty)| Argument::Place(place, ty))
            }
            Accepts::Label => self.label(node),
            Accepts::Function => self.function(node),
            Accepts::SearchOperator => match &node.kind {
                NodeKind::Name(name) if search_operator(name).is_some() => {
                    search_operator(name).map(Argument::Operator)
                }
                _ => {
                    let message = "one of EQ NE GT GE LT LE is expected here";
                    self.report(bad_operand::wrong(self.at(node.range), message));
                    None
                }
            },
            Accepts::Tag => {
                if self.is_in_parts(node) {
                    return match self.part_type(node) {
                        Some((Type::State(_), _)) => self.state(node),
                        Some((Type::Scalar(_), 0)) => self
                            .place_or_say(node)
                            .map(|(place, ty)| Argument::Place(place, ty)),
                        _ => self.copied_parts(node).map(Argument::Parts),
                    };
                }
                if let Some(tag) = self.named_tag(node) {
                    match self.tag_type(tag) {
                        Type::State(_) => return Some(Argument::State(self.tag_id(tag))),
                        Type::Array { first, last, element } => {
                            let index =
                                |n| Box::new(self.constant_expr(Value::Int(n), Scalar::Lint, node.range));
                            let (tag, first, last) = (self.tag_id(tag), index(first), Some(index(last)));
                            return Some(Argument::Range(RangeRef {
                                tag,
                                element,
                                first,
                                last,
                                row: None,
                                per_index: 1,
                            }));
                        }
                        Type::Scalar(_) | Type::Compound(_) => {}
                    }
                }
                self.place_or_say(node)
                    .map(|(place, ty)| Argument::Place(place, ty))
            }
            Accepts::Result(_)
            | Accepts::Value
            | Accepts::Compared
            | Accepts::Expression
            | Accepts::Convertible
            | Accepts::Wrapped => None,
        }
    }

    /// Whether a node is several elements: a range, or an array without an index.
    fn is_range(&self, node: &Node) -> bool {
        matches!(node.kind, NodeKind::Range(..))
            || self.part_type(node).is_some_and(|(ty, _)| ty.array().is_some())
    }

    /// A range as an operand. Says so if the operand writes it, and it must not be written.
    fn ranged(&mut self, range: RangeRef, node: &Node, operand: &Operand) -> Option<Argument> {
        self.check_writable(&Place::Tag(range.tag), node, access(operand.direction))
            .then_some(Argument::Range(range))
    }

    /// Whether a tag of a type can hold the state of a block.
    fn is_state_for(&self, found: StateType, block: StateType) -> bool {
        match self.semantics().states {
            States::OneBlock | States::Writable => found == block,
            States::Shared => found.is_of_one_sort_with(block),
        }
    }

    /// A place of one type that is written.
    fn target(&mut self, node: &Node, operand: &'static Operand, ty: Scalar) -> Option<Argument> {
        let (place, found) = self.place_or_say(node)?;
        if !self.check_writable(&place, node, access(operand.direction)) {
            return None;
        }
        // A number takes 0 or 1.
        let takes_truth = self.semantics().truth == Truth::NotZero && ty == Scalar::Bool && found.is_number();
        if found != ty && !takes_truth {
            let given = self.given(node);
            self.report(type_mismatch::does_not_take(
                &given,
                found,
                ("what this block writes", ty),
                self.at(node.range),
            ));
            return None;
        }
        Some(Argument::Place(place, found))
    }

    /// PT: a TIME, or a plain integer in milliseconds.
    fn duration(&mut self, node: &Node) -> Option<Expr> {
        let range = self.at(node.range);
        let milliseconds = match self.own_type(node) {
            Some(ty) if ty.is_integer() => self.natural(node)?,
            None if matches!(
                signed_literal(node),
                Some((Ok(crate::values::literal::Literal::Int(_)), _))
            ) =>
            {
                self.literal_in(node, Scalar::Dint)?
            }
            _ => return self.value(node, Scalar::Time),
        };
        // There a plain number counts steps.
        if matches!(self.semantics().timing, Timing::Ticks | Timing::Units) {
            return Some(milliseconds);
        }
        if let ExprKind::Constant(Value::Int(n)) = milliseconds.kind {
            return Some(Expr {
                ty: Scalar::Time,
                kind: ExprKind::Constant(Value::Int(n.saturating_mul(MILLISECOND))),
                range,
            });
        }
        let one = Expr {
            ty: Scalar::Time,
            kind: ExprKind::Constant(Value::Int(MILLISECOND)),
            range,
        };
        let kind = ExprKind::Binary(BinaryOperator::Mul, Box::new(one), Box::new(milliseconds));
        Some(Expr {
            ty: Scalar::Time,
            kind,
            range,
        })
    }
}

fn access(direction: Direction) -> Access {
    match direction {
        Direction::In => Access::Read,
        Direction::Out => Access::Write,
        Direction::InOut => Access::ReadWrite,
    }
}

fn search_operator(name: &str) -> Option<Op> {
    Some(match name.to_ascii_uppercase().as_str() {
        "EQ" | "EQU" => Op::Eq,
        "NE" | "NEQ" => Op::Ne,
        "GT" | "GRT" => Op::Gt,
        "GE" | "GEQ" => Op::Ge,
        "LT" | "LES" => Op::Lt,
        "LE" | "LEQ" => Op::Le,
        _ => return None,
    })
}

/// Whether a `[SEARCH]` compares with EQ or NE.
fn asks_for_equality(bound: BlockAt<'_>) -> bool {
    let mut operands = bound.facts.operands.iter().zip(bound.formals.iter());
    operands.any(|(written, formal)| {
        let is_operator =
            matches!(formal, Formal::Operand(operand) if operand.accepts == Accepts::SearchOperator);
        let name = match &written.value.kind {
            NodeKind::Name(name) => name.as_str(),
            _ => "",
        };
        is_operator && ["EQ", "NE"].iter().any(|equal| name.eq_ignore_ascii_case(equal))
    })
}

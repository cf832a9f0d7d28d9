//! Values and expressions, brought to the type that their place asks for (LANGUAGE §5.2).

use super::Resolver;
use super::enumeration::NamedValue;
use crate::findings::excerpt;
use crate::program::{BinaryOperator, Expr, ExprKind, UnaryOperator};
use crate::rules::{bad_operand, type_mismatch};
use crate::values::callable::is_callable;
use crate::values::types::{Scalar, common, passes};
use crate::values::value::Value;
use crate::written::constant::{self, literal_problem, natural_type, signed_literal};
use crate::written::facts::{Node, NodeKind, Operator, Word};
use ladder_instructions::{Accepts, Op, Shape, Truth, TypeClass, lookup};

impl Resolver<'_, '_> {
    /// A literal in a type.
    pub(super) fn literal_in(&mut self, node: &Node, ty: Scalar) -> Option<Expr> {
        let (literal, negative) = signed_literal(node)?;
        let value = match literal {
            Ok(literal) => constant::place(literal, negative, ty, node.range),
            Err(problem) => Err(literal_problem(problem, node.range)),
        };
        match value {
            Ok(value) => Some(self.constant_expr(value, ty, node.range)),
            Err(problem) => {
                let diagnostic = crate::rules::literals::diagnostic(&problem.moved_by(self.base));
                self.report(diagnostic);
                None
            }
        }
    }

    /// One value (a tag or a literal, no expression) that passes to a type.
    pub(super) fn value(&mut self, node: &Node, ty: Scalar) -> Option<Expr> {
        if signed_literal(node).is_some() {
            return self.literal_in(node, ty);
        }
        match self.named_value(node, Some(ty)) {
            NamedValue::No => {}
            NamedValue::Wrong => return None,
            NamedValue::Is(value) => return self.pass(value, ty),
        }
        if !self.is_simple(node) {
            return None;
        }
        let (place, own) = self.place(node)?;
        let read = Expr {
            ty: own,
            kind: ExprKind::Read(place),
            range: self.at(node.range),
        };
        self.pass(read, ty)
    }

    /// Whether the node is a tag or literal; says so if it is more.
    fn is_simple(&mut self, node: &Node) -> bool {
        let expression = matches!(
            node.kind,
            NodeKind::Unary(..) | NodeKind::Binary(..) | NodeKind::Call(..)
        );
        if expression {
            self.report(bad_operand::expression(self.at(node.range)));
        }
        !expression && !matches!(node.kind, NodeKind::Missing)
    }

    /// A value that passes to a type without `[TYP]`.
    fn pass(&mut self, expr: Expr, ty: Scalar) -> Option<Expr> {
        if expr.ty == ty || (expr.ty.is_string() && ty.is_string()) {
            return Some(expr);
        }
        if self.semantics().truth == Truth::NotZero && ty == Scalar::Bool && expr.ty.is_number() {
            return Some(not_zero(expr));
        }
        let is_digit = self.semantics().truth == Truth::NotZero && expr.ty == Scalar::Bool && ty.is_integer();
        if !is_digit && !passes(expr.ty, ty) {
            let named = self.operand.filter(|operand| operand.range == expr.range);
            let hidden = self.hidden_value(expr.range, expr.ty, ty);
            self.report(match (hidden, named) {
                (Some(hidden), _) => hidden,
                (None, Some(operand)) => {
                    let given = excerpt::text(&self.context.parse, operand.range);
                    let place = (operand.name, &*operand.block.head_text());
                    type_mismatch::does_not_pass_for(&given, place, expr.ty, ty, expr.range)
                }
                (None, None) => type_mismatch::does_not_pass(expr.ty, ty, expr.range),
            });
            return None;
        }
        let range = expr.range;
        Some(Expr {
            ty,
            kind: ExprKind::Pass(Box::new(expr)),
            range,
        })
    }

    /// One value in its own type; a literal in the type that it has by itself.
    pub(super) fn natural(&mut self, node: &Node) -> Option<Expr> {
        if let Some((literal, negative)) = signed_literal(node) {
            let ty = literal
                .as_ref()
                .map_or(Scalar::Dint, |literal| natural_type(literal, negative));
            return self.literal_in(node, ty);
        }
        match self.named_value(node, None) {
            NamedValue::No => {}
            NamedValue::Wrong => return None,
            NamedValue::Is(value) => return Some(value),
        }
        if !self.is_simple(node) {
            return None;
        }
        let (place, ty) = self.place(node)?;
        Some(Expr {
            ty,
            kind: ExprKind::Read(place),
            range: self.at(node.range),
        })
    }

    /// The type that a node has by itself; none for untyped literals and for what cannot be known.
    pub(super) fn own_type(&self, node: &Node) -> Option<Scalar> {
        if let Some((literal, _)) = signed_literal(node) {
            return match literal {
                Ok(crate::values::literal::Literal::Int(_) | crate::values::literal::Literal::Real(_))
                | Err(_) => None,
                Ok(literal) => Some(natural_type(literal, false)),
            };
        }
        match &node.kind {
            NodeKind::Paren(inner) | NodeKind::Unary(_, inner) => self.own_type(inner),
            NodeKind::Name(name) if name.eq_ignore_ascii_case("PI") => Some(Scalar::Lreal),
            NodeKind::Binary(operator, left, right) => match operator {
                op if comparison(*op).is_some() => Some(Scalar::Bool),
                Operator::Shl | Operator::Shr => self.own_type(left),
                _ => match (self.own_type(left), self.own_type(right)) {
                    // A TIME by a number, and a number by a TIME, are TIMEs.
                    (Some(Scalar::Time), Some(_)) | (Some(_), Some(Scalar::Time))
                        if matches!(operator, Operator::Mul | Operator::Div) =>
                    {
                        Some(Scalar::Time)
                    }
                    (Some(a), Some(b)) => common(a, b),
                    (a, b) => a.or(b),
                },
            },
            NodeKind::Call(name, arguments) => {
                let row = lookup(Shape::Logical, &name.text).last();
                match row
                    .and_then(|row| row.operands.first())
                    .map(|operand| operand.accepts)
                {
                    Some(Accepts::Result(TypeClass::Integer)) => Some(Scalar::Dint),
                    _ => arguments
                        .iter()
                        .enumerate()
                        .filter(|(index, _)| !row.is_some_and(|row| is_choice(row, *index)))
                        .filter_map(|(_, argument)| self.own_type(argument))
                        .reduce(|a, b| common(a, b).unwrap_or(a)),
                }
            }
            NodeKind::Range(..) => self.part_type(node).and_then(|(ty, _)| ty.scalar()),
            _ => self.place_type(node),
        }
    }

    /// An expression of `[CALC]` in a type: arithmetic is done in it.
    pub(super) fn expression(&mut self, node: &Node, ty: Scalar) -> Option<Expr> {
        if signed_literal(node).is_some() {
            return self.literal_in(node, ty);
        }
        match self.named_value(node, Some(ty)) {
            NamedValue::No => {}
            NamedValue::Wrong => return None,
            NamedValue::Is(value) => return self.pass(value, ty),
        }
        let range = self.at(node.range);
        let kind = match &node.kind {
            NodeKind::Paren(inner) => return self.expression(inner, ty),
            NodeKind::Name(name) if name.eq_ignore_ascii_case("PI") => {
                if !ty.is_real() {
                    self.report(type_mismatch::wrong(
                        range,
                        format!("PI is a real number, the result is {ty}"),
                    ));
                    return None;
                }
                let pi = std::f64::consts::PI;
                let value = if ty == Scalar::Real {
                    f64::from(pi as f32)
                } else {
                    pi
                };
                ExprKind::Constant(Value::Real(value))
            }
            NodeKind::Unary(operator, inner) => {
                let (operator, fits) = match operator {
                    Operator::Not => (
                        UnaryOperator::Not,
                        ty == Scalar::Bool || ty.is_bits() || ty.is_integer(),
                    ),
                    _ => (UnaryOperator::Minus, ty.is_number() || ty == Scalar::Time),
                };
                if !fits {
                    self.report(type_mismatch::operator(range, ty));
                    return None;
                }
                ExprKind::Unary(operator, Box::new(self.expression(inner, ty)?))
            }
            NodeKind::Binary(operator, left, right) => {
                return match comparison(*operator) {
                    Some(op) => self.comparison(op, left, right, node, ty),
                    None => self.binary(*operator, left, right, node, ty),
                };
            }
            NodeKind::Call(name, arguments) => return self.call(name, arguments, node, ty),
            NodeKind::Missing => return None,
            _ => {
                let (place, own) = self.place(node)?;
                return self.pass(
                    Expr {
                        ty: own,
                        kind: ExprKind::Read(place),
                        range,
                    },
                    ty,
                );
            }
        };
        Some(Expr { ty, kind, range })
    }

    fn binary(
        &mut self,
        operator: Operator,
        left: &Node,
        right: &Node,
        node: &Node,
        ty: Scalar,
    ) -> Option<Expr> {
        let range = self.at(node.range);
        let logic = ty == Scalar::Bool || ty.is_bits() || ty.is_integer();
        let (operator, fits) = match operator {
            Operator::Or => (BinaryOperator::Or, logic),
            Operator::Xor => (BinaryOperator::Xor, logic),
            Operator::And => (BinaryOperator::And, logic),
            Operator::Shl => (BinaryOperator::Shl, ty.is_bits() || ty.is_integer()),
            Operator::Shr => (BinaryOperator::Shr, ty.is_bits() || ty.is_integer()),
            Operator::Add => (BinaryOperator::Add, ty.is_number() || ty == Scalar::Time),
            Operator::Sub => (BinaryOperator::Sub, ty.is_number() || ty == Scalar::Time),
            Operator::Mul => (BinaryOperator::Mul, ty.is_number() || ty == Scalar::Time),
            Operator::Div => (BinaryOperator::Div, ty.is_number() || ty == Scalar::Time),
            Operator::Mod => (BinaryOperator::Mod, ty.is_number()),
            _ => (BinaryOperator::Power, ty.is_number()),
        };
        if !fits {
            self.report(type_mismatch::operator(range, ty));
            return None;
        }
        let by_number = ty == Scalar::Time && matches!(operator, BinaryOperator::Mul | BinaryOperator::Div);
        let (left, right) = match operator {
            BinaryOperator::Shl | BinaryOperator::Shr => {
                (self.expression(left, ty), self.integer_expression(right))
            }
            _ if by_number => {
                // TIME by a number; for MUL also the other way round.
                let number_first =
                    self.own_type(left).is_none_or(Scalar::is_number) && operator == BinaryOperator::Mul;
                let (time, number) = if number_first {
                    (right, left)
                } else {
                    (left, right)
                };
                let time = self.expression(time, ty);
                let number = self.number(number);
                (time, number)
            }
            _ => (self.expression(left, ty), self.expression(right, ty)),
        };
        Some(Expr {
            ty,
            kind: ExprKind::Binary(operator, Box::new(left?), Box::new(right?)),
            range,
        })
    }

    /// A number in its own type, next to a TIME.
    pub(super) fn number(&mut self, node: &Node) -> Option<Expr> {
        let ty = self.own_type(node).unwrap_or_else(|| match signed_literal(node) {
            Some((Ok(literal), negative)) => natural_type(literal, negative),
            _ => Scalar::Dint,
        });
        if !ty.is_number() {
            self.report(type_mismatch::wrong(
                self.at(node.range),
                format!("a number is expected here, this is {ty}"),
            ));
            return None;
        }
        self.expression(node, ty)
    }

    /// An integer expression in its own type.
    fn integer_expression(&mut self, node: &Node) -> Option<Expr> {
        match self.own_type(node) {
            Some(ty) if ty.is_integer() => self.expression(node, ty),
            Some(_) => self.integer(node),
            None => self.expression(node, Scalar::Dint),
        }
    }

    /// Two sides compared in their own common type.
    fn comparison(&mut self, op: Op, left: &Node, right: &Node, node: &Node, ty: Scalar) -> Option<Expr> {
        let range = self.at(node.range);
        if ty != Scalar::Bool {
            self.report(type_mismatch::wrong(
                range,
                format!("a comparison gives BOOL, the result is {ty}"),
            ));
            return None;
        }
        let (a, b) = (self.own_type(left), self.own_type(right));
        let (left_type, right_type) = match (a, b) {
            (Some(a), Some(b)) => match common(a, b) {
                Some(common) => (common, common),
                // Two integers that none holds both of, as LINT and ULINT: by value.
                None if a.is_integer() && b.is_integer() => (a, b),
                None => {
                    let hidden = self.hidden_value(self.at(left.range), a, b);
                    let hidden = hidden.or_else(|| self.hidden_value(self.at(right.range), b, a));
                    self.report(hidden.unwrap_or_else(|| type_mismatch::cannot_compare(a, b, range)));
                    return None;
                }
            },
            (Some(one), None) | (None, Some(one)) => (one, one),
            (None, None) => {
                let natural = |node: &Node| match signed_literal(node) {
                    Some((Ok(literal), negative)) => natural_type(literal, negative),
                    _ => Scalar::Dint,
                };
                let both = common(natural(left), natural(right)).unwrap_or(Scalar::Lreal);
                (both, both)
            }
        };
        let has_no_order = |ty: &Scalar| *ty == Scalar::Bool || ty.is_enumeration();
        if let Some(ty) = [left_type, right_type].into_iter().find(has_no_order)
            && !matches!(op, Op::Eq | Op::Ne)
        {
            self.report(type_mismatch::no_order(ty, range));
            return None;
        }
        let left = self.expression(left, left_type);
        let right = self.expression(right, right_type);
        Some(Expr {
            ty,
            kind: ExprKind::Compare(op, Box::new(left?), Box::new(right?)),
            range,
        })
    }

    /// A function by name: the table's row without its result.
    fn call(&mut self, name: &Word, arguments: &[Node], node: &Node, ty: Scalar) -> Option<Expr> {
        let range = self.at(node.range);
        if name.text.eq_ignore_ascii_case("SUM") {
            let [argument] = arguments else {
                self.report(bad_operand::wrong(range, "SUM takes one range: SUM(a[1..9])"));
                return None;
            };
            let summed = self.range(argument, false)?;
            if !passes(summed.element, ty) || !(ty.is_number() || ty == Scalar::Time) {
                self.report(type_mismatch::does_not_pass(summed.element, ty, range));
                return None;
            }
            return Some(Expr {
                ty,
                kind: ExprKind::Sum(summed),
                range,
            });
        }
        let count = arguments.len();
        // A function has a result and takes the rest as values.
        let row = lookup(Shape::Logical, &name.text).find(|row| is_callable(row));
        let Some(row) = row else {
            self.report(bad_operand::unknown_function(&name.text, self.at(name.range)));
            return None;
        };
        if !row.takes(count + 1) {
            self.report(bad_operand::wrong(
                range,
                format!("{} is written {}", row.mnemonic, call_signature(row)),
            ));
            return None;
        }
        if let Some(Accepts::Result(class)) = row.operands.first().map(|operand| operand.accepts)
            && !super::argument::in_class(ty, class)
        {
            self.report(type_mismatch::wrong(
                range,
                format!("{} does not give {ty}", row.mnemonic),
            ));
            return None;
        }
        let mut values = Vec::with_capacity(count);
        for (index, argument) in arguments.iter().enumerate() {
            let formal = row.positional(index + 1)?;
            let value = match formal.accepts {
                Accepts::Bool => self.expression(argument, Scalar::Bool),
                Accepts::Integer => self.integer_expression(argument),
                Accepts::Number => self.number(argument),
                Accepts::String => {
                    self.expression(argument, Scalar::String(crate::values::types::DEFAULT_STRING))
                }
                _ => self.expression(argument, ty),
            };
            values.push(value);
        }
        let values: Option<Vec<Expr>> = values.into_iter().collect();
        Some(Expr {
            ty,
            kind: ExprKind::Call(row.op, values?),
            range,
        })
    }
}

/// Whether an argument of a function only chooses or counts, and takes no part in the type.
fn is_choice(row: &ladder_instructions::Instruction, argument: usize) -> bool {
    let formal = row.positional(argument + 1);
    formal.is_some_and(|formal| matches!(formal.accepts, Accepts::Bool | Accepts::Integer))
}

/// `LIMIT(low, a, high)`
fn call_signature(row: &ladder_instructions::Instruction) -> String {
    let names: Vec<&str> = row.operands.iter().skip(1).map(|operand| operand.name).collect();
    let more = if row.repeats() { ", ..." } else { "" };
    format!("{}({}{more})", row.mnemonic, names.join(", "))
}

/// Whether a number is not 0.
fn not_zero(number: Expr) -> Expr {
    let (ty, range) = (number.ty, number.range);
    let zero = if ty.is_real() {
        Value::Real(0.0)
    } else {
        Value::Int(0)
    };
    let zero = Expr {
        ty,
        kind: ExprKind::Constant(zero),
        range,
    };
    Expr {
        ty: Scalar::Bool,
        kind: ExprKind::Compare(Op::Ne, Box::new(number), Box::new(zero)),
        range,
    }
}

/// The comparison that an operator means.
fn comparison(operator: Operator) -> Option<Op> {
    Some(match operator {
        Operator::Equal => Op::Eq,
        Operator::NotEqual => Op::Ne,
        Operator::Less => Op::Lt,
        Operator::LessEqual => Op::Le,
        Operator::Greater => Op::Gt,
        Operator::GreaterEqual => Op::Ge,
        _ => return None,
    })
}

//! Expressions: arithmetic, logic, comparisons, functions.

use crate::arithmetic::wrapped;
use crate::checks::{Check, Checks, is_within};
use crate::place::{bits_of, conversion};
use crate::project::Result;
use crate::term::{Binding, Term};
use crate::unit::Unit;
use ladder_analysis::program::{Expr, ExprKind, UnaryOperator};
use ladder_analysis::values::types::{Scalar, common};
use ladder_analysis::values::value::Value;
use ladder_instructions::Op;

impl Unit<'_, '_> {
    /// The value of an expression, in its type.
    pub(crate) fn value(&mut self, expr: &Expr, checks: &mut Checks) -> Result<Term> {
        match &expr.kind {
            ExprKind::Constant(value) => Ok(Term::whole(self.project.literal(value, expr.ty))),
            ExprKind::Read(place) => self.read(place, checks),
            ExprKind::Pass(inner) => {
                if let ExprKind::Constant(Value::Int(_)) = inner.kind
                    && !inner.ty.is_bits()
                    && !expr.ty.is_bits()
                {
                    let ExprKind::Constant(value) = &inner.kind else {
                        unreachable!("it is one")
                    };
                    return Ok(Term::whole(self.project.literal(value, expr.ty)));
                }
                let value = self.value(inner, checks)?;
                let value = self.settle(value, inner.ty, checks);
                Ok(pass(value, inner.ty, expr.ty))
            }
            ExprKind::Unary(UnaryOperator::Minus, inner) => {
                let value = self.value(inner, checks)?;
                Ok(negative(&value, expr.ty))
            }
            ExprKind::Unary(UnaryOperator::Not, inner) => {
                let value = self.value(inner, checks)?;
                Ok(self.not(value, expr.ty, checks))
            }
            ExprKind::Binary(operator, a, b) => self.function(operator.op(), expr.ty, &[a, b], checks),
            ExprKind::Compare(op, a, b) => self.comparison(*op, a, b, checks),
            ExprKind::Call(op, arguments) => {
                let arguments: Vec<&Expr> = arguments.iter().collect();
                self.function(*op, expr.ty, &arguments, checks)
            }
            ExprKind::Sum(range) => self.sum(range, expr.ty, checks),
            ExprKind::Offset(_) => self.stop("an index that is no number"),
        }
    }

    /// The same, as one of its type.
    pub(crate) fn settled(&mut self, expr: &Expr, checks: &mut Checks) -> Result<Term> {
        let term = self.value(expr, checks)?;
        Ok(self.settle(term, expr.ty, checks))
    }

    fn not(&mut self, value: Term, ty: Scalar, checks: &mut Checks) -> Term {
        if !ty.is_integer() {
            return value.not();
        }
        let value = self.settle(value, ty, checks);
        let bits = bits_of(ty);
        let inverted = Term::call(&conversion(ty, bits), &[&value]).not();
        Term::call(&conversion(bits, ty), &[&inverted])
    }

    /// A comparison of two values; whole numbers of two types by value.
    pub(crate) fn comparison(&mut self, op: Op, a: &Expr, b: &Expr, checks: &mut Checks) -> Result<Term> {
        let (left, right) = (self.settled(a, checks)?, self.settled(b, checks)?);
        Ok(compare(op, (&left, a.ty), (&right, b.ty)))
    }

    /// The value of an instruction or function, in a type.
    pub(crate) fn function(
        &mut self,
        op: Op,
        ty: Scalar,
        all: &[&Expr],
        checks: &mut Checks,
    ) -> Result<Term> {
        match op {
            Op::Mov | Op::Calc => self.value(all[0], checks),
            Op::Typ => self.converted(ty, all[0], checks),
            Op::Wrap => self.wrapped(ty, all[0], checks),
            Op::Add | Op::Sub | Op::Mul | Op::Div | Op::Mod | Op::Exp | Op::Min | Op::Max => {
                self.arithmetic(op, ty, all, checks)
            }
            Op::And | Op::Or | Op::Xor => self.logic(op, ty, all, checks),
            Op::Not => {
                let value = self.value(all[0], checks)?;
                Ok(self.not(value, ty, checks))
            }
            Op::Neg => {
                let value = self.value(all[0], checks)?;
                Ok(negative(&value, ty))
            }
            Op::Sel if ty.is_enumeration() => {
                let terms = self.settled_all(all, checks)?;
                let [chooser, no, yes] = terms.as_slice() else {
                    return self.stop("a choice of nothing");
                };
                Ok(self.chosen_value(std::slice::from_ref(chooser), &[yes, no], ty, checks))
            }
            Op::Limit | Op::Sel => {
                let terms = self.settled_all(all, checks)?;
                let name = if op == Op::Sel { "SEL" } else { "LIMIT" };
                let references: Vec<&Term> = terms.iter().collect();
                Ok(Term::call(name, &references))
            }
            Op::Mux | Op::Lut => {
                let [selector, values @ ..] = all else {
                    return self.stop("a choice of nothing");
                };
                let chosen = self.value(selector, checks)?;
                let chosen = self.named(chosen, selector.ty, checks);
                let values = self.settled_all(values, checks)?;
                let last = values.len() as i128 - 1;
                checks.extend(is_within(&chosen, 0, last, selector.ty).map(Check::Holds));
                if ty.is_enumeration() {
                    let is = |number: usize| {
                        let number = Term::whole(number.to_string());
                        Term::binary(&chosen, "=", &number, Binding::Equality)
                    };
                    let conditions: Vec<Term> = (0..values.len().saturating_sub(1)).map(is).collect();
                    let values: Vec<&Term> = values.iter().collect();
                    return Ok(self.chosen_value(&conditions, &values, ty, checks));
                }
                let mut arguments = vec![&chosen];
                arguments.extend(&values);
                let mut term = Term::call("MUX", &arguments);
                term.is_risky = true;
                Ok(term)
            }
            Op::Shl | Op::Shr | Op::Rol | Op::Ror => self.shift(op, ty, all, checks),
            Op::Pwl => self.curve(ty, all, checks),
            Op::Len
            | Op::Left
            | Op::Right
            | Op::Mid
            | Op::Concat
            | Op::Insert
            | Op::Delete
            | Op::Replace
            | Op::Find => self.of_texts(op, ty, all, checks),
            _ => self.function_of_one(op, ty, all[0], checks),
        }
    }

    /// The value after the first condition that holds, or the last one: SEL and MUX take no enumerations everywhere.
    fn chosen_value(
        &mut self,
        conditions: &[Term],
        values: &[&Term],
        ty: Scalar,
        checks: &mut Checks,
    ) -> Term {
        let name = self.value_temporary(ty);
        let mut lines = Vec::new();
        for (number, (condition, value)) in conditions.iter().zip(values).enumerate() {
            let word = if number == 0 { "IF" } else { "ELSIF" };
            lines.push(format!("{word} {} THEN", condition.text));
            lines.push(format!("    {name} := {};", value.text));
        }
        let last = values.last().map_or("", |value| value.text.as_str());
        lines.extend([
            "ELSE".to_owned(),
            format!("    {name} := {last};"),
            "END_IF;".to_owned(),
        ]);
        checks.push(Check::Lines(lines));
        Term::variable(&name)
    }

    pub(crate) fn settled_all(&mut self, all: &[&Expr], checks: &mut Checks) -> Result<Vec<Term>> {
        all.iter().map(|expr| self.settled(expr, checks)).collect()
    }

    fn logic(&mut self, op: Op, ty: Scalar, all: &[&Expr], checks: &mut Checks) -> Result<Term> {
        let bits = bits_of(ty);
        let mut terms = Vec::new();
        for expr in all {
            let term = self.settled(expr, checks)?;
            terms.push(if ty.is_integer() {
                Term::call(&conversion(ty, bits), &[&term])
            } else {
                term
            });
        }
        let (sign, binding) = match op {
            Op::And => ("AND", Binding::And),
            Op::Or => ("OR", Binding::Or),
            _ => ("XOR", Binding::Xor),
        };
        let mut terms = terms.into_iter();
        let first = terms.next().unwrap_or_else(|| Term::whole("FALSE"));
        let value = terms.fold(first, |value, next| Term::binary(&value, sign, &next, binding));
        Ok(if ty.is_integer() {
            Term::call(&conversion(bits, ty), &[&value])
        } else {
            value
        })
    }
}

/// A value in a type that it passes to without `[TYP]`.
pub(crate) fn pass(value: Term, from: Scalar, to: Scalar) -> Term {
    if from == to || (from.is_string() && to.is_string()) {
        return value;
    }
    // A literal is of the type that its place asks for.
    if from.is_integer() && to.is_integer() && value.text.parse::<i128>().is_ok() {
        return value;
    }
    Term::call(&conversion(from, to), &[&value])
}

/// A comparison of two settled values.
pub(crate) fn compare(op: Op, (a, a_ty): (&Term, Scalar), (b, b_ty): (&Term, Scalar)) -> Term {
    let (sign, binding) = match op {
        Op::Ne => ("<>", Binding::Equality),
        Op::Gt => (">", Binding::Order),
        Op::Ge => (">=", Binding::Order),
        Op::Lt => ("<", Binding::Order),
        Op::Le => ("<=", Binding::Order),
        _ => ("=", Binding::Equality),
    };
    if a_ty == b_ty || (a_ty.is_string() && b_ty.is_string()) {
        return Term::binary(a, sign, b, binding);
    }
    if a_ty.is_real() || b_ty.is_real() {
        let meet = common(a_ty, b_ty).unwrap_or(Scalar::Lreal);
        let (a, b) = (pass(a.clone(), a_ty, meet), pass(b.clone(), b_ty, meet));
        return Term::binary(&a, sign, &b, binding);
    }
    let zero = Term::whole("0");
    let mixed = |signed: &Term, signed_ty: Scalar, is_left: bool| {
        // A negative number is less than any without a sign.
        let wide = pass(signed.clone(), signed_ty, Scalar::Lint);
        let wide = Term::call(&conversion(Scalar::Lint, Scalar::Ulint), &[&wide]);
        let compared = if is_left {
            Term::binary(&wide, sign, b, binding)
        } else {
            Term::binary(a, sign, &wide, binding)
        };
        let holds_if_negative = match op {
            Op::Ne => true,
            Op::Lt | Op::Le => is_left,
            Op::Gt | Op::Ge => !is_left,
            _ => false,
        };
        if holds_if_negative {
            let negative = Term::binary(signed, "<", &zero, Binding::Order);
            Term::binary(&negative, "OR", &compared, Binding::Or)
        } else {
            let positive = Term::binary(signed, ">=", &zero, Binding::Order);
            Term::binary(&positive, "AND", &compared, Binding::And)
        }
    };
    if b_ty == Scalar::Ulint && a_ty.is_signed() {
        return mixed(a, a_ty, true);
    }
    if a_ty == Scalar::Ulint && b_ty.is_signed() {
        return mixed(b, b_ty, false);
    }
    let wide = if a_ty == Scalar::Ulint || b_ty == Scalar::Ulint {
        Scalar::Ulint
    } else {
        Scalar::Lint
    };
    let (a, b) = (pass(a.clone(), a_ty, wide), pass(b.clone(), b_ty, wide));
    Term::binary(&a, sign, &b, binding)
}

/// `-a`
fn negative(value: &Term, ty: Scalar) -> Term {
    if let (Some(_), Ok(known)) = (ty.bounds(), value.text.parse::<i128>()) {
        return Term::whole(wrapped(-known, ty).to_string());
    }
    match ty {
        Scalar::Time => Term::binary(&Term::whole("T#0s"), "-", value, Binding::Sum),
        _ if ty.is_real() => value.negative(),
        _ if ty.is_signed() => value.negative().raw(),
        _ => Term::binary(&Term::whole("0"), "-", value, Binding::Sum).raw(),
    }
}

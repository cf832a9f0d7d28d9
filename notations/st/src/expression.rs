//! Expressions: arithmetic, logic, comparisons, functions.

use crate::checks::{Check, Checks, is_within};
use crate::place::{bits_of, conversion};
use crate::project::Result;
use crate::term::{Binding, Term};
use crate::unit::Unit;
use ladder_analysis::program::{BinaryOperator, Expr, ExprKind, UnaryOperator};
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
                self.negative(value, expr.ty)
            }
            ExprKind::Unary(UnaryOperator::Not, inner) => {
                let value = self.value(inner, checks)?;
                Ok(self.not(value, expr.ty, checks))
            }
            ExprKind::Binary(operator, a, b) => {
                let op = match operator {
                    BinaryOperator::Or => Op::Or,
                    BinaryOperator::Xor => Op::Xor,
                    BinaryOperator::And => Op::And,
                    BinaryOperator::Shl => Op::Shl,
                    BinaryOperator::Shr => Op::Shr,
                    BinaryOperator::Add => Op::Add,
                    BinaryOperator::Sub => Op::Sub,
                    BinaryOperator::Mul => Op::Mul,
                    BinaryOperator::Div => Op::Div,
                    BinaryOperator::Mod => Op::Mod,
                    BinaryOperator::Power => Op::Exp,
                };
                self.function(op, expr.ty, &[a, b], checks)
            }
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

    fn negative(&mut self, value: Term, ty: Scalar) -> Result<Term> {
        Ok(match ty {
            Scalar::Time => Term::binary(&Term::whole("T#0s"), "-", &value, Binding::Sum),
            _ if ty.is_real() => value.negative(),
            _ if ty.is_signed() => value.negative().raw(),
            _ => Term::binary(&Term::whole("0"), "-", &value, Binding::Sum).raw(),
        })
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
                self.negative(value, ty)
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

    fn settled_all(&mut self, all: &[&Expr], checks: &mut Checks) -> Result<Vec<Term>> {
        all.iter().map(|expr| self.settled(expr, checks)).collect()
    }

    fn arithmetic(&mut self, op: Op, ty: Scalar, all: &[&Expr], checks: &mut Checks) -> Result<Term> {
        let mut all = all.to_vec();
        if op == Op::Mul && ty == Scalar::Time {
            all.sort_by_key(|operand| operand.ty != Scalar::Time);
        }
        if op == Op::Exp {
            let mut terms = self.settled_all(&all, checks)?;
            let mut power = terms.pop().unwrap_or_else(|| Term::whole("1"));
            while let Some(base) = terms.pop() {
                power = self.settle(power, ty, checks);
                power = self.to_the_power(&base, power, ty, checks)?;
            }
            return Ok(power);
        }
        let mut value = self.value(all[0], checks)?;
        for operand in &all[1..] {
            let next = self.value(operand, checks)?;
            value = self.step(op, ty, value, (next, operand.ty), checks)?;
        }
        Ok(value)
    }

    fn step(
        &mut self,
        op: Op,
        ty: Scalar,
        a: Term,
        (b, b_ty): (Term, Scalar),
        checks: &mut Checks,
    ) -> Result<Term> {
        if b_ty.is_real() && !ty.is_real() {
            return self.stop(
                "a TIME times or by a real number, which systems round differently: use a whole number",
            );
        }
        // A TIME is 64 bits of nanoseconds here, and what a system has there.
        let may_leave = ty.is_real() || ty.is_integer();
        let modular = |sign: &str, binding| {
            let term = Term::binary(&a, sign, &b, binding);
            if may_leave { term.raw() } else { term }
        };
        match op {
            Op::Add => Ok(modular("+", Binding::Sum)),
            Op::Sub => Ok(modular("-", Binding::Sum)),
            Op::Mul => Ok(modular("*", Binding::Product)),
            Op::Min | Op::Max => {
                let (a, b) = (self.settle(a, ty, checks), self.settle(b, ty, checks));
                Ok(Term::call(if op == Op::Min { "MIN" } else { "MAX" }, &[&a, &b]))
            }
            Op::Mod if ty.is_real() => {
                self.stop("a remainder of real numbers, which Structured Text has no operator for")
            }
            _ => self.quotient(op, ty, a, (b, b_ty), checks),
        }
    }

    /// `a / b` and `a MOD b`: by 0 is a fault, and the smallest number by -1 stays what it is.
    fn quotient(
        &mut self,
        op: Op,
        ty: Scalar,
        a: Term,
        (b, b_ty): (Term, Scalar),
        checks: &mut Checks,
    ) -> Result<Term> {
        let a = self.settle(a, ty, checks);
        let sign = if op == Op::Div { "/" } else { "MOD" };
        let constant: Option<f64> = b.text.parse().ok();
        if let Some(by) = constant
            && by != 0.0
            && by != -1.0
        {
            let term = Term::binary(&a, sign, &b, Binding::Product);
            return Ok(if ty.is_real() { term.raw() } else { term });
        }
        let b = self.named(b, b_ty, checks);
        let zero = if b_ty.is_real() { "0.0" } else { "0" };
        checks.push(Check::Holds(Term::binary(
            &b,
            "<>",
            &Term::whole(zero),
            Binding::Equality,
        )));
        let mut term = if ty.is_signed() && ty == b_ty {
            let piece = if op == Op::Div { "LADDER_DIV" } else { "LADDER_MOD" };
            self.project.pieces.insert(piece);
            let wide = |term: &Term| pass(term.clone(), ty, Scalar::Lint);
            let quotient = Term::call(piece, &[&wide(&a), &wide(&b)]);
            match ty {
                Scalar::Lint => quotient,
                _ => Term::call(&conversion(Scalar::Lint, ty), &[&quotient]),
            }
        } else {
            Term::binary(&a, sign, &b, Binding::Product)
        };
        term.is_risky = true;
        Ok(if ty.is_real() { term.raw() } else { term })
    }

    fn to_the_power(&mut self, base: &Term, exponent: Term, ty: Scalar, checks: &mut Checks) -> Result<Term> {
        if ty.is_real() {
            return Ok(Term::call("EXPT", &[base, &exponent]).raw());
        }
        let exponent = self.named(exponent, ty, checks);
        if ty.is_signed() {
            let holds = Term::binary(&exponent, ">=", &Term::whole("0"), Binding::Order);
            if exponent.text.parse::<u64>().is_err() {
                checks.push(Check::Holds(holds));
            }
        }
        if ty == Scalar::Ulint {
            return self.stop("a power of ULINT numbers: use LINT");
        }
        self.project.pieces.insert("LADDER_POWER");
        let (base, exponent) = (
            pass(base.clone(), ty, Scalar::Lint),
            pass(exponent, ty, Scalar::Lint),
        );
        let power = Term::call("LADDER_POWER", &[&base, &exponent]);
        Ok(match ty {
            Scalar::Lint => power,
            _ => Term::call(&conversion(Scalar::Lint, ty), &[&power]),
        })
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

    fn shift(&mut self, op: Op, ty: Scalar, all: &[&Expr], checks: &mut Checks) -> Result<Term> {
        let [a, n] = all else {
            return self.stop("a shift without a count");
        };
        let bits = bits_of(ty);
        let value = self.settled(a, checks)?;
        let value = if ty == bits {
            value
        } else {
            Term::call(&conversion(ty, bits), &[&value])
        };
        let count = self.settled(n, checks)?;
        let count = self.named(count, n.ty, checks);
        let width = i128::from(ty.width());
        let known: Option<i128> = count.text.parse().ok();
        if known.is_none_or(|known| known < 0) && (n.ty.is_signed() || n.ty.is_bits()) {
            checks.push(Check::Holds(Term::binary(
                &count,
                ">=",
                &Term::whole("0"),
                Binding::Order,
            )));
        }
        let name = match op {
            Op::Shl => "SHL",
            Op::Shr => "SHR",
            Op::Rol => "ROL",
            _ => "ROR",
        };
        let is_shift = matches!(op, Op::Shl | Op::Shr);
        let shifted = match known {
            Some(known) if is_shift && known >= width => Term::whole("16#0"),
            Some(known) => Term::call(
                name,
                &[&value, &Term::whole((known.rem_euclid(width)).to_string())],
            ),
            None if is_shift => {
                let most = Term::whole((width - 1).to_string());
                let within = Term::call("MIN", &[&count, &most]);
                let shifted = Term::call(name, &[&value, &within]);
                let is_far = Term::binary(&count, ">", &most, Binding::Order);
                Term::call(
                    "SEL",
                    &[&is_far, &shifted, &Term::whole(format!("{}#16#0", bits.name()))],
                )
            }
            None => {
                let within = Term::binary(&count, "MOD", &Term::whole(width.to_string()), Binding::Product);
                Term::call(name, &[&value, &within])
            }
        };
        Ok(if ty == bits {
            shifted
        } else {
            Term::call(&conversion(bits, ty), &[&shifted])
        })
    }

    fn function_of_one(&mut self, op: Op, ty: Scalar, operand: &Expr, checks: &mut Checks) -> Result<Term> {
        let value = self.settled(operand, checks)?;
        if op == Op::Abs && !ty.is_real() {
            let term = Term::call("ABS", &[&value]);
            return Ok(if ty.is_signed() { term.raw() } else { value });
        }
        if op == Op::Trunc {
            return self.truncated(ty, value, operand.ty, checks);
        }
        let single = ty == Scalar::Real;
        let number = |text: &str| Term::whole(text);
        let (name, holds) = match op {
            Op::Abs => ("ABS", None),
            Op::Sqrt => {
                let value = self.named(value.clone(), ty, checks);
                (
                    "SQRT",
                    Some((
                        value.clone(),
                        Term::binary(&value, ">=", &number("0.0"), Binding::Order),
                    )),
                )
            }
            Op::Ln | Op::Log => {
                let value = self.named(value.clone(), ty, checks);
                let name = if op == Op::Ln { "LN" } else { "LOG" };
                (
                    name,
                    Some((
                        value.clone(),
                        Term::binary(&value, ">", &number("0.0"), Binding::Order),
                    )),
                )
            }
            Op::Asin | Op::Acos => {
                let value = self.named(value.clone(), ty, checks);
                let size = Term::call("ABS", &[&value]);
                let name = if op == Op::Asin { "ASIN" } else { "ACOS" };
                (
                    name,
                    Some((value, Term::binary(&size, "<=", &number("1.0"), Binding::Order))),
                )
            }
            Op::Expe => ("EXP", None),
            Op::Sin => ("SIN", None),
            Op::Cos => ("COS", None),
            Op::Tan => ("TAN", None),
            Op::Atan => ("ATAN", None),
            Op::Rad | Op::Deg => {
                let pi = std::f64::consts::PI;
                let by = if op == Op::Rad { pi / 180.0 } else { 180.0 / pi };
                let by = if single {
                    format!("{:?}", by as f32)
                } else {
                    format!("{by:?}")
                };
                return Ok(Term::binary(&value, "*", &number(&by), Binding::Product).raw());
            }
            _ => return self.stop("an instruction that Structured Text has no words for"),
        };
        let may_leave = matches!(op, Op::Expe | Op::Tan);
        let term = match holds {
            Some((value, holds)) => {
                checks.push(Check::Holds(holds));
                let mut term = Term::call(name, &[&value]);
                term.is_risky = true;
                term
            }
            None => Term::call(name, &[&value]),
        };
        Ok(if may_leave { term.raw() } else { term })
    }

    /// Piecewise linear, held at both ends, computed in the widest type.
    fn curve(&mut self, ty: Scalar, all: &[&Expr], checks: &mut Checks) -> Result<Term> {
        let wide = if ty.is_real() { Scalar::Lreal } else { Scalar::Lint };
        if !ty.is_real() && !is_small_curve(ty, &all[1..]) {
            return self
                .stop("a curve whose numbers may be too large to be computed with: use INT, or LREAL");
        }
        let terms = self.settled_all(all, checks)?;
        let [x, points @ ..] = terms.as_slice() else {
            return self.stop("a curve without points");
        };
        let points: Vec<Term> = points.iter().map(|point| pass_wide(point, ty, wide)).collect();
        let x = self.held(&pass_wide(x, ty, wide), wide, checks);
        let y = self.value_temporary(wide);
        let (Some([x0, y0]), Some([_, last])) = (points.first_chunk::<2>(), points.last_chunk::<2>()) else {
            return self.stop("a curve without points");
        };
        let before = |x1: &Term| Term::binary(&x, "<", x1, Binding::Order).text;
        let minus = |a: &Term, b: &Term| Term::binary(a, "-", b, Binding::Sum);
        let times = |a: &Term, b: &Term| Term::binary(a, "*", b, Binding::Product);
        let mut lines = vec![
            format!("IF {} THEN", before(x0)),
            format!("    {y} := {};", y0.text),
        ];
        for (from, to) in points.chunks_exact(2).zip(points.chunks_exact(2).skip(1)) {
            let ([x0, y0], [x1, y1]) = ([&from[0], &from[1]], [&to[0], &to[1]]);
            let span = minus(x1, x0);
            let rise = times(&minus(y1, y0), &minus(&x, x0));
            let height = if ty.is_real() {
                Term::binary(
                    y0,
                    "+",
                    &Term::binary(&rise, "/", &span, Binding::Product),
                    Binding::Sum,
                )
            } else {
                let exact = Term::binary(&times(y0, &span), "+", &rise, Binding::Sum);
                Term::binary(&exact, "/", &span, Binding::Product)
            };
            lines.push(format!("ELSIF {} THEN", before(x1)));
            lines.push(format!("    {y} := {};", height.text));
        }
        lines.extend([
            "ELSE".into(),
            format!("    {y} := {};", last.text),
            "END_IF;".into(),
        ]);
        checks.push(Check::Lines(lines));
        let value = Term::variable(&y);
        Ok(match ty {
            Scalar::Lreal => value.raw(),
            Scalar::Real => Term::call(&conversion(wide, ty), &[&value]).raw(),
            _ => pass_wide(&value, wide, ty),
        })
    }

    fn of_texts(&mut self, op: Op, ty: Scalar, all: &[&Expr], checks: &mut Checks) -> Result<Term> {
        let mut terms = Vec::new();
        for expr in all {
            let term = self.settled(expr, checks)?;
            terms.push(if expr.ty.is_string() {
                term
            } else {
                self.named(term, expr.ty, checks)
            });
        }
        let name = match op {
            Op::Len => "LEN",
            Op::Left => "LEFT",
            Op::Right => "RIGHT",
            Op::Mid => "MID",
            Op::Concat => "CONCAT",
            Op::Insert => "INSERT",
            Op::Delete => "DELETE",
            Op::Replace => "REPLACE",
            _ => "FIND",
        };
        // Counts and positions that the text does not have are faults.
        let numbers: Vec<Term> = (terms.iter().zip(all))
            .filter(|(_, expr)| !expr.ty.is_string())
            .map(|(term, _)| term.clone())
            .collect();
        if matches!(
            op,
            Op::Left | Op::Right | Op::Mid | Op::Insert | Op::Delete | Op::Replace
        ) {
            let length = Term::call("LEN", &[&terms[0]]);
            let whole = Term::whole;
            let order = |a: &Term, sign: &str, b: &Term| Term::binary(a, sign, b, Binding::Order);
            let [count, rest @ ..] = numbers.as_slice() else {
                return self.stop("a text function without numbers");
            };
            checks.push(Check::Holds(order(count, ">=", &whole("0"))));
            let to_lint = |term: &Term, ty: Scalar| pass(term.clone(), ty, Scalar::Lint);
            let length = Term::call(&conversion(Scalar::Int, Scalar::Lint), &[&length]);
            let types: Vec<Scalar> = all
                .iter()
                .filter(|expr| !expr.ty.is_string())
                .map(|expr| expr.ty)
                .collect();
            checks.push(Check::Holds(order(&to_lint(count, types[0]), "<=", &length)));
            if let [position] = rest {
                checks.push(Check::Holds(order(position, ">=", &whole("1"))));
                let end = Term::binary(&length, "-", &to_lint(count, types[0]), Binding::Sum);
                let start = Term::binary(&to_lint(position, types[1]), "-", &whole("1"), Binding::Sum);
                checks.push(Check::Holds(order(&start, "<=", &end)));
            }
        }
        let references: Vec<&Term> = terms.iter().collect();
        let mut term = Term::call(name, &references);
        if matches!(op, Op::Len | Op::Find) {
            if !ty.is_integer() {
                return self.stop("the length of a text as something else than an integer");
            }
            if ty != Scalar::Int {
                term = Term::call(&conversion(Scalar::Int, ty), &[&term]);
            }
        }
        term.is_risky = true;
        Ok(term)
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
        let compared = match is_left {
            true => Term::binary(&wide, sign, b, binding),
            false => Term::binary(a, sign, &wide, binding),
        };
        let holds_if_negative = match op {
            Op::Ne => true,
            Op::Lt | Op::Le => is_left,
            Op::Gt | Op::Ge => !is_left,
            _ => false,
        };
        match holds_if_negative {
            true => {
                let negative = Term::binary(signed, "<", &zero, Binding::Order);
                Term::binary(&negative, "OR", &compared, Binding::Or)
            }
            false => {
                let positive = Term::binary(signed, ">=", &zero, Binding::Order);
                Term::binary(&positive, "AND", &compared, Binding::And)
            }
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

fn pass_wide(value: &Term, from: Scalar, to: Scalar) -> Term {
    match value.text.parse::<f64>() {
        Ok(_) => value.clone(),
        Err(_) => pass(value.clone(), from, to),
    }
}

/// Whether what a curve of whole numbers is computed from stays within 64 bits.
fn is_small_curve(ty: Scalar, points: &[&Expr]) -> bool {
    let number = |expr: &&Expr| match expr.kind {
        ExprKind::Constant(Value::Int(number)) => Some(i128::from(number)),
        _ => None,
    };
    let known: Option<Vec<i128>> = points.iter().map(number).collect();
    match known {
        _ if ty.width() <= 16 => true,
        Some(known) if ty != Scalar::Ulint => {
            let most = known.iter().map(|number| number.abs()).max().unwrap_or(0);
            // Three products of differences of two.
            most.checked_mul(most)
                .is_some_and(|square| square < i128::from(i64::MAX) / 8)
        }
        _ => false,
    }
}

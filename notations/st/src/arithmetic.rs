//! Sums, products, powers, shifts, and functions of one number.

use crate::checks::{Check, Checks};
use crate::expression::pass;
use crate::place::{bits_of, conversion};
use crate::project::Result;
use crate::term::{Binding, Term};
use crate::unit::Unit;
use ladder_analysis::program::Expr;
use ladder_analysis::values::types::Scalar;
use ladder_instructions::Op;

impl Unit<'_, '_> {
    pub(crate) fn arithmetic(
        &mut self,
        op: Op,
        ty: Scalar,
        all: &[&Expr],
        checks: &mut Checks,
    ) -> Result<Term> {
        let mut all = all.to_vec();
        if op == Op::Mul && ty == Scalar::Time {
            all.sort_by_key(|operand| operand.ty != Scalar::Time);
        }
        if op == Op::Exp {
            let mut terms = self.settled_all(&all, checks)?;
            let mut power = terms.pop().unwrap_or_else(|| Term::whole("1"));
            while let Some(base) = terms.pop() {
                power = self.settle(power, ty, checks);
                power = self.powered(&base, power, ty, checks)?;
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

    pub(crate) fn step(
        &mut self,
        op: Op,
        ty: Scalar,
        a: Term,
        (b, b_ty): (Term, Scalar),
        checks: &mut Checks,
    ) -> Result<Term> {
        if b_ty.is_real() && !ty.is_real() {
            return Ok(self.scaled(op, &a, (b, b_ty), checks));
        }
        if let Some(known) = known(op, ty, &a, &b) {
            return Ok(known);
        }
        let a = if ty.is_real() && b.text.parse::<f64>().is_ok() {
            self.named_number(a, ty, checks)
        } else {
            a
        };
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
            _ => Ok(self.quotient(op, ty, a, (b, b_ty), checks)),
        }
    }

    /// A number that is written out in a variable, anything else as it is: a compiler refuses what is computed from numbers alone and
    /// has no room.
    fn named_number(&mut self, term: Term, ty: Scalar, checks: &mut Checks) -> Term {
        match term.text.parse::<f64>() {
            Ok(_) => self.held(&term, ty, checks),
            Err(_) => term,
        }
    }

    /// A TIME times or by a real number.
    fn scaled(&mut self, op: Op, time: &Term, (by, ty): (Term, Scalar), checks: &mut Checks) -> Term {
        let by = self.settle(by, ty, checks);
        let by = if ty == Scalar::Real {
            pass(by, ty, Scalar::Lreal)
        } else {
            by
        };
        self.project.used.pieces.insert("LADDER_NANOSECONDS");
        let number = Term::call("LADDER_NANOSECONDS", &[time]);
        let number = Term::call(&conversion(Scalar::Lint, Scalar::Lreal), &[&number]);
        let scaled = if op == Op::Div {
            self.quotient(op, Scalar::Lreal, number, (by, Scalar::Lreal), checks)
        } else {
            Term::binary(&number, "*", &by, Binding::Product)
        };
        let scaled = self.held(&scaled, Scalar::Lreal, checks);
        self.time_of(&scaled, checks)
    }

    /// `a / b` and `a MOD b`: by 0 is a fault, and the smallest number by -1 stays what it is.
    pub(crate) fn quotient(
        &mut self,
        op: Op,
        ty: Scalar,
        a: Term,
        (b, b_ty): (Term, Scalar),
        checks: &mut Checks,
    ) -> Term {
        let a = self.settle(a, ty, checks);
        let sign = if op == Op::Div { "/" } else { "MOD" };
        let constant: Option<f64> = b.text.parse().ok();
        if let Some(by) = constant
            && by.abs() > 0.0
            && (ty.is_real() || !(-1.0..=0.0).contains(&by))
        {
            let term = Term::binary(&a, sign, &b, Binding::Product);
            return if ty.is_real() { term.raw() } else { term };
        }
        let b = self.named(b, b_ty, checks);
        let b = self.named_number(b, b_ty, checks);
        let zero = if b_ty.is_real() { "0.0" } else { "0" };
        checks.push(Check::Holds(Term::binary(
            &b,
            "<>",
            &Term::whole(zero),
            Binding::Equality,
        )));
        let mut term = if ty.is_signed() && ty == b_ty {
            let piece = if op == Op::Div { "LADDER_DIV" } else { "LADDER_MOD" };
            self.project.used.pieces.insert(piece);
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
        if ty.is_real() { term.raw() } else { term }
    }

    pub(crate) fn powered(
        &mut self,
        base: &Term,
        exponent: Term,
        ty: Scalar,
        checks: &mut Checks,
    ) -> Result<Term> {
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
        self.project.used.pieces.insert("LADDER_POWER");
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

    pub(crate) fn shift(&mut self, op: Op, ty: Scalar, all: &[&Expr], checks: &mut Checks) -> Result<Term> {
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

    pub(crate) fn function_of_one(
        &mut self,
        op: Op,
        ty: Scalar,
        operand: &Expr,
        checks: &mut Checks,
    ) -> Result<Term> {
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
                let value = self.named_number(value, ty, checks);
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
}

/// What is computed from two numbers that are written out, as it wraps in its type: compilers refuse one that does not fit.
fn known(op: Op, ty: Scalar, a: &Term, b: &Term) -> Option<Term> {
    ty.bounds()?;
    let (a, b): (i128, i128) = (a.text.parse().ok()?, b.text.parse().ok()?);
    let exact = match op {
        Op::Add => a.checked_add(b),
        Op::Sub => a.checked_sub(b),
        Op::Mul => a.checked_mul(b),
        _ => None,
    }?;
    Some(Term::whole(wrapped(exact, ty).to_string()))
}

/// A number as its low bits are in a type.
pub(crate) fn wrapped(exact: i128, ty: Scalar) -> i128 {
    let size = 1i128 << ty.width();
    let low = exact.rem_euclid(size);
    if ty.is_signed() && low >= size / 2 {
        low - size
    } else {
        low
    }
}

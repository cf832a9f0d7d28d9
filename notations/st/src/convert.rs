//! `[TYP]`: a value made into another type.

use crate::checks::{Check, Checks, is_within};
use crate::expression::pass;
use crate::place::{bits_of, conversion};
use crate::project::Result;
use crate::term::{Binding, Term};
use crate::unit::Unit;
use ladder_analysis::program::Expr;
use ladder_analysis::values::types::{Scalar, passes};

/// Milliseconds beyond this are no TIME.
const MOST_MILLISECONDS: i64 = i64::MAX / 1_000_000;

impl Unit<'_, '_> {
    /// `[WRAP]`: bit strings are cut and extended by zeros there, integers extended by their sign.
    pub(crate) fn wrapped(&mut self, to: Scalar, operand: &Expr, checks: &mut Checks) -> Result<Term> {
        let mut value = self.settled(operand, checks)?;
        let mut from = operand.ty;
        let mut convert = |to: Scalar| {
            if from != to {
                value = Term::call(&conversion(from, to), &[&value]);
                from = to;
            }
        };
        if operand.ty.is_signed() && operand.ty.width() < to.width() {
            convert(match to.width() {
                16 => Scalar::Int,
                32 => Scalar::Dint,
                _ => Scalar::Lint,
            });
            convert(bits_of(to));
        }
        if operand.ty.width() >= to.width() || !operand.ty.is_signed() {
            convert(bits_of(operand.ty));
        }
        convert(bits_of(to));
        convert(to);
        Ok(value)
    }

    pub(crate) fn converted(&mut self, to: Scalar, operand: &Expr, checks: &mut Checks) -> Result<Term> {
        let from = operand.ty;
        let value = self.settled(operand, checks)?;
        let order = |a: &Term, sign: &str, b: String| Term::binary(a, sign, &Term::whole(b), Binding::Order);
        match (from, to) {
            _ if from == to || (from.is_string() && to.is_string()) => Ok(value),
            (Scalar::Enum(id), _) if to.is_integer() => {
                self.project.used.enumerations_as_numbers.insert(id);
                let name = format!(
                    "{}_NUMBER",
                    self.project.enumeration_name(id).cloned().unwrap_or_default()
                );
                let number = Term::call(&name, &[&value]);
                self.fitted(number, Scalar::Dint, to, checks)
            }
            (_, Scalar::Enum(id)) if from.is_integer() => {
                self.project.used.enumerations_from_numbers.insert(id);
                let value = self.named(value, from, checks);
                let numbers = id
                    .get()
                    .values
                    .iter()
                    .map(|(_, number)| *number)
                    .collect::<Vec<_>>();
                let tests: Vec<Term> = numbers
                    .iter()
                    .map(|number| {
                        Term::binary(&value, "=", &Term::whole(number.to_string()), Binding::Equality)
                    })
                    .collect();
                let any = tests
                    .into_iter()
                    .reduce(|any, next| Term::binary(&any, "OR", &next, Binding::Or));
                checks.extend(any.map(Check::Holds));
                let name = format!(
                    "{}_VALUE",
                    self.project.enumeration_name(id).cloned().unwrap_or_default()
                );
                let number = pass(value, from, Scalar::Lint);
                let mut term = Term::call(&name, &[&number]);
                term.is_risky = true;
                Ok(term)
            }
            _ if from.is_string() || to.is_string() || from.is_enumeration() || to.is_enumeration() => {
                self.stop("a number as a text or the other way, which each system writes in its own way")
            }
            (Scalar::Bool, Scalar::Time) => {
                let [no, yes] = ["T#0s", "T#1ms"].map(Term::whole);
                Ok(Term::call("SEL", &[&value, &no, &yes]))
            }
            (Scalar::Bool, _) if to.is_real() => {
                let [no, yes] = ["0.0", "1.0"].map(Term::whole);
                Ok(Term::call("SEL", &[&value, &no, &yes]))
            }
            (Scalar::Bool, _) if !to.is_date() => Ok(Term::call(&conversion(from, to), &[&value])),
            (_, Scalar::Bool) if from.is_integer() || from.is_bits() => {
                let value = self.named(value, from, checks);
                checks.extend(is_within(&value, 0, 1, from).map(Check::Holds));
                Ok(Term::binary(&value, "=", &Term::whole("1"), Binding::Equality))
            }
            (_, Scalar::Bool) if from.is_real() => {
                let number = self.rounded(value, from, checks);
                checks.extend(is_within(&number, 0, 1, Scalar::Lint).map(Check::Holds));
                Ok(Term::binary(&number, "=", &Term::whole("1"), Binding::Equality))
            }
            (Scalar::Dt, Scalar::Date | Scalar::Tod) => Ok(Term::call(&conversion(from, to), &[&value])),
            (Scalar::Time, _) if to.is_integer() => {
                self.project.used.pieces.insert("LADDER_MILLISECONDS");
                let number = Term::call("LADDER_MILLISECONDS", &[&value]);
                self.fitted(number, Scalar::Lint, to, checks)
            }
            (_, Scalar::Time) if from.is_integer() => {
                let value = self.named(value, from, checks);
                if from.width() == 64 {
                    checks.push(Check::Holds(order(&value, "<=", MOST_MILLISECONDS.to_string())));
                    if from.is_signed() {
                        checks.push(Check::Holds(order(
                            &value,
                            ">=",
                            (-MOST_MILLISECONDS).to_string(),
                        )));
                    }
                }
                Ok(Term::binary(&Term::whole("T#1ms"), "*", &value, Binding::Product))
            }
            (Scalar::Time, _) if to.is_real() => {
                self.project.used.pieces.insert("LADDER_NANOSECONDS");
                let number = Term::call("LADDER_NANOSECONDS", &[&value]);
                let number = Term::call(&conversion(Scalar::Lint, Scalar::Lreal), &[&number]);
                let number = Term::binary(&number, "/", &Term::whole("1000000.0"), Binding::Product);
                Ok(pass(number, Scalar::Lreal, to))
            }
            (_, Scalar::Time) if from.is_real() => {
                let value = pass(value, from, Scalar::Lreal);
                let number = Term::binary(&value, "*", &Term::whole("1000000.0"), Binding::Product);
                let number = self.held(&number, Scalar::Lreal, checks);
                Ok(self.time_of(&number, checks))
            }
            _ if !is_plain(from) || !is_plain(to) => {
                self.stop(format!("{from} as {to}, for which systems differ"))
            }
            _ if from.is_real() && to.is_real() => {
                let term = Term::call(&conversion(from, to), &[&value]);
                Ok(if to == Scalar::Real { term.raw() } else { term })
            }
            _ if from.is_real() => {
                if to.width() == 64 && !to.is_signed() {
                    return self.stop(format!("a real number as {to}: use LINT"));
                }
                let number = self.rounded(value, from, checks);
                self.fitted(number, Scalar::Lint, to, checks)
            }
            _ if to.is_real() => Ok(Term::call(&conversion(from, to), &[&value])),
            _ if from.is_bits() != to.is_bits() && passes(from, to) => {
                Ok(Term::call(&conversion(from, to), &[&value]))
            }
            _ => self.fitted(value, from, to, checks),
        }
    }

    /// So many nanoseconds as a TIME.
    pub(crate) fn time_of(&mut self, nanoseconds: &Term, checks: &mut Checks) -> Term {
        let number = self.rounded(nanoseconds.clone(), Scalar::Lreal, checks);
        self.project.used.pieces.insert("LADDER_TIME");
        Term::call("LADDER_TIME", &[&number])
    }

    /// `TRUNC`
    pub(crate) fn truncated(
        &mut self,
        to: Scalar,
        value: Term,
        from: Scalar,
        checks: &mut Checks,
    ) -> Result<Term> {
        if !from.is_real() {
            return if to.is_real() {
                Ok(Term::call(&conversion(from, to), &[&value]))
            } else {
                self.fitted(value, from, to, checks)
            };
        }
        if to.width() == 64 && !to.is_signed() {
            return self.stop(format!("a real number as {to}: use LINT"));
        }
        let value = self.named(pass(value, from, Scalar::Lreal), Scalar::Lreal, checks);
        self.project.used.pieces.insert("LADDER_TRUNC");
        if to.is_real() {
            return self
                .stop("a real number without its fraction as a real number: write it into a LINT first");
        }
        in_lint(&value, checks);
        let number = Term::call("LADDER_TRUNC", &[&value]);
        self.fitted(number, Scalar::Lint, to, checks)
    }

    /// The nearest whole number, the even one of two, in a LINT.
    fn rounded(&mut self, value: Term, from: Scalar, checks: &mut Checks) -> Term {
        let value = self.named(pass(value, from, Scalar::Lreal), Scalar::Lreal, checks);
        in_lint(&value, checks);
        self.project.used.pieces.insert("LADDER_ROUND");
        let number = Term::call("LADDER_ROUND", &[&value]);
        self.held(&number, Scalar::Lint, checks)
    }

    /// A whole number in another type, which must have room for it.
    fn fitted(&mut self, value: Term, from: Scalar, to: Scalar, checks: &mut Checks) -> Result<Term> {
        let (Some((least, most)), Some((low, high))) = (from.bounds(), to.bounds()) else {
            return self.stop(format!("{from} as {to}"));
        };
        if from == to || (low <= least && most <= high) {
            return Ok(pass(value, from, to));
        }
        let value = self.named(value, from, checks);
        checks.extend(is_within(&value, low.max(least), high.min(most), from).map(Check::Holds));
        Ok(pass(value, from, to))
    }
}

/// Numbers, whose conversions all systems agree about.
fn is_plain(ty: Scalar) -> bool {
    ty.is_number() || ty.is_bits()
}

/// What a LINT has room for.
fn in_lint(value: &Term, checks: &mut Checks) {
    let size = Term::call("ABS", &[value]);
    let most = Term::whole("9.2E18");
    checks.push(Check::Holds(Term::binary(&size, "<", &most, Binding::Order)));
}

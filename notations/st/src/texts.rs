//! Functions of texts.

use crate::checks::{Check, Checks};
use crate::expression::pass;
use crate::place::conversion;
use crate::project::Result;
use crate::term::{Binding, Term};
use crate::unit::Unit;
use ladder_analysis::program::Expr;
use ladder_analysis::values::types::Scalar;
use ladder_instructions::Op;

impl Unit<'_, '_> {
    pub(crate) fn of_texts(
        &mut self,
        op: Op,
        ty: Scalar,
        all: &[&Expr],
        checks: &mut Checks,
    ) -> Result<Term> {
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
                // matiec has these functions with numbers of one type.
                if types[0] != types[1] {
                    for ((term, expr), number) in terms
                        .iter_mut()
                        .zip(all)
                        .filter(|(_, expr)| !expr.ty.is_string())
                        .zip([count, position])
                    {
                        *term = to_lint(number, expr.ty);
                    }
                }
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

//! `[PWL]`: curves of straight lines.

use crate::checks::{Check, Checks};
use crate::expression::pass;
use crate::place::conversion;
use crate::project::Result;
use crate::term::{Binding, Term};
use crate::unit::Unit;
use ladder_analysis::program::{Expr, ExprKind};
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;

impl Unit<'_, '_> {
    /// Piecewise linear, held at both ends, computed in the widest type.
    pub(crate) fn curve(&mut self, ty: Scalar, all: &[&Expr], checks: &mut Checks) -> Result<Term> {
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

//! Formulas about the bytes and digits of words as the instructions that they were: `SWPB`, `TOD`, `FRD`, `COP`.

use super::rung::{Piece, it};
use super::{Result, Writer};
use crate::words;
use ladder_analysis::program::{Argument, BlockKind, Expr, ExprKind, Network, Place};
use ladder_analysis::values::types::Scalar;
use ladder_format::Circuit;
use ladder_format::program::{Expression, Path, Step};
use ladder_instructions::Op;

/// Without blanks.
fn bare(text: &str) -> String {
    text.chars().filter(|c| !c.is_whitespace()).collect()
}

/// The leftmost tag that a formula reads.
fn leftmost(expr: &Expr) -> Option<&Expr> {
    match &expr.kind {
        ExprKind::Read(_) => Some(expr),
        ExprKind::Pass(inner) | ExprKind::Unary(_, inner) | ExprKind::Binary(_, inner, _) => leftmost(inner),
        _ => None,
    }
}

impl Writer<'_> {
    /// A formula that the reader makes of `SWPB`, `TOD` or `FRD`.
    pub(super) fn of_words(&mut self, to: &str, formula: &Expr) -> Result<Option<Piece>> {
        let Some(read) = leftmost(formula).filter(|_| self.input.is_own && !Self::is_simple(formula)) else {
            return Ok(None);
        };
        let whole = bare(self.source(formula.range));
        let Ok(source) = Expression::read(self.source(read.range)) else {
            return Ok(None);
        };
        let is = |formula: &Expression| bare(&formula.to_string()) == whole;
        for bits in [16, 32] {
            let mut modes = words::MODES.iter();
            let mode = modes.find(|mode| words::swapped(&source, bits, mode).as_ref().is_some_and(is));
            if let Some(mode) = mode {
                return Ok(Some(it("SWPB", &[&self.value(read)?, mode, to])));
            }
        }
        for bits in [8, 16, 32] {
            for (name, formula) in [
                ("TOD", words::to_bcd(&source, bits)),
                ("FRD", words::from_bcd(&source, bits)),
            ] {
                if is(&formula) {
                    return Ok(Some(it(name, &[&self.value(read)?, to])));
                }
            }
        }
        Ok(None)
    }

    /// Formulas that the reader makes of a copy between arrays of words of other widths, and how many they are.
    pub(super) fn bytes(
        &mut self,
        network: &Network,
        series: &[Circuit<usize>],
    ) -> Result<Option<(Piece, usize)>> {
        let element = |part: &Circuit<usize>| {
            let Circuit::Element(block) = part else {
                return None;
            };
            let block = &network.blocks[*block];
            let is_formula = matches!(block.kind, BlockKind::Instruction(row) if row.op == Op::Calc);
            let [to, formula] = &block.arguments[..] else {
                return None;
            };
            let (Argument::Place(Place::Element(..), ty), Argument::Value(formula)) =
                (&to.argument, &formula.argument)
            else {
                return None;
            };
            let (array, index) = indexed(self.source(to.range))?;
            is_formula.then_some((array, index, *ty, formula))
        };
        let Some((array, first, ty, formula)) = series.first().and_then(element) else {
            return Ok(None);
        };
        let Some(read) = leftmost(formula) else {
            return Ok(None);
        };
        let Some((source, from)) = indexed(self.source(read.range)) else {
            return Ok(None);
        };
        let (own, width) = (read.ty.width(), ty.width());
        let fits = |ty: Scalar| ty.is_integer() && ty.width() <= 32;
        if !self.input.is_own || !fits(ty) || !fits(read.ty) || own == width {
            return Ok(None);
        }
        let is_next = |(number, part): &(usize, &Circuit<usize>)| {
            let wanted = words::element(*number as u32, width, (&source, from), own);
            element(part).is_some_and(|(to, index, _, formula)| {
                let same = to == array && index == first + *number as i64;
                same && bare(self.source(formula.range)) == bare(&wanted.to_string())
            })
        };
        let taken = series.iter().enumerate().take_while(is_next).count();
        if taken == 0 || (taken == 1 && Self::is_simple(formula)) {
            return Ok(None);
        }
        let [from, to] = [source.index([from]), array.index([first])].map(|path| path.to_string());
        let (from, to) = (self.path(&from)?, self.path(&to)?);
        Ok(Some((it("COP", &[&from, &to, &taken.to_string()]), taken)))
    }
}

/// An array and a constant index in it.
fn indexed(written: &str) -> Option<(Path, i64)> {
    let Expression::Path(mut path) = Expression::read(written).ok()? else {
        return None;
    };
    match path.steps.pop()? {
        Step::Index(index) => match &index[..] {
            [Expression::Literal(index)] => Some((path, index.as_str().parse().ok()?)),
            _ => None,
        },
        _ => None,
    }
}

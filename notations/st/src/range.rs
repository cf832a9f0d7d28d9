//! Ranges of arrays, and whole structures and arrays.

use crate::arguments::{by_place, values};
use crate::checks::Checks;
use crate::place::Target;
use crate::project::Result;
use crate::term::{Binding, Term};
use crate::unit::Unit;
use ladder_analysis::program::{Argument, Block, Expr, ExprKind, Place, RangeRef};
use ladder_analysis::values::types::{Scalar, Type};
use ladder_analysis::values::value::Value;
use ladder_instructions::Op;
use ladder_syntax::TextRange;
use std::collections::BTreeSet;

/// Longer ranges are not written element by element.
const LONGEST: i64 = 256;

impl Unit<'_, '_> {
    /// The first and last index of a range, where they are numbers.
    fn ends(&self, range: &RangeRef) -> Result<(i64, i64)> {
        let number = |expr: &Expr| match expr.kind {
            ExprKind::Constant(Value::Int(number)) => Some(number),
            _ => None,
        };
        let tag = &self.project.program.tags[range.tag.0 as usize];
        let end = match tag.ty {
            Type::Array { last, .. } => last,
            _ => 0,
        };
        let last = range.last.as_deref().map_or(Some(end), number);
        match (number(&range.first), last) {
            (Some(first), Some(last)) if last - first < LONGEST && first <= last => Ok((first, last)),
            (Some(_), Some(_)) => self.stop("a range of that many elements: use a loop"),
            _ => self.stop("a range whose ends are computed: use a loop"),
        }
    }

    fn each(
        &mut self,
        range: &RangeRef,
        (first, last): (i64, i64),
        checks: &mut Checks,
    ) -> Result<Vec<Target>> {
        let mut all = Vec::new();
        for number in first..=last {
            let index = Expr {
                ty: Scalar::Lint,
                kind: ExprKind::Constant(Value::Int(number)),
                range: range.first.range,
            };
            all.push(self.place(&Place::Element(range.tag, Box::new(index)), checks)?);
        }
        Ok(all)
    }

    /// The elements of a range, to be written.
    pub(crate) fn element_targets(&mut self, range: &RangeRef, checks: &mut Checks) -> Result<Vec<Target>> {
        let ends = self.ends(range)?;
        self.each(range, ends, checks)
    }

    /// The elements of a range.
    pub(crate) fn elements(&mut self, range: &RangeRef, checks: &mut Checks) -> Result<Vec<Term>> {
        let targets = self.element_targets(range, checks)?;
        Ok(targets.iter().map(term_of).collect())
    }

    pub(crate) fn sum(&mut self, range: &RangeRef, ty: Scalar, checks: &mut Checks) -> Result<Term> {
        let element = range.element;
        let all = self.elements(range, checks)?;
        let terms = all
            .into_iter()
            .map(|term| crate::expression::pass(term, element, ty));
        let sum = terms.reduce(|sum, next| Term::binary(&sum, "+", &next, Binding::Sum));
        Ok(sum.unwrap_or_else(|| Term::whole("0")).raw())
    }

    /// `[BMOV]` and `[FILL]`
    pub(crate) fn range_act(
        &mut self,
        op: Op,
        block: &Block,
        checks: &mut Checks,
    ) -> Result<(Vec<String>, String)> {
        let arguments = by_place(block);
        let Some(Argument::Range(to)) = arguments.first() else {
            return self.stop("a range that is none");
        };
        if op == Op::Fill {
            let targets = self.element_targets(to, checks)?;
            let Some([value]) = values(block, 1)
                .as_deref()
                .and_then(<[&Expr]>::first_chunk::<1>)
                .copied()
            else {
                return self.stop("a value that is none");
            };
            let ty = value.ty;
            let value = self.settled(value, checks)?;
            let variable = targets
                .first()
                .map(|target| target.variable.clone())
                .unwrap_or_default();
            let value = if value.reads.contains(&variable) {
                self.held(&value, ty, checks)
            } else {
                value
            };
            let lines = targets.iter().flat_map(|target| target.assign(&value)).collect();
            return Ok((lines, variable));
        }
        let Some(Argument::Range(from)) = arguments.get(1) else {
            return self.stop("a range that is none");
        };
        let ends = |unit: &Self, one: &RangeRef, other: &RangeRef| {
            let number = |expr: &Expr| match expr.kind {
                ExprKind::Constant(Value::Int(number)) => Some(number),
                _ => None,
            };
            match (&one.last, &other.last, number(&one.first)) {
                (Some(_), ..) => unit.ends(one),
                (None, Some(_), Some(first)) => {
                    let (low, high) = unit.ends(other)?;
                    Ok((first, first + high - low))
                }
                (None, None, Some(first)) => Ok((first, first)),
                _ => unit.stop("a range whose ends are computed: use a loop"),
            }
        };
        let (to_ends, from_ends) = (ends(self, to, from)?, ends(self, from, to)?);
        if to_ends.1 - to_ends.0 != from_ends.1 - from_ends.0 {
            return self.stop("ranges of different lengths");
        }
        let beyond = |range: &RangeRef, (first, last): (i64, i64)| {
            let tag = &self.project.program.tags[range.tag.0 as usize];
            matches!(tag.ty, Type::Array { first: low, last: high, .. } if tag.column.is_none() && (first < low || last > high))
        };
        if beyond(to, to_ends) || beyond(from, from_ends) {
            return self.stop("a range that reaches beyond its array");
        }
        let (targets, sources) = (
            self.each(to, to_ends, checks)?,
            self.each(from, from_ends, checks)?,
        );
        let variable = targets
            .first()
            .map(|target| target.variable.clone())
            .unwrap_or_default();
        let mut pairs: Vec<(&Target, &Target)> = targets.iter().zip(&sources).collect();
        // As if through a buffer: within one array from the end that is not written first.
        if to.tag == from.tag && to_ends.0 > from_ends.0 {
            pairs.reverse();
        }
        let lines = pairs
            .into_iter()
            .flat_map(|(to, from)| to.assign(&term_of(from)))
            .collect();
        Ok((lines, variable))
    }

    /// `[SHIFT]`
    pub(crate) fn shift_range(&mut self, block: &Block, en: usize, step: usize) -> Result<()> {
        let Some(Argument::Range(range)) = by_place(block).first().copied() else {
            return self.stop("a shift of something that is no range of values");
        };
        let mut checks = Checks::new();
        let targets = self.element_targets(range, &mut checks)?;
        let Some([value]) = values(block, 1)
            .as_deref()
            .and_then(<[&Expr]>::first_chunk::<1>)
            .copied()
        else {
            return self.stop("a value that is none");
        };
        let entering = self.settled(value, &mut checks)?;
        let power = self.entering(en, step);
        self.powers[step] = power;
        let edge = self.edge_of_power(en, "rung", true);
        let Some(first) = targets.first() else {
            return self.stop("a range without elements");
        };
        let variable = first.variable.clone();
        let mut lines = Vec::new();
        let entering = if entering.reads.contains(&variable) {
            self.held(&entering, value.ty, &mut checks)
        } else {
            entering
        };
        for pair in targets.windows(2).rev() {
            lines.extend(pair[1].assign(&term_of(&pair[0])));
        }
        lines.extend(first.assign(&entering));
        self.keep(Some(&BTreeSet::from([variable])));
        let is_checked = checks
            .iter()
            .any(|check| matches!(check, crate::checks::Check::Holds(_)));
        if is_checked && self.left[step] > 0 {
            return self.stop("a shift of a value that may be a fault, with something after it");
        }
        self.guarded(Some(&edge), checks, &lines, None);
        Ok(())
    }

    /// `[MOV]` and `[SEL]` of whole structures and arrays.
    pub(crate) fn whole_act(
        &mut self,
        op: Op,
        block: &Block,
        checks: &mut Checks,
    ) -> Result<(Vec<String>, String)> {
        let bounds: Vec<_> = block.arguments.iter().collect();
        let whole = |unit: &mut Self, n: usize, checks: &mut Checks| match bounds.get(n) {
            Some(bound) => unit.whole(&bound.argument, Some(bound.range), block, checks),
            None => unit.stop("an operand that is missing"),
        };
        match op {
            Op::Mov => {
                let (to, variable) = whole(self, 0, checks)?;
                let (from, _) = whole(self, 1, checks)?;
                Ok((vec![format!("{to} := {from};")], variable))
            }
            Op::Sel => {
                let Some(Argument::Value(g)) = bounds.get(1).map(|bound| &bound.argument) else {
                    return self.stop("a selector that is no value");
                };
                let g = self.settled(g, checks)?;
                let (to, variable) = whole(self, 0, checks)?;
                let (a, _) = whole(self, 2, checks)?;
                let (b, _) = whole(self, 3, checks)?;
                let lines = vec![
                    format!("IF {} THEN", g.text),
                    format!("    {to} := {b};"),
                    "ELSE".into(),
                    format!("    {to} := {a};"),
                    "END_IF;".into(),
                ];
                Ok((lines, variable))
            }
            _ => self.stop("this instruction on whole structures: write it for their members"),
        }
    }

    /// A whole structure or array as a variable or part of one; and the variable.
    pub(crate) fn whole(
        &mut self,
        argument: &Argument,
        range: Option<TextRange>,
        block: &Block,
        checks: &mut Checks,
    ) -> Result<(String, String)> {
        let first = match argument {
            Argument::Parts(parts) => parts.first(),
            one => Some(one),
        };
        let Some(first) = first else {
            return self.stop("a structure without members");
        };
        let target = match first {
            Argument::Place(place, _) => self.place(place, checks)?,
            Argument::Range(part) => self.place(&Place::Element(part.tag, part.first.clone()), checks)?,
            Argument::State(tag) => {
                let (variable, text) = self.path(*tag, &[]);
                return self.cut(&text, range, block).map(|text| (text, variable));
            }
            Argument::ChosenState(chosen) => {
                let (variable, text) = self.chosen(chosen, checks)?;
                return self.cut(&text, range, block).map(|text| (text, variable));
            }
            _ => return self.stop("an operand that is no tag"),
        };
        let Some(text) = target.plain().map(str::to_owned) else {
            return self.stop("an operand that is no tag");
        };
        Ok((self.cut(&text, range, block)?, target.variable))
    }

    /// The beginning of a path, with as many indices and members as the operand has in the ladder text.
    fn cut(&self, path: &str, range: Option<TextRange>, block: &Block) -> Result<String> {
        let text = range
            .filter(|_| block.location.file == 0)
            .and_then(|range| self.project.text.get(std::ops::Range::<usize>::from(range)));
        let Some(text) = text else {
            return self.stop("a whole structure in a block of another file");
        };
        let wanted = steps(text);
        let given = steps(path);
        let Some(cut) = given.get(..wanted.len()) else {
            return self.stop("a whole structure of several tags");
        };
        // An index for each of several dimensions, or none of them.
        let commas = |step: &str| {
            if step.starts_with('[') {
                step.matches(',').count()
            } else {
                0
            }
        };
        if wanted
            .iter()
            .zip(cut)
            .any(|(a, b)| commas(a) + a.matches("][").count() != commas(b))
        {
            return self.stop("a row of an array as a whole: write it for its elements");
        }
        Ok(cut.concat())
    }
}

fn term_of(target: &Target) -> Term {
    let mut term = Term::whole(target.plain().unwrap_or_default());
    term.reads.insert(target.variable.clone());
    term
}

/// The steps of a path: its name, members, indices.
fn steps(path: &str) -> Vec<String> {
    let mut steps = vec![String::new()];
    let mut depth = 0;
    for c in path.chars() {
        match c {
            '[' if depth == 0 && !steps.last().is_some_and(|step| step.ends_with(']')) => {
                steps.push(c.to_string())
            }
            '.' if depth == 0 => steps.push(c.to_string()),
            _ => {
                if let Some(step) = steps.last_mut() {
                    step.push(c);
                }
            }
        }
        match c {
            '[' => depth += 1,
            ']' => depth -= 1,
            _ => {}
        }
    }
    steps
}

//! Ranges of arrays, and whole structures and arrays.

use crate::arguments::{by_place, second};
use crate::checks::{Check, Checks};
use crate::place::Target;
use crate::project::Result;
use crate::term::{Binding, Term};
use crate::unit::Unit;
use ladder_analysis::program::{Argument, Block, Expr, ExprKind, Place, RangeRef, Subscript};
use ladder_analysis::values::types::{Scalar, Type};
use ladder_analysis::values::value::Value;
use ladder_instructions::Op;
use ladder_syntax::TextRange;
use std::collections::BTreeSet;

/// The value of an index that is written as a number.
fn number(index: &Expr) -> Option<i64> {
    match index.kind {
        ExprKind::Constant(Value::Int(number)) => Some(number),
        _ => None,
    }
}

/// Longer ranges are not written element by element.
const LONGEST: i64 = 256;

impl Unit<'_, '_> {
    /// The first and last index of a range, where they are numbers.
    fn ends(&self, range: &RangeRef) -> Result<(i64, i64)> {
        let tag = &self.project.source.program.tags[range.tag.0 as usize];
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
        if let Some(all) = self.row(range, checks)? {
            return Ok(all);
        }
        let ends = self.ends(range)?;
        self.each(range, ends, checks)
    }

    /// The elements of a range in the last dimensions of an array, of which the others have the same computed index.
    fn row(&mut self, range: &RangeRef, checks: &mut Checks) -> Result<Option<Vec<Target>>> {
        let (ExprKind::Offset(first), Some(ExprKind::Offset(last))) =
            (&range.first.kind, range.last.as_deref().map(|last| &last.kind))
        else {
            return Ok(None);
        };
        let computed = |subscript: &Subscript| !matches!(subscript.index.kind, ExprKind::Constant(_));
        let Some(fixed) = first.iter().rposition(computed).map(|at| at + 1) else {
            return Ok(None);
        };
        let is_same = |(a, b): (&Subscript, &Subscript)| a.index.kind == b.index.kind;
        if !first[..fixed].iter().zip(last).all(is_same) || last[fixed..].iter().any(computed) {
            return Ok(None);
        }
        let mut indices = Vec::new();
        for subscript in &first[..fixed] {
            indices.push(self.index(&subscript.index, subscript.first, subscript.last, checks)?);
        }
        let place = |subscripts: &[Subscript]| -> i64 {
            let offset = |subscript: &Subscript| match subscript.index.kind {
                ExprKind::Constant(Value::Int(number)) => (number - subscript.first) * subscript.stride,
                _ => 0,
            };
            subscripts[fixed..].iter().map(offset).sum()
        };
        let (from, to) = (place(first), place(last));
        if to - from >= LONGEST {
            return self.stop("a range of that many elements: use a loop");
        }
        let all = (from..=to).map(|number| {
            let mut rest = number;
            let mut texts = indices.clone();
            for subscript in &first[fixed..] {
                texts.push((subscript.first + rest / subscript.stride).to_string());
                rest %= subscript.stride;
            }
            let (variable, text) = self.path(range.tag, &texts);
            Target::element(variable, text)
        });
        Ok(Some(all.collect()))
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
            let Some(value) = second(block) else {
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
        let (targets, sources) = self.moved(to, from, checks)?;
        let variable = targets
            .first()
            .map(|target| target.variable.clone())
            .unwrap_or_default();
        let lines = targets
            .iter()
            .zip(&sources)
            .flat_map(|(to, from)| to.assign(from))
            .collect();
        Ok((lines, variable))
    }

    /// The elements that a range is copied to, and those that it is copied from, in an order that keeps what is still to be copied.
    fn moved(
        &mut self,
        to: &RangeRef,
        from: &RangeRef,
        checks: &mut Checks,
    ) -> Result<(Vec<Target>, Vec<Term>)> {
        if let (Some(targets), Some(sources)) = (self.row(to, checks)?, self.row(from, checks)?) {
            if targets.len() != sources.len() || to.tag == from.tag {
                return self.stop("ranges in one array, or of different lengths: use a loop");
            }
            return Ok((targets, sources.iter().map(term_of).collect()));
        }
        let ends = |unit: &Self, one: &RangeRef, other: &RangeRef| match (
            &one.last,
            &other.last,
            number(&one.first),
        ) {
            (Some(_), ..) => unit.ends(one),
            (None, Some(_), Some(first)) => {
                let (low, high) = unit.ends(other)?;
                Ok((first, first + high - low))
            }
            (None, None, Some(first)) => Ok((first, first + one.per_index - 1)),
            _ => unit.stop("a range whose ends are computed: use a loop"),
        };
        let (to_ends, from_ends) = (ends(self, to, from)?, ends(self, from, to)?);
        if to_ends.1 - to_ends.0 != from_ends.1 - from_ends.0 {
            return self.stop("ranges of different lengths");
        }
        let beyond = |range: &RangeRef, (first, last): (i64, i64)| {
            if let Some(row) = &range.row {
                let own = number(&row.index).map(|own| own + last - first);
                return own.is_none_or(|own| own > row.bounds.1);
            }
            let tag = &self.project.source.program.tags[range.tag.0 as usize];
            matches!(tag.ty, Type::Array { first: low, last: high, .. } if first < low || last > high)
        };
        if beyond(to, to_ends) || beyond(from, from_ends) {
            return self.stop("a range that reaches beyond its array");
        }
        let (targets, sources) = (
            self.each(to, to_ends, checks)?,
            self.each(from, from_ends, checks)?,
        );
        let mut pairs: Vec<(Target, Term)> = targets.into_iter().zip(sources.iter().map(term_of)).collect();
        // As if through a buffer: within one array from the end that is not written first.
        if to.tag == from.tag && to_ends.0 > from_ends.0 {
            pairs.reverse();
        }
        Ok(pairs.into_iter().unzip())
    }

    /// `[SHIFT]`
    pub(crate) fn shift_range(&mut self, block: &Block, en: usize, step: usize) -> Result<()> {
        let Some(Argument::Range(range)) = by_place(block).first().copied() else {
            return self.stop("a shift of something that is no range of values");
        };
        let mut checks = Checks::new();
        let targets = self.element_targets(range, &mut checks)?;
        let Some(value) = second(block) else {
            return self.stop("a value that is none");
        };
        let entering = self.settled(value, &mut checks)?;
        let power = self.entering(en, step);
        self.rungs.powers[step] = power;
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
        let is_checked = checks.iter().any(|check| matches!(check, Check::Holds(_)));
        if is_checked && self.rungs.left[step] > 0 {
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
            Op::Mux => {
                let Some(Argument::Value(k)) = bounds.get(1).map(|bound| &bound.argument) else {
                    return self.stop("a selector that is no value");
                };
                let chosen = self.value(k, checks)?;
                let chosen = self.named(chosen, k.ty, checks);
                let (to, variable) = whole(self, 0, checks)?;
                let mut lines = Vec::new();
                for number in 0..bounds.len() - 2 {
                    let (from, _) = whole(self, number + 2, checks)?;
                    let word = if number == 0 { "IF" } else { "ELSIF" };
                    lines.push(format!("{word} {} = {number} THEN", chosen.text));
                    lines.push(format!("    {to} := {from};"));
                }
                lines.push("END_IF;".into());
                let last = bounds.len() as i128 - 3;
                checks.extend(crate::checks::is_within(&chosen, 0, last, k.ty).map(Check::Holds));
                Ok((lines, variable))
            }
            Op::Fill | Op::Bmov => self.whole_ranges(op, block, checks),
            _ => self.stop("this instruction on whole structures: write it for their members"),
        }
    }

    /// `[FILL]` and `[BMOV]` of ranges of structures: each of their elementary parts.
    fn whole_ranges(&mut self, op: Op, block: &Block, checks: &mut Checks) -> Result<(Vec<String>, String)> {
        let (Some(Argument::Parts(to)), Some(Argument::Parts(from))) = (
            block.arguments.first().map(|bound| &bound.argument),
            block.arguments.get(1).map(|bound| &bound.argument),
        ) else {
            return self.stop("ranges of different kinds");
        };
        let (mut lines, mut variable) = (Vec::new(), String::new());
        for (to, from) in to.iter().zip(from) {
            let Argument::Range(to) = to else {
                return self.stop("a range that is none");
            };
            let (targets, sources) = match (op, from) {
                (Op::Bmov, Argument::Range(from)) => self.moved(to, from, checks)?,
                (Op::Fill, Argument::Place(place, _)) => {
                    let value = self.read(place, checks)?;
                    let targets = self.element_targets(to, checks)?;
                    let sources = vec![value; targets.len()];
                    (targets, sources)
                }
                (Op::Fill, Argument::Range(from)) => {
                    let (targets, values) = (self.element_targets(to, checks)?, self.elements(from, checks)?);
                    let sources = values.iter().cycle().take(targets.len()).cloned().collect();
                    (targets, sources)
                }
                _ => return self.stop("ranges of different kinds"),
            };
            variable = targets
                .first()
                .map(|target| target.variable.clone())
                .unwrap_or_default();
            if op == Op::Fill && sources.iter().any(|source| source.reads.contains(&variable)) {
                return self.stop("an array that is filled with one of its own elements: copy that first");
            }
            lines.extend(
                targets
                    .iter()
                    .zip(&sources)
                    .flat_map(|(to, from)| to.assign(from)),
            );
        }
        Ok((lines, variable))
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
            Argument::State(_) | Argument::ChosenState(_) => {
                let (variable, text) = self.path(self.state_tag(first)?, &[]);
                return Ok((text, variable));
            }
            _ => return self.stop("an operand that is no tag"),
        };
        let Some(text) = target.plain().map(str::to_owned) else {
            return self.stop("an operand that is no tag");
        };
        Ok((self.cut(&text, range, block)?, target.variable))
    }

    /// The beginning of a path, with as many indices and members as the operand has in the ladder text. There the indices of an
    /// array of arrays are one list or several.
    fn cut(&self, path: &str, range: Option<TextRange>, block: &Block) -> Result<String> {
        let text = range.filter(|_| block.location.file == 0).and_then(|range| {
            self.project
                .source
                .text
                .get(std::ops::Range::<usize>::from(range))
        });
        let Some(text) = text else {
            return self.stop("a whole structure in a block of another file");
        };
        let wanted = steps(text);
        let given = steps(path);
        let Some(cut) = given.get(..wanted.len()) else {
            return self.stop("a whole structure of several tags");
        };
        let mut beginning = String::new();
        for (wanted, given) in wanted.iter().zip(cut) {
            let end = match index_lists(wanted).last() {
                None => given.len(),
                Some((_, count)) => match index_lists(given).iter().find(|(_, own)| own == count) {
                    Some((end, _)) => *end,
                    None => return self.stop("a row of an array as a whole: write it for its elements"),
                },
            };
            beginning.push_str(&given[..end]);
        }
        Ok(beginning)
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
                steps.push(c.to_string());
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

/// The lists of indices in a step: where each ends, and how many indices there are up to there.
fn index_lists(step: &str) -> Vec<(usize, usize)> {
    let (mut lists, mut depth, mut count) = (Vec::new(), 0, 0);
    for (at, c) in step.char_indices() {
        match c {
            '[' | '(' => {
                depth += 1;
                count += usize::from(depth == 1);
            }
            ',' if depth == 1 => count += 1,
            ']' | ')' => {
                depth -= 1;
                if depth == 0 {
                    lists.push((at + 1, count));
                }
            }
            _ => {}
        }
    }
    lists
}

//! What computes and moves as instructions.

use super::block::{constant, unpassed, values};
use super::operand::function;
use super::rung::{Piece, Series, branch, it};
use super::{Result, Writer};
use ladder_analysis::program::{Argument, BinaryOperator, Block, Bound, Expr, ExprKind};
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use ladder_instructions::Op;
use ladder_syntax::Name;

/// Whether it is the text without characters, which is zeros there.
fn is_empty_text(value: &Expr) -> bool {
    matches!(&value.kind, ExprKind::Constant(Value::Text(text)) if text.is_empty())
}

impl Writer<'_> {
    /// What computes and moves.
    pub(super) fn data(&mut self, op: Op, block: &Block) -> Result<Series> {
        let all = values(block);
        if matches!(op, Op::Bmov | Op::Fill) {
            return self.files(op, block);
        }
        if let (Op::Mov, [to, from]) = (op, &block.arguments[..])
            && matches!(to.argument, Argument::Parts(_))
        {
            return self.whole(to, from);
        }
        let Some(Argument::Place(_, ty)) = block.arguments.first().map(|bound| &bound.argument) else {
            return Err("it has no counterpart there".to_owned());
        };
        let (ty, to) = (*ty, self.target(block)?);
        match (op, &all[..]) {
            (Op::Mov | Op::Calc, [value]) if ty == Scalar::Bool => self.put_bit(&to, value),
            (Op::Typ, [value]) if value.ty == Scalar::Bool && ty.is_number() => {
                let (mut on, mut off) = (self.condition(value, true)?, self.condition(value, false)?);
                on.push(it("MOV", &["1", &to]));
                off.push(it("MOV", &["0", &to]));
                Ok(branch(vec![on, off]))
            }
            (Op::Wrap, [value]) if !(ty.is_signed() && value.ty.is_signed()) => {
                Err("there integers have a sign".to_owned())
            }
            (Op::Mov | Op::Typ | Op::Wrap, [value]) => {
                // A time is a number of milliseconds, there as in a conversion here.
                let is_between = |ty: Scalar| ty.is_number() || ty.is_bits() || ty == Scalar::Time;
                if op == Op::Typ && !(is_between(ty) && is_between(value.ty)) && !ty.is_string() {
                    return Err("this conversion has no counterpart there".to_owned());
                }
                if op == Op::Typ && !self.input.is_own && narrows(value.ty, ty) {
                    self.note("what is too large for its type is cut there, and no fault");
                }
                if !Self::is_simple(value) {
                    let text = self.formula(value)?;
                    return Ok(vec![it("CPT", &[&to, &text])]);
                }
                if is_empty_text(value) {
                    return Ok(vec![it("FLL", &["0", &to, "1"])]);
                }
                let value = self.value(value)?;
                Ok(vec![it("MOV", &[&value, &to])])
            }
            (Op::Calc, [formula]) => self.compute(&to, ty, formula),
            (Op::Sel, [which, low, high]) => {
                let (mut off, mut on) = (self.condition(which, false)?, self.condition(which, true)?);
                off.push(it("MOV", &[&self.value(low)?, &to]));
                on.push(it("MOV", &[&self.value(high)?, &to]));
                Ok(branch(vec![off, on]))
            }
            (Op::Min | Op::Max, [_, ..]) => {
                let mut operands: Vec<String> = Vec::new();
                for value in &all {
                    operands.push(self.value(value)?);
                }
                // The result itself is there already.
                let first = operands
                    .iter()
                    .position(|operand| operand.eq_ignore_ascii_case(&to));
                let first = operands.remove(first.unwrap_or(0));
                let mut legs = vec![put(&first, &to)];
                for other in operands {
                    let name = if op == Op::Min { "LES" } else { "GRT" };
                    legs.push(vec![it(name, &[&other, &to]), it("MOV", &[&other, &to])]);
                }
                Ok(branch(legs))
            }
            (Op::Limit, [low, value, high]) => {
                let [low, value, high] = [self.apart(low, &to)?, self.value(value)?, self.apart(high, &to)?];
                Ok(branch(vec![
                    put(&value, &to),
                    vec![it("LES", &[&to, &low]), it("MOV", &[&low, &to])],
                    vec![it("GRT", &[&to, &high]), it("MOV", &[&high, &to])],
                ]))
            }
            (
                Op::Add | Op::Sub | Op::Mul | Op::Div | Op::Mod | Op::Exp | Op::And | Op::Or | Op::Xor,
                [first, rest @ ..],
            ) => {
                let operator = operator(op);
                let formula = match op {
                    Op::Exp => return self.power(&to, ty, &all),
                    _ => rest.iter().fold((*first).clone(), |left, right| Expr {
                        ty,
                        range: left.range,
                        kind: ExprKind::Binary(operator, Box::new(left), Box::new((*right).clone())),
                    }),
                };
                self.compute_with(&to, ty, &formula, true)
            }
            (Op::Not | Op::Neg, [value]) if ty != Scalar::Bool => {
                let value = self.value(value)?;
                Ok(vec![it(
                    if op == Op::Not { "NOT" } else { "NEG" },
                    &[&value, &to],
                )])
            }
            (Op::Not, [value]) => {
                let bit = Expr {
                    ty,
                    range: value.range,
                    kind: ExprKind::Unary(
                        ladder_analysis::program::UnaryOperator::Not,
                        Box::new((*value).clone()),
                    ),
                };
                self.put_bit(&to, &bit)
            }
            (Op::Concat | Op::Mid | Op::Delete | Op::Insert | Op::Find, values) => {
                self.strings(op, &to, values)
            }
            // A text that is cut where it is: its length is written.
            (Op::Left, [text, length]) if self.value(text)?.eq_ignore_ascii_case(&to) => {
                let length = self.value(length)?;
                Ok(vec![it("MOV", &[&length, &format!("{to}.LEN")])])
            }
            (op, [value]) if function(op).is_some() => {
                let mut out = self.domain(op, value)?;
                let name = function(op).unwrap_or_default();
                out.push(it(name, &[&self.value(value)?, &to]));
                Ok(out)
            }
            _ => Err("it has no counterpart there".to_owned()),
        }
    }

    /// An operand that is not what is written.
    fn apart(&mut self, value: &Expr, to: &str) -> Result<String> {
        let value = self.value(value)?;
        if value.eq_ignore_ascii_case(to) {
            return Err("its result as one of its operands has no counterpart there".to_owned());
        }
        Ok(value)
    }

    fn power(&mut self, to: &str, ty: Scalar, all: &[&Expr]) -> Result<Series> {
        let [base, exponent] = all else {
            return Err("there a power has two operands".to_owned());
        };
        if ty.is_integer() && !self.input.is_own {
            self.note("there a power is computed with 32 bits of a real");
        }
        let (base, exponent) = (self.value(base)?, self.value(exponent)?);
        Ok(vec![it("XPY", &[&base, &exponent, to])])
    }

    /// A bit becomes what a formula is.
    fn put_bit(&mut self, to: &str, value: &Expr) -> Result<Series> {
        let (mut on, mut off) = (self.condition(value, true)?, self.condition(value, false)?);
        on.push(it("OTL", &[to]));
        off.push(it("OTU", &[to]));
        let reads_itself = {
            let whole = super::rung::text(&on);
            whole.matches(&format!("({to}")).count() > 1
        };
        if reads_itself {
            return Err("a bit that is computed from itself has no counterpart there".to_owned());
        }
        Ok(branch(vec![on, off]))
    }

    /// `[CALC]`
    pub(super) fn compute(&mut self, to: &str, ty: Scalar, formula: &Expr) -> Result<Series> {
        let found = [
            self.bits_moved(to, formula)?,
            self.latched_bit(to, formula)?,
            self.of_words(to, formula)?,
        ];
        if let Some(found) = found.into_iter().flatten().next() {
            return Ok(vec![found]);
        }
        self.compute_with(to, ty, formula, false)
    }

    /// A formula as an instruction of its own where it has one. `as_block`: it is a block of its own here, too.
    fn compute_with(&mut self, to: &str, ty: Scalar, formula: &Expr, as_block: bool) -> Result<Series> {
        let mut out = Vec::new();
        if !self.input.is_own {
            self.divisors(formula, &mut out)?;
            if narrow(ty) && divides_after(formula) {
                self.note("parts of the formula are DINT there, and do not wrap in the type of the result");
            }
        }
        let single = match &formula.kind {
            ExprKind::Binary(operator, left, right) if Self::is_simple(left) && Self::is_simple(right) => {
                let name = match operator {
                    BinaryOperator::Div => Some("DIV"),
                    BinaryOperator::Mod => Some("MOD"),
                    BinaryOperator::Power => Some("XPY"),
                    BinaryOperator::Add if as_block => Some("ADD"),
                    BinaryOperator::Sub if as_block => Some("SUB"),
                    BinaryOperator::Mul if as_block => Some("MUL"),
                    BinaryOperator::And if as_block => Some("AND"),
                    BinaryOperator::Or if as_block => Some("OR"),
                    BinaryOperator::Xor if as_block => Some("XOR"),
                    _ => None,
                };
                match name {
                    Some(name) => Some(it(name, &[&self.value(left)?, &self.value(right)?, to])),
                    None => None,
                }
            }
            ExprKind::Call(op, inner) if inner.len() == 1 && Self::is_simple(&inner[0]) => {
                if !self.input.is_own {
                    out.extend(self.domain(*op, &inner[0])?);
                }
                match function(*op) {
                    Some("TRN") | None => None,
                    Some(name) => Some(it(name, &[&self.value(&inner[0])?, to])),
                }
            }
            _ => None,
        };
        let piece = match single {
            Some(piece) => piece,
            None => it("CPT", &[to, &self.formula(formula)?]),
        };
        out.push(piece);
        Ok(out)
    }

    /// A division by zero is a fault here, and nothing is written.
    fn divisors(&mut self, formula: &Expr, out: &mut Series) -> Result<()> {
        match &formula.kind {
            ExprKind::Pass(inner) | ExprKind::Unary(_, inner) => self.divisors(inner, out),
            ExprKind::Binary(operator, left, right) => {
                self.divisors(left, out)?;
                self.divisors(right, out)?;
                if matches!(operator, BinaryOperator::Div | BinaryOperator::Mod)
                    && constant(right).is_none_or(|number| number == 0)
                    && !matches!(&right.kind, ExprKind::Constant(Value::Real(number)) if *number != 0.0)
                {
                    let zero = "0".to_owned();
                    out.push(if Self::is_simple(right) {
                        it("NEQ", &[&self.value(right)?, &zero])
                    } else {
                        it("CMP", &[&format!("({}) <> 0", self.formula(right)?)])
                    });
                }
                Ok(())
            }
            ExprKind::Call(_, inner) => inner.iter().try_for_each(|inner| self.divisors(inner, out)),
            _ => Ok(()),
        }
    }

    /// Outside of its domain a function is a fault here.
    fn domain(&mut self, op: Op, value: &Expr) -> Result<Series> {
        if self.input.is_own {
            return Ok(Vec::new());
        }
        Ok(match op {
            Op::Sqrt => vec![it("GEQ", &[&self.value(value)?, "0"])],
            Op::Ln | Op::Log => vec![it("GRT", &[&self.value(value)?, "0"])],
            _ => Vec::new(),
        })
    }

    /// A whole structure or array.
    fn whole(&mut self, to: &Bound, from: &Bound) -> Result<Series> {
        let (Argument::Parts(parts), written, source) = (
            &to.argument,
            self.source(to.range).to_owned(),
            self.source(from.range).to_owned(),
        ) else {
            return Err("it has no counterpart there".to_owned());
        };
        if let [Argument::Range(range)] = &parts[..]
            && let (Some(first), Some(Some(last))) =
                (constant(&range.first), range.last.as_deref().map(constant))
            && !written.trim_end().ends_with(']')
        {
            let (to, from) = (self.path(&written)?, self.path(&source)?);
            let (to, from) = (format!("{to}[{first}]"), format!("{from}[{first}]"));
            return Ok(vec![it("COP", &[&from, &to, &(last - first + 1).to_string()])]);
        }
        if written.contains("..") {
            return Err("it has no counterpart there".to_owned());
        }
        let to = self.path(&written)?;
        if self.is_cleared(from) {
            return Ok(vec![it("FLL", &["0", &to, "1"])]);
        }
        let from = self.path(&source)?;
        Ok(vec![it("COP", &[&from, &to, "1"])])
    }

    /// Structures that are cleared, `all[0..4]`.
    fn cleared(&mut self, to: &Bound) -> Result<Series> {
        let written = self.source(to.range).trim().to_owned();
        let range = written.strip_suffix(']').and_then(|text| text.rsplit_once('['));
        let numbers = range.and_then(|(array, range)| {
            let (first, last) = range.split_once("..").unwrap_or((range, range));
            let number = |text: &str| text.trim().parse::<i64>().ok();
            Some((array, number(first)?, number(last)?))
        });
        let (array, first, last) = numbers.ok_or("it has no counterpart there")?;
        let (array, length) = (self.path(array)?, last.saturating_sub(first).saturating_add(1));
        let begin = format!("{array}[{first}]");
        Ok(vec![it("FLL", &["0", &begin, &length.to_string()])])
    }

    /// Whether it is a constant that the reader made to clear a structure.
    fn is_cleared(&self, bound: &Bound) -> bool {
        let name = Name::new(self.source(bound.range).trim());
        self.facts.cleared.contains(&name)
    }

    /// `[BMOV]` and `[FILL]`
    fn files(&mut self, op: Op, block: &Block) -> Result<Series> {
        let [to, from] = &block.arguments[..] else {
            return Err("it has no counterpart there".to_owned());
        };
        if op == Op::Fill && self.is_cleared(from) {
            return self.cleared(to);
        }
        let (array, first, last) = self.range(to)?;
        if op == Op::Fill {
            let Argument::Value(value) = &from.argument else {
                return Err("it has no counterpart there".to_owned());
            };
            let value = if is_empty_text(value) {
                "0".to_owned()
            } else {
                self.value(value)?
            };
            let length = last.unwrap_or(first) - first + 1;
            return Ok(vec![it(
                "FLL",
                &[&value, &format!("{array}[{first}]"), &length.to_string()],
            )]);
        }
        let (source, from_first, from_last) = self.range(from)?;
        let length = match (last, from_last) {
            (Some(last), _) => last - first + 1,
            (None, Some(last)) => last - from_first + 1,
            (None, None) => 1,
        };
        let (from, to) = (format!("{source}[{from_first}]"), format!("{array}[{first}]"));
        Ok(vec![it("COP", &[&from, &to, &length.to_string()])])
    }

    fn strings(&mut self, op: Op, to: &str, values: &[&Expr]) -> Result<Series> {
        let mut texts = Vec::new();
        for value in values {
            texts.push(self.value(value)?);
        }
        let name = match (op, texts.len()) {
            (Op::Concat, 2) => "CONCAT",
            (Op::Mid, 3) => "MID",
            (Op::Delete, 3) => "DELETE",
            (Op::Find, 2) => {
                texts.push("1".to_owned());
                "FIND"
            }
            (Op::Insert, 3) => {
                let position = constant(values[2]).ok_or("there the position is a constant")?;
                texts[2] = (position + 1).to_string();
                "INSERT"
            }
            _ => return Err("it has no counterpart there".to_owned()),
        };
        texts.push(to.to_owned());
        let texts: Vec<&str> = texts.iter().map(String::as_str).collect();
        Ok(vec![it(name, &texts)])
    }

    /// `d AND NOT m OR (s SHL n) AND m`, which `BTD` and `MVM` become here.
    fn bits_moved(&mut self, to: &str, formula: &Expr) -> Result<Option<Piece>> {
        use BinaryOperator::{And, Or, Shl, Shr};
        let parts = |expr: &Expr| match unpassed(expr) {
            Expr {
                kind: ExprKind::Binary(operator, left, right),
                ..
            } => Some((*operator, (**left).clone(), (**right).clone())),
            _ => None,
        };
        let Some((Or, kept, moved)) = parts(formula) else {
            return Ok(None);
        };
        let (Some((And, own, not)), Some((And, source, mask))) = (parts(&kept), parts(&moved)) else {
            return Ok(None);
        };
        let (Some((shift, word, by)), Some(mask)) = (parts(&source), constant(&mask)) else {
            return Ok(None);
        };
        if !Self::is_simple(&own) || !self.value(&own)?.eq_ignore_ascii_case(to) || !Self::is_simple(&word) {
            return Ok(None);
        }
        let is_not =
            matches!(&unpassed(&not).kind, ExprKind::Unary(_, inner) if constant(inner) == Some(mask));
        let Some(by) = constant(&by).filter(|_| is_not && matches!(shift, Shl | Shr)) else {
            return Ok(None);
        };
        let bits = mask as u64 & if mask < 0 { u64::from(u32::MAX) } else { u64::MAX };
        let (first, length) = (i64::from(bits.trailing_zeros()), bits.count_ones());
        let from = if shift == Shl { first - by } else { first + by };
        if from < 0 {
            return Ok(None);
        }
        let operands = [from.to_string(), first.to_string(), length.to_string()];
        let word = self.value(&word)?;
        Ok(Some(it(
            "BTD",
            &[&word, &operands[0], to, &operands[1], &operands[2]],
        )))
    }
}

const fn operator(op: Op) -> BinaryOperator {
    match op {
        Op::Add => BinaryOperator::Add,
        Op::Sub => BinaryOperator::Sub,
        Op::Mul => BinaryOperator::Mul,
        Op::Div => BinaryOperator::Div,
        Op::Mod => BinaryOperator::Mod,
        Op::Exp => BinaryOperator::Power,
        Op::And => BinaryOperator::And,
        Op::Or => BinaryOperator::Or,
        _ => BinaryOperator::Xor,
    }
}

/// Narrower than what Logix computes in.
fn narrow(ty: Scalar) -> bool {
    ty.is_integer() && ty.width() < 32
}

/// Whether a value of one type may not fit another.
fn narrows(from: Scalar, to: Scalar) -> bool {
    to.is_integer() && (from.is_real() || from.width() > to.width() || from.is_signed() != to.is_signed())
}

/// Whether a formula divides what was computed before.
fn divides_after(formula: &Expr) -> bool {
    match &formula.kind {
        ExprKind::Binary(BinaryOperator::Div | BinaryOperator::Mod, left, right) => {
            !Writer::is_simple(left) || !Writer::is_simple(right)
        }
        ExprKind::Binary(_, left, right) => divides_after(left) || divides_after(right),
        ExprKind::Pass(inner) | ExprKind::Unary(_, inner) => divides_after(inner),
        _ => false,
    }
}

/// What moves a value; nothing where it is.
fn put(value: &str, to: &str) -> Series {
    if value.eq_ignore_ascii_case(to) {
        return Vec::new();
    }
    vec![it("MOV", &[value, to])]
}

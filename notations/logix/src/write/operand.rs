//! Operands: tags, numbers and formulas as Logix spells them, and conditions as contacts.

use super::rung::{Piece, Series, branch, it};
use super::{Result, Writer};
use ladder_analysis::program::{BinaryOperator, Expr, ExprKind, Member, Place, SystemTag, UnaryOperator};
use ladder_analysis::values::types::{Scalar, Type};
use ladder_analysis::values::value::{Value, real_text};
use ladder_instructions::{Op, StateType};
use ladder_syntax::TextRange;

/// Nanoseconds in a millisecond.
const MILLISECOND: i64 = 1_000_000;

impl Writer<'_> {
    pub(super) fn source(&self, range: TextRange) -> &str {
        &self.input.text[range]
    }

    /// A tag or a part of one.
    pub(super) fn path(&mut self, written: &str) -> Result<String> {
        let mut out = String::new();
        let mut rest = written;
        let mut after_dot = false;
        while let Some(c) = rest.chars().next() {
            if c == '#' {
                rest = rest[1..].split_once('#').map_or("", |(_, rest)| rest);
            } else if c.is_alphabetic() || c == '_' || c == '%' {
                let is_address = c == '%';
                let goes_on = |c: char| c.is_alphanumeric() || c == '_' || (is_address && c == '.');
                let mut ends = rest.char_indices().skip(1).filter(|(_, c)| !goes_on(*c));
                let word = &rest[..ends.next().map_or(rest.len(), |(end, _)| end)];
                rest = &rest[word.len()..];
                out.push_str(&self.word(word, after_dot)?);
                after_dot = false;
            } else {
                rest = &rest[c.len_utf8()..];
                match c {
                    c if c.is_whitespace() => continue,
                    '^' => out.push_str("**"),
                    '[' if out.ends_with(']') => {
                        out.pop();
                        out.push(',');
                    }
                    c => out.push(c),
                }
                after_dot = c == '.';
            }
        }
        Ok(out)
    }

    fn word(&mut self, word: &str, is_member: bool) -> Result<String> {
        let upper = word.to_ascii_uppercase();
        if !is_member {
            match upper.as_str() {
                "MOD" | "AND" | "OR" | "XOR" | "NOT" => return Ok(format!(" {upper} ")),
                "SHL" | "SHR" => return Err("an index that is shifted has no counterpart there".to_owned()),
                "EN" if self.scope.body.is_some() => return Ok("EnableIn".to_owned()),
                "ENO" if self.scope.body.is_some() => return Ok("EnableOut".to_owned()),
                _ => {}
            }
            self.visible(word)?;
            return Ok(self.root(word));
        }
        Ok(self.member_name(word))
    }

    /// A place that is read or written as a whole.
    pub(super) fn place(&mut self, place: &Place, written: &str) -> Result<String> {
        match place {
            Place::System(SystemTag::FirstScan) => Ok("S:FS".to_owned()),
            Place::System(_) => Err(format!("`{written}` has no counterpart there")),
            Place::Member(tag, member) => self.member(self.state_of(*tag), *member, written),
            Place::ChosenMember(chosen, member) => self.member(self.state_of(chosen.first), *member, written),
            _ => self.path(written),
        }
    }

    fn state_of(&self, tag: ladder_analysis::program::TagId) -> Option<StateType> {
        match self.input.program.tags[tag.0 as usize].ty {
            Type::State(state) => Some(state),
            _ => None,
        }
    }

    /// A member of a timer or counter.
    fn member(&mut self, state: Option<StateType>, member: Member, written: &str) -> Result<String> {
        let base = written.rsplit_once('.').map_or(written, |(base, _)| base);
        let own = self.path(base)?;
        let is_timer = matches!(state, Some(StateType::Ton | StateType::Tof | StateType::Rto));
        let is_counter = matches!(state, Some(StateType::Ctu | StateType::Ctd | StateType::Ctud));
        let name = match member {
            Member::Q1 => return Ok(own),
            Member::Et if is_timer => "ACC",
            Member::Pt if is_timer => "PRE",
            Member::Q if is_timer => "DN",
            Member::In if is_timer => "EN",
            Member::Timing if is_timer => "TT",
            Member::Q if state == Some(StateType::Tp) => return Ok(self.pulse(&own)),
            Member::Cv if is_counter => "ACC",
            Member::Pv if is_counter => "PRE",
            Member::Q if state == Some(StateType::Ctu) => "DN",
            Member::Cu if is_counter => "CU",
            Member::Cd if is_counter => "CD",
            _ => return Err(format!("`{written}` has no counterpart there")),
        };
        Ok(format!("{own}.{name}"))
    }

    /// A value that is a tag or a number.
    pub(super) fn value(&mut self, expr: &Expr) -> Result<String> {
        match &expr.kind {
            ExprKind::Constant(value) => self.constant(value, expr),
            ExprKind::Read(place) => {
                if let Place::Tag(tag) = place
                    && let Some(Some(text)) = self.facts.absorbed.get(tag)
                {
                    return Ok(text.clone());
                }
                let written = self.source(expr.range).to_owned();
                self.place(place, &written)
            }
            ExprKind::Pass(inner) => self.value(inner),
            _ => Err("a formula has no counterpart here: only CPT and CMP have one there".to_owned()),
        }
    }

    fn constant(&self, value: &Value, expr: &Expr) -> Result<String> {
        let written = self.source(expr.range).trim();
        let digits = written.strip_prefix('-').unwrap_or(written);
        let is_plain = digits.starts_with(|c: char| c.is_ascii_digit())
            && digits
                .chars()
                .all(|c| c.is_ascii_digit() || matches!(c, '.' | 'e' | 'E' | '-' | '+'));
        Ok(match value {
            Value::Int(_) | Value::Real(_) if is_plain && expr.ty != Scalar::Time => written.to_owned(),
            Value::Bool(high) => u8::from(*high).to_string(),
            Value::Int(span) if expr.ty == Scalar::Time => milliseconds(*span)?.to_string(),
            Value::Int(_) if expr.ty.is_date() => return Err("there are no dates there".to_owned()),
            Value::Int(number) => number.to_string(),
            Value::Real(number) => real_text(*number, expr.ty),
            Value::Text(_) => written.to_owned(),
        })
    }

    /// Whether it is a tag or a number.
    pub(super) fn is_simple(expr: &Expr) -> bool {
        match &expr.kind {
            ExprKind::Constant(_) | ExprKind::Read(_) => true,
            ExprKind::Pass(inner) => Self::is_simple(inner),
            _ => false,
        }
    }

    /// A formula of `CPT` or `CMP`.
    pub(super) fn formula(&mut self, expr: &Expr) -> Result<String> {
        Ok(self.part(expr)?.0)
    }

    /// A part of a formula, and how tightly it holds together: more is tighter.
    fn part(&mut self, expr: &Expr) -> Result<(String, u8)> {
        Ok(match &expr.kind {
            ExprKind::Pass(inner) => self.part(inner)?,
            ExprKind::Constant(_) | ExprKind::Read(_) => {
                let text = self.value(expr)?;
                let tight = if text.starts_with('-') { 8 } else { 10 };
                (text, tight)
            }
            ExprKind::Unary(operator, inner) => {
                let sign = match operator {
                    UnaryOperator::Minus => "-",
                    UnaryOperator::Not => "NOT ",
                };
                (format!("{sign}{}", self.within(inner, 10)?), 8)
            }
            ExprKind::Binary(operator, left, right) => {
                let (spelled, tight) = match operator {
                    BinaryOperator::Or => (" OR ", 1),
                    BinaryOperator::Xor => (" XOR ", 2),
                    BinaryOperator::And => (" AND ", 3),
                    BinaryOperator::Add => (" + ", 5),
                    BinaryOperator::Sub => (" - ", 5),
                    BinaryOperator::Mul => (" * ", 6),
                    BinaryOperator::Div => (" / ", 6),
                    BinaryOperator::Mod => (" MOD ", 6),
                    BinaryOperator::Power => {
                        let (left, right) = (self.within(left, 10)?, self.within(right, 10)?);
                        return Ok((format!("{left}**{right}"), 9));
                    }
                    BinaryOperator::Shl | BinaryOperator::Shr => {
                        return Err("a shift in a formula has no counterpart there".to_owned());
                    }
                };
                let (left, right) = (self.within(left, tight)?, self.within(right, tight + 1)?);
                (format!("{left}{spelled}{right}"), tight)
            }
            ExprKind::Compare(op, left, right) => {
                let sign = match op {
                    Op::Eq => "=",
                    Op::Ne => "<>",
                    Op::Lt => "<",
                    Op::Le => "<=",
                    Op::Gt => ">",
                    _ => ">=",
                };
                let (left, right) = (self.within(left, 5)?, self.within(right, 5)?);
                (format!("{left} {sign} {right}"), 4)
            }
            ExprKind::Call(op, arguments) => {
                let (Some(name), [inner]) = (function(*op), &arguments[..]) else {
                    return Err("this function has no counterpart there".to_owned());
                };
                (format!("{name}({})", self.formula(inner)?), 10)
            }
            ExprKind::Sum(_) | ExprKind::Offset(_) => {
                return Err("a sum over an array has no counterpart there".to_owned());
            }
        })
    }

    fn within(&mut self, expr: &Expr, tight: u8) -> Result<String> {
        let (text, own) = self.part(expr)?;
        Ok(if own < tight { format!("({text})") } else { text })
    }

    /// Power that passes while a formula is high, or while it is low.
    pub(super) fn condition(&mut self, expr: &Expr, high: bool) -> Result<Series> {
        Ok(match &expr.kind {
            ExprKind::Pass(inner) => self.condition(inner, high)?,
            ExprKind::Constant(Value::Bool(own)) => always(*own == high),
            ExprKind::Read(Place::System(SystemTag::On)) => always(high),
            ExprKind::Read(Place::System(SystemTag::Off)) => always(!high),
            ExprKind::Read(place) => {
                let written = self.source(expr.range).to_owned();
                if let Some(compared) = self.counted(place, &written, high)? {
                    return Ok(compared);
                }
                let path = self.place(place, &written)?;
                vec![it(if high { "XIC" } else { "XIO" }, &[&path])]
            }
            ExprKind::Unary(UnaryOperator::Not, inner) => self.condition(inner, !high)?,
            ExprKind::Binary(operator, left, right) if expr.ty == Scalar::Bool => match operator {
                BinaryOperator::And | BinaryOperator::Or => {
                    let both = (*operator == BinaryOperator::And) == high;
                    let (mut one, other) = (self.condition(left, high)?, self.condition(right, high)?);
                    if both {
                        one.extend(other);
                        one
                    } else {
                        branch(vec![one, other])
                    }
                }
                BinaryOperator::Xor => self.same(left, right, !high)?,
                _ => return Err("this formula has no counterpart there".to_owned()),
            },
            ExprKind::Compare(op @ (Op::Eq | Op::Ne), left, right) if left.ty == Scalar::Bool => {
                self.same(left, right, (*op == Op::Eq) == high)?
            }
            ExprKind::Compare(op, left, right) => {
                let op = if high { *op } else { opposite(*op) };
                vec![self.compared(op, left, right)?]
            }
            _ => return Err("this formula has no counterpart there".to_owned()),
        })
    }

    /// Whether two bits are alike, or are not.
    fn same(&mut self, left: &Expr, right: &Expr, alike: bool) -> Result<Series> {
        let mut legs = Vec::new();
        for high in [true, false] {
            let mut leg = self.condition(left, high)?;
            leg.extend(self.condition(right, high == alike)?);
            legs.push(leg);
        }
        Ok(branch(legs))
    }

    /// The output of a counter that has another one there.
    fn counted(&mut self, place: &Place, written: &str, high: bool) -> Result<Option<Series>> {
        let (Place::Member(tag, member), Some((base, _))) = (place, written.rsplit_once('.')) else {
            return Ok(None);
        };
        let own = match (self.state_of(*tag), member) {
            (Some(StateType::Ctd), Member::Q) | (Some(StateType::Ctud), Member::Qd) => {
                let at = format!("{}.ACC", self.path(base)?);
                it(if high { "LEQ" } else { "GRT" }, &[&at, "0"])
            }
            (Some(StateType::Ctud), Member::Q | Member::Qu) => {
                let base = self.path(base)?;
                let (at, preset) = (format!("{base}.ACC"), format!("{base}.PRE"));
                it(if high { "GEQ" } else { "LES" }, &[&at, &preset])
            }
            _ => return Ok(None),
        };
        Ok(Some(vec![own]))
    }

    /// A comparison of two values or formulas.
    pub(super) fn compared(&mut self, op: Op, left: &Expr, right: &Expr) -> Result<Piece> {
        if Self::is_simple(left) && Self::is_simple(right) {
            let (left, right) = (self.value(left)?, self.value(right)?);
            return Ok(it(comparison(op), &[&left, &right]));
        }
        let whole = Expr {
            ty: Scalar::Bool,
            kind: ExprKind::Compare(op, Box::new(left.clone()), Box::new(right.clone())),
            range: left.range,
        };
        let text = self.formula(&whole)?;
        Ok(it("CMP", &[&text]))
    }
}

/// A span in whole milliseconds.
pub(super) fn milliseconds(span: i64) -> Result<i64> {
    if span % MILLISECOND != 0 {
        return Err("there a time is whole milliseconds".to_owned());
    }
    let span = span / MILLISECOND;
    match i32::try_from(span) {
        Ok(_) => Ok(span),
        Err(_) => Err("there a time is at most 2147483647 milliseconds".to_owned()),
    }
}

fn always(high: bool) -> Series {
    if high { Vec::new() } else { vec![it("AFI", &[])] }
}

/// What Logix calls a comparison.
pub(super) fn comparison(op: Op) -> &'static str {
    match op {
        Op::Eq => "EQU",
        Op::Ne => "NEQ",
        Op::Lt => "LES",
        Op::Le => "LEQ",
        Op::Gt => "GRT",
        _ => "GEQ",
    }
}

fn opposite(op: Op) -> Op {
    match op {
        Op::Eq => Op::Ne,
        Op::Ne => Op::Eq,
        Op::Lt => Op::Ge,
        Op::Le => Op::Gt,
        Op::Gt => Op::Le,
        _ => Op::Lt,
    }
}

/// What Logix calls a function of one number.
pub(super) fn function(op: Op) -> Option<&'static str> {
    Some(match op {
        Op::Abs => "ABS",
        Op::Sqrt => "SQR",
        Op::Ln => "LN",
        Op::Log => "LOG",
        Op::Sin => "SIN",
        Op::Cos => "COS",
        Op::Tan => "TAN",
        Op::Asin => "ASN",
        Op::Acos => "ACS",
        Op::Atan => "ATN",
        Op::Rad => "RAD",
        Op::Deg => "DEG",
        Op::Trunc => "TRN",
        _ => return None,
    })
}

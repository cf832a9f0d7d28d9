//! Operands and formulas of ladder text as Click has them.

use super::Back;
use super::meaning::Meaning;
use crate::address::{Span, Tag};
use crate::bank::Bank;
use crate::model::{Bits, Constant, Formula, Function, Operand, Operator, Pointer};
use crate::operand::shortest;
use crate::tags::system_number;
use ladder_analysis::program::{
    Argument, BinaryOperator, Bound, Expr, ExprKind, Member, Place, RangeRef, TagId, UnaryOperator,
};
use ladder_analysis::values::value::Value;
use ladder_instructions::Op;
use ladder_syntax::TextRange;

/// Why something cannot be expressed in Click.
pub(super) type Refusal = String;

impl Back<'_> {
    pub(super) fn meaning(&self, tag: TagId) -> &Meaning {
        &self.meanings[tag.0 as usize]
    }

    /// What an operand is, if it is a value or a place.
    pub(super) fn operand(&self, bound: &Bound) -> Result<Operand, Refusal> {
        match &bound.argument {
            Argument::Value(value) => self.value(value),
            Argument::Place(place, _) => self.place(place, bound.range),
            Argument::State(tag) => self.state(*tag).map(Operand::Tag),
            _ => Err("Click has no such operand".to_owned()),
        }
    }

    /// An address.
    pub(super) fn tag(&self, bound: &Bound) -> Result<Tag, Refusal> {
        match self.operand(bound)? {
            Operand::Tag(tag) => Ok(tag),
            _ => Err("Click takes a single address here".to_owned()),
        }
    }

    /// The bit of a timer or counter.
    pub(super) fn state(&self, tag: TagId) -> Result<Tag, Refusal> {
        match self.meaning(tag) {
            Meaning::Address(found) => Ok(found.clone()),
            Meaning::Nothing(why) => Err((*why).to_owned()),
            _ => Err("Click has no such operand".to_owned()),
        }
    }

    pub(super) fn bits(&self, bound: &Bound) -> Result<Bits, Refusal> {
        match &bound.argument {
            Argument::Range(range) => self.span(range).map(Bits::Many),
            _ => self.tag(bound).map(Bits::One),
        }
    }

    /// A range of a bank.
    pub(super) fn span(&self, range: &RangeRef) -> Result<Span, Refusal> {
        let bank = self.bank(range.tag)?;
        let number = |expr: &Expr| index(expr).ok_or("Click's ranges have fixed ends");
        let first = number(&range.first)?;
        let last = range.last.as_deref().map_or(Ok(first), number)?;
        Ok(Span { bank, first, last })
    }

    pub(super) fn span_of(&self, bound: &Bound) -> Result<Span, Refusal> {
        match &bound.argument {
            Argument::Range(range) => self.span(range),
            _ => Err("Click takes a range here".to_owned()),
        }
    }

    fn bank(&self, tag: TagId) -> Result<Bank, Refusal> {
        match self.meaning(tag) {
            Meaning::Bank(bank) => Ok(*bank),
            Meaning::Nothing(why) => Err((*why).to_owned()),
            _ => Err("Click has no arrays but its banks".to_owned()),
        }
    }

    pub(super) fn value(&self, expr: &Expr) -> Result<Operand, Refusal> {
        match &expr.kind {
            ExprKind::Pass(inside) => self.value(inside),
            ExprKind::Constant(value) => self.constant(value, expr.range).map(Operand::Constant),
            ExprKind::Read(place) => self.place(place, expr.range),
            _ => Err("Click computes in calc() alone".to_owned()),
        }
    }

    fn place(&self, place: &Place, range: TextRange) -> Result<Operand, Refusal> {
        match place {
            Place::Tag(tag) => match self.meaning(*tag) {
                Meaning::Address(tag) => Ok(Operand::Tag(tag.clone())),
                Meaning::Nothing(why) => Err((*why).to_owned()),
                _ => Err("it is a helper of the conversion, and is in a place that Click has not".to_owned()),
            },
            Place::Element(tag, by) => {
                let bank = self.bank(*tag)?;
                if let Some(number) = index(by) {
                    return Ok(Operand::Tag(Tag::number(bank, number)));
                }
                if let ExprKind::Read(Place::Tag(helper)) = &stripped(by).kind
                    && let Some((by, offset)) = self.computed.pointers.get(helper)
                {
                    let (by, offset) = (by.clone(), *offset);
                    return Ok(Operand::Pointer(Pointer { bank, by, offset }));
                }
                match self.value(by)? {
                    Operand::Tag(by) => Ok(Operand::Pointer(Pointer { bank, by, offset: 0 })),
                    _ => Err("Click's pointers are single addresses".to_owned()),
                }
            }
            Place::Member(tag, member) => {
                let mut found = self.state(*tag)?;
                match member {
                    Member::Q | Member::Qu => {}
                    Member::Et => found.bank = Bank::Td,
                    Member::Cv => found.bank = Bank::Ctd,
                    _ => return Err("Click has a timer's or counter's bit and current value only".to_owned()),
                }
                Ok(Operand::Tag(found))
            }
            Place::System(_) => {
                let number = system_number(self.written(range)).ok_or("Click has no such system tag")?;
                Ok(Operand::Tag(Tag::number(Bank::Sc, number)))
            }
            Place::As(..) => {
                Err("Click has one kind for each address: give all names of it one type".to_owned())
            }
            Place::Chosen(_) | Place::ChosenMember(..) => {
                Err("Click chooses no timer or counter by an index: write a number".to_owned())
            }
            Place::Bit(..) => Err("Click has no single bits of words: unpack the word".to_owned()),
        }
    }

    /// As it is written, so that `16#00FF` stays one; by its value where that is unusual.
    fn constant(&self, value: &Value, range: TextRange) -> Result<Constant, Refusal> {
        let written = self.written(range);
        if let Some(digits) = written.strip_prefix("16#")
            && let Ok(number) = u32::from_str_radix(digits, 16)
        {
            return Ok(Constant::Hex(number));
        }
        if let Ok(number) = written.parse() {
            return Ok(Constant::Int(number));
        }
        Ok(match value {
            Value::Bool(on) => Constant::Bit(*on),
            Value::Int(number) => Constant::Int(*number),
            Value::Real(_) if written.parse::<f64>().is_ok() => {
                Constant::Float(written.parse().unwrap_or(0.0))
            }
            Value::Real(number) => Constant::Float(shortest(*number)),
            Value::Text(bytes) if bytes.is_ascii() => {
                Constant::Text(String::from_utf8_lossy(bytes).into_owned())
            }
            Value::Text(_) => return Err("Click's texts are ASCII".to_owned()),
        })
    }

    /// The expression of a `[CALC]` as a formula.
    pub(super) fn formula(&self, expr: &Expr) -> Result<Formula, Refusal> {
        Ok(match &expr.kind {
            ExprKind::Pass(inside) => self.formula(inside)?,
            ExprKind::Constant(_) if self.written(expr.range).eq_ignore_ascii_case("PI") => Formula::Pi,
            ExprKind::Constant(_) | ExprKind::Read(_) => Formula::Value(self.value(expr)?),
            ExprKind::Unary(UnaryOperator::Minus, inside) => match self.formula(inside)? {
                Formula::Value(Operand::Constant(Constant::Int(number))) => {
                    Formula::Value(Operand::Constant(Constant::Int(-number)))
                }
                Formula::Value(Operand::Constant(Constant::Float(number))) => {
                    Formula::Value(Operand::Constant(Constant::Float(-number)))
                }
                inside => Formula::Negated(Box::new(inside)),
            },
            ExprKind::Unary(UnaryOperator::Not, inside) => Formula::Not(Box::new(self.formula(inside)?)),
            ExprKind::Binary(operator, left, right) => {
                let operator = match operator {
                    BinaryOperator::Or => Operator::Or,
                    BinaryOperator::Xor => Operator::Xor,
                    BinaryOperator::And => Operator::And,
                    BinaryOperator::Shl => Operator::ShiftLeft,
                    BinaryOperator::Shr => Operator::ShiftRight,
                    BinaryOperator::Add => Operator::Add,
                    BinaryOperator::Sub => Operator::Subtract,
                    BinaryOperator::Mul => Operator::Multiply,
                    BinaryOperator::Div => Operator::Divide,
                    BinaryOperator::Mod => Operator::Modulo,
                    BinaryOperator::Power => Operator::Power,
                };
                Formula::Binary(
                    Box::new(self.formula(left)?),
                    operator,
                    Box::new(self.formula(right)?),
                )
            }
            ExprKind::Call(op, arguments) => {
                let function = match op {
                    Op::Sin => Function::Sin,
                    Op::Cos => Function::Cos,
                    Op::Tan => Function::Tan,
                    Op::Asin => Function::Asin,
                    Op::Acos => Function::Acos,
                    Op::Atan => Function::Atan,
                    Op::Log => Function::Log,
                    Op::Ln => Function::Ln,
                    Op::Sqrt => Function::Sqrt,
                    Op::Rad => Function::Rad,
                    Op::Deg => Function::Deg,
                    _ => return Err("Click's formulas have no such function".to_owned()),
                };
                let arguments = arguments.iter().map(|argument| self.formula(argument));
                Formula::Call(function, arguments.collect::<Result<_, _>>()?)
            }
            ExprKind::Sum(range) => Formula::Sum(self.span(range)?),
            ExprKind::Offset(_) => return Err("Click's arrays have one dimension".to_owned()),
            ExprKind::Compare(..) => return Err("Click's formulas compare nothing".to_owned()),
        })
    }
}

pub(super) fn stripped(expr: &Expr) -> &Expr {
    match &expr.kind {
        ExprKind::Pass(inside) => stripped(inside),
        _ => expr,
    }
}

/// A fixed index.
fn index(expr: &Expr) -> Option<u16> {
    match &stripped(expr).kind {
        ExprKind::Constant(Value::Int(number)) => u16::try_from(*number).ok(),
        _ => None,
    }
}

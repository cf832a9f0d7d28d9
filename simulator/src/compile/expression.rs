//! Expressions: each becomes a slot that holds its value, and the instructions that put it there.

use super::arguments::Arguments;
use super::place::Slot;
use super::{Compiler, Result};
use crate::code::Instr;
use crate::compile_error::CompileError;
use crate::memory::{Bit, TextSlot, Word};
use crate::operation::{Conversion, IntegerOp, RealFunction, RealOp, Width};
use ladder_analysis::program::{BinaryOperator, Expr, ExprKind, UnaryOperator};
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use ladder_instructions::Op;

impl Compiler<'_> {
    /// Computes an expression.
    pub(super) fn expression(&mut self, expr: &Expr) -> Result<Slot> {
        match &expr.kind {
            ExprKind::Constant(value) => Ok(self.literal(value)),
            ExprKind::Read(place) => {
                let spot = self.spot(place)?;
                Ok(self.load(spot))
            }
            ExprKind::Pass(inner) => {
                let value = self.expression(inner)?;
                Ok(self.pass(value, inner.ty, expr.ty))
            }
            ExprKind::Unary(operator, a) => {
                let a = self.expression(a)?;
                Ok(self.unary(*operator, expr.ty, a))
            }
            ExprKind::Binary(operator, a, b) => self.binary(*operator, expr.ty, a, b),
            ExprKind::Compare(op, a, b) => Ok(Slot::Bit(self.compare(*op, Bit::HIGH, a, b)?)),
            ExprKind::Call(op, arguments) => {
                let arguments: Vec<&Expr> = arguments.iter().collect();
                match self.function(*op, expr.ty, &arguments)? {
                    Some(value) => Ok(value),
                    None => Err(self.unknown_expression()),
                }
            }
            ExprKind::Sum(range) if self.notes_slips() && !expr.ty.is_real() => {
                let sum = self.sum(Scalar::Lint, range)?;
                Ok(Slot::Word(self.sum_noted(expr.ty, sum)))
            }
            ExprKind::Sum(range) => Ok(Slot::Word(self.sum(expr.ty, range)?)),
            ExprKind::Offset(subscripts) => Ok(Slot::Word(self.offset(subscripts)?)),
        }
    }

    /// An expression of type BOOL.
    pub(super) fn bit(&mut self, expr: &Expr) -> Result<Bit> {
        match self.expression(expr)? {
            Slot::Bit(slot) => Ok(slot),
            _ => Err(self.unknown_expression()),
        }
    }

    /// An expression of a type that is held in a word.
    pub(super) fn word(&mut self, expr: &Expr) -> Result<Word> {
        match self.expression(expr)? {
            Slot::Word(slot) => Ok(slot),
            _ => Err(self.unknown_expression()),
        }
    }

    /// An expression of type STRING.
    pub(super) fn text(&mut self, expr: &Expr) -> Result<TextSlot> {
        match self.expression(expr)? {
            Slot::Text(slot) => Ok(slot),
            _ => Err(self.unknown_expression()),
        }
    }

    /// A count, selector or index: any integer, held at the largest LINT if it is an ULINT past that.
    pub(super) fn count(&mut self, expr: &Expr) -> Result<Word> {
        let word = self.word(expr)?;
        if Width::of(expr.ty) != Width::U64 {
            return Ok(word);
        }
        let (to, most) = (self.layout.word(), self.constant(i64::MAX));
        self.emit(Instr::Integer {
            op: IntegerOp::Min,
            width: Width::U64,
            to,
            a: word,
            b: most,
        });
        Ok(to)
    }

    fn unknown_expression(&self) -> CompileError {
        let location = self.code.blocks.last().map(|block| block.location);
        CompileError {
            message: "the simulator cannot compute this block's operands yet".into(),
            location: location.unwrap_or(self.program.networks[0].location),
        }
    }

    pub(super) fn literal(&mut self, value: &Value) -> Slot {
        match value {
            Value::Bool(false) => Slot::Bit(Bit::LOW),
            Value::Bool(true) => Slot::Bit(Bit::HIGH),
            Value::Int(number) => Slot::Word(self.constant(*number)),
            Value::Real(real) => Slot::Word(self.constant(real.to_bits() as i64)),
            Value::Text(bytes) => Slot::Text(self.layout.text_constant(bytes)),
        }
    }

    /// Passes a value to another type without `[TYP]` (LANGUAGE §5.2). Most types pass as they are: a word holds
    /// the same number for SINT and LINT.
    pub(super) fn pass(&mut self, value: Slot, from: Scalar, to: Scalar) -> Slot {
        let word = match value {
            Slot::Word(word) => word,
            // Where a BOOL is a number.
            Slot::Bit(from) if to.is_integer() => {
                let to = self.layout.word();
                self.emit(Instr::BitToWord { to, from });
                return Slot::Word(to);
            }
            _ => return value,
        };
        let conversion = if to.is_real() && !from.is_real() {
            Conversion::IntegerToReal {
                from: Width::of(from),
                single: to == Scalar::Real,
            }
        } else if !to.is_real() && from.width() == to.width() && Width::of(from) != Width::of(to) {
            Conversion::Wrap(Width::of(to))
        } else {
            return value;
        };
        Slot::Word(self.convert(conversion, word))
    }

    pub(super) fn convert(&mut self, conversion: Conversion, from: Word) -> Word {
        let to = self.layout.word();
        self.emit(Instr::Convert { conversion, to, from });
        to
    }

    fn unary(&mut self, operator: UnaryOperator, ty: Scalar, a: Slot) -> Slot {
        match (a, operator) {
            (Slot::Bit(a), _) => {
                let to = self.layout.bit();
                self.emit(Instr::NotBit { to, a });
                Slot::Bit(to)
            }
            (Slot::Word(a), UnaryOperator::Minus) if ty.is_real() => {
                Slot::Word(self.real_function(RealFunction::Neg, ty, a))
            }
            (Slot::Word(a), UnaryOperator::Minus) => {
                let zero = self.constant(0);
                Slot::Word(self.pair(Op::Sub, ty, zero, a))
            }
            (Slot::Word(a), UnaryOperator::Not) => {
                let ones = self.constant(-1);
                Slot::Word(self.integer(IntegerOp::Xor, ty, a, ones))
            }
            (Slot::Text(_), _) => a,
        }
    }

    fn binary(&mut self, operator: BinaryOperator, ty: Scalar, a: &Expr, b: &Expr) -> Result<Slot> {
        match self.function(operator.op(), ty, &[a, b])? {
            Some(value) => Ok(value),
            None => Err(self.unknown_expression()),
        }
    }

    pub(super) fn integer(&mut self, op: IntegerOp, ty: Scalar, a: Word, b: Word) -> Word {
        let to = self.layout.word();
        self.emit(Instr::Integer {
            op,
            width: Width::of(ty),
            to,
            a,
            b,
        });
        to
    }

    pub(super) fn real(&mut self, op: RealOp, ty: Scalar, a: Word, b: Word) -> Word {
        let to = self.layout.word();
        self.emit(Instr::Real {
            op,
            single: ty == Scalar::Real,
            to,
            a,
            b,
        });
        to
    }

    pub(super) fn real_function(&mut self, function: RealFunction, ty: Scalar, a: Word) -> Word {
        let to = self.layout.word();
        self.emit(Instr::RealFunction {
            function,
            single: ty == Scalar::Real,
            to,
            a,
        });
        to
    }

    /// The values of a block's operands from the n-th on, as a function takes them.
    pub(super) fn function_of_block(&mut self, op: Op, ty: Scalar, arguments: Arguments) -> Result<Slot> {
        let values = arguments.values_from(1)?;
        self.function(op, ty, &values)?
            .ok_or_else(|| arguments.mismatch())
    }
}

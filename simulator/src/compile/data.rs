//! Data instructions (LANGUAGE §5.2): one function for each kind computes a value, for blocks and for the
//! functions of expressions alike.

use super::arguments::Arguments;
use super::place::{Slot, Spot};
use super::{Compiler, Result};
use crate::code::Instr;
use crate::memory::{Bit, Word};
use crate::operation::{Conversion, IntegerOp, RealFunction, RealOp, Test, Width};
use crate::routine::{Routine, type_operand};
use ladder_analysis::program::Expr;
use ladder_analysis::values::types::{Scalar, passes};
use ladder_instructions::{Division, Op};

impl Compiler<'_> {
    /// A block that writes its first operand when EN is high.
    pub(super) fn data(&mut self, op: Op, arguments: Arguments, en: Bit) -> Result<Bit> {
        let (place, ty) = arguments.place(0)?;
        let (out, start) = self.begin_powered(en);
        let spot = self.spot(place)?;
        self.begin_slips(op);
        let value = self.function_of_block(op, ty, arguments)?;
        let value = self.without_slips(value, arguments.formula_type(op, ty), ty);
        self.write_result(spot, value);
        self.end_slips();
        for bit in std::mem::take(&mut self.complaints) {
            self.routine(Routine::EndOnDivision, &[bit.0]);
        }
        self.end_powered(start);
        Ok(out)
    }

    /// Division where zero gives 0 and the last scan.
    fn divide_or_end(&mut self, ty: Scalar, a: Word, b: Word) -> Word {
        let (to, zero) = (self.layout.word(), self.constant(0));
        let [is_zero, divides, unused] = [self.layout.bit(), self.layout.bit(), self.layout.bit()];
        self.emit(Instr::Compare {
            test: Test::EQ,
            out: is_zero,
            en: Bit::HIGH,
            a: b,
            b: zero,
        });
        self.emit(Instr::NotBit {
            to: divides,
            a: is_zero,
        });
        self.emit(Instr::Move { to, from: zero });
        self.emit(Instr::IntegerWhen {
            op: IntegerOp::Div,
            width: Width::of(ty),
            out: unused,
            en: divides,
            to,
            a,
            b,
        });
        self.complaints.push(is_zero);
        to
    }

    /// Begins what is done with EN high only.
    pub(super) fn begin_powered(&mut self, en: Bit) -> (Bit, usize) {
        let out = self.layout.bit();
        let start = self.code.instrs.len();
        self.emit(Instr::Powered { out, en, end: 0 });
        (out, start)
    }

    /// Ends it. Where a single instruction is left, it takes the power itself.
    pub(super) fn end_powered(&mut self, start: usize) {
        let end = self.here();
        let Instr::Powered { out, en, .. } = self.code.instrs[start] else {
            return;
        };
        if let [_, only] = self.code.instrs[start..] {
            let one = match only {
                Instr::Move { to, from } => Some(Instr::MoveWhen { out, en, to, from }),
                Instr::Integer { op, width, to, a, b } => Some(Instr::IntegerWhen {
                    op,
                    width,
                    out,
                    en,
                    to,
                    a,
                    b,
                }),
                Instr::Real { op, single, to, a, b } => Some(Instr::RealWhen {
                    op,
                    single,
                    out,
                    en,
                    to,
                    a,
                    b,
                }),
                _ => None,
            };
            if let Some(one) = one {
                self.code.instrs.truncate(start);
                self.emit(one);
                return;
            }
        }
        self.code.instrs[start] = Instr::Powered { out, en, end };
    }

    /// Writes a value that was just computed. The instruction that computed it writes the tag itself where it
    /// can: it has read all it reads, and does not write if it faults.
    pub(super) fn write_result(&mut self, spot: Spot, value: Slot) {
        if let (Spot::Word(tag), Slot::Word(value)) = (spot, value) {
            match self.code.instrs.last_mut() {
                Some(
                    Instr::Integer { to, .. }
                    | Instr::Real { to, .. }
                    | Instr::RealFunction { to, .. }
                    | Instr::Convert { to, .. },
                ) if *to == value => {
                    *to = tag;
                    return;
                }
                _ => {}
            }
        }
        self.store(spot, value);
    }

    /// The value of an instruction or function of LANGUAGE §5.2, in a type. None if it does not give one.
    pub(super) fn function(&mut self, op: Op, ty: Scalar, operands: &[&Expr]) -> Result<Option<Slot>> {
        let value = match op {
            Op::Mov | Op::Calc => self.expression(operands[0])?,
            Op::Typ => {
                let value = self.expression(operands[0])?;
                return Ok(self.convert_to(ty, operands[0].ty, value));
            }
            Op::Wrap => {
                let value = self.word(operands[0])?;
                Slot::Word(self.convert(Conversion::Wrap(Width::of(ty)), value))
            }
            Op::Add | Op::Sub | Op::Mul | Op::Div | Op::Mod | Op::Exp | Op::Min | Op::Max => {
                Slot::Word(self.arithmetic(op, ty, operands)?)
            }
            Op::Limit => {
                let [low, a, high] = operands else { return Ok(None) };
                let (low, a, high) = (self.word(low)?, self.word(a)?, self.word(high)?);
                let at_least = self.pair(Op::Max, ty, a, low);
                Slot::Word(self.pair(Op::Min, ty, at_least, high))
            }
            Op::And | Op::Or | Op::Xor => self.logic(op, ty, operands)?,
            Op::Not => match self.expression(operands[0])? {
                Slot::Bit(a) => {
                    let to = self.layout.bit();
                    self.emit(Instr::NotBit { to, a });
                    Slot::Bit(to)
                }
                Slot::Word(a) => {
                    let ones = self.constant(-1);
                    Slot::Word(self.integer(IntegerOp::Xor, ty, a, ones))
                }
                Slot::Text(_) => return Ok(None),
            },
            Op::Shl | Op::Shr | Op::Rol | Op::Ror => {
                let [a, n] = operands else { return Ok(None) };
                let (a, n) = (self.word(a)?, self.count(n)?);
                let op = match op {
                    Op::Shl => IntegerOp::Shl,
                    Op::Shr => IntegerOp::Shr,
                    Op::Rol => IntegerOp::Rol,
                    _ => IntegerOp::Ror,
                };
                Slot::Word(self.integer(op, ty, a, n))
            }
            Op::Sel => return self.select(operands),
            Op::Mux | Op::Lut => return self.choose(operands),
            Op::Pwl => return self.curve(ty, operands),
            Op::Len
            | Op::Left
            | Op::Right
            | Op::Mid
            | Op::Concat
            | Op::Insert
            | Op::Delete
            | Op::Replace
            | Op::Find => return self.string_function(op, ty, operands),
            _ => match real_function_of(op) {
                Some(function) => Slot::Word(self.function_of_one(function, ty, operands[0])?),
                None => return Ok(None),
            },
        };
        Ok(Some(value))
    }

    /// From the left, but for powers, which group from the right.
    fn arithmetic(&mut self, op: Op, ty: Scalar, operands: &[&Expr]) -> Result<Word> {
        let mut operands = operands.to_vec();
        if op == Op::Mul && ty == Scalar::Time {
            // A time is scaled by numbers, wherever among them it is.
            operands.sort_by_key(|operand| operand.ty != Scalar::Time);
        }
        let words: Vec<Word> = operands
            .iter()
            .map(|operand| self.word(operand))
            .collect::<Result<_>>()?;
        if op == Op::Exp {
            let mut rest = words.iter().rev();
            let last = *rest.next().unwrap_or(&Word::SCAN);
            return Ok(rest.fold(last, |exponent, &base| self.pair(op, ty, base, exponent)));
        }
        let mut value = words[0];
        for (&word, operand) in words[1..].iter().zip(&operands[1..]) {
            value = if ty == Scalar::Time && operand.ty.is_real() {
                self.scale(op, value, word)
            } else {
                self.pair(op, ty, value, word)
            };
        }
        // One operand alone: still a value of its own, so that the result is written by one instruction.
        Ok(value)
    }

    /// A TIME times or by a real number.
    fn scale(&mut self, op: Op, time: Word, by: Word) -> Word {
        let time = self.convert(
            Conversion::IntegerToReal {
                from: Width::I64,
                single: false,
            },
            time,
        );
        let op = if op == Op::Div { RealOp::Div } else { RealOp::Mul };
        let scaled = self.real(op, Scalar::Lreal, time, by);
        self.convert(Conversion::Round(Width::I64), scaled)
    }

    /// One step of arithmetic in a type.
    pub(super) fn pair(&mut self, op: Op, ty: Scalar, a: Word, b: Word) -> Word {
        if let Some(value) = self.step_noted(op, ty, a, b) {
            return value;
        }
        if ty.is_real() {
            let op = match op {
                Op::Add => RealOp::Add,
                Op::Sub => RealOp::Sub,
                Op::Mul => RealOp::Mul,
                Op::Div => RealOp::Div,
                Op::Mod => RealOp::Mod,
                Op::Exp => RealOp::Power,
                Op::Min => RealOp::Min,
                _ => RealOp::Max,
            };
            return self.real(op, ty, a, b);
        }
        if op == Op::Div && self.semantics.division == Division::ZeroAndEnd {
            return self.divide_or_end(ty, a, b);
        }
        let op = match op {
            Op::Add => IntegerOp::Add,
            Op::Sub => IntegerOp::Sub,
            Op::Mul => IntegerOp::Mul,
            Op::Div => IntegerOp::Div,
            Op::Mod => IntegerOp::Mod,
            Op::Exp => IntegerOp::Power,
            Op::Min => IntegerOp::Min,
            _ => IntegerOp::Max,
        };
        self.integer(op, ty, a, b)
    }

    fn logic(&mut self, op: Op, ty: Scalar, operands: &[&Expr]) -> Result<Slot> {
        let mut value = self.expression(operands[0])?;
        for operand in &operands[1..] {
            let next = self.expression(operand)?;
            value = match (value, next) {
                (Slot::Bit(a), Slot::Bit(b)) => {
                    let to = self.layout.bit();
                    self.emit(match op {
                        Op::And => Instr::AndBit { to, a, b },
                        Op::Or => Instr::OrBit { to, a, b },
                        _ => Instr::XorBit { to, a, b },
                    });
                    Slot::Bit(to)
                }
                (Slot::Word(a), Slot::Word(b)) => {
                    let op = match op {
                        Op::And => IntegerOp::And,
                        Op::Or => IntegerOp::Or,
                        _ => IntegerOp::Xor,
                    };
                    Slot::Word(self.integer(op, ty, a, b))
                }
                _ => value,
            };
        }
        Ok(value)
    }

    fn function_of_one(&mut self, function: RealFunction, ty: Scalar, operand: &Expr) -> Result<Word> {
        let a = self.word(operand)?;
        match (function, ty.is_real(), operand.ty.is_real()) {
            (RealFunction::Abs, false, _) => Ok(self.integer(IntegerOp::Abs, ty, a, a)),
            (RealFunction::Neg, false, _) => {
                let zero = self.constant(0);
                Ok(self.integer(IntegerOp::Sub, ty, zero, a))
            }
            (RealFunction::Trunc, false, true) => Ok(self.convert(Conversion::Truncate(Width::of(ty)), a)),
            (RealFunction::Trunc, false, false) => {
                let conversion = Conversion::Fit {
                    from: Width::of(operand.ty),
                    to: Width::of(ty),
                };
                Ok(self.convert(conversion, a))
            }
            (RealFunction::Trunc, true, false) => {
                let from = Width::of(operand.ty);
                Ok(self.convert(
                    Conversion::IntegerToReal {
                        from,
                        single: ty == Scalar::Real,
                    },
                    a,
                ))
            }
            _ => Ok(self.real_function(function, ty, a)),
        }
    }

    /// `[TYP]`. None where there is no conversion.
    fn convert_to(&mut self, to: Scalar, from: Scalar, value: Slot) -> Option<Slot> {
        let from = match from {
            Scalar::Enum(_) if !to.is_string() => Scalar::Dint,
            other => other,
        };
        match (value, to) {
            (Slot::Word(word), Scalar::Enum(_)) => {
                let number = self.convert_number(Scalar::Dint, from, word)?;
                let value = self.layout.word();
                self.routine(Routine::Enumerate, &[value.0, type_operand(to), number.0]);
                Some(Slot::Word(value))
            }
            (Slot::Bit(_), Scalar::Bool) => Some(value),
            (Slot::Bit(bit), _) if !to.is_string() => {
                let word = self.layout.word();
                self.emit(Instr::BitToWord { to: word, from: bit });
                self.convert_word(to, Scalar::Usint, word)
            }
            (Slot::Word(word), Scalar::Bool) => {
                // 0 and 1 are BOOLs, any other number is out of range.
                let number = self.convert_number(Scalar::Usint, from, word)?;
                let one = self.constant(1);
                let excess = self.integer(IntegerOp::Sub, Scalar::Lint, one, number);
                let fits = self.convert(
                    Conversion::Fit {
                        from: Width::I64,
                        to: Width::U64,
                    },
                    excess,
                );
                let bit = self.layout.bit();
                let test = crate::operation::Test::EQ;
                let zero = self.constant(0);
                self.emit(Instr::Compare {
                    test,
                    out: bit,
                    en: Bit::HIGH,
                    a: fits,
                    b: zero,
                });
                Some(Slot::Bit(bit))
            }
            (Slot::Word(word), _) if !to.is_string() => match self.clamped(to, from, word) {
                Some(word) => Some(Slot::Word(word)),
                None => self.convert_word(to, from, word),
            },
            (Slot::Text(text), _) => Some(self.read_text(text, to)),
            (_, _) => Some(Slot::Text(self.as_text(value, from))),
        }
    }

    fn convert_word(&mut self, to: Scalar, from: Scalar, word: Word) -> Option<Slot> {
        self.convert_number(to, from, word).map(Slot::Word)
    }

    fn convert_number(&mut self, to: Scalar, from: Scalar, word: Word) -> Option<Word> {
        use Conversion as C;
        let conversion = match (from, to) {
            _ if from == to => return Some(word),
            (Scalar::Dt, Scalar::Date) => C::DayOf,
            (Scalar::Dt, Scalar::Tod) => C::TimeOfDayOf,
            (Scalar::Date, Scalar::Dt) => return Some(word),
            // What passes without a conversion gives the same with one: bits kept.
            _ if from.is_bits() != to.is_bits() && passes(from, to) => C::Wrap(Width::of(to)),
            _ if is_clock(from) && is_clock(to) => return None,
            _ if is_clock(from) && to.is_real() => C::TimeToReal {
                single: to == Scalar::Real,
            },
            _ if is_clock(from) => C::ToMilliseconds(Width::of(to)),
            _ if is_clock(to) && from.is_real() => C::RealToTime,
            _ if is_clock(to) => C::Milliseconds(Width::of(from)),
            (Scalar::Lreal, Scalar::Real) => C::Single,
            (Scalar::Real, Scalar::Lreal) => return Some(word),
            _ if from.is_real() => C::Round(Width::of(to)),
            _ if to.is_real() => C::IntegerToReal {
                from: Width::of(from),
                single: to == Scalar::Real,
            },
            _ => C::Fit {
                from: Width::of(from),
                to: Width::of(to),
            },
        };
        Some(self.convert(conversion, word))
    }
}

fn is_clock(ty: Scalar) -> bool {
    ty == Scalar::Time || ty.is_date()
}

fn real_function_of(op: Op) -> Option<RealFunction> {
    Some(match op {
        Op::Abs => RealFunction::Abs,
        Op::Neg => RealFunction::Neg,
        Op::Trunc => RealFunction::Trunc,
        Op::Sqrt => RealFunction::Sqrt,
        Op::Ln => RealFunction::Ln,
        Op::Log => RealFunction::Log,
        Op::Expe => RealFunction::Expe,
        Op::Sin => RealFunction::Sin,
        Op::Cos => RealFunction::Cos,
        Op::Tan => RealFunction::Tan,
        Op::Asin => RealFunction::Asin,
        Op::Acos => RealFunction::Acos,
        Op::Atan => RealFunction::Atan,
        Op::Rad => RealFunction::Rad,
        Op::Deg => RealFunction::Deg,
        _ => return None,
    })
}

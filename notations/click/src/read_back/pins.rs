//! Timers and counters, with their set points and pins.

use super::Back;
use super::value::{Refusal, stripped};
use crate::address::Tag;
use crate::bank::Bank;
use crate::model::{
    Bits, Condition, Constant, Contact, ContactKind, Counter, CounterKind, Instruction, Operand, Timer,
    TimerKind, Unit,
};
use ladder_analysis::program::{Argument, BinaryOperator, Bound, ExprKind};
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use ladder_instructions::Timing;

const MILLISECOND: i64 = 1_000_000;

impl Back<'_> {
    pub(super) fn timer(&mut self, kind: TimerKind, arguments: &[Bound]) -> Result<Instruction, Refusal> {
        let [state, setpoint, pins @ ..] = arguments else {
            return Err("the timer lacks operands".to_owned());
        };
        let tag = self.tag(state)?;
        let is_unit = |bound: &&Bound| bound.operand.is_some_and(|operand| operand.name == "B");
        let (setpoint, unit) = match pins.iter().find(is_unit) {
            Some(unit) => self.setpoint_in(setpoint, unit)?,
            None => self.setpoint(setpoint)?,
        };
        let pins: Vec<Bound> = pins.iter().filter(|bound| !is_unit(bound)).cloned().collect();
        let reset = self.pins(&pins, &["R"])?.pop().flatten();
        if reset.is_some() && !kind.is_retentive() {
            return Err("Click resets retentive timers only".to_owned());
        }
        Ok(Instruction::Timer(Timer {
            kind,
            tag,
            setpoint,
            unit,
            reset,
        }))
    }

    /// A set point where the timer names its unit.
    fn setpoint_in(&self, bound: &Bound, unit: &Bound) -> Result<(Operand, Unit), Refusal> {
        let size = time(unit).unwrap_or(0);
        let unit = Unit::lasting(size)
            .ok_or("Click's timers count milliseconds, seconds, minutes, hours or days")?;
        let setpoint = match time(bound) {
            Some(time) => Operand::Constant(Constant::Int(time / size)),
            None => self.operand(bound)?,
        };
        Ok((setpoint, unit))
    }

    fn setpoint(&self, bound: &Bound) -> Result<(Operand, Unit), Refusal> {
        if let Some(value) = time(bound) {
            // Where timers count milliseconds, they do so however the time is written.
            if self.program.semantics(self.program.networks[0].location).timing == Timing::Units {
                return Ok((
                    Operand::Constant(Constant::Int(value / MILLISECOND)),
                    Unit::Milliseconds,
                ));
            }
            let written = self.written(bound.range);
            return duration(written, value)
                .ok_or_else(|| "Click counts whole milliseconds up to 32767 days".to_owned());
        }
        // A plain number counts milliseconds here.
        if let Argument::Value(expr) = &bound.argument
            && let ExprKind::Binary(BinaryOperator::Mul, one, number) = &stripped(expr).kind
            && one.range == expr.range
        {
            return Ok((self.value(number)?, Unit::Milliseconds));
        }
        match self.operand(bound)? {
            Operand::Tag(tag) if tag.bank.kind().is_decimal() => Ok((Operand::Tag(tag), Unit::Milliseconds)),
            Operand::Constant(Constant::Int(number)) => {
                Ok((Operand::Constant(Constant::Int(number)), Unit::Milliseconds))
            }
            _ => Err("Click's set points are numbers and DS addresses".to_owned()),
        }
    }

    pub(super) fn counter(&mut self, kind: CounterKind, arguments: &[Bound]) -> Result<Instruction, Refusal> {
        let [state, setpoint, pins @ ..] = arguments else {
            return Err("the counter lacks operands".to_owned());
        };
        let mut pins = self.pins(pins, &["CD", "R"])?;
        let reset = pins.pop().flatten();
        let count_down = pins.pop().flatten();
        Ok(Instruction::Counter(Counter {
            kind,
            tag: self.tag(state)?,
            setpoint: self.operand(setpoint)?,
            count_down,
            reset,
        }))
    }

    /// The named operands as conditions, in this order.
    fn pins(&self, given: &[Bound], names: &[&str]) -> Result<Vec<Option<Condition>>, Refusal> {
        let name_of = |bound: &Bound| bound.operand.map_or("", |operand| operand.name);
        if let Some(odd) = given.iter().find(|bound| !names.contains(&name_of(bound))) {
            return Err(format!("Click has no pin {}", name_of(odd)));
        }
        let pin = |name: &&str| {
            let bound = given.iter().find(|bound| name_of(bound) == *name);
            bound.map(|bound| self.pin(bound)).transpose()
        };
        names.iter().map(pin).collect()
    }

    pub(super) fn pin(&self, bound: &Bound) -> Result<Condition, Refusal> {
        if let Some((tag, _)) = self.helper(Some(bound)) {
            let found = self.computed.conditions.get(&tag).cloned();
            return found.ok_or_else(|| "the rung that computes the pin is missing".to_owned());
        }
        match self.operand(bound)? {
            Operand::Tag(tag) if tag == Tag::number(Bank::Sc, 1) => Ok(Condition::ALWAYS),
            Operand::Tag(tag) => Ok(Condition::Contact(Contact {
                place: self.place_of_range(bound.range),
                kind: ContactKind::Open,
                bits: Bits::One(tag),
            })),
            Operand::Constant(Constant::Bit(true)) => Ok(Condition::ALWAYS),
            _ => Err("Click's pins are contacts".to_owned()),
        }
    }
}

/// A duration in the unit in which it is written, or in the largest that counts it whole.
fn duration(written: &str, nanoseconds: i64) -> Option<(Operand, Unit)> {
    let of = |number: i64, unit| Some((Operand::Constant(Constant::Int(number)), unit));
    let plain = written.to_ascii_lowercase();
    let plain = plain.trim_start_matches("time#").trim_start_matches("t#");
    let digits = plain.find(|c: char| !c.is_ascii_digit()).unwrap_or(0);
    let (number, suffix) = plain.split_at(digits);
    let row = Unit::ALL.iter().find(|(_, _, own, _)| *own == suffix);
    if let (Some((unit, ..)), Ok(number)) = (row, number.parse()) {
        return of(number, *unit);
    }
    if nanoseconds % MILLISECOND != 0 {
        return None;
    }
    let milliseconds = nanoseconds / MILLISECOND;
    let mut units = Unit::ALL.iter().rev();
    let whole =
        units.find(|(.., size)| milliseconds % size == 0 && (1..=32_767).contains(&(milliseconds / size)));
    let (unit, _, _, size) = whole?;
    of(milliseconds / size, *unit)
}

/// The value of an operand that is a fixed time, in nanoseconds.
pub(super) fn time(bound: &Bound) -> Option<i64> {
    let Argument::Value(expr) = &bound.argument else {
        return None;
    };
    match stripped(expr).kind {
        ExprKind::Constant(Value::Int(value)) if expr.ty == Scalar::Time => Some(value),
        _ => None,
    }
}

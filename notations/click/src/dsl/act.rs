//! Actions: what is under an `if`.

use super::super::address::Span;
use super::super::formula;
use super::super::model::{
    Coil, Counter, CounterKind, Instruction, Math, MathKind, Relation, Search, Shift, Timer, TimerKind, Unit,
};
use super::arguments::Arguments;
use super::condition::{bits, operand, shown};
use super::mistakes::{Mistakes, Unread, expression, statement};
use ruff_python_ast::{Expr, ExprCall, Stmt, StmtFor};
use ruff_text_size::Ranged;

/// An action, and whether it has its one-shot.
pub(super) type Read = (Instruction, bool);

/// A statement under an `if`.
pub(super) fn act(mistakes: &mut Mistakes<'_>, stmt: &Stmt) -> Result<Read, Unread> {
    match stmt {
        Stmt::Pass(_) => Ok((Instruction::Nop, false)),
        Stmt::Return(back) => match &back.value {
            None => Ok((Instruction::Return, false)),
            Some(value) => Err(mistakes.note(&**value, "`return` has no value in the DSL")),
        },
        Stmt::For(repeat) => Ok((self::repeat(mistakes, repeat)?, false)),
        Stmt::If(inner) => Err(mistakes.note(
            inner,
            "an `if` inside another is not in the DSL: write all(..) with both",
        )),
        Stmt::Expr(inside) => match &*inside.value {
            Expr::Call(call) => called(mistakes, call),
            other => {
                let what = expression(other);
                Err(mistakes.note(other, format!("{what} is no action of the DSL")))
            }
        },
        other => {
            let what = statement(other);
            Err(mistakes.note(other, format!("{what} is not in the DSL")))
        }
    }
}

/// `for _ in range(n): pass`
fn repeat(mistakes: &mut Mistakes<'_>, repeat: &StmtFor) -> Result<Instruction, Unread> {
    if repeat.is_async || !repeat.orelse.is_empty() {
        return Err(mistakes.note(
            repeat,
            "a loop of the DSL is `for _ in range(n):` with `pass` in it, and nothing else",
        ));
    }
    if !matches!(&*repeat.target, Expr::Name(name) if name.id == "_") {
        return Err(mistakes.note(
            &*repeat.target,
            "a loop of the DSL counts with `_`: for _ in range(n):",
        ));
    }
    let count = match &*repeat.iter {
        Expr::Call(call)
            if matches!(&*call.func, Expr::Name(name) if name.id == "range")
                && call.arguments.keywords.is_empty() =>
        {
            match &call.arguments.args[..] {
                [count] => operand(mistakes, count)?,
                _ => return Err(mistakes.note(call, "`range` takes the number of loops, and nothing else")),
            }
        }
        other => return Err(mistakes.note(other, "a loop of the DSL is `for _ in range(n):`")),
    };
    match &repeat.body[..] {
        [Stmt::Pass(_)] => Ok(Instruction::For(count)),
        body => {
            let message = "only `pass` is in a loop: what it repeats are the rungs up to next_loop()";
            Err(match body.first() {
                Some(first) => mistakes.note(first, message),
                None => mistakes.note(repeat, message),
            })
        }
    }
}

fn called(mistakes: &mut Mistakes<'_>, call: &ExprCall) -> Result<Read, Unread> {
    let (word, arguments) = Arguments::of(mistakes, call)?;
    let one = |name: &str, mistakes: &mut Mistakes<'_>| arguments.flag(mistakes, name);
    let oneshot = one("oneshot", mistakes)? || one("one_shot", mistakes)?;
    let coil = |mistakes: &mut Mistakes<'_>| {
        let address = arguments.must(mistakes, "address")?;
        let bits = bits(mistakes, address)?;
        Ok(Coil {
            bits,
            immediate: false,
        })
    };
    let instruction = match word {
        "out" => Instruction::Out(coil(mistakes)?),
        "set" => Instruction::Set(coil(mistakes)?),
        "reset" => Instruction::Reset(coil(mistakes)?),
        "ton" => timer(mistakes, &arguments, TimerKind::On)?,
        "tof" => timer(mistakes, &arguments, TimerKind::Off)?,
        "rton" => timer(mistakes, &arguments, TimerKind::RetentiveOn)?,
        "rtof" => timer(mistakes, &arguments, TimerKind::RetentiveOff)?,
        "ctu" => counter(mistakes, &arguments, CounterKind::Up)?,
        "ctd" => counter(mistakes, &arguments, CounterKind::Down)?,
        "ctud" => counter(mistakes, &arguments, CounterKind::UpDown)?,
        "copy" => Instruction::Copy {
            source: arguments.operand(mistakes, "source")?,
            target: arguments.operand(mistakes, "destination")?,
            options: arguments.options(mistakes)?,
        },
        "copy_block" => Instruction::BlockCopy {
            source: arguments.span(mistakes, "source_range")?,
            target: arguments.tag(mistakes, "destination_start")?,
            options: arguments.options(mistakes)?,
        },
        "copy_fill" => Instruction::Fill {
            source: arguments.operand(mistakes, "source")?,
            target: arguments.span(mistakes, "destination_range")?,
            options: arguments.options(mistakes)?,
        },
        "copy_pack" => Instruction::Pack {
            source: arguments.span(mistakes, "source_range")?,
            target: arguments.tag(mistakes, "destination")?,
            options: arguments.options(mistakes)?,
        },
        "copy_unpack" => Instruction::Unpack {
            source: arguments.tag(mistakes, "source")?,
            target: arguments.span(mistakes, "destination_range")?,
            options: arguments.options(mistakes)?,
        },
        "shift" => Instruction::Shift(Shift {
            bits: arguments.span(mistakes, "range")?,
            clock: arguments.pin(mistakes, "clock")?,
            reset: arguments.pin(mistakes, "reset")?,
        }),
        "search" => search(mistakes, &arguments)?,
        "calc" => math(mistakes, &arguments, MathKind::Decimal)?,
        "math_hex" => math(mistakes, &arguments, MathKind::Hex)?,
        "call" => match arguments.must(mistakes, "subroutine_name")? {
            Expr::Name(name) => Instruction::Call(name.id.to_string()),
            other => return Err(mistakes.note(other, "call() takes the name of a subroutine")),
        },
        "next_loop" => Instruction::Next,
        _ => Instruction::End,
    };
    Ok((instruction, oneshot))
}

fn timer(
    mistakes: &mut Mistakes<'_>,
    arguments: &Arguments<'_>,
    kind: TimerKind,
) -> Result<Instruction, Unread> {
    let unit = arguments.must(mistakes, "unit")?;
    let found = match unit {
        Expr::Name(name) => Unit::named(&name.id),
        _ => None,
    };
    let Some(unit) = found else {
        return Err(mistakes.note(unit, "a timer's unit is Tms, Ts, Tm, Th or Td"));
    };
    Ok(Instruction::Timer(Timer {
        kind,
        tag: arguments.tag(mistakes, "timer")?,
        setpoint: arguments.operand(mistakes, "setpoint")?,
        unit,
        reset: arguments.pin(mistakes, "reset")?,
    }))
}

fn counter(
    mistakes: &mut Mistakes<'_>,
    arguments: &Arguments<'_>,
    kind: CounterKind,
) -> Result<Instruction, Unread> {
    Ok(Instruction::Counter(Counter {
        kind,
        tag: arguments.tag(mistakes, "counter")?,
        setpoint: arguments.operand(mistakes, "setpoint")?,
        count_down: arguments.pin(mistakes, "count_down")?,
        reset: arguments.pin(mistakes, "reset")?,
    }))
}

fn search(mistakes: &mut Mistakes<'_>, arguments: &Arguments<'_>) -> Result<Instruction, Unread> {
    let (text, at) = arguments.text(mistakes, "condition")?;
    let Some(relation) = Relation::named(text) else {
        return Err(mistakes.note(at, "the condition of a search is eq, ne, gt, ge, lt or le"));
    };
    let start = arguments.tag(mistakes, "start_address")?;
    let end = arguments.tag(mistakes, "end_address")?;
    let (Some(first), Some(last)) = (start.address(), end.address()) else {
        let message = "a search goes from one number to another: ds[100], ds[200]";
        let at = arguments.must(mistakes, "start_address")?;
        return Err(mistakes.note(at, message));
    };
    if first.bank != last.bank {
        let at = arguments.must(mistakes, "end_address")?;
        return Err(mistakes.note(at, "a search stays in one bank"));
    }
    Ok(Instruction::Search(Search {
        relation,
        value: arguments.operand(mistakes, "search_value")?,
        among: Span {
            bank: first.bank,
            first: first.number,
            last: last.number,
        },
        result: arguments.tag(mistakes, "result_address")?,
        flag: arguments.tag(mistakes, "result_flag")?,
        continuous: arguments.flag(mistakes, "continuous")?,
    }))
}

fn math(
    mistakes: &mut Mistakes<'_>,
    arguments: &Arguments<'_>,
    kind: MathKind,
) -> Result<Instruction, Unread> {
    let (text, at) = arguments.text(mistakes, "formula")?;
    let formula = formula::parse(text).map_err(|mistake| {
        let around = shown(text.get(mistake.at..).unwrap_or(""));
        let at_end = mistake.at >= text.len();
        let place = if at_end {
            "at its end".to_owned()
        } else {
            format!("at `{around}`")
        };
        mistakes.note(
            &at.range(),
            format!("the formula cannot be read {place}: {}", mistake.message),
        )
    })?;
    Ok(Instruction::Math(Math {
        kind,
        formula,
        target: arguments.operand(mistakes, "result_destination")?,
    }))
}

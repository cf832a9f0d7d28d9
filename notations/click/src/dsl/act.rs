//! Actions: what is under an `if`.

use super::super::address::Span;
use super::super::formula;
use super::super::model::{
    Coil, Counter, CounterKind, Instruction, Math, MathKind, Relation, Search, Shift, Timer, TimerKind,
};
use super::arguments::Arguments;
use super::condition::{bits, operand, shown};
use super::drum;
use super::problems::{Problems, Unread, expression, statement};
use ruff_python_ast::{Expr, ExprCall, Stmt, StmtFor};
use ruff_text_size::Ranged;

/// An action, and whether it has its one-shot.
pub(super) type Read = (Instruction, bool);

/// A statement under an `if`.
pub(super) fn act(problems: &mut Problems<'_>, stmt: &Stmt) -> Result<Read, Unread> {
    match stmt {
        Stmt::Pass(_) => Ok((Instruction::Nop, false)),
        Stmt::Return(back) => match &back.value {
            None => Ok((Instruction::Return, false)),
            Some(value) => Err(problems.note(&**value, "`return` has no value in the DSL")),
        },
        Stmt::For(repeat) => Ok((self::repeat(problems, repeat)?, false)),
        Stmt::If(inner) => Err(problems.note(
            inner,
            "an `if` inside another is not in the DSL: write all(..) with both",
        )),
        Stmt::Expr(inside) => match &*inside.value {
            Expr::Call(call) => called(problems, call),
            other => {
                let what = expression(other);
                Err(problems.note(other, format!("{what} is not an action of the DSL")))
            }
        },
        other => {
            let what = statement(other);
            Err(problems.note(other, format!("{what} is not in the DSL")))
        }
    }
}

/// `for _ in range(n): pass`
fn repeat(problems: &mut Problems<'_>, repeat: &StmtFor) -> Result<Instruction, Unread> {
    if repeat.is_async || !repeat.orelse.is_empty() {
        return Err(problems.note(
            repeat,
            "a loop of the DSL is `for _ in range(n):` with `pass` in it, and nothing else",
        ));
    }
    if !matches!(&*repeat.target, Expr::Name(name) if name.id == "_") {
        return Err(problems.note(
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
                [count] => operand(problems, count)?,
                _ => return Err(problems.note(call, "`range` takes the number of loops, and nothing else")),
            }
        }
        other => return Err(problems.note(other, "a loop of the DSL is `for _ in range(n):`")),
    };
    match &repeat.body[..] {
        [Stmt::Pass(_)] => Ok(Instruction::For(count)),
        body => {
            let message = "only `pass` is in a loop: what it repeats are the rungs up to next_loop()";
            Err(match body.first() {
                Some(first) => problems.note(first, message),
                None => problems.note(repeat, message),
            })
        }
    }
}

fn called(problems: &mut Problems<'_>, call: &ExprCall) -> Result<Read, Unread> {
    let (word, arguments) = Arguments::of(problems, call)?;
    let one = |name: &str, problems: &mut Problems<'_>| arguments.flag(problems, name);
    let oneshot = one("oneshot", problems)? || one("one_shot", problems)?;
    let coil = |problems: &mut Problems<'_>| {
        let address = arguments.must(problems, "address")?;
        let bits = bits(problems, address)?;
        Ok(Coil {
            bits,
            immediate: false,
        })
    };
    let instruction = match word {
        "out" => Instruction::Out(coil(problems)?),
        "set" => Instruction::Set(coil(problems)?),
        "reset" => Instruction::Reset(coil(problems)?),
        "ton" => timer(problems, &arguments, TimerKind::On)?,
        "tof" => timer(problems, &arguments, TimerKind::Off)?,
        "rton" => timer(problems, &arguments, TimerKind::RetentiveOn)?,
        "rtof" => timer(problems, &arguments, TimerKind::RetentiveOff)?,
        "ctu" => counter(problems, &arguments, CounterKind::Up)?,
        "ctd" => counter(problems, &arguments, CounterKind::Down)?,
        "ctud" => counter(problems, &arguments, CounterKind::UpDown)?,
        "copy" => Instruction::Copy {
            source: arguments.operand(problems, "source")?,
            target: arguments.operand(problems, "destination")?,
            options: arguments.options(problems)?,
        },
        "copy_block" => Instruction::BlockCopy {
            source: arguments.span(problems, "source_range")?,
            target: arguments.tag(problems, "destination_start")?,
            options: arguments.options(problems)?,
        },
        "copy_fill" => Instruction::Fill {
            source: arguments.operand(problems, "source")?,
            target: arguments.span(problems, "destination_range")?,
            options: arguments.options(problems)?,
        },
        "copy_pack" => Instruction::Pack {
            source: arguments.span(problems, "source_range")?,
            target: arguments.tag(problems, "destination")?,
            options: arguments.options(problems)?,
        },
        "copy_unpack" => Instruction::Unpack {
            source: arguments.tag(problems, "source")?,
            target: arguments.span(problems, "destination_range")?,
            options: arguments.options(problems)?,
        },
        "shift" => Instruction::Shift(Shift {
            bits: arguments.span(problems, "range")?,
            clock: arguments.pin(problems, "clock")?,
            reset: arguments.pin(problems, "reset")?,
        }),
        "search" => search(problems, &arguments, call)?,
        "event_drum" => drum::read(problems, &arguments, false)?,
        "time_drum" => drum::read(problems, &arguments, true)?,
        "calc" => math(problems, &arguments, MathKind::Decimal, call)?,
        "math_hex" => math(problems, &arguments, MathKind::Hex, call)?,
        "call" => match arguments.must(problems, "subroutine_name")? {
            Expr::Name(name) => Instruction::Call(name.id.to_string()),
            other => return Err(problems.note(other, "call() takes the name of a subroutine")),
        },
        "next_loop" => Instruction::Next,
        _ => Instruction::End,
    };
    Ok((instruction, oneshot))
}

fn timer(
    problems: &mut Problems<'_>,
    arguments: &Arguments<'_>,
    kind: TimerKind,
) -> Result<Instruction, Unread> {
    let unit = drum::unit(problems, arguments)?;
    Ok(Instruction::Timer(Timer {
        kind,
        tag: arguments.tag(problems, "timer")?,
        setpoint: arguments.operand(problems, "setpoint")?,
        unit,
        reset: arguments.pin(problems, "reset")?,
    }))
}

fn counter(
    problems: &mut Problems<'_>,
    arguments: &Arguments<'_>,
    kind: CounterKind,
) -> Result<Instruction, Unread> {
    Ok(Instruction::Counter(Counter {
        kind,
        tag: arguments.tag(problems, "counter")?,
        setpoint: arguments.operand(problems, "setpoint")?,
        count_down: arguments.pin(problems, "count_down")?,
        reset: arguments.pin(problems, "reset")?,
    }))
}

fn search(
    problems: &mut Problems<'_>,
    arguments: &Arguments<'_>,
    call: &ExprCall,
) -> Result<Instruction, Unread> {
    let (text, at) = arguments.text(problems, "condition")?;
    let Some(relation) = Relation::named(text) else {
        return Err(problems.note(at, "the condition of a search is eq, ne, gt, ge, lt or le"));
    };
    let start = arguments.tag(problems, "start_address")?;
    let end = arguments.tag(problems, "end_address")?;
    let [first, last] = [start, end].map(|tag| problems.address(&tag));
    let (Some(first), Some(last)) = (first, last) else {
        return Ok(Instruction::Kept {
            text: problems.source(call).to_owned(),
            why: "a search goes from one number to another, and no nickname file says where its bounds are"
                .to_owned(),
        });
    };
    if first.bank != last.bank {
        let at = arguments.must(problems, "end_address")?;
        return Err(problems.note(at, "a search stays in one bank"));
    }
    Ok(Instruction::Search(Search {
        relation,
        value: arguments.operand(problems, "search_value")?,
        among: Span {
            bank: first.bank,
            first: first.number,
            last: last.number,
        },
        result: arguments.tag(problems, "result_address")?,
        flag: arguments.tag(problems, "result_flag")?,
        continuous: arguments.flag(problems, "continuous")?,
    }))
}

fn math(
    problems: &mut Problems<'_>,
    arguments: &Arguments<'_>,
    kind: MathKind,
    call: &ExprCall,
) -> Result<Instruction, Unread> {
    let (text, at) = arguments.text(problems, "formula")?;
    if let Err(why) = formula::shallow(text) {
        let text = problems.source(call).to_owned();
        return Ok(Instruction::Kept { text, why });
    }
    let formula = formula::parse(text).map_err(|error| {
        let around = shown(text.get(error.at..).unwrap_or(""));
        let at_end = error.at >= text.len();
        let place = if at_end {
            "at its end".to_owned()
        } else {
            format!("at `{around}`")
        };
        problems.note(
            &at.range(),
            format!("the formula cannot be read {place}: {}", error.message),
        )
    })?;
    Ok(Instruction::Math(Math {
        kind,
        formula,
        target: arguments.operand(problems, "result_destination")?,
    }))
}

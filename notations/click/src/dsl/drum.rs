//! Drums: `event_drum(outputs=[y[1]], events=[x[1]], pattern=[[1]], ..)`.

use super::super::address::Tag;
use super::super::drum::patterns;
use super::super::model::{Drum, Instruction, Steps, Unit};
use super::arguments::Arguments;
use super::condition::{condition, operand, tag};
use super::problems::{Problems, Unread};
use super::spell;
use ruff_python_ast::{Expr, Number};

/// The arguments of a drum, whose steps events or times end.
pub(super) fn read(
    problems: &mut Problems<'_>,
    arguments: &Arguments<'_>,
    is_timed: bool,
) -> Result<Instruction, Unread> {
    let outputs = given(problems, arguments, "outputs")?;
    let outputs: Vec<_> = outputs.iter().map(|output| tag(problems, output)).collect();
    let outputs = outputs.into_iter().collect::<Result<Vec<_>, _>>()?;
    let steps = if is_timed {
        let presets = given(problems, arguments, "presets")?;
        let presets: Vec<_> = presets.iter().map(|preset| operand(problems, preset)).collect();
        Steps::Times {
            presets: presets.into_iter().collect::<Result<_, _>>()?,
            unit: unit(problems, arguments)?,
            accumulator: arguments.tag(problems, "accumulator")?,
        }
    } else {
        let events = given(problems, arguments, "events")?;
        let events: Vec<_> = events.iter().map(|event| condition(problems, event)).collect();
        Steps::Events(events.into_iter().collect::<Result<_, _>>()?)
    };
    let written = arguments.must(problems, "pattern")?;
    let mut rows = Vec::new();
    for row in list(problems, written)? {
        let row = list(problems, row)?.iter().map(|value| on(problems, value));
        rows.push(row.collect::<Result<Vec<bool>, _>>()?);
    }
    let pattern = patterns(&rows, outputs.len()).map_err(|why| problems.note(written, why))?;
    let jump_step = arguments.get("jump_step");
    Ok(Instruction::Drum(Box::new(Drum {
        steps,
        outputs,
        pattern,
        current_step: arguments.tag(problems, "current_step")?,
        completion_flag: arguments.tag(problems, "completion_flag")?,
        reset: arguments.pin(problems, "reset")?,
        jump: arguments.pin(problems, "jump")?,
        jump_step: jump_step.map(|step| operand(problems, step)).transpose()?,
        jog: arguments.pin(problems, "jog")?,
    })))
}

/// The unit in which a timer or a drum counts.
pub(super) fn unit(problems: &mut Problems<'_>, arguments: &Arguments<'_>) -> Result<Unit, Unread> {
    let unit = arguments.must(problems, "unit")?;
    let found = match unit {
        Expr::Name(name) => Unit::named(&name.id),
        _ => None,
    };
    found.ok_or_else(|| problems.note(unit, "a timer's unit is Tms, Ts, Tm, Th or Td"))
}

/// A list that is an argument.
fn given<'e>(
    problems: &mut Problems<'_>,
    arguments: &Arguments<'e>,
    name: &str,
) -> Result<&'e [Expr], Unread> {
    let argument = arguments.must(problems, name)?;
    list(problems, argument)
}

fn list<'e>(problems: &mut Problems<'_>, expr: &'e Expr) -> Result<&'e [Expr], Unread> {
    match expr {
        Expr::List(list) => Ok(&list.elts),
        other => Err(problems.note(other, "a drum has lists here: [y[1], y[2]]")),
    }
}

fn on(problems: &mut Problems<'_>, value: &Expr) -> Result<bool, Unread> {
    match value {
        Expr::BooleanLiteral(literal) => Ok(literal.value),
        Expr::NumberLiteral(literal) => match &literal.value {
            Number::Int(number) if number.as_u8() == Some(0) => Ok(false),
            Number::Int(number) if number.as_u8() == Some(1) => Ok(true),
            _ => Err(problems.note(value, "a drum's output is 0 or 1 in each step")),
        },
        other => Err(problems.note(other, "a drum's output is 0 or 1 in each step")),
    }
}

/// The named arguments of a drum, as they are written.
pub(super) fn arguments(drum: &Drum) -> Vec<(&'static str, String)> {
    let bracketed = |parts: Vec<String>| format!("[{}]", parts.join(", "));
    let mut out = vec![("outputs", bracketed(drum.outputs.iter().map(Tag::dsl).collect()))];
    match &drum.steps {
        Steps::Events(events) => {
            out.push(("events", bracketed(events.iter().map(spell::condition).collect())));
        }
        Steps::Times { presets, unit, .. } => {
            out.push(("presets", bracketed(presets.iter().map(spell::operand).collect())));
            out.push(("unit", unit.name().to_owned()));
        }
    }
    let row = |pattern: &u16| {
        let bits = (0..drum.outputs.len()).map(|at| (pattern >> at & 1).to_string());
        bracketed(bits.collect())
    };
    out.push(("pattern", bracketed(drum.pattern.iter().map(row).collect())));
    out.push(("current_step", drum.current_step.dsl()));
    if let Steps::Times { accumulator, .. } = &drum.steps {
        out.push(("accumulator", accumulator.dsl()));
    }
    out.push(("completion_flag", drum.completion_flag.dsl()));
    for (name, pin) in [("reset", &drum.reset), ("jump", &drum.jump), ("jog", &drum.jog)] {
        if let Some(pin) = pin {
            out.push((name, format!("lambda: {}", spell::condition(pin))));
        }
        if name == "jump"
            && let Some(step) = &drum.jump_step
        {
            out.push(("jump_step", spell::operand(step)));
        }
    }
    out
}

//! Blocks on a rung as parts.

use super::declare::type_name;
use super::operand::{self, is_timer, operand};
use super::power::{POWER_IN, POWER_OUT, Power};
use super::tags::Tags;
use crate::model::{self, Argument, Part, Value};
use crate::standard::{Form, Pins, Row, of_form, of_op};
use ladder_analysis::program::{self, Block, BlockKind, Bound, ExprKind, ParameterKind};
use ladder_analysis::values::types::{Scalar, Type};
use ladder_analysis::values::value;
use ladder_format::program::{Expression, Operator, Path, Step};
use ladder_instructions::{Instruction, Op};

type Result<T> = std::result::Result<T, String>;

/// A block.
///
/// # Errors
///
/// Why it has no form there.
pub(super) fn part(tags: &mut Tags<'_>, block: &Block) -> Result<Part> {
    let own = match block.kind {
        BlockKind::Instruction(own) => own,
        BlockKind::User(_) => return call(tags, block, ("TRUE", None)),
    };
    let none = || format!("`[{}]` has no counterpart", own.mnemonic);
    let row = row_of(own, block).ok_or_else(none)?;
    let part = Part::named(row.sd[0]);
    let arguments = &block.arguments;
    let first = || arguments.first().ok_or("its operand is missing");
    Ok(match row.form {
        Form::Contact(_) | Form::Coil(_) => part.given("operand", given(tags, first()?)?),
        Form::EdgeContact(_) => {
            let bit = given(tags, first()?)?;
            part.given("operand", bit).given("bit", tags.memory())
        }
        Form::EdgeCoil(_) => {
            let bit = given(tags, first()?)?;
            part.taken("operand", bit).given("bit", tags.memory())
        }
        Form::Edge(_) => part.given("bit", tags.memory()),
        Form::Not | Form::Return => part,
        Form::Bits(_) => bits(tags, part, first()?)?,
        Form::ResetTimer => part.given("timer", timer(tags, first()?)?),
        Form::Jump { .. } => {
            let label = tags.project.source_of(first()?);
            part.given("label", format!("\"{label}\""))
        }
        Form::Move => part
            .given("in", given(tags, &arguments[1])?)
            .taken("out1", given(tags, &arguments[0])?),
        Form::Convert => {
            let from = type_at(&arguments[1]).ok_or("its value has no type there")?;
            let to = type_at(&arguments[0]).ok_or("its result has no type there")?;
            let part = part.typed("SrcType", from).typed("DestType", to);
            part.given("in", given(tags, &arguments[1])?)
                .taken("out", given(tags, &arguments[0])?)
        }
        Form::Calculate => calculated(tags, part, block)?,
        _ => of_table(tags, part, row, own, block)?,
    })
}

/// What an instruction is written as, with these operands.
fn row_of(own: &Instruction, block: &Block) -> Option<&'static Row> {
    match (own.op, block.arguments.first().map(|bound| &bound.argument)) {
        (op @ (Op::SetCoil | Op::ResetCoil), Some(program::Argument::Range(_))) => of_form(Form::Bits(op)),
        (
            Op::SetCoil | Op::ResetCoil,
            Some(program::Argument::State(_) | program::Argument::ChosenState(_)),
        ) => of_form(Form::ResetTimer),
        (Op::Le, _) if block.arguments.len() == 3 => of_form(Form::InRange),
        (op, _) => of_op(op),
    }
}

/// The instructions that differ in their names and pins alone.
fn of_table(tags: &mut Tags<'_>, part: Part, row: &Row, own: &Instruction, block: &Block) -> Result<Part> {
    let arguments = &block.arguments;
    let name = row.sd[0];
    if block.works_in == Some(Scalar::Bool) && matches!(own.op, Op::And | Op::Or | Op::Xor | Op::Not) {
        return Err(format!(
            "`{name}` is for words there, and not for one bit: draw it with contacts"
        ));
    }
    let operands: Result<Vec<String>> = arguments.iter().map(|bound| given(tags, bound)).collect();
    let operands = operands?;
    let works_in = || {
        let ty = block.works_in.and_then(type_name);
        ty.ok_or_else(|| "the type that it works in has no form there".to_owned())
    };
    let typed = |part: Part, ty: &str| row.template.map_or(part.clone(), |name| part.typed(name, ty));
    let with = |part: Part, pins: &[&str], operands: &[String]| {
        let pins = pins.iter().zip(operands);
        pins.fold(part, |part, (pin, operand)| part.given(*pin, operand))
    };
    match row.form {
        Form::InRange => Ok(with(typed(part, works_in()?), &["min", "in", "max"], &operands)),
        Form::Compare(_) if operands.len() == 2 => {
            Ok(with(typed(part, works_in()?), &["in1", "in2"], &operands))
        }
        Form::State(_, pins) => {
            let [state, rest @ ..] = &operands[..] else {
                return Err("its operand is missing".to_owned());
            };
            let (ty, shows) = match row.template {
                Some("value_type") => ("DInt", "cv"),
                _ => ("Time", "et"),
            };
            let mut part = typed(part, ty);
            part.instance = Some(state.clone());
            for (pin, named) in pins {
                let mut rest = arguments[1..].iter().zip(rest);
                let found = rest.find(|(bound, _)| tags.project.name_of(bound).eq_ignore_ascii_case(named));
                if let Some((_, operand)) = found {
                    part = part.given(*pin, operand);
                }
            }
            if part.arguments.len() < rest.len() {
                return Err(format!("an operand of `[{}]` has no pin there", own.mnemonic));
            }
            part.arguments.push(Argument {
                value: Value::Open,
                ..Argument::new(shows, "", true)
            });
            Ok(part)
        }
        Form::Value(op, pins) => {
            let [out, values @ ..] = &operands[..] else {
                return Err("its operand is missing".to_owned());
            };
            let pins = names_of(pins, values.len());
            if pins.len() != values.len() {
                return Err(format!("`{name}` has {} values there", pins.len()));
            }
            let part = if op == Op::Trunc {
                let from = type_at(&arguments[1]).unwrap_or("Real");
                let to = type_at(&arguments[0]).unwrap_or("Int");
                part.typed("SrcType", from).typed("DestType", to)
            } else {
                typed(part, works_in()?)
            };
            let pins: Vec<&str> = pins.iter().map(String::as_str).collect();
            Ok(with(part, &pins, values).taken("out", out))
        }
        _ => Err(format!("`[{}]` has no counterpart", own.mnemonic)),
    }
}

/// The names of pins for so many values.
fn names_of(pins: Pins, count: usize) -> Vec<String> {
    let numbered = |first: usize, count: usize| (first..first + count).map(|number| format!("in{number}"));
    match pins {
        Pins::Named(pins) => pins.iter().map(|pin| (*pin).to_owned()).collect(),
        Pins::Numbered => numbered(1, count).collect(),
        Pins::Selected(selector) => {
            let selector = std::iter::once(selector.to_owned());
            selector.chain(numbered(0, count.saturating_sub(1))).collect()
        }
    }
}

/// `[CALC]`: each tag and number of the formula is a pin.
fn calculated(tags: &mut Tags<'_>, mut part: Part, block: &Block) -> Result<Part> {
    let ty = block.works_in.and_then(type_name).filter(|ty| *ty != "Bool");
    let ty = ty.ok_or("Calculate makes numbers and bit strings only")?;
    let out = given(tags, &block.arguments[0])?;
    let formula = Expression::read(tags.project.source_of(&block.arguments[1]))?;
    let mut pins = Vec::new();
    let formula = with_pins(tags, &formula, &mut pins)?;
    part.formula = Some(formula.to_string().replace('^', "**"));
    let numbered = pins.into_iter().enumerate();
    let part = numbered.fold(part.typed("SrcType", ty), |part, (number, pin)| {
        part.given(format!("in{}", number + 1), pin)
    });
    Ok(part.taken("out", out))
}

/// A formula with the names of pins in the place of its tags and numbers.
fn with_pins(tags: &Tags<'_>, formula: &Expression, pins: &mut Vec<String>) -> Result<Expression> {
    let mut inside = |inner: &Expression| with_pins(tags, inner, pins);
    Ok(match formula {
        Expression::Literal(_) | Expression::Path(_) => {
            let pin = operand::value(formula, tags)?;
            let number = pins.iter().position(|own| *own == pin).unwrap_or_else(|| {
                pins.push(pin);
                pins.len() - 1
            });
            Path::tag(format!("IN{}", number + 1)).into()
        }
        Expression::Unary(sign, inner) => Expression::Unary(*sign, Box::new(inside(inner)?)),
        Expression::Group(inner) => Expression::Group(Box::new(inside(inner)?)),
        Expression::Binary(operator, ..) if operator.compares() => {
            return Err("Calculate compares nothing".to_owned());
        }
        Expression::Binary(Operator::Shl, ..) => return Err("Calculate has no `SHL`".to_owned()),
        Expression::Binary(Operator::Shr, ..) => return Err("Calculate has no `SHR`".to_owned()),
        Expression::Binary(operator, left, right) => {
            let left = match inside(left)? {
                // A power binds more tightly than a sign there.
                left @ Expression::Unary(..) if *operator == Operator::Power => {
                    Expression::Group(Box::new(left))
                }
                left => left,
            };
            left.with(*operator, inside(right)?)
        }
        Expression::Call(function, arguments) => {
            let upper = function.to_ascii_uppercase();
            let function = match upper.as_str() {
                "ABS" | "SQRT" | "LN" | "SIN" | "COS" | "TAN" | "ASIN" | "ACOS" | "ATAN" => upper.as_str(),
                "EXPE" => "EXP",
                _ => return Err(format!("Calculate has no `{upper}`")),
            };
            let arguments: Result<Vec<Expression>> = arguments.iter().map(inside).collect();
            Expression::call(function, arguments?)
        }
    })
}

fn bits(tags: &Tags<'_>, part: Part, bound: &Bound) -> Result<Part> {
    let range = match Expression::read(tags.project.source_of(bound))? {
        Expression::Path(mut path) => match path.steps.pop() {
            Some(Step::Range(before, range)) if before.is_empty() => Some((path, *range)),
            _ => None,
        },
        _ => None,
    };
    let (array, (first, last)) = range.ok_or("a bit field begins at an element")?;
    let number = |bound: &Expression| {
        let number = bound.to_string().parse::<i64>();
        number.map_err(|_| "a bit field has a constant length".to_owned())
    };
    let count = number(&last)?.saturating_sub(number(&first)?) + 1;
    let start = operand::value(&array.index([first]).into(), tags)?;
    Ok(part.given("operand", start).given("n", count.to_string()))
}

/// A timer that is reset.
fn timer(tags: &Tags<'_>, bound: &Bound) -> Result<String> {
    let state = Expression::read(tags.project.source_of(bound))?;
    match state.path().and_then(|path| operand::type_at(path, tags)) {
        Some(Type::State(state_type)) if is_timer(state_type) => operand::value(&state, tags),
        _ => Err("only timers are reset by a coil there: a counter has its R".to_owned()),
    }
}

/// A block of one's own: `#"pump"( start := #"a", running => #"b" )`. `power`: what it is given, and what keeps what it
/// returns.
pub(super) fn call(tags: &mut Tags<'_>, block: &Block, power: (&str, Option<&str>)) -> Result<Part> {
    let project = tags.project;
    let BlockKind::User(user) = block.kind else {
        return Err("it is not a block of one's own".to_owned());
    };
    let facts = project.source(user);
    let facts = facts.map(|source| &project.analysis.context.user_blocks[source.scope - 1]);
    if let Some(why) = project.why_unwritable(user) {
        return Err(why.clone());
    }
    let mut part = Part::default();
    if let Power::Given { reads: true, .. } = project.used[user].power {
        part = part.given(POWER_IN, power.0);
    }
    for bound in &block.arguments {
        let Some(parameter) = bound.parameter else {
            part.name = operand(project.source_of(bound), tags)?;
            continue;
        };
        let own = facts.and_then(|facts| facts.parameters.get(parameter));
        let own = own.ok_or("its parameters are not known")?;
        let name = own.name.as_str();
        let text = given(tags, bound)?;
        part = match own.kind {
            ParameterKind::Output => part.taken(name, text),
            ParameterKind::Input | ParameterKind::InOut => part.given(name, text),
        };
    }
    if let Some(kept) = power.1 {
        part = part.taken(POWER_OUT, kept);
    }
    if part.name.is_empty() {
        let name = &project.program.blocks[user].name[1..];
        part.name = tags.make(name, model::Type::Named(name.to_owned()));
    }
    Ok(part)
}

/// What is given for an operand.
fn given(tags: &mut Tags<'_>, bound: &Bound) -> Result<String> {
    if let program::Argument::Value(value) = &bound.argument
        && let (Scalar::Enum(id), ExprKind::Constant(value::Value::Int(number))) = (value.ty, &value.kind)
    {
        return Ok(tags.named_value(&id.get(), *number));
    }
    operand(tags.project.source_of(bound), tags)
}

/// The name there of the type of what is given.
fn type_at(bound: &Bound) -> Option<&'static str> {
    match &bound.argument {
        program::Argument::Value(value) => type_name(value.ty),
        program::Argument::Place(_, ty) => type_name(*ty),
        _ => None,
    }
}

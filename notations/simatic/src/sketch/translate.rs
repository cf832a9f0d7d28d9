//! Instructions as elements of a rung.

use super::call::Labels;
use crate::model::{Argument, Part, Value};
use crate::operand::{Operand, at_pin, literal, operand};
use crate::scope::{Scope, passes};
use crate::standard::{Form, Pins, Row, elementary};
use ladder_format::program::{Block, Expression, Literal, Operand as Given, Operator, Path, Step};
use ladder_instructions::{Op, by_op};
use ladder_notation_st::read::Edge;

/// What an instruction became.
#[derive(Debug, Default)]
pub(super) struct Translated {
    /// One after the other.
    pub(super) blocks: Vec<Block>,
    /// The tag that the power before it goes into: it begins at the rail.
    pub(super) cut: Option<String>,
    /// Networks after this one.
    pub(super) after: Vec<Vec<Block>>,
    /// Why it is not quite the same.
    pub(super) note: Option<String>,
}

/// What translates the instructions of a block.
pub(super) struct Translator<'s, 'l> {
    pub(super) scope: &'s mut Scope<'l>,
    pub(super) labels: Labels,
}

type Result<T> = std::result::Result<T, String>;

fn one<O: Into<Given>>(op: Op, operands: impl IntoIterator<Item = O>) -> Result<Translated> {
    Ok(series([Block::of(op, operands)?]))
}

fn series<const N: usize>(blocks: [Block; N]) -> Translated {
    Translated {
        blocks: blocks.into(),
        ..Translated::default()
    }
}

impl Translator<'_, '_> {
    /// An instruction of the table.
    ///
    /// # Errors
    ///
    /// Why it has no counterpart here.
    pub(super) fn instruction(&mut self, row: &Row, part: &Part) -> Result<Translated> {
        match row.form {
            Form::Contact(op) => {
                let bit = self.bit(part, "operand")?.value;
                let bit = match &bit {
                    Expression::Literal(literal) => always(literal).into(),
                    _ => bit,
                };
                one(op, [bit])
            }
            Form::EdgeContact(op) | Form::Coil(op) | Form::EdgeCoil(op) => {
                one(op, [self.bit(part, "operand")?.value])
            }
            Form::Edge(op) => one(op, Given::NONE),
            Form::Not => one(Op::Inverter, Given::NONE),
            Form::Compare(op) => one(op, self.values(part, ["in1", "in2"])?),
            Form::CompareBox(sign) => {
                let [a, b] = self.values(part, ["in1", "in2"])?;
                let out = self.out(part, "out", "BOOL")?;
                one(Op::Calc, [out.value, a.with(sign, b)])
            }
            Form::InRange => one(Op::Le, self.values(part, ["min", "in", "max"])?),
            Form::OutRange => {
                let [min, value, max] = self.values(part, ["min", "in", "max"])?;
                let about = "whether a value is outside of its range";
                let helper = Expression::from(self.helper("outside", "BOOL", about));
                let below = value.clone().with(Operator::Less, min);
                let outside = below.with(Operator::Or, value.with(Operator::Greater, max));
                Ok(series([
                    Block::of(Op::Calc, [helper.clone(), outside])?,
                    Block::contact(helper),
                ]))
            }
            Form::Valid(op) => {
                let value = self.only(part, "operand", "REAL")?.value;
                one(op, [value.clone(), value])
            }
            Form::Bits(op) => {
                let first = self.bit(part, "operand")?.value;
                let [count] = self.values(part, ["n"])?;
                let range = bits(&first, &count)
                    .ok_or("only bits of an array, from a constant index on, can be set together here")?;
                one(op, [range])
            }
            Form::Bistable { reset_wins } => self.bistable(part, reset_wins),
            Form::Trigger(edge) => self.trigger(part, edge),
            Form::State(op, pins) => self.state(part, op, pins),
            Form::TimerCoil(op) => {
                let timer = self.only(part, "timer", by_op(op).mnemonic)?;
                let time = self.pin(part, "pt", "TIME")?;
                one(op, [timer.value, time.value])
            }
            Form::ResetTimer => one(Op::Res, [self.only(part, "timer", "TON")?.value]),
            Form::Move => self.moves(part),
            Form::Value(op, pins) => self.computed(part, op, pins),
            Form::Square => {
                let ty = works_in(part);
                let value = self.pin(part, "in", ty)?.value;
                self.result(part, ty, Op::Mul, &[value.clone(), value])
            }
            Form::Step(op) => {
                let it = self.only(part, "operand", works_in(part))?.value;
                one(op, [it.clone(), it, 1.into()])
            }
            Form::Convert => {
                let from = part.template("SrcType").and_then(elementary).unwrap_or("INT");
                let to = part.template("DestType").and_then(elementary).unwrap_or("INT");
                let value = self.pin(part, "in", from)?;
                let out = self.out(part, "out", to)?;
                one(Op::Typ, [out.value, value.value])
            }
            Form::Calculate => self.calculated(part),
            Form::Jump { negated } => {
                let label = part.only("label").map(|argument| &argument.value);
                let Some(Value::Operand(label)) = label else {
                    return Err("it names no label".to_owned());
                };
                let jump = Block::jump(&self.label(label));
                if negated {
                    return Ok(series([Block::of(Op::Inverter, Given::NONE)?, jump]));
                }
                Ok(series([jump]))
            }
            Form::Return => {
                let mut done = series([Block::ret()]);
                if !part.arguments.is_empty() || part.name != "Return" {
                    done.note = Some("the power that the block leaves is not set".to_owned());
                }
                Ok(done)
            }
        }
    }

    /// A label as it is spelled here.
    pub(super) fn label(&mut self, name: &str) -> String {
        self.labels.spell(name)
    }

    /// A tag that the source does not have.
    fn helper(&mut self, like: &str, ty: &str, about: &str) -> Path {
        Path::tag(self.scope.helper(like, ty, about))
    }

    /// The operand at a pin.
    pub(super) fn pin(&mut self, part: &Part, pin: &str, wanted: &str) -> Result<Operand> {
        at_pin(self.scope, part.pin(pin), wanted)
            .unwrap_or_else(|| Err(format!("nothing is at its pin `{pin}`")))
    }

    fn only(&mut self, part: &Part, pin: &str, wanted: &str) -> Result<Operand> {
        at_pin(self.scope, part.only(pin), wanted).unwrap_or_else(|| Err("its operand is missing".to_owned()))
    }

    fn bit(&mut self, part: &Part, pin: &str) -> Result<Operand> {
        self.only(part, pin, "BOOL")
    }

    fn values<const N: usize>(&mut self, part: &Part, pins: [&str; N]) -> Result<[Expression; N]> {
        let mut values = pins.map(|_| Expression::from(0));
        for (value, pin) in values.iter_mut().zip(pins) {
            *value = self.pin(part, pin, works_in(part))?.value;
        }
        Ok(values)
    }

    /// What is written at a pin; a tag of its own where nothing is.
    fn out(&mut self, part: &Part, pin: &str, ty: &str) -> Result<Operand> {
        if part.pin(pin).is_some() {
            return self.pin(part, pin, ty);
        }
        let helper = self.helper("result", ty, "a result that nothing takes");
        Ok(Operand::new(helper, ty))
    }

    /// A result that is computed from values in a type, and brought to the type of what takes it.
    fn result(&mut self, part: &Part, ty: &str, op: Op, values: &[Expression]) -> Result<Translated> {
        let out = self.out(part, "out", ty)?;
        let computed = |out: &Expression| Block::of(op, std::iter::once(out).chain(values).cloned());
        match out.plain() {
            Some(to) if !passes(ty, to) => {
                let helper = self.helper("result", ty, "a result before it is converted");
                let helper = Expression::from(helper);
                let result = computed(&helper)?;
                Ok(series([result, Block::of(Op::Typ, [out.value, helper])?]))
            }
            _ => Ok(series([computed(&out.value)?])),
        }
    }

    fn moves(&mut self, part: &Part) -> Result<Translated> {
        let mut done = Translated::default();
        for out in part.arguments.iter().filter(|argument| argument.is_output) {
            // Of two that nobody declares the one that is moved has the type of the other.
            let wanted = part.pin("in").and_then(least_type).unwrap_or("INT");
            let Some(known) = at_pin(self.scope, Some(out), wanted).transpose()? else {
                continue;
            };
            let value = self.pin(part, "in", known.plain().unwrap_or("INT"))?;
            let op = match (value.plain(), known.plain()) {
                (Some(from), Some(to)) if !value.is_literal() && !passes(from, to) => Op::Typ,
                _ => Op::Mov,
            };
            done.blocks.push(Block::of(op, [known.value, value.value])?);
        }
        if done.blocks.is_empty() {
            return Err("nothing takes its value".to_owned());
        }
        Ok(done)
    }

    fn computed(&mut self, part: &Part, op: Op, pins: Pins) -> Result<Translated> {
        let ty = works_in(part);
        let mut values = Vec::new();
        let numbered = |first: usize| (first..).map(|number| format!("in{number}"));
        match pins {
            Pins::Named(pins) => {
                for pin in pins {
                    values.push(self.pin(part, pin, if *pin == "n" { "INT" } else { ty })?.value);
                }
            }
            Pins::Numbered => {
                for pin in numbered(1).take_while(|pin| part.pin(pin).is_some()) {
                    values.push(self.pin(part, &pin, ty)?.value);
                }
                if values.len() < 2 {
                    return Err("it has fewer than two values".to_owned());
                }
            }
            Pins::Selected(selector) => {
                let of = if selector == "g" { "BOOL" } else { "INT" };
                values.push(self.pin(part, selector, of)?.value);
                for pin in numbered(0).take_while(|pin| part.pin(pin).is_some()) {
                    values.push(self.pin(part, &pin, ty)?.value);
                }
                if part.pin("else").is_some() {
                    return Err("what it takes when the selector is outside has no counterpart".to_owned());
                }
            }
        }
        if op == Op::Trunc {
            let to = part.template("DestType").and_then(elementary).unwrap_or("INT");
            values.insert(0, self.out(part, "out", to)?.value);
            return one(op, values);
        }
        self.result(part, ty, op, &values)
    }

    fn calculated(&mut self, part: &Part) -> Result<Translated> {
        let ty = works_in(part);
        let written = part.formula.as_deref().ok_or("its formula is missing")?;
        let mut formula = String::new();
        let mut rest = written;
        while let Some(c) = rest.chars().next() {
            let length = rest
                .find(|c: char| !c.is_alphanumeric() && c != '_')
                .unwrap_or(rest.len());
            let (word, after) = rest.split_at(length.max(c.len_utf8()));
            rest = after;
            let upper = word.to_ascii_uppercase();
            match upper.strip_prefix("IN") {
                Some(number) if !number.is_empty() && number.bytes().all(|c| c.is_ascii_digit()) => {
                    formula.push_str(&self.pin(part, word, ty)?.value.to_string());
                }
                _ if upper == "SQR" => return Err("the square in its formula has no counterpart".to_owned()),
                _ if upper == "EXP" => formula.push_str("EXPE"),
                _ if upper == "*" && formula.ends_with('*') => {
                    formula.pop();
                    formula.push('^');
                }
                _ => formula.push_str(&upper),
            }
        }
        self.result(part, ty, Op::Calc, &[Expression::read(&formula)?])
    }

    fn bistable(&mut self, part: &Part, reset_wins: bool) -> Result<Translated> {
        let bit = match (&part.instance, part.pin("operand")) {
            (Some(instance), _) => operand(self.scope, instance, "BOOL")?.value,
            (None, Some(_)) => self.pin(part, "operand", "BOOL")?.value,
            (None, None) => return Err("its operand is missing".to_owned()),
        };
        let other = ["r1", "s1"].iter().find_map(|pin| part.pin(pin));
        let other = other.or_else(|| part.arguments.iter().find(|argument| argument.pin.is_none()));
        let other = match at_pin(self.scope, other, "BOOL") {
            Some(other) => other?.value,
            None => Literal::from(false).into(),
        };
        let helper = self.scope.helper("power", "BOOL", "the power before a flip-flop");
        let power = Expression::from(Path::tag(&helper));
        let formula = if reset_wins {
            let set = bit.clone().with(Operator::Or, power);
            set.with(Operator::And, other.negated())
        } else {
            let kept = bit.clone().with(Operator::And, power.negated());
            kept.with(Operator::Or, other)
        };
        let mut done = series([Block::of(Op::Calc, [bit.clone(), formula])?, Block::contact(bit)]);
        done.cut = Some(helper);
        Ok(done)
    }

    /// An edge detector runs only with power, and its output is read elsewhere, too: it is computed.
    fn trigger(&mut self, part: &Part, edge: Edge) -> Result<Translated> {
        let instance = part.instance.as_ref().ok_or("it has no instance")?;
        let output = operand(self.scope, instance, "BOOL")?.path()?;
        let clock = self.bit(part, "clk")?.value;
        let about = "what an edge detector remembers";
        let memory = Expression::from(self.helper(&format!("{}_M", output.root), "BOOL", about));
        let formula = match edge {
            Edge::Rising => clock.clone().with(Operator::And, memory.clone().negated()),
            Edge::Falling => memory.clone().with(Operator::And, clock.clone().negated()),
        };
        let output = Expression::from(output);
        let mut done = series([
            Block::of(Op::Calc, [output.clone(), formula])?,
            Block::of(Op::Mov, [memory, clock])?,
        ]);
        if let Some(taken) = at_pin(self.scope, part.pin("q"), "BOOL").transpose()? {
            done.blocks.push(Block::of(Op::Mov, [taken.value, output])?);
        }
        Ok(done)
    }

    fn state(&mut self, part: &Part, op: Op, pins: &[(&str, &str)]) -> Result<Translated> {
        let Some(instance) = &part.instance else {
            return Err("it has no instance".to_owned());
        };
        let state = operand(self.scope, instance, by_op(op).mnemonic)?.path()?;
        let mut operands = vec![Given::from(&state)];
        for (pin, named) in pins {
            let wanted = match *pin {
                "pt" => "TIME",
                "pv" => "DINT",
                _ => "BOOL",
            };
            match part.pin(pin) {
                Some(_) => {
                    let value = self.pin(part, pin, wanted)?.value;
                    operands.push(match *named {
                        "" => Given::Value(value),
                        named => Given::Given(named.to_owned(), value),
                    });
                }
                None if named.is_empty() => return Err(format!("nothing is at its pin `{pin}`")),
                None => {}
            }
        }
        let mut done = one(op, operands)?;
        for argument in part.arguments.iter().filter(|argument| argument.is_output) {
            let Some(pin) = &argument.pin else { continue };
            let pin = pin.to_ascii_uppercase();
            let wanted = match pin.as_str() {
                "ET" => "TIME",
                "CV" => "DINT",
                _ => "BOOL",
            };
            let Some(out) = at_pin(self.scope, Some(argument), wanted).transpose()? else {
                continue;
            };
            let to = out.plain();
            let operands = [out.value, state.clone().member(&pin).into()];
            done.after.push(match (pin.as_str(), to) {
                ("ET", _) | ("CV", Some("DINT" | "LINT")) => vec![Block::of(Op::Mov, operands)?],
                ("CV", _) => vec![Block::of(Op::Typ, operands)?],
                _ => {
                    let [to, from] = operands;
                    vec![Block::of(Op::Contact, [from])?, Block::coil(to)]
                }
            });
            done.note = Some("the values of its other pins are written after the network".to_owned());
        }
        Ok(done)
    }
}

/// The type that an instruction works in.
fn works_in(part: &Part) -> &'static str {
    let named = ["SrcType", "value_type"]
        .iter()
        .find_map(|name| part.template(name));
    named.and_then(elementary).unwrap_or("INT")
}

/// The smallest type of numbers that holds a literal, from INT on.
fn least_type(argument: &Argument) -> Option<&'static str> {
    let Value::Operand(text) = &argument.value else {
        return None;
    };
    let known = literal(text)?.ok()?;
    if known.ty.is_some() {
        return known.plain();
    }
    let number: i128 = known.value.to_string().replace('_', "").parse().ok()?;
    let holds = |bits: u32| (-(1_i128 << (bits - 1))..1_i128 << (bits - 1)).contains(&number);
    Some(match number {
        _ if holds(16) => "INT",
        _ if holds(32) => "DINT",
        _ => "LINT",
    })
}

/// The tag that a contact on a literal reads.
fn always(literal: &Literal) -> Path {
    let is_on = matches!(literal.as_str(), "TRUE" | "1");
    Path::system(if is_on { "ON" } else { "OFF" })
}

/// Several bits of an array, from one on.
fn bits(first: &Expression, count: &Expression) -> Option<Path> {
    let mut array = first.path()?.clone();
    let Step::Index(indices) = array.steps.pop()? else {
        return None;
    };
    let [index] = &indices[..] else { return None };
    let (index, count) = (number(index)?, number(count)?);
    let last = index.checked_add(count.checked_sub(1)?);
    Some(array.range(index, last.filter(|last| *last >= index)?))
}

/// The number that a decimal literal is, with its type or without.
fn number(value: &Expression) -> Option<i64> {
    let Expression::Literal(literal) = value else {
        return None;
    };
    match literal.as_str().split_once('#') {
        None => literal.as_str().parse().ok(),
        Some((ty, digits)) => elementary(ty).and_then(|_| digits.parse().ok()),
    }
}

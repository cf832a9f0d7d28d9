//! Instructions as elements of a rung.

use super::call::Labels;
use crate::model::{Part, Value};
use crate::operand::{Operand, operand};
use crate::scope::{Scope, passes};
use crate::standard::{Form, Pins, Row, elementary};

/// What an instruction became.
#[derive(Debug, Default)]
pub(super) struct Translated {
    /// One after the other.
    pub(super) texts: Vec<String>,
    /// The tag that the power before it goes into: it begins at the rail.
    pub(super) cut: Option<String>,
    /// Networks after this one.
    pub(super) after: Vec<Vec<String>>,
    /// Why it is not quite the same.
    pub(super) note: Option<String>,
}

/// What translates the instructions of a block.
pub(super) struct Translator<'s, 'l> {
    pub(super) scope: &'s mut Scope<'l>,
    pub(super) labels: Labels,
}

type Result<T> = std::result::Result<T, String>;

fn one(text: String) -> Translated {
    series([text])
}

fn series<const N: usize>(texts: [String; N]) -> Translated {
    Translated {
        texts: texts.into(),
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
            Form::Contact(sign) => match self.bit(part, "operand")? {
                it if it.is_literal => Ok(one(format!("{sign}( {} )", always(&it.text)))),
                it => Ok(one(format!("{sign}( {} )", it.text))),
            },
            Form::EdgeContact(sign) | Form::Coil(sign) => {
                Ok(one(format!("{sign}( {} )", self.bit(part, "operand")?.text)))
            }
            Form::EdgeCoil(sign) => Ok(one(format!("{sign}( {} )", self.bit(part, "operand")?.text))),
            Form::Edge(sign) => Ok(one(sign.to_owned())),
            Form::Not => Ok(one("[NOT]".to_owned())),
            Form::Compare(name) => {
                let (a, b) = (self.value(part, "in1")?, self.value(part, "in2")?);
                Ok(one(format!("[{name}]( {}, {} )", a.text, b.text)))
            }
            Form::CompareBox(sign) => {
                let (a, b) = (self.value(part, "in1")?, self.value(part, "in2")?);
                let out = self.out(part, "out", "BOOL")?;
                Ok(one(format!(
                    "[CALC]( {}, {} {sign} {} )",
                    out.text, a.text, b.text
                )))
            }
            Form::InRange => {
                let [min, value, max] = self.values(part, ["min", "in", "max"])?;
                Ok(one(format!("[LE]( {min}, {value}, {max} )")))
            }
            Form::OutRange => {
                let [min, value, max] = self.values(part, ["min", "in", "max"])?;
                let helper = self
                    .scope
                    .helper("outside", "BOOL", "whether a value is outside of its range");
                Ok(series([
                    format!("[CALC]( {helper}, {value} < {min} OR {value} > {max} )"),
                    format!("[ ]( {helper} )"),
                ]))
            }
            Form::Valid | Form::Invalid => {
                let value = self.only(part, "operand", "REAL")?;
                let name = if row.form == Form::Valid { "EQ" } else { "NE" };
                Ok(one(format!("[{name}]( {0}, {0} )", value.text)))
            }
            Form::Bits(sign) => {
                let first = self.bit(part, "operand")?;
                let count = self.value(part, "n")?;
                bits(sign, &first.text, &count.text)
            }
            Form::Bistable { reset_wins } => self.bistable(part, reset_wins),
            Form::State(name, pins) => self.state(part, name, pins),
            Form::TimerCoil(name) => {
                let timer = self.only(part, "timer", name)?;
                let time = self.pin(part, "pt", "TIME")?;
                Ok(one(format!("[{name}]( {}, {} )", timer.text, time.text)))
            }
            Form::ResetTimer => Ok(one(format!("(RES)( {} )", self.only(part, "timer", "TON")?.text))),
            Form::Move => self.moves(part),
            Form::Value(name, pins) => self.computed(part, name, pins),
            Form::Square => {
                let ty = works_in(part);
                let value = self.pin(part, "in", ty)?;
                self.result(part, ty, |out| format!("[MUL]( {out}, {0}, {0} )", value.text))
            }
            Form::Step(name) => {
                let ty = works_in(part);
                let it = self.only(part, "operand", ty)?;
                Ok(one(format!("[{name}]( {0}, {0}, 1 )", it.text)))
            }
            Form::Convert => {
                let from = part.template("SrcType").and_then(elementary).unwrap_or("INT");
                let to = part.template("DestType").and_then(elementary).unwrap_or("INT");
                let value = self.pin(part, "in", from)?;
                let out = self.out(part, "out", to)?;
                Ok(one(format!("[TYP]( {}, {} )", out.text, value.text)))
            }
            Form::Calculate => self.calculated(part),
            Form::Jump { negated } => {
                let label = part.only("label").map(|argument| &argument.value);
                let Some(Value::Operand(label)) = label else {
                    return Err("it names no label".to_owned());
                };
                let jump = format!("<JMP>( {} )", self.label(label));
                if negated {
                    return Ok(series(["[NOT]".to_owned(), jump]));
                }
                Ok(one(jump))
            }
            Form::Return { .. } => {
                let mut done = one("<RET>".to_owned());
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

    /// The operand at a pin.
    pub(super) fn pin(&mut self, part: &Part, pin: &str, wanted: &str) -> Result<Operand> {
        match part.pin(pin).map(|argument| &argument.value) {
            Some(Value::Operand(text)) => operand(self.scope, text, wanted),
            _ => Err(format!("nothing is at its pin `{pin}`")),
        }
    }

    fn only(&mut self, part: &Part, pin: &str, wanted: &str) -> Result<Operand> {
        match part.only(pin).map(|argument| &argument.value) {
            Some(Value::Operand(text)) => operand(self.scope, text, wanted),
            _ => Err("its operand is missing".to_owned()),
        }
    }

    fn bit(&mut self, part: &Part, pin: &str) -> Result<Operand> {
        self.only(part, pin, "BOOL")
    }

    fn value(&mut self, part: &Part, pin: &str) -> Result<Operand> {
        let ty = works_in(part);
        self.pin(part, pin, ty)
    }

    fn values<const N: usize>(&mut self, part: &Part, pins: [&str; N]) -> Result<[String; N]> {
        let mut texts = pins.map(str::to_owned);
        for text in &mut texts {
            *text = self.value(part, &text.clone())?.text;
        }
        Ok(texts)
    }

    /// What is written at a pin; a tag of its own where nothing is.
    fn out(&mut self, part: &Part, pin: &str, ty: &str) -> Result<Operand> {
        if part.pin(pin).is_some() {
            return self.pin(part, pin, ty);
        }
        let text = self.scope.helper("result", ty, "a result that nothing takes");
        Ok(Operand {
            text,
            ty: Some(crate::model::Type::Named(ty.to_owned())),
            is_literal: false,
        })
    }

    /// A result that is computed in a type, and brought to the type of what takes it.
    fn result(&mut self, part: &Part, ty: &str, text: impl FnOnce(&str) -> String) -> Result<Translated> {
        let out = self.out(part, "out", ty)?;
        match out.plain() {
            Some(to) if !passes(ty, to) => {
                let helper = self.scope.helper("result", ty, "a result before it is converted");
                Ok(series([
                    text(&helper),
                    format!("[TYP]( {}, {helper} )", out.text),
                ]))
            }
            _ => Ok(one(text(&out.text))),
        }
    }

    fn moves(&mut self, part: &Part) -> Result<Translated> {
        let outs: Vec<String> = part
            .arguments
            .iter()
            .filter(|argument| argument.is_output)
            .filter_map(|argument| match &argument.value {
                Value::Operand(text) => Some(text.clone()),
                _ => None,
            })
            .collect();
        let mut done = Translated::default();
        for out in outs {
            // Of two that nobody declares the one that is moved has the type of the other.
            let known = operand(self.scope, &out, "INT")?;
            let value = self.pin(part, "in", known.plain().unwrap_or("INT"))?;
            let block = match (value.plain(), known.plain()) {
                (Some(from), Some(to)) if !value.is_literal && !passes(from, to) => "TYP",
                _ => "MOV",
            };
            done.texts
                .push(format!("[{block}]( {}, {} )", known.text, value.text));
        }
        if done.texts.is_empty() {
            return Err("nothing takes its value".to_owned());
        }
        Ok(done)
    }

    fn computed(&mut self, part: &Part, name: &str, pins: Pins) -> Result<Translated> {
        let ty = works_in(part);
        let mut texts = Vec::new();
        let numbered = |first: usize| (first..).map(|number| format!("in{number}"));
        match pins {
            Pins::Named(pins) => {
                for pin in pins {
                    texts.push(self.pin(part, pin, if *pin == "n" { "INT" } else { ty })?.text);
                }
            }
            Pins::Numbered => {
                for pin in numbered(1).take_while(|pin| part.pin(pin).is_some()) {
                    texts.push(self.pin(part, &pin, ty)?.text);
                }
                if texts.len() < 2 {
                    return Err("it has fewer than two values".to_owned());
                }
            }
            Pins::Selected(selector) => {
                let of = if selector == "g" { "BOOL" } else { "INT" };
                texts.push(self.pin(part, selector, of)?.text);
                for pin in numbered(0).take_while(|pin| part.pin(pin).is_some()) {
                    texts.push(self.pin(part, &pin, ty)?.text);
                }
                if part.pin("else").is_some() {
                    return Err("what it takes when the selector is outside has no counterpart".to_owned());
                }
            }
        }
        if name == "TRUNC" {
            let to = part.template("DestType").and_then(elementary).unwrap_or("INT");
            let out = self.out(part, "out", to)?;
            return Ok(one(format!("[TRUNC]( {}, {} )", out.text, texts.join(", "))));
        }
        self.result(part, ty, |out| format!("[{name}]( {out}, {} )", texts.join(", ")))
    }

    fn calculated(&mut self, part: &Part) -> Result<Translated> {
        let ty = works_in(part);
        let written = part.template("expression").ok_or("its formula is missing")?;
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
                    formula.push_str(&self.pin(part, word, ty)?.text);
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
        self.result(part, ty, |out| format!("[CALC]( {out}, {formula} )"))
    }

    fn bistable(&mut self, part: &Part, reset_wins: bool) -> Result<Translated> {
        let bit = match (&part.instance, part.pin("operand")) {
            (Some(instance), _) => operand(self.scope, instance, "BOOL")?.text,
            (None, Some(_)) => self.pin(part, "operand", "BOOL")?.text,
            (None, None) => return Err("its operand is missing".to_owned()),
        };
        let other = ["r1", "s1"].iter().find_map(|pin| part.pin(pin));
        let other = other.or_else(|| part.arguments.iter().find(|argument| argument.pin.is_none()));
        let other = match other.map(|argument| &argument.value) {
            Some(Value::Operand(text)) => operand(self.scope, text, "BOOL")?.text,
            _ => "FALSE".to_owned(),
        };
        let helper = self.scope.helper("power", "BOOL", "the power before a flip-flop");
        let formula = if reset_wins {
            format!("({bit} OR {helper}) AND NOT {other}")
        } else {
            format!("{bit} AND NOT {helper} OR {other}")
        };
        let mut done = series([format!("[CALC]( {bit}, {formula} )"), format!("[ ]( {bit} )")]);
        done.cut = Some(helper);
        Ok(done)
    }

    fn state(&mut self, part: &Part, name: &str, pins: &[(&str, &str)]) -> Result<Translated> {
        let Some(instance) = &part.instance else {
            return Err("it has no instance".to_owned());
        };
        let state = operand(self.scope, instance, name)?.text;
        let mut texts = vec![state.clone()];
        for (pin, named) in pins {
            let wanted = match *pin {
                "pt" => "TIME",
                "pv" => "DINT",
                _ => "BOOL",
            };
            match part.pin(pin) {
                Some(_) => {
                    let value = self.pin(part, pin, wanted)?.text;
                    texts.push(match *named {
                        "" => value,
                        named => format!("{named} := {value}"),
                    });
                }
                None if named.is_empty() => return Err(format!("nothing is at its pin `{pin}`")),
                None => {}
            }
        }
        let mut done = one(format!("[{name}]( {} )", texts.join(", ")));
        for argument in part.arguments.iter().filter(|argument| argument.is_output) {
            let (Some(pin), Value::Operand(text)) = (&argument.pin, &argument.value) else {
                continue;
            };
            let pin = pin.to_ascii_uppercase();
            let wanted = match pin.as_str() {
                "ET" => "TIME",
                "CV" => "DINT",
                _ => "BOOL",
            };
            let out = operand(self.scope, text, wanted)?;
            done.after.push(match (pin.as_str(), out.plain()) {
                ("ET", _) => vec![format!("[MOV]( {}, {state}.ET )", out.text)],
                ("CV", Some("DINT" | "LINT")) => vec![format!("[MOV]( {}, {state}.CV )", out.text)],
                ("CV", _) => vec![format!("[TYP]( {}, {state}.CV )", out.text)],
                _ => vec![format!("[ ]( {state}.{pin} )"), format!("( )( {} )", out.text)],
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

fn always(literal: &str) -> &'static str {
    if literal == "TRUE" || literal == "1" {
        "SYS.ON"
    } else {
        "SYS.OFF"
    }
}

/// A coil on several bits of an array, from one on.
fn bits(sign: &str, first: &str, count: &str) -> Result<Translated> {
    let range = first
        .strip_suffix(']')
        .and_then(|path| path.rsplit_once('['))
        .and_then(|(array, index)| {
            let index: i64 = index.parse().ok()?;
            let count: i64 = count.rsplit('#').next()?.parse().ok()?;
            let last = index.checked_add(count - 1).filter(|last| *last >= index)?;
            Some(format!("{array}[{index}..{last}]"))
        });
    let range: String =
        range.ok_or("only bits of an array, from a constant index on, can be set together here")?;
    Ok(one(format!("{sign}( {range} )")))
}

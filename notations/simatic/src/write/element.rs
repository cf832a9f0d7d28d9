//! Blocks on a rung as instructions of source documents.

use super::Writer;
use super::declare::{self, elementary};
use super::operand::{Tags, operand};
use super::power::{POWER_IN, POWER_OUT, Power};
use crate::standard::{Form, Pins, ROWS, Row};
use ladder_analysis::program::{Argument, Block, BlockKind, Bound, ExprKind, ParameterKind};
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use ladder_instructions::{Instruction, Op};

/// An instruction as it is written, with its pragma on a line before.
pub(super) type Text = String;

impl Writer<'_> {
    /// A block.
    ///
    /// # Errors
    ///
    /// Why it has no form there.
    pub(super) fn element(&mut self, block: &Block, tags: &Tags) -> Result<Text, String> {
        let row = match block.kind {
            BlockKind::Instruction(row) => row,
            BlockKind::User(_) => return self.call(block, ("TRUE", None), tags),
        };
        let arguments = &block.arguments;
        let first = |writer: &Self| {
            let first = arguments.first().ok_or("its operand is missing")?;
            operand(writer.source(first), tags)
        };
        let one = |name: &str, text: String| Ok(format!("{name}( {text} )"));
        Ok(match row.op {
            Op::Contact => return one("Contact", first(self)?),
            Op::NegatedContact => return one("I_Contact", first(self)?),
            Op::RisingContact | Op::FallingContact => {
                let name = if row.op == Op::RisingContact {
                    "P_Contact"
                } else {
                    "N_Contact"
                };
                let operand = first(self)?;
                format!("{name}( operand := {operand}, bit := {} )", self.memory())
            }
            Op::OneShotRising => format!("P_Trig( {} )", self.memory()),
            Op::OneShotFalling => format!("N_Trig( {} )", self.memory()),
            Op::Inverter => "Not( )".to_owned(),
            Op::Coil => return one("Coil", first(self)?),
            Op::NegatedCoil => return one("I_Coil", first(self)?),
            Op::SetCoil | Op::ResetCoil => {
                let name = if row.op == Op::SetCoil { "S" } else { "R" };
                match arguments.first().map(|bound| &bound.argument) {
                    Some(Argument::Range(_)) => return self.bits(name, &arguments[0], tags),
                    Some(Argument::State(_) | Argument::ChosenState(_)) => return self.reset(block, tags),
                    _ => return one(&format!("{name}_Coil"), first(self)?),
                }
            }
            Op::RisingCoil | Op::FallingCoil => {
                let name = if row.op == Op::RisingCoil {
                    "P_Coil"
                } else {
                    "N_Coil"
                };
                let operand = first(self)?;
                format!("{name}( operand => {operand}, bit := {} )", self.memory())
            }
            Op::Res => return self.reset(block, tags),
            Op::Jmp => format!("JumpCoil( \"{}\" )", self.source(&arguments[0]).trim()),
            Op::Ret => "Return( )".to_owned(),
            Op::Typ => {
                let from = scalar_of(&arguments[1]).and_then(type_name);
                let to = scalar_of(&arguments[0]).and_then(type_name);
                let (from, to) = (
                    from.ok_or("its value has no type there")?,
                    to.ok_or("its result has no type there")?,
                );
                let (out, value) = (self.given(&arguments[0], tags)?, self.given(&arguments[1], tags)?);
                format!(
                    "{{ S7_Templates := \"[SrcType := {from}, DestType := {to}]\" }}\nConvert( in := {value}, out => {out} )"
                )
            }
            Op::Mov => {
                let (out, value) = (self.given(&arguments[0], tags)?, self.given(&arguments[1], tags)?);
                format!("Move( in := {value}, out1 => {out} )")
            }
            Op::Calc => return self.formula(block, tags),
            _ => return self.of_table(block, row, tags),
        })
    }

    /// The instructions that differ in their names and pins alone.
    fn of_table(&mut self, block: &Block, own: &Instruction, tags: &Tags) -> Result<Text, String> {
        let mnemonic = own.mnemonic;
        let none = || format!("`[{mnemonic}]` has no counterpart");
        let arguments = &block.arguments;
        let is = |row: &&Row| match row.form {
            Form::Compare(op) | Form::Value(op, _) | Form::State(op, _) => op == own.op,
            _ => false,
        };
        let row = ROWS.iter().find(is).ok_or_else(none)?;
        let name = row.sd[0];
        if block.works_in == Some(Scalar::Bool) && matches!(own.op, Op::And | Op::Or | Op::Xor | Op::Not) {
            return Err(format!(
                "`{name}` is for words there, and not for one bit: draw it with contacts"
            ));
        }
        let given: Result<Vec<String>, String> =
            arguments.iter().map(|bound| self.given(bound, tags)).collect();
        let given = given?;
        let works_in = block.works_in.and_then(type_name);
        let template = |ty: &str| match row.template {
            Some(template) => format!("{{ S7_Templates := \"{template} := {ty}\" }}\n"),
            None => String::new(),
        };
        let works_in = || works_in.ok_or_else(|| "the type that it works in has no form there".to_owned());
        match row.form {
            Form::Compare(Op::Le) if given.len() == 3 => {
                let head = template(works_in()?);
                Ok(format!(
                    "{head}InRange( min := {}, in := {}, max := {} )",
                    given[0], given[1], given[2]
                ))
            }
            Form::Compare(_) if given.len() == 2 => {
                let head = template(works_in()?);
                Ok(format!(
                    "{head}{name}( in1 := {}, in2 := {} )",
                    given[0], given[1]
                ))
            }
            Form::State(_, pins) => {
                let ty = if name.starts_with("CT") { "DInt" } else { "Time" };
                let head = template(ty);
                let state = &given[0];
                let mut parts = Vec::new();
                for (pin, named) in pins {
                    let mut rest = arguments.iter().zip(&given).skip(1);
                    let found = rest.find(|(bound, _)| self.named(bound).eq_ignore_ascii_case(named));
                    parts.extend(found.map(|(_, text)| format!("{pin} := {text}")));
                }
                if parts.len() + 1 < given.len() {
                    return Err(format!("an operand of `[{mnemonic}]` has no pin there"));
                }
                parts.push(if name.starts_with("CT") { "cv =>" } else { "et =>" }.to_owned());
                Ok(format!("{head}{state}.{name}( {} )", parts.join(", ")))
            }
            Form::Value(_, pins) => {
                let values = &given[1..];
                let pins: Vec<String> = match pins {
                    Pins::Named(pins) => pins.iter().map(|pin| (*pin).to_owned()).collect(),
                    Pins::Numbered => (1..=values.len()).map(|number| format!("in{number}")).collect(),
                    Pins::Selected(selector) => {
                        let numbered =
                            (0..values.len().saturating_sub(1)).map(|number| format!("in{number}"));
                        std::iter::once(selector.to_owned()).chain(numbered).collect()
                    }
                };
                if pins.len() != values.len() {
                    return Err(format!("`{name}` has {} values there", pins.len()));
                }
                let head = if name == "Trunc" {
                    let from = scalar_of(&arguments[1]).and_then(type_name).unwrap_or("Real");
                    let to = scalar_of(&arguments[0]).and_then(type_name).unwrap_or("Int");
                    format!("{{ S7_Templates := \"[SrcType := {from}, DestType := {to}]\" }}\n")
                } else {
                    template(works_in()?)
                };
                let parts: Vec<String> = pins
                    .iter()
                    .zip(values)
                    .map(|(pin, text)| format!("{pin} := {text}"))
                    .collect();
                Ok(format!(
                    "{head}{name}( {}, out => {} )",
                    parts.join(", "),
                    given[0]
                ))
            }
            _ => Err(none()),
        }
    }

    /// `[CALC]`: each tag and number of the formula is a pin.
    fn formula(&mut self, block: &Block, tags: &Tags) -> Result<Text, String> {
        let arguments = &block.arguments;
        let ty = block.works_in.and_then(type_name).filter(|ty| *ty != "Bool");
        let ty = ty.ok_or("Calculate makes numbers and bit strings only")?;
        let out = self.given(&arguments[0], tags)?;
        let text = self.source(&arguments[1]).to_owned();
        let mut pins: Vec<String> = Vec::new();
        let mut formula = String::new();
        let mut rest = text.as_str();
        while let Some(c) = rest.chars().next() {
            if !(c.is_alphanumeric() || "_'%".contains(c)) {
                match c {
                    '=' | '<' | '>' => return Err("Calculate compares nothing".to_owned()),
                    '^' => formula.push_str("**"),
                    c => formula.push(c),
                }
                rest = &rest[c.len_utf8()..];
                continue;
            }
            let end = word_end(rest);
            let (word, after) = rest.split_at(end);
            rest = after;
            let upper = word.to_ascii_uppercase();
            match upper.as_str() {
                "AND" | "OR" | "XOR" | "MOD" | "NOT" => formula.push_str(&upper),
                "ABS" | "SQRT" | "LN" | "SIN" | "COS" | "TAN" | "ASIN" | "ACOS" | "ATAN"
                    if rest.starts_with('(') =>
                {
                    formula.push_str(&upper);
                }
                "EXPE" if rest.starts_with('(') => formula.push_str("EXP"),
                _ if rest.starts_with('(') || matches!(upper.as_str(), "SHL" | "SHR") => {
                    return Err(format!("Calculate has no `{upper}`"));
                }
                _ => {
                    let pin = match upper.as_str() {
                        "PI" => std::f64::consts::PI.to_string(),
                        _ => operand(word, tags)?,
                    };
                    let number = pins.iter().position(|own| *own == pin).unwrap_or_else(|| {
                        pins.push(pin);
                        pins.len() - 1
                    });
                    formula.push_str(&format!("IN{}", number + 1));
                }
            }
        }
        let parts: Vec<String> = pins
            .iter()
            .enumerate()
            .map(|(number, pin)| format!("in{} := {pin}", number + 1))
            .collect();
        Ok(format!(
            "{{ S7_Templates := \"SrcType := {ty}\"; S7_Expression := \"{formula}\" }}\nCalculate( {}, out => {out} )",
            parts.join(", ")
        ))
    }

    fn bits(&mut self, name: &str, bound: &Bound, tags: &Tags) -> Result<Text, String> {
        let text = self.source(bound).trim();
        let range = text.strip_suffix(']').and_then(|path| path.rsplit_once('['));
        let range = range.and_then(|(array, range)| Some((array, range.split_once("..")?)));
        let (array, (first, last)) = range.ok_or("a bit field begins at an element")?;
        let number = |bound: &str| {
            bound
                .trim()
                .parse::<i64>()
                .map_err(|_| "a bit field has a constant length".to_owned())
        };
        let (first, last) = (number(first)?, number(last)?);
        let start = operand(&format!("{array}[{first}]"), tags)?;
        Ok(format!(
            "{name}_BitfieldCoil( operand := {start}, n := {} )",
            last.saturating_sub(first) + 1
        ))
    }

    fn reset(&mut self, block: &Block, tags: &Tags) -> Result<Text, String> {
        let bound = block.arguments.first().ok_or("its operand is missing")?;
        let text = self.source(bound).trim().to_owned();
        let root = text.split(['.', '[']).next().unwrap_or_default().to_lowercase();
        match tags.get(&root) {
            Some(Ok(ty)) if matches!(ty.as_str(), "TON" | "TOF" | "TP" | "RTO") => {
                Ok(format!("RT_Coil( {} )", operand(&text, tags)?))
            }
            _ => Err("only timers are reset by a coil there: a counter has its R".to_owned()),
        }
    }

    /// A block of one's own: `#"pump"( start := #"a", running => #"b" )`. `power`: what it is given, and what keeps what it
    /// returns.
    pub(super) fn call(
        &mut self,
        block: &Block,
        power: (&str, Option<&str>),
        tags: &Tags,
    ) -> Result<Text, String> {
        let BlockKind::User(user) = block.kind else {
            return Err("it is no block of one's own".to_owned());
        };
        let program = self.program;
        let definition = &program.blocks[user];
        let name = &definition.name[1..];
        declare::type_text(&definition.name, &self.types, 0)?;
        let mut instance = None;
        let mut parts = Vec::new();
        if let Power::Given { reads: true, .. } = self.powers[user] {
            parts.push(format!("\"{POWER_IN}\" := {}", power.0));
        }
        for bound in &block.arguments {
            let Some(parameter) = bound.parameter else {
                instance = Some(operand(self.source(bound), tags)?);
                continue;
            };
            let text = self.given(bound, tags)?;
            let own = self.parameters.get(&name.to_lowercase());
            let own = own
                .and_then(|own| own.get(parameter))
                .ok_or("its parameters are not known")?;
            let sign = match definition.parameters.get(parameter) {
                Some((_, ParameterKind::Output)) => "=>",
                _ => ":=",
            };
            parts.push(format!("\"{own}\" {sign} {text}"));
        }
        parts.extend(power.1.map(|kept| format!("\"{POWER_OUT}\" => {kept}")));
        let instance = instance.unwrap_or_else(|| self.static_tag(name, &format!("\"{name}\"")));
        Ok(format!("{instance}( {} )", parts.join(", ")))
    }

    /// What is given for an operand.
    fn given(&self, bound: &Bound, tags: &Tags) -> Result<String, String> {
        if let Argument::Value(value) = &bound.argument
            && let (Scalar::Enum(_), ExprKind::Constant(Value::Int(number))) = (value.ty, &value.kind)
        {
            return Ok(number.to_string());
        }
        operand(self.source(bound), tags)
    }

    /// The name that an operand is given by, and its value, as they are written.
    fn parts(&self, bound: &Bound) -> (&str, &str) {
        let text = self.text[bound.range].trim();
        match text.split_once(":=").or_else(|| text.split_once("=>")) {
            Some((name, value)) if !text.starts_with('\'') => (name.trim(), value.trim()),
            _ => ("", text),
        }
    }

    fn named(&self, bound: &Bound) -> &str {
        self.parts(bound).0
    }

    pub(super) fn source(&self, bound: &Bound) -> &str {
        self.parts(bound).1
    }
}

/// Where a path, number or text ends, with its members and indices.
fn word_end(text: &str) -> usize {
    if let Some(inner) = text.strip_prefix('\'') {
        return inner.find('\'').map_or(text.len(), |end| end + 2);
    }
    let mut depth = 0usize;
    let mut before = ' ';
    for (at, c) in text.char_indices() {
        let is_word = c.is_alphanumeric() || "_.#%".contains(c);
        let is_exponent = (c == '-' || c == '+')
            && before.eq_ignore_ascii_case(&'e')
            && text.starts_with(|c: char| c.is_ascii_digit());
        match c {
            '[' => depth += 1,
            ']' => depth = depth.saturating_sub(1),
            _ if depth > 0 || is_word || is_exponent => {}
            _ => return at,
        }
        before = c;
    }
    text.len()
}

/// The type of what is given.
fn scalar_of(bound: &Bound) -> Option<Scalar> {
    match &bound.argument {
        Argument::Value(value) => Some(value.ty),
        Argument::Place(_, ty) => Some(*ty),
        _ => None,
    }
}

/// A type's name there.
fn type_name(ty: Scalar) -> Option<&'static str> {
    match ty {
        Scalar::String(_) => Some("String"),
        Scalar::Enum(_) => Some("DInt"),
        other => elementary(&other.to_string().to_ascii_uppercase()),
    }
}

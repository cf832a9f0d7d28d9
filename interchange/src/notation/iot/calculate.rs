//! Contacts, coils, comparisons and calculations as blocks, with the steps between that C's conversions make.

use super::super::Names;
use super::kinds::{Kind, Kinds};
use super::model::{Family, Member, Operand, Variable};
use ladder_instructions::{Op, by_op};
use std::collections::{BTreeMap, HashMap};

/// What is known of the variables while a program is translated.
pub(super) struct Values {
    pub(super) kinds: Kinds,
    pub(super) names: Names,
    /// The presets of timers and counters.
    pub(super) presets: HashMap<Variable, Preset>,
    /// The tags for steps between, with what they hold.
    pub(super) helpers: BTreeMap<String, (String, Kind)>,
}

/// Where a preset comes from.
#[derive(Debug, Clone)]
pub(super) struct Preset {
    /// What it is at first.
    pub(super) value: i32,
    /// The time base of a timer, in milliseconds.
    pub(super) base: i32,
    /// The tag that holds it, if the program writes it.
    pub(super) tag: Option<String>,
}

/// The blocks of an element, one behind the other; or why there are none.
pub(super) type Blocks = Result<Vec<String>, String>;

impl Values {
    /// A contact.
    pub(super) fn contact(&mut self, op: Op, operand: &Operand) -> Blocks {
        if let Operand::Number(_) = operand {
            return Err("a contact looks at a variable".to_owned());
        }
        if self.kinds.operand(operand) == Kind::Bit {
            return Ok(vec![format!("{}( {} )", by_op(op).block(), self.text(operand))]);
        }
        let mut out = Vec::new();
        let compare = match op {
            Op::Contact => Op::Ne,
            Op::NegatedContact => Op::Eq,
            _ => return Err(format!("{operand} is a number, and only bits have edges here")),
        };
        let value = self.read(operand, Kind::Integer, &mut out)?;
        out.push(format!("{}( {value}, 0 )", by_op(compare).block()));
        Ok(out)
    }

    /// A coil, or RESET of a variable.
    pub(super) fn coil(&mut self, op: Op, operand: &Operand) -> Blocks {
        let to = self.written(operand)?;
        if self.kinds.operand(operand) == Kind::Bit {
            return Ok(vec![format!("{}( {to} )", by_op(op).block())]);
        }
        let value = match op {
            Op::SetCoil | Op::RetentiveSet => 1,
            Op::ResetCoil | Op::RetentiveReset => 0,
            _ => {
                return Err(format!(
                    "{operand} is a number in this program, and coils write bits here"
                ));
            }
        };
        Ok(vec![format!("[MOV]( {to}, {value} )")])
    }

    pub(super) fn compare(&mut self, op: Op, a: &Operand, b: &Operand) -> Blocks {
        let mut out = Vec::new();
        let head = by_op(op).block();
        if matches!((a, b), (Operand::Number(_), Operand::Number(_))) {
            return Err("it compares two numbers, neither of which changes".to_owned());
        }
        if matches!(op, Op::Eq | Op::Ne) && self.kinds.is_bit(a) && self.kinds.is_bit(b) {
            out.push(format!("{head}( {}, {} )", self.bit(a), self.bit(b)));
            return Ok(out);
        }
        let is_broken = |operand: &Operand| matches!(operand, Operand::Number(n) if n.whole().is_none());
        let is_float = |operand: &Operand| {
            is_broken(operand) || !is_literal(operand) && self.kinds.operand(operand) == Kind::Float
        };
        let kind = if is_float(a) || is_float(b) {
            Kind::Float
        } else {
            Kind::Integer
        };
        let compared = |values: &mut Values, operand: &Operand, other: &Operand, out: &mut Vec<String>| {
            // A broken number wants a real beside it.
            if is_broken(other) && values.kinds.operand(operand) != Kind::Float {
                let value = values.read(operand, Kind::Float, out)?;
                let helper = values.helper(operand, Kind::Float);
                if value != helper {
                    out.push(format!("[MOV]( {helper}, {value} )"));
                }
                return Ok(helper);
            }
            values.read(operand, kind, out)
        };
        let (left, right) = (compared(self, a, b, &mut out)?, compared(self, b, a, &mut out)?);
        out.push(format!("{head}( {left}, {right} )"));
        Ok(out)
    }

    /// ADD to XOR with two operands, NOT with one.
    pub(super) fn calculate(&mut self, op: Op, to: &Operand, from: &[Operand]) -> Blocks {
        let target = self.written(to)?;
        let head = by_op(op).block();
        let is_bitwise = matches!(op, Op::And | Op::Or | Op::Xor | Op::Not);
        let kind = self.kinds.operand(to);
        let all = |texts: Vec<String>| texts.join(", ");
        if kind == Kind::Bit {
            let from: Vec<String> = from.iter().map(|operand| self.bit(operand)).collect();
            return Ok(vec![format!("{head}( {target}, {} )", all(from))]);
        }
        let mut out = Vec::new();
        if kind == Kind::Byte && is_bitwise && from.iter().all(|operand| self.is_small(operand)) {
            let mut texts = Vec::new();
            for operand in from {
                texts.push(self.read(operand, Kind::Byte, &mut out)?);
            }
            out.push(format!("{head}( {target}, {} )", all(texts)));
            return Ok(out);
        }
        let is_float = |operand: &Operand| self.kinds.operand(operand) == Kind::Float;
        let works_in = if !is_bitwise && from.iter().any(is_float) {
            Kind::Float
        } else {
            Kind::Integer
        };
        let mut texts = Vec::new();
        for operand in from {
            texts.push(self.read(operand, works_in, &mut out)?);
        }
        let step = if kind == works_in {
            target.clone()
        } else {
            self.helper(to, works_in)
        };
        out.push(format!("{head}( {step}, {} )", all(texts)));
        if kind != works_in {
            self.convert(to, &target, kind, &step, works_in, &mut out);
        }
        Ok(out)
    }

    pub(super) fn assign(&mut self, to: &Operand, from: &Operand) -> Blocks {
        let target = self.written(to)?;
        let kind = self.kinds.operand(to);
        let mut out = Vec::new();
        if kind == Kind::Bit {
            return Ok(vec![format!("[MOV]( {target}, {} )", self.bit(from))]);
        }
        if let Operand::Number(number) = from {
            let text = match kind {
                Kind::Byte => (number.value as i64).rem_euclid(256).to_string(),
                Kind::Float => real(number.value),
                _ => (number.value as i32).to_string(),
            };
            return Ok(vec![format!("[MOV]( {target}, {text} )")]);
        }
        let text = self.text(from);
        self.convert(to, &target, kind, &text, self.kinds.operand(from), &mut out);
        Ok(out)
    }

    /// From a value of one kind to a tag of another, as C assigns.
    fn convert(
        &mut self,
        to: &Operand,
        target: &str,
        kind: Kind,
        value: &str,
        from: Kind,
        out: &mut Vec<String>,
    ) {
        match (kind, from) {
            (Kind::Byte, Kind::Bit) => out.push(format!("[TYP]( {target}, {value} )")),
            (Kind::Byte, Kind::Byte) => out.push(format!("[MOV]( {target}, {value} )")),
            (Kind::Byte, _) => {
                // The eight lower bits stay.
                let whole = self.helper(to, Kind::Integer);
                match from {
                    Kind::Count => out.push(format!("[TYP]( {whole}, {value} )")),
                    Kind::Float => out.push(format!("[TRUNC]( {whole}, {value} )")),
                    _ => {}
                }
                let value = if from == Kind::Integer { value } else { &whole };
                out.push(format!("[AND]( {whole}, {value}, 255 )"));
                out.push(format!("[TYP]( {target}, {whole} )"));
            }
            (_, Kind::Bit | Kind::Count) => out.push(format!("[TYP]( {target}, {value} )")),
            (Kind::Integer, Kind::Float) => out.push(format!("[TRUNC]( {target}, {value} )")),
            _ => out.push(format!("[MOV]( {target}, {value} )")),
        }
    }

    /// An operand as a value of a kind; steps that are needed first go to `out`.
    fn read(&mut self, operand: &Operand, kind: Kind, out: &mut Vec<String>) -> Result<String, String> {
        if let Operand::Number(number) = operand {
            return match (kind, number.whole()) {
                (Kind::Float, _) => Ok(real(number.value)),
                (_, Some(whole)) => Ok(whole.to_string()),
                (_, None) => Err(format!("C has no such operation with {operand}")),
            };
        }
        let text = self.text(operand);
        match self.kinds.operand(operand) {
            Kind::Float if kind != Kind::Float => Err(format!("C has no such operation with {operand}")),
            Kind::Bit | Kind::Count => {
                let helper = self.helper(operand, kind);
                out.push(format!("[TYP]( {helper}, {text} )"));
                Ok(helper)
            }
            _ => Ok(text),
        }
    }

    /// An operand that is a bit.
    fn bit(&self, operand: &Operand) -> String {
        match operand {
            Operand::Number(number) if number.value == 0.0 => "FALSE".to_owned(),
            Operand::Number(_) => "TRUE".to_owned(),
            other => self.text(other),
        }
    }

    /// Whether eight bits hold an operand.
    fn is_small(&self, operand: &Operand) -> bool {
        match operand {
            Operand::Number(number) => number.whole().is_some_and(|whole| (0..256).contains(&whole)),
            other => matches!(self.kinds.operand(other), Kind::Bit | Kind::Byte),
        }
    }

    /// What an element writes.
    fn written(&self, operand: &Operand) -> Result<String, String> {
        match operand {
            Operand::Variable(variable) if !variable.family.is_state() => Ok(variable.to_string()),
            Operand::Member(_, Member::Pre) => Ok(self.text(operand)),
            _ => Err(format!("only its own block and RESET write {operand} here")),
        }
    }

    /// An operand that is not a number.
    pub(super) fn text(&self, operand: &Operand) -> String {
        let Operand::Member(variable, member) = operand else {
            return operand.to_string();
        };
        let preset = self.presets.get(variable);
        match member {
            Member::Pre => match preset {
                Some(Preset { tag: Some(tag), .. }) => tag.clone(),
                preset => preset
                    .map_or_else(|| default_preset(variable), |p| p.value)
                    .to_string(),
            },
            Member::B => preset.map_or(DEFAULT_BASE, |preset| preset.base).to_string(),
            member => format!("{variable}.{}", member.word()),
        }
    }

    /// The tag for a step between that is like an operand, but of another kind.
    fn helper(&mut self, operand: &Operand, kind: Kind) -> String {
        let suffix = match kind {
            Kind::Byte => "byte",
            Kind::Float => "real",
            _ => "int",
        };
        let like = format!("{}_{suffix}", operand.to_string().replace(':', "_"));
        if let Some((name, _)) = self.helpers.get(&like) {
            return name.clone();
        }
        let name = self.names.fresh(&like);
        self.helpers.insert(like, (name.clone(), kind));
        name
    }
}

fn is_literal(operand: &Operand) -> bool {
    matches!(operand, Operand::Number(_))
}

/// What the editor sets where nothing is given.
pub(super) const DEFAULT_BASE: i32 = 100;

/// See [`DEFAULT_BASE`].
pub(super) fn default_preset(variable: &Variable) -> i32 {
    i32::from(variable.family == Family::Timer)
}

/// A real literal of ladder text.
pub(super) fn real(value: f64) -> String {
    let text = format!("{value:?}");
    match text.split_once('e') {
        Some((digits, exponent)) if !digits.contains('.') => format!("{digits}.0e{exponent}"),
        _ => text,
    }
}

//! Which variables are bits, and which are numbers.

use super::model::{Element, Family, File, Member, Operand, Variable};
use super::word::Form;
use ladder_instructions::Op;
use std::collections::{HashMap, HashSet};

/// What a variable holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum Kind {
    /// 0 or 1, always.
    Bit,
    /// Eight bits: an input or output that a calculation writes.
    Byte,
    /// 32 bits.
    Integer,
    /// A timer's count: a TIME here, as many milliseconds as it counts.
    Count,
    Float,
}

impl Kind {
    /// The type of a tag that holds it.
    pub(super) const fn ty(self) -> &'static str {
        match self {
            Kind::Bit => "BOOL",
            Kind::Byte => "USINT",
            Kind::Integer => "DINT",
            Kind::Count => "TIME",
            Kind::Float => "LREAL",
        }
    }
}

/// The kinds of all variables of a program.
#[derive(Debug, Default)]
pub(super) struct Kinds(HashMap<Variable, Kind>);

impl Kinds {
    pub(super) fn of(file: &File) -> Kinds {
        let elements = file.elements();
        let mut kinds = Kinds::default();
        let integers = bit_integers(&elements);
        for variable in elements.iter().flat_map(|element| variables(element)) {
            let kind = match variable.family {
                Family::Integer if !integers.contains(variable) => Kind::Integer,
                Family::Float => Kind::Float,
                _ => Kind::Bit,
            };
            kinds.0.insert(variable.clone(), kind);
        }
        // Who is given a number is one, and who is given that.
        loop {
            let mut changed = false;
            for element in &elements {
                let Some(Operand::Variable(to)) = result(element) else {
                    continue;
                };
                if kinds.variable(to) == Kind::Bit && !kinds.gives_bit(element) {
                    let number = match to.family {
                        Family::Integer => Kind::Integer,
                        _ => Kind::Byte,
                    };
                    kinds.0.insert(to.clone(), number);
                    changed = true;
                }
            }
            if !changed {
                return kinds;
            }
        }
    }

    pub(super) fn variable(&self, variable: &Variable) -> Kind {
        self.0.get(variable).copied().unwrap_or(Kind::Bit)
    }

    /// What an operand holds; of a number, what C takes it for.
    pub(super) fn operand(&self, operand: &Operand) -> Kind {
        match operand {
            Operand::Variable(variable) => self.variable(variable),
            Operand::Member(variable, Member::Ac) if variable.family == Family::Timer => Kind::Count,
            Operand::Member(_, Member::Pre | Member::Ac | Member::B) => Kind::Integer,
            Operand::Member(_, Member::Dn | Member::En | Member::Tt | Member::Cc) => Kind::Bit,
            Operand::Number(number) if number.is_float() => Kind::Float,
            Operand::Number(_) => Kind::Integer,
        }
    }

    /// Whether an operand is a bit, or the number 0 or 1.
    pub(super) fn is_bit(&self, operand: &Operand) -> bool {
        match operand {
            Operand::Number(number) => matches!(number.whole(), Some(0 | 1)),
            other => self.operand(other) == Kind::Bit,
        }
    }

    fn gives_bit(&self, element: &Element) -> bool {
        match element.row.form {
            Form::Assign | Form::Calculate(Op::And | Op::Or | Op::Xor) => {
                element.operands[1..].iter().all(|operand| self.is_bit(operand))
            }
            _ => false,
        }
    }
}

/// The operand that a calculation writes.
pub(super) fn result(element: &Element) -> Option<&Operand> {
    match element.row.form {
        Form::Calculate(_) | Form::Not | Form::Assign => element.operands.first(),
        _ => None,
    }
}

fn variables(element: &Element) -> impl Iterator<Item = &Variable> {
    element.operands.iter().filter_map(|operand| match operand {
        Operand::Variable(variable) => Some(variable),
        _ => None,
    })
}

/// The `MI` that are looked at like bits and nowhere like numbers.
fn bit_integers(elements: &[&Element]) -> HashSet<Variable> {
    let (mut bits, mut numbers) = (HashSet::new(), HashSet::new());
    for element in elements {
        let set = match element.row.form {
            Form::Contact(_) | Form::Coil(_) => &mut bits,
            Form::Reset | Form::Assign | Form::Calculate(Op::And | Op::Or | Op::Xor) => continue,
            _ => &mut numbers,
        };
        set.extend(
            variables(element)
                .filter(|v| v.family == Family::Integer)
                .cloned(),
        );
    }
    bits.retain(|variable| !numbers.contains(variable));
    bits
}

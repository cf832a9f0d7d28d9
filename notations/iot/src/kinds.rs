//! Which inputs and outputs are bits, and which are numbers.

use super::model::{Element, Family, File, Member, Operand, Variable};
use super::word::Form;
use ladder_instructions::Op;
use std::collections::HashSet;

/// The inputs and outputs that a calculation may give another number than 0 or 1.
pub(super) fn numbers(file: &File) -> HashSet<Variable> {
    let elements = file.elements();
    let mut numbers = HashSet::new();
    loop {
        let before = numbers.len();
        for element in &elements {
            let Some(Operand::Variable(to)) = result(element) else {
                continue;
            };
            let is_pin = matches!(to.family, Family::Input | Family::Output);
            if is_pin && !numbers.contains(to) && !gives_bit(element, &numbers) {
                numbers.insert(to.clone());
            }
        }
        if numbers.len() == before {
            return numbers;
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

fn gives_bit(element: &Element, numbers: &HashSet<Variable>) -> bool {
    match element.row.form {
        Form::Assign | Form::Calculate(Op::And | Op::Or | Op::Xor) => element.operands[1..]
            .iter()
            .all(|operand| is_bit(operand, numbers)),
        _ => false,
    }
}

/// Whether an operand is 0 or 1.
pub(super) fn is_bit(operand: &Operand, numbers: &HashSet<Variable>) -> bool {
    match operand {
        Operand::Number(number) => matches!(number.whole(), Some(0 | 1)),
        Operand::Variable(variable) => {
            matches!(variable.family, Family::Input | Family::Output) && !numbers.contains(variable)
        }
        Operand::Member(_, member) => {
            matches!(member, Member::Dn | Member::En | Member::Tt | Member::Cc)
        }
    }
}

/// Whether an operand is a float for C.
pub(super) fn is_float(operand: &Operand) -> bool {
    match operand {
        Operand::Number(number) => number.is_float(),
        Operand::Variable(variable) => variable.family == Family::Float,
        Operand::Member(..) => false,
    }
}

//! What iot-ladder-editor checks, and what its compiler is known to get wrong.

use super::kinds::{is_bit, numbers};
use super::model::{Element, File, Operand};
use super::word::Form;
use ladder_analysis::Severity;
use ladder_instructions::Op;
use ladder_notation::Finding;
use std::collections::HashMap;

/// What there is to say about a program.
pub(super) fn findings(file: &File) -> Vec<Finding> {
    let mut out = Vec::new();
    let numbers = numbers(file);
    let mut edges: HashMap<String, &Element> = HashMap::new();
    let elements = file.elements();
    for element in &elements {
        match element.row.form {
            Form::Timer(_) => state(element, 999_999, &mut out),
            Form::Counter(_) => state(element, 999_999_999, &mut out),
            Form::Contact(Op::RisingContact | Op::FallingContact)
            | Form::Coil(Op::RisingCoil | Op::FallingCoil) => {
                let operand = &element.operands[0];
                match edges.get(&operand.to_string()) {
                    Some(first) => {
                        let message = format!(
                            "the edge elements on {operand} share one memory: the one at {} uses up the edge; use another \
                             variable for this one",
                            first.place
                        );
                        out.push(warning(element, "iot-shared-edge", message));
                    }
                    None => drop(edges.insert(operand.to_string(), element)),
                }
            }
            Form::Not if is_bit(&element.operands[1], &numbers) => {
                let message = format!(
                    "NOT inverts all bits of a number: of 0 and of 1 it makes something that is not 0; use NC {}",
                    element.operands[1]
                );
                out.push(warning(element, "iot-not-of-bit", message));
            }
            _ => {}
        }
        let is_negative = |operand: &&Operand| matches!(operand, Operand::Number(n) if n.value < 0.0);
        let is_calculation = !matches!(element.row.form, Form::Timer(_) | Form::Counter(_));
        if let Some(number) = element
            .operands
            .iter()
            .find(is_negative)
            .filter(|_| is_calculation)
        {
            let message = format!("the editor's compiler makes invalid C of {number}; subtract instead");
            out.push(warning(element, "iot-negative-number", message));
        }
    }
    out
}

fn state(element: &Element, most: i32, out: &mut Vec<Finding>) {
    for operand in &element.operands[1..] {
        let Operand::Number(number) = operand else {
            continue;
        };
        if number.whole().is_none_or(|number| number.abs() > most) {
            let message = format!(
                "{number} is out of range: -{most} to {most}",
                number = number.text
            );
            out.push(warning(element, "iot-range", message));
        }
    }
    let preset = match element.operands.get(1) {
        Some(Operand::Number(number)) => number.value,
        _ => return,
    };
    if preset <= 0.0 && element.row.form != Form::Counter(Op::Ctd) {
        let message = format!("the preset {preset} is reached at once");
        out.push(warning(element, "iot-preset", message));
    }
}

fn warning(element: &Element, check: &'static str, message: String) -> Finding {
    Finding {
        place: element.place,
        severity: Severity::Warning,
        check,
        message,
    }
}

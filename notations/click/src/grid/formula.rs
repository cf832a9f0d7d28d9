//! Formulas as the grid writes them: `(DS1 * 2) + DS[DS2+1]`.

use super::super::address::{Address, Span};
use super::super::formula::{self, Spelling};
use super::super::model::{Formula, Operand, Operator};
use super::addresses::Addresses;
use super::contact::exists;
use super::operand::operand_text;
use std::cell::Cell;

/// A formula.
///
/// # Errors
///
/// Why it is none.
pub(super) fn read(text: &str) -> Result<Formula, String> {
    formula::shallow(text)?;
    let formula = formula::parse(text).map_err(|error| {
        let before: String = text
            .get(..error.at)
            .unwrap_or(text)
            .chars()
            .rev()
            .take(20)
            .collect();
        let before: String = before.chars().rev().collect();
        format!("after `{before}` in the formula: {}", error.message)
    })?;
    let (mut operands, mut sums) = (Vec::new(), Vec::new());
    formula::operands(&formula, &mut operands);
    formula::sums(&formula, &mut sums);
    for operand in operands {
        let tag = match operand {
            Operand::Constant(_) => continue,
            Operand::Tag(tag) => tag,
            Operand::Pointer(pointer) => &pointer.by,
        };
        match tag.address() {
            Some(address) => _ = exists(address)?,
            None => return Err("the grid has addresses and no nicknames".to_owned()),
        }
    }
    match sums.iter().find(|span| !span.exists()) {
        Some(span) => Err(format!(
            "there is no {span}: {} has {}",
            span.bank.row().name,
            span.bank.extent()
        )),
        None => Ok(formula),
    }
}

/// As the grid writes it. None: an address has only a nickname.
pub(super) fn write(formula: &Formula, addresses: &Addresses) -> Option<String> {
    let nameless = Cell::new(false);
    let operand = |operand: &Operand| {
        operand_text(operand, addresses).unwrap_or_else(|| {
            nameless.set(true);
            String::new()
        })
    };
    let binary = |operator: Operator, left: &str, right: &str| match operator {
        Operator::ShiftLeft => Some(format!("LSH({left},{right})")),
        Operator::ShiftRight => Some(format!("RSH({left},{right})")),
        _ => None,
    };
    let spelling = Spelling {
        operand: &operand,
        sum: &|span| {
            let Span { bank, first, last } = *span;
            let [first, last] = [first, last].map(|number| Address { bank, number });
            format!("SUM ( {first} : {last} )")
        },
        binary: Some(&binary),
    };
    let text = formula::write(formula, spelling);
    (!nameless.get()).then_some(text)
}

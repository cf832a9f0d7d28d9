//! From what a formula computes to its text.

use super::super::address::Span;
use super::super::model::{Formula, Operand, Operator};
use super::{ATOM, PREFIX};

/// An operator with its two sides as something else than that.
pub(in super::super) type Binary = dyn Fn(Operator, &str, &str) -> Option<String>;

/// How a formula writes what it computes with.
#[derive(Clone, Copy)]
pub(in super::super) struct Spelling<'s> {
    pub(in super::super) operand: &'s dyn Fn(&Operand) -> String,
    /// A sum, with its name.
    pub(in super::super) sum: &'s dyn Fn(&Span) -> String,
    /// What has no spelling of its own: Click's own words for shifts, for example. None: as the DSL.
    pub(in super::super) binary: Option<&'s Binary>,
}

/// The text of a formula, with no more parentheses than it needs.
pub(in super::super) fn write(formula: &Formula, spelling: Spelling<'_>) -> String {
    part(formula, spelling).0
}

/// A text and how tightly it holds together.
fn part(formula: &Formula, spelling: Spelling<'_>) -> (String, u8) {
    let inside = |formula: &Formula, loosest: u8| {
        let (text, precedence) = part(formula, spelling);
        if precedence < loosest {
            format!("({text})")
        } else {
            text
        }
    };
    match formula {
        Formula::Value(operand) => {
            let text = (spelling.operand)(operand);
            let precedence = if text.starts_with('-') { PREFIX } else { ATOM };
            (text, precedence)
        }
        Formula::Pi => ("PI".to_owned(), ATOM),
        // `--a` is nothing anybody reads, and `-5` is a number.
        Formula::Negated(value) => {
            let negative = matches!(**value, Formula::Value(Operand::Constant(_)));
            let loosest = if negative { ATOM + 1 } else { ATOM };
            (format!("-{}", inside(value, loosest)), PREFIX)
        }
        Formula::Not(value) => (format!("NOT {}", inside(value, PREFIX)), PREFIX),
        Formula::Binary(left, operator, right) => {
            if let Some(binary) = spelling.binary
                && let Some(text) = binary(*operator, &inside(left, 0), &inside(right, 0))
            {
                return (text, ATOM);
            }
            let precedence = operator.precedence();
            let (before, after) = match operator {
                Operator::Power => (precedence + 1, precedence),
                _ => (precedence, precedence + 1),
            };
            let text = format!(
                "{} {} {}",
                inside(left, before),
                operator.sign(),
                inside(right, after)
            );
            (text, precedence)
        }
        Formula::Call(function, arguments) => {
            let arguments: Vec<String> = arguments.iter().map(|argument| inside(argument, 0)).collect();
            (format!("{}({})", function.name(), arguments.join(", ")), ATOM)
        }
        Formula::Sum(span) => ((spelling.sum)(span), ATOM),
    }
}

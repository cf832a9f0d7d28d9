//! `wrong-shape`: an instruction in brackets that it does not have, as in `<TON>` or `[SET]( run )`.

use crate::findings::diagnostic::{Applicability, Diagnostic};
use crate::findings::excerpt;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::networks::BlockAt;
use ladder_instructions::{Instruction, Op, in_other_shape};
use ladder_syntax::Parse;

pub(crate) const RULE: Rule =
    Rule(&RuleFacts::new(RuleGroup::Blocks, "wrong-shape", Severity::Error).fixed(Applicability::Safe));

/// The instruction of this name in other brackets; one that takes the operands as they are comes first.
pub(crate) fn elsewhere(bound: BlockAt<'_>) -> Option<&'static Instruction> {
    let mut rows = in_other_shape(bound.facts.shape, bound.facts.head.text());
    taking_operands(bound).or_else(|| rows.next())
}

/// The instruction of this name in other brackets that takes the operands as they are.
pub(crate) fn taking_operands(bound: BlockAt<'_>) -> Option<&'static Instruction> {
    let count = bound.positional_count();
    in_other_shape(bound.facts.shape, bound.facts.head.text()).find(|row| row.takes(count))
}

/// Only a word that is one instruction and no other, with the operands that it takes, can mean nothing else: one or
/// two letters are one slip away from others.
fn applicability(bound: BlockAt<'_>, row: &Instruction) -> Applicability {
    let name = bound.facts.head.text();
    let is_the_only_one = in_other_shape(bound.facts.shape, name).nth(1).is_none();
    let fits = row.takes(bound.positional_count());
    if bound.instruction().is_none() && is_the_only_one && fits && name.len() > 2 {
        Applicability::Safe
    } else {
        Applicability::Unsafe
    }
}

pub(crate) fn brackets(parse: &Parse, bound: BlockAt<'_>, row: &'static Instruction) -> Diagnostic {
    let list = bound
        .facts
        .list_range
        .map(|range| excerpt::text(parse, bound.absolute(range)))
        .unwrap_or_default();
    let written = format!("{}{list}", row.block());
    let head = bound.head_text();
    // `[SET]` is an instruction too, for other operands.
    let message = match bound.instruction() {
        Some(own) => format!("{head}{list} is not {}", own.signature()),
        None => format!(
            "there is no {head}: the {} is written {}",
            excerpt::in_sentence(row.title),
            row.block()
        ),
    };
    let help = match row.op {
        Op::SetCoil => format!("to latch a bit write {written}"),
        Op::ResetCoil => format!("to reset a bit write {written}"),
        Op::Coil => format!("to write a bit write {written}"),
        Op::Contact => format!("to test a bit write {written}"),
        _ => format!("write {written}"),
    };
    Diagnostic::new(RULE, bound.head_range(), message).help(help).fix(
        applicability(bound, row),
        format!("Replace with {}", row.block()),
        bound.head_range(),
        row.block(),
    )
}

//! `wrong-shape`: an instruction in brackets that it does not have, as in `<TON>` or `[SET]( run )`.

use super::operand_fit::fits;
use crate::findings::diagnostic::{Applicability, Diagnostic};
use crate::findings::excerpt;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::networks::BlockAt;
use crate::values::literal::Literal;
use crate::written::facts::{Node, NodeKind};
use ladder_instructions::{Instruction, Op, Role, Shape, in_other_shape};
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

/// Only a word that is one instruction and no other can mean nothing else: one or two letters are one slip away from
/// others. None where the drawing says something else than the instruction: what is drawn as a coil is not a condition, an
/// operand must be one that it takes, and elsewhere the END of a program ends the scan, not all of them.
fn applicability(bound: BlockAt<'_>, row: &Instruction) -> Option<Applicability> {
    let name = bound.facts.head.text();
    let is_read_as_coil = bound.facts.shape == Shape::Coil && row.role == Role::Condition;
    if is_read_as_coil || row.op == Op::End || !fits(bound, row) {
        return None;
    }
    let is_the_only_one = in_other_shape(bound.facts.shape, name).nth(1).is_none();
    let has_list = bound.facts.list_range.is_some();
    let is_safe = bound.instruction().is_none() && is_the_only_one && name.len() > 2 && has_list;
    Some(if is_safe {
        Applicability::Safe
    } else {
        Applicability::Unsafe
    })
}

/// A loop in the way of other languages, with the counter, its first and its last value: `[FOR]( i, 1, 3 )`.
pub(crate) fn counted_loop(
    parse: &Parse,
    bound: BlockAt<'_>,
    row: &'static Instruction,
) -> Option<Diagnostic> {
    let facts = &bound.facts;
    let [counter, first, last] = &facts.operands[..] else {
        return None;
    };
    if row.op != Op::For || bound.positional_count() != 3 || !matches!(counter.value.kind, NodeKind::Name(_))
    {
        return None;
    }
    let text = |node: &Node| excerpt::text(parse, bound.absolute(node.range));
    let number = |node: &Node| match node.literal() {
        Some(Literal::Int(number)) => Some(*number),
        _ => None,
    };
    let turns = match (number(&first.value), number(&last.value)) {
        (Some(first), Some(last)) => last.saturating_sub(first).saturating_add(1).to_string(),
        (Some(1), None) => text(&last.value),
        _ => "turns".to_owned(),
    };
    let counter = text(&counter.value);
    let list = facts.list_range.unwrap_or(facts.head_range);
    let range = bound.absolute(facts.head_range.cover(list));
    let written = format!("{}( {turns}, I => {counter} )", row.block());
    Some(
        Diagnostic::new(
            RULE,
            range,
            format!("a loop takes how many times it runs: write {written}"),
        )
        .help(format!("`{counter}` is then the number of the turn, from 1"))
        .fix(Applicability::Unsafe, format!("Write {written}"), range, written),
    )
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
    if let Some(counted) = counted_loop(parse, bound, row) {
        return counted;
    }
    let help = match row.op {
        Op::SetCoil => format!("to latch a bit write {written}"),
        Op::ResetCoil => format!("to reset a bit write {written}"),
        Op::Coil => format!("to write a bit write {written}"),
        Op::Contact => format!("to test a bit write {written}"),
        Op::End => "<END> stops the program for good; to end the scan write <RET>".to_owned(),
        _ => format!("write {written}"),
    };
    let found = Diagnostic::new(RULE, bound.head_range(), message).help(help);
    let Some(applicability) = applicability(bound, row) else {
        return found;
    };
    let title = format!("Replace with {}", row.block());
    found.fix(applicability, title, bound.head_range(), row.block())
}

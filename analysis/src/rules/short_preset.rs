//! `short-preset`: a timer's time is shorter than a scan.

use super::survey::SurveyedBlock;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::findings::rule_settings::DEFAULT_SCAN_INTERVAL;
use crate::names::operand_value::Number;
use crate::networks::network::Formal;
use crate::values::literal::Literal;
use crate::values::types::Scalar;
use crate::written::facts::{Node, NodeKind};
use ladder_instructions::{Accepts, Instruction, Timing};
use ladder_syntax::TextRange;

pub(crate) const RULE: Rule =
    Rule(&RuleFacts::new(RuleGroup::Blocks, "short-preset", Severity::Warning).about_types());

const MILLISECOND: i128 = 1_000_000;

/// What 16 bits count, and one scan more.
const MOST_SCANS: i128 = 32_768;

/// What 16 bits count.
const MOST_UNITS: i128 = 32_767;

/// The time base of a timer that names none, in nanoseconds.
const DEFAULT_TIME_BASE: i128 = 100_000_000;

pub(super) fn check(place: &SurveyedBlock<'_>, out: &mut Vec<Diagnostic>) {
    if !place.row.is_some_and(Instruction::is_timer) {
        return;
    }
    let bound = place.bound;
    let mut operands = bound.facts.operands.iter().zip(bound.formals.iter());
    let Some((operand, _)) = operands
        .find(|(_, formal)| matches!(formal, Formal::Operand(row) if row.accepts == Accepts::Duration))
    else {
        return;
    };
    let Some(Number::Int(value)) = place.tags.number(&operand.value) else {
        return;
    };
    // A plain integer is milliseconds.
    let plain = is_integer(place, &operand.value);
    let preset = if plain { value * MILLISECOND } else { value };
    let scan = place.scan;
    let scan = i128::from(scan.unwrap_or(DEFAULT_SCAN_INTERVAL));
    let at = bound.absolute(operand.value.range);
    match place.tags.profile().semantics().timing {
        Timing::Clock => {}
        Timing::Scans => return out.extend(in_scans(preset, scan, at)),
        Timing::Ticks => return out.extend(in_ticks(place, plain.then_some(value), scan, at)),
        Timing::Units => {
            let base = time_base(place, MILLISECOND);
            return out.extend(base.and_then(|base| in_units(value, plain, base, at)));
        }
    }
    if !(0..scan).contains(&preset) {
        return;
    }
    let message = if preset == 0 {
        "the preset is 0: the timer does not wait".to_owned()
    } else {
        format!(
            "the preset is shorter than a scan of {}: the timer cannot tell it from one scan",
            milliseconds(scan)
        )
    };
    let found = Diagnostic::new(RULE, at, message);
    out.push(if plain && value > 0 {
        found.help(format!(
            "a plain number is milliseconds: {value} s is written T#{value}s"
        ))
    } else {
        found.help("give a time of at least a scan, or leave the timer out")
    });
}

/// A timer that counts scans: it needs two at least, and its count has 16 bits. The simulator refuses it otherwise.
fn in_scans(preset: i128, scan: i128, at: TextRange) -> Option<Diagnostic> {
    let scans = preset / scan;
    let (message, help) = match scans {
        ..2 => (
            format!(
                "the time is {} of {}: timers of this profile take 2 or more",
                if scans == 1 {
                    "1 scan".to_owned()
                } else {
                    format!("{scans} scans")
                },
                milliseconds(scan)
            ),
            "give a longer time, or a shorter scan above the first network, as in: # ladder: cycle 1ms #",
        ),
        2..=MOST_SCANS => return None,
        _ => (
            format!(
                "the time is {scans} scans of {}: timers of this profile count to {MOST_SCANS}",
                milliseconds(scan)
            ),
            "give a shorter time, or a longer scan above the first network, as in: # ladder: cycle 100ms #",
        ),
    };
    Some(Diagnostic::new(RULE, at, message).help(help))
}

/// A timer that counts steps of a time base, at most one in a scan.
fn in_ticks(place: &SurveyedBlock<'_>, count: Option<i128>, scan: i128, at: TextRange) -> Option<Diagnostic> {
    if count.is_some_and(|count| count <= 0) {
        let message = "the preset is 0 or less: the first step reaches it";
        return Some(Diagnostic::new(RULE, at, message).help("count one step or more"));
    }
    match time_base(place, DEFAULT_TIME_BASE) {
        Some(base) if base < scan => {
            let message = format!(
                "the time base is {} and a scan {}: a timer counts one step in a scan at most, and runs slow",
                milliseconds(base),
                milliseconds(scan)
            );
            let found = Diagnostic::new(RULE, at, message);
            Some(found.help("take a longer time base, or a shorter scan"))
        }
        _ => None,
    }
}

/// The time base of a timer in nanoseconds, if it is a fixed number.
fn time_base(place: &SurveyedBlock<'_>, unless_named: i128) -> Option<i128> {
    let bound = place.bound;
    let mut operands = bound.facts.operands.iter().zip(bound.formals.iter());
    let named =
        operands.find(|(_, formal)| matches!(formal, Formal::Operand(row) if row.accepts == Accepts::Time));
    let Some((operand, _)) = named else {
        return Some(unless_named);
    };
    match place.tags.number(&operand.value) {
        Some(Number::Int(base)) => Some(base),
        _ => None,
    }
}

/// A timer that counts time in a unit: its count has 16 bits. The simulator refuses what is longer.
fn in_units(value: i128, plain: bool, base: i128, at: TextRange) -> Option<Diagnostic> {
    let units = if plain { value } else { value / base.max(1) };
    let (message, help) = match units {
        ..1 => (
            "the preset is less than one unit of the timer: it does not wait".to_owned(),
            "give at least one unit; B := T#1s sets the unit, 1 ms unless given",
        ),
        1..=MOST_UNITS => return None,
        _ => (
            format!("the preset is {units} units: timers of this profile count to {MOST_UNITS}"),
            "count in a longer unit, as in: B := T#1s",
        ),
    };
    Some(Diagnostic::new(RULE, at, message).help(help))
}

fn is_integer(place: &SurveyedBlock<'_>, node: &Node) -> bool {
    match &node.kind {
        NodeKind::Literal(_) => matches!(node.literal(), Some(Literal::Int(_))),
        _ => place.tags.scalar(node).is_some_and(Scalar::is_integer),
    }
}

fn milliseconds(nanoseconds: i128) -> String {
    format!("{} ms", nanoseconds as f64 / MILLISECOND as f64)
}

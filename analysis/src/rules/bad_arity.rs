//! `bad-arity`: a block has too few or too many operands.

use super::form::Form;
use super::{missing_wire, wrong_shape};
use crate::findings::diagnostic::{Applicability, Diagnostic};
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::networks::BlockAt;
use crate::networks::network::{Formal, Meaning};
use crate::program::ParameterKind;
use crate::written::user_block::UserBlockFacts;
use ladder_instructions::{Accepts, Instruction, Operand};
use ladder_syntax::{Parse, TextRange};

pub(crate) const RULE: Rule =
    Rule(&RuleFacts::new(RuleGroup::Blocks, "bad-arity", Severity::Error).fixed(Applicability::Unsafe));

/// What holds the place of an operand until a person writes the right one. It is an error, so that nothing runs with it.
pub(super) const PLACEHOLDER: &str = "?";

pub(super) fn check(form: &Form<'_>, out: &mut Vec<Diagnostic>) {
    let network = form.network;
    for (index, bound) in network.blocks().enumerate() {
        if bound.faulty {
            continue;
        }
        match bound.meaning {
            Meaning::Instruction(row) => {
                if !row.takes(bound.positional_count()) && !missing_wire::takes_next_head(network, index) {
                    out.extend(instruction(form.parse, bound, row));
                }
            }
            Meaning::User(block) => user_block(&form.user_blocks[block], bound, out),
            Meaning::Unknown | Meaning::UnknownUser => continue,
        }
        given_twice(bound, out);
    }
}

fn instruction(parse: &Parse, bound: BlockAt<'_>, row: &'static Instruction) -> Option<Diagnostic> {
    let given = bound.positional_count();
    // `PT := T#5s`: bad-operand says that it is given by its place.
    let by_name = |operand: &&Operand| {
        let names = bound.facts.operands.iter().filter_map(|o| o.name());
        names
            .into_iter()
            .any(|name| name.text.eq_ignore_ascii_case(operand.name))
    };
    if row
        .operands
        .iter()
        .filter(|o| row.named(o.name).is_none())
        .any(|o| by_name(&o))
    {
        return None;
    }
    if let Some(counted) = wrong_shape::counted_loop(parse, bound, row) {
        return Some(counted);
    }
    if given > 0
        && let Some(other) = wrong_shape::taking_operands(bound)
    {
        return Some(wrong_shape::brackets(parse, bound, other));
    }
    let excess: Vec<usize> = (0..bound.formals.len())
        .filter(|&n| matches!(bound.formals[n], Formal::Excess))
        .collect();
    let range = match (excess.first(), excess.last()) {
        (Some(&first), Some(&last)) => bound.absolute(
            bound.facts.operands[first]
                .range
                .cover(bound.facts.operands[last].range),
        ),
        _ => bound.range(),
    };
    let found = Diagnostic::new(RULE, range, message(bound, row, given))
        .help(format!("it is written {}", row.signature()));
    // An operand too many says that something else is meant: to take it away would be to guess what.
    Some(if excess.is_empty() {
        add_missing(bound, row, given, found)
    } else {
        found
    })
}

fn message(bound: BlockAt<'_>, row: &Instruction, given: usize) -> String {
    let least = row.required();
    let takes = match row.limit() {
        Some(0) => "no operands".to_owned(),
        Some(most) if most == least => operands(most),
        Some(most) => format!("{least} to {most} operands"),
        None if given < least => format!("at least {}", operands(least)),
        // Repeated in groups, and the last group is not whole.
        None => "its last operands in pairs".to_owned(),
    };
    let given = match given {
        0 => "none is given".to_owned(),
        1 => "1 is given".to_owned(),
        n => format!("{n} are given"),
    };
    format!("{} takes {takes}, {given}", bound.head_text())
}

fn operands(count: usize) -> String {
    if count == 1 {
        "1 operand".to_owned()
    } else {
        format!("{count} operands")
    }
}

fn add_missing(bound: BlockAt<'_>, row: &'static Instruction, given: usize, found: Diagnostic) -> Diagnostic {
    // At most one group of operands lacks after the required ones.
    let Some(needed) = (given..given + 8).find(|&count| row.takes(count)) else {
        return found;
    };
    let missing: Vec<&Operand> = (given..needed)
        .filter_map(|index| row.positional(index))
        .collect();
    let names: Vec<&str> = missing.iter().map(|operand| operand.name).collect();
    let title = format!("Add {}", names.join(" and "));
    let values: Vec<&str> = missing.iter().map(|operand| value(operand)).collect();
    let (at, text) = insertion(bound, given, &values.join(", "));
    found.fix(Applicability::Unsafe, title, bound.absolute(at), text)
}

/// What is written for a missing operand: a preset that works until a person writes another one. What a tag or another value is
/// nobody else can know.
fn value(operand: &Operand) -> &'static str {
    match operand.accepts {
        Accepts::Duration | Accepts::Time => "T#1s",
        Accepts::Count => "10",
        _ => PLACEHOLDER,
    }
}

/// Where missing operands go, and the text that puts them there.
fn insertion(bound: BlockAt<'_>, given: usize, values: &str) -> (TextRange, String) {
    let facts = &bound.facts;
    let Some(list) = facts.list_range else {
        return (TextRange::empty(facts.head_range.end()), format!("( {values} )"));
    };
    match (given.checked_sub(1), facts.operands.first()) {
        (_, None) => (list, format!("( {values} )")),
        (None, Some(named)) => (TextRange::empty(named.range.start()), format!("{values}, ")),
        (Some(_), Some(_)) => {
            let last = facts.operands.iter().rfind(|operand| operand.name().is_none());
            let end = last.map_or(list.end(), |operand| operand.range.end());
            (TextRange::empty(end), format!(", {values}"))
        }
    }
}

fn user_block(facts: &UserBlockFacts, bound: BlockAt<'_>, out: &mut Vec<Diagnostic>) {
    if facts.doubtful {
        return;
    }
    let name_of = |index: usize| facts.parameters[index].name.as_str();
    let signature = || format!("it is written {}", signature(facts, bound, &name_of));
    let excess: Vec<usize> = (0..bound.formals.len())
        .filter(|&n| matches!(bound.formals[n], Formal::Excess))
        .collect();
    if let (Some(&first), Some(&last)) = (excess.first(), excess.last()) {
        let range = bound.facts.operands[first]
            .range
            .cover(bound.facts.operands[last].range);
        let message = format!(
            "{} takes {}, {} are given",
            bound.head_text(),
            operands(facts.parameters.len()),
            bound.positional_count()
        );
        let found = Diagnostic::new(RULE, bound.absolute(range), message)
            .help(signature())
            .related_at(facts.file(), facts.at, "the block is defined here");
        out.push(found);
        return;
    }
    let is_given = |index| {
        bound
            .formals
            .iter()
            .any(|formal| matches!(formal, Formal::Parameter(given) if *given == index))
    };
    let has_instance = bound
        .formals
        .iter()
        .any(|formal| matches!(formal, Formal::Instance));
    let missing: Vec<String> = (0..facts.parameters.len())
        .filter(|&index| {
            let parameter = &facts.parameters[index];
            let optional = match parameter.kind {
                // A state that is a tag keeps what it is not given.
                ParameterKind::Input => parameter.has_default || has_instance,
                ParameterKind::Output => true,
                ParameterKind::InOut => parameter.has_default,
            };
            !optional && !is_given(index)
        })
        .map(|index| format!("`{}`", name_of(index)))
        .collect();
    if missing.is_empty() {
        return;
    }
    let message = match missing.as_slice() {
        [one] => format!("the operand {one} of {} is missing", bound.head_text()),
        several => format!(
            "the operands {} of {} are missing",
            several.join(", "),
            bound.head_text()
        ),
    };
    out.push(
        Diagnostic::new(RULE, bound.range(), message)
            .help(signature())
            .related_at(facts.file(), facts.at, "the block is defined here"),
    );
}

fn signature<'n>(facts: &UserBlockFacts, bound: BlockAt<'_>, name_of: &dyn Fn(usize) -> &'n str) -> String {
    let head = bound.head_text();
    if facts.parameters.is_empty() {
        return head;
    }
    let names: Vec<&str> = (0..facts.parameters.len()).map(name_of).collect();
    format!("{head}( {} )", names.join(", "))
}

/// An operand that is given twice: by its place and by name, or by name twice.
fn given_twice(bound: BlockAt<'_>, out: &mut Vec<Diagnostic>) {
    for (index, formal) in bound.formals.iter().enumerate() {
        let operand = &bound.facts.operands[index];
        let Some(name) = operand.name() else { continue };
        if !matches!(formal, Formal::Operand(_) | Formal::Parameter(_)) {
            continue;
        }
        let same = |other: &Formal| match (formal, other) {
            (Formal::Operand(a), Formal::Operand(b)) => std::ptr::eq(*a, *b),
            (Formal::Parameter(a), Formal::Parameter(b)) => a == b,
            _ => false,
        };
        if let Some(first) = bound.formals[..index].iter().position(same) {
            out.push(
                Diagnostic::new(
                    RULE,
                    bound.absolute(operand.range),
                    format!(
                        "the operand `{}` of {} is given twice",
                        name.text,
                        bound.head_text()
                    ),
                )
                .help("leave one of them out")
                .related(
                    bound.absolute(bound.facts.operands[first].range),
                    "it is given here before",
                ),
            );
        }
    }
}

//! `unknown-instruction`: no instruction has this name.

use super::form::Form;
use super::operand_fit::fits;
use super::{missing_wire, wrong_shape};
use crate::findings::article::with_article;
use crate::findings::diagnostic::{Applicability, Diagnostic};
use crate::findings::excerpt::{in_sentence, text};
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::networks::BlockAt;
use crate::networks::network::Meaning;
use crate::values::literal::Literal;
use ladder_instructions::{
    Accepts, Instruction, Operand, Profile, Shape, TABLE, closest, in_other_shape, known_elsewhere, slip_of,
};
use ladder_syntax::{Parse, is_identifier};

pub(crate) const RULE: Rule = Rule(
    &RuleFacts::new(RuleGroup::Blocks, "unknown-instruction", Severity::Error).fixed(Applicability::Unsafe),
);

pub(super) fn check(form: &Form<'_>, out: &mut Vec<Diagnostic>) {
    let network = form.network;
    for (index, bound) in network.blocks().enumerate() {
        if let Meaning::Instruction(row) = bound.meaning {
            out.extend(not_in_profile(form.profile, row, bound));
            continue;
        }
        if !matches!(bound.meaning, Meaning::Unknown) || bound.faulty {
            continue;
        }
        let before = index.checked_sub(1);
        if before.is_some_and(|before| missing_wire::takes_next_head(network, before)) {
            continue;
        }
        out.push(meant(form.parse, bound));
    }
}

/// A timer or counter that a profile does not have: it would count what nothing there counts. Other instructions work
/// in every profile.
fn not_in_profile(profile: Profile, row: &Instruction, bound: BlockAt<'_>) -> Option<Diagnostic> {
    let counts = |operand: &Operand| match operand.accepts {
        Accepts::State(state) => state.is_timer() || state.is_counter(),
        _ => false,
    };
    if row.profiles.contain(profile) || !row.operands.iter().any(counts) {
        return None;
    }
    let known = TABLE
        .iter()
        .filter(|row| row.profiles.contain(profile) && row.operands.iter().any(counts));
    let known: Vec<String> = known.map(Instruction::block).collect();
    let message = format!("there is no {} in the profile `{profile}`", row.block());
    let found = Diagnostic::new(RULE, bound.head_range(), message);
    Some(found.help(format!("its timers and counters are {}", known.join(" "))))
}

/// What a block probably means. A name that other notations have says more than a likeness, and without operands the
/// name of a tag is where the kind of contact or coil belongs.
fn meant(parse: &Parse, bound: BlockAt<'_>) -> Diagnostic {
    let shape = bound.facts.shape;
    let text = bound.facts.head.text();
    let known = known_elsewhere(text);
    if let Some(found) = range_test(parse, bound) {
        return found;
    }
    let is_bare = bound.facts.list_range.is_none() && is_identifier(text) && shape != Shape::Function;
    // `[RESET]` is a contact of that tag, `(RESET)` the coil that resets one.
    let is_sign = known.is_some_and(|row| row.shape == shape);
    // `[END]`, `(RET)`.
    let mut complete = in_other_shape(shape, text).filter(|row| row.takes(0));
    if is_bare && !is_sign && complete.next().is_none() {
        return bare(bound);
    }
    match (known, wrong_shape::elsewhere(bound)) {
        (Some(row), _) if row.shape == shape => known_by(bound, row),
        (_, Some(row)) => wrong_shape::brackets(parse, bound, row),
        _ => misspelt(bound),
    }
}

fn unknown(bound: BlockAt<'_>) -> Diagnostic {
    Diagnostic::new(
        RULE,
        bound.head_range(),
        format!("there is no instruction {}", bound.head_text()),
    )
}

fn replaced(found: Diagnostic, bound: BlockAt<'_>, row: &Instruction) -> Diagnostic {
    let title = format!("Replace with {}", row.block());
    found.fix(Applicability::Unsafe, title, bound.head_range(), row.block())
}

/// `[start]`, `(run)`.
fn bare(bound: BlockAt<'_>) -> Diagnostic {
    let text = bound.facts.head.text();
    let (block, kind) = match bound.facts.shape {
        Shape::Coil => ("( )", "coil"),
        _ => ("[ ]", "contact"),
    };
    let written = format!("{block}( {text} )");
    unknown(bound)
        .help(format!(
            "{} of the tag `{text}` is written {written}",
            with_article(kind)
        ))
        .fix(
            Applicability::Unsafe,
            format!("Write {written}"),
            bound.head_range(),
            written,
        )
}

/// `(SET)`, `[XIC]`: other notations call an instruction so.
fn known_by(bound: BlockAt<'_>, row: &Instruction) -> Diagnostic {
    let message = format!(
        "there is no {}: the {} is written {}",
        bound.head_text(),
        in_sentence(row.title),
        row.block()
    );
    let found =
        Diagnostic::new(RULE, bound.head_range(), message).help(format!("it is written {}", row.signature()));
    // Without operands it is as incomplete under its right name.
    if bound.facts.list_range.is_none() || fits(bound, row) {
        replaced(found, bound, row)
    } else {
        found
    }
}

/// `[LIM]( low, value, high )`: whether a value is in a range. Where the limits are tags the low one may be above the high
/// one, which has another meaning there.
fn range_test(parse: &Parse, bound: BlockAt<'_>) -> Option<Diagnostic> {
    if bound.facts.shape != Shape::Logical || !bound.facts.head.text().eq_ignore_ascii_case("LIM") {
        return None;
    }
    let found = unknown(bound).help("a range test is written [GE]( value, low )--[LE]( value, high )");
    let [low, value, high] = &bound.facts.operands[..] else {
        return Some(found);
    };
    let are_in_order = match (low.value.literal(), high.value.literal()) {
        (Some(Literal::Int(low)), Some(Literal::Int(high))) => low <= high,
        (Some(Literal::Real(low)), Some(Literal::Real(high))) => low <= high,
        (Some(Literal::Time(low)), Some(Literal::Time(high))) => low <= high,
        _ => false,
    };
    if !are_in_order || bound.positional_count() != 3 {
        return Some(found);
    }
    let [low, value, high] = [low, value, high].map(|operand| text(parse, bound.absolute(operand.range)));
    let written = format!("[GE]( {value}, {low} )--[LE]( {value}, {high} )");
    let title = format!("Write {written}");
    Some(found.fix(Applicability::Unsafe, title, bound.range(), written))
}

fn misspelt(bound: BlockAt<'_>) -> Diagnostic {
    let found = unknown(bound);
    let shape = bound.facts.shape;
    let name = bound.facts.head.text();
    // A likeness across shapes says something only if the operands fit as well.
    let near = closest(shape, name).filter(|row| row.shape == shape || row.takes(bound.positional_count()));
    if let Some(row) = near {
        let found = found.help(format!(
            "did you mean {} ({})?",
            row.block(),
            in_sentence(row.title)
        ));
        return match slip_of(shape, name) {
            Some(row) if fits(bound, row) => replaced(found, bound, row),
            _ => found,
        };
    }
    found.help(match shape {
        Shape::Coil => "a coil is ( ), (/), (S), (R), (P), (N), (M), (SM), (RM) or (RES)",
        Shape::Function => {
            "a block in < > is <LBL>, <JMP>, <FUN>, <CALL>, <RET>, <END>, <FOR>, <NEXT> or <MCR>"
        }
        Shape::Logical => "contacts are [ ] and [/]; the language reference lists all instructions",
    })
}

//! Names that are not tags: labels, functions, and the operators of SEARCH.

use super::item::{CompletionKind, Topic};
use super::proposals::Proposals;
use crate::typing::{Operand, Typing};
use ladder_analysis::context::Body;
use rustc_hash::FxHashSet;

/// The labels that a jump from here can reach: those of its own body.
pub(super) fn labels(typing: &Typing<'_>, operand: &Operand, out: &mut Proposals<'_>) {
    let context = typing.context;
    let word = typing.absolute(typing.word.clone());
    let mut seen = FxHashSet::default();
    if operand.head.eq_ignore_ascii_case("LBL") {
        // Labels that are jumped to and are not anywhere.
        return missing_labels(typing, out);
    }
    for label in &context.labels {
        let here = typing
            .body
            .is_none_or(|body| context.bodies[label.network] == body);
        if here && label.at != word && seen.insert(label.key.clone()) {
            let detail = format!("label on line {}", context.line_number(label.at.start()));
            out.word(
                (0, 0),
                CompletionKind::Label,
                &label.name,
                &detail,
                Topic::Nothing,
            );
        }
    }
}

fn missing_labels(typing: &Typing<'_>, out: &mut Proposals<'_>) {
    let context = typing.context;
    let Some(body) = typing.body else { return };
    let word = typing.absolute(typing.word.clone());
    let mut seen = FxHashSet::default();
    for (network, _) in context
        .networks
        .iter()
        .zip(context.bodies.iter())
        .filter(|(_, of)| **of == body)
    {
        for (name, key, at) in crate::jumps::jumps(network) {
            let is = context
                .labels
                .iter()
                .any(|label| label.key == key && label.at != word && context.bodies[label.network] == body);
            if !is && seen.insert(key) {
                let detail = format!("jumped to on line {}", context.line_number(at.start()));
                out.word((0, 0), CompletionKind::Label, name, &detail, Topic::Nothing);
            }
        }
    }
}

/// The functions of this file, then those of others.
pub(super) fn functions(typing: &Typing<'_>, operand: &Operand, out: &mut Proposals<'_>) {
    let context = typing.context;
    if operand.head.eq_ignore_ascii_case("FUN") {
        return;
    }
    let mut seen = FxHashSet::default();
    for (index, function) in context.functions.iter().enumerate() {
        // A function that calls itself is rarely meant.
        let own = typing.body == Some(Body::Function(index));
        if seen.insert(function.name.to_lowercase()) {
            let detail = format!("function on line {}", context.line_number(function.at.start()));
            out.word(
                (u8::from(own), 0),
                CompletionKind::Function,
                &function.name,
                &detail,
                Topic::Nothing,
            );
        }
    }
    for name in context.others.function_names() {
        if seen.insert(name.to_lowercase()) {
            out.word(
                (2, 0),
                CompletionKind::Function,
                name,
                "function of another file",
                Topic::Nothing,
            );
        }
    }
}

/// The comparisons that SEARCH makes.
pub(super) fn search_operators(out: &mut Proposals<'_>) {
    for (name, words) in [
        ("EQ", "equal"),
        ("NE", "not equal"),
        ("GT", "greater"),
        ("GE", "greater or equal"),
        ("LT", "less"),
        ("LE", "less or equal"),
    ] {
        out.word((0, 0), CompletionKind::Operator, name, words, Topic::Nothing);
    }
}

//! Expressions: functions where a value is asked for, operators after one.

use super::item::{Completion, CompletionKind, Snippet, Topic};
use super::proposals::{Order, Proposals};
use crate::typing::Typing;
use ladder_analysis::values::callable::is_callable;
use ladder_instructions::{Instruction, TABLE};
use ladder_syntax::is_reserved;

/// Functions, and the words that begin a value.
pub(super) fn values(typing: &Typing<'_>, out: &mut Proposals<'_>) {
    // The words that are operators (AND, MOD) are not called.
    let callable = |row: &&Instruction| is_callable(row) && !is_reserved(row.mnemonic);
    for row in TABLE.iter().filter(callable) {
        let called = typing.rest(typing.word.end).starts_with('(');
        let text = if called {
            Snippet::plain_text(row.mnemonic)
        } else {
            let mut text = Snippet::default().text(row.mnemonic).text("(");
            for index in 1..row.required() {
                let Some(operand) = row.positional(index) else {
                    break;
                };
                text = text.text(if index == 1 { "" } else { ", " }).stop(operand.name);
            }
            text.text(")").end()
        };
        out.add_at(
            (6, 0),
            Completion {
                label: format!("{}(", row.mnemonic),
                detail: row.title.to_owned(),
                kind: CompletionKind::Function,
                range: typing.absolute(typing.word.clone()),
                filter: row.mnemonic.to_owned(),
                text,
                topic: Topic::Instruction(row.op, typing.context.profile),
            },
        );
    }
    let sum = Snippet::default().text("SUM(").stop("a[1..8]").text(")").end();
    let words = Topic::Words("The sum of the elements of a range.");
    out.snippet(
        (6, 0),
        CompletionKind::Function,
        "SUM(",
        "Sum of a range",
        sum,
        words,
    );
    operator(
        out,
        (6, 1),
        "NOT",
        "The opposite; of a number, every bit inverted.",
        "a",
    );
    out.word(
        (6, 1),
        CompletionKind::Value,
        "PI",
        "3.14159...",
        Topic::Words("Half the angle of a full turn, in radians."),
    );
}

/// The operators that are words. `missing`: what is after one that is accepted, where nothing is yet.
pub(super) fn operators(missing: &str, out: &mut Proposals<'_>) {
    for (word, doc) in [
        ("AND", "Both; of numbers, bit by bit."),
        ("OR", "One of them or both; of numbers, bit by bit."),
        ("XOR", "One of them, not both; of numbers, bit by bit."),
        ("MOD", "The remainder of a division."),
        ("SHL", "Bits shifted to the left."),
        ("SHR", "Bits shifted to the right."),
    ] {
        operator(out, (0, 0), word, doc, missing);
    }
}

fn operator(out: &mut Proposals<'_>, order: Order, word: &str, doc: &'static str, missing: &str) {
    let text = if missing.is_empty() {
        Snippet::plain_text(word)
    } else {
        Snippet::default().text(&format!("{word} ")).stop(missing)
    };
    out.snippet(
        order,
        CompletionKind::Operator,
        word,
        "operator",
        text,
        Topic::Words(doc),
    );
}

//! `commented-out-rung`: a comment that is a rung.

use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::names::context::Context;
use crate::written::facts;
use ladder_instructions::lookup;
use ladder_syntax::wiring::{PartKind, rung};
use ladder_syntax::{Line, LineKind, NodeOrToken, Part, TextRange, TextSize, parse};

pub(crate) const RULE: Rule = Rule(&RuleFacts::new(
    RuleGroup::Program,
    "commented-out-rung",
    Severity::Info,
));

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let parse = &*context.parse;
    let may_hold_one = |line: &Line| {
        line.is_commented()
            && matches!(line.kind, LineKind::Comment | LineKind::Rail)
            && may_be_rung(line.text())
    };
    let commented = parse.lines().of_parts_that(Part::is_commented);
    for (number, line) in commented.filter(|(_, line)| may_hold_one(line)) {
        let mut at = parse.line_start(number);
        for child in line.tree().children() {
            let NodeOrToken::Token(token) = child else {
                at += match child {
                    NodeOrToken::Node(node) => node.text_len(),
                    NodeOrToken::Token(token) => token.text_len(),
                };
                continue;
            };
            let text = token.text();
            if text.starts_with('#') && is_rung(text.trim_matches('#')) {
                out.push(found(TextRange::at(at, TextSize::of(text))));
            }
            at += TextSize::of(text);
        }
    }
}

/// Cheap: most comments are none.
fn may_be_rung(text: &str) -> bool {
    text.contains("--") && text.contains('(')
}

/// The finding about a comment that is a rung.
fn found(range: TextRange) -> Diagnostic {
    Diagnostic::new(
        RULE,
        range,
        "this comment is a rung: nobody can tell whether it still belongs to the program",
    )
    .help("remove it (an old version is kept by version control), or switch it off with [ ]( SYS.OFF )")
}

/// Whether a comment's text is a rung with a block that exists.
fn is_rung(text: &str) -> bool {
    if !may_be_rung(text) || !text.trim_start().starts_with(['+', '|']) {
        return false;
    }
    let parsed = parse(text.trim_start());
    let mut known = false;
    for line in parsed.lines().iter().filter(|line| line.kind == LineKind::Rung) {
        if !line.errors.is_empty() {
            return false;
        }
        let tree = line.tree();
        let drawing = rung(&tree);
        let mut blocks = facts::blocks(&tree, 0, drawing.connectors(PartKind::Block));
        known |= drawing.has_left_rail()
            && blocks.any(|block| {
                !block.operands.is_empty() && lookup(block.shape, block.head.text()).next().is_some()
            });
    }
    known
}

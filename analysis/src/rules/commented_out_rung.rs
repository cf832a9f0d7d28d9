//! `commented-out-rung`: a comment that is a rung.

use crate::context::Context;
use crate::diagnostic::Diagnostic;
use crate::facts;
use crate::rule::Rule;
use ladder_instructions::lookup;
use ladder_syntax::wiring::{PartKind, rung};
use ladder_syntax::{LineKind, TextRange, TextSize, parse};

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    for (number, line) in context.parse.lines().iter().enumerate() {
        if !matches!(line.kind, LineKind::Comment | LineKind::Rail) {
            continue;
        }
        let mut at = TextSize::new(0);
        for token in line
            .green()
            .children()
            .filter_map(ladder_syntax::NodeOrToken::into_token)
        {
            let text = token.text();
            if text.starts_with('#') && is_rung(text.trim_matches('#')) {
                let range = TextRange::at(at + context.parse.line_start(number), TextSize::of(text));
                out.push(
                    Diagnostic::new(
                        Rule::CommentedOutRung,
                        range,
                        "this comment is a rung: nobody can tell whether it still belongs to the program",
                    )
                    .help("remove it (an old version is kept by version control), or switch it off with [ ]( SYS.OFF )"),
                );
            }
            at += TextSize::of(text);
        }
    }
}

/// Whether a comment's text is a rung with a block that exists.
fn is_rung(text: &str) -> bool {
    if !text.contains("--") || !text.contains('(') || !text.trim_start().starts_with(['+', '|']) {
        return false;
    }
    let parsed = parse(text.trim_start());
    let mut known = false;
    for line in parsed.lines().iter().filter(|line| line.kind == LineKind::Rung) {
        if !line.errors.is_empty() {
            return false;
        }
        let drawing = rung(line);
        let blocks = facts::blocks(line, 0, drawing.connectors(PartKind::Block));
        known |= drawing.has_left_rail()
            && blocks.iter().any(|block| {
                !block.operands.is_empty() && lookup(block.shape, block.head.text()).next().is_some()
            });
    }
    known
}

//! `commented-out-rung`: a comment that is a rung.

use crate::diagnostic::Diagnostic;
use crate::facts;
use crate::rule::Rule;
use ladder_instructions::lookup;
use ladder_syntax::wiring::{PartKind, rung};
use ladder_syntax::{LineKind, TextRange, parse};

/// The finding about a comment that is a rung.
pub(crate) fn found(range: TextRange) -> Diagnostic {
    Diagnostic::new(
        Rule::CommentedOutRung,
        range,
        "this comment is a rung: nobody can tell whether it still belongs to the program",
    )
    .help("remove it (an old version is kept by version control), or switch it off with [ ]( SYS.OFF )")
}

/// Whether a comment's text is a rung with a block that exists.
pub(crate) fn is_rung(text: &str) -> bool {
    if !text.contains("--") || !text.contains('(') || !text.trim_start().starts_with(['+', '|']) {
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

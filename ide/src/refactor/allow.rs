//! A finding that is meant so: a comment switches its rule off, for the next network or the whole file (LANGUAGE §7).

use super::{Action, ActionKind};
use ladder_analysis::Finding;
use ladder_analysis::context::Context;
use ladder_analysis::names::declaring::line_end;
use ladder_format::Edit;
use ladder_syntax::{LineKind, TextRange, TextSize};

/// The comments that hide a finding, with a reason to be filled in.
pub(super) fn offer(context: &Context, found: &Finding, mut give: impl FnMut(Action)) {
    if !found.rule.may_be_allowed() {
        return;
    }
    let name = found.rule.name();
    let comment = |word: &str| format!("# ladder: {word}({name}): reason #{}", line_end(&context.parse));
    let insert = |title: String, at: TextSize, text: String| {
        let range = TextRange::empty(at);
        Action::new(ActionKind::QuickFix, title, vec![Edit { range, text }])
    };
    if let Some(at) = above(context, found.range.start()) {
        give(insert(
            format!("Allow `{name}` here, with a reason"),
            at,
            comment("allow"),
        ));
    }
    give(insert(
        format!("Allow `{name}` in this file, with a reason"),
        start(context, 0),
        comment("allow-file"),
    ));
}

/// Where a comment covers what is at a place: above its network, its section, or the first line of its block.
fn above(context: &Context, at: TextSize) -> Option<TextSize> {
    let parse = &context.parse;
    let line = parse.line_at(at)?;
    let frame = parse.frame();
    let section = frame
        .sections
        .iter()
        .find(|section| section.lines.contains(&line));
    let is_header = frame.blocks.iter().any(|block| block.lines.start == line);
    let first = match (context.networks.on_line(line), section) {
        (Some(network), _) => network.first_line,
        (None, Some(section)) => section.lines.start,
        (None, None) if is_header || parse.lines()[line].kind == LineKind::Stray => line,
        (None, None) => return None,
    };
    Some(start(context, first))
}

/// Where a line starts, after a byte order mark.
fn start(context: &Context, line: usize) -> TextSize {
    const MARK: char = '\u{feff}';
    let lines = context.parse.lines();
    let is_marked = line == 0 && lines.get(0).is_some_and(|line| line.text().starts_with(MARK));
    let mark = if is_marked {
        TextSize::of(MARK)
    } else {
        TextSize::new(0)
    };
    context.parse.line_start(line) + mark
}

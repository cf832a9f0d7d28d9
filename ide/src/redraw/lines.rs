//! Networks with the lines around them: where one begins with its comments, where a new one goes, what goes with one that goes.

use ladder_analysis::context::Context;
use ladder_analysis::names::declaring::line_end;
use ladder_analysis::networks::NetworkAt;
use ladder_syntax::{LineKind, TextRange, TextSize};
use std::ops::Range;

/// The logical line of a place; behind the last line end the last line.
pub(super) fn line_at(context: &Context, place: TextSize) -> Option<usize> {
    let parse = &context.parse;
    let before = || parse.line_at(place.checked_sub(TextSize::new(1))?);
    parse.line_at(place).or_else(before)
}

/// The network of a line, or of a comment that touches one below it.
pub(super) fn network_on(context: &Context, line: usize) -> Option<NetworkAt<'_>> {
    let is_comment = |line: &usize| context.parse.lines()[*line].kind == LineKind::Comment;
    let line = (line..context.parse.lines().len()).find(|line| !is_comment(line))?;
    context.networks.on_line(line)
}

/// The network in whose lines a place is, or in a comment that touches it.
///
/// # Errors
/// That there is none.
pub(super) fn network_at(context: &Context, place: TextSize) -> Result<NetworkAt<'_>, String> {
    let found = line_at(context, place).and_then(|line| network_on(context, line));
    found.ok_or_else(|| "there is no network there".to_owned())
}

/// The lines of a network with the comments and directives that touch it.
pub(super) fn with_heading(context: &Context, network: NetworkAt<'_>) -> Range<usize> {
    let lines = network.lines();
    let is_comment = |line: &usize| context.parse.lines()[*line].kind == LineKind::Comment;
    let first = (0..lines.start).rev().take_while(is_comment).last();
    first.unwrap_or(lines.start)..lines.end
}

/// Where some lines are, line ends included; without a byte order mark before them.
pub(super) fn range_of(context: &Context, lines: Range<usize>) -> TextRange {
    let parse = &context.parse;
    let end = if parse.lines().len() <= lines.end {
        parse.text_len()
    } else {
        parse.line_start(lines.end)
    };
    let range = TextRange::new(parse.line_start(lines.start), end);
    let mark = TextSize::of('\u{feff}');
    let has_mark = range.start() == TextSize::new(0) && parse.text_in(range).starts_with('\u{feff}');
    if has_mark {
        TextRange::new(mark, range.end())
    } else {
        range
    }
}

fn is_blank(context: &Context, line: usize) -> bool {
    let lines = context.parse.lines();
    line < lines.len() && lines[line].text().trim().is_empty()
}

/// What to take out of the text to be rid of some lines, with one of the blank lines around them.
pub(super) fn gone(context: &Context, lines: Range<usize>) -> TextRange {
    let all = context.parse.lines().len();
    let is_apart = lines.start == 0 || is_blank(context, lines.start - 1);
    let with = if is_apart && is_blank(context, lines.end) {
        lines.start..lines.end + 1
    } else if lines.start > 0 && is_blank(context, lines.start - 1) && lines.end >= all {
        lines.start - 1..lines.end
    } else {
        lines
    };
    range_of(context, with)
}

/// Where networks are put in: the place, what is written before them, and what behind.
pub(super) struct Place {
    pub(super) at: TextSize,
    pub(super) before: String,
    pub(super) behind: String,
    /// The scope that they are in there.
    pub(super) scope: usize,
}

/// The place before the first of some lines.
pub(super) fn above(context: &Context, line: usize, scope: usize) -> Place {
    let line_end = line_end(&context.parse);
    let touches = line > 0 && !is_blank(context, line - 1) && !is_header(context, line - 1);
    Place {
        at: range_of(context, line..line)
            .start()
            .max(range_of(context, line..line + 1).start()),
        before: if touches {
            line_end.to_owned()
        } else {
            String::new()
        },
        behind: line_end.repeat(2),
        scope,
    }
}

/// The place behind the line before one.
pub(super) fn below(context: &Context, line: usize, scope: usize) -> Place {
    let parse = &context.parse;
    let line_end = line_end(parse);
    let end = range_of(context, line.saturating_sub(1)..line).end();
    let is_ended = line == 0 || parse.lines()[line - 1].text().ends_with(['\n', '\r']);
    let is_first = line == 0 || is_header(context, line - 1) || is_blank(context, line - 1);
    let is_last = line >= parse.lines().len();
    let ends = usize::from(!is_ended) + usize::from(!is_first);
    let behind = match (
        is_last,
        is_blank(context, line) || (!is_last && is_end(context, line)),
    ) {
        (true, _) if !is_ended => 0,
        (true, _) | (false, true) => 1,
        (false, false) => 2,
    };
    Place {
        at: if line == 0 { TextSize::new(0) } else { end },
        before: line_end.repeat(ends),
        behind: line_end.repeat(behind),
        scope,
    }
}

/// Whether a line begins a block definition.
fn is_header(context: &Context, line: usize) -> bool {
    context.parse.lines()[line].kind == LineKind::BlockHeader
}

/// Whether a line ends a block definition.
fn is_end(context: &Context, line: usize) -> bool {
    context.parse.lines()[line].kind == LineKind::BlockEnd
}

/// The place for networks near a line that is in none: below it, and never within declarations.
pub(super) fn near(context: &Context, line: usize) -> Place {
    let frame = context.parse.frame();
    let section = frame
        .sections
        .iter()
        .find(|section| section.lines.contains(&line));
    let line = section.map_or(line + 1, |section| section.lines.end);
    below(context, line, scope_of(context, line - 1))
}

/// The scope that a line is in.
pub(super) fn scope_of(context: &Context, line: usize) -> usize {
    let mut blocks = context.parse.frame().blocks.iter();
    let found = blocks.position(|block| block.lines.contains(&line) && !is_end(context, line));
    found.map_or(0, |block| block + 1)
}

/// The place behind everything of the file.
pub(super) fn at_end(context: &Context) -> Place {
    below(context, context.parse.lines().len(), 0)
}

/// The blank lines that are all there is of a file.
pub(super) fn all_blank(context: &Context) -> Option<TextRange> {
    let lines = context.parse.lines().len();
    (lines > 0 && (0..lines).all(|line| is_blank(context, line))).then(|| range_of(context, 0..lines))
}

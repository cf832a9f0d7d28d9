//! How far a body reaches: the main program, a function, the definition of a block.

use ladder_analysis::context::{Body, Context};
use ladder_syntax::{NodeOrToken, Parse, SyntaxKind, TextRange};

/// From the first network of a body to the last, without the last line end; of a block's definition all of it.
pub(crate) fn extent(context: &Context, body: Body) -> Option<TextRange> {
    let parse = &context.parse;
    if let Body::Block(block) = body {
        let lines = &parse.structure().blocks.get(block)?.lines;
        let range = TextRange::new(
            parse.line_start(lines.start),
            parse.line_range(lines.end - 1).end(),
        );
        return Some(without_line_end(context, range));
    }
    networks(context, body)
}

/// From the first network of a body to the last, without the last line end.
pub(crate) fn networks(context: &Context, body: Body) -> Option<TextRange> {
    let of = |&network: &usize| context.bodies[network] == body;
    let first = (0..context.networks.len()).find(of)?;
    let last = (0..context.networks.len()).rev().find(of)?;
    let range = context
        .networks
        .at(first)
        .range
        .cover(context.networks.at(last).range);
    Some(without_line_end(context, range))
}

/// A range of whole lines without the line end of the last, and without what is blank before that.
pub(crate) fn without_line_end(context: &Context, range: TextRange) -> TextRange {
    let parse = &context.parse;
    let Some(last) = range
        .end()
        .checked_sub(1.into())
        .and_then(|end| parse.line_at(end))
    else {
        return range;
    };
    let text = line_text(parse, last);
    let blank = text.len() - text.trim_end_matches([' ', '\t', '\r', '\n']).len();
    let end = parse.line_range(last).end() - ladder_syntax::TextSize::new(blank as u32);
    TextRange::new(range.start(), end.max(range.start()))
}

/// The text of a line.
pub(crate) fn line_text(parse: &Parse, line: usize) -> String {
    parse.lines()[line].text().to_owned()
}

/// The text of the file.
pub(crate) fn file_text(parse: &Parse) -> String {
    parse.to_string()
}

/// A line without blanks, comments and line end around it.
pub(crate) fn line_body(parse: &Parse, line: usize) -> TextRange {
    let mut at = parse.line_start(line);
    let mut range = TextRange::empty(at);
    // Through the green node, without a cursor: this is asked of every network and declaration.
    for child in parse.lines()[line].tree().children() {
        let (kind, len) = match child {
            NodeOrToken::Node(node) => (SyntaxKind::from_raw(node.kind()), node.text_len()),
            NodeOrToken::Token(token) => (SyntaxKind::from_raw(token.kind()), token.text_len()),
        };
        let child = TextRange::at(at, len);
        at += len;
        if !kind.is_trivia() && !matches!(kind, SyntaxKind::NEWLINE | SyntaxKind::BOM) {
            range = if range.is_empty() {
                child
            } else {
                range.cover(child)
            };
        }
    }
    range
}

//! How far a body reaches: the main program, a function, the definition of a block.

use ladder_analysis::context::{Body, Context};
use ladder_syntax::{Line, LineKind, NodeOrToken, Parse, SyntaxKind, TextRange, TextSize};

/// From the first network of a body to the last, without the last line end; of a block's definition all of it.
pub(crate) fn extent(context: &Context, body: Body) -> Option<TextRange> {
    let parse = &context.parse;
    if let Body::Block(block) = body {
        let lines = &parse.frame().blocks.get(block)?.lines;
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
    let end = parse.line_range(last).end() - TextSize::new(blank as u32);
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
    let found = &parse.lines()[line];
    // This is asked of every network and declaration.
    body_between_blanks(found).unwrap_or_else(|| body_of_tree(found)) + parse.line_start(line)
}

/// The body of a line that has nothing but blanks around it, as nearly all have.
fn body_between_blanks(line: &Line) -> Option<TextRange> {
    let text = line.text();
    let body = text.trim_start_matches('\u{feff}');
    let body = body.trim_matches([' ', '\t', '\r', '\n']);
    // `T#5s` holds no comment.
    let mut marks = memchr::memchr_iter(b'#', body.as_bytes());
    let in_literals = marks.all(|at| at > 0 && body.as_bytes()[at - 1].is_ascii_alphanumeric());
    let is_whole = matches!(line.kind, LineKind::Rung | LineKind::Declaration) && line.errors.is_empty();
    if !is_whole || !in_literals || body.ends_with('#') {
        return None;
    }
    let before = body.as_ptr().addr() - text.as_ptr().addr();
    Some(TextRange::at(TextSize::new(before as u32), TextSize::of(body)))
}

fn body_of_tree(line: &Line) -> TextRange {
    let mut at = TextSize::new(0);
    let mut range = TextRange::empty(at);
    for child in line.tree().children() {
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

#[cfg(test)]
mod tests {
    use super::*;
    use ladder_syntax::parse;

    #[test]
    fn blanks_bound_a_body_as_the_tree_does() {
        let text = "\u{feff}  +--[ ]( a )--( )( b )--+  \n\
                    +--[TON]( t, T#5s )--( )( c )--+\r\n\
                    \t+--[ ]( a# near # )--[=]( 16#F, x )--( )( d )--+\n\
                    # one # +--( )( e )--+ # two #\n\
                    +--( )( f )--+# three #\n\
                    VAR # four #\n  g : TIME := T#1s; h, # five # i : INT;\nEND_VAR# six #\n";
        let parse = parse(text);
        let mut by_blanks = 0;
        for line in parse.lines() {
            if let Some(body) = body_between_blanks(line) {
                by_blanks += 1;
                assert_eq!(body, body_of_tree(line), "{:?}", line.text());
            }
        }
        assert_eq!(by_blanks, 3);
    }
}

//! The comments that belong to what is below them.

use ladder_analysis::context::Context;
use ladder_analysis::names::scope::TagFacts;
use ladder_syntax::rowan::GreenNodeData;
use ladder_syntax::{LineKind, NodeOrToken, Parse, SyntaxKind, TextRange, TextSize};

/// The comments of a logical line with their texts, `#` included.
pub(crate) fn of_line(parse: &Parse, line: usize) -> Vec<(TextRange, String)> {
    let mut comments = Vec::new();
    let found = &parse.lines()[line];
    // Straight through the green node, where there is a comment: this is asked of every line.
    if found.text().contains('#') {
        gather(&found.tree(), parse.line_start(line), &mut comments);
    }
    comments
}

fn gather(node: &GreenNodeData, start: TextSize, comments: &mut Vec<(TextRange, String)>) {
    let mut at = start;
    for child in node.children() {
        match child {
            NodeOrToken::Node(node) => {
                gather(node, at, comments);
                at += node.text_len();
            }
            NodeOrToken::Token(token) => {
                if SyntaxKind::from_raw(token.kind()) == SyntaxKind::COMMENT {
                    comments.push((TextRange::at(at, token.text_len()), token.text().to_owned()));
                }
                at += token.text_len();
            }
        }
    }
}

/// What a comment says: its first line with words, without the `#` and without lines drawn around it. None if it
/// is only for the tools.
pub(crate) fn words(comment: &str) -> Option<&str> {
    let inner = comment.strip_prefix('#').unwrap_or(comment);
    let inner = inner.strip_suffix('#').unwrap_or(inner);
    let decoration = |c: char| c.is_whitespace() || matches!(c, '*' | '=' | '-' | '_' | '|' | '~');
    let mut lines = inner.lines().map(|line| line.trim_matches(decoration));
    let first = lines.find(|line| !line.is_empty())?;
    (!first.starts_with("ladder:")).then_some(first)
}

/// All that a comment says, the lines of a paragraph as one; a blank line parts paragraphs. None as for [`words`].
pub(crate) fn whole(comment: &str) -> Option<String> {
    words(comment)?;
    let inner = comment.trim_matches('#');
    let mut paragraphs = vec![String::new()];
    for line in inner.lines().map(str::trim) {
        let last = paragraphs.len() - 1;
        match (line.is_empty(), paragraphs[last].is_empty()) {
            (true, true) => {}
            (true, false) => paragraphs.push(String::new()),
            (false, true) => paragraphs[last].push_str(line),
            (false, false) => {
                paragraphs[last].push(' ');
                paragraphs[last].push_str(line);
            }
        }
    }
    Some(paragraphs.join("\n\n").trim_end().to_owned())
}

/// What the comment on the line of a tag's declaration says.
pub(crate) fn of_declaration(context: &Context, tag: &TagFacts) -> Option<String> {
    if !tag.is_declared() {
        return None;
    }
    let parse = &context.parse;
    let found = of_line(parse, parse.line_at(context.place_of(tag).start())?);
    first_words(&found)
}

/// The run of comment lines that ends right above a line: the first and the last of them.
pub(crate) fn above(context: &Context, line: usize) -> Option<(usize, usize)> {
    let parse = &context.parse;
    let is_comment = |&line: &usize| match parse.lines()[line].kind {
        LineKind::Comment => true,
        LineKind::Rail => !of_line(parse, line).is_empty(),
        _ => false,
    };
    let first = (0..line).rev().take_while(is_comment).last()?;
    Some((first, line - 1))
}

/// What the comments right above a line say, or those that begin it.
pub(crate) fn title(context: &Context, line: usize) -> Option<String> {
    let parse = &context.parse;
    let mut lines = above(context, line).map_or(line..line, |(first, last)| first..last + 1);
    let told = lines.find_map(|line| first_words(&of_line(parse, line)));
    told.or_else(|| {
        let text = parse.lines()[line].text();
        let drawn = text.trim_start_matches('\u{feff}').trim_start();
        // Comments further on are about what is next to them.
        let mut begin = drawn.starts_with('#').then(|| of_line(parse, line))?;
        begin.truncate(1);
        first_words(&begin)
    })
}

fn first_words(comments: &[(TextRange, String)]) -> Option<String> {
    let mut told = comments.iter().filter_map(|(_, text)| words(text));
    told.next().map(str::to_owned)
}

#[cfg(test)]
mod tests {
    use super::words;

    #[test]
    fn what_a_comment_says() {
        for (comment, told) in [
            ("# start #", Some("start")),
            ("# ====\n  = Motor 1 =\n ==== #", Some("Motor 1")),
            ("# ladder: allow(double-coil) #", None),
            ("#  #", None),
            ("##", None),
            ("# open", Some("open")),
        ] {
            assert_eq!(words(comment), told, "{comment}");
        }
    }
}

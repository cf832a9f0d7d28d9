//! What the comments of a ladder text say, for those who write other notations.

use ladder_syntax::{NodeOrToken, Parse, SyntaxKind};

/// The comments on a line of a text, each without its signs.
pub fn on_line(parse: &Parse, line: usize) -> Vec<String> {
    let tokens = parse.lines()[line].syntax().descendants_with_tokens();
    tokens
        .filter_map(NodeOrToken::into_token)
        .filter(|token| token.kind() == SyntaxKind::COMMENT)
        .map(|token| inside(token.text()).to_owned())
        .collect()
}

/// The lines of a comment that are for people: directives to the tools are not for another system.
pub fn told(comment: &str) -> impl Iterator<Item = &str> {
    let lines = inside(comment).lines().map(str::trim);
    lines.filter(|line| !line.is_empty() && !line.starts_with("ladder:"))
}

/// A comment without its signs.
pub fn inside(comment: &str) -> &str {
    let after = comment.strip_prefix('#').unwrap_or(comment);
    after.strip_suffix('#').unwrap_or(after)
}

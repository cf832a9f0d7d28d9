//! The tree as indented text, for people who work on the language.

use crate::kind::SyntaxToken;
use crate::parse::Parse;
use rowan::NodeOrToken;
use rowan::WalkEvent;
use std::fmt::Write as _;

/// The tree of a parse: one line for each node and token with its kind, its range and, for tokens, its text
/// with control characters escaped; after the tree the errors.
pub fn dump(parse: &Parse) -> String {
    let mut out = String::new();
    let mut depth = 0usize;
    for event in parse.syntax().preorder_with_tokens() {
        match event {
            WalkEvent::Enter(NodeOrToken::Node(node)) => {
                line(
                    &mut out,
                    depth,
                    &format_args!("{:?}@{:?}", node.kind(), node.text_range()),
                );
                depth += 1;
            }
            WalkEvent::Leave(NodeOrToken::Node(_)) => depth -= 1,
            WalkEvent::Enter(NodeOrToken::Token(token)) => token_line(&mut out, depth, &token),
            _ => {}
        }
    }
    for error in parse.errors() {
        line(
            &mut out,
            0,
            &format_args!("error {:?}: {:?}", error.range, error.kind),
        );
    }
    out
}

fn token_line(out: &mut String, depth: usize, token: &SyntaxToken) {
    let (kind, range, text) = (token.kind(), token.text_range(), token.text());
    line(out, depth, &format_args!("{kind:?}@{range:?} {text:?}"));
}

fn line(out: &mut String, depth: usize, text: &std::fmt::Arguments<'_>) {
    // Writing to a string does not fail.
    let _ = writeln!(out, "{:width$}{text}", "", width = depth * 2);
}

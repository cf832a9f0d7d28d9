//! How snapshots are written down.

use expect_test::Expect;
use ladder_syntax::{NodeOrToken, Parse, SyntaxKind, SyntaxNode, parse};
use std::fmt::Write as _;

/// The indented tree with its errors.
#[track_caller]
pub(crate) fn check_tree(text: &str, expect: Expect) {
    expect.assert_eq(&ladder_syntax::dump(&parse(text)));
}

/// The errors, each under the text that it marks, and the lines in brief.
#[track_caller]
pub(crate) fn check_errors(texts: &[&str], expect: Expect) {
    let mut out = String::new();
    for text in texts {
        let parse = parse(text);
        assert_eq!(parse.to_string(), *text);
        for (index, line) in parse.lines().iter().enumerate() {
            let _ = writeln!(out, "{}", brief(&line.syntax()));
            let range = parse.line_range(index);
            for error in parse.errors() {
                if range.contains(error.range.start())
                    || index + 1 == parse.lines().len() && error.range.start() >= range.end()
                {
                    let start = std::ops::Range::<usize>::from(error.range).start;
                    let _ = writeln!(
                        out,
                        "    {:?} {:?} {}",
                        &text[error.range],
                        error.range,
                        format!("{:?}", error.kind).replace("{ ", "{").replace(" }", "}")
                    );
                    assert!(text.is_char_boundary(start));
                }
            }
        }
        out.push('\n');
    }
    expect.assert_eq(&out);
}

/// The children of a line, each between `‹›`; blocks with their parts, operands with their kinds. `!` marks
/// tokens without meaning.
fn brief(line: &SyntaxNode) -> String {
    let mut out = format!("{:?}", line.kind());
    for child in line.children_with_tokens() {
        match child {
            NodeOrToken::Node(node) => {
                out.push(' ');
                brief_node(&mut out, &node);
            }
            NodeOrToken::Token(token) => match token.kind() {
                SyntaxKind::WHITESPACE => out.push_str(" ·"),
                SyntaxKind::ERROR => {
                    let _ = write!(out, " !{:?}", token.text());
                }
                _ => {
                    let _ = write!(
                        out,
                        " {}",
                        token.text().escape_debug().to_string().replace("\\\\", "\\")
                    );
                }
            },
        }
    }
    out
}

fn brief_node(out: &mut String, node: &SyntaxNode) {
    out.push('‹');
    if !node.kind().is_block() && !matches!(node.kind(), SyntaxKind::BLOCK_HEAD | SyntaxKind::OPERAND_LIST) {
        let _ = write!(out, "{:?}:", node.kind());
    }
    for child in node.children_with_tokens() {
        match child {
            NodeOrToken::Node(node) => brief_node(out, &node),
            NodeOrToken::Token(token) if token.kind() == SyntaxKind::ERROR => {
                let _ = write!(out, "!{:?}", token.text());
            }
            NodeOrToken::Token(token) => out.push_str(token.text()),
        }
    }
    out.push('›');
}

/// The tokens of a text, white space aside.
#[track_caller]
pub(crate) fn check_tokens(texts: &[&str], expect: Expect) {
    let mut out = String::new();
    for text in texts {
        let parse = parse(text);
        let _ = write!(out, "{text:?}:");
        for token in tokens(&parse) {
            let _ = write!(out, " {token}");
        }
        out.push('\n');
    }
    expect.assert_eq(&out);
}

fn tokens(parse: &Parse) -> Vec<String> {
    parse
        .syntax()
        .descendants_with_tokens()
        .filter_map(NodeOrToken::into_token)
        .filter(|token| token.kind() != SyntaxKind::WHITESPACE)
        .map(|token| format!("{:?} {:?}", token.kind(), token.text()))
        .collect()
}

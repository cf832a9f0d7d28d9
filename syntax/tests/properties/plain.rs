//! A builder that takes plain blocks as a whole, and a reader that goes part by part, see what the tree shows.

use crate::mutated::{mutate, mutation};
use crate::programs::PROGRAMS;
use ladder_syntax::{Builder, Line, LineReader, Lines, NodeOrToken, SyntaxKind, parse, read_lines};
use proptest::prelude::*;
use std::ops::Range;

/// What is directly on lines: kinds and places.
#[derive(Default)]
struct OnLines {
    open: u32,
    started: usize,
    children: Vec<(SyntaxKind, Range<usize>)>,
    at: usize,
    plain: usize,
}

impl Builder for OnLines {
    type Line = Vec<(SyntaxKind, Range<usize>)>;
    /// Where the next token begins, and how many children are there.
    type Checkpoint = (usize, usize);

    const TAKES_PLAIN_BLOCKS: bool = true;

    fn token(&mut self, kind: SyntaxKind, _: &str, place: Range<usize>) {
        self.at = place.end;
        if self.open == 0 {
            self.children.push((kind, place));
        }
    }

    fn plain_block(&mut self, kind: SyntaxKind, place: Range<usize>) {
        assert_eq!(self.open, 0);
        self.at = place.end;
        self.plain += 1;
        self.children.push((kind, place));
    }

    fn start_node(&mut self, kind: SyntaxKind) {
        if self.open == 0 {
            self.started = self.children.len();
            self.children.push((kind, self.at..self.at));
        }
        self.open += 1;
    }

    fn checkpoint(&self) -> (usize, usize) {
        (self.at, self.children.len())
    }

    fn start_node_at(&mut self, (at, children): (usize, usize), kind: SyntaxKind) {
        if self.open == 0 {
            self.children.truncate(children);
            self.started = children;
            self.children.push((kind, at..at));
        }
        self.open += 1;
    }

    fn finish_node(&mut self) {
        self.open -= 1;
        if self.open == 0 {
            self.children[self.started].1.end = self.at;
        }
    }

    fn finish_line(&mut self, _: SyntaxKind) -> Self::Line {
        std::mem::take(&mut self.children)
    }
}

/// Whether its tree holds a comment.
fn has_comment(line: &Line) -> bool {
    let mut all = line.syntax().descendants_with_tokens();
    all.any(|element| element.kind() == SyntaxKind::COMMENT)
}

/// Checks a text; how many plain blocks it holds.
fn check(text: &str) -> usize {
    let tree = parse(text);
    let mut builder = OnLines::default();
    let whole = read_lines(text, &mut builder);
    assert_eq!(whole.structure(), tree.structure(), "{text}");
    assert_eq!(whole.unclosed_comment(), tree.unclosed_comment(), "{text}");
    assert_eq!(whole.lines().len(), tree.lines().len(), "{text}");
    for (n, (line, expected)) in whole.lines().iter().zip(tree.lines()).enumerate() {
        let seen = (
            line.kind,
            line.mode_after,
            line.downs,
            line.ups,
            line.len,
            line.is_commented(),
            &line.errors,
        );
        let right = (
            expected.kind,
            expected.mode_after,
            expected.downs,
            expected.ups,
            expected.len,
            has_comment(expected),
            &expected.errors,
        );
        assert_eq!(seen, right, "{text}");
        let start = tree.line_start(n);
        let children: Vec<_> = expected
            .syntax()
            .children_with_tokens()
            .map(|child| match child {
                NodeOrToken::Node(node) => (node.kind(), Range::<usize>::from(node.text_range() + start)),
                NodeOrToken::Token(token) => (token.kind(), Range::<usize>::from(token.text_range() + start)),
            })
            .collect();
        assert_eq!(line.node(), &children, "{text}");
    }
    parts(text, &whole);
    builder.plain
}

/// The networks, sections and blocks of the parts are those of the whole.
fn parts<N>(text: &str, whole: &Lines<N>) {
    let mut reader = LineReader::new(text);
    let mut part = Lines::default();
    let mut items = Vec::new();
    let mut lines = 0;
    while reader.at() < text.len() {
        let start = reader.at();
        reader.read(1, &mut OnLines::default(), &mut part);
        assert_eq!(usize::from(part.line_start(0)), start);
        lines += part.lines().len();
        let structure = part.structure();
        for network in &structure.networks {
            items.push((
                "network",
                part.line_start(network.lines.start),
                network.block.is_some(),
            ));
        }
        for section in &structure.sections {
            items.push((
                "section",
                part.line_start(section.lines.start),
                section.block.is_some(),
            ));
        }
    }
    let structure = whole.structure();
    let mut expected = Vec::new();
    for network in &structure.networks {
        expected.push((
            "network",
            whole.line_start(network.lines.start),
            network.block.is_some(),
        ));
    }
    for section in &structure.sections {
        expected.push((
            "section",
            whole.line_start(section.lines.start),
            section.block.is_some(),
        ));
    }
    items.sort_unstable();
    expected.sort_unstable();
    assert_eq!(lines, whole.lines().len(), "{text}");
    assert_eq!(items, expected, "{text}");
}

#[test]
fn programs() {
    let plain: Vec<usize> = PROGRAMS.iter().map(|program| check(program)).collect();
    assert_eq!(plain, [1, 7, 2, 4, 9, 3, 4]);
}

/// Blocks of words that are nearly plain.
fn nearly_plain() -> impl Strategy<Value = String> {
    let word = prop::sample::select(vec![
        "a",
        "b_1",
        "EN",
        "eno",
        "t1.Q",
        "t.EN",
        "w.3",
        "5",
        "5s",
        "1.5",
        "1.",
        ".5",
        "1.5.2",
        "-5",
        "- 5",
        "-a",
        "--5",
        "T#5s",
        "T#1.5s",
        "T#-5s",
        "_#5",
        "a_#5",
        "16#FF",
        "INT#16#FF",
        "D#2026-11-21",
        "1e-3",
        "1E5",
        "é",
        "aé",
        "NOT",
        "TRUE",
        "true",
        "SYS.SCAN",
        "PI",
        "a.b.c",
        "a.NOT",
        "'s'",
        "%IX0.1",
        "a[3]",
        "f(",
        "#c#",
        ":=",
        "a b",
        "",
    ]);
    let blank = prop::sample::select(vec!["", "", " ", "\t", "  "]);
    let head = prop::sample::select(vec![
        "[ ]", "[]", "( )", "()", "[/]", "(S)", "[ TON ]", "[ton]", "[SEARCH]", "[$B]", "<JMP>", "<>", "[é]",
        "[T#]", "(T#5s)", "(a#", "[ ] ", "[A B]", "[A)", "(S", "[_X1]",
    ]);
    let operands = prop::collection::vec((blank.clone(), word, blank), 0..4);
    prop::collection::vec((head, operands, any::<bool>()), 1..4).prop_map(|blocks| {
        let mut text = String::from("+--");
        for (head, operands, list) in blocks {
            text.push_str(head);
            if list {
                let operands: Vec<String> = operands.iter().map(|(a, b, c)| format!("{a}{b}{c}")).collect();
                text.push_str(&format!("({})", operands.join(",")));
            }
            text.push_str("--");
        }
        text.push_str("+\n");
        text
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, ..ProptestConfig::default() })]

    #[test]
    fn nearly_plain_blocks(text in nearly_plain()) {
        check(&text);
    }

    #[test]
    fn mutated_programs(program in 0..PROGRAMS.len(), mutations in prop::collection::vec(mutation(), 1..4)) {
        let mut text = PROGRAMS[program].to_owned();
        for mutation in &mutations {
            mutate(&mut text, mutation);
        }
        check(&text);
    }
}

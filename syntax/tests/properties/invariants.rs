//! What must hold for the parse of any text.

use ladder_syntax::{NodeOrToken, Parse, SyntaxNode, Trees, dump, parse, rowan, wiring};
use std::ops::Range;

/// Parses a text and checks everything that must hold: the tree gives the text back, lines and errors lie where
/// they say, nesting is bounded, and the wiring of every network is sound.
pub(crate) fn check(text: &str) -> Parse {
    let parse = parse(text);
    assert_eq!(parse.to_string(), text);
    assert_eq!(parse.syntax().to_string(), text);
    lines(text, &parse);
    for error in parse.errors() {
        let range = Range::<usize>::from(error.range);
        assert!(
            text.get(range).is_some(),
            "{error:?} cuts a character in {text:?}"
        );
    }
    assert!(depth(&parse.syntax()) < 2000);
    networks(text, &parse);
    parse
}

/// Checks an edited parse against one from scratch.
pub(crate) fn check_same(edited: &Parse, text: &str) {
    let fresh = check(text);
    assert_eq!(edited.to_string(), text);
    lines(text, edited);
    assert_eq!(dump(edited), dump(&fresh), "{text:?}");
    assert_eq!(edited.structure(), fresh.structure(), "{text:?}");
    let structure = edited.structure();
    assert_eq!(edited.frame().sections, structure.sections, "{text:?}");
    assert_eq!(edited.frame().blocks, structure.blocks, "{text:?}");
    let first = structure.networks.first().map(|first| first.lines.start);
    assert_eq!(edited.lines().first_network(), first, "{text:?}");
    assert_eq!(edited.conflicts(), fresh.conflicts(), "{text:?}");
    assert_eq!(edited.unclosed_comment(), fresh.unclosed_comment(), "{text:?}");
    assert_eq!(edited.lines().len(), fresh.lines().len(), "{text:?}");
    for (index, (a, b)) in edited.lines().iter().zip(fresh.lines()).enumerate() {
        assert_eq!(edited.line_range(index), fresh.line_range(index), "{text:?}");
        assert_eq!(a.errors, b.errors, "{text:?}");
        assert_eq!(
            (a.kind, a.mode_after, a.downs, a.ups, a.len, a.is_in_conflict()),
            (b.kind, b.mode_after, b.downs, b.ups, b.len, b.is_in_conflict())
        );
    }
}

fn lines(text: &str, parse: &Parse) {
    let mut at = 0;
    // A line by itself has the tree that it has in the whole text.
    let whole = parse.green().children();
    let (mut trees, mut whole) = (Trees::default(), whole.filter_map(NodeOrToken::into_node));
    for (index, line) in parse.lines().iter().enumerate() {
        assert_eq!(whole.next(), Some(&*trees.of(line)), "line {index} of {text:?}");
        assert_eq!(line.text(), &text[at as usize..(at + line.len) as usize]);
        assert!(line.len > 0, "line {index} is empty in {text:?}");
        assert_eq!(u32::from(parse.line_start(index)), at);
        assert_eq!(line.syntax().kind(), line.kind.syntax_kind());
        for error in &line.errors {
            assert!(
                u32::from(error.range.end()) <= line.len,
                "{error:?} leaves its line in {text:?}"
            );
        }
        at += line.len;
    }
    assert_eq!(at as usize, text.len());
}

fn networks(text: &str, parse: &Parse) {
    let mut end = 0;
    for network in &parse.structure().networks {
        assert!(network.lines.start >= end, "networks overlap in {text:?}");
        end = network.lines.end;
        let wiring = wiring::wiring(parse, network);
        let lines = || {
            wiring
                .line_offsets
                .iter()
                .map(|offset| network.lines.start + offset)
        };
        for (line, rung) in lines().zip(&wiring.rungs) {
            let len = parse.lines()[line].len;
            let mut end = 0;
            for part in &rung.parts {
                assert!(u32::from(part.range.start()) >= end, "parts overlap in {text:?}");
                end = part.range.end().into();
            }
            assert!(end <= len);
        }
        let connectors: usize = lines()
            .map(|line| (parse.lines()[line].downs + parse.lines()[line].ups) as usize)
            .sum();
        assert_eq!(
            wiring.points.len() * 2 + wiring.unpaired.len(),
            connectors,
            "{text:?}"
        );
    }
}

fn depth(root: &SyntaxNode) -> usize {
    let mut deepest = 0;
    let mut depth = 0;
    for event in root.preorder() {
        match event {
            rowan::WalkEvent::Enter(_) => depth += 1,
            rowan::WalkEvent::Leave(_) => depth -= 1,
        }
        deepest = deepest.max(depth);
    }
    deepest
}

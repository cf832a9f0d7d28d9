//! Networks drawn one by one for a page that shows a running program. `UPDATE_EXPECT=1 cargo test -p ladder-picture`
//! draws them again; look at them before you keep them.

use expect_test::expect_file;
use ladder_analysis::analyze;
use ladder_picture::live::{Kind, Piece, pieces};
use ladder_syntax::{LineIndex, TextRange, TextSize, parse};
use std::sync::Arc;

/// What is in a stretch of a text: kind, first line from 0, and drawing.
fn drawn_in(text: &str, stretch: TextRange, rail: u32) -> Vec<(Kind, usize, String)> {
    let analysis = analyze(&Arc::new(parse(text)), "program");
    let index = LineIndex::new(text);
    let line = |offset: TextSize| index.line(offset);
    let drawn = |piece: &Piece| {
        let first = line(piece.range.start());
        let place = |offset: TextSize| {
            let line = line(offset);
            let column = u32::from(offset - index.range(line).start());
            format!("{}:{column}", line - first)
        };
        let svg = piece.svg(&analysis.context, &[], &place);
        (piece.kind(&analysis.context), first, svg)
    };
    let found = pieces(&analysis.context, stretch, rail);
    found.iter().map(drawn).collect()
}

fn drawn(text: &str) -> Vec<(Kind, usize, String)> {
    drawn_in(text, TextRange::up_to(TextSize::of(text)), 60)
}

fn lines(text: &str, first: usize, last: usize) -> TextRange {
    let index = LineIndex::new(text);
    index.range(first).cover(index.range(last))
}

const PROGRAM: &str = "\
VAR  level : REAL;  warmup : TON;  END_VAR

# Begins here, #
# and goes on. #
+--\\--[ ]( start )--\\--[/]( stop )--( )( run )--+
|  /--[ ]( run )----/                           |

+--[GT]( level, 4.5 )--[TON]( warmup, T#5s )--(S)( ready )--+
+--[MOV]( level, 1.5 )--<CALL>( pumps )--+
+--[ ( broken )--+
";

#[test]
fn everything_knows_its_place() {
    let pieces = drawn(PROGRAM);
    let text: Vec<String> = pieces
        .iter()
        .map(|(kind, line, svg)| format!("{kind:?}, line {line}\n{svg}\n"))
        .collect();
    expect_file!["pictures/live.txt"].assert_eq(&text.concat());
}

#[test]
fn only_what_is_asked_for_is_drawn() {
    let at = |first, last| -> Vec<usize> {
        let found = drawn_in(PROGRAM, lines(PROGRAM, first, last), 60);
        found.iter().map(|(_, line, _)| *line).collect()
    };
    assert_eq!(at(0, 1), [0; 0]);
    assert_eq!(at(3, 3), [2], "all of the comment");
    assert_eq!(at(5, 5), [4], "all of the network");
    assert_eq!(at(5, 7), [4, 7]);
    assert_eq!(at(0, 9), [2, 4, 7, 8, 9]);
}

#[test]
fn a_drawing_does_not_depend_on_what_is_above() {
    let below = format!("# something #\n\n+--( )( on )--+\n\n{PROGRAM}");
    let svgs = |text: &str| -> Vec<String> { drawn(text).into_iter().map(|(_, _, svg)| svg).collect() };
    assert_eq!(svgs(&below)[2..], svgs(PROGRAM)[..]);
}

#[test]
fn no_text_makes_a_broken_document() {
    for text in [
        "",
        "+",
        "|",
        "# only a comment #",
        "# <script>alert('1')</script> & #",
        "+--[ ]( a & <b> )--+",
        "+--\\--+",
        "/--\\\n\\--/",
        "+--[MOV]( s, '<&\u{1}>' )--+",
        "+--[$\"<]( a )--( )( b )--+",
        "[ ]( a )",
        "|--[ ]( a )--|",
        "FUNCTION_BLOCK\n+--+",
        "FUNCTION_BLOCK [$B]\n+--[ ]( a )--( )( ENO )--+\nEND_FUNCTION_BLOCK",
    ] {
        for (_, _, svg) in drawn(text) {
            let document = roxmltree::Document::parse(&svg);
            assert!(document.is_ok(), "{text:?}: {document:?}\n{svg}");
            let scripts = document.unwrap();
            assert!(scripts.descendants().all(|node| !node.has_tag_name("script")));
        }
    }
}

//! Parsing to a tree, next to the bare tree builder fed with the same nodes and tokens: what the lexer and the
//! grammar cost on top of building the tree.

use divan::{Bencher, counter::BytesCount};
use ladder_syntax::{NodeOrToken, SyntaxKind, TextRange, TextSize, parse, tree};
use rowan::{GreenNode, GreenNodeBuilder, NodeCache, WalkEvent};
use std::fmt::Write as _;
use std::ops::Range;

fn main() {
    divan::main();
}

const SMALL: usize = 10 << 10;
const LARGE: usize = 1 << 20;

/// The same few rungs again and again: nearly every token and small node is in the builder's cache.
fn regular(size: usize) -> String {
    let rungs = "\
# Start/stop with a seal-in contact #
+--\\--[ ]( start )--\\--[/]( stop )-------------( )( run )--+
|  |                |                                      |
|  /--[ ]( run )----/                                      |

+--[ ]( run )---------[TON]( warmup, T#5s )--( )( ready )--+
";
    rungs.repeat(size / rungs.len() + 1)
}

/// Names, numbers, instructions and drawings that differ from rung to rung, sections between.
fn varied(size: usize) -> String {
    let mut text = String::with_capacity(size + 1000);
    let mut n = 0u32;
    // A small linear congruential generator: the text is the same at every run.
    let mut state = 1u32;
    let mut next = move |below: u32| {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (state >> 16) % below
    };
    let _ = writeln!(text, "VAR_INPUT");
    for k in 0..40 {
        let _ = writeln!(
            text,
            "    start_{k}, stop_{k} AT %IX{}.{} : BOOL := FALSE;  # panel {k} #",
            k / 8,
            k % 8
        );
    }
    let _ = writeln!(text, "END_VAR\n");
    while text.len() < size {
        n += 1;
        let (a, b, c) = (next(3000), next(3000), next(3000));
        let dashes = "-".repeat(next(30) as usize + 2);
        let blanks = " ".repeat(next(20) as usize + 2);
        let _ = match next(6) {
            0 => writeln!(
                text,
                "# Station {n}: starts valve {a} #\n+--\\--[ ]( start_{a} ){dashes}\\--[/]( stop_{b} )--( )( run_{n} )--+\n\
                 |  |{blanks}|{blanks}|\n|  /--[ ]( run_{n} )--/{blanks}|\n"
            ),
            1 => writeln!(
                text,
                "+--[ ]( run_{a} ){dashes}[TON]( t_{n}, T#{b}ms, R := stop_{c} )--( )( ready_{n} )--+\n"
            ),
            2 => writeln!(
                text,
                "+--[GE]( level_{a}, {b} )--[CALC]( flow_{n}, (level_{a} * {b} + SQRT(f_{c})) / 2.5 )--(S)( y_{n} )--+\n"
            ),
            3 => writeln!(
                text,
                "+{dashes}[CTU]( c_{n}, {a} )--[MOV]( total_{b}, c_{n}.CV )--[MOV]( a[{c}], 16#{a:X} )--+\n"
            ),
            4 => writeln!(
                text,
                "+--\\--[ ]( in_{a} )--\\-----\\--[/]( in_{b} )--\\--( )( out_{n} )--+\n\
                 |  /--[ ]( in_{c} )--/     /--[ ]( in_{n} )--/{blanks}|\n"
            ),
            _ => writeln!(
                text,
                "+--[P]( key_{a} )--[NE]( word_{b}.3, x_{c} )--<JMP>( step_{n} )--+  # again {b} #\n"
            ),
        };
    }
    text
}

/// The calls of the builder, recorded.
enum Event {
    Start(SyntaxKind),
    Token(SyntaxKind, Range<usize>),
    Finish,
}

fn record(text: &str) -> Vec<Event> {
    parse(text)
        .syntax()
        .preorder_with_tokens()
        .filter_map(|event| match event {
            WalkEvent::Enter(NodeOrToken::Node(node)) => Some(Event::Start(node.kind())),
            WalkEvent::Enter(NodeOrToken::Token(token)) => {
                Some(Event::Token(token.kind(), token.text_range().into()))
            }
            WalkEvent::Leave(NodeOrToken::Node(_)) => Some(Event::Finish),
            WalkEvent::Leave(NodeOrToken::Token(_)) => None,
        })
        .collect()
}

fn replay(text: &str, events: &[Event]) -> GreenNode {
    let mut cache = NodeCache::default();
    let mut builder = GreenNodeBuilder::with_cache(&mut cache);
    for event in events {
        match event {
            Event::Start(kind) => builder.start_node((*kind).into()),
            Event::Token(kind, range) => builder.token((*kind).into(), &text[range.clone()]),
            Event::Finish => builder.finish_node(),
        }
    }
    builder.finish()
}

fn text(case: &str) -> String {
    match case {
        "regular 10 KB" => regular(SMALL),
        "regular 1 MB" => regular(LARGE),
        "varied 10 KB" => varied(SMALL),
        _ => varied(LARGE),
    }
}

const CASES: [&str; 4] = ["regular 10 KB", "varied 10 KB", "regular 1 MB", "varied 1 MB"];

#[divan::bench(args = CASES)]
fn parse_to_tree(bencher: Bencher, case: &str) {
    let text = text(case);
    assert!(parse(&text).errors().is_empty());
    bencher.counter(BytesCount::of_str(&text)).bench(|| tree(&text));
}

#[divan::bench(args = CASES)]
fn bare_builder(bencher: Bencher, case: &str) {
    let text = text(case);
    let events = record(&text);
    assert_eq!(replay(&text, &events).to_string(), text);
    bencher
        .counter(BytesCount::of_str(&text))
        .bench(|| replay(&text, &events));
}

/// A keystroke in the middle of the text: one dash more in a wire.
#[divan::bench(args = CASES)]
fn keystroke(bencher: Bencher, case: &str) {
    let mut text = text(case);
    let before = parse(&text);
    let middle = text.len() / 2;
    let at = middle + text[middle..].find("--").expect("a wire");
    text.insert(at, '-');
    let range = TextRange::empty(TextSize::new(at as u32));
    bencher.bench(|| before.edited(&text, range, TextSize::new(1)));
}

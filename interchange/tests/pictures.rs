//! Pictures of programs, compared to the byte. `UPDATE_EXPECT=1 cargo test -p ladder-interchange` draws them anew;
//! look at them before you keep them.

use expect_test::expect_file;
use ladder_analysis::analyze;
use ladder_interchange::picture::{Options, Theme, svg};
use ladder_syntax::{Parse, TextRange, TextSize, parse};
use std::collections::HashMap;
use std::sync::Arc;

fn drawn(text: &str, options: &Options<'_>) -> String {
    svg(&analyze(&Arc::new(parse(text)), "program").context, options)
}

fn in_colours(theme: Theme) -> Options<'static> {
    Options {
        theme,
        ..Options::default()
    }
}

#[test]
fn every_kind_of_symbol() {
    let picture = drawn(include_str!("pictures/symbols.clad"), &in_colours(Theme::Light));
    expect_file!["pictures/symbols.svg"].assert_eq(&picture);
}

#[test]
fn program_flow_and_blocks() {
    let picture = drawn(include_str!("pictures/flow.clad"), &in_colours(Theme::Auto));
    expect_file!["pictures/flow.svg"].assert_eq(&picture);
}

#[test]
fn power_and_values() {
    let text = "\
+--\\--[ ]( start )--\\--[/]( stop )--( )( run )--+
|  /--[ ]( run )----/                           |
+--[ ]( run )--[TON]( warmup, T#5s )--( )( ready )--+
";
    let live = [
        ("+--\\", true),
        ("--\\--[/]", true),
        ("[/]( stop )--( )( run )--+", true),
        ("/--[ ]( run )----/", true),
        ("+--[ ]( run )--", true),
        ("[ ]( start )", false),
    ];
    let mut power = HashMap::new();
    let parsed = parse(text);
    for (piece, on) in live {
        for (range, here) in parts_in(&parsed, text, piece) {
            power.insert(range, on && here);
        }
    }
    let value = |text: &str| (text == "warmup").then(|| "1.2s".to_owned());
    let picture = drawn(
        text,
        &Options {
            theme: Theme::Dark,
            power: Some(power),
            value: Some(&value),
        },
    );
    expect_file!["pictures/power.svg"].assert_eq(&picture);
}

/// The parts of the drawing that lie in a piece of the text.
fn parts_in(parse: &Parse, text: &str, piece: &str) -> Vec<(TextRange, bool)> {
    let start = text.find(piece).unwrap_or_else(|| panic!("{piece} is not there"));
    let range = TextRange::at(TextSize::new(start as u32), TextSize::of(piece));
    let root = parse.syntax();
    let tokens = root.descendants_with_tokens();
    tokens
        .map(|element| element.text_range())
        .filter(|part| range.contains_range(*part) && !part.is_empty())
        .map(|part| (part, true))
        .collect()
}

#[test]
fn no_text_makes_a_broken_document() {
    for text in [
        "",
        "+",
        "|",
        "# only a comment #",
        "+--[ ]( a & <b> )--+",
        "+--\\--+",
        "/--\\\n\\--/",
        "+--[MOV]( s, '<&\u{1}>' )--+",
        "[ ]( a )",
        "|--[ ]( a )--|",
        "FUNCTION_BLOCK\n+--+",
    ] {
        let picture = drawn(text, &Options::default());
        let document = roxmltree::Document::parse(&picture);
        assert!(document.is_ok(), "{text:?}: {document:?}\n{picture}");
    }
}

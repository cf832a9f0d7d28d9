//! Pictures of programs, compared to the byte. `UPDATE_EXPECT=1 cargo test -p ladder-picture` draws them again;
//! look at them before you keep them.

use expect_test::expect_file;
use ladder_analysis::analyze;
use ladder_picture::{Options, Theme, picture, svg};
use ladder_syntax::{Parse, TextRange, TextSize, parse};
use std::collections::HashMap;
use std::sync::Arc;

fn drawn(text: &str, theme: Theme, options: &Options<'_>) -> String {
    let analysis = analyze(&Arc::new(parse(text)), "program");
    svg(&picture(&analysis.context, options), theme)
}

fn at_rest(text: &str, theme: Theme) -> String {
    drawn(text, theme, &Options::default())
}

#[test]
fn every_kind_of_symbol() {
    let picture = at_rest(include_str!("pictures/symbols.clad"), Theme::Light);
    expect_file!["pictures/symbols.svg"].assert_eq(&picture);
}

#[test]
fn program_flow_and_blocks() {
    let picture = at_rest(include_str!("pictures/flow.clad"), Theme::Auto);
    expect_file!["pictures/flow.svg"].assert_eq(&picture);
}

#[test]
fn branches_are_flush() {
    let picture = at_rest(include_str!("pictures/branches.clad"), Theme::Dark);
    expect_file!["pictures/branches.svg"].assert_eq(&picture);
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
    let value = |text: &str| match text {
        "warmup" => Some("1.2s".to_owned()),
        "run" => Some("1".to_owned()),
        "start" => Some("0".to_owned()),
        _ => None,
    };
    let picture = drawn(
        text,
        Theme::Dark,
        &Options {
            power: Some(power),
            value: Some(&value),
            ..Options::default()
        },
    );
    expect_file!["pictures/power.svg"].assert_eq(&picture);
}

#[test]
fn tags_of_a_body_have_no_one_value() {
    let text = "\
FUNCTION_BLOCK [$B]
VAR_INPUT a : BOOL; END_VAR
+--[ ]( a )--( )( ENO )--+
END_FUNCTION_BLOCK
+--[$B]( a )--( )( y )--+
";
    let value = |text: &str| (text == "a").then(|| "1".to_owned());
    let options = Options {
        value: Some(&value),
        ..Options::default()
    };
    let picture = drawn(text, Theme::Light, &options);
    assert_eq!(picture.matches("= 1").count(), 1, "{picture}");
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
        let picture = at_rest(text, Theme::Auto);
        let document = roxmltree::Document::parse(&picture);
        assert!(document.is_ok(), "{text:?}: {document:?}\n{picture}");
    }
}

//! For every text: the tree gives it back, errors lie inside it, and nesting is bounded.

use ladder_syntax::{SyntaxNode, parse};
use proptest::prelude::*;

/// Checks all that must hold for any text.
fn check(text: &str) {
    let parse = parse(text);
    assert_eq!(parse.to_string(), text);
    assert_eq!(parse.syntax().to_string(), text);
    let mut at = 0;
    for (index, line) in parse.lines().iter().enumerate() {
        assert!(line.len > 0, "line {index} is empty in {text:?}");
        assert_eq!(u32::from(parse.line_start(index)), at);
        for error in &line.errors {
            assert!(
                u32::from(error.range.end()) <= line.len,
                "{error:?} leaves its line in {text:?}"
            );
        }
        at += line.len;
    }
    for error in parse.errors() {
        let range = std::ops::Range::<usize>::from(error.range);
        assert!(
            text.get(range).is_some(),
            "{error:?} cuts a character in {text:?}"
        );
    }
    assert!(depth(&parse.syntax()) < 2000);
    for network in &parse.structure().networks {
        let wiring = ladder_syntax::wiring::wiring(&parse, network);
        for (line, rung) in wiring.lines.iter().zip(&wiring.rungs) {
            let len = parse.lines()[*line].len;
            let mut end = 0;
            for part in &rung.parts {
                assert!(u32::from(part.range.start()) >= end, "parts overlap in {text:?}");
                end = part.range.end().into();
            }
            assert!(end <= len);
        }
    }
}

fn depth(root: &SyntaxNode) -> usize {
    root.descendants()
        .map(|n| n.ancestors().count())
        .max()
        .unwrap_or(0)
}

/// Pieces from which texts are made that look like ladder, with every character that means something.
fn pieces() -> impl Strategy<Value = String> {
    let piece = prop_oneof![
        4 => prop::sample::select(vec![
            "+--", "--+", "\\", "/", "--\\--", "--/--", "[ ]( a )", "[/]( b )", "( )( y )", "(S)( y )",
            "[TON]( t, T#5s )", "[TON]( t, 5s, R := r )", "<JMP>( l )", "<RET>", "[$B]( a, b )", "|", "|  ", "\n", "\r\n",
            "\r", " ", "\t", "--", "-", "# c #", "#", "# a\n+--", "VAR\n", "VAR_INPUT ", "END_VAR\n", "a : INT;",
            "b, c : ARRAY[1..3] OF INT := [1, 2(0)];", "s : STRING[5] := 'a$'b';", "FUNCTION_BLOCK [$B]\n",
            "END_FUNCTION_BLOCK\n", "[CALC]( y, a + b * -c ^ 2 )", "[CALC]( y, (a + SQRT(b)) / 2 )", "a[3..9]", "t1.Q",
            "[ ]( word.3 )", "16#FF", "T#1h30m", "D#2026-11-21", "'", "(", ")", "[", "]", "<", ">", ",", ":=", "=>", ";",
            ":", "..", ".", "%IX0.3", "NOT", "MOD", "$", "\u{feff}", "\0", "\u{2028}", "é", "温", "🙂", "((((", "----(",
        ]).prop_map(str::to_owned),
        1 => any::<String>(),
    ];
    prop::collection::vec(piece, 0..40).prop_map(|pieces| pieces.concat())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn any_string(text in any::<String>()) {
        check(&text);
    }

    #[test]
    fn ladder_like(text in pieces()) {
        check(&text);
    }
}

#[test]
fn deep_and_long() {
    for (open, close) in [
        ("(", ")"),
        ("-", ""),
        ("NOT ", ""),
        ("a[", "]"),
        ("SQRT(", ")"),
        ("a+", "b"),
        ("a^", "b"),
        ("a.", "b"),
    ] {
        let text = format!(
            "+--[CALC]( y, {}a{} )--+\n",
            open.repeat(20_000),
            close.repeat(20_000)
        );
        check(&text);
    }
}

//! What holds for every text, checked on any strings, on soups of ladder pieces and on made programs.

mod comments;
mod meaning;
mod programs;

use ladder_format::{Options, apply, format_ranges};
use ladder_syntax::{TextRange, TextSize, parse};
use meaning::{check_with, drawing, errors, words};
use proptest::prelude::*;

/// Checks all that must hold for any text.
fn check(text: &str) {
    check_with(text, &Options::default());
}

/// Pieces of every kind, in any order.
fn soup() -> impl Strategy<Value = String> {
    let piece = prop_oneof![
        8 => prop::sample::select(vec![
            "+--", "--+", "\\", "/", "--\\--", "--/--", "[ ]( a )", "[/]( b )", "( )( y )", "(S)( y )",
            "[TON]( t, T#5s )", "[ton]( t, 5s, r := r )", "<JMP>( l )", "<RET>", "[$B]( a, b )", "|", "|  ", "\n", "\r\n",
            "\r", " ", "\t", "--", "-", "# c #", "#", "# a\n+--", "VAR\n", "VAR_INPUT ", "END_VAR\n", "a : INT;",
            "b, c : ARRAY[1..3] OF INT := [1, 2(0)];", "s : STRING[5] := 'a$'b';", "FUNCTION_BLOCK [$B]\n",
            "END_FUNCTION_BLOCK\n", "[CALC]( y, a + b * -c ^ 2 )", "[CALC]( y, (a + SQRT(b)) / 2 )", "a[3..9]", "t1.Q",
            "[ ]( word.3 )", "16#FF", "T#1h30m", "D#2026-11-21", "'", "(", ")", "[", "]", "<", ">", ",", ":=", "=>", ";",
            ":", "..", ".", "%IX0.3", "NOT", "MOD", "$", "\u{feff}", "\0", "\u{2028}", "é", "温", "🙂", "((((", "----(",
            "[OSR]", "[CALC]( ", " )", "- ", "not ", "SHL", "sys", "pi", "5", "1.5", "# ladder: fmt off #", "# ladder: fmt on #",
        ]).prop_map(str::to_owned),
        1 => any::<String>(),
    ];
    prop::collection::vec(piece, 0..40).prop_map(|pieces| pieces.concat())
}

/// A block whose operands are words in any order, with and without blanks between.
fn operands() -> impl Strategy<Value = String> {
    let word = prop::sample::select(vec![
        "a", "b1", "5", "1.5", "3", "T#5s", "16#FF", "1e", "%IX0", "'s'", "-", "-", "+", "*", "/", "^", "(",
        ")", "(a)", "(b)", "[", "]", "[3]", ".", "..", ".5", ",", ":=", "=>", "=", "<", ">", "<>", "not ",
        "mod", "and", "sqrt", "sys", "true", "# c #", "#c#", "é", "INT#",
    ]);
    let blank = prop::sample::select(vec!["", "", " ", "  ", "\t"]);
    let head = prop::sample::select(vec!["[CALC]( y, ", "[SEARCH](y, eq, ", "( )(", "[$B](", "[ ]( "]);
    (head, prop::collection::vec((word, blank), 0..12)).prop_map(|(head, words)| {
        let mut text = format!("+--{head}");
        for (word, blank) in words {
            text.push_str(word);
            text.push_str(blank);
        }
        text.push_str(")--( )( y )--+\n");
        text
    })
}

/// A program, and a program with a few characters changed.
fn program() -> impl Strategy<Value = String> {
    prop::collection::vec(any::<u8>(), 0..300)
        .prop_map(|bytes| programs::file(&mut programs::Choices::new(&bytes)))
}

fn mutated() -> impl Strategy<Value = String> {
    let change = (
        any::<prop::sample::Index>(),
        prop::sample::select(vec![
            "",
            " ",
            "-",
            "|",
            "\\",
            "/",
            "+",
            "#",
            "\n",
            "(",
            ")",
            "[",
            "]",
            "a",
            ",",
            ".",
            "VAR\n",
            "END_VAR\n",
        ]),
    );
    (program(), prop::collection::vec(change, 1..4)).prop_map(|(mut text, changes)| {
        for (at, new) in changes {
            let places: Vec<usize> = text.char_indices().map(|(n, _)| n).collect();
            if places.is_empty() {
                continue;
            }
            let at = places[at.index(places.len())];
            let end = at + text[at..].chars().next().map_or(0, char::len_utf8);
            text.replace_range(at..end, new);
        }
        text
    })
}

/// How many texts each property is tried on; more when asked for.
fn cases() -> u32 {
    let asked = std::env::var("PROPTEST_CASES").ok();
    asked.and_then(|n| n.parse().ok()).unwrap_or(1000)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: cases(), ..ProptestConfig::default() })]

    #[test]
    fn any_string(text in any::<String>()) {
        check(&text);
    }

    #[test]
    fn ladder_like(text in soup()) {
        check(&text);
    }

    #[test]
    fn operands_of_all_kinds(text in operands()) {
        check(&text);
    }

    #[test]
    fn programs_of_all_kinds(text in program()) {
        check(&text);
    }

    #[test]
    fn other_options(text in program(), width in 0..130u32, spacing in 0..5u32) {
        check_with(&text, &Options { width, spacing });
    }

    #[test]
    fn mutated_programs(text in mutated()) {
        check(&text);
    }

    #[test]
    fn commented_programs(text in program(), places in prop::collection::vec((any::<prop::sample::Index>(), 0..comments::COMMENTS.len()), 1..4)) {
        check(&comments::insert(text, &places));
    }

    #[test]
    fn ranges_change_nothing_else(text in program(), from in any::<prop::sample::Index>(), to in any::<prop::sample::Index>()) {
        let before = parse(&text);
        let (a, b) = (from.index(text.len() + 1), to.index(text.len() + 1));
        let range = TextRange::new(TextSize::new(a.min(b) as u32), TextSize::new(a.max(b) as u32));
        let edits = format_ranges(&before, &Options::default(), &[range]);
        let new = apply(&text, &edits);
        let after = parse(&new);
        prop_assert_eq!(words(&before), words(&after));
        prop_assert_eq!(drawing(&before, &text), drawing(&after, &new));
        prop_assert_eq!(errors(&before), errors(&after));
    }
}

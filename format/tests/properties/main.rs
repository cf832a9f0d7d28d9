//! What holds for every text, checked on any strings, on soups of ladder pieces and on made programs.

mod programs;

use ladder_format::{Options, apply, format, format_ranges, format_text};
use ladder_syntax::wiring::{PartKind, wiring};
use ladder_syntax::{NodeOrToken, Parse, SyntaxKind, TextRange, TextSize, parse};
use proptest::prelude::*;

/// Checks all that must hold for any text.
fn check(text: &str) {
    check_with(text, &Options::default());
}

fn check_with(text: &str, options: &Options) {
    let before = parse(text);
    let new = format_text(text, options);
    let edits = format(&before, options);
    assert_eq!(apply(text, &edits), new, "edits and text differ");
    for pair in edits.windows(2) {
        assert!(pair[0].range.end() < pair[1].range.start(), "{pair:?}");
    }
    for edit in &edits {
        assert_ne!(&text[edit.range], edit.text, "an edit that changes nothing");
    }
    let after = parse(&new);
    assert_eq!(words(&before), words(&after), "words changed\n{text}\n=>\n{new}");
    assert_eq!(
        drawing(&before, text),
        drawing(&after, &new),
        "wiring changed\n{text}\n=>\n{new}"
    );
    assert_eq!(
        mistakes(&before),
        mistakes(&after),
        "mistakes changed\n{text}\n=>\n{new}"
    );
    let again = format_text(&new, options);
    assert_eq!(again, new, "a second time changes something\n{text}");
    assert!(
        !new.contains(" \n") || text.contains(" \n"),
        "blanks at a line end"
    );
}

/// All that may not change: every token but white space, wires and `|`, in capitals where letters may change.
fn words(parse: &Parse) -> Vec<(SyntaxKind, String)> {
    parse
        .syntax()
        .descendants_with_tokens()
        .filter_map(NodeOrToken::into_token)
        .filter(|token| {
            !matches!(
                token.kind(),
                SyntaxKind::WHITESPACE | SyntaxKind::NEWLINE | SyntaxKind::WIRE | SyntaxKind::RAIL
            )
        })
        .map(|token| {
            let may_change = matches!(
                token.kind(),
                SyntaxKind::KEYWORD
                    | SyntaxKind::MNEMONIC
                    | SyntaxKind::WORD_OPERATOR
                    | SyntaxKind::IDENT
                    | SyntaxKind::LITERAL
            );
            let word = if may_change {
                token.text().to_ascii_uppercase()
            } else {
                token.text().to_owned()
            };
            (token.kind(), word)
        })
        .collect()
}

/// The wiring: for each network its rungs as segments, and the pairs.
fn drawing(parse: &Parse, text: &str) -> Vec<String> {
    let mut networks = Vec::new();
    for network in &parse.structure().networks {
        let wiring = wiring(parse, network);
        let mut out = format!("block {:?}; {} unpaired;", network.block, wiring.unpaired.len());
        for (offset, rung) in wiring.line_offsets.iter().zip(&wiring.rungs) {
            let line = network.lines.start + offset;
            let start = usize::from(parse.line_start(line));
            let mut segment = None;
            for (index, part) in rung.parts.iter().enumerate() {
                if part.kind == PartKind::Bar || (part.kind == PartKind::Comment && part.segment.is_none()) {
                    continue;
                }
                if part.segment != segment || part.segment.is_none() {
                    segment = part.segment;
                    let powered = segment.is_some_and(|n| rung.segments[n as usize].powered);
                    out.push_str(if powered { "\n  powered:" } else { "\n  segment:" });
                }
                // A wire counts only where it ends at nothing; between two things it may have been missing.
                let edge = segment.is_some_and(|n| {
                    let parts = &rung.segments[n as usize].parts;
                    rung.parts[parts.start].range == part.range
                        || rung.parts[parts.end - 1].range == part.range
                });
                let at_bar = [index.wrapping_sub(1), index + 1]
                    .iter()
                    .any(|&n| rung.parts.get(n).is_some_and(|p| p.kind == PartKind::StrayBar));
                if part.kind == PartKind::Wire && (!edge || at_bar) {
                    continue;
                }
                let range = std::ops::Range::<usize>::from(part.range);
                let word = &text[start + range.start..start + range.end];
                let word: String = word.chars().filter(|c| !c.is_whitespace()).collect();
                let word = if part.kind == PartKind::Wire { "-" } else { &word };
                out.push_str(&format!(" {:?} {}", part.kind, word.to_ascii_uppercase()));
            }
            out.push_str("\n rung;");
        }
        // Pairs by their ordinals on both rungs, which part numbers are not.
        for point in &wiring.points {
            out.push_str(&format!(" {}:{}", point.upper, point.ordinal));
        }
        networks.push(out);
    }
    networks
}

fn mistakes(parse: &Parse) -> Vec<String> {
    parse
        .errors()
        .iter()
        .map(|error| format!("{:?}", error.kind))
        .collect()
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
    #![proptest_config(ProptestConfig { cases: cases(), failure_persistence: None, ..ProptestConfig::default() })]

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
    fn ranges_change_nothing_else(text in program(), from in any::<prop::sample::Index>(), to in any::<prop::sample::Index>()) {
        let before = parse(&text);
        let (a, b) = (from.index(text.len() + 1), to.index(text.len() + 1));
        let range = TextRange::new(TextSize::new(a.min(b) as u32), TextSize::new(a.max(b) as u32));
        let edits = format_ranges(&before, &Options::default(), &[range]);
        let new = apply(&text, &edits);
        let after = parse(&new);
        prop_assert_eq!(words(&before), words(&after));
        prop_assert_eq!(drawing(&before, &text), drawing(&after, &new));
        prop_assert_eq!(mistakes(&before), mistakes(&after));
    }
}

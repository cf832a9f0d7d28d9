//! What formatting keeps of a text, and what it leaves out.

use ladder_format::program::ProgramSketch;
use ladder_format::{Options, apply, format, format_text};
use ladder_syntax::wiring::{PartKind, wiring};
use ladder_syntax::{NodeOrToken, Parse, SyntaxKind, parse};

/// Checks all that must hold for any text, laid out with these options.
pub(crate) fn check_with(text: &str, options: &Options) {
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
        errors(&before),
        errors(&after),
        "errors changed\n{text}\n=>\n{new}"
    );
    let again = format_text(&new, options);
    assert_eq!(again, new, "a second time changes something\n{text}");
    assert!(
        !new.contains(" \n") || text.contains(" \n"),
        "blanks at a line end"
    );
    // What is only drawn wrong is an error of the analysis.
    let is_stray = drawing(&after, &new).concat().contains(" Stray");
    if errors(&after).is_empty() && !is_stray && !new.contains(['#', '\u{feff}']) {
        check_sketch(&new, &after);
    }
}

/// Checks that a text without errors and comments is drawn again by its sketch.
fn check_sketch(text: &str, before: &Parse) {
    let written = ProgramSketch::of_text(before).write(&Options::default());
    let after = parse(&written.text);
    let shown = || format!("{text}\n=>\n{}", written.text);
    // Empty lists have no form of their own, and parentheses are where operators ask for them.
    let sorted = |parse: &Parse| {
        let mut words = words(parse);
        words.retain(|(kind, _)| !matches!(kind, SyntaxKind::L_PAREN | SyntaxKind::R_PAREN));
        words.sort();
        words
    };
    assert_eq!(sorted(before), sorted(&after), "words changed\n{}", shown());
    let joined = |parse: &Parse, text: &str| {
        let drawn = drawing(parse, text).join("\n");
        drawn.replace(['(', ')'], "").replace(" Wire -", "")
    };
    assert_eq!(
        joined(before, text),
        joined(&after, &written.text),
        "wiring changed\n{}",
        shown()
    );
    assert!(errors(&after).is_empty(), "errors\n{}", shown());
    for (range, origin) in written.places {
        assert!(
            text[origin as usize..].starts_with(written.text[range].chars().next().unwrap_or_default()),
            "{}",
            shown()
        );
    }
}

/// All that may not change: every token but white space, wires and `|`, in capitals where letters may change.
pub(crate) fn words(parse: &Parse) -> Vec<(SyntaxKind, String)> {
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
pub(crate) fn drawing(parse: &Parse, text: &str) -> Vec<String> {
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

pub(crate) fn errors(parse: &Parse) -> Vec<String> {
    parse
        .errors()
        .iter()
        .map(|error| format!("{:?}", error.kind))
        .collect()
}

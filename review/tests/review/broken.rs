//! Texts of any kind: each line is in one entry, and nothing panics.

use crate::harness::outline;
use ladder_review::outline::{Entry, Outline};
use ladder_review::report::{Compared, html, markdown, text};
use ladder_review::{Sides, compare, merge};
use proptest::prelude::*;

fn pieces() -> impl Strategy<Value = String> {
    let piece = prop_oneof![
        Just("+--[ ]( a )--( )( b )--+\n"),
        Just("+--\\--[ ]( a )--\\--( )( b )--+\n"),
        Just("|  /--[ ]( c )--/\n"),
        Just("|\n"),
        Just("\n"),
        Just("\r\n"),
        Just("\r"),
        Just("# note #\n"),
        Just("# ladder: profile iec #\n"),
        Just("# ladder: allow(x): y #"),
        Just("# two\nlines #\n"),
        Just("VAR\n"),
        Just("VAR_INPUT x, y : BOOL; END_VAR\n"),
        Just("    x : INT := 3;  # why #\n"),
        Just("END_VAR\n"),
        Just("TYPE\n"),
        Just("M : STRUCT\n"),
        Just("END_STRUCT;\n"),
        Just("END_TYPE\n"),
        Just("FUNCTION_BLOCK [$B]\n"),
        Just("END_FUNCTION_BLOCK\n"),
        Just("+--<FUN>( f )--+\n"),
        Just("+--[ ]( é b )--(\n"),
        Just("#"),
        Just("\u{feff}"),
        Just("stray\n"),
    ];
    proptest::collection::vec(piece, 0..14).prop_map(|pieces| pieces.concat())
}

fn rebuilt(outline: &Outline, entries: &[Entry], out: &mut String) {
    for entry in entries {
        out.push_str(&outline.text(entry.range));
        rebuilt(outline, &entry.inside, out);
        if entry.kind.holds_others() {
            out.push_str(&outline.text(entry.end));
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 1000, ..ProptestConfig::default() })]

    #[test]
    fn the_entries_are_the_whole_text(text in pieces()) {
        let outline = outline(&text);
        let mut whole = String::new();
        rebuilt(&outline, &outline.entries, &mut whole);
        whole.push_str(&outline.text(outline.end));
        prop_assert_eq!(whole, text);
    }

    #[test]
    fn whatever_is_compared_is_reported(old in pieces(), new in pieces()) {
        let (old, new) = (outline(&old), outline(&new));
        let compared = Compared { old: Some("old"), new: Some("new"), renamed: false, comparison: compare(&old, &new) };
        text::report(&compared);
        let files = [compared];
        markdown::report(&files);
        html::report(&files, &[]);
        prop_assert!(!compare(&new, &new).differs());
    }

    #[test]
    fn whatever_is_merged_is_merged_or_refused(base in pieces(), ours in pieces(), theirs in pieces()) {
        let (base, ours, theirs) = (outline(&base), outline(&ours), outline(&theirs));
        let _ = merge(Sides { base: &base, ours: &ours, theirs: &theirs });
    }
}

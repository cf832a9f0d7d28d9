//! Parsing again after an edit gives what parsing from scratch gives.

use crate::invariants::check_same;
use crate::mutated::{mutate, mutation};
use crate::programs::PROGRAMS;
use ladder_syntax::{Parse, TextRange, TextSize, parse};
use proptest::prelude::*;
use std::cell::Cell;

/// The edit that leads from one text to the other: what they share at both ends stays, but for some bytes more.
fn edit(old: &str, new: &str, more: usize) -> (TextRange, TextSize) {
    let shared = old.bytes().zip(new.bytes()).take_while(|(a, b)| a == b).count();
    let mut start = shared.saturating_sub(more);
    while !old.is_char_boundary(start) || !new.is_char_boundary(start) {
        start -= 1;
    }
    let after = old[start..]
        .bytes()
        .rev()
        .zip(new[start..].bytes().rev())
        .take_while(|(a, b)| a == b)
        .count();
    let mut after = after.saturating_sub(more);
    while !old.is_char_boundary(old.len() - after) || !new.is_char_boundary(new.len() - after) {
        after -= 1;
    }
    let size = |n: usize| TextSize::new(n as u32);
    (
        TextRange::new(size(start), size(old.len() - after)),
        size(new.len() - after - start),
    )
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(600))]

    #[test]
    fn edits_of_programs(
        program in 0..PROGRAMS.len(),
        mutations in prop::collection::vec(mutation(), 1..8),
        more in 0..3usize,
    ) {
        let mut text = PROGRAMS[program].to_owned();
        let mut edited = parse(&text);
        for step in &mutations {
            let old = text.clone();
            mutate(&mut text, step);
            let (range, len) = edit(&old, &text, more);
            edited = edited.edited(&text, range, len);
            check_same(&edited, &text);
        }
    }

    #[test]
    fn edits_of_pieces(old in crate::arbitrary::pieces(), mutations in prop::collection::vec(mutation(), 1..4)) {
        let mut text = old;
        let mut edited = parse(&text);
        for step in &mutations {
            let old = text.clone();
            mutate(&mut text, step);
            let (range, len) = edit(&old, &text, 0);
            edited = edited.edited(&text, range, len);
            check_same(&edited, &text);
        }
    }
}

/// Long programs, so that there are several parts; what an edit does not touch stays the same line.
#[test]
fn edits_of_long_programs() {
    let program = PROGRAMS.concat();
    let mut text = program.repeat(25);
    let mut edited = parse(&text);
    let state = Cell::new(1u32);
    let random = |below: usize| {
        state.set(state.get().wrapping_mul(1_664_525).wrapping_add(1_013_904_223));
        (state.get() >> 8) as usize % below
    };
    for round in 0..40 {
        let mut at = random(text.len());
        while !text.is_char_boundary(at) {
            at -= 1;
        }
        let piece = match round % 10 {
            0 => program.repeat(1 + random(20)),
            1 => "#".to_owned(),
            2 => "VAR\n".to_owned(),
            3 => "\n".to_owned(),
            _ => "--".to_owned(),
        };
        // Now and then a large part goes, and a stray `#` does not stay.
        let mut end = match round % 10 {
            5 => (at + random(text.len() / 4)).min(text.len()),
            _ => (at + random(3)).min(text.len()),
        };
        while !text.is_char_boundary(end) {
            end -= 1;
        }
        let end = end.max(at);
        let range = TextRange::new(TextSize::new(at as u32), TextSize::new(end as u32));
        let old = text.clone();
        text.replace_range(at..end, &piece);
        edited = edited.edited(&text, range, TextSize::of(&piece));
        check_same(&edited, &text);
        if piece == "#" {
            let range = TextRange::at(TextSize::new(at as u32), TextSize::of(&piece));
            edited = edited.edited(&old, range, TextSize::new((end - at) as u32));
            text = old;
            check_same(&edited, &text);
        }
    }
    let before = parse(&text);
    let at = text.find("+--").unwrap() as u32 + 1;
    let range = TextRange::empty(TextSize::new(at));
    text.insert(at as usize, '-');
    let after = before.edited(&text, range, TextSize::new(1));
    let kept = before
        .lines()
        .iter()
        .zip(after.lines())
        .filter(|(a, b)| a.is(b))
        .count();
    assert!(
        kept + 2 >= before.lines().len(),
        "{kept} of {} lines",
        before.lines().len()
    );
}

/// Edits that change how lines before or after them are read.
#[test]
fn edits_at_the_edges_of_lines() {
    for (old, from, to, new) in [
        // A word that becomes a qualifier, or a keyword, of the line before it.
        ("VAR RETAINx : INT; END_VAR\n", 10, 11, ""),
        ("VAR END_VAR VARx\n", 15, 16, ""),
        ("END_VAR x\n", 8, 9, "VAR"),
        // The first character may be a byte order mark only at the start.
        ("\u{feff}+--+\n", 0, 0, "+--+\n"),
        ("+--+\n\u{feff}+--+\n", 0, 5, ""),
        // CR and LF come together, or apart.
        ("+--+\r+--+\n", 5, 5, "\n"),
        ("+--+\r\n+--+\n", 5, 6, ""),
        ("+--+\r\n+--+\n", 4, 5, ""),
        // A declaration goes on, or goes on no longer, over blank lines and comments.
        ("VAR\na\n\n# c #\nb : INT;\nEND_VAR\n", 13, 14, ""),
        ("VAR\na\n\n# c #\n: INT;\nEND_VAR\n", 13, 13, "b"),
        ("VAR\na\n\n# c #\n: INT;\nEND_VAR\n", 13, 13, "+"),
        // Comments open and close over everything that follows.
        ("+--+\n+--+\n+--+\n", 7, 7, "#"),
        ("+--+ # a\n+--+ # b\n+--+\n", 5, 6, ""),
        ("+--+\n", 5, 5, "# a"),
        // A conflict begins, and ends, and what is not read of it too.
        ("+--+\n=======\n+--+\n>>>>>>> b\n+--+\n", 0, 0, "<<<<<<< a\n"),
        ("<<<<<<< a\n+--+\n=======\n+--+\n>>>>>>> b\n+--+\n", 27, 28, ""),
        ("<<<<<<< a\n+--+\n=======\n+--+\n>>>>>>> b\n+--+\n", 15, 16, ""),
        (
            "<<<<<<< a\n+--+\n+--+\n+--+\n+--+\n>>>>>>> b\n+--+\n",
            20,
            20,
            "=======\n",
        ),
        ("<<<<<<< a\n# a\n=======\n# b\n>>>>>>> b\nc #\n+--+\n", 10, 11, ""),
        (
            "VAR\na\n<<<<<<< a\n: INT;\n=======\n: DINT;\n>>>>>>> b\nEND_VAR\n",
            16,
            16,
            "b",
        ),
        ("", 0, 0, "+--+"),
        ("+--+\n", 0, 5, ""),
    ] {
        let mut text = old.to_owned();
        text.replace_range(from..to, new);
        let range = TextRange::new(TextSize::new(from as u32), TextSize::new(to as u32));
        check_same(&parse(old).edited(&text, range, TextSize::of(new)), &text);
    }
}

/// Whole lines that come and go leave all others as they are, the first and those next to them too.
#[test]
fn whole_lines_come_and_go() {
    let (declared, drawn) = (
        "VAR_INPUT\n    a : BOOL;\nEND_VAR\n",
        "+--[ ]( a )--( )( b )--+\n\n",
    );
    let old = format!("{declared}{drawn}{drawn}");
    for (line, new) in [
        (0, "# note #\n"),
        (1, "    c : BOOL;\n"),
        (2, "    c : BOOL;\n"),
        (3, "\n"),
        (3, drawn),
        (4, "|  /--[ ]( b )--/\n"),
        (5, drawn),
    ] {
        let before = parse(&old);
        let at = before.line_start(line);
        let mut text = old.clone();
        text.insert_str(at.into(), new);
        let after = before.edited(&text, TextRange::empty(at), TextSize::of(new));
        let same = |one: &Parse, other: &Parse| one.lines().shared_with(other.lines());
        let rest = before.lines().len() - line;
        assert_eq!(same(&after, &before), (line, rest), "{new:?} in line {line}");
        let back = after.edited(&old, TextRange::at(at, TextSize::of(new)), TextSize::new(0));
        assert_eq!(same(&back, &after), (line, rest), "{new:?} out of line {line}");
    }
}

/// Lengths that do not agree give no panic, but the parse of the text.
#[test]
fn wrong_lengths() {
    let old = parse("+--+\n");
    let range = |a: u32, b: u32| TextRange::new(a.into(), b.into());
    for (text, range, len) in [
        ("+---+\n", range(1, 2), 1),
        ("", range(0, 50), 0),
        ("x", range(0, 0), 1),
    ] {
        check_same(&old.edited(text, range, len.into()), text);
    }
    check_same(&parse("").edited("+\n", range(0, 0), 2.into()), "+\n");
}

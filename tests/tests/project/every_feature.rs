//! No text, however broken, makes any feature of an editor panic, at any place. A new feature gets a line in
//! [`FEATURES`].

use ladder_analysis::analyze;
use ladder_syntax::{TextSize, parse};
use ladder_tests::features::{FEATURES, whole};
use ladder_tests::generator::Dice;
use ladder_tests::project;
use std::sync::Arc;

/// What a hand puts in, or leaves half-written.
const PIECES: [&str; 34] = [
    "",
    "",
    "\\",
    "/",
    "-",
    "+",
    "|",
    " ",
    "\n",
    "\r\n",
    "\r",
    "(",
    ")",
    "[",
    "]",
    "<",
    ">",
    "#",
    ",",
    ":=",
    "=>",
    ".",
    "'",
    "$",
    "%",
    "é",
    "\u{feff}",
    "[TON](",
    "<CALL>(",
    "VAR\n",
    "END_VAR",
    "FUNCTION_BLOCK [$B]\n",
    "+--",
    "# note",
];

fn mutated(dice: &mut Dice, text: &str) -> String {
    let mut text = text.to_owned();
    for _ in 0..dice.below(4) {
        let mut at = dice.below(text.len() + 1);
        while !text.is_char_boundary(at) {
            at -= 1;
        }
        let mut end = (at + dice.below(6)).min(text.len());
        while !text.is_char_boundary(end) {
            end += 1;
        }
        text.replace_range(at..end, dice.of(&PIECES));
    }
    if dice.one_in(4) {
        let mut at = dice.below(text.len() + 1);
        while !text.is_char_boundary(at) {
            at -= 1;
        }
        text.truncate(at);
    }
    text
}

fn ask_everywhere(text: &str, offsets: impl Iterator<Item = usize>) {
    let analysis = analyze(&Arc::new(parse(text)), "main.clad");
    whole(&analysis);
    let end = TextSize::of(text);
    for at in offsets.filter(|at| text.is_char_boundary(*at)) {
        for (name, ask) in FEATURES {
            let at = TextSize::new(at as u32);
            let asked = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| ask(&analysis, at, end)));
            assert!(asked.is_ok(), "{name} at {at:?} of\n{text}\n{text:?}");
        }
    }
}

/// A bit of everything, small enough to ask at every offset.
const SMALL: &str = "VAR t : TON; a : ARRAY[1..3] OF INT; END_VAR\n# motor # \n+--\\--[ ]( x )--\\--[TON]( t, 5s )--( )( y )--+\n\
    |  /--[/]( y )--/                              |\n+--<FUN>( f )--[$B]( i := t.Q )--<JMP>( l )--+\n\
    FUNCTION_BLOCK [$B]\nVAR_INPUT i : BOOL; END_VAR\n+--<LBL>( l )--[CALC]( n, -(a[2] + 1) )--<CALL>( f )--+\nEND_FUNCTION_BLOCK\n";

#[test]
fn at_every_offset() {
    ask_everywhere(SMALL, 0..=SMALL.len());
    let mut dice = Dice::new(7);
    for _ in 0..2 {
        let text = mutated(&mut dice, SMALL);
        ask_everywhere(&text, 0..=text.len());
    }
}

#[test]
fn here_and_there_in_broken_examples() {
    let mut dice = Dice::new(11);
    for path in project::files(&project::root().join("examples"), "clad") {
        let text = project::read(&path);
        for _ in 0..3 {
            let text = mutated(&mut dice, &text);
            let offsets: Vec<usize> = (0..12).map(|_| dice.below(text.len() + 1)).collect();
            ask_everywhere(&text, offsets.into_iter());
        }
    }
}

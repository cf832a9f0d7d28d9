//! The same for edits of declarations, whose names, types and initial values decide about networks elsewhere.

use crate::incremental::{Document, asked, settings};
use ladder_tests::generator::Dice;

/// Names are close to each other: a letter more or less makes one of another.
const DECLARED: [&str; 4] = [
    "\
VAR_INPUT
    a, b : BOOL;
    start : BOOL; # begins #
END_VAR
VAR_OUTPUT
    y, y1 : BOOL;
    lamp : BOOL := TRUE;
END_VAR
VAR
    t, t1 : TON;
    n : INT := 5; m : DINT;

    # alone #
    unused, held : BOOL;
    list : ARRAY[1..5] OF INT;
END_VAR
VAR CONSTANT
    most : INT := 7;
END_VAR
",
    "\
FUNCTION_BLOCK [$F]
VAR_INPUT
    x : BOOL;
    never : BOOL;
END_VAR
+--[ ]( x )--( )( ENO )--+
END_FUNCTION_BLOCK

VAR_INPUT
    a : BOOL;
    b : BOOL;
    start : BOOL;
END_VAR
VAR RETAIN
    held, y : BOOL;
    n : INT;
    t : TON;
END_VAR
",
    "\
VAR_INPUT
    a, b, start : BOOL;
END_VAR
VAR_OUTPUT
    y, y1, lamp, held : BOOL;
END_VAR
VAR
    n, m, most : INT;
    t : TON;
END_VAR

# ladder: allow(never-read) #
",
    "\
VAR_INPUT
    a : BOOL;
END_VAR
VAR
    first AT %MW3 : INT;
    t : TON;
    y : BOOL;
END_VAR
",
];

const RUNGS: [&str; 14] = [
    "+--[ ]( a )--[/]( b )--( )( y )--+\n\n",
    "+--[ ]( ab )--( )( y1 )--+\n\n",
    "+--[ ]( a1 )--(S)( held )--+\n\n",
    "+--[ ]( start )--(R)( held )--( )( y )--+\n\n",
    "+--[ ]( held )--[/]( held )--( )( lamp )--+\n\n",
    "+--[ ]( b )--[TON]( t, T#1s )--( )( lamp )--+\n\n",
    "+--[ ]( t.Q )--[TON]( t1, T#1s )--( )( y1 )--+\n\n",
    "+--[GT]( n, most )--[MOV]( 3, n )--+\n\n",
    "+--[GT]( m, 70000 )--[MOV]( n, m )--+\n\n",
    "+--[MOV]( 300, nn )--[GT]( list[2], 1 )--( )( y )--+\n\n",
    "+--\\--[ ]( start )--\\--( )( lamp )--+\n|  /--[ ]( Start )--/              |\n\n",
    "+--[ ]( y )--[ ]( y1 )--( )( b )--+\n\n",
    "+--[$F]( a )--( )( held )--+\n\n",
    "FUNCTION_BLOCK [$G]\nVAR_INPUT p : BOOL; END_VAR\n+--[ ]( p )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n\n",
];

/// What is typed.
const TYPED: [&str; 16] = [
    "1",
    "b",
    "A",
    "5",
    " ",
    "x",
    ", a1",
    ", nn",
    ":= 5",
    "D",
    "# note #",
    "\n",
    "    z : BOOL;\n",
    "é",
    " AT %IX0.1",
    "_",
];

#[test]
fn typing_in_declarations() {
    for seed in 0..asked(40) {
        let mut dice = Dice::new(seed);
        let declared = dice.of(&DECLARED);
        let drawn: String = (0..3 + dice.below(9)).map(|_| dice.of(&RUNGS)).collect();
        let original = format!("{declared}\n{drawn}");
        let mut document = Document::with(original.clone(), settings(&mut dice));
        for _ in 0..8 {
            let at = dice.below(declared.len());
            let typed = dice.of(&TYPED);
            let mut next = document.text.clone();
            if !next.is_char_boundary(at) {
                continue;
            }
            next.insert_str(at, typed);
            document.becomes(next);
            if dice.one_in(3) {
                // A letter in a network, with the declarations as they are.
                let mut next = document.text.clone();
                let end = next.rfind(" )").unwrap_or(next.len());
                next.insert(end, '1');
                document.becomes(next);
            }
            if dice.one_in(3) {
                // A letter is taken out of a word.
                let mut next = document.text.clone();
                let words: Vec<usize> = next[..declared.len()]
                    .match_indices(char::is_alphanumeric)
                    .map(|(at, _)| at)
                    .collect();
                next.remove(dice.of(&words));
                document.becomes(next);
            }
            if dice.one_in(2) {
                document.becomes(original.clone());
            }
        }
    }
}

/// Names that are exchanged, letter by letter and on several lines at once.
#[test]
fn names_that_take_the_place_of_others() {
    let program = |declared: &str| {
        format!(
            "VAR_INPUT\n    {declared}\nEND_VAR\nVAR\n    below : BOOL;\nEND_VAR\n\n\
             +--[ ]( one )--[/]( two )--( )( three )--+\n\n+--[ ]( ones )--( )( below )--+\n"
        )
    };
    for declared in [
        [
            "one : BOOL;\n    two : BOOL;",
            "two : BOOL;\n    one : BOOL;",
            "two : BOOL;\n    ones : BOOL;",
        ],
        ["one, two : BOOL;", "two, one : BOOL;", "ones, two : BOOL;"],
        ["one, two : BOOL;", "one, ONE : BOOL;", "one, two : INT;"],
        [
            "one, two : BOOL;",
            "one, two : BOOL; # n #",
            "one, two : BOOL; # longer #",
        ],
        ["one : BOOL;", "on : BOOL;", "One : BOOL;"],
        ["one : BOOL;", "one : BOOL := TRUE;", "one : BOOL := 5;"],
    ] {
        let mut document = Document::new(String::new());
        for declared in [declared[0], declared[1], declared[2], declared[1], declared[0]] {
            document.becomes(program(declared));
        }
    }
}

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

/// Whole declarations, and the lines between them.
const LINES: [&str; 9] = [
    "    fresh : BOOL;\n",
    "    y1x, a1, nn : BOOL;\n",
    "    ab : INT := 7; # begins #\n",
    "    startx : TON;\n    stop : STRING;\n",
    "    z AT %IX0.1 : BOOL;\n",
    "\n",
    "    # ladder: allow(never-read) #\n",
    "    a : BOOL;\n",
    "    é\n",
];

/// Declarations that are typed letter by letter on lines of their own, and lines that come and go.
#[test]
fn lines_of_declarations_that_come_and_go() {
    for seed in 0..asked(40) {
        let mut dice = Dice::new(seed);
        let declared = dice.of(&DECLARED);
        let drawn: String = (0..3 + dice.below(9)).map(|_| dice.of(&RUNGS)).collect();
        let mut document = Document::with(format!("{declared}\n{drawn}"), settings(&mut dice));
        for _ in 0..6 {
            let count = declared.lines().count();
            let lines: Vec<&str> = document.text.split_inclusive('\n').collect();
            let at = dice.below(count.min(lines.len()));
            let start: usize = lines[..at].iter().map(|line| line.len()).sum();
            if dice.one_in(3) {
                let gone = (at..lines.len()).take(1 + dice.below(3));
                let end = start + gone.map(|line| lines[line].len()).sum::<usize>();
                let mut next = document.text.clone();
                next.replace_range(start..end, "");
                document.becomes(next);
                continue;
            }
            let line = dice.of(&LINES);
            if dice.one_in(2) {
                let mut next = document.text.clone();
                next.insert_str(start, line);
                document.becomes(next);
                continue;
            }
            let mut next = document.text.clone();
            next.insert(start, '\n');
            document.becomes(next);
            for (letter, what) in line.trim_end().char_indices() {
                let mut next = document.text.clone();
                next.insert(start + letter, what);
                document.becomes(next);
                if dice.one_in(6) {
                    // A letter in a network meanwhile.
                    let mut next = document.text.clone();
                    let end = next.rfind(" )").unwrap_or(next.len());
                    next.insert(end, '1');
                    document.becomes(next);
                }
            }
        }
    }
}

/// Half a declaration says no type, so that the places of its tag do; and of a name that is declared twice nobody knows which
/// is meant.
#[test]
fn what_half_a_declaration_leaves_open() {
    let program = |declared: &str, drawn: &str| {
        format!(
            "VAR\n    a, b : BOOL;\n{declared}    c : INT;\nEND_VAR\n\n+--[ ]( a )--( )( b )--+\n\n{drawn}\n"
        )
    };
    let timed = "+--[ ]( b )--[TON]( z, T#1s )--( )( a )--+";
    let moved = "+--[ ]( b )--[MOV]( 300, z )--+\n\n+--[ ]( z )--( )( a )--+";
    let half = "    z;\n";
    for texts in [
        vec![
            program(half, ""),
            program(half, timed),
            program(half, moved),
            program("    z : INT;\n", moved),
        ],
        vec![
            program("", moved),
            program("    z;\n    z;\n", moved),
            program("    z : BOOL;\n    z;\n", moved),
            program("    z : BOOL;\n", moved),
        ],
        vec![
            program("", "+--[MOV]( 300, c )--[ ]( c )--+"),
            program("    c;\n", "+--[MOV]( 300, c )--[ ]( c )--+"),
            program("    cc;\n", "+--[MOV]( 300, c )--[ ]( c )--+"),
        ],
    ] {
        let mut document = Document::new(String::new());
        for text in texts {
            document.becomes(text);
        }
    }
}

/// A network that is put between two sections is above what the second declares.
#[test]
fn networks_between_sections() {
    let section = |name: &str| format!("VAR\n    {name} : BOOL;\nEND_VAR\n\n");
    let drawn = "+--[ ]( a )--( )( b )--+\n\n";
    for declared in ["a", "never_used", "b"] {
        let (first, second) = (section("a"), section(declared));
        let mut document = Document::new(format!("{first}{second}{drawn}"));
        document.becomes(format!("{first}+--[ ]( c )--( )( c )--+\n\n{second}{drawn}"));
        document.becomes(format!("{first}+--[ ]( cc )--( )( c )--+\n\n{second}{drawn}"));
        document.becomes(format!("{first}{second}{drawn}"));
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

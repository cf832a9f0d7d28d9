//! The same for edits of declarations, whose names, types and initial values decide about networks elsewhere.

use crate::incremental::{Document, asked, settings, type_in_an_operand};
use ladder_tests::generator::Dice;

/// Names are close to each other: a letter more or less makes one of another.
const DECLARED: [&str; 5] = [
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
    "\
VAR
    held AT %QX0.1 : BOOL;
    n AT %MW3 : INT;
    m : INT;
END_VAR
VAR_OUTPUT
    lamp, y AT %QX0.1 : BOOL;
    nn AT %MW03 : WORD;
END_VAR
",
];

const RUNGS: [&str; 16] = [
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
    "+--[ ]( %QX0.1 )--(S)( %qx00.1 )--[MOV]( %MW3, 16#5 )--+\n\n",
    "FUNCTION_BLOCK [$H]\nVAR own AT %QX0.1 : BOOL; w AT %MW3 : UINT; END_VAR\n\
     +--[ ]( EN )--(R)( own )--[MOV]( w, 3 )--+\nEND_FUNCTION_BLOCK\n\n",
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
                let words: Vec<usize> = next
                    .match_indices(char::is_alphanumeric)
                    .map(|(at, _)| at)
                    .take_while(|at| *at < declared.len())
                    .collect();
                if !words.is_empty() {
                    next.remove(dice.of(&words));
                    document.becomes(next);
                }
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

/// Lines whose names many others have, of one type or another; some cannot be read to their end, some say no type.
const REPEATING: [&str; 14] = [
    "    a : BOOL;\n",
    "    A, b : BOOL;\n",
    "    a, c : INT;\n",
    "    b, d, b : BOOL;\n",
    "    c := 3;\n",
    "    c : INT := 7;\n",
    "    d : TON;\n",
    "    d : DINT := 70000;\n",
    "    e : BOO;\n",
    "    e, a : REAL\n",
    "    e;\n",
    "    b : INT := TRUE;\n",
    "    c AT %MW3 : INT;\n",
    "    f : BOOL;\n",
];

const NAMING: [&str; 10] = [
    "+--[ ]( a )--[/]( b )--( )( e )--+\n\n",
    "+--[ ]( e )--[/]( e )--( )( A )--+\n\n",
    "+--[ ]( b )--(S)( f )--( )( f )--+\n\n",
    "+--[GT]( c, 5 )--[MOV]( c, g )--+\n\n",
    "+--[MOV]( 300, d )--[ ]( d )--( )( b )--+\n\n",
    "+--[ ]( f )--[TON]( d, T#1s )--( )( a )--+\n\n",
    "+--[ ]( f )--[TON]( c, T#1s )--( )( b )--+\n\n",
    "+--[ADD]( d, e, c )--[EQ]( e, 2.5 )--( )( f )--+\n\n",
    "+--[ ]( d.Q )--( )( b1 )--+\n\n",
    "+--[ ]( a )--[/]( b1 )--( )( g )--+\n\n",
];

/// Names that several lines declare: the first of them counts, and which that is changes as lines come, go and are typed.
#[test]
fn names_that_are_declared_again() {
    let sections = [
        "VAR\n",
        "VAR_INPUT\n",
        "VAR_OUTPUT\n",
        "VAR_GLOBAL\n",
        "VAR CONSTANT\n",
    ];
    for seed in 0..asked(60) {
        let mut dice = Dice::new(seed);
        let declared =
            |dice: &mut Dice| -> String { (0..dice.below(4)).map(|_| dice.of(&REPEATING)).collect() };
        let mut text = String::new();
        for section in 0..2 + dice.below(2) {
            // Mostly plain sections, which are followed.
            let kind = if dice.one_in(4) {
                dice.of(&sections)
            } else {
                sections[section]
            };
            text += &format!("{kind}{}END_VAR\n", declared(&mut dice));
            if dice.one_in(8) {
                text += &format!(
                    "FUNCTION_BLOCK [$F{section}]\nVAR_INPUT\n{}END_VAR\n+--[ ]( a )--( )( ENO )--+\n\
                     END_FUNCTION_BLOCK\n",
                    declared(&mut dice)
                );
            }
        }
        text += "\n";
        text.extend((0..2 + dice.below(5)).map(|_| dice.of(&NAMING)));
        let mut document = Document::with(text, settings(&mut dice));
        for _ in 0..20 {
            let mut lines: Vec<String> = document.text.split_inclusive('\n').map(str::to_owned).collect();
            let in_sections: Vec<usize> = (0..lines.len())
                .filter(|&line| lines[line].starts_with("    ") || lines[line].starts_with("END_VAR"))
                .collect();
            let at = dice.of(&in_sections);
            let before = document.text.clone();
            match dice.below(6) {
                0 => lines.insert(at, dice.of(&REPEATING).to_owned()),
                1 if lines[at].starts_with("    ") => {
                    lines.remove(at);
                }
                // A letter more, or one less.
                2 if lines[at].starts_with("    ") => lines[at].insert_str(5, dice.of(&["1", "b", ", d"])),
                3 if lines[at].starts_with("    ") => {
                    let letter = 4 + dice.below(lines[at].len() - 4);
                    lines[at].remove(letter);
                }
                4 => lines.push(dice.of(&NAMING).to_owned()),
                _ => {
                    let rungs: Vec<usize> = (0..lines.len())
                        .filter(|&line| lines[line].starts_with('+'))
                        .collect();
                    type_in_an_operand(&mut lines[dice.of(&rungs)], &["1", "b"], &mut dice);
                }
            }
            document.becomes(lines.concat());
            if dice.one_in(3) {
                document.becomes(before);
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

/// The value of a constant decides about what is found in networks: an index, a comparison, a divisor, a preset.
#[test]
fn the_value_of_a_constant() {
    let program = |constants: &str| {
        format!(
            "VAR CONSTANT\n    first : INT := 1;\n{constants}END_VAR\nVAR\n    list : ARRAY[0..5] OF INT;\n    small : SINT;\n\
             \x20   wait : TON;\nEND_VAR\n\n\
             +--[MOV]( small, n )--[MOV]( list[n], 7 )--[DIV]( list[0], list[1], n )--( )( Q1 )--+\n\n\
             +--[GT]( n, 3 )--( )( Q2 )--+\n\n\
             +--[ ]( I1 )--[TON]( wait, t )--( )( Q3 )--+\n\n\
             +--[CALC]( list[2], n * 40000 )--[GT]( list[first], n )--( )( Q4 )--+\n"
        )
    };
    let mut document = Document::with(
        program("    n : INT := 5;\n    t : TIME := 5s;\n"),
        settings(&mut Dice::new(0)),
    );
    for constants in [
        "    n : INT := 6;\n    t : TIME := 5s;\n",
        "    n : INT := 0;\n    t : TIME := 5ms;\n",
        "    n : INT := 2;\n    t : TIME := -5ms;\n",
        "    n : INT := 300;\n    t : TIME := T#0s;\n",
        "    n : INT := -1;\n",
        "    n : DINT;\n    t : TIME := 5s;\n",
        "    n : INT := ;\n    t : TIME := 5s;\n",
        "    n, t : INT := 4;\n",
        "    n : REAL := 2.5;\n    t : TIME := 5s;\n",
        "    t : TIME := 5s;\n    n : INT := 6;\n    n : INT := 1;\n",
        "    n : INT := 1;\n    t : TIME := 5s;\n",
    ] {
        document.becomes(program(constants));
    }
}

/// What is done by one of the names of an address is done to all of them.
#[test]
fn names_of_one_address() {
    let program = |rung: &str| {
        format!(
            "VAR\n    held, lamp AT %QX0.1 : BOOL;\n    level AT %MD3 : REAL;\nEND_VAR\n\
             VAR_OUTPUT\n    high AT %QX0.2 : BOOL;\nEND_VAR\n\n\
             FUNCTION_BLOCK [$High]\nVAR own AT %QX0.2 : BOOL; n AT %MD4 : REAL; END_VAR\n\
             +--[ ]( EN )--[MOV]( n, 1.0 )--( )( own )--+\nEND_FUNCTION_BLOCK\n\n\
             +--[ ]( I1 )--(S)( held )--+\n\n\
             {rung}\n\n\
             +--[ ]( lamp )--[$High]( )--[GT]( level, 1.0 )--( )( Q2 )--+\n"
        )
    };
    let mut document = Document::new(program("+--[ ]( I2 )--( )( Q1 )--+"));
    for rung in [
        "+--[ ]( I2 )--(R)( lamp )--+",
        "+--[ ]( lamp )--( )( Q1 )--+",
        "+--[ ]( I2 )--(S)( lamp )--+",
        "+--[ ]( I2 )--[EQ]( %MD4, 16#5 )--( )( Q1 )--+",
        "+--[ ]( I2 )--[MOV]( %MD04, 16#5 )--(R)( %QX00.1 )--+",
        "+--[ ]( I2 )--( )( Q1 )--+",
    ] {
        document.becomes(program(rung));
    }
}

/// An address that a declaration has no longer is free, and one that it has now is its own.
#[test]
fn addresses_that_come_and_go() {
    let program = |declared: &str, named: &str| {
        format!(
            "VAR_OUTPUT\n    x : BOOL;\n{declared}    z AT %QX0.3 : BOOL;\nEND_VAR\n\n+--[ ]( I1 )--( )( y )--+\n\n\
             +--[ ]( {named} )--( )( z )--( )( x )--+\n"
        )
    };
    let (one, two) = ("    y AT %QX0.1 : BOOL;\n", "    y AT %QX0.2 : BOOL;\n");
    let mut document = Document::new(program(one, "y"));
    for (declared, named) in [
        (two, "y"),
        (two, "%QX0.1"),
        (two, "%QX0.2"),
        (one, "%QX0.2"),
        (one, "x"),
        ("", "x"),
        ("", "%QX0.1"),
        ("    y : BOOL;\n", "%QX0.1"),
        ("    y : BOOL;\n", "y"),
        (one, "y"),
        (one, "%QX0.1"),
        ("    y AT %QX0.3 : BOOL;\n", "y"),
        ("    y, w AT %QX0.2 : BOOL;\n", "y"),
        ("    y AT %QB0 : BYTE;\n", "I2"),
        (two, "I2"),
    ] {
        document.becomes(program(declared, named));
    }
}

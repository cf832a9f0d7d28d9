//! The same for tags whose types follow from their places and their company: an edit of one gives others another type.

use crate::incremental::{Document, asked, settings, type_in_an_operand};
use ladder_tests::generator::Dice;

const NAMES: [&str; 9] = [
    "level", "limit", "total", "count", "speed", "rate", "t", "I1", "%QW3",
];

const VALUES: [&str; 8] = [
    "5",
    "2.5",
    "T#3s",
    "'text'",
    "t.ET",
    "-7",
    "level + 2.5",
    "D#2024-01-02",
];

const DECLARED: [&str; 5] = [
    "",
    "",
    "VAR\n    level : REAL;\n    t : TON;\nEND_VAR\n\n",
    "VAR\n    total, count : TIME;\nEND_VAR\nVAR\n    limit : NOTHING;\nEND_VAR\n\n",
    "VAR CONSTANT\n    rate : REAL := 1.5;\nEND_VAR\n\n",
];

fn rung(dice: &mut Dice) -> String {
    let mut value = || match dice.below(3) {
        0 => dice.of(&VALUES).to_owned(),
        _ => dice.of(&NAMES).to_owned(),
    };
    let (first, second, third) = (value(), value(), value());
    let name = dice.of(&NAMES);
    match dice.below(9) {
        0 => format!("+--[GT]( {first}, {second} )--( )( done )--+\n\n"),
        1 => format!("+--[MOV]( {name}, {first} )--+\n\n"),
        2 => format!("+--[ADD]( {name}, {first}, {second} )--[EQ]( {name}, {third} )--( )( done )--+\n\n"),
        3 => format!("+--[TON]( {name}, {first} )--( )( done )--+\n\n"),
        4 => format!("+--[ ]( {name} )--( )( done )--+\n\n"),
        5 => format!("+--[ ]( {name}.Q )--[GT]( {name}.ET, {first} )--( )( done )--+\n\n"),
        6 => format!("+--[ ]( done )--(R)( {name} )--+\n\n"),
        7 => format!("+--[SQRT]( {name}, {first} )--+\n\n"),
        _ => format!("+--[CTU]( {name}, {second} )--(S)( {first} )--+\n\n"),
    }
}

#[test]
fn types_that_follow_from_others() {
    for seed in 0..asked(80) {
        let mut dice = Dice::new(seed);
        let declared = dice.of(&DECLARED);
        let count = 2 + dice.below(12);
        let mut rungs: Vec<String> = (0..count).map(|_| rung(&mut dice)).collect();
        let text = |rungs: &[String]| format!("{declared}{}", rungs.concat());
        let mut document = Document::with(text(&rungs), settings(&mut dice));
        for _ in 0..10 {
            let at = dice.below(rungs.len());
            match dice.below(5) {
                0 => rungs.insert(at, rung(&mut dice)),
                1 if rungs.len() > 2 => {
                    rungs.remove(at);
                }
                2 => rungs[at] = rung(&mut dice),
                3 => type_in_an_operand(&mut rungs[at], &["a", "t", "1", ".5", " "], &mut dice),
                _ => {
                    // A line of declarations comes and goes.
                    let lines: Vec<&str> = document.text.split_inclusive('\n').collect();
                    let (above, below) = lines.split_at(dice.below(declared.lines().count().max(1)));
                    let line = dice.of(&[
                        "    speed : REAL;\n",
                        "    level, limit : INT;\n",
                        "    total : TIME;\n",
                        "    count : NOTHING;\n",
                        "    t : TOF;\n",
                    ]);
                    document.becomes([above.concat().as_str(), line, &below.concat()].concat());
                }
            }
            document.becomes(text(&rungs));
        }
    }
}

/// A chain of tags, each of which has its type from the one above it: the first value decides about all.
#[test]
fn one_value_decides_about_a_chain() {
    let program = |first: &str, link: &str| {
        format!(
            "+--[MOV]( a, {first} )--+\n\n+--[MOV]( b, a )--+\n\n+--[MOV]( c, {link} )--+\n\n+--[MOV]( d, c )--+\n\n\
             +--[GT]( d, e )--( )( done )--+\n"
        )
    };
    let mut document = Document::new(program("5", "b"));
    for (first, link) in [
        ("5.0", "b"),
        ("5.0", "x"),
        ("5.0", "b"),
        ("T#5s", "b"),
        ("T#5s", "7"),
        ("'five'", "7"),
        ("'five'", "b"),
        ("5", "b"),
    ] {
        document.becomes(program(first, link));
    }
}

/// Two places that ask for two types are said at the tag; the finding comes and goes with either.
#[test]
fn places_that_disagree() {
    let program = |first: &str, above: &str, second: &str| {
        format!("{first}\n\n{above}+--[ ]( start )--( )( done )--+\n\n{second}\n")
    };
    let (timer, contact) = ("+--[TON]( t, T#1s )--( )( on )--+", "+--[ ]( t )--( )( off )--+");
    let note = "+--[ ]( stop )--( )( halt )--+\n\n";
    let mut document = Document::new(program(timer, "", contact));
    for (first, above, second) in [
        (timer, note, contact),
        (contact, note, timer),
        (contact, "", timer),
        (contact, "", contact),
        (timer, "", contact),
        (timer, note, timer),
    ] {
        document.becomes(program(first, above, second));
    }
}

/// Two tags of one network get each other's types, and two at once new ones.
#[test]
fn types_that_are_exchanged() {
    let program = |first: &str, second: &str| {
        format!(
            "VAR\n    first : {first};\n    second : {second};\nEND_VAR\n\n+--[ ]( first )--( )( done )--+\n\n\
             +--[GT]( first, second )--( )( more )--+\n\n+--[ADD]( second, first, 5 )--+\n"
        )
    };
    let types = ["BOOL", "INT", "DINT", "REAL", "LREAL", "TIME", "WORD"];
    let mut document = Document::new(program("DINT", "DINT"));
    for first in types {
        for second in types {
            document.becomes(program(first, second));
            document.becomes(program(second, first));
            document.becomes(program("DINT", "DINT"));
        }
    }
}

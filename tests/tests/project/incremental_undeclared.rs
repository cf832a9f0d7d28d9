//! The same for names that no declaration has: what is said of one depends on others that are near to it, on how many there
//! are, and on whether the file declares any.

use crate::incremental::{Document, asked, settings, type_in_an_operand};
use ladder_tests::generator::Dice;

/// Names that are a letter or two away from each other.
const NAMES: [&str; 14] = [
    "lamp", "lump", "limp", "lamps", "Lamp", "clamp", "start", "strat", "stat", "starts", "pump", "pumps",
    "I1", "list[2]",
];

const DECLARED: [&str; 5] = [
    "",
    "",
    "VAR\n    lamp : BOOL;\n    start : BOOL;\nEND_VAR\n\n",
    "VAR_INPUT\n    start, stop : BOOL;\nEND_VAR\nVAR_OUTPUT\n    lamp : BOOL;\nEND_VAR\nVAR CONSTANT\n    most : INT := 3;\nEND_VAR\n\n",
    "FUNCTION_BLOCK [$F]\nVAR_INPUT\n    x : BOOL;\nEND_VAR\n+--[ ]( x )--[ ]( lamp )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n\n",
];

fn rung(dice: &mut Dice) -> String {
    let mut name = || {
        let name = dice.of(&NAMES);
        // Enough of them that not all are compared.
        match dice.below(3) {
            0 => format!(
                "{name}{}",
                ["_a", "_b", "_c", "_d", "_e", "_f", "_g", "_h"][dice.below(8)]
            ),
            _ => name.to_owned(),
        }
    };
    let (first, second, third) = (name(), name(), name());
    match dice.below(5) {
        0 => format!("+--[GT]( {first}, 5 )--[MOV]( 3, {second} )--+\n\n"),
        1 => format!("+--[TON]( {first}, T#1s )--( )( {second} )--+\n\n"),
        _ => format!("+--[ ]( {first} )--[/]( {second} )--( )( {third} )--+\n\n"),
    }
}

#[test]
fn names_that_come_and_go() {
    for seed in 0..asked(40) / 2 {
        let mut dice = Dice::new(seed);
        let declared = dice.of(&DECLARED);
        let count = 2 + dice.below(30);
        let mut rungs: Vec<String> = (0..count).map(|_| rung(&mut dice)).collect();
        let text = |declared: &str, rungs: &[String]| format!("{declared}{}", rungs.concat());
        let mut document = Document::with(text(declared, &rungs), settings(&mut dice));
        for _ in 0..10 {
            let at = dice.below(rungs.len());
            match dice.below(6) {
                0 => rungs.insert(at, rung(&mut dice)),
                1 if rungs.len() > 2 => {
                    rungs.remove(at);
                }
                2 => rungs[at] = rung(&mut dice),
                3 => type_in_an_operand(&mut rungs[at], &["a", "t", "s", "1"], &mut dice),
                4 => {
                    let names = [
                        "    lamp : BOOL;\n",
                        "    clamp : BOOL;\n",
                        "    pump : BOOL;\n",
                        "    stat, strat : BOOL;\n",
                    ];
                    let lines: Vec<&str> = document.text.split_inclusive('\n').collect();
                    let within = declared.lines().count().min(lines.len()).max(1);
                    let (above, below) = lines.split_at(dice.below(within));
                    document.becomes([above.concat().as_str(), dice.of(&names), &below.concat()].concat());
                }
                _ => {
                    // A section that is not closed, or none at all, and back.
                    let other = match dice.below(3) {
                        0 => declared.replacen("END_VAR", "", 1),
                        1 => String::new(),
                        _ => "VAR\n    pump : BOOL;\nEND_VAR\n\n".to_owned(),
                    };
                    document.becomes(text(&other, &rungs));
                }
            }
            document.becomes(text(declared, &rungs));
        }
    }
}

/// A name is near to another one that is used often, and that decides: here it is used once more, or once less.
#[test]
fn uses_elsewhere_decide_about_a_slip() {
    let program = |above: &str, drawn: &str| {
        format!(
            "+--[ ]( gate )--( )( done )--+\n\n{above}+--[ ]( lump )--( )( done )--+\n\n{drawn}+--[ ]( lamp )--( )( done )--+\n"
        )
    };
    let other = "+--[ ]( lamp )--( )( gate )--+\n\n";
    let nearer = "+--[ ]( limp )--[ ]( limp )--( )( gate )--+\n\n";
    let mut document = Document::new(program("", ""));
    for (above, drawn) in [
        ("", other),
        ("", ""),
        (other, ""),
        (nearer, other),
        (nearer, ""),
        ("", ""),
    ] {
        document.becomes(program(above, drawn));
    }
}

/// A name that is declared, or is no longer, is the nearest to one that is not.
#[test]
fn declared_names_decide_about_suggestions() {
    let program = |declared: &str| {
        format!(
            "VAR_INPUT\n    gate : BOOL;\n{declared}    done : BOOL;\nEND_VAR\n\n+--[ ]( gate )--( )( done )--+\n\n\
             +--[ ]( lamp )--( )( done )--+\n"
        )
    };
    let mut document = Document::new(program(""));
    for declared in [
        "",
        "    lump : BOOL;\n",
        "    lump, limp : BOOL;\n",
        "    limp : BOOL;\n",
        "    limps : BOOL;\n",
        "",
    ] {
        document.becomes(program(declared));
    }
}

/// Only the first names of a file are compared with the declared ones: which these are is another matter when a network
/// above them comes or goes.
#[test]
fn names_above_decide_whether_one_is_compared() {
    let rung = |name: &str| format!("+--[ ]( {name} )--( )( done )--+\n\n");
    let above: String = ["one", "two", "six", "ten"]
        .iter()
        .flat_map(|first| {
            ["red", "blue", "green", "grey", "black"].map(|second| rung(&format!("{first}_{second}")))
        })
        .collect();
    let program = |first: &str, near: &str| {
        format!(
            "VAR_OUTPUT\n    lump, done : BOOL;\nEND_VAR\n\n{}{first}{above}{}",
            rung("lump"),
            rung(near)
        )
    };
    let another = rung("another");
    let mut document = Document::new(program(&another, "lamp"));
    let without = above.replacen(&rung("one_red"), "", 1);
    for first in ["", another.as_str(), ""] {
        document.becomes(program(first, "lamp"));
        let fewer = program(first, "lamp").replace(&above, &without);
        document.becomes(fewer);
    }
}

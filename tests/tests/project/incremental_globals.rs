//! The same with tags for all files: declared here, used by name, used by way of VAR_EXTERNAL. Somebody types in their uses and
//! declarations, now in one file, now in another.

use crate::incremental::{asked, type_in_an_operand};
use crate::incremental_files::Files;
use ladder_tests::generator::Dice;

/// What a file may begin with.
const SECTIONS: [&str; 19] = [
    "VAR_GLOBAL\n    ready, done : BOOL;\n    total : DINT := 3;\nEND_VAR\n",
    "VAR_GLOBAL\n    wait : TON;\n    unused : BOOL;\nEND_VAR\n",
    "VAR_GLOBAL\n    level AT %MW3 : INT;\n    open AT %QX0.1 : BOOL;\nEND_VAR\n",
    "VAR_GLOBAL CONSTANT\n    most : DINT := 5;\nEND_VAR\n",
    "VAR_GLOBAL RETAIN\n    kept : REAL;\nEND_VAR\n",
    "VAR_GLOBAL\n    done : INT;\nEND_VAR\n",
    "VAR_EXTERNAL\n    ready : BOOL;\n    total : DINT;\nEND_VAR\n",
    "VAR_EXTERNAL\n    wait : TON;\nEND_VAR\n",
    "VAR_INPUT\n    go, off : BOOL;\nEND_VAR\n",
    "VAR_OUTPUT\n    lamp, beep : BOOL;\nEND_VAR\n",
    "VAR\n    own, done : BOOL;\n    count : DINT;\nEND_VAR\n",
    "VAR\n    wait, pause : TON;\nEND_VAR\n",
    "FUNCTION_BLOCK [$Hold]\nVAR_INPUT\n    a : BOOL;\nEND_VAR\nVAR_OUTPUT\n    q : BOOL;\nEND_VAR\n\
     +--[ ]( a )--( )( q )--+\nEND_FUNCTION_BLOCK\n",
    "FUNCTION_BLOCK [$Bare]\n+--[ ]( EN )--[ ]( %IX0.1 )--[ ]( ready )--( )( %QX0.1 )--+\n+--[ ]( Done )--( )( ENO )--+\n\
     END_FUNCTION_BLOCK\n",
    "FUNCTION_BLOCK [$Wait]\nVAR\n    pause : TON;\nEND_VAR\nVAR_EXTERNAL\n    wait : TON;\nEND_VAR\n\
     +--[ ]( EN )--[TON]( pause, T#2s )--[ ]( wait.Q )--[ ]( %ix0.1 )--( )( done )--+\n\
     +--[ ]( %IX0.2 )--[TON]( wait, T#3s )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n",
    "FUNCTION_BLOCK [$Sum]\nVAR_EXTERNAL\n    total : DINT;\nEND_VAR\n\
     +--[ ]( EN )--[ADD]( total, 1, total )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n",
    "FUNCTION_BLOCK [$Slack]\nVAR_INPUT\n    in : DINT;\nEND_VAR\n\
     +--[ ]( EN )--[MOV]( in, spare )--[GT]( spare, more )--( )( loose )--+\n+--[TON]( clock, T#1s )--(R)( Lamp )--+\n\
     +--[ ]( loose )--[ ]( Clock.Q )--[ADD]( more, extra, total )--( )( M1 )--+\nEND_FUNCTION_BLOCK\n",
    "FUNCTION_BLOCK [$Far]\nVAR_EXTERNAL\n    far : BOOL;\n    ready : INT;\nEND_VAR\n\
     +--[ ]( far )--[GT]( ready, 3 )--( )( fresh )--+\n+--[ ]( fresh )--(S)( lamp )--+\nEND_FUNCTION_BLOCK\n",
    "VAR_EXTERNAL\n    far : BOOL;\n    wait : BOOL;\nEND_VAR\n",
];

const RUNGS: [&str; 22] = [
    "+--[ ]( go )--( )( ready )--+\n\n",
    "+--[ ]( ready )--( )( done )--+\n\n",
    "+--[ ]( Done )--[/]( own )--( )( lamp )--+\n\n",
    "+--[ ]( done )--(S)( own )--+\n\n",
    "+--[ ]( off )--[TON]( wait, T#1s )--( )( beep )--+\n\n",
    "+--[ ]( wait.Q )--( )( lamp )--+\n\n",
    "+--[ ]( off )--[TON]( pause, T#1s )--( )( wait )--+\n\n",
    "+--[GT]( total, most )--( )( beep )--+\n\n",
    "+--[MOV]( 70000, level )--[EQ]( %MW3, 7 )--( )( open )--+\n\n",
    "+--[MOV]( total, most )--[MOV]( 7, total )--+\n\n",
    "+--[GT]( kept, 2.5 )--[MOV]( kept, count )--( )( %QX0.1 )--+\n\n",
    "+--[MOV]( fresh, kept )--[LT]( fresh, other )--( )( lamp )--+\n\n",
    "+--[$Hold]( ready, done )--+\n\n",
    "+--[$Sum]()--( )( lamp )--+\n\n",
    "+--[$Bare]()--[$Wait]()--( )( lamp )--+\n\n",
    "+--[ ]( %IX0.1 )--( )( %QX0.1 )--+\n\n",
    "+--[ ]( %ix0.2 )--[ ]( READY )--( )( beep )--+\n\n",
    "+--[ ]( M1 )--( )( M2 )--+\n\n",
    "+--[ ]( ready )--[ ]( \n\n",
    "+--[ ]( far )--[$Slack]( 5 )--[$Far]()--( )( loose )--+\n\n",
    "+--[MOV]( more, spare )--(R)( clock )--( )( far )--+\n\n",
    "+--[GT]( spare, fresh )--( )( lamp )--+\n\n",
];

/// What is typed behind the first letter of an operand.
const LETTERS: [&str; 5] = ["x", "5", "_", ".Q", "e"];

/// Lines of declarations that come.
const LINES: [&str; 7] = [
    "    fresh : BOOL;\n",
    "    total : INT;\n",
    "    done, ready : BOOL;\n",
    "    done\n",
    "    level : INT := 4;\n",
    "    M1 : TON;\n",
    "\n",
];

/// One edit of a text, as somebody makes it who types.
fn next(text: &str, dice: &mut Dice) -> String {
    let mut lines: Vec<String> = text.split_inclusive('\n').map(str::to_owned).collect();
    let place = |dice: &mut Dice, lines: &[String], wanted: &dyn Fn(&str) -> bool| {
        let all: Vec<usize> = (0..lines.len()).filter(|line| wanted(&lines[*line])).collect();
        (!all.is_empty()).then(|| dice.of(&all))
    };
    let is_rung = |line: &str| line.starts_with('+');
    let is_declaration = |line: &str| line.starts_with("    ");
    match dice.below(8) {
        0..=2 => {
            if let Some(line) = place(dice, &lines, &is_rung) {
                type_in_an_operand(&mut lines[line], &LETTERS, dice);
            }
        }
        3 => lines.push(dice.of(&RUNGS).to_owned()),
        4 => {
            if let Some(line) = place(dice, &lines, &is_rung) {
                lines.remove(line);
            }
        }
        5 => {
            if let Some(line) = place(dice, &lines, &is_declaration) {
                lines.insert(line, dice.of(&LINES).to_owned());
            }
        }
        6 => {
            if let Some(line) = place(dice, &lines, &is_declaration) {
                lines.remove(line);
            }
        }
        _ => {
            if let Some(line) = place(dice, &lines, &is_declaration) {
                let at = 4 + dice.below(3);
                if lines[line].is_char_boundary(at) {
                    lines[line].insert_str(at, dice.of(&LETTERS));
                }
            }
        }
    }
    lines.concat()
}

fn program(dice: &mut Dice, sections: &[&str]) -> String {
    let mut head: Vec<&str> = (0..dice.below(4)).map(|_| dice.of(sections)).collect();
    head.dedup();
    let drawn: String = (0..=dice.below(8)).map(|_| dice.of(&RUNGS)).collect();
    format!("{}\n{drawn}", head.concat())
}

/// Edits of files that declare and use each other's tags.
#[test]
fn typing_where_tags_are_for_all_files() {
    for seed in 0..asked(60) {
        let mut dice = Dice::new(seed);
        // In some workspaces no file has a definition, in some nobody writes VAR_EXTERNAL.
        let sections = match seed % 4 {
            0 => &SECTIONS[..],
            1 => &SECTIONS[..12],
            _ => &[&SECTIONS[..6], &SECTIONS[8..12]].concat(),
        };
        let mut files = Files::default();
        for name in ["line", "panel", "plant"] {
            let text = program(&mut dice, sections);
            files.becomes(name, text);
        }
        for _ in 0..15 {
            let name = dice.of(&["line", "line", "panel", "plant"]);
            let before = files.text(name).to_owned();
            let after = next(&before, &mut dice);
            files.becomes(name, after);
            if dice.one_in(3) {
                files.becomes(name, before);
            }
        }
    }
}

/// Of what other files do with a tag, and how they declare it, each change is followed.
#[test]
fn what_others_say_of_a_tag() {
    let declares = |ty: &str| format!("VAR_GLOBAL\n    all : {ty};\nEND_VAR\n\n+--[ ]( I1 )--( )( Q1 )--+\n");
    let uses =
        |drawn: &str| format!("VAR_OUTPUT\n    y : BOOL;\nEND_VAR\n\n+--[ ]( I2 )--( )( y )--+\n\n{drawn}\n");
    let (reads, writes) = ("+--[ ]( all )--( )( Q2 )--+", "+--[ ]( I3 )--( )( all )--+");
    let (times, asks) = (
        "+--[ ]( I4 )--[TON]( all, T#1s )--+",
        "+--[ ]( all.Q )--( )( Q2 )--+",
    );
    for (first, second) in [("a", "b"), ("b", "a")] {
        let mut files = Files::default();
        files.becomes(first, declares("BOOL"));
        files.becomes(second, uses(""));
        for text in [
            uses(reads),
            uses(writes),
            uses(&[reads, writes].join("\n\n")),
            uses(""),
        ] {
            files.becomes(second, text);
        }
        files.becomes(second, uses(reads));
        for ty in ["BOOL := TRUE", "DINT", "BOOL", "TON", "BOOL"] {
            files.becomes(first, declares(ty));
        }
        files.becomes(first, declares("TON"));
        for (here, there) in [
            (times, ""),
            (times, asks),
            (times, times),
            ("", times),
            (asks, ""),
            ("", ""),
        ] {
            files.becomes(first, format!("{}\n{here}\n", declares("TON")));
            files.becomes(second, uses(there));
        }
        // A reset reads and writes it as its block does, and keeps no state in it.
        let resets = "+--[ ]( I5 )--(R)( all )--+";
        files.becomes(first, format!("{}\n{times}\n", declares("TON")));
        for there in [
            &[asks, resets].join("\n\n"),
            &[asks, resets, times].join("\n\n"),
            resets,
        ] {
            files.becomes(second, uses(there));
        }
        files.becomes(first, declares("TON").replace("all", "al"));
        files.becomes(second, uses(asks));
        files.becomes(first, declares("TON"));
        files.close(first);
        files.close(second);
    }
}

/// Another file may have used a name before this one declares it for all.
#[test]
fn a_tag_that_others_name_already() {
    let declares = |name: &str| {
        format!(
            "VAR_GLOBAL\n    {name}, x : BOOL;\nEND_VAR\n\n+--[ ]( I1 )--( )( x )--+\n\n+--[ ]( x )--( )( Q1 )--+\n"
        )
    };
    for drawn in ["+--[ ]( all )--( )( Q2 )--+\n", "+--[ ]( I2 )--( )( all )--+\n"] {
        let mut files = Files::default();
        files.becomes("a", declares("al"));
        files.becomes("b", drawn.to_owned());
        for name in ["all", "alll", "all", "al"] {
            files.becomes("a", declares(name));
        }
    }
}

/// What a body names of the file's tags has the order and the spelling of its first places in the body.
#[test]
fn rungs_of_a_body_that_come_and_go() {
    let rungs = [
        "+--[ ]( %IX0.1 )--[ ]( READY )--( )( %QX0.1 )--+\n\n",
        "+--[ ]( EN )--[/]( Done )--[ ]( %ix0.1 )--(S)( ENO )--+\n\n",
        "+--[ ]( %QX0.1 )--[ ]( done )--[/]( ready )--[ ]( %IX0.1 )--(R)( ENO )--+\n\n",
    ];
    let drawn = |body: &[&str]| {
        format!(
            "VAR_GLOBAL\n    ready, done : BOOL;\nEND_VAR\n\nFUNCTION_BLOCK [$Bare]\n{}END_FUNCTION_BLOCK\n\n\
             +--[ ]( I1 )--( )( ready )--( )( done )--[$Bare]()--( )( %QX0.2 )--+\n\n+--[ ]( %QX0.1 )--( )( Q1 )--+\n",
            body.concat()
        )
    };
    let alike = rungs.map(str::to_uppercase);
    // With a connector that has no partner, so that the rung below is not read as it is drawn.
    let open = "+--[ ]( EN )--\\--( )( ENO )--+\n";
    for [first, second, third] in [rungs, alike.each_ref().map(String::as_str)] {
        let mut files = Files::default();
        for body in [
            &[first, second, third][..],
            &[second, third],
            &[first, second, third],
            &[first, third],
            &[third, first, second],
            &[third, second],
            &[second, first, third],
            &[second, open, first, third],
            &[second, open, third],
            &[third],
            &[open, third],
            &[third, third],
        ] {
            files.becomes("line", drawn(body));
        }
    }
}

/// Where a global of another file lies decides about the tags of a file at that place.
#[test]
fn addresses_of_globals_of_other_files() {
    let library = |declared: &str| format!("VAR_GLOBAL\n    {declared};\nEND_VAR\n");
    let program_with = |own: &str, rung: &str| {
        format!(
            "VAR\n    {own};\n    bit AT %MX8.0 : BOOL;\nEND_VAR\n\n\
             +--[GT]( own, 1.0 )--[ ]( bit )--( )( Q1 )--+\n\n{rung}\n"
        )
    };
    let program = |rung: &str| program_with("own AT %MD3 : REAL", rung);
    let mut files = Files::default();
    files.becomes("main", program("+--[ ]( I1 )--( )( Q2 )--+"));
    files.becomes("library", library("level AT %MW1 : INT"));
    for rung in [
        "+--[GT]( level, 5 )--( )( Q2 )--+",
        "+--[GT]( level, 5 )--[EQ]( %MD3, 16#5 )--( )( Q2 )--+",
        "+--[ ]( I1 )--( )( Q2 )--+",
        "+--[MOV]( level, 5 )--+",
    ] {
        files.becomes("main", program(rung));
        for declared in [
            "level AT %MW4 : INT",
            "level AT %MD3 : DINT",
            "level AT %MD03 : REAL",
            "level : INT",
            "level AT %MW1 : INT",
        ] {
            files.becomes("library", library(declared));
        }
        for own in [
            "own AT %MD4 : REAL",
            "own AT %MW1 : INT",
            "own : REAL",
            "own AT %MD3 : REAL",
        ] {
            files.becomes("main", program_with(own, rung));
        }
    }
}

/// A global of another file lies where the file's own networks name it first, or else where a body declares it.
#[test]
fn only_a_body_still_names_a_tag_of_another_file() {
    let program = |rung: &str| {
        format!(
            "FUNCTION_BLOCK [$Wait]\nVAR_EXTERNAL\n    wait : TON;\nEND_VAR\n+--[ ]( EN )--[TON]( wait, T#3s )--( )( ENO )--+\n\
             END_FUNCTION_BLOCK\n\n+--[$Wait]()--( )( Q1 )--+\n\n{rung}\n"
        )
    };
    let mut files = Files::default();
    files.becomes("panel", "VAR_GLOBAL\n    wait : TON;\nEND_VAR\n".to_owned());
    files.becomes("line", program("+--[ ]( wait.Q )--( )( Q2 )--+"));
    for named in ["waits.Q", "wait.Q", "W.Q", "wait.Q"] {
        files.becomes("line", program(&format!("+--[ ]( {named} )--( )( Q2 )--+")));
    }
}

//! The same for programs without mistakes, in which rules look at what networks do to each other: who sets and resets a tag,
//! who reads it before it is written, where jumps and calls lead.

use crate::incremental::{Document, asked, settings};
use ladder_tests::generator::Dice;

/// Definitions and declarations: names that stand for one address, and for tags of the file in a body.
const HEADS: &[&str] = &[
    "VAR_INPUT\n    a, b, c : BOOL;\nEND_VAR\nVAR_OUTPUT\n    y, z : BOOL;\nEND_VAR\n\
     VAR\n    m, k : BOOL;\n    n : INT;\nEND_VAR\n",
    "VAR_INPUT\n    a, b, c : BOOL;\nEND_VAR\nVAR_OUTPUT\n    y, z : BOOL;\nEND_VAR\n\
     VAR\n    m AT %MX0.0 : BOOL;\n    k AT %MX0.0 : BOOL;\n    n : INT;\nEND_VAR\n",
    "FUNCTION_BLOCK [$B]\nVAR_INPUT\n    x : BOOL;\nEND_VAR\n\n+--[ ]( x )--( )( %MX0.0 )--+\n\n\
     +--[ ]( x )--(S)( %MX0.1 )--+\n\n+--[ ]( x )--(R)( %MX0.1 )--+\nEND_FUNCTION_BLOCK\n\
     VAR_INPUT\n    a, b, c : BOOL;\nEND_VAR\nVAR_OUTPUT\n    y, z : BOOL;\nEND_VAR\n\
     VAR\n    m AT %MX0.0 : BOOL;\n    k AT %MX0.0 : BOOL;\n    n : INT;\nEND_VAR\n",
    "FUNCTION_BLOCK <$G>\nVAR_INPUT\n    x : BOOL;\nEND_VAR\n\n+--[ ]( x )--<JMP>( l )--+\n\n\
     +--[ ]( x )--<RET>--+\nEND_FUNCTION_BLOCK\n\
     VAR_INPUT\n    a, b, c : BOOL;\nEND_VAR\nVAR_OUTPUT\n    y, z : BOOL;\nEND_VAR\n\
     VAR\n    m, k : BOOL;\n    n : INT;\nEND_VAR\n",
    "",
];

/// What moves the program on to another place, and what stands for many tags.
const SPECIAL: &[&str] = &[
    "+--<LBL>( l )--[ ]( a )--( )( z )--+",
    "+--<LBL>( e )--[ ]( b )--( )( y )--+",
    "+--[ ]( c )--<JMP>( l )--+",
    "+--[ ]( m )--<JMP>( l )--+",
    "+--[ ]( c )--<JMP>( e )--+",
    "+--<JMP>( l )--+",
    "+--[ ]( c )--<RET>--+",
    "+--<RET>--+",
    "+--[ ]( c )--<END>--+",
    "+--<END>--+",
    "+--<FOR>( n, 1, 3 )--+",
    "+--<NEXT>--+",
    "+--<MCR>--+",
    "+--[ ]( a )--<CALL>( f )--+",
    "+--[ ]( b )--<CALL>( g )--+",
    "+--[ ]( a )--[$B]( a )--+",
    "+--<$G>( a )--+",
    "+--[ADD]( n, n, 1 )--+",
    "+--[GT]( n, 5 )--(S)( y )--+",
    "+--[GT]( n, 5 )--(R)( y )--+",
    "+--[ ]( SYS.FIRST_SCAN )--(R)( m )--+",
    // Two networks run one timer: an error, at the lower one.
    "+--[ ]( a )--[TON]( t, T#1s )--( )( z )--+",
    "+--[ ]( b )--[TON]( t, T#2s )--<RET>--+",
];

/// Contacts in series and a coil or two, of few tags; now and then something of which there is more to say.
fn network(dice: &mut Dice, special: &[&str]) -> String {
    if !special.is_empty() && dice.one_in(3) {
        return format!("{}\n\n", dice.of(special));
    }
    let mut drawn = String::from("+");
    let mut add = |dice: &mut Dice, signs: &[&str], tags: &[&str]| {
        drawn += &format!("--{}( {} )", dice.of(signs), dice.of(tags));
    };
    for _ in 0..dice.below(3) {
        add(
            dice,
            &["[ ]", "[ ]", "[ ]", "[/]"],
            &["a", "m", "m", "k", "%MX0.0"],
        );
    }
    if dice.one_in(2) {
        add(dice, &["(S)", "(R)"], &["y"]);
    } else {
        add(dice, &["( )", "(S)", "(R)"], &["z", "m", "k", "%MX0.0"]);
    }
    drawn + "--+\n\n"
}

#[test]
fn what_networks_do_to_each_other() {
    for seed in 0..asked(120) {
        let mut dice = Dice::new(seed);
        // Of most kinds a program has none.
        let special: Vec<&str> = SPECIAL.iter().copied().filter(|_| dice.one_in(3)).collect();
        let mut head = dice.of(HEADS).to_owned();
        let mut networks: Vec<String> = (0..5).map(|_| network(&mut dice, &special)).collect();
        if dice.one_in(2) {
            for function in ["f", "g"] {
                networks.push(format!("+--<FUN>( {function} )--+\n\n"));
                networks.extend((0..3).map(|_| network(&mut dice, &special)));
                networks.push("+--<RET>--+\n\n".to_owned());
            }
        }
        let text = |head: &str, networks: &[String]| format!("{head}\n{}", networks.concat());
        let mut document = Document::with(text(&head, &networks), settings(&mut dice));
        for _ in 0..40 {
            let at = dice.below(networks.len());
            match dice.below(8) {
                0 if networks.len() < 20 => networks.insert(at, network(&mut dice, &special)),
                1 if networks.len() > 4 => {
                    networks.remove(at);
                }
                2 => networks.insert(at, "# note #\n".to_owned()),
                3 => networks[at] = networks[at].replacen("--", "---", 1),
                // Half-typed, and mended by the next edit.
                4 => {
                    let whole = networks[at].clone();
                    networks[at] = whole.replacen(" )", "", 1);
                    document.becomes(text(&head, &networks));
                    networks[at] = whole;
                }
                5 => networks[at] = networks[at].replacen("( a )", "( b )", 1),
                6 if dice.one_in(4) => dice.of(HEADS).clone_into(&mut head),
                _ => networks[at] = network(&mut dice, &special),
            }
            document.becomes(text(&head, &networks));
        }
    }
}

#[test]
fn what_is_between_two_coils_of_a_latch() {
    let head = "VAR_INPUT\n    a : BOOL;\nEND_VAR\nVAR_OUTPUT\n    y : BOOL;\nEND_VAR\n\
         VAR\n    m AT %MX0.0 : BOOL;\n    k AT %MX0.0 : BOOL;\nEND_VAR\n\n";
    let with = |between: &str| {
        format!(
            "{head}+--[ ]( a )--(S)( k )--+\n\n+--[ ]( m )--(S)( y )--+\n\n\
             {between}+--[ ]( m )--(R)( y )--+\n"
        )
    };
    let mut document = Document::new(with(""));
    for between in [
        "+--[ ]( a )--( )( m )--+\n\n",
        "",
        "+--[ ]( a )--( )( k )--+\n\n",
        "",
        "+--[ ]( a )--( )( %MX0.0 )--+\n\n",
        "+--[ ]( %MX0.0 )--[ ]( a )--( )( y )--+\n\n",
        "+--<CALL>( f )--+\n\n",
        "",
        "+--<MCR>--+\n\n",
        "# note #\n",
    ] {
        document.becomes(with(between));
    }
}

#[test]
fn circles_that_open_and_close_far_away() {
    let head = "VAR_INPUT\n    a, b : BOOL;\nEND_VAR\nVAR_OUTPUT\n    y : BOOL;\nEND_VAR\n\
         VAR\n    late, first, second, third : BOOL;\nEND_VAR\n\n";
    let with = |between: &str, below: &str| {
        format!(
            "{head}+--[ ]( late )--( )( first )--+\n\n+--[ ]( b )--( )( y )--+\n\n{between}\
             +--[ ]( second )--( )( late )--+\n\n+--[ ]( a )--( )( third )--+\n\n{below}"
        )
    };
    let closed = "+--[ ]( first )--( )( second )--+\n\n";
    let open = "+--[ ]( a )--( )( second )--+\n\n";
    let by_another = "+--[ ]( first )--( )( third )--+\n\n+--[ ]( third )--( )( second )--+\n\n";
    let half_typed = "+--[ ]( first --( )( second )--+\n\n";
    let function = "+--<FUN>( f )--+\n\n+--[ ]( a )--<RET>--+\n\n+--[ ]( a )--( )( y )--+\n\n+--<RET>--+\n";
    let mut document = Document::new(with(open, ""));
    for (between, below) in [
        (closed, ""),
        (open, ""),
        (half_typed, ""),
        (closed, ""),
        (half_typed, ""),
        (open, ""),
        ("", ""),
        (closed, ""),
        (by_another, ""),
        ("", ""),
        (by_another, ""),
        (open, ""),
        (open, "+--[ ]( b )--<RET>--+\n"),
        (open, "# note #\n"),
        (open, function),
        (open, "+--[ ]( b )--<RET>--+\n\n+--<FUN>( f )--+\n\n+--<RET>--+\n"),
        (open, function),
        (closed, function),
        (open, function),
    ] {
        document.becomes(with(between, below));
    }
}

#[test]
fn what_is_found_in_bodies_that_others_are_beside() {
    let head = "VAR_INPUT\n    a, b : BOOL;\nEND_VAR\nVAR_OUTPUT\n    y : BOOL;\nEND_VAR\n\
         VAR\n    m : BOOL;\nEND_VAR\n\n";
    let with = |main: &str, first: &str, second: &str| {
        format!(
            "{head}{main}+--[ ]( a )--<CALL>( f )--+\n\n+--[ ]( b )--<CALL>( g )--+\n\n+--<RET>--+\n\n\
             +--<FUN>( f )--+\n\n{first}+--[ ]( a )--( )( m )--+\n\n+--<RET>--+\n\n\
             +--<FUN>( g )--+\n\n+--<LBL>( l )--[ ]( b )--( )( y )--+\n\n{second}\
             +--[ ]( m )--<JMP>( l )--+\n\n+--<RET>--+\n"
        )
    };
    let mut document = Document::new(with("", "", ""));
    let always = "+--<RET>--+\n\n";
    let half_typed = "+--[ ]( a --( )( y )--+\n\n";
    let written = "+--[ ]( a )--( )( m )--+\n\n";
    for (main, first, second) in [
        ("", always, ""),
        (half_typed, always, ""),
        ("", always, ""),
        ("# note #\n", always, ""),
        ("", half_typed, always),
        ("", always, always),
        ("", always, written),
        (half_typed, "", written),
        (half_typed, always, ""),
        ("", always, ""),
        ("+--<END>--+\n\n", "", ""),
        ("+--[ ]( a )--<END>--+\n\n", "", always),
        ("+--<END>--+\n\n", always, half_typed),
        ("+--<END>--+\n\n# note #\n", always, ""),
        (written, "", ""),
        ("", "", ""),
    ] {
        document.becomes(with(main, first, second));
    }
}

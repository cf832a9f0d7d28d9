//! Pairs of networks: whether they do the same.

use expect_test::{Expect, expect};
use ladder_analysis::Cancel;
use ladder_analysis::program::Program;
use ladder_prover::{Compared, Meaning};
use std::sync::Arc;
use std::time::Duration;

fn program(text: &str) -> Arc<Program> {
    let analysis = ladder_analysis::analyze(&Arc::new(ladder_syntax::parse(text)), "p.clad");
    Arc::clone(
        analysis
            .program()
            .unwrap_or_else(|| panic!("it has errors:\n{text}")),
    )
}

/// The verdict on the first networks of two programs.
fn told(old: &str, new: &str) -> String {
    let compared = Compared::new(&program(old), &program(new)).expect("they compile");
    match compared.networks(0, 0, Duration::from_secs(10), &Cancel::default()) {
        Meaning::Same => String::from("the same"),
        Meaning::Other(difference) => difference.to_string(),
        Meaning::Declared(tags) => format!("declared differently: {}", tags.join(", ")),
        Meaning::NotDecided(cause) => format!("not decided: {cause}"),
    }
}

#[track_caller]
fn check(old: &str, new: &str, expected: Expect) {
    expected.assert_eq(&told(old, new));
}

#[test]
fn the_same_in_other_words() {
    for (old, new) in [
        // Branches that are swapped.
        (
            "+--\\--[ ]( a )--\\--( )( x )--+\n|  /--[/]( b )--/            |\n",
            "+--\\--[/]( b )--\\--( )( x )--+\n|  /--[ ]( a )--/            |\n",
        ),
        // De Morgan.
        (
            "+--\\--[/]( a )--\\--( )( x )--+\n|  /--[/]( b )--/            |\n",
            "+--[ ]( a )--[ ]( b )--(/)( x )--+\n",
        ),
        // Twice not.
        ("+--[ ]( a )--( )( x )--+\n", "+--[/]( a )--[NOT]--( )( x )--+\n"),
        // A contact that is there twice.
        (
            "+--[ ]( a )--[ ]( a )--( )( x )--+\n",
            "+--[ ]( a )--( )( x )--+\n",
        ),
        // Edges that have changed places.
        (
            "+--\\--[P]( a )--\\--( )( x )--+\n|  /--[N]( b )--/            |\n",
            "+--\\--[N]( b )--\\--( )( x )--+\n|  /--[P]( a )--/            |\n",
        ),
        // A set coil, written out.
        (
            "+--[ ]( a )--(S)( x )--+\n",
            "+--\\--[ ]( a )--\\--( )( x )--+\n|  /--[ ]( x )--/            |\n",
        ),
        // Timers and counters after other conditions that are equal.
        (
            "+--[ ]( a )--[ ]( b )--[TON]( t, 5s )--( )( x )--+\n",
            "+--[ ]( b )--[ ]( a )--[TON]( t, 5000ms )--( )( x )--+\n",
        ),
        (
            "+--[ ]( a )--[ ]( b )--[CTU]( c, 5 )--( )( x )--+\n",
            "+--[ ]( b )--[ ]( a )--[CTU]( c, 5 )--( )( x )--+\n",
        ),
        // Numbers.
        (
            "VAR\n    n : INT;\nEND_VAR\n+--[GT]( n, 4 )--( )( x )--+\n",
            "VAR\n    n : INT;\nEND_VAR\n+--[GE]( n, 5 )--( )( x )--+\n",
        ),
        // Jumps.
        (
            "+--[ ]( a )--[ ]( b )--<JMP>( On )--+\n\n+--( )( y )--+\n\n+--<LBL>( On )--( )( x )--+\n",
            "+--[ ]( b )--[ ]( a )--<JMP>( On )--+\n\n+--( )( y )--+\n\n+--<LBL>( On )--( )( x )--+\n",
        ),
    ] {
        assert_eq!(told(old, new), "the same", "{old}{new}");
    }
}

#[test]
fn a_contact_that_is_gone_or_turned() {
    check(
        "+--\\--[ ]( start )--\\--[/]( stop )--( )( run )--+\n|  /--[ ]( run )----/                           |\n",
        "+--\\--[ ]( start )--\\--( )( run )--+\n|  /--[ ]( run )----/              |\n",
        expect!["with run on and stop on, run goes off in the old and on in the new program"],
    );
    check(
        "+--[ ]( start )--[/]( stop )--( )( run )--+\n",
        "+--[ ]( start )--[ ]( stop )--( )( run )--+\n",
        expect!["with start on and stop off, run goes on in the old and off in the new program"],
    );
}

#[test]
fn edges() {
    check(
        "+--[ ]( a )--( )( x )--+\n",
        "+--[P]( a )--( )( x )--+\n",
        expect!["with a on and a on before, x goes on in the old and off in the new program"],
    );
    check(
        "+--[P]( a )--( )( x )--+\n",
        "+--[N]( a )--( )( x )--+\n",
        expect!["with a off and a on before, x goes off in the old and on in the new program"],
    );
}

#[test]
fn edges_of_one_tag_that_change_places() {
    let rung = |upper: &str, lower: &str| {
        format!(
            "+--\\--{upper}( a )--[ ]( b )--\\--( )( x )--+\n|  /--{lower}( a )--[/]( b )--/            |\n"
        )
    };
    check(
        &rung("[P]", "[N]"),
        &rung("[N]", "[P]"),
        expect!["with a on, b off and a off before, x goes off in the old and on in the new program"],
    );
    let [old, new] = [("[ ]", "[/]"), ("[/]", "[ ]")].map(|(one, other)| {
        format!(
            "+--\\--[P]( a )--{one}( b )--\\--( )( x )--+\n|  /--[N]( a )--{other}( b )--/            |\n"
        )
    });
    check(
        &old,
        &new,
        expect!["with a on, b off and a off before, x goes off in the old and on in the new program"],
    );
    let new = "+--\\--[N]( a )--[/]( b )--\\--( )( x )--+\n|  /--[P]( a )--[ ]( b )--/            |\n";
    check(
        &old,
        new,
        expect!["not decided: edges of one tag in it have changed places"],
    );
}

#[test]
fn timers_and_counters() {
    check(
        "+--[ ]( a )--[TON]( t, 5s )--( )( x )--+\n",
        "+--[ ]( a )--[TON]( t, 6s )--( )( x )--+\n",
        expect!["with a on, t begun T#5s ago and t running, x goes on in the old and off in the new program"],
    );
    check(
        "+--[ ]( a )--[TON]( t, 5s )--( )( x )--+\n",
        "+--[ ]( a )--[TOF]( t, 5s )--( )( x )--+\n",
        expect!["declared differently: t"],
    );
    check(
        "+--[ ]( a )--[CTU]( c, 5 )--( )( x )--+\n",
        "+--[ ]( a )--[CTU]( c, 6 )--( )( x )--+\n",
        expect!["with a on, c.CV 4 and c.CU before off, x goes on in the old and off in the new program"],
    );
    check(
        "+--[ ]( a )--[TON]( t, 5s )--( )( x )--+\n",
        "+--[/]( a )--[TON]( t, 5s )--( )( x )--+\n",
        expect!["with a on and t done, x goes on in the old and off in the new program"],
    );
}

#[test]
fn numbers() {
    check(
        "VAR\n    n : INT;\nEND_VAR\n+--[GT]( n, 4 )--( )( x )--+\n",
        "VAR\n    n : INT;\nEND_VAR\n+--[GE]( n, 4 )--( )( x )--+\n",
        expect!["with n 4, x goes off in the old and on in the new program"],
    );
    check(
        "VAR\n    n, m : INT;\nEND_VAR\n+--[ADD]( m, n, 1 )--+\n",
        "VAR\n    n, m : INT;\nEND_VAR\n+--[ADD]( m, n, 2 )--+\n",
        expect!["with n 0, m becomes 1 in the old and 2 in the new program"],
    );
    check(
        "VAR\n    n : INT;\nEND_VAR\n+--[GT]( n, 4 )--( )( x )--+\n",
        "VAR\n    n : DINT;\nEND_VAR\n+--[GE]( n, 5 )--( )( x )--+\n",
        expect!["declared differently: n"],
    );
}

#[test]
fn tags_of_the_system_have_their_names() {
    check(
        "+--[ ]( SYS.CLOCK_1S )--( )( x )--+\n",
        "+--[ ]( SYS.FIRST_SCAN )--( )( x )--+\n",
        expect![
            "with SYS.CLOCK_1S off and SYS.FIRST_SCAN on, x goes off in the old and on in the new program"
        ],
    );
    check(
        "+--[GT]( SYS.SCAN, 3 )--( )( x )--+\n",
        "+--[GT]( SYS.SCAN, 4 )--( )( x )--+\n",
        expect!["with SYS.SCAN 4, x goes on in the old and off in the new program"],
    );
    check(
        "+--[GT]( SYS.TIME, T#3s )--( )( x )--+\n",
        "+--[GT]( SYS.TIME, T#4s )--( )( x )--+\n",
        expect!["with SYS.TIME T#3s1ns, x goes on in the old and off in the new program"],
    );
}

#[test]
fn where_execution_goes_on() {
    check(
        "+--[ ]( a )--<JMP>( On )--+\n\n+--( )( y )--+\n\n+--<LBL>( On )--( )( x )--+\n",
        "+--[/]( a )--<JMP>( On )--+\n\n+--( )( y )--+\n\n+--<LBL>( On )--( )( x )--+\n",
        expect!["with a off, it jumps to on in the new and not in the old program"],
    );
    check(
        "+--[ ]( a )--<END>--+\n",
        "+--[ ]( a )--<RET>--+\n",
        expect!["with a on, the program ends in the old and not in the new program"],
    );
}

#[test]
fn what_is_not_followed() {
    check(
        "VAR\n    s : STRING;\nEND_VAR\n+--[ ]( a )--[MOVE]( s, 'a' )--+\n",
        "VAR\n    s : STRING;\nEND_VAR\n+--[ ]( a )--[MOVE]( s, 'b' )--+\n",
        expect!["not decided: texts are not followed"],
    );
    check(
        "VAR\n    p, q, r : REAL;\nEND_VAR\n+--[ ]( a )--[ADD]( p, q, r )--+\n",
        "VAR\n    p, q, r : REAL;\nEND_VAR\n+--[ ]( a )--[SUB]( p, q, r )--+\n",
        expect!["not decided: arithmetic of reals is not tracked"],
    );
    check(
        "VAR\n    p, q, r : REAL;\nEND_VAR\n+--[ ]( a )--[ ]( b )--[ADD]( p, q, r )--[SUB]( q, p, r )--+\n",
        "VAR\n    p, q, r : REAL;\nEND_VAR\n+--[ ]( b )--[ ]( a )--[ADD]( p, r, q )--[SUB]( q, p, r )--+\n",
        expect!["the same"],
    );
    check(
        "VAR\n    p, q, r : DINT;\nEND_VAR\n+--[ ]( a )--[MUL]( p, q, r )--+\n",
        "VAR\n    p, q, r : DINT;\nEND_VAR\n+--[ ]( a )--[MUL]( p, r, q )--+\n",
        expect!["the same"],
    );
}

/// A program without networks but those in the body of a block.
fn with_body(parameters: &str, body: &str) -> String {
    format!(
        "FUNCTION_BLOCK [$B]\nVAR_INPUT\n    a, b : BOOL;\nEND_VAR\n{parameters}VAR_OUTPUT\n    y : BOOL;\nEND_VAR\n\
         VAR\n    t : TON;\nEND_VAR\n\n{body}\nEND_FUNCTION_BLOCK\n"
    )
}

#[test]
fn networks_in_the_body_of_a_block() {
    let compared = |parameters: &str, old: &str, new: &str| {
        told(&with_body(parameters, old), &with_body(parameters, new))
    };
    let old = "+--[ ]( EN )--[ ]( a )--[/]( b )--[TON]( t, 2s )--( )( y )--+";
    expect!["the same"].assert_eq(&compared(
        "",
        old,
        "+--[/]( b )--[ ]( EN )--[ ]( a )--[TON]( t, T#2000ms )--( )( y )--+",
    ));
    expect!["with EN on, a on, b on and t done, y goes off in the old and on in the new program"].assert_eq(
        &compared(
            "",
            old,
            "+--[ ]( EN )--[ ]( a )--[ ]( b )--[TON]( t, 2s )--( )( y )--+",
        ),
    );
    // Two in-outs may be one tag where the block stands.
    let in_outs = "VAR_IN_OUT\n    p, q : BOOL;\nEND_VAR\n";
    expect!["not decided: it is in the body of a block with in-outs"].assert_eq(&compared(
        in_outs,
        "+--[ ]( a )--(S)( p )--(R)( q )--+",
        "+--[ ]( a )--(R)( q )--(S)( p )--+",
    ));
}

//! Texts that consist of mistakes: each is read in a time that grows with its length. Where a rule compared
//! everything with everything, this test would not come to an end.

use ladder_analysis::{Rule, analyze};
use ladder_syntax::parse;
use std::fmt::Write as _;
use std::sync::Arc;

/// How many findings there are.
fn findings(text: &str) -> usize {
    analyze(&Arc::new(parse(text)), "test.clad").diagnostics.len()
}

const MANY: usize = 4_000;

#[test]
fn one_long_line() {
    for piece in [
        "\\",
        "/",
        "\\/",
        "[",
        "(",
        "[ ]( ",
        "?-",
        "[ ]( a )",
        "[X]( a )-",
        "-+",
        "|-",
        "- ",
        "[ ]( a[ )-",
        "[ ]( a b )-",
        "'",
        "[$B]-",
        "[TON]( t, T#5s )-",
        "( )( y )-",
        "<JMP>( x )-",
        "<LBL>( x )-",
        "<FUN>( f )-",
    ] {
        let text = format!("+{}+\n", piece.repeat(MANY));
        assert!(findings(&text) > 0, "{piece}");
        let below = format!("{text}+{}+\n", piece.repeat(MANY / 2));
        assert!(findings(&below) > 0, "{piece}");
    }
}

#[test]
fn one_block_with_many_operands() {
    for operand in ["a, ", "R := a, ", "X := a, ", "R => a, ", "1 + "] {
        let text = format!("+--[TON]( {}b )--( )( y )--+\n", operand.repeat(MANY));
        assert!(findings(&text) > 0, "{operand}");
    }
    let mut text = String::from("+--[EQ]( ");
    for n in 0..MANY {
        let _ = write!(text, "n{n}, ");
    }
    text.push_str("T#5s )--( )( y )--+\n");
    findings(&text);
}

#[test]
fn many_lines() {
    for line in [
        "+--[TOM{n}]( t )--+\n",
        "+--[ ]( a )--\\--( )( y )--+\n\n",
        "+--[ ]( a{n} )--  --( )( y )--+\n",
        "+--<JMP>( l{n} )--+\n\n+--<LBL>( m{n} )--+\n\n",
        "+--<CALL>( f{n} )--+\n\n+--<FUN>( g{n} )--+\n\n",
        "+--<LBL>( x )--<JMP>( x )--+\n",
        "+--[TON]( t, T#5s )--( )( y )--+\n",
        "VAR a{n} : BOOL; END_VAR\n+--[ ]( b{n} )--( )( c{n} )--+\n",
        "VAR x : BOOL; END_VAR\n",
        "+--\\--[ ]( a )--\\--( )( y )--[ ]( y )--(S)( z )--(R)( z )--+\n|  /-----------/\n",
        "+--\\--[ ]( a )--\\--\n+--/--[/]( a )--/--[GT]( n, {n} )--\\--(S)( z )--+\n+--[ ]( a )--/\n",
        "+--[ ]( a )--<JMP>( x )--+\n+--<LBL>( x )--<JMP>( x )--<END>--+\n",
        "+--[ ]( a{n} )--[CTU]( c, 5 )--(S)( z )--+\n+--[ ]( b{n} )--(R)( z )--( )( a{n} )--+\n",
        "# +--[ ]( a )--( )( y )--+ #\n",
        "+--<FOR>( 3 )--<NEXT>--+\n",
        "FUNCTION_BLOCK [$B{n}]\n+--[$B{n}]--[ ]( q )--+\nEND_FUNCTION_BLOCK\n",
        "VAR\n",
        "FUNCTION_BLOCK [$B]\n",
        "|\n\n",
    ] {
        let text: String = (0..MANY / 4)
            .map(|n| line.replace("{n}", &n.to_string()))
            .collect();
        findings(&text);
        // The same without a declaration for every name that is used once.
        findings(&format!("VAR z : INT; END_VAR\n{text}"));
    }
}

#[test]
fn types_that_follow_from_each_other() {
    let mut text = String::new();
    for n in 0..MANY {
        let _ = writeln!(text, "+--[MOV]( a{n}, a{} )--+", n + 1);
    }
    let _ = writeln!(text, "+--[MOV]( a{MANY}, T#5s )--+");
    let parse = Arc::new(parse(&text));
    let found = analyze(&parse, "test.clad").diagnostics;
    // Each rung reads what the next one writes: that is told of each of them.
    assert!(
        found.iter().all(|found| found.rule == Rule::ReadBeforeWrite),
        "{found:?}"
    );
}

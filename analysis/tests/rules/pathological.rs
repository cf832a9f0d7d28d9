//! Texts that consist of errors: each is read in a time that grows with its length. Where a rule compared
//! everything with everything, this test would not come to an end.

use ladder_analysis::analyze;
use ladder_analysis::findings::diagnostic::MOST_RELATED;
use ladder_syntax::parse;
use std::fmt::Write as _;
use std::sync::Arc;

/// How many findings there are.
fn findings(text: &str) -> usize {
    analyze(&Arc::new(parse(text)), "test.clad").diagnostics().len()
}

const MANY: usize = 2_000;

#[test]
fn a_finding_names_a_bounded_number_of_places() {
    for rung in [
        "+--[ ]( a )--( )( y )--+\n",
        "+--[ ]( a )--(S)( y )--+\n",
        "+--[ ]( a )--(R)( y )--+\n",
        "+--[ ]( a )--( )( start )--+\n",
        "+--<LBL>( x )--[ ]( a )--<JMP>( x )--+\n",
        "+--<FUN>( f )--( )( y )--<CALL>( f )--+\n",
        "+--[TON]( t, 5s )--( )( y )--+\n",
    ] {
        let size = |count: usize| {
            let text = format!("VAR_INPUT start : BOOL; END_VAR\n{}", rung.repeat(count));
            let found = analyze(&Arc::new(parse(&text)), "test.clad")
                .diagnostics()
                .to_vec();
            let most = found.iter().map(|found| found.related.len()).max().unwrap_or(0);
            assert!(most <= MOST_RELATED, "{rung}: {most}");
            let all = found
                .iter()
                .map(|found| 1 + found.related.len() + found.fixes.len());
            let hidden: Vec<_> = found.iter().filter(|found| found.more_related > 0).collect();
            for found in &hidden {
                let last = &found.related[MOST_RELATED - 1].message;
                assert!(
                    last.ends_with(&format!("; and {} more", found.more_related)),
                    "{last}"
                );
            }
            all.sum::<usize>()
        };
        // At most as much more is reported as there is more to be reported about.
        let (small, large) = (size(50), size(500));
        assert!(large <= 11 * small, "{rung}: {small}, then {large}");
    }
}

#[test]
fn after_very_many_findings_no_more_are_looked_for() {
    let analysis = |rungs: usize| {
        let rung = format!("+-{}-( )( y )-+\n", "[ ]( a )".repeat(2001));
        let text = rung.repeat(rungs);
        analyze(&Arc::new(parse(&text)), "test.clad")
    };
    let few = analysis(1);
    assert!(few.diagnostics().len() >= 2000 && !few.has_errors());
    let many = analysis(101);
    let wires = many.diagnostics().iter();
    let wires: Vec<_> = wires
        .filter(|found| found.rule.name() == "missing-wire")
        .collect();
    assert!(wires.len() < 202_000, "{}", wires.len());
    // Nobody has checked the rest: it does not run.
    assert!(many.has_errors() && many.program().is_none());
    let help = wires
        .last()
        .and_then(|last| last.help.as_deref())
        .unwrap_or_default();
    assert!(help.contains("not checked"), "{help}");
}

#[test]
fn many_comments_that_switch_rules_off() {
    let allow = "# ladder: allow(missing-wire): so it is #\n";
    let rung = "+--[ ]( a )( )( y )--+\n";
    for text in [
        format!("{allow}{rung}").repeat(MANY),
        format!("{}{}", allow.repeat(MANY), rung.repeat(MANY)),
        format!(
            "# ladder: allow({}missing-wire): so it is #\n{rung}",
            "missing-wire, ".repeat(MANY)
        ),
    ] {
        let found = analyze(&Arc::new(parse(&text)), "test.clad")
            .diagnostics()
            .to_vec();
        let first = found.iter().find(|found| found.rule.name() == "missing-wire");
        let hidden = first.map_or(text.len(), |found| found.range.start().into());
        assert!(hidden >= text.find('+').unwrap() + rung.len(), "{hidden}");
    }
}

#[test]
fn circles_of_calls() {
    let size = |count: usize| {
        let mut text = String::from("+--<CALL>( f0 )--+\n");
        for n in 0..count {
            let (a, b) = ((n * 7 + 1) % count, (n * 3 + 2) % count);
            let _ = writeln!(
                text,
                "+--<FUN>( f{n} )--+\n+--[ ]( a )--<CALL>( f{a} )--<CALL>( f{b} )--+"
            );
        }
        let found = analyze(&Arc::new(parse(&text)), "test.clad")
            .diagnostics()
            .to_vec();
        let circles = found.iter().filter(|found| found.rule.name() == "recursive-call");
        assert!(circles.clone().count() > 0);
        circles.map(|found| found.message.len()).max().unwrap()
    };
    // However long a circle is, a few names of it are reported.
    assert!(size(4000) < 2 * size(40), "{} {}", size(40), size(4000));
}

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
    let found = analyze(&parse, "test.clad").diagnostics().to_vec();
    // Each rung reads what the next one writes: that is reported for each of them.
    assert!(
        found.iter().all(|found| found.rule.name() == "read-before-write"),
        "{found:?}"
    );
}

//! Formulas of networks.

use super::*;
use expect_test::{Expect, expect};
use std::fmt::Write;
use std::sync::Arc;

fn check(text: &str, expected: Expect) {
    let analysis = crate::analyze(&Arc::new(ladder_syntax::parse(text)), "test.clad");
    let mut shown = String::new();
    for network in 0..analysis.context.networks.len() {
        match formulas(&analysis.context, network) {
            Some(formulas) => {
                for (_, effect) in formulas.effects() {
                    let _ = writeln!(shown, "{effect}");
                }
            }
            None => shown.push_str("nothing\n"),
        }
    }
    expected.assert_eq(&shown);
}

#[test]
fn branches() {
    check(
        "+--\\--[ ]( start )--\\--[/]( stop )--( )( run )--+\n|  /--[ ]( run )----/                           |\n",
        expect![[r#"
                run := (start OR run) AND NOT stop
            "#]],
    );
    // Three branches after a contact, and a branch around two.
    check(
        "+--[ ]( x )--\\--[ ]( a )----------------\\--( )( y )--+\n             /--\\--[ ]( b )--[ ]( d )--\\--/\n                /--[ ]( c )------------/\n",
        expect![[r#"
                y := x AND (a OR b AND d OR c)
            "#]],
    );
    // A bare wire next to a contact, and an inverter after branches.
    check(
        "+--\\--[ ]( a )--\\--( )( y )--+\n|  /------------/            |\n+--\\--[ ]( a )--\\--[NOT]--( )( z )--+\n|  /--[ ]( b )--/                   |\n",
        expect![[r#"
                y := TRUE
                z := NOT (a OR b)
            "#]],
    );
}

#[test]
fn blocks() {
    check(
        "+--[ ]( a )--[TON]( t, 5s )--( )( y )--(S)( s )--(R)( r )--(/)( n )--+\n\
             +--[GT]( count, 3, 1 )--[P]( a )--[ADD]( count, count, 1 )--+\n\
             +--[ ]( a )--[OSR]--[CTU]( c, 10 )--<JMP>( done )--+\n\
             +--[ ]( a )--(R)( c )--+\n\
             +--[ ]( b[1..3] )--[/]( b[4..5] )--(P)( p )--+\n\
             +--[MOV]( k, 1 )--+\n\
             +--<LBL>( done )--[SR]( latch )--( )( q )--+\n",
        expect![[r#"
                t.IN := a
                y := t.Q
                s := s OR t.Q
                r := r AND NOT s
                n := NOT s
                IF count > 3 AND 3 > 1 AND RISE(a): [ADD]( count, count, 1 )
                c.CU := RISE(a)
                IF c.Q: <JMP>( done )
                IF a: (R)( c )
                p := RISE(ALL(b[1..3]) AND NONE(b[4..5]))
                [MOV]( k, 1 )
                [SR]( latch )
                q := latch.Q1
            "#]],
    );
}

#[test]
fn what_is_not_known() {
    check(
        "+--[ ]( a )--[FOO]( b )--( )( y )--+\n",
        expect![[r#"
            IF a: [FOO]( b )
        "#]],
    );
    check(
        "+--\\--[ ]( a )--( )( y )--+\n",
        expect![[r#"
            nothing
        "#]],
    );
    check(
        "+--[ ]( a )--<MCR>--+\n+--[ ]( b )--( )( y )--+\n",
        expect![[r#"
            IF a: <MCR>
            y := RAIL AND b
        "#]],
    );
}

/// What a formula says for the values of its names.
fn holds(formula: &Formula, value: &impl Fn(&str) -> bool) -> bool {
    match formula {
        Formula::Always => true,
        Formula::Never => false,
        Formula::Name(name) | Formula::Compare(name) => value(name),
        Formula::Not(inner) => !holds(inner, value),
        Formula::And(parts) => parts.iter().all(|part| holds(part, value)),
        Formula::Or(parts) => parts.iter().any(|part| holds(part, value)),
    }
}

/// Three rungs of contacts joined at random, bridges among them.
fn drawing(seed: u64) -> String {
    let mut state = seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1;
    let mut dice = |below: usize| {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 33) as usize % below
    };
    let pairs = [1 + dice(3), dice(3)];
    let mut text = String::new();
    for rung in 0..3 {
        if rung > 0 && pairs[rung - 1] == 0 {
            break;
        }
        let mut parts: Vec<String> = Vec::new();
        let downs = pairs.get(rung).copied().unwrap_or(0);
        let ups = if rung > 0 { pairs[rung - 1] } else { 0 };
        parts.extend(std::iter::repeat_n("\\".to_owned(), downs));
        parts.extend(std::iter::repeat_n("/".to_owned(), ups));
        for _ in 0..dice(4) {
            let head = ["[ ]", "[/]", "[NOT]"][dice(5) % 3];
            let tag = ["a", "b", "c", "d"][dice(4)];
            parts.push(if head == "[NOT]" {
                head.to_owned()
            } else {
                format!("{head}( {tag} )")
            });
        }
        for index in (1..parts.len()).rev() {
            parts.swap(index, dice(index + 1));
        }
        let start = if rung == 0 || dice(2) == 0 { "+--" } else { "|  " };
        text.push_str(&format!("{start}{}--( )( y{rung} )--+\n", parts.join("--")));
    }
    text
}

/// The formulas say what the tables of the boolean function say, for every combination of values.
#[test]
fn formulas_are_exact() {
    use crate::boolean::gate::Variable;
    use crate::boolean::power::{NetworkPower, Question};
    let mut compared = 0;
    for seed in 0..600 {
        let text = drawing(seed);
        let analysis = crate::analyze(&Arc::new(ladder_syntax::parse(&text)), "test.clad");
        let network = analysis.context.networks.at(0);
        let (Some(formulas), Some(power)) = (
            formulas(&analysis.context, 0),
            NetworkPower::new(&analysis.context, network, false),
        ) else {
            continue;
        };
        let powers = power.powers(Question::default());
        for (step, formula) in formulas.steps.iter().enumerate() {
            let Some(formula) = formula else { continue };
            let points = power.gates.variables.iter().map(Variable::size).product();
            for point in 0..points {
                let values = power.space.at(point);
                let value = |name: &str| {
                    let mut variables = power.gates.variables.iter();
                    let at = variables.position(|it| matches!(it, Variable::Bool(of) if of == name));
                    values[at.expect("the network asks for it")] == 1
                };
                let expected = powers.of_step[step].holds(point);
                assert_eq!(
                    holds(formula, &value),
                    expected,
                    "step {step}, {formula}, in\n{text}"
                );
                compared += 1;
            }
        }
    }
    assert!(compared > 10_000, "{compared}");
}

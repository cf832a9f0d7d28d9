//! Unread parts: what they may write is unknown, in proofs and in comparisons.

use super::{answers, simulation};
use expect_test::{Expect, expect};
use ladder_prover::{Compared, Limits, Meaning, Whole, compare_programs, resting_on_unread};
use std::fmt::Write;
use std::sync::Arc;
use std::time::Duration;

/// A program in which an unread part of this directive is on the second of three rungs.
fn program(directive: &str, first: &str, text: &str) -> String {
    format!(
        "VAR_INPUT go, x : BOOL; END_VAR
VAR_OUTPUT run, lamp, late : BOOL; END_VAR
VAR done : BOOL; n : INT; t : TON; c : CTU; END_VAR
VAR CONSTANT limit : INT := 5; END_VAR
FUNCTION_BLOCK [$MSG]
VAR_INPUT operands : STRING[254] := ''; END_VAR
# ladder: {directive} #
# {text} #
END_FUNCTION_BLOCK
{first}
+--[ ]( run )--[$MSG]( 'control' )--( )( lamp )--+
+--[ ]( go )--[ ]( done )--( )( late )--+
+--[ ]( go )--[TON]( t, T#1s )--+
+--[ ]( go )--[CTU]( c, 3 )--+
"
    )
}

const FIRST: &str = "+--[ ]( go )--( )( run )--+";

#[track_caller]
fn check(program: &str, properties: &str, expected: Expect) {
    let mut text = String::new();
    for (name, answer) in answers(program, properties).expect("it has no errors") {
        let verdict = answer.verdict.word();
        let open = answer.open.iter().map(|(what, _)| what.as_str());
        let open: Vec<&str> = open.filter(|what| what.contains("unread")).collect();
        writeln!(text, "{name}: {verdict} {}", open.join("; ")).expect("it can be written");
    }
    expected.assert_eq(&text.replace(" \n", "\n"));
}

const PROPERTIES: &str = "program p.clad
interval 100ms
when late: go
always run = go
never lamp
never done
never late
always n = 0
always limit = 5
possible done
never go or done
when t.Q: go
always c.CV <= 9
";

#[test]
fn a_part_that_says_what_it_writes() {
    check(
        &program("unread, writes done", FIRST, ""),
        PROPERTIES,
        expect![[r#""#]],
    );
}

#[test]
fn a_part_that_does_not_say_it() {
    check(&program("unread", FIRST, ""), PROPERTIES, expect![[r#""#]]);
}

#[test]
fn a_part_at_any_time() {
    let program = "VAR_INPUT go : BOOL; END_VAR
VAR_OUTPUT run, lamp, same : BOOL; END_VAR
FUNCTION_BLOCK [$Task]
# ladder: unread, at any time, writes run #
END_FUNCTION_BLOCK
+--[ ]( go )--( )( run )--( )( same )--+
+--[ ]( run )--( )( lamp )--+
+--[$Task]--+
";
    check(
        program,
        "program p.clad
always same = go
always lamp = same
always run = go
",
        expect![[r#""#]],
    );
}

#[test]
fn states_and_instances() {
    let program = "VAR_INPUT go : BOOL; END_VAR
VAR_OUTPUT y, z : BOOL; r : INT; END_VAR
VAR t : TON; calc : $Calc; END_VAR
FUNCTION_BLOCK [$Calc]
VAR_INPUT a : INT; END_VAR
VAR_OUTPUT b : INT; END_VAR
# ladder: unread #
# b := a * 2; #
END_FUNCTION_BLOCK
FUNCTION_BLOCK [$Reset]
# ladder: unread, writes t #
END_FUNCTION_BLOCK
+--[$Reset]--+
+--[ ]( go )--[TON]( t, T#1s )--( )( y )--+
+--[ ]( go )--[MOV]( r, 7 )--+
+--[$Calc]( calc, 5, r )--+
+--[ ]( go )--( )( z )--+
";
    check(
        program,
        "program p.clad
interval 100ms
always r = 0
always calc.b = 0
always z = go
when y: go
never y
always t.ET <= T#1s
",
        expect![[r#""#]],
    );
}

/// Both ways of comparing.
fn said(old: &str, new: &str) -> String {
    let [mut one, mut other] =
        [old, new].map(|text| simulation(text, 100_000_000).expect("it has no errors"));
    let limits = Limits {
        time: Duration::from_secs(10),
        ..Limits::default()
    };
    let whole = match compare_programs(&mut one, &mut other, limits).expect("what is found happens") {
        Whole::Same => String::from("the same"),
        Whole::Differs(run) => {
            let names: Vec<&str> = run.differs.iter().map(|row| row.name.as_str()).collect();
            format!("differs in {}", names.join(", "))
        }
        Whole::Unknown(why) => format!("not decided: {why}"),
    };
    let [one, other] = [one, other].map(|simulation| Arc::clone(simulation.program()));
    let compared = Compared::new(&one, &other).expect("they compile");
    let network = match compared.networks(1, 1, Duration::from_secs(10)) {
        Meaning::Same => String::from("the same"),
        Meaning::Other(difference) => difference.to_string(),
        Meaning::Declared(tags) => format!("declared differently: {}", tags.join(", ")),
        Meaning::NotDecided(cause) => format!("not decided: {cause}"),
    };
    format!("whole: {whole}\nnetwork: {network}\n")
}

#[test]
fn the_same_part_gives_the_same() {
    let old = program("unread", FIRST, "a := 1;");
    let mut text = String::new();
    for (what, new) in [
        ("itself", old.clone()),
        ("white space", program("unread", FIRST, "a  :=1;")),
        ("another text", program("unread", FIRST, "a := 2;")),
        ("another list", program("unread, writes done", FIRST, "a := 1;")),
        (
            "the same before it",
            program("unread", "+--[ ]( go )--[ ]( go )--( )( run )--+", "a := 1;"),
        ),
        (
            "the same in other words",
            program(
                "unread",
                "+--\\--[ ]( go )--[ ]( x )--\\--( )( run )--+\n|  /--[ ]( go )--[/]( x )--/",
                "a := 1;",
            ),
        ),
        (
            "something else before it",
            program("unread", "+--[/]( go )--( )( run )--+", "a := 1;"),
        ),
    ] {
        let _ = writeln!(text, "{what}\n{}", said(&old, &new));
    }
    expect![[r#""#]].assert_eq(&text);
}

#[test]
fn what_does_not_rest_on_a_part_is_compared() {
    let old = program("unread, writes done", FIRST, "");
    let new = program("unread, writes done", "+--[/]( go )--( )( run )--+", "");
    expect![[r#""#]].assert_eq(&said(&old, &new));
}

#[test]
fn what_rests_on_a_part() {
    let simulation =
        simulation(&program("unread, writes done", FIRST, ""), 100_000_000).expect("it has no errors");
    let names: Vec<String> = resting_on_unread(&simulation).into_keys().collect();
    expect![[r#""#]].assert_eq(&names.join(" "));
}

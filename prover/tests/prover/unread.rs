//! Unread parts: what they may write is unknown, in proofs and in comparisons.

use super::{answers, simulation};
use expect_test::{Expect, expect};
use ladder_prover::{Limits, Whole, compare_programs, resting_on_unread};
use std::fmt::Write;
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
        expect![[r#"
            when late: go: proved
            always run = go: proved
            never lamp: unknown what the unread part `MSG` writes is not known
            never done: unknown what the unread part `MSG` writes is not known
            never late: unknown what the unread part `MSG` writes is not known
            always n = 0: proved
            always limit = 5: proved
            possible done: unknown what the unread part `MSG` writes is not known
            never go or done: violated what the unread part `MSG` writes is not known
            when t.Q: go: proved
            always c.CV <= 9: violated
        "#]],
    );
}

#[test]
fn a_part_that_does_not_say_it() {
    check(
        &program("unread", FIRST, ""),
        PROPERTIES,
        expect![[r#"
            when late: go: proved
            always run = go: unknown what the unread part `MSG` writes is not known
            never lamp: unknown what the unread part `MSG` writes is not known
            never done: unknown what the unread part `MSG` writes is not known
            never late: unknown what the unread part `MSG` writes is not known
            always n = 0: unknown what the unread part `MSG` writes is not known
            always limit = 5: proved
            possible done: unknown what the unread part `MSG` writes is not known
            never go or done: violated what the unread part `MSG` writes is not known
            when t.Q: go: proved what the unread part `MSG` writes is not known
            always c.CV <= 9: unknown what the unread part `MSG` writes is not known
        "#]],
    );
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
        expect![[r#"
            always same = go: proved
            always lamp = same: unknown what the unread part `Task` writes is not known
            always run = go: unknown what the unread part `Task` writes is not known
        "#]],
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
        expect![[r#"
            always r = 0: unknown what the unread part `Calc` writes is not known
            always calc.b = 0: unknown what the unread part `Calc` writes is not known
            always z = go: proved
            when y: go: unknown what the unread part `Calc` writes is not known
            never y: unknown what the unread part `Calc` writes is not known
            always t.ET <= T#1s: unknown what the unread part `Calc` writes is not known
        "#]],
    );
}

/// What two programs do, next to each other.
fn whole(old: &str, new: &str) -> String {
    let [mut old, mut new] = [old, new].map(|text| simulation(text, 100_000_000).expect("it has no errors"));
    let limits = Limits {
        time: Duration::from_secs(10),
        ..Limits::default()
    };
    match compare_programs(&mut old, &mut new, limits).expect("what is found happens") {
        Whole::Same => String::from("the same"),
        Whole::Differs(run) => {
            let names: Vec<&str> = run.differs.iter().map(|row| row.name.as_str()).collect();
            format!("differs in {}", names.join(", "))
        }
        Whole::Unknown(why) => format!("not decided: {why}"),
    }
}

#[test]
fn the_same_part_gives_the_same() {
    let old = program("unread", FIRST, "a := 1;");
    for new in [
        old.clone(),
        program("unread", FIRST, "a  :=1;"),
        program("unread", "+--[ ]( go )--[ ]( go )--( )( run )--+", "a := 1;"),
    ] {
        assert_eq!(whole(&old, &new), "the same", "{new}");
    }
}

#[test]
fn another_part_gives_what_it_likes() {
    let old = program("unread", FIRST, "a := 1;");
    for new in [
        program("unread", FIRST, "a := 2;"),
        program("unread, writes done", FIRST, "a := 1;"),
        program("unread", "+--[/]( go )--( )( run )--+", "a := 1;"),
    ] {
        let told = whole(&old, &new);
        assert!(
            told.starts_with("not decided") && told.contains("`MSG`"),
            "{told}\n{new}"
        );
    }
}

#[test]
fn what_does_not_rest_on_a_part_is_compared() {
    let old = program("unread, writes done", FIRST, "");
    let new = program("unread, writes done", "+--[/]( go )--( )( run )--+", "");
    assert_eq!(whole(&old, &new), "differs in run");
    let simulation = simulation(&old, 100_000_000).expect("it has no errors");
    let resting = resting_on_unread(&simulation);
    assert!(resting.contains_key("lamp") && resting.contains_key("late"));
    assert!(!resting.contains_key("run"));
}

#[test]
fn what_a_part_writes_differs_for_sure() {
    let text = |coil: &str| {
        format!(
            "VAR m : BOOL; END_VAR
FUNCTION_BLOCK [$Part]
# ladder: unread, writes m #
END_FUNCTION_BLOCK
+--[ ]( m )--{coil}( y )--+
+--[ ]( k )--[$Part]--+
"
        )
    };
    assert_eq!(whole(&text("( )"), &text("(/)")), "differs in y");
}

//! What is not followed is open, and only what depends on it is not decided.

use super::answers;
use expect_test::{Expect, expect};
use std::fmt::Write;

/// The verdicts, and what was left open.
fn check(program: &str, properties: &str, expected: Expect) {
    let mut text = String::new();
    for (name, answer) in answers(program, properties).expect("it has no errors") {
        let verdict = answer.verdict.word();
        let open: Vec<&str> = answer.open.iter().map(|(what, _)| what.as_str()).collect();
        writeln!(text, "{name}: {verdict} {}", open.join("; ")).expect("it can be written");
    }
    expected.assert_eq(&text.replace(" \n", "\n"));
}

#[test]
fn jumps_back() {
    check(
        "VAR_INPUT few : USINT; go : BOOL; END_VAR
VAR n, sum : INT; END_VAR
+--[ ]( a )--[/]( down )--( )( up )--+
+--[ ]( b )--[/]( up )--( )( down )--+
+--[MOV]( n, 0 )--[MOV]( sum, 0 )--+
+--<LBL>( again )--[ADD]( n, n, 1 )--[ADD]( sum, sum, n )--+
+--[ ]( go )--[LT]( n, few )--[LT]( n, 4 )--<JMP>( again )--+
+--[ ]( go )--( )( gone )--+
",
        "program p.clad
never up and down
never gone and not go
always n >= 1 and n <= 4
possible sum = 10
never sum > 9
when n = 3: sum = 6
when not go: n = 1
",
        expect![[r#"
            never up and down: proved
            never gone and not go: proved
            always n >= 1 and n <= 4: proved
            possible sum = 10: possible
            never sum > 9: violated
            when n = 3: sum = 6: proved
            when not go: n = 1: proved
        "#]],
    );
}

#[test]
fn a_jump_back_that_may_not_end() {
    check(
        "+--[ ]( a )--[/]( down )--( )( up )--+
+--[ ]( b )--[/]( up )--( )( down )--+
+--<LBL>( again )--[ADD]( n, n, 1 )--[ ]( more )--<JMP>( again )--+
+--[ ]( go )--( )( gone )--+
",
        "program p.clad
never up and down
never gone and not go
when not more: n = was(n) + 1
possible up
",
        expect![[r#"
            never up and down: proved
            never gone and not go: unknown a jump may go back more often than is followed
            when not more: n = was(n) + 1: proved a jump may go back more often than is followed
            possible up: possible
        "#]],
    );
}

#[test]
fn a_loop_that_a_tag_counts() {
    let program = "VAR_INPUT few : USINT; many : DINT; go : BOOL; END_VAR
VAR sum, all, turns : INT; x : BOOL; END_VAR
+--[MIN]( turns, few, 5 )--[MOV]( sum, 0 )--[MOV]( all, 0 )--+
+--<FOR>( turns )--+
+--[ADD]( sum, sum, 2 )--+
+--<NEXT>--+
+--[ ]( go )--<FOR>( many )--+
+--[ADD]( all, all, 1 )--+
+--<NEXT>--+
+--[ ]( go )--( )( x )--+
";
    check(
        program,
        "program p.clad
never sum > 10
possible sum = 10
never sum > 9
when not go: all = 0
never all > 63
",
        expect![[r#"
            never sum > 10: proved
            possible sum = 10: possible
            never sum > 9: violated
            when not go: all = 0: proved a loop may make more turns than are followed
            never all > 63: violated a loop may make more turns than are followed
        "#]],
    );
}

#[test]
fn texts_the_serial_port_and_reals() {
    check(
        "VAR_INPUT a, b : BOOL; name : STRING; level : REAL; END_VAR
VAR code : USINT; share : REAL; came : BOOL; END_VAR
+--[ ]( a )--[EQ]( name, 'pump' )--( )( named )--+
+--[ ]( b )--[URCV]( code )--( )( came )--+
+--[MUL]( share, level, 0.5 )--[GT]( share, 10.0 )--( )( high )--+
+--[ ]( a )--[/]( b )--( )( free )--+
",
        "program p.clad
never named and not a
never named and b
never code = 13
never high
never free and b
",
        expect![[r#"
            never named and not a: proved
            never named and b: unknown texts are not tracked
            never code = 13: unknown the serial port is not tracked
            never high: unknown arithmetic of reals is not tracked
            never free and b: proved
        "#]],
    );
}

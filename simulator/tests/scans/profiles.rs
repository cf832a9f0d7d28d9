//! Profiles: what instructions do otherwise. That whole programs do what they did on their own systems is compared where
//! those can be read.

use crate::support::{check, force, get, set, simulation};
use expect_test::expect;
use ladder_simulator::{Options, Simulation, Status};
use std::sync::Arc;

fn ldmicro(text: &str) -> String {
    format!("# ladder: profile ldmicro #\n{text}")
}

fn iot(text: &str) -> String {
    format!("# ladder: profile iot #\n{text}")
}

#[test]
fn timers_count_scans_and_are_variables() {
    check(
        &ldmicro(
            "VAR_INPUT en, jump : BOOL; END_VAR\nVAR t : TON; END_VAR\n\
             +--[ ]( en )--[TON]( t, T#40ms )--( )( y )--+\n\
             +--[ ]( jump )--[MOV]( t.ET, 3 )--+\n",
        ),
        "en   _------_--\njump _______-__",
        "t.Q t.ET t.PT y",
        expect![[r#"
            t.Q   ____---_--
            t.ET  0 1 2 3 3 3 3 3 3 3
            t.PT  3 3 3 3 3 3 3 3 3 3
            y     ____---_--
        "#]],
    );
}

#[test]
fn counters_share_a_tag_and_wrap() {
    check(
        &ldmicro(
            "VAR_INPUT up, down, far, clear : BOOL; END_VAR\nVAR c : CTU; END_VAR\n\
             +--[ ]( far )--[MOV]( c.CV, 32767 )--+\n\
             +--[ ]( up )--[CTU]( c, 2 )--( )( high )--+\n\
             +--[ ]( down )--[CTD]( c, 1 )--( )( low )--+\n\
             +--[ ]( clear )--(RES)( c )--+\n",
        ),
        "up    -_-_____-_\ndown  _____-____\nfar   _______-__\nclear _________-",
        "c.CV high low",
        expect![[r#"
            c.CV  1 1 2 2 2 1 1 32767 -32768 0
            high  __----_-__
            low   --------__
        "#]],
    );
}

#[test]
fn a_timer_that_cannot_count_is_refused() {
    let text = ldmicro("VAR t : TON; END_VAR\n+--[TON]( t, T#10ms )--( )( y )--+\n");
    let analysis = ladder_analysis::analyze(&Arc::new(ladder_syntax::parse(&text)), "test.clad");
    let program = analysis.program().expect("it is a warning");
    let error = Simulation::new(Arc::clone(program), Options::default()).expect_err("it is too short");
    expect![
        "Timer period too short (needs faster cycle time): a timer of this profile takes two scans or more"
    ]
    .assert_eq(&error.message);
    let fast = Options {
        interval: 1_000_000,
        ..Options::default()
    };
    assert!(Simulation::new(Arc::clone(program), fast).is_ok());
}

#[test]
fn a_division_by_zero_is_the_last_scan() {
    let mut simulation = simulation(&ldmicro(
        "VAR q : INT := 7; z : INT; after : INT; END_VAR\n\
         +--[DIV]( q, 5, z )--[MOV]( after, 1 )--+\n",
    ));
    assert!(simulation.scan());
    assert_eq!(
        (get(&simulation, "q"), get(&simulation, "after")),
        ("0".into(), "1".into())
    );
    assert_eq!(simulation.status(), Status::Ended);
    let faults = simulation.take_faults();
    assert!(
        faults[0]
            .message
            .starts_with("Division by zero; halting simulation"),
        "{faults:?}"
    );
    assert!(!simulation.scan());
}

#[test]
fn tables_write_nothing_outside() {
    check(
        &ldmicro(
            "VAR_INPUT i : INT; END_VAR\nVAR y, p : INT; END_VAR\n\
             +--[LUT]( y, i, 10, 20 )--[PWL]( p, i, 0, 0, 10, 100, 20, -100 )--( )( on )--+\n",
        ),
        "i 0 1 2 -1 14 21",
        "y p on",
        expect![[r#"
            y   10 20 20 20 20 20
            p   0 10 20 -10 20 20
            on  ------
        "#]],
    );
}

#[test]
fn texts_are_sent_byte_by_byte() {
    let mut simulation = simulation(&ldmicro(
        "VAR n : INT := 12345; END_VAR\n+--[ ]( SYS.OFF )--[FMT]( '\\3;\\-2', n )--( )( busy )--+\n",
    ));
    let mut sent = Vec::new();
    for _ in 0..14 {
        simulation.scan();
        if get(&simulation, "n") == "12345" && sent.len() == 4 {
            set(&mut simulation, "n", "-7");
        }
        sent.extend(simulation.take_serial());
    }
    expect![[r#""\\xab45;- 7""#]].assert_eq(&format!("{:?}", sent.escape_ascii().to_string()));
}

#[test]
fn a_master_relay_toggles() {
    check(
        &ldmicro(
            "VAR_INPUT a, b : BOOL; END_VAR\n\
             +--[ ]( a )--<MCR>--+\n+-----( )( y )--+\n+--[ ]( b )--<MCR>--+\n+-----( )( z )--+\n",
        ),
        "a _-_-\nb __--",
        "y z",
        expect![[r#"
            y  _-_-
            z  -_--
        "#]],
    );
}

#[test]
fn numbers_are_bools_and_bools_are_numbers() {
    check(
        &iot(
            "VAR_INPUT I1 : BOOL; n : DINT; END_VAR\nVAR_OUTPUT Q1, Q2, Q3 : BOOL; k : DINT; END_VAR\n\
             +--[ ]( n )--( )( Q1 )--+\n\
             +--[NOT]( Q2, I1 )--+\n\
             +--[AND]( Q3, n, 4 )--+\n\
             +--[ ]( I1 )--( )( k )--+\n\
             +--[XOR]( MI01, n, I1 )--+\n",
        ),
        "I1 _-_-\nn  0 2 4 -1",
        "Q1 Q2 Q3 k MI01",
        expect![[r#"
            Q1    _---
            Q2    ----
            Q3    __--
            k     0 1 0 1
            MI01  0 3 4 -2
        "#]],
    );
}

#[test]
fn arithmetic_is_that_of_the_operands() {
    let mut simulation = simulation(&iot("VAR b : USINT; f : REAL; zero : REAL; END_VAR\n\
         +--[DIV]( f, 7, 2 )--[ADD]( MI01, 3.5, 0.25 )--[MUL]( MI02, 2147483647, 2 )--[ADD]( b, 250, 10 )--+\n\
         +--[DIV]( MF01, 1.0, zero )--[ ]( MF01 )--( )( on )--+\n"));
    simulation.scan();
    let held = ["f", "MI01", "MI02", "b", "MF01", "on"].map(|tag| get(&simulation, tag));
    expect!["3.0 3 -2 4 inf 1"].assert_eq(&held.join(" "));
    assert!(simulation.take_faults().is_empty());
}

#[test]
fn edges_of_a_tag_share_their_memory() {
    check(
        &iot("+--[P]( I1 )--( )( Q1 )--+\n+--[P]( I1 )--( )( Q2 )--+\n+--[P]( I2 )--( )( Q3 )--+\n"),
        "I1 _--_-\nI2 _--_-",
        "Q1 Q2 Q3",
        expect![[r#"
            Q1  _-__-
            Q2  _____
            Q3  _-__-
        "#]],
    );
}

#[test]
fn timers_count_steps_and_latch() {
    check(
        &iot(
            "VAR_INPUT en, r : BOOL; END_VAR\nVAR t : TON; o : TOF; c : CTD; END_VAR\n\
             +--[ ]( en )--[TON]( t, T#40ms, B := T#20ms )--( )( y )--+\n\
             +--[ ]( en )--[TOF]( o, 2, B := T#20ms )--( )( z )--+\n\
             +--[ ]( en )--[CTD]( c, 4, AC := 5 )--( )( w )--+\n\
             +--[ ]( r )--(RES)( c )--+\n",
        ),
        "en _------_-_-\nr  _________-_",
        "t.AC t.DN y z c.AC c.DN c.CC w",
        expect![[r#"
            t.AC  0 0 1 1 2 2 2 0 0 0 0
            t.DN  ____---____
            y     ____---____
            z     _---____-_-
            c.AC  5 4 4 4 4 4 4 4 3 5 4
            c.DN  _--------_-
            c.CC  _------_-_-
            w     _------_-_-
        "#]],
    );
}

#[test]
fn what_a_system_does_not_have_is_an_error() {
    for (profile, block, expected) in [
        (
            "ldmicro",
            "[TP]( t, T#1s )",
            "there is no [TP] in the profile `ldmicro`",
        ),
        (
            "iot",
            "[RTO]( t, T#1s )",
            "there is no [RTO] in the profile `iot`",
        ),
        (
            "ldmicro",
            "[TON]( t, T#1s, R := r )",
            "[TON] has no operand `R` in the profile `ldmicro`",
        ),
    ] {
        let text = format!("# ladder: profile {profile} #\n+--{block}--( )( y )--+\n");
        let analysis = ladder_analysis::analyze(&Arc::new(ladder_syntax::parse(&text)), "test.clad");
        let messages: Vec<&str> = analysis.errors().map(|error| error.message.as_str()).collect();
        assert!(messages.contains(&expected), "{messages:?}");
    }
}

/// A timer or counter that an index chooses does what it does alone, and no other changes.
#[test]
fn a_computed_index_chooses_where_all_is_in_the_tag() {
    let program = |profile: &str, ty: &str, rung: &str, place: &str| {
        let rung = rung.replace('X', place);
        format!(
            "# ladder: profile {profile} #\nVAR_INPUT\n    a, b, r : BOOL;\nEND_VAR\nVAR\n    x : ARRAY[1..3] OF {ty};\n    k : INT := 2;\n    u : BOOL;\n    y : BOOL;\nEND_VAR\n{rung}\n"
        )
    };
    let reset = "--( )( y )--+\n+--[ ]( r )--(RES)( X )--+";
    for (profile, ty, block, members) in [
        ("iot", "TON", "[TON]( X, 3, B := T#10ms )", "Q ET"),
        ("iot", "TOF", "[TOF]( X, 3, B := T#10ms )", "Q ET"),
        ("iot", "CTU", "[CTU]( X, 3 )", "Q CV"),
        ("iot", "CTD", "[CTD]( X, 3, AC := 7 )", "Q CV"),
        ("click", "CTU", "[CTU]( X, 1, R := b )", "Q CV"),
        ("click", "CTUD", "[CTUD]( X, 3, CD := b, R := r )", "QU QD CV"),
        ("iec", "RTO", "[RTO]( X, T#30ms, R := b )", "Q ET"),
    ] {
        let rung = format!("+--[ ]( a )--{block}{reset}");
        let mut runs = Vec::new();
        for (place, plain) in [("x[2]", false), ("x[k]", false), ("x[2]", true), ("x[k]", true)] {
            let mut simulation = simulation(&program(profile, ty, &rung, place));
            if plain {
                force(&mut simulation, "u", "0");
            }
            let all = |simulation: &Simulation, element: &str| {
                let members = members.split(' ').map(|member| format!("x[{element}].{member}"));
                let values = members.map(|member| get(simulation, &member));
                values.collect::<Vec<_>>().join(" ")
            };
            let others = (all(&simulation, "1"), all(&simulation, "3"));
            let mut shown = String::new();
            let mut random = 7u32;
            for _ in 0..60 {
                for input in ["a", "b", "r"] {
                    random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                    let most = if input == "a" { 11 } else { 1 };
                    let value = if random >> 28 < most { "1" } else { "0" };
                    set(&mut simulation, input, value);
                }
                simulation.scan();
                let of = |element: &str| all(&simulation, element);
                shown.push_str(&format!("{} {}\n", get(&simulation, "y"), of("2")));
                assert_eq!((of("1"), of("3")), others, "{block} of {profile}");
            }
            runs.push(shown);
        }
        for run in &runs[1..] {
            assert_eq!(*run, runs[0], "{block} of {profile}");
        }
        assert!(
            runs[0].contains("1 "),
            "{block} of {profile} does something:\n{}",
            runs[0]
        );
    }
}

//! Networks and rungs of a size that nobody draws: the time may grow with the text, not faster.

use ladder_format::{Options, format_text};
use std::fmt::Write as _;

fn stays(text: &str) -> bool {
    format_text(text, &Options::default()) == text
}

/// Each rung is three columns right of the one above it, so a drawing of n rungs takes n² columns.
fn staircase(rungs: usize) -> String {
    let mut text = String::from("+-\\\n");
    for _ in 2..rungs {
        text.push_str("/-\\\n");
    }
    text.push_str("/-[ ]( a )\n");
    text
}

#[test]
fn a_staircase_is_drawn_while_there_is_room() {
    assert!(!stays(&staircase(1_000)));
    assert!(stays(&staircase(50_000)));
}

#[test]
fn what_follows_a_staircase_is_formatted() {
    let text = staircase(50_000) + "\n+-[ ]( a )-( )( y )-+\n";
    let new = format_text(&text, &Options::default());
    assert!(new.ends_with(&format!("\n+--[ ]( a ){}( )( y )--+\n", "-".repeat(58))));
}

#[test]
fn a_network_of_many_rungs() {
    let mut text = String::from("+-\\-[ ]( a )-( )( y )-+\n");
    for rung in 1..20_000 {
        let _ = if rung % 2 == 1 {
            writeln!(text, "/-[ ]( a{rung} )-\\-( )( y{rung} )-+")
        } else {
            writeln!(text, "+-\\--[ ]( a{rung} )-/")
        };
    }
    text.push_str("/-[ ]( last )\n");
    let new = format_text(&text, &Options::default());
    let widths: Vec<usize> = new.lines().map(str::len).collect();
    assert!(
        widths.iter().all(|&width| width == 80),
        "{:?}",
        widths.iter().max()
    );
}

#[test]
fn a_rung_of_many_elements() {
    let text = format!(
        "+-{}( )( y )-+\n",
        "[ ]( a )-# c #- -[/](b)|--|-(s)( t )".repeat(10_000)
    );
    let new = format_text(&text, &Options::default());
    assert!(stays(&new));
    let many = format!(
        "+-{}-+\n/{}-+\n",
        "\\-( )( y )-".repeat(10_000),
        "/-( )( z )-".repeat(9_999)
    );
    let new = format_text(&many, &Options::default());
    assert!(stays(&new));
}

#[test]
fn many_errors_on_a_rung() {
    let text = format!("+-{}-( )( y )-+\n", "[TON](t,)-".repeat(2_000));
    let new = format_text(&text, &Options::default());
    assert!(new.starts_with("+----"), "{new:.50}");
    assert!(new.contains("--[TON](t,)--[TON](t,)--"));
}

#[test]
fn a_line_that_is_split_very_often() {
    for end in ["\n", ""] {
        let text = format!("VAR {}END_VAR{end}", "a : INT; ".repeat(50_000));
        let new = format_text(&text, &Options::default());
        assert_eq!(new.lines().count(), 50_002);
        let text = format!("{}+-[ ]( a )-( )( y )-+{end}", "# c #".repeat(50_000));
        let new = format_text(&text, &Options::default());
        assert_eq!(new.lines().count(), 50_001);
    }
}

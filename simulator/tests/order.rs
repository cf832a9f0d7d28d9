//! The order of evaluation follows the wiring alone: the same drawing in other columns does the same.

mod support;

use expect_test::expect;
use support::{check, get, simulation};

/// Each block appends its digit to x when it is evaluated.
fn digit(n: u8) -> String {
    format!("[CALC]( x, (x * 10) + {n} )")
}

fn order_of(drawing: &str) -> String {
    let mut text = String::from("VAR x : LINT; END_VAR\n");
    for c in drawing.chars() {
        match c {
            '1'..='9' => text.push_str(&digit(c as u8 - b'0')),
            c => text.push(c),
        }
    }
    let mut simulation = simulation(&text);
    simulation.scan();
    get(&simulation, "x")
}

#[test]
fn branches_run_before_their_join() {
    assert_eq!(order_of("+--\\--1--\\--3--+\n   /--2--/\n"), "123");
}

#[test]
fn staggered_branches() {
    let drawing = "+--\\--1----------\\--4--+\n   /--\\--2--\\--/\n      /--3--/\n";
    assert_eq!(order_of(drawing), "1234");
}

#[test]
fn side_by_side() {
    let drawing = "+--\\--1--\\--3--\\--4--\\--6--+\n   /--2--/     /--5--/\n";
    assert_eq!(order_of(drawing), "123456");
}

#[test]
fn a_branch_that_passes_a_line() {
    let drawing = "+--\\-----\\--1--\\-----\\--5--+\n   /--\\  /--2--/  \\--/\n      /--3--------/--4--+\n";
    assert_eq!(
        order_of(drawing),
        order_of(&drawing.replace("  /--2--/  ", "/--2--/"))
    );
}

#[test]
fn a_bridge() {
    // The lower line runs up to its second `/` when the upper line asks for it.
    let drawing = "+--1--\\--2--\\--3--+\n+--4--/--5--/--6--+\n";
    assert_eq!(order_of(drawing), "142536");
}

#[test]
fn columns_do_not_matter() {
    let near = "+--\\--1--\\--4--\\--5--+\n   /--\\--/--2--/\n      /--3--+\n";
    let far =
        "+--------\\--1---------------\\--4--\\----5----+\n/--\\--/--2--/\n                    /--3--+\n";
    assert_eq!(order_of(near), order_of(far));
}

#[test]
fn a_write_is_seen_by_every_later_read() {
    check(
        "VAR_INPUT a : BOOL; END_VAR\nVAR b, c, d : BOOL; END_VAR\n\
         +--[ ]( c )--( )( d )--+\n\
         +--[ ]( a )--( )( b )--[ ]( b )--( )( c )--+\n",
        "a _--_",
        "b c d",
        expect![[r#"
            b  _--_
            c  _--_
            d  __--
        "#]],
    );
}

#[test]
fn power_never_flows_back() {
    check(
        "VAR_INPUT a, b, x : BOOL; END_VAR\nVAR y, z : BOOL; END_VAR\n\
         +--[ ]( a )--\\--( )( y )--------------+\n\
         \x20            /--[ ]( x )--\\\n\
         +--[ ]( b )---------------/--( )( z )--+\n",
        "a _-__-\nb __-_-\nx ----_",
        "y z",
        expect![[r#"
            y  _-__-
            z  _--_-
        "#]],
    );
}

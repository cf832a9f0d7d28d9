//! The order of evaluation follows the wiring alone: the same drawing in other columns does the same.

use crate::support::{check, get, simulation};
use expect_test::expect;

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

/// Line 1 goes to its second `\`. Line 2 is called for: it goes on after its first `/` to its own first `\`, and
/// line 3 begins there; each calls the next line before it comes back.
#[test]
fn four_staggered_lines() {
    let drawing = "+--\\--1-----------------\\--6--+\n   /--\\--2-----------\\--/\n      /--\\--3--\\--5--/\n         /--4--/\n";
    assert_eq!(order_of(drawing), "123456");
}

/// A line may go on to a rail of its own: what is right of its last `/` comes after the whole line above.
#[test]
fn what_hangs_after_a_join_comes_last() {
    // run(1): 1, then line 2 up to its `/`: 3; then 2. run(2): 4.
    assert_eq!(order_of("+--1--\\--2--+\n+--3--/--4--+\n"), "1324");
    // run(1): 1, line 2 up to its first `/`: 4; 2, line 2 up to its second: 5; 3. run(2): its `\` asks line 3: 7;
    // then 6. run(3): 8.
    assert_eq!(
        order_of("+--1--\\--2--\\--3------+\n+--4--/--5--/--\\--6--+\n+--7-----------/--8--+\n"),
        "14253768"
    );
}

/// The branch of line 3 passes line 2 on either side. After its second `/` line 3 has a wire of its own, which
/// comes after all.
#[test]
fn a_branch_that_passes_and_goes_on() {
    // run(1): both `\` at the left give nothing but power; 1; line 2 up to its third `/`: 2; line 2 up to its
    // fourth, for which line 3 is asked: 3; 5. run(2): nothing is left. run(3): 4.
    let drawing = "+--\\-----\\--1--\\-----\\--5--+\n   /--\\  /--2--/  \\--/\n      /--3--------/--4--+\n";
    assert_eq!(order_of(drawing), "12354");
}

/// A segment that begins with a `\` gets its power from the line below.
#[test]
fn power_from_below() {
    // run(1): line 2 up to its `/`: 1; then 2. run(2): 3.
    assert_eq!(order_of("      \\--2--+\n+--1--/--3--+\n"), "123");
    // The first segment of line 1 is run before the second asks for line 2.
    assert_eq!(order_of("+--1--    \\--3--+\n+----2----/--4--+\n"), "1234");
}

/// What a jump leaves is not run: neither what is right of it nor the lines above and below that wait for it.
#[test]
fn a_jump_out_of_a_branch_leaves_the_whole_network() {
    let drawing = "+--\\--1--\\--3--+\n   /--2--<JMP>( out )--/\n+--4--+\n+--<LBL>( out )--5--+\n";
    // The four is a network of its own, jumped over.
    assert_eq!(order_of(drawing), "125");
}

/// The branch writes m before the contact that is right of the join reads it: y follows at once.
#[test]
fn a_write_in_a_branch_is_seen_after_the_join() {
    check(
        "VAR_INPUT go : BOOL; END_VAR\nVAR m, y : BOOL; END_VAR\n\
         +--\\--[ ]( go )-----------\\--[ ]( m )--( )( y )--+\n   /--[ ]( go )--( )( m )--/\n",
        "go _-__",
        "m y",
        expect![[r#"
            m  _-__
            y  _-__
        "#]],
    );
}

/// The contact on line 1 reads m before the branch below it writes it: y falls one scan after go.
#[test]
fn a_read_above_comes_before_the_write_below() {
    check(
        "VAR_INPUT go : BOOL; END_VAR\nVAR m, y : BOOL; END_VAR\n\
         +--\\--[ ]( m )------------\\--( )( y )--+\n   /--[ ]( go )--( )( m )--/\n",
        "go _-__",
        "m y",
        expect![[r#"
            m  _-__
            y  _--_
        "#]],
    );
}

/// Side by side: the coil of the first branch is read by the second, and by what is between them.
#[test]
fn side_by_side_writes_are_seen_to_the_right() {
    check(
        "VAR_INPUT go : BOOL; END_VAR\nVAR m, n, y : BOOL; END_VAR\n\
         +--\\--[/]( n )------------\\--[ ]( m )--\\--[/]( go )--\\--( )( y )--+\n\
         \x20  /--[ ]( go )--( )( m )--/           /--[ ]( m )--( )( n )--/\n",
        // Scan 1: n is still low; m and, after it, n go high; y. Scan 2: m falls, and the contact after it cuts all.
        "go _-__",
        "m n y",
        expect![[r#"
            m  _-__
            n  _-__
            y  _-__
        "#]],
    );
}

//! What cannot be read: it stays, with its place and a reason.

use super::truth::read;
use expect_test::{Expect, expect};

#[track_caller]
fn check(drawing: &str, expected: Expect) {
    expected.assert_eq(&read(drawing));
}

#[test]
fn elements_that_stay_as_comments_in_the_wire() {
    check(
        "
   a                      y
|--| |---| |---{FIFO}-----( )--|
   b                      z
|--| |---[MOV 5 n]--[PID]-( )--|
",
        expect![[r#"
            # a                      y #
            # |--| |---| |---{FIFO}-----( )--| #

            +--[ ]( b )--# [MOV 5 n] #--[ ]( PID )-------------------------------( )( z )--+
            3:15 refused |--| |---| |---{FIFO}-----( )--|: the wire ends here, and no line leads on from it
            3:16 refused |--| |---| |---{FIFO}-----( )--|: `{FIFO}` is in the wire: a name belongs above its contact, or inside it
            3:22 refused |--| |---| |---{FIFO}-----( )--|: no wire leads here from the left, and no line from above or below
            5:10 refused [MOV 5 n]: where its result goes is not the same in all systems: write [MOV]( result, operands )
        "#]],
    );
}

#[test]
fn wires_that_cannot_be_followed() {
    // A branch whose joint is not under the one above it.
    check(
        "
   a              y
|--| |-----+------( )--|
   b       |
|--| |--+
",
        expect![[r#""#]],
    );
    // Lines that cross, or meet.
    check(
        "
   a      |    y
|--| |----|----( )--|
   b      |    z
|--| |----+----( )--|
   c      |
|--| |----+
",
        expect![[r#""#]],
    );
    // A hole in the wire, and a word in it.
    check(
        "
   a               y
|--| |--  ---------( )--|

   b               z
|--| |--wire-------( )--|
",
        expect![[r#""#]],
    );
}

#[test]
fn boxes() {
    check(
        "
|   a     +------+    y
+--| |----|IN   Q|---( )--+
|     5s--|PT    |        |
|         +------+        |
|           t2            |
|   a     +------+    y   |
+--| |----|IN   Q|---( )--+
|  TON    | TP   |        |
|   b     | PT   |        |
+--| |----|R     |        |
|         +------+        |
",
        expect![[r#"
            +--[ ]( a )--# |IN   Q| #--------------------------------------------( )( y )--+

            +--[ ]( a )--# |IN   Q| t2 #-----------------------------------------( )( y )--+

            # |  TON    | TP   |        | #
            # |   b     | PT   |        | #
            # +--| |----|R     |        | #
            # |         +------+        | #
            3:11 refused |IN   Q|: the box does not say which block it is: TON, TOF and TP have these pins
            8:11 refused |IN   Q| t2: wires lead to more than one pin of the box: write a tag at all but the first
            11:10 refused +--| |----|R     |        |: the wire ends here, and no line leads on from it
        "#]],
    );
}

#[test]
fn what_is_no_drawing() {
    check("Dear all,\n\nwhat is a rung?\n", expect![[r#""#]]);
    check("| a | b |\n|---|---|\n| 1 | 2 |\n", expect![[r#""#]]);
}

#[test]
fn names_that_ladder_text_cannot_hold() {
    check(
        "
  Stop button   I:0/1        Pump on
|----|/|--------| |------------( )-----|
",
        expect![[r#""#]],
    );
}

#[test]
fn what_is_written_next_to_a_drawing_stays_as_comments() {
    check(
        "
From a friend; works on his controller.

Rung 1: seal-in
            Start      Stop          Motor
  1    |-----] [---+----]/[-----------( )-----|   main drive
       |    Motor  |                          |
       |-----] [---+                          |   ; holds itself
",
        expect![[r#""#]],
    );
}

#[test]
fn a_large_drawing_takes_little_time() {
    let mut drawing = String::new();
    for rung in 0..3_000 {
        drawing.push_str(&format!("|   a{rung}              y{rung}   |\n|--| |---+-------( )---|\n"));
    }
    assert!(read(&drawing).contains("( )( y2999 )"));
    assert!(!read(&"|-+-".repeat(2_000)).is_empty());
    assert!(!read(&"+-|(\n".repeat(20_000)).is_empty());
}

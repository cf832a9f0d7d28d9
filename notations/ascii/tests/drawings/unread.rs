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
            3:10 refused | |: no name is above this contact or inside it
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
        expect![[r#"
            # a              y #
            # |--| |-----+------( )--| #

            # b       | #
            # |--| |--+ #
            3:12 refused |--| |-----+------( )--|: the line that leads up or down from here ends at nothing
            5:9 refused |--| |--+: the wire ends here, and no line leads on from it
        "#]],
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
        expect![[r#"
            # a      |    y #
            # |--| |----|----( )--| #
            # b      |    z #
            # |--| |----+----( )--| #
            # c      | #
            # |--| |----+ #
            3:11 refused |--| |----|----( )--|: the line that leads up or down from here ends at nothing
            3:11 refused |--| |----|----( )--|: whether the two lines meet here or only cross cannot be seen: draw + where they meet
            5:11 refused |--| |----+----( )--|: the line that leads up or down from here ends at nothing
            7:11 refused |--| |----+: the line that leads up or down from here ends at nothing
        "#]],
    );
    // A hole in the wire, and a word in it.
    check(
        "
   a               y
|--| |--  ---------( )--|

   b               z
|--| |--wire-------( )--|
",
        expect![[r#"
            # a               y #
            # |--| |--  ---------( )--| #

            # b               z #
            # |--| |--wire-------( )--| #
            3:8 refused |--| |--  ---------( )--|: the wire ends here, and no line leads on from it
            3:11 refused |--| |--  ---------( )--|: no wire leads here from the left, and no line from above or below
            6:8 refused |--| |--wire-------( )--|: the wire ends here, and no line leads on from it
            6:9 refused |--| |--wire-------( )--|: `wire` is in the wire: a name belongs above its contact, or inside it
            6:13 refused |--| |--wire-------( )--|: no wire leads here from the left, and no line from above or below
        "#]],
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

            # TON #
            +--[ ]( a )--# |IN   Q| t2 #-----------------------------------------( )( y )--+
            3:11 refused |IN   Q|: the box does not say which block it is: TON, TOF and TP have these pins
            8:11 refused |IN   Q| t2: its operand PT is not in the drawing
        "#]],
    );
}

#[test]
fn a_timer_without_a_name_gets_one() {
    check(
        "
|   a    +-TON--+    y   |
+--[ ]---|IN   Q|---( )--+
|    5s--|PT    |        |
|        +------+        |
",
        expect![[r#"
            +--[ ]( a )------------------------------------[TON]( ton_1, T#5s )--( )( y )--+
            1:1 approximated ton_1: a timer or counter of the drawing has no name; it has this one here
        "#]],
    );
}

#[test]
fn what_is_no_drawing() {
    check(
        "Dear all,\n\nwhat is a rung?\n",
        expect![[r#"
        there is no drawing in the file: no contact or coil is on a wire
    "#]],
    );
    check(
        "| a | b |\n|---|---|\n| 1 | 2 |\n",
        expect![[r#"
        there is no drawing in the file: no contact or coil is on a wire
    "#]],
    );
}

#[test]
fn names_that_ladder_text_cannot_hold() {
    check(
        "
  Stop button   I:0/1        Pump on
|----|/|--------| |------------( )-----|
",
        expect![[r#"
            +--[/]( Stop_button )--[ ]( I_0_1 )----------------------------( )( Pump_on )--+
            1:1 approximated I:0/1: this is not a name of its own in ladder text; it is `I_0_1` here
            1:1 approximated Pump on: this is not a name of its own in ladder text; it is `Pump_on` here
            1:1 approximated Stop button: this is not a name of its own in ladder text; it is `Stop_button` here
        "#]],
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
        expect![[r#"
            # From a friend; works on his controller. #

            # Rung 1: seal-in #
            # 1  main drive #
            # holds itself #
            +--[ ]( Start )--\--[/]( Stop )----------------------------------( )( Motor )--+
            +--[ ]( Motor )--/                                                             |
        "#]],
    );
}

#[test]
fn a_large_drawing_takes_little_time() {
    let mut drawing = String::new();
    for rung in 0..3_000 {
        drawing.push_str(&format!(
            "|  {:<13} {:<5} |\n|--| |-----------( )---|\n",
            format!("a{rung}"),
            format!("y{rung}")
        ));
    }
    assert!(read(&drawing).contains("( )( y2999 )"));
    assert!(!read(&"|-+-".repeat(2_000)).is_empty());
    assert!(!read(&"+-|(\n".repeat(20_000)).is_empty());
}

#[test]
fn a_title_right_above_a_rung_is_no_name() {
    check(
        "# of a forum #\n|--| |-----| |------( )--|\n",
        expect![[r#"
        # of a forum #
        +--# | | #--# | | #--# ( ) #---------------------------------------------------+
        2:4 refused | |: no name is above this contact or inside it
        2:12 refused | |: no name is above this contact or inside it
        2:21 refused ( ): no name is above this coil or inside it
    "#]],
    );
    check(
        "This starts the whole pump\n|--| |----------------------| |------( )--|\n",
        expect![[r#"
            +--# | | This starts the whole pump #--# | | #--# ( ) #------------------------+
            2:4 refused | | This starts the whole pump: `This starts the whole pump` is no name of a tag
            2:29 refused | |: no name is above this contact or inside it
            2:38 refused ( ): no name is above this coil or inside it
        "#]],
    );
}

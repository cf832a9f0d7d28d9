//! Drawings, each in a form of its own, with the truth table of an output.

use super::truth::check;

#[test]
fn bars_with_names_above() {
    check(
        "
  start      stop              run
|--| |---+----|/|--------------( )--|
|        |                          |
|  run   |                          |
|--| |---+                          |
",
        "run",
        &["start", "run", "stop"],
        |v| (v[0] || v[1]) && !v[2],
    );
}

#[test]
fn an_inactive_coil() {
    for drawing in [
        "   I0     I1      Q0\n|-| |----|/|-----(~)-|\n",
        "|--[I0]--[/I1]--(~Q0)--|\n",
    ] {
        check(drawing, "Q0", &["I0", "I1"], |v| !v[0] || v[1]);
    }
}

#[test]
fn brackets_that_open_outward() {
    check(
        "
      Key      Guard    Fault        Drive
|----] [------] [------]/[-----+------( )-----|
|                              |              |
|     Jog        Slow          |              |
|----] [----------] [----------+              |
",
        "Drive",
        &["Key", "Guard", "Fault", "Jog", "Slow"],
        |v| (v[0] && v[1] && !v[2]) || (v[3] && v[4]),
    );
}

#[test]
fn names_inside_brackets() {
    check(
        "---[auto]---+---[/full]---(pump)---\n            |\n---[hand]---+\n",
        "pump",
        &["auto", "hand", "full"],
        |v| (v[0] || v[1]) && !v[2],
    );
}

#[test]
fn names_inside_bars_and_double_rails() {
    check(
        "
||--|door|--+--|/lock|--+--(open)--||
||          |           |          ||
||          +--|panic|--+          ||
",
        "open",
        &["door", "lock", "panic"],
        |v| v[0] && (!v[1] || v[2]),
    );
}

#[test]
fn three_branches_of_box_characters() {
    check(
        "
│  Go       Halt            Fan
├──┤ ├───┬──┤/├─────────────( )──┤
│  Jog   │
├──┤ ├───┤
│  Fan   │
├──┤ ├───┘
",
        "Fan",
        &["Go", "Jog", "Fan", "Halt"],
        |v| (v[0] || v[1] || v[2]) && !v[3],
    );
}

#[test]
fn branches_within_branches_of_box_characters() {
    check(
        "
     a        b              y
├──┬─┤ ├────┬─┤ ├─┬─────────( )──┤
│  │        │  c  │              │
│  │        └─┤/├─┤              │
│  │  d           │              │
│  └──┤ ├─────────┘              │
",
        "y",
        &["a", "b", "c", "d"],
        |v| (v[0] && (v[1] || !v[2])) || v[3],
    );
}

#[test]
fn semigraphics_of_the_standard() {
    check(
        "
|  IN1    IN2                OUT1
+--| |--+-|/|----------------( )---+
|       |                          |
|  IN3  |                          |
+--| |--+                          |
|       |                    OUT2  |
|       +--------------------(/)---+
",
        "OUT1",
        &["IN1", "IN3", "IN2"],
        |v| (v[0] || v[1]) && !v[2],
    );
    check(
        "
|  IN1    IN2                OUT1
+--| |--+-|/|----------------( )---+
|       |                          |
|  IN3  |                          |
+--| |--+                          |
|       |                    OUT2  |
|       +--------------------(/)---+
",
        "OUT2",
        &["IN1", "IN3"],
        |v| !(v[0] || v[1]),
    );
}

#[test]
fn latch_and_unlatch_of_a_controller_family() {
    let drawing = "
        I:0/1                       O:2/3
0000 |---] [------------------------(L)---|
        I:0/2   I:0/3               O:2/3
0001 |---]/[-----] [----------------(U)---|
";
    check(drawing, "O_2_3", &["I_0_1", "I_0_2", "I_0_3", "O_2_3"], |v| {
        (v[3] || v[0]) && (v[1] || !v[2])
    });
}

#[test]
fn set_and_reset_coils() {
    check(
        "
| in                         out |
+--[ ]------------------------(S)-+
| clear                      out |
+--[ ]------------------------(R)-+
",
        "out",
        &["in", "clear", "out"],
        |v| (v[2] || v[0]) && !v[1],
    );
}

#[test]
fn numbers_titles_and_comments_at_the_sides() {
    check(
        "
Rung 1: the seal-in circuit
            Start      Stop          Motor
  1    |-----] [---+----]/[-----------( )-----|   main drive
       |    Motor  |                          |
       |-----] [---+                          |   (holds itself)

Rung 2: lamp
            Motor                    Lamp
  2    |-----] [----------------------( )-----|   ; green
",
        "Lamp",
        &["Start", "Motor", "Stop"],
        |v| (v[0] || v[1]) && !v[2],
    );
}

#[test]
fn a_timer_in_a_box() {
    check(
        "
                  T1
  go          +---------+      done
|             |   TON   |            |
|--| |--------|IN      Q|-------( )--|
|        5s---|PT     ET|            |
|             +---------+            |
",
        "done",
        &["go"],
        |_| false,
    );
}

#[test]
fn a_counter_in_a_box_of_box_characters() {
    check(
        "
│  part      ┌── CTU ──┐    full
├──┤ ├───────┤CU      Q├────( )──┤
│   1────────┤PV     CV│         │
│   empty────┤R        │         │
│            └─────────┘         │
",
        "full",
        &["part", "empty"],
        |v| v[0] && !v[1],
    );
}

#[test]
fn a_counter_whose_reset_is_a_contact() {
    check(
        "
|  part          +------+     full  |
|--| |-----------|CU  Q |------( )--|
|  empty         | CTU  |           |
|--| |-----------|R     |           |
|        1-------|PV    |           |
|                +------+           |
",
        "full",
        &["part", "empty"],
        |v| v[0] && !v[1],
    );
}

#[test]
fn a_timer_as_a_controller_family_draws_it() {
    check(
        "
     go                                      +TON---------------+
|----] [-------------------------------------+Timer On Delay    +-(EN)-|
|                                            |Timer        T4:0 |      |
|                                            |Time Base     1.0 +-(DN)-|
|                                            |Preset          0 |      |
|                                            |Accum           0 |      |
|                                            +------------------+      |
    T4:0/DN                                                    lamp
|----] [-------------------------------------------------------( )-----|
",
        "lamp",
        &["go"],
        |v| v[0],
    );
}

#[test]
fn branches_with_outputs_and_a_line_between_all() {
    // Power comes from two rungs and leaves on three.
    check(
        "
|    a         c     y1  |
|---| |---+---| |---( )--|
|    b    |          y2  |
|---| |---+---------( )--|
|         |   d      y3  |
|         +---|/|---( )--|
",
        "y3",
        &["a", "b", "d"],
        |v| (v[0] || v[1]) && !v[2],
    );
}

#[test]
fn a_branch_that_passes_a_rung() {
    // The left line passes the second rung on its way to the third, and a bridge leads from one branch to another.
    check(
        "
|    a      b      y  |
|-+-[ ]---+-[ ]-+-( )-|
| |  c    |  d  |     |
| +-[ ]---+-[ ]-+     |
",
        "y",
        &["a", "b", "c", "d"],
        |v| (v[0] || v[2]) && (v[1] || v[3]),
    );
    check(
        "
|    a            y  |
|-+-[ ]---------+-( )-|
| |    b     c  |     |
| |  +-[ ]-+-[ ]+     |
| |  |     |          |
| +--+     |          |
|    |  d  |          |
|    +-[/]-+          |
",
        "y",
        &["a", "b", "c", "d"],
        |v| v[0] || ((v[1] || !v[3]) && v[2]),
    );
}

#[test]
fn blocks_on_one_line() {
    check(
        "|--[count >= 0]--[/halt]--[TON T1 0s]--(run)--|\n|--[GEQ count 1]--(L more)--|\n",
        "run",
        &["halt"],
        |v| !v[0],
    );
}

#[test]
fn names_inside_without_anything_else() {
    check(
        "|--[auto]--[/full]--(pump)--|\n",
        "pump",
        &["auto", "full"],
        |v| v[0] && !v[1],
    );
    check("|--[auto]--(pump)--|\n", "pump", &["auto"], |v| v[0]);
}

#[test]
fn columns_that_are_off_by_one() {
    check(
        "
   a         b              y
|--] [---+---] [-----------( )--|
|         |                     |
|  c      |                     |
|--]/[---+                      |
",
        "y",
        &["a", "c", "b"],
        |v| (v[0] || !v[1]) && v[2],
    );
}

#[test]
fn round_corners() {
    check(
        "
     a           b       y
|----| |----.----|/|----( )---|
            |
     c      |
|----| |----'
",
        "y",
        &["a", "c", "b"],
        |v| (v[0] || v[1]) && !v[2],
    );
    check(
        "
     a             c      y
|--.-| |-.--.-----| |----( )---|
   |     |  |
   | b   |  |   d
   '-| |-'  '---| |--------( z )-|
",
        "z",
        &["a", "b", "d"],
        |v| (v[0] || v[1]) && v[2],
    );
    check(
        "
|   a     .---------.    y
+--| |----| TON  T1 |---( )--+
|         | PT 0 s  |        |
|         '---------'        |
",
        "y",
        &["a"],
        |v| v[0],
    );
}

//! Moving about.

use super::{Bench, MOTOR};
use expect_test::expect;
use std::fmt::Write;

/// A program of this many rungs.
pub(super) fn long(rungs: usize) -> String {
    let mut text = String::new();
    for rung in 0..rungs {
        let _ = writeln!(text, "+--[ ]( a{rung} )--[ ]( b{rung} )--( )( y{rung} )--+");
    }
    text
}

#[test]
fn from_block_to_block() {
    let bench = Bench::new(MOTOR);
    bench.check_info(
        "",
        expect![[r#"
            | Open contact: input start is FALSE; space switches it
        "#]],
    );
    bench.check_info(
        "right",
        expect![[r#"
            | Closed contact: input stop is FALSE; space switches it
        "#]],
    );
    bench.check_info(
        "right right right right",
        expect![[r#"
            | Coil: run is FALSE
        "#]],
    );
    bench.check_info(
        "down",
        expect![[r#"
            | Open contact: run is FALSE
        "#]],
    );
    bench.check_info(
        "down down right",
        expect![[r#"
            | On-delay timer: warmup 0s/0s, warmup.Q is FALSE
        "#]],
    );
    bench.check_info(
        "tab tab tab tab",
        expect![[r#"
            | Open contact: run is FALSE
        "#]],
    );
    bench.check_info(
        "tab tab back-tab",
        expect![[r#"
            | Closed contact: input stop is FALSE; space switches it
        "#]],
    );
    bench.check_info(
        "j l k h",
        expect![[r#"
            | Open contact: input start is FALSE; space switches it
        "#]],
    );
    bench.check_info(
        "G",
        expect![[r#"
            | Coil: output ready is FALSE
        "#]],
    );
    bench.check_info(
        "G g",
        expect![[r#"
            | Open contact: input start is FALSE; space switches it
        "#]],
    );
}

#[test]
fn scrolling() {
    let bench = Bench::new(&long(100)).size(60, 12);
    bench.check(
        "page-down page-down",
        expect![[r#"
            | motor.clad  ■ PAUSED  speed 1x              scan 0  0.00 s
            |   +──[ ]( a6 )──[ ]( b6 )──( )( y6 )──+
            |   +──[ ]( a7 )──[ ]( b7 )──( )( y7 )──+
            | > +──[ ]( a8 )──[ ]( b8 )──( )( y8 )──+
            |   +──[ ]( a9 )──[ ]( b9 )──( )( y9 )──+
            |   +──[ ]( a10 )──[ ]( b10 )──( )( y10 )──+
            |   +──[ ]( a11 )──[ ]( b11 )──( )( y11 )──+
            |─ Inputs: press the number ──────── 191 more: / finds them ─
            | 1 ○ a0   2 ○ b0   3 ○ a1   4 ○ b1   5 ○ a2   6 ○ b2
            | 7 ○ a3   8 ○ b3   9 ○ a4
            | Coil: output y8 is FALSE
            | space switch p run s step b back +- speed f force w watch ?
        "#]],
    );
    bench.check_lines(
        "G",
        0..4,
        expect![[r#"
            | motor.clad  ■ PAUSED  speed 1x              scan 0  0.00 s
            |   +──[ ]( a94 )──[ ]( b94 )──( )( y94 )──+
            |   +──[ ]( a95 )──[ ]( b95 )──( )( y95 )──+
            |   +──[ ]( a96 )──[ ]( b96 )──( )( y96 )──+
        "#]],
    );
    bench.check_lines(
        "G page-up up up",
        0..4,
        expect![[r#"
            | motor.clad  ■ PAUSED  speed 1x              scan 0  0.00 s
            |   +──[ ]( a91 )──[ ]( b91 )──( )( y91 )──+
            |   +──[ ]( a92 )──[ ]( b92 )──( )( y92 )──+
            | > +──[ ]( a93 )──[ ]( b93 )──( )( y93 )──+
        "#]],
    );
    bench.check_lines(
        "wheel:5,3 wheel:5,3",
        0..4,
        expect![[r#"
            | motor.clad  ■ PAUSED  speed 1x              scan 0  0.00 s
            |   +──[ ]( a6 )──[ ]( b6 )──( )( y6 )──+
            |   +──[ ]( a7 )──[ ]( b7 )──( )( y7 )──+
            |   +──[ ]( a8 )──[ ]( b8 )──( )( y8 )──+
        "#]],
    );
}

#[test]
fn long_lines_follow_the_selection() {
    let text = format!("+{}( )( y )--+\n", "--[ ]( contact_with_a_long_name )".repeat(6));
    let bench = Bench::new(&text).size(60, 10);
    bench.check_lines(
        "right right",
        1..2,
        expect![[r#"
            | > g_name )──[ ]( contact_with_a_long_name )──[ »( )( y )──+
        "#]],
    );
    bench.check_lines(
        "right right right right right right",
        1..2,
        expect![[r#"
            | > +──[ ]( contact_with_a_long_name )──[ ]( cont»( )( y )──+
        "#]],
    );
    bench.check_lines(
        "right right right left left left left",
        1..2,
        expect![[r#"
            | > +──[ ]( contact_with_a_long_name )──[ ]( cont»( )( y )──+
        "#]],
    );
}

#[test]
fn finding_tags() {
    let bench = Bench::new(&long(40)).size(70, 20);
    bench.check(
        "/ 'y3'",
        expect![[r#"
            | motor.clad  ■ PAUSED  speed 1x                        scan 0  0.00 s
            | > +──[ ]( a0 )──[ ]( b0 )──( )( y0 )──+
            |   +──[ ]( a1 )──[ ]( b1 )──( )( y1 )──+
            |   +──[ ]( a2 )──[ ]( b2 )──( )( y2 )──+
            |   +──[ ]( a3 )──[ ]( b3 )──( )( y3 )──+
            |   +──[ ]( a4 )──[ ]( b4 )──( )( y4 )──+
            |┌ Enter: go there ─────────────────────────────────┐
            |│   y3            BOOL      FALSE                  │
            |│   y30           BOOL      FALSE                  │
            |│   y31           BOOL      FALSE                  │
            |│   y32           BOOL      FALSE                  │
            |│   y33           BOOL      FALSE                  │re: / finds them ─
            |│   y34           BOOL      FALSE                  │   7 ○ a3   8 ○ b3
            |│   y35           BOOL      FALSE                  │
            |│   y36           BOOL      FALSE                  │ column = 100 ms ─
            |│   y37           BOOL      FALSE                  │
            |│   y38           BOOL      FALSE                  │
            |└──────────────────────────────────────────────────┘
            | find: y3   type some of its name; up, down, Enter, Esc
            | space switch p run s step b back +- speed f force w watch ? help q qu
        "#]],
    );
    bench.check_info(
        "/ 'y31' enter",
        expect![[r#"
            | Coil: output y31 is FALSE
        "#]],
    );
    bench.check_info(
        "/ 'nothing' enter",
        expect![[r#"
            | there is no tag `nothing` in this program
        "#]],
    );
    let bench = Bench::new(MOTOR);
    bench.check_info(
        "/ 'run' enter",
        expect![[r#"
            | run is in 3 blocks: n, N
        "#]],
    );
    bench.check_info(
        "/ 'run' enter n tab",
        expect![[r#"
            | Open contact: run is FALSE
        "#]],
    );
    bench.check_info(
        "/ 'run' enter N back-tab",
        expect![[r#"
            | Open contact: run is FALSE
        "#]],
    );
}

#[test]
fn a_program_without_blocks() {
    let bench = Bench::new("# nothing yet #\n").size(60, 8);
    bench.check(
        "space tab up down left page-down G / esc w esc f s",
        expect![[r#"
            | motor.clad  ■ PAUSED  speed 1x              scan 1  0.01 s
            |   # nothing yet #
            |
            |
            |
            |
            | the program has no blocks
            | space switch p run s step b back +- speed f force w watch ?
        "#]],
    );
}

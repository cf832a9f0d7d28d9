//! Arrays: their elements are inputs, are found, and are shown in a loop.

use super::Bench;
use expect_test::expect;

const PUMPS: &str = "\
VAR_INPUT trip : ARRAY[1..2] OF BOOL; run : BOOL; END_VAR
VAR_OUTPUT pump : ARRAY[1..2] OF BOOL; END_VAR
VAR i : INT; starts : ARRAY[1..2] OF INT; END_VAR

+--[MOV]( i, 0 )--<FOR>( 2 )--+

+--[ADD]( i, i, 1 )--[ ]( run )--[/]( trip[i] )--( )( pump[i] )--+
+--[ ]( run )--[ADD]( starts[i], starts[i], 1 )--+
+--<NEXT>--+
";

#[test]
fn elements_are_inputs_and_a_loop_shows_which_one_is_meant() {
    let bench = Bench::new(PUMPS).size(100, 24);
    bench.check(
        "p s",
        expect![[r#"
        | motor.clad  ■ PAUSED  speed 1x                                                      scan 1  0.01 s
        |   VAR_INPUT trip : ARRAY[1..2] OF BOOL; run : BOOL; END_VAR
        |   VAR_OUTPUT pump : ARRAY[1..2] OF BOOL; END_VAR
        |   VAR i : INT; starts : ARRAY[1..2] OF INT; END_VAR
        |
        |   +══[MOV]( i, 0 )══<FOR>( 2 )══+  i=2
        |
        | > +══[ADD]( i, i, 1 )══[ ]( run )──[/]( trip[i] )──( )( pump[i] )──+  i=2  trip[2]=0  pump[2]=0
        |   +══[ ]( run )──[ADD]( starts[i], starts[i], 1 )──+  starts[2]=0
        |   +══<NEXT>══+
        |
        |
        |
        |
        |
        |
        |
        |─ Inputs: press the number ─────────────────────────────────────────────────────────────────────────
        | 1 ○ trip[1]   2 ○ trip[2]   3 ○ run
        |─ Watch ──────────────────────────────────────────────────────────────────── [ ] 1 column = 100 ms ─
        | pump[1]  FALSE                                                                                    ⡀
        | pump[2]  FALSE                                                                                    ⡀
        | Open contact: input run is FALSE; space switches it
        | space switch   p run   s step   b back   +- speed   f force   w watch   ? help   q quit
    "#]],
    );
    bench.check(
        "p 1 3 s",
        expect![[r#"
            | motor.clad  ■ PAUSED  speed 1x                                                      scan 1  0.01 s
            |   VAR_INPUT trip : ARRAY[1..2] OF BOOL; run : BOOL; END_VAR
            |   VAR_OUTPUT pump : ARRAY[1..2] OF BOOL; END_VAR
            |   VAR i : INT; starts : ARRAY[1..2] OF INT; END_VAR
            |
            |   +══[MOV]( i, 0 )══<FOR>( 2 )══+  i=2
            |
            | > +══[ADD]( i, i, 1 )══[ ](●run )══[/]( trip[i] )══( )(●pump[i] )══+  i=2  trip[2]=0  pump[2]=1
            |   +══[ ](●run )══[ADD]( starts[i], starts[i], 1 )══+  starts[2]=1
            |   +══<NEXT>══+
            |
            |
            |
            |
            |
            |
            |
            |─ Inputs: press the number ─────────────────────────────────────────────────────────────────────────
            | 1 ● trip[1]   2 ○ trip[2]   3 ● run
            |─ Watch ──────────────────────────────────────────────────────────────────── [ ] 1 column = 100 ms ─
            | pump[1]  FALSE                                                                                    ⡀
            | pump[2]  TRUE                                                                                     ⠁
            | Open contact: input run is TRUE; space switches it
            | space switch   p run   s step   b back   +- speed   f force   w watch   ? help   q quit
        "#]],
    );
}

#[test]
fn elements_are_found_by_a_part_of_their_name() {
    let bench = Bench::new(PUMPS).size(100, 24);
    bench.check_lines(
        "/ u m p enter",
        21..23,
        expect![[r#"
        | pump[2]  FALSE
        | Coil:
    "#]],
    );
    bench.check(
        "/ u m p",
        expect![[r#"
        | motor.clad  ■ PAUSED  speed 1x                                                      scan 0  0.00 s
        |   VAR_INPUT trip : ARRAY[1..2] OF BOOL; run : BOOL; END_VAR
        |   VAR_OUTPUT pump : ARRAY[1..2] OF BOOL; END_VAR
        |   VAR i : INT; starts : ARRAY[1..2] OF INT; END_VAR
        |
        |   +──[MOV]( i, 0 )──<FOR>( 2 )──+  i=0
        |
        | > +──[ADD]( i, i, 1 )──[ ]( run )──[/]( trip[i] )──( )( pump[i] )──+  i=0
        |   +──[ ]( run )──[ADD]( starts[i], starts[i], 1 )──+
        |   +──<NEXT>──+
        |
        |
        |
        |
        |
        |
        |
        |─ Inputs: press the number ─────────────────────────────────────────────────────────────────────────
        |┌ Enter: go there ─────────────────────────────────┐
        |│ * pump[1]       BOOL      FALSE                  │──────────────────────── [ ] 1 column = 100 ms ─
        |│ * pump[2]       BOOL      FALSE                  │
        |└──────────────────────────────────────────────────┘
        | find: ump   type some of its name; up, down, Enter, Esc
        | space switch   p run   s step   b back   +- speed   f force   w watch   ? help   q quit
    "#]],
    );
}

#[test]
fn an_array_is_watched_element_by_element() {
    let bench = Bench::new(PUMPS).size(100, 24).watch(&["pump"]);
    bench.check_lines(
        "p 3 s",
        14..24,
        expect![[r#"
        |
        |
        |
        |─ Inputs: press the number ─────────────────────────────────────────────────────────────────────────
        | 1 ○ trip[1]   2 ○ trip[2]   3 ● run
        |─ Watch ──────────────────────────────────────────────────────────────────── [ ] 1 column = 100 ms ─
        | pump[1]  TRUE                                                                                     ⠁
        | pump[2]  TRUE                                                                                     ⠁
        | Open contact: input run is TRUE; space switches it
        | space switch   p run   s step   b back   +- speed   f force   w watch   ? help   q quit
    "#]],
    );
}

/// What a loop's contact is about can be switched and forced as any other.
#[test]
fn the_element_of_now_is_what_keys_act_on() {
    let bench = Bench::new(PUMPS).size(100, 24);
    bench.check_lines(
        "p s right right",
        7..8,
        expect![[r#"
        | > +══[ADD]( i, i, 1 )══[ ]( run )──[/]( trip[i] )──( )( pump[i] )──+  i=2  trip[2]=0  pump[2]=0
    "#]],
    );
    bench.check_lines(
        "p s right",
        17..24,
        expect![[r#"
        |─ Inputs: press the number ─────────────────────────────────────────────────────────────────────────
        | 1 ○ trip[1]   2 ○ trip[2]   3 ○ run
        |─ Watch ──────────────────────────────────────────────────────────────────── [ ] 1 column = 100 ms ─
        | pump[1]  FALSE                                                                                    ⡀
        | pump[2]  FALSE                                                                                    ⡀
        | Closed contact: input trip[2] is FALSE; space switches it
        | space switch   p run   s step   b back   +- speed   f force   w watch   ? help   q quit
    "#]],
    );
    bench.check_lines(
        "p s right space",
        17..24,
        expect![[r#"
        |─ Inputs: press the number ─────────────────────────────────────────────────────────────────────────
        | 1 ○ trip[1]   2 ● trip[2]   3 ○ run
        |─ Watch ──────────────────────────────────────────────────────────────────── [ ] 1 column = 100 ms ─
        | pump[1]  FALSE                                                                                    ⡀
        | pump[2]  FALSE                                                                                    ⡀
        | trip[2] is on; the program sees it in the next scan: s or p
        | space switch   p run   s step   b back   +- speed   f force   w watch   ? help   q quit
    "#]],
    );
}

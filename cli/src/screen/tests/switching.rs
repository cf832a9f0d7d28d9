//! Inputs, values and forces.

use super::{Bench, MOTOR};
use expect_test::expect;

const TANK: &str = "\
VAR_INPUT  level : INT;  open : BOOL;  wait : TIME;  END_VAR
VAR_OUTPUT  alarm : BOOL;  scaled : INT;  END_VAR
VAR CONSTANT  limit : INT := 80;  END_VAR
+--[GT]( level, limit )--[TON]( t, wait )-----------------------( )( alarm )--+
+--[ ]( open )--[MUL]( scaled, level, 2 )--+
";

#[test]
fn space_and_numbers_switch_inputs() {
    let bench = Bench::new(MOTOR);
    bench.check_lines(
        "space",
        5..6,
        expect![[r#"
            | > +──\──[ ](●start )──\──[/]( stop )─────────────( )( run )──+
        "#]],
    );
    bench.check_lines(
        "space space",
        5..6,
        expect![[r#"
            | > +──\──[ ]( start )──\──[/]( stop )─────────────( )( run )──+
        "#]],
    );
    bench.check_lines(
        "2",
        5..6,
        expect![[r#"
            | > +──\──[ ]( start )──\──[/](●stop )─────────────( )( run )──+
        "#]],
    );
    bench.check_lines(
        "1 2 s",
        5..7,
        expect![[r#"
            | > +══\══[ ](●start )══\══[/](●stop )─────────────( )( run )──+
            |   |  /══[ ]( run )────/                                      |
        "#]],
    );
    bench.check_info(
        "space",
        expect![[r#"
            | start is on; the program sees it in the next scan: s or p
        "#]],
    );
    bench.check_info(
        "9",
        expect![[r#"
            | there is no input 9
        "#]],
    );
}

#[test]
fn what_is_no_input_says_so() {
    let bench = Bench::new(MOTOR);
    bench.check_info(
        "down space",
        expect![[r#"
            | run is not an input: the program may write it at once; f forces it
        "#]],
    );
    bench.check_info(
        "right right space",
        expect![[r#"
            | run is not an input: the program may write it at once; f forces it
        "#]],
    );
}

#[test]
fn the_mouse_switches() {
    let bench = Bench::new(MOTOR);
    // On a contact, on an input, on a key.
    bench.check_lines(
        "click:12,5 s",
        5..6,
        expect![[r#"
            | > +══\══[ ](●start )══\══[/]( stop )═════════════( )(●run )══+
        "#]],
    );
    bench.check_lines(
        "click:5,18 s",
        5..6,
        expect![[r#"
            | > +══\══[ ]( start )──\──[/]( stop )─────────────( )( run )──+
        "#]],
    );
    bench.check_info(
        "click:16,6",
        expect![[r#"
            | Open contact: run is FALSE
        "#]],
    );
    bench.check_lines(
        "click:12,5 click:23,23",
        0..1,
        expect![[r#"
            | motor.clad  ■ PAUSED  speed 1x                                  scan 1  0.01 s
        "#]],
    );
}

#[test]
fn numbers_are_asked_for() {
    let bench = Bench::new(TANK);
    bench.check_info(
        "space",
        expect![[r#"
            | set level (INT) to:    as in 42; Enter, Esc
        "#]],
    );
    bench.check_info(
        "space 9 5",
        expect![[r#"
            | set level (INT) to: 95   as in 42; Enter, Esc
        "#]],
    );
    bench.check_info(
        "space 'many' enter",
        expect![[r#"
            | set level (INT) to: many   as in 42; Enter, Esc
        "#]],
    );
    bench.check_info(
        "space 'many' enter backspace",
        expect![[r#"
            | set level (INT) to: man   as in 42; Enter, Esc
        "#]],
    );
    bench.check_lines(
        "space 'many' enter esc s",
        4..6,
        expect![[r#"
            | > +══[GT]( level, limit )──[TON]( t, wait )──( )( alarm )──+  level=0  limit=80
            |   +══[ ]( open )──[MUL]( scaled, level, 2 )──+  scaled=0  level=0
        "#]],
    );
    bench.check_lines(
        "1 '95' enter 3 '20ms' enter s s s",
        4..6,
        expect![[r#"
            | > +══[GT]( level, limit )══[TON](●t, wait )══( )(●alarm )══+  level=95        »
            |   +══[ ]( open )──[MUL]( scaled, level, 2 )──+  scaled=0  level=95
        "#]],
    );
    bench.check_info(
        "tab space",
        expect![[r#"
            | set wait (TIME) to:    as in 1.5s or 250ms; Enter, Esc
        "#]],
    );
}

#[test]
fn what_is_read_only_is_refused() {
    let text = "+--[ ]( SYS.FIRST_SCAN )--( )( y )--+\n";
    Bench::new(text).check_info(
        "space",
        expect![[r#"
            | SYS.FIRST_SCAN is read-only
        "#]],
    );
    Bench::new(text).check_info(
        "f",
        expect![[r#"
            | SYS.FIRST_SCAN is read-only
        "#]],
    );
}

#[test]
fn forces() {
    let bench = Bench::new(MOTOR);
    bench.check_info(
        "f",
        expect![[r#"
            | FORCE start: 1 on   0 off   u let go   Esc leave it
        "#]],
    );
    bench.check(
        "f 1 s",
        expect![[r#"
            | motor.clad  ■ PAUSED  speed 1x                         1 FORCE  scan 1  0.01 s
            |   VAR_INPUT  start, stop : BOOL;  END_VAR
            |   VAR  warmup : TON;  END_VAR
            |
            |   # Seal-in #
            | > +══\══[ ](●startF)══\══[/]( stop )═════════════( )(●run )══+
            |   |  /══[ ](●run )────/                                      |
            |
            |   # Warm-up #
            |   +══[ ](●run )═════════[TON]( warmup, T#5s )──( )( ready )──+  warmup 0s/5s
            |
            |
            |
            |
            |
            |
            |─ Inputs: press the number ─────────────────────────────────────────────────────
            | 1 ● startF  2 ○ stop
            |─ Watch ──────────────────────────────────────────────── [ ] 1 column = 100 ms ─
            | ready      FALSE                                                              ⡀
            | warmup.ET  0s                                                                 ▁
            | run        TRUE                                                               ⠁
            | Open contact: input start is TRUE (forced); u lets it go
            | space switch p run s step b back +- speed f force w watch ? help q quit
        "#]],
    );
    bench.check_info(
        "f 1 space",
        expect![[r#"
            | start is forced: u lets it go, f forces it again
        "#]],
    );
    bench.check_lines(
        "f 1 s u s",
        5..7,
        expect![[r#"
            | > +══\══[ ]( start )──\══[/]( stop )═════════════( )(●run )══+
            |   |  /══[ ](●run )════/                                      |
        "#]],
    );
    bench.check_info(
        "u",
        expect![[r#"
            | start is not forced
        "#]],
    );
    bench.check_info(
        "f 1 tab f 0 U",
        expect![[r#"
            | 2 tags were let go
        "#]],
    );
    bench.check_lines(
        "f 1 tab f 0 s",
        0..1,
        expect![[r#"
            | motor.clad  ■ PAUSED  speed 1x                        2 FORCES  scan 1  0.01 s
        "#]],
    );
    let bench = Bench::new(TANK);
    bench.check_info(
        "f",
        expect![[r#"
            | FORCE level (INT) to:    as in 42; Enter, Esc
        "#]],
    );
    bench.check_lines(
        "f '99' enter s",
        4..5,
        expect![[r#"
            | > +══[GT]( level, limit )══[TON](●t, wait )══( )(●alarm )══+  level=99 F      »
        "#]],
    );
}

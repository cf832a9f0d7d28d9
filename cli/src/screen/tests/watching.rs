//! The watch list.

use super::{Bench, MOTOR};
use expect_test::expect;

#[test]
fn waves() {
    let bench = Bench::new(MOTOR).watch(&["start", "run", "warmup.ET", "SYS.SCAN"]);
    let steps = "p +500ms space +300ms space +900ms 2 +200ms 2 +100ms";
    bench.check_lines(
        steps,
        16..22,
        expect![[r#"
            | 1 ○ start   2 ○ stop
            |─ Watch ──────────────────────────────────────────────── [ ] 1 column = 100 ms ─
            | start      FALSE                                          ⣀⣀⣀⣀⣀⡏⠉⠉⣇⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⡀
            | run        FALSE                                          ⣀⣀⣀⣀⣀⡏⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⣇⣀⣀⡀
            | warmup.ET  0s                                             ▁▁▁▁▁▁▂▃▃▄▄▅▆▆▇▇█▁▁▁▁
            | SYS.SCAN   199                                            ▁▂▂▂▃▃▃▄▄▄▅▅▆▆▆▇▇▇███
        "#]],
    );
    bench.check_lines(
        &format!("{steps} ] ]"),
        16..22,
        expect![[r#"
            | 1 ○ start   2 ○ stop
            |─ Watch ──────────────────────────────────────────────── [ ] 1 column = 400 ms ─
            | start      FALSE                                                         ⣀⡏⣇⣀⣀⡀
            | run        FALSE                                                         ⣀⡏⠉⠉⣇⡀
            | warmup.ET  0s                                                            ▁▃▅▇▁▁
            | SYS.SCAN   199                                                           ▂▄▅▇██
        "#]],
    );
    bench.check_lines(
        &format!("{steps} [ [ [ [ ["),
        16..22,
        expect![[r#"
            | 1 ○ start   2 ○ stop
            |─ Watch ───────────────────────────────────────────────── [ ] 1 column = 10 ms ─
            | start      FALSE  ⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀
            | run        FALSE  ⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⣇⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀
            | warmup.ET  0s     ▆▆▆▆▆▇▇▇▇▇▇▇▇▇▇▇▇▇▇▇▇▇█████████▁▁▁▁▁▁▁▁▁▁▁▁▁▁▁▁▁▁▁▁▁▁▁▁▁▁▁▁▁▁
            | SYS.SCAN   199    ▁▁▁▁▁▂▂▂▂▂▂▂▂▃▃▃▃▃▃▃▃▃▄▄▄▄▄▄▄▄▅▅▅▅▅▅▅▅▅▆▆▆▆▆▆▆▆▆▇▇▇▇▇▇▇▇█████
        "#]],
    );
    bench.check_lines(
        &format!("{steps} b b b b b b b b b b b"),
        16..22,
        expect![[r#"
            | 1 ○ start   2 ● stop
            |─ Watch ──────────────────────────────────────────────── [ ] 1 column = 100 ms ─
            | start      FALSE                                            ⣀⣀⣀⣀⣀⡏⠉⠉⣇⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀
            | run        FALSE                                            ⣀⣀⣀⣀⣀⡏⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⣇⣀
            | warmup.ET  0s                                               ▁▁▁▁▁▁▂▃▃▄▄▅▆▆▇▇█▁▁
            | SYS.SCAN   188                                              ▁▂▂▂▃▃▄▄▄▅▅▅▆▆▇▇▇██
        "#]],
    );
}

#[test]
fn tags_are_added_and_removed() {
    let bench = Bench::new(MOTOR).watch(&["run"]);
    bench.check(
        "w",
        expect![[r#"
            | motor.clad  ■ PAUSED  speed 1x                                  scan 0  0.00 s
            |   VAR_INPUT  start, stop : BOOL;  END_VAR
            |   VAR  warmup : TON;  END_VAR
            |
            |   # Seal-in #
            | > +──\──[ ]( start )──\──[/]( stop )─────────────( )( run )──+
            |   |  /──[ ]( run )────/                                      |
            |
            |   # Warm-up #
            |   +──[ ]( run )─────────[TON]( warmup, T#5s )──( )( ready )──+  warmup 0s/0s
            |
            |
            |
            |
            |
            |┌ Enter: watch, or no more ────────────────────────┐
            |│   start         BOOL      FALSE                  │
            |│   stop          BOOL      FALSE                  │
            |│   ▸ warmup      TON       Q=FALSE ET=T#0s        │────────────────────────────
            |│ * run           BOOL      FALSE                  │
            |│   ready         BOOL      FALSE                  │──── [ ] 1 column = 100 ms ─
            |└──────────────────────────────────────────────────┘
            | watch:    type some of its name; up, down, Enter, Esc
            | space switch p run s step b back +- speed f force w watch ? help q quit
        "#]],
    );
    bench.check_lines(
        "w 'pt' enter",
        16..23,
        expect![[r#"
            |
            |─ Inputs: press the number ─────────────────────────────────────────────────────
            | 1 ○ start   2 ○ stop
            |─ Watch ──────────────────────────────────────────────── [ ] 1 column = 100 ms ─
            | run        FALSE
            | warmup.ET  0s
            | warmup.ET is watched
        "#]],
    );
    bench.check_lines(
        "w 'run' enter",
        14..23,
        expect![[r#"
            |
            |
            |
            |
            |
            |
            |─ Inputs: press the number ─────────────────────────────────────────────────────
            | 1 ○ start   2 ○ stop
            | run is watched no more
        "#]],
    );
    bench.check_lines(
        "w down enter",
        16..23,
        expect![[r#"
            |
            |─ Inputs: press the number ─────────────────────────────────────────────────────
            | 1 ○ start   2 ○ stop
            |─ Watch ──────────────────────────────────────────────── [ ] 1 column = 100 ms ─
            | run   FALSE
            | stop  FALSE
            | stop is watched
        "#]],
    );
    bench.check_info(
        "w 'xyz' enter",
        expect![[r#"
            | there is no tag `xyz` in this program
        "#]],
    );
    // What is added later has a past too.
    bench.check_lines(
        "space s s space s s w 'start' enter [ [ [ [",
        16..23,
        expect![[r#"
            |
            |─ Inputs: press the number ─────────────────────────────────────────────────────
            | 1 ○ start   2 ○ stop
            |─ Watch ───────────────────────────────────────────────── [ ] 1 column = 10 ms ─
            | run    TRUE                                                                ⠉⠉⠉⠉
            | start  FALSE                                                               ⠉⠉⣇⣀
            | Open contact: input start is FALSE; space switches it
        "#]],
    );
}

#[test]
fn more_tags_than_lines() {
    let tags = [
        "start",
        "stop",
        "run",
        "ready",
        "warmup.Q",
        "warmup.ET",
        "warmup.PT",
        "warmup.IN",
        "SYS.SCAN",
        "SYS.TIME",
    ];
    Bench::new(MOTOR).watch(&tags).check_lines(
        "s",
        10..24,
        expect![[r#"
            |
            |
            |─ Inputs: press the number ─────────────────────────────────────────────────────
            | 1 ○ start   2 ○ stop
            |─ Watch ──────────────────────────────────────── 3 more  [ ] 1 column = 100 ms ─
            | start      FALSE                                                              ⡀
            | stop       FALSE                                                              ⡀
            | run        FALSE                                                              ⡀
            | ready      FALSE                                                              ⡀
            | warmup.Q   FALSE                                                              ⡀
            | warmup.ET  0s                                                                 ▁
            | warmup.PT  5.0s                                                               ▄
            | Open contact: input start is FALSE; space switches it
            | space switch p run s step b back +- speed f force w watch ? help q quit
        "#]],
    );
}

const LINES: &str = "\
TYPE
    Phase : (IDLE, FILLING);
    Motor : STRUCT
        speed : REAL := 50.0;
        delay : TON;
    END_STRUCT;
END_TYPE
VAR step : Phase := FILLING; lines : ARRAY[1..2] OF Motor; big : ARRAY[1..10000] OF INT; END_VAR
+--[TON]( lines[2].delay, T#5s )--[MOV]( big[3], 7 )--+
";

#[test]
fn what_is_compound_is_opened_and_closed() {
    let bench = Bench::new(LINES);
    bench.check_lines(
        "w down down down down right",
        10..23,
        expect![[r#"
            |┌ Enter: watch, or no more ──────────────────────────────────────┐
            |│   lines[2].delay.Q            BOOL      FALSE                  │
            |│   step                        Phase     FILLING                │
            |│   ▸ lines                     ARRAY[1..2] OF Motor             │
            |│   ▾ big                       ARRAY[1..10000] OF INT           │
            |│     ▸ big[1] .. big[100]      INT                              │
            |│     ▸ big[101] .. big[200]    INT                              │
            |│     ▸ big[201] .. big[300]    INT                              │
            |│     ▸ big[301] .. big[400]    INT                              │
            |│     ▸ big[401] .. big[500]    INT                              │umn = 100 ms ─
            |│     ▸ big[501] .. big[600]    INT                              │
            |└────────────────────────────────────────────────────────────────┘
            | watch:    type some of its name; up, down, Enter, Esc
        "#]],
    );
    bench.check_lines(
        "w down down down down enter down down enter down enter",
        8..23,
        expect![[r#"
            |   VAR step : Phase := FILLING; lines : ARRAY[1..2] OF Motor; big : ARRAY[1..100
            | > +──[TON]( lines[2].delay, T#5s )──[MOV]( big[3], 7 )──+  lines[2].delay 0s/0s
            |
            |
            |
            |
            |
            |
            |
            |
            |─ Watch ──────────────────────────────────────────────── [ ] 1 column = 100 ms ─
            | lines[1].delay.ET  0s
            | lines[2].delay.ET  0s
            | big[101]           0
            | big[101] is watched
        "#]],
    );
    bench.check_lines(
        "w down down down down right down right down left left",
        10..23,
        expect![[r#"
        |
        |
        |
        |
        |
        |
        |┌ Enter: watch, or no more ────────────────────────────┐
        |│   lines[2].delay.Q  BOOL      FALSE                  │
        |│   step              Phase     FILLING                │
        |│   ▸ lines           ARRAY[1..2] OF Motor             │ [ ] 1 column = 100 ms ─
        |│   ▸ big             ARRAY[1..10000] OF INT           │
        |└──────────────────────────────────────────────────────┘
        | watch:    type some of its name; up, down, Enter, Esc
    "#]],
    );
}

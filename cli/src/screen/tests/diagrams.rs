//! How programs look.

use super::{Bench, MOTOR, styles};
use crate::screen::theme::Charset;
use expect_test::expect;

/// The first input is far to the right: what the rung decides by is seen first all the same.
#[test]
fn a_wide_rung_begins_at_its_left() {
    let text = "\
VAR_INPUT  level : INT;  release : BOOL;  END_VAR
VAR  automatic_mode, pressure_reached, conveyor_is_empty : BOOL;  copied : INT;  END_VAR
+--[ ]( automatic_mode )--[ ]( pressure_reached )--[ ]( conveyor_is_empty )--[MOV]( copied, level )--( )( pressure_reached )--+
+--[ ]( conveyor_is_empty )--[/]( automatic_mode )--[ ]( pressure_reached )--[ ]( release )--[/]( conveyor_is_empty )--( )( automatic_mode )--+
";
    Bench::new(text).check_lines(
        "",
        1..6,
        expect![[r#"
            |   VAR_INPUT  level : INT;  release : BOOL;  END_VAR
            |   VAR  automatic_mode, pressure_reached, conveyor_is_empty : BOOL;  copied : IN
            | > +──[ ]( automatic_mode )──[ ]( pressure_reached »──( )( pressure_reached )──+
            |   +──[ ]( conveyor_is_empty )──[/]( automatic_mode )»──( )( automatic_mode )──+
            |
        "#]],
    );
}

/// A bit of a system tag has one value as any other bit.
#[test]
fn a_bit_of_a_system_tag_is_shown() {
    Bench::new("+--[ ]( SYS.SCAN.0 )--( )( odd )--+\n").check_lines(
        "s s",
        1..2,
        expect![[r#"
            | > +══[ ](●SYS.SCAN.0 )══( )(●odd )══+
        "#]],
    );
}

#[test]
fn a_program_before_its_first_scan() {
    Bench::new(MOTOR).check(
        "",
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
            |
            |─ Inputs: press the number ─────────────────────────────────────────────────────
            | 1 ○ start   2 ○ stop
            |─ Watch ──────────────────────────────────────────────── [ ] 1 column = 100 ms ─
            | ready      FALSE
            | warmup.ET  0s
            | run        FALSE
            | Open contact: input start is FALSE; space switches it
            | space switch p run s step b back +- speed f force w watch ? help q quit
        "#]],
    );
}

#[test]
fn power_flows() {
    Bench::new(MOTOR).check(
        "p space +1200ms space +100ms",
        expect![[r#"
            | motor.clad  ▶ RUNNING 1x                                      scan 130  1.30 s
            |   VAR_INPUT  start, stop : BOOL;  END_VAR
            |   VAR  warmup : TON;  END_VAR
            |
            |   # Seal-in #
            | > +══\══[ ]( start )──\══[/]( stop )═════════════( )(●run )══+
            |   |  /══[ ](●run )════/                                      |
            |
            |   # Warm-up #
            |   +══[ ](●run )═════════[TON]( warmup, T#5s )──( )( ready )──+  warmup 1.2s/5s
            |
            |
            |
            |
            |
            |
            |─ Inputs: press the number ─────────────────────────────────────────────────────
            | 1 ○ start   2 ○ stop
            |─ Watch ──────────────────────────────────────────────── [ ] 1 column = 100 ms ─
            | ready      FALSE                                                 ⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⡀
            | warmup.ET  1.2s                                                  ▁▂▃▃▄▄▅▅▆▆▇▇██
            | run        TRUE                                                  ⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠁
            | Open contact: input start is FALSE; space switches it
            | space switch p pause s step b back +- speed f force w watch ? help q quit
        "#]],
    );
}

#[test]
fn nothing_is_shown_by_colour_alone() {
    let bench = Bench::new(MOTOR);
    expect![[r#"
        |RRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRR
        |
        |
        |
        |   DDDDDDDDDDD
        | B BBBBBBBBBBBBBBBBBBBBBBBRRRRRRRRRRRBBBBBBBBBBBBBBBBBBBBBBBBBB
        |      BBB    BBBB      B
        |
        |   DDDDDDDDDDD
        |   BBBBBBBBBBBBBBBBBBBBBB
        |
        |
        |
        |
        |
        |
        |DBBBBBBBBBBBBBBBBBBBBBBBBBBDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDD
        | U B BBBBB   U R RRRRR
        |DBBBBBBBDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDD
        |
        |
        | BBB        BBBB
        |
        | UUUUU        U     U      U      UU       U       U       U      U
    "#]]
    .assert_eq(&bench.play("space s tab f 0 b s", |_, buffer| styles(buffer)));
    let bench = Bench::new(MOTOR).theme(true, Charset::Unicode);
    expect![[r#"
        |RRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRR
        |
        |
        |
        |   DDDDDDDDDDD
        | B gggggggggggggggggggggggRRRRyyyyyyRgggggggggggggggggggggggggg
        |      ggg    gggg      g
        |
        |   DDDDDDDDDDD
        |   gggggggggggggggggggggg                                        cccccccccccc
        |
        |
        |
        |
        |
        |
        |DBBBBBBBBBBBBBBBBBBBBBBBBBBDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDD
        | B g ggggg   B y yyyyy
        |DBBBBBBBDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDDD
        |                   ccccccccccccccccccccccccccccccccccccccccccccccccccccccccccccc
        |            cc     ccccccccccccccccccccccccccccccccccccccccccccccccccccccccccccc
        | ggg        gggg   ccccccccccccccccccccccccccccccccccccccccccccccccccccccccccccc
        |
        | BBBBB        B     B      B      BB       B       B       B      B
    "#]]
    .assert_eq(&bench.play("space s tab f 0 b s", |_, buffer| styles(buffer)));
}

#[test]
fn plain_characters() {
    Bench::new(MOTOR).theme(false, Charset::Ascii).check(
        "p space +300ms",
        expect![[r#"
            | motor.clad  > RUNNING 1x                                       scan 30  0.30 s
            |   VAR_INPUT  start, stop : BOOL;  END_VAR
            |   VAR  warmup : TON;  END_VAR
            |
            |   # Seal-in #
            | > +==\==[ ](*start )==\==[/]( stop )=============( )(*run )==+
            |   |  /==[ ](*run )====/                                      |
            |
            |   # Warm-up #
            |   +==[ ](*run )=========[TON]( warmup, T#5s )--( )( ready )--+  warmup 290ms/5s
            |
            |
            |
            |
            |
            |
            |- Inputs: press the number -----------------------------------------------------
            | 1 * start   2 . stop
            |- Watch ------------------------------------------------ [ ] 1 column = 100 ms -
            | ready      FALSE                                                           ____
            | warmup.ET  290ms                                                           :=##
            | run        TRUE                                                            ----
            | Open contact: input start is TRUE; space switches it
            | space switch p pause s step b back +- speed f force w watch ? help q quit
        "#]],
    );
}

#[test]
fn large() {
    Bench::new(MOTOR).size(160, 30).check("p space +700ms", expect![[r#"
        | motor.clad  ▶ RUNNING 1x                                                                                                                       scan 70  0.70 s
        |1   VAR_INPUT  start, stop : BOOL;  END_VAR                                                          ─ Watch ─────────────────────────── [ ] 1 column = 100 ms ─
        |2   VAR  warmup : TON;  END_VAR                                                                       ready      FALSE                                  ⣀⣀⣀⣀⣀⣀⣀⡀
        |3                                                                                                     warmup.ET  690ms                                  ▂▃▄▅▆▇██
        |4   # Seal-in #                                                                                       run        TRUE                                   ⠉⠉⠉⠉⠉⠉⠉⠁
        |5 > +══\══[ ](●start )══\══[/]( stop )═════════════( )(●run )══+
        |6   |  /══[ ](●run )════/                                      |
        |7
        |8   # Warm-up #
        |9   +══[ ](●run )═════════[TON]( warmup, T#5s )──( )( ready )──+  warmup 690ms/5s
        |
        |
        |
        |
        |
        |
        |
        |
        |
        |
        |
        |
        |
        |
        |
        |
        |─ Inputs: press the number ─────────────────────────────────────────────────────────────────────────────────────────────────────────────────────────────────────
        | 1 ● start   2 ○ stop
        | Open contact: input start is TRUE; space switches it
        | space switch   p pause   s step   b back   +- speed   f force   w watch   ? help   q quit
    "#]]);
}

#[test]
fn tiny() {
    let bench = Bench::new(MOTOR);
    bench.check(
        "size:30x8",
        expect![[r#"
            | motor.clad  ■ PAUSED  speed 1
            |   # Seal-in #
            | > +──\──[ ]( start )──\──[/]»
            |   |  /──[ ]( run )────/
            |─ Inputs: press the number ───
            | 1 ○ start   2 ○ stop
            | Open contact: input start is
            | space switch p run s step b b
        "#]],
    );
    for (width, height) in [(1, 1), (2, 40), (200, 1), (5, 5), (12, 3)] {
        bench.play(&format!("size:{width}x{height} ? esc w esc space"), |_, _| {
            String::new()
        });
    }
}

#[test]
fn wide_characters_tabs_and_line_ends() {
    let text = "\u{feff}# 温度 🙂 #\r\n+--[ ](\t温度\t)--( )( a )--+\r\r\n+--[GT]( level, 80 )--# heiß #--( )( é )--+  # note #";
    Bench::new(text).check_lines(
        "2 enter 9 5 enter s",
        0..8,
        expect![[r#"
            | motor.clad  ■ PAUSED  speed 1x                                  scan 1  0.01 s
            |   # 温度 🙂 #
            | > +══[ ]( 温度    )──( )( a )──+
            |
            |   +══[GT]( level, 80 )══# heiß #══( )(●é )══+  # note #  level=95
            |
            |
            |
        "#]],
    );
}

#[test]
fn values_at_line_ends() {
    let text = "\
+--[ADD]( total, total, 3 )--[ ]( go )--[CTU]( parts, 12 )--( )( full )--+
+--[MUL]( rate, total, 2.5 )--[TON]( t, wait )--+
";
    Bench::new(text).check_lines(
        "space s s s",
        1..4,
        expect![[r#"
            | > +══[ADD]( total, total, 3 )══[ ](●go )══[CTU]( parts, 12 )──( )( full )──+  »
            |   +══[MUL]( rate, total, 2.5 )══[TON](●t, wait )══+  rate=22.5  total=9       »
            |
        "#]],
    );
}

#[test]
fn help() {
    Bench::new(MOTOR).check(
        "?",
        expect![[r#"
            | motor.clad  ■ PAUSED  speed 1x                                  scan 0  0.00 s
            | ┌ Help: any key closes it ───────────────────────────────────────────────────┐
            | │ Move                                      Run                              │
            | │  arrows hjkl    from block to block        p          run, pause           │
            | │  Tab, Shift-Tab next, previous block       s          one scan             │
            | │  PgUp PgDn      a page                     . ,        one block, one rung  │
            | │  g G            first, last block          b          one scan back        │
            | │  / n N          find tag, next, previous   + -        faster, slower       │
            | │                                            B t        stop at rung, change │
            | │ Inputs                                     c C        restart cold, warm   │
            | │  space, Enter   switch, or set a number                                    │
            | │  1 .. 9         the same for that input   Look                             │
            | │  mouse click    the same for that block    w          watch, or no more    │
            | │  v              set the selected tag       y          why is it so?        │
            | │  f              force the selected tag     [ ]        shorter, longer time │
            | │  u U            let it go, let all go      !          go to the last fault │
            | │                                            r R        load; write a test   │
            | │                                            Esc        close what is open   │
            | │                                            q, Ctrl-C  quit                 │
            | │                                                                            │
            | │ ═══ power    ─── no power    ● tag the tag is on    tag F forced           │
            | │ This is a simulator, not a safety device.                                  │
            | └────────────────────────────────────────────────────────────────────────────┘
            | space switch p run s step b back +- speed f force w watch ? help q quit
        "#]],
    );
}

#[test]
fn what_wide_rungs_do_is_brought_into_sight() {
    let wire = "-".repeat(40);
    let text = format!(
        "+--[ ]( go ){wire}{wire}( )( lamp )--+\n\
         +--[ ]( go )--[TON]( t, T#5s ){wire}{wire}( )( late )--+\n\
         +--[ ]( go )--[TON]( t2, T#10s )--[MUL]( rate, speed, 2 )--[ADD]( a_long_name, b, c ){wire}( )( end )--+\n"
    );
    let bench = Bench::new(&text).size(60, 12);
    bench.check_lines(
        "space s s",
        1..5,
        expect![[r#"
            | > +══[ ](●go )════════════════════( )(●lamp )══+
            |   +══[ ](●go )══[TON]( t, T#5s )──( )( late )──+  t 10ms/5s
            |   +══[ ](●go )══[TON]( t2, T#10s )──[MUL]( »──( )( end )──+
            |
        "#]],
    );
    bench.check_lines(
        "space s s right",
        1..5,
        expect![[r#"
            | > +══[ ](●go )════════════════════( )(●lamp )══+
            |   +══[ ](●go )══[TON]( t, T#5s )──( )( late )──+  t 10ms/5s
            |   +══[ ](●go )══[TON]( t2, T#10s )──[MUL]( »──( )( end )──+
            |
        "#]],
    );
}

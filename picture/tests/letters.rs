//! Diagrams drawn with characters. `UPDATE_EXPECT=1 cargo test -p ladder-picture` draws them again; look at them before
//! you keep them.

use expect_test::{expect, expect_file};
use ladder_analysis::{Analysis, analyze};
use ladder_picture::letters::{Gate, Ink, Live, Piece, Shown, pieces};
use ladder_syntax::{TextRange, TextSize, parse};
use std::fmt::Write;
use std::sync::Arc;

fn analysis(text: &str) -> Analysis {
    analyze(&Arc::new(parse(text)), "program")
}

fn drawn(text: &str, rail: u32, live: Option<&Live>) -> Vec<Piece> {
    let all = TextRange::up_to(TextSize::of(text));
    pieces(&analysis(text).context, all, rail, live)
}

fn shown(pieces: &[Piece]) -> String {
    let mut out = String::new();
    for piece in pieces {
        for line in &piece.lines {
            let _ = writeln!(out, "{}", line.text);
        }
        out.push('\n');
    }
    out
}

#[test]
fn programs_at_rest() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/pictures");
    let mut all = String::new();
    for name in ["branches", "symbols", "flow"] {
        let text = std::fs::read_to_string(format!("{folder}/{name}.clad")).unwrap();
        let _ = writeln!(all, "== {name}\n\n{}", shown(&drawn(&text, 70, None)));
    }
    expect_file!["pictures/letters.txt"].assert_eq(&all);
}

const MOTOR: &str = "\
+--\\--[ ]( start )--\\--[/]( stop )--( )( run )--+
|  /--[ ]( run )----/                           |
+--[ ]( run )--[TON]( warmup, T#5s )--[GE]( speed, 80 )--( )( ready )--+
";

/// How the parts with these texts are: what is not named has power.
fn live(text: &str, dead: &[&str], gates: &[(&str, Gate)], values: &[(&str, &str, bool)]) -> Live {
    let place = |part: &str| {
        let at = text.find(part).unwrap_or_else(|| panic!("{part} is not there"));
        TextRange::at((at as u32).into(), TextSize::of(part))
    };
    let analysis = analysis(text);
    let context = &analysis.context;
    let mut live = Live::default();
    let is_dead = |range: &TextRange| dead.iter().any(|part| place(part).contains_range(*range));
    for index in 0..context.networks.len() {
        let network = context.networks.at(index);
        for (rung, wiring) in network.wiring.rungs.iter().enumerate() {
            for part in 0..wiring.parts.len() {
                let range = network.part_range(&context.parse, rung, part);
                live.power.insert(range, !is_dead(&range));
            }
        }
    }
    live.contacts = gates.iter().map(|(part, gate)| (place(part), *gate)).collect();
    let values = values.iter().map(|&(operand, text, forced)| {
        let before = place(operand);
        let name = operand.trim_start_matches(|letter: char| !letter.is_alphanumeric());
        let range = TextRange::new(before.end() - TextSize::of(name), before.end());
        (
            range,
            Shown {
                text: text.to_owned(),
                forced,
            },
        )
    });
    live.values = values.collect();
    live
}

/// Below each line what its parts are, in letters.
fn inked(pieces: &[Piece]) -> String {
    let mut out = String::new();
    for line in pieces.iter().flat_map(|piece| &piece.lines) {
        let mut marks = vec![' '; line.text.chars().count()];
        for mark in &line.marks {
            for letter in marks
                .iter_mut()
                .take(mark.characters.end)
                .skip(mark.characters.start)
            {
                *letter = match mark.ink {
                    Ink::On => '#',
                    Ink::Off => '.',
                    Ink::Closed => 'c',
                    Ink::Blocks => 'x',
                    Ink::Rail => ' ',
                    Ink::Value => 'v',
                    Ink::Forced => '!',
                    Ink::Tag => 't',
                    _ => '-',
                };
            }
        }
        let marks: String = marks.into_iter().collect();
        let _ = writeln!(out, "{}\n{}", line.text, marks.trim_end());
    }
    out
}

#[test]
fn power_is_weight_and_contacts_are_closed_or_not() {
    let live = live(
        MOTOR,
        &["[ ]( run )----", "--( )( ready )--+", "[GE]( speed, 80 )"],
        &[
            ("[ ]( start )", Gate::Closed),
            ("[/]( stop )", Gate::Closed),
            ("[ ]( run )----/", Gate::Open),
            ("[GE]( speed, 80 )", Gate::Blocks),
        ],
        &[
            ("( stop", "0", true),
            ("( warmup", "4.98s", false),
            ("( speed", "12345678.25", true),
        ],
    );
    let pieces = drawn(MOTOR, 50, Some(&live));
    expect![[r#"
        │     start     stop!                       run   │
              ttttt     !!!!!                       ttt
        ┝━━┳━━┥━━━┝━━┳━━┥━/━┝━━━━━━━━━━━━━━━━━━━━━━(━━━)━━┥
        ###################################################
        │  ┃   run   ┃                                    │
           #   ttt   #
        │  ┗━━┥   ├──┚                                    │
           ###.......#
        │           4.98s                                 │
                    vvvvv
        │          warmup    1234567…!                    │
                   tttttt    !!!!!!!!!
        │   run   ┌─ TON ─┐    speed               ready  │
            ttt   ---------    ttttt               ttttt
        ┝━━┥━━━┝━━┥IN    Q┝━━━━┥ ≥ ├───────────────(   )──┤
        ##########---    --####xxxxx......................
        │         │PT T#5s│     80                        │
                  --- tttt-     tt
        │         └───────┘                               │
                  ---------
    "#]]
    .assert_eq(&inked(&pieces));
}

#[test]
fn every_block_has_its_place() {
    let pieces = drawn(MOTOR, 50, None);
    let text = |piece: &Piece| {
        let areas = piece.things.areas.iter();
        let areas = areas.map(|area| format!("{:?} {:?} {}", area.lines, area.columns, &MOTOR[area.range]));
        areas.collect::<Vec<_>>().join("\n")
    };
    expect![[r#"
        0..2 6..11 [ ]( start )
        0..2 16..21 [/]( stop )
        0..2 43..48 ( )( run )
        2..4 6..11 [ ]( run )
        1..3 3..8 [ ]( run )
        0..5 10..19 [TON]( warmup, T#5s )
        1..4 21..26 [GE]( speed, 80 )
        1..3 43..48 ( )( ready )"#]]
    .assert_eq(&pieces.iter().map(text).collect::<Vec<_>>().join("\n"));
    let lines = pieces.iter().flat_map(|piece| &piece.lines);
    let places: Vec<usize> = lines
        .map(|line| MOTOR[..line.place.into()].matches('\n').count())
        .collect();
    assert_eq!(places, [0, 0, 1, 1, 2, 2, 2, 2, 2]);
}

#[test]
fn every_wire_and_line_has_its_place() {
    let text = "+--\\--[ ]( a )--# why #--\\--( )( x )--+\n|  /--[ ]( b )------------/\n";
    let pieces = drawn(text, 40, None);
    let things = &pieces[0].things;
    let place = |at: TextSize| {
        let line = text[..at.into()].matches('\n').count();
        (line, text[at.into()..].chars().take(4).collect::<String>())
    };
    let mut told = shown(&pieces);
    for area in &things.areas {
        told.push_str(&format!(
            "{:?} {:?} {}\n",
            area.lines, area.columns, &text[area.range]
        ));
    }
    for wire in &things.wires {
        told.push_str(&format!(
            "{} {:?} {:?}\n",
            wire.line,
            wire.columns,
            place(wire.place)
        ));
    }
    for join in &things.joins {
        told.push_str(&format!(
            "{:?} {} {:?}\n",
            join.lines,
            join.column,
            place(join.place)
        ));
    }
    expect![[r#"
        │       a     why                  x    │
        ├──┬──┤   ├─────────┬────────────(   )──┤
        │  │    b           │                   │
        │  └──┤   ├─────────┘                   │

        0..2 6..11 [ ]( a )
        0..2 13..18 # why #
        0..2 33..38 ( )( x )
        2..4 6..11 [ ]( b )
        1 1..3 (0, "--\\-")
        1 4..6 (0, "--[ ")
        1 11..13 (0, "--# ")
        1 18..20 (0, "--\\-")
        1 21..33 (0, "--( ")
        1 38..40 (0, "--+\n")
        3 4..6 (1, "--[ ")
        3 11..20 (1, "----")
        1..4 3 (1, "/--[")
        1..4 20 (1, "/\n")
    "#]]
    .assert_eq(&told);
}

/// A comment above a rung is next to the lines that come down there.
#[test]
fn comments_are_next_to_the_lines() {
    let text = "+--\\--[ ]( a )--\\--( )( x )--+\n# b, too #\n|  /--[ ]( b )--/            |\n";
    expect![[r#"
        │       a                x    │
        ├──┬──┤   ├──┬─────────(   )──┤
        │  │ b, too  │                │
        │  │    b    │                │
        │  └──┤   ├──┘                │

    "#]]
    .assert_eq(&shown(&drawn(text, 30, None)));
}

/// Only what is asked for is drawn: in a long program it costs what it is.
#[test]
fn a_part_of_a_program() {
    let mut text = String::new();
    for n in 0..50 {
        let _ = write!(text, "+--[ ]( a{n} )--( )( b{n} )--+\n\n");
    }
    let at = |name: &str| TextSize::from(text.find(name).unwrap() as u32);
    let stretch = TextRange::new(at("a20 "), at("a22 "));
    let found = pieces(&analysis(&text).context, stretch, 30, None);
    assert_eq!(found.len(), 3);
    assert!(shown(&found).contains("a21"), "{}", shown(&found));
}

/// Whatever the text is, something is drawn, and marks lie in their lines.
#[test]
fn odd_texts() {
    for text in [
        "",
        "+",
        "|",
        "# only a comment #",
        "+--[ ]( )--+",
        "+--\\--+",
        "/--\\\n\\--/",
        "+--[ ]( a )--\\\n  /--( )( b )--+",
        "+--[MOV]( s, '<&\u{1}>' )--+",
        "+--[$]( x )--[NONE]( )--<JMP>( )--+",
        "+--[CTUD]( c, 1 )--# in between #--(S)( 液位 )--+ # after #",
        "FUNCTION_BLOCK [$B]\n+--[ ]( a )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n",
    ] {
        for live in [None, Some(&Live::default())] {
            for line in drawn(text, 20, live).iter().flat_map(|piece| &piece.lines) {
                let characters = line.text.chars().count();
                let inside = line.marks.iter().all(|mark| mark.characters.end <= characters);
                assert!(inside, "{text:?}: {line:?}");
            }
        }
    }
}

/// A network whose rungs lead down to the right, as wide as it is high.
fn staircase(rungs: usize) -> String {
    let mut text = "+--\\--( )( y )--+\n".to_owned();
    for _ in 0..rungs {
        text += "   /--[ ]( a )--\\--( )( y )--+\n";
    }
    text + "   /--( )( y )--+\n"
}

#[test]
fn a_network_that_is_too_large_says_so() {
    let small = drawn(&staircase(20), 70, None);
    assert!(small[0].lines.len() > 20);
    let large = drawn(&staircase(3000), 70, None);
    let lines: Vec<&str> = large[0].lines.iter().map(|line| line.text.as_str()).collect();
    let [told] = lines[..] else {
        panic!("{} lines", lines.len())
    };
    assert!(
        told.ends_with("is too large to be drawn with characters"),
        "{told}"
    );
}

#[test]
fn a_block_with_very_many_operands_is_no_wider_than_one_with_many() {
    // Operands after the thousandth are not read, and are one long text.
    let text = format!("+--[ADD]( y{} )--+\n", ", a".repeat(20_000));
    let pieces = drawn(&text, 70, None);
    let widest = pieces[0].lines.iter().map(|line| line.text.chars().count()).max();
    assert!(widest < Some(1200), "{widest:?}");
}

#[test]
fn text_that_is_no_network_is_shown_as_it_is() {
    let line = format!("+--[ ]( {} --( )( b )--+", "a".repeat(100_000));
    let pieces = drawn(&format!("{line}\n"), 70, None);
    assert_eq!(pieces[0].lines[0].text, line);
    assert_eq!(pieces[0].lines[0].marks[0].characters, 0..line.len());
}

//! How wide networks are shown on narrow panes.

use super::fold::{Band, ColumnPlace, Content, Folding, LineShape, cuts};
use expect_test::{Expect, expect};
use std::ops::Range;

/// A drawing as a network: dashes are wires, blanks are blank, what is between brackets is a block.
fn band(drawing: &str) -> Band {
    let shapes: Vec<LineShape> = drawing.lines().map(shape).collect();
    Band::network(0..shapes.len(), &shapes)
}

fn shape(line: &str) -> LineShape {
    let mut columns = Vec::new();
    let mut blocks: Vec<Range<usize>> = Vec::new();
    let mut inside = false;
    for (at, letter) in line.chars().enumerate() {
        if letter == '[' {
            blocks.push(at..at);
            inside = true;
        }
        columns.push(match letter {
            '-' if !inside => Content::Wire,
            ' ' if !inside => Content::Blank,
            _ => Content::Fixed,
        });
        if letter == ']' {
            inside = false;
            if let Some(block) = blocks.last_mut() {
                block.end = at + 1;
            }
        }
    }
    LineShape {
        full: columns.len(),
        columns,
        blocks,
        values: 0,
    }
}

/// The drawing as a pane shows it.
fn shown(drawing: &str, pane: usize, left: usize) -> String {
    let band = band(drawing);
    let window = Folding::new(std::slice::from_ref(&band), pane).window(&band, left);
    let mut shown = String::new();
    for line in drawing.lines() {
        let mut cells = vec![' '; pane];
        if let Some(split) = window.split() {
            cells[split.at] = '»';
        }
        for (column, letter) in line.chars().enumerate() {
            if let ColumnPlace::Seen(at) = window.place(column) {
                cells[at] = letter;
                assert_eq!(window.drawn_at(at), Some(column), "{line} {at}");
            }
        }
        shown.push_str(cells.iter().collect::<String>().trim_end());
        shown.push('\n');
    }
    shown
}

fn check(drawing: &str, pane: usize, left: usize, expected: Expect) {
    expected.assert_eq(&shown(drawing, pane, left));
}

const SEAL_IN: &str = "\
+--\\--[start]----\\--[stop]-----------------------------------[run]--+
|  /--[running]--/                                                  |
";

#[test]
fn long_wires_are_shortened_and_lines_stay_together() {
    check(
        SEAL_IN,
        80,
        0,
        expect![[r#"
            +--\--[start]----\--[stop]-----------------------------------[run]--+
            |  /--[running]--/                                                  |
        "#]],
    );
    check(
        SEAL_IN,
        60,
        0,
        expect![[r#"
            +--\--[start]----\--[stop]--------------------------[run]--+
            |  /--[running]--/                                         |
        "#]],
    );
    check(
        SEAL_IN,
        45,
        0,
        expect![[r#"
            +--\--[start]----\--[stop]-----------[run]--+
            |  /--[running]--/                          |
        "#]],
    );
}

#[test]
fn nothing_is_narrower_than_it_can_be() {
    check(
        SEAL_IN,
        30,
        0,
        expect![[r#"
            +--\--[start]----\-»--[run]--+
            |  /--[running]--/ »         |
        "#]],
    );
}

const PUSHER: &str = "\
+--[passed]---------[CTU boxes, PER_TRAY, pusher]--[TP push, 2s]--[pusher]--+
";

#[test]
fn right_hand_blocks_are_held_at_the_edge() {
    check(
        PUSHER,
        60,
        0,
        expect![[r#"
            +--[passed]--[CTU boxes, PER_TRAY, pusher]--[T»--[pusher]--+
        "#]],
    );
    check(
        PUSHER,
        60,
        8,
        expect![[r#"
            ed]--[CTU boxes, PER_TRAY, pusher]--[TP push, »--[pusher]--+
        "#]],
    );
    check(
        PUSHER,
        60,
        99,
        expect![[r#"
            ]--[CTU boxes, PER_TRAY, pusher]--[TP push, 2s]--[pusher]--+
        "#]],
    );
}

#[test]
fn where_there_is_no_right_hand_block_nothing_is_held() {
    check(
        "+--[a contact of some length]--[another contact]--[a third one]--/   |\n",
        40,
        0,
        expect![[r#"
            +--[a contact of some length]--[another
        "#]],
    );
}

#[test]
fn a_block_is_scrolled_into_sight_from_wherever_one_is() {
    let drawing = "\
+--[first]--[the second one]--\\--[the third one, which is longer]--\\--[fourth]--[coil]--+
|                             /--[5]------------------------------/                       |
";
    let mut shapes: Vec<LineShape> = drawing.lines().map(shape).collect();
    shapes[0].values = 10;
    let band = Band::network(0..2, &shapes);
    let blocks: Vec<Range<usize>> = shapes.iter().flat_map(|line| line.blocks.clone()).collect();
    for pane in 36..100 {
        let folding = Folding::new(std::slice::from_ref(&band), pane);
        for from in 0..100 {
            for block in &blocks {
                let left = folding.left_for(&band, from, block);
                let window = folding.window(&band, left);
                // Of one that is wider than the left part the beginning is seen.
                let whole = block.len() <= window.left_part();
                let seen = matches!(window.place(block.start), ColumnPlace::Seen(_));
                assert!(
                    window.shows(block) || !whole && seen,
                    "{pane} {from} {block:?} {left}"
                );
            }
        }
    }
}

#[test]
fn cuts_are_exact() {
    let spare = [3..10, 20..23, 30..60];
    for number in 0..=40 {
        let cuts = cuts(&spare, number);
        let left_out: usize = cuts.iter().map(|cut| cut.columns.len()).sum();
        assert_eq!(left_out, number);
    }
}

//! The language reference shows every instruction as the table has it.
//!
//! After a change of the table, `UPDATE_EXPECT=1 cargo test -p ladder-tests` writes the pages again.

use expect_test::expect_file;
use ladder_instructions::{Op, TABLE, origin};
use ladder_tests::book::source;
use ladder_tests::instruction_pages::{PAGES, text};
use ladder_tests::instruction_runs::{has_diagram, only_marks, strays, table};
use std::collections::BTreeSet;

#[test]
fn the_pages_are_up_to_date() {
    let folder = source().join("language/instructions");
    for page in &PAGES {
        expect_file![folder.join(page.file)].assert_eq(&text(page));
    }
}

#[test]
fn every_instruction_is_on_a_page() {
    for row in TABLE {
        assert!(
            PAGES.iter().any(|page| page.group == row.group),
            "{}",
            row.signature()
        );
    }
}

/// A truth table, a timing diagram or a table of values, made by running the example: something happens in it.
#[test]
fn every_instruction_shows_what_it_does() {
    for row in TABLE.iter().filter(|row| !has_diagram(row)) {
        let table = table(row);
        let changes = |line: &&str| {
            let cells = line.split_once(' ').map_or("", |(_, cells)| cells.trim());
            let is_wave = cells.chars().all(|c| matches!(c, '_' | '-'));
            let values: BTreeSet<&str> = if is_wave {
                cells.split("").filter(|cell| !cell.is_empty()).collect()
            } else {
                cells.split_whitespace().collect()
            };
            values.len() > 1
        };
        let lines = table.lines().count();
        let moving = table.lines().filter(changes).count();
        let still = [Op::For, Op::Next, Op::Scantime];
        let least = if still.contains(&row.op) {
            0
        } else {
            2 - usize::from(only_marks(row))
        };
        assert!(
            lines > 0 && moving >= least,
            "{} shows too little:\n{table}",
            row.signature()
        );
    }
}

#[test]
fn every_instruction_says_where_it_comes_from() {
    for row in TABLE {
        assert!(!origin(row.op).is_empty(), "{}", row.signature());
    }
}

#[test]
fn every_stimulus_belongs_to_an_instruction() {
    assert!(strays().is_empty(), "{:?}", strays());
}

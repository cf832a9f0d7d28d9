//! Completion, with `$0` where the cursor is.

mod blocks;
mod declarations;
mod operands;
mod ranking;
mod types;

use super::{Completions, completions};
use expect_test::Expect;
use ladder_analysis::{Analysis, analyze};
use ladder_syntax::{TextSize, parse};
use std::fmt::Write;
use std::sync::Arc;

fn at_cursor(fixture: &str) -> (String, TextSize, Analysis) {
    let at = fixture.find("$0").expect("a fixture has its $0");
    let text = fixture.replacen("$0", "", 1);
    let analysis = analyze(&Arc::new(parse(&text)), "test.clad");
    (text, TextSize::new(at as u32), analysis)
}

fn found(fixture: &str) -> (String, Completions) {
    let (text, offset, analysis) = at_cursor(fixture);
    let found = completions(&analysis.context, offset, None);
    (text, found)
}

/// The first proposals: label and detail.
fn check(fixture: &str, expected: Expect) {
    const SHOWN: usize = 14;
    let (_, found) = found(fixture);
    let mut shown = String::new();
    for item in found.items.iter().take(SHOWN) {
        let _ = writeln!(shown, "{:<14} {}", item.label, item.detail);
    }
    if found.items.len() > SHOWN {
        let _ = writeln!(shown, "... {} in all", found.items.len());
    }
    if shown.is_empty() {
        shown.push_str("nothing\n");
    }
    expected.assert_eq(&shown);
}

/// The text once the proposal of this label is accepted: as a snippet, then as plain text.
fn accept(fixture: &str, label: &str, expected: Expect) {
    let (text, found) = found(fixture);
    let item = found
        .items
        .iter()
        .find(|item| item.label == label)
        .unwrap_or_else(|| panic!("{label} is not proposed"));
    let mut shown = String::new();
    for new in [item.text.snippet(), item.text.plain()] {
        let mut text = text.clone();
        text.replace_range(std::ops::Range::<usize>::from(item.range), &new);
        shown.push_str(&text);
    }
    expected.assert_eq(&shown);
}

const PLANT: &str = "VAR_INPUT start, stop : BOOL; level : INT; END_VAR\nVAR_OUTPUT run : BOOL; END_VAR\n\
                     VAR CONSTANT limit : INT := 80; on : BOOL := TRUE; END_VAR\n\
                     VAR warmup : TON; parts : CTU; total : DINT; flags : WORD; row : ARRAY[1..8] OF BOOL; name : STRING; wait : TIME; END_VAR\n";

fn in_plant(rung: &str) -> String {
    format!("{PLANT}{rung}\n")
}

const HOLD: &str = "FUNCTION_BLOCK [$Hold]\nVAR_INPUT raw : BOOL; wait : TIME := T#1s; END_VAR\n\
                    VAR_OUTPUT clean : BOOL; END_VAR\n+--[ ]( raw )--( )( clean )--+\nEND_FUNCTION_BLOCK\n";

/// Whatever is written so far and whatever is accepted: the line has no more errors than before, and the edit is
/// one stretch of the cursor's line that holds the cursor.
#[test]
fn what_is_accepted_reads() {
    let rungs = [
        "+--\\--[ ]( start )--\\--[/]( stop )--[TON]( warmup, T#5s )--( )( run )--+",
        "+--[GT]( level, limit )--[CALC]( total, MAX(level, 3) * (2 + total) )--(RES)( warmup )--+",
        "+--[$Hold]( start, wait, run )--[SEARCH]( total, EQ, level, row[1..4], FOUND => run )--<JMP>( done )--+",
    ];
    let errors = |text: &str| parse(text).errors().len();
    let mut accepted = 0;
    for rung in rungs {
        for cut in 0..=rung.len() {
            for after in ["", ")", "]", " --( )( run )--+", &rung[cut..]] {
                // Every place once, and every third with each of the others after it.
                if !after.is_empty() && cut % 3 != 0 {
                    continue;
                }
                let line = format!("{}{after}", &rung[..cut]);
                let text = format!("{PLANT}{line}\n{HOLD}");
                let before = errors(&line);
                let cursor = TextSize::new((PLANT.len() + cut) as u32);
                let analysis = analyze(&Arc::new(parse(&text)), "test.clad");
                let items = completions(&analysis.context, cursor, None).items;
                // An editor that shows a list after one column needs one column for all.
                let starts: std::collections::BTreeSet<_> =
                    items.iter().map(|item| item.range.start()).collect();
                assert!(starts.len() < 2, "{line} at {cut}");
                for item in items {
                    let written = &text[item.range.start().into()..cursor.into()];
                    let mut letters = item.filter.chars();
                    let found = written
                        .chars()
                        .all(|c| letters.any(|letter| letter.eq_ignore_ascii_case(&c)));
                    assert!(found, "{} is found by {written} in {line} at {cut}", item.label);
                    assert!(item.range.contains_inclusive(cursor));
                    assert!(!text[item.range].contains('\n'));
                    let range = item.range - TextSize::of(PLANT);
                    let mut new = line.clone();
                    new.replace_range(std::ops::Range::<usize>::from(range), &item.text.plain());
                    assert!(
                        errors(&new) <= before,
                        "{} in\n{line} at {cut} gives\n{new}",
                        item.label
                    );
                    accepted += 1;
                }
            }
        }
    }
    assert!(accepted > 10_000, "{accepted}");
}

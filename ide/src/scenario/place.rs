//! What is at an offset of a scenario file.

use super::file::Scenarios;
use ladder_simulator::scenario::{Row, Scenario};
use ladder_syntax::{TextRange, TextSize, line_around};

/// What the cursor is at.
#[derive(Debug, Clone, Copy)]
pub(super) enum AtCursor<'s> {
    /// The program's name.
    Program(TextRange),
    /// The name of a scenario.
    Scenario(&'s Scenario),
    /// The tag of a row.
    Tag(&'s Row),
    /// The value of a step: of which row of which scenario, and the number of the step, from 0.
    Step(&'s Scenario, &'s Row, usize),
    /// What is after `±`.
    Tolerance(TextRange),
}

/// What is at an offset; a cursor right after a word counts, unless something else begins there.
pub(super) fn place<'s>(scenarios: &Scenarios<'s>, offset: TextSize) -> Option<AtCursor<'s>> {
    let suite = scenarios.suite;
    if let Some((_, range)) = &suite.program
        && range.contains_inclusive(offset)
    {
        return Some(AtCursor::Program(*range));
    }
    // The last one that begins at the offset or before it.
    let after = |scenario: &Scenario| scenario.range.start() <= offset;
    let scenario = suite.scenarios.iter().rev().find(|scenario| after(scenario))?;
    if scenario.range.contains_inclusive(offset) {
        return Some(AtCursor::Scenario(scenario));
    }
    let row = scenario
        .rows
        .iter()
        .rev()
        .find(|row| row.range.start() <= offset)?;
    if row.range.contains_inclusive(offset) {
        return Some(AtCursor::Tag(row));
    }
    if let Some((_, range)) = &row.tolerance
        && range.contains_inclusive(offset)
    {
        return Some(AtCursor::Tolerance(*range));
    }
    let at = |touches: fn(TextRange, TextSize) -> bool| {
        row.cells.iter().position(|(_, range)| touches(*range, offset))
    };
    let step = at(TextRange::contains).or_else(|| at(TextRange::contains_inclusive))?;
    Some(AtCursor::Step(scenario, row, step))
}

/// The line of an offset, up to its end, and where it begins.
pub(super) fn line(text: &str, offset: TextSize) -> (TextSize, &str) {
    let line = line_around(text, offset);
    (line.start(), &text[line])
}

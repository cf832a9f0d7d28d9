//! What is at an offset of a scenario file.

use super::file::Scenarios;
use super::naming::{Naming, expressions, operands, side};
use ladder_simulator::scenario::{PlantLine, Property, Row, Scenario, Suite, TimeRow};
use ladder_syntax::{TextRange, TextSize, line_around};

/// What the cursor is at.
#[derive(Debug, Clone, Copy)]
pub(super) enum AtCursor<'s> {
    /// The program's name.
    Program(TextRange),
    /// A plant.
    Plant(&'s PlantLine),
    /// A side of a connection.
    Side(Naming<'s>),
    /// The name of a scenario.
    Scenario(&'s Scenario),
    /// The tag of a row.
    Tag(&'s Row),
    /// The value of a step: of which row of which scenario, and the number of its cell, from 0.
    Step(&'s Scenario, &'s Row, usize),
    /// What is after `±`.
    Tolerance(TextRange),
    /// How long a step is: its place in a row `time`, and the number of the step.
    Time(&'s Scenario, TextRange, usize),
    /// The name of a property.
    Property(&'s Property),
    /// What an expression of a property or an assumption names.
    Operand(Naming<'s>),
}

/// What is at an offset; a cursor right after a word counts, unless something else begins there.
pub(super) fn place<'s>(scenarios: &Scenarios<'s>, offset: TextSize) -> Option<AtCursor<'s>> {
    let suite = scenarios.suite;
    if let Some((_, range)) = &suite.program
        && range.contains_inclusive(offset)
    {
        return Some(AtCursor::Program(*range));
    }
    let mut plants = suite.plants.iter();
    if let Some(plant) = plants.find(|it| it.range.contains_inclusive(offset)) {
        return Some(AtCursor::Plant(plant));
    }
    let mut sides = suite.connects.iter().flat_map(|connect| &connect.sides);
    if let Some(found) = sides.find(|it| it.range.contains_inclusive(offset)) {
        return Some(AtCursor::Side(side(found)));
    }
    let mut named = suite.properties.iter().filter(|it| it.range != it.place);
    if let Some(property) = named.find(|it| it.range.contains_inclusive(offset)) {
        return Some(AtCursor::Property(property));
    }
    if let Some(operand) = operand_at(suite, offset) {
        return Some(AtCursor::Operand(operand));
    }
    // The last one that begins at the offset or before it.
    let after = |scenario: &Scenario| scenario.range.start() <= offset;
    let scenario = suite.scenarios.iter().rev().find(|scenario| after(scenario))?;
    if scenario.range.contains_inclusive(offset) {
        return Some(AtCursor::Scenario(scenario));
    }
    let time = scenario
        .times
        .iter()
        .rev()
        .find(|row| row.range.start() <= offset);
    let row = scenario.rows.iter().rev().find(|row| row.range.start() <= offset);
    if let Some(time) = time.filter(|time| row.is_none_or(|row| row.range.start() < time.range.start())) {
        return in_time(scenario, time, offset);
    }
    let row = row?;
    if row.range.contains_inclusive(offset) {
        return Some(AtCursor::Tag(row));
    }
    if let Some((_, range)) = &row.tolerance
        && range.contains_inclusive(offset)
    {
        return Some(AtCursor::Tolerance(*range));
    }
    let step = cell_at(row.cells.iter().map(|(_, range)| *range), offset)?;
    Some(AtCursor::Step(scenario, row, step))
}

/// The operand at an offset; of one within another's index that one.
fn operand_at(suite: &Suite, offset: TextSize) -> Option<Naming<'_>> {
    let mut at = expressions(suite).into_iter();
    let expression = at.find(|it| it.range.contains_inclusive(offset))?;
    let mut inside = operands(expression).into_iter();
    inside.rfind(|it| it.range.contains_inclusive(offset))
}

fn in_time<'s>(scenario: &'s Scenario, time: &'s TimeRow, offset: TextSize) -> Option<AtCursor<'s>> {
    let cell = cell_at(time.cells.iter().map(|(_, range)| *range), offset)?;
    Some(AtCursor::Time(scenario, time.cells[cell].1, time.first + cell))
}

/// The cell at an offset; of two that touch there the second.
fn cell_at(cells: impl Iterator<Item = TextRange> + Clone, offset: TextSize) -> Option<usize> {
    let at =
        |touches: fn(TextRange, TextSize) -> bool| cells.clone().position(|range| touches(range, offset));
    at(TextRange::contains).or_else(|| at(TextRange::contains_inclusive))
}

/// The line of an offset, up to its end, and where it begins.
pub(super) fn line(text: &str, offset: TextSize) -> (TextSize, &str) {
    let line = line_around(text, offset);
    (line.start(), &text[line])
}

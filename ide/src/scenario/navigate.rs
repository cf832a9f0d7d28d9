//! From a row or a property to the program and back: definition and highlights; `references` and `rename` ask here what is named.

use super::file::Scenarios;
use super::place::{AtCursor, place};
use super::row::{Files, named, places_in, within};
use crate::definition::defined;
use crate::highlight::Highlight;
use crate::symbol::Symbol;
use crate::target::Target;
use ladder_syntax::{TextRange, TextSize};
use std::sync::Arc;

/// What is named at an offset: the tag, a member or a value, and where its name is.
pub(crate) fn symbol_at(scenarios: &Scenarios<'_>, offset: TextSize) -> Option<(Symbol, TextRange)> {
    let files = Files::of(scenarios)?;
    match place(scenarios, offset)? {
        AtCursor::Tag(row) => in_name(files, &row.name, row.range, offset),
        AtCursor::Operand(operand) | AtCursor::Side(operand) => {
            in_name(files, operand.text, operand.range, offset)
        }
        AtCursor::Step(_, row, _) => {
            let cells = named(files, &row.name)?.in_cells(row);
            let found = cells
                .into_iter()
                .find(|(range, _)| range.contains_inclusive(offset));
            found.map(|(range, symbol)| (symbol, range))
        }
        _ => None,
    }
}

fn in_name(files: Files<'_>, name: &str, range: TextRange, offset: TextSize) -> Option<(Symbol, TextRange)> {
    let named = named(files, name)?;
    // An index, or a member of a timer, leads to its tag.
    let found = named.at(usize::from(offset - range.start()));
    let (word, symbol) = found.unwrap_or((&named.name, &named.symbol));
    Some((symbol.clone(), within(range, word)))
}

/// Where what is at an offset is defined: a tag in its file, or the program.
pub fn definition(scenarios: &Scenarios<'_>, offset: TextSize) -> Vec<Target> {
    let Some(program) = scenarios.program else {
        return Vec::new();
    };
    let file = match place(scenarios, offset) {
        Some(AtCursor::Program(_)) => Some(Arc::clone(&program.name)),
        Some(AtCursor::Plant(plant)) => {
            let file = Files::of(scenarios).and_then(|files| files.plant(plant));
            file.map(|file| Arc::clone(&file.name))
        }
        _ => None,
    };
    if let Some(file) = file {
        let begin = TextRange::empty(TextSize::new(0));
        return vec![Target {
            file,
            range: begin,
            focus: begin,
        }];
    }
    match symbol_at(scenarios, offset) {
        Some((symbol, _)) => defined(program, &symbol, scenarios.workspace),
        None => Vec::new(),
    }
}

/// The places of the file that name what is at an offset.
pub fn highlights(scenarios: &Scenarios<'_>, offset: TextSize) -> Vec<Highlight> {
    let (Some((wanted, _)), Some(files)) = (symbol_at(scenarios, offset), Files::of(scenarios)) else {
        return Vec::new();
    };
    let found = places_in(scenarios.suite, files, &wanted);
    found
        .into_iter()
        .map(|(range, usage)| Highlight { range, usage })
        .collect()
}

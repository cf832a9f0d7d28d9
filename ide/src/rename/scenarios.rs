//! The rows of scenarios are named after tags: they follow.

use super::Renamed;
use crate::neighbour::{ScenarioFile, Workspace};
use crate::scenario::row::name_in;
use crate::symbol::Symbol;
use ladder_format::{Edit, display_width};
use ladder_simulator::scenario::Row;
use ladder_syntax::{TextRange, TextSize};
use std::sync::Arc;

/// The edits of all files of scenarios. `hides` says whether a program has a tag of its own by the name of a
/// global one.
pub(super) fn renamed(
    symbol: &Symbol,
    new: &str,
    workspace: &dyn Workspace,
    hides: &dyn Fn(&str) -> bool,
) -> Vec<Renamed> {
    // Only a file's own tags and global ones have names outside.
    if !matches!(symbol, Symbol::Tag { scope: 0, .. } | Symbol::Global(_)) {
        return Vec::new();
    }
    let file = |scenarios: ScenarioFile| {
        let edits = of_file(symbol, new, &scenarios, hides);
        (!edits.is_empty()).then(|| Renamed {
            file: Arc::clone(&scenarios.name),
            edits,
        })
    };
    workspace.scenarios().into_iter().filter_map(file).collect()
}

fn of_file(symbol: &Symbol, new: &str, file: &ScenarioFile, hides: &dyn Fn(&str) -> bool) -> Vec<Edit> {
    let Some(program) = &file.program else {
        return Vec::new();
    };
    if matches!(symbol, Symbol::Global(_)) && hides(program) {
        return Vec::new();
    }
    let mut edits = Vec::new();
    for scenario in &file.suite.scenarios {
        let names: Vec<Option<TextRange>> = scenario
            .rows
            .iter()
            .map(|row| name_in(row, symbol, program))
            .collect();
        if names.iter().all(Option::is_none) {
            continue;
        }
        let new_width = i64::from(display_width(new));
        let grows = |name: &Option<TextRange>| match name {
            Some(range) => new_width - i64::from(display_width(&file.text[*range])),
            None => 0,
        };
        // All rows keep their columns in common, with at least one blank after each name.
        let room = |(row, name): (&Row, &Option<TextRange>)| {
            i64::from(u32::from(blanks_after(row, &file.text).len())) - grows(name)
        };
        let least = scenario.rows.iter().zip(&names).map(room).min().unwrap_or(1);
        let more = (1 - least).max(0);
        for (row, name) in scenario.rows.iter().zip(&names) {
            if let Some(range) = *name {
                edits.push(Edit {
                    range,
                    text: new.to_owned(),
                });
            }
            let blanks = blanks_after(row, &file.text);
            let width = room((row, name)) + more;
            if width != i64::from(u32::from(blanks.len())) && !blanks.is_empty() {
                edits.push(Edit {
                    range: blanks,
                    text: " ".repeat(width.max(1) as usize),
                });
            }
        }
    }
    edits.sort_by_key(|edit| edit.range.start());
    edits
}

/// The blanks between a row's name and what follows.
fn blanks_after(row: &Row, text: &str) -> TextRange {
    let written = &text[row.range];
    let name = written.find(char::is_whitespace).unwrap_or(written.len());
    let end = row.range.start() + TextSize::new(name as u32);
    let after = &text[usize::from(end)..];
    let blanks = after.len() - after.trim_start_matches([' ', '\t']).len();
    TextRange::at(end, TextSize::new(blanks as u32))
}

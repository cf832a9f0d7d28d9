//! Scenarios and properties name tags, members and values: they follow.

use super::layout::compose;
use super::{RenameRefused, Renamed};
use crate::neighbour::{ScenarioFile, Workspace};
use crate::scenario::connected::lines;
use crate::scenario::edits::layout;
use crate::scenario::row::{naming, with_files};
use crate::symbol::Symbol;
use ladder_analysis::context::Context;
use ladder_format::{Edit, apply, display_width};
use ladder_simulator::scenario::{Row, Suite, parse};
use ladder_syntax::{Name, TextRange, TextSize, line_around};
use std::collections::BTreeSet;
use std::sync::Arc;

/// The edits of all files of scenarios. `own` is the file that was asked about.
///
/// # Errors
/// A plant would be connected with something else.
pub(super) fn renamed(
    own: &Context,
    symbol: &Symbol,
    new: &str,
    workspace: &dyn Workspace,
) -> Result<Vec<Renamed>, RenameRefused> {
    let file = |scenarios: ScenarioFile| {
        let connections = still_connected(&scenarios, own, symbol, new, workspace)?;
        let named = |range| Edit {
            range,
            text: new.to_owned(),
        };
        let mut edits = Vec::new();
        for found in naming(&scenarios, symbol, own, workspace) {
            edits.extend(found.in_name.into_iter().chain(found.in_cells).map(named));
        }
        edits.retain(|edit| scenarios.text[edit.range] != edit.text);
        edits.extend(connections);
        let edits = in_columns(&scenarios.suite, &scenarios.text, edits);
        Ok((!edits.is_empty()).then(|| Renamed {
            file: Arc::clone(&scenarios.name),
            edits,
        }))
    };
    let files = workspace.scenarios().into_iter().map(file);
    files.filter_map(Result::transpose).collect()
}

/// The lines that keep connected what a plant and the program have connected by name.
fn still_connected(
    scenarios: &ScenarioFile,
    own: &Context,
    symbol: &Symbol,
    new: &str,
    workspace: &dyn Workspace,
) -> Result<Option<Edit>, RenameRefused> {
    let Suite { plants, connects, .. } = &*scenarios.suite;
    let of_connects = connects.iter().map(|connect| connect.range.end());
    let of_plants = plants.iter().map(|plant| plant.range.end());
    // A scene has no place for such a line.
    let is_scene = scenarios.name.ends_with(".svg");
    if is_scene || plants.is_empty() || symbol.name().is_none_or(|name| *name == Name::new(new)) {
        return Ok(None);
    }
    let lines = with_files(scenarios, own, workspace, |files| lines(files, symbol, new));
    let lines = lines.unwrap_or(Ok(Vec::new())).map_err(RenameRefused)?;
    let (Some(last), false) = (of_connects.chain(of_plants).max(), lines.is_empty()) else {
        return Ok(None);
    };
    let line = line_around(&scenarios.text, last);
    let ends_in_cr = scenarios.text[usize::from(line.end())..].starts_with('\r');
    let end = if ends_in_cr { "\r\n" } else { "\n" };
    Ok(Some(Edit {
        range: TextRange::empty(line.end()),
        text: format!("{end}{}", lines.join(end)),
    }))
}

/// Edits of words of rows, with the blanks that keep the columns: a scenario that was laid out before is laid out
/// afterwards if its cells changed; of others the rows still begin below each other.
pub(crate) fn in_columns(suite: &Suite, text: &str, words: Vec<Edit>) -> Vec<Edit> {
    let mut edits = words;
    edits.sort_by_key(|edit| edit.range.start());
    let mut blanks = Vec::new();
    let mut in_cells = BTreeSet::new();
    for (number, scenario) in suite.scenarios.iter().enumerate() {
        let grows: Vec<Option<i64>> = scenario.rows.iter().map(|row| grows(row, text, &edits)).collect();
        let changed = |row: &Row| {
            let cells = row.cells.first().zip(row.cells.last());
            let cells = cells.map(|(first, last)| first.1.cover(last.1));
            cells.is_some_and(|cells| edits.iter().any(|edit| cells.contains_range(edit.range)))
        };
        if scenario.rows.iter().any(changed) {
            in_cells.insert(number);
        }
        if grows.iter().all(Option::is_none) {
            continue;
        }
        // All rows keep their columns in common, with at least one blank after each name.
        let room = |(row, grows): (&Row, &Option<i64>)| {
            i64::from(u32::from(blanks_after(row, text).len())) - grows.unwrap_or(0)
        };
        let least = scenario.rows.iter().zip(&grows).map(room).min().unwrap_or(1);
        let more = (1 - least).max(0);
        for (row, grows) in scenario.rows.iter().zip(&grows) {
            let range = blanks_after(row, text);
            let width = room((row, grows)) + more;
            if width != i64::from(u32::from(range.len())) && !range.is_empty() {
                blanks.push(Edit {
                    range,
                    text: " ".repeat(width.max(1) as usize),
                });
            }
        }
    }
    edits.extend(blanks);
    edits.sort_by_key(|edit| edit.range.start());
    if in_cells.is_empty() {
        return edits;
    }
    let is_straight = {
        let crooked = layout(text);
        move |range: TextRange| !crooked.iter().any(|edit| range.contains_range(edit.range))
    };
    let straight: Vec<usize> = in_cells
        .into_iter()
        .filter(|number| is_straight(extent(suite, text, *number)))
        .collect();
    let between = apply(text, &edits);
    let after = parse(&between);
    let mut straight_again = layout(&between);
    let ranges: Vec<TextRange> = straight
        .iter()
        .map(|number| extent(&after, &between, *number))
        .collect();
    straight_again.retain(|edit| ranges.iter().any(|range| range.contains_range(edit.range)));
    compose(text, &edits, &between, &straight_again)
}

/// From a scenario's name to the next.
fn extent(suite: &Suite, text: &str, number: usize) -> TextRange {
    let next = suite.scenarios.get(number + 1);
    let end = next.map_or(TextSize::of(text), |next| next.range.start());
    suite
        .scenarios
        .get(number)
        .map_or(TextRange::empty(end), |it| TextRange::new(it.range.start(), end))
}

/// By how many columns the name of a row grows; none if it stays.
fn grows(row: &Row, text: &str, edits: &[Edit]) -> Option<i64> {
    let own = edits.iter().filter(|edit| row.range.contains_range(edit.range));
    own.map(|edit| i64::from(display_width(&edit.text)) - i64::from(display_width(&text[edit.range])))
        .reduce(|all, one| all + one)
}

/// The blanks between a row's name and what follows.
fn blanks_after(row: &Row, text: &str) -> TextRange {
    let end = row.range.end();
    let after = &text[usize::from(end)..];
    let blanks = after.len() - after.trim_start_matches([' ', '\t']).len();
    TextRange::at(end, TextSize::new(blanks as u32))
}

//! The columns of one scenario.

use super::super::suite::{Cell, Row, TimeRow};
use super::{at, is_expected, ruler, width};
use ladder_syntax::{TextRange, line_around};

/// What is between a tag and its values: an arrow with a blank at either side, or as many blanks.
const ARROW: &str = " => ";

/// A row of cells below others.
#[derive(Debug, Clone)]
pub(super) struct Laid {
    /// What it begins with.
    name: TextRange,
    is_expected: bool,
    /// The step of its first cell.
    pub(super) first: usize,
    /// Where each cell is, and whether it is as long as its value.
    cells: Vec<(bool, TextRange)>,
    tolerance: Option<TextRange>,
}

impl From<&Row> for Laid {
    fn from(row: &Row) -> Laid {
        let cell = |(cell, place): &(Cell, TextRange)| (matches!(cell, Cell::Value(_)), *place);
        Laid {
            name: row.range,
            is_expected: is_expected(row),
            first: row.first,
            cells: row.cells.iter().map(cell).collect(),
            tolerance: row.tolerance.as_ref().map(|(_, place)| *place),
        }
    }
}

impl From<&TimeRow> for Laid {
    fn from(row: &TimeRow) -> Laid {
        Laid {
            name: row.range,
            is_expected: false,
            first: row.first,
            cells: row
                .cells
                .iter()
                .map(|(time, place)| (time.is_some(), *place))
                .collect(),
            tolerance: None,
        }
    }
}

/// Where the rows of a scenario have their columns.
#[derive(Debug, Default)]
pub(super) struct Columns {
    /// The width of the longest tag.
    names: usize,
    /// Of each step: whether a blank is before it, and how wide it is.
    steps: Vec<(bool, usize)>,
    /// Where the comments after rows begin.
    comments: usize,
    /// For each step of the longest row, where it was and where it goes.
    moves: Vec<(usize, usize)>,
}

impl Columns {
    /// The width of the longest tag.
    pub(super) fn names(rows: &[Laid], text: &str) -> usize {
        rows.iter()
            .map(|row| width(at(text, row.name)))
            .max()
            .unwrap_or(0)
    }

    /// The columns of rows below each other, whose longest tag has this width.
    pub(super) fn of(rows: &[Laid], names: usize, text: &str) -> Columns {
        let count = rows.iter().map(|row| row.cells.len()).max().unwrap_or(0);
        let steps = (0..count).map(|step| (is_apart(rows, step), widest(rows, step, text)));
        let mut columns = Columns {
            names,
            steps: steps.collect(),
            ..Columns::default()
        };
        columns.moves = columns.moves(rows, text);
        let ends = rows.iter().map(|row| width(&columns.row(row, text)));
        columns.comments = ends.max().unwrap_or(0) + 2;
        columns
    }

    /// A row with the comment after it.
    pub(super) fn line(&self, row: &Laid, comment: Option<&str>, text: &str) -> String {
        let mut line = self.row(row, text);
        if let Some(comment) = comment {
            pad(&mut line, self.comments);
            line.push_str(comment);
        }
        line
    }

    fn row(&self, row: &Laid, text: &str) -> String {
        let mut line = at(text, row.name).to_owned();
        pad(&mut line, self.names);
        line.push_str(if row.is_expected { ARROW } else { "    " });
        for ((_, place), (step, end)) in row.cells.iter().zip(self.places()) {
            pad(&mut line, self.names + ARROW.len() + step);
            line.push_str(at(text, *place));
            if row.tolerance.is_some() {
                pad(&mut line, self.names + ARROW.len() + end);
            }
        }
        if let Some(place) = &row.tolerance {
            let written = at(text, *place);
            line.push(' ');
            if written.contains(['\'', '"', '[']) {
                line.push_str(written);
            } else {
                line.push_str(&written.split_whitespace().collect::<Vec<_>>().join(" "));
            }
        }
        line
    }

    /// Where each step begins and ends, from the first one on.
    fn places(&self) -> impl Iterator<Item = (usize, usize)> {
        let mut at = 0;
        self.steps.iter().map(move |(apart, width)| {
            let start = at + usize::from(*apart);
            at = start + width;
            (start, at)
        })
    }

    fn moves(&self, rows: &[Laid], text: &str) -> Vec<(usize, usize)> {
        let longest = rows.iter().rev().max_by_key(|row| row.cells.len());
        let Some(row) = longest else {
            return Vec::new();
        };
        let line = line_around(text, row.name.start()).start();
        let line = &text[usize::from(line)..];
        let line = line.strip_prefix('\u{feff}').unwrap_or(line);
        let start = text.len() - line.len();
        let was = row
            .cells
            .iter()
            .map(|(_, place)| width(&text[start..usize::from(place.start())]));
        let goes = self.places().map(|(step, _)| self.names + ARROW.len() + step);
        was.zip(goes).collect()
    }

    /// A comment between the rows: one that names the steps below it goes with them.
    pub(super) fn ruler(&self, comment: &str) -> String {
        ruler::moved(comment, &self.moves)
    }
}

/// Whether a blank is before a step: where a value is longer than a letter might be, or where most rows have one.
fn is_apart(rows: &[Laid], step: usize) -> bool {
    let Some(before) = step.checked_sub(1) else {
        return false;
    };
    let is_value = |row: &Laid, step: usize| row.cells.get(step).is_some_and(|cell| cell.0);
    if rows
        .iter()
        .any(|row| is_value(row, before) || is_value(row, step))
    {
        return true;
    }
    let pairs = rows
        .iter()
        .filter_map(|row| Some((row.cells.get(before)?.1, row.cells.get(step)?.1)));
    let (touching, apart): (Vec<_>, Vec<_>) = pairs.partition(|(left, right)| left.end() == right.start());
    apart.len() > touching.len()
}

fn widest(rows: &[Laid], step: usize, text: &str) -> usize {
    let cells = rows.iter().filter_map(|row| row.cells.get(step));
    cells.map(|(_, place)| width(at(text, *place))).max().unwrap_or(0)
}

/// Blanks up to a column.
fn pad(line: &mut String, column: usize) {
    let missing = column.saturating_sub(width(line));
    line.extend(std::iter::repeat_n(' ', missing));
}

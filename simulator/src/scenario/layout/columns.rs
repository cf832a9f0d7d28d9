//! The columns of one scenario.

use super::super::parse::{Cell, Row};
use super::{at, is_expected, ruler, width};
use ladder_syntax::line_around;

/// What is between a tag and its values: an arrow with a blank at either side, or as many blanks.
const ARROW: &str = " => ";

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
    /// The columns of rows.
    pub(super) fn of(rows: &[&Row], text: &str) -> Columns {
        let names = rows.iter().map(|row| width(at(text, row.range))).max();
        let count = rows.iter().map(|row| row.cells.len()).max().unwrap_or(0);
        let steps = (0..count).map(|step| (is_apart(rows, step), widest(rows, step, text)));
        let mut columns = Columns {
            names: names.unwrap_or(0),
            steps: steps.collect(),
            ..Columns::default()
        };
        columns.moves = columns.moves(rows, text);
        let ends = rows.iter().map(|row| width(&columns.row(row, text)));
        columns.comments = ends.max().unwrap_or(0) + 2;
        columns
    }

    /// A row with the comment after it.
    pub(super) fn line(&self, row: &Row, comment: Option<&str>, text: &str) -> String {
        let mut line = self.row(row, text);
        if let Some(comment) = comment {
            pad(&mut line, self.comments);
            line.push_str(comment);
        }
        line
    }

    fn row(&self, row: &Row, text: &str) -> String {
        let mut line = at(text, row.range).to_owned();
        pad(&mut line, self.names);
        line.push_str(if is_expected(row) { ARROW } else { "    " });
        for ((_, place), (step, end)) in row.cells.iter().zip(self.places()) {
            pad(&mut line, self.names + ARROW.len() + step);
            line.push_str(at(text, *place));
            if row.tolerance.is_some() {
                pad(&mut line, self.names + ARROW.len() + end);
            }
        }
        if let Some((_, place)) = &row.tolerance {
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

    fn moves(&self, rows: &[&Row], text: &str) -> Vec<(usize, usize)> {
        let longest = rows.iter().rev().max_by_key(|row| row.cells.len());
        let Some(row) = longest else {
            return Vec::new();
        };
        let line = line_around(text, row.range.start()).start();
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
fn is_apart(rows: &[&Row], step: usize) -> bool {
    let Some(before) = step.checked_sub(1) else {
        return false;
    };
    let is_value = |row: &&Row, step: usize| matches!(row.cells.get(step), Some((Cell::Value(_), _)));
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

fn widest(rows: &[&Row], step: usize, text: &str) -> usize {
    let cells = rows.iter().filter_map(|row| row.cells.get(step));
    cells.map(|(_, place)| width(at(text, *place))).max().unwrap_or(0)
}

/// Blanks up to a column.
fn pad(line: &mut String, column: usize) {
    let missing = column.saturating_sub(width(line));
    line.extend(std::iter::repeat_n(' ', missing));
}

//! The declarations as a table.

use super::super::measure::columns;
use super::super::paper::Paper;
use super::super::shapes::{Anchor, Shape};
use super::super::style::{LINE, Look, UNIT};
use super::super::symbol::width;
use super::super::wrap::wrap;
use super::declarations::{COLUMNS, Group, Row};

/// Columns between two columns of the table.
const APART: u32 = 2;
/// The most columns that each column of the table takes, but for the last, which has the rest.
const WIDEST: [u32; 4] = [28, 24, 10, 18];
/// Pixels above and below the text of a row.
const PADDING: i32 = 3;

/// More lines than this are several pieces.
const MOST_LINES: usize = 20;

/// Shapes, and the height that they take.
pub(super) type Drawn = (Vec<Shape>, i32);

/// Where the columns of the table begin, and how wide they are.
pub(super) struct Table {
    names: [&'static str; 5],
    places: [(u32, u32); 5],
    width: u32,
}

impl Table {
    /// Columns for these declarations on a page that is this many columns wide.
    pub(super) fn new(groups: &[Group], width: u32) -> Table {
        Table::with_columns(COLUMNS, groups, width)
    }

    /// The same with other names of the columns.
    pub(super) fn with_columns(names: [&'static str; 5], groups: &[Group], width: u32) -> Table {
        let mut places = [(0, 0); 5];
        let mut at = 0;
        for (column, most) in WIDEST.into_iter().enumerate() {
            let rows = groups.iter().flat_map(|group| &group.rows);
            let widest = rows.map(|row| columns(&row[column])).max().unwrap_or(0);
            let wide = widest.min(most).max(columns(names[column]));
            places[column] = (at, wide);
            at += wide + APART;
        }
        places[4] = (at, width.saturating_sub(at).max(10));
        Table { names, places, width }
    }

    /// The names of the columns, with a line below.
    pub(super) fn header(&self) -> Drawn {
        let mut paper = Paper::default();
        for (name, (at, _)) in self.names.into_iter().zip(self.places) {
            let at = (at as i32 * UNIT, PADDING + LINE - 4);
            paper.text(Look::Name, at, Anchor::Start, width(name), name);
        }
        self.end(paper, PADDING + LINE, Look::Line)
    }

    /// A row, with a line below. One that would be very high comes in pieces.
    pub(super) fn row(&self, row: &Row) -> Vec<Drawn> {
        let cells = row.iter().zip(self.places);
        let cells: Vec<Vec<String>> = cells.map(|(text, (_, wide))| wrap(text, wide)).collect();
        let lines = cells.iter().map(Vec::len).max().unwrap_or(1);
        let mut pieces = Vec::new();
        for first in (0..lines).step_by(MOST_LINES) {
            let mut paper = Paper::default();
            let count = (lines - first).min(MOST_LINES);
            for (column, cell) in cells.iter().enumerate() {
                let look = if column == 4 { Look::Comment } else { Look::Text };
                for (number, text) in cell.iter().skip(first).take(count).enumerate() {
                    let base = PADDING + (number as i32 + 1) * LINE - 4;
                    let at = (self.places[column].0 as i32 * UNIT, base);
                    paper.text(look, at, Anchor::Start, width(text), text);
                }
            }
            let bottom = PADDING + count as i32 * LINE;
            pieces.push(if first + count < lines {
                (paper.into_shapes(), bottom)
            } else {
                self.end(paper, bottom, Look::Rule)
            });
        }
        pieces
    }

    fn end(&self, mut paper: Paper, bottom: i32, rule: Look) -> Drawn {
        let bottom = bottom + PADDING;
        paper.line(rule, (0, bottom), (self.width as i32 * UNIT, bottom));
        (paper.into_shapes(), bottom + 1)
    }
}

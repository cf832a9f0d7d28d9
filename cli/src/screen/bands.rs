//! Which lines of a program are folded together, and what is in their columns.

use super::columns;
use super::fold::{Band, Content, LineShape};
use super::sheet::{Indexed, Sheet, Shown};
use ladder_analysis::values::types::Scalar;
use ladder_format::display_width;
use ladder_simulator::Point;
use ladder_syntax::{LineKind, Parse};
use std::ops::Range;

/// The bands of a program, from top to bottom.
pub(super) fn of(sheet: &Sheet, parse: &Parse) -> Vec<Band> {
    let mut bands = Vec::new();
    let mut next = 0;
    for network in &parse.structure().networks {
        let mut last = network.lines.end;
        // Rails that are drawn on below a rung go with it.
        while parse
            .lines()
            .get(last)
            .is_some_and(|line| line.kind == LineKind::Rail)
        {
            last += 1;
        }
        let lines = lines_of(network.lines.start..last, sheet, parse);
        if lines.start < next {
            continue;
        }
        if next < lines.start {
            bands.push(plain(next..lines.start, sheet));
        }
        next = lines.end;
        let shapes: Vec<LineShape> = lines.clone().map(|line| shape(line, sheet)).collect();
        bands.push(Band::network(lines, &shapes));
    }
    if next < sheet.height() || bands.is_empty() {
        bands.push(plain(next..sheet.height(), sheet));
    }
    bands
}

/// The lines of the file that logical lines take.
fn lines_of(lines: Range<usize>, sheet: &Sheet, parse: &Parse) -> Range<usize> {
    let start = parse.line_range(lines.start).start();
    let end = parse.line_range(lines.end - 1).end();
    let last = usize::from(end).max(usize::from(start) + 1) - 1;
    sheet.line_at(start.into())..sheet.line_at(last) + 1
}

fn plain(lines: Range<usize>, sheet: &Sheet) -> Band {
    let full = lines.clone().map(|line| columns::width(sheet.line(line))).max();
    Band::plain(lines, full.unwrap_or(0))
}

/// What is in the columns of a line.
fn shape(line: usize, sheet: &Sheet) -> LineShape {
    let (text, start) = (sheet.line(line), sheet.line_start(line));
    let blocks = &sheet.blocks[sheet.blocks_of(line)];
    let mut shape = LineShape {
        blocks: blocks
            .iter()
            .map(|block| columns::column(text, block.start - start)..columns::column(text, block.end - start))
            .collect(),
        values: values(line, sheet),
        ..LineShape::default()
    };
    let mut rail = 0;
    for cell in columns::cells(text) {
        let offset = start + cell.offset;
        let comment = sheet.is_comment(offset);
        let content = match cell.shown {
            _ if comment || sheet.block_at(offset).is_some() => Content::Fixed,
            "-" => Content::Wire,
            // A tab is not divided.
            " " if cell.width == 1 => Content::Blank,
            _ => Content::Fixed,
        };
        shape.columns.extend(std::iter::repeat_n(content, cell.width));
        if !comment && content == Content::Fixed {
            rail = shape.columns.len();
        }
    }
    shape.full = shape.columns.len();
    shape.columns.truncate(rail);
    shape
}

/// How many columns the values at the end of a line take, as far as that can be known before they run.
fn values(line: usize, sheet: &Sheet) -> usize {
    let widths = sheet.shown(line).map(|shown| match shown {
        Shown::Progress {
            name,
            reached,
            goal_width,
            ..
        } => width(name) + 1 + room(reached, *goal_width) + 1 + goal_width,
        Shown::Value(point) => width(&point.name) + 1 + room(point, 0),
        Shown::Indexed(Indexed { sample, .. }) => width(&sample.name) + 1 + room(sample, 0),
    });
    // Two blanks between them.
    widths.reduce(|all, next| all + 2 + next).unwrap_or(0)
}

fn width(text: &str) -> usize {
    display_width(text) as usize
}

/// The columns of a value of common size. One that takes more is marked at the edge.
fn room(point: &Point, least: usize) -> usize {
    let common = match point.ty {
        Scalar::Bool => 1,
        Scalar::Time => 5,
        Scalar::Real | Scalar::Lreal => 6,
        ty if ty.is_string() || ty.is_date() => 10,
        _ => 4,
    };
    common.max(least)
}

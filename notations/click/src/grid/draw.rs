//! Rungs of the model drawn into cells.
//!
//! A rung's condition is at the left, from its first row down. Its outputs share those rows and go further down
//! where there are more of them; a condition that one of them has for itself is on its row, after the wire that
//! goes down to all outputs. Pins come below everything, each with its own way from the left rail.

use super::super::model::Condition;
use super::addresses::Addresses;
use super::cell::{Body, COLUMNS, Row, Text};
use super::contact;
use super::file::MOST_ROWS;
use ladder_notation::LineColumn;

/// Why a rung cannot be drawn.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Undrawable {
    /// It is wider than the grid.
    Wide,
    /// It has more rows than a rung may have.
    Tall,
    /// Something in it has no counterpart: what.
    Unsaid(String),
}

/// An output to be drawn.
pub(super) struct Drawn<'m> {
    pub(super) output: String,
    /// What it has for itself.
    pub(super) condition: &'m Condition,
    /// Its pins, with their conditions.
    pub(super) pins: Vec<(String, &'m Condition)>,
}

/// The condition of what has none.
static WIRE: Condition = Condition::ALWAYS;

impl Drawn<'_> {
    /// Without a condition of its own.
    fn bare(&self) -> Drawn<'_> {
        Drawn {
            output: self.output.clone(),
            condition: &WIRE,
            pins: self.pins.clone(),
        }
    }
}

/// Draws a rung. Only the last output may have pins.
///
/// # Errors
///
/// See [`Undrawable`].
pub(super) fn rung(
    condition: &Condition,
    outputs: &[Drawn<'_>],
    addresses: &Addresses,
) -> Result<Vec<Row>, Undrawable> {
    if let [first, others @ ..] = outputs
        && !first.condition.is_always()
        && others.iter().all(|other| other.condition == first.condition)
    {
        // What all outputs have for themselves is as good as the rung's own.
        let whole = Condition::All(vec![condition.clone(), first.condition.clone()]);
        let bare: Vec<Drawn<'_>> = outputs.iter().map(Drawn::bare).collect();
        return rung(&whole, &bare, addresses);
    }
    let mut sheet = Sheet {
        rows: Vec::new(),
        addresses,
    };
    let common = Shape::of(condition);
    let height = sheet.outputs(&common, outputs, 0, 0)?;
    let pins = outputs.iter().flat_map(|output| &output.pins);
    let mut row = height;
    for (pin, condition) in pins {
        let own = Shape::of(condition);
        let end = sheet.shape(&own, row, 0)?;
        sheet.output(row, end, pin)?;
        row += own.height;
    }
    if sheet.rows.len() > MOST_ROWS {
        return Err(Undrawable::Tall);
    }
    Ok(sheet.rows)
}

/// A condition whose size is known.
struct Shape<'m> {
    kind: ShapeKind<'m>,
    width: usize,
    height: usize,
}

enum ShapeKind<'m> {
    Contact(&'m Condition),
    Series(Vec<Shape<'m>>),
    Parallel(Vec<Shape<'m>>),
}

impl<'m> Shape<'m> {
    fn of(condition: &'m Condition) -> Shape<'m> {
        match condition {
            Condition::Contact(_) | Condition::Compare(_) => Shape {
                kind: ShapeKind::Contact(condition),
                width: 1,
                height: 1,
            },
            Condition::All(parts) => {
                let mut flat = Vec::with_capacity(parts.len());
                for part in parts.iter().map(Shape::of) {
                    match part.kind {
                        ShapeKind::Series(inner) => flat.extend(inner),
                        kind => flat.push(Shape { kind, ..part }),
                    }
                }
                Shape::series(flat)
            }
            // A wire next to other branches is all that counts.
            Condition::Any(_) if condition.is_always() => Shape::series(Vec::new()),
            Condition::Any(branches) => {
                let mut flat = Vec::with_capacity(branches.len());
                for branch in branches.iter().map(Shape::of) {
                    match branch.kind {
                        ShapeKind::Parallel(inner) => flat.extend(inner),
                        kind => flat.push(Shape { kind, ..branch }),
                    }
                }
                Shape::parallel(flat)
            }
        }
    }

    fn series(mut parts: Vec<Shape<'m>>) -> Shape<'m> {
        if parts.len() == 1 {
            return parts.remove(0);
        }
        let gaps = parts
            .windows(2)
            .filter(|pair| is_parallel(&pair[0]) && is_parallel(&pair[1]))
            .count();
        Shape {
            width: parts.iter().map(|part| part.width).sum::<usize>() + gaps,
            height: parts.iter().map(|part| part.height).max().unwrap_or(1),
            kind: ShapeKind::Series(parts),
        }
    }

    fn parallel(mut branches: Vec<Shape<'m>>) -> Shape<'m> {
        if branches.len() == 1 {
            return branches.remove(0);
        }
        Shape {
            width: branches.iter().map(|branch| branch.width).max().unwrap_or(0),
            height: branches.iter().map(|branch| branch.height).sum(),
            kind: ShapeKind::Parallel(branches),
        }
    }
}

fn is_parallel(shape: &Shape<'_>) -> bool {
    matches!(shape.kind, ShapeKind::Parallel(_))
}

fn ends_in_branches(shape: &Shape<'_>) -> bool {
    match &shape.kind {
        ShapeKind::Parallel(_) => true,
        ShapeKind::Series(parts) => parts.last().is_some_and(is_parallel),
        ShapeKind::Contact(_) => false,
    }
}

/// The cells so far. Rows are added as they are needed.
struct Sheet<'a> {
    rows: Vec<Row>,
    addresses: &'a Addresses,
}

impl Sheet<'_> {
    fn row(&mut self, row: usize) -> &mut Row {
        while self.rows.len() <= row {
            self.rows.push(Row::empty());
        }
        &mut self.rows[row]
    }

    fn body(&mut self, row: usize, column: usize, body: Body) -> Result<(), Undrawable> {
        let cell = self.row(row).cells.get_mut(column).ok_or(Undrawable::Wide)?;
        cell.body = body;
        Ok(())
    }

    fn wire(&mut self, row: usize, column: usize) -> Result<(), Undrawable> {
        self.body(row, column, Body::Wire)
    }

    /// Wire down along the left edges of a column, from one row to another. At the left rail there is no need.
    fn down(&mut self, from: usize, to: usize, column: usize) {
        if column == 0 {
            return;
        }
        for row in from..to {
            if let Some(cell) = self.row(row).cells.get_mut(column) {
                cell.down = true;
            }
        }
    }

    /// Wire from a column to the right edge, and what is there.
    fn output(&mut self, row: usize, from: usize, text: &str) -> Result<(), Undrawable> {
        for column in from..COLUMNS {
            self.wire(row, column)?;
        }
        self.row(row).output = Some(Text {
            text: text.to_owned(),
            place: LineColumn::START,
        });
        Ok(())
    }

    /// Draws a condition and the outputs after it; comes back how many rows that takes.
    fn outputs(
        &mut self,
        common: &Shape<'_>,
        outputs: &[Drawn<'_>],
        row: usize,
        column: usize,
    ) -> Result<usize, Undrawable> {
        let mut column = self.shape(common, row, column)?;
        // Outputs that follow each other and have the same condition share it.
        let same = |one: &Drawn<'_>, other: &Drawn<'_>| {
            !one.condition.is_always() && one.condition == other.condition
        };
        let groups: Vec<&[Drawn<'_>]> = outputs.chunk_by(same).collect();
        if groups.len() > 1 && ends_in_branches(common) {
            // One column brings the branches together, the next parts the outputs.
            self.wire(row, column)?;
            column += 1;
        }
        if outputs.len() > 1 && column >= COLUMNS {
            return Err(Undrawable::Wide);
        }
        let (mut at, mut last) = (row, row);
        for group in groups {
            last = at;
            let own = Shape::of(group[0].condition);
            at += match group {
                [single] => {
                    let end = self.shape(&own, at, column)?;
                    self.output(at, end, &single.output)?;
                    own.height
                }
                several => {
                    let bare: Vec<Drawn<'_>> = several.iter().map(Drawn::bare).collect();
                    self.outputs(&own, &bare, at, column)?
                }
            };
        }
        self.down(row, last, column);
        Ok((at - row).max(common.height))
    }

    /// Draws what a row and column begin with; its first row carries power on at the column that comes back.
    fn shape(&mut self, shape: &Shape<'_>, row: usize, column: usize) -> Result<usize, Undrawable> {
        match &shape.kind {
            ShapeKind::Contact(condition) => {
                let text = contact::write(condition, self.addresses)
                    .ok_or_else(|| Undrawable::Unsaid("a contact".to_owned()))?;
                let place = LineColumn::START;
                self.body(row, column, Body::Contact(Text { text, place }))?;
                Ok(column + 1)
            }
            ShapeKind::Series(parts) => {
                let mut at = column;
                for (number, part) in parts.iter().enumerate() {
                    if number > 0 && is_parallel(part) && is_parallel(&parts[number - 1]) {
                        self.wire(row, at)?;
                        at += 1;
                    }
                    at = self.shape(part, row, at)?;
                }
                Ok(at)
            }
            ShapeKind::Parallel(branches) => {
                let end = column + shape.width;
                // What the branches come together in is the left edge of a cell.
                if end >= COLUMNS {
                    return Err(Undrawable::Wide);
                }
                let mut at = row;
                let mut last = row;
                for branch in branches {
                    let after = self.shape(branch, at, column)?;
                    for wire in after..end {
                        self.wire(at, wire)?;
                    }
                    last = at;
                    at += branch.height;
                }
                self.down(row, last, column);
                self.down(row, last, end);
                Ok(end)
            }
        }
    }
}

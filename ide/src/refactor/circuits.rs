//! Networks as what is in series and in parallel, and back to a drawing.

use super::drawing::{Drawing, Item, ItemKind, Row, comments};
use super::parallel::Parallel;
use ladder_format::{Circuit, PieceKind};
use std::ops::Range;

/// A network from the left rail to its end, if all of it is in series and in parallel.
#[derive(Debug, Clone)]
pub(crate) struct Rung {
    /// What is in series, from left to right.
    pub(crate) parts: Vec<Circuit<Item>>,
    /// Whether it ends at the right rail.
    pub(crate) railed: bool,
    /// Its comments that are no piece of a wire: those on rungs.
    pub(crate) comments: Vec<String>,
    /// And the lines of comments between rungs.
    pub(crate) between: String,
}

impl Rung {
    pub(crate) fn read(drawing: &Drawing) -> Option<Rung> {
        let items = &drawing.rows[0].items;
        let start = drawing.drawn_start(0);
        if items.get(start)?.kind != ItemKind::LeftRail {
            return None;
        }
        let after = items[start + 1..].iter().take_while(|item| item.joined).count();
        let mut end = start + 1 + after;
        let railed = items[end - 1].kind == ItemKind::RightRail;
        end -= usize::from(railed);
        let mut blocks = 0;
        let parts = series(drawing, 0, start + 1..end, &mut blocks)?;
        let all = || drawing.rows.iter().flat_map(|row| &row.items);
        if all().any(|item| item.kind == ItemKind::Stub)
            || all().filter(|item| item.is_block()).count() != blocks
        {
            return None;
        }
        let mut loose = Vec::new();
        for row in &drawing.rows {
            for (index, item) in row.items.iter().enumerate() {
                if item.is_loose(row.items.get(index + 1)) {
                    loose.push(item.text.clone());
                }
            }
        }
        Some(Rung {
            parts,
            railed,
            comments: loose,
            between: drawing.rows.iter().map(|row| comments(&row.below)).collect(),
        })
    }

    /// The drawing of a network of these parts, with the comments of this one.
    pub(crate) fn draw(&self, like: &Drawing, parts: Vec<Circuit<Item>>) -> Drawing {
        let circuit = Circuit::Series(parts);
        let mut rows: Vec<Row> = Vec::new();
        for (number, rung) in circuit.rungs().into_iter().enumerate() {
            let mut items = Vec::new();
            if number == 0 {
                items.push(Item::left_rail());
            }
            items.extend(rung.into_iter().map(|piece| match piece.kind {
                PieceKind::Down => Item {
                    joined: piece.joined,
                    ..Item::down()
                },
                PieceKind::Up => Item::up(piece.joined),
                PieceKind::Element(item) => Item {
                    joined: true,
                    ..item.clone()
                },
            }));
            if number == 0 {
                items.extend(self.railed.then(Item::right_rail));
                let comments = self.comments.iter();
                items.extend(comments.map(|text| Item::new(ItemKind::Comment, text.as_str(), false)));
            }
            rows.push(Row {
                items,
                below: Vec::new(),
            });
        }
        let mut drawing = like.with_rows(rows);
        drawing.head.clone_from(&self.between);
        drawing
    }
}

fn series(
    drawing: &Drawing,
    row: usize,
    range: Range<usize>,
    blocks: &mut usize,
) -> Option<Vec<Circuit<Item>>> {
    let mut parts = Vec::new();
    let mut at = range.start;
    while at < range.end {
        let item = &drawing.rows[row].items[at];
        match item.kind {
            ItemKind::Block(_) | ItemKind::Comment => {
                *blocks += usize::from(item.is_block());
                parts.push(Circuit::Element(item.clone()));
                at += 1;
            }
            ItemKind::Down => {
                let found = Parallel::at(drawing, row, at).filter(|found| found.right < range.end)?;
                let upper = Circuit::Series(series(drawing, row, found.upper(), blocks)?);
                let mut branches = vec![upper];
                let lower = series(drawing, found.below, found.lower(), blocks)?;
                // Branches of a branch are branches of the whole.
                match <[_; 1]>::try_from(lower) {
                    Ok([Circuit::Parallel(more)]) => branches.extend(more),
                    Ok(one) => branches.push(Circuit::Series(one.into())),
                    Err(lower) => branches.push(Circuit::Series(lower)),
                }
                parts.push(Circuit::Parallel(branches));
                at = found.right + 1;
            }
            _ => return None,
        }
    }
    Some(parts)
}

/// Every item of a circuit.
pub(crate) fn items(circuit: &Circuit<Item>) -> Vec<&Item> {
    match circuit {
        Circuit::Element(item) => vec![item],
        Circuit::Series(parts) | Circuit::Parallel(parts) => parts.iter().flat_map(items).collect(),
    }
}

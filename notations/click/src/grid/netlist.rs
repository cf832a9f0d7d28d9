//! The wiring of a rung: what joins what, from cells.
//!
//! Nets meet at the edges between cells. Wire joins the two edges of its cell; wire that goes down joins the left edge
//! of its cell with that of the cell below. Every left edge of column A is the left rail. A contact lies between the two
//! edges of its cell, and power goes through it both ways.

use super::cell::{Body, COLUMNS, Row, Text};

/// The net of the left rail.
pub(super) const RAIL: usize = 0;

/// The wiring of a rung.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Netlist<'r> {
    /// In the order of reading: row by row, from left to right.
    pub(super) contacts: Vec<Wired<'r>>,
    pub(super) outputs: Vec<Fed<'r>>,
    /// How many nets there are.
    pub(super) nets: usize,
}

/// A contact and the nets at its left and right edge.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Wired<'r> {
    pub(super) contact: &'r Text,
    pub(super) left: usize,
    pub(super) right: usize,
}

/// What is in column AF, and the net that feeds it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Fed<'r> {
    pub(super) output: &'r Text,
    pub(super) net: usize,
}

/// The edges of cells, joined into nets.
struct Edges {
    parent: Vec<usize>,
}

impl Edges {
    fn of(rows: usize) -> Edges {
        let mut edges = Edges {
            parent: (0..rows * (COLUMNS + 1)).collect(),
        };
        for row in 1..rows {
            edges.join((0, 0), (row, 0));
        }
        edges
    }

    fn root(&mut self, (row, column): (usize, usize)) -> usize {
        let mut at = row * (COLUMNS + 1) + column;
        while self.parent[at] != at {
            self.parent[at] = self.parent[self.parent[at]];
            at = self.parent[at];
        }
        at
    }

    /// The smaller root stays, so that the rail has the first.
    fn join(&mut self, one: (usize, usize), other: (usize, usize)) {
        let (one, other) = (self.root(one), self.root(other));
        self.parent[one.max(other)] = one.min(other);
    }
}

impl<'r> Netlist<'r> {
    /// The wiring of a rung's rows.
    pub(super) fn of(rows: &'r [Row]) -> Netlist<'r> {
        let mut edges = Edges::of(rows.len());
        for (number, row) in rows.iter().enumerate() {
            for (column, cell) in row.cells.iter().enumerate() {
                if cell.body == Body::Wire {
                    edges.join((number, column), (number, column + 1));
                }
                if cell.down && number + 1 < rows.len() {
                    edges.join((number, column), (number + 1, column));
                }
            }
        }
        let mut numbers = vec![None; rows.len() * (COLUMNS + 1)];
        numbers[0] = Some(RAIL);
        let mut nets = 1;
        let mut net = |edge| {
            let root = edges.root(edge);
            *numbers[root].get_or_insert_with(|| {
                nets += 1;
                nets - 1
            })
        };
        let mut contacts = Vec::new();
        let mut outputs = Vec::new();
        for (number, row) in rows.iter().enumerate() {
            for (column, cell) in row.cells.iter().enumerate() {
                if let Body::Contact(contact) = &cell.body {
                    let (left, right) = (net((number, column)), net((number, column + 1)));
                    contacts.push(Wired { contact, left, right });
                }
            }
            if let Some(output) = &row.output {
                let net = net((number, COLUMNS));
                outputs.push(Fed { output, net });
            }
        }
        Netlist {
            contacts,
            outputs,
            nets,
        }
    }
}

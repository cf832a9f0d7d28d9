//! `--inputs`: what the world outside gives to the program, scan by scan.

use super::table::Table;
use crate::outcome::Failure;
use ladder_analysis::value::Value;
use ladder_simulator::{Point, Simulation, value_text};
use std::path::Path;

/// The assignments of a run. A cell of row k is one assignment before scan k, an empty cell none.
pub(crate) struct Inputs {
    table: Table,
    /// The tag of each column.
    points: Vec<Point>,
}

impl Inputs {
    /// No assignments.
    pub(crate) fn none() -> Inputs {
        Inputs {
            table: Table::default(),
            points: Vec::new(),
        }
    }

    /// Reads them from a file.
    ///
    /// # Errors
    /// The file cannot be read, a column names no tag that can be set, or a cell holds no value of its tag's type.
    pub(crate) fn read(file: &Path, simulation: &Simulation) -> Result<Inputs, Failure> {
        let table = Table::read(file)?;
        let points = table
            .names
            .iter()
            .enumerate()
            .map(|(column, name)| match simulation.resolve(name) {
                Ok(point) if point.read_only => {
                    Err(table.column_failure(column, "this tag can only be read"))
                }
                Ok(point) => Ok(point),
                Err(unknown) => Err(table.column_failure(column, &hint(name, unknown.to_string()))),
            })
            .collect::<Result<Vec<Point>, Failure>>()?;
        let inputs = Inputs { table, points };
        inputs.check()?;
        Ok(inputs)
    }

    /// Every cell is looked at before the run, so that no run ends in the middle over a slip of the finger.
    fn check(&self) -> Result<(), Failure> {
        for row in 0..self.table.rows.len() {
            for (column, (cell, point)) in self.table.cells(row).zip(&self.points).enumerate() {
                if !cell.is_empty()
                    && let Err(problem) = value_text::parse(cell, point.ty)
                {
                    return Err(self.table.cell_failure(row, column, &problem));
                }
            }
        }
        Ok(())
    }

    /// Goes on with another program. A column whose tag that does not have, or has as another type, gives nothing.
    #[cfg(feature = "screen")]
    pub(crate) fn rebind(&mut self, simulation: &Simulation) {
        for (point, name) in self.points.iter_mut().zip(&self.table.names) {
            if let Ok(found) = simulation.resolve(name)
                && found.ty == point.ty
            {
                *point = found;
            }
        }
    }

    /// Makes the assignments that stand before a scan.
    pub(crate) fn give(&self, scan: u64, simulation: &mut Simulation) {
        for (point, value) in self.before(scan) {
            // What could be refused was found when the file was read.
            let _ = simulation.set(point, value);
        }
    }

    /// The assignments that stand before a scan.
    pub(crate) fn before(&self, scan: u64) -> impl Iterator<Item = (&Point, Value)> {
        let row = usize::try_from(scan)
            .ok()
            .filter(|row| *row < self.table.rows.len());
        row.into_iter()
            .flat_map(|row| self.table.cells(row).zip(&self.points))
            .filter(|(cell, _)| !cell.is_empty())
            .filter_map(|(cell, point)| Some((point, value_text::parse(cell, point.ty).ok()?)))
    }
}

/// Spreadsheets of many countries put semicolons between the cells.
fn hint(name: &str, problem: String) -> String {
    if name.contains([';', '\t']) {
        return "columns are separated by commas".to_owned();
    }
    problem
}

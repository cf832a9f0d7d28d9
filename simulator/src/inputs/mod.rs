//! What the world outside gives to the program, scan by scan, as a table in CSV says it.

mod cells;
mod table;

use crate::session::Session;
use crate::simulation::Simulation;
use crate::tags::Point;
use crate::value_text;
use ladder_analysis::values::value::Value;
use std::fmt;
use table::Table;

pub use cells::{separator, table_cells, with_point};

/// Why a table of inputs cannot be used: its file, the row and the column, and what is wrong there.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct InputsError(String);

impl fmt::Display for InputsError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for InputsError {}

/// A cell that gives an input back to the plant that drives it.
const GIVEN_BACK: &str = "~";

/// The assignments of a run. A cell of row k is one assignment before scan k, an empty cell none.
#[derive(Debug, Default)]
pub struct Inputs {
    table: Table,
    /// The tag of each column.
    points: Vec<Point>,
}

impl Inputs {
    /// Reads them from the text of a file, which messages call `file`.
    ///
    /// # Errors
    /// It is not a table, a column names no tag that can be set, or a cell holds no value of its tag's type.
    pub fn parse(file: &str, text: &str, simulation: &Simulation) -> Result<Inputs, InputsError> {
        let table = Table::parse(file, text)?;
        let points = table
            .names
            .iter()
            .enumerate()
            .map(|(column, name)| match simulation.resolve(name) {
                Ok(point) if point.read_only => {
                    Err(table.column_failure(column, "this tag can only be read"))
                }
                Ok(point) => Ok(point),
                Err(unknown) => Err(table.column_failure(column, &unknown.to_string())),
            })
            .collect::<Result<Vec<Point>, InputsError>>()?;
        let inputs = Inputs { table, points };
        inputs.check(simulation)?;
        Ok(inputs)
    }

    /// Every cell is checked before the run, so that no run ends in the middle because of a typing error.
    fn check(&self, simulation: &Simulation) -> Result<(), InputsError> {
        for row in 0..self.table.rows.len() {
            for (column, (cell, point)) in self.table.cells(row).zip(&self.points).enumerate() {
                if cell == GIVEN_BACK && simulation.is_driven(point) {
                    continue;
                }
                if !cell.is_empty()
                    && let Err(problem) = self.value(cell, point)
                {
                    return Err(self.table.cell_failure(row, column, &problem));
                }
            }
        }
        Ok(())
    }

    /// Goes on with another program. A column whose tag that does not have, or has as another type, gives nothing.
    pub fn rebind(&mut self, simulation: &Simulation) {
        for (point, name) in self.points.iter_mut().zip(&self.table.names) {
            if let Ok(found) = simulation.resolve(name)
                && found.ty == point.ty
            {
                *point = found;
            }
        }
    }

    /// Makes the assignments that are before a scan.
    pub fn give(&self, scan: u64, simulation: &mut Simulation) {
        for (point, value) in self.before(scan) {
            match value {
                // What could be refused was found when the file was read.
                Some(value) => _ = simulation.set(point, value),
                None => simulation.unforce(point),
            }
        }
    }

    /// The same in a session, which keeps what is given.
    pub fn give_to_session(&self, scan: u64, session: &mut Session) {
        for (point, value) in self.before(scan) {
            match value {
                Some(value) => _ = session.set(point, value),
                None => session.unforce(point),
            }
        }
    }

    /// The tags that something is given to.
    pub fn points(&self) -> &[Point] {
        &self.points
    }

    /// The assignments that are before a scan; without a value the plant that drives the tag does so again.
    fn before(&self, scan: u64) -> impl Iterator<Item = (&Point, Option<Value>)> {
        let row = usize::try_from(scan)
            .ok()
            .filter(|row| *row < self.table.rows.len());
        row.into_iter()
            .flat_map(|row| self.table.cells(row).zip(&self.points))
            .filter(|(cell, _)| !cell.is_empty())
            .filter_map(|(cell, point)| match cell {
                GIVEN_BACK => Some((point, None)),
                cell => Some((point, Some(self.value(cell, point).ok()?))),
            })
    }

    fn value(&self, cell: &str, point: &Point) -> Result<Value, String> {
        value_text::parse(&with_point(cell, point.ty, self.table.separator), point.ty)
    }
}

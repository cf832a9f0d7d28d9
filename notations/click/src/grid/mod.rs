//! The grid of Click's ladders as comma-separated values: one file for each routine.
//!
//! ```text
//! marker,A,B,C,..,AE,AF
//! #,The motor runs.
//! R,X001,T,~X002,-,..,-,out(Y001)
//! ,Y001,,,,..,,
//! ```
//!
//! A row has a marker (`R` begins a rung, nothing goes on with it, `#` is a comment), the 31 condition cells A to AE, and
//! the output AF. `-` is wire, `T` wire that also goes down at the cell's left edge, `|` goes down only, `T:X002` is a
//! contact with wire that goes down at its left edge. Pins (`.reset()`) are on rows of their own, below their output.
//!
//! ```text
//! file --file--> rows of cells --netlist--> nets --reduce, paths--> circuits --rungs--> Program
//! Program --draw--> rows of cells --file--> file
//! ```

mod action;
mod addresses;
mod cell;
mod contact;
mod draw;
mod file;
mod formula;
mod netlist;
mod operand;
mod output;
mod paths;
mod read;
mod reduce;
mod rungs;
mod subcircuit;
mod token;
mod write;

use super::model::Operand;
use super::{nicknames, order, read_back};
use addresses::Addresses;
use ladder_analysis::Analysis;
use ladder_notation::{Notation, ReadError, Reading, Source, WriteError, Writing};

pub(super) use cell::COLUMNS;
pub(super) use rungs::CONTINUES;

/// A value as the grid writes it. None: an address has only a nickname.
pub(super) fn operand(operand: &Operand) -> Option<String> {
    operand::operand_text(operand, &Addresses::default())
}

/// See the module.
#[derive(Debug)]
pub struct ClickGrid;

impl Notation for ClickGrid {
    fn name(&self) -> &'static str {
        "click-csv"
    }

    fn title(&self) -> &'static str {
        "grid of a Click program"
    }

    fn extensions(&self) -> &'static [&'static str] {
        &["csv"]
    }

    fn recognises(&self, bytes: &[u8]) -> bool {
        file::is_grid(bytes)
    }

    fn has_companion(&self, program: &str, file: &str) -> bool {
        nicknames::is_file_of(program, file) || read::is_subroutine_of(program, file)
    }

    fn read(&self, source: &Source<'_>) -> Result<Reading, ReadError> {
        read::read(source)
    }

    fn write(&self, analysis: &Analysis) -> Result<Writing, WriteError> {
        let (program, mut report) = read_back::program(analysis)?;
        order::remarks(&program, order::Look::Before, &mut report);
        let (text, companions) = write::write(&program, &mut report);
        report.entries.sort_by_key(|entry| entry.place);
        Ok(Writing {
            bytes: text.into_bytes(),
            companions,
            report,
        })
    }
}

#[cfg(test)]
mod properties;
#[cfg(test)]
mod tests;

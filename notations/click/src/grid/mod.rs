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
mod drum;
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
use addresses::Addresses;

pub(super) use action::convert;
pub(super) use cell::COLUMNS;
pub(super) use file::is_grid;
pub(super) use read::{SUBROUTINES, is_subroutine_of, read};
pub(super) use rungs::CONTINUES;
pub(super) use write::write;

/// A value as the grid writes it. None: an address has only a nickname.
pub(super) fn operand(operand: &Operand) -> Option<String> {
    operand::operand_text(operand, &Addresses::default())
}

#[cfg(test)]
mod properties;
#[cfg(test)]
mod tests;

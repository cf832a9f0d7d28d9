//! Programs of AutomationDirect's Click controllers: a Python DSL (`.py`) and the grid of its ladders (`.csv`).
//!
//! ```text
//! Python --dsl--\                 /--sketch--> sketch of a ladder program, report
//!                >-- Program ----<---checks--> findings
//! CSV ----grid--/                 \--dsl, grid--> Python, CSV
//!                analysed program --read_back--> Program
//! ```
//!
//! Both notations say the same things of the same banks of memory, so they share the model, the rules and the way to
//! ladder text and back. A Python file is parsed and never run.

#![allow(
    clippy::trivially_copy_pass_by_ref,
    reason = "ranges are parts of instructions, which are matched by reference"
)]

mod act;
mod address;
mod bank;
mod calc;
mod checks;
mod conversion;
mod convert;
mod csv;
mod drum;
mod dsl;
mod formula;
mod grid;
mod model;
mod nicknames;
mod notations;
mod operand;
mod order;
mod python_name;
mod ranges;
mod read_back;
mod sketch;
mod tags;
mod uses;

pub use notations::{Click, ClickGrid};

#[cfg(test)]
mod generated;
#[cfg(test)]
mod tests;

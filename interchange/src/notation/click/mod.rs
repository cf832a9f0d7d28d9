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

mod address;
mod bank;
mod model;

//! The deterministic scan engine for ladder programs.
//!
//! ```text
//! Program --compile--> flat code + memory banks --machine--> one scan = one walk through the code
//!                                    \-- Simulation: inputs, forces, faults, power, restart --/
//! ```
//!
//! [`Simulation`] is what the command line, the language server and tests share: it takes a program of
//! `ladder-analysis`, runs scans on a clock of its own, and shows every tag and the power of every wire. A [`Session`]
//! is one that remembers: it steps back to earlier scans.
//!
//! - The same program, inputs and interval give the same values on every machine: time moves by the interval and
//!   never by the wall clock, and transcendental functions come from `libm`.
//! - A scan allocates nothing. All room is taken when the program is compiled.
//! - The power of every element is kept as it is computed: each power has a slot that is written once in a scan.
//! - Forces cost nothing while there are none: the scan is compiled twice, once with the looks at them.
//!
//! A new instruction is a row of the table in `ladder-instructions` and a line in `compile/mod.rs`, which does not
//! compile without it.

#![allow(dead_code, reason = "parts that further instructions take")]

mod code;
mod compile;
mod counters;
mod diagram;
mod fault;
mod fuse;
mod layout;
mod machine;
mod memory;
mod operation;
mod retain;
mod routine;
mod session;
mod simulation;
mod tags;
mod timers;
pub mod trace;
pub mod value_text;

pub use compile::CompileError;
pub use diagram::diagram;
pub use fault::Fault;
pub use session::{HistoryLimits, Session, Stop};
pub use simulation::{Options, Refused, Simulation, Status};
pub use tags::{Point, UnknownTag};

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
//! - Forces cost nothing while there are none: the scan is compiled twice, once with checks for them.
//! - Nor does looking into a scan. [`Simulation::step_block`] and [`Simulation::step_network`] run the
//!   plain code and halt in front of the next block or network, where tags and power can be seen; `scan()` runs fused
//!   code, in which such places are gone. Both leave the same state behind.
//! - [`Simulation::state`] is all that a scan can change, within one too; [`Simulation::restore`] goes on from it
//!   as if nothing had happened since.
//!
//! ```
//! # use ladder_simulator::{Options, Simulation, Stepped};
//! # let text = "+--[ ]( start )--( )( run )--+\n+--[ ]( run )--( )( lamp )--+\n";
//! # let analysis = ladder_analysis::analyze(&ladder_syntax::parse(text).into(), "motor.clad");
//! let mut simulation = Simulation::new(analysis.program().cloned().unwrap(), Options::default())?;
//! let before = simulation.state();
//! let mut blocks = Vec::new();
//! while let Stepped::At(block) = simulation.step_block() {
//!     blocks.push(&text[block.range]);
//! }
//! assert_eq!(blocks, ["[ ]( start )", "( )( run )", "[ ]( run )", "( )( lamp )"]);
//! assert_eq!(simulation.scans(), 1);
//! assert!(simulation.restore(&before));
//! assert_eq!(simulation.scans(), 0);
//! # Ok::<(), ladder_simulator::CompileError>(())
//! ```
//!
//! A new instruction is a row of the table in `ladder-instructions` and a line in `compile/instruction.rs`, which does not
//! compile without it.

mod carry;
pub mod chart;
#[allow(missing_docs, reason = "operands and members are described at what has them")]
mod code;
mod compile;
mod compile_error;
mod controller;
mod counters;
pub mod coverage;
mod diagram;
pub mod expression;
mod fault;
mod fuse;
mod groups;
mod inputs;
#[allow(missing_docs, reason = "operands and members are described at what has them")]
mod layout;
mod machine;
mod members;
#[allow(missing_docs, reason = "operands and members are described at what has them")]
mod memory;
pub mod online;
#[allow(missing_docs, reason = "operands and members are described at what has them")]
mod operation;
mod overlap;
#[allow(missing_docs, reason = "operands and members are described at what has them")]
mod places;
mod retain;
#[allow(missing_docs, reason = "operands and members are described at what has them")]
mod routine;
pub mod scenario;
mod session;
mod simulation;
mod system;
mod tags;
mod timers;
pub mod trace;
mod tree;
mod uses;
pub mod value_text;
mod work;

/// The compiled form of a program, for those who translate it further: flat code over banks of bits, words and texts, so
/// that each instruction has one meaning wherever it runs.
pub mod compiled {
    pub use crate::carry::counterparts;
    pub use crate::code::{
        ArrayPlace, BlockPlace, Code, Instr, NOTHING_SAVED, NetworkPlace, Tracked, UnreadPlace,
    };
    pub use crate::compile::{CHANNELS, Compiled, Ports, compile};
    pub use crate::layout::{Borrowed, Home, counter, state_size, timer};
    pub use crate::memory::{Bit, Memory, Text, TextSlot, Word};
    pub use crate::operation::{
        Conversion, IntegerOp, RealFunction, RealOp, Test, Width, converted, real_function_of, real_of,
    };
    pub use crate::places::Cell;
    pub use crate::retain::Retained;
    pub use crate::routine::{Routine, TYPES, type_of};
    pub use crate::tags::PointSlot;
    pub use crate::work::CALL_DEPTH;

    /// How instructions and routines use the cells of memory.
    pub mod uses {
        pub use crate::uses::{Access, Cell};
    }
}

pub use carry::{Changeover, Lost};
pub use compile_error::CompileError;
pub use diagram::{diagram, diagram_of};
pub use fault::Fault;
pub use groups::{Entry, Group};
pub use inputs::{Inputs, InputsError, separator, table_cells, with_point};
pub use members::members_of;
pub use retain::Kept;
pub use session::{
    Breakpoint, Cause, HistoryLimits, Hit, Judged, Judgement, Moment, Reason, Session, Since, StepBy, Stop,
    Why, Wording, Write,
};
pub use simulation::{
    Activation, Instance, Options, Routine, Simulation, State, Status, Stepped, ValueRefused, real_time,
};
pub use tags::{Point, UnknownTag};

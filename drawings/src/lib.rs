//! Ladder diagrams as people draw them with characters, in forums, mails and manuals: read as sketches, which the writer of
//! `ladder-format` draws.
//!
//! ```text
//!   start      stop              run
//! |--| |---+----|/|--------------( )--|
//! |  run   |                          |
//! |--| |---+                          |
//! ```
//!
//! ```text
//! text --drawing--> parts: runs of lines without a blank one
//!      --sheet----> columns
//!      --frame----> boxes of blocks
//!      --sides----> the values next to boxes
//!      --symbol---> contacts and coils; --element, block--> blocks of ladder text, named by --label
//!      --wires----> what is joined, from left to right and from line to line
//!      --network--> rungs with connectors
//! ```
//!
//! ```text
//! XIC(start)XIO(stop)OTE(run); --neutral--> its parts --rung_text--> a network
//! XIC start TON delay T#5s OTE run --neutral--> its parts --entry--> a network
//! ```
//!
//! Nothing is guessed: an element that cannot be read is a comment in its place, a network whose wires cannot be followed stays as comments,
//! and [`Read::problems`] says where and why.
#![forbid(unsafe_code)]

mod block;
mod drawing;
mod element;
mod entry;
mod frame;
mod label;
mod marks;
mod network;
pub mod neutral;
mod operand;
mod part;
mod rung_text;
mod sheet;
mod sides;
mod symbol;
mod text;
mod wires;

pub use drawing::{Look, Problem, Read, Shown, look, read};
pub use entry::read_entry;
pub use rung_text::{RungText, may_be_rung_text, read_rung_text};

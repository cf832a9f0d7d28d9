//! The trace of chosen tags while a program runs, and the numbers from which clients draw it.
//!
//! ```text
//! Session --after each scan--> Recorder: a Track for each tag --Window--> columns, ticks, readings
//! ```
//!
//! Scans are counted as a state counts them: what is at scan 5 is what tags held when five scans were done, and its
//! time is five intervals. A column of a drawing is one or more scans; columns begin at whole multiples of their
//! length, so that a picture that moves does not flicker, and only those that are new have to be asked for.

mod columns;
mod recorder;
pub(crate) mod scale;
#[cfg(test)]
mod tests;
mod text;
pub(crate) mod time_axis;
mod track;

pub use columns::{Column, Level, Mark, Window};
pub use recorder::Recorder;
pub use text::{difference, duration, reading};
pub(crate) use time_axis::ticks as time_ticks;
pub use track::{Kind, Track};

/// A tick of an axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Tick {
    /// Where it is: nanoseconds on a time axis, on others a value.
    pub at: f64,
    /// What it says.
    pub text: String,
}

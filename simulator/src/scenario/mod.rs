//! Scenarios: timing diagrams in text that say what goes into a program and what must come out (LANGUAGE §9).
//!
//! ```text
//! text --parse--> Suite: what the lines say --bind--> Cases: tags and values --run--> Ran --draw--> what differs
//!                   \------ mistakes, each with its place ------/
//! ```
//!
//! [`parse()`] needs no program and never fails: what it cannot read is a [`Mistake`], and it goes on in the next
//! line. [`bind()`] asks a compiled program for the tags and reads the values in their types. [`run()`] plays one
//! case from a cold start, and [`draw()`] shows the rows that came out differently. [`layout()`] puts a file's columns
//! straight.

mod bind;
mod draw;
mod layout;
mod parse;
mod play;
mod played;
mod record;
mod run;
#[cfg(test)]
mod tests;
mod tolerance;
mod words;

pub use bind::{Case, bind};
pub use draw::{Line, LineKind, draw, sentence};
use ladder_syntax::TextRange;
pub use layout::layout;
pub use parse::{Cell, Direction, HEADINGS, Row, Scenario, Suite, parse};
pub use play::Unmet;
pub use record::{Recorded, record, recorded_file};
pub use run::{Difference, Ran, run};
pub use tolerance::Tolerance;
pub use words::{Line as TextLine, Word};

/// A mistake in a scenario file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Mistake {
    /// Where, in bytes.
    pub range: TextRange,
    /// What is wrong.
    pub message: String,
    /// What to do, where the message does not say it.
    pub help: Option<String>,
}

impl Mistake {
    fn new(range: TextRange, message: impl Into<String>, help: impl Into<String>) -> Mistake {
        Mistake {
            range,
            message: message.into(),
            help: Some(help.into()),
        }
    }
}

//! Scenarios: timing diagrams in text that say what goes into a program and what must come out (LANGUAGE §9).
//!
//! ```text
//! text --parse--> Suite: what the lines say --bind--> Cases: tags and values --run--> Ran --draw--> what differs
//!                   \------ errors, each with its place ------/
//! ```
//!
//! [`parse()`] needs no program and never fails: what it cannot read is a [`ScenarioError`], and it goes on in the next
//! line. [`bind()`] asks a compiled program for the tags and reads the values in their types. [`run()`] plays one
//! case from a cold start, watched by the monitors of the file's properties ([`bind_properties()`]), and [`draw()`] shows the
//! rows that came out differently and the properties that were violated. [`layout()`] puts a file's columns
//! straight.

mod bind;
mod draw;
mod error;
mod generated;
mod layout;
mod monitor;
mod parse;
mod plants;
mod play;
mod played;
mod property;
#[cfg(test)]
mod property_tests;
mod record;
mod run;
mod run_text;
mod steps;
mod suite;
#[cfg(test)]
mod tests;
mod tolerance;
mod watch;
mod words;

pub use bind::{Case, bind};
pub use draw::{Line, LineKind, draw, outside_sentence, sentence, violated_in_scan, violation_sentence};
pub use error::ScenarioError;
pub use generated::{Columns, Given, scenario_of_inputs};
pub use layout::layout;
pub use monitor::{Memory, Monitor, Watched, bind_properties};
pub use parse::{HEADINGS, TIME, parse};
pub use plants::{head, plant_error};
pub use play::Unmet;
pub use property::{FORMS, Form, PROPERTY, Property, Span, Written};
pub use record::{Recordable, Recorded, Wanted, passes, program_line, record, recordable, recorded_file};
pub use run::{Difference, Ran, run, run_within};
pub use run_text::{RunCell, RunRow, run_text};
pub use suite::{
    Cell, ConnectLine, Direction, PLANT, PlantLine, Row, Scenario, Suite, TimeRow, connected, plant_named,
};
pub use tolerance::Tolerance;
pub use watch::{Outside, Violation};
pub use words::{Line as TextLine, Word};

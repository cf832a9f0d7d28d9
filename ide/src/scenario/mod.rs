//! Files of scenarios in an editor: one file for each feature.
//!
//! A scenario file names the tags of a program. Whoever asks gives both: the [`Scenarios`] of a text, and the context of
//! the program that they are about, if it was found. The reader is the one that runs them.

mod completion;
mod edits;
mod hover;
mod navigate;
mod outline;
mod place;
mod row;

pub use completion::completions as scenario_completions;
pub use edits::{TRIGGERS as SCENARIO_TRIGGERS, layout as scenario_layout, on_type as scenario_on_type};
pub use hover::hover as scenario_hover;
pub use navigate::{
    definition as scenario_definition, highlights as scenario_highlights,
    prepare_rename as prepare_scenario_rename, references as scenario_references,
    rename as rename_in_scenario,
};
pub use outline::{ScenarioPart, outline as scenario_outline};
pub(crate) use row::{name_in, places};

use ladder_analysis::context::Context;
use ladder_simulator::scenario::{Suite, parse};

/// A scenario file as features read it.
#[derive(Debug)]
pub struct Scenarios<'t> {
    text: &'t str,
    suite: Suite,
    program: Option<&'t Context>,
}

impl<'t> Scenarios<'t> {
    /// Reads a text. `program` is the one that it names.
    pub fn read(text: &'t str, program: Option<&'t Context>) -> Scenarios<'t> {
        Scenarios {
            text,
            suite: parse(text),
            program,
        }
    }
}

#[cfg(test)]
mod tests;

//! Files of scenarios in an editor: one file for each feature.
//!
//! A scenario file names the tags of a program, and those of the files that it uses with the file's name before them. Whoever
//! asks gives all of that: what was read from a text, once for each request, and the program that it is about with the files
//! beside it, if it was found. The reader is the one that runs the scenarios.

mod completion;
mod edits;
mod hover;
mod named_by_rows;
mod navigate;
mod outline;
mod place;
mod row;
mod used;

pub use completion::completions as scenario_completions;
pub use edits::{layout as scenario_layout, on_type as scenario_on_type};
pub use hover::hover as scenario_hover;
pub use navigate::{
    definition as scenario_definition, highlights as scenario_highlights,
    prepare_rename as prepare_scenario_rename, references as scenario_references,
    rename as rename_in_scenario,
};
pub use outline::{ScenarioPart, outline as scenario_outline};
pub(crate) use row::{name_in, places};

use crate::neighbour::Workspace;
use ladder_analysis::context::Context;
use ladder_simulator::scenario::Suite;

/// A scenario file as features read it.
#[derive(Clone, Copy)]
pub struct Scenarios<'t> {
    /// What it says.
    pub text: &'t str,
    /// What was read from that.
    pub suite: &'t Suite,
    /// The program that it names, if that was found.
    pub program: Option<&'t Context>,
    /// The files beside the program.
    pub workspace: &'t dyn Workspace,
}

#[cfg(test)]
mod tests;

//! Files of scenarios in an editor: one file for each feature.
//!
//! A scenario file names the tags of a program, and those of the files that it uses with the file's name before them. The
//! caller passes all of that: what was read from a text, once for each request, and the program that it is about with the files
//! next to it, if it was found. The reader is the one that runs the scenarios.

mod completion;
pub(crate) mod connected;
mod connection_completion;
pub(crate) mod edits;
mod file;
mod forms;
mod hover;
mod members;
mod named_by_rows;
mod naming;
pub(crate) mod navigate;
mod outline;
mod place;
mod property_completion;
pub(crate) mod row;
mod scene;
mod used;

pub use completion::completions as scenario_completions;
pub use edits::{layout as scenario_layout, on_type as scenario_on_type};
pub use file::Scenarios;
pub use hover::hover as scenario_hover;
pub use navigate::{definition as scenario_definition, highlights as scenario_highlights};
pub use outline::{ScenarioPart, outline as scenario_outline};
pub use scene::{SceneAttribute, scene_completions, scene_hover};

#[cfg(test)]
mod tests;

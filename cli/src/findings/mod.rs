//! What is wrong in a program, as people and as machines read it.

pub(crate) mod concise;
pub(crate) mod full;
pub(crate) mod github;
pub(crate) mod json;
mod place;
mod problem;
pub(crate) mod sarif;
mod scenario_error;
mod source;
mod workspaces;

pub(crate) use problem::{FileRange, Problem, annotation};
#[cfg(feature = "run")]
pub(crate) use scenario_error::settings_source;
pub(crate) use source::{FOREIGN, NotRead, Source, is_settings, with_line_feeds};
pub(crate) use workspaces::Workspaces;

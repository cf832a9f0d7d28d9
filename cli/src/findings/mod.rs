//! What is wrong in a program, as people and as machines read it.

pub(crate) mod concise;
pub(crate) mod full;
pub(crate) mod github;
pub(crate) mod json;
mod place;
pub(crate) mod sarif;
mod source;
mod workspaces;

pub(crate) use source::Source;
pub(crate) use workspaces::Workspaces;

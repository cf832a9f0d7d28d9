//! What is wrong in a program, as people and as machines read it.

pub(crate) mod full;
pub(crate) mod json;
mod source;

pub(crate) use source::Source;

//! The Python DSL: `def main():` with a rung under each `if`. Python is parsed by ruff's parser and never run.

mod act;
mod arguments;
mod comments;
mod condition;
mod depth;
mod drum;
mod problems;
mod program;
mod recognise;
pub(super) mod spell;
mod write;

#[cfg(test)]
pub(super) use program::read;
pub(super) use program::{read_with, single_action};
pub(super) use recognise::recognises;
pub(super) use write::write;

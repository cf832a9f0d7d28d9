//! What the table of instructions holds.

mod documentation;
mod lookup;
mod rows;
mod signatures;

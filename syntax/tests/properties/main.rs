//! What holds for every text.

mod arbitrary;
mod conflicts;
mod edits;
mod invariants;
mod linear;
mod locality;
mod mutated;
mod plain;
mod programs;

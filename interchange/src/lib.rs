//! Ladder programs in the notations of other systems.

pub mod notation;

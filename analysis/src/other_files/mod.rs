//! What files show to each other.

pub mod exports;
pub mod others;
pub(crate) mod outward;
mod part_uses;
mod type_values;

//! What files show to each other, and programs of several files.

pub(crate) mod exporting;
pub mod exports;
pub mod import;
pub mod link;
pub mod others;
pub(crate) mod outward;
mod outward_uses;
mod part_uses;
pub(crate) mod targets;
mod type_values;

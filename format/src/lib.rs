//! The canonical layout of ladder text.

mod edit;

pub use edit::{Edit, apply};

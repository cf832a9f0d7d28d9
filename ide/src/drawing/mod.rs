//! A network as a person changes it: as rows of things, and where it is in series and in parallel as a term.
//!
//! ```text
//! text --reading--> Drawing: what is on each row, and what wire joins
//!                   --gap--> the places where something can be put in
//!                   --term--> Rung: what is in series and in parallel
//! insert, beside, remove, carry, ends: the term with a change, drawn again by `format::Circuit`;
//!                                      where a network is no term, its rows with the change
//! ```

pub(crate) mod beside;
pub(crate) mod carry;
pub(crate) mod ends;
pub(crate) mod gap;
pub(crate) mod insert;
pub(crate) mod item;
pub(crate) mod merge;
pub(crate) mod parallel;
pub(crate) mod passing;
mod reading;
pub(crate) mod region;
pub(crate) mod remove;
pub(crate) mod rows;
pub(crate) mod selection;
pub(crate) mod term;

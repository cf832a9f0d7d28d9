//! The power of a network as a function of what its contacts and comparisons read.
//!
//! ```text
//! steps, blocks --variables--> which variable each condition asks about, and for which of its values it conducts
//!               --space------> all combinations of values, numbered
//!               --power------> for each step the set of combinations in which it has power
//! ```
//!
//! For people there is the [`formula`] of a network, as they would write it.
//!
//! All of it is exact: a table holds the answer for every combination, so rules decide and do not guess. A
//! network with more combinations than [`space::MOST_POINTS`] is not checked. What cannot be known (an edge, a
//! timer's output, a value that another block has written) is a variable of its own.

mod comparison;
pub(crate) mod formula;
pub(crate) mod gate;
pub(crate) mod power;
pub(crate) mod space;
mod value_space;
mod variables;
pub(crate) mod written;

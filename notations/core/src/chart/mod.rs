//! Sequential function charts (SFC) of IEC 61131-3, for every notation that has them, as networks.
//!
//! ```text
//! foreign file --its reader--> Chart: steps, transitions, actions --lower--> networks, tags
//! ```
//!
//! A step is a BOOL. What a scan does, in this order, is what the C of matiec does, which the generators of Beremiz and OpenPLC hand
//! their charts to: what steps were and how long they are active; the conditions of the transitions from active steps; steps that
//! are left, then steps that are reached; the actions of the steps in their order; what is stored; the bodies of the actions.

mod actions;
mod lower;
mod mentions;
mod model;
mod networks;
mod transitions;
mod whole_seconds;

pub use lower::{Clock, Lowered, lower};
pub use model::{Act, Action, Association, Chart, Condition, Qualifier, Step, Transition};
